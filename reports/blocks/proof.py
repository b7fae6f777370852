# SPDX-License-Identifier: Apache-2.0
"""What decides a check, walked back from the number that it judges: the lines of the calculation that a proof shows, and what they need.

Twins, which are one row of the table of checks (front and rear bearing, every mesh), are one proof: those that fail or come near their
limit with their numbers, the others by name.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from math import prod

from calc.design.key_values import PROVEN, PROVEN_WHERE
from calc.sheet.check import Check, severity
from calc.sheet.expression import governing, result, symbol_of
from calc.sheet.rules import pattern_of
from calc.sheet.text import Text, with_unit
from calc.sheet.trace import Line

from ..context import Context, near
from ..elements import Element, Index
from ..setting.equation import Entry, Label, Place

MOST = {"limit": 9, "caution": 4}  # formulas of a demand
ALIKE = 3  # values of one symbol that are quoted
FEW = 3  # elements of an array that are quoted one by one
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
    starts = [[(line, governing(line)) for line in _lines(root)] for root in roots]
    shown = _nearest(context, starts[0], most, also, known)
    if not shown:
        return Walk([], [], [leaf for leaf in roots[0] if isinstance(leaf, str)])
    count = {name: sum(_name(line) == name for line in shown) for name in map(_name, shown)}
    for start in starts[1:]:
        left = dict(count)
        for line, index in context.origins.followed(start):
            if left.get(_name(line), 0) > 0 and line not in shown:
                left[_name(line)] -= 1
                shown[line] = index
    places, first = _places(context, shown, [*context.origins.followed(element for start in starts for element in start)]), _lines(roots[0])
    entries: dict[str, Entry] = {}
    for line in shown:
        entry = Entry(line.formula, [], places, parts=1, full=line in first)
        entries.setdefault(_name(line), entry).lines.append((Label(*context.say.halves(line.about)), line))
    return Walk(list(entries.values()), _quoted(context, shown, known), _inputs(context, roots, shown))


def _lines(leaves: Iterable[Line | str]) -> list[Line]:
    return [leaf for leaf in leaves if isinstance(leaf, Line)]


def _nearest(context: Context, start: list[Element], most: int, also: tuple[str, ...], known: Known) -> dict[Line, Index | None]:
    """The lines to be shown, each with the element of it that is followed."""
    names: dict[str, None] = {}
    shown: dict[Line, Index | None] = {}
    roots, wanted = [line for line, _ in start], set(also)
    for line, index in context.origins.followed(start):
        if line.formula.symbol in wanted:
            wanted.discard(line.formula.symbol)
        elif line not in roots and (
            _constant(context, (line, index)) or _name(line) in known or (_name(line) not in names and len(names) >= most)
        ):
            continue
        names[_name(line)] = None
        shown[line] = index
    return shown


def _constant(context: Context, element: Element) -> bool:
    """Whether a line says no more than its value."""
    return bool(element[0].formula.shows) and not any(context.origins.of(element))


def _name(line: Line) -> str:
    return f"{line.formula.function.__module__}.{line.formula.__name__}"


def _quoted(context: Context, shown: Mapping[Line, Index | None], known: Known) -> list[str]:
    """The values that the shown lines take from lines that are not shown."""
    values: dict[tuple[str, str], dict[str, str]] = {}  # symbol and where it is derived → numbers, each with its unit
    for element in shown.items():
        for needed, index in context.origins.of(element)[0]:
            if needed not in shown:
                where = known.get(needed) or (context.text("as_in", number=known[_name(needed)]) if _name(needed) in known else "")
                for at in [index] if index else _all(needed):
                    number, unit = result(needed, at)
                    values.setdefault((symbol_of(needed), where), {})[context.say.number(number)] = unit
    return [_told(symbol, where, numbers) for (symbol, where), numbers in values.items()]


def _all(line: Line) -> list[Index | None]:
    """Every element of an array of few along one axis; else the one that governs."""
    shape: Index = getattr(line.value, "shape", ())
    return [(i,) for i in range(shape[0])] if len(shape) == 1 and 1 < shape[0] <= FEW else [None]


def _told(symbol: str, where: str, numbers: dict[str, str]) -> str:
    """The values of a symbol, of many the first and the last, and the number of the proof that derives it."""
    some = list(numbers)
    listed = "; ".join(some) if len(some) <= ALIKE else f"{some[0]} … {some[-1]}"
    return f"{symbol} = {with_unit(listed, numbers[some[-1]])}{f' [{where}]' if where else ''}"


def _inputs(context: Context, roots: Sequence[tuple[Line | str, ...]], shown: Mapping[Line, Index | None]) -> list[str]:
    keys = [leaf for root in roots for leaf in root if isinstance(leaf, str)]
    return list(dict.fromkeys([*keys, *(key for element in shown.items() for key in context.origins.of(element)[1])]))


def _places(context: Context, shown: Mapping[Line, Index | None], reached: list[Element]) -> dict[Line, Place]:
    """The elements of arrays that are followed, each named by where it lies; `reached`: all that the numbers come from."""
    coordinates = [(one, at) for one, at in reached if at and one.formula.symbol in COORDINATES]
    places = {}
    for line, index in shown.items():
        shape: Index = getattr(line.value, "shape", ())
        if index is None or prod(shape) < 2:
            continue
        lies = (one for one, at in coordinates if at == index and getattr(one.value, "shape", ()) == shape)
        if (one := next(lies, None)) is not None:
            number, unit = result(one, index)
            words = f"({one.formula.symbol} = {with_unit(context.say.number(number), unit)})"
        else:
            words = context.say(Text("(place {number} of {size})", number=index[-1] + 1, size=shape[-1]))
        places[line] = Place(index, words)
    return places
