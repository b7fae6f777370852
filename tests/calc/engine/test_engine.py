"""Masses and kinematics beside the source's numbers and closed forms."""

import math

import numpy as np
import pytest

from calc.engine.crank import crank
from calc.engine.inputs import EngineInputs
from calc.engine.solve import solve
from tests.calc.imbalance.engines import R753


def result(**changes):
    return solve(EngineInputs(**{**R753, **changes})).result


def test_masses_of_the_r753():
    """Finotti 2013, 2.5.3.1: 311.35 and 703.65 g of the rod, 1489.35 and 758.65 g per cylinder."""
    e = result()
    assert e.reciprocating_mass * 1e3 == pytest.approx(1489.350, abs=5e-4)
    assert e.rotating_mass * 1e3 == pytest.approx(758.650, abs=5e-4)
    assert e.lambda_ == pytest.approx(0.328221, abs=5e-7)
    assert e.angular_speed == pytest.approx(272.2714, abs=5e-5)
    assert e.mean_piston_speed == pytest.approx(9.2733, abs=5e-5)
    assert e.displacement * 1e6 == pytest.approx(2228, abs=0.5)


def test_the_rod_by_thirds_where_its_centre_of_gravity_is_not_known():
    e = result(rod_cg_to_big_end=None)
    assert e.reciprocating_mass == pytest.approx(1.178 + 1.015 / 3)


def test_what_the_rated_power_tells():
    """Finotti 2013, 1.3.2.2: 50 kW at 2600 rpm from 2.228 L."""
    assert result(rated_power=50e3).brake_mean_pressure == pytest.approx(50e3 * 120 / 2600 / 2.228e-3, rel=2e-4)
    assert result().brake_mean_pressure is None


def test_accelerations_at_the_dead_centres():
    """ω²r(1+λ) = 5267.8 m/s² at TDC; λ > ¼: the minimum −0.69863 ω²r is at 138.98°, not at BDC (λ = 0.3282)."""
    e = result()
    assert e.acceleration_max == pytest.approx(5267.8, abs=0.05)
    assert e.acceleration_min / (e.angular_speed**2 * 0.0535) == pytest.approx(-0.69863, abs=2e-5)
    assert math.degrees(e.acceleration_min_angle) == pytest.approx(138.98, abs=0.01)


def test_largest_speed_of_the_piston():
    """λ = 0.24: 1.02848 ωr, exact."""
    e = result(crank_radius=0.24 * 0.163)
    assert e.piston_speed_max / (e.angular_speed * 0.24 * 0.163) == pytest.approx(1.02848, abs=5e-6)


def test_where_the_piston_is_fastest():
    """Two terms: cos α + λ cos 2α = 0 (Finotti 2013, 2.1), 73.88° at λ = 0.3282; exact: half a degree before, where the
    way turns over."""
    e = result()
    lam = e.lambda_
    terms = math.degrees(math.acos((math.sqrt(1 + 8 * lam**2) - 1) / (4 * lam)))
    assert math.degrees(e.piston_speed_max_angle) == pytest.approx(terms, abs=0.6)
    alpha = e.piston_speed_max_angle
    way = lambda a: math.cos(a) + math.sqrt(1 / lam**2 - math.sin(a) ** 2)  # noqa: E731
    assert abs(way(alpha + 1e-3) - 2 * way(alpha) + way(alpha - 1e-3)) < 1e-8


@pytest.mark.parametrize("offset", [0.0, 0.006])
def test_way_speed_and_acceleration_are_each_other_s_slopes(offset):
    """The way runs from 0 at TDC over one stroke; both kinds of each curve are the slope of the one before."""
    outcome = solve(EngineInputs(**{**R753, "cylinder_offset": offset}))
    drawn = {curve.id: curve for curve in outcome.curves}
    e, step = outcome.result, math.radians(1.0) / outcome.result.angular_speed
    assert np.ptp(drawn["path"].series[0].y) == pytest.approx(e.stroke * 1e3, rel=1e-4)
    assert drawn["path"].series[0].y.min() == pytest.approx(0, abs=0.01)
    assert np.abs(drawn["speed"].series[0].y).max() == pytest.approx(e.piston_speed_max, rel=1e-3)
    for k in range(2):
        x, v, a = (drawn[id].series[k].y for id in ("path", "speed", "acceleration"))
        assert np.gradient(x, step)[1:-1] / 1e3 == pytest.approx(v[1:-1], abs=0.01)
        assert np.gradient(v, step)[1:-1] == pytest.approx(a[1:-1], abs=3)


def test_forces_of_one_cylinder():
    """Finotti 2013, 2.2.3: M_alt·ω²·r of first order, λ of it at twice the frequency; their sum is M_alt·a but for the
    higher orders."""
    outcome = solve(EngineInputs(**R753))
    e = outcome.result
    first, second, whole = next(curve for curve in outcome.curves if curve.id == "cylinder_forces").series
    assert first.y[0] == pytest.approx(1.48935 * 272.2714**2 * 0.0535, rel=1e-6)
    assert second.y[[0, 45, 90]] == pytest.approx(np.array([1, 0, -1]) * e.harmonics[1].real * first.y[0])
    assert whole.y.max() == pytest.approx(e.reciprocating_mass * e.acceleration_max)


@pytest.mark.parametrize("lam", [0.15, 0.2, 0.25, 0.328220858895706])
def test_harmonics_against_their_series(lam):
    """A₂, A₄, A₆ of the slider-crank as power series in λ (Biezeno & Grammel)."""
    c = result(crank_radius=lam * 0.163).harmonics
    assert c[0] == pytest.approx(1)
    assert c[1].real == pytest.approx(lam + lam**3 / 4 + 15 * lam**5 / 128 + 35 * lam**7 / 512, abs=lam**9)
    assert c[3].real == pytest.approx(-(lam**3 / 4 + 3 * lam**5 / 16 + 35 * lam**7 / 256), abs=lam**9)
    assert c[5].real == pytest.approx(9 * lam**5 / 128 + 45 * lam**7 / 512, abs=lam**9)
    assert max(abs(c[n - 1]) for n in (3, 5, 7)) < 1e-12


def test_offset_cylinder():
    """r 53.5, L 163 mm, δ = 0.045: TDC at 1.9415°, stroke 107.122 mm, |c₁…c₄| 1.0011 .33869 .00610 .00978."""
    e = result(cylinder_offset=0.045 * 0.163)
    assert math.degrees(e.tdc_angle) == pytest.approx(1.9415, abs=5e-5)
    assert e.stroke * 1e3 == pytest.approx(107.122, abs=5e-4)
    assert [abs(c) for c in e.harmonics[:4]] == pytest.approx([1.0011, 0.33869, 0.00610, 0.00978], abs=5e-5)


def test_two_terms_are_close_to_exact():
    """At λ = 0.3282 the two-term acceleration errs by at most 0.0192 ω²r."""
    outcome = solve(EngineInputs(**R753))
    exact, two = outcome.curves[0].series
    e = outcome.result
    assert np.abs(exact.y - two.y).max() / (e.angular_speed**2 * 0.0535) == pytest.approx(0.0192, abs=5e-5)


@pytest.mark.parametrize("order, angles", [((1, 3, 2), (0, 240, 120)), ((1, 2, 3), (0, 120, 240))])
def test_crank_angles_follow_from_the_firing_order(order, angles):
    c = crank(EngineInputs(**{**R753, "firing_order": order, "crank_angles": None}), 0.0)
    assert np.degrees(c.phi) == pytest.approx(angles)
    assert c.z == pytest.approx((-0.112, 0, 0.112))


def test_the_usual_firing_order_is_chosen_and_said():
    c = crank(EngineInputs(**{**R753, "firing_order": None}), 0.0)
    assert np.degrees(c.phi) == pytest.approx((0, 240, 120))
    assert "1-3-2" in c.chosen[0]


@pytest.mark.parametrize(
    "changes, key",
    [
        ({"firing_order": (1, 2, 2)}, "firing_order"),
        ({"firing_order": (1, 2)}, "firing_order"),
        ({"strokes": 3}, "strokes"),
        ({"rod_length": 0.05}, "rod_length_mm"),
        ({"rod_cg_to_big_end": 0.2}, "rod_cg_to_big_end_mm"),
        ({"layout": "vee"}, "bank_angle_deg"),
        ({"cylinders": 13, "firing_order": None}, "cylinders"),
    ],
)
def test_what_makes_no_sense_is_named(changes, key):
    assert key in [k for k, _ in EngineInputs(**{**R753, **changes}).problems()]
