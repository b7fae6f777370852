# SPDX-License-Identifier: Apache-2.0
"""The search behind a dialog: how far it is, why it ends, that it can be stopped, and that an earlier one is no longer
heard."""

import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NoReturn

import pytest
from textual.app import ComposeResult
from textual.widgets import Static

from assistant.offers import Offer
from assistant.screens import selection
from assistant.screens.selection import Choosing, Searching, time_left
from assistant.screens.workbench import Workbench
from calc.sheet.errors import BadInput, InputError, NoSolution
from calc.sheet.progress import Progress
from calc.sheet.text import Text
from tests.assistant.conftest import Screen
from tests.assistant.driving import strike, until, work


class Letters(Searching[str | None, str]):
    """Finds what it is given, by the searches one after the other."""

    STATE, BAR, BEHIND = "state", 10, Text("Esc stops")

    def __init__(self, *searches: Callable[[Progress], Iterator[str]]) -> None:
        super().__init__()
        self.searches = list(searches)
        self.letters: list[str] = []

    def compose(self) -> ComposeResult:
        yield Static(id="state")

    def on_mount(self) -> None:
        self.begin()

    def search(self, progress: Progress) -> Iterator[str]:
        return self.searches.pop(0)(progress)

    def show_found(self, found: str) -> None:
        self.letters.append(found)

    def show_end(self, failure: Text) -> None:
        self.show_state(f"over {failure}")

    @property
    def state(self) -> str:
        return str(self.query_one("#state", Static).content)


@pytest.mark.parametrize(
    ("ascii", "bar"), [(False, "████░░░░░░"), pytest.param(True, "####......", marks=pytest.mark.slow)]
)
async def test_how_far_it_is(screen: Screen, ascii: bool, bar: str) -> None:
    go_on = threading.Event()

    def search(progress: Progress) -> Iterator[str]:
        progress(0.4, "half of them")
        yield "a"
        go_on.wait(30)

    async with screen(ascii=ascii) as pilot:
        shown = Letters(search)
        pilot.app.push_screen(shown)
        await until(pilot, lambda: shown.letters == ["a"])
        assert shown.searching and shown.state == f"searching …  {bar}  40%  half of them   Esc stops"
        go_on.set()
        await until(pilot, lambda: not shown.searching)
        assert shown.state == "over " and shown.letters == ["a"]


@pytest.mark.parametrize(
    ("seconds", "share", "words"),
    [
        (2.0, 0.5, ""),  # nobody can know yet
        (60.0, 0.02, ""),
        (10.0, 0.5, "about 10 s left"),
        (4.0, 0.8, "about 1 s left"),
        (17.0, 0.4, "about 25 s left"),
        (200.0, 0.5, "about 3 min left"),
        (200.0, 1.0, ""),
    ],
)
def test_how_long_it_still_takes(seconds: float, share: float, words: str) -> None:
    assert time_left(seconds, share) == words


@pytest.mark.parametrize(
    ("error", "words"),
    [
        (NoSolution(Text("no pair fits")), "no pair fits"),
        (
            BadInput("x.toml", [InputError(1, "engine.bore_mm", "-1", Text("is below zero"))]),
            "bore: is below zero",
        ),
        (ZeroDivisionError("by nought"), "the program made a mistake: ZeroDivisionError: by nought"),
    ],
)
async def test_why_it_ends(
    screen: Screen, error: Exception, words: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))

    def search(progress: Progress) -> Iterator[str]:
        yield "a"
        raise error

    async with screen() as pilot:
        shown = Letters(search)
        shown.session = work(pilot).session
        pilot.app.push_screen(shown)
        await until(pilot, lambda: bool(shown.letters) and not shown.searching)
        assert words in shown.state and shown.letters == ["a"]


@pytest.mark.slow
async def test_a_fault_in_a_table_of_rows_does_not_end_the_session(
    screen: Screen, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It is said in the dialog, with the file that has its trace."""

    def broken(top: int) -> NoReturn:
        raise KeyError("rise")

    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    monkeypatch.setattr(
        selection, "offer", lambda *asked, **_: Offer(1, broken, lambda n: {}, lambda n: Text("row"), Text("hint"))
    )
    async with screen() as pilot:
        shown = Choosing(work(pilot).session, "engine")
        pilot.app.push_screen(shown)
        await until(pilot, lambda: shown.is_mounted and not shown.searching)
        (trace,) = tmp_path.glob("contralbero/faults/*.txt")
        said = str(shown.query_one("#choosing-state", Static).content)
        assert said == f"Nothing to choose: the program made a mistake: KeyError: 'rise'; its trace is in {trace}"
        assert "in broken" in trace.read_text(encoding="utf-8")
        await strike(pilot, "escape")
        await until(pilot, lambda: isinstance(pilot.app.screen, Workbench))


async def test_an_earlier_search_is_stopped_and_no_longer_heard(screen: Screen) -> None:
    go_on, stopped = threading.Event(), threading.Event()

    def first(progress: Progress) -> Iterator[str]:
        yield "a"
        go_on.wait(30)
        yield "late"
        try:
            progress(0.9, "nearly")
        finally:
            stopped.set()
        yield "never"

    async with screen() as pilot:
        shown = Letters(first, lambda progress: iter("b"))
        pilot.app.push_screen(shown)
        await until(pilot, lambda: shown.letters == ["a"])
        shown.begin()
        await until(pilot, lambda: not shown.searching)
        go_on.set()
        await until(pilot, stopped.is_set)
        await pilot.pause(0.05)
        assert shown.letters == ["a", "b"] and shown.state == "over "


async def test_leaving_stops_it(screen: Screen) -> None:
    go_on, ended = threading.Event(), threading.Event()
    reached: list[str] = []

    def search(progress: Progress) -> Iterator[str]:
        yield "a"
        go_on.wait(30)
        try:
            progress(0.5, "more")
            reached.append("went on")
        finally:
            ended.set()

    async with screen() as pilot:
        shown, below = Letters(search), pilot.app.screen
        pilot.app.push_screen(shown)
        await until(pilot, lambda: shown.letters == ["a"])
        await strike(pilot, "escape")
        await until(pilot, lambda: pilot.app.screen is below)
        go_on.set()
        await until(pilot, ended.is_set)
        assert not reached
