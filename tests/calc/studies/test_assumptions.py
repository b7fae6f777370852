# SPDX-License-Identifier: Apache-2.0
"""What is assumed, numbered, and what it puts at risk: of checks that are made here, and of the shipped design."""

from calc.sheet.check import Check
from calc.sheet.text import Text
from calc.studies.assumptions import assumptions
from tests.made_checks import made_check


def made(value: float, best: object, worst: object, taken: str = "a runout of 20 µm") -> Check:
    """A gap in µm that needs at least 1."""
    ends = dict(at_best=best, at_worst=worst, missing=("gears.runout_um",), taken=(Text(taken),))
    return made_check(value, unit="µm", name=Text("Gap"), **ends)


def risk(*checks: Check) -> str:
    (one,) = assumptions(checks)
    return str(one.risk)


def test_they_are_numbered_in_the_order_in_which_checks_rest_on_them() -> None:
    found = assumptions([made(5.0, 9.0, 2.0, "one"), made(5.0, 9.0, 2.0, "two"), made(5.0, 9.0, 2.0, "one")])
    assert [(one.name, str(one.words), len(one.checks)) for one in found] == [("A1", "one", 2), ("A2", "two", 1)]


def test_the_check_that_is_lost_worst_stands_for_the_others() -> None:
    said = risk(made(5.0, 9.0, 0.5), made(5.0, 9.0, -3.0), made(5.0, 9.0, 2.0))
    assert said == "Gap comes to −3 µm, needs ≥ 1 µm; 1 more"


def test_it_is_not_blamed_for_what_fails_at_its_best_too() -> None:
    fails = made(-5.0, -2.0, -9.0)
    assert risk(fails) == "what fails on it fails at its best too"
    assert risk(fails, made(5.0, 9.0, 0.5)) == "Gap comes to 0.5 µm, needs ≥ 1 µm"


def test_what_nobody_knows_is_said_beside_what_is_lost() -> None:
    unknown = made(5.0, 9.0, "none")
    assert risk(unknown) == "how far it goes nobody knows: gap"
    assert risk(unknown, made(5.0, 9.0, -3.0)).endswith("needs ≥ 1 µm; how far it goes nobody knows: gap")


def test_what_holds() -> None:
    assert risk(made(5.0, 9.0, 2.0)) == "all hold at its worst too"
    assert risk(made(5.0, "holds", 5.0)) == "all hold with it, which is taken as the unfavourable end"
    assert not assumptions([made_check(5.0), made_check(0.5)])
