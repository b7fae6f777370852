# SPDX-License-Identifier: Apache-2.0
"""What a design can be compared with: its saved file, the design as it was opened, the states before each edit, another file."""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path

from calc.compare import InputDifference, inputs
from calc.compare_tables import input_texts, named
from calc.design import Design
from calc.design_file import Table, design, load

from .session import Session

LONGEST = 24  # characters of a value that is named in a list
MOST = 3  # inputs of one edit that are named


@dataclass(frozen=True)
class Other:
    """`name` stands above its column, `title` in a list of choices."""

    name: str
    title: str
    data: Table = field(repr=False)


@dataclass(frozen=True)
class Chosen:
    """Another design that is valid, to be solved."""

    name: str
    title: str
    data: Table = field(repr=False)
    design: Design = field(repr=False)


def kept(session: Session) -> Iterator[Other]:
    """The design as its file has it; and as it was opened, where it has been saved since."""
    yield Other("saved", f"{session.name} as it is saved", session.saved)
    if session.opened != session.saved:
        yield Other("opened", f"{session.name} as it was opened", session.opened)


def past(session: Session) -> Iterator[Other]:
    """The states before each edit that can be taken back, the last first."""
    for n, (before, after) in enumerate(session.history.past(), 1):
        yield Other("1 edit ago" if n == 1 else f"{n} edits ago", f"before {edit_text(before, after)}", before)


def edit_text(before: Table, after: Table) -> str:
    """What an edit changed, from what to what; empty where it changed nothing."""
    found = inputs(before, after)
    more = f"; {len(found) - MOST} more" if len(found) > MOST else ""
    return "; ".join(map(_input_text, found[:MOST])) + more


def _input_text(one: InputDifference) -> str:
    old, new = (text if len(text) <= LONGEST else text[: LONGEST - 1] + "…" for text in input_texts(one))
    return f"{named(one.key, one.label, step=True)}: {old} → {new} {one.unit}".rstrip()


def of_session(session: Session, other: Other) -> Chosen:
    """A state of this design, checked.  Raises BadInput."""
    return Chosen(other.name, other.title, other.data, design(replace(session.document, data=other.data, lines={})))


def of_file(path: Path) -> Chosen:
    """Another design file, checked.  Raises BadInput with every error of the file."""
    document, made = load(path)
    return Chosen(path.stem, str(path), document.data, made)
