# SPDX-License-Identifier: Apache-2.0
"""Schema 2 in schema 1: a file that was written in it keeps it where it can say what changed; else `upgrade` is named.
A design that is written in either schema has the same numbers."""

import tomllib
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from assistant.session.saving import NeedsUpgrade, saved_text
from calc.design.addresses import value_at
from calc.design.downgrade import downgraded
from calc.design.toml_file import Document, design, parse, read
from calc.sheet.errors import BadInput
from calc.solve import Results, solve
from tests.conftest import ROOT

OLD, NEW = (ROOT / "tests" / "data" / name for name in ("designs_0_1", "upgraded"))
SHIPPED = sorted(path.name for path in OLD.glob("*.toml"))
GAMMA, R754, TWIN = "r753ie4_gamma.toml", "r754ie4_balance_shafts.toml", "twin_force_shaft.toml"
RAW = {name: (OLD / name).read_bytes() for name in (GAMMA, R754, TWIN)}


@pytest.mark.parametrize("name", SHIPPED)
def test_a_shipped_design_comes_back_as_it_was(name: str) -> None:
    text = (OLD / name).read_text(encoding="utf-8")
    assert downgraded(read(OLD / name).data) == tomllib.loads(text)
    assert saved_text(text.encode("utf-8"), read(NEW / name).data) == text


def kept(raw: bytes, document: Document) -> dict[str, Any]:
    """What is saved over a file of schema 1, and whether that says all."""
    text = saved_text(raw, document.data)
    assert parse(text.encode("utf-8"), "").data == document.data
    return tomllib.loads(text)


def numbers(data: Any, way: str = "") -> list[str]:
    """The keys of the numbers of a file, elements of arrays by their names."""
    if isinstance(data, dict):
        return [key for part, inner in data.items() for key in numbers(inner, f"{way}.{part}" if way else part)]
    if isinstance(data, list):
        named = [(item.get("name", n) if isinstance(item, dict) else n, item) for n, item in enumerate(data)]
        return [key for name, item in named for key in numbers(item, f"{way}.{name}")]
    return [way] * (isinstance(data, float) and way.partition(".")[0] in ("countershaft", "bearings", "gears"))


OF_FILES = {name: numbers(tomllib.loads(raw.decode("utf-8"))) for name, raw in RAW.items()}
MANY: dict[str, list[tuple[str, object]]] = {
    GAMMA: [("bearings.slope_mrad", 0.25), ("bearings.slope_mrad", [0.25, 0.125]), ("bearings.slope_mrad", None)],
    R754: [("countershaft.pair", "yes"), ("countershaft.pair", "no"), ("countershaft.journals", None)],
    TWIN: [("countershaft.bearing_positions_mm", [-170.5, 169.5]), ("countershaft.axis_mm", [20.0, 30.0])],
}
edits = st.sampled_from(sorted(RAW)).flatmap(
    lambda name: st.tuples(
        st.just(name),
        st.lists(
            st.tuples(st.sampled_from(OF_FILES[name]), st.sampled_from((0.9, 0.99, 1.05)))
            | st.sampled_from(MANY[name]),
            max_size=3,
        ),
    )
)


@settings(deadline=None, max_examples=30)
@given(edits)
def test_what_old_keys_say_is_kept_in_schema_1(said: tuple[str, list[tuple[str, object]]]) -> None:
    """A number by a factor, so that places still rise; or one of the keys that have become many."""
    name, changes = said
    document = parse(RAW[name], "")
    for key, value in changes:
        if key in OF_FILES[name]:
            now = value_at(document.data, key)
            value = now * value if isinstance(now, float) and isinstance(value, float) else None
        document = document.with_value(key, value)
    assert kept(RAW[name], document)["schema"] == 1


NEW_KEYS: list[tuple[str, object]] = [
    ("shafts.shaft.name", "left"),
    ("shafts.shaft.bearings.front.name", "one"),
    ("shafts.shaft.bearings.0.kind", "plain"),
    ("shafts.shaft.bearings.rear.slope_mrad", 0.125),
    ("shafts.shaft.bearings.*.slope_mrad", 0.25),
    ("shafts.shaft.bearings.0.position_mm", -180.5),
    ("shafts.shaft.bearings.*.diameter_mm", 60.5),
    ("shafts.shaft.speed_ratio", None),
    ("shafts.shaft.core_radius_mm", 21.5),
    ("shafts.shaft.masses.*.mass_kg", 2.5),
    ("shafts.shaft.masses.front.radius_mm", 20.5),
    ("gears.wheels.shaft.shaft", None),
    ("gears.wheels.crank.shaft", "shaft"),
    ("shafts", None),
    ("bearings", None),
]


@settings(deadline=None, max_examples=30)
@given(st.sampled_from(sorted(RAW)), st.lists(st.sampled_from(NEW_KEYS), max_size=3))
def test_what_new_keys_say_is_kept_or_upgrade_is_named(name: str, changes: list[tuple[str, object]]) -> None:
    document = parse(RAW[name], "")
    for key, value in changes:
        if not key.startswith("gears") or "gears" in document.data:
            document = changed(document, key, value)
    try:
        assert kept(RAW[name], document)["schema"] == 1
    except NeedsUpgrade as needed:
        assert "upgrade" in str(needed) and downgraded(document.data) is None


def changed(document: Document, key: str, value: object) -> Document:
    """The document with a change; as it is where a change before it took away what it is of."""
    try:
        return document.with_value(key, value)
    except BadInput:
        return document


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("shafts.shaft.name", "left"),
        ("shafts.shaft.bearings.front.name", "one"),
        ("shafts.shaft.bearings.rear.slope_mrad", None),  # schema 1 has one slope of both, or two
        ("gears.wheels.shaft.shaft", None),
    ],
)
def test_what_schema_1_has_no_words_for_names_upgrade(key: str, value: object) -> None:
    with pytest.raises(NeedsUpgrade, match="contralbero upgrade FILE"):
        saved_text(RAW[GAMMA], parse(RAW[GAMMA], "").with_value(key, value).data)


# --- the same design by hand

BEGUN = """
name = "by hand"
[engine]
name = "own inline three"
layout = "inline"
cylinders = 3
strokes = 4
bore_mm = 95.0
crank_radius_mm = 55.0
rod_length_mm = 170.0
cylinder_pitch_mm = 112.0
firing_order = [1, 3, 2]
piston_mass_g = 1200.0
rod_mass_g = 1100.0
rod_cg_to_big_end_mm = 55.0
rated_speed_rpm = 2800.0
[imbalance]
crank_balance_fraction = 0.5
"""
MASSES = """[{ name = "front", mass_kg = 2.7, radius_mm = 18.7, angle_deg = 210.0, z_mm = -76.5 },
    { name = "rear", mass_kg = 2.7, radius_mm = 18.7, angle_deg = 30.0, z_mm = 76.5 }]"""
SUPPLY = 'oil = "SAE 30"\nsupply_temperature_C = 90.0\nsupply_pressure_bar = 3.0\nsupply = "hole"\nhole_diameter_mm = 4.0\nhousing_material = "EN AC-43100"'
FRONT = (
    "diameter_mm = 60.0\nlength_mm = 30.0\nclearance_um = 75.0\njournal_roughness_um = 0.4\nhousing_roughness_um = 0.8"
)
REAR = (
    "diameter_mm = 62.0\nlength_mm = 31.0\nclearance_um = 77.0\njournal_roughness_um = 0.4\nhousing_roughness_um = 0.8"
)
FORMER = f"""schema = 1{BEGUN}[countershaft]
material = "20CrNi4"
bearing_positions_mm = [-150.0, 155.0]
outer_radius_mm = 29.0
core_radius_mm = 20.0
half_length_mm = 120.0
masses = {MASSES}
[bearings]
{SUPPLY}
slope_mrad = 0.2
[bearings.front]
{FRONT}
[bearings.rear]
{REAR}
"""
TODAY = f"""schema = 2{BEGUN}[bearings]
{SUPPLY}
[[shafts]]
name = "lower"
speed_ratio = -1
half_length_mm = 120.0
core_radius_mm = 20.0
outer_radius_mm = 29.0
masses = {MASSES}
material = "20CrNi4"
[[shafts.bearings]]
name = "front"
position_mm = -150.0
slope_mrad = 0.2
{FRONT}
[[shafts.bearings]]
name = "rear"
position_mm = 155.0
slope_mrad = 0.2
{REAR}
"""


def digits(results: Results) -> list[str]:
    """Every value, every check with its limit, and every verdict, to the last bit."""
    values = [f"{id}={value.inside!r}" for id, value in results.values().items()]
    checks = [f"{c.id}: {float(c.value)!r} {c.limit!r} {c.verdict}" for c in results.checks()]
    return sorted([*values, *checks, *(f"{key}: {one.verdict}" for key, one in results.outcomes.items())])


def test_a_design_by_hand_has_the_numbers_of_its_twin_in_schema_1() -> None:
    former, today = (solve(design(parse(text.encode("utf-8"), ""))) for text in (FORMER, TODAY))
    assert digits(former) == digits(today)
    assert len(today.values()) > 200 and len(list(today.checks())) > 20


@pytest.mark.parametrize("name", [GAMMA, R754, TWIN])
def test_a_shipped_design_has_the_numbers_of_its_twin_in_schema_1(name: str) -> None:
    assert digits(solve(design(read(OLD / name)))) == digits(solve(design(read(NEW / name))))


# --- what is locked or varied by the keys of schema 1

PLACE_LOCKED = RAW[GAMMA] + b'\n[locked]\n"countershaft.bearing_positions_mm" = "the casing is there"\n'


@pytest.mark.parametrize(
    ("key", "old"),
    [
        ("position_mm", "countershaft.bearing_positions_mm.1"),
        ("slope_mrad", "bearings.slope_mrad.1"),
        ("length_mm", "bearings.rear.length_mm"),
    ],
)
def test_what_is_locked_of_a_bearing_is_saved_by_a_key_that_schema_1_has(key: str, old: str) -> None:
    changed = parse(RAW[GAMMA], "").with_value(f"locked.shafts.shaft.bearings.rear.{key}", "measured")
    assert tomllib.loads(saved_text(RAW[GAMMA], changed.data))["locked"] == {old: "measured"}


def test_of_a_list_that_is_locked_one_number_can_not_be_set_free_in_schema_1() -> None:
    document = parse(PLACE_LOCKED, "")
    assert saved_text(PLACE_LOCKED, document.with_value("name", "other").data)
    with pytest.raises(NeedsUpgrade):
        saved_text(PLACE_LOCKED, document.with_value("locked.shafts.shaft.bearings.front.position_mm", None).data)
