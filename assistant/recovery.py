# SPDX-License-Identifier: Apache-2.0
"""What the program remembers between two runs: the last design, and edits that were not saved."""

import contextlib
import hashlib
import os
import tomllib
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

from calc.design_file import Table

from .saving import SaveError, fresh_text, write_atomic

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
    """A design with edits that were never saved: its tables, when they were kept, and the hash of the file that they started from."""

    data: Table
    time: datetime
    sha256: str


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
        self._write(self._file(path), fresh_text({"unsaved": head, "design": edits.data}))

    def kept(self, path: Path) -> Edits | None:
        """The edits that were put aside for a design; a file that is damaged counts as none."""
        try:
            found = tomllib.loads(self._file(path).read_text(encoding="utf-8"))
            return Edits(found["design"], datetime.fromisoformat(found["unsaved"]["time"]), str(found["unsaved"]["sha256"]))
        except (OSError, ValueError, KeyError, TypeError):
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
