# SPDX-License-Identifier: Apache-2.0
"""The torque of the gas on the crank, order by order, at any speeds: linear in the pressures, so that many speeds and
loads cost little more than one.

T = T_m + Σ Re{t_n·e^{inε}}, ε = 0 at the firing TDC of cylinder 1; n in halves for a four-stroke engine."""

from collections.abc import Sequence
from functools import cache

import numpy as np

from ..sheet.arrays import Array, ComplexArray, IndexArray
from ..sheet.formula import formula
from ..sheet.record import record, replace
from ..sheet.units import Newtons, Numbers, PhasorNewtonMetres, Radians
from ..sheet.value import based_on, untraced
from . import cycle as c
from . import formulas as kinematics
from .cycle import Cycle, MixedCycle
from .gas import GasInputs
from .inputs import EngineInputs
from .operation import OfGas, changes
from .result import EngineResult
from .torque import prepare

HIGHEST = 8
SAMPLES = 7200  # over a cycle
INSIDE = 1e-9  # rad: a sample so near to the end of the held pressure belongs to it
BEYOND = 1e-9  # of a speed: so little outside of the nodes is none

# --- orders


def orders_of(strokes: int, highest: float = HIGHEST) -> Array:
    """0.5, 1, … of a four-stroke engine, 1, 2, … of a two-stroke, up to the highest."""
    first = 2.0 / strokes
    orders: Array = np.arange(1, round(highest / first) + 1, dtype=float) * first
    return orders


def order_word(n: float) -> str:
    """The order in the names of values: 1, 1_5, 2 …"""
    return f"{n:g}".replace(".", "_")


def index(n: Array, order: float) -> int:
    return int(np.argmin(np.abs(n - order)))


def integer(harmonics: tuple[complex, ...], n: Array) -> ComplexArray:
    """Harmonics of the turn at their places among the orders of the cycle."""
    placed = np.zeros(n.size, dtype=complex)
    for order, harmonic in enumerate(harmonics, 1):
        placed[index(n, order)] = harmonic
    return placed


# --- formulas


@formula(
    "t_n",
    "mathematics: Fourier analysis of the gas torque of one cylinder over its working cycle",
    shows="2/N·Σ T_k(ε_j)·e^(−i·n·ε_j), N = 7200; T_k of the mixed cycle as the engine has it",
)
def one_cylinder(
    basis: PhasorNewtonMetres, p_max: Newtons, p_2: Newtons, p_ex: Newtons, p_in: Newtons, p_case: Newtons
) -> PhasorNewtonMetres:
    """The torque is linear in the pressures: `basis` holds what each of them does, so that many speeds cost no more
    than one."""
    at = np.asarray(basis)
    parts = np.stack(np.broadcast_arrays(p_max, p_2, p_ex, p_in, p_case), -1)[..., None]
    torque: ComplexArray = np.sum(parts * at, -2)
    return torque


@formula(
    "t_n",
    "mathematics: the cylinders one after the other, the gas torque of each with its spread ε_k, the inertia torque "
    "alike",
    shows="Σ_k t_G,n·(1 + ε_k)·e^(−i·n·f_k) + t_I,n",
    names={"fires": "f"},
)
def all_cylinders(
    t_one: PhasorNewtonMetres, t_inertia: PhasorNewtonMetres, spread: Numbers, fires: Radians, n: Numbers
) -> PhasorNewtonMetres:
    turned = np.exp(-1j * np.asarray(n)[:, None] * fires)
    sums = (turned * (1 + np.asarray(spread))).sum(-1)
    sums[np.abs(sums) < 1e-12 * turned.shape[1]] = 0.0
    torque: ComplexArray = t_one * sums + t_inertia
    torque = np.where(np.abs(torque) < 1e-12 * np.abs(torque).max(-1, keepdims=True), 0.0, torque)
    return torque


# --- of one cylinder, at as many speeds as are asked for; the pressures go linearly from speed to speed


@record
class Basis:
    """What 1 Pa does over the parts of the cycle for every order, and at each sample up to BDC (orders twice, cosines
    over sines, …)."""

    epsilon: Array  # (samples up to BDC,)
    held: Array  # constant pressure
    expanding: Array  # the same times how a polytrope falls
    fixed: ComplexArray  # (parts, orders): exhaust, intake with compression, crankcase

    def up_to(self, until: IndexArray) -> tuple[ComplexArray, ComplexArray]:
        """Held pressure up to each of these samples, and expansion from there to BDC (speeds, orders)."""
        ends, which = np.unique(np.concatenate([until, [self.epsilon.size]]), return_inverse=True)
        starts = np.concatenate([[0], ends[:-1]])
        held, fallen = (
            np.cumsum(np.add.reduceat(part, starts, axis=1), axis=1).T for part in (self.held, self.expanding)
        )
        at = which[:-1]
        return _together(held[at]), _together(fallen[which[-1]] - fallen[at])

    def parts(self, eps_p: Array) -> ComplexArray:
        """Of every operating point, by the angle for which its peak is held: what 1 Pa does of the peak, of the
        expansion, and of exhaust, intake and crankcase (points, 5, orders)."""
        parts = np.empty((eps_p.size, 5, self.fixed.shape[1]), dtype=np.complex128)
        parts[:, 0], parts[:, 1] = self.up_to(np.searchsorted(self.epsilon, eps_p + INSIDE, side="right"))
        parts[:, 2:] = self.fixed
        return parts


def _together(parts: Array) -> ComplexArray:
    """Cosine and sine parts, side by side along the last axis, as phasors."""
    half = parts.shape[-1] // 2
    return parts[..., :half] - 1j * parts[..., half:]


def basis(engine: EngineInputs, e: EngineResult, cycle: Cycle, n: Array) -> Basis:
    """Of the mixed cycle of an engine; the samples are evenly spaced over the working cycle, its parts follow each
    other."""
    g = cycle.given
    assert isinstance(g, MixedCycle)
    epsilon, arm, way = _arms(engine, e, cycle)
    turning = _turning(tuple(n.tolist()), float(cycle.length))
    h_c, s, bdc, turn = float(g.h_c), float(g.s), float(g.eps_bdc), float(cycle.length) - c.TURN
    last, exhaust, intake = np.searchsorted(epsilon, (bdc, turn, turn + bdc), side="right").tolist()
    exhaust = max(last, int(np.searchsorted(epsilon, turn, side="left")))  # a two-stroke engine has neither of the two
    intake = max(last, intake)
    pressed = arm.copy()
    pressed[intake:] *= ((h_c + s) / (h_c + way[intake:])) ** float(g.n_c)
    fixed = np.stack(
        [
            turning[:, last:exhaust] @ arm[last:exhaust],
            turning[:, exhaust:] @ pressed[exhaust:],
            -(turning @ arm),
        ]
    )
    held = turning[:, :last] * arm[:last]
    return Basis(epsilon[:last], held, held * (h_c + way[:last]) ** -float(g.n_e), _together(fixed))


def expansion_from(engine: EngineInputs, e: EngineResult, g: MixedCycle, eps_p: Array) -> Array:
    """By what the peak pressure, held for ε_p, is multiplied where the expansion counts (h_c + x)^−n_e."""
    with untraced():
        alpha = e.tdc_angle + eps_p
        beta = kinematics.rod_angle(lam=e.lambda_, alpha=alpha, delta=e.delta)
        x_p = c.piston_way(r=engine.crank_radius, lam=e.lambda_, phi_0=e.tdc_angle, alpha=alpha, beta=beta)
    factor: Array = (float(g.h_c) + x_p) ** float(g.n_e)
    return factor


@cache
def _turning(orders: tuple[float, ...], length: float) -> Array:
    """Cosines and sines of every order at the samples of a cycle (orders twice, samples)."""
    angles = np.array(orders)[:, None] * np.arange(SAMPLES) * (length / SAMPLES)
    return np.concatenate([np.cos(angles), np.sin(angles)])


def _arms(engine: EngineInputs, e: EngineResult, cycle: Cycle) -> tuple[Array, Array, Array]:
    """Sample angles, what 1 Pa does there on the crank, over half the samples, and the piston's way."""
    epsilon: Array = np.arange(SAMPLES, dtype=float) * (float(cycle.length) / SAMPLES)
    with untraced():
        alpha = e.tdc_angle + epsilon
        beta = kinematics.rod_angle(lam=e.lambda_, alpha=alpha, delta=e.delta)
        v_rel = kinematics.relative_speed(alpha=alpha, beta=beta)
        way = c.piston_way(r=engine.crank_radius, lam=e.lambda_, phi_0=e.tdc_angle, alpha=alpha, beta=beta)
        arm = c.torque_of(F=c.gas_force(p=1.0, p_case=0.0, D=engine.bore), r=engine.crank_radius, v_rel=v_rel)
    return epsilon, arm * (2.0 / SAMPLES), way


def of_table(engine: EngineInputs, e: EngineResult, cycle: Cycle, n: Array) -> ComplexArray:
    epsilon, arm, way = _arms(engine, e, cycle)
    with untraced():
        p = cycle.pressure(epsilon, way) - float(cycle.crankcase)
    return _together(_turning(tuple(n.tolist()), float(cycle.length)) @ (arm * p))


@record
class Nodes:
    """The speeds at which the gas is given, ascending, and the cycle at each; one node where it is the same
    everywhere."""

    speeds: Array
    cycles: tuple[Cycle, ...]
    basis: "Basis | ComplexArray"  # of a table of pressures: t_n itself

    def outside(self, speed: float) -> bool:
        lowest, highest = float(self.speeds[0]), float(self.speeds[-1])
        return len(self.cycles) > 1 and not lowest * (1 - BEYOND) <= speed <= highest * (1 + BEYOND)


def nodes(engine: EngineInputs, e: EngineResult, gas: GasInputs, rows: Sequence[OfGas], n: Array) -> Nodes:
    """Rows that say something of the gas are nodes; where there are none, [engine.gas] holds at every speed."""
    given = sorted((row for row in rows if row.has_gas), key=lambda row: row.speed)
    cycles = tuple(prepare(engine, e, replace(gas, **changes(row))) for row in given) or (prepare(engine, e, gas),)
    speeds = np.array([row.speed for row in given] or [engine.rated_speed])
    of = basis if isinstance(cycles[0].given, MixedCycle) else of_table
    return Nodes(speeds, cycles, of(engine, e, cycles[0], n))


def harmonics(engine: EngineInputs, e: EngineResult, at: Nodes, speeds: Array, *, mean: bool = False) -> ComplexArray:
    """t_n of one cylinder (speeds, orders); `mean`: of order 0, twice the mean torque."""
    b = at.basis
    if mean:
        b = (basis if isinstance(b, Basis) else of_table)(engine, e, at.cycles[0], np.zeros(1))
    if not isinstance(b, Basis):  # a table of pressures: the same at every speed
        same: ComplexArray = np.broadcast_to(b, (len(speeds), b.size))
        return same
    cycles = [(cycle, g) for cycle in at.cycles if isinstance(g := cycle.given, MixedCycle)]
    v = np.asarray(speeds, dtype=float)

    def over(values: list[float]) -> Array:
        return np.asarray(np.interp(v, at.speeds, values), dtype=float)

    p_max, p_in, p_ex = (over([float(getattr(g, key)) for _, g in cycles]) for key in ("p_max", "p_in", "p_ex"))
    p_case, eps_p = over([float(cycle.crankcase) for cycle, _ in cycles]), over([float(g.eps_p) for _, g in cycles])
    parts = b.parts(eps_p)
    p_2 = p_max * expansion_from(engine, e, cycles[0][1], eps_p)
    of = [part for _, g in cycles for part in (g.p_max, g.p_in, g.p_ex, g.eps_p, g.x_p, g.h_c, g.n_c, g.n_e)]
    return one_cylinder(basis=parts, p_max=based_on(p_max, *of), p_2=p_2, p_ex=p_ex, p_in=p_in, p_case=p_case)
