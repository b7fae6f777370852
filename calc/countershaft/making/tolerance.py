# SPDX-License-Identifier: Apache-2.0
"""The residual unbalance that a balance quality grade permits, ISO 21940-11, and the couple that it may leave.

It applies to the deviation of a finished shaft from its drawing: a balance shaft is out of balance on purpose.  The tolerance planes are
the outer bearings.
"""

from collections.abc import Iterator

from ...library.balance_quality import ISO, grade_number
from ...sheet.formula import formula
from ...sheet.functions import largest, modulus, smallest
from ...sheet.quantity import result, value
from ...sheet.step import Table
from ...sheet.text import Text
from ...sheet.trace import about, untraced
from ...sheet.units import UNITS, Kilogram, KilogramMetre, Metre, MetrePerSecond, NewtonMetre, Number, RadPerSecond

PLANES = Text("{iso}, allocation to the tolerance planes", iso=ISO)
TABLED = ("G2.5", "G6.3", "G16", "G40")
LEAST = 0.3  # of U_per, the smaller share of a plane
MOST_INBOARD, MOST_OUTBOARD = 0.7, 1.3  # the larger one: centre of gravity between the planes, beyond one of them


@result
class ToleranceResult:
    """What the grade permits in all, in each bearing plane, and as an error of the couple."""

    residual_unbalance_permitted: KilogramMetre = value("Permitted residual unbalance", "g·mm", "U_per")
    residual_unbalance_permitted_front: KilogramMetre = value("in the plane of the front bearing", "g·mm", "U_per,f")
    residual_unbalance_permitted_rear: KilogramMetre = value("in the plane of the rear bearing", "g·mm", "U_per,r")
    permitted_couple_error: NewtonMetre = value("Couple of both planes' permitted unbalance, opposed", "N·m", "C_per")
    permitted_couple_error_share: Number | None = value("its share of the required couple", "%", "q_per", default=None)


@formula("U_per", Text("{iso}: permissible residual unbalance, from G = e_per·ω", iso=ISO), unit="g·mm", names={"G": "G_Q", "omega": "ω_S"})
def shaft_unbalance(G: MetrePerSecond, m_S: Kilogram, omega: RadPerSecond) -> KilogramMetre:
    return G * m_S / omega


@formula("q_f", Text("{planes}: share of the front plane, that of the static load of its bearing", planes=PLANES))
def lever_front(z_r: Metre, z_S: Metre, z_f: Metre) -> Number:
    return modulus(z_r - z_S) / (z_r - z_f)


@formula("q_r", Text("{planes}: share of the rear plane, that of the static load of its bearing", planes=PLANES))
def lever_rear(z_S: Metre, z_f: Metre, z_r: Metre) -> Number:
    return modulus(z_S - z_f) / (z_r - z_f)


@formula("U_per,p", Text("{planes}: permitted unbalance of a plane, 0.3 to 0.7 of U_per (to 1.3 near an overhung mass)", planes=PLANES),
    unit="g·mm", names={"U": "U_per", "q": "x_U", "q_max": "x_U,max"})  # fmt: skip
def plane_unbalance(U: KilogramMetre, q: Number, q_max: Number) -> KilogramMetre:
    return U * smallest(largest(q, LEAST), q_max)


@formula(
    "C_per",
    "mathematics: both planes at their limit and opposed, about mid-shaft",
    names={"U_f": "U_per,f", "U_r": "U_per,r", "omega": "ω_S"},
)
def couple_error(U_f: KilogramMetre, z_f: Metre, U_r: KilogramMetre, z_r: Metre, omega: RadPerSecond) -> NewtonMetre:
    """The largest couple of two unbalances of free direction; for bearings at equal distances U_per/2 times the span."""
    return omega**2 * (U_f * modulus(z_f) + U_r * modulus(z_r))


@formula("q_per", "definition: permitted error of the couple over the required couple", unit="%")
def error_share(C_per: NewtonMetre, C_S: NewtonMetre) -> Number:
    return C_per / C_S


def permitted(grade: str, mass: Kilogram, omega: RadPerSecond, z_S: Metre, z_f: Metre, z_r: Metre,
    C_required: NewtonMetre) -> ToleranceResult:  # fmt: skip
    """What `grade` permits a shaft of that mass, its centre of gravity at `z_S`, in the planes of the outer bearings `z_f` < `z_r`.

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
        return ToleranceResult(residual_unbalance_permitted=U, residual_unbalance_permitted_front=front,
            residual_unbalance_permitted_rear=rear, permitted_couple_error=error,
            permitted_couple_error_share=error_share(C_per=error, C_S=C_required) if C_required else None)  # fmt: skip


def table(grade: str, mass: Kilogram, omega: RadPerSecond, z_S: Metre, z_f: Metre, z_r: Metre, C_required: NewtonMetre) -> Table:
    """The usual grades side by side, and the chosen one among them."""
    rows: list[tuple[str | float | None, ...]] = []
    gram, percent = UNITS["g·mm"].factor, UNITS["%"].factor
    with untraced():
        for row_grade in sorted({*TABLED, grade}, key=grade_number):
            r = permitted(row_grade, mass, omega, z_S, z_f, z_r, C_required)
            unbalances = (r.residual_unbalance_permitted, r.residual_unbalance_permitted_front, r.residual_unbalance_permitted_rear)
            share = r.permitted_couple_error_share
            label = Text("{one}, chosen", one=row_grade) if row_grade == grade else row_grade
            rows.append((label, *(U / gram for U in unbalances), r.permitted_couple_error, None if share is None else share / percent))
    columns = (
        (Text("grade"), ""), (Text("U_per"), "g·mm"), (Text("front"), "g·mm"), (Text("rear"), "g·mm"), (Text("couple error"), "N·m"),
        (Text("of the required"), "%"),
    )  # fmt: skip
    note = Text("Permitted deviation from the drawing, in all and in each bearing plane; couple error: both planes opposed.")
    return Table("balance_grades", Text("Balance quality grades"), columns, tuple(rows), note)


def notes(z_S: Metre, z_f: Metre, z_r: Metre) -> Iterator[Text]:
    """What is said about the grade, and where the centre of gravity is near a bearing or beyond one."""
    yield Text("The balance quality grade is the designer's choice: the table of ISO 21940-11 does not list balance shafts.")
    if not z_f <= z_S <= z_r:
        yield Text("The shaft's centre of gravity overhangs the {where} bearing: its plane is permitted up to 1.3 of U_per, "
            "as its bearing is made for that load, the other at least 0.3 (ISO 21940-11).",
            where=Text("rear") if z_S > z_r else Text("front"))  # fmt: skip
    elif min(z_S - z_f, z_r - z_S) < LEAST * (z_r - z_f):
        yield Text("The centre of gravity stands near one bearing: the planes share U_per 0.7 to 0.3, not as their loads (ISO 21940-11).")
