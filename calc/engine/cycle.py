# SPDX-License-Identifier: Apache-2.0
"""The pressure in a cylinder over its cycle, and the forces on its piston.

ε is the crank angle after the TDC at which the cylinder fires, from 0 up to the cycle: 720° of a four-stroke engine,
360° of a two-stroke.  α = φ₀ + ε is the crank angle from the cylinder's axis, x the piston's way from TDC.  Pressures
are absolute; forces are positive towards the crank.  The simple cycle: compression from BDC, the peak at TDC and held
for a while, expansion to BDC; a four-stroke engine exhausts and draws in at constant pressures between."""

import math

import numpy as np

from ..sheet.arrays import Array, Value
from ..sheet.formula import formula
from ..sheet.functions import asin, cos, joined, pi, power, single_or_many
from ..sheet.record import record
from ..sheet.text import Text
from ..sheet.units import Kilogram, Metre, Newton, NewtonMetre, Number, Pascal, Pascals, Radian, Radians, RadPerSecond
from ..sheet.value import based_on

TURN = 2 * math.pi
DUST: Radian = 1e-9
SEILIGER = Text("thermodynamics, mixed (Sabathé, Seiliger) cycle of an ideal gas")
WIDE = math.radians(60.0)  # a gap between the points of a table that is worth a word
PANEL = math.radians(1.0)  # of the integration over a cycle, with its middle


# --- motion


@formula(
    "ε_k",
    "kinematics: crank angle after the firing of the cylinder, within its cycle",
    shows="ε − f_k, f_k the crank angle at which the cylinder fires",
)
def own_angle(epsilon: Radian, fires: Radian, cycle: Radian) -> Radian:
    since: Array = np.mod(epsilon - fires, cycle)
    return single_or_many(np.where((cycle - since < DUST) | (since < DUST), 0.0, since))


@formula("α", "definition of the crank angle from the cylinder's axis", names={"phi_0": "φ_0", "epsilon": "ε_k"})
def crank_angle(phi_0: Radian, epsilon: Radian) -> Radian:
    return phi_0 + epsilon


@formula(
    "x",
    "Finotti 2013, eq. 2.7, its bracket corrected: way of the piston from TDC, with offset",
    unit="mm",
    names={"lam": "λ"},
)
def piston_way(r: Metre, lam: Number, phi_0: Radian, alpha: Radian, beta: Radian) -> Metre:
    return r * joined((1 + 1 / lam) * cos(phi_0) - cos(alpha), -(cos(beta) / lam))


@formula(
    "ε_BDC", "kinematics, dead centres of the offset slider-crank: crank angle from TDC to BDC", names={"lam": "λ"}
)
def dead_centre_angle(delta: Number, lam: Number) -> Radian:
    return pi + asin(delta / (1 - lam)) - asin(delta / (1 + lam))


# --- pressure


@formula(
    "h_c",
    "definition of the compression ratio: height of the clearance volume on the bore",
    unit="mm",
    names={"eps_c": "ε_c"},
)
def clearance_height(s: Metre, eps_c: Number) -> Metre:
    return s / (eps_c - 1)


@formula(
    "p_c",
    Text("{seiliger}: end of compression", seiliger=SEILIGER),
    unit="bar",
    names={"eps_c": "ε_c"},
    meanings={"n_c": "Exponent of the compression"},
)
def compression_end(p_in: Pascal, eps_c: Number, n_c: Number) -> Pascal:
    return p_in * power(eps_c, n_c)


@formula(
    "p_1",
    Text("{seiliger}: polytropic compression from BDC", seiliger=SEILIGER),
    unit="bar",
    meanings={"n_c": "Exponent of the compression"},
)
def compression(p_in: Pascal, h_c: Metre, s: Metre, x: Metre, n_c: Number) -> Pascal:
    return p_in * power((h_c + s) / (h_c + x), n_c)


@formula(
    "p_2",
    Text("{seiliger}: polytropic expansion from the end of constant pressure, x_p", seiliger=SEILIGER),
    unit="bar",
    meanings={"n_e": "Exponent of the expansion"},
)
def expansion(p_max: Pascal, h_c: Metre, x_p: Metre, x: Metre, n_e: Number) -> Pascal:
    return p_max * power((h_c + x_p) / (h_c + x), n_e)


@formula(
    "p",
    Text("{seiliger}, gas exchange at constant pressure", seiliger=SEILIGER),
    unit="bar",
    shows="p_max up to ε_p, p_2 up to BDC, then p_ex and p_in for a stroke each (four-stroke), p_1 from BDC to TDC",
)
def mixed_cycle(
    epsilon: Radian,
    p_1: Pascal,
    p_2: Pascal,
    p_max: Pascal,
    eps_p: Radian,
    eps_bdc: Radian,
    p_ex: Pascal,
    p_in: Pascal,
    cycle: Radian,
) -> Pascal:
    ends = [epsilon <= eps_p, epsilon <= eps_bdc, epsilon < cycle - TURN, epsilon <= cycle - TURN + eps_bdc]
    return single_or_many(np.select(ends, [p_max, p_2, p_ex, p_in], p_1))


@formula(
    "p",
    "given in the design: indicated pressure",
    unit="bar",
    shows="linear between the points of the table, which closes over the cycle",
)
def table_pressure(epsilon: Radian, angles: Radians, pressures: Pascals, cycle: Radian) -> Pascal:
    return single_or_many(np.asarray(np.interp(epsilon, angles, pressures, period=cycle)))


@record
class MixedCycle:
    """What the formula of the mixed cycle is fed with."""

    s: Metre
    p_max: Pascal
    p_in: Pascal
    p_ex: Pascal
    n_c: Number
    n_e: Number
    eps_p: Radian
    eps_bdc: Radian
    h_c: Metre
    x_p: Metre


@record
class Cycle:
    """The gas of one cylinder.  `corners`: the angles ε where the pressure jumps or bends, `given`: a table's points,
    or a mixed cycle."""

    length: Radian
    crankcase: Pascal
    corners: Array
    given: tuple[Array, Array] | MixedCycle
    notes: tuple[Text, ...]
    compression_end: Pascal | None = None

    def pressure(self, epsilon: Value, x: Value) -> Value:
        """The pressure at crank angles after firing, from 0 up to the cycle, where the piston's way is x."""
        g = self.given
        if isinstance(g, tuple):
            return table_pressure(epsilon=epsilon, angles=g[0], pressures=g[1], cycle=self.length)
        p_1 = compression(p_in=g.p_in, h_c=g.h_c, s=g.s, x=x, n_c=g.n_c)
        p_2 = expansion(p_max=g.p_max, h_c=g.h_c, x_p=g.x_p, x=x, n_e=g.n_e)
        return mixed_cycle(epsilon, p_1, p_2, g.p_max, g.eps_p, g.eps_bdc, g.p_ex, g.p_in, self.length)


def widest_gap(corners: Array, length: Radian) -> tuple[Radian, Radian]:
    """Where the widest gap between the points of a pressure table begins, over the closed cycle, and how wide it is."""
    gap = np.diff(corners, append=corners[:1] + length)
    return float(corners[gap.argmax()]), float(gap.max())


# --- forces on the piston, and what they do at the crank


@formula(
    "F_G",
    "Finotti 2013, 2.2: gas force, crankcase pressure under the piston",
    meanings={"p_case": "Pressure in the crankcase"},
)
def gas_force(p: Pascal, p_case: Pascal, D: Metre) -> Newton:
    return (p - p_case) * pi / 4 * D**2


@formula("F_I", "Finotti 2013, 2.2.2: inertia force of the reciprocating mass, here positive towards the crank")
def inertia_force(M_alt: Kilogram, omega: RadPerSecond, r: Metre, a_rel: Number) -> Newton:
    return -M_alt * omega**2 * r * a_rel


@formula(
    "T_k",
    "Finotti 2013, 2.2.1: couple F·tan β·(L·cos β + r·cos α) = F·r·[sin α + λ·sin α·cos α/√(1 − λ²·sin² α)]; with "
    "offset F·dx/dα",
)
def torque_of(F: Newton, r: Metre, v_rel: Number) -> NewtonMetre:
    return F * r * v_rel


# --- over the cycle


def points(cycle: Cycle, fires: Array) -> Array:
    """Crank angles over the cycle of the whole engine: edges of panels, which meet every corner of every cylinder, and
    their middles.

    The torque is continuous even where the pressure jumps, since it does so at dead centres: Simpson's rule holds on
    every panel."""
    corners = np.mod(cycle.corners[:, None] + fires, cycle.length)
    edges = np.sort(np.concatenate([np.linspace(0.0, cycle.length, round(cycle.length / PANEL) + 1), corners.ravel()]))
    edges = edges[np.append(True, np.diff(edges) > DUST)]
    grid = np.empty(2 * edges.size - 1)
    grid[::2], grid[1::2] = edges, (edges[:-1] + edges[1:]) / 2
    return based_on(grid, cycle.corners, cycle.length, fires)


def running(epsilon: Array, y: Array) -> Array:
    """The integral of y from the first of the points up to each: parabolas over the panels, exact as Simpson's rule at
    their edges."""
    half = np.diff(epsilon[::2]) / 2
    before, middle, after = y[:-1:2], y[1::2], y[2::2]
    steps = np.empty(y.size - 1)
    steps[::2] = half / 12 * (5 * before + 8 * middle - after)
    steps[1::2] = half / 12 * (5 * after + 8 * middle - before)
    return np.append(0.0, np.cumsum(steps))


def highest(x: Array, y: Array) -> tuple[float, float]:
    """Place and height of the largest value: the top of the parabola through it and its neighbours."""
    i = min(max(int(np.argmax(y)), 1), y.size - 2)
    a, b = x[i] - x[i - 1], x[i + 1] - x[i]
    left, right = (y[i] - y[i - 1]) / a, (y[i + 1] - y[i]) / b
    bend, slope = (right - left) / (a + b), (left * b + right * a) / (a + b)
    if bend >= 0:  # the largest is the first or the last, or all are the same
        return float(x[np.argmax(y)]), float(np.max(y))
    way = min(max(-slope / (2 * bend), -a), b)
    return float(x[i] + way), float(max(np.max(y), y[i] + way * (slope + bend * way)))


def first_highest(x: Array, y: Array) -> float:
    """The place of the largest value; of peaks of equal height the first."""
    top = np.max(y)
    inner = np.arange(1, y.size - 1)
    peaks = inner[(y[1:-1] >= y[:-2]) & (y[1:-1] >= y[2:]) & (y[1:-1] > top - 1e-3 * abs(top))]
    candidates = [highest(x[i - 1 : i + 2], y[i - 1 : i + 2]) for i in peaks.tolist()]
    candidates += [(float(x[i]), float(y[i])) for i in (0, -1)]
    best = max(height for _, height in candidates)
    return min(place for place, height in candidates if height >= best - 1e-6 * abs(best))


def amounts(y: Array) -> Array:
    """Amounts among which the largest is one: of a rise and a fall of the same size the rise."""
    return np.where(y < 0, -y * (1 - 1e-9), y)
