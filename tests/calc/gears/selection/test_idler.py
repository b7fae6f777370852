"""Teeth and place of an idler between walls: what passes stands clear, meshes with both neighbours, and is what is then
computed."""

from dataclasses import replace

import numpy as np
import pytest

from calc.design.toml_file import design, read
from calc.gears.layout.solve import ShaftInTrain, layout
from calc.gears.selection.free_shifts import freedoms
from calc.gears.selection.idler import idler_table, idlers, passed
from calc.gears.solve import geometry
from calc.gears.train import settle, tooth_system
from tests.calc.gears.layout.trains import AXIS, screw, triangle, wall
from tests.conftest import DESIGNS

COVER = wall("cover", -60, 0, -60, 60)  # the idler stands 24 mm below the line of its neighbours, or above it


@pytest.fixture(scope="module")
def sized():
    return design(read(DESIGNS / "r753ie4_sized.toml"))


@pytest.fixture(scope="module")
def rows(sized):
    (found,) = idlers(sized.gears, {"shaft": complex(*sized.countershaft.axis)})
    return found


def edited(gears, changes):
    """The train as its file is with the keys of a row."""
    wheels, meshes = {w.name: w for w in gears.wheels}, list(gears.meshes)
    for key, value in changes.items():
        _, table, name, key = key.split(".")
        if table == "wheels":
            wheels[name] = replace(wheels[name], **{key: value})
        else:
            meshes[int(name)] = replace(meshes[int(name)], centre_distance=value * 1e-3)
    return replace(gears, wheels=tuple(wheels.values()), meshes=tuple(meshes))


def test_fewer_teeth_have_more_room_and_the_next_one_touches_the_cover(rows):
    by_teeth = {row.teeth: row for row in rows}
    assert sorted(by_teeth) == list(range(26, 53))
    # 37 alone has no common factor and its mates well in reach
    assert [row.teeth for row in passed(rows)] == [37, 38, 36, 35, 34, 33]
    assert by_teeth[39].changes == {} and by_teeth[39].place.clearance == pytest.approx(1.457e-3, abs=1e-6)
    assert [c.id for c in by_teeth[40].against if c.verdict == "fail"] == ["gears.idler.clearance"]
    assert by_teeth[40].place.nearest == "cover-below" and by_teeth[40].place.clearance < 0
    assert [c.id for c in by_teeth[32].against if c.verdict == "fail"] == ["gears.idler.position"] and not by_teeth[
        32
    ].passes


def test_a_row_is_what_its_keys_give(sized, rows):
    """Its shifts as before, its axis at both centre distances, its tip circle clear of the cover, by points of it."""
    gears, axis = sized.gears, complex(*sized.countershaft.axis)
    before = settle(gears, tooth_system(gears)).shifts
    for row in passed(rows):
        assert row.changes["gears.wheels.idler.span_teeth"] is None and len(row.changes) == 4
        made = geometry(changed := edited(gears, row.changes), 40.0).result
        there = layout(changed, made, {"shaft": ShaftInTrain(axis)}).result.wheels["idler"]
        assert there.nearest == row.place.nearest
        place = row.place.position, row.place.clearance
        assert (there.position, there.clearance) == pytest.approx(place, rel=1e-12)
        assert {name: w.profile_shift for name, w in made.wheels.items()} == pytest.approx(
            before,
            abs=3e-4,  # distances stand on the micrometre
        )
        ends = (complex(*gears.wheels[1].position), "central_idler"), (axis, "idler_shaft")
        assert [abs(row.place.position - p) for p, _ in ends] == pytest.approx(
            [made.meshes[key].centre_distance for _, key in ends]
        )
        reach = made.wheels["idler"].tip_diameter / 2 + made.meshes["central_idler"].centre_tolerance
        along = [np.linspace(complex(*w.from_), complex(*w.to), 2001) for w in gears.walls]
        gap = min(float(np.abs(line - row.place.position).min()) for line in along) - reach
        assert gap == pytest.approx(row.place.clearance, abs=1e-6)


def test_the_table_numbers_what_can_be_written_and_says_why_the_next_ones_fail(rows):
    table = idler_table(rows, 7, 2)
    assert [(row[0], row[1]) for row in table.rows] == [("now", 39), ("7", 37), ("8", 38), ("", 32), ("", 40)]
    assert "cover-below" in table.rows[-1][-1] and "spans" in table.rows[-2][-1] and "4 more" in table.note


def test_nothing_is_searched_without_walls_a_place_or_an_idler():
    assert idlers(triangle(), {"shaft": AXIS}) == [] and idlers(triangle(walls=(COVER,)), {}) == []
    assert idlers(triangle(idler=(18, 24), walls=(COVER,)), {"shaft": AXIS}) == []
    assert [rows[0].wheel for rows in idlers(triangle(neighbours=(screw("screw", -50, 20, 5),)), {"shaft": AXIS})] == [
        "idler"
    ]


def test_a_distance_that_is_not_given_is_not_written_and_without_a_tooth_there_is_no_row():
    gears = triangle(walls=(COVER,))
    deep = replace(
        gears, wheels=tuple(replace(w, tip_shortening=2.1e-3) if w.name == "idler" else w for w in gears.wheels)
    )
    assert all(list(row.changes) in ([], ["gears.wheels.idler.teeth"]) for row in idlers(gears, {"shaft": AXIS})[0])
    assert idlers(deep, {"shaft": AXIS}) == []


def test_a_distance_between_two_given_axes_is_not_left_free(sized):
    gears, axis = sized.gears, complex(*sized.countershaft.axis)
    loose = replace(gears, wheels=tuple(replace(w, position=None) for w in gears.wheels))
    assert [way.key for way in freedoms(gears, tooth_system(gears), {"shaft": axis})] == ["held"]
    assert [way.key for way in freedoms(gears, tooth_system(gears))] == ["held"]  # crank and central
    assert [way.key for way in freedoms(loose, tooth_system(gears), {"shaft": axis})] == ["designed", "held", "free"]


def test_a_distance_between_two_given_axes_is_theirs(sized):
    """The axes of crank and central stand 65.808 mm apart, whatever distance the present shifts would have."""
    meshes = (sized.gears.meshes[0], replace(sized.gears.meshes[1], centre_distance=81.2e-3), *sized.gears.meshes[2:])
    gears = replace(sized.gears, meshes=meshes)
    ways = freedoms(gears, tooth_system(gears), {"shaft": complex(*sized.countershaft.axis)})
    assert {round(way.gears.meshes[0].centre_distance, 6) for way in ways} == {0.065808}
