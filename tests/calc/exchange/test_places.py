"""Where wheels and their teeth stand: tooth in gap at every line of centres, in any plane along the crank."""

import cmath
import math
from functools import cache

import pytest

from calc.design.toml_file import load_design
from calc.exchange.frame import Frame
from calc.exchange.places import HANDS, helix, planes_of, shaft_axes, wheel_places
from calc.sheet.record import replace
from calc.solve import solve
from tests.conftest import ROOT


@cache
def solved(name):
    return solve(load_design(ROOT / "designs" / f"{name}.toml"))


def drive():
    return solved("r753ie4_drive")


def pair():
    return solved("r754ie4_balance_shafts")


def placeless():
    return solved("r753ie4_gamma")


def in_gap(results, mesh, z=0.0, turn=1, places=None):
    """How far the teeth of a mesh stand from tooth in gap, in pitches, at a distance z from the middle of the driver's
    face, in the axes of a file."""
    places, frame = places or wheel_places(results), Frame(turn)
    hands, at = results.design.gears.hands(), {}
    for name in (mesh.driver, mesh.driven):
        place = places[name]
        off = places[mesh.driver].z + z - place.z
        at[name] = frame.angle(place.tooth) + HANDS[hands[name]] * helix(results.train, name) * off
    way = places[mesh.driven].axis - places[mesh.driver].axis
    gamma = frame.angle(cmath.phase(way))
    z_1, z_2 = (results.train.wheels[name].teeth for name in (mesh.driver, mesh.driven))
    pitches = ((gamma - at[mesh.driver]) * z_1 + (gamma + math.pi - at[mesh.driven]) * z_2) / (2 * math.pi)
    return pitches % 1 - 0.5


@pytest.mark.parametrize("turn", (1, -1))
@pytest.mark.parametrize("results", (drive, pair))
def test_teeth_stand_in_gaps_over_the_whole_face(results, turn):
    """Also of an engine that turns the other way, whose wheels have the same hands: places and phases are mirrored."""
    for mesh in results().train.meshes.values():
        for z in (-0.007, 0.0, 0.007):
            assert in_gap(results(), mesh, z, turn) == pytest.approx(0.0, abs=1e-9)


def test_axes_of_shafts_are_given_or_those_of_their_wheels():
    assert shaft_axes(pair()) == {"left": -0.06 - 0.095j, "right": -0.06 + 0.095j}
    assert shaft_axes(placeless()) == {}
    axis = drive().train.layout.wheels["shaft"].position
    assert shaft_axes(drive()) == {"shaft": axis}


def test_wheels_stand_in_the_plane_of_the_shafts_wheel():
    assert set(planes_of(drive()).values()) == {drive().shaft.wheel}
    assert set(planes_of(placeless())) == set(placeless().train.wheels)


def test_a_train_of_no_known_place_has_none():
    assert wheel_places(placeless()) == {}


def test_a_wheel_in_another_plane_still_meshes():
    """Its helix has turned until there: tooth in gap where their faces meet."""
    results = drive()
    gears = results.design.gears
    wheels = tuple(replace(one, z=-0.19 if one.name == "idler" else None) for one in gears.wheels)
    moved = replace(results, design=replace(results.design, gears=replace(gears, wheels=wheels)))
    places = wheel_places(moved)
    assert places["idler"].z == -0.19 and places["shaft"].z == results.shaft.wheel
    for mesh in moved.train.meshes.values():
        assert in_gap(moved, mesh, 0.003) == pytest.approx(0.0, abs=1e-9)
