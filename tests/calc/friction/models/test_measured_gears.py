# SPDX-License-Identifier: Apache-2.0
"""The friction that is judged beside measured gears: FEUP's fit to FZG tests, at the four points of its reports and
where it was not looked at, Schlenk's on the load stages of ISO 14635-1, with both lubricant factors; and that the
friction source's model stands where it stood."""

import itertools
import math
from dataclasses import replace

import numpy as np
import pytest

from calc.friction import models as regressions
from calc.friction.mesh.film import oil_at
from calc.friction.mesh.geometry import MeshGeometry
from calc.friction.mesh.loss import case, solve_mesh
from calc.friction.mesh.mixed import BOUNDARY, LOAD_SHARES, PUBLISHED
from calc.library.catalogue import oils
from calc.library.contact import LUBRICANT_FACTOR
from calc.library.lubricant import Lubricant
from tests.calc.friction.pairs import closed, friction, fzg, reference, wheel

MEASURED = reference("friction_measured.toml")
FEUP = MEASURED["feup"]
POINTS = {point["name"]: point for point in FEUP["point"]}
STAGES = reference("friction_vectors.toml")["iso_14635"]["torque_Nm"]


def gears(name):
    """A pair of FEUP at 91.5 mm."""
    g = FEUP["gears"][name]
    m_n, beta, alpha_n = g["normal_module"] * 1e-3, math.radians(g["helix_angle"]), math.radians(20)
    m_t, alpha_t = m_n / math.cos(beta), math.atan(math.tan(alpha_n) / math.cos(beta))
    one, two = (
        wheel(f"w{z}", z, m_t, alpha_t, r_a * 1e-3, g["face_width"] * 1e-3)
        for z, r_a in zip(g["teeth"], g["tip_radii"])
    )
    return MeshGeometry(one, two, 91.5e-3, math.asin(math.sin(beta) * math.cos(alpha_n)) if beta else 0.0)


def lubricant(base):
    """An oil of FEUP's library by its own viscosities at 40 and 100 °C."""
    law = FEUP["oils"][base]
    nu40, nu100 = ((10**10 ** (law["m"] - law["n"] * math.log10(T + 273.15)) - 0.7) * 1e-6 for T in (40.0, 100.0))
    plain = replace(
        oils()["FVA 3 (ref mineral)"], name=base, base=base, limiting_shear=None, pressure_viscosity_40=None, printed=()
    )
    return Lubricant(replace(plain, nu40=nu40, nu100=nu100, rho15=law["rho15"]), "d341")


def operating(mesh, base, T, rpm, torque, Ra, **said):
    c = case(friction(flank_roughness=tuple(x * 1e-6 for x in Ra), **said), mesh, oil_at(lubricant(base), T), rpm / 60)
    return c, torque * 2 * math.pi * rpm / 60


def at(name, **said):
    p = POINTS[name]
    return operating(gears(name), p["oil"], p["temperature"], p["speed_rpm"], p["torque"], p["roughness"], **said)


def fit(c, P, base, constants):
    """FEUP's formula, with α by the constants s and t."""
    state, p, mesh = c.oil.lubricant.at(c.oil.T_m), c.path, c.mesh
    s, t = constants[base]
    alpha = s * (state.nu * 1e6) ** t * 1e-9
    F_bn = P / (c.motion.omega_1 * mesh.driver.base_radius * math.cos(mesh.base_helix_angle))
    length = mesh.face_width if mesh.spur else float(np.min(p.carried))
    rho_C = p.C_C * (p.C_F - p.C_C) / p.C_F / math.cos(mesh.base_helix_angle)
    S_p = 2 * p.at_pitch_point(c.motion.u_e) * state.mu * math.sqrt(alpha / F_bn)
    return FEUP["factor"] * (c.Ra / math.sqrt(length * rho_C) / S_p) ** 0.25 * FEUP["lubricant_factor"][base]


def friction_of(c, P, by_regime=True):
    return float(solve_mesh(c, P, by_regime).friction_mean)


# --- what was measured
@pytest.mark.parametrize("name", POINTS)
def test_the_fit_is_theirs_with_their_digits_and_another_with_gold_s(name):
    """Their program exchanges the digits of s and t; with them its printed numbers come out, so nothing else
    differs."""
    p, (c, P) = POINTS[name], at(name)
    assert fit(c, P, p["oil"], FEUP["printed"]) == pytest.approx(p["fit"], abs=1.5e-4)
    assert fit(c, P, p["oil"], FEUP["gold"]) == pytest.approx(p["fit_mended"], abs=1e-4)


@pytest.mark.parametrize("base, T", [("mineral", 75.0), ("PAO", 80.0)])
def test_the_exchange_of_digits(base, T):
    s, t = FEUP["printed"][base]
    assert s * (lubricant(base).at(T).nu * 1e6) ** t == pytest.approx(FEUP["printed_alpha_GPa"][base], rel=2e-3)
    s, t = FEUP["gold"][base]
    own = lubricant(base)
    # and the program's own α
    assert s * (own.at(T).nu * 1e6) ** t == pytest.approx(own.alpha(own.at(T).mu) * 1e9, rel=0.03)
    assert FEUP["printed"]["mineral"] == pytest.approx(
        [10 * FEUP["gold"]["mineral"][1], FEUP["gold"]["mineral"][0] / 10]
    )


# --- the four points
@pytest.mark.parametrize("name", POINTS)
@pytest.mark.parametrize("which, rel", [("fit", 0.20), ("fit_mended", 0.21)])
def test_what_is_judged_meets_measured_gears(name, which, rel):
    assert friction_of(*at(name)) == pytest.approx(POINTS[name][which], rel=rel)


@pytest.mark.parametrize("name", POINTS)
def test_the_source_s_law_is_twice_too_much(name):
    """1 − erf λ and 0.135, as it was: 1.9 to 2.9 times what was measured."""
    over = friction_of(*at(name), by_regime=False) / POINTS[name]["fit"]
    assert 1.9 < over < 2.9


def test_the_source_s_law_has_not_moved():
    """Recorded before another law was judged."""
    found = [friction_of(*at(name), by_regime=False) for name in POINTS]
    was = [0.08623100246644866, 0.04872190319089981, 0.08293020348851404, 0.07405990916135845]
    assert found == pytest.approx(was, rel=1e-13)


# --- held out: nothing was chosen by these
def held_out():
    for name, Ra in (("C40", (0.4, 0.31)), ("H501", (0.6, 0.6)), ("H701", (0.6, 0.6))):
        mesh = gears(name)
        for base in FEUP["oils"]:
            for torque in (99.0, 139.0, 215.0):
                for rpm in (300.0, 600.0, 1800.0):
                    yield base, *operating(mesh, base, 80.0, rpm, torque, Ra)


def test_the_fit_to_their_tests_elsewhere():
    """Three gears, both oils, loads and speeds of FEUP's tests at 80 °C: λ from 0.17 to 1.05."""
    off = np.array([friction_of(c, P) / fit(c, P, base, FEUP["gold"]) for base, c, P in held_out()])
    assert 0.85 < np.exp(np.mean(np.log(off))) < 1.15
    assert np.mean(abs(off - 1) <= 0.25) >= 0.9
    assert off.min() > 0.65 and off.max() < 1.2


SCHLENK_AT = [(T, rpm, Ra) for T in (60.0, 80.0, 90.0, 120.0) for rpm in (542.0, 2170.0, 4350.0) for Ra in (0.3, 0.5)]
OILS = {"FVA 3": Lubricant(oils()["FVA 3 (ref mineral)"]), "M320": lubricant("mineral"), "P320": lubricant("PAO")}


def beside_schlenk(own, T, rpm, Ra, b=14e-3, first=5, change=lambda surfaces: surfaces, **said):
    """FZG C gears on load stages `first` to 12 of ISO 14635-1: the mean λ, and the friction over Schlenk's with a
    lubricant factor of 1."""
    c = case(friction(flank_roughness=(Ra * 1e-6,), **said), fzg(b), oil_at(own, T), rpm / 60, points=12)
    P = np.array(STAGES[first - 1 :]) * 2 * math.pi * rpm / 60
    schlenk = regressions.of_schlenk(c, P, 0.195)
    assert not schlenk.outside
    found = solve_mesh(replace(c, surfaces=change(c.surfaces)), P, True)
    return found.local.lam.mean(axis=-1), found.friction_mean / schlenk.friction_mean * LUBRICANT_FACTOR[own.oil.base]


def all_beside_schlenk(own, **said):
    return np.concatenate([beside_schlenk(own, *at, **said)[1] for at in SCHLENK_AT])


def within(off, rel):
    return abs(off - 1) <= rel


def test_fzg_gears_beside_schlenk():
    """With the factor that FEUP's tests gave a mineral oil, the one of its printed 0.0483 and 0.0415: every point, and
    A/8.3/90."""
    X_L = FEUP["lubricant_factor"]["mineral"]
    assert within(all_beside_schlenk(OILS["FVA 3"]) / X_L, 0.25).all()
    for Ra in (0.3, 0.4, 0.5):
        assert within(beside_schlenk(OILS["FVA 3"], 90.0, 2170.0, Ra, 20e-3, 6)[1] / X_L, 0.25).all()


def test_no_model_meets_both_at_c14():
    """20 % above the fit as printed ends where 25 % below Schlenk with a lubricant factor of 1 has not begun."""
    p, (c, P) = POINTS["C14"], at("C14")
    schlenk = regressions.of_schlenk(c, P, 0.195)
    assert (
        schlenk.friction_mean * FEUP["lubricant_factor"]["mineral"] == pytest.approx(p["schlenk"], rel=0.005)
        and not schlenk.outside
    )
    assert 1.2 * p["fit"] < 0.75 * schlenk.friction_mean


PUBLISHED_CHOICES = list(
    itertools.product(
        LOAD_SHARES, (0.05, 0.06, 0.07, 0.08, 0.09, 0.1), (1.0, 1.25), (True, False), ("oil", "estimated")
    )
)


@pytest.mark.slow
def test_no_published_choice_does_better():
    """Load share, friction of the peaks, roughness as Ra or rms, the film under its own pressure or the whole, teeth as
    warm as the oil or warmer: of those that meet the four gears, only what is judged meets Schlenk everywhere with
    FEUP's factor, and none with 1."""
    met, best = {}, 0.0
    for law, mu_s, rms, relieved, bulk in PUBLISHED_CHOICES:

        def change(s, law=law, mu_s=mu_s, rms=rms, relieved=relieved):
            return replace(s, load_share=law, mu_s=mu_s, sigma=s.sigma * rms, Ra=s.Ra * rms, relieved=relieved)

        four = []
        for name, p in POINTS.items():
            c, P = at(name, bulk=bulk)
            four.append(friction_of(replace(c, surfaces=change(c.surfaces)), P) / p["fit"])
        if within(np.array(four), 0.2).all():
            off = all_beside_schlenk(OILS["FVA 3"], change=change, bulk=bulk)
            met[law, mu_s, rms, relieved, bulk] = within(off / FEUP["lubricant_factor"]["mineral"], 0.25).all()
            best = max(best, within(off, 0.25).mean())
    assert [choice for choice, all_of_them in met.items() if all_of_them] == [("zhu-hu", BOUNDARY, 1.0, True, "oil")]
    assert len(met) == 57 and best < 0.75


# --- the ends
def thick(**said):
    """Smooth flanks, cold oil: λ above 4 all along the path."""
    return case(
        friction(flank_roughness=(0.05e-6,), **said),
        fzg(20e-3),
        oil_at(Lubricant(oils()["FVA 3 (ref mineral)"]), 60.0),
        36.0,
    ), 40e3


def test_a_thick_film_rubs_as_oil_alone():
    c, P = thick()
    found = solve_mesh(c, P, True)
    assert found.lambda_min > 4
    assert friction_of(c, P) == pytest.approx(friction_of(*thick(solid_friction=0.0)), rel=1e-12)


def test_without_a_film_the_peaks_rub():
    c, P = thick(solid_friction=0.08)
    rough = replace(c, surfaces=replace(c.surfaces, sigma=1e-2, Ra=1e-2))
    assert friction_of(rough, P) == pytest.approx(0.08, rel=0.01)


@pytest.mark.parametrize("law", LOAD_SHARES)
def test_every_law_falls_with_the_film(law):
    lam = np.linspace(0.1, 4.0, 400)
    xi = np.asarray(LOAD_SHARES[law].solid(lam, 1.0, 1.0))
    assert np.all(np.diff(xi) <= 1e-12) and xi.min() >= 0 and xi.max() <= 1
    assert np.asarray(LOAD_SHARES[law].solid(np.array([1e-6]), 1.0, 1.0))[0] == pytest.approx(1.0, abs=0.03)
    assert np.asarray(LOAD_SHARES[law].solid(np.array([1e3]), 1.0, 1.0))[0] == pytest.approx(0.0, abs=1e-5)


def test_the_friction_of_the_peaks_is_a_published_one():
    said = {key: row["is"] for key, row in MEASURED["boundary"].items()}
    lubricated = [said[key] for key in ("arana_measured", "arana_proposed", "robbe_valloire", "feup_code", "gearpie")]
    assert BOUNDARY == said["robbe_valloire"] == sorted(lubricated)[2]  # their median
    assert PUBLISHED == (min(lubricated), max(lubricated))


# --- the check that compares
def comparison(power, **said):
    found = closed(
        shaft_power=None,
        power=power,
        speed=36.0,
        T=90.0,
        oil="FVA 3 (ref mineral)",
        meshes={"pinion_gear": fzg(20e-3)},
        **said,
    )
    mesh = found.result.meshes["pinion_gear"]
    return mesh, next((c for c in found.checks if c.id == "friction.pinion_gear.models"), None)


@pytest.mark.parametrize("said", [{}, {"film": "source"}, {"solid_friction": 0.03}])
def test_a_check_compares_with_the_models_inside_their_range(said):
    mesh, check = comparison(41e3, flank_roughness=(0.4e-6,), **said)
    inside = [one.loss for one in mesh.published_models.values() if one is not None and not one.outside]
    assert len(inside) >= 3
    assert check.value == pytest.approx(
        max(max(P / mesh.judged.sliding_loss, mesh.judged.sliding_loss / P) for P in inside)
    )
    assert check.kind == "caution" and check.verdict == ("warn" if check.value > 1.3 else "pass")


def test_where_no_model_is_inside_nothing_is_compared():
    mesh, check = comparison(20.0, flank_roughness=(0.4e-6,))
    assert check is None and mesh.published_models["schlenk"].outside
