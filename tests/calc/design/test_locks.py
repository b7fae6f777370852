# SPDX-License-Identifier: Apache-2.0
"""Inputs that the program may not change."""

import pytest

from calc.design.locks import locked, locks, standing, toggled
from calc.design.toml_file import Document, design, read
from calc.sheet.errors import BadInput
from calc.studies.shipped import EXAMPLE


@pytest.fixture(scope="module")
def gamma() -> Document:
    return read(EXAMPLE)


def test_the_oil_is_locked_until_the_design_says_otherwise(gamma: Document) -> None:
    assert locked(gamma.data, "bearings.oil") and locked(gamma.data, "measured.0.value")
    assert not locked(gamma.data, "bearings.front.length_mm")
    assert not locked({**gamma.data, "locked": {}}, "bearings.oil")
    # that of the bearings is used
    assert "friction.oil" in locks(gamma.data) and "friction.oil" not in standing(gamma.data)


def test_a_table_locks_what_stands_in_it_and_is_unlocked_from_there(gamma: Document) -> None:
    data = toggled(gamma.data, "bearings.front", "the casting is there")
    assert locked(data, "bearings.front.length_mm") == "the casting is there" and locked(data, "bearings.oil")
    assert not locked(data, "bearings.rear.length_mm") and not locked(data, "bearings.front_load_N")
    assert not locked(toggled(data, "bearings.front.length_mm", "no matter"), "bearings.front.length_mm")


def test_the_name_of_a_step_locks_all_its_inputs(gamma: Document) -> None:
    """Those of the shaft and of its bearings stand in the table of the shaft."""
    shaft, bearings = (gamma.with_value(f"locked.{step}", "cast") for step in ("countershaft", "bearings"))
    size, core, place = (f"shafts.shaft.{key}" for key in ("bearings.front.length_mm", "core_radius_mm", "axis_mm"))
    assert locked(shaft.data, core) and locked(shaft.data, place) and not locked(shaft.data, size)
    assert locked(bearings.data, size) and locked(bearings.data, "bearings.front.length_mm")
    assert locked(bearings.data, "bearings.supply") and not locked(bearings.data, core)
    for document in (shaft, bearings):
        design(document)
    assert not locked(toggled(bearings.data, size, "no matter"), size)


def test_a_key_that_no_design_has_is_no_lock(gamma: Document) -> None:
    """An element may come and go while its lock stays."""
    for key in ("bearings.front", "gears.wheels.nobody.teeth", "bearings.slope_mrad.0", "bearings.oil"):
        design(gamma.with_value(f"locked.{key}", "why"))
    with pytest.raises(BadInput) as bad:
        design(
            gamma.with_value("locked.bearings.front.lenght_mm", "cast").with_value("locked.engine.bore_mm.x", "cast")
        )
    assert {(e.key, str(e.reason)) for e in bad.value.errors} == {
        ("locked.shafts.shaft.bearings.front.lenght_mm", 'is not known; did you mean "length_mm"?'),
        ("locked.engine.bore_mm.x", '"engine.bore_mm" has no parts'),
    }


def test_an_element_is_locked_by_its_name_and_by_its_place(gamma: Document) -> None:
    name = str(gamma.data["gears"]["wheels"][1]["name"])
    data = toggled(gamma.data, f"gears.wheels.{name}.teeth", "the wheel is bought")
    assert locked(data, "gears.wheels.1.teeth") == "the wheel is bought" and not locked(data, "gears.wheels.0.teeth")
