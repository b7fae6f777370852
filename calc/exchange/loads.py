# SPDX-License-Identifier: Apache-2.0
"""The loads of a design for finite elements and multi-body programs: one row a point, order by order, in the axes of
all files (`frame.py`).

a(t) = Re{â·e^{iΩt}}, Ω = order times the speed of the crank, t = 0 at the firing TDC of cylinder 1; order 0 stands
still.  What an engine does with its own speed is taken of the design itself, what its bearings and gears carry of the
design at each speed."""

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property

from ..bearings.result import BearingsResult
from ..bearings.sharing import turned_over
from ..countershaft.result import CountershaftResult
from ..design import step_inputs as h
from ..design.model import Design
from ..design.predicted import at_speed
from ..mounting.result import MountingResult
from ..mounting.wrenches import ShaftOnEngine, Variant, with_shafts
from ..sheet.record import record
from ..sheet.step import Outcome
from ..sheet.text import COMMA, Amount, Name, Text
from ..sheet.units import Metre, RevPerSecond, Watt
from ..sheet.value import recorded
from ..solve import Results, solve
from .engine_loads import HALF, about_origin, engine_rows, mount_rows, variant_of
from .frame import Frame, frame_of
from .load_rows import Book, LoadRow
from .mesh_loads import MeshForce, mesh_rows, meshes, orders_of
from .places import known_planes, shaft_axes
from .shaft_loads import ShaftAtSpeed
from .shaft_rows import ShaftRows

VARIANTS = ("half", "shaft", "scatter", "tooth")
KINDS = ("bearing", "inertia", "weight", "mesh", "engine", "mount")
STEPS, STEP, SLOWEST = 10, 50.0 / 60, 0.3  # of the speeds; 1/s; of rated speed, where idle is not known
CLOSES = 1e-9
UP = 1.0, 0.0, 0.0


@record
class Loads:
    """All rows, speed by speed.  `variant` in words; `bearings`: which values of the results their rows are;
    `left_out`: what is not in them though it might be asked; `notes`: on what some of them stand; `sums`: by what was
    added up, by how much it does not close, as a share of the largest part."""

    rows: tuple[LoadRow, ...]
    frame: Frame
    variant: Text
    bearings: tuple[Text, ...]
    left_out: tuple[Text, ...]
    notes: tuple[Text, ...]
    sums: Mapping[str, float]

    @property
    def closes(self) -> bool:
        return all(off <= CLOSES for off in self.sums.values())


def default_speeds(design: Design) -> tuple[RevPerSecond, ...]:
    """From idle to rated speed in ten equal steps, rounded to 50 rpm; rated speed itself is the last."""
    engine = design.engine
    assert engine is not None
    rated = float(engine.rated_speed)
    idle = design.mounting.idle_speed if design.mounting is not None else engine.idle_speed
    lowest = min(SLOWEST * rated if idle is None else float(idle), rated)
    steps = (lowest + (rated - lowest) * k / STEPS for k in range(STEPS))
    rounded = (STEP * math.floor(speed / STEP + 0.5) for speed in steps)
    return (*dict.fromkeys(speed for speed in rounded if 0 < speed < rated * (1 - 1e-9)), rated)


def loads(results: Results, speeds: Sequence[RevPerSecond], variant: str = "shaft") -> Loads:
    """Of a solved design with an engine, at these speeds of its crank.

    `variant` of the balancing, one of `variants(results)`: `half` without shafts, `shaft` as designed, `scatter` as
    they scatter, `tooth` one tooth off, of several shafts the worst.  Of a design without shafts it is always half."""
    with recorded(False):
        made = _AtSpeeds(results)
        rated = float(made.driven.engine.rated_speed)  # met exactly, since there it is the design itself
        at = tuple(rated if math.isclose(speed, rated, rel_tol=1e-12) else float(speed) for speed in speeds)
        name = variant_of(made.driven, variant if made.shafts else HALF)
        assert name is not None  # one of those that there are
        off = with_shafts(made.shafts).get(name) or Variant(made.driven.words[name], {})
        rows = [*engine_rows(made.book, made.driven, at)]
        if (mounted := results.result(MountingResult)) is not None:
            rows += mount_rows(made.book, mounted, name, at)
        beside: tuple[Text, ...] = ()
        if name != HALF:
            rows += made.moving(at, off)
            beside = (*made.beside_check(rated),)
        rows.sort(key=lambda row: (row.speed, KINDS.index(row.kind)))
        of = made.book
        return Loads(tuple(rows), of.frame, off.words, beside, (*of.left_out.values(),), (*of.notes.values(),), of.sums)


def variants(results: Results) -> tuple[str, ...]:
    """Those that a solved design with an engine has."""
    with recorded(False):
        driven = _AtSpeeds(results).driven
    return tuple(name for name in VARIANTS if variant_of(driven, name) is not None)


class _AtSpeeds:
    """What is asked of one design at many speeds."""

    def __init__(self, results: Results) -> None:
        self.results, self.design, self.book = results, results.design, Book(frame_of(results.design))
        e, i = results.engine.result, results.imbalance.result
        assert e is not None and i is not None
        self.of_shafts = _outcomes(results)
        self.shafts: tuple[ShaftOnEngine, ...] = h.shafts_on_engine(self.design, self.of_shafts, results.gears)
        self.driven = about_origin(self.design, e, i, self.shafts)

    def moving(self, speeds: tuple[RevPerSecond, ...], off: Variant) -> Iterator[LoadRow]:
        """Shafts and gears, at each speed of the design as it is there."""
        design, train = self.design, self.results.train
        orders = orders_of(self.book, train, speeds) if train is not None else None
        for n, speed in enumerate(speeds):
            other = solve(at_speed(design, speed, self.results.values()), compared=False)
            teeth = self._teeth(other, speed)
            for shaft in self._shafts_at(other, speed):
                of = self._rows_of(shaft, speed)
                yield from of.rows(off.off.get(shaft.name, (0.0, 0.0)), _losses(other, shaft), other.train, teeth)
            for key, force in teeth.items():
                if force is not None:
                    amounts = orders.at(key, n) if orders is not None else {}
                    yield from mesh_rows(
                        self.book, key, force, self._planes.get(force.mesh.driver, 0.0), speed, amounts
                    )

    def beside_check(self, rated: RevPerSecond) -> Iterator[Text]:
        """Of each shaft, which values of the results its bearings' rows are."""
        for shaft in self._shafts_at(self.results, rated):
            yield self._rows_of(shaft, rated).beside_check(self.results.values())

    def _rows_of(self, shaft: ShaftAtSpeed, speed: RevPerSecond) -> ShaftRows:
        mounting = self.design.mounting
        up = mounting.up if mounting is not None else UP
        return ShaftRows(self.book, speed, shaft, len(h.turning(self.design)) > 1, up)

    def _shafts_at(self, other: Results, speed: RevPerSecond) -> Iterator[ShaftAtSpeed]:
        axes = shaft_axes(other)
        for shaft in h.turning(self.design):
            own, original = (other.of_shafts.get(name, {}) for name in (shaft.name, shaft.of or shaft.name))
            result = original["countershaft"].result if "countershaft" in original else None
            if not isinstance(result, CountershaftResult):
                self._unsolved(Name(shaft.name), speed)
                continue
            bearings = own.get("bearings") or original.get("bearings")
            found = bearings.result if bearings is not None else None
            if not isinstance(found, BearingsResult):
                found = None
                if self.design.bearings is not None:
                    self.book.notes[f"rigid {shaft.name} {speed}"] = Text(
                        "the bearings of {shaft} have no solution at {speed}: the rows are those of rigid ones without "
                        "friction",
                        shaft=Name(shaft.name),
                        speed=_rpm(speed),
                    )
            elif shaft.how == "mirrors" and "bearings" in own:
                found = turned_over(found)
            yield ShaftAtSpeed(shaft, result, found, axes.get(shaft.name))

    def _teeth(self, other: Results, speed: RevPerSecond) -> dict[str, MeshForce | None]:
        gears, train = self.design.gears, other.train
        if gears is None or train is None:
            return {}
        found = meshes(train, gears.hands())
        if not found and train.meshes:
            self._unsolved(Text("the forces of the teeth"), speed)
        if nowhere := [Name(train.meshes[key].title) for key, force in found.items() if force is None]:
            self.book.left_out["layout"] = Text(
                "the forces of the teeth of {meshes}: where their wheels stand is not known (give position_mm), so "
                "that they have no direction",
                meshes=COMMA.join(nowhere),
            )
        if gears.speed is not None:
            self.book.notes["speed"] = Text("the gears turn at gears.speed_rpm at every speed of the crank")
        return found

    @cached_property
    def _planes(self) -> dict[str, Metre]:
        """Where the wheels stand along the engine."""
        planes = known_planes(self.results)
        if not planes:
            self.book.notes["plane"] = Text("where the gears stand along the engine is not known: Z of their rows is 0")
        return planes

    def _unsolved(self, what: Text, speed: RevPerSecond) -> None:
        words = Text("{what} at {speed}: there is no solution", what=what, speed=_rpm(speed))
        self.book.left_out[f"{what} {speed}"] = words


def _rpm(speed: RevPerSecond) -> Amount:
    return Amount(speed * 60, "rpm", form="g")


def _outcomes(results: Results) -> dict[str, Outcome[CountershaftResult]]:
    """Of every shaft that is solved, twins too."""
    found: dict[str, Outcome[CountershaftResult]] = {}
    for shaft in h.in_order(results.design):
        outcome = results.of_shafts.get(shaft.name, {}).get("countershaft")
        if outcome is not None and isinstance(outcome.result, CountershaftResult):
            mine: Outcome[CountershaftResult] = Outcome("countershaft", result=outcome.result)
            found |= {shaft.name: mine, **h.twins(results.design, shaft, mine)}
    return found


def _losses(other: Results, shaft: ShaftAtSpeed) -> dict[str, Watt]:
    """Of the journals as the closed balance has them, else of the bearings under what turns."""
    friction = other.friction.result
    if friction is not None and shaft.name in friction.journals:
        return {name: float(journal.friction_power) for name, journal in friction.journals[shaft.name].items()}
    found = shaft.bearings.bearings if shaft.bearings is not None else {}
    return {name: float(r.friction_power) for name, r in found.items()}
