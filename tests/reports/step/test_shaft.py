# SPDX-License-Identifier: Apache-2.0
"""A shaft as a solid: against the mass properties, by the kernel and by a reader of its file that knows no kernel."""

import json
import math

import numpy as np
import pytest

from calc.countershaft.balancing import hole as h
from calc.countershaft.outline import Piece, outline
from calc.exchange.frame import Frame
from tests.calc.countershaft.shafts import drawn_shaft
from tests.conftest import ROOT

pytest.importorskip("OCP")

from reports.step import shaft as step
from reports.step.kernel import KernelFault, solids, step_file
from reports.step.shaft import Hole, shaft_solid
from tests.reports.step.reading import File, weighed

RHO, HEAVY = 7860.0, 17300.0
GIVEN = json.loads((ROOT / "tests" / "data" / "mass_properties.json").read_text(encoding="utf-8"))["given"]
CLOCKWISE = Frame()


def of_case(n):
    pieces = []
    for p in GIVEN[n]["case"]["pieces"]:
        half = p["half_angle_deg"]
        lengths = (p[key] * 1e-3 for key in ("from_mm", "to_mm", "outer_radius_mm", "core_radius_mm"))
        half, angle = None if half is None else math.radians(half), math.radians(p["angle_deg"])
        pieces.append(Piece(*lengths, half, angle, "full" if half is None else "sector"))
    return outline(tuple(pieces), False)


def row(*pieces, bore=0.0, heavier=1.0):
    """From lengths in mm: a piece (length, R), or (length, R, r_0, half-angle, angle) in degrees."""
    here, made = -0.06, []
    for length, R, *sector in pieces:
        r_0, half, angle = sector or (0.0, None, 0.0)
        half = half and math.radians(half)
        end = here + length * 1e-3
        made.append(Piece(here, end, R * 1e-3, r_0 * 1e-3, half, math.radians(angle), "sector" if half else "full"))
        here = end
    return outline(tuple(made), False, bore * 1e-3, heavier)


SHAFTS = {
    "gamma": of_case(0),
    "half disc": of_case(10),
    "pair": row((25, 15), (84, 27, 13, 90, 180), (10, 14), (84, 27, 13, 90, 180), (25, 16)),
    "hollow": row((20, 14), (50, 30, 11, 70, 40), (8, 11), (50, 26, 11, 130, -120), (20, 14), bore=6.0),
    "couple": drawn_shaft(),
    "full and touching": row((20, 14), (30, 30, 11, 180, 40), (30, 30, 11, 90, 0), (30, 30, 11, 90, 90), (20, 30)),
    "no core": row((20, 14), (30, 30, 0, 90, 0), (20, 14), (30, 30, 0, 40, 0), (20, 14)),
}


def file_of(made, words=("undrilled",)):
    return step_file([made.part], "shaft.step", "2026-01-01", words)


@pytest.mark.parametrize("turn", [1, -1])
@pytest.mark.parametrize("name", SHAFTS)
def test_the_solid_is_the_shaft(name, turn):
    made = shaft_solid(name.replace(" ", "-"), SHAFTS[name], RHO, Frame(turn))
    assert made.deviation < 1e-9
    ((_, sums),) = File(file_of(made)).bodies()
    mass, centre, tensor = weighed(sums * RHO * 1e-9)
    length = (SHAFTS[name].end - SHAFTS[name].start) * 1e3
    program = made.by_program
    assert mass == pytest.approx(program.mass, rel=1e-8)
    assert centre == pytest.approx(program.centre, abs=1e-8 * length)
    assert tensor == pytest.approx(program.tensor, abs=1e-8 * np.max(program.tensor))


def test_the_frame_is_right_handed_whichever_way_the_engine_turns():
    for_both = [shaft_solid("a", SHAFTS["hollow"], RHO, Frame(turn)).whole for turn in (1, -1)]
    clockwise, other = for_both
    assert other.centre == pytest.approx(clockwise.centre * [1, -1, 1]) and abs(clockwise.centre[1]) > 0.5
    assert other.tensor == pytest.approx(clockwise.tensor * [[1, -1, 1], [-1, 1, -1], [1, -1, 1]])


def test_sectors_of_another_density_are_solids_of_their_own():
    shape = row((20, 14), (30, 30, 11, 70, 40), (30, 30, 11, 180, 0), (20, 14), heavier=HEAVY / RHO, bore=5.0)
    made = shaft_solid("left", shape, RHO, CLOCKWISE)
    assert made.deviation < 1e-9 and [one.name for one in made.solids] == ["left", "left-sectors"]
    bodies = File(file_of(made)).bodies()
    assert {name for name, _ in bodies} == {"left", "left-sectors"}
    densities = {"left": RHO, "left-sectors": HEAVY}
    mass, centre, _ = weighed(sum(sums * densities[name] * 1e-9 for name, sums in bodies))
    assert mass == pytest.approx(made.by_program.mass, rel=1e-8)
    assert centre == pytest.approx(made.by_program.centre, abs=1e-6)


def test_sectors_alone_and_no_sector_of_another_density():
    assert [n for n, _ in shaft_solid("a", row((20, 14)), RHO, CLOCKWISE).part.bodies] == ["a"]
    bare = row((20, 14, 0, 50, 0), heavier=2.0)
    assert [n for n, _ in shaft_solid("a", bare, RHO, CLOCKWISE).part.bodies] == ["a-sectors"]


def test_neighbours_of_the_same_section_are_one():
    """Else the solid has a face between them that nothing shows."""
    split = row((20, 14), (15, 30, 11, 70, 40), (15, 30, 11, 70, 400), (10, 14), (10, 14))
    whole = row((20, 14), (30, 30, 11, 70, 40), (20, 14))
    assert file_of(shaft_solid("a", split, RHO, CLOCKWISE)) == file_of(shaft_solid("a", whole, RHO, CLOCKWISE))


def test_holes_are_drilled_to_their_depth_with_the_cone():
    """The cylinder's exact volume: ρπa²·(mean height of the surface − q + l/3), mean of √(R² − y²) over the circle."""
    R, a, depth, point = 40.5, 7.0, 20.0, math.radians(118)
    hole = Hole("a-1", 0.01, math.radians(200), R * 1e-3, 2e-3 * a, depth * 1e-3, point)
    shape = row((20, 14), (80, R, 15, 90, 210), (20, 14))
    made = shaft_solid("a", shape, RHO, Frame(-1), [hole])
    surface = R * (1 - a**2 / (8 * R**2) - a**4 / (64 * R**4) - 5 * a**6 / (1024 * R**6))
    taken = math.pi * a**2 * (surface - (R - depth) + a / math.tan(point / 2) / 3)
    assert made.undrilled.volume - made.whole.volume == pytest.approx(taken, rel=1e-6)
    lost = made.undrilled.mass * made.undrilled.centre - made.whole.mass * made.whole.centre
    where = lost / (made.undrilled.mass - made.whole.mass)
    assert math.degrees(math.atan2(where[1], where[0])) == pytest.approx(-200 + 360) and where[2] == pytest.approx(10)
    flat = shaft_solid("a", shape, RHO, Frame(-1), [Hole(*(*vars(hole).values(),)[:-1], math.pi)])
    assert made.whole.volume < flat.whole.volume


def test_what_the_drill_takes_is_what_the_balancing_sheet_says():
    R, a, depth, point = 0.0405, 0.007, 0.02, math.radians(118)
    hole = Hole("a-1", 0.01, math.radians(200), R, 2 * a, depth, point)
    made = shaft_solid("a", row((20, 14), (80, 40.5, 15, 90, 210), (20, 14)), RHO, CLOCKWISE, [hole])
    shape = dict(rho=RHO, a=a, q=h.bottom_radius(R=R, h=depth), l=h.cone_length(a=a, theta=point))
    taken = made.undrilled.mass - made.whole.mass
    assert taken == pytest.approx(h.hole_mass(R_m=h.mean_surface(R=R, a=a), **shape), rel=1e-7)
    lost = made.undrilled.mass * made.undrilled.centre - made.whole.mass * made.whole.centre
    assert math.hypot(*lost[:2]) * 1e-3 == pytest.approx(h.hole_unbalance(R=R, **shape), rel=1e-7)


def test_a_solid_that_is_not_what_the_program_weighs_is_a_fault(monkeypatch):
    weigh = step.mass_properties
    monkeypatch.setattr(step, "mass_properties", lambda shape, rho: weigh(shape, rho * (1 + 2e-6)))
    with pytest.raises(KernelFault, match="the solid of a is off"):
        shaft_solid("a", SHAFTS["pair"], RHO, CLOCKWISE)


def test_what_makes_it_invalid_is_named(monkeypatch):
    monkeypatch.setattr(step, "fused", lambda *shapes: step.face(step.polygon([(0, 0, 0), (1, 0, 0), (1, 0, 3)])))
    with pytest.raises(KernelFault, match="the solid of a with its sector from -35 to 49 mm"):
        shaft_solid("a", SHAFTS["pair"], RHO, CLOCKWISE)


def test_the_file_is_the_same_each_time_and_says_nothing_of_here():
    made = shaft_solid("left", SHAFTS["pair"], RHO, CLOCKWISE)
    first = file_of(made)
    assert first == file_of(shaft_solid("left", SHAFTS["pair"], RHO, CLOCKWISE))
    text = first.decode("ascii")
    assert "'shaft.step','2026-01-01T00:00:00',(''),('')" in text and "PRODUCT('left','left'" in text
    assert "AUTOMOTIVE_DESIGN" in text and ".MILLI.,.METRE." in text.replace(" ", "") and "/tmp" not in text
    assert len(solids(made.part.bodies[0][1])) == 1
