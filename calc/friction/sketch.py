# SPDX-License-Identifier: Apache-2.0
"""Where the watts go, as a sketch: what the train takes in flows to the right and parts into its losses, as wide as
they are large."""

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from ..countershaft.rows import called, row_key
from ..draw.drawing import OUTLINE, WORDS, Area, Mark, Point, Polyline, Sketch, State, Words, awaited, judged
from ..gears.inputs import GearsInputs
from ..sheet.quantity import dotted
from ..sheet.record import record
from ..sheet.text import Amount, Name, Text
from ..sheet.units import Number, Watt
from .result import FrictionResult

if TYPE_CHECKING:
    from ..design.model import Design
    from ..solve import Results

SMALL: Number = 0.01  # of the sum: smaller losses stand together
THIN: Number = 0.04  # of the sum: meshes that each lose less stand together
WIDE, HIGH = 1.0, 0.62  # of the flow's length: that length, and the width of the sum
SPREAD: Number = 0.3  # room between the losses, all of it together
STRAIGHT: Number = 0.25  # of the length: before the losses part
CORNERS = 24
SHADES = (0.55, 0.4)  # in turn, so that neighbours are told apart


@record
class Loss:
    """Where some of the power goes."""

    name: Text
    power: Watt
    key: str = ""
    state: State = ""


def sketch(design: "Design", results: "Results") -> Sketch:
    """The losses of a design's train, those of the meshes first."""
    outcome = results.outcomes["friction"]
    result = outcome.result
    if design.friction is None or not isinstance(result, FrictionResult):
        return awaited(outcome)
    checks = tuple(outcome.checks)
    meshes = [
        Loss(
            Name(mesh.case.mesh.title),
            mesh.judged.loss,
            dotted("gears", GearsInputs.meshes, n),
            judged(checks, f"friction.{name}"),
        )
        for n, (name, mesh) in enumerate(result.meshes.items())
    ]
    losses = _together(meshes, result.total_loss)
    for name, stage in result.stages.items():
        losses.append(Loss(Name(name), stage.loss, dotted("gears", GearsInputs.stages, name)))
    for shaft, journals in result.journals.items():
        for place, journal in journals.items():
            words = Text("{place} bearing", place=called(place))
            if len(result.journals) > 1:
                words = Text("{shaft}, {what}", shaft=Name(shaft), what=words)
            state = judged(checks, f"friction.{place}")
            losses.append(Loss(words, journal.friction_power, row_key(place), state))
    losses += [
        Loss(Text("turning masses"), result.mass_loss or 0.0),
        Loss(Text("windage"), result.windage_loss or 0.0),
        Loss(Text("churning"), result.churning_loss or 0.0),
        Loss(Text("oil thrown on"), result.thrown_oil_loss or 0.0),
        Loss(Text("shaft seals"), result.seal_loss or 0.0),
        Loss(Text("wheel bearings"), result.wheel_bearing_loss or 0.0),
        Loss(Text("others"), result.other_loss),
    ]
    shown = _shown(losses, result.total_loss)
    if not shown:
        return Sketch(notes=(Text("Nothing is lost."),))
    notes = [Text("widths to scale")]
    if result.delivered_power:
        notes.append(Text("beside {power} passed on", power=_watts(result.delivered_power)))
    return Sketch(tuple(_flow(shown, result.total_loss)), tuple(notes), title=Text("all of it becomes heat in the oil"))


def _shown(losses: list[Loss], total: Watt) -> list[Loss]:
    """Those that are wide enough to be seen, and the others as one."""
    large = [loss for loss in losses if loss.power >= SMALL * total and loss.power > 0]
    small = [loss for loss in losses if 0 < loss.power < SMALL * total]
    return large + (small if len(small) < 2 else [Loss(Text("rest"), sum(loss.power for loss in small))])


def _together(meshes: list[Loss], total: Watt) -> list[Loss]:
    """All meshes as one where each alone is a thin line."""
    if len(meshes) < 2 or any(mesh.power > THIN * total or mesh.state for mesh in meshes):
        return meshes
    name = Text("{count} meshes", count=len(meshes))
    return [Loss(name, sum(mesh.power for mesh in meshes), dotted("gears", GearsInputs.meshes))]


def _flow(losses: list[Loss], total: Watt) -> Iterator[Mark]:
    scale = HIGH / total
    gap = SPREAD / max(1, len(losses) - 1)
    inlet, outlet = HIGH / 2, (HIGH + SPREAD * (len(losses) > 1)) / 2
    yield Polyline(OUTLINE, ((0.0, inlet), (0.0, -inlet)))
    for n, loss in enumerate(losses):
        width = loss.power * scale
        upper, lower = _band(inlet, outlet), _band(inlet - width, outlet - width)
        yield Area(OUTLINE, ((*upper, *reversed(lower)),), SHADES[n % 2], loss.key, loss.state)
        yield Polyline(OUTLINE, upper, key=loss.key, state=loss.state)
        yield Polyline(OUTLINE, lower, key=loss.key, state=loss.state)
        text = Text("{power}  {name}", power=_watts(loss.power), name=loss.name)
        yield Words(WORDS, (WIDE * 1.05, outlet - width / 2), text, key=loss.key, state=loss.state)
        inlet, outlet = inlet - width, outlet - width - gap
    yield Words(WORDS, (STRAIGHT * 0.55, 0.0), _watts(total), side="centre")


def _band(start: Number, end: Number) -> tuple[Point, ...]:
    """An edge of a flow: straight at first, then in a smooth curve to where it ends."""
    ways = [n / CORNERS for n in range(CORNERS + 1)]
    bend = (
        (STRAIGHT + (WIDE - STRAIGHT) * way, start + (end - start) * (1 - math.cos(math.pi * way)) / 2) for way in ways
    )
    return (0.0, start), *bend


def _watts(power: Watt) -> Text:
    if power >= 1000:
        return Text("{power}", power=Amount(power / 1000, "kW", digits=3))
    return Text("{power}", power=Amount(power, "W", form=".0f") if power >= 10 else Amount(power, "W", digits=2))
