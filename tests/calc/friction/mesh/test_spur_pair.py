# SPDX-License-Identifier: Apache-2.0
"""The spur pair of the gear friction thesis: recorded values of a second implementation, and what the regimes
change."""

import numpy as np
import pytest

from calc.friction.mesh.loss import case, solve_mesh
from calc.friction.mesh.mixed import friction as mixed
from calc.friction.mesh.path import line_load, transverse_force
from tests.calc.friction.pairs import friction, oil, recorded, spur_pair

RECORDED = recorded("friction_spur_pair.json")
SPEED = 25.0  # rev/s
TOLERANCE = 1e-4


def solved(row, by_regime=False):
    c = case(
        friction(load_sharing=row["load_sharing"]), spur_pair(), oil(row["oil"], row.get("temperature_C", 40.0)), SPEED
    )
    return c, solve_mesh(c, row.get("power_W", 100.0), by_regime)


def at_marks(column, local, path):
    """The values at A … E; the local arrays are sorted by x and hold them exactly."""
    return [float(np.asarray(column)[int(np.argmin(np.abs(np.asarray(local.x) - mark)))]) for mark in path.marks]


@pytest.mark.parametrize("row", RECORDED["runs"], ids=lambda r: f"{r['power_W']:.0f} W")
def test_whole_mesh(row):
    _, found = solved(row)
    assert found.loss == pytest.approx(row["loss_W"], rel=TOLERANCE)
    assert found.efficiency == pytest.approx(row["efficiency"], rel=1e-6)
    assert found.friction_mean == pytest.approx(row["friction_mean"], rel=TOLERANCE)
    assert found.deborah_max == pytest.approx(row["deborah_max"], rel=TOLERANCE)


@pytest.mark.parametrize("row", RECORDED["runs"], ids=lambda r: f"{r['power_W']:.0f} W")
def test_the_points_of_the_path(row):
    c, found = solved(row)
    local, marks = found.local, row["at_A_to_E"]
    assert at_marks(local.h, local, c.path) == pytest.approx([h * 1e-6 for h in marks["film_um"]], rel=TOLERANCE)
    assert at_marks(local.lam, local, c.path) == pytest.approx(marks["lambda"], rel=TOLERANCE)
    assert at_marks(local.mu, local, c.path) == pytest.approx(marks["friction"], rel=TOLERANCE)
    warming = [T - row["temperature_C"] for T in at_marks(local.T_f, local, c.path)]
    assert warming == pytest.approx([T - row["temperature_C"] for T in marks["temperature_C"]], rel=5e-4, abs=1e-6)
    power = [q * c.mesh.face_width for q in at_marks(local.q, local, c.path)]
    assert power == pytest.approx(marks["power_W"], rel=5e-4, abs=1e-12)


@pytest.mark.parametrize("row", RECORDED["at_40_C_and_100_W"], ids=lambda r: f"{r['oil']}, {r['load_sharing']}")
def test_oils_at_light_load(row):
    c, found = solved(row)
    local = found.local
    assert c.oil.eta_0 * 1e3 == pytest.approx(row["eta_40_mPas"], abs=5e-4)
    assert found.loss == pytest.approx(row["loss_W"], rel=TOLERANCE)
    assert found.loss_factor == pytest.approx(row["loss_factor"], rel=TOLERANCE)
    assert found.friction_mean == pytest.approx(row["friction_mean"], rel=TOLERANCE)
    assert found.pressure_max / 1e6 == pytest.approx(row["pressure_max_MPa"], rel=TOLERANCE)
    assert found.lambda_min == pytest.approx(row["lambda_min"], rel=TOLERANCE)
    assert np.max(local.lam) == pytest.approx(row["lambda_max"], rel=TOLERANCE)
    A, _, C, _, E = at_marks(local.h, local, c.path)
    assert [A * 1e6, C * 1e6, E * 1e6] == pytest.approx(
        [row["film_A_um"], row["film_C_um"], row["film_E_um"]], rel=TOLERANCE
    )
    mu = at_marks(local.mu, local, c.path)
    assert (mu[0], mu[4]) == pytest.approx((row["friction_A"], row["friction_E"]), rel=TOLERANCE)
    # the hottest position lies between grid points where the tips are relieved
    assert found.temperature_max - 40 == pytest.approx(
        row["warming_max_K"], rel=TOLERANCE if row["load_sharing"] == "linear" else 1e-3
    )
    assert solve_mesh(c, 100.0, True).rigid_share == pytest.approx(row["rigid_share"])


def test_at_100_w_the_film_is_rigid_and_rolling_costs_more_than_sliding():
    """Film 12 µm instead of 1.5, no solid friction, sliding about 0.11 W, the rolling bound 3.2 W."""
    _, found = solved(RECORDED["at_40_C_and_100_W"][0], by_regime=True)
    assert found.rigid_share == 1.0
    assert found.film_min * 1e6 == pytest.approx(12, abs=0.5)
    assert found.sliding_loss == pytest.approx(0.11, abs=0.005)
    assert found.rolling_loss == pytest.approx(3.2, abs=0.05)
    assert found.loss == found.sliding_loss + found.rolling_loss


def test_at_10_kw_the_films_agree_with_the_source_and_the_friction_does_not():
    row = RECORDED["runs"][1]
    source, judged = solved(row)[1], solved(row, by_regime=True)[1]
    assert judged.rigid_share == 0.0
    assert judged.rolling_loss == 0.0
    assert judged.film_min == pytest.approx(source.film_min, rel=1e-12)
    assert judged.loss < 0.5 * source.loss


def test_nothing_slides_at_the_pitch_point():
    c, found = solved(RECORDED["runs"][0])
    assert c.path.at_pitch_point(c.motion.V_s) == 0.0
    mu, q = (at_marks(x, found.local, c.path)[2] for x in (found.local.mu, found.local.q))
    assert 0 < mu < 0.135
    assert q == 0.0


@pytest.mark.parametrize("by_regime", [False, True])
def test_relieved_tips_carry_nothing_and_stay_finite(by_regime):
    c, found = solved(RECORDED["at_40_C_and_100_W"][1], by_regime)
    w, w_f = line_load(
        c.mesh, c.path, transverse_force(P=100.0, omega_1=c.motion.omega_1, r_b1=c.mesh.driver.base_radius)
    )
    assert np.asarray(w)[[-5, -1]] == pytest.approx([0.0, 0.0], abs=1e-9)
    assert np.min(w_f) == pytest.approx(0.01 * np.max(w))
    for column in (found.local.h, found.local.mu, found.local.q, found.local.T_f):
        assert np.isfinite(column).all()
    assert found.local.q[0] == pytest.approx(0.0, abs=1e-12)
    assert found.local.T_f[0] == pytest.approx(40.0)


def test_friction_lies_between_that_of_the_fluid_and_of_the_solids():
    _, found = solved(RECORDED["runs"][1])
    assert (np.asarray(found.local.mu) < 0.135).all()
    assert mixed(xi=1.0, mu_s=0.135, mu_f=0.01) == 0.135
    assert mixed(xi=0.0, mu_s=0.135, mu_f=0.01) == 0.01


if __name__ == "__main__":
    for row in (*RECORDED["runs"], *RECORDED["at_40_C_and_100_W"]):
        print(row["oil"], row["load_sharing"], solved(row)[1])
