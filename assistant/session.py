# SPDX-License-Identifier: Apache-2.0
"""A design under edit, without a screen: what was typed, what it means, what it gives, and how it is kept.

Every edit makes a new document that is checked whole.  What can not be understood, or is not allowed, stays visible in its
field while the last valid design and its results stay as they were.
"""

import os
import threading
from collections.abc import Callable, Iterable
from dataclasses import replace
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

from calc.design import Design
from calc.design_file import Document, Table, address, changed, design, parse, read
from calc.sheet.errors import BadInput, InputError
from calc.sheet.quantity import Published, Quantity, keys

from . import numbers
from .changes import applied
from .history import History, State
from .places import Place, content_at, described, error_place, optional_table, without_empty
from .recovery import Edits, Memory, not_accepted
from .saving import ChangedOnDisk, SaveError, differences, edited_text, free_name, fresh_text, write_atomic
from .solving import Answer, Job, run

if TYPE_CHECKING:
    from calc.solve import Results

SHIPPED = Path(__file__).resolve().parent.parent / "designs"
EXAMPLE = SHIPPED / "r753ie4_gamma.toml"


class Session:
    """One open design.  `path` is where it is saved to; None for the example, which gets a name of its own at the first save."""

    def __init__(self, raw: bytes, origin: Path, *, memory: Memory | None = None, now: Callable[[], datetime] = datetime.now) -> None:
        self.memory = memory or Memory()
        self.now = now
        self.origin = origin  # the file that was read
        self.path: Path | None = None if _shipped(origin) else origin.absolute()
        self.message = ""  # something to be told once, when the session begins
        self.document: Document = parse(raw, str(origin))
        self.design: Design = design(self.document)
        self.errors: tuple[InputError, ...] = ()
        self.results: Results | None = None
        self.seconds, self.failure = 0.0, ""
        self.generation = 1
        self.solved = 0  # the generation of the results
        self.autosaved: datetime | None = None
        self.autosave_failure = ""
        self._keeping = threading.Lock()  # edits are kept in another thread than they are made and saved in
        self._values: tuple[Any, dict[str, Published]] = (None, {})
        self._raw = raw
        self.history = History(State(self.document.data, {}))
        self.opened = self.saved = self.document.data  # as it was read, and as its file is now
        self._valid: Table = self.document.data  # the last tables that were a valid design
        self._kept: Edits | None = None

    # --- opening
    @classmethod
    def open(cls, path: Path | None, *, memory: Memory | None = None, now: Callable[[], datetime] = datetime.now) -> "Session":
        """Open a design; without a path the last one, or the shipped example.  Edits that were never saved are put back, as one
        step that can be undone.  Raises BadInput with every error of the file."""
        memory = memory or Memory()
        wanted = path
        path = path or memory.last()
        told = ""
        if path is not None:
            path = path.expanduser()
            try:
                session = cls._read(path, memory, now)
            except BadInput:
                if wanted is not None:
                    raise
                told = f"The last design, {path}, can not be opened any more; this is the example."
                path = None
        if path is None:
            session = cls._read(EXAMPLE, memory, now)
        elif session.path is not None:
            memory.remember(session.path)
        session._put_back()
        session.message = told or session.message
        return session

    @classmethod
    def _read(cls, path: Path, memory: Memory, now: Callable[[], datetime]) -> "Session":
        read(path)  # the size and the kind of the file are judged there
        return cls(path.read_bytes(), path, memory=memory, now=now)

    def _put_back(self) -> None:
        """Edits that were kept when the program ended before they were saved."""
        kept = self.memory.kept(self.home)
        if kept is None or (kept.data == self.saved and not kept.typed):
            return
        when = kept.time.strftime("%H:%M" if kept.time.date() == self.now().date() else "%d.%m. %H:%M")
        if kept.sha256 != self.document.sha256:
            self.message = (
                f"Edits of {when} were not saved, but the file has changed since; they are kept: “Put back unsaved edits” in the palette."
            )
            return
        if self.restore():
            self.message = f"Edits of {when} that were not saved are back. Undo returns to the file."

    def restore(self) -> bool:
        """Put back the edits that were kept, as one step of the undo."""
        kept = self.memory.kept(self.home)
        if kept is None or (state := kept.state()) == self._state:
            return False
        try:
            design(replace(self.document, data=kept.data))
        except BadInput:
            return False
        self._step(state, None)
        return True

    # --- what is shown
    @property
    def _state(self) -> State:
        return self.history.state

    @property
    def home(self) -> Path:
        """The file of this design: that which is saved to, or the shipped one that it started from."""
        return self.path or self.origin

    @property
    def data(self) -> Table:
        return self._state.data

    @property
    def name(self) -> str:
        """The name of the file."""
        return self.home.name

    @property
    def example(self) -> bool:
        return self.path is None

    @property
    def valid(self) -> bool:
        return not self.errors and not self._state.texts

    @property
    def dirty(self) -> bool:
        return bool(self._state.texts) or self._state.data != self.saved

    @property
    def read_only(self) -> bool:
        """The file itself, or its folder, can not be written; a first save beside it would fail too."""
        target = Path(os.path.realpath(self.home))
        return self.path is not None and not (os.access(target.parent, os.W_OK) and (os.access(target, os.W_OK) or not target.exists()))

    @property
    def current(self) -> bool:
        """The results belong to what the fields say."""
        return self.valid and self.solved == self.generation

    def values(self) -> dict[str, Published]:
        """Every value of the results, by its id."""
        if self._values[0] is not self.results:
            self._values = (self.results, self.results.values() if self.results is not None else {})
        return self._values[1]

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
        return numbers.written(self.value(where), described(where))

    def reason(self, key: str | Place) -> str:
        """Why this field is not accepted; empty where it is."""
        where = self.place(key)
        return self.reasons().get(where, "")

    def reasons(self) -> dict[Place, str]:
        """Every field that is not accepted, with the reason; mistakes that belong to a table stand at the place of the table."""
        found: dict[Place, str] = {}
        for error in self.errors:
            found.setdefault(error_place(self._state.data, error.key), error.reason)
        return found | {where: reason for where, (_, reason) in self._state.texts.items()}

    # --- editing
    def edit(self, key: str | Place, text: str) -> str:
        """Type a text into a field.  Gives the reason why it is not accepted, or nothing.

        Edits of one field that follow each other are one step of the undo; `seal()` ends the step.
        """
        where = self.place(key)
        texts = {k: v for k, v in self._state.texts.items() if k != where}
        try:
            gone = not text.strip() and optional_table(where) is not None  # such a table goes with its last key, so a key must go too
            content = None if gone else numbers.value(text, described(where))
        except numbers.NotUnderstood as no:
            self._step(State(self._state.data, {**texts, where: (text, str(no))}), where)
            return str(no)
        old = self.value(where)
        if isinstance(content, list) and len(content) == 1 and old is not None and not isinstance(old, list):
            content = content[0]  # a list of one may stand in the file as a number
        data = self._state.data if content == old and type(content) is not bool else changed(self._state.data, where, content)
        self._step(State(without_empty(data, where), texts), where)
        return self.reason(where)

    def seal(self) -> None:
        """The next edit is a step of its own."""
        self.history.seal()

    def add(self, key: str | Place) -> int:
        """A further element of an array of tables, like the last one but with a name of its own.  Gives its index."""
        where = self.place(key) if not isinstance(key, str) else tuple(key.split("."))
        there = self.value(where) or []
        made = dict(there[-1]) if there else {}
        names = [item.get("name") for item in there]
        if isinstance(made.get("name"), str):
            base = made["name"].rstrip("0123456789").rstrip("-")
            made["name"] = next(name for n in range(2, len(there) + 3) if (name := f"{base}-{n}") not in names)
        self.seal()
        self._step(State(changed(self._state.data, where, [*there, made]), self._state.texts), where)
        self.seal()
        return len(there)

    def remove(self, key: str | Place, index: int) -> None:
        """Take an element out of an array of tables."""
        where = self.place(key) if not isinstance(key, str) else tuple(key.split("."))
        there = [item for n, item in enumerate(self.value(where) or []) if n != index]
        texts = {k: v for k, v in self._state.texts.items() if k[: len(where)] != where}
        self.seal()
        self._step(State(changed(self._state.data, where, there or None), texts), where)
        self.seal()

    def put_table(self, where: Place, there: bool) -> None:
        """Add a table that may be left out, with no key yet (what it needs is then reported as missing); or leave it out."""
        texts = {k: v for k, v in self._state.texts.items() if k[: len(where)] != where}
        self.seal()
        self._step(State(changed(self._state.data, where, {} if there else None), texts), where)
        self.seal()

    def apply(self, changes: Iterable[str]) -> None:
        """Make several changes, each KEY=VALUE as `--set` takes it, as one step of the undo.  Raises BadInput where a key is none."""
        data = applied(self.document, changes).data
        self.seal()
        self._step(State(data, {}), None)
        self.seal()

    def ask(self, step: str) -> None:
        """Add a step that the design does not have, with the values of the example."""
        example = parse(EXAMPLE.read_bytes(), EXAMPLE.name).data
        self.seal()
        order = [f.key for f in keys(Design).values()]
        data = {**self._state.data, step: example[step]}
        self._step(State({k: data[k] for k in sorted(data, key=order.index)}, self._state.texts), (step,))
        self.seal()

    def undo(self) -> Place | None:
        """Back by one step.  Gives the place that changed, () where it is no single one, None where there is nothing to undo."""
        return self._travelled(self.history.undo)

    def redo(self) -> Place | None:
        return self._travelled(self.history.redo)

    def _travelled(self, travel: Callable[[], Place | None]) -> Place | None:
        before = self._state
        where = travel()
        self._entered(before)
        return where

    def _step(self, state: State, where: Place | None) -> None:
        before = self._state
        if self.history.go(state, where):
            self._entered(before)

    def _entered(self, before: State) -> None:
        """The design is another one than before: check it whole."""
        data = self._state.data
        if data == before.data:
            return
        self.document = replace(self.document, data=data)
        self.generation += 1
        try:
            self.design = design(self.document)
            self.errors = ()
            self._valid = data
        except BadInput as bad:
            self.errors = tuple(bad.errors)

    # --- solving
    def job(self) -> Job | None:
        """What is to be solved now; None where the input is not valid or the results are up to date."""
        if not self.valid or self.solved == self.generation:
            return None
        return Job(self.generation, self.design, self.results)

    def accept(self, answer: Answer) -> bool:
        """Take over what a solve gave; an answer to an older question is dropped."""
        if answer.generation != self.generation or self.errors:
            return False
        self.solved = answer.generation
        self.failure = answer.failure
        if answer.results is not None:
            self.results, self.seconds = answer.results, answer.seconds
        return True

    def solve(self) -> None:
        """Solve here and now."""
        if (job := self.job()) is not None:
            self.accept(run(job))

    # --- keeping
    def bytes(self) -> bytes:
        """The design file as it would be saved now."""
        changes = differences(self.saved, self._state.data)
        if not changes:
            return self._raw
        try:
            return edited_text(self._raw.decode("utf-8"), changes).encode("utf-8")
        except SaveError:  # a notation that can not be edited in place
            self.message = "The comments of the file could not be kept; the old file stays as .bak."
            return fresh_text(self._state.data).encode("utf-8")

    def save(self, *, force: bool = False) -> Path:
        """Save; the example under its own name in the current folder, never over another file.  Raises SaveError with what to do.

        `force` overwrites a file that another program has changed since it was read.
        """
        if self.path is not None and not force:
            try:
                there = self.path.read_bytes()
            except FileNotFoundError:
                there = self._raw
            except OSError as error:
                raise SaveError(f"{self.path} can not be read: {error.strerror or error}; save under another name") from None
            if there != self._raw:
                raise ChangedOnDisk(
                    f"{self.path.name} was changed by another program; save once more to overwrite it (the other version is kept as .bak)"
                )
        return self._write(self.path or free_name(Path.cwd() / self.origin.name))

    def save_as(self, path: Path) -> Path:
        """Save under another name; the session goes on with that file.  A file that is there is overwritten, and kept as .bak."""
        path = path.expanduser()
        if not path.suffix and not path.is_dir():
            path = path.with_suffix(".toml")
        if _shipped(path):
            raise SaveError(f"{path.name} is the shipped example; give another name")
        if path.is_dir():
            raise SaveError(f"{path} is a folder; give the name of a file in it")
        return self._write(path.absolute())

    def _write(self, path: Path) -> Path:
        if not self.valid:
            where, reason = next(iter(self.reasons().items()))
            raise SaveError(f"not saved: {'.'.join(map(str, where)) or 'the design'} {reason}")
        raw = self.bytes()
        write_atomic(path, raw)
        with self._keeping:
            self.memory.drop(self.home)
            self.memory.drop(path)
            self.path, self._raw, self._kept = path, raw, None
            self.document = parse(raw, str(path))
            self.saved = self._valid = self.document.data
            self.history.state = State(self.document.data, {})
            self.autosaved, self.autosave_failure = None, ""
        self.seal()
        self.memory.remember(path)
        return path

    def autosave(self) -> None:
        """Keep aside the last valid state and the entries that are not accepted; a failure is remembered."""
        with self._keeping:
            state, data = self._state, self._valid
            typed = not_accepted(data, state)
            if data == self.saved and not typed:
                if self._kept is not None:
                    self.memory.drop(self.home)
                    self._kept, self.autosaved = None, None
                return
            edits = Edits(data, self.now(), self.document.sha256, typed)
            if self._kept is not None and (data, typed) == (self._kept.data, self._kept.typed):
                return
            try:
                self.memory.keep(self.home, edits)
            except SaveError as error:
                self.autosave_failure = str(error)
                return
            self._kept, self.autosaved, self.autosave_failure = edits, edits.time, ""

    @property
    def safe(self) -> bool:
        """Nothing is lost if the program ends now."""
        return not self.dirty or (self._kept is not None and self._kept.state() == self._state and not self.autosave_failure)


def _shipped(path: Path) -> bool:
    return path.resolve().parent == SHIPPED
