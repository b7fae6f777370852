# SPDX-License-Identifier: Apache-2.0
"""The equations of the site as MathML: each is well formed, says what its plain text says, and has its own layout."""

import importlib.util
import re
from html import unescape
from types import SimpleNamespace
from unicodedata import normalize
from xml.etree import ElementTree

import pytest

from calc.sheet.expression import Expr
from tests.conftest import ROOT


@pytest.fixture(scope="module")
def mathml():
    spec = importlib.util.spec_from_file_location("mathml", ROOT / "docs" / "mathml.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_every_formula_is_there_with_all_of_its_letters(mathml):
    known = mathml.typeset()
    assert len(known) > 1000
    for words, markup in known.items():
        shown, plain = (normalize("NFKC", t) for t in ("".join(ElementTree.fromstring(markup).itertext()), words))
        letters = set(re.findall(r"[^\W_]", unescape(plain)))
        assert letters - set("exp conj rss") <= set(shown), words  # these are a power, a bar and a root


@pytest.mark.parametrize(
    "head, args, markup",
    [
        ("div", "ab", "<mfrac><mrow>A</mrow><mrow>B</mrow></mfrac>"),
        ("sqrt", "a", "<msqrt><mrow>A</mrow></msqrt>"),
        ("pow", "ab", "<msup><mrow>A</mrow><mrow>B</mrow></msup>"),
        ("sub", "ab", "<mrow>A</mrow><mo>−</mo><mrow>B</mrow>"),
    ],
)
def test_a_tree_is_set_as_on_paper(mathml, head, args, markup):
    of = Expr(head, tuple(Expr("symbol", name=letter) for letter in args))
    wanted = markup.replace("A", mathml.symbol("a")).replace("B", mathml.symbol("b"))
    assert mathml.tree(of) == f"<mrow>{wanted}</mrow>"


def test_what_binds_less_stands_in_brackets(mathml):
    a, b, c = (Expr("symbol", name=letter) for letter in "abc")
    times = "".join(ElementTree.fromstring(mathml.tree(Expr("mul", (Expr("add", (a, b)), c)))).itertext())
    assert times == "(a+b)·c"


def test_only_the_pages_of_the_equations_are_typeset(mathml):
    words, markup = next(iter(mathml.typeset().items()))
    item = f"<li><code>{words}</code> (m)</li><li><code>no such formula</code></li>"
    theory, other = (SimpleNamespace(file=SimpleNamespace(src_uri=uri)) for uri in ("theory/gears.md", "own.md"))
    assert mathml.on_page_content(item, page=theory) == item.replace(f"<code>{words}</code>", markup)
    assert mathml.on_page_content(item, page=other) == item
