# SPDX-License-Identifier: Apache-2.0
"""A screen that many tests use, one after the other, put in order before each."""

import shutil
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from textual.pilot import Pilot

from assistant.app import ContralberoApp
from assistant.session.recovery import Memory
from assistant.session.session import EXAMPLE, Session
from assistant.session.solving import Answer
from assistant.widgets.calculation import Calculation
from assistant.widgets.checks import Checks
from assistant.widgets.curve_pane import CurvePane
from assistant.widgets.form import Form
from assistant.widgets.radio import Balance
from calc.design.model import STEPS
from tests.assistant.action_tests import still
from tests.assistant.conftest import NOON
from tests.assistant.driving import work


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
        bench.reset_panes()
        bench.set_out()
        await bench.open_step(STEPS[1])
        for form in bench.query(Form):
            if form is not bench.form:  # every widget that is there makes every key a little slower
                await form.remove()
        bench.form.last = None
        question = bench.form.query_one(Balance)
        question.go_to(question.made())
        bench.form.focus(scroll_visible=False)
        bench.form.scroll_home(animate=False)
        bench.query_one(Checks).action_page(-1000)
        bench.query_one(Calculation).action_page(-1000)
        curve.draw()
        await still(self.pilot)
        assert app.focused is bench.form and bench.number == 2


@asynccontextmanager
async def staged(size: tuple[int, int], folder: Path) -> AsyncIterator[Stage]:
    """The screen over the first three steps of the example."""
    text = EXAMPLE.read_text(encoding="utf-8").partition("\n[bearings]")[0] + "\n"
    (folder / "light.toml").write_text(text, encoding="utf-8")
    session = Session.open(folder / "light.toml", memory=Memory(folder / "state"), now=lambda: NOON)
    session.solve()
    async with ContralberoApp(session).run_test(size=size) as pilot:
        await still(pilot)
        yield Stage(pilot, folder, text, session.results)
