# SPDX-License-Identifier: Apache-2.0
"""What one step hands to another: numbers that stand in one table of a design, or in one result, and are needed in the
next."""

from cmath import phase
from collections import Counter
from collections.abc import Callable, Mapping
from math import hypot
from typing import TYPE_CHECKING, Any

from ..bearings.inputs import BearingsInputs
from ..bearings.plain.selection.variants import SelectionCase
from ..bearings.plain.speeds import highest_speed, of_journals
from ..bearings.result import BearingsResult
from ..bearings.solve import BearingMaterials
from ..bearings.support import Solids, StandingLoads, Task
from ..countershaft.checks import InPlace, swept
from ..countershaft.inputs import ShaftInputs
from ..countershaft.left_over import RESIDUAL, RESIDUAL_FORCE, RESIDUAL_FORCE_SHARE, RESIDUAL_SHARE
from ..countershaft.making.bolts import on_bearings
from ..countershaft.result import CountershaftResult
from ..countershaft.rows import BearingRow
from ..countershaft.shafts import of_twin
from ..countershaft.sums import SystemResult, SystemShaft
from ..countershaft.supports import Gear, ShaftDrive, Sprocket
from ..countershaft.twins import Resolved
from ..engine.result import EngineResult
from ..friction.drag import OverSpeed
from ..friction.journals import OnShaft
from ..friction.result import FrictionResult
from ..friction.solve import MeshOil
from ..gears.drive.line import ShaftBody
from ..gears.drive.source import CrankAtWork
from ..gears.drive.window import MayLeave
from ..gears.inputs import ONLY, GearsInputs
from ..gears.layout.formulas import angular_pitch
from ..gears.layout.solve import ShaftInTrain
from ..gears.rating.irregular import Irregular
from ..gears.rating.load import Power, Surroundings, power_by_balance, power_by_shafts
from ..gears.result import TrainResult
from ..gears.solve import NOT_RATED, Balanced
from ..library.lubricant import Lubricant
from ..mounting.wrenches import ShaftOnEngine
from ..sheet.errors import NoSolution
from ..sheet.linked_array import item
from ..sheet.record import replace
from ..sheet.step import Outcome
from ..sheet.text import EMPTY, Text
from ..sheet.units import Watt
from ..sheet.value import about, based_on, recorded, trace
from .model import STEPS, Design
from .operations import idle_speed, operations

if TYPE_CHECKING:
    from ..bearings.rolling.search import Place
    from ..countershaft.making.system_scatter import MadeShaft

NORMAL_95 = 1.96  # standard deviations on either side of the mean, within which 95 % lie


def unsolved(outcomes: tuple[Outcome[object], ...]) -> tuple[Outcome[object], ...]:
    """Those that a part has to wait for: where a step is not asked, what it hands on is given otherwise."""
    return tuple(outcome for outcome in outcomes if outcome.state not in ("solved", "not_asked"))


def first_speed(design: Design) -> float | None:
    """The speed of the train's first driver: given, or the crank's."""
    if design.gears is not None and design.gears.speed is not None:
        return design.gears.speed
    return design.engine.rated_speed if design.engine is not None else None


def rated_power(design: Design) -> float | None:
    """What the losses are a share of: None where the train turns at a speed of its own, at which the engine's power is
    not known."""
    own_speed = design.gears is not None and design.gears.speed is not None
    return design.engine.rated_power if design.engine is not None and not own_speed else None


def orders_taken(design: Design) -> frozenset[int]:
    """The orders that shafts of the design take, with their sense: at how many times crank speed these turn."""
    return frozenset(round(shaft.inputs.speed_ratio) for shaft in turning(design))


def turning(design: Design) -> tuple[Resolved, ...]:
    """The shafts, but for those of which only bearings are asked."""
    return tuple(shaft for shaft in design.resolved if shaft.inputs.mode != "bearings")


def in_order(design: Design) -> tuple[Resolved, ...]:
    """Those that are no twins: given ones first, since what they leave is for those that are sized."""
    own = [shaft for shaft in turning(design) if shaft.of is None]
    return tuple(sorted(own, key=lambda shaft: shaft.inputs.mode == "size"))


def twins(
    design: Design, original: Resolved, solved: Outcome[CountershaftResult]
) -> dict[str, Outcome[CountershaftResult]]:
    """What the twins of a shaft have of it, where it is solved."""
    if solved.result is None:
        return {}
    found = {}
    for name, twin in twins_of(design, original.name).items():
        with trace() as lines:
            result = of_twin(solved.result, twin)
        found[name] = Outcome("countershaft", result=result, lines=tuple(lines))
    return found


def twins_of(design: Design, original: str) -> dict[str, Resolved]:
    """The twins of a shaft by their names."""
    return {shaft.name: shaft for shaft in turning(design) if shaft.of == original}


def on_own_bearings(design: Design) -> tuple[Resolved, ...]:
    """The shafts whose bearings are solved: those that are no twins, then twins that say something of theirs."""
    every = [shaft for shaft in design.resolved if shaft.of is None or shaft.rows]
    return tuple(sorted(every, key=lambda shaft: shaft.of is not None))


def sized_alike(design: Design, name: str) -> int:
    """Of how many equal shares a sized shaft, no twin, takes one: as many as are sized for its ratio, twins counted, or
    for that of its mirror images, which take as much, where these are more."""
    sized = Counter(shaft.inputs.speed_ratio for shaft in design.resolved if shaft.inputs.mode == "size")
    return max(sized[shaft.inputs.speed_ratio] for shaft in design.resolved if name in (shaft.name, shaft.of))


def shares(design: Design, shaft: ShaftInputs) -> bool:
    """Whether another shaft turns like this one."""
    return sum(one.inputs.speed_ratio == shaft.speed_ratio for one in turning(design)) > 1


def in_place(design: Design, solved: Mapping[str, Outcome[CountershaftResult]]) -> dict[str, InPlace]:
    """Where every shaft turns, and what it sweeps."""
    placed_by = {shaft.name: shaft.mirrors or "" for shaft in design.shafts if shaft.axis is None}
    return {
        shaft.name: InPlace(
            axis_of(shaft.inputs),
            swept(shaft.inputs, solved[shaft.name].solution.outline),
            placed_by.get(shaft.name, ""),
        )
        for shaft in turning(design)
    }


def crank_sweeps(design: Design) -> float:
    """The least radius that the crank sweeps: that of its pins' axes, or of its counterweights' centres of gravity."""
    known = [design.engine.crank_radius] if design.engine is not None else []
    if design.imbalance is not None and design.imbalance.counterweight_radius is not None:
        known.append(design.imbalance.counterweight_radius)
    return max(known, default=0.0)


def beside(
    design: Design, shaft: Resolved, solved: Mapping[str, Outcome[CountershaftResult]]
) -> tuple[SystemShaft, ...]:
    """The given shafts that a sized one has beside it."""
    if shaft.inputs.mode != "size":
        return ()
    given = {s.name for s in turning(design) if s.inputs.mode != "size"}
    return system_shafts(design, {name: outcome for name, outcome in solved.items() if name in given})


def given_beside(design: Design, name: str, solved: Mapping[str, Outcome[Any]]) -> tuple[SystemShaft, ...]:
    """What a shaft would have beside it if it were sized, of shafts that are solved, by the names of those that are no
    twins."""
    every = dict(solved)
    for shaft in in_order(design):
        if shaft.name in solved:
            every |= twins(design, shaft, solved[shaft.name])
    mine = [shaft.name for shaft in turning(design) if name in (shaft.name, shaft.of) or shaft.inputs.mode == "size"]
    return system_shafts(design, {other: outcome for other, outcome in every.items() if other not in mine})


def system_shafts(
    design: Design, solved: Mapping[str, Outcome[CountershaftResult]], teeth: bool = False
) -> tuple[SystemShaft, ...]:
    """The shafts that are solved, as what all leave together has them; `teeth`: with those of their wheels."""
    return tuple(
        SystemShaft(
            shaft.name,
            shaft.inputs.speed_ratio,
            *solved[shaft.name].solution.vectors,
            axis=axis_of(shaft.inputs),
            tooth=_tooth(design, shaft.name) if teeth else None,
            mirrors=shaft.of if shaft.how == "mirrors" else None,
        )
        for shaft in turning(design)
        if shaft.name in solved and solved[shaft.name].result is not None
    )


def on_support(
    design: Design, shaft: Resolved, solved: Mapping[str, Outcome[CountershaftResult]]
) -> tuple[SystemShaft, ...]:
    """The shafts that its bolts hold, itself in any case, with what they put on their bearings; empty where there are
    none, or one of them is not solved."""
    bolts = shaft.inputs.bolts
    if bolts is None or bolts.carries is None:
        return ()
    held = [one for one in turning(design) if one.name in (shaft.name, *bolts.carries)]
    if any(one.name not in solved or solved[one.name].result is None for one in held):
        return ()
    return tuple(
        on_bearings(one.name, one.inputs.speed_ratio, one.inputs.bearing_positions, solved[one.name].solution.reactions)
        for one in held
    )


def made_shafts(
    design: Design, solved: Mapping[str, Outcome[CountershaftResult]], shafts: tuple[SystemShaft, ...]
) -> "tuple[MadeShaft, ...]":
    """Several shafts as they are made; empty where none of them scatters, or one alone."""
    inputs = {shaft.name: shaft.inputs for shaft in turning(design)}
    if len(shafts) < 2 or all(inputs[shaft.name].scatter is None for shaft in shafts):
        return ()
    from ..countershaft.making.system_scatter import MadeShaft

    made = []
    for shaft in shafts:
        of, result = inputs[shaft.name], solved[shaft.name].solution
        drilling = None
        if result.scatter is not None and result.holes is not None:
            drilling = result.scatter.target, result.holes
        made.append(MadeShaft(shaft, result.omega, of.scatter, result.masses, of.extras, drilling))
    return tuple(made)


def _tooth(design: Design, name: str) -> float | None:
    z = shaft_teeth(design, name)
    return None if z is None else angular_pitch(z=z)


def rolls(engine: EngineResult) -> dict[int, complex]:
    """By order, the torque reaction of its inertia about the crank, where that is known."""
    torque = engine.torque
    return {} if torque is None else {n: item(torque.reaction_harmonics[n - 1]) for n in (1, 2)}


def only(design: Design) -> str | None:
    """The name of the one shaft, where there is one."""
    every = turning(design)
    return every[0].name if len(every) == 1 else None


def driven(design: Design) -> tuple[str, ...]:
    """The names of the shafts that the train turns: of several those that a wheel carries."""
    names = [shaft.name for shaft in design.resolved]
    if len(names) < 2 or design.gears is None:
        return tuple(names) or (ONLY,)
    on = {wheel.shaft for wheel in design.gears.wheels} | set(design.gears.along)
    return tuple(name for name in names if name in on) or design.originals[:1]


def undriven(design: Design) -> tuple[str, ...]:
    """The names of the others."""
    turned = driven(design)
    return tuple(shaft.name for shaft in design.resolved if shaft.name not in turned)


def shaft_teeth(design: Design, name: str | None) -> int | None:
    """The teeth by which the train turns a shaft: of its wheel, or of the sprocket beside that."""
    if design.gears is None or name is None or name not in driven(design):
        return None
    return design.gears.tree.driving[design.gears.carrier(name)].z_2


def axis_of(shaft: ShaftInputs) -> complex | None:
    """Where a shaft stands beside the crank: real up, imaginary 90° further in the sense of rotation."""
    return based_on(complex(*shaft.axis), shaft.axis) if shaft.axis is not None else None


def shaft_axes(design: Design) -> dict[str, complex]:
    """Of the shafts that have a given one, by their names."""
    axes = {shaft.name: axis_of(shaft.inputs) for shaft in turning(design)}
    return {name: axis for name, axis in axes.items() if axis is not None}


def overrun(design: Design) -> float:
    """The highest speed that the engine runs at, over its rated one."""
    if design.engine is None:
        return 1.0
    rated, bench = of_journals(design.engine, design.own.speed_ratio if design.own is not None else None)
    return highest_speed(rated, bench, design.bearings) / rated


def journals(design: Design) -> tuple[tuple[float, float], ...]:
    """Diameter and length of the shaft's journals, front to rear; empty where they are not known."""
    return design.own.journals if design.own is not None else ()


def shaft_gear(design: Design, train: TrainResult | None, name: str) -> Gear | None:
    """The wheel on a shaft; None where a sprocket alone turns it."""
    if train is None or design.gears is None or name not in train.shafts:
        return None
    wheel = train.wheels.get(train.shafts[name].wheel)
    if wheel is None:
        return None
    return Gear(wheel.pitch_diameter, wheel.tip_diameter, wheel.face_width, train.system.alpha_n, train.system.beta)


def balanced(shafts: Mapping[str, Outcome[CountershaftResult]]) -> dict[str, Balanced]:
    """What the backlash of the train takes a part of, by shaft."""
    several = len(shafts) > 1
    solved = {name: shaft.result for name, shaft in shafts.items() if shaft.result is not None}
    return {name: Balanced(shaft.couple, shaft.force if several else None) for name, shaft in solved.items()}


def may_leave(shafts: Mapping[str, Outcome[CountershaftResult]], left: Outcome[SystemResult]) -> dict[str, MayLeave]:
    """What each shaft turns with, and what all of them together may leave of it at the order that they are for."""
    most = {check.rule: check.limit for check in left.checks if isinstance(check.limit, float)}
    couple, force = (
        next((most[rule] for rule in rules if rule in most), None)
        for rules in ((RESIDUAL, RESIDUAL_SHARE), (RESIDUAL_FORCE, RESIDUAL_FORCE_SHARE))
    )
    return {name: MayLeave(of.couple, couple, of.force, force) for name, of in balanced(shafts).items()}


def ratios(design: Design) -> dict[str, float]:
    """How fast the shafts must turn, over the crank, by their names."""
    return {shaft.name: shaft.inputs.speed_ratio for shaft in turning(design)}


def gears_life(design: Design) -> float | None:
    """The life that is asked of the gears, where it is given."""
    return design.gears.life if design.gears is not None else None


def bearing_materials(design: Design, bearings: BearingsInputs, shaft: ShaftInputs) -> BearingMaterials:
    """The oil of the bearings, and what journals and housing are made of; journals that are not given are those of the
    shaft."""
    solids = design.materials
    return BearingMaterials(
        oil=bearings.in_bearings(design.oils[bearings.oil]),
        journal=solids[bearings.journal_material or shaft.material],
        housings=tuple(solids[bearings.of(row).housing_material] for row in shaft.bearings),
        backings=tuple(solids[row.backing] for row in shaft.bearings),
        shaft_bore=shaft.bore_diameter,
    )


def mesh_oil(design: Design) -> MeshOil | None:
    """The oil on the teeth: given, or that of the bearings; None where neither is."""
    friction, there = design.friction, design.bearings
    name = (friction.oil if friction is not None else None) or (there.oil if there is not None else None)
    temperature = friction.oil_temperature if friction is not None else None
    if temperature is None and there is not None:
        temperature = there.supply_temperature
    if name is None or temperature is None:
        return None
    law = there.viscosity_law if there is not None else "walther"
    return MeshOil(oil=design.oils[name], viscosity_law=law, temperature=temperature)


def parts_of_power(design: Design, train: TrainResult | None, f: Outcome[FrictionResult]) -> dict[str, Watt]:
    """Of a power that is given for the drive of several shafts, what each mesh, chain and belt takes in; none where it
    is not given, or turns one shaft."""
    P = design.gears.power if design.gears is not None else None
    if P is None or train is None or len(train.shafts) < 2:
        return {}
    links, parts = train.tree.links, {}
    taken = powers_in(f.result) if f.result is not None else {}
    first = [taken[link.key] for link in links if taken and link.driver == train.tree.first]
    P_1, n = based_on(sum(first), *first), len(train.shafts)
    of_shafts = {turn.wheel for turn in train.shafts.values()}
    others = {link.driven for link in links} - {link.driver for link in links} - of_shafts
    for link in links:
        with about(Text("mesh {pair}", pair=link.title)):
            if taken:
                parts[link.key] = power_by_balance(P=P, P_i=taken[link.key], P_1=P_1)
            else:  # of an end that is no shaft nobody knows what it takes: all of it at most
                unknown = any(link in train.tree.way(end) for end in others)
                k = n if unknown else sum(link in train.tree.way(wheel) for wheel in of_shafts)
                parts[link.key] = power_by_shafts(P=P, k=float(k), n=float(n))
    return parts


def powers_in(friction: FrictionResult) -> dict[str, Watt]:
    """What each mesh, chain and belt takes in in the closed balance."""
    of_meshes = {key: mesh.power_in for key, mesh in friction.meshes.items()}
    return of_meshes | {key: stage.power_in for key, stage in friction.stages.items()}


def power(gears: GearsInputs, f: Outcome[FrictionResult], parts: dict[str, Watt]) -> Power | None:
    """The power that loads the teeth: the given one or its parts, else that of each mesh in the closed balance; None
    where neither is known."""
    if gears.power is not None:
        return Power(parts or gears.power)
    if f.result is None:
        return None
    return Power(powers_in(f.result))


def not_rated(f: Outcome[FrictionResult]) -> Text:
    """Why the teeth have no power to be rated with."""
    if f.state not in ("no_solution", "blocked"):
        return NOT_RATED
    title = next(step.title for step in STEPS if step.key == f.key)
    return Text("Not rated: {titles} gives no power: {reason}.", titles=title, reason=f.reason)


def on_shafts(
    design: Design,
    shafts: Mapping[str, Outcome[CountershaftResult]],
    journals: Mapping[str, Outcome[BearingsResult]],
    train: TrainResult,
) -> dict[str, OnShaft]:
    """The journals that the train turns, by the names of their shafts; none where there are no bearings."""
    on = {}
    for shaft in design.resolved:
        carried, solved = journals.get(shaft.name), shafts.get(shaft.name)
        if carried is not None and carried.result is not None and shaft.name in train.shafts:
            gear = shaft_gear(design, train, shaft.name) if solved is not None else None
            result = solved.result if solved is not None else None
            chained = sprockets(design, train, shaft.name)
            on[shaft.name] = OnShaft(carried.result, result, shaft.inputs, gear, chained)
    return on


def sprockets(design: Design, train: TrainResult, name: str) -> tuple[Sprocket, ...]:
    """Those on a shaft, alone or beside its wheel."""
    wheel, on = train.shafts[name].wheel, []
    for stage in design.gears.stages if design.gears is not None else ():
        sizes, tension = train.stages[stage.name], stage.tensioner or 0.0
        if stage.driver == wheel:
            on.append(Sprocket(stage.name, sizes.pitch_diameter_driver, tension))
        if stage.driven == wheel:
            on.append(Sprocket(stage.name, sizes.pitch_diameter_driven, tension))
    return tuple(on)


def shaft_drive(
    design: Design, train: TrainResult | None, f: Outcome[FrictionResult], parts: dict[str, Watt], name: str
) -> ShaftDrive | None:
    """What drives a shaft by its gear and its sprockets: the given power or its `parts`, else what they carry in the
    closed balance."""
    if train is None or design.gears is None or name not in train.shafts:
        return None
    own, given = train.shafts[name].wheel, design.gears.power
    speed = train.speeds.get(own)
    if not speed:
        return None
    meshes = [link.key for link in train.tree.links if link.toothed and own in (link.driver, link.driven)]
    power = given if own in train.wheels else None
    if parts:
        mine = [parts[key] for key in meshes]
        power = based_on(sum(mine), *mine) if mine else None
    elif given is None and f.result is not None:
        power = f.result.at_teeth(own)
    taken = parts or (powers_in(f.result) if given is None and f.result is not None else {})
    strands = []
    for sprocket in sprockets(design, train, name):
        if (carried := taken.get(sprocket.stage, given)) is not None:
            strands.append((sprocket, carried))
    if power is None and not strands:
        return None
    return ShaftDrive(power, based_on(abs(speed), speed), tuple(strands))


def crank_at_work(
    design: Design,
    engine: Outcome[EngineResult],
    shafts: Mapping[str, Outcome[CountershaftResult]],
    train: TrainResult,
    friction: Outcome[FrictionResult],
) -> CrankAtWork | None:
    """The engine as the drive over speed sees it, with what hangs on the wheels of the shafts; None where there is no
    engine."""
    crank, speed = design.engine, first_speed(design)
    if crank is None or engine.result is None or speed is None:
        return None
    bodies = {}
    for shaft in turning(design):
        solved = shafts[shaft.name].result if shaft.name in shafts else None
        if shaft.name in train.shafts and solved is not None and (J := solved.moment_of_inertia) is not None:
            outline, F = solved.outline, solved.force_vector
            has_gear = outline is not None and any(piece.what == "gear" for piece in outline.pieces)
            bodies[shaft.name] = ShaftBody(
                J=J,
                with_wheel=outline is not None and (not outline.derived or has_gear),
                U=solved.static_unbalance,
                angle=based_on(phase(F), F),
                ratio=shaft.inputs.speed_ratio,
            )
    first = next(iter(bodies), None)
    end = None
    if first is not None and first in shafts:
        inputs = next(shaft.inputs for shaft in turning(design) if shaft.name == first)
        end = gear_end(inputs, shafts[first].result)
    return CrankAtWork(
        engine=crank,
        e=engine.result,
        rows=operations(crank, design.mounting),
        idle=idle_speed(crank, design.mounting),
        ratio=based_on(speed / crank.rated_speed, speed, crank.rated_speed),
        front=None if end is None else end == "front",
        shafts=bodies,
        friction=OverSpeed(friction.result) if friction.result is not None else None,
    )


def eccentric(shaft: ShaftInputs, end: str | None) -> float | None:
    """Direction, with cylinder 1 at TDC, of the shaft's eccentric mass nearest to its gear, whose journal is `end`; of
    two in one plane that of the larger unbalance.  Where the gear's place is not known, the front is taken."""
    masses = shaft.masses
    away = -1 if end == "rear" else 1
    return min(masses, key=lambda x: (away * x.z, -x.mass * x.radius, x.angle)).angle if masses else None


def gear_end(given: ShaftInputs, shaft: CountershaftResult | None) -> str | None:
    """At which journal the shaft's gear stands: where it is given, else as its outline is put together; None: not
    known."""
    z = given.gear_z
    if z is None and shaft is not None and shaft.outline is not None:
        z = next((piece.start for piece in shaft.outline.pieces if piece.what == "gear"), None)
    if z is None:
        return None
    return "rear" if z > sum(given.bearing_positions) / len(given.bearing_positions) else "front"


def housing(design: Design) -> str | None:
    """The material between the centres: that of the gears, else that of the bearings."""
    material = design.gears.housing_material if design.gears is not None else None
    return material or (design.bearings.housing_material if design.bearings is not None else None)


def shafts_in_train(design: Design, solved: Mapping[str, Outcome[CountershaftResult]]) -> dict[str, ShaftInTrain]:
    """What the place of the train has to know of the shafts on its wheels, by their names."""
    shafts = {}
    for shaft in design.resolved:
        inputs, result = shaft.inputs, solved[shaft.name].result if shaft.name in solved else None
        turns, seats = inputs.mode != "bearings", inputs.openings
        end = gear_end(inputs, result) if turns else None
        shafts[shaft.name] = ShaftInTrain(
            axis=axis_of(inputs) if turns else None,
            eccentric=eccentric(inputs, end) if turns else None,
            journals=(seats[0], seats[-1]) if seats and inputs.passes_seats else None,
            gear_end=end,
            couple=result.couple if result is not None else None,
        )
    return shafts


def around_gears(design: Design, uneven: Irregular | None) -> Surroundings:
    """What the rating of the teeth takes from other steps; `uneven`: what the motion of the crank adds to the
    torque."""
    oil = mesh_oil(design)
    lubricant = Lubricant(oil.oil, oil.viscosity_law) if oil is not None else None
    Ra = design.friction.flank_roughness if design.friction is not None else None
    return Surroundings(
        uneven=uneven,
        lubricant=lubricant,
        oil_temperature=oil.temperature if oil is not None else None,
        flank_ra=(Ra[0], Ra[-1]) if Ra else None,
    )


def shafts_on_engine(
    design: Design, shafts: Mapping[str, Outcome[CountershaftResult]], train: Outcome[TrainResult]
) -> tuple[ShaftOnEngine, ...]:
    """All balance shafts as the engine's mounts see them."""
    return tuple(
        ShaftOnEngine(**vars(shaft), errors=shaft_errors(design, shaft.name, shafts[shaft.name].solution, train.result))
        for shaft in system_shafts(design, shafts, teeth=True)
    )


def shaft_errors(
    design: Design, name: str, shaft: CountershaftResult, train: TrainResult | None
) -> tuple[float, float] | None:
    """Error of the couple and of the angle of a shaft as it scatters: given, else what 95 % of the shafts stay below;
    None: not known."""
    given, scatter = design.mounting, shaft.scatter
    if given is None:
        return None
    s, delta, turned = given.scatter_couple, given.late, 0.0
    if scatter is not None and shaft.couple:
        of_couple = (scatter.couple_error_by_mass, scatter.couple_error_by_radius, scatter.couple_error_by_position)
        of_angle = (scatter.couple_error_by_angle, scatter.couple_error_by_timing)
        s = based_on(NORMAL_95 * hypot(*of_couple) / shaft.couple, of_couple, shaft.couple) if s is None else s
        turned = based_on(NORMAL_95 * hypot(*of_angle) / shaft.couple, of_angle, shaft.couple)
    elif scatter is not None and shaft.force:
        of_angle = (scatter.force_error_by_angle, scatter.force_error_by_timing)
        turned = based_on(NORMAL_95 * hypot(*of_angle) / shaft.force, of_angle, shaft.force)
    free = _free_turn(name, train)
    if delta is None and (free is not None or turned):
        delta = based_on(turned + (free or 0.0), turned, free)
    return (s or 0.0, delta or 0.0) if s is not None or delta is not None else None


def _free_turn(name: str, train: TrainResult | None) -> float | None:
    """Of the shaft's wheel: what 95 % of the trains stay below, else the worst case; None: no wheel turns it."""
    if train is None or name not in train.shafts:
        return None
    by_chance = train.train_play[name].phase_error_95 if train.train_play is not None else None
    return train.shafts[name].phase_error if by_chance is None else by_chance


def bearings_case(
    design: Design, solve: Callable[..., Any], results: Any = None, shaft: str | None = None
) -> "SelectionCase":
    """A design put as the question that the search for bearings answers, of those of one shaft.

    `solve`: that of the program, which stands above this room.  `results`: of the design, where it is solved already.
    `shaft`: one that is no twin, else the first.  Raises NoSolution where there are no bearings."""
    if design.bearings is None:
        lacks = Text("the design has no [bearings]")
        raise NoSolution(Text("there are no bearings to choose"), lacks, Text("give the table"))
    view = design.views[shaft] if shaft is not None else next(iter(design.views.values()))
    own = view.own
    assert own is not None  # bearings stand in its rows
    done = results if results is not None else solve(design)
    gear = shaft_gear(design, done.result(TrainResult), own.name)

    def with_bearings(bearings: BearingsInputs, rows: tuple[BearingRow, ...], *, last: bool = False) -> Any:
        solved = iter(design.originals)  # one by one, in this order
        enough = (lambda outcome: outcome.key == "bearings" and next(solved) == own.name) if last else None
        changed = replace(design, bearings=bearings).with_shaft(replace(own, bearings=rows))
        with recorded(False):
            return solve(changed, done, enough=enough)

    return SelectionCase(
        design.bearings,
        own.name,
        f"{design.ids_of('bearings', own.name)}.",
        own.bearings,
        view.own_key(ShaftInputs.bearings),
        view.countershaft,
        design.oils,
        tuple(oil.name for oil in design.oil),
        gear.tip_diameter if gear else None,
        done,
        with_bearings,
        _gear_bore(design, own.name),
    )


def _gear_bore(design: Design, name: str) -> float | None:
    """Of the wheel on a shaft, where it has one."""
    wheels = design.gears.wheels if design.gears is not None else ()
    return next((wheel.bore_diameter for wheel in wheels if wheel.shaft == name), None)


def rolling_places(design: Design, results: Any, name: str) -> "dict[str, Place]":
    """The places of a shaft's bearings, front to rear, as rolling ones are sought for them; of a shaft that is no twin.

    `results`: of the design, with an outline of the shaft where it has one.  A rolling bearing takes no less of the
    shaft than its core, the bore of the wheel beside the first, and what its ring passes on the way there, and no more
    than the envelope; of a shaft that is given as sections just that of its section there.  The one
    nearest to the gear locates the shaft, else the first.  Raises NoSolution where the loads are not known."""
    view = results.views[name]
    return _rolling_places(design, view.result(CountershaftResult), view.outcomes["countershaft"].reason, name)


def _rolling_places(design: Design, solved: CountershaftResult | None, why: Text, name: str) -> "dict[str, Place]":
    """The same under a shaft that is solved; `why`: it is not."""
    from ..bearings.rolling.kind import on_the_way  # with the room of these, when they are asked for
    from ..bearings.rolling.search import Place

    view = design.views[name]
    own, inputs, shaft = view.own, design.bearings, view.countershaft
    assert own is not None and inputs is not None
    ratio = shaft.speed_ratio if shaft is not None else None
    speed, engine = inputs.speed, design.engine
    if speed is None:
        assert engine is not None  # asked of the design
        speed, _ = of_journals(engine, ratio)
    operation = engine.operation if engine is not None else ()
    task = Task(speed, ratio, operation=operation, life=gears_life(design))
    solids = bearing_materials(design, inputs, own)
    lubricant = Lubricant(solids.oil, inputs.viscosity_law)
    least, most, first = 0.0, float("inf"), own.bearings[0]
    if shaft is not None:
        least = max(2 * (shaft.core_radius or 0.0), shaft.bore_diameter)
        most = 2 * shaft.outer_radius if shaft.outer_radius is not None else most
    end = gear_end(own, solved) if shaft is not None else None
    outline = solved.outline if solved is not None else None
    locating = own.bearings[-1] if end == "rear" else first
    places = {}
    for row, housing, backing in zip(own.bearings, solids.housings, solids.backings):
        load, slope = row.load, row.slope
        if load is None:
            load = solved.loads.get(row.name) if solved is not None else None
        if load is None:
            raise NoSolution(Text("the loads of the bearings are not known"), why, Text("solve the shaft first"))
        if slope is None and solved is not None:
            slope = solved.slopes.get(row.name)
        way = on_the_way(outline, row.position, ("gear", "journal")) if outline is not None else None
        bores = max(least, (_gear_bore(design, own.name) or 0.0) if row is first else 0.0, way or 0.0), most
        here = [x for x in (shaft.sections if shaft is not None else ()) if x.from_ <= row.position <= x.to]
        if here:  # the given shape has it
            bores = 2 * here[0].outer_radius, 2 * here[0].outer_radius
        places[row.name] = Place(
            row=row,
            inputs=inputs.of(row),
            solids=Solids(lubricant, solids.journal, housing, backing, solids.shaft_bore),
            load=load,
            stands=_standing_on(row, solved),
            slope=slope,
            task=task,
            bores=bores,
            locates=row is locating,
        )
    return places


def on_rolling_instead(design: Design, solved: Mapping[str, CountershaftResult | None]) -> Watt | None:
    """What balls and rollers of least loss would lose in the places of all bearings, at rated speed, an estimate; None
    where in one of them none would do, or no load is known."""
    if design.bearings is None or design.engine is None:
        return None
    from ..bearings.rolling.search import candidates, usual_sizes

    found = 0.0
    for name in design.originals:
        try:
            places = _rolling_places(design, solved.get(name), EMPTY, name)
        except NoSolution:
            return None
        for place in places.values():
            task, inputs = replace(place.task, operation=()), replace(place.inputs, duty=())
            there = replace(place, task=task, inputs=inputs, bores=(0.0, place.bores[1]))
            one = next(iter(candidates(there, usual_sizes(there))), None)
            if one is None or one.fails:
                return None
            found += one.loss * (1 + len(twins_of(design, name)))
    return found


def _standing_on(row: BearingRow, shaft: CountershaftResult | None) -> StandingLoads:
    if row.standing_load is not None:
        return StandingLoads(row.standing_load, row.standing_load, row.axial_load or 0.0)
    stands = shaft.standing if shaft is not None else None
    if stands is None:
        return StandingLoads(0.0, 0.0, 0.0)
    all_of_it, weight = stands.stationary.get(row.name, 0.0), stands.weights.get(row.name, 0.0)
    axial = row.axial_load if row.axial_load is not None else stands.gear_force_axial
    return StandingLoads(all_of_it, weight, axial or 0.0)
