# SPDX-License-Identifier: Apache-2.0
"""The pen collects what one page holds and writes it: rules and lines first, then figures, then all text in reading order."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import groupby
from operator import itemgetter

from reportlab.pdfbase import pdfmetrics
from reportlab.pdfgen.canvas import Canvas

from .boxes import BLACK, Box, Colour, Mark
from .paper import LEFT

Encoded = tuple[str, str]  # a part of an embedded font by its name on the page, and codes in it
Codes = tuple[dict[str, list[Encoded]], dict[str, Encoded]]  # texts and single letters, as a font encodes them


class Pen:
    """Collects what one page holds.  x = 0 is the left margin, y is the height on the page."""

    def __init__(
        self, canvas: Canvas, numbers: Mapping[str, int], codes: dict[str, Codes],
        places: Mapping[str, list[int]] | None = None,
    ) -> None:  # fmt: skip
        self.canvas = canvas
        self.places = places or {}  # name in the index → its pages
        self.codes = codes  # by typeface
        self.numbers = numbers  # anchor → page number
        self.text: list[tuple[float, float, Mark]] = []
        self.figures: list[Callable[[], None]] = []
        self.code: list[str] = []
        self.colour: Colour | None = None

    def put(self, box: Box, x: float, y: float) -> None:
        """Place a box with its base line at this height."""
        x += LEFT
        for mark in box.marks:
            match mark[0]:
                case "text":
                    self.text.append((x + mark[1], y + mark[2], mark))
                case "rule":
                    self._fill(x + mark[1], y + mark[2], mark[3], mark[4], mark[5])
                case "path":
                    self.line([(x + px, y + py) for px, py in mark[1]], mark[2], mark[3])
                case "link":
                    self.link(x - LEFT + mark[1], y + mark[2], mark[3], mark[4], mark[5], mark[6])
                case _:
                    self.text.append((x + mark[1], y + mark[2], mark))

    def turn(self, box: Box, x: float, y: float) -> None:
        """Place the text of a box turned a quarter to the left, reading upwards from here."""
        for mark in box.marks:
            if mark[0] == "text":
                self.text.append((LEFT + x - mark[2], y + mark[1], ("turned", *mark[1:])))

    def rule(self, x: float, y: float, width: float, thick: float, colour: Colour = BLACK) -> None:
        """A horizontal rule whose upper edge lies at y."""
        self._fill(LEFT + x, y - thick, width, thick, colour)

    def panel(self, x: float, y: float, width: float, height: float, colour: Colour) -> None:
        """A filled rectangle; y is its lower edge."""
        self._fill(LEFT + x, y, width, height, colour)

    def link(self, x: float, y: float, width: float, height: float, anchor: str, words: str) -> None:
        left = LEFT + x
        self.canvas.linkRect(words, anchor, (round(left, 2), round(y, 2), round(left + width, 2), round(y + height, 2)), relative=0)

    def figure(self, draw: Callable[[], None]) -> None:
        self.figures.append(draw)

    def _fill(self, x: float, y: float, width: float, height: float, colour: Colour) -> None:
        self.code.append(f"{_rgb(colour)} rg {x:.2f} {y:.2f} {width:.2f} {height:.2f} re f")

    def line(self, points: list[tuple[float, float]], thick: float, colour: Colour, dashes: tuple[float, ...] = ()) -> None:
        """An open line through points of the page."""
        drawn = f"{_rgb(colour)} RG {thick:.2f} w {_path(points)} S"
        self.code.append(f"[{' '.join(f'{d:g}' for d in dashes)}] 0 d {drawn} [] 0 d" if dashes else drawn)

    def area(self, points: list[tuple[float, float]], colour: Colour) -> None:
        """A filled polygon with its corners at points of the page."""
        self.code.append(f"{_rgb(colour)} rg {_path(points)} f")

    def shape(self, outlines: list[list[tuple[float, float]]], colour: Colour) -> None:
        """What is filled within closed outlines; what lies in two of them stays empty."""
        self.code.append(f"{_rgb(colour)} rg {' '.join(map(_path, outlines))} f*")

    def write(self) -> None:
        """Put everything on the canvas."""
        if self.code:
            self.canvas._code.append("q 1 j 1 J\n" + "\n".join(self.code) + "\nQ")
        for draw in self.figures:
            draw()
        self.canvas._code.append("\n".join(self._text()))

    def _text(self) -> list[str]:
        """The operators of all text; one text object, so that marked passages may span lines."""
        made = ["BT"]
        font: tuple[str, float] | None = None
        colour: Colour | None = None
        hidden = False
        for x, y, mark in self.text:
            if mark[0] in ("begin", "end"):
                made.append("EMC" if mark[0] == "end" else f"/Span <</ActualText <{_utf16(mark[3])}>>> BDC")
                continue
            _, _, _, words, face, size, paint, stretch, unseen = mark
            if paint != colour:
                made.append(f"{_rgb(paint)} rg")
                colour = paint
            if unseen != hidden:
                made.append(f"{3 if unseen else 0} Tr")
                hidden = unseen
            turned = "0 1 -1 0" if mark[0] == "turned" else "1 0 0 1" if stretch == 1.0 else f"1 0 0 {stretch:.3f}"
            made.append(f"{turned} {x:.2f} {y:.2f} Tm")
            for name, string in self._encoded(face, words):
                if (name, size) != font:
                    made.append(f"{name} {size:.3f} Tf")
                    font = (name, size)
                made.append(f"<{string}> Tj")
        return [*made, "ET"]

    def _encoded(self, face: str, words: str) -> list[Encoded]:
        """A text in the embedded parts of its font."""
        strings, letters = self.codes.setdefault(face, ({}, {}))
        if (known := strings.get(words)) is None:
            for c in words:
                if c not in letters:
                    font, document = pdfmetrics.getFont(face), self.canvas._doc
                    ((part, code),) = font.splitString(c, document)
                    letters[c] = font.getSubsetInternalName(part, document), code.hex()
            runs = groupby([letters[c] for c in words], itemgetter(0))
            known = strings[words] = [(name, "".join([code for _, code in run])) for name, run in runs]
        return known


def _path(points: list[tuple[float, float]]) -> str:
    (x, y), *rest = points
    return f"{x:.2f} {y:.2f} m " + " ".join(f"{a:.2f} {b:.2f} l" for a, b in rest)


def _rgb(colour: Colour) -> str:
    return " ".join(f"{c:.3f}" for c in colour)


def _utf16(words: str) -> str:
    return ("\ufeff" + words).encode("utf-16-be").hex().upper()
