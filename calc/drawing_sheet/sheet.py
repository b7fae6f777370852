# SPDX-License-Identifier: Apache-2.0
"""A sheet put together: the views in the largest scale of ISO 5455 that the paper has room for, tables and notes beside them."""

from collections.abc import Callable, Iterable

from ..design.other_tables import DocumentControl
from ..draw.drawing import Ink
from ..draw.lettering import wrapped
from ..sheet.record import record
from ..sheet.text import Text
from ..draw.sheet_data import Rows
from ..draw.workshop_sheet import LEFT, LOW, PAPER, RIGHT, TOP, frame, title_block
from ..draw.annotations import LETTER, Leaf
from .saying import Say

SCALES = ((2, 1), (1, 1), (1, 2), (1, 5), (1, 10), (1, 20))
COLUMNS = (68.0, 44.0)  # of a table: what, and how much
TABLE_LEFT = RIGHT - sum(COLUMNS)
MARGIN, BELOW = 4.0, 4.0
LINE = 4.2  # from one line of a note to the next


@record
class Sheet:
    """A drawing on its paper: every mark where it stands, in metres from the lower left corner.  `scale`: of the views, paper over part."""

    title: str
    scale: float
    marks: tuple[Ink, ...]


@record
class Part:
    """What the title block says of the part; empty: nobody knows."""

    title: str
    material: str
    mass: str = ""
    sheet: str = "1/1"


def composed(
    part: Part, views: Callable[[float], Leaf], tables: Leaf, notes: Iterable[Text], control: DocumentControl, say: Say, kind: Text
) -> Sheet:
    """`views`: drawn in a scale, wherever they stand; `kind`: of the document."""
    noted = _noted(notes, say)
    wide, high = TABLE_LEFT - LEFT - 2 * MARGIN, TOP - LOW - 3 * MARGIN - noted.extent[3]
    for over, under in SCALES:
        drawn = views(over / under)
        left, low, right, top = drawn.extent
        if right - left <= wide and top - low <= high:
            break
    sheet = Leaf()
    frame(sheet)
    sheet.add(tables, TABLE_LEFT, TOP)
    sheet.add(drawn, LEFT + MARGIN + (wide - right - left) / 2, TOP - MARGIN - (high + top + low) / 2)
    sheet.add(noted, LEFT + MARGIN, LOW + MARGIN)
    facts = {"scale": f"{over}:{under}", "material": part.material, "mass": part.mass, "sheet": part.sheet}
    title_block(sheet, control, part.title, say(kind), facts, say)
    return Sheet(title=part.title, scale=over / under, marks=tuple(sheet.marks))


def tables(parts: Iterable[tuple[str, Rows, tuple[float, ...]]]) -> Leaf:
    """Tables one below the other: head, rows, widths of the columns; those without rows are left out."""
    leaf, y = Leaf(), 0.0
    for head, rows, columns in parts:
        if rows:
            one = Leaf()
            one.table(rows, columns, head)
            leaf.add(one, 0.0, y)
            y += one.extent[1] - BELOW
    return leaf


def _noted(notes: Iterable[Text], say: Say) -> Leaf:
    """The notes, numbered, from the lower left corner upwards; they end short of the centring mark."""
    leaf, most = Leaf(), PAPER[0] / 2 - LEFT - 2 * MARGIN
    lines = []
    for n, note in enumerate(notes, 1):
        for i, line in enumerate(wrapped(say(note), LETTER, most - 7.0)):
            lines.append((f"{n}" if i == 0 else "", line))
    for n, (mark, line) in enumerate(lines):
        y = (len(lines) - 1 - n) * LINE
        leaf.words(mark, 0.0, y)
        leaf.words(line, 6.0, y)
    return leaf
