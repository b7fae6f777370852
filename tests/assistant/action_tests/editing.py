# SPDX-License-Identifier: Apache-2.0
"""Editing, moving between fields, copying."""

from textual.pilot import Pilot
from textual.widgets import Input

from assistant.app import ContralberoApp
from assistant.screens.dialogs import Accept, LeaveOut
from assistant.screens.explain import Explain
from assistant.screens.ready import ReadyScreen
from assistant.screens.workbench import Workbench
from assistant.widgets.radio import Balance
from assistant.widgets.steps import states_of
from calc.design.model import STEPS
from calc.studies.ready import NO_PLAIN
from tests.assistant.action_tests import (
    FIRST_CHECK,
    SECOND,
    SHARE,
    Do,
    back,
    deed,
    edited,
    over,
    still,
    text,
    to_checks,
)
from tests.assistant.driving import go_to, screen_rows, strike, told, type_in, until, work


# --- editing
@deed
async def undo(pilot: Pilot[int], do: Do) -> None:
    session = await edited(pilot)
    await do()
    await still(pilot)
    assert session.value(SHARE) == 0.5 and "[0.5      ]" in text(pilot) and "edited" not in screen_rows(pilot)[0]
    form, app = work(pilot).form, pilot.app
    assert isinstance(app, ContralberoApp) and form.last == session.place(SHARE)
    # behind a letter the next one is a key as well
    assert app.focused is form if app.struck_key == "u" else form.here() == form.last
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
async def lock(pilot: Pilot[int], do: Do) -> None:
    session = work(pilot).session
    await do()
    assert "Go to a field first" in told(pilot)
    await go_to(pilot, SHARE)
    await do()
    assert session.lock_reason(SHARE) == "locked in the session"
    await do()
    assert not session.lock_reason(SHARE)


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
    # first the question
    await until(pilot, lambda: isinstance(pilot.app.focused, Balance) and "▸(•) one shaft" in text(pilot))
    await do()
    await until(pilot, lambda: "▸( ) a pair at ±ω" in text(pilot))
    await do()
    await do()
    await until(pilot, lambda: work(pilot).form.here() == work(pilot).session.place(SHARE))  # and past its last answer
    checks = await to_checks(pilot)
    await do()
    await pilot.pause()
    assert checks.key == "hold" and "▸✓ 7 hold" in text(pilot) and checks.has_focus


@deed
async def up(pilot: Pilot[int], do: Do) -> None:
    checks = await to_checks(pilot)
    await strike(pilot, "down")
    assert checks.key == "hold"
    await do()
    await pilot.pause()
    assert checks.key == FIRST_CHECK and f"▸•   {SECOND}" in text(pilot) and checks.has_focus


@deed
async def go_on(pilot: Pilot[int], do: Do) -> None:
    """Accepts a field, with what was understood, and goes to the next; from a step that is done to the next; explains a
    check."""
    box = await go_to(pilot, SHARE)
    await type_in(pilot, "0,4")
    await do()
    await still(pilot)
    assert (
        "[0.4      ]" in text(pilot)
        and pilot.app.focused is not box
        and work(pilot).form.here() == ("imbalance", "kinematics")
    )
    await strike(pilot, "ctrl+z", "escape", "1")
    await until(pilot, lambda: work(pilot).number == 1)
    await still(pilot)
    assert states_of(work(pilot).session)[0].done and pilot.app.focused is work(pilot).form
    await do()
    await until(pilot, lambda: work(pilot).number == 2)
    await to_checks(pilot)
    await do()
    await over(pilot, Explain)
    await back(pilot)


@deed
async def leave(pilot: Pilot[int], do: Do) -> None:
    await go_to(pilot, SHARE)
    assert "Share balanced on the crank: " in text(pilot)
    await type_in(pilot, "0.4")
    await still(pilot)
    assert "[0.4      ] was 0.5" in " ".join(text(pilot).split("\n"))
    await do()
    await still(pilot)
    assert "[0.5      ]" in text(pilot) and not work(pilot).session.dirty  # what was being typed is taken back
    await do()
    await still(pilot)
    assert pilot.app.focused is work(pilot).form
    await strike(pilot, "3")
    await until(pilot, lambda: work(pilot).number == 3)  # a letter is a key again


# --- findings
@deed
async def accept(pilot: Pilot[int], do: Do) -> None:
    """A caution is accepted with a reason, and opened again; a limit is not."""
    session, checks = work(pilot).session, await to_checks(pilot)
    await work(pilot).open_step(STEPS[2], stay=True)
    checks.go_to("countershaft.bolts.slip_vdi")
    await still(pilot)
    await do()
    asked = await over(pilot, Accept)
    await strike(pilot, "enter")
    await until(pilot, lambda: "A reason is needed" in text(pilot))
    asked.query_one(Input).value = "agreed with the foundry"
    await strike(pilot, "enter")
    await until(pilot, lambda: isinstance(pilot.app.screen, Workbench))
    await still(pilot)
    assert session.design.accepted == (("countershaft.bolts.slip_vdi", "agreed with the foundry"),)
    said = " ".join(text(pilot).split())  # over two lines where narrow
    assert all(words in said for words in ("accepted,", "agreed with the foundry"))
    assert checks.key == "countershaft.bolts.slip_vdi"
    await do()
    await still(pilot)
    assert not session.design.accepted and "Open again" in told(pilot)
    checks.go_to("countershaft.residual")
    await do()
    await until(pilot, lambda: "is a limit, which nobody can accept" in told(pilot))


@deed
async def leave_out(pilot: Pilot[int], do: Do) -> None:
    """In a step that the design does not have, from the form too; what the program left out needs words of the user."""
    await do()
    await until(pilot, lambda: "Only a step that the design does not have" in told(pilot))
    session = work(pilot).session
    session.leave_out("bearings", NO_PLAIN)
    work(pilot).edited()
    await work(pilot).open_step(STEPS[3])
    await still(pilot)
    assert pilot.app.focused is work(pilot).form
    await do()
    asked = await over(pilot, LeaveOut)
    assert asked.query_one(Input).value == "" and "left out by the program so far" in text(pilot)
    await strike(pilot, "enter")
    await until(pilot, lambda: "A reason is needed" in text(pilot))
    await strike(pilot, *"on rollers", "enter")
    await until(pilot, lambda: isinstance(pilot.app.screen, Workbench))
    assert session.data["without"] == {"bearings": "on rollers"}


@deed
async def build_all(pilot: Pilot[int], do: Do) -> None:
    """Not before the input is valid; behind the last step that is to do it shows what it came to.  (The building itself
    takes seconds: `test_from_engine_to_ready.py`.)"""
    session = work(pilot).session
    session.edit("engine.bore_mm", "wide")
    await do()
    await until(pilot, lambda: "First the input has to be valid." in told(pilot))
    session.edit("engine.bore_mm", "94")
    for step in ("bearings", "gears", "friction"):
        session.leave_out(step, "on a bench")
    work(pilot).edited()
    await do()
    await over(pilot, ReadyScreen)


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
    assert pilot.app.clipboard.startswith(f"note: {SECOND} 386.8 N·m, limit ≤ 108.6 N·m, margin −256 % [")
    assert told(pilot) == f"Copied: {pilot.app.clipboard}"
