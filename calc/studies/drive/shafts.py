# SPDX-License-Identifier: Apache-2.0
"""Shafts as arrays: sectors, slopes of the journals and mass over core, both journals' lengths and the largest seat.

A pure couple on two journals: the sectors have a closed form (countershaft/sizing), the bending moment depends on no
stiffness, and a slope is the integral of M·m/(E·I) + Q·q/(κ·G·A) over the pieces (principle of virtual work; m, q of a
unit couple at the journal).  M is at most quadratic and m linear on each piece, so that two points of Gauss are exact.
What the shaft's own mass adds while it turns is a share that goes with mass and slope; whatever is offered is bent
whole (countershaft/bending).

z from mid-shaft, + towards the flywheel; SI throughout.
"""

import math

import numpy as np

from ...countershaft import outline as s
from ...countershaft.bending import formulas as b
from ...countershaft.inputs import Holes
from ...countershaft.sizing import formulas as z
from ...countershaft.sizing.sectors import NEAR, too_narrow
from ...draw.drawing import TOUCH
from ...library.catalogue import Material
from ...sheet.arrays import Array, BoolArray
from ...sheet.record import record, replace
from ...sheet.units import Kilogram, Metre, NewtonMetre, Number, Radian, RadPerSecond

# of m·ω²·L²·θ/C: the share that the mass of a bent shaft adds to a slope as it turns; by trying, bearings about the
# middle
TURNING = 0.05
SAFE = 1.25  # on that of the softest shaft of a class, where it is more; rule of this program
GAUSS = (0.5 - 0.5 / math.sqrt(3), 0.5 + 0.5 / math.sqrt(3))


@record
class ShaftSurroundings:
    """What all shafts of a class have in common.  `couple` that the sectors give; `gear`: diameter and width of its
    wheel.

    `clearance`: for threading; `fillet` 0: none is asked; `effectiveness`: share of the sectors' stiffness. `added`: to
    the slopes of both journals while the shaft turns, as TURNING. `gear_z`: middle of its wheel where that is given,
    ahead of both journals or behind them; None: it stands against the first one.

    Journals are counted front to rear: 0 and 1."""

    material: Material
    couple: NewtonMetre
    omega: RadPerSecond
    positions: tuple[Metre, Metre]
    clearance: Metre
    fillet: Metre
    effectiveness: Number
    gear: tuple[Metre, Metre] | None
    filleted: bool  # whether the core between wheel and journal must hold two fillets
    added: tuple[Number, Number] = (TURNING, TURNING)
    gear_z: Metre | None = None
    holes: Holes | None = None  # that are to end within the sectors

    @property
    def span(self) -> Metre:
        return self.positions[1] - self.positions[0]

    @property
    def shear(self) -> Number:
        """κ·G."""
        m = self.material
        return b.shear_coefficient(nu=m.poisson) * b.shear_modulus(E=m.E, nu=m.poisson)

    def turning(self, n: int, mass: Array, slope: Array) -> Array:
        """The slope of journal n as the shaft turns."""
        turned: Array = slope * (1 + self.added[n] * mass * self.omega**2 * self.span**2 * np.abs(slope) / self.couple)
        return turned

    def longest(self, n: int, R: Metre, r_0: Metre) -> Metre:
        """The longest journal n that leaves the sectors the room that the couple needs, with that outer and core
        radius."""
        K = z.couple_number(C=self.couple, rho=self.material.density, omega=self.omega, R=R, r_0=r_0)
        return 2 * (abs(self.positions[n]) - math.sqrt(2 * K) - 2 * self.fillet)

    def stub(self, l_0: Array, l_1: Array) -> Array:
        """The core between the wheel and the journal beside it; 0 where it stands against the first one, below it where
        they cross."""
        if self.gear is None or self.gear_z is None:
            return 0 * l_0 + 0 * l_1
        half = self.gear[1] / 2
        ahead = self.gear_z < self.positions[0]
        room: Array = self.positions[0] - l_0 / 2 - self.gear_z if ahead else self.gear_z - self.positions[1] - l_1 / 2
        return room - half + 0 * l_0 + 0 * l_1

    def face(self, l_0: Array, l_1: Array) -> Array:
        """Half-length: where the sectors' outer faces stand, two fillets from the longer journal (in reach)."""
        z_0, z_1 = self.positions
        face: Array = np.minimum(abs(z_0) - l_0 / 2, abs(z_1) - l_1 / 2) - 2 * self.fillet
        return face

    def gear_mass(self) -> Kilogram:
        if self.gear is None:
            return 0.0
        d, width = self.gear
        return self.material.density * math.pi / 4 * d**2 * width


@record
class Shafts:
    """Over core (first axis) and the lengths of journal 0 (second) and 1 (third); not a number where nothing fits.

    `slopes` of the journals without what their own bending adds; `mass` without their own; `fits`: the envelope holds
    the couple, and the core beside a wheel its fillets."""

    face: Array
    slopes: tuple[Array, Array]
    mass: Array
    fits: BoolArray


def journal_slopes(drive: ShaftSurroundings, n: int, d: Metre, l: Array) -> tuple[Array, Array]:
    """What the bending of journal n, from its pin to its inner end, adds to the slopes of both."""
    A, I = s.cylinder_area(R=d / 2), s.cylinder_inertia(R=d / 2)
    pin = drive.positions[n]
    start, end = (pin + 0 * l, pin + l / 2) if n == 0 else (pin - l / 2, pin + 0 * l)
    R = drive.couple / drive.span
    total = [np.zeros_like(l), np.zeros_like(l)]
    for share in GAUSS:
        at = start + (end - start) * share
        M = R * (at - pin)
        for k in (0, 1):
            total[k] = (
                total[k] + _virtual(drive, k, at, M, R, drive.material.E * I, drive.shear * A) * (end - start) / 2
            )
    return total[0], total[1]


def _virtual(
    drive: ShaftSurroundings, n: int, at: Array, M: Array, Q: Array | float, EI: Array | float, GA: Array | float
) -> Array:
    """The integrand of the slope of journal n, both counted so that a couple between them makes them positive."""
    x = (at - drive.positions[0]) / drive.span
    m, q = (1 - x if n == 0 else -x), -1 / drive.span
    integrand: Array = M * m / EI + Q * q / GA
    return integrand


def with_turning(
    drive: ShaftSurroundings,
    core: Metre,
    d: tuple[Metre, Metre],
    l: tuple[Metre, Metre],
    turning: tuple[Radian, Radian],
    seat: Metre,
) -> ShaftSurroundings:
    """The same with what its mass adds to slopes, from one shaft of it that was bent whole as it turns.  `seat`: the
    largest, through which the sectors go."""
    lengths = np.array([l[0]]), np.array([l[1]])
    still = shafts(drive, np.array([core]), lengths, seat)
    mass = float(still.mass[0, 0, 0] + sum(journal_mass(drive, d[n], lengths[n])[0] for n in (0, 1)))
    bent = [journal_slopes(drive, n, d[n], lengths[n]) for n in (0, 1)]
    added = list(drive.added)
    for n in (0, 1):
        slope = float(still.slopes[n][0, 0, 0] + bent[0][n][0] + bent[1][n][0])
        if slope > 0:
            share = (turning[n] / slope - 1) * drive.couple / (mass * drive.omega**2 * drive.span**2 * slope)
            added[n] = max(added[n], SAFE * share)
    return replace(drive, added=(added[0], added[1]))


def shafts(drive: ShaftSurroundings, core: Array, lengths: tuple[Array, Array], seat: Metre) -> Shafts:
    """`lengths` of the journals, front to rear; `seat`: diameter of the largest, through which the sectors go."""
    material, R, span, (z_0, z_1) = drive.material, seat / 2 - drive.clearance, drive.span, drive.positions
    r_0 = core[:, None, None]
    l_0, l_1 = along(0, lengths[0]), along(1, lengths[1])
    F = drive.face(l_0, l_1)
    faces, place = np.unique(np.round(F, 9), return_inverse=True)
    place = place.reshape(F.shape)[0]  # of each pair of lengths
    with np.errstate(all="ignore"):
        r, f = core[:, None], faces[None, :]
        K = z.couple_number(C=drive.couple, rho=material.density, omega=drive.omega, R=R, r_0=r)
        fits = (f > 0) & (z.pair_utilisation(K=K, z_max=f) <= 1) & (r < R)
        gamma = z.pair_half_angle(K=np.where(fits, K, np.nan), z_max=f)
        length = z.pair_length(z_max=f, q=z.pair_ratio(gamma=gamma))
        closed = too_narrow(2 * (f - length), drive.fillet)
        gamma = np.where(closed, z.closed_half_angle(K=K, z_max=f), gamma)
        length = np.where(closed, f, length)
        A, S = s.sector_area(gamma=gamma, R=R, r_0=r), s.sector_moment(gamma=gamma, R=R, r_0=r)
        area = s.whole_area(A=A, r_0=r)
        I = s.sector_inertia(R=R, r_0=r, gamma=gamma, A_tot=area, y=s.whole_centre(S=S, A_tot=area))
        whole = area
        gap = 2 * (f - length)
        if drive.holes is not None:
            fits &= _drilled(drive.holes, R, r, length, gamma)
        I_0 = math.pi / 4 * r**4
        EI = material.E * b.shared_inertia(I_0=I_0, eta=drive.effectiveness, I=I)
        EI_0, GA, GA_0 = material.E * I_0, drive.shear * whole, drive.shear * math.pi * r**2
        load = drive.couple / (length * (2 * f - length))  # of each sector, per length
        reaction = drive.couple / span

        def state(at: Array) -> tuple[Array, Array]:
            """M and Q, by Macaulay's brackets."""
            M, Q = reaction * (at - z_0), reaction + 0 * at
            for edge, sign in ((-f, -1), (-f + length, 1), (f - length, 1), (f, -1)):
                beyond = np.maximum(at - edge, 0.0)
                M, Q = M + sign * load * beyond**2 / 2, Q + sign * load * beyond
            return M, Q

        inner = [np.zeros_like(length), np.zeros_like(length)]
        for start, end, stiff, shear in (
            (-f, -f + length, EI, GA),
            (-f + length, f - length, EI_0, GA_0),
            (f - length, f, EI, GA),
        ):
            for share in GAUSS:
                at = start + (end - start) * share
                M, Q = state(at)
                for n in (0, 1):
                    inner[n] = inner[n] + _virtual(drive, n, at, M, Q, stiff, shear) * (end - start) / 2
        mass = material.density * (2 * whole * length + math.pi * r**2 * gap)

        slopes = [inner[n][:, place] for n in (0, 1)]
        E, G = material.E * math.pi / 4 * r_0**4, drive.shear * math.pi * r_0**2
        for start, end, pin in (
            (z_0 + l_0 / 2 + 0 * l_1, -F, z_0),
            (F, z_1 - l_1 / 2 + 0 * l_0, z_1),
        ):
            for share in GAUSS:
                at = start + (end - start) * share
                for n in (0, 1):
                    M = reaction * (at - pin)
                    slopes[n] = slopes[n] + _virtual(drive, n, at, M, reaction, E, G) * (end - start) / 2
        beside = (-F - z_0 - l_0 / 2) + (z_1 - l_1 / 2 - F)
        stub = drive.stub(l_0, l_1)
        beside = beside + np.where(stub > TOUCH, stub, 0.0)
        free = (stub >= -TOUCH) & ~(drive.filleted & too_narrow(stub, drive.fillet))
        weight = mass[:, place] + material.density * math.pi * r_0**2 * beside + drive.gear_mass()
    return Shafts(np.broadcast_to(F, slopes[0].shape), (slopes[0], slopes[1]), weight, fits[:, place] & free)


def _drilled(holes: Holes, R: Metre, r: Array, length: Array, gamma: Array) -> BoolArray:
    """Whether the calibration holes end in two sectors, side by side within them (countershaft/making/unbalance.py)."""
    row = math.ceil(holes.count / 2) * holes.diameter
    chord = 2 * max(R - holes.depth, 0.0) * np.sin(np.minimum(gamma, math.pi / 2))
    inside: BoolArray = (holes.depth <= R - r + NEAR) & (row <= length) & (holes.diameter <= chord)
    return inside


def along(n: int, x: Array) -> Array:
    """What is known over the length of journal n, along its axis of `Shafts`."""
    return x[None, :, None] if n == 0 else x[None, None, :]


def journal_mass(drive: ShaftSurroundings, d: Metre | Array, l: Array) -> Array:
    mass: Array = drive.material.density * math.pi / 4 * np.asarray(d) ** 2 * l
    return mass
