"""Calibration holes: 14 mm × 20 mm into steel of 7860 kg/m³ from a radius of 40 mm, as in Finotti 2013, 3.2."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from calc.countershaft.inputs import Holes
from calc.countershaft.making.unbalance import calibration, hole_checks
from calc.countershaft.outline import Piece

OMEGA = 2 * math.pi * 2600 / 60
HOLES = Holes(diameter=0.014, depth=0.020, count=4)


def found(holes=HOLES, rho=7860.0, R=0.040, z=(-0.077, 0.077), C=572.932):
    return calibration(holes, rho, R, np.array(z), OMEGA, C)


def test_one_hole_of_the_source():
    """Worked by hand: π/4·1.4²·7.86 = 12.10 g/cm over 3.985 − 2 + 0.421/3 cm = 25.71 g, their centre of gravity at
    29.2 mm, 750.7 g·mm, 4.285 N·m at 77 mm and 2600 rpm."""
    r = found()
    assert r.hole_mass * 1e3 == pytest.approx(25.71, abs=5e-3)
    assert r.hole_centroid_radius * 1e3 == pytest.approx(29.2, abs=5e-3)
    assert r.hole_unbalance * 1e6 == pytest.approx(750.7, abs=0.05)
    assert r.hole_couple == pytest.approx(4.285, abs=5e-4)


def test_four_holes_and_the_overdesign_they_need():
    r = found()
    assert r.hole_range == pytest.approx(17.14, abs=0.005)
    assert r.hole_range_share * 100 == pytest.approx(2.992, abs=0.001)
    assert r.hole_overdesign * 100 == pytest.approx(1.496, abs=0.001)
    assert r.hole_unbalance_of_mass == pytest.approx(2 * r.hole_unbalance)


def test_a_shaft_without_a_required_couple_has_no_share_of_it():
    r = found(C=0.0)
    assert r.hole_range_share is None and r.hole_overdesign is None
    assert r.hole_range > 0


@given(st.integers(1, 20), st.floats(0.001, 0.05), st.floats(0.03, 0.2))
def test_the_range_is_that_of_the_masses_drilled_at_once(per_mass, depth, arm):
    """All holes together take, off each mass, its own unbalance times its own arm."""
    z = np.array([-0.4 * arm, 1.6 * arm])
    r = found(replace(HOLES, depth=depth, count=2 * per_mass), R=0.06, z=z)
    assert r.hole_range == pytest.approx(OMEGA**2 * np.sum(r.hole_unbalance_of_mass * np.abs(z)))


@given(st.floats(0.001, 0.0355))
def test_deeper_takes_more_until_the_cone_is_at_the_axis(depth):
    assert found(replace(HOLES, depth=depth + 1e-4)).hole_unbalance > found(replace(HOLES, depth=depth)).hole_unbalance


def test_a_hole_into_the_core_fails():
    def verdict(holes):
        (depth,) = hole_checks(holes, 0.040, 0.015, 0, [], found(holes), None)
        return depth.verdict

    assert verdict(HOLES) == "pass"
    assert verdict(replace(HOLES, depth=0.026)) == "fail"


def judged(*sectors, holes=HOLES, core=None):
    """The checks of a shaft of 40 mm by their last words; a sector by its start, end [mm], half angle and direction
    [°]."""
    pieces = [
        Piece(start * 1e-3, end * 1e-3, 0.040, 0.015, math.radians(half), math.radians(angle), "sector")
        for start, end, half, angle in sectors
    ]
    return {c.id.split(".")[-1]: c for c in hole_checks(holes, 0.040, core, 2, pieces, found(holes), None)}


@pytest.mark.parametrize(
    "sectors, shortest",
    [
        ([(-100, -10, 70, 0), (10, 90, 70, 180)], 80),
        ([(-100, -30, 70, 0), (-30, -10, 60, 0), (10, 110, 70, 180)], 90),
        ([(-100, 0, 70, 0), (0, 20, 60, 0), (20, 130, 70, 180)], 110),
        ([(-100, -10, 70, 0), (-10, 70, 70, 180), (75, 105, 70, 180), (105, 110, 70, 180)], 35),
        ([(-100, -70, 70, 0), (-69, 0, 70, 0), (10, 110, 70, 180)], 30),
        ([(-30, 0, 70, 0), (30, 70, 70, 0)], 30),
    ],
)
def test_holes_stand_along_the_shortest_sector(sectors, shortest):
    """Sectors that touch and stand in one direction are one."""
    assert judged(*sectors)["row"].limit == pytest.approx(shortest)


@pytest.mark.parametrize("half, other, half_chord", [(70, 80, math.sin(math.radians(70))), (130, 110, 1.0)])
def test_a_hole_has_the_width_of_its_sector(half, other, half_chord):
    """At its bottom, 20 mm from the axis; of a sector beyond the half the whole diameter."""
    width = judged((0, 50, half, 0), (60, 90, other, 0))["width"]
    assert width.limit == pytest.approx(40.0 * half_chord)


def test_what_would_keep_the_holes_in_the_sectors():
    (way,) = judged(core=0.0255, holes=replace(HOLES, depth=0.0146))["depth"].remedies
    assert way.changes == (("shafts.S.holes.depth_mm", 14.5),) and "at most 14.5 mm" in way.words
    (way,) = judged((0, 50, 5, 0))["width"].remedies  # 40·sin 5° = 3.486
    assert way.words == "Diameter at most 3.48 mm"


def test_without_sectors_only_the_depth_is_judged():
    assert set(judged(core=0.015)) == {"depth"}
    assert not judged()
