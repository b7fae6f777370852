# SPDX-License-Identifier: Apache-2.0
"""The form of a step, generated from the descriptions of its inputs: question, values taken over, fields.

In order: the guide at its head, the values of earlier steps, what the form consists of, the form."""

import asyncio
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

from calc.design.addresses import asks, quantity_of, step_at, value_at
from calc.design.labels import SHAFTS, Place, content_at
from calc.design.model import STEPS
from calc.locale import Language
from calc.locale.language import in_language
from calc.sheet.errors import BadInput
from calc.sheet.number import short
from calc.sheet.step import OF_SHAFTS, Step
from calc.sheet.text import COMMA, EMPTY, Name, Text, plural

from ..base_app import BaseApp
from ..session import numbers
from ..session.guide import FIRST, FOLD, GUIDES, fold_at, taken_over
from ..session.places import OF_SHAFT
from ..session.session import Session
from .entry import Choice, Entry
from .field import LABEL, LABEL_NARROW, NARROW, CellColumns, Cells, Field, StrokeField, sides
from .headings import ArrayHeading, Fold, ShaftsHeading, TableHeading
from .item_list import Item, ItemList
from .pane import short_of_room
from .radio import Balance, Radio, Todo
from .rows import ALL, EARLIER, RADIUS, Asked, FormRow, routed
from .text import fit, wrap

# --- at the head of a form
# The question of the step; until it is built, or where the user wants it, what a good answer looks like or, where a
# check fails, what to try.


class GuideText(Static):
    app: BaseApp

    def __init__(self, session: Session, step: str) -> None:
        super().__init__(classes="guide")
        self.session, self.step = session, step
        self._shown: tuple[Text, Text, bool] | None = None

    def on_mount(self) -> None:
        self.redraw()

    def _still(self) -> Text:
        """How much is still of the engine that the design began with."""
        engine, places = self.session.inherited
        if self.step != FIRST or not places:
            return EMPTY
        return plural("{n} value is still {engine}'s", "{n} values are still {engine}'s", n=len(places), engine=engine)

    def redraw(self) -> None:
        say = self.app.say
        guide, results = GUIDES[self.step], self.session.results
        fails = results is not None and results.outcomes[self.step].verdict in ("fail", "no_solution")
        word, text = (Text("Try"), guide.trying) if fails else (Text("Good"), guide.good)
        still, guiding = self._still(), self.app.guiding or not asks(self.session.data, self.step)
        if self._shown != (word, still, guiding):
            self._shown = word, still, guiding
            question = Content.assemble((say(guide.question), "bold"), (f"\n{say(still)}" if still else "", "dim"))
            self.update(Content.assemble(question, f"\n{say(word)}: {say(text)}") if guiding else question)


# --- what a step takes over from the steps before it
# Plain text, not fields.  Typing on one goes to the step that owns it.

NUMBERS = {step.key: n for n, step in enumerate(STEPS, 1)}


class Taken(ItemList):
    """The key of an item is the id of the value, or of the input, that is taken over."""

    def __init__(self, session: Session, step: str) -> None:
        super().__init__(id=f"taken-{step}")
        self.session = session
        self.step = step

    def explained(self) -> tuple[str, str]:
        """What the foot of the form says about it."""
        say = self.app.say
        return say(EARLIER), say(Text("Enter, or typing a number, goes to the step that owns the value."))

    def build(self, width: int) -> list[Item]:
        items = []
        values, say = self.session.values(), self.app.say
        label_width = LABEL_NARROW if width >= NARROW else LABEL  # as in the fields above
        one, original = self.step in OF_SHAFT, self.session.original  # of a step of all shafts each says whose it is
        others = {name for name in self.session.shafts if one and name != original}
        leafs = len(self.session.shafts) > 1 and self.step in OF_SHAFTS
        for id in taken_over(self.step, self.session.data, values):
            if others.intersection(id.split(".")[1:2]):
                continue
            owner = step_at(self.session.data, id)
            if (known := values.get(id)) is not None:
                _, *part, _ = id.split(".")  # front or rear
                part = part[1:] if leafs and part[:1] == [original] else part
                label = say(COMMA.join((known.label, *part)))
                text, unit = say.number(short(known.shown)), say(known.unit)
            else:
                try:
                    about = quantity_of(self.session.data, id)
                except BadInput:
                    continue
                content = value_at(self.session.data, id) if asks(self.session.data, owner) else None
                if content is None:
                    continue
                label, unit = say(about.label), say(about.unit)
                text = numbers.written(content, about, self.session.decimal)
            labels = wrap(label, label_width - 1)
            origin = f"{self.app.signs.mark('from')} {NUMBERS[owner]}"
            value = f"{text} {unit}".rstrip()
            room = max(1, min(18, width - label_width - len(origin) - 1))
            first = f"{labels[0]:<{label_width}}{fit(value, room):<{room}} {origin}"
            items.append(
                Item(id, [Content.styled(row, "dim") for row in (first, *labels[1:])], value, f"{label} {value}")
            )
        if items:
            items.insert(0, Item("", [Content(""), Content.styled(self.app.say(EARLIER), "bold dim")]))
        return items

    def on_key(self, event: events.Key) -> None:
        """A value that another step owns is changed there."""
        if event.is_printable and event.character and event.character in "0123456789,.-":
            event.stop()
            event.prevent_default()
            self.choose()


# --- what the form of a step consists of, in order
# Its question, then a widget for each row of its inputs.

Identity = tuple[object, ...]  # of a widget: kind and place of its row
Part = tuple[Identity, Callable[[], Widget]]  # what tells a part from all others, and how it is made


class FormParts:
    def __init__(self, step: Step, session: Session, say: Language) -> None:
        self._step, self._session, self._say = step, session, say

    @property
    def there(self) -> bool:
        """Whether the design has the step."""
        return asks(self._session.data, self._step.key)

    def parts(self, rows: list[FormRow]) -> list[Part]:
        """Of these rows of inputs, and of what stands before and behind them."""
        key, session = self._step.key, self._session
        parts: list[Part] = [(("guide",), lambda: GuideText(session, key))]
        if key == "imbalance" and "engine" in session.data:
            parts.append((("balance",), lambda: Balance(session, key)))
        elif not self.there:
            parts.append((("todo",), lambda: Todo(session, key)))
        if self.there:
            parts += [(identity(row), partial(self._widget, row)) for row in rows]
            if all(row.place[-1] != f"{FOLD}{ALL}" for row in rows):  # behind which it lies too
                parts.append((("taken",), lambda: Taken(session, key)))
        return parts

    def rows(self, asked: Asked, opened: set[int]) -> list[FormRow]:
        """The inputs of the step, in the user's language; none where the design does not have it."""
        if not self.there:
            return []
        rows = routed(self._step, self._session.data, asked, opened)
        return rows if self._say.original else [_said(row, self._say) for row in rows]

    def fold(self, place: Place) -> int | None:
        """The fold that a place lies in."""
        return fold_at(self._step.key, place, self._session.data)

    def heading(self, row: FormRow) -> Content:
        last = row.place[-1]
        if row.kind == "original":
            original = Name(self._session.original)
            return Content.styled(f" {self._say(Text('all else as {name}', name=original))}", "dim")
        name = (
            str((content_at(self._session.data, row.place) or {}).get("name", last + 1))
            if isinstance(last, int)
            else row.about.label
        )
        return Content.styled(f" {name}", "bold" if not isinstance(last, int) else "italic")

    def _widget(self, row: FormRow) -> Widget:
        session = self._session
        match row.kind:
            case "field":
                return Field(row, session, self._words(row))
            case "stroke":
                return StrokeField(row, session, ())
            case "cells":
                return Cells(row, [Field(cell, session, self._words(cell), cell=True) for cell in row.inside])
            case "columns":
                return CellColumns(row)
            case "array" | "leaf":
                return (ShaftsHeading if row.place == SHAFTS else ArrayHeading)(row, session)
            case "option":
                return TableHeading(row, session)
            case "fold":
                return Fold(row, session)
            case _:
                return Static(self.heading(row), classes="heading")

    def _words(self, row: FormRow) -> tuple[str, ...]:
        """The names that a field of a catalogue may hold."""
        catalogue = row.about.catalogue
        return tuple(getattr(self._session.design, catalogue)) if catalogue else ()


def identity(row: FormRow) -> Identity:
    return (row.kind, row.place, len(row.inside)) if row.kind == "cells" else (row.kind, row.place)


def _said(row: FormRow, say: Language) -> FormRow:
    """A row with its words in the user's language."""
    return replace(
        row, about=in_language(row.about, say), inside=tuple(_said(inner_row, say) for inner_row in row.inside)
    )


# --- the form

WIDE = 46  # cells of the form beside the other panes


class Form(VerticalScroll, can_focus=True, inherit_bindings=False):
    """Fields in the order of the design file.  Focus on the form itself means that no field is being edited."""

    app: BaseApp

    @dataclass
    class Asked(Message):
        """A step that the design does not have is to be built; `choice`: the balancing, with crank and shaft, or the
        kind of the bearings."""

        step: str
        choice: str = ""

    @dataclass
    class LeftOut(Message):
        """The design shall do without a step, for a reason that is to be asked for."""

        step: str

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
        self._sides = 1, 1
        self._gathers = False
        self._parts = FormParts(step, session, self.app.say)

    # --- content
    def compose(self):  # type: ignore[no-untyped-def]
        known = self.parent.size.width if isinstance(self.parent, Widget) else 0  # where another form has stood before
        alone = not self.screen.has_class("-wide") and not self.screen.has_class("-huge")
        self._sides = sides(known or (self.app.size.width if alone else WIDE))
        for part, make in self._parts.parts(self._rows()):
            yield self._made(part, make)

    def _made(self, part: Identity, make: Callable[[], Widget]) -> Widget:
        widget = make()
        self._identities[widget] = part
        return widget

    def _rows(self) -> list[FormRow]:
        """The inputs with the folds, and the elements of arrays, that are open: what is edited, or not accepted, is."""
        reasons = self.session.reasons()
        field = self.field if self.is_mounted else None
        if field is None or not field.editing:
            places = [place for place in reasons if place != RADIUS]  # which the stroke asks for
            self.opened |= {n for place in places if (n := self._parts.fold(place)) is not None}
        editing = [field.place] if field is not None else []
        chosen = {**self.chosen, SHAFTS: self.session.shaft}
        self._gathers = short_of_room(self)
        return self._parts.rows(Asked(chosen, [*editing, *reasons], *self._sides, self._gathers), self.opened)

    def refresh_fields(self, reasons: dict[Place, Text]) -> None:
        """Show what the session says; a design of another shape gets a form of another shape."""
        rows = self._rows()
        by_identity = {identity(row): row for row in rows}
        for child in self.children:
            if isinstance(child, Todo):
                child.rebuild()
        if [self._identities.get(child) for child in self.children] != [part for part, _ in self._parts.parts(rows)]:
            self.rebuild()
        for child in self.children:
            row = by_identity.get(self._identities.get(child, ()))
            if row is None:
                continue
            if isinstance(child, Field):
                child.row = row
                child.show(reasons.get(child.place, EMPTY))
            elif isinstance(child, Cells):
                child.redraw(row, reasons)
            elif isinstance(child, (ArrayHeading, TableHeading)):
                child.redraw(row, reasons.get(row.place, EMPTY))
            elif isinstance(child, (Fold, CellColumns)):
                child.redraw(row)
            elif isinstance(child, Static) and str(child.content) != (heading := self._parts.heading(row)).plain:
                child.update(heading, layout=False)

    def _settle(self) -> None:
        """When the focus has left a field: fields of a table that lost its last key go, and folds with mistakes
        open."""
        if self.display and self.is_attached:
            self.refresh_fields(self.session.reasons())

    def refresh_taken(self) -> None:
        for child in self.children:
            match child:
                case GuideText():
                    child.redraw()
                case Balance():
                    child.refresh_options()
                    child.rebuild()
                case Taken():
                    child.rebuild()

    def on_resize(self, event: events.Resize) -> None:
        if (found := sides(event.size.width)) != self._sides or self._gathers != short_of_room(self):
            self._sides = found
            self.rebuild()

    def watch_virtual_size(self) -> None:
        """Something above the field may have grown: it is never typed into unseen."""
        if self.is_attached and self.field is not None:
            self.call_after_refresh(self.bring_into_view)

    def rebuild(self, focus: Place | None = None) -> None:
        """Put the form in order: what goes is taken away, what is new is put in, and all else stays as it is, the focus
        too."""
        if focus is not None:
            self._wanted, self._back = focus, True
            self.screen.set_focus(self, scroll_visible=False)  # keys wait here
        self._stale = True
        if not self._remaking:
            self._remaking = True
            _: Worker[None] = self.run_worker(self._remake, group=f"form-{self.step.key}")

    async def _remake(self) -> None:
        """One at a time and never cancelled: a removal that is cut off leaves widgets that answer no more."""
        cut = 0
        try:
            while self._stale:
                self._stale = False
                try:
                    with self.app.batch_update():
                        await self._put_in_order()
                except asyncio.CancelledError:
                    # a part went while it was awaited: once more, unless all of the form goes
                    cut += 1
                    if cut > 1 or not self.is_attached:
                        raise
                    self._stale = True
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
        parts = self._parts.parts(self._rows())
        wanted = {part for part, _ in parts}
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
        for part, make in parts:
            if (there := standing.get(part)) is None:
                new.append(self._made(part, make))
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
        focusable: list[Widget] = []
        for child in self.children:
            if isinstance(child, Field):
                focusable.append(child.box)
            elif isinstance(child, Cells):
                focusable += [field.box for field in child.fields]
            elif isinstance(child, (ArrayHeading, TableHeading, Fold, Radio)) or (
                isinstance(child, Taken) and child.items
            ):
                focusable.append(child)
        return [stop for stop in focusable if not stop.disabled]

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
        """Focus the field at a place; without one, or where it is gone, the one edited last, or the first.

        `at_once`: before the next key.
        """
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
        fields = (stop for stop in self.stops() if not isinstance(stop, ArrayHeading))  # whose − takes an element out
        if place is None and wanted is None:  # the first that is to be filled in, if one is
            lacking = set(self.session.lacking)
            first = (stop for stop in self.stops() if isinstance(stop.parent, Field) and stop.parent.place in lacking)
            wanted = next(first, None)
        target = wanted or (stops[around[0]] if around else next(fields, self))
        if at_once:
            self.screen.set_focus(target)
        else:
            target.focus()

    def _bring_out(self, place: Place, stops: Collection[Place]) -> bool:
        """Open the fold, or leaf to the element, that a place lies in; whether there was something to do."""
        n, uncovered = self._parts.fold(place), False
        if self._parts.there and n is not None and n not in self.opened:
            self.opened.add(n)
            uncovered = True
        for end, part in enumerate(place):
            if (
                isinstance(part, int)
                and place[:end] != SHAFTS
                and self.chosen.get(place[:end], 0) != part
                and (uncovered or place[:end] in stops)
            ):
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
        if (stop := self.below()) is not None:
            self.screen.set_focus(stop)
        else:
            self.post_message(self.Done())

    def below(self) -> Widget | None:
        """The next field below that which has the focus."""
        stops = self.stops()
        here = stops.index(self.screen.focused) if self.screen.focused in stops else -1
        return next((stop for stop in stops[here + 1 :] if isinstance(stop, (Entry, Choice))), None)

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
        values = ["; ".join(event.values)] if owner.about.kind in ("series", "integers", "names") else event.values
        self.session.seal()
        for field, text in zip(fields, values):
            field.box.show(text)
            self.session.edit(field.place, field.meant(text))
            self.session.seal()
        self.post_message(self.Changed())
        if left := values[len(fields) :]:
            self.app.tell(Text("There is no field left for {values}.", values="; ".join(left)), "warning")
        self.screen.set_focus(fields[min(len(values), len(fields)) - 1].box)

    def toggle_lock(self) -> bool:
        """Lock the input that has the focus against remedies and searches, or unlock it; False where there is none."""
        if (field := self.field) is None:
            return False
        self.session.toggle_lock(field.place)
        field.redraw()
        self.post_message(self.Changed())
        return True

    def on_fold_turned(self, event: Fold.Turned) -> None:
        n = int(str(event.fold.row.place[-1]))
        if n == ALL:
            self.opened.add(ALL)
            self.rebuild((self.step.key, f"{FOLD}0"))
            return
        self.opened = self.opened | {n} if event.open else self.opened - {n} | {ALL}  # those beside it stay in sight
        self.refresh_fields(self.session.reasons())

    def on_item_list_chosen(self, event: ItemList.Chosen) -> None:
        """What a step offers first is taken."""
        if not isinstance(source := event.source, Radio):
            return
        event.stop()
        if isinstance(source, Balance) and event.key != source.made():
            self.post_message(self.Asked("countershaft", event.key))
        elif isinstance(source, Balance):
            self.post_message(self.Done())
        elif event.key == Todo.LEAVE:
            self.post_message(self.LeftOut(self.step.key))
        else:
            self.ask(event.key)

    # --- arrays
    def on_array_heading_leafed(self, event: ArrayHeading.Leafed) -> None:
        if event.heading.row.place == SHAFTS:
            return  # which the whole screen leafs through
        event.stop()
        self.chosen[event.heading.row.place] = event.index
        self.rebuild(event.heading.row.place)

    def ask(self, key: str = Todo.BUILD) -> None:
        """Enter on the form of a step that the design does not have, or on one of the ways to build it."""
        if not self._parts.there:
            self.post_message(self.Asked(self.step.key, "" if key == Todo.BUILD else key))
