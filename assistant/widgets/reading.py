# SPDX-License-Identifier: Apache-2.0
"""What is read off a curve at its cursor: the numbers, with their distances to the limits.  Knows neither screen nor
plotting library."""

import math
import re
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from calc.sheet.number import DIGITS
from calc.sheet.step import Curve
from calc.sheet.text import COMMA, EMPTY, SEMICOLON, Amount, Name, Text

from .curve_view import Cursor, Sight

STEPS = 50  # about so many coarse steps lead from one end of a curve to the other
NOTHING = Name("–")  # no value here
FINER = 10  # fine steps in a coarse one
DUST = 1e-9  # of the largest number of a curve: less is rounding
# a figure in true scale with this unit shows places; with another one it shows vectors, whose length is of interest
PLACES = "mm"


@dataclass(frozen=True)
class Read:
    """One series at the cursor.  `brief`: the value where there is little room; `distances`: to each limit, the nearest
    first."""

    number: int
    label: str
    x: float
    y: float
    value: Text
    brief: Text
    distances: tuple[Text, ...] = ()

    @property
    def text(self) -> Text:
        """As it is copied."""
        return COMMA.join(
            (Text("{label} {value}", label=self.label, value=self.value) if self.label else self.value, *self.distances)
        )


@dataclass(frozen=True)
class Reading:
    """`at`: where the cursor stands, in words.  `x`: of its line; None where it stands on points."""

    at: Text
    reads: tuple[Read, ...]
    x: float | None
    chosen: int

    @property
    def value(self) -> Text:
        """Of the series that was chosen."""
        return next((read.value for read in self.reads if read.number == self.chosen), EMPTY)

    @property
    def line(self) -> Text:
        return SEMICOLON.join((self.at, *(read.text for read in self.reads)))


def axis(label: str) -> tuple[str, str]:
    """The name of an axis and its unit; what is explained in brackets behind it belongs to neither."""
    bare_label = re.sub(r" \([^()]*\)$", "", label)
    name, _, unit = bare_label.rpartition(", ")
    return (name, unit) if name else (unit, "")


def step_of(low: float, high: float) -> float:
    """A step at 1, 2 or 5 times a power of ten."""
    wanted = (high - low) / STEPS
    if not wanted > 0:
        return 1.0
    power = 10.0 ** math.floor(math.log10(wanted))
    return next((n * power for n in (1, 2, 5) if n * power >= wanted * (1 - 1e-9)), 10 * power)


def largest_of(values: Any) -> float:
    magnitudes = np.abs(np.asarray(values, float).ravel())
    magnitudes = magnitudes[np.isfinite(magnitudes)]
    return float(magnitudes.max()) if magnitudes.size else 0.0


class Digits:
    """Numbers of one series, all with the same decimals: four significant digits for the largest of them, as
    everywhere."""

    def __init__(self, values: Any, dust: float = 0.0) -> None:
        largest = largest_of(values)
        if largest <= dust:  # nothing but rounding: written like what is beside it
            largest = dust / DUST
        self.plain = largest == 0 or 1e-2 <= largest < 1e5
        self.decimals = (
            min(DIGITS + 2, max(0, DIGITS - 1 - math.floor(math.log10(largest)))) if largest and self.plain else 0
        )

    def write(self, value: float, unit: str = "") -> Amount:
        if not self.plain or not math.isfinite(value):
            return Amount(value, unit)
        return fixed(value, self.decimals, unit)


def fixed(value: float, decimals: int, unit: str = "") -> Amount:
    """A number with so many decimals; one that they make zero has no sign."""
    return Amount(value if round(value, decimals) else 0.0, unit, form=f".{decimals}f")


class Reader:
    """Reads one sight of a curve, and moves a cursor over it.

    `kind`: "x" where every series is a function of x; "bars"; "along" where all series run along the same parameter;
    else "points"."""

    def __init__(self, sight: Sight) -> None:
        self.sight, self.curve = sight, sight.curve
        self.points = [_points(s.x, s.y) for s in sight.series]
        self.kind = self._kind()

    def _kind(self) -> str:
        curve = self.curve
        if not any(x.size for x, _ in self.points):
            return ""
        if curve.bars:
            return "bars"
        if curve.along is not None and all(
            len(s.x) == len(curve.along[1]) == len(x) for s, (x, _) in zip(self.sight.series, self.points)
        ):
            return "along"
        rising = all(
            x.size < 2 or bool(np.all(np.diff(x) >= 0)) or bool(np.all(np.diff(x) <= 0)) for x, _ in self.points
        )
        return "x" if rising and not curve.equal else "points"

    # --- where the cursor can stand
    @cached_property
    def stops(self) -> Any:
        """The places of bars, the parameters of a locus, the numbers of the points of the chosen series; of a function
        its two ends."""
        if self.kind == "along":
            assert self.curve.along is not None
            return np.asarray(self.curve.along[1], float)
        every = np.concatenate([x for x, _ in self.points])
        return np.unique(every) if self.kind == "bars" else np.array([every.min(), every.max()])

    def _stops(self, cursor: Cursor) -> Any:
        return np.arange(max(1, self.points[cursor.line][0].size)) if self.kind == "points" else self.stops

    @property
    def step(self) -> float:
        return step_of(*self.stops)

    def kept(self, cursor: Cursor) -> Cursor:
        """The same place, or the nearest that there is."""
        line = min(cursor.line, len(self.points) - 1)
        stops = self._stops(replace(cursor, line=line))
        if self.kind == "x":
            return Cursor(float(min(max(cursor.place, stops[0]), stops[1])), line)
        return Cursor(float(stops[_nearest(stops, cursor.place)]), line)

    def start(self) -> Cursor:
        """In the middle, at the first series that has points."""
        line = next(n for n, (x, _) in enumerate(self.points) if x.size)
        stops = self._stops(Cursor(0.0, line))
        if self.kind == "x":
            return self.kept(Cursor(round(float(stops.mean()) / self.step) * self.step, line))
        return Cursor(float(stops[len(stops) // 2]), line)

    def moved(self, cursor: Cursor, by: int, fine: bool = False) -> Cursor:
        """A step on; places of a function are multiples of the step."""
        cursor = self.kept(cursor)
        if self.kind == "x":
            step = self.step / FINER if fine else self.step
            whole = cursor.place / step
            near = round(whole)
            count = (
                near + by if abs(whole - near) < 1e-6 else math.floor(whole) + by if by > 0 else math.ceil(whole) + by
            )
            return self.kept(replace(cursor, place=count * step))
        stops = self._stops(cursor)
        size = 1 if fine or self.kind == "bars" else max(1, len(stops) // STEPS)
        at = _nearest(stops, cursor.place) + by * size
        return replace(cursor, place=float(stops[min(max(at, 0), len(stops) - 1)]))

    def ended(self, cursor: Cursor, last: bool) -> Cursor:
        return replace(cursor, place=float(self._stops(cursor)[-1 if last else 0]))

    def other(self, cursor: Cursor, by: int) -> Cursor:
        """The next series.  Where the cursor runs over its points, at about the same share of them."""
        line = (cursor.line + by) % len(self.points)
        if self.kind != "points":
            return replace(cursor, line=line)
        old, new = len(self._stops(cursor)), len(self._stops(replace(cursor, line=line)))
        return Cursor(float(round(cursor.place * (new - 1) / max(1, old - 1))), line)

    def nearest(self, x: float, y: float, across: float, up: float) -> Cursor:
        """To where was pointed; `across` and `up` are how far a cell reaches."""
        if self.kind == "x":
            reads = self.read(self.kept(Cursor(x))).reads
            near = min(reads, key=lambda r: abs(r.y - y) if math.isfinite(r.y) else math.inf)
            return self.kept(Cursor(x, near.number))
        if self.kind == "bars":
            return self.kept(Cursor(x))
        away = [
            np.hypot((xs - x) / across, (ys - y) / up) if xs.size else np.array([math.inf]) for xs, ys in self.points
        ]
        line = min(range(len(away)), key=lambda n: float(away[n].min()))
        at = int(away[line].argmin())
        return Cursor(float(self.stops[at]) if self.kind == "along" else float(at), line)

    # --- what is read
    @cached_property
    def _digits(self) -> tuple[Digits, ...]:
        """Of each series; places in true scale all have the same."""
        axes = ("x", "y") if self.curve.equal else ("y",)
        dust = DUST * max(largest_of(getattr(s, name)) for s in self.curve.series for name in axes)
        largest = [max(largest_of(getattr(s, name)) for name in axes) for s in self.sight.series]
        if self.curve.equal and axis(self.curve.y_label)[1] == PLACES:
            largest = [max(largest)] * len(largest)
        return tuple(Digits(size, dust) for size in largest)

    def read(self, cursor: Cursor) -> Reading:
        cursor = self.kept(cursor)
        if self.kind == "x":
            x = cursor.place
            name, unit = axis(self.curve.x_label)
            decimals = max(0, -math.floor(math.log10(self.step / FINER) + 1e-9))
            at = _at_axis(name, fixed(x, decimals, unit))
            return Reading(
                at, tuple(self._one(n, x, _at(points, x)) for n, points in enumerate(self.points)), x, cursor.line
            )
        if self.kind == "bars":
            x = cursor.place
            bars = ((n, ys[xs == x]) for n, (xs, ys) in enumerate(self.points))
            reads = tuple(self._one(n, x, float(y[0]) if y.size else math.nan) for n, y in bars)
            return Reading(self._group(x), reads, x, cursor.line)
        at_point = _nearest(self._stops(cursor), cursor.place)
        if self.kind == "along":
            assert self.curve.along is not None
            name, unit = axis(self.curve.along[0])
            at = _at_axis(name, Amount(cursor.place, unit))
            lines = tuple(range(len(self.points)))
        else:
            at = Text("point {n} of {count}", n=at_point + 1, count=int(self.points[cursor.line][0].size))
            lines = (cursor.line,)
        reads = tuple(
            self._place(n, float(self.points[n][0][at_point]), float(self.points[n][1][at_point])) for n in lines
        )
        return Reading(at, reads, None, cursor.line)

    def _group(self, x: float) -> Text:
        """The name of a group of bars."""
        names = self.curve.names
        if names and x == int(x) and 1 <= x <= len(names):
            group = names[int(x) - 1]
            number = str(group)[:1].isdigit()  # an order: two numbers beside each other say nothing
            return (
                Text("{what} {name}", what=self.curve.x_label, name=group)
                if number
                else Text("{n} {name}", n=int(x), name=group)
            )
        name, unit = axis(self.curve.x_label)
        return _at_axis(name, Amount(x, unit))

    def _one(self, n: int, x: float, y: float) -> Read:
        digits, unit = self._digits[n], axis(self.curve.y_label)[1]
        near = (
            sorted((limit for limit in finite_limits(self.curve)), key=lambda limit: abs(y - limit[1]))
            if math.isfinite(y)
            else []
        )
        brief, value = (Text("{y}", y=digits.write(y, shown)) if math.isfinite(y) else NOTHING for shown in ("", unit))
        return Read(
            n, self.sight.series[n].label, x, y, value, brief, tuple(_distance(digits, y, *limit) for limit in near)
        )

    def _place(self, n: int, x: float, y: float) -> Read:
        (x_name, x_unit), (y_name, y_unit) = axis(self.curve.x_label), axis(self.curve.y_label)
        digits = self._digits[n]
        x_name, y_name = x_name.partition(":")[0], y_name.partition(":")[0]
        brief = Text("({x}; {y})", x=digits.write(x), y=digits.write(y))
        at_x = _at_axis(x_name, digits.write(x, x_unit if x_unit != y_unit else ""))
        value = COMMA.join((at_x, _at_axis(y_name, digits.write(y, y_unit))))
        if x_unit == y_unit and self.curve.equal and y_unit != PLACES:
            length = digits.write(math.hypot(x, y))
            value = Text("{place}, length {length}", place=value, length=length)
            brief = Text("{place}, length {length}", place=brief, length=length)
        return Read(n, self.sight.series[n].label, x, y, value, brief)


def _at_axis(name: str, value: Amount) -> Text:
    return Text("{axis} {value}", axis=name, value=value)


def _distance(digits: Digits, y: float, name: str, limit: float) -> Text:
    away = digits.write(abs(y - limit))
    if not any(char in "123456789" for char in away.written()):
        return Text("on {name}", name=name)
    return (
        Text("{away} above {name}", away=away, name=name)
        if y > limit
        else Text("{away} below {name}", away=away, name=name)
    )


def finite_limits(curve: Curve) -> list[tuple[str, float]]:
    return [(name, float(value)) for name, value in curve.limits if math.isfinite(value)]


def _points(x: Any, y: Any) -> tuple[Any, Any]:
    xs, ys = np.asarray(x, float).ravel(), np.asarray(y, float).ravel()
    whole = np.isfinite(xs) & np.isfinite(ys)
    return xs[whole], ys[whole]


def _at(points: tuple[Any, Any], x: float) -> float:
    """As the line is drawn: straight between the points, nothing beyond them."""
    xs, ys = points
    if not xs.size:
        return math.nan
    if xs[0] > xs[-1]:
        xs, ys = xs[::-1], ys[::-1]
    return float(np.interp(x, xs, ys, left=math.nan, right=math.nan))


def _nearest(stops: Any, place: float) -> int:
    return int(np.abs(stops - place).argmin())
