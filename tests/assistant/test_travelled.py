# SPDX-License-Identifier: Apache-2.0
"""Undo and redo say what has changed, step by step and from what to what, and lead there."""

import pytest

from assistant.app import ContralberoApp
from assistant.session.session import Session
from assistant.session.travelled import Travelled, travelled
from assistant.widgets.headings import ArrayHeading
from calc.design.labels import Place
from calc.sheet.remedy import assignment
from tests.assistant.conftest import Screen
from tests.assistant.driving import settled, strike, told, until, work

ORDER_2 = "imbalance.order_2.couple"
MASSES: Place = ("shafts", 0, "masses")


def back_and_forth(session: Session) -> tuple[Travelled, Travelled]:
    """What an undo of the last edit comes to, and the redo of it."""
    after = session.history.state
    session.undo()
    before = session.history.state
    session.redo()
    return travelled(after, before), travelled(before, after)


def test_a_value_says_its_step_and_from_what_to_what(session: Session) -> None:
    for key, text, step, place, undone, redone in (
        ("engine.bore_mm", "95", "engine", ("engine", "bore_mm"), "bore 95 → 94 mm", "bore 94 → 95 mm"),
        ("engine.bore_mm", "95x", "engine", ("engine", "bore_mm"), "bore: “95x” is gone", "bore: “95x” is there again"),
        (
            "bearings.front.length_mm",
            "25",
            "bearings",
            ("shafts", 0, "bearings", 0, "length_mm"),
            "length of front 25 → 27.5 mm",
            "length of front 27.5 → 25 mm",
        ),
        ("name", "Other", "engine", ("name",), "name of the design Other → R753IE4", "→ Other"),
    ):
        session.edit(key, text)
        session.seal()
        undo, redo = back_and_forth(session)
        number = {"engine": "1 Engine: ", "bearings": "4 Bearings: "}[step]
        assert str(undo.words).startswith(number) and undone in str(undo.words), key
        assert str(redo.words).startswith(number) and redone in str(redo.words), key
        assert undo.step == redo.step == step and undo.place == redo.place == place
        session.undo()


def test_what_comes_and_goes_is_named(session: Session) -> None:
    def last(change: object) -> tuple[str, str]:
        undo, redo = back_and_forth(session)
        return str(undo.words), str(redo.words)

    session.seal()
    index = session.add(MASSES)
    undo, redo = back_and_forth(session)
    assert "3 Counter-shaft: Eccentric masses: rear-2 is gone" == str(undo.words) and undo.place == MASSES
    assert "rear-2 is there" in str(redo.words) and redo.place == (*MASSES, index)
    assert last(session.toggle_lock("engine.bore_mm")) == (
        "1 Engine: bore is not locked",
        "1 Engine: bore is locked",
    )  # and nothing of the oil, which is locked as a rule
    assert last(session.toggle_lock("bearings.oil")) == ("4 Bearings: oil is locked", "4 Bearings: oil is not locked")
    assert last(session.leave_out("friction", "no need")) == (
        "6 Friction: not left out any more",
        "6 Friction: left out: no need",
    )
    session.apply([assignment(f"accepted.{ORDER_2}", "as in the engine that runs")])
    after = session.history.state
    session.undo()
    undo = travelled(after, session.history.state, {ORDER_2: "Second-order couple left"}.__getitem__)  # type: ignore[arg-type]
    assert str(undo.words) == "2 Imbalance: Second-order couple left is open"
    assert undo.check == ORDER_2 and undo.step == "imbalance" and undo.place == ()


def test_of_many_changes_three_are_named_by_their_steps(session: Session) -> None:
    session.apply(
        [
            "engine.bore_mm=96",
            "engine.rod_length_mm=160",
            "imbalance.crank_balance_fraction=0.4",
            "bearings.front.length_mm=24",
            "bearings.rear.length_mm=24",
        ]
    )
    undo, _ = back_and_forth(session)
    assert str(undo.words) == (
        "1 Engine: bore 96 → 94 mm, rod length 160 → 163 mm; 2 Imbalance: share balanced on the crank 0.4 → 0.5; 2 more"
    )
    assert undo.place == ("engine", "bore_mm")
    same = session.history.state
    assert travelled(same, same) == Travelled(travelled(same, same).words) and not travelled(same, same).words


@pytest.mark.slow
async def test_the_cursor_goes_where_it_was_undone(screen: Screen, light: Session) -> None:
    """From another step and another pane, into a fold, to an element, to a finding; behind a letter keys stay keys."""
    async with screen(size=(80, 24)) as pilot:
        app, bench = pilot.app, work(pilot)
        assert isinstance(app, ContralberoApp)
        folded = next(
            key
            for key in ("engine.rated_power_kW", "engine.flywheel_inertia_kgm2")
            if bench.form._parts.fold(light.place(key)) is not None
        )
        before = light.text(folded)
        light.edit(folded, "41")
        light.seal()
        light.edit("imbalance.crank_balance_fraction", "0.4")
        light.seal()
        light.apply([assignment(f"accepted.{ORDER_2}", "as in the engine that runs")])
        light.add(MASSES)
        light.solve()
        bench.rebuilt()
        await strike(pilot, "alt+1", "f4")
        await settled(pilot)

        await strike(pilot, "ctrl+z")
        await until(pilot, lambda: isinstance(app.focused, ArrayHeading) and bench.form.here() == MASSES)
        assert bench.number == 3 and "Undone: 3 Counter-shaft: Eccentric masses: rear-2 is gone" in told(pilot)
        light.solve()
        await strike(pilot, "ctrl+z")
        await until(pilot, lambda: bench.checks.has_focus and bench.checks.key == ORDER_2)
        assert bench.number == 2 and "Undone: 2 Imbalance: Second-order couple left is open" in told(pilot)
        await strike(pilot, "alt+1")
        await strike(pilot, "ctrl+z")
        share = light.place("imbalance.crank_balance_fraction")
        await until(pilot, lambda: bench.form.here() == share)
        assert "Undone: 2 Imbalance: share balanced on the crank 0.4 → 0.5" in told(pilot) and bench.number == 2
        await strike(pilot, "ctrl+z")
        await until(pilot, lambda: bench.form.here() == light.place(folded))
        assert bench.number == 1 and light.text(folded) == before
        bench.leave_pane()
        await strike(pilot, "r")
        await until(pilot, lambda: light.text(folded) == "41")
        assert app.focused is bench.form and bench.form.last == light.place(folded)
        await strike(pilot, "r")  # still a key
        await until(pilot, lambda: light.value("imbalance.crank_balance_fraction") == 0.4)
        assert "Done again: 2 Imbalance: share balanced on the crank 0.5 → 0.4" in told(pilot)
