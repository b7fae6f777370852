# SPDX-License-Identifier: Apache-2.0
"""What is said for a moment covers neither the help of a field, nor what stands at the foot, nor the help."""

from textual.widget import Widget
from textual.widgets._toast import Toast, ToastRack

from assistant.app import ContralberoApp
from assistant.screens.help import HelpScreen
from assistant.session.session import Session
from assistant.widgets.lines import FooterLine, MessageLine
from assistant.widgets.rows import FieldHelp
from tests.assistant.conftest import solved
from tests.assistant.driving import go_to, settled, work

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
