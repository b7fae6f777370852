# SPDX-License-Identifier: Apache-2.0
"""The rows of one balance shaft at one speed: its bearings, order by order, its weight, and what its bending adds."""

from collections.abc import Container, Iterator, Mapping

import numpy as np

from ..gears.result import TrainResult
from ..mounting.excitation import horizontal, moment_about_x, moment_about_y, vertical
from ..sheet.record import record
from ..sheet.text import SEMICOLON, Amount, Name, Text
from ..sheet.units import Number, Radian, RevPerSecond, Watt
from .frame import Vector
from .load_rows import NOTHING, Book, LoadRow
from .mesh_loads import MeshForce
from .shaft_loads import OnWheel, ShaftAtSpeed, TurningForces, Wrench, standing, turning

WHY = {  # of the rows, the value that differs
    ("load", "reaction"): Text(" of rigid bearings: films and bending share the load in another way"),
    ("load", "levers"): Text(" of a rigid shaft: what it bends adds to the load"),
    ("reaction", "levers"): Text(" of a rigid shaft: what it bends adds to the load"),
    ("levers", "reaction"): Text(", which has what the bent shaft adds"),
}


@record
class ShaftRows:
    """`several`: the design has more shafts, so that bearings are called by both names; `up`: against which weight
    acts, in the axes of the design."""

    book: Book
    speed: RevPerSecond
    shaft: ShaftAtSpeed
    several: bool
    up: tuple[float, ...]

    def rows(
        self,
        off: tuple[Number, Radian],
        losses: Mapping[str, Watt],
        train: TrainResult | None,
        teeth: Mapping[str, MeshForce | None],
    ) -> Iterator[LoadRow]:
        """`off`: by how much the couple is too large and the shaft is late; `losses`: of its journals; `teeth`: of the
        meshes of the train."""
        if self.shaft.axis is None:
            self.book.notes[f"axis {self.name}"] = Text(
                "where {shaft} stands is not known: X and Y of its rows are empty (give axis_mm = [up, side])",
                shaft=Name(self.name),
            )
        yield from self._turning(turning(self.shaft, *map(float, off)))
        yield from self._standing(losses, self._on_wheel(train, teeth))

    @property
    def name(self) -> str:
        return self.shaft.name

    def beside_check(self, ids: Container[str]) -> Text:
        """Which values of the results (`ids`) the bearings' rows of the shaft as designed are, and how another one
        differs."""
        result, found = self.shaft.result, self.shaft.bearings.bearings if self.shaft.bearings is not None else {}
        known = {
            "load": ("bearings.{of}*.load", {name: r.load for name, r in found.items()}),
            "reaction": ("countershaft.{of}reaction_*", result.loads),
            "levers": ("countershaft.{of}reaction_*_levers", result.loads_by_levers),
        }
        like = turning(self.shaft).like
        other = "levers" if like != "levers" and result.loads_by_levers else "reaction"
        (mine, loads), (else_, beside) = known[like], known[other]
        words = Text(
            "{shaft}: the rows bearing equal {value} of check", shaft=Name(self.name), value=self._id(mine, ids)
        )
        at = [Text("{bearing} {load} N", bearing=Name(name), load=f"{R:.6g}") for name, R in loads.items()]
        if other != like:
            words = Text("{words}, not {other}{why}", words=words, other=self._id(else_, ids), why=WHY[like, other])
            at = [Text("{row}, not {other}", row=row, other=f"{beside[name]:.6g}") for row, name in zip(at, loads)]
        speed = Amount(self.speed * 60, "rpm", form="g")
        return Text("{words}; at {speed} {loads}", words=words, speed=speed, loads=SEMICOLON.join(at))

    def _id(self, pattern: str, ids: Container[str]) -> Name:
        """Of this shaft, or of its original where a twin has no value of its own."""
        names = (f"{name}." if self.several else "" for name in (self.name, self.shaft.shaft.of or self.name))
        filled = [pattern.format(of=of) for of in names]
        first = next(iter(self.shaft.places))
        return Name(next((one for one in filled if one.replace("*", first) in ids), filled[-1]))

    def _row(self, kind: str, place: str, order: float, z: float, force: Vector, moment: Vector = NOTHING) -> LoadRow:
        on = "block" if kind == "bearing" else f"shaft {self.name}"
        if kind == "bearing" and self.several:
            place = f"{self.name}.{place}"
        return LoadRow(self.speed, kind, place, on, order, self.book.place(self.shaft.axis, z), force, moment)

    # --- what turns

    def _turning(self, found: TurningForces) -> Iterator[LoadRow]:
        order, places, name = self.shaft.order, self.shaft.places, self.name
        rows = [self._row("bearing", of, order, places[of], *self._rotating((F, 0j))) for of, F in found.forces.items()]
        for place, wrench in ((name, found.inertia), (f"{name}.outline", found.outline)):
            if wrench is not None:
                rows.append(self._row("inertia", place, order, 0.0, *self._rotating(wrench)))
        if found.outline is not None:
            self.book.notes[f"outline {name}"] = Text(
                "the outline of {shaft} has not the unbalance of its masses: its bearings carry that of the outline, "
                "and a row inertia has the difference",
                shaft=Name(name),
            )
        if found.inertia is not None and any(row.load is not None for row in self.shaft.shaft.inputs.bearings):
            self.book.notes[f"given {name}"] = Text(
                "loads that are given for bearings of {shaft} have no direction: their rows are those of the bent "
                "shaft on rigid bearings",
                shaft=Name(name),
            )
        asked = self._row("", "", order, 0.0, *self._rotating(found.total))
        self.book.closed(f"shaft {name}, order {order:g}: ω² times its unbalance", rows, [asked])
        yield from rows

    def _rotating(self, wrench: Wrench) -> tuple[Vector, Vector]:
        """Phasors of a force that turns with the shaft, and of a couple Σ z·F: one that turns backward enters
        conjugated."""
        (F, C), forward = wrench, self.shaft.sense > 0
        (p, m), (q, r) = ((F, 0j), (C, 0j)) if forward else ((0j, F), (0j, C))
        force = self.book.frame.vector(vertical(p=p, m=m), horizontal(p=p, m=m), 0j)
        return force, self.book.frame.moment(moment_about_x(p=q, m=r), moment_about_y(p=q, m=r), 0j)

    # --- what stands still

    def _standing(self, losses: Mapping[str, Watt], wheel: OnWheel | None) -> Iterator[LoadRow]:
        """Of each bearing its share of weight and teeth, its friction torque and, where it locates the shaft, the
        thrust."""
        found, name, frame = standing(self.shaft, wheel, losses), self.name, self.book.frame
        down = -np.array(self.up, dtype=float) / np.linalg.norm(self.up)
        if found.weights is None:
            self.book.left_out[f"weight {name}"] = Text(
                "the weight of {shaft} on its bearings: its outline is not known", shaft=Name(name)
            )
        G, z_S = found.weight if found.weight is not None and found.weights is not None else (0.0, 0.0)
        x, y, z = (G * down).tolist()
        thrust = z + (wheel.thrust if wheel is not None else 0.0)
        locating, said = self.shaft.locating
        if thrust and not said:
            self.book.notes[f"locates {name}"] = Text(
                "no bearing of {shaft} is said to locate it: the rear one, {bearing}, has its thrust",
                shaft=Name(name),
                bearing=Name(locating),
            )
        rows = []
        for place, at in self.shaft.places.items():
            across = complex(x, y) * (found.weights or {}).get(place, 0.0) + (found.teeth or {}).get(place, 0j)
            along = thrust if place == locating else 0.0
            torque = self.shaft.sense * found.friction.get(place, 0.0)
            force, moment = frame.vector(across.real, across.imag, along), frame.moment(0.0, 0.0, torque)
            if any((*force, *moment)):
                rows.append(self._row("bearing", place, 0.0, at, force, moment))
        asked = [self._row("", "", 0.0, z_S, frame.vector(x, y, z))]
        if wheel is not None and found.teeth is not None:
            F, C = wheel.force, wheel.couple
            force, moment = frame.vector(F.real, F.imag, wheel.thrust), frame.moment(-C.imag, C.real, 0.0)
            asked.append(self._row("", "", 0.0, wheel.z, force, moment))
        # friction stands against the torque of the wheel, which has other losses too: not added up
        without = [self._row("", "", 0.0, row.at[2], row.force) for row in rows]
        self.book.closed(f"shaft {name}, order 0: weight and teeth", without, asked)
        yield from rows
        if found.weight is not None:
            G, z_S = found.weight
            yield self._row("weight", name, 0.0, z_S, frame.vector(*(G * down).tolist()))

    def _on_wheel(self, train: TrainResult | None, teeth: Mapping[str, MeshForce | None]) -> OnWheel | None:
        """What the teeth do to the shaft's wheel; None where it has none, or the places of the wheels are not known."""
        if train is None or self.name not in train.shafts:
            return None
        own = train.shafts[self.name].wheel
        if any(own in (stage.driver, stage.driven) for stage in train.stages.values()):
            self.book.left_out[f"pull {self.name}"] = Text(
                "the pull of the chain or belt on {shaft}, whose direction is not known", shaft=Name(self.name)
            )
        mine = [key for key, mesh in train.meshes.items() if own in (mesh.driver, mesh.driven)]
        forces = [force for key in mine if (force := teeth.get(key)) is not None]
        position = train.layout.wheels[own].position if train.layout is not None and own in train.wheels else None
        if not mine or len(forces) < len(mine) or position is None or self.shaft.result.wheel is None:
            return None
        whole, couple, thrust = 0j, 0j, 0.0
        for force in forces:
            sign = 1.0 if force.mesh.driver == own else -1.0
            along = sign * force.thrust * self.book.frame.turn  # towards the flywheel
            whole, thrust, couple = whole + sign * force.across, thrust + along, couple - along * (force.at - position)
        return OnWheel(whole, couple, thrust, float(self.shaft.result.wheel))
