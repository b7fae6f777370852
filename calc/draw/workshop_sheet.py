# SPDX-License-Identifier: Apache-2.0
"""The drawing sheet: a page of A3 or A2 with frame and title block, and views, tables and notes put together on it.

Frame, centring marks and grid references as ISO 5457 has them, the title block of ISO 7200."""

import itertools
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING

from ..sheet.record import record
from ..sheet.text import Text
from .annotations import COLUMNS, LETTER, TITLE, Leaf, SheetTable
from .drawing import EDGE, FRAME, TABLE, VISIBLE, Ink, Point, enlarged, moved
from .lettering import shortened, width, wrapped
from .sizes import Say

if TYPE_CHECKING:
    from ..design.other_tables import DocumentControl

MM = 1e-3
LEFT, LOW, ELSEWHERE = 20.0, 10.0, 10.0  # the frame: 20 mm for filing, 10 mm elsewhere
BORDER = 5.0  # of the grid references, around the frame
FIELD = 50.0  # of the grid, counted from the middles of the page
CENTRING = 10.0  # how far a centring mark goes on within the frame
BLOCK, BLOCK_TOP = 180.0, LOW + 46.0  # of the title block: its width, and how far up the sheet it reaches
STAMP = 14.0  # height of what stands above it: whether the sheet may be used
PAD = 1.5
HEAD = 5.0  # the title's letters, where they have room
LETTERS = "ABCDEFGHJKLM"  # of the grid: I and O are left out


@record
class Paper:
    """A size of ISO 5457, lying; all in mm."""

    name: str
    wide: float
    high: float

    @property
    def right(self) -> float:
        return self.wide - ELSEWHERE

    @property
    def top(self) -> float:
        return self.high - ELSEWHERE

    @property
    def block_left(self) -> float:
        return self.right - BLOCK


A3, A2 = Paper("A3", 420.0, 297.0), Paper("A2", 594.0, 420.0)


def frame(leaf: Leaf, paper: Paper) -> None:
    """Frame, border of the grid, centring marks, and the name of the size of the paper."""
    leaf.box(FRAME, LEFT, LOW, paper.right, paper.top)
    left, low, right, top = LEFT - BORDER, LOW - BORDER, paper.right + BORDER, paper.top + BORDER
    leaf.box(TABLE, left, low, right, top)
    mid_x, mid_y = paper.wide / 2, paper.high / 2
    for outer, inner in ((low, LOW + CENTRING), (top, paper.top - CENTRING)):
        leaf.line(FRAME, (mid_x, outer), (mid_x, inner))
    for outer, inner in ((left, LEFT + CENTRING), (right, paper.right - CENTRING)):
        leaf.line(FRAME, (outer, mid_y), (inner, mid_y))
    for n, (a, b) in enumerate(_fields(mid_x, LEFT, paper.right), 1):
        for y in (low, paper.top):
            leaf.words(str(n), (a + b) / 2, y + (BORDER - LETTER) / 2, "centre", layer=TABLE)
            if b < paper.right:
                leaf.line(TABLE, (b, y), (b, y + BORDER))
    for n, (a, b) in enumerate(reversed(_fields(mid_y, LOW, paper.top))):
        for x in (left, paper.right):
            leaf.words(LETTERS[n], x + BORDER / 2, (a + b - LETTER) / 2, "centre", layer=TABLE)
            if a > LOW:
                leaf.line(TABLE, (x, a), (x + BORDER, a))
    leaf.words(paper.name, right - 1.0, 1.0, "right", layer=TABLE)


def _fields(middle: float, first: float, last: float) -> list[tuple[float, float]]:
    """The fields of the grid on one side, those at its ends shorter or longer than the others."""
    count = 2 * round((last - middle) / FIELD)
    ends = [first, *(middle + FIELD * (n - count // 2) for n in range(1, count)), last]
    return list(itertools.pairwise(ends))


def title_block(
    leaf: Leaf, paper: Paper, control: "DocumentControl", part: "DrawnPart", kind: str, facts: dict[str, str], say: Say
) -> None:
    """Who owns, drew, checked and approved what; `facts`: scale, material, mass.  What is left empty is filled in by
    hand."""
    by = dict(control.signatures())
    said_title = say(Text("Title, part of {design}", design=part.of)) if part.of else say(Text("Title"))
    dates = [by[key].date for key in ("approved", "checked", "prepared") if by[key].date]
    rows: Sequence[tuple[float, list[tuple[float, str, str]]]] = (
        (
            11.0,
            [
                (46.0, say(Text("Legal owner")), control.company),
                (58.0, say(Text("Project")), control.project),
                (40.0, say(Text("Customer")), control.customer),
                (18.0, say(Text("Scale")), facts["scale"]),
                (18.0, "", ""),
            ],
        ),
        (13.0, [(120.0, said_title, part.title), (60.0, say(Text("Number")), control.number)]),
        (
            11.0,
            [
                (42.0, say(Text("Material")), facts["material"]),
                (40.0, say(Text("Mass, as calculated")), facts["mass"]),
                (38.0, say(Text("Document type")), kind),
                (34.0, say(Text("Date of issue")), dates[0] if dates else ""),
                (26.0, say(Text("Revision")), control.revision),
            ],
        ),
        (
            11.0,
            [
                (54.0, say(Text("Prepared")), by["prepared"].name),
                (54.0, say(Text("Checked")), by["checked"].name),
                (54.0, say(Text("Approved")), by["approved"].name),
                (18.0, say(Text("Sheet")), facts["sheet"]),
            ],
        ),
    )
    left = paper.block_left
    leaf.box(VISIBLE, left, LOW, paper.right, BLOCK_TOP)
    y = BLOCK_TOP
    for high, cells in rows:
        x = left
        for wide, label, value in cells:
            size = next(
                (h for h in (HEAD, TITLE) if h <= high - LETTER - 3 * PAD and width(value, h) <= wide - 2 * PAD), LETTER
            )
            leaf.words(shortened(label, LETTER, wide - 2 * PAD), x + PAD, y - PAD - LETTER, layer=TABLE)
            leaf.words(shortened(value, size, wide - 2 * PAD), x + PAD, y - high + PAD, height=size)
            if x > left:
                leaf.line(TABLE, (x, y), (x, y - high))
            x += wide
        y -= high
        if y > LOW + 0.1:
            leaf.line(TABLE, (left, y), (paper.right, y))
    first_angle(leaf, paper.right - 8.5, BLOCK_TOP - 5.5)


@record
class Release:
    """Whether a sheet may be used.  `verdict`: of the whole design; `approved`: by whom and when, empty where nobody
    has; `design`: the first digits of its file's SHA-256, empty where it has no file."""

    passes: bool
    verdict: Text
    approved: str
    design: str = ""

    @property
    def words(self) -> Text:
        if self.passes and self.approved:
            return Text("Released: {approved}", approved=self.approved)
        return Text("PRELIMINARY, NOT FOR MANUFACTURE")

    @property
    def judged(self) -> Text:
        verdict = Text("Calculation: {verdict}", verdict=self.verdict)
        return verdict if self.approved else Text("{verdict}; not approved", verdict=verdict)


def stamp(leaf: Leaf, paper: Paper, release: Release, say: Say) -> None:
    """Above the title block: for what the sheet is good, the verdict of the design, and which design it is of."""
    left, low, right, top = paper.block_left, BLOCK_TOP, paper.right, BLOCK_TOP + STAMP
    leaf.box(VISIBLE, left, low, right, top)
    wide = BLOCK - 2 * PAD
    verdict = say(release.judged)
    design = say(Text("design {digest}", digest=release.design)) if release.design else ""
    leaf.words(shortened(say(release.words), HEAD, wide), left + PAD, top - PAD - HEAD, height=HEAD)
    leaf.words(design, right - PAD, low + PAD, "right", layer=TABLE)
    room = wide - (width(design, LETTER) + PAD if design else 0.0)
    leaf.words(shortened(verdict, LETTER, room), left + PAD, low + PAD, layer=TABLE)


def first_angle(leaf: Leaf, x: float, y: float) -> None:
    """The symbol of first-angle projection, ISO 5456-2: a cone from its side, and behind it as seen from its narrow
    end."""
    small, large, long = 1.25, 2.5, 5.0
    side = x - 8.0
    narrow, wide = [(side, y - small), (side, y + small)], [(side + long, y - large), (side + long, y + large)]
    leaf.line(VISIBLE, narrow[0], *wide, narrow[1], closed=True)
    leaf.arc(VISIBLE, (x + 3.5, y), small)
    leaf.arc(VISIBLE, (x + 3.5, y), large)
    leaf.line(EDGE, (side - 1.0, y), (x + 7.0, y))
    leaf.line(EDGE, (x + 3.5, y - large - 1.0), (x + 3.5, y + large + 1.0))


# --- a sheet put together
# The views in the largest scale of ISO 5455 that the paper has room for, tables and notes beside them.  The paper is
# A3, or A2 for what is shown larger there: not above its full size.

SCALES = ((10, 1), (5, 1), (2, 1), (1, 1), (1, 2), (1, 5), (1, 10), (1, 20))
MARGIN, BELOW = 4.0, 4.0
UNDER_MARK = 12.0  # below the frame's centring mark
LINE = 3.9  # from one line of a note to the next


@record
class WorkshopSheet:
    """A drawing on its paper: every mark where it stands, in metres from the lower left corner.

    `views`: what shows the part, at a scale, paper over part; `around`: frame, tables, notes; `origin`: where the
    part's own origin stands."""

    title: str
    paper: Paper
    scale: float
    views: tuple[Ink, ...]
    around: tuple[Ink, ...]
    origin: Point

    @property
    def marks(self) -> tuple[Ink, ...]:
        return (*self.around, *self.views)

    @property
    def part(self) -> tuple[Ink, ...]:
        """The views in full size about the part's own origin, their letters larger in the same measure."""
        (x, y), by = self.origin, 1 / self.scale
        return tuple(enlarged(moved(mark, -x, -y), by) for mark in self.views)


@record
class DrawnPart:
    """What the title block says of the part; empty: nobody knows.  `of`: what it is a part of."""

    title: str
    material: str
    mass: str = ""
    sheet: str = "1/1"
    of: str = ""


def composed(
    part: DrawnPart,
    views: Callable[[float], Leaf],
    beside: Iterable[SheetTable],
    notes: Iterable[Text],
    control: "DocumentControl",
    say: Say,
    kind: Text,
    release: Release | None = None,
) -> WorkshopSheet:
    """`views`: drawn in a scale, wherever they stand; `beside`: the tables; `kind`: of the document."""
    said, parts = [say(note) for note in notes], list(beside)
    around = {paper: (tables(parts, paper), _noted(said, paper)) for paper in (A3, A2)}
    for over, under in SCALES:
        drawn = views(over / under)
        left, low, right, top = drawn.extent
        for paper in (A3, A2) if over <= under else (A3,):
            columns, noted = around[paper]
            wide, high = _room(paper, columns, noted)
            if fits := right - left <= wide and top - low <= high:
                break
        if fits:
            break
    sheet, shown = Leaf(), Leaf()
    frame(sheet, paper)
    sheet.add(columns, _columns_left(paper), paper.top)
    x, y = LEFT + MARGIN + (wide - right - left) / 2, paper.top - MARGIN - (high + top + low) / 2
    shown.add(drawn, x, y)
    sheet.add(noted, LEFT + MARGIN, LOW + MARGIN)
    facts = {"scale": f"{over}:{under}", "material": part.material, "mass": part.mass, "sheet": part.sheet}
    title_block(sheet, paper, control, part, say(kind), facts, say)
    if release is not None:
        stamp(sheet, paper, release, say)
    return WorkshopSheet(part.title, paper, over / under, tuple(shown.marks), tuple(sheet.marks), (x * MM, y * MM))


def _columns_left(paper: Paper) -> float:
    return paper.right - sum(COLUMNS)


def _room(paper: Paper, columns: Leaf, noted: Leaf) -> tuple[float, float]:
    """Width and height of what tables and notes leave to the views."""
    beside = min(0.0, columns.extent[0]) if columns.marks else 0.0  # columns of tables beside the first
    wide = _columns_left(paper) + beside - LEFT - 2 * MARGIN
    return wide, paper.top - LOW - 3 * MARGIN - noted.extent[3]


def tables(parts: Iterable[SheetTable], paper: Paper = A3) -> Leaf:
    """Tables one below the other: head, rows, widths of the columns; those without rows are left out.  None stands on
    the centring mark of the frame.  What has no room above the title block stands in a further column to the left."""
    leaf, x, y, mark = Leaf(), 0.0, 0.0, paper.high / 2 - paper.top
    for head, rows, columns in parts:
        if rows:
            block = Leaf()
            block.table(rows, columns, head)
            low = block.extent[1]
            if not x and y + low < mark < y < 0:
                y = mark - BELOW / 2
            if y < 0 and y + low < BLOCK_TOP + STAMP + BELOW - paper.top:
                x, y = x - sum(COLUMNS) - BELOW, -UNDER_MARK
            leaf.add(block, x, y)
            y += low - BELOW
    return leaf


def _noted(notes: Iterable[str], paper: Paper) -> Leaf:
    """The notes, numbered, from the lower left corner upwards; they end short of the centring mark."""
    leaf, most = Leaf(), paper.wide / 2 - LEFT - 2 * MARGIN
    lines = []
    for n, note in enumerate(notes, 1):
        for i, line in enumerate(wrapped(note, LETTER, most - 7.0)):
            lines.append((f"{n}" if i == 0 else "", line))
    for n, (mark, line) in enumerate(lines):
        y = (len(lines) - 1 - n) * LINE
        leaf.words(mark, 0.0, y)
        leaf.words(line, 6.0, y)
    return leaf
