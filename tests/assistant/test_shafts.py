# SPDX-License-Identifier: Apache-2.0
"""The list of shafts and their bearings: what the forms show, what + and − make, what follows a new name; and files of
schema 1, which have no words for all of it."""

import tomllib
from datetime import datetime
from pathlib import Path
from types import SimpleNamespace

import pytest

from assistant.screens.dialogs import Ask, Choose
from assistant.session.places import followed, further, further_shaft, less, ways_to_add, with_shafts, with_wheel
from assistant.session.recovery import Edits, Memory
from assistant.session.saving import NeedsUpgrade
from assistant.session.session import Session
from assistant.widgets.entry import Entry
from assistant.widgets.field import CellColumns, Field
from assistant.widgets.headings import ArrayHeading
from assistant.widgets.rows import Asked, FormRow, routed
from calc.design.addresses import Table, changed
from calc.design.labels import Place, label_of
from calc.design.model import STEPS
from calc.design.toml_file import design, parse
from calc.sheet.text import Text
from calc.studies.shipped import DESIGNS
from tests.assistant.conftest import Screen, solved
from tests.assistant.driving import go_to, rows, settled, strike, told, type_in, until, work
from tests.conftest import SCREENED

SHAFTS: Place = ("shafts",)
ROWS: Place = ("shafts", 0, "bearings")


def tables(name: str) -> Table:
    return parse((DESIGNS / f"{name}.toml").read_bytes(), name).data


def opened(name: str, memory: Memory, tmp_path: Path) -> Session:
    path = tmp_path / Path(f"{name}.toml").name
    path.write_bytes((DESIGNS / f"{name}.toml").read_bytes())
    return Session.open(path, memory=memory)


def form_of(key: str, data: Table, side: int = 1, shaft: int = 0, bearing: int = 0) -> list[FormRow]:
    step = next(step for step in STEPS if step.key == key)
    chosen = {SHAFTS: shaft, ROWS: bearing, (*SHAFTS, shaft, ROWS[-1]): bearing}
    return routed(step, data, Asked(chosen, side=side), ())


# --- forms


def test_one_shaft_has_one_line_more_than_its_fields() -> None:
    kinds = [(row.kind, row.place[-1]) for row in form_of("countershaft", tables("r753ie4_gamma"), side=2)]
    assert kinds[:8] == [
        ("array", "shafts"),
        ("field", "mode"),
        ("field", "outer_radius_mm"),
        ("field", "core_radius_mm"),
        ("field", "half_length_mm"),
        ("array", "bearings"),
        ("cells", "name"),
        ("cells", "position_mm"),
    ]
    assert not any(row.place == (*SHAFTS, 0) for row in form_of("countershaft", tables("r753ie4_gamma")))


def test_a_mirror_image_shows_its_few_fields_and_whose_all_else_is() -> None:
    shown = form_of("countershaft", tables(SCREENED), shaft=1)
    assert [(row.kind, row.place[-1]) for row in shown] == [
        ("array", "shafts"),
        ("field", "name"),
        ("field", "mirrors"),
        ("field", "axis_mm"),
        ("array", "loads"),
        ("original", 1),
    ]


@pytest.mark.parametrize("side", [1, 2])
def test_the_bearings_are_placed_in_step_3_and_judged_in_step_4(side: int) -> None:
    data = tables("r753ie4_gamma")
    for step, asked in (("countershaft", ["name", "position_mm"]), ("bearings", ["kind", "diameter_mm", "length_mm"])):
        found = [row.place[-1] for row in form_of(step, data, side) if row.place[: len(ROWS)] == ROWS]
        keys = [key for key in dict.fromkeys(found) if isinstance(key, str) and key != "bearings"]
        assert keys[: len(asked)] == asked and ("kind" in keys) is (step == "bearings")
    columns = [row for row in form_of("bearings", data, 2) if row.kind == "columns"]
    assert [str(column.about.label) for column in columns[0].inside] == ["Front bearing", "Rear bearing"]


def test_bearings_that_are_only_screened_have_their_sizes_in_step_3_and_nothing_else() -> None:
    data = tables(SCREENED)
    cells = [row.place[-1] for row in form_of("countershaft", data, 3) if row.place[: len(ROWS)] == ROWS]
    assert cells == ["bearings", "name", "position_mm", "kind", "diameter_mm", "length_mm"]


def test_what_stands_in_a_table_all_the_same_can_be_seen_and_taken_out(memory: Memory, tmp_path: Path) -> None:
    session = opened(SCREENED, memory, tmp_path)
    session.apply(["shafts.twin.gear_z_mm=3", "shafts.shaft.bearings.front.slope_mrad=0.1"])
    reasons = session.reasons()
    wrong = {("shafts", 1, "gear_z_mm"), (*ROWS, 0, "slope_mrad")}
    assert wrong <= reasons.keys() and "is that of its original, shaft" in reasons["shafts", 1, "gear_z_mm"]
    assert ("shafts", 1, "gear_z_mm") in [row.place for row in form_of("countershaft", session.data, shaft=1)]
    folded = [inner.place for row in form_of("countershaft", session.data) for inner in (row, *row.inside)]
    assert (*ROWS, 0, "slope_mrad") in folded
    for place in wrong:
        session.edit(place, "")
    assert session.valid


def test_one_shaft_needs_no_name_in_a_sentence() -> None:
    one, two = tables("r753ie4_gamma"), tables(SCREENED)
    assert str(label_of(one, "shafts.shaft.core_radius_mm")) == "core radius"
    assert str(label_of(one, "shafts.shaft.bearings.front.length_mm")) == "length of front"
    assert str(label_of(two, "shafts.twin.mirrors")) == "mirrors"


async def test_shafts_are_leafed_through_added_and_taken_out(screen: Screen, light: Session) -> None:
    async with screen() as pilot:
        await go_to(pilot, "countershaft.mode")
        form = work(pilot).form
        (heading,) = [one for one in form.query(ArrayHeading) if one.row.place == SHAFTS]
        assert isinstance(pilot.app.focused.parent, Field), "no − by mistake"  # type: ignore[union-attr]
        heading.focus()
        await strike(pilot, "plus")
        await until(pilot, lambda: isinstance(pilot.app.screen, Choose))
        await strike(pilot, "enter")
        await settled(pilot)
        assert light.data["shafts"][1] == {"name": "twin", "mirrors": "shaft"} and light.valid
        assert form.here() == (*SHAFTS, 1, "name") and "all else as shaft" in rows(pilot)
        await type_in(pilot, "left")
        await settled(pilot)
        assert light.data["shafts"][1]["name"] == "left" and "2/2 ▸" in rows(pilot)
        (heading,) = [one for one in form.query(ArrayHeading) if one.row.place == SHAFTS]
        heading.focus()
        await strike(pilot, "left")
        await settled(pilot)
        assert "1/2 ▸" in rows(pilot) and "all else as" not in rows(pilot)
        await strike(pilot, "right", "minus")
        await settled(pilot)
        assert len(light.data["shafts"]) == 1 and light.valid
        await strike(pilot, *["ctrl+z"] * 3)
        await settled(pilot)
        assert not light.dirty


@pytest.mark.slow
async def test_a_bearing_by_another_name_has_that_name_above_its_column(screen: Screen, session: Session) -> None:
    async with screen(size=(120, 40), session=session) as pilot:
        await go_to(pilot, "shafts.shaft.bearings.front.name")
        await type_in(pilot, "gear side")
        await go_to(pilot, "bearings.oil")
        columns = work(pilot).form.query_one(CellColumns)
        assert "Gear side" in columns.render().plain and "Rear" in columns.render().plain
        box = await go_to(pilot, "shafts.shaft.bearings.rear.hole_diameter_mm")
        field = work(pilot).form.field
        assert isinstance(box, Entry) and box.placeholder == "as all" and field is not None and not field.note()[0]
        await type_in(pilot, "3.5")
        assert field.note() == ("rules here", "muted")


# --- several shafts, one in view

FOUR = "../tests/data/upgraded/r754ie4_balance_shafts"  # screened, with its mirror image


def two_of_their_own(memory: Memory, tmp_path: Path) -> Session:
    """The pair with its twin as a shaft of its own, a little lighter."""
    session = opened(FOUR, memory, tmp_path)
    session.remove(SHAFTS, 1)
    session.add_shaft("shaft", "own")
    session.apply(["shafts.shaft-2.speed_ratio=-2", "shafts.shaft-2.masses.front.mass_kg=0.44"])
    session.edit((*SHAFTS, 1, "name"), "right")
    session.solve()
    assert session.valid and session.results is not None
    return session


@pytest.mark.parametrize(
    ("id", "moved_by", "shown"),
    [
        ("countershaft.right.fatigue", ("shafts.shaft.material",), 1),
        ("countershaft.shafts.clear", ("shafts.right.axis_mm",), 1),
        ("countershaft.shafts.clear", ("shafts.shaft.axis_mm", "shafts.right.axis_mm"), None),
        ("countershaft.roll", ("engine.bore_mm", "shafts.right.axis_mm"), None),
    ],
)
def test_a_finding_that_is_moved_by_one_shaft_alone_is_shown_there(
    session: Session, monkeypatch: pytest.MonkeyPatch, id: str, moved_by: tuple[str, ...], shown: int | None
) -> None:
    session.add_shaft("shaft", "own")
    session.edit((*SHAFTS, 1, "name"), "right")
    monkeypatch.setattr(session, "results", SimpleNamespace(checks=lambda: [SimpleNamespace(id=id, moved_by=moved_by)]))
    assert session.shaft_of_finding(id) == shown


def test_the_view_is_of_the_shaft_in_view_or_of_the_original_of_a_twin(memory: Memory, tmp_path: Path) -> None:
    pair = opened(FOUR, memory, tmp_path)
    pair.solve()
    first = pair.view("countershaft")
    pair.shaft = 1
    assert pair.original == "shaft" and pair.view("countershaft") is first is not None
    session = two_of_their_own(memory, tmp_path)
    forces = []
    for session.shaft in (0, 1):
        view = session.view("countershaft")
        assert view is not None and view.shaft is not None
        forces.append(view.shaft.force)
    assert forces[1] < forces[0] and session.shaft_of("countershaft.right.force") == 1
    assert session.shaft_of("countershaft.residual_order_2_force") is None
    session.undo()
    session.remove(SHAFTS, 1)
    assert session.shaft == 0


def test_a_twin_says_of_its_bearings_what_is_added(memory: Memory, tmp_path: Path) -> None:
    session = opened("r754ie4_balance_shafts", memory, tmp_path)
    there: Place = (*SHAFTS, 1, "bearings")
    assert session.add(there) == 0 and session.valid
    session.edit((*there, 0, "clearance_um"), "50")
    assert session.valid and session.add(there) == 1 and session.data["shafts"][1]["bearings"][1] == {"name": "middle"}
    session.remove(there, 1)
    judged = [(row.kind, row.place) for row in form_of("bearings", session.data, shaft=1)]
    assert judged[:5] == [
        ("leaf", SHAFTS),
        ("leaf", there),
        ("field", (*there, 0, "clearance_um")),
        ("field", (*there, 0, "clearance_factor")),
        ("original", (*SHAFTS, 1)),
    ]
    placed = [(row.kind, row.place[-1]) for row in form_of("countershaft", session.data, shaft=1)]
    assert placed[-4:] == [("array", "bearings"), ("heading", 0), ("field", "name"), ("original", 1)]
    session.edit((*ROWS, 0, "name"), "fore")
    assert session.valid and session.data["shafts"][1]["bearings"] == [{"name": "fore", "clearance_um": 50.0}]
    session.put_table(("bearings",), False)
    assert "bearings" not in session.data["shafts"][1]  # which are not judged any more
    session.undo()
    session.remove(ROWS, 0)
    assert "bearings" not in session.data["shafts"][1]  # of which the one is gone
    session.undo()
    session.solve()
    session.shaft = 1
    views = [session.view(step) for step in ("countershaft", "bearings")]
    assert [view.design.own_name for view in views if view is not None] == ["left", "right"]


def test_what_is_typed_for_a_bearing_of_a_twin_is_said_of_that_one(memory: Memory, tmp_path: Path) -> None:
    """Its form has a row for each bearing of the original, in places that stay where they are."""
    session, there = opened("r754ie4_balance_shafts", memory, tmp_path), (*SHAFTS, 1, "bearings")
    place: Place = (*there, 1, "clearance_um")
    assert place in [row.place for row in form_of("bearings", session.data, shaft=1, bearing=1)]
    assert session.place("shafts.right.bearings.middle.clearance_um") == place
    assert str(label_of(session.data, "shafts.right.bearings.middle.clearance_um")).endswith(" of right middle")
    session.edit(place, "90")
    assert session.valid and session.value("shafts.right.bearings.middle.clearance_um") == 90
    assert session.design.shafts[1].bearings[1].clearance == pytest.approx(90e-6)
    assert [row["name"] for row in session.value(there)] == ["front", "middle", "rear"]
    session.edit(place, "")
    assert session.valid and session.value(there) is None  # all as the original again


def test_what_a_row_says_of_its_supply_stands_in_a_fold_with_what_that_needs() -> None:
    data = tables("r753ie4_gamma")
    grooved = changed(data, (*ROWS, 0, "supply"), "groove")
    shown = []
    for there in (data, grooved):
        inside = {field.place for row in form_of("bearings", there) for field in row.inside if row.kind == "fold"}
        shown.append([key for key in ("hole_diameter_mm", "groove_width_mm") if (*ROWS, 0, key) in inside])
    assert shown == [["hole_diameter_mm"], ["groove_width_mm"]]


def test_ids_of_what_is_accepted_and_measured_have_a_shafts_name_beside_another(session: Session) -> None:
    session.solve()
    ids = ["countershaft.slope_front", "bearings.front.mckee", "countershaft.residual", "gears.crank-idler.sliding"]
    session.apply(f'accepted.{id}="seen"' for id in ids)
    values = ["countershaft.force", "countershaft.residual_order_1_couple"]
    rows = ", ".join(f"{{value='{value}', is=1.0}}" for value in values)
    session.apply([f"measured=[{rows}]"])
    before = session.data
    session.add_shaft("shaft", "mirrors")
    named = ["countershaft.shaft.slope_front", "bearings.shaft.front.mckee"]
    assert list(session.data["accepted"]) == [*named, *ids[2:]]
    assert [row["value"] for row in session.data["measured"]] == ["countershaft.shaft.force", values[1]]
    session.edit((*SHAFTS, 0, "name"), "left")
    session.edit((*ROWS, 0, "name"), "fore")
    assert list(session.data["accepted"])[:2] == ["countershaft.left.slope_fore", "bearings.left.fore.mckee"]
    session.undo()
    session.undo()
    session.remove(SHAFTS, 1)
    assert session.data == before
    session.undo()
    session.undo()
    assert session.data == before


@pytest.mark.parametrize("what, sense", [("mirrors", -1), ("repeats", 1)])
def test_a_twin_has_a_wheel_that_turns_it_as_it_must_and_takes_it_along(
    session: Session, what: str, sense: int
) -> None:
    before = session.data
    session.add_shaft("shaft", what)
    session.edit((*SHAFTS, 1, "axis_mm"), "10, 200")
    assert session.valid and session.design.gears is not None
    tree = session.design.gears.tree
    own, further = (session.design.gears.carrier(name) for name in ("shaft", "twin"))
    assert own != further and tree.senses[further] == sense * tree.senses[own]
    assert tree.turns(further) == tree.turns(own)
    session.remove(SHAFTS, 1)
    assert session.data["gears"] == before["gears"] and session.valid
    for _ in range(3):
        session.undo()
    assert session.data == before


def test_the_wheel_of_a_mirror_image_that_the_originals_does_not_meet_has_one_idler_more(
    memory: Memory, tmp_path: Path
) -> None:
    """As the pair is shipped: the axes stand 190 mm apart, two wheels 51."""
    session = opened("r754ie4_balance_shafts", memory, tmp_path)
    before = session.data["gears"]
    session.remove(SHAFTS, 1)
    assert [wheel["name"] for wheel in session.data["gears"]["wheels"]] == ["crank", "left-idler", "left"]
    session.add_shaft("left", "mirrors")
    gears = session.data["gears"]
    assert session.valid and session.data["shafts"][1]["name"] == "right"
    assert [wheel["name"] for wheel in gears["wheels"]][3:] == ["right-idler", "right-idler-2", "right"]
    assert [wheel["teeth"] for wheel in gears["wheels"]] == [wheel["teeth"] for wheel in before["wheels"]]
    assert [mesh["tolerance_um"] for mesh in gears["meshes"]] == [mesh["tolerance_um"] for mesh in before["meshes"]]
    session.remove(SHAFTS, 1)
    session.apply(["gears.wheels.left-idler.position_mm=[10.0, -60.0]"])
    session.add_shaft("left", "mirrors")
    places = {wheel["name"]: wheel.get("position_mm") for wheel in session.data["gears"]["wheels"]}
    assert places["right-idler"] == [10.0, 60.0] and places["right-idler-2"] is None
    session.apply(['friction.other_losses=[{name="pump", wheel="right-idler", power_W=50.0}]'])
    session.remove(SHAFTS, 1)
    assert [wheel["name"] for wheel in session.data["gears"]["wheels"]][3:] == ["right-idler"] and session.valid


def test_a_wheel_that_drives_others_stays_when_its_shaft_goes(session: Session) -> None:
    session.add_shaft("shaft", "own")
    session.apply(["gears.wheels.idler.shaft=shaft-2"])
    session.remove(SHAFTS, 1)
    assert all(wheel.get("shaft") != "shaft-2" for wheel in session.data["gears"]["wheels"]) and session.valid
    assert len(session.data["gears"]["wheels"]) == 4


def test_a_further_chain_turns_the_twin_of_a_shaft_that_a_chain_turns() -> None:
    stage = {"name": "chain", "driver": "crank", "driven": "left", "driver_teeth": 40, "driven_teeth": 20}
    left: Table = {"name": "left"}
    data: Table = {"shafts": [left, {"name": "right"}], "gears": {"stages": [stage]}}
    for what, side in (("mirrors", {"side": "outer"}), ("repeats", {})):
        turned = with_wheel(data, "right", "left", "left", what)
        assert turned["gears"]["stages"] == [stage, {**stage, "name": "chain-2", "driven": "right", **side}]
        assert with_shafts(turned, [left], ())["gears"] == data["gears"]
    renamed: Table = {**data, "shafts": [{"name": "low"}, {"name": "right"}]}
    assert followed(data, renamed, (*SHAFTS, 0, "name"))["gears"]["stages"] == [{**stage, "driven": "low"}]


@pytest.mark.parametrize("size", [(80, 24), pytest.param((120, 40), marks=pytest.mark.slow)])
async def test_everything_on_the_screen_is_of_the_shaft_in_view(
    screen: Screen, memory: Memory, tmp_path: Path, size: tuple[int, int]
) -> None:
    session = two_of_their_own(memory, tmp_path)
    async with screen(size=size, session=session) as pilot:
        await go_to(pilot, "shafts.shaft.masses.front.mass_kg")
        await solved(pilot)
        assert "▸ shaft" in rows(pilot) and "3 Balance shafts: shaft" in rows(pilot) and "^→ Shaft" in rows(pilot)
        await strike(pilot, "ctrl+right")
        await settled(pilot)
        assert work(pilot).form.here() == (*SHAFTS, 1, "masses", 0, "mass_kg")  # the same field, of the other
        await type_in(pilot, "0.43")
        await solved(pilot)
        assert session.data["shafts"][1]["masses"][0]["mass_kg"] == 0.43 and "▸ right" in rows(pilot)
        ids = [str(row[-1]) for row in work(pilot).curve_pane.leaves[-1].rows]
        assert "countershaft.right.force" in ids and "countershaft.residual_order_2_force" in ids
        assert not any(id.startswith("countershaft.shaft.") for id in ids)
        await strike(pilot, "f7")
        await until(pilot, lambda: work(pilot).checks.has_focus and bool(work(pilot).checks.key))
        seen = set()
        for _ in range(6):
            await strike(pilot, "f7")
            await settled(pilot)
            seen.add((work(pilot).checks.key.split(".")[1], session.shafts[session.shaft]))
        assert {("shaft", "shaft"), ("right", "right")} <= seen and not {("shaft", "right"), ("right", "shaft")} & seen
        await strike(pilot, "f7")
        before, finding = session.shaft, work(pilot).checks.key
        assert session.shaft_of(finding) == before
        await strike(pilot, "ctrl+right")
        work(pilot).checks.show_slopes(finding, Text("what moves it is known"))  # which makes the rows anew
        await settled(pilot)
        assert session.shaft != before and work(pilot).checks.key == finding


# --- elements


def test_a_further_shaft_is_a_twin_on_the_other_side_or_one_of_its_own_without_a_place() -> None:
    left: Table = {"name": "left", "axis_mm": [10.0, 50.0], "speed_ratio": -1}
    twin: Table = {"name": "right", "axis_mm": [10.0, -50.0]}
    assert further_shaft([left], "left", "mirrors") == {**twin, "mirrors": "left"}
    assert further_shaft([left], "left", "repeats") == {**twin, "repeats": "left"}
    assert further_shaft([left], "left", "own") == {"name": "left-2", "speed_ratio": -1}
    assert further_shaft([left], "left", "mirrors", ["right", "right-1"])["name"] == "right-2"  # wheels are called so
    there = [left, {"name": "right", "mirrors": "left"}]  # where the twin would stand
    further = further_shaft(there, "left", "repeats")
    assert further["axis_mm"] == [10.0, -100.0] and further_shaft([*there, further], "left", "repeats")["axis_mm"] == [
        10.0,
        -150.0,
    ]
    assert list(ways_to_add([left], "left")) == ["mirrors", "repeats", "own"]
    assert list(ways_to_add([left, {**twin, "mirrors": "left"}], "left")) == ["repeats", "own"]


def test_a_further_bearing_stands_in_the_widest_gap_and_takes_the_sizes_of_the_one_before() -> None:
    front: Table = {"name": "front", "position_mm": -100.0, "diameter_mm": 24.0, "slope_mrad": 0.1, "load_N": 3.0}
    there, index = further(ROWS, [front, {"name": "rear", "position_mm": 60.0}])
    assert index == 1 and there[1] == {"name": "middle", "position_mm": -20.0, "diameter_mm": 24.0}
    assert further(ROWS, there)[0][2]["name"] == "middle-2"
    unplaced: list[Table] = [{"name": "front"}, {"name": "rear"}]
    assert further(ROWS, unplaced) == ([*unplaced, {"name": "rear-2"}], 2)


def test_a_bearing_that_is_added_to_a_sound_shaft_leaves_it_sound(memory: Memory, tmp_path: Path) -> None:
    session = opened(SCREENED, memory, tmp_path)
    for _ in range(6):
        session.add(ROWS)
        assert session.valid, session.reasons()
    session.add(ROWS)
    assert "needs 2 to 9 rows [[shafts.bearings]]; has 10" in session.reason(ROWS)


def test_a_shaft_takes_its_mirror_image_with_it() -> None:
    there: list[Table] = [{"name": "a"}, {"name": "b", "mirrors": "a"}, {"name": "c"}]
    assert less(SHAFTS, there, 0) == [{"name": "c"}] and less(SHAFTS, there, 1) == [{"name": "a"}, {"name": "c"}]
    assert less(SHAFTS, [{"name": "a"}, {"name": "b", "repeats": "a"}], 0) == []


def test_what_names_a_shaft_or_locks_something_in_it_follows_its_name_letter_by_letter(session: Session) -> None:
    session.add_shaft("shaft", "mirrors")
    session.toggle_lock("bearings.front.length_mm")
    assert session.data["locked"].keys() >= {"shafts.shaft.bearings.front.length_mm"}
    for text in ("", "t", "tw", "twin", "twin-", "twin-1"):  # by way of the name of its mirror image
        session.edit((*SHAFTS, 0, "name"), text)
    assert session.valid and session.data["shafts"][1]["mirrors"] == "twin-1"
    assert [wheel.get("shaft") for wheel in session.data["gears"]["wheels"]] == [None, None, None, "twin-1", "twin"]
    session.edit((*ROWS, 0, "name"), "fore")
    assert session.lock_reason("shafts.twin-1.bearings.fore.length_mm")
    session.undo()
    session.undo()
    assert session.data["shafts"][1]["mirrors"] == "shaft" and session.lock_reason("bearings.front.length_mm")


def test_what_is_accepted_and_measured_of_a_bearing_follows_its_name() -> None:
    rows = [{"name": "front"}, {"name": "rear"}]
    ids = ["bearings.front.mckee", "countershaft.slope_front", "bearings.rear.mckee", "countershaft.holes.range"]
    values = ["countershaft.reaction_front_peak", "shafts.s.bearings.front.length_mm", "countershaft.reaction_rear"]
    before: Table = {
        "shafts": [{"name": "s", "bearings": rows}],
        "accepted": dict.fromkeys(ids, "seen"),
        "measured": [{"value": value} for value in values],
    }
    after = followed(before, changed(before, (*ROWS, 0, "name"), "a-1"), (*ROWS, 0, "name"))
    assert list(after["accepted"]) == ["bearings.a-1.mckee", "countershaft.slope_a-1", *ids[2:]]
    assert [row["value"] for row in after["measured"]] == [
        "countershaft.reaction_a-1_peak",
        "shafts.s.bearings.a-1.length_mm",
        "countershaft.reaction_rear",
    ]


def test_bolts_hold_a_shaft_by_its_new_name() -> None:
    before: Table = {"shafts": [{"name": "a", "bolts": {"carries": ["a", "b"]}}, {"name": "b", "mirrors": "a"}]}
    after = followed(before, changed(before, (*SHAFTS, 1, "name"), "c"), (*SHAFTS, 1, "name"))
    assert after["shafts"][0]["bolts"] == {"carries": ["a", "c"]}
    assert with_shafts(before, before["shafts"][:1], ())["shafts"] == [{"name": "a", "bolts": {"carries": ["a"]}}]


def test_a_name_is_followed_only_where_the_elements_are_the_same() -> None:
    before: Table = {"locked": {"shafts.a.material": ""}, "shafts": [{"name": "a"}, {"name": "b"}]}
    after: Table = {**before, "shafts": [{"name": "c"}]}
    assert followed(before, after, (*SHAFTS, 0, "name")) == after


def test_without_bearings_a_shaft_keeps_what_is_screened(session: Session) -> None:
    session.put_table(("bearings",), False)
    session.put_table(("friction",), False)
    assert session.valid and session.data["shafts"][0]["bearings"][0].keys() == {
        "name",
        "position_mm",
        "diameter_mm",
        "length_mm",
    }


# --- files of schema 1


def test_a_file_of_schema_1_stays_one_where_it_can_say_what_changed(session: Session, light: Session) -> None:
    session.edit("bearings.front.length_mm", "28.5")
    text = session.save().read_text("utf-8")
    assert "schema = 1" in text and "length_mm = 28.5" in text
    light.add_shaft("shaft", "mirrors")
    text = light.save().read_text("utf-8")
    assert "schema = 1" in text and 'pair = "yes"' in text


def test_where_it_can_not_a_save_asks_for_schema_2_and_keeps_the_comments(session: Session) -> None:
    before, comments = session.home.read_bytes(), session.home.read_text("utf-8").count("#")
    session.edit((*SHAFTS, 0, "name"), "left")
    with pytest.raises(NeedsUpgrade, match="contralbero upgrade"):
        session.save()
    assert session.home.read_bytes() == before and session.dirty
    document, _ = session.draft().solved()  # a report needs no schema
    assert document.data == session.data and document.former is None
    path = session.save(upgrade=True)
    text, data = path.read_text("utf-8"), session.data
    assert not session.dirty and path.with_name(f"{path.name}.bak").read_bytes() == before
    assert tomllib.loads(text) == data and data["schema"] == 2 and text.count("#") >= comments
    assert session.remark((*SHAFTS, 0, "half_length_mm")) == "assumed: up to the front journal"


@pytest.mark.parametrize("answer", ["enter", pytest.param("escape", marks=pytest.mark.slow)])
async def test_the_question_is_asked_and_no_work_is_lost(screen: Screen, light: Session, answer: str) -> None:
    async with screen() as pilot:
        await go_to(pilot, "shafts.shaft.name")
        await type_in(pilot, "left")
        await solved(pilot)
        await strike(pilot, "ctrl+s")
        await until(pilot, lambda: isinstance(pilot.app.screen, Ask))
        await strike(pilot, answer)
        await settled(pilot)
        assert light.value("shafts.0.name") == "left" and light.dirty is (answer == "escape")
        assert ("Saved" in told(pilot)) is (answer == "enter")
    assert tomllib.loads(light.home.read_text("utf-8"))["schema"] == (2 if answer == "enter" else 1)


def test_edits_that_version_0_1_kept_are_put_back_in_the_fields_of_today(session: Session) -> None:
    old = tomllib.loads(session.home.read_text("utf-8"))
    old["bearings"]["front"]["length_mm"] = 31.0
    typed: dict[Place, str] = {
        ("bearings", "rear", "length_mm"): "long",
        ("countershaft", "masses", 0, "mass_kg"): "2.5",
        ("countershaft", "bearing_positions_mm"): "no field any more",
    }
    session.memory.keep(session.home, Edits(old, datetime(2026, 1, 1), session.document.sha256, typed))
    later = Session.open(session.home, memory=session.memory)
    assert later.value("bearings.front.length_mm") == 31.0 and later.value("countershaft.masses.0.mass_kg") == 2.5
    assert later.text("bearings.rear.length_mm") == "long" and list(later.reasons()) == [(*ROWS, 1, "length_mm")]
    assert design(later.document).rows[0].length == pytest.approx(0.031)
