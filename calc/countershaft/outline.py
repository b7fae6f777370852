# SPDX-License-Identifier: Apache-2.0
"""The shaft as a row of pieces, front to rear: what bends, what is drawn, what is weighed.

Given as sections, or put together from the eccentric masses (or the sized sectors), the core, the journals and the gear.
"""

import math
from typing import Any

import numpy as np

from ..sheet.arrays import Array, ComplexArray
from ..sheet.formula import formula
from ..sheet.functions import resultant
from ..sheet.record import record
from ..sheet.trace import about
from ..sheet.units import Kilogram, KilogramPerMetre3, Metre, Number, Radian, SquareMetre
from . import sector as s
from .inputs import CountershaftInputs, EccentricMass, Extra

TOUCH = 1e-6  # m: pieces that meet within this are taken to touch


@record
class Piece:
    """A stretch of the shaft of one section; `half_angle` None: a full cylinder.  `what`: journal, gear, core, sector, full."""

    start: Metre
    end: Metre
    outer_radius: Metre
    core_radius: Metre
    half_angle: Radian | None
    angle: Radian
    what: str

    @property
    def length(self) -> Metre:
        return self.end - self.start


@record
class Outline:
    """The pieces of the shaft, touching one another, and their sections' properties, an element each.

    `inertia` is that of the full section in its weaker plane; `moment` the static moment S·e^{iγ} of what is eccentric.
    """

    pieces: tuple[Piece, ...]
    derived: bool
    area: Array
    inertia: Array
    moment: ComplexArray

    @property
    def start(self) -> Metre:
        return self.pieces[0].start

    @property
    def end(self) -> Metre:
        return self.pieces[-1].end

    def each(self, name: str) -> Any:
        """One number of every piece, as an array."""
        return np.array([getattr(piece, name) for piece in self.pieces])


class NoOutline(Exception):
    """Why the shaft can not be drawn from what is known."""


@formula("m_S", "sum over the pieces of the shaft and its further elements", unit="kg")
def shaft_mass(rho: KilogramPerMetre3, A: SquareMetre, l: Metre, m: Kilogram) -> Kilogram:
    return rho * resultant(A * l) + resultant(m)


@formula("z_S", "centre of gravity of the pieces and the further elements", unit="mm")
def centre(rho: KilogramPerMetre3, A: SquareMetre, l: Metre, z: Metre, m: Kilogram, z_m: Metre, m_S: Kilogram) -> Metre:
    return (rho * resultant(A * l * z) + resultant(m * z_m)) / m_S


@formula("sin γ/γ", f"{s.SECTOR}: e over its value for a narrow sector")
def narrowness(e: Metre, R: Metre, r_0: Metre) -> Number:
    return e * (R**2 - r_0**2) / (2 / 3 * (R**3 - r_0**3))


@formula("γ", f"{s.SECTOR}", shows="γ from sin γ/γ, Newton", names={"t": "sin γ/γ"})
def half_angle(t: Number) -> Radian:
    """The half-angle of a sector, 0 < t < 1."""
    gamma = math.sqrt(6 * (1 - t)) if t > 0.4 else math.pi * (1 - t)
    for _ in range(50):
        step = (math.sin(gamma) - t * gamma) / (math.cos(gamma) - t)
        gamma -= step
        if abs(step) < 1e-15:
            break
    return gamma


@formula("b", "length of a sector of that mass", unit="mm")
def sector_length(m: Kilogram, rho: KilogramPerMetre3, A: SquareMetre) -> Metre:
    return m / (rho * A)


def outline(pieces: tuple[Piece, ...], derived: bool) -> Outline:
    """Pieces with the properties of their sections."""
    R, r_0, full = (np.array([getattr(p, n) for p in pieces]) for n in ("outer_radius", "core_radius", "half_angle"))
    sectors = np.array([g is not None for g in full])
    area, inertia = np.empty(len(pieces)), np.empty(len(pieces))
    moment = np.zeros(len(pieces), dtype=complex)
    with about("full sections of the shaft"):
        area[~sectors] = s.cylinder_area(R=R[~sectors])
        inertia[~sectors] = s.cylinder_inertia(R=R[~sectors])
    if sectors.any():
        gamma: Any = full[sectors].astype(float)
        R, r_0 = R[sectors], r_0[sectors]
        with about("sectors of the shaft"):
            A = s.sector_area(gamma=gamma, R=R, r_0=r_0)
            S: Any = s.sector_moment(gamma=gamma, R=R, r_0=r_0)
            whole = s.whole_area(A=A, r_0=r_0)
            y = s.whole_centre(S=S, A_tot=whole)
            area[sectors], inertia[sectors] = whole, s.sector_inertia(R=R, r_0=r_0, gamma=gamma, A_tot=whole, y=y)
            moment[sectors] = S * np.exp(1j * np.array([p.angle for p in pieces])[sectors])
    return Outline(pieces=pieces, derived=derived, area=area, inertia=inertia, moment=moment)


def given(shaft: CountershaftInputs) -> Outline:
    """The outline of [[countershaft.sections]]."""
    rows = sorted(shaft.sections, key=lambda section: section.from_)
    pieces = (
        Piece(r.from_, r.to, r.outer_radius, r.core_radius or 0.0, r.half_angle, r.angle or 0.0, "sector" if r.half_angle else "full")
        for r in rows
    )
    return outline(tuple(pieces), derived=False)


def sectors_of(masses: tuple[EccentricMass, ...], rho: KilogramPerMetre3, R: Metre, r_0: Metre) -> list[Piece]:
    """Sectors that have the mass, the centre of gravity and the place of the masses.  Raises NoOutline where one has no such sector."""
    found = []
    for mass in masses:
        if not mass.mass:
            continue
        with about(f"sector of mass {mass.name}"):
            t = narrowness(e=mass.radius, R=R, r_0=r_0)
            if not 1e-6 < t < 1:
                most = mass.radius / t if t else 0.0
                raise NoOutline(
                    f"mass {mass.name}: no sector from {r_0 * 1e3:g} to {R * 1e3:.4g} mm has its centre of gravity "
                    f"at {mass.radius * 1e3:g} mm" + (f" (it stays below {most * 1e3:.4g} mm)" if most else "")
                )
            gamma = half_angle(t=t)
            b = sector_length(m=mass.mass, rho=rho, A=s.sector_area(gamma=gamma, R=R, r_0=r_0))
        found.append(Piece(mass.z - b / 2, mass.z + b / 2, R, r_0, gamma, mass.angle, "sector"))
    return found


def assembled(
    sectors: list[Piece], journals: tuple[tuple[Metre, Metre], ...], positions: tuple[Metre, ...], r_0: Metre,
    gear: tuple[Metre, Metre] | None, gear_z: Metre | None, extras: tuple[Extra, ...],
) -> Outline:  # fmt: skip
    """Sectors, journals (diameter, length) and gear (radius, width) joined by the core.  Raises NoOutline where two of them cross."""
    solid = list(sectors)
    for z, (d, l) in zip(positions, journals):
        solid.append(Piece(z - l / 2, z + l / 2, d / 2, 0.0, None, 0.0, "journal"))
    if gear is not None:
        radius, width = gear
        front = positions[0] - (journals[0][1] / 2 if journals else 0.0)
        middle = gear_z if gear_z is not None else front - width / 2
        solid.append(Piece(middle - width / 2, middle + width / 2, radius, 0.0, None, 0.0, "gear"))
    solid.sort(key=lambda piece: piece.start)
    ends = [min([solid[0].start, *positions]), max([solid[-1].end, *positions])]
    for extra in extras:  # a stub that reaches as far beyond an overhung element as before it
        ends = [
            min(ends[0], 2 * extra.z - ends[0]) if extra.z < ends[0] else ends[0],
            max(ends[1], 2 * extra.z - ends[1]) if extra.z > ends[1] else ends[1],
        ]
    pieces: list[Piece] = []
    here = ends[0]
    for piece in solid:
        if piece.start < here - TOUCH:
            raise NoOutline(f"{_said(piece)} crosses {_said(pieces[-1])}")
        if piece.start > here + TOUCH:
            pieces.append(Piece(here, piece.start, r_0, 0.0, None, 0.0, "core"))
        pieces.append(piece)
        here = piece.end
    if ends[1] > here + TOUCH:
        pieces.append(Piece(here, ends[1], r_0, 0.0, None, 0.0, "core"))
    return outline(tuple(pieces), derived=True)


def _said(piece: Piece) -> str:
    return f"the {piece.what} from {piece.start * 1e3:.4g} to {piece.end * 1e3:.4g} mm"


def weighed(found: Outline, rho: KilogramPerMetre3, extras: tuple[Extra, ...]) -> tuple[Kilogram, Metre]:
    """Mass of the whole shaft and its centre of gravity along the axis."""
    A: Any = found.area
    l, z = found.each("end") - found.each("start"), (found.each("start") + found.each("end")) / 2
    m: Any = np.array([x.mass for x in extras])
    z_m: Any = np.array([x.z for x in extras])
    m_S = shaft_mass(rho=rho, A=A, l=l, m=m)
    return m_S, centre(rho=rho, A=A, l=l, z=z, m=m, z_m=z_m, m_S=m_S)


def unbalance_per_length(found: Outline, rho: KilogramPerMetre3) -> ComplexArray:
    """ρ·S of each piece [kg·m/m]: times ω² the distributed centrifugal load."""
    return rho * found.moment
