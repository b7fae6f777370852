# SPDX-License-Identifier: Apache-2.0
"""Where on a page of a report something is printed, so that what is laid over it can be told from what covers nothing.

Text counts wherever it stands, figures and formulas as a whole, with the bars between their letters; rules, frames and panels say
nothing by themselves.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import Any

from .verify.pdf_file import Malformed, Pdf
from .setting.tags import FIGURE

Rectangle = tuple[float, float, float, float]  # left, lower, right, upper
ABOVE, BELOW = 0.72, 0.20  # of the size: how far letters reach from their base line
NEAR = 1.0  # points at its edges in which something printed may be overlapped
SPAN = "Span"  # of a formula: its letters with what is read out for them
WHOLE = {FIGURE: "figure", SPAN: "formula"}
PARTS = 100  # of the contents of a page
MOST = 60  # letters that are quoted of what is covered
NUMBER = rb"-?[\d.]{1,30}"
TOKEN = re.compile(
    rb"(?P<matrix>(?:" + NUMBER + rb" ){6})Tm|/(?P<font>\S{1,60}) (?P<size>[\d.]{1,30}) Tf|<(?P<codes>[0-9a-fA-F]*)> Tj"
    rb"|/(?P<role>\w{1,60}) (?:<<(?:[^<>]|<[^<>]*>)*>> BDC|BMC)|(?P<end>EMC)"
    rb"|1 0 0 1 (?P<frame>(?:" + NUMBER + rb" ){2})cm|(?P<image>(?:" + NUMBER + rb" ){6})cm"
    rb"|(?P<area>(?:" + NUMBER + rb" ){4})re\b|(?P<points>(?:" + NUMBER + rb" ){2,6})[mlc]\b",
    re.S,
)  # fmt: skip
CODE = re.compile(rb"<([0-9A-F]{2})> <([0-9A-F]{4,})>")


def covered(rectangle: Rectangle, under: Iterable[tuple[Rectangle, str]]) -> str:
    """What a rectangle covers of what is printed on a page; empty where it is nothing."""
    left, low, right, top = rectangle
    found = [text for (a, b, c, d), text in under if _reaches(left, right, a, c) and _reaches(low, top, b, d)]
    said = " ".join(found)
    return said if len(said) <= MOST else f"{said[:MOST]} …"


def _reaches(start: float, end: float, low: float, high: float) -> bool:
    """Whether one stretch reaches into another beyond its edges; what is thinner than both edges has still a middle."""
    return start < max(high - NEAR, (low + high) / 2) and end > min(low + NEAR, (low + high) / 2)


def printed(pdf: Pdf, page: Any) -> Iterator[tuple[Rectangle, str]]:
    """Every piece of text, every formula and every figure of a page with its place."""
    known = pdf.entries(pdf.entries(pdf.entries(page).get("Resources")).get("Font"))
    fonts = {name: _font(pdf, pdf.entries(reference)) for name, reference in known.items()}
    matrix, x, size, font = (1.0, 0.0, 0.0, 1.0, 0.0, 0.0), 0.0, 0.0, ""
    roles: list[str] = []
    drawn: list[tuple[float, float]] = []
    origin: tuple[float, ...] = (0.0, 0.0)  # of what is drawn in a frame of its own
    for token in TOKEN.finditer(contents(pdf, page)):
        if token["matrix"]:
            matrix, x = _six(token["matrix"]), 0.0
        elif token["font"]:
            font, size = token["font"].decode("latin-1"), float(token["size"])
        elif token["codes"] is not None:
            wide, text = _set(fonts.get(font), bytes.fromhex(token["codes"].decode()))
            if text.strip():
                place = _box(matrix, x, x + wide * size, size)
                yield place, text
                if SPAN in roles:
                    drawn += [place[:2], place[2:]]
            x += wide * size
        elif token["role"]:
            roles.append(token["role"].decode())
        elif token["end"]:
            role = roles.pop() if roles else ""
            if role in WHOLE and drawn:
                xs, ys = zip(*drawn)
                yield (min(xs), min(ys), max(xs), max(ys)), WHOLE[role]
                drawn = []
            origin = 0.0, 0.0
        elif token["frame"]:
            origin = tuple(map(float, token["frame"].split()))
        elif FIGURE in roles:
            drawn += [(a + origin[0], b + origin[1]) for a, b in _corners(token)]


def contents(pdf: Pdf, page: Any) -> bytes:
    """The operators of a page."""
    found = pdf.entries(page).get("Contents")
    parts = pdf.items(found) or [found]
    if len(parts) > PARTS:
        raise Malformed(f"a page has {len(parts):,} contents; at most {PARTS} are read")
    return b"\n".join(pdf.data(one) for one in parts)


def _corners(token: re.Match[bytes]) -> list[tuple[float, float]]:
    """The points of an operator that draws."""
    if token["points"]:
        numbers = [float(one) for one in token["points"].split()]
        return list(zip(numbers[::2], numbers[1::2]))
    if token["area"]:
        x, y, wide, high = (float(one) for one in token["area"].split())
    else:
        wide, _, _, high, x, y = _six(token["image"])
    return [(x, y), (x + wide, y + high)]


def _six(numbers: bytes) -> tuple[float, float, float, float, float, float]:
    a, b, c, d, e, f = (float(one) for one in numbers.split())
    return a, b, c, d, e, f


def _box(matrix: tuple[float, float, float, float, float, float], start: float, end: float, size: float) -> Rectangle:
    """The room of a piece of text from start to end along its line."""
    a, b, c, d, e, f = matrix
    ends = [(a * u + c * v + e, b * u + d * v + f) for u in (start, end) for v in (-BELOW * size, ABOVE * size)]
    xs, ys = zip(*ends)
    return min(xs), min(ys), max(xs), max(ys)


Font = tuple[int, list[float], dict[int, str]]  # its first code, widths from there, letters


def _font(pdf: Pdf, font: dict[str, Any]) -> Font:
    letters = {int(code, 16): bytes.fromhex(to.decode()).decode("utf-16-be") for code, to in CODE.findall(pdf.data(font.get("ToUnicode")))}
    return int(font.get("FirstChar", 0)), [float(one) for one in pdf.items(font.get("Widths"))], letters


def _set(font: Font | None, codes: bytes) -> tuple[float, str]:
    """How wide codes stand for each point of size, and what they say; of a font that is not known half a size each."""
    if font is None or not font[1]:
        return 0.5 * len(codes), "?" * len(codes)
    first, widths, letters = font
    wide = sum(widths[code - first] if 0 <= code - first < len(widths) else 500.0 for code in codes)
    return wide / 1000, "".join(letters.get(code, "?") for code in codes)
