# SPDX-License-Identifier: Apache-2.0
"""What a figure shows, as a person would say it to somebody who can not see it: sentences in the report's language."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Any

import numpy as np

from calc.locale import Language
from calc.sheet.number import DUST, short
from calc.sheet.step import Curve, Series
from calc.sheet.text import Name, Text, with_unit

from .plots import limits, numbers, series_label

ALIKE = 1e-9  # of the largest value of a line: two that are no further apart are alike, and the first is named

OVER = Text("Over {axis}")
RUNS = Text("{name} is largest, {most}, at {most_at}, and smallest, {least}, at {least_at}")
STAYS = Text("{name} is {value} throughout")
REACHES = Text("{name} reaches from {left} to {right} across and from {low} to {high} upwards")
MARKED = Text("{name} is marked at {place}")
LIMIT = Text("the limit {name} is {value}")
FURTHEST = Text("{name} goes furthest at {place}, by {value}")
LOAD = Text("{name} of {value} at {place}")
FAILS, WARNS = Text("{words} (fails)"), Text("{words} (warns)")


def in_words(curve: Curve, say: Language) -> str:
    """Of every line its largest and its smallest value and where they are; then forces and limits."""
    (x_name, x_unit), (y_name, y_unit) = _axis(say(curve.x_label)), _axis(say(curve.y_label))

    def at(x: float) -> Name:
        if curve.names and 0 < round(x) <= len(curve.names):
            return Name(say(curve.names[round(x) - 1]))
        return _amount(x, x_unit, say)

    phrases: list[str] = []
    for series in curve.series if not curve.loads else ():  # these draw the shaft that they load
        name = Name(say(series_label(curve, series)) or y_name)
        phrases += _line(curve, series, name, (x_unit, y_unit), at, say)
    for load in curve.loads:
        size = _amount(load.size, say(curve.load_unit), say)
        phrases.append(say(Text(LOAD.template, name=Name(say(load.label)), value=size, place=at(load.x))))
    for label, value in limits(curve):
        phrases.append(say(Text(LIMIT.template, name=Name(say(label)), value=_amount(value, y_unit, say))))
    head = "" if curve.equal or curve.names else say(Text(OVER.template, axis=Name(x_name))) + ": "
    return head + "; ".join(phrases)


def _line(curve: Curve, series: Series, name: Name, units: tuple[str, str], at: Any, say: Language) -> list[str]:
    x, y = np.broadcast_arrays(numbers(series.x), numbers(series.y))
    known = np.isfinite(x) & np.isfinite(y)
    x, y = x[known], y[known]
    if not y.size:
        return []
    if curve.equal:
        largest = max(np.abs(x).max(), np.abs(y).max())
        x, y = (np.where(np.abs(values) > DUST * largest, values, 0.0) for values in (x, y))
        ends = {"left": (x.min(), units[0]), "right": (x.max(), units[0]), "low": (y.min(), units[1])}
        ends["high"] = (y.max(), units[1])
        words = {key: _amount(float(value), unit, say) for key, (value, unit) in ends.items()}
        return [say(Text(REACHES.template, name=name, **words))]
    if x.size > 1 and np.ptp(x) == 0.0:
        return [say(Text(MARKED.template, name=name, place=at(float(x[0]))))]
    y = np.where(np.abs(y) > DUST * np.abs(y).max(), y, 0.0)
    if np.ptp(y) <= ALIKE * np.abs(y).max():
        return [say(Text(STAYS.template, name=name, value=_amount(float(y[0]), units[1], say)))]
    if curve.names:
        place = int((np.abs(y) >= (1.0 - ALIKE) * np.abs(y).max()).argmax())
        value = _amount(float(y[place]), units[1], say)
        return [say(Text(FURTHEST.template, name=name, place=at(float(x[place])), value=value))]
    parts: dict[str, Name] = {"name": name}
    for key, extreme in (("most", y.max()), ("least", y.min())):
        place = int((np.abs(y - extreme) <= ALIKE * np.abs(y).max()).argmax())
        parts |= {key: _amount(float(extreme), units[1], say), f"{key}_at": at(float(x[place]))}
    return [say(Text(RUNS.template, **parts))]


def _axis(label: str) -> tuple[str, str]:
    """What an axis has, and its unit."""
    name, comma, unit = label.rpartition(", ")
    return (name, unit) if comma else (label, "")


def _amount(value: float, unit: str, say: Language) -> Name:
    return Name(with_unit(say.number(short(value)), unit))


SAYS = re.compile(r"[^\W\d_]{2}")  # a word, or a unit: two letters


def read_out(written: Iterable[str]) -> list[str]:
    """Of what is written in a drawing what is read out: each once, and no lone numbers and letters."""
    return [words for words in dict.fromkeys(written) if SAYS.search(words)]


def with_state(words: str, state: str, say: Language) -> str:
    """Words of a sketch, and after them what a sign says there."""
    told = {"fail": FAILS, "warn": WARNS}.get(state)
    return words if told is None else say(Text(told.template, words=Name(words)))
