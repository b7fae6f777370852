# SPDX-License-Identifier: Apache-2.0
"""A recorded line made readable, from the formula's own `return` expression.

In order: the digits of a substitution, the expression as a tree, one recorded line, its text for the terminal.

`expression(formula)` turns the function's syntax tree into a small neutral tree of `Expr`; `text()` writes such a tree
for a terminal, the report typesets the same tree.  Loaded only when something is shown."""

import ast
import math
import re
from collections.abc import Callable, Mapping, Sequence
from functools import cache

from .formula import definition, units
from .number import DIGITS, LISTED, SUBSCRIPTS, SUPERSCRIPTS, all_rounded, rounded, scalar, several, short
from .record import record, replace
from .text import COMMA, EMPTY, Name, Text, with_unit
from .units import UNITS
from .value import Equation, Line, link_of

# --- with how many digits the numbers of a substitution are written, so that working it out again gives the value
# A value has four digits.  Its arguments have four as well, and more where they are needed: where a difference takes
# the first ones away, where a power multiplies a rounding, where the value lies near the middle between two numbers of
# four digits.  In a proof a value has as many as the lines that take it need of it (`digits_taken`).

MOST = 12  # digits of an argument
FEW = 4  # numbers from which an algorithm makes one, as a table is read at a point: they are written with it
NOUGHT = 5e-4  # in the shown unit: what is found again in place of 0


def digits_that_close(
    formula: Equation, arguments: Mapping[str, object], value: object, factor: float, wanted: int = DIGITS
) -> dict[str, int]:
    """Digits by argument.  `value`: what the arguments gave, in SI; `factor`: its shown unit in SI; `wanted`: the
    digits of the value.

    Four for all where that is enough; else the least number with which all of them give the value, then as few as each
    one needs."""
    given = {name: x for name, x in arguments.items() if _is_written(x)}
    digits = dict.fromkeys(arguments, DIGITS)
    if not isinstance(value, (float, complex)) or not math.isfinite(abs(value)):
        return digits
    target = value / factor

    def close() -> bool:
        try:
            rounded_ones = {name: all_rounded(x, digits[name]) for name, x in given.items()}
            again = formula.function(**{**arguments, **rounded_ones})
            return isinstance(again, (int, float, complex)) and bool(_same(again / factor, target, wanted))
        except (ValueError, ArithmeticError, LookupError, TypeError):  # rounded, they may lie outside of a table
            return False

    for many in range(DIGITS, MOST + 1):
        digits = dict.fromkeys(arguments, many)
        if close():
            break
    else:
        # an algorithm of its own, or a list too long to be written: no digits help
        return dict.fromkeys(arguments, DIGITS)
    for name in given:
        for fewer in range(DIGITS, digits[name]):
            kept, digits[name] = digits[name], fewer
            if close():
                break
            digits[name] = kept
    return digits


def _is_written(x: object) -> bool:
    """A number, or a list that is short enough to be written whole."""
    if isinstance(x, (tuple, list)):
        return len(x) <= LISTED
    if hasattr(x, "size"):
        return bool(x.size <= LISTED)
    return isinstance(x, (int, float, complex)) and not isinstance(x, bool)


def _same(again: complex, value: float | complex, digits: int) -> bool:
    """Whether a number that is worked out again lies within half a unit of the last digit with which the value is
    written."""
    if isinstance(value, complex):
        ours, theirs = (math.atan2(z.imag, z.real) for z in (again, value))
        turned = math.degrees(ours - theirs) if value and again else 0.0
        angle = math.degrees(theirs)
        return _near(abs(again), abs(value), digits) and _near(angle + math.remainder(turned, 360), angle, digits)
    return _near(again, value, digits)


def _near(again: complex, value: float, digits: int) -> bool:
    shown = rounded(float(value), digits)
    if not shown:
        return abs(again) < NOUGHT
    unit = 10.0 ** (math.floor(math.log10(abs(shown))) - digits + 1)  # of the last of its digits
    return bool(abs(again - shown) <= 0.5 * unit * (1 + 1e-9))


# --- the expression as a tree

GREEK = dict(
    alpha="α", beta="β", gamma="γ", delta="δ", epsilon="ε", eps="ε", zeta="ζ", eta="η", theta="θ", kappa="κ", lam="λ",
    mu="μ", nu="ν",
    xi="ξ", pi="π", rho="ρ", sigma="σ", tau="τ", phi="φ", chi="χ", psi="ψ", omega="ω", Delta="Δ", Lambda="Λ", Phi="Φ",
    Psi="Ψ", Omega="Ω",
    Sigma="Σ", Gamma="Γ",
) | {"lambda": "λ"}  # fmt: skip
NO_ANGLE = 1e-12  # rad: what a sine of π has left
WRITTEN = 10  # digits of a number that stands in a formula itself: as it is written there
ENOUGH = 5  # digits of a constant that has no end: 30° in radians
BINARY = {ast.Add: "add", ast.Sub: "sub", ast.Mult: "mul", ast.Div: "div", ast.Pow: "pow"}
CALLS = {"sqrt": "sqrt", "cis": "cis", "modulus": "abs", "abs": "abs", "real": "Re", "imag": "Im", "argument": "arg"}
CALLS |= {"total": "sum", "along": "sum", "resultant": "sum", "largest": "max", "smallest": "min"}
CALLS |= {"asin": "arcsin", "acos": "arccos", "atan": "arctan", "log10": "lg", "asinh": "arsinh", "log1p": "ln1p"}


@record
class Expr:
    """A node: `head` is number, symbol (both with their text in `name`), add, sub, mul, div, pow, neg, sqrt, sum, cis,
    abs or call."""

    head: str
    args: tuple["Expr", ...] = ()
    name: str = ""


@cache
def symbol(identifier: str) -> str:
    """`alpha_wt` → `α_wt`, `omega` → `ω`, `C_1` → `C_1`, `z1` → `z_1`, `Delta_T` → `ΔT`: base, underscore, index."""
    base, *index = identifier.strip("_").split("_")
    if base == "Delta" and index:  # a difference of what follows
        return f"Δ{symbol('_'.join(index))}"
    if base not in GREEK and (stem := base.rstrip("0123456789")) and stem != base and len(stem) <= 6:
        index.insert(0, base[len(stem) :])
        base = stem
    base = GREEK.get(base, base)
    return f"{base}_{','.join(GREEK.get(i, i) for i in index)}" if index else base


@cache
def expression(formula: Equation) -> Expr | None:
    """The tree of the return expression; None where the source text is not at hand or the formula stands for an
    algorithm."""
    if formula.shows:
        return None
    parsed = definition(formula.function)
    if parsed is None:
        return None
    last = parsed.body[-1]
    if not isinstance(last, ast.Return) or last.value is None:
        raise TypeError(f"{formula.__name__}: a formula is one return expression, or says `shows=`")
    return _without_ones(_build(last.value, formula))


def _without_ones(tree: Expr) -> Expr:
    """The tree without factors and divisors of 1, which only carry a unit."""
    args = tuple(_without_ones(a) for a in tree.args)
    ones = [a.head == "number" and a.name == "1" for a in args]
    if tree.head in ("mul", "div") and ones[1]:
        return args[0]
    if tree.head == "mul" and ones[0]:
        return args[1]
    return Expr(tree.head, args, tree.name)


def _build(node: ast.expr, formula: Equation) -> Expr:
    def sub(n: ast.expr) -> Expr:
        return _build(n, formula)

    match node:
        case ast.Constant(value=complex() as v):
            return Expr("symbol", name="i") if v == 1j else Expr("number", name=f"{v.imag:g}i")
        case ast.Constant(value=v):
            return Expr("number", name=short(v, WRITTEN) if isinstance(v, (int, float)) else str(v))
        case ast.Name(id=name):
            if name in formula.parameters:
                return Expr("symbol", name=formula.names.get(name, symbol(name)))
            constant = formula.function.__globals__.get(name)
            if isinstance(constant, (int, float)) and name != "pi":
                ends = len(f"{constant:.{WRITTEN}g}") < WRITTEN
                if not ends and abs((part := round(1 / constant)) * constant - 1) < 1e-12:
                    return Expr("div", (Expr("number", name="1"), Expr("number", name=short(part, WRITTEN))))
                return Expr("number", name=short(constant, WRITTEN if ends else ENOUGH))
            return Expr("symbol", name=symbol(name))
        case ast.BinOp(left=a, op=op, right=b):
            return Expr(BINARY[type(op)], (sub(a), sub(b)))
        case ast.UnaryOp(op=ast.USub(), operand=a):
            return Expr("neg", (sub(a),))
        case ast.Call(func=ast.Name(id="joined"), args=[a, ast.UnaryOp(op=ast.USub(), operand=b)]):
            return Expr("sub", (sub(a), sub(b)))
        case ast.Call(func=ast.Name(id="power"), args=[a, b]):
            return Expr("pow", (sub(a), sub(b)))
        case ast.Call(func=ast.Name(id="joined"), args=[a, b]):
            return Expr("add", (sub(a), sub(b)))
        case ast.Call(func=ast.Name(id=name), args=args):
            head = CALLS.get(name, name)
            known = head if head in ("sqrt", "sum", "cis", "abs") else "call"
            return Expr(known, tuple(sub(a) for a in args), head if known == "call" else "")
    raise TypeError(f"{formula.__name__}: not allowed in a formula: {ast.unparse(node)}")


def substituted(tree: Expr, numbers: Mapping[str, str]) -> Expr:
    """The same tree with the symbols replaced by the numbers that stood for them."""
    if tree.head == "symbol":
        return Expr("number", name=numbers[tree.name]) if tree.name in numbers else tree
    return Expr(tree.head, tuple(substituted(a, numbers) for a in tree.args), tree.name)


def renamed(tree: Expr, called: Mapping[str, str]) -> Expr:
    """The same tree with other symbols."""
    if tree.head == "symbol":
        name = called.get(tree.name, tree.name)
        return Expr("number" if name.isdecimal() else "symbol", name=name)
    return Expr(tree.head, tuple(renamed(a, called) for a in tree.args), tree.name)


# --- one recorded line, ready to be shown


@record
class Shown:
    """A line made readable: the two trees (None for an algorithm, whose words stand in `shows`), the value with its
    unit, the source."""

    symbol: str
    formula: Expr | None
    numbers: Expr | None
    shows: Text
    value: str
    unit: str
    source: Text
    about: Text
    where: Text = EMPTY  # which element of an array is shown
    degrees: str = ""  # an angle that another line takes, which is in radians
    given: str = ""  # what an algorithm takes, where that is a few numbers

    @property
    def how(self) -> Text:
        """An algorithm in words, with what it takes."""
        return Text("{how}, at {given}", how=self.shows, given=Name(self.given)) if self.given else self.shows

    @property
    def result(self) -> str:
        """The value with its unit."""
        value = with_unit(self.value, self.unit)
        return f"{value} ({self.degrees})" if self.degrees else value


GOVERNS = {"max": Text("largest of {size}, number {number}"), "min": Text("smallest of {size}, number {number}")}
NUMBERED = Text("number {number} of {size}")
ALIKE = 1e-9  # of the largest: elements that are no further apart govern alike, and the first of them is shown


def governing(line: Line) -> tuple[int, ...] | None:
    """The index of the element to show, None for a value that is no array."""
    import numpy as np

    if not isinstance(line.value, np.ndarray) or line.value.ndim == 0:
        return None
    size = np.abs(line.value)
    if not (finite := size[np.isfinite(size)]).size:
        return (0,) * size.ndim
    governs = {"max": np.nanmax, "min": np.nanmin}[line.formula.governs](size)
    alike = np.isclose(size, governs, rtol=0.0, atol=ALIKE * finite.max())
    return tuple(int(i) for i in np.unravel_index(int(alike.argmax()), size.shape))


def _element(x: object, index: tuple[int, ...] | None, shape: tuple[int, ...]) -> object:
    """Of an argument, the number that enters the element which is shown; the whole of what has no such element."""
    if index is not None and hasattr(x, "shape"):
        import numpy as np

        try:
            x = np.broadcast_to(np.asarray(x), shape)[index]
        except ValueError:
            return x
    return x.item() if hasattr(x, "item") and getattr(x, "shape", None) == () else x


def _argument(x: object, unit: str, digits: int = DIGITS) -> str:
    if isinstance(x, (str, bool)) or x is None:
        return str(x)
    if isinstance(x, (int, float, complex)):
        return scalar(x, digits) if unit != "rad" or isinstance(x, complex) or abs(x) > NO_ANGLE else "0"
    import numpy as np

    return several(x if isinstance(x, (list, tuple)) else np.asarray(x).ravel(), digits)


@cache
def _result_unit(formula: Equation) -> tuple[str, float]:
    inside = units(formula).get("return", "")
    if formula.unit:
        return formula.unit, UNITS[formula.unit].factor
    return ("°", math.pi / 180) if inside == "rad" else (inside, 1.0)


def result(line: Line, at: tuple[int, ...] | None = None, taken: int = 0) -> tuple[str, str]:
    """The value of a line with its unit; of an array that which governs, or the one at this place of it.  `taken`: the
    digits with which another line takes it, which is in SI, so an angle in radians."""
    return _result(line.formula, _element(line.value, _place(line, at), getattr(line.value, "shape", ())), taken)


def _place(line: Line, at: tuple[int, ...] | None) -> tuple[int, ...] | None:
    """The index of the element to show: the one asked for where the value has it, else the one that governs."""
    shape = getattr(line.value, "shape", ())
    return at if at and len(at) == len(shape) and all(i < n for i, n in zip(at, shape)) else governing(line)


def _result(formula: Equation, value: object, taken: int = 0) -> tuple[str, str]:
    unit, factor = _result_unit(formula) if not taken else _taken_unit(formula)
    assert isinstance(value, (int, float, complex)), formula.__name__
    return scalar(value / factor, max(taken, DIGITS)), unit


def _taken_unit(formula: Equation) -> tuple[str, float]:
    """The unit of a value that another line takes: angles as formulas have them."""
    unit, factor = _result_unit(formula)
    return ("rad", 1.0) if unit == "°" else (unit, factor)


def digits_taken(places: Mapping[Line, tuple[int, ...] | None]) -> dict[Line, int]:
    """With how many digits these lines take the values of others, so that each closes on what is printed.  `places`: of
    each line the element that is shown."""
    needed: dict[Line, int] = {}
    waiting = list(places)
    while waiting:
        line = waiting.pop()
        arguments, value = _at_element(line, _place(line, places[line]))
        if expression(line.formula) is None and not of_few_numbers(line):
            continue
        factor = _taken_unit(line.formula)[1] if line in needed else _result_unit(line.formula)[1]
        wanted = digits_that_close(line.formula, arguments, value, factor, needed.get(line, DIGITS))
        for name, digits in wanted.items():
            link = link_of(line.arguments[name])
            if isinstance(link, Line) and needed.get(link, 0) < digits:
                needed[link] = digits
                if link in places and link not in waiting:
                    waiting.append(link)
    return needed


def of_few_numbers(line: Line) -> bool:
    """Whether a few numbers are all that an algorithm takes."""
    given = line.arguments.values()
    return 0 < len(given) <= FEW and all(isinstance(x, (int, float)) and not isinstance(x, bool) for x in given)


def _at_element(line: Line, index: tuple[int, ...] | None) -> tuple[dict[str, object], object]:
    """The arguments of a line and its value; of arrays the element."""
    shape = getattr(line.value, "shape", ())
    return {name: _element(x, index, shape) for name, x in line.arguments.items()}, _element(line.value, index, shape)


def symbol_of(line: Line) -> str:
    """The symbol of what a line gives: of one order the number of the order in place of its n, `C_n⁺` → `C_1⁺`."""
    return _of_order(line.formula.symbol, _order(line))


def _of_order(symbol: str, order: str) -> str:
    return re.sub(r"_n(?![^\W_])", f"_{order}", symbol) if order else symbol


def _order(line: Line) -> str:
    """Of which order a line is; empty of one that is of none."""
    order = line.arguments.get("n")
    known = isinstance(order, (int, float)) and order >= 1 and not units(line.formula).get("n")
    return f"{order:g}" if known else ""


ANYWHERE = "_y"  # the index of what holds at any diameter, ISO 21771


def symbols_put_in(lines: Sequence[Line]) -> dict[str, str]:
    """The symbols of a formula that stand for a value with one of its own, each with that: in ψ = g/d the clearance at
    one temperature, g_T.  Of several lines only what all of them say.

    The formula's own symbol stays where it says more (d_b1 of two base circles that are both d_b, α_K of an angle α_y
    at any place y), where the value is called by another letter, and where two values would be called alike."""
    first, *others = (_put_in(line) for line in lines)
    return {own: said for own, said in first.items() if all(other.get(own) == said for other in others)}


def _put_in(line: Line) -> dict[str, str]:
    formula, known = line.formula, {}
    for name, x in line.arguments.items():
        own, link = formula.names.get(name, symbol(name)), link_of(x)
        said = symbol_of(link) if isinstance(link, Line) and _is(x, link.value) else own
        alike = own.partition("_")[0] == said.partition("_")[0]
        says_more = not own.startswith(said) and not said.endswith(ANYWHERE)
        known[own] = said if alike and says_more else own
    if order := _order(line):  # beside n, a speed
        known = {own: order if own == "n" else _of_order(said, order) for own, said in known.items()}
    every = [symbol_of(line), *known, *known.values()]
    return {own: said for own, said in known.items() if said != own and every.count(said) == 1}


def _is(x: object, value: object) -> bool:
    """Whether an argument is what a line gave, and not another number that was found from it: its opposite."""
    if isinstance(x, (float, complex)) and isinstance(value, (float, complex)):
        return abs(x - value) <= ALIKE * abs(value)
    return True


def show(
    line: Line, at: tuple[int, ...] | None = None, put_in: Mapping[str, str] | None = None, taken: int = 0
) -> Shown:
    """A line made readable; of arrays the element that governs, or the one at the place `at`.  `put_in`: the symbols of
    the values that stand in the formula; left out, those of this line.  `taken`: the digits with which another line
    takes its value."""
    formula = line.formula
    index = _place(line, at)
    shape = getattr(line.value, "shape", ())
    arguments, value = _at_element(line, index)
    tree = expression(formula)
    numbers, shows, given, texts = None, formula.shows, "", dict[str, str]()
    if tree is not None or of_few_numbers(line):
        factor = (_taken_unit if taken else _result_unit)(formula)[1]
        known, digits = units(formula), digits_that_close(formula, arguments, value, factor, max(taken, DIGITS))
        texts = {
            formula.names.get(name, symbol(name)): _argument(x, known.get(name, ""), digits[name])
            for name, x in arguments.items()
        }
    if tree is not None:
        numbers = substituted(tree, texts)
    elif shows and texts:
        given = "; ".join(f"{plain(own)} = {words}" for own, words in texts.items())
    if tree is None and not shows:
        listed = COMMA.join(Name(f"{symbol(k)} = {_argument(v, '')}") for k, v in arguments.items())
        shows = Text("{name}({given})", name=formula.__name__, given=listed)
    where = EMPTY
    if index is not None and (size := math.prod(shape)) > 1:
        template = NUMBERED if index == at else GOVERNS[formula.governs]
        where = Text(template.template, size=size, number=index[-1] + 1)
    if tree is not None and (called := symbols_put_in([line]) if put_in is None else put_in):
        tree = renamed(tree, called)
    written, unit = _result(formula, value, taken)
    degrees = "" if unit == _result_unit(formula)[0] else with_unit(*_result(formula, value))
    return Shown(
        symbol_of(line), tree, numbers, shows, written, unit, formula.source, line.about, where, degrees, given
    )


# --- for the terminal


def plain(name: str) -> str:
    """A symbol for a terminal: digits below the line, letters after an underscore."""
    base, _, index = name.partition("_")
    return base + (index.translate(SUBSCRIPTS) if index.isdigit() else f"_{index}" if index else "")


RANK = {"add": 1, "sub": 1, "mul": 2, "div": 2, "neg": 2.5, "pow": 4, "cis": 4, "sqrt": 4.5, "sum": 4.5}
# how a node is written, and the rank below which each of its parts is bracketed
SPELT: dict[str, tuple[str, *tuple[float, ...]]] = {
    "add": ("{} + {}", 1, 1),
    "sub": ("{} − {}", 1, 1.5),
    "mul": ("{}·{}", 2, 2.2),
    "div": ("{}/{}", 2, 2.5),
    "neg": ("−{}", 2.5),
    "cis": ("e^(i·{})", 2.2),
    "sum": ("Σ({})", 0),
    "abs": ("|{}|", 0),
}


def rank_of_number(name: str, outer: float) -> float:
    """How strongly a written number holds together: one with a sign, a power of ten or an angle needs brackets in a
    product."""
    if name.startswith("−") and outer > 0:
        return 0.0
    return 2.0 if name.startswith("−") or "·10" in name or "∠" in name else 5.0


def text(tree: Expr, outer: float = 0) -> str:
    """A tree as one line of text; semicolons part arguments, as a number may have a comma."""
    rank = RANK.get(tree.head, 5)
    a = tree.args
    match tree.head:
        case "number":
            rank, out = rank_of_number(tree.name, outer), tree.name
        case "symbol":
            out = plain(tree.name)
        case "pow":
            exponent = text(a[1])
            raised = exponent.translate(SUPERSCRIPTS) if exponent.lstrip("−").isdecimal() else f"^{text(a[1], 5)}"
            out = f"{text(a[0], 4.5)}{raised}"
        case "sqrt":
            out = f"√{text(a[0], 5)}" if a[0].head in ("symbol", "number") else f"√({text(a[0])})"
        case head if head in SPELT:
            form, *ranks = SPELT[head]
            out = form.format(*map(text, a, ranks))
        case _:
            out = f"{tree.name}({'; '.join(text(x) for x in a)})"
    return f"({out})" if rank < outer else out


def respelled(tree: Expr, number: Callable[[str], str]) -> Expr:
    """The same tree with its numbers as `number` writes them, which are written in English."""
    name = number(tree.name) if tree.head == "number" else tree.name
    return Expr(tree.head, tuple(respelled(a, number) for a in tree.args), name)


def line_text(line: Line, say: Callable[[str], str] = str, number: Callable[[str], str] = str) -> tuple[str, str, str]:
    """A line for a terminal: the formula, the substitution with its value, the source; `say` and `number` put its words
    and its numbers into a language."""
    shown = show(line)
    result = with_unit(number(shown.value), shown.unit) + (f"   ({say(shown.where)})" if shown.where else "")
    head = plain(shown.symbol)
    if shown.formula is None or shown.numbers is None:
        return f"{head}: {say(replace(shown, given=number(shown.given)).how)}", f"= {result}", say(shown.source)
    substitution = f"= {number(text(shown.numbers))} = {result}"
    return f"{head} = {number(text(shown.formula))}", substitution, say(shown.source)


def line_json(line: Line) -> dict[str, str]:
    """A line as JSON: what the terminal shows, in named parts."""
    shown = show(line)
    return {
        "symbol": shown.symbol,
        "formula": text(shown.formula) if shown.formula else shown.how,
        "substituted": text(shown.numbers) if shown.numbers else "",
        "value": shown.value,
        "unit": shown.unit,
        "source": shown.source,
        "about": shown.about,
    }
