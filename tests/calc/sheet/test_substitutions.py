# SPDX-License-Identifier: Apache-2.0
"""Substitutions worked out again from what is printed, by a reader of its own: each gives the value beside it.

300 are drawn at random over all shipped designs at each run; all of them under the slow marker.
"""

import cmath
import math
import random
import re
from functools import cache

import numpy as np
import pytest

from calc.design.toml_file import design, read
from calc.sheet.expression import line_text
from calc.solve import solve
from tests.conftest import FEW

NUMBER = r"\d+(?:\.\d+)?(?:·10[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+)?"
RAISED = {sign: plain for sign, plain in zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")}
WORDS = {
    "π": math.pi, "e": math.e, "i": 1j, "sin": np.sin, "cos": np.cos, "tan": np.tan, "arcsin": np.arcsin,
    "arccos": np.arccos,
    "arctan": np.arctan, "arsinh": np.arcsinh, "exp": np.exp, "ln": np.log, "ln1p": np.log1p, "lg": np.log10,
    "tanh": np.tanh, "floor": np.floor,
    "erf": np.vectorize(math.erf), "inv": lambda x: np.tan(x) - x, "arg": np.angle, "conj": np.conj, "Im": np.imag,
    "Re": np.real,
    "max": lambda *x: np.max(x[0]) if len(x) == 1 else np.maximum.reduce(x),
    "min": lambda *x: np.min(x[0]) if len(x) == 1 else np.minimum.reduce(x),
    "rss": lambda x: np.sqrt(np.sum(np.square(x))), "Σ": np.sum, "sqrt": np.emath.sqrt, "abs": np.abs,
    "vector": lambda r, angle: cmath.rect(r, math.radians(angle)), "row": lambda *x: np.array(x),
}  # fmt: skip
TOKEN = re.compile(
    rf"(?P<vector>{NUMBER}∠−?{NUMBER}°)|(?P<number>{NUMBER})(?P<unit>i?)|(?P<power>[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+)|(?P<word>[^\W\d_]\w*)|(?P<sign>\S)"
)


def number(text: str) -> float:
    mantissa, _, power = text.replace("−", "-").partition("·10")
    return float(f"{mantissa}e{raised(power)}") if power else float(mantissa)


def raised(text: str) -> str:
    return "".join(RAISED[sign] for sign in text)


def worked_out(text: str):
    """The value of a printed substitution.  A list stands in parentheses with semicolons, a modulus between strokes."""
    # operand: one may begin here; close: of a root without parentheses
    out, open_strokes, operand, close = ([], 0, True, "")
    for token in TOKEN.finditer(text):
        kind, found = token.lastgroup, token[0]
        if token["vector"]:
            length, angle = found[:-1].split("∠")
            out.append(f"vector({number(length)!r}, {number(angle)!r})")
        elif token["number"]:
            out.append(f"({number(token['number'])!r}{'*i' if token['unit'] else ''})")
        elif kind == "power":
            out.append(f"**({raised(found)})")
        elif kind == "word":
            out.append(found)
        elif found == "√":
            out.append("sqrt" if text[token.end()] == "(" else "sqrt(")
            close, operand = out[-1][4:].replace("(", ")"), True
            continue
        elif found == "|":
            out.append("abs(" if operand else ")")
            open_strokes += 1 if operand else -1
        else:
            out.append({"−": "-", "·": "*", "^": "**"}.get(found, found))
        out.append(close)
        close = ""
        operand = found in "+−·/^,(;Σ" or (found == "|" and out[-2] == "abs(")
    assert not open_strokes
    return eval(rows("".join(out)), {"__builtins__": {}}, WORDS)


def rows(python: str) -> str:
    """`(a;b)` as `row(a,b)`; what follows a word are its arguments."""
    starts, out = [], list(python)
    for at, sign in enumerate(python):
        if sign == "(":
            starts.append(at)
        elif sign == ")":
            starts.pop()
        elif sign == ";":
            out[at] = ","
            alone = not python[: starts[-1]][-1:].isalnum()
            out[starts[-1]] = "row(" if alone and out[starts[-1]] == "(" else out[starts[-1]]
    return "".join(out)


def half_a_unit(text: str) -> float:
    """Of the last digit of a number, which has four; noughts at its end are not printed."""
    value = abs(number(text))
    return 0.5 * 10.0 ** (math.floor(math.log10(value)) - 3) if value else 5e-4


def agrees(again, text: str) -> bool:
    length, _, angle = text.rstrip("°").partition("∠")
    if not angle:
        assert abs(np.imag(again)) <= half_a_unit(length)
        turn = 360.0 if text in ("180", "−180") else math.inf
        return abs(math.remainder(float(np.real(again)) - number(length), turn)) <= half_a_unit(length) * (1 + 1e-6)
    off = math.remainder(math.degrees(cmath.phase(again)) - number(angle), 360)
    return abs(abs(again) - number(length)) <= half_a_unit(length) * (1 + 1e-6) and abs(off) <= half_a_unit(angle) * (
        1 + 1e-6
    )


@cache
def printed():
    """Of every line with a substitution: the design, the symbol, the numbers, the value without its unit, the unit's
    factor."""
    from calc.sheet.expression import _result_unit, expression, result

    found = []
    for path in FEW:
        results = solve(design(read(path)))
        for line in {id(line): line for outcome in results.outcomes.values() for line in outcome.lines}.values():
            if expression(line.formula) is not None:
                found.append((path.stem, line, result(line)[0], _result_unit(line.formula)[1]))
    return found


def off(chosen) -> list[str]:
    wrong = []
    for name, line, value, factor in chosen:
        head, written, _ = line_text(line)
        numbers = written[2:].rsplit(" = ", 1)[0]
        if "…" not in numbers and not agrees(worked_out(numbers) / factor, value):
            wrong.append(f"{name}: {head}: {numbers} is not {value}")
    return wrong


def test_300_at_random_give_their_values():
    drawn = random.sample(printed(), 300)
    assert not (wrong := off(drawn)), "\n".join(wrong)


@pytest.mark.slow
def test_all_of_them_give_their_values():
    assert len(printed()) > 10_000
    assert not (wrong := off(printed())), "\n".join(wrong)


@pytest.mark.slow
def test_no_dust_is_printed():
    """What is zero by cancellation is 0: nothing in these designs is as small as 10⁻¹³ of its unit."""
    small = re.compile(r"·10⁻(?:¹[³⁴⁵⁶⁷⁸⁹]|²[⁰¹²³⁴⁵⁶⁷⁸⁹])")
    dusty = [f"{name}: {text}" for name, line, *_ in printed() if small.search(text := line_text(line)[1])]
    assert not dusty, "\n".join(dusty)


@pytest.mark.parametrize(
    "text, value",
    [
        ("2·10³·√4/(1 + 3)²", 250.0),
        ("|−1|·√(9 + 16)", 5.0),
        ("Σ((1; 2)·(3; 4))", 11.0),
        ("2∠90°", 2j),
        ("√π/2", math.sqrt(math.pi) / 2),
        ("max(1; 2)^0.5", math.sqrt(2)),
        ("max((1; 3)) − 1·(2; 1)", (1, 2)),
        ("|3 − |−5||", 2.0),
        ("2i·3", 6j),
    ],
)
def test_the_reader_itself(text, value):
    assert worked_out(text) == pytest.approx(value)


def test_the_reader_sees_a_wrong_digit():
    assert agrees(0.5498, "0.5498") and not agrees(0.54986, "0.5498") and not agrees(1.2 + 0j, "1.2∠1°")
