# SPDX-License-Identifier: Apache-2.0
"""A table that may be left out: adding it, filling it, emptying it, taking it out; and an array of tables that has no
element yet."""

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import pytest
from textual.pilot import Pilot
from textual.widgets import Static

from assistant.session.session import Session
from assistant.widgets.entry import Entry
from assistant.widgets.field import Field
from assistant.widgets.headings import ArrayHeading, TableHeading
from calc.design.model import STEPS, Design
from calc.design.toml_file import parse
from calc.engine.inputs import EngineInputs
from calc.sheet.quantity import inputs, keys, quantity, series, table
from tests.assistant.conftest import Screen, solved
from tests.assistant.driving import at_rest, go_to, message, rows, settled, strike, type_in, until, work


@inputs
class Trial:
    """A table of the test's own."""

    peak: float = quantity("Peak of the trial", "bar", above=0, high=300)
    ratio: float = quantity("Ratio of the trial", above=1, high=30)
    trace: tuple[float, ...] | None = series("Trace of the trial", "bar", default=None)


@inputs
class EngineWithTrial(EngineInputs):
    """The engine, with a table that may be left out."""

    trial: Trial | None = table("Trial", Trial, default=None, help="What the test asks for.")


@pytest.fixture(autouse=True)
def engine_with_trial(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Steps and design with the engine of the test."""
    known = keys(Design)
    monkeypatch.setitem(
        known, "engine", replace(known["engine"], about=replace(known["engine"].about, table=EngineWithTrial))
    )
    object.__setattr__(STEPS[0], "inputs", EngineWithTrial)
    yield
    object.__setattr__(STEPS[0], "inputs", EngineInputs)


PLACE = ("engine", "trial")


def shown(pilot: Pilot[int]) -> list[Any]:
    """The last keys of the fields of the table that can be seen."""
    return [f.place[-1] for f in work(pilot).form.query(Field) if f.display and f.place[:2] == PLACE]


def heading_of(pilot: Pilot[int]) -> TableHeading:
    (found,) = [heading for heading in work(pilot).form.query(TableHeading) if heading.row.place == PLACE]
    return found


async def to_heading(pilot: Pilot[int]) -> TableHeading:
    form = work(pilot).form
    form.opened |= {0, 1}
    form.rebuild()
    await settled(pilot)
    heading = heading_of(pilot)
    heading.focus()
    heading.scroll_visible(animate=False)
    await settled(pilot)
    await until(pilot, lambda: pilot.app.focused is heading)
    return heading


async def test_an_absent_table_is_one_line(screen: Screen) -> None:
    async with screen() as pilot:
        heading = await to_heading(pilot)
        assert shown(pilot) == [] and "Trial" in rows(pilot) and "+ add" in heading.render().plain
        assert work(pilot).session.valid
        await strike(pilot, "minus")  # nothing to take out
        assert work(pilot).session.valid and not work(pilot).session.dirty


@pytest.mark.slow
async def test_a_table_is_added_filled_and_undone(screen: Screen) -> None:
    async with screen() as pilot:
        session = work(pilot).session
        await to_heading(pilot)
        await strike(pilot, "plus")
        await settled(pilot)
        assert session.value(PLACE) == {} and shown(pilot) == ["peak_bar", "ratio", "trace_bar"]
        assert work(pilot).form.here() == (*PLACE, "peak_bar")  # ready to be typed into
        assert set(session.reasons()) == {(*PLACE, "peak_bar"), (*PLACE, "ratio")}
        assert all("is missing" in reason for reason in session.reasons().values())
        await type_in(pilot, "90")
        await pilot.pause(0.8)
        assert "ratio" in message(pilot) and "is missing" in message(pilot)
        await strike(pilot, "enter")
        await type_in(pilot, "17,5")
        await strike(pilot, "enter")
        await type_in(pilot, "1; 2,5; 90")
        await solved(pilot)
        assert session.valid and session.value(PLACE) == {
            "peak_bar": 90.0,
            "ratio": 17.5,
            "trace_bar": [1.0, 2.5, 90.0],
        }
        assert isinstance(session.design.engine, EngineWithTrial) and session.design.engine.trial is not None
        for left in ({"peak_bar": 90.0, "ratio": 17.5}, {"peak_bar": 90.0}, {}, None):
            await strike(pilot, "ctrl+z")
            await settled(pilot)
            assert session.value(PLACE) == left
        await settled(pilot)
        assert shown(pilot) == [] and not session.dirty and work(pilot).form.here() == PLACE
        await strike(pilot, "ctrl+y")
        await settled(pilot)
        assert session.value(PLACE) == {} and len(shown(pilot)) == 3


@pytest.mark.slow
async def test_the_first_field_of_an_added_table_is_in_view(screen: Screen) -> None:
    async with screen(size=(80, 24)) as pilot:
        form = work(pilot).form
        await to_heading(pilot)
        await strike(pilot, "plus")
        await settled(pilot)
        await until(pilot, lambda: form.here() == (*PLACE, "peak_bar"))
        await until(pilot, lambda: form.field is not None and form.region.contains_region(form.field.region))
        assert form.field is not None and form.region.contains_region(form.field.region)


@pytest.mark.slow
async def test_a_table_is_taken_out_in_one_step(screen: Screen, light: Session) -> None:
    light.put_table(PLACE, True)
    light.edit((*PLACE, "peak_bar"), "90")
    light.edit((*PLACE, "ratio"), "no number")
    async with screen() as pilot:
        session = work(pilot).session
        heading = await to_heading(pilot)
        assert len(shown(pilot)) == 3 and not session.valid
        await strike(pilot, "minus")
        await settled(pilot)
        assert session.value(PLACE) is None and session.valid and shown(pilot) == []
        assert pilot.app.focused is heading and "+ add" in heading.render().plain
        await strike(pilot, "ctrl+z")
        await settled(pilot)
        assert session.value(PLACE) == {"peak_bar": 90.0} and len(shown(pilot)) == 3
        assert session.text((*PLACE, "ratio")) == "no number"


@pytest.mark.slow
async def test_emptying_the_only_field_leaves_nothing_invalid(screen: Screen) -> None:
    async with screen() as pilot:
        session = work(pilot).session
        await to_heading(pilot)
        await strike(pilot, "plus")
        await settled(pilot)
        await type_in(pilot, "9")
        await strike(pilot, "backspace")
        await pilot.pause()
        assert session.value(PLACE) is None and session.valid  # the table went with its last key …
        box = pilot.app.focused
        assert isinstance(box, Entry) and len(shown(pilot)) == 3  # … but not the field that is being edited
        await type_in(pilot, "80")
        assert session.value(PLACE) == {"peak_bar": 80.0}
        await strike(pilot, "backspace", "backspace")
        await strike(pilot, "shift+tab")
        await until(pilot, lambda: shown(pilot) == [])
        assert session.value(PLACE) is None and session.valid
        assert pilot.app.focused is heading_of(pilot)
        await strike(pilot, "plus")
        await settled(pilot)
        assert len(shown(pilot)) == 3 and heading_of(pilot).there


@pytest.mark.slow
async def test_what_is_not_understood_stays_in_sight(screen: Screen) -> None:
    async with screen() as pilot:
        session = work(pilot).session
        await to_heading(pilot)
        await strike(pilot, "plus")
        await settled(pilot)
        await type_in(pilot, "9")
        await strike(pilot, "tab")
        await type_in(pilot, "much")
        await strike(pilot, "shift+tab")
        await strike(pilot, "delete")
        await go_to(pilot, "engine.bore_mm")
        await settled(pilot)
        assert session.value(PLACE) is None and not session.valid and len(shown(pilot)) == 3
        await strike(pilot, "f7")
        await settled(pilot)
        assert work(pilot).form.here() == (*PLACE, "ratio")


@pytest.mark.slow
async def test_a_field_of_an_absent_table_leads_to_its_heading(screen: Screen) -> None:
    async with screen() as pilot:
        await work(pilot).to_field((*PLACE, "ratio"))
        await settled(pilot)
        assert work(pilot).form.here() == PLACE
        await strike(pilot, "up")
        await until(pilot, lambda: work(pilot).form.here() != PLACE)
        await strike(pilot, "down")
        await until(pilot, lambda: work(pilot).form.here() == PLACE)


@pytest.mark.slow
async def test_enter_adds_an_absent_table_and_goes_on_from_a_present_one(screen: Screen) -> None:
    async with screen() as pilot:
        session = work(pilot).session
        await to_heading(pilot)
        await until(pilot, lambda: "+ or Enter adds it" in " ".join(rows(pilot).split()))
        await strike(pilot, "enter")
        await settled(pilot)
        assert session.value(PLACE) == {} and work(pilot).form.here() == (*PLACE, "peak_bar")
        await type_in(pilot, "90")
        await settled(pilot)
        assert session.value(PLACE) == {"peak_bar": 90.0} and work(pilot).number == 1
        await to_heading(pilot)
        await until(
            pilot, lambda: "- takes it out" in (said := " ".join(rows(pilot).split())) and "adds it" not in said
        )
        await strike(pilot, "enter")
        await settled(pilot)
        assert session.value(PLACE) == {"peak_bar": 90.0} and work(pilot).form.here() == (*PLACE, "peak_bar")


@pytest.mark.slow
async def test_enter_adds_the_first_element_only(screen: Screen) -> None:
    async with screen() as pilot:
        await strike(pilot, "f3")
        await settled(pilot)
        session, form = work(pilot).session, work(pilot).form
        where = ("imbalance", "unbalances")
        form.focus_place(where)
        await until(pilot, lambda: form.here() == where)
        await strike(pilot, "enter")
        await settled(pilot)
        assert session.value(where) == [{}] and form.here() == (*where, 0, "name")
        form.focus_place(where)
        await until(pilot, lambda: form.here() == where)
        await strike(pilot, "enter")
        await settled(pilot)
        assert session.value(where) == [{}] and form.here() == (*where, 0, "name")


@pytest.mark.slow
async def test_help_is_about_the_heading(screen: Screen) -> None:
    async with screen() as pilot:
        await to_heading(pilot)
        await strike(pilot, "f1")
        await until(pilot, lambda: bool(pilot.app.screen.query("#help-here")))
        said = str(pilot.app.screen.query_one("#help-here", Static).content)
        assert (
            "Trial" in said
            and "engine.trial" in said
            and "What the test asks for." in said
            and "+ or Enter adds it" in said
        )


@pytest.mark.slow
async def test_the_heading_can_be_clicked(screen: Screen) -> None:
    async with screen() as pilot:
        heading = await to_heading(pilot)
        await at_rest(pilot)  # the form has scrolled there
        await pilot.click(heading, offset=(heading.render().plain.index("+"), 0))
        await until(pilot, lambda: work(pilot).session.value(PLACE) == {})
        assert work(pilot).session.value(PLACE) == {}


def test_an_added_table_is_saved_and_read_again(light: Session) -> None:
    light.put_table(PLACE, True)
    light.edit((*PLACE, "peak_bar"), "90")
    light.edit((*PLACE, "ratio"), "17.5")
    assert light.valid
    assert parse(light.bytes(), "saved").data == light.data
    light.save()
    assert light.value(PLACE) == {"peak_bar": 90.0, "ratio": 17.5} and not light.dirty
    light.put_table(PLACE, False)
    assert parse(light.bytes(), "saved").data == light.data and light.value(PLACE) is None


@pytest.mark.slow
async def test_the_first_element_of_an_array_begins_at_its_first_field(screen: Screen) -> None:
    async with screen() as pilot:
        screen_ = work(pilot)
        session = screen_.session
        await strike(pilot, "escape")
        await strike(pilot, "2")
        await settled(pilot)
        where = ("imbalance", "unbalances")
        screen_.form.focus_place(where)
        await pilot.pause()
        assert screen_.form.here() == where and session.value(where) is None
        await strike(pilot, "plus")
        await settled(pilot)
        assert session.value(where) == [{}] and screen_.form.here() == (*where, 0, "name")
        assert {reason for place, reason in session.reasons().items() if "is missing" not in reason} == set()
        await strike(pilot, "ctrl+z")
        await settled(pilot)
        assert session.value(where) is None and session.valid


@pytest.mark.slow
async def test_a_list_that_is_not_accepted_as_a_whole_says_so_at_its_heading(screen: Screen, light: Session) -> None:
    light.edit("engine.cylinders", "4")
    light.edit("engine.firing_order", "1; 3; 4; 2")
    async with screen() as pilot:
        await strike(pilot, "f7")
        await settled(pilot)
        heading = pilot.app.focused
        assert isinstance(heading, ArrayHeading) and heading.row.place == ("imbalance", "crank_bodies")
        await until(pilot, lambda: "! Bodies of the crank" in rows(pilot))
        assert "crankpins" in rows(pilot)
