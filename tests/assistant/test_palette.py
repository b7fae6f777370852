# SPDX-License-Identifier: Apache-2.0
"""What the palette finds, and by which words."""

import pytest
from textual.pilot import Pilot

from assistant.actions import ACTIONS
from assistant.screens.palette import ACTION, HIDDEN, Palette, entries
from assistant.screens.workbench import Workbench
from assistant.session.session import Session
from assistant.widgets.text import folded, match
from calc.design.model import STEPS
from tests.assistant.conftest import Screen
from tests.assistant.driving import strike, type_in, until, work


def test_words_in_any_order_and_in_parts() -> None:
    def score(text: str, title: str, *others: str) -> float:
        return match(folded(text).split(), title, *others)[0]

    assert score("step next", "Next step") > 0 and score("st ne", "Next step") > 0
    assert score("step nothing", "Next step") == 0
    assert score("velocita", "Velocità nominale") > 0
    assert score("alesaggio", "Field: Bore", "campo: alesaggio") > 0
    assert (
        score("next", "Next step")
        > score("next", "The next step")
        > score("ext", "Next step")
        > score("next", "x", "next")
        > 0
    )
    assert score("save", "Save") > score("save", "Save as …")
    assert match(["ore", "bo"], "Field: Bore")[1] == [(8, 11), (7, 9)]


def found(pilot: Pilot[int]) -> list[str]:
    screen = pilot.app.screen
    return [row.title for row in screen.rows] if isinstance(screen, Palette) else []


FIRST = (
    ("quit", "Quit"),
    ("ready", "Ready?"),
    ("new", "New: own engine …"),
    ("new another", "New, or another design …"),
    ("step next", "Next step"),
    ("bore engine.b", "Field: Bore  engine.bore_mm"),
    ("alesaggio", "Field: Bore  engine.bore_mm"),
    ("b38 new", "New from BMW B38B15: inline 3, even firing"),
    ("required_couple", "Value: Couple that the counter-shaft must supply  imbalance.required_couple"),
    ("nord theme", "Theme: nord"),
    ("design name", "Field: Name of the design  name"),
    ("customer", "Field: Customer  document.customer"),
)


async def test_what_words_find_first(screen: Screen) -> None:
    async with screen() as pilot:
        every = [entry for entry in entries(work(pilot).app, work(pilot)) if entry.weight == ACTION]
        idle = {*HIDDEN, *(["drive"] if work(pilot).no_drive() else []), *(["fit"] if work(pilot).no_fit() else [])}
        titles = [action.title for action in ACTIONS if action.id not in idle]
        for title in (*titles, *(step.title for step in STEPS)):
            words = folded(title.replace("?", "")).split()
            hits = sorted(((entry.score(words)[0], entry.title) for entry in every), reverse=True)
            assert hits[0][0] > 0 and title in hits[0][1], title
        for words, first in FIRST:
            await strike(pilot, "ctrl+p", *words)
            await until(pilot, lambda first=first: found(pilot)[:1] == [first])  # type: ignore[misc]
            await strike(pilot, "escape")
            await until(pilot, lambda: isinstance(pilot.app.screen, Workbench))


async def test_english_words_in_an_italian_session(screen: Screen) -> None:
    async with screen() as pilot:
        await pilot.app.speak("it")  # type: ignore[attr-defined]
        await strike(pilot, "ctrl+p", *"bore")
        await until(pilot, lambda: len(found(pilot)) < 40 and found(pilot)[0].endswith(" engine.bore_mm"))
        assert "Bore" not in found(pilot)[0]


@pytest.mark.slow
async def test_older_edits_are_offered(screen: Screen, light: Session) -> None:
    other = Session.open(light.home, memory=light.memory, now=light.now)
    other.edit("engine.bore_mm", "97")
    other.autosave()
    async with screen() as pilot:
        await strike(pilot, "ctrl+p")
        await type_in(pilot, "unsaved edits back")
        await strike(pilot, "enter")
        await until(pilot, lambda: work(pilot).session.value("engine.bore_mm") == 97.0)
