# SPDX-License-Identifier: Apache-2.0
"""Steps, help, panes, checks and lines."""

import re
from functools import partial

from textual.pilot import Pilot

from assistant.screens.dialogs import Ask
from assistant.screens.explain import Explain
from assistant.screens.help import HelpScreen
from assistant.screens.palette import Palette
from assistant.screens.ready import ReadyScreen
from assistant.screens.remedies import Remedies
from assistant.screens.selection import Choosing, OfferList
from assistant.screens.workbench import Workbench
from assistant.session.session import Session
from assistant.widgets.checks import Checks
from assistant.widgets.curve_pane import CurvePane
from assistant.widgets.radio import Todo
from assistant.widgets.steps import BRIEF, Steps
from calc.design.model import STEPS
from tests.assistant.action_tests import (
    DEEDS,
    SECOND,
    SHARE,
    Do,
    back,
    deed,
    edited,
    over,
    still,
    text,
    titles,
    to_checks,
    wide,
)
from tests.assistant.driving import screen_rows, strike, told, type_in, until, work


# --- steps
async def to_step(number: int, pilot: Pilot[int], do: Do) -> None:
    await do()
    await still(pilot)
    title = f"{number} {STEPS[number - 1].title}"
    bench = work(pilot)
    offers = isinstance(bench.focused, Todo)  # what is to be chosen stands under the cursor
    assert titles(pilot) == [title] and (offers if number > 3 else bench.focused is bench.form)
    if wide(pilot):
        assert f"{title}" in text(pilot) and re.search(rf"{title} +◀", text(pilot))
    else:
        step = STEPS[number - 1]
        assert re.search(rf"\[{number}.({step.title}|{BRIEF.get(step.key, step.title)})\]", screen_rows(pilot)[1])
    assert ("leave it out" in text(pilot)) == (number > 3)  # what the design does not have is built, or left out


DEEDS |= {f"step_{n}": partial(to_step, n) for n in range(1, len(STEPS) + 1)}
DEEDS |= {"back": partial(to_step, 1), "next": partial(to_step, 3)}


async def leafs(pilot: Pilot[int], do: Do) -> None:
    """Of two shafts the next one is the one before."""
    bench = work(pilot)
    bench.session.add_shaft("shaft", "mirrors")
    bench.edited()
    await strike(pilot, "3")
    await still(pilot)
    assert "3 Balance shafts: shaft" in text(pilot) and "◂ 1/2" in text(pilot)
    await do()
    await still(pilot)
    assert "3 Balance shafts: twin" in text(pilot) and "◂ 2/2" in text(pilot)


DEEDS |= {"shaft_on": leafs, "shaft_back": leafs}


# --- help, palette, the end
@deed
async def help_(pilot: Pilot[int], do: Do) -> None:
    await do()
    await over(pilot, HelpScreen)
    assert "Step 2 of 7: Imbalance" in text(pilot)
    assert all(word in text(pilot) for word in ("Go on", "See why", "Mend", "Take back", "Write"))
    await strike(pilot, "f1")
    await until(pilot, lambda: "This screen" in text(pilot))
    await strike(pilot, "end")
    # the keys, at the end
    await until(pilot, lambda: "Step 6: Friction" in text(pilot) and "Tab Shift+Tab" in text(pilot))
    await back(pilot)


@deed
async def palette(pilot: Pilot[int], do: Do) -> None:
    await do()
    await over(pilot, Palette)
    await type_in(pilot, "ap counterweights")
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
    await strike(pilot, "escape")
    await until(pilot, lambda: isinstance(pilot.app.screen, Workbench))
    session.recording = None
    await do()
    await until(pilot, lambda: pilot.app.return_code == 0)
    session.leave()  # as the end of the program does
    again = Session.open(session.home, memory=session.memory)
    assert again.value(SHARE) == 0.4 and "are back" in again.message


DEEDS["close"] = quit_


# --- panes
@deed
async def view(pilot: Pilot[int], do: Do) -> None:
    if wide(pilot):
        for title in ("Calculation", "Locus of the couple", "Findings"):  # in turn, and the picture stays
            await do()
            await still(pilot)
            assert f"│▸{title}" in text(pilot) and "│ Picture" in text(pilot) and "│ 2 Imbalance" in text(pilot)
        return
    for title in ("▸Picture", "▸Findings", "▸Calculation", "▸Locus of the couple", "▸2 Imbalance"):
        await do()
        await still(pilot)
        assert screen_rows(pilot)[2].startswith(title)


@deed
async def enlarge(pilot: Pilot[int], do: Do) -> None:
    """The pane alone on the screen, and beside the others again; on a narrow screen it is alone already."""
    for _ in range(2):
        await do()
        await still(pilot)
        assert titles(pilot) == ["2 Imbalance"] and "Findings  " not in text(pilot) and work(pilot).form.size.width > 70
        await do()
        await still(pilot)
        assert not wide(pilot) or ("│ Findings" in text(pilot) and work(pilot).form.size.width < 60)


@deed
async def pane(pilot: Pilot[int], do: Do) -> None:
    for title in ("Picture", "Findings"):
        await do()
        await still(pilot)
        assert titles(pilot) == [title]
    assert "▸? Wanted couple that pulley" in text(pilot)


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
    assert work(pilot).number == 2 and titles(pilot) == ["Findings"] and "▸? Wanted couple" in text(pilot)
    await do()
    await until(pilot, lambda: work(pilot).number == 3)
    await still(pilot)
    assert titles(pilot) == ["Findings"] and "▸▲ Couple beyond the" in text(pilot)
    await do()
    await still(pilot)
    assert "▸▲ Safety against slip" in text(pilot) and isinstance(pilot.app.focused, Checks)


@deed
async def ready(pilot: Pilot[int], do: Do) -> None:
    """The closing page tells the numbers and, as the title does, what is left; Enter goes there, Esc back."""
    assert "WARN: 3 cautions  3 steps left" in screen_rows(pilot)[0]
    await do()
    await over(pilot, ReadyScreen)
    assert re.search(r"couple for the shaft +573 → 0 N·m", text(pilot))
    assert re.search(r"3 Counter-shaft +WARN: 2 cautions" if wide(pilot) else r"2 Imbalance +WARN: 1", text(pilot))
    assert "WARN: 3 cautions; 3 steps left" in screen_rows(pilot)[0] and "done, with findings (2)" in text(pilot)
    assert re.search(r"○ 4 Bearings +to do", text(pilot))
    await back(pilot)
    await do()
    await over(pilot, ReadyScreen)
    await strike(pilot, "down", "enter")  # the second of those that are left
    await until(pilot, lambda: isinstance(pilot.app.screen, Workbench) and work(pilot).number == 5)


@deed
async def not_counted(pilot: Pilot[int], do: Do) -> None:
    """The same page, with what acts on the shaft and no input describes unfolded."""
    await do()
    await over(pilot, ReadyScreen)
    await until(pilot, lambda: "· torsion of the shaft" in text(pilot))
    await back(pilot)


@deed
async def fit(pilot: Pilot[int], do: Do) -> None:
    await do()
    await pilot.pause()
    assert "This design has no [[fits]]." in told(pilot) and isinstance(pilot.app.screen, Workbench)


@deed
async def drive(pilot: Pilot[int], do: Do) -> None:
    """A design without bearings has no drive: that is said, and nothing is opened. Ready does not offer it either."""
    await do()
    await pilot.pause()
    assert "The whole drive is searched once the design has these steps: bearings." in told(pilot)
    assert isinstance(pilot.app.screen, Workbench)
    work(pilot).action_ready()
    await over(pilot, ReadyScreen)
    assert "Enter opens it" in text(pilot) and "drives" not in text(pilot)
    await back(pilot)


@deed
async def explain(pilot: Pilot[int], do: Do) -> None:
    await to_checks(pilot)
    await do()
    await over(pilot, Explain)
    assert f"• note  {SECOND}: 386.8 N·m" in text(pilot) and "formulas" in text(pilot)
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
    assert SECOND in shown and "386.8\u00a0N·m" in shown  # a number and its unit stay on one row


@deed
async def fix(pilot: Pilot[int], do: Do) -> None:
    mass = "countershaft.masses.front.mass_kg"
    session = await edited(pilot, mass, "2")
    await do()
    shown = await over(pilot, Remedies)
    assert "First-order force left over: 963.5 N" in text(pilot)
    await until(pilot, lambda: not shown.searching)
    assert "mass of front 2 → 2.5 kg" in text(pilot) and "Counter-shaft ✗ → ▲ warn" in text(pilot)
    await strike(pilot, "ctrl+l")
    await until(pilot, lambda: not shown.searching and any(way.locked for way in shown.ways))
    *_, locked = session.data["locked"]
    await strike(pilot, *["down"] * (len(shown.ways) - 1), "enter")
    assert isinstance(pilot.app.screen, Remedies) and "is locked: locked in the session" in told(pilot)
    await strike(pilot, "ctrl+l")
    await until(pilot, lambda: not shown.searching and locked not in session.data["locked"])
    heavier = next(n for n, way in enumerate(shown.ways, 1) if way.kind == "heavier mass")
    await strike(pilot, "home", *["down"] * (heavier - 1), "enter")
    await until(
        pilot,
        lambda: (
            "mass of front 2 → 2.5 kg: First-order force left over" in told(pilot)
            and "passes. Undo takes it back" in told(pilot)
        ),
    )
    await still(pilot)
    assert session.value(mass) == 2.5 and "✗" not in text(pilot)


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
    assert (
        "Evenly firing orders" in text(pilot) and "▸  2  1-3-2" in text(pilot) and shown.query_one(OfferList).has_focus
    )
    await strike(pilot, "up", "enter")
    await until(pilot, lambda: isinstance(pilot.app.screen, Workbench))
    await still(pilot)
    assert list(work(pilot).session.value("engine.firing_order")) == [1, 2, 3] and "1; 2; 3" in text(pilot) + told(
        pilot
    )


@deed
async def guide(pilot: Pilot[int], do: Do) -> None:
    for shown in (False, True):
        assert "Which balancing?" in text(pilot) and ("Good: Little left" in text(pilot)) != shown
        await do()
        await still(pilot)
        assert "Which balancing?" in text(pilot) and ("Good: Little left" in text(pilot)) == shown
        assert work(pilot).session.memory.settings().guide is shown
