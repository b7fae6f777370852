# SPDX-License-Identifier: Apache-2.0
"""A replay taken down while a design is edited: where it began, every edit since, and what came out."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from calc.design.addresses import Table, address
from calc.design.labels import Place
from calc.design.model import SCHEMA
from calc.design.replay import RECORDED, played
from calc.design.toml_file import Document
from calc.sheet.errors import BadInput

if TYPE_CHECKING:
    from calc.design.replay import Step
    from calc.solve import Results

REL = 1e-6  # what a recorded value may differ by when it is played again
NOTHING = 1e-9  # a value below is held to this, in its unit, instead


class Recording:
    """Follows the valid states of a design.  A state that is not valid is passed over: the next valid one takes its
    edits along."""

    def __init__(self, start: Table) -> None:
        self.start = start
        self._states = [start]  # those that the replay will have, for its undo
        self._moves: list[Table | None] = []  # the state after each step; None is an undo
        self._open = False  # the last step still goes on

    @property
    def end(self) -> Table:
        """The design as it is now."""
        return self._states[-1]

    def close(self) -> None:
        """The next edit is a step of its own."""
        self._open = False

    def edited(self, data: Table) -> None:
        """The design is another one; an edit that goes on replaces what it was at first."""
        if self._open:
            self._states.pop()
            self._moves.pop()
        self._open = data != self.end
        if self._open:
            self._states.append(data)
            self._moves.append(data)

    def undone(self, data: Table) -> None:
        """An edit was taken back; one from before the recording, or a part of a step, is an edit like any other."""
        self.close()
        if len(self._states) > 1 and data == self._states[-2]:
            self._states.pop()
            self._moves.append(None)
        else:
            self.edited(data)
            self.close()

    def steps(self) -> "list[Step]":
        """The steps as a replay file has them."""
        replayed: list[Step] = []
        states = [self.start]
        for after in self._moves:
            if after is None:
                states.pop()
                replayed.append({"undo": True})
            else:
                replayed.append(step(states[-1], after))
                states.append(after)
        return replayed

    def text(self, results: "Results", start: str | None = None) -> str:
        """The replay file.  `results` are those of the design as it is now; `start`: the path of the file that the
        design was read from, which then stands for it, so that a later edit of the file is noticed."""
        import tomli_w

        design = self.start if start is None else start
        head = tomli_w.dumps({"schema": SCHEMA, "name": results.design.name, "design": design})
        rows = [*(("step", row) for row in self.steps()), *(("expect", row) for row in expected(results))]
        return "\n".join([head, *(_row(key, row) for key, row in rows)])


def _row(key: str, row: Mapping[str, object]) -> str:
    """One element of an array of tables, each under a header of its own."""
    import tomli_w

    return f"[[{key}]]\n" + tomli_w.dumps({key: row}).removeprefix(f"[{key}]\n")


# --- steps


@dataclass(frozen=True)
class _Change:
    """One place that changes; None: what stood there is taken out."""

    place: Place
    value: Any


def step(before: Table, after: Table) -> "Step":
    """The step that leads from one design to another: key by key where that can be said, else the tables of whole
    steps."""
    small = _step(before, list(_changes(before, after)))
    if small is not None and _leads(before, small, after):
        return small
    large = _step(
        before, [_Change((key,), after.get(key)) for key in {**before, **after} if before.get(key) != after.get(key)]
    )
    assert large is not None
    return large


def _leads(before: Table, step: "Step", after: Table) -> bool:
    """The replay comes to the same design by this step; it need not where an element is renamed among other changes."""
    try:
        return played(Document(before), step).data == after
    except BadInput:
        return False


def _changes(before: Any, after: Any, place: Place = ()) -> Iterator[_Change]:
    """What differs, each as deep as it can be named; an array that has another length is one change."""
    if isinstance(before, dict) and isinstance(after, dict):
        for key in (*before, *(key for key in after if key not in before)):
            if key not in before or key not in after:
                yield _Change((*place, key), after.get(key))
            else:
                yield from _changes(before[key], after[key], (*place, key))
    elif _elements(before) and _elements(after) and len(before) == len(after):
        for n, (a, b) in enumerate(zip(before, after)):
            yield from _changes(a, b, (*place, n))
    elif before != after:
        yield _Change(place, after)


def _elements(value: Any) -> bool:
    return isinstance(value, list) and all(isinstance(item, dict) for item in value)


def _step(before: Table, changes: list[_Change]) -> "Step | None":
    """The step with these changes, None where one of them has no key."""
    keys = [key for change in changes if (key := _key(before, change.place)) is not None]
    if len(keys) < len(changes):
        return None
    gone = [key for key, change in zip(keys, changes) if change.value is None]
    given = {key: change.value for key, change in zip(keys, changes) if change.value is not None}
    if len(changes) > 1:
        taken: Step = {"unset": gone} if gone else {}
        return taken | {"set": given} if given else taken
    return {"unset": gone[0]} if gone else {"set": keys[0], "to": changes[0].value}


def _key(data: Table, place: Place) -> str | None:
    """The dotted key of a place: elements by name, else by index; None where neither leads there."""
    parts: list[str] = []
    here: Any = data
    for part in place:
        part_name = None
        for name in _names(here, part):
            try:
                if address(data, ".".join([*parts, name]), whole=True) == place[: len(parts) + 1]:
                    part_name = name
                    break
            except BadInput:
                continue
        if part_name is None:
            return None
        parts.append(part_name)
        here = here[part] if isinstance(part, int) else here.get(part, {})
    return ".".join(parts)


def _names(here: Any, part: str | int) -> list[str]:
    """What a part of a place may be called."""
    if isinstance(part, str):
        return [part]
    name = here[part].get("name") if isinstance(here[part], dict) else None
    return [name, str(part)] if isinstance(name, str) and name else [str(part)]


# --- expectations


def expected(results: "Results") -> Iterator[dict[str, Any]]:
    """What the replay is to come to: the state of the design and of every step, every check that fails, and the values
    that stand for the steps."""
    asked, recorded = results.design.asked(), {"kind": RECORDED}
    yield {"design": results.verdict, **recorded}
    for asked_step in asked:
        yield {"step": asked_step.key, "verdict": results.outcomes[asked_step.key].verdict, **recorded}
    for id in dict.fromkeys(check.id for check in results.checks() if check.verdict == "fail"):
        yield {"check": id, "verdict": "fail", **recorded}
    values = results.values()
    for asked_step in asked:
        head = next(iter(asked_step.heads(values)), None)
        if head is not None and math.isfinite(head.shown):
            held = {"rel": REL} if abs(head.shown) > NOTHING else {"abs": NOTHING}
            yield {"value": head.id, "is": float(head.shown), "unit": head.unit, **held, **recorded}
