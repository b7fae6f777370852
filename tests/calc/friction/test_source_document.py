# SPDX-License-Identifier: Apache-2.0
"""designs/friction_source.md: every number in it, recomputed."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from calc.design_file import design, read
from calc.friction.mesh import film as films
from calc.friction.mesh import traction as t
from calc.friction.mesh.loss import case, solve_mesh
from calc.friction.mesh.path import array, line_load, transverse_force
from calc.solve import solve

from .pairs import friction, oil, spur_pair

DESIGNS = Path(__file__).parents[3] / "designs"
TEXT = (DESIGNS / "friction_source.md").read_text(encoding="utf-8")
ROWS = {
    cells[0]: cells[1:]
    for line in TEXT.splitlines()
    if line.startswith("| ")
    for cells in [[c.strip() for c in line.strip("|").split("|")]]
}
OIL = "friction thesis 10W40"


def scenario(file, name):
    found = solve(design(read(DESIGNS / f"thesis_{file}.toml"))).outcomes["friction"].result.scenarios[name]
    return found.meshes["crank_pump"]


def shown(x):
    """Four digits, as the document writes them."""
    return f"{x:#.4g}".rstrip(".")


@pytest.mark.parametrize(("row", "file", "name"), [
    ("10W-40", "temperatures", "40-C"), ("10W-40, 50 °C", "temperatures", "50-C"), ("10W-40, 60 °C", "temperatures", "60-C"),
    ("0W-30", "oils", "0W-30"), ("10W-40 synthetic", "oils", "10W-40-synthetic"), ("MIL-L-23699E", "oils", "MIL-L-23699E"),
    ("10W-40, tips relieved", "tip_relief", "tips-relieved"),
])  # fmt: skip
def test_the_scenarios(row, file, name):
    mesh = scenario(file, name)
    judged, source = mesh.judged, mesh.source
    numbers = (source.sliding_loss, judged.sliding_loss, judged.rolling_loss, source.local.h[0] * 1e6, judged.local.h[0] * 1e6)
    assert ROWS[row] == [shown(x) for x in numbers]


def test_the_command_and_its_designs_are_there():
    for name in ("temperatures", "oils", "tip_relief"):
        assert f"thesis_{name}.toml" in TEXT


def light(T=40.0, P=100.0, by_regime=False, **change):
    """The pair at 1500 rpm with the thesis' 10W-40."""
    c = case(friction(), spur_pair(), replace(oil(OIL, T), **change), 25.0)
    return c, solve_mesh(c, P, by_regime)


def test_what_holds():
    linear, smooth = scenario("tip_relief", "as-generated"), scenario("tip_relief", "tips-relieved")
    assert f"from {shown(linear.source.loss_factor)} to {shown(smooth.source.loss_factor)}" in TEXT
    falls = [1 - one.sliding_loss / two.sliding_loss for one, two in ((smooth.source, linear.source), (smooth.judged, linear.judged))]
    assert "by {:.0f} % (source) or {:.0f} % (judged)".format(*(100 * x for x in falls)) in TEXT
    assert f"{linear.source.efficiency * 100:.2f} % at 100 W" in TEXT
    assert f"no less than {linear.judged.efficiency * 100:.2f} %" in TEXT
    for P, at in ((5000.0, "5 kW"), (10000.0, "10 kW")):
        one, two = light(P=P)[1].loss, light(P=P, by_regime=True)[1].loss
        assert one == pytest.approx(two, rel=1e-12)
        assert f"{shown(one)} W at {at}" in TEXT


def test_the_argument_falls_with_the_temperature():
    arguments, shares = [], []
    for T in (40.0, 50.0, 60.0):
        c, found = light(T)
        local, lubricant = found.local, c.oil.lubricant
        eta_f = lubricant.at(float(local.T_f[0])).mu
        alpha_f = lubricant.alpha(eta_f)
        p_m, V_s = np.pi / 4 * local.p_H[0], c.path.in_the_middle(c.motion.V_s)[0]
        arguments.append(t.viscosity_under_pressure(eta_f, alpha_f, p_m) * V_s / (t.eyring_stress(c.oil.Lambda, alpha_f) * local.h[0]))
        shares.append(local.xi[0])
    assert arguments == sorted(arguments, reverse=True)
    assert "{}, {} and\n  {} at 40, 50 and 60 °C".format(*map(shown, arguments)) in TEXT
    assert f"from {shown(shares[0])} to {shown(shares[2])}" in TEXT


def test_the_regime_at_100_w():
    c, found = light(by_regime=True)
    w, _ = line_load(c.mesh, c.path, transverse_force(P=100.0, omega_1=c.motion.omega_1, r_b1=c.mesh.driver.base_radius))
    w_C, R, u_e = (c.path.at_pitch_point(x) for x in (w, c.motion.R, c.motion.u_e))
    W, U = films.load_parameter(w=w_C, E_r=c.motion.E_r, R=R), films.speed_parameter(eta_0=c.oil.eta_0, u_e=u_e, E_r=c.motion.E_r, R=R)
    G = films.materials_parameter(alpha=c.oil.alpha, E_r=c.motion.E_r)
    assert f"g_V = {shown(films.viscosity_group(W=W, G=G, U=U))} and g_E = {shown(films.elasticity_group(W=W, U=U))}" in TEXT
    assert f"{shown(found.film_min * 1e6)} µm thick" in TEXT
    assert f"rolling, {shown(found.rolling_loss)} W at most against {shown(found.sliding_loss)} W" in " ".join(TEXT.split())
    best, worst = scenario("oils", "10W-40").judged.loss, scenario("oils", "MIL-L-23699E").judged.loss
    assert f"{shown(best)} W against {shown(worst)} W" in TEXT


@pytest.mark.parametrize(("formula", "row"), [
    (lambda eta_0, beta, u_e, k_f: eta_0 * beta * (2 * u_e) ** 2 / k_f, "Gupta's thermal loading with the sum of the speeds"),
    (lambda eta_0, beta, u_e, k_f: eta_0 * beta * u_e / k_f, "the same, speed not squared"),
])  # fmt: skip
def test_the_thermal_loading_as_printed(monkeypatch, formula, row):
    monkeypatch.setattr(films.thermal_loading, "function", formula)
    assert ROWS[row][1] == shown(light()[1].loss)


def test_the_other_misprints():
    c, right = light()
    assert f"the right one is {shown(right.loss)}" in TEXT
    row = next(row for row in ROWS if row.startswith("eq. 26"))
    assert ROWS[row][1] == shown(solve_mesh(c, 100.0, False, films.ELLIPTICAL).loss)
    state = c.oil.lubricant.at(40.0)
    kinematic = films.oil_at(c.oil.lubricant, 40.0, None, (state.nu * 1e6 / (state.mu * 1e3)) ** 0.1348)
    row = next(row for row in ROWS if row.startswith("eq. 41"))
    assert ROWS[row][1] == shown(solve_mesh(replace(c, oil=kinematic), 100.0, False).loss)
    share = np.asarray(c.path.carried)
    less = replace(c, path=replace(c.path, carried=array(np.where(share < 1, 0.99 * share, share))))
    found = solve_mesh(less, 100.0, False)
    row = next(row for row in ROWS if row.startswith("0.33"))
    assert f"(loss factor {shown(found.loss_factor)})" in row
    assert ROWS[row][1] == shown(found.loss)
    assert f"{shown(state.mu * 1e3)}." in TEXT
