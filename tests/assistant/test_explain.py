# SPDX-License-Identifier: Apache-2.0
"""Walking back from a number to the inputs."""

import pytest

from assistant.screens.explain import INPUT, ChainList, Explain
from assistant.screens.workbench import Workbench
from assistant.session.session import Session
from assistant.widgets.calculation import Calculation
from assistant.widgets.checks import Checks
from calc.studies.explain import chain
from tests.assistant.conftest import Screen
from tests.assistant.driving import settled, strike, told, until, work


@pytest.mark.slow
@pytest.mark.parametrize("size", [(80, 24), (120, 40)])
async def test_from_a_check_to_the_field_of_an_input(screen: Screen, session: Session, size: tuple[int, int]) -> None:
    async with screen(size=size, session=session) as pilot:
        await strike(pilot, "escape")  # a moment before the letter, as a terminal needs it too
        await strike(pilot, "4", "f7")
        await until(pilot, lambda: work(pilot).query_one(Checks).key == "bearings.front.film_edge")
        await strike(pilot, "enter")
        await until(pilot, lambda: isinstance(pilot.app.screen, Explain))
        shown = pilot.app.screen.query_one(ChainList)
        results = session.results
        assert results is not None
        assert [link.line for link in shown.links] == [link.line for link in chain(results, "bearings.front.film_edge")]
        await strike(pilot, "down", "enter")  # the slope of the journals
        await until(pilot, lambda: isinstance(pilot.app.screen, Workbench))
        await settled(pilot)
        assert work(pilot).form.here() is not None


async def test_a_line_is_walked_through_and_back(screen: Screen, session: Session) -> None:
    async with screen(size=(100, 30), session=session) as pilot:
        await strike(pilot, "escape")
        await strike(pilot, "3")
        await until(pilot, lambda: work(pilot).number == 3)
        await strike(pilot, "f4")
        calculation = work(pilot).query_one(Calculation)
        await until(
            pilot,
            lambda: (
                work(pilot).number == 3
                and work(pilot).page is not None
                and calculation.has_focus
                and "." in calculation.key
            ),
        )
        last = calculation.sheet.entries[-1].number
        calculation.go_to(last)
        await strike(pilot, "x")
        await until(pilot, lambda: isinstance(pilot.app.screen, Explain))
        shown = pilot.app.screen.query_one(ChainList)
        before = list(shown.links)
        for _ in shown.items:
            if not shown.key.startswith(INPUT) and int(shown.key or len(before)) < len(before) - 1:
                break
            await strike(pilot, "down")
        wanted = before[int(shown.key)].line
        await strike(pilot, "enter")
        await until(pilot, lambda: bool(shown.links) and shown.links[-1].line is wanted)
        assert len(shown.links) < len(before)
        await strike(pilot, "backspace")
        await until(pilot, lambda: shown.links == before)
        await strike(pilot, "y")
        assert "Copied" in told(pilot)
        await strike(pilot, "escape")
        await until(pilot, lambda: isinstance(pilot.app.screen, Workbench))


@pytest.mark.slow
async def test_every_check_can_be_explained(screen: Screen, session: Session) -> None:
    """Whatever stands in the list of checks: its limit, source and, where one gives it, its formula."""
    async with screen(size=(80, 24), session=session) as pilot:
        session.solve()
        assert session.results is not None
        for check in session.results.checks():
            screen_ = Explain(session, check=check)
            assert check.source in "\n".join(row.plain for row in _title(pilot, screen_)), check.id


def _title(pilot: object, screen: Explain) -> list:  # type: ignore[type-arg]
    from unittest.mock import PropertyMock, patch

    with patch.object(Explain, "app", new_callable=PropertyMock, return_value=pilot.app):  # type: ignore[attr-defined]
        return screen._title()


async def test_where_there_is_nothing_to_explain(screen: Screen) -> None:
    async with screen(size=(80, 24)) as pilot:
        await strike(pilot, "escape")
        await strike(pilot, "x")
        await until(pilot, lambda: "nothing to explain" in told(pilot))
        await strike(pilot, "g")
        await until(pilot, lambda: "check first" in told(pilot))
