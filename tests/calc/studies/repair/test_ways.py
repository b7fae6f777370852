# SPDX-License-Identifier: Apache-2.0
"""What would help against one finding: several kinds, each true when it is solved afresh, in words and not in keys."""

from itertools import islice

import pytest

from calc.design.addresses import quantity_of, value_at
from calc.design.toml_file import Document, design, read
from calc.sheet.check import Check
from calc.sheet.errors import Cancelled
from calc.solve import Results, solve
from calc.studies.repair.levers import grid
from calc.studies.repair.option import LOCKED, NEAR, RepairOption, ranked
from calc.studies.repair.options import search
from calc.studies.repair.state import broken, state_of
from tests.calc.studies.repair.test_remedy import damaged, with_changes
from tests.conftest import DESIGNS, ROOT


def finding(results: Results, id: str) -> Check:
    return next(c for c in results.checks() if c.id == id)


def as_written(document: Document, made: dict[str, object]) -> bool:
    """Whether a workshop would write the numbers so: on the grid of their fields, or on a tenth of it; what only
    follows, where a journal is that grows outwards, stands on half of that."""
    for key, new in made.items():
        about, now = quantity_of(document.data, key), value_at(document.data, key)
        if isinstance(new, float) and isinstance(now, float) and (step := grid(about, now)) is not None:
            finest = step / 20
            if abs(round(new / finest) * finest - new) > 1e-9 * abs(new):
                return False
    return True


def ways_of(document: Document, id: str) -> tuple[Check, tuple[RepairOption, ...]]:
    results = solve(design(document))
    check = finding(results, id)
    return check, ranked(search(document, check, results))


@pytest.mark.parametrize(
    ("id", "kinds"),
    [
        pytest.param(
            "bearings.front.film_edge", {"longer journal", "smoother surfaces", "thicker oil"}, marks=pytest.mark.slow
        ),
        pytest.param(
            "gears.central_idler.backlash_warm", {"thinner teeth", "closer tolerance"}, marks=pytest.mark.slow
        ),
        ("countershaft.bolts.slip_vdi", {"closer bolt holes", "more bolt torque"}),  # a caution
        ("bearings.front.mckee", {"longer journal"}),  # advice
    ],
)
def test_remedies_of_several_kinds_do_what_they_say(gamma: Document, id: str, kinds: set[str]) -> None:
    check, found = ways_of(gamma, id)
    assert kinds <= {way.kind for way in found} and 2 <= len(found) <= 6
    before = state_of(gamma)
    assert found[0].passes and not found[0].breaks
    for way in found:
        assert "_" not in way.words and "_" not in way.rest and way.words  # no key stands there
        if way.quality == LOCKED:
            continue
        assert as_written(gamma, dict(way.made)), way.words
        assert way.passes == way.result.startswith(("passes", "mends this")), way.result
        after = state_of(with_changes(gamma, way.changes))
        there = finding(after.results, id)
        assert (there.holds if check.verdict == "fail" else not there.open) == way.passes
        assert len(broken(before, after)) == len(way.breaks)
        assert all(
            after.outcome(step).verdict == now and before.outcome(step).verdict == was
            for step, was, now in way.verdicts
        )
        assert way.power is not None and way.power[1] == pytest.approx(
            after.results.values()["friction.total_loss"].shown
        )
        assert ("cold gap" in way.rest) == (way.cold is not None and way.cold[0] != way.cold[1])
    ranks = [way.quality for way in found]
    assert ranks == sorted(ranks)


@pytest.mark.slow
def test_what_the_finding_names_is_listed_beside_a_larger_change(gamma: Document) -> None:
    """Both of one kind: with what it says of itself, and at every corner."""
    check, found = ways_of(gamma, "gears.central_idler.backlash_warm")
    (named,) = check.remedies
    corners, own = (way for way in found if way.kind == "thinner teeth")
    assert dict(own.made) == dict(named.changes) and own.disturbance < corners.disturbance
    assert own.result.startswith("passes as given") and "every corner" in corners.result


@pytest.mark.slow
def test_what_is_locked_is_shown_and_not_searched(gamma: Document) -> None:
    _, found = ways_of(gamma, "bearings.front.film_double_load")
    assert [(way.kind, way.locked) for way in found if way.locked] == [("thicker oil", "the oil is the engine's")]
    assert not any("oil" in change for way in found for change in way.changes)
    _, found = ways_of(with_changes(gamma, ("locked.engine=bought",)), "bearings.rear.film_double_load")
    oil = next(way for way in found if way.kind == "another oil")
    assert oil.passes and not oil.locked and oil.changes[0].startswith("bearings.oil=")


@pytest.mark.slow
def test_masses_that_leave_a_couple_are_set_each_in_its_way() -> None:
    _, found = ways_of(damaged("r753ie4_gamma", "shafts.shaft.masses.front.mass_kg=2.0"), "countershaft.residual")
    assert {"heavier mass", "mass further out"} <= {way.kind for way in found if way.passes}


def test_a_kind_that_does_not_reach_says_how_far_it_comes_and_breaks_nothing(gamma: Document) -> None:
    _, found = ways_of(gamma, "bearings.front.film_double_load")
    near = [way for way in found if way.quality == NEAR]
    assert near and all(way.effect.startswith("comes to ") and not way.breaks for way in near)


def test_the_first_comes_long_before_the_last_and_the_search_can_be_stopped(
    gamma: Document, gamma_results: Results
) -> None:
    told: list[float] = []
    check = finding(gamma_results, "bearings.front.film_edge")
    first = next(
        way
        for way in search(gamma, check, gamma_results, lambda share, what: told.append(share))
        if way.quality != LOCKED
    )
    assert first.passes and max(told) < 0.3 and told == sorted(told)

    def stop(share: float, what: str) -> None:
        raise Cancelled

    with pytest.raises(Cancelled):
        ranked(search(gamma, check, gamma_results, stop))


@pytest.mark.parametrize("name", ["timing_pair", pytest.param("thesis_oils", marks=pytest.mark.slow)])
def test_what_can_not_be_verified_asks_for_what_is_missing_first(name: str) -> None:
    """Other numbers are looked at only where it does not even hold by what is taken."""
    document = read(ROOT / "tests" / "reference" / "designs_0_1" / f"{name}.toml")
    results = solve(design(document))
    unknown = [c for c in results.checks() if c.finding == "not_verified"]
    assert unknown
    for check in unknown[:3]:
        group = {key for c in results.checks() for key in c.missing if c.missing}
        ways = list(islice(search(document, check, results), None if check.holds else len(check.missing)))
        first = ways[: len(check.missing)]
        assert first and all(set(way.keys) <= group and way.kind.startswith("give ") for way in first)
        if check.holds:
            assert all(set(way.keys) <= group for way in ways)
        assert not any("_" in way.kind + way.result for way in ways), "inputs by their labels"


def test_a_table_that_is_missing_is_named_and_what_fails_as_taken_comes_to_that(
    gamma: Document, gamma_results: Results
) -> None:
    (way,) = search(gamma, finding(gamma_results, "imbalance.unbalances.couple_left"), gamma_results)
    assert (way.kind, way.keys, way.changes) == ("give unbalances", ("imbalance.unbalances",), ())
    check = finding(gamma_results, "gears.crank_central.backlash")
    for way in search(gamma, check, gamma_results):
        if len(way.made) == 1:
            there = finding(state_of(with_changes(gamma, way.changes)).results, check.id)
            assert ("as taken" in way.effect) == there.holds and ("comes to" in way.effect) == (not there.holds)
        assert check.name not in way.side.words, "what it is made for is no side effect"


@pytest.mark.parametrize(
    ("key", "wrong", "id", "right"),
    [
        ("engine.bore_mm", 9.4, "engine.inputs.bore_mm", 94),
        ("engine.rod_cg_to_big_end_mm", 113.0, "engine.inputs.rod_cg", 50),
    ],
)
def test_of_an_input_that_is_doubted_what_was_meant_is_all_that_is_offered(
    key: str, wrong: float, id: str, right: float
) -> None:
    """Not the smallest change that only just gets by."""
    document = read(DESIGNS / "r753ie4_sized.toml").with_value(key, wrong)
    results = solve(design(document))
    doubt = next(check for check in results.checks() if check.id == id)
    assert [way.changes for way in search(document, doubt, results)] == [(f"{key}={right}",)]
    shut = document.with_value("locked", {key: "measured"})
    assert list(search(shut, doubt)) == []
