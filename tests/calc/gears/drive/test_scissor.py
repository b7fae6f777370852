# SPDX-License-Identifier: Apache-2.0
"""A scissor gear: what its spring must hold, where it opens, what both halves carry, and what it costs."""

import json
import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from calc.design.toml_file import design
from calc.friction.mesh.loss import losses
from calc.friction.power_balance import drive
from calc.friction.solve import links_of
from calc.gears.drive.scissor import (
    ScissorCase,
    needed_torque,
    opening_speed,
    scissor,
    scissor_checks,
)
from calc.gears.drive.scissor_inputs import Scissor
from calc.gears.drive.spring import split_wheel, spring_torque, sprung
from calc.gears.drive.strength import held
from calc.library.lubricant import Lubricant
from calc.sheet.errors import NoSolution
from calc.sheet.expression import show
from calc.sheet.quantity import keys
from calc.sheet.units import UNITS
from calc.sheet.value import trace
from calc.solve import solve
from tests.calc.gears.drive.conftest import changed

REFERENCE = json.loads((Path(__file__).parents[3] / "reference" / "drive.json").read_text(encoding="utf-8"))["given"]
ROWS = {row["id"].rpartition(".")[2]: row for row in REFERENCE if ".scissor." in row["id"]}
LEAST = next(r["is"] for r in REFERENCE if (r["case"], r["id"]) == ("R753 idle", "gears.mesh_3.least_force"))
DEGREE = math.pi / 180
KEY = "idler_shaft"


def test_the_torque_that_is_needed_and_the_least_of_the_spring():
    row = ROWS["needed"]
    r_b = row["given"]["base_radius_mm"] / 1e3
    assert needed_torque(F=LEAST, r_b=r_b) == pytest.approx(row["is"], rel=row["rel"])
    row = ROWS["torque_least"]
    given = row["given"]
    c_S, j = given["spring_Nm_deg"] / DEGREE, given["backlash_max_um"] / 1e6
    T_S = spring_torque(T=given["torque_Nm"], c_S=c_S, j=j, r_b=r_b)
    assert T_S == pytest.approx(row["is"], rel=row["rel"])


def test_the_keys_and_the_unit_of_the_rate():
    assert set(keys(Scissor)) == {"torque_Nm", "stiffness_Nm_deg", "face_width_mm", "to_rpm", "wheel"}
    rate = UNITS["N·m/°"].inside(1.5)
    assert rate * 10 * DEGREE == pytest.approx(15.0)  # what ten degrees take


def test_a_spring_that_backlash_turns_slack_holds_nothing():
    given = Scissor(torque=0.5, stiffness=10 / DEGREE)
    assert spring_torque(T=given.torque, c_S=given.stiffness, j=1e-3, r_b=25e-3) == 0.0
    assert needed_torque(F=5.0, r_b=25e-3) == 0.0
    assert sprung(given, 1e-3, 25e-3, np.array([[5.0, -5.0]])).tolist() == [[True, False]]


def test_where_it_opens():
    """Forces fall in a straight line: it opens where they reach that of the spring."""
    n, F = np.array([15.0, 20.0, 30.0, 40.0]), np.array([50.0, 0.0, -100.0, -200.0])
    assert opening_speed(n=n, F=F, F_S=150.0) == pytest.approx(35.0)
    assert opening_speed(n=n, F=F, F_S=-60.0) == 15.0
    at = np.interp(opening_speed(n=n, F=F, F_S=70.0), n, F)
    assert at == pytest.approx(-70.0)


def a_case(context, **more):
    """Least forces of the R753 by speed, of three loads; the first at idle."""
    speeds = np.linspace(900, 2600, 12) / 60
    forces = LEAST * np.linspace(1.0, 2.2, 12)[:, None] * np.array([1.0, 0.9, 0.8])
    return ScissorCase(122e-6, speeds[0], LEAST, speeds, forces, **more)


def test_a_spring_in_its_mesh(context):
    given, case = Scissor(torque=4.0, stiffness=1.5 / DEGREE), a_case(context, most=170.0)
    spring = scissor(given, context, KEY, case)
    r_b = context.train.wheels["shaft"].base_diameter / 2
    assert spring.needed == pytest.approx(ROWS["needed"]["is"], rel=1e-3)
    assert spring.torque_least == pytest.approx(ROWS["torque_least"]["is"], rel=1e-4)
    assert (spring.wheel, spring.to) == ("shaft", pytest.approx(1.5 * case.idle_speed))
    share = 1 + 1.2 * (1.5 * 900 - 900) / 1700
    assert spring.needed_range == pytest.approx(-LEAST * share * r_b)
    assert np.interp(spring.opens_at, case.speeds, case.forces[:, 0]) * r_b == pytest.approx(-spring.torque_least)
    assert spring.width == pytest.approx(0.3 * 15e-3) and spring.loss is None
    main, half = held(context, KEY, 170 + 4.0 / r_b, "shaft", 10.5e-3), held(context, KEY, 4.0 / r_b, "shaft", 4.5e-3)
    assert spring.main_safety_contact == pytest.approx(main.contact)
    assert spring.sprung_safety_contact == pytest.approx(half.contact)
    assert spring.main_safety_bending == pytest.approx(min(main.bending.values()))
    strong = scissor(replace(given, torque=50.0), context, KEY, case)
    assert strong.opens_at is None and strong.sprung_safety_contact < spring.sprung_safety_contact


def test_every_line_of_it_can_be_shown(context):
    with trace() as lines:
        spring = scissor(Scissor(torque=4.0), context, KEY, a_case(context, most=170.0))
    shown = {line.symbol: line for line in map(show, lines)}
    assert shown["n_o"].unit == "rpm" and float(shown["n_o"].value) == pytest.approx(spring.opens_at * 60, rel=1e-3)
    assert {"T_S", "T_S,min", "F_S", "F_M", "b_S", "n_S", "S_H", "S_F"} <= shown.keys()


def test_the_driver_may_be_split(context):
    given = Scissor(torque=4.0, wheel="idler")
    assert (
        split_wheel(given, "idler", "shaft") == "idler"
        and split_wheel(Scissor(torque=4.0), "idler", "shaft") == "shaft"
    )
    spring = scissor(given, context, KEY, a_case(context))
    assert spring.needed == pytest.approx(-LEAST * context.train.wheels["idler"].base_diameter / 2)
    assert spring.main_safety_contact is None


@pytest.mark.parametrize("width", [15e-3, 20e-3])
def test_a_sprung_half_as_wide_as_the_mesh_is_refused(context, width):
    with pytest.raises(NoSolution, match="less than the 15 mm"):
        scissor(Scissor(torque=4.0, face_width=width), context, KEY, a_case(context))


def test_what_it_costs_on_the_r753(context, gamma_results):
    """4.3 N·m at rated speed: both halves pass its power in a circle.  By hand, with the loss factor of 0.16 and the mean
    coefficient of friction of 0.038 of the mesh without it, some 14 W; under the load of the spring the film carries
    less, and its coefficient is 0.053 to 0.054."""
    design, friction = gamma_results.design, gamma_results.outcomes["friction"].result
    links = links_of(design.gears, gamma_results.train, design.materials)
    oil = Lubricant(design.oils[design.bearings.oil], design.bearings.viscosity_law)
    T, wheel, P = design.bearings.supply_temperature, context.train.wheels["shaft"], friction.meshes[KEY].power_in
    d = drive(design.friction, links, oil, T, 2600 / 60)
    flanks = math.pi * wheel.base_diameter * abs(wheel.speed)
    case = a_case(context, steady=P / flanks, lost=lambda P, b: d.loss_on(KEY, P, b))
    spring = scissor(Scissor(torque=4.3), context, KEY, case)
    of_spring = 4.3 * 2 * math.pi * abs(wheel.speed)
    assert 2 * of_spring * 0.16 * 0.038 == pytest.approx(14, abs=0.5)
    assert spring.loss == pytest.approx(2 * of_spring * 0.155 * 0.0535, rel=0.1)

    def lost(P, b):
        both = (replace(wheel, face_width=b) for wheel in (links[KEY].driver, links[KEY].driven))
        part = replace(links[KEY], **dict(zip(("driver", "driven"), both)))
        return float(losses(design.friction, part, oil, T, abs(context.train.wheels["idler"].speed), P).loss[0])

    assert d.loss_on(KEY, P, 15e-3) == pytest.approx(friction.meshes[KEY].judged.loss, rel=1e-9)
    apart = lost(P + of_spring, 10.5e-3) + lost(of_spring, 4.5e-3) - lost(P, 15e-3)
    assert spring.loss == pytest.approx(apart, rel=0.02)  # coarser along the path


# --- checks


def kept(spring, **other):
    checks = scissor_checks(KEY, "idler–shaft", 2, replace(spring, **other))
    return {check.id.rpartition(".")[2]: check.holds for check in checks}


def test_just_inside_and_just_outside(context):
    spring = scissor(Scissor(torque=4.0), context, KEY, a_case(context))
    least, more = spring.torque_least, spring.torque_least * 1.001
    assert kept(spring, needed=least, needed_range=least) == {"scissor": True, "scissor_range": True}
    assert kept(spring, needed=more, needed_range=least) == {"scissor": False, "scissor_range": True}
    assert kept(spring, needed=least, needed_range=more) == {"scissor": True, "scissor_range": False}
    at_idle, over_range = scissor_checks(KEY, "idler–shaft", 2, replace(spring, needed=more, needed_range=more))
    assert (at_idle.verdict, over_range.verdict) == ("fail", "warn")
    assert at_idle.moved_by[0] == "gears.meshes.2.scissor.torque_Nm"
    nothing = scissor_checks(KEY, "idler–shaft", 2, replace(spring, needed=0.0, needed_range=0.0))
    assert [check.margin for check in nothing] == pytest.approx([1.0, 1.0])  # a share of the spring's own torque


def test_what_it_costs_is_said_to_be_outside_the_sum_of_losses(over_speed):
    id, total = f"gears.{KEY}.scissor.loss", "friction.total_loss"
    results = solve(design(changed({"gears.meshes.2.scissor": {"torque_Nm": 5.5}})))
    loss, notes = results.values()[id].shown, [str(note) for note in results.outcomes["gears"].notes]
    assert any(f"cost up to {loss:.0f} W in their meshes" in note for note in notes)
    assert results.values()[total].shown == pytest.approx(over_speed.values()[total].shown, rel=1e-9)
    assert not any("springs of scissor gears" in str(note) for note in over_speed.outcomes["gears"].notes)
