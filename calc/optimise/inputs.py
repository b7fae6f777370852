# SPDX-License-Identifier: Apache-2.0
"""[optimise]: what `contralbero design` may vary, what it must keep, and what it wants.  No step asks for it; all of it may be left out."""

from collections.abc import Iterable
from math import isfinite
from numbers import Real
from typing import Any

from ..sheet.quantity import choice, inputs, integer, open_, quantity, tables
from ..sheet.text import Text

OBJECTIVES = ("power", "mass", "seat", "price", "margin")
MOST = ("power_W", "mass_kg", "seat_mm", "price_EUR")
LEAST = ("margin_percent",)
PRICED = ("fit", "surface", "material", "supply", "oil")
RANGE = {"from", "to", "step"}


@inputs
class Price:
    """What one choice adds to the price of a piece."""

    what: str = choice("What", *PRICED)
    value: list[Any] = open_("Which", help='["IT6", "IT7"] of fits, [0.4, 0.6] of surfaces (journal, seat, µm), ["20CrNi4"] of materials.')
    piece: float = quantity("Added to a piece", "€", low=-1e6, high=1e6, help="What this choice adds to the price of one piece.")


@inputs
class CyclePoint:
    """How long the machine runs at a speed."""

    speed: float = quantity("Speed", "rpm", above=0, high=30000, symbol="n", help="Of the crank.")
    hours: float = quantity("Hours", above=0, high=1e9, help="Of a day, a year or a life: only their shares count.")


@inputs
class OptimiseInputs:
    """The search for whole drives: objectives, ranges, requirements and prices, each with a rule of this program where it is left out."""

    objectives: list[str] | None = open_(
        "Objectives", default=None, help="Any of power, mass, seat, price, margin. Left out: all that are known."
    )
    rows: int = integer("Drives that are solved whole and saved", default=60, low=1, high=2000)
    seed: int = integer("Seed", default=1, low=0, high=2**31, help="Of the search without proof; the other has no chance in it.")
    limits: list[str] | None = open_("Findings that are limits here", default=None, help='Ids of checks, * for any: "bearings.*_corner".')
    waive: list[str] | None = open_("Findings of the usual list that are none here", default=None)
    vary: dict[str, Any] | None = open_("What is varied", default=None,
        help="By key a list, or numbers from, to and step; a key that is not named follows a rule of this program.")  # fmt: skip
    most: dict[str, float] | None = open_("Most of an objective", default=None, help="seat_mm, mass_kg, power_W, price_EUR.")
    least: dict[str, float] | None = open_("Least of an objective", default=None, help="margin_percent.")
    price: tuple[Price, ...] = tables("Prices", Price, default=())
    cycle: tuple[CyclePoint, ...] = tables("Duty cycle", CyclePoint, default=(),
        help="Speeds with their hours, over which the power is a mean. Left out: the power at the rated speed.")  # fmt: skip

    def problems(self) -> Iterable[tuple[str, Text]]:
        for name in ("objectives", "limits", "waive"):
            given = getattr(self, name)
            if given is not None and not (isinstance(given, list) and all(isinstance(one, str) for one in given)):
                yield name, Text("must be a list of words")
            elif name == "objectives" and given is not None:
                if not given or set(given) - set(OBJECTIVES):
                    yield name, Text("must be some of {known}", known=", ".join(OBJECTIVES))
        yield from self._bounds("most", MOST)
        yield from self._bounds("least", LEAST)
        if self.vary is not None and not isinstance(self.vary, dict):
            yield "vary", Text("must be a table of keys")
        elif isinstance(self.vary, dict):
            for key, said in self.vary.items():
                if (wrong := range_problem(said)) is not None:
                    yield f"vary.{key}", wrong
        for n, one in enumerate(self.price):
            if not isinstance(one.value, list):
                yield f"price.{n}.value", Text("must be a list, of one or two")

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


def range_problem(said: object) -> Text | None:
    """What is wrong with the values that a key may take; None: nothing."""
    if isinstance(said, list):
        return None if said else Text("is empty; give the values that it may take")
    if isinstance(said, dict):
        if set(said) != RANGE or not all(_number(x) for x in said.values()):
            return Text("must be a list of values, or numbers from, to and step")
        if not (said["step"] > 0 and said["to"] >= said["from"]):
            return Text("must rise from `from` to `to` by a step above zero")
        return None
    return None if said == "fixed" else Text('must be a list of values, numbers from, to and step, or "fixed"')


def _number(x: object) -> bool:
    return isinstance(x, Real) and not isinstance(x, bool) and isfinite(x)
