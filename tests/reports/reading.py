# SPDX-License-Identifier: Apache-2.0
"""What is read back from a report."""

import io
import re
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

from pypdf import PdfReader

from calc.design.toml_file import Document, design, parse
from calc.solve import Results, solve
from reports.report import render
from tests.conftest import RUN_FILES

ROOT = Path(__file__).parents[2]
EXAMPLE = ROOT / "designs" / "r753ie4_gamma.toml"
V12 = """
schema = 1
name = "V12 at 60°, zwölf Zylinder"
[engine]
name = "V12"
layout = "vee"
cylinders = 12
strokes = 4
bank_angle_deg = 60
bore_mm = 86
crank_radius_mm = 43
rod_length_mm = 145
cylinder_pitch_mm = 95
crank_angles_deg = [0, 120, 240, 240, 120, 0, 0, 120, 240, 240, 120, 0]
axial_positions_mm = [-250, -150, -50, 50, 150, 250, -240, -140, -40, 60, 160, 260]
bank_of_cylinder = [0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1]
piston_mass_g = 500
rod_mass_g = 600
rated_speed_rpm = 6000
[imbalance]
crank_balance_fraction = 0.2
"""


@dataclass(frozen=True)
class Solved:
    raw: bytes
    document: Document
    results: Results

    def report(self, depth: str = "engineer", lang: str = "en") -> bytes:
        return render(self.document, self.results, self.raw, depth=depth, lang=lang)


def solved(text: str | bytes) -> Solved:
    raw = text.encode() if isinstance(text, str) else text
    document = parse(raw, "design.toml", RUN_FILES)
    return Solved(raw, document, solve(design(document)))


@dataclass(frozen=True)
class Span:
    """One piece of text on a page: what it says, where it begins and ends, its size, whether it is upright and can be
    seen."""

    page: int
    text: str
    x: float
    y: float
    end: float
    size: float
    upright: bool
    hidden: bool


CODE = re.compile(rb"^<([0-9A-F]{2})> <([0-9A-F]{4,})>$", re.M)
TOKEN = re.compile(
    rb"(?P<matrix>(?:-?[\d.]+ ){6})Tm|/(?P<font>F\S+) (?P<size>[\d.]+) Tf|(?P<mode>\d) Tr|<(?P<codes>[0-9a-f]*)> Tj",
    re.S,
)


@cache
def spans(pdf: bytes) -> list[Span]:
    """Every piece of text of a report with its place, from the operators of its pages and what its fonts say of each
    code."""
    found = []
    known: dict[int, tuple[list[float], dict[int, str]]] = {}
    for number, page in enumerate(PdfReader(io.BytesIO(pdf)).pages):
        fonts = {}
        for name, reference in page["/Resources"]["/Font"].items():
            if reference.idnum not in known:
                font = reference.get_object()
                wide = [0.0] * int(font.get("/FirstChar", 0)) + [float(w) for w in font.get("/Widths", [])]
                letters = CODE.findall(font["/ToUnicode"].get_object().get_data()) if "/ToUnicode" in font else []
                known[reference.idnum] = (
                    wide,
                    {int(code, 16): bytes.fromhex(u.decode()).decode("utf-16-be") for code, u in letters},
                )
            fonts[name[1:]] = known[reference.idnum]
        matrix, x, size, hidden = (1.0, 0.0, 0.0, 1.0, 0.0, 0.0), 0.0, 0.0, False
        for token in TOKEN.finditer(page.get_contents().get_data()):
            if token["matrix"]:
                matrix = tuple(map(float, token["matrix"].split()))
                x = matrix[4]
            elif token["font"]:
                (widths, letters), size = fonts[token["font"].decode()], float(token["size"])
            elif token["mode"]:
                hidden = token["mode"] == b"3"
            else:
                codes = bytes.fromhex(token["codes"].decode())
                wide = sum(widths[c] for c in codes) * size / 1000
                # a blank at a line's end parts words, and is not seen
                if (words := "".join(letters[c] for c in codes)).strip():
                    found.append(Span(number, words, x, matrix[5], x + wide, size, abs(matrix[1]) < 1e-6, hidden))
                x += wide
    assert found
    return found


def squeezed(text: str) -> str:
    """Text without what line breaks and indices change."""
    return re.sub(r"[\s_⁺⁻+−-]", "", text)


@cache
def pages_of(pdf: bytes) -> tuple[str, ...]:
    """The text of each page, line by line, as a reader copies it: pypdf finds the same (test_report) and takes fifteen
    times as long."""
    pages = [""] * len(PdfReader(io.BytesIO(pdf)).pages)
    before = None
    for span in spans(pdf):
        if before is not None and before.page == span.page:
            same_line = abs(span.y - before.y) < 0.5 * max(span.size, before.size) and span.x > before.x
            pages[span.page] += (" " if span.x - before.end > 0.15 * span.size else "") if same_line else "\n"
        pages[span.page] += span.text
        before = span
    return tuple(pages)


def text_of(pdf: bytes) -> str:
    return "\n".join(pages_of(pdf))


def spoken(pdf: bytes) -> str:
    """What is said of each formula to who copies it."""
    said = []
    for page in PdfReader(io.BytesIO(pdf)).pages:
        for code in re.findall(rb"/ActualText\s*<FEFF([0-9A-F]*)>", page.get_contents().get_data()):
            said.append(bytes.fromhex(code.decode()).decode("utf-16-be"))
    return "\n".join(said)


@dataclass(frozen=True)
class Shape:
    """One painted path of a page: its parts, each a list of corners; the colours it is filled and drawn with (empty:
    not)."""

    page: int
    parts: list[list[tuple[float, float]]]
    fill: str
    stroke: str


SHAPE = re.compile(
    rb"(?P<colour>(?:[\d.]+ ){3})(?P<kind>rg|RG)|(?P<x>-?[\d.]+) (?P<y>-?[\d.]+) (?P<to>[ml])\b|\b(?P<paint>[BSf])(?=\s)"
    rb"|1 0 0 1 (?P<frame>-?[\d.]+ -?[\d.]+) cm|(?P<end>EMC)"
)


def shapes(pdf: bytes) -> list[Shape]:
    """The polygons and lines of a report, in the order in which they are painted."""
    found = []
    for number, page in enumerate(PdfReader(io.BytesIO(pdf)).pages):
        drawn, _, _ = page.get_contents().get_data().partition(b"BT")
        colours = {"rg": "", "RG": ""}
        parts: list[list[tuple[float, float]]] = []
        left, low = 0.0, 0.0  # of the frame in which it is drawn
        for token in SHAPE.finditer(drawn):
            if token["kind"]:
                colours[token["kind"].decode()] = token["colour"].decode().strip()
            elif token["to"]:
                if token["to"] == b"m":
                    parts.append([])
                parts[-1].append((left + float(token["x"]), low + float(token["y"])))
            elif token["frame"] or token["end"]:
                left, low = map(float, (token["frame"] or b"0 0").split())
            else:
                fill, stroke = (
                    colours[k] if token["paint"] in paints else "" for k, paints in (("rg", b"Bf"), ("RG", b"BS"))
                )
                if parts:
                    found.append(Shape(number, parts, fill, stroke))
                parts = []
    return found


def rgb(colour: tuple[float, float, float]) -> str:
    return " ".join(f"{c:.3f}" for c in colour)


def with_outcome(made: Solved, key: str, **changed: object) -> Solved:
    """A solved design with no curves and tables but those that are put into one of its steps."""
    outcomes = {
        name: replace(outcome, curves=(), tables=(), further=None) for name, outcome in made.results.outcomes.items()
    }
    outcomes[key] = replace(outcomes[key], **changed)  # type: ignore[arg-type]
    return Solved(made.raw, made.document, Results(made.results.design, outcomes))
