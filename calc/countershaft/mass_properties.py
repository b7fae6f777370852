# SPDX-License-Identifier: Apache-2.0
"""Where the shaft's centre of gravity lies and its tensor of inertia about it, in closed form from its pieces.

Across the axis a point is w = x + iy: x up, y 90° further in the sense of crank rotation, cylinder 1 at TDC; z from
mid-shaft, + towards the flywheel.  Of every cross-section the area ∫dA, the static moment ∫w dA, the polar moment
∫|w|² dA and the moment of squares ∫w² dA are known; a piece of length l around z has of each ∫dz = l, ∫z dz = l·z and
∫z² dz = l·z² + l³/12."""

import numpy as np

from ..sheet.arrays import ComplexArray
from ..sheet.formula import formula
from ..sheet.functions import cis, imag, joined, modulus, real, resultant, sin
from ..sheet.linked_array import column, gathered, where
from ..sheet.quantity import result, value
from ..sheet.record import record, replace
from ..sheet.shown import Shown
from ..sheet.text import Amount, Text
from ..sheet.units import (
    Kilogram,
    KilogramMetre2,
    KilogramPerMetre3,
    Kilograms,
    Metre,
    Metres,
    Number,
    PhasorCubicMetres,
    PhasorKilogramMetre,
    PhasorKilogramMetre2,
    PhasorMetre,
    PhasorMetre4,
    PhasorMetres4,
    Radian,
    Radians,
    SquareMetres,
)
from ..sheet.value import based_on
from .inputs import EccentricMass
from .outline import HEAVIER, SECTOR, Outline, extent, turning_inertia, weighed

ABOUT_G = Text("definition, with Steiner's theorem: moment of inertia about the centre of gravity")
PRODUCT_G = Text("definition, with Steiner's theorem: −∫ of both distances over the mass, about the centre of gravity")
ALONG_AXIS = {"z_S": "Centre of gravity along the axis, from mid-shaft"}
POINTS = {"m": "m_i", "e": "e_i", "z": "z_i", "phi": "φ_i"}


def turned(x: float) -> float:
    """The number of a mirror image that has the other sign; of 0 it is 0."""
    return based_on(0.0 - x, x)


@result
class InertiaResult(Shown):
    """The tensor of inertia about the centre of gravity, axes up, side and along; its products are −∫ab dm."""

    xx: KilogramMetre2 = value("Moment of inertia about the axis up through the centre of gravity", "kg·mm²", "J_xx")
    yy: KilogramMetre2 = value("the same about the axis to the side", "kg·mm²", "J_yy")
    zz: KilogramMetre2 = value("the same about the axis along the shaft", "kg·mm²", "J_zz")
    xy: KilogramMetre2 = value("Product of inertia −∫xy dm about the centre of gravity", "kg·mm²", "J_xy")
    yz: KilogramMetre2 = value("the same, −∫yz dm", "kg·mm²", "J_yz")
    zx: KilogramMetre2 = value("the same, −∫zx dm", "kg·mm²", "J_zx")

    def mirrored(self) -> "InertiaResult":
        """Of the shaft's mirror image in the vertical plane through the crank."""
        return replace(self, xy=turned(self.xy), yz=turned(self.yz))


# --- sums over the pieces, and over masses that stand on a plain shaft as points


@formula(
    "S_2",
    Text("{sector}: ∫w² of the sector, w = x + iy", sector=SECTOR),
    unit="mm⁴",
    names={"phi": "φ"},
    meanings={"phi": "Directions of the sectors"},
)
def moment_of_squares(gamma: Radian, R: Metre, r_0: Metre, phi: Radian) -> PhasorMetre4:
    return sin(2 * gamma) * (R**4 - r_0**4) / 4 * cis(2 * phi)


@formula("S_2,w", HEAVIER, unit="mm⁴", names={"D": "S_2", "nu": "ν_ρ"})
def weighing_squares(D: PhasorMetre4, nu: Number) -> PhasorMetre4:
    return nu * D


@formula("U_i", "definition: static moment of points about the axis", unit="kg·mm", names=POINTS)
def unbalance_of_points(m: Kilograms, e: Metres, phi: Radians) -> PhasorKilogramMetre:
    return resultant(m * e * cis(phi))


@formula("K_i", "definition: ∫wz of points", unit="kg·mm²", names=POINTS)
def tilt_of_points(m: Kilograms, e: Metres, phi: Radians, z: Metres) -> PhasorKilogramMetre2:
    return resultant(m * e * z * cis(phi))


@formula("D_i", "definition: ∫w² of points", unit="kg·mm²", names=POINTS)
def squares_of_points(m: Kilograms, e: Metres, phi: Radians) -> PhasorKilogramMetre2:
    return resultant(m * e**2 * cis(2 * phi))


@formula("Z_i", "definition: ∫z² of points", unit="kg·mm²", names=POINTS)
def lengthwise_of_points(m: Kilograms, z: Metres) -> KilogramMetre2:
    return resultant(m * z**2)


PIECES = {"rho": "Density", "l": "Lengths of the pieces"}
STATIC = PIECES | {"S": "Static moments of the pieces about the axis", "U_i": "Static moment of points on it"}
ALONG = PIECES | {"z": "Middles of the pieces"}
LENGTHWISE = ALONG | {"A": "Areas of the pieces", "Z_i": "∫z² of points on it"}
SQUARES = PIECES | {"D": "∫w² of the sectors", "D_i": "∫w² of points on it"}


@formula("U", "geometry: static moment of the shaft about its axis", unit="kg·mm", names={"S": "S_γ"}, meanings=STATIC)
def unbalance(rho: KilogramPerMetre3, S: PhasorCubicMetres, l: Metres, U_i: PhasorKilogramMetre) -> PhasorKilogramMetre:
    return rho * resultant(S * l) + U_i


@formula(
    "K_S",
    "geometry: ∫wz of the shaft about mid-shaft",
    unit="kg·mm²",
    names={"S": "S_γ"},
    meanings=ALONG | {"S": STATIC["S"], "K_i": "∫wz of points on it"},
)
def tilt(
    rho: KilogramPerMetre3, S: PhasorCubicMetres, l: Metres, z: Metres, K_i: PhasorKilogramMetre2
) -> PhasorKilogramMetre2:
    return rho * resultant(S * l * z) + K_i


@formula("D_S", "geometry: ∫w² of the shaft about its axis", unit="kg·mm²", names={"D": "S_2"}, meanings=SQUARES)
def squares(rho: KilogramPerMetre3, D: PhasorMetres4, l: Metres, D_i: PhasorKilogramMetre2) -> PhasorKilogramMetre2:
    return rho * resultant(D * l) + D_i


@formula("Z", "geometry: ∫z² of the shaft about mid-shaft", unit="kg·mm²", meanings=LENGTHWISE)
def lengthwise(rho: KilogramPerMetre3, A: SquareMetres, l: Metres, z: Metres, Z_i: KilogramMetre2) -> KilogramMetre2:
    return rho * resultant(A * (l * z**2 + l**3 / 12)) + Z_i


# --- the centre of gravity, and the tensor about it


@formula("w_G", "definition: centre of gravity, static moment over mass", unit="mm")
def centre_across(U: PhasorKilogramMetre, m_S: Kilogram) -> PhasorMetre:
    return U / m_S


@formula("x_G", "geometry: its part up", unit="mm")
def up(w_G: PhasorMetre) -> Metre:
    return real(w_G)


@formula("y_G", "geometry: its part 90° further in the sense of crank rotation", unit="mm")
def side(w_G: PhasorMetre) -> Metre:
    return imag(w_G)


@formula("J_xx", ABOUT_G, unit="kg·mm²", meanings=ALONG_AXIS)
def inertia_up(
    J_S: KilogramMetre2, D_S: PhasorKilogramMetre2, Z: KilogramMetre2, m_S: Kilogram, w_G: PhasorMetre, z_S: Metre
) -> KilogramMetre2:
    return (J_S - real(D_S)) / 2 + Z - m_S * (imag(w_G) ** 2 + z_S**2)


@formula("J_yy", ABOUT_G, unit="kg·mm²", meanings=ALONG_AXIS)
def inertia_side(
    J_S: KilogramMetre2, D_S: PhasorKilogramMetre2, Z: KilogramMetre2, m_S: Kilogram, w_G: PhasorMetre, z_S: Metre
) -> KilogramMetre2:
    return (J_S + real(D_S)) / 2 + Z - m_S * (real(w_G) ** 2 + z_S**2)


@formula("J_zz", ABOUT_G, unit="kg·mm²")
def inertia_along(J_S: KilogramMetre2, m_S: Kilogram, w_G: PhasorMetre) -> KilogramMetre2:
    return J_S - m_S * modulus(w_G) ** 2


@formula("J_xy", PRODUCT_G, unit="kg·mm²")
def product_up_side(D_S: PhasorKilogramMetre2, m_S: Kilogram, w_G: PhasorMetre) -> KilogramMetre2:
    return joined(m_S * real(w_G) * imag(w_G), -(imag(D_S) / 2))


@formula("J_yz", PRODUCT_G, unit="kg·mm²", names={"K": "K_S"}, meanings=ALONG_AXIS)
def product_side_along(K: PhasorKilogramMetre2, m_S: Kilogram, w_G: PhasorMetre, z_S: Metre) -> KilogramMetre2:
    return joined(m_S * imag(w_G) * z_S, -imag(K))


@formula("J_zx", PRODUCT_G, unit="kg·mm²", names={"K": "K_S"}, meanings=ALONG_AXIS)
def product_along_up(K: PhasorKilogramMetre2, m_S: Kilogram, w_G: PhasorMetre, z_S: Metre) -> KilogramMetre2:
    return joined(m_S * real(w_G) * z_S, -real(K))


@record
class MassProperties:
    """Mass, centre of gravity (up, side, along the shaft from mid-shaft), tensor of inertia about it."""

    mass: Kilogram
    up: Metre
    side: Metre
    along: Metre
    inertia: InertiaResult


def mass_properties(
    shape: Outline,
    rho: KilogramPerMetre3,
    points: tuple[EccentricMass, ...] = (),
    known: tuple[Kilogram, Metre, KilogramMetre2] | None = None,
) -> MassProperties:
    """Of the outline and of masses that stand on it as points.

    `rho`: density of the core; `known`: mass, place of the centre of gravity along the axis and moment of inertia about
    the axis, where they are those of the same outline and points."""
    m_S, z_S, J_S = known or (*weighed(shape, rho, points), turning_inertia(shape, rho, points))
    l, z = extent(shape)
    S, A, D = shape.weighing_moment, shape.weighing_area, _squares(shape)
    U_i, K_i, D_i, Z_i = _of_points(points) if points else (0j, 0j, 0j, 0.0)
    K = tilt(rho=rho, S=S, l=l, z=z, K_i=K_i)
    Z = lengthwise(rho=rho, A=A, l=l, z=z, Z_i=Z_i)
    D_S = squares(rho=rho, D=D, l=l, D_i=D_i)
    w_G = centre_across(U=unbalance(rho=rho, S=S, l=l, U_i=U_i), m_S=m_S)
    inertia = InertiaResult(
        xx=inertia_up(J_S=J_S, D_S=D_S, Z=Z, m_S=m_S, w_G=w_G, z_S=z_S),
        yy=inertia_side(J_S=J_S, D_S=D_S, Z=Z, m_S=m_S, w_G=w_G, z_S=z_S),
        zz=inertia_along(J_S=J_S, m_S=m_S, w_G=w_G),
        xy=product_up_side(D_S=D_S, m_S=m_S, w_G=w_G),
        yz=product_side_along(K=K, m_S=m_S, w_G=w_G, z_S=z_S),
        zx=product_along_up(K=K, m_S=m_S, w_G=w_G, z_S=z_S),
    )
    return MassProperties(m_S, up(w_G=w_G), side(w_G=w_G), z_S, inertia)


def _squares(shape: Outline) -> ComplexArray:
    """∫w² of every piece's section, as it weighs."""
    sectors = np.array([piece.half_angle is not None for piece in shape.pieces])
    none = np.zeros(len(sectors), dtype=complex)
    if not sectors.any():
        return none
    gamma = gathered(piece.half_angle for piece in shape.pieces if piece.half_angle is not None)
    R, r_0, phi = (column(shape.pieces, name)[sectors] for name in ("outer_radius", "core_radius", "angle"))
    D = moment_of_squares(gamma=gamma, R=R, r_0=r_0, phi=phi)
    if shape.heavier != 1:
        D = weighing_squares(D=D, nu=shape.heavier)
    return where(sectors, D, none[~sectors])


def _of_points(
    points: tuple[EccentricMass, ...],
) -> tuple[PhasorKilogramMetre, PhasorKilogramMetre2, PhasorKilogramMetre2, KilogramMetre2]:
    m, e, phi, z = (column(points, name) for name in ("mass", "radius", "angle", "z"))
    return (
        unbalance_of_points(m=m, e=e, phi=phi),
        tilt_of_points(m=m, e=e, phi=phi, z=z),
        squares_of_points(m=m, e=e, phi=phi),
        lengthwise_of_points(m=m, z=z),
    )


def without_extras(extras: tuple[EccentricMass, ...]) -> Text:
    """That the centre of gravity across the axis and the tensor leave the further elements out."""
    return Text(
        "The further elements ({mass}) count as points in the mass, its place along the shaft and the moment of "
        "inertia about the axis; the centre of gravity across the axis and the tensor of inertia leave them out, "
        "and so does a STEP file.",
        mass=Amount(sum(extra.mass for extra in extras), "kg", digits=4),
    )
