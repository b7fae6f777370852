"""The section of a wheel by the curves that bound it: what they enclose, and the points that a spline is laid through."""

import math

import numpy as np
import pytest

from calc.gears.profile.cut import Cut
from calc.gears.profile.outline import repeated, shifts, tooth
from calc.gears.profile.section import section
from calc.gears.wheel import wheel_mass
from calc.sheet.record import replace
from tests.calc.gears.trains import mesh, solved, train, wheel

WHEELS = [
    (36, 0.014, 21.916, (1.41, 0.2)),
    (20, 0.0, 0.0, (1.25, 0.38)),
    (8, -0.3, 15.0, (1.25, 0.2)),  # undercut
    (12, 0.0, 0.0, (1.25, 0.0)),  # a sharp tool
    (80, -0.4, 10.0, (1.25, 0.0)),
    (9, 0.9, 0.0, (1.25, 0.3)),  # pointed
]


def cut_wheel(z, x, beta, tool, m_n=1.0, **more):
    t = solved(train([wheel("a", z, x, **more), wheel("b", 60, 0.5)], [mesh("a", "b")], m_n=m_n, beta=beta, tool=tool))
    return t.system, t.wheels["a"]


def enclosed(line):
    """Area and polar moment within a closed polyline."""
    a, b = line[:-1], line[1:]
    cross = a.real * b.imag - b.real * a.imag
    square = abs(a) ** 2 + (a * b.conj()).real + abs(b) ** 2
    return cross.sum() / 2, (cross * square).sum() / 12


def test_volume_and_inertia_are_the_given_ones():
    """Given values, by a rack generation of their own: a polyline of 40 000 points a flank."""
    system, cut = cut_wheel(25, 0.014229850303051, 21.916, (1.41, 0.2), m_n=2.0)
    curves = section(system, cut)
    assert curves.area * 0.015 * 1e9 == pytest.approx(33703.99256659126, rel=1e-10)
    assert 7859.999999999999 * 0.015 * curves.polar_moment * 1e6 == pytest.approx(96.70699879870187, rel=1e-10)
    blank = wheel_mass(rho=7859.999999999999, b=0.015, d=cut.reference_diameter, d_i=0.0)
    assert blank == pytest.approx(0.26896673145461364, rel=1e-9)


@pytest.mark.parametrize("case", WHEELS)
def test_a_very_fine_polyline_encloses_as_much(case):
    """One of a tenth of a nanometre lacks some 10⁻⁸ of these areas; the program's own of a micrometre 10⁻⁴."""
    system, w = cut_wheel(*case)
    curves = section(system, w)
    area, polar_moment = enclosed(repeated(tooth(system, w, 1e-10), w.teeth))
    assert area == pytest.approx(curves.area, rel=5e-8)
    assert polar_moment == pytest.approx(curves.polar_moment, rel=1e-7)


@pytest.mark.parametrize("case", WHEELS)
def test_points_run_on_the_outline_from_root_to_tip(case):
    system, w = cut_wheel(*case)
    cut, curves = Cut(system, w.teeth, w.profile_shift), section(system, w)
    assert abs(curves.fillet[0]) == pytest.approx(w.root_diameter / 2, rel=1e-12)
    assert np.angle(curves.fillet[0]) == pytest.approx(curves.root_angle)
    assert curves.fillet[-1] == pytest.approx(curves.involute[0], rel=1e-9)
    assert np.angle(curves.involute) == pytest.approx(cut.involute(np.abs(curves.involute)), abs=1e-12)
    assert abs(curves.involute[-1]) == pytest.approx(min(w.tip_diameter, w.pointed_diameter) / 2, rel=1e-9)
    assert curves.tip_angle == pytest.approx(np.angle(curves.involute[-1]), abs=1e-12)
    assert curves.has_tip == (w.pointed_diameter > w.tip_diameter)


def test_turn_of_the_fillet_is_its_derivative():
    cut = Cut(cut_wheel(8, -0.3, 15.0, (1.25, 0.2))[0], 8, -0.3)
    phi, h = np.linspace(-1.5, -0.4, 7), 1e-5
    by_steps = (cut.fillet(phi + h)[1] - cut.fillet(phi - h)[1]) / (2 * h)
    assert cut.turn_of_fillet(phi) == pytest.approx(by_steps, rel=1e-7)


def test_allowance_takes_its_share_of_the_flanks():
    """A thinner tooth lacks what its span does along the base cylinder, over its depth: to first order."""
    system, w = cut_wheel(36, 0.0, 20.0, (1.25, 0.38), allowance=(-20, -40))
    whole, thick, thin = (section(system, w, x).area for x in (None, *list(shifts(system, w).values())[1:]))
    assert whole > thick > thin
    # the root is cut deeper too: by as much as the generating shift
    assert (whole - thin) / (whole - thick) == pytest.approx(2.0, rel=0.01)


def test_a_step_that_finishing_leaves_is_part_of_the_outline():
    system, w = cut_wheel(30, 0.1, 20.0, (1.4, 0.25))
    stepped = replace(system, s_pr=-0.02e-3)
    curves = section(stepped, w)
    assert curves.step and not section(system, w).step
    assert abs(curves.fillet[-1]) == pytest.approx(abs(curves.involute[0]), rel=1e-12)
    exact = enclosed(repeated(tooth(stepped, w, 1e-10), w.teeth))[0]
    assert exact == pytest.approx(curves.area, rel=5e-8)
    assert math.pi / curves.teeth > curves.root_angle > np.angle(curves.fillet[-1]) > np.angle(curves.involute[0])
