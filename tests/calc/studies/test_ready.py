# SPDX-License-Identifier: Apache-2.0
"""How far a design is: the state of its steps, what decides them, whether it is ready, and what it leaves to shake."""

from dataclasses import replace
from pathlib import Path

import pytest

from calc.design.addresses import Table
from calc.design.toml_file import Document, design, parse, read
from calc.sheet.check import Check
from calc.solve import Results, solve
from calc.studies.headlines import closest_limit, headline, heads, main_numbers, remaining
from calc.studies.ready import NO_PLAIN, OF_PROGRAM, Readiness, limits_hold, readiness, whole
from calc.studies.shipped import DESIGNS, EXAMPLE, engine_design
from calc.studies.starter import build
from tests.conftest import each_shipped
from tests.made_checks import made_check

HOLDS, FAILS, NARROW = (made_check(value, id="gears.a") for value in (2.0, 0.5, 1.01))
UNKNOWN = made_check(2.0, id="gears.b", missing=("gears.x",), at_best=2.0, at_worst="none")
CAUTION = made_check(0.5, id="gears.c", kind="caution")
SELF = made_check(2.0, id="gears.d", rule_of={"role": "self"})


@pytest.fixture(scope="module")
def gamma() -> tuple[Document, Results]:
    document = read(EXAMPLE)
    return document, solve(design(document))


@pytest.fixture(scope="module")
def pair() -> Results:
    """A pair of gears on its own."""
    return solve(design(read(DESIGNS / "timing_pair.toml").with_value("friction", None)))


def words(data: Table, results: Results | None, wrong: tuple[str, ...] = ()) -> dict[str, tuple[str, str]]:
    return {one.key: (one.state, str(one.words)) for one in readiness(data, results, wrong)}


def of(results: Results, *checks: Check, wrong: tuple[str, ...] = ()) -> Readiness:
    """How ready a pair of gears with these checks is."""
    made = replace(results, outcomes={**results.outcomes, "gears": replace(results.outcomes["gears"], checks=checks)})
    return whole(readiness({"schema": 1, "gears": {}}, made, wrong), made)


def test_each_step_says_its_state_in_the_words_of_its_verdict(gamma: tuple[Document, Results]) -> None:
    """An input that is not understood goes before all."""
    document, results = gamma
    told = words(document.data, results, ("engine.bore_mm", "engine.stroke_mm"))
    assert told.pop("engine") == ("needs", "needs 2 inputs") and told.pop("mounting") == ("not_asked", "not used")
    assert told == {key: (results.outcomes[key].verdict, results.outcomes[key].words()) for key in told}
    assert words(document.data, results)["engine"] == ("computed", "COMPUTED")
    assert told["bearings"][1].startswith("FAIL: ") and told["gears"][0] == "fail"
    assert str(whole(readiness(document.data, results), results).words) == "3 steps left"


def test_what_is_missing_is_to_do_unless_it_is_left_out_or_never_wanted() -> None:
    engine_only = {"engine": {}, "without": {"gears": "the pump's idler drives it", "bearings": NO_PLAIN}}
    told = words(engine_only, None)
    assert told["engine"] == ("waits", "solving …") and told["friction"] == ("todo", "to do")
    assert told["gears"] == ("not_asked", "left out: the pump's idler drives it")
    assert told["bearings"] == ("not_asked", f"left out by the program: {NO_PLAIN}")
    assert words({"gears": {}}, None)["bearings"] == ("not_asked", "not used")  # a pair of gears on its own


@pytest.mark.parametrize(
    ("checks", "ready", "state", "told"),
    [
        ((HOLDS,), True, "pass", "1 limit holds"),
        ((HOLDS, replace(CAUTION, accepted="agreed")), True, "pass", "1 limit holds"),
        ((HOLDS, CAUTION), True, "warn", "1 limit holds"),
        ((NARROW, HOLDS), True, "warn", "2 limits hold"),
        ((HOLDS, UNKNOWN), False, "todo", "1 step left"),
        ((HOLDS, FAILS), False, "todo", "1 step left"),
        ((CAUTION,), False, "not_judged", "no limit judges it"),
        ((SELF,), False, "not_judged", "no limit judges it"),
        ((), False, "not_judged", "no limit judges it"),
    ],
)
def test_a_design_is_ready_where_its_limits_were_judged_and_hold(
    pair: Results, checks: tuple[Check, ...], ready: bool, state: str, told: str
) -> None:
    """A pair of gears wants no other step, and says which were not used."""
    answer = of(pair, *checks)
    unused = "; not used: engine, imbalance, counter-shaft, bearings, friction" if ready else ""
    assert (answer.ready, answer.state, str(answer.words)) == (ready, state, told + unused)


def test_a_mistake_outside_the_steps_keeps_a_design_from_being_ready(pair: Results) -> None:
    assert of(pair, HOLDS).ready and not of(pair, HOLDS, wrong=("measured.0.value",)).ready
    assert words({"gears": {}}, pair, ("measured.0.value", "name"))["engine"] == ("needs", "needs 2 inputs")


@pytest.mark.parametrize("step", ["engine", "gears", "friction"])
def test_nothing_is_ready_while_a_step_is_to_do_or_waits(gamma: tuple[Document, Results], step: str) -> None:
    """Whatever the others say."""
    document, results = gamma
    passing = {key: replace(o, checks=(HOLDS,)) for key, o in results.outcomes.items()}
    holds = replace(results, outcomes=passing)
    assert whole(readiness(document.data, holds), holds).ready
    gone = {key: table for key, table in document.data.items() if key != step}
    blocked = replace(results, outcomes={**passing, step: replace(passing[step], state="blocked", result=None)})
    for data, outcome in ((gone, holds), (document.data, blocked)):
        if "engine" in data:
            assert str(whole(readiness(data, outcome), outcome).words) == "1 step left"


def test_what_the_program_left_out_is_not_ready_until_a_person_leaves_it_out(gamma: tuple[Document, Results]) -> None:
    document, results = gamma
    data = {key: table for key, table in document.data.items() if key != "friction"}
    passing = {key: replace(o, checks=(HOLDS,)) for key, o in results.outcomes.items() if key != "friction"}
    for reason, told in ((NO_PLAIN, "left out by the program: friction"), ("the pump's", "6 limits hold")):
        left = replace(results.design, friction=None, without=(("friction", reason),))
        answer = Results(left, passing)
        ready = whole(readiness({**data, "without": {"friction": reason}}, answer), answer)
        assert ready.ready is (reason != NO_PLAIN) and ready.words.startswith(told)
    assert str(limits_hold(answer)) == "6 limits hold; left out by you: friction"
    constants = [value for name, value in vars(build).items() if name.isupper() and value in OF_PROGRAM]
    assert sorted([*constants, NO_PLAIN]) == sorted(OF_PROGRAM), "one that older versions wrote"


@pytest.mark.parametrize("pins, turns", [([0.0, 120.0, 240.0, 300.0, 60.0, 180.0], False), ([0.0] * 6, True)])
def test_what_the_program_left_out_for_an_engine_that_was_another_is_said(pins: list[float], turns: bool) -> None:
    """A V6 of 60° with split pins, and the same with all pins together."""
    document = parse(engine_design("v6-60").encode(), "six.toml").with_value("engine.firing_order", None)
    document = document.with_value("engine.crank_angles_deg", pins)
    told = str(limits_hold(solve(design(document))))
    assert "left out by the program: counter-shaft, bearings, gears, friction" in told
    assert told.endswith("but of order 1 something turns backward now") == turns


def test_a_caution_that_can_not_be_judged_decides_nothing(gamma: tuple[Document, Results]) -> None:
    _, results = gamma
    wide = made_check(9.0, id="bearings.front.film", rule_of={"decides": True})
    caution = made_check(0.5, id="bearings.front.heat", kind="caution", missing=("a",), at_best=2.0, at_worst=0.1)
    both = replace(results.outcomes["bearings"], checks=(caution, wide))
    told = headline(replace(results, outcomes={**results.outcomes, "bearings": both}), "bearings")
    assert told is not None and told.check is wide


def test_the_mounts_say_what_is_felt_with_its_unit_and_where_nobody_sits_their_modes() -> None:
    felt, alone = (
        headline(solve(design(read(DESIGNS / f"{name}_mounting.toml"))), "mounting") for name in ("r753ie4", "twin")
    )
    assert felt is not None and str(felt.text) == "seat 0.034 → 0.031 m/s²"
    assert alone is not None and str(alone.text) == "modes 5.3 … 14 Hz"


def test_a_step_without_a_solution_is_left(gamma: tuple[Document, Results]) -> None:
    document, results = gamma
    lost = replace(results.outcomes["bearings"], state="no_solution", result=None, checks=())
    without = replace(results, outcomes={**results.outcomes, "bearings": lost})
    assert words(document.data, without)["bearings"] == ("no_solution", "NO SOLUTION")
    assert not whole(readiness(document.data, without), without).ready and headline(without, "bearings") is None


def test_what_stays_to_shake_is_told_in_numbers(gamma: tuple[Document, Results], pair: Results) -> None:
    _, results = gamma
    told = [(step, str(text)) for step, text in remaining(results)]
    assert ("imbalance", "of order 2 stay 387 N·m") in told
    assert ("imbalance", "Couple that pulley and flywheel must supply: 828 N·m") in told
    assert [text for step, text in told if step == "countershaft" and text.endswith("N·m")] == [
        "of order 1 the shaft leaves 0.0105 N·m"
    ]
    assert not any("of order 1 stay" in text for _, text in told) and not list(remaining(pair))


def test_the_closest_limit_is_one_of_physics_or_a_dash(pair: Results) -> None:
    def told(*checks: Check) -> str:
        outcomes = {**pair.outcomes, "gears": replace(pair.outcomes["gears"], checks=checks)}
        return str(closest_limit(replace(pair, outcomes=outcomes)))

    assert told(HOLDS, SELF, CAUTION) == "A check, +100 %" and told(SELF, CAUTION, UNKNOWN) == "–"


def test_the_value_that_decides_is_said_with_its_limit(gamma: tuple[Document, Results]) -> None:
    """The limit that stands first among the findings; where none is open, what the step is for."""
    _, results = gamma
    told = {key: headline(results, key) for key in results.outcomes}
    film = results.values()["bearings.front.film_edge"].shown
    assert {key: str(one.text) for key, one in told.items() if one is not None and key != "gears"} == {
        "engine": "3 cyl, 2.23 L",
        "imbalance": "shaft 573 → 0 N·m",
        "countershaft": "fatigue not verified",
        "bearings": "film 7.41 of 9 µm",
        "friction": "229 W",
    }
    bearings = told["bearings"]
    assert bearings is not None and bearings.share == pytest.approx(film / 9) and str(bearings.brief) == "film 7.4/9 µm"


@pytest.mark.parametrize("path", each_shipped())
def test_a_number_of_the_drive_is_told_where_there_is_one(path: Path) -> None:
    results, name = solve(design(read(path))), path.stem
    told = dict(main_numbers(results))
    assert all(told.values()) and len(told) == len(main_numbers(results))
    if (loss := results.values().get("friction.total_loss")) is not None:
        assert float(told["loss"].split(" W")[0]) == pytest.approx(loss.shown, rel=5e-3)
    assert ("force for the shaft" in told) == (name in ("twin_drive", "twin_force_shaft", "twin_mounting"))
    if name == "r754ie4_balance_shafts":  # the roll beside the force, at the end and in the step's line
        assert ("countershaft", "of the roll of order 2 stay 842 N·m") in list(remaining(results))
        assert [v.id.rpartition(".")[2] for v in heads(results, "countershaft")] == [
            "residual_order_2_force",
            "roll_left_order_2",
        ]
    of_one = "bearings.front.film" in results.values() and len(results.design.shafts) < 2
    assert ("films at the edge" in told) == of_one
