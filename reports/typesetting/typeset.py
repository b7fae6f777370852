# SPDX-License-Identifier: Apache-2.0
"""Formulas set from the trees of the sheet: fractions, roots, indices, sums, brackets that grow.

A tree becomes a row of pieces; before some of them a line may break, outside of brackets where that is possible.
What is wider than the column and can not break (a fraction, a root, a power) is written out on the line instead."""

import re
from dataclasses import dataclass
from functools import lru_cache
from itertools import groupby, pairwise

from calc.sheet.expression import RANK, Expr, rank_of_number
from calc.sheet.number import SUPERSCRIPTS

from .boxes import BLACK, Box, Colour, fraction, radical, raised, row, scaled, space, stretched, text
from .fonts import ITALIC, UPRIGHT

SMALL = 0.75  # of the size: indices and exponents
SMALLEST = 6.0  # points
TIGHT = 1.25  # what is so much wider than the column is made smaller rather than written out
RAISE, LOWER = 0.36, 0.17  # of the size
SUPER = dict(zip("⁺⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "+−0123456789"))
# in T_1T_2 the second T is a letter with an index of its own
INDEX = re.compile(r"_((?:[^\W_]|[⁺⁻,∞])(?:(?![^\W\d_]_)[^\W_]|[⁺⁻,∞])*)")
LETTERS = re.compile(r"[^\W\d_]+")
UPRIGHT_LETTERS = set("ΣΔΠ∠°")


@dataclass(frozen=True, slots=True)
class SetPiece:
    """A box in a formula; `open` counts the brackets around it where a line may break before it, None where it may
    not."""

    box: Box
    open: float | None = None


# --- symbols


@lru_cache(maxsize=5000)
def symbol(name: str, size: float, colour: Colour = BLACK) -> Box:
    """A symbol as the sheet writes it: `C_1⁻,res` → C with a raised minus and the index "1,res"; operators may stand
    between."""
    boxes: list[Box] = []
    small = max(SMALLEST, size * SMALL)
    for letters, below, above in symbol_parts(name):
        if letters:
            for upright, some in groupby(letters, lambda c: not c.isalpha() or c in UPRIGHT_LETTERS):
                boxes.append(text("".join(some), size, UPRIGHT if upright else ITALIC, colour))
        if below or above:
            boxes.append(_scripts(below, above, size, small, colour))
    return row(boxes)


def symbol_parts(name: str) -> list[tuple[str, str, str]]:
    """The pieces of a symbol: letters of one kind, or another sign, each with what stands below and above it at the
    right."""
    parts: list[tuple[str, str, str]] = []

    def script(below: str, above: str) -> None:
        letters = parts.pop()[0] if parts and not (parts[-1][1] or parts[-1][2]) else ""
        parts.append((letters, below, above))

    at = 0
    while at < len(name):
        if (index := INDEX.match(name, at)) and at:
            at = index.end()
            script("".join(c for c in index[1] if c not in SUPER), "".join(SUPER[c] for c in index[1] if c in SUPER))
        elif name[at] in "⁺⁻":
            script("", SUPER[name[at]])
            at += 1
        elif word := LETTERS.match(name, at):
            at = word.end()
            parts.append((word[0], "", ""))
        else:
            parts.append((name[at], "", ""))
            at += 1
    return parts


def _scripts(below: str, above: str, size: float, small: float, colour: Colour) -> Box:
    low = raised(text(below, small, UPRIGHT, colour), -LOWER * size) if below else space(0.0)
    if not above:
        return low
    small *= 0.9
    # A sign over an index stands above it, not behind it.
    high = raised(text(above, small, UPRIGHT, colour), RAISE * size)
    marks = (*high.marks, *low.marks)
    return Box(max(low.width, high.width), high.up, max(low.down, 0.0), marks)


@lru_cache(maxsize=200)
def _spaced(sign: str, size: float, gap: float) -> Box:
    """A sign with room on both sides."""
    return row([space(gap), text(sign, size), space(gap)])


# --- trees


class Setter:
    """Sets trees at one size for one column width."""

    def __init__(self, size: float, column: float, *, script: bool = False) -> None:
        self.size, self.column, self.script = size, column, script

    def smaller(self) -> "Setter":
        return Setter(max(SMALLEST, self.size * SMALL), self.column, script=True)

    def word(self, words: str, face: str = UPRIGHT) -> Box:
        return text(words, self.size, face)

    def operator(self, sign: str, gap: float) -> Box:
        return _spaced(sign, self.size, gap * self.size * (0.5 if self.script else 1.0))

    def fitted(self, box: Box) -> Box:
        return scaled(box, self.column / box.width) if box.width > self.column else box

    def box(self, tree: Expr, outer: float = 0.0) -> Box:
        return row([p.box for p in self.pieces(tree, outer)])

    def pieces(self, tree: Expr, outer: float = 0.0, open: float = 0.0) -> list[SetPiece]:
        """The row of a tree, in brackets where what stands around it (`outer`) binds more strongly."""
        rank, pieces = self._pieces(tree, outer, open)
        return self.bracketed(pieces, open) if rank < outer else pieces

    def bracketed(self, inside: list[SetPiece], open: float, left: str = "(", right: str = ")") -> list[SetPiece]:
        up, down = max(p.box.up for p in inside), max(p.box.down for p in inside)
        deeper = [SetPiece(p.box, p.open + 1.0) if p.open is not None else p for p in inside]
        return [
            SetPiece(stretched(left, self.size, up, down)),
            *deeper,
            SetPiece(stretched(right, self.size, up, down)),
        ]

    def _pieces(self, tree: Expr, outer: float, open: float) -> tuple[float, list[SetPiece]]:
        a = tree.args
        match tree.head:
            case "number":
                return rank_of_number(tree.name, outer), [SetPiece(self.word(tree.name))]
            case "symbol":
                face = symbol(tree.name, self.size)
                return 5.0, [SetPiece(face)]
            case "add":
                return 1.0, [
                    *self.pieces(a[0], 1, open),
                    SetPiece(self.operator("+", 0.24), open),
                    *self.pieces(a[1], 1, open),
                ]
            case "sub":
                return 1.0, [
                    *self.pieces(a[0], 1, open),
                    SetPiece(self.operator("−", 0.24), open),
                    *self.pieces(a[1], 1.5, open),
                ]
            case "mul":
                return 2.0, [
                    *self.pieces(a[0], 2, open),
                    SetPiece(self.operator("·", 0.07), open + 0.5),
                    *self.pieces(a[1], 2.2, open),
                ]
            case "neg":
                return RANK["neg"], [SetPiece(self.word("−")), *self.pieces(a[0], RANK["neg"], open)]
            case "div":
                return self.quotient(a[0], a[1], open)
            case "pow":
                return self.power(a[0], a[1], open)
            case "sqrt":
                return self.root(a[0], open)
            case "cis":
                return self.exponential(a[0], "i", open)
            case "sum":
                sign = raised(text("Σ", self.size * 1.25), -0.06 * self.size)
                return 4.5, [SetPiece(sign), *self.bracketed(self.pieces(a[0], 0, open), open)]
            case "abs":
                return 5.0, self.bracketed(self.pieces(a[0], 0, open), open, "|", "|")
        return self.call(tree, open)

    def call(self, tree: Expr, open: float) -> tuple[float, list[SetPiece]]:
        if tree.name == "exp" and len(tree.args) == 1:
            return self.exponential(tree.args[0], "", open)
        if tree.name == "conj" and (inside := self.box(tree.args[0])).width <= self.column:
            bar = (
                "rule",
                0.06 * self.size,
                inside.up + 0.05 * self.size,
                inside.width - 0.04 * self.size,
                0.05 * self.size,
                BLACK,
            )
            return 5.0, [
                SetPiece(
                    Box(
                        inside.width + 0.06 * self.size, inside.up + 0.14 * self.size, inside.down, (*inside.marks, bar)
                    )
                )
            ]
        if tree.name == "rss" and len(tree.args) == 1:
            return self.root(Expr("sum", (Expr("pow", (tree.args[0], Expr("number", name="2"))),)), open)
        inside_pieces: list[SetPiece] = []
        for i, arg in enumerate(tree.args):
            if i:
                inside_pieces.append(SetPiece(self.word("; ")))
            more = self.pieces(arg, 0, open)
            inside_pieces += [SetPiece(more[0].box, open), *more[1:]] if i else more
        name = SetPiece(row([self.word(tree.name), space(0.04 * self.size)]))
        return 5.0, [name, *self.bracketed(inside_pieces or [SetPiece(space(0.0))], open)]

    def quotient(self, over: Expr, under: Expr, open: float) -> tuple[float, list[SetPiece]]:
        while over.head == "div":  # a/b/c as one fraction
            over, under = over.args[0], Expr("mul", (over.args[1], under))
        if not self.script:
            box = fraction(self.box(over), self.box(under), self.size)
            if box.width <= self.column * TIGHT:
                return 4.4, [SetPiece(self.fitted(box))]
        slash = SetPiece(_spaced("/", self.size, 0.04 * self.size), None if self.script else open + 0.5)
        return 2.0, [*self.pieces(over, 2, open), slash, *self.pieces(under, 2.5, open)]

    def power(self, base: Expr, exponent: Expr, open: float) -> tuple[float, list[SetPiece]]:
        under = self.pieces(base, 4.5, open)
        whole = (
            f"−{exponent.args[0].name}"
            if exponent.head == "neg"
            else exponent.name
            if exponent.head == "number"
            else ""
        )
        if whole.lstrip("−").isdigit() and max(p.box.up for p in under) <= 0.8 * self.size:
            script = self.word(whole.translate(SUPERSCRIPTS))
        else:
            high = max(p.box.up for p in under)
            inside = self.smaller().box(exponent)
            if inside.width > 0.7 * self.column:
                return 4.0, [*under, SetPiece(self.word("^")), *self.pieces(exponent, 5, open)]
            script = raised(inside, max(RAISE * self.size, high - 0.40 * self.size) + inside.down - 0.24 * inside.up)
        return 4.0, [*under[:-1], SetPiece(row([under[-1].box, script]), under[-1].open)]

    def root(self, of: Expr, open: float) -> tuple[float, list[SetPiece]]:
        box = radical(self.box(of), self.size)
        if box.width <= self.column * TIGHT:
            return 4.5, [SetPiece(self.fitted(box))]
        return 4.5, [SetPiece(self.word("√")), *self.bracketed(self.pieces(of, 0, open), open)]

    def exponential(self, of: Expr, unit: str, open: float) -> tuple[float, list[SetPiece]]:
        e = self.word("e", ITALIC if not unit else UPRIGHT)
        small = self.smaller()
        inside = small.box(of, 2.2 if unit else 0.0)
        if unit:
            inside = row([small.word(unit, UPRIGHT), small.operator("·", 0.05), inside])
        if inside.width <= 0.7 * self.column:
            up = raised(inside, RAISE * self.size + max(0.0, inside.down - 0.30 * self.size))
            return 4.0, [SetPiece(row([e, up]))]
        pieces = self.pieces(of, 2.2 if unit else 0.0, open)
        head = [SetPiece(self.word(unit + "·"))] if unit else []
        return 4.0, [SetPiece(e), SetPiece(self.word("^")), *self.bracketed([*head, *pieces], open)]


# --- lines

# what a line costs that is made smaller, where a break costs the number of brackets that it leaves open: less than one,
# since all in a bracket is read more easily on one line
SHRUNK = 0.6
Cost = tuple[float, float, int, float]  # what is too wide, what is torn or made smaller, lines, how they look


def lines(pieces: list[SetPiece], width: float) -> list[Box]:
    """Pieces broken into lines of at most this width: outside of all brackets where that is possible, else inside as
    few as possible, or made a little smaller (at most TIGHT); on few lines, at operators that fill them well."""
    starts = [0, *(n for n, piece in enumerate(pieces) if n and piece.open is not None), len(pieces)]
    ends = [0.0]  # of what stands before each of these
    for start, end in pairwise(starts):
        ends.append(ends[-1] + sum(piece.box.width for piece in pieces[start:end]))
    # up to each of them what the lines cost at least, and where the last of these begins
    best: list[tuple[Cost, int]] = [((0.0, 0.0, 0, 0.0), 0)]
    last = len(starts) - 1
    for end in range(1, len(starts)):
        opened = (pieces[starts[end]].open or 0.0) if end < last else 0.0
        torn = max(0.0, opened // 1.0)
        choices: list[tuple[Cost, int]] = []
        for start in range(end - 1, -1, -1):
            full = (ends[end] - ends[start]) / width
            if full > TIGHT and choices:
                break
            excess, made_smaller, count, looks = best[start][0]
            excess += max(0.0, full - TIGHT)
            made_smaller += torn + (SHRUNK if full > 1.0 + 1e-9 else 0.0)
            looks += opened - torn + (4.0 * max(0.0, 1.0 - full) ** 2 if end < last else 0.0)
            choices.append(((excess, made_smaller, count + 1, looks), start))
        best.append(min(choices))
    set_lines: list[Box] = []
    while last > 0:
        start = best[last][1]
        line = row([piece.box for piece in pieces[starts[start] : starts[last]]])
        set_lines.insert(0, scaled(line, width / line.width) if line.width > width else line)
        last = start
    return set_lines


def formula(tree: Expr, size: float, column: float) -> list[SetPiece]:
    """The pieces of a whole formula at one size, for a column of this width."""
    return Setter(size, column).pieces(tree)
