# SPDX-License-Identifier: Apache-2.0
"""How far a design is: the state of its steps, what decides them, and whether it is ready."""

from dataclasses import replace

import pytest

from calc.design.addresses import Table
from calc.design.toml_file import Document, design, read
from calc.solve import Results, solve
from calc.studies.headlines import headline, main_numbers
from calc.studies.ready import readiness, ready, tally
from calc.studies.shipped import DESIGNS, EXAMPLE


@pytest.fixture(scope="module")
def gamma() -> tuple[Document, Results]:
    document = read(EXAMPLE)
    return document, solve(design(document))


def words(data: Table, results: Results | None, wrong: tuple[str, ...] = ()) -> dict[str, tuple[str, str]]:
    return {one.key: (one.state, str(one.words)) for one in readiness(data, results, wrong)}


def test_each_step_says_how_far_it_is(gamma: tuple[Document, Results]) -> None:
    """A finding of one cause counts once, as its worst; an input that is not understood goes before all."""
    document, results = gamma
    found = words(document.data, results, ("engine.bore_mm", "engine.stroke_mm"))
    assert found == {
        "engine": ("needs", "needs 2 inputs"),
        "imbalance": ("ready", "ready"),
        "countershaft": ("warn", "2 cautions"),
        "bearings": ("fail", "3 limits fail"),
        "gears": ("fail", "2 limits fail"),
        "friction": ("ready", "ready"),
        "mounting": ("not_asked", "not used"),
    }
    assert [str(text) for _, text in tally(readiness(document.data, results), results).words] == [
        "5 limits fail",
        "3 cautions",
        "ready 3 of 6",
    ]


def test_what_is_missing_is_to_do_unless_it_is_left_out_or_never_wanted() -> None:
    engine_only = {"engine": {}, "without": {"gears": "the pump's idler drives it"}}
    found = words(engine_only, None)
    assert found["engine"] == ("waits", "solving …") and found["bearings"] == ("todo", "to do")
    assert found["gears"] == ("not_asked", "left out: the pump's idler drives it")
    assert words({"gears": {}}, None)["bearings"] == ("not_asked", "not used")  # a pair of gears on its own


def test_a_design_is_ready_when_nothing_is_open(gamma: tuple[Document, Results]) -> None:
    """A pair of gears whose findings hold, or are accepted, wants no other step."""
    _, results = gamma
    data = {"schema": 1, "gears": {}}
    holds = tuple(check for check in results.outcomes["gears"].checks if check.verdict == "pass")
    fails = next(check for check in results.outcomes["gears"].checks if check.verdict == "fail")
    caution = replace(fails, kind="caution")
    for checks, expected in (
        (holds, True),
        ((*holds, caution), False),
        ((*holds, replace(caution, accepted="agreed")), True),
        ((fails,), False),
    ):
        of_pair = Results(results.design, {"gears": replace(results.outcomes["gears"], checks=checks)})
        assert ready(readiness(data, of_pair)) is expected


def test_a_caution_that_can_not_be_judged_is_a_caution_and_decides_nothing(gamma: tuple[Document, Results]) -> None:
    _, results = gamma
    fails = next(check for check in results.outcomes["bearings"].checks if check.verdict == "fail")
    limit = replace(fails, missing=("bearings.housing_material",))
    caution = replace(limit, kind="caution")
    for check, state in ((limit, "not_verified"), (caution, "warn")):
        alone = Results(
            results.design, {**results.outcomes, "bearings": replace(results.outcomes["bearings"], checks=(check,))}
        )
        assert words({"schema": 1, "bearings": {}}, alone)["bearings"][0] == state
    wide = replace(fails, value=10 * fails.nearest[1], id="bearings.front.film_edge")
    both = replace(results.outcomes["bearings"], checks=(replace(caution, cause="a", id="bearings.front.heat"), wide))
    told = headline(Results(results.design, {**results.outcomes, "bearings": both}), "bearings")
    assert told is not None and told.check is wide


def test_a_mistake_outside_the_steps_keeps_a_design_from_being_ready(gamma: tuple[Document, Results]) -> None:
    _, results = gamma
    data = {"schema": 1, "gears": {}}
    pair = Results(results.design, {"gears": replace(results.outcomes["gears"], checks=())})
    assert ready(readiness(data, pair)) and not ready(readiness(data, pair, ("measured.0.value",)))
    assert words(data, pair, ("measured.0.value", "name"))["engine"] == ("needs", "needs 2 inputs")


def test_a_step_without_a_solution_fails_in_the_count_of_the_whole(gamma: tuple[Document, Results]) -> None:
    document, results = gamma
    lost = replace(results.outcomes["bearings"], state="no_solution", result=None, checks=())
    without = Results(results.design, {**results.outcomes, "bearings": lost})
    states = readiness(document.data, without)
    assert tally(states, without).fail == 3 and words(document.data, without)["bearings"] == ("fail", "no solution")
    assert headline(without, "bearings") is None


def test_the_value_that_decides_is_said_with_its_limit(gamma: tuple[Document, Results]) -> None:
    """The limit that stands first among the findings; where none is open, what the step is for."""
    _, results = gamma
    told = {key: headline(results, key) for key in results.outcomes}
    film = results.values()["bearings.front.film_edge"].shown
    assert {key: str(one.text) for key, one in told.items() if one is not None and key != "gears"} == {
        "engine": "3 cyl, 2.23 L",
        "imbalance": "shaft 573 → 0 N·m",
        "countershaft": "slope 0.188 of 0.25 mrad",
        "bearings": "film 7.41 of 9 µm",
        "friction": "229 W",
    }
    bearings = told["bearings"]
    assert bearings is not None and bearings.share == pytest.approx(film / 9) and str(bearings.brief) == "film 7.4/9 µm"


@pytest.mark.parametrize("name", sorted(path.stem for path in DESIGNS.glob("*.toml")))
def test_a_number_of_the_drive_is_told_where_there_is_one(name: str) -> None:
    results = solve(design(read(DESIGNS / f"{name}.toml")))
    told = dict(main_numbers(results))
    assert all(told.values()) and len(told) == len(main_numbers(results))
    if (loss := results.values().get("friction.total_loss")) is not None:
        assert float(told["loss"].split(" W")[0]) == pytest.approx(loss.shown, rel=5e-3)
    assert ("force for the shaft" in told) == (name in ("twin_drive", "twin_force_shaft", "twin_mounting")) and (
        "films at the edge" in told
    ) == ("bearings.front.film" in results.values())
