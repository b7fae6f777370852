# SPDX-License-Identifier: Apache-2.0
"""A design under edit: the changes made to it, what was typed, and what of it is not allowed.

Every edit makes a new document that is checked whole.  What can not be understood, or is not allowed, stays visible in
its field while the last valid design stays as it was.  `undo.py` keeps the states that it has been through."""

import math
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from calc.countershaft.rows import BearingRow
from calc.design.addresses import (
    Table,
    address,
    changed,
    every,
    of_kind,
    parse_assignment,
    quantity_of,
    rows_of_twin,
    step_at,
    unjudged,
    value_at,
)
from calc.design.labels import SHAFTS, Place, content_at, with_bearings
from calc.design.locks import locked, standing, toggled
from calc.design.model import SCHEMA, Design
from calc.design.names import written
from calc.design.toml_file import Document, design, parse
from calc.sheet.errors import BadInput, InputError, NoSolution, text_of
from calc.sheet.quantity import Quantity, dotted
from calc.sheet.text import EMPTY, SEMICOLON, Amount, Name, Part, Text

from . import numbers
from .inherited import inherited, owned
from .places import (
    NAME,
    OWN,
    WHEELS,
    described,
    error_place,
    followed,
    further,
    further_shaft,
    less,
    named_key,
    names_of,
    optional_table,
    with_shafts,
    with_wheel,
    without_empty,
    without_row,
    without_silent,
)
from .recording import Recording
from .undo import EditState, History

# --- changes of a design as `--set` takes them, KEY=VALUE
# Made all together, and told in words.


def applied(document: Document, changes: Iterable[str]) -> Document:
    """The document with every change made.  Raises BadInput where a key is none."""
    for change in changes:
        document = document.with_value(*parse_assignment(change))
    return document


def told(document: Document, changes: Iterable[str]) -> Text:
    """What each change does: "Bore (engine.bore_mm) 94 → 95 mm"; those that change nothing are left out."""
    texts = []
    for key, value, there in _different(document, changes):
        if there is None:
            texts.append(Text("{key} {value}", key=key, value=_part(value)))
            continue
        about, before = there
        texts.append(
            Text(
                "{label} ({key}) {before} → {value}",
                label=about.label,
                key=key,
                before=_part(before),
                value=_part(value, about.unit),
            )
        )
    return SEMICOLON.join(texts)


def held_words(document: Document, step: str) -> Text:
    """What is locked of the inputs of a step, with its value and why; empty where nothing is."""
    texts = [
        Text(
            "{label} {value} ({reason})",
            label=quantity_of(document.data, key).label,
            value=written(value_at(document.data, key)),
            reason=reason,
        )
        for key, reason in standing(document.data).items()
        if step_at(document.data, key) == step and key.count(".")
    ]
    return Text("Held: {inputs}.", inputs=SEMICOLON.join(texts)) if texts else EMPTY


def locked_text(document: Document, changes: Iterable[str]) -> Text:
    """`changes what is locked: Oil (bearings.oil): the oil is the engine's`; empty where nothing of it is."""
    texts = [
        Text("{label} ({key}): {reason}", label=there[0].label, key=key, reason=reason)
        for key, _, there in _different(document, changes)
        if there is not None and (reason := locked(document.data, key))
    ]
    return Text("changes what is locked: {inputs}", inputs=SEMICOLON.join(texts)) if texts else EMPTY


def _different(document: Document, changes: Iterable[str]) -> Iterator[tuple[str, Any, tuple[Quantity, object] | None]]:
    """Keys with their new values, each with its description and the value before; None of an element that only the
    changes make."""
    for key, value in _each(document, changes):
        try:
            there = quantity_of(document.data, key), value_at(document.data, key)
        except BadInput:
            yield key, value, None
            continue
        if there[1] != value:
            yield key, value, there


def _each(document: Document, changes: Iterable[str]) -> Iterator[tuple[str, object]]:
    """Keys with their new values, one with a * as all that it stands for."""
    for key, value in map(parse_assignment, changes):
        try:
            yield from ((each, value) for each in every(document.data, key))
        except BadInput:
            yield key, value


def _part(value: Any, unit: str = "") -> Part:
    """A value of the design file as the part of a sentence."""
    if value is None:
        return "(auto)"
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return Amount(value, unit, form="g" if isinstance(value, float) else "d")
    text = (
        SEMICOLON.join(Text("{item}", item=_part(item)) for item in value)
        if isinstance(value, list)
        else Name(str(value))
    )
    return Text("{text} {unit}", text=text, unit=unit) if unit else text


# --- what was typed, and what it means

LOCKED_HERE = "locked in the session"
NEAR = 0.1  # of their diameter: profile shifts bring two wheels no further together or apart


@dataclass(frozen=True)
class BuildPlan:
    """What was built for the tables of a design; `why`: it can not be built; `left`: why the rules came no further;
    `asked`: of a step what was asked for."""

    of: Table = field(repr=False)
    data: Table = field(repr=False)
    why: Text = EMPTY
    left: Text = EMPTY
    asked: Mapping[str, str] = field(default_factory=dict)


class Editing:
    """The fields of one design, and the way back through its edits.  Knows neither the disk nor the results."""

    def __init__(self, raw: bytes, origin: Path, *, blank: bool = False) -> None:
        """`blank`: it may be no design yet, of which nothing is known then but its name.  Raises BadInput."""
        self.document: Document = parse(raw, str(origin))
        self.errors: tuple[InputError, ...] = ()
        self.refused: dict[str, str] = {}  # of a step what was asked for, and can not be built
        self.blank = False  # it has been no design yet
        try:
            self.design: Design = design(self.document)
        except BadInput as bad:
            if not blank:
                raise
            self.blank = True
            self.design = Design(schema=SCHEMA, name=str(self.document.data.get(NAME, "")))
            self.errors = tuple(bad.errors)
        self.generation = 1
        self.history = History(EditState(self.document.data, {}))
        # the last that were a valid design; of a blank one the first
        self._valid: Table = self.document.data
        self.recording: Recording | None = None  # follows the edits, if it was asked for
        self.own_name = origin.stem  # of what is no longer another's
        self.decimal = "."  # sign of the user's language

    # --- what is shown
    @property
    def _state(self) -> EditState:
        return self.history.state

    @property
    def data(self) -> Table:
        return self._state.data

    @property
    def valid(self) -> bool:
        return not self.errors and not self._state.texts

    def place(self, key: str | Place) -> Place:
        """Where a dotted key stands; a place is taken as it is."""
        return address(self._state.data, key) if isinstance(key, str) else key

    def value(self, key: str | Place) -> Any:
        """The value in the unit of its key, None where it is left out."""
        return content_at(self._state.data, self.place(key))

    def about(self, key: str | Place) -> Quantity:
        return described(self.place(key))

    def text(self, key: str | Place) -> str:
        """What stands in the field: what was typed and not understood, else the value as it is written."""
        where = self.place(key)
        if where in self._state.texts:
            return self._state.texts[where][0]
        return numbers.written(self.value(where), described(where), self.decimal)

    def reason(self, key: str | Place) -> Text:
        """Why this field is not accepted; empty where it is."""
        where = self.place(key)
        return self.reasons().get(where, EMPTY)

    def reasons(self) -> dict[Place, Text]:
        """Every field that is not accepted, with the reason; mistakes that belong to a table stand at the place of the
        table."""
        reasons: dict[Place, Text] = {}
        for error in self.errors:
            reasons.setdefault(error_place(self._state.data, error.key), error.reason)
        reasons.update({where: reason for where, (_, reason) in self._state.texts.items()})
        return reasons

    def lacks(self, where: Place) -> bool:
        """Whether a field that is not accepted is one to be filled in: empty, in what has been no design yet."""
        return self.blank and where not in self._state.texts and self.value(where) is None

    @property
    def lacking(self) -> list[Place]:
        """All such fields, where nothing else is wrong; none where something is."""
        places = list(self.reasons())
        return places if all(map(self.lacks, places)) else []

    @property
    def inherited(self) -> tuple[str, tuple[Place, ...]]:
        """The engine that the design began with, and which of its numbers are still there; not those that were typed
        alike."""
        return inherited(self._state.data)

    # --- editing
    def edit(self, key: str | Place, text: str) -> Text:
        """Type a text into a field.  Gives the reason why it is not accepted, or nothing.

        Edits of one field that follow each other are one step of the undo; `seal()` ends the step.
        """
        where = self.place(key)
        texts = {k: v for k, v in self._state.texts.items() if k != where}
        try:
            # such a table goes with its last key, so a key must go too
            gone = not text.strip() and optional_table(where) is not None
            content = None if gone else numbers.value(text, described(where))
        except numbers.NotUnderstood as no:
            self._step(EditState(self._state.data, {**texts, where: (text, no.reason)}), where)
            return no.reason
        old = self.value(where)
        if isinstance(content, list) and len(content) == 1 and old is not None and not isinstance(old, list):
            content = content[0]  # a list of one may stand in the file as a number
        data = self._state.data
        if content != old or type(content) is bool:
            there = with_bearings(data, where) if self.value(where[:-1]) is None else data
            data = without_silent(of_kind(there, changed(there, where, content), where), where)
            if where[-1] == dotted(BearingRow.kind):  # of a bearing other fields stand there now
                texts = {k: v for k, v in texts.items() if k[:-1] != where[:-1]}
        self._step(EditState(followed(self._valid, without_empty(data, where), where), texts), where)
        return self.reason(where)

    def seal(self) -> None:
        """The next edit is a step of its own."""
        self.history.seal()

    def add(self, key: str | Place) -> int:
        """A further element of an array of tables (see `further`).  Gives its index."""
        where = self._array(key)
        elements, index = further(
            where, self.value(where) or [], rows_of_twin(self._state.data, ".".join(map(str, where)))
        )
        self.seal()
        self._step(EditState(changed(self._state.data, where, elements), self._state.texts), where)
        self.seal()
        return index

    def add_shaft(self, name: str, what: str) -> int:
        """A further shaft beside the one of that name (see `further_shaft`); a twin is turned as that one is (see
        `with_wheel`).  Gives its index."""
        there = self.value(SHAFTS) or []
        shaft = further_shaft(there, name, what, names_of(content_at(self._state.data, WHEELS) or []))
        data = with_shafts(self._state.data, [*there, shaft], self.ids_of_shaft())
        if what != OWN and (carrier := self._carrier(name)):
            data = with_wheel(data, str(shaft[NAME]), name, carrier, what, meets=self._meets(name, carrier))
        self._put_shafts(data)
        return len(there)

    def _carrier(self, shaft: str) -> str:
        """The wheel or sprocket that turns a shaft, by the last valid design; empty where none does."""
        gears = self.design.gears
        if gears is None:
            return ""
        carrier = gears.carrier(shaft)
        says = {wheel.name for wheel in gears.wheels if wheel.shaft == shaft} | {shaft}
        return carrier if len(self.design.shafts) == 1 or carrier in says else ""

    def _meets(self, shaft: str, wheel: str) -> bool:
        """Whether the wheel of a shaft meets the like one of its mirror image, as far as their places are known."""
        gears, axis = self.design.gears, next((s.axis for s in self.design.shafts if s.name == shaft), None)
        teeth = next((there.teeth for there in gears.wheels if there.name == wheel), 0) if gears is not None else 0
        if gears is None or axis is None or not axis[1] or not teeth:
            return True
        diameter = teeth * gears.module / math.cos(gears.helix_angle)
        return abs(2 * abs(axis[1]) - diameter) <= NEAR * diameter

    def remove(self, key: str | Place, index: int) -> None:
        """Take an element out of an array of tables; a shaft with its twins, a bearing with what twins say of it."""
        where = self._array(key)
        there = self.value(where) or []
        left = less(where, there, index)
        if where == SHAFTS:
            self._put_shafts(with_shafts(self._state.data, left, self.ids_of_shaft()))
            return
        texts = {k: v for k, v in self._state.texts.items() if k[: len(where)] != where}
        data = changed(self._state.data, where, left or None)
        if described(where).table is BearingRow:
            data = without_row(data, where[:-1], there[index].get(NAME))
        self.seal()
        self._step(EditState(data, texts), where)
        self.seal()

    def _put_shafts(self, data: Table) -> None:
        """Tables with other shafts."""
        texts = {k: v for k, v in self._state.texts.items() if k[:1] != SHAFTS}
        self.seal()
        self._step(EditState(data, texts), SHAFTS)
        self.seal()

    def ids_of_shaft(self) -> Collection[str]:
        """The ids of what a shaft has for itself, without its name, as far as they are known."""
        return ()

    def _array(self, key: str | Place) -> Place:
        return address(self._state.data, key, whole=True) if isinstance(key, str) else key

    def put_table(self, where: Place, there: bool) -> None:
        """Add a table that may be left out, with no key yet (what it needs is then reported as missing); or leave it
        out."""
        texts = {k: v for k, v in self._state.texts.items() if k[: len(where)] != where}
        data = changed(self._state.data, where, {} if there else None)
        if where == (dotted(Design.bearings),) and not there:
            data = unjudged(data)
        self.seal()
        self._step(EditState(data, texts), where)
        self.seal()

    def apply(self, changes: Iterable[str]) -> None:
        """Make several changes, each KEY=VALUE as `--set` takes it, as one step of the undo.  Raises BadInput where a
        key is none.

        What was typed elsewhere, and not understood, stays.
        """
        data, before = applied(self.document, changes).data, self._state.data
        texts = {
            where: text
            for where, text in self._state.texts.items()
            if content_at(data, where) == content_at(before, where)
        }
        self.seal()
        self._step(EditState(data, texts), None)
        self.seal()

    def lock_reason(self, place: str | Place) -> str:
        """Why no remedy and no search may change an input; empty where they may."""
        return locked(self._state.data, named_key(self._state.data, self.place(place)))

    def toggle_lock(self, place: str | Place, reason: str = LOCKED_HERE) -> None:
        """Lock an input, or unlock it, as one step of the undo."""
        data = toggled(self._state.data, named_key(self._state.data, self.place(place)), reason)
        self.seal()
        self._step(EditState(data, self._state.texts), None)
        self.seal()

    def plan(self, step: str, choice: str = "") -> "BuildPlan":
        """A step that the design does not have, built by the rules behind `new`; `choice`: the balancing, with crank
        and shaft, or the kind of the bearings.

        Changes nothing, and so may run in another thread; `take` puts it in.
        """
        from calc.studies.starter.build import built

        document = self.document
        try:
            data = built(document, step, choice).data
        except (BadInput, NoSolution) as error:
            return BuildPlan(document.data, document.data, text_of(error), asked={step: choice})
        if step == "countershaft" and data == document.data:
            return BuildPlan(
                data, data, Text("the balancing that was chosen has no shaft; the step Imbalance offers others")
            )
        return BuildPlan(document.data, data, asked={step: choice})

    def plan_all(self) -> "BuildPlan":
        """All steps that are still to do, as far as the rules come; `why`: they do not come to the first.

        What was asked for and refused is tried again, as another engine may have room for it: nothing else takes its
        place unasked."""
        from calc.studies.starter.build import all_built

        document = self.document
        made, why = all_built(document, self.refused)
        none = made.data == document.data
        return BuildPlan(document.data, made.data, why if none else EMPTY, left=EMPTY if none else why)

    def take(self, plan: "BuildPlan") -> Text:
        """Put in what was built, as one step of the undo; what was asked for and refused is remembered.  Gives the
        reason why not, or nothing."""
        if not plan.why and plan.of is not self.document.data:
            return Text("The design has changed meanwhile: build it once more.")
        if not plan.why:
            self._put(plan.data)
        for step, choice in plan.asked.items():
            self.refused.pop(step, None)
            if plan.why and choice:
                self.refused[step] = choice
        return plan.why

    def ask(self, step: str, choice: str = "") -> Text:
        """Build a step here and now.  Gives the reason why it can not be built, or nothing."""
        return self.take(self.plan(step, choice))

    def leave_out(self, step: str, reason: str) -> None:
        """Say that the design does without a step that it does not have."""
        without = self._state.data.get("without")
        self._put(
            changed(self._state.data, ("without",), {**(without if isinstance(without, dict) else {}), step: reason})
        )

    def _put(self, data: Table) -> None:
        texts = {where: text for where, text in self._state.texts.items() if where[0] in data}
        self.seal()
        self._step(EditState(data, texts), None)
        self.seal()

    def undo(self) -> Place | None:
        """Back by one step.  Gives the place that changed, () where it is no single one, None where there is nothing to
        undo."""
        return self._travelled(self.history.undo)

    def redo(self) -> Place | None:
        return self._travelled(self.history.redo)

    def _travelled(self, travel: Callable[[], Place | None]) -> Place | None:
        before = self._state
        where = travel()
        self._entered(before, back=travel == self.history.undo)
        return where

    def _step(self, state: EditState, where: Place | None) -> None:
        before = self._state
        data = owned(before.data, state.data, self.own_name, typed=where)
        state = state if data is state.data else replace(state, data=data)
        if self.history.go(state, where):
            if self.recording is not None and not self.history.joined:
                self.recording.close()
            self._entered(before)

    def _entered(self, before: EditState, back: bool = False) -> None:
        """The design is another one than before: check it whole.  `back`: by an undo."""
        data = self._state.data
        if data == before.data:
            return
        self.document = replace(self.document, data=data)
        self.generation += 1
        document = replace(self.document, former=None)  # fields go by their keys of today
        try:
            self.design = design(document, None if self.blank else (replace(document, data=self._valid), self.design))
            self.errors = ()
            self.blank = False
            self._valid = data
        except BadInput as bad:
            self.errors = tuple(bad.errors)
            return
        if self.recording is not None and back:
            self.recording.undone(data)
        elif self.recording is not None:
            self.recording.edited(data)

    # --- recording
    def record(self) -> None:
        """Begin to record a replay, at the last valid state."""
        self.seal()
        self.recording = Recording(self._valid)
