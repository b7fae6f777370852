# SPDX-License-Identifier: Apache-2.0
"""What the program remembers between two runs: the last design, and edits that were not saved."""

import contextlib
import hashlib
import os
import tomllib
from dataclasses import dataclass, field
from datetime import datetime
from pathlib import Path
from typing import Any

from calc.design_file import Table, changed

from . import numbers
from .history import State
from .places import Place, described
from .saving import SaveError, differences, fresh_text, write_atomic

FOLDER = "contralbero"


def state_dir() -> Path:
    """The user's folder for the state of programs, and ours in it; nothing is made before something is written."""
    if given := os.environ.get("XDG_STATE_HOME"):
        base = Path(given)
    elif os.name == "nt":
        base = Path(os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local")
    else:
        base = Path.home() / ".local" / "state"
    return base / FOLDER


@dataclass(frozen=True)
class Edits:
    """A design with edits that were never saved: its tables, when they were kept, and the hash of the file that they started from.

    `typed`: entries that are not accepted, and so no part of the tables, as they stand in their fields.
    """

    data: Table
    time: datetime
    sha256: str
    typed: dict[Place, str] = field(default_factory=dict)

    def state(self) -> State:
        """The state that they make; an entry that has no field any more is left out."""
        data, texts = self.data, {}
        for where, text in self.typed.items():
            try:
                about = described(where)
                if about.table is None:
                    data = changed(data, where, numbers.value(text, about))
            except numbers.NotUnderstood as no:
                texts[where] = (text, str(no))
            except (KeyError, TypeError, AttributeError, ValueError):
                continue
        return State(data, texts)


def not_accepted(valid: Table, state: State) -> dict[Place, str]:
    """The entries by which a state differs from the last valid design, as texts of their fields."""
    found: dict[Place, str] = {}

    def leaves(where: Place, content: Any) -> None:
        if isinstance(content, dict):
            for key, inner in content.items():
                leaves((*where, key), inner)
        elif not (isinstance(content, list) and any(isinstance(item, dict) for item in content)):
            found[where] = numbers.written(content, described(where))

    if state.data is not valid:
        for where, content in differences(valid, state.data):
            leaves(where, content)
    return found | {where: text for where, (text, _) in state.texts.items()}


class Memory:
    """The state folder.  A folder that can not be read is an empty one; one that can not be written says so by SaveError."""

    def __init__(self, folder: Path | None = None) -> None:
        self.folder = folder or state_dir()

    # --- the last design
    def last(self) -> Path | None:
        """The design that was open last, if it is still there."""
        try:
            path = Path((self.folder / "last").read_text(encoding="utf-8").strip())
            return path if path.is_absolute() and path.is_file() else None
        except (OSError, ValueError):
            return None

    def remember(self, path: Path) -> None:
        """Nothing depends on this being kept."""
        with contextlib.suppress(SaveError, OSError):
            self._write(self.folder / "last", str(path.absolute()))

    # --- unsaved edits
    def _file(self, path: Path) -> Path:
        name = hashlib.sha256(str(path.absolute()).encode()).hexdigest()[:16]
        return self.folder / "unsaved" / f"{name}.toml"

    def keep(self, path: Path, edits: Edits) -> None:
        """Put the edits of a design aside.  Raises SaveError."""
        head = {"path": str(path.absolute()), "sha256": edits.sha256, "time": edits.time.isoformat(timespec="seconds")}
        typed = [{"place": list(where), "text": text} for where, text in edits.typed.items()]
        self._write(self._file(path), fresh_text({"unsaved": head, "typed": typed, "design": edits.data}))

    def kept(self, path: Path) -> Edits | None:
        """The edits that were put aside for a design; a file that is damaged counts as none."""
        try:
            found = tomllib.loads(self._file(path).read_text(encoding="utf-8"))
            head = found["unsaved"]
            typed = {tuple(entry["place"]): str(entry["text"]) for entry in found.get("typed", [])}
            return Edits(found["design"], datetime.fromisoformat(head["time"]), str(head["sha256"]), typed)
        except (OSError, ValueError, KeyError, TypeError, AttributeError):
            return None

    def drop(self, path: Path) -> None:
        with contextlib.suppress(OSError):
            self._file(path).unlink(missing_ok=True)

    # --- settings
    def keys(self) -> dict[str, str]:
        """The user's own keys: `keys.toml` in this folder, the id of an action = its keys (`save = "ctrl+w,f12"`)."""
        try:
            found = tomllib.loads((self.folder / "keys.toml").read_text(encoding="utf-8"))
        except (OSError, ValueError):
            return {}
        return {str(id): keys for id, keys in found.items() if isinstance(keys, str)}

    def _write(self, file: Path, text: str) -> None:
        try:
            file.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
        except OSError as error:
            raise SaveError(f"{file.parent} can not be made: {error.strerror or error}") from None
        write_atomic(file, text.encode("utf-8"), backup=False)
