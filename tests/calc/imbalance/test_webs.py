"""The crank of the R753IE4 on the balancing machine (Finotti 2013, 2.6), and cranks of other throws."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from calc.design.toml_file import design, read
from calc.imbalance.inputs import CrankBody, ImbalanceInputs, Unbalance
from calc.imbalance.solve import solve
from calc.sheet.quantity import published
from tests.calc.imbalance.engines import solved

GAMMA = design(read(Path(__file__).parents[3] / "designs" / "r753ie4_gamma.toml"))


def webs(**changes):
    return solved(replace(GAMMA.imbalance, **changes))[2].webs


def test_the_bare_crank():
    """S (0.337, −0.717) kg·mm; C (−44.13, 4430.98) kg·mm², z towards the flywheel; 328.5 N·m at 2600 rpm."""
    bare = webs().crank["bare"]
    assert (bare.unbalance_up * 1e3, bare.unbalance_side * 1e3) == pytest.approx((0.337, -0.717), abs=5e-4)
    assert (bare.product_up * 1e6, bare.product_side * 1e6) == pytest.approx((-44.13, 4430.98), abs=5e-3)
    assert bare.couple == pytest.approx(328.5, abs=0.05)


def test_the_crank_with_the_bobs_as_stated():
    """427.4 g on every pin: S (0.337, −0.6617), C (−54.659, 0.719); 0.096 N·m on the machine, 4.05 at rated speed."""
    stated = webs().crank["stated"]
    assert (stated.unbalance_up * 1e3, stated.unbalance_side * 1e3) == pytest.approx((0.337, -0.6617), abs=5e-4)
    assert (stated.product_up * 1e6, stated.product_side * 1e6) == pytest.approx((-54.659, 0.719), abs=5e-4)
    assert stated.couple_on_machine == pytest.approx(0.096, abs=5e-4)
    assert stated.couple == pytest.approx(4.05, abs=5e-3)


def test_equal_bobs_of_427_grams():
    found = webs()
    assert [bob.number * 1e3 for bob in found.bob_mass.values()] == pytest.approx([427.469] * 3, abs=5e-4)
    assert found.crank["balanced"].product_side == 0
    assert [(p.id, p.label, p.symbol) for p in published(found, "") if p.id.startswith(".bob_mass")] == [
        (f".bob_mass.{j}", f"Bob mass on pin {j}", f"m_{j}") for j in (1, 2, 3)
    ]


def test_bobs_per_pin_take_the_whole_couple_and_keep_the_middle_one():
    found = webs(bob_mode="per_pin")
    assert found.bob_mass["2"].number == pytest.approx(webs().bob_mass["2"].number)
    assert found.crank["balanced"].couple < 1e-9
    assert found.bob_mass["1"].number > found.bob_mass["3"].number


def test_least_squares_are_least():
    """No change of a bob lowers S² + C²/a²."""
    found = webs(bob_mode="least_squares")
    a = 0.112

    def badness(state):
        return state.unbalance_up**2 + state.unbalance_side**2 + (state.product_up**2 + state.product_side**2) / a**2

    best = badness(found.crank["balanced"])
    assert best <= min(badness(webs(bob_mode=mode).crank["balanced"]) for mode in ("equal", "per_pin"))
    bobs = [bob.number for bob in found.bob_mass.values()]
    bodies = GAMMA.imbalance.crank_bodies
    pins = [next(b for b in bodies if b.pin == j) for j in (1, 2, 3)]
    for j in range(3):
        for change in (-1e-4, 1e-4):
            tried = [bob + change * (k == j) for k, bob in enumerate(bobs)]
            S = sum(b.mass * complex(b.x, b.y) for b in bodies) + sum(
                m * complex(b.x, b.y) for m, b in zip(tried, pins)
            )
            C = sum(b.mass * complex(b.x, b.y) * b.z for b in bodies) + sum(
                m * complex(b.x, b.y) * b.z for m, b in zip(tried, pins)
            )
            assert abs(S) ** 2 + abs(C) ** 2 / a**2 > best


def test_the_table_of_the_cranks_shows_what_they_are():
    """Beside each other the bare crank, the stated one and that of every mode: masses of the bobs, S, C, and C·ω² at
    rated speed."""
    inputs, e, found = solved(GAMMA.imbalance)
    table = next(t for t in solve(GAMMA.imbalance, inputs, e).tables if t.id == "bobs")
    rows = {str(row[0]): row[1:] for row in table.rows}
    assert list(rows) == ["bare", "as stated", "equal (chosen)", "per pin", "least squares"]
    stated = GAMMA.imbalance.bob_mass * 1e3
    assert [rows[name][:3] for name in ("bare", "as stated")] == [(None,) * 3, pytest.approx((stated,) * 3)]
    assert rows["equal (chosen)"][:3] == pytest.approx([bob.number * 1e3 for bob in found.webs.bob_mass.values()])
    for name, state in zip(rows, (found.webs.crank[key] for key in ("bare", "stated", "balanced"))):
        shown = (
            state.unbalance_up * 1e3,
            state.unbalance_side * 1e3,
            state.product_up * 1e6,
            state.product_side * 1e6,
            state.couple,
        )
        assert rows[name][3:] == pytest.approx(shown, abs=1e-9), name


def test_what_pulley_and_flywheel_must_supply():
    """(1503.3 − 427.4) g on every pin: 827.8 N·m at 2600 rpm."""
    found = webs()
    assert found.equivalent_mass * 1e3 == pytest.approx(1503.325, abs=5e-4)
    assert found.missing_forward_couple == pytest.approx(827.8, abs=0.05)
    assert found.missing_forward_force == pytest.approx(0, abs=1e-9)


def test_given_unbalances_supply_it():
    """A pulley and a flywheel of opposite unbalance, in the direction that is asked for, leave nothing."""
    wanted = webs()
    U, arm = wanted.missing_forward_couple / solved()[1].angular_speed ** 2 / 0.5, 0.25
    given = (
        Unbalance(name="pulley", unbalance=U, angle=wanted.missing_forward_couple_phase + math.pi, z=-arm),
        Unbalance(name="flywheel", unbalance=U, angle=wanted.missing_forward_couple_phase, z=arm),
    )
    found = webs(unbalances=given)
    assert found.unbalances_couple == pytest.approx(wanted.missing_forward_couple)
    assert found.unbalances_force == pytest.approx(0, abs=1e-9)
    assert found.unbalances_couple_left == pytest.approx(0, abs=1e-9)
    assert (
        solved(replace(GAMMA.imbalance, unbalances=given))[2].orders["order_1"].vectors
        == solved()[2].orders["order_1"].vectors
    )


def planar(cylinders=4):
    """A flat four of pins and webs whose webs balance bobs of 0.4 kg."""
    side = (1, -1, -1, 1)
    z = [0.1 * (k - 1.5) for k in range(4)]
    pins = [CrankBody(name=f"pin-{k + 1}", mass=0.5, x=0.05 * side[k], y=0.0, z=z[k], pin=k + 1) for k in range(4)]
    webs_ = [CrankBody(name=f"web-{k + 1}", mass=0.9, x=-0.05 * side[k], y=0.0, z=z[k]) for k in range(4)]
    return (*pins, *webs_)


def test_a_planar_crank_is_balanced_by_least_squares():
    """Equal bobs have no couple across the throw: said, and solved all the same."""
    inputs, e, _ = solved(cylinders=4, firing_order=(1, 3, 4, 2))
    outcome = solve(ImbalanceInputs(crank_bodies=planar()), inputs, e)
    state = outcome.result.webs.crank["balanced"]
    assert abs(state.unbalance) < 1e-12 and state.couple < 1e-6
    assert any("least squares" in note for note in outcome.notes)


@pytest.mark.parametrize(
    "changes, key",
    [
        (dict(crank_bodies=(CrankBody(name="web", mass=1.0, x=0.0, y=0.0, z=0.0),)), "crank_bodies"),
        (dict(crank_bodies=(CrankBody(name="pin", mass=1.0, x=0.0, y=0.0, z=0.0, pin=2),)), "crank_bodies"),
        (dict(counterweight_span=0.3), "counterweight_radius_mm"),
        (dict(counterweight_radius=0.3), "counterweight_span_mm"),
    ],
)
def test_what_makes_no_sense_is_named(changes, key):
    assert key in [k for k, _ in ImbalanceInputs(**changes).problems()]


def test_the_bodies_of_many_speeds_at_once():
    _inputs, _e, _ = solved()
    speeds = np.array([10.0, 20.0, 40.0])
    many = solved(GAMMA.imbalance, rated_speed=speeds)[2].webs
    assert many.crank["bare"].couple == pytest.approx(webs().crank["bare"].couple * (speeds * 60 / 2600) ** 2)
    assert many.missing_forward_couple.shape == (3,)


def test_a_bob_stands_on_a_pin_and_not_on_a_rod():
    """V6 90° on three pins, half on the crank, bobs of 0.4 kg: (2·M_eq − m_b)·r·a·√3·ω² is missing."""
    given = ImbalanceInputs(bob_mass=0.4)
    inputs, e, found = solved(
        given,
        layout="vee",
        cylinders=6,
        bank_angle=math.pi / 2,
        firing_order=None,
        bank_of_cylinder=(0, 1) * 3,
        crank_angles=tuple(map(math.radians, (0, 0, 240, 240, 120, 120))),
    )
    M_eq = e.rotating_mass + 0.5 * e.reciprocating_mass
    expected = (2 * M_eq - 0.4) * inputs.crank_radius * 0.112 * math.sqrt(3) * e.angular_speed**2
    assert found.webs.missing_forward_couple == pytest.approx(expected)


def test_pins_that_do_not_stand_where_the_throws_do_are_named():
    mirrored = tuple(replace(body, y=-body.y) for body in GAMMA.imbalance.crank_bodies)
    inputs, e, _ = solved()
    verdicts = {}
    for name, bodies in (("right", GAMMA.imbalance.crank_bodies), ("mirrored", mirrored)):
        outcome = solve(replace(GAMMA.imbalance, crank_bodies=bodies), inputs, e)
        verdicts[name] = {c.id: c.verdict for c in outcome.checks}["imbalance.crank.throws"]
    assert verdicts == {"right": "pass", "mirrored": "warn"}


def test_a_crank_that_its_bobs_leave_out_of_balance_is_named():
    heavier = (*GAMMA.imbalance.crank_bodies, CrankBody(name="lump", mass=0.5, x=0.05, y=0.0, z=0.0))
    inputs, e, _ = solved()
    outcome = solve(replace(GAMMA.imbalance, crank_bodies=heavier), inputs, e)
    assert {c.id: c.verdict for c in outcome.checks}["imbalance.crank.force"] == "warn"


def test_what_the_balance_quality_permits_the_crank():
    """ISO 21940-11: G·m/ω of the bodies and their bobs; judged where the webs to drill, which take all of it, are not
    found."""
    inputs, e, _ = solved()
    mass = sum(body.mass for body in GAMMA.imbalance.crank_bodies) + 3 * GAMMA.imbalance.bob_mass
    for grade, drill, verdict in (("G16", None, "pass"), ("G6.3", None, "note"), ("G6.3", 0.065, None)):
        outcome = solve(replace(GAMMA.imbalance, crank_balance_grade=grade, drill_radius=drill), inputs, e)
        assert outcome.solution.webs.permitted_unbalance == pytest.approx(
            float(grade[1:]) * 1e-3 * mass / e.angular_speed
        )
        assert {c.id: c.verdict for c in outcome.checks}.get("imbalance.crank.residual") == verdict


def drilled(found, bodies, radius):
    """The bodies with what is drilled out of them, as bodies of negative mass."""
    at = {body.name: body.z for body in bodies}
    return tuple(
        CrankBody(
            name=f"{name}-hole",
            mass=-web.mass,
            x=radius * math.cos(web.angle),
            y=radius * math.sin(web.angle),
            z=at[name],
        )
        for name, web in found.items()
    )


@pytest.mark.parametrize("bob", [0.4274, None])
def test_drilled_webs_leave_the_crank_balanced_on_its_bobs(bob):
    """Finotti 2013, 2.6: which webs, and how many grams; here the residue of the source's crank, 0.74 kg·mm, at a
    radius of 65 mm."""
    given = replace(GAMMA.imbalance, drill_radius=0.065, bob_mass=bob)
    found = solved(given)[2].webs
    bobs = [bob] * 3 if bob else [stated.number for stated in found.bob_mass.values()]
    pins = {body.pin: body for body in given.crank_bodies if body.pin}
    hung = tuple(replace(pins[k + 1], name=f"bob-{k}", mass=m, pin=None) for k, m in enumerate(bobs))
    state = solved(
        replace(
            given,
            crank_bodies=(*given.crank_bodies, *hung, *drilled(found.drill, given.crank_bodies, 0.065)),
            bob_mass=None,
        )
    )[2].webs.crank["bare"]
    assert state.force < 1e-6 and state.couple < 1e-6
    assert found.drilled_mass == pytest.approx(sum(web.mass for web in found.drill.values()))
    assert found.drilled_mass > 0.7 * found.crank["stated" if bob else "balanced"].unbalance / 0.065
    for name, web in found.drill.items():  # away from the pin
        body = next(b for b in given.crank_bodies if b.name == name)
        pin = min(pins.values(), key=lambda one: abs(one.z - body.z))
        assert math.cos(web.angle - math.atan2(pin.y, pin.x)) < -math.cos(math.radians(75.01))


def test_what_drilling_can_not_take_is_said():
    """One web can not take a couple, wherever it is drilled."""
    inputs, e, _ = solved()
    light = tuple(body for body in GAMMA.imbalance.crank_bodies if body.pin or body.name == "web-1")
    outcome = solve(replace(GAMMA.imbalance, crank_bodies=light, bob_mass=None, drill_radius=0.065), inputs, e)
    assert outcome.solution.webs.drilled_mass is None
    assert any("Which webs to drill is not found" in note for note in outcome.notes)
