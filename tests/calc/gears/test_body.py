# SPDX-License-Identifier: Apache-2.0
"""The mass of each wheel, and what a drive weighs with them."""

import math

import pytest

from calc.countershaft.result import CountershaftResult
from calc.design.toml_file import design, read
from calc.gears.result import TrainResult
from calc.solve import solve
from calc.studies.drive.solved_drive import mass
from tests.conftest import DESIGNS

SIZED = read(DESIGNS / "r753ie4_sized.toml")


def wheels(document):
    results = solve(design(document))
    return results, results.result(TrainResult).wheels


def test_a_wheel_is_a_disc_of_its_reference_diameter():
    """The last one weighs what the shaft has of it, whose outline holds the same disc."""
    results, all_ = wheels(SIZED)
    shaft = results.result(CountershaftResult)
    (piece,) = (p for p in shaft.outline.pieces if p.what == "gear")
    rho = design(SIZED).materials["20CrNi4"].density
    # "steel" is as dense, nearly
    assert all_["shaft"].mass == pytest.approx(rho * math.pi * piece.outer_radius**2 * piece.length, rel=2e-3)
    assert all_["idler"].mass / all_["crank"].mass == pytest.approx((39 / 25) ** 2, rel=1e-9)
    assert results.values()["gears.idler.mass"].unit == "kg"


def test_a_bore_and_a_rim_take_from_it_and_a_face_width_goes_with_it():
    plain = wheels(SIZED)[1]["idler"].mass
    bored = wheels(SIZED.with_value("gears.wheels.idler.bore_diameter_mm", 30.0))[1]["idler"]
    d = bored.reference_diameter
    assert bored.mass == pytest.approx(plain * (1 - (0.03 / d) ** 2), rel=1e-12)
    rimmed = wheels(SIZED.with_value("gears.wheels.idler.rim_thickness_mm", 10.0))[1]["idler"]
    assert rimmed.mass == pytest.approx(plain * (1 - ((rimmed.root_diameter - 0.02) / d) ** 2), rel=1e-12)
    assert wheels(SIZED.with_value("gears.face_width_mm", 30.0))[1]["idler"].mass == pytest.approx(2 * plain, rel=1e-12)


def test_a_drive_weighs_its_shaft_and_the_other_wheels():
    results, all_ = wheels(SIZED)
    others = sum(all_[name].mass for name in ("crank", "central", "idler"))
    assert mass(results) == pytest.approx(results.result(CountershaftResult).mass + others, rel=1e-12)
    alone = solve(design(SIZED.with_value("gears", None).with_value("friction", None)))
    assert mass(alone) == pytest.approx(alone.result(CountershaftResult).mass, rel=1e-12)
