# SPDX-License-Identifier: Apache-2.0
"""Formulas as Office Math: well formed, with the signs of the formula on paper, brackets where they belong."""

import re
from xml.etree import ElementTree

import pytest

from calc.sheet.expression import Expr, expression, text
from reports.docx import omml
from reports.typesetting.typeset import symbol_parts
from tests.calc.test_formulas import OURS

M = f"{{{omml.NAMESPACE}}}"
X, Y, TWO = Expr("symbol", name="x"), Expr("symbol", name="y"), Expr("number", name="2")
SUM = Expr("add", (X, Y))


def parsed(part: str) -> ElementTree.Element:
    return ElementTree.fromstring(omml.inline(part))


def letters(element: ElementTree.Element) -> str:
    return "".join(element.itertext())


def shape(part: str) -> str:
    """The tree in short: runs by their text, all else by its tag."""

    def said(element: ElementTree.Element) -> str:
        tag = element.tag.removeprefix(M)
        if tag == "r":
            return letters(element)
        inside = "".join(said(child) for child in element if not child.tag.endswith("Pr"))
        return inside if tag == "e" else f"{tag}[{inside}]"

    return "".join(map(said, parsed(part)))


@pytest.mark.parametrize(
    ("tree", "expected"),
    [
        (Expr("div", (SUM, Y)), "f[num[x+y]den[y]]"),
        (Expr("div", (Expr("div", (X, Y)), TWO)), "f[num[x]den[y·2]]"),
        (Expr("mul", (SUM, Y)), "d[x+y]·y"),
        (Expr("sub", (X, SUM)), "x−d[x+y]"),
        (Expr("pow", (SUM, TWO)), "sSup[d[x+y]sup[2]]"),
        (Expr("pow", (Expr("div", (X, Y)), TWO)), "sSup[d[f[num[x]den[y]]]sup[2]]"),
        (Expr("sqrt", (SUM,)), "rad[deg[]x+y]"),
        (Expr("call", (X, Y), "max"), "maxd[x; y]"),
        (Expr("call", (X,), "conj"), "bar[x]"),
        (Expr("call", (X,), "exp"), "sSup[esup[x]]"),
        (Expr("cis", (SUM,)), "sSup[esup[i·d[x+y]]]"),
        (Expr("mul", (X, Expr("number", name="−3"))), "x·d[−3]"),
        (Expr("symbol", name="C_1⁻,res"), "sSubSup[Csub[1,res]sup[−]]"),
        (Expr("symbol", name="|C|"), "d[C]"),
    ],
)
def test_trees(tree: Expr, expected: str) -> None:
    assert shape(omml.tree(tree)) == expected


def test_letters_that_xml_reserves() -> None:
    assert letters(parsed(omml.run("a < b & c"))) == "a < b & c"


def test_pieces_of_symbols() -> None:
    assert symbol_parts("T_1T_2") == [("T", "1", ""), ("T", "2", "")]
    assert symbol_parts("y_∞") == [("y", "∞", "")]
    assert symbol_parts("Δφ") == [("Δφ", "", "")] and symbol_parts("U·Δz") == [
        ("U", "", ""),
        ("·", "", ""),
        ("Δz", "", ""),
    ]


def test_every_formula_is_well_formed_and_keeps_its_letters() -> None:
    def signs(said: str) -> list[str]:
        return sorted(re.findall(r"\w", said))

    for f in OURS:
        if (tree := expression(f)) is None:
            continue
        made = parsed(omml.formula(f.symbol, tree))
        if not any(name in text(tree) for name in ("exp(", "conj(", "rss(")):  # which are drawn and not written
            written = text(tree).translate(str.maketrans("₀₁₂₃₄₅₆₇₈₉⁰¹²³⁴⁵⁶⁷⁸⁹", "0123456789" * 2))
            own = letters(parsed(omml.tree(tree))).translate(str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹", "0123456789"))
            assert signs(own) == signs(written.replace("_", "")), f.__name__
        assert not [e for e in made.iter() if e.tag in (f"{M}e", f"{M}num", f"{M}den") and not letters(e)], f.__name__
