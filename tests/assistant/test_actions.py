# SPDX-License-Identifier: Apache-2.0
"""The one table of what the user can do."""

import re
from dataclasses import replace
from typing import Any

import pytest
from textual.widgets import Input

from assistant.actions import ACTIONS, BY_ID, ELSEWHERE, Action, key_name
from assistant.screens.workbench import Workbench
from assistant.widgets.curve_pane import CurvePane
from assistant.widgets.lines import FooterLine
from calc.sheet.step import Curve
from tests.assistant.conftest import Screen
from tests.assistant.driving import rows, settled, strike, until, work

ALLOWED_IN_A_FIELD = {"up", "down", "enter", "escape", "shift+up", "shift+down", "pageup", "pagedown"}


def test_every_action_has_words_and_a_method() -> None:
    assert len(BY_ID) == len(ACTIONS) + len(ELSEWHERE)
    for action in ACTIONS:
        assert action.title and action.help.endswith("."), action.id
        assert action.binding, action.id
        assert len(having(action)) == 1, action.id  # none of ours hides another, nor one of textual's own


def having(action: Action, screen: type[Workbench] = Workbench) -> list[type]:
    """The classes of the main screen that have the method of an action."""
    name = f"action_{action.call[0] if action.call else action.id}"
    return [kind for kind in screen.__mro__ if name in vars(kind)]


def test_an_action_without_a_method_or_with_two_is_found() -> None:
    class Hiding(Workbench):
        async def action_undo(self) -> None: ...

    assert not having(replace(BY_ID["undo"], id="undone"))
    assert len(having(BY_ID["undo"], Hiding)) == 2


def test_no_key_is_given_twice() -> None:
    keys = [key for action in (*ACTIONS, *ELSEWHERE) for key in action.binding.split(",")]
    assert len(keys) == len(set(keys))


def test_the_keys_of_the_proposal_are_there() -> None:
    keys = {key for action in ACTIONS for key in action.binding.split(",")}
    wanted = (
        "f1 f2 f3 f4 f6 f7 f8 pageup pagedown 1 2 3 4 5 6 up down enter shift+f6 ctrl+z ctrl+y ctrl+s ctrl+o "
        "ctrl+p shift+up shift+down escape ctrl+q"
    )
    letters = "question_mark left_square_bracket right_square_bracket j k v h l n p u r w o colon q y Y"
    assert set(wanted.split() + letters.split()) <= keys


def test_nothing_needs_alt_or_a_modern_terminal() -> None:
    """Alt is a second way beside a plain key."""
    for action in ACTIONS:
        assert any("alt+" not in key for key in action.binding.split(",")), action.id
        assert not re.search(r"super\+|ctrl\+shift", action.binding)


def test_letters_are_no_keys_of_a_field() -> None:
    """What acts anywhere is not a character that can be typed."""
    for action in ACTIONS:
        for key in filter(None, action.keys.split(",")):
            assert len(key) > 1 and (key[0] == "f" or "+" in key or key in ALLOWED_IN_A_FIELD), action.id


def test_a_field_takes_none_of_our_control_keys() -> None:
    own = {
        key for binding in Input.BINDINGS for key in (binding.key if hasattr(binding, "key") else binding[0]).split(",")
    }
    ours = {key for action in ACTIONS if not action.first for key in action.keys.split(",")} - {"", "enter"}
    assert not own & ours


def test_keys_are_named_as_on_the_keyboard() -> None:
    assert [key_name(k) for k in ("f1", "ctrl+z", "shift+f6", "question_mark", "pagedown", "Y")] == [
        "F1",
        "^z",
        "Shift+F6",
        "?",
        "PgDn",
        "Y",
    ]


@pytest.mark.parametrize(
    ("size", "shown"),
    [
        ((80, 24), "F1 Help F2 Back F3 Next F4 View F5 Remedy F7 Finding F8 PDF F9 Plot ^p All"),
        ((120, 40), "F1 Help F3 Next F4 View F5 Remedy ^t Choose F7 Finding F8 PDF F9 Plot ^p All"),
    ],
)
async def test_the_footer_fits(screen: Screen, size: tuple[int, int], shown: str) -> None:
    async with screen(size=size) as pilot:
        footer = pilot.app.screen.query_one("#footer-line")
        text: Any = footer.render()
        assert " ".join(text.plain.split()) == shown
        assert text.cell_length <= size[0]
        await strike(
            pilot, "1"
        )  # into a field, the name of the design: now there is something to take back, and to keep
        assert "^z Undo ^s Save" in " ".join(footer.render().plain.split()) or size[0] == 80
        await strike(pilot, "ctrl+z")
        await until(pilot, lambda: ("^y Redo" in footer.render().plain) == (size[0] > 80))
        assert footer.render().cell_length <= size[0]


@pytest.mark.slow
async def test_the_footer_has_room_for_what_does_something_here(screen: Screen) -> None:
    async with screen(size=(120, 40)) as pilot:
        footer = pilot.app.screen.query_one(FooterLine)
        said = footer.render().plain
        # the curves of the engine have no variants
        assert "F9 Plot" in said and "F10" not in said
        await strike(pilot, "f3")
        await settled(pilot)
        # its curves are written out in another thread
        await until(pilot, lambda: len(work(pilot).query_one(CurvePane).leaves) > 2)
        assert "F10" not in footer.render().plain  # nor is there a curve to be seen
        await strike(pilot, "f9")
        await until(pilot, lambda: "F10 Variant" in footer.render().plain)
        assert "F9 Plot" in footer.render().plain and footer.render().cell_length <= 120
        curves = work(pilot).query_one(CurvePane)
        seen = set()
        for _ in curves.leaves:
            has = isinstance(curves.leaf, Curve) and len(curves.leaf.variants) > 1
            await until(pilot, lambda has=has: ("F10 Variant" in rows(pilot)) == has)  # type: ignore[misc]
            seen.add(has)
            await strike(pilot, "f9")
        assert seen == {True, False}


async def test_help_and_palette_know_every_action(screen: Screen) -> None:
    from assistant.screens.help import HelpScreen
    from assistant.screens.palette import HIDDEN, entries

    async with screen() as pilot:
        bench = pilot.app.screen
        assert isinstance(bench, Workbench)
        found = [entry.title for entry in entries(bench.app, bench) if entry.first]
        for action in ACTIONS:
            if action.id == "drive":  # offered where it can run, which is not here: there are no bearings
                assert not any(action.title in text for text in found) and "bearings" in bench.no_drive()
                continue
            if action.id == "fit":  # nor has this design anything to fit
                assert not any(action.title in text for text in found) and "[[fits]]" in bench.no_fit()
                continue
            assert action.id in HIDDEN or any(action.title in text for text in found), action.id
        await pilot.press("f1")
        await pilot.pause()
        help = pilot.app.screen
        assert isinstance(help, HelpScreen)
        text = re.sub(r"\s+", " ", help.keys().plain)
        for action in ACTIONS:
            assert action.help in text, action.id


@pytest.mark.slow
async def test_a_key_of_the_user_s_own(session: Any) -> None:
    from assistant.app import ContralberoApp

    app = ContralberoApp(session, key_map={"next": "f5", "nonsense": "f11"})
    async with app.run_test(size=(80, 24)) as pilot:
        bench = app.screen
        assert isinstance(bench, Workbench)
        await pilot.press("f3")
        assert bench.number == 1
        await pilot.press("f5")
        assert bench.number == 2
        assert "F5 Next" in bench.query_one("#footer-line").render().plain  # type: ignore[union-attr]
