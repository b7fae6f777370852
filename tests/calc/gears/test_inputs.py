# SPDX-License-Identifier: Apache-2.0
"""What is refused before anything is computed: place, value and what is allowed."""

from pathlib import Path

import pytest

from calc.design.toml_file import design, read
from calc.gears.inputs import Wall
from calc.sheet.errors import BadInput

GAMMA = read(Path(__file__).parents[3] / "designs" / "r753ie4_gamma.toml")

WRONG = [
    ({"gears.wheels.crank.hand": "right", "gears.wheels.idler.hand": "left"}, "wheels.2.hand", "must be right"),
    ({"gears.wheels.crank.hand": "right", "gears.wheels.central.hand": "right"}, "wheels.1.hand", "hands of a train "
                                                                                                  "alternate"),
    ({"gears.wheels.crank.gear_material": "16MnCr5"}, "wheels.0.gear_material", "choose"),
    ({"gears.wheels.crank.gear_material": "ADI"}, "wheels.0.gear_material", "austempered"),
    ({"gears.wheels.crank.gear_material": "case hardened"}, "wheels.0.gear_material", "case-hardened"),
    ({"gears.wheels.crank.measured_span_mm": 21.5}, "measured_span_mm", "needs span_teeth"),
    ({"gears.ball_diameter_mm": None, "gears.wheels.crank.measured_over_balls_mm": 58.8}, "measured_over_balls_mm",
    "needs gears.ball_diameter_mm"),
    ({"gears.support_material": None}, "support_share", "needs gears.support_material"),
    ({"gears.support_material": "cheese"}, "gears.support_material", "not known"),
    ({"gears.wheels.crank.tip_diameter_tolerance_um": [-100, 0]}, "tip_diameter_tolerance_um", "upper, lower"),
    ({"gears.iso_6336_edition": 2010}, "iso_6336_edition", "2006 or 2019"),
    ({"gears.meshes.1.contributors_mm": [0.1], "gears.meshes.1.tolerance_um": None}, "stack", "either contributors_mm "
                                                                                              "or stack"),
    ({"gears.meshes.2.scissor.torque_Nm": 4.0, "gears.meshes.2.scissor.wheel": "central"}, "2.scissor.wheel",
     'must be "idler" or "shaft"'),
    ({"gears.meshes.2.scissor.torque_Nm": 4.0, "gears.meshes.2.scissor.face_width_mm": 15.0}, "2.scissor.face_width_mm",
     "below the 15 mm of the mesh"),
]  # fmt: skip


@pytest.mark.parametrize("changes, place, words", WRONG)
def test_what_can_not_be_asked_is_refused_with_its_place(changes, place, words):
    document = GAMMA
    for key, value in changes.items():
        document = document.with_value(key, value)
    with pytest.raises(BadInput) as raised:
        design(document)
    assert any(place in error.key and words in error.reason for error in raised.value.errors), raised.value.errors


def test_hands_that_alternate_are_taken():
    document = GAMMA.with_value("gears.wheels.crank.hand", "left").with_value("gears.wheels.idler.hand", "left")
    assert design(document).gears.wheels[0].hand == "left"


def test_a_wall_needs_a_length():
    assert [key for key, _ in Wall(name="cover", from_=(0.01, 0.02), to=(0.01, 0.02)).problems()] == ["to_mm"]
    assert not list(Wall(name="cover", from_=(0.01, 0.02), to=(0.01, 0.03)).problems())
