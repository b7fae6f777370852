# SPDX-License-Identifier: Apache-2.0
"""The window of the nominal backlash on whole designs: both ends worked out beside, by code of its own."""

import math
from dataclasses import replace

import numpy as np
import pytest

from calc.gears.drive.window import MayLeave, phase_by_couple, phase_by_force, windows
from calc.library.catalogue import materials
from tests.calc.gears.drive import event_solver as solver

NOTHING = MayLeave(None, None, None, None)


def inv(a):
    return math.tan(a) - a


def smallest_normal(gears, train, i):
    """Of one mesh in mm: tolerance and runout at 20 °C, and at all states of temperature."""
    m_n, beta, alpha_n = gears.normal_module * 1e3, gears.helix_angle, gears.pressure_angle
    alpha_t = math.atan(math.tan(alpha_n) / math.cos(beta))
    beta_b = math.asin(math.sin(beta) * math.cos(alpha_n))
    mesh, wheels, library = gears.meshes[i], {w.name: w for w in gears.wheels}, materials()
    pair = wheels[mesh.driver], wheels[mesh.driven]
    d = [m_n / math.cos(beta) * w.teeth for w in pair]
    d_b = [x * math.cos(alpha_t) for x in d]
    thickness = [
        db
        * (
            (math.pi / 2 + 2 * train.wheels[w.name].profile_shift * math.tan(alpha_n)) * m_n / math.cos(beta) / x
            + inv(alpha_t)
        )
        + w.span_allowance[0] * 1e3 / math.cos(beta_b)
        for w, x, db in zip(pair, d, d_b)
    ]
    F_r = [(0.24 * m_n + math.sqrt(x) + 5.6) * 2 ** ((gears.accuracy_grade - 5) / 2) * 1e-3 for x in d]
    a = train.meshes[mesh.key].centre_distance * 1e3 - (mesh.tolerance or 0.0) * 1e3 - sum(F_r) / 2
    of_wheels = [library[w.material].expansion for w in pair]
    of_housing = library[gears.housing_material].expansion
    of_housing += (mesh.support_share or 0.0) * (library[gears.support_material].expansion - of_housing)
    cold, warm = gears.lowest_temperature - 20, gears.running_temperature - 20
    p_bt, found = math.pi * d_b[0] / pair[0].teeth, []
    for T_h, T_w in ((0, 0), (cold, cold), (warm, warm), (warm, warm + gears.warmer), (cold, cold + gears.warmer)):
        eps = [e * T_w for e in of_wheels]
        d_b_T = [x * (1 + e) for x, e in zip(d_b, eps)]
        alpha_w = math.acos(sum(d_b_T) / 2 / (a * (1 + of_housing * T_h)))
        s = [x * (1 + e) for x, e in zip(thickness, eps)]
        found.append((p_bt * (1 + min(eps)) - sum(s) + sum(d_b_T) * inv(alpha_w)) * math.cos(beta_b))
    return min(found)


def test_lower_end_of_a_whole_design(over_speed):
    """What tolerance, runout and temperature take of the nominal backlash of each mesh, along the line of action."""
    gears, train = over_speed.design.gears, over_speed.train
    beta_b = math.asin(math.sin(gears.helix_angle) * math.cos(gears.pressure_angle))
    allowances = {
        w.name: sum(w.span_allowance) / 2 for w in gears.wheels
    }  # µm for µm, and nothing else leaves backlash
    low = 0.0
    for i, mesh in enumerate(gears.meshes):
        nominal = -(allowances[mesh.driver] + allowances[mesh.driven]) * 1e3
        low += (nominal - smallest_normal(gears, train, i)) / math.cos(beta_b)
    window = over_speed.values()["gears.drive.window_low"]
    assert window.unit == "µm" and window.shown == pytest.approx(low * 1e3, rel=2e-5)
    assert window.shown == pytest.approx(232, abs=0.5)


def test_upper_end_of_a_whole_design(over_speed):
    """At the quiet backlash the last body strikes as fast as its grade allows, event by event; what the tolerances
    widen is taken off."""
    drive, values = over_speed.train.drive, over_speed.values()
    p, motion = drive.at["idle"], drive.survey.motion
    waves = solver.Driver(motion.orders * motion.omega[p], motion.a[p], motion.period / motion.omega[p])
    g = drive.survey.closed.drag[p, 2] / drive.survey.closed.mass[2]
    quiet = [values[f"gears.drive.backlash_quiet_{grade}"].shown for grade in "ab"]
    for J, u in zip(quiet, (35e-3, 70e-3)):
        strikes, _, _ = solver.orbit(waves, g, J * 1e-6)
        assert max(abs(strike.speed) for strike in strikes) == pytest.approx(u, rel=1e-4)
    assert quiet == pytest.approx([47.5, 198], rel=0.01)  # as stated with another drag of the journals
    plays = [sum(drive.drive.line.play[corner]) * 1e6 for corner in ("nominal", "most")]
    assert plays == pytest.approx([130, 264], abs=0.5)
    assert values["gears.drive.window_high"].shown == pytest.approx(quiet[1] - (plays[1] - plays[0]), rel=1e-9)
    check = over_speed.check("gears.drive.backlash_window")
    assert check.verdict == "warn" and not check.cause  # shut by far, it would stand before the rattle and its remedies
    assert "crank–central–idler–shaft, from above rattle" in check.name and "shut by 166 µm" in check.to_do
    assert (check.value, check.limit) == (
        values["gears.drive.window_low"].shown,
        values["gears.drive.window_high"].shown,
    )


def test_a_phase_error_rules_the_upper_end(over_speed):
    train, drive = over_speed.train, over_speed.train.drive
    r_b = drive.drive.line.radius[2]
    (way,) = windows(train, drive, {"shaft": NOTHING})
    assert not way.by_phase
    (way,) = windows(train, drive, {"shaft": MayLeave(500.0, 0.5, 0.0, 30.0)})
    assert way.by_phase and 2 * 500.0 * math.sin(way.high / r_b / 2) == pytest.approx(0.5, rel=1e-9)
    (way,) = windows(train, drive, {"shaft": MayLeave(500.0, 0.5, 400.0, 0.2)})
    assert 2 * 400.0 * math.sin(way.high / r_b / 2) == pytest.approx(0.2, rel=1e-9)
    assert phase_by_couple(r_b, 500.0, 0.5) == phase_by_force(r_b, 500.0, 0.5)
    (way,) = windows(train, drive, {"shaft": MayLeave(500.0, 1001.0, None, None)})  # all of it may be left
    assert not way.by_phase


def test_no_window_where_nothing_strikes(over_speed):
    drive = over_speed.train.drive
    strikes = replace(drive.survey.strikes, orbit=np.zeros_like(drive.survey.strikes.orbit))
    assert windows(over_speed.train, replace(drive, survey=replace(drive.survey, strikes=strikes)), {}) == []
    at = {word: p for word, p in drive.at.items() if word != "idle"}
    assert windows(over_speed.train, replace(drive, at=at), {}) == []
