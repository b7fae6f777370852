# SPDX-License-Identifier: Apache-2.0
"""Until every check is declared: checks by the rows of the table."""

import re
from difflib import get_close_matches
from functools import cache
from pathlib import Path

from .check import CheckRule as Declared
from .check import Missing
from .errors import BadTable, InputError
from .quantity import unknown
from .record import record
from .text import EMPTY, Text

# --- the table of all checks
# Of which kind each is and why, what it shares its cause with, which value it judges and what moves it.
#
# It is a table to be read, `calc/library/tables/checks.md`; the letters in its ids stand for elements that have names
# of their own.

TABLE = Path(__file__).parents[1] / "library" / "tables" / "checks.md"
KINDS_ = KINDS = ("limit", "caution", "advice", "method")  # from what must hold to what concerns the calculation alone
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


@cache
def _declared(
    id: str, kind: str, demand: bool, exact: bool, unit: str, cause: str, moved_by: tuple[str, ...]
) -> Declared:
    made = Declared.__new__(Declared)
    for name, field in Declared.__dataclass_fields__.items():
        vars(made)[name] = field.default
    vars(made).update(
        id=id, kind=kind, why="", role="physics" if kind == "limit" else "", demand=demand, exact=exact, unit=unit
    )
    return made


def check(
    id,
    name,
    value,
    sense,
    limit,
    unit,
    source,
    advice=EMPTY,
    *,
    kind="",
    index=None,
    value_id=None,
    moved_by=None,
    remedies=None,
    missing=(),
):
    rule = rule_of(id, index)
    kind = kind if kind in rule.kinds else rule.kinds[0]
    declared = _declared(pattern_of(id), kind, rule.demand, rule.exact, unit, rule.cause, rule.moved_by)
    lack = Missing(missing, (), "none", "none") if missing else None
    made = declared(
        value,
        limit,
        at=("",) * len(__import__("calc.sheet.check", fromlist=["LETTER"]).LETTER.findall(declared.id))
        if "M" not in declared.id.split(".")
        else tuple(
            "a_b" if x == "M" else "w"
            for x in __import__("calc.sheet.check", fromlist=["LETTER"]).LETTER.findall(declared.id)
        ),
        name=name,
        source=source,
        advice=advice,
        sense=sense,
        scale=1.0 if limit == 0 else None,
        missing=lack,
        remedies=remedies,
    )
    return made.but(
        id=id,
        cause=rule.cause,
        value_id=rule.value if value_id is None else value_id,
        limit_id=rule.limit,
        moved_by=rule.moved_by if moved_by is None else moved_by,
    )
