# SPDX-License-Identifier: Apache-2.0
"""The design beside its saved file, an earlier state or another design, from the screen."""

from pathlib import Path
from typing import Any

import pytest
from textual.pilot import Pilot
from textual.widgets import Input, OptionList

from assistant.app import ContralberoApp
from assistant.screens.compare import CompareScreen, ComparisonList
from assistant.screens.path_dialogs import CompareFile, CompareWith
from assistant.session.compare_with import kept, of_session, past
from assistant.session.session import Session
from calc.design.toml_file import load
from calc.sheet.number import short
from calc.solve import solve
from calc.studies.compare import compare
from calc.studies.compare_tables import differing, moved
from calc.studies.shipped import DESIGNS
from tests.assistant.conftest import Screen
from tests.assistant.driving import go_to, settled, strike, told, type_in, until, work

SIZES = [(80, 24), pytest.param((120, 40), marks=pytest.mark.slow)]  # the narrow one shows more faults


def text(pilot: Pilot[int]) -> str:
    """The screen as text, whichever it is."""
    return "\n".join(
        "".join(segment.text for segment in strip) for strip in pilot.app.screen._compositor.render_strips()
    )


def options(pilot: Pilot[int]) -> list[str]:
    screen = pilot.app.screen
    assert isinstance(screen, CompareWith)
    return [str(option.prompt) for option in screen.query_one("#others", OptionList).options]


async def asked(pilot: Pilot[int]) -> None:
    """Wait for the question what to compare with."""
    await until(pilot, lambda: isinstance(pilot.app.screen, CompareWith) and pilot.app.screen.focused is not None)


async def opened(pilot: Pilot[int]) -> ComparisonList:
    """Wait for the comparison."""
    await until(pilot, lambda: isinstance(pilot.app.screen, CompareScreen))
    shown = pilot.app.screen.query_one(ComparisonList)
    await until(pilot, lambda: shown.found is not None)
    await pilot.pause()
    return shown


# --- what can be compared with, without a screen
def test_the_states_of_a_design(light: Session) -> None:
    assert [other.title for other in kept(light)] == ["light.toml as it is saved"] and list(past(light)) == []
    before = light.data
    light.edit("engine.bore_mm", "9")
    light.edit("engine.bore_mm", "95")
    light.seal()
    light.edit("countershaft.masses.rear.mass_kg", "")  # not accepted, but taken back all the same
    light.undo()
    light.add("countershaft.masses")
    assert [other.title for other in past(light)] == [
        "before Eccentric masses: rear-2 (shafts, shaft, masses): left out → 5 keys",
        "before Bore (engine): 94 → 95 mm",
    ]
    assert [other.name for other in past(light)] == ["1 edit ago", "2 edits ago"]
    assert list(past(light))[-1].data is before
    # nothing was taken back but the last edit
    assert light.undo() is not None and light.value("engine.bore_mm") == 95.0
    light.save()
    assert [other.name for other in kept(light)] == ["saved", "opened"]


def test_an_edit_that_was_not_understood_is_no_state(light: Session) -> None:
    light.edit("engine.bore_mm", "nine")
    assert list(past(light)) == []
    light.edit("engine.bore_mm", "95")
    assert [other.title for other in past(light)] == ["before Bore (engine): 94 → 95 mm"]


def test_many_edits_are_all_listed(light: Session) -> None:
    for n in range(300):
        light.edit("engine.bore_mm", f"{80 + n / 10}")
        light.seal()
    assert len(list(past(light))) == 300


# --- the screen
@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("ascii", [True, pytest.param(False, marks=pytest.mark.slow)])
async def test_an_earlier_state_beside_the_present_one(screen: Screen, size: tuple[int, int], ascii: bool) -> None:
    async with screen(size=size, ascii=ascii) as pilot:
        for key, value in (("engine.crank_radius_mm", "54"), ("engine.bore_mm", "95")):
            await go_to(pilot, key)
            await type_in(pilot, value)
        here = work(pilot).focused
        assert here is not None
        await strike(pilot, "shift+f7")
        await asked(pilot)
        then = "->" if ascii else "→"
        assert options(pilot) == [
            "light.toml as it is saved",
            "another design file ..." if ascii else "another design file …",
            f"before Bore (engine): 94 {then} 95 mm",
            f"before Crank radius (engine): 53.5 {then} 54 mm",
        ]
        await strike(pilot, "down", "j", "down", "enter")
        shown = await opened(pilot)
        assert shown.found is not None
        found = {(d.key, d.a, d.b) for d in shown.found.inputs}
        assert found == {("engine.crank_radius_mm", 53.5, 54.0), ("engine.bore_mm", 94.0, 95.0)}
        seen = text(pilot)
        assert f"2 edits ago {then} now: the whole" in seen
        await strike(pilot, "right")
        await pilot.pause()
        seen = text(pilot)
        assert (
            "2 edits ago" in seen and "Crank radius (engine)" in seen and "53.5" in seen and "2 inputs differ" in seen
        )
        assert all(len(line) <= size[0] for line in seen.splitlines())
        assert ("x FAIL" in seen or "! warn" in seen) if ascii else "▲ warn" in seen
        await strike(pilot, "escape")
        await until(pilot, lambda: not isinstance(pilot.app.screen, CompareScreen))
        assert work(pilot).focused is here and work(pilot).session.value("engine.bore_mm") == 95.0


@pytest.mark.slow
async def test_sections_lines_and_copying(screen: Screen, monkeypatch: pytest.MonkeyPatch) -> None:
    async with screen(size=(80, 24)) as pilot:
        copied: list[str] = []
        monkeypatch.setattr(pilot.app, "copy_to_clipboard", copied.append)
        await go_to(pilot, "engine.crank_radius_mm")
        await type_in(pilot, "54")
        await strike(pilot, "enter", "escape")
        await strike(pilot, "=")
        await asked(pilot)
        await strike(pilot, "enter")
        shown = await opened(pilot)
        sections = []
        for key in ("tab", "right", "h", "left", "left", "right", "l", "l", "l", "l"):
            await strike(pilot, key)
            sections.append(shown.section)
        there = (
            "Inputs",
            "Verdicts",
            "Inputs",
            "Conclusion",
            "Conclusion",
            "Inputs",
            "Verdicts",
            "Checks",
            "Values",
            "Values",
        )
        assert tuple(sections) == there
        top = text(pilot).splitlines()[1]
        assert "▸Values" in top and "Inputs 1 " in top
        first = shown.key
        await strike(pilot, "j", "j", "k")
        assert shown.key != first and shown.id_here in text(pilot)
        await strike(pilot, "y", "Y")
        assert shown.found is not None
        value = next(d for d in shown.found.values if d.id == shown.id_here)
        assert (
            value.b is not None
            and copied[0] in (short(value.b, n) for n in range(4, 10))
            and copied[1].startswith(f"{value.id}: ")
        )
        await strike(pilot, "end")
        assert shown.cursor == max(i for i, item in enumerate(shown.items) if item.key)
        assert shown._first[shown.cursor] < shown.scroll_y + shown.size.height
        await strike(pilot, *["h"] * 3, "enter")
        await until(pilot, lambda: not isinstance(pilot.app.screen, CompareScreen))
        await settled(pilot)
        field = work(pilot).form.field
        assert field is not None and field.place == ("engine", "crank_radius_mm")


async def test_another_design_file(screen: Screen, tmp_path: Path) -> None:
    (tmp_path / "broken.toml").write_text("schema = 1\nname = 3\n")
    other = tmp_path / "other [red]design.toml"
    other.write_bytes((tmp_path / "light.toml").read_bytes().replace(b"bore_mm = 94.0", b"bore_mm = 99.0"))
    async with screen(size=(120, 40)) as pilot:
        await strike(pilot, "shift+f7")
        await asked(pilot)
        await strike(pilot, "down", "enter")
        await until(pilot, lambda: isinstance(pilot.app.screen, CompareFile) and pilot.app.screen.is_mounted)
        dialog = pilot.app.screen
        names = [str(option.prompt) for option in dialog.query_one("#names", OptionList).options]
        assert "light.toml" in names and any(name.startswith("r753ie4_beta.toml") for name in names)
        box = dialog.query_one("#path", Input)
        for name, reason in (("broken.toml", "name"), ("none.toml", "cannot be read"), ("", "folder")):
            box.value = f"{tmp_path}/{name}"
            await strike(pilot, "enter")
            await pilot.pause()
            assert isinstance(pilot.app.screen, CompareFile) and reason in str(dialog.query_one("#wrong").render())
        box.value = str(other)
        await strike(pilot, "enter")
        shown = await opened(pilot)
        assert shown.found is not None and [(d.key, d.a, d.b) for d in shown.found.inputs] == [
            ("engine.bore_mm", 99.0, 94.0)
        ]
        assert "other [red]design" in text(pilot)


@pytest.mark.slow
async def test_a_shipped_design_and_steps_that_are_not_asked(screen: Screen) -> None:
    async with screen(size=(80, 24)) as pilot:
        await strike(pilot, "escape")
        await strike(pilot, "=")
        await asked(pilot)
        await strike(pilot, "down", "enter")
        await until(pilot, lambda: isinstance(pilot.app.screen, CompareFile))
        pilot.app.screen.query_one("#path", Input).value = str(DESIGNS / "timing_pair.toml")
        await strike(pilot, "enter")
        await opened(pilot)
        await strike(pilot, "right", "right")
        await pilot.pause()
        assert "· not used" in text(pilot) and "5 steps change their verdict" in text(pilot)


@pytest.mark.slow
async def test_an_unchanged_design_is_equal(screen: Screen) -> None:
    async with screen(size=(80, 24)) as pilot:
        await strike(pilot, "shift+f7")
        await asked(pilot)
        await strike(pilot, "enter")
        shown = await opened(pilot)
        assert shown.found is not None and shown.found.equal and "The two designs are equal" in text(pilot)
        await strike(pilot, "l", "l", "j", "enter", "y")  # nothing to go to
        assert isinstance(pilot.app.screen, CompareScreen) and "nothing to copy" in told(pilot)


@pytest.mark.slow
async def test_what_is_not_valid_is_said(screen: Screen, light: Session) -> None:
    async with screen(size=(80, 24)) as pilot:
        await go_to(pilot, "engine.bore_mm")
        await type_in(pilot, "-1")
        await strike(pilot, "shift+f7")
        await settled(pilot)
        assert "Nothing to compare while the input is not valid: engine.bore_mm" in told(pilot)
        assert work(pilot) is pilot.app.screen
        light.seal()
        await type_in(pilot, "")
        box: Any = await go_to(pilot, "engine.bore_mm")
        box.value = "95"
        await settled(pilot)
        assert light.valid
        await strike(pilot, "shift+f7")
        await asked(pilot)
        wrong = next(n for n, name in enumerate(options(pilot)) if "−1 → 95" in name)
        await strike(pilot, *["down"] * wrong, "enter")
        await pilot.pause()
        assert isinstance(pilot.app.screen, CompareWith) and "engine.bore_mm" in str(
            pilot.app.screen.query_one("#wrong").render()
        )
        await strike(pilot, "escape")
        await until(pilot, lambda: not isinstance(pilot.app.screen, CompareWith))
        work(pilot)


@pytest.mark.slow
@pytest.mark.parametrize("size", SIZES)
async def test_a_long_comparison_is_set_whole(session: Session, size: tuple[int, int]) -> None:
    """β beside γ: more than 700 rows."""
    document, made = load(DESIGNS / "r753ie4_beta.toml")
    session.solve()
    assert session.results is not None
    found = compare(document.data, session.data, solve(made), session.results)
    app = ContralberoApp(session)
    async with app.run_test(size=size) as pilot:
        other = of_session(session, next(iter(kept(session))))
        screen = CompareScreen(session, other)
        await app.push_screen(screen)
        shown = screen.query_one(ComparisonList)
        await until(pilot, lambda: shown.found is not None)
        shown.show(found, ("r753ie4_beta", "now"))
        parts = (moved(found), differing(found), found.inputs, found.verdicts, found.checks, found.values)
        rows = sum(map(len, parts))
        assert sum(bool(item.key) for item in shown.items) == rows
        assert all(row.cell_length <= shown.room for item in shown.items for row in item.rows)
