# SPDX-License-Identifier: Apache-2.0
"""Curves and tables, and reading them."""

import re
from contextlib import nullcontext
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
import pytest
from textual.pilot import Pilot

from assistant.screens.curves import CurveList
from assistant.screens.workbench import Workbench
from assistant.widgets.curve_pane import CurvePane
from calc.sheet.step import Curve, Series, Walk
from calc.sheet.text import Text
from tests.assistant.action_tests import DEEDS, Do, deed, over, still, text, to_curve
from tests.assistant.driving import at_rest, strike, told, type_in, until, work


# --- curves and tables
def number(pilot: Pilot[int]) -> str:
    """Which curve of how many, as its title says."""
    found = re.search(r"(\d+) of 11", text(pilot))
    return found[1] if found else ""


@deed
async def curve(pilot: Pilot[int], do: Do) -> None:
    """From where no curve is to be seen, the first key shows it."""
    assert "Locus of the couple" not in text(pilot)
    await do()
    await still(pilot)
    for n in ("1", "2", "3"):
        assert number(pilot) == n and work(pilot).query_one(CurvePane).leaves[int(n) - 1].title[:20] in text(pilot)
        await do()
        await still(pilot)


@deed
async def curve_back(pilot: Pilot[int], do: Do) -> None:
    await to_curve(pilot)
    await do()
    await still(pilot)
    assert number(pilot) == "11" and "All values" in text(pilot)
    await do()
    await still(pilot)
    assert number(pilot) == "10"


@deed
async def curves(pilot: Pilot[int], do: Do) -> None:
    await do()
    await over(pilot, CurveList)
    assert "2 Imbalance: " in text(pilot) and "▸  1 Locus of the couple" in text(pilot)
    wanted = pilot.app.screen_stack[0].query_one(CurvePane).leaves[2]
    await type_in(pilot, wanted.title.lower())
    await at_rest(pilot)
    await strike(pilot, "enter")
    await until(pilot, lambda: isinstance(pilot.app.screen, Workbench))
    await still(pilot)
    await at_rest(pilot)
    shown = work(pilot).query_one(CurvePane)
    assert shown.leaf is wanted and pilot.app.focused is shown.target and wanted.title[:20] in text(pilot)


async def read_at(pilot: Pilot[int]) -> float:
    """Where the curve is read, as the user sees it too."""
    await still(pilot)
    pane = work(pilot).query_one(CurvePane)
    assert (
        pane.reading is not None and pane.cursor is not None and pane.reading.at in text(pilot) and "◆" in text(pilot)
    )
    return pane.cursor.place


async def reads(by: int, fine: bool, pilot: Pilot[int], do: Do) -> None:
    """The first key brings the cursor; then it goes on, by a step or by a tenth of it."""
    pane = await to_curve(pilot)
    await strike(pilot, "right")
    start = await read_at(pilot)
    await strike(pilot, "right")
    step = await read_at(pilot) - start
    await do()
    moved = await read_at(pilot) - start - step
    assert step > 0 and moved * by > 0 and (abs(moved) < step if fine else abs(moved) == pytest.approx(step))
    await strike(pilot, "escape")
    await still(pilot)
    assert pane.cursor is None and "◆" not in text(pilot) and work(pilot).pane == "curve"


DEEDS |= {"read": partial(reads, 1, False), "read_back": partial(reads, -1, False)}
DEEDS |= {"read_fine": partial(reads, 1, True), "read_fine_back": partial(reads, -1, True)}


async def reads_end(last: bool, pilot: Pilot[int], do: Do) -> None:
    await to_curve(pilot)
    await strike(pilot, "right")
    middle = await read_at(pilot)
    await do()
    end = await read_at(pilot)
    assert (end > middle) if last else (end < middle)
    await strike(pilot, "right" if last else "left")
    assert await read_at(pilot) == end or work(pilot).query_one(CurvePane).curve.equal  # type: ignore[union-attr]


DEEDS |= {"read_first": partial(reads_end, False), "read_last": partial(reads_end, True)}


@deed
async def variant(pilot: Pilot[int], do: Do) -> None:
    await to_curve(pilot)
    for shown in ("without", "with", "without"):
        assert f"{shown} the counter-shaft" in text(pilot)
        await do()
        await still(pilot)


async def turns(degrees: str, pilot: Pilot[int], do: Do) -> None:
    await to_curve(pilot)
    assert "crank at 0°" in text(pilot)
    await do()
    await still(pilot)
    assert f"crank at {degrees}°" in text(pilot)


DEEDS |= {"crank_on": partial(turns, "10"), "crank_back": partial(turns, "350")}


def walked_to(step: int, row: int) -> Curve:
    """A figure that the session makes at three steps and in two rows."""
    line = Series(Text("way"), np.array([0.0, 720.0]), np.array([0.0, 1.0 + step]))
    return Curve("way", Text("Step {step}, row {row}", step=step, row=row), Text("crank, °"), Text("y, µm"), (line,))


async def walks(by: int, pilot: Pilot[int], do: Do) -> None:
    """To a point and no further than the last; l changes the row in the pane itself, the variant's key anywhere."""
    pane = await to_curve(pilot)
    before = pane.leaves
    await do()
    await still(pilot)
    assert "no working cycle of a mesh" in told(pilot)
    pane.show(pane.step, (replace(walked_to(1, 0), walk=Walk(walked_to, 3, 2, (1, 0))), *before))
    pane.choose("way")
    await still(pilot)
    assert "Step 1, row 0" in text(pilot) and "other speeds" in text(pilot)
    for _ in range(2):
        await do()
        await still(pilot)
        assert f"Step {1 + by}, row 0" in text(pilot)
    for row in (1, 0):
        await strike(pilot, "b")
        await still(pilot)
        assert f"Step {1 + by}, row {row}" in text(pilot) and work(pilot).pane == "curve"
    await strike(pilot, "b")
    await still(pilot)
    assert f"Step {1 + by}, row 1" in text(pilot)
    pane.walked.clear()
    pane.show(pane.step, before)


DEEDS |= {"walk_on": partial(walks, 1), "walk_back": partial(walks, -1)}


@deed
async def pixels(pilot: Pilot[int], do: Do) -> None:
    """The curve that stands there goes to a terminal that shows pixels, and not to any other."""
    pane = await to_curve(pilot)
    written: list[Any] = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("assistant.screens.curves.show", lambda curve, how, say: written.append((curve, how)))
        patch.setattr(pilot.app, "suspend", nullcontext)
        patch.setenv("CONTRALBERO_PIXELS", "none")
        await do()
        await until(pilot, lambda: "so nothing was drawn" in told(pilot))
        assert not written
        patch.setenv("CONTRALBERO_PIXELS", "kitty")
        await do()
        await until(pilot, lambda: bool(written))
    assert written == [(pane.curve, "kitty")]
