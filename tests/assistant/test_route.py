# SPDX-License-Identifier: Apache-2.0
"""The form that leads: one question first, what decides it, the rest folded; typing that loses and overwrites
nothing."""

import pytest
from textual import events

from assistant.session.guide import fold_at, folds, idle
from assistant.session.session import Session
from assistant.widgets.entry import Entry
from assistant.widgets.field import Field, StrokeField
from assistant.widgets.form import GuideText
from assistant.widgets.headings import Fold
from assistant.widgets.radio import Balance, Todo
from assistant.widgets.rows import Asked, routed
from calc.design.labels import Place
from calc.design.model import STEPS
from calc.design.toml_file import read
from calc.studies.shipped import DESIGNS
from tests.assistant.conftest import Screen, solved
from tests.assistant.driving import go_to, rows, settled, strike, told, type_in, until, work

SIX = 6  # inputs that decide a step, at most
OF_ENGINE = 9  # whose masses are weighed: no rod is like that of another engine


def places(pilot: object) -> list[Place]:
    return [field.row.place for field in work(pilot).form.query(Field)]  # type: ignore[arg-type]


def test_an_input_lies_where_it_says_and_else_where_its_table_lies() -> None:
    assert fold_at("engine", ("engine", "bore_mm"), {}) is None
    assert fold_at("engine", ("engine", "flywheel_inertia_kgm2"), {}) == 0
    assert fold_at("gears", ("gears", "wheels", 0, "teeth"), {}) is None
    assert fold_at("gears", ("gears", "wheels", 0, "quality"), {}) == 1
    assert fold_at("gears", ("gears", "+1"), {}) is None, "a fold lies in none"
    assert folds("gears") == ("More", "More of the wheels", "More of the meshes", "The drive over speed")


def test_what_says_nothing_beside_a_choice_is_not_asked_for_unless_it_has_a_value() -> None:
    width = ("bearings", "groove_width_mm")
    assert idle(width, {"bearings": {"supply": "hole"}}) and idle(width, {"bearings": {}})
    assert not idle(width, {"bearings": {"supply": "groove"}})
    assert not idle(width, {"bearings": {"supply": "hole", "groove_width_mm": 3.0}})
    assert idle(("engine", "bank_angle_deg"), {"engine": {}}) and not idle(("engine", "bore_mm"), {"engine": {}})


@pytest.mark.parametrize("key", ["engine", "imbalance", "countershaft", "bearings", "friction", "mounting"])
def test_what_decides_a_step_is_seen_at_one_glance(key: str) -> None:
    """The gears, with their wheels and meshes, need more."""
    data = read(DESIGNS / "r753ie4_mounting.toml").data
    step = next(step for step in STEPS if step.key == key)
    asked = routed(step, data, Asked({}, side=2), ())
    kinds, first = ("field", "stroke", "array"), 2 if key == "countershaft" else 1  # behind the step, or its shaft
    names = {row.place[first] for row in asked if row.kind in kinds and len(row.place) > first}
    rows_of_tables = {row.place[-1] for row in asked if row.kind == "cells"} if key != "countershaft" else set()
    decide = (names | rows_of_tables) - {"kind"}  # which of them there are
    assert 2 <= len(decide) <= (OF_ENGINE if key == "engine" else SIX)  # beside the design's name


async def test_a_fold_opens_stays_open_and_opens_for_a_field_that_is_sought(screen: Screen) -> None:
    async with screen() as pilot:
        await go_to(pilot, "engine.bore_mm")
        assert "Which engine shakes?" in rows(pilot) and ("engine", "flywheel_inertia_kgm2") not in places(pilot)
        more = work(pilot).form.query_one(Fold)  # beside other panes all of them stand behind one
        assert len(more.row.inside) > 30 and "From earlier" not in more.explained()[1]
        more.focus()
        await strike(pilot, "enter")
        await settled(pilot)
        assert len(work(pilot).form.query(Fold)) > 2
        fold = next(one for one in work(pilot).form.query(Fold) if one.row.place == ("engine", "+0"))
        fold.focus()
        await strike(pilot, "enter")
        await settled(pilot)
        assert ("engine", "flywheel_inertia_kgm2") in places(pilot) and "assumed (" in rows(pilot)
        await strike(pilot, "left")
        await settled(pilot)
        assert ("engine", "flywheel_inertia_kgm2") not in places(pilot) and pilot.app.focused is fold
        await go_to(pilot, "engine.flywheel_inertia_kgm2")
        await go_to(pilot, "engine.firing_order")
        assert ("engine", "bank_angle_deg") not in places(pilot)  # an inline engine has none


@pytest.mark.slow
async def test_a_field_is_never_typed_into_unseen(screen: Screen) -> None:
    """Whatever grows above it."""
    async with screen(size=(80, 24)) as pilot:
        await go_to(pilot, "engine.bore_mm")
        form = work(pilot).form
        assert form.field is not None and form.field.region in form.region
        form.query_one(GuideText).styles.height = 40
        await until(pilot, lambda: form.scroll_y > 0 and form.field is not None and form.field.region in form.region)


@pytest.mark.slow
async def test_keys_that_follow_a_jump_into_a_fold_are_not_lost(screen: Screen) -> None:
    async with screen() as pilot:
        bench = work(pilot)
        await bench.to_field(("engine", "flywheel_inertia_kgm2"))
        await type_in(pilot, "0.61")
        await settled(pilot)
        assert bench.number == 1 and bench.session.value("engine.flywheel_inertia_kgm2") == 0.61


@pytest.mark.slow
async def test_the_stroke_is_twice_the_crank_radius(screen: Screen) -> None:
    async with screen() as pilot:
        await go_to(pilot, "engine.bore_mm")
        await strike(pilot, "enter")
        assert isinstance(work(pilot).form.field, StrokeField)
        await type_in(pilot, "92,4")
        await strike(pilot, "enter")
        await settled(pilot)
        assert work(pilot).session.value("engine.crank_radius_mm") == 46.2
        await go_to(pilot, "engine.crank_radius_mm")
        assert [field.box.value for field in work(pilot).form.query(Field) if field.place[-1] == "crank_radius_mm"] == [
            "92.4",
            "46.2",
        ]


@pytest.mark.slow
async def test_escape_gives_the_old_text_back_and_a_second_one_leaves(screen: Screen) -> None:
    async with screen() as pilot:
        box = await go_to(pilot, "engine.bore_mm")
        await type_in(pilot, "9")
        await settled(pilot)
        assert "was 94" in rows(pilot) and "✎Bore" in rows(pilot)
        await strike(pilot, "escape")
        await settled(pilot)
        assert box.value == "94" and box.has_focus and work(pilot).session.value("engine.bore_mm") == 94.0
        assert not work(pilot).session.dirty
        await strike(pilot, "escape")
        assert not box.has_focus


async def test_what_is_pasted_in_several_lines_fills_the_fields_one_after_the_other(screen: Screen) -> None:
    async with screen() as pilot:
        box = await go_to(pilot, "engine.rod_length_mm")
        assert isinstance(box, Entry)
        box.post_message(events.Paste("160\n1100\t990\n"))
        await settled(pilot)
        engine = work(pilot).session.data["engine"]
        assert (engine["rod_length_mm"], engine["piston_mass_g"], engine["rod_mass_g"]) == (160.0, 1100.0, 990.0)
        await go_to(pilot, "engine.firing_order")
        pilot.app.focused.post_message(events.Paste("1\n2\n3"))  # type: ignore[union-attr]
        await settled(pilot)
        assert work(pilot).session.value("engine.firing_order") == [1, 2, 3]


async def test_a_field_is_locked_by_its_key(screen: Screen) -> None:
    async with screen() as pilot:
        await go_to(pilot, "engine.bore_mm")
        await strike(pilot, "ctrl+l")
        await settled(pilot)
        assert work(pilot).session.lock_reason("engine.bore_mm") and "locked" in rows(pilot)
        assert work(pilot).session.value("engine.bore_mm") == 94.0


@pytest.mark.slow
async def test_the_row_that_is_called_for_keeps_its_mark_where_there_is_little_room(screen: Screen) -> None:
    async with screen() as pilot:
        await pilot.press("escape", "2")
        balance = work(pilot).form.query_one(Balance)
        await until(pilot, lambda: balance.key == "shaft")
        wide, close = ([item.line for item in balance.build(width)] for width in (60, 42))
        assert [" kg ◀" in row for row in wide] == ["◀" in row for row in close] and sum(
            "◀" in row for row in close
        ) == 1
        assert all(len(row) <= 42 for row in close if "◀" in row)


@pytest.mark.slow
async def test_a_balancing_is_taken_as_one_step(screen: Screen, light: Session) -> None:
    async with screen() as pilot:
        await pilot.press("escape", "2")
        balance = work(pilot).form.query_one(Balance)
        await until(pilot, lambda: balance.key == "shaft")  # the one that the design has
        before = light.data
        balance.focus()
        await strike(pilot, "up")
        await until(pilot, lambda: balance.key != "shaft")
        await strike(pilot, "enter")
        await until(pilot, lambda: light.data is not before)
        await solved(pilot)
        assert "countershaft" not in light.data and light.data["imbalance"]["crank_balance_fraction"] == 0.5
        assert light.undo() is not None and light.data == before and "locked" not in told(pilot)


async def test_a_step_that_was_built_is_left_by_the_next_enter(screen: Screen, light: Session) -> None:
    """Also where it can not be judged before the one after it is built: the line below says so."""
    assert not light.ask("bearings")
    async with screen(size=(120, 40)) as pilot:
        bench = work(pilot)
        await bench.action_to_step(5)
        bench.form.focus_place(None, at_once=True)
        bench._built(light, "gears", light.plan("gears"))
        assert bench.focused is bench.form  # at once: keys may be waiting
        await until(pilot, lambda: "Enter goes on: 6 Friction is to do." in rows(pilot))
        await settled(pilot)
        await strike(pilot, "enter")
        await until(pilot, lambda: bench.number == 6)


@pytest.mark.slow
async def test_the_document_control_is_asked_for_below_the_name(screen: Screen) -> None:
    async with screen() as pilot:
        bench = work(pilot)
        await bench.to_field(("document", "number"))
        await type_in(pilot, "CS-1")
        await settled(pilot)
        session = bench.session
        assert bench.number == 1 and session.value("document.number") == "CS-1" and "assumed" not in rows(pilot)
        assert "2026-03-14" in str(session.edit("document.prepared.date", "14.3.2026")) and not session.valid
        assert not session.edit("document.prepared.date", "2026-03-14") and session.valid
        assert b"date = 2026-03-14" in session.bytes() and b'number = "CS-1"' in session.bytes()


async def test_what_can_not_be_built_yet_says_why(screen: Screen, light: Session) -> None:
    assert not light.ask("countershaft", "none")
    async with screen() as pilot:
        await pilot.press("escape", "3", "escape", "f3")
        await settled(pilot)
        assert work(pilot).number == 4 and "not built by rules: there is no shaft" in rows(pilot)


@pytest.mark.slow
async def test_the_choice_of_a_step_that_was_turned_to_takes_the_next_enter(screen: Screen) -> None:
    async with screen() as pilot:
        await pilot.press("escape", "3", "escape", "f3")
        await settled(pilot)
        assert work(pilot).number == 4 and pilot.app.focused is work(pilot).form.query_one(Todo)
