"""The dimensions of a formula, from its own return expression and the units of its annotations."""

import ast
import inspect
import textwrap
from functools import cache
from typing import Any

import pint

from calc.sheet.formula import Formula, units

UREG = pint.UnitRegistry()
UREG.define("euro = [money]")
SPELL = {
    "·": "*",
    "²": "**2",
    "³": "**3",
    "⁴": "**4",
    "µ": "u",
    "°C": "kelvin",
    "°": "degree",
    "10⁻⁶/K": "1e-6/kelvin",
    "€": "euro",
}
SAME = {"modulus", "abs", "conj", "total", "along", "resultant", "joined", "real", "imag", "largest", "smallest", "rss"}
PURE = {
    "sin",
    "cos",
    "tan",
    "exp",
    "ln",
    "log10",
    "asin",
    "acos",
    "atan",
    "asinh",
    "floor",
    "inv",
    "cis",
    "erf",
    "log1p",
    "arctan2",
}


class Mismatch(AssertionError):
    pass


@cache
def dimension(unit: str) -> Any:
    for symbol, spelled in SPELL.items():
        unit = unit.replace(symbol, spelled)
    return (
        UREG.parse_units(unit).dimensionality if unit and unit != "1e-6/kelvin" else UREG.dimensionless.dimensionality
    )


def check(formula: Formula[..., Any]) -> None:
    """Raises Mismatch where the return expression does not have the dimension of its annotation."""
    tree = ast.parse(textwrap.dedent(inspect.getsource(formula.function))).body[0]
    known = units(formula)
    constants = formula.function.__globals__.get("__annotations__", {})

    def of(node: ast.expr) -> Any:
        match node:
            case ast.Constant():
                return dimension("")
            case ast.Name(id=name):
                if name in known:
                    return dimension(known[name])
                return dimension(constants[name].__metadata__[0]) if name in constants else dimension("")
            case ast.UnaryOp(operand=a):
                return of(a)
            case ast.BinOp(left=a, op=ast.Add() | ast.Sub(), right=b):
                if of(a) != of(b):
                    raise Mismatch(f"{ast.unparse(node)}: {of(a)} with {of(b)}")
                return of(a)
            case ast.BinOp(left=a, op=ast.Mult(), right=b):
                return of(a) * of(b)
            case ast.BinOp(left=a, op=ast.Div(), right=b):
                return of(a) / of(b)
            case ast.BinOp(left=a, op=ast.Pow(), right=b) | ast.Call(func=ast.Name(id="power"), args=[a, b]):
                base = of(a)
                if base == dimension(""):
                    return base
                return base ** eval(compile(ast.Expression(b), "", "eval"), {})
            case ast.Call(func=ast.Name(id="argument")):
                return dimension("")
            case ast.Call(func=ast.Name(id="sqrt"), args=[a]):
                return of(a) ** 0.5
            case ast.Call(func=ast.Name(id=name), args=args) if name in SAME:
                found = [of(a) for a in args]
                if any(f != found[0] for f in found):
                    raise Mismatch(f"{ast.unparse(node)}: {found}")
                return found[0]
            case ast.Call(func=ast.Name(id=name), args=args) if name in PURE:
                if any(of(a) != dimension("") for a in args):
                    raise Mismatch(f"{ast.unparse(node)}: {name} of {[of(a) for a in args]}")
                return dimension("")
        raise Mismatch(f"not understood: {ast.unparse(node)}")

    last = tree.body[-1]  # type: ignore[attr-defined]
    if not isinstance(last, ast.Return) or last.value is None:
        raise Mismatch("no return expression")
    if not close(of(last.value), dimension(known["return"])):
        raise Mismatch(f"{ast.unparse(last.value)} is {of(last.value)}, said {known['return']!r}")


def close(a: Any, b: Any) -> bool:
    """Equal up to the rounding of fractional powers."""
    return all(abs(a.get(k, 0) - b.get(k, 0)) < 1e-9 for k in {*a, *b})
