# SPDX-License-Identifier: Apache-2.0
"""A value held against its limit as a bar of a few cells: full at the limit, which has a mark where the value lies beyond it."""

from textual.content import Content

from .signs import Signs

CELLS = 8
EIGHTHS = "▁▂▃▄▅▆▇"  # of the cell in which the value ends


def bar(share: float, signs: Signs, style: str = "", cells: int = CELLS) -> Content:
    """`share`: the value over its limit."""
    full, empty, mark = ("#", ".", "|") if signs.ascii else ("▇", "▁", "│")
    if share > 1:
        at = min(cells - 1, max(1, round(cells / share)))
        return Content.assemble((full * at, style), (mark, "bold"), (full * (cells - 1 - at), style))
    whole, rest = divmod(round(max(0.0, share) * cells * len(EIGHTHS)), len(EIGHTHS))
    last = "" if whole == cells else empty if signs.ascii else EIGHTHS[rest]
    return Content.assemble((full * whole + last, style), (empty * (cells - whole - len(last)), "dim"))
