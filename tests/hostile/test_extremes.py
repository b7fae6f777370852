"""Extreme but allowed values in every numeric field of the shipped designs: a finite result, a verdict, bad input or no
solution."""

import random
from datetime import date

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from calc.design.toml_file import Document, design, read
from calc.sheet.errors import BadInput
from calc.solve import solve
from calc.studies.shipped import shipped_name
from tests.conftest import SHIPPED
from tests.hostile.extremes import extremes, faults, fields, single

ALL = {shipped_name(path): read(path) for path in SHIPPED}
FIELDS = {name: fields(document) for name, document in ALL.items()}
TIP_RELIEF = ALL["thesis_tip_relief"]
SHARE = 60  # of the cases of a design, of which there are from 400 to 4,700


@st.composite
def placed(draw: st.DrawFn, most: int) -> tuple[str, dict[str, float]]:
    """A shipped design, and a few of its fields with extreme values."""
    name = draw(st.sampled_from(sorted(ALL)))
    chosen = draw(st.lists(st.sampled_from(FIELDS[name]), min_size=1, max_size=most, unique_by=lambda one: one[0]))
    return name, {key: draw(st.sampled_from(values)) for key, about in chosen if (values := extremes(about))}


@given(placed(3))
@settings(max_examples=40, suppress_health_check=[HealthCheck.too_slow])
def test_extreme_fields_end_cleanly(case: tuple[str, dict[str, float]]) -> None:
    name, changes = case
    assert faults(ALL[name], changes) == []


def test_a_duty_without_load_has_no_cost_of_plain_bearings() -> None:
    assert faults(ALL["r753ie4_rolling"], {"engine.strokes": 2, "bearings.duty.rated.load_factor": 0}) == []


@pytest.mark.slow
@given(placed(6))
@settings(max_examples=400, suppress_health_check=[HealthCheck.too_slow])
def test_many_extreme_fields_end_cleanly(case: tuple[str, dict[str, float]]) -> None:
    name, changes = case
    assert faults(ALL[name], changes) == []


@pytest.mark.slow
@pytest.mark.parametrize("name", ALL)
def test_a_field_at_an_extreme_ends_cleanly(name: str) -> None:
    """A share of them, drawn anew each day; all of them, nearly two hours: `python -m tests.hostile.extremes`."""
    cases = single(ALL[name])
    drawn = random.Random(f"{date.today()} {name}").sample(cases, min(len(cases), SHARE))
    assert [(one, bad) for one in drawn if (bad := faults(ALL[name], dict([one])))] == []


@pytest.mark.parametrize(
    ("document", "key", "value"),
    [
        (TIP_RELIEF, "gears.normal_module_mm", 5e-324),
        (TIP_RELIEF, "gears.face_width_mm", 1e-300),
        (ALL["r753ie4_gamma"], "engine.crank_radius_mm", 5e-324),
        (ALL["r753ie4_mounting"], "engine.rated_power_kW", 5e-324),
    ],
)
def test_a_number_of_no_size_is_bad_input(document: Document, key: str, value: float) -> None:
    with pytest.raises(BadInput, match="0 or of a size from 1e-30 to 1e30"):
        design(document.with_value(key, value))


@pytest.mark.parametrize(
    ("name", "changes"),
    [
        ("thesis_tip_relief", {"gears.normal_module_mm": 1e-29}),
        ("thesis_tip_relief", {"gears.face_width_mm": 1e-29}),
        ("thesis_tip_relief", {"gears.speed_irregularity": 0.0}),
        ("r753ie4_gamma", {"engine.crank_radius_mm": 0.059}),
        ("r753ie4_gamma", {"engine.crank_radius_mm": 5.9e-5}),
        ("generating_set_mounting", {"engine.crank_radius_mm": 1e-9}),
        ("twin_force_shaft", {"engine.crank_radius_mm": 1e-9}),
        pytest.param("r753ie4_drive", {"countershaft.half_length_mm": 4999.999999999999}, marks=pytest.mark.slow),
    ],
    ids=str,
)
def test_what_once_broke(name: str, changes: dict[str, float]) -> None:
    assert faults(ALL[name], changes) == []


def test_an_oil_outside_of_its_law_is_told() -> None:
    """At −40 °C a thin oil is still on its line, a thick one is not; the losses then rest on an extrapolation."""
    pair = ALL["timing_pair"].with_value("friction.oil_temperature_C", -40.0)
    for oil, outside in (("0W-20", False), ("SAE 50", True)):
        checks = solve(design(pair.with_value("friction.oil", oil))).outcomes["friction"].checks
        found = [check for check in checks if check.id == "friction.train.viscosity_range"]
        assert [(check.kind, check.verdict) for check in found] == [("method", "note")] * outside
