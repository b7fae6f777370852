# SPDX-License-Identifier: Apache-2.0
"""Every action of the table, by each of its keys, on a wide and on a narrow terminal: what the user sees of it.

The tests of a size share one screen, which is put in order before each; one that fails leaves a screen that is made anew.
"""

import asyncio
import gc
import re
import shutil
import sys
from collections.abc import AsyncIterator, Awaitable, Callable, Iterator
from contextlib import asynccontextmanager
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest
import pytest_asyncio
from textual.command import CommandInput, CommandPalette
from textual.pilot import Pilot
from textual.widgets import Input

from assistant.actions import ACTIONS, BY_ID
from assistant.app import ContralberoApp
from assistant.recovery import Memory
from assistant.screens import live
from assistant.screens.ask import Ask
from assistant.screens.choosing import Choosing
from assistant.screens.compare import CompareScreen
from assistant.screens.compare_with import CompareWith
from assistant.screens.curve_list import CurveList
from assistant.screens.explain import Explain
from assistant.screens.help import HelpScreen
from assistant.screens.open_dialog import OpenDialog
from assistant.screens.path_dialog import PathDialog
from assistant.screens.save_dialog import ExportDialog, RecordDialog, SaveDialog
from assistant.screens.workbench import Workbench
from assistant.session import EXAMPLE, Session
from assistant.solving import Answer
from assistant.widgets.calculation import Calculation
from assistant.widgets.checks import Checks
from assistant.widgets.curve_pane import CurvePane
from assistant.widgets.form import Form
from assistant.widgets.offer_list import OfferList
from assistant.widgets.steps import Steps
from calc.design import STEPS
from calc.design_file import load

from .conftest import NOON, solved
from .driving import at_rest, go_to, message, screen_rows, strike, told, type_in, until, work
from .test_curves import drawn

Do = Callable[[], Awaitable[None]]
Deed = Callable[[Pilot[int], Do], Awaitable[None]]
DEEDS: dict[str, Deed] = {}
SHARE, SECOND = "imbalance.crank_balance_fraction", "Second-order couple left"
FIRST_CHECK = "imbalance.order_2.couple"


def deed(of: Deed) -> Deed:
    """What is done with the action of this name, and seen of it.  It begins in step 2, where no field is being edited; `do` presses
    the key, or runs the action from the palette."""
    DEEDS[of.__name__.strip("_")] = of
    return of


# --- the screen
@dataclass
class Stage:
    """A screen that is used by many tests, one after the other."""

    pilot: Pilot[int]
    folder: Path
    text: str  # the design as it is in its file
    results: Any
    played: bool = True  # nothing went wrong on it

    def session(self) -> Session:
        shutil.rmtree(self.folder)
        self.folder.mkdir()
        path = self.folder / "light.toml"
        path.write_text(self.text, encoding="utf-8")
        session = Session.open(path, memory=Memory(self.folder / "state"), now=lambda: NOON)
        assert session.accept(Answer(session.generation, self.results, 0.04))
        return session

    async def put_in_order(self) -> None:
        """Step 2 of the design as it is in its file, nothing said, nothing edited, no field with the focus."""
        app = self.pilot.app
        assert isinstance(app, ContralberoApp)
        while len(app.screen_stack) > 1:
            app.pop_screen()
            await self.pilot.pause()
        app.clear_notifications()
        app._clipboard = ""
        bench, session = work(self.pilot), app.session
        as_read = session.home.read_text(encoding="utf-8") == self.text and session.home.name == "light.toml"
        if not (self.played and as_read and not session.dirty and session.recording is None and app.guiding):
            app.guiding = True
            session.recording = None
            await app.enter(self.session())
        curve = bench.query_one(CurvePane)
        curve.chosen, curve.variant, curve.degrees, curve.cursor = {}, "", 0, None
        bench.large = False
        bench.at_pane("inputs")
        bench.set_out()
        await bench.open_step(STEPS[1])
        for form in bench.query(Form):
            if form is not bench.form:  # every widget that is there makes every key a little slower
                await form.remove()
        bench.form.last = None
        bench.form.focus(scroll_visible=False)
        bench.form.scroll_home(animate=False)
        bench.query_one(Checks).action_page(-1000)
        bench.query_one(Calculation).action_page(-1000)
        curve.draw()
        await still(self.pilot)
        assert app.focused is bench.form and bench.number == 2


@pytest.fixture(scope="module")
def put_aside() -> Iterator[None]:
    """Nothing goes on behind a test, and a report is a word."""
    report = ModuleType("reports.report")
    report.write = lambda document, results, raw, path, **rest: path.write_bytes(b"%PDF-" + raw)  # type: ignore[attr-defined]
    with pytest.MonkeyPatch.context() as patch:
        patch.setitem(sys.modules, "reports.report", report)
        patch.setattr(live, "AHEAD", 1000.0)
        gc.set_threshold(50_000, 20, 50)
        yield


@asynccontextmanager
async def staged(size: tuple[int, int], folder: Path) -> AsyncIterator[Stage]:
    """The screen over the first three steps of the example."""
    text = EXAMPLE.read_text(encoding="utf-8").partition("\n[bearings]")[0] + "\n"
    (folder / "light.toml").write_text(text, encoding="utf-8")
    session = Session.open(folder / "light.toml", memory=Memory(folder / "state"), now=lambda: NOON)
    session.solve()
    gc.collect()
    gc.freeze()  # these stay; they need not be looked through again and again
    async with ContralberoApp(session).run_test(size=size) as pilot:
        await still(pilot)
        yield Stage(pilot, folder, text, session.results)
    gc.unfreeze()


@pytest_asyncio.fixture(scope="module", loop_scope="module")
async def wide_stage(put_aside: None, tmp_path_factory: pytest.TempPathFactory) -> AsyncIterator[Stage]:
    async with staged((120, 40), tmp_path_factory.mktemp("wide")) as stage:
        yield stage


@pytest_asyncio.fixture(scope="module", loop_scope="module")
async def narrow_stage(put_aside: None, tmp_path_factory: pytest.TempPathFactory) -> AsyncIterator[Stage]:
    async with staged((80, 24), tmp_path_factory.mktemp("narrow")) as stage:
        yield stage


async def still(pilot: Pilot[int]) -> None:
    """Wait until the form stands, the results are those of the fields, and the curve is drawn."""
    if making := [w for w in pilot.app.workers if w.group.startswith("form-")]:  # of none, it would wait for all workers
        await pilot.app.workers.wait_for_complete(making)
    await solved(pilot)
    await drawn(pilot)


def text(pilot: Pilot[int]) -> str:
    """What is seen, of whatever is on top."""
    return "\n".join(screen_rows(pilot))


def wide(pilot: Pilot[int]) -> bool:
    return pilot.app.size.width >= 100


async def over(pilot: Pilot[int], kind: type[Any]) -> Any:
    """What has been opened over the main screen, as soon as it can be used."""
    await until(pilot, lambda: isinstance(pilot.app.screen, kind) and pilot.app.screen.focused is not None)
    await pilot.pause()
    return pilot.app.screen


async def back(pilot: Pilot[int]) -> None:
    """Leave it with Esc."""
    await strike(pilot, "escape")
    await until(pilot, lambda: isinstance(pilot.app.screen, Workbench))


async def give(pilot: Pilot[int], kind: type[PathDialog[Any]], path: Path) -> None:
    """Type a path into the dialog that has just been opened, and accept it."""
    asked = await over(pilot, kind)
    asked.query_one("#path", Input).value = str(path)
    await pilot.pause()
    await strike(pilot, "enter")


async def to_checks(pilot: Pilot[int]) -> Checks:
    work(pilot).action_to_view("checks")
    await still(pilot)
    return work(pilot).query_one(Checks)


async def to_curve(pilot: Pilot[int]) -> CurvePane:
    work(pilot).action_to_view("curve")
    await still(pilot)
    return work(pilot).query_one(CurvePane)


async def edited(pilot: Pilot[int], key: str = SHARE, value: str = "0.4") -> Session:
    """Type into a field, and leave it."""
    await go_to(pilot, key)
    await type_in(pilot, value)
    await strike(pilot, "escape")
    await still(pilot)
    session = work(pilot).session
    assert session.value(key) == float(value) and session.dirty and "● edited" in screen_rows(pilot)[0]
    return session


def titles(pilot: Pilot[int]) -> list[str]:
    """The panes whose title is marked as the one with the focus."""
    names, seen = ("Steps", "Checks", "Calculation", *(f"{n} {step.title}" for n, step in enumerate(STEPS, 1))), text(pilot)
    return [name for name in names if f"▸{name}" in seen]


# --- steps
async def to_step(number: int, pilot: Pilot[int], do: Do) -> None:
    await do()
    await still(pilot)
    title = f"{number} {STEPS[number - 1].title}"
    assert titles(pilot) == [title] and pilot.app.focused is work(pilot).form
    if wide(pilot):
        assert f"{title}" in text(pilot) and re.search(rf"{title} +◀", text(pilot))
    else:
        assert re.search(rf"\[{number}.{STEPS[number - 1].title}\]", screen_rows(pilot)[1])
    assert ("This design has no step" in text(pilot)) == (number > 3)


DEEDS |= {f"step_{n}": partial(to_step, n) for n in range(1, len(STEPS) + 1)}
DEEDS |= {"back": partial(to_step, 1), "next": partial(to_step, 3)}


# --- help, palette, the end
@deed
async def help_(pilot: Pilot[int], do: Do) -> None:
    await do()
    await over(pilot, HelpScreen)
    assert "Step 2 of 6: Imbalance" in text(pilot)
    await strike(pilot, "end")
    await until(pilot, lambda: "Step 6: Friction" in text(pilot) and "Tab Shift+Tab" in text(pilot))  # the keys, at the end
    await back(pilot)


@deed
async def palette(pilot: Pilot[int], do: Do) -> None:
    await do()
    await over(pilot, CommandPalette)
    await type_in(pilot, "counterweights ap")
    await until(pilot, lambda: "Field: Counterweights apart" in text(pilot))
    await strike(pilot, "enter")
    await until(pilot, lambda: isinstance(pilot.app.screen, Workbench) and work(pilot).form.here() is not None)
    assert work(pilot).form.here() == ("imbalance", "counterweight_span_mm")


@deed
async def quit_(pilot: Pilot[int], do: Do) -> None:
    """Unsaved edits are kept aside; a recording that would be lost is asked about."""
    session = await edited(pilot)
    session.record()
    await do()
    await until(pilot, lambda: isinstance(pilot.app.screen, Ask))
    assert "The recorded replay is not written." in text(pilot) and pilot.app.return_code is None
    await strike(pilot, "n")
    await until(pilot, lambda: isinstance(pilot.app.screen, Workbench))
    session.recording = None
    await do()
    await until(pilot, lambda: pilot.app.return_code == 0)
    again = Session.open(session.home, memory=session.memory)
    assert again.value(SHARE) == 0.4 and "are back" in again.message


# --- panes
@deed
async def view(pilot: Pilot[int], do: Do) -> None:
    if wide(pilot):
        await do()
        await still(pilot)
        assert titles(pilot) == ["2 Imbalance"] and "Calculation" not in text(pilot) and work(pilot).form.size.width > 100
        await do()
        await still(pilot)
        assert "Calculation" in text(pilot) and work(pilot).form.size.width < 60
        return
    for title in ("▸Checks", "▸Calculation", "▸Locus of the couple", "▸2 Imbalance"):
        await do()
        await still(pilot)
        assert screen_rows(pilot)[2].startswith(title)


@deed
async def pane(pilot: Pilot[int], do: Do) -> None:
    for title in ("Checks", "Calculation"):
        await do()
        await still(pilot)
        assert titles(pilot) == [title] and re.search(r"▸(▲ warn|2\.1 )", text(pilot))


@deed
async def pane_back(pilot: Pilot[int], do: Do) -> None:
    await do()
    await still(pilot)
    if wide(pilot):
        assert titles(pilot) == ["Steps"] and isinstance(pilot.app.focused, Steps) and "▸▲ 2 Imbalance" in text(pilot)
    else:
        assert screen_rows(pilot)[2].startswith("▸Locus of the couple") and isinstance(pilot.app.focused, CurvePane)


# --- checks and lines
@deed
async def trouble(pilot: Pilot[int], do: Do) -> None:
    await do()
    await still(pilot)
    assert titles(pilot) == ["Checks"] and f"▸▲ warn {SECOND}" in text(pilot)
    await do()
    await until(pilot, lambda: work(pilot).number == 3)  # the next is in the next step
    await still(pilot)
    assert "▸▲ warn Couple beyond the" in text(pilot) and isinstance(pilot.app.focused, Checks)


@deed
async def explain(pilot: Pilot[int], do: Do) -> None:
    await to_checks(pilot)
    await do()
    await over(pilot, Explain)
    assert f"▲ warn  {SECOND}: 386.8 N·m" in text(pilot) and "formulas" in text(pilot)
    await back(pilot)


@deed
async def line(pilot: Pilot[int], do: Do) -> None:
    await to_checks(pilot)
    await do()
    await still(pilot)
    assert titles(pilot) == ["Calculation"]
    await pilot.pause()
    await until(pilot, lambda: "▸2." in text(pilot))
    shown = text(pilot)[text(pilot).index("▸2.") :]
    assert SECOND in shown and "386.8 N·m" in shown


@deed
async def mend(pilot: Pilot[int], do: Do) -> None:
    mass = "countershaft.masses.front.mass_kg"
    session = await edited(pilot, mass, "2")
    work(pilot).seek_remedy()  # as it does by itself when nothing else is to be done
    await until(pilot, lambda: "mends it" in text(pilot))
    assert message(pilot).startswith("First-order couple left over") and "mass of front 2 → 2.696 kg" in text(pilot)
    await do()
    await until(pilot, lambda: "mass of front 2 → 2.696 kg: passes" in told(pilot) and "Undo takes it back" in told(pilot))
    await still(pilot)
    assert session.value(mass) == 2.696 and "mends it" not in text(pilot) and "✗" not in text(pilot)


@deed
async def choose(pilot: Pilot[int], do: Do) -> None:
    await do()
    await pilot.pause()
    assert "There is nothing to choose in this step; there is in Engine, Counter-shaft" in told(pilot)
    await strike(pilot, "f2")
    await still(pilot)
    await strike(pilot, "escape")
    await do()
    shown = await over(pilot, Choosing)
    await until(pilot, lambda: bool(shown.previews))
    await strike(pilot, "down")
    await until(pilot, lambda: "the design as it is" in text(pilot) and len(shown.previews) == 2)
    assert "Evenly firing orders" in text(pilot) and "▸  2  1-3-2" in text(pilot) and shown.query_one(OfferList).has_focus
    await strike(pilot, "up", "enter")
    await until(pilot, lambda: isinstance(pilot.app.screen, Workbench))
    await still(pilot)
    assert list(work(pilot).session.value("engine.firing_order")) == [1, 2, 3] and "1; 2; 3" in text(pilot) + told(pilot)


@deed
async def guide(pilot: Pilot[int], do: Do) -> None:
    assert "Decide: How much" in text(pilot)
    await do()
    await still(pilot)
    assert "Decide:" not in text(pilot) and work(pilot).session.memory.settings().guide is False
    await do()
    await still(pilot)
    assert "Decide: How much" in text(pilot) and work(pilot).session.memory.settings().guide is True


# --- files
@deed
async def report(pilot: Pilot[int], do: Do) -> None:
    path = work(pilot).session.home.with_suffix(".pdf")
    await do()
    await until(pilot, lambda: f"PDF report: {path}" in told(pilot))
    assert path.read_bytes().startswith(b"%PDF-")


@deed
async def export(pilot: Pilot[int], do: Do) -> None:
    path = work(pilot).session.home.with_name("out.csv")
    await do()
    await give(pilot, ExportDialog, path)
    await until(pilot, lambda: f"Exported: {path}" in told(pilot))
    assert "\nengine.stroke,107" in path.read_text(encoding="utf-8")


@deed
async def save(pilot: Pilot[int], do: Do) -> None:
    session = await edited(pilot)
    before = session.home.read_text(encoding="utf-8")
    await do()
    await until(pilot, lambda: f"Saved: {session.home}" in told(pilot))
    after = session.home.read_text(encoding="utf-8")
    assert load(session.home)[0].data["imbalance"]["crank_balance_fraction"] == 0.4 and after.count("\n") == before.count("\n")
    assert session.home.with_name("light.toml.bak").read_text(encoding="utf-8") == before
    await pilot.pause()
    assert "edited" not in screen_rows(pilot)[0]


@deed
async def save_as(pilot: Pilot[int], do: Do) -> None:
    session = await edited(pilot)
    old, new = session.home, session.home.with_name("other.toml")
    before = old.read_bytes()
    await do()
    await give(pilot, SaveDialog, new)
    await until(pilot, lambda: f"Saved: {new}" in told(pilot))
    assert load(new)[0].data["imbalance"]["crank_balance_fraction"] == 0.4 and old.read_bytes() == before
    await pilot.pause()
    assert session.home == new and " other.toml " in screen_rows(pilot)[0] and "edited" not in screen_rows(pilot)[0]


@deed
async def open_(pilot: Pilot[int], do: Do) -> None:
    home = work(pilot).session.home
    other = home.with_name("other.toml")
    other.write_text(home.read_text(encoding="utf-8").replace("bore_mm = 94.0", "bore_mm = 99.0"), encoding="utf-8")
    await do()
    await give(pilot, OpenDialog, other)
    await until(pilot, lambda: isinstance(pilot.app.screen, Workbench) and work(pilot).session.home == other)
    await still(pilot)
    assert " other.toml " in screen_rows(pilot)[0] and titles(pilot) == ["1 Engine"] and "[99       ] mm" in text(pilot)


@deed
async def reload(pilot: Pilot[int], do: Do) -> None:
    session = await edited(pilot)
    theirs = session.home.read_text(encoding="utf-8").replace("crank_balance_fraction = 0.5", "crank_balance_fraction = 0.3")
    session.home.write_text(theirs, encoding="utf-8")
    await do()
    await until(pilot, lambda: "light.toml is read anew. Undo returns to your edits." in told(pilot))
    await still(pilot)
    assert session.value(SHARE) == 0.3 and "[0.3      ]" in text(pilot) and "edited" not in screen_rows(pilot)[0]


@deed
async def record(pilot: Pilot[int], do: Do) -> None:
    session = work(pilot).session
    await do()
    await pilot.pause()
    assert "● rec" in screen_rows(pilot)[0] and "Every edit is recorded" in told(pilot)
    await edited(pilot)
    await do()
    path = session.home.with_name("replay.toml")
    await give(pilot, RecordDialog, path)
    await until(pilot, lambda: f"Replay: {path}" in told(pilot))
    assert f'set = "{SHARE}"' in path.read_text(encoding="utf-8") and session.recording is None
    await pilot.pause()
    assert "rec" not in screen_rows(pilot)[0]


@deed
async def compare(pilot: Pilot[int], do: Do) -> None:
    await edited(pilot)
    await do()
    await over(pilot, CompareWith)
    assert "light.toml as it is saved" in text(pilot) and "another design file" in text(pilot)
    await strike(pilot, "enter")
    await over(pilot, CompareScreen)
    await until(pilot, lambda: re.search(r"Share balanced on the crank.* 0\.5 +0\.4", text(pilot)) is not None)
    assert "1 input" in text(pilot)
    await back(pilot)


# --- curves and tables
def number(pilot: Pilot[int]) -> str:
    """Which curve of how many, as its title says."""
    found = re.search(r"(\d+) of 8", text(pilot))
    return found[1] if found else ""


@deed
async def curve(pilot: Pilot[int], do: Do) -> None:
    """From where no curve is to be seen, the first key shows it."""
    if not wide(pilot):
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
    assert number(pilot) == "8" and "All values" in text(pilot)
    await do()
    await still(pilot)
    assert number(pilot) == "7"


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
    assert pane.reading is not None and pane.cursor is not None and pane.reading.at in text(pilot) and "◆" in text(pilot)
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


# --- editing
@deed
async def undo(pilot: Pilot[int], do: Do) -> None:
    session = await edited(pilot)
    await do()
    await still(pilot)
    assert session.value(SHARE) == 0.5 and "[0.5      ]" in text(pilot) and "edited" not in screen_rows(pilot)[0]
    assert work(pilot).form.here() == session.place(SHARE)  # where it was taken back
    assert "Undone: " in told(pilot) and "0.4 → 0.5" in told(pilot)


@deed
async def redo(pilot: Pilot[int], do: Do) -> None:
    session = await edited(pilot)
    await strike(pilot, "ctrl+z")
    await strike(pilot, "escape")
    await still(pilot)
    assert session.value(SHARE) == 0.5
    await do()
    await still(pilot)
    assert "Done again: " in told(pilot) and "0.5 → 0.4" in told(pilot)
    assert session.value(SHARE) == 0.4 and "[0.4      ]" in text(pilot) and "● edited" in screen_rows(pilot)[0]


@deed
async def more(pilot: Pilot[int], do: Do) -> None:
    await nudged(pilot, do, "[0.55     ]", 0.55)


@deed
async def less(pilot: Pilot[int], do: Do) -> None:
    await nudged(pilot, do, "[0.45     ]", 0.45)


async def nudged(pilot: Pilot[int], do: Do, shown: str, value: float) -> None:
    box = await go_to(pilot, SHARE)
    await do()
    await still(pilot)
    assert shown in text(pilot) and work(pilot).session.value(SHARE) == value and pilot.app.focused is box


# --- moving
@deed
async def down(pilot: Pilot[int], do: Do) -> None:
    await do()
    await until(pilot, lambda: work(pilot).form.here() == work(pilot).session.place(SHARE))  # into the first field
    checks = await to_checks(pilot)
    await do()
    await pilot.pause()
    assert checks.key == checks.items[2].key and "▸✓ pass First-order couple turning" in text(pilot) and checks.has_focus


@deed
async def up(pilot: Pilot[int], do: Do) -> None:
    checks = await to_checks(pilot)
    await strike(pilot, "down", "down")
    assert checks.key == checks.items[3].key
    await do()
    await do()
    await pilot.pause()
    assert checks.key == FIRST_CHECK and f"▸▲ warn {SECOND}" in text(pilot) and checks.has_focus


@deed
async def go_on(pilot: Pilot[int], do: Do) -> None:
    """Accepts a field, with what was understood, and goes to the next; opens a step; explains a check."""
    box = await go_to(pilot, SHARE)
    await type_in(pilot, "0,4")
    await do()
    await still(pilot)
    assert "[0.4      ]" in text(pilot) and pilot.app.focused is not box and work(pilot).form.here() == ("imbalance", "kinematics")
    await to_checks(pilot)
    await do()
    await over(pilot, Explain)
    await back(pilot)


@deed
async def leave(pilot: Pilot[int], do: Do) -> None:
    await go_to(pilot, SHARE)
    assert "Share balanced on the crank: " in text(pilot)
    await type_in(pilot, "0.4")
    await do()
    await still(pilot)
    assert pilot.app.focused is work(pilot).form and "No field is being edited" in text(pilot)
    assert "[0.4      ]" in text(pilot)  # nothing is taken back
    await strike(pilot, "3")
    await until(pilot, lambda: work(pilot).number == 3)  # a letter is a key again


# --- copying
@deed
async def copy(pilot: Pilot[int], do: Do) -> None:
    await to_checks(pilot)
    await do()
    assert pilot.app.clipboard == "386.8 N·m" and told(pilot) == "Copied: 386.8 N·m"


@deed
async def copy_line(pilot: Pilot[int], do: Do) -> None:
    await to_checks(pilot)
    await do()
    assert pilot.app.clipboard.startswith(f"warn: {SECOND} 386.8 N·m, limit ≤ 108.6 N·m, margin −256 % [")
    assert told(pilot) == f"Copied: {pilot.app.clipboard}"


# --- every one of them
def test_every_action_has_its_deed() -> None:
    assert set(DEEDS) == {action.id for action in ACTIONS}


KEYS = [(action.id, keys.split(",")[0]) for action in ACTIONS for keys in (action.keys, action.letters) if keys]
FIRST = [(action.id, action.binding.split(",")[0]) for action in ACTIONS]  # one key of each action
FROM_PALETTE = ("trouble", "export", "undo", "copy_line")
ALONE = {"quit"}  # on a screen that nobody else uses


async def play(stage: Stage, id: str, do: Do) -> None:
    async with asyncio.timeout(30):
        await stage.put_in_order()
        stage.played = False
        await DEEDS[id](stage.pilot, do)
        stage.played = True


def rows(turn: int) -> list[Any]:
    """Every key of every action: here the first of each at one of the two sizes, by turns; all others among the slow tests."""
    here = [row for n, row in enumerate(FIRST) if n % 2 == turn]
    return [pytest.param(*row, marks=() if row in here else pytest.mark.slow, id="-".join(row)) for row in KEYS if row[0] not in ALONE]


@pytest.mark.asyncio(loop_scope="module")
@pytest.mark.parametrize(("id", "key"), rows(0))
async def test_by_its_key_120x40(wide_stage: Stage, id: str, key: str) -> None:
    await play(wide_stage, id, partial(strike, wide_stage.pilot, key))


@pytest.mark.asyncio(loop_scope="module")
@pytest.mark.parametrize(("id", "key"), rows(1))
async def test_by_its_key_80x24(narrow_stage: Stage, id: str, key: str) -> None:
    await play(narrow_stage, id, partial(strike, narrow_stage.pilot, key))


@pytest.mark.asyncio(loop_scope="module")
@pytest.mark.parametrize("id", FROM_PALETTE)
async def test_from_the_palette(wide_stage: Stage, id: str) -> None:
    async def do() -> None:
        await strike(wide_stage.pilot, "ctrl+p")
        palette = await over(wide_stage.pilot, CommandPalette)
        await type_in(wide_stage.pilot, BY_ID[id].title)
        await until(
            wide_stage.pilot,
            lambda: palette.query_one(CommandInput).value == BY_ID[id].title and chosen(palette).startswith(BY_ID[id].title),
        )
        await strike(wide_stage.pilot, "enter")
        await until(wide_stage.pilot, lambda: wide_stage.pilot.app.screen is not palette)
        await wide_stage.pilot.pause()

    await play(wide_stage, id, do)


def chosen(palette: CommandPalette) -> str:
    """What Enter would run."""
    from textual.command import CommandList

    found = palette.query_one(CommandList)
    at = found.highlighted if found.highlighted is not None else 0
    return str(found.get_option_at_index(at).prompt).strip() if found.option_count else ""


@pytest.mark.parametrize("size", [(120, 40), (80, 24)], ids=["120x40", "80x24"])
@pytest.mark.parametrize("key", BY_ID["quit"].binding.split(","))
@pytest.mark.usefixtures("put_aside")
async def test_the_end(light: Session, size: tuple[int, int], key: str) -> None:
    light.solve()
    async with ContralberoApp(light).run_test(size=size) as pilot:
        await still(pilot)
        await DEEDS["quit"](pilot, partial(strike, pilot, key))
