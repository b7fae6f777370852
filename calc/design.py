# SPDX-License-Identifier: Apache-2.0
"""A design: the six Inputs in order.  A seventh step is one new folder, two adjacent lines here and its call in solve.py."""

from collections.abc import Iterable, Mapping
from typing import Any

from .bearings.inputs import BearingsInputs
from .bearings.pairing.data import application_problem, applications, bush_problem, bushes
from .catalogue import Material, Oil, materials, oils
from .countershaft.inputs import CountershaftInputs
from .engine.inputs import EngineInputs
from .friction.inputs import FrictionInputs
from .gears.inputs import GearsInputs
from .imbalance.inputs import ImbalanceInputs
from .sheet.quantity import inputs, integer, table, tables, text
from .sheet.step import Step

SCHEMA = 1

STEPS = (
    Step("engine", "Engine", EngineInputs, ("engine.stroke",)),
    Step("imbalance", "Imbalance", ImbalanceInputs, ("imbalance.required_couple",)),
    Step("countershaft", "Counter-shaft", CountershaftInputs, ("countershaft.couple",)),
    Step("bearings", "Bearings", BearingsInputs, ("bearings.front.film_edge", "bearings.front.film")),
    Step("gears", "Gears", GearsInputs, ("gears.phase_error",)),
    Step("friction", "Friction", FrictionInputs, ("friction.total_loss",)),
)


@inputs
class Design:
    """Everything that a design file says, checked and in SI."""

    schema: int = integer("Schema", low=1, high=SCHEMA)
    name: str = text("Design")
    note: str = text("Note", default="")
    author: str = text("Author", default="")
    checker: str = text("Checker", default="")
    revision: str = text("Revision", default="")
    date: str = text("Date", default="")
    oil: tuple[Oil, ...] = tables("Oils of this design", Oil, optional=True)
    material: tuple[Material, ...] = tables("Materials of this design", Material, optional=True)
    engine: EngineInputs | None = table("Engine", EngineInputs, optional=True)
    imbalance: ImbalanceInputs | None = table("Imbalance", ImbalanceInputs, optional=True)
    countershaft: CountershaftInputs | None = table("Counter-shaft", CountershaftInputs, optional=True)
    bearings: BearingsInputs | None = table("Bearings", BearingsInputs, optional=True)
    gears: GearsInputs | None = table("Gears", GearsInputs, optional=True)
    friction: FrictionInputs | None = table("Friction", FrictionInputs, optional=True)

    @property
    def oils(self) -> Mapping[str, Oil]:
        return oils(self.oil)

    @property
    def materials(self) -> dict[str, Material]:
        return materials(self.material)

    @property
    def bushes(self) -> tuple[str, ...]:
        return bushes()

    @property
    def strength_classes(self) -> tuple[str, ...]:
        from .gears.rating.classes import class_names

        return class_names()

    @property
    def applications(self) -> tuple[str, ...]:
        return tuple(applications())

    def asked(self) -> tuple[Step, ...]:
        return tuple(s for s in STEPS if getattr(self, s.key) is not None)

    def problems(self) -> Iterable[tuple[str, str]]:
        """What only the whole design can show: (key, reason)."""
        if not self.asked():
            yield "", "no step is asked: give at least one of the tables " + ", ".join(f"[{s.key}]" for s in STEPS)
        for key, name, known in self._names():
            if name is not None and name not in known:
                yield key, _unknown_name(name, known)
        if self.imbalance is not None and self.engine is not None and self.imbalance.crank_bodies:
            yield from self._crank_bodies(self.imbalance, self.engine)
        if self.countershaft is not None:
            yield from self._countershaft(self.countershaft)
        if self.bearings is not None:
            yield from self._bearings(self.bearings)
        yield from self._gear_materials()
        yield from self._gear_places()
        if self.friction is not None and self.bearings is None:
            for attribute, key in (("oil", "friction.oil"), ("oil_temperature", "friction.oil_temperature_C")):
                if getattr(self.friction, attribute) is None:
                    yield key, "needed where there is no [bearings] table to take it from"
        if self.friction is not None and self.bearings is not None:
            for i, scenario in enumerate(self.friction.scenarios):
                if scenario.power is not None:
                    yield f"friction.scenarios.{i}.power_kW", "leave it out: the losses of the [bearings] say what the train carries"
        if self.gears is not None and self.engine is None and self.gears.speed is None:
            yield "gears.speed_rpm", "needed where there is no [engine] table to take it from"
        if self.gears is not None and self.engine is None and self.gears.speed_irregularity and self.gears.irregularity_order is None:
            yield "gears.irregularity_order", "needed where there is no [engine] table whose firing order it is"
        if self.friction is not None and self.gears is not None and self.bearings is None and self.gears.power is None:
            yield "gears.power_kW", "needed where there is no [bearings] table whose loss the train carries"

    def _gear_places(self) -> Iterable[tuple[str, str]]:
        """Positions count from the crank's axis, on which the first driver stands where the engine drives it."""
        own = self.gears
        if own is None or self.engine is None or (own.speed is not None and own.speed != self.engine.rated_speed) or not own.meshes:
            return
        for i, wheel in enumerate(own.wheels):
            if wheel.name == own.meshes[0].driver and wheel.position is not None and any(wheel.position):
                yield f"gears.wheels.{i}.position_mm", "must be [0, 0]: it stands on the crank, from whose axis positions count"

    def _gear_materials(self) -> Iterable[tuple[str, str]]:
        wheels = self.gears.wheels if self.gears is not None else ()
        for i, wheel in enumerate(wheels):
            if wheel.gear_material is not None:
                from .gears.rating.classes import class_problem  # brings numpy with it

                if (wrong := class_problem(wheel.gear_material)) is not None:
                    yield f"gears.wheels.{i}.gear_material", wrong

    def _crank_bodies(self, imbalance: ImbalanceInputs, engine: EngineInputs) -> Iterable[tuple[str, str]]:
        pins = sum(body.pin is not None for body in imbalance.crank_bodies)
        there = engine.cylinders
        if engine.layout != "inline":  # cylinders of two banks may share a pin
            from .engine.crank import crank, pin_of_cylinder

            there = int(pin_of_cylinder(engine, crank(engine, 0.0)).max()) + 1
        if pins and pins != there:
            yield "imbalance.crank_bodies", f"have {pins} crankpins; the throws of this engine stand on {there}"
        if imbalance.crank_bodies_throw_at_tdc > engine.cylinders:
            yield "imbalance.crank_bodies_throw_at_tdc", f"must be a cylinder of this engine, from 1 to {engine.cylinders}"

    def _countershaft(self, shaft: CountershaftInputs) -> Iterable[tuple[str, str]]:
        if self.bearings is not None:
            if len(shaft.bearing_positions) > 2:
                yield "countershaft.bearing_positions_mm", "[bearings] has a front and a rear one: give two, or the sizes as journals"
            if shaft.journals:
                yield "countershaft.journals", "are those of [bearings]; leave them out here, or [bearings]"
        if shaft.speed_ratio != -1 and (self.bearings is not None or self.gears is not None):
            yield "countershaft.speed_ratio", "must be -1 where [bearings] or [gears] carry the shaft"
        lengths = [j.length for j in shaft.journals] or ([self.bearings.front.length, self.bearings.rear.length] if self.bearings else [])
        places = shaft.bearing_positions
        for i, (a, b, l_a, l_b) in enumerate(zip(places, places[1:], lengths, lengths[1:])):
            if b - a < (l_a + l_b) / 2 - 1e-9:
                yield f"countershaft.bearing_positions_mm.{i + 1}", f"its journal overlaps the one before it, {(b - a) * 1e3:g} mm away"
        if shaft.sections and len(lengths) == len(shaft.bearing_positions):
            start, end = min(s.from_ for s in shaft.sections), max(s.to for s in shaft.sections)
            for i, (z, l) in enumerate(zip(shaft.bearing_positions, lengths)):
                if z - l / 2 < start - 1e-9 or z + l / 2 > end + 1e-9:
                    reach = f"from {start * 1e3:g} to {end * 1e3:g} mm"
                    yield (
                        f"countershaft.bearing_positions_mm.{i}",
                        f"its journal, {l * 1e3:g} mm long, reaches beyond the shaft's sections, {reach}",
                    )

    def _bearings(self, own: BearingsInputs) -> Iterable[tuple[str, str]]:
        """What the tables of bearings do not have, and what bearings need that stand alone."""
        if own.bush_material is not None and (wrong := bush_problem(own.bush_material)) is not None:
            yield "bearings.bush_material", wrong
        if (wrong := application_problem(own.application)) is not None:
            yield "bearings.application", wrong
        if self.engine is None and own.speed is None:
            yield "bearings.speed_rpm", "needed where there is no [engine] table to take it from"
        if self.countershaft is None:
            if own.journal_material is None:
                yield "bearings.journal_material", "needed where there is no [countershaft] table to take it from"
            for place in ("front", "rear"):
                if getattr(own, place).load is None:
                    yield f"bearings.{place}.load_N", "needed where there is no [countershaft] table whose reactions it carries"
        elif self.engine is not None and own.speed is not None and own.speed != self.engine.rated_speed:
            for place in ("front", "rear"):
                if getattr(own, place).load is None:
                    at = f"{self.engine.rated_speed * 60:g} rpm"
                    yield "bearings.speed_rpm", f"the shaft's reactions are those of {at}; leave it out, or give load_N of front and rear"
                    break

    def _names(self) -> Iterable[tuple[str, Any, Any]]:
        known_oils, solids = self.oils, self.materials
        if self.engine is not None and self.engine.throw is not None:
            yield "engine.throw.material", self.engine.throw.material, solids
        if self.countershaft is not None:
            yield "countershaft.material", self.countershaft.material, solids
            if self.countershaft.support is not None:
                yield "countershaft.support.material", self.countershaft.support.material, solids
            for i, other in enumerate(self.countershaft.cost.alternatives if self.countershaft.cost is not None else ()):
                yield f"countershaft.cost.alternatives.{i}.material", other.material, solids
        if self.bearings is not None:
            yield "bearings.oil", self.bearings.oil, known_oils
            yield "bearings.housing_material", self.bearings.housing_material, solids
            yield "bearings.journal_material", self.bearings.journal_material, solids
        if self.gears is not None:
            yield "gears.housing_material", self.gears.housing_material, solids
            yield "gears.support_material", self.gears.support_material, solids
            for i, wheel in enumerate(self.gears.wheels):
                yield f"gears.wheels.{i}.material", wheel.material, solids
        if self.friction is not None:
            yield "friction.oil", self.friction.oil, known_oils
            for i, scenario in enumerate(self.friction.scenarios):
                yield f"friction.scenarios.{i}.oil", scenario.oil, known_oils
            wheels = [wheel.name for wheel in self.gears.wheels] if self.gears is not None else []
            for kind in ("seals", "rolling_bearings", "plain_bearings", "dips", "jets", "other_losses") if wheels else ():
                for i, entry in enumerate(getattr(self.friction, kind)):
                    yield f"friction.{kind}.{i}.wheel", entry.wheel, wheels


def _unknown_name(name: str, known: Iterable[str]) -> str:
    from difflib import get_close_matches

    near = get_close_matches(name, list(known), 1)
    return f'"{name}" is not known' + (f'; did you mean "{near[0]}"?' if near else "; known are " + ", ".join(known))
