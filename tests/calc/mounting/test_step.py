"""The step as a whole: what leads it, its checks, the search for mounts, transfer functions, and the same numbers with
lines and without."""

import copy
import math

import numpy as np
import pytest

from calc.design.toml_file import Document, design, load
from calc.mounting.operations import rows, transfer_functions
from calc.mounting.selection import changes, choices
from calc.sheet.value import recorded
from calc.solve import solve
from tests.conftest import DESIGNS


@pytest.fixture(scope="module")
def case():
    return load(DESIGNS / "r753ie4_mounting.toml")[0]


@pytest.fixture(scope="module")
def results(case):
    return solve(design(case))


def test_what_leads_and_what_comes_first(results):
    outcome = results.outcomes["mounting"]
    assert "takes the rocking couple of order 1 and nothing else" in outcome.reason
    assert "firing torque of order 1.5" in outcome.reason and "order 2 stay" in outcome.reason
    assert "out twice" in outcome.notes[0]
    assert not [c.id for c in outcome.checks if c.id.endswith(".severity")]


def test_lines_change_no_number(case, results):
    with recorded(False):
        bare = solve(design(case)).values()
    for id, value in results.values().items():
        if id.startswith("mounting."):
            assert bare[id].shown == pytest.approx(value.shown, rel=1e-12), id


def test_every_level_is_a_number(results):
    assert all(math.isfinite(value.shown) for id, value in results.values().items() if id.startswith("mounting."))


def test_the_search_reaches_pure_modes(case, results):
    made, step = design(case), results.outcomes["mounting"].result
    room, found = choices(made.mounting, step)
    best = dict(zip(("bounce", "lateral", "fore_aft", "yaw", "pitch", "roll"), found[0].energies))
    assert best["bounce"] >= 0.95 and best["roll"] >= 0.95 and min(best.values()) >= 0.85
    assert 5.9 <= found[0].frequencies.min() and found[0].frequencies.max() <= 15.92
    document = case
    for key, value in changes(found[0], made.mounting, room).items():
        document = document.with_value(key, value)
    values = solve(design(document)).values()
    assert values["mounting.energy.roll"].shown == pytest.approx(100 * best["roll"], rel=1e-6)


def test_transfer_functions_are_symmetric_at_the_centre_of_gravity(results):
    step = results.outcomes["mounting"].result
    header, numbers = rows(step)
    assert len(header) == len(numbers[0]) == 1 + 2 * 6 * 3 * 6 and all(map(math.isfinite, numbers[0]))
    assert np.isfinite(transfer_functions(step, np.array([10.0, 27.0]))).all()


def test_a_spread_of_the_cylinders_brings_half_an_order(case):
    table = {**copy.deepcopy(case.data["mounting"]), "cylinder_spread_percent": [3.0]}
    values = solve(design(Document({**case.data, "mounting": table}))).values()
    assert values["mounting.idle.torque.order_0_5"].shown > 0.1
    assert values["mounting.window.shaft.lowest_order"].shown < 1.5
    assert "mounting.idle.torque.order_0_5" not in solve(design(case)).values()


def test_a_free_force_and_a_torque_that_leaves_the_body():
    outcome = solve(load(DESIGNS / "twin_mounting.toml")[1]).outcomes["mounting"]
    values = {value.id: value for value in outcome.values()}
    assert "mounting.felt_order_1.shaft" not in values
    assert values["mounting.idle.half.order_1.transmissibility_force"].shown > 0
    assert abs(values["mounting.static.roll"].shown) > 1
    assert any("makes it worse" in note for note in outcome.notes)


def test_a_generating_set_is_judged():
    outcome = solve(load(DESIGNS / "generating_set_mounting.toml")[1]).outcomes["mounting"]
    judged = [c for c in outcome.checks if c.id.endswith(".severity")]
    assert len(judged) == 4 and all(c.kind == "advice" for c in judged)
    assert "No shaft" in outcome.reason


def test_the_weight_stiffens_the_mounts_by_little_and_the_note_says_by_how_much(results):
    pitch = roll = both = 0.0
    for k_x, k, y, z in ((900, 420, -250, -210), (900, 420, 250, -210), (990, 462, -280, 290), (990, 462, 280, 290)):
        pitch += 1.3 * (k_x * (z - 90) ** 2 + k * 205**2)
        roll += 1.3 * (k_x * (y + 12) ** 2 + k * 205**2)
        both -= 1.3 * k_x * (z - 90) * (y + 12)
    share = 310 * 9.80665 * 205 / ((pitch + roll) / 2 - math.hypot((pitch - roll) / 2, both))  # N·mm
    assert share < 0.01
    note = next(note for note in results.outcomes["mounting"].notes if "Payne" in note)
    assert f"{100 * share:.2g} %" in note


def test_points_may_be_left_out(case):
    """Modes, statics and the forces of the mounts need no place to look at."""
    table = copy.deepcopy(case.data["mounting"])
    table.pop("points")
    table["chassis"].pop("modes")
    outcome = solve(design(Document({**case.data, "mounting": table}))).outcomes["mounting"]
    assert outcome.state == "solved"
    assert {value.id: value for value in outcome.values()}["mounting.idle.half.force_sum"].shown > 100
    assert "In the mounts" in outcome.reason
