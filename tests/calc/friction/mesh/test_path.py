# SPDX-License-Identifier: Apache-2.0
"""The path of contact: its points, the sharing of the load, and how fine the positions must be."""

import math
from dataclasses import replace

import numpy as np
import pytest

from calc.friction.mesh.loss import case, loss_factor, solve_mesh
from calc.friction.mesh.path import (
    _legendre,
    floored_line_load,
    line_load,
    linear_load_sharing,
    motion,
    path,
    smooth_load_sharing,
    transverse_force,
)
from calc.library.contact import hertz_pressure, ohlendorf_loss_factor
from calc.sheet.errors import NoSolution
from tests.calc.friction.pairs import friction, fzg, oil, r753, reference, spur_pair

VECTORS = reference("friction_vectors.toml")
OIL = "10W-40 Q8 T905"


def wider(mesh, b):
    return replace(mesh, driver=replace(mesh.driver, face_width=b), driven=replace(mesh.driven, face_width=b))


def tips(mesh, driver=1.0, driven=1.0):
    one, two = mesh.driver, mesh.driven
    return replace(
        mesh,
        driver=replace(one, tip_radius=one.tip_radius * driver),
        driven=replace(two, tip_radius=two.tip_radius * driven),
    )


# --- published
def test_loss_factor_of_the_fzg_gears():
    known, p = VECTORS["fzg_c"], path(fzg())
    H_V = ohlendorf_loss_factor(
        z_1=16, z_2=24, beta_b=0.0, eps_alpha=p.epsilon_alpha, eps_1=p.epsilon_1, eps_2=p.epsilon_2
    )
    assert H_V == pytest.approx(known["ohlendorf_loss_factor"], abs=known["tolerance"])


@pytest.mark.parametrize("stage", range(12))
def test_hertzian_pressure_of_the_fzg_load_stages(stage):
    known, mesh = VECTORS["iso_14635"], fzg(b=20e-3)
    p = path(mesh)
    m = motion(mesh, p, 1.0)
    F_bt = known["torque_Nm"][stage] / mesh.driver.base_radius
    p_C = float(hertz_pressure(w=F_bt / mesh.face_width, E_r=m.E_r, rho_n=p.at_pitch_point(m.R)))
    assert p_C / 1e6 == pytest.approx(known["pressure_MPa"][stage], rel=known["tolerance"][min(stage, 1)])


@pytest.mark.parametrize("name", ["central_idler", "idler_shaft"])
def test_contact_ratios_of_the_train(name):
    known, p = VECTORS["finotti"], path(r753()[name])
    assert p.epsilon_alpha == pytest.approx(known["transverse_contact_ratio"][name], abs=known["tolerance"])
    assert p.epsilon_beta == pytest.approx(known["overlap_ratio"][name], abs=known["tolerance"])


# --- the spur pair
def test_points_of_the_thesis_pair():
    """Computed by hand from its data: C_A … C_E, C_F, base pitch in mm."""
    p = path(spur_pair())
    assert [1e3 * x for x in (*p.marks, p.C_F, p.p_bt)] == pytest.approx(
        [8.71330, 14.01302, 14.62280, 15.61421, 20.91392, 43.86839, 6.90090], abs=2e-5
    )
    assert p.epsilon_alpha == pytest.approx(1.76797, abs=1e-5)


@pytest.mark.parametrize("sharing", [linear_load_sharing, smooth_load_sharing])
def test_two_pairs_carry_the_whole_load_together(sharing):
    p = path(spur_pair())
    ends = dict(C_A=p.C_A, C_B=p.C_B, C_D=p.C_D, C_E=p.C_E)
    x = np.linspace(p.C_A, p.C_B, 52)[1:-1]  # at D itself one pair takes all
    assert sharing(x=x, **ends) + sharing(x=x + p.p_bt, **ends) == pytest.approx(np.ones(50), abs=1e-9)
    assert sharing(x=np.array([p.C_B, p.C_C, p.C_D]), **ends) == pytest.approx([1, 1, 1])


@pytest.mark.parametrize(("sharing", "expected"), [("linear", 0.090638), ("smooth", 0.074384)])
def test_loss_factors_of_the_thesis_pair(sharing, expected):
    c = case(friction(load_sharing=sharing), spur_pair(), oil(OIL, 60.0), 25.0)
    assert solve_mesh(c, 1000.0, False).loss_factor == pytest.approx(expected, rel=1e-5)


def test_ohlendorf_is_exact_where_two_pairs_share_half_and_half():
    mesh = spur_pair()
    p = path(mesh)
    c = case(friction(), mesh, oil(OIL, 60.0), 25.0)
    share = np.where((p.x < p.C_B) | (p.x > p.C_D), 0.5, 1.0)
    F_bt = transverse_force(P=1000.0, omega_1=c.motion.omega_1, r_b1=mesh.driver.base_radius)
    H_VL = loss_factor(s=p.weight, w=share * F_bt / mesh.face_width, V_s=c.motion.V_s, P=1000.0)
    H_V = ohlendorf_loss_factor(
        z_1=38, z_2=76, beta_b=0.0, eps_alpha=p.epsilon_alpha, eps_1=p.epsilon_1, eps_2=p.epsilon_2
    )
    assert H_VL == pytest.approx(H_V, rel=1e-12)
    assert H_V == pytest.approx(0.098764, abs=1e-6)


def test_film_and_pressure_see_a_hundredth_of_the_load():
    w = np.array([0.0, 9.9, 10.1, 1000.0])
    assert floored_line_load(w=w, w_max=1000.0) == pytest.approx([10.0, 10.0, 10.1, 1000.0])


# --- helical
@pytest.mark.parametrize("name", r753())
def test_the_lines_carry_the_whole_force(name):
    mesh = r753()[name]
    p = path(mesh)
    w, _ = line_load(mesh, p, 100.0)
    assert np.sum(p.weight * w) * math.cos(mesh.base_helix_angle) == pytest.approx(100.0, rel=2e-4)
    assert np.sum(p.weight) == pytest.approx(
        p.epsilon_alpha * mesh.face_width / math.cos(mesh.base_helix_angle), rel=1e-12
    )


def test_an_overlap_of_one_makes_the_load_uniform_and_the_loss_factor_closed():
    """ε_β = 1: the contact length never changes, H_V = π(u + 1)/(z₁·u·cos β_b)·(ε₁² + ε₂²)/ε_α."""
    mesh = r753()["central_idler"]
    mesh = wider(mesh, path(mesh).p_bt / math.tan(mesh.base_helix_angle))
    p = path(mesh)
    assert p.epsilon_beta == pytest.approx(1.0)
    assert np.ptp(p.carried) < 1e-12 * np.mean(p.carried)
    u, z_1 = 39 / 36, 36
    expected = (
        math.pi
        * (u + 1)
        / (z_1 * u * math.cos(mesh.base_helix_angle))
        * (p.epsilon_1**2 + p.epsilon_2**2)
        / p.epsilon_alpha
    )
    c = case(friction(), mesh, oil(OIL, 120.0), 30.0)
    assert solve_mesh(c, 300.0, False).loss_factor == pytest.approx(expected, rel=1e-10)


# --- how fine
@pytest.mark.parametrize(("sharing", "tolerance"), [("linear", 1e-7), ("smooth", 1e-5)])
def test_positions_of_a_spur_pair_are_fine_enough(sharing, tolerance):
    said, o = friction(load_sharing=sharing), oil("friction thesis 10W40", 40.0)
    coarse, fine = (
        solve_mesh(case(said, spur_pair(), o, 25.0, **more), 100.0, False) for more in ({}, {"points": 150})
    )
    assert coarse.loss == pytest.approx(fine.loss, rel=tolerance)


@pytest.mark.parametrize("by_regime", [False, True])
@pytest.mark.parametrize("b", [6e-3, 15e-3, 40e-3])
def test_strips_of_a_helical_pair_are_fine_enough(b, by_regime):
    mesh, o = wider(r753()["crank_central"], b), oil(OIL, 120.0)
    coarse, fine = (
        solve_mesh(case(friction(), mesh, o, 43.3, **more), 290.0, by_regime)
        for more in ({}, {"points": 6, "strips": 121})
    )
    assert coarse.loss == pytest.approx(fine.loss, rel=2e-4)
    assert coarse.film_min == pytest.approx(fine.film_min, rel=5e-3)


def test_how_many_positions_a_path_has():
    """40 Gauss points on each of the four pieces of a spur path and A … E; 21 strips across a helical face, with 3 on
    each piece."""
    spur, helical = path(spur_pair()), path(r753()["idler_shaft"])
    assert spur.x.size == spur.per_strip == 4 * 40 + 5
    assert helical.x.size == 21 * helical.per_strip
    assert helical.per_strip - 5 == 3 * (path(r753()["idler_shaft"], points=1).per_strip - 5)
    assert helical.in_the_middle(helical.x) == pytest.approx(np.sort(helical.x.reshape(21, -1)[10]))


# --- what can not mesh
@pytest.mark.parametrize(
    "mesh",
    [
        tips(spur_pair(), driver=1.15),
        tips(spur_pair(), driven=1.1),
        tips(spur_pair(), 0.97, 0.97),
        tips(spur_pair(), 1.03, 1.03),
        replace(spur_pair(), centre_distance=120e-3),
        replace(spur_pair(), centre_distance=142e-3),
        wider(tips(r753()["idler_shaft"], 0.97, 0.97), 2e-3),
    ],
)
def test_teeth_that_do_not_mesh_are_refused(mesh):
    with pytest.raises(NoSolution, match="path of contact"):
        path(mesh)


@pytest.mark.parametrize("ratio, meshes", [(0.99, False), (1.01, True), (1.99, True), (2.01, False)])
def test_spur_teeth_share_their_load_between_one_pair_and_two(ratio, meshes):
    """Both tips by the factor that gives the transverse contact ratio (ρ_E − ρ_A)/p_bt."""
    mesh = spur_pair()
    two = mesh.driver, mesh.driven
    C_F = math.sqrt(mesh.centre_distance**2 - sum(wheel.base_radius for wheel in two) ** 2)

    def contact(factor):
        ends = (math.sqrt((wheel.tip_radius * factor) ** 2 - wheel.base_radius**2) for wheel in two)
        return (sum(ends) - C_F) / (2 * math.pi * mesh.driver.base_radius / mesh.driver.teeth)

    low, high = 0.97, 1.03
    for _ in range(50):
        middle = (low + high) / 2
        low, high = (middle, high) if contact(middle) < ratio else (low, middle)
    if meshes:
        assert path(tips(mesh, low, low)).epsilon_alpha == pytest.approx(ratio)
    else:
        with pytest.raises(NoSolution, match=f"ε_α = {ratio}.*a contact ratio from 1 to 2"):
            path(tips(mesh, low, low))


@pytest.mark.parametrize("value", [float("nan"), float("inf"), -1.0, 0.0])
@pytest.mark.parametrize("field", ["base_radius", "tip_radius", "face_width", "E", "teeth"])
def test_a_wheel_without_meaning_is_refused_by_its_field(field, value):
    mesh = spur_pair()
    with pytest.raises(NoSolution, match=field):
        path(replace(mesh, driver=replace(mesh.driver, **{field: value})))


@pytest.mark.parametrize("points", [2, 11, 40])
def test_our_nodes_are_those_of_gauss_and_legendre(points):
    nodes, weights = _legendre(points)
    theirs = np.polynomial.legendre.leggauss(points)
    assert nodes == pytest.approx(theirs[0], abs=1e-14)
    assert weights == pytest.approx(theirs[1], abs=1e-14)
