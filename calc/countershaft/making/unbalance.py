# SPDX-License-Identifier: Apache-2.0
"""Calibration holes and balance quality: what drilling takes off the shaft's couple, and what unbalance may stay.

Radial holes are drilled into the eccentric masses.  Drilling only takes away, so a shaft that is to be calibrated is
made stronger than it has to be, by half of what drilling can take."""

import math
from collections.abc import Callable, Iterator
from itertools import pairwise

from ...draw.drawing import TOUCH
from ...library.tolerances import ISO, grade_number
from ...sheet.arrays import Array
from ...sheet.check import Check, CheckRule
from ...sheet.formula import formula
from ...sheet.functions import largest, modulus, smallest, total
from ...sheet.quantity import dotted, result, value
from ...sheet.remedy import Remedy, by_key, down
from ...sheet.shown import Shown
from ...sheet.step import Table
from ...sheet.text import Amount, Text
from ...sheet.units import (
    UNITS,
    Kilogram,
    KilogramMetre,
    KilogramPerMetre3,
    Metre,
    MetrePerSecond,
    Metres,
    NewtonMetre,
    Number,
    RadPerSecond,
)
from ...sheet.value import about, based_on, untraced
from ..balancing.hole import bottom_radius, cone_length, drill_radius, hole_mass, hole_unbalance, mean_surface
from ..balancing.inputs import POINT
from ..inputs import Holes, ShaftInputs
from ..outline import Piece
from ..rows import SHAFT


@result
class HolesResult(Shown):
    """What one hole takes away, and all of them at full depth together."""

    hole_mass: Kilogram = value("Mass removed by one calibration hole", "g", "m_c")
    hole_centroid_radius: Metre = value("Radius of its centre of gravity", "mm", "e_c")
    hole_unbalance: KilogramMetre = value("Unbalance removed by one hole", "g·mm", "ΔU")
    hole_couple: NewtonMetre = value("Couple removed by one hole", "N·m", "ΔC")
    hole_unbalance_of_mass: KilogramMetre = value("Unbalance that drilling can take off each mass", "g·mm", "ΔU_m")
    hole_range: NewtonMetre = value("Couple that all holes together can take", "N·m", "ΔC_c", short=True)
    hole_range_share: Number | None = value("its share of the required couple", "%", "q_c", default=None)
    hole_overdesign: Number | None = value(
        "Couple beyond the required one that drilling needs", "%", "x_c", default=None
    )


@formula("e_c", "definition: unbalance of a hole over its mass", unit="mm", names={"U": "ΔU"})
def hole_centroid_radius(U: KilogramMetre, m_c: Kilogram) -> Metre:
    return U / m_c


@formula(
    "z_m",
    "mathematics: mean distance of the eccentric masses from mid-shaft",
    unit="mm",
    names={"n": "n_h"},
    meanings={"z": "Places of the eccentric masses", "n": "Number of holes"},
)
def mean_arm(z: Metres, n: Number) -> Metre:
    return total(modulus(z)) / n


@formula(
    "ΔC", "dynamics: couple of a hole's unbalance at the mean arm of the masses", names={"U": "ΔU", "omega": "ω_S"}
)
def hole_couple(U: KilogramMetre, z_m: Metre, omega: RadPerSecond) -> NewtonMetre:
    return U * z_m * omega**2


@formula(
    "ΔU_m",
    "rule of this program: the holes are shared evenly by the n eccentric masses",
    unit="g·mm",
    names={"U": "ΔU", "n": "n_h"},
    meanings={"n": "Number of holes"},
)
def unbalance_of_mass(N_c: Number, U: KilogramMetre, n: Number) -> KilogramMetre:
    return N_c / n * U


@formula("ΔC_c", "mathematics: all holes at full depth", names={"C": "ΔC"})
def hole_range(N_c: Number, C: NewtonMetre) -> NewtonMetre:
    return N_c * C


@formula(
    "q_c",
    "definition: range of the holes over the required couple",
    unit="%",
    names={"C_c": "ΔC_c"},
    meanings={"C_S": "Couple of the shaft"},
)
def range_share(C_c: NewtonMetre, C_S: NewtonMetre) -> Number:
    return C_c / C_S


@formula(
    "x_c",
    "rule of this program: half of the range, so that drilling reaches as far below as above",
    unit="%",
    names={"q": "q_c"},
)
def needed_overdesign(q: Number) -> Number:
    return q / 2


def calibration(
    holes: Holes, rho: KilogramPerMetre3, R_outer: Metre, z: Array, omega: RadPerSecond, C_required: NewtonMetre
) -> HolesResult:
    """What the holes take from masses at `z`, of outer radius `R_outer`, on a shaft that turns at `omega`.

    `C_required`: modulus of the couple that the shaft must supply; 0 leaves the shares out.
    """
    n = float(z.size)
    with about(Text("calibration holes")):
        a_c = drill_radius(d=holes.diameter)
        l_c, q_c = cone_length(a=a_c, theta=POINT), bottom_radius(R=R_outer, h=holes.depth)
        m_c = hole_mass(rho=rho, a=a_c, R_m=mean_surface(R=R_outer, a=a_c), q=q_c, l=l_c)
        unbalance = hole_unbalance(rho=rho, a=a_c, R=R_outer, q=q_c, l=l_c)
        e_c = hole_centroid_radius(U=unbalance, m_c=m_c)
        couple = hole_couple(U=unbalance, z_m=mean_arm(z=z, n=n), omega=omega)
        whole = hole_range(N_c=holes.count, C=couple)
        share = range_share(C_c=whole, C_S=C_required) if C_required else None
        return HolesResult(
            hole_mass=m_c,
            hole_centroid_radius=e_c,
            hole_unbalance=unbalance,
            hole_couple=couple,
            hole_unbalance_of_mass=unbalance_of_mass(N_c=holes.count, U=unbalance, n=n),
            hole_range=whole,
            hole_range_share=share,
            hole_overdesign=needed_overdesign(q=share) if share is not None else None,
        )


DEPTH = dotted(SHAFT, ShaftInputs.holes, Holes.depth)
DIAMETER = dotted(SHAFT, ShaftInputs.holes, Holes.diameter)
HOLES_DEPTH = CheckRule(
    "countershaft.holes.depth",
    "limit",
    "The holes run into the core.",
    Text("Depth of the calibration holes"),
    "<=",
    "mm",
    Text("geometry: height of the sectors over the core"),
    Text("More or wider holes take the rest."),
    role="physics",
    zero="outer radius",
    moved_by=(DEPTH, dotted(SHAFT, ShaftInputs.core_radius)),
)
HOLES_ROW = CheckRule(
    "countershaft.holes.row",
    "limit",
    "The holes do not fit beside each other.",
    Text("Length of the holes of a mass, side by side"),
    "<=",
    "mm",
    Text("rule of this program: holes stand in one row along the sector"),
    Text("Fewer or narrower holes."),
    role="physics",
    moved_by=(dotted(SHAFT, ShaftInputs.holes, Holes.count), DIAMETER),
)
HOLES_WIDTH = CheckRule(
    "countershaft.holes.width",
    "limit",
    "The hole breaks out of the side of its sector.",
    Text("Diameter of a hole in the width of its sector"),
    "<=",
    "mm",
    Text("geometry: width of the sector at the bottom of the hole"),
    Text("Shorter holes have more room as well."),
    role="physics",
    zero="diameter of the hole",
    moved_by=(DIAMETER, DEPTH),
)
HOLES_RANGE = CheckRule(
    "countershaft.holes.range",
    "caution",
    "A shaft that lies exactly, but outside what drilling reaches, can not be corrected when it is made.",
    Text("Couple beyond the required one, for drilling to take away"),
    "in",
    "N·m",
    Text(
        "mathematics, drilling only takes away: the shaft as drawn must lie above the couple to be balanced, by no "
        "more than the holes take"
    ),
    moved_by=(
        dotted(SHAFT, ShaftInputs.overdesign),
        dotted(SHAFT, ShaftInputs.masses),
        DEPTH,
    ),
)


def hole_checks(
    holes: Holes,
    R: Metre,
    core_radius: Metre | None,
    masses: int,
    sectors: list[Piece],
    drilled: HolesResult,
    over: NewtonMetre | None,
) -> Iterator[Check]:
    """Whether the holes end in the sectors, which reach from the core out to R, have room in them and take what is too
    much.  `over`: the couple of the shaft as drawn beyond the required one; None where none is required."""

    def no_larger(field: object, length: Metre) -> Callable[[], tuple[Remedy, ...]]:
        return by_key(Holes, dotted(SHAFT, ShaftInputs.holes, field), down(length), bound="<=")

    if core_radius is not None:  # a deeper hole weakens the core, which alone carries the shaft between the sectors
        height = R - core_radius
        yield HOLES_DEPTH(holes.depth, height, scale=R, remedies=no_larger(Holes.depth, height))
    if sectors and masses:
        yield HOLES_ROW(math.ceil(holes.count / masses) * holes.diameter, _shortest(sectors))
        half_angle = min(sector.half_angle for sector in sectors if sector.half_angle is not None)
        chord = 2 * max(R - holes.depth, 0.0) * math.sin(min(half_angle, math.pi / 2))
        less = no_larger(Holes.diameter, chord)
        yield HOLES_WIDTH(holes.diameter, chord, scale=holes.diameter, remedies=less)
    if over is not None:
        aim = Amount(drilled.hole_range / 2, form=".1f")
        advice = Text("Aim at {hole_range} N·m beyond, half of the range.", hole_range=aim)
        yield HOLES_RANGE(based_on(round(over, 9), over), (0.0, drilled.hole_range), advice=advice)


def _shortest(sectors: list[Piece]) -> Metre:
    """The length of the shortest sector; those that touch and stand at one angle are one."""
    lengths = [sectors[0].length]
    for before, piece in pairwise(sectors):
        if abs(piece.start - before.end) < TOUCH and piece.angle == before.angle:
            lengths[-1] += piece.length
        else:
            lengths.append(piece.length)
    return min(lengths)


# --- the residual unbalance of a balance quality grade, ISO 21940-11, and the couple that it may leave
# It applies to the deviation of a finished shaft from its drawing: a balance shaft is out of balance on purpose.  The
# tolerance planes are the outer bearings.

PLANES = Text("{iso}, allocation to the tolerance planes", iso=ISO)
TABLED = ("G2.5", "G6.3", "G16", "G40")
LEAST = 0.3  # of U_per, the smaller share of a plane
MOST_INBOARD, MOST_OUTBOARD = 0.7, 1.3  # the larger one: centre of gravity between the planes, beyond one of them


@result
class ToleranceResult(Shown):
    """What the grade permits in all, in each bearing plane, and as an error of the couple."""

    residual_unbalance_permitted: KilogramMetre = value("Permitted residual unbalance", "g·mm", "U_per", short=True)
    residual_unbalance_permitted_front: KilogramMetre = value(
        "in the plane of the front bearing", "g·mm", "U_per,f", short=True
    )
    residual_unbalance_permitted_rear: KilogramMetre = value(
        "in the plane of the rear bearing", "g·mm", "U_per,r", short=True
    )
    permitted_couple_error: NewtonMetre = value(
        "Couple of both planes' permitted unbalance, opposed", "N·m", "C_per", short=True
    )
    permitted_couple_error_share: Number | None = value("its share of the required couple", "%", "q_per", default=None)


# held against the couple that may be left over
BALANCE_GRADE = CheckRule(
    "countershaft.balance_grade",
    "caution",
    "A shaft at the end of its balance quality leaves more couple than the drawing may.",
    Text("Couple that the balance quality grade permits"),
    "<=",
    "N·m",
    Text("rule of this program: 5 % of the couple to be balanced"),
    Text("A finer grade (a smaller number), or a lighter shaft."),
    demand=True,
    value_id=dotted("countershaft", ToleranceResult.permitted_couple_error),
    moved_by=(dotted(SHAFT, ShaftInputs.balance_grade),),
    proven=(),
)


@formula(
    "U_per",
    Text("{iso}: permissible residual unbalance, from G = e_per·ω", iso=ISO),
    unit="g·mm",
    names={"G": "G_Q", "omega": "ω_S"},
)
def shaft_unbalance(G: MetrePerSecond, m_S: Kilogram, omega: RadPerSecond) -> KilogramMetre:
    return G * m_S / omega


@formula(
    "q_f",
    Text("{planes}: share of the front plane, that of the static load of its bearing", planes=PLANES),
    meanings={"z_S": "Place of the centre of gravity"},
)
def lever_front(z_r: Metre, z_S: Metre, z_f: Metre) -> Number:
    return modulus(z_r - z_S) / (z_r - z_f)


@formula(
    "q_r",
    Text("{planes}: share of the rear plane, that of the static load of its bearing", planes=PLANES),
    meanings={"z_S": "Place of the centre of gravity"},
)
def lever_rear(z_S: Metre, z_f: Metre, z_r: Metre) -> Number:
    return modulus(z_S - z_f) / (z_r - z_f)


@formula(
    "U_per,p",
    Text("{planes}: permitted unbalance of a plane, 0.3 to 0.7 of U_per (to 1.3 near an overhung mass)", planes=PLANES),
    unit="g·mm",
    names={"U": "U_per", "q": "x_U", "q_max": "x_U,max"},
    meanings={"q": "Share of the plane", "q_max": "Largest share of a plane"},
)
def plane_unbalance(U: KilogramMetre, q: Number, q_max: Number) -> KilogramMetre:
    return U * smallest(largest(q, LEAST), q_max)


@formula(
    "C_per",
    "mathematics: both planes at their limit and opposed, about mid-shaft",
    names={"U_f": "U_per,f", "U_r": "U_per,r", "omega": "ω_S"},
)
def couple_error(U_f: KilogramMetre, z_f: Metre, U_r: KilogramMetre, z_r: Metre, omega: RadPerSecond) -> NewtonMetre:
    """The largest couple of two unbalances of free direction; for bearings at equal distances U_per/2 times the
    span."""
    return omega**2 * (U_f * modulus(z_f) + U_r * modulus(z_r))


@formula(
    "q_per",
    "definition: permitted error of the couple over the required couple",
    unit="%",
    meanings={"C_S": "Couple of the shaft"},
)
def error_share(C_per: NewtonMetre, C_S: NewtonMetre) -> Number:
    return C_per / C_S


def permitted(
    grade: str, mass: Kilogram, omega: RadPerSecond, z_S: Metre, z_f: Metre, z_r: Metre, C_required: NewtonMetre
) -> ToleranceResult:
    """What `grade` permits a shaft of that mass, its centre of gravity at `z_S`, in the planes of the outer bearings
    `z_f` < `z_r`.

    `C_required`: modulus of the couple that the shaft must supply; 0 leaves the share out.
    """
    most = MOST_INBOARD if z_f <= z_S <= z_r else MOST_OUTBOARD
    with about(Text("balance quality {grade}", grade=grade)):
        U = shaft_unbalance(G=grade_number(grade=grade), m_S=mass, omega=omega)
    with about(Text("balance quality {grade}, front bearing", grade=grade)):
        front = plane_unbalance(U=U, q=lever_front(z_r=z_r, z_S=z_S, z_f=z_f), q_max=most)
    with about(Text("balance quality {grade}, rear bearing", grade=grade)):
        rear = plane_unbalance(U=U, q=lever_rear(z_S=z_S, z_f=z_f, z_r=z_r), q_max=most)
    with about(Text("balance quality {grade}", grade=grade)):
        error = couple_error(U_f=front, z_f=z_f, U_r=rear, z_r=z_r, omega=omega)
        return ToleranceResult(
            residual_unbalance_permitted=U,
            residual_unbalance_permitted_front=front,
            residual_unbalance_permitted_rear=rear,
            permitted_couple_error=error,
            permitted_couple_error_share=error_share(C_per=error, C_S=C_required) if C_required else None,
        )


COLUMNS = (
    (Text("U_per"), "residual_unbalance_permitted", "g·mm"),
    (Text("front"), "residual_unbalance_permitted_front", "g·mm"),
    (Text("rear"), "residual_unbalance_permitted_rear", "g·mm"),
    (Text("couple error"), "permitted_couple_error", "N·m"),
    (Text("of the required"), "permitted_couple_error_share", "%"),
)


def table(
    grade: str, mass: Kilogram, omega: RadPerSecond, z_S: Metre, z_f: Metre, z_r: Metre, C_required: NewtonMetre
) -> Table:
    """The usual grades side by side, and the chosen one among them."""
    rows = []
    with untraced():
        for row_grade in sorted({*TABLED, grade}, key=grade_number):
            row = permitted(row_grade, mass, omega, z_S, z_f, z_r, C_required)
            label = Text("{one}, chosen", one=row_grade) if row_grade == grade else row_grade
            values = ((getattr(row, name), UNITS[unit].factor) for _, name, unit in COLUMNS)
            rows.append((label, *(None if number is None else number / factor for number, factor in values)))
    columns = ((Text("grade"), ""), *((label, unit) for label, _, unit in COLUMNS))
    note = Text(
        "Permitted deviation from the drawing, in all and in each bearing plane; couple error: both planes opposed."
    )
    return Table("balance_grades", Text("Balance quality grades"), columns, tuple(rows), note)


def notes(z_S: Metre, z_f: Metre, z_r: Metre) -> Iterator[Text]:
    """What is said about the grade, and where the centre of gravity is near a bearing or beyond one."""
    yield Text(
        "The balance quality grade is the designer's choice: the table of ISO 21940-11 does not list balance shafts."
    )
    if not z_f <= z_S <= z_r:
        yield Text(
            "The shaft's centre of gravity overhangs the {where} bearing: its plane is permitted up to 1.3 of U_per, "
            "as its bearing is made for that load, the other at least 0.3 (ISO 21940-11).",
            where=Text("rear") if z_S > z_r else Text("front"),
        )
    elif min(z_S - z_f, z_r - z_S) < LEAST * (z_r - z_f):
        yield Text(
            "The centre of gravity stands near one bearing: the planes share U_per 0.7 to 0.3, not as their loads "
            "(ISO 21940-11)."
        )
