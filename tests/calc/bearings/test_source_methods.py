"""The source's two methods, formula by formula: its printed iterations of the front bearing (F = 1710 N, 2600 rpm, 120 °C, 4 bar)."""

import json
from pathlib import Path

import pytest

from calc.bearings import din31652 as din
from calc.bearings import flow
from calc.bearings import formulas as f
from calc.bearings import raimondi_boyd as rb
from calc.catalogue import oils
from calc.lubricant import Lubricant

REFERENCE = json.loads((Path(__file__).parents[2] / "reference" / "finotti_front_bearing.json").read_text(encoding="utf-8"))
OIL = Lubricant(oils()["10W-40 Q8 T905"])
F, N, D, L, P_S = 1710.0, 2600 / 60, 0.0595, 0.0275, 4e5
U = f.surface_speed(D, N)
G = f.clearance_by_factor(0.8, D, U)
PSI = f.relative_clearance(G, D)
P = f.specific_load(F, D, L)
B = L / D


@pytest.mark.parametrize("T, nu", [(float(t), v) for t, v in REFERENCE["oil"]["nu"].items()])
def test_viscosity_of_the_source_oil(T, nu):
    assert OIL.at(T).nu * 1e6 == pytest.approx(nu, rel=1e-9)


@pytest.mark.parametrize("name", ["rho", "cp", "mu_mPas"])
def test_the_other_properties_of_the_source_oil(name):
    for T, value in REFERENCE["oil"][name].items():
        state = OIL.at(float(T))
        assert {"rho": state.rho, "cp": state.cp, "mu_mPas": state.mu * 1e3}[name] == pytest.approx(value, rel=1e-9)


def test_geometry():
    known = REFERENCE["geometry_front"]
    assert (U, G, PSI, B, P) == pytest.approx((known["u"], known["g"], known["psi"], known["ld"], known["P"]), rel=1e-12)


@pytest.mark.parametrize("row", REFERENCE["raimondi_boyd_front"])
def test_raimondi_boyd_iteration(row):
    """Each column of the printed table from the chart readings h₀/c, f*, ε of the source."""
    T = f.mean_temperature(120.0, row["dT_in"])
    oil = OIL.at(T)
    assert f.sommerfeld(oil.mu, N, P, PSI) == pytest.approx(row["S"], rel=1e-9)
    assert G / 2 * row["h0c"] == pytest.approx(row["h0"], rel=1e-9)
    friction = f.friction_coefficient(PSI, row["frc"])
    power = f.friction_power(friction, F, U)
    Q = flow.groove_flow_of_finotti(P_S, D, G, row["eps"], oil.mu, L)
    assert (friction, power, Q) == pytest.approx((row["f"], row["H"], row["Qs"]), rel=1e-9)
    assert f.temperature_rise(power, oil.rho, oil.cp, Q) == pytest.approx(row["dT"], rel=1e-9)


@pytest.mark.parametrize("row", REFERENCE["din31652_front"])
def test_din_31652_iteration(row):
    """Each column of the printed table; the film by the branch So > 1 in all three rows, as the source has it."""
    T = f.mean_temperature(120.0, row["dT_in"])
    oil = OIL.at(T)
    omega = f.angular_speed(N)
    So = f.sommerfeld_din(P, PSI, oil.mu, omega)
    h_0 = din.film_heavily_loaded(G, So, B)
    eps = 1 - 2 * h_0 / G
    assert (So, h_0, eps) == pytest.approx((row["So"], row["h0"], row["eps"]), rel=1e-9)
    Y, friction = din.friction(PSI, So, B)
    assert (Y, friction) == pytest.approx((row["Y"], row["f"]), rel=1e-9)
    q_H = flow.hole_factor(0.004 / L)
    q_2 = flow.supply_factor(flow.opposite(eps), L, 0.004, q_H)
    Q_2 = flow.supply_flow(D, PSI, P_S, oil.mu, q_2)
    q_1 = flow.side_flow_factor(B, eps)
    Q_1 = flow.side_flow_din(D, PSI, omega, q_1)
    power = f.friction_power(friction, F, U)
    found = (q_H, q_2, Q_2, q_1, Q_1, power, f.temperature_rise(power, oil.rho, oil.cp, Q_1 + Q_2), f.transition_speed(P, oil.mu, D))
    assert found == pytest.approx(tuple(row[k] for k in ("qH", "q2", "Q2", "q1", "Q1", "P", "dT", "nT")), rel=1e-9)


def test_so_and_s_describe_the_same_state():
    mu = 7e-3
    assert f.sommerfeld(mu, N, P, PSI) * f.sommerfeld_din(P, PSI, mu, f.angular_speed(N)) == pytest.approx(1 / (2 * 3.141592653589793))


def test_falz_keeps_the_source_rule_and_does_not_meet_at_one():
    """l/d 0.4622: 0.316 c by the branch above 1, 0.209 c by the one below (c = g/2)."""
    assert din.film(2.0, 1.0 + 1e-12, B) == pytest.approx(0.316, abs=5e-4)
    assert din.film(2.0, 1.0, B) == pytest.approx(0.209, abs=5e-4)


@pytest.mark.parametrize("b, holds", [(0.3, True), (0.55, True), (0.65, False), (1.0, True), (1.1, False)])
def test_the_friction_polynomial_is_guarded(b, holds):
    assert din.polynomial_holds(b) is holds


@pytest.mark.parametrize("b, S, film, friction", [
    (0.4622, 0.05, 0.1343, None), (0.4622, 0.1588, 0.2564, 4.918), (0.3272, 0.3073, 0.2252, 9.225), (0.3272, 1.0, 0.4470, None),
])  # fmt: skip
def test_chart_interpolation_of_the_source(b, S, film, friction):
    """The source's cubic in d/l; values by exact solutions, so the charts' own errors (S 1.4 % off at l/d 1, ε 0.4)
    stand between, and the cubic makes them up to twice as large."""
    assert rb.relative_film(S, b) == pytest.approx(film, rel=0.03)
    if friction:
        assert rb.friction_variable(S, b) == pytest.approx(friction, rel=0.02)


def test_the_charts_refuse_what_they_do_not_show():
    with pytest.raises(rb.OutsideCharts, match="l/d"):
        rb.relative_film(0.1, 0.2)
    with pytest.raises(rb.OutsideCharts, match="below the charts"):
        rb.relative_film(1e-4, 0.5)


def test_the_charts_are_met_at_their_own_points():
    assert rb.chart_readings(0.319)[0.5] == pytest.approx((0.4, 8.1))
    assert rb.chart_readings(0.0446)[1.0] == pytest.approx((0.2, 1.7))
    assert rb.relative_film(0.261, 0.25) == pytest.approx(0.2)


def test_full_groove_flow_is_that_of_two_lands():
    """(π/24)(1+1.5ε²)·d/(l−b_G) equals R–B's Q_s with l' = (l−b_G)/2."""
    mu, eps = 7e-3, 0.7
    q_2 = flow.groove_factor(eps, D, L, 0.003)
    assert flow.supply_flow(D, PSI, P_S, mu, q_2) == pytest.approx(flow.groove_flow_of_finotti(P_S, D, G, eps, mu, (L - 0.003) / 2))
