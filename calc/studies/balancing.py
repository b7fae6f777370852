# SPDX-License-Identifier: Apache-2.0
"""The balancing sheets of a design, with what the end of its line measures; and the same as rows of a table."""

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from ..design.predicted import at_speed
from ..draw.balancing_sheet import at_angle, balancing_sheet, down
from ..draw.balancing_views import BalanceSheet
from ..draw.sizes import Say, number
from ..draw.workshop_sheet import DrawnPart, WorkshopSheet
from ..exchange.frame import frame_of
from ..exchange.frame import number as exact
from ..gears.result import TrainResult
from ..sheet.quantity import published
from ..sheet.record import replace
from ..sheet.text import COMMA, Amount, Name, Text
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
    title = titled(view, name) if len((view.viewed or view).design.shafts) > 1 else view.design.title("countershaft")
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
        line=tuple(line_rows(view, shaft.balancing)),
    )


def _also(view: Results, name: str) -> Text:
    """The mirror images: they turn the other way, so that the shop counts the same angles on them the other way."""
    of = (view.viewed or view).design
    return COMMA.join(Name(shaft.name) for shaft in of.resolved if shaft.of == name and shaft.how == "mirrors")


# --- the end of the line


def line_rows(view: Results, found: "BalancingResult") -> Iterator[tuple[Text, Text]]:
    """What is measured of the mounted shaft, and what it shall be."""
    known = [plane.permitted for plane in found.planes]
    if None not in known:
        yield (
            Text("Unbalance beyond the target, planes I / II"),
            Text("≤ {a} / {b} g·mm", a=down(known[0] or 0.0), b=down(known[1] or 0.0)),
        )
    train = view.result(TrainResult)
    turn = _turn(view, train)
    if turn is not None:
        angle = at_angle(turn)
        yield (
            Text("Angle mass to tooth mark, off the drawing"),
            Text("± {angle}, the free turn of the backlash", angle=angle),
        )
    for check in found.inputs.line_checks:
        band = drag(view, check)
        if band is not None:
            low, mid, high = (Amount(torque, form=".3g") for torque in band)
            rpm, T = number(UNITS["rpm"].shown(check.speed), 0), number(check.oil_temperature, 0)
            yield (
                Text("Drag torque, {n} rpm, oil at {T} °C", n=rpm, T=T),
                Text("{low} … {high} N·m, middle {mid}", low=low, high=high, mid=mid),
            )
    yield Text("End float"), Text("as on the drawing")
    yield from _backlashes(view, train)


def _turn(view: Results, train: TrainResult | None) -> float | None:
    """The free turn of the shaft's wheel by backlash."""
    name = view.design.countershaft.name if view.design.countershaft is not None else ""
    if train is None:
        return None
    turns = train.shafts
    found = turns.get(name) or (next(iter(turns.values())) if len(turns) == 1 else None)
    return None if found is None else float(found.phase_error)


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


def _backlashes(view: Results, train: TrainResult | None) -> Iterator[tuple[Text, Text]]:
    """Of each mesh on the way to the shaft: what is wanted, and what a shim changes."""
    gears, shaft = view.design.gears, view.design.countershaft
    if train is None or gears is None or shaft is None or train.play is None:
        return
    wanted = wanted_backlashes(train)
    wheel = next(
        (turn.wheel for name, turn in train.shafts.items() if name == shaft.name or len(train.shafts) == 1), None
    )
    on_way = {link.key for link in train.tree.way(wheel)} if wheel is not None else set(train.meshes)
    for mesh in gears.meshes:
        if mesh.key not in on_way:
            continue
        play, um = train.play[mesh.key], UNITS["µm"].shown
        label = Text("Backlash {mesh}, normal", mesh=mesh.title)
        if play.coat_backlash is not None:
            j = number(um(play.coat_backlash), 0)
            yield label, Text("set without, on the coat; {j} µm once worn", j=j)
            continue
        j, factor = number(um(wanted[mesh.key]), 0), play.backlash_per_centre
        if mesh.shim_step is None:
            yield label, Text("{j} µm; 10 µm of the centres: {k} µm", j=j, k=number(10 * factor, 1))
        else:
            step = number(um(mesh.shim_step), 0)
            yield (
                label,
                Text(
                    "{j} µm; a shim of {step} µm changes {k}", j=j, step=step, k=number(um(mesh.shim_step) * factor, 1)
                ),
            )


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


# --- as rows


def table_rows(results: Results) -> list[list[tuple[str, str, str]]]:
    """Blocks of (id, value, unit): of each shaft its sheet, with what is permitted, and then one of each reading."""
    blocks = []
    for name, view in asked(results).items():
        shaft = view.shaft
        assert shaft is not None and shaft.balancing is not None
        step = f"countershaft.{name}" if len(results.design.shafts) > 1 else "countershaft"
        sheet = f"{step}.balancing"
        own = published(shaft.balancing, sheet)
        readings = tuple(f"{sheet}.reading.{serial}." for serial in shaft.balancing.reading)
        permitted = published(shaft.tolerance, step) if shaft.tolerance is not None else []
        common = [v for v in own if not v.id.startswith(readings)] + [v for v in permitted if v.unit == "g·mm"]
        for block in (common, *([v for v in own if v.id.startswith(of)] for of in readings)):
            blocks.append([(v.id, exact(v.shown), v.unit) for v in block])
    return blocks
