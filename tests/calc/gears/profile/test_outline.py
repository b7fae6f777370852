"""The outline of a tooth: it is what the tool leaves, it is smooth, and two of them roll without touching twice."""

import math

import numpy as np
import pytest

from calc.gears.curves import pitch_point_view
from calc.gears.profile.cut import Cut
from calc.gears.profile.outline import regions, repeated, shifts, tooth
from tests.calc.gears.trains import mesh, r753, solved, train, wheel

TOOTH = [
    (36, 0.014, 21.916, (1.41, 0.2)),
    (25, 0.0142, 21.916, (1.41, 0.2)),
    (20, 0.0, 0.0, (1.25, 0.38)),
    (80, -0.4, 10.0, (1.25, 0.0)),
]
UNDERCUT = [
    (10, 0.0, 0.0, (1.25, 0.38)),
    (8, -0.3, 15.0, (1.25, 0.2)),
    (12, 0.0, 0.0, (1.25, 0.0)),
    (16, -0.02, 0.0, (1.25, 0.3)),
]


def cut_wheel(z, x, beta, tool):
    t = solved(train([wheel("a", z, x), wheel("b", 60, 0.5)], [mesh("a", "b")], m_n=1.0, beta=beta, tool=tool))
    return t.system, t.wheels["a"]


def derivative(function, at, h=1e-3):
    return (8 * (function(at + h) - function(at - h)) - (function(at + 2 * h) - function(at - 2 * h))) / (12 * h)


@pytest.mark.parametrize("case", TOOTH)
def test_fillet_meets_the_involute_with_a_common_tangent(case):
    system, w = cut_wheel(*case)
    cut = Cut(system, w.teeth, w.profile_shift)
    radius, angle = (float(a[0]) for a in cut.fillet(np.array([-system.alpha_n])))
    assert 2 * radius == pytest.approx(w.form_diameter, rel=1e-13)
    assert angle == pytest.approx(float(cut.involute(radius)), abs=1e-13)
    dr, dtheta = (
        derivative(lambda phi, i=i: float(cut.fillet(np.array([phi]))[i][0]), -system.alpha_n) for i in (0, 1)
    )
    tangent = math.atan2(radius * dtheta, dr)
    assert tangent == pytest.approx(-math.acos(w.base_diameter / 2 / radius), abs=1e-9)


@pytest.mark.parametrize("case", TOOTH + UNDERCUT)
def test_radius_rises_from_root_to_tip(case):
    system, w = cut_wheel(*case)
    flank = regions(system, w)
    assert flank.fillet[0][0] * 2 == pytest.approx(w.root_diameter, rel=1e-13)
    assert flank.involute[0][-1] * 2 == pytest.approx(w.tip_diameter, rel=1e-13)
    radius = np.concatenate([flank.fillet[0], flank.involute[0][1:]])
    assert np.all(np.diff(radius) >= (0 if system.rho_aP0 else -1e-15))
    for (r_1, a_1), (r_2, a_2) in (
        (flank.root, flank.fillet),
        (flank.fillet, flank.involute),
        (flank.involute, flank.tip),
    ):
        assert (r_1[-1], a_1[-1]) == pytest.approx((r_2[0], a_2[0]), abs=1e-12)


@pytest.mark.parametrize("case", UNDERCUT)
def test_undercut_ends_where_the_trochoid_crosses_the_involute(case):
    system, w = cut_wheel(*case)
    assert w.profile_shift < w.undercut_limit
    assert w.base_diameter < w.form_diameter < w.tip_diameter
    cut = Cut(system, w.teeth, w.profile_shift)
    phi = np.linspace(-np.pi / 2, cut.end_of_fillet, 400)
    radius, angle = cut.fillet(phi)
    assert angle[-1] == pytest.approx(float(cut.involute(radius[-1])), abs=1e-12)
    below = (radius > w.base_diameter / 2) & (radius < w.form_diameter / 2)
    assert np.all(angle[below] <= cut.involute(radius[below]) + 1e-12)


def test_form_diameter_is_continuous_where_undercut_begins():
    limit = cut_wheel(14, 0.4, 0.0, (1.25, 0.3))[1].undercut_limit
    above, below = (cut_wheel(14, limit + e, 0.0, (1.25, 0.3))[1].form_diameter for e in (1e-9, -1e-9))
    assert above == pytest.approx(below, rel=1e-6)


def test_critical_section_of_iso_6336_on_the_real_fillet():
    """z 20, tool 1.25 / 0.38: where the tangent stands at 30° the chord is 1.94475 and the radius 0.57295 modules
    (public test)."""
    system, _ = cut_wheel(20, 0.0, 0.0, (1.25, 0.38))
    cut = Cut(system, 20, 0.0)

    def point(phi):
        radius, angle = (float(a[0]) for a in cut.fillet(np.array([phi])))
        return radius * np.exp(1j * angle)  # the tooth points along the real axis

    def slope(phi):
        return float(np.angle(derivative(point, phi, 1e-4)))

    low, high = -1.5, -0.4
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if slope(middle) < math.radians(-30) else (low, middle)
    assert 2 * abs(point(low).imag) / system.m_n == pytest.approx(1.94475, abs=5e-6)
    radius = abs(derivative(point, low, 1e-4)) / abs(derivative(slope, low, 1e-4))
    assert radius / system.m_n == pytest.approx(0.57295, abs=5e-6)


def test_outline_is_closed_and_repeats():
    system, w = cut_wheel(*TOOTH[0])
    whole, one = repeated(tooth(system, w), w.teeth), tooth(system, w)
    assert abs(whole[0] - whole[-1]) < 1e-15
    assert whole.size == w.teeth * (one.size - 1) + 1
    assert np.allclose(whole[one.size - 1 : 2 * one.size - 1], one * np.exp(2j * np.pi / w.teeth))
    steps = np.diff(np.unwrap(np.angle(whole)))
    assert steps.sum() == pytest.approx(2 * np.pi)


def test_pointed_tooth_ends_where_its_flanks_meet():
    t = solved(train([wheel("a", 12, 1.2), wheel("b", 40, 0.0)], [mesh("a", "b")], beta=0.0, tool=(1.25, 0.2)))
    assert t.wheels["a"].tip_thickness < 0
    flank = regions(t.system, t.wheels["a"])
    assert flank.involute[1][-1] == 0
    assert flank.involute[0][-1] * 2 == pytest.approx(t.wheels["a"].pointed_diameter, rel=1e-14)
    assert flank.involute[0][-1] < t.wheels["a"].tip_diameter / 2
    assert np.isfinite(tooth(t.system, t.wheels["a"])).all()


@pytest.mark.parametrize("pair", ["crank_central", "central_idler", "idler_shaft"])
@pytest.mark.parametrize("turn", [-0.6, -0.35, -0.1, 0.0, 0.2, 0.45, 0.7])
def test_teeth_touch_and_never_enter_each_other(pair, turn):
    """Without backlash, at any roll: no point of the driven teeth lies inside a tooth of the driver; some lie on it."""
    t = solved(r753())
    mesh_ = t.meshes[pair]
    driver, driven = t.wheels[mesh_.driver], t.wheels[mesh_.driven]
    roll = turn * 2 * np.pi / driver.teeth
    _, above = pitch_point_view(mesh_, *((w, regions(t.system, w)) for w in (driver, driven)), roll)
    seen = (above + 1j * mesh_.working_diameter_driver / 2) * -1j * np.exp(-1j * roll)  # from the driver's middle
    pitch = 2 * np.pi / driver.teeth
    angle = np.abs((np.angle(seen) + pitch / 2) % pitch - pitch / 2)
    radius = np.abs(seen)
    flank = regions(t.system, driver, 1e-9)
    cut = Cut(t.system, driver.teeth, driver.profile_shift)
    tooth_angle = np.where(radius >= driver.form_diameter / 2, cut.involute(radius), np.interp(radius, *flank.fillet))
    inside = radius < driver.tip_diameter / 2
    gap = (angle - tooth_angle)[inside] * radius[inside]
    assert -1e-9 < gap.min() < 2e-5


# --- the polyline
def off(points, line):
    """Largest distance of points from a polyline."""
    start, way = line[:-1], np.diff(line)
    gap = points[:, None] - start
    along = np.clip((gap * way.conj()).real / np.maximum(np.abs(way) ** 2, 1e-300), 0, 1)
    return np.abs(gap - along * way).min(axis=1).max()


@pytest.mark.parametrize("error", [1e-8, 1e-6, 2e-5])
@pytest.mark.parametrize("case", TOOTH + UNDERCUT)
def test_the_polyline_stands_nowhere_further_off_than_the_chord_error(case, error):
    system, w = cut_wheel(*case)
    flank, cut = regions(system, w, error), Cut(system, w.teeth, w.profile_shift)
    fillet = cut.fillet(np.linspace(-np.pi / 2, cut.end_of_fillet, 3000))
    r = np.hypot(
        w.base_diameter / 2,
        np.linspace(
            *(
                math.sqrt(max((d / 2) ** 2 - (w.base_diameter / 2) ** 2, 0.0))
                for d in (w.form_diameter, w.tip_diameter)
            ),
            3000,
        ),
    )
    top = np.linspace(float(cut.involute(w.tip_diameter / 2)), 0, 500)
    ground = np.linspace(np.pi / w.teeth, fillet[1][0], 500)
    exact = {
        "fillet": fillet,
        "involute": (r, cut.involute(r)),
        "tip": (w.tip_diameter / 2, top),
        "root": (w.root_diameter / 2, ground),
    }
    for name, (radius, angle) in exact.items():
        drawn_r, drawn_a = getattr(flank, name)
        assert off(radius * np.exp(1j * angle), drawn_r * np.exp(1j * drawn_a)) <= error * 1.0001 + 1e-15, name


def test_a_coarser_polyline_has_fewer_points():
    system, w = cut_wheel(*TOOTH[0])
    sizes = [tooth(system, w, error).size for error in (1e-8, 1e-6, 1e-4)]
    assert sizes[0] > 5 * sizes[1] and sizes[1] > 2 * sizes[2] and sizes[1] < 200


# --- allowances
@pytest.mark.parametrize("name", ["central", "idler", "shaft"])
def test_the_outlines_at_both_ends_of_the_allowance_have_the_diameters_that_are_told(name):
    t = solved(r753())
    w, cut = t.wheels[name], shifts(t.system, t.wheels[name])
    assert set(cut) == {"", "min", "max"} and cut["min"] < cut["max"] < cut[""]
    for end in ("min", "max"):
        flank = regions(t.system, w, shift=cut[end])
        assert 2 * flank.fillet[0][0] == pytest.approx(getattr(w, f"root_diameter_{end}"), rel=1e-13)
        assert 2 * flank.involute[0][0] == pytest.approx(getattr(w, f"form_diameter_{end}"), rel=1e-13)
        assert 2 * flank.tip[0][0] == pytest.approx(w.tip_diameter, rel=1e-13)


@pytest.mark.parametrize("end, E_W", [("max", -20e-6), ("min", -30e-6)])
def test_the_thinned_outline_is_thinner_by_the_change_of_the_span(end, E_W):
    """Along the base tangent each flank stands back by half of the change of the span, ISO 21771: E_W in the normal
    section."""
    t = solved(r753())
    w = t.wheels["idler"]
    whole, thin = (Cut(t.system, w.teeth, x) for x in (w.profile_shift, shifts(t.system, w)[end]))
    back = (
        (whole.half_angle_at_base - thin.half_angle_at_base) * whole.base_radius * math.cos(t.system.base_helix_angle)
    )
    assert back == pytest.approx(-E_W / 2, rel=1e-12)
