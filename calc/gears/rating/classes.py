# SPDX-License-Identifier: Apache-2.0
"""Strength classes of gears by ISO 6336-5: the stresses that a material endures, by its heat treatment, quality and
hardness.

The table stands in calc/library/tables/gear_materials.toml; only the row asked for is read.  The hardness is in
Vickers; classes that the standard gives in Brinell take 0.95 of it.  Above the range of its class a hardness adds
nothing (the line is read at its end); below the range the class does not hold, which a check says."""

import difflib
from collections.abc import Iterable
from functools import cache

from ...library.table_file import TableRow, parsed, text_of_table
from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.record import record
from ...sheet.text import Amount, Text
from ...sheet.units import UNITS, Metre, Number, Pascal
from ...sheet.value import about
from ..wheel_inputs import Wheel

FILE = "gear_materials.toml"
DEFAULT = "case-hardened"
TABLE_1 = Text("ISO 6336-5:2016, Table 1")
SURFACE_HARDENED = ("Eh", "IF", "NT(nitr.)", "NV(nitr.)", "NV(nitrocar.)")
THROUGH_HARDENED = ("St", "V")
HARDNESS = {"x": "x_H"}  # x in the standard; here that is the profile shift
MEGAPASCAL = UNITS["MPa"].factor


@formula(
    "HBW", "ISO 18265: HBW = 0.95·HV; so do, within 1, the pairs of ISO 898-1 from 120 to 435 HV", names={"HV": "HV"}
)
def brinell_hardness(HV: Number) -> Number:
    return 0.95 * HV


@formula(
    "σ_Hlim",
    Text("{table_1}: allowable stress number, contact; x_H: hardness", table_1=TABLE_1),
    unit="MPa",
    names=HARDNESS,
    meanings={
        "A": "Slope of the allowable stress over the hardness",
        "x": "Hardness of the flank",
        "B": "Allowable stress without hardness",
    },
)
def contact_number(A: Pascal, x: Number, B: Pascal) -> Pascal:
    return A * x + B


@formula(
    "σ_Flim",
    Text("{table_1}: allowable stress number, bending; x_H: hardness", table_1=TABLE_1),
    unit="MPa",
    names=HARDNESS,
    meanings={
        "A": "Slope of the allowable stress over the hardness",
        "x": "Hardness of the flank",
        "B": "Allowable stress without hardness",
    },
)
def bending_number(A: Pascal, x: Number, B: Pascal) -> Pascal:
    return A * x + B


@record
class StrengthClass:
    """A material as a gear: `x` is the hardness entered, `low` to `high` its range, all on `scale`; `hardness`: as
    given, HV.

    `brinell` is that of through-hardened classes and iron; of the others it is not asked.
    """

    name: str
    kind: str
    quality: str
    scale: str
    hardness: Number | None
    x: Number
    low: Number
    high: Number
    sigma_Hlim: Pascal
    sigma_Flim: Pascal
    brinell: Number
    proof_stress: Pascal | None
    slip_layer: Metre | None
    notes: tuple[Text, ...]

    @property
    def surface_hardened(self) -> bool:
        return self.kind in SURFACE_HARDENED

    @property
    def through_hardened(self) -> bool:
        return self.kind in THROUGH_HARDENED


@cache
def _rows() -> dict[str, str]:
    """The text of every row by its name, not yet parsed."""
    return {row.split('"')[1]: row for row in text_of_table(FILE).split("\n[[row]]")[1:]}


@cache
def _row(name: str) -> TableRow:
    return TableRow(parsed(FILE, _rows()[name]), FILE, f"row.{list(_rows()).index(name)}")


def class_names() -> tuple[str, ...]:
    """Every strength class that a wheel may name."""
    return tuple(_rows())


@cache
def classes_of(steel: str) -> tuple[str, ...]:
    """The classes that name a steel among their usual ones."""
    sought = steel.casefold()
    # the only rows that need be read
    likely = [name for name, text in _rows().items() if f'"{sought}"' in text.casefold()]
    return tuple(name for name in likely if sought in (s.casefold() for s in _row(name)["steels"]))


def strength_class(
    name: str | None = None, quality: str = "MQ", hardness: Number | None = None, proof_stress: Pascal | None = None
) -> StrengthClass:
    """The allowable stress numbers of a class.  `hardness` of the flank in HV; `proof_stress` of the very steel, if
    known.

    Left out: the class is case-hardened steel, the hardness the lowest of its range (rule of this program); the notes
    say so. Raises NoSolution where there is no such class."""
    notes: list[Text] = []
    if name is None:
        name = DEFAULT
        notes.append(Text("strength class not given; chosen: case-hardened steel, {quality}", quality=quality))
    if name not in _rows():
        raise _unknown(name)
    row = _row(name)
    scale, kind, proof, slip = row["scale"], row["kind"], row.get("proof_MPa"), row.get("slip_layer_mm")
    contact, bending = row[f"contact_{quality}"], row[f"bending_{quality}"]
    low, high = max(contact[0][2], bending[0][2]), min(contact[-1][3], bending[-1][3])
    x = low
    if hardness is not None:
        x = hardness if scale == "HV" else brinell_hardness(HV=hardness)
    elif any(A for A, *_ in contact + bending):
        notes.append(
            Text(
                "hardness not given; taken: the lowest of the class {name}, {low} {row} (rule of this program)",
                name=name,
                low=Amount(low, form="g"),
                row=scale,
            )
        )
    if x > high:
        notes.append(
            Text(
                "hardness {x} {row} is above the range of the class {name}; its stresses are those at {high}",
                x=Amount(x, form=".4g"),
                row=scale,
                name=name,
                high=Amount(high, form="g"),
            )
        )
    A_H, x_H, B_H = _line_at(contact, x)
    A_F, x_F, B_F = _line_at(bending, x)
    return StrengthClass(
        name=name,
        kind=kind,
        quality=quality,
        scale=scale,
        hardness=hardness,
        x=x,
        low=low,
        high=high,
        sigma_Hlim=contact_number(A=A_H, x=x_H, B=B_H),
        sigma_Flim=bending_number(A=A_F, x=x_F, B=B_F),
        brinell=x if scale == "HBW" or kind not in THROUGH_HARDENED else brinell_hardness(HV=x),
        proof_stress=None if proof is None else (proof_stress or proof * MEGAPASCAL),
        slip_layer=None if slip is None else slip * 1e-3,
        notes=tuple(notes),
    )


STEEL_E = (190e9, 225e9)  # Pa: a material as stiff as this is taken for steel


def of_wheel(wheel: Wheel, E: Pascal, proof_stress: Pascal | None = None) -> StrengthClass | None:
    """The class of a wheel of the design, its lines under the wheel's name; None: it gives none, and its material is
    not for the default.

    `E`: of its material.  A steel that the table names is taken for case-hardened only where that is one of its
    classes."""
    if wheel.gear_material is None:
        usual = classes_of(wheel.material)
        if DEFAULT not in usual if usual else not STEEL_E[0] <= E <= STEEL_E[1]:
            return None
    with about(Text("wheel {name}, strength class", name=wheel.name)):
        return strength_class(wheel.gear_material, wheel.quality, wheel.hardness, proof_stress)


def _line_at(lines: list[list[float]], x: Number) -> tuple[Pascal, Number, Pascal]:
    """A, x and B of the line that holds at a hardness; beyond the last line x is its end."""
    for A, B, _, end in lines:
        if x <= end:
            return A * MEGAPASCAL, x, B * MEGAPASCAL
    return A * MEGAPASCAL, end, B * MEGAPASCAL


def class_problem(name: str) -> Text | None:
    """Why a word is no strength class; None where it is one."""
    if name in class_names():
        return None
    why = _unknown(name)
    return Text("{tried}; {advice}", tried=why.tried, advice=why.advice)


def _unknown(name: str) -> NoSolution:
    what = Text('strength class "{name}"', name=name)
    if "adi" in name.casefold().replace("-", " ").split() or "austemper" in name.casefold():
        why = Text("austempered ductile iron is not among the materials of ISO 6336-5")
        advice = Text(
            "rate it by its maker's own fatigue data; for a first guess take a class that is surely weaker (nodular "
            "iron, pearlitic)"
        )
        return NoSolution(what, why, advice)
    if usual := classes_of(name):
        why = Text("it is a steel, not a class: its strength depends on the heat treatment")
        return NoSolution(what, why, Text("choose {or_}", or_=_or(usual)))
    near = difflib.get_close_matches(name, class_names()) or class_names()
    return NoSolution(what, Text("there is no such class"), Text("the nearest: {or_}", or_=_or(near)))


def _or(names: Iterable[str]) -> Text:
    return Text(" or ").join(f'"{name}"' for name in names)
