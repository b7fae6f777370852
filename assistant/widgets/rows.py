# SPDX-License-Identifier: Apache-2.0
"""The rows of a form, read from the descriptions of the inputs and put into the order of the route; and field help.

A table that may be left out has fields only where it is there. Elements stand side by side where they fit; else a short
array stands there whole, and of a long one only one element does: its heading leafs through them.  The stroke is asked
for in place of the crank radius, which is half of it."""

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from textual.content import Content
from textual.widget import Widget

from calc.countershaft.inputs import ShaftInputs
from calc.countershaft.rows import OF_ORIGINAL, BearingRow, titled
from calc.design.addresses import Table, as_list, as_table, keys_of, own_keys
from calc.design.labels import SHAFTS, Place, content_at, with_bearings
from calc.design.model import Design
from calc.engine.inputs import EngineInputs
from calc.locale import Language
from calc.sheet.quantity import THUMB, Quantity, dotted, keys
from calc.sheet.step import Step
from calc.sheet.text import COMMA, Amount, Name, Small, Text

from ..base_app import BaseApp
from ..session.guide import (
    DOCUMENT,
    FIRST,
    FOLD,
    MORE,
    NAME,
    NOTE,
    STROKE,
    all_decides,
    document_fold,
    fold_at,
    folds,
    idle,
    layout_of,
    of_twin,
)
from ..session.places import MIRRORS, REPEATS, described
from ..session.wording import sentences, worded
from .pane import short_of_room
from .text import fit, wrap

LAST = 99  # the rank of what stands behind all that decides
MOST = 12  # fields that an array of tables may have before it is shown one element at a time
ROWS = dotted(ShaftInputs.bearings)
BEARING_NAME = dotted(BearingRow.name)
COLUMNS = {"front": Text("Front bearing"), "rear": Text("Rear bearing")}
RADIUS: Place = (FIRST, dotted(EngineInputs.crank_radius))
_RADII = keys(EngineInputs)[dotted(EngineInputs.crank_radius)].about.usual or (0.0, 0.0)
TWICE = Quantity(  # in no file
    "number",
    Text("Stroke"),
    "mm",
    above=0,
    decides=2,
    usual=(2 * _RADII[0], 2 * _RADII[1]),
    source=THUMB,
    help=Text("Twice the crank radius, which the design file has."),
)


@dataclass(frozen=True)
class FormRow:
    """`kind`: heading (of a sub-table, or of one element), option (heading of a sub-table that may be left out), array
    (heading of an array of tables), leaf (the same where another step asks for them), columns (names of tables side by
    side), cells (one input of each of them), fold (heading of what is folded), original (whose twin a shaft is), stroke
    or field."""

    kind: str
    place: Place
    about: Quantity
    required: bool = False  # must be there because its table is
    shown: int | None = None  # of an array that is shown one element at a time: which
    inside: tuple["FormRow", ...] = ()  # cells: the fields; columns: their headings; fold: what lies in it
    open: bool = False  # a fold


@dataclass(frozen=True)
class Asked:
    """`gather`: all folds stand behind one, until one of them is open.

    `chosen`: which element of a long array is shown.  `held`: fields that stay although their table is not there:
    the one that is being edited and has just been emptied, and those in which something is not accepted.  `side`: how
    many elements fit side by side; `short`: how many inputs, where their unit has two letters at most."""

    chosen: Mapping[Place, int]
    held: Sequence[Place] = ()
    side: int = 1
    short: int = 1
    gather: bool = False


ALL = 99  # the number of the fold that all folds lie behind, and what is taken over
EARLIER = Text("From earlier steps")


def routed(step: Step, data: Table, asked: Asked, opened: Collection[int]) -> list[FormRow]:
    """The rows of a step's form in the order in which they decide; of the folds only what is in the open ones."""
    form_rows = [
        row
        for row in rows(step, data, asked)
        if row.place in asked.held or not all(idle(field.place, data) for field in row.inside or (row,))
    ]
    if step.key == FIRST:
        form_rows.append(FormRow("stroke", (FIRST, STROKE), TWICE, required=True))
    ordered = [_of_design(NAME, required=True)] if step.key == FIRST else []
    ranked = [(_rank(row, step.key, data), row) for row in form_rows]
    of_shaft = len(content_at(data, SHAFTS) or ()) > 1  # stands before what several shafts share
    by_rank = sorted(ranked, key=lambda one: (of_shaft and one[1].place[:1] != SHAFTS, one[0]))
    ordered += [row for rank, row in by_rank if rank]
    folded = [row for rank, row in ranked if not rank]
    for n, title in enumerate(folds(step.key)):
        if inside := tuple([row for row in folded if fold_at(step.key, row.place, data) == n]):
            ordered.append(
                FormRow("fold", (step.key, f"{FOLD}{n}"), Quantity("table", title), inside=inside, open=n in opened)
            )
            ordered += inside if n in opened else []
    ordered += _document(data, asked, opened) if step.key == FIRST else []
    return ordered if opened or not asked.gather else _gathered(step.key, ordered)


def _gathered(step: str, rows: list[FormRow]) -> list[FormRow]:
    """Rows with all their folds, which are shut, behind one."""
    shut = [row for row in rows if row.kind == "fold"]
    if len(shut) < 2:
        return rows
    parts = [*(row.about.label for row in shut), *([Small(EARLIER)] if step != FIRST else [])]
    about = Quantity("table", MORE, help=COMMA.join(parts))
    inside = tuple([inner for row in shut for inner in row.inside])
    return [*(row for row in rows if row.kind != "fold"), FormRow("fold", (step, f"{FOLD}{ALL}"), about, inside=inside)]


def _rank(row: FormRow, step: str, data: Table) -> int:
    """Which of the few that decide a row is, from 1; 0 in a fold.  The heading of several elements stands before what
    decides of each; a twin has nothing but what decides."""
    if row.kind == "original":
        return LAST
    if all_decides(step, row.place, data):
        return 1
    about = row.about if row.kind == "stroke" else layout_of(row.place)
    if about is not None and about.decides:
        return about.decides
    inside = (
        keys_of(row.about.table, data, step) if row.about.table and row.kind in ("array", "leaf", "columns") else ()
    )
    return min((key.about.decides for key in inside if key.about.decides), default=0)


def _of_design(place: Place, *, required: bool = False) -> FormRow:
    """An input of the design itself."""
    return FormRow("field", place, keys(Design)[str(place[0])].about, required=required)


def _document(data: Table, asked: Asked, opened: Collection[int]) -> list[FormRow]:
    """The fold of the document control, which every design may have, with its note."""
    about = keys(Design)[str(DOCUMENT[0])].about
    assert about.table is not None
    inside = (
        _of_design(NOTE),
        *_Rows(FIRST, data, asked).of(about.table, data.get(str(DOCUMENT[0]), {}), DOCUMENT, False),
    )
    is_open = (n := document_fold()) in opened
    return [FormRow("fold", (FIRST, f"{FOLD}{n}"), about, inside=inside, open=is_open), *(inside if is_open else ())]


def rows(step: Step, data: Table, asked: Asked) -> list[FormRow]:
    """All rows of a step's form, in the order of the file; the bearings of a shaft stand with it by their places, all
    else of them with what they share, those of the shaft in view."""
    form = _Rows(step.key, data, asked)
    if step.key == "countershaft":
        return list(form.array(described(SHAFTS), content_at(data, SHAFTS) or [], SHAFTS))
    form_rows = list(form.of(step.inputs, data.get(step.key, {}), (step.key,), True))
    if step.key == dotted(Design.bearings):
        form_rows += form.bearings(content_at(data, SHAFTS) or [])
    return form_rows


class _Rows:
    """The rows of a step's form: of tables that two steps share those that this one asks for."""

    def __init__(self, step: str, data: Table, asked: Asked) -> None:
        self.step, self.data, self.asked = step, data, asked

    def keys(self, cls: type, content: object, place: Place) -> dict[str, Quantity]:
        """What the step asks for of a table; what stands in it all the same, or is wrong, can be seen and taken out."""
        there = as_table(content)
        own = set(own_keys(cls, there, judged=dotted(Design.bearings) in self.data))
        if of_twin(place, self.data):
            own -= {MIRRORS, REPEATS} if cls is ShaftInputs else {*OF_ORIGINAL}  # the one that it is stands in it
        shown = {*own, *there, *(held[-1] for held in self.asked.held if held[:-1] == place)}
        return {key.key: key.about for key in keys_of(cls, self.data, self.step) if key.key in shown}

    def of(self, cls: type, content: object, place: Place, there: bool) -> Iterator[FormRow]:
        """Plain inputs before tables, so that none seems to belong to the table above it."""
        known = self.keys(cls, content, place)
        tables = [about.table for about in known.values() if about.kind == "table" and not about.optional]
        twins = [key for key, about in known.items() if about.kind == "table" and tables.count(about.table) > 1]
        for key in sorted(known, key=lambda key: known[key].kind in ("table", "tables")):
            yield from self._one(known, key, as_table(content), place, there, twins)

    def _one(
        self, known: Mapping[str, Quantity], key: str, data: Table, place: Place, there: bool, twins: list[str]
    ) -> Iterator[FormRow]:
        about, here = known[key], (*place, key)
        if key in twins and self.asked.side >= len(twins):
            if key == twins[0]:
                columns = [FormRow("heading", (*place, twin), known[twin]) for twin in twins]
                yield from self._side_by_side(columns, [data.get(twin) for twin in twins])
        elif about.kind == "table":
            yield from self._table(about, data.get(key), here, there)
        elif about.kind == "tables":
            yield from self.array(about, as_list(data.get(key)), here)
        else:
            yield FormRow("field", here, about, required=there and not about.optional)

    def _side_by_side(self, columns: Sequence[FormRow], contents: Sequence[object]) -> Iterator[FormRow]:
        """One row for each input of tables of one kind."""
        first = columns[0]
        assert first.about.table is not None
        yield FormRow("columns", first.place, first.about, inside=tuple(columns))
        known: dict[str, Quantity] = {}
        for column, content in zip(columns, contents):
            known |= self.keys(first.about.table, content, column.place)
        for key, about in known.items():
            cells = [FormRow("field", (*column.place, key), about, required=not about.optional) for column in columns]
            yield FormRow("cells", cells[0].place, about, inside=tuple(cells))

    def _below_each_other(
        self, about: Quantity, content: list[object], here: Place, known: dict[str, Quantity], unit: str
    ) -> Iterator[FormRow]:
        """One row for each table, with a column for each input."""
        headings = tuple(FormRow("heading", (*here, 0, key), column) for key, column in known.items())
        yield FormRow("columns", here, about, inside=headings)
        for i, item in enumerate(content):
            cells = tuple(
                FormRow("field", (*here, i, key), column, required=not column.optional) for key, column in known.items()
            )
            yield FormRow("cells", cells[0].place, replace(_titled(about, item), unit=unit), inside=cells)

    def _table(self, about: Quantity, content: object, here: Place, there: bool) -> Iterator[FormRow]:
        assert about.table is not None
        yield FormRow("option" if about.optional else "heading", here, about)
        held = any(here == place[: len(here)] for place in self.asked.held)
        if content is not None or not about.optional or held:
            yield from self.of(about.table, content, here, content is not None or (there and not about.optional))

    def bearings(self, shafts: list[object]) -> Iterator[FormRow]:
        """Those of the shaft in view, below which one it is where there are several."""
        if not shafts:
            return
        shaft = (*SHAFTS, n := min(self.asked.chosen.get(SHAFTS, 0), len(shafts) - 1))
        if len(shafts) > 1:
            yield FormRow("leaf", SHAFTS, described(SHAFTS), shown=n)
        here = (*shaft, ROWS)
        bearings = as_list(content_at(with_bearings(self.data, here), here))
        if bearings and of_twin(shaft, self.data):
            about = described(here)
            assert about.table is not None
            at = min(self.asked.chosen.get(here, 0), len(bearings) - 1)
            yield FormRow("leaf", here, about, shown=at)
            yield from self.of(about.table, bearings[at], (*here, at), True)
            yield FormRow("original", shaft, described(SHAFTS))
        elif bearings:
            yield from self.array(described(here), bearings, here)

    def array(self, about: Quantity, content: list[object], here: Place) -> Iterator[FormRow]:
        """Elements side by side, below each other, or where that were too many rows one at a time."""
        assert about.table is not None
        known = self.keys(about.table, content[0] if content else {}, (*here, 0))
        flat = all(key.kind not in ("table", "tables") for key in known.values())
        if flat and 1 < len(content) <= self.asked.side:
            columns = [FormRow("heading", (*here, i), _titled(about, item)) for i, item in enumerate(content)]
            names, *cells = self._side_by_side(columns, content)
            yield FormRow("array", here, about) if BEARING_NAME in known or about.table is not BearingRow else names
            yield from cells
            return
        first = {key: column for key, column in known.items() if column.decides}
        unit = "".join({column.unit for column in first.values()})  # a row has room for one
        if len(content) < 2 or not flat or not 1 < len(first) <= self.asked.short or len(unit) > 2:
            first = {}
        long = len(content) > 1 and len(content) * (len(known) - len(first)) > MOST
        shown = min(self.asked.chosen.get(here, 0), len(content) - 1) if long else None
        yield FormRow("array", here, about, shown=shown)
        if first:
            yield from self._below_each_other(about, content, here, first, unit)
        for i, item in enumerate(content):
            if shown is None or i == shown:
                if not long and here != SHAFTS:
                    yield FormRow("heading", (*here, i), about)
                inner = self.of(about.table, item, (*here, i), True)
                yield from (row for row in inner if row.place[-1] not in first)
                if here == SHAFTS and of_twin((*here, i), self.data):
                    yield FormRow("original", (*here, i), about)


def _titled(about: Quantity, element: object) -> Quantity:
    """What stands above a column, or before a row, of inputs of one element: of a bearing, whose name is an input of
    another step, that it is one."""
    name = str(as_table(element).get(BEARING_NAME, ""))
    if about.table is not BearingRow:
        return replace(about, label=Text("{name}", name=Name(name)))
    return replace(about, label=COLUMNS.get(name) or Text("{name} bearing", name=titled(name)))


# --- at the foot of the form
# What the field that has the focus means, and what is usual there.


def meaning(about: Quantity, say: Language, *, sourced: bool = True, brief: bool = False) -> str:
    """What a quantity means and what is usual, which stands behind the first sentence; `brief`: no more than that.

    `sourced`: with the source in brackets, behind the usual range or else the meaning; that there is none F1 says."""
    sourced = sourced and not brief and about.source is not THUMB
    source = f" ({say(about.source)})" if sourced and about.source else ""
    words, usual = say(about.help), ""
    if about.usual:
        low, high = about.usual
        usual = f"{say(Text('Usual {low} to {high}', low=Amount(low), high=Amount(high, about.unit)))}{source}."
    elif words and source:
        words = f"{words.removesuffix('.')}{source}."
    first, *others = sentences(words) or [""]
    return " ".join(part for part in (first, usual, *([] if brief else others)) if part)


def allowed(about: Quantity, say: Language) -> str:
    """What a number may be, as a sentence."""
    words = "" if about.kind in ("text", "choice") else say(about.allowed())
    return f"{words[:1].upper()}{words[1:]}." if words else ""


def heading_help(about: Quantity, keys: Text, reason: Text, app: BaseApp) -> tuple[str, str]:
    """Of a part that may be left out or repeated: why it is not accepted, what it is, and its keys."""
    text = f"{about.help} {app.say(keys)}".strip()
    return about.label, f"{app.signs.mark('invalid')} {app.say(reason)}. {text}" if reason else text


BRACKETS = re.compile(r" \([^()]*\)")


def foot(parts: Sequence[str], more: str, width: int, height: int) -> list[str]:
    """As many whole sentences as go into so many rows, sooner without their brackets than not at all; `more` where the
    last row has room for it."""
    words = ""
    for part in parts:
        for shorter in (part, BRACKETS.sub("", part)):
            longer = f"{words} {shorter}".strip()
            if not words or len(wrap(longer, width)) <= height:
                words = longer
                break
    rows = wrap(words, width)
    if len(rows) > height:  # the first alone is too long
        rows = rows[:height]
        rows[-1] = fit(rows[-1] + " …", width - len(more))
    if len(rows[-1]) + len(more) <= width:
        rows[-1] += more
    return rows


class FieldHelp(Widget):
    app: BaseApp

    def __init__(self) -> None:
        super().__init__(id="field-help")
        self.title = ""
        self.text = ""
        self.rest = ""
        self.moves = ""

    def show(self, title: str, text: str, rest: str = "", moves: str = "") -> None:
        """What a field means and what is usual, then what it `moves`, then what else there is to say, and the `rest`:
        as far as there is room.  Where it is short, the title only if nothing else is said: the cursor stands
        there."""
        self.title, self.text, self.rest, self.moves = title, text, rest, moves
        self.refresh()

    def render(self) -> Content:
        if not self.title and not self.text:
            return Content("")
        short = short_of_room(self)
        told = sentences(worded(self.text, self.app.say))
        if self.title and not (short and told):
            told = [f"{self.title}: {told[0]}" if told else self.title, *told[1:]]
        moves = self.moves.partition(";")[0].rstrip(".") + "." if self.moves and short else self.moves
        parts = [part for part in (*told[:2], moves, *told[2:], "" if short else self.rest) if part]
        more = self.app.say(Text("{key} more", key=self.app.shown_key("help")))
        rows = foot(
            parts, f"  {more}" if self.title and not short else "", max(10, self.size.width - 2), self.size.height
        )
        return Content.styled("\n".join(" " + row for row in rows), "dim")
