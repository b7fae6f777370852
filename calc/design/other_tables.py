# SPDX-License-Identifier: Apache-2.0
"""The tables of a design that are no step's: [document], [[requirements]], [optimise] and [[measured]].

Document control is what the report is for, number, people, revision and change record, as its first page prints them:

[document]
purpose = "To release the counter-shaft for the prototype of series B."
scope = "Shaft, bearings, gear train; not the housing."
number = "CS-0042"
project = "Counter-shaft of the small industrial engine"
customer = "…"
company = "…"
logo = "logo.png"                      # a PNG file beside the design
revision = "B"
prepared = { name = "…", date = 2026-03-14 }
checked = { name = "…" }               # a date that is left out is written by hand

[[document.changes]]
revision = "B"
date = 2026-03-14
what = "Longer bearings"
by = "…"

[[requirements]]                       # what somebody has asked of the design, printed with who did
name = "First-order couple left over"
value = "at most 20 N·m"
owner = "Vehicle comfort"
"""

from collections.abc import Iterable, Mapping
from math import isfinite
from numbers import Real
from typing import Any

from ..sheet.quantity import choice, day, dotted, inputs, integer, open_, quantity, table, tables, text
from ..sheet.record import replace
from ..sheet.text import Text
from ..sheet.units import UNITS
from .disk import bare_name

SIGNED = ("prepared", "checked", "approved")


@inputs
class Signature:
    """One who signs.  What is left empty is a field to fill in by hand."""

    name: str = text("Name", default="")
    date: str = day("Date", default="")


@inputs
class Change:
    """One row of the change record."""

    revision: str = text("Revision")
    date: str = day("Date", default="")
    what: str = text("What changed")
    by: str = text("By", default="")


@inputs
class DocumentControl:
    """What the title block says."""

    purpose: str = text("Purpose", default="", help="What the report is for: the question that it answers.")
    scope: str = text("Scope", default="", help="What it covers, and what it leaves to others.")
    number: str = text("Number", default="", help="Of the document, as its company files it.")
    project: str = text("Project", default="")
    customer: str = text("Customer", default="")
    company: str = text("Company", default="")
    logo: str = text("Logo", default="", help="The name of a PNG file beside the design; the report prints it.")
    revision: str = text("Revision", default="")
    prepared: Signature | None = table("Prepared", Signature, default=None)
    checked: Signature | None = table("Checked", Signature, default=None)
    approved: Signature | None = table("Approved", Signature, default=None)
    changes: tuple[Change, ...] = tables(
        "Change record", Change, default=(), help="One row for each revision, the oldest first."
    )

    def problems(self) -> Iterable[tuple[str, Text]]:
        if not self.logo:
            return
        if not bare_name(self.logo, made=False):
            yield dotted(DocumentControl.logo), Text("must be the bare name of a file beside the design, like logo.png")
        elif not self.logo.lower().endswith(".png"):
            must = Text("must be a PNG file (.png); other pictures, SVG among them, are not drawn: export it as PNG")
            yield dotted(DocumentControl.logo), must

    def signatures(self) -> list[tuple[str, Signature]]:
        """Who signs, in order, by the keys of the table."""
        return [(key, getattr(self, key) or Signature()) for key in SIGNED]

    def words(self) -> Iterable[str]:
        """All that is printed of it."""
        yield from (self.purpose, self.scope, self.number, self.project, self.customer, self.company, self.revision)
        for _, signature in self.signatures():
            yield from (signature.name, signature.date)
        for change in self.changes:
            yield from (change.revision, change.date, change.what, change.by)


@inputs
class Requirement:
    """One row of [[requirements]]: words, which no formula reads."""

    name: str = text("Requirement")
    value: str = text("Value", default="", help="As it was asked, with its unit.")
    owner: str = text("Owner", default="", help="Who has asked for it.")


# Where the keys at the top of old files stand now
FORMER = {
    "author": ("prepared", "name"),
    "date": ("prepared", "date"),
    "checker": ("checked", "name"),
    "revision": ("revision", ""),
}


def control(given: DocumentControl | None, former: Mapping[str, str]) -> DocumentControl:
    """The table of a design, and what an old file says at its top in its place."""
    document = given or DocumentControl()
    prepared, checked = document.prepared or Signature(), document.checked or Signature()
    return replace(
        document,
        revision=document.revision or former["revision"],
        prepared=Signature(name=prepared.name or former["author"], date=prepared.date or former["date"]),
        checked=Signature(name=checked.name or former["checker"], date=checked.date),
        approved=document.approved or Signature(),
    )


def said_twice(document: DocumentControl | None, former: Mapping[str, str]) -> Iterable[tuple[str, Text]]:
    """Keys of old files whose content stands in the table as well."""
    for key, (place, part) in FORMER.items():
        there = getattr(document, place, None)
        if former[key] and (getattr(there, part, "") if part else there):
            stands = ".".join(filter(None, ("document", place, part)))
            yield key, Text("stands as {place} too; keep that and leave this out", place=stands)


# --- [optimise]: what `contralbero design` may vary, what it must keep, and what it wants
# No step asks for it; all of it may be left out.

OBJECTIVES = ("power", "mass", "seat", "price", "margin")
MOST = ("power_W", "mass_kg", "seat_mm", "price_EUR")
LEAST = ("margin_percent",)
PRICED = ("fit", "surface", "material", "supply", "oil")
RANGE = {"from", "to", "step"}


@inputs
class Price:
    """What one choice adds to the price of a piece."""

    what: str = choice("What", *PRICED)
    value: list[Any] = open_(
        "Which", help='["IT6", "IT7"] of fits, [0.4, 0.6] of surfaces (journal, seat, µm), ["20CrNi4"] of materials.'
    )
    piece: float = quantity(
        "Added to a piece", "€", within=(-1e6, 1e6), help="What this choice adds to the price of one piece."
    )


@inputs
class CyclePoint:
    """How long the machine runs at a speed."""

    speed: float = quantity("Speed", "rpm", up_to=30000, symbol="n", help="Of the crank.")
    hours: float = quantity("Hours", up_to=1e9, help="Of a day, a year or a life: only their shares count.")


@inputs
class OptimiseInputs:
    """The search for whole drives: objectives, ranges, requirements and prices, each with a rule of this program where
    it is left out."""

    objectives: list[str] | None = open_(
        "Objectives", default=None, help="Any of power, mass, seat, price, margin. Left out: all that are known."
    )
    shaft: str | None = text(
        "Shaft that is searched",
        default=None,
        help="The name of one that is no twin; its twins follow, others stay as they are. Left out: the only one.",
    )
    rows: int = integer("Drives that are solved whole and saved", default=60, within=(1, 2000))
    seed: int = integer(
        "Seed", default=1, within=(0, 2**31), help="Of the search without proof; the other has no chance in it."
    )
    limits: list[str] | None = open_(
        "Findings that are limits here", default=None, help='Ids of checks, * for any: "bearings.*_corner".'
    )
    waive: list[str] | None = open_("Findings of the usual list that are none here", default=None)
    vary: dict[str, Any] | None = open_(
        "What is varied",
        default=None,
        help="By key a list, or numbers from, to and step; a key that is not named follows a rule of this program.",
    )
    most: dict[str, float] | None = open_(
        "Most of an objective", default=None, help="seat_mm, mass_kg, power_W, price_EUR."
    )
    least: dict[str, float] | None = open_("Least of an objective", default=None, help="margin_percent.")
    price: tuple[Price, ...] = tables("Prices", Price, default=())
    cycle: tuple[CyclePoint, ...] = tables(
        "Duty cycle",
        CyclePoint,
        default=(),
        help="Speeds with their hours, over which the power is a mean. Left out: those of [[engine.operation]], else "
        "the power at the rated speed.",
    )

    def problems(self) -> Iterable[tuple[str, Text]]:
        for name in ("objectives", "limits", "waive"):
            given = getattr(self, name)
            if given is not None and not (isinstance(given, list) and all(isinstance(word, str) for word in given)):
                yield name, Text("must be a list of words")
            elif name == "objectives" and given is not None and (not given or set(given) - set(OBJECTIVES)):
                yield name, Text("must be some of {known}", known=", ".join(OBJECTIVES))
        yield from self._bounds("most", MOST)
        yield from self._bounds("least", LEAST)
        if self.vary is not None and not isinstance(self.vary, dict):
            yield dotted(OptimiseInputs.vary), Text("must be a table of keys")
        elif isinstance(self.vary, dict):
            for key, allowed in self.vary.items():
                if (wrong := range_problem(allowed)) is not None:
                    yield dotted(OptimiseInputs.vary, key), wrong
        for n, price in enumerate(self.price):
            if not isinstance(price.value, list):
                yield dotted(OptimiseInputs.price, n, Price.value), Text("must be a list, of one or two")

    def _bounds(self, name: str, known: tuple[str, ...]) -> Iterable[tuple[str, Text]]:
        given = getattr(self, name)
        if given is None:
            return
        if not isinstance(given, dict):
            yield name, Text("must be a table of {known}", known=", ".join(known))
            return
        for key, bound in given.items():
            if key not in known:
                yield f"{name}.{key}", Text("is not known; known are {known}", known=", ".join(known))
            elif not _number(bound):
                yield f"{name}.{key}", Text("must be a number")


def range_problem(allowed: object) -> Text | None:
    """What is wrong with the values that a key may take; None: nothing."""
    if isinstance(allowed, list):
        return None if allowed else Text("is empty; give the values that it may take")
    if isinstance(allowed, dict):
        if set(allowed) != RANGE or not all(_number(x) for x in allowed.values()):
            return Text("must be a list of values, or numbers from, to and step")
        if not (allowed["step"] > 0 and allowed["to"] >= allowed["from"]):
            return Text("must rise from `from` to `to` by a step above zero")
        return None
    return None if allowed == "fixed" else Text('must be a list of values, numbers from, to and step, or "fixed"')


def _number(x: object) -> bool:
    return isinstance(x, Real) and not isinstance(x, bool) and isfinite(x)


# --- what was measured of a design, a row each; `design/predicted.py` lays it beside what is predicted
# [[measured]]
# value = "bearings.front.oil_flow"      # the id of a value, or the key of an input
# speed_rpm = 2000                       # left out: the design's own speed
# is = 0.52
# unit = "L/min"
# uncertainty = 0.05                     # in the same unit
# note = "bench, 12 October"


@inputs
class Measured:
    """One row of [[measured]]."""

    value: str = text("Value", help="The id of a value, as `check --all` prints it, or the key of an input.")
    speed: float | None = quantity("Speed", "rpm", up_to=30000, default=None, help="Left out: the design's own speed.")
    is_: float = quantity("Measured", help="In the unit of the row.")
    unit: str = text("Unit", default="", help="That in which the value is shown.")
    uncertainty: float | None = quantity("Uncertainty", low=0, default=None, help="In the unit of the row.")
    note: str = text("Note", default="", help="Instrument, date, conditions.")

    def problems(self) -> Iterable[tuple[str, Text]]:
        if self.unit not in UNITS:
            yield dotted(Measured.unit), Text("is no unit that values are shown in")
