# SPDX-License-Identifier: Apache-2.0
"""What the bench measured, in the session: points on the curve, the residuals below it, the verdict with the findings."""

from pathlib import Path

import numpy as np
from textual.pilot import Pilot
from textual.widgets import Static

from assistant.screens.workbench_results import runs_known
from assistant.session.recovery import Memory
from assistant.session.session import Session
from assistant.widgets.residual_strip import strip
from calc.design.model import STEPS
from calc.locale import language
from calc.sheet.curve import MeasuredPoints
from calc.sheet.text import Text
from tests.assistant.conftest import Screen
from tests.assistant.driving import at_rest, rows, until, work

RUN = """
[[measurements]]
name = "run"
file = "run.csv"
speed = "n"
columns = [{ name = "P", column = "P", value = "imbalance.order_1.couple_backward", unit = "N·m", uncertainty = 20 }]
"""


def points(*residuals: float) -> MeasuredPoints:
    n = np.arange(len(residuals), dtype=float)
    return MeasuredPoints(Text("measured"), n, 0 * n, np.full(len(n), 1.0), np.array(residuals))


def test_the_strip_has_a_row_above_one_on_and_one_below_what_was_measured() -> None:
    above, on, below = strip(points(2.0, 0.5, -3.0, float("nan")), "W", int, 4, 24, language("en"), "•")
    assert above == " > σ•" + " " * 19
    assert on == "   0·•" + "·" * 18
    assert below.startswith("< −σ  •") and below.endswith("furthest −3 W ")


async def test_points_and_residuals_stand_in_the_pane_of_curves(screen: Screen, design: Path, memory: Memory) -> None:
    path = design.with_name("run.toml")
    (path.parent / "run.csv").write_text("n;P\n1300;150\n2000;400\n2600;560\n", encoding="utf-8")
    path.write_text(design.read_text(encoding="utf-8").partition("\n[countershaft]")[0] + RUN, encoding="utf-8")
    session = Session.open(path, memory=memory)
    async with screen((120, 40), session) as pilot:
        await opened(pilot)
        pane = work(pilot).curve_pane
        pane.choose("measured.run.P")
        work(pilot).action_to_view("curve")
        await at_rest(pilot)
        text = rows(pilot)
        assert "•" in text and "measured" in text and "> σ" in text
        assert pane.query_one("#residuals", Static).display
        assert [check.id for check in work(pilot).checks.outcome.checks if check.id.startswith("measured")]


async def opened(pilot: Pilot[int]) -> None:
    """The second step, with its runs solved."""
    await until(pilot, lambda: work(pilot).session.results is not None)
    await work(pilot).open_step(STEPS[1])
    results = work(pilot).session.results
    assert results is not None and not runs_known(results)
    work(pilot).seek_runs()  # which goes on behind the screen while nobody types
    await until(pilot, lambda: runs_known(results))
    await until(pilot, lambda: any(leaf.id == "measured.run.P" for leaf in work(pilot).curve_pane.leaves))
