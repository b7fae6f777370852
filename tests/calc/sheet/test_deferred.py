# SPDX-License-Identifier: Apache-2.0
"""What is made when somebody looks at it is made once."""

from calc.sheet.deferred import Later
from calc.sheet.errors import NoSolution


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
