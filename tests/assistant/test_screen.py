# SPDX-License-Identifier: Apache-2.0
"""The guided session, driven by keys."""

import asyncio
import random
from pathlib import Path
from typing import Any

import pytest
from textual import events
from textual.keys import _character_to_key
from textual.pilot import Pilot
from textual.widgets import Input

from assistant.actions import ACTIONS
from assistant.screens.workbench import Workbench
from assistant.session import Session
from assistant.widgets.calculation import Calculation
from assistant.widgets.checks import Checks
from assistant.widgets.choice import Choice
from assistant.widgets.curve_pane import CurvePane
from assistant.widgets.entry import Entry
from assistant.widgets.field import Field
from assistant.widgets.message_line import MessageLine
from calc.design import STEPS
from calc.design_file import address, quantities

from .conftest import Screen, solved

CHARACTERS = {"question_mark": "?", "left_square_bracket": "[", "right_square_bracket": "]", "colon": ":", "plus": "+", "minus": "-", "space": " "}


def work(pilot: Pilot[int]) -> Workbench:
    screen = pilot.app.screen
    assert isinstance(screen, Workbench)
    return screen


def message(pilot: Pilot[int]) -> str:
    return work(pilot).query_one(MessageLine).message()[1]


def told(pilot: Pilot[int]) -> str:
    return "\n".join(str(note.message) for note in pilot.app._notifications)


async def go_to(pilot: Pilot[int], key: str) -> Entry | Choice:
    """Put the focus on a field by its key."""
    screen = work(pilot)
    await screen.to_field(screen.session.place(key))
    await settled(pilot)
    assert screen.form.field is not None and screen.form.field.place == screen.session.place(key)
    return screen.form.field.box


async def settled(pilot: Pilot[int]) -> None:
    """Wait until a form that is being made anew stands there."""
    for _ in range(3):
        await pilot.pause()
        await pilot.app.workers.wait_for_complete([w for w in pilot.app.workers if w.group.startswith("form-")])
    await pilot.pause()


async def strike(pilot: Pilot[int], *keys: str) -> None:
    """Keys as quickly as they come, without waiting for the screen in between."""
    driver = pilot.app._driver
    assert driver is not None
    for name in keys:
        key = _character_to_key(name) if len(name) == 1 else name
        character = name if len(name) == 1 else CHARACTERS.get(name)
        event = events.Key(key, character)
        event.set_sender(pilot.app)
        driver.send_message(event)
        await asyncio.sleep(0)
    await pilot.pause()


async def type_in(pilot: Pilot[int], text: str) -> None:
    await strike(pilot, *text)


def rows(pilot: Pilot[int]) -> str:
    """The screen as text."""
    return "\n".join("".join(segment.text for segment in strip) for strip in work(pilot)._compositor.render_strips())


# --- typing
async def test_typing_flips_a_check(screen: Screen) -> None:
    async with screen() as pilot:
        await go_to(pilot, "countershaft.masses.rear.mass_kg")
        assert work(pilot).query_one(Checks).items[1].line.startswith("pass")
        await type_in(pilot, "1,5")
        await solved(pilot)
        assert work(pilot).session.value("countershaft.masses.rear.mass_kg") == 1.5
        assert work(pilot).query_one(Checks).items[1].line.startswith("FAIL")
        assert "left over" in message(pilot)


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


async def test_another_unit(screen: Screen) -> None:
    async with screen() as pilot:
        box = await go_to(pilot, "engine.bore_mm")
        await type_in(pilot, "3.7 in")
        await strike(pilot, "tab")
        await pilot.pause()
        assert isinstance(box, Entry) and box.value == "93.98"


async def test_what_is_not_understood_stays_with_the_reason(screen: Screen) -> None:
    async with screen() as pilot:
        box = await go_to(pilot, "engine.bore_mm")
        await type_in(pilot, "1,234")
        await solved(pilot)
        before = work(pilot).session.results
        await type_in(pilot, ".5")
        await pilot.pause(0.8)
        assert "ambiguous" in message(pilot)
        assert "bore_mm" in rows(pilot) and "write 1234.5" in rows(pilot)
        assert work(pilot).session.results is before
        assert work(pilot).query_one(Checks).stale
        await strike(pilot, "escape")
        await pilot.pause()
        assert isinstance(box, Entry) and box.value == "1,234.5"
        await strike(pilot, "ctrl+z")
        await pilot.pause()
        assert box.value == "94" and "bore_mm" not in message(pilot)


async def test_undo_and_redo_from_another_step(screen: Screen) -> None:
    async with screen() as pilot:
        await go_to(pilot, "engine.bore_mm")
        await type_in(pilot, "95.5")
        await pilot.press("f3", "escape", "u")
        await settled(pilot)
        screen_ = work(pilot)
        assert screen_.number == 1
        assert screen_.session.value("engine.bore_mm") == 94.0
        assert screen_.form.field is not None and screen_.form.field.box.value == "94"
        await strike(pilot, "ctrl+y")
        await pilot.pause()
        assert screen_.session.value("engine.bore_mm") == 95.5


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
        await strike(pilot, "enter")
        await pilot.pause()
        await pilot.press(*"SAE")
        await pilot.press("space", "3", "0", "enter")
        await pilot.pause()
        await solved(pilot)
        assert box.value == "SAE 30"
        assert work(pilot).session.value("bearings.oil") == "SAE 30"


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
async def test_every_form_has_the_fields_of_the_file_in_their_order(screen: Screen, session: Session) -> None:
    async with screen(session=session) as pilot:
        for step in STEPS:
            await work(pilot).open_step(step)
            await pilot.pause()
            shown = [field.place for field in work(pilot).form.query(Field)]
            known = [address(session.data, key) for key, _ in quantities(session.data) if key.partition(".")[0] == step.key]
            assert [place for place in known if place in shown] == shown
            hidden = [place for place in known if place not in shown]
            assert all(any(isinstance(part, int) and part > 0 for part in place) for place in hidden)  # other elements of a long array
            assert len(shown) > 1


async def test_tab_goes_through_the_form_in_its_order(screen: Screen) -> None:
    async with screen() as pilot:
        await pilot.press("escape", "3")
        await pilot.pause()
        stops = work(pilot).form.stops()
        await go_to(pilot, "countershaft.mode")
        for stop in stops:
            assert pilot.app.focused is stop
            await strike(pilot, "tab")
        await strike(pilot, "shift+tab")
        assert pilot.app.focused is stops[-1]
        for stop in reversed(stops[:-1]):
            await strike(pilot, "up")
            assert pilot.app.focused is stop
        await strike(pilot, "down")
        assert pilot.app.focused is stops[1]


async def test_a_long_array_is_leafed_through_and_grows(screen: Screen, session: Session) -> None:
    async with screen(session=session) as pilot:
        await go_to(pilot, "gears.wheels.crank.teeth")
        while work(pilot).form.here() != ("gears", "wheels"):
            await strike(pilot, "up")
        await strike(pilot, "right")
        await settled(pilot)
        assert "2 of 4 central" in rows(pilot)
        await strike(pilot, "plus")
        await settled(pilot)
        session = work(pilot).session
        assert [w["name"] for w in session.data["gears"]["wheels"]][-1] == "shaft-2"
        assert work(pilot).form.here() == ("gears", "wheels", 4, "name")
        await strike(pilot, "ctrl+z")
        await settled(pilot)
        assert len(session.data["gears"]["wheels"]) == 4


async def test_a_field_of_an_element_that_is_not_shown_is_found(screen: Screen, session: Session) -> None:
    async with screen(session=session) as pilot:
        await go_to(pilot, "gears.wheels.shaft.teeth")
        assert "4 of 4 shaft" in rows(pilot)


async def test_a_step_that_is_not_asked_can_be_added(session: Session, screen: Screen, memory: Any) -> None:
    import tomli_w

    data = {key: value for key, value in session.data.items() if key != "imbalance"}
    session.home.write_text(tomli_w.dumps(data), encoding="utf-8")
    other = Session.open(session.home, memory=memory)
    async with screen(session=other) as pilot:
        await pilot.press("escape", "2")
        await pilot.pause()
        assert "has no step Imbalance" in rows(pilot)
        await strike(pilot, "enter")
        await settled(pilot)
        await solved(pilot)
        assert "imbalance" in other.data
        assert work(pilot).form.query(Field)


async def test_values_of_earlier_steps_lead_to_their_owner(screen: Screen) -> None:
    async with screen() as pilot:
        await pilot.press("escape", "3")
        await pilot.pause()
        work(pilot).form.stops()[-1].focus()
        await pilot.pause()
        assert "← 1" in rows(pilot)
        await strike(pilot, "7")
        await settled(pilot)
        assert work(pilot).number == 1
        assert work(pilot).form.here() == ("engine", "rated_speed_rpm")


# --- steps, panes, checks
async def test_steps_forward_back_and_by_number(screen: Screen) -> None:
    async with screen() as pilot:
        for key, number in (("f3", 2), ("pagedown", 3), ("f2", 2), ("pageup", 1), ("f2", 1), ("escape", 1), ("6", 6), ("right_square_bracket", 6),
                            ("left_square_bracket", 5), ("4", 4)):  # fmt: skip
            await strike(pilot, key)
            await pilot.pause()
            assert work(pilot).number == number, key


async def test_the_next_fault_and_its_line(screen: Screen, session: Session) -> None:
    async with screen(session=session) as pilot:
        results = work(pilot).session.results
        assert results is not None
        failing = [(n, c.id) for n, s in enumerate(STEPS, 1) for c in results.outcomes[s.key].checks if c.verdict == "fail"]
        assert len(failing) > 1
        seen = []
        for _ in failing:
            await strike(pilot, "f7")
            await settled(pilot)
            seen.append((work(pilot).number, work(pilot).query_one(Checks).key))
        assert set(seen) == set(failing)
        await strike(pilot, "enter")
        await settled(pilot)
        calculation = work(pilot).query_one(Calculation)
        assert calculation.has_focus and calculation.item is not None
        entry = next(e for e in calculation.sheet.entries if e.number == calculation.key)
        assert seen[-1][1] in {c.id for c in entry.checks}


async def test_the_cursor_stays_on_its_check_when_the_results_change(screen: Screen, session: Session) -> None:
    async with screen(session=session) as pilot:
        await go_to(pilot, "bearings.front.length_mm")
        checks = work(pilot).query_one(Checks)
        checks.go_to("bearings.rear.specific_load")
        await pilot.pause()
        await type_in(pilot, "40")
        await solved(pilot)
        assert checks.key == "bearings.rear.specific_load"


async def test_panes_in_turn(screen: Screen) -> None:
    async with screen() as pilot:
        seen = [work(pilot).pane]
        for _ in range(5):
            await strike(pilot, "f6")
            await pilot.pause()
            seen.append(work(pilot).pane)
        assert seen == ["inputs", "checks", "calculation", "curve", "steps", "inputs"]
        await strike(pilot, "shift+f6")
        assert work(pilot).pane == "steps"
        await pilot.press("down", "enter")
        await pilot.pause()
        assert work(pilot).number == 2


async def test_a_pane_is_made_large_and_small(screen: Screen) -> None:
    async with screen() as pilot:
        await pilot.press("f6", "f6", "f4")
        await pilot.pause()
        assert work(pilot).query_one("#calculation").size.width == 110
        assert not work(pilot).query_one("#inputs").display
        await strike(pilot, "f4")
        await pilot.pause()
        assert work(pilot).query_one("#inputs").display


async def test_narrow_shows_one_view_after_the_other(screen: Screen) -> None:
    async with screen(size=(80, 24)) as pilot:
        for view in ("checks", "calculation", "curve", "inputs"):
            await strike(pilot, "f4")
            await pilot.pause()
            shown = [pane.id for pane in work(pilot).query(".pane") if pane.display]
            assert shown == [view]


async def test_resizing_keeps_the_focus_and_the_text(screen: Screen) -> None:
    async with screen() as pilot:
        box = await go_to(pilot, "engine.bore_mm")
        await type_in(pilot, "95")
        await pilot.resize_terminal(80, 24)
        await pilot.pause()
        assert pilot.app.focused is box
        await type_in(pilot, ".5")
        await pilot.resize_terminal(120, 40)
        await pilot.pause()
        assert pilot.app.focused is box and box.value == "95.5"
        await strike(pilot, "f6")
        await pilot.pause()
        focused = pilot.app.focused
        await pilot.resize_terminal(80, 24)
        await pilot.pause()
        assert pilot.app.focused is focused


async def test_curves_in_turn(screen: Screen) -> None:
    async with screen() as pilot:
        await pilot.press("escape", "2")
        await pilot.pause()
        pane = work(pilot).query_one(CurvePane)
        first = pane.curve
        await strike(pilot, "c")
        await pilot.pause()
        assert pane.curve is not first and pane.curve is not None
        assert "2 of 3" in rows(pilot)
        await pilot.press("f9", "f9")
        assert pane.curve is first


async def test_the_sources_errors_and_the_assumptions_stand_in_the_calculation(screen: Screen) -> None:
    async with screen() as pilot:
        await pilot.press("escape", "2")
        await pilot.pause()
        calculation = work(pilot).query_one(Calculation)
        text = "\n".join(row.plain for item in calculation.items for row in item.rows)
        assert "the source has 188" in text
        assert "The torque reaction" in text.replace("\n", " ")
        assert "1 erratum · 2 assumed" in calculation.position()


async def test_square_brackets_are_no_markup(screen: Screen) -> None:
    async with screen() as pilot:
        await go_to(pilot, "engine.name")
        await type_in(pilot, "[red]x[/] [")
        await settled(pilot)
        assert "[[red]x[/] [" in rows(pilot).replace("[red]x[/] [", "[[red]x[/] [", 1)
        assert work(pilot).session.value("engine.name") == "[red]x[/] ["
        pilot.app.tell("[not markup")  # type: ignore[attr-defined]
        await pilot.press("ctrl+s", "f1")
        await pilot.pause()


# --- letters
async def test_no_key_fires_while_typing(screen: Screen) -> None:
    async with screen() as pilot:
        box = await go_to(pilot, "engine.name")
        assert isinstance(box, Input)
        box.value = ""
        letters = [key for action in ACTIONS for key in action.letters.split(",") if key]
        before = (work(pilot).number, work(pilot).pane, pilot.app.screen)
        await strike(pilot, *letters)
        await pilot.pause()
        assert (work(pilot).number, work(pilot).pane, pilot.app.screen) == before
        assert len(box.value) == len(letters)


async def test_letters_act_after_escape(screen: Screen) -> None:
    async with screen() as pilot:
        await strike(pilot, "escape")
        assert pilot.app.focused is work(pilot).form
        await strike(pilot, "3")
        await pilot.pause()
        assert work(pilot).number == 3 and pilot.app.focused is work(pilot).form
        await strike(pilot, "j")
        await pilot.pause()
        assert work(pilot).form.field is not None


async def test_copying(screen: Screen) -> None:
    async with screen() as pilot:
        await pilot.press("f6", "y")
        assert pilot.app.clipboard == "0.3282"
        await pilot.press("Y")
        assert pilot.app.clipboard.startswith("pass: Crank ratio λ 0.3282")
        await pilot.press("f6", "j", "Y")
        assert pilot.app.clipboard.startswith("M_alt = M_P + M_ra = 1.178")
        await strike(pilot, "y")
        assert pilot.app.clipboard == "1489 g"
        await go_to(pilot, "engine.bore_mm")
        await pilot.press("escape", "y")
        assert pilot.app.clipboard == "94 mm"


# --- files
async def test_saving(screen: Screen, light: Session) -> None:
    async with screen() as pilot:
        await go_to(pilot, "engine.bore_mm")
        await type_in(pilot, "95")
        await strike(pilot, "ctrl+s")
        await pilot.pause()
        saved = light.home.read_bytes()
        assert b"bore_mm = 95.0\n" in saved and str(light.home) in told(pilot)
        assert "edited" not in rows(pilot).splitlines()[0]
        await pilot.press("backspace", "backspace", "0", "ctrl+s", "f8")
        await pilot.pause()
        assert "not saved" in told(pilot) and light.home.read_bytes() == saved
        assert "No report" in told(pilot)


async def test_save_as(screen: Screen, tmp_path: Path) -> None:
    async with screen() as pilot:
        await pilot.press("escape", "W")
        await pilot.pause()
        box = pilot.app.screen.query_one("#path", Input)
        box.value = str(tmp_path / "no" / "other")
        await strike(pilot, "enter")
        await pilot.pause()
        assert "does not exist" in str(pilot.app.screen.query_one("#wrong").render())
        box.value = str(tmp_path / "other")
        await strike(pilot, "enter")
        await settled(pilot)
        assert (tmp_path / "other.toml").is_file()
        assert work(pilot).session.path == tmp_path / "other.toml"


async def test_save_as_asks_before_it_overwrites(screen: Screen, tmp_path: Path) -> None:
    (tmp_path / "other.toml").write_text("theirs")
    async with screen() as pilot:
        await strike(pilot, "f12")
        await pilot.pause()
        pilot.app.screen.query_one("#path", Input).value = str(tmp_path / "other.toml")
        await strike(pilot, "enter")
        await pilot.pause()
        assert (tmp_path / "other.toml").read_text() == "theirs"
        await strike(pilot, "enter")
        await settled(pilot)
        assert (tmp_path / "other.toml.bak").read_text() == "theirs"


async def test_a_file_changed_by_another_program_needs_a_second_save(screen: Screen, light: Session) -> None:
    async with screen() as pilot:
        await go_to(pilot, "engine.bore_mm")
        await type_in(pilot, "95")
        light.home.write_text(light.home.read_text(encoding="utf-8") + "# theirs\n", encoding="utf-8")
        await strike(pilot, "ctrl+s")
        await pilot.pause()
        assert "another program" in told(pilot) and "bore_mm = 94.0" in light.home.read_text(encoding="utf-8")
        await strike(pilot, "ctrl+s")
        await pilot.pause()
        assert "bore_mm = 95.0" in light.home.read_text(encoding="utf-8")


async def test_opening(screen: Screen, tmp_path: Path, design: Path) -> None:
    (tmp_path / "broken.toml").write_text("schema = 1\nname = 3\n")
    (tmp_path / "second.toml").write_bytes(design.read_bytes().replace(b"bore_mm = 94.0", b"bore_mm = 99.0"))
    async with screen() as pilot:
        await strike(pilot, "ctrl+o")
        await pilot.pause()
        dialog = pilot.app.screen
        box = dialog.query_one("#path", Input)
        box.value = str(tmp_path / "broken.toml")
        await strike(pilot, "enter")
        await pilot.pause()
        assert pilot.app.screen is dialog and "name" in str(dialog.query_one("#wrong").render())
        box.value = str(tmp_path) + "/sec"
        await pilot.pause()
        await pilot.press("down", "enter")
        await settled(pilot)
        await solved(pilot)
        assert work(pilot).session.value("engine.bore_mm") == 99.0


async def test_edits_are_kept_when_the_program_ends(screen: Screen, light: Session, memory: Any) -> None:
    async with screen() as pilot:
        await go_to(pilot, "engine.bore_mm")
        await type_in(pilot, "95")
        await strike(pilot, "ctrl+q")
        await pilot.pause()
        assert pilot.app.return_code == 0
    assert Session.open(light.home, memory=memory).value("engine.bore_mm") == 95.0


async def test_only_what_can_not_be_kept_is_asked_about(screen: Screen) -> None:
    async with screen() as pilot:
        await go_to(pilot, "engine.bore_mm")
        await type_in(pilot, "0")
        await strike(pilot, "ctrl+q")
        await pilot.pause()
        assert not isinstance(pilot.app.screen, Workbench)
        await strike(pilot, "n")
        await pilot.pause()
        assert isinstance(pilot.app.screen, Workbench)
        await strike(pilot, "ctrl+q")
        await pilot.pause()
        await strike(pilot, "y")
        await pilot.pause()
        assert pilot.app.return_code == 0


async def test_a_read_only_file_asks_for_another_name(screen: Screen, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Session, "read_only", property(lambda self: True))
    async with screen() as pilot:
        assert "read-only" in rows(pilot).splitlines()[0]
        await strike(pilot, "ctrl+s")
        await pilot.pause()
        assert pilot.app.screen.query("#path")


# --- report
async def test_the_report(screen: Screen, light: Session, monkeypatch: pytest.MonkeyPatch) -> None:
    import sys
    from types import ModuleType

    stub = ModuleType("reports.report")

    def write(document: Any, results: Any, raw: bytes, path: Path, depth: str = "") -> None:
        assert document.data["engine"]["bore_mm"] == 95.0 and b"bore_mm = 95.0" in raw and results.design.engine.bore == 0.095
        path.write_bytes(b"%PDF-" + depth.encode())

    stub.write = write  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "reports.report", stub)
    async with screen() as pilot:
        await go_to(pilot, "engine.bore_mm")
        await type_in(pilot, "95")
        await strike(pilot, "f8")  # before the results are there
        for _ in range(50):
            await pilot.pause(0.05)
            if "PDF report:" in told(pilot):
                break
        path = light.home.with_suffix(".pdf")
        assert path.read_bytes() == b"%PDF-engineer" and str(path) in told(pilot)
        monkeypatch.setattr(stub, "write", lambda *_, **__: (_ for _ in ()).throw(PermissionError(13, "Permission denied")))
        await strike(pilot, "f8")
        for _ in range(50):
            await pilot.pause(0.05)
            if "Permission denied" in told(pilot):
                break
        assert "can not be written" in told(pilot)


# --- terminals
async def test_plain_signs(screen: Screen, session: Session) -> None:
    async with screen(session=session, ascii=True) as pilot:
        await pilot.press("escape", "4")
        await settled(pilot)
        text = rows(pilot)
        assert "x FAIL" in text and not set("✓▲✗●◌▸◀▼━┃") & set(text)


@pytest.mark.parametrize("environment", [{"NO_COLOR": "1"}, {"TEXTUAL_THEME": "ansi-dark"}, {"TEXTUAL_THEME": "textual-light"}])
async def test_other_colours(session: Session, monkeypatch: pytest.MonkeyPatch, environment: dict[str, str]) -> None:
    from assistant.app import ContralberoApp

    session.solve()
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    app = ContralberoApp(session)
    app.theme = environment.get("TEXTUAL_THEME", app.theme)
    async with app.run_test(size=(120, 40)) as pilot:
        await solved(pilot)
        await pilot.press("escape", "4")
        await pilot.pause(0.05)
        assert "FAIL" in rows(pilot)


async def test_a_tiny_terminal_says_so(screen: Screen) -> None:
    async with screen(size=(44, 12)) as pilot:
        assert "needs 60 columns" in rows(pilot)
        await pilot.press("f4", "f4", "f4", "f3")
        await pilot.pause()


async def test_any_keys_in_any_order(screen: Screen, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A hundred keys at random: nothing may go wrong."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("assistant.screens.doing.Doing.action_report", lambda self: None)
    draw = random.Random(7)
    keys = [key for action in ACTIONS for key in action.binding.split(",") if action.id not in ("quit",)]
    keys += ["tab", "shift+tab", "backspace", "left", "right", "plus", "minus", "1", "2", "5", "e", "x", "space", "delete", "home", "ctrl+k", ".", ","]
    async with screen(size=(100, 30)) as pilot:
        for _ in range(20):
            await strike(pilot, *(draw.choice(keys) for _ in range(6)))
        for size in [(80, 24), (120, 40), (50, 15), (160, 45)]:
            await pilot.resize_terminal(*size)
            await strike(pilot, *(draw.choice(keys) for _ in range(6)))
        await pilot.pause(0.3)
        assert pilot.app.return_code is None
