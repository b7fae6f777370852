# SPDX-License-Identifier: Apache-2.0
"""A replay recorded from a session comes to the same design and the same results."""

import tomllib
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from assistant.session.recording import Recording, step
from assistant.session.session import Session
from calc.design import replay
from calc.design.toml_file import Document
from calc.solve import solve
from tests.command import run

BORE, ROD = "engine.bore_mm", "engine.rod_length_mm"


def recorded(session: Session, path: Path) -> replay.Script:
    """The replay of what was done in a session, written and read back."""
    assert session.recording is not None
    session.solve()
    assert session.results is not None
    path.write_text(session.recording.text(session.results), encoding="utf-8")
    return replay.load(path)


def end(script: replay.Script) -> dict[str, object]:
    """The design that a replay comes to."""
    history = [script.start]
    for row in script.steps:
        history = history[:-1] if "undo" in row else [*history, replay.played(history[-1], row)]
    return history[-1].data


@pytest.mark.slow
def test_edits_of_all_kinds_play_to_the_same_values(session: Session, tmp_path: Path) -> None:
    session.edit(BORE, "93")  # before the recording: a part of where it begins
    session.record()
    for text in ("1", "16", "164"):
        session.edit(ROD, text)  # one step, the states on the way are not recorded
    session.edit("bearings.front.length_mm", "34")
    session.edit("gears.wheels.shaft.teeth", "x")  # not understood: in no step
    session.edit("gears.wheels.shaft.teeth", str(session.value("gears.wheels.shaft.teeth")))  # as it was
    index = session.add("countershaft.masses")
    session.edit(("shafts", 0, "masses", index, "mass_kg"), "0.25")
    session.put_table(("shafts", 0, "holes"), False)
    session.edit("imbalance.crank_balance_fraction", "0.45")
    session.undo()
    session.apply(["bearings.oil=SAE 50", "bearings.front.clearance_factor=0.64", "bearings.rear.clearance_um="])
    session.edit(BORE, "-3")  # at the moment of stopping
    assert session.recording is not None
    data = session.recording.end
    session.undo()
    script = recorded(session, tmp_path / "r.toml")
    assert script.start.data["engine"]["bore_mm"] == 93.0
    assert script.steps[0] == {"set": ROD, "to": 164.0}
    assert script.steps[1] == {"set": "shafts.shaft.bearings.front.length_mm", "to": 34.0}
    kinds = [row.get("set", row.get("unset", "undo")) for row in script.steps]
    assert kinds[2:4] == [
        "shafts.shaft.masses",
        f"shafts.shaft.masses.{data['shafts'][0]['masses'][index]['name']}.mass_kg",
    ]
    assert kinds[4:7] == ["shafts.shaft.holes", "imbalance.crank_balance_fraction", "undo"]
    assert kinds[7] == {"bearings.oil": "SAE 50", "shafts.shaft.bearings.front.clearance_factor": 0.64}
    assert len(kinds) == 8
    assert end(script) == data == session.data
    compared = replay.run(script, solve)
    assert all(c.agrees for c in compared), [c.text for c in compared]
    assert session.results is not None and [row["design"] for row in script.expects if "design" in row] == [
        session.results.verdict
    ]
    assert all(row["kind"] == replay.RECORDED for row in script.expects)
    assert {row["step"] for row in script.expects if "step" in row} == {s.key for s in session.design.asked()}
    assert {row["value"] for row in script.expects if "value" in row} >= {"engine.stroke", "friction.total_loss"}
    assert any("check" in row for row in script.expects)
    done = run("replay", tmp_path / "r.toml")
    assert done.returncode == 0 and f"{len(compared)} of {len(compared)} as expected" in done.stdout


def test_what_is_invalid_on_the_way_goes_into_the_next_step(session: Session, tmp_path: Path) -> None:
    session.record()
    session.put_table(("engine", "gas"), True)  # its keys are missing
    session.edit("engine.gas.peak_pressure_bar", "85")
    session.edit("engine.gas.compression_ratio", "10")
    session.undo()
    session.redo()
    script = recorded(session, tmp_path / "r.toml")
    assert script.steps == ({"set": "engine.gas", "to": {"peak_pressure_bar": 85.0, "compression_ratio": 10.0}},)
    session.undo()
    session.undo()
    session.undo()
    assert session.recording is not None and session.recording.steps()[1:] == [{"undo": True}]


def test_undo_behind_the_beginning_and_redo_are_edits(session: Session, tmp_path: Path) -> None:
    session.edit(BORE, "95")
    session.record()
    session.undo()
    session.redo()
    session.edit(ROD, "170")
    session.undo()
    script = recorded(session, tmp_path / "r.toml")
    assert script.steps == (
        {"set": BORE, "to": 94.0},
        {"set": BORE, "to": 95.0},
        {"set": ROD, "to": 170.0},
        {"undo": True},
    )
    assert end(script) == session.data


def test_an_edit_that_is_typed_back_is_no_step(session: Session) -> None:
    session.record()
    session.edit(BORE, "95")
    session.edit(ROD, "x")
    session.edit(ROD, "170")  # not a part of the bore's step
    session.edit(ROD, "165")
    session.seal()
    session.edit(BORE, "9")
    session.edit(BORE, "95")
    assert session.recording is not None
    assert session.recording.steps() == [{"set": BORE, "to": 95.0}, {"set": ROD, "to": 165.0}]


def test_steps_come_and_go_whole(session: Session, tmp_path: Path) -> None:
    session.record()
    for key in ("friction", "gears"):
        session.put_table((key,), False)
    assert not session.ask("gears")
    session.remove("countershaft.masses", 0)
    session.edit("countershaft.masses.0.name", "front")
    script = recorded(session, tmp_path / "r.toml")
    assert script.steps[:2] == ({"unset": "friction"}, {"unset": "gears"})
    assert script.steps[2] == {"set": "gears", "to": session.data["gears"]}
    assert end(script) == session.data
    assert all(c.agrees for c in replay.run(script, solve))


def test_a_renamed_element_with_other_changes_is_set_in_the_table_of_its_step() -> None:
    before = {"schema": 2, "name": "x", "shafts": [{"masses": [{"name": "a", "mass_kg": 1.0, "z_mm": 1.0}]}]}
    after = {"schema": 2, "name": "x", "shafts": [{"masses": [{"name": "b", "mass_kg": 2.0, "z_mm": 1.0}]}]}
    assert step(before, after) == {"set": "shafts", "to": after["shafts"]}


NAMES = st.sampled_from(["a", "b", "0", "1"])
MASSES = st.lists(st.fixed_dictionaries({"name": NAMES}, optional={"mass_kg": st.floats(0.1, 2.0)}), max_size=3)
TABLES = st.fixed_dictionaries(
    {},
    optional={
        "note": NAMES,
        "shafts": st.lists(
            st.fixed_dictionaries(
                {"name": NAMES}, optional={"masses": MASSES, "holes": st.just({}), "material": NAMES}
            ),
            max_size=2,
        ),
        "oil": st.lists(
            st.fixed_dictionaries({"name": st.sampled_from(["our 10W-40", "a.b", ""])}, optional={"source": NAMES}),
            max_size=2,
        ),
        "engine": st.fixed_dictionaries({}, optional={"firing_order": st.lists(st.integers(1, 3), max_size=3)}),
    },
)


@settings(max_examples=150, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(st.lists(st.tuples(TABLES, st.booleans()), min_size=1, max_size=6))
def test_any_way_is_played_to_the_same_tables(way: list[tuple[dict[str, object], bool]]) -> None:
    recording = Recording({"schema": 2})
    for tables, joined in way:
        if not joined:
            recording.close()
        recording.edited({"schema": 2, **tables})
    history = [Document({"schema": 2})]
    for row in recording.steps():
        assert "undo" not in row
        history.append(replay.played(history[-1], row))
    assert history[-1].data == recording.end == {"schema": 2, **way[-1][0]}


def test_the_file_is_whole_toml_with_every_number(session: Session) -> None:
    session.record()
    session.edit(ROD, "165.123456789012345")
    session.solve()
    assert session.recording is not None and session.results is not None
    found = tomllib.loads(session.recording.text(session.results))
    assert found["schema"] == 2 and found["step"][0]["to"] == 165.123456789012345
    values = {row["value"]: row for row in found["expect"] if "value" in row}
    stroke = session.values()["engine.stroke"]
    assert values["engine.stroke"] == {
        "value": "engine.stroke",
        "is": stroke.shown,
        "unit": stroke.unit,
        "rel": 1e-6,
        "kind": "recorded",
    }


def test_every_step_stands_under_its_own_header(session: Session) -> None:
    session.record()
    session.edit(ROD, "170")
    session.put_table(("shafts", 0, "holes"), False)
    session.apply(["bearings.oil=SAE 50", "bearings.front.clearance_factor=0.64"])
    session.remove("gears.meshes", 0)
    session.ask("friction")
    session.undo()
    session.solve()
    assert session.recording is not None and session.results is not None
    text = session.recording.text(session.results)
    found = tomllib.loads(text)
    assert found["step"] == session.recording.steps() and found["design"] == session.recording.start
    assert text.count("[[step]]\n") == len(found["step"]) and text.count("[[expect]]\n") == len(found["expect"])
    assert '[[step]]\nset = "engine.rod_length_mm"\nto = 170.0\n' in text
