# SPDX-License-Identifier: Apache-2.0
"""The drive over speed: motion of the crank, forces and strikes of every mesh, and what they do to the teeth.

`over_speed` comes before the rating, which takes what the motion adds to its torque; `struck` after it, with the forces
of the strikes in place of that torque."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import reduce

import numpy as np

from ...engine.inputs import EngineInputs
from ...engine.operation import GasRow
from ...engine.result import EngineResult
from ...friction.drag import drags
from ...friction.result import FrictionResult
from ...library.catalogue import Material
from ...sheet.arrays import Array
from ...sheet.deferred import Later
from ...sheet.formula import formula
from ...sheet.record import record
from ...sheet.step import Outcome, finite
from ...sheet.text import Text
from ...sheet.units import (
    Kilogram,
    KilogramMetre2,
    Metre,
    MetrePerSecond,
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
from .bodies import LIGHT_SHAFT, ShaftBody, TrainOnLine, drag_on_line, inertias, measured, on_line, with_body
from .checks import grade_of
from .crank import UnevenRow, default_row, firing_order, given_accelerations, given_motion, motion, published
from .forces import forces_of
from .orders import mesh_order
from .result import HARDEST, IDLE, IDLE_FULL, RATED, DriveResult, MeshAt, MeshOverSpeed, MotionAt
from .survey import CORNERS, Drags, Spring, Survey, grid, survey

DRAG_SPEEDS = 7


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


@formula("J", "geometry: backlash of all meshes of the way that part, as the last of them sees it", unit="µm")
def with_backlash(J: Metre, j: Metre, rho: Number) -> Metre:
    """`rho`: from the mesh before to this one."""
    return J * rho + j


@formula("J/x̂", "definition: backlash of the way over half the swing of the driver along the line of action")
def backlash_share(J: Metre, x: Metre) -> Number:
    return J / x


@formula(
    "u",
    "rule of this program, flanks that strike without rebound: speed across the backlash of the way, where they meet",
    shows="v(t) − v(t_0) + g·(t − t_0) where x(t) − x(t_0) − v(t_0)·(t − t_0) + g·(t − t_0)²/2 reaches a flank",
    unit="mm/s",
)
def strike_speed(u: MetrePerSecond) -> MetrePerSecond:
    """The largest of an orbit, as the flight has it."""
    return u


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
        return self.work.engine.strokes * math.pi

    def torque(self, speeds: Array, loads: Array) -> CrankTorque:
        work = self.work
        return crank_torque(work.engine, work.e, work.rows, speeds, loads, idle=work.idle)

    def moved(self, speeds: Array, loads: Array, torque: CrankTorque | None = None) -> Motion:
        """Of the first driver; `torque`: at these points, where it is there already."""
        i_1 = abs(self.work.ratio)
        if self.J_E is None:
            return given_motion(self.rows, speeds, self.cycle, self.r_1, i_1)
        torque = self.torque(speeds, loads) if torque is None else torque
        return motion(
            torque, speeds, self.J_E, self.r_1, i_1, twist=self.work.engine.crank_twist, nose=self.nose
        )


def _said(gears: GearsInputs) -> bool:
    """Whether the design gives an irregularity."""
    return gears.speed_irregularity is not None or bool(gears.drive is not None and gears.drive.irregularity)


def source_of(work: CrankAtWork, gears: GearsInputs, line: TrainOnLine) -> Source:
    """By rows of an irregularity, else by gas or torque diagram with flywheel, else by a default."""
    engine, end = work.engine, gears.drive.driven_from if gears.drive is not None else None
    nose = end == "nose" if end is not None else bool(work.front)
    rows: tuple[UnevenRow, ...] = ()
    J_E, loads = None, (0.0,)
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
            J_E = reduce(lambda J, of: with_body(J=J, J_k=of[0], i_k=of[1]), zip(line.J, turns), engine.flywheel_inertia)
        one_load = engine.gas is None or bool(engine.gas.pressure)
        loads = (1.0,) if one_load or not _idles(work) else LOADS
    else:
        rows = (default_row(engine, work.idle),)
    return Source(work, gears, J_E, rows, loads, nose, line.first_radius)


def _idles(work: CrankAtWork) -> bool:
    """Whether the cycle without brake load is known or can be solved; else full load stands alone."""
    try:
        with untraced():
            crank_torque(work.engine, work.e, work.rows, np.array([float(work.idle)]), np.zeros(1), idle=work.idle)
    except NoSolution:
        return False
    return True


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

    def drawn(self) -> Survey:
        """The map."""
        work = self.work
        with untraced():
            return self.survey(*grid(float(work.idle), float(work.engine.rated_speed), self.source.loads, DRAWN))
