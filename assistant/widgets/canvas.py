# SPDX-License-Identifier: Apache-2.0
"""Sketches in character cells: braille lines, areas of half-blocks, words and dimensions that never cross each other.

Three parts: the raster of dots and halves, the arrangement of several pictures in a frame, and the canvas that draws a
sketch.  A sketch is fitted into its frame with all its words, to true scale: a dot is as wide as high.  What the edited
field changes is lit; a part that fails has the colour of failure and its sign."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from rich.cells import cell_len
from textual.content import Content, Span

from calc.draw.drawing import AXIS, CONTEXT, HIDDEN, Arc, Area, Dimension, Mark, Point, Polyline, Sketch, Words, reach
from calc.locale import Language
from calc.sheet.text import EMPTY, Amount, Text

from .signs import Signs
from .text import wrap

# --- dots of lines and halves of cells of areas: the arithmetic below the canvas
# A cell is twice as high as wide, and holds 2 by 4 square dots, or two square halves.  Places are in dots, down from
# the upper left.

Floats = npt.NDArray[np.float64]
Integers = npt.NDArray[np.int64]

BITS = np.array([[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]])  # of the dots of a braille letter
PLAIN = "-|/\\"  # by the direction of a line, where there is no braille
FLAT, STEEP = 0.4, 2.2  # slopes up to which, and from which, a line is drawn as a level or an upright one
CROSSING = 0.6  # a cell where the second direction has this share of the first shows a crossing
UPPER, LOWER = 0x2580, 0x2584  # half blocks


class Raster:
    """`roles`: how each cell of lines is drawn, a higher one over a lower one; `fill`: what is in each half of a cell,
    0 nothing."""

    def __init__(self, columns: int, rows: int) -> None:
        self.columns, self.rows = columns, rows
        self.dots = np.zeros((rows * 4, columns * 2), bool)
        self.roles = np.zeros((rows, columns), np.int64)
        self.fill = np.zeros((rows * 2, columns), np.int64)
        self._ways = np.zeros((4, rows, columns), np.int64)

    def lines(self, paths: Sequence[tuple[Floats, int, tuple[float, ...]]], within: "Frame") -> None:
        """Draw paths (corners, role, pattern): a pattern has the lengths in dots that are drawn, left out, drawn …"""
        if not paths:
            return
        starts: list[Floats] = []
        steps: list[Floats] = []
        roles: list[Integers] = []
        ways: list[Floats] = []
        keeps: list[tuple[float, ...]] = []
        for corners, role, pattern in paths:
            pieces = np.diff(corners, axis=0)
            starts.append(corners[:-1])
            steps.append(pieces)
            roles.append(np.full(len(pieces), role))
            length = np.hypot(pieces[:, 0], pieces[:, 1])
            ways.append(np.cumsum(length) - length)
            keeps += [pattern] * len(pieces)
        start, step, kinds, way = (
            np.concatenate(starts),
            np.concatenate(steps),
            np.concatenate(roles),
            np.concatenate(ways),
        )
        count = np.ceil(np.abs(step).max(axis=1)).astype(int) + 1
        of = np.repeat(np.arange(len(count)), count)
        t = (np.arange(len(of)) - np.repeat(np.cumsum(count) - count, count)) / np.maximum(count[of] - 1, 1)
        points = start[of] + t[:, None] * step[of]
        drawn = np.ones(len(of), bool)
        for pattern in {p for p in keeps if p}:
            mine = np.array([p == pattern for p in keeps])[of]
            along = way[of[mine]] + t[mine] * np.hypot(step[:, 0], step[:, 1])[of[mine]]
            drawn[mine] = np.searchsorted(np.cumsum(pattern), along % sum(pattern), side="right") % 2 == 0
        x, y = np.floor(points).astype(int).T
        drawn &= (x >= within.left * 2) & (x < within.right * 2) & (y >= within.top * 4) & (y < within.bottom * 4)
        x, y, of = x[drawn], y[drawn], of[drawn]
        self.dots[y, x] = True
        np.maximum.at(self.roles, (y // 4, x // 2), kinds[of])
        np.add.at(self._ways, (_direction(step)[of], y // 4, x // 2), 1)

    def area(self, outlines: Sequence[Floats], value: int, within: "Frame") -> None:
        """Fill the halves of cells whose middles lie within an odd number of the outlines."""
        start = np.concatenate(outlines) / 2
        end = np.concatenate([np.roll(outline, -1, axis=0) for outline in outlines]) / 2
        middle = np.arange(self.rows * 2) + 0.5
        cut = (start[:, 1, None] <= middle) != (end[:, 1, None] <= middle)
        edge, row = np.nonzero(cut)
        (x0, y0), (x1, y1) = start[edge].T, end[edge].T
        x = x0 + (middle[row] - y0) / (y1 - y0) * (x1 - x0)
        left_of = np.zeros((self.rows * 2, self.columns + 1), np.int64)
        np.add.at(left_of, (row, np.clip(np.ceil(x - 0.5), 0, self.columns).astype(int)), 1)
        crossings = np.cumsum(left_of[:, ::-1], axis=1)[:, ::-1][:, 1:]
        inside = crossings % 2 == 1
        inside[: within.top * 2], inside[within.bottom * 2 :] = False, False
        inside[:, : within.left], inside[:, within.right :] = False, False
        self.fill[inside] = value

    def letters(self, plain: bool) -> Integers:
        """The code of each cell's letter: of braille, or plain ones; 0 where no line runs."""
        cells = self.dots.reshape(self.rows, 4, self.columns, 2)
        if not plain:
            bits = np.einsum("ryxd,yd->rx", cells.transpose(0, 1, 2, 3), BITS)
            return np.where(bits > 0, 0x2800 + bits, 0)
        order = np.sort(self._ways, axis=0)
        main = np.array([ord(letter) for letter in PLAIN])[self._ways.argmax(axis=0)]
        few = np.where(cells.any(axis=(1, 3)), ord("."), 0)
        crossing = order[-2] >= np.maximum(2, CROSSING * order[-1])
        return np.where(order[-1] > 1, np.where(crossing, ord("*"), main), few)


def _direction(step: Floats) -> Integers:
    """Of each piece of a line: level, upright, rising or falling."""
    across, down = step.T
    slope = np.abs(down) / np.maximum(np.abs(across), 1e-9)
    leaning = np.where(across * down < 0, 2, 3)
    return np.where(slope < FLAT, 0, np.where(slope > STEEP, 1, leaning))


# --- where pictures lie in a frame of character cells
# Next to each other or above, each at the largest true scale with all its words.

# columns and rows, and share of its scale, below which a picture beside another one is left out
LEAST, SMALL = ((14, 6), 0.5)
SMALLER = 0.97  # step of the scale at which the pictures are tried next to each other
GAPS = 3, 1  # columns and rows between pictures
RIGHT, CENTRE, LEFT = "left", "centre", "right"


@dataclass(frozen=True)
class Frame:
    """A part of the canvas, in cells."""

    left: int
    top: int
    columns: int
    rows: int

    @property
    def right(self) -> int:
        return self.left + self.columns

    @property
    def bottom(self) -> int:
        return self.top + self.rows

    @property
    def roomy(self) -> bool:
        return self.columns >= LEAST[0] and self.rows >= LEAST[1]


class Spread:
    """What a picture spans: its points, and how many cells its words reach around theirs."""

    def __init__(self, sketch: Sketch, say: Language) -> None:
        reaches: list[tuple[float, ...]] = [
            (*point, 0.3, 0.3, 0.15, 0.15) for mark in sketch.primitives for point in reach(mark)
        ]
        reaches += [reach for mark in sketch.primitives for reach in _word_reach(mark, say)]
        self.x, self.y, self.left, self.right, self.up, self.down = np.array(reaches or [(0.0,) * 6]).T
        self.sketch, self._title = sketch, say(sketch.title)
        # what stands apart on paper has its turn in any case
        self.wrong = not sketch.caption and any(mark.state for mark in sketch.primitives)
        self.extent = max(float(np.ptp(self.x)), float(np.ptp(self.y))) or 1.0

    def title(self, columns: int) -> list[str]:
        """Its rows in so many cells."""
        return wrap(self._title, columns) if self._title else []

    def edges(self, scale: float) -> tuple[float, float, float, float]:
        """Left, right, top and bottom in cells, at so many columns per metre."""
        across, upwards = self.x * scale, self.y * (scale / 2)
        return (
            float((across - self.left).min()),
            float((across + self.right).max()),
            float((upwards + self.up).max()),
            float((upwards - self.down).min()),
        )

    def size(self, scale: float, columns: int) -> tuple[float, float]:
        """Columns and rows, where there are so many cells for the title."""
        left, right, top, bottom = self.edges(scale)
        title = self.title(columns)
        return max(right - left, *map(cell_len, title), 0), top - bottom + len(title)

    def largest(self, columns: int, rows: int) -> float:
        """The largest scale that fits into so many cells."""
        scale = (columns + 2 * rows) / self.extent
        scale = _shrunk(self.x, self.left, self.right, columns, scale)
        return 2 * _shrunk(self.y, self.down, self.up, rows - len(self.title(columns)), scale / 2)


def _shrunk(at: Floats, before: Floats, behind: Floats, room: float, scale: float) -> float:
    """The largest scale, up to the given one, at which all that is around these places fits into the room.

    What the places span grows along straight lines that get steeper: following the steepest back never goes too far.
    """
    for _ in range(len(at)):
        last, first = int((at * scale + behind).argmax()), int((at * scale - before).argmin())
        reach = float(at[last] - at[first])
        over = reach * scale + float(behind[last] + before[first]) - room
        if over <= 1e-9 or reach <= 0:
            return scale
        scale = max(0.0, scale - over / reach)
    return scale


def arranged(pictures: list[Spread], columns: int, rows: int) -> list[tuple[Spread, Frame]]:
    """The pictures side by side or one above the other, whichever draws them larger; as many as are still large
    enough: the first, and those that show what is wrong before others."""
    while len(pictures) > 1:
        ways = [
            way for way in (_shared(pictures, columns, rows, 0), _shared(pictures, columns, rows, 1)) if way is not None
        ]
        if ways:
            return max(ways, key=lambda way: way[0])[1]
        sound = (n for n in range(len(pictures) - 1, 0, -1) if not pictures[n].wrong)
        left_out = next(sound, len(pictures) - 1)
        pictures = pictures[:left_out] + pictures[left_out + 1 :]
    return [(pictures[0], Frame(0, 0, columns, rows))]


def _shared(
    pictures: list[Spread], columns: int, rows: int, way: int
) -> tuple[float, list[tuple[Spread, Frame]]] | None:
    """The frames side by side (`way` 0) or one above the other, and the share of the scale that each has of what it
    would have alone; None where they get too small."""
    gap = GAPS[way] * (len(pictures) - 1)
    room = (columns, rows)[way] - gap
    if room <= 0:
        return None
    alone = [picture.largest(columns, rows) for picture in pictures]
    share, sizes = 1.0, [room + 1]
    while sum(sizes) > room and share >= SMALL:
        sizes = [math.ceil(picture.size(share * scale, columns)[way]) for picture, scale in zip(pictures, alone)]
        share *= SMALLER
    share /= SMALLER
    spare, at, frames = room - sum(sizes), 0, []
    for n, (picture, size) in enumerate(zip(pictures, sizes)):
        size += spare * (n + 1) // len(sizes) - spare * n // len(sizes)
        frames.append((picture, Frame(at, 0, size, rows) if way == 0 else Frame(0, at, columns, size)))
        at += size + GAPS[way]
    return (share, frames) if sum(sizes) <= room and all(frame.roomy for _, frame in frames) else None


class Fit:
    """Where metres lie in a frame of cells: in its middle, at the largest true scale at which the picture and its words
    are within."""

    def __init__(self, picture: Spread, frame: Frame) -> None:
        self.scale = picture.largest(frame.columns, frame.rows)  # columns per metre
        left, right, top, bottom = picture.edges(self.scale)
        self.x = frame.left + (frame.columns - (right - left)) / 2 - left
        title = picture.title(frame.columns)
        above = max(0, math.floor((frame.rows - (top - bottom) - len(title)) / 2))
        self.title = frame.top + above  # its first row
        first = self.title + len(title)
        self.y = first + top
        self.inside = Frame(frame.left, first, frame.columns, max(0, frame.bottom - first))  # what is below the title

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
            wide = cell_len(words_of(mark, say))
            left: float = {RIGHT: 0.0, CENTRE: wide / 2, LEFT: wide}[side]
            yield *at, left, wide - left, 0.5, 0.5
        case Dimension(start=start, end=end, line=(x, y), upright=upright):
            room = cell_len(words_of(mark, say)) + 2
            if upright:
                left, right = (1.0, room) if x >= start[0] else (room, 1.0)
                yield x, (start[1] + end[1]) / 2, left, right, 0.5, 0.5
            else:
                yield (start[0] + end[0]) / 2, y, room / 2, room / 2, 0.5, 0.5


def words_of(mark: Words | Dimension, say: Language) -> str:
    """What a word or a dimension says."""
    if isinstance(mark, Words):
        return say(mark.text)
    if mark.label:
        return say(mark.label)
    length = mark.end[1] - mark.start[1] if mark.upright else mark.end[0] - mark.start[0]
    return ("Ø " if mark.diameter else "") + say.part(Amount(abs(length) * 1000, "mm"))


# --- the canvas

FAINT, NORMAL, WARN, FAIL, LIT = range(1, 6)  # roles: a higher one is drawn over a lower one
STYLES = {FAINT: "muted", WARN: "warn", FAIL: "fail", LIT: "lit"}
STATES = {"": NORMAL, "warn": WARN, "fail": FAIL}
PATTERNS: dict[str, tuple[float, ...]] = {AXIS: (8, 3, 1, 3), HIDDEN: (3, 3)}
WITNESS = (1.0, 2.0)  # pattern of the lines from a part to its dimension
HEAD, HEAD_ANGLE = 5.0, math.radians(25)  # dots; of an arrow
PAPER = {True: 0x1A, False: 0xE8}  # grey of the background, dark or light, that the fill of areas is mixed with
INK = {FAINT: 0x80, NORMAL: 0xB0}
SHIFTS = sorted(
    ((row, column) for row in range(-2, 3) for column in range(-6, 7)),
    key=lambda shift: (2 * abs(shift[0]) + abs(shift[1]), shift),
)  # how a word may be moved, in rows and columns
# what each cell of a line under a word, and a word right beside it, is worth in `SHIFTS`
ON_A_LINE, BESIDE_A_WORD = (1.0, 2.0)


def draw(
    sketch: Sketch, columns: int, rows: int, signs: Signs, say: Language, lit: str = "", more: Text = EMPTY
) -> Content:
    """The sketch in so many cells; nothing where there is no room for it.  `more`: how pictures that have no room are
    brought to the front."""
    if columns < 4 or rows < 2:
        return Content("")
    canvas = Canvas(columns, rows, signs, say, lit)
    panels = [Spread(panel, say) for panel in (sketch, *sketch.beside)]
    shown = [picture for picture, _ in arranged(panels, columns, rows - len(_below(panels, columns, rows, say)))]
    below = _below(shown, columns, rows, say, more if sketch.views > 1 and len(shown) < len(panels) else EMPTY)
    for picture, frame in arranged(shown, columns, rows - len(below)):
        canvas.picture(picture, frame)
    for row, note in enumerate(below, rows - len(below)):
        canvas.put(row, max(0, (columns - cell_len(note)) // 2), note, FAINT)
    return canvas.content()


def _below(pictures: list[Spread], columns: int, rows: int, say: Language, more: Text = EMPTY) -> list[str]:
    """The rows of the notes of pictures; none where there is no room."""
    texts = [*(note for picture in pictures for note in picture.sketch.notes), more]
    notes = noted(list(dict.fromkeys(say(text) for text in texts if text)), columns)
    return notes if rows > 4 + len(notes) else []


def noted(notes: list[str], columns: int) -> list[str]:
    """The notes in rows, as many in one as there is room for."""
    rows: list[str] = []
    for note in notes:
        if rows and cell_len(joined := f"{rows[-1]} · {note}") <= columns:
            rows[-1] = joined
        else:
            rows += wrap(note, columns)
    return rows


def covers(key: str, lit: str) -> bool:
    """Whether a key is that of an input, or of a table that has it; * stands for any element."""
    parts, inner = key.split("."), lit.split(".")
    return len(parts) <= len(inner) and all(a in (b, "*") for a, b in zip(parts, inner))


class Canvas:
    """The cells of a picture: `fill` below lines below `text`."""

    def __init__(self, columns: int, rows: int, signs: Signs, say: Language, lit: str) -> None:
        self.columns, self.rows, self.signs, self.say, self.lit = columns, rows, signs, say, lit
        self.raster = Raster(columns, rows)
        self.inside = Frame(0, 0, columns, rows)  # where is drawn and written
        self.text = np.zeros((rows, columns), np.int64)  # code of a letter; 0: none; -1: the second half of a wide one
        self.text_roles = np.zeros((rows, columns), np.int64)
        self.fills: list[tuple[int, float]] = []  # role and shade of each value of `raster.fill`

    def role(self, mark: Mark) -> int:
        if self.lit and any(covers(key, self.lit) for key in mark.key.split()):
            return LIT
        return STATES[mark.state] if mark.state else FAINT if mark.layer in (CONTEXT, AXIS, HIDDEN) else NORMAL

    # --- pictures
    def picture(self, picture: Spread, frame: Frame) -> None:
        """Draw one picture into its frame."""
        sketch, fit = picture.sketch, Fit(picture, frame)
        self.inside = frame
        for row, title in enumerate(picture.title(frame.columns), fit.title):
            self.put(row, frame.left + max(0, (frame.columns - cell_len(title)) // 2), title, FAINT)
        self.inside = frame = fit.inside
        paths: list[tuple[Floats, int, tuple[float, ...]]] = []
        for mark in sketch.primitives:
            paths += self._paths(mark, fit)
        self.raster.lines(paths, frame)
        dimensions = [mark for mark in sketch.primitives if isinstance(mark, Dimension)]
        for dimension in dimensions:
            self._dimension_line(dimension, fit)
        for mark in sorted(sketch.primitives, key=lambda mark: -self.role(mark)):
            if isinstance(mark, Words):
                row, column = fit.cell(mark.at)
                text = words_of(mark, self.say) + (f" {self.signs.mark(mark.state)}" if mark.state else "")
                wide = cell_len(text)
                start = {
                    RIGHT: column,
                    CENTRE: round(fit.x + mark.at[0] * fit.scale - wide / 2),
                    LEFT: column - wide + 1,
                }[mark.side]
                self._place(text, row, start, self.role(mark), frame)
        for dimension in dimensions:
            self._number(dimension, fit, frame)
        self._mark_states(sketch, fit, frame)
        self.inside = Frame(0, 0, self.columns, self.rows)

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
                self.raster.area([fit.dots(outline) for outline in outlines], len(self.fills), self.inside)
            case Dimension(start=start, end=end, line=(x, y), upright=upright):
                for from_x, from_y in (start, end):
                    yield fit.dots([(from_x, from_y), (x, from_y) if upright else (from_x, y)]), FAINT, WITNESS
            case Words():
                pass

    def _mark_states(self, sketch: Sketch, fit: Fit, frame: Frame) -> None:
        """The sign of each part that fails, or of which is warned, at its upper right: one for all marks of one field
        or part.

        Words have theirs behind them.
        """
        ends: dict[tuple[str, str], Point] = {}
        worded = {
            (mark.state, key)
            for mark in sketch.primitives
            if isinstance(mark, Words)
            for key in mark.key.split() or [""]
        }
        for mark in sketch.primitives:
            if mark.state and all((mark.state, key) not in worded for key in mark.key.split() or [""]):
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
        (r0, c0), (r1, c1) = (
            fit.cell((mark.line[0], p[1]) if mark.upright else (p[0], mark.line[1])) for p in (mark.start, mark.end)
        )
        if mark.upright:
            top, bottom = sorted((r0, r1))
            alone, inner, first, last = ("|", "|", "+", "+") if ascii else ("↕", "│", "┬", "┴")
            letters = [alone] if top == bottom else [first, *[inner] * (bottom - top - 1), last]
            for row, letter in enumerate(letters, top):
                self.put(row, c0, letter, role, free=True)
        else:
            left, right = sorted((c0, c1))
            inner = ("-" if ascii else "─") * (right - left - 1)
            line = ("|" if ascii else "↔") if left == right else f"|{inner}|" if ascii else f"├{inner}┤"
            self.put(r0, left, line, role, free=True)

    def _number(self, mark: Dimension, fit: Fit, frame: Frame) -> None:
        """In a level line, or right of it where it is too short; beside an upright one."""
        text, role = words_of(mark, self.say), self.role(mark)
        wide = cell_len(text)
        (r0, c0), (r1, c1) = (
            fit.cell((mark.line[0], p[1]) if mark.upright else (p[0], mark.line[1])) for p in (mark.start, mark.end)
        )
        if mark.upright:
            self._place(text, (r0 + r1) // 2, c0 + 2 if mark.line[0] >= mark.start[0] else c0 - 1 - wide, role, frame)
        elif abs(c1 - c0) >= wide + 3:
            self.put(r0, (c0 + c1 + 1 - wide) // 2 - 1, f" {text} ", role)
        else:
            self._place(text, r0, max(c0, c1) + 2, role, frame)

    # --- words
    def put(self, row: int, column: int, text: str, role: int, free: bool = False) -> None:
        """Write over lines, and over words too, or (`free`) only where none stand; nothing outside of the picture's
        frame."""
        inside = self.inside
        for letter in text:
            wide = cell_len(letter)
            if (
                inside.top <= row < inside.bottom
                and inside.left <= column
                and column + wide <= inside.right
                and wide
                and not (free and self.text[row, column])
            ):
                self.text[row, column : column + wide] = [ord(letter), -1][:wide]
                self.text_roles[row, column] = role
            column += wide

    def _place(self, text: str, row: int, column: int, role: int, frame: Frame) -> None:
        """Write near a place where no other word stands, clear of lines if possible; not at all where there is no
        room."""
        top, bottom, left, right = frame.top, frame.bottom, frame.left, frame.right
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
                    spans.append(
                        Span(start, end, self._style(number // count**2, number // count % count, number % count))
                    )
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
        ink = (
            [int(colour[n : n + 2], 16) for n in (0, 2, 4)]
            if len(colour) == 6
            else [grey if self.signs.dark else 0xFF - grey] * 3
        )
        return "#" + "".join(f"{round(paper + (channel - paper) * shade):02x}" for channel in ink)


def _head(dots: Floats) -> Floats:
    """The two strokes of an arrow's head."""
    tip = dots[-1]
    back = next((tip - dot for dot in dots[-2::-1] if np.hypot(*(tip - dot)) > 1), None)
    if back is None:
        return dots[-1:]
    way = math.atan2(-back[1], -back[0])
    length = min(HEAD, float(np.hypot(*back)))
    barbs = [
        tip + length * np.array([math.cos(way + turn), math.sin(way + turn)]) for turn in (HEAD_ANGLE, -HEAD_ANGLE)
    ]
    return np.array([barbs[0], tip, barbs[1]])


def _style(signs: Signs, role: int) -> str:
    """The style of lines and words of a role."""
    return signs.style(STYLES[role]) if role in STYLES else "not dim" if role else ""
