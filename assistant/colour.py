# SPDX-License-Identifier: Apache-2.0
"""Verdicts in colour where the text goes to a terminal; anywhere else it stays as it is."""

import os
import re
from collections.abc import Callable
from typing import TextIO

Paint = Callable[[str], str]
# verdicts as `results_text.sign` writes them, states as the first line has them, and the signs alone
COLOURS = {
    "red": ("✗ FAIL", "✗ NO SOLUTION", "FAIL", "NO SOLUTION", "✗"),
    "yellow": ("▲ warn", "? not verified", "? not judged", "WARN", "NOT VERIFIED", "NOT JUDGED"),
    "green": ("✓ pass", "PASS", "✓"),
}
STYLE_OF = {words: style for style, many in COLOURS.items() for words in many}
# a state stands at the beginning of a line, or behind the name of its file
VERDICT = re.compile(
    "|".join(
        rf"{'(?:(?<=: )|^)' if words[0].isascii() and words[0].isalpha() else ''}{re.escape(words)}(?!\w)"
        for words in sorted(STYLE_OF, key=len, reverse=True)
    ),
    re.MULTILINE,
)


def paint_for(stream: TextIO) -> Paint | None:
    """What colours a text for this stream; None where it shall stay as it is: no terminal, one without colours, or
    NO_COLOR is set (https://no-color.org)."""
    if os.environ.get("NO_COLOR") or not stream.isatty():
        return None
    from rich.color import ColorSystem
    from rich.console import Console
    from rich.style import Style

    console = Console(file=stream)
    if console.color_system is None or console.legacy_windows:
        return None
    styles = {name: Style(color=name, bold=True) for name in COLOURS}

    def paint(text: str) -> str:
        return VERDICT.sub(
            lambda match: styles[STYLE_OF[match[0]]].render(match[0], color_system=ColorSystem.STANDARD), text
        )

    return paint
