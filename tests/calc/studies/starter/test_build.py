# SPDX-License-Identifier: Apache-2.0
"""Steps that are missing are built by rules: from an own engine to ready, around what is there, and with reasons where
nothing fits."""

import re
from dataclasses import replace
from functools import reduce

import pytest

from calc.countershaft.rows import BearingRow
from calc.design.addresses import Table
from calc.design.toml_file import Document, design, parse, read
from calc.imbalance.checks import COUPLE_LEFT
from calc.sheet.errors import NoSolution
from calc.solve import Results, solve
from calc.studies.shipped import DESIGNS, _rows, engine_design
from calc.studies.starter.build import all_built, built, choice_made, hindrance, to_build

DIESEL: Table = {
    "name": "own inline three",
    "layout": "inline",
    "cylinders": 3,
    "strokes": 4,
    "bore_mm": 95.0,
    "crank_radius_mm": 55.0,
    "rod_length_mm": 170.0,
    "cylinder_pitch_mm": 112.0,
    "firing_order": [1, 3, 2],
    "piston_mass_g": 1200.0,
    "rod_mass_g": 1100.0,
    "rated_speed_rpm": 2800.0,
}
STEPS = ("countershaft", "bearings", "gears", "friction")
LENGTHS = ("bore_mm", "crank_radius_mm", "rod_length_mm", "cylinder_pitch_mm")


def alone(engine: Table) -> Document:
    return Document({"schema": 1, "name": "own", "engine": engine})


def shipped(name: str, speed: float = 1.0, piston: float = 1.0, size: float = 1.0) -> Table:
    """A shipped engine with other numbers."""
    own: Table = dict(_rows()[name]["engine"])
    factors = {"rated_speed_rpm": speed, "piston_mass_g": piston, **dict.fromkeys(LENGTHS, size)}
    return {**own, **{key: own[key] * factor for key, factor in factors.items()}}  # type: ignore[operator]


def solved(document: Document) -> Results:
    return solve(design(document))


def open_findings(results: Results) -> list[str]:
    return [c.id for c in results.checks() if c.kind in ("limit", "caution") and c.open]


@pytest.mark.parametrize(
    "engine",
    [
        pytest.param(DIESEL, marks=pytest.mark.slow),
        pytest.param(shipped("twin-360", speed=0.8), marks=pytest.mark.slow),
        pytest.param(shipped("twin-360", piston=1.2), marks=pytest.mark.slow),
        pytest.param(shipped("single", speed=1.2, size=0.9), marks=pytest.mark.slow),
        pytest.param(shipped("inline-3", piston=0.8, size=1.2), marks=pytest.mark.slow),
        shipped("boxer-2", speed=0.8),
        shipped("inline-5", size=0.8),
        shipped("v6-90", speed=1.2),
    ],
    ids=[
        "diesel",
        "twin slower",
        "twin heavier",
        "single faster",
        "three wider",
        "boxer slower",
        "five smaller",
        "V6 faster",
    ],
)
def test_an_own_engine_is_ready_step_by_step(engine: Table) -> None:
    """As the session asks for one step after the other, with what the engine calls for."""
    document = reduce(built, STEPS, built(alone(engine), "imbalance"))
    results = solved(document)
    assert open_findings(results) == []
    assert {results.outcomes[step].verdict for step in STEPS} <= {"pass", "not_asked"}
    backlashes = [c for c in results.outcomes["gears"].checks if ".backlash" in c.id and c.kind == "limit"]
    assert all(c.verdict == "pass" and c.margin >= 0.05 for c in backlashes), "free with the runout of the grade"
    steps = ("shafts" if step == "countershaft" else step for step in STEPS)
    assert list(document.data)[3:] == ["imbalance", *(step for step in steps if step in document.data)]
    assert choice_made(document) == "shaft"


def test_all_that_is_left_is_built_as_far_as_the_rules_come() -> None:
    """What is there stays, what a person left out too; where they come no further they say why."""
    gamma = read(DESIGNS / "r753ie4_gamma.toml")
    made, why = all_built(gamma.with_value("friction", None))
    assert not why and made.data == built(gamma.with_value("friction", None), "friction").data
    without = Document({**gamma.data, "without": {"gears": "a chain"}})
    without = without.with_value("gears", None).with_value("friction", None)
    made, why = all_built(without)
    assert made is without and "friction" in to_build(made.data) and "gears" not in to_build(made.data) and why


@pytest.mark.slow
def test_a_train_that_rattles_is_built_with_its_cautions() -> None:
    """No train of a single is quiet: one is written all the same, with nothing open but what its strikes do."""
    results = solved(parse(engine_design("single").encode("utf-8"), "own"))
    open_ = open_findings(results)
    assert "gears.crank_central.rattle" in open_ and "gears.drive.backlash_window" in open_
    assert all(id.startswith("gears.") and ("strike" in id or "rattle" in id or "window" in id) for id in open_)
    assert results.outcomes["gears"].verdict == "warn" and results.outcomes["friction"].verdict == "pass"
    check = results.check("gears.crank_central.rattle")
    assert check is not None
    keys = [[key.rpartition(".")[2] for key, _ in way.changes] for way in check.remedies]
    # no flywheel closes the flanks that the weight of the shaft parts: none of 59 times the inertia is offered
    assert keys == [["flywheel_inertia_kgm2"], ["torque_Nm"] * 2, ["torque_Nm"] * 3]


def test_a_step_is_built_around_what_is_there() -> None:
    """Bearings for a given shaft: at its places, as wide as its sectors ask, in the housing of its wheels."""
    gamma = read(DESIGNS / "r753ie4_gamma.toml")
    made = built(gamma.with_value("bearings", None), "bearings")
    shaft, bearings = design(made).countershaft, design(made).bearings
    given = design(gamma).countershaft
    assert shaft is not None and bearings is not None and given is not None and shaft.outer_radius is not None
    assert replace(shaft, bearings=()) == replace(given, bearings=()) and made.data["gears"] == gamma.data["gears"]
    assert shaft.bearing_positions == given.bearing_positions
    assert shaft.bearings[-1].diameter >= 2 * shaft.outer_radius and bearings.housing_material == "EN-GJL-250"
    results = solved(made)
    assert results.outcomes["bearings"].verdict == "pass"


def test_given_journals_become_those_of_the_bearings() -> None:
    twin = read(DESIGNS / "twin_force_shaft.toml")
    given = [{"diameter_mm": 75.0, "length_mm": 56.0}, {"diameter_mm": 80.0, "length_mm": 56.0}]
    made = built(twin.with_value("countershaft.journals", given), "bearings")
    assert design(made).bearings is not None
    assert [row.diameter for row in design(made).rows] == pytest.approx([0.075, 0.08])


def test_short_journals_are_judged_by_their_films() -> None:
    """Their heat index is beyond the old table of cooling; their oil leaves below its limit."""
    twin = read(DESIGNS / "twin_force_shaft.toml")
    made = built(twin.with_value("countershaft.journals", [{"diameter_mm": 70.0, "length_mm": 30.0}] * 2), "bearings")
    results = solved(made)
    assert results.outcomes["bearings"].verdict == "pass"
    assert max(b.heat_index for b in results.outcomes["bearings"].result.bearings.values()) > 500e3 * 1000 / 60  # type: ignore[attr-defined]


@pytest.mark.slow
def test_a_train_reaches_the_axis_of_the_shaft() -> None:
    twin = read(DESIGNS / "twin_force_shaft.toml").with_value("shafts.shaft.axis_mm", [0.0, 190.0])
    made = reduce(built, STEPS[1:], twin)
    train = solved(made).outcomes["gears"].result
    distances = [mesh.centre_distance for mesh in train.meshes.values()]  # type: ignore[attr-defined]
    assert sum(distances) > 0.190


def test_another_choice_takes_the_place_of_the_one_before() -> None:
    gamma = read(DESIGNS / "r753ie4_gamma.toml")
    half = built(gamma, "countershaft", "half")
    assert choice_made(half) == "half" and not {"shafts", *STEPS} & half.data.keys()
    results = solved(half)
    assert results.outcomes["countershaft"].verdict == "not_asked"
    assert open_findings(results) == [COUPLE_LEFT.id], "what crank and webs leave is no matter of the balancing"
    none = built(half, "countershaft", "none")
    assert choice_made(none) == "none" and none.data["accepted"]
    shaft = built(none, "countershaft", "shaft")
    assert choice_made(shaft) == "shaft" and "accepted" not in shaft.data and "without" not in shaft.data


def judged(document: Document) -> list[BearingRow]:
    """The bearings of a design wherever they stand."""
    return [replace(row, position=0.0) for row in design(document).rows]


def test_steps_that_no_longer_fit_the_shaft_go_with_the_one_before() -> None:
    """The bearings of γ fail beside any shaft; those that pass stay."""
    gamma = read(DESIGNS / "r753ie4_gamma.toml")
    assert "bearings" not in built(gamma, "countershaft", "shaft").data
    own = alone(shipped("inline-3", piston=0.8, size=1.2))
    for step in ("imbalance", "countershaft", "bearings"):
        own = built(own, step)
    kept = built(own, "countershaft", "shaft")
    assert kept.data["bearings"] == own.data["bearings"] and judged(kept) == judged(own)
    assert max(solved(kept).values()[f"countershaft.slope_{end}"].shown for end in ("front", "rear")) <= 0.2


@pytest.mark.slow
def test_a_pair_is_designed_step_by_step() -> None:
    pair = reduce(built, STEPS[1:], built(alone(shipped("inline-4")), "countershaft", "second"))
    shaft, twin = design(pair).shafts
    assert shaft.speed_ratio == 2 and twin.mirrors == shaft.name and len(shaft.bearings) == 3
    assert pair.data["imbalance"]["crank_balance_fraction"] == 0  # type: ignore[index]
    results = solved(pair)
    assert open_findings(results) == [] and "without" not in pair.data
    assert {results.outcomes[step].verdict for step in STEPS} == {"pass"}
    force = results.values()
    # 1.5 % over: what is left of the force of order 2
    assert force["countershaft.residual_order_2_force"].shown == pytest.approx(0.015 * 6101, rel=1e-3)


ARRANGED = {
    "second": ("inline-4", [2]),
    "pair": ("single", [1]),
    "repeat": ("single", [-1]),
    "pair_and_second": ("twin-360", [1, 2]),
}


@pytest.mark.slow
@pytest.mark.parametrize("balancing", ARRANGED)
def test_every_arrangement_is_written_whole(balancing: str) -> None:
    """What `new --arrangement` writes: each limit holds in all six steps, and the session knows the choice."""
    engine, ratios = ARRANGED[balancing]
    document = parse(engine_design(engine, balancing).encode("utf-8"), engine)
    made = design(document)
    assert [shaft.speed_ratio for shaft in made.shafts if not shaft.is_twin] == ratios
    assert len(made.shafts) == 2 * len(ratios) and choice_made(document) == balancing
    results = solve(made)
    assert open_findings(results) == [] and {results.outcomes[step].verdict for step in STEPS} == {"pass"}


@pytest.mark.slow
def test_an_engine_of_ones_own_is_built_for_its_own_numbers() -> None:
    """A diesel of 4500 rpm, from nothing to its mounts."""
    own = {"engine.bore_mm": 84.0, "engine.crank_radius_mm": 45.0, "engine.rod_length_mm": 145.0}
    own |= {
        "engine.cylinder_pitch_mm": 92.0,
        "engine.piston_mass_g": 620.0,
        "engine.rod_mass_g": 680.0,
        "engine.rated_speed_rpm": 4500.0,
    }
    text = engine_design("inline-4", "second", own, mounts=True)
    results = solve(design(parse(text.encode("utf-8"), "own")))
    assert open_findings(results) == []
    assert {results.outcomes[step].verdict for step in (*STEPS, "mounting")} == {"pass"}


@pytest.mark.parametrize("step", ["bearings", *(pytest.param(step, marks=pytest.mark.slow) for step in STEPS[2:])])
def test_a_step_that_was_left_out_is_built_after_all(step: str) -> None:
    before = reduce(built, STEPS[: STEPS.index(step)], built(alone(DIESEL), "imbalance"))
    left = dict.fromkeys(STEPS[STEPS.index(step) :], "bought in")
    document = built(replace(before, data={**before.data, "without": left}), step)
    assert step in document.data and set(document.data.get("without", {})) == set(left) - {step}  # type: ignore[call-overload]


@pytest.mark.parametrize(("engine", "balancing"), [("v6-60", "half"), ("inline-4", "none")])
def test_what_can_not_be_built_for_a_balancing_is_said_in_words(engine: str, balancing: str) -> None:
    document = built(alone(shipped(engine)), "countershaft", balancing)
    for step in STEPS[1:]:
        why = str(hindrance(document, step))
        assert why and "[" not in why
        with pytest.raises(NoSolution, match=re.escape(why)):
            built(document, step)


def test_what_can_not_be_built_says_why() -> None:
    with pytest.raises(NoSolution, match="nothing to take"):
        built(alone(shipped("inline-6")), "countershaft", "shaft")
    with pytest.raises(NoSolution, match="mirror image"):
        built(alone(shipped("v8-flat")), "countershaft", "second")
    with pytest.raises(NoSolution, match="the step Counter-shaft comes first"):
        built(alone(DIESEL), "bearings")
    with pytest.raises(NoSolution, match="the step Gears comes first"):
        built(alone(DIESEL), "friction")


@pytest.mark.parametrize("engine", ["single", "twin-360", "inline-3", "inline-6", "v6-60", "boxer-4"])
def test_the_engine_is_put_on_four_mounts(engine: str) -> None:
    """Its modes lie between the road and what shakes at idle, and every limit of the step holds."""
    document = built(built(alone(shipped(engine)), "imbalance"), "mounting")
    assert len(document.data["mounting"]["mounts"]) == 4  # type: ignore[index, call-overload]
    outcome = solved(document).outcomes["mounting"]
    assert outcome.verdict == "pass"
    window = outcome.result.window  # type: ignore[attr-defined]
    ceilings = [of.highest_factor for of in (window.half, window.shaft) if of is not None]
    # midway, but for the rounding of the stiffness
    assert window.lowest_factor * min(ceilings) == pytest.approx(1, rel=0.15)


def test_an_engine_is_as_long_as_its_cylinders_stand_apart() -> None:
    """Nine around one crankpin take the length of one."""
    radial = {**DIESEL, "layout": "radial", "cylinders": 9, "firing_order": [1, 3, 5, 7, 9, 2, 4, 6, 8]}
    document = built(built(alone(radial), "imbalance"), "mounting")
    assert document.data["mounting"]["dimensions_mm"][2] == pytest.approx(340.0)  # type: ignore[index, call-overload]
