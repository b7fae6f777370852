# SPDX-License-Identifier: Apache-2.0
"""The counter-shaft's journals in the balance, and what the balance hands on to shaft and gears."""

import math
from dataclasses import replace

import numpy as np
import pytest

from calc.bearings.plain.loads import response
from calc.design.step_inputs import on_shafts
from calc.friction.journals import journals_at, journals_of
from calc.friction.power_balance import shaft_loss
from calc.solve import solve
from tests.calc.friction.documents import changed, design, gamma

PLACES = ("front", "rear")


@pytest.fixture(scope="module")
def drawn():
    return design(gamma())


@pytest.fixture(scope="module")
def on(drawn, gamma_results):
    c, b, g = (gamma_results.outcomes[step] for step in ("countershaft", "bearings", "gears"))
    return on_shafts(drawn, {"shaft": c}, {"shaft": b}, g.result)["shaft"]


def friction_of(results):
    return results.outcomes["friction"].result


# --- the journals
@pytest.mark.parametrize("place", PLACES)
def test_a_journal_loses_what_the_turn_costs(gamma_results, place):
    found, one = (
        friction_of(gamma_results).journals["shaft"][place],
        gamma_results.outcomes["bearings"].result.bearings[place],
    )
    expected = response(one.seat, one.duty, one.friction_power).power(found.standing_load)
    assert found.friction_power == pytest.approx(expected, rel=1e-12)
    assert found.friction_power > one.friction_power


def test_both_journals_are_the_bearings_loss(gamma_results):
    found = friction_of(gamma_results)
    assert found.bearing_loss == pytest.approx(
        sum(j.friction_power for j in found.journals["shaft"].values()), rel=1e-12
    )
    assert found.total_loss == pytest.approx(found.crank_power, rel=1e-9)


def test_the_standing_load_is_that_of_the_power_that_closes(gamma_results):
    """Weight and the gear's force at the power that the last mesh passes on, as the shaft's own step has them."""
    stands = gamma_results.outcomes["countershaft"].result.standing
    found = friction_of(gamma_results).journals["shaft"]
    assert found["front"].standing_load == pytest.approx(stands.stationary["front"], rel=1e-9)
    assert found["rear"].standing_load == pytest.approx(stands.stationary["rear"], rel=1e-9)


def test_a_loss_on_the_shaft_is_felt_by_its_journals():
    """What else the shaft drives goes through its gear, whose force stands still on the journals."""
    heavier = friction_of(
        solve(design(changed(gamma(), friction={"other_losses": [{"name": "shaft-pump", "power_W": 2000.0}]})))
    )
    lighter = friction_of(solve(design(gamma())))
    for place in PLACES:
        assert heavier.journals["shaft"][place].standing_load > lighter.journals["shaft"][place].standing_load
        assert heavier.journals["shaft"][place].friction_power > lighter.journals["shaft"][place].friction_power
    assert heavier.total_loss == pytest.approx(heavier.crank_power, rel=1e-9)


def test_a_standing_load_that_is_no_small_part_is_told():
    document = changed(gamma(), friction={"other_losses": [{"name": "shaft-pump", "power_W": 20000.0}]})
    notes = solve(design(document)).outcomes["friction"].notes
    assert any("Front journal: the standing load is" in note and "is rough" in note for note in notes)
    assert not any("is rough" in note for note in solve(design(gamma())).outcomes["friction"].notes)


def test_without_a_shaft_the_bearings_step_says_what_is_lost():
    """Bearings whose loads are given: no standing part is known."""
    data = gamma().data
    alone = {key: value for key, value in data.items() if key != "imbalance"}
    rows = [{**row, "load_N": 1700.0, "slope_mrad": 0.1} for row in data["shafts"][0]["bearings"]]
    shaft = {"name": "shaft", "mode": "bearings", "bearings": rows}
    bearings = {**data["bearings"], "journal_material": "20CrNi4"}
    document = replace(gamma(), data={**alone, "shafts": [shaft], "bearings": bearings})
    outcomes = solve(design(document)).outcomes
    bearings = outcomes["bearings"].result.bearings
    for place, found in outcomes["friction"].result.journals["shaft"].items():
        assert found.standing_load is None
        assert found.friction_power == bearings[place].friction_power


# --- many operating points
def test_at_the_design_point_many_points_are_the_one(on, gamma_results):
    one = journals_of(on)
    many = journals_at(on, np.array([0.5, 1.0]), np.array([100.0, 120.0]))
    for P in (None, 250.0, 2000.0):
        assert shaft_loss(many, P)[1] == pytest.approx(shaft_loss(one, P), rel=1e-6)
    assert shaft_loss(many, 250.0)[0] < shaft_loss(one, 250.0)
    assert many.speed == pytest.approx([one.speed / 2, one.speed])


def test_the_turning_load_grows_with_the_square_of_the_speed(on):
    many = journals_at(on, np.array([0.5, 1.0, 2.0]), np.array([100.0, 100.0, 100.0]))
    for answer in many.answers.values():
        assert answer.load / answer.load[1] == pytest.approx([0.25, 1.0, 4.0])
    some = many.only(np.array([True, False, True]))
    assert some.speed == pytest.approx(many.speed[[0, 2]])
    assert shaft_loss(some, 250.0) == pytest.approx(shaft_loss(many, 250.0)[[0, 2]])


# --- what is handed on
def test_the_power_of_the_balance_rates_the_teeth(gamma_results):
    train, found = gamma_results.outcomes["gears"].result, friction_of(gamma_results)
    for key, mesh in found.meshes.items():
        speed = abs(train.wheels[train.meshes[key].driver].speed)
        assert train.meshes[key].rating.mean_torque == pytest.approx(mesh.power_in / (2 * math.pi * speed), rel=1e-12)
    first = train.wheels["crank"].speed
    assert found.crank_torque == pytest.approx(found.crank_power / (2 * math.pi * abs(first)), rel=1e-12)


def test_a_given_power_rates_the_teeth_and_leaves_the_balance(gamma_results):
    given = solve(design(gamma().with_value("gears.power_kW", 1.35)))
    train = given.outcomes["gears"].result
    rated = train.meshes["crank_central"].rating.mean_torque
    assert rated == pytest.approx(1350 / (2 * math.pi * abs(train.wheels["crank"].speed)), rel=1e-9)
    for place in PLACES:
        assert friction_of(given).journals["shaft"][place].friction_power == pytest.approx(
            friction_of(gamma_results).journals["shaft"][place].friction_power
        )
    assert friction_of(given).total_loss == pytest.approx(friction_of(gamma_results).total_loss, rel=1e-12)
