# SPDX-License-Identifier: Apache-2.0
"""What is assumed, numbered, and what it puts at risk: of checks that are made here, and of the shipped design."""

from math import nan

from calc.sheet.check import Check, CheckRule, Missing
from calc.sheet.text import Text
from calc.studies.assumptions import assumptions

RULE = CheckRule("made.assumed.N", "limit", "Made here.", Text("Gap"), ">=", "µm", role="physics")


def made(name: str, value: float, best: object, worst: object, taken: str = "a runout of 20 µm") -> Check:
    missing = Missing(("gears.runout_um",), (Text(taken),), best, worst)  # type: ignore[arg-type]
    return RULE(value, 1e-6, at=name, missing=missing)


def risk(*checks: Check) -> str:
    (one,) = assumptions(checks)
    return str(one.risk)


def test_they_are_numbered_in_the_order_in_which_checks_rest_on_them() -> None:
    found = assumptions(
        [made("a", 5e-6, 9e-6, 2e-6, "one"), made("b", 5e-6, 9e-6, 2e-6, "two"), made("c", 5e-6, 9e-6, 2e-6, "one")]
    )
    assert [(one.name, str(one.words), len(one.checks)) for one in found] == [("A1", "one", 2), ("A2", "two", 1)]


def test_the_check_that_is_lost_worst_stands_for_the_others() -> None:
    said = risk(made("a", 5e-6, 9e-6, 0.5e-6), made("b", 5e-6, 9e-6, -3e-6), made("c", 5e-6, 9e-6, 2e-6))
    assert said == "Gap comes to −3 µm, needs ≥ 1 µm; 1 more"


def test_it_is_not_blamed_for_what_fails_at_its_best_too() -> None:
    fails = made("a", -5e-6, -2e-6, -9e-6)
    assert risk(fails) == "what fails on it fails at its best too"
    assert risk(fails, made("b", 5e-6, 9e-6, 0.5e-6)) == "Gap comes to 0.5 µm, needs ≥ 1 µm"


def test_what_nobody_knows_is_said_beside_what_is_lost() -> None:
    unknown = made("a", 5e-6, 9e-6, "none")
    assert risk(unknown) == "how far it goes nobody knows: gap"
    assert risk(unknown, made("b", 5e-6, 9e-6, -3e-6)).endswith("needs ≥ 1 µm; how far it goes nobody knows: gap")


def test_what_holds() -> None:
    assert risk(made("a", 5e-6, 9e-6, 2e-6)) == "all hold at its worst too"
    assert risk(made("a", 5e-6, "holds", 5e-6)) == "all hold with it, which is taken as the unfavourable end"
    assert not assumptions([RULE(5e-6, 1e-6, at="a"), RULE(nan, 1e-6, at="b")])
