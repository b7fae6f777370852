"""The thermal balance of many bearings at once, against that of one."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.bearings.plain.routes.routes import own_cold, own_warm
from calc.bearings.plain.routes.thermal_balance import balanced, settled
from calc.library.lubricant import Lubricant
from calc.sheet.errors import NoSolution


@pytest.fixture(scope="module")
def front(gamma_results):
    return gamma_results.outcomes["bearings"].result.bearings["front"]


@pytest.mark.parametrize("route, warm", [(own_warm, True), (own_cold, False)])
def test_all_at_once_are_what_each_is_alone(front, route, warm):
    random = np.random.default_rng(5)
    loads, clearances = random.uniform(300, 4000, 40), random.uniform(50e-6, 160e-6, 40)
    many = settled(replace(front.seat, clearance=clearances), replace(front.duty, load=loads), warm=warm)
    for i in range(40):
        one = balanced(
            route, replace(front.seat, clearance=float(clearances[i])), replace(front.duty, load=float(loads[i]))
        )
        for name in (
            "film",
            "eccentricity",
            "friction_power",
            "oil_flow",
            "temperature_rise",
            "attitude",
            "largest_pressure",
        ):
            assert getattr(many, name)[i] == pytest.approx(getattr(one, name), rel=1e-6), name


def test_lengths_diameters_speeds_and_supplies_may_be_arrays(front):
    bearing = replace(front.seat.bearing, length=np.array([0.02, 0.03]), diameter=np.array([0.05, 0.06]))
    duty = replace(
        front.duty,
        speed=np.array([30.0, 40.0]),
        effective_speed=np.array([30.0, 40.0]),
        supply_temperature=np.array([100.0, 110.0]),
        supply_pressure=np.array([3e5, 4e5]),
    )
    many = settled(replace(front.seat, bearing=bearing), duty)
    for i in range(2):
        own = replace(front.seat.bearing, length=float(bearing.length[i]), diameter=float(bearing.diameter[i]))
        at = replace(
            duty,
            speed=float(duty.speed[i]),
            effective_speed=float(duty.effective_speed[i]),
            supply_temperature=float(duty.supply_temperature[i]),
            supply_pressure=float(duty.supply_pressure[i]),
        )
        assert many.film[i] == pytest.approx(balanced(own_warm, replace(front.seat, bearing=own), at).film, rel=1e-6)


def test_without_balance_the_film_of_a_given_viscosity_is_the_same_at_once_and_alone(front):
    """Across the end of the balance: 400 mPa·s, whose rise passes 200 K as the clearance narrows, and no jump there."""
    thick = replace(
        front.seat, lubricant=Lubricant(replace(front.seat.inputs, viscosity=0.4).in_bearings(front.seat.lubricant.oil))
    )
    clearances = np.linspace(4e-5, 1.6e-4, 30)
    many = settled(replace(thick, clearance=clearances), front.duty)
    alone = [balanced(own_warm, replace(thick, clearance=float(g)), front.duty) for g in clearances]
    assert many.film == pytest.approx([film.film for film in alone], rel=1e-6)
    assert many.temperature_rise == pytest.approx([film.temperature_rise for film in alone], rel=1e-6)
    assert many.temperature_rise[0] > 200 > many.temperature_rise[-1]
    assert np.abs(np.diff(many.film, 2)).max() < 0.02 * many.film.max()


def test_they_are_broadcast(front):
    many = settled(
        replace(front.seat, clearance=np.array([[8e-5], [9e-5]])),
        replace(front.duty, load=np.array([500.0, 1000.0, 1500.0])),
    )
    assert many.film.shape == (2, 3)
    assert (np.diff(many.film, axis=1) < 0).all()


def test_what_has_no_film_is_nan_and_leaves_its_neighbours_alone(front):
    """Overloaded, hardly loaded, seized: nan where one alone is refused, and nothing else."""
    loads = np.array([1e7, 1700.0, 1e-3, 1700.0])
    clearances = np.array([8e-5, 8e-5, 8e-5, -2e-4])
    many = settled(replace(front.seat, clearance=clearances), replace(front.duty, load=loads))
    assert np.isfinite(many.film).tolist() == [False, True, False, False]
    for i in (0, 2, 3):
        with pytest.raises(NoSolution):
            balanced(
                own_warm, replace(front.seat, clearance=float(clearances[i])), replace(front.duty, load=float(loads[i]))
            )


def test_a_film_that_breaks_down_above_is_still_found(gamma):
    """A housing held back: the bracket passes temperatures at which the journal seizes."""
    from calc.design.toml_file import design
    from calc.solve import solve

    document = gamma.with_value("bearings.expansion_restraint", 0.75).with_value(
        "shafts.shaft.bearings.rear.clearance_factor", 0.8
    )
    held = solve(design(document)).outcomes["bearings"].result.bearings["front"]
    many = settled(held.seat, replace(held.duty, load=held.duty.load * np.ones(3)))
    assert many.film == pytest.approx(held.film, rel=1e-6)


@settings(max_examples=30, deadline=None)
@given(
    load=st.floats(50, 20000),
    clearance=st.floats(20e-6, 300e-6),
    length=st.floats(8e-3, 80e-3),
    speed=st.floats(5, 150),
    temperature=st.floats(40, 130),
)
def test_every_film_closes_its_balance(front, load, clearance, length, speed, temperature):
    seat = replace(front.seat, clearance=np.array([clearance]), bearing=replace(front.seat.bearing, length=length))
    duty = replace(front.duty, load=load, speed=speed, effective_speed=speed, supply_temperature=temperature)
    many = settled(seat, duty)
    if np.isnan(many.film[0]):
        with pytest.raises(NoSolution):
            balanced(own_warm, replace(seat, clearance=clearance), duty)
        return
    assert many.mean_temperature[0] == pytest.approx(temperature + many.temperature_rise[0] / 2, abs=1e-5)
    carried = many.oil.rho[0] * many.oil.cp[0] * many.oil_flow[0] * many.temperature_rise[0]
    assert many.friction_power[0] == pytest.approx(carried, rel=1e-9)
