# SPDX-License-Identifier: Apache-2.0
"""The main screens lead with numbers and pictures: how many words stand beside them."""

import re
import shutil
from pathlib import Path

import pytest
from textual.pilot import Pilot

from assistant.app import ContralberoApp
from assistant.screens.ready import ReadyScreen
from assistant.screens.workbench import Workbench
from assistant.session.recovery import Memory
from assistant.session.session import EXAMPLE, Session
from assistant.session.solving import Answer
from calc.design.model import STEPS
from tests.assistant.conftest import NOON, solved
from tests.assistant.driving import at_rest, screen_rows, until, work
from tests.assistant.test_snapshots import solved_once

MOST = 130
NUMBERS = 25  # that stand there at least
# A word: two letters or more, with what a hyphen joins to it.  No words are units, and what the user has typed: what
# stands in boxes, and the name of the file.
WORD = re.compile(r"[^\W\d_]{2,}(?:-[^\W\d_]+)*")
NUMBER = re.compile(r"\d+(?:[.,]\d+)?")
UNITS = {"mm", "µm", "kg", "kN", "rpm", "mrad", "kW", "MPa", "GPa", "ms", "Hz", "min", "bar"}
BOX = re.compile(r"\[[^\[\]]*\]")
EVERY = tuple(step.key for step in STEPS)
FULLEST = ("imbalance", "countershaft", "gears")
DESIGNS = ("r753ie4_gamma", "r753ie4_rolling", "twin_drive", "r753ie4_drive_over_speed")


def words_of(screen: str, file: str) -> list[str]:
    text = "\n".join(BOX.sub(" ", row) for row in screen.replace(file, "").splitlines())
    return [word for word in WORD.findall(text) if word not in UNITS]


def test_what_is_counted_as_a_word() -> None:
    row = " my-3.toml  Length [27.5 ] mm · counter-shaft, z 25 · film 7.4 of 9 µm [10W-40 Q8 oil ▼]"
    assert words_of(row, "my-3.toml") == ["Length", "counter-shaft", "film", "of"]


@pytest.mark.parametrize(
    ("name", "steps"),
    [("r753ie4_gamma", FULLEST), *(pytest.param(name, EVERY, marks=pytest.mark.slow) for name in DESIGNS)],
)
async def test_a_main_screen_has_few_words(
    name: str, steps: tuple[str, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(Workbench, "_go_ahead", lambda self: None)  # the advice that a remedy replaces is longer
    path = tmp_path / f"{name}.toml"
    shutil.copy(EXAMPLE.with_name(path.name), path)
    session = Session.open(path, memory=Memory(tmp_path / "state"), now=lambda: NOON)
    assert session.accept(Answer(session.generation, solved_once(EXAMPLE.with_name(path.name)), 0.64))
    counted = {}
    async with ContralberoApp(session).run_test(size=(120, 40)) as pilot:
        await solved(pilot)
        for step in (step for step in STEPS if step.key in steps):
            await work(pilot).open_step(step)
            await solved(pilot)
            counted[step.key] = await _seen(pilot, path.name)
        await work(pilot).run_action("ready")
        await until(pilot, lambda: isinstance(pilot.app.screen, ReadyScreen))
        counted["ready"] = await _seen(pilot, path.name)
    assert list(counted) == [*steps, "ready"]
    assert {key: n for key, (n, _) in counted.items() if n > MOST} == {}
    assert min(numbers for _, numbers in counted.values()) >= NUMBERS


async def _seen(pilot: Pilot[int], file: str) -> tuple[int, int]:
    await at_rest(pilot)
    screen = "\n".join(screen_rows(pilot))
    return len(words_of(screen, file)), len(NUMBER.findall(screen))
