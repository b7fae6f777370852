# SPDX-License-Identifier: Apache-2.0
"""Why a number is what it is: the chain of lines that leads to it, and how far each input moves it.

The chain of recorded lines is the links of the value (`sheet/value.py`) followed back to the inputs, and nothing else.
"""

import math
from collections.abc import Callable, Collection, Iterable, Iterator
from dataclasses import dataclass, is_dataclass

from ..design.addresses import as_list, quantities, value_at
from ..design.model import Design
from ..design.toml_file import Document, design
from ..sheet.check import Check
from ..sheet.errors import BadInput
from ..sheet.quantity import Quantity
from ..sheet.quantity import keys as keys_of
from ..sheet.record import record
from ..sheet.value import Line, joined_links, leaves, link_of, recorded
from ..sheet.verdict import grouped
from ..solve import Results, solve


@dataclass(frozen=True)
class Link:
    """One line of a chain and the inputs that enter it directly, as keys of the design file."""

    line: Line
    inputs: tuple[str, ...]


def chain(results: Results, value_id: str) -> list[Link]:
    """The lines that lead to a value, each behind those that it needs; empty for a value taken straight from an
    input."""
    return Chains(results).of(value_id)


def origin(results: Results, value_id: str) -> str | None:
    """The key of a value that is an input itself, or that a name brings in."""
    return next((leaf for leaf in leaves(link_of(results.values()[value_id].inside)) if isinstance(leaf, str)), None)


def needs(line: Line) -> tuple[list[Line], list[str]]:
    """The lines and the inputs that the arguments of a line come from."""
    return _apart(dict.fromkeys(leaf for argument in line.arguments.values() for leaf in leaves(link_of(argument))))


def _apart(sources: Collection[Line | str]) -> tuple[list[Line], list[str]]:
    return [leaf for leaf in sources if isinstance(leaf, Line)], [leaf for leaf in sources if isinstance(leaf, str)]


class Chains:
    """The chains of the values of one solved design."""

    def __init__(self, results: Results) -> None:
        self.results = results
        self.values = results.values()
        self.value_of: dict[Line, str] = {}  # line → the value that it gives
        for id, value in self.values.items():
            for line in _apart(leaves(link_of(value.inside)))[0]:
                self.value_of.setdefault(line, id)

    def of(self, value_id: str) -> list[Link]:
        """The chain of one value; empty where it is an input."""
        return self._links(_apart(leaves(link_of(self.values[value_id].inside)))[0])

    def to(self, line: Line) -> list[Link]:
        """The chain of one line of the calculation."""
        return self._links([line])

    def behind(self, check: Check) -> str | None:
        """The value that a check is on; None where it judges none that is published."""
        if check.value_id in self.values:
            return check.value_id
        return next((self.value_of[line] for line in _apart(self.judged(check))[0] if line in self.value_of), None)

    def of_check(self, check: Check) -> tuple[list[Link], list[str]]:
        """The chain of the number that a check judges, published or not, and the inputs that it is taken from straight
        away."""
        lines, keys = _apart(self.judged(check))
        return self._links(lines), keys

    def judged(self, check: Check) -> tuple[Line | str, ...]:
        """The lines that gave the number which a check judges, and the inputs that it was taken from."""
        known = next((candidate for candidate in self.results.checks() if candidate.id == check.id), check)
        return leaves(link_of(known.value))

    def asked(self, check: Check) -> tuple[Line | str, ...]:
        """The same of the limit that it is held against; nothing where the limit stands for itself."""
        known = next((candidate for candidate in self.results.checks() if candidate.id == check.id), check)
        of_value = self.values[check.limit_id].inside if check.limit_id in self.values else None
        ends = known.limit if isinstance(known.limit, tuple) else (known.limit,)
        return leaves(joined_links(map(link_of, ends))) or leaves(link_of(of_value))

    def _links(self, lines: list[Line]) -> list[Link]:
        return [Link(line, tuple(needs(line)[1])) for line in _ordered(lines)]


def _ordered(lines: list[Line]) -> Iterator[Line]:
    """These lines and all that they need, each behind those that it needs."""
    given: set[Line] = set()
    waiting = [(line, False) for line in lines]  # the first, which gave the number, comes last
    while waiting:
        line, ready = waiting.pop()
        if ready:
            yield line
        elif line not in given:
            given.add(line)
            waiting.append((line, True))
            waiting += [(needed, False) for needed in reversed(needs(line)[0]) if needed not in given]


def shortened(inputs: Iterable[str], design: Design) -> list[str]:
    """Keys to be listed: those of one number of all elements of an array of tables as one,
    `shafts.shaft.masses.*.mass_kg`."""
    keys = dict.fromkeys(inputs)
    for columns in _columns(design):
        if len(columns) > 1 and all(key in keys for key, _ in columns):
            whole = columns[0][1]
            keys = dict.fromkeys(whole if key in dict(columns) else key for key in keys)
    return list(keys)


def _columns(inputs: object, prefix: str = "") -> Iterator[list[tuple[str, str]]]:
    """Of each number of each array of tables, its keys by element, each with the key of them all."""
    for key in keys_of(_class(inputs)).values():
        content, here = getattr(inputs, key.attribute), f"{prefix}.{key.key}" if prefix else key.key
        if is_dataclass(content):
            yield from _columns(content, here)
        elif key.about.kind == "tables" and content:
            for part in keys_of(_class(content[0])).values():
                yield [
                    (f"{here}.{getattr(element, 'name', i)}.{part.key}", f"{here}.*.{part.key}")
                    for i, element in enumerate(content)
                ]
            for i, element in enumerate(content):
                yield from _columns(element, f"{here}.{getattr(element, 'name', i)}")


def _class(inputs: object) -> type:
    return type(inputs)


# --- how far the inputs that move a check move it
# The sign and the size of each effect, by solving the design again with a small change.

SMALL = 1e-3  # relative change of an input
MOST = 3  # inputs that are moved for one cause
KINDS = ("number", "integer", "series")


@record
class Effect:
    """What one unit more of a key does to a check, in the check's unit: to its value (`slope`), and to the distance
    from its limit (`gain`, positive: it is kept more widely).  Of a list all numbers are moved.  None: it was not
    moved, or it is no number, is not given, or the design has no solution then."""

    key: str
    slope: float | None
    gain: float | None
    unit: str


def effects(
    document: Document, results: Results, checks: Iterable[Check], most: int = MOST, stop: Callable[[], bool] = bool
) -> dict[str, tuple[Effect, ...]]:
    """For each check what the inputs do that move it most, in the order of use.  `document` is that of the results.

    Of checks with one cause the worst says which inputs are moved, `most` of them.  Each is moved once, and only what
    depends on it is solved again.  `stop` as of a solve."""
    known = dict(quantities(document.data))
    wanted = list(checks)
    moved: dict[str, Moved] = {}
    for group in grouped(wanted):
        keys = [key for key in _keys(group[0], known) if known[key].kind in KINDS]
        numbers = [key for key in keys if value_at(document.data, key) is not None]
        for key in numbers[:most]:
            if key not in moved:
                moved[key] = _moved(document, results, key, known[key], stop)
    return {c.id: tuple(_effect(c, key, known[key], moved.get(key)) for key in _keys(c, known)) for c in wanted}


Moved = tuple[float, dict[str, Check]] | None


def _keys(check: Check, known: dict[str, Quantity]) -> list[str]:
    """The keys of single inputs: in place of the key of a table those of the numbers in it."""
    keys: dict[str, None] = {}
    for key in check.moved_by:
        inside = [inner for inner in known if inner.startswith(f"{key}.") and known[inner].kind in KINDS]
        keys |= dict.fromkeys([key] if key in known else inside)
    return list(keys)


def _moved(document: Document, results: Results, key: str, about: Quantity, stop: Callable[[], bool]) -> Moved:
    """The change of an input in its unit, and all checks after it: to the side where the same checks are there, since
    where a shaft loses its outline, say, its numbers jump."""
    old = value_at(document.data, key)
    numbers = [x for x in as_list(old) if isinstance(x, (int, float))]
    size = max(map(abs, numbers)) * SMALL or (about.step or 1.0) * 0.01
    there, first = {check.id for check in results.checks()}, None
    for change in (1, -1) if about.kind == "integer" else (size, -size):
        new = [x + change for x in numbers]
        try:
            moved = design(document.with_value(key, new if isinstance(old, list) else new[0]))
            with recorded(False):
                after = solve(moved, results, stop)
        except BadInput:
            continue  # beyond what is allowed: the other way
        found = change, {check.id: check for check in after.checks()}
        if found[1].keys() == there:
            return found
        first = first or found
    return first


def _effect(check: Check, key: str, about: Quantity, moved: Moved) -> Effect:
    unit = f"{check.unit or '1'}/{about.unit or '1'}" if check.unit or about.unit else ""
    if moved is None or check.id not in moved[1]:
        return Effect(key, None, None, unit)
    change, after = moved[0], moved[1][check.id]
    slope, gain = (after.value - check.value) / change, (after.nearest[0] - check.nearest[0]) / change
    return Effect(key, slope if math.isfinite(slope) else None, gain if math.isfinite(gain) else None, unit)


def moved_by(
    document: Document, results: Results, key: str, stop: Callable[[], bool] = bool
) -> tuple[tuple[Check, Effect], ...]:
    """What one input moves: every check, with the effect of one unit more; first those whose margin it moves most, of
    what there is."""
    about = dict(quantities(document.data)).get(key)
    if about is None or about.kind not in KINDS or value_at(document.data, key) is None:
        return ()
    moved = _moved(document, results, key, about, stop)
    moves = [(check, _effect(check, key, about, moved)) for check in results.checks()]
    there = [(check, effect) for check, effect in moves if effect.gain]
    return tuple(sorted(there, key=lambda pair: -abs((pair[1].gain or 0.0) / (abs(pair[0].nearest[0]) or 1.0))))
