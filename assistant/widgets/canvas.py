# SPDX-License-Identifier: Apache-2.0
"""Sketches in character cells: braille lines, areas of half-blocks, words and dimensions that never run into each other.

A sketch is fitted into its frame with all its words, to true scale: a dot is as wide as high.  What the edited field changes is lit; a
part that fails has the colour of failure and its sign.
"""

import math
from collections.abc import Iterable

import numpy as np
from rich.cells import cell_len
from textual.content import Content, Span

from calc.locale import Language
from calc.draw.drawing import AXIS, CONTEXT, HIDDEN, Arc, Area, Dimension, Mark, Point, Polyline, Sketch, Words, reach

from ..arrangement import CENTRE, LEFT, RIGHT, Fit, Frame, Spread, arranged, words_of
from ..raster import LOWER, UPPER, Floats, Integers, Raster
from .signs import Signs
from .text import wrap

FAINT, NORMAL, WARN, FAIL, LIT = range(1, 6)  # roles: a higher one is drawn over a lower one
STYLES = {FAINT: "muted", WARN: "warn", FAIL: "fail", LIT: "lit"}
STATES = {"": NORMAL, "warn": WARN, "fail": FAIL}
PATTERNS: dict[str, tuple[float, ...]] = {AXIS: (8, 3, 1, 3), HIDDEN: (3, 3)}
WITNESS = (1.0, 2.0)  # pattern of the lines from a part to its dimension
HEAD, HEAD_ANGLE = 5.0, math.radians(25)  # dots; of an arrow
PAPER = {True: 0x1A, False: 0xE8}  # grey of the background, dark or light, that the fill of areas is mixed with
INK = {FAINT: 0x80, NORMAL: 0xB0}
SHIFTS = sorted(
    ((row, column) for row in range(-2, 3) for column in range(-6, 7)), key=lambda shift: (2 * abs(shift[0]) + abs(shift[1]), shift)
)  # how a word may be moved, in rows and columns
ON_A_LINE, BESIDE_A_WORD = 1.0, 2.0  # what each cell of a line under a word, and a word right beside it, is worth in `SHIFTS`


def draw(sketch: Sketch, columns: int, rows: int, signs: Signs, say: Language, lit: str = "") -> Content:
    """The sketch in so many cells; nothing where there is no room for it."""
    if columns < 4 or rows < 2:
        return Content("")
    canvas = Canvas(columns, rows, signs, say, lit)
    notes = noted(list(dict.fromkeys(say(note) for one in (sketch, *sketch.beside) for note in one.notes)), columns)
    below = notes if rows > 4 + len(notes) else []
    for picture, frame in arranged([Spread(one, say) for one in (sketch, *sketch.beside)], columns, rows - len(below)):
        canvas.picture(picture, frame)
    for row, note in enumerate(below, rows - len(below)):
        canvas.put(row, max(0, (columns - cell_len(note)) // 2), note, FAINT)
    return canvas.content()


def noted(notes: list[str], columns: int) -> list[str]:
    """The notes in rows, as many in one as there is room for."""
    rows: list[str] = []
    for note in notes:
        if rows and cell_len(joined := f"{rows[-1]} · {note}") <= columns:
            rows[-1] = joined
        else:
            rows += wrap(note, columns)
    return rows


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
    def picture(self, picture: Spread, frame: Frame) -> None:
        """Draw one picture into its frame."""
        sketch, fit = picture.sketch, Fit(picture, frame)
        if sketch.title:
            title = self.say(sketch.title)
            self.put(fit.title, frame.left + max(0, (frame.columns - cell_len(title)) // 2), title, FAINT)
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
                text = words_of(mark, self.say) + (f" {self.signs.mark(mark.state)}" if mark.state else "")
                wide = cell_len(text)
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

    def _mark_states(self, sketch: Sketch, fit: Fit, frame: Frame) -> None:
        """The sign of each part that fails, or of which is warned, at its upper right: one for all marks of one field or part.

        Words have theirs behind them.
        """
        ends: dict[tuple[str, str], Point] = {}
        told = {(mark.state, mark.key) for mark in sketch.primitives if isinstance(mark, Words)}
        for mark in sketch.primitives:
            if mark.state and (mark.state, mark.key) not in told:
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

    def _number(self, mark: Dimension, fit: Fit, frame: Frame) -> None:
        """In a level line, or right of it where it is too short; beside an upright one."""
        text, role = words_of(mark, self.say), self.role(mark)
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

    def _place(self, text: str, row: int, column: int, role: int, frame: Frame) -> None:
        """Write near a place where no other word stands, clear of lines if possible; not at all where there is no room."""
        top, bottom, left, right = frame.top, frame.top + frame.rows, frame.left, frame.left + frame.columns
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
        for look, code in zip(looks, codes):
            letters = code[code >= 0].astype("<u4").tobytes().decode("utf-32-le")
            ends = np.concatenate([[0], np.flatnonzero(np.diff(look)) + 1, [self.columns]])
            places = (at + np.concatenate([[0], np.cumsum(code >= 0)])[ends]).tolist()
            for number, start, end in zip(look[ends[:-1]].tolist(), places, places[1:]):
                if number:
                    spans.append(Span(start, end, self._style(number // count**2, number // count % count, number % count)))
            rows.append(letters)
            at += len(letters) + 1
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
