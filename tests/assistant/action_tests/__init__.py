# SPDX-License-Identifier: Apache-2.0
"""What is done with each action of the table, and what the user sees of it; every deed ends with what must be true.

A deed is named like its action, with an underscore where Python needs one.  It begins in step 2, where no field is
being edited."""

from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any

from textual.pilot import Pilot
from textual.widgets import Input

from assistant.screens.path_dialogs import PathDialog
from assistant.screens.workbench import Workbench
from assistant.session.session import Session
from assistant.widgets.checks import Checks
from assistant.widgets.curve_pane import CurvePane
from calc.design.model import STEPS
from tests.assistant.conftest import solved
from tests.assistant.driving import go_to, screen_rows, strike, type_in, until, work
from tests.assistant.test_curves import drawn

Do = Callable[[], Awaitable[None]]
Deed = Callable[[Pilot[int], Do], Awaitable[None]]
DEEDS: dict[str, Deed] = {}
SHARE, SECOND = "imbalance.crank_balance_fraction", "Second-order couple left"
FIRST_CHECK = "imbalance.order_2.couple"


def deed(of: Deed) -> Deed:
    """What is done with the action of this name, and seen of it.  It begins in step 2, where no field is being edited;
    `do` presses the key, or runs the action from the palette."""
    DEEDS[of.__name__.strip("_")] = of
    return of


async def still(pilot: Pilot[int]) -> None:
    """Wait until the form stands, the results are those of the fields, and the curve is drawn."""
    if making := [
        w for w in pilot.app.workers if w.group.startswith("form-")
    ]:  # of none, it would wait for all workers
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
    """The findings, with the cursor on a piece of advice, which is folded at first."""
    work(pilot).action_to_view("checks")
    await still(pilot)
    checks = work(pilot).query_one(Checks)
    checks.go_to(FIRST_CHECK)
    await still(pilot)
    return checks


async def to_curve(pilot: Pilot[int]) -> CurvePane:
    work(pilot).action_to_view("curve")
    await still(pilot)
    return work(pilot).query_one(CurvePane)


async def edited(pilot: Pilot[int], key: str = SHARE, value: str = "0.4") -> Session:
    """Type into a field, accept it, and leave the form."""
    await go_to(pilot, key)
    await type_in(pilot, value)
    await strike(pilot, "enter", "escape")
    await still(pilot)
    session = work(pilot).session
    assert session.value(key) == float(value) and session.dirty and "● edited" in screen_rows(pilot)[0]
    return session


def titles(pilot: Pilot[int]) -> list[str]:
    """The panes whose title is marked as the one with the focus."""
    names, seen = (
        ("Steps", "Picture", "Findings", "Calculation", *(f"{n} {step.title}" for n, step in enumerate(STEPS, 1))),
        text(pilot),
    )
    return [name for name in names if f"▸{name}" in seen]
