"""The bearing step: what the source's design gives, and what must hold for any bearing."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.bearings.plain.checks import checks
from calc.bearings.solve import _slope_checks
from calc.library.catalogue import materials
from tests.calc.bearings.documents import outcome

ALUMINIUM = materials()["EN AC-43100"]


def without_bench(document):
    return replace(
        document, data={**document.data, "engine": {k: v for k, v in document.data["engine"].items() if k != "bench"}}
    )


def verdicts(found):
    return {c.id: c.verdict for c in found.checks}


def test_the_route_on_the_given_clearance(gamma_results):
    """Reynolds, clearance as given, swept hole: front 10.38 µm, 6.22 K, 91.6 W at 1710 N (here 1706.8 N, the shaft's
    own reaction)."""
    r = gamma_results.outcomes["bearings"].result.bearings["front"].routes["reynolds"]
    assert r.film * 1e6 == pytest.approx(10.38, rel=2e-3)
    assert r.temperature_rise == pytest.approx(6.22, rel=2e-3)
    assert r.friction_power == pytest.approx(91.6, rel=2e-3)


def test_both_journals_lose_278_watts_on_the_given_clearance(gamma_results):
    found = gamma_results.outcomes["bearings"].result.bearings
    assert sum(r.routes["reynolds"].friction_power for r in found.values()) == pytest.approx(277.65, rel=2e-3)


def test_the_source_methods_beside(gamma_results):
    """Finotti's charts give 10.8 µm and 6.34 K (read to ±5 %); Falz by the source's rule 8.9 µm front, 20.8 µm rear."""
    found = gamma_results.outcomes["bearings"].result.bearings
    assert found["front"].routes["raimondi_boyd"].film * 1e6 == pytest.approx(10.8, rel=0.05)
    assert found["front"].routes["raimondi_boyd"].temperature_rise == pytest.approx(6.34, rel=0.02)
    assert found["front"].routes["falz"].film * 1e6 == pytest.approx(8.9, abs=0.06)
    assert found["rear"].routes["falz"].film * 1e6 == pytest.approx(20.8, abs=0.06)


def test_the_source_design_fails_where_it_did_not_look(gamma_results):
    found = verdicts(gamma_results.outcomes["bearings"])
    assert found["bearings.front.film_edge"] == "fail"
    assert found["bearings.front.film_edge_range"] == "fail"
    assert found["bearings.front.film_double_load"] == found["bearings.rear.film_double_load"] == "note"
    assert found["bearings.rear.film_edge"] == "pass"
    assert found["bearings.front.mckee"] == "note"
    assert all(c.advice for c in gamma_results.outcomes["bearings"].checks if c.verdict != "pass")


def test_an_oil_that_carries_nothing_once_thinned_says_so(gamma):
    found = outcome(gamma, front__length_mm=7.0)
    r = found.result.bearings["front"]
    assert r.film > 0 and r.film_sheared is None and verdicts(found)["bearings.front.film_edge_sheared"] == "warn"
    assert any("Front bearing: no film is found for an oil thinned by shear" in note for note in found.notes)


def test_what_a_slope_given_too_small_hides_is_told(gamma):
    """The film at the edge that its remedy tells is the one that the design has once the slope is left out."""
    told = {
        c.id: c.remedies[0].effect.parts["edge"].number for c in outcome(gamma).checks if c.id.endswith("slope_given")
    }
    left_out = outcome(gamma, front__slope_mrad=None, rear__slope_mrad=None).result.bearings
    assert len(told) == 2
    for id, edge in told.items():
        assert edge == pytest.approx(left_out[id.split(".")[1]].film_edge * 1e6, rel=1e-9)


def test_each_slope_given_is_held_against_that_of_its_end(gamma_results):
    results = gamma_results.outcomes["bearings"].result.bearings
    shaft = gamma_results.outcomes["countershaft"].result

    def sloped(**slopes):
        return {
            place: replace(r, seat=replace(r.seat, bearing=replace(r.seat.bearing, slope=slopes.get(place))))
            for place, r in results.items()
        }

    for slopes in ({"front": 3e-4, "rear": 3e-4}, {"front": 3e-4, "rear": 4e-4}, {"rear": 4e-4}):
        checks = {c.id.split(".")[1]: c for c in _slope_checks(shaft, sloped(**slopes))}
        assert {place: c.value for place, c in checks.items()} == pytest.approx(
            {place: slope * 1e3 for place, slope in slopes.items()}
        )
        assert {place: c.limit for place, c in checks.items()} == pytest.approx(
            {place: shaft.slopes[place] * 1e3 for place in slopes}
        )
    assert list(_slope_checks(shaft, sloped())) == []
    assert list(_slope_checks(None, results)) == []


def test_the_material_that_the_design_has_is_marked_and_the_clearance_is_as_made(gamma_results):
    outcome = gamma_results.outcomes["bearings"]
    (bushes,) = (x for x in outcome.tables if x.id == "bushes")
    assert [row[0] for row in bushes.rows if "chosen" in str(row[0])] == ["EN AC-43100, chosen"]
    (usual,) = (c for c in outcome.checks if c.id == "bearings.front.clearance_usual")
    front, _ = gamma_results.design.rows
    assert usual.value == pytest.approx(outcome.result.bearings["front"].clearance / front.diameter * 1e3)


def test_a_slope_given_against_a_shaft_that_nothing_bends(gamma):
    """Its own slope is 0: the margin is a share of what is taken where no slope is known."""
    masses = {f"shafts__shaft__masses__{mass['name']}__mass_kg": 0.0 for mass in gamma.data["shafts"][0]["masses"]}
    found = outcome(gamma, front__load_N=3000.0, rear__load_N=3000.0, **masses)
    given = [c for c in found.checks if c.id.endswith("slope_given")]
    assert [(c.limit, c.scale, c.verdict) for c in given] == [(0.0, pytest.approx(0.1), "pass")] * 2


@pytest.mark.parametrize(
    "kind, most",
    [
        ("grease", 20_000),
        ("ring", 40_000),
        ("ring_moving_air", 70_000),
        ("ring_fast_air", 200_000),
        ("forced", 70_000),
        ("forced_cooled", 500_000),
    ],
)
def test_the_heat_index_is_held_against_the_row_of_its_lubrication(gamma_results, kind, most):
    """Finotti 2013, Table 3.1, as printed; only the last row lets go beyond its range."""
    r = gamma_results.outcomes["bearings"].result.bearings["rear"]
    oiled = replace(r, seat=replace(r.seat, inputs=replace(r.seat.inputs, lubrication=kind)))
    found = {c.id.split(".")[-1]: c for c in checks("rear", oiled, ALUMINIUM)}
    assert found["heat_index"].limit == most and found["heat_index"].verdict == ("pass" if most > 168_128 else "note")


def test_a_rise_of_the_oil_beyond_20_degrees_is_told(gamma_results):
    """Finotti 2013, 5.5.2: ΔT ≤ 15 ÷ 20 °C."""
    r = gamma_results.outcomes["bearings"].result.bearings["front"]
    for rise, verdict in ((19.9, "pass"), (20.1, "note")):
        found = {c.id: c for c in checks("front", replace(r, temperature_rise=rise), ALUMINIUM)}
        assert found["bearings.front.temperature_rise_usual"].verdict == verdict


def test_steel_in_aluminium_opens_by_60_micrometres(gamma_results):
    """59.5 mm · 10·10⁻⁶/K · 100 K = 59.5 µm at 120 °C; at the film's 120.9 °C a little more."""
    r = gamma_results.outcomes["bearings"].result.bearings["front"]
    assert (r.clearance_hot - r.clearance) * 1e6 == pytest.approx(59.5, rel=0.02)
    assert r.clearance_cold * 1e6 == pytest.approx(80.3025 - 59.5e-3 * 10 * 40, abs=0.01)


def test_a_clearance_meant_warm_seizes_when_cold(gamma):
    found = outcome(gamma, clearance_reference_temperature_C=123.1)
    r = found.result.bearings["front"]
    assert r.clearance_cold * 1e6 == pytest.approx(-4.8, abs=0.05)
    assert verdicts(found)["bearings.front.clearance_cold"] == "fail"


def test_a_housing_that_expands_like_the_journal_keeps_the_clearance(gamma):
    r = outcome(gamma, housing_material="steel").result.bearings["front"]
    assert r.clearance_hot == pytest.approx(r.clearance)
    assert r.film == pytest.approx(r.routes["reynolds"].film)


def test_the_block_may_hold_the_housing_back(gamma):
    free = outcome(gamma).result.bearings["front"].clearance_hot
    held = outcome(gamma, expansion_restraint=0.4).result.bearings["front"].clearance_hot
    assert held < free


def test_the_thinnest_film_is_found_not_assumed(gamma_results):
    """The no-load row (2646 rpm) does not govern, and the hottest loaded row is not the fastest."""
    assert gamma_results.outcomes["bearings"].result.bearings["front"].speed_of_thinnest_film * 60 == pytest.approx(
        2497
    )


def test_without_a_bench_run_a_range_is_swept(gamma):
    found = outcome(without_bench(gamma))
    assert found.result.bearings["front"].speed_of_thinnest_film * 60 == pytest.approx(2600)


def test_a_full_groove_halves_the_bearing(gamma):
    """Split bearing: 5.81 µm, 119.5 W on the given clearance with a groove of no width."""
    found = outcome(gamma, supply="groove", groove_width_mm=0.0)
    r = found.result.bearings["front"].routes["reynolds"]
    assert r.film * 1e6 == pytest.approx(5.81, rel=5e-3)
    assert r.friction_power == pytest.approx(119.5, rel=5e-3)
    assert r.temperature_rise == pytest.approx(3.68, rel=5e-3)


@pytest.mark.parametrize(
    "supply, more", [("pocket", {"pocket_width_mm": 8.0, "pocket_length_mm": 20.0}), ("shaft", {})]
)
def test_other_supplies(gamma, supply, more):
    document = gamma.with_value("bearings.supply", supply)
    for key, value in more.items():
        document = document.with_value(f"bearings.{key}", value)
    assert outcome(document).state == "solved"


def test_no_oil_through_a_fast_shaft(gamma):
    found = outcome(
        without_bench(gamma),
        supply="shaft",
        supply_pressure_bar=0.2,
        engine__rated_speed_rpm=6000.0,
    )
    assert found.state == "no_solution"
    assert "through the shaft" in found.reason


@pytest.mark.parametrize(
    "key, value, words",
    [
        ("shafts.shaft.bearings.front.length_mm", 4.0, "l/d"),
        ("shafts.shaft.masses.front.mass_kg", 300.0, "no film carries"),
    ],
)
def test_what_has_no_film_says_so(gamma, key, value, words):
    found = outcome(gamma.with_value(key, value), hole_diameter_mm=2.0)
    assert found.state == "no_solution"
    assert words in found.reason


def test_d341_is_selectable(gamma):
    walther = outcome(gamma).result.bearings["front"].hot.oil.nu
    astm = outcome(gamma, viscosity_law="d341").result.bearings["front"].hot.oil.nu
    assert astm / walther - 1 == pytest.approx(-0.003, abs=1.5e-3)


@settings(max_examples=8, deadline=None)
@given(length=st.floats(20, 45))
def test_a_longer_bearing_has_a_thicker_film(gamma, length):
    short = outcome(gamma, front__length_mm=length).result.bearings["front"].film
    longer = outcome(gamma, front__length_mm=length + 2).result.bearings["front"].film
    assert longer > short


@settings(max_examples=10, deadline=None)
@given(length=st.floats(22, 40), clearance=st.floats(40, 120), temperature=st.floats(80, 130))
def test_all_heat_leaves_with_the_oil(gamma, length, clearance, temperature):
    """The film that is shown closes its own balance: P_f = ρ·c_p·Q·ΔT at the mean temperature."""
    changed = gamma.with_value("shafts.shaft.bearings.front.clearance_factor", None).with_value(
        "shafts.shaft.bearings.front.clearance_um", clearance
    )
    hot = outcome(changed, front__length_mm=length, supply_temperature_C=temperature).result.bearings["front"].hot
    assert hot.mean_temperature == pytest.approx(temperature + hot.temperature_rise / 2, abs=1e-8)
    assert hot.friction_power == pytest.approx(hot.oil.rho * hot.oil.cp * hot.oil_flow * hot.temperature_rise, rel=1e-9)


def test_no_film_at_twice_the_load_is_told_and_not_the_end_of_the_step(gamma):
    found = outcome(gamma, front__length_mm=8.0)
    r = found.result.bearings["front"]
    assert found.state == "solved" and r.film > 0 and r.film_double_load is None
    assert verdicts(found)["bearings.front.film_double_load"] == "note"


def test_a_row_of_the_bench_that_hardly_loads_the_film_is_a_gap(gamma):
    rows = [*gamma.data["engine"]["bench"], {"speed_rpm": 300.0, "oil_temperature_C": 20.0, "oil_pressure_bar": 3.0}]
    document = replace(gamma, data={**gamma.data, "engine": {**gamma.data["engine"], "bench": rows}})
    r = outcome(document).result.bearings["front"]
    assert r.speed_of_thinnest_film * 60 == pytest.approx(2497)


def test_rows_above_the_rated_speed_govern_where_masses_are_the_load(gamma):
    """Without torque a gear's force is gone, and the force of turning masses is larger than ever."""
    slower = gamma.with_value("engine.rated_speed_rpm", 800.0)
    r = outcome(slower).result.bearings["front"]
    assert r.sweep.given and max(r.sweep.speeds) * 60 == pytest.approx(2646)
    assert r.thinnest_film == pytest.approx(min(r.sweep.films))
    for place in ("front", "rear"):
        slower = slower.with_value(f"shafts.shaft.bearings.{place}.load_N", 500.0)
    r = outcome(slower, load_speed_ratio=0.0).result.bearings["front"]
    assert r.speed_of_thinnest_film * 60 <= 800 + 1e-6 and max(r.sweep.speeds) * 60 == pytest.approx(2646)


def test_a_housing_held_back_by_three_quarters_still_has_its_balance(gamma):
    """The bracket passes temperatures at which the journal would seize; the balance itself does not."""
    document = gamma.with_value("bearings.expansion_restraint", 0.75).with_value(
        "shafts.shaft.bearings.rear.clearance_factor", 0.8
    )
    r = outcome(document).result.bearings["front"]
    assert r.film * 1e6 == pytest.approx(9.548, rel=1e-3)
    assert r.temperature_rise == pytest.approx(27.45, rel=1e-3)


def test_too_little_load_is_told_from_too_much(gamma):
    light = outcome(gamma, front__load_N=0.5, rear__load_N=0.5)
    assert "nearly centred" in light.reason and "thinner or warmer oil" in light.reason


def test_without_supply_pressure_the_charts_take_their_own_flow(gamma):
    found = outcome(gamma, supply_pressure_bar=0.0)
    r = found.result.bearings["front"]
    # by an independent balance: 10.7 K front, 14.4 K rear
    assert r.routes["raimondi_boyd"].temperature_rise == pytest.approx(10.7, abs=0.06)
    assert found.result.bearings["rear"].routes["raimondi_boyd"].temperature_rise == pytest.approx(14.4, abs=0.2)
    assert (
        r.routes["raimondi_boyd"].oil_flow == r.routes["raimondi_boyd_own_flow"].oil_flow
        and r.routes["raimondi_boyd"].side_flow < r.routes["raimondi_boyd"].oil_flow
    )
    assert not any("no oil flows" in note for note in found.notes)


def test_a_hole_outside_the_range_of_its_factor_warns(gamma):
    assert verdicts(outcome(gamma, hole_diameter_mm=26.0))["bearings.front.supply_range"] == "note"
    assert verdicts(outcome(gamma))["bearings.front.supply_range"] == "pass"


def test_a_speed_range_is_judged_where_the_film_is_thinnest(gamma):
    """From 800 to 6000 rpm the load of the eccentric masses is five times that of rated speed: the film fails there,
    and it is said."""
    found = outcome(gamma, speed_range_rpm=[800.0, 6000.0])
    r = found.result.bearings["front"]
    assert r.speed_of_thinnest_film * 60 == pytest.approx(6000)
    check = {c.id: c for c in found.checks}["bearings.front.film_edge_range"]
    assert check.verdict == "fail" and "6000 rpm" in check.name
    assert check.value == pytest.approx((r.thinnest_film - (r.film - r.film_edge)) * 1e6)
    assert not any("without load" in note for note in found.notes)


def test_heat_that_is_not_carried_away_asks_for_clearance_and_not_for_thicker_oil(gamma):
    reason = outcome(gamma, expansion_restraint=1.0).reason
    assert "not carried away" in reason and "clearance" in reason and "thicker" not in reason


def test_a_given_viscosity_has_its_film_whatever_its_heat(gamma):
    """800 mPa·s at every temperature: 370 K of heat on the way through, which no balance is asked for; the film of the
    charts at that viscosity stands, and the temperature fails.  With an oil of its own law there is no film to tell."""
    found = outcome(gamma, viscosity_mPas=800.0)
    r = found.result.bearings["front"]
    assert r.temperature_rise > 200 and verdicts(found)["bearings.front.temperature"] == "fail"
    assert any("the heat has no balance" in note for note in found.notes)
    assert r.corners.outlet_temperature == pytest.approx(r.corners.columns["outlet_temperature"].max(), rel=1e-6)
    assert r.corners.outlet_temperature > r.outlet_temperature
    # clearance at 200 K of heat, 100 K above the supply on average
    psi = r.seat.clearance_at(r.duty.supply_temperature + 100.0) / r.seat.bearing.diameter
    assert r.sommerfeld == pytest.approx(0.8 * r.duty.effective_speed / (r.specific_load * psi**2), rel=1e-9)
    warmer = outcome(gamma, viscosity_mPas=300.0)
    assert warmer.result.bearings["front"].temperature_rise < 200
    assert not any("no balance" in note for note in warmer.notes)


def test_a_load_near_half_speed_is_told_by_its_speed(gamma):
    assert "52 rpm" in outcome(gamma, load_speed_ratio=0.49).reason


def test_values_found_among_many_lead_back_to_the_inputs(gamma_results):
    from calc.studies.explain import chain

    for value in ("corners.film_edge", "corners.film_double_load", "corners.outlet_temperature", "thinnest_film"):
        inputs = {key for link in chain(gamma_results, f"bearings.front.{value}") for key in link.inputs}
        assert {"shafts.shaft.bearings.front.diameter_mm", "shafts.shaft.bearings.front.clearance_factor"} <= inputs, (
            value
        )


def test_the_worst_of_the_corners_has_symbols_of_its_own(gamma_results):
    """One quantity, one symbol: the film as designed and that of the worst corner are two."""
    values = {v.id: v for v in gamma_results.outcomes["bearings"].values() if v.id.startswith("bearings.front.")}
    worst = {id: v for id, v in values.items() if ".corners." in id and v.symbol}
    assert len(worst) >= 5
    designed = {v.symbol for id, v in values.items() if id not in worst}
    assert [id for id, v in worst.items() if v.symbol in designed] == []


def test_the_design_stands_on_its_curves_and_fails_with_its_film(gamma_results):
    found = gamma_results.outcomes["bearings"]
    judged = verdicts(found)
    curves = {c.id: c for c in found.curves}
    for place in ("front", "rear"):
        over_speed, over_clearance = curves[f"film_{place}"], curves[f"film_over_clearance_{place}"]
        x, y = over_clearance.point
        line = next(s for s in over_clearance.series if s.label == "at the edge")
        assert np.interp(x, line.x, line.y) == pytest.approx(y, rel=1e-6)
        # with the oil of the design, the line has that of the bench run
        assert over_speed.point == pytest.approx((2600, y))
        assert over_speed.fails == over_clearance.fails == (judged[f"bearings.{place}.film_edge"] == "fail")
    assert {judged[f"bearings.{place}.film_edge"] for place in ("front", "rear")} >= {"fail"}
