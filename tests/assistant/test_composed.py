# SPDX-License-Identifier: Apache-2.0
"""The screens of a design with two shafts of three bearings each, as one, at three sizes."""

from pathlib import Path

import pytest

from assistant.session.recovery import Memory
from assistant.session.session import Session
from assistant.widgets.checks import Checks
from assistant.widgets.form import Taken
from assistant.widgets.picture import Picture
from assistant.widgets.rows import Asked, rows
from calc.design.model import STEPS
from calc.design.toml_file import read
from calc.studies.headlines import headline, lead
from tests.assistant.conftest import Screen
from tests.assistant.driving import at_rest, screen_rows, settled, work
from tests.conftest import DESIGNS

PAIR = DESIGNS / "r754ie4_balance_shafts.toml"  # of which the middle bearing of the left shaft decides


def flat(lines: list[str]) -> str:
    return " ".join(" ".join(lines).split())


@pytest.mark.slow
async def test_two_shafts_at_three_sizes(screen: Screen, tmp_path: Path) -> None:
    session = Session.open(PAIR, memory=Memory(tmp_path))
    async with screen((120, 40), session) as pilot:
        for size, view in (((120, 40), "checks"), ((80, 24), "checks"), ((200, 60), "checks")):
            await pilot.resize_terminal(*size)
            await pilot.press("escape", "5")
            work(pilot).action_to_view(view)
            await settled(pilot)
            # the sentence of the drive leads step 5, whole
            assert session.results is not None and (first := lead(session.results, "gears", brief=True)) is not None
            content = [row.plain for item in work(pilot).query_one(Checks).items[:1] for row in item.rows]
            assert flat(content) == str(first) and "Rattle at idle, no load: C, strikes at 73 mm/s" in str(first)
            assert content[0] in "\n".join(screen_rows(pilot)), size
        # what step 6 takes over of the bearings says of which shaft they are
        await pilot.press("6")
        await settled(pilot)
        told = [item.line for item in work(pilot).form.query_one(Taken).items]
        assert [line for line in told if line.startswith("Friction power")] == [
            "Friction power, left, front 54.1 W",
            "Friction power, left, middle 78.65 W",
            "Friction power, left, rear 54.1 W",
        ]
        await pilot.press("4")
        await settled(pilot)
        await at_rest(pilot)
        assert "middle" in pilot.app.screen.query_one(Picture).render().plain
        shown = headline(session.results, "bearings")
        assert shown is not None and str(shown.brief) == "left middle film 5.1/4.5 µm"


def test_rows_of_wheels_have_their_names_and_of_bearings_say_that_they_are() -> None:
    data, asked = read(PAIR).data, Asked({}, short=4)
    labels = {
        step.key: [str(row.about.label) for row in rows(step, data, asked) if row.kind == "cells"] for step in STEPS
    }
    assert labels["gears"][:3] == ["crank", "left-idler", "left"]
    assert labels["countershaft"][:3] == ["Front bearing", "Middle bearing", "Rear bearing"]
