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
from calc.engine.crank import firing, pin_of_cylinder
from calc.imbalance.checks import checks
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


def by_hand(inputs, e, arm, m):
    """Harmonics of all pistons' force and couple and of the torque on the block, from the place of each piston on its
    axis at 256 crank angles alone: acceleration as the second derivative of its Fourier series."""
    theta = np.arange(256) * (2 * np.pi / 256)
    r, d, L = np.array(inputs.radii), np.array(inputs.offsets), inputs.rod_length
    alpha = theta[:, None] + e.crank.theta_0 + e.crank.phi - e.crank.psi
    height = r * np.cos(alpha) + np.sqrt(L**2 - (r * np.sin(alpha) - d) ** 2)
    n = np.fft.fftfreq(256, 1 / 256)[:, None]
    force = -np.array(m) * np.fft.ifft(-(n**2) * np.fft.fft(height, axis=0), axis=0).real * e.angular_speed**2
    vectors = force * np.exp(1j * e.crank.psi)
    # what the pistons press on their liners; the rest goes through the crank's axis
    thrust = force * (r * np.sin(alpha) - d) / np.sqrt(L**2 - (r * np.sin(alpha) - d) ** 2)
    block = (thrust * height).sum(1)
    return np.fft.fft(vectors.sum(1)) / 256, np.fft.fft((vectors * arm).sum(1)) / 256, np.fft.rfft(block) / 128, height


@settings(max_examples=25, deadline=None)
@given(st.data())
def test_offsets_and_directions_of_each_cylinder(data):
    """A W or radial engine whose cylinders have offset, radius, direction and mass of their own."""
    n = data.draw(st.integers(2, 6))

    def of_each(low, high):
        return tuple(data.draw(st.lists(st.floats(low, high), min_size=n, max_size=n)))

    d, r, m = of_each(-0.03, 0.03), of_each(0.03, 0.08), of_each(0.2, 3)
    inputs, e, found = solved(
        ImbalanceInputs(crank_balance_fraction=0.0),
        layout=data.draw(st.sampled_from(["w", "radial"])),
        cylinders=n,
        cylinder_directions=of_each(-3, 3),
        cylinder_offset=d[0],
        cylinder_offsets=d,
        crank_radius=r[0],
        crank_radii=r,
        cylinder_pitch=None,
        axial_positions=of_each(-0.3, 0.3),
        crank_angles=of_each(0, 6.28),
        firing_order=None,
        piston_mass=None,
        reciprocating_masses=m,
    )
    force, couple, block, _ = by_hand(inputs, e, e.crank.z, m)
    size = max(m) * max(r) * e.angular_speed**2
    for n in (1, 2, 4):
        one = found.orders[f"order_{n}"]
        for found_one, theirs, scale in (("force", force, size), ("couple", couple, size * 0.3)):
            assert getattr(one, f"{found_one}_forward") == pytest.approx(abs(theirs[n]), abs=1e-8 * scale)
            assert getattr(one, f"{found_one}_backward") == pytest.approx(abs(theirs[-n]), abs=1e-8 * scale)
    turning = engine.solve(inputs).solution.torque
    assert np.abs(turning.reaction_harmonics) == pytest.approx(np.abs(block[1:9]), abs=1e-8 * size * max(r))


# A VR6 by its layout: ±22 mm at 10.8°, 96.4 mm stroke; rod, pitch and mass are round ones near those that are built.
VR6 = dict(
    layout="vee",
    cylinders=6,
    bore=0.089,
    crank_radius=0.0482,
    rod_length=0.16,
    bank_angle=math.radians(10.8),
    firing_order=(1, 5, 3, 6, 2, 4),
    cylinder_pitch=None,
    axial_positions=tuple((k - 2.5) * 0.068 for k in range(6)),
    piston_mass=None,
    rod_mass=None,
    rod_cg_to_big_end=None,
    crankpin_bearing_mass=0.0,
    reciprocating_masses=(0.59,),
    rotating_masses=(0.5,),
    rated_speed=100.0,
)


def test_the_offsets_of_a_vr6_are_of_opposite_sign():
    """Order 2 and 3 against `by_hand`, each piston at its top dead centre where it fires, and what one sense for both
    banks makes of it."""
    inputs, e, found = solved(cylinder_offset=-0.022, cylinder_offsets=(-0.022, 0.022) * 3, **VR6)
    force, couple, _, height = by_hand(inputs, e, e.crank.z, (0.59,) * 6)
    of = found.orders
    assert of["order_2"].couple_peak == pytest.approx(abs(couple[2]) + abs(couple[-2]), rel=1e-9)
    assert of["order_3"].force_peak == pytest.approx(abs(force[3]) + abs(force[-3]), rel=1e-9)
    assert (of["order_2"].couple_peak, of["order_3"].force_peak) == pytest.approx((352, 339), abs=0.5)
    fires = firing(inputs, e.crank)
    assert fires.order == (1, 5, 3, 6, 2, 4) and np.degrees(fires.intervals) == pytest.approx([120] * 6)
    theta = np.arange(256) * (2 * np.pi / 256)
    for k, angle in enumerate(fires.angles):
        there = np.interp((angle + np.array([-0.1, 0, 0.1])) % (2 * np.pi), theta, height[:, k], period=2 * np.pi)
        assert there[1] == pytest.approx(height[:, k].max(), abs=1e-5) and there[0] == pytest.approx(there[2], rel=1e-3)
    told = " ".join(
        str(c.advice) for c in checks(found, 0.3, 0.5, 1.0, taken=frozenset({-1}), offsets_differ=True) if not c.holds
    )
    assert "Offsets that differ turn each cylinder's force" in told and "balance half" not in told
    assert "further masses on it, opposite to the phase of what is left, take it" in told
    both = solved(cylinder_offset=0.022, **VR6)[2].orders
    assert (both["order_2"].couple_peak, both["order_3"].force_peak) == pytest.approx((158, 1085), abs=0.5)


def test_a_radial_engine_fires_every_other_cylinder():
    """Nine on one crankpin, all in one plane: the vectors of first order turn with the crank alone and half of the
    mass takes them whole (rods that turn about the pin); the order of the Wright and Pratt & Whitney nines."""
    inputs, e, found = solved(
        layout="radial", cylinders=9, crank_angles=(0.0,) * 9, firing_order=None, cylinder_pitch=None,
        axial_positions=(0.0,) * 9,
    )  # fmt: skip
    assert firing(inputs, e.crank).order == (1, 3, 5, 7, 9, 2, 4, 6, 8)
    assert set(pin_of_cylinder(inputs, e.crank)) == {0}
    assert found.orders["order_1"].force_peak == pytest.approx(0, abs=1e-9 * found.one_force)
    assert found.one_couple == found.one_force * inputs.bore
    by_order, *_ = solved(layout="radial", cylinders=9, firing_order=(1, 3, 5, 7, 9, 2, 4, 6, 8))
    assert engine.values(by_order).crank.phi % (2 * math.pi) == pytest.approx([0] * 9, abs=1e-12)


def test_a_w_of_two_banks_is_a_vee_and_its_places_give_the_pitch():
    places = tuple((k // 2 - 1) * 0.112 for k in range(6))
    vee = dict(cylinders=6, firing_order=None, crank_angles=(0.0, 0.0, 4.0, 4.0, 2.0, 2.0), axial_positions=places)
    _, _, one = solved(layout="vee", bank_angle=1.2, **vee)
    w = dict(layout="w", cylinder_directions=(-0.6, 0.6) * 3, cylinder_pitch=None, **vee)
    inputs, e, other = solved(**w)
    assert e.crank.pitch == pytest.approx(0.112, rel=1e-12)
    assert pin_of_cylinder(inputs, e.crank).tolist() == [0, 0, 1, 1, 2, 2]
    ours, theirs = ({v.id: v.shown for v in published(x, "i")} for x in (one, other))
    assert theirs == pytest.approx(ours, rel=1e-9, abs=1e-9)


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
        "schema": 2,
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
    text = text.replace("rod_length", "crank_radii_mm = [300.0, 280.0]\ncylinder_offsets_mm = [0.0, 20.0]\nrod_length")
    text = text.replace('"inline"', '"w"').replace(
        "cylinder_pitch_mm = 700.0", "axial_positions_mm = [-350.0, 350.0]\ncylinder_directions_deg = [0.0, 10.0]"
    )
    document = parse(text.encode(), "d.toml")
    results = solve(design(document))
    chains, before = provenance.Chains(results), {id: v.shown for id, v in results.values().items()}
    for key, number in (
        ("engine.reciprocating_masses_kg.1", 210.0),
        ("engine.rotating_masses_kg", 160.0),
        ("engine.crank_radii_mm.1", 290.0),
        ("engine.cylinder_offsets_mm.1", 30.0),
        ("engine.axial_positions_mm.1", 360.0),
        ("engine.cylinder_directions_deg.1", 15.0),
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
            ["engine.crank_radii_mm: cylinder 2: radius plus offset, 950 mm", "not below rod_length_mm"],
        ),
        (
            "[imb",
            "crank_radii_mm = [300.0, 280.0]\n[engine.gas]\npeak_pressure_bar = 80.0\ncompression_ratio = 9.0\n[imb",
            ["engine.gas: its pressure is that of cylinders of one motion"],
        ),
        ("bore", "cylinder_offsets_mm = [5.0, -5.0]\nbore", ["engine.cylinder_offsets_mm", "must begin with"]),
        (
            "bore",
            "cylinder_offsets_mm = [0.0, 1200.0]\nbore",
            ["engine.cylinder_offsets_mm"],
        ),
        (
            "rod_length_mm = 1500.0",
            "crank_radii_mm = [300.0, 280.0]\ncylinder_offsets_mm = [0.0, 480.0]\nrod_length_mm = 700.0",
            ["engine.crank_radii_mm: cylinder 2: radius plus offset, 760 mm"],
        ),
        ("cylinder_pitch_mm = 700.0\n", "", ["engine.cylinder_pitch_mm: needed, or axial_positions_mm"]),
        ("bore", "cylinder_directions_deg = [0.0, 90.0]\nbore", ["engine.cylinder_directions_deg", "leave it out"]),
        ('"inline"', '"w"', ["engine.cylinder_directions_deg: needed for a W engine"]),
        ('"inline"', '"radial"\nbank_of_cylinder = [0, 1]', ["engine.bank_of_cylinder", "belongs to two banks"]),
        ("cylinders = 2", 'cylinders = "two"\ncylinder_offsets_mm = [0.0, 5.0]', ["engine.cylinders"]),
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
