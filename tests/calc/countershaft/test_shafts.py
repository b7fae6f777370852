"""Twins, and the step of several shafts by their names."""

import cmath
import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from calc.countershaft.inputs import EccentricMass
from calc.countershaft.result import CountershaftResult
from calc.countershaft.shafts import (
    HELD_ALONE,
    ShaftsResult,
    TwinResult,
    inertia_at_crank,
    mass_of_all,
    of_twin,
    told,
    whole,
)
from calc.countershaft.sums import SystemResult
from calc.countershaft.twins import Resolved
from calc.design.toml_file import design
from calc.imbalance.remedies import roll_torque
from calc.sheet.quantity import published
from calc.sheet.step import Outcome
from calc.sheet.text import Text
from tests.calc.countershaft.shafts import FRONT, REAR, SEATED, document, outcome

SCATTER = {"mass_g": 10, "radius_mm": 0.05, "angle_deg": 0.1, "z_mm": 0.1, "shafts": 200}
# with a force and a couple of unlike directions, so that neither its conjugate nor its opposite is itself
LOPSIDED = [{**FRONT, "mass_kg": 3.0}, {**REAR, "angle_deg": 50.0}]


@pytest.fixture(scope="module")
def original() -> CountershaftResult:
    shape = {"outer_radius_mm": 43.0, "core_radius_mm": 15.0, "bearings": SEATED}
    made = outcome(masses=LOPSIDED, axis_mm=[30.0, 80.0], scatter=SCATTER, **shape)
    assert made.state == "solved", made.reason
    return made.result


def twin(how: str, axis: tuple[float, float] | None = (0.03, -0.08)) -> Resolved:
    (shaft,) = design(document(masses=LOPSIDED)).shafts
    return Resolved("image", replace(shaft, name="image", axis=axis), how, "shaft")


def test_a_mirror_image_has_the_conjugate_vectors(original):
    image = of_twin(original, twin("mirrors"))
    assert image.force_vector == original.force_vector.conjugate() != original.force_vector
    assert image.couple_vector == original.couple_vector.conjugate()
    assert image.couple_phase == pytest.approx(-original.couple_phase)
    assert image.reactions == tuple(R.conjugate() for R in original.reactions)
    assert image.load_phases == {row: pytest.approx(-phase) for row, phase in original.load_phases.items()}
    assert (image.force, image.couple, image.loads, image.slopes) == (
        original.force,
        original.couple,
        original.loads,
        original.slopes,
    )
    assert image.outline is original.outline and image.mass == original.mass


def test_its_masses_stand_at_the_other_side_and_at_the_same_place(original):
    """At −γ, not at γ + 180°: what they supply at the twin's speed is what it is said to."""
    image = of_twin(original, twin("mirrors"))
    assert [mass.angle for mass in image.masses] == [-mass.angle for mass in original.masses]
    assert [mass.z for mass in image.masses] == [mass.z for mass in original.masses]

    def supplied(masses: tuple[EccentricMass, ...]) -> complex:
        return sum(m.mass * m.radius * cmath.exp(1j * m.angle) for m in masses)

    assert supplied(image.masses) == pytest.approx(supplied(original.masses).conjugate())
    assert original.omega**2 * supplied(image.masses) == pytest.approx(image.force_vector)
    target, mirrored = original.scatter.target, image.scatter.target
    assert (mirrored.couple, mirrored.force) == (target.couple.conjugate(), target.force.conjugate())


def test_a_repeated_shaft_has_the_same_vectors(original):
    again = of_twin(original, twin("repeats"))
    for name in ("force_vector", "couple_vector", "reactions", "masses", "scatter"):
        assert getattr(again, name) is getattr(original, name), name
    assert again.couple_phase == original.couple_phase


@pytest.mark.parametrize("how", ["mirrors", "repeats"])
def test_its_roll_is_about_its_own_axis(original, how):
    F = original.force_vector
    assert of_twin(original, twin(how)).roll_torque == pytest.approx(math.hypot(0.03, 0.08) * abs(F))
    assert of_twin(original, twin(how, (0.2, 0.0))).roll_torque == pytest.approx(0.2 * abs(F))
    assert original.roll_torque == pytest.approx(roll_torque(p=0.03 + 0.08j, F=F))
    assert of_twin(original, twin(how, None)).roll_torque is None


def test_a_twin_tells_what_is_not_its_originals(original):
    given = told(replace(of_twin(original, twin("mirrors")), standing=None))
    mine = {value.id for value in published(given, "countershaft")}
    told_of_it = ["couple", "couple_phase", "force", "roll_torque", "reaction_front_phase", "reaction_rear_phase"]
    told_of_it += ["centre_of_gravity_up", "centre_of_gravity_side"]
    told_of_it += [f"inertia.{name}" for name in ("xx", "yy", "zz", "xy", "yz", "zx")]
    assert mine == {f"countershaft.{name}" for name in told_of_it}
    of_original = {value.id: value for value in published(original, "countershaft")}
    for value in published(given, "countershaft"):
        assert (value.label, value.unit) == (of_original[value.id].label, of_original[value.id].unit)


# --- all of them

SUMS = Outcome("countershaft", result=SystemResult(residual={}, vectors={}))
NONE = Outcome[CountershaftResult]("countershaft", "no_solution", reason=Text("too small"))


def test_one_shaft_has_its_sums_beside_it(original):
    alone = whole({"shaft": Outcome("countershaft", result=original)}, {}, {"shaft": -1.0}, SUMS, named=False)
    assert isinstance(alone.result, CountershaftResult) and alone.result.sums is SUMS.result
    assert whole({"shaft": NONE}, {}, {"shaft": -1.0}, Outcome("countershaft", "blocked"), named=False).reason == (
        "too small"
    )


def test_several_are_told_by_their_names(original):
    image = Outcome("countershaft", result=of_twin(original, twin("mirrors")))
    one = {"left": Outcome("countershaft", result=original)}
    ratios = {"left": 2.0, "image": -2.0}
    every = whole(one, {"image": image}, ratios, SUMS, named=True).result
    assert isinstance(every, ShaftsResult) and every.sums is SUMS.result
    assert every.shafts["left"] is original and isinstance(every.shafts["image"], TwinResult)
    assert every.shaft_mass == pytest.approx(2 * original.mass)
    assert every.moment_of_inertia_at_crank == pytest.approx(8 * original.moment_of_inertia)
    # of one whose mass nobody knows, nor that of all
    bare = Outcome("countershaft", result=replace(original, mass=None, moment_of_inertia=None))
    some = whole(one | {"right": bare}, {}, ratios | {"right": -1.0}, SUMS, named=True).result
    assert some.shaft_mass is None and some.moment_of_inertia_at_crank is None


def test_bolts_that_hold_one_of_several_are_said_to_do_so(original):
    bolted = Outcome("countershaft", result=replace(original, bolts=SimpleNamespace(carries=None)))
    image = {"image": Outcome("countershaft", result=of_twin(bolted.result, twin("mirrors")))}
    named = Outcome("countershaft", result=replace(original, bolts=SimpleNamespace(carries=("left", "image"))))
    ratios = {"left": 2.0, "image": -2.0}
    assert HELD_ALONE in whole({"left": bolted}, image, ratios, SUMS, named=True).notes
    assert HELD_ALONE not in whole({"left": bolted}, {}, ratios, SUMS, named=True).notes
    both = {"image": Outcome("countershaft", result=of_twin(named.result, twin("mirrors")))}
    assert HELD_ALONE not in whole({"left": named}, both, ratios, SUMS, named=True).notes
    bare = {"image": Outcome("countershaft", result=of_twin(original, twin("mirrors")))}
    assert (
        HELD_ALONE
        not in whole({"left": Outcome("countershaft", result=original)}, bare, ratios, SUMS, named=True).notes
    )


def test_one_without_a_solution_leaves_no_result_of_all(original):
    one = {"left": Outcome("countershaft", result=original), "right": NONE}
    lost = whole(one, {}, {"left": -1.0, "right": -1.0}, Outcome("countershaft", "blocked"), named=True)
    assert (lost.state, lost.result, str(lost.reason)) == ("no_solution", None, "right: too small")


def test_the_only_one_of_several_that_turns_keeps_its_name(original):
    """Beside one of which only the bearings are asked."""
    every = whole({"left": Outcome("countershaft", result=original)}, {}, {"left": -1.0}, SUMS, named=True).result
    assert list(every.shafts) == ["left"] and every.shaft_mass == pytest.approx(original.mass)


def test_the_sums_by_hand():
    assert mass_of_all(m=np.array([2.0, 3.0])) == 5.0
    assert inertia_at_crank(i=np.array([-1.0, 2.0]), J=np.array([3e-3, 1e-3])) == pytest.approx(7e-3)
