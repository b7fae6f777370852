# SPDX-License-Identifier: Apache-2.0
"""What the bending of the shaft is computed from, and what comes out: stiffness, load, slope, frequency, stress.

All formulas take arrays, an element for each piece; faces at z, bearings at z_B.  θ is the rotation of the section,
that of the journal."""

import numpy as np

from ...sheet.arrays import Array, BoolArray, ComplexArray
from ...sheet.formula import formula
from ...sheet.functions import cos, largest, modulus, pi, sin, smallest, sqrt, total
from ...sheet.text import Text
from ...sheet.units import (
    KilogramMetre,
    KilogramMetres,
    KilogramPerMetre,
    KilogramPerMetre3,
    Kilograms,
    KilogramsPerMetre,
    Metre,
    Metre4,
    Metres,
    Metres4,
    MetreTuple,
    Newton,
    NewtonMetre,
    NewtonMetre2,
    NewtonMetres,
    NewtonMetres2,
    NewtonPerMetre,
    Newtons,
    NewtonsPerMetre,
    Number,
    Pascal,
    PerMetre,
    PhasorCubicMetre,
    PhasorMetre,
    PhasorMetres,
    PhasorNewtonPerMetre,
    PhasorNewtons,
    PhasorNewtonsPerMetre,
    PhasorRadians,
    Radian,
    Radians,
    RadiansPerMetre,
    RadPerSecond,
    RevPerSecond,
    SquareMetre,
)
from . import beam as b
from .beam import Beam, Bent

FINITE = Text("elasticity, stepped beam of Timoshenko elements, exact in statics; journals on pins at their middles")
TURNING = Text("(stiffness − ω_S²·masses)·u = f, f from q and F, w = 0 at the journals")
NOISE = 1e-9  # of the largest slope: what the sums leave at the middle journal of a symmetric shaft


# --- the section


@formula("G", "elasticity, isotropic", unit="GPa", meanings={"E": "Modulus of elasticity", "nu": "Poisson's ratio"})
def shear_modulus(E: Pascal, nu: Number) -> Pascal:
    return E / (2 * (1 + nu))


@formula(
    "κ_s",
    "Cowper 1966, The shear coefficient in Timoshenko's beam theory: shear coefficient of the circular section",
    meanings={"nu": "Poisson's ratio"},
)
def shear_coefficient(nu: Number) -> Number:
    """Used for the sectors too: shear gives a small part of the deflection there."""
    return 6 * (1 + nu) / (7 + 6 * nu)


@formula(
    "S_s",
    "elasticity, Timoshenko's beam: shear stiffness of the whole section",
    names={"kappa": "κ_s"},
    meanings={"A": "Area of the section"},
)
def shear_stiffness(kappa: Number, G: Pascal, A: SquareMetre) -> Newton:
    return kappa * G * A


@formula(
    "B",
    "elasticity: bending stiffness of the section",
    meanings={"E": "Modulus of elasticity", "I": "Second moment of the section"},
)
def bending_stiffness(E: Pascal, I: Metre4) -> NewtonMetre2:
    return E * I


@formula(
    "I_0",
    "geometry: second moment of the core alone, which a sector of no effect leaves; of a full section all of it",
    unit="mm⁴",
    shows="π·r_0⁴/4 of a sector, I of a full section",
)
def core_inertia(I: Metres4, r_0: Metres, sector: BoolArray) -> Metres4:
    return np.where(sector, pi * r_0**4 / 4, I)


@formula(
    "I_η",
    "rule of this program: second moment of area; the core bends whole, and the sector lends a share of what it adds "
    "to the core",
    unit="mm⁴",
    meanings={"I": "Second moment of the section"},
)
def shared_inertia(I_0: Metre4, eta: Number, I: Metre4) -> Metre4:
    """Mass and shear stiffness stay those of the whole section."""
    return I_0 + eta * (I - I_0)


@formula(
    "I_side",
    "geometry: second moment of sector and core, bending across the plane of symmetry",
    unit="mm⁴",
    meanings={"R": "Radius of the cylinder", "gamma": "Half of the sector's angle"},
)
def sideways_inertia(R: Metre, r_0: Metre, gamma: Radian) -> Metre4:
    return (R**4 - r_0**4) / 4 * (gamma - sin(gamma) * cos(gamma)) + pi * r_0**4 / 4


@formula(
    "I_min",
    "geometry, the weaker plane of the section: below a half-angle of about 60° that across the plane of symmetry",
    unit="mm⁴",
    meanings={"I": "Second moment of the section"},
)
def weaker_inertia(I: Metre4, I_side: Metre4) -> Metre4:
    return smallest(I, I_side)


@formula(
    "c",
    "geometry: distance of the farthest fibre from the centre of sector and core, in the plane of symmetry",
    unit="mm",
    names={"y": "ȳ"},
)
def farthest_fibre(R: Metre, y: Metre, r_0: Metre, gamma: Radian) -> Metre:
    """Outer edge, the core's back, or the edge of a sector of more than half a turn."""
    return largest(R - y, y + largest(r_0, -R * cos(gamma)))


# --- mass and load


@formula(
    "ρ_l", "geometry: mass per length of the whole section", meanings={"rho": "Density", "A": "Area of the section"}
)
def line_mass(rho: KilogramPerMetre3, A: SquareMetre) -> KilogramPerMetre:
    return rho * A


@formula(
    "J_l",
    "dynamics: rotary inertia per length of a section that tilts as it bends (Rayleigh; Timoshenko's beam)",
    meanings={"rho": "Density", "I": "Second moment of the section"},
)
def rotary_inertia(rho: KilogramPerMetre3, I: Metre4) -> KilogramMetre:
    return rho * I


@formula(
    "J_l",
    "dynamics: rotary inertia per length, the part of the sectors by their own density; rule of this program: about "
    "the centre of the section",
    names={"nu": "ν_ρ"},
)
def heavier_rotary_inertia(rho: KilogramPerMetre3, I: Metres4, I_0: Metres4, nu: Number) -> KilogramMetres:
    """ν: density of the sectors over that of the core, whose second moment is I_0."""
    return rho * (I_0 + nu * (I - I_0))


@formula(
    "q",
    "dynamics: centrifugal load per length of what is eccentric",
    names={"omega": "ω_S"},
    meanings={"rho": "Density", "S": "Static moment of the sectors, as a vector"},
)
def line_load(omega: RadPerSecond, rho: KilogramPerMetre3, S: PhasorCubicMetre) -> PhasorNewtonPerMetre:
    return omega**2 * rho * S


@formula(
    "θ",
    FINITE,
    shows=Text("|θ| at each journal from {turning}", turning=TURNING),
    unit="mrad",
    names={"mu": "ρ_l", "omega": "ω_S"},
)
def slopes(
    EI: NewtonMetres2,
    S_s: Newtons,
    mu: KilogramsPerMetre,
    q: PhasorNewtonsPerMetre,
    F: PhasorNewtons,
    m: Kilograms,
    omega: RadPerSecond,
    z: Metres,
    z_B: MetreTuple,
    u: Bent,
) -> Radians:
    """`u` is the solution for the other arguments, from which the moments are taken too."""
    theta = np.abs(u.slopes)
    return np.where(theta > NOISE * theta.max(initial=0.0), theta, 0.0)


@formula(
    "R_i",
    Text("{finite}: forces of the supports on the shaft", finite=FINITE),
    shows=Text("R_i from {turning}", turning=TURNING),
    names={"mu": "ρ_l", "omega": "ω_S"},
)
def reactions(
    EI: NewtonMetres2,
    S_s: Newtons,
    mu: KilogramsPerMetre,
    q: PhasorNewtonsPerMetre,
    F: PhasorNewtons,
    m: Kilograms,
    omega: RadPerSecond,
    z: Metres,
    z_B: MetreTuple,
    u: Bent,
) -> PhasorNewtons:
    """They hold the load and what the masses add as they move outwards: 1/(1 − (ω_S/ω_n)²) of it in a mode."""
    return u.reactions


@formula(
    "f_1",
    Text("{finite}; with rotary inertia, without gyroscopic effect", finite=FINITE),
    shows="lowest root of |K − (2π·f)²·M| = 0, M of ρ_l, j and m, subspace iteration",
    names={"mu": "ρ_l"},
)
def natural_frequency(
    EI: NewtonMetres2,
    S_s: Newtons,
    mu: KilogramsPerMetre,
    j: KilogramMetres,
    m: Kilograms,
    z: Metres,
    z_B: MetreTuple,
    model: Beam,
) -> RevPerSecond:
    """The lowest natural frequency of bending in the weaker plane; `model` is made of the other arguments."""
    return b.natural_frequency(model) / (2 * pi)


@formula(
    "f_1",
    Text("{finite}; without rotary inertia", finite=FINITE),
    shows="the same root, M of ρ_l and m alone",
    names={"mu": "ρ_l"},
)
def natural_frequency_without_rotary(
    EI: NewtonMetres2, S_s: Newtons, mu: KilogramsPerMetre, m: Kilograms, z: Metres, z_B: MetreTuple, model: Beam
) -> RevPerSecond:
    """To compare with beams that leave it out."""
    return b.natural_frequency(model) / (2 * pi)


@formula(
    "K_f",
    "rule of this program: of the film's two direct stiffnesses the softer; the cross ones are left out",
)
def film_stiffness(K_xx: NewtonPerMetre, K_yy: NewtonPerMetre) -> NewtonPerMetre:
    """In the frame of the shaft its load and its films stand still: it leaves its place first where they hold least."""
    return smallest(K_xx, K_yy)


@formula("K_B", "statics: springs in series, film and housing")
def in_series(K_f: NewtonPerMetre, K_H: NewtonPerMetre) -> NewtonPerMetre:
    """>>> in_series(K_f=3e8, K_H=6e8)
    200000000.0
    """
    return K_f * K_H / (K_f + K_H)


@formula(
    "f_1",
    "elasticity, stepped beam of Timoshenko elements: lowest frequency on springs; with rotary inertia, without "
    "gyroscopic effect",
    shows="lowest root of |K + K_B − (2π·f)²·M| = 0, M of ρ_l, j and m, subspace iteration",
    names={"mu": "ρ_l"},
)
def natural_frequency_on_springs(
    EI: NewtonMetres2,
    S_s: Newtons,
    mu: KilogramsPerMetre,
    j: KilogramMetres,
    m: Kilograms,
    z: Metres,
    z_B: MetreTuple,
    K_B: NewtonsPerMetre,
    model: Beam,
) -> RevPerSecond:
    """The lowest natural frequency, tilting and bouncing in its bearings included; `model` is made of the other
    arguments."""
    return b.natural_frequency(model) / (2 * pi)


@formula(
    "M_max",
    FINITE,
    shows=Text("largest |M| along the shaft, M = −E·I·θ' from {turning}", turning=TURNING),
    names={"mu": "ρ_l", "omega": "ω_S"},
)
def largest_moment(
    EI: NewtonMetres2,
    S_s: Newtons,
    mu: KilogramsPerMetre,
    q: PhasorNewtonsPerMetre,
    F: PhasorNewtons,
    m: Kilograms,
    omega: RadPerSecond,
    z: Metres,
    z_B: MetreTuple,
    u: Bent,
) -> NewtonMetre:
    return float(np.abs(u.moment).max())


@formula("z_M", FINITE, shows="where |M| is largest", unit="mm")
def moment_place(u: Bent) -> Metre:
    return float(u.moment_z[np.abs(u.moment).argmax()])


@formula(
    "M_s",
    "statics: moment of the forces on one side of a section, without what bending adds to them while the shaft turns",
    meanings={"F": "Forces on one side of the section", "z": "Places of the forces", "z_s": "Place of the section"},
)
def moment_by_statics(F: PhasorNewtons, z: Metres, z_s: Metre) -> NewtonMetre:
    """>>> round(moment_by_statics(F=np.array([1715.0 + 0j]), z=np.array([0.1675]), z_s=0.1518), 2)
    26.93
    """
    return modulus(total(F * (z - z_s)))


@formula(
    "M",
    FINITE,
    shows=Text("largest |M| on each piece, from {turning}; M_s where the stress is largest", turning=TURNING),
)
def piece_moments(z_1: Metres, z_2: Metres, u: Bent, M_s: NewtonMetre) -> NewtonMetres:
    """The pieces reach from z_1 to z_2; `M_s` stands beside, found on another way."""
    ends = np.stack([z_1, z_2], 1)
    at_ends = np.abs(u.moment_at(ends)).max(1)
    size = np.abs(u.moment)
    within = (u.moment_z[None, :] >= ends[:, :1]) & (u.moment_z[None, :] <= ends[:, 1:])
    moments: Array = np.maximum(at_ends, np.where(within, size[None, :], 0.0).max(1))
    return moments


@formula("M_h", FINITE, shows="|M| at the shoulder; by statics M_s")
def shoulder_moment(z: Metre, u: Bent, M_s: NewtonMetre) -> NewtonMetre:
    """`M_s` stands beside, found on another way."""
    return float(abs(u.moment_at(np.asarray(z))))


@formula(
    "σ",
    "elasticity, elementary bending, nominal: farthest fibre of the whole section",
    unit="MPa",
    meanings={"c": "Distance of the farthest fibre", "I": "Second moment of the section"},
)
def bending_stress(M: NewtonMetre, c: Metre, I: Metre4) -> Pascal:
    return M * c / I


@formula(
    "η_lim",
    "mathematics: where the largest slope of a journal reaches its limit",
    shows="the root of max θ(η) = θ_lim, secant of 1/θ",
    names={"mu": "ρ_l", "omega": "ω_S"},
)
def limiting_share(
    theta_lim: Radian,
    E: Pascal,
    I_0: Metres4,
    I: Metres4,
    S_s: Newtons,
    mu: KilogramsPerMetre,
    q: PhasorNewtonsPerMetre,
    F: PhasorNewtons,
    m: Kilograms,
    omega: RadPerSecond,
    z: Metres,
    z_B: MetreTuple,
    eta: Number,
) -> Number:
    """`eta` is the root itself, found from the other arguments."""
    return eta


@formula("a", "geometry: way of the journal's edge by its slope", unit="µm")
def edge_displacement(theta: Radian, l: Metre) -> Metre:
    return theta * l / 2


# --- on supports that give way
# x: displacement of each journal, complex, in the frame of the shaft; θ₀, Θ, K_c, f_c: the shaft seen from its supports

CENTRED: Metre = 1e-9  # a journal that is displaced by less has no direction
SHARED = Text("statics: the shaft bends between supports that give way, K_c·x + P(x) = f_c")
MEAN_TANGENT = Text(
    "statics: a force that stands goes round in the frame of the shaft, and meets the mean of both tangents"
)
BOUND = Text("statics, a bound: nothing is known of the directions, so that all add up")


@formula(
    "P",
    SHARED,
    shows="P of each support where K_c·x + P(x) = f_c, Newton's method; P(x) the law of each support",
    meanings={"return": "Loads of the supports"},
)
def shared_load(K_c: NewtonsPerMetre, f_c: PhasorNewtons, x: PhasorMetres, P: PhasorNewtons) -> PhasorNewtons:
    """The loads of the supports, in the frame of the shaft.  `P` is found from the others and the laws."""
    return P


@formula("x", "geometry: the journal lags its load by the attitude angle", shows="e·e^{−i·φ}·P/|P|")
def displaced(P: PhasorNewtons, e: Metres, phi: Radians) -> PhasorMetres:
    """Of journals whose loads are known; e of each, φ below zero where the shaft turns against the crank."""
    size = np.abs(P)
    x: ComplexArray = e * np.exp(-1j * phi) * P / np.where(size > 0, size, 1.0)
    return x


@formula("θ", "statics: slopes on rigid supports, and what the displaced journals add", shows="θ_0 + Θ·x")
def tilted(theta_0: PhasorRadians, Theta: RadiansPerMetre, x: PhasorMetres) -> PhasorRadians:
    """The rotation of the sections at the supports, in the films."""
    tilts: ComplexArray = theta_0 + Theta @ x
    return tilts


@formula(
    "θ_x",
    "geometry: the part of the tilt that lies in the plane of the narrowest film",
    shows="|Re(θ·x*)|/|x|; |θ| of a journal that runs centred",
)
def tilt_along(theta: PhasorRadians, x: PhasorMetres) -> Radians:
    """Half a bearing's length times this is missing of the narrowest film at its edge."""
    e = np.abs(x)
    centred = e < CENTRED
    along: Array = np.where(centred, np.abs(theta), np.abs((theta * np.conj(x)).real) / np.where(centred, 1.0, e))
    return along


@formula(
    "γ_c",
    "geometry: half-angle of the cone on which the straight line through the outer journals goes round",
    meanings={"z_f": "Place of the front bearing", "z_r": "Place of the rear bearing"},
)
def cone(x_f: PhasorMetre, x_r: PhasorMetre, z_f: Metre, z_r: Metre) -> Radian:
    return modulus((x_r - x_f) / (z_r - z_f))


@formula("k_m", MEAN_TANGENT, names={"k_t": "d|P|/de", "k_s": "|P|/e"})
def mean_stiffness(k_t: NewtonPerMetre, k_s: NewtonPerMetre) -> NewtonPerMetre:
    """>>> mean_stiffness(k_t=9e7, k_s=3e7)
    60000000.0
    """
    return (k_t + k_s) / 2


# --- what stands in the housing


@formula("I_m", "geometry: mean second moment of both planes, as a section that turns bends under a load that stands")
def mean_inertia(I: Metre4, I_side: Metre4) -> Metre4:
    return (I + I_side) / 2


@formula("R_G", Text("{bound}: tooth force and tilting couple of its thrust", bound=BOUND))
def wheel_load(G_F: Number, G_C: PerMetre, F_t: Newton, F_r: Newton, F_a: Newton, d: Metre) -> Newton:
    """G_F, G_C: what 1 N and 1 N·m at the wheel put on the support."""
    return G_F * sqrt(F_t**2 + F_r**2) + G_C * F_a * d / 2


@formula(
    "R_c", Text("{bound}: every bore by t/2 off the line", bound=BOUND), shows="t/2·Σ_j |A_ij|, A = k − k·(K_0 + k)⁻¹·k"
)
def alignment_load(t: Metre, A: NewtonsPerMetre) -> Newtons:
    """`A`: how much less stands on the row's support for each metre by which the column's bore is off the line."""
    loads: Array = t / 2 * np.abs(A).sum(1)
    return loads
