# SPDX-License-Identifier: Apache-2.0
"""A design under edit, without a screen: what it gives, and how it is kept.

While an entry is not valid, the last valid design and its results stay as they were.
"""

import os
import threading
from collections.abc import Callable
from dataclasses import replace
from datetime import datetime
from pathlib import Path
from secrets import token_hex
from typing import TYPE_CHECKING, Any

from calc.design.addresses import Table
from calc.design.disk import read_file
from calc.design.labels import SHAFTS, Place, content_at
from calc.design.limits import DESIGN_BYTES
from calc.design.toml_file import design, parse, read, same_content
from calc.sheet.errors import BadInput, InputError
from calc.sheet.quantity import Published
from calc.sheet.text import EMPTY, Text
from calc.studies.shipped import EXAMPLE, is_shipped

from .editing import Editing
from .places import NAME, named_key, original_of
from .recovery import Edits, Memory, Presence, is_file, not_accepted, with_said
from .saving import Draft, SaveError, free_name, fresh_text, write_atomic
from .solving import Answer, Job, run
from .undo import EditState

if TYPE_CHECKING:
    from calc.solve import Results


LONG = 0.1  # seconds of a solve from which on its verdicts are worth a solve of their own, ahead of it
ALONE = {"schema", "name", "note", "engine"}  # the keys of a design with nothing but an engine


class Session(Editing):
    """One open design.  `path` is where it is saved to; None for the example, which gets a name of its own at the first
    save."""

    def __init__(
        self,
        raw: bytes,
        origin: Path,
        *,
        memory: Memory | None = None,
        now: Callable[[], datetime] = datetime.now,
        blank: bool = False,
    ) -> None:
        super().__init__(raw, origin, blank=blank)
        self.memory = memory or Memory()
        self.now = now
        self.origin = origin  # the file that was read
        self.path: Path | None = None if is_shipped(origin) else origin.absolute()
        self.message = EMPTY  # something to be told once, when the session begins
        self.results: Results | None = None
        self.seconds, self.failure = 0.0, EMPTY
        self.solved = 0  # the generation of the results
        self._ahead: tuple[int, Results | None] = (0, None)  # verdicts ahead of the results, and their generation
        self.seconds_ahead = 0.0  # that they took
        self.autosaved: datetime | None = None
        self.autosave_failure = EMPTY
        self._keeping = threading.Lock()  # edits are kept in another thread than they are made and saved in
        self._values: tuple[Any, dict[str, Published]] = (None, {})
        self._views: tuple[Any, dict[str, Results]] = (None, {})
        self._shaft = 0
        self._raw = raw
        self.opened = self.saved = self.document.data  # as it was read, and as its file is now
        self.id = token_hex(4)  # of what it keeps aside
        self._kept: Edits | None = None
        # edits of an earlier session that were put back, until they are kept as this one's
        self._taken: Edits | None = None
        self._presence: Presence | None = None
        self._company: set[str] = set()  # other sessions on this file, as far as it was looked
        self._unwritten = False  # there is no file yet
        # when the file was changed and how long it is, as far as it was looked at
        self._stamp: tuple[int, int] | None = None

    # --- opening
    @classmethod
    def open(
        cls, path: Path | None, *, memory: Memory | None = None, now: Callable[[], datetime] = datetime.now
    ) -> "Session":
        """Open a design; without a path the last one, or the shipped example.  Edits that were never saved are put
        back, as one step that can be undone.  Raises BadInput with every error of the file."""
        memory = memory or Memory()
        wanted = path
        path = path or memory.last()
        notice = EMPTY
        if path is not None:
            path = path.expanduser()
            if not is_file(path) and (begun := cls._begun(path, memory, now)) is not None:
                return begun
            try:
                session = cls._read(path, memory, now)
            except BadInput:
                if wanted is not None:
                    raise
                notice = Text(
                    "The last design, {path}, can not be opened any more; this is the example.", path=str(path)
                )
                path = None
        if path is None:
            session = cls._read(EXAMPLE, memory, now)
        elif session.path is not None:
            memory.remember(session.path)
        session._put_back()
        session.message = notice or session.message
        return session

    @classmethod
    def _read(cls, path: Path, memory: Memory, now: Callable[[], datetime]) -> "Session":
        return cls(read(path).raw, path, memory=memory, now=now)

    @classmethod
    def begin(
        cls,
        data: Table,
        path: Path,
        *,
        memory: Memory | None = None,
        now: Callable[[], datetime] = datetime.now,
        again: bool = False,
    ) -> "Session":
        """A design that has no file before it is saved.  Raises BadInput where the tables are no design; an engine
        alone may still have to be filled in, and so may what is begun `again`."""
        blank = again or set(data) <= ALONE
        session = cls(fresh_text(data).encode("utf-8"), path, memory=memory, now=now, blank=blank)
        session._unwritten = True
        session.memory.remember(path)
        return session

    @classmethod
    def _begun(cls, path: Path, memory: Memory, now: Callable[[], datetime]) -> "Session | None":
        """A design that was kept, and never saved."""
        for kept in memory.left(path):
            try:
                session = cls.begin(kept.data, path, memory=memory, now=now, again=True)
            except BadInput:
                continue
            session._taken = kept
            if kept.typed:
                session._step(kept.state(), None)
            session.message = Text(
                "{name} was never saved: this is how it was at {when}.", name=path.name, when=session.when(kept)
            )
            return session
        return None

    def when(self, kept: Edits) -> str:
        return kept.time.strftime("%H:%M" if kept.time.date() == self.now().date() else "%d.%m. %H:%M")

    def put_aside(self) -> list[Edits]:
        """Unsaved edits of sessions on this file that have ended, the last first."""
        return [
            kept
            for kept in self.memory.left(self.home)
            if kept.session != self.id and (kept.data != self.saved or kept.typed)
        ]

    def _put_back(self) -> None:
        """Edits that were kept when the program ended before they were saved."""
        kept = next(iter(self.put_aside()), None)
        if kept is None:
            return
        if kept.sha256 != self.document.sha256:
            self.message = Text(
                "Edits of {when} were not saved, but the file has changed since; they are kept: “Put back unsaved "
                "edits” in the palette.",
                when=self.when(kept),
            )
            return
        if self.restore(kept):
            self.message = Text(
                "Edits of {when} that were not saved are back. Undo returns to the file.", when=self.when(kept)
            )

    def restore(self, kept: Edits | None = None) -> bool:
        """Put back edits that were kept, the last or these, as one step of the undo."""
        kept = kept or next(iter(self.put_aside()), None)
        if kept is None or (state := kept.state()) == self._state:
            return False
        try:
            design(replace(self.document, data=kept.data))
        except BadInput:
            return False
        self._taken = kept
        self._step(state, None)
        return True

    # --- beside others
    def attend(self) -> None:
        """Be seen at this file by other sessions."""
        self.leave()
        self._presence = self.memory.attend(self.home, self.id)

    def leave(self) -> None:
        if self._presence is not None:
            self._presence.leave()
        self._presence = None
        self._company = set()

    def joined(self) -> bool:
        """Whether another session is at this file; True once for each."""
        if self._presence is None:
            return False
        before, self._company = self._company, self.memory.present(self.home) - {self.id}
        return bool(self._company - before)

    # --- what is shown
    @property
    def home(self) -> Path:
        """The file of this design: that which is saved to, or the shipped one that it started from."""
        return self.path or self.origin

    @property
    def name(self) -> str:
        """The name of the file."""
        return self.home.name

    @property
    def example(self) -> bool:
        return self.path is None

    @property
    def dirty(self) -> bool:
        return self._unwritten or bool(self._state.texts) or self._state.data != self.saved

    @property
    def read_only(self) -> bool:
        """The file itself, or its folder, can not be written; a first save beside it would fail too."""
        target = Path(os.path.realpath(self.home))
        return self.path is not None and not (
            os.access(target.parent, os.W_OK) and (os.access(target, os.W_OK) or not target.exists())
        )

    @property
    def current(self) -> bool:
        """The results belong to what the fields say."""
        return self.valid and self.solved == self.generation and not self.failure

    @property
    def judged(self) -> bool:
        """The verdicts belong to what the fields say; the results may not yet."""
        generation, results = self._ahead
        return self.current or (self.valid and generation == self.generation and results is not None)

    @property
    def verdicts(self) -> "Results | None":
        """What there is to be shown at once: the results, or the verdicts ahead of them, which have no lines."""
        return self.results if self.current or not self.judged else self._ahead[1]

    def values(self) -> dict[str, Published]:
        """Every value of the results, by its id."""
        if self._values[0] is not self.results:
            self._values = (self.results, self.results.values() if self.results is not None else {})
        return self._values[1]

    # --- the shaft in view
    @property
    def shafts(self) -> list[str]:
        """The names of the shafts, in the order of the file."""
        return [str(item.get(NAME, n + 1)) for n, item in enumerate(content_at(self.data, SHAFTS) or [])]

    @property
    def shaft(self) -> int:
        """Which of them is in view: fields, picture, curves and values are its own, beside what all have together."""
        return max(0, min(self._shaft, len(self.shafts) - 1))

    @shaft.setter
    def shaft(self, place: int) -> None:
        self._shaft = place

    @property
    def original(self) -> str:
        """The name of the shaft in view; of a twin that of its original."""
        return original_of(content_at(self.data, (*SHAFTS, self.shaft)) or {})

    def own(self, step: str) -> str:
        """The name of the shaft of which a step tells: that in view, where it is a twin its original; the bearings of a
        twin that says something of them are its own."""
        name = self.shafts[self.shaft] if self.shafts else ""
        of_shaft = self.results.of_shafts.get(name, {}) if self.results is not None else {}
        return name if step in of_shaft else self.original

    def view(self, step: str) -> "Results | None":
        """The results with that shaft alone."""
        if self.results is None:
            return None
        if self._views[0] is not self.results:
            names = (shaft.name for shaft in self.results.design.shafts)
            self._views = self.results, {name: self.results.view(name) for name in names}
        views = self._views[1]
        return views.get(self.own(step)) or next(iter(views.values()), self.results)

    def ids_of_shaft(self) -> set[str]:
        of_shafts = self.results.of_shafts.values() if self.results is not None else ()
        outcomes = [outcome for steps in of_shafts for outcome in steps.values()]
        values = {value.id for outcome in outcomes for value in outcome.values()}
        return values | {check.id for outcome in outcomes for check in outcome.checks}

    def shaft_of(self, id: str) -> int | None:
        """The place of the shaft that a value or a check is of; None where it is of all of them."""
        name = id.partition(".")[2].partition(".")[0]
        return self.shafts.index(name) if len(self.shafts) > 1 and name in self.shafts else None

    def shaft_of_finding(self, id: str) -> int | None:
        """That of a check; of one of all shafts, which inputs of a single one move, this one."""
        checks = self.results.checks() if self.results is not None else ()
        keys = next((check.moved_by for check in checks if check.id == id), ())
        moved = {self.shaft_of(key) for key in keys}
        return moved.pop() if self.shaft_of(id) is None and len(moved) == 1 else self.shaft_of(id)

    # --- solving
    def job(self) -> Job | None:
        """What is to be solved now; None where the results are up to date, or the input is not valid: then the last
        valid one counts, which is solved if it never was."""
        first = self.results is None and not self.failure
        if self.solved == self.generation or not (self.valid or first):
            return None
        asked = self.generation
        return Job(asked, self.design, self.results, stop=lambda: self.generation != asked)

    def brief_job(self) -> Job | None:
        """What is to be solved ahead of that, for the verdicts alone; None where all of it takes hardly longer."""
        job = self.job()
        if job is None or job.before is None or self.seconds < LONG or self._ahead[0] == self.generation:
            return None
        return replace(job, brief=True)

    def accept(self, answer: Answer) -> bool:
        """Take over what a solve gave; an answer to an older question is dropped."""
        if answer.generation != self.generation or (self.errors and self.results is not None):
            return False
        if answer.brief:  # where it failed, the whole says why
            self._ahead, self.seconds_ahead = (answer.generation, answer.results), answer.seconds
            return True
        if not self.errors:
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
    def draft(self, data: Table | None = None) -> Draft:
        """The design as it would be saved now, or with these tables, to be written out in another thread while the
        editing goes on."""
        now = self._state.data
        results = self.results if self.current and (data is None or data == now) else None
        return Draft(self._raw, self.saved, now if data is None else data, self.home, results)

    def bytes(self, upgrade: bool = False) -> bytes:
        """The design file as it would be saved now.  Raises NeedsUpgrade where its schema has no words for what
        changed; `upgrade`: it is then in that of this program."""
        raw, kept = self.draft().bytes(upgrade)
        if not kept:
            self.message = Text("The comments of the file could not be kept; the old file stays as .bak.")
        return raw

    def save(self, *, force: bool = False, upgrade: bool = False) -> Path:
        """Save; the example under its own name in the current folder, never over another file.  Raises SaveError with
        what to do, NeedsUpgrade as `bytes` does.

        `force` overwrites a file that another program has changed since it was read.
        """
        if self.path is None:
            return self._write(free_name(Path.cwd() / self.origin.name), new=True, upgrade=upgrade)
        return self._write(self.path, force=force, upgrade=upgrade)

    def save_as(self, path: Path, *, upgrade: bool = False) -> Path:
        """Save under another name; the session goes on with that file.  A file that is there is overwritten, and kept
        as .bak."""
        path = path.expanduser()
        if not path.suffix and not path.is_dir():
            path = path.with_suffix(".toml")
        if is_shipped(path):
            raise SaveError(Text("{name} is the shipped example; give another name", name=path.name))
        if path.is_dir():
            raise SaveError(Text("{path} is a folder; give the name of a file in it", path=str(path)))
        return self._write(path.absolute(), upgrade=upgrade)

    def _write(self, path: Path, *, force: bool = True, new: bool = False, upgrade: bool = False) -> Path:
        if not self.valid:
            where, reason = next(iter(self.reasons().items()))
            key = named_key(self.data, where) or Text("the design")
            raise SaveError(Text("not saved: {key}: {reason}", key=key, reason=reason))
        raw, before = self.bytes(upgrade), self.home
        try:
            document = parse(raw, str(path))
        except BadInput as bad:  # nothing is written that can not be read
            raise SaveError(Text("not saved: {key}: {reason}", key=path.name, reason=bad.errors[0].reason)) from None
        write_atomic(path, raw, expected=None if force else self._raw, new=new)
        with self._keeping:
            self._drop()
            self.path, self._raw, self._stamp, self._unwritten = path, raw, None, False
            self.own_name = path.stem
            self.document = document
            self.saved = self._valid = self.document.data
            self.history.state = EditState(self.document.data, {})
            self.autosaved, self.autosave_failure = None, EMPTY
        self.seal()
        self.memory.remember(path)
        if self._presence is not None and path != before:
            self.attend()
        return path

    def remark(self, place: Place) -> str:
        """What the file says beside a key; nothing once its value is another one."""
        key = ".".join(map(str, place))
        return self.document.remarks.get(key, "") if same_content(self.data, self.saved, key) else ""

    def look(self) -> bool:
        """Whether another program has changed the file; True once for each change."""
        if self.path is None:
            return False
        try:
            there = self.path.stat()
            stamp = (there.st_mtime_ns, there.st_size)
            if stamp == self._stamp:
                return False
            self._stamp = stamp
            return read_file(self.path, DESIGN_BYTES) != self._raw
        except OSError:  # it is gone, or just being replaced; a save says what is wrong
            return False

    def reload(self) -> bool:
        """Take the file as it is now, as one step of the undo; False where that changes nothing.  Raises BadInput, and
        then takes nothing.

        The edits stay behind the undo; saving them then overwrites what the other program wrote, with its comments
        kept."""
        path = self.path
        if path is None:
            raise BadInput(
                self.name, [InputError(0, "", "", Text("is the shipped example, which has no file of its own yet"))]
            )
        document = read(path)
        design(document)
        if document.raw == self._raw and not self.dirty:
            return False
        self._raw, self.saved = document.raw, document.data
        self.document = replace(document, data=self._state.data)
        self.seal()
        self._step(EditState(document.data, {}), None)
        self.seal()
        return True

    def autosave(self) -> None:
        """Keep aside the last valid state and the entries that are not accepted; a failure is remembered."""
        with self._keeping:
            state = self._state
            data = state.data if self.blank else with_said(self._valid, state.data)
            typed = not_accepted(data, state)
            if data == self.saved and not typed and not self._unwritten:
                # those of an earlier session, all of them taken back
                if self._kept is not None or self._taken is not None:
                    self._drop()
                    self.autosaved = None
                return
            edits = Edits(data, self.now(), self.document.sha256, typed, self.id)
            if (
                self._kept is not None
                and (data, typed) == (self._kept.data, self._kept.typed)
                and self.memory.keeps(self.home, self._kept)
            ):
                return
            try:
                self.memory.keep(self.home, edits)
            except SaveError as error:
                self.autosave_failure = error.text
                return
            self._drop_taken()
            self._kept, self.autosaved, self.autosave_failure = edits, edits.time, EMPTY

    def _drop(self) -> None:
        """Nothing is left to be kept: it stands in the file, or was taken back."""
        self._drop_taken()
        if self._kept is not None:
            self.memory.drop(self.home, self.id)
            self._kept = None

    def _drop_taken(self) -> None:
        """What was put back is this session's now; what its own has added since, if it still goes on, stays."""
        if self._taken is not None and self._taken in self.memory.kept(self.home):
            self.memory.drop(self.home, self._taken.session)
        self._taken = None

    @property
    def safe(self) -> bool:
        """Nothing is lost if the program ends now."""
        kept = self._kept is not None and self._kept.state() == self._state and self.memory.keeps(self.home, self._kept)
        return not self.dirty or (kept and not self.autosave_failure)
