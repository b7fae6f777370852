# SPDX-License-Identifier: Apache-2.0
"""The counter-shaft as a sketch: its pieces where they are, its bending line, what fails."""

import math

import pytest

from calc.countershaft.sketch import sector_outline, sketch
from calc.design.addresses import address, changed
from calc.design.toml_file import Document, design, load, read
from calc.draw.drawing import HIDDEN, Arc, Area, Polyline
from calc.solve import solve
from tests.calc import sketches
from tests.conftest import DESIGNS


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


@pytest.mark.parametrize("name", ["twin_force_shaft", "r754ie4_balance_shafts", "r753ie4_sized"])
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
