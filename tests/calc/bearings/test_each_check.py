# SPDX-License-Identifier: Apache-2.0
"""Every check of the bearings: just inside its limit, just outside, and what is not given; and films that makers'
journals have, computed independently of the checks."""

from dataclasses import replace

import numpy as np
import pytest

from calc.bearings.plain.checks import checks, least_film, oil_check
from calc.bearings.plain.corners import Exact
from calc.bearings.plain.loads import standing_checks
from calc.bearings.plain.materials import application, bearing_materials
from calc.bearings.plain.routes.routes import own_warm
from calc.bearings.plain.routes.thermal_balance import balanced
from calc.bearings.plain.suitability import application_checks, film_asked, material_checks
from calc.bearings.result import BearingsResult
from calc.countershaft.rows import BearingRow
from calc.design.toml_file import Document, design
from calc.library.catalogue import materials, oils
from calc.library.journal_rules import LUBRICATIONS, N_RPM_MM, speed_factor
from calc.library.lubricant import Lubricant
from calc.library.oils import high_shear
from calc.sheet.quantity import keys
from calc.solve import solve

UM, MPA = 1e-6, 1e6
ALUMINIUM = materials()["EN AC-43100"]


@pytest.fixture(scope="module")
def given(gamma_results):
    """The front bearing of the source, as if its fits and the viscosity of its oil at high shear were given."""
    r = gamma_results.outcomes["bearings"].result.bearings["front"]
    lubricant = Lubricant(replace(r.seat.lubricant.oil, hths=3.5e-3))
    inputs = replace(r.seat.inputs, journal_fit="IT7", seat_fit="IT7")
    return replace(r, seat=replace(r.seat, lubricant=lubricant, inputs=inputs), corners=replace(r.corners, exact=None))


def made(r, housing=ALUMINIUM):
    return {c.id.removeprefix("bearings.front."): c for c in checks("front", r, housing)}


def seated(r, **inputs):
    return replace(r, seat=replace(r.seat, inputs=replace(r.seat.inputs, **inputs)))


def oiled(r, **numbers):
    return replace(r, hot=replace(r.hot, oil=replace(r.hot.oil, **numbers)))


def cornered(r, **numbers):
    return replace(r, corners=replace(r.corners, **numbers))


def lengthened(r, length, land=None):
    """Of a length in mm; `land`: that of each of its lands."""
    seat = replace(r.seat, bearing=replace(r.seat.bearing, length=length * 1e-3))
    return replace(r, seat=seat, length_ratio=(land or length) / 59.5)


def slope_off(r):
    return r.film - r.film_edge


INSIDE = {"limit": "warn", "caution": "pass", "advice": "pass", "method": "pass"}  # a limit that just holds is narrow
OUTSIDE = {"limit": "fail", "caution": "warn", "advice": "note", "method": "note"}
TABLE = [
    # check, kind, how its value comes, just inside, just outside, in SI, the limit as shown, its source
    ("film_edge", "limit", lambda r, x: replace(r, film_edge=x), 9.01 * UM, 8.99 * UM, 9.0, "Kreisle"),
    (
        "film_edge_range",
        "limit",
        lambda r, x: replace(r, thinnest_film=x + slope_off(r)),
        9.01 * UM,
        8.99 * UM,
        9.0,
        "Kreisle",
    ),
    (
        "film_edge_speeds",
        "caution",
        lambda r, x: replace(r, thinnest_film=x + slope_off(r), sweep=replace(r.sweep, given=False)),
        9.01 * UM,
        8.99 * UM,
        9.0,
        "Kreisle",
    ),
    ("film_edge_sheared", "caution", lambda r, x: replace(r, film_sheared=x), 9.01 * UM, 8.99 * UM, 9.0, "SAE J300"),
    ("film_overspeed", "caution", lambda r, x: replace(r, film_overspeed=x), 9.01 * UM, 8.99 * UM, 9.0, "Kreisle"),
    ("film_edge_corner", "caution", lambda r, x: cornered(r, film_edge=x), 9.01 * UM, 8.99 * UM, 9.0, "Kreisle"),
    ("film_edge_usual", "advice", lambda r, x: replace(r, film_edge=x), 5.01 * UM, 4.99 * UM, 5.0, "ISO 7902-3"),
    ("film_double_load", "advice", lambda r, x: replace(r, film_double_load=x), 7.47 * UM, 7.45 * UM, 7.46, "Shigley"),
    ("film_trumpler", "advice", lambda r, x: replace(r, film=x), 7.47 * UM, 7.45 * UM, 7.46, "Trumpler"),
    ("film_pressure", "limit", lambda r, x: replace(r, film_pressure_max=x), 179e6, 181e6, 180.0, "proof stress"),
    ("film_band", "advice", lambda r, x: replace(r, film_band=x), 0.001, -0.001, (0.0, 100.0), "Raimondi"),
    ("film_band", "advice", lambda r, x: replace(r, film_band=x), 0.999, 1.001, (0.0, 100.0), "Raimondi"),
    ("temperature", "limit", lambda r, x: replace(r, outlet_temperature=x), 134.9, 135.1, 135.0, "engine maker"),
    ("temperature_corner", "caution", lambda r, x: cornered(r, outlet_temperature=x), 134.9, 135.1, 135.0, "corner"),
    ("temperature_trumpler", "advice", lambda r, x: replace(r, outlet_temperature=x), 119.9, 120.1, 120.0, "250 °F"),
    ("temperature_rise_usual", "advice", lambda r, x: replace(r, temperature_rise=x), 19.9, 20.1, 20.0, "15 to 20 °C"),
    ("specific_load", "caution", lambda r, x: replace(r, specific_load=x), 4.99e6, 5.01e6, 5.0, "Finotti"),
    (
        "specific_load_usual",
        "advice",
        lambda r, x: seated(replace(r, specific_load=x), bush_material="AlSn20Cu"),
        1.99e6,
        2.01e6,
        2.0,
        "Finotti",
    ),
    ("heat_index", "advice", lambda r, x: replace(r, heat_index=x * N_RPM_MM), 499e3, 501e3, 500e3, "Table 3.1"),
    ("clearance_cold", "limit", lambda r, x: replace(r, clearance_cold=x), 0.1 * UM, 0.0, 0.0, "seizure"),
    ("clearance_cold_corner", "limit", lambda r, x: cornered(r, clearance_cold=x), 0.1 * UM, 0.0, 0.0, "seizure"),
    ("length_ratio_usual", "advice", lambda r, x: replace(r, length_ratio=x), 0.26, 0.24, (0.25, 0.75), "5.5.2"),
    ("length_ratio_usual", "advice", lambda r, x: replace(r, length_ratio=x), 0.74, 0.76, (0.25, 0.75), "5.5.2"),
    ("transition", "advice", lambda r, x: replace(r, least_speed=x), 43.3, 43.4, None, "5.5.3"),
    ("mckee", "advice", lambda r, x: replace(r, mckee_number=x), 150.1, 149.9, 150.0, "McKee"),
    ("routes_spread", "method", lambda r, x: replace(r, routes_spread=x), 0.099, 0.101, 10.0, "rule of this program"),
    (
        "misalignment",
        "advice",
        lambda r, x: replace(r, slope=x / 27.5e-3, film=10 * UM),
        2.99 * UM,
        3.01 * UM,
        3.0,
        "0.3·h₀",
    ),
    (
        "friction_regime",
        "method",
        lambda r, x: replace(r, friction_coefficient=x),
        2.1e-3,
        1.9e-3,
        (2e-3, 0.012),
        "full",
    ),
    (
        "friction_regime",
        "method",
        lambda r, x: replace(r, friction_coefficient=x),
        0.0119,
        0.0121,
        (2e-3, 0.012),
        "full",
    ),
    ("viscosity_range", "method", lambda r, x: oiled(r, nu=x), 2.1e-6, 1.9e-6, (2.0, 1e5), "viscosity law"),
    ("shear_rate", "method", lambda r, x: replace(r, shear_rate=x), 0.99e5, 1.01e5, 1e5, "polymer"),
    (
        "supply_range",
        "method",
        lambda r, x: seated(r, hole_diameter=x * 27.5e-3),
        0.051,
        0.049,
        (0.05, 0.7),
        "Table 5.1",
    ),
    ("supply_range", "method", lambda r, x: seated(r, hole_diameter=x * 27.5e-3), 0.69, 0.71, (0.05, 0.7), "Table 5.1"),
]


@pytest.mark.parametrize(("key", "kind", "changed", "inside", "outside", "limit", "source"), TABLE)
def test_a_check_holds_just_inside_its_limit_and_not_just_outside(
    given, key, kind, changed, inside, outside, limit, source
):
    kept, missed = made(changed(given, inside))[key], made(changed(given, outside))[key]
    assert (kept.kind, kept.verdict, missed.verdict) == (kind, INSIDE[kind], OUTSIDE[kind])
    assert source in kept.source and (limit is None or kept.limit == pytest.approx(limit))
    assert missed.advice or key == "routes_spread"


def test_what_the_source_accepts_speaks_alone_beyond_it(given):
    """One verdict of one source: beyond 0.2 to 1 no word of the usual range, which lies inside."""
    for ratio in (0.19, 1.01):
        beyond = made(replace(given, length_ratio=ratio))
        assert beyond["length_ratio"].verdict == "note" and "length_ratio_usual" not in beyond
    for ratio in (0.201, 0.99):
        assert "length_ratio" not in made(replace(given, length_ratio=ratio))


def test_a_lined_seat_is_judged_by_its_lining_alone(given):
    lined = made(seated(given, bush_material="AlSn20Cu"))
    assert not {"specific_load", "film_pressure"} & set(lined)
    assert "specific_load_usual" not in made(given)


def test_the_fits_make_the_clearance_that_is_judged(given):
    """H7/f7 of 59.5 mm: 30 to 90 µm."""
    fitted = seated(given, journal_fit="f7", seat_fit="H7")
    for clearance, verdict in ((30.1, "pass"), (29.9, "warn"), (89.9, "pass"), (90.1, "warn")):
        check = made(replace(fitted, clearance=clearance * UM))["fit"]
        assert (check.verdict, check.kind, check.source) == (verdict, "caution", "ISO 286")
    assert "fit" not in made(seated(given, journal_fit="f7", seat_fit="IT7")), "a grade alone makes no clearance"


def test_a_film_beyond_the_rows_of_its_oil(given):
    rows = Lubricant(oils()["10W-40"])
    rows.oil = replace(rows.oil, nu40=None, nu100=None, viscosities=(Row(20.0), Row(120.0)))
    within = replace(given, seat=replace(given.seat, lubricant=rows))
    for T, verdict in ((119.9, "pass"), (120.1, "note")):
        check = made(replace(within, hot=replace(within.hot, mean_temperature=T)))["oil_rows"]
        assert (check.verdict, check.limit, check.kind) == (verdict, (20.0, 120.0), "method")


class Row:
    def __init__(self, temperature):
        self.temperature = temperature


def test_an_oil_is_pumped_above_its_limit(gamma_results):
    inputs = gamma_results.design.bearings
    for lowest, verdict in ((-23.9, "pass"), (-24.1, "warn")):
        oil = replace(oils()[inputs.oil], pumping_limit=-30.0, pour_point=-24.0)
        check = oil_check(replace(inputs, lowest_temperature=lowest), oil)
        assert (check.verdict, check.limit, check.kind) == (verdict, -24.0, "caution")
        assert check.source == oil.source
        assert oil_check(inputs, replace(oil, source="the user")).source == "given in the design"
    assert oil_check(inputs, replace(oil, pumping_limit=None, pour_point=None)) is None


def test_the_routes_that_are_far_off_are_named(given):
    for off, words in ((-0.101, "Raimondi & Boyd, own flow is −10 % off"), (-0.099, "")):
        side = replace(given.side, alike={"raimondi_boyd_own_flow": off, "iso7902": 0.099})
        check = made(replace(given, side=side))["routes_spread"]
        assert str(check.advice).startswith(words) and bool(check.advice) is bool(words)
        assert "ISO" not in check.advice and "10 %" in check.source


@pytest.mark.parametrize(
    ("key", "changed", "lengths"),
    [
        # of 27.5 mm: so much longer as its limit is passed over; of 59.5 mm a quarter to three quarters
        ("specific_load", lambda r: replace(r, specific_load=6e6), [("at least", 27.5 * 6 / 5)]),
        ("heat_index", lambda r: replace(r, heat_index=600e3 * N_RPM_MM), [("at least", 27.5 * 6 / 5)]),
        ("length_ratio_usual", lambda r: lengthened(r, 14.0), [("at least", 59.5 / 4)]),
        ("length_ratio_usual", lambda r: lengthened(r, 45.0), [("at most", 59.5 * 3 / 4)]),
        # two lands beside a groove of 5 mm
        (
            "specific_load",
            lambda r: seated(replace(r, specific_load=6e6), supply="groove", groove_width=5e-3),
            [("at least", 5 + 22.5 * 6 / 5)],
        ),
        (
            "length_ratio_usual",
            lambda r: lengthened(seated(r, supply="groove", groove_width=5e-3), 33.0, 14.0),
            [("at least", 59.5 / 2 + 5)],
        ),
        ("specific_load", lambda r: replace(r, specific_load=np.inf), []),
    ],
)
def test_the_length_that_would_do(given, key, changed, lengths):
    check = made(changed(given))[key]
    ways = [(way.words, way.changes) for way in check.remedies]
    assert not check.holds and len(ways) == len(lengths)
    for (words, changes), (bound, length) in zip(ways, lengths):
        ((name, x),) = changes
        assert name == "shafts.S.bearings.front.length_mm" and bound in words
        assert 0 <= (x - length if bound == "at least" else length - x) < 0.1


def test_what_stands_still_beside_the_turning_load(given):
    part = given.standing
    for start, film, verdict in ((1.99e6, 9.01 * UM, "pass"), (2.01e6, 8.99 * UM, "warn")):
        other = replace(part, load_at_start=start, film_orbit=film + slope_off(given), film_load_peak=1.0)
        found = {c.id.split(".")[-1]: c for c in standing_checks("front", given, other)}
        assert {key: c.verdict for key, c in found.items()} == {"start_load": verdict, "film_edge_standing": verdict}
        other = replace(other, film_orbit=1.0, film_load_peak=film + slope_off(given))
        found = {c.id.split(".")[-1]: c for c in standing_checks("front", given, other)}
        assert found["film_edge_standing"].verdict == verdict and "Trumpler" in found["start_load"].source
    (_, none) = standing_checks("front", given, replace(part, film_orbit=1.0, film_load_peak=None))
    assert none.verdict == "warn", "no film carries the largest load of the turn"


def test_each_number_of_a_material_and_of_an_application():
    white = bearing_materials()["SnSb8Cu4"]
    for p, pv, T, HB, caution, advice in (
        (5.49e6, 15.9e6, 149.9, 130.1, "pass", "pass"),
        (5.51e6, 16.1e6, 150.1, 129.9, "warn", "note"),
    ):
        found = {c.id.split(".")[-1]: c for c in material_checks("front", white, p, pv, T, 110.0, HB)}
        assert [found[f"material_{key}"].verdict for key in ("load", "temperature", "hardness")] == [caution] * 3
        assert found["material_pv"].verdict == advice and "Carvill" in found["material_load"].source
    (aluminium,) = (m for m in bearing_materials().values() if m.name == "AlSn20Cu")
    (load, *_) = material_checks("front", aluminium, 24.9e6, 1.0, 100.0, 90.0)
    assert load.limit == 25.0 and "from memory" in load.source
    for p, pv, duty, psi, ratio, verdict in (
        (7.9e6, 34.9e6, 4.1e-8, 0.91e-3, 0.81, "pass"),
        (8.1e6, 35.1e6, 3.9e-8, 0.89e-3, 0.79, "note"),
        (7.9e6, 34.9e6, 4.1e-8, 2.89e-3, 1.49, "pass"),
        (8.1e6, 35.1e6, 3.9e-8, 2.91e-3, 1.51, "note"),
    ):
        row = application("diesel-main")
        usual = application_checks("front", row, p=p, pv=pv, mu=1e-2, mu_n_over_p=duty, psi=psi, l_over_d=ratio)
        assert [c.verdict for c in usual] == [verdict] * 5
    half = replace(row, length_ratio_high=None)
    usual = application_checks("front", half, p=p, pv=pv, mu=1e-2, mu_n_over_p=duty, psi=psi, l_over_d=ratio)
    assert "bearings.front.length_ratio_application" not in {c.id for c in usual}


# ISO 7902-3, in its manner: from each diameter on, in mm, the film in µm up to 1, 3, 10, 30 m/s and beyond
H_LIM = {24.01: (3, 4, 5, 7, 10), 62.9: (3, 4, 5, 7, 10), 63.1: (4, 5, 7, 9, 12), 159.9: (4, 5, 7, 9, 12)}


@pytest.mark.parametrize(("d", "films"), H_LIM.items())
def test_the_least_film_by_diameter_and_speed(d, films):
    below, above = (0.99, 2.98, 9.9, 29.8, 100.0), (0.1, 1.01, 3.02, 10.1, 30.2)
    for speeds in (below, above):
        assert [least_film(d * 1e-3, u) for u in speeds] == pytest.approx([h * UM for h in films])


def test_there_is_no_least_film_of_smaller_or_larger_journals(given):
    assert least_film(0.0239, 5.0) is least_film(0.1601, 5.0) is None
    seat = replace(given.seat, bearing=replace(given.seat.bearing, diameter=0.0239))
    assert "film_edge_usual" not in made(replace(given, seat=seat))


# Finotti 2013, Table 3.1: N·rpm/mm, from, to, and where it is cooled the most
TABLE_3_1 = [(15, 20), (30, 40), (60, 70), (100, 200), (60, 70), (150, 240, 500)]


def test_the_heat_that_a_lubrication_bears_is_as_printed():
    rows = [(*row.usual, *([] if row.most is None else [row.most])) for row in LUBRICATIONS.values()]
    assert rows == [tuple(1000 * x for x in row) for row in TABLE_3_1]
    # 1 N·rpm/mm: a newton at a turn a minute on a millimetre
    assert [row.limit * 60 / 1000 for row in LUBRICATIONS.values()] == pytest.approx(
        [1e3 * row[-1] for row in TABLE_3_1]
    )


def test_the_least_speed_is_three_to_ten_times_that_of_transition():
    """Finotti 2013, 5.5.3: n/n_T at least the surface speed in m/s, of 3 to 10 m/s."""
    assert [speed_factor(u) for u in (0.1, 2.9, 5.0, 9.9, 20.0)] == [3.0, 3.0, 5.0, 9.9, 10.0]


def test_a_slope_is_usual_up_to_what_the_engine_s_maker_aims_at():
    """Finotti 2013, 4.6: 0.25 mrad."""
    assert keys(BearingRow)["slope_mrad"].about.usual == (0, pytest.approx(0.25))


# --- what is not given


@pytest.mark.parametrize(
    ("film", "edge", "verdict"),
    [(9.5, 9.1, "warn"), (9.5, 8.9, "not_verified"), (8.95, 8.9, "fail")],
)
def test_without_a_slope_the_film_is_judged_from_none_to_what_is_taken(given, film, edge, verdict):
    """It holds flat and sloped, flat alone, or not even flat; the films beside it alike, as cautions."""
    film, edge = film * UM, edge * UM
    r = replace(
        given, slope=None, film=film, film_edge=edge, thinnest_film=film, film_sheared=edge, film_overspeed=edge
    )
    found = made(cornered(r, film_edge=edge))
    assert found["film_edge"].verdict == found["film_edge_range"].verdict == verdict
    assert (found["film_edge"].at_best, found["film_edge"].at_worst) == pytest.approx((film / UM, edge / UM))
    assert found["film_edge"].missing == ("shafts.S.bearings.front.slope_mrad",)
    caution = {"warn": "pass", "fail": "warn"}.get(verdict, verdict)
    for key in ("film_edge_sheared", "film_overspeed", "film_edge_corner"):
        assert found[key].verdict == caution, key


def test_without_a_viscosity_at_high_shear_the_film_is_judged_from_none_lost(gamma_results, given):
    r = replace(gamma_results.outcomes["bearings"].result.bearings["front"], film_edge=9.5 * UM, film_sheared=8.9 * UM)
    check = made(r)["film_edge_sheared"]
    assert check.verdict == "not_verified" and check.missing == ("oil.hths_mPas",)
    assert check.at_best == pytest.approx(9.5)
    assert made(replace(given, film_edge=9.5 * UM, film_sheared=8.9 * UM))["film_edge_sheared"].verdict == "warn"


@pytest.mark.parametrize(("exact", "verdict"), [(1.0, "not_verified"), (-1.0, "fail")])
def test_without_fits_the_corners_are_judged_from_exact_parts(gamma_results, exact, verdict):
    r = gamma_results.outcomes["bearings"].result.bearings["front"]
    best = Exact(clearance_cold=exact * UM, film_edge=(9 + exact) * UM, outlet_temperature=135.0 - exact)
    corners = replace(r.corners, exact=best, clearance_cold=-2 * UM, film_edge=7 * UM, outlet_temperature=137.0)
    found = made(replace(r, corners=corners))
    assert found["clearance_cold_corner"].verdict == verdict
    caution = {"fail": "warn"}.get(verdict, verdict)
    assert found["film_edge_corner"].verdict == found["temperature_corner"].verdict == caution
    assert found["clearance_cold_corner"].missing == ("bearings.journal_fit", "bearings.seat_fit")


def test_exact_parts_have_the_clearance_as_given_and_the_oil_within_its_tolerance(gamma_results):
    for r in gamma_results.outcomes["bearings"].result.bearings.values():
        thin, thick = (balanced(own_warm, replace(r.seat, viscosity_factor=factor), r.duty) for factor in (0.9, 1.1))
        exact = r.corners.exact
        assert exact.clearance_cold == pytest.approx(r.clearance_cold)
        assert exact.film_edge == pytest.approx(thin.film - slope_off(r), rel=1e-6)
        assert exact.outlet_temperature == pytest.approx(120 + thick.temperature_rise, rel=1e-6)


@pytest.mark.parametrize(
    ("housing", "limit", "outside"),
    [("EN-GJL-250", 250.0, "fail"), ("steel", 235.0, "not_verified"), ("DI-400", 305.0, "fail")],
)
def test_the_pressure_is_held_against_proof_stress_else_tensile_strength_else_that_of_weak_steel(
    given, housing, limit, outside
):
    over = made(replace(given, film_pressure_max=(limit + 1) * MPA), materials()[housing])["film_pressure"]
    under = made(replace(given, film_pressure_max=0.9 * limit * MPA), materials()[housing])["film_pressure"]
    assert (over.limit, over.verdict, under.verdict) == (limit, outside, "pass")
    assert (over.at_best == "holds") is (housing == "steel")


# --- outside the range of a formula


def test_a_supply_outside_its_range_is_known_by_a_third_less_in_its_rise(gamma):
    """A hole of 26 mm over 27.5 mm: the outlet is judged with 1.3 times the rise too."""
    found = {c.id: c for c in solve(design(gamma.with_value("bearings.hole_diameter_mm", 26.0))).checks()}
    check = found["bearings.front.temperature"]
    assert check.outside == ("bearings.front.supply_range",)
    assert check.at_worst == pytest.approx(120 + 1.3 * (check.value - 120))
    assert check.at_best == pytest.approx(check.value)


def test_an_oil_outside_its_law_is_known_by_a_third_less_in_its_films(gamma):
    oil = {"name": "thin", "nu40_mm2_s": 6.0, "nu100_mm2_s": 2.2, "rho15_kgm3": 850.0, "base": "mineral"}
    document = replace(gamma, data={**gamma.data, "oil": [oil]}).with_value("bearings.oil", "thin")
    document = document.with_value("shafts.shaft.bearings.front.length_mm", 45.0).with_value(
        "shafts.shaft.bearings.rear.length_mm", 45.0
    )
    results = solve(design(document))
    found, r = {c.id: c for c in results.checks()}, results.result(BearingsResult).bearings["front"]
    lost = (r.film - r.film_edge) / UM  # what the slope takes of the film is known
    assert lost > 1
    for key in ("film_edge", "film_edge_range", "film_overspeed", "film_edge_standing", "film_edge_corner"):
        check = found[f"bearings.front.{key}"]
        assert check.outside == ("bearings.front.viscosity_range",)
        assert check.at_worst == pytest.approx((check.value + lost) / 1.3 - lost)


# --- films of makers' journals


MAKERS = [
    # d, l, clearance, load, rpm, oil, °C, bar, housing, HTHS; film, outlet, at the edge sheared and at 10 % overspeed
    (
        28,
        18,
        35,
        2473.0,
        8500,
        "10W-40 Q8 T905",
        100,
        3.0,
        "EN AC-43100",
        3.5,
        5.561576,
        115.304862,
        3.949942,
        4.251887,
    ),
    (20.01, 18, 46, 2238.4, 12000, "5W-30", 100, 3.5, "steel", 2.9, 4.559183, 117.595408, 2.824821, 3.286807),
    (36.733, 20, 67, 4157.0, 12000, "5W-30", 100, 3.5, "steel", 2.9, 6.588226, 122.159284, 4.588615, 5.121575),
    (29.96, 20, 77, 3300.0, 12000, "5W-30", 100, 3.5, "EN AC-43100", 2.9, 5.508668, 108.803281, 3.450466, 4.080686),
    (48.942, 24, 103, 2100.0, 5200, "10W-30", 100, 3.5, "EN-GJL-250", 2.9, 10.037558, 107.076882, 7.772671, 8.220781),
    (41.952, 22, 82, 1530.0, 7000, "10W-30", 100, 3.5, "EN-GJL-250", 2.9, 11.176104, 110.694778, 8.988304, 9.410277),
    (24.95, 18, 51, 3100.0, 12000, "5W-30", 100, 3.5, "EN AC-43100", 2.9, 4.281297, 112.084382, 2.567745, 3.033747),
    (52.895, 35, 155, 4230.0, 4400, "15W-40", 95, 3.0, "EN-GJL-250", 3.7, 12.541453, 100.563847, 9.223973, 9.920028),
    (19.97, 20, 44, 600.0, 3400, "SAE 30", 90, 3.0, "EN AC-43100", None, 6.487429, 94.021972, None, 5.003198),
]


@pytest.mark.parametrize("case", MAKERS)
def test_films_of_makers_journals(case):
    """Solved point by point, each with its own balance; lengths, oils and temperatures are assumed."""
    d, l, g, F, n, oil, T, bar, housing, hths, film, outlet, sheared, over = case
    sizes = dict(diameter_mm=d, length_mm=l, clearance_um=g, load_N=F, slope_mrad=0.1)
    sizes |= dict(journal_roughness_um=0.2, housing_roughness_um=0.4)
    rows = [{"name": name, "position_mm": z, **sizes} for name, z in (("front", 0.0), ("rear", 1000.0))]
    shaft = {"name": "shaft", "mode": "bearings", "bearings": rows}
    table = dict(
        oil=oil,
        supply_temperature_C=T,
        supply_pressure_bar=bar,
        supply="hole",
        hole_diameter_mm=3.0,
        housing_material=housing,
        journal_material="42CrMo4",
        speed_rpm=n,
    )
    solved = solve(design(Document({"schema": 2, "name": "maker", "shafts": [shaft], "bearings": table}, "maker.toml")))
    r = solved.outcomes["bearings"].result.bearings["front"]
    assert high_shear(r.seat.lubricant) == (None if hths is None else pytest.approx(hths * 1e-3))
    assert r.film / UM == pytest.approx(film, rel=1e-4) and r.outlet_temperature == pytest.approx(outlet, rel=1e-4)
    assert r.film_overspeed / UM == pytest.approx(over, rel=1e-3)
    assert r.film_sheared == (None if sheared is None else pytest.approx(sheared * UM, rel=3e-3))
    # a lining that runs in counts with the journal's 0.2 µm, bare metal with its own 0.4
    assert r.kreisle_film / UM == pytest.approx(4.5)
    lined = replace(r.seat.inputs, bush_material="AlSn20Cu")
    assert film_asked(lined, 0.2 * UM, 0.4 * UM) / UM == pytest.approx(3.0)
    assert film_asked(lined, 0.4 * UM, 0.2 * UM) / UM == pytest.approx(4.5)
    hard = replace(r.seat.inputs, bush_material="CuSn10P")
    assert film_asked(hard, 0.2 * UM, 0.4 * UM) / UM == pytest.approx(4.5)


def test_a_film_is_asked_for_of_the_smoothest_journal_too(given):
    """In a lining that runs in, its 0.01 µm twice."""
    lined = replace(given.seat.inputs, bush_material="AlSn20Cu")
    for Ra in (0.0, 0.01):
        assert film_asked(lined, Ra * UM, 0.4 * UM) / UM == pytest.approx(7.5 * 0.02)


def test_the_film_at_overspeed_is_that_of_a_load_with_the_square_of_the_speed(gamma):
    results = solve(design(gamma.with_value("bearings.overspeed_percent", 20.0)))
    r = results.outcomes["bearings"].result.bearings["front"]
    ratio = 1.2 * 2646 / 2600  # of the fastest row of the bench run
    faster = replace(
        r.duty,
        load=ratio**2 * r.duty.load,
        speed=ratio * r.duty.speed,
        effective_speed=ratio * r.duty.effective_speed,
    )
    assert r.film_overspeed == pytest.approx(balanced(own_warm, r.seat, faster).film - slope_off(r), rel=1e-6)
    assert "20 % overspeed" in {c.id: c for c in results.checks()}["bearings.front.film_overspeed"].name


def test_overspeed_is_above_the_highest_speed_of_the_range(gamma):
    r = solve(design(gamma.with_value("bearings.speed_range_rpm", [1000.0, 3000.0]))).outcomes["bearings"].result
    front = r.bearings["front"]
    ratio = 1.1 * 3000 / 2600
    faster = replace(
        front.duty,
        load=ratio**2 * front.duty.load,
        speed=ratio * front.duty.speed,
        effective_speed=ratio * front.duty.effective_speed,
    )
    assert front.film_overspeed == pytest.approx(
        balanced(own_warm, front.seat, faster).film - slope_off(front), rel=1e-6
    )


@pytest.mark.parametrize(
    ("name", "hths"),
    [
        ("0W-20", 2.6),
        ("5W-30", 2.9),
        ("friction thesis 0W30", 2.9),
        ("10W-40 Q8 T905", 3.5),
        ("5W-40", 3.5),
        ("15W-40", 3.7),
        ("20W-50", 3.7),
        ("SAE 40", None),
    ],
)
def test_the_least_viscosity_at_high_shear_of_a_grade(name, hths):
    """SAE J300, from memory; a single grade does not thin, and what is given goes before."""
    oil = oils()[name]
    assert high_shear(Lubricant(oil)) == (None if hths is None else pytest.approx(hths * 1e-3))
    assert high_shear(Lubricant(replace(oil, hths=3.1e-3))) == 3.1e-3


def test_the_films_that_are_new_are_solved_in_one_call_with_the_others(gamma_results):
    r = gamma_results.outcomes["bearings"].result.bearings["front"]
    assert 0.5 < r.shear_factor < 1 and r.film_sheared < r.film_edge
    thin = balanced(own_warm, replace(r.seat, viscosity_factor=r.shear_factor), r.duty)
    assert r.film_sheared == pytest.approx(thin.film - slope_off(r), rel=1e-9)
    twice = balanced(own_warm, r.seat, replace(r.duty, load=2 * r.duty.load))
    assert r.film_double_load == pytest.approx(twice.film, rel=1e-9)
    full = min(1.0, 3.5e-3 / r.seat.lubricant.at(150.0).mu)
    assert r.shear_factor == pytest.approx(1 + (full - 1) * np.clip(np.log10(r.shear_rate) - 5, 0, 1))
