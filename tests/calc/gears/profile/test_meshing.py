"""Two outlines in mesh: where they enter each other, how deep; and the gap that the allowances leave between them."""

import dataclasses
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.gears.curves import pitch_point_view
from calc.gears.profile.meshing import (
    FILLET,
    FLANK,
    _depth,
    _distances,
    _seen,
    checks,
    flank,
    notes,
    penetration,
    penetration_check,
    penetrations,
)
from calc.gears.profile.outline import CHORD_ERROR, regions, shifts
from calc.sheet.errors import NoSolution
from tests.calc.gears.trains import mesh, pair_1, r753, solved, train, wheel


def pair(z_1, x_1, z_2, x_2, tool, beta=0.0, **said):
    return solved(train([wheel("a", z_1, x_1), wheel("b", z_2, x_2)], [mesh("a", "b")], beta=beta, tool=tool, **said))


def depth(t):
    (found,) = penetrations(t).values()
    return found


JAMS = [
    (20, 0.0, 20, 0.0, (1.05, 0.38), 0.0),
    (20, 0.0, 60, 0.3, (1.1, 0.38), 0.0),
    (20, 0.0, 30, 0.0, (0.95, 0.3), 0.0),
    (25, 0.1, 36, 0.0, (1.12, 0.4), 20.0),
]


@pytest.mark.parametrize("make", [r753, pair_1])
def test_the_wheels_of_the_source_roll_without_entering_each_other(make):
    t = solved(make())
    found = penetrations(t)
    assert set(found) == set(t.meshes) and set(found.values()) == {0.0}
    assert [(c.id, c.verdict) for c in checks(t, found)] == [(f"gears.{key}.penetration", "pass") for key in found]


# --- against whole polygons
def inside(points, polygon):
    """By the turns that a polygon makes about each point."""
    seen = polygon - points[:, None]
    return np.abs(np.angle(np.roll(seen, -1, axis=1) / seen).sum(axis=1)) > np.pi


def distance(points, line):
    start, way = line[:-1], np.diff(line)
    gap = points[:, None] - start
    along = np.clip((gap * way.conj()).real / np.maximum(np.abs(way) ** 2, 1e-300), 0, 1)
    return np.abs(gap - along * way).min(axis=1)


def deepest(t, positions=41, turn=0.0):
    """Of the corners of either polygon inside the other, over one pitch; `turn`: of the driven one about its axis."""
    (m,) = t.meshes.values()
    driver, driven, found = t.wheels["a"], t.wheels["b"], 0.0
    for roll in np.linspace(-0.5, 0.5, positions) * 2 * np.pi / driver.teeth:
        below, above = pitch_point_view(m, *((w, regions(t.system, w, 4e-7)) for w in (driver, driven)), roll)
        axis = 1j * m.working_diameter_driven / 2
        above = axis + (above - axis) * np.exp(1j * turn)
        far = 2 * t.system.m_n
        for points, line, away in ((above, below, -1j), (below, above, 1j)):
            near = points[np.abs(points.imag) < far]
            middle = away * (m.working_diameter_driver if away == -1j else m.working_diameter_driven) / 2
            within = near[inside(near, np.append(line, middle))]
            if within.size:
                found = max(found, distance(within, line).max())
    return found


@pytest.mark.parametrize("case", JAMS)
def test_the_depth_is_that_of_the_whole_polygons(case):
    """The polygons are looked at in fewer positions, so they can only be a little less deep."""
    t = pair(*case)
    assert depth(t) > 10 * CHORD_ERROR
    assert deepest(t) == pytest.approx(depth(t), rel=0.01, abs=6e-7)


def test_with_backlash_one_flank_is_in_contact():
    """Half of it further to one side, as whole polygons see it; and the train's own, of axes that are too far apart."""
    t = pair(*JAMS[1])
    (m,) = t.meshes.values()
    both, j = [flank(t.system, t.wheels[name]) for name in ("a", "b")], 5e-5
    turned = max(deepest(t, 21, side * j / m.working_diameter_driven) for side in (1, -1))
    assert turned == pytest.approx(penetration(m.centre_distance, *both, j), rel=0.01)
    apart = solved(
        train([wheel("a", 20, 0.0), wheel("b", 20, 0.0)], [mesh("a", "b", 40.02)], beta=0.0, tool=JAMS[0][4])
    )
    both, a_w = [flank(apart.system, apart.wheels[name]) for name in ("a", "b")], apart.meshes["a_b"].centre_distance
    alpha, alpha_w = math.radians(20), math.acos(40 / 40.02 * math.cos(math.radians(20)))
    loose = 2 * a_w * (math.tan(alpha_w) - alpha_w - math.tan(alpha) + alpha)
    assert depth(apart) == pytest.approx(penetration(a_w, *both, loose))
    assert depth(apart) > 1.1 * penetration(a_w, *both)


RECORDED = [
    (2.3395050372435717e-05, 5.725370849082487e-05),
    (1.6057824909402968e-05, 5.452325294484933e-05),
    (1.4543446705094594e-04, 1.662003511547845e-04),
    (1.3290205035477091e-05, 5.310180679503053e-05),
]


@pytest.mark.parametrize("case, depths", [*zip(JAMS, RECORDED)])
def test_recorded_depths(case, depths):
    """Recorded: without backlash and with 0.1 mm of it."""
    t = pair(*case)
    (m,) = t.meshes.values()
    both = [flank(t.system, t.wheels[name]) for name in ("a", "b")]
    for order in (1, -1):
        found = [penetration(m.centre_distance, *both[::order], j) for j in (0.0, 1e-4)]
        assert found == pytest.approx(depths, rel=1e-8)


def test_a_loop_between_two_positions_is_found():
    """Recorded: where the corner stands the tips are clear of the fillets, between two of these places by 8 nm not."""
    wheels = [wheel(name, 20, 0.0, cut=0.0606) for name in ("a", "b")]
    t = solved(train(wheels, [mesh("a", "b")], beta=0.0, tool=(1.05, 0.38)))
    assert depth(t) == pytest.approx(7.96332e-9, rel=1e-5)


@pytest.mark.parametrize(
    "outward, shares, digits",
    [
        (0.95, (0.5, 0.9), 1e-5),
        (0.5, (0.95, 0.999), 1e-5),
        (0.15, (0.95, 0.99), 1e-9),
        (-0.001, (0.9, 1.03), 1e-9),
        (-0.05, (0.9, 1.03), 1e-9),
    ],
)
def test_the_way_out_of_a_tooth_is_the_shortest(outward, shares, digits):
    """Of points that stand so far from the root (0) to the tip (1), at such shares of half the tooth there: to the
    outline, drawn in small steps."""
    t = pair(*JAMS[0])
    side = flank(t.system, t.wheels["a"])
    r, theta = side.fillet
    rising = np.linspace(r[-1], side.tip_radius, 4001)
    root, tip = (
        R * np.exp(1j * np.linspace(*ends, 4001))
        for R, ends in ((r[0], (math.pi / 20, theta[0])), (side.tip_radius, (side.tooth_angle(rising[-1:])[0], 0.0)))
    )
    outline = np.concatenate([root, r * np.exp(1j * theta), rising * np.exp(1j * side.cut.involute(rising)), tip])
    radius = np.array([r[0] + outward * (side.tip_radius - r[0])])
    for share in np.linspace(*shares, 14):
        angle = side.tooth_angle(radius) * share
        found = _depth(side, radius, angle, (side.tooth_angle(radius) - angle) * radius)
        assert found == pytest.approx(distance(radius * np.exp(1j * angle), outline)[0], rel=digits)


def test_the_distance_from_a_polyline():
    """Across a piece, to a corner, and to either end."""
    line, points = np.array([0j, 3 + 0j, 3 + 4j]), np.array([1 - 2j, 4 - 1j, -3 - 4j, 6 + 8j, 2.9 + 1j, 0.1 - 1j])
    assert _distances(points, line) == pytest.approx([2, math.sqrt(2), 5, 5, 0.1, 1])


def test_a_root_that_is_too_shallow_is_entered_by_at_least_its_negative_clearance():
    t = pair(20, 0.0, 60, 0.0, (0.95, 0.05))
    clearance = min(t.meshes["a_b"].tip_clearance_driver, t.meshes["a_b"].tip_clearance_driven)
    assert clearance == pytest.approx(-0.05 * t.system.m_n)
    assert depth(t) >= -clearance * (1 - 1e-6)
    assert penetration_check("a_b", t.meshes["a_b"], depth(t)).verdict == "fail"


def test_fillets_that_are_too_round_are_entered_though_the_formulas_pass():
    """z 20/20, tool 1.05 / 0.38: tips clear the roots, contact starts above the form circles, and a tip's corner works
    on the fillet."""
    t = pair(*JAMS[0])
    m = t.meshes["a_b"]
    assert m.tip_clearance_driver == pytest.approx(0.05 * t.system.m_n)
    assert m.line_of_action - t.wheels["b"].tip_curvature > t.wheels["a"].form_curvature
    assert depth(t) > 10 * CHORD_ERROR
    assert depth(pair(20, 0.0, 20, 0.0, (1.3, 0.2))) == 0.0


def test_a_point_is_carried_through_the_tip_circle_of_the_other_wheel():
    """From where it enters to where it leaves, over the line of centres; one that stays outside stands still there."""
    t = pair(*JAMS[1])
    a_w, every = t.meshes["a_b"].centre_distance, np.arange(FLANK)
    own, mate = (flank(t.system, t.wheels[name]) for name in ("a", "b"))
    for share in (-1.0, 1.0):
        assert _seen(a_w, own, mate, every, np.full(FLANK, share), 0.0)[0] == pytest.approx(own.tip_radius)
    assert _seen(a_w, own, mate, every, np.zeros(FLANK), 0.0)[0] == pytest.approx(a_w - mate.points[0])
    apart = a_w + 5e-3
    assert _seen(apart, own, mate, every, np.ones(FLANK), 0.0)[0] == pytest.approx(apart - mate.points[0])


def test_the_fillet_ends_where_the_involute_begins():
    t = pair(*JAMS[1])
    side = flank(t.system, t.wheels["a"])
    r, angle = side.fillet
    for n in (0, 60, FILLET - 2):
        assert side.tooth_angle(np.array([(r[n] + r[n + 1]) / 2])) == pytest.approx((angle[n] + angle[n + 1]) / 2)
    assert side.tooth_angle(r[-1:] * 1.01) == pytest.approx(side.cut.involute(r[-1:] * 1.01))


def test_what_is_cut_off_the_tips_ends_the_interference():
    cuts = [
        depth(
            solved(
                train(
                    [wheel("a", 20, 0.0, cut=c), wheel("b", 20, 0.0, cut=c)],
                    [mesh("a", "b")],
                    beta=0.0,
                    tool=(1.05, 0.38),
                )
            )
        )
        for c in (0.0, 0.02, 0.05, 0.4)
    ]
    assert cuts == sorted(cuts, reverse=True) and cuts[0] > cuts[1] > 0 and cuts[-1] == 0.0


@settings(deadline=None, max_examples=60)
@given(
    z_1=st.integers(8, 60),
    z_2=st.integers(8, 90),
    x_1=st.floats(-0.4, 0.7),
    x_2=st.floats(-0.4, 0.7),
    beta=st.floats(0, 30),
    addendum=st.floats(1.0, 1.45),
    rho=st.floats(0.0, 0.4),
    q=st.floats(0.0, 0.08),
    more=st.floats(0.0, 0.05),
)
def test_wheels_that_fit_the_rack_of_the_tool_do_not_enter_each_other(z_1, z_2, x_1, x_2, beta, addendum, rho, q, more):
    """Where contact starts above the fillets and the tool's straight flank reaches 0.1 m_n deeper than the mate's
    tip."""
    gears = train([wheel("a", z_1, x_1), wheel("b", z_2, x_2)], [mesh("a", "b")], beta=beta, tool=(addendum, rho))
    try:
        t = solved(dataclasses.replace(gears, stock=q * 1e-3, protuberance=(q + more) * 1e-3))
    except NoSolution:
        return
    m, a, b, s = t.meshes["a_b"], t.wheels["a"], t.wheels["b"], t.system
    fits = s.h_fP - s.rho_aP0 * (1 - math.sin(s.alpha_n)) > 1.1 + m.standard_tip_shortening / s.m_n
    for own, mate in ((a, b), (b, a)):
        fits = fits and m.line_of_action - mate.tip_curvature > own.form_curvature and mate.tip_thickness > 0
    if fits:
        assert depth(t) < 1e-8
    else:
        assert depth(t) >= 0.0


def test_the_order_of_the_wheels_and_the_module_do_not_matter():
    t = pair(20, 0.0, 60, 0.3, (1.1, 0.38))
    back, twice = pair(60, 0.3, 20, 0.0, (1.1, 0.38)), pair(20, 0.0, 60, 0.3, (1.1, 0.38), m_n=4.0)
    assert depth(back) == pytest.approx(depth(t), rel=1e-9)
    assert depth(twice) == pytest.approx(2 * depth(t), rel=1e-9)


def test_a_step_that_finishing_leaves_is_entered_though_contact_starts_above_it():
    """Stock without protuberance: the form circles and the roots are clear of the mate's tip, the thick fillet between
    them is not."""
    gears = train([wheel("a", 15, 0.0), wheel("b", 15, 0.0)], [mesh("a", "b")], beta=0.0, tool=(1.25, 0.1))
    stepped, covered = (solved(dataclasses.replace(gears, stock=6e-5, protuberance=pr)) for pr in (0.0, 6e-5))
    m, w = stepped.meshes["a_b"], stepped.wheels["a"]
    assert m.line_of_action - w.tip_curvature > w.form_curvature and m.tip_clearance_driver > 0
    assert CHORD_ERROR < depth(stepped) < 6e-5
    assert depth(covered) == 0.0
    verdicts = [{c.id: c.verdict for c in checks(t, penetrations(t))} for t in (stepped, covered)]
    assert [found["gears.train.finishing_step"] for found in verdicts] == ["warn", "pass"]
    assert [found["gears.a_b.penetration"] for found in verdicts] == ["fail", "pass"]


@pytest.mark.parametrize("share, verdict", [(0.999, "pass"), (1.001, "fail")])
def test_the_outlines_are_exact_to_a_micrometre(share, verdict):
    check = penetration_check("central_idler", solved(r753()).meshes["central_idler"], share * 1e-6)
    assert check.verdict in (verdict, "warn") and check.holds is (verdict == "pass")
    assert "no deeper than the outlines are exact" in check.source


@pytest.mark.parametrize(
    "stock, protuberance, verdict, scale",
    [
        (60e-6, 60e-6, "pass", 60.0),
        (60e-6, 60.1e-6, "pass", 60.1),
        (60e-6, 59.9e-6, "warn", 60.0),
        (5e-6, 4e-6, "warn", 10.0),
        (5e-6, 20e-6, "pass", 20.0),
    ],
)
def test_a_step_is_a_share_of_the_larger_of_stock_and_protuberance(stock, protuberance, verdict, scale):
    gears = train([wheel("a", 25, 0.1), wheel("b", 36, 0.0)], [mesh("a", "b")], beta=0.0, tool=(1.4, 0.3))
    t = solved(dataclasses.replace(gears, stock=stock, protuberance=protuberance))
    (check,) = [c for c in checks(t, penetrations(t)) if c.id == "gears.train.finishing_step"]
    assert (check.verdict, check.kind) == (verdict, "caution") and "at least as large as the stock" in check.source
    assert check.value == pytest.approx(max(stock - protuberance, 0.0) * 1e6)
    assert check.scale == pytest.approx(scale)
    covering = [(("gears.protuberance_mm", pytest.approx(stock * 1e3)),)] if verdict == "warn" else []
    assert [way.changes for way in check.remedies] == covering
    assert all("at least" in way.words for way in check.remedies)


def test_what_the_protuberance_must_be_like_is_said_of_each_wheel():
    gears = train([wheel("a", 25, 0.1), wheel("b", 36, 0.0)], [mesh("a", "b")], beta=0.0, tool=(1.4, 0.3))
    said = notes(solved(dataclasses.replace(gears, stock=5e-5, protuberance=7e-5)))
    assert len(said) == 2 and said[0].startswith("Wheel a: the fillet is as computed if")
    assert notes(solved(gears)) == ()


@pytest.mark.parametrize("x", [1.1, 1.2])
def test_a_pointed_tooth_ends_where_its_flanks_meet(x):
    t = pair(12, x, 40, 0.0, (1.25, 0.2))
    w = t.wheels["a"]
    assert w.tip_thickness < 0
    for shift in (None, w.profile_shift):
        found = flank(t.system, w, shift)
        assert found.tip_radius * 2 == pytest.approx(w.pointed_diameter, rel=1e-14)
        assert float(found.cut.involute(found.tip_radius)) == pytest.approx(0.0, abs=1e-14)
    thin = flank(t.system, w, w.profile_shift - 0.01)
    assert thin.tip_radius < found.tip_radius and float(thin.cut.involute(thin.tip_radius)) == pytest.approx(
        0.0, abs=1e-14
    )


# --- backlash
def flank_gap(a_w, own, mate):
    """Smallest distance of the mate's flank from the involute of the wheel, in the transverse plane; negative: inside
    it.

    Both wheels stand in the middle of their backlash.  Each point of the mate is looked at in many turns, the best of
    them again."""
    base = mate.cut.base_radius
    form = max(float(mate.fillet[0][-1]), base)
    radius = np.hypot(base, np.linspace(math.sqrt(form**2 - base**2), math.sqrt(mate.tip_radius**2 - base**2), 101))
    points, pitch = radius * np.exp(1j * mate.cut.involute(radius)), 2 * np.pi / own.cut.teeth
    turns, best = np.linspace(-3, 3, 1501) * 2 * np.pi / mate.cut.teeth, np.inf
    for _ in range(3):
        # the mate's tooth towards the wheel, turned on from the line of centres
        seen = a_w - points * np.exp(-1j * turns[:, None])
        tooth = pitch / 2 + turns[:, None] * mate.cut.teeth / own.cut.teeth
        off = np.abs((np.angle(seen) - tooth + pitch / 2) % pitch - pitch / 2)
        there = (np.abs(seen) < own.tip_radius) & (np.abs(seen) >= own.fillet[0][-1])
        gap = np.where(there, off - own.cut.involute(np.maximum(np.abs(seen), own.cut.base_radius)), np.inf).min(axis=1)
        best = min(best, float(gap.min()))
        step, at = turns[1] - turns[0], turns[int(np.argmin(gap))]
        turns = np.linspace(at - step, at + step, 301)
    return best * own.cut.base_radius


@pytest.mark.parametrize("key", ["crank_central", "central_idler", "idler_shaft"])
def test_allowances_leave_half_the_backlash_on_each_side(key):
    """Both wheels in the middle of their play: j_bn/2 normal to the flanks, j_bn that of the middle of the
    allowances."""
    t = solved(r753())
    m = t.meshes[key]
    thin = []
    for name in (m.driver, m.driven):
        cut = shifts(t.system, t.wheels[name])
        thin.append(flank(t.system, t.wheels[name], (cut["min"] + cut["max"]) / 2))
    normal = math.cos(t.system.base_helix_angle)
    assert 2 * normal * flank_gap(m.centre_distance, *thin) == pytest.approx(m.backlash_nominal, abs=1e-10)
    assert 2 * normal * flank_gap(m.centre_distance, *thin[::-1]) == pytest.approx(m.backlash_nominal, abs=1e-10)
    assert penetration(m.centre_distance, *thin) == 0.0


def test_without_allowance_the_flanks_touch():
    t = solved(r753())
    for m in t.meshes.values():
        both = [flank(t.system, t.wheels[name]) for name in (m.driver, m.driven)]
        assert flank_gap(m.centre_distance, *both) == pytest.approx(0.0, abs=1e-10)


def test_a_centre_distance_that_is_too_small_is_found_too():
    """Closer by Δa the flanks enter each other by Δa·sin α_wt on each side, measured along the line of action."""
    t = solved(r753())
    m = t.meshes["central_idler"]
    both = [flank(t.system, t.wheels[name]) for name in (m.driver, m.driven)]
    closer = 1e-5
    depth = penetration(m.centre_distance - closer, *both)
    assert depth == pytest.approx(closer * math.sin(m.working_pressure_angle), rel=0.03)
    assert depth == pytest.approx(3.564895679204e-6, rel=1e-8)  # recorded
