# SPDX-License-Identifier: Apache-2.0
"""What the program remembers between two runs, and which other sessions are at a design now.

Remembered are the last designs, edits that were not saved, and the user's settings."""

import contextlib
import hashlib
import os
from dataclasses import dataclass, field
from datetime import datetime
from pathlib import Path
from secrets import token_hex
from typing import Any

from calc.design.addresses import Table, address, changed
from calc.design.disk import lock, read_file
from calc.design.labels import Place
from calc.design.limits import DESIGN_BYTES
from calc.design.toml_file import Document, current_document, read_as_it_is
from calc.sheet.errors import BadInput
from calc.sheet.text import Text

from ..output import state_dir
from . import numbers
from .places import described
from .saving import SaveError, differences, edited_text, fresh_text, write_atomic
from .undo import EditState

# --- which sessions are at a design now
# Each holds a locked file of its own in the state folder, and the lock ends with its process.

PRESENCE_FOLDER = "open"


def design_key(path: Path) -> str:
    """What the files of the state folder call a design."""
    return hashlib.sha256(str(path.absolute()).encode("utf-8", "surrogateescape")).hexdigest()[:16]


class Presence:
    """A session at a design, until it leaves.  Where the system has no locks, or the folder can not be written, nobody
    sees it."""

    def __init__(self, state: Path, path: Path, session: str) -> None:
        self._file = state / PRESENCE_FOLDER / f"{design_key(path)}-{session}"
        self._handle: int | None = None
        with contextlib.suppress(OSError):
            self._file.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
            draft = self._file.with_name(f".{token_hex(8)}")
            self._handle = os.open(draft, os.O_RDWR | os.O_CREAT | os.O_EXCL, 0o600)
            lock(self._handle)  # before anybody can see it and take it for one that was left behind
            os.replace(draft, self._file)

    def leave(self) -> None:
        if self._handle is not None:
            with contextlib.suppress(OSError):
                self._file.unlink(missing_ok=True)
            os.close(self._handle)
            self._handle = None


def present(state: Path, path: Path) -> set[str]:
    """The sessions that are at a design.  What those that were killed have left is taken away."""
    sessions = set[str]()
    try:
        files = list((state / PRESENCE_FOLDER).glob(f"{design_key(path)}-*"))
    except OSError:
        return sessions
    for file in files:
        with contextlib.suppress(OSError):
            handle = os.open(file, os.O_RDWR)
            try:
                if lock(handle):
                    file.unlink(missing_ok=True)
            except BlockingIOError:
                sessions.add(file.name.partition("-")[2])
            finally:
                os.close(handle)
    return sessions


# --- what is remembered

RECENT = 10  # designs that are offered to be opened again
KEPT = 8  # sessions on one file whose unsaved edits are kept; older ones go


@dataclass(frozen=True)
class Edits:
    """A design with edits that were never saved: its tables, when they were kept, and the hash of the file that they
    started from.

    `typed`: entries that are not accepted, and so no part of the tables, as they stand in their fields.  `session`: who
    made them; two sessions on one file keep what is theirs."""

    data: Table
    time: datetime
    sha256: str
    typed: dict[Place, str] = field(default_factory=dict)
    session: str = ""

    def state(self) -> EditState:
        """The state that they make; an entry that has no field any more is left out."""
        data, texts = self.data, {}
        for where, text in self.typed.items():
            try:
                about = described(where)
                if about.table is None:
                    data = changed(data, where, numbers.value(text, about))
            except numbers.NotUnderstood as no:
                texts[where] = (text, no.reason)
            except (KeyError, TypeError, AttributeError, ValueError):
                continue
        return EditState(data, texts)


SAID = ("locked", "accepted")  # of inputs and findings, which no field has


def with_said(valid: Table, data: Table) -> Table:
    """A valid design with what these tables, which may be none, say of its inputs and findings."""
    if all(valid.get(key) == data.get(key) for key in SAID):
        return valid
    return {key: value for key, value in valid.items() if key not in SAID} | {
        key: data[key] for key in SAID if key in data
    }


def not_accepted(valid: Table, state: EditState) -> dict[Place, str]:
    """The entries by which a state differs from the last valid design, as texts of their fields."""
    texts: dict[Place, str] = {}

    def leaves(where: Place, content: Any) -> None:
        if isinstance(content, dict):
            for key, inner in content.items():
                leaves((*where, key), inner)
        elif not (isinstance(content, list) and any(isinstance(item, dict) for item in content)):
            texts[where] = numbers.written(content, described(where))

    if state.data is not valid:
        for where, content in differences(valid, state.data):
            if where[0] not in SAID:
                leaves(where, content)
    return texts | {where: text for where, (text, _) in state.texts.items()}


@dataclass(frozen=True)
class Settings:
    """What the user has chosen.  `theme`: the name of one of textual's; empty: its own choice.  `guide`: the forms say
    what to decide."""

    language: str = "en"
    theme: str = ""
    guide: bool = False


class Memory:
    """The state folder.  A folder that can not be read is an empty one; one that can not be written says so by
    SaveError."""

    def __init__(self, folder: Path | None = None) -> None:
        self.folder = folder or state_dir()

    # --- the last designs
    def _opened(self) -> list[Path]:
        """What was open, the last first: a path in each line of the file `last`."""
        try:
            lines = read_file(self.folder / "last", DESIGN_BYTES).decode("utf-8").splitlines()
        except (OSError, ValueError):
            return []
        return [path for line in lines if (path := Path(line.strip())).is_absolute()]

    def last(self) -> Path | None:
        """The design that was open last, if it is still there."""
        return next((path for path in self._opened()[:1] if self.there(path)), None)

    def recent(self) -> list[Path]:
        """The designs that were open last and are still there, the last first."""
        return [path for path in self._opened() if self.there(path)][:RECENT]

    def there(self, path: Path) -> bool:
        """A design that was never saved has no file, but edits that are kept."""
        return is_file(path) or bool(self._files(path))

    def remember(self, path: Path) -> None:
        """Nothing depends on this being kept."""
        path = path.absolute()
        paths = [path, *(other for other in self._opened() if other != path)]
        with contextlib.suppress(SaveError, OSError, ValueError):  # a name that is no text in UTF-8 is not remembered
            # some may be back later: a drive
            self._write(self.folder / "last", "\n".join(map(str, paths[: 3 * RECENT])))

    # --- unsaved edits
    def _file(self, path: Path, session: str) -> Path:
        name = design_key(path)
        return self.folder / "unsaved" / (f"{name}-{session}.toml" if session else f"{name}.toml")

    def _files(self, path: Path) -> list[Path]:
        """Of all sessions on a design, the last first."""
        base = self._file(path, "")
        try:
            return sorted(
                base.parent.glob(f"{base.stem}*.toml"), key=lambda file: file.stat().st_mtime_ns, reverse=True
            )
        except OSError:  # one has just been taken away
            return []

    def keep(self, path: Path, edits: Edits) -> None:
        """Put the edits of a session on a design aside.  Raises SaveError."""
        head = {
            "path": str(path.absolute()),
            "sha256": edits.sha256,
            "time": edits.time.isoformat(timespec="seconds"),
            "session": edits.session,
        }
        typed = [{"place": list(where), "text": text} for where, text in edits.typed.items()]
        self._write(
            self._file(path, edits.session), fresh_text({"unsaved": head, "typed": typed, "design": edits.data})
        )
        held = {self._file(path, session) for session in self.present(path)}
        for old in [file for file in self._files(path) if file not in held][KEPT:]:
            with contextlib.suppress(OSError):
                old.unlink()

    def kept(self, path: Path) -> list[Edits]:
        """The edits that were put aside for a design, the last first; a file that is damaged counts as none."""
        return [edits for file in self._files(path) if (edits := _read(file)) is not None]

    def left(self, path: Path) -> list[Edits]:
        """Those whose sessions have ended: the edits of one that lives are its own."""
        living = self.present(path)
        return [edits for edits in self.kept(path) if edits.session not in living]

    def keeps(self, path: Path, edits: Edits) -> bool:
        """Whether these edits stand on the disk."""
        stored = _read(self._file(path, edits.session))
        return stored is not None and (stored.data, stored.typed, stored.sha256) == (
            edits.data,
            edits.typed,
            edits.sha256,
        )

    def drop(self, path: Path, session: str) -> None:
        with contextlib.suppress(OSError):
            self._file(path, session).unlink(missing_ok=True)

    # --- sessions
    def attend(self, path: Path, session: str) -> Presence:
        """A session is at a design from here on."""
        return Presence(self.folder, path, session)

    def present(self, path: Path) -> set[str]:
        """The sessions that are at a design."""
        return present(self.folder, path)

    # --- settings
    def keys(self) -> dict[str, str]:
        """The user's own keys: `keys.toml` in this folder, the id of an action = its keys (`save = "ctrl+w,f12"`)."""
        table = _table(self.folder / "keys.toml") or {}
        return {str(id): keys for id, keys in table.items() if isinstance(keys, str)}

    def settings(self) -> Settings:
        """`settings.toml` in this folder; what is not understood in it is left at its own choice."""
        table, defaults = self._settings(), Settings()
        language, theme, guide = (table.get(name) for name in ("language", "theme", "guide"))
        return Settings(
            language if isinstance(language, str) else defaults.language,
            theme if isinstance(theme, str) else defaults.theme,
            guide if isinstance(guide, bool) else defaults.guide,
        )

    def set_setting(self, name: str, value: str | bool) -> None:
        """Keep a choice; comments stay.  Nothing depends on this being kept."""
        if self._settings().get(name) == value:
            return
        file = self.folder / "settings.toml"
        with contextlib.suppress(SaveError, OSError):
            try:
                text = edited_text(read_as_it_is(file).raw.decode("utf-8"), {name: value})
            except (BadInput, ValueError, SaveError):  # there is none, or it is damaged
                text = fresh_text({**self._settings(), name: value})
            self._write(file, text)

    def _settings(self) -> Table:
        return _table(self.folder / "settings.toml") or {}

    def _write(self, file: Path, text: str) -> None:
        try:
            file.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
        except OSError as error:
            raise SaveError(
                Text("{folder} can not be made: {reason}", folder=str(file.parent), reason=error.strerror or str(error))
            ) from None
        write_atomic(file, text.encode("utf-8"), backup=False)


def _table(file: Path) -> dict[str, Any] | None:  # Any: it may be damaged
    """What a file of the folder says, read as carefully as a design; None: it is not there, or damaged."""
    try:
        return read_as_it_is(file).data
    except BadInput:
        return None


def _read(file: Path) -> Edits | None:
    if (table := _table(file)) is None:
        return None
    try:
        head, kept = table["unsaved"], current_document(Document(table["design"]))
        typed = {tuple(entry["place"]): str(entry["text"]) for entry in table.get("typed", [])}
        if kept.former is not None:  # by version 0.1
            typed = {_today(kept.data, where): text for where, text in typed.items()}
        return Edits(
            kept.data,
            datetime.fromisoformat(head["time"]),
            str(head["sha256"]),
            typed,
            str(head.get("session", "")),
        )
    except (BadInput, ValueError, KeyError, TypeError, AttributeError):  # or of a later program
        return None


def _today(data: Table, where: Place) -> Place:
    """Where an input stands now that stood at a place of schema 1."""
    try:
        return address(data, ".".join(map(str, where)))
    except BadInput:
        return where


def is_file(path: Path) -> bool:
    try:
        return path.is_file()
    except (OSError, ValueError):  # a name that the system does not know
        return False
