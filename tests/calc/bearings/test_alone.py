"""Bearings without a shaft, an engine or gears: load and speed given."""

import pytest

from calc.design_file import Document, design
from calc.sheet.errors import BadInput
from calc.solve import solve


def alone(**changes):
    bearing = {
        "diameter_mm": 60.0,
        "length_mm": 30.0,
        "clearance_um": 80.0,
        "load_N": 3000.0,
        "journal_roughness_um": 0.4,
        "housing_roughness_um": 0.4,
    }
    table = {
        "oil": "SAE 30", "supply_temperature_C": 60.0, "supply_pressure_bar": 2.0, "supply": "hole", "hole_diameter_mm": 5.0,
        "housing_material": "steel", "journal_material": "steel", "speed_rpm": 1500.0, "load_speed_ratio": 0.0,
        "front": dict(bearing), "rear": dict(bearing),
    }  # fmt: skip
    for key, value in changes.items():
        part, _, name = key.rpartition("__")
        (table[part] if part else table)[name] = value
    table = {key: value for key, value in table.items() if value is not None}
    return Document({"schema": 1, "name": "alone", "bearings": table}, "alone.toml")


def test_bearings_alone_are_solved():
    results = solve(design(alone()))
    assert results.outcomes["bearings"].state == "solved"
    assert {o.state for key, o in results.outcomes.items() if key != "bearings"} == {"not_asked"}
    front = results.outcomes["bearings"].result.bearings["front"]
    assert front.load == 3000 and front.specific_load == pytest.approx(3000 / (0.06 * 0.03))
    assert front.standing is None


@pytest.mark.parametrize("key", ["speed_rpm", "journal_material", "front__load_N"])
def test_what_they_then_need_is_named(key):
    with pytest.raises(BadInput) as caught:
        document = alone()
        table = document.data["bearings"]
        part, _, name = key.rpartition("__")
        del (table[part] if part else table)[name]
        design(document)
    assert f"bearings.{key.replace('__', '.')}" in {error.key for error in caught.value.errors}


def test_a_standing_load_is_swept_at_its_own_size():
    """It does not grow with the square of the speed, as that of eccentric masses does."""
    standing = solve(design(alone(speed_range_rpm=[500.0, 3000.0]))).outcomes["bearings"].result.bearings["front"].sweep
    assert standing.thinnest_speed * 60 == pytest.approx(500)
    turning = (
        solve(design(alone(speed_range_rpm=[500.0, 3000.0], load_speed_ratio=1.0))).outcomes["bearings"].result.bearings["front"].sweep
    )
    assert turning.thinnest_speed * 60 == pytest.approx(3000)


def test_a_given_load_stands_beside_a_shaft_that_has_others(gamma):
    document = gamma.with_value("bearings.front.load_N", 900.0)
    found = solve(design(document)).outcomes["bearings"].result.bearings
    assert found["front"].load == 900
    assert found["rear"].load == pytest.approx(1713.6, rel=1e-3)


def test_another_speed_than_the_engine_s_wants_its_own_loads(gamma):
    with pytest.raises(BadInput) as caught:
        design(gamma.with_value("bearings.speed_rpm", 2000.0))
    assert "bearings.speed_rpm" in {error.key for error in caught.value.errors}
