# SPDX-License-Identifier: Apache-2.0
"""A check: a value against its limit, with kind, cause, margin, verdict and remedies; and the table of all checks.

The table says of each check what kind it is and why, what it shares its cause with, and what moves it."""

import math
import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from difflib import get_close_matches
from functools import cache, cached_property
from pathlib import Path

from .errors import BadTable, InputError
from .quantity import unknown
from .record import record
from .remedy import Remedy, sentence
from .text import EMPTY, SEMICOLON, SPACE, Amount, Text
from .units import UNITS
from .value import link_of, linked

# --- the table of all checks
# Of which kind each is and why, what it shares its cause with, which value it judges and what moves it.
#
# It is a table to be read, `calc/library/tables/checks.md`; the letters in its ids stand for elements that have names
# of their own.

TABLE = Path(__file__).parents[1] / "library" / "tables" / "checks.md"
KINDS = ("limit", "caution", "advice", "method")  # from what must hold to what concerns the calculation alone
ROLES = ("demand", "exact")  # what may stand behind a kind
COLUMNS = ("id", "kind", "cause", "value", "limit", "moved by", "why")
INDEX = "#"  # in the key of an input: the place of an element in its array


@record
class Element:
    """What a letter in the ids of the table stands for.

    `ends`: the element is called by two names with _ between, which these words stand for.  `single`: by one name with
    no _ in it.  `behind`: the letter also stands behind _ at the end of an id.
    """

    letter: str
    ends: tuple[str, ...] = ()
    single: bool = False
    behind: bool = False

    def can_be(self, part: str) -> bool:
        return "_" in part if self.ends else not (self.single and "_" in part)


@record
class CheckRule:
    """One row: for one check, or for all checks of its pattern.

    `kinds`: the first, unless the site says another of them.  `demand`: value and limit are demand and capacity.
    `exact`: the limit is one that the designer has chosen, and may be used up.  `value`, `limit`: ids of the value that
    is judged and of that which it is held against; empty: it has none.  `moved_by`: keys of the inputs that move it
    most, in the order in which a designer uses them; the key of a table stands for the numbers in it."""

    id: str
    kinds: tuple[str, ...]
    demand: bool
    exact: bool
    cause: str
    value: str
    limit: str
    moved_by: tuple[str, ...]
    why: str


@cache
def rules() -> tuple[CheckRule, ...]:
    """All rows, in their order."""
    return tuple(_rule(line, cells) for line, cells in _tables()[1])


def _tables() -> tuple[list[tuple[int, list[str]]], list[tuple[int, list[str]]]]:
    """The rows of the two tables of the page, each with its line, without their heads: the letters, and the checks."""
    tables: list[list[tuple[int, list[str]]]] = []
    inside = False
    for line, row in enumerate(TABLE.read_text(encoding="utf-8").splitlines(), 1):
        if row.startswith("| "):
            tables += [] if inside else [[]]
            tables[-1].append((line, [cell.strip() for cell in row[2:-2].split("| ")]))
        inside = row.startswith("|")
    letters, checks = tables
    return letters[1:], checks[1:]


@cache
def elements() -> dict[str, Element]:
    """The letters of the table."""
    by_letter = {}
    for _, (letter, _, kind) in _tables()[0]:
        words = re.findall(r"\w+", kind)
        ends = tuple(words[words.index("pair") + 1 :][:2]) if "pair" in words else ()
        by_letter[letter] = Element(letter, ends, "single" in words, "behind" in words)
    return by_letter


@cache
def letters() -> re.Pattern[str]:
    """The letters in ids that stand side by side with | between them."""
    alone = [INDEX, *elements(), *(word for element in elements().values() for word in element.ends)]
    behind = "".join(letter for letter, element in elements().items() if element.behind)
    return re.compile(rf"(?<![^.|])(?:{'|'.join(alone)})(?![^.|])|(?<=_)[{behind}](?![^|])")


def _rule(line: int, cells: list[str]) -> CheckRule:
    if len(cells) != len(COLUMNS):
        count, columns = len(cells), ", ".join(COLUMNS)
        raise _bad_row(line, cells[0], Text("has {count} cells; needs {columns}", count=count, columns=columns))
    id, kind, cause, value, limit, moved_by, why = cells
    words = kind.split()
    if strangers := [word for word in words if word not in KINDS + ROLES]:
        raise _bad_row(line, id, unknown(strangers[0], KINDS + ROLES), strangers[0])
    if not any(word in KINDS for word in words):
        raise _bad_row(line, id, Text("has no kind; needs {kinds}", kinds=", ".join(KINDS)))
    kinds = tuple(word for word in words if word in KINDS)
    value = id if value == "=" else value
    return CheckRule(id, kinds, "demand" in words, "exact" in words, cause, value, limit, tuple(moved_by.split()), why)


def _bad_row(line: int, id: str, reason: Text, value: str = "") -> BadTable:
    return BadTable(str(TABLE), [InputError(line, id, value, reason)])


def _without_row(id: str) -> BadTable:
    """What is said of a check that has no row, at the row that may be meant for it."""
    lines = {cells[0]: line for line, cells in _tables()[1]}
    for near in get_close_matches(id, lines, 1):
        return _bad_row(lines[near], id, Text('has no row here; did you mean "{near}"?', near=near))
    return _bad_row(0, id, Text("has no row here"))


@cache
def _by_end() -> dict[tuple[str, int, str], list[tuple[CheckRule, list[str]]]]:
    """The rules and the parts of their ids by step, number of parts and last part; of several, those with fewer letters
    first."""
    by_end: dict[tuple[str, int, str], list[tuple[CheckRule, list[str]]]] = {}
    parted = [(rule, rule.id.split(".")) for rule in rules()]
    for rule, parts in sorted(parted, key=lambda entry: sum(part in elements() for part in entry[1])):
        last = parts[-1]
        for letter, element in elements().items():
            last = last.removesuffix(letter) if element.behind else last
        by_end.setdefault((parts[0], len(parts), last), []).append((rule, parts))
    return by_end


@cache
def rule_of(id: str, index: int | None = None) -> CheckRule:
    """The row of a check with its own elements in place of the letters.  `index`: of the mesh in its array (`#` of the
    keys).

    Raises KeyError where there is none: every check has its row.
    """
    return _filled(*_row(id), index)


@cache
def pattern_of(id: str) -> str:
    """The id of the row of a check, letters in place of its elements: the same for both bearings, and for all meshes.

    The id itself where there is no row.
    """
    try:
        return _row(id)[0].id
    except KeyError:
        return id


def _row(id: str) -> tuple[CheckRule, dict[str, str]]:
    """The row of a check, and the elements that its letters stand for."""
    parts = id.split(".")
    # the last of them: what the check is about stands at the end
    ends = (parts[-1], parts[-1].partition("_")[0] + "_", *elements())
    for end in ends:
        for rule, pattern in _by_end().get((parts[0], len(parts), end), ()):
            names = _names(pattern, parts)
            if names is not None:
                return rule, names
    raise KeyError(f"the check {id} has no row in {TABLE.name}")


def is_limit(id: str) -> bool:
    """Whether a check with this id can be nothing but a limit."""
    try:
        return rule_of(id).kinds == ("limit",)
    except KeyError:
        return False


def _names(pattern: list[str], parts: list[str]) -> dict[str, str] | None:
    """The elements that the letters of a pattern stand for in an id; None where it is not of this pattern."""
    names: dict[str, str] = {}
    for letter, part in zip(pattern, parts):
        if (element := elements().get(letter)) is not None:
            if not element.can_be(part):
                return None
            names[letter] = part
            names.update(zip(element.ends, part.split("_", 1)))
        elif letter != part:
            before, last = letter[:-1], elements().get(letter[-1:])
            if last is None or not last.behind or not before.endswith("_") or not part.startswith(before):
                return None
            names[last.letter] = part.removeprefix(before)
    return names


def _filled(rule: CheckRule, names: dict[str, str], index: int | None) -> CheckRule:
    names = names if index is None else names | {INDEX: str(index)}
    if not names and not any(INDEX in key for key in rule.moved_by):
        return rule
    asked = "|".join((rule.id, rule.cause, rule.value, rule.limit, *rule.moved_by))
    id, cause, value, limit, *keys = letters().sub(lambda letter: names.get(letter[0], letter[0]), asked).split("|")
    moved_by = tuple([key for key in keys if INDEX not in key])
    return CheckRule(id, rule.kinds, rule.demand, rule.exact, cause, value, limit, moved_by, rule.why)


# --- one check, and what several come to

THIN_MARGIN = 0.05  # a limit that holds by less than this is a warning
SIGNS = {
    "pass": "✓",
    "warn": "▲",
    "fail": "✗",
    "note": "•",
    "not_verified": "?",
    "accepted": "✓",
    "blocked": "○",
    "not_asked": "·",
    "no_solution": "✗",
}
# from good to bad
ORDER = ("not_asked", "pass", "accepted", "note", "warn", "not_verified", "blocked", "fail", "no_solution")
URGENT = ("fail", "not_verified", "warn")  # verdicts that somebody has to look at
STEP_STATES = ("not_asked", "pass", "warn", "not_verified", "blocked", "fail", "no_solution")


@record
class Check:
    """`value` and `limit` stand in the shown unit.  `sense` is ">=", ">", "<=", "<" or "in" (limit is then (low,
    high)).

    `kind`: a "limit" that is passed over is a fail, and one that holds by less than 5 % a
    warning; a "caution" that is passed over is a warning; "advice" and "method" (about the calculation, not the part)
    are notes. `cause`: the id of the check, or of the group, that it is shown under.  `value_id`, `limit_id`: the value
    that is judged, and the one that it is held against.  `moved_by`: keys of the inputs that move it most, in the order
    in which a designer uses them; the key of a table stands for the numbers in it. `exact`: the limit, where it is not
    0, is one that the designer has chosen and may be used up. `missing`: keys that are not given and without which it
    can not be judged: it stands on what the program takes for them. `advice`: what to do: the remedies, in the labels
    and units of the fields, and what is no value of a key.  `accepted`: the reason that the user gave for leaving it
    open."""

    id: str
    name: Text
    value: float
    limit: float | tuple[float, float]
    sense: str
    unit: str
    source: Text
    advice: Text = EMPTY
    kind: str = "limit"
    cause: str = ""
    value_id: str = ""
    limit_id: str = ""
    moved_by: tuple[str, ...] = ()
    remedies: tuple[Remedy, ...] = ()
    missing: tuple[str, ...] = ()
    demand: bool = False
    exact: bool = False
    accepted: str = ""

    def __str__(self) -> str:
        value = Amount(self.value, self.unit)
        return f"{SIGNS[self.verdict]} {self.name}: {value} ({self.limit_text()}, {self.margin_text()})"

    @property
    def nearest(self) -> tuple[float, float]:
        """Distance to the nearest limit, negative when passed over, and that limit."""
        if isinstance(self.limit, tuple):
            low, high = self.limit
            to_low, to_high = self.value - low, high - self.value
            return (to_low, low) if to_low <= to_high else (to_high, high)
        return (self.value - self.limit if self.sense in (">=", ">") else self.limit - self.value), self.limit

    @cached_property
    def margin(self) -> float:
        """Distance to the nearest limit over |limit|, negative when passed over; for a limit of 0 the distance
        itself."""
        gap, limit = self.nearest
        return gap / abs(limit) if limit else gap

    @property
    def holds(self) -> bool:
        """Whether the limit is kept; a value that is no number keeps none."""
        margin = self.margin
        return margin > 0 or (margin == 0 and self.sense not in (">", "<"))

    @property
    def narrow(self) -> bool:
        """A limit that is kept, but by so little that it is a warning."""
        return self.kind == "limit" and not (self.exact and self.limit) and self.holds and self.margin < THIN_MARGIN

    @property
    def utilisation(self) -> float | None:
        """Demand over capacity, 1 at the limit; None where the check is not on these two."""
        if not self.demand or isinstance(self.limit, tuple):
            return None
        over, under = (self.value, self.limit) if self.sense in ("<=", "<") else (self.limit, self.value)
        return over / under if under else None

    @property
    def share(self) -> float | None:
        """The value over its nearest limit, 1 at it; None where that says nothing."""
        limit = self.nearest[1]
        ratio = self.value / limit if limit else -1.0
        return ratio if ratio >= 0 else None

    @cached_property
    def finding(self) -> str:
        """The verdict, before anybody accepts it."""
        if self.missing and self.kind in ("limit", "caution"):
            return "not_verified"
        if self.holds:
            return "warn" if self.narrow else "pass"
        return {"limit": "fail", "caution": "warn"}.get(self.kind, "note")

    @property
    def verdict(self) -> str:
        finding = self.finding
        return "accepted" if self.accepted and self.kind != "limit" and finding != "pass" else finding

    @property
    def open(self) -> bool:
        """Whether something is left to do, or to accept."""
        return self.verdict not in ("pass", "accepted")

    def limit_text(self) -> Text:
        if isinstance(self.limit, tuple):
            return Text("{low} to {high}", low=Amount(self.limit[0]), high=Amount(self.limit[1], self.unit))
        sign = {">=": "≥", "<=": "≤"}.get(self.sense, self.sense)
        return Text("{sign} {limit}", sign=sign, limit=Amount(self.limit, self.unit))

    def margin_text(self) -> Text:
        margin = self.margin
        if math.isnan(margin):
            return Text("no number")
        if self.nearest[1] == 0:
            return Text("{margin}", margin=Amount(margin, self.unit, form="+.3g"))
        if abs(margin) > 1000:  # of a limit that is all but zero
            return Text("beyond {percent}", percent=Amount(math.copysign(1e5 - 1, margin), "%", form="+.0f"))
        return Text("{percent}", percent=Amount(margin * 100, "%", form="+.1f" if 0 < abs(margin) < 0.005 else "+.0f"))


def check(
    id: str,
    name: Text,
    value: float,
    sense: str,
    limit: float | tuple[float, float],
    unit: str,
    source: Text,
    advice: Text = EMPTY,
    *,
    kind: str = "",
    index: int | None = None,
    value_id: str | None = None,
    moved_by: tuple[str, ...] | None = None,
    remedies: Callable[[], tuple[Remedy, ...]] | None = None,
    missing: tuple[str, ...] = (),
) -> Check:
    """A check from numbers in SI: value and limit are turned into the shown unit here and nowhere else.

    A function that gives several is a generator, called `checks` or `…_checks`, and becomes a tuple where the Outcome
    is made; one that gives one, or perhaps none, is called `…_check`.

    Kind, cause, the value that is judged and what moves it are those of its row in `calc/library/tables/checks.md`.
    `kind`: where the row has two. `advice`: what could be done beside the remedies.  `index`: of the mesh in its array,
    for the keys of the row.  `value_id`, `moved_by`: where the site knows them better than the row.  `remedies` are
    made only where it does not hold."""
    try:
        rule = rule_of(id, index)
    except KeyError:
        raise _without_row(id) from None
    shown = UNITS[unit].shown
    bound = (shown(limit[0]), shown(limit[1])) if isinstance(limit, tuple) else linked(shown(limit), link_of(limit))
    number = shown(value) if math.isfinite(value) else value
    this_check = Check(
        id,
        name,
        linked(number, link_of(value)),
        bound,
        sense,
        unit,
        source,
        advice,
        kind if kind in rule.kinds else rule.kinds[0],
        rule.cause,
        rule.value if value_id is None else value_id,
        rule.limit,
        rule.moved_by if moved_by is None else moved_by,
        (),
        missing,
        rule.demand,
        rule.exact,
    )
    ways = () if remedies is None or this_check.holds else remedies()
    if not ways:
        return this_check
    return replace(this_check, remedies=ways, advice=SPACE.join(filter(None, (sentence(ways), advice))))


def worst(verdicts: Iterable[str]) -> str:
    """The worst of the states of steps; of a check's own only those count that colour a step."""
    return max((v for v in verdicts if v in STEP_STATES), key=ORDER.index, default="pass")


def step_verdict(checks: Iterable[Check]) -> str:
    """Of a step: fail if a limit fails, not_verified if one can not be judged, warn if a caution is open or a limit
    holds narrowly."""
    return worst("warn" if c.verdict == "not_verified" and c.kind != "limit" else c.verdict for c in checks)


def grouped(checks: Iterable[Check]) -> list[tuple[Check, ...]]:
    """Checks under their causes, the worst kind and verdict first; within a group the worst first.

    A group stands where its worst check does.  Checks of one kind and verdict keep their order, the limit that is
    missed furthest first."""
    groups: dict[str, list[Check]] = {}
    for check in checks:
        groups.setdefault(check.cause or check.id, []).append(check)
    ordered = (tuple(sorted(group, key=severity)) for group in groups.values())
    return sorted(ordered, key=lambda group: severity(group[0])[:3])


def with_it(checks: Sequence[Check], most: int = 3) -> Text:
    """What else of a group is open beside its worst."""
    return Text("With it: {names}", names=named(checks, most))


def named(checks: Sequence[Check], most: int = 3) -> Text:
    """Checks by name and margin; of more than `most` the rest as a number."""
    first = SEMICOLON.join(Text("{name} ({margin})", name=c.name, margin=c.margin_text()) for c in checks[:most])
    return first if len(checks) <= most else Text("{names}; {more} more", names=first, more=len(checks) - most)


def severity(check: Check) -> tuple[bool, int, int, float]:
    """What sorts checks: open ones before those that hold or are accepted, then by kind, then the worst verdict
    first."""
    margin = -math.inf if math.isnan(check.margin) else check.margin
    return not check.open, KINDS.index(check.kind), -ORDER.index(check.verdict), margin
