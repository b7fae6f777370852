# SPDX-License-Identifier: Apache-2.0
"""A symbol in a formula stands for the value that was put in."""

import pytest

from calc.sheet.expression import expression, line_text, show, symbols_put_in, text
from calc.sheet.formula import formula
from calc.sheet.units import Metre, Number
from calc.sheet.value import based_on, trace
from calc.solve import Results


@formula("g_T", "made here: a clearance when warm")
def warm(g: Metre) -> Metre:
    return g + 1e-5


@formula("d_b", "made here: a circle")
def circle(d: Metre) -> Metre:
    return 0.9 * d


@formula("ψ", "made here")
def relative(g: Metre, d: Metre) -> Number:
    return g / d


@formula("x", "made here")
def of_two(d_b1: Metre, d_b2: Metre) -> Number:
    return d_b1 / d_b2


@formula("g_T", "made here: the same once more")
def warmer(g: Metre) -> Metre:
    return g + 2e-5


def test_the_value_s_own_symbol_stands_there() -> None:
    with trace() as lines:
        relative(g=warm(g=8e-5), d=0.06)
    assert symbols_put_in(lines[1:]) == {"g": "g_T"}
    assert line_text(lines[1])[:2] == ("ψ = g_T/d", "= 9·10⁻⁵/0.06 = 1.5·10⁻³")


def test_where_the_formula_says_more_or_two_would_be_alike_its_own_stands() -> None:
    with trace() as lines:
        of_two(d_b1=circle(d=0.05), d_b2=circle(d=0.07))
        warmer(g=warm(g=8e-5))
    assert symbols_put_in([lines[2]]) == {} and text(show(lines[2]).formula) == "d_b1/d_b2"  # type: ignore[arg-type]
    assert symbols_put_in([lines[4]]) == {}, "what comes out is called so"


def test_what_was_only_found_from_a_value_is_not_called_so() -> None:
    with trace() as lines:
        value = warm(g=8e-5)
        relative(g=based_on(-value, value), d=0.06)
    assert symbols_put_in(lines[1:]) == {}


def test_of_several_lines_only_what_all_say() -> None:
    with trace() as lines:
        relative(g=warm(g=8e-5), d=0.06)
        relative(g=8e-5, d=0.06)
    assert symbols_put_in([lines[1], lines[2]]) == {} and symbols_put_in([lines[1], lines[1]]) == {"g": "g_T"}


def test_no_two_values_of_a_line_are_called_alike(gamma_results: Results) -> None:
    renamed = 0
    for outcome in gamma_results.outcomes.values():
        for line in outcome.lines:
            if expression(line.formula) is None:
                continue
            called = symbols_put_in([line])
            renamed += len(called)
            own = [line.formula.names.get(name, name) for name in line.arguments]
            said = [called.get(name, name) for name in own]
            assert len(set(said)) == len(set(own)), line.formula.__name__
    assert renamed > 500


@pytest.mark.parametrize(
    ("formula_name", "own", "said"), [("relative_clearance", "g", "g_T"), ("surface_speed", "n", "n_h")]
)
def test_in_a_design(gamma_results: Results, formula_name: str, own: str, said: str) -> None:
    lines = [line for line in gamma_results.outcomes["bearings"].lines if line.formula.__name__ == formula_name]
    assert any(symbols_put_in([line]).get(own) == said for line in lines)
