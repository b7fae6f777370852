# SPDX-License-Identifier: Apache-2.0
"""Lines of two kinds in one figure: whole and dashed, the n-th of either in the same colour, on screen and on paper."""

import numpy as np

from assistant.widgets.signs import Signs
from calc.sheet.step import Curve, Series, line_of
from calc.sheet.text import Text
from reports.figures.plots import DASHES, line_style, series_style

LINES = tuple(Series(Text("line"), np.arange(3.0), np.arange(3.0), dashed=n >= 3) for n in range(6))
CURVE = Curve("two", Text("two kinds"), Text("x"), Text("y"), LINES)
WHOLE = Curve("one", Text("one kind"), Text("x"), Text("y"), LINES[:3])


def test_dashed_lines_repeat_the_colours_of_whole_ones():
    assert [line_of(LINES, n) for n in range(6)] == [0, 1, 2, 0, 1, 2]
    assert line_of(LINES, 7) == 7  # none of them: an arrow behind the lines


def test_on_paper():
    styles = [series_style(CURVE, n) for n in range(6)]
    assert [dashes for _, dashes, _ in styles] == [()] * 3 + [DASHES] * 3
    assert [colour for colour, _, _ in styles[:3]] == [colour for colour, _, _ in styles[3:]]
    assert [series_style(WHOLE, n) for n in range(3)] == [line_style(n) for n in range(3)]


def test_on_the_screen():
    signs = Signs()
    looks = [signs.look(n, LINES) for n in range(6)]
    assert [look.pattern for look in looks] == [0] * 3 + [1] * 3
    assert [look.colour for look in looks[:3]] == [look.colour for look in looks[3:]]
    assert [signs.look(n, LINES[:3]) for n in range(3)] == [signs.look(n) for n in range(3)]
