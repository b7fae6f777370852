# SPDX-License-Identifier: Apache-2.0
"""Formulas as boxes: their widths, brackets, breaks; every formula of the program."""

import ast

import pytest

import calc.solve  # noqa: F401  (registers every formula)
from calc.sheet.expression import Expr, _build, expression, substituted
from calc.sheet.formula import FORMULAS, formula
from reports.typesetting.boxes import Box
from reports.typesetting.typeset import formula as pieces
from reports.typesetting.typeset import lines, symbol

SIZE = 8.0


@formula("x", "a formula for the tests")
def _any(a: float, b: float, c: float, d: float) -> float:
    return a


def tree(source: str) -> Expr:
    return _build(ast.parse(source, mode="eval").body, _any)


def box(source: str | Expr, size: float = SIZE, width: float = 1e6) -> Box:
    (line,) = lines(pieces(tree(source) if isinstance(source, str) else source, size, width), width)
    return line


def written(made: Box) -> str:
    return "".join(m[3] for m in made.marks if m[0] == "text")


def test_more_takes_more_room() -> None:
    order = ["a", "a + b", "a + b + c", "a + b + c + d"]
    widths = [box(s).width for s in order]
    assert widths == sorted(widths) and len(set(widths)) == len(widths)
    assert box("a / b", 16).width == pytest.approx(2 * box("a / b", 8).width)
    assert box("a / b").height > 1.5 * box("a").height
    assert box("a / (b / c)").height > box("a / b").height
    assert box("sqrt(a)").width > box("a").width


def test_a_fraction_is_as_wide_as_its_wider_half() -> None:
    wide = max(box("a + b + c").width, box("d").width)
    assert wide < box("(a + b + c) / d").width < wide + 4
    rules = [m for m in box("a / b").marks if m[0] == "rule"]
    assert len(rules) == 1


@pytest.mark.parametrize(
    "source, shown",
    [
        ("(a + b) * c", "(a+b)·c"),
        ("a * (b + c)", "a·(b+c)"),
        ("a - (b - c)", "a−(b−c)"),
        ("a - b + c", "a−b+c"),
        ("(a + b)**2", "(a+b)²"),
        ("-a**2", "−a²"),
        ("(-a)**2", "(−a)²"),
        ("a**-2", "a⁻²"),
        ("a * b / (c * d)", "a·bc·d"),
        ("sqrt(a + b)", "√a+b"),
        ("total(a * b)", "Σ(a·b)"),
        ("modulus(a)", "|a|"),
        ("cis(a)", "ei·a"),
        ("exp(a)", "ea"),
        ("largest(a, b)", "max(a; b)"),
        ("a * b**0.25", "a·b0.25"),
        ("conj(a)", "a"),
        ("log10(a)", "lg(a)"),
        ("(a / b)**2", "(ab)2"),
    ],
)
def test_brackets_stand_where_they_must(source: str, shown: str) -> None:
    assert written(box(source)) == shown


def test_brackets_grow_with_what_they_hold() -> None:
    tall = [m for m in box("(a / b) ** 2").marks if m[0] == "text" and m[3] in "()"]
    assert all(m[7] > 1.2 for m in tall)
    assert all(m[7] == 1.0 for m in box("(a + b) * c").marks if m[0] == "text")


def test_numbers_in_place_of_symbols_get_their_brackets() -> None:
    numbers = {"a": "−0.5", "b": "6.2·10⁻³", "c": "573∠30°", "d": "(1; 2; 3)"}

    def put(source: str) -> str:
        return written(box(substituted(tree(source), numbers)))

    assert put("a * b") == "(−0.5)·(6.2·10⁻³)" or put("a * b") == "−0.5·(6.2·10⁻³)"
    assert put("b**2") == "(6.2·10⁻³)²"
    assert put("a**2") == "(−0.5)²"
    assert put("d + a") == "(1; 2; 3)+(−0.5)"


@pytest.mark.parametrize(
    "name, text",
    [
        ("C_1⁻,res", "C−1,res"),
        ("F_n⁺", "F+n"),
        ("φ_0", "φ0"),
        ("|C_S|", "|CS|"),
        ("a/(ω²·r)", "a/(ω²·r)"),
        ("α_wt", "αwt"),
        ("F⁺", "F+"),
    ],
)
def test_symbols(name: str, text: str) -> None:
    made = symbol(name, SIZE)
    assert written(made) == text
    assert made.width > 0


def test_long_formulas_break_at_their_outer_operators() -> None:
    long = tree(" + ".join(f"sqrt(a*b + c) * d**{n}" for n in range(2, 9)))
    whole = box(long)
    for width in (240.0, 150.0, 90.0):
        made = lines(pieces(long, SIZE, width), width)
        assert len(made) > 1 and all(line.width <= width + 1e-6 for line in made)
        assert all(written(line).startswith(("+",) if width > 100 else ("+", "·")) for line in made[1:])
        assert "".join(written(line) for line in made) == written(whole)


def test_what_can_not_break_is_written_out_or_made_smaller() -> None:
    wide = tree("(" + " + ".join("a * b" for _ in range(30)) + ") / c")
    made = lines(pieces(wide, SIZE, 120.0), 120.0)
    assert len(made) > 3 and all(line.width <= 120.0 + 1e-6 for line in made)
    assert "/" in "".join(map(written, made))
    (line,) = lines(pieces(Expr("number", name="8" * 200), SIZE, 100.0), 100.0)
    assert line.width <= 100.0 + 1e-6


@pytest.mark.parametrize("width", [320.0, 90.0])
def test_every_formula_of_the_program_can_be_set(width: float) -> None:
    count = 0
    for name, made in FORMULAS.items():
        assert symbol(made.symbol, SIZE).width > 0
        found = expression(made)
        if found is None:
            assert made.shows, name
            continue
        numbers = {n: "−1.234·10⁻³" for n in _names(found)}
        for shown in (found, substituted(found, numbers)):
            for line in lines(pieces(shown, SIZE, width), width):
                assert 0 < line.width <= width + 1e-6, name
        count += 1
    assert count > 50


def _names(found: Expr) -> set[str]:
    return {found.name} if found.head == "symbol" else set().union(*map(_names, found.args))


def test_brackets_are_made_a_little_smaller_rather_than_torn() -> None:
    def torn(source: str, tight: float = 1.1) -> int:
        whole = box(source).width
        return len(lines(pieces(tree(source), SIZE, whole), whole / tight))

    assert torn("max(a / b, c + d + a + b)") == torn("max(a, b + c + d + a + b)") == 1
    assert torn("a / b + max(c, d)") == 2, "outside of them there is a sign to break at"
    assert torn("max(a, b + c + d + a + b)", 1.5) == 2, "too wide even when smaller"


def depths(made: list[Box]) -> list[int]:
    """How many brackets are open at each line's end but the last."""
    read = [written(line) for line in made]
    return [
        sum(map("".join(read[: n + 1]).count, "([")) - sum(map("".join(read[: n + 1]).count, ")]"))
        for n in range(len(read) - 1)
    ]


@pytest.mark.parametrize("share", [0.95, 0.8, 0.65, 0.5])
@pytest.mark.parametrize(
    "source",
    [
        "a + b*(a + b + c + d) - c*(d - a - b)",
        "a*b*c*(a + b) + d",
        "a * (b + c) * (c + d) * (d + a) * (a + b + c)",
        "a - b - max(c, d, a) - (a + b)*(c + d)",
    ],
)
def test_no_line_ends_inside_brackets_where_it_can_end_outside(source: str, share: float) -> None:
    """All brackets of these fit on a line."""
    width = share * box(source).width
    made = lines(pieces(tree(source), SIZE, width), width)
    assert len(made) > 1 and depths(made) == [0] * (len(made) - 1)
    assert all(m[5] == SIZE for line in made for m in line.marks if m[3] in "abcd"), "and none is made smaller"


def test_inside_brackets_lines_end_where_the_fewest_are_open() -> None:
    inner = " + ".join(["a*(b + c)"] * 8)
    source = f"max(d, {inner})"
    width = 0.3 * box(source).width
    made = lines(pieces(tree(source), SIZE, width), width)
    assert len(made) > 2 and set(depths(made)) == {1}


def test_a_letter_after_an_index_may_have_its_own() -> None:
    (t1, i1, t2, i2) = symbol("T_1T_2", SIZE).marks
    assert [m[3] for m in (t1, i1, t2, i2)] == ["T", "1", "T", "2"]
    assert t1[5] == t2[5] > i1[5] == i2[5] and i1[2] == i2[2] < t1[2] == t2[2]
    assert [m[3] for m in symbol("P_H1max", SIZE).marks] == ["P", "H1max"]
