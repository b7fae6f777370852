# SPDX-License-Identifier: Apache-2.0
"""What becomes of every line before it is written on the screen: nothing in it is obeyed by the terminal, words stand
out from what is behind them, and with plain signs all of it is ASCII."""

import re
from functools import lru_cache, partial

from rich.cells import cell_len
from rich.color import Color as RichColor
from rich.color import ColorType, blend_rgb
from rich.color_triplet import ColorTriplet
from rich.segment import Segment
from rich.style import Style
from rich.terminal_theme import TerminalTheme
from textual.color import Color
from textual.filter import LineFilter

from calc.sheet.in_ascii import in_ascii
from calc.sheet.visible import visible

# --- harmless
# Characters that a terminal would obey are written out: a name in a design file may hold any.

BLANKS = re.compile(" {2,}")


class Legible(LineFilter):
    """The line stays as wide as it was: what is written out takes its room from blanks beside it, else from the line's
    end."""

    def apply(self, segments: list[Segment], background: Color) -> list[Segment]:
        if all(segment.control or segment.text.isprintable() for segment in segments):
            return segments
        printable, owed = [], 0
        for segment in segments:
            text = segment.text if segment.control else visible(segment.text)
            owed += cell_len(text) - cell_len(segment.text)
            if owed and not segment.control:
                text, owed = _shortened(text, owed)
            printable.append(Segment(text, segment.style, segment.control))
        return Segment.adjust_line_length(printable, Segment.get_line_length(segments)) if owed else printable


def _shortened(text: str, owed: int) -> tuple[str, int]:
    """The text with fewer blanks where several follow each other, and how many cells are still too many."""

    def fewer(blanks: re.Match[str]) -> str:
        nonlocal owed
        taken = min(owed, len(blanks[0]) - 1)
        owed -= taken
        return blanks[0][taken:]

    return BLANKS.sub(fewer, text), owed


# --- ASCII


class Ascii(LineFilter):
    """What is left of other letters, where texts are in ASCII already: names of the user in fields, lines and bars.
    Each takes the cells that it took."""

    def apply(self, segments: list[Segment], background: Color) -> list[Segment]:
        if all(segment.text.isascii() for segment in segments):
            return segments
        return [Segment(_cells(segment.text), segment.style, segment.control) for segment in segments]


LINES = str.maketrans(
    {
        **dict.fromkeys("─━╍┈╌▁▂▃", "-"),
        **dict.fromkeys("│┃▏▎▍▕", "|"),
        **dict.fromkeys("┌┐└┘├┤┬┴┼┏┓┗┛┣┫┳┻╋", "+"),
        **dict.fromkeys("▄▅▆▇█▒▀▐▌▊", "#"),
        "░": ".",
        "…": "~",
    }
)


def _cells(text: str) -> str:
    """As many cells in ASCII."""
    if text.isascii():
        return text
    letters = (in_ascii(letter)[:1].ljust(cell_len(letter)) for letter in text.translate(LINES))
    return "".join(letters)


# --- readable
# Words keep their distance from what is behind them, on the row under the cursor too, whatever the theme; in a theme of
# the terminal's own colours these are taken as most terminals have them.

CONTRAST = 4.5  # of words against what is behind them, at least: WCAG 2.2, 1.4.3
LIFTS = 20  # steps from a colour to black or white
BLACK, WHITE = ColorTriplet(0, 0, 0), ColorTriplet(255, 255, 255)
GREY = ColorTriplet(0xAA, 0xAA, 0xAA)  # of words in a dark terminal, at the darkest
ANSI_BLACK, ANSI_WHITE = 0, 15
XTERM = TerminalTheme(  # the sixteen colours of xterm; those of other terminals are near them
    BLACK,
    GREY,
    [BLACK, (205, 0, 0), (0, 205, 0), (205, 205, 0), (0, 0, 238), (205, 0, 205), (0, 205, 205), (229, 229, 229)],
    [(127, 127, 127), (255, 0, 0), (0, 255, 0), (255, 255, 0), (92, 92, 255), (255, 0, 255), (0, 255, 255), WHITE],
)
WRITTEN = re.compile(r"[^\s\u2500-\u259f\u2800-\u28ff]")  # neither a line, nor a bar, nor a dot of a picture


class Readable(LineFilter):
    """`dark`: what is behind words that have nothing of their own behind them."""

    def __init__(self, dark: bool) -> None:
        super().__init__()
        self.dark = dark

    def apply(self, segments: list[Segment], background: Color) -> list[Segment]:
        return [
            Segment(text, readable(style, self.dark), control)
            if style is not None and not control and WRITTEN.search(text)
            else Segment(text, style, control)
            for text, style, control in segments
        ]


@lru_cache(4096)
def readable(style: Style, dark: bool) -> Style:
    """The style with a lighter or darker colour of its letters, where they would hardly be seen."""
    paper, ink = (BLACK, GREY) if dark else (WHITE, BLACK)
    behind, letters = style.bgcolor, style.color
    if style.reverse:
        behind, letters, paper, ink = letters, behind, ink, paper
    back = behind.get_truecolor(XTERM) if behind is not None and not behind.is_default else paper
    front = letters.get_truecolor(XTERM) if letters is not None and not letters.is_default else ink
    if contrast(front, back) >= CONTRAST:
        return style
    end = max(BLACK, WHITE, key=partial(contrast, back))
    if behind is not None and behind.type is ColorType.STANDARD:
        seen = RichColor.from_ansi(ANSI_BLACK if end == BLACK else ANSI_WHITE)
    else:
        lifted = (blend_rgb(front, end, n / LIFTS) for n in range(1, LIFTS + 1))
        seen = RichColor.from_triplet(next((ink for ink in lifted if contrast(ink, back) >= CONTRAST), end))
    return style + (Style(bgcolor=seen) if style.reverse else Style(color=seen))


def contrast(some: ColorTriplet, other: ColorTriplet) -> float:
    """The ratio of contrast of two colours, 1 to 21: WCAG 2.2."""
    dark, light = sorted((_luminance(some), _luminance(other)))
    return (light + 0.05) / (dark + 0.05)


def _luminance(colour: ColorTriplet) -> float:
    """Relative luminance of a colour of sRGB, 0 to 1: WCAG 2.2."""
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in colour.normalized]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


# --- one of each

READABLE = {dark: Readable(dark) for dark in (True, False)}
LEGIBLE, PLAIN = Legible(), Ascii()
