# SPDX-License-Identifier: Apache-2.0
"""The sectors of a shaft with inner bearings: around each of these a gap is left, which parts what stands between
∓half-length into stretches.

Where force and couple point one way, or opposite ways, each stretch carries one sector, the lightest together
(multipliers.py).  Where they point different ways, two stretches are filled, and their half-angles follow from the two
conditions: that is not the lightest, and in unequal stretches shorter sectors may hold more (up to 14 % was seen).  One
stretch alone carries the pair of sectors.py.  ρ is the density of the sectors alone, so that they may be of a heavier
material than the core; a bore of the core changes nothing here.

Vectors: real up, imaginary 90° further in the sense of crank rotation, cylinder 1 at TDC.  z from mid-shaft, + towards
the flywheel."""

import math
from collections.abc import Callable, Iterable
from itertools import pairwise

import numpy as np

from ...draw.drawing import TOUCH
from ...sheet.arguments import demand_numbers
from ...sheet.arrays import Array, Num
from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.functions import argument, cos, joined, largest, modulus, root
from ...sheet.linked_array import column, gathered
from ...sheet.quantity import result
from ...sheet.record import replace
from ...sheet.text import Amount, Text
from ...sheet.units import (
    Kilogram,
    KilogramPerMetre3,
    Metre,
    Metres,
    Number,
    Numbers,
    PhasorKilogramMetre,
    PhasorKilogramMetre2,
    PhasorNumber,
    Radian,
    RadPerSecond,
)
from ...sheet.value import about, based_on, untraced
from .. import outline as s
from ..formulas import eccentric_mass
from ..inputs import Extra, ShaftInputs
from . import formulas as f
from .multipliers import LIGHTEST, Part, Stretches, grown, multipliers, present, supply, utilisation, worth
from .sectors import (
    Room,
    Sized,
    SizedSector,
    TooSmall,
    in_words,
    larger,
    masses,
    needed,
    remainder,
    sector,
    share_of_that,
    size,
    too_small,
    up,
)

# of the larger one of force·z_max and couple: what the other may have across it and still point the same way
ALONG = 1e-6
TUNGSTEN: KilogramPerMetre3 = 17600.0  # typical of the heavy alloys of which such sectors are made, from memory
NOT_THE_LIGHTEST = Text(
    "Force and couple point different ways: both stretches are filled, which is not the lightest shaft."
)


@result
class SizedStretches:
    """The sectors between the bearings, front to rear; `lightest`: whether no others of their kind weigh less."""

    mass: Kilogram
    utilisation: Number
    sectors: tuple[SizedSector, ...]
    outer_radius: Metre
    core_radius: Metre
    lightest: bool

    @property
    def by_name(self) -> dict[str, SizedSector]:
        """Its sectors, counted from the front."""
        return {str(number): sector for number, sector in enumerate(self.sectors, 1)}


# --- the stretches

Gaps = tuple[tuple[Metre, Metre], ...]  # the place of each inner bearing, and the width of the gap around it


@formula(
    "g_B",
    "rule of this program: beside an inner journal room for two fillets, one at it and one at the sector",
    unit="mm",
)
def gap_of(l: Metre, r: Metre) -> Metre:
    """l: length of the journal, r: radius of the fillets."""
    return l + 4 * r


def inner_gaps(shaft: ShaftInputs) -> Gaps:
    """The gaps at the inner bearings of a shaft: as it has them, else by their journals."""
    fillet = shaft.fillet_radius or 0.0
    gaps = []
    for row in shaft.bearings[1:-1]:
        with about(Text("{row} bearing", row=row.in_words)):
            if shaft.gap is not None:
                gaps.append((row.position, shaft.gap))
            elif row.on_shaft is not None:
                gaps.append((row.position, gap_of(l=row.on_shaft[1], r=fillet)))
    return tuple(gaps)


def stretches(half_length: Metre, gaps: Iterable[tuple[Metre, Metre]]) -> Stretches:
    """What is left between ∓half_length [m] of all gaps, (from, to) [m], front to rear.

    A gap without width parts a stretch all the same: sectors end at the bearing.  BadInput where one of them is no
    finite number."""
    gaps = tuple(gaps)
    places = {f"gaps[{n}].{name}": x for n, gap in enumerate(gaps) for name, x in zip(("z", "width"), gap)}
    demand_numbers("stretches", half_length=half_length, **places)
    left = [(based_on(-half_length, half_length), half_length)]
    for z, width in gaps:
        front, rear = (based_on(face, z, width) for face in (z - width / 2, z + width / 2))
        parted = [end for start, stop in left for end in ((start, min(stop, front)), (max(start, rear), stop))]
        left = [(start, end) for start, end in parted if end - start > TOUCH]
    return tuple(left)


# --- the sizing


@formula(
    "P_m", "mathematics: unbalance times position about the middle of the stretch", unit="kg·mm²", names={"z": "z_m"}
)
def product_about(P: PhasorKilogramMetre2, U: PhasorKilogramMetre, z: Metre) -> PhasorKilogramMetre2:
    return joined(P, -z * U)


@formula("v_∥", "mathematics: component in the common direction of force and couple", names={"phi": "∠"})
def component(v: PhasorNumber, phi: Radian) -> Number:
    return modulus(v) * cos(argument(v) - phi)


@formula("ζ", "definition: faces of the stretches, over the farthest of them")
def relative(z: Metres, z_max: Metre) -> Numbers:
    return z / z_max


@formula(
    "u",
    "rule of this program: what is asked over what all stretches, filled to 90°, can give in its proportion",
    shows="u = max over λ_F, λ_C of (λ_F·α + λ_C·Π)/Σ∫|λ_F + λ_C·ζ|dζ",
)
def stretches_utilisation(alpha: Number, product: Number, faces: Numbers) -> Number:
    return utilisation(float(alpha), float(product), _pairs(faces))


@formula(
    "λ_F",
    Text("{lightest}: of the force", lightest=LIGHTEST),
    shows="λ_F, with λ_C, from the largest λ_F·α + λ_C·Π − Σ∫(|λ_F + λ_C·ζ|·sin γ − γ)dζ",
)
def force_multiplier(alpha: Number, product: Number, faces: Numbers) -> Number:
    return multipliers(float(alpha), float(product), _pairs(faces))[0]


@formula(
    "λ_C",
    Text("{lightest}: of the couple", lightest=LIGHTEST),
    shows="λ_C, with λ_F, from the largest λ_F·α + λ_C·Π − Σ∫(|λ_F + λ_C·ζ|·sin γ − γ)dζ",
)
def couple_multiplier(alpha: Number, product: Number, faces: Numbers) -> Number:
    return multipliers(float(alpha), float(product), _pairs(faces))[1]


@formula("b", "definition: lengths are measured by the farthest face", unit="mm", names={"beta": "β"})
def sector_length(beta: Number, z_max: Metre) -> Metre:
    return beta * z_max


@formula("u", "rule of this program: the larger sin γ of two filled stretches")
def filled_utilisation(
    U_f: PhasorKilogramMetre, U_r: PhasorKilogramMetre, k: Kilogram, b_f: Metre, b_r: Metre
) -> Number:
    return largest(modulus(U_f) / (k * b_f), modulus(U_r) / (k * b_r))


def size_between(
    U: PhasorKilogramMetre,
    P: PhasorKilogramMetre2,
    omega: RadPerSecond,
    rho: KilogramPerMetre3,
    R: Metre,
    r_0: Metre,
    z_max: Metre,
    gaps: Gaps,
    extras: tuple[Extra, ...] = (),
    fillet: Metre = 0.0,
) -> Sized | SizedStretches:
    """The lightest sectors that, with the extras, have the unbalance U and the product of unbalance and position P: two
    of them, or beside inner bearings one in each stretch.  Raises TooSmall and NoSolution, as these do."""
    if not gaps:
        return size(U, P, omega, rho, R, r_0, z_max, extras, fillet)
    return size_stretches(*remainder(U, P, extras), omega, rho, R, r_0, stretches(z_max, gaps), fillet)


def least_masses(
    U: PhasorKilogramMetre, P: PhasorKilogramMetre2, rho: Num, R: Num, r_0: Metre, z_max: Metre, gaps: Gaps
) -> Array:
    """Their masses [kg] in as many envelopes, U and P of the sectors alone; NaN where it can not be."""
    return stretch_masses(U, P, rho, R, r_0, stretches(z_max, gaps)) if gaps else masses(U, P, rho, R, r_0, z_max)


def size_stretches(
    U: PhasorKilogramMetre,
    P: PhasorKilogramMetre2,
    omega: RadPerSecond,
    rho: KilogramPerMetre3,
    R: Metre,
    r_0: Metre,
    where: Stretches,
    fillet: Metre = 0.0,
) -> SizedStretches:
    """The sectors that together have the unbalance U and the product of unbalance and position P.

    U = F/ω² and P = C/ω², less what further elements do; `where`: the stretches, front to rear; a single one takes the
    pair of `sectors.size` about its own middle, and only for that `fillet` counts.  Raises TooSmall where the envelope
    can not hold them, NoSolution where nothing is asked, no stretch is left, or force and couple point different ways
    and there are more than two."""
    if not where:
        raise NoSolution(
            Text("the gaps of the inner bearings leave no room for sectors"),
            advice=Text("narrower gaps, or a larger half-length"),
        )
    front, rear = where[0][0], where[-1][1]
    room = Room(omega, rho, R, r_0, based_on(max(-front, rear), front, rear), fillet)
    if len(where) == 1:
        return _one(U, P, room, where[0])
    with about(Text("sectors")):
        k = f.unbalance_per_length(rho=rho, R=R, r_0=r_0)
    needed(U, P, k, room.z_max)
    if same_way(U, P, room.z_max):
        return _lightest(U, P, k, room, where)
    if len(where) > 2:
        apart = math.degrees(abs(argument(P / U)))
        raise NoSolution(
            Text("force and couple point {angle} apart", angle=Amount(apart, "°", form=".3g")),
            Text("one direction for the sectors of {n} stretches between the bearings", n=len(where)),
            Text("give the masses (mode given)"),
        )
    return _filled(U, P, k, room, where)


def same_way(U: PhasorKilogramMetre, P: PhasorKilogramMetre2, z_max: Metre) -> bool:
    """Whether force and couple point the same way or opposite ways, or one of them is nothing: the smaller has next to
    nothing across the larger."""
    return abs((U.conjugate() * P).imag) * z_max <= ALONG * max(abs(U) * z_max, abs(P)) ** 2


def _direction(U: PhasorKilogramMetre, P: PhasorKilogramMetre2, z_max: Metre) -> Radian:
    """The common direction: of the larger one."""
    return f.direction(U=U) if abs(U) * z_max >= abs(P) else f.couple_direction(P=P)


def _lightest(
    U: PhasorKilogramMetre, P: PhasorKilogramMetre2, k: Kilogram, room: Room, where: Stretches
) -> SizedStretches:
    z_max = room.z_max
    with about(Text("sectors")):
        phi = _direction(U, P, z_max)
        alpha = component(v=f.force_number(U=U, k=k, z_max=z_max), phi=phi)
        product = component(v=f.product_number(P=P, k=k, z_max=z_max), phi=phi)
        faces = relative(z=gathered(face for stretch in where for face in stretch), z_max=z_max)
        u = stretches_utilisation(alpha=alpha, product=product, faces=faces)
        if u > 1:

            def load(share: float, stretches: Stretches) -> float:
                return utilisation(alpha, share * product, _pairs(np.ravel(stretches) / z_max))

            raise _refused(u, U, P, room, where, load, Text("of any length"))
        lam_F = force_multiplier(alpha=alpha, product=product, faces=faces)
        lam_C = couple_multiplier(alpha=alpha, product=product, faces=faces)
    found = [
        _grown_sector(number, part, lam_F, lam_C, phi, room)
        for number, part in enumerate(present(lam_F, lam_C, _pairs(faces)), 1)
    ]
    return _sized(found, u, room, True)


def _grown_sector(number: int, part: Part, lam_F: Number, lam_C: Number, phi: Radian, room: Room) -> SizedSector:
    """The sector of a part."""
    with about(Text("sector {number}", number=number)):
        gamma, beta = grown(worth(lam_F=lam_F, lam_C=lam_C, zeta=part.outer), lam_C, part.length)
        b = sector_length(beta=beta, z_max=room.z_max)
        A = s.sector_area(gamma=gamma, R=room.R, r_0=room.r_0)
        S = s.sector_moment(gamma=gamma, R=room.R, r_0=room.r_0)
        return SizedSector(
            length=b,
            half_angle=gamma,
            mass=s.sector_mass(rho=room.rho, A=A, b=b),
            radius=s.centre_of_gravity(S=S, A=A),
            angle=phi if part.side > 0 else f.opposite(angle=phi),
            z=based_on(part.outer * room.z_max + part.inward * b / 2, b),
        )


def _filled(
    U: PhasorKilogramMetre, P: PhasorKilogramMetre2, k: Kilogram, room: Room, where: Stretches
) -> SizedStretches:
    (b_f, b_r), (z_f, z_r) = _extent(where)
    with about(Text("sectors")):
        U_r = f.rear_unbalance(P=P, z_f=z_f, U=U, z_r=z_r)
        U_f = f.front_unbalance(U=U, U_r=U_r)
        u = filled_utilisation(U_f=U_f, U_r=U_r, k=k, b_f=b_f, b_r=b_r)
    if u > 1:

        def load(share: float, stretches: Stretches) -> float:
            (b_f, b_r), (z_f, z_r) = _extent(stretches)
            U_r = f.rear_unbalance(P=share * P, z_f=z_f, U=U, z_r=z_r)
            return filled_utilisation(U_f=U - U_r, U_r=U_r, k=k, b_f=b_f, b_r=b_r)

        raise _refused(u, U, P, room, where, load, Text("which they fill"))
    both = sector("front", U_f, b_f, z_f, k, room), sector("rear", U_r, b_r, z_r, k, room)
    return _sized([one for one in both if one.mass], u, room, False)


def _one(U: PhasorKilogramMetre, P: PhasorKilogramMetre2, room: Room, where: tuple[Metre, Metre]) -> SizedStretches:
    start, end = where
    if middle := (start + end) / 2:
        P = product_about(P=P, U=U, z=middle)
    sized = size(U, P, room.omega, room.rho, room.R, room.r_0, (end - start) / 2, fillet=room.fillet)
    both = [replace(one, z=based_on(one.z + middle, one.z)) for one in (sized.front, sized.rear) if one.mass]
    return _sized(both, sized.utilisation, room, True)


def _sized(found: list[SizedSector], u: Number, room: Room, lightest: bool) -> SizedStretches:
    with about(Text("sectors")):
        return SizedStretches(
            mass=eccentric_mass(m=column(found, "mass")),
            utilisation=u,
            sectors=tuple(found),
            outer_radius=room.R,
            core_radius=room.r_0,
            lightest=lightest,
        )


def _pairs(faces: Numbers) -> Stretches:
    """Stretches from the row of their faces."""
    ends = [float(face) for face in faces]
    return tuple(zip(ends[::2], ends[1::2]))


def _extent(where: Stretches) -> tuple[tuple[Metre, ...], tuple[Metre, ...]]:
    """Lengths and middles."""
    return tuple(end - start for start, end in where), tuple((start + end) / 2 for start, end in where)


def stretch_masses(
    U: PhasorKilogramMetre, P: PhasorKilogramMetre2, rho: Num, R: Num, r_0: Metre, where: Stretches
) -> Array:
    """The mass of all sectors [kg] for U and P in as many envelopes: densities and outer radii in SI, arrays of one
    axis or numbers.  NaN where it can not be."""
    rho, R = np.broadcast_arrays(np.atleast_1d(rho), np.atleast_1d(R))
    z_max = max(-where[0][0], where[-1][1])
    (b, z), section = _extent(where), rho * (R**2 - r_0**2)
    with untraced():
        k = f.unbalance_per_length(rho=rho, R=R, r_0=r_0)
        if len(where) == 1:
            return masses(U, P - z[0] * U, rho, R, r_0, b[0] / 2)
        if same_way(U, P, z_max):
            phi = _direction(U, P, z_max)
            task = component(v=U, phi=phi) / z_max, component(v=P, phi=phi) / z_max**2
            faces = _pairs(np.ravel(where) / z_max)
            amounts = [_amount(task[0] / x, task[1] / x, faces) for x in k]
            return np.asarray(section * z_max * np.array(amounts))
        if len(where) > 2:
            return np.full(k.shape, np.nan)
        U_r = f.rear_unbalance(P=P, z_f=z[0], U=U, z_r=z[1])
        sines = [abs(share) / (k * length) for share, length in zip((U - U_r, U_r), b)]
        with np.errstate(invalid="ignore"):
            front, rear = (length * np.arcsin(sine) for length, sine in zip(b, sines))
            return np.asarray(section * (front + rear))


def _amount(alpha: float, product: float, where: Stretches) -> float:
    """Σ γ·β of the lightest sectors."""
    if utilisation(alpha, product, where) > 1:
        return math.nan
    return supply(*multipliers(alpha, product, where), where)[2]


# --- where it does not fit


@formula("ρ_min", "geometry: the largest unbalance goes with the density of the sectors")
def density_needed(rho: KilogramPerMetre3, u: Number) -> KilogramPerMetre3:
    return rho * u


def _refused(
    u: Number,
    U: PhasorKilogramMetre,
    P: PhasorKilogramMetre2,
    room: Room,
    where: Stretches,
    load: Callable[[float, Stretches], float],
    ends: Text,
) -> TooSmall:
    """Each answer is where the utilisation comes to 1; `load` is that of a share of the couple in other stretches."""
    R, r_0, rho, z_max = room.R, room.r_0, room.rho, room.z_max

    def longer(x: Metre) -> Stretches:
        ends = [face for stretch in where for face in stretch]
        return _pairs(np.array([ends[0] - x, *ends[1:-1], ends[-1] + x]))

    def nearer(x: Metre) -> Stretches:
        inner = ((a + min(x, b - a) / 2, b - min(x, b - a) / 2) for (_, a), (b, _) in pairwise(where))
        return _pairs(np.array([where[0][0], *(face for gap in inner for face in gap), where[-1][1]]))

    widest = max(b - a for (_, a), (b, _) in pairwise(where))
    with untraced():
        far = z_max
        while load(1.0, longer(far)) > 1:
            far *= 2
        half_length = z_max + root(lambda x: load(1.0, longer(x)) - 1, 0.0, far)
        gap = missing = None
        if load(1.0, nearer(widest)) < 1:
            gap = root(lambda x: load(1.0, nearer(x)) - 1, 0.0, widest)
        if load(0.0, where) < 1:
            missing = root(lambda x: load(1 - x, where) - 1, 0.0, 1.0) * abs(P)
        heavy = f.radius_needed(R=R, r_0=r_0, u=u * rho / TUNGSTEN)
    radius, density = f.radius_needed(R=R, r_0=r_0, u=u), density_needed(rho=rho, u=u)
    ways = larger(radius, half_length, missing)
    if gap is not None:
        ways.append(Text("gaps at the inner bearings that are narrower by {up} mm each", up=up(gap * 1000.0, 1)))
    tungsten = Amount(TUNGSTEN, "kg/m³", form=".0f")
    if density <= TUNGSTEN:
        said = Text("sectors of {up} kg/m³ (tungsten: {tungsten})", up=up(density, 0), tungsten=tungsten)
        ways.append(said)
    elif rho < TUNGSTEN:
        said = Text("tungsten ({tungsten}) and an outer radius of {up} mm", tungsten=tungsten, up=up(heavy * 1000.0, 2))
        ways.append(said)
    tried = Text(
        "sectors from {r_0} to {r} mm in {n} stretches up to ±{z_max} mm, {ends}, half-angle up to 90°",
        r_0=Amount(r_0 * 1000.0, form="g"),
        r=Amount(R * 1000.0, form="g"),
        n=len(where),
        z_max=Amount(z_max * 1000.0, form="g"),
        ends=ends,
    )
    asked = in_words(abs(U) * room.omega**2, abs(P) * room.omega**2, z_max)
    error = too_small(u, asked, share_of_that(u), tried, ways)
    error.possible_couple = None
    error.outer_radius, error.half_length, error.product = radius, half_length, missing
    error.gap, error.density = gap, density
    return error
