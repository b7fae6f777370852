# SPDX-License-Identifier: Apache-2.0
"""Figures as pixels, on a terminal that shows them: by the protocol of Kitty, of iTerm2, or as Sixel.

The terminal is known by what it says of itself in the environment; nothing is asked of it, since an answer would come
as keys."""

import base64
import sys
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from calc.locale import Language
from calc.sheet.step import Curve
from calc.sheet.text import Text

from ..output import bare

if TYPE_CHECKING:
    from numpy import uint8
    from numpy.typing import NDArray

KITTY, ITERM, SIXEL = "kitty", "iterm2", "sixel"
CHUNK = 4096  # characters of base64 that Kitty takes at a time
SIZE = 520.0, 300.0  # points
LEVELS = 6  # of each of red, green and blue in a Sixel picture: 216 colours


def protocol(environment: Mapping[str, str]) -> str:
    """How this terminal shows pixels; empty where it does not say that it does, or where another program stands
    between."""
    asked = environment.get("CONTRALBERO_PIXELS", "")
    if asked in (KITTY, ITERM, SIXEL):
        return asked
    if environment.get("TMUX") or environment.get("STY") or asked == "none":
        return ""
    terminal, program = environment.get("TERM", ""), environment.get("TERM_PROGRAM", "")
    if "kitty" in terminal or "ghostty" in terminal or program.lower() == "ghostty":
        return KITTY
    if program in ("iTerm.app", "WezTerm"):
        return ITERM
    return SIXEL if terminal.startswith(("foot", "mlterm", "contour", "yaft")) else ""


def kitty(png: bytes) -> Iterator[str]:
    """The picture in pieces, the first of which says that it is a PNG to be shown here."""
    text = base64.standard_b64encode(png).decode()
    pieces = [text[at : at + CHUNK] for at in range(0, len(text), CHUNK)]
    for n, piece in enumerate(pieces):
        start = "f=100,a=T," if n == 0 else ""
        yield f"\x1b_G{start}m={int(n < len(pieces) - 1)};{piece}\x1b\\"


def iterm2(png: bytes) -> Iterator[str]:
    yield f"\x1b]1337;File=inline=1;size={len(png)}:{base64.standard_b64encode(png).decode()}\x07"


def sixel(pixels: "NDArray[uint8]") -> Iterator[str]:
    """Rows of six dots, colour by colour; equal dots that follow each other are counted."""
    import numpy as np

    step = 255 / (LEVELS - 1)
    levels = np.rint(pixels / step).astype(int)
    index = (levels[:, :, 0] * LEVELS + levels[:, :, 1]) * LEVELS + levels[:, :, 2]
    yield f'\x1bPq"1;1;{pixels.shape[1]};{pixels.shape[0]}'
    for colour in np.unique(index):
        red, rest = divmod(int(colour), LEVELS * LEVELS)
        shares = (round(100 * part / (LEVELS - 1)) for part in (red, *divmod(rest, LEVELS)))
        yield f"#{colour};2;" + ";".join(map(str, shares))
    weights = 2 ** np.arange(6)
    for top in range(0, index.shape[0], 6):
        band = index[top : top + 6]
        for colour in np.unique(band):
            bits = ((band == colour) * weights[: len(band), None]).sum(axis=0)
            ends = np.append(np.flatnonzero(np.diff(bits)) + 1, len(bits))
            counts = np.diff(ends, prepend=0)
            yield (
                f"#{colour}"
                + "".join(f"!{n}{chr(63 + bit)}" for n, bit in zip(counts.tolist(), bits[ends - 1].tolist()))
                + "$"
            )
        yield "-"
    yield "\x1b\\"


def show(curve: Curve, how: str, say: Language) -> None:
    """Write the figure to the terminal, and wait for Enter.  The curve's texts are said in the language already."""
    from reports.figures.pixels import pixels, png

    if how == SIXEL:
        pieces = sixel(pixels(curve, *SIZE, say))
    else:
        pieces = (kitty if how == KITTY else iterm2)(png(curve, *SIZE, say))
    out = bare()
    out.write("\n" + "".join(pieces) + "\n" + say(Text("Enter goes back")) + " ")
    out.flush()
    sys.stdin.readline()
