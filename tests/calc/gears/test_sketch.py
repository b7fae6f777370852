# SPDX-License-Identifier: Apache-2.0
"""The train as a sketch: wheels that touch on their pitch circles, walls, and the tightest mesh with its backlash."""

import math

import pytest

from calc.design.toml_file import design, load
from calc.draw.drawing import Arc, Polyline
from calc.gears.sketch import sketch
from calc.solve import solve
from tests.calc import sketches
from tests.conftest import DESIGNS


def wheels(train):
    """Pitch circles by the names of their wheels."""
    circles = (mark for mark in train.primitives if isinstance(mark, Arc) and mark.key.startswith("gears.wheels."))
    return {mark.key.split()[0].rpartition(".")[2]: mark for mark in circles}


@pytest.mark.parametrize("name", ["r753ie4_gamma", "r753ie4_sized", "timing_pair", "finotti_gear_sheet"])
def test_the_pitch_circles_of_every_mesh_touch(name):
    document, asked = load(DESIGNS / f"{name}.toml")
    results = solve(asked)
    train = sketch(asked, results)
    sketches.check(train, document)
    circles = wheels(train)
    for mesh in results.outcomes["gears"].result.meshes.values():
        first, second = circles[mesh.driver], circles[mesh.driven]
        apart = math.dist(first.centre, second.centre)
        assert apart == pytest.approx(mesh.centre_distance, abs=1e-5)
        # a wheel may have another pitch circle for each mate
        assert first.radius + second.radius == pytest.approx(apart, rel=5e-3)


def test_a_mesh_without_room_is_marked_at_its_place(gamma, gamma_results):
    train = sketch(gamma_results.design, gamma_results)
    assert sketches.failing(train) >= {"gears.meshes.1", "gears.meshes.2"}
    assert "gears.meshes.0" not in sketches.failing(train)
    assert any(str(note) == "in a row" for note in train.notes)


def test_teeth_that_fail_are_drawn_with_the_least_backlash(gamma):
    """Below zero: drawn as teeth that run into each other, exaggerated by as much as makes 28 µm nearly 0.3 modules of
    2 mm."""
    for wheel in ("central", "idler"):
        gamma = gamma.with_value(f"gears.wheels.{wheel}.runout_um", 20.0)
    results = solve(design(gamma))
    train = results.outcomes["gears"].result
    assert train.meshes["central_idler"].backlash_min == pytest.approx(-14.65e-6, abs=1e-7)
    assert train.meshes["central_idler"].backlash_nominal == pytest.approx(36e-6, abs=1e-7)
    assert train.play["central_idler"].backlash_min_runout == pytest.approx(-27.94e-6, abs=1e-8)
    notes = [str(note) for note in sketch(results.design, results).notes]
    assert "gap × 20" in notes  # without the runout it would be 30, in the middle of the tolerances 15


def test_wheels_with_places_stand_within_their_walls():
    _, asked = load(DESIGNS / "r753ie4_sized.toml")
    train = sketch(asked, solve(asked))
    assert len(
        [mark for mark in train.primitives if isinstance(mark, Polyline) and mark.key.startswith("gears.walls.")]
    ) == len(asked.gears.walls)
    assert train.beside and any("gap ×" in str(note) for note in train.notes)
    assert not sketches.failing(train)
