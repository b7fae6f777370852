# SPDX-License-Identifier: Apache-2.0
"""Changes of more than a field: elements of arrays, steps that are built, locks, and changes by key."""

from dataclasses import replace
from pathlib import Path

from assistant.session.recovery import Memory
from assistant.session.session import EXAMPLE, Session
from calc.design.toml_file import design


def test_elements_are_added_and_removed(session: Session) -> None:
    place = ("shafts", 0, "masses")
    assert session.add(place) == 2
    assert session.data["shafts"][0]["masses"][2]["name"] == "rear-2"
    assert session.valid
    session.remove(place, 0)
    assert [m["name"] for m in session.data["shafts"][0]["masses"]] == ["rear", "rear-2"]
    session.undo()
    session.undo()
    assert not session.dirty


def test_removing_the_last_element_leaves_the_key_out(session: Session) -> None:
    for _ in range(16):
        session.remove(("engine", "bench"), 0)
    assert "bench" not in session.data["engine"] and session.valid


def test_a_step_that_is_not_asked_can_be_asked(session: Session) -> None:
    data = {key: value for key, value in session.data.items() if key != "friction"}
    assert session.path is not None
    import tomli_w

    session.path.write_text(tomli_w.dumps(data), encoding="utf-8")
    other = Session.open(session.path, memory=session.memory, now=session.now)
    assert "friction" not in other.data
    assert not other.ask("friction")
    assert other.valid and other.data["friction"]["load_sharing"] == "linear"
    assert list(other.data)[-2:] == ["friction", "measured"]
    other.undo()
    assert "friction" not in other.data


def test_a_step_that_can_not_be_built_says_why_and_changes_nothing(session: Session) -> None:
    for key in ("friction", "bearings", "gears", "shafts"):
        session.put_table((key,), False)
    before = session.data
    assert "the step Counter-shaft comes first" in session.ask("bearings")
    assert session.data is before


def test_a_balancing_takes_the_place_of_the_shaft_in_one_step(session: Session) -> None:
    before = session.data
    assert not session.ask("countershaft", "half")
    assert session.valid and "bearings" not in session.data and "countershaft" in session.data["without"]
    session.undo()
    assert session.data == before


def test_a_lock_is_one_step_of_the_undo_and_goes_by_the_name_of_its_element(tmp_path: Path) -> None:
    session = Session.open(EXAMPLE, memory=Memory(tmp_path))
    place = session.place("gears.wheels.2.span_allowance_um")
    assert session.lock_reason("bearings.oil") == "the oil is the engine's" and session.lock_reason(place) == ""
    session.toggle_lock(place, "the wheel is bought")
    assert session.valid and session.data["locked"]["gears.wheels.idler.span_allowance_um"] == "the wheel is bought"
    assert session.lock_reason("gears.wheels.idler.span_allowance_um") and session.lock_reason("bearings.oil")
    session.toggle_lock("bearings.oil")
    assert not session.lock_reason("bearings.oil") and session.lock_reason(place)
    session.undo()
    session.undo()
    assert "locked" not in session.data


def test_what_is_typed_and_not_understood_survives_a_change_elsewhere(session: Session) -> None:
    session.edit("bearings.front.length_mm", "long")
    session.apply(["bearings.rear.length_mm=31"])
    assert session.text("bearings.front.length_mm") == "long" and session.value("bearings.rear.length_mm") == 31
    session.apply(["bearings.front.length_mm=32"])
    assert session.text("bearings.front.length_mm") == "32" and session.valid


def test_what_was_built_for_an_earlier_design_is_not_taken(session: Session) -> None:
    plan = session.plan("countershaft", "half")
    session.edit("engine.bore_mm", "95")
    before = session.data
    assert not plan.why and "changed meanwhile" in session.take(plan)
    assert session.data is before


def test_an_edit_reads_again_what_it_has_changed_alone(session: Session) -> None:
    before = session.design
    session.edit("engine.bore_mm", "95")
    assert session.valid and session.design.engine != before.engine
    assert session.design.gears is before.gears and session.design.shafts[0] is before.shafts[0]
    session.edit("gears.helix_angle_deg", "200")  # not allowed, and what stands is what was valid last
    assert not session.valid and session.design.engine.bore == 0.095
    session.edit("gears.helix_angle_deg", "15")
    assert session.design == design(replace(session.document, former=None))
