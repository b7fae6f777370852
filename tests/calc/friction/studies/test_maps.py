# SPDX-License-Identifier: Apache-2.0
"""The map of losses: its design point is the closed balance, its axes are those that are asked for, what is missing is
told."""

import numpy as np
import pytest

from calc.friction.power_balance import drive, losses_of
from calc.friction.studies import maps
from calc.solve import solve
from tests.calc.friction.documents import changed, design, gamma, pair
from tests.calc.friction.pairs import CRANK_SPEED, friction, lubricant, r753


def friction_of(document):
    return solve(design(document)).outcomes["friction"]


def table(outcome, id="map"):
    return next(t for t in outcome.whole.tables if t.id == id)


def cell(found, T, rpm):
    """The number in the row of a speed and the column of a temperature ("120 °C")."""
    at = [label for label, _ in found.columns].index(T)
    return next(row[at] for row in found.rows if row[0] == pytest.approx(rpm))


# --- the design point
@pytest.mark.parametrize(
    "document, T, rpm, rel",
    [
        (gamma(), "120 °C", 2600.0, 1e-3),
        (pair(), "40 °C", 1500.0, 1e-3),
        (changed(pair(), gears={"power_kW": 20.0}), "40 °C", 1500.0, 1e-3),
        (
            changed(
                pair(),
                gears={"power_kW": 20.0},
                friction={"bulk": "estimated", "pressure_law": "roelands", "load_sharing": "smooth"},
            ),
            "40 °C",
            1500.0,
            4e-3,
        ),  # its tips change their regime
        (
            changed(
                gamma(),
                friction={
                    "film": "source",
                    "plain_bearings": [{"name": "idler", "diameter_mm": 25.0, "length_mm": 20.0, "clearance_um": 40.0}],
                },
            ),
            "120 °C",
            2600.0,
            1e-3,
        ),
    ],
)
def test_the_design_point_is_the_closed_balance(document, T, rpm, rel):
    outcome = friction_of(document)
    assert cell(table(outcome), T, rpm) == pytest.approx(outcome.result.total_loss, rel=rel)


def test_another_point_is_the_design_solved_there():
    """Speed, power and oil temperature of the pair changed together: it carries its torque at every speed."""
    outcome = friction_of(pair())
    at_half = friction_of(
        changed(pair(), gears={"speed_rpm": 1050.0, "power_kW": 0.07}, friction={"oil_temperature_C": 20.0})
    )
    assert cell(table(outcome), "20 °C", 1050.0) == pytest.approx(at_half.result.total_loss, rel=1e-3)


def test_a_coarse_path_is_good_to_one_percent_of_the_meshes():
    said = friction()
    fine = drive(said, r753(), lubricant(), 120.0, CRANK_SPEED)
    coarse = drive(said, r753(), lubricant(), 120.0, CRANK_SPEED, points=maps.HELICAL_POINTS, strips=maps.STRIPS)
    a, b = losses_of(fine, 300.0).total, losses_of(coarse, 300.0).total
    assert abs(a - b) < 0.01 * a


# --- axes
def test_axes_hold_the_design_unless_asked():
    speeds, temperatures = maps.axes(friction(), 90.0, 40.0)
    assert speeds[-1] == 40.0 and speeds[0] == pytest.approx(16.0) and speeds.size == maps.SPEEDS
    assert temperatures.tolist() == [50.0, 70.0, 90.0, 100.0]
    assert 150.0 in maps.axes(friction(), 150.0, 40.0)[1] and max(maps.axes(friction(), 155.0, 40.0)[1]) <= maps.HOTTEST


def test_axes_as_asked_in_any_order():
    speeds, temperatures = maps.axes(friction(map_speeds=(50.0, 10.0), map_temperatures=(80.0, 20.0)), 90.0, 40.0)
    assert (speeds[0], speeds[-1]) == (10.0, 50.0) and np.all(np.diff(speeds) > 0)
    assert temperatures.tolist() == [20.0, 80.0]


def test_the_map_has_the_axes_of_its_keys():
    found = table(
        friction_of(
            changed(pair(), friction={"map_temperatures_C": [100.0, 20.0, 60.0], "map_speeds_rpm": [500.0, 3000.0]})
        )
    )
    assert found.columns == (("n", "rpm"), ("20 °C", "W"), ("60 °C", "W"), ("100 °C", "W"))
    assert [row[0] for row in found.rows] == pytest.approx(np.linspace(500, 3000, maps.SPEEDS))
    assert all(len(row) == 4 and None not in row for row in found.rows)


def test_losses_grow_with_the_speed():
    for document in (gamma(), pair()):
        rows = np.array(table(friction_of(document)).rows, dtype=float)
        assert (np.diff(rows[:, 1:], axis=0) > 0).all()


# --- what is missing, and what it costs
def test_points_without_a_film_are_empty_and_told():
    hot = changed(gamma(), friction={"map_temperatures_C": [80.0, 200.0], "map_speeds_rpm": [1000.0, 12000.0]})
    outcome = friction_of(hot)
    found = table(outcome)
    cells = [x for row in found.rows for x in row[1:]]
    assert None in cells and any(x is not None for x in cells)
    note = next(n for n in outcome.whole.notes if n.startswith("Map of losses"))
    assert f"at {cells.count(None)} of {len(cells)} points a journal has no film" in note
    for curve in outcome.whole.curves:
        if curve.id == "map":
            assert sum(int(np.isnan(np.asarray(s.y)).sum()) for s in curve.series) == cells.count(None)


def test_no_point_at_all_is_a_note_and_no_map():
    """A power that the meshes eat at every point."""
    outcome = friction_of(
        changed(gamma(), friction={"map_temperatures_C": [200.0], "map_speeds_rpm": [60000.0, 90000.0]})
    )
    assert outcome.state == "solved"
    assert not [t for t in outcome.whole.tables if t.id == "map"]
    assert any(n.startswith("No map of losses over speed and temperature: ") for n in outcome.whole.notes)


def test_fuel_and_carbon_dioxide_follow_the_losses():
    outcome = friction_of(changed(pair(), friction={"specific_fuel_consumption_g_kWh": 250.0, "co2_per_fuel": 3.0}))
    P, m_B, m_CO2 = (np.array(table(outcome, id).rows, dtype=float)[:, 1:] for id in ("map", "map_fuel", "map_co2"))
    assert m_B == pytest.approx(0.25 * P)
    assert m_CO2 == pytest.approx(3.0 * m_B)
    assert not [t for t in friction_of(pair()).whole.tables if t.id == "map_fuel"]


def test_the_parts_are_the_whole():
    outcome = friction_of(gamma())
    curves = {c.id: c for c in outcome.whole.curves}
    whole = next(s for s in curves["over_speed"].series if s.label == "120 °C")
    assert sum(np.asarray(s.y) for s in curves["over_speed_parts"].series) == pytest.approx(whole.y)


def test_a_measured_bulk_temperature_does_not_stand_in_the_map():
    """It says nothing at other points: the map takes the teeth as warm as the oil."""
    plain = table(friction_of(changed(pair(), gears={"power_kW": 20.0})))
    measured = table(friction_of(changed(pair(), gears={"power_kW": 20.0}, friction={"bulk_temperature_C": 90.0})))
    assert measured.rows == plain.rows
