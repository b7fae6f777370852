# SPDX-License-Identifier: Apache-2.0
"""What the session and the report say is a Text, which a language can look up; a plain string would be shown as it
stands."""

import ast
from pathlib import Path

import pytest

from tests.languages.texts import ROOT

SPEAKERS = {"say", "tell", "forget"}
FILES = [
    path
    for folder in ("assistant", "reports")
    for path in sorted((ROOT / folder).rglob("*.py"))
    if path.parent != ROOT / "assistant" / "commands"  # the command line prints English
]


def plain(tree: ast.AST) -> list[str]:
    """The strings and f-strings that are handed to a language, or told, as they stand."""
    calls = (node for node in ast.walk(tree) if isinstance(node, ast.Call) and node.args)
    return [
        ast.unparse(call)
        for call in calls
        if _speaker(call.func)
        and any(isinstance(part, (ast.JoinedStr, ast.Constant)) for part in _choices(call.args[0]))
    ]


def _speaker(func: ast.expr) -> bool:
    """`say`, `app.say`, `app.tell`; not the method of a dialog that shows what has been said."""
    if isinstance(func, ast.Name):
        return func.id in SPEAKERS
    owner = func.value if isinstance(func, ast.Attribute) else None
    name = getattr(owner, "attr", getattr(owner, "id", ""))
    return isinstance(func, ast.Attribute) and func.attr in SPEAKERS and name in ("app", "signs", "context")


def _choices(node: ast.expr) -> list[ast.expr]:
    return [*_choices(node.body), *_choices(node.orelse)] if isinstance(node, ast.IfExp) else [node]


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_nothing_plain_is_said(path: Path) -> None:
    assert plain(ast.parse(path.read_text(encoding="utf-8"))) == []


def test_the_scan_finds_what_is_plain() -> None:
    assert len(FILES) > 100  # 121 of them
    for code in (
        'say("Saved")',
        'self.app.tell(f"Saved: {path}")',
        'app.say("a" if x else Text("b"))',
        'context.say(f"{n} lines")',
    ):
        assert plain(ast.parse(code)), code
    for code in ('say(Text("Saved"))', "app.tell(text)", 'self.say("")', 'app.tell(Text("Saved: {path}", path="x"))'):
        assert plain(ast.parse(code)) == [], code
