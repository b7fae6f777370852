# SPDX-License-Identifier: Apache-2.0
"""Formulas as Office Math (ISO/IEC 29500-1, clause 22.1), from the same trees as those on paper: a word processor shows
and edits them."""

from xml.sax.saxutils import escape

from calc.sheet.expression import RANK, Expr, Shown, rank_of_number

from ..typesetting.typeset import UPRIGHT_LETTERS, symbol_parts

NAMESPACE = "http://schemas.openxmlformats.org/officeDocument/2006/math"


def paragraph(part: str) -> str:
    """A formula as a paragraph of its own, to the left."""
    left = '<m:oMathParaPr><m:jc m:val="left"/></m:oMathParaPr>'
    return f'<m:oMathPara xmlns:m="{NAMESPACE}">{left}<m:oMath>{part}</m:oMath></m:oMathPara>'


def inline(part: str) -> str:
    """A formula within a line of text."""
    return f'<m:oMath xmlns:m="{NAMESPACE}">{part}</m:oMath>'


def formula(name: str, of: Expr) -> str:
    """Symbol = formula."""
    return symbol(name) + run("=") + tree(of)


def numbers(line: Shown) -> str:
    """= numbers = value unit."""
    value = run("=") + words(f" {line.result}" + (f"   {line.where}" if line.where else ""))
    return value if line.numbers is None else run("=") + tree(line.numbers) + value


# --- runs and symbols


def run(text: str, *, upright: bool = True) -> str:
    style = '<m:rPr><m:sty m:val="p"/></m:rPr>' if upright else ""
    return f'<m:r>{style}<m:t xml:space="preserve">{escape(text)}</m:t></m:r>'


def words(text: str) -> str:
    """Text that is no mathematics."""
    return f'<m:r><m:rPr><m:nor/></m:rPr><m:t xml:space="preserve">{escape(text)}</m:t></m:r>'


def symbol(name: str) -> str:
    """A symbol with its indices."""
    if len(name) > 2 and name[0] == name[-1] == "|":
        return brackets(symbol(name[1:-1]), "|", "|")
    markup = ""
    for letters, below, above in symbol_parts(name):
        base = run(letters, upright=not letters.isalpha() or all(c in UPRIGHT_LETTERS for c in letters))
        # no operators, if they are signs
        markup += scripts(base, words(below) if below else "", words(above) if above else "")
    return markup


def scripts(base: str, below: str, above: str) -> str:
    if below and above:
        return f"<m:sSubSup><m:e>{base}</m:e><m:sub>{below}</m:sub><m:sup>{above}</m:sup></m:sSubSup>"
    if below:
        return f"<m:sSub><m:e>{base}</m:e><m:sub>{below}</m:sub></m:sSub>"
    return f"<m:sSup><m:e>{base}</m:e><m:sup>{above}</m:sup></m:sSup>" if above else base


# --- trees


def tree(of: Expr, outer: float = 0.0) -> str:
    """A tree, in brackets where what stands around it (`outer`) binds more strongly."""
    rank, markup = _ranked(of, outer)
    return brackets(markup) if rank < outer else markup


def brackets(inside: str, left: str = "(", right: str = ")") -> str:
    return f'<m:d><m:dPr><m:begChr m:val="{left}"/><m:endChr m:val="{right}"/></m:dPr><m:e>{inside}</m:e></m:d>'


def _ranked(of: Expr, outer: float) -> tuple[float, str]:
    """What binds a tree, and the tree."""
    a = of.args
    match of.head:
        case "number":
            return rank_of_number(of.name, outer), run(of.name)
        case "symbol":
            return 5.0, symbol(of.name)
        case "add":
            return 1.0, tree(a[0], 1) + run("+") + tree(a[1], 1)
        case "sub":
            return 1.0, tree(a[0], 1) + run("−") + tree(a[1], 1.5)
        case "mul":
            return 2.0, tree(a[0], 2) + run("·") + tree(a[1], 2.2)
        case "neg":
            return RANK["neg"], run("−") + tree(a[0], RANK["neg"])
        case "div":
            return 4.4, _fraction(a[0], a[1])
        case "pow":
            return 4.0, scripts(tree(a[0], 4.5), "", tree(a[1]))
        case "sqrt":
            return 4.5, _root(tree(a[0]))
        case "cis":
            return 4.0, scripts(run("e"), "", run("i·") + tree(a[0], 2.2))
        case "sum":
            return 4.5, run("Σ") + brackets(tree(a[0]))
        case "abs":
            return 5.0, brackets(tree(a[0]), "|", "|")
    return _call(of)


def _fraction(over: Expr, under: Expr) -> str:
    while over.head == "div":  # a/b/c as one fraction
        over, under = over.args[0], Expr("mul", (over.args[1], under))
    return f"<m:f><m:num>{tree(over)}</m:num><m:den>{tree(under)}</m:den></m:f>"


def _root(inside: str) -> str:
    return f'<m:rad><m:radPr><m:degHide m:val="1"/></m:radPr><m:deg/><m:e>{inside}</m:e></m:rad>'


def _call(of: Expr) -> tuple[float, str]:
    a = of.args
    if of.name == "exp" and len(a) == 1:
        return 4.0, scripts(run("e", upright=False), "", tree(a[0]))
    if of.name == "conj":
        return 5.0, f'<m:bar><m:barPr><m:pos m:val="top"/></m:barPr><m:e>{tree(a[0])}</m:e></m:bar>'
    if of.name == "rss" and len(a) == 1:
        return 4.5, _root(tree(Expr("sum", (Expr("pow", (a[0], Expr("number", name="2"))),))))
    return 5.0, run(of.name) + brackets(run("; ").join(map(tree, a)))
