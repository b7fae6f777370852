# SPDX-License-Identifier: Apache-2.0
"""Formulas as MathML, which browsers typeset by themselves, from the same trees as those on paper.

The pages in docs/theory have each formula as plain text, readable anywhere.  MkDocs calls `on_page_content` when it
builds the site (`hooks` in mkdocs.yml): there the same formulas stand typeset."""

import re
import sys
from functools import cache
from html import escape
from pathlib import Path
from typing import Any

sys.path[:0] = [str(Path(__file__).parents[1]), str(Path(__file__).parent)]

from generate import loaded, written  # noqa: E402

from calc.sheet.expression import RANK, Expr, expression, rank_of_number  # noqa: E402
from reports.typesetting.typeset import UPRIGHT_LETTERS, symbol_parts  # noqa: E402


def on_page_content(html: str, page: Any, **_: object) -> str:
    """A page of the site; in those of the equations each formula is typeset.  What stands for an algorithm is words."""
    if not page.file.src_uri.startswith("theory/"):
        return html
    known = typeset()
    return re.sub(
        r"(<li>\s*(?:<p>)?)<code>(.*?)</code>", lambda m: m[1] + known.get(m[2], f"<code>{m[2]}</code>"), html
    )


@cache
def typeset() -> dict[str, str]:
    """Every formula that has an expression, by its plain text as a page has it."""
    equations = [(one, tree) for one in loaded() if (tree := expression(one)) is not None]
    return {escape(written(one), quote=False): formula(one.symbol, tree, written(one)) for one, tree in equations}


def formula(name: str, of: Expr, words: str) -> str:
    """Symbol = formula; `words`: the same as plain text."""
    return f'<math alttext="{escape(words)}"><mrow>{symbol(name)}{sign("=")}{tree(of)}</mrow></math>'


# --- symbols


def sign(text: str) -> str:
    return f"<mo>{escape(text)}</mo>"


def symbol(name: str) -> str:
    """A symbol with its indices."""
    if len(name) > 2 and name[0] == name[-1] == "|":
        return brackets(symbol(name[1:-1]), "|", "|")
    parts = []
    for letters, below, above in symbol_parts(name):
        upright = not letters.isalpha() or all(c in UPRIGHT_LETTERS for c in letters)
        style = ' mathvariant="normal"' if upright else ""
        base = f"<mi{style}>{escape(letters)}</mi>"
        parts.append(scripts(base, *(f"<mtext>{escape(index)}</mtext>" if index else "" for index in (below, above))))
    return row("".join(parts))


def scripts(base: str, below: str, above: str) -> str:
    if below and above:
        return f"<msubsup>{base}{below}{above}</msubsup>"
    if below:
        return f"<msub>{base}{below}</msub>"
    return f"<msup>{base}{above}</msup>" if above else base


# --- trees


def row(inside: str) -> str:
    return f"<mrow>{inside}</mrow>"


def tree(of: Expr, outer: float = 0.0) -> str:
    """A tree, in brackets where what stands around it (`outer`) binds more strongly."""
    rank, markup = _ranked(of, outer)
    return brackets(markup) if rank < outer else row(markup)


def brackets(inside: str, left: str = "(", right: str = ")") -> str:
    return row(f"{sign(left)}{inside}{sign(right)}")


def _ranked(of: Expr, outer: float) -> tuple[float, str]:
    """What binds a tree, and the tree."""
    a = of.args
    match of.head:
        case "number":
            return rank_of_number(of.name, outer), f"<mn>{escape(of.name)}</mn>"
        case "symbol":
            return 5.0, symbol(of.name)
        case "add":
            return 1.0, tree(a[0], 1) + sign("+") + tree(a[1], 1)
        case "sub":
            return 1.0, tree(a[0], 1) + sign("−") + tree(a[1], 1.5)
        case "mul":
            return 2.0, tree(a[0], 2) + sign("·") + tree(a[1], 2.2)
        case "neg":
            return RANK["neg"], sign("−") + tree(a[0], RANK["neg"])
        case "div":
            return 4.4, _fraction(a[0], a[1])
        case "pow":
            return 4.0, scripts(tree(a[0], 4.5), "", tree(a[1]))
        case "sqrt":
            return 4.5, f"<msqrt>{tree(a[0])}</msqrt>"
        case "cis":
            return 4.0, scripts("<mi>e</mi>", "", row("<mi>i</mi>" + sign("·") + tree(a[0], 2.2)))
        case "sum":
            return 4.5, sign("Σ") + brackets(tree(a[0]))
        case "abs":
            return 5.0, brackets(tree(a[0]), "|", "|")
    return _call(of)


def _fraction(over: Expr, under: Expr) -> str:
    while over.head == "div":  # a/b/c as one fraction
        over, under = over.args[0], Expr("mul", (over.args[1], under))
    return f"<mfrac>{tree(over)}{tree(under)}</mfrac>"


def _call(of: Expr) -> tuple[float, str]:
    a = of.args
    if of.name == "exp" and len(a) == 1:
        return 4.0, scripts("<mi>e</mi>", "", tree(a[0]))
    if of.name == "conj":
        return 5.0, f"<mover>{tree(a[0])}{sign('¯')}</mover>"
    if of.name == "rss" and len(a) == 1:
        return 4.5, f"<msqrt>{tree(Expr('sum', (Expr('pow', (a[0], Expr('number', name='2'))),)))}</msqrt>"
    return 5.0, f"<mi>{escape(of.name)}</mi>" + brackets(sign(";").join(map(tree, a)))
