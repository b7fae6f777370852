# SPDX-License-Identifier: Apache-2.0
"""Sketches in character cells: braille lines, areas of half-blocks, words and dimensions that never run into each other.

A sketch is fitted into its frame with all its words, to true scale: a dot is as wide as high.  What the edited field changes is lit; a
part that fails has the colour of failure and its sign.
"""

import math
from collections.abc import Iterable, Sequence
from itertools import pairwise

import numpy as np
from rich.cells import cell_len
from textual.content import Content, Span

from calc.languages import Language
from calc.sheet.drawing import AXIS, CONTEXT, HIDDEN, Arc, Area, Dimension, Mark, Point, Polyline, Sketch, Words, reach
from calc.sheet.text import Amount

from .raster import LOWER, UPPER, Floats, Integers, Raster
from .widgets.signs import Signs

FAINT, NORMAL, WARN, FAIL, LIT = range(1, 6)  # roles: a higher one is drawn over a lower one
STYLES = {FAINT: "muted", WARN: "warn", FAIL: "fail", LIT: "lit"}
STATES = {"": NORMAL, "warn": WARN, "fail": FAIL}
PATTERNS: dict[str, tuple[float, ...]] = {AXIS: (8, 3, 1, 3), HIDDEN: (3, 3)}
WITNESS = (1.0, 2.0)  # pattern of the lines from a part to its dimension
HEAD, HEAD_ANGLE = 5.0, math.radians(25)  # dots; of an arrow
LEAST = 18, 5  # columns and rows below which a picture beside another one is left out
GAP = 3  # columns between pictures
PAPER = {True: 0x1A, False: 0xE8}  # grey of the background, dark or light, that the fill of areas is mixed with
INK = {FAINT: 0x80, NORMAL: 0xB0}
SHIFTS = sorted(
    ((row, column) for row in range(-2, 3) for column in range(-6, 7)), key=lambda shift: (2 * abs(shift[0]) + abs(shift[1]), shift)
)  # how a word may be moved, in rows and columns
ON_A_LINE, BESIDE_A_WORD = 1.0, 2.0  # what each cell of a line under a word, and a word right beside it, is worth in `SHIFTS`
RIGHT, CENTRE, LEFT = "left", "centre", "right"


def draw(sketch: Sketch, columns: int, rows: int, signs: Signs, say: Language, lit: str = "") -> Content:
    """The sketch in so many cells; nothing where there is no room for it."""
    if columns < 4 or rows < 2:
        return Content("")
    canvas = Canvas(columns, rows, signs, say, lit)
    notes = " · ".join(dict.fromkeys(say(note) for one in (sketch, *sketch.beside) for note in one.notes))
    below = 1 if notes and rows > LEAST[1] else 0
    for one, left, top, wide, high in _frames(sketch, columns, rows - below, say):
        canvas.picture(one, left, top, wide, high)
    if below:
        canvas.put(rows - 1, max(0, (columns - cell_len(notes)) // 2), notes, FAINT)
    return canvas.content()


Frame = tuple[Sketch, int, int, int, int]  # left, top, columns, rows


def _frames(sketch: Sketch, columns: int, rows: int, say: Language) -> list[Frame]:
    """The pictures side by side or one above the other, whichever draws them larger; as many as there is room for."""
    pictures = [sketch, *sketch.beside]
    while True:
        arrangements = [_row(pictures, columns, rows), _column(pictures, columns, rows)]
        fitting = [frames for frames in arrangements if all(f[3] >= LEAST[0] and f[4] >= LEAST[1] for f in frames)]
        if len(pictures) == 1:
            return arrangements[0]
        if fitting:
            return max(fitting, key=lambda frames: math.prod(Fit(f[0], f[3], f[4], say).scale for f in frames))
        pictures.pop()


def _row(pictures: Sequence[Sketch], columns: int, rows: int) -> list[Frame]:
    shapes = [min(max(_slimness(one), 0.6), 3.0) for one in pictures]
    widths = _shared(columns - GAP * (len(pictures) - 1), shapes)
    return [(one, sum(widths[:n]) + GAP * n, 0, widths[n], rows) for n, one in enumerate(pictures)]


def _column(pictures: Sequence[Sketch], columns: int, rows: int) -> list[Frame]:
    shapes = [1 / min(max(_slimness(one), 0.6), 3.0) for one in pictures]
    heights = _shared(rows, shapes)
    return [(one, 0, sum(heights[:n]), columns, heights[n]) for n, one in enumerate(pictures)]


def _slimness(sketch: Sketch) -> float:
    left, bottom, right, top = sketch.box
    return (right - left) / (top - bottom) if top > bottom else 1.0


def _shared(cells: int, weights: Sequence[float]) -> list[int]:
    ends = [round(cells * sum(weights[:n]) / sum(weights)) for n in range(len(weights) + 1)]
    return [end - start for start, end in pairwise(ends)]


class Fit:
    """Where metres lie in a frame of cells: the largest true scale at which the picture and its words are within."""

    def __init__(self, sketch: Sketch, columns: int, rows: int, say: Language) -> None:
        reaches: list[tuple[float, ...]] = [(*point, 0.3, 0.3, 0.15, 0.15) for mark in sketch.primitives for point in reach(mark)]
        reaches += [reach for mark in sketch.primitives for reach in _word_reach(mark, say)]
        x, y, left, right, up, down = np.array(reaches or [(0.0,) * 6]).T
        rows -= bool(sketch.title)

        def spans(scale: float) -> tuple[float, float, float, float]:
            across, upwards = x * scale, y * scale / 2
            return (across - left).min(), (across + right).max(), (upwards + up).max(), (upwards - down).min()

        def fits(scale: float) -> bool:
            first, last, top, bottom = spans(scale)
            return bool(last - first <= columns and top - bottom <= rows)

        extent = max(float(np.ptp(x)), float(np.ptp(y)))
        low, high = 0.0, 2 * (columns + 2 * rows) / extent if extent else 1.0
        for _ in range(24):
            middle = (low + high) / 2
            low, high = (middle, high) if fits(middle) else (low, middle)
        self.scale = low  # columns per metre
        first, last, top, bottom = spans(low)
        self.x = (columns - (last - first)) / 2 - first
        self.y = (rows - (top - bottom)) / 2 + top + bool(sketch.title)

    def cell(self, at: Point) -> tuple[int, int]:
        """Row and column of a place."""
        return math.floor(self.y - at[1] * self.scale / 2), math.floor(self.x + at[0] * self.scale)

    def dots(self, points: Iterable[Point]) -> Floats:
        places = np.array(list(points), float).reshape(-1, 2)
        return np.column_stack([2 * (self.x + places[:, 0] * self.scale), 4 * (self.y - places[:, 1] * self.scale / 2)])


def _word_reach(mark: Mark, say: Language) -> Iterable[tuple[float, ...]]:
    """A place, and how many cells its words reach from there to the left, right, up and down."""
    match mark:
        case Words(at=at, side=side):
            wide = cell_len(_words(mark, say))
            left: float = {RIGHT: 0.0, CENTRE: wide / 2, LEFT: wide}[side]
            yield *at, left, wide - left, 0.5, 0.5
        case Dimension(start=start, end=end, line=(x, y), upright=upright):
            room = cell_len(_words(mark, say)) + 2
            if upright:
                left, right = (1.0, room) if x >= start[0] else (room, 1.0)
                yield x, (start[1] + end[1]) / 2, left, right, 0.5, 0.5
            else:
                yield (start[0] + end[0]) / 2, y, room / 2, room / 2, 0.5, 0.5


def _words(mark: Words | Dimension, say: Language) -> str:
    """What a word or a dimension says, with the sign of failure or of a warning in front."""
    if isinstance(mark, Words):
        return say(mark.text)
    if mark.label:
        return say(mark.label)
    length = mark.end[1] - mark.start[1] if mark.upright else mark.end[0] - mark.start[0]
    return ("Ø " if mark.diameter else "") + say.part(Amount(abs(length) * 1000, "mm"))


class Canvas:
    """The cells of a picture: `fill` below lines below `text`."""

    def __init__(self, columns: int, rows: int, signs: Signs, say: Language, lit: str) -> None:
        self.columns, self.rows, self.signs, self.say, self.lit = columns, rows, signs, say, lit
        self.raster = Raster(columns, rows)
        self.text = np.zeros((rows, columns), np.int64)  # code of a letter; 0: none; -1: the second half of a wide one
        self.text_roles = np.zeros((rows, columns), np.int64)
        self.fills: list[tuple[int, float]] = []  # role and shade of each value of `raster.fill`

    def role(self, mark: Mark) -> int:
        if self.lit and any(self.lit == key or self.lit.startswith(f"{key}.") for key in mark.key.split()):
            return LIT
        return STATES[mark.state] if mark.state else FAINT if mark.layer in (CONTEXT, AXIS, HIDDEN) else NORMAL

    # --- pictures
    def picture(self, sketch: Sketch, left: int, top: int, columns: int, rows: int) -> None:
        """Draw one picture into its frame."""
        fit = Fit(sketch, columns, rows, self.say)
        fit.x, fit.y = fit.x + left, fit.y + top
        frame = (top + bool(sketch.title), top + rows, left, left + columns)
        if sketch.title:
            title = self.say(sketch.title)
            self.put(top, left + max(0, (columns - cell_len(title)) // 2), title, FAINT)
        paths: list[tuple[Floats, int, tuple[float, ...]]] = []
        for mark in sketch.primitives:
            paths += self._paths(mark, fit)
        self.raster.lines(paths)
        dimensions = [mark for mark in sketch.primitives if isinstance(mark, Dimension)]
        for dimension in dimensions:
            self._dimension_line(dimension, fit)
        for mark in sorted(sketch.primitives, key=lambda mark: -self.role(mark)):
            if isinstance(mark, Words):
                row, column = fit.cell(mark.at)
                wide = cell_len(text := _words(mark, self.say))
                start = {RIGHT: column, CENTRE: round(fit.x + mark.at[0] * fit.scale - wide / 2), LEFT: column - wide + 1}[mark.side]
                self._place(text, row, start, self.role(mark), frame)
        for dimension in dimensions:
            self._number(dimension, fit, frame)
        self._mark_states(sketch, fit, frame)

    def _paths(self, mark: Mark, fit: Fit) -> Iterable[tuple[Floats, int, tuple[float, ...]]]:
        role, pattern = self.role(mark), PATTERNS.get(mark.layer, ())
        match mark:
            case Polyline(points=points, closed=closed, arrow=arrow):
                dots = fit.dots((*points, points[0]) if closed else points)
                yield dots, role, pattern
                if arrow:
                    yield _head(dots), role, ()
            case Arc(centre=centre, radius=r, start=start, end=end):
                corners = 2 + min(180, math.ceil((end - start) * math.sqrt(r * fit.scale) * 4))
                angles = np.linspace(start, end, corners)
                yield fit.dots(zip(centre[0] + r * np.cos(angles), centre[1] + r * np.sin(angles))), role, pattern
            case Area(outlines=outlines, shade=shade):
                self.fills.append((role, shade))
                self.raster.area([fit.dots(outline) for outline in outlines], len(self.fills))
            case Dimension(start=start, end=end, line=(x, y), upright=upright):
                for from_x, from_y in (start, end):
                    yield fit.dots([(from_x, from_y), (x, from_y) if upright else (from_x, y)]), FAINT, WITNESS
            case Words():
                pass

    def _mark_states(self, sketch: Sketch, fit: Fit, frame: tuple[int, int, int, int]) -> None:
        """The sign of each part that fails, or of which is warned, at its upper right: one for all marks of one field or part."""
        ends: dict[tuple[str, str], Point] = {}
        for mark in sketch.primitives:
            if mark.state:
                corner = max(reach(mark), key=sum)
                known = ends.get((mark.state, mark.key))
                ends[mark.state, mark.key] = corner if known is None else max(known, corner, key=sum)
        for (state, _), corner in ends.items():
            row, column = fit.cell(corner)
            self._place(self.signs.mark(state), row, column + 1, STATES[state], frame)

    # --- dimensions
    def _dimension_line(self, mark: Dimension, fit: Fit) -> None:
        role = role if (role := self.role(mark)) != NORMAL else FAINT
        ascii = self.signs.ascii
        (r0, c0), (r1, c1) = (fit.cell((mark.line[0], p[1]) if mark.upright else (p[0], mark.line[1])) for p in (mark.start, mark.end))
        if mark.upright:
            top, bottom = sorted((r0, r1))
            for row in range(top, bottom + 1):
                alone = "|" if ascii else "↕"
                end = "+" if ascii else "┬" if row == top else "┴"
                self.put(row, c0, alone if top == bottom else end if row in (top, bottom) else "|" if ascii else "│", role, free=True)
        else:
            left, right = sorted((c0, c1))
            inner = ("-" if ascii else "─") * (right - left - 1)
            line = ("|" if ascii else "↔") if left == right else f"|{inner}|" if ascii else f"├{inner}┤"
            self.put(r0, left, line, role, free=True)

    def _number(self, mark: Dimension, fit: Fit, frame: tuple[int, int, int, int]) -> None:
        """In a level line, or right of it where it is too short; beside an upright one."""
        text, role = _words(mark, self.say), self.role(mark)
        wide = cell_len(text)
        (r0, c0), (r1, c1) = (fit.cell((mark.line[0], p[1]) if mark.upright else (p[0], mark.line[1])) for p in (mark.start, mark.end))
        if mark.upright:
            self._place(text, (r0 + r1) // 2, c0 + 2 if mark.line[0] >= mark.start[0] else c0 - 1 - wide, role, frame)
        elif abs(c1 - c0) >= wide + 3:
            self.put(r0, (c0 + c1 + 1 - wide) // 2 - 1, f" {text} ", role)
        else:
            self._place(text, r0, max(c0, c1) + 2, role, frame)

    # --- words
    def put(self, row: int, column: int, text: str, role: int, free: bool = False) -> None:
        """Write over lines, and over words too, or (`free`) only where none stand."""
        for letter in text:
            wide = cell_len(letter)
            if 0 <= row < self.rows and 0 <= column and column + wide <= self.columns and wide and not (free and self.text[row, column]):
                self.text[row, column : column + wide] = [ord(letter), -1][:wide]
                self.text_roles[row, column] = role
            column += wide

    def _place(self, text: str, row: int, column: int, role: int, frame: tuple[int, int, int, int]) -> None:
        """Write near a place where no other word stands, clear of lines if possible; not at all where there is no room."""
        top, bottom, left, right = frame
        wide = cell_len(text)
        if wide > right - left:
            return
        lines = self.raster.roles > 0
        best, where = math.inf, None
        for down, aside in SHIFTS:
            r, c = row + down, min(max(column + aside, left), right - wide)
            moved = 2 * abs(r - row) + abs(c - column)
            if moved >= best:
                continue
            if not top <= r < bottom or self.text[r, c : c + wide].any():
                continue
            near = self.text[r, max(left, c - 1)] != 0 or self.text[r, min(right - 1, c + wide)] != 0
            cost = moved + ON_A_LINE * int(lines[r, c : c + wide].sum()) + BESIDE_A_WORD * near
            if cost < best:
                best, where = cost, (r, c)
        if where is not None:
            self.put(*where, text, role)

    # --- what comes out
    def content(self) -> Content:
        plain = self.signs.ascii
        letters = self.raster.letters(plain)
        upper, lower = self.raster.fill[0::2], self.raster.fill[1::2]
        codes = np.where(self.text != 0, self.text, letters)
        roles = np.where(self.text != 0, self.text_roles, np.where(letters > 0, self.raster.roles, 0))
        empty = codes == 0
        if plain:
            shades = np.array([32] + [ord(":" if shade < 0.5 else "#") for _, shade in self.fills])
            kinds = np.array([0] + [role for role, _ in self.fills])
            most = np.maximum(upper, lower)
            codes, roles = np.where(empty, shades[most], codes), np.where(empty, kinds[most], roles)
            back, front = np.zeros_like(codes), np.zeros_like(codes)
        else:
            half = empty & (upper != lower)
            top = half & (upper > 0)
            codes = np.where(half, np.where(top, UPPER, LOWER), np.where(empty, 32, codes))
            front = np.where(half, np.where(top, upper, lower), 0)
            back = np.where(half, np.where(top, lower, 0), np.where(upper == lower, upper, 0))
        return self._runs(codes, roles, front, back)

    def _runs(self, codes: Integers, roles: Integers, front: Integers, back: Integers) -> Content:
        count = len(self.fills) + 1
        looks = (roles * count + front) * count + back
        spans, rows, at = [], [], 0
        for row in range(self.rows):
            look, code = looks[row], codes[row]
            ends = [0, *(np.flatnonzero(np.diff(look)) + 1).tolist(), self.columns]
            pieces = ["".join([chr(c) for c in code[a:b].tolist() if c >= 0]) for a, b in pairwise(ends)]
            for piece, number in zip(pieces, look[ends[:-1]].tolist()):
                if number:
                    spans.append(Span(at, at + len(piece), self._style(number // count // count, number // count % count, number % count)))
                at += len(piece)
            rows.append("".join(pieces))
            at += 1
        return Content("\n".join(rows), spans)

    def _style(self, role: int, front: int, back: int) -> str:
        style = self._fill(front) if front else _style(self.signs, role)
        return f"{style} on {self._fill(back)}" if back else style

    def _fill(self, value: int) -> str:
        """The colour of an area: that of its role, thinned."""
        role, shade = self.fills[value - 1]
        paper = PAPER[self.signs.dark]
        colour = _style(self.signs, role).rpartition("#")[2] if role > NORMAL else ""
        grey = INK[role] if role in INK else 0xB0
        ink = [int(colour[n : n + 2], 16) for n in (0, 2, 4)] if len(colour) == 6 else [grey if self.signs.dark else 0xFF - grey] * 3
        return "#" + "".join(f"{round(paper + (one - paper) * shade):02x}" for one in ink)


def _head(dots: Floats) -> Floats:
    """The two strokes of an arrow's head."""
    tip = dots[-1]
    back = next((tip - one for one in dots[-2::-1] if np.hypot(*(tip - one)) > 1), None)
    if back is None:
        return dots[-1:]
    way = math.atan2(-back[1], -back[0])
    length = min(HEAD, float(np.hypot(*back)))
    barbs = [tip + length * np.array([math.cos(way + turn), math.sin(way + turn)]) for turn in (HEAD_ANGLE, -HEAD_ANGLE)]
    return np.array([barbs[0], tip, barbs[1]])


def _style(signs: Signs, role: int) -> str:
    """The style of lines and words of a role."""
    return signs.style(STYLES[role]) if role in STYLES else "not dim" if role else ""
