# SPDX-License-Identifier: Apache-2.0
"""The inputs of one step, generated from their descriptions."""

from collections.abc import Callable, Collection
from dataclasses import dataclass, replace
from functools import partial

from textual import events
from textual.containers import VerticalScroll
from textual.content import Content
from textual.message import Message
from textual.widget import Widget
from textual.widgets import Input, Static
from textual.worker import Worker

from calc.languages import Language
from calc.languages.outcome import in_language
from calc.sheet.step import Step
from calc.sheet.text import EMPTY, Text

from ..base_app import BaseApp
from ..places import Place, content_at, key_at
from ..route import fold_of, path_of
from ..session import Session
from ..upstream import NAMED
from .array_heading import ArrayHeading
from .cells import Cells, Columns, side
from .choice import Choice
from .entry import Entry
from .field import Field, StrokeField
from .fold import Fold
from .guide_text import GuideText
from .item_list import ItemList
from .radio import Balance, Radio, Todo
from .rows import Asked, Row, routed
from .table_heading import TableHeading
from .upstream_values import Taken

Identity = tuple[object, ...]  # of a widget: kind and place of its row
LEFT_OUT = Text("left out on purpose")
WIDE = 46  # cells of the form beside the other panes


class Form(VerticalScroll, can_focus=True, inherit_bindings=False):
    """Fields in the order of the design file.  Focus on the form itself means that no field is being edited."""

    app: BaseApp

    @dataclass
    class Asked(Message):
        """A step that the design does not have is to be built, or (`balancing`) crank and shaft of a balancing."""

        step: str
        balancing: str = ""

    class Done(Message):
        """Nothing is left to do in this form: on to the next step."""

    class Changed(Message):
        """The design was changed in more than the text of a field."""

    def __init__(self, step: Step, session: Session) -> None:
        super().__init__(id=f"form-{step.key}", classes="form")
        self.step = step
        self.session = session
        self.chosen: dict[Place, int] = {}
        self.opened: set[int] = set()  # the folds that are open
        self.last: Place | None = None  # the field that was edited last
        self._stale = False  # the form has to be put in order
        self._remaking = False
        self._wanted: Place | None = None  # where the focus goes when the form stands again
        self._back = False  # the focus was on a part that goes
        self._ahead: list[events.Key] = []  # struck while the form is put in order
        self._identities: dict[Widget, Identity] = {}
        self._side = side(min(WIDE, self.app.size.width - 1))

    # --- content
    def compose(self):  # type: ignore[no-untyped-def]
        for identity, make in self._parts():
            yield self._made(identity, make)

    def _made(self, identity: Identity, make: Callable[[], Widget]) -> Widget:
        widget = make()
        self._identities[widget] = identity
        return widget

    def _parts(self) -> list[tuple[Identity, Callable[[], Widget]]]:
        """What the form consists of, in order: what tells each part from all others, and how it is made."""
        key, session = self.step.key, self.session
        parts: list[tuple[Identity, Callable[[], Widget]]] = [(("guide",), lambda: GuideText(session, key))]
        if key == "imbalance" and "engine" in session.data:
            parts.append((("balance",), lambda: Balance(session, key)))
        elif not self.there:
            parts.append((("todo",), lambda: Todo(session, key)))
        if self.there:
            for row in self._rows():
                parts.append((_identity(row), partial(self._widget, row)))
            parts.append((("taken",), lambda: Taken(session, key)))
        return parts

    def _widget(self, row: Row) -> Widget:
        session = self.session
        match row.kind:
            case "field":
                return Field(row, session, self._words(row))
            case "stroke":
                return StrokeField(row, session, ())
            case "cells":
                return Cells(row, [Field(cell, session, self._words(cell), cell=True) for cell in row.inside])
            case "columns":
                return Columns(row)
            case "array":
                return ArrayHeading(row, session)
            case "option":
                return TableHeading(row, session)
            case "fold":
                return Fold(row, session)
            case _:
                return Static(self._heading(row), classes="heading")

    @property
    def there(self) -> bool:
        """Whether the design has the step."""
        return self.step.key in self.session.data

    def _rows(self) -> list[Row]:
        reasons = self.session.reasons()
        editing = [self.field.place] if self.is_mounted and self.field is not None else []
        if not (editing and self.field is not None and self.field.editing):
            self.opened |= {n for place in reasons if (n := self._fold(place)) is not None}
        found = routed(self.step, self.session.data, Asked(self.chosen, [*editing, *reasons], self._side), self.opened)
        say = self.app.say
        return found if say.code == "en" else [_said(row, say) for row in found]

    def _fold(self, place: Place) -> int | None:
        """The fold that a place lies in."""
        return fold_of(self.step.key, path_of(place)) if len(place) > 1 and place[0] == self.step.key else None

    def _heading(self, row: Row) -> Content:
        last = row.place[-1]
        name = str((content_at(self.session.data, row.place) or {}).get("name", last + 1)) if isinstance(last, int) else row.about.label
        return Content.styled(f" {name}", "bold" if not isinstance(last, int) else "italic")

    def _words(self, row: Row) -> tuple[str, ...]:
        """The names that a field of a catalogue may hold."""
        catalogue = NAMED.get(key_at(row.place)) if row.about.kind == "text" else None
        return tuple(getattr(self.session.design, catalogue)) if catalogue else ()

    def refresh_fields(self, reasons: dict[Place, Text]) -> None:
        """Show what the session says; a design of another shape gets a form of another shape."""
        found = {_identity(row): row for row in self._rows()} if self.there else {}
        for todo in self.query(Todo):
            todo.rebuild()
        if [self._identities.get(child) for child in self.children] != [identity for identity, _ in self._parts()]:
            self.rebuild()
        for child in self.children:
            row = found.get(self._identities.get(child, ()))
            if row is None:
                continue
            if isinstance(child, Field):
                child.row = row
                child.show(reasons.get(child.place, EMPTY))
            elif isinstance(child, Cells):
                child.redraw(row, reasons)
            elif isinstance(child, (ArrayHeading, TableHeading)):
                child.redraw(row, reasons.get(row.place, EMPTY))
            elif isinstance(child, (Fold, Columns)):
                child.redraw(row)
            elif isinstance(child, Static) and str(child.content) != (made := self._heading(row)).plain:
                child.update(made, layout=False)

    def _settle(self) -> None:
        """When the focus has left a field: fields of a table that lost its last key go, and folds with mistakes open."""
        if self.display and self.is_attached:
            self.refresh_fields(self.session.reasons())

    def refresh_taken(self) -> None:
        for guide in self.query(GuideText):
            guide.redraw()
        for balance in self.query(Balance):
            balance.refresh_options()
            balance.rebuild()
        for taken in self.query(Taken):
            taken.rebuild()

    def on_resize(self, event: events.Resize) -> None:
        if (side_ := side(event.size.width)) != self._side:
            self._side = side_
            self.rebuild()

    def rebuild(self, focus: Place | None = None) -> None:
        """Put the form in order: what goes is taken away, what is new is put in, and all else stays as it is, the focus too."""
        if focus is not None:
            self._wanted, self._back = focus, True
            self.screen.set_focus(self, scroll_visible=False)  # keys wait here
        self._stale = True
        if not self._remaking:
            self._remaking = True
            _: Worker[None] = self.run_worker(self._remake, group=f"form-{self.step.key}")

    async def _remake(self) -> None:
        """One at a time and never cancelled: a removal that is cut off leaves widgets that answer no more."""
        try:
            while self._stale:
                self._stale = False
                with self.app.batch_update():
                    await self._put_in_order()
        finally:
            self._remaking = False
        self.refresh_fields(self.session.reasons())
        if self._stale:
            return  # once more, and then the focus
        if self._back:
            self._back = False
            wanted, self._wanted = self._wanted, None
            self.focus_place(wanted, at_once=True)
            self.call_after_refresh(self.bring_into_view)
        ahead, self._ahead = self._ahead, []
        for event in ahead:
            await self.app.on_event(events.Key(event.key, event.character))

    async def _put_in_order(self) -> None:
        parts = self._parts()
        wanted = {identity for identity, _ in parts}
        gone = [child for child in self.children if self._identities.get(child) not in wanted]
        focused = self.screen.focused
        if focused is not None and any(child in focused.ancestors_with_self for child in gone):
            self._wanted, self._back = self._wanted or self.here(), True
            self.screen.set_focus(self, scroll_visible=False)
        if gone:
            await self.remove_children(gone)
        for child in gone:
            self._identities.pop(child, None)
        standing = {self._identities[child]: child for child in self.children}
        new: list[Widget] = []
        for identity, make in parts:
            if (there := standing.get(identity)) is None:
                new.append(self._made(identity, make))
            elif new:
                await self.mount(*new, before=there)
                new = []
        if new:
            await self.mount(*new)

    def on_key(self, event: events.Key) -> None:
        """Keys that are struck while the form is put in order wait for the field that they are meant for."""
        if self._remaking and self.screen.focused is self:
            event.stop()
            event.prevent_default()
            self._ahead.append(event)

    def bring_into_view(self) -> None:
        """What has the focus in a form that was just made: it had no place yet when it got the focus."""
        focused = self.screen.focused
        if focused is not None and focused in self.walk_children():
            (self.field or focused).scroll_visible(animate=False)

    # --- focus
    def stops(self) -> list[Widget]:
        """Everything in the form that takes the focus, in order."""
        found: list[Widget] = []
        for child in self.children:
            if isinstance(child, Field):
                found.append(child.box)
            elif isinstance(child, Cells):
                found += [field.box for field in child.fields]
            elif isinstance(child, (ArrayHeading, TableHeading, Fold, Radio)) or (isinstance(child, Taken) and child.items):
                found.append(child)
        return found

    def here(self) -> Place | None:
        """The place that has the focus."""
        focused = self.screen.focused
        if isinstance(focused, (ArrayHeading, TableHeading, Fold)):
            return focused.row.place
        field = self.field
        return field.place if field is not None else None

    @property
    def field(self) -> Field | None:
        """The field that has the focus."""
        focused = self.screen.focused
        return focused.parent if isinstance(focused, (Entry, Choice)) and isinstance(focused.parent, Field) else None

    def focus_place(self, place: Place | None, *, at_once: bool = False) -> None:
        """Focus the field at a place; without one, or where it is gone, the one edited last, or the first."""
        if self._remaking:
            self.rebuild(place or self._wanted or self.last or ())
            return
        stops: dict[Place, Widget] = {}
        for stop in self.stops():
            owner = stop.parent if isinstance(stop.parent, Field) else stop
            stops[owner.row.place if isinstance(owner, (Field, ArrayHeading, TableHeading, Fold)) else ()] = stop
        wanted = stops.get(place) if place else stops.get(self.last) if self.last else None
        if wanted is None and place and self._bring_out(place, stops):
            self.rebuild(place)
            return
        around = [place[:end] for end in range(len(place) - 1, 1, -1) if place[:end] in stops] if place else []
        target = wanted or (stops[around[0]] if around else next(iter(self.stops()), self))
        if at_once:
            self.screen.set_focus(target)
        else:
            target.focus()

    def _bring_out(self, place: Place, stops: Collection[Place]) -> bool:
        """Open the fold, or leaf to the element, that a place lies in; whether there was something to do."""
        n, uncovered = self._fold(place), False
        if self.there and n is not None and n not in self.opened:
            self.opened.add(n)
            uncovered = True
        for end, part in enumerate(place):
            if isinstance(part, int) and self.chosen.get(place[:end], 0) != part and (uncovered or place[:end] in stops):
                self.chosen[place[:end]] = part
                uncovered = True
        return uncovered

    def go(self, by: int) -> None:
        """To the next field, or the one before."""
        stops = self.stops()
        focused = self.screen.focused
        if focused in stops:
            i = stops.index(focused) + by
            if 0 <= i < len(stops):
                self.screen.set_focus(stops[i])  # now, and not after the keys that are waiting
        else:
            self.focus_place(None)

    def go_on(self) -> None:
        """To the next field below, past headings and folds; from the last one to the next step."""
        stops = self.stops()
        here = stops.index(self.screen.focused) if self.screen.focused in stops else -1
        below = (stop for stop in stops[here + 1 :] if isinstance(stop, (Entry, Choice)))
        if (stop := next(below, None)) is not None:
            self.screen.set_focus(stop)
        else:
            self.post_message(self.Done())

    def on_descendant_focus(self, event: events.DescendantFocus) -> None:
        if (field := self.field) is not None:
            self.last = field.place
            field.arrive()
            self._redraw_around(field)

    def on_descendant_blur(self, event: events.DescendantBlur) -> None:
        owner = event.widget.parent
        if isinstance(owner, Field):
            self.session.seal()
            owner.rewrite()
            owner.redraw()
            self._redraw_around(owner)
            self.call_after_refresh(self._settle)

    def _redraw_around(self, field: Field) -> None:
        if isinstance(field.parent, Cells):
            field.parent.refresh()

    def restore(self) -> bool:
        """Take back what was typed into the field that is being edited; whether there was any."""
        if (field := self.field) is None or not field.editing:
            return False
        field.restore()
        return True

    def on_input_submitted(self, event: Input.Submitted) -> None:
        """Enter accepts and goes on."""
        event.stop()
        if isinstance(owner := event.input.parent, Field):
            self.session.seal()
            owner.rewrite()
        self.go(1)

    def on_entry_pasted(self, event: Entry.Pasted) -> None:
        """Several values: a list takes them all, else they go into this field and those after it."""
        event.stop()
        if not isinstance(owner := event.entry.parent, Field):
            return
        fields = [stop.parent for stop in self.stops() if isinstance(stop.parent, Field)]
        fields = fields[fields.index(owner) :]
        values = event.values
        if owner.about.kind in ("series", "integers"):
            values = ["; ".join(values)]
        self.session.seal()
        for field, text in zip(fields, values):
            field.box.show(text)
            self.session.edit(field.place, field.meant(text))
            self.session.seal()
        self.post_message(self.Changed())
        if left := values[len(fields) :]:
            self.app.tell(Text("There is no field left for {values}.", values="; ".join(left)), "warning")
        self.screen.set_focus(fields[min(len(values), len(fields)) - 1].box)

    def on_entry_locked(self, event: Entry.Locked | Choice.Locked) -> None:
        """Lock the input against remedies and searches, or unlock it."""
        event.stop()
        if (field := self.field) is not None:
            self.session.toggle_lock(field.place)
            field.redraw()
            self.post_message(self.Changed())

    on_choice_locked = on_entry_locked

    def on_fold_turned(self, event: Fold.Turned) -> None:
        event.stop()
        n = int(str(event.fold.row.place[-1]))
        self.opened = self.opened | {n} if event.open else self.opened - {n}
        self.refresh_fields(self.session.reasons())

    def on_item_list_chosen(self, event: ItemList.Chosen) -> None:
        """What a step offers first is taken."""
        if not isinstance(event.source, Radio):
            return
        event.stop()
        source = event.source
        if isinstance(source, Balance) and event.key != source.made():
            self.post_message(self.Asked("countershaft", event.key))
        elif isinstance(source, Balance):
            self.post_message(self.Done())
        elif event.key == Todo.LEAVE:
            self.session.leave_out(self.step.key, self.app.say(LEFT_OUT))
            self.post_message(self.Changed())
            self.post_message(self.Done())
        else:
            self.ask()

    # --- arrays
    def on_array_heading_leafed(self, event: ArrayHeading.Leafed) -> None:
        event.stop()
        self.chosen[event.heading.row.place] = event.index
        self.rebuild(event.heading.row.place)

    def ask(self) -> None:
        """Enter on the form of a step that the design does not have."""
        if not self.there:
            self.post_message(self.Asked(self.step.key))


def _identity(row: Row) -> Identity:
    return (row.kind, row.place, len(row.inside)) if row.kind == "cells" else (row.kind, row.place)


def _said(row: Row, say: Language) -> Row:
    """A row with its words in the user's language."""
    return replace(row, about=in_language(row.about, say), inside=tuple(_said(one, say) for one in row.inside))
