# SPDX-License-Identifier: Apache-2.0
"""The shaft as a row of pieces, front to rear: what bends, what is drawn, what is weighed; and its cross-section.

The outline is given as sections, or put together from the eccentric masses (or the sized sectors), the core, the
journals and the gear."""

import math

import numpy as np

from ..draw.drawing import TOUCH
from ..sheet.arrays import Array, ComplexArray
from ..sheet.check import Check, CheckRule, Missing
from ..sheet.formula import formula
from ..sheet.functions import cis, cos, pi, resultant, sin
from ..sheet.linked_array import column, gathered, where
from ..sheet.quantity import dotted
from ..sheet.record import record
from ..sheet.text import Amount, Text
from ..sheet.units import (
    CubicMetre,
    Kilogram,
    KilogramMetre,
    KilogramMetre2,
    KilogramPerMetre3,
    Kilograms,
    Metre,
    Metre4,
    Metres,
    Metres4,
    Number,
    PhasorCubicMetre,
    PhasorCubicMetres,
    PhasorNewton,
    PhasorNewtonMetre,
    Radian,
    RadPerSecond,
    SquareMetre,
    SquareMetres,
)
from ..sheet.value import about, based_on, untraced
from .inputs import EccentricMass, ShaftInputs
from .rows import EACH_ROW, SHAFT, BearingRow

# --- the cross-section: a core of radius r_0 and on it a sector of half-angle γ out to the radius R
# Area and static moment are those of the sector alone, without the core; valid for 0 < γ ≤ π.  All formulas take
# arrays.

SECTOR = Text("geometry of the circular sector between the radii r_0 and R")


@formula("A", SECTOR, unit="mm²")
def sector_area(gamma: Radian, R: Metre, r_0: Metre) -> SquareMetre:
    """>>> sector_area(gamma=1.59, R=0.0405, r_0=0.015)
    0.002250247...
    """
    return gamma * (R**2 - r_0**2)


@formula("S", Text("{sector}: static moment of the sector about the axis", sector=SECTOR), unit="mm³")
def sector_moment(gamma: Radian, R: Metre, r_0: Metre) -> CubicMetre:
    """>>> sector_moment(gamma=1.336, R=0.043, r_0=0.018)
    4.776899...e-05
    """
    return 2 / 3 * sin(gamma) * (R**3 - r_0**3)


@formula("e", "geometry: centre of gravity of the sector from the axis", unit="mm")
def centre_of_gravity(S: CubicMetre, A: SquareMetre) -> Metre:
    """>>> centre_of_gravity(S=4.777e-05, A=0.002038)
    0.02343964...
    """
    return S / A


@formula("m", "geometry: mass of a sector of length b", unit="kg")
def sector_mass(rho: KilogramPerMetre3, A: SquareMetre, b: Metre) -> Kilogram:
    """>>> sector_mass(rho=7860, A=0.002038, b=0.1195)
    1.914232...
    """
    return rho * A * b


@formula("U", "geometry: unbalance of a sector of length b", unit="g·mm")
def sector_unbalance(rho: KilogramPerMetre3, S: CubicMetre, b: Metre) -> KilogramMetre:
    """>>> sector_unbalance(rho=7860, S=4.777e-05, b=0.1195)
    0.04486892...
    """
    return rho * S * b


@formula("A_tot", "geometry: sector and core", unit="mm²")
def whole_area(A: SquareMetre, r_0: Metre) -> SquareMetre:
    return A + pi * r_0**2


@formula(
    "ȳ",
    "geometry: centre of gravity of sector and core from the axis",
    unit="mm",
    meanings={"S": "Static moment of the sector about the axis"},
)
def whole_centre(S: CubicMetre, A_tot: SquareMetre) -> Metre:
    return S / A_tot


@formula(
    "I_sym",
    "geometry: second moment of sector and core about their own centre, bending in the plane of symmetry",
    unit="mm⁴",
    names={"y": "ȳ"},
)
def sector_inertia(R: Metre, r_0: Metre, gamma: Radian, A_tot: SquareMetre, y: Metre) -> Metre4:
    """The smaller of the two main second moments."""
    return (R**4 - r_0**4) / 4 * (gamma + sin(gamma) * cos(gamma)) + pi * r_0**4 / 4 - A_tot * y**2


@formula(
    "A",
    "geometry: full cylinder",
    unit="mm²",
    meanings={"R": "Radius of the cylinder", "return": "Area of a full cylinder"},
)
def cylinder_area(R: Metre) -> SquareMetre:
    return pi * R**2


@formula("I", "geometry: second moment of a full cylinder", unit="mm⁴", meanings={"R": "Radius of the cylinder"})
def cylinder_inertia(R: Metre) -> Metre4:
    return pi * R**4 / 4


@formula(
    "I_p",
    "geometry, polar moment of sector and core about the axis; a full cylinder: γ = π",
    unit="mm⁴",
    meanings={"R": "Radius of the cylinder", "gamma": "Half of the sector's angle"},
)
def polar_moment(gamma: Radian, R: Metre, r_0: Metre) -> Metre4:
    return gamma * (R**4 - r_0**4) / 2 + pi * r_0**4 / 2


# --- a bore along the whole shaft, and sectors of another density than the core

BORED = Text("geometry: less the bore along the whole shaft")
HEAVIER = Text("geometry: sectors of another density, as if of the core's")


@formula("A_b", BORED, unit="mm²")
def bored_area(A: SquareMetre, r_b: Metre) -> SquareMetre:
    return A - pi * r_b**2


@formula("I_b", Text("{bored}; of a section that bends about its own centre", bored=BORED), unit="mm⁴")
def bored_inertia(I: Metre4, r_b: Metre) -> Metre4:
    return I - pi * r_b**4 / 4


@formula("I_p,b", BORED, unit="mm⁴")
def bored_polar_moment(I_p: Metre4, r_b: Metre) -> Metre4:
    return I_p - pi * r_b**4 / 2


@formula("ν_ρ", HEAVIER, names={"rho_s": "ρ_s"})
def density_ratio(rho_s: KilogramPerMetre3, rho: KilogramPerMetre3) -> Number:
    return rho_s / rho


@formula("A_w", HEAVIER, unit="mm²", names={"nu": "ν_ρ"})
def weighing_area(A_tot: SquareMetre, A: SquareMetre, nu: Number) -> SquareMetre:
    """ν: density of the sectors over that of the core; A: of the sector alone."""
    return A_tot + (nu - 1) * A


@formula("S_w", HEAVIER, unit="mm³", names={"S": "S_γ", "nu": "ν_ρ"})
def weighing_moment(S: PhasorCubicMetre, nu: Number) -> PhasorCubicMetre:
    return nu * S


@formula("I_p,w", HEAVIER, unit="mm⁴", names={"nu": "ν_ρ"})
def weighing_polar_moment(I_p: Metre4, gamma: Radian, R: Metre, r_0: Metre, nu: Number) -> Metre4:
    return I_p + (nu - 1) * gamma * (R**4 - r_0**4) / 2


# --- the outline

Journals = tuple[tuple[Metre, Metre], ...]  # diameter and length of each, front to rear; empty where they are not known


def outer_face(positions: tuple[Metre, ...], journals: Journals) -> tuple[Metre, Metre]:
    """Of the outer two journals the one nearer to mid-shaft: how far from it its inner face stands, and its length."""
    ends = (0, -1)
    return min((abs(positions[n]) - journals[n][1] / 2, journals[n][1]) for n in ends)


PLAIN = 1e-9  # of the cubed radius: a static moment below it is none
# of the largest radius: a thinner piece joins nothing, and bending stiffnesses so far apart can not be reckoned with
THIN = 2e-3


@record
class Piece:
    """A stretch of the shaft of one section; `half_angle` None: a full cylinder.  `what`: journal, gear, core, sector,
    full."""

    start: Metre
    end: Metre
    outer_radius: Metre
    core_radius: Metre
    half_angle: Radian | None
    angle: Radian
    what: str

    @property
    def length(self) -> Metre:
        return based_on(self.end - self.start, self.end, self.start)


@record
class Outline:
    """The pieces of the shaft, touching one another, and their sections' properties, an element each.

    `inertia` is that of the full section in its weaker plane; `moment` the static moment S·e^{iγ} of what is eccentric.
    `heavier`: density of the sectors over that of the core; `weighing_area`, `weighing_moment`: of sections that weigh
    as much with the density of the core.  `bore`: the radius of a bore along the whole shaft.
    """

    pieces: tuple[Piece, ...]
    derived: bool
    area: Array
    inertia: Array
    moment: ComplexArray
    weighing_area: Array
    weighing_moment: ComplexArray
    bore: Metre = 0.0
    heavier: Number = 1.0

    @property
    def plain(self) -> bool:
        """Whether nothing of it is eccentric: the masses then stand on it as points."""
        largest = max(piece.outer_radius for piece in self.pieces)
        return bool(np.all(np.abs(self.moment) < PLAIN * largest**3))

    @property
    def start(self) -> Metre:
        return self.pieces[0].start

    @property
    def end(self) -> Metre:
        return self.pieces[-1].end


CORE = CheckRule(
    "countershaft.core",
    "limit",
    "Nothing joins the parts of the shaft.",
    unit="mm",
    source=Text("rule of this program: 0.2 % of the largest radius, below which nothing joins the shaft's parts"),
    advice=Text("A larger core."),
    role="physics",
    moved_by=(dotted(SHAFT, ShaftInputs.core_radius),),
)
MASS_SHAPE = CheckRule(
    "countershaft.mass_shape",
    "limit",
    "Without a shape nothing of the bending, a limit, can be judged.",
    sense="<",
    unit="mm",
    source=SECTOR,
    advice=Text(
        "Give the true shape as [[shafts.sections]], or a larger outer radius: nothing of its bending is judged."
    ),
    role="self",
    zero="outer radius",
    moved_by=(
        dotted(SHAFT, ShaftInputs.sections),
        dotted(SHAFT, ShaftInputs.outer_radius),
    ),
)
CROSSING = CheckRule(
    "countershaft.crossing",
    "limit",
    "Two pieces of one shaft can not be in one place.",
    sense="<=",
    unit="mm",
    source=Text("two pieces of one shaft stand side by side; each eccentric mass as a sector out to the outer radius"),
    advice=Text("Move them apart, widen the envelope, or give the true shape as [[shafts.sections]]."),
    role="chosen",
    exact=True,
    zero="length of the shorter piece",
    moved_by=(
        dotted(SHAFT, ShaftInputs.masses),
        dotted(SHAFT, ShaftInputs.outer_radius),
        dotted(EACH_ROW, BearingRow.diameter),
        dotted(EACH_ROW, BearingRow.length),
    ),
)


class NoOutline(Exception):
    """Why the shaft can not be drawn from what is known; `broken`: the check that fails where it is no shaft at all."""

    def __init__(self, reason: Text, broken: Check | None = None) -> None:
        super().__init__(reason)
        self.reason, self.broken = reason, broken


@formula(
    "m_S",
    "mathematics: sum over the pieces of the shaft",
    unit="kg",
    meanings={"rho": "Density", "A": "Areas of the pieces"},
)
def pieces_mass(rho: KilogramPerMetre3, A: SquareMetres, l: Metres) -> Kilogram:
    return rho * resultant(A * l)


@formula(
    "z_S",
    "geometry: centre of gravity of the pieces",
    unit="mm",
    meanings={"rho": "Density", "A": "Areas of the pieces"},
)
def pieces_centre(rho: KilogramPerMetre3, A: SquareMetres, l: Metres, z: Metres, m_S: Kilogram) -> Metre:
    return rho * resultant(A * l * z) / m_S


@formula("m_S", "mathematics: sum over the pieces of the shaft and its further elements", unit="kg", names={"m": "m_i"})
def shaft_mass(rho: KilogramPerMetre3, A: SquareMetres, l: Metres, m: Kilograms) -> Kilogram:
    return rho * resultant(A * l) + resultant(m)


@formula(
    "z_S",
    "geometry: centre of gravity of the pieces and the further elements",
    unit="mm",
    names={"m": "m_i", "z_m": "z_i"},
)
def centre(
    rho: KilogramPerMetre3, A: SquareMetres, l: Metres, z: Metres, m: Kilograms, z_m: Metres, m_S: Kilogram
) -> Metre:
    return (rho * resultant(A * l * z) + resultant(m * z_m)) / m_S


@formula("J_S", "geometry: moment of inertia about the axis, of the pieces", unit="kg·mm²", meanings={"rho": "Density"})
def pieces_inertia(rho: KilogramPerMetre3, I_p: Metres4, l: Metres) -> KilogramMetre2:
    return rho * resultant(I_p * l)


@formula(
    "J_S",
    "geometry, moment of inertia about the axis: the pieces, and the further elements as points",
    unit="kg·mm²",
    names={"m": "m_i", "e": "e_i"},
)
def shaft_inertia(rho: KilogramPerMetre3, I_p: Metres4, l: Metres, m: Kilograms, e: Metres) -> KilogramMetre2:
    return rho * resultant(I_p * l) + resultant(m * e**2)


@formula("sin γ/γ", Text("{sector}: e over its value for a narrow sector", sector=SECTOR))
def narrowness(e: Metre, R: Metre, r_0: Metre) -> Number:
    return e * (R**2 - r_0**2) / (2 / 3 * (R**3 - r_0**3))


@formula("γ", Text("{sector}", sector=SECTOR), shows="γ from sin γ/γ, Newton", names={"t": "sin γ/γ"})
def half_angle(t: Number) -> Radian:
    """The half-angle of a sector, 0 < t < 1."""
    gamma = math.pi  # sin γ − t·γ bends down: from here each step stops short of its root
    while (nearer := gamma - (math.sin(gamma) - t * gamma) / (math.cos(gamma) - t)) < gamma:
        gamma = nearer
    return gamma


@formula("b", "geometry: length of a sector of that mass", unit="mm", meanings={"rho": "Density"})
def sector_length(m: Kilogram, rho: KilogramPerMetre3, A: SquareMetre) -> Metre:
    return m / (rho * A)


@formula("R", "geometry: half of the diameter", unit="mm", meanings={"d": "Diameter of the piece"})
def radius(d: Metre) -> Metre:
    return d / 2


@formula(
    "z_1",
    "geometry: front face of a stretch of length b around its middle",
    unit="mm",
    meanings={"b": "Length of the stretch"},
)
def front_face(z: Metre, b: Metre) -> Metre:
    return z - b / 2


@formula(
    "z_2",
    "geometry: rear face of a stretch of length b around its middle",
    unit="mm",
    meanings={"b": "Length of the stretch"},
)
def rear_face(z: Metre, b: Metre) -> Metre:
    return z + b / 2


@formula(
    "l",
    "geometry: length of each piece of the shaft",
    unit="mm",
    names={"z_1": "z_a", "z_2": "z_b"},
    meanings={"z_1": "Front ends of the pieces", "z_2": "Rear ends of the pieces"},
)
def lengths(z_1: Metre, z_2: Metre) -> Metre:
    return z_2 - z_1


@formula(
    "z",
    "geometry: middle of each piece of the shaft",
    unit="mm",
    names={"z_1": "z_a", "z_2": "z_b"},
    meanings={"z_1": "Front ends of the pieces", "z_2": "Rear ends of the pieces"},
)
def middles(z_1: Metre, z_2: Metre) -> Metre:
    return (z_1 + z_2) / 2


@formula(
    "z_G",
    "rule of this program: the gear stands ahead of the front journal, against it",
    unit="mm",
    names={"l": "l_f", "b": "b_G"},
    meanings={"l": "Length of the front journal"},
)
def gear_middle(z_f: Metre, l: Metre, b: Metre) -> Metre:
    return z_f - l / 2 - b / 2


@formula(
    "S_γ",
    "geometry: static moment of the sectors, each along its middle, cylinder 1 at TDC",
    unit="mm³",
    names={"gamma": "φ"},
    meanings={"gamma": "Directions of the eccentric masses"},
)
def directed_moment(S: CubicMetre, gamma: Radian) -> PhasorCubicMetre:
    return S * cis(gamma)


def around(z: Metre, b: Metre, what: Text) -> tuple[Metre, Metre]:
    """The faces of a stretch of the shaft, from its middle and its length."""
    with about(what):
        return front_face(z=z, b=b), rear_face(z=z, b=b)


def outline(pieces: tuple[Piece, ...], derived: bool, bore: Metre = 0.0, heavier: Number = 1.0) -> Outline:
    """Pieces with the properties of their sections; `bore`: radius of a bore along the whole shaft, `heavier`: density
    of the sectors over that of the core.  Raises NoOutline where one is too thin to join its neighbours."""
    thinnest, largest = (pick(pieces, key=lambda piece: piece.outer_radius) for pick in (min, max))
    if thinnest.outer_radius < THIN * largest.outer_radius:
        reason = Text(
            "{said} has a radius of {outer_radius} mm, too thin to join the shaft's parts",
            said=_stretch(thinnest),
            outer_radius=Amount(thinnest.outer_radius * 1000.0, form=".3g"),
        )
        name = Text("Radius of {said}", said=_stretch(thinnest))
        raise NoOutline(reason, CORE(thinnest.outer_radius, THIN * largest.outer_radius, name=name))
    if bore and (
        hollowed := [p for p in pieces if bore >= (p.outer_radius if p.half_angle is None else p.core_radius)]
    ):
        width = Amount(bore * 2000.0)
        raise NoOutline(Text("a bore of {width} mm leaves nothing of {said}", width=width, said=_stretch(hollowed[0])))
    sectors = np.array([p.half_angle is not None for p in pieces])
    R, r_0 = column(pieces, "outer_radius"), column(pieces, "core_radius")
    moment = np.zeros(len(pieces), dtype=complex)
    with about(Text("full sections of the shaft")):
        area = cylinder_area(R=R[~sectors])
        inertia = cylinder_inertia(R=R[~sectors])
        if bore:
            area, inertia = bored_area(A=area, r_b=bore), bored_inertia(I=inertia, r_b=bore)
    weighing: Array | None = None
    if sectors.any():
        gamma = gathered(p.half_angle for p in pieces if p.half_angle is not None)
        R, r_0 = R[sectors], r_0[sectors]
        with about(Text("sectors of the shaft")):
            A = sector_area(gamma=gamma, R=R, r_0=r_0)
            S = sector_moment(gamma=gamma, R=R, r_0=r_0)
            whole = whole_area(A=A, r_0=r_0)
            if bore:
                whole = bored_area(A=whole, r_b=bore)
            y = whole_centre(S=S, A_tot=whole)
            I = sector_inertia(R=R, r_0=r_0, gamma=gamma, A_tot=whole, y=y)
            if bore:
                I = bored_inertia(I=I, r_b=bore)
            if heavier != 1:
                weighing = where(sectors, weighing_area(A_tot=whole, A=A, nu=heavier), area)
            area = where(sectors, whole, area)
            inertia = where(sectors, I, inertia)
            moment = where(sectors, directed_moment(S=S, gamma=column(pieces, "angle")[sectors]), moment[~sectors])
    return Outline(
        pieces=pieces,
        derived=derived,
        area=area,
        inertia=inertia,
        moment=moment,
        weighing_area=area if weighing is None else weighing,
        weighing_moment=moment if heavier == 1 else weighing_moment(S=moment, nu=heavier),
        bore=bore,
        heavier=heavier,
    )


def given(shaft: ShaftInputs, heavier: Number = 1.0) -> Outline:
    """The outline of [[shafts.sections]]; `heavier`: density of the sectors over that of the core."""
    pieces = []
    for s in sorted(shaft.sections, key=lambda section: section.from_):
        what = "sector" if s.half_angle else "full"
        pieces.append(Piece(s.from_, s.to, s.outer_radius, s.core_radius or 0.0, s.half_angle, s.angle or 0.0, what))
    return outline(tuple(pieces), False, _bore(shaft), heavier)


def _bore(shaft: ShaftInputs) -> Metre:
    """The radius of its bore."""
    if not shaft.bore_diameter:
        return based_on(0.0, shaft.bore_diameter)
    with about(Text("bore of the shaft")):
        return radius(d=shaft.bore_diameter)


def sectors_of(masses: tuple[EccentricMass, ...], rho: KilogramPerMetre3, R: Metre, r_0: Metre) -> list[Piece]:
    """Sectors that have the mass, the centre of gravity and the place of the masses.  Raises NoOutline where one has no
    such sector."""
    sectors = []
    for mass in masses:
        if not mass.mass:
            continue
        subject = Text("sector of mass {name}", name=mass.name)
        with about(subject):
            t = narrowness(e=mass.radius, R=R, r_0=r_0)
            if not 0 < t < 1:
                raise _no_sector(mass, R, r_0, t)
            gamma = half_angle(t=t)
            b = sector_length(m=mass.mass, rho=rho, A=sector_area(gamma=gamma, R=R, r_0=r_0))
        sectors.append(Piece(*around(mass.z, b, subject), R, r_0, gamma, mass.angle, "sector"))
    return sectors


def _no_sector(mass: EccentricMass, R: Metre, r_0: Metre, t: Number) -> NoOutline:
    """`t`: sin γ/γ that the mass asks for."""
    most = mass.radius / t if t else 0.0
    within = Text(" (it stays below {radius} mm)", radius=Amount(most * 1000.0, form=".4g")) if t else ""
    place = Text("from {r_0} to {r} mm", r_0=Amount(r_0 * 1000.0, form="g"), r=Amount(R * 1000.0, form=".4g"))
    reason = Text(
        "mass {name}: no sector {place} has its centre of gravity at {radius} mm{within}",
        name=mass.name,
        place=place,
        radius=Amount(mass.radius * 1000.0, form="g"),
        within=within,
    )
    name = Text("Radius of the centre of gravity of mass {name}, as a sector", name=mass.name)
    shape = Missing((dotted(SHAFT, ShaftInputs.sections),), (SECTOR,), "holds", "none")
    return NoOutline(reason, MASS_SHAPE(mass.radius, most, name=name, scale=R, missing=shape))


def assembled(
    shaft: ShaftInputs,
    sectors: list[Piece],
    journals: Journals,
    gear: tuple[Metre, Metre] | None,
    heavier: Number = 1.0,
) -> Outline:
    """Sectors, journals and gear (diameter, length of each), joined by the core, with a stub around each overhung
    element that reaches as far beyond as before it.  A gear without a place stands ahead of the front journal, against
    it.  Raises NoOutline where two of them cross."""
    positions = shaft.bearing_positions
    solid = list(sectors)
    for n, (z, (d, l)) in enumerate(zip(positions, journals), 1):
        solid.append(_turned(z, d, l, "journal", Text("journal {n}", n=n)))
    if gear is not None:
        d, width = gear
        middle = shaft.gear_z if shaft.gear_z is not None else gear_middle(z_f=positions[0], l=journals[0][1], b=width)
        solid.append(_turned(middle, d, width, "gear", Text("gear on the shaft")))
    solid.sort(key=lambda piece: piece.start)

    start, end = solid[0].start, solid[-1].end
    for z in (extra.z for extra in shaft.extras):
        start, end = min(start, 2 * z - start), max(end, 2 * z - end)
    r_0 = shaft.core_radius or 0.0
    pieces: list[Piece] = []
    here = start
    for piece in solid:
        if piece.start < here - TOUCH:
            raise _crossing(pieces[-1], piece)
        if piece.start > here + TOUCH:
            pieces.append(Piece(here, piece.start, r_0, 0.0, None, 0.0, "core"))
        pieces.append(piece)
        here = piece.end
    if end > here + TOUCH:
        pieces.append(Piece(here, end, r_0, 0.0, None, 0.0, "core"))
    return outline(tuple(pieces), True, _bore(shaft), heavier)


def known(shaft: ShaftInputs, R: Metre | None, journals: Journals) -> tuple[Metre, Metre]:
    """Outer and core radius of the sectors.  Raises NoOutline where these or the journals are not known."""
    r_0 = shaft.core_radius
    if R is None or r_0 is None or not journals:
        needed = (
            (dotted(ShaftInputs.core_radius), r_0),
            (dotted(ShaftInputs.outer_radius), R),
            (Text("diameter and length of the bearings"), journals or None),
        )
        missing = Text(" and ").join([name for name, given in needed if given is None])
        raise NoOutline(Text("give [[shafts.sections]], or {missing}", missing=missing))
    return R, r_0


def _turned(z: Metre, d: Metre, l: Metre, what: str, subject: Text) -> Piece:
    with about(subject):
        return Piece(front_face(z=z, b=l), rear_face(z=z, b=l), radius(d=d), 0.0, None, 0.0, what)


def _crossing(first: Piece, second: Piece) -> NoOutline:
    name = Text("Overlap of {said} and {said2}", said=_stretch(first), said2=_stretch(second))
    shorter = min(first.length, second.length)
    overlap = CROSSING(min(first.end, second.end) - second.start, 0.0, name=name, scale=shorter)
    return NoOutline(Text("{said} crosses {said2}", said=_stretch(second), said2=_stretch(first)), overlap)


def _stretch(piece: Piece) -> Text:
    return Text(
        "the {what} from {start} to {end} mm",
        what=Text(piece.what),
        start=Amount(piece.start * 1000.0),
        end=Amount(piece.end * 1000.0),
    )


def extent(shape: Outline) -> tuple[Array, Array]:
    """Length and middle of each piece."""
    z_1, z_2 = column(shape.pieces, "start"), column(shape.pieces, "end")
    return lengths(z_1=z_1, z_2=z_2), middles(z_1=z_1, z_2=z_2)


def hollowed(shape: Outline, rho: KilogramPerMetre3, extras: tuple[EccentricMass, ...]) -> None:
    """Raises NoOutline where the further elements take away more than the pieces of the shaft have."""
    holes = [extra for extra in extras if extra.mass < 0]
    with untraced():
        there = weighed(shape, rho, ())[0], turning_inertia(shape, rho, ())
    taken = -sum(hole.mass for hole in holes), -sum(hole.mass * hole.radius**2 for hole in holes)
    for label, unit, less, whole in zip(
        (Text("Mass that is taken away"), Text("Moment of inertia that is taken away")),
        ("kg", "kg·mm²"),
        taken,
        there,
    ):
        if less >= whole:
            check = MASS_SHAPE(
                less,
                whole,
                name=label,
                unit=unit,
                source=Text("geometry: no hole takes away more than stands there"),
                advice=Text("Look at the mass and the radius of the further elements: below zero it is a hole's."),
                moved_by=(dotted(SHAFT, ShaftInputs.extras),),
            )
            words = dict(less=Amount(check.value, unit), limit=check.limit_text())
            raise NoOutline(Text("the further elements take away {less}, needs {limit}", **words), check)


def weighed(shape: Outline, rho: KilogramPerMetre3, extras: tuple[EccentricMass, ...]) -> tuple[Kilogram, Metre]:
    """Mass of the whole shaft and its centre of gravity along the axis."""
    A = shape.weighing_area
    l, z = extent(shape)
    m, z_m = column(extras, "mass"), column(extras, "z")
    if not extras:
        m_S = pieces_mass(rho=rho, A=A, l=l)
        return m_S, pieces_centre(rho=rho, A=A, l=l, z=z, m_S=m_S)
    m_S = shaft_mass(rho=rho, A=A, l=l, m=m)
    return m_S, centre(rho=rho, A=A, l=l, z=z, m=m, z_m=z_m, m_S=m_S)


def turning_inertia(shape: Outline, rho: KilogramPerMetre3, extras: tuple[EccentricMass, ...]) -> KilogramMetre2:
    """Moment of inertia of the whole shaft about its axis."""
    gamma = gathered(math.pi if piece.half_angle is None else piece.half_angle for piece in shape.pieces)
    l, _ = extent(shape)
    m, e = column(extras, "mass"), column(extras, "radius")
    R, r_0 = column(shape.pieces, "outer_radius"), column(shape.pieces, "core_radius")
    I_p = polar_moment(gamma=gamma, R=R, r_0=r_0)
    if shape.heavier != 1:
        nu = np.where([piece.half_angle is None for piece in shape.pieces], 1.0, shape.heavier)
        I_p = weighing_polar_moment(I_p=I_p, gamma=gamma, R=R, r_0=r_0, nu=nu)
    if shape.bore:
        I_p = bored_polar_moment(I_p=I_p, r_b=shape.bore)
    return shaft_inertia(rho=rho, I_p=I_p, l=l, m=m, e=e) if extras else pieces_inertia(rho=rho, I_p=I_p, l=l)


@formula("F_O", "dynamics: force of the pieces of the outline and the further elements", names={"omega": "ω_S"})
def outline_force(
    omega: RadPerSecond, rho: KilogramPerMetre3, S: PhasorCubicMetres, l: Metres, F_x: PhasorNewton
) -> PhasorNewton:
    return omega**2 * rho * resultant(S * l) + F_x


@formula(
    "C_O",
    "dynamics: couple of the pieces of the outline and the further elements, their unbalance times position",
    names={"omega": "ω_S"},
)
def outline_couple(
    omega: RadPerSecond, rho: KilogramPerMetre3, S: PhasorCubicMetres, l: Metres, z: Metres, C_x: PhasorNewtonMetre
) -> PhasorNewtonMetre:
    return omega**2 * rho * resultant(S * l * z) + C_x


def vectors_of(
    shape: Outline, rho: KilogramPerMetre3, omega: RadPerSecond, F_x: complex, C_x: complex
) -> tuple[complex, complex]:
    """Force and couple of the outline about mid-shaft, with those of the further elements."""
    S = shape.weighing_moment
    l, z = extent(shape)
    return outline_force(omega=omega, rho=rho, S=S, l=l, F_x=F_x), outline_couple(
        omega=omega, rho=rho, S=S, l=l, z=z, C_x=C_x
    )
