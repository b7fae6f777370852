# SPDX-License-Identifier: Apache-2.0
"""Strength classes of gears by ISO 6336-5: the stresses that a material endures, by its heat treatment, quality and hardness.

The table stands in calc/tables/gear_materials.toml; only the row asked for is read.  The hardness is in Vickers; classes that the standard
gives in Brinell take 0.95 of it.  Above the range of its class a hardness adds nothing (the line is read at its end); below the range the
class does not hold, which a check says.
"""

import tomllib
from collections.abc import Mapping
from functools import cache
from typing import TYPE_CHECKING, Any

from ...catalogue import TABLES
from ...sheet.check import Check, check
from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.record import record
from ...sheet.step import Table
from ...sheet.trace import about
from ...sheet.units import UNITS, Metre, Number, Pascal

if TYPE_CHECKING:
    from ..inputs import Wheel

FILE = "gear_materials.toml"
DEFAULT = "case-hardened"
TABLE_1 = "ISO 6336-5:2016, Table 1, as reprinted in public code, not compared with the standard"
SURFACE_HARDENED = ("Eh", "IF", "NT(nitr.)", "NV(nitr.)", "NV(nitrocar.)")
THROUGH_HARDENED = ("St", "V")
MEGAPASCAL = UNITS["MPa"].factor


@formula(
    "HBW",
    "ISO 18265, as generally published: HBW = 0.95·HV; so do, within 1, the pairs of ISO 898-1 from 120 to 435 HV",
    names={"HV": "HV"},
)
def brinell_hardness(HV: Number) -> Number:
    return 0.95 * HV


@formula("σ_Hlim", f"{TABLE_1}: allowable stress number, contact; x: hardness", unit="MPa")
def contact_number(A: Pascal, x: Number, B: Pascal) -> Pascal:
    return A * x + B


@formula("σ_Flim", f"{TABLE_1}: allowable stress number, bending; x: hardness", unit="MPa")
def bending_number(A: Pascal, x: Number, B: Pascal) -> Pascal:
    return A * x + B


@record
class StrengthClass:
    """A material as a gear: `x` is the hardness entered, `low` to `high` its range, all on `scale`; `hardness`: as given, HV.

    `brinell` is that of through-hardened classes and iron; of the others it is not asked.
    """

    name: str
    title: str
    kind: str
    treatment: str
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
    steels: tuple[str, ...]
    source: str
    notes: tuple[str, ...]

    @property
    def surface_hardened(self) -> bool:
        return self.kind in SURFACE_HARDENED

    @property
    def through_hardened(self) -> bool:
        return self.kind in THROUGH_HARDENED


@cache
def _rows() -> dict[str, str]:
    """The text of every row by its name, not yet parsed."""
    text = (TABLES / FILE).read_text(encoding="utf-8")
    return {row.split('"', 2)[1]: "[[row]]" + row for row in text.split("\n[[row]]")[1:]}


@cache
def _row(name: str) -> dict[str, Any]:
    return tomllib.loads(_rows()[name])["row"][0]


def class_names() -> tuple[str, ...]:
    """Every strength class that a wheel may name."""
    return tuple(_rows())


def classes_of(steel: str) -> tuple[str, ...]:
    """The classes that name a steel among their usual ones."""
    return tuple(name for name in class_names() if steel.casefold() in (s.casefold() for s in _row(name)["steels"]))


def strength_class(
    name: str | None = None, quality: str = "MQ", hardness: Number | None = None, proof_stress: Pascal | None = None
) -> StrengthClass:
    """The allowable stress numbers of a class.  `hardness` of the flank in HV; `proof_stress` of the very steel, if known.

    Left out: the class is case-hardened steel, the hardness the lowest of its range (rule of this program); the notes say so.
    Raises NoSolution where there is no such class.
    """
    notes = []
    if name is None:
        name = DEFAULT
        notes.append(f"strength class not given; chosen: {DEFAULT} steel, {quality}")
    if name not in _rows():
        raise _unknown(name)
    row = _row(name)
    contact, bending = row[f"contact_{quality}"], row[f"bending_{quality}"]
    low, high = max(contact[0][2], bending[0][2]), min(contact[-1][3], bending[-1][3])
    x = low
    if hardness is not None:
        x = hardness if row["scale"] == "HV" else brinell_hardness(HV=hardness)
    elif any(A for A, *_ in contact + bending):
        notes.append(f"hardness not given; taken: the lowest of the class {name}, {low:g} {row['scale']} (rule of this program)")
    if x > high:
        notes.append(f"hardness {x:.4g} {row['scale']} is above the range of the class {name}; its stresses are those at {high:g}")
    sigma_H, sigma_F = _read(contact, x), _read(bending, x)
    proof = row.get("proof_MPa")
    slip = row.get("slip_layer_mm")
    return StrengthClass(
        name=name, title=row["title"], kind=row["kind"], treatment=row["treatment"], quality=quality, scale=row["scale"],
        hardness=hardness, x=x, low=low, high=high,
        sigma_Hlim=contact_number(A=sigma_H[0], x=sigma_H[1], B=sigma_H[2]),
        sigma_Flim=bending_number(A=sigma_F[0], x=sigma_F[1], B=sigma_F[2]),
        brinell=x if row["scale"] == "HBW" or row["kind"] not in THROUGH_HARDENED else brinell_hardness(HV=x),
        proof_stress=None if proof is None else (proof_stress or proof * MEGAPASCAL),
        slip_layer=None if slip is None else slip * 1e-3, steels=tuple(row["steels"]), source=row["source"], notes=tuple(notes),
    )  # fmt: skip


STEEL_E = (190e9, 225e9)  # Pa: a material as stiff as this is taken for steel


def of_wheel(wheel: "Wheel", E: Pascal, proof_stress: Pascal | None = None) -> StrengthClass | None:
    """The class of a wheel of the design, its lines under the wheel's name; None: it gives none, and its material is not for the default.

    `E`: of its material.  A steel that the table names is taken for case-hardened only where that is one of its classes.
    """
    if wheel.gear_material is None:
        usual = classes_of(wheel.material)
        if DEFAULT not in usual if usual else not STEEL_E[0] <= E <= STEEL_E[1]:
            return None
    with about(f"wheel {wheel.name}, strength class"):
        return strength_class(wheel.gear_material, wheel.quality, wheel.hardness, proof_stress)


def _read(lines: list[list[float]], x: Number) -> tuple[Pascal, Number, Pascal]:
    """A, x and B of the line that holds at a hardness; beyond the last line x is its end."""
    for A, B, _, end in lines:
        if x <= end:
            return A * MEGAPASCAL, x, B * MEGAPASCAL
    return A * MEGAPASCAL, end, B * MEGAPASCAL


def class_problem(name: str) -> str | None:
    """Why a word is no strength class; None where it is one."""
    if name in class_names():
        return None
    why = _unknown(name)
    return f"{why.tried}; {why.advice}"


def _unknown(name: str) -> NoSolution:
    if "adi" in name.casefold().replace("-", " ").split() or "austemper" in name.casefold():
        return NoSolution(
            f'strength class "{name}"', "austempered ductile iron is not among the materials of ISO 6336-5",
            "rate it by its maker's own fatigue data; for a first guess take a class that is surely weaker (nodular iron, pearlitic)",
        )  # fmt: skip
    if found := classes_of(name):
        return NoSolution(
            f'strength class "{name}"', "it is a steel, not a class: its strength depends on the heat treatment", f"choose {_or(found)}"
        )
    import difflib  # only for a name that is wrong

    near = difflib.get_close_matches(name, class_names(), 3, 0.4) or list(class_names())
    return NoSolution(f'strength class "{name}"', "there is no such class", f"the nearest: {_or(near)}")


def _or(names: Any) -> str:
    return " or ".join(f'"{name}"' for name in names)


# --- what is shown ---------------------------------------------------------------------------------------------------------
def hardness_checks(wheel: str, cls: StrengthClass) -> tuple[Check, ...]:
    """Whether a given hardness lies in the range of its class; none where it is not given."""
    if cls.hardness is None:
        return ()
    factor = 1.0 if cls.scale == "HV" else 0.95
    source = f"ISO 6336-5:2016, Table 1: {cls.name}, {cls.quality}, {cls.low:g} to {cls.high:g} {cls.scale}"
    name = f"Hardness of {wheel} for its strength class"
    return (
        check(
            f"gears.{wheel}.hardness", name, cls.hardness, ">=", cls.low / factor, "HV", source,
            f"A softer flank does not reach the class: choose another gears.wheels.{wheel}.gear_material.",
        ),
        check(
            f"gears.{wheel}.hardness_most", f"{name}, upper end", cls.hardness, "<=", cls.high / factor, "HV", source,
            "The strength is that of the upper end: more hardness adds none, and may make the teeth brittle.", kind="advice",
        ),
    )  # fmt: skip


def classes_table(classes: Mapping[str, StrengthClass]) -> Table:
    """The wheels with their classes and the two stress numbers."""
    return Table(
        "gear_strength_classes", "Strength classes of the wheels",
        (("wheel", ""), ("class", ""), ("kind", ""), ("quality", ""), ("hardness", "HV"), ("σ_Hlim", "MPa"), ("σ_Flim", "MPa")),
        tuple(
            (wheel, c.name, c.kind, c.quality, c.hardness, c.sigma_Hlim / MEGAPASCAL, c.sigma_Flim / MEGAPASCAL)
            for wheel, c in classes.items()
        ),
        f"{TABLE_1}; for 1 % probability of failure. A hardness that is not given stays empty.",
    )  # fmt: skip
