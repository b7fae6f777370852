# SPDX-License-Identifier: Apache-2.0
"""Aids to the design of mounts: the window of stiffness, mounts leaning towards each other, the symmetric four in closed form."""

import numpy as np

from ..sheet.arrays import Array, ComplexArray, each
from ..sheet.formula import formula
from ..sheet.functions import atan, pi, power, sqrt, tan
from ..sheet.record import record
from ..sheet.units import Hertz, Kilogram, KilogramMetre2, Metre, NewtonPerMetre, Number, Radian, RevPerSecond
from .excitation import strength
from .inputs import MountingInputs
from .mount_inputs import Mount

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


# --- two mounts that lean towards each other ---------------------------------------------------------------------------------
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
class Pair:
    """Two mounts that mirror each other in the vertical plane of the engine."""

    first: str
    second: str
    b: Metre
    L: Number
    h: Metre


def pairs(mounting: MountingInputs) -> tuple[Pair, ...]:
    """From the front to the flywheel; `h`: of the centre of gravity above them."""
    found = []
    mounts = sorted(mounting.mounts, key=lambda mount: mount.position[2])
    for i, one in enumerate(mounts):
        for other in mounts[i + 1 :]:
            if _mirrored(one, other):
                b, L = abs(one.position[1] - other.position[1]) / 2, one.stiffness[0] / one.stiffness[1]
                found.append(Pair(one.name, other.name, b, L, mounting.centre_of_gravity[0] - one.position[0]))
    return tuple(found)


def _mirrored(one: Mount, other: Mount) -> bool:
    (x, _, z), (x_2, _, z_2) = one.position, other.position
    if abs(x - x_2) > SAME or abs(z - z_2) > SAME or abs(one.position[1] - other.position[1]) < SAME:
        return False
    if any(abs(a - b) > SAME * a for a, b in zip(one.stiffness, other.stiffness)):
        return False
    (a, b, c), (d, e, f) = (mount.turned or (0.0, 0.0, 0.0) for mount in (one, other))
    return abs(a + d) < EVEN and abs(b - e) < EVEN and abs(c + f) < EVEN


# --- the symmetric four --------------------------------------------------------------------------------------------------------
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
def four_coupled(k: NewtonPerMetre, k_x: NewtonPerMetre, h: Metre, a: Metre, m: Kilogram, J: KilogramMetre2) -> Hertz:
    """Lateral with roll (a = b), fore and aft with pitch (a = c)."""
    K = np.array([[4 * k, 4 * k * h], [4 * k * h, 4 * (k * h**2 + k_x * a**2)]])
    root = np.sqrt(np.array([m, J]))
    found: Array = np.sqrt(np.linalg.eigvalsh(K / np.outer(root, root))) / (2 * np.pi)
    return each(found)


# --- excitation ----------------------------------------------------------------------------------------------------------------
def lowest_order(orders: Array, wrench: ComplexArray, rho: float) -> float | None:
    """The lowest order that counts, of the wrench about the centre of gravity (orders, 6); None where nothing drives the engine."""
    sizes = strength(wrench[:, :3], wrench[:, 3:], rho)
    counts = np.flatnonzero(sizes > NOTICED * sizes.max(initial=0.0))
    return float(orders[counts[0]]) if counts.size else None
