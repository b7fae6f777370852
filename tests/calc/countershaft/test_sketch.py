# SPDX-License-Identifier: Apache-2.0
"""The counter-shaft as a sketch: its pieces where they are, its bending line, what fails."""

import math

import pytest

from calc.countershaft.front_view import sector_outline
from calc.countershaft.sketch import sketch
from calc.design.addresses import address, changed
from calc.design.toml_file import Document, design, load, read
from calc.draw.drawing import HIDDEN, Arc, Area, Polyline, Words
from calc.solve import solve
from tests.calc import sketches
from tests.conftest import DESIGNS, SCREENED


def made(document, **values):
    """The sketch of a design with other values of its shaft."""
    data = document.data
    for key, value in values.items():
        data = changed(data, address(data, f"shafts.shaft.{key}"), value)
    asked = design(Document(data))
    return sketch(asked, solve(asked))


def test_gamma_to_scale_with_its_bending_line(gamma, gamma_results):
    shaft = sketch(gamma_results.design, gamma_results)
    sketches.check(shaft, gamma)
    left, _, right, _ = shaft.box
    outline = gamma_results.outcomes["countershaft"].result.outline
    assert left < outline.start and outline.end < right < outline.end + 0.1 * (outline.end - outline.start)
    assert any("1000" in str(note) for note in shaft.notes)
    bent = next(mark for mark in shaft.primitives if mark.layer == HIDDEN)
    assert isinstance(bent, Polyline)
    sag = abs(gamma_results.outcomes["countershaft"].result.bending.vectors).max() * 1000
    assert 0.5 * sag < max(abs(y) for _, y in bent.points) <= sag * (1 + 1e-9)


def test_holes_that_have_nothing_to_take_away_show_it(gamma_results):
    """The shaft of gamma gives less than the engine asks for, the sized one more."""
    key = "shafts.S.holes"

    def states(shaft):
        return {mark.state for mark in sketches.marks(shaft) if mark.key == key}

    assert states(sketch(gamma_results.design, gamma_results)) == {"warn"}
    assert states(made(read(DESIGNS / "r753ie4_sized.toml"))) == {""}


def test_a_mass_lights_its_own_sector_alone(gamma, gamma_results):
    shaft = sketch(gamma_results.design, gamma_results)
    front = {mark for mark in sketches.lit(shaft, "shafts.S.masses.front.mass_kg") if isinstance(mark, Area)}
    rear = {mark for mark in sketches.lit(shaft, "shafts.S.masses.rear.mass_kg") if isinstance(mark, Area)}
    assert front and rear and not front & rear


def test_a_slope_beyond_its_target_marks_its_support(gamma):
    supports = "shafts.S.bearings.*.position_mm shafts.S.bearings.front.position_mm"

    def warned(shaft):
        return {mark.key for mark in sketches.marks(shaft) if mark.state == "warn"}

    assert supports not in warned(made(gamma)) and supports in warned(made(gamma, core_radius_mm=9.0))


@pytest.mark.parametrize("name", ["twin_force_shaft", SCREENED, "r753ie4_sized"])
def test_shafts_of_every_kind(name):
    document, asked = load(DESIGNS / f"{name}.toml")
    (seen,) = solve(asked).views.values()
    shaft = sketch(seen.design, seen)
    sketches.check(shaft, document)
    points = any("points" in str(note) for note in shaft.notes)
    assert points == (name != "r753ie4_sized")


def test_a_sector_stands_at_its_angle(gamma_results):
    piece = next(
        piece for piece in gamma_results.outcomes["countershaft"].result.outline.pieces if piece.half_angle is not None
    )
    points = sector_outline(piece)
    x, y = points[(len(points) // 2 - 1) // 2]
    assert math.hypot(x, y) == pytest.approx(piece.outer_radius)
    assert math.atan2(x, y) % (2 * math.pi) == pytest.approx(piece.angle)


def test_from_the_front_the_core_is_a_circle(gamma, gamma_results):
    (front,) = sketch(gamma_results.design, gamma_results).beside
    assert any(isinstance(mark, Arc) and mark.radius == pytest.approx(0.015) for mark in front.primitives)


def test_nothing_is_drawn_of_a_shaft_that_can_not_be_sized(gamma):
    waits = made(gamma, mode="size", half_length_mm=20.0)
    assert not waits.primitives and waits.notes


# --- all of them beside the crank


FOUR = read(DESIGNS / f"{SCREENED}.toml").data
LEFT = FOUR["shafts"][0] | {"name": "left", "axis_mm": [-60.0, -95.0]}
RIGHT = {"name": "right", "mirrors": "left"}
FIRST = {
    "name": "first",
    "speed_ratio": -1,
    "mode": "given",
    "material": "steel",
    "bearings": LEFT["bearings"],
    "axis_mm": [90.0, 60.0],
    "masses": [{"name": "a", "mass_kg": 0.3, "radius_mm": 15.0, "angle_deg": 90.0, "z_mm": 0.0}],
}
BACK = {"name": "back", "repeats": "first", "axis_mm": [90.0, -60.0]}


def all_of(*shafts):
    """The picture of all shafts of an inline four, and its document."""
    document = Document(FOUR | {"shafts": list(shafts)})
    asked = design(document)
    whole = sketch(asked, solve(asked))
    sketches.check(whole, document)
    return next(one for one in (whole, *whole.beside) if str(one.title).startswith("beside the crank")), whole


CHAIN = {"name": "chain", "kind": "chain", "driver": "crank", "driven": "left", "pitch_mm": 8.0}
OIL = {"oil_level_mm": -150.0, "flank_roughness_um": 0.4, "oil": "SAE 10W", "oil_temperature_C": 90.0}
GEARS = {
    "normal_module_mm": 2.0,
    "face_width_mm": 10.0,
    "power_kW": 0.1,
    "stages": [CHAIN | {"driver_teeth": 42, "driven_teeth": 21}],
}


def test_the_chain_runs_around_its_sprockets_and_the_oil_lies_level():
    document = Document(FOUR | {"shafts": [LEFT], "gears": GEARS, "friction": OIL})
    asked = design(document)
    whole = sketch(asked, solve(asked))
    sketches.check(whole, document)
    picture = next(one for one in whole.beside if str(one.title).startswith("beside the crank"))
    (chain,) = (mark.points for mark in picture.primitives if mark.key == "gears.stages.chain")
    for (x, y), z in (((0.0, 0.0), 42), ((-0.095, -0.06), 21)):
        assert min(math.dist(point, (x, y)) for point in chain) == pytest.approx(
            0.004 / math.sin(math.pi / z), rel=1e-3
        )
    line, words = (mark for mark in picture.primitives if mark.key == "friction.oil_level_mm")
    assert {y for _, y in line.points} == {-0.15} and str(words.text) == "oil at rest"


def circles(picture, state=""):
    return [mark for mark in picture.primitives if isinstance(mark, Arc) and mark.state == state]


@pytest.mark.parametrize("shafts", [(LEFT,), (LEFT, RIGHT), (LEFT, RIGHT, FIRST), (LEFT, RIGHT, FIRST, BACK)])
def test_each_shaft_stands_at_its_axis(shafts):
    picture, whole = all_of(*shafts)
    places = {"left": (-0.095, -0.06), "right": (0.095, -0.06), "first": (0.06, 0.09), "back": (-0.06, 0.09)}
    names = {str(mark.text).split()[0]: mark.at for mark in picture.primitives if isinstance(mark, Words)}
    assert set(names) == {shaft["name"] for shaft in shafts} and not circles(picture, "fail")
    for name, (x, y) in names.items():
        assert x == pytest.approx(places[name][0]) and y < places[name][1]
    assert [mark.centre for mark in circles(picture)] == [(0.0, 0.0)] + [
        pytest.approx(places[shaft["name"]]) for shaft in shafts
    ]
    own = [shaft for shaft in shafts if "mirrors" not in shaft and "repeats" not in shaft]
    assert whole.views == (len(own) + 2 if len(own) > 1 else 2)


def test_arrows_say_how_each_turns_and_where_its_force_points():
    """The left one turns with the crank, clockwise; the forces of both point down with cylinder 1 at TDC."""
    picture, _ = all_of(LEFT, RIGHT)
    arrows = [mark.points for mark in picture.primitives if isinstance(mark, Polyline) and mark.arrow]
    crank, left, force, right, mirrored = arrows
    assert crank[0][0] < crank[-1][0] and left[0][0] < left[-1][0] and right[0][0] > right[-1][0]
    for (x_0, y_0), (x_1, y_1) in (force, mirrored):
        assert x_1 == pytest.approx(x_0) and y_1 < y_0
    first, _ = all_of(LEFT, RIGHT, FIRST)
    aside = [mark.points for mark in first.primitives if isinstance(mark, Polyline) and mark.arrow][-1]
    assert aside[1][0] > aside[0][0] and aside[1][1] == pytest.approx(aside[0][1])  # its mass stands at 90°
    assert math.dist(*aside) < math.dist(*force)


def test_a_twin_s_sectors_are_mirrored(gamma):
    data = gamma.data
    own = data["shafts"][0] | {"axis_mm": [-60.0, 95.0]}
    document = Document({key: data[key] for key in data if key not in ("bearings", "gears", "friction", "accepted")})
    kept = ("name", "position_mm", "diameter_mm", "length_mm")
    rows = [{key: row[key] for key in kept} for row in own["bearings"]]
    shafts = [own | {"bearings": rows}, {"name": "twin", "mirrors": own["name"]}]
    asked = design(Document(document.data | {"shafts": shafts}))
    whole = sketch(asked, solve(asked))
    picture = next(one for one in whole.beside if str(one.title).startswith("beside the crank"))
    outlines = [mark.outlines[0] for mark in picture.primitives if isinstance(mark, Area)]
    half = len(outlines) // 2
    for one, other in zip(outlines[:half], outlines[half:]):
        assert sorted((-x, y) for x, y in one) == [pytest.approx(point) for point in sorted(other)]


def test_where_two_sweeps_meet_it_is_red():
    near = FIRST | {"axis_mm": [-45.0, -100.0]}
    picture, _ = all_of(LEFT, RIGHT, near)
    one, other = circles(picture, "fail")
    for arc, (x, y) in ((one, other.centre), (other, one.centre)):
        R = next(mark.radius for mark in circles(picture) if mark.centre == (x, y))
        ends = [
            (arc.centre[0] + arc.radius * math.cos(angle), arc.centre[1] + arc.radius * math.sin(angle))
            for angle in (arc.start, arc.end, (arc.start + arc.end) / 2)
        ]
        assert math.dist(ends[0], (x, y)) == pytest.approx(R) == math.dist(ends[1], (x, y))
        assert math.dist(ends[2], (x, y)) < R
    (whole,) = circles(all_of(LEFT, RIGHT | {"axis_mm": [-60.0, -95.0]})[0], "fail")[:1]
    assert whole.end - whole.start == pytest.approx(2 * math.pi)


def test_shafts_without_a_place_stand_beneath():
    picture, _ = all_of(LEFT, RIGHT, {key: part for key, part in FIRST.items() if key != "axis_mm"})
    said = {str(mark.text): mark.at for mark in picture.primitives if isinstance(mark, Words)}
    assert said["first ×1"][1] < min(said["left ×2"][1], said["right ×2"][1])
    assert said["place not given"][1] < said["first ×1"][1]


def test_without_any_place_the_shafts_stand_alone():
    bare = {key: part for key, part in LEFT.items() if key != "axis_mm"}
    asked = design(Document(FOUR | {"shafts": [bare, RIGHT]}))
    picture = sketch(asked, solve(asked)).beside[0]
    assert str(picture.title).startswith("all shafts, up to ")
    assert not [mark for mark in picture.primitives if mark.key.startswith("engine")] and len(circles(picture)) == 2
