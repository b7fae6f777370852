"""The case of the shipped design against values of a separate program, and values that tell the usual slips apart."""

import json

import numpy as np
import pytest

from calc.design.toml_file import Document, design, load
from calc.mounting import modal as aids
from calc.mounting.standards import weights
from calc.solve import solve
from tests.conftest import DESIGNS, ROOT

REFERENCE = ROOT / "tests" / "reference"
GIVEN = json.loads((REFERENCE / "mounting.json").read_text())["given"]
REACHED = 2e-6  # the values have seven digits


@pytest.fixture(scope="module")
def case():
    return load(DESIGNS / "r753ie4_mounting.toml")[0]


@pytest.fixture(scope="module")
def results(case):
    return solve(design(case))


def rows(mounts, edit=""):
    return [
        row
        for row in GIVEN
        if row["mounts"].startswith(mounts) and edit in row["edit"] and (bool(row["edit"]) == bool(edit))
    ]


@pytest.mark.parametrize("row", rows("stiff"), ids=lambda row: row["value"])
def test_a_given_value(results, row):
    assert results.values()[row["value"]].shown == pytest.approx(row["is"], rel=REACHED if row["rel"] else 1e-12)


@pytest.mark.parametrize(
    "edit",
    ["no [mounting.chassis]", "inertia_kgm2 left out, dimensions_mm = [750, 600, 850]"],
    ids=["rigid ground", "box"],
)
def test_a_given_value_of_an_edited_case(case, edit):
    if "chassis" in edit:
        table = {key: value for key, value in case.data["mounting"].items() if key != "chassis"}
        table["points"] = [point for point in table["points"] if point.get("on") != "chassis"]
    else:
        table = {key: value for key, value in case.data["mounting"].items() if not key.startswith("inertia")} | {
            "dimensions_mm": [750, 600, 850]
        }
    values = solve(design(Document({**case.data, "mounting": table}))).values()
    for row in [row for row in GIVEN if row["edit"] == edit]:
        assert values[row["value"]].shown == pytest.approx(row["is"], rel=2e-6)


def test_closed_forms():
    by = {row["value"]: row["is"] for row in GIVEN if row["mounts"] in ("pair", "four")}
    assert np.degrees(aids.focal_angle(b=0.26, L=4.0, h=0.12)) == pytest.approx(by["mounting.focal.angle"], rel=REACHED)
    assert aids.focal_reach(b=0.26, L=4.0) * 1e3 == pytest.approx(by["mounting.focal.reach"], rel=REACHED)
    assert aids.four_bounce(k_x=260e3, m=310.0) == pytest.approx(by["closed form bounce"], rel=REACHED)
    assert aids.four_yaw(k_y=110e3, c=0.25, k_z=90e3, b=0.26, J_x=22.0) == pytest.approx(
        by["closed form yaw"], rel=REACHED
    )
    pair = aids.four_coupled(k=90e3, k_x=260e3, h=0.18, a=0.25, m=310.0, J=24.0)
    assert pair[0] == pytest.approx(by["closed form fore_aft_pitch"], rel=REACHED)


def test_weightings():
    by = {row["value"]: row["is"] for row in GIVEN if row["value"].startswith("weighting")}
    found = weights("Wk", np.array([15.0, 22.5]))
    assert found == pytest.approx([by["weighting Wk at 15 Hz"], by["weighting Wk at 22.5 Hz"]], rel=REACHED)


def test_values_that_tell_slips_apart(results):
    """Order 1 at the seat at rated speed, weighted: a mirrored axis, an early shaft, moments about the origin would
    give others."""
    step = results.outcomes["mounting"].result
    lines, n = step.levels, list(step.drive.orders).index(1.0)
    a = lines.weight["seat"][3, 0, :, n] * np.abs(lines.acceleration["seat"][3, :, :, n])
    order_1 = dict(zip(step.drive.variants, np.sqrt((a**2).sum(-1) / 2) * 1e6))
    assert [order_1[name] for name in ("shaft", "scatter", "tooth")] == pytest.approx(
        [96.571, 97.406, 648.077], abs=6e-4
    )
    values = results.values()
    for mount, half, shaft in (
        ("front-left", 0.6485, 0.4714),
        ("front-right", 0.6485, 0.4714),
        ("rear-left", 0.3522, 0.2754),
        ("rear-right", 0.3474, 0.3244),
    ):
        assert values[f"mounting.idle.half.{mount}.deflection_peak"].shown == pytest.approx(half, abs=6e-5)
        assert values[f"mounting.idle.shaft.{mount}.deflection_peak"].shown == pytest.approx(shaft, abs=6e-5)


def test_the_gas_is_computed_anew_between_its_nodes(results):
    """351.1 N·m at 1500 rpm; torques that are interpolated themselves would give 378.9."""
    assert results.values()["mounting.slow.torque.order_1_5"].shown == pytest.approx(351.1, abs=0.06)


def test_critical_speeds(results):
    values = results.values()
    for id, rpm in (
        ("yaw.order_1", 1121),
        ("bounce.order_1", 1171),
        ("pitch.order_1", 1363),
        ("roll.order_1", 1841),
        ("pitch.order_1_5", 909),
        ("roll.order_1_5", 1228),
        ("roll.order_2", 921),
    ):
        assert values[f"mounting.critical.{id}.speed"].shown == pytest.approx(rpm, abs=0.6)


def test_first_order_is_felt_as_the_errors_of_the_shaft_leave_it(results):
    values = results.values()
    assert values["mounting.felt_order_1.tooth"].shown == pytest.approx(1 / (2 * np.sin(np.radians(7.2))), rel=1e-9)
    assert values["mounting.felt_order_1.scatter"].shown == pytest.approx(54, rel=0.01)
