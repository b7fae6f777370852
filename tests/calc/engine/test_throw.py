"""The crank throw beside statics: equilibrium, work, a case by hand, and the notch factors beside another source's
fit."""

import itertools
import math
from dataclasses import replace

import numpy as np
import pytest

from calc.engine import throw, torque
from calc.engine import throw_strength as t
from calc.engine.gas import GasInputs, PressurePoint
from calc.engine.inputs import ThrowInputs
from calc.engine.torque import prepare
from calc.library import fatigue
from calc.library.catalogue import materials
from calc.sheet.quantity import published
from calc.sheet.value import leaves, link_of, trace
from tests.calc.engine.test_gas import DIESEL
from tests.calc.engine.test_torque import V6, engine_of, single

SIZES = dict(
    pin_diameter=0.055,
    pin_length=0.032,
    journal_diameter=0.062,
    journal_length=0.030,
    web_thickness=0.024,
    fillet_radius=0.003,
    material="42CrMo4",
)
GAS = GasInputs(**DIESEL)


def solved(changes=None, gas=GAS, **sizes):
    engine, e, fires = engine_of(**(changes or {}))
    return engine, e, fires, throw.solve(engine, e, fires, gas, ThrowInputs(**{**SIZES, **sizes}), materials())


def test_a_throw_by_hand():
    """Bore 100 mm, 101 bar against 1 bar, at rest: F = 25000·π N.  L = 30 + 2·20 + 30 = 100 mm, d 50 mm.

    Pin: M = F·L/4 = 625·π N·m, σ = 32·M/(π·d³) = 160 MPa.  Journal: M = F/2·15 mm = 187.5·π N·m, σ = 48 MPa.
    """
    gas = GasInputs(peak_pressure=101e5, compression_ratio=12.0, crankcase_pressure=1e5)
    _, _, _, (found, checks, _, tables) = solved(
        single(bore=0.1, rated_speed=1e-6),
        gas,
        pin_diameter=0.05,
        journal_diameter=0.05,
        pin_length=0.03,
        journal_length=0.03,
        web_thickness=0.02,
        fillet_radius=None,
    )
    top = found.top_dead_centre
    assert found.span == pytest.approx(0.1)
    assert top.gas_force == pytest.approx(25000 * math.pi)
    assert top.rod_force == top.radial_force == pytest.approx(25000 * math.pi)
    assert top.tangential_force == top.side_thrust == pytest.approx(0)
    assert top.reactions == pytest.approx(dict.fromkeys(("front", "rear"), 12500 * math.pi))
    assert top.pin.bending_moment == pytest.approx(625 * math.pi)
    assert top.pin.von_mises == top.pin.bending_stress == pytest.approx(160e6)
    assert top.journal.von_mises == pytest.approx(48e6)
    assert top.pin.torsion == top.journal.torsion == pytest.approx(0)
    assert top.pin.notch_stress is None
    assert {c.id for c in checks} == {"engine.throw.stress_pin", "engine.throw.stress_journal"}
    assert checks[0].value >= 160 and checks[0].limit == 882.0
    assert [table.id for table in tables] == ["throw_forces", "throw_stresses"]


def test_von_mises_by_hand():
    """M 1000 and T 2000 N·m on d 60 mm: σ 47.157 MPa, τ 47.157 MPa, σ_v = 2·47.157."""
    sigma, tau = t.bending_stress(M=1000.0, d=0.06), t.torsion_stress(T=2000.0, d=0.06)
    assert sigma == tau == pytest.approx(47.157e6, rel=1e-5)
    assert t.von_mises(sigma=sigma, tau=tau) == pytest.approx(94.314e6, rel=1e-5)


@pytest.mark.parametrize("changes", [single(), {}, dict(cylinder_offset=0.008), single(strokes=2)])
@pytest.mark.parametrize("gas", [GAS, None])
def test_equilibrium(changes, gas):
    """Rod: length and side thrust give the piston's force.  Pin: rod less centrifugal force.  Journals: half of it
    each."""
    engine, e, _, (found, *_) = solved(changes, gas)
    for p in (found.largest_tangential, found.top_dead_centre):
        assert p.piston_force == pytest.approx((p.gas_force or 0.0) + p.inertia_force)
        assert math.hypot(p.piston_force, p.side_thrust) == pytest.approx(abs(p.rod_force))
        centrifugal = e.rotating_mass * engine.crank_radius * e.angular_speed**2
        assert math.hypot(p.tangential_force, p.radial_force + centrifugal) == pytest.approx(abs(p.rod_force))
        assert sum(p.reactions.values()) == pytest.approx(math.hypot(p.tangential_force, p.radial_force))
        assert p.pin.bending_moment == pytest.approx(p.reactions["front"] * found.span / 2)
        assert p.journal.torsion - p.torque_in_front == pytest.approx(2 * (p.pin.torsion - p.torque_in_front))
        assert (p.gas_force is None) == (gas is None)
    assert found.top_dead_centre.crank_angle == 0.0
    assert found.top_dead_centre.tangential_force == pytest.approx(0, abs=1e-6)


@pytest.mark.parametrize("changes", [single(), {}, dict(cylinders=4, firing_order=(1, 3, 4, 2)), V6])
def test_tangential_force_is_torque_over_radius_and_the_torque_adds_up_along_the_crank(changes):
    engine, e, fires, (found, *_) = solved(changes)
    k = found.cylinder - 1
    cycle = prepare(engine, e, GAS)
    shared, in_front = throw.pins(engine, e)
    for p in (found.largest_tangential, found.top_dead_centre):
        T = sum(torque.at(engine, e, cycle, fires, p.crank_angle + fires[k])[:2])
        assert p.tangential_force * engine.crank_radius == pytest.approx(T[shared[k]].sum(), abs=1e-6)
        assert p.torque_in_front == pytest.approx(T[in_front[k]].sum(), abs=1e-9)
        assert p.journal.torsion == pytest.approx(T[shared[k] | in_front[k]].sum())
    assert (np.diag(shared)).all() and not (in_front & in_front.T).any() and not (in_front & shared).any()
    assert (shared | in_front | in_front.T).all()


@pytest.mark.parametrize("changes", [single(), {}, dict(cylinders=4, firing_order=(1, 3, 4, 2)), V6])
@pytest.mark.parametrize("gas", [GAS, None])
def test_the_largest_tangential_force_is_that_of_a_fine_scan(changes, gas):
    engine, e, fires, (found, *_) = solved(changes, gas)
    shared, _ = throw.pins(engine, e)
    epsilon = np.linspace(0, 4 * np.pi, 36001)
    T_G, T_I, _ = torque.at(engine, e, prepare(engine, e, gas) if gas else None, fires, epsilon[:, None])
    force = ((T_I if T_G is None else T_G + T_I) @ shared[found.cylinder - 1]) / engine.crank_radius
    assert abs(found.largest_tangential.tangential_force) == pytest.approx(np.abs(force).max(), rel=1e-6)


def test_the_largest_tangential_force_may_stand_at_a_corner_of_the_table():
    """A parabola through its neighbours has its top beside it."""
    bars = {0: 2, 40: 20, 41: 120, 44: 100, 80: 5, 140: 2} | {degrees: 1 for degrees in range(180, 720, 50)}
    points = [PressurePoint(angle=math.radians(degrees), pressure=bar * 1e5) for degrees, bar in bars.items()]
    *_, (found, *_) = solved(single(rated_speed=5.0), GasInputs(pressure=tuple(points)))
    assert math.degrees(found.largest_tangential.crank_angle) == pytest.approx(41.0, abs=1e-9)


def test_the_throw_with_the_largest_stress_governs():
    """Four cylinders: each looked at in both positions; the one in the table with the largest stress is shown."""
    *_, (found, _, notes, tables) = solved(dict(cylinders=4, firing_order=(1, 3, 4, 2)))
    rows = {row[0]: row[1:] for row in tables[2].rows}
    assert len(rows) == 4
    assert max(rows, key=lambda name: max(rows[name])) == f"cylinder {found.cylinder}"
    p, q = found.largest_tangential, found.top_dead_centre
    shown = [s.von_mises / 1e6 for s in (p.pin, p.journal, q.pin, q.journal)]
    assert rows[f"cylinder {found.cylinder}"] == pytest.approx(shown, rel=1e-12)
    assert any(f"cylinder {found.cylinder} governs" in note for note in notes)
    assert found.fatigue is not None and not any("fatigue is not judged" in note for note in notes)


@pytest.mark.parametrize(
    "stress, governs",
    [
        ([[9, 1], [1, 2], [1, 2]], 1),
        ([[1, 1], [1, 9], [5, 5]], 2),  # of the journal too
        ([[9.9, 9.9], [10, 1], [9, 9]], 2),  # by little
        ([[1, 1], [10 - 1e-10, 1], [10, 1]], 2),  # of equal ones the first
    ],
)
@pytest.mark.parametrize("position", [0, 1])
def test_the_throw_with_the_largest_nominal_stress_is_shown(monkeypatch, stress, governs, position):
    """In either position; the fillets, which are not given here, do not count."""
    worst = np.full((2, 3, 4), np.nan)
    worst[1 - position, :, :2], worst[position, :, :2] = 0.5, stress
    monkeypatch.setattr(throw, "_stress_of_all", lambda crank, angles: worst)
    assert solved()[3][0].cylinder == governs


def test_what_the_tables_show():
    """Forces in N, angles in degrees, stresses in MPa, of both positions and of pin and journal."""
    *_, (result, _, _, (forces, stresses, _)) = solved()
    positions = result.largest_tangential, result.top_dead_centre
    numbers = [
        (math.degrees(p.crank_angle), p.gas_force, p.inertia_force, p.piston_force, p.rod_force) for p in positions
    ]
    assert [row[1:6] for row in forces.rows] == numbers
    numbers = [(p.side_thrust, p.tangential_force, p.radial_force) for p in positions]
    assert [row[6:9] for row in forces.rows] == numbers
    numbers = [(*p.reactions.values(), p.torque_in_front) for p in positions]
    assert [row[9:] for row in forces.rows] == numbers
    sections = [section for p in positions for section in (p.pin, p.journal)]
    assert [row[1:3] for row in stresses.rows] == [(s.bending_moment, s.torsion) for s in sections]
    in_mega = [(s.bending_stress, s.torsion_stress, s.von_mises, s.notch_stress) for s in sections]
    assert np.array([row[3:] for row in stresses.rows]) == pytest.approx(np.array(in_mega) / 1e6)


@pytest.mark.parametrize("count, firing_order", [(1, None), (2, (1, 2))])
def test_what_compares_throws_is_there_from_two_throws_on(count, firing_order):
    *_, (_, checks, notes, tables) = solved(dict(cylinders=count, firing_order=firing_order))
    several = count > 1
    assert ("throws" in {table.id for table in tables}) == several
    assert ("engine.throw.span" in {check.id for check in checks}) == several
    assert any("governs" in note for note in notes) == several


def test_forces_on_every_pin_over_the_cycle():
    """Torque over crank radius; without gas every half degree of a turn."""
    engine, e, fires = engine_of(**V6)
    shared, in_front = throw.pins(engine, e)
    crank = throw._Throw(engine, e, fires, None, ThrowInputs(**SIZES))
    assert crank.epsilon == pytest.approx(np.radians(np.arange(0.0, 360.1, 0.5)))
    F_t, F_r, T_v = throw._forces_over_the_cycle(crank)
    _, T, _ = torque.at(engine, e, None, fires, crank.epsilon[:, None])
    assert F_t * engine.crank_radius == pytest.approx(T @ shared.T)
    assert T_v == pytest.approx(T @ in_front.T)
    each = crank.rod(fires, crank.epsilon[:, None]).radial_force
    assert F_r == pytest.approx(each + each[:, [1, 0, 3, 2, 5, 4]])


def test_nothing_passes_through_the_first_throw():
    engine, e, _ = engine_of(cylinders=4, firing_order=(1, 3, 4, 2))
    _, in_front = throw.pins(engine, e)
    assert in_front.sum(1).tolist() == [0, 1, 2, 3]
    # numbered from the flywheel
    _, in_front = throw.pins(engine, replace(e, crank=replace(e.crank, z=e.crank.z[::-1])))
    assert in_front.sum(1).tolist() == [3, 2, 1, 0]


def test_two_rods_on_a_pin():
    """V6 with three pins: both rods load the pin; split pins carry one rod each."""
    engine, e, fires = engine_of(**V6)
    assert throw.pins(engine, e)[0].sum(1).tolist() == [2] * 6
    split = engine_of(
        **{**V6, "bank_angle": math.pi / 3, "crank_angles": tuple(math.radians(a) for a in (0, -60, 240, 180, 120, 60))}
    )
    assert throw.pins(*split[:2])[0].sum(1).tolist() == [1] * 6
    assert throw.pins(*split[:2])[1].sum(1).tolist() == [0, 1, 2, 3, 4, 5]
    found, _, notes, _ = throw.solve(engine, e, fires, GAS, ThrowInputs(**SIZES), materials())
    assert any("same pin" in note for note in notes)
    top = found.top_dead_centre
    assert top.radial_force != pytest.approx(
        top.rod_force - e.rotating_mass * engine.crank_radius * e.angular_speed**2, rel=1e-3
    )


def test_notch_factors_of_norton():
    """Figures of the shaft with a shoulder fillet, D/d = 2: A·(r/d)^b, at r/d = 0.01 and 0.1."""
    for factor, A, b in ((t.notch_bending, 0.90879, -0.28598), (t.notch_torsion, 0.86331, -0.23865)):
        assert [factor(rho_d=0.1), factor(rho_d=0.01)] == pytest.approx([A * 10**-b, A * 100**-b], rel=1e-9)


# --- fatigue
def swinging(seed, shift, size):
    """Forces [N] and torques [N·m] of four cylinders at thirty angles: random, of some kilonewtons."""
    rng = np.random.default_rng(seed)
    F_t, F_r, T_v = (rng.normal(shift, 1.0, (30, 4)) * size for size in size)
    return F_t, F_r, T_v


@pytest.mark.parametrize(
    "forces, sizes, place",
    [
        (swinging(1, 0.0, (2e4, 4e4, 300.0)), {}, "pin"),
        (swinging(2, 2.0, (4e4, 1e4, 300.0)), {}, "pin"),
        (swinging(3, -1.0, (2e4, 4e4, 900.0)), dict(journal_diameter=0.045), "journal"),
        (swinging(4, 1.0, (1e4, 1e4, 2e3)), dict(pin_diameter=0.070, journal_diameter=0.060), "journal"),
    ],
)
def test_the_worst_point_of_all_fillets(forces, sizes, place):
    """Point by point, each 7.5°: the pin's fillet half a journal and a web from the journal's middle, that of the
    journal half a journal; half of the throw's own torque in the pin, all of it in the journal."""
    sizes, r, steel = ThrowInputs(**{**SIZES, **sizes}), 0.05, materials()["42CrMo4"]
    bears = fatigue.strength(steel)
    notch = {"pin": (0.05, 2.1, 1.7), "journal": (0.05, 1.9, 1.6)}
    F_t, F_r, T_v = forces
    points = []
    for name, arm, d, share in (
        ("pin", sizes.journal_length / 2 + sizes.web_thickness, sizes.pin_diameter, 0.5),
        ("journal", sizes.journal_length / 2, sizes.journal_diameter, 1.0),
    ):
        _, K_b, K_t = notch[name]
        for k, angle in itertools.product(range(4), np.radians(np.arange(24) * 7.5)):
            force = F_r[:, k] * math.cos(angle) + F_t[:, k] * math.sin(angle)
            sigma = K_b * 32 / (math.pi * d**3) * arm * force / 2
            tau = K_t * 16 / (math.pi * d**3) * (share * F_t[:, k] * r + T_v[:, k])
            a, m = (
                math.hypot((sigma.max() + of * sigma.min()) / 2, math.sqrt(3) * (tau.max() + of * tau.min()) / 2)
                for of in (-1, 1)
            )
            points.append((fatigue.equivalent_amplitude(sigma_a=a, sigma_m=m, M=bears.sensitivity), a, m, name, k + 1))
    worst = max(points)
    result = t.judged(forces, notch, sizes, r, steel, ())
    numbers = result.fatigue_equivalent, result.fatigue_amplitude, result.fatigue_mean
    assert numbers == pytest.approx(worst[:3]) and (result.place, result.cylinder) == worst[3:]
    assert result.place == place and result.wanted == bears.safety
    assert result.fatigue_safety == pytest.approx(bears.bearable / worst[0])


@pytest.mark.parametrize("r_d", [0.04, 0.06, 0.1, 0.2])
def test_notch_factor_in_bending_beside_another_fit(r_d):
    """Roark's Formulas for Stress and Strain, table 17.1, square shoulder with fillet in a circular shaft, D/d = 2, h/r
    from 2 to 20.

    The two fits of Peterson's chart are 6 % apart at 0.04, 4 % at 0.06 and 2 % at 0.1.
    """
    q = 0.5 / r_d
    a = (
        1.225 + 0.831 * q**0.5 - 0.010 * q,
        -3.790 + 0.958 * q**0.5 - 0.257 * q,
        7.374 - 4.834 * q**0.5 + 0.862 * q,
        -3.809 + 3.046 * q**0.5 - 0.595 * q,
    )
    assert t.notch_bending(rho_d=r_d) == pytest.approx(
        sum(c / 2**i for i, c in enumerate(a)), rel=0.07 if r_d < 0.05 else 0.05
    )


@pytest.mark.parametrize("r_d", [0.125, 0.2, 0.3])
def test_notch_factor_in_torsion_beside_another_fit(r_d):
    """Peterson's Stress Concentration Factors, shoulder fillet in a round shaft, polynomial fit, h/r from 0.25 to 4,
    D/d = 2."""
    q = 0.5 / r_d
    a = (
        0.905 + 0.783 * q**0.5 - 0.075 * q,
        -0.437 - 1.969 * q**0.5 + 0.553 * q,
        1.557 + 1.073 * q**0.5 - 0.578 * q,
        -1.061 + 0.171 * q**0.5 + 0.086 * q,
    )
    assert t.notch_torsion(rho_d=r_d) == pytest.approx(sum(c / 2**i for i, c in enumerate(a)), rel=0.05)


def test_notch_stress_is_that_of_the_fillet():
    """The pin's fillet stands at the web, where the moment is smaller than at its middle; the journal's is its section
    itself."""
    *_, (found, checks, _, _) = solved()
    for p in (found.largest_tangential, found.top_dead_centre):
        at_web = p.reactions["front"] * (SIZES["journal_length"] / 2 + SIZES["web_thickness"])
        sigma = 32 * at_web / (math.pi * SIZES["pin_diameter"] ** 3)
        assert p.pin.notch_stress == pytest.approx(
            math.hypot(found.notch_bending_pin * sigma, math.sqrt(3) * found.notch_torsion_pin * p.pin.torsion_stress)
        )
        bending, torsion = (
            found.notch_bending_journal * p.journal.bending_stress,
            found.notch_torsion_journal * p.journal.torsion_stress,
        )
        assert p.journal.notch_stress == pytest.approx(math.hypot(bending, math.sqrt(3) * torsion))
    kinds = {c.id: c.kind for c in checks}
    for place in ("pin", "journal"):
        assert [kinds[f"engine.throw.{what}_{place}"] for what in ("stress", "notch_stress", "fillet")] == [
            "limit",
            "caution",
            "method",
        ]


@pytest.mark.parametrize(
    "sizes, id, verdict",
    [
        (dict(pin_diameter=0.025), "engine.throw.stress_pin", "fail"),
        (dict(journal_diameter=0.02), "engine.throw.stress_journal", "fail"),
        (dict(), "engine.throw.stress_pin", "pass"),
        (dict(fillet_radius=0.0002), "engine.throw.fillet_pin", "note"),
        (dict(fillet_radius=0.0002), "engine.throw.fillet_journal", "note"),
        (dict(pin_diameter=0.037), "engine.throw.notch_stress_pin", "pass"),
        (dict(pin_diameter=0.032), "engine.throw.notch_stress_pin", "warn"),
    ],
)
def test_verdicts(sizes, id, verdict):
    *_, (_, checks, _, _) = solved(**sizes)
    assert {c.id: c.verdict for c in checks}[id] == verdict


@pytest.mark.parametrize("material", ["20CrNi4", "unobtainium"])
def test_of_a_material_without_known_strength_the_fillets_are_not_judged(material):
    *_, (_, checks, notes, _) = solved(material=material)
    assert {c.id.removeprefix("engine.throw."): c.verdict for c in checks} == {
        "fillet_pin": "pass",
        "fillet_journal": "pass",
        "span": "pass",
        "stress_pin": "pass",
        "stress_journal": "pass",
        "fatigue": "not_verified",
    }
    assert any(f"proof stress of {material}" in note for note in notes)
    *_, (_, _, notes, _) = solved(material=material, fillet_radius=None)
    assert not any(f"proof stress of {material}" in note for note in notes)


def test_inertia_alone_is_said():
    *_, (found, _, notes, _) = solved(gas=None)
    assert any("inertia alone" in note for note in notes)
    assert found.top_dead_centre.piston_force == found.top_dead_centre.inertia_force < 0


def test_names_and_lines_of_the_values():
    """What the contract names, and each value but the positions leads back to a recorded line."""
    engine, e, fires = engine_of()
    with trace() as lines:
        found, *_ = throw.solve(engine, e, fires, GAS, ThrowInputs(**SIZES), materials())
    values = {p.id.removeprefix("engine.throw."): p for p in published(found, "engine.throw")}
    for where in ("largest_tangential", "top_dead_centre"):
        for name in (
            "rod_force",
            "tangential_force",
            "radial_force",
            "reaction_front",
            "reaction_rear",
            "pin.von_mises",
            "journal.torsion",
        ):
            assert f"{where}.{name}" in values
    assert {name for name, p in values.items() if link_of(p.inside) not in lines} == {"cylinder"}
    assert set(leaves(link_of(values["cylinder"].inside))) <= set(lines)


def test_the_gas_of_the_torque_may_be_handed_over():
    engine, e, fires = engine_of()
    cycle = torque.solve(engine, e, fires, GAS, None)[0].cycle
    one, two = (
        throw.solve(engine, e, fires, GAS, ThrowInputs(**SIZES), materials(), given)[0] for given in (cycle, None)
    )
    assert [p.shown for p in published(one, "throw")] == [p.shown for p in published(two, "throw")]


def test_each_place_is_judged_on_its_own_worst_throw():
    """The pin of one throw may govern while the journal of another carries more."""
    *_, (_, checks, _, tables) = solved(dict(cylinders=4, firing_order=(1, 3, 4, 2)))
    rows = next(table for table in tables if table.id == "throws").rows
    by_id = {c.id: c.value for c in checks}
    assert by_id["engine.throw.stress_pin"] == pytest.approx(max(max(row[1], row[3]) for row in rows))
    assert by_id["engine.throw.stress_journal"] == pytest.approx(max(max(row[2], row[4]) for row in rows))


@pytest.mark.parametrize("journal_length, verdict", [(0.034, "pass"), (0.08, "note")])
def test_a_span_that_does_not_fit_the_pitch_is_named(journal_length, verdict):
    *_, (_, checks, _, _) = solved(journal_length=journal_length)
    assert {c.id: c.verdict for c in checks}["engine.throw.span"] == verdict
