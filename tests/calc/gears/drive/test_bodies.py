# SPDX-License-Identifier: Apache-2.0
"""The bodies of a train: against its speeds, its kinetic energy and the backlash of its meshes."""

import math
from dataclasses import replace

import numpy as np
import pytest

from calc.gears.drive.bodies import GRAVITY, counted, inertias, measured, on_line, plays_on_line
from calc.gears.drive.inputs import DragRow
from calc.gears.drive.line import ShaftBody
from calc.gears.inputs import Stage
from calc.gears.wheel import with_masses
from calc.library.catalogue import materials
from calc.sheet.errors import NoSolution
from calc.sheet.step import Outcome
from tests.calc.gears.drive.at_work import on_shaft
from tests.calc.gears.trains import SPEED, mesh, r753, solved, train, wheel


def two_shafts(**said):
    """An idler on the crank drives two equal shafts; one of its mates has another partner behind it."""
    teeth = {"crank": 40, "idler": 30, "left": 20, "right": 20, "last": 25}
    wheels = [wheel(name, z, allowance=(-20, -30)) for name, z in teeth.items()]
    meshes = (mesh("crank", "idler"), mesh("idler", "left"), mesh("idler", "right"), mesh("right", "last"))
    return train(wheels, meshes, **said)


def behind_a_chain():
    """The crank's wheel turns with a sprocket of 19 teeth, which the 38 of the nose drive."""
    stage = Stage(
        name="chain", kind="chain", driver="nose", driven="crank", driver_teeth=38, driven_teeth=19, pitch=9.525e-3
    )
    return replace(r753(), stages=(stage,))


def line_of(gears, shafts):
    found = solved(gears)
    return found, on_line(found, inertias(gears, found, shafts, materials()), materials(), shafts)


TRAINS = {"one way": r753, "two ways": two_shafts, "chain": behind_a_chain}


@pytest.mark.parametrize("gears", TRAINS.values(), ids=list(TRAINS))
def test_every_body_moves_along_the_line_of_action_as_its_wheel_turns(gears):
    """ρ along its way takes the first driver's base circle, or pitch circle, to its own: r·ω by the speeds of the train."""
    found, line = line_of(gears(), {})
    bodies = line.bodies(np.ones((1, len(line.links))), "nominal")
    first = line.first_radius * found.speeds[found.tree.first]
    for i, link in enumerate(line.links):
        assert line.radius[i] == found.wheels[link.driven].base_diameter / 2
        assert bodies.ratio[i] * first == pytest.approx(line.radius[i] * abs(found.speeds[link.driven]), rel=1e-12)
        assert line.parent[i] < i and (line.parent[i] < 0 or line.links[line.parent[i]].driven == link.driver)
        way = [line.links[k].driven for k in line.path(i)]
        assert way[-1] == link.driven and line.parent[line.path(i)[0]] == -1


@pytest.mark.parametrize("gears", TRAINS.values(), ids=list(TRAINS))
def test_the_masses_have_the_kinetic_energy_of_the_wheels(gears):
    found, line = line_of(gears(), on_shaft(5e-3))
    bodies = line.bodies(np.zeros((1, len(line.links))), "nominal")
    v = line.first_radius * 2 * math.pi * SPEED
    energy = sum(J * (2 * math.pi * found.speeds[link.driven]) ** 2 for J, link in zip(line.J, line.links))
    assert np.sum(bodies.mass * bodies.ratio**2) * v**2 == pytest.approx(energy, rel=1e-12)


def test_the_wheel_of_a_shaft_is_in_its_inertia_or_beside_it():
    steel, gears = materials()["steel"], r753()
    found = solved(gears)
    disc = found.wheels["shaft"]
    J = math.pi / 32 * steel.density * disc.face_width * disc.pitch_diameter**4
    within, beside = (inertias(gears, found, on_shaft(5e-3, x), materials())["shaft"] for x in (True, False))
    assert (within, beside) == (5e-3, pytest.approx(5e-3 + J, rel=1e-12))
    hollow = replace(gears, wheels=tuple(replace(w, bore_diameter=20e-3) for w in gears.wheels))
    bored = inertias(hollow, solved(hollow), {}, materials())["shaft"]
    assert bored == pytest.approx(J * (1 - (20e-3 / disc.pitch_diameter) ** 4), rel=1e-12)


def test_a_wheel_of_which_its_bore_leaves_nothing_has_neither_mass_nor_inertia():
    gears = replace(r753(), wheels=tuple(replace(w, bore_diameter=0.09) for w in r753().wheels))
    found = solved(gears)
    with pytest.raises(NoSolution, match="leaves nothing of its teeth"):
        inertias(gears, found, {}, materials())
    assert {w.mass for w in with_masses(Outcome("gears", result=found), gears, materials()).result.wheels.values()} == {
        None
    }


def test_backlash_lies_along_the_line_of_action():
    """j_bn/cos β_b, which is not j_bn; a chain has none."""
    found, line = line_of(behind_a_chain(), {})
    cos_beta = math.cos(found.system.base_helix_angle)
    assert 1 / cos_beta == pytest.approx(1.07, abs=0.01)
    for i, link in enumerate(line.links):
        of = found.meshes.get(link.key)
        if of is None:
            assert [line.play[corner][i] for corner in ("least", "nominal", "most")] == [0.0] * 3
        else:
            assert line.play["nominal"][i] == pytest.approx(of.backlash_nominal / cos_beta, rel=1e-12)
            assert line.play["most"][i] == pytest.approx(of.play_angle * line.radius[i], rel=1e-12)
            assert line.play["least"][i] == pytest.approx(of.backlash_min / cos_beta, rel=1e-12)
            assert line.play["least"][i] < line.play["nominal"][i] < line.play["most"][i]
    again = plays_on_line(found, line)
    assert again == {corner: pytest.approx(line.play[corner], rel=1e-12) for corner in again}


@pytest.mark.parametrize("angle", [0.0, 40.0, 90.0, -130.0])
@pytest.mark.parametrize("ratio", [1.0, -1.0, -2.0])
def test_gravity_turns_a_shaft_by_where_its_mass_stands(angle, ratio):
    """Its moment about the axis, along its own sense: + past the top, on the side to which it falls."""
    U, degree = 0.0108, math.pi / 180
    _, line = line_of(r753(), {"shaft": ShaftBody(5e-3, True, U, angle * degree, ratio)})
    i = line.index("idler_shaft")
    r_b, G = line.radius[i], line.gravity[i]
    for epsilon in np.linspace(0, 4 * math.pi, 7):
        stands = angle * degree + ratio * epsilon  # from up, in the sense of the crank
        falls = U * GRAVITY * math.sin(stands) * math.copysign(1.0, ratio)  # in its own sense
        turns = (G * np.exp(1j * line.gravity_order[i] * epsilon)).real * r_b
        assert turns == pytest.approx(falls, abs=1e-12)
    assert abs(G) * r_b == pytest.approx(0.106, abs=0.0005)  # N·m, of 10.8 kg·mm
    assert all(line.gravity[k] == 0 for k in range(len(line.links)) if k != i)


def test_gravity_that_is_little_beside_the_drag_is_not_counted():
    _, line = line_of(r753(), {"shaft": ShaftBody(5e-3, True, 0.0108)})
    i = line.index("idler_shaft")
    drag = np.zeros(len(line.links))
    assert counted(line, drag).gravity == line.gravity
    for share, there in ((99.0, True), (101.0, False)):
        drag[i] = share * abs(line.gravity[i])
        left = counted(line, drag)
        assert bool(left.gravity[i]) is there
        assert (left.bodies(drag[None], "nominal").gravity is not None) is there


def test_rows_of_a_measured_drag():
    said = [("a", 20.0, 0.6), ("a", 10.0, 0.2), ("b", 10.0, 1.0)]
    rows = [DragRow(wheel=name, speed=n, torque=T) for name, n, T in said]
    found = measured(rows, "a", np.array([5.0, 10.0, 15.0, 20.0, 40.0]))
    assert found.tolist() == pytest.approx([0.2, 0.2, 0.4, 0.6, 0.6])
    assert measured(rows, "b", np.array([5.0, 40.0])).tolist() == [1.0, 1.0]
    assert measured(rows, "c", np.array([5.0])) is None
