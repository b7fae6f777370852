# SPDX-License-Identifier: Apache-2.0
"""What decides a check, walked back from the number that it judges: the lines of the calculation that a proof shows, and what they need.

Twins, which are one row of the table of checks (front and rear bearing, every mesh), are one proof: those that fail or come near their
limit with their numbers, the others by name.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from math import prod

import numpy as np

from calc.explain import needs
from calc.key_values import PROVEN, PROVEN_WHERE
from calc.sheet.check import Check, severity
from calc.sheet.expression import governing, result, symbol_of
from calc.sheet.rules import pattern_of
from calc.sheet.text import Text, with_unit
from calc.sheet.trace import Line
from calc.sheet.value import link_of

from .context import Context, near
from .equation import Entry, Label, Place

MOST = {"limit": 9, "caution": 4}  # formulas of a demand
ALIKE = 3  # values of one symbol that are quoted
HELD = 4  # of one that holds, and of a value
LIMIT = 2  # formulas of a limit
COORDINATES = ("z", "φ", "ξ")  # what a place along an array is named by
Known = dict[str | Line, str]  # formula, and each of its lines that is shown → number of the proof that derives it


@dataclass(frozen=True, slots=True)
class Proof:
    """Checks that are proven together, the worst first, and their twins, which hold with more room."""

    checks: tuple[Check, ...]
    others: tuple[Check, ...]

    @property
    def governing(self) -> Check:
        return self.checks[0]


@dataclass(frozen=True, slots=True)
class Walk:
    """What a number comes from: formulas with their numbers, values that these take from elsewhere, and inputs."""

    entries: list[Entry]
    quoted: list[str]  # "F = 1707 N [4.1]"
    inputs: list[str]  # keys

    @property
    def lines(self) -> list[Line]:
        return [line for entry in self.entries for _, line in entry.lines]

    def derived(self, number: str) -> Known:
        """Its formulas and lines, as those of the proof with this number."""
        return {**{_name(line): number for line in self.lines}, **dict.fromkeys(self.lines, number)}


def proofs(context: Context, checks: Iterable[Check]) -> list[Proof]:
    """The proofs of a step: of what fails, can not be judged or comes near its limit, the worst first; then of what is always proven."""
    twins: dict[str, list[Check]] = {}
    for check in checks:
        twins.setdefault(pattern_of(check.id), []).append(check)
    open_ones, kept = [], []
    for pattern, group in twins.items():
        if wanted := sorted(filter(near, group), key=severity):
            open_ones.append(Proof(tuple(wanted), tuple(check for check in group if check not in wanted)))
        elif pattern in PROVEN and group[0].kind in MOST and _asked(context, pattern):
            least = min(group, key=lambda check: check.margin)
            kept.append(Proof((least,), tuple(check for check in group if check is not least)))
    return sorted(open_ones, key=lambda proof: severity(proof.governing)) + kept


def _asked(context: Context, pattern: str) -> bool:
    """Whether there is anything to prove of what is always proven."""
    asked = context.values.get(PROVEN_WHERE.get(pattern, ""))
    return pattern not in PROVEN_WHERE or (asked is not None and asked.shown != 0)


def demand(context: Context, proof: Proof, known: Known) -> Walk:
    """What the numbers that are judged come from; what another proof derives is quoted from there."""
    check = proof.governing
    roots = [context.chains.judged(one) for one in proof.checks]
    most = HELD if check.verdict == "pass" else MOST[check.kind]
    return _walk(context, roots, most, PROVEN.get(pattern_of(check.id), ()), known)


def limit(context: Context, proof: Proof, known: Known) -> Walk:
    """What the limits come from; nothing where other proofs derive it."""
    roots = [context.chains.asked(one) for one in proof.checks]
    if all(line in known for root in roots for line in _lines(root)):
        return Walk([], [], [])
    return _walk(context, roots, LIMIT, (), {})


def value(context: Context, id: str, known: Known) -> Walk:
    """What a value comes from that no check judges."""
    return _walk(context, [tuple(link.line for link in context.chains.of(id)[-1:])], HELD, (), known)


def _walk(context: Context, roots: Sequence[tuple[Line | str, ...]], most: int, also: tuple[str, ...], known: Known) -> Walk:
    """The lines nearest to the first of several numbers, `most` formulas and the symbols in `also`, and the same of the others."""
    shown = _nearest(_lines(roots[0]), most, also, known)
    if not shown:
        return Walk([], [], [leaf for leaf in roots[0] if isinstance(leaf, str)])
    count = {name: sum(_name(line) == name for line in shown) for name in map(_name, shown)}
    for root in roots[1:]:
        left = dict(count)
        for line in _followed(_lines(root)):
            if left.get(_name(line), 0) > 0 and line not in shown:
                left[_name(line)] -= 1
                shown.append(line)
    place, first = _place(context, shown), _lines(roots[0])
    entries: dict[str, Entry] = {}
    for line in shown:
        entry = Entry(line.formula, [], place, parts=1, full=line in first)
        entries.setdefault(_name(line), entry).lines.append((Label(*context.say.halves(line.about)), line))
    return Walk(list(entries.values()), _quoted(context, shown, place, known), _inputs(roots, shown))


def _lines(leaves: Iterable[Line | str]) -> list[Line]:
    return [leaf for leaf in leaves if isinstance(leaf, Line)]


def _followed(roots: list[Line]) -> Iterator[Line]:
    """These lines and all that they need, the nearest first."""
    known, waiting = set(roots), list(roots)
    for line in waiting:  # grows on the way
        yield line
        for needed in needs(line)[0]:
            if needed not in known:
                known.add(needed)
                waiting.append(needed)


def _nearest(roots: list[Line], most: int, also: tuple[str, ...], known: Known) -> list[Line]:
    names: dict[str, None] = {}
    shown, wanted = [], set(also)
    for line in _followed(roots):
        if line.formula.symbol in wanted:
            wanted.discard(line.formula.symbol)
        elif line not in roots and (_constant(line) or _name(line) in known or (_name(line) not in names and len(names) >= most)):
            continue
        names[_name(line)] = None
        shown.append(line)
    return shown


def _constant(line: Line) -> bool:
    """Whether a line says no more than its value."""
    lines, inputs = needs(line)
    return bool(line.formula.shows) and not lines and not inputs


def _name(line: Line) -> str:
    return f"{line.formula.function.__module__}.{line.formula.__name__}"


def _quoted(context: Context, shown: list[Line], place: Place | None, known: Known) -> list[str]:
    """The values that the shown lines take from lines that are not shown."""
    given = set(shown)
    values: dict[tuple[str, str], dict[str, str]] = {}  # symbol and where it is derived → numbers, each with its unit
    for line in shown:
        for needed in needs(line)[0]:
            if needed not in given:
                number, unit = result(needed, place.index if place else None)
                key = symbol_of(needed), known.get(_name(needed), "")
                values.setdefault(key, {})[context.say.number(number)] = unit
    return [_told(symbol, where, numbers) for (symbol, where), numbers in values.items()]


def _told(symbol: str, where: str, numbers: dict[str, str]) -> str:
    """The values of a symbol, of many the first and the last, and the number of the proof that derives it."""
    some = list(numbers)
    listed = "; ".join(some) if len(some) <= ALIKE else f"{some[0]} … {some[-1]}"
    return f"{symbol} = {with_unit(listed, numbers[some[-1]])}{f' [{where}]' if where else ''}"


def _inputs(roots: Sequence[tuple[Line | str, ...]], shown: list[Line]) -> list[str]:
    keys = [leaf for root in roots for leaf in root if isinstance(leaf, str)]
    return list(dict.fromkeys([*keys, *(key for line in shown for key in needs(line)[1])]))


def _place(context: Context, shown: list[Line]) -> Place | None:
    """The element of arrays that is followed: the one that governs the number which is judged, or that it is made from; named by where it
    lies."""
    line, index = shown[0], governing(shown[0])
    if index is None:
        line, index = _taken(line) or (line, None)
    shape: tuple[int, ...] = getattr(line.value, "shape", ())
    if index is None or prod(shape) < 2:
        return None
    for one in _followed([line]):
        if one.formula.symbol in COORDINATES and getattr(one.value, "shape", ()) == shape:
            number, unit = result(one, index)
            return Place(index, f"({one.formula.symbol} = {with_unit(context.say.number(number), unit)})")
    return Place(index, context.say(Text("(place {number} of {size})", number=index[-1] + 1, size=shape[-1])))


def _taken(line: Line) -> tuple[Line, tuple[int, ...]] | None:
    """The array of which a line takes one number, and which of its elements that is: the frequency of one mode among the squares of all."""
    for value in line.arguments.values():
        source = link_of(value)
        if isinstance(source, Line) and isinstance(value, float) and isinstance(source.value, np.ndarray):
            for index in np.argwhere(source.value == value).tolist():
                return source, tuple(index)
    return None
