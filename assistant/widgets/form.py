# SPDX-License-Identifier: Apache-2.0
"""The inputs of one step, generated from their descriptions."""

from dataclasses import dataclass, replace

from textual import events
from textual.containers import VerticalScroll
from textual.content import Content
from textual.message import Message
from textual.widget import Widget
from textual.widgets import Input, Static
from textual.worker import Worker

from calc.languages.outcome import in_language
from calc.sheet.step import Step
from calc.sheet.text import EMPTY, Text

from ..base_app import BaseApp
from ..places import Place, content_at, key_at
from ..session import Session
from ..upstream import NAMED
from .array_heading import ArrayHeading
from .choice import Choice
from .entry import Entry
from .field import Field
from .guide_text import GuideText
from .rows import Row, rows
from .table_heading import TableHeading
from .upstream_values import Taken

Shape = list[tuple[str, Place]]  # kind and place of each row


class Form(VerticalScroll, can_focus=True, inherit_bindings=False):
    """Fields in the order of the design file.  Focus on the form itself means that no field is being edited."""

    app: BaseApp

    @dataclass
    class Asked(Message):
        """The step, which the design does not have, is wanted."""

        step: Step

    def __init__(self, step: Step, session: Session) -> None:
        super().__init__(id=f"form-{step.key}", classes="form")
        self.step = step
        self.session = session
        self.chosen: dict[Place, int] = {}
        self._shape: Shape = []
        self.last: Place | None = None  # the field that was edited last
        self._stale = False  # the form has to be made anew
        self._remaking = False
        self._wanted: Place | None = None  # where the focus goes when the form stands again
        self._back = False  # the focus was in the form

    # --- content
    def compose(self):  # type: ignore[no-untyped-def]
        yield from self._widgets()

    def _widgets(self) -> list[Widget]:
        if self.step.key not in self.session.data:
            self._shape = []
            texts = (
                Text("This design has no step {title}.", title=self.step.title),
                Text("Enter adds it, with the values of the example; undo takes it out."),
            )
            return [Static(Content("\n\n".join(f" {self.app.say(text)}" for text in texts)))]
        found = self._rows()
        self._shape = _shape(found)
        made: list[Widget] = [GuideText(self.session, self.step.key)]
        for row in found:
            match row.kind:
                case "field":
                    made.append(Field(row, self.session, self._words(row)))
                case "array":
                    made.append(ArrayHeading(row, self.session))
                case "option":
                    made.append(TableHeading(row, self.session))
                case _:
                    first = bool(made) and isinstance(made[-1], ArrayHeading)
                    made.append(Static(self._heading(row), classes="heading -first" if first else "heading"))
        return [*made, Taken(self.session, self.step.key)]

    def _standing(self) -> list[Widget]:
        """What stands for the rows of the form, in their order."""
        return [child for child in self.children if child.display and not isinstance(child, GuideText)]

    def _rows(self) -> list[Row]:
        editing = [self.field.place] if self.is_mounted and self.field is not None else []
        found = rows(self.step, self.session.data, self.chosen, [*editing, *self.session.reasons()])
        say = self.app.say
        return found if say.code == "en" else [replace(row, about=in_language(row.about, say)) for row in found]

    def _heading(self, row: Row) -> Content:
        last = row.place[-1]
        name = str((content_at(self.session.data, row.place) or {}).get("name", last + 1)) if isinstance(last, int) else row.about.label
        return Content.styled(f" {name}", "bold" if not isinstance(last, int) else "italic")

    def _words(self, row: Row) -> tuple[str, ...]:
        """The names that a field of a catalogue may hold."""
        catalogue = NAMED.get(key_at(row.place)) if row.about.kind == "text" else None
        return tuple(getattr(self.session.design, catalogue)) if catalogue else ()

    def refresh_fields(self, reasons: dict[Place, Text]) -> None:
        """Show what the session says; a design of another shape gets another form."""
        if self.step.key not in self.session.data or not self._shape:
            if bool(self._shape) != (self.step.key in self.session.data):
                self.rebuild()
            return
        found = self._rows()
        if not self._remaking:
            self._hide(_shape(found))
        if _shape(found) != self._shape:
            self.rebuild()
            return
        by_place = {row.place: row for row in found}
        standing = self._standing()
        for child in standing:
            if isinstance(child, Field):
                child.row = by_place[child.place]
                child.show(reasons.get(child.place, EMPTY))
            elif isinstance(child, (ArrayHeading, TableHeading)):
                child.redraw(by_place[child.row.place], reasons.get(child.row.place, EMPTY))
        headings = [row for row in found if row.kind == "heading"]
        for row, heading in zip(headings, (child for child in standing if isinstance(child, Static))):
            made = self._heading(row)
            if str(heading.content) != made.plain:
                heading.update(made, layout=False)

    def _settle(self) -> None:
        """A table that lost its last key loses its fields when the focus has left them."""
        if self.display and self._shape and not self._remaking:
            self._hide(_shape(self._rows()))

    def _hide(self, shape: Shape) -> None:
        """Hide the fields of tables that are no longer there.  They are not taken away: no key is lost that is typed meanwhile."""
        absent = [place for kind, place in shape if kind == "option" and content_at(self.session.data, place) is None]
        gone = [entry for entry in self._shape if entry not in shape and any(entry[1][: len(place)] == place for place in absent)]
        if gone and [entry for entry in self._shape if entry not in gone] == shape:
            for child, entry in zip(self._standing(), self._shape):
                child.display = entry not in gone
            self._shape = shape

    def refresh_taken(self) -> None:
        for guide in self.query(GuideText):
            guide.redraw()
        for taken in self.query(Taken):
            taken.rebuild()

    def rebuild(self, focus: Place | None = None) -> None:
        """Make the form anew; the focus stays on the same place, where it still exists."""
        inside = self.screen.focused is not None and self.screen.focused in self.walk_children()
        self._wanted = focus or self.here() or (self._wanted if self._remaking else None)
        self._stale = True
        if inside:
            self.focus(scroll_visible=False)
        self._back = self._back or inside
        if not self._remaking:
            self._remaking = True
            _: Worker[None] = self.run_worker(self._remake, group=f"form-{self.step.key}")

    async def _remake(self) -> None:
        """One at a time and never cancelled: a removal that is cut off leaves widgets that answer no more."""
        try:
            while self._stale:
                self._stale = False
                with self.app.batch_update():
                    await self.remove_children()
                    await self.mount(*self._widgets())
                self.refresh_fields(self.session.reasons())
        finally:
            self._remaking = False
        if self._back or self._wanted is not None:
            self._back = False
            self.focus_place(self._wanted)
            self.call_after_refresh(self.bring_into_view)

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
            if not child.display:
                continue
            if isinstance(child, Field):
                found.append(child.box)
            elif isinstance(child, (ArrayHeading, TableHeading)) or (isinstance(child, Taken) and child.items):
                found.append(child)
        return found

    def here(self) -> Place | None:
        """The place that has the focus."""
        focused = self.screen.focused
        if isinstance(focused, (ArrayHeading, TableHeading)):
            return focused.row.place
        field = self.field
        return field.place if field is not None else None

    @property
    def field(self) -> Field | None:
        """The field that has the focus."""
        focused = self.screen.focused
        return focused.parent if isinstance(focused, (Entry, Choice)) and isinstance(focused.parent, Field) else None

    def focus_place(self, place: Place | None) -> None:
        """Focus the field at a place; without one, or where it is gone, the one edited last, or the first."""
        stops = {}
        for stop in self.stops():
            owner = stop.parent if isinstance(stop.parent, Field) else stop
            stops[owner.row.place if isinstance(owner, (Field, ArrayHeading, TableHeading)) else ()] = stop
        wanted = stops.get(place) if place else stops.get(self.last) if self.last else None
        if wanted is None and place and any(isinstance(part, int) for part in place):
            for end, part in enumerate(place):  # an element that is not shown: leaf to it
                if isinstance(part, int) and self.chosen.get(place[:end], 0) != part and place[:end] in stops:
                    self.chosen[place[:end]] = part
                    self.rebuild(place)
                    return
        around = [place[:end] for end in range(len(place) - 1, 1, -1) if place[:end] in stops] if place else []
        target = wanted or (stops[around[0]] if around else next(iter(stops.values()), self))
        target.focus()

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

    def on_descendant_focus(self, event: events.DescendantFocus) -> None:
        if (field := self.field) is not None:
            self.last = field.place
            field.redraw()

    def on_descendant_blur(self, event: events.DescendantBlur) -> None:
        owner = event.widget.parent
        if isinstance(owner, Field):
            self.session.seal()
            owner.rewrite()
            owner.redraw()
            self.call_after_refresh(self._settle)

    def on_input_submitted(self, event: Input.Submitted) -> None:
        """Enter accepts and goes on."""
        event.stop()
        if isinstance(owner := event.input.parent, Field):
            self.session.seal()
            owner.rewrite()
        self.go(1)

    # --- arrays
    def on_array_heading_leafed(self, event: ArrayHeading.Leafed) -> None:
        event.stop()
        self.chosen[event.heading.row.place] = event.index
        self.rebuild(event.heading.row.place)

    def ask(self) -> None:
        """Enter on the form of a step that the design does not have."""
        if self.step.key not in self.session.data:
            self.post_message(self.Asked(self.step))


def _shape(found: list[Row]) -> Shape:
    return [(row.kind, row.place) for row in found]
