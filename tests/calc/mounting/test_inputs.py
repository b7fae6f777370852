"""What is wrong with a [mounting] table: all of it at once, each with its line; and what no spring holds."""

import copy

import pytest

from calc.design.toml_file import Document, design, load, parse
from calc.sheet.errors import BadInput
from calc.solve import solve
from tests.conftest import DESIGNS

PATH = DESIGNS / "r753ie4_mounting.toml"


@pytest.fixture(scope="module")
def data():
    return load(PATH)[0].data


def changed(data, change):
    made = {**data, "mounting": copy.deepcopy(data["mounting"])}
    change(made["mounting"])
    return made


def errors(data, change):
    with pytest.raises(BadInput) as bad:
        design(Document(changed(data, change)))
    return {error.key: str(error.reason) for error in bad.value.errors}


def put(key, value):
    def change(table):
        here = table
        *way, last = key.split(".")
        for part in way:
            here = here[int(part)] if part.isdigit() else here[part]
        if value is None:
            here.pop(last)
        else:
            here[last] = value

    return change


@pytest.mark.parametrize(
    ("key", "value", "where", "words"),
    [
        ("mass_kg", 0.0, "mass_kg", "above 0"),
        ("mounts.0.loss_factor", 1.0, "mounts.0.loss_factor", "below 1"),
        ("mounts.0.damping_Ns_mm", 1.0, "mounts.0.damping_Ns_mm", "excludes loss_factor"),
        ("mounts.1.stiffness_N_mm", [900.0, 0.0, 420.0], "mounts.1.stiffness_N_mm", "above 0"),
        ("mounts.1.name", "front-left", "mounts.1.name", "stands twice"),
        ("mounts.1.name", "front right", "mounts.1.name", "letters, digits and -"),
        ("points.0.name", "rear-left", "points.0.name", "name of its own"),
        ("inertia_kgm2", [22.0, 24.0, 60.0], "inertia_kgm2", "exceeds the sum of the others"),
        ("inertia_coupling_kgm2", [20.0, 20.0, 20.0], "inertia_kgm2", "principal moments"),
        ("inertia_kgm2", None, "inertia_coupling_kgm2", "needs inertia_kgm2"),
        ("dimensions_mm", [750.0, 600.0, 850.0], "dimensions_mm", "excludes inertia_kgm2"),
        ("idle_speed_rpm", 2600.0, "idle_speed_rpm", "below the rated speed"),
        ("chassis", None, "points.4.on", "needs [mounting.chassis]"),
        ("chassis.modes.0.shape.4.name", "saet", "chassis.modes.0.shape.4.name", 'did you mean "seat"'),
        ("operation.2.hours", 23.0, "operation", "a day has 24"),
        ("operation.0.name", "static", "operation.0.name", "take another"),
        ("forward", [1.0, 0.0, 0.0], "forward", "not that of up"),
        ("cylinder_spread_percent", [1.0, 2.0], "cylinder_spread_percent", "one per cylinder, 3"),
        ("output_torque_Nm", 100.0, "output_torque_Nm", "off_body"),
        ("mounts.0.foundation_loss", 0.1, "mounts.0.foundation_loss", "needs foundation_N_mm"),
    ],
)
def test_a_wrong_entry_is_named(data, key, value, where, words):
    found = errors(data, put(key, value))
    assert words in found[f"mounting.{where}"]


@pytest.mark.parametrize("count", [2, 9])
def test_three_to_eight_mounts(data, count):
    def change(table):
        table["chassis"]["modes"] = []
        rows = [{**table["mounts"][n % 4], "name": f"mount-{n}"} for n in range(count)]
        table["mounts"] = rows

    assert "needs from 3 to 8" in errors(data, change)["mounting.mounts"]


def test_all_mistakes_come_at_once_each_with_its_line():
    text = PATH.read_text(encoding="utf-8")
    text = text.replace("mass_kg = 310.0 ", "mass_kg = -3.0 ").replace(
        'torque_path = "inside"', 'torque_path = "outside"'
    )
    text = text.replace("hours = 1.5", "hours = 25.0").replace("idle_speed_rpm = 900.0", "idle_speed_rpm = 9000.0")
    with pytest.raises(BadInput) as bad:
        design(parse(text.encode(), "d.toml"))
    found = {error.key: error.line for error in bad.value.errors}
    lines = text.splitlines()
    for key, start in (
        ("mounting.mass_kg", "mass_kg = -3.0"),
        ("mounting.torque_path", "torque_path"),
        ("mounting.operation.0.hours", "hours = 25"),
        ("mounting.idle_speed_rpm", "idle_speed_rpm = 9000"),
    ):
        assert lines[found[key] - 1].startswith(start)


def test_the_mounts_need_engine_and_imbalance(data):
    with pytest.raises(BadInput) as bad:
        design(Document({"schema": 2, "name": "x", "mounting": data["mounting"]}))
    assert sum("says what shakes the engine" in error.reason for error in bad.value.errors) == 2


def test_mounts_in_a_row_leave_a_turn_about_their_line(data):
    """All four on one line along the crank: nothing holds the engine about it."""

    def change(table):
        table.pop("chassis")
        table["points"] = [point for point in table["points"] if point.get("on") != "chassis"]
        for n, mount in enumerate(table["mounts"]):
            mount["position_mm"] = [-110.0, 0.0, -210.0 + 150.0 * n]

    outcome = solve(design(Document(changed(data, change)))).outcomes["mounting"]
    assert outcome.state == "no_solution"
    assert "turns freely about the line" in outcome.reason and "[0.00, 0.00, 1.00]" in outcome.reason


def test_without_its_table_the_step_is_not_asked(gamma_results):
    assert gamma_results.outcomes["mounting"].state == "not_asked"
