# SPDX-License-Identifier: Apache-2.0
"""Every shipped replay typed into the form: the same numbers as without a screen."""

from pathlib import Path
from typing import Any

import pytest
from textual.pilot import Pilot

from assistant.app import ContralberoApp
from assistant.screens.workbench import Workbench
from assistant.session.numbers import written
from assistant.session.places import described
from assistant.session.recovery import Memory
from assistant.session.session import Session
from assistant.widgets.entry import Choice, Entry
from assistant.widgets.headings import ArrayHeading
from calc.design.replay import Script, compare, load
from calc.design.toml_file import design as checked
from calc.design.upgrade import PAIR
from calc.solve import Results, solve
from tests.assistant.conftest import solved
from tests.assistant.driving import go_to, settled, strike, type_in, until, work
from tests.conftest import ROOT

REPLAYS = sorted((ROOT / "tests" / "replays").glob("*.toml"))


async def enter(pilot: Pilot[int], key: str, value: Any) -> None:
    """Type a value into the field of a key, or choose it from the list that the field opens."""
    session = work(pilot).session
    text = written(value, described(session.place(key)))
    box = await go_to(pilot, key)
    if isinstance(box, Choice):
        await strike(pilot, "space")
        await pilot.pause()
        await type_in(pilot, text)  # letters find a word
        await strike(pilot, "enter")
        await pilot.pause()
    else:
        assert isinstance(box, Entry)
        await type_in(pilot, text)
        await strike(pilot, "enter")
    await until(pilot, lambda: session.text(key) == text)
    assert not session.reasons()


async def without_twin(pilot: Pilot[int]) -> None:
    """What schema 1 had as a key, pair = "no", is − on the second shaft of the list."""
    await go_to(pilot, "shafts.twin.name")
    next(heading for heading in work(pilot).form.query(ArrayHeading) if heading.row.place == ("shafts",)).focus()
    await strike(pilot, "minus")
    await settled(pilot)


def same(ours: Results, theirs: Results) -> None:
    """Every value and every verdict."""
    a, b = ours.values(), theirs.values()
    assert a.keys() == b.keys()
    for id, value in a.items():
        other = b[id]
        assert value.unit == other.unit, id
        assert value.shown == pytest.approx(other.shown, rel=1e-12, abs=0, nan_ok=True), id
    assert {c.id: c.verdict for c in ours.checks()} == {c.id: c.verdict for c in theirs.checks()}


def agree(script: Script, session: Session, number: int) -> int:
    """What the replay expects after this many steps; gives how many expectations that were."""
    assert session.current and session.results is not None
    rows = [row for row in script.expects if row.get("after", len(script.steps)) == number]
    missed = [found.text for row in rows if not (found := compare(session.results, row)).agrees]
    assert not missed, missed
    return len(rows)


SHORT = ("twin_force_shaft",)
# the others are those of `contralbero replay`
TYPED = [path for path in REPLAYS if any("set" in step for step in load(path).steps)]


@pytest.mark.parametrize(
    "path",
    [p if p.stem in SHORT else pytest.param(p, marks=pytest.mark.slow) for p in TYPED],
    ids=lambda path: path.stem,
)
async def test_a_replay_is_typed_into_the_form(path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Workbench, "_go_ahead", lambda self: None)
    script = load(path)
    file = tmp_path / "replayed.toml"
    file.write_bytes(script.start.raw)
    session = Session.open(file, memory=Memory(tmp_path / "state"))
    headless = [script.start]
    expected, awaited = 0, {len(script.steps), *(row.get("after", 0) for row in script.expects)}
    async with ContralberoApp(session).run_test(size=(120, 40)) as pilot:
        await solved(pilot)
        expected += agree(script, session, 0)
        for number, step in enumerate(script.steps, 1):
            if "set" in step:
                await (without_twin(pilot) if step["set"] == PAIR else enter(pilot, step["set"], step["to"]))
                headless.append(headless[-1].with_value(step["set"], step["to"]))
            elif "undo" in step:
                await strike(pilot, "ctrl+z")
                await settled(pilot)
                headless.pop()
            else:
                continue  # paper has tests of its own
            assert session.data == headless[-1].data
            if number in awaited:
                await solved(pilot)
                expected += agree(script, session, number)
        assert session.results is not None
        same(session.results, solve(checked(headless[-1])))
    assert expected == len(script.expects) > 0
