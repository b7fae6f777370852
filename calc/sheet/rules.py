# SPDX-License-Identifier: Apache-2.0
"""The table of all checks: of which kind each is and why, what it shares its cause with, which value it judges and what moves it.

It is a table to be read, `calc/library/tables/checks.md`; the letters in its ids stand for elements that have names of their own.
"""

import re
from functools import cache
from pathlib import Path

from .record import record

TABLE = Path(__file__).parents[1] / "library" / "tables" / "checks.md"
KINDS = ("limit", "caution", "advice", "method")  # from what must hold to what concerns the calculation alone
ELEMENTS = ("B", "M", "N", "W")  # a bearing, a mesh, any element, a wheel
LETTER = re.compile(r"(?<![^.|])(?:[BMNW#]|DRIVER|DRIVEN)(?![^.|])|(?<=_)W(?![^|])")  # in ids side by side, with | between them


@record
class Rule:
    """One row: for one check, or for all checks of its pattern.

    `kinds`: the first, unless the site says another of them.  `demand`: value and limit are demand and capacity.  `exact`: the limit is
    one that the designer has chosen, and may be used up.  `value`, `limit`: ids of
    the value that is judged and of that which it is held against; empty: it has none.  `moved_by`: keys of the inputs that move it most,
    in the order in which a designer uses them; the key of a table stands for the numbers in it.
    """

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
def rules() -> tuple[Rule, ...]:
    """All rows, in their order."""
    rows = [line for line in TABLE.read_text(encoding="utf-8").splitlines() if line.startswith("| ")][1:]
    return tuple(_rule(*(cell.strip() for cell in row[2:-2].split("| "))) for row in rows)


def _rule(id: str, kind: str, cause: str, value: str, limit: str, moved_by: str, why: str) -> Rule:
    words = kind.split()
    kinds = tuple(word for word in words if word in KINDS)
    value = id if value == "=" else value
    return Rule(id, kinds, "demand" in words, "exact" in words, cause, value, limit, tuple(moved_by.split()), why)


@cache
def _by_end() -> dict[tuple[str, int, str], list[tuple[Rule, list[str]]]]:
    """The rules and the parts of their ids by step, number of parts and last part; of several, those with fewer letters first."""
    found: dict[tuple[str, int, str], list[tuple[Rule, list[str]]]] = {}
    parted = [(rule, rule.id.split(".")) for rule in rules()]
    for rule, parts in sorted(parted, key=lambda one: sum(part in ELEMENTS for part in one[1])):
        found.setdefault((parts[0], len(parts), parts[-1].removesuffix("W")), []).append((rule, parts))
    return found


@cache
def rule_of(id: str, index: int | None = None) -> Rule:
    """The row of a check with its own elements in place of the letters.  `index`: of the mesh in its array (`#` of the keys).

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


def _row(id: str) -> tuple[Rule, dict[str, str]]:
    """The row of a check, and the elements that its letters stand for."""
    parts = id.split(".")
    ends = (parts[-1], parts[-1].partition("_")[0] + "_", "N")  # the last: what the check is about stands at the end
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
    """The elements that the letters of a pattern stand for in an id; None where it is not of this pattern.  A mesh is two names with _."""
    names: dict[str, str] = {}
    for letter, part in zip(pattern, parts):
        if letter in ELEMENTS:
            if letter in "MW" and (letter == "M") != ("_" in part):
                return None
            names[letter] = part
        elif letter.endswith("_W") and part.startswith(letter[:-1]):
            names["W"] = part[len(letter) - 1 :]
        elif letter != part:
            return None
    if "M" in names:
        names["DRIVER"], _, names["DRIVEN"] = names["M"].partition("_")
    return names


def _filled(rule: Rule, names: dict[str, str], index: int | None) -> Rule:
    names = names if index is None else names | {"#": str(index)}
    if not names and not any("#" in key for key in rule.moved_by):
        return rule
    asked = "|".join((rule.id, rule.cause, rule.value, rule.limit, *rule.moved_by))
    id, cause, value, limit, *keys = LETTER.sub(lambda letter: names.get(letter[0], letter[0]), asked).split("|")
    moved_by = tuple([key for key in keys if "#" not in key])
    return Rule(id, rule.kinds, rule.demand, rule.exact, cause, value, limit, moved_by, rule.why)
