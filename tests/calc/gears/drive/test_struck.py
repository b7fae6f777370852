# SPDX-License-Identifier: Apache-2.0
"""Whole designs: the safeties of the teeth under their strikes, and what a scissor gear costs, worked out beside."""

import math
from dataclasses import replace

import pytest

from calc.design.toml_file import design
from calc.friction.mesh.loss import losses
from calc.gears.drive.result import HARDEST, IDLE
from calc.library.lubricant import Lubricant
from calc.solve import solve
from tests.calc.gears.drive.conftest import changed
from tests.calc.gears.drive.test_strength import MESHES, by_the_standard

WHEEL = "shaft"


@pytest.mark.parametrize("key", MESHES)
def test_safeties_under_the_strikes_of_a_whole_design(over_speed, context, key):
    """ISO 6336 written out once more, with the forces that are published, at idle and where they are hardest."""
    drive, mesh = over_speed.train.drive, over_speed.train.meshes[key].over_speed
    rpm = {IDLE: drive.idle_speed * 60, HARDEST: drive.hardest_speed * 60}
    forces = {"low": "impact_force_low", "": "impact_force", "most": "impact_force_most"}
    for end, force in forces.items():
        least = min(by_the_standard(context, key, getattr(mesh.operations[op], force), n) for op, n in rpm.items())
        published = getattr(mesh, "_".join(filter(None, ("strike_safety_contact", end))))
        assert published == pytest.approx(least, rel=1e-9)


def test_the_weakest_root_of_a_wheel_is_that_of_its_hardest_mesh(over_speed):
    """Both wheels of the hardest mesh have the least safeties, and S_F falls as the force rises."""
    train = over_speed.train
    for wheel in train.wheels.values():
        struck = wheel.strikes
        assert struck.strike_safety_bending_most < struck.strike_safety_bending < struck.strike_safety_bending_low
        hardest = max(
            mesh.over_speed.operations[HARDEST].impact_force
            for mesh in train.meshes.values()
            if wheel.name in (mesh.driver, mesh.driven)
        )
        low = max(
            mesh.over_speed.operations[HARDEST].impact_force_low
            for mesh in train.meshes.values()
            if wheel.name in (mesh.driver, mesh.driven)
        )
        # the load factors fall as the load rises: S_F falls by less than the force rises
        assert low / hardest < struck.strike_safety_bending / struck.strike_safety_bending_low < 1.25 * low / hardest


def test_a_scissor_gear_in_a_whole_design(over_speed):
    """4.3 N·m in the last mesh: what is needed at idle, and the loss of both halves against that of the whole width."""
    results = solve(design(changed({"gears.meshes.2.scissor": {"torque_Nm": 4.3}})))
    before, mesh = over_speed.train.meshes["idler_shaft"], results.train.meshes["idler_shaft"]
    spring, wheel = mesh.over_speed.scissor, results.train.wheels[WHEEL]
    idle = before.over_speed.operations[IDLE]
    assert spring.needed == pytest.approx(-idle.least_force * wheel.base_diameter / 2, rel=1e-9)
    assert mesh.over_speed.operations[IDLE].impact_speed < idle.impact_speed  # its backlash is gone from the way
    d = results.design
    friction = results.outcomes["friction"].result
    link = friction.drive.links["idler_shaft"]
    oil = Lubricant(d.oils[d.bearings.oil], d.bearings.viscosity_law)

    def lost(P, b):
        both = {name: replace(getattr(link, name), face_width=b) for name in ("driver", "driven")}
        n = abs(results.train.wheels["idler"].speed)
        return float(losses(d.friction, replace(link, **both), oil, d.bearings.supply_temperature, n, P).loss[0])

    omega = 2 * math.pi * abs(wheel.speed)
    D = results.train.drive.survey.closed.drag[results.train.drive.at["rated"], 2]
    P, P_S, b = D * wheel.base_diameter / 2 * omega, 4.3 * omega, mesh.face_width
    beside = lost(P + P_S, 0.7 * b) + lost(P_S, 0.3 * b) - lost(P, b)
    assert spring.loss == pytest.approx(beside, rel=0.02)  # coarser along the path
