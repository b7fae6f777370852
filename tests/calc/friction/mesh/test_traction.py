# SPDX-License-Identifier: Apache-2.0
"""Friction and film temperature: the fixed point against two other ways to it, its failure, and the error function."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from calc.friction.mesh import mixed
from calc.friction.mesh import traction as t
from calc.friction.mesh.film import film
from calc.friction.mesh.loss import case, solve_mesh
from calc.friction.mesh.path import line_load, transverse_force
from calc.library.contact import half_width, hertz_pressure, mean_pressure
from calc.sheet.errors import NoSolution
from calc.sheet.functions import erf
from tests.calc.friction.pairs import friction, oil, r753, spur_pair

OILS = ("friction thesis 10W40", "friction thesis 0W30", "friction thesis MIL-L-23699E")


# --- the error function
def test_erf_of_an_array_is_that_of_math():
    x = np.concatenate((np.linspace(-7, 7, 20011), [0.0, 1e-300, 6.0, 1e9]))
    assert np.max(np.abs(erf(x) - np.array([math.erf(v) for v in x]))) < 6e-14


def test_erf_of_a_float_and_of_nan():
    assert erf(0.3) == math.erf(0.3)
    assert np.isnan(erf(np.array([np.nan]))).all()


# --- the temperature of the film
def warming(c, P):
    """T → warmed(T) of a whole mesh with the EHL film, as `traction` has it; with the highest temperature that can come
    out."""
    w, w_f = line_load(c.mesh, c.path, transverse_force(P=P, omega_1=c.motion.omega_1, r_b1=c.mesh.driver.base_radius))
    m, lube = c.motion, c.oil.lubricant
    b_H, p_H = half_width(w_f, m.R, m.E_r), hertz_pressure(w_f, m.E_r, m.R)
    p_m, h = mean_pressure(p_H), film(False, c.oil, m, w_f, p_H, c.path.cells).h
    B_1, B_2 = (t.transient_resistance(t.STEEL_DIFFUSIVITY, b_H, u, t.STEEL_CONDUCTIVITY) for u in (m.u_1, m.u_2))
    R_th = t.film_resistance(t.heat_partition(B_1, B_2, 0.0, 0.0), B_1, h, b_H, c.oil.k_f)
    xi, mu_s = mixed.solid_share(mixed.film_ratio(h, c.source_surfaces.sigma)), c.source_surfaces.mu_s

    def warmed(T):
        eta_f = lube.at(T).mu
        alpha_f = lube.alpha(eta_f)
        tau_E = t.eyring_stress(lube.limiting_shear, alpha_f)
        mu_f = t.fluid_friction(
            tau_E, p_m, t.viscosity_under_pressure(eta_f, alpha_f, p_m), m.V_s, h, lube.limiting_shear
        )
        return c.oil.T_m + t.friction_power(mixed.friction(xi, mu_s, mu_f), w, m.V_s) * R_th

    return warmed, c.oil.T_m + mixed.friction(xi, mu_s, lube.limiting_shear) * w * m.V_s * R_th


def damped(warmed, T_m, shape):
    """The fixed point, half a step at a time, less where the residual swings without shrinking."""
    T, factor = np.full(shape, T_m), np.full(shape, 0.5)
    left = np.zeros(shape)
    for _ in range(400):
        now = warmed(T) - T
        if np.max(np.abs(now)) < 1e-9:
            return T
        factor = np.where((now * left < 0) & (np.abs(now) > 0.7 * np.abs(left)), factor / 2, factor)
        T, left = T + factor * now, now
    raise AssertionError("the damped fixed point did not settle")


def bisected(warmed, T_m, highest):
    low, high = np.full_like(highest, T_m), highest + 1e-6
    for _ in range(80):
        middle = (low + high) / 2
        above = warmed(middle) > middle
        low, high = np.where(above, middle, low), np.where(above, high, middle)
    return (low + high) / 2


@pytest.mark.parametrize("P", [10.0, 100.0, 10000.0, 100000.0])
@pytest.mark.parametrize("name", OILS)
def test_secant_bisection_and_damped_steps_agree(name, P):
    c = case(friction(), spur_pair(), oil(name, 60.0), 25.0)
    warmed, highest = warming(c, P)
    T = t.settled(warmed, c.oil.T_m, highest, c.path.x, "mesh")
    assert np.max(np.abs(warmed(T) - T)) <= t.TOLERANCE
    assert bisected(warmed, c.oil.T_m, highest) == pytest.approx(T, abs=1e-9, rel=1e-9)
    assert damped(warmed, c.oil.T_m, T.shape) == pytest.approx(T, abs=1e-9, rel=1e-9)
    assert np.max(T) == pytest.approx(solve_mesh(c, P, False).temperature_max, abs=1e-6)


def test_no_settling_names_position_and_residual(monkeypatch):
    monkeypatch.setattr(t, "PASSES", 1)
    c = case(friction(), spur_pair(), oil(OILS[0], 60.0), 25.0)
    with pytest.raises(
        NoSolution, match=r"mesh pinion–gear: temperature of the film; .* mm from T₁: off by .* K after 1 passes"
    ):
        solve_mesh(c, 10000.0, False)


def test_a_response_without_a_number_is_not_an_answer():
    x = np.array([0.01, 0.02])
    with pytest.raises(NoSolution, match="20 mm from T₁: the formulas give no number there"):
        t.settled(lambda T: np.where(x > 0.015, np.nan, 40.0), 40.0, np.array([50.0, 50.0]), x, "mesh")


def test_a_response_that_jumps_over_itself_has_no_temperature():
    """Above 50 °C as cold as the teeth, below it 60 °C."""
    with pytest.raises(NoSolution, match=r"10 mm from T₁: off by −10 K after 60 passes"):
        t.settled(lambda T: np.where(T < 50, 60.0, 40.0), 40.0, np.array([60.0]), np.array([0.01]), "mesh")


def test_a_response_that_jumps_is_met_from_inside_its_bracket():
    """A steep fall: the secant alone would leave the bracket."""
    steep = t.settled(lambda T: 40 + 60 / (1 + np.exp(3 * (T - 70))), 40.0, np.array([100.0]), np.array([0.01]), "mesh")
    assert steep[0] == pytest.approx(40 + 60 / (1 + math.exp(3 * (steep[0] - 70))), abs=1e-6)


# --- the law
def test_fluid_friction_never_passes_the_limiting_shear():
    assert t.fluid_friction(5e6, 1e9, 1e6, 5.0, 1e-7, 0.047) == pytest.approx(0.047)
    assert t.fluid_friction(5e6, 1e9, 1.0, 0.0, 1e-7, 0.047) == 0.0


def test_slow_shear_is_newtonian():
    """arsinh x → x: the stress is η·V_s/h."""
    assert t.fluid_friction(5e6, 1e8, 0.1, 1e-3, 1e-6, 0.047) == pytest.approx(0.1 * 1e-3 / 1e-6 / 1e8, rel=1e-6)


def test_viscosity_under_pressure_is_capped():
    assert t.viscosity_under_pressure(0.01, 2e-8, 1e12) == pytest.approx(0.01 * math.exp(60))


def test_solid_share_begins_at_a_film_ratio_of_two():
    assert mixed.solid_share(0.0) == 1.0
    assert mixed.solid_share(2.0) == pytest.approx(0.0047, abs=1e-4)


def test_both_bodies_see_one_flash_temperature():
    B_1, B_2 = (t.transient_resistance(t.STEEL_DIFFUSIVITY, 1e-4, u, t.STEEL_CONDUCTIVITY) for u in (2.0, 5.0))
    share = t.heat_partition(B_1, B_2, 0.0, 0.0)
    assert share * B_1 == pytest.approx((1 - share) * B_2)


def test_the_temperatures_by_hand():
    """B = √(χ·a/u)/(2·a·k) and R_th = 1.06·ε·B_1 + h/(16·a·k_f); ε with bodies that resist."""
    B = t.transient_resistance(a_th=1e-5, a=1e-4, u=10.0, k_s=50.0)
    assert B == pytest.approx(1e-3)
    R_th = t.film_resistance(epsilon=0.5, B_1=2e-3, h=1.6e-6, a=1e-4, k_f=0.1)
    assert R_th == pytest.approx(1.06e-3 + 10e-3)
    assert t.heat_partition(B_1=1.0, B_2=2.0, M_1=3.0, M_2=4.0) == pytest.approx((2.12 + 4) / (3.18 + 7))


def test_the_rigid_film_by_hand():
    """a_IR = √(2·R·h₀); De = η·u_e/(2·a·1 GPa)."""
    assert t.sheared_half_width(R=0.02, h_0=1e-6) == pytest.approx(2e-4)
    assert t.deborah(eta=1.0, u_e=10.0, a=1e-4) == pytest.approx(5e-5)


def test_the_heat_goes_into_steel():
    """The friction source's: 46 W/(m·K), 7830 kg/m³, 465 J/(kg·K)."""
    c = SimpleNamespace(
        surfaces=SimpleNamespace(M_1=0.0, M_2=0.0),
        motion=SimpleNamespace(u_1=4.0, u_2=9.0),
        film=SimpleNamespace(h=1e-6),
        oil=SimpleNamespace(k_f=0.14),
    )
    epsilon, R_th = t._heat(c, 1e-4)
    B_1, B_2 = (math.sqrt(46 / (7830 * 465) * 1e-4 / u) / (2e-4 * 46) for u in (4.0, 9.0))
    assert epsilon == pytest.approx(B_2 / (B_1 + B_2))
    assert R_th == pytest.approx(1.06 * B_1 * B_2 / (B_1 + B_2) + 1e-6 / (16e-4 * 0.14))


def test_a_film_hotter_than_the_laws_of_the_oil_is_none():
    """1500 °C: the density of the oil comes to 0 at 1553."""
    x, highest = np.array([0.01, 0.02]), np.array([2000.0, 2000.0])
    assert t.settled(lambda T: np.array([60.0, 1499.0]), 40.0, highest, x, "mesh") == pytest.approx([60.0, 1499.0])
    with pytest.raises(NoSolution, match="20 mm from T₁ it would be above 1500 °C, where the laws of the oil end"):
        t.settled(lambda T: np.array([60.0, 1501.0]), 40.0, highest, x, "mesh")


def test_solid_friction_zero_leaves_the_fluid():
    c = case(friction(solid_friction=0.0), r753()["idler_shaft"], oil("10W-40 Q8 T905", 120.0), 27.8)
    assert solve_mesh(c, 280.0, False).friction_mean < 0.02


@pytest.mark.parametrize("by_regime", [False, True])
def test_the_loss_grows_with_the_power(by_regime):
    c = case(friction(), r753()["central_idler"], oil("10W-40 Q8 T905", 120.0), 30.0)
    losses = [solve_mesh(c, P, by_regime).sliding_loss for P in (1.0, 10.0, 100.0, 1000.0, 10000.0)]
    assert losses == sorted(losses)


@pytest.mark.parametrize(("said", "more"), [({}, {"flank_roughness": (1.6e-6,)}), ({"solid_friction": 0.07}, {})])
def test_rougher_flanks_and_more_solid_friction_cost_more(said, more):
    mesh, o = r753()["idler_shaft"], oil("10W-40 Q8 T905", 120.0)
    less, greater = (solve_mesh(case(friction(**s), mesh, o, 27.8), 280.0, True).sliding_loss for s in (said, more))
    assert less < greater


def test_two_roughnesses_count_as_their_root_of_squares():
    mesh, o = spur_pair(), oil(OILS[0], 40.0)
    one, two = (case(friction(flank_roughness=Ra), mesh, o, 25.0) for Ra in ((0.5e-6,), (0.3e-6, 0.4e-6)))
    assert one.surfaces.sigma == pytest.approx(0.5e-6 * math.sqrt(2))
    assert two.surfaces.sigma == pytest.approx(0.5e-6)
