"""Bearings without a shaft, an engine or gears: load and speed given."""

import math
from dataclasses import replace
from types import SimpleNamespace

import pytest

from calc.bearings.plain.solve import operating_point, solve_film
from calc.bearings.solve import _load, _slope
from calc.design.toml_file import design
from calc.sheet.errors import BadInput
from calc.solve import solve
from tests.calc.bearings.documents import alone


def test_bearings_alone_are_solved():
    results = solve(design(alone()))
    assert results.outcomes["bearings"].state == "solved"
    assert {o.state for key, o in results.outcomes.items() if key != "bearings"} == {"not_asked"}
    front = results.outcomes["bearings"].result.bearings["front"]
    assert front.load == 3000 and front.specific_load == pytest.approx(3000 / (0.06 * 0.03))
    assert front.standing is None


@pytest.mark.parametrize(
    "name, key",
    [
        ("speed_rpm", "bearings.speed_rpm"),
        ("journal_material", "bearings.journal_material"),
        ("front__load_N", "shafts.0.bearings.0.load_N"),
    ],
)
def test_what_they_then_need_is_named(name, key):
    with pytest.raises(BadInput) as caught:
        design(alone(**{name: None}))
    assert key in {error.key for error in caught.value.errors}


def test_a_standing_load_is_swept_at_its_own_size():
    """It does not grow with the square of the speed, as that of eccentric masses does."""
    standing = solve(design(alone(speed_range_rpm=[500.0, 3000.0]))).outcomes["bearings"].result.bearings["front"].sweep
    assert standing.thinnest_speed * 60 == pytest.approx(500)
    turning = (
        solve(design(alone(speed_range_rpm=[500.0, 3000.0], load_speed_ratio=1.0)))
        .outcomes["bearings"]
        .result.bearings["front"]
        .sweep
    )
    assert turning.thinnest_speed * 60 == pytest.approx(3000)


def test_a_given_load_stands_beside_a_shaft_that_has_others(gamma):
    document = gamma.with_value("shafts.shaft.bearings.front.load_N", 900.0)
    found = solve(design(document)).outcomes["bearings"].result.bearings
    assert found["front"].load == 900
    assert found["rear"].load == pytest.approx(1713.6, rel=1e-3)


def test_another_speed_than_the_engine_s_wants_its_own_loads(gamma):
    with pytest.raises(BadInput) as caught:
        design(gamma.with_value("bearings.speed_rpm", 2000.0))
    assert "bearings.speed_rpm" in {error.key for error in caught.value.errors}


@pytest.mark.parametrize(
    "changes, rise, film",
    [
        # oil that is too thick for the table until it has warmed; rise [K] and film [µm] from an independent solution
        # of the balance
        ({"supply_temperature_C": -20.0}, 109.5, 25.5),
        ({"front__load_N": 20.0}, 55.8, None),
    ],
)
def test_oil_that_is_thick_at_first_warms_to_its_balance(changes, rise, film):
    found = solve(design(alone(**changes))).outcomes["bearings"]
    assert found.state == "solved", found.reason
    front = found.result.bearings["front"]
    assert front.temperature_rise == pytest.approx(rise, rel=0.01)
    assert front.hot.friction_power == pytest.approx(
        front.hot.oil.rho * front.hot.oil.cp * front.oil_flow * front.temperature_rise
    )
    if film:
        assert front.film * 1e6 == pytest.approx(film, rel=0.01)


def test_a_corner_with_thick_oil_is_no_corner_without_film():
    """100 N: the tight corner with thicker oil runs at 83 K above its supply and 23.2 µm (independent solution)."""
    corners = solve(design(alone(front__load_N=100.0))).outcomes["bearings"].result.bearings["front"].corners
    films, outlets = corners.columns["film"], corners.columns["outlet_temperature"]
    assert films[outlets.argmax()] * 1e6 == pytest.approx(23.2, rel=0.01)
    assert outlets.max() - 60 == pytest.approx(83, rel=0.01)


def test_where_load_and_surfaces_hardly_drag_the_film_the_transition_is_told():
    """Load at 0.55 of the journal's speed: the film is that of 150 rpm, though the journal turns at 1500."""
    found = {c.id: c for c in solve(design(alone(load_speed_ratio=0.55))).outcomes["bearings"].checks}
    assert found["bearings.front.transition"].value == pytest.approx(150)
    assert found["bearings.front.transition"].verdict == "note"


def test_a_bush_that_turns_makes_the_sliding_speed():
    """u, p·u and the shear are those of journal on bush, |n_J − n_B|."""
    r = solve(design(alone(bush_speed_ratio=5.0))).outcomes["bearings"].result.bearings["front"]
    assert r.surface_speed == pytest.approx(3.141592653589793 * 0.06 * 25 * 4)
    assert r.shear_rate == pytest.approx(r.surface_speed / r.film)


@pytest.mark.parametrize(
    ("bush", "load", "effective", "slides"),
    [
        # of the journal's speed; the shear over it by the speed of journal on bush
        (0.0, 0.0, 1.0, 1.0),
        (0.0, 1.0, 1.0, 1.0),
        (0.0, 0.25, 0.5, 2.0),
        (0.5, 0.0, 1.5, 1 / 3),
        (0.5, 1.0, 0.5, 1.0),
        (-0.5, 1.0, 1.5, 1.0),
        (0.5, 0.25, 1.0, 0.5),
    ],
)
def test_the_effective_speed_is_that_of_both_surfaces_against_the_load(bush, load, effective, slides):
    """|n_J + n_B − 2·n_F|, and |n_J − n_B| over it."""
    inputs = replace(design(alone()).bearings, bush_speed_ratio=bush, load_speed_ratio=load)
    point = operating_point(inputs, 3000.0, 25.0)
    assert (point.effective_speed, point.sliding_ratio) == (pytest.approx(25 * effective), pytest.approx(slides))
    assert (point.load, point.speed, point.supply_pressure) == (3000.0, 25.0, pytest.approx(2e5))


def test_a_groove_parts_the_bearing_into_two_lands():
    r = solve(design(alone(**GROOVE, load_speed_ratio=1.0))).outcomes["bearings"].result.bearings["front"]
    assert r.specific_load == pytest.approx(3000 / (0.06 * 0.026)) and r.length_ratio == pytest.approx(13 / 60)
    assert r.feed_blocked_arc is None


def test_a_load_is_that_given_or_the_reaction_of_the_shaft():
    front, rear = (replace(row, load=None) for row in design(alone()).rows)
    shaft = SimpleNamespace(loads={"front": 0.5, "rear": 7.0})
    assert (_load(front, shaft), _load(rear, shaft), _load(front, None)) == (0.5, 7.0, 0.0)
    assert _load(replace(front, load=3.0), shaft) == 3.0


def test_a_slope_is_that_given_for_the_bearing_or_that_of_the_shaft():
    shaft = SimpleNamespace(slopes={"front": 3e-4, "rear": 4e-4})
    rows = design(alone()).rows
    for slopes, found in (((1e-4, 1e-4), (1e-4, 1e-4)), ((1e-4, None), (1e-4, 4e-4)), ((None, None), (3e-4, 4e-4))):
        given = [replace(row, slope=slope) for row, slope in zip(rows, slopes)]
        assert tuple(_slope(row, shaft) for row in given) == found
    assert _slope(rows[0], None) is None and _slope(rows[0], SimpleNamespace(slopes={})) is None


def test_a_film_from_python_is_that_of_the_step():
    """By default a hole of 4 mm at 3 bar, and a load that turns with the shaft."""
    of = dict(diameter=0.06, length=0.03, clearance=80e-6, load=3000.0, speed=25.0)
    film = solve_film(**of, oil="SAE 30", supply_temperature=60.0)
    document = alone(load_speed_ratio=1.0, supply_pressure_bar=3.0, hole_diameter_mm=4.0)
    r = solve(design(document)).outcomes["bearings"].result.bearings["front"]
    assert (film.film, film.oil_flow) == (pytest.approx(r.film), pytest.approx(r.oil_flow))
    assert (r.attitude_angle, r.film_pressure_max) == (film.attitude, pytest.approx(film.largest_pressure))
    cold = solve_film(**of, oil="SAE 30", supply_temperature=60.0, housing="EN AC-43100", warm=False)
    assert cold.clearance == pytest.approx(80e-6)


def test_shear_thinning_is_a_matter_of_multigrades():
    plain = {c.id for c in solve(design(alone())).outcomes["bearings"].checks}
    multi = {c.id for c in solve(design(alone(oil="10W-40"))).outcomes["bearings"].checks}
    assert "bearings.front.shear_rate" in multi - plain


def test_a_balance_far_above_the_supply_is_found_too():
    """−20 °C, 30 N: a rise of 175.9 K, found by a scan of all rises."""
    found = solve(design(alone(supply_temperature_C=-20.0, front__load_N=30.0))).outcomes["bearings"]
    assert found.state == "solved" and found.result.bearings["front"].temperature_rise == pytest.approx(175.9, abs=0.5)


def test_thin_oil_asks_for_less_load_or_clearance_and_not_for_more_clearance():
    small = dict(diameter_mm=20.0, length_mm=12.0, load_N=4000.0, clearance_um=90.0)
    heavy = {f"{place}__{key}": value for place in ("front", "rear") for key, value in small.items()}
    heavy |= dict(
        oil="SAE 20",
        supply_temperature_C=27.0,
        supply_pressure_bar=1.0,
        hole_diameter_mm=2.0,
        speed_rpm=800.0,
        load_speed_ratio=1.0,
    )
    reason = solve(design(alone(**heavy))).outcomes["bearings"].reason
    assert "less clearance" in reason and "more clearance" not in reason


def test_a_corner_that_is_seized_at_its_supply_has_no_film():
    """A steel journal in aluminium at −40 °C: a clearance of 30 µm at 20 °C is −6 µm, alone and as a corner."""
    cold = dict(
        housing_material="EN AC-43100",
        supply_temperature_C=-40.0,
        speed_rpm=300.0,
        front__load_N=6000.0,
        rear__load_N=6000.0,
    )
    tight = solve(design(alone(**cold, front__clearance_um=30.0, rear__clearance_um=30.0))).outcomes["bearings"]
    assert "seized" in tight.reason
    wider = solve(design(alone(**cold, front__clearance_um=60.0, rear__clearance_um=60.0))).outcomes["bearings"]
    assert wider.state == "solved" and wider.result.bearings["front"].corners.film is None


def test_lands_that_are_too_short_ask_for_a_narrower_groove():
    grooved = alone(supply="groove", groove_width_mm=22.0)
    assert "narrower groove" in solve(design(grooved)).outcomes["bearings"].reason


def test_speeds_without_a_film_are_told():
    found = solve(design(alone(speed_range_rpm=[5.0, 3000.0]))).outcomes["bearings"]
    assert any("no film of the front bearing is found" in note and "5 rpm" in note for note in found.notes)


@pytest.mark.parametrize(
    ("turns", "lost"),
    [
        (0.0, True),  # a load that stays: none carries it when it is slow
        (1.0, False),  # one that turns is next to nothing there
    ],
)
def test_a_speed_of_the_range_at_which_no_film_carries_the_load_fails(turns, lost):
    found = solve(design(alone(speed_range_rpm=[5.0, 3000.0], load_speed_ratio=turns))).outcomes["bearings"]
    sweep = found.result.bearings["front"].sweep
    assert math.isnan(sweep.films[0]) and (sweep.lost is not None) is lost
    (over,) = (c for c in found.checks if c.id == "bearings.front.film_edge_range")
    assert (over.verdict == "fail") is lost and ("none at 5 rpm" in over.name) is lost


GROOVE = {"hole_diameter_mm": None, "supply": "groove", "groove_width_mm": 4.0}


@pytest.mark.parametrize(
    ("feed", "key", "load", "length"),
    [
        ({}, "specific_load", 12000.0, 30.0),
        (GROOVE, "specific_load", 12000.0, 30.0),
        ({}, "heat_index", 11000.0, 30.0),
        (GROOVE, "heat_index", 11000.0, 30.0),
        ({}, "length_ratio_usual", 3000.0, 14.5),
        (GROOVE, "length_ratio_usual", 3000.0, 30.0),
        ({}, "length_ratio_usual", 3000.0, 50.0),
        (GROOVE, "length_ratio_usual", 3000.0, 99.0),
    ],
)
def test_the_length_that_a_check_names_is_just_enough(feed, key, load, length):
    """Of a bearing that a groove parts, too: its lands carry the load, and each of them has the ratio l/d."""

    def judged(length):
        results = solve(design(alone(speed_rpm=3000.0, front__load_N=load, front__length_mm=length, **feed)))
        (found,) = (one for one in results.checks() if one.id == f"bearings.front.{key}")
        return found

    (((name, enough),),) = (one.changes for one in judged(length).remedies)
    assert name == "shafts.shaft.bearings.front.length_mm" and judged(length).margin < 0
    assert judged(enough).margin >= 0
    assert judged(enough - (0.05 if enough > length else -0.05)).margin < 0
