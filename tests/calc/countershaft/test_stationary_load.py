"""What stands still: the shaft's weight and its gear's force, by hand."""

import math

import pytest

from calc.countershaft.supports import Gear, ShaftDrive, Sprocket, standing
from calc.design.toml_file import design
from calc.solve import solve
from tests.calc.countershaft.shafts import SEATED, result

FRONT, REAR = -0.1675, 0.1675
GEAR = Gear(
    diameter=0.054,
    tip_diameter=0.0587,
    face_width=0.015,
    normal_pressure_angle=math.radians(20),
    helix_angle=math.radians(21.916),
)
DRIVE = ShaftDrive(power=1400.0, speed=2600 / 60)

WEIGHT = 80.0, REAR - 45 / 80 * (REAR - FRONT)  # 45 N on the front bearing, 35 N on the rear one


def stands(weight=None, gear=GEAR, z_G=-0.18875, drive=DRIVE, reactions=(1710.0, 1710.0)):
    loads = dict(zip(("front", "rear"), reactions))
    return standing(loads, {"front": FRONT, "rear": REAR}, weight, gear, z_G, drive)


def test_tooth_force_by_hand():
    """1.4 kW at 2600 rpm: T = 5.1419 N·m, F_t = 2·T/54 mm = 190.44 N, F_r = F_t·tan 20°/cos 21.916°, F_a = F_t·tan
    21.916°."""
    r = stands()
    assert r.gear_torque == pytest.approx(5.1419, abs=5e-5)
    assert r.gear_force_tangential == pytest.approx(190.44, abs=5e-3)
    assert r.gear_force_radial == pytest.approx(74.714, abs=5e-3)
    assert r.gear_force_axial == pytest.approx(76.618, abs=5e-3)


def test_a_spur_wheel_over_a_bearing_loads_that_one_alone():
    """Helix 0 and z_G at the front bearing: R = F_t/cos α there, nothing at the rear."""
    r = stands(gear=GEAR._replace(helix_angle=0.0), z_G=FRONT)
    assert r.gear_force_axial == 0
    assert r.stationary["front"] == pytest.approx(r.gear_force_tangential / math.cos(math.radians(20)), rel=1e-12)
    assert r.stationary["rear"] == pytest.approx(0, abs=1e-12)


def test_an_overhung_spur_wheel_is_a_lever():
    """21.25 mm ahead of the front bearing: front F·(335 + 21.25)/335, rear F·21.25/335."""
    r = stands(gear=GEAR._replace(helix_angle=0.0))
    F = math.hypot(r.gear_force_tangential, r.gear_force_radial)
    assert r.stationary["front"] == pytest.approx(F * 356.25 / 335, rel=1e-12)
    assert r.stationary["rear"] == pytest.approx(F * 21.25 / 335, rel=1e-12)


def test_thrust_only_adds():
    spur, helical = stands(gear=GEAR._replace(helix_angle=1e-6)), stands()
    assert (
        helical.stationary["front"] > spur.stationary["front"] and helical.stationary["rear"] > spur.stationary["rear"]
    )
    C = helical.gear_force_axial * 0.027  # tilting couple of the thrust, in the radial plane
    front = math.hypot(helical.gear_force_tangential * 356.25, helical.gear_force_radial * 356.25 + C * 1e3) / 335
    assert helical.stationary["front"] == pytest.approx(front, rel=1e-9)


def test_the_largest_load_is_the_sum():
    r = stands(weight=WEIGHT, reactions=(1706.0, 1713.0))
    bare = stands()
    assert r.stationary["front"] == pytest.approx(45 + bare.stationary["front"]) and r.stationary[
        "rear"
    ] == pytest.approx(35 + bare.stationary["rear"])
    assert r.peaks["front"] == pytest.approx(1706 + r.stationary["front"])
    assert r.peaks["rear"] == pytest.approx(1713 + r.stationary["rear"])


def test_nothing_is_known_without_weight_and_drive():
    for gear, drive in ((GEAR, None), (None, DRIVE)):
        r = stands(gear=gear, drive=drive)
        assert r.gear_torque is None and r.stationary == r.peaks == {}
    alone = stands(weight=WEIGHT, gear=None)
    assert (
        alone.stationary == pytest.approx({"front": 45.0, "rear": 35.0}, rel=1e-12)
        and alone.gear_force_tangential is None
    )


def test_a_chain_pulls_with_both_strands():
    """1.4 kW on a sprocket of 60 mm, 50 N of tensioner: 2·5.1419/0.06 + 2·50 = 271.40 N, 21.25 mm ahead of the front
    bearing; beside a wheel what the teeth push comes to it."""
    chained = ShaftDrive(None, DRIVE.speed, ((Sprocket("chain", 0.06, 50.0), 1400.0),))
    alone, both = stands(gear=None, drive=chained), stands(drive=chained._replace(power=DRIVE.power))
    assert alone.chain_pull == pytest.approx(271.40, abs=5e-3) and alone.gear_torque is None
    pulled = {"front": 271.40 * 356.25 / 335, "rear": 271.40 * 21.25 / 335}
    assert alone.stationary == pytest.approx(pulled, rel=1e-4)
    for row, pushed in stands().stationary.items():
        assert both.stationary[row] == pytest.approx(pushed + pulled[row], rel=1e-4)


def test_the_weight_is_shared_by_the_lever():
    made = result(core_radius_mm=15.0, bearings=SEATED)  # no gear here
    assert made.standing is not None and made.standing.gear_torque is None
    assert made.standing.weights["rear"] / made.standing.weight == pytest.approx(
        (made.centre_of_gravity - FRONT) / 0.335, rel=1e-12
    )


def test_in_the_design(gamma):
    """Weight with g = 9.80665 m/s² on both bearings; a given power of 1.4 kW in place of the closed balance."""
    made = solve(design(gamma.with_value("gears.power_kW", 1.4))).outcomes["countershaft"].result
    r = made.standing
    assert r.weight == pytest.approx(9.80665 * made.mass) and r.weights["front"] + r.weights["rear"] == pytest.approx(
        r.weight
    )
    assert r.weights["rear"] * 0.335 == pytest.approx(r.weight * (made.centre_of_gravity - FRONT), rel=1e-12)
    assert r.gear_torque == pytest.approx(5.1419, abs=5e-5)
    d = 2e-3 * 25 / math.cos(math.radians(21.916))
    assert r.gear_force_tangential == pytest.approx(2 * r.gear_torque / d)
    assert r.peaks["front"] == pytest.approx(made.loads["front"] + r.stationary["front"])


def test_the_closed_balance_gives_what_the_last_mesh_passes_on(gamma_results):
    passed = list(gamma_results.outcomes["friction"].result.meshes.values())[-1].power_out
    r = gamma_results.outcomes["countershaft"].result.standing
    assert r.gear_torque == pytest.approx(passed / (2 * math.pi * 2600 / 60), rel=1e-9)
