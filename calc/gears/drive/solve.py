# SPDX-License-Identifier: Apache-2.0
"""The drive over speed: motion of the crank, forces and strikes of every mesh, and what they do to the teeth.

`over_speed` comes before the rating, which takes what the motion adds to its torque; `struck` after it, with the forces
of the strikes in place of that torque."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial, reduce

import numpy as np

from ...engine.inputs import EngineInputs
from ...engine.load import CrankTorque, crank_torque
from ...engine.operation import GasRow
from ...engine.result import EngineResult
from ...friction.drag import drag_sources, drags
from ...friction.result import FrictionResult
from ...library.catalogue import Material
from ...sheet.arrays import Array
from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.linked_array import item
from ...sheet.quantity import Described, Stated
from ...sheet.record import record
from ...sheet.step import Outcome, finite
from ...sheet.text import EMPTY, Amount, Text
from ...sheet.units import (
    Kilogram,
    KilogramMetre2,
    Metre,
    MetrePerSecond2,
    Newton,
    NewtonMetre,
    Number,
    RevPerSecond,
    Watt,
)
from ...sheet.value import about, based_on, trace, untraced
from ..inputs import GearsInputs
from ..limits import EXTREME
from ..rating.load import Irregular, MeshTorques
from ..result import TrainResult
from . import strikes as s
from .bodies import ShaftBody, TrainOnLine, counted, drag_on_line, inertias, measured, on_line, with_body
from .checks import grade_of
from .crank import (
    UnevenRow,
    acceleration,
    default_row,
    firing_order,
    given_accelerations,
    given_motion,
    motion,
    published,
)
from .forces import forces_of
from .motion import Motion
from .orders import mesh_order
from .result import HARDEST, IDLE, IDLE_FULL, OPERATIONS, RATED, DriveResult, MeshAt, MeshOverSpeed, MotionAt
from .scissor import split_wheel
from .survey import DRAWN, FULL, JUDGED, LOADS, Drags, Spring, Survey, grid, survey

DRAG_SPEEDS = 7
TRACED = (IDLE, HARDEST)  # the operating points whose strikes are shown line by line
TURN = 2 * math.pi


@record
class CrankAtWork:
    """The engine as the drive sees it.

    `ratio`: speed of the first driver over that of the crank; `rows`: what is said of the gas at speeds and loads;
    `front`: whether the first wheel stands at the nose, None: not known; `shafts` by their names, those whose inertia
    is known; `friction`: the closed balance, None: no drag is known."""

    engine: EngineInputs
    e: EngineResult
    rows: tuple[GasRow, ...]
    idle: RevPerSecond
    ratio: Number
    front: bool | None
    shafts: Mapping[str, ShaftBody]
    friction: FrictionResult | None


# --- formulas


@formula("M_c", "dynamics: with what its body drives, ρ times as fast on the line of action", names={"M_2": "M_c,2"})
def with_behind(M: Kilogram, M_2: Kilogram, rho: Number) -> Kilogram:
    return M + M_2 * rho**2


@formula("D_c", "statics: with what its body drives, ρ times as fast on the line of action", names={"D_2": "D_c,2"})
def drag_with_behind(D: Newton, D_2: Newton, rho: Number) -> Newton:
    return D + D_2 * rho


@formula("a", "kinematics: acceleration of the crank along the line of action of a mesh", names={"alpha": "α"})
def at_mesh(alpha: Number, i_1: Number, r_b1: Metre, rho: Number) -> MetrePerSecond2:
    """`i_1`: turns of the first driver in a turn of the crank, `r_b1` its base radius, `rho` from there to the mesh."""
    return alpha * i_1 * r_b1 * rho


@formula("T_dyn", "dynamics: torque at the driver that accelerates all that its mesh drives", names={"M": "M_c"})
def dynamic_torque(M: Kilogram, a: MetrePerSecond2, r_b: Metre, z_1: Number, z_2: Number) -> NewtonMetre:
    """`r_b` of the driven wheel."""
    return M * a * r_b * z_1 / z_2


@formula("ΣW_u", "mathematics: sum over the bodies that strike")
def with_power(W: Watt, W_i: Watt) -> Watt:
    return W + W_i


# --- the motion of the crank, whatever it is known by


@record
class Source:
    """Where the motion of the crank comes from: a torque on flywheel and train, or an irregularity.

    `loads`: those that can be told apart, one where they are all alike; `assumed`: a default stands for it."""

    work: CrankAtWork
    gears: GearsInputs
    J_E: KilogramMetre2 | None
    rows: tuple[UnevenRow, ...]
    loads: tuple[float, ...]
    nose: bool
    r_1: Metre

    @property
    def assumed(self) -> bool:
        return self.J_E is None and not _said(self.gears)

    @property
    def cycle(self) -> float:
        """That of the engine; of one given order that does not fit into it, the nearest one that it does fit into."""
        cycle, orders = self.work.engine.strokes * math.pi, {float(row.order) for row in self.rows}
        if len(orders) != 1:
            return cycle
        (order,) = orders
        return max(1, round(cycle * order / TURN)) * TURN / order

    def points(self, count: int = JUDGED) -> tuple[Array, Array]:
        """Speeds from idle to rated with every load."""
        return grid(float(self.work.idle), float(self.work.engine.rated_speed), self.loads, count)

    def torque(self, speeds: Array, loads: Array) -> CrankTorque:
        work = self.work
        return crank_torque(work.engine, work.e, work.rows, speeds, loads, idle=work.idle)

    def moved(self, speeds: Array, loads: Array, torque: CrankTorque | None = None) -> Motion:
        """Of the first driver; `torque`: at these points, where it is there already."""
        i_1 = abs(self.work.ratio)
        if self.J_E is None:
            return given_motion(self.rows, speeds, self.cycle, self.r_1, i_1)
        torque = self.torque(speeds, loads) if torque is None else torque
        return motion(torque, speeds, self.J_E, self.r_1, i_1, twist=self.work.engine.crank_twist, nose=self.nose)


def _said(gears: GearsInputs) -> bool:
    """Whether the design gives an irregularity."""
    return gears.speed_irregularity is not None or bool(gears.drive is not None and gears.drive.irregularity)


def source_of(work: CrankAtWork, gears: GearsInputs, line: TrainOnLine) -> Source:
    """By rows of an irregularity, else by gas or torque diagram with flywheel, else by a default."""
    engine, end = work.engine, gears.drive.driven_from if gears.drive is not None else None
    nose = end == "nose" if end is not None else bool(work.front)
    rows: tuple[UnevenRow, ...] = ()
    J_E: KilogramMetre2 | None = None
    loads: tuple[float, ...] = (0.0,)
    if gears.drive is not None and gears.drive.irregularity:
        usual = firing_order(engine)
        rows = tuple(
            UnevenRow(row.speed, row.delta, usual if row.order is None else row.order)
            for row in gears.drive.irregularity
        )
    elif gears.speed_irregularity is not None:
        order = firing_order(engine) if gears.irregularity_order is None else gears.irregularity_order * abs(work.ratio)
        rows = (UnevenRow(engine.rated_speed, gears.speed_irregularity, order),)
    elif (engine.gas is not None or engine.torque) and engine.flywheel_inertia is not None:
        with about(Text("inertia on the crank")):
            turns = [i * abs(work.ratio) for i in line.turns]
            J_E = reduce(
                lambda J, of: with_body(J=J, J_k=of[0], i_k=of[1]), zip(line.J, turns), engine.flywheel_inertia
            )
        loads = FULL if engine.gas is None or engine.gas.pressure else LOADS
    else:
        rows = (default_row(engine, work.idle),)
    return Source(work, gears, J_E, rows, loads, nose, line.first_radius)


# --- what drags


def drags_of(work: CrankAtWork, gears: GearsInputs, line: TrainOnLine) -> Drags | None:
    """By the closed balance, and where it is measured by that; None where neither is known."""
    rated = float(work.engine.rated_speed)
    speeds = np.linspace(float(work.idle), rated, DRAG_SPEEDS)
    solved = {} if work.friction is None else drags(work.friction, speeds / rated)
    rows = gears.drive.drag if gears.drive is not None else ()
    known, columns = bool(solved), []
    for link, r in zip(line.links, line.radius):
        given = measured(rows, link.driven, speeds)
        T_d = given if given is not None else solved.get(link.driven, np.zeros(speeds.size))
        known = known or given is not None
        columns.append(_filled(T_d, speeds) / float(r))
    return Drags(speeds, np.stack(columns, -1)) if known else None


def _filled(T_d: Array, speeds: Array) -> Array:
    """Where a journal has no film in the range of its table, the drag of the nearest speed at which it has one."""
    there = np.isfinite(T_d)
    if there.all():
        return T_d
    return np.interp(speeds, speeds[there], T_d[there]) if there.any() else np.zeros(T_d.size)


# --- over the range


@record
class Drive:
    """What `over_speed` knows: for maps, remedies and pictures, which survey it at other points."""

    work: CrankAtWork
    line: TrainOnLine
    source: Source
    drags: Drags
    springs: Mapping[int, Spring]
    drag_known: bool

    def survey(self, speeds: Array, loads: Array, corner: str = "nominal") -> Survey:
        return survey(self.source.moved, self.line, self.drags, self.springs, speeds, loads, corner)

    @property
    def taken(self) -> Text:
        """What stands for the motion of the crank where nothing is given."""
        row = self.source.rows[0] if self.source.rows else None
        if row is None:
            return EMPTY
        return Text(
            "an irregularity of {delta} at idle, {n}",
            delta=Amount(row.delta * 100, "%"),
            n=Amount(row.speed * 60, "rpm", form=".0f"),
        )

    def lost(self, key: str) -> Callable[[Watt, Metre], Watt] | None:
        """What a mesh loses of a power by the friction of the closed balance, over a part of its face width."""
        friction = self.work.friction
        return None if friction is None or friction.drive is None else partial(friction.drive.loss_on, key)

    def drawn(self) -> Survey:
        """The map."""
        with untraced():
            return self.survey(*self.source.points(DRAWN))


def over_speed(
    gears: GearsInputs, train: TrainResult, work: CrankAtWork, materials: Mapping[str, Material]
) -> Outcome[DriveResult]:
    """The motion of the crank over speed and load, and what it does in every mesh: 12 speeds from idle to rated, at no,
    half and full load; what is published of four operating points is traced."""
    with trace() as lines:
        own = inertias(gears, train, work.shafts, materials)
        line = on_line(train, own, materials, work.shafts)
        source = source_of(work, gears, line)
        with untraced():
            drags = drags_of(work, gears, line)
        B = len(line.links)
        known = drags is not None
        if drags is None:
            drags = Drags(np.array([float(work.idle), float(work.engine.rated_speed)]), np.zeros((2, B)))
        line = counted(line, drags.of[0])
        springs = _springs(gears, train, line)
        with about(Text("crank, over speed and load")):
            source, torque = _turning(source)
        speeds, loads = source.points()
        moved = source.moved(speeds, loads, torque)
        drive = Drive(work, line, source, drags, springs, known)
        with untraced():
            judged = survey(lambda *_: moved, line, drags, springs, speeds, loads)
        at = _operations(drive, judged)
        points = list(at.values())
        with untraced():
            most = survey(lambda *_: moved.at(points), line, drags, springs, speeds[points], loads[points], "most")
        operations = {op: _motion_at(drive, torque, moved, p) for op, p in at.items()}
        meshes = _meshes(drive, judged, most, at, operations)
        torques = _torques(drive, judged, operations, moved)
        result = _result(drive, judged, most, at, operations, meshes, torques)
    finite(result, "gears", EXTREME)
    notes = torque.notes if torque is not None else ()
    return Outcome("gears", result=result, lines=tuple(lines), notes=notes)


def _turning(source: Source) -> tuple[Source, CrankTorque | None]:
    """The torque at the points that are judged; where the cycle without brake load is neither known nor solved, at full
    load alone, and the reason with it."""
    if source.J_E is None:
        return source, None
    try:
        return source, source.torque(*source.points())
    except NoSolution as none:
        alone = replace(source, loads=FULL)
        torque = alone.torque(*alone.points())
        return alone, replace(torque, notes=(*torque.notes, Text("Full load alone: {reason}.", reason=none.text)))


def _springs(gears: GearsInputs, train: TrainResult, line: TrainOnLine) -> dict[int, Spring]:
    springs = {}
    for mesh in gears.meshes:
        if mesh.scissor is not None:
            i = line.index(mesh.key)
            split = train.wheels[split_wheel(mesh.scissor, mesh.driver, mesh.driven)]
            springs[i] = Spring(mesh.scissor, split.base_diameter / 2, float(line.play["most"][i]))
    return springs


def _operations(drive: Drive, judged: Survey) -> dict[str, int]:
    """The points that are published, by their names: those of the source's loads; the hardest is that of the largest
    force of a strike, or where nothing strikes rated speed."""
    idle, rated, loads = float(drive.work.idle), float(drive.work.engine.rated_speed), drive.source.loads
    at = {}
    if loads[0] == 0.0:
        at[IDLE] = judged.at(idle, 0.0)
    if loads[-1] == 1.0:
        at[IDLE_FULL] = judged.at(idle, 1.0)
    at[RATED] = judged.at(rated, loads[-1])
    hardest = judged.impacts.high.max(axis=1)
    at[HARDEST] = int(np.argmax(hardest)) if hardest.any() else at[RATED]
    return at


def _motion_at(drive: Drive, torque: CrankTorque | None, moved: Motion, p: int) -> MotionAt:
    """The crank at one point of the survey."""
    source, speed = drive.source, drive.work.engine.rated_speed
    n = based_on(float(moved.omega[p]) / TURN, speed, drive.work.idle)
    mean = None
    with about(Text("crank at {n} rpm", n=round(n * 60))):
        if torque is not None and source.J_E is not None and drive.work.engine.crank_twist is None:
            alpha = acceleration(t_n=torque.t[p], J_E=source.J_E)
        elif source.J_E is None:
            alpha = given_accelerations(source.rows, np.array([n]))[1][0]
        else:
            alpha = based_on(moved.a[p] / (float(source.r_1) * abs(float(drive.work.ratio))), moved.a, source.J_E)
        if torque is not None:
            mean = item(torque.mean[p])
        of = published(alpha, moved.orders, n, moved.cycle, mean)
    orders = {
        f"order_{word}": Stated(
            Described(Text("Acceleration of the crank, order {n}", n=word.replace("_", ".")), "rad/s²", "α̂_n"), size
        )
        for word, size in of.orders.items()
    }
    return MotionAt(
        irregularity=of.irregularity,
        acceleration_up=of.up,
        acceleration_down=of.down,
        mean_torque=mean,
        acceleration=orders,
    )


def _masses(line: TrainOnLine) -> list[Kilogram]:
    """M_c of every mesh."""
    mass = list(line.mass)
    for i in reversed(range(len(mass))):
        if line.parent[i] >= 0:
            with about(Text("mesh {pair}, with what lies behind", pair=line.links[line.parent[i]].title)):
                mass[line.parent[i]] = with_behind(M=mass[line.parent[i]], M_2=mass[i], rho=line.rho[i])
    return mass


def _drags(drive: Drive, p: int, judged: Survey) -> list[Newton]:
    """D_c of every mesh at a point of the survey."""
    line, of = drive.line, drive.work.friction
    D: list[Newton] = []
    for i, link in enumerate(line.links):
        sources = () if of is None else drag_sources(of, link.driven)
        T_d = based_on(float(judged.bodies.drag[p, i]) * float(line.radius[i]), *sources)
        with about(Text("wheel {name}, drag", name=link.driven)):
            D.append(drag_on_line(T_d=T_d, r_b=line.radius[i]))
    for i in reversed(range(len(D))):
        if line.parent[i] >= 0:
            with about(Text("mesh {pair}, with what lies behind", pair=line.links[line.parent[i]].title)):
                D[line.parent[i]] = drag_with_behind(D=D[line.parent[i]], D_2=D[i], rho=line.rho[i])
    return D


def _meshes(
    drive: Drive, judged: Survey, most: Survey, at: Mapping[str, int], operations: Mapping[str, MotionAt]
) -> dict[str, MeshOverSpeed]:
    line, M = drive.line, _masses(drive.line)
    by_mesh: dict[str, dict[str, MeshAt]] = {link.key: {} for link in line.links if link.toothed}
    for place, (op, p) in enumerate(at.items()):
        D = _drags(drive, p, judged)
        for i, link in enumerate(line.links):
            if link.toothed:
                with about(Text("mesh {pair}, {op}", pair=link.title, op=OPERATIONS[op])):
                    by_mesh[link.key][op] = _mesh_at(drive, judged, most, p, place, i, M, D, op, operations[op])
    spans = {}
    for i, link in enumerate(line.links):
        if link.toothed:
            spans[link.key] = _reversal(judged, i)
    return {
        key: MeshOverSpeed(
            operations=of,
            reversal_from=spans[key][0],
            reversal_to=spans[key][1],
            order=mesh_order(z=drive.line.links[line.index(key)].z_1, i=_turns(drive, key)),
        )
        for key, of in by_mesh.items()
    }


def _turns(drive: Drive, key: str) -> Number:
    """Of the driver of a mesh, in a turn of the crank."""
    line = drive.line
    i = line.index(key)
    before = line.turns[line.parent[i]] if line.parent[i] >= 0 else 1.0
    return based_on(abs(before * drive.work.ratio), before, drive.work.ratio)


def _mesh_at(
    drive: Drive,
    judged: Survey,
    most: Survey,
    p: int,
    place: int,
    i: int,
    M: Sequence[Kilogram],
    D: Sequence[Newton],
    op: str,
    crank: MotionAt,
) -> MeshAt:
    """One mesh at a point of the survey, which is the one at `place` in that of the largest backlash."""
    line, of, hits = drive.line, judged.closed, judged.impacts
    rho = float(judged.bodies.ratio[i])
    down = at_mesh(alpha=-crank.acceleration_down, i_1=abs(drive.work.ratio), r_b1=line.first_radius, rho=rho)
    up = at_mesh(alpha=crank.acceleration_up, i_1=abs(drive.work.ratio), r_b1=line.first_radius, rho=rho)
    Gamma = s.separation(M=M[i], a=down, D=D[i]) if D[i] > 0 else None
    least, largest = s.least_force(M=M[i], a=down, D=D[i]), s.most_force(M=M[i], a=up, D=D[i])
    sources = (M[i], down, up, D[i], *(line.play["nominal"][k] for k in line.path(i)))
    if judged.bodies.gravity is not None:
        least, largest = based_on(float(of.least[p, i]), least), based_on(float(of.most[p, i]), largest)
    if op in TRACED:
        low, high = forces_of(judged.bodies, of, judged.strikes, i, p, sources=sources)
    else:
        low, high = based_on(float(hits.low[p, i]), *sources), based_on(float(hits.high[p, i]), *sources)
    u = float(hits.speed[p, i])
    far, worst = most.closed, most.impacts
    return MeshAt(
        separation=Gamma,
        least_force=least,
        most_force=largest,
        impact_speed=s.strike_speed(u=based_on(u, *sources)) if u else based_on(0.0, *sources),
        impact_force_low=low,
        impact_force=high,
        impact_power=_power(judged, p, i, sources),
        impacts=based_on(float(hits.impacts[p, i]), *sources),
        flanks=based_on(float(hits.flanks[p, i]), *sources),
        backlash_share=based_on(float(hits.share[p, i]), *sources),
        separation_most=based_on(float(far.separation[place, i]), *sources) if D[i] > 0 else None,
        least_force_most=based_on(float(far.least[place, i]), *sources),
        most_force_most=based_on(float(far.most[place, i]), *sources),
        impact_speed_most=based_on(float(worst.speed[place, i]), *sources),
        impact_force_low_most=based_on(float(worst.low[place, i]), *sources),
        impact_force_most=based_on(float(worst.high[place, i]), *sources),
        impact_power_most=based_on(float(worst.power[place, i]), *sources),
        impacts_most=based_on(float(worst.impacts[place, i]), *sources),
        flanks_most=based_on(float(worst.flanks[place, i]), *sources),
        backlash_share_most=based_on(float(worst.share[place, i]), *sources),
    )


def _power(judged: Survey, p: int, i: int, sources: Sequence[object]) -> Watt:
    """Of the strikes of a body's own orbit."""
    T_o, flown = float(judged.strikes.orbit[p, i]), judged.strikes.speed[p, i]
    if not T_o:
        return based_on(0.0, *sources)
    M = based_on(float(judged.closed.mass[i]), *sources)
    W: Watt = s.impact_power(M=M, u=based_on(flown[flown > 0], *sources), T=T_o)
    return W


def _reversal(judged: Survey, i: int) -> tuple[RevPerSecond | None, RevPerSecond | None]:
    """Between which speeds the flanks of a mesh part at any load, linear between the speeds of the survey."""
    speeds = np.unique(judged.speeds)
    least = np.array([judged.closed.least[judged.speeds == n, i].min() for n in speeds])
    parts = np.flatnonzero(least < 0)
    if not parts.size:
        return None, None
    first, last = int(parts[0]), int(parts[-1])
    low, high = float(speeds[first]), float(speeds[last])
    if first > 0:
        low -= (low - speeds[first - 1]) * least[first] / (least[first] - least[first - 1])
    if last < speeds.size - 1:
        high += (speeds[last + 1] - high) * least[last] / (least[last] - least[last + 1])
    return float(low), float(high)


def _torques(drive: Drive, judged: Survey, operations: Mapping[str, MotionAt], moved: Motion) -> Irregular:
    """What the rating takes: the largest torque by inertia over all points, and by how much each slows down."""
    line, M, of, torques = drive.line, _masses(drive.line), judged.closed, {}
    p = int(np.argmax(of.speeding[:, 0]))
    rated = judged.at(float(drive.work.engine.rated_speed), drive.source.loads[-1])
    alpha = based_on(
        float(of.speeding[p, 0])
        / (float(line.first_radius) * abs(float(drive.work.ratio)) * float(judged.bodies.ratio[0])),
        moved.a,
    )
    for i, link in enumerate(line.links):
        with about(Text("mesh {pair}, inertia", pair=link.title)):
            a = at_mesh(
                alpha=alpha, i_1=abs(drive.work.ratio), r_b1=line.first_radius, rho=float(judged.bodies.ratio[i])
            )
            dynamic = dynamic_torque(M=M[i], a=a, r_b=line.radius[i], z_1=link.z_1, z_2=link.z_2)
        lever = of.mass[i] * float(line.radius[i]) * link.z_1 / link.z_2
        slowing, at_rated = lever * of.slowing[:, i], float(lever * of.speeding[rated, i])
        D = of.drag[:, i]
        share = D / D[rated] if D[rated] > 0 else np.ones(D.size)
        torques[link.key] = MeshTorques(dynamic, slowing.tolist(), share.tolist(), at_rated)
    return Irregular(torques, drive.source.assumed)


def _result(
    drive: Drive,
    judged: Survey,
    most: Survey,
    at: Mapping[str, int],
    operations: Mapping[str, MotionAt],
    meshes: Mapping[str, MeshOverSpeed],
    torques: Irregular,
) -> DriveResult:
    p, u = at[HARDEST], None
    if IDLE in at and meshes:
        speeds = [mesh.operations[IDLE].impact_speed for mesh in meshes.values()]
        u = max(speeds)
    powers = []
    for op in (IDLE, HARDEST):
        if op in at:
            with about(Text("train, {op}", op=OPERATIONS[op])):
                parts = [mesh.operations[op].impact_power for mesh in meshes.values()]
                if parts:
                    powers.append(reduce(lambda W, W_i: with_power(W=W, W_i=W_i), parts))
    hardest = [mesh.operations[HARDEST].impact_force for mesh in meshes.values()]
    return DriveResult(
        idle_speed=drive.work.idle,
        inertia_total=drive.source.J_E,
        operations=dict(operations),
        hardest_speed=based_on(float(judged.speeds[p]), *hardest),
        hardest_load=based_on(float(judged.loads[p]), *hardest),
        impact_power=max(powers, default=0.0),
        impact_speed=u,
        grade=None if u is None else based_on(float(grade_of(u)), u),
        assumed=drive.source.assumed,
        drive=drive,
        survey=judged,
        most=most,
        at=dict(at),
        meshes=dict(meshes),
        torques=torques,
    )
