# SPDX-License-Identifier: Apache-2.0
"""What is published of the modes, and aids to the design of mounts.

Aids: the window of stiffness, mounts leaning towards each other, the symmetric four in closed form.  Of the modes:
frequencies, energies, the torque roll axis, the window of stiffness, mounts that could lean."""

import math

import numpy as np

from ..sheet.arrays import Array, ComplexArray
from ..sheet.formula import formula
from ..sheet.functions import atan, pi, power, sqrt, tan
from ..sheet.linked_array import elements
from ..sheet.quantity import Stated
from ..sheet.record import record
from ..sheet.text import Text
from ..sheet.units import Hertz, Hertzes, Kilogram, KilogramMetre2, Metre, NewtonPerMetre, Number, Radian, RevPerSecond
from ..sheet.value import based_on, link_of, linked
from . import body, modes
from .body import DOFS
from .excitation import strength
from .inputs import DOF_WORDS, Mount, MountingInputs
from .modes import Modes
from .result import Ceiling, Focal, Mode, RollAxis, Tree, Window, described
from .system import System
from .wrenches import EngineWrenches

# --- aids: the window of stiffness

NOTICED = 0.01  # of the strongest order: weaker ones are no excitation
SAME = 1e-6  # m, or of a stiffness: mounts that mirror each other
EVEN = 1e-6  # rad


@formula("s_low", "dynamics: frequencies grow as the root of a stiffness; no mode below the road's")
def lowest_factor(f_road: Hertz, f_min: Hertz) -> Number:
    return power(f_road / f_min, 2)


@formula("s_high", "dynamics: isolation begins √2 above the highest mode")
def highest_factor(f_exc: Hertz, f_max: Hertz) -> Number:
    return power(f_exc / (sqrt(2.0) * f_max), 2)


@formula("f_max/f_min", "definition: spread of the six modes")
def spread(f_max: Hertz, f_min: Hertz) -> Number:
    return f_max / f_min


@formula("n", "definition: speed at which an order meets a mode", unit="rpm")
def critical_speed(f: Hertz, i: Number) -> RevPerSecond:
    return f / i


@formula("f_exc", "definition: frequency of an order", unit="Hz")
def excitation_frequency(i: Number, n: RevPerSecond) -> Hertz:
    return i * n


# --- two mounts that lean towards each other

FOCAL = "geometry of two inclined mounts, elastic centre: lateral force that turns nothing (recomputed)"


@formula("a", FOCAL)
def elastic_centre(b: Metre, L: Number, phi: Radian) -> Metre:
    """Above the plane of the mounts; `L` compression over shear stiffness, `phi` from up, inwards."""
    return b * (L - 1) * tan(phi) / (1 + L * tan(phi) ** 2)


@formula("a_max", FOCAL, unit="mm")
def focal_reach(b: Metre, L: Number) -> Metre:
    return b * (L - 1) / (2 * sqrt(L))


@formula("φ", FOCAL)
def focal_angle(b: Metre, L: Number, h: Metre) -> Radian:
    """The smaller of two angles at which the elastic centre stands at the height h."""
    return atan((b * (L - 1) - sqrt(b**2 * (L - 1) ** 2 - 4 * h**2 * L)) / (2 * h * L))


@record
class MountPair:
    """Two mounts that mirror each other in the vertical plane of the engine."""

    first: str
    second: str
    b: Metre
    L: Number
    h: Metre


def mount_pairs(mounting: MountingInputs) -> tuple[MountPair, ...]:
    """From the front to the flywheel, of each the mount on the side below zero first; `h`: of the centre of gravity
    above them."""
    pairs = []
    mounts = sorted(mounting.mounts, key=lambda mount: mount.position[::-1])
    for i, first in enumerate(mounts):
        for other in mounts[i + 1 :]:
            if _mirrored(first, other):
                b, L = abs(first.position[1] - other.position[1]) / 2, first.stiffness[0] / first.stiffness[1]
                pairs.append(MountPair(first.name, other.name, b, L, mounting.centre_of_gravity[0] - first.position[0]))
    return tuple(pairs)


def _mirrored(first: Mount, other: Mount) -> bool:
    (x, _, z), (x_2, _, z_2) = first.position, other.position
    if abs(x - x_2) > SAME or abs(z - z_2) > SAME or abs(first.position[1] - other.position[1]) < SAME:
        return False
    if any(abs(a - b) > SAME * a for a, b in zip(first.stiffness, other.stiffness)):
        return False
    (a, b, c), (d, e, f) = (mount.turned or (0.0, 0.0, 0.0) for mount in (first, other))
    return abs(a + d) < EVEN and abs(b - e) < EVEN and abs(c + f) < EVEN


# --- the symmetric four


@formula("f_bounce", "Harris, Shock and vibration handbook, ch. 3: four upright mounts", unit="Hz")
def four_bounce(k_x: NewtonPerMetre, m: Kilogram) -> Hertz:
    return sqrt(4 * k_x / m) / (2 * pi)


@formula("f_yaw", "Harris, Shock and vibration handbook, ch. 3: four upright mounts", unit="Hz")
def four_yaw(k_y: NewtonPerMetre, c: Metre, k_z: NewtonPerMetre, b: Metre, J_x: KilogramMetre2) -> Hertz:
    return sqrt(4 * (k_y * c**2 + k_z * b**2) / J_x) / (2 * pi)


@formula(
    "f_1, f_2",
    "Harris, Shock and vibration handbook, ch. 3: four upright mounts below the centre of gravity",
    unit="Hz",
    shows="√λ/2π of [[4·k, 4·k·h], [4·k·h, 4·(k·h² + k_x·a²)]] on diag(m, J)",
)
def four_coupled(k: NewtonPerMetre, k_x: NewtonPerMetre, h: Metre, a: Metre, m: Kilogram, J: KilogramMetre2) -> Hertzes:
    """Lateral with roll (a = b), fore and aft with pitch (a = c)."""
    K = np.array([[4 * k, 4 * k * h], [4 * k * h, 4 * (k * h**2 + k_x * a**2)]])
    root = np.sqrt(np.array([m, J]))
    coupled: Array = np.sqrt(np.linalg.eigvalsh(K / np.outer(root, root))) / (2 * np.pi)
    return coupled


# --- excitation


def lowest_order(orders: Array, wrench: ComplexArray, rho: float) -> float | None:
    """The lowest order that counts, of the wrench about the centre of gravity (orders, 6); None where nothing drives
    the engine."""
    sizes = strength(wrench[:, :3], wrench[:, 3:], rho)
    counts = np.flatnonzero(sizes > NOTICED * sizes.max(initial=0.0))
    return float(orders[counts[0]]) if counts.size else None


# --- what is published of the modes


@record
class Matrices:
    """Of the engine on rigid ground: stiffness at rest, its loss, masses; and the modes that they have."""

    K: Array
    K_loss: Array
    M: Array
    J: Array
    found: Modes
    energies: list[list[float]]  # by coordinate and mode


def matrices(mounting: MountingInputs, free: System, J: Array) -> Matrices:
    """Raises NoSolution where the mounts leave the engine a motion."""
    mounts = mounting.mounts
    B, R = based_on(free.between, mounting.centre_of_gravity), free.axes
    k, loss = (np.stack([of(mount) for mount in mounts]) for of in (body.real_at_rest, body.loss_at_rest))
    K = modes.stiffness_matrix(k=based_on(k, mounts), B=B, R=R)
    K_loss = modes.stiffness_matrix(k=based_on(loss, mounts), B=B, R=R)
    M = body.mass_matrix(m=mounting.mass, J=J)
    solved = modes.modes(K, M)
    phi = modes.shapes(K=K, M=M)
    p = based_on(np.asarray(M) @ np.asarray(phi), phi, M)
    E = [[modes.energy(phi=_of(phi, j, i), p=_of(p, j, i)) for i in range(6)] for j in range(6)]
    return Matrices(K, K_loss, M, J, solved, E)


def of_modes(m: Matrices) -> dict[str, Mode]:
    """Mode by mode, slowest first."""
    squares = elements(modes.eigenvalues(K=m.K, M=m.M))
    losses = elements(modes.mode_loss(K_loss=m.K_loss, K=m.K, M=m.M))
    by_mode = {}
    for i in range(6):
        share = {dof: Stated(described(SHARE[dof], "%", "E"), m.energies[j][i]) for j, dof in enumerate(DOFS)}
        f = modes.frequency(omega2=squares[i])
        by_mode[f"mode_{i + 1}"] = Mode(frequency=f, loss_factor=losses[i], share=share)
    return by_mode


SHARE = {dof: Text("Energy of the mode in {dof}", dof=words) for dof, words in DOF_WORDS.items()}
NAMED = {dof: Text("Frequency of the mode named {dof}", dof=words) for dof, words in DOF_WORDS.items()}
HEADLINES = {"roll": 1, "bounce": 2}  # what stands for the step
PURE = {dof: Text("Energy of the mode named {dof} in it", dof=words) for dof, words in DOF_WORDS.items()}


def _of(x: Array, *place: int) -> float:
    """One number of an array, with the array's link."""
    return linked(float(np.asarray(x)[place]), link_of(x))


def frequencies(m: Matrices, mode_values: dict[str, Mode]) -> dict[str, Stated]:
    """By the coordinate that a mode is named after, which is not its number."""
    named = {}
    for i, dof in enumerate(DOFS):
        about = described(NAMED[dof], "Hz", "f", short=True, headline=HEADLINES.get(dof, 0))
        named[dof] = Stated(about, mode_values[f"mode_{m.found.of[i] + 1}"].frequency)
    return named


def energies(m: Matrices) -> dict[str, Stated]:
    return {dof: Stated(described(PURE[dof], "%", "E"), m.energies[i][m.found.of[i]]) for i, dof in enumerate(DOFS)}


def roll_axis(m: Matrices) -> RollAxis:
    e_T, shares = body.roll_axis(J=m.J), modes.roll_shares(K=m.K, M=m.M)
    along = {
        axis: Stated(described(Text("Torque roll axis along {axis}", axis=axis), "", "e_T"), _of(e_T, i))
        for i, axis in enumerate("xyz")
    }
    decoupling = _of(shares, int(np.argmax(np.asarray(shares))))
    return RollAxis(angle=body.roll_axis_angle(e_T=e_T), decoupling=decoupling, direction=along)


def with_chassis(whole: System) -> Tree:
    """The frequencies of engine and frame together, slowest first."""
    omega = np.array([2 * math.pi * body.REFERENCE])
    frequencies = modes.of_whole(whole.stiffness(whole.mount_stiffness(omega)[1], omega)[0], whole.M)
    about = described(Text("Frequency of engine and frame together"), "Hz", "f")
    return {
        f"mode_{i}": {"frequency": Stated(about, based_on(float(f), whole.source))}
        for i, f in enumerate(frequencies, 1)
    }


def window(mounting: MountingInputs, driven: EngineWrenches, m: Matrices, mode_values: dict[str, Mode]) -> Window:
    f_min, f_max = mode_values["mode_1"].frequency, mode_values["mode_6"].frequency
    ceilings = {}
    speeds = np.array([float(mounting.idle_speed)])
    wrench = driven.wrench(speeds, driven.torque(speeds))[0]
    rho = body.radius_of_gyration(float(mounting.mass), m.J)
    for name in ("half", "shaft"):
        if name not in driven.variants:
            continue
        order = lowest_order(driven.orders, np.asarray(wrench[:, driven.variants.index(name)]), rho)
        if order is not None:
            n = based_on(order, wrench)
            f_exc = excitation_frequency(i=n, n=mounting.idle_speed)
            ceilings[name] = Ceiling(highest_factor=highest_factor(f_exc=f_exc, f_max=f_max), lowest_order=n)
    return Window(
        lowest_factor=lowest_factor(f_road=mounting.road_frequency, f_min=f_min),
        spread=spread(f_max=f_max, f_min=f_min),
        **ceilings,
    )


def focal(mounting: MountingInputs) -> Tree | None:
    """Of the pair at the front under `focal` itself; of several each by its first mount as well."""
    tree: Tree = {}
    pairs = mount_pairs(mounting)
    for i, pair in enumerate(pairs):
        of = (mounting.mounts, mounting.centre_of_gravity)
        b, L, h = (based_on(x, of) for x in (pair.b, pair.L, pair.h))
        reach = focal_reach(b=b, L=L)
        leans = L > 1 and 0 < h <= reach
        focus = Focal(angle=focal_angle(b=b, L=L, h=h) if leans else None, reach=reach)
        if i == 0:
            tree["reach"] = Stated(described(REACH, "mm", "a_max"), focus.reach)
            if focus.angle is not None:
                tree["angle"] = Stated(described(LEAN, "°", "φ"), focus.angle)
        if len(pairs) > 1:
            tree[pair.first] = focus
    return tree or None


LEAN = Text("Inclination of the front pair that decouples roll from lateral")
REACH = Text("Highest elastic centre that an inclination of the front pair gives")
