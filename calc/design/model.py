# SPDX-License-Identifier: Apache-2.0
"""A design: the Inputs of its steps in order.  A further step is one new folder, two adjacent lines here and its call
in solve.py."""

from collections.abc import Collection, Iterable, Mapping
from difflib import get_close_matches

from ..bearings.inputs import BearingInputs, BearingsInputs
from ..bearings.materials import application_problem, applications, bush_problem, bushes
from ..countershaft.inputs import CountershaftInputs
from ..countershaft.making.inputs import Alternative, Cost, Support
from ..engine.inputs import EngineInputs, ThrowInputs
from ..friction.inputs import FrictionInputs, Scenario, Seal
from ..gears.inputs import GearsInputs, Wheel
from ..imbalance.inputs import ImbalanceInputs
from ..library.catalogue import Material, Oil, materials, oils
from ..mounting.inputs import MountingInputs
from ..sheet.check import is_limit
from ..sheet.quantity import day, dotted, inputs, integer, keys, reasons, table, tables, text, unknown
from ..sheet.step import Step
from ..sheet.text import Amount, Text
from .other_tables import FORMER, DocumentControl, Measured, OptimiseInputs, control, said_twice

SCHEMA = 1

STEPS = (
    Step("engine", Text("Engine"), EngineInputs),
    Step("imbalance", Text("Imbalance"), ImbalanceInputs),
    Step("countershaft", Text("Counter-shaft"), CountershaftInputs),
    Step("bearings", Text("Bearings"), BearingsInputs),
    Step("gears", Text("Gears"), GearsInputs),
    Step("friction", Text("Friction"), FrictionInputs),
    Step("mounting", Text("Mounting"), MountingInputs, optional=True),
)
STEP_KEYS = tuple(step.key for step in STEPS)
OPTIONAL = {step.key for step in STEPS if step.optional}  # of which nothing is said in a design without them


@inputs
class Design:
    """Everything that a design file says, checked and in SI."""

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
    countershaft: CountershaftInputs | None = table("Counter-shaft", CountershaftInputs, default=None)
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

    measured: tuple[Measured, ...] = tables(
        "Measured", Measured, default=(), help="What was measured of this design; it stands beside what is predicted."
    )

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

    def asked(self) -> tuple[Step, ...]:
        return tuple(s for s in STEPS if getattr(self, s.key) is not None)

    def problems(self) -> Iterable[tuple[str, Text]]:
        """What only the whole design can show: (key, reason)."""
        if not self.asked():
            yield (
                "",
                Text("no step is asked: give at least one of the tables ") + ", ".join(f"[{key}]" for key in STEP_KEYS),
            )
        yield from said_twice(self.document, self._former)
        yield from self._reasons()
        yield from self._measured()
        for key, name, known in self._names():
            if name is not None and name not in known:
                yield key, _unknown_name(name, known)
        if self.engine is not None:
            yield from self._cranks(self.engine)
        if self.countershaft is not None:
            yield from self._countershaft(self.countershaft)
        if self.bearings is not None:
            yield from self._bearings(self.bearings)
        yield from self._gear_materials()
        yield from self._gear_places()
        if self.mounting is not None:
            yield from self._mounting(self.mounting)
        if self.friction is not None:
            yield from self._friction(self.friction)
        if self.gears is not None:
            yield from self._gear_operation(self.gears)

    def _reasons(self) -> Iterable[tuple[str, Text]]:
        """Of what is accepted, locked and left out: whether there is such a thing, and whether that can be."""
        for id, _ in self.accepted:
            if is_limit(id):
                yield f"accepted.{id}", Text("is a limit, which nobody can accept: what fails must be changed")
        for key, _ in self.locked:
            if (wrong := _no_key(key)) is not None:
                yield f"locked.{key}", wrong
        for step, _ in self.without:
            if step not in STEP_KEYS:
                yield f"without.{step}", Text("is no step; there are {steps}", steps=", ".join(STEP_KEYS))
            elif getattr(self, step) is not None:
                yield f"without.{step}", Text("is a step of this design: take the table out, or this line")

    def _measured(self) -> Iterable[tuple[str, Text]]:
        for n, row in enumerate(self.measured):
            if row.step not in STEP_KEYS:
                yield (
                    dotted(Design.measured, n, Measured.value),
                    Text(
                        "must be the id of a value or the key of an input of a step: {steps}",
                        steps=", ".join(STEP_KEYS),
                    ),
                )
            if row.speed is not None and self.engine is None:
                yield (
                    dotted(Design.measured, n, Measured.speed),
                    Text("is that of the engine: leave it out where there is no [engine] table"),
                )

    def _cranks(self, engine: EngineInputs) -> Iterable[tuple[str, Text]]:
        """Whether crank angles, firing order and crank bodies are those of one crank."""
        if engine.crank_angles is not None and engine.firing_order is not None:
            from ..engine.crank import not_fired  # brings numpy with it

            if reason := not_fired(engine):
                yield dotted(Design.engine, EngineInputs.firing_order), reason
        if self.imbalance is not None and self.imbalance.crank_bodies:
            yield from self._crank_bodies(self.imbalance, engine)

    def _friction(self, friction: FrictionInputs) -> Iterable[tuple[str, Text]]:
        """Oil and temperature are needed without bearings; with them the power is known."""
        if self.bearings is None:
            for key, given in (
                (FrictionInputs.oil, friction.oil),
                (FrictionInputs.oil_temperature, friction.oil_temperature),
            ):
                if given is None:
                    yield (
                        dotted(Design.friction, key),
                        Text("needed where there is no [bearings] table to take it from"),
                    )
            return
        for i, scenario in enumerate(friction.scenarios):
            if scenario.power is not None:
                yield (
                    dotted(Design.friction, FrictionInputs.scenarios, i, Scenario.power),
                    Text("leave it out: the losses of the [bearings] say what the train carries"),
                )

    def _gear_operation(self, gears: GearsInputs) -> Iterable[tuple[str, Text]]:
        """Speed, irregularity and power of the train, where no other table has them."""
        if self.engine is None:
            if gears.speed is None:
                yield (
                    dotted(Design.gears, GearsInputs.speed),
                    Text("needed where there is no [engine] table to take it from"),
                )
            if gears.speed_irregularity and gears.irregularity_order is None:
                yield (
                    dotted(Design.gears, GearsInputs.irregularity_order),
                    Text("needed where there is no [engine] table whose firing order it is"),
                )
        if self.friction is not None and self.bearings is None and gears.power is None:
            yield (
                dotted(Design.gears, GearsInputs.power),
                Text("needed where there is no [bearings] table whose loss the train carries"),
            )

    def _mounting(self, mounting: MountingInputs) -> Iterable[tuple[str, Text]]:
        """What the mounts ask of the engine."""
        for key, there in ((dotted(Design.engine), self.engine), (dotted(Design.imbalance), self.imbalance)):
            if there is None:
                yield dotted(Design.mounting), Text("needs [{key}], which says what shakes the engine", key=key)
        if self.engine is None:
            return
        rated = Amount(self.engine.rated_speed * 60, "rpm")
        if mounting.idle_speed >= self.engine.rated_speed:
            yield (
                dotted(Design.mounting, MountingInputs.idle_speed),
                Text("must stay below the rated speed, {rated}", rated=rated),
            )
        if mounting.cylinder_spread is not None and len(mounting.cylinder_spread) not in (1, self.engine.cylinders):
            count, n = len(mounting.cylinder_spread), self.engine.cylinders
            yield (
                dotted(Design.mounting, MountingInputs.cylinder_spread),
                Text("has {count} entries; needs one, or one per cylinder, {n}", count=count, n=n),
            )
        gas = self.engine.gas
        for i, row in enumerate(mounting.operation):
            if row.has_gas and (gas is None or gas.pressure):
                yield (
                    dotted(Design.mounting, MountingInputs.operation, i),
                    Text("its pressures need [engine.gas] with a peak pressure, of which they are changes"),
                )
        if mounting.torque_path == "off_body" and mounting.output_torque is None and gas is None:
            yield (
                dotted(Design.mounting, MountingInputs.output_torque),
                Text("needed where no [engine.gas] gives the mean torque"),
            )

    def _gear_places(self) -> Iterable[tuple[str, Text]]:
        """Positions count from the crank's axis, on which the first driver stands where the engine drives it."""
        gears = self.gears
        if (
            gears is None
            or self.engine is None
            or (gears.speed is not None and gears.speed != self.engine.rated_speed)
            or not gears.meshes
        ):
            return
        for i, wheel in enumerate(gears.wheels):
            if wheel.name == gears.meshes[0].driver and wheel.position is not None and any(wheel.position):
                yield (
                    dotted(Design.gears, GearsInputs.wheels, i, Wheel.position),
                    Text("must be [0, 0]: it stands on the crank, from whose axis positions count"),
                )

    def _gear_materials(self) -> Iterable[tuple[str, Text]]:
        wheels = self.gears.wheels if self.gears is not None else ()
        for i, wheel in enumerate(wheels):
            if wheel.gear_material is not None:
                from ..gears.rating.classes import class_problem  # brings numpy with it

                if (wrong := class_problem(wheel.gear_material)) is not None:
                    yield dotted(Design.gears, GearsInputs.wheels, i, Wheel.gear_material), wrong

    def _crank_bodies(self, imbalance: ImbalanceInputs, engine: EngineInputs) -> Iterable[tuple[str, Text]]:
        pins = sum(body.pin is not None for body in imbalance.crank_bodies)
        there = engine.cylinders
        if engine.layout != "inline":  # cylinders of two banks may share a pin
            from ..engine.crank import crank, pin_of_cylinder

            there = int(pin_of_cylinder(engine, crank(engine, 0.0)).max()) + 1
        if pins and pins != there:
            yield (
                dotted(Design.imbalance, ImbalanceInputs.crank_bodies),
                Text("have {pins} crankpins; the throws of this engine stand on {there}", pins=pins, there=there),
            )
        if imbalance.crank_bodies_throw_at_tdc > engine.cylinders:
            yield (
                dotted(Design.imbalance, ImbalanceInputs.crank_bodies_throw_at_tdc),
                Text("must be a cylinder of this engine, from 1 to {cylinders}", cylinders=engine.cylinders),
            )

    def _countershaft(self, shaft: CountershaftInputs) -> Iterable[tuple[str, Text]]:
        if self.bearings is not None:
            if len(shaft.bearing_positions) > 2:
                yield (
                    dotted(Design.countershaft, CountershaftInputs.bearing_positions),
                    Text("[bearings] has a front and a rear one: give two, or the sizes as journals"),
                )
            if shaft.journals:
                yield (
                    dotted(Design.countershaft, CountershaftInputs.journals),
                    Text("are those of [bearings]; leave them out here, or [bearings]"),
                )
        if shaft.speed_ratio != -1 and (self.bearings is not None or self.gears is not None):
            yield (
                dotted(Design.countershaft, CountershaftInputs.speed_ratio),
                Text("must be -1 where [bearings] or [gears] carry the shaft"),
            )
        lengths = [j.length for j in shaft.journals] or (
            [self.bearings.front.length, self.bearings.rear.length] if self.bearings else []
        )
        places = shaft.bearing_positions
        for i, (a, b, l_a, l_b) in enumerate(zip(places, places[1:], lengths, lengths[1:])):
            if b - a < (l_a + l_b) / 2 - 1e-9:
                yield (
                    dotted(Design.countershaft, CountershaftInputs.bearing_positions, i + 1),
                    Text("its journal overlaps the one before it, {b} mm away", b=Amount((b - a) * 1000.0, form="g")),
                )
        if shaft.sections and len(lengths) == len(shaft.bearing_positions):
            start, end = min(s.from_ for s in shaft.sections), max(s.to for s in shaft.sections)
            for i, (z, l) in enumerate(zip(shaft.bearing_positions, lengths)):
                if z - l / 2 < start - 1e-9 or z + l / 2 > end + 1e-9:
                    reach = Text(
                        "from {start} to {end} mm",
                        start=Amount(start * 1000.0, form="g"),
                        end=Amount(end * 1000.0, form="g"),
                    )
                    yield (
                        dotted(Design.countershaft, CountershaftInputs.bearing_positions, i),
                        Text(
                            "its journal, {l} mm long, reaches beyond the shaft's sections, {reach}",
                            l=Amount(l * 1000.0, form="g"),
                            reach=reach,
                        ),
                    )

    def _bearings(self, bearings: BearingsInputs) -> Iterable[tuple[str, Text]]:
        """What the tables of bearings do not have, and what bearings need that stand alone."""
        if bearings.bush_material is not None and (wrong := bush_problem(bearings.bush_material)) is not None:
            yield dotted(Design.bearings, BearingsInputs.bush_material), wrong
        if (wrong := application_problem(bearings.application)) is not None:
            yield dotted(Design.bearings, BearingsInputs.application), wrong
        if self.engine is None and bearings.speed is None:
            yield (
                dotted(Design.bearings, BearingsInputs.speed),
                Text("needed where there is no [engine] table to take it from"),
            )
        if self.countershaft is None:
            if bearings.journal_material is None:
                yield (
                    dotted(Design.bearings, BearingsInputs.journal_material),
                    Text("needed where there is no [countershaft] table to take it from"),
                )
            for place in ("front", "rear"):
                if getattr(bearings, place).load is None:
                    yield (
                        dotted(Design.bearings, place, BearingInputs.load),
                        Text("needed where there is no [countershaft] table whose reactions it carries"),
                    )
        elif self.engine is not None and bearings.speed is not None and bearings.speed != self.engine.rated_speed:
            for place in ("front", "rear"):
                if getattr(bearings, place).load is None:
                    at = Text("{rated_speed} rpm", rated_speed=Amount(self.engine.rated_speed * 60, form="g"))
                    yield (
                        dotted(Design.bearings, BearingsInputs.speed),
                        Text(
                            "the shaft's reactions are those of {at}; leave it out, or give load_N of front and rear",
                            at=at,
                        ),
                    )
                    break

    def _names(self) -> Iterable[tuple[str, str | None, Collection[str]]]:
        known_oils, solids = self.oils, self.materials
        if self.engine is not None and self.engine.throw is not None:
            yield dotted(Design.engine, EngineInputs.throw, ThrowInputs.material), self.engine.throw.material, solids
        if self.countershaft is not None:
            yield dotted(Design.countershaft, CountershaftInputs.material), self.countershaft.material, solids
            if self.countershaft.support is not None:
                yield (
                    dotted(Design.countershaft, CountershaftInputs.support, Support.material),
                    self.countershaft.support.material,
                    solids,
                )
            for i, other in enumerate(
                self.countershaft.cost.alternatives if self.countershaft.cost is not None else ()
            ):
                yield (
                    dotted(Design.countershaft, CountershaftInputs.cost, Cost.alternatives, i, Alternative.material),
                    other.material,
                    solids,
                )
        if self.bearings is not None:
            yield dotted(Design.bearings, BearingsInputs.oil), self.bearings.oil, known_oils
            yield dotted(Design.bearings, BearingsInputs.housing_material), self.bearings.housing_material, solids
            yield dotted(Design.bearings, BearingsInputs.journal_material), self.bearings.journal_material, solids
        if self.gears is not None:
            yield dotted(Design.gears, GearsInputs.housing_material), self.gears.housing_material, solids
            yield dotted(Design.gears, GearsInputs.support_material), self.gears.support_material, solids
            for i, wheel in enumerate(self.gears.wheels):
                yield dotted(Design.gears, GearsInputs.wheels, i, Wheel.material), wheel.material, solids
        if self.friction is not None:
            yield dotted(Design.friction, FrictionInputs.oil), self.friction.oil, known_oils
            for i, scenario in enumerate(self.friction.scenarios):
                yield dotted(Design.friction, FrictionInputs.scenarios, i, Scenario.oil), scenario.oil, known_oils
            wheels = [wheel.name for wheel in self.gears.wheels] if self.gears is not None else []
            for kind in (
                ("seals", "rolling_bearings", "plain_bearings", "dips", "jets", "other_losses") if wheels else ()
            ):
                for i, entry in enumerate(getattr(self.friction, kind)):
                    yield dotted(Design.friction, kind, i, Seal.wheel), entry.wheel, wheels


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
    near = get_close_matches(name, list(known), 1)
    return Text('"{name}" is not known', name=name) + (
        Text('; did you mean "{near}"?', near=near[0]) if near else Text("; known are ") + ", ".join(known)
    )
