# SPDX-License-Identifier: Apache-2.0
"""What a design can be compared with: its saved file, the design as it was opened, the states before each edit, another
file."""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path

from calc.design.addresses import Table
from calc.design.model import Design
from calc.design.toml_file import design, load
from calc.sheet.text import SEMICOLON, Name, Text, plural
from calc.studies.compare import InputDifference, inputs
from calc.studies.compare_tables import input_texts, named

from .session import Session

LONGEST = 24  # characters of a value that is named in a list
MOST = 3  # inputs of one edit that are named


@dataclass(frozen=True)
class Other:
    """`name` stands above its column, `title` in a list of choices."""

    name: Text
    title: Text
    data: Table = field(repr=False)


@dataclass(frozen=True)
class Chosen:
    """Another design that is valid, to be solved."""

    name: Text
    title: Text
    data: Table = field(repr=False)
    design: Design = field(repr=False)


def kept(session: Session) -> Iterator[Other]:
    """The design as its file has it; and as it was opened, where it has been saved since."""
    yield Other(Text("saved"), Text("{name} as it is saved", name=session.name), session.saved)
    if session.opened != session.saved:
        yield Other(Text("opened"), Text("{name} as it was opened", name=session.name), session.opened)


def past(session: Session) -> Iterator[Other]:
    """The states before each edit that can be taken back, the last first."""
    for n, (before, after) in enumerate(session.history.past(), 1):
        yield Other(
            plural("{n} edit ago", "{n} edits ago", n=n),
            Text("before {edit}", edit=edit_text(before, after)),
            before,
        )


def edit_text(before: Table, after: Table) -> Text:
    """What an edit changed, from what to what; empty where it changed nothing."""
    changed = inputs(before, after)
    texts = [_input_text(difference) for difference in changed[:MOST]]
    if len(changed) > MOST:
        texts.append(Text("{count} more", count=len(changed) - MOST))
    return SEMICOLON.join(texts)


def _input_text(difference: InputDifference) -> Text:
    label = named(difference.key, difference.label, step=True)
    return Text("{label}: {change}", label=label, change=from_to(difference))


def from_to(difference: InputDifference) -> Text:
    """`94 → 95 mm`; the unit stands behind numbers alone: `0.8 mrad → left out`."""
    old, new = (text if len(text) <= LONGEST else text[: LONGEST - 1] + "…" for text in input_texts(difference))
    unit = difference.unit
    if not unit or difference.b is not None:
        return (
            Text("{old} → {new} {unit}", old=old, new=new, unit=unit)
            if unit
            else Text("{old} → {new}", old=old, new=new)
        )
    return Text("{old} {unit} → {new}", old=old, new=new, unit=unit)


def of_session(session: Session, other: Other) -> Chosen:
    """A state of this design, checked.  Raises BadInput."""
    return Chosen(other.name, other.title, other.data, design(replace(session.document, data=other.data, lines={})))


def of_file(path: Path) -> Chosen:
    """Another design file, checked.  Raises BadInput with every error of the file."""
    document, loaded = load(path)
    return Chosen(Name(path.stem), Name(str(path)), document.data, loaded)
