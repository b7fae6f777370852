# SPDX-License-Identifier: Apache-2.0
"""The drive over speed in what is done with whole designs: sweeps, comparisons, the search for a drive, the choice of
shifts."""

import math
from types import SimpleNamespace

import pytest

from calc.design.toml_file import design
from calc.gears.selection.rattle import RattleOfRows
from calc.gears.selection.states import states
from calc.gears.train import settle, tooth_system
from calc.solve import solve
from calc.studies.compare import compare
from calc.studies.compare_tables import sentences
from calc.studies.drive.problem import Problem
from calc.studies.explain import chain
from calc.studies.sweep import sweep, varied
from tests.calc.gears.drive.conftest import changed


def speeds(document, key, numbers):
    """The hardest strike at idle of each design of a sweep, mm/s."""
    found = sweep(document, varied(document, [f"{key}={numbers}"]), wanted=["gears.drive.impact_speed"])
    return [row[found.header.index("gears.drive.impact_speed [mm/s]")] for row in found.rows]


@pytest.mark.slow
def test_sweep_over_flywheel_and_centre_distance(over_speed, light):
    """A lighter flywheel strikes harder; centres farther apart strike harder where the shifts are given."""
    u = speeds(changed({}), "engine.flywheel_inertia_kgm2", "0.3,0.9")
    alone = [r.values()["gears.drive.impact_speed"].shown for r in (light[1], over_speed)]
    assert u == pytest.approx(alone, rel=1e-9)
    wide = {f"gears.wheels.{name}.profile_shift": 0.0 for name in ("crank", "central", "shaft")}
    wide = changed(wide | {"gears.wheels.idler.profile_shift": -0.18})
    near, far = speeds(wide, "gears.meshes.idler_shaft.centre_distance_mm", "68.698,68.798")
    assert far > 1.05 * near


@pytest.mark.parametrize(
    "id",
    [
        "idler_shaft.idle.separation",
        "idler_shaft.idle.least_force",
        "idler_shaft.reversal_to",
        "idler_shaft.least_torque",
        "drive.backlash_quiet_b",
    ],
)
def test_what_the_motion_does_rests_on_flywheel_and_idle_speed(over_speed, id):
    keys = {key for link in chain(over_speed, f"gears.{id}") for key in link.inputs}
    assert {"engine.flywheel_inertia_kgm2", "engine.idle_speed_rpm"} <= keys


def test_a_measured_drag_stands_in_place_of_the_bearings():
    rows = [{"wheel": "shaft", "speed_rpm": 900.0, "torque_Nm": 0.3}]
    results = solve(design(changed({"gears.drive.drag": rows})))
    keys = {key for link in chain(results, "gears.idler_shaft.idle.separation") for key in link.inputs}
    assert "gears.drive.drag.0.torque_Nm" in keys and not any(key.startswith("bearings") for key in keys)


def test_compare_says_the_tendency_of_one_engine_alone(over_speed, light):
    document, lighter = light
    a, b = changed({}), document
    found = compare(a.data, b.data, over_speed, lighter)
    forces = [
        max(r.values()[f"gears.{mesh}.idle.impact_force"].shown for mesh in r.train.meshes)
        for r in (over_speed, lighter)
    ]
    assert found.strikes == pytest.approx(forces)
    said = next(text for text in sentences(found, ("a", "b"), str) if "Rattle at idle" in text)
    assert f"{20 * math.log10(forces[1] / forces[0]):+.1f} dB" in said and "no sound level" in said
    back = compare(b.data, a.data, lighter, over_speed)
    assert back.strikes == (found.strikes[1], found.strikes[0])


def test_compare_says_nothing_of_another_engine(over_speed, gamma_results):
    """Nor of one whose irregularity is assumed."""
    data = changed({}).data
    assert compare(data, data, over_speed, gamma_results).strikes is None
    none = [text for text in sentences(compare(data, data, over_speed, over_speed), ("a", "b"), str) if "dB" in text]
    assert len(none) == 1 and "+0.0 dB" in none[0]


def test_a_drive_whose_teeth_strike_too_hard_is_broken(light):
    """The search over whole drives confirms a row by the checks of its whole solution, the strikes among them."""
    binds = SimpleNamespace(binds=lambda id: False)
    broken = {check.id for check in Problem.broken(binds, light[1].checks())}
    assert {"gears.shaft.strike_bending", "gears.idler_shaft.strike_contact"} <= broken


def test_rows_of_shifts_with_their_grade(over_speed, light):
    """As the design is the row strikes as its drive does; what rattles as C is passed over, and said."""
    gears = over_speed.design.gears
    system = tooth_system(gears)
    row = SimpleNamespace(freedom=None, cuts={}, states=states(system, gears, settle(gears, system).shifts))
    for results, cell in ((over_speed, "B 58"), (light[1], "C 98")):
        rattle = RattleOfRows(gears, results.train)
        assert rattle.known and rattle.speed(row) == pytest.approx(results.train.drive.impact_speed, rel=1e-6)
        assert rattle.cell(row) == cell
        assert ("passed over here: 1." in rattle.note([("1", row)])) is (cell[0] == "C")
    unknown = RattleOfRows(gears, None)
    assert not unknown.known and unknown.speed(row) is None and not unknown.cell(row)
