# SPDX-License-Identifier: Apache-2.0
"""Putting a design on disk: the keys that changed are edited in place, and the file is whole at every moment."""

import contextlib
import os
import re
import tomllib
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from calc.design.addresses import Table
from calc.design.disk import FileChanged, demand_writable, same_file, write_file
from calc.design.labels import Place
from calc.design.toml_file import Document, design, parse
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import Text

from .solving import Job, run

if TYPE_CHECKING:
    from calc.solve import Results


class SaveError(OSError):
    """The design can not be put where it was asked for; `text` says why, and what to do."""

    def __init__(self, text: Text) -> None:
        self.text = text
        super().__init__(text)


ORIGIN = re.compile(  # how a comment begins that says where a value comes from
    r"(?:assumed|estimated|guessed|typical|measured|fitted|copied|read|taken|from|finite-element"
    r"|as (?:printed|stated|given|drawn|measured))\b",
    re.IGNORECASE,
)
REASONS = ("accepted", "without", "locked")  # tables of reasons by ids, which have dots of their own


class NeedsUpgrade(SaveError):
    """A file of schema 1 can not say what was changed."""


UPGRADE = Text(
    "schema 1, in which the file is written, has no words for this change: `contralbero upgrade FILE` first, which "
    "keeps its comments"
)


class ChangedOnDisk(SaveError):
    """The file was changed by another program since it was read."""


# --- text


def edited_text(text: str, changes: Mapping[str, Any] | Iterable[tuple[Place, Any]]) -> str:
    """The TOML text with some keys changed: comments, order and spacing stay.  None takes a key out; a new key ends its
    table.

    A comment that begins with where a value comes from says of another what it was: `# assumed: usual` → `# was 80.0,
    assumed: usual`. A key is dotted, elements of arrays by name, else by index (`gears.wheels.shaft.teeth`), or a tuple
    of names and indices."""
    import tomlkit

    mark = "\ufeff" if text.startswith("\ufeff") else ""
    crlf = text.count("\r\n") > 0 and text.count("\r\n") == text.count("\n")
    body = text.removeprefix(mark)
    wanted = tomllib.loads(body)
    document = tomlkit.parse(body.replace("\r\n", "\n") if crlf else body)
    for key, value in changes.items() if isinstance(changes, Mapping) else changes:
        place = _place(wanted, key) if isinstance(key, str) else key
        _set(document, place, value, kept=True)
        _set(wanted, place, value)
    edited = tomlkit.dumps(document)
    if tomllib.loads(edited) != wanted:
        raise SaveError(
            Text(
                "the text of the design file can not be edited in place; save it under another name, or simplify its "
                "notation"
            )
        )
    return mark + (edited.replace("\n", "\r\n") if crlf else edited)


def saved_text(raw: bytes, data: Table) -> str:
    """The text of a design file once its tables are these, in the schema that the file has.  Raises SaveError where it
    can not be edited in place, NeedsUpgrade where its schema has no words for what changed."""
    document, text = parse(raw, ""), raw.decode("utf-8")
    if document.former is None:
        return edited_text(text, differences(document.data, data))
    from calc.design.downgrade import downgraded

    old, new = downgraded(document.data), downgraded(data)
    if old is None or new is None:
        raise NeedsUpgrade(UPGRADE)
    made = edited_text(text, differences(old, new))
    if parse(made.encode("utf-8"), "").data != data:  # one key of the file says what are several now: a lock of a list
        raise NeedsUpgrade(UPGRADE)
    return made


def upgraded_bytes(raw: bytes) -> tuple[bytes, bool]:
    """A design file in the schema of this program, and whether it kept its comments."""
    from calc.design.upgrade_text import upgraded_text

    made = upgraded_text(raw.decode("utf-8"))
    return made.text.encode("utf-8"), made.kept


def fresh_text(data: Table) -> str:
    """The text of a design file that has no hand-written form yet."""
    import tomli_w

    return tomli_w.dumps(data)


def _place(data: Any, key: str) -> Place:
    """A dotted key by names and indices; parts that are not there yet are taken as they are."""
    table, _, id = key.partition(".")
    if id and table in REASONS:
        return table, id
    place: list[str | int] = []
    here = data
    for part in key.split("."):
        if isinstance(here, list):
            index = next(
                (n for n, item in enumerate(here) if isinstance(item, dict) and item.get("name") == part), None
            )
            if index is None and part.isdigit() and int(part) <= len(here):
                index = int(part)
            if index is None:
                raise SaveError(Text('{key}: there is no element "{part}"', key=key, part=part))
            place.append(index)
            here = here[index] if index < len(here) else {}
        else:
            # no key is a number: an array that is not there yet
            place.append(int(part) if part.isdigit() and here == {} else part)
            here = here.get(part, {}) if isinstance(here, dict) else {}
    return tuple(place)


def _set(here: Any, place: Place, value: Any, kept: bool = False) -> None:
    """Change one key of nested tables, of plain ones or (`kept`) of tomlkit's; tables on the way are made where they
    are missing."""
    part: Any
    outer: Any = None
    last: Any = place[-1]
    for i, part in enumerate(place[:-1]):
        if isinstance(here, list) and part == len(here):
            here.append(_new_table(kept))
        elif not isinstance(here, list) and part not in here:
            if value is None:
                return
            here[part] = _new_array(kept) if isinstance(place[i + 1], int) else _new_table(kept)
        outer, here = here, here[part]
    if value is None:
        if isinstance(here, list):
            if isinstance(last, int) and last < len(here):
                del here[last]
        else:
            here.pop(last, None)
            if kept and not here and outer is not None:
                outer[part] = _new_table(kept)  # an emptied table has no header of its own any more
    elif isinstance(here, list) and last == len(here):
        here.append(value)
    elif kept:
        old = here[last] if isinstance(here, list) or last in here else None
        here[last] = _in_the_style_of(old, value)
        if comment := _said_of(old, here[last]):
            here[last].trivia.comment = f"# {comment}"
    else:
        here[last] = value


def _said_of(old: Any, new: Any) -> str:
    """What the comment of a value becomes beside another: where the old one came from does not hold of it, until it is
    back."""
    comment = getattr(getattr(old, "trivia", None), "comment", "").lstrip("# \t")
    if comment.startswith("was "):
        return comment.removeprefix(f"was {new.as_string()}, ")
    return f"was {was}, {comment}" if ORIGIN.match(comment) and "\n" not in (was := old.as_string()) else ""


def _new_table(kept: bool) -> Any:
    if not kept:
        return {}
    import tomlkit

    return tomlkit.table()


def _new_array(kept: bool) -> Any:
    if not kept:
        return []
    import tomlkit

    return tomlkit.aot()


def _in_the_style_of(old: Any, new: Any) -> Any:
    """A whole number stays one where it was written so (55 and not 55.0); a table keeps the notation that tomlkit gives
    it."""
    if (
        isinstance(new, float)
        and new.is_integer()
        and abs(new) < 1e15
        and isinstance(old, int)
        and not isinstance(old, bool)
    ):
        return int(new)
    if isinstance(new, list) and isinstance(old, list) and all(isinstance(x, (int, float)) for x in new):
        return [_in_the_style_of(old[min(i, len(old) - 1)] if old else None, x) for i, x in enumerate(new)]
    return new


def differences(old: Any, new: Any, place: Place = ()) -> list[tuple[Place, Any]]:
    """The changes that lead from one set of tables to the other, in an order in which they can be made.

    An array of tables that lost elements is cut from its end, so that the places of the others hold.
    """
    if isinstance(old, dict) and isinstance(new, dict):
        changes = [((*place, key), None) for key in old if key not in new]
        for key, value in new.items():
            changes += differences(old[key], value, (*place, key)) if key in old else [((*place, key), value)]
        return changes
    if _tables(old) and _tables(new):
        changes = []
        for i, (a, b) in enumerate(zip(old, new)):
            changes += differences(a, b, (*place, i))
        changes += [((*place, i), None) for i in range(len(old) - 1, len(new) - 1, -1)]
        return changes + [((*place, i), new[i]) for i in range(len(old), len(new))]
    return [] if old == new else [(place, new)]


def _tables(value: Any) -> bool:
    return isinstance(value, list) and bool(value) and all(isinstance(item, dict) for item in value)


# --- bytes


def spare(target: Path, *inputs: str | Path) -> None:
    """Raises BadInput where a command was asked to write over what it reads, or where nothing can be written, before it
    does any work."""
    if any(same_file(target, source) for source in inputs):
        raise BadInput(
            str(target), [InputError(0, "", "", Text("is an input of this very command; give another name with -o"))]
        )
    with asked_for(target):
        demand_writable(target)


def make_folder(folder: Path, option: str) -> None:
    """The folder that a command was asked to write to.  Raises BadInput."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except (OSError, ValueError) as error:
        why = getattr(error, "strerror", None) or str(error)
        reason = Text("is no folder to write to: {reason}", reason=why)
        if os.path.isfile(folder):
            reason = Text("is a file; give the name of a folder")
        raise BadInput(str(folder), [InputError(0, option, "", reason)]) from None


def write_asked(
    path: Path,
    content: str | bytes,
    backup: bool = False,
    inputs: Iterable[str | Path] = (),
    expected: bytes | None = None,
    new: bool = False,
) -> None:
    """Write a file that a command was asked for.  Raises BadInput with the reason where it can not be written.
    `backup`: for designs alone, which a user wrote; what is generated can be generated again."""
    data = content.encode("utf-8") if isinstance(content, str) else content
    with asked_for(path):
        write_file(path, data, backup=backup, inputs=inputs, expected=expected, new=new)


@contextlib.contextmanager
def asked_for(path: Path) -> Iterator[None]:
    """What stops the writing of a file that a command was asked for, as bad input."""
    try:
        yield
    except OSError as error:
        reason = Text("cannot be written: {reason}", reason=error.strerror or str(error))
        raise BadInput(str(path), [InputError(0, "", "", reason)]) from None


def write_atomic(
    path: Path,
    data: bytes,
    backup: bool = True,
    inputs: Iterable[Path] = (),
    expected: bytes | None = None,
    new: bool = False,
) -> None:
    """Write a file of the session.  Raises SaveError with what to do, ChangedOnDisk where it has not the `expected`
    bytes any more."""
    try:
        write_file(path, data, backup=backup, inputs=inputs, expected=expected, new=new)
    except FileChanged:
        raise ChangedOnDisk(
            Text(
                "{name} was changed by another program; save once more to overwrite it (the other version is kept as "
                ".bak)",
                name=path.name,
            )
        ) from None
    except OSError as error:
        place = os.path.realpath(path)
        raise SaveError(
            Text(
                "{path} can not be written: {reason}; save under another name (nothing was changed)",
                path=str(place),
                reason=error.strerror or str(error),
            )
        ) from None


def free_name(path: Path) -> Path:
    """The path, or the first with a number behind its name that does not exist yet."""
    free, n = path, 1
    while free.exists():
        n += 1
        free = path.with_name(f"{path.stem}-{n}{path.suffix}")
    return free


# --- a design as it stands at one moment of its editing
# It is written out while the editing goes on.


@dataclass(frozen=True)
class Draft:
    """`raw` and `saved`: the file as it is, and its tables; `data`: the tables as they are now.  `results`: where they
    are known."""

    raw: bytes = field(repr=False)
    saved: Table = field(repr=False)
    data: Table = field(repr=False)
    home: Path
    results: "Results | None" = field(repr=False)

    def bytes(self, upgrade: bool = True) -> tuple[bytes, bool]:
        """The file as it would be saved, and whether it kept its comments.  Where its schema has no words for what
        changed it is in that of this program, or (not `upgrade`) NeedsUpgrade is raised."""
        if self.saved == self.data:
            return self.raw, True
        try:
            try:
                return saved_text(self.raw, self.data).encode("utf-8"), True
            except NeedsUpgrade:
                if not upgrade:
                    raise
                raw, kept = upgraded_bytes(self.raw)
                return saved_text(raw, self.data).encode("utf-8"), kept
        except NeedsUpgrade:
            raise
        except SaveError:  # a notation that can not be edited in place
            return fresh_text(self.data).encode("utf-8"), False

    def solved(self) -> "tuple[Document, Results]":
        """The document and its results, solved here where they are not known.  Raises RuntimeError with the program's
        mistake."""
        document = parse(self.bytes()[0], str(self.home))
        if self.results is not None:
            return document, self.results
        answer = run(Job(0, design(document), None))
        if answer.results is None:
            raise RuntimeError(answer.failure)
        return document, answer.results
