# SPDX-License-Identifier: Apache-2.0
"""The sketches of the report: their words stand free of each other and of lines, and what fails has its sign."""

from itertools import combinations

import numpy as np
import pytest

from calc.draw.drawing import OUTLINE, WORDS, Dimension, Polyline, Sketch, Words, rectangle
from calc.locale import language
from calc.sheet.text import Text
from reports.figures.labels import DOWN, SIZE, UP, Label, placed
from reports.figures.sketches import _labels
from reports.typesetting.boxes import text
from tests.reports.reading import pages_of

FRAME = (-100.0, -100.0, 200.0, 200.0)


def extents(labels: list[Label], pieces: object) -> list[tuple[float, float, float, float]]:
    return [(x, y - DOWN * SIZE, x + box.width, y + UP * SIZE) for box, (x, y), _ in placed(labels, pieces, FRAME)]


def test_words_of_one_place_stand_apart() -> None:
    labels = [Label(text(word, SIZE), (0.0, 0.0), "centre") for word in ("crank", "idler", "shaft", "pump")]
    boxes = extents(labels, np.zeros((0, 4)))
    assert all(a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1] for a, b in combinations(boxes, 2))


@pytest.mark.parametrize("line", [(-50.0, 0.0, 50.0, 0.0), (0.0, -50.0, 0.0, 50.0)])
def test_words_move_off_a_line(line: tuple[float, ...]) -> None:
    ((_, _, clear),) = placed([Label(text("z 25", SIZE), (0.0, 0.0), "centre")], np.array([line]), FRAME)
    assert clear
    (box,) = extents([Label(text("z 25", SIZE), (0.0, 0.0), "centre")], np.array([line]))
    assert box[1] > 0 or box[3] < 0 if line[1] == line[3] else box[0] > 0 or box[2] < 0


def test_the_sign_of_a_failing_part_stands_once() -> None:
    box = rectangle(0.0, 0.0, 1.0, 1.0)
    part = [
        Polyline(OUTLINE, box, True, "gears.meshes.0", "fail"),
        Polyline(OUTLINE, box, True, "gears.meshes.0", "fail"),
    ]
    told = Words(WORDS, (0.0, 0.0), Text("jams"), key="gears.meshes.1", state="fail")
    words = ["".join(mark[3] for mark in one.words.marks) for one in _labels(Sketch((*part, told)), language("en"))]
    assert sorted(words) == ["✗", "✗ jams"]


def test_a_dimension_tells_millimetres() -> None:
    (label,) = _labels(Sketch((Dimension("DIMENSIONS", (0.0, 0.0), (0.1125, 0.0), (0.0, -0.01)),)), language("en"))
    assert "".join(mark[3] for mark in label.words.marks) == "112.5"


def test_every_solved_step_of_the_example_has_its_picture(engineer: bytes) -> None:
    read = "\n".join(pages_of(engineer))
    for n, step in enumerate(("Engine", "Imbalance", "Counter-shaft", "Bearings", "Gears", "Friction"), 1):
        assert f". {step} (" in read, n
