# SPDX-License-Identifier: Apache-2.0
"""Where the value stands that a curve has where the design is."""

import numpy as np
import pytest

from calc.locale import language
from calc.sheet.step import Curve, Series
from reports.figures.labels import OVER, UNDER, at_the_point, crossed
from reports.figures.plots import Plots, filled

X = np.array([0.0, 5.0, 10.0])
ENDS = (0.0, 100.0)  # lines that the others stand between, so that one of their units is about a point


def lines_crossed(levels: tuple[float, ...], point: tuple[float, float]) -> tuple[int, float]:
    """How many level lines lie across the value at a point, and how far its middle is above the point."""
    curve = Curve(
        "c", "Lines", "x", "y, N", tuple(Series(f"{y:g}", X, 0 * X + y) for y in (*ENDS, *levels)), point=point
    )
    plots = Plots(language("en"))
    axes = plots.axes(480.0, 134.0, curve)
    filled(axes, curve)
    ((box, x, y),) = at_the_point(axes, curve, plots)
    (left, right), height = axes.get_xlim(), axes.transData.transform
    pieces = [np.array([[*height((left, level)), *height((right, level))]]) for level in (*ENDS, *levels)]
    extent = x, y - UNDER, x + box.width, y + OVER
    return sum(crossed(extent, piece) for piece in pieces), y + (OVER - UNDER) / 2 - height(point)[1]


@pytest.mark.parametrize("at", [0.5, 5.0, 9.8])
def test_it_stands_beside_its_mark_where_it_can(at: float) -> None:
    across, above = lines_crossed((), (at, 50.0))
    assert across == 0 and abs(above) < 14.0


@pytest.mark.parametrize("at", [0.5, 5.0, 9.8])
def test_among_close_lines_it_goes_to_where_it_crosses_none(at: float) -> None:
    across, above = lines_crossed((38.0, 44.0, 50.0, 56.0), (at, 50.0))
    assert across == 0 and abs(above) < 30.0


def test_where_lines_are_everywhere_it_crosses_as_few_as_can_be() -> None:
    across, _ = lines_crossed(tuple(range(3, 100, 5)), (5.0, 50.0))
    assert across == 1
