# SPDX-License-Identifier: Apache-2.0
"""What an engine is described by: its crank throws, a diagram of torque in place of the gas, the engine as a whole."""

from collections.abc import Iterable, Iterator
from math import pi
from typing import ClassVar

from ..sheet.quantity import choice, dotted, inputs, integer, integers, keys, quantity, series, table, tables, text
from ..sheet.text import Amount, Text
from .gas import GasInputs, cycle_problems
from .operation import BenchPoint, CrankTwist, Operation, operation_problems

# --- a crank throw

# the folds of the form
CYLINDERS = Text("Cylinders, banks, cranks")
GAS = Text("Gas, bench, torque")


@inputs
class ThrowInputs:
    """One throw of the crank between its two main journals; all throws have the same.  Pin and journals are solid and
    round."""

    pin_diameter: float = quantity(
        "Crankpin diameter",
        "mm",
        up_to=1000,
        symbol="d_p",
        rule_of_thumb=(20, 120),
        help="Diameter of the crankpin, solid and round.",
        repair="free",
    )
    pin_length: float = quantity(
        "Crankpin length",
        "mm",
        up_to=1000,
        symbol="l_p",
        rule_of_thumb=(12, 90),
        help="Length of the crankpin between the webs.",
        repair="free",
    )
    journal_diameter: float = quantity(
        "Main journal diameter",
        "mm",
        up_to=1000,
        symbol="d_j",
        rule_of_thumb=(20, 140),
        help="Diameter of the main journals, solid and round.",
        repair="free",
    )
    journal_length: float = quantity(
        "Main journal length",
        "mm",
        up_to=1000,
        symbol="l_j",
        rule_of_thumb=(12, 90),
        help="Length of a main journal between the webs of two throws.",
        repair="free",
    )
    web_thickness: float = quantity(
        "Web thickness",
        "mm",
        up_to=1000,
        symbol="t_w",
        rule_of_thumb=(6, 60),
        help="Thickness of a web along the crank axis.",
        repair="free",
    )
    fillet_radius: float | None = quantity(
        "Fillet radius",
        "mm",
        default=None,
        up_to=500,
        symbol="rho",
        rule_of_thumb=(1, 8),
        help="Radius from pin and journal to the web. Left out: no notch stress.",
        repair="free",
    )
    material: str = text(
        "Material",
        help="A name from the table of materials or from [[material]]; its proof stress is the limit.",
        repair="free",
        catalogue="materials",
    )


# --- a torque over the crank angle that is given as a diagram, in place of the gas

FEWEST_ROWS = 3
SAME_ANGLE = 1e-9  # rad


@inputs
class TorquePoint:
    """One row of a torque diagram."""

    angle: float = quantity(
        "Crank angle", "°", within=(-1440, 1440), symbol="epsilon", help="After the firing of cylinder 1."
    )
    torque: float = quantity(
        "Torque", "N·m", within=(-1e9, 1e9), symbol="T", help="Of the whole engine on its crank, + in its sense."
    )


def diagram_problems(
    rows: tuple[TorquePoint, ...], period: float | None, strokes: int, gas: bool
) -> Iterator[tuple[str, Text]]:
    """What is wrong with a torque diagram, with keys of [engine]."""
    if not rows:
        if period is not None:
            reason = Text("belongs to a torque diagram, [[engine.torque]]; leave it out")
            yield dotted(EngineInputs.torque_period), reason
        return
    if gas:
        reason = Text("the gas gives the torque already: leave out [[engine.torque]] or [engine.gas]")
        yield dotted(EngineInputs.torque), reason
    if len(rows) < FEWEST_ROWS:
        reason = Text("has {count} rows; needs at least {fewest} over its period", count=len(rows), fewest=FEWEST_ROWS)
        yield dotted(EngineInputs.torque), reason
    length = period if period is not None else strokes * pi
    shown = Amount(length / pi * 180, form="g")
    for i, row in enumerate(rows):
        if i and row.angle <= rows[i - 1].angle:
            reason = Text("must be above that of the row before; a jump takes two rows, a hundredth of a degree apart")
            yield dotted(EngineInputs.torque, i, TorquePoint.angle), reason
    if rows[-1].angle - rows[0].angle > length + SAME_ANGLE:
        reason = Text("lies more than the period of {length}° behind the first row", length=shown)
        yield dotted(EngineInputs.torque, len(rows) - 1, TorquePoint.angle), reason
    elif abs(rows[-1].angle - rows[0].angle - length) <= SAME_ANGLE and rows[-1].torque != rows[0].torque:
        reason = Text("must be that of the first row, {length}° before it: the diagram closes", length=shown)
        yield dotted(EngineInputs.torque, len(rows) - 1, TorquePoint.torque), reason


# --- the engine

# usual λ; Finotti 2013, 2.1, and the mechanics textbook, 48.3.3; Finotti 2013, 2.2.4, has 0.2 to 0.3
CRANK_RATIO = (0.22, 0.30)

# Firing orders of inline engines: usual ones, else of all (above nine cylinders: of symmetrical cranks) the one that
# leaves least.
FOUR_STROKE = {
    1: (1,),
    2: (1, 2),
    3: (1, 3, 2),
    4: (1, 3, 4, 2),
    5: (1, 2, 4, 5, 3),
    6: (1, 5, 3, 6, 2, 4),
    7: (1, 2, 4, 6, 7, 5, 3),
    8: (1, 6, 2, 5, 8, 3, 7, 4),
    9: (1, 2, 4, 6, 8, 9, 7, 5, 3),
    10: (1, 2, 3, 4, 5, 10, 9, 8, 7, 6),
    11: (1, 2, 4, 6, 8, 10, 11, 9, 7, 5, 3),
    12: (1, 2, 3, 4, 5, 6, 12, 11, 10, 9, 8, 7),
}
TWO_STROKE = {
    1: (1,),
    2: (1, 2),
    3: (1, 3, 2),
    4: (1, 3, 4, 2),
    5: (1, 5, 2, 3, 4),
    6: (1, 6, 2, 4, 3, 5),
    7: (1, 7, 2, 5, 4, 3, 6),
    8: (1, 8, 2, 6, 4, 5, 3, 7),
    9: (1, 9, 2, 7, 4, 5, 6, 3, 8),
    10: (1, 9, 4, 7, 2, 10, 3, 5, 6, 8),
    11: (1, 11, 2, 9, 4, 7, 6, 5, 8, 3, 10),
    12: (1, 11, 9, 4, 2, 12, 7, 5, 3, 10, 8, 6),
}


def usual_order(cylinders: int, strokes: int) -> tuple[int, ...] | None:
    """The firing order that is taken for an inline engine where none is given."""
    return (FOUR_STROKE if strokes == 4 else TWO_STROKE).get(cylinders)


@inputs
class EngineInputs:
    """Crank train, masses and rated speed."""

    REFUSED: ClassVar[dict[str, Text]] = {"stroke_mm": Text("is not known; give crank_radius_mm, which is half of it")}

    name: str = text("Engine", help="A name for screen and report.")
    layout: str = choice(
        "Layout",
        "inline",
        "vee",
        "boxer",
        "w",
        "radial",
        help="All but inline need crank angles or a firing order.",
        fold=CYLINDERS,
    )
    cylinders: int = integer(
        "Cylinders",
        within=(1, 16),
        symbol="N",
        help="Number of cylinders, counted from the timing side.",
        fold=CYLINDERS,
    )
    strokes: int = integer(
        "Strokes", within=(2, 4), step=2, help="4 for a four-stroke, 2 for a two-stroke engine.", fold=CYLINDERS
    )
    bore: float = quantity(
        "Bore",
        "mm",
        up_to=1000,
        symbol="D",
        rule_of_thumb=(50, 150),
        help="Diameter of the cylinders, on which the gas presses.",
        decides=1,
    )
    crank_radius: float = quantity(
        "Crank radius",
        "mm",
        up_to=1000,
        symbol="r",
        rule_of_thumb=(20, 90),
        help="Half the stroke: from the crank's axis to the pin's.",
    )
    rod_length: float = quantity(
        "Rod length",
        "mm",
        up_to=4000,
        symbol="L",
        rule_of_thumb=(80, 300),
        help=Text(
            "Between centres. λ = r/L is usually {low} to {high}; a longer rod lowers the second order.",
            low=Amount(CRANK_RATIO[0]),
            high=Amount(CRANK_RATIO[1]),
        ),
        change=("shorter rods", "longer rods"),
        decides=3,
    )
    cylinder_pitch: float | None = quantity(
        "Cylinder pitch",
        "mm",
        default=None,
        up_to=2000,
        symbol="a",
        rule_of_thumb=(35, 200),
        help="Distance of neighbouring cylinders of a bank. May be left out where axial positions are given: then it "
        "is theirs.",
        decides=8,
    )
    cylinder_offset: float = quantity(
        "Cylinder offset",
        "mm",
        default=0.0,
        within=(-500, 500),
        symbol="d",
        source="Finotti 2013, 2.1",
        help="Cylinder axis to crank axis; positive moves TDC to later crank angles. Usual up to 0.045 rod lengths.",
        fold=CYLINDERS,
    )
    bank_angle: float | None = quantity(
        "Bank angle",
        "°",
        default=None,
        within=(0, 180),
        symbol="V",
        rule_of_thumb=(10, 180),
        help="Between the banks of a vee engine, of a VR engine 10° to 15°; a boxer has 180°.",
        where=(layout, "vee", "boxer"),
        fold=CYLINDERS,
    )
    cylinder_directions: tuple[float, ...] | None = series(
        "Directions of the cylinders",
        "°",
        default=None,
        within=(-360, 360),
        symbol="psi",
        help="One per cylinder of a W or radial engine: its axis from up, + in the sense of crank rotation. Left out, "
        "those of a radial engine stand evenly around, 1 up.",
        where=(layout, "w", "radial"),
        fold=CYLINDERS,
    )
    firing_order: tuple[int, ...] | None = integers(
        "Firing order",
        default=None,
        low=1,
        source="Finotti 2013, 2.4",
        help="Cylinder numbers, 1 first. The crank angles of an evenly firing engine follow from it.",
        repair="asked",
        fold=CYLINDERS,
    )
    crank_angles: tuple[float, ...] | None = series(
        "Crank angles",
        "°",
        default=None,
        within=(-720, 720),
        symbol="phi",
        help="One per cylinder, of the pin it runs on; positive leads cylinder 1.",
        repair="asked",
        fold=CYLINDERS,
    )
    axial_positions: tuple[float, ...] | None = series(
        "Axial positions",
        "mm",
        default=None,
        within=(-5000, 5000),
        symbol="z",
        help="One per cylinder, + towards the flywheel.",
        fold=CYLINDERS,
    )
    bank_of_cylinder: tuple[int, ...] | None = integers(
        "Bank of each cylinder",
        default=None,
        within=(0, 1),
        help="The bank of each cylinder, 0 or 1; bank 0 stands at −V/2.",
        where=(layout, "vee", "boxer"),
        fold=CYLINDERS,
    )
    crank_radii: tuple[float, ...] | None = series(
        "Crank radii",
        "mm",
        default=None,
        up_to=1000,
        symbol="r_k",
        help="One per cylinder, where they differ; the first is the crank radius. Left out: all cylinders have that "
        "one.",
        fold=CYLINDERS,
    )
    cylinder_offsets: tuple[float, ...] | None = series(
        "Cylinder offsets",
        "mm",
        default=None,
        within=(-500, 500),
        symbol="d_k",
        help="One per cylinder, where they differ; the first is the cylinder offset. A VR engine, whose axes meet "
        "below the crank, has them below zero in bank 0, above in bank 1. Left out: all cylinders have that one.",
        fold=CYLINDERS,
    )
    piston_mass: float | None = quantity(
        "Piston mass",
        "g",
        default=None,
        up_to=1e5,
        symbol="M_P",
        rule_of_thumb=(150, 2000),
        help="Mass of one piston with rings, pin and circlips.",
        decides=4,
    )
    rod_mass: float | None = quantity(
        "Rod mass",
        "g",
        default=None,
        within=(0, 1e5),
        symbol="M_B",
        rule_of_thumb=(200, 2000),
        help="Mass of one rod with bush and screws, without big-end shells.",
        decides=5,
    )
    rod_cg_to_big_end: float | None = quantity(
        "Rod CG to big end",
        "mm",
        default=None,
        within=(0, 4000),
        symbol="X_2",
        rule_of_thumb=(20, 120),
        help="Centre of gravity of the rod from its big end. Left out: one third of the rod reciprocates, two thirds "
        "rotate.",
        decides=6,
    )
    crankpin_bearing_mass: float = quantity(
        "Big-end shells",
        "g",
        default=0.0,
        within=(0, 1e5),
        symbol="M_shell",
        rule_of_thumb=(0, 500),
        help="Mass of the shells of one big end; they rotate with the pin.",
    )
    reciprocating_masses: tuple[float, ...] | None = series(
        "Reciprocating masses",
        "kg",
        default=None,
        up_to=1e6,
        symbol="M_alt",
        help="One for all cylinders, or one per cylinder. Left out: piston and the rod's share.",
    )
    rotating_masses: tuple[float, ...] | None = series(
        "Rotating masses",
        "kg",
        default=None,
        within=(0, 1e6),
        symbol="M_rot",
        help="At the crank radius: one for all cylinders, or one per cylinder. Left out: the rod's share and the "
        "shells.",
    )
    rated_speed: float = quantity(
        "Rated speed",
        "rpm",
        within=(1, 30000),
        symbol="n",
        rule_of_thumb=(1000, 13000),
        help="The speed at which forces and bearings are judged.",
        repair="asked",
        decides=7,
        taken_by=("imbalance", "countershaft", "bearings", "gears"),
    )
    idle_speed: float | None = quantity(
        "Idle speed",
        "rpm",
        default=None,
        within=(200, 3000),
        symbol="n_i",
        rule_of_thumb=(500, 1800),
        help="At which the engine runs by itself. Left out: that of [mounting], else 0.13 of the rated speed, held "
        "from 600 to 1300 rpm.",
        repair="asked",
        fold=GAS,
    )
    rated_power: float | None = quantity(
        "Rated power",
        "kW",
        default=None,
        up_to=1e5,
        symbol="P_e",
        rule_of_thumb=(2, 600),
        help="Brake power at rated speed: gives the brake mean effective pressure, and the share of it that the "
        "train's losses take.",
        repair="asked",
        decides=9,
    )
    flywheel_inertia: float | None = quantity(
        "Inertia of the flywheel",
        "kg·m²",
        default=None,
        up_to=1e5,
        symbol="J",
        rule_of_thumb=(0.005, 10),
        help="Moment of inertia of the flywheel; with the gas it gives the speed irregularity.",
        change=("lighter flywheel", "heavier flywheel"),
        repair="free",
    )
    operation: tuple[Operation, ...] = tables(
        "Operation",
        Operation,
        default=(),
        help="How the engine runs: speed and load, with gas, oil and hours. Bearings, gear train and mounts read it.",
        fold=GAS,
    )
    bench: tuple[BenchPoint, ...] = tables(
        "Bench run",
        BenchPoint,
        default=(),
        help="Oil in the main gallery over speed. Left out: the rows of [[engine.operation]] with temperature and "
        "pressure of the oil.",
        fold=GAS,
    )
    crank_twist: CrankTwist | None = table(
        "Twist of the crank",
        CrankTwist,
        default=None,
        help="Its first mode, for a gear train at its nose. Left out: the crank is rigid.",
        fold=GAS,
    )

    gas: GasInputs | None = table(
        "Gas", GasInputs, default=None, help="Pressure in the cylinders: torque over the cycle.", fold=GAS
    )
    torque: tuple[TorquePoint, ...] = tables(
        "Torque over the crank angle",
        TorquePoint,
        default=(),
        help="The turning-moment diagram of the whole engine, in place of the gas; straight lines between its rows.",
        fold=GAS,
    )
    torque_period: float | None = quantity(
        "Period of the torque",
        "°",
        default=None,
        up_to=1440,
        symbol="epsilon_T",
        help="After which the diagram repeats itself. Left out: the cycle, 720° of a four-stroke engine.",
        fold=GAS,
    )
    throw: ThrowInputs | None = table(
        "Crank throw", ThrowInputs, default=None, help="Pin, journal and web: stresses of the crank.", fold=GAS
    )

    @property
    def gallery(self) -> tuple[BenchPoint, ...]:
        """The oil in the main gallery: the bench run, else the rows of operation that say both of it, of equal speeds
        the one of the highest load."""
        if self.bench:
            return self.bench
        rows = {
            row.speed: BenchPoint(speed=row.speed, oil_temperature=row.oil_temperature, oil_pressure=row.oil_pressure)
            for row in sorted(self.operation, key=lambda row: row.load)
            if row.oil_temperature is not None and row.oil_pressure is not None
        }
        return tuple(rows.values())

    @property
    def unlike_masses(self) -> bool:
        """Whether the masses differ from cylinder to cylinder."""
        return any(
            masses is not None and len(set(masses)) > 1 for masses in (self.reciprocating_masses, self.rotating_masses)
        )

    @property
    def unlike_radii(self) -> bool:
        """Whether the crank radii do."""
        return self.crank_radii is not None and len(set(self.crank_radii)) > 1

    @property
    def unlike_offsets(self) -> bool:
        """Whether the cylinder offsets do."""
        return self.cylinder_offsets is not None and len(set(self.cylinder_offsets)) > 1

    @property
    def unlike_motions(self) -> bool:
        """Whether the pistons move unlike each other."""
        return self.unlike_radii or self.unlike_offsets

    @property
    def unlike(self) -> bool:
        return self.unlike_masses or self.unlike_motions

    @property
    def radii(self) -> tuple[float, ...]:
        """The crank radius of each cylinder [m]."""
        return self.crank_radii or (self.crank_radius,) * self.cylinders

    @property
    def offsets(self) -> tuple[float, ...]:
        """The offset of each cylinder [m]."""
        return self.cylinder_offsets or (self.cylinder_offset,) * self.cylinders

    def problems(self) -> Iterable[tuple[str, Text]]:
        """What no single field can show: (key, reason)."""
        n = self.cylinders
        yield from self._mass_problems()
        yield from self._motion_problems()
        if self.strokes == 3:
            yield dotted(EngineInputs.strokes), Text("must be 2 or 4")
        yield from diagram_problems(self.torque, self.torque_period, self.strokes, self.gas is not None)
        if self.gas is not None:
            yield from ((f"gas.{key}", reason) for key, reason in cycle_problems(self.gas, self.strokes))
        operation = dotted(EngineInputs.operation)
        for key, reason in operation_problems(self.operation, self.gas, self.strokes):
            yield f"{operation}.{key}", reason
        if self.idle_speed is not None and self.idle_speed >= self.rated_speed:
            rated = Amount(self.rated_speed * 60, form="g")
            yield dotted(EngineInputs.idle_speed), Text("must stay below the rated speed, {rated} rpm", rated=rated)
        if self.rod_cg_to_big_end is not None and self.rod_cg_to_big_end > self.rod_length:
            yield dotted(EngineInputs.rod_cg_to_big_end), Text("must not exceed the rod length")
        if n != n:  # not given as a number: nothing to compare with
            return
        for key, given in (
            (dotted(EngineInputs.firing_order), self.firing_order),
            (dotted(EngineInputs.crank_angles), self.crank_angles),
            (dotted(EngineInputs.crank_radii), self.crank_radii),
            (dotted(EngineInputs.cylinder_offsets), self.cylinder_offsets),
            (dotted(EngineInputs.cylinder_directions), self.cylinder_directions),
            (dotted(EngineInputs.axial_positions), self.axial_positions),
            (dotted(EngineInputs.bank_of_cylinder), self.bank_of_cylinder),
        ):
            if given is not None and len(given) != n:
                yield key, Text("has {count} entries; needs one per cylinder, {n}", count=len(given), n=n)
        if (
            self.firing_order is not None
            and len(self.firing_order) == n
            and sorted(self.firing_order) != list(range(1, n + 1))
        ):
            yield dotted(EngineInputs.firing_order), Text("must name each cylinder from 1 to {n} once", n=n)
        if self.crank_angles is None and self.firing_order is None and (self.layout != "inline" or n > 12):
            reason = Text("needed here: give the crank angles, or the firing order of an evenly firing engine")
            yield dotted(EngineInputs.crank_angles), reason
        if self.layout != "vee" and self.bank_angle:
            yield dotted(EngineInputs.bank_angle), Text("belongs to a vee engine; leave it out")
        if self.layout == "vee" and self.bank_angle is None:
            yield dotted(EngineInputs.bank_angle), Text("needed for a vee engine")
        if self.layout == "inline" and self.bank_of_cylinder is not None and any(self.bank_of_cylinder):
            yield dotted(EngineInputs.bank_of_cylinder), Text("an inline engine has bank 0 only")
        if self.layout in ("w", "radial"):
            if self.bank_of_cylinder is not None:
                reason = Text("belongs to two banks; cylinder_directions_deg says where these cylinders stand")
                yield dotted(EngineInputs.bank_of_cylinder), reason
        elif self.cylinder_directions is not None:
            yield dotted(EngineInputs.cylinder_directions), Text("belongs to a W or radial engine; leave it out")
        if self.layout == "w" and self.cylinder_directions is None:
            yield dotted(EngineInputs.cylinder_directions), Text("needed for a W engine")
        if self.cylinder_pitch is None and self.axial_positions is None:
            yield dotted(EngineInputs.cylinder_pitch), Text("needed, or axial_positions_mm in its place")
        if self.layout == "inline" and n > 12:
            yield dotted(EngineInputs.cylinders), Text("an inline engine has at most 12")

    def _mass_problems(self) -> Iterable[tuple[str, Text]]:
        """Masses are given by piston and rod, or as they move; cylinder by cylinder, or one for all."""
        if self.reciprocating_masses is None:
            for key, given in (
                (dotted(EngineInputs.piston_mass), self.piston_mass),
                (dotted(EngineInputs.rod_mass), self.rod_mass),
            ):
                if given is None:
                    allowed = keys(EngineInputs)[key].about.allowed()
                    yield (
                        key,
                        Text(
                            "is missing; needs {allowed}, or reciprocating_masses_kg instead of piston and rod",
                            allowed=allowed,
                        ),
                    )
        elif self.piston_mass is not None:
            reason = Text("reciprocating_masses_kg has its mass already; leave one of the two out")
            yield dotted(EngineInputs.piston_mass), reason
        if self.rotating_masses is not None and self.crankpin_bearing_mass:
            reason = Text("rotating_masses_kg has its mass already; leave one of the two out")
            yield dotted(EngineInputs.crankpin_bearing_mass), reason
        for key, masses in (
            (dotted(EngineInputs.reciprocating_masses), self.reciprocating_masses),
            (dotted(EngineInputs.rotating_masses), self.rotating_masses),
        ):
            if masses is not None and len(masses) not in (1, self.cylinders) and self.cylinders == self.cylinders:
                yield (
                    key,
                    Text(
                        "has {count} entries; needs one, or one per cylinder, {n}", count=len(masses), n=self.cylinders
                    ),
                )
        if self.unlike and self.throw is not None:
            yield (
                dotted(EngineInputs.throw),
                Text(
                    "its stresses are those of a crank whose cylinders are alike: leave it out where masses, radii or "
                    "offsets differ"
                ),
            )

    def _motion_problems(self) -> Iterable[tuple[str, Text]]:
        """Crank radii and offsets: whether each crank turns, and what has no one answer for cylinders that differ."""
        if self.crank_radius + abs(self.cylinder_offset) >= self.rod_length:
            reason = Text("must be longer than crank radius plus cylinder offset: the crank could not turn")
            yield dotted(EngineInputs.rod_length), reason
        given = self.cylinders == self.cylinders and (self.crank_radii or self.cylinder_offsets)
        key = dotted(EngineInputs.cylinder_offsets if self.crank_radii is None else EngineInputs.crank_radii)
        for k, (r_k, d_k) in enumerate(zip(self.radii, self.offsets) if given else (), 1):
            if r_k + abs(d_k) >= self.rod_length:
                mm = Amount((r_k + abs(d_k)) * 1e3, form="g")
                reason = Text(
                    "cylinder {k}: radius plus offset, {mm} mm, is not below rod_length_mm: the crank could not turn",
                    k=k,
                    mm=mm,
                )
                yield key, reason
        r, d = self.crank_radius, self.cylinder_offset
        if self.crank_radii is not None and self.crank_radii[:1] != (r,) and r == r:  # not given as a number: said
            mm = Amount(r * 1e3, form="g")
            reason = Text("must begin with crank_radius_mm, {mm} mm, which is that of cylinder 1: change both", mm=mm)
            yield dotted(EngineInputs.crank_radii), reason
        if self.cylinder_offsets is not None and self.cylinder_offsets[:1] != (d,) and d == d:
            mm = Amount(d * 1e3, form="g")
            reason = Text(
                "must begin with cylinder_offset_mm, {mm} mm, which is that of cylinder 1: change both", mm=mm
            )
            yield dotted(EngineInputs.cylinder_offsets), reason
        if self.gas is not None and self.unlike_motions:
            reason = Text(
                "its pressure is that of cylinders of one motion: leave it out where crank radii or offsets differ; "
                "[[engine.torque]] may take its place"
            )
            yield dotted(EngineInputs.gas), reason
