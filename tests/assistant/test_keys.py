# SPDX-License-Identifier: Apache-2.0
"""What keys mean, on every screen, and what is said of them: in messages, toasts, hints and dialogs."""

import ast
import importlib
import pkgutil
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest
from textual.binding import Binding
from textual.dom import DOMNode
from textual.screen import Screen as TextualScreen

import assistant
from assistant.actions import ACTIONS, BY_ID, ELSEWHERE, MOVING, anywhere, bound
from assistant.app import ContralberoApp
from assistant.screens.dialogs import Ask
from assistant.screens.help import HelpScreen
from assistant.screens.palette import Palette
from assistant.screens.path_dialogs import OpenDialog, SaveDialog
from assistant.screens.ready import ReadyScreen
from assistant.screens.remedies import Remedies
from assistant.session.session import Session
from assistant.widgets.item_list import ItemList
from tests.assistant.action_tests import over, text
from tests.assistant.conftest import Screen
from tests.assistant.driving import go_to, settled, strike, until, work

SOURCE = Path(assistant.__file__).parent
OWNERS = {key: action for action in (*ACTIONS, *ELSEWHERE) for key in action.binding.split(",")}


# --- one key, one meaning
def widgets() -> list[type[DOMNode]]:
    """Every app, screen and widget of the session."""
    for module in pkgutil.walk_packages(assistant.__path__, "assistant."):
        if not module.name.endswith("__main__"):
            importlib.import_module(module.name)

    def below(kind: type[DOMNode]) -> Iterator[type[DOMNode]]:
        for child in kind.__subclasses__():
            yield child
            yield from below(child)

    return list({kind for kind in below(DOMNode) if kind.__module__.startswith("assistant.")})


def strays(kinds: list[type[DOMNode]]) -> list[str]:
    """Keys that are bound to something else than the action that they have in the table.  Keys that move do in each
    place what it is moved through with."""
    wrong = []
    for kind in kinds:
        for binding in Binding.make_bindings(vars(kind).get("BINDINGS", ())):
            owner = OWNERS.get(binding.key)
            named = owner is not None and binding.id in (owner.id, anywhere(owner.id))
            if not named and binding.key.removeprefix("shift+") not in MOVING:
                wrong.append(f"{kind.__name__}: {binding.key} {binding.action}")
    return wrong


def test_a_key_means_the_same_on_every_screen() -> None:
    kinds = widgets()
    assert len([kind for kind in kinds if vars(kind).get("BINDINGS")]) > 20
    assert strays(kinds) == []


def test_a_second_meaning_is_found() -> None:
    class Clashing(ItemList):
        BINDINGS = [Binding("k", "lock"), bound("lock"), Binding("t", "turn", id="choose"), Binding("space", "x")]  # noqa: RUF012

    assert strays([Clashing]) == ["Clashing: k lock"]


# --- keys that a text names
NAMED = re.compile(
    r"\bF\d+\b|\^[a-z]\b|\b(?:Ctrl|Alt)\b(?!\+{)|Shift\+(?![→←↑↓{])"  # a key that the user's map may give to another action
    r"|(?:^|[·;:,] |\()[^\W\d_](?= [a-z]+s\b)|(?:^|[·;(,:] |\()[-+−=<>] (?=[a-z])"  # a letter, a sign: `k unlocks`
    r"|(?:^|· )[,.] (?=\S)"
)


@cache
def trees() -> dict[Path, ast.Module]:
    """The source of the session, file by file."""
    return {path: ast.parse(path.read_text(encoding="utf-8")) for path in SOURCE.rglob("*.py")}


def texts(tree: ast.AST) -> Iterator[tuple[ast.Call, str]]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and getattr(node.func, "id", "") in ("Text", "plural"):
            for part in node.args:
                if isinstance(part, ast.Constant) and isinstance(part.value, str):
                    yield node, part.value


@pytest.mark.parametrize(
    ("text", "named"),
    [
        ("F1 more", True),
        ("locked: {reason} (k unlocks)", True),
        ("- leaves the step out", True),
        ("Enter applies it · w writes a table", True),
        ("take it with ^p", True),
        (", . other pictures", True),
        ("Enter takes it · . the next", True),
        ("{key} accepts it, with a reason.", False),
        ("Enter goes back, ↓ to the list ({columns}; Shift+→ ←)", False),
        ("the value of a design, 3 to 5", False),
        (", ", False),
    ],
)
def test_what_names_a_key_is_seen(text: str, named: bool) -> None:
    assert bool(NAMED.search(text)) is named


def test_no_text_names_a_key_that_may_be_another_one() -> None:
    """It names it through `shown_key`, as the user's key map has it."""
    wrong = [
        f"{path.relative_to(SOURCE)}:{node.lineno}: {text}"
        for path, tree in trees().items()
        if "commands" not in path.parts
        for node, text in texts(tree)
        if NAMED.search(text) and text != "+ add"  # which is a button
    ]
    assert wrong == []


# Where no field can have the cursor while the text stands there, a letter is as good as a key.
WITHOUT_FIELDS = {"compare.py", "drive.py", "explain.py", "ready.py", "remedies.py", "selection.py"}
IN_ITS_PANE = {"picture.py"}  # said in a pane of its own keys, which are so once it has the focus
WITH_THE_FOCUS = {"add", "leave_out"}  # said at the foot of the form by what has the focus itself
GIVES_KEYS = {"shown_key", "key"}


def said_keys(function: ast.AST) -> Iterator[str]:
    for node in ast.walk(function):
        if isinstance(node, ast.Call) and node.args and isinstance(node.args[0], ast.Constant):
            name = getattr(node.func, "attr", getattr(node.func, "id", ""))
            if name in GIVES_KEYS and str(node.args[0].value) in BY_ID:
                yield str(node.args[0].value)


def test_a_key_that_is_named_works_while_a_field_has_the_cursor() -> None:
    """Or the text says that the field is to be left first."""
    seen, wrong = set(), []
    for path, tree in trees().items():
        if path.name in WITHOUT_FIELDS | IN_ITS_PANE:
            continue
        for function in ast.walk(tree):
            if isinstance(function, ast.FunctionDef | ast.AsyncFunctionDef):
                ids = set(said_keys(function))
                seen |= ids
                for id in ids - WITH_THE_FOCUS:
                    moves = BY_ID[id].letters in MOVING  # in what has the focus itself
                    if not BY_ID[id].keys and not moves and "leave" not in ids:
                        wrong.append(f"{path.name} {function.name}: {id}")
    assert wrong == [] and {"fix", "accept", "record", "reload", "walk_on"} <= seen


# --- the user's key map
@pytest.mark.slow
async def test_a_key_map_holds_on_every_screen(light: Session) -> None:
    """Through textual's own, by the ids of the table: on the main screen, on those over it, and in what is said."""
    light.solve()
    app = ContralberoApp(light, key_map={"save": "ctrl+g", "lock": "f5", "quit": "ctrl+e", "down": "n"})
    async with app.run_test(size=(120, 40)) as pilot:
        await go_to(pilot, "engine.bore_mm")
        await strike(pilot, *"95", "enter", "ctrl+s")
        await settled(pilot)
        assert light.dirty  # it has lost its key
        await strike(pilot, "ctrl+g")
        await until(pilot, lambda: not light.dirty)
        await go_to(pilot, "engine.bore_mm")
        await strike(pilot, "f5")
        assert light.lock_reason("engine.bore_mm")
        work(pilot).leave_pane()
        assert "m Remedy" in text(pilot)  # its first key was taken
        await strike(pilot, "m")
        await over(pilot, Remedies)
        await strike(pilot, "ctrl+g", "escape", "D")
        ready = await over(pilot, ReadyScreen)
        assert "^g save" in text(pilot)
        before = ready.query_one(ItemList).cursor
        await strike(pilot, "n")
        assert ready.query_one(ItemList).cursor > before
        await strike(pilot, "ctrl+e")
        await until(pilot, lambda: app.return_code == 0)


# --- saving, wherever a design is open
SOME = (("f1", HelpScreen), ("ctrl+p", Palette), ("D", ReadyScreen), ("ctrl+o", OpenDialog))


def test_every_screen_has_the_key_that_saves() -> None:
    """But the question with two answers, which may be the one how to save."""
    without = []
    for kind in widgets():
        if issubclass(kind, TextualScreen) and "compose" in {name for base in kind.__mro__[:-3] for name in vars(base)}:
            bindings = [b for base in kind.__mro__ for b in Binding.make_bindings(vars(base).get("BINDINGS", ()))]
            if not any(binding.id == "save" for binding in bindings):
                without.append(kind)
    assert without == [Ask]


@pytest.mark.slow
async def test_a_design_is_saved_from_every_screen(screen: Screen, light: Session) -> None:
    async with screen(size=(120, 40)) as pilot:
        work(pilot).leave_pane()
        for n, (key, kind) in enumerate(SOME):
            light.edit(light.place("engine.bore_mm"), f"{95 + n}")
            await strike(pilot, key)
            await over(pilot, kind)
            await strike(pilot, "ctrl+s")
            await until(pilot, lambda: not light.dirty)
            assert f"bore_mm = {95 + n}" in light.home.read_text(encoding="utf-8"), kind
            await strike(pilot, "escape")
            await until(pilot, lambda: pilot.app.screen is pilot.app.screen_stack[0])
        # but where it is asked how to save, the question stays one
        await strike(pilot, "f12")
        asked = await over(pilot, SaveDialog)
        await strike(pilot, "ctrl+s", "ctrl+s")
        await pilot.pause()
        assert pilot.app.screen is asked
