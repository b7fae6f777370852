# SPDX-License-Identifier: Apache-2.0
"""What the shaft's making asks: permitted unbalance, holes, scatter, bolts, support and its load cases, oil drain.

Each part where it is asked for."""

import cmath
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING

from ...imbalance.curves import DRAWN
from ...library.catalogue import Material, proof_of
from ...sheet.check import Check, CheckRule, Missing
from ...sheet.deferred import Later, Many
from ...sheet.linked_array import column
from ...sheet.quantity import dotted
from ...sheet.record import replace
from ...sheet.step import Curve, Outcome, Table
from ...sheet.text import EMPTY, Amount, Text
from ...sheet.units import KilogramPerMetre3, Metre, Number, RadPerSecond
from ...sheet.value import about, based_on, trace
from .. import formulas as f
from ..balancing import told
from ..balancing.checks import checks as balancing_checks
from ..balancing.solve import Made
from ..balancing.solve import sheet as balancing_sheet
from ..inputs import EccentricMass, ShaftInputs
from ..outline import Journals, density_ratio
from ..result import CountershaftResult
from ..rows import EACH_ROW, SHAFT, BearingRow, called
from ..sizing.choices import Seat, compared, compared_table
from ..sizing.sectors import LEFT_OVER, ShaftTask
from ..sums import SystemShaft
from . import bolts, drain, scatter
from . import unbalance as balance
from .inputs import ShaftSupport
from .unbalance import HolesResult, ToleranceResult

if TYPE_CHECKING:
    from ..balancing.result import BalancingResult
    from .drain import DrainResult
    from .scatter import ScatterResult


# --- the loads of the support for finite elements, as Finotti 2013, 4.7 (in chapter 6), takes them
# Four instants of a turn, bolts tight.  The stresses that they give come back as `bolt_stress` and `load_stress` of
# the support; its bolts are judged for every direction.

CASES = 4  # a quarter of a turn apart


def table(shaft: ShaftInputs, result: CountershaftResult) -> list[Table]:
    """Forces of the shaft on both its bearings, the first one's upwards first; none where they have more supports or
    carry nothing."""
    if len(shaft.bearings) != 2 or not abs(result.reactions[0]):
        return []
    on_bearings = [-R for R in result.reactions]
    upwards = abs(on_bearings[0]) / on_bearings[0]
    preload = () if result.bolts is None else (float(result.bolts.bolt_preload),)
    rows = []
    for n in range(CASES):
        turn = upwards * cmath.exp(2j * math.pi * n / CASES)
        forces = (part for force in on_bearings for part in ((force * turn).real, (force * turn).imag))
        rows.append((n + 1, 360.0 * n / CASES, *(round(x, 9) + 0.0 for x in forces), *preload))
    columns = [
        (Text("case"), ""),
        (Text("direction, {row}", row=called(shaft.bearings[0].name)), "°"),
    ]
    for row in shaft.bearings:
        name = called(row.name)
        columns += [(Text("{row}, up", row=name), "N"), (Text("{row}, side", row=name), "N")]
    bolts = EMPTY
    if shaft.bolts is not None:
        columns.append((Text("each bolt"), "N"))
        bolts = Text(" Each of the {count} bolts presses with its preload.", count=shaft.bolts.count)
    speed = Amount(result.omega / (2 * math.pi) * 60, form=".4g")
    note = Text(
        "Forces of the shaft on its bearings at {n} rpm, at four instants of a turn (Finotti 2013, 4.7, in chapter 6, "
        "spreads each over 60° of its seat); side is 90° further in the sense of crank rotation. Weight and gear force "
        "are left out, as there.{bolts} The stresses that finite elements find with them belong to "
        "[shafts.support].",
        n=speed,
        bolts=bolts,
    )
    return [Table("support_loads", Text("Load cases of the support"), tuple(columns), tuple(rows), note)]


# --- the parts


@dataclass
class ShaftStep:
    """What the parts of the step have in common, and what they add to its outcome."""

    shaft: ShaftInputs
    todo: ShaftTask
    materials: Mapping[str, Material]
    journals: Journals
    omega: RadPerSecond  # of the shaft
    checks: list[Check] = field(default_factory=list)
    notes: list[Text] = field(default_factory=list)
    tables: Many[Table] = ()
    curves: Many[Curve] = ()

    @property
    def material(self) -> Material:
        """Of the shaft."""
        return self.materials[self.shaft.material]

    @property
    def sector_density(self) -> KilogramPerMetre3:
        return self.materials[self.shaft.of_sectors].density

    @cached_property
    def heavier(self) -> Number:
        """The density of the sectors over that of the core."""
        if self.shaft.of_sectors == self.shaft.material:
            return 1.0
        with about(Text("sectors of the shaft")):
            return density_ratio(rho_s=self.sector_density, rho=self.material.density)


def making(
    step: ShaftStep, masses: tuple[EccentricMass, ...], result: CountershaftResult, R: Metre | None
) -> CountershaftResult:
    """The result with all of it but the bending; `R`: outer radius of the sectors, where it is known."""
    shaft, materials, journals = _with_wall(step.shaft, step.journals), step.materials, step.journals
    result = replace(result, tolerance=_permitted(step, result), holes=_holes(step, masses, result, R))
    result = replace(result, balancing=_balancing(step, masses, result, R))
    scattered, other, bolted = _scatter(step, masses, result), None, None
    if shaft.cost is not None or shaft.mode == "size":
        loads = list(result.loads.values())
        ends = zip((*journals[:1], *journals[-1:]), (loads[0], loads[-1]))
        seat = max((Seat(d, l, load) for (d, l), load in ends), key=lambda seat: seat.diameter, default=None)
        mass = result.mass if shaft.sector_material is None else None  # else not all of it is in the other material
        other = compared(shaft, materials, R, shaft.core_radius, result.eccentric_mass, mass, seat)
        what = Text("force") if result.force > DRAWN * step.todo.one_force else Text("couple")
        step.tables += Later(lambda: [compared_table(shaft, other, what)])
    support = materials[shaft.support.material] if shaft.support is not None else None
    if shaft.bolts is not None:
        bolted = bolts.tightened(shaft.bolts, support)
        if shaft.bolts.carries is None:  # else once all of them are solved
            alone = bolts.on_bearings(shaft.name, shaft.speed_ratio, shaft.bearing_positions, result.reactions)
            bolted = bolts.held(shaft.bolts, bolted, (alone,), shaft.bearing_positions)
            step.checks += bolts.checks(bolted)
            step.notes += bolts.notes(shaft.bolts, bolted)
    further = {}
    for joint in shaft.further_bolts:
        part = None if joint.material is None else materials[joint.material]
        further[joint.name] = found = bolts.solve_further(joint, part)
        step.checks += bolts.further_checks(joint, found)
        step.notes += bolts.face_notes(found)
    if shaft.support is not None:
        step.checks += support_checks(shaft.support, materials[shaft.support.material])
    count = f.part_count(n=column(shaft.parts, "count")) if shaft.parts else None
    kinds = based_on(float(len(shaft.parts)), shaft.parts) if shaft.parts else None
    drains = _drains(step)
    whole = replace(
        result,
        scatter=scattered,
        alternative=other,
        bolts=bolted,
        further_bolts=further or None,
        drain=drains.pop("", None),
        further_drains=drains or None,
        part_count=count,
        part_kinds=kinds,
    )
    if shaft.support is not None:
        step.tables += Later(lambda: table(shaft, whole))
    return whole


def with_bolts(
    outcome: Outcome[CountershaftResult], shaft: ShaftInputs, shafts: tuple[SystemShaft, ...]
) -> Outcome[CountershaftResult]:
    """The same outcome with the bolts of its support under all the `shafts` that are given for them, as these lie on
    their bearings; none: one of them is not solved."""
    result, inputs = outcome.solution, shaft.bolts
    if inputs is None or inputs.carries is None or result.bolts is None or not shafts:
        return outcome
    with trace() as lines:
        bolted = bolts.held(inputs, result.bolts, shafts, shaft.bearing_positions)
    return replace(
        outcome,
        result=replace(result, bolts=bolted),
        checks=(*outcome.checks, *bolts.checks(bolted)),
        lines=(*outcome.lines, *lines),
        notes=outcome.notes + Later(lambda: bolts.notes(inputs, bolted, shafts)),
    )


def _permitted(step: ShaftStep, result: CountershaftResult) -> ToleranceResult | None:
    """What the balance quality grade permits; it needs the mass of the whole shaft."""
    if result.mass is None or result.centre_of_gravity is None:
        return None
    shaft, couple = step.shaft, step.todo.couple
    z_f, z_r = shaft.bearing_positions[0], shaft.bearing_positions[-1]
    asked = result.mass, result.omega, result.centre_of_gravity, z_f, z_r, couple
    permitted = balance.permitted(shaft.balance_grade, *asked)
    step.tables += Later(lambda: [balance.table(shaft.balance_grade, *asked)])
    step.notes += balance.notes(result.centre_of_gravity, z_f, z_r)
    if couple:
        step.checks.append(balance.BALANCE_GRADE(permitted.permitted_couple_error, LEFT_OVER * couple))
    return permitted


def _holes(
    step: ShaftStep, masses: tuple[EccentricMass, ...], result: CountershaftResult, R: Metre | None
) -> HolesResult | None:
    """The calibration holes, and whether the shaft as drawn leaves them something to take."""
    holes, core_radius, todo = step.shaft.holes, step.shaft.core_radius, step.todo
    if holes is None:
        return None
    if R is None:
        step.notes.append(
            Text("Calibration holes are not computed: give the outer radius, from which they are drilled.")
        )
        return None
    z = column(masses, "z")
    drilled = balance.calibration(holes, step.sector_density, R, z, result.omega, todo.couple)
    if masses and holes.count % len(masses):
        shared = Text(
            "Calibration holes: {count} holes on {count2} masses are counted as an equal share for each.",
            count=holes.count,
            count2=len(masses),
        )
        step.notes.append(shared)
    if core_radius is None:
        step.notes.append(
            Text("Calibration holes: whether they end in the sectors is not judged: give the core radius.")
        )
    sectors = [p for p in result.outline.pieces if p.half_angle is not None] if result.outline is not None else []
    if not (sectors and masses):
        step.notes.append(
            Text("Calibration holes: whether they fit into the sectors is not judged: the outline has none.")
        )
    over = f.couple_beyond(C_S=result.couple_vector, C_req=based_on(-todo.C, todo.C)) if todo.couple else None
    step.checks += balance.hole_checks(holes, R, core_radius, len(masses), sectors, drilled, over)
    return drilled


def _balancing(
    step: ShaftStep, masses: tuple[EccentricMass, ...], result: CountershaftResult, R: Metre | None
) -> "BalancingResult | None":
    """The sheet for the balancing machine, where it is asked for."""
    table = step.shaft.balancing
    if table is None:
        return None
    made = Made(masses, result.outline, R, step.sector_density, step.material.density, result.tolerance)
    found = balancing_sheet(step.shaft, table, made)
    if found is None:
        step.notes.append(told.no_zero(table, masses))
        return None
    step.checks += balancing_checks(found)
    step.notes += told.notes(step.shaft, found)
    step.tables += Later(lambda: told.tables(found))
    return found


def _scatter(step: ShaftStep, masses: tuple[EccentricMass, ...], result: CountershaftResult) -> "ScatterResult | None":
    shaft, todo, permitted = step.shaft, step.todo, result.tolerance
    if shaft.scatter is None:
        return None
    if permitted is None:
        step.notes.append(Text("Scatter is not computed: what is permitted needs the mass of the whole shaft."))
        return None
    target = scatter.Target(
        omega=result.omega,
        couple=based_on(-todo.C, todo.C),
        force=based_on(-todo.F, todo.F),
        couple_left=result.couple_against,
        z_f=shaft.bearing_positions[0],
        z_r=shaft.bearing_positions[-1],
        permitted_front=permitted.residual_unbalance_permitted_front,
        permitted_rear=permitted.residual_unbalance_permitted_rear,
    )
    limit = todo.may_leave
    spread = scatter.scattered(shaft.scatter, masses, shaft.extras, target, result.holes)
    step.checks.append(scatter.residual_check(spread, limit))
    step.tables += Later(lambda: scatter.tables(spread))
    step.curves += Later(lambda: scatter.curves(spread, limit))
    step.notes += scatter.notes(shaft.scatter, spread)
    return spread


def _drains(step: ShaftStep) -> "dict[str, DrainResult]":
    """The drains by their names, the first one without; what is noted of all is noted once."""
    asked = [("", step.shaft.oil_drain)] if step.shaft.oil_drain is not None else []
    asked += [(inputs.name, inputs) for inputs in step.shaft.further_drains]
    chosen = {name: drain.solve(inputs) for name, inputs in asked}
    for result in chosen.values():
        step.checks += drain.checks(result)
    step.notes += dict.fromkeys(note for result in chosen.values() for note in drain.notes(result))
    return chosen


def _with_wall(shaft: ShaftInputs, journals: Journals) -> ShaftInputs:
    """The wall of the support beside the largest seat as it now is; as given where that does not say at which seat it
    was."""
    support = shaft.support
    if support is None or support.wall is None or support.wall_at_seat is None or not journals:
        return shaft
    w = f.wall_beside(w=support.wall, d=max(d for d, _ in journals), D_w=support.wall_at_seat)
    return replace(shaft, support=replace(support, wall=w))


SUPPORT_WALL = CheckRule(
    "countershaft.support.wall",
    "caution",
    "A thinner wall can not be cast, by the rule of one foundry.",
    Text("Wall of the support beside the largest seat"),
    unit="mm",
    source=Text("Finotti 2013, 4.1 and 4.2: no thinner than 5 mm beside the rear seat"),
    advice=Text("A smaller seat, or a larger casting."),
    moved_by=(dotted(SHAFT, ShaftInputs.support, ShaftSupport.wall), dotted(EACH_ROW, BearingRow.diameter)),
)
SUPPORT_BOLT_STRESS = CheckRule(
    "countershaft.support.bolt_stress",
    "limit",
    "The support yields under its bolts.",
    Text("Stress of the support under the bolts' preload"),
    "<",
    "MPa",
    advice=Text("More metal under the bolt heads."),
    role="physics",
    demand=True,
    moved_by=(dotted(SHAFT, ShaftInputs.support, ShaftSupport.bolt_stress),),
)
SUPPORT_LOAD_STRESS = CheckRule(
    "countershaft.support.load_stress",
    "limit",
    "The support breaks by fatigue.",
    Text("Stress of the support from the bearing loads"),
    "<=",
    "MPa",
    Text("given in the design: what the casting endures without end under the turning load"),
    Text(
        "Give what the casting endures under a turning load, or add ribs between seat and flange. The finite "
        "elements of Finotti 2013, 4.7 (in chapter 6), stay within 20 MPa: a result of theirs, no limit."
    ),
    role="physics",
    demand=True,
    moved_by=(dotted(SHAFT, ShaftInputs.support, ShaftSupport.load_stress),),
)


def support_checks(support: ShaftSupport, material: Material) -> Iterator[Check]:
    """The casting's wall, and its stresses as they were found elsewhere."""
    if support.wall is not None:
        yield SUPPORT_WALL(support.wall, support.least_wall)
    if support.bolt_stress is not None:
        proof, unknown = proof_of(material.proof_stress, support.bolt_stress)
        if unknown is not None and material.kind != "steel":
            unknown = replace(unknown, worst="none")  # how far iron or aluminium goes nobody says
        source = Text("Finotti 2013, 4.7 (in chapter 6): proof stress of {name}", name=material.name)
        yield SUPPORT_BOLT_STRESS(support.bolt_stress, proof, source=source, missing=unknown)
    if support.load_stress is None:
        return
    if support.load_stress_limit is not None:
        yield SUPPORT_LOAD_STRESS(support.load_stress, support.load_stress_limit)
        return
    # what the casting endures is not given: its strength stands for it, which does not judge fatigue
    strength, unknown = proof_of(material.proof_stress, support.load_stress)
    if unknown is not None and material.tensile_strength is not None:
        strength, unknown = material.tensile_strength, None
    source = Text("elasticity, strength of {name}; its fatigue is not judged", name=material.name)
    key = dotted(SHAFT, ShaftInputs.support, ShaftSupport.load_stress_limit)
    missing = Missing((key,), (source,), support.load_stress, "none")
    if unknown is not None:
        missing = Missing((key, *unknown.keys), (source, *unknown.taken), unknown.best, "none")
    yield SUPPORT_LOAD_STRESS(support.load_stress, strength, source=source, missing=missing)
