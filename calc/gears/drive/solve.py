# SPDX-License-Identifier: Apache-2.0
"""The drive over speed: motion of the crank, forces and strikes of every mesh, and what they do to the teeth.

`over_speed` comes before the rating, which takes what the motion adds to its torque; `struck` after it, with the forces
of the strikes in place of that torque."""

import math
from collections.abc import Mapping, Sequence
from functools import reduce

import numpy as np

from ...engine.load import CrankTorque
from ...library.catalogue import Material
from ...sheet.arrays import Array
from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.linked_array import item
from ...sheet.quantity import Described, Stated
from ...sheet.record import replace
from ...sheet.step import Outcome, finite
from ...sheet.text import Text
from ...sheet.units import (
    Hertzes,
    Kilogram,
    KilogramMetre2,
    Metre,
    MetrePerSecond2,
    Newton,
    NewtonMetre,
    Newtons,
    Number,
    RadPerSecond2,
    RevPerSecond,
    Watt,
)
from ...sheet.value import about, based_on, trace, untraced
from ..inputs import GearsInputs
from ..limits import EXTREME
from ..rating.irregular import Irregular, MeshTorques
from ..result import TrainResult
from . import strikes as s
from .bodies import counted, drag_on_line, inertias, measured, on_line, with_body
from .checks import grade_of
from .crank import (
    UnevenRow,
    acceleration,
    default_row,
    firing_order,
    given_accelerations,
    published,
)
from .forces import AtPoint, at_point, forces_in
from .line import TrainOnLine
from .motion import Motion
from .orders import mesh_order
from .result import HARDEST, IDLE, IDLE_FULL, OPERATIONS, RATED, DriveResult, MeshAt, MeshOverSpeed, MotionAt
from .source import CrankAtWork, Drive, Source
from .spring import Spring, split_wheel
from .survey import FULL, LOADS, Drags, Survey, survey

DRAG_SPEEDS = 7
TRACED = (IDLE, HARDEST)  # the operating points whose strikes are shown line by line
TURN = 2 * math.pi


# --- formulas

REVERSAL = "rule of this program: where flanks part, straight between the speeds that are computed"
BEHIND = {"M": "M_i", "M_2": "M_c,2", "D": "D_i", "D_2": "D_c,2", "rho": "ρ_b"}


@formula(
    "M_c",
    "dynamics: with what its body drives, ρ times as fast on the line of action",
    names=BEHIND,
    meanings={
        "rho": "Speed on the line of action of what is behind, over that of the mesh",
        "return": "Mass on the line of action, with what its body drives",
    },
)
def with_behind(M: Kilogram, M_2: Kilogram, rho: Number) -> Kilogram:
    return M + M_2 * rho**2


@formula(
    "D_c",
    "statics: with what its body drives, ρ times as fast on the line of action",
    names=BEHIND,
    meanings={
        "rho": "Speed on the line of action of what is behind, over that of the mesh",
        "return": "Drag on the line of action, with what its body drives",
    },
)
def drag_with_behind(D: Newton, D_2: Newton, rho: Number) -> Newton:
    return D + D_2 * rho


@formula(
    "a_F",
    "kinematics: acceleration of the crank along the line of action of a mesh",
    names={"alpha": "ω'", "rho": "ρ_b"},
    meanings={
        "alpha": "Angular acceleration of the crank",
        "i_1": "Turns of the first driver in a turn of the crank",
        "r_b1": "Base radius of the first driver",
        "rho": "Speed on the line of action of the mesh, over that of the first driver",
    },
)
def at_mesh(alpha: RadPerSecond2, i_1: Number, r_b1: Metre, rho: Number) -> MetrePerSecond2:
    """`i_1`: turns of the first driver in a turn of the crank, `r_b1` its base radius, `rho` from there to the mesh."""
    return alpha * i_1 * r_b1 * rho


@formula(
    "T_dyn",
    "dynamics: torque at the driver that accelerates all that its mesh drives",
    names={"M": "M_c", "a": "a_F"},
    meanings={"r_b": "Base radius"},
)
def dynamic_torque(M: Kilogram, a: MetrePerSecond2, r_b: Metre, z_1: Number, z_2: Number) -> NewtonMetre:
    """`r_b` of the driven wheel."""
    return M * a * r_b * z_1 / z_2


@formula(
    "n_F,1",
    REVERSAL,
    unit="rpm",
    shows="lowest speed at which F_least = 0, or where they part at idle that",
    names={"F": "F_least"},
)
def first_reversal(n: Hertzes, F: Newtons) -> RevPerSecond:
    """`n`: rising speeds of the crank (S,), `F`: least force over cycle and loads at each, below 0 at some.

    >>> first_reversal(n=np.array([10.0, 20.0, 30.0]), F=np.array([30.0, -10.0, -20.0]))
    17.5
    """
    i = int(np.flatnonzero(F < 0)[0])
    return float(n[0] if i == 0 else n[i - 1] + (n[i] - n[i - 1]) * F[i - 1] / (F[i - 1] - F[i]))


@formula(
    "n_F,2",
    REVERSAL,
    unit="rpm",
    shows="highest speed at which F_least = 0, or where they part at rated speed that",
    names={"F": "F_least"},
)
def last_reversal(n: Hertzes, F: Newtons) -> RevPerSecond:
    """The same from above.

    >>> last_reversal(n=np.array([10.0, 20.0, 30.0]), F=np.array([-30.0, -10.0, 10.0]))
    25.0
    """
    return -first_reversal.function(-n[::-1], F[::-1])


@formula("ΣW_u", "mathematics: sum over the bodies that strike", names={"W": "W_u", "W_i": "W_u,i"})
def with_power(W: Watt, W_i: Watt) -> Watt:
    return W + W_i


# --- the motion of the crank, whatever it is known by


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
    solved = {} if work.friction is None else work.friction.drags(speeds / rated)
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
    line = drive.line
    D: list[Newton] = []
    for i, link in enumerate(line.links):
        T_d = based_on(float(judged.bodies.drag[p, i]) * float(line.radius[i]), *drive.drag_sources(link.driven))
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
        seen = at_point(judged.bodies, judged.closed, judged.strikes, judged.impacts, p) if op in TRACED else None
        for i, link in enumerate(line.links):
            if link.toothed:
                with about(Text("mesh {pair}, {op}", pair=link.title, op=OPERATIONS[op])):
                    by_mesh[link.key][op] = _mesh_at(drive, judged, most, p, place, i, M, D, seen, operations[op])
    spans = {}
    for i, link in enumerate(line.links):
        if link.toothed:
            spans[link.key] = _reversal(drive, judged, i)
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
    seen: AtPoint | None,
    crank: MotionAt,
) -> MeshAt:
    """One mesh at a point of the survey, which is the one at `place` in that of the largest backlash; `seen`: its
    strikes, where they are shown line by line."""
    line, of, hits = drive.line, judged.closed, judged.impacts
    rho = float(judged.bodies.ratio[i])
    slowing = based_on(-crank.acceleration_down, crank.acceleration_down)
    down = at_mesh(alpha=slowing, i_1=abs(drive.work.ratio), r_b1=line.first_radius, rho=rho)
    up = at_mesh(alpha=crank.acceleration_up, i_1=abs(drive.work.ratio), r_b1=line.first_radius, rho=rho)
    Gamma = s.separation(M=M[i], a=down, D=D[i]) if D[i] > 0 else None
    least, largest = s.least_force(M=M[i], a=down, D=D[i]), s.most_force(M=M[i], a=up, D=D[i])
    stands = based_on(0.0, M[i], down, up, D[i], *(line.play["nominal"][k] for k in line.path(i)))  # on these
    if judged.bodies.gravity is not None:
        least, largest = based_on(float(of.least[p, i]), least), based_on(float(of.most[p, i]), largest)
    if seen is not None:
        low, high = forces_in(seen, i, (stands,))
    else:
        low, high = based_on(float(hits.low[p, i]), stands), based_on(float(hits.high[p, i]), stands)
    u = float(hits.speed[p, i])
    far, worst = most.closed, most.impacts
    return MeshAt(
        separation=Gamma,
        least_force=least,
        most_force=largest,
        impact_speed=s.strike_speed(u=based_on(u, stands)) if u else based_on(0.0, stands),
        impact_force_low=low,
        impact_force=high,
        impact_power=_power(judged, p, i, (stands,)),
        impacts=based_on(float(hits.impacts[p, i]), stands),
        flanks=based_on(float(hits.flanks[p, i]), stands),
        backlash_share=based_on(float(hits.share[p, i]), stands),
        separation_most=based_on(float(far.separation[place, i]), stands) if D[i] > 0 else None,
        least_force_most=based_on(float(far.least[place, i]), stands),
        most_force_most=based_on(float(far.most[place, i]), stands),
        impact_speed_most=based_on(float(worst.speed[place, i]), stands),
        impact_force_low_most=based_on(float(worst.low[place, i]), stands),
        impact_force_most=based_on(float(worst.high[place, i]), stands),
        impact_power_most=based_on(float(worst.power[place, i]), stands),
        impacts_most=based_on(float(worst.impacts[place, i]), stands),
        flanks_most=based_on(float(worst.flanks[place, i]), stands),
        backlash_share_most=based_on(float(worst.share[place, i]), stands),
    )


def _power(judged: Survey, p: int, i: int, sources: Sequence[object]) -> Watt:
    """Of the strikes of a body's own orbit."""
    T_o, flown = float(judged.strikes.orbit[p, i]), judged.strikes.speed[p, i]
    if not T_o:
        return based_on(0.0, *sources)
    M = based_on(float(judged.closed.mass[i]), *sources)
    W: Watt = s.impact_power(M=M, u=based_on(flown[flown > 0], *sources), T=T_o)
    return W


def _reversal(drive: Drive, judged: Survey, i: int) -> tuple[RevPerSecond | None, RevPerSecond | None]:
    """Between which speeds the flanks of a mesh part at any load."""
    speeds = judged.each_speed
    least = np.full(speeds.shape, np.inf)
    np.minimum.at(least, np.searchsorted(speeds, judged.speeds), judged.closed.least[:, i])
    if not np.any(least < 0):
        return None, None
    n = based_on(speeds, drive.work.idle, drive.work.engine.rated_speed)
    F = based_on(least, judged.motion.a, *(drive.line.mass[k] for k in drive.line.path(i)))
    with about(Text("mesh {pair}, over speed and load", pair=drive.line.links[i].title)):
        return first_reversal(n=n, F=F), last_reversal(n=n, F=F)


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


def _jams(drive: Drive, judged: Survey, p: int) -> tuple[str, ...]:
    """The meshes that part of themselves at a point and have no backlash to part in: no speed says how they rattle."""
    stuck = judged.closed.parts[p] & (judged.bodies.backlash <= 0)
    return tuple(link.title for link, jams in zip(drive.line.links, stuck) if jams)


def _result(
    drive: Drive,
    judged: Survey,
    most: Survey,
    at: Mapping[str, int],
    operations: Mapping[str, MotionAt],
    meshes: Mapping[str, MeshOverSpeed],
    torques: Irregular,
) -> DriveResult:
    p, u, work = at[HARDEST], None, drive.work
    jams = _jams(drive, judged, at[IDLE]) if IDLE in at else ()
    if IDLE in at and meshes and not jams:
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
        idle_speed=work.idle,
        inertia_total=drive.source.J_E,
        operations=dict(operations),
        hardest_speed=based_on(float(judged.speeds[p]), *hardest),
        hardest_load=based_on(float(judged.loads[p]), *hardest),
        impact_power=max(powers, default=0.0),
        impact_speed=u,
        grade=None if u is None else based_on(float(grade_of(u)), u),
        assumed=based_on(float(drive.source.assumed), work.engine.flywheel_inertia, work.idle),
        jams=jams,
        drive=drive,
        survey=judged,
        most=most,
        at=dict(at),
        meshes=dict(meshes),
        torques=torques,
    )
