# SPDX-License-Identifier: Apache-2.0
"""What all of a model of REXS stands in: the gear unit with its casing and oils, and where its axes and wheels stand.

The gear unit's u runs along the crank to the flywheel, v up and w to the side (`frame.py`); every shaft lies along
u."""

from collections.abc import Mapping
from math import hypot

from ..countershaft.result import CountershaftResult
from ..countershaft.twins import Resolved
from ..design import step_inputs as h
from ..gears.profile.drawing import in_row
from ..library.catalogue import Oil
from ..library.lubricant import Lubricant
from ..sheet.text import Text
from ..sheet.units import Metre
from ..solve import Results
from .frame import frame_of
from .places import known_planes
from .rexs_file import Component, Place, RexsModel, pose

IN_A_ROW = Text(
    "Where the axes stand is not known: they stand in a row at their centre distances. position_mm of the wheels, or "
    "axis_mm of the shafts, says it."
)
AT_MID_ENGINE = Text("Where the wheels stand along the crank is not known: they stand at mid-engine. z_mm says it.")


class GearUnit:
    """The model of a design as it grows, and what is said of it.

    `along`: the wheels and sprockets in the flow of power.  `places`: of their axes, up and side from the crank's;
    `planes`: of their middles along the crank.  `carried`: by wheel its shaft, and where that begins; `gears`: the
    wheels themselves."""

    def __init__(self, results: Results) -> None:
        self.results, self.design = results, results.design
        self.train, self.frame = results.train, frame_of(results.design)
        self.model, self.notes = RexsModel(), list[Text]()
        self.along = self.design.gears.along if self.train is not None and self.design.gears is not None else ()
        self.places, self.planes = self._axes(), self._middles()
        self.carried: dict[str, tuple[Component, Metre]] = {}
        self.gears: dict[str, Component] = {}
        self._oils: dict[str, Component] = {}
        self.gear_unit = self._gear_unit()
        self.casing = self._casing()

    # --- what shafts and wheels ask

    def at(self, axis: complex, z: Metre) -> Place:
        """A point of the design in the gear unit: `axis` up and side from the crank's, z along it."""
        X, Y, Z = self.frame.place(axis.real, axis.imag, z)
        return Z, X, Y

    def carrier(self, shaft: Resolved) -> str:
        """The wheel or sprocket by which the train turns a shaft; empty: it does not."""
        return self.train.shafts[shaft.name].wheel if self.train and shaft.name in self.train.shafts else ""

    def solved(self, shaft: Resolved) -> CountershaftResult | None:
        """Of a twin that of its original."""
        return self.results.view(shaft.name).shaft

    def heads(self, wheel: str) -> bool:
        """Whether no mesh turns a wheel or sprocket, so that its shaft defines the speed of what it meshes with."""
        link = self.train.tree.driving.get(wheel) if self.train is not None else None
        return link is None or not link.toothed

    def material(self, of: Component, name: str) -> None:
        """A material of its own for each part that is made of it."""
        solid = self.design.materials[name]
        material = self.model.add(
            "material",
            name,
            material_designation=name,
            elastic_modulus=solid.E,
            poisson_ratio=solid.poisson,
            density=solid.density,
            thermal_expansion_coefficient_plus=solid.expansion or None,
        )
        self.model.relate("reference", origin=of, referenced=material)

    # --- where things stand

    def _axes(self) -> Mapping[str, complex]:
        train = self.train
        if train is None:
            return {}
        laid = train.layout
        if laid is not None:
            wheels = {name: w.position for name, w in laid.wheels.items() if w.position is not None}
            places = {**laid.sprockets, **wheels}
            if places.keys() >= set(self.along):
                return places
        self.notes.append(IN_A_ROW)
        return in_row(train)  # whose first way, there to the right, is up here

    def _middles(self) -> Mapping[str, Metre]:
        """Of each wheel and sprocket."""
        planes = known_planes(self.results)
        if not planes and self.train is not None and self.train.wheels:
            self.notes.append(AT_MID_ENGINE)
        return {name: planes.get(name, next(iter(planes.values()), 0.0)) for name in self.along}

    # --- what there is once

    def _gear_unit(self) -> Component:
        mounting = self.design.mounting
        X, Y, Z = self.frame.place(*(mounting.up if mounting is not None else (1.0, 0.0, 0.0)))
        length = hypot(X, Y, Z) or 1.0
        return self.model.add(
            "gear_unit",
            self.design.name,
            model_name=self.design.name,
            account_for_gravity=True,
            direction_vector_gravity_u=-Z / length,
            direction_vector_gravity_v=-X / length,
            direction_vector_gravity_w=-Y / length,
            **pose((0.0, 0.0, 0.0)),
        )

    def _casing(self) -> Component:
        """The engine block, and the oils of bearings and teeth behind it."""
        supply, teeth = self.design.bearings, h.mesh_oil(self.design)
        warm = supply.supply_temperature if supply is not None else teeth.temperature if teeth is not None else None
        casing = self.model.add("gear_casing", "engine block", temperature_lubricant=warm)
        self.model.relate("assembly", assembly=self.gear_unit, part=casing)
        law = supply.viscosity_law if supply is not None else "walther"
        self.bearing_oil = self._oil(self.design.oils[supply.oil], law) if supply is not None else None
        meshes = self.train is not None and self.train.meshes
        self.mesh_oil = self._oil(teeth.oil, teeth.viscosity_law) if teeth is not None and meshes else None
        if (oil := self.bearing_oil or self.mesh_oil) is not None:
            self.model.relate("reference", origin=casing, referenced=oil)
        return casing

    def _oil(self, oil: Oil, law: str) -> Component:
        if oil.name not in self._oils:
            lubricant, constant = Lubricant(oil, law), oil.viscosity is not None
            if constant:
                self.notes.append(Text("{oil} has one viscosity at every temperature: it is left out.", oil=oil.name))
            self._oils[oil.name] = self.model.add(
                "lubricant",
                oil.name,
                name=oil.name,
                viscosity_at_40_degree_celsius=None if constant else lubricant.nu40,
                viscosity_at_100_degree_celsius=None if constant else lubricant.nu100,
                density_at_15_degree_celsius=oil.rho15,
            )
        return self._oils[oil.name]
