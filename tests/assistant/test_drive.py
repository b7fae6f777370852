# SPDX-License-Identifier: Apache-2.0
"""The whole drive in the session: searched aside, walked along, narrowed, taken as one step of the undo."""

from pathlib import Path

import pytest

from assistant.screens import drive
from assistant.screens.compare import CompareScreen
from assistant.screens.drive import Driving, Scatter
from assistant.screens.selection import OfferList
from assistant.session.session import Session
from calc.design.addresses import value_at
from tests.assistant.conftest import Screen
from tests.assistant.driving import strike, until, work
from tests.conftest import DESIGNS

FEW = """
[optimise]
rows = 6

[optimise.vary]
"countershaft.core_radius_mm" = [14.0, 16.0]
"bearings.rear.diameter_mm" = [84.5, 86.0]
"bearings.front.diameter_mm" = [58.5, 62.0]
"countershaft.material" = ["20CrNi4"]
"bearings.supply" = ["hole"]
"""
SEAT = "shafts.shaft.bearings.rear.diameter_mm"


@pytest.fixture
def few(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Session:
    monkeypatch.setattr(drive, "PROCESSES", 1)
    path = tmp_path / "own.toml"
    path.write_text((DESIGNS / "r753ie4_sized.toml").read_text(encoding="utf-8") + FEW, encoding="utf-8")
    return Session.open(path)


async def found(pilot) -> Driving:  # type: ignore[no-untyped-def]
    work(pilot).call_later(work(pilot).action_drive)
    await until(pilot, lambda: isinstance(pilot.app.screen, Driving))
    shown = pilot.app.screen
    assert isinstance(shown, Driving)
    await until(pilot, lambda: not shown.searching)
    return shown


@pytest.mark.parametrize("size", [(80, 24), pytest.param((120, 40), marks=pytest.mark.slow)])
async def test_a_drive_is_taken_and_taken_back(screen: Screen, few: Session, size: tuple[int, int]) -> None:
    async with screen(size=size, session=few) as pilot:
        shown = await found(pilot)
        assert shown.front is not None and len(shown.front.drives) >= 2
        await until(pilot, lambda: shown.number == 1 and 1 in shown.previews)
        await strike(pilot, "down")
        await until(pilot, lambda: shown.number == 2 and 2 in shown.previews)
        wanted = shown.front.drives[1]
        await strike(pilot, "enter")
        await until(pilot, lambda: not isinstance(pilot.app.screen, Driving))
        session = work(pilot).session
        assert value_at(session.data, SEAT) == wanted.sized.diameter["rear"]
        assert session.data["bearings"]["journal_fit"] == "IT7"
        session.undo()
        assert value_at(session.data, SEAT) == 86.4 and "journal_fit" not in session.data["bearings"]


@pytest.mark.slow
async def test_the_front_is_sorted_narrowed_and_looked_at(screen: Screen, few: Session) -> None:
    async with screen(size=(120, 40), session=few) as pilot:
        shown = await found(pilot)
        offers, scatter = shown.query_one(OfferList), shown.query_one(Scatter)

        def order() -> list[int]:
            return [int(item.key) for item in offers.items if item.key]

        assert order() == sorted(order()) and scatter.points is not None and scatter.points.now is not None
        await strike(pilot, "s")  # by mass
        masses = [shown.front.drives[n - 1].objectives["mass"] for n in order()]  # type: ignore[union-attr]
        assert masses == sorted(masses)
        await strike(pilot, "comma")
        assert shown.widest == 84.5 and len(order()) < len(masses)
        await strike(pilot, "full_stop")
        assert shown.widest is None and len(order()) == len(masses)
        across = scatter.points.across
        await strike(pilot, "X")
        assert scatter.points.across != across and scatter.points.across != scatter.points.up
        await strike(pilot, "equals_sign")
        await until(pilot, lambda: isinstance(pilot.app.screen, CompareScreen))
        await strike(pilot, "escape")
        await until(pilot, lambda: pilot.app.screen is shown)
        await strike(pilot, "f1")
        assert any("follows from the largest journal" in row.plain for item in offers.items for row in item.rows)
        await strike(pilot, "escape")
        await until(pilot, lambda: not isinstance(pilot.app.screen, Driving))


@pytest.mark.slow
async def test_what_stops_every_drive_is_said(screen: Screen, few: Session) -> None:
    few.edit("gears.wheels.crank.span_allowance_um", "60, 50")
    async with screen(size=(120, 40), session=few) as pilot:
        shown = await found(pilot)
        assert shown.front is None
        words = str(shown.query_one("#choosing-state").content)  # type: ignore[attr-defined]
        assert "every drive that was solved whole breaks" in words and "backlash crank–central" in words
        assert "gears." not in words


def test_enter_ends_the_classes_and_then_the_solving(few: Session) -> None:
    """What the classes gave is still solved whole, until another Enter ends that too."""
    shown, told = Driving(few), list[str]()
    shown.searching = True

    def progress(share: float, what: str) -> None:
        told.append(what)
        if ": front" in what or what.startswith("2 of"):
            shown.action_take()

    list(shown.search(progress))
    assert told[-3:] == [f"{n} of 6 drives solved whole" for n in range(3)]
    assert shown.front is not None and len(shown.front.drives) == 2
