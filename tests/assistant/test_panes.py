# SPDX-License-Identifier: Apache-2.0
"""Steps, panes, checks, curves, and the letters that act as keys."""

import re
from typing import Any

import pytest
from rich.cells import cell_len
from textual.pilot import Pilot
from textual.widgets import Input

from assistant.actions import ACTIONS
from assistant.screens.ready import ReadyScreen
from assistant.screens.selection import Choosing
from assistant.screens.workbench import Workbench
from assistant.session.session import Session
from assistant.widgets.calculation import Calculation
from assistant.widgets.checks import Checks
from assistant.widgets.curve_pane import CurvePane, Pane
from assistant.widgets.field import Cells
from assistant.widgets.form import Form
from assistant.widgets.headings import ArrayHeading
from assistant.widgets.radio import Todo
from calc.design.model import STEPS
from calc.sheet.verdict import grouped
from calc.studies.repair.nearest import NearestRemedy, remedy
from tests.assistant.conftest import Screen, solved
from tests.assistant.driving import CHARACTERS, go_to, rows, screen_rows, settled, strike, told, type_in, until, work


# --- steps, panes, checks
@pytest.mark.slow
async def test_steps_forward_back_and_by_number(screen: Screen) -> None:
    async with screen() as pilot:
        for key, number in (
            ("f3", 2),
            ("pagedown", 3),
            ("f2", 2),
            ("pageup", 1),
            ("f2", 1),
            ("escape", 1),
            ("6", 6),
            ("left_square_bracket", 5),
            ("right_square_bracket", 6),
            ("4", 4),
        ):
            await strike(pilot, key)
            await pilot.pause()
            assert work(pilot).number == number, key


async def test_before_the_first_step_is_nothing_and_after_the_last_the_closing_page(screen: Screen) -> None:
    async with screen() as pilot:
        await strike(pilot, "f2", "f2", "f2", "f2")
        await settled(pilot)
        assert told(pilot) == "This is the first step."
        await strike(pilot, "f3")
        await settled(pilot)
        assert work(pilot).number == 2 and told(pilot) == ""
        await strike(pilot, "escape")
        await strike(pilot, "6")
        await settled(pilot)
        assert work(pilot).number == 6
        await strike(pilot, "f3", "f3")  # past the mounting, which is offered
        await until(pilot, lambda: isinstance(pilot.app.screen, ReadyScreen))
        await strike(pilot, "escape")
        await until(pilot, lambda: isinstance(pilot.app.screen, Workbench))
        assert work(pilot).number == 7


@pytest.mark.slow
async def test_enter_goes_on_from_a_pane_in_which_nothing_can_be_chosen(screen: Screen) -> None:
    """A step that is not built opens with its inputs; from its empty plot Enter leads back to them."""
    async with screen(size=(80, 24)) as pilot:
        bench = work(pilot)
        await strike(pilot, "f9")
        await until(pilot, lambda: bench.pane == "curve")
        await strike(pilot, "5")
        await until(pilot, lambda: bench.number == 5)
        await settled(pilot)
        assert bench.pane == "inputs" and isinstance(pilot.app.focused, Todo)
        bench.action_to_view("curve")
        await strike(pilot, "enter")
        await settled(pilot)
        assert bench.pane == "inputs" and pilot.app.focused is bench.form


@pytest.mark.slow
async def test_while_an_input_is_not_valid_no_older_verdict_is_told(screen: Screen) -> None:
    async with screen(size=(80, 24)) as pilot:
        assert "WARN: 3 cautions  3 steps left" in screen_rows(pilot)[0]
        await go_to(pilot, "engine.bore_mm")
        await type_in(pilot, "x")
        await until(pilot, lambda: "input is not valid  4 steps left" in screen_rows(pilot)[0])
        assert "WARN" not in screen_rows(pilot)[0]
        await pilot.press("enter", "escape", "D")
        await until(pilot, lambda: "! input is not valid; 4 steps left" in screen_rows(pilot)[0])


@pytest.mark.slow
async def test_what_helps_a_step_that_fails_is_known_before_it_is_opened(
    screen: Screen, session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each is looked for once, though the steps are turned in between."""
    sought: list[str] = []

    def known(document: Any, step: str, results: Any, progress: Any) -> NearestRemedy:
        sought.append(step)
        progress(0.0, "")
        return remedy(document, "gears", results, progress)

    monkeypatch.setattr("calc.studies.repair.nearest.remedy", known)
    async with screen(session=session) as pilot:
        bench = work(pilot)
        await strike(pilot, "f3", "f3")
        await until(pilot, lambda: bench.remedies.keys() == {"bearings", "gears"})
        await strike(pilot, "f3", "f3")
        await settled(pilot)
        assert bench.trouble == "gears" and bench.remedy is not None
        assert sorted(sought) == ["bearings", "gears"]
        session.edit("engine.bore_mm", "93")  # of results that are no longer the design's there is none
        assert session.results is not None and bench.known_remedy("gears") is None
        await bench.open_step(STEPS[4])
        session.edit("engine.bore_mm", "92")
        bench.action_choose()
        chosen = pilot.app.screen
        assert isinstance(chosen, Choosing) and chosen.step == "gears" and chosen.nearest is None
        await strike(pilot, "escape")


@pytest.mark.slow
async def test_the_form_of_a_step_is_made_once(
    screen: Screen, session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It has as many columns as its room takes from the first."""
    made: list[str] = []
    monkeypatch.setattr(Form, "rebuild", lambda self, focus=None: made.append(self.step.key))
    async with screen(size=(80, 24), session=session) as pilot:
        await strike(pilot, "escape")
        await strike(pilot, "5")
        await settled(pilot)
        assert work(pilot).form.query(Cells) and not made


async def test_the_next_fault_and_its_line(screen: Screen, session: Session) -> None:
    async with screen(session=session) as pilot:
        results = work(pilot).session.results
        assert results is not None
        findings = [(n, group[0]) for n, s in enumerate(STEPS, 1) for group in grouped(results.outcomes[s.key].checks)]
        failing = [(n, worst.id) for n, worst in findings if worst.verdict == "fail"]
        assert len(failing) > 1
        seen = []
        for _ in failing:
            await strike(pilot, "f7")
            await settled(pilot)
            seen.append((work(pilot).number, work(pilot).query_one(Checks).key))
        assert set(seen) == set(failing)
        await until(pilot, lambda: work(pilot).page is not None)  # the calculation is written out
        await strike(pilot, "g")
        await settled(pilot)
        calculation = work(pilot).query_one(Calculation)
        assert calculation.has_focus and calculation.item is not None
        entry = next(e for e in calculation.sheet.entries if e.number == calculation.key)
        assert seen[-1][1] in {c.id for c, _ in entry.checks}


@pytest.mark.slow
async def test_the_cursor_stays_on_its_check_when_the_results_change(screen: Screen, session: Session) -> None:
    async with screen(session=session) as pilot:
        await go_to(pilot, "bearings.front.length_mm")
        checks = work(pilot).query_one(Checks)
        checks.go_to("bearings.rear.specific_load")
        await pilot.pause()
        await type_in(pilot, "40")
        await solved(pilot)
        assert checks.key == "bearings.rear.specific_load"


@pytest.mark.slow
async def test_the_cursor_goes_from_line_to_line(screen: Screen) -> None:
    async with screen(size=(80, 24)) as pilot:
        await pilot.press("f3", "f4", "f4", "f4")
        calculation = work(pilot).query_one(Calculation)
        await until(pilot, lambda: bool(calculation.key))
        seen = [calculation.key]
        for key in ("down", "j", "up", "pagedown", "end", "home"):
            await strike(pilot, key)
            seen.append(calculation.key)
            first = calculation._first[calculation.cursor]
            assert calculation.scroll_y <= first < calculation.scroll_y + calculation.size.height
        assert seen[:4] == ["2.1", "2.2", "2.3", "2.2"]
        assert float(seen[4].partition(".")[2]) > 4 and seen[5].startswith("note") and seen[6] == "2.1"


@pytest.mark.slow
async def test_panes_in_turn(screen: Screen) -> None:
    async with screen() as pilot:
        seen = [work(pilot).pane]
        for _ in range(4):
            await strike(pilot, "f6")
            await pilot.pause()
            seen.append(work(pilot).pane)
        assert seen == ["inputs", "picture", "checks", "steps", "inputs"]
        await strike(pilot, "shift+f6")
        assert work(pilot).pane == "steps"
        await pilot.press("down", "enter")
        await pilot.pause()
        assert work(pilot).number == 2


@pytest.mark.slow
@pytest.mark.parametrize(
    ("size", "ascii"),
    [
        ((110, 30), False),
        ((80, 24), True),
        *(pytest.param(*row, marks=pytest.mark.slow) for row in (((110, 30), True), ((80, 24), False))),
    ],
)
async def test_the_title_of_the_pane_that_has_the_focus_is_marked(
    screen: Screen, size: tuple[int, int], ascii: bool
) -> None:
    async with screen(size=size, ascii=ascii) as pilot:

        def marked() -> list[str]:
            panes = [pane for pane in work(pilot).query(Pane) if pane.display]
            for pane in panes:
                here = pane.id == work(pilot).pane
                assert pane.title.styles.text_style.bold is (True if here else None), pane.id
            return [str(pane.id) for pane in panes if str(pane.title.render())[:1] == (">" if ascii else "▸")]

        for key in ("f6", "f6", "f6", "f6", "escape"):
            await strike(pilot, key)
            await until(pilot, lambda: marked() == [work(pilot).pane])
        assert work(pilot).pane == "inputs" and pilot.app.focused is work(pilot).form
        await strike(pilot, "f6", "f6", "f1")
        await until(pilot, lambda: bool(pilot.app.screen.query("#help-text")))
        await strike(pilot, "escape")
        await until(pilot, lambda: not pilot.app.screen.query("#help-text"))
        await until(pilot, lambda: marked() == ["checks"] == [work(pilot).pane])


@pytest.mark.slow
async def test_a_pane_is_made_large_and_small(screen: Screen) -> None:
    async with screen() as pilot:
        await pilot.press("f6", "f6", "shift+f4")
        await pilot.pause()
        assert work(pilot).query_one("#checks").size.width == 110
        assert not work(pilot).query_one("#inputs").display
        await strike(pilot, "z")
        await pilot.pause()
        assert work(pilot).query_one("#inputs").display


@pytest.mark.slow
async def test_findings_calculation_and_curve_take_turns(screen: Screen) -> None:
    """Wide, in one place; very wide the curve has a place of its own, where it stays."""
    async with screen(size=(120, 40)) as pilot:
        for columns, turns in ((120, ("calculation", "curve", "checks")), (200, ("calculation", "checks"))):
            await pilot.resize_terminal(columns, 40)
            await until(pilot, lambda: work(pilot).huge is (columns == 200))  # noqa: B023
            for name in turns:
                await strike(pilot, "f4")
                await pilot.pause()
                shown = {pane.id for pane in work(pilot).query(Pane) if pane.display}
                assert shown == {"steps", "inputs", "picture", name, *(["curve"] if columns == 200 else [])}
                assert work(pilot).pane == name


async def test_narrow_shows_one_view_after_the_other(screen: Screen) -> None:
    async with screen(size=(80, 24)) as pilot:
        for view in ("picture", "checks", "calculation", "curve", "inputs"):
            await strike(pilot, "f4")
            await pilot.pause()
            shown = [pane.id for pane in work(pilot).query(".pane") if pane.display]
            assert shown == [view]


@pytest.mark.slow
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


@pytest.mark.slow
async def test_curves_in_turn(screen: Screen) -> None:
    async with screen() as pilot:
        await pilot.press("escape", "2")
        await pilot.pause()
        pane = work(pilot).query_one(CurvePane)
        await settled(pilot)
        await until(pilot, lambda: len(pane.leaves) > 2)
        first, count = pane.leaf, len(pane.leaves)
        await strike(pilot, "c")
        await pilot.pause()
        assert pane.display and pane.leaf is first  # which had not been seen yet
        await strike(pilot, "c")
        await pilot.pause()
        assert pane.leaf is pane.leaves[1] and pane.leaf is not first
        assert f"2 of {count}" in rows(pilot)
        await pilot.press(*["f9"] * (count - 1))
        assert pane.leaf is first


@pytest.mark.slow
async def test_the_sources_errors_and_the_assumptions_stand_in_the_calculation(screen: Screen) -> None:
    async with screen() as pilot:
        await pilot.press("escape", "2")
        await pilot.pause()
        results = work(pilot).session.results
        assert results is not None
        outcome = results.outcomes["imbalance"]
        assert outcome.errata and outcome.notes
        await strike(pilot, "f4")
        calculation = work(pilot).query_one(Calculation)
        await until(pilot, lambda: bool(calculation.items))
        text = re.sub(r"\s+", " ", " ".join(row.plain for item in calculation.items for row in item.rows))
        for said in (*(erratum.why for erratum in outcome.errata), *outcome.notes):
            assert said in text
        assert f"{len(outcome.notes)} assumed" in calculation.position()


@pytest.mark.slow
async def test_square_brackets_are_no_markup(screen: Screen) -> None:
    async with screen() as pilot:
        await go_to(pilot, "engine.name")
        await type_in(pilot, "[red]x[/] [")
        await settled(pilot)
        assert "[[red]x[/] [" in rows(pilot)
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
        keys = [key for action in ACTIONS for key in action.letters.split(",") if key]
        letters = [key for key in keys if len(key) == 1 or key in CHARACTERS]
        before = (work(pilot).number, work(pilot).pane, pilot.app.screen)
        await strike(pilot, *letters)
        await pilot.pause()
        assert (work(pilot).number, work(pilot).pane, pilot.app.screen) == before
        assert len(box.value) == len(letters)
        others = [key for key in keys if key not in letters]  # they move and delete in the text
        assert set(others) == {"backspace", "left", "right", "shift+left", "shift+right", "home", "end"}
        await strike(pilot, *others)
        await pilot.pause()
        assert (
            work(pilot).number,
            work(pilot).pane,
            pilot.app.screen,
        ) == before and pilot.app.focused is box
        assert len(box.value) == len(letters) - 1 and work(pilot).query_one(CurvePane).cursor is None


@pytest.mark.slow
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
        await pilot.press("f6", "f6", "right", "down", "y")  # the advice is folded
        assert pilot.app.clipboard == "0.3282"
        await pilot.press("Y")
        assert pilot.app.clipboard.startswith("note: Crank ratio λ 0.3282, limit 0.22 to 0.3")
        await pilot.press("f4", "j", "Y")
        assert pilot.app.clipboard.startswith("M_alt = M_P + M_ra = 1.178")
        await strike(pilot, "y")
        assert pilot.app.clipboard == "1489 g"
        await go_to(pilot, "engine.bore_mm")
        await pilot.press("escape", "y")
        assert pilot.app.clipboard == "94 mm"


# --- the mouse
def spot(pilot: Pilot[int], words: str) -> tuple[int, int]:
    """Where words stand first on the screen."""
    seen = screen_rows(pilot)
    y = next(n for n, row in enumerate(seen) if words in row)
    return cell_len(seen[y].partition(words)[0]), y


@pytest.mark.slow
async def test_everything_can_be_clicked(screen: Screen, session: Session) -> None:
    async with screen(size=(120, 40), session=session) as pilot:
        await pilot.click(offset=spot(pilot, "4 Bearings"))
        await settled(pilot)
        assert work(pilot).number == 4
        await pilot.click(offset=spot(pilot, "Film at the edge,"))  # chosen, and told in full
        await settled(pilot)
        checks = work(pilot).query_one(Checks)
        assert pilot.app.focused is checks and checks.key == "bearings.front.film_edge"
        await until(pilot, lambda: work(pilot).page is not None, 10.0)
        await pilot.click(offset=spot(pilot, "Film at the edge,"))
        await settled(pilot)
        assert pilot.app.focused is work(pilot).query_one(Calculation)
        text = rows(pilot).splitlines()[-1]
        await pilot.click("#footer-line", offset=(text.index("F3"), 0))
        await settled(pilot)
        assert work(pilot).number == 5
        await pilot.resize_terminal(80, 24)
        await settled(pilot)
        await pilot.click("#step-bar", offset=(rows(pilot).splitlines()[1].index("Gears"), 0))
        await settled(pilot)
        assert work(pilot).number == 5
        await pilot.click("#calculation-title", offset=(rows(pilot).splitlines()[2].index("Inputs"), 0))
        await settled(pilot)
        assert work(pilot).pane == "inputs"
        heading = next(one for one in work(pilot).form.query(ArrayHeading) if one.row.place == ("gears", "meshes"))
        heading.scroll_visible(animate=False)
        await settled(pilot)
        await pilot.click(heading, offset=(heading.render().plain.index("▸"), 0))
        await settled(pilot)
        assert "2/3" in rows(pilot)


@pytest.mark.slow
async def test_a_field_that_the_palette_finds_comes_into_view(screen: Screen) -> None:
    """The form of its step is made on the way there, and has no size yet when the field gets the focus."""
    async with screen(size=(80, 24)) as pilot:
        await strike(pilot, "ctrl+p", *"countershaft.oil_drain.tilt_deg", "enter")
        await settled(pilot)
        field = work(pilot).form.field
        assert field is not None and field.place == work(pilot).session.place("countershaft.oil_drain.tilt_deg")
        await until(pilot, lambda: work(pilot).form.region.contains_region(field.region), 3.0)
