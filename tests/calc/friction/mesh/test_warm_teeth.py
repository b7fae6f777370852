# SPDX-License-Identifier: Apache-2.0
"""Teeth warmer than the oil, by estimate or by the resistance of their bodies; oil under pressure by Roelands."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from calc.friction.mesh import loss, traction
from calc.friction.mesh import mixed as surfaces
from calc.friction.mesh.film import oil_at
from calc.friction.mesh.loss import Warming, case, solve_mesh
from calc.library.contact import bulk_rise
from calc.sheet.errors import NoSolution
from calc.solve import solve
from tests.calc.friction.documents import changed, design, pair
from tests.calc.friction.pairs import closed, friction, lubricant, r753, spur_pair

MESHES = {"spur": spur_pair(), "helical": r753()["idler_shaft"]}


def solved(P=5000.0, mesh="spur", T=60.0, n=25.0, by_regime=True, X_S=1.2, X_Ca=1.0, **said):
    c = case(friction(**said), MESHES[mesh], oil_at(lubricant(), T), n, Warming(T, X_S, X_Ca))
    return solve_mesh(c, P, by_regime)


# --- estimated by the loss
@pytest.mark.parametrize("by_regime", [True, False])
@pytest.mark.parametrize("mesh", MESHES)
@pytest.mark.parametrize("P", [10.0, 5000.0, 50000.0])
def test_the_estimate_is_the_warming_by_its_own_loss(P, mesh, by_regime):
    m = MESHES[mesh]
    found = solved(P, mesh, bulk="estimated", by_regime=by_regime, X_S=1.0, X_Ca=1.3)
    own = bulk_rise(
        P=P, mu_m=found.friction_mean, H_v=found.loss_factor, a=m.centre_distance, b=m.face_width, X_S=1.0, X_Ca=1.3
    )
    assert found.bulk_temperature == pytest.approx(60 + own, abs=1e-7)
    measured = solved(P, mesh, T=found.bulk_temperature, by_regime=by_regime)
    assert found.loss == pytest.approx(measured.loss, rel=1e-8)
    assert measured.bulk_temperature is None


def test_better_cooling_and_relief_keep_the_teeth_cooler():
    spray, dip, submerged = (solved(bulk="estimated", X_S=X_S).bulk_temperature for X_S in (1.2, 1.0, 0.2))
    relieved = solved(bulk="estimated", X_Ca=1.5).bulk_temperature
    assert 60 < submerged < dip < spray
    assert 60 < relieved < spray


def test_more_power_makes_warmer_teeth():
    T = [solved(P, bulk="estimated").bulk_temperature for P in (1.0, 10.0, 100.0, 1000.0, 10000.0, 100000.0)]
    assert T == sorted(T) and T[0] > 60


def test_a_measured_temperature_counts_before_an_estimate():
    found = closed(
        shaft_power=None,
        power=5000.0,
        speed=25.0,
        T=60.0,
        meshes={"pinion_gear": MESHES["spur"]},
        bulk="estimated",
        bulk_temperature=75.0,
    )
    alone = closed(
        shaft_power=None,
        power=5000.0,
        speed=25.0,
        T=60.0,
        meshes={"pinion_gear": MESHES["spur"]},
        bulk_temperature=75.0,
    )
    mesh = found.result.meshes["pinion_gear"]
    assert mesh.judged.bulk_temperature is None
    assert mesh.judged.loss == alone.result.meshes["pinion_gear"].judged.loss


def test_the_design_says_how_the_oil_comes():
    """gears.lubrication gives X_S."""
    documents = (
        changed(pair(), gears={"lubrication": way, "power_kW": 5.0}, friction={"bulk": "estimated"})
        for way in ("spray", "submerged")
    )
    spray, submerged = (
        solve(design(d)).outcomes["friction"].result.meshes["crank_camshaft"].judged.bulk_temperature for d in documents
    )
    assert spray > submerged > 40


@pytest.mark.parametrize(
    "slope, third", [(0.5, 20.0), (0.89, 10 / 0.11), (0.95, 105.0), (-0.97, 10 / 1.97), (-1.05, 10 - 10.5 / 2)]
)
def test_a_temperature_is_found_by_secant_steps(slope, third):
    """T = 10 + slope·T from 0: first what follows from 0, then the place where the line through both meets T, its
    slope held between −1 and what a step may trust, here 0.9."""
    tried = []

    def at(T):
        tried.append(T)
        return 10 + slope * T - T, "state"

    assert loss._steadied(at, 0.0, 0.9, lambda gap, reason: NoSolution(reason)) == "state"
    assert tried[:3] == pytest.approx([0.0, 10.0, third]) and tried[-1] == pytest.approx(10 / (1 - slope))


@pytest.mark.parametrize(
    "gap, words", [(2e-8, "off by 2·10⁻⁸ K after 100 passes"), (1400.0, "above 1500 °C, where the laws of the oil end")]
)
def test_a_temperature_that_is_not_found_says_why(gap, words):
    with pytest.raises(NoSolution) as caught:
        loss._steadied(lambda T: (gap, ""), 0.0, 0.9, lambda left, reason: NoSolution(reason))
    assert words in str(caught.value)


def test_an_estimate_that_does_not_settle_names_mesh_and_residual(monkeypatch):
    monkeypatch.setattr(loss, "PASSES", 1)
    with pytest.raises(
        NoSolution, match=r"mesh pinion–gear: temperature of the teeth; off by [0-9.]+ K after 1 passes"
    ):
        solved(bulk="estimated")


# --- by the bodies' resistance
def test_bodies_without_resistance_change_nothing():
    assert solved(body_resistance=(0.0,)).loss == solved(body_resistance=(0.0, 0.0)).loss == solved().loss


def test_resistance_warms_the_skins_and_thins_the_film():
    R = (0.0, 0.001, 0.01, 0.1)
    found = [solved(body_resistance=(r,)) for r in R]
    assert [m.temperature_max for m in found] == sorted(m.temperature_max for m in found)
    assert [m.film_min for m in found] == sorted((m.film_min for m in found), reverse=True)
    assert found[-1].temperature_max > found[0].temperature_max + 0.5


def test_one_resistance_stands_for_both_wheels():
    assert solved(body_resistance=(0.02,)).loss == solved(body_resistance=(0.02, 0.02)).loss
    assert solved(body_resistance=(0.02, 0.0)).loss != solved(body_resistance=(0.0, 0.02)).loss


def test_all_the_heat_goes_into_the_body_that_does_not_resist():
    """M_1 far above all else: ε → 0, the driver takes nothing; the skins stay as warm as the driven body allows."""
    assert traction.heat_partition(B_1=1e-3, B_2=2e-3, M_1=1e6, M_2=0.0) == pytest.approx(0.0, abs=1e-8)
    assert traction.heat_partition(B_1=1e-3, B_2=2e-3, M_1=0.0, M_2=1e6) == pytest.approx(1.0)
    assert traction.heat_partition(B_1=1e-3, B_2=1e-3, M_1=5.0, M_2=5.0) == pytest.approx(0.5)


def test_the_skins_are_as_warm_as_their_heat_makes_them():
    """T_m = T_b + q·(u_1·ε·M_1 + u_2·(1 − ε)·M_2)/(u_1 + u_2), by hand for equal speeds: half of q·(ε·M_1 + (1 −
    ε)·M_2)."""
    T_m = traction.skin_temperature(T_b=60.0, q=1000.0, epsilon=0.4, M_1=0.01, M_2=0.02, u_1=3.0, u_2=3.0)
    assert T_m == pytest.approx(60 + 500 * (0.4 * 0.01 + 0.6 * 0.02))
    assert surfaces.body_resistance(R_K=2.0, b=0.02, beta_b=0.0) == pytest.approx(0.04)


def test_skins_that_do_not_settle_name_position_and_residual(monkeypatch):
    monkeypatch.setattr(loss, "PASSES", 2)
    with pytest.raises(
        NoSolution,
        match=r"mesh pinion–gear: temperature of the skins; [0-9.]+ mm from T₁: off by .* K after 2 passes; less friction.body",
    ):
        solved(body_resistance=(0.02,))


# --- Roelands
def under(law, eta, alpha, p):
    if law == "barus":
        return traction.viscosity_under_pressure(eta_f=eta, alpha_f=alpha, p_m=p)
    return traction.viscosity_by_roelands(eta_f=eta, Z=traction.roelands_index(alpha_f=alpha, eta_f=eta), p_m=p)


def test_roelands_by_hand():
    """10 mPa·s, 20 GPa⁻¹, 0.5 GPa: ln η + 9.67 = 5.06483, Z = 0.774275, 3.55^Z = 2.66703, exponent 8.4432."""
    assert traction.roelands_index(alpha_f=2e-8, eta_f=0.01) == pytest.approx(0.774275, abs=1e-6)
    assert under("roelands", 0.01, 2e-8, 0.5e9) == pytest.approx(0.01 * np.exp(8.4432), rel=2e-4)


@given(eta=st.floats(1e-3, 1.0), alpha=st.floats(1e-9, 4e-8), p=st.floats(0, 3e9))
def test_roelands_is_milder_than_barus_where_its_index_is_below_one(eta, alpha, p):
    """Both begin with the same slope; one is concave in the pressure for Z < 1, convex for Z > 1."""
    Z = traction.roelands_index(alpha_f=alpha, eta_f=eta)
    mild, steep = under("roelands", eta, alpha, p), under("barus", eta, alpha, p)
    assert eta <= mild * (1 + 1e-12) and eta <= steep * (1 + 1e-12)
    if Z <= 1:
        assert mild <= steep * (1 + 1e-9)
    else:
        assert mild >= steep * (1 - 1e-9)


@given(eta=st.floats(1e-3, 1.0), alpha=st.floats(1e-9, 4e-8))
def test_both_laws_begin_with_the_same_slope(eta, alpha):
    p = 1e3
    assert np.log(under("roelands", eta, alpha, p) / eta) == pytest.approx(
        np.log(under("barus", eta, alpha, p) / eta), rel=1e-4, abs=1e-12
    )


@pytest.mark.parametrize("mesh", MESHES)
def test_roelands_lowers_friction_at_high_pressure_and_leaves_light_load(mesh):
    heavy = [
        solved(100000.0, mesh, by_regime=False, pressure_law=law, solid_friction=0.0).loss
        for law in ("barus", "roelands")
    ]
    assert heavy[1] <= heavy[0]
    light = [solved(5.0, mesh, by_regime=False, pressure_law=law).loss for law in ("barus", "roelands")]
    assert light[1] == pytest.approx(light[0], rel=0.02)


def test_the_law_is_an_input_of_the_design():
    heavy = changed(pair(), gears={"power_kW": 100.0})
    one, two = (
        solve(design(heavy.with_value("friction.pressure_law", law)))
        .outcomes["friction"]
        .result.meshes["crank_camshaft"]
        .case
        for law in ("barus", "roelands")
    )
    assert (one.surfaces.roelands, two.surfaces.roelands) == (False, True)


# --- what both have in common
@pytest.mark.parametrize(
    "said",
    [
        dict(bulk="estimated"),
        dict(body_resistance=(0.05, 0.01)),
        dict(pressure_law="roelands"),
        dict(load_sharing="smooth"),
    ],
)
@pytest.mark.parametrize("by_regime", [True, False])
def test_nothing_slides_at_c_and_no_film_is_colder_than_the_teeth(said, by_regime):
    for mesh in MESHES:
        c = case(friction(**said), MESHES[mesh], oil_at(lubricant(), 60.0), 25.0)
        assert c.path.at_pitch_point(c.motion.V_s) == 0.0
        local = solve_mesh(c, 5000.0, by_regime).local
        x = np.asarray(local.x)
        at_C = int(np.argmin(np.abs(x - c.path.C_C)))
        assert np.asarray(local.q)[at_C] == 0.0
        assert np.asarray(local.mu)[at_C] >= 0.0
        assert (np.asarray(local.T_f) >= 60.0 - 1e-9).all()
        for column in vars(local).values():
            assert np.isfinite(column).all()


def test_the_bulk_temperature_of_the_oil_is_kept_apart_from_that_of_the_teeth():
    """Wheel losses see the oil, the film sees the teeth."""
    only = {"pinion_gear": MESHES["spur"]}
    cool, warm = (
        closed(shaft_power=None, power=5000.0, speed=25.0, T=60.0, meshes=only, bulk_temperature=T).result
        for T in (60.0, 90.0)
    )
    assert cool.wheels["pinion"].windage == warm.wheels["pinion"].windage
    assert warm.meshes["pinion_gear"].judged.film_min < cool.meshes["pinion_gear"].judged.film_min
    assert replace(cool, residual=0.0).oil_viscosity > warm.oil_viscosity
