# SPDX-License-Identifier: Apache-2.0
"""On a small screen data come first: every step in the strip, and the rows of a choice before what is said about it."""

import re

import pytest

from assistant.app import ContralberoApp
from assistant.offers import Offer
from assistant.screens.selection import Choosing
from assistant.widgets.steps import StepBar
from calc.sheet.step import Table
from calc.sheet.text import EMPTY, Text
from tests.assistant.conftest import Screen, solved
from tests.assistant.driving import at_rest, screen_rows, strike, until, work

PROSE = Text("A sentence about the rows, of which there are many more on such a screen than there is room for.")


async def test_every_step_stands_in_the_strip(screen: Screen) -> None:
    """By a word of it, in both languages, whatever step is open."""
    async with screen(size=(80, 24)) as pilot:
        app = pilot.app
        assert isinstance(app, ContralberoApp)
        for code in ("en", "it"):
            await app.speak(code)
            await solved(pilot)
            strip = work(pilot).query_one(StepBar)
            for key in ("1", "4", "7"):
                await strike(pilot, "escape", key)
                shown = strip.render()
                assert shown.cell_length <= 80
                assert re.findall(r"(\d)[^\w\s][^\W\d_]{3,}", shown.plain) == list("1234567"), shown.plain


def many(*args: object, **options: object) -> Offer:
    """Twenty rows, each of which leaves the design as it is."""
    columns = ((Text("no."), ""), (Text("length"), "mm"))
    table = Table("choices", Text("Lengths"), columns, tuple((n, 20.0 + n) for n in range(1, 21)))
    return Offer(20, lambda top: table, lambda n: {}, lambda n: EMPTY, EMPTY, summary=(PROSE,) * 6)


async def test_rows_of_a_choice_stand_before_prose(screen: Screen, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("assistant.screens.selection.offer", many)
    async with screen(size=(80, 24)) as pilot:
        shown = Choosing(work(pilot).session, "engine")
        pilot.app.push_screen(shown)

        async def seen() -> list[str]:
            await until(pilot, lambda: shown.is_mounted and shown.number in shown.previews)
            await at_rest(pilot)
            return screen_rows(pilot)

        rows = await seen()
        assert not any("A sentence" in row for row in rows)
        assert sum(f" {20 + n} " in row for row in rows for n in range(1, 21)) >= 10
        for keys in (["down"] * 11, ["end"]):
            await strike(pilot, *keys)
            # what stands below the table has grown meanwhile
            assert any("▸" in row and f"{20 + shown.number} " in row for row in await seen())
        await strike(pilot, "down")
        assert any("A sentence" in row for row in await seen())  # behind the last row
        await pilot.resize_terminal(120, 40)
        await strike(pilot, "home")
        rows = await seen()
        assert [n for n, row in enumerate(rows) if "A sentence" in row][-1] < min(
            n for n, row in enumerate(rows) if " 21 " in row
        )
