# SPDX-License-Identifier: Apache-2.0
"""Figures drawn ahead of their pages: all at once, by whoever is told to, and the same as if they were drawn here."""

import subprocess
import sys
from collections.abc import Callable

import numpy as np
import pytest

from calc.locale import language
from calc.sheet.step import Curve, Series
from reports.figures.draughtsman import draughtsman
from reports.figures.plots import ALONE, Job, Plots, plot
from reports.typesetting.pen import Recording
from tests.reports.reading import ROOT

X = np.linspace(0.0, 5.0, 60)
CURVES = [Curve("c", "A curve", "x, mm", "y, N", (Series("sine", X, n * np.sin(X)),)) for n in (1, 2000)]


def test_all_that_were_asked_for_are_drawn_at_once() -> None:
    told: list[tuple[str, list[Job]]] = []

    def draws(asked: tuple[str, list[Job]]) -> Callable[[], list[Recording]]:
        told.append(asked)
        return lambda: [Recording(job[0].id, ()) for job in asked[1]]

    plots = Plots(language("it"))
    asked = [plots.ask(curve, 240.0, 150.0, ALONE) for curve in CURVES]
    assert not told
    plots.begin(draws)
    assert [one().code for one in asked] == ["c", "c"]
    assert told == [("it", [(curve, 240.0, 150.0, ALONE) for curve in CURVES])]


@pytest.mark.parametrize("lang", ["en", "it"])
def test_a_figure_is_the_same_whoever_draws_it(lang: str) -> None:
    drawn = draughtsman()((lang, [(curve, 240.0, 150.0, ALONE) for curve in CURVES]))()
    assert drawn == [plot(Plots(language(lang)), curve, 240.0, 150.0) for curve in CURVES]


def test_who_draws_is_there_before_anything_is_loaded() -> None:
    code = "import sys, reports.figures.draughtsman; assert not {'numpy', 'matplotlib', 'reportlab', 'calc.solve'} & set(sys.modules)"
    subprocess.run([sys.executable, "-c", code], cwd=ROOT, check=True)
