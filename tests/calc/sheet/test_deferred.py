# SPDX-License-Identifier: Apache-2.0
"""What is made when somebody looks at it is made once."""

from dataclasses import replace

from calc.sheet.deferred import Later
from calc.sheet.errors import NoSolution
from tests.made_checks import made_check


def test_what_is_made_is_not_made_again() -> None:
    asked: list[int] = []

    def make() -> tuple[int]:
        asked.append(1)
        return (7,)

    later = Later(make)
    assert tuple(later) == (7,)
    assert tuple(later) == (7,) and asked == [1]


def test_what_can_not_be_made_is_not_there() -> None:
    def make() -> tuple[int, ...]:
        raise NoSolution("a figure", "has no numbers", "give some")

    later = Later(make)
    assert tuple(later) == ()


def test_whether_it_is_made_can_be_asked_without_making_it() -> None:
    later = Later(lambda: (7,))
    check = made_check("gears.crank_central.rattle", 80.0, 70.0)
    assert not later.is_made and replace(check, remedies=later).waits and not check.waits
    assert len(later) == 1
    assert later.is_made and not replace(check, remedies=later).waits
