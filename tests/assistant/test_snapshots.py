# SPDX-License-Identifier: Apache-2.0
"""The screens as they are seen, few of them: each is a plain text file in `__snapshots__/`, to be read by whoever
reviews a change.

Where a screen is meant to change, `pytest tests/assistant/test_snapshots.py --snapshot-update` writes them anew; then
read what `git diff` shows."""

from collections.abc import AsyncIterator, Callable
from contextlib import AbstractAsyncContextManager, asynccontextmanager
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from rich.cells import cell_len
from syrupy.assertion import SnapshotAssertion
from syrupy.extensions.single_file import SingleFileSnapshotExtension, WriteMode
from textual.pilot import Pilot

from assistant.app import ContralberoApp
from assistant.screens import workbench_results
from assistant.screens.help import HelpScreen
from assistant.screens.path_dialogs import NewDialog
from assistant.screens.ready import ReadyScreen
from assistant.screens.remedies import Remedies
from assistant.screens.selection import Choosing
from assistant.screens.start import Start
from assistant.screens.workbench import Workbench
from assistant.session.recovery import Memory, Settings
from assistant.session.session import EXAMPLE, Session
from assistant.session.solving import Answer
from assistant.widgets.checks import Checks
from assistant.widgets.curve_pane import CurvePane
from calc.design.model import STEPS
from calc.solve import Results
from calc.studies.repair.nearest import remedy
from tests.assistant.conftest import NOON
from tests.assistant.driving import at_rest, screen_rows, strike, until, work
from tests.assistant.test_curves import drawn

SECONDS = 0.64  # that a solve is said to take
SIZED = EXAMPLE.with_name("r753ie4_sized.toml")
FIRST_FAILING = "bearings.front.film_edge"


class Screens(SingleFileSnapshotExtension):
    """One file of text for each screen."""

    _write_mode = WriteMode.TEXT
    file_extension = "txt"


@pytest.fixture
def seen(snapshot: SnapshotAssertion) -> SnapshotAssertion:
    return snapshot.use_extension(Screens)


# --- a design, solved once
@cache
def solved_once(path: Path) -> Results:
    session = Session.open(path, memory=Memory(path.parent / "nowhere"))
    session.solve()
    assert session.results is not None
    return session.results


@cache
def remedy_once(path: Path, step: str) -> Any:
    return remedy(Session.open(path, memory=Memory(path.parent / "nowhere")).document, step, solved_once(path))


Opened = Callable[..., AbstractAsyncContextManager[Pilot[int]]]


@pytest.fixture
def opened(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Opened:
    """Opens a step of a shipped design, which is solved; with a clock that stands, and a solve that always takes as
    long."""
    monkeypatch.setattr(Workbench, "_go_ahead", lambda self: None)
    monkeypatch.setattr(workbench_results, "KEEP", 1000.0)  # nor is there an autosave, sooner or later

    @asynccontextmanager
    async def opened(
        step: int, size: tuple[int, int], path: Path = EXAMPLE, **options: Any
    ) -> AsyncIterator[Pilot[int]]:

        def known(document: Any, step: str, results: Any, progress: Any, **rest: Any) -> Any:
            return remedy(document, step, results, progress, **rest) if rest else remedy_once(path, step)

        monkeypatch.setattr("calc.studies.repair.nearest.remedy", known)
        session = Session.open(path, memory=Memory(tmp_path / "state"), now=lambda: NOON)
        assert session.accept(Answer(session.generation, solved_once(path), SECONDS))
        app = ContralberoApp(session, **options)
        bench = app.get_default_screen()
        assert isinstance(bench, Workbench)
        bench.step = STEPS[step - 1]
        monkeypatch.setattr(app, "get_default_screen", lambda: bench)
        async with app.run_test(size=size) as pilot:
            await still(pilot)
            yield pilot

    return opened


async def still(pilot: Pilot[int]) -> None:
    """Wait until the main screen stands there whole, with the remedy of what fails."""
    bench = work(pilot)
    await until(
        pilot,
        lambda: (
            bench.focused is not None and bench.page is not None and (not bench.trouble or bench.remedy is not None)
        ),
    )
    await drawn(pilot)
    await at_rest(pilot)


async def to_failing(pilot: Pilot[int]) -> Checks:
    """To the first finding that fails, told in full."""
    await strike(pilot, "f7")
    checks = work(pilot).query_one(Checks)
    await until(pilot, lambda: checks.key == FIRST_FAILING and FIRST_FAILING in checks.slopes)
    await still(pilot)
    return checks


def picture(pilot: Pilot[int]) -> str:
    """The screen as text, without the blanks at the end of its rows; a row that is longer or shorter than the screen is
    a fault of itself."""
    found = screen_rows(pilot)
    width, height = pilot.app.size
    assert len(found) == height and {cell_len(row) for row in found} == {width}
    return "\n".join(row.rstrip() for row in found) + "\n"


async def over(pilot: Pilot[int], key: str, kind: type[Any]) -> Any:
    """What a key opens over the main screen, as soon as it can be used."""
    await strike(pilot, key)
    await until(pilot, lambda: isinstance(pilot.app.screen, kind) and pilot.app.screen.focused is not None)
    await pilot.pause()
    return pilot.app.screen


# --- what is seen
async def test_start(seen: SnapshotAssertion, tmp_path: Path) -> None:
    """The engines to begin with, and what the one under the cursor is; nothing is recent."""
    async with ContralberoApp(None, memory=Memory(tmp_path / "state")).run_test(size=(120, 40)) as pilot:
        await until(pilot, lambda: isinstance(pilot.app.screen, Start) and pilot.app.screen.here is not None)
        await strike(pilot, *"inline 3")
        await until(pilot, lambda: not pilot.app.workers and any("−ω" in row for row in screen_rows(pilot)))
        await at_rest(pilot)
        assert picture(pilot) == seen


async def test_imbalance_of_a_new_design(
    seen: SnapshotAssertion, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The one question of the step, what each answer leaves, and its picture."""
    monkeypatch.setattr(Workbench, "_go_ahead", lambda self: None)
    monkeypatch.setattr(workbench_results, "KEEP", 1000.0)
    monkeypatch.chdir(tmp_path)
    async with ContralberoApp(None, memory=Memory(tmp_path / "state")).run_test(size=(120, 40)) as pilot:
        await until(pilot, lambda: isinstance(pilot.app.screen, Start) and pilot.app.screen.here is not None)
        await strike(pilot, *"b38", "enter")
        await until(pilot, lambda: isinstance(pilot.app.screen, NewDialog) and pilot.app.screen.focused is not None)
        await strike(pilot, "enter")
        await until(
            pilot,
            lambda: isinstance(pilot.app.screen, Workbench) and work(pilot).stands and work(pilot).session.current,
        )
        await strike(pilot, "f3")
        await still(pilot)
        work(pilot).session.seconds = SECONDS
        work(pilot).refresh_top_line()
        await at_rest(pilot)
        assert picture(pilot) == seen


async def test_bearings(opened: Opened, seen: SnapshotAssertion) -> None:
    """The first finding that fails, told in full below the films in their gaps."""
    async with opened(4, (120, 40)) as pilot:
        await to_failing(pilot)
        assert picture(pilot) == seen


@pytest.mark.slow
async def test_gears_on_a_narrow_screen(
    opened: Opened, seen: SnapshotAssertion, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(Workbench, "_seek_slopes", lambda self, kind, name: None)
    async with opened(5, (80, 24)) as pilot:
        await strike(pilot, "f4", "f4")
        await still(pilot)
        assert picture(pilot) == seen


async def test_ready(opened: Opened, seen: SnapshotAssertion) -> None:
    async with opened(6, (120, 40), SIZED) as pilot:
        await strike(pilot, "f3")  # past the mounting, which is offered
        await still(pilot)
        await over(pilot, "f3", ReadyScreen)
        await at_rest(pilot)
        assert picture(pilot) == seen


@pytest.mark.slow
async def test_remedies(opened: Opened, seen: SnapshotAssertion) -> None:
    async with opened(4, (120, 40)) as pilot:
        await to_failing(pilot)
        shown = await over(pilot, "f5", Remedies)
        await until(pilot, lambda: not shown.searching)
        await at_rest(pilot)
        assert picture(pilot) == seen


@pytest.mark.slow
async def test_help(opened: Opened, seen: SnapshotAssertion) -> None:
    async with opened(4, (80, 24)) as pilot:
        await over(pilot, "f1", HelpScreen)
        await at_rest(pilot)
        assert picture(pilot) == seen


@pytest.mark.slow
async def test_choosing_with_plain_signs(opened: Opened, seen: SnapshotAssertion) -> None:
    """The firing orders, with what the first would do to all steps."""
    async with opened(1, (120, 40), ascii=True) as pilot:
        shown = await over(pilot, "ctrl+t", Choosing)
        await until(pilot, lambda: bool(shown.previews))
        await at_rest(pilot)
        assert picture(pilot) == seen


@pytest.mark.slow
async def test_in_italian(opened: Opened, seen: SnapshotAssertion, monkeypatch: pytest.MonkeyPatch) -> None:
    # sooner or later the foot and the findings would tell them
    monkeypatch.setattr(Workbench, "_seek_slopes", lambda self, kind, name: None)
    async with opened(4, (80, 24), settings=Settings(language="it")) as pilot:
        assert picture(pilot) == seen


@pytest.mark.slow
async def test_a_very_wide_screen(opened: Opened, seen: SnapshotAssertion, monkeypatch: pytest.MonkeyPatch) -> None:
    # sooner or later the foot and the findings would tell them
    monkeypatch.setattr(Workbench, "_seek_slopes", lambda self, kind, name: None)
    async with opened(3, (200, 60)) as pilot:
        assert picture(pilot) == seen


# --- colours only help
@pytest.mark.slow
async def test_verdicts_are_told_without_colours(opened: Opened, monkeypatch: pytest.MonkeyPatch) -> None:
    """With NO_COLOR every cell is grey, and the same is read; but for curves, whose lines are then told apart by their
    pattern."""
    shown = []
    for plain in (False, True):
        if plain:
            monkeypatch.setenv("NO_COLOR", "1")
        async with opened(4, (200, 60)) as pilot:
            checks = await to_failing(pilot)
            curve, rows = work(pilot).query_one(CurvePane).region, picture(pilot).splitlines()
            for y in range(curve.y, curve.bottom):
                rows[y] = rows[y][: curve.x] + rows[y][curve.right :]
            shown.append(rows)
            if plain:
                _grey(pilot)
                _signed(checks)
    assert shown[0] == shown[1]


def _grey(pilot: Pilot[int]) -> None:
    colours = [
        colour
        for strip in pilot.app.screen._compositor.render_strips()
        for _, style, _ in strip
        if style is not None
        for colour in (style.color, style.bgcolor)
        if colour is not None and not colour.is_default
    ]
    assert colours and all(len({*colour.get_truecolor()}) == 1 for colour in colours)


def _signed(checks: Checks) -> None:
    """Every check begins with the sign of its verdict."""
    verdicts = {check.id: check.verdict for check in solved_once(EXAMPLE).outcomes["bearings"].checks}
    assert {*verdicts.values()} >= {"fail", "warn", "note", "pass"}
    for id in verdicts:
        checks.go_to(id)  # which unfolds it
    told = {item.key: item.rows[0].plain for item in checks.items if "." in item.key}
    assert told.keys() == verdicts.keys()
    for id, row in told.items():
        assert row.startswith(f"{checks.app.signs.mark(verdicts[id])} "), row
