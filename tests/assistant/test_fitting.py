# SPDX-License-Identifier: Apache-2.0
"""The fits of a design in the session: made aside, taken as one step of the undo, and of the others why not."""

from pathlib import Path

from assistant.screens.fitting import Fitting
from assistant.session.session import Session
from calc.design.addresses import value_at
from tests.assistant.conftest import Screen
from tests.assistant.driving import strike, until, work
from tests.engine_run import L_ROW, R_ROW, RADIUS, engine_run, fits


async def test_a_fit_is_taken_and_taken_back(screen: Screen, tmp_path: Path) -> None:
    wide = fits(R_ROW, L_ROW, name="wide", of='of = ["acceleration-max"]\n')
    session = Session.open(engine_run(tmp_path, fits(R_ROW, of='of = ["mean-piston-speed"]\n') + wide, noise=1))
    async with screen(session=session) as pilot:
        work(pilot).call_later(work(pilot).action_fit)
        await until(pilot, lambda: isinstance(pilot.app.screen, Fitting))
        shown = pilot.app.screen
        assert isinstance(shown, Fitting)
        await until(pilot, lambda: not shown.searching)
        assert shown.offer is not None and shown.offer.count == 1  # the other is not identifiable
        assert "No values are given" in shown.offer.notes[1]
        await until(pilot, lambda: shown.number == 1 and 1 in shown.previews)
        await strike(pilot, "enter")
        await until(pilot, lambda: not isinstance(pilot.app.screen, Fitting))
        session = work(pilot).session
        assert 51.5 < value_at(session.data, RADIUS) < 52.5
        session.undo()
        assert value_at(session.data, RADIUS) == 53.5
