# SPDX-License-Identifier: Apache-2.0
"""Where on a page of a report something is printed, so that what is laid over it can be told from what covers nothing.

Text counts wherever it stands, and a figure as a whole; rules, frames and panels say nothing by themselves.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

from pypdf import PageObject

from .tags import FIGURE

Rectangle = tuple[float, float, float, float]  # left, lower, right, upper
ABOVE, BELOW = 0.72, 0.20  # of the size: how far letters reach from their base line
NEAR = 1.0  # points that two things may overlap before one covers the other
MOST = 60  # letters that are quoted of what is covered
NUMBER = rb"-?[\d.]+"
TOKEN = re.compile(
    rb"(?P<matrix>(?:" + NUMBER + rb" ){6})Tm|/(?P<font>\S+) (?P<size>[\d.]+) Tf|<(?P<codes>[0-9a-fA-F]*)> Tj"
    rb"|/(?P<role>\w+) (?:<<(?:[^<>]|<[^<>]*>)*>> BDC|BMC)|(?P<end>EMC)|(?P<image>(?:" + NUMBER + rb" ){6})cm"
    rb"|(?P<area>(?:" + NUMBER + rb" ){4})re\b|(?P<points>(?:" + NUMBER + rb" ){2,6})[mlc]\b",
    re.S,
)  # fmt: skip
CODE = re.compile(rb"<([0-9A-F]{2})> <([0-9A-F]{4,})>")


def covered(page: PageObject, annotation: Any) -> str:
    """What an annotation covers of what is printed on its page; empty where it is nothing."""
    x, y, x_2, y_2 = (float(end) for end in annotation["/Rect"])
    left, right, low, top = min(x, x_2), max(x, x_2), min(y, y_2), max(y, y_2)
    under = [
        words
        for (a, b, c, d), words in printed(page)
        if min(right, c) - max(left, a) > NEAR and min(top, d) - max(low, b) > NEAR
    ]  # fmt: skip
    said = " ".join(under)
    return said if len(said) <= MOST else f"{said[:MOST]} …"


def printed(page: PageObject) -> Iterator[tuple[Rectangle, str]]:
    """Every piece of text and every figure of a page with its place."""
    contents = page.get_contents()
    if contents is None:
        return
    resources: Any = page["/Resources"]
    fonts = {name: _font(reference.get_object()) for name, reference in resources.get("/Font", {}).items()}
    matrix, x, size, font = (1.0, 0.0, 0.0, 1.0, 0.0, 0.0), 0.0, 0.0, ""
    roles: list[str] = []
    drawn: list[tuple[float, float]] = []
    for token in TOKEN.finditer(contents.get_data()):
        if token["matrix"]:
            matrix, x = _six(token["matrix"]), 0.0
        elif token["font"]:
            font, size = "/" + token["font"].decode("latin-1"), float(token["size"])
        elif token["codes"] is not None:
            wide, words = _set(fonts.get(font), bytes.fromhex(token["codes"].decode()))
            if words.strip():
                yield _box(matrix, x, x + wide * size, size), words
            x += wide * size
        elif token["role"]:
            roles.append(token["role"].decode())
        elif token["end"]:
            if roles and roles.pop() == FIGURE and drawn:
                xs, ys = zip(*drawn)
                yield (min(xs), min(ys), max(xs), max(ys)), FIGURE.lower()
                drawn = []
        elif FIGURE in roles:
            drawn += _corners(token)


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


def _font(font: Any) -> Font:
    letters = CODE.findall(font["/ToUnicode"].get_object().get_data()) if "/ToUnicode" in font else []
    widths = [float(one) for one in font.get("/Widths", [])]
    return int(font.get("/FirstChar", 0)), widths, {int(code, 16): bytes.fromhex(to.decode()).decode("utf-16-be") for code, to in letters}


def _set(font: Font | None, codes: bytes) -> tuple[float, str]:
    """How wide codes stand for each point of size, and what they say; of a font that is not known half a size each."""
    if font is None or not font[1]:
        return 0.5 * len(codes), "?" * len(codes)
    first, widths, letters = font
    wide = sum(widths[code - first] if 0 <= code - first < len(widths) else 500.0 for code in codes)
    return wide / 1000, "".join(letters.get(code, "?") for code in codes)
