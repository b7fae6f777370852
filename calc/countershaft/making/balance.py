# SPDX-License-Identifier: Apache-2.0
"""Calibration holes: what radial holes drilled into the eccentric masses take off the shaft's couple.

Drilling only takes away, so a shaft that is to be calibrated is made stronger than it has to be, by half of what drilling can take.
The hole is a cylinder from the outer radius inwards: the drill's cone, and the curve of the surface over the hole (d²/(32·R) of its depth
in the mean), are left out.
"""

import math

from ...sheet.arrays import Array, each
from ...sheet.check import Check, check
from ...sheet.formula import formula
from ...sheet.functions import modulus, pi, total
from ...sheet.quantity import result, value
from ...sheet.remedy import by_key, down
from ...sheet.text import Text
from ...sheet.trace import about
from ...sheet.units import Kilogram, KilogramMetre, KilogramPerMetre3, Metre, NewtonMetre, Number, Radian, RadPerSecond
from ..inputs import Holes

HOLES = Text("geometry, calibration holes in the eccentric masses (Finotti 2013, 4.1)")


@result
class HolesResult:
    """What one hole takes away, and all of them at full depth together."""

    hole_mass: Kilogram = value("Mass removed by one calibration hole", "g", "m_c")
    hole_centroid_radius: Metre = value("Radius of its centre of gravity", "mm", "e_c")
    hole_unbalance: KilogramMetre = value("Unbalance removed by one hole", "g·mm", "ΔU")
    hole_couple: NewtonMetre = value("Couple removed by one hole", "N·m", "ΔC")
    hole_unbalance_of_mass: KilogramMetre = value("Unbalance that drilling can take off each mass", "g·mm", "ΔU_m")
    hole_range: NewtonMetre = value("Couple that all holes together can take", "N·m", "ΔC_c")
    hole_range_share: Number | None = value("its share of the required couple", "%", "q_c", default=None)
    hole_overdesign: Number | None = value("Couple beyond the required one that drilling needs", "%", "x_c", default=None)


@formula("m_c", Text("{holes}: a cylinder of the drill's diameter", holes=HOLES), unit="g")
def hole_mass(rho: KilogramPerMetre3, d_c: Metre, h_c: Metre) -> Kilogram:
    """>>> hole_mass(rho=7860, d_c=0.014, h_c=0.02)
    0.02419905...
    """
    return rho * pi * d_c**2 / 4 * h_c


@formula("e_c", Text("{holes}: middle of the depth, from the outer radius", holes=HOLES), unit="mm")
def hole_centroid_radius(R: Metre, h_c: Metre) -> Metre:
    return R - h_c / 2


@formula("ΔU", Text("{holes}: unbalance taken away", holes=HOLES), unit="g·mm")
def hole_unbalance(m_c: Kilogram, e_c: Metre) -> KilogramMetre:
    return m_c * e_c


@formula("z_m", "mathematics: mean distance of the eccentric masses from mid-shaft", unit="mm", names={"n": "n_h"})
def mean_arm(z: Metre, n: Number) -> Metre:
    return total(modulus(z)) / n


@formula("ΔC", "dynamics: couple of a hole's unbalance at the mean arm of the masses", names={"U": "ΔU", "omega": "ω_S"})
def hole_couple(U: KilogramMetre, z_m: Metre, omega: RadPerSecond) -> NewtonMetre:
    return U * z_m * omega**2


@formula("ΔU_m", "rule of this program: the holes are shared evenly by the n eccentric masses", unit="g·mm", names={"U": "ΔU", "n": "n_h"})
def unbalance_of_mass(N_c: Number, U: KilogramMetre, n: Number) -> KilogramMetre:
    return N_c / n * U


@formula("ΔC_c", "mathematics: all holes at full depth", names={"C": "ΔC"})
def hole_range(N_c: Number, C: NewtonMetre) -> NewtonMetre:
    return N_c * C


@formula("q_c", "definition: range of the holes over the required couple", unit="%", names={"C_c": "ΔC_c"})
def range_share(C_c: NewtonMetre, C_S: NewtonMetre) -> Number:
    return C_c / C_S


@formula("x_c", "rule of this program: half of the range, so that drilling reaches as far below as above", unit="%", names={"q": "q_c"})
def needed_overdesign(q: Number) -> Number:
    return q / 2


def calibration(holes: Holes, rho: KilogramPerMetre3, R_outer: Metre, z: Array, omega: RadPerSecond,
    C_required: NewtonMetre) -> HolesResult:  # fmt: skip
    """What the holes take from masses at `z`, of outer radius `R_outer`, on a shaft that turns at `omega`.

    `C_required`: modulus of the couple that the shaft must supply; 0 leaves the shares out.
    """
    n = float(z.size)
    with about(Text("calibration holes")):
        m_c = hole_mass(rho=rho, d_c=holes.diameter, h_c=holes.depth)
        e_c = hole_centroid_radius(R=R_outer, h_c=holes.depth)
        unbalance = hole_unbalance(m_c=m_c, e_c=e_c)
        couple = hole_couple(U=unbalance, z_m=mean_arm(z=each(z), n=n), omega=omega)
        whole = hole_range(N_c=holes.count, C=couple)
        share = range_share(C_c=whole, C_S=C_required) if C_required else None
        return HolesResult(hole_mass=m_c, hole_centroid_radius=e_c, hole_unbalance=unbalance, hole_couple=couple,
            hole_unbalance_of_mass=unbalance_of_mass(N_c=holes.count, U=unbalance, n=n), hole_range=whole, hole_range_share=share,
            hole_overdesign=needed_overdesign(q=share) if share is not None else None)  # fmt: skip


def depth_check(holes: Holes, R_outer: Metre, core_radius: Metre) -> Check:
    """The holes must end in the sectors: one that is deeper weakens the core, which alone carries the shaft between them."""
    return check("countershaft.holes.depth", Text("Depth of the calibration holes"), holes.depth, "<=", R_outer - core_radius, "mm",
        Text("geometry: height of the sectors over the core"), Text("More or wider holes take the rest."),
        remedies=by_key(Holes, "countershaft.holes.depth_mm", down(R_outer - core_radius), bound="<="))  # fmt: skip


def row_check(holes: Holes, masses: int, length: Metre) -> Check:
    """The holes of a mass stand in a row along the shaft, side by side; `length` of the shortest sector."""
    return check("countershaft.holes.row", Text("Length of the holes of a mass, side by side"),
        math.ceil(holes.count / masses) * holes.diameter, "<=", length, "mm",
        Text("rule of this program: holes stand in one row along the sector"), Text("Fewer or narrower holes."))  # fmt: skip


def width_check(holes: Holes, R_outer: Metre, half_angle: Radian) -> Check:
    """A hole must not break out of the sides of its sector; `half_angle` of the narrowest one."""
    chord = 2 * max(R_outer - holes.depth, 0.0) * math.sin(min(half_angle, math.pi / 2))
    return check("countershaft.holes.width", Text("Diameter of a hole in the width of its sector"), holes.diameter, "<=", chord, "mm",
        Text("geometry: width of the sector at the bottom of the hole"), Text("Shorter holes have more room as well."),
        remedies=by_key(Holes, "countershaft.holes.diameter_mm", down(chord), bound="<="))  # fmt: skip
