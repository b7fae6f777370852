# SPDX-License-Identifier: Apache-2.0
"""Published models of friction: what another program makes of two pairs, where each says that it is outside its range,
their spread."""

import math
from dataclasses import replace

import numpy as np
import pytest

from calc.friction import models as compared
from calc.friction import models as r
from calc.friction.mesh.film import oil_at
from calc.friction.mesh.geometry import MeshGeometry
from calc.friction.mesh.loss import case, solve_mesh
from calc.friction.mesh.path import contact_length, line_load, motion, path
from calc.library.contact import half_width, hertz_pressure, relative_radius, sum_of_speeds
from calc.library.contact import ohlendorf_loss_factor as ohlendorf
from calc.library.lubricant import Lubricant
from tests.calc.friction.pairs import closed, friction, lubricant, oil, r753, reference, shown, spur_pair, wheel

KNOWN = reference("friction_models.toml")
C40, H501 = KNOWN["c40"], KNOWN["h501"]
ONLY = {"pinion_gear": spur_pair()}


def c40():
    alpha, b = math.radians(20), C40["face_width"] * 1e-3
    one, two = (wheel(f"w{z}", z, 4.5e-3, alpha, r_a * 1e-3, b) for z, r_a in zip(C40["teeth"], C40["tip_radii"]))
    return MeshGeometry(one, two, C40["centre_distance"] * 1e-3, 0.0)


def h501():
    """Its tips are not shortened: r_a = r + m_n·(1 + x)."""
    m_n, beta, z, x, b = 3.5e-3, math.radians(15), H501["teeth"], H501["profile_shifts"], H501["face_width"] * 1e-3
    alpha_t, m_t = math.atan(math.tan(math.radians(20)) / math.cos(beta)), m_n / math.cos(beta)
    involute = math.tan(alpha_t) - alpha_t + 2 * math.tan(math.radians(20)) * sum(x) / sum(z)
    alpha_w = alpha_t
    for _ in range(60):
        alpha_w -= (math.tan(alpha_w) - alpha_w - involute) / math.tan(alpha_w) ** 2
    a_w = m_t * sum(z) / 2 * math.cos(alpha_t) / math.cos(alpha_w)
    one, two = (wheel(f"w{n}", n, m_t, alpha_t, m_t * n / 2 + m_n * (1 + shift), b) for n, shift in zip(z, x))
    return MeshGeometry(one, two, a_w, math.asin(math.sin(beta) * math.cos(math.radians(20))))


# --- FZG C, 40 mm wide
def test_c40_has_the_same_path():
    p, mesh = path(c40()), c40()
    assert [mesh.driver.base_radius * 1e3, mesh.driven.base_radius * 1e3] == pytest.approx(C40["base_radii"], abs=1e-4)
    assert p.p_bt * 1e3 == pytest.approx(C40["base_pitch"], abs=1e-5)
    assert [p.epsilon_1, p.epsilon_2] == pytest.approx(C40["contact_ratios"], abs=2e-5)
    assert relative_radius(rho_1=p.C_C, rho_2=p.C_F - p.C_C) * 1e3 == pytest.approx(C40["radius_at_C"], abs=1e-4)


def test_c40_loses_by_ohlendorf_s_factor():
    p = path(c40())
    H_V = ohlendorf(eps_1=p.epsilon_1, eps_2=p.epsilon_2, eps_alpha=p.epsilon_alpha, z_1=16, z_2=24, beta_b=0.0)
    assert H_V == pytest.approx(C40["ohlendorf_loss_factor"], abs=1.5e-5)
    assert H_V == pytest.approx(C40["local_loss_factor"], rel=2e-3)


def test_c40_presses_as_much():
    """At C one pair alone, at the highest point of it too; two pairs half and half at the lowest."""
    mesh, p = c40(), path(c40())
    m = motion(mesh, p, 30.0)
    w = C40["torque_Nm"] / mesh.driver.base_radius / mesh.face_width

    def pressed(place, share):
        return (
            float(hertz_pressure(w=w * share, E_r=m.E_r, rho_n=relative_radius(rho_1=place, rho_2=p.C_F - place))) / 1e6
        )

    assert pressed(p.C_C, 1.0) == pytest.approx(C40["pressure_MPa"][0], abs=0.02)
    alone = max(pressed(x, 1.0) for x in np.linspace(p.C_B, p.C_D, 201))
    assert alone == pytest.approx(C40["pressure_MPa"][1], rel=2e-3)
    shared = min(pressed(x, 0.5) for x in (*np.linspace(p.C_A, p.C_B, 201), *np.linspace(p.C_D, p.C_E, 201)))
    assert shared == pytest.approx(C40["pressure_MPa"][2], rel=2e-3)
    b_H = half_width(w=w, rho_n=C40["radius_at_C"] * 1e-3, E_r=m.E_r)
    assert b_H * 1e6 == pytest.approx(C40["half_width_um"], rel=2e-4)  # theirs at the sample nearest to C


def schlenk_of(known, w_t, rho_C):
    return r.schlenk(
        w_t=w_t,
        v_SumC=known["sum_of_speeds"],
        rho_C=rho_C,
        eta_0=known["viscosity_mPas"] * 1e-3,
        Ra=known["roughness_um"] * 1e-6,
        X_L=known["lubricant_factor"],
    )


def test_c40_rubs_as_much_by_schlenk():
    """With its own inputs: the normal force over the width, its lubricant factor, its mean roughness."""
    mesh, p = c40(), path(c40())
    w = C40["torque_Nm"] / mesh.driver.base_radius / mesh.face_width
    mu = schlenk_of(C40, w, C40["radius_at_C"] * 1e-3)
    assert mu == pytest.approx(C40["friction_mean"], abs=1e-6)
    P = C40["torque_Nm"] * 2 * math.pi * 30.0
    assert r.loss_of_mean_friction(P=P, mu_m=mu, H_V=C40["local_loss_factor"]) == pytest.approx(
        C40["power_lost"], rel=1e-4
    )
    assert sum_of_speeds(v_C=p.at_pitch_point(motion(mesh, p, 30.0).u_e)) == pytest.approx(
        C40["sum_of_speeds"], abs=1e-4
    )


# --- helical
def test_h501_has_the_same_path():
    p = path(h501())
    assert [p.epsilon_1, p.epsilon_2] == pytest.approx(H501["contact_ratios"], abs=3e-5)
    assert p.epsilon_beta == pytest.approx(H501["overlap_ratio"], abs=1e-4)
    said = dict(
        g_alpha=p.epsilon_alpha * p.p_bt, g_beta=p.epsilon_beta * p.p_bt, p_bt=p.p_bt, beta_b=h501().base_helix_angle
    )
    shortest = np.min(contact_length(s=np.linspace(0, p.p_bt, 20001), **said))
    assert shortest * 1e3 == pytest.approx(H501["least_length"], rel=1e-3)


def test_h501_loses_by_both_factors():
    """The local one is larger: Ohlendorf's knows no lines across the face."""
    mesh, p = h501(), path(h501())
    H_V = ohlendorf(
        eps_1=p.epsilon_1, eps_2=p.epsilon_2, eps_alpha=p.epsilon_alpha, z_1=20, z_2=30, beta_b=mesh.base_helix_angle
    )
    assert H_V == pytest.approx(H501["ohlendorf_loss_factor"], abs=2e-5)
    c = case(friction(), mesh, oil("10W-40 Q8 T905", 80.0), H501["speed_rpm"] / 60)
    H_VL = solve_mesh(c, H501["power_kW"] * 1e3, False).loss_factor
    assert H_VL == pytest.approx(H501["local_loss_factor"], rel=5e-3)
    assert H_VL > 1.1 * H_V


def test_h501_rubs_as_much_by_schlenk():
    """With its own inputs: the normal force over the shortest length of line, the radius of the transverse section."""
    p = path(h501())
    rho_C = relative_radius(rho_1=p.C_C, rho_2=p.C_F - p.C_C)
    w = H501["normal_force"] / H501["least_length"] * 1e3
    assert schlenk_of(H501, w, rho_C) == pytest.approx(H501["friction_mean"], rel=1e-4)
    assert H501["power_kW"] * 1e3 * H501["friction_mean"] * H501["local_loss_factor"] == pytest.approx(
        H501["power_lost"], rel=1e-3
    )


# --- where they say that they are outside
def pinion(P, n=25.0, T=60.0, **said):
    return case(friction(**said), spur_pair(), oil("10W-40 Q8 T905", T), n), P


def power_of(w, n=25.0):
    """The power at which the spur pair has the line load w."""
    pair = spur_pair()
    return w * pair.face_width * 2 * math.pi * n * pair.driver.base_radius


@pytest.mark.parametrize("of", [r.of_schlenk, r.of_niemann])
@pytest.mark.parametrize("w, said", [(149e3, "line load 149 N/mm"), (151e3, "")])
def test_the_line_load_from_which_tests_of_gears_hold(of, w, said):
    outside = of(*pinion(power_of(w)), 0.1).outside
    assert outside.startswith(said) and bool(outside) == bool(said) and ("150" in outside) == bool(said)


@pytest.mark.parametrize("of", [r.of_schlenk, r.of_niemann])
def test_the_speed_from_which_tests_of_gears_hold(of):
    pair = spur_pair()
    p = path(pair)
    n_1 = 0.5 / (2 * math.pi * p.C_C)  # 1 m/s of both flanks together
    slow, fast = (of(*pinion(power_of(2e5, n), n), 0.1).outside for n in (0.99 * n_1, 1.01 * n_1))
    assert slow.startswith("sum of speeds 0.99 m/s") and fast == ""
    both = of(*pinion(power_of(1e5, 0.5 * n_1), 0.5 * n_1), 0.1).outside
    assert "line load" in both and "; sum of speeds" in both


@pytest.mark.parametrize("of", [r.of_schlenk, r.of_niemann])
@pytest.mark.parametrize("v, outside", [(49.9, ""), (50.1, "pitch line 50.1 m/s, tests up to 50")])
def test_the_pitch_line_up_to_which_tests_of_gears_hold(of, v, outside):
    pair = spur_pair()
    n = v / (2 * math.pi * pair.centre_distance * 38 / (38 + 76))
    assert of(*pinion(power_of(2e5, n), n), 0.1).outside == outside


@pytest.mark.parametrize("p_H, inside", [(0.497e9, False), (0.503e9, True), (2.49e9, True), (2.51e9, False)])
def test_the_pressures_of_xu_and_kahraman_s_runs(p_H, inside):
    """0.5 to 2.5 GPa at the most; the power for a pressure by Hertz: its square."""
    P = 10e3 * (p_H / solve_mesh(*pinion(10e3), False).pressure_max) ** 2
    outside = r.of_xu_kahraman(*pinion(P, flank_roughness=(0.3e-6,)), 0.1).outside
    assert ("pressure up to" in outside) == (not inside)


@pytest.mark.parametrize("Ra, says", [(0.7e-6, False), (0.72e-6, True)])
def test_the_roughness_of_xu_and_kahraman_s_runs(Ra, says):
    """√2·0.7071 µm is 1 µm."""
    outside = r.of_xu_kahraman(*pinion(20000.0, flank_roughness=(Ra,)), 0.1).outside
    assert ("roughness" in outside) == says


def test_xu_and_kahraman_end_at_two_micrometres():
    smooth, rough = (r.of_xu_kahraman(*pinion(20000.0, flank_roughness=(Ra,)), 0.1) for Ra in (1.41e-6, 1.42e-6))
    assert smooth is not None and rough is None


def of_benedict_and_kelley(P, n=25.0, T=20.0):
    """Their friction along the path, kept within its bounds, with what each position weighs and slides."""
    c, P = pinion(P, n, T)
    w = line_load(c.mesh, c.path, P / (c.motion.omega_1 * c.mesh.driver.base_radius))
    eta, V_s, V_T = c.oil.eta_0 * 1e3, np.maximum(c.motion.V_s, 1e-9), c.motion.u_1 + c.motion.u_2
    mu = np.clip(0.0127 * np.log10(29.66 * w[1] / (eta * V_s * V_T**2)), 0.01, 0.2)
    return c, mu, c.path.weight, w[0] * c.motion.V_s


def test_benedict_and_kelley_along_the_path():
    """The mean of their friction, weighted by load and sliding; the sum of the speeds is that of both flanks."""
    for P in (300.0, 20000.0):
        c, mu, s, slid = of_benedict_and_kelley(P)
        found = r.of_benedict_kelley(c, P, 0.1)
        assert found.loss == pytest.approx(np.sum(s * slid * mu), rel=1e-12)
        assert found.friction_mean == pytest.approx(np.sum(s * slid * mu) / np.sum(s * slid), rel=1e-12)


@pytest.mark.parametrize("P, expected", [(187.0, 0.533), (199.0, 0.501), (211.0, 0.484), (219.0, 0.468)])
def test_benedict_and_kelley_s_bounds_may_hold_on_half_of_the_path(P, expected):
    """Outside from one half on."""
    c, mu, s, _ = of_benedict_and_kelley(P)
    share = np.sum(s[(mu == 0.01) | (mu == 0.2)]) / np.sum(s)
    held = f"held at its bounds on {100 * share:.0f} % of the path"
    assert share == pytest.approx(expected, abs=5e-4)
    assert r.of_benedict_kelley(c, P, 0.1).outside == (held if expected > 0.5 else "")


def test_benedict_and_kelley_say_where_their_bounds_hold():
    free, held = (r.of_benedict_kelley(*pinion(P, n, T), 0.1) for P, n, T in ((20000.0, 25.0, 60.0), (5.0, 100.0, 0.0)))
    assert free.outside == ""
    assert held.outside.startswith("held at its bounds on") and held.friction_mean == pytest.approx(0.01, rel=1e-6)


def test_the_regressions_are_told_by_their_ranges():
    """A train that drives a counter-shaft carries less than any was fitted to."""
    found = closed()
    check = next(c for c in found.checks if c.id == "friction.train.models")
    assert check.kind == "method" and check.verdict == "note"
    models = [mesh.published_models for mesh in found.result.meshes.values()]
    inside = [name for name in models[0] if all(m[name] is not None and not m[name].outside for m in models)]
    assert check.value == len(inside)
    assert "Schlenk" in check.advice


def test_the_table_names_what_does_not_run():
    found = closed(flank_roughness=(3e-6,))
    table = next(t for t in found.tables if t.id == "models_idler_shaft")
    row = next(row for row in table.rows if row[0].startswith("Xu and Kahraman"))
    assert row[1] is None and row[-1] == "runs away: not shown"
    assert len(table.rows) == 2 + len(r.MODELS)


@pytest.mark.parametrize("lead, outside", [(0.99, True), (1.01, False), (1.9, False)])
def test_the_table_says_where_a_rigid_film_governs(lead, outside):
    """Of the friction source's EHL film alone, which then is not the thickest."""
    mesh = closed(shaft_power=None, power=20000.0, speed=25.0, T=60.0, meshes=ONLY).result.meshes["pinion_gear"]
    rows = r.table(
        "key", "title", replace(mesh.judged, lead_at_pitch=lead), mesh.judged, 0.1, mesh.published_models
    ).rows
    assert rows[0][-1] == "" and rows[1][-1] == ("outside: a rigid isoviscous film governs" if outside else "")


# --- side by side
def test_the_spread_is_the_largest_over_the_smallest():
    found = closed(shaft_power=None, power=20000.0, speed=25.0, T=60.0, meshes=ONLY)
    mesh = found.result.meshes["pinion_gear"]
    losses = [
        mesh.judged.loss,
        mesh.source.loss,
        *(one.loss for one in mesh.published_models.values() if one is not None),
    ]
    assert mesh.model_spread == pytest.approx(max(losses) / min(losses))
    assert 1 < mesh.model_spread < 5
    assert compared.spread_of([3.0, 1.0, 2.0]) == 3.0
    assert compared.spread_of([3.0, 0.0]) is None


def test_all_models_see_the_same_power():
    found = shown(closed(shaft_power=None, power=20000.0, speed=25.0, T=60.0, meshes=ONLY))
    for model in ("schlenk", "niemann"):
        expected = 20000 * found[f"pinion_gear.{model}.friction_mean"] * found["pinion_gear.ohlendorf_loss_factor"]
        assert found[f"pinion_gear.{model}.loss"] == pytest.approx(expected, rel=1e-9)
    for model in ("xu_kahraman", "benedict_kelley"):
        expected = 20000 * found[f"pinion_gear.{model}.friction_mean"] * found["pinion_gear.loss_factor"]
        assert found[f"pinion_gear.{model}.loss"] == pytest.approx(expected, rel=1e-9)


def test_schlenk_and_niemann_differ_by_roughness_over_radius_only():
    """0.048·Ra^¼ against 0.045·2.2·(Ra/ρ)^¼."""
    c, P = pinion(power_of(3e5))
    one, two = r.of_schlenk(c, P, 0.1), r.of_niemann(c, P, 0.1)
    rho = c.path.at_pitch_point(c.motion.R) * 1e3
    assert two.friction_mean / one.friction_mean == pytest.approx(0.045 * 2.2 / 0.048 * rho**-0.25)


@pytest.mark.parametrize("base, factor", [("mineral", 1.0), ("PAO", 0.8), ("PAG", 0.7), ("ester", 1.0)])
def test_the_base_stock_lowers_the_friction(base, factor):
    def mean(of):
        own = Lubricant(replace(lubricant().oil, base=base))
        return of(case(friction(), r753()["idler_shaft"], oil_at(own, 80.0), 40.0), 5000.0, 0.13).friction_mean

    for of in (r.of_schlenk, r.of_niemann):
        mineral = of(
            case(
                friction(),
                r753()["idler_shaft"],
                oil_at(Lubricant(replace(lubricant().oil, base="mineral")), 80.0),
                40.0,
            ),
            5000.0,
            0.13,
        )
        assert mean(of) == pytest.approx(factor * mineral.friction_mean)


def test_the_tables_are_named_by_their_meshes():
    titles = [t.title for t in closed().tables if t.id.startswith("models_")]
    assert [title.split(":")[0] for title in titles] == ["Mesh crank–central", "Mesh central–idler", "Mesh idler–shaft"]
