# SPDX-License-Identifier: Apache-2.0
"""What would help against a finding: remedies of different kinds, found one after the other."""

import csv
import io
import math
from collections.abc import Iterator
from pathlib import Path
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.widgets import Static

from calc.design.model import STEPS, TITLES
from calc.design.names import named
from calc.locale import Language
from calc.sheet.check import Check
from calc.sheet.errors import BadInput
from calc.sheet.progress import Progress
from calc.sheet.text import COMMA, EMPTY, Amount, Text
from calc.studies.repair.nearest import NearestRemedy
from calc.studies.repair.option import ALL_CORNERS, AS_GIVEN, LOCKED, NEAR, RepairOption, ranked
from calc.studies.repair.options import search

from ..actions import bound
from ..session.saving import SaveError, free_name, write_atomic
from ..session.session import Session
from ..widgets.item_list import Item, ItemList
from ..widgets.text import pad, wrap
from .selection import Searching

# --- the list of remedies
# Number, kind, change, how far it comes, and what it does to the rest.

# of the verdicts; one that breaks something else is a fail
SIGN = {ALL_CORNERS: "pass", AS_GIVEN: "pass", NEAR: "warn"}
ROOMY = 96  # cells from which the change, the result and the rest stand beside each other
GAP = 2


class RemedyList(ItemList):
    """The key of an item is the number of its row."""

    def __init__(self) -> None:
        super().__init__(id="way-list")
        self.ways: tuple[RepairOption, ...] = ()

    def show(self, ways: tuple[RepairOption, ...]) -> None:
        """The cursor stays on its remedy, which may have another number now; on the first row until it was moved from
        there."""
        here, before = self.key if self.key != "1" else "", self.ways
        self.ways = ways
        self.rebuild()
        if (
            here
            and (now := next((n for n, way in enumerate(ways, 1) if way == before[int(here) - 1]), None)) is not None
        ):
            self.go_to(str(now))
        elif ways:
            self.go_to("1")

    def build(self, width: int) -> list[Item]:
        return [
            Item(str(n), self._columns(n, way, width), self.app.say(way.words), self._line(way))
            for n, way in enumerate(self.ways, 1)
        ]

    def _line(self, way: RepairOption) -> str:
        return self.app.say(
            Text("{kind}: {change}; {result}", kind=way.kind, change=way.words, result=self.result(way))
        )

    def result(self, way: RepairOption) -> Text:
        unlocks = self.app.shown_key("lock")
        return Text("locked: {reason} ({key} unlocks)", reason=way.locked, key=unlocks) if way.locked else way.result

    def _columns(self, number: int, way: RepairOption, width: int) -> list[Content]:
        say, signs = self.app.say, self.app.signs
        arrow = signs.mark("then")
        kind, change, rest = say(way.kind), say(way.words).replace("→", arrow), say(way.rest)
        state = "blocked" if way.quality == LOCKED else SIGN.get(way.quality, "fail")
        if state == "pass" and way.side.opens:
            state = "warn"
        result, style = f"{signs.mark(state)} {say(self.result(way))}", signs.style(state)
        kinds = max(len(say(other.kind)) for other in self.ways)
        start = f" {number} "
        if width >= ROOMY:
            left = width - len(start) - kinds - 3 * GAP
            sizes = (left * 2 // 5, left // 3, left - left * 2 // 5 - left // 3)
            columns = [wrap(kind, kinds), wrap(change, sizes[0]), wrap(result, sizes[1], 2), wrap(rest, sizes[2])]
            rows = []
            for i in range(max(map(len, columns))):
                cells = [column[i] if i < len(column) else "" for column in columns]
                rows.append(
                    Content.assemble(
                        start if i == 0 else " " * len(start),
                        (pad(cells[0], kinds), "bold"),
                        " " * GAP,
                        pad(cells[1], sizes[0]),
                        " " * GAP,
                        (pad(cells[2], sizes[1]), style),
                        " " * GAP,
                        (cells[3], "dim"),
                    )
                )
            return rows
        lead = " " * len(start)
        first = wrap(result, width - len(start) - kinds - GAP, 2)
        rows = [Content.assemble(start, (pad(kind, kinds), "bold"), " " * GAP, (first[0], style))]
        rows += [Content.assemble(lead, " " * (kinds + GAP), (row, style)) for row in first[1:]]
        rows += [Content(lead + row) for row in wrap(change, width - len(lead), 2)]
        return rows + [Content.styled(lead + row, "dim") for row in (wrap(rest, width - len(lead), 2) if rest else [])]


# --- the dialog

NARROW = 100  # cells below which the list has the whole screen
HINT = Text("{compare} compares now → row · {lock} locks its input · {export} writes a table · Esc goes back")


def table(ways: tuple[RepairOption, ...], say: Language) -> str:
    """Remedies as comma-separated values: numbers and keys as the design file has them, words in the user's
    language."""
    file = io.StringIO()
    rows = csv.writer(file, lineterminator="\n")
    rows.writerow(
        [
            "kind",
            "change",
            "result",
            "passes",
            "locked",
            "set",
            "loss before W",
            "loss W",
            "mass before kg",
            "mass kg",
            "cold clearance um",
            *(step.key for step in STEPS),
        ]
    )
    for way in ways:
        numbers = [*(way.power or ("", "")), *(way.mass or ("", "")), "" if way.cold is None else way.cold[1]]
        verdicts = {key: now for key, _, now in way.verdicts}
        rows.writerow(
            [
                say(way.kind),
                say(way.words),
                say(way.result),
                way.passes,
                way.locked,
                " ".join(way.changes),
                *numbers,
                *(verdicts.get(step.key, "") for step in STEPS),
            ]
        )
    return file.getvalue()


class Remedies(Searching[RepairOption | None, RepairOption]):
    """Gives the remedy that was taken."""

    STATE, BAR = "remedies-state", 24
    BINDINGS: ClassVar[list[BindingType]] = [
        bound("go_on", "take"),
        bound("lock", "lock"),
        bound("compare", "compare"),
        bound("export", "write"),
        bound("copy", "copy"),
        bound("copy_line", "copy"),
    ]

    def __init__(self, session: Session, finding: Check | str, nearest: NearestRemedy | None = None) -> None:
        """`finding`: a check, or the key of a step without a solution; `nearest`: the remedy of its step, where it is
        known."""
        super().__init__()
        self.session, self.finding, self.nearest = session, finding, nearest
        self.found: list[RepairOption] = []

    def compose(self) -> ComposeResult:
        with Vertical(classes="dialog -whole" if self.app.size.width < NARROW else "dialog", id="remedies"):
            yield Static(id="remedies-title")
            yield RemedyList()
            yield Static(id="remedies-state")
            yield Static(id="remedies-preview")
            yield Static(id="remedies-hint")

    def on_mount(self) -> None:
        self.query_one("#remedies-title", Static).update(self._title())
        self.query_one(RemedyList).focus()
        self.begin()

    @property
    def room(self) -> int:
        return max(30, self.query_one(RemedyList).size.width or self.app.size.width * 9 // 10 - 6)

    def _title(self) -> Content:
        say, signs = self.app.say, self.app.signs
        check = self.finding
        if isinstance(check, str):
            return Content.styled(
                f"{signs.mark('no_solution')} {say(Text('{step}: no solution', step=TITLES[check]))}", "bold"
            )
        known = Amount(check.value, check.unit) if math.isfinite(check.value) else Text("not known")
        text = Text("{check}: {value}, needs {limit}", check=check.name, value=known, limit=check.limit_text())
        rows = wrap(f"{signs.mark(check.verdict)} {say(text)}", self.room, 2)
        return Content("\n").join([Content.styled(row, f"bold {signs.style(check.verdict)}") for row in rows])

    # --- searching
    def begin(self) -> None:
        self.found = []
        self.show_ways()
        super().begin()

    def search(self, progress: Progress) -> Iterator[RepairOption]:
        yield from search(self.session.document, self.finding, self.session.results, progress, nearest=self.nearest)

    def show_found(self, result: RepairOption) -> None:
        self.found.append(result)
        self.show_ways()

    def show_end(self, failure: Text) -> None:
        none = Text("No change of a single input is known that helps; look at what the finding says.")
        self.show_state(self.app.say(failure or (EMPTY if self.found else none)))

    @property
    def ways(self) -> tuple[RepairOption, ...]:
        return ranked(self.found)

    def show_ways(self) -> None:
        self.query_one(RemedyList).show(self.ways)
        self._preview()

    # --- the row under the cursor
    @property
    def way(self) -> RepairOption | None:
        key = self.query_one(RemedyList).key
        return self.ways[int(key) - 1] if key and int(key) <= len(self.ways) else None

    def on_item_list_moved(self, event: ItemList.Moved) -> None:
        event.stop()
        self._preview()

    def on_item_list_chosen(self, event: ItemList.Chosen) -> None:
        event.stop()
        if event.clicked:
            self.action_take()

    def _preview(self) -> None:
        """What it does to every step."""
        say, way = self.app.say, self.way
        lines = self.verdict_rows(way.verdicts if way is not None else (), self.app.signs.mark("then"))
        if way is not None and way.left:
            still = Text("still open: {checks}", checks=COMMA.join(way.left))
            lines += [Content.styled(row, "dim") for row in wrap(say(still), self.room, 2)[:2]]
        if way is not None and way.side.words and (way.side.opens or len(way.breaks) > 2):
            lines += [Content.styled(row, "dim") for row in wrap(say(way.side.words), self.room, 2)[:2]]
        self.query_one("#remedies-preview", Static).update(Content("\n").join(lines))
        self.query_one("#remedies-hint", Static).update(Content.styled(say(self._hint()), "dim"))

    def _hint(self) -> Text:
        """What Enter does with the row, and the other keys."""
        shown = {id: self.app.shown_letter(id) for id in ("compare", "lock", "export")}
        keys, way = Text(HINT.template, **shown), self.way
        if way is None:
            return Text("Esc goes back")
        if way.locked:
            return keys
        return (
            Text("Enter applies it · {keys}", keys=keys)
            if way.changes
            else Text("Enter goes there · {keys}", keys=keys)
        )

    # --- what the keys do
    def action_take(self) -> None:
        """The row under the cursor."""
        way = self.way
        if way is None:
            return
        if way.locked:
            self.app.tell(
                Text(
                    "{kind} is locked: {reason}. {key} unlocks it.",
                    kind=way.kind,
                    reason=way.locked,
                    key=self.app.shown_key("lock"),
                ),
                "warning",
            )
        elif way.quality == LOCKED:
            self.app.tell(Text("{kind}: {result}.", kind=way.kind, result=way.result), "warning")
        else:
            self.dismiss(way)

    def action_compare(self) -> None:
        """The design as it is, and that of the row under the cursor."""
        if (way := self.way) is not None and way.changes:
            self.compare(way.kind, way.changes, lambda: self.dismiss(way))

    def action_lock(self) -> None:
        """Lock the input that the row changes, of several the first, or unlock it, and search anew."""
        way = self.way
        if way is None:
            return
        key = way.keys[0]
        try:
            self.session.toggle_lock(key)
        except BadInput:  # of a table that is to be given
            self.app.tell(Text("There is no input to lock here."))
            return
        self.nearest = None  # which is that of other locks
        locked = bool(self.session.lock_reason(key))
        what = named(self.session.document, key)
        self.app.tell(
            Text("{input}: locked", input=what) if locked else Text("{input}: may be changed again", input=what)
        )
        self.begin()

    def action_copy(self) -> None:
        if (item := self.query_one(RemedyList).item) is not None:
            self.app.copy_to_clipboard(item.line)
            self.app.tell(Text("Copied: {text}", text=item.line))

    def action_write(self) -> None:
        """All rows as a table beside the design."""
        home = self.session.path or Path.cwd() / self.session.name
        path = free_name(home.with_name(f"{home.stem}-remedies.csv"))
        try:
            write_atomic(path, table(self.ways, self.app.say).encode("utf-8"), new=True)
        except SaveError as error:
            self.app.tell(error.text, "error")
            return
        self.app.tell(Text("Written: {path}", path=str(path)))
