"""Which teeth meet, proven with the profiles themselves; marks, steps of assembly, insertion."""

import cmath
import math
from dataclasses import replace

import numpy as np
import pytest

from calc.gears.layout.solve import ShaftInTrain, layout
from calc.gears.profile.outline import regions, repeated, tooth
from tests.calc.gears.layout.trains import AXIS, at, laid, mesh, r753, solved, train, triangle, verdicts

R753_AXIS = 0.130 + 0.103j
FINE = 1e-8  # m: how far the outlines may be from the true curves


def depth(gears, found, key, turned=0.0):
    """How deep the driven wheel's outline stands in the driver's teeth, at most [m]; negative: they are apart by that
    angle's arc."""
    result = solved(gears)
    m = result.meshes[key]
    driver, driven = result.wheels[m.driver], result.wheels[m.driven]
    one, two = found.wheels[m.driver], found.wheels[m.driven]
    flank = regions(result.system, driver, FINE)
    radius = np.concatenate([flank.fillet[0], flank.involute[0][1:]])
    half = np.concatenate([flank.fillet[1], flank.involute[1][1:]])
    edge = (
        repeated(tooth(result.system, driven, FINE), driven.teeth) * cmath.exp(1j * (two.tooth_angle + turned))
        + two.position
        - one.position
    )
    edge = edge[np.abs(edge) < driver.tip_diameter / 2]
    pitch = 2 * np.pi / driver.teeth
    off = np.angle(edge) - one.tooth_angle
    off = np.abs(off - pitch * np.round(off / pitch))
    return float(((np.interp(np.abs(edge), radius, half) - off) * np.abs(edge)).max())


@pytest.mark.parametrize("tooth", [0.0, 0.05, -0.4])
@pytest.mark.parametrize("key", ["crank_central", "central_idler", "idler_shaft"])
def test_teeth_at_the_computed_angles_touch_and_do_not_overlap(key, tooth):
    """Without allowances and at centre distances without backlash both flanks touch: 0 µm, to the points of the
    outlines."""
    gears = replace(r753(), tooth_angle=tooth)
    found = layout(gears, solved(gears), {"shaft": ShaftInTrain(R753_AXIS, 0.3)}).result
    assert depth(gears, found, key) == pytest.approx(0.0, abs=1e-7)


@pytest.mark.parametrize("turned", [0.01, -0.01])
def test_teeth_at_other_angles_overlap(turned):
    gears = r753()
    found = layout(gears, solved(gears), {"shaft": ShaftInTrain(R753_AXIS)}).result
    assert depth(gears, found, "idler_shaft", turned) > 1e-4


def test_the_triangle_touches_too():
    gears = triangle()
    found = laid(gears, AXIS).result
    assert [depth(gears, found, key) for key in ("crank_idler", "idler_shaft")] == pytest.approx([0, 0], abs=1e-7)


@pytest.mark.parametrize("z_2, tooth", [(40, 4.5), (41, 0.0)])
def test_a_driver_with_a_tooth_towards_the_driven_wheel(z_2, tooth):
    """A space of the driven wheel looks down; on the other side an even wheel has a space and an odd one a tooth."""
    gears = train([at("crank", 20), at("shaft", z_2)], [mesh("crank", "shaft")], m_n=1.0, beta=0.0, ball=None)
    found = laid(gears, (20 + z_2) / 2e3)
    assert math.degrees(found.result.wheels["shaft"].tooth_angle) == pytest.approx(tooth)
    mark = next(t for t in found.tables if t.id == "timing_marks").rows[0]
    assert mark[:2] == ("crank–shaft", 1) and mark[2] == pytest.approx(0)
    assert mark[3] == {40: "20 and 21", 41: "21 and 22"}[z_2]


def test_marked_teeth_stand_beside_the_marked_tooth():
    """The middle of the two marked teeth is where the driver's tooth is, rolled along by the ratio of the teeth."""
    gears = r753()
    found = laid(gears, R753_AXIS, eccentric=0.3)
    rows = {row[0]: row for row in next(t for t in found.tables if t.id == "timing_marks").rows}
    for key, m in solved(gears).meshes.items():
        _, tooth, off, between = rows[f"{m.driver}–{m.driven}"]
        gamma = found.result.meshes[key].line_of_centres
        z_1, z_2 = (solved(gears).wheels[name].teeth for name in (m.driver, m.driven))
        at_driver = found.result.wheels[m.driver].tooth_angle + (tooth - 1) * 2 * math.pi / z_1 - gamma
        assert math.sin(at_driver - math.radians(off)) == pytest.approx(0, abs=1e-9)
        assert abs(off) <= 180 / z_1 + 1e-9
        first, second = map(int, between.split(" and "))
        assert second == first % z_2 + 1
        space = found.result.wheels[m.driven].tooth_angle + (first - 0.5) * 2 * math.pi / z_2
        assert cmath.exp(1j * (space - gamma - math.pi + math.radians(off) * z_1 / z_2)) == pytest.approx(1, abs=1e-9)


def test_a_turned_train_has_turned_teeth():
    gears, angle = r753(), 0.7
    here = laid(gears, R753_AXIS, eccentric=0.3).result
    places = {n: w.position * cmath.exp(1j * angle) for n, w in here.wheels.items()}
    wheels = [replace(w, position=(places[w.name].real, places[w.name].imag)) for w in gears.wheels]
    there = laid(replace(gears, wheels=tuple(wheels), tooth_angle=angle), eccentric=0.3 + angle).result
    assert there.shafts["shaft"].eccentric_offset == pytest.approx(here.shafts["shaft"].eccentric_offset)
    for name, w in there.wheels.items():
        pitches = (
            (w.tooth_angle - here.wheels[name].tooth_angle - angle) * solved(gears).wheels[name].teeth / (2 * math.pi)
        )
        assert pitches == pytest.approx(round(pitches), abs=1e-8)


def test_the_eccentric_has_its_tooth_within_half_a_pitch():
    gears = r753()
    for eccentric in np.linspace(-3, 3, 25):
        found = laid(gears, R753_AXIS, eccentric=float(eccentric), couple=30.0).result
        assert found.wheels["shaft"].tooth_angle == pytest.approx(eccentric + found.shafts["shaft"].eccentric_offset)
        assert abs(found.shafts["shaft"].eccentric_offset) <= math.radians(7.2) * (1 + 1e-9)
        assert found.shafts["shaft"].eccentric_tooth_error + found.shafts[
            "shaft"
        ].eccentric_space_error == pytest.approx(math.radians(7.2))
        assert found.shafts["shaft"].eccentric_tooth_couple == pytest.approx(
            60 * math.sin(found.shafts["shaft"].eccentric_tooth_error / 2)
        )


def test_one_tooth_further_leaves_twice_the_sine_of_half_the_step():
    """360°/25 = 14.4°: 2·C·sin 7.2° = 0.2507·C."""
    found = laid(r753(), couple=100.0).result
    assert math.degrees(found.shafts["shaft"].remesh_angle) == pytest.approx(14.4)
    assert found.shafts["shaft"].remesh_couple == pytest.approx(25.0666, abs=1e-4)


def test_without_positions_no_tooth_of_the_shaft_is_known():
    found = laid(r753(), eccentric=0.3)
    assert found.result.shafts["shaft"].eccentric_offset is None and found.result.wheels["shaft"].tooth_angle is None
    assert any("assembly phase is not known" in note for note in found.notes)


def test_hunting_teeth_of_the_train():
    """gcd(36, 39) = 3; (25, 36) and (39, 25) have no common factor."""
    found = laid(r753())
    assert {k: (m.common_factor, m.turns_to_repeat) for k, m in found.result.meshes.items()} == {
        "crank_central": (1, 36),
        "central_idler": (3, 13),
        "idler_shaft": (1, 25),
    }
    judged = verdicts(found)
    assert [judged[f"{k}.hunting"] for k in found.result.meshes] == ["pass", "note", "pass"]
    said = [c.advice for c in found.checks if c.id.endswith(".hunting")]
    assert ["meets only" in advice for advice in said] == [False, True, False]
    assert "central meets only 13 of the 39 teeth of idler, and one fault returns after 13 turns of central" in said[1]


def test_marks_meet_again_after_whole_turns_of_every_wheel_and_not_before():
    period = int(laid(r753()).result.marks_period)
    assert period == math.lcm(36, 39)
    whole = [n for n in range(1, period + 1) if all(n * 25 % z == 0 for z in (36, 39, 25))]
    assert whole == [period]


@pytest.mark.parametrize(
    "journals, end, verdict, gap",
    [
        ((59.5e-3, 40e-3), "front", "pass", 1.548),
        ((59.5e-3, 40e-3), "rear", "warn", -17.952),
        ((59.5e-3, 40e-3), None, "warn", -17.952),
    ],
)
def test_the_wheel_passes_through_the_seat_of_the_journal(journals, end, verdict, gap):
    found = laid(r753(), journals=journals, gear_end=end)
    assert verdicts(found)["train.assembly"] == verdict
    assert found.result.shafts["shaft"].insertion_gap * 1e3 == pytest.approx(gap, abs=5e-4)


def test_the_gap_of_the_source_is_about_half_of_its_sheet():
    """Journal 59.5 mm, tip 58.7 mm on the drawing: 0.8 mm; the sheet's tip circle is smaller."""
    (found,) = laid(r753(), journals=(59.5e-3, 81e-3), gear_end="front").errata
    assert found.source_value == 0.8 and found.about == "gears.insertion_gap"
    assert not laid(r753(), journals=(65e-3, 81e-3), gear_end="front").errata
