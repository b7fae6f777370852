# SPDX-License-Identifier: Apache-2.0
"""What is said for a moment covers neither the help of a field, nor what stands at the foot, nor the help."""

import threading

import pytest
from textual.widget import Widget
from textual.widgets._toast import Toast, ToastRack

from assistant.app import ContralberoApp
from assistant.screens.help import HelpScreen
from assistant.screens.workbench_edits import BUILDING_ALL
from assistant.session.editing import BuildPlan
from assistant.session.session import Session
from assistant.widgets.lines import FooterLine, MessageLine
from assistant.widgets.rows import FieldHelp
from calc.sheet.errors import NoSolution
from calc.sheet.text import Text
from calc.studies.starter import build
from tests.assistant.conftest import solved
from tests.assistant.driving import go_to, settled, until, work

WORDS = "The report is written: /a/folder/with/a/long/name/" + "and/another" * 8


async def test_a_toast_covers_no_help_and_no_foot(light: Session) -> None:
    """At three sizes; in the help nothing is said, above a dialog it is."""
    light.solve()
    async with ContralberoApp(light).run_test(size=(120, 40), notifications=True) as pilot:
        await solved(pilot)

        async def toasts() -> list[Widget]:
            await settled(pilot)
            rack = pilot.app.screen.get_child_by_type(ToastRack)
            return [toast for toast in rack.walk_children(Toast) if rack.display and toast.region]

        await go_to(pilot, "engine.bore_mm")
        pilot.app.notify(WORDS, timeout=600)
        for size in ((120, 40), (80, 24), (60, 18)):
            await pilot.resize_terminal(*size)
            shown = await toasts()
            assert shown and all(toast.region.height > 1 for toast in shown)
            for below in (FieldHelp, MessageLine, FooterLine):
                part = work(pilot).query_one(below)
                assert part.region and not any(toast.region.overlaps(part.region) for toast in shown), size
        await pilot.press("f1")
        assert isinstance(pilot.app.screen, HelpScreen) and not await toasts()
        await pilot.press("escape", "ctrl+p")
        told = pilot.app.screen.query_one("#palette-help").region
        assert (again := await toasts()) and not any(toast.region.overlaps(told) for toast in again)


async def test_it_is_said_that_all_is_being_built_until_it_is(light: Session, monkeypatch: pytest.MonkeyPatch) -> None:
    """However long that takes, and whatever else is said meanwhile."""
    light.solve()
    built, why = threading.Event(), Text("no needles do")

    def plan_all() -> BuildPlan:
        built.wait(5)
        return BuildPlan(light.document.data, light.document.data, why)

    monkeypatch.setattr(light, "plan_all", plan_all)
    async with ContralberoApp(light).run_test(size=(120, 40), notifications=True) as pilot:
        await solved(pilot)

        def shown() -> dict[str, float]:
            return {note.message: note.time_left for note in pilot.app._notifications}

        await pilot.press("ctrl+g")
        pilot.app.tell(Text("something else"))
        await until(pilot, lambda: "something else" in shown())
        assert shown()[str(BUILDING_ALL)] > 600
        built.set()
        await until(pilot, lambda: str(BUILDING_ALL) not in shown() and str(why) in shown())


def test_what_was_asked_for_and_refused_is_not_built_otherwise_with_the_rest(light: Session, monkeypatch) -> None:
    """Until another kind is chosen in the step itself."""
    asked = []

    def built(document, step, choice=""):
        asked.append((step, choice))
        if choice == "needle":
            raise NoSolution(Text("no needles do"))
        return document

    monkeypatch.setattr(build, "built", built)
    monkeypatch.setattr(build, "to_build", lambda data: ["bearings"])
    before = light.document.data
    assert str(light.ask("bearings", "needle")) == "no needles do"
    plan = light.plan_all()
    assert asked[-1] == ("bearings", "needle") and str(light.take(plan)) == "no needles do"
    assert light.document.data == before
    assert not light.ask("bearings")
    light.plan_all()
    assert asked[-1] == ("bearings", "")
