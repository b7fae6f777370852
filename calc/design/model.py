# SPDX-License-Identifier: Apache-2.0
"""A design: the Inputs of its steps in order.  A further step is one new folder, two adjacent lines here and its call
in solve.py."""

from collections import Counter
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import field
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar

from ..bearings.inputs import OF_ROWS, BearingsInputs
from ..bearings.plain.materials import application_problem, applications, bushes
from ..countershaft.inputs import ShaftInputs, ShaftLoad
from ..countershaft.making.inputs import Bolts
from ..countershaft.rows import SHAFT, BearingRow, said_in
from ..countershaft.twins import Resolved, resolved
from ..engine.inputs import EngineInputs
from ..engine.operation import Operation
from ..friction.inputs import FrictionInputs, Scenario, Seal
from ..gears.inputs import ONLY, GearsInputs
from ..gears.wheel_inputs import Wheel
from ..imbalance.inputs import ImbalanceInputs
from ..library.catalogue import Material, Oil, materials, oils
from ..measurements.fit_inputs import FitInputs, fit_problems
from ..measurements.inputs import Condition, MeasuredColumn, Measurement
from ..mounting.inputs import RESERVED, MountingInputs
from ..sheet.inputs_at import content_at
from ..sheet.quantity import (
    Quantity,
    day,
    dotted,
    given,
    inputs,
    integer,
    keys,
    meant,
    reasons,
    table,
    tables,
    text,
    unknown,
)
from ..sheet.record import replace
from ..sheet.step import OF_SHAFTS, Step
from ..sheet.text import Amount, Small, Text, listed
from .other_tables import FORMER, DocumentControl, Measured, OptimiseInputs, Requirement, control, said_twice

if TYPE_CHECKING:
    from ..measurements.rows import RunRows  # which only a design with runs loads

SCHEMA = 2

STEPS = (
    Step("engine", Text("Engine"), EngineInputs),
    Step("imbalance", Text("Imbalance"), ImbalanceInputs),
    Step("countershaft", Text("Counter-shaft"), ShaftInputs),
    Step("bearings", Text("Bearings"), BearingsInputs),
    Step("gears", Text("Gears"), GearsInputs),
    Step("friction", Text("Friction"), FrictionInputs),
    Step("mounting", Text("Mounting"), MountingInputs, optional=True),
)
STEP_KEYS = tuple(step.key for step in STEPS)
TITLES = {step.key: step.title for step in STEPS}
IN_SENTENCES = {key: Small(title) for key, title in TITLES.items()}
STEP_LIST = ", ".join(STEP_KEYS)
OPTIONAL = {step.key for step in STEPS if step.optional}  # of which nothing is said in a design without them
NEEDS_ENGINE = Text("needed where there is no [engine] table to take it from")
Problems = Iterable[tuple[str, Text]]  # keys, each with what is wrong there
MOST_SHAFTS = 4
JUDGED = Text("is for bearings that are judged: add [bearings], or leave it out")
CARRIED = Text("is carried by the balance that [bearings] begin: add that table, or leave it out")
# of a bearing that [bearings] does not judge
SCREENED = (
    "name", "position", "kind", "diameter", "length", "carrier_bore", "carrier", "offset",
    "size", "elements", "bore", "outside_diameter", "width",
)  # fmt: skip


@inputs
class Design:
    """Everything that a design file says, checked and in SI."""

    REFUSED: ClassVar[dict[str, Text]] = {"countershaft": Text("[countershaft] is [[shafts]] since schema 2")}

    schema: int = integer("Schema", within=(1, SCHEMA))
    name: str = text("Name of the design")
    note: str = text("Note", default="")
    author: str = text("Author", default="")
    checker: str = text("Checker", default="")
    revision: str = text("Revision", default="")
    date: str = day("Date", default="", free=True)
    document: DocumentControl | None = table("Document", DocumentControl, default=None)
    oil: tuple[Oil, ...] = tables("Oils of this design", Oil, default=())
    material: tuple[Material, ...] = tables("Materials of this design", Material, default=())
    engine: EngineInputs | None = table("Engine", EngineInputs, default=None)
    imbalance: ImbalanceInputs | None = table("Imbalance", ImbalanceInputs, default=None)
    shafts: tuple[ShaftInputs, ...] = tables("Balance shafts", ShaftInputs, default=())
    bearings: BearingsInputs | None = table("Bearings", BearingsInputs, default=None)
    gears: GearsInputs | None = table("Gears", GearsInputs, default=None)
    friction: FrictionInputs | None = table("Friction", FrictionInputs, default=None)
    mounting: MountingInputs | None = table("Mounting", MountingInputs, default=None)

    accepted: tuple[tuple[str, str], ...] = reasons(
        "Accepted findings",
        help="Ids of checks that are left open, each with the reason; a limit can be accepted by nobody.",
    )

    without: tuple[tuple[str, str], ...] = reasons(
        "Steps left out",
        help="Steps that this design does without, each with the reason: an idler shared with the pump, no shaft "
        "needed.",
    )
    locked: tuple[tuple[str, str], ...] = reasons(
        "Locked inputs",
        help="Keys that no remedy and no search may change, each with the reason. Left out: the oil, which is the "
        "engine's.",
    )

    optimise: OptimiseInputs | None = table(
        "Search for whole drives",
        OptimiseInputs,
        default=None,
        help="What `contralbero design` varies and wants; no step asks for it.",
    )

    requirements: tuple[Requirement, ...] = tables(
        "Requirements", Requirement, default=(), help="What is asked of the design, and who asks; the report prints it."
    )

    measured: tuple[Measured, ...] = tables(
        "Measured", Measured, default=(), help="What was measured of this design; it stands beside what is predicted."
    )

    measurements: tuple[Measurement, ...] = tables(
        "Measurements",
        Measurement,
        default=(),
        help="Runs of the bench, each in a file beside the design; they stand on top of what is predicted over speed.",
    )

    fits: tuple[FitInputs, ...] = tables(
        "Fits",
        FitInputs,
        default=(),
        help="Inputs that `contralbero fit` finds from runs of the bench; no step asks for them.",
    )

    # what the files of the measurements hold, read with the design
    runs: "tuple[RunRows, ...]" = field(default=(), kw_only=True, repr=False)

    @property
    def checked_later(self) -> frozenset[str]:
        """The ids of checks that are made when somebody asks for them: of the columns of runs."""
        return frozenset(id for run in self.measurements for id in run.column_ids)

    @property
    def countershaft(self) -> ShaftInputs | None:
        """The shaft of the design that is no twin, with whether one mirrors it; None where only bearings are asked."""
        own = self.own
        return None if own is None or own.mode == "bearings" else own

    @cached_property
    def own(self) -> ShaftInputs | None:
        """The shaft that is no twin."""
        own = next((shaft for shaft in self.shafts if not shaft.is_twin), None)
        if own is None or not any(shaft.mirrors == own.name for shaft in self.shafts):
            return own
        return replace(own, paired=True)

    @property
    def own_name(self) -> str:
        """The name of the shaft that is no twin; empty where there is none."""
        return next(iter(self.originals), "")

    @cached_property
    def resolved(self) -> tuple[Resolved, ...]:
        """All shafts, each with its inputs as they are."""
        return resolved(self.shafts)

    @cached_property
    def views(self) -> "dict[str, Design]":
        """The design with one of its shafts alone, and the twins of that, by the name of each that is no twin."""
        originals = self.originals
        if len(originals) == 1:
            return {originals[0]: self}
        return {
            name: replace(self, shafts=tuple(s for s in self.shafts if name in (s.name, s.mirrors, s.repeats)))
            for name in originals
        }

    def with_bearings_of(self, twin: str) -> "Design":
        """The design with a twin alone, as a shaft that is none."""
        return replace(self, shafts=tuple(shaft.inputs for shaft in self.resolved if shaft.name == twin))

    @cached_property
    def originals(self) -> tuple[str, ...]:
        """The names of the shafts that are no twins."""
        return tuple(shaft.name for shaft in self.shafts if not shaft.is_twin)

    def shaft_of(self, id: str) -> str:
        """The name of the shaft, no twin, that a key or the id of a value or a check is of; empty where it is of none,
        or of all."""
        step, _, rest = id.partition(".")
        name = rest.partition(".")[0]
        named = step == dotted(Design.shafts) or (len(self.shafts) > 1 and step in OF_SHAFTS)
        return name if named and name in self.originals else ""

    def of_original(self, id: str) -> str:
        """The key or the id that a twin has of its original; the same where it is of no twin."""
        step, _, rest = id.partition(".")
        name, dot, rest = rest.partition(".")
        twin = next((shaft for shaft in self.shafts if shaft.name == name and shaft.is_twin), None)
        if twin is None or step not in (dotted(Design.shafts), *OF_SHAFTS):
            return id
        return f"{step}.{twin.mirrors or twin.repeats}{dot}{rest}"

    def ids_of(self, step: str, shaft: str) -> str:
        """How the ids of a step of one of its shafts begin."""
        return f"{step}.{shaft}" if len(self.shafts) > 1 else step

    @property
    def renamed(self) -> bool:
        """Whether any value or check of this design was called otherwise."""
        wheels = self.gears.wheels if self.gears is not None else ()
        return len(self.shafts) > 1 == len(self.originals) or any(wheel.former_name for wheel in wheels)

    def former_id(self, id: str) -> str:
        """What a value or check of the one shaft that is no twin was called while its name stood in no id, and what one
        of a wheel was while that had another name; the id itself where nothing of it was otherwise."""
        step, _, rest = id.partition(".")
        if step in OF_SHAFTS and len(self.shafts) > 1 == len(self.originals):
            id = f"{step}.{rest.removeprefix(f'{self.own_name}.')}"
        return self.gears.former_id(id) if self.gears is not None else id

    @property
    def rows(self) -> tuple[BearingRow, ...]:
        """Its bearings, front to rear."""
        return self.own.bearings if self.own is not None else ()

    def with_shaft(self, shaft: ShaftInputs) -> "Design":
        """The same with another shaft in the place of its own."""
        shaft = replace(shaft, paired=False)
        return replace(self, shafts=tuple(shaft if there.name == shaft.name else there for there in self.shafts))

    @property
    def oils(self) -> Mapping[str, Oil]:
        return oils(self.oil)

    @property
    def control(self) -> DocumentControl:
        return control(self.document, self._former)

    @property
    def _former(self) -> Mapping[str, str]:
        return {key: getattr(self, key) for key in FORMER}

    @property
    def materials(self) -> Mapping[str, Material]:
        return materials(self.material)

    @property
    def bushes(self) -> tuple[str, ...]:
        return bushes()

    @property
    def strength_classes(self) -> tuple[str, ...]:
        from ..gears.rating.classes import class_names

        return class_names()

    @property
    def applications(self) -> tuple[str, ...]:
        return tuple(applications())

    def runs_of(self, fit: FitInputs) -> list[str]:
        """The names of the runs that it is of."""
        return [run.name for run in self.measurements if fit.of is None or run.name in fit.of]

    def title(self, step: str) -> Text:
        """What a step is called in this design."""
        return Text("Balance shafts") if step == "countershaft" and len(self.shafts) > 1 else TITLES[step]

    def asked(self) -> tuple[Step, ...]:
        return tuple(s for s in STEPS if getattr(self, s.key) is not None)

    def step_of(self, key: str) -> str:
        """The step that a key is of, or the id of a value or a check: those of a shaft are the counter-shaft's, but for
        the bearings of one that [bearings] judges."""
        return step_of(key, judged=self.bearings is not None)

    def own_key(self, *parts: object) -> str:
        """The key of an input of its own shaft, by the declared field."""
        return dotted(Design.shafts, self.own.name if self.own is not None else "S", *parts)

    def as_in_rules(self, key: str) -> str:
        """A key of this design as rules and pictures spell it: shafts.S for its only own shaft."""
        own = f"{self.own_key()}."
        if len(self.views) > 1:
            return key
        return f"{SHAFT}.{key.removeprefix(own)}" if key.startswith(own) else key

    def in_place(self, key: str) -> tuple[str, ...]:
        """The keys of this design that the key of a rule stands for: shafts.S is each shaft that is no twin, bearings.*
        each of that shaft's bearings."""
        if not f"{key}.".startswith(f"{SHAFT}.") or self.own is None:
            return (key,)
        if len(self.originals) > 1:
            return tuple(each for view in self.views.values() for each in view.in_place(key))
        key = f"{self.own_key()}{key.removeprefix(SHAFT)}"
        each = f"{self.own_key(ShaftInputs.bearings)}.*"
        if not key.startswith(each):
            return (key,)
        return tuple(f"{self.own_key(ShaftInputs.bearings, row.name)}{key.removeprefix(each)}" for row in self.rows)

    def in_twin(self, twin: Resolved) -> Callable[[str], tuple[str, ...]]:
        """The same of the bearings of a twin: what it says of them itself by its own keys, the rest by those of its
        original."""
        view, said = self.with_bearings_of(twin.name), self.said_by(twin)
        mine, theirs = (f"{dotted(Design.shafts, name)}." for name in (twin.name, twin.of))

        def whose(key: str) -> str:
            return theirs + key.removeprefix(mine) if key.startswith(mine) and key not in said else key

        return lambda key: tuple(map(whose, view.in_place(key)))

    def said_by(self, twin: Resolved) -> frozenset[str]:
        """The keys of what a twin says of its bearings itself."""
        rows = dotted(Design.shafts, twin.name, ShaftInputs.bearings)
        return frozenset(dotted(rows, row.name, entry) for row in twin.rows for entry in said_in(row))

    def given(self, step: str) -> Iterator[tuple[str, Quantity, Any]]:
        """The inputs of a step that are not left out, without what twins say of their bearings: key with the names of
        elements, description, content in SI."""
        tables: list[tuple[str, object]] = [] if step == "countershaft" else [(step, getattr(self, step))]
        if step in ("countershaft", "bearings"):
            for shaft in self.shafts:
                alone = replace(shaft, bearings=()) if shaft.is_twin else shaft
                tables.append((dotted(Design.shafts, shaft.name), alone))
        for way, there in tables:
            if there is not None:
                yield from (row for row in given(there, way, named=True) if self.step_of(row[0]) == step)

    def problems(self) -> Problems:
        """What only the whole design can show: (key, reason)."""
        if not self.asked():
            known = ", ".join(f"[{key}]" for key in STEP_KEYS)
            yield "", Text("no step is asked: give at least one of the tables ") + known
        yield from said_twice(self.document, self._former)
        yield from self._reasons()
        yield from self._measured()
        yield from self._measurements()
        yield from self._fits()
        yield from self._names()
        if self.engine is not None:
            yield from self._cranks(self.engine)
        twins = list(self._twins())
        yield from twins or self._shares()
        for n, shaft in enumerate(self.shafts):
            rows = [(dotted(Design.shafts, n, ShaftInputs.bearings, i), row) for i, row in enumerate(shaft.bearings)]
            if shaft.is_twin:
                yield from self._twin_rows(shaft, rows)
            else:
                yield from self._rows(rows)
                yield from _within(dotted(Design.shafts, n), self._shaft(shaft))
        if self.bearings is not None:
            yield from self._bearings(self.bearings)
        if self.mounting is not None:
            yield from self._mounting(self.mounting)
        if self.friction is not None:
            yield from _within("friction", self._friction(self.friction))
            for n, shaft in enumerate(self.shafts if self.bearings is None else ()):
                if shaft.loads:
                    yield dotted(Design.shafts, n, ShaftInputs.loads), CARRIED
        if self.gears is not None:
            yield from _within("gears", self._gears(self.gears))

    def _reasons(self) -> Problems:
        """Of what is accepted, locked and left out: whether there is such a thing, and whether that can be."""
        for key, _ in self.locked:
            if key not in STEP_KEYS and (wrong := _no_key(key)) is not None:
                yield f"locked.{key}", wrong
        for step, _ in self.without:
            if step not in STEP_KEYS:
                yield f"without.{step}", Text("is no step; there are {steps}", steps=STEP_LIST)
            elif getattr(self, step) is not None:
                yield f"without.{step}", Text("is a step of this design: take the table out, or this line")

    def _measured(self) -> Problems:
        for n, row in enumerate(self.measured):
            if self.step_of(row.value) not in STEP_KEYS:
                must = Text("must be the id of a value or the key of an input of a step: {steps}", steps=STEP_LIST)
                yield dotted(Design.measured, n, Measured.value), must
            if row.speed is not None and self.engine is None:
                other = Text("is that of the engine: leave it out where there is no [engine] table")
                yield dotted(Design.measured, n, Measured.speed), other

    def _measurements(self) -> Problems:
        """Whether what was measured, and what the conditions set, may be values and inputs of this design; whether a
        value is there only its results say."""
        if self.measurements and self.engine is None:
            needs = Text("are over the speed of the engine: add [engine], or take them out")
            yield dotted(Design.measurements), needs
        must = Text("must be the id of a value or the key of an input of a step: {steps}", steps=STEP_LIST)
        for n, run in enumerate(self.measurements):
            here = dotted(Design.measurements, n)
            for i, condition in enumerate(run.conditions):
                about = content_at(self, condition.key)[1]
                key = dotted(here, Measurement.conditions, i, Condition.key)
                if about is None or about.kind != "number" or self.step_of(condition.key) not in STEP_KEYS:
                    yield key, Text("must be the key of an input of this design that is a number")
            for i, column in enumerate(run.columns):
                if any(self.step_of(id) not in STEP_KEYS for id in column.value):
                    yield dotted(here, Measurement.columns, i, MeasuredColumn.value), must

    def _fits(self) -> Problems:
        """Of each fit its runs and its inputs, which are those of steps."""
        tables: list[tuple[str, object]] = [(step, getattr(self, step)) for step in STEP_KEYS if step != "countershaft"]
        tables += [(dotted(Design.shafts, shaft.name), shaft) for shaft in self.shafts if not shaft.is_twin]
        for n, fit in enumerate(self.fits):
            yield from _within(dotted(Design.fits, n), fit_problems(fit, self.measurements, tables))

    def _names(self) -> Problems:
        """Oils and materials that are named and not there, and wheels that lose power and are not there."""
        catalogues: Mapping[str, Collection[str]] = {"oils": self.oils, "materials": self.materials}
        tables = [(step, getattr(self, step)) for step in STEP_KEYS if step != "countershaft"]
        tables += [(dotted(Design.shafts, n), shaft) for n, shaft in enumerate(self.shafts)]
        for way, there in tables:
            for key, about, name in given(there, way) if there is not None else ():
                if about.catalogue in catalogues and name not in catalogues[about.catalogue]:
                    yield key, _unknown_name(name, catalogues[about.catalogue])
        wheels = list(self.gears.along) if self.gears is not None else []
        if self.friction is not None and self.gears is not None:
            for kind in ("seals", "rolling_bearings", "plain_bearings", "dips", "jets", "other_losses"):
                for i, entry in enumerate(getattr(self.friction, kind)):
                    if entry.wheel is not None and entry.wheel not in wheels:
                        yield dotted(Design.friction, kind, i, Seal.wheel), _unknown_name(entry.wheel, wheels)
        turn = [shaft.name for shaft in self.shafts if shaft.mode != "bearings"]
        for n, shaft in enumerate(self.shafts):
            for name in (shaft.bolts.carries or ()) if shaft.bolts is not None else ():
                if name not in turn:
                    yield dotted(Design.shafts, n, ShaftInputs.bolts, Bolts.carries), _unknown_name(name, turn)
            for i, load in enumerate(shaft.loads):
                if load.wheel is not None and load.wheel not in wheels:
                    key = dotted(Design.shafts, n, ShaftInputs.loads, i, ShaftLoad.wheel)
                    yield key, _unknown_name(load.wheel, wheels)

    def _cranks(self, engine: EngineInputs) -> Problems:
        """Whether crank angles, firing order and crank bodies are those of one crank."""
        if engine.crank_angles is not None and engine.firing_order is not None:
            from ..engine.crank import not_fired  # brings numpy with it

            if reason := not_fired(engine):
                yield dotted(Design.engine, EngineInputs.firing_order), reason
        if self.imbalance is not None and self.imbalance.crank_bodies:
            yield from _within("imbalance", self._crank_bodies(self.imbalance, engine))

    def _crank_bodies(self, imbalance: ImbalanceInputs, engine: EngineInputs) -> Problems:
        pins = sum(body.pin is not None for body in imbalance.crank_bodies)
        there = engine.cylinders
        if engine.layout != "inline":  # cylinders of two banks may share a pin
            from ..engine.crank import crank, pin_of_cylinder

            there = int(pin_of_cylinder(engine, crank(engine, 0.0)).max()) + 1
        if pins and pins != there:
            have = Text("have {pins} crankpins; the throws of this engine stand on {there}", pins=pins, there=there)
            yield dotted(ImbalanceInputs.crank_bodies), have
        if imbalance.crank_bodies_throw_at_tdc > engine.cylinders:
            must = Text("must be a cylinder of this engine, from 1 to {cylinders}", cylinders=engine.cylinders)
            yield dotted(ImbalanceInputs.crank_bodies_throw_at_tdc), must

    def _twins(self) -> Problems:
        """Whether every twin is one of an earlier shaft, and every shaft has an axis of its own."""
        if len(self.shafts) > MOST_SHAFTS:
            most = Text("at most {n} shafts", n=MOST_SHAFTS)
            yield dotted(Design.shafts, MOST_SHAFTS), most
        own: list[str] = []
        for n, shaft in enumerate(self.shafts):
            if not shaft.is_twin:
                own.append(shaft.name)
                continue
            field = ShaftInputs.mirrors if shaft.mirrors is not None else ShaftInputs.repeats
            key, name = dotted(Design.shafts, n, field), shaft.mirrors or shaft.repeats or ""
            if name == shaft.name:
                yield key, Text("is the shaft itself; name an earlier one")
            elif name in [other.name for other in self.shafts[:n] if other.is_twin]:
                yield key, Text("is a twin itself; name the shaft that it is a twin of")
            elif name in [other.name for other in self.shafts[n + 1 :]]:
                yield key, Text("stands below; a twin comes behind its original")
            elif name not in own:
                yield key, _unknown_name(name, own)
            elif next(other for other in self.shafts if other.name == name).mode == "bearings":
                yield key, Text("asks its bearings alone: there is nothing that turns to be a twin of")
        yield from self._axes()

    def _shares(self) -> Problems:
        """Of the shafts of one ratio that are sized; a twin takes its original's."""
        own = {s.name: s for s in self.shafts if not s.is_twin and s.mode == "size" and s.speed_ratio is not None}
        sized = [
            (-original.speed_ratio if shaft.mirrors is not None else original.speed_ratio, original)
            for shaft in self.shafts
            if (original := own.get(shaft.mirrors or shaft.repeats or shaft.name)) is not None
        ]
        alike = Counter(ratio for ratio, _ in sized)
        taken = dict.fromkeys(alike, 0.0)
        for ratio, original in sized:
            most = max(alike[other] for other, one in sized if one is original)
            taken[ratio] += original.share or 1 / most
        for n, shaft in enumerate(self.shafts):
            together = max((taken[ratio] for ratio, original in sized if original is shaft), default=0.0)
            if shaft.share is not None and together > 1 + 1e-9:
                whole = Text(
                    "the sized shafts of one ratio, twins counted, take {together} of what they are for, more than all",
                    together=Amount(together * 100, "%", form=".4g"),
                )
                yield dotted(Design.shafts, n, ShaftInputs.share), whole

    def _axes(self) -> Problems:
        """Two shafts about one axis; a mirror image that lies on its original is judged, since both may be meant to be
        given their place later."""
        placed: dict[tuple[float, ...], str] = {}
        for n, shaft in enumerate(self.shafts):
            if shaft.axis is None:
                continue
            if (other := placed.get(shaft.axis)) is not None and shaft.mirrors != other:
                yield dotted(Design.shafts, n, ShaftInputs.axis), Text("is that of {name} too", name=other)
            placed.setdefault(shaft.axis, shaft.name)

    def _rows(self, rows: list[tuple[str, BearingRow]]) -> Problems:
        """What each bearing of a shaft needs: all of it where [bearings] judges its film; else its place, and a size
        for all of them or for none."""
        for key, row in (rows[0], rows[-1]) if rows else ():
            if row.offset is not None:
                line = Text("the outer two bearings define the line that the others are off")
                yield dotted(key, BearingRow.offset), line
        if self.bearings is None:
            for key, row in rows:
                given = [getattr(row, keys(BearingRow)[own].attribute) is not None for own in row.size_keys()]
                if row.sized != rows[0][1].sized or (any(given) and not all(given)):
                    alike = Text("give diameter and length of all bearings, or of none")
                    yield dotted(key, row.size_keys()[0]), alike
                    break
            for key, row in rows:
                for entry in keys(BearingRow).values():
                    if entry.attribute not in SCREENED and getattr(row, entry.attribute) != entry.field.default:
                        yield f"{key}.{entry.key}", JUDGED
            return
        for key, row in rows:
            yield from _within(key, self.bearings.asked_of(row))
            if row.fed():
                yield from self._seat(self.bearings, key, row)
        yield from self._locating(rows)
        if len(rows) > 2 and self.bearings.load_speed_ratio != 1:
            turning = Text("must be 1 on a shaft with more than two bearings, which share what turns with it")
            yield dotted(Design.bearings, BearingsInputs.load_speed_ratio), turning

    def _locating(self, rows: list[tuple[str, BearingRow]]) -> Problems:
        """One bearing of a shaft takes its thrust."""
        for key, _ in [(key, row) for key, row in rows if row.locates][1:]:
            yield dotted(key, BearingRow.locates), Text("another bearing of this shaft locates it already")

    def _twin_rows(self, twin: ShaftInputs, rows: list[tuple[str, BearingRow]]) -> Problems:
        """The rows of a twin: whether its original has such a bearing, and what is wrong of that as the twin has it."""
        original = next((shaft for shaft in self.shafts if shaft.name == (twin.mirrors or twin.repeats)), None)
        if original is None:
            return
        there = {row.name: row for row in original.bearings}
        for key, row in rows:
            if row.name not in there:
                yield dotted(key, BearingRow.name), _unknown_name(row.name, there)
            elif self.bearings is None:
                yield key, JUDGED
            else:
                known = list(_of_row(self.bearings, there[row.name]))
                own = there[row.name].with_own(row)
                here = _of_row(self.bearings, own)
                yield from _within(key, (problem for problem in here if problem not in known))
                if row.seat != "direct" and (undivided := original.seat_problem(own)) is not None:
                    yield dotted(key, BearingRow.seat), undivided

    def _seat(self, bearings: BearingsInputs, key: str, row: BearingRow) -> Problems:
        """Supply and seat of one bearing: what is wrong by what all share is said there, the rest at its row."""
        known, shared = list(bearings.of_seat()), list(bearings.beside(row)) if row.sized else []
        for problem in _of_seat(bearings, row):
            if problem not in known:
                yield from _within(dotted(Design.bearings) if problem in shared else key, [problem])

    def _shaft(self, shaft: ShaftInputs) -> Problems:
        if shaft.mode == "bearings" or None in shaft.bearing_positions:
            return
        places, journals = shaft.bearing_positions, shaft.journals
        lengths = [length for _, length in journals]
        if shaft.outer_radius is None and shaft.seat is not None and not shaft.sections:
            widest = shaft.seat / 2 - (shaft.radial_clearance or 0.0)
            if shaft.core_radius is not None and shaft.core_radius >= widest:
                must = Text(
                    "must be smaller than what the largest journal leaves to the sectors, {R} mm", R=_in_mm(widest)
                )
                yield dotted(ShaftInputs.core_radius), must
        for i, (a, b, l_a, l_b) in enumerate(zip(places, places[1:], lengths, lengths[1:]), 1):
            if b - a < (l_a + l_b) / 2 - 1e-9:
                near = Text("its journal overlaps the one before it, {b} mm away", b=_in_mm(b - a))
                yield dotted(ShaftInputs.bearings, i, BearingRow.position), near
        if shaft.sections and len(lengths) == len(places):
            start, end = min(s.from_ for s in shaft.sections), max(s.to for s in shaft.sections)
            reach = Text("from {start} to {end} mm", start=_in_mm(start), end=_in_mm(end))
            for i, (z, (d, l)) in enumerate(zip(places, journals)):
                if z - l / 2 < start - 1e-9 or z + l / 2 > end + 1e-9:
                    parts = dict(l=_in_mm(l), reach=reach)
                    beyond = Text("its journal, {l} mm long, reaches beyond the shaft's sections, {reach}", **parts)
                    yield dotted(ShaftInputs.bearings, i, BearingRow.position), beyond
                there = min((s.outer_radius for s in shaft.sections if s.from_ <= z <= s.to), default=0.0)
                if d / 2 < there - 1e-6:
                    thick = Text(
                        "its journal has a diameter of {d} mm, the shaft's section there of {there} mm",
                        d=_in_mm(d),
                        there=_in_mm(2 * there),
                    )
                    yield dotted(ShaftInputs.bearings, i, BearingRow.position), thick

    def _bearings(self, bearings: BearingsInputs) -> Problems:
        """What the tables of bearings do not have, and what bearings need that stand alone."""
        if (wrong := application_problem(bearings.application)) is not None:
            yield dotted(Design.bearings, BearingsInputs.application), wrong
        if self.engine is None and bearings.speed is None:
            yield dotted(Design.bearings, BearingsInputs.speed), NEEDS_ENGINE
        if not self.shafts:
            yield dotted(Design.shafts), Text("needs [[shafts]] with a row [[shafts.bearings]] for each bearing")
            return
        own = [(n, shaft) for n, shaft in enumerate(self.shafts) if not shaft.is_twin]
        asked = bearings.asked_by(row for _, shaft in own for row in shaft.bearings)
        yield from _within(dotted(Design.bearings), asked)
        alone = [(n, shaft) for n, shaft in own if shaft.mode == "bearings"]
        if bearings.journal_material is None and any(shaft.material is None for _, shaft in alone):
            needed = Text("needed where a shaft has no material to take it from")
            yield dotted(Design.bearings, BearingsInputs.journal_material), needed
        for n, shaft in alone:
            for i in _unloaded(shaft):
                needed = Text("needed where there is no shaft whose reactions it carries")
                yield dotted(Design.shafts, n, ShaftInputs.bearings, i, BearingRow.load), needed
        for n, shaft in own:
            for i, row in enumerate(shaft.bearings):
                if row.standing_load is not None and shaft.mode != "bearings":
                    known = Text("leave it out: the shaft knows what stands on its bearings")
                    yield dotted(Design.shafts, n, ShaftInputs.bearings, i, BearingRow.standing_load), known
        yield from self._speeds(bearings, [shaft for _, shaft in own if shaft.mode != "bearings"])

    def _speeds(self, bearings: BearingsInputs, turning: list[ShaftInputs]) -> Problems:
        """Those given of the journals, of which shafts at other ratios have others."""
        if self.engine is None or not turning:
            return
        ratios = {abs(shaft.speed_ratio or 1.0) for shaft in turning}
        if bearings.speed_range is not None and len(ratios) > 1:
            unlike = Text("is that of the journals, and the shafts turn at unlike ratios; leave it out")
            yield dotted(Design.bearings, BearingsInputs.speed_range), unlike
        speeds = sorted(ratio * self.engine.rated_speed for ratio in ratios)
        if bearings.speed is not None and any(map(_unloaded, turning)) and speeds != [bearings.speed]:
            at = listed(Text("{rated_speed} rpm", rated_speed=Amount(n * 60, form="g")) for n in speeds)
            theirs = Text(
                "the shaft's reactions are those of {at}; leave it out, or give load_N of all bearings", at=at
            )
            yield dotted(Design.bearings, BearingsInputs.speed), theirs

    def _mounting(self, mounting: MountingInputs) -> Problems:
        """What the mounts ask of the engine."""
        for key, there in ((dotted(Design.engine), self.engine), (dotted(Design.imbalance), self.imbalance)):
            if there is None:
                yield dotted(Design.mounting), Text("needs [{key}], which says what shakes the engine", key=key)
        if self.engine is not None:
            yield from _within("mounting", self._on_mounts(mounting, self.engine))
            for i, row in enumerate(() if mounting.operation else self.engine.operation):
                if row.name in RESERVED:
                    named = dotted(Design.engine, EngineInputs.operation, i, Operation.name)
                    yield named, Text("stands for something else in the names of values of [mounting]; take another")

    def _on_mounts(self, mounting: MountingInputs, engine: EngineInputs) -> Problems:
        rated, gas, spread = Amount(engine.rated_speed * 60, "rpm"), engine.gas, mounting.cylinder_spread
        if mounting.idle_speed >= engine.rated_speed:
            yield dotted(MountingInputs.idle_speed), Text("must stay below the rated speed, {rated}", rated=rated)
        if spread is not None and len(spread) not in (1, engine.cylinders):
            counts = dict(count=len(spread), n=engine.cylinders)
            has = Text("has {count} entries; needs one, or one per cylinder, {n}", **counts)
            yield dotted(MountingInputs.cylinder_spread), has
        for i, row in enumerate(mounting.operation):
            if row.has_gas and (gas is None or gas.pressure):
                needs = Text("its pressures need [engine.gas] with a peak pressure, of which they are changes")
                yield dotted(MountingInputs.operation, i), needs
        if mounting.torque_path == "off_body" and mounting.output_torque is None and gas is None:
            yield dotted(MountingInputs.output_torque), Text("needed where no [engine.gas] gives the mean torque")

    def _friction(self, friction: FrictionInputs) -> Problems:
        """Oil and temperature are needed without bearings; with them the power is known."""
        if self.bearings is None:
            needed = Text("needed where there is no [bearings] table to take it from")
            if friction.oil is None:
                yield dotted(FrictionInputs.oil), needed
            if friction.oil_temperature is None:
                yield dotted(FrictionInputs.oil_temperature), needed
            return
        for i, scenario in enumerate(friction.scenarios):
            if scenario.power is not None:
                known = Text("leave it out: the losses of the [bearings] say what the train carries")
                yield dotted(FrictionInputs.scenarios, i, Scenario.power), known

    def _gears(self, gears: GearsInputs) -> Problems:
        """Materials, shafts and places of the wheels; speed, irregularity and power of the train, where no other table
        has them."""
        for i, wheel in enumerate(gears.wheels):
            names = [shaft.name for shaft in self.shafts] or [ONLY]
            if wheel.shaft not in (None, *names):
                yield dotted(GearsInputs.wheels, i, Wheel.shaft), _unknown_name(wheel.shaft or "", names)
            if wheel.gear_material is not None:
                from ..gears.rating.classes import class_problem  # brings numpy with it

                if (wrong := class_problem(wheel.gear_material)) is not None:
                    yield dotted(GearsInputs.wheels, i, Wheel.gear_material), wrong
        if gears.meshes and any(shaft.mode != "bearings" for shaft in self.shafts):
            for i, wheel in enumerate(gears.wheels):
                if wheel.z is not None and wheel.name in gears.carriers:
                    on_shaft = Text("gear_z_mm of the shaft on which it sits says it: leave this out")
                    yield dotted(GearsInputs.wheels, i, Wheel.z), on_shaft
        # positions count from the crank's axis, on which the first driver stands where the engine drives it
        if self.engine is not None and gears.speed in (None, self.engine.rated_speed) and gears.meshes:
            for i, wheel in enumerate(gears.wheels):
                if wheel.name == gears.first and wheel.position is not None and any(wheel.position):
                    must = Text("must be [0, 0]: it stands on the crank, from whose axis positions count")
                    yield dotted(GearsInputs.wheels, i, Wheel.position), must
        if self.engine is None and gears.speed is None:
            yield dotted(GearsInputs.speed), NEEDS_ENGINE
        if self.engine is None and gears.speed_irregularity and gears.irregularity_order is None:
            needed = Text("needed where there is no [engine] table whose firing order it is")
            yield dotted(GearsInputs.irregularity_order), needed
        if self.friction is not None and self.bearings is None and gears.power is None:
            needed = Text("needed where there is no [bearings] table whose loss the train carries")
            yield dotted(GearsInputs.power), needed


PLACES_OF_ROWS = tuple(dotted(key) for key in (BearingRow.name, BearingRow.position, BearingRow.offset))
SHARED_OF_ROWS = OF_ROWS  # what a row may say for its bearing alone, where else that of all of them holds


def step_of(key: str, *, judged: bool) -> str:
    """The step that a key is of; `judged`: the design has [bearings]."""
    first, *parts = key.split(".")
    if first != dotted(Design.shafts):
        return first
    of_row = len(parts) > 3 and parts[1] == dotted(ShaftInputs.bearings) and parts[3] not in PLACES_OF_ROWS
    return dotted(Design.bearings) if judged and of_row else "countershaft"


def _of_seat(bearings: BearingsInputs, row: BearingRow) -> Problems:
    """What is wrong with supply and seat of one bearing."""
    own = bearings.of(row)
    yield from own.of_seat()
    if row.sized:
        yield from own.beside(row)


def _of_row(bearings: BearingsInputs, row: BearingRow) -> Problems:
    """What is wrong with one bearing, by itself and by what all share."""
    yield from row.of_others()
    yield from row.problems()
    yield from bearings.asked_of(row)
    if row.fed():
        yield from _of_seat(bearings, row)


def _unloaded(shaft: ShaftInputs) -> list[int]:
    """Which of its bearings have no given load."""
    return [i for i, row in enumerate(shaft.bearings) if row.load is None]


def _within(step: str, problems: Problems) -> Problems:
    """Problems of a step, by their keys in the design."""
    return ((f"{step}.{key}", reason) for key, reason in problems)


def _in_mm(length: float) -> Amount:
    return Amount(length * 1000.0, form="g")


def _no_key(key: str) -> Text | None:
    """Why a key is none of a design.  Elements of arrays are not looked for: one may come and go while its lock
    stays."""
    cls: type | None = Design
    parts = iter(key.split("."))
    for part in parts:
        known = keys(cls) if cls is not None else {}
        if part not in known:
            return unknown(part, known) if known else Text('"{key}" has no parts', key=key.rpartition(".")[0])
        about = known[part].about
        cls = about.table
        if about.kind in ("tables", "series", "integers"):
            next(parts, None)
        elif about.kind in ("reasons", "open"):
            break  # with keys of their own
    return None


def _unknown_name(name: str, known: Iterable[str]) -> Text:
    there = [other for other in known if other]  # one without a name is an error of its own
    others = Text("; there are none")
    if there:
        others = meant(name, there) or Text("; known are ") + ", ".join(there)
    return Text('"{name}" is not known', name=name) + others
