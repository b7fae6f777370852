# SPDX-License-Identifier: Apache-2.0
"""The process that reads a stranger's file: whatever it does there, here is an answer in words."""

import os
import time

import pytest

from calc.design.limits import APPENDED_MEMORY
from reports.apart import Refused, apart


def length(raw: bytes, more: int) -> list[int]:
    return [len(raw), more]


def refuses(raw: bytes) -> None:
    raise Refused("is none of ours")


def breaks(raw: bytes) -> None:
    raise KeyError("x" * 1000)


def sleeps(raw: bytes) -> None:
    time.sleep(60)


def eats(raw: bytes) -> int:
    return len(bytearray(APPENDED_MEMORY))


def dies(raw: bytes) -> None:
    os._exit(1)


def test_what_the_task_gives_comes_back() -> None:
    assert apart(length, b"abc\0\xff", 7) == [5, 7]


@pytest.mark.parametrize(
    ("task", "why"),
    [
        (refuses, "^is none of ours$"),
        (breaks, r"^can not be read \(KeyError: 'x{60,80}$"),
        (sleeps, "^takes more than 2 s to read$"),
        pytest.param(
            eats, "MemoryError", marks=pytest.mark.skipif(os.name != "posix", reason="limits no memory of a process")
        ),
        (dies, "broke its reader"),
    ],
)
def test_what_breaks_there_is_refused_here(task: object, why: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("reports.apart.APPENDED_SECONDS", 2)
    with pytest.raises(Refused, match=why):
        apart(task, b"%PDF-1.7")  # type: ignore[arg-type]
