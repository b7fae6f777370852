"""Targets, shop angles, rings, and what a reading asks to be drilled: against given values, and by physics."""

import cmath
import json
import math
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from calc.countershaft.balancing.drilling import amounts
from calc.countershaft.balancing.inputs import Balancing
from calc.sheet.quantity import published
from calc.sheet.record import replace
from tests.calc.countershaft.balancing.sheets import GAMMA, hole, reading, shaft, sheet_of, tolerance
from tests.conftest import ROOT

GIVEN = json.loads((ROOT / "tests" / "reference" / "balancing.json").read_text(encoding="utf-8"))["given"]
SHEETS, RULED = {}, []  # the case of a name stands in the first row that has it
for row in GIVEN:
    if isinstance(row["case"], dict) and "masses" in row["case"]:
        SHEETS["gamma" if not SHEETS else "r754_left"] = row["case"]
    if row["quantity"].startswith(("countershaft.", "…")) and "shop_angle" not in row["quantity"]:
        RULED.append((row["case"] if isinstance(row["case"], str) else list(SHEETS)[-1], row))
SHOWN = {"g mm": 1e-6, "deg": math.pi / 180, "N": 1.0}


def of_case(name):
    case = SHEETS[name]
    masses = [[mass[key] for key in ("mass_kg", "radius_mm", "angle_deg", "z_mm")] for mass in case["masses"]]
    inputs = shaft(masses, case["bearing_positions_mm"], case["speed_ratio"])
    per = tolerance(inputs, case["mass_kg"], case["centre_of_gravity_mm"], case["rated_speed_rpm"])
    rings = tuple(z * 1e-3 for z in case["ring_positions_mm"])
    table = Balancing(speed=case["balancing_speed_rpm"] / 60, ring_positions=rings)
    return per, sheet_of(inputs, table, per)


@pytest.mark.parametrize("name, row", RULED, ids=lambda x: x if isinstance(x, str) else x["quantity"])
def test_given_sheets(name, row):
    per, found = of_case(name)
    id, _, unit = row["quantity"].partition(" [")
    if "residual" in id or "…" in id:
        part = id.removeprefix("countershaft.residual_unbalance_permitted").removeprefix("…")
        value = getattr(per, f"residual_unbalance_permitted{part}")
    else:
        known = {v.id: v.inside for v in published(found, "countershaft.balancing")}
        value = known[id]
    shown = value / SHOWN[unit.partition("]")[0] or "g mm"]
    assert shown == pytest.approx(row["is"], rel=row["rel"], abs=row.get("abs", 0.0))


def test_a_given_total_reading_still_has_the_target():
    """Of a backward shaft, whose angles count against the crank."""
    rows = {row["quantity"]: row for row in GIVEN if "total" in row["quantity"] or "shop_angle" in row["quantity"]}
    table = Balancing(zero="210", readings=(reading("1", (23400.0, 1.5), (23050.0, 180.6), "total"),))
    found = sheet_of(shaft(), table)
    for plane, name in zip(found.planes, ("front", "rear")):
        row = rows[f"countershaft.balancing.{name}.shop_angle [deg]"]
        assert math.degrees(plane.shop_angle) == pytest.approx(row["is"], rel=row["rel"], abs=row["abs"])
    for excess, name in zip(found.reading["1"].before, ("front", "rear")):
        row = rows[f"excess of the total reading, {name} [g mm]"]
        assert abs(excess) * 1e6 == pytest.approx(row["is"], rel=row["rel"])


def test_a_given_reading_and_its_holes():
    rows = [row for row in GIVEN if row["case"] == "gamma-0117" or "excess_gmm_deg" in row["case"]]
    case, is_ = rows[0]["case"], {row["quantity"].split(" [")[0]: row for row in rows}
    excess = np.array([U * cmath.exp(1j * math.radians(at)) for U, at in case["excess_gmm_deg"]])
    z_f, z_r = case["planes_mm"]
    ways = [(o["z_mm"], cmath.exp(1j * math.radians(o["angle_deg"]))) for o in case["holes"]]
    takes = np.array(
        [[(z_r - z) / (z_r - z_f) * way for z, way in ways], [(z - z_f) / (z_r - z_f) * way for z, way in ways]]
    )
    most = np.array([o["most_gmm"] for o in case["holes"]])
    u = amounts(excess, takes, np.array(case["permitted_gmm"]), most)
    left = abs(excess - takes @ u)
    for name, found in zip(("drill hole 1", "drill hole 2", "left front", "left rear"), (*u, *left)):
        assert found == pytest.approx(is_[name]["is"], rel=is_[name]["rel"])
    assert (left <= case["permitted_gmm"]).all()  # its verdict: pass


# --- physics

ANGLES, SIZES = st.floats(-360.0, 360.0), st.floats(0.1, 50.0)
SHAFTS = st.lists(st.tuples(st.floats(0.1, 5.0), SIZES, ANGLES, st.floats(-90.0, 90.0)), min_size=1, max_size=4)


@given(SHAFTS, st.floats(-250.0, -20.0), st.floats(20.0, 250.0))
def test_rings_and_shaft_together_have_no_unbalance(rows, z_1, z_2):
    table = Balancing(ring_positions=(z_1 * 1e-3, z_2 * 1e-3))
    found = sheet_of(shaft(rows, (-100.0, 100.0)), table)
    U = sum(m * e * 1e-3 * cmath.exp(1j * math.radians(at)) for m, e, at, _ in rows)
    M = sum(m * e * 1e-3 * z * 1e-3 * cmath.exp(1j * math.radians(at)) for m, e, at, z in rows)
    size = sum(m * e * 1e-3 for m, e, _, _ in rows)
    assert abs(U + sum(ring.vector for ring in found.rings)) < 1e-9 * size
    assert abs(M + sum(ring.vector * ring.z for ring in found.rings)) < 1e-9 * size


@given(SHAFTS, st.floats(0.0, 360.0), st.sampled_from(("with", "against")))
def test_a_shaft_and_its_mirror_image_have_the_same_shop_angles(rows, zero, count):
    """The mirror image turns the other way: what the shop counts with its rotation is the same."""
    one = sheet_of(shaft(rows, ratio=2), Balancing(zero=f"{zero!r}", count=count))
    other = [(m, e, -at, z) for m, e, at, z in rows]
    image = sheet_of(shaft(other, ratio=-2), Balancing(zero=f"{-zero!r}", count=count))
    for a, b in zip(one.planes, image.planes):
        assert (a.shop_angle is None) is (b.shop_angle is None)
        if a.shop_angle is not None:
            assert abs(math.remainder(a.shop_angle - b.shop_angle, 2 * math.pi)) < 1e-9


@pytest.mark.parametrize("ratio", [-1, 1])
def test_against_counts_the_other_way(ratio):
    with_, against = (sheet_of(shaft(ratio=ratio), Balancing(zero="mass front", count=c)) for c in ("with", "against"))
    assert with_.front.shop_angle == against.front.shop_angle == 0.0
    turned = sheet_of(shaft(ratio=ratio), Balancing(zero="200"))
    assert math.degrees(turned.front.shop_angle) == pytest.approx(350.0 if ratio < 0 else 10.0)
    back = sheet_of(shaft(ratio=ratio), Balancing(zero="200", count="against"))
    assert math.degrees(back.front.shop_angle) == pytest.approx(10.0 if ratio < 0 else 350.0)


@given(st.floats(-720.0, 720.0), st.sampled_from((-1, 1)), st.sampled_from(("with", "against")))
def test_what_the_machine_reads_of_the_target_is_no_excess(zero, ratio, count):
    """A total reading of the target itself, in the shop's angles, whatever these count from."""
    table = Balancing(zero=f"{zero!r}", count=count)
    bare = sheet_of(shaft(ratio=ratio), table)
    read = [(plane.target * 1e6, math.degrees(plane.shop_angle)) for plane in bare.planes]
    found = sheet_of(shaft(ratio=ratio), replace(table, readings=(reading("1", *read, "total"),)))
    assert all(abs(excess) < 1e-9 * bare.front.target for excess in found.reading["1"].before)


def test_target_and_tolerance_turn_with_the_shaft():
    """Turned by 40° as a whole, with the shop's zero on a mass, nothing of the sheet changes."""
    rows = [(m, e, at + 40.0, z) for m, e, at, z in GAMMA]
    table = Balancing(zero="mass rear", readings=(reading("1", (300.0, 20.0), (200.0, 170.0)),))
    drilled = [replace(table, holes=(hole("a", -110.0, 210.0 + t), hole("b", 45.0, 30.0 + t))) for t in (0.0, 40.0)]
    one, other = sheet_of(shaft(), drilled[0]), sheet_of(shaft(rows), drilled[1])
    assert one.front.shop_angle == pytest.approx(other.front.shop_angle)
    assert one.reading["1"].front == pytest.approx(other.reading["1"].front)
    assert one.reading["1"].amounts == pytest.approx(other.reading["1"].amounts)


def test_three_bearings_have_the_outer_two_as_planes():
    three = sheet_of(shaft(bearings=(-167.5, 10.0, 167.5)))
    two = sheet_of(shaft())
    assert [p.vector for p in three.planes] == [p.vector for p in two.planes] and three.rear.z == 0.1675


@pytest.mark.parametrize("ratio, count", [(-1, "with"), (1, "with"), (-1, "against")])
def test_rings_are_said_in_both_angles(ratio, count):
    """At the bearings a ring stands across from its target, in the engine and as the shop counts."""
    found = sheet_of(shaft(ratio=ratio), Balancing(zero="200", count=count))
    for plane, ring in zip(found.planes, found.rings):
        for one, other in ((plane.target_angle, ring.angle), (plane.shop_angle, ring.shop_angle)):
            assert abs(math.remainder(one - other, 2 * math.pi)) == pytest.approx(math.pi)
    labels = {v.id: str(v.label) for v in published(found, "s")}
    for part in ("front", "ring_rear"):
        engine = labels[f"s.{part}.target_angle" if part == "front" else f"s.{part}.angle"]
        assert "in the engine, cylinder 1 at TDC" in engine and "as the shop counts" in labels[f"s.{part}.shop_angle"]


def test_extras_are_in_the_target():
    bare = sheet_of(shaft())
    more = sheet_of(shaft(extras=((-0.01, 20.0, 0.0, 0.0),)))
    assert [b.vector - a.vector for a, b in zip(bare.planes, more.planes)] == pytest.approx([-1e-4, -1e-4])


def test_a_symmetric_target_has_no_direction_where_it_is_nothing():
    found = sheet_of(shaft([(1.0, 10.0, 0.0, -50.0), (1.0, 10.0, 180.0, -50.0)]))
    assert found.front.target == 0.0 and found.front.target_angle is None and found.front.shop_angle is None


# --- readings


def read_of(front, rear, per=None, **table):
    holes = table.pop("holes", (hole("a", -110.0, 210.0), hole("b", 45.0, 30.0)))
    given = Balancing(zero="0", count="against", holes=holes, readings=(reading("1", front, rear),), **table)
    return sheet_of(shaft(), given, per).reading["1"]


def test_holes_take_what_the_drill_takes():
    """The depths that a reading asks for, drilled again."""
    found = read_of((520.0, 214.0), (260.0, 22.0))
    assert found.hole["a"].number * 1e3 == pytest.approx(20.0)  # at its most
    inside = found.hole["b"].number
    assert 0.01 < inside < 0.02
    deeper = read_of(
        (520.0, 214.0), (260.0, 22.0), holes=(hole("a", -110.0, 210.0), hole("b", 45.0, 30.0, depth=inside * 1e3))
    )
    assert deeper.amounts["b"] == pytest.approx(found.amounts["b"], rel=1e-9)


def test_across_the_masses_nothing_can_be_drilled_but_by_a_hole_there():
    """What is left for want of a direction is told apart from what is left for want of depth."""
    across = read_of((300.0, 120.0), (0.0, 0.0))
    assert across.amounts == {"a": 0.0, "b": 0.0} and abs(across.unreached[0]) * 1e6 == pytest.approx(300.0)
    more = (hole("a", -110.0, 210.0), hole("b", 45.0, 30.0), hole("c", -110.0, 120.0), hole("d", 45.0, 300.0))
    helped = read_of((300.0, 120.0), (0.0, 0.0), holes=more)
    assert helped.front < 0.4 * across.front and helped.amounts["c"] > 0
    deep = read_of((3000.0, 210.0), (0.0, 0.0))
    assert abs(deep.unreached[0]) < 0.2 * deep.front


def test_unlike_planes_count_by_what_they_permit():
    """The plane that permits less is left with less."""
    per = tolerance(shaft())
    tight = SimpleNamespace(residual_unbalance_permitted_front=10e-6, residual_unbalance_permitted_rear=1000e-6)
    one, other = (read_of((300.0, 210.0), (300.0, 30.0), p, holes=(hole("a", -40.0, 210.0),)) for p in (per, tight))
    assert other.front < one.front and other.rear > one.rear


@pytest.mark.parametrize("left, told", [(0.9, "pass"), (0.96, "between"), (1.04, "between"), (1.06, "fail")])
def test_between_the_machine_can_not_tell(left, told):
    """ΔU of 5.5 % of what the front plane permits, as machine and ring together have it; a smaller one is none."""
    per = tolerance(shaft()).residual_unbalance_permitted_front
    both = dict(measurement_error=(0.055 * 0.6 * per,), ring_tolerance=(0.055 * 0.8 * per, 0.0))
    U = left * per * 1e6
    assert read_of((U, 120.0), (0.0, 0.0), holes=(), **both).told == (told, "pass")
    assert read_of((U, 120.0), (0.0, 0.0), holes=()).told[0] == ("pass" if left <= 1 else "fail")


@given(st.lists(st.floats(1.0, 900.0), min_size=3, max_size=6), st.floats(100.0, 3000.0))
def test_the_load_is_shared_where_depths_are_not_unique(most, wanted):
    """Holes side by side at one angle: each takes in the measure of the square of its most, up to that."""
    takes = np.array([[0.75] * len(most), [0.25] * len(most)], dtype=complex)
    u = amounts(np.array([0.75 * wanted, 0.25 * wanted], dtype=complex), takes, np.array([1.0, 1.0]), np.array(most))
    assert np.sum(u) == pytest.approx(min(wanted, sum(most)), rel=1e-6)
    free = u < np.array(most) * (1 - 1e-6)
    share = u / np.array(most) ** 2
    assert np.ptp(share[free]) < 1e-5 * max(share) if free.any() else True
