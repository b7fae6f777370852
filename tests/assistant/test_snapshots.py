# SPDX-License-Identifier: Apache-2.0
"""The screens as they are seen: each is a plain text file in `__snapshots__/`, to be read by whoever reviews a change.

Where a screen is meant to change, `pytest tests/assistant/test_snapshots.py --snapshot-update` writes them anew; then read what `git diff` shows.
"""

from collections.abc import AsyncIterator, Callable, Iterator
from contextlib import AbstractAsyncContextManager, asynccontextmanager
from pathlib import Path
from typing import Any

import pytest
from rich.cells import cell_len
from syrupy.assertion import SnapshotAssertion
from syrupy.extensions.single_file import SingleFileSnapshotExtension, WriteMode
from textual.pilot import Pilot

from assistant.app import ContralberoApp
from assistant.recovery import Memory, Settings
from assistant.screens import background_solve, edit_feedback
from assistant.screens.explain import Explain
from assistant.screens.help import HelpScreen
from assistant.screens.selection import Choosing
from assistant.screens.workbench import Workbench
from assistant.session import EXAMPLE, Session
from assistant.sheets import Sheet, sheet
from assistant.solving import Answer
from assistant.widgets.checks import Checks
from assistant.widgets.curve_pane import CurvePane
from calc.design import STEPS
from calc.repair import remedy as remedies

from .conftest import NOON
from .driving import at_rest, go_to, screen_rows, strike, type_in, until, work
from .test_curves import drawn

BY_SIZE = pytest.mark.parametrize("size", [(120, 40), (80, 24)], ids=lambda size: f"{size[0]}x{size[1]}")
SECONDS = 0.64  # that a solve is said to take
pytestmark = pytest.mark.usefixtures("calculations")


class Screens(SingleFileSnapshotExtension):
    """One file of text for each screen."""

    _write_mode = WriteMode.TEXT
    file_extension = "txt"


@pytest.fixture
def seen(snapshot: SnapshotAssertion) -> SnapshotAssertion:
    return snapshot.use_extension(Screens)


# --- the example, solved once
@pytest.fixture(scope="module")
def solved_once(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    """The results of the shipped example, and the remedies of the steps that fail."""
    session = Session.open(EXAMPLE, memory=Memory(tmp_path_factory.mktemp("once")))
    session.solve()
    assert session.results is not None
    outcomes = session.results.outcomes
    found = {s.key: remedies.remedy(session.document, s.key, session.results) for s in STEPS if outcomes[s.key].verdict == "fail"}
    yield session.results, found


@pytest.fixture(scope="module")
def calculations() -> Iterator[None]:
    """The calculations of the example are written out once in each language."""
    made: dict[tuple[int, str], tuple[Any, Sheet]] = {}

    def once(outcome: Any, number: int, say: Any, stop: Any) -> Sheet:
        if (id(outcome), say.code) not in made:
            made[id(outcome), say.code] = outcome, sheet(outcome, number, say)
        return made[id(outcome), say.code][1]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("assistant.sheets.sheet", once)
        yield


Opened = Callable[..., AbstractAsyncContextManager[Pilot[int]]]


@pytest.fixture
def opened(solved_once: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Opened:
    """Opens a step of the example, which is solved; with a clock that stands, and a solve that always takes as long."""
    results, found = solved_once
    monkeypatch.setattr(background_solve, "AHEAD", 1000.0)
    monkeypatch.setattr(edit_feedback, "KEEP", 1000.0)  # nor is there an autosave, sooner or later
    monkeypatch.setattr("calc.repair.remedy.remedy", lambda document, step, results, progress: found[step])

    @asynccontextmanager
    async def opened(step: int, size: tuple[int, int], **options: Any) -> AsyncIterator[Pilot[int]]:
        session = Session.open(EXAMPLE, memory=Memory(tmp_path / "state"), now=lambda: NOON)
        assert session.accept(Answer(session.generation, results, SECONDS))
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
            bench.focused is not None
            and bench.background.page is not None
            and (not bench.background.trouble or bench.background.remedy is not None)
        ),
    )
    await drawn(pilot)
    await at_rest(pilot)


def picture(pilot: Pilot[int]) -> str:
    """The screen as text, without the blanks at the end of its rows; a row that is longer or shorter than the screen is a fault of itself."""
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
@BY_SIZE
@pytest.mark.parametrize("number", range(1, 7), ids=lambda n: f"{n}-{STEPS[n - 1].key}")
async def test_step(opened: Opened, seen: SnapshotAssertion, size: tuple[int, int], number: int) -> None:
    async with opened(number, size) as pilot:
        assert picture(pilot) == seen


@BY_SIZE
async def test_help_views_and_explanation(opened: Opened, seen: SnapshotAssertion, size: tuple[int, int]) -> None:
    """Help on a field; the panes that a narrow screen shows one at a time; and where the number of the worst check comes from."""
    async with opened(4, size) as pilot:
        await over(pilot, "f1", HelpScreen)
        assert picture(pilot) == seen(name=f"help {size[0]}")
        await strike(pilot, "escape")
        await until(pilot, lambda: isinstance(pilot.app.screen, Workbench))
        for view in ("checks", "calculation", "curve") if size[0] < 100 else ():
            await strike(pilot, "f4")
            await still(pilot)
            assert picture(pilot) == seen(name=f"{view} {size[0]}")
        await strike(pilot, "f7")
        await over(pilot, "enter", Explain)
        assert picture(pilot) == seen(name=f"explain {size[0]}")


@BY_SIZE
async def test_choosing_and_a_mistake(opened: Opened, seen: SnapshotAssertion, size: tuple[int, int]) -> None:
    """The firing orders, with what the first would do to all steps; and an entry that is not accepted."""
    async with opened(1, size) as pilot:
        shown = await over(pilot, "ctrl+t", Choosing)
        await until(pilot, lambda: bool(shown.previews))
        await pilot.pause()
        assert picture(pilot) == seen(name=f"choose {size[0]}")
        await strike(pilot, "escape")
        await until(pilot, lambda: isinstance(pilot.app.screen, Workbench))
        await go_to(pilot, "engine.bore_mm")
        await type_in(pilot, "-9")
        await until(pilot, lambda: "last valid input" in picture(pilot))
        await still(pilot)
        assert picture(pilot) == seen(name=f"not valid {size[0]}")


async def test_in_italian(opened: Opened, seen: SnapshotAssertion) -> None:
    async with opened(1, (80, 24), settings=Settings(language="it")) as pilot:
        assert picture(pilot) == seen


async def test_plain_signs(opened: Opened, seen: SnapshotAssertion) -> None:
    async with opened(3, (120, 40), ascii=True) as pilot:
        assert picture(pilot) == seen


async def test_too_small_a_terminal(opened: Opened, seen: SnapshotAssertion) -> None:
    async with opened(1, (44, 12)) as pilot:
        assert picture(pilot) == seen


# --- colours only help
async def test_verdicts_are_told_without_colours(opened: Opened, monkeypatch: pytest.MonkeyPatch) -> None:
    """With NO_COLOR every cell is grey, and the same is read; but for curves, whose lines are then told apart by their pattern."""
    monkeypatch.setenv("NO_COLOR", "1")
    async with opened(4, (120, 40)) as pilot:
        bench, signs = work(pilot), pilot.app.signs  # type: ignore[attr-defined]
        colours = [colour for strip in pilot.app.screen._compositor.render_strips() for _, style, _ in strip if style is not None
                   for colour in (style.color, style.bgcolor) if colour is not None and not colour.is_default]  # fmt: skip
        assert colours and all(len({*colour.get_truecolor()}) == 1 for colour in colours)

        assert bench.session.results is not None
        checks = {check.id: check.verdict for check in bench.session.results.outcomes["bearings"].checks}
        assert {*checks.values()} >= {"fail", "warn", "note", "pass"}
        listed = bench.query_one(Checks)
        for id in checks:
            listed.go_to(id)  # which unfolds it
        shown = {item.key: item.rows[0].plain for item in listed.items if "." in item.key}
        assert shown.keys() == checks.keys()
        for id, row in shown.items():
            assert row.startswith(f"{signs.mark(checks[id])} "), row

        file = Path(__file__).parent / "__snapshots__" / "test_snapshots" / "test_step[4-bearings-120x40].txt"
        coloured = file.read_text(encoding="utf-8")
        curve = bench.query_one(CurvePane).region
        for y, (with_colours, without) in enumerate(zip(coloured.splitlines(), picture(pilot).splitlines(), strict=True)):
            room = curve.x if curve.y <= y < curve.bottom else None
            assert without[:room].rstrip() == with_colours[:room].rstrip()
