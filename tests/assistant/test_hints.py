# SPDX-License-Identifier: Apache-2.0
"""What the last rows say of Enter is what it does, wherever the cursor is: it is read, and then struck."""

from pathlib import Path

import pytest
from textual.pilot import Pilot
from textual.widgets import Static

from assistant.app import ContralberoApp
from assistant.screens.ready import ASSUMED, Closing, ReadyScreen
from assistant.screens.remedies import Remedies, RemedyList
from assistant.session.session import Session
from assistant.widgets.headings import Fold
from assistant.widgets.radio import Balance
from assistant.widgets.rows import FieldHelp
from assistant.widgets.steps import Steps
from tests.assistant.action_tests import over
from tests.assistant.conftest import Screen, solved
from tests.assistant.driving import go_to, message, settled, strike, until, work
from tests.assistant.test_leaving_out import begun


def foot(pilot: Pilot[int]) -> str:
    return " ".join(work(pilot).query_one(FieldHelp).text.split())


async def test_the_message_says_what_leads_to_what_is_to_do(tmp_path: Path) -> None:
    """Enter where it leads there: from a finished step, from its last field, in the list of steps, on what builds it;
    else the key of the step."""
    session = begun(tmp_path, "r753ie4")
    session.solve()
    async with ContralberoApp(session).run_test(size=(120, 40)) as pilot:
        await solved(pilot)
        bench = work(pilot)

        async def says(number: int, key: str) -> None:
            """And what it says is so."""
            await until(pilot, lambda: message(pilot).startswith(f"{key} goes on: {number} "))
            await strike(pilot, {"Enter": "enter"}.get(key, key.lower()))
            await until(pilot, lambda: bench.number == number)
            await settled(pilot)

        await strike(pilot, "escape")
        await says(2, "Enter")
        await until(pilot, lambda: isinstance(pilot.app.focused, Balance))
        assert message(pilot).startswith("Enter goes on: 2 ")  # which it builds

        await strike(pilot, "alt+1")
        await go_to(pilot, "engine.bore_mm")
        await says(2, "Alt+2")
        await strike(pilot, "alt+1")
        await settled(pilot)
        fields = [stop for stop in bench.form.stops() if stop.parent is not bench.form]
        bench.set_focus(fields[-1])
        await says(2, "Enter")

        await strike(pilot, "alt+1", "escape")
        steps = bench.query_one(Steps)
        bench.set_focus(steps)
        steps.go_to("bearings")
        await says(2, "Alt+2")
        bench.set_focus(steps)
        steps.go_to("imbalance")
        await says(2, "Enter")

        await strike(pilot, "alt+2", "escape")
        await until(pilot, lambda: message(pilot).startswith("2 Imbalance is to do."))


@pytest.mark.slow
async def test_the_foot_says_what_enter_does_with_a_fold_and_a_choice(screen: Screen, light: Session) -> None:
    async with screen(size=(120, 40)) as pilot:
        form = work(pilot).form
        fold = form.query(Fold).first()
        fold.focus()
        for said, open in (("Enter or → opens it", True), ("Enter or ← closes it", False)):
            await until(pilot, lambda said=said: foot(pilot).startswith(said))  # type: ignore[misc]
            await strike(pilot, "enter")
            await until(pilot, lambda open=open: fold.row.open is open)  # type: ignore[misc]
            await settled(pilot)
        assert foot(pilot).startswith("Enter or → opens it")
        await strike(pilot, "alt+2")
        balance = work(pilot).form.query_one(Balance)
        await until(pilot, lambda: balance.taken)
        balance.focus()
        await until(pilot, lambda: foot(pilot).endswith("The design has this one: Enter goes on."))
        await strike(pilot, "down")
        await until(pilot, lambda: "Enter takes it" in foot(pilot))
        await strike(pilot, "up", "enter")
        await until(pilot, lambda: work(pilot).number == 3)


@pytest.mark.slow
async def test_the_last_row_of_the_pages_says_what_enter_does_with_theirs(screen: Screen, light: Session) -> None:
    async with screen(size=(120, 40)) as pilot:

        def last(id: str) -> str:
            return str(pilot.app.screen.query_one(id, Static).content).strip()

        work(pilot).leave_pane()
        await strike(pilot, "D")
        await over(pilot, ReadyScreen)
        closing = pilot.app.screen.query_one(Closing)
        closing.go_to(ASSUMED)
        for said in ("Enter unfolds", "Enter folds it", "Enter unfolds"):
            await until(pilot, lambda said=said: last("#ready-keys").startswith(said))  # type: ignore[misc]
            assert (ASSUMED in closing.unfolded) is (said == "Enter folds it")
            await strike(pilot, "enter")
        closing.go_to("bearings")
        await until(pilot, lambda: last("#ready-keys").startswith("Enter opens it"))
        await strike(pilot, "enter")
        await until(pilot, lambda: pilot.app.screen is work(pilot) and work(pilot).number == 4)
        await strike(pilot, "D")
        await over(pilot, ReadyScreen)
        closing = pilot.app.screen.query_one(Closing)
        finding = next(item.key for item in closing.items if "." in item.key)
        closing.go_to(finding)
        await until(pilot, lambda: last("#ready-keys").startswith("Enter goes there"))
        await strike(pilot, "enter")
        await until(pilot, lambda: pilot.app.screen is work(pilot) and work(pilot).checks.has_focus)
        await until(pilot, lambda: work(pilot).checks.key == finding)

        await strike(pilot, "f7", "f5")
        shown = await over(pilot, Remedies)
        await until(pilot, lambda: bool(shown.ways))
        ways = pilot.app.screen.query_one(RemedyList)
        await until(pilot, lambda: not shown.searching)
        for n, way in enumerate(shown.ways, 1):
            ways.go_to(str(n))
            does = "" if way.locked else "Enter applies it" if way.changes else "Enter goes there"
            await until(pilot, lambda does=does: last("#remedies-hint").startswith(does or "^l locks"))  # type: ignore[misc]
