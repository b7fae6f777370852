# SPDX-License-Identifier: Apache-2.0
"""Each check of the drive just inside its limit and just outside it, known and with an irregularity that is assumed."""

from dataclasses import replace
from functools import cache

import pytest

from calc.gears.drive.checks import grade_letter, grade_limits, grade_of, method_checks, rattle_checks, strength_checks
from calc.gears.drive.result import IDLE, MeshOverSpeed, WheelStruck
from calc.sheet.deferred import Later
from calc.sheet.text import Text
from tests.calc.gears.drive.at_work import driven, on_shaft

KEY = "idler_shaft"
LITTLE = 1e-6
TAKEN = Text("an irregularity")


def no_remedies(*_):
    return Later(tuple)


@cache
def drive(assumed=False):
    return replace(driven(on_shaft(6e-3)).solution, assumed=assumed)


def by_name(checks):
    return {check.id.rpartition(".")[2]: check for check in checks}


def of_rattle(nominal, most, assumed=False):
    at = replace(drive().meshes[KEY].operations[IDLE], impact_speed=nominal, impact_speed_most=most)
    known = {KEY: "idler–shaft"}, TAKEN, {KEY: 2}
    return by_name(rattle_checks(drive(assumed), {KEY: at}, *known, Later(tuple), Later(tuple)))


def of_strength(assumed=False, **said):
    mesh = {name: S for name, S in said.items() if "contact" in name}
    wheel = {name: S for name, S in said.items() if "bending" in name}
    meshes = {KEY: MeshOverSpeed(operations={}, order=25.0, **mesh)}
    known = {KEY: "idler–shaft"}, TAKEN, {KEY: 2}
    return by_name(strength_checks(drive(assumed), meshes, {"shaft": WheelStruck(**wheel)}, *known, no_remedies))


def test_the_grades():
    A, B = grade_limits()
    assert (A, B) == pytest.approx((35e-3, 70e-3))
    assert [grade_of(u) for u in (0.0, A, A * 1.001, B, B * 1.001)] == [1, 1, 2, 2, 3]
    assert [grade_letter(grade) for grade in (1, 2.0, 3)] == ["A", "B", "C"]


A_B = grade_limits()
# check, how it is made of a number, its limit, on which side of it is inside, what it is outside
EACH = [
    ("rattle", lambda x, **said: of_rattle(x, x, **said), A_B[1], -1, "warn"),
    ("rattle_most", lambda x, **said: of_rattle(0.0, x, **said), A_B[1], -1, "note"),
    ("rattle_most", lambda x, **said: of_rattle(x, 0.0, **said), A_B[0], -1, "note"),
    ("strike_contact", lambda x, **said: of_strength(strike_safety_contact_low=x, **said), 1.0, 1, "fail"),
    ("strike_contact_most", lambda x, **said: of_strength(strike_safety_contact_most=x, **said), 1.0, 1, "warn"),
    ("strike_bending", lambda x, **said: of_strength(strike_safety_bending_low=x, **said), 1.4, 1, "fail"),
    ("strike_bending_most", lambda x, **said: of_strength(strike_safety_bending_most=x, **said), 1.4, 1, "warn"),
]


@pytest.mark.parametrize("name, made_of, limit, side, outside", EACH)
def test_each_check(name, made_of, limit, side, outside):
    within, beyond = (made_of(limit * (1 + sign * LITTLE))[name] for sign in (side, -side))
    assert (within.holds, beyond.holds, beyond.verdict) == (True, False, outside)
    assert within.missing == beyond.missing == ()


@pytest.mark.parametrize("name, made_of, limit, side, outside", [of for of in EACH if of[0] != "rattle_most"])
def test_a_default_fails_nothing(name, made_of, limit, side, outside):
    """What holds with it passes, and says what is assumed; what does not is not verified."""
    within, beyond = (made_of(limit * (1 + sign * 0.1), assumed=True)[name] for sign in (side, -side))
    assert within.verdict == "pass" and beyond.verdict == "not_verified"
    for check in (within, beyond):
        assert check.missing == ("engine.gas", "engine.flywheel_inertia_kgm2")


def of_method(share=0.5, delta=0.1, assumed=False):
    of = drive(assumed)
    at = replace(of.operations[IDLE], irregularity=delta)
    return by_name(method_checks(replace(of, operations={IDLE: at}), {KEY: share}))


@pytest.mark.parametrize("name, said, limit", [("irregularity_high", "delta", 0.15), ("rebound", "share", 1.0)])
def test_how_far_the_method_holds(name, said, limit):
    within, beyond = (of_method(**{said: limit * (1 + sign * LITTLE)})[name] for sign in (-1, 1))
    assert (within.verdict, beyond.verdict) == ("pass", "note")


def test_a_default_is_said():
    assert (of_method()["assumed"].verdict, of_method(assumed=True)["assumed"].verdict) == ("pass", "note")


def test_what_is_not_known_is_not_judged():
    assert of_strength() == {}
    of = replace(drive(), operations={})
    assert by_name(method_checks(of, {})).keys() == {"assumed"}
