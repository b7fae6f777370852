# SPDX-License-Identifier: Apache-2.0
"""The gear train in the whole design: what has no solution keeps its reason, and what is known stays."""

from copy import deepcopy
from dataclasses import replace
from pathlib import Path

import pytest

from calc.design.replay import compare
from calc.design.toml_file import design, read
from calc.gears.inputs import wheel_key
from calc.gears.wheel_inputs import Wheel
from calc.sheet.errors import BadInput
from calc.solve import solve

DESIGNS = Path(__file__).parents[3] / "designs"
GAMMA, SHEET, PAIR = (
    read(DESIGNS / name) for name in ("r753ie4_gamma.toml", "finotti_gear_sheet.toml", "timing_pair.toml")
)


def solved(document, **changes):
    for key, value in changes.items():
        document = document.with_value("gears." + key.replace("__", "."), value)
    return solve(design(document)).outcomes["gears"]


@pytest.mark.parametrize("document", [GAMMA, SHEET], ids=["gamma", "alone"])
@pytest.mark.parametrize(
    "changes, words",
    [
        ({"meshes__1__centre_distance_mm": 50.0}, "it must exceed"),
        ({"wheels__idler__tip_shortening_mm": 4.5}, "no involute flank is left"),
        ({"wheels__idler__span_allowance_um": [0, -4000]}, "it must stay above"),
        ({"wheels__central__profile_shift": 2.9}, ""),
        ({"tool_tip_radius": 0.9}, "gears.tool_tip_radius"),
    ],
)
def test_a_train_that_can_not_be_keeps_its_reason(document, changes, words):
    outcome = solved(document, **changes)
    assert outcome.state == "no_solution" and words in outcome.reason and len(outcome.reason) > 30


@pytest.mark.parametrize(
    "changes, part, words",
    [
        ({"wheels__central__rim_thickness_mm": 0.5}, "rating", "rim_thickness_mm"),
        ({"wheels__central__bore_diameter_mm": 90.0}, "rating", "bore"),
    ],
)
def test_a_part_without_solution_fails_and_the_rest_stays(changes, part, words):
    outcome = solved(GAMMA, **changes)
    failed = next(c for c in outcome.checks if c.id == f"gears.train.{part}")
    assert outcome.state == "solved" and failed.verdict == "fail" and words in failed.advice
    assert outcome.result.meshes["central_idler"].backlash_min < 0 and outcome.result.layout is not None


def test_a_train_whose_torque_is_not_known_says_so():
    outcome = solved(SHEET, power_kW=None)
    assert all(mesh.rating is None for mesh in outcome.result.meshes.values())
    assert any("no torque is known" in note for note in outcome.notes)


def test_the_sheet_stands_beside_only_where_it_is_asked():
    plain, asked = solved(PAIR), solved(PAIR, source_sheet="finotti")
    assert plain.result.meshes["crank_camshaft"].rating.sheet is None and not plain.errata
    assert asked.result.meshes["crank_camshaft"].rating.sheet is not None
    assert {t.id for t in asked.tables} - {t.id for t in plain.tables} == {"source_sheet"}


def test_the_sheet_names_a_fault_only_where_it_differs():
    (table,) = (t for t in solved(GAMMA, speed_irregularity=0.02).tables if t.id == "source_sheet")
    for _, what, _, theirs, ours, wrong in table.rows:
        assert bool(wrong) == (abs(theirs - ours) > 1e-3 * abs(ours)), what
    first = next(row for row in table.rows if row[:2] == ("crank–central", "tangential force"))
    assert first[3] == pytest.approx(first[4]) and first[5] == ""


@pytest.mark.parametrize("ball, verdict", [(3.5, "pass"), (30.0, "warn"), (0.5, "warn")])
def test_a_given_ball_has_to_fit(ball, verdict):
    outcome = solved(SHEET, ball_diameter_mm=ball)
    checks = {c.id: c for c in outcome.checks}
    assert checks["gears.central.ball"].verdict == verdict
    assert (outcome.result.wheels["central"].over_balls is None) == (verdict == "warn")


def test_the_ends_of_the_tolerances_are_judged():
    long, short = (solved(SHEET, wheels__idler__tip_diameter_tolerance_um=ends) for ends in ([3000, 0], [0, -2500]))
    verdicts = {c.id: c.verdict for c in long.checks}
    assert (
        verdicts["gears.central_idler.tip_clearance_least"] == "fail"
        and verdicts["gears.central_idler.tip_clearance"] == "pass"
    )
    verdicts = {c.id: c.verdict for c in short.checks}
    assert (
        verdicts["gears.central_idler.contact_ratio_least"] == "warn"
        and verdicts["gears.central_idler.contact_ratio"] == "pass"
    )
    thin = {c.id: c for c in solved(SHEET, wheels__central__span_allowance_um=[-1200, -1300]).checks}
    assert thin["gears.central.tip_thickness"].verdict == "fail"


def test_an_iron_wheel_is_not_rated_as_case_hardened_steel():
    for material in ("EN AC-43100", "EN-GJL-250", "42CrMo4"):
        outcome = solved(GAMMA, wheels__crank__material=material)
        assert outcome.result.meshes["crank_central"].rating.strength is None
        assert outcome.result.meshes["idler_shaft"].rating.strength is not None
        assert any("gears.wheels.crank.gear_material" in note for note in outcome.notes)
    named = solved(
        GAMMA, wheels__crank__material="42CrMo4", wheels__crank__gear_material="quenched and tempered alloy steel"
    )
    assert named.state == "solved"


@pytest.mark.parametrize("changes", [{"meshes__1__centre_distance_mm": 95.0}, {"wheels__central__teeth": 8}])
def test_a_distance_that_asks_for_an_absurd_shift_is_named_with_its_limits(changes):
    outcome = solved(GAMMA, **changes)
    assert outcome.reason.startswith("gears.meshes.1.centre_distance_mm") and "a distance from" in outcome.reason


def test_a_bore_leaves_a_rim():
    """A wheel bored out is weaker, and none where its bore nears the root."""
    solid, bored = (solved(GAMMA, wheels__idler__bore_diameter_mm=bore).result for bore in (None, 69.0))
    S_F = [t.meshes["idler_shaft"].rating.strength.wheels["safety_bending_idler"].number for t in (solid, bored)]
    assert S_F[1] < S_F[0]
    thin = solved(GAMMA, wheels__idler__bore_diameter_mm=76.0)
    assert next(c for c in thin.checks if c.id == "gears.train.rating").verdict == "fail"


def test_the_shaft_is_held_against_the_crank_and_not_against_the_first_driver():
    """A first driver at half the crank's speed needs twice the teeth of the shaft's wheel."""
    verdict = {c.id: c.verdict for c in solved(GAMMA, speed_rpm=1300.0).checks}
    assert verdict["gears.train.speed_ratio"] == "fail"


def test_following_the_advice_on_the_fillet_passes():
    (before,) = (c for c in solved(PAIR).checks if c.id == "gears.crank_camshaft.interference_usual")
    assert before.verdict == "note"
    ((key, cut),) = before.remedies[0].changes
    name = key.split(".")[2]
    after = solved(PAIR, **{f"wheels__{name}__tip_shortening_mm": cut})
    one = next(c for c in after.checks if c.id == "gears.crank_camshaft.interference_usual")
    assert one.value > before.value and (one.verdict == "pass" or name not in one.advice.partition(":")[0])


def test_a_wheel_is_found_by_the_name_that_it_had():
    """The driven wheel of the gear friction thesis sits on the camshaft (3.2); its design called it a pump's."""
    key, results = wheel_key("pump", Wheel.teeth), solve(design(PAIR))
    assert design(PAIR.with_value(key, 75)).gears.wheels[1].teeth == 75
    values = results.values()
    for old, new in (
        ("gears.pump.tip_diameter", "gears.camshaft.tip_diameter"),
        ("friction.crank_pump.loss", "friction.crank_camshaft.loss"),
        ("gears.crank_pump.safety_bending_pump", "gears.crank_camshaft.safety_bending_camshaft"),
    ):
        assert values[old] is values[new] and values[old].id == new
    check = next(c for c in results.checks() if c.id == "gears.crank_camshaft.backlash")
    found = compare(results, {"check": "gears.crank_pump.backlash", "verdict": check.verdict})
    assert found.agrees


def test_a_former_name_is_that_of_no_other_wheel():
    with pytest.raises(BadInput, match="is the name of a wheel"):
        design(PAIR.with_value(wheel_key("camshaft", Wheel.former_name), "crank"))
    with pytest.raises(BadInput, match="is the name of a wheel"):
        design(PAIR.with_value(wheel_key("crank", Wheel.former_name), "pump"))


def test_a_former_name_takes_no_id_that_something_else_has():
    """A wheel that is called rear and was called front: the front bearing keeps its values and checks."""
    document = read(DESIGNS / "r753ie4_gamma.toml")
    before = solve(design(document))
    gears = deepcopy(document.data["gears"])
    gears["wheels"][1] |= {"name": "rear", "former_name": "front"}
    for mesh in gears["meshes"]:
        mesh |= {end: "rear" for end in ("driver", "driven") if mesh[end] == "central"}
    after = solve(design(replace(document, data={**document.data, "gears": gears})))
    for id in ("bearings.front.film", "bearings.rear.film"):
        assert after.values()[id].shown == before.values()[id].shown
    id = "bearings.front.film_edge"
    assert after.check(id).value == before.check(id).value
