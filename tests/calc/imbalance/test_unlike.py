"""Masses as they move and crank radii, one for all cylinders or one for each, and rotating masses that the crank
balances in part."""

import importlib.util
import math
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.design.toml_file import Document, design, parse
from calc.engine import solve as engine
from calc.engine.crank import pin_of_cylinder
from calc.imbalance.inputs import ImbalanceInputs
from calc.imbalance.throws import polygons
from calc.sheet.errors import BadInput
from calc.sheet.quantity import published
from calc.solve import solve
from tests.calc.imbalance.engines import R753, solved

PLAIN = {
    key: value
    for key, value in R753.items()
    if key not in ("piston_mass", "rod_mass", "rod_cg_to_big_end", "crankpin_bearing_mass")
}
ROOT = Path(__file__).parents[3]

# Khurmi and Gupta, Theory of Machines, Balancing of Reciprocating Masses (from memory): an inside-cylinder locomotive,
# cylinders 0.7 m apart, stroke 0.6 m, rotating masses of 150 kg at the crankpin and reciprocating ones of 180 kg per
# cylinder, wheels 1.5 m apart, cranks at right angles; all of the rotating and two thirds of the reciprocating masses
# balanced at 0.6 m; 300 rpm.
LOCOMOTIVE = """
schema = 1
name = "locomotive"
[engine]
name = "inside cylinders"
layout = "inline"
cylinders = 2
strokes = 2
bore_mm = 500.0
crank_radius_mm = 300.0
rod_length_mm = 1500.0
cylinder_pitch_mm = 700.0
crank_angles_deg = [0.0, 90.0]
reciprocating_masses_kg = 180.0
rotating_masses_kg = 150.0
rated_speed_rpm = 300.0
[imbalance]
crank_balance_fraction = 0.6666666666666666
kinematics = "two_term"
counterweight_span_mm = 1500.0
counterweight_radius_mm = 600.0
"""


def values(text):
    return {id: v.shown for id, v in solve(design(parse(text.encode(), "d.toml"))).values().items()}


def errors(text):
    with pytest.raises(BadInput) as caught:
        design(parse(text.encode(), "d.toml"))
    return str(caught.value)


def test_the_locomotive_of_khurmi():
    found = values(LOCOMOTIVE)
    # g; 105 kg in each wheel, from a drawn polygon
    assert found["imbalance.counterweight.front.mass"] == pytest.approx(105e3, abs=0.5e3)
    # variation of the tractive effort
    assert found["imbalance.order_1.force_peak_vertical"] == pytest.approx(25127, rel=5e-4)
    assert found["imbalance.order_1.couple_peak_vertical"] == pytest.approx(8797, rel=5e-4)  # swaying couple
    assert found["engine.reciprocating_mass"] == 180e3 and found["engine.rotating_mass"] == 150e3


def test_the_inner_masses_that_balance_four_cranks():
    """Khurmi's kind of problem, worked by hand: cranks 1 and 4 with 400 kg 120° apart, planes 450, 750 and 600 mm
    apart; complete primary balance gives masses and angles of 2 and 3 by two vector equations, and the secondary force
    is what is left: r = 300 mm, L = 1.2 m."""
    z = np.array([0.0, 0.45, 1.2, 1.8]) - 0.9
    outer = 400 * np.exp(1j * np.array([0.0, math.radians(120)]))
    inner = np.linalg.solve([[1, 1], z[1:3]], [-outer.sum(), -(outer @ z[[0, 3]])])
    m = np.array([400, *np.abs(inner), 400])
    phi = np.angle([outer[0], *inner, outer[1]])
    left = abs(np.sum(m * np.exp(2j * phi))) * 0.3 * (2 * math.pi * 4) ** 2 * 0.3 / 1.2
    text = LOCOMOTIVE.replace("cylinders = 2", "cylinders = 4").replace(
        "rod_length_mm = 1500.0", "rod_length_mm = 1200.0"
    )
    text = text.replace("= [0.0, 90.0]", f"= {np.degrees(phi).tolist()}\naxial_positions_mm = {(z * 1e3).tolist()}")
    text = text.replace("_kg = 180.0", f"_kg = {m.tolist()}").replace("rpm = 300.0", "rpm = 240.0")
    found = values(text.replace("crank_balance_fraction = 0.6666666666666666", "crank_balance_fraction = 0.0"))
    for name in ("force_forward", "force_backward"):
        assert found[f"imbalance.order_1.{name}"] < 1e-6
    for name in ("couple_forward", "couple_backward"):
        assert found[f"imbalance.order_1.{name}"] < 1e-6
    assert found["imbalance.order_2.force_peak_vertical"] == pytest.approx(left, rel=1e-9) and left > 1000
    assert found["engine.reciprocating_mass"] == pytest.approx(m.mean() * 1e3)


@settings(max_examples=20, deadline=None)
@given(
    st.lists(st.floats(0.1, 500), min_size=3, max_size=3, unique=True),
    st.lists(st.floats(0.03, 0.08), min_size=3, max_size=3),
    st.floats(0, 1),
    st.floats(0, 1.5),
)
def test_the_vectors_are_the_forces_over_a_turn(m, r, kappa, rho):
    """Force and couple of all pistons, crank masses and counterweights, summed at 64 crank angles from the exact
    accelerations."""
    rotating = (5.0, 0.0, 7.0)
    inputs, e, found = solved(
        ImbalanceInputs(crank_balance_fraction=kappa, rotating_balance_fraction=rho),
        piston_mass=None,
        rod_mass=None,
        rod_cg_to_big_end=None,
        crankpin_bearing_mass=0.0,
        reciprocating_masses=tuple(m),
        rotating_masses=rotating,
        crank_radius=r[0],
        crank_radii=tuple(r),
    )
    theta = np.arange(64) * (2 * np.pi / 64)
    r, omega = np.array(r), e.angular_speed
    lam = r / inputs.rod_length
    alpha = theta[:, None] + e.crank.phi
    s = np.sqrt(1 - (lam * np.sin(alpha)) ** 2)
    a = np.cos(alpha) + lam * np.cos(2 * alpha) / s + lam**3 * np.sin(2 * alpha) ** 2 / (4 * s**3)
    force = np.array(m) * a * r * omega**2 + (
        (1 - rho) * np.array(rotating) - kappa * np.array(m)
    ) * r * omega**2 * np.exp(1j * alpha)
    scale = max(max(m), 7.0) * r.max() * omega**2
    for kind, arm, size in (("force", 1.0, scale), ("couple", e.crank.z, scale * 0.112)):
        spectrum = np.fft.fft((force * arm).sum(1)) / 64
        for n in (1, 2, 4):
            one = found.orders[f"order_{n}"]
            assert getattr(one, f"{kind}_forward") == pytest.approx(abs(spectrum[n]), abs=1e-9 * size)
            assert getattr(one, f"{kind}_backward") == pytest.approx(abs(spectrum[-n]), abs=1e-9 * size)


@pytest.mark.parametrize(
    "nearly",
    [
        dict(reciprocating_masses=(1.49, 1.49 + 1e-13, 1.49 - 1e-13)),
        dict(crank_radii=(0.0535, 0.0535 + 1e-15, 0.0535 - 1e-15)),
    ],
)
def test_what_hardly_differs_is_alike(nearly):
    """The sums with each mass and radius inside, and the torque, against those with the one mass and radius outside."""
    like = dict(reciprocating_masses=(1.49,), rotating_masses=(0.75,), crank_radius=0.0535)
    nearly = like | nearly
    none = dict(piston_mass=None, rod_mass=None, rod_cg_to_big_end=None, crankpin_bearing_mass=0.0)
    given = ImbalanceInputs(
        crank_balance_fraction=0.3,
        rotating_balance_fraction=0.8,
        counterweight_span=0.3,
        counterweight_radius=0.04,
        bob_mass=1.0,
    )
    one, other = (
        {
            v.id: v.shown
            for v in published(solved(given, **none, **masses)[2], "i")
            if not v.id.startswith(("i.order_8", "i.equivalent"))
        }
        for masses in (like, nearly)
    )  # order 8 is a millionth of order 1; the equivalent mass may be one for each
    assert one == pytest.approx(other, rel=1e-8, abs=1e-7)
    turning = [engine.solve(solved(given, **none, **masses)[0]).solution.torque for masses in (like, nearly)]
    assert turning[0].inertia_torque_peak == pytest.approx(turning[1].inertia_torque_peak, rel=1e-9)
    assert np.abs(turning[0].harmonics) == pytest.approx(np.abs(turning[1].harmonics), abs=1e-9)


def test_the_inertia_torque_of_unlike_cylinders():
    """Sum over the cylinders of −m·a·v/ω at 720 crank angles, and its orders; what each has by itself."""
    m, r = (1.0, 2.5, 4.0), np.array([0.05, 0.04, 0.06])
    changes = dict(
        piston_mass=None,
        rod_mass=None,
        rod_cg_to_big_end=None,
        crankpin_bearing_mass=0.0,
        reciprocating_masses=m,
        rotating_masses=(1.0,),
        crank_radius=r[0],
        crank_radii=tuple(r),
    )
    inputs, e, _ = solved(**changes)
    t = engine.solve(inputs).solution.torque
    theta = np.arange(720) * (2 * np.pi / 720)
    alpha = theta[:, None] + e.crank.phi
    lam, omega = r / inputs.rod_length, e.angular_speed
    s = np.sqrt(1 - (lam * np.sin(alpha)) ** 2)
    v = np.sin(alpha) * (1 + lam * np.cos(alpha) / s)
    a = np.cos(alpha) + lam * np.cos(2 * alpha) / s + lam**3 * np.sin(2 * alpha) ** 2 / (4 * s**3)
    T = -(np.array(m) * a * v * r**2).sum(1) * omega**2
    assert t.inertia_torque_peak == pytest.approx(np.abs(T).max(), rel=1e-4)
    assert np.abs(t.harmonics) == pytest.approx(2 * np.abs(np.fft.rfft(T))[1:9] / 720, abs=1e-9 * np.abs(T).max())
    assert e.displacement == pytest.approx(math.pi / 4 * inputs.bore**2 * 2 * r.sum())
    assert [one.stroke for one in e.cylinder.values()] == pytest.approx(2 * r)
    assert [one.acceleration_max for one in e.cylinder.values()] == pytest.approx((1 + lam) * r * omega**2)


def test_cylinders_side_by_side_share_a_pin_only_at_one_radius():
    vee = LOCOMOTIVE.replace('"inline"', '"vee"\nbank_angle_deg = 60.0').replace("[0.0, 90.0]", "[0.0, 0.0]")
    for radii, pins in (([300.0, 300.0], [0, 0]), ([300.0, 250.0], [0, 1])):
        inputs = design(parse(vee.replace("bore_mm", f"crank_radii_mm = {radii}\nbore_mm").encode(), "d.toml")).engine
        assert pin_of_cylinder(inputs, engine.values(inputs).crank).tolist() == pins


def test_each_throw_and_each_bob_stands_at_its_own_radius():
    """The throws together, and what bobs of 0.5 kg lack of the equivalent masses: sums of m·r and m·r·z; the polygon
    ends where they do."""
    r = np.array([0.05, 0.04, 0.06])
    given = ImbalanceInputs(crank_balance_fraction=0.3, bob_mass=0.5)
    inputs, e, found = solved(given, crank_radius=r[0], crank_radii=tuple(r))
    turned, omega = r * np.exp(1j * e.crank.phi) * e.angular_speed**2, e.angular_speed
    whole = e.rotating_mass * turned.sum()
    lacking = (e.rotating_mass + 0.3 * e.reciprocating_mass - 0.5) * turned
    assert found.throw.force_together == pytest.approx(abs(whole))
    assert found.webs.missing_forward_force == pytest.approx(abs(lacking.sum()))
    assert found.webs.missing_forward_couple == pytest.approx(abs((lacking * e.crank.z).sum()))
    assert found.one_force == pytest.approx(e.reciprocating_mass * r.mean() * omega**2)
    ends = polygons(inputs, e, found.throw)[0].series[3]
    assert ends.y[1] + 1j * ends.x[1] == pytest.approx(whole)


def test_rotating_masses_that_the_crank_leaves():
    inputs, e, none = solved(
        ImbalanceInputs(crank_balance_fraction=0.0, rotating_balance_fraction=0.0), cylinders=1, firing_order=None
    )
    _, _, all_ = solved(ImbalanceInputs(crank_balance_fraction=0.0), cylinders=1, firing_order=None)
    more = none.orders["order_1"].force_forward - all_.orders["order_1"].force_forward
    assert more == pytest.approx(e.rotating_mass * inputs.crank_radius * e.angular_speed**2)
    assert none.orders["order_1"].force_backward == all_.orders["order_1"].force_backward


def test_rotating_masses_that_are_left_are_not_laid_on_the_share_of_the_reciprocating_ones():
    """With a tenth of the rotating masses left, half of the reciprocating ones leaves more than 0.6 of them does; no
    offset is in it."""
    single = {
        "schema": 1,
        "name": "d",
        "imbalance": {"crank_balance_fraction": 0.5, "rotating_balance_fraction": 0.9},
        "engine": {
            "name": "one",
            "layout": "inline",
            "cylinders": 1,
            "strokes": 4,
            "bore_mm": 85.0,
            "crank_radius_mm": 36.0,
            "rod_length_mm": 112.0,
            "cylinder_pitch_mm": 100.0,
            "reciprocating_masses_kg": [0.4],
            "rotating_masses_kg": [0.5],
            "cylinder_offset_mm": 2.0,
            "rated_speed_rpm": 6000.0,
        },
    }
    for shares, verdict in (((0.5, 0.9), "warn"), ((0.5, 1.0), "pass")):
        single["imbalance"] = dict(zip(("crank_balance_fraction", "rotating_balance_fraction"), shares))
        found = solve(design(Document(single))).outcomes["imbalance"]
        (check,) = [c for c in found.checks if c.id == "imbalance.order_1.forward_force"]
        assert check.verdict == verdict
        told = " ".join((check.advice, *found.proposals, *found.notes, *(row[0] for row in found.tables[0].rows)))
        whole = shares[1] == 1
        assert ("rotating_balance_fraction 1, crank_balance_fraction 0.5" in told) is not whole
        assert ("the rotating masses are balanced to a share of 0.9 only" in told) is not whole
        assert ("To a share of 0.9 only (rotating_balance_fraction)" in told) is not whole
        assert ("rotating masses as designed (share 0.9), nothing else" in told) is not whole
        assert ("The offset turns it" in told or "the offset turns it" in told) is whole


def test_an_input_that_moves_a_value_stands_in_its_chain():
    spec = importlib.util.spec_from_file_location("provenance_of_unlike", ROOT / "bench" / "provenance.py")
    provenance = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(provenance)
    text = LOCOMOTIVE.replace("_kg = 180.0", "_kg = [180.0, 200.0]").replace(
        "kinematics", "rotating_balance_fraction = 0.9\nkinematics"
    )
    text = text.replace("rod_length", "crank_radii_mm = [300.0, 280.0]\nrod_length")
    document = parse(text.encode(), "d.toml")
    results = solve(design(document))
    chains, before = provenance.Chains(results), {id: v.shown for id, v in results.values().items()}
    for key, number in (
        ("engine.reciprocating_masses_kg.1", 210.0),
        ("engine.rotating_masses_kg", 160.0),
        ("engine.crank_radii_mm.1", 290.0),
        ("imbalance.rotating_balance_fraction", 0.8),
    ):
        after = {id: v.shown for id, v in solve(design(document.with_value(key, number))).values().items()}
        moved = [id for id in before if id in after and abs(after[id] - before[id]) > 1e-9 * abs(before[id])]
        assert moved
        for id in moved:
            assert key.removesuffix(".1") in {k for link in chains.of(id) for k in link.inputs}, id


@pytest.mark.parametrize(
    "old, new, wanted",
    [
        (
            "reciprocating_masses_kg = 180.0\n",
            "",
            ["engine.piston_mass_g", "engine.rod_mass_g", "is missing", "or reciprocating_masses_kg"],
        ),
        (
            "_kg = 180.0",
            "_kg = [180.0, 1.0, 2.0]",
            ["engine.reciprocating_masses_kg", "has 3 entries; needs one, or one per cylinder, 2"],
        ),
        ("_kg = 150.0", "_kg = -1.0", ["engine.rotating_masses_kg: -1.0", "from 0 to 1·10⁶ kg"]),
        (
            "bore",
            "crank_radii_mm = [300.0]\nbore",
            ["engine.crank_radii_mm", "has 1 entries; needs one per cylinder, 2"],
        ),
        ("bore", "crank_radii_mm = [280.0, 300.0]\nbore", ["engine.crank_radii_mm", "must begin with crank_radius_mm"]),
        (
            "rod_length_mm = 1500",
            "crank_radii_mm = [300.0, 950.0]\nrod_length_mm = 900",
            ["engine.crank_radii_mm: cylinder 2: 950 mm", "below rod_length_mm"],
        ),
        (
            "bore",
            "crank_radii_mm = [300.0, 280.0]\ncylinder_offset_mm = 5.0\nbore",
            ["engine.cylinder_offset_mm", "must be 0 where"],
        ),
        (
            "[imb",
            "crank_radii_mm = [300.0, 280.0]\n[engine.gas]\npeak_pressure_bar = 80.0\ncompression_ratio = 9.0\n[imb",
            ["of one stroke"],
        ),
        ("_kg = 180.0", "_kg = 0.0", ["engine.reciprocating_masses_kg: 0.0", "above 0"]),
        (
            "rated",
            "piston_mass_g = 400.0\nrated",
            ["engine.piston_mass_g: 400.0: reciprocating_masses_kg has its mass already"],
        ),
        (
            "rated",
            "crankpin_bearing_mass_g = 4.0\nrated",
            ["engine.crankpin_bearing_mass_g: 4.0: rotating_masses_kg has its mass already"],
        ),
    ],
)
def test_what_is_refused(old, new, wanted):
    said = errors(LOCOMOTIVE.replace(old, new, 1))
    assert all(part in said for part in wanted), said
