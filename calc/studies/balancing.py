# SPDX-License-Identifier: Apache-2.0
"""The balancing sheets of a design, with what the end of its line measures."""

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from ..countershaft.twins import turned_alike
from ..design.predicted import at_speed
from ..draw.balancing_sheet import at_angle, balancing_sheet, down
from ..draw.balancing_views import BalanceSheet, LineRow
from ..draw.sizes import Say, number
from ..draw.workshop_sheet import DrawnPart, WorkshopSheet
from ..exchange.frame import frame_of
from ..gears.result import ShaftTurn, TrainResult
from ..sheet.record import replace
from ..sheet.text import COMMA, EMPTY, Amount, Name, Text
from ..sheet.units import UNITS, Metre, NewtonMetre
from ..sheet.value import recorded
from ..solve import Results, solve
from .drawings import release_of, titled

if TYPE_CHECKING:
    from ..countershaft.balancing.inputs import LineCheck
    from ..countershaft.balancing.result import BalancingResult

CORNERS = 8  # of the tolerances, at the load itself: journal, seat, oil
Drag = tuple[NewtonMetre, NewtonMetre, NewtonMetre]  # least, as at the middle, most


def asked(results: Results) -> dict[str, Results]:
    """Each shaft with a balancing sheet in view, by its name."""
    return {
        name: view
        for name, view in results.views.items()
        if view.shaft is not None and view.shaft.balancing is not None
    }


def sheets(results: Results, say: Say = str, sha256: str = "") -> dict[str, WorkshopSheet]:
    """The page of each shaft that asks for one, by its name."""
    views = asked(results)
    return {
        name: _page(view, name, f"{n}/{len(views)}", say, sha256) for n, (name, view) in enumerate(views.items(), 1)
    }


def _page(view: Results, name: str, count: str, say: Say, sha256: str) -> WorkshopSheet:
    shaft, inputs = view.shaft, view.design.countershaft
    assert shaft is not None and inputs is not None
    several = len((view.viewed or view).design.shafts) > 1
    title = titled(view, name) if several else view.design.title("countershaft")
    mass = say(Text("{m} kg", m=number(shaft.mass, 2))) if shaft.mass is not None else ""
    part = DrawnPart(say(title), inputs.material, mass, count, view.design.name)
    release = release_of(view.viewed or view, sha256)
    return balancing_sheet(page_of(view, name), part, view.design.control, release, say)


def page_of(view: Results, name: str) -> BalanceSheet:
    """What stands on the page of the shaft in view."""
    shaft, inputs = view.shaft, view.design.countershaft
    assert shaft is not None and inputs is not None and shaft.balancing is not None
    radii = [hole.drill.R for hole in shaft.balancing.hole.values()]
    radii += [piece.outer_radius for piece in shaft.outline.pieces] if shaft.outline is not None else []
    return BalanceSheet(
        found=shaft.balancing,
        outline=shaft.outline,
        R=max(radii, default=2 * max(mass.radius for mass in shaft.masses)),
        turn=float(frame_of(view.design).turn),
        backwards=inputs.speed_ratio < 0,
        also=_also(view, name),
        same=_same(view, name),
        line=tuple(line_rows(view, shaft.balancing)),
    )


def _also(view: Results, name: str) -> Text:
    """The mirror images: they turn the other way, so that the shop counts the same angles on them the other way."""
    of = (view.viewed or view).design
    return COMMA.join(Name(shaft.name) for shaft in of.resolved if shaft.of == name and shaft.how == "mirrors")


def _same(view: Results, name: str) -> Text:
    """Whether the mirror images of the shaft in view, drilled, are the same part; empty where they are another one, or
    where its shape is not known."""
    shaft, train, also = view.shaft, (view.viewed or view).result(TrainResult), _also(view, name)
    if not also or shaft is None or shaft.outline is None or shaft.balancing is None:
        return EMPTY
    if turned_alike(shaft.outline, [hole.drill.angle for hole in shaft.balancing.hole.values()]) is None:
        return EMPTY
    if train is not None and name in train.shafts:
        return Text("(without its teeth {twins} is the same part)", twins=also)
    return Text("({twins} is the same part)", twins=also)


# --- the end of the line


def line_rows(view: Results, found: "BalancingResult") -> Iterator[LineRow]:
    """What is measured of the mounted shaft, and what it shall be."""
    known = [plane.permitted for plane in found.planes]
    if None not in known:
        yield LineRow(
            "unbalance",
            Text("Unbalance beyond the target, planes I / II"),
            Text("≤ {a} / {b} g·mm", a=down(known[0] or 0.0), b=down(known[1] or 0.0)),
            (
                ("front", known[0] or 0.0, "g·mm", Text("at most, front plane")),
                ("rear", known[1] or 0.0, "g·mm", Text("at most, rear plane")),
            ),
        )
    train = view.result(TrainResult)
    turned = _turned(view, train)
    if turned is not None:
        turn = float(turned.phase_error)
        angle = at_angle(turn)
        yield LineRow(
            "tooth_mark",
            Text("Angle mass to tooth mark, off the drawing"),
            Text("± {angle}, the free turn of the backlash", angle=angle),
            (("angle", turn, "°", Text("at most, either way")),),
        )
    for n, check in enumerate(found.inputs.line_checks, 1):
        band = drag(view, check)
        if band is not None:
            low, mid, high = (Amount(torque, form=".3g") for torque in band)
            rpm, T = number(UNITS["rpm"].shown(check.speed), 0), number(check.oil_temperature, 0)
            yield LineRow(
                f"drag_{n}",
                Text("Drag torque, {n} rpm, oil at {T} °C", n=rpm, T=T),
                Text("{low} … {high} N·m, middle {mid}", low=low, high=high, mid=mid),
                (
                    ("least", band[0], "N·m", Text("least")),
                    ("middle", band[1], "N·m", Text("middle")),
                    ("most", band[2], "N·m", Text("most")),
                ),
            )
    yield LineRow("end_float", Text("End float"), Text("as on the drawing"))
    yield from _backlashes(view, train)


def _turned(view: Results, train: TrainResult | None) -> ShaftTurn | None:
    """How the train turns the shaft in view: a single one, whatever it is called."""
    if train is None:
        return None
    name = view.design.countershaft.name if view.design.countershaft is not None else ""
    return train.shafts.get(name) or (next(iter(train.shafts.values())) if len(train.shafts) == 1 else None)


def drag(view: Results, check: "LineCheck") -> Drag | None:
    """The torque of the shaft's bearings at a speed of the shaft and a temperature of its oil, over those corners of
    their tolerances that have a film; None where they are not judged."""
    design, shaft = view.design, view.design.countershaft
    if design.engine is None or design.bearings is None or shaft is None:
        return None
    other = at_speed(design, check.speed / abs(shaft.speed_ratio), view.values())
    assert other.bearings is not None
    fed = replace(other.bearings, supply_temperature=check.oil_temperature)
    other = replace(other, bearings=fed, friction=None, mounting=None)
    with recorded(False):
        found = solve(other, compared=False)
    name = shaft.name
    outcome = found.view(name).outcomes.get("bearings") if name in found.views else found.outcomes.get("bearings")
    known: dict[str, Any] = getattr(outcome.result if outcome is not None else None, "bearings", {})
    if not known:
        return None
    least = middle = most = 0.0
    for bearing in known.values():
        power = float(bearing.friction_power)
        corners = getattr(getattr(bearing, "corners", None), "columns", {}).get("friction_power")
        ends = np.append(() if corners is None else corners[:CORNERS], power)
        least, middle, most = least + float(np.nanmin(ends)), middle + power, most + float(np.nanmax(ends))
    if not math.isfinite(least + most):
        return None
    omega = 2 * math.pi * check.speed
    return least / omega, middle / omega, most / omega


def _backlashes(view: Results, train: TrainResult | None) -> Iterator[LineRow]:
    """Of each mesh on the way to the shaft: what is wanted, and what a shim changes."""
    gears, shaft = view.design.gears, view.design.countershaft
    if train is None or gears is None or shaft is None or train.play is None:
        return
    wanted = wanted_backlashes(train)
    turned = _turned(view, train)
    on_way = {link.key for link in train.tree.way(turned.wheel)} if turned is not None else set(train.meshes)
    for mesh in gears.meshes:
        if mesh.key not in on_way:
            continue
        play, um = train.play[mesh.key], UNITS["µm"].shown
        key, label = f"backlash_{mesh.key}", Text("Backlash {mesh}, normal", mesh=mesh.title)
        if play.coat_backlash is not None:
            j = number(um(play.coat_backlash), 0)
            worn = ("once_worn", float(play.coat_backlash), "µm", Text("once the coat is worn; set without"))
            yield LineRow(key, label, Text("set without, on the coat; {j} µm once worn", j=j), (worn,))
            continue
        j, factor = number(um(wanted[mesh.key]), 0), float(play.backlash_per_centre)
        numbers = [
            ("wanted", wanted[mesh.key], "µm", Text("wanted")),
            ("per_centre", factor, "", Text("of it for each µm of the centres")),
        ]
        if mesh.shim_step is None:
            words = Text("{j} µm; 10 µm of the centres: {k} µm", j=j, k=number(10 * factor, 1))
        else:
            step, change = number(um(mesh.shim_step), 0), mesh.shim_step * factor
            words = Text("{j} µm; a shim of {step} µm changes {k}", j=j, step=step, k=number(um(change), 1))
            numbers.append(("per_shim", change, "µm", Text("changed by a shim of {step} µm", step=step)))
        yield LineRow(key, label, words, tuple(numbers))


def wanted_backlashes(train: TrainResult) -> dict[str, Metre]:
    """The backlash of each mesh, normal, that brings its way to the middle of the window: what tolerance, runout and
    temperature take of it, and an equal part of the room; where there is no window, as at mid-tolerance."""
    wanted = {key: float(mesh.backlash_nominal) for key, mesh in train.meshes.items()}
    drive = train.drive
    way = drive.window if drive is not None else None
    if drive is None or way is None or way.high is None:
        return wanted
    line = drive.drive.line
    meshes = [i for i in line.path(way.body) if line.links[i].key in way.taken]
    lever = {line.links[i].key: float(drive.survey.bodies.lever[i, way.body]) for i in meshes}
    room = ((way.low + way.high) / 2 - way.low) / sum(lever.values())
    for key in lever:
        wanted[key] = (way.taken[key] + room) * math.cos(train.system.base_helix_angle)
    return wanted


def shim(wanted: Metre, measured: Metre, per_centre: float, step: Metre) -> Metre:
    """What shims have to widen the centres by (less: narrow), in whole steps.

    >>> round(shim(60e-6, 40e-6, 0.684, 10e-6) * 1e6)
    30
    """
    return round((wanted - measured) / per_centre / step) * step
