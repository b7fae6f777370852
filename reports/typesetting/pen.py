# SPDX-License-Identifier: Apache-2.0
"""The pen collects what one page holds and writes it; what is drawn once is recorded and placed on any page.

Rules and lines come first, then figures, then all text in reading order."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import groupby
from operator import itemgetter

from reportlab.pdfbase import pdfmetrics
from reportlab.pdfgen.canvas import Canvas

from .boxes import BLACK, EDGE, Box, Colour, Mark
from .fonts import LEFT, face_of
from .tags import DRAWN, Element, Link, SignatureField, Tag, Tree, hexed

Encoded = tuple[str, str]  # a part of an embedded font by its name on the page, and codes in it
Codes = tuple[dict[str, list[Encoded]], dict[str, Encoded]]  # texts and single letters, as a font encodes them


class Pen:
    """Collects what one page holds.  x = 0 is the left margin, y is the height on the page."""

    def __init__(
        self,
        canvas: Canvas,
        numbers: Mapping[str, int],
        codes: dict[str, Codes],
        places: Mapping[str, list[int]] | None = None,
        tree: Tree | None = None,
    ) -> None:
        self.canvas = canvas
        self.tree = tree or Tree(1)
        self.tree.pages.append([])
        self.element: Element | None = None  # whose content is drawn; None: what repeats or adorns
        self.places = places or {}  # name in the index → its pages
        self.codes = codes  # by typeface
        self.numbers = numbers  # anchor → page number
        self.text: list[tuple[float, float, Mark, Element | None]] = []
        self.figures: list[tuple[Callable[[], None], Element | None]] = []
        self.code: list[tuple[str, Element | None]] = []
        self.colour: Colour | None = None

    @contextmanager
    def tagged(self, tag: Tag | None) -> Iterator[None]:
        """What is drawn meanwhile is the content of this tag's element; None: of none."""
        before, self.element = self.element, self.tree.element(tag) if tag is not None else None
        try:
            yield
        finally:
            self.element = before

    @contextmanager
    def cell(self, attributes: str = "") -> Iterator[None]:
        """What is drawn meanwhile is a further cell of the row that is drawn, a head where it has attributes."""
        before = self.element
        if before is not None and before.role == "TR":
            self.element = Element("TH" if attributes else "TD", before, attributes=attributes)
        try:
            yield
        finally:
            self.element = before

    def put(self, box: Box, x: float, y: float) -> None:
        """Place a box with its base line at this height."""
        x += LEFT
        for mark in box.marks:
            match mark[0]:
                case "text":
                    self.text.append((x + mark[1], y + mark[2], mark, self.element))
                case "rule":
                    self._fill(x + mark[1], y + mark[2], mark[3], mark[4], mark[5])
                case "path":
                    self.line([(x + px, y + py) for px, py in mark[1]], mark[2], mark[3])
                case "link":
                    self.link(x - LEFT + mark[1], y + mark[2], mark[3], mark[4], mark[5], mark[6])
                case _:
                    self.text.append((x + mark[1], y + mark[2], mark, self.element))

    def turn(self, box: Box, x: float, y: float) -> None:
        """Place the text of a box turned a quarter to the left, reading upwards from here."""
        for mark in box.marks:
            if mark[0] == "text":
                self.text.append((LEFT + x - mark[2], y + mark[1], ("turned", *mark[1:]), self.element))

    def rule(self, x: float, y: float, width: float, thick: float, colour: Colour = BLACK) -> None:
        """A horizontal rule whose upper edge lies at y."""
        self._fill(LEFT + x, y - thick, width, thick, colour)

    def panel(self, x: float, y: float, width: float, height: float, colour: Colour) -> None:
        """A filled rectangle; y is its lower edge."""
        self._fill(LEFT + x, y, width, height, colour)

    def link(self, x: float, y: float, width: float, height: float, anchor: str, words: str) -> None:
        """Over the text that was put there last: it becomes the content of the link."""
        left, canvas, owner = LEFT + x, self.canvas, self.element
        parent = None
        if owner is not None:
            link = Element("Link", owner)
            for n in range(len(self.text) - 1, -1, -1):  # back to where its owner begins
                at, base, mark, whose = self.text[n]
                if whose is None or owner not in (whose, whose.parent):
                    break
                if left - 0.5 <= at < left + width and y <= base < y + height:
                    self.text[n] = at, base, mark, link
            parent = self.tree.link(link, f"NUMBER{canvas._annotationCount + 1}")
        canvas._addAnnotation(
            Link((left, y, left + width, y + height), words, canvas._bookmarkReference(anchor), parent)
        )

    def signature(self, x: float, y: float, width: float, height: float, name: str, words: str) -> None:
        """A field to sign in; y is its lower edge."""
        left, canvas = LEFT + x, self.canvas
        annotation = f"NUMBER{canvas._annotationCount + 1}"
        parent = self.tree.link(Element("Form", self.element), annotation) if self.element is not None else None
        self.tree.fields.append(annotation)
        corners = left, y, left + width, y + height
        canvas._addAnnotation(SignatureField(corners, name, words, len(self.tree.pages), parent))

    def figure(self, draw: Callable[[], None]) -> None:
        self.figures.append((draw, self.element))

    def _fill(self, x: float, y: float, width: float, height: float, colour: Colour) -> None:
        corner, size = f"{x + EDGE:.2f} {y + EDGE:.2f}", f"{width + EDGE:.2f} {height + EDGE:.2f}"
        self._draw(f"{_rgb(colour)} rg {corner} {size} re f")

    def _draw(self, code: str) -> None:
        """Lines and areas are content in what is drawn; elsewhere they adorn."""
        self.code.append((code, self.element if self.element is not None and self.element.role in DRAWN else None))

    def line(
        self, points: list[tuple[float, float]], thick: float, colour: Colour, dashes: tuple[float, ...] = ()
    ) -> None:
        """An open line through points of the page."""
        drawn = f"{_rgb(colour)} RG {thick:.2f} w {_path(points)} S"
        self._draw(f"[{' '.join(f'{d:g}' for d in dashes)}] 0 d {drawn} [] 0 d" if dashes else drawn)

    def area(self, points: list[tuple[float, float]], colour: Colour) -> None:
        """A filled polygon with its corners at points of the page."""
        self._draw(f"{_rgb(colour)} rg {_path(points)} f")

    def shape(self, outlines: list[list[tuple[float, float]]], colour: Colour) -> None:
        """What is filled within closed outlines; what lies in two of them stays empty."""
        self._draw(f"{_rgb(colour)} rg {' '.join(map(_path, outlines))} f*")

    def write(self) -> None:
        """Put everything on the canvas."""
        code = self.canvas._code
        if self.code:
            code.append("q 1 j 1 J")
            for element, some in groupby(self.code, itemgetter(1)):
                code += [self._begin(element), *(operator for operator, _ in some), "EMC"]
            code.append("Q")
        for draw, element in self.figures:
            self.element = element
            code.append(self._begin(element))
            draw()
            code.append("EMC")
        code.append("\n".join(self._text()))

    def _begin(self, element: Element | None) -> str:
        """The operator that begins marked content."""
        return "/Artifact BMC" if element is None else f"/{element.role} <</MCID {self.tree.mark(element)}>> BDC"

    def _text(self) -> list[str]:
        """The operators of all text; one text object, so that marked passages may span lines."""
        operators = ["BT"]
        font: tuple[str, float] | None = None
        colour: Colour | None = None
        hidden = False
        marked: Element | bool | None = False  # False: before the first
        for n, (x, y, mark, element) in enumerate(self.text):
            if element is not marked:
                operators += ["EMC"] * (marked is not False) + [self._begin(element)]
                marked = element
            if mark[0] in ("begin", "end"):
                operators.append("EMC" if mark[0] == "end" else f"/Span <</ActualText <{hexed(mark[3])}>>> BDC")
                continue
            _, _, _, words, face, size, paint, stretch, unseen = mark
            if paint != colour:
                operators.append(f"{_rgb(paint)} rg")
                colour = paint
            if unseen != hidden:
                operators.append(f"{3 if unseen else 0} Tr")
                hidden = unseen
            turned = "0 1 -1 0" if mark[0] == "turned" else "1 0 0 1" if stretch == 1.0 else f"1 0 0 {stretch:.3f}"
            operators.append(f"{turned} {x + EDGE:.2f} {y + EDGE:.2f} Tm")
            blank = (
                self._encoded(face, " ")
                if n + 1 < len(self.text) and self._breaks(x, y, element, *self.text[n + 1])
                else []
            )
            for name, string in [*self._encoded(face, words), *blank]:
                if (name, size) != font:
                    operators.append(f"{name} {size:.3f} Tf")
                    font = (name, size)
                operators.append(f"<{string}> Tj")
        return [*operators, *["EMC"] * (marked is not False), "ET"]

    @staticmethod
    def _breaks(
        x: float, y: float, element: Element | None, then_x: float, then_y: float, mark: Mark, then: Element | None
    ) -> bool:
        """Whether the next piece begins another line of the same element: two words, which a blank parts for whoever
        reads the codes."""
        return element is not None and then is element and mark[0] == "text" and then_x <= x and then_y < y - 1.0

    def _encoded(self, face: str, words: str) -> list[Encoded]:
        """A text in the embedded parts of its font."""
        strings, letters = self.codes.setdefault(face, ({}, {}))
        if (known := strings.get(words)) is None:
            for c in words:
                if c not in letters:
                    font, document = pdfmetrics.getFont(face_of(c, face)), self.canvas._doc
                    ((part, code),) = font.splitString(c, document)
                    letters[c] = font.getSubsetInternalName(part, document), code.hex()
            runs = groupby([letters[c] for c in words], itemgetter(0))
            known = strings[words] = [(name, "".join([code for _, code in run])) for name, run in runs]
        return known


def _path(points: list[tuple[float, float]]) -> str:
    (x, y), *rest = points
    lines = " ".join(f"{a + EDGE:.2f} {b + EDGE:.2f} l" for a, b in rest)
    return f"{x + EDGE:.2f} {y + EDGE:.2f} m {lines}"


def _rgb(colour: Colour) -> str:
    return " ".join(f"{c:.3f}" for c in colour)


# --- what is drawn in a frame of its own and placed on a page afterwards
# A figure is the same wherever it stands, so it can be drawn before there are pages.


@dataclass(frozen=True, slots=True)
class Recording:
    """`code`: lines and areas as operators of PDF, from the lower left corner of the frame; `words`: boxes with their
    places from there, and whether they are turned."""

    code: str
    words: tuple[tuple[Box, float, float, bool], ...]

    def place(self, pen: Pen, x: float, y: float) -> None:
        """Put it on a page with its corner there; x from the left margin."""
        corner = f"{LEFT + x + EDGE:.2f} {y + EDGE:.2f}"
        pen.figure(lambda: pen.canvas._code.append(f"q 1 0 0 1 {corner} cm\n{self.code}\nQ"))
        for box, a, b, turned in self.words:
            (pen.turn if turned else pen.put)(box, x + a, y + b)


class Recorder:
    """Takes down what is drawn into a frame, as a pen does for a page."""

    def __init__(self) -> None:
        self.code: list[str] = []
        self.words: list[tuple[Box, float, float, bool]] = []

    def put(self, box: Box, x: float, y: float) -> None:
        """Place a box with its base line at this height."""
        self.words.append((box, float(x), float(y), False))

    def turn(self, box: Box, x: float, y: float) -> None:
        """Place a box turned a quarter to the left, reading upwards from here."""
        self.words.append((box, float(x), float(y), True))

    @property
    def recording(self) -> Recording:
        return Recording("\n".join(self.code), tuple(self.words))
