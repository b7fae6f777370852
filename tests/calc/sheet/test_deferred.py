# SPDX-License-Identifier: Apache-2.0
"""What is made when somebody looks at it is the same made meanwhile by a copy of the process."""

import os
import sys

import pytest

from calc.sheet.deferred import Later
from calc.sheet.errors import NoSolution

CAN = sys.platform == "linux" and len(os.sched_getaffinity(0)) > 1


def test_it_is_the_same_made_meanwhile() -> None:
    later = Later(lambda: (2.5, "two"))
    later.meanwhile()
    assert tuple(later) == (2.5, "two") and len(later) == 2


@pytest.mark.skipif(not CAN, reason="one core, or no fork")
def test_another_process_makes_it() -> None:
    later = Later(lambda: (os.getpid(),))
    later.meanwhile()
    assert later[0] != os.getpid()


def test_what_is_made_is_not_made_again() -> None:
    asked: list[int] = []

    def make() -> tuple[int]:
        asked.append(1)
        return (7,)

    later = Later(make)
    assert tuple(later) == (7,)
    later.meanwhile()
    assert tuple(later) == (7,) and asked == [1]


def test_what_can_not_be_made_is_not_there() -> None:
    def make() -> tuple[int, ...]:
        raise NoSolution("a figure", "has no numbers", "give some")

    later = Later(make)
    later.meanwhile()
    assert tuple(later) == ()
