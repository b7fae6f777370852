# SPDX-License-Identifier: Apache-2.0
"""A comparison as tables, which terminal, screen and paper draw alike.

A number is written with as many digits as it takes to tell it from the other one.
"""

from collections.abc import Callable, Sequence
from typing import Any

from .compare import CheckDifference, Comparison, InputDifference, Judged, ValueDifference, turn
from .design import STEPS
from .sheet.check import Check
from .sheet.number import short
from .sheet.step import Table

DIGITS, MOST_DIGITS = 4, 12
LEFT_OUT = "left out"
NOT_HERE = "–"
Names = tuple[str, str]
Sign = Callable[[str], str]  # how a verdict is written


# --- inputs -----------------------------------------------------------------------------------------------------------------
def input_table(found: Sequence[InputDifference], names: Names, *, ids: bool = True, full: bool = False) -> Table:
    """`ids`: by their keys, which say the unit too, else by their labels.  `full`: tables that only one design has are written out."""
    if ids:
        by_key = tuple((d.key, *input_texts(d, full=full)) for d in found)
        return Table("inputs", "Inputs that differ", _columns(("Key", ""), names), by_key)
    rows = tuple((named(d.key, d.label, step=True), *input_texts(d, full=full), d.unit) for d in found)
    return Table("inputs", "Inputs that differ", _columns(("Input", ""), names, ("Unit", "")), rows)


def input_texts(d: InputDifference, *, full: bool = False) -> tuple[str, str]:
    """Both sides of an input in words."""
    missing = "not asked" if d.key in {step.key for step in STEPS} else LEFT_OUT
    return _content(d.a, missing, full), _content(d.b, missing, full)


def _content(content: Any, missing: str, full: bool) -> str:
    if content is None:
        return missing
    if isinstance(content, dict):
        if full:
            return ", ".join(f"{key} = {_content(item, missing, full)}" for key, item in content.items())
        return "1 key" if len(content) == 1 else f"{len(content)} keys"
    if isinstance(content, list):
        if content and isinstance(content[0], dict):
            if full:
                return "; ".join(_content(item, missing, full) for item in content)
            return "1 element" if len(content) == 1 else f"{len(content)} elements"
        return "; ".join(_content(item, missing, full) for item in content)
    return content if isinstance(content, str) else short(content, MOST_DIGITS)


def named(id: str, label: str, *, step: bool = False) -> str:
    """A label with the part of the design that it belongs to: Length (front); `step`: Length (bearings, front)."""
    where = ", ".join(id.split(".")[0 if step else 1 : -1])
    return f"{label} ({where})" if where else label


# --- verdicts and checks ----------------------------------------------------------------------------------------------------
def verdict_table(compared: Comparison, names: Names, sign: Sign) -> Table:
    rows = tuple((v.title, judged_text(v.a, sign), judged_text(v.b, sign)) for v in compared.verdicts)
    return Table("verdicts", "Verdicts of the steps", _columns(("Step", ""), names), rows)


def judged_text(judged: Judged, sign: Sign) -> str:
    verdict = sign(judged.verdict)
    if judged.reason:
        return f"{verdict}: {judged.reason}"
    if judged.fail and judged.warn:
        return f"{verdict}: {judged.fail} fail, {judged.warn} warn"
    if judged.fail:
        return f"{verdict}: {judged.fail} fail"
    return f"{verdict}: {judged.warn} warn" if judged.warn else verdict


def check_table(found: Sequence[CheckDifference], names: Names, sign: Sign, *, ids: bool = True, margins: bool = True) -> Table:
    """`ids`: checks by their ids, else by their names."""
    rows = []
    for d in found:
        values = pair(d.a.value if d.a else None, d.b.value if d.b else None)
        sides = [_judged_value(check, value, sign) for check, value in zip((d.a, d.b), values)]
        beside = [check.margin_text() if check else "" for check in (d.a, d.b)] if margins else []
        rows.append((d.id if ids else d.name, *sides, limit_text(d), *beside))
    heads = [(f"Margin, {name}", "") for name in names] if margins else []
    columns = (*_columns(("Check", ""), names, ("Limit", "")), *heads)
    return Table("checks", "Checks that differ", columns, tuple(rows))


def _judged_value(check: Check | None, value: str, sign: Sign) -> str:
    return f"{sign(check.verdict)} {value} {check.unit}".rstrip() if check is not None else NOT_HERE


def limit_text(d: CheckDifference) -> str:
    """The limit; where it has moved, both."""
    texts = [f"{c.limit_text()} (advice)" if c.kind == "advice" else c.limit_text() for c in (d.a, d.b) if c is not None]
    return texts[0] if len(set(texts)) == 1 else f"{texts[0]} → {texts[1]}"


# --- values -----------------------------------------------------------------------------------------------------------------
def value_table(step: str, title: str, found: Sequence[ValueDifference], names: Names, *, ids: bool = True) -> Table:
    """The values of one step; `ids`: by their ids with the labels last, else by their labels."""
    rows = []
    for d in found:
        cells = (*pair(d.a, d.b), d.unit, change_text(d))
        rows.append((d.id, *cells, d.label) if ids else (named(d.id, d.label), *cells))
    columns = _columns(("Value", ""), names, ("Unit", ""), ("Change", ""))
    return Table(f"values_{step}", title, (*columns, ("", "")) if ids else columns, tuple(rows))


def pair(a: float | None, b: float | None) -> tuple[str, str]:
    """Two numbers with as many digits as tell them apart."""
    if a is None or b is None:
        return (NOT_HERE if a is None else short(a), NOT_HERE if b is None else short(b))
    for digits in range(DIGITS, MOST_DIGITS + 1):
        if (texts := (short(a, digits), short(b, digits)))[0] != texts[1]:
            return texts
    return short(a), short(b)


def change_text(d: ValueDifference) -> str:
    """From A to B: in degrees for a phase, in K for a temperature, else in percent of A."""
    if d.a is None or d.b is None:
        return ""
    if d.phase:
        return f"{_signed(turn(d.a, d.b))}°"
    if d.unit == "°C":
        return f"{_signed(d.b - d.a)} K"
    if d.a == 0:
        return "from 0"
    percent = (d.b - d.a) / abs(d.a) * 100
    if abs(percent) > 99999:  # of next to nothing
        return "> +99999 %" if percent > 0 else "< −99999 %"
    return f"{_signed(percent)} %"


def _signed(number: float) -> str:
    text = f"{number:+.0f}" if abs(number) >= 100 else f"{number:+.2g}"
    return text.replace("-", "−")


def _columns(first: tuple[str, str], names: Names, *more: tuple[str, str]) -> tuple[tuple[str, str], ...]:
    return (first, (names[0], ""), (names[1], ""), *more)
