# SPDX-License-Identifier: Apache-2.0
"""designs/friction_source.md: every number in it, recomputed."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from calc.design.toml_file import design, read
from calc.friction.mesh import film as films
from calc.friction.mesh import traction as t
from calc.friction.mesh.geometry import MeshGeometry
from calc.friction.mesh.loss import case, solve_mesh
from calc.friction.mesh.path import line_load, transverse_force
from calc.solve import solve
from calc.studies.published import caveat
from tests.calc.friction.models import test_measured_gears as measured
from tests.calc.friction.pairs import friction, oil, spur_pair, wheel

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
    return found.meshes["crank_camshaft"]


def shown(x):
    """Four digits, as the document writes them."""
    return f"{x:#.4g}".rstrip(".")


@pytest.mark.parametrize(
    ("row", "file", "name"),
    [
        *(
            (f"{oil}, {T} °C", "temperatures", f"{oil.replace(' ', '-')}-{T}-C")
            for oil in ("10W-40", "0W-30", "10W-40 synthetic", "MIL-L-23699E")
            for T in (40, 50, 60)
        ),
        ("10W-40, 40 °C, tips relieved", "tip_relief", "tips-relieved"),
    ],
)
def test_the_scenarios(row, file, name):
    mesh = scenario(file, name)
    judged, source = mesh.judged, mesh.source
    numbers = (
        source.sliding_loss,
        judged.sliding_loss,
        judged.rolling_loss,
        source.local.h[0] * 1e6,
        judged.local.h[0] * 1e6,
    )
    assert ROWS[row] == [shown(x) for x in numbers]


def test_the_command_and_its_designs_are_there():
    for name in ("temperatures", "oils", "tip_relief"):
        assert f"thesis_{name}.toml" in TEXT


def light(T=40.0, P=100.0, by_regime=False, **change):
    """The pair at 1500 rpm with the thesis' 10W-40."""
    c = case(friction(), spur_pair(), replace(oil(OIL, T), **change), 25.0)
    return c, solve_mesh(c, P, by_regime)


def test_tip_relief_and_efficiency():
    linear, smooth = scenario("tip_relief", "as-generated"), scenario("tip_relief", "tips-relieved")
    assert f"from {shown(linear.source.loss_factor)} to {shown(smooth.source.loss_factor)}" in TEXT
    falls = [
        1 - one.sliding_loss / two.sliding_loss
        for one, two in ((smooth.source, linear.source), (smooth.judged, linear.judged))
    ]
    assert "by {:.0f} %\n  (source) or {:.0f} % (judged)".format(*(100 * x for x in falls)) in TEXT
    assert f"{linear.source.efficiency * 100:.2f} % at 100 W" in TEXT
    assert f"no less than {linear.judged.efficiency * 100:.2f} %" in TEXT


def test_the_friction_of_touching_flanks():
    for P, said in ((5000.0, "loses {} W, the judged one {} W"), (10000.0, "{} W and {} W")):
        one, two = light(P=P)[1], light(P=P, by_regime=True)[1]
        assert one.film_min == pytest.approx(two.film_min, rel=1e-12)
        assert said.format(shown(one.loss), shown(two.loss)) in TEXT


def test_what_the_thesis_says_of_its_curves():
    c, found = light()
    local, marks = found.local, c.path.marks
    h, x, q = np.asarray(local.h) * 1e6, np.asarray(local.x), np.asarray(local.q) * 1e-3
    before, after = (h[(x > a) & (x < b)] for a, b in ((marks[0], marks[1]), (marks[3], marks[4])))
    assert np.all(np.diff(before) > 0) and np.all(np.diff(after) > 0)
    assert f"from {shown(h[0])} µm at A to {shown(h[-1])} µm at E" in TEXT
    alone = h[(x > marks[1] + 1e-9) & (x < marks[3] - 1e-9)]
    assert f"from\n  {shown(before[-1])} to {shown(alone[0])} µm" in TEXT
    assert f"{shown(q[0])} W/mm are lost at A and {shown(q[-1])} W/mm at E" in TEXT
    judged = np.asarray(light(by_regime=True)[1].local.h)
    first, last = (judged[(x > a) & (x < b)] for a, b in ((marks[0], marks[1]), (marks[3], marks[4])))
    assert np.all(np.diff(first) < 0) and np.all(np.diff(last) > 0)


def test_temperature_moves_film_and_friction_only():
    cold, hot = (scenario("temperatures", f"10W-40-{T}-C").source.local for T in (40, 60))
    for name in ("V_s", "w", "b_H"):
        assert np.array_equal(getattr(cold, name), getattr(hot, name))
    assert np.all(np.asarray(hot.h) < cold.h)


def test_the_best_oil():
    for T in (40, 50, 60):
        losses = {
            name: scenario("oils", f"{name}-{T}-C").source.loss
            for name in ("10W-40", "0W-30", "10W-40-synthetic", "MIL-L-23699E")
        }
        assert min(losses, key=losses.get) == "10W-40" and max(losses, key=losses.get) == "MIL-L-23699E"


@pytest.mark.parametrize(
    "name, row",
    [
        ("C14", "C14, mineral VG 320, 75 °C"),
        ("C40", "C40, PAO VG 320, 80 °C"),
        ("H701", "H701, PAO VG 320, 80 °C"),
        ("H951", "H951, mineral VG 320, 75 °C"),
    ],
)
def test_beside_measured_gears(name, row):
    point, (c, P) = measured.POINTS[name], measured.at(name)
    ours = (measured.friction_of(c, P, by_regime) for by_regime in (False, True))
    assert ROWS[row] == [f"{x:.4f}" for x in (point["fit"], point["fit_mended"], point["schlenk"], *ours)]


def test_beside_the_fit_elsewhere_and_schlenk():
    off = np.array(
        [
            measured.friction_of(c, P) / measured.fit(c, P, base, measured.FEUP["gold"])
            for base, c, P in measured.held_out()
        ]
    )
    assert f"at {off.size} other points" in TEXT and f"at {np.mean(abs(off - 1) <= 0.25) * 100:.0f} % of them" in TEXT
    assert f"{100 - 100 * np.exp(np.mean(np.log(off))):.0f} % below on average" in TEXT
    assert f"{100 - 100 * off.min():.0f} % below FEUP's fit" in TEXT


def stages(beyond):
    """Load stages from 5 on, as the document names them; those that are beyond lie side by side."""
    found = [5 + int(i) for i in np.flatnonzero(beyond)]
    assert found == list(range(found[0], found[-1] + 1)) if found else True
    return "none" if not found else f"{found[0]}" if len(found) == 1 else f"{found[0]} to {found[-1]}"


def test_beside_schlenk():
    for name, own in measured.OILS.items():
        off, base = measured.all_beside_schlenk(own), own.oil.base
        for X_L in (measured.LUBRICANT_FACTOR[base], measured.FEUP["lubricant_factor"][base]):
            met = measured.within(off / X_L, 0.25)
            assert ROWS[f"{name}, {X_L:g}"] == [
                f"{met.sum()} of {met.size}",
                f"{(off / X_L).min():.2f} to {(off / X_L).max():.2f}",
            ]
    X_L = measured.FEUP["lubricant_factor"]["mineral"]
    for T, rpm, Ra in measured.SCHLENK_AT:
        lam, off = measured.beside_schlenk(measured.OILS["FVA 3"], T, rpm, Ra)
        cells = [f"{x.min():.2f} to {x.max():.2f}" for x in (lam, off, off / X_L)]
        assert ROWS[f"{T:g} °C, {rpm / 60 * np.pi * 73.2e-3:.1f} m/s, Ra {Ra} µm"] == [*cells, stages(off < 0.75)]
    test = [measured.beside_schlenk(measured.OILS["FVA 3"], 90.0, 2170.0, Ra, 20e-3, 6)[1] for Ra in (0.3, 0.5)]
    assert f"{100 - 100 * np.max(test):.0f} to {100 - 100 * np.min(test):.0f} % below" in TEXT


# --- what the literature says
def spur(alpha=20.0, split=1):
    """16/24 teeth of 4.5 mm without shifts, or the same size with teeth split in two."""
    m, angle = 4.5e-3 / split, np.radians(alpha)
    wheels = (wheel(f"w{z}", z * split, m, angle, m * z * split / 2 + m, 20e-3) for z in (16, 24))
    return MeshGeometry(*wheels, 90e-3, 0.0)


def trial(by_regime, mesh=None, Ra=0.4, rpm=2160.0, torque=183.4):
    c = case(friction(flank_roughness=(Ra * 1e-6,)), mesh or spur(), oil("FVA 3 (ref mineral)", 90.0), rpm / 60)
    return solve_mesh(c, torque * 2 * np.pi * rpm / 60, by_regime)


@pytest.mark.parametrize(
    "said, one, two, name",
    [
        ("smaller module", {}, {"mesh": spur(split=2)}, "loss"),
        ("larger pressure angle", {}, {"mesh": spur(alpha=25.0)}, "loss"),
        ("finer flanks", {"Ra": 0.8}, {"Ra": 0.2}, "loss"),
        ("more speed", {"rpm": 540.0}, {"rpm": 4320.0}, "friction_mean"),
        ("more load", {"torque": 94.1}, {"torque": 302.0}, "friction_mean"),
        ("friction independent", {"Ra": 0.5}, {"Ra": 3.0}, "friction_mean"),
        ("friction proportional", {"Ra": 0.5}, {"Ra": 3.0}, "friction_mean"),
    ],
)
def test_the_trends(said, one, two, name):
    row = next(row for row in ROWS if row.startswith(said))
    unit = " W" if name == "loss" else ""
    digits = (lambda x: f"{x:.1f}") if name == "loss" else shown
    for cell, by_regime in zip(ROWS[row][1:3], (True, False)):
        before, after = (getattr(trial(by_regime, **kw), name) for kw in (one, two))
        assert cell == f"{digits(before)} to {digits(after)}{unit}"
        if "more load" in row or said.startswith("friction"):
            assert after > before
        else:
            assert after < before
    if said == "friction proportional":
        before, after = (trial(True, **kw).friction_mean for kw in (one, two))
        assert f"Ra^{np.log(after / before) / np.log(6):.2f}" in ROWS[row][3]


def test_the_argument_falls_with_the_temperature():
    arguments, shares = [], []
    for T in (40.0, 50.0, 60.0):
        c, found = light(T)
        local, lubricant = found.local, c.oil.lubricant
        eta_f = lubricant.at(float(local.T_f[0])).mu
        alpha_f = lubricant.alpha(eta_f)
        p_m, V_s = np.pi / 4 * local.p_H[0], c.path.in_the_middle(c.motion.V_s)[0]
        arguments.append(
            t.viscosity_under_pressure(eta_f, alpha_f, p_m)
            * V_s
            / (t.eyring_stress(c.oil.Lambda, alpha_f) * local.h[0])
        )
        shares.append(local.xi[0])
    assert arguments == sorted(arguments, reverse=True)
    assert "{}, {} and\n  {} at 40, 50 and 60 °C".format(*map(shown, arguments)) in TEXT
    assert f"from {shown(shares[0])} to {shown(shares[2])}" in TEXT


def test_the_regime_at_100_w():
    c, found = light(by_regime=True)
    w, _ = line_load(
        c.mesh, c.path, transverse_force(P=100.0, omega_1=c.motion.omega_1, r_b1=c.mesh.driver.base_radius)
    )
    w_C, R, u_e = (c.path.at_pitch_point(x) for x in (w, c.motion.R, c.motion.u_e))
    W, U = (
        films.load_parameter(w=w_C, E_r=c.motion.E_r, R=R),
        films.speed_parameter(eta_0=c.oil.eta_0, u_e=u_e, E_r=c.motion.E_r, R=R),
    )
    G = films.materials_parameter(alpha=c.oil.alpha, E_r=c.motion.E_r)
    assert (
        f"g_V = {shown(films.viscosity_group(W=W, G=G, U=U))} and g_E = {shown(films.elasticity_group(W=W, U=U))}"
        in TEXT
    )
    assert f"{shown(found.film_min * 1e6)} µm thick" in TEXT
    assert f"rolling, {shown(found.rolling_loss)} W at most against {shown(found.sliding_loss)} W" in " ".join(
        TEXT.split()
    )
    best, worst = scenario("oils", "10W-40-40-C").judged.loss, scenario("oils", "MIL-L-23699E-40-C").judged.loss
    assert f"{shown(best)} W against {shown(worst)} W" in TEXT


def test_its_errors_stand_in_the_one_list_under_the_same_caveat():
    assert caveat() in TEXT
    assert f"ν·ρ gives {shown(oil(OIL, 40.0).lubricant.at(40.0).mu * 1e3)}." in TEXT
