# SPDX-License-Identifier: Apache-2.0
"""Values of others beside ours, and what is wrong in the documents that this program grew out of.

The values are the cases of tables/validation.toml, and the charts of Raimondi & Boyd.  Three kinds apart: printed in a
source, worked out from a source's numbers (or by another program), measured by others.  What the sources print and this
program does not give is told with its reason."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from typing import TypedDict

from ..bearings.plain.film.table import eccentricity_from, film_at
from ..design.addresses import Table
from ..design.toml_file import Document, current_document, design, read
from ..library.catalogue import Oil
from ..library.lubricant import Lubricant
from ..library.table_file import house_table, parsed, text_of_table
from ..sheet.number import short
from ..sheet.quantity import Published
from ..sheet.record import record
from ..sheet.text import with_unit
from ..sheet.units import UNITS
from ..sheet.value import recorded
from ..solve import solve
from .shipped import DESIGNS

# Where the charts of 1958 are known to be off by more than the 2 % that their grid supports (ε, quantity).
CHARTS_HOLD_UP_TO = 0.9


VALIDATION_KINDS = {
    "printed": "Printed in a source",
    "worked out": "Worked out from a source's numbers, or by another calculation",
    "measured": "Measured by others",
}


Expect = TypedDict(
    "Expect", {"value": str, "what": str, "is": float, "unit": str, "abs": float, "rel": float}, total=False
)
Case = TypedDict(
    "Case",
    {  # a design, a film by S and length_ratio, or an oil, and what its source has
        "source": str,
        "kind": str,
        "expect": list[Expect],
        "design": str | Table,
        "set": Table,
        "why": str,
        "S": float,
        "length_ratio": float,
        "nu_40": float,
        "nu_100": float,
        "law": str,
        "temperature": float,
        "is": float,
        "abs": float,
        "rel": float,
    },
    total=False,
)


@dataclass(frozen=True)
class ValidationRow:
    """One value of another beside ours."""

    kind: str
    source: str
    what: str
    published: float
    ours: float
    tolerance: float  # absolute, what the source supports
    unit: str

    @property
    def deviation(self) -> float:
        """Relative to the published value; absolute where that is zero."""
        return _deviation(self.published, self.ours)

    @property
    def verdict(self) -> str:
        return "pass" if abs(self.ours - self.published) <= self.tolerance else "fail"


@dataclass(frozen=True)
class Unmet:
    """A value that a source prints and that this program does not give, and why."""

    source: str
    what: str
    printed: float
    ours: float
    unit: str
    why: str

    @property
    def deviation(self) -> float:
        return _deviation(self.printed, self.ours)


def _deviation(theirs: float, ours: float) -> float:
    return (ours - theirs) / abs(theirs) if theirs else ours


def rows() -> list[ValidationRow]:
    """Every comparison, kind by kind, case by case."""
    designs, known = _known()
    comparisons = [row for case in known["case"] for row in _case(case, designs)]
    comparisons += [row for film in known["film"] for row in _film(film)]
    comparisons += [_oil(oil) for oil in known["oil"]]
    comparisons += _raimondi_boyd()
    return sorted(comparisons, key=lambda row: list(VALIDATION_KINDS).index(row.kind))


def unmet() -> Iterator[Unmet]:
    """What the sources print and this program does not give."""
    designs, known = _known()
    for case in known["unmet"]:
        values = _values(_document(case, designs))
        for expect in case["expect"]:
            value = values[expect["value"]]
            yield Unmet(case["source"], expect["value"], float(expect["is"]), value.shown, value.unit, case["why"])


def _known() -> tuple[dict[str, Table], dict[str, list[Case]]]:
    """The designs that are given once for several cases, and the cases by their kind."""
    data = parsed("validation.toml", text_of_table("validation.toml"))  # holds designs, which are read as such
    return data.pop("designs"), data


def _document(case: Case, designs: dict[str, Table]) -> Document:
    """`design` is a whole one, or the name of a shipped file or of one of `designs`; `set` changes keys of it."""
    given = designs.get(case["design"], case["design"]) if isinstance(case["design"], str) else case["design"]
    document = read(DESIGNS / given) if isinstance(given, str) else current_document(Document(given, case["source"]))
    for key, value in case.get("set", {}).items():
        document = document.with_value(key, value)
    return document


def _values(document: Document) -> dict[str, Published]:
    with recorded(False):
        return solve(design(document)).values()


def _case(case: Case, designs: dict[str, Table]) -> Iterator[ValidationRow]:
    values = _values(_document(case, designs))
    for expect in case["expect"]:
        published, unit = float(expect["is"]), expect.get("unit", "")
        tolerance = max(expect.get("abs", 0.0), abs(published) * expect.get("rel", 0.0))
        value = values.get(expect["value"])
        ours = value.shown if value is not None and value.unit == unit else float("nan")
        yield ValidationRow(case["kind"], case["source"], expect["value"], published, ours, tolerance, unit)


def _film(case: Case) -> Iterator[ValidationRow]:
    """A worked example of the film: what stands at its S and l/d."""
    S, ratio = case["S"], case["length_ratio"]
    ours = film_at(eccentricity_from(S, ratio), ratio)
    for expect in case["expect"]:
        name, published, unit = expect["what"], float(expect["is"]), expect.get("unit", "")
        what, value = f"{name} at S = {S:g}, l/d = {ratio:g}", getattr(ours, name) / UNITS[unit].factor
        tolerance = abs(published) * expect["rel"]
        yield ValidationRow(case["kind"], case["source"], what, published, value, tolerance, unit)


def _oil(case: Case) -> ValidationRow:
    """A viscosity of an oil by the law, from those at 40 and 100 °C, mm²/s; its density does not count."""
    oil = Oil(name="oil", nu40=case["nu_40"] * 1e-6, nu100=case["nu_100"] * 1e-6, rho15=900.0, base="mineral")
    ours = Lubricant(oil, case["law"]).at(case["temperature"]).nu / UNITS["mm²/s"].factor
    what = f"ν at {case['temperature']:g} °C of {case['nu_40']:g} and {case['nu_100']:g} mm²/s"
    tolerance = max(case.get("abs", 0.0), case["is"] * case.get("rel", 0.0))
    return ValidationRow(case["kind"], case["source"], what, case["is"], ours, tolerance, "mm²/s")


def _raimondi_boyd() -> Iterator[ValidationRow]:
    """S at the charts' ε within 2 %, friction within 1 %, flow within 0.5 %, for finite l/d and ε ≤ 0.9."""
    source = "Raimondi & Boyd 1958, as tabulated in textbooks"
    for row in house_table("raimondi_boyd.toml")["row"]:
        eps, ratio = row["eccentricity"], row["length_ratio"]
        if ratio > 2 or eps > CHARTS_HOLD_UP_TO:
            continue
        S, friction, flow = row["S"], row["friction_variable"], row["flow"]
        ours, at = film_at(eps, ratio), f"at ε = {eps:g}, l/d = {ratio:g}"
        for what, printed, value, tolerance in (
            (f"S {at}", S, ours.sommerfeld, 0.02 * S),
            (f"(r/c)·f {at}", friction, ours.friction, 0.01 * friction),
            (f"Q/(r·c·n·l) {at}", flow, ours.flow, 0.005 * flow),
            (f"ε at S = {S:g}, l/d = {ratio:g}", eps, eccentricity_from(S, ratio), 0.01),
        ):
            yield ValidationRow("printed", source, what, printed, value, tolerance, "")


# --- what is wrong in the documents that this program grew out of
# The rows of tables/errata.toml, with the right values computed.

DIGITS = 5  # of a right number: as many as the documents print


@record
class Misprint:
    """One error of a source.  `design` and `value`: where this program has the right number; `sum`: arithmetic that
    shows it."""

    source: str
    place: str  # section, equation, table or figure
    lines: str  # of the document's plain text
    about: str
    line: str  # as printed, ten words at most, in its own language
    who: str  # may be wrong: author, print or copy
    right: str
    why: str
    printed: str = ""  # what the line says, where it does not say it alone
    design: str = ""
    value: str = ""
    sum: str = ""

    @property
    def as_printed(self) -> str:
        """What stands there: what it says, the line itself, and who may be wrong."""
        return f"{self.printed}: “{self.line}” ({self.who})".removeprefix(": ")

    @property
    def command(self) -> str:
        """What a reader types to see the right number worked out; empty where the source itself shows the error."""
        return f"contralbero explain designs/{self.design} {self.value}" if self.value else ""


def documents() -> dict[str, str]:
    """The documents by the short names of the register, each with what it is."""
    return {name: about["title"] for name, about in house_table("errata.toml")["source"].items()}


def caveat() -> str:
    """What is held against no document."""
    return str(house_table("errata.toml")["caveat"])


def misprints(source: str = "") -> Iterator[Misprint]:
    """All that is known to be wrong, or what is wrong in one document."""
    for row in house_table("errata.toml")["row"]:
        if not source or row["source"] == source:
            yield _misprint(dict(row))


def _misprint(row: dict[str, str]) -> Misprint:
    unit, numbers = row.pop("unit", ""), {}
    if "sum" in row:
        numbers["sum"] = with_unit(short(worked_out(row["sum"]), DIGITS), unit)
    if "value" in row:
        published = _values_of(row["design"])[row["value"]]
        numbers["value"] = with_unit(short(published.shown, DIGITS), published.unit)
    right = row.get("right", "{value}" if "value" in row else "{sum}")
    told = {"printed": row.get("printed", "").format_map(numbers), "right": right.format_map(numbers)}
    return Misprint(**row | told)


def worked_out(arithmetic: str) -> float:
    """The value of a row's `sum`.  The table is part of the program, so it may be evaluated; it knows `math` and
    nothing else."""
    return float(eval(arithmetic, {"__builtins__": {}}, vars(math)))


@cache
def _values_of(name: str) -> dict[str, Published]:
    return _values(read(DESIGNS / name))
