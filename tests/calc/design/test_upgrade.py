# SPDX-License-Identifier: Apache-2.0
"""Schema 1 in schema 2: the shipped designs of version 0.1, what is not well formed, old keys beside new designs."""

import contextlib
import copy
import math
import tomllib

import pytest
from hypothesis import given
from hypothesis import strategies as st

from calc.design.addresses import every, value_at
from calc.design.toml_file import design, parse, read
from calc.design.upgrade import (
    JOURNALS,
    PAIR,
    POSITIONS,
    SLOPES,
    current,
    formerly,
    own_key,
    renamed,
    rewritten,
    row_names,
    upgraded,
)
from calc.sheet.errors import BadInput
from calc.sheet.toml_scan import key_lines, remarks
from calc.solve import solve
from tests.conftest import ROOT

OLD, NEW = (ROOT / "tests" / "data" / name for name in ("designs_0_1", "upgraded"))
SHIPPED = sorted(path.name for path in OLD.glob("*.toml"))
GAMMA, R754 = "r753ie4_gamma.toml", "r754ie4_balance_shafts.toml"


def old(name: str) -> dict:
    return tomllib.loads((OLD / name).read_text(encoding="utf-8"))


def new(name: str) -> dict:
    return tomllib.loads((NEW / name).read_text(encoding="utf-8"))


def from_text(text: str):
    return upgraded(tomllib.loads(text), key_lines(text))


# --- whole designs


def test_there_are_sixteen() -> None:
    assert len(SHIPPED) == 16


@pytest.mark.parametrize("name", SHIPPED)
def test_a_shipped_design_is_upgraded(name: str) -> None:
    data = old(name)
    before = copy.deepcopy(data)
    it = upgraded(data, {})
    assert it.data == new(name)
    assert (it.errors, it.wrong) == ((), frozenset())
    assert data == before


@pytest.mark.parametrize("name", SHIPPED)
def test_every_key_of_the_new_design_has_the_line_of_the_old_one(name: str) -> None:
    text = (OLD / name).read_text(encoding="utf-8")
    it, lines = from_text(text), text.splitlines()
    known = {key for key in key_lines((NEW / name).read_text(encoding="utf-8"))}
    made = {"shafts.0.name", "shafts.0.bearings.0.name", "shafts.0.bearings.1.name", "shafts.0.bearings.2.name"}
    assert known - set(it.lines) <= made
    for key, line in it.lines.items():
        word = own_key(it.was, key).rpartition(".")[2]
        assert word.isdigit() or word in lines[line - 1] or word in ("position_mm", "diameter_mm", "length_mm"), key


def test_a_key_is_called_as_its_user_does() -> None:
    was = from_text((OLD / GAMMA).read_text(encoding="utf-8")).was
    assert own_key(was, "shafts.0.masses.1.mass_kg") == "countershaft.masses.1.mass_kg"
    assert own_key(was, "shafts.0.bearings.1.length_mm") == "bearings.rear.length_mm"
    assert own_key(was, "shafts.0.bearings.1.position_mm") == "countershaft.bearing_positions_mm.1"
    assert own_key(was, "shafts.0.bearings.1.slope_mrad") == "bearings.slope_mrad.1"
    assert own_key(was, "gears.wheels.3.shaft") == "gears.meshes.2.driven"
    assert own_key(was, "bearings.oil") == "bearings.oil"


def test_remarks_go_where_their_values_go() -> None:
    text = (OLD / GAMMA).read_text(encoding="utf-8")
    it = from_text(text)
    found = renamed(remarks(text), it.data, it.was)
    assert found["shafts.0.bearings.1.slope_mrad"] == "finite-element result of the source"
    assert found["shafts.0.bearings.0.position_mm"].startswith("assumed: the middle of the shaft midway")
    assert found["shafts.0.core_radius_mm"] == "core of the source's first alternative"


def test_bearings_alone_make_a_shaft_that_has_only_them() -> None:
    it = from_text(
        "schema = 1\n[bearings]\noil = 'x'\nslope_mrad = 0.1\n[bearings.front]\nload_N = 1\n[bearings.rear]\nload_N = 2\n"
    )
    rows = [{"name": "front", "load_N": 1, "slope_mrad": 0.1}, {"name": "rear", "load_N": 2, "slope_mrad": 0.1}]
    shaft = {"name": "shaft", "mode": "bearings", "bearings": rows}
    assert it.data == {"schema": 2, "shafts": [shaft], "bearings": {"oil": "x"}}
    assert own_key(it.was, "shafts.0.bearings.0.load_N") == "bearings.front.load_N"


def test_a_twin_stands_on_the_other_side() -> None:
    it = from_text("[countershaft]\nbearing_positions_mm = [0, 1]\npair = 'yes'\naxis_mm = [10.0, 20.5]\n")
    assert it.data["shafts"][1] == {"name": "twin", "mirrors": "shaft", "axis_mm": [10.0, -20.5]}
    assert own_key(it.was, "shafts.1.axis_mm") == "countershaft.axis_mm"
    assert from_text("[countershaft]\nbearing_positions_mm = [0, 1]\npair = 'no'\n").data["shafts"][1:] == []


@pytest.mark.parametrize(
    "count, names",
    [
        (2, "front rear"),
        (3, "front middle rear"),
        (4, "front second third rear"),
        (9, "front second third fourth fifth sixth seventh eighth rear"),
    ],
)
def test_rows_have_names(count: int, names: str) -> None:
    assert row_names(count) == tuple(names.split())


SHAFT = "[countershaft]\nmaterial = 'steel'\nbearing_positions_mm = [-1.0, 1.0]\n"
BEARINGS = "[bearings]\n[bearings.front]\n[bearings.rear]\n"


def test_keys_that_are_named_go_along() -> None:
    it = from_text(
        SHAFT + BEARINGS + "[locked]\ncountershaft = 'a'\nbearings = 'b'\n'bearings.oil' = 'c'\n"
        "'bearings.front.length_mm' = 'd'\n'countershaft.bearing_positions_mm' = 'e'\n'countershaft.pair' = 'f'\n"
        "'bearings.slope_mrad.1' = 'g'\n'countershaft.masses.front.z_mm' = 'h'\n"
        "[accepted]\n'bearings.front.film' = 'a'\n'countershaft.slope_front' = 'b'\n"
        "[optimise]\nlimits = ['bearings.front.*']\n[optimise.vary]\n'bearings.fits' = []\n'countershaft.core_radius_mm' = [1]\n"
        "'bearings.slope_mrad' = 'fixed'\n'countershaft.bearing_positions_mm' = [[-2, 2]]\n"
        "[[measured]]\nvalue = 'bearings.front.oil_flow'\n[[measured]]\nvalue = 'countershaft.material'\n"
    )
    assert it.data["locked"] == {
        "countershaft": "a",
        "bearings": "b",
        "bearings.oil": "c",
        "shafts.shaft.bearings.front.length_mm": "d",
        "shafts.shaft.bearings.front.position_mm": "e",
        "shafts.shaft.bearings.rear.position_mm": "e",
        "shafts.shaft.bearings.rear.slope_mrad": "g",
        "shafts.shaft.masses.front.z_mm": "h",
    }
    assert it.data["accepted"] == {"bearings.front.film": "a", "countershaft.slope_front": "b"}
    assert it.data["optimise"] == {
        "limits": ["bearings.front.*"],
        "vary": {
            "bearings.fits": [],
            "shafts.shaft.core_radius_mm": [1],
            "shafts.shaft.bearings.front.slope_mrad": "fixed",
            "shafts.shaft.bearings.rear.slope_mrad": "fixed",
            "countershaft.bearing_positions_mm": [[-2, 2]],
        },
    }
    assert [row["value"] for row in it.data["measured"]] == ["bearings.front.oil_flow", "shafts.shaft.material"]
    assert own_key(it.was, "locked.shafts.shaft.bearings.front.length_mm") == "locked.bearings.front.length_mm"


@pytest.mark.parametrize("name, text", [(R754, "[countershaft]\n"), (GAMMA, '[countershaft]\npair = "yes"\n')])
def test_what_was_accepted_or_measured_of_a_pair_still_is(name: str, text: str) -> None:
    file = (OLD / name).read_text(encoding="utf-8").replace("[countershaft]\n", text)
    before = solve(design(parse(file.encode(), name)))
    found = [before.design.former_id(check.id) for check in before.checks() if check.verdict == "warn"]
    assert any(id.startswith(("countershaft.support.2.", "bearings.front.")) for id in found)
    measured = '[[measured]]\nvalue = "countershaft.reaction_front"\nis = 1000.0\nunit = "N"\n'
    file += measured + "[accepted]\n" + "".join(f'"{id}" = "seen on the bench"\n' for id in found)
    results = solve(design(parse(file.encode(), name)))
    assert {results.check(id).accepted for id in found} == {"seen on the bench"}
    assert results.design.measured[-1].value in results.values()


# --- what is not well formed: the errors that version 0.1 gave, at the user's own keys

CASES = [
    ("countershaft = 3\n", "countershaft", "3", "must be a table"),
    ("[countershaft]\n", POSITIONS, "", "is missing; needs a list of numbers from −5000 to 5000 mm"),
    ("[countershaft]\nbearing_positions_mm = [1]\n", POSITIONS, "[1]", "has 1 entries; needs 2 to 9"),
    ("[countershaft]\nbearing_positions_mm = ['1,5', 2]\n", POSITIONS, '"1,5"', "must be a list of numbers from −5000 to 5000 mm; write 1.5"),
    ("[countershaft]\nbearing_positions_mm = [nan, 2]\n", POSITIONS, "nan", "must be a list of numbers from −5000 to 5000 mm, and finite"),
    ("[countershaft]\nbearing_positions_mm = [0, 6000]\n", POSITIONS, "6000", "must be a list of numbers from −5000 to 5000 mm"),
    ("[countershaft]\nbearing_positions_mm = [2, 1]\n", POSITIONS, "", "must rise from front to rear: [z_front, z_rear] with z_front < z_rear"),
    ("[countershaft]\nbearing_positions_mm = [0, 1, 2]\n" + BEARINGS, POSITIONS, "", "[bearings] has a front and a rear one: give two, or the sizes as journals"),
    (SHAFT + "pair = 'maybe'\n", PAIR, '"maybe"', 'must be one of "no", "yes"'),
    (SHAFT + "name = 'x'\n", "countershaft.name", "", 'is not known; did you mean "mode"?'),
    (SHAFT + "journals = [{ diameter_mm = 5, length_mm = 4 }]\n", JOURNALS, "", "give one for each of the 2 bearing_positions_mm"),
    (SHAFT + "journals = 3\n", JOURNALS, "3", "must be an array of tables: [[countershaft.journals]]"),
    (SHAFT + "journals = [{ diameter_mm = 5, length_mm = 4 }, { diameter_mm = 5 }]\n", f"{JOURNALS}.1.length_mm", "", "is missing; needs a number above 0 and up to 1000 mm"),
    (SHAFT + "[[countershaft.journals]]\ndiameter_mm = 1\nlength_mm = 1\n[[countershaft.journals]]\ndiameter_mm = 1\nlength_mm = 1\n" + BEARINGS, JOURNALS, "", "are those of [bearings]; leave them out here, or [bearings]"),
    (SHAFT + "[bearings]\n[bearings.front]\n", "bearings.rear", "", "is missing; needs a table"),
    (SHAFT + "[bearings]\nrear = 5\n[bearings.front]\n", "bearings.rear", "5", "must be a table"),
    (SHAFT + "[bearings]\nslope_mrad = [1, 2, 3]\n[bearings.front]\n[bearings.rear]\n", SLOPES, "[1, 2, 3]", "has 3 entries; needs 1 to 2"),
    (SHAFT + "[bearings]\nslope_mrad = 30\n[bearings.front]\n[bearings.rear]\n", SLOPES, "30", "must be a number, or a list of numbers, from 0 to 20 mrad"),
    (SHAFT + "[bearings]\n[bearings.front]\nlenght_mm = 3\n[bearings.rear]\n", "bearings.front.lenght_mm", "", 'is not known; did you mean "length_mm"?'),
    (SHAFT + "[bearings]\n[bearings.frnt]\n[bearings.front]\n[bearings.rear]\n", "bearings.frnt", "", 'is not known; did you mean "front"?'),
    ("[countershft]\n", "countershft", "", 'is not known; did you mean "countershaft"?'),
    (SHAFT + "[[shafts]]\nname = 'a'\n", "shafts", "", "[[shafts]] is of schema 2: write schema = 2, or [countershaft] instead"),
]  # fmt: skip


@pytest.mark.parametrize("text, key, value, reason", CASES)
def test_what_is_not_well_formed_is_told_and_left_out(text: str, key: str, value: str, reason: str) -> None:
    it = from_text(text)
    (error,) = it.errors
    assert (error.key, error.value, str(error.reason)) == (key, value, reason)
    lines = key_lines(text)
    around = [".".join(key.split(".")[:n]) for n in range(len(key.split(".")), 0, -1)]
    assert error.line == next((lines[part] for part in around if part in lines), 1)


def test_a_wheel_of_schema_1_sits_on_no_shaft() -> None:
    it = from_text(SHAFT + "[[gears.wheels]]\nname = 'a'\nshaft = 'b'\n")
    assert [error.key for error in it.errors] == ["gears.wheels.0.shaft"]
    assert it.errors[0].reason.startswith("is not known; known here are name, teeth, ")
    assert it.data["gears"] == {"wheels": [{"name": "a"}]}


def test_what_would_follow_is_not_said() -> None:
    assert from_text("countershaft = 3\n" + BEARINGS).wrong == {"shafts"}
    assert from_text("[countershaft]\n").wrong == {"shafts.0.bearings"}
    places = {"shafts.0.bearings.0.position_mm", "shafts.0.bearings.1.position_mm"}
    assert from_text("[countershaft]\n" + BEARINGS).wrong == places
    assert from_text(SHAFT + "[bearings]\n[bearings.front]\n").wrong == {"shafts.0.bearings.1"}


junk = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=3) | st.just(10**400),
    lambda inner: (
        st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=3) | st.just("name"), inner, max_size=3)
    ),
    max_leaves=6,
)
PLACES = [
    "schema", "countershaft", "bearings", "gears", "locked", "accepted", "measured", "optimise", "shafts", POSITIONS, JOURNALS,
    PAIR, SLOPES, "bearings.front", "bearings.rear", "gears.wheels", "gears.meshes", "optimise.vary", "countershaft.axis_mm",
]  # fmt: skip


@given(st.sampled_from([GAMMA, R754]), st.dictionaries(st.sampled_from(PLACES), junk, max_size=4))
def test_nothing_in_a_file_stops_it(name: str, placed: dict) -> None:
    data = old(name)
    for key, content in placed.items():
        table, _, part = key.partition(".")
        here = data.setdefault(table, {}) if part else data
        if isinstance(here, dict):
            here[part or table] = content
    it = upgraded(data, {})
    shafts = it.data.get("shafts", [])
    assert "countershaft" not in it.data and all(shaft["name"] for shaft in shafts)
    assert all(error.reason and error.line == 1 for error in it.errors)


rows = st.lists(st.dictionaries(st.sampled_from(["name", "position_mm", "length_mm"]), junk, max_size=3), max_size=3)
shafts = st.lists(
    st.fixed_dictionaries({}, optional={"name": junk, "mirrors": junk, "axis_mm": junk, "bearings": rows | junk}),
    max_size=2,
)


@given(shafts | junk, st.sampled_from([POSITIONS, JOURNALS, PAIR, SLOPES]), junk)
def test_nothing_in_a_design_of_schema_2_stops_an_old_key(content: object, key: str, value: object) -> None:
    with contextlib.suppress(BadInput):
        formerly({"shafts": content}, key)
        current({"shafts": content}, f"{key}.0")
        rewritten({"shafts": content}, key, value)


# --- old keys beside a design of schema 2

KEYS = [
    ("engine.bore_mm", "engine.bore_mm"),
    ("countershaft", "shafts.shaft"),
    ("countershaft.core_radius_mm", "shafts.shaft.core_radius_mm"),
    ("countershaft.masses.front.z_mm", "shafts.shaft.masses.front.z_mm"),
    ("countershaft.masses.*.z_mm", "shafts.shaft.masses.*.z_mm"),
    ("countershaft.bearing_positions_mm.1", "shafts.shaft.bearings.rear.position_mm"),
    ("countershaft.bearing_positions_mm.*", "shafts.shaft.bearings.*.position_mm"),
    ("countershaft.journals.0.length_mm", "shafts.shaft.bearings.front.length_mm"),
    ("bearings.front", "shafts.shaft.bearings.front"),
    ("bearings.front.length_mm", "shafts.shaft.bearings.front.length_mm"),
    ("bearings.*.length_mm", "shafts.shaft.bearings.*.length_mm"),
    ("bearings.slope_mrad.0", "shafts.shaft.bearings.front.slope_mrad"),
    ("bearings.oil", "bearings.oil"),
    ("bearings", "bearings"),
    ("locked.bearings", "locked.bearings"),
    ("locked.countershaft.core_radius_mm", "locked.shafts.shaft.core_radius_mm"),
    ("optimise.vary.bearings.rear.length_mm", "optimise.vary.shafts.shaft.bearings.rear.length_mm"),
    ("optimise.vary.bearings.fits", "optimise.vary.bearings.fits"),
    ("shafts.shaft.bearings.rear.length_mm", "shafts.shaft.bearings.rear.length_mm"),
    (POSITIONS, POSITIONS),
]


@pytest.mark.parametrize("before, now", KEYS)
def test_an_old_key_is_one_of_today(before: str, now: str) -> None:
    assert current(new(GAMMA), before) == now


def test_twins_do_not_count_and_names_are_those_of_the_design() -> None:
    data = new(R754)
    assert current(data, "countershaft.bearing_positions_mm.1") == "shafts.shaft.bearings.middle.position_mm"
    data["shafts"][0]["name"] = "left"
    data["shafts"][0]["bearings"][1]["name"] = "centre"
    assert current(data, "countershaft.bearing_positions_mm.1") == "shafts.left.bearings.centre.position_mm"


def test_of_several_shafts_an_old_key_is_none() -> None:
    data = {"shafts": [{"name": "left"}, {"name": "right"}, {"name": "twin", "mirrors": "left"}]}
    for call in (current, formerly, lambda *asked: rewritten(*asked, None)):
        key = "bearings.front.length_mm" if call is current else POSITIONS
        with pytest.raises(
            BadInput, match=r"there are several shafts: shafts\.left\.bearings\.front\.\w+, shafts\.right…$"
        ):
            call(data, key)
    assert current(data, "bearings.oil") == "bearings.oil"


@pytest.mark.parametrize("name", SHIPPED)
def test_what_became_many_is_read_as_it_was(name: str) -> None:
    data, before = new(name), old(name)
    shaft, bearings = before.get("countershaft", {}), before.get("bearings", {})
    assert formerly(data, POSITIONS) == shaft.get("bearing_positions_mm")
    assert formerly(data, JOURNALS) == shaft.get("journals")
    assert formerly(data, PAIR) == shaft.get("pair")
    assert formerly(data, SLOPES) == bearings.get("slope_mrad")


CHANGES = [
    (R754, POSITIONS, [-100.0, 5.0, 100.0]), (R754, POSITIONS, [-100.0, 100.0]), (R754, POSITIONS, [-3, -2, -1, 0, 1]),
    (R754, PAIR, "no"), (R754, PAIR, "yes"), (R754, JOURNALS, [{"diameter_mm": 1.0, "length_mm": 2.0}] * 3),
    (GAMMA, SLOPES, 0.1), (GAMMA, SLOPES, [0.1, 0.2]), (GAMMA, PAIR, "yes"), (GAMMA, POSITIONS, [-1.0, 1.0]),
]  # fmt: skip


@pytest.mark.parametrize("name, key, value", CHANGES)
def test_a_change_of_one_is_that_change_upgraded(name: str, key: str, value: object) -> None:
    table, _, last = key.partition(".")
    before = old(name)
    before[table][last] = value
    if key == POSITIONS and "journals" in before["countershaft"]:
        journals, names = before["countershaft"].pop("journals"), row_names(3)
        sizes = dict(zip(names, journals))
        wanted = upgraded(before, {}).data
        for row in wanted["shafts"][0]["bearings"]:
            row.update(sizes.get(row["name"], {}))
    else:
        wanted = upgraded(before, {}).data
    data = new(name)
    assert rewritten(data, key, value) == wanted
    assert data == new(name)
    assert formerly(rewritten(data, key, value), key) in (value, [value, value], None if value == "no" else value)


@pytest.mark.parametrize("name, key", [(R754, PAIR), (R754, JOURNALS), (GAMMA, SLOPES), (GAMMA, JOURNALS)])
def test_one_that_is_left_out_is_that_upgraded(name: str, key: str) -> None:
    table, _, last = key.partition(".")
    before = old(name)
    before[table].pop(last, None)
    assert rewritten(new(name), key, None) == upgraded(before, {}).data
    assert formerly(rewritten(new(name), key, None), key) is None


def test_positions_that_are_left_out_leave_the_rows() -> None:
    (shaft,) = rewritten(new(GAMMA), POSITIONS, None)["shafts"]
    assert [row["name"] for row in shaft["bearings"]] == ["front", "rear"]
    assert all("position_mm" not in row and row["length_mm"] for row in shaft["bearings"])
    assert rewritten({}, POSITIONS, None) == {}
    assert rewritten({}, POSITIONS, [0, 1])["shafts"] == [
        {"name": "shaft", "bearings": [{"name": "front", "position_mm": 0}, {"name": "rear", "position_mm": 1}]}
    ]


WRONG = [
    (R754, POSITIONS, [1], "has 1 entries; needs 2 to 9"),
    (R754, POSITIONS, ["x", 1], "must be a list of numbers from −5000 to 5000 mm"),
    (GAMMA, SLOPES, math.nan, "must be a number, or a list of numbers, from 0 to 20 mrad, and finite"),
    (R754, PAIR, True, 'must be one of "no", "yes"'),
    (R754, JOURNALS, 3, "must be an array of tables: [[countershaft.journals]]"),
    (R754, JOURNALS, [{}], "give one for each of the 3 bearing_positions_mm"),
    (R754, JOURNALS, [{"name": "x"}, {}, {}], "is not known; known here are diameter_mm, length_mm"),
    (GAMMA, JOURNALS, [{}, {}], "are those of [bearings]; leave them out here, or [bearings]"),
]  # fmt: skip


@pytest.mark.parametrize("name, key, value, reason", WRONG)
def test_what_schema_1_did_not_allow_is_told(name: str, key: str, value: object, reason: str) -> None:
    with pytest.raises(BadInput) as error:
        rewritten(new(name), key, value)
    assert str(error.value.errors[0].reason) == reason


def test_the_data_are_those_of_version_0_1() -> None:
    assert all("schema = 1" in (OLD / name).read_text(encoding="utf-8") for name in SHIPPED)
    assert sorted(path.name for path in NEW.glob("*.toml")) == SHIPPED


def test_a_bearing_of_old_that_is_given_whole_stays_where_it_is() -> None:
    given = {"diameter_mm": 59.5, "length_mm": 30.0, "clearance_um": 75.0}
    row = read(NEW / GAMMA).with_value("bearings.front", given).data["shafts"][0]["bearings"][0]
    assert row == {"name": "front", "position_mm": -167.5, "slope_mrad": 0.15625, **given}


@pytest.mark.parametrize(("key", "value", "kept"), [(PAIR, "yes", True), (POSITIONS, [-170, 0, 170], False)])
def test_remarks_stay_where_the_rows_do(key: str, value: object, kept: bool) -> None:
    remarks = read(OLD / GAMMA).with_value(key, value).remarks
    assert ("shafts.0.core_radius_mm" in remarks) == kept and "imbalance.crank_balance_fraction" in remarks


def test_the_ratio_of_old_that_is_left_out_is_minus_one() -> None:
    document = read(NEW / GAMMA).with_value("countershaft.speed_ratio", None)
    assert document.data["shafts"][0]["speed_ratio"] == -1 and design(document)


def test_a_star_stands_for_all_bearings_of_old_too_and_leaves_mirror_images_out() -> None:
    document = read(NEW / "r753ie4_gamma.toml")
    document = document.with_value("countershaft.pair", "yes").with_value("bearings.*.length_mm", 30.0)
    assert [row["length_mm"] for row in document.data["shafts"][0]["bearings"]] == [30.0, 30.0]
    assert every(document.data, "shafts.*.material") == ["shafts.shaft.material"]
    assert value_at(document.data, "shafts.*.material") == value_at(document.data, "shafts.shaft.material")
    assert every(document.data, "shafts.*.name") == ["shafts.shaft.name", "shafts.twin.name"]


def test_without_the_counter_shaft_of_old_its_bearings_stay_where_they_are_judged() -> None:
    judged = read(NEW / "r753ie4_gamma.toml").with_value("countershaft.pair", "yes")
    (shaft,) = judged.with_value("countershaft", None).data["shafts"]
    assert shaft["mode"] == "bearings" and all("position_mm" not in row for row in shaft["bearings"])
    alone = read(NEW / "r754ie4_balance_shafts.toml")
    assert "shafts" not in alone.with_value("countershaft", None).data


# --- what is wrong in a file of schema 1, once a key is typed

TYPING_ERROR, MISSING = (
    ("fillet_radius_mm =", "filet_radius_mm ="),
    ("bearing_positions_mm = [", "bearing_positions_m = ["),
)


def errors_after(instead: tuple[str, str], key: str, value: object) -> list[str]:
    """The keys of what is wrong in gamma with another text in it, once a key has this value."""
    text = (OLD / GAMMA).read_text(encoding="utf-8").replace(*instead)
    try:
        design(parse(text.encode(), GAMMA).with_value(key, value))
    except BadInput as bad:
        return [error.key for error in bad.errors]
    return []


@pytest.mark.parametrize(
    "key, value",
    [(PAIR, "yes"), (SLOPES, 0.1), (POSITIONS, [-170.0, 170.0]), (JOURNALS, None), ("engine.bore_mm", 95.0)],
)
def test_what_is_wrong_elsewhere_is_told_whatever_is_typed(key: str, value: object) -> None:
    assert errors_after(TYPING_ERROR, key, value) == ["countershaft.filet_radius_mm"]


@pytest.mark.parametrize(
    "instead, key, value, left",
    [
        (MISSING, POSITIONS, [-167.5, 167.5], ["countershaft.bearing_positions_m"]),
        (MISSING, f"{POSITIONS}.0", -167.5, ["countershaft.bearing_positions_m", POSITIONS]),  # the rear one has none
        (("slope_mrad = [0.15625,", "slope_mrad = [-1,"), SLOPES, [0.1, 0.1], []),
        (("slope_mrad = [0.15625,", "slope_mrad = [-1,"), f"{SLOPES}.0", 0.1, [SLOPES]),  # that of the rear is not read
        (
            TYPING_ERROR,
            "countershaft",
            None,
            ["bearings.journal_material", "bearings.front.load_N", "bearings.rear.load_N"],
        ),
    ],
)
def test_what_is_typed_is_wrong_no_more(instead: tuple[str, str], key: str, value: object, left: list[str]) -> None:
    assert sorted(errors_after(instead, key, value)) == sorted(left)
