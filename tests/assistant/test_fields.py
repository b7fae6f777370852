# SPDX-License-Identifier: Apache-2.0
"""The form, driven by keys: typing, undo, choices, arrays, the order of the fields."""

from typing import Any

import pytest
from textual import events

from assistant.session.guide import idle
from assistant.session.session import Session
from assistant.widgets.checks import Checks
from assistant.widgets.entry import Entry
from assistant.widgets.field import Field
from assistant.widgets.headings import ArrayHeading, Fold
from assistant.widgets.rows import ALL
from calc.design.addresses import address, asks, quantities, step_at
from calc.design.model import STEPS
from calc.sheet.text import Text
from tests.assistant.conftest import Screen, solved
from tests.assistant.driving import go_to, message, rows, settled, strike, told, type_in, until, work


def shown(pilot: Any, check: str) -> str:
    """The line of a check in the list of this step, which is unfolded where the check is folded."""
    work(pilot).query_one(Checks).go_to(check)
    return next(item.line for item in work(pilot).query_one(Checks).items if item.key == check)


# --- typing
async def test_typing_flips_a_check(screen: Screen) -> None:
    async with screen() as pilot:
        await go_to(pilot, "countershaft.masses.rear.mass_kg")
        assert shown(pilot, "countershaft.residual").startswith("pass")
        await type_in(pilot, "1,5")
        await solved(pilot)
        assert work(pilot).session.value("countershaft.masses.rear.mass_kg") == 1.5
        assert shown(pilot, "countershaft.residual").startswith("FAIL")
        assert "left over" in message(pilot)


@pytest.mark.slow
async def test_what_is_typed_in_one_burst_is_kept_whole(screen: Screen) -> None:
    """Also where the text comes back to what the design has, while the edits before it are still on their way."""
    async with screen() as pilot:
        box = await go_to(pilot, "countershaft.masses.front.mass_kg")
        for key in "2.691":
            pilot.app.post_message(events.Key({".": "full_stop"}.get(key, key), key))
        pilot.app.post_message(events.Key("down", None))
        await settled(pilot)
        await solved(pilot)
        assert work(pilot).session.value("countershaft.masses.front.mass_kg") == 2.691
        assert not box.has_focus and box.value == "2.691"


@pytest.mark.parametrize("key", ["enter", *(pytest.param(key, marks=pytest.mark.slow) for key in ("tab", "down"))])
async def test_what_is_typed_in_one_burst_goes_to_the_fields_that_it_was_typed_for(screen: Screen, key: str) -> None:
    async with screen() as pilot:
        box = await go_to(pilot, "engine.bore_mm")
        # the stroke, twice the crank radius
        for name in ("9", "6", key, "1", "0", "8", key, "1", "6", "0", "shift+tab", "1", "1", "0"):
            pilot.app.post_message(events.Key(name, name if len(name) == 1 else None))
        await settled(pilot)
        await solved(pilot)
        engine = work(pilot).session.data["engine"]
        assert (engine["bore_mm"], engine["crank_radius_mm"], engine["rod_length_mm"]) == (96.0, 55.0, 160.0)
        assert isinstance(box, Entry) and box.value == "96"


@pytest.mark.slow
async def test_a_burst_passes_over_what_is_no_text(screen: Screen) -> None:
    """Over two folds, and the layout, which is a choice."""
    async with screen() as pilot:
        await go_to(pilot, "engine.layout")
        await go_to(pilot, "engine.cylinder_pitch_mm")
        for name in ("9", "9", "down", "down", "down", "down", "down", "4"):
            pilot.app.post_message(events.Key(name, name if len(name) == 1 else None))
        await settled(pilot)
        await solved(pilot)
        engine = work(pilot).session.data["engine"]
        assert (engine["cylinders"], engine["cylinder_pitch_mm"]) == (4, 99.0)


async def test_a_comma_is_a_decimal_sign_and_the_field_is_rewritten(screen: Screen) -> None:
    async with screen() as pilot:
        box = await go_to(pilot, "engine.bore_mm")
        await type_in(pilot, "3,5")
        await pilot.pause()
        assert isinstance(box, Entry) and box.value == "3,5"
        assert "= 3.5" in rows(pilot)
        await strike(pilot, "enter")
        await pilot.pause()
        assert box.value == "3.5"
        assert work(pilot).session.value("engine.bore_mm") == 3.5


@pytest.mark.slow
async def test_another_unit(screen: Screen) -> None:
    async with screen() as pilot:
        box = await go_to(pilot, "engine.bore_mm")
        await type_in(pilot, "3.7 in")
        await strike(pilot, "tab")
        await pilot.pause()
        assert isinstance(box, Entry) and box.value == "93.98"


@pytest.mark.slow
async def test_what_is_not_understood_stays_with_the_reason(screen: Screen) -> None:
    async with screen() as pilot:
        box = await go_to(pilot, "engine.bore_mm")
        await type_in(pilot, "1,234")
        await solved(pilot)
        before = work(pilot).session.results
        await type_in(pilot, ".5")
        await pilot.pause(0.8)
        assert "ambiguous" in message(pilot)
        assert "write 1234.5" in rows(pilot)
        assert work(pilot).session.results is before
        assert work(pilot).query_one(Checks).stale
        await strike(pilot, "tab")
        await pilot.pause()
        assert isinstance(box, Entry) and box.value == "1,234.5"
        await strike(pilot, "ctrl+z")
        await pilot.pause()
        assert box.value == "94" and "bore_mm" not in message(pilot)


@pytest.mark.slow
async def test_undo_and_redo_from_another_step(screen: Screen) -> None:
    async with screen() as pilot:
        await go_to(pilot, "engine.bore_mm")
        await type_in(pilot, "95.5")
        await pilot.press("f3", "escape", "u")
        await settled(pilot)
        screen_ = work(pilot)
        assert screen_.number == 1
        assert screen_.session.value("engine.bore_mm") == 94.0
        # the next letter is a key again
        assert screen_.form.field is None and screen_.form.last == ("engine", "bore_mm")
        await strike(pilot, "u")
        assert "Nothing to undo" in told(pilot)
        await strike(pilot, "ctrl+y")
        await pilot.pause()
        assert screen_.session.value("engine.bore_mm") == 95.5


async def test_esc_takes_back_to_what_an_undo_has_left(screen: Screen) -> None:
    """And not to what stood there before it, which would write an undone value into the design once more."""
    key = "countershaft.masses.rear.mass_kg"
    async with screen() as pilot:
        box, session = await go_to(pilot, key), work(pilot).session
        first = session.value(key)
        await type_in(pilot, "1.5")
        await strike(pilot, "tab", "shift+tab")
        for travel, there in (("ctrl+z", first), ("ctrl+y", 1.5), ("ctrl+z", first)):
            await strike(pilot, travel)
            assert session.value(key) == there
        await strike(pilot, "x", "escape")
        await settled(pilot)
        assert isinstance(box, Entry) and box.value == session.text(session.place(key))
        assert session.value(key) == first and session.valid
        work(pilot).apply([f"{key}=1.7"], Text("taken"))  # as a remedy or a row of a table is
        await strike(pilot, "x", "escape")
        await settled(pilot)
        assert session.value(key) == 1.7


@pytest.mark.slow
async def test_shift_and_arrows_make_one_step(screen: Screen, session: Session) -> None:
    async with screen(session=session) as pilot:
        box = await go_to(pilot, "bearings.front.length_mm")
        await strike(pilot, "shift+up")
        assert box.value == "28"
        await pilot.press("shift+down", "shift+down")
        assert box.value == "27"
        choice = await go_to(pilot, "imbalance.kinematics")
        await strike(pilot, "shift+up")
        await pilot.pause()
        assert choice.value == "two_term" and work(pilot).session.value("imbalance.kinematics") == "two_term"


async def test_a_choice_is_made_from_a_list(screen: Screen, session: Session) -> None:
    async with screen(session=session) as pilot:
        box = await go_to(pilot, "bearings.oil")
        await strike(pilot, *"SAE", "space", "3", "0")
        await pilot.press("enter")
        await pilot.pause()
        await solved(pilot)
        assert work(pilot).form.here() == ("bearings", "supply_temperature_C")  # Enter takes the word, and goes on
        assert box.value == "SAE 30"
        assert work(pilot).session.value("bearings.oil") == "SAE 30"


@pytest.mark.slow
async def test_a_field_may_be_left_to_the_program(screen: Screen, session: Session) -> None:
    async with screen(session=session) as pilot:
        box = await go_to(pilot, "bearings.outlet_temperature_limit_C")
        await strike(pilot, "backspace")
        await strike(pilot, "tab")
        await pilot.pause()
        assert isinstance(box, Entry) and box.value == "" and box.placeholder == "135"
        assert work(pilot).session.value("bearings.outlet_temperature_limit_C") is None
        assert "(auto)" in rows(pilot)


# --- the form
@pytest.mark.slow
async def test_every_form_has_the_fields_of_the_file_once(screen: Screen, session: Session) -> None:
    async with screen(session=session) as pilot:
        for step in (step for step in STEPS if asks(session.data, step.key)):
            await work(pilot).open_step(step)
            form = work(pilot).form
            form.opened |= set(range(20))
            form.rebuild()
            await settled(pilot)
            shown = [field.place for field in form.query(Field) if field.row.kind == "field" and len(field.place) > 1]
            assert len(set(shown)) == len(shown) > 1
            known = [
                address(session.data, key)
                for key, _ in quantities(session.data)
                if step_at(session.data, key) == step.key
            ]
            hidden = [place for place in known if place not in shown and not idle(place, session.data)]
            absent = [place for place in hidden if not any(isinstance(part, int) and part > 0 for part in place)]
            for place in absent:  # not another element of a long array: then of a table that is left out
                assert any(
                    session.value(place[:end]) is None and session.about(place[:end]).optional
                    for end in range(2, len(place))
                ), place


@pytest.mark.slow
async def test_tab_goes_through_the_form_in_its_order(screen: Screen) -> None:
    async with screen() as pilot:
        await pilot.press("escape", "3")
        await pilot.pause()
        _, *stops = work(pilot).form.stops()  # behind the heading of the shafts
        await go_to(pilot, "countershaft.mode")
        for stop in stops:
            await until(pilot, lambda stop=stop: pilot.app.focused is stop)  # type: ignore[misc]
            await strike(pilot, "tab")
        await strike(pilot, "shift+tab")
        assert pilot.app.focused is stops[-1]
        for stop in reversed(stops[:-1]):
            await strike(pilot, "up")
            assert pilot.app.focused is stop
        await strike(pilot, "down")
        assert pilot.app.focused is stops[1]


@pytest.mark.slow
async def test_a_long_array_is_leafed_through_and_grows(screen: Screen, session: Session) -> None:
    async with screen(session=session) as pilot:
        await go_to(pilot, "gears.wheels.crank.teeth")
        while work(pilot).form.here() != ("gears", "wheels"):
            await strike(pilot, "up")
        await strike(pilot, "right")
        await settled(pilot)
        assert "2/4" in rows(pilot) and "[central " in rows(pilot)
        await strike(pilot, "plus")
        await settled(pilot)
        session = work(pilot).session
        assert [w["name"] for w in session.data["gears"]["wheels"]][-1] == "shaft-2"
        assert work(pilot).form.here() == ("gears", "wheels", 4, "name")
        await strike(pilot, "ctrl+z")
        await settled(pilot)
        assert len(session.data["gears"]["wheels"]) == 4


@pytest.mark.parametrize("size, rows_of_table", [pytest.param((120, 40), 5, marks=pytest.mark.slow), ((80, 24), 0)])
async def test_a_long_array_is_a_table_where_there_is_room(
    screen: Screen, session: Session, size: tuple[int, int], rows_of_table: int
) -> None:
    """What each element must have; the row that is shown is marked, and a click shows another."""
    async with screen(size=size, session=session) as pilot:
        await go_to(pilot, "gears.wheels.crank.teeth")
        heading = next(one for one in work(pilot).form.query(ArrayHeading) if one.row.place == ("gears", "wheels"))
        assert heading.size.height == 1 + rows_of_table
        if not rows_of_table:
            return
        told = [line.split() for line in heading.render().plain.splitlines()[1:]]
        assert told == [["Teeth"], ["▸", "crank", "25"], ["central", "36"], ["idler", "39"], ["shaft", "25"]]
        await pilot.click(heading, offset=(5, 4))
        await settled(pilot)
        assert "3/4 ▸" in rows(pilot)
        await go_to(pilot, "gears.wheels.idler.teeth")
        await type_in(pilot, "40")
        await settled(pilot)
        assert heading.cells()[3] == ("idler", "40") and heading.render().plain.splitlines()[4].split() == [
            "▸",
            "idler",
            "40",
        ]
        await pilot.resize_terminal(80, 24)
        await settled(pilot)
        assert heading.size.height == 1
        await pilot.resize_terminal(*size)
        await settled(pilot)
        assert heading.size.height == 1 + rows_of_table
        heading.focus()
        await strike(pilot, "plus")
        await settled(pilot)
        grown = next(one for one in work(pilot).form.query(ArrayHeading) if one.row.place == ("gears", "wheels"))
        assert grown.size.height == 1 + len(grown.cells()) == 2 + rows_of_table


@pytest.mark.slow
async def test_a_field_of_an_element_that_is_not_shown_is_found(screen: Screen, session: Session) -> None:
    async with screen(session=session) as pilot:
        await go_to(pilot, "gears.wheels.shaft.teeth")
        assert "4/4" in rows(pilot) and "[shaft " in rows(pilot)


@pytest.mark.slow
async def test_a_step_that_is_not_asked_can_be_added(session: Session, screen: Screen, memory: Any) -> None:
    import tomli_w

    data = {key: value for key, value in session.data.items() if key != "imbalance"}
    session.home.write_text(tomli_w.dumps(data), encoding="utf-8")
    other = Session.open(session.home, memory=memory)
    async with screen(session=other) as pilot:
        await pilot.press("escape", "2")
        await pilot.pause()
        assert "Which balancing?" in rows(pilot) and not work(pilot).form.query(Field)
        other.ask("imbalance")
        work(pilot).edited()
        await settled(pilot)
        await solved(pilot)
        assert "imbalance" in other.data
        assert work(pilot).form.query(Field)


@pytest.mark.slow
async def test_values_of_earlier_steps_lead_to_their_owner(screen: Screen) -> None:
    async with screen() as pilot:
        await pilot.press("escape", "3")
        await settled(pilot)
        work(pilot).form.opened.add(ALL)  # beside other panes they lie behind the one fold
        work(pilot).form.rebuild()
        await settled(pilot)
        work(pilot).form.stops()[-1].focus()
        await until(pilot, lambda: "← 1" in rows(pilot))  # the form is long, and has to scroll there
        await strike(pilot, "7")
        await settled(pilot)
        assert work(pilot).number == 1
        assert work(pilot).form.here() == ("engine", "rated_speed_rpm")


async def test_words_show_how_they_begin_and_a_mistake_is_told_without_its_key(screen: Screen) -> None:
    async with screen() as pilot:
        box = await go_to(pilot, "name")
        assert isinstance(box, Entry) and box.cursor_position == 0 and box.selected_text == box.value
        await strike(pilot, "x")
        assert box.value == "x"  # the first key replaces all of it
        await go_to(pilot, "engine.rod_length_mm")
        await type_in(pilot, "-5")
        await strike(pilot, "tab")
        await until(pilot, lambda: "greater than" in rows(pilot) or "must be" in rows(pilot))
        assert "rod_length_mm" not in rows(pilot) and "rod length: must be" in message(pilot)


@pytest.mark.slow
async def test_a_lone_digit_that_was_meant_for_a_step_changes_no_number(screen: Screen, light: Session) -> None:
    """F3 after it: the number stays, and it is said; Enter after it, or a second digit, means it."""
    async with screen() as pilot:
        for keys, bore in (("3",), 94.0), (("3", "enter"), 3.0), (("8", "3"), 83.0):
            await go_to(pilot, "engine.bore_mm")
            await strike(pilot, *keys, "f3")
            await until(pilot, lambda: work(pilot).number == 2)
            assert light.value("engine.bore_mm") == bore
            if bore == 94.0:
                assert "Bore stays 94: 3 was not accepted" in told(pilot)
            await strike(pilot, "f2")
            await until(pilot, lambda: work(pilot).number == 1)


async def test_enter_passes_over_what_says_nothing_of_a_kind(screen: Screen) -> None:
    """A bearing that rolls has no diameter of its own: Enter goes on to the other's, and to the size that is asked."""
    async with screen() as pilot:
        form = work(pilot).form
        await go_to(pilot, "shafts.shaft.bearings.front.kind")
        for keys in (("space",), ("r",), ("enter",)):
            await strike(pilot, *keys)
            await settled(pilot)
        places = [form.field.place if form.field is not None else None]
        for _ in range(3):
            await strike(pilot, "enter")
            await settled(pilot)
            places.append(form.field.place if form.field is not None else None)
        place = work(pilot).session.place
        assert len({*places}) == 4 and place("shafts.shaft.bearings.front.size") in places


async def test_a_fold_has_nothing_to_copy(screen: Screen) -> None:
    """It stands at no place of the design."""
    async with screen() as pilot:
        fold = work(pilot).form.query(Fold).first()
        fold.focus()
        await pilot.pause()
        await strike(pilot, "y")
        assert "nothing to copy" in told(pilot)
