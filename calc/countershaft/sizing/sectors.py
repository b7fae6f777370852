# SPDX-License-Identifier: Apache-2.0
"""The lightest pair of sectors in an envelope: outer radius, core radius, and the half-length of their outer faces.

The outer radius is always used up, since the static moment of a sector grows with its cube and the mass with its
square.  A pure couple has a closed form: two equal sectors opposite each other.  A force, or elements beside the
sectors, ask for two different ones, and a search over their lengths (lengths.py).  Half-angles stay at or below 90°:
beyond, the static moment falls while the mass grows. Vectors: real up, imaginary 90° further in the sense of crank
rotation, cylinder 1 at TDC.  z from mid-shaft, + towards the flywheel."""

import math
from collections.abc import Sequence
from typing import Protocol

import numpy as np

from ...draw.drawing import TOUCH
from ...imbalance.result import ImbalanceResult
from ...sheet.arrays import Array, BoolArray, Num
from ...sheet.errors import NoSolution
from ...sheet.functions import root
from ...sheet.linked_array import column
from ...sheet.quantity import group, result, value
from ...sheet.record import record
from ...sheet.shown import Shown
from ...sheet.text import Amount, Text
from ...sheet.units import (
    Kilogram,
    KilogramMetre2,
    KilogramPerMetre3,
    Metre,
    Newton,
    NewtonMetre,
    Number,
    PhasorKilogramMetre,
    PhasorKilogramMetre2,
    PhasorNumber,
    Radian,
    RadPerSecond,
)
from ...sheet.value import about, based_on, untraced
from .. import outline as s
from ..inputs import EccentricMass, Extra
from ..outline import Piece, around
from ..sums import OrderVectors, SystemShaft, left
from . import formulas as f
from . import lengths

Asked = tuple[PhasorKilogramMetre, PhasorKilogramMetre2]  # unbalance U, and unbalance times position P
NEAR = 1e-9  # m: what sums of lengths are off
DUST = 1e-12  # of what the envelope can do: a force or an unbalance below it is none


@result
class SizedSector(Shown):
    """One sector of the shaft.  Its direction is that of its middle; one without mass has no half-angle."""

    length: Metre = value("Length of the sector", "mm", "b")
    half_angle: Radian = value("its half-angle", "°", "γ")
    mass: Kilogram = value("its mass", "kg", "m")
    radius: Metre = value("Radius of its centre of gravity", "mm", "e")
    angle: Radian = value("its direction, cylinder 1 at TDC", "°")
    z: Metre = value("its position", "mm", "z")


@result
class Sized(Shown):
    """The lightest pair of sectors in the envelope.  `sector_length` and `sector_half_angle` are the larger of both
    sectors'."""

    mass: Kilogram = value("Eccentric masses together", "kg", "Σm")
    utilisation: Number = value("Utilisation of the envelope", "", "u")
    sector_length: Metre = value("Length of a sector, the longer one", "mm", "b")
    sector_half_angle: Radian = value("Half-angle of a sector, the wider one", "°", "γ")
    couple: NewtonMetre | None = value("Couple of the pair", "N·m", "C", default=None)
    front: SizedSector = group()
    rear: SizedSector = group()
    outer_radius: Metre
    core_radius: Metre

    @property
    def by_name(self) -> dict[str, SizedSector]:
        """Its sectors, front to rear."""
        return {"front": self.front, "rear": self.rear}


@record
class Room:
    """The envelope that the sectors may fill, what they are made of, and the speed and the fillets of the shaft."""

    omega: RadPerSecond
    rho: KilogramPerMetre3
    R: Metre
    r_0: Metre
    z_max: Metre
    fillet: Metre


class TooSmall(NoSolution):
    """The envelope can not hold what is asked of it, with what would help (None: that alone would not).

    `possible` is the share of force and couple that the envelope holds, `possible_couple` that of a pure couple [N·m];
    `product` the unbalance times distance that further elements would have to bring in the couple's direction, without
    a force of their own.  Beside inner bearings also `gap`, by how much all of their gaps would have to be narrower,
    and `density`, that of the sectors."""

    possible: Number
    possible_couple: NewtonMetre | None
    outer_radius: Metre
    half_length: Metre
    product: KilogramMetre2 | None
    gap: Metre | None = None
    density: KilogramPerMetre3 | None = None


@result
class SectorPair(Shown):
    """A pure couple's two equal sectors."""

    utilisation: Number
    half_angle: Radian
    length: Metre
    arm: Metre  # of a sector's middle from mid-shaft
    radius: Metre
    mass: Kilogram
    couple: NewtonMetre  # of the pair, from its dimensions


def pair(
    C: NewtonMetre, omega: RadPerSecond, rho: KilogramPerMetre3, R: Metre, r_0: Metre, z_max: Metre, fillet: Metre = 0.0
) -> SectorPair:
    """Two equal sectors opposite each other that give the couple C with the least mass.  A gap between them that does
    not hold two fillets is closed.  Raises TooSmall."""
    K = f.couple_number(C=C, rho=rho, omega=omega, R=R, r_0=r_0)
    u = f.pair_utilisation(K=K, z_max=z_max)
    if u > 1:
        most = f.possible_couple(C=C, u=u)
        product = f.product_missing(C=C, C_max=most, omega=omega)
        asked = Text("a couple of {c} N·m", c=Amount(C, form=".4g"))
        length = f.half_length_needed(z_max=z_max, u=u)
        raise _refusal(u, asked, most, length, product, Room(omega, rho, R, r_0, z_max, fillet))
    gamma = f.pair_half_angle(K=K, z_max=z_max)
    q = f.pair_ratio(gamma=gamma)
    b = f.pair_length(z_max=z_max, q=q)
    if too_narrow(2 * (z_max - b), fillet):
        gamma, b = f.closed_half_angle(K=K, z_max=z_max), f.closed_length(z_max=z_max)
    z_c = f.pair_arm(z_max=z_max, b=b)
    A, S = s.sector_area(gamma=gamma, R=R, r_0=r_0), s.sector_moment(gamma=gamma, R=R, r_0=r_0)
    return SectorPair(
        utilisation=u,
        half_angle=gamma,
        length=b,
        arm=z_c,
        radius=s.centre_of_gravity(S=S, A=A),
        mass=s.sector_mass(rho=rho, A=A, b=b),
        couple=f.pair_couple(U=s.sector_unbalance(rho=rho, S=S, b=b), z_c=z_c, omega=omega),
    )


def too_narrow(gap: Metre | Array, fillet: Metre) -> BoolArray:
    """Whether a stretch of the core between two shoulders is there and does not hold two fillets."""
    narrow: BoolArray = (np.asarray(gap) >= TOUCH) & (np.asarray(gap) < 2 * fillet - NEAR)
    return narrow


def pair_masses(C: Num, omega: RadPerSecond, rho: Num, R: Num, r_0: Num, z_max: Num) -> Array:
    """The mass of both sectors [kg] for a couple C [N·m] at ω; density, radii and half-length in SI, any of them an
    array.  NaN where the envelope is too small."""
    with untraced(), np.errstate(invalid="ignore", divide="ignore"):
        rho, R, r_0, z_max = (np.asarray(x, dtype=float) for x in (rho, R, r_0, z_max))
        K = f.couple_number(C=C, rho=rho, omega=omega, R=R, r_0=r_0)
        fits = f.pair_utilisation(K=K, z_max=z_max) <= 1
        possible = np.where(fits, K, np.nan)
        gamma = f.pair_half_angle(K=possible, z_max=z_max)
        b = f.pair_length(z_max=z_max, q=f.pair_ratio(gamma=gamma))
        masses = 2 * s.sector_mass(rho=rho, A=s.sector_area(gamma=gamma, R=R, r_0=r_0), b=b)
        return np.where(K == 0, 0.0, masses)


def masses(U: complex, P: complex, rho: Num, R: Num, r_0: Num, z_max: Num) -> Array:
    """The mass of both sectors for a force as well: unbalance U [kg·m], product P [kg·m²], of the sectors alone;
    arrays of one axis, or numbers.

    NaN where the envelope is too small.  U and P are one task, or as many as there are envelopes; a pure couple takes
    the closed form."""
    if np.all(np.abs(U) * z_max <= DUST * np.abs(P)):
        return pair_masses(np.abs(P), 1.0, rho, R, r_0, z_max)
    with untraced():
        k = np.asarray(f.unbalance_per_length(rho=rho, R=R, r_0=r_0))
    alpha, product = np.asarray(U / (k * z_max)), np.asarray(P / (k * z_max**2))
    front, rear, _ = lengths.lengths(alpha, product)
    amount = lengths.amount(lengths.task(alpha, product), front, rear)
    return rho * (R**2 - r_0**2) * z_max * np.where(np.isnan(front), np.nan, amount)


def size(
    U: PhasorKilogramMetre,
    P: PhasorKilogramMetre2,
    omega: RadPerSecond,
    rho: KilogramPerMetre3,
    R: Metre,
    r_0: Metre,
    z_max: Metre,
    extras: tuple[Extra, ...] = (),
    fillet: Metre = 0.0,
) -> Sized:
    """The lightest two sectors that, with the extras, have the unbalance U and the product of unbalance and position P;
    a gap between them that does not hold two fillets is closed where the sectors serve at their full length.

    U = F/ω² and P = C/ω² of the whole shaft.  Raises TooSmall where the envelope can not hold them, NoSolution where
    nothing is asked."""
    U, P = remainder(U, P, extras)
    with untraced():
        k = f.unbalance_per_length(rho=rho, R=R, r_0=r_0)
    needed(U, P, k, z_max)
    room = Room(omega, rho, R, r_0, z_max, fillet)
    return _of_pair(P, room) if abs(U) * z_max <= DUST * abs(P) else _of_search(U, P, room)


def needed(U: PhasorKilogramMetre, P: PhasorKilogramMetre2, k: Kilogram, z_max: Metre) -> None:
    """Raises NoSolution where nothing is asked of the sectors."""
    if max(abs(U), abs(P) / z_max) <= DUST * k * z_max:
        raise NoSolution(
            Text("there is nothing for the sectors to balance"),
            Text("force and couple asked of the shaft, less its further elements"),
            Text("leave the counter-shaft out, or the further elements that do all its work"),
        )


def remainder(U: PhasorKilogramMetre, P: PhasorKilogramMetre2, extras: tuple[Extra, ...]) -> Asked:
    """What is left for the sectors once the further elements have done their part."""
    if not extras:
        return U, P
    m, e, gamma, z = (column(extras, name) for name in ("mass", "radius", "angle", "z"))
    U_x = f.extra_unbalance(m=m, e=e, gamma=gamma)
    P_x = f.extra_product(m=m, e=e, z=z, gamma=gamma)
    return f.unbalance_left(U=U, U_x=U_x), f.product_left(P=P, P_x=P_x)


def _of_pair(P: PhasorKilogramMetre2, room: Room) -> Sized:
    with about(Text("sectors")):
        C = f.couple_asked(P=P, omega=room.omega)
        half = pair(C, room.omega, room.rho, room.R, room.r_0, room.z_max, room.fillet)
        rear = f.couple_direction(P=P)
        common = dict(length=half.length, half_angle=half.half_angle, mass=half.mass, radius=half.radius)
        return Sized(
            mass=f.both_masses(m_f=half.mass, m_r=half.mass),
            utilisation=half.utilisation,
            sector_length=half.length,
            sector_half_angle=half.half_angle,
            couple=half.couple,
            outer_radius=room.R,
            core_radius=room.r_0,
            front=SizedSector(**common, angle=f.opposite(angle=rear), z=f.front_place(b=half.length, z_max=room.z_max)),
            rear=SizedSector(**common, angle=rear, z=f.rear_place(b=half.length, z_max=room.z_max)),
        )


def _of_search(U: PhasorKilogramMetre, P: PhasorKilogramMetre2, room: Room) -> Sized:
    z_max = room.z_max
    with about(Text("sectors")):
        k = f.unbalance_per_length(rho=room.rho, R=room.R, r_0=room.r_0)
        alpha, product = f.force_number(U=U, k=k, z_max=z_max), f.product_number(P=P, k=k, z_max=z_max)
        u = f.utilisation(alpha=alpha, product=product)
        if u > 1:
            raise _too_small(alpha, product, u, k, room)
        b_f = f.front_length(alpha=alpha, product=product, z_max=z_max)
        b_r = f.rear_length(alpha=alpha, product=product, z_max=z_max)
        if too_narrow(2 * z_max - b_f - b_r, room.fillet) and lengths.serves_whole(alpha, product):
            b_f = b_r = f.closed_length(z_max=z_max)
        z_f, z_r = f.front_place(b=b_f, z_max=z_max), f.rear_place(b=b_r, z_max=z_max)
        U_r = f.rear_unbalance(P=P, z_f=z_f, U=U, z_r=z_r)
        U_f = f.front_unbalance(U=U, U_r=U_r)
    front = sector("front", U_f, b_f, z_f, k, room)
    rear = sector("rear", U_r, b_r, z_r, k, room)
    return Sized(
        mass=f.both_masses(m_f=front.mass, m_r=rear.mass),
        utilisation=u,
        outer_radius=room.R,
        core_radius=room.r_0,
        front=front,
        rear=rear,
        sector_length=max(front.length, rear.length),
        sector_half_angle=max(front.half_angle, rear.half_angle),
    )


def sector(name: str, U: PhasorKilogramMetre, b: Metre, z: Metre, k: Kilogram, room: Room) -> SizedSector:
    if abs(U) <= DUST * k * room.z_max:  # the other one does all
        return SizedSector(length=0.0, half_angle=0.0, mass=0.0, radius=0.0, angle=0.0, z=z)
    with about(Text("{name} sector", name=name)):
        gamma = f.sector_half_angle(U=U, k=k, b=b)
        A = s.sector_area(gamma=gamma, R=room.R, r_0=room.r_0)
        S = s.sector_moment(gamma=gamma, R=room.R, r_0=room.r_0)
        return SizedSector(
            length=b,
            half_angle=gamma,
            mass=s.sector_mass(rho=room.rho, A=A, b=b),
            radius=s.centre_of_gravity(S=S, A=A),
            angle=f.direction(U=U),
            z=z,
        )


class Found(Protocol):
    """Sectors that were found for an envelope."""

    @property
    def by_name(self) -> dict[str, SizedSector]: ...
    @property
    def outer_radius(self) -> Metre: ...
    @property
    def core_radius(self) -> Metre: ...


def eccentric_masses(found: Found) -> tuple[EccentricMass, ...]:
    """The sectors as the eccentric masses of a shaft, by their names."""
    return tuple(
        EccentricMass(name=name, mass=sector.mass, radius=sector.radius, angle=sector.angle, z=sector.z)
        for name, sector in found.by_name.items()
    )


def pieces(found: Found) -> list[Piece]:
    """The sectors as pieces of the outline; one without mass is left out."""
    sectors = []
    for name, one in found.by_name.items():
        if one.mass:
            counted = Text("sector {number}", number=name) if name.isdigit() else Text("{name} sector", name=name)
            faces = around(one.z, one.length, counted)
            sectors.append(Piece(*faces, found.outer_radius, found.core_radius, one.half_angle, one.angle, "sector"))
    return sectors


# --- where it does not fit


def _too_small(alpha: PhasorNumber, product: PhasorNumber, u: Number, k: Kilogram, room: Room) -> TooSmall:
    """With a force there is no closed form: each answer is where the utilisation comes to 1."""
    z_max, omega = room.z_max, room.omega
    with untraced():
        far = 2.0
        while _load(alpha / far, product / far**2) > 1:
            far *= 2
        longer = root(lambda x: _load(alpha / x, product / x**2) - 1, 1.0, far)
        missing = None
        if _load(alpha, 0j) < 1:
            missing = root(lambda x: _load(alpha, product * (1 - x)) - 1, 0.0, 1.0) * abs(product) * k * z_max**2
    force, couple = abs(alpha) * k * z_max * omega**2, abs(product) * k * z_max**2 * omega**2
    return _refusal(u, in_words(force, couple, z_max), None, longer * z_max, missing, room)


def in_words(force: Newton, couple: NewtonMetre, z_max: Metre) -> Text:
    """What is asked of the sectors."""
    newton, newton_metre = Amount(force, form=".4g"), Amount(couple, form=".4g")
    if force * z_max <= DUST * couple:
        return Text("a couple of {c} N·m", c=newton_metre)
    if couple <= DUST * force * z_max:
        return Text("a force of {force} N", force=newton)
    return Text("a force of {force} N with a couple of {couple} N·m", force=newton, couple=newton_metre)


def _load(alpha: PhasorNumber, product: PhasorNumber) -> float:
    return float(lengths.utilisation(alpha, product)[0])


def _refusal(
    u: Number, asked: Text, most: NewtonMetre | None, length: Metre, product: KilogramMetre2 | None, room: Room
) -> TooSmall:
    """`most`: the couple that the envelope holds; `length`: the half-length needed.  The advice is rounded up: with it
    it does fit."""
    radius = f.radius_needed(R=room.R, r_0=room.r_0, u=u)
    reach = Amount(most, "N·m", form=".1f") if most is not None else share_of_that(u)
    tried = Text(
        "two sectors from {r_0} to {r} mm up to ±{z_max} mm, half-angle up to 90°",
        r_0=Amount(room.r_0 * 1000.0, form="g"),
        r=Amount(room.R * 1000.0, form="g"),
        z_max=Amount(room.z_max * 1000.0, form="g"),
    )
    error = too_small(u, asked, reach, tried, larger(radius, length, product))
    error.possible_couple = most
    error.outer_radius, error.half_length, error.product = radius, length, product
    return error


def larger(radius: Metre, length: Metre, product: KilogramMetre2 | None) -> list[Text]:
    """What would help, each alone."""
    ways = [Text("an outer radius of {up} mm at this core and length", up=up(radius * 1000.0, 2))]
    ways.append(Text("a half-length of {up} mm at this radius", up=up(length * 1000.0, 1)))
    if product is not None:
        ways.append(
            Text(
                "further elements (extras) that bring {up} kg·mm² of unbalance times distance in its direction",
                up=up(product * 1000000.0, 1),
            )
        )
    return ways


def share_of_that(u: Number) -> Text:
    """What the envelope holds of what is asked."""
    return Text("{u} % of that", u=Amount(100 / u, form=".1f"))


def too_small(u: Number, asked: Text, reach: Amount | Text, tried: Text, ways: list[Text]) -> TooSmall:
    """The refusal in words; the sizes that would help are the caller's to add."""
    what = Text(
        "{asked} does not fit into the envelope: it holds {reach} at most (utilisation {u})",
        asked=asked,
        reach=reach,
        u=Amount(u, form=".3f"),
    )
    error = TooSmall(what, tried, Text("it takes {ways}", ways=Text(", or ").join(ways)))
    error.possible = 1 / u
    return error


def up(x: float, digits: int) -> str:
    """A size that would be enough, rounded up."""
    return f"{math.ceil(x * 10**digits * (1 - 1e-12)) / 10**digits:.{digits}f}"


# --- what the shaft has to take: of the order of its speed, the vectors of the engine that turn like it

LEFT_OVER = 0.05  # share of the couple to be balanced that a good shaft may leave
WORDS = {1: Text("First"), 2: Text("Second")}


@record
class ShaftTask:
    """The engine's vectors of one order, cylinder 1 at TDC: those that turn like the shaft, and those that turn against
    it.

    `one_force`, `one_couple`: m·r·ω² of one cylinder, and over one pitch, by which what is left is judged.
    """

    order: int
    F: complex
    C: complex
    F_against: complex
    C_against: complex
    one_force: Newton
    one_couple: NewtonMetre

    @property
    def may_leave(self) -> NewtonMetre:
        """The couple that a good shaft may leave: a share of the one to be balanced, or of m·r·ω²·a where there is
        none."""
        whole = self.couple or self.one_couple
        return based_on(LEFT_OVER * whole, whole)

    @property
    def force_may_be_left(self) -> Newton:
        """The force that it may leave, or bring in."""
        return based_on(LEFT_OVER * self.one_force, self.one_force)

    @property
    def out_of_reach(self) -> frozenset[str]:
        """Of couple and force those of which more turns against the shaft than may be left: no mass of a single shaft
        takes it."""
        against = (("couple", self.C_against, self.may_leave), ("force", self.F_against, self.force_may_be_left))
        return frozenset(word for word, vector, limit in against if abs(vector) > limit)

    @property
    def couple(self) -> NewtonMetre:
        """The couple that a shaft must supply to leave nothing of what turns like it."""
        return based_on(abs(self.C), self.C)


def task(ratio: Number, imbalance: ImbalanceResult, beside: Sequence[SystemShaft] = ()) -> ShaftTask:
    """The task of a shaft at `ratio` times crank speed: what the shafts `beside` it leave of the engine's vectors."""
    order = round(abs(ratio))
    engine = OrderVectors(*imbalance.orders[f"order_{order}"].vectors)
    if beside := [shaft for shaft in beside if shaft.order == order]:
        engine = left(engine, beside, Text("shafts that are given"))
    (F_f, F_b), (C_f, C_b) = engine.forces, engine.couples
    if ratio < 0:
        return ShaftTask(order, F_b, C_b, F_f, C_f, imbalance.one_force, imbalance.one_couple)
    return ShaftTask(order, F_f, C_f, F_b, C_b, imbalance.one_force, imbalance.one_couple)
