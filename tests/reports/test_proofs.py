"""The proofs of a report, worked out again from what is printed: each substitution gives its value to the last digit,
and within a proof a symbol stands for one value."""

import math
import random
from collections import defaultdict
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from calc.design.toml_file import design, read
from calc.sheet.expression import Expr, Shown, text
from calc.sheet.units import UNITS
from calc.solve import solve
from reports.blocks.proof import Proof, _walked, demand, limit, proofs
from reports.context import Context
from reports.report import context_of
from reports.typesetting.pagination import Formula
from tests.calc.sheet.test_substitutions import number, worked_out
from tests.conftest import SHIPPED, each_shipped

THREE = [path for path in SHIPPED if path.stem in ("r753ie4_gamma", "r754ie4_balance_shafts", "r753ie4_rolling")]


@cache
def reported(path: Path) -> list[tuple[Proof, list[Formula]]]:
    """Every proof of an engineer's report with its formulas."""
    document = read(path)
    context = context_of(document, solve(design(document)), document.raw, depth="engineer", lang="en")
    return [
        (proof, list(formulas(context, step, proof)))
        for _, step, outcome in context.steps()
        for proof in proofs(context, outcome.checks)
    ]


def formulas(context: Context, step, proof: Proof) -> Iterator[Formula]:
    for walk in (limit(context, proof, {}), demand(context, proof, {})):
        for block in _walked(context, step, walk):
            if isinstance(block.content, Formula):
                yield block.content


def digits(written: str) -> int:
    """With how many a number is given, at least four; noughts at the end of a whole number need not be given."""
    mantissa = written.partition("·10")[0].lstrip("−")
    given = mantissa.replace(".", "").lstrip("0")
    return max(4, len(given if "." in mantissa else given.rstrip("0")))


def half_a_unit(written: str) -> float:
    value = abs(number(written))
    return 0.5 * 10.0 ** (math.floor(math.log10(value)) - digits(written) + 1) if value else 5e-4


def off(line: Shown) -> str:
    """What a substitution gives instead of its value; empty where it gives that."""
    assert line.numbers is not None
    written = text(line.numbers)
    if "…" in written:
        return ""
    # a vector is given by its angle as well, in degrees
    factor = 1.0 if line.unit not in UNITS else UNITS[line.unit].factor
    again = worked_out(written) / factor
    length, _, angle = line.value.rstrip("°").partition("∠")
    if angle:
        turned = math.remainder(math.degrees(np.angle(again)) - number(angle), 360)
        close = abs(turned) <= half_a_unit(angle) * (1 + 1e-6)
        again = abs(again)
    else:
        close = True
    close = close and abs(again - number(length)) <= half_a_unit(length) * (1 + 1e-6)
    return "" if close else f"{line.symbol}: {written} is {again}, not {line.value} {line.unit}"


def substitutions() -> list[Shown]:
    return [
        line
        for path in THREE
        for _, found in reported(path)
        for formula in found
        for _, line in formula.lines
        if line.numbers is not None
    ]


def test_30_at_random_close_with_the_digits_printed() -> None:
    every = substitutions()
    assert len(every) > 150
    assert not (wrong := list(filter(None, map(off, random.sample(every, 30))))), "\n".join(wrong)


@pytest.mark.slow
def test_all_of_them_close() -> None:
    assert not (wrong := list(filter(None, map(off, substitutions())))), "\n".join(wrong)


def named(formula: Expr, numbers: Expr) -> Iterator[tuple[str, str]]:
    """The symbols of a formula with the numbers that stand for them."""
    if formula.head == "symbol" and numbers.head == "number":
        yield formula.name, numbers.name
    for part, its in zip(formula.args, numbers.args):
        yield from named(part, its)


def values_by_symbol(found: list[Formula]) -> dict[tuple[str, str], list[tuple[str, float]]]:
    """By the part and the symbol, each number that is printed for it, and what it is in SI."""
    values = defaultdict(list)
    of_all = None
    for formula in found:
        of_all = formula.first or of_all
        for label, line in formula.lines:
            printed = [(line.symbol, line.value, UNITS[line.unit].factor if line.unit in UNITS else 1.0)]
            if line.numbers is not None and of_all is not None and of_all.formula is not None:
                printed += [(symbol, written, 1.0) for symbol, written in named(of_all.formula, line.numbers)]
            for symbol, written, factor in printed:
                try:
                    values[label, symbol].append((written, number(written) * factor))
                except (ValueError, KeyError):  # a list, a vector, a word
                    continue
    return values


def apart(a: tuple[str, float], b: tuple[str, float]) -> bool:
    """Whether two numbers are not roundings of one value."""
    if not a[1] or not b[1]:
        return abs(a[1] - b[1]) > 1e-9
    room = sum(half_a_unit(written) * abs(value / number(written)) for written, value in (a, b))
    return abs(a[1] - b[1]) > room * (1 + 1e-6)


@pytest.mark.parametrize("path", each_shipped())
def test_a_symbol_has_one_value_in_a_proof(path: Path) -> None:
    wrong = [
        f"{proof.governing.id}, {label or 'all'}: {symbol} is {sorted({written for written, _ in values})}"
        for proof, found in reported(path)
        for (label, symbol), values in values_by_symbol(found).items()
        if any(apart(values[0], other) for other in values[1:])
    ]
    assert not wrong, "\n".join(wrong)


def test_two_values_are_seen() -> None:
    assert apart(("1.41", 1.41), ("1.42", 1.42)) and not apart(("0.8638", 0.8638), ("0.863816", 0.863816))
