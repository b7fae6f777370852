# SPDX-License-Identifier: Apache-2.0
"""What is drawn in a frame of its own is the same wherever it is placed, and whoever has drawn it."""

import io
import os
import pickle

import numpy as np
import pytest
from reportlab.pdfgen.canvas import Canvas

from calc.locale import language
from calc.sheet.step import Curve, Series, Turning
from reports.figures.plots import Plots, plot
from reports.typesetting.fonts import LEFT, UPRIGHT
from reports.typesetting.pen import Codes, Pen, Recording
from tests.reports.reading import V12, shapes, solved, spans

X = np.linspace(0.0, 5.0, 60)
CURVES = (
    Curve(
        "lines",
        "Lines",
        "x, mm",
        "y, N",
        (Series("sine", X, np.sin(X)), Series("line", X, X)),
        limits=(("limit", 2.0),),
    ),
    Curve("bars", "Bars", "order", "C, N·m", (Series("one", [1.0, 2, 3], [4.0, -1, 2]),), bars=True),
    Curve(
        "locus",
        "Locus",
        "x",
        "y",
        (Series("", np.cos(X), np.sin(X)),),
        equal=True,
        turning=(Turning(("a",), (1 + 0j,), (1,)),),
    ),
)


def drawn(curve: Curve) -> Recording:
    return plot(Plots(language("en")), curve, 240.0, 150.0)


def placed(*at: tuple[Recording, float, float]) -> bytes:
    """A page with recordings at these places."""
    out, codes = io.BytesIO(), dict[str, Codes]()
    canvas = Canvas(out, invariant=1, initialFontName=UPRIGHT)
    pen = Pen(canvas, {}, codes)
    for recording, x, y in at:
        recording.place(pen, x, y)
    pen.write()
    canvas.save()
    return out.getvalue()


@pytest.mark.parametrize("curve", CURVES, ids=lambda curve: curve.id)
def test_it_is_the_same_at_another_place(curve: Curve) -> None:
    recording = drawn(curve)
    corners, words = [], []
    for x, y in ((0.0, 0.0), (31.25, 407.5)):
        pdf = placed((recording, x, y))
        corners.append([np.array(part) - (LEFT + x, y) for shape in shapes(pdf) for part in shape.parts])
        words.append([(s.text, s.x - LEFT - x, s.y - y) for s in spans(pdf)])
    assert len(corners[0]) == len(corners[1]) > 5 and len(words[0]) > 5
    for one, other in zip(*corners):
        assert one == pytest.approx(other, abs=0.011)  # of two decimals
    for (text, *here), (same, *there) in zip(*words):
        assert text == same and here == pytest.approx(there, abs=0.011)


def test_neighbours_do_not_move_each_other() -> None:
    left, right = drawn(CURVES[0]), drawn(CURVES[1])
    both = placed((left, 0.0, 100.0), (right, 200.0, 300.0))
    alone = [
        shape.parts for pdf in (placed((left, 0.0, 100.0)), placed((right, 200.0, 300.0))) for shape in shapes(pdf)
    ]
    assert [shape.parts for shape in shapes(both)] == alone


@pytest.mark.parametrize("curve", CURVES, ids=lambda curve: curve.id)
def test_what_a_copy_of_the_process_sends_is_what_it_has_drawn(curve: Curve) -> None:
    recording = drawn(curve)
    assert pickle.loads(pickle.dumps(recording)) == recording == drawn(curve)


def test_the_pages_are_the_same_with_copies_of_the_process_and_without(monkeypatch: pytest.MonkeyPatch) -> None:
    made = solved(V12)
    whole = made.report("audit")
    monkeypatch.setattr(os, "sched_getaffinity", lambda _: {0}, raising=False)
    assert made.report("audit") == whole
