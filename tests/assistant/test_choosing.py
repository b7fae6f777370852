# SPDX-License-Identifier: Apache-2.0
"""Rows to choose from: what each breaks, opens and finds locked is said before it is taken; it is compared with the
design as it is; the remedy of the step is that which F5 has."""

import threading
from collections.abc import Callable

import pytest

from assistant.offers import Offer
from assistant.screens import selection
from assistant.screens.compare import CompareScreen, ComparisonList
from assistant.screens.remedies import Remedies
from assistant.screens.selection import Choosing, Preview
from assistant.screens.workbench import Workbench
from assistant.session.guide import no_choice
from assistant.session.session import Session
from calc.design.model import STEP_KEYS
from calc.sheet.remedy import Changes
from calc.sheet.step import Table
from calc.sheet.text import EMPTY, Text
from calc.studies.repair.nearest import NearestRemedy, remedy
from calc.studies.repair.option import RepairOption
from calc.studies.repair.options import QUICK, search
from tests.assistant.conftest import Screen
from tests.assistant.driving import screen_rows, strike, told, until, work

MASS, BORE = "shafts.shaft.masses.front.mass_kg", "engine.bore_mm"
ROWS: dict[int, Changes] = {1: {MASS: 2.0}, 2: {BORE: 95.0}, 3: {}}


def rows(*asked: object, **more: object) -> Offer:
    table = Table("choices", Text("Rows"), ((Text("no."), ""),), tuple((n,) for n in ROWS))
    return Offer(len(ROWS), lambda top: table, ROWS.__getitem__, lambda n: EMPTY, EMPTY)


async def test_what_a_row_does_is_said_before_it_is_taken(
    screen: Screen, light: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    go_on, solve = threading.Event(), Choosing.previewed

    def previewed(self: Choosing, number: int, stop: Callable[[], bool] = bool) -> Preview:
        go_on.wait(30)
        return solve(self, number, stop)

    monkeypatch.setattr(selection, "offer", rows)
    monkeypatch.setattr(Choosing, "previewed", previewed)
    light.toggle_lock(BORE)
    async with screen(size=(80, 24), session=light) as pilot:
        before = light.value(MASS)
        shown = Choosing(light, "countershaft")
        done: list[tuple[str, ...] | None] = []
        pilot.app.push_screen(shown, done.append)
        await until(pilot, lambda: shown.is_mounted and shown.number == 1)
        await strike(pilot, "enter")  # before it is solved: it is taken only where nothing gives way
        go_on.set()
        await until(pilot, lambda: "Row 1: then not kept: First-order couple left over" in told(pilot))
        assert pilot.app.screen is shown and "Row 1: then not kept:" in "\n".join(screen_rows(pilot))
        await strike(pilot, "down")
        await until(pilot, lambda: 2 in shown.previews)
        await strike(pilot, "enter")
        assert "changes what is locked" in told(pilot) and "^l in the field unlocks it" in told(pilot) and not done
        await strike(pilot, "up", "equals_sign")
        await until(pilot, lambda: isinstance(pilot.app.screen, CompareScreen))
        await until(pilot, lambda: bool(pilot.app.screen.query_one(ComparisonList).items))
        text = "\n".join(screen_rows(pilot))
        assert "now → row 1: what it changes" in text and "Enter Take it" in text
        await strike(pilot, "right")
        text = "\n".join(screen_rows(pilot))
        inputs = next(row for row in text.splitlines() if "ass" in row and f"{before:g}" in row)
        assert inputs.index(f"{before:g}") < inputs.rindex("2"), "from now to the row"
        await strike(pilot, "enter")
        await until(pilot, lambda: isinstance(pilot.app.screen, Workbench))
        assert done == [(f"{MASS}=2.0",)]


async def test_a_table_that_is_missing_leads_to_where_it_is_given(screen: Screen, light: Session) -> None:
    async with screen(size=(80, 24), session=light) as pilot:
        assert light.results is not None
        check = next(c for c in light.results.checks() if c.id == "imbalance.unbalances.couple_left")
        done: list[RepairOption | None] = []
        shown = Remedies(light, check)
        pilot.app.push_screen(shown, done.append)
        await until(pilot, lambda: shown.is_mounted and shown.way is not None)
        await strike(pilot, "ctrl+l")
        assert "There is no input to lock here." in told(pilot) and pilot.app.screen is shown
        await strike(pilot, "enter")
        await until(pilot, lambda: bool(done))
        await work(pilot)._remedied(light.generation, check, done[0])
        await until(pilot, lambda: "add" in "".join(screen_rows(pilot)) and work(pilot).step.key == "imbalance")


async def test_a_rolling_bearing_without_a_size_asks_for_one(screen: Screen, session: Session) -> None:
    async with screen(session=session) as pilot:
        session.edit(session.place("bearings.front.kind"), "rolling")
        await strike(pilot, "escape", "4", "t")
        await until(pilot, lambda: "Give a size first, for instance 6205; ^t lists sizes" in told(pilot))
        session.edit(session.place("engine.bore_mm"), "x")
        session.edit(session.place("bearings.front.size"), "6205")
        await strike(pilot, "ctrl+t")
        await until(pilot, lambda: "First the input has to be valid." in told(pilot))


def test_the_table_is_headed_by_the_remedy_that_f5_has(light: Session) -> None:
    """The same change, in the same words; what is locked of the step is said."""
    light.edit(MASS, "2")
    light.toggle_lock("shafts.shaft.masses.rear.radius_mm")
    light.solve()
    results = light.results
    assert results is not None
    nearest: NearestRemedy = remedy(light.document, "countershaft", results, tries=QUICK)
    assert nearest.mends
    (offer,) = Choosing(light, "countershaft").search(lambda share, what: None)
    number, words, _ = offer.table(1).rows[0]
    assert (words, offer.keys(int(str(number)))) == (nearest.words, nearest.made)
    assert any(text.startswith("Held: ") and "locked in the session" in text for text in offer.summary)
    check = next(c for c in results.checks() if c.verdict == "fail" and c.id.startswith("countershaft."))
    ways = list(search(light.document, check, results, nearest=nearest))
    assert nearest.words in [way.words for way in ways]


def test_a_table_is_offered_where_there_is_one(light: Session) -> None:
    assert [step for step in STEP_KEYS if not no_choice(step, light.data)] == ["engine", "countershaft"]
    assert "once the design has these steps: bearings" in no_choice("bearings", light.data)
    assert "nothing to choose in this step; there is in Engine" in no_choice("friction", light.data)
