# SPDX-License-Identifier: Apache-2.0
"""How hard strikes are on the teeth: low, high, and the whip of one wheel against its neighbour; what each mesh has.

Low: the mass of all that is behind a mesh strikes through the teeth of its whole path, in series.  High: through the
teeth of one mesh alone.  The truth is some way between; neither is a bound.

A body is struck by the strikes of its own orbit and of those of every body before it on its path, whatever its own Γ:
u and p count Πρ there.  Of the bodies behind a mesh that a strike reaches, the first has the largest mass, so the high
force has to be sought for that one alone."""

from collections.abc import Callable, Sequence

import numpy as np

from ...sheet.arrays import Array, BoolArray, IndexArray
from ...sheet.formula import formula
from ...sheet.functions import along, modulus, power, smallest, sqrt
from ...sheet.record import record
from ...sheet.text import Text
from ...sheet.units import (
    Kilogram,
    Metre,
    MetrePerSecond,
    MetrePerSecond2,
    Newton,
    NewtonPerMetre,
    NewtonsPerMetre,
    Number,
    Numbers,
    Pascal,
)
from ...sheet.value import about, based_on, untraced
from ..rating import dynamic
from .motion import Bodies, Motion
from .strikes import RULE, Closed, Strikes

LIGHT: NewtonPerMetre = dynamic.LIGHT  # below this line load teeth are softer
OF_MESH = {"k": "k_γ", "M": "M_i", "rho": "ρ_b"}
PASSES = 10  # each takes the error to an eighth and less, from that of teeth that do not soften at a light load
COUNTS_FROM = 0.05  # of the hardest strike of the orbit

# --- formulas

STIFFNESS = Text(
    "{clause_9}: stiffness of the teeth in mesh, at a line load below 100 N/mm too", clause_9=dynamic.CLAUSE_9
)


@formula(
    "k_γ",
    STIFFNESS,
    unit="kN/mm",
    names={"c": "c_γα,100"},
    meanings={"F": "Force on the teeth", "b": "Face width", "c": "Mesh stiffness at 100 N/mm and more"},
)
def stiffness_at(F: Newton, b: Metre, c: Pascal) -> NewtonPerMetre:
    """`c`: the mesh stiffness at 100 N/mm and more; a rim of another material has its factor in it.

    >>> round(stiffness_at(F=93.75, b=15e-3, c=16e9))
    120000000"""
    return b * c * power(smallest(1.0, F / b / LIGHT), 0.25)


@formula(
    "k_low",
    Text("{rule}: the teeth of all meshes of the path in series", rule=RULE),
    unit="kN/mm",
    names=OF_MESH,
    meanings={"rho": "Speed on the line of action, over that of the mesh"},
)
def path_stiffness(k: NewtonsPerMetre, rho: Numbers) -> NewtonPerMetre:
    """`k` of each mesh of the path, `rho` the factor of speed from it to the last.

    >>> float(path_stiffness(k=np.array([2e8, 2e8]), rho=np.array([1.0, 1.0])))
    100000000.0"""
    return 1 / along(rho**2 / k)


@formula(
    "F",
    Text("{rule}: greatest force of a mass that strikes a spring and is pressed to it steadily", rule=RULE),
    names={"M": "M_c", "k": "k_γ", "u": "u_s"},
    meanings={
        "M": "Mass on the line of action",
        "p": "Acceleration that presses the mass to the teeth",
        "u": "Speed of a strike",
    },
)
def strike_force(M: Kilogram, p: MetrePerSecond2, k: NewtonPerMetre, u: MetrePerSecond) -> Newton:
    """k is that of the force itself, the point where both agree.

    >>> round(strike_force(M=10.0, p=0.0, k=1e8, u=0.05), 3)
    1581.139"""
    return M * modulus(p) + sqrt((M * p) ** 2 + k * M * u**2)


@formula(
    "μ", Text("dynamics: mass by which two bodies strike each other; ρ_b takes the driver's to the mesh"), names=OF_MESH
)
def reduced_mass(M: Kilogram, M_driver: Kilogram, rho: Number) -> Kilogram:
    return M * M_driver / (M_driver + rho**2 * M)


@formula(
    "F_whip",
    Text("{rule}: a wheel that is thrown back meets its neighbour at twice the speed of the strike", rule=RULE),
    names={"c": "c_γα,100", "M": "μ", "u": "u_b"},
)
def whip_force(M: Kilogram, u: MetrePerSecond, b: Metre, c: Pascal) -> Newton:
    """2·u·√(k·μ) with k of this force itself: 2·u·√(b·c·μ), below 100 N/mm the smaller by the seventh root."""
    return 2 * u * sqrt(b * c * M) * power(smallest(1.0, 2 * u * sqrt(b * c * M) / b / LIGHT), 1 / 7)


# --- what each mesh has


@record
class ToothStiffness:
    """Of each mesh; a chain has none, and numbers that disturb nothing."""

    there: BoolArray  # (B,)
    b: Array  # (B,) in m
    c: Array  # (B,) c_γα,100 in Pa


@record
class Forces:
    """Of every strike through every mesh, in N; P points, B bodies, E events."""

    low: Array  # (P, on, by, E)
    high: Array  # (P, mesh, by, E)
    whip: Array  # (P, B)
    hardest: Array  # (P, B) strike of the branch, in m/s

    def at(self, point: int) -> "Forces":
        return Forces(self.low[point], self.high[point], self.whip[point], self.hardest[point])


@record
class Impacts:
    """What the strikes are to each mesh; P points, B bodies, each with the mesh that drives it.  Nothing strikes: 0."""

    speed: Array  # (P, B) the largest |u| on the body and all behind it, each at its own mesh, in m/s
    impacts: Array  # (P, B) strikes per working cycle of the orbit that holds it, those above 5 % of its hardest
    flanks: IndexArray  # (P, B) that they strike: 0, 1, 2
    power: Array  # (P, B) of its own body, in W
    low: Array  # (P, B) in N; low and high are 0 in a chain
    high: Array  # (P, B) in N
    share: Array  # (P, B) backlash of the path over half the driver's swing
    teeth: ToothStiffness
    forces: Forces


def impacts(motion: Motion, bodies: Bodies, of: Closed, strikes: Strikes, factor: Array | None = None) -> Impacts:
    """`factor` (B,): on the stiffness of each mesh, of a rim of another material."""
    hardest = strikes.hardest / bodies.ratio  # (P, B) in metres of the first driver

    # of the bodies from i on the fastest at its own mesh: struck by itself, or by one before it
    own = np.where(bodies.before, hardest[:, :, None], 0.0) * bodies.ratio  # (P, by, on)
    on = np.where(bodies.before, own.max(1)[:, None], -1.0)  # (P, i, on): those that are behind mesh i
    body = np.argmax(on, 2)
    orbit = np.take_along_axis(np.argmax(own, 1), body, 1)  # (P, i): of which body

    counts = strikes.speed > COUNTS_FROM * strikes.hardest[..., None]
    cycle = (motion.cycle / motion.omega)[:, None]
    number = np.divide(counts.sum(-1) * cycle, strikes.orbit, out=np.zeros(orbit.shape), where=strikes.orbit > 0)
    flanks = (counts & (strikes.flank > 0)).any(-1).astype(int) + (counts & (strikes.flank < 0)).any(-1)

    teeth = _teeth(bodies, factor)
    branch = _hardest_of_branch(bodies, strikes)
    with untraced():
        low, high = _low(bodies, of, strikes, teeth), _high(bodies, of, strikes, teeth)
        whip = _whip(bodies, of, branch, teeth) * teeth.there
    behind = bodies.lever * low.max((2, 3))[:, None]  # (P, i, on)
    return Impacts(
        speed=on.max(2),
        impacts=np.take_along_axis(number, orbit, 1),
        flanks=np.take_along_axis(flanks, orbit, 1),
        power=strikes.power,
        low=behind.max(2) * bodies.toothed,
        high=np.maximum(high.max((2, 3)) * bodies.toothed, whip),
        share=strikes.share,
        teeth=teeth,
        forces=Forces(low, high, whip, branch),
    )


def _teeth(bodies: Bodies, factor: Array | None) -> ToothStiffness:
    there = np.array(bodies.toothed)
    c = bodies.stiffness if factor is None else bodies.stiffness * factor
    return ToothStiffness(there, np.where(there, bodies.width, 1.0), np.where(there, c, 1.0))


def _high(bodies: Bodies, of: Closed, strikes: Strikes, teeth: ToothStiffness) -> Array:
    """(P, i, by, E) through the teeth of mesh i: the strikes of each body on its path or behind it, on the mass that is
    behind the farther one of both."""
    farther = np.where(bodies.before, of.mass * bodies.lever**2, of.mass[:, None])
    pairs = (bodies.before | bodies.before.T) & teeth.there[:, None]
    return _forces(bodies, strikes, pairs, farther, lambda F, i: stiffness_at(F, teeth.b[i], teeth.c[i]))


def _low(bodies: Bodies, of: Closed, strikes: Strikes, teeth: ToothStiffness) -> Array:
    """(P, on, by, E) through the teeth of the path to a body: the strikes of each body on it, on all that is behind.
    Every mesh of the path is as stiff as it is at the force in the last one."""
    rho = np.where(teeth.there[:, None], bodies.lever, 0.0).T  # (on, mesh): what is not on the path gives nothing

    def series(F: Array, on: IndexArray) -> Array:
        return np.asarray(path_stiffness(stiffness_at(F[:, None], teeth.b, teeth.c), rho[on]))

    M = np.broadcast_to(of.mass[:, None], bodies.before.shape)
    return _forces(bodies, strikes, bodies.before.T, M, series)


def _forces(
    bodies: Bodies,
    strikes: Strikes,
    pairs: BoolArray,
    M: Array,
    stiffness: Callable[[Array, IndexArray], Array],
) -> Array:
    """(P, B, B, E): the force of a strike of the second body of a pair on the mass M (B, B) in metres of the first."""
    u = np.where(pairs[..., None], strikes.speed[:, None] * (bodies.ratio[:, None] / bodies.ratio)[..., None], 0.0)
    forces = np.zeros(u.shape)
    point, first, second, event = there = np.nonzero(u > 0)
    ratio = bodies.ratio[first] / bodies.ratio[second]
    struck, speed, press = M[first, second], u[there], strikes.press[point, second, event] * ratio
    F = np.full(speed.shape, np.inf)  # as stiff as teeth can be
    for _ in range(PASSES + 1):
        F = strike_force(struck, press, stiffness(F, first), speed)
    forces[there] = F
    return forces


def _whip(bodies: Bodies, of: Closed, u: Array, teeth: ToothStiffness) -> Array:
    """(P, B): one wheel against its neighbour, by the hardest strike u of their branch.  None in a mesh of the first
    driver that parts of itself: its driver is not thrown back."""
    first = np.array(bodies.parent) < 0
    with np.errstate(invalid="ignore"):  # of the first driver, whose parent is none: not taken
        mu = np.where(first, bodies.mass, reduced_mass(bodies.mass, bodies.mass[list(bodies.parent)], bodies.rho))
    return np.where(first & of.parts, 0.0, whip_force(mu, u, teeth.b, teeth.c))


def _hardest_of_branch(bodies: Bodies, strikes: Strikes) -> Array:
    """(P, B): at each mesh, of the strikes of all bodies that hang on the same mesh of the first driver."""
    root = np.argmax(bodies.before, 0)  # parents stand before children
    alike = root[:, None] == root
    hardest: Array = np.where(alike, (strikes.hardest / bodies.ratio)[:, None], 0.0).max(2) * bodies.ratio
    return hardest


# --- the forces of one mesh, line by line


@record
class AtPoint:
    """All strikes of one operating point as forces, among which those of a mesh are sought."""

    bodies: Bodies
    of: Closed
    strikes: Strikes
    teeth: ToothStiffness
    forces: Forces


def at_point(bodies: Bodies, of: Closed, strikes: Strikes, hits: Impacts, point: int = 0) -> AtPoint:
    one = [point]
    return AtPoint(bodies.at(one), of.at(one), strikes.at(one), hits.teeth, hits.forces.at(point))


def forces_in(at: AtPoint, mesh: int, sources: Sequence[object] = ()) -> tuple[Newton, Newton]:
    """Low and high of one mesh, by the formulas, from the strikes that govern; all seen at this mesh.  (0, 0) where
    nothing strikes.  `sources`: what mass, speed and press of a strike stand on."""
    bodies, of, strikes, teeth, forces = at.bodies, at.of, at.strikes, at.teeth, at.forces
    low, high = forces.low * bodies.lever[mesh][:, None, None] * teeth.there[mesh], forces.high[mesh]
    whip, hardest = float(forces.whip[mesh]), float(forces.hardest[mesh])
    F_low = F_high = based_on(0.0, *sources)
    if (F := float(low.max())) > 0:
        on, by, event = (int(n) for n in np.unravel_index(np.argmax(low), low.shape))
        M, u, p = (based_on(x, *sources) for x in _seen(bodies, of, strikes, mesh, on, by, event))
        path = np.flatnonzero(bodies.before[:, on] & teeth.there)
        F_last = F / float(bodies.lever[mesh, on])
        with about(Text("all teeth of the path")):
            k = stiffness_at(F_last, teeth.b[path], teeth.c[path])
            F_low = strike_force(M, p, path_stiffness(k, bodies.ratio[mesh] / bodies.ratio[path]), u)
    b, c = float(teeth.b[mesh]), float(teeth.c[mesh])
    F = float(high.max())
    if F >= whip and F > 0:
        by, event = (int(n) for n in np.unravel_index(np.argmax(high), high.shape))
        on = by if bodies.before[mesh, by] else mesh
        M, u, p = (based_on(x, *sources) for x in _seen(bodies, of, strikes, mesh, on, by, event))
        with about(Text("the teeth of this mesh alone")):
            F_high = strike_force(M, p, stiffness_at(F, b, c), u)
    if whip > F:
        mu, driver = float(bodies.mass[mesh]), bodies.parent[mesh]
        with about(Text("a wheel against its neighbour")):
            if driver >= 0:
                mu = reduced_mass(mu, float(bodies.mass[driver]), float(bodies.rho[mesh]))
            F_high = whip_force(based_on(mu, *sources), based_on(hardest, *sources), b, c)
    return F_low, F_high


def _seen(
    bodies: Bodies, of: Closed, strikes: Strikes, mesh: int, on: int, by: int, event: int
) -> tuple[Kilogram, MetrePerSecond, MetrePerSecond2]:
    """M, u and p of a strike of one body on all that is behind another, at a mesh of their path."""
    ratio = bodies.ratio
    M = of.mass[on] * (ratio[on] / ratio[mesh]) ** 2
    u, p = (f[0, by, event] * ratio[mesh] / ratio[by] for f in (strikes.speed, strikes.press))
    return float(M), float(u), float(p)
