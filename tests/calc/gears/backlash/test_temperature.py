"""Backlash over temperature: the shifts of aluminium and iron, wheels of two materials, what the checks advise."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.gears.backlash import temperature as t
from calc.gears.backlash.case import cases
from calc.sheet.errors import NoSolution
from tests.calc.gears.backlash.plays import SHAVED, SOLIDS, alone, changed, played, true
from tests.calc.gears.trains import mesh, pair_1, r753, solved, train, wheel

PRINTED = ((-2, -20), (-20, -30))


def states(play, mesh="central–idler"):
    """Rows of the table by the state: Δa_eff and the three backlashes [µm]."""
    table = next(table for table in play.tables() if table.id == "backlash_states")
    return {row[1]: row[4:] for row in table.rows if row[0] == mesh}


@pytest.mark.parametrize("allowances, expected", [(PRINTED, (-14.7, 36.0, 86.8)), (SHAVED, (3.3, 50.0, 96.8))])
def test_the_reference_state_is_the_backlash_over_the_tolerance(allowances, expected):
    """Recomputed from the allowances of Finotti 2013, 4.5, at 80.555 ± 0.055 mm: as printed the first pair can jam."""
    play, _ = alone(allowances, housing="aluminium")
    assert states(play)["reference"] == pytest.approx((0, *expected), abs=0.05)


def test_aluminium_and_iron_80_K_warmer():
    """Small-change figures: a·Δα·80 K is 0.074 and 0.063 mm for aluminium 23·10⁻⁶/K, −0.003 mm for cast iron 11·10⁻⁶/K,
    on the wheels of
    11.5·10⁻⁶/K; the backlash of the aluminium housing rises by 0.049 and 0.042 mm."""
    shaft = played(true(r753()), "aluminium").meshes
    assert shaft["central_idler"].centre_change_running == pytest.approx(0.074e-3, abs=0.5e-6)
    assert shaft["idler_shaft"].centre_change_running == pytest.approx(0.063e-3, abs=0.5e-6)
    for key, more in (("central_idler", 0.049e-3), ("idler_shaft", 0.042e-3)):
        cold = solved(r753()).meshes[key].backlash_min
        assert shaft[key].backlash_running - cold == pytest.approx(more, abs=0.5e-6)
    assert alone(housing="iron")[1].centre_change_running == pytest.approx(-0.003e-3, abs=0.5e-6)


def test_a_cold_start_takes_the_backlash_of_an_aluminium_housing():
    """At −30 °C the first pair loses 0.031 mm: even −20/−30 µm on both wheels becomes negative."""
    play, cold = alone(housing="aluminium")
    plain = solved(pair_1(allowances=SHAVED)).meshes["central_idler"].backlash_min
    assert plain > 0 > cold.backlash_cold
    assert cold.backlash_cold - plain == pytest.approx(-0.031e-3, abs=0.5e-6)
    check = next(c for c in play.checks if c.id == "gears.central_idler.backlash_cold")
    assert check.verdict == "not_verified" and check.kind == "limit" and check.missing == ("gears.housing_material",)
    assert check.at_best == pytest.approx(plain * (1 - 50 * 11.5e-6) * 1e6), "the housing grows as the driver"
    assert check.at_worst == pytest.approx(cold.backlash_cold * 1e6), "what is taken grows more than the aluminium"
    check = next(c for c in alone(housing="iron")[0].checks if c.id == "gears.central_idler.backlash_cold")
    assert check.at_worst == pytest.approx(alone(housing="EN AC-43100")[1].backlash_cold * 1e6)


@settings(max_examples=40, deadline=None)
@given(st.floats(0, 40e-6), st.floats(-60, 60), st.floats(0, 200), st.floats(0, 60))
def test_small_changes_are_linear(alpha, cold, warm, warmer):
    """j(T) = k·j + 2·Δa_eff·sin α_wt·cos β_b, good to Δa_eff² and to the change of the slope over the tolerance."""
    housing = replace(SOLIDS["aluminium"], name="housing", expansion=alpha)
    gears = true(pair_1(allowances=SHAVED))
    gears = replace(gears, lowest_temperature=cold, running_temperature=warm, wheels_warmer=warmer)
    train_ = solved(gears)
    (m,) = cases(gears, train_)
    expansions = t.expansions(m, gears, {**SOLIDS, "housing": housing}, "housing")
    slope = 2 * math.sin(m.mesh.working_pressure_angle) * math.cos(train_.system.base_helix_angle)
    for state in t.states(gears, warmer):
        grown = t.grown(m, expansions, state.housing, state.wheels)
        change = t.change(m, grown)
        j = t.at_state(m, grown, m.mesh.centre_distance, *(teeth.middle for teeth in m.teeth)).backlash
        growth = 1 + 11.5e-6 * (state.wheels - 20)
        assert j == pytest.approx(growth * (m.mesh.backlash_nominal + slope * change), abs=30 * change**2 + 1e-12)


@pytest.mark.parametrize("allowances", [PRINTED, SHAVED, ((0, 0), (0, 0))])
def test_a_housing_that_grows_as_the_wheels_only_scales_the_backlash(allowances):
    _, mesh_ = alone(allowances)
    plain = solved(pair_1(allowances=allowances)).meshes["central_idler"].backlash_min
    assert mesh_.centre_change_cold == pytest.approx(0, abs=1e-15)
    assert mesh_.backlash_cold == pytest.approx(plain * (1 - 50 * 11.5e-6), abs=1e-14)
    assert mesh_.backlash_running == pytest.approx(plain * (1 + 80 * 11.5e-6), abs=1e-14)


def test_without_tolerance_and_allowance_no_dust_is_judged():
    gears = true(train([wheel("a", 36, 0.014), wheel("b", 39)], [mesh("a", "b", 80.555)]))
    play = played(gears)
    assert play.meshes["a_b"].backlash_cold == play.meshes["a_b"].backlash_min_runout == 0.0
    assert next(c for c in play.checks if c.id == "gears.a_b.backlash_cold").holds
    assert play.shafts["shaft"].phase_error_median is None and play.meshes["a_b"].backlash_median is None


def free_turn_of_points(d_b, half, pitch, a, points=20001):
    """How far the second wheel turns while a tooth of the first stands on the line of centres, by points along both
    flanks.

    `d_b`, `half`: base diameters, and half tooth angles at them; `pitch`: pitch angles.  Each point of the driver's
    flank is put into polar coordinates of the second wheel, where the flank of its space has another angle at the same
    radius: the least of the differences is the turn to contact."""

    def inv(r, r_b):
        x = np.arccos(r_b / r)
        return np.tan(x) - x

    r_b1, r_b2 = d_b[0] / 2, d_b[1] / 2
    r = r_b1 * np.linspace(1.02, 1.16, points)
    phi = half[0] - inv(r, r_b1)  # half angle of the tooth of the first wheel
    x, y = a - r * np.cos(phi), r * np.sin(phi)
    R, theta = np.hypot(x, y), np.arctan2(y, x)
    on = R > r_b2 * 1.0001
    space = pitch[1] / 2 - (half[1] - inv(R[on], r_b2))  # half angle of the space
    return 2 * (space - theta[on]).min()  # the same on both sides


@pytest.mark.parametrize(
    "second, housing",
    [("steel", "aluminium"), ("ADI 1050", "aluminium"), ("ADI 1050", "iron"), ("EN AC-43100", "iron")],
)
@pytest.mark.parametrize("T", [-30.0, 100.0])
def test_wheels_of_two_materials_against_points_on_their_flanks(second, housing, T):
    """The tooth stands in a space of the wheel with the smaller pitch; the larger one differs by 5 nm at most here."""
    gears = changed(pair_1(allowances=SHAVED), wheels={"idler": {"material": second}})
    train_ = solved(gears)
    (m,) = cases(gears, train_)
    grown = t.grown(m, t.expansions(m, gears, SOLIDS, housing), T, T)
    k = 1 + 11.5e-6 * (T - 20), 1 + SOLIDS[second].expansion * (T - 20)
    s_b = [teeth.middle for teeth in m.teeth]
    d_b = m.driver.base_diameter, m.driven.base_diameter
    a = m.mesh.centre_distance * (1 + SOLIDS[housing].expansion * (T - 20))
    turn = free_turn_of_points(
        [k[0] * d_b[0], k[1] * d_b[1]], [s / d for s, d in zip(s_b, d_b)], [2 * np.pi / 36, 2 * np.pi / 39], a
    )
    expected = turn * k[1] * d_b[1] / 2 * math.cos(train_.system.base_helix_angle)
    found = t.at_state(m, grown, m.mesh.centre_distance, *s_b).backlash
    larger_pitch = max(0.0, k[1] - k[0]) * train_.system.base_pitch * math.cos(train_.system.base_helix_angle)
    assert found + larger_pitch == pytest.approx(expected, abs=1e-9)


def test_the_wheel_that_grows_less_gives_the_growth():
    gears = changed(pair_1(allowances=SHAVED), wheels={"idler": {"material": "EN AC-43100"}})
    (m,) = cases(gears, solved(gears))
    grown = t.grown(m, t.expansions(m, gears, SOLIDS, "iron"), 100.0, 120.0)
    at = t.at_state(m, grown, m.closest, *(teeth.thickest for teeth in m.teeth))
    assert (at.wheel_growth, at.centre_growth) == pytest.approx((1 + 11.5e-6 * 100, 1 + 11e-6 * 80))


def test_base_circles_that_overlap_have_no_backlash_at_an_end():
    (m,) = cases(pair_1(), solved(pair_1()))
    alpha, (cold, *_) = t.Expansions(11e-6, 11e-6, 11e-6), t.states(pair_1(), 0.0)
    assert t.smallest(m, alpha, cold, 0.999 * m.touching) == -math.inf


def test_a_support_spans_its_share():
    """Half of steel and half of aluminium: the mean of both; a share of one is the support alone."""

    def change(share):
        gears = replace(changed(pair_1(allowances=SHAVED), support_share=share), support_material="aluminium")
        return played(gears, "steel").meshes["central_idler"].centre_change_running

    assert change(0.0) == pytest.approx(0, abs=1e-15)
    assert change(0.5) == pytest.approx(change(1.0) / 2, rel=1e-9)
    assert change(1.0) == pytest.approx(alone(housing="aluminium")[1].centre_change_running, rel=1e-12)


def test_wheels_warmer_than_an_iron_block_are_its_critical_state():
    _, mesh_ = alone(housing="iron")
    assert mesh_.backlash_warmer < mesh_.backlash_running < mesh_.backlash_cold


def test_wheels_that_warm_up_first_are_the_critical_state_of_a_cold_aluminium_housing():
    """It shrinks more than steel in the cold, and the wheels then grow before it does."""
    play, mesh_ = alone(housing="aluminium", housing_material="aluminium")
    assert mesh_.backlash_warming < mesh_.backlash_cold < mesh_.backlash_warmer
    taken = mesh_.backlash_cold - mesh_.backlash_warming
    a, alpha_wt = pair_1().meshes[0].centre_distance or 0.0, math.radians(20)
    assert taken == pytest.approx(20 * 11.5e-6 * 2 * a * math.sin(alpha_wt), rel=0.25), (
        "both wheels grow towards each other"
    )
    check = next(c for c in play.checks if c.id.endswith("backlash_warming"))
    assert check.value == pytest.approx(mesh_.backlash_warming * 1e6)
    assert check.at_best == pytest.approx(mesh_.backlash_cold * 1e6), "wheels no warmer than the housing"
    assert (check.kind, check.verdict) == ("limit", "fail")


def test_a_given_material_leaves_no_doubt():
    play, _ = alone(housing="aluminium", housing_material="aluminium")
    (check,) = (c for c in play.checks if c.id.endswith("cold"))
    assert (check.verdict, check.missing, check.at_best) == ("fail", (), None)


@pytest.mark.parametrize(
    "name, housing, said",
    [("backlash_cold", "aluminium", {}), ("backlash_warm", "iron", {"wheels_warmer": 30.0})],
)
def test_advice_just_passes(name, housing, said):
    """What the failing check advises passes by no narrow margin, with less than 1 µm (of the span), or 1 µm of the
    tolerance, to spare."""

    def value(gears):
        given = replace(gears, housing_material=housing, **said)
        return next(c for c in played(given, housing).checks if c.id.endswith(name))

    gears = true(pair_1(allowances=SHAVED))
    failing = value(gears)
    assert failing.value < 0
    ((key, ends),), ((place, tolerance),) = (one.changes for one in failing.remedies)
    thinner = changed(gears, wheels={key.split(".")[2]: {"span_allowance": tuple(end * 1e-6 for end in ends)}})
    enough = 0.05 * failing.zero_scale
    assert 0 <= value(thinner).value - enough < 1.0 and value(thinner).verdict == "pass"
    assert place == "gears.meshes.0.tolerance_um"
    assert 0 <= value(changed(gears, tolerance=tolerance * 1e-6)).value - enough < 1.0


def test_advice_holds_in_every_housing_that_nobody_names():
    gears = true(pair_1(allowances=SHAVED))

    def cold(gears):
        return next(c for c in played(gears, "aluminium").checks if c.id.endswith("backlash_cold"))

    jam = cold(gears)
    assert jam.verdict == "not_verified" and not jam.holds
    ((key, ends),), *_ = (way.changes for way in jam.remedies)
    thinner = changed(gears, wheels={key.split(".")[2]: {"span_allowance": tuple(end * 1e-6 for end in ends)}})
    free = cold(thinner)
    assert min(free.value - 0.05 * free.zero_scale, free.at_worst) == pytest.approx(0.5, abs=0.5)
    assert free.verdict == "pass"


def test_the_curve_meets_the_table():
    play, _ = alone(housing="aluminium")
    (curve,) = play.curves()
    at = states(play)
    nominal, warmer, smallest, largest = curve.series
    assert (smallest.y[0], nominal.y[0], largest.y[0]) == pytest.approx(at["cold"][1:])
    assert (smallest.y[-1], nominal.y[-1], largest.y[-1]) == pytest.approx(at["running"][1:])
    assert warmer.y[-1] == pytest.approx(at["wheels warmer"][1])
    assert curve.limits == (("jam", 0.0),) and curve.id == "backlash_temperature_central_idler"
    assert warmer.y[0] == pytest.approx(at["warming up"][1])
    judged = at["cold"][1], at["running"][1], at["wheels warmer"][1], at["warming up"][1]
    assert curve.band and curve.point is not None and curve.point[1] == pytest.approx(min(judged))


def test_a_cold_that_lets_the_base_circles_overlap_is_no_solution():
    gears = train(
        [wheel("a", 20, 0.0), wheel("b", 20, 0.0)],
        [mesh("a", "b", tolerance=119.5)],
        m_n=0.1,
        alpha_n=20,
        beta=0.0,
        b=2.0,
    )
    solved(gears)  # at 20 °C it still meshes
    with pytest.raises(NoSolution, match="can not mesh"):
        played(replace(gears, lowest_temperature=-60.0), "aluminium")
