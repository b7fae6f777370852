"""Trains with known places: three spur wheels of module 1 mm on a 3-4-5 triangle."""

from dataclasses import replace

from calc.gears.inputs import Neighbour, Wall
from calc.gears.layout.solve import ShaftInTrain, layout
from tests.calc.gears.trains import mesh, r753, solved, train, wheel

AXIS = 0.050j  # 30 mm and 40 mm away from the idler: a right angle there


def at(name, teeth, place=None, **more):
    return wheel(name, teeth, 0.0, position=None if place is None else tuple(c * 1e-3 for c in place), **more)


def triangle(idler=None, walls=(), neighbours=(), meshes=None, **said):
    wheels = at("crank", 20), at("idler", 40, idler), at("shaft", 40)
    made = train(
        wheels,
        meshes or (mesh("crank", "idler"), mesh("idler", "shaft")),
        m_n=1.0,
        beta=0.0,
        ball=None,
        tool=(1.25, 0.38),
        **said,
    )
    return replace(made, walls=tuple(walls), neighbours=tuple(neighbours))


def wall(name, *ends):
    return Wall(name=name, from_=tuple(c * 1e-3 for c in ends[:2]), to=tuple(c * 1e-3 for c in ends[2:]))


def screw(name, up, side, radius):
    return Neighbour(name=name, position=(up * 1e-3, side * 1e-3), radius=radius * 1e-3)


def laid(gears, axis=None, **said):
    return layout(gears, solved(gears), {"shaft": ShaftInTrain(axis, **said)})


def verdicts(outcome):
    return {c.id.removeprefix("gears."): c.verdict for c in outcome.checks}


__all__ = ["AXIS", "at", "laid", "mesh", "r753", "screw", "solved", "train", "triangle", "verdicts", "wall", "wheel"]
