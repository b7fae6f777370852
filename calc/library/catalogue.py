# SPDX-License-Identifier: Apache-2.0
"""Oils and materials by name: the design's own first, then the tables that come with the program."""

import re
from collections import ChainMap
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import MISSING
from functools import cache, lru_cache
from typing import Any, TypeVar

from ..sheet.check import Missing
from ..sheet.quantity import choice, dotted, inputs, keys, quantity, tables, text, unknown
from ..sheet.record import record, replace
from ..sheet.text import Amount, Text
from ..sheet.units import Pascal
from ..sheet.value import Link, linked
from .table_file import Mistake, bad_table, parsed, text_of_table

T = TypeVar("T")
# keys of a table's row that stand there for the reader only
BESIDE = ("specific_heat_J_kgK", "elongation_percent", "hardness_HB")
NAMED = re.compile(r'name = "([^"]*)"\n')  # how a row begins


@record
class Claim:
    """One value of a table's row as it stands there: its key, number (or word), confidence and source."""

    key: str
    value: float | str
    confidence: Text
    source: Text


@inputs
class PrintedViscosity:
    """A dynamic viscosity that is printed somewhere, to be held against the oil's own law."""

    temperature: float = quantity("Temperature", "°C", within=(-40, 200), symbol="T")
    viscosity: float = quantity("Printed dynamic viscosity", "mPa·s", up_to=1e6, symbol="mu")

    def __str__(self) -> str:
        return Text(
            "{viscosity} mPa·s at {temperature} °C",
            viscosity=Amount(self.viscosity * 1000.0, form=".5g"),
            temperature=Amount(self.temperature, form="g"),
        )


@inputs
class ViscosityRow:
    """One row of an oil's own table: its dynamic viscosity at a temperature."""

    temperature: float = quantity("Temperature", "°C", within=(-60, 300), symbol="T")
    viscosity: float = quantity("Dynamic viscosity", "mPa·s", within=(0.5, 1e6), symbol="mu")


@inputs
class Oil:
    """A lubricant by its viscosity and density; the values by which it acts in a gear mesh follow from its base, or are
    given.

    The viscosity is given in one of three ways: at 40 and at 100 °C, in rows over the temperature, or as one number for
    all of them."""

    name: str = text("Name")
    nu40: float | None = quantity(
        "Kinematic viscosity at 40 °C",
        "mm²/s",
        default=None,
        within=(1, 1e5),
        symbol="nu_40",
        help="With that at 100 °C. Left out: viscosities, or viscosity_mPas.",
    )
    nu100: float | None = quantity(
        "Kinematic viscosity at 100 °C",
        "mm²/s",
        default=None,
        within=(1, 1e4),
        symbol="nu_100",
        help="With that at 40 °C. Left out: viscosities, or viscosity_mPas.",
    )
    rho15: float = quantity("Density at 15 °C", "kg/m³", within=(600, 1300), symbol="rho_15")
    base: str = choice("Base stock", "mineral", "PAO", "PAG", "ester", "MIL-L-7808", "MIL-L-23699")
    conductivity: float = quantity("Thermal conductivity", "W/(m·K)", default=0.14, within=(0.05, 1.0), symbol="k_f")
    limiting_shear: float | None = quantity(
        "Limiting shear stress over pressure",
        default=None,
        up_to=0.3,
        symbol="Lambda",
        help="Left out: that of the base stock.",
    )
    pressure_viscosity_40: float | None = quantity(
        "Pressure-viscosity coefficient at 40 °C",
        "1/GPa",
        default=None,
        up_to=100,
        symbol="alpha_40",
        help="Left out: by the base stock. Given: the base stock says only how it changes with the viscosity.",
    )
    viscosity: float | None = quantity(
        "Dynamic viscosity at every temperature",
        "mPa·s",
        default=None,
        up_to=1e6,
        symbol="mu",
        help="Constant, as in textbooks; instead of the viscosities at 40 and 100 °C.",
    )
    viscosities: tuple[ViscosityRow, ...] = tables(
        "Dynamic viscosity over temperature",
        ViscosityRow,
        default=(),
        help="Rows of rising temperature, instead of the viscosities at 40 and 100 °C. Walther's line joins each to "
        "the next.",
    )
    pumping_limit: float | None = quantity(
        "Borderline pumping temperature",
        "°C",
        default=None,
        within=(-80, 50),
        symbol="T_BP",
        help="Below it a pump does not get the oil to the bearings.",
    )
    pour_point: float | None = quantity(
        "Pour point", "°C", default=None, within=(-80, 50), symbol="T_PP", help="Below it the oil stands."
    )
    hths: float | None = quantity(
        "Viscosity at high shear (HTHS)",
        "mPa·s",
        default=None,
        within=(0.5, 50),
        symbol="mu_HTHS",
        source="SAE J300",
        help="Dynamic, at 150 °C and 10⁶ 1/s. Left out: the least of the multigrade that the name says.",
    )
    printed: tuple[PrintedViscosity, ...] = tables("Viscosities printed elsewhere", PrintedViscosity, default=())
    source: str = text("Source", default="the user")
    claims: tuple[Claim, ...] = ()  # of an oil of the table: where each value comes from

    def problems(self) -> Iterable[tuple[str, Text]]:
        yield from self._viscosity_problems()
        for i, row in enumerate(self.printed):
            if any(row.temperature == other.temperature for other in self.printed[:i]):
                yield dotted(Oil.printed, i, PrintedViscosity.temperature), Text("stands twice")

    def _viscosity_problems(self) -> Iterable[tuple[str, Text]]:
        """The viscosity must be given, and in one way only."""
        ways = {
            dotted(Oil.nu40): self.nu40 is not None or self.nu100 is not None,
            dotted(Oil.viscosity): self.viscosity is not None,
            "viscosities": bool(self.viscosities),
        }
        first, *others = [key for key, given in ways.items() if given] or [""]
        if not first:
            needs = Text(
                "is missing; needs the viscosities at 40 and 100 °C, or viscosity_mPas, or rows of viscosities"
            )
            yield from ((dotted(Oil.nu40), needs), (dotted(Oil.nu100), needs))
            return
        twice = Text("the viscosity of this oil is given by {first} already; leave one of the two out", first=first)
        yield from ((key, twice) for key in others)
        if ways[dotted(Oil.nu40)]:
            if self.nu40 is None:
                yield dotted(Oil.nu40), Text("is missing; needed with the viscosity at 100 °C")
            elif self.nu100 is None:
                yield dotted(Oil.nu100), Text("is missing; needed with the viscosity at 40 °C")
            elif self.nu100 >= self.nu40:
                yield dotted(Oil.nu100), Text("must be below the viscosity at 40 °C")
            elif self.nu100 < self.nu40:  # neither is a placeholder
                from .oil_formulas import line_problem  # brings numpy with it

                if (wrong := line_problem(self.nu40, self.nu100)) is not None:
                    yield dotted(Oil.nu100), wrong
        if len(self.viscosities) == 1:
            needs = Text("has one row; needs two or more, or viscosity_mPas for one viscosity at every temperature")
            yield dotted(Oil.viscosities), needs
        for i, (row, after) in enumerate(zip(self.viscosities, self.viscosities[1:]), 1):
            if after.temperature <= row.temperature:
                yield dotted(Oil.viscosities, i, ViscosityRow.temperature), Text("must be above that of the row before")


@inputs
class BaseStock:
    """What the base stock of an oil makes of its viscosity in a gear mesh: α = k·η^s, and the limiting shear stress."""

    name: str = text("Base stock")
    k: float = quantity("Constant of the pressure-viscosity coefficient", "mm²/N", above=0, symbol="k")
    s: float = quantity("Exponent of the pressure-viscosity coefficient", above=0, symbol="s")
    limiting_shear: float = quantity("Limiting shear stress over pressure", above=0, symbol="Lambda")
    claims: tuple[Claim, ...] = ()


@inputs
class Grade:
    """An SAE grade by its kinematic viscosity at 100 °C.  What a multigrade oil of it must have at high shear: also
    with a winter grade of 15W or thicker."""

    name: str = text("Grade")
    from_: float = quantity("From", "mm²/s")
    below: float = quantity("Below", "mm²/s")
    hths: float = quantity("Least viscosity at high shear", "mPa·s")
    hths_thick: float = quantity("Least viscosity at high shear, 15W and thicker", "mPa·s")


@inputs
class Material:
    """A solid by what shaft, bearing and gear need of it."""

    name: str = text("Name")
    E: float = quantity("Young's modulus", "GPa", within=(1, 1000))
    poisson: float = quantity("Poisson's ratio", default=0.3, within=(0.0, 0.49), symbol="nu")
    density: float = quantity("Density", "kg/m³", within=(500, 25000), symbol="rho")
    expansion: float = quantity("Thermal expansion", "10⁻⁶/K", within=(0, 100), symbol="alpha", rule_of_thumb=(5, 30))
    proof_stress: float | None = quantity(
        "Proof stress",
        "MPa",
        default=None,
        up_to=10000,
        symbol="R_p",
        rule_of_thumb=(80, 1500),
        help="Rp0.2, tension.",
    )
    tensile_strength: float | None = quantity(
        "Tensile strength", "MPa", default=None, up_to=10000, symbol="R_m", rule_of_thumb=(120, 2200)
    )
    kind: str = choice(
        "Kind",
        "steel",
        "ductile iron",
        "grey iron",
        "aluminium",
        "other",
        default="other",
        help="For its fatigue; other: it is not judged.",
    )
    alternating_strength: float | None = quantity(
        "Alternating strength",
        "MPa",
        default=None,
        up_to=10000,
        symbol="sigma_W",
        help="Of a smooth, polished specimen, endless life. Left out: by its kind from the tensile strength.",
    )
    source: str = text("Source", default="the user")


WEAKEST_STEEL: Pascal = 235e6  # proof stress of the weakest structural steels
WEAKEST_TENSILE: Pascal = 360e6  # their tensile strength


def proof_of(given: Pascal | None, stress: Pascal) -> tuple[Pascal, Missing | None]:
    """The proof stress that a stress is held against; where it is not given that of the weakest structural steels:
    above it the stress may still be borne, by a stronger metal."""
    if given is not None:
        return given, None
    taken = Text("{stress}, as the weakest structural steels", stress=Amount(WEAKEST_STEEL * 1e-6, "MPa"))
    return WEAKEST_STEEL, Missing((dotted("material", Material.proof_stress),), (taken,), "holds", stress)


CLAIM = ("is", "confidence", "source")  # the keys of a value that stands with where it comes from


def _row(cls: type[T], row: dict[str, Any], file: str, place: str) -> T:
    """One row in SI.  A value may stand with its confidence and source: `{ is = 93.27, confidence = "high", source =
    "…" }`.  `place`: of the row in its file.  Raises BadTable."""
    mistakes = list(_mistakes(cls, row, place))
    if mistakes:
        raise bad_table(file, mistakes)
    kind: type = cls
    known, claims = keys(kind), []
    values: dict[str, object] = {}
    for key, value in row.items():
        if isinstance(value, dict):
            claims.append(Claim(key, value["is"], Text(value["confidence"]), Text(value["source"])))
            value = value["is"]
        if key in BESIDE:
            continue
        about = known[key].about
        if about.table is not None and isinstance(value, list):
            value = tuple(_row(about.table, item, file, f"{place}.{key}.{n}") for n, item in enumerate(value))
        elif about.kind == "series":
            numbers = value if isinstance(value, list) else [value]
            value = tuple(about.units.inside(float(number)) for number in numbers)
        elif about.kind == "text" and key != "name":
            value = Text(str(value))  # a word of the program, not of a user
        values[known[key].attribute] = about.units.inside(float(value)) if about.kind == "number" else value
    return cls(**(values | {"claims": tuple(claims)}) if claims else values)


def _mistakes(cls: type, row: dict[str, Any], place: str) -> Iterator[Mistake]:
    """What is wrong with the keys of a row: one that is not known, one that is missing, one that is no number."""
    known = keys(cls)
    for key, value in row.items():
        where = f"{place}.{key}"
        if isinstance(value, dict):
            if set(value) != set(CLAIM):
                yield where, str(value), Text("needs {keys}, and nothing else", keys=", ".join(CLAIM))
                continue
            value = value["is"]
        if key in BESIDE:
            continue
        if key not in known:
            yield where, "", unknown(key, known)
            continue
        about = known[key].about
        if about.kind not in ("number", "series"):
            continue
        numbers = value if about.kind == "series" and isinstance(value, list) else [value]
        if any(isinstance(number, bool) or not isinstance(number, (int, float)) for number in numbers):
            yield where, str(value), Text("must be {allowed}", allowed=about.allowed())
    for key, needed in known.items():
        if key not in row and needed.field.default is MISSING:
            yield f"{place}.{key}", "", Text("is missing; needs {allowed}", allowed=needed.about.allowed())


@cache
def rows_of(file: str, cls: type, only: str = "") -> dict[str, object]:
    """The rows of a table by their names; `only`: one of them, which spares the reading of the others."""
    rows: CatalogueRows[object] = CatalogueRows(file, "row", cls)
    return {only: rows[only]} if only else dict(rows)


class CatalogueRows(Mapping[str, T]):
    """The rows of one kind of a table by their names, each read when it is asked for.  A row begins with its name."""

    def __init__(self, file: str, kind: str, cls: type[T]) -> None:
        _, *parts = re.split(r"^\[\[(\w+)\]\]\n", text_of_table(file), flags=re.MULTILINE)
        self.file, self.cls = file, cls
        self.texts: dict[str, str] = {}
        self.places: dict[str, str] = {}
        rows = [row for here, row in zip(parts[::2], parts[1::2]) if here == kind]
        for n, row in enumerate(rows):
            if (name := NAMED.match(row)) is None:
                raise bad_table(file, [(f"{kind}.{n}", "", Text('must begin with its name: name = "…"'))])
            self.texts[name[1]], self.places[name[1]] = row, f"{kind}.{n}"
        self.made: dict[str, T] = {}

    def __getitem__(self, name: str) -> T:
        if name not in self.made:
            row = _row(self.cls, parsed(self.file, self.texts[name]), self.file, self.places[name])
            # one object, whichever thread comes first
            self.made.setdefault(name, row)
        return self.made[name]

    def __contains__(self, name: object) -> bool:
        return name in self.texts

    def __iter__(self) -> Iterator[str]:
        return iter(self.texts)

    def __len__(self) -> int:
        return len(self.texts)


class ByName(Mapping[str, T]):
    """Rows of tables by name.  Where the name is an input (`bearings.oil`), the row's numbers come from it."""

    def __init__(self, rows: Mapping[str, T]) -> None:
        self.rows = rows

    def __getitem__(self, name: str) -> T:
        row = self.rows[name]
        key = getattr(name, "link", None)
        return row if key is None else _named_by(key, row)

    def __contains__(self, name: object) -> bool:
        return name in self.rows

    def __iter__(self) -> Iterator[str]:
        return iter(self.rows)

    def __len__(self) -> int:
        return len(self.rows)


@lru_cache(maxsize=256)
def _named_by(key: Link, row: Any) -> Any:  # the cache knows no type of its own for each row
    """A row whose numbers are linked to the key that names it; those of the design itself have keys of their own."""
    kind: type = type(row)
    names = [about.attribute for about in keys(kind).values() if about.about.kind in ("number", "choice")]
    if any(hasattr(getattr(row, name), "link") for name in names):
        return row
    link = f"{key} ({row.name})" if isinstance(key, str) and not key.endswith(")") else key
    return replace(row, **{name: linked(getattr(row, name), link) for name in names})


@cache
def shipped_oils() -> CatalogueRows[Oil]:
    """The oils of the table."""
    return CatalogueRows("oils.toml", "row", Oil)


@cache
def shipped_materials() -> CatalogueRows[Material]:
    """The materials of the table."""
    return CatalogueRows("materials.toml", "row", Material)


@cache
def base_stocks() -> Mapping[str, BaseStock]:
    """The base stocks of the table of oils."""
    return ByName(CatalogueRows("oils.toml", "base", BaseStock))


@cache
def grades() -> tuple[Grade, ...]:
    """The SAE grades, from thin to thick."""
    return tuple(CatalogueRows("oils.toml", "grade", Grade).values())


def oils(own_oils: Iterable[Oil] = ()) -> Mapping[str, Oil]:
    """Every oil that a design may name; its own override those of the table."""
    return ByName(ChainMap({o.name: o for o in own_oils}, shipped_oils()))  # type: ignore[arg-type]


def materials(own_materials: Iterable[Material] = ()) -> Mapping[str, Material]:
    """Every material that a design may name; its own override those of the table."""
    return ByName(ChainMap({m.name: m for m in own_materials}, shipped_materials()))  # type: ignore[arg-type]
