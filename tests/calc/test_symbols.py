# SPDX-License-Identifier: Apache-2.0
"""A symbol means one thing in a chapter: within a step it never stands for quantities of two dimensions."""

import pytest

from calc.design.model import STEPS
from calc.sheet.expression import symbol, symbol_of
from calc.sheet.formula import units
from calc.sheet.value import Line
from tests.conftest import FEW
from tests.reports.reading import solved

Meanings = dict[str, dict[str, str]]  # symbol → dimension, as its unit in SI, → where it stands


@pytest.fixture(scope="module")
def lines() -> dict[str, list[Line]]:
    """The lines of every step in all shipped designs, of each formula one."""
    found: dict[str, dict[object, Line]] = {step.key: {} for step in STEPS}
    for path in FEW:
        for key, outcome in solved(path.read_bytes()).results.outcomes.items():
            for line in outcome.lines:
                found[key].setdefault(line.formula, line)
    return {key: list(of.values()) for key, of in found.items()}


@pytest.mark.parametrize("step", [step.key for step in STEPS])
def test_no_symbol_has_two_dimensions_in_a_chapter(lines: dict[str, list[Line]], step: str) -> None:
    meanings: Meanings = {}
    for line in lines[step]:
        formula, known = line.formula, units(line.formula)
        meanings.setdefault(symbol_of(line), {}).setdefault(known.get("return", ""), formula.__name__)
        if not formula.shows:  # of an algorithm no symbol is written but its own
            for name in formula.parameters:
                written = formula.names.get(name) or symbol(name)
                meanings.setdefault(written, {}).setdefault(known.get(name, ""), f"in {formula.__name__}")
    assert len(meanings) > 40
    assert {sign: of for sign, of in meanings.items() if len(of) > 1} == {}


def test_a_symbol_of_one_order_carries_its_number(lines: dict[str, list[Line]]) -> None:
    forward = [line for line in lines["imbalance"] if line.formula.__name__ == "couple_forward"]
    assert forward and all(symbol_of(line) == f"C_{line.arguments['n']:g}⁺" for line in forward)
    speeds = [line for line in lines["bearings"] if "n" in line.arguments and "_n" in line.formula.symbol]
    assert all(symbol_of(line) == line.formula.symbol for line in speeds)


def test_no_formula_gives_a_symbol_that_it_takes(lines: dict[str, list[Line]]) -> None:
    """F = F·(n/n_rated)² would be an equation for the ratio; the length |C| of C is another symbol."""
    wrong = {
        line.formula.__name__
        for step in lines.values()
        for line in step
        if not line.formula.shows
        and line.formula.symbol in {line.formula.names.get(name) or symbol(name) for name in line.formula.parameters}
    }
    assert wrong == set()
