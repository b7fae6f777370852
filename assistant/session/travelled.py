# SPDX-License-Identifier: Apache-2.0
"""What an undo, or a redo, has changed: in words, step by step, and where the first of it stands."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import groupby

from calc.design.addresses import Table, address, step_at
from calc.design.labels import Place, label_of
from calc.design.locks import locks
from calc.design.model import STEPS, Design
from calc.sheet.errors import BadInput
from calc.sheet.quantity import dotted
from calc.sheet.text import COMMA, EMPTY, SEMICOLON, Name, Text
from calc.studies.compare import InputDifference, inputs

from .compare_with import from_to
from .guide import DOCUMENT, NAME, NOTE, title_of
from .undo import EditState

ACCEPTED, LOCKED, WITHOUT = map(dotted, (Design.accepted, Design.locked, Design.without))
ORDER = [step.key for step in STEPS]
MOST = 3  # changes that are named

CheckName = Callable[[str], Text]


@dataclass(frozen=True)
class Travelled:
    """`step`: the key of the step in which the first change is seen; empty where it is in none.  `place`: of its field,
    or of the list that has lost an element; () where it has none.  `check`: the finding that it is about."""

    words: Text
    step: str = ""
    place: Place = ()
    check: str = ""


def travelled(before: EditState, after: EditState, check_name: CheckName = Name) -> Travelled:
    """From one state to another.  `check_name`: what a check is called that has this id."""
    changes = [*_locks(before.data, after.data)]
    changes += [change for change in inputs(before.data, after.data) if change.key.partition(".")[0] != LOCKED]
    if not changes:
        return _typed(before, after)
    changes.sort(key=lambda change: change.key not in ORDER)  # a whole step, before what has gone with it
    named = [(_step(change, before.data, after.data), change) for change in changes]
    parts = []
    for step, mine in groupby(named[:MOST], lambda each: each[0]):
        parts.append(_of_step(step, COMMA.join(_words(c, before.data, after.data, check_name) for _, c in mine), after))
    if len(named) > MOST:
        parts.append(Text("{count} more", count=len(named) - MOST))
    (step, first), *_ = named
    top, _, rest = first.key.partition(".")
    if top == ACCEPTED:
        return Travelled(SEMICOLON.join(parts), step, check=rest)
    place = () if top == WITHOUT or first.key in ORDER else _place(first, before.data, after.data)
    return Travelled(SEMICOLON.join(parts), step, place)


def _locks(before: Table, after: Table) -> Iterator[InputDifference]:
    """What is locked, or is not any more; the file need not say what is locked as a rule."""
    old, new = locks(before), locks(after)
    for key in dict.fromkeys((*old, *new)):
        if (key in old) != (key in new):
            yield InputDifference(f"{LOCKED}.{key}", EMPTY, "", old.get(key), new.get(key))


def _typed(before: EditState, after: EditState) -> Travelled:
    """Between entries that are not understood, and what stood there before."""
    for place in (*before.texts, *after.texts):
        old, new = (state.texts.get(place, ("", EMPTY))[0] for state in (before, after))
        if old != new:
            key = ".".join(map(str, place))
            label = label_of(after.data, key)
            words = Text("{label}: “{old}” is gone", label=label, old=Name(old))
            if new:
                words = Text("{label}: “{new}” is there again, which is not understood", label=label, new=Name(new))
            step = _known(step_at(after.data, key))
            return Travelled(_of_step(step, words, after), step, place)
    return Travelled(EMPTY)


def _of_step(step: str, changes: Text, after: EditState) -> Text:
    if not step:
        return Text("the design: {changes}", changes=changes)
    n = ORDER.index(step)
    return Text("{n} {step}: {changes}", n=n + 1, step=title_of(STEPS[n], after.data), changes=changes)


# --- of one change
def _key(change: InputDifference) -> str:
    """Of the input that it is about."""
    top, _, rest = change.key.partition(".")
    return rest if top in (ACCEPTED, LOCKED, WITHOUT) else change.key


def _step(change: InputDifference, before: Table, after: Table) -> str:
    """The step whose form shows it; empty where none does."""
    key = _key(change)
    if (key.partition(".")[0],) in (DOCUMENT, NAME, NOTE):
        return ORDER[0]
    return _known(step_at(after if _place(change, after, after) else before, key))


def _known(step: str) -> str:
    return step if step in ORDER else ""


def _place(change: InputDifference, before: Table, after: Table) -> Place:
    """Where it stands now; of an element that is gone, the list that it stood in."""
    key = _key(change)
    try:
        return address(after, key, whole=True)
    except BadInput:
        pass
    try:
        place = address(before, key, whole=True)
    except BadInput:
        return ()
    return place[:-1] if isinstance(place[-1], int) else place


def _words(change: InputDifference, before: Table, after: Table, check_name: CheckName) -> Text:
    top, _, rest = change.key.partition(".")
    there = change.b is not None
    data = after if there else before
    if top == LOCKED:
        label = label_of(data, rest)
        return Text("{input} is locked", input=label) if there else Text("{input} is not locked", input=label)
    if top == ACCEPTED:
        check = check_name(rest)
        return Text("{check} is accepted", check=check) if there else Text("{check} is open", check=check)
    if top == WITHOUT:
        return Text("left out: {reason}", reason=Name(str(change.b))) if there else Text("not left out any more")
    if change.key in ORDER:
        return Text("the step is there") if there else Text("the step is gone")
    if None in (change.a, change.b) and isinstance(change.b if there else change.a, (dict, list)):
        return Text("{what} is there", what=change.label) if there else Text("{what} is gone", what=change.label)
    return Text("{label} {change}", label=label_of(data, change.key), change=from_to(change))
