# SPDX-License-Identifier: Apache-2.0
"""Signs, words and colours of the states.  Sign and word carry the meaning; the colour only helps."""

from collections.abc import Sequence
from dataclasses import dataclass

from calc.locale import Language, language
from calc.sheet.check import SIGNS
from calc.sheet.step import Series, line_of
from calc.sheet.text import Text

WORDS = {
    "pass": Text("pass"),
    "computed": Text("computed"),
    "warn": Text("warn"),
    "fail": Text("FAIL"),
    "note": Text("note"),
    "not_judged": Text("not judged"),
    "not_verified": Text("not verified"),
    "accepted": Text("accepted"),
    "blocked": Text("waits"),
    "not_asked": Text("not used"),
    "no_solution": Text("NO SOLUTION"),
    "outside": Text("outside validity"),
}
MARKS = SIGNS | {
    "outside": SIGNS["note"],
    "invalid": "!", "edited": "●", "read_only": "▪", "solving": "◌", "cursor": "▸", "here": "◀", "from": "←",
    "yes": "✓", "more": "…",
    "then": "→", "recording": "●", "editing": "✎",
    "todo": "○", "needs": "!", "waits": "◌", "folded": "▸", "unfolded": "▾",
}  # fmt: skip
ASCII = {
    "pass": "+", "computed": "+", "warn": "!", "fail": "x", "note": "-", "not_judged": "?", "not_verified": "?",
    "accepted": "+", "blocked": "o", "not_asked": ".", "no_solution": "x", "outside": "-",
    "invalid": "!", "edited": "*", "read_only": "#", "solving": "o", "cursor": ">", "here": "<", "from": "<-",
    "yes": "+", "more": "...",
    "then": "->", "recording": "@", "editing": "*",
    "todo": "o", "needs": "!", "waits": "o", "folded": "...", "unfolded": ":",
}  # fmt: skip

# Okabe and Ito: told apart by nearly everybody; the darker ones for a light background
DARK = {
    "pass": "#56B4E9",
    "computed": "#56B4E9",
    "warn": "#E69F00",
    "fail": "#D55E00",
    "no_solution": "#D55E00",
    "invalid": "#E69F00",
    "not_verified": "#E69F00",
    "needs": "#E69F00",
    "accepted": "#56B4E9",
    "lit": "#56B4E9",
}
LIGHT = {
    "pass": "#0072B2",
    "computed": "#0072B2",
    "warn": "#8A5A00",
    "fail": "#B04A00",
    "no_solution": "#B04A00",
    "invalid": "#8A5A00",
    "not_verified": "#8A5A00",
    "needs": "#8A5A00",
    "accepted": "#0072B2",
    "lit": "#0072B2",
}
# of a terminal with sixteen colours, which would show a failure and a caution of the above in one
SIXTEEN_DARK = {"pass": "#55FFFF", "warn": "#FFFF55", "fail": "#FF5555"}
SIXTEEN_LIGHT = {"pass": "#0000AA", "warn": "#AA00AA", "fail": "#AA0000"}
BOLD = {"fail", "no_solution", "invalid", "needs", "lit"}
MUTED = "dim"
LINES_DARK = ("#56B4E9", "#E69F00", "#009E73", "#CC79A7", "#F0E442")
LINES_LIGHT = ("#0072B2", "#8A5A00", "#007A5A", "#A04A7D", "#6E6700")

LINES_GREY = ("#C0C0C0", "#808080")
# whole, dashed, dotted; where the colours are used up, or there are none
LINE_MARKS, BAR_MARKS = (("━", "╍", "┈"), "█▒░")
# a chain line, which no series has; so that a limit is known without its colour
LIMIT, LIMIT_MARK = (len(LINE_MARKS), "─·─")
PLAIN_MARKS = "*x=o%&"


@dataclass(frozen=True)
class Look:
    """How one line, or one set of bars, is told from the others.  `pattern`: 0 whole, 1 dashed, 2 dotted, 3 chain;
    `plain`: its character where nothing finer can be drawn, else empty."""

    colour: str
    pattern: int = 0
    plain: str = ""

    @property
    def line_mark(self) -> str:
        return self.plain or (*LINE_MARKS, LIMIT_MARK)[self.pattern]

    @property
    def bar_mark(self) -> str:
        return self.plain or BAR_MARKS[self.pattern]


def _sixteen(dark: bool) -> dict[str, str]:
    """The colour of each state where there are sixteen."""
    many, few = (DARK, SIXTEEN_DARK) if dark else (LIGHT, SIXTEEN_LIGHT)
    kinds = {many[kind]: colour for kind, colour in few.items()}
    return {state: kinds[colour] for state, colour in many.items()}


class Signs:
    """The signs as this terminal can show them, with words in the user's language and styles for its background."""

    def __init__(
        self,
        ascii: bool = False,
        dark: bool = True,
        colour: bool = True,
        say: Language | None = None,
        sixteen: bool = False,
    ) -> None:
        self.ascii, self.dark, self.colour = ascii, dark, colour
        self.colours = _sixteen(dark) if sixteen else DARK if dark else LIGHT
        self.say = say or language("en")
        self.marks = ASCII if ascii else MARKS

    def mark(self, state: str) -> str:
        return self.marks[state]

    def word(self, state: str) -> str:
        """The word of a state."""
        return self.say(WORDS[state])

    def style(self, state: str) -> str:
        colour = self.colours.get(state)
        if colour is None:
            return MUTED
        if not self.colour:
            return "bold" if state in BOLD else "not dim"
        return f"bold {colour}" if state in BOLD else colour

    def look(self, n: int, among: Sequence[Series] = ()) -> Look:
        """Of the n-th line, or set of bars, of a curve; `among`: of these, some of which may be dashed.  Without
        colours, grey and pattern change together."""
        lines = LINES_GREY if not self.colour else LINES_DARK if self.dark else LINES_LIGHT
        pattern = n // len(lines) if self.colour else n
        if any(series.dashed for series in among) and n < len(among):
            n, pattern = line_of(among, n), int(among[n].dashed)
        return Look(
            lines[n % len(lines)], pattern % len(LINE_MARKS), PLAIN_MARKS[n % len(PLAIN_MARKS)] if self.ascii else ""
        )

    def limit(self) -> Look:
        """Of a limit in a curve."""
        return Look(self.colours["fail"] if self.colour else "#FFFFFF", LIMIT, "-" if self.ascii else "")

    def point(self, chosen: bool) -> str:
        """Where the cursor stands on a line."""
        return "#" if self.ascii else "◆" if chosen else "◇"
