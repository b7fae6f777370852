# SPDX-License-Identifier: Apache-2.0
"""The room that each placed wheel has: to walls, to neighbours, and to wheels that it does not mesh with."""

from typing import NamedTuple

from ...sheet.check import Check, check
from ...sheet.number import short
from ...sheet.trace import about
from ...sheet.units import Metre
from . import formulas as f
from .room import Room

USUAL = 1e-3  # m, rule of this program
SOURCE = "tip circle with its upper deviation, half the runout and the tolerance of the axis, at rest and cold"


class Clearance(NamedTuple):
    """The smallest one of a kind: "wall", "neighbour" or "wheel"."""

    g: Metre
    kind: str
    to: str


def clearances(wheel: str, places: dict[str, complex], room: Room) -> dict[str, Clearance]:
    """The smallest clearance of each kind, line by line; kinds of which there is nothing are left out."""
    p, found = places[wheel], {}
    with about(f"wheel {wheel}, room"):
        if room.walls:
            name, a, b = min(room.walls, key=lambda wall: f.wall_distance.function(p, wall[1], wall[2]))
            h = f.wall_distance(p=p, w_1=a, w_2=b)
            found["wall"] = Clearance(f.wall_clearance(h=h, r_s=room.swept[wheel]), "wall", name)
        round_ = {"neighbour": [(name, q, r) for name, q, r in room.neighbours]}
        others = [(name, q) for name, q in places.items() if name != wheel and name not in room.mates[wheel]]
        round_["wheel"] = [(name, q, room.swept[name]) for name, q in others]
        for kind, things in round_.items():
            if things:
                name, q, r = min(things, key=lambda thing: abs(thing[1] - p) - thing[2])
                c = f.axes_apart(p_1=p, p_3=q)
                found[kind] = Clearance(f.round_clearance(c=c, r_s=room.swept[wheel], r=r), kind, name)
    return found


def clearance_checks(wheel: str, found: dict[str, Clearance], order: list[str], chosen: bool) -> list[Check]:
    """Of the tightest place around a wheel.  Two wheels that come too near each other are judged once, at the later one."""
    own = [one for one in found.values() if one.kind != "wheel" or order.index(one.to) < order.index(wheel)]
    if not own:
        return []
    tight = min(own, key=lambda one: one.g)
    what = {"wall": f"wall {tight.to}", "neighbour": tight.to, "wheel": f"wheel {tight.to}"}[tight.kind]
    name, id = f"Clearance of {wheel} to {what}", f"gears.{wheel}.clearance"
    move = f"give {wheel} another place (gears.wheels.{wheel}.position_mm)" if chosen else f"move {wheel} or {what} apart"
    missing = f" by {short(-tight.g * 1e3)} mm" if tight.g < 0 else ""
    advice = f"The tip circle needs more room: {move}{missing}, or give it fewer teeth or a smaller shift."
    return [
        check(id, name, tight.g, ">=", 0.0, "mm", SOURCE, advice),
        check(f"{id}_usual", f"{name}, usual", tight.g, ">=", USUAL, "mm", "rule of this program: 1 mm", advice, kind="advice"),
    ]
