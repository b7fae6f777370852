"""The formula mechanism: calling, recording, and rendering from the expression itself."""

import gc
import inspect
import pydoc
import re
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from calc.library.journal_rules import specific_load
from calc.sheet import expression
from calc.sheet.expression import line_json, line_text, symbol
from calc.sheet.formula import FORMULAS, Formula, definition, formula
from calc.sheet.functions import cis, exp, pi, sqrt, total
from calc.sheet.units import Kilogram, Metre, Newton, Number, Pascal, Radian
from calc.sheet.value import about, trace, untraced

LIMIT: Metre = 1.7e-9


@formula("p", "a formula for this test", unit="MPa")
def pressure(F: Newton, d: Metre, l: Metre) -> Pascal:
    return F / (d * l)


@formula("x_1", "a formula for this test")
def tangle(a: Number, omega: Number, alpha_wt: Number) -> Number:
    return -((a + omega) ** 2) * sqrt(a - (omega - alpha_wt)) / (2 * pi) ** 0.56 + a / omega / 3 - exp(-a) * 1.153423


@formula("h", "a formula for this test", governs="min")
def thinnest(h: Metre, k: Number) -> Metre:
    return h * k


@formula("U", "a formula for this test")
def vector(m: Kilogram, e: Metre, gamma: Radian) -> Number:
    return total(m * e * cis(gamma))


@formula("n", "a formula for this test")
def rule(u: Metre) -> Number:
    return u / LIMIT


@formula("ε", "a formula for this test", shows="ε from a table at S")
def looked_up(S: Number) -> Number:
    for _ in range(3):
        S = S / 2
    return S


@formula("δ", "a formula for this test", unit="µm")
def gap(a: Metre, b: Metre) -> Metre:
    return a - b


HALF: Number = 0.5235987755982988


@formula("w", "a formula for this test")
def with_unit(u: Metre) -> Number:
    return HALF * u / 1


@formula("w", "a formula for this test")
def of_ones(u: Metre, a: Metre) -> Number:
    return 1 * u / 1 - (a - u) * 1


def only(call, *args, **kwargs):
    with trace() as lines:
        call(*args, **kwargs)
    (line,) = lines
    return line


def test_a_call_returns_the_plain_number_and_records_nothing_outside_a_trace():
    assert pressure(1000.0, 0.1, 0.05) == pytest.approx(200000.0)
    assert pressure(F=1000.0, d=0.1, l=0.05) == pressure(1000.0, d=0.1, l=0.05)


@pytest.mark.parametrize(
    "call", [lambda: pressure(1710.0, 0.0595, 0.0275), lambda: pressure(l=0.0275, d=0.0595, F=1710.0)]
)
def test_positional_and_keyword_calls_render_alike(call):
    assert line_text(only(call)) == ("p = F/(d·l)", "= 1710/(0.0595·0.0275) = 1.045 MPa", "a formula for this test")


def test_precedence_signs_roots_powers_and_written_constants():
    formula_text, numbers, _ = line_text(only(tangle, 2.0, -3.0, 0.5))
    assert formula_text == "x₁ = −(a + ω)²·√(a − (ω − α_wt))/(2·π)^0.56 + a/ω/3 − exp(−a)·1.153423"
    assert "(2 + (−3))²" in numbers and "√(2 − ((−3) − 0.5))" in numbers


KNOWN = {"a": 0.7, "b": 1.3, "c": 1.9, "d": 0.4}
NODES = {
    "add": lambda x, y: x + y,
    "sub": lambda x, y: x - y,
    "mul": lambda x, y: x * y,
    "div": lambda x, y: x / y,
    "pow": lambda x, y: x**y,
    "neg": lambda x: -x,
    "sqrt": lambda x: x**0.5,
    "cis": lambda x: np.exp(1j * x),
    "sum": lambda x: x,
}
A, TWO = expression.Expr("symbol", (), "a"), expression.Expr("number", (), "2")
leaves = st.sampled_from(
    [
        *(expression.Expr("symbol", (), name) for name in KNOWN),
        *(expression.Expr("number", (), n) for n in ("2", "3", "0.5", "−2")),
    ]
)
trees = st.recursive(
    leaves,
    lambda inner: st.builds(
        lambda head, one, other: expression.Expr(
            head, (one, other) if head in ("add", "sub", "mul", "div", "pow") else (one,)
        ),
        st.sampled_from(list(NODES)),
        inner,
        inner,
    ),
    max_leaves=8,
)


def meant(tree):
    """The value of a tree; a root of a negative number has two."""
    if tree.head in NODES:
        parts = [meant(one) for one in tree.args]
        if tree.head in ("pow", "sqrt") and abs(parts[0].imag) < 1e-9 and parts[0].real < 0:
            raise ZeroDivisionError
        return complex(NODES[tree.head](*parts))
    return complex(KNOWN.get(tree.name) or float(tree.name.replace("−", "-")))


def read_again(text):
    """The value of what is written, by the rules of arithmetic."""
    text = re.sub(
        "[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+", lambda raised: "**" + raised[0].translate(str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")), text
    )
    text = re.sub(r"√(\w+(?:\.\d+)?)", r"√(\1)", text)
    for sign, word in (("·", "*"), ("−", "-"), ("^", "**"), ("√", "root"), ("Σ", "")):
        text = text.replace(sign, word)
    return eval(
        text, {"root": lambda x: (x + 0j) ** 0.5, "e": np.e, "i": 1j, **{name: complex(x) for name, x in KNOWN.items()}}
    )


@given(tree=trees)
@example(tree=expression.Expr("pow", (expression.Expr("pow", (A, TWO)), TWO)))
@example(tree=expression.Expr("pow", (A, expression.Expr("pow", (TWO, TWO)))))
def test_what_is_written_reads_as_what_is_meant(tree):
    """Brackets stand wherever another order of the operations would be read, so of a power of a power."""
    try:
        value = meant(tree)
    except (ZeroDivisionError, OverflowError):
        return
    if np.isfinite(value) and abs(value) < 1e9:
        assert read_again(expression.text(tree)) == pytest.approx(value, rel=1e-6, abs=1e-9)


def test_an_array_is_shown_by_its_governing_value_and_where_it_occurs():
    line = only(thinnest, np.array([3e-6, 1e-6, 2e-6]), 2.0)
    assert line_text(line)[1] == "= 1·10⁻⁶·2 = 2·10⁻⁶ m   (smallest of 3, number 2)"


def test_a_sum_shows_its_terms_and_a_vector_its_length_and_angle():
    formula_text, numbers, _ = line_text(
        only(vector, np.array([1.0, 2.0]), np.array([0.5, 0.5]), np.array([0.0, np.pi / 2]))
    )
    assert formula_text == "U = Σ(m·e·e^(i·γ))"
    assert numbers.startswith("= Σ((1; 2)·(0.5; 0.5)·e^(i·(0; 1.570796))) = 1.118∠63.43°")


def test_a_named_constant_stands_as_its_number():
    assert line_text(only(rule, 1.0))[0] == "n = u/(1.7·10⁻⁹)"


def test_an_algorithm_is_shown_by_its_words():
    assert line_text(only(looked_up, 8.0))[:2] == ("ε: ε from a table at S, at S = 8", "= 1")


def test_where_the_source_text_is_not_at_hand_name_and_arguments_stand_for_it(monkeypatch):
    def no_source(_):
        raise OSError("could not get source code")

    monkeypatch.setattr("inspect.getsource", no_source)
    monkeypatch.setattr("linecache.getlines", lambda *_: [])
    expression.expression.cache_clear()
    try:
        assert line_text(only(pressure, 1000.0, 0.1, 0.05))[:2] == (
            "p: pressure(F = 1000, d = 0.1, l = 0.05)",
            "= 0.2 MPa",
        )
    finally:
        expression.expression.cache_clear()


def test_json_has_what_the_terminal_has():
    assert line_json(only(pressure, 1000.0, 0.1, 0.05)) == {
        "symbol": "p",
        "formula": "F/(d·l)",
        "substituted": "1000/(0.1·0.05)",
        "value": "0.2",
        "unit": "MPa",
        "source": "a formula for this test",
        "about": "",
    }


def test_a_trace_keeps_order_and_subject_and_leaves_iterations_out():
    with trace() as lines:
        with about("front bearing"):
            first = pressure(1.0, 1.0, 1.0)
        with untraced():
            pressure(2.0, 1.0, 1.0)
        pressure(first, 1.0, 1.0)
    assert [(line.about, line.value) for line in lines] == [("front bearing", 1.0), ("", 1.0)]
    assert lines[1].arguments["F"].link is lines[0]


@pytest.mark.parametrize(
    "name, shown",
    [
        ("alpha_wt", "α_wt"),
        ("omega", "ω"),
        ("d1", "d_1"),
        ("F_t", "F_t"),
        ("lambda_", "λ"),
        ("lam", "λ"),
        ("h_aP0", "h_aP0"),
        ("Delta_T", "ΔT"),
    ],
)
def test_symbols(name, shown):
    assert symbol(name) == shown


# --- numbers that give the result
def test_a_difference_shows_as_many_digits_as_its_result_needs():
    assert line_text(only(gap, 0.0658080476, 0.0657517430))[1] == "= 0.065808 − 0.0657517 = 56.3 µm"
    assert line_text(only(gap, 0.0658080476, 0.02))[1] == "= 0.06581 − 0.02 = 45810 µm"


@given(a=st.floats(0.01, 1.0), b=st.floats(0.01, 1.0))
def test_the_numbers_that_are_shown_give_the_result(a, b):
    line = only(gap, a, b)
    shown = expression.show(line)
    left, right = (float(part.name) for part in shown.numbers.args)
    assert left - right == pytest.approx(a - b, rel=5.1e-3) or abs(a - b) < 1e-8


def test_numbers_of_an_array_are_those_of_the_element_that_governs():
    line = only(gap, np.array([0.5, 0.0658080476, 0.2]), np.array([0.5, 0.0657517430, 0.2]))
    assert line_text(line)[1].startswith("= 0.065808 − 0.0657517 = 56.3 µm")


def test_constants_are_short_and_factors_of_one_are_left_out():
    assert line_text(only(with_unit, 2.0))[:2] == ("w = 0.5236·u", "= 0.5236·2 = 1.047")


def test_help_shows_call_units_expression_source_and_docstring():
    text = pydoc.plain(pydoc.render_doc(specific_load))
    assert f"Formula in module {specific_load.__module__}" in text
    assert "specific_load(F: N, d: m, l: m) -> Pa   (shown in MPa)" in text
    assert "p = F / (d * l)" in text
    assert f"Source: {specific_load.source}" in text
    assert ">>> specific_load(" in text


def test_help_on_an_algorithm_shows_its_words():
    assert "looked_up(S: -) -> -\n\nε = ε from a table at S\n\nSource: a formula for this test" in looked_up.__doc__


def test_a_formula_keeps_the_signature_of_its_function():
    assert list(inspect.signature(specific_load).parameters) == ["F", "d", "l"]
    assert inspect.unwrap(specific_load) is specific_load.function
    assert Formula.__doc__.startswith("A formula with its symbol")


def test_ones_that_only_carry_a_unit_are_not_written():
    assert line_text(only(of_ones, 3.0, 2.0))[:2] == ("w = u − (a − u)", "= 3 − (2 − 3) = 4")


def test_threads_that_write_at_once_do_not_disturb_each_other():
    """The collector gives the interpreter to another thread while one of them parses."""
    functions = [each.function for each in list(FORMULAS.values())[:150]]

    def parse(_):
        return [definition(function) is not None for function in functions]

    before = gc.get_threshold()
    gc.set_threshold(20)
    gc.callbacks.append(give_way := lambda *_: time.sleep(0))
    try:
        with ThreadPoolExecutor(4) as threads:
            assert all(map(all, threads.map(parse, range(4))))
    finally:
        gc.callbacks.remove(give_way)
        gc.set_threshold(*before)
