"""Film and flash temperature against the forms that are printed in public code and text, and the sharing of the
load."""

import math

import numpy as np
import pytest

from calc.gears.rating.screening import load, micropitting, scuffing
from calc.library.catalogue import base_stocks
from tests.calc.gears.rating.test_screening import flash_at, path_of, spur
from tests.calc.gears.trains import SPEED, r753, solved


# --- the published forms
def test_thermo_elastic_factor_of_martensitic_steel():
    """ISO/TR 13989-1:2000 (A.13), (A.14): X_M = 1000·E_r^0.25/B_M is 50.0 for E = 206000, ν = 0.3, B_M = 435; 435 is
    13756 in SI."""
    E_r = load.reduced_modulus(0.3, 206e9, 0.3, 206e9)
    assert 1000 * (E_r / 1e6) ** 0.25 / 435 == pytest.approx(50.0, abs=0.2)
    assert 435 / math.sqrt(1e-3) == pytest.approx(13756, abs=0.5)


@pytest.mark.parametrize("beta", [0.0, 8.0])
def test_flash_temperature_is_the_form_for_cylindrical_gears(beta):
    """ISO/TR 13989-1:2000 (A.5), (A.6) with the angle factor of part 2 (13), as printed in public code: constants 0.51
    and 1.22.

    Θ_fl = μ·X_M·X_G·(X_Γ·w_Bt)^0.75·v_t^0.5/a^0.25 in N/mm, m/s, mm; 0.51·1.22 is 1.11·(π/32)^0.25 to its two digits.
    """
    gears = spur(beta=beta)
    t, p = solved(gears), path_of(gears)
    m, system = t.meshes["a_b"], t.system
    awt, at, an = m.working_pressure_angle, system.transverse_pressure_angle, system.alpha_n
    X_ab = (
        1.22 * (math.sin(awt) * math.cos(an) * math.cos(system.beta)) ** 0.25 / math.sqrt(math.cos(awt) * math.cos(at))
    )
    v_t, a, u = math.pi * SPEED * t.wheels["a"].pitch_diameter, m.centre_distance * 1e3, 36 / 24
    for rho in (0.999 * p.E, p.B, p.D, 1.001 * p.A):
        G, X = rho / p.C - 1, p.at(rho).X
        X_G = (
            0.51 * X_ab * math.sqrt(u + 1) * abs(math.sqrt(1 + G) - math.sqrt(1 - G / u)) / ((1 + G) * (u - G)) ** 0.25
        )
        w_Bt = 150 * math.cos(at)  # N/mm
        theirs = 0.06 * (226e3**0.25 * 1000 / 435) * X_G * (X * w_Bt) ** 0.75 * math.sqrt(v_t) / a**0.25
        assert flash_at(p, rho) == pytest.approx(theirs, rel=2e-3)


def test_flash_temperature_is_the_general_form():
    """ISO/TR 13989-1:2000 (5), as printed in public code, whose constant 2.52 leaves out part of the pressure angle:
    2.5 % lower."""
    gears = spur(x=(0.0, 0.0))
    p, u = path_of(gears), 36 / 24
    rho_1 = p.E
    at = p.at(rho_1)
    mm_1, mm_2, mm = at.rho_1 * 1e3, at.rho_2 * 1e3, at.rho_rel * 1e3
    w_Bt = 150 * math.cos(math.radians(20))
    bracket = abs(math.sqrt(mm_1) - math.sqrt(mm_2 / u)) / mm**0.25
    X_M = 226e3**0.25 * 1000 / 435
    theirs = 2.52 * 0.06 * X_M / 50 * (at.X * w_Bt) ** 0.75 * math.sqrt(SPEED) * bracket
    assert flash_at(p, rho_1) == pytest.approx(theirs, rel=0.025)


def test_both_flash_temperatures_are_one_physics():
    """ISO/TR 15144-1:2014 (80) has √π/2 where Blok has 1.11·π/4: 1.7 % apart at the same load, friction and
    pressure."""
    p = path_of(spur())
    at, E_r, w = p.at(p.E), 226e9, 150e3
    p_H = math.sqrt(E_r * w * at.X / (2 * math.pi * at.rho_n))
    micro = micropitting.local_flash_temperature(0.06, p_H, at.v_1, at.v_2, 13756.0**2, 13756.0**2, at.rho_n, E_r)
    assert micro / flash_at(p, p.E, w_t=w) == pytest.approx(math.sqrt(math.pi) / 2 / (1.11 * math.pi / 4), rel=1e-12)


@pytest.mark.parametrize(
    "base, k, s", [("mineral", 2.657e-8, 0.1348), ("PAO", 1.466e-8, 0.0507), ("PAG", 1.392e-8, 0.1572)]
)
def test_pressure_viscosity_at_38_degrees(base, k, s):
    """ISO/TR 15144-1:2014 (9) to (11), as printed in public code: α_38 = k·η_38^s with η in Pa·s."""
    ours = base_stocks()[base]
    assert ours.s == s
    assert ours.k * 1000**s == pytest.approx(k, rel=5e-4)


def test_film_is_that_of_the_standard_in_its_own_units():
    """ISO/TR 15144-1:2014 (4), (12): h in µm = 1600·ρ_n·G^0.6·U^0.7·W^-0.13·S^0.22, U = η·v_Σ/(2000·E_r·ρ_n), ρ in mm,
    E_r in N/mm²."""
    U = micropitting.velocity_parameter(0.01, 3.0, 2.0, 226e9, 7e-3)
    assert U == pytest.approx(0.01 * 5.0 / (2000 * 226000 * 7))
    h = micropitting.film_thickness(7e-3, 2800.0, U, 2e-5, 0.9)
    assert h * 1e6 == pytest.approx(1600 * 7 * 2800**0.6 * U**0.7 * 2e-5**-0.13 * 0.9**0.22)


@pytest.mark.parametrize("eps_gamma, K", [(1.5, 1.0), (2.0, 1.0), (2.5, 1.2236), (3.5, 1.3), (5.0, 1.3)])
def test_helical_load_factor(eps_gamma, K):
    """ISO/TR 13989-2:2000 (5), as printed in public code."""
    assert load.helical_load_factor(eps_gamma) == pytest.approx(K, abs=5e-5)


def test_scuffing_temperature_of_load_stages():
    """ISO/TR 13989-1:2000 (99): 80 + (0.85 + 1.4·X_W)·X_L·S²; nitrided steel stands more."""
    assert scuffing.scuffing_temperature(1.0, 1.0, 12.0) == pytest.approx(404.0)
    assert scuffing.scuffing_temperature(1.5, 1.0, 10.0) == pytest.approx(375.0)


# --- load sharing
def test_a_spur_pair_shares_by_thirds():
    p = path_of(spur())
    assert p.at(p.A).X == pytest.approx(1 / 3)
    assert p.at(p.B * (1 - 1e-9)).X == pytest.approx(2 / 3, abs=1e-6)
    assert p.at(p.B).X == p.at(p.C).X == p.at(p.D).X == 1.0
    assert p.at(p.E).X == pytest.approx(1 / 3)


def test_coarse_teeth_share_less_evenly():
    p = path_of(spur(), grade=10)
    assert p.at(p.A).X == pytest.approx(8 / 15)
    assert path_of(spur(), grade=4).at(p.A).X == pytest.approx(1 / 3)


def test_wide_helical_pair_carries_its_mean_load_with_buttressing():
    gears = r753()
    p = path_of(gears, "central_idler")
    eps_alpha, eps_beta = p.eps_alpha, p.eps_beta
    assert p.wide
    assert p.at(p.C).X == pytest.approx(1 / eps_alpha)
    assert p.at(p.A).X == pytest.approx((1 + 0.3 * eps_beta) / eps_alpha)
    assert p.at(p.A + p.way).X == pytest.approx(1 / eps_alpha)
    assert p.at(p.E).X == pytest.approx(p.at(p.A).X)


def test_narrow_helical_pair_has_both():
    p = path_of(spur(beta=5.0))
    assert not p.wide
    assert p.at(p.A).X == pytest.approx((1 + 0.3 * p.eps_beta) / 3)
    assert p.at(p.C).X == 1.0


def test_shares_of_the_pairs_make_one():
    p = path_of(spur())
    p_bt = p.D - p.A
    for part in (0.1, 0.4, 0.9):
        rho = p.A + part * (p.B - p.A)
        assert p.at(rho).X + p.at(rho + p_bt).X == pytest.approx(1.0)


def test_samples_agree_with_single_points():
    for p in (path_of(spur()), path_of(spur(beta=5.0)), path_of(r753(), "idler_shaft")):
        places = p.samples()
        many = p.at(places)
        assert np.all(np.diff(places) >= 0)
        assert [p.at(float(rho)).X for rho in places] == pytest.approx(list(many.X))
