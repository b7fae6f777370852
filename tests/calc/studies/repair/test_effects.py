# SPDX-License-Identifier: Apache-2.0
"""What a change does beside what it is made for, in words."""

from types import SimpleNamespace
from typing import Any

from calc.sheet.check import Check
from calc.sheet.text import Text
from calc.studies.repair.effects import NO_EFFECTS, side_effects
from calc.studies.repair.state import ORDER
from tests.made_checks import made_check


def solved(*checks: Check, lost: str = "") -> Any:
    """As `Results`: the checks are those of the bearings; one step may have lost its solution."""
    outcomes = {
        step: SimpleNamespace(
            state="no_solution" if step == lost else "solved", checks=checks if step == "bearings" else ()
        )
        for step in ORDER
    }
    return SimpleNamespace(outcomes=outcomes, checks=lambda: checks)


def check(id: str, value: float, kind: str = "limit", **more: Any) -> Check:
    return made_check(value, kind=kind, id=f"bearings.{id}", name=Text(id), **more)


def test_what_breaks_is_named_and_what_opens_is_counted() -> None:
    before = solved(check("a", 2.0), check("b", 2.0, "caution"), check("c", 0.5, "caution"), check("d", 0.5))
    after = solved(check("a", 0.5), check("b", 0.8, "caution"), check("c", 0.4, "caution"), check("d", 0.4))
    side = side_effects(before, after)
    assert side.breaks == ("a",) and [c.name for c in side.opens] == ["b"], "c and d were open before"
    assert side.counted == "opens 1 caution"
    assert side.words == "then not kept: a; opens 1 caution: b (−20 %)"


def test_what_a_change_is_made_for_is_no_side_effect() -> None:
    before = solved(check("a", 2.0), check("b", 2.0, "caution"))
    after = solved(check("a", 0.5), check("b", 0.5, "caution"))
    assert side_effects(before, after, ["bearings.a", "bearings.b"]) == NO_EFFECTS
    assert not side_effects(before, before).words and not NO_EFFECTS.counted


def test_a_limit_that_is_not_verified_any_more_says_so_and_a_step_that_is_lost_is_named() -> None:
    ends: dict[str, Any] = {"missing": ("a.b",), "at_best": 2.0, "at_worst": 0.5}
    side = side_effects(solved(check("a", 2.0)), solved(check("a", 0.9, **ends)))
    assert side.words == "then not kept: a (not verified)"
    assert side_effects(solved(), solved(lost="friction")).words == "then not kept: friction has no solution"


def test_of_many_the_first_are_named() -> None:
    names = "abcd"
    side = side_effects(solved(*(check(name, 2.0) for name in names)), solved(*(check(name, 0.5) for name in names)))
    assert side.words == "then not kept: a, b and 2 more"
    cautions = [[check(name, value, "caution") for name in names] for value in (2.0, 0.5)]
    assert side_effects(*(solved(*some) for some in cautions)).words.startswith("opens 4 cautions: ")
