# SPDX-License-Identifier: Apache-2.0
"""Two designs side by side: what is found to differ, and what is not."""

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.design.addresses import address, changed, quantities, value_at
from calc.design.model import STEPS
from calc.design.toml_file import Document, design, read
from calc.sheet.check import Check
from calc.sheet.quantity import Described, Published
from calc.sheet.step import Outcome
from calc.solve import Results, solve
from calc.studies.compare import SAME, Comparison, ValueDifference, compare, inputs, relative, turn
from calc.studies.compare_tables import change_text, check_table, input_table, pair, value_table, verdict_table
from tests.conftest import DESIGNS, GAMMA, ROOT
from tests.made_checks import made_check

BETA = DESIGNS / "r753ie4_beta.toml"
OWN = {  # of what the two files say about one and the same thing
    "shafts.shaft.bearings.front.length_mm": (26.0, 27.5),
    "shafts.shaft.bearings.rear.diameter_mm": (40.0, 81.0),
    "shafts.shaft.bearings.rear.length_mm": (25.5, 26.5),
    "shafts.shaft.bearings.rear.clearance_factor": (0.6, 0.61),
}


@pytest.fixture(scope="module")
def beta() -> Document:
    return read(BETA)


@pytest.fixture(scope="module")
def beta_results(beta: Document) -> Results:
    return solve(design(beta))


@pytest.fixture(scope="module")
def found(beta: Document, beta_results: Results, gamma: Document, gamma_results: Results) -> Comparison:
    return compare(beta.data, gamma.data, beta_results, gamma_results)


# --- inputs
def test_the_inputs_of_beta_and_gamma(found: Comparison) -> None:
    by_key = {d.key: d for d in found.inputs}
    both = {
        key: (d.a, d.b)
        for key, d in by_key.items()
        if d.a is not None and d.b is not None and d.step not in ("name", "note")
    }
    assert both == OWN
    assert [d.key for d in found.inputs][-3:] == ["material", "name", "note"]  # what is not calculated with stands last
    assert by_key["shafts.shaft.bolts"].a is None and by_key["shafts.shaft.bolts"].b["thread"] == "M10x1.5"
    assert "shafts.shaft.bolts.thread" not in by_key  # a table of one design is one difference
    assert len(by_key["gears.meshes.1.stack"].b) == 17
    assert by_key["gears.wheels.shaft.tip_diameter_tolerance_um"].b == [0, -100]  # by its name
    rear = by_key["shafts.shaft.bearings.rear.diameter_mm"]
    assert (rear.label, rear.unit, rear.step) == ("Journal diameter", "mm", "bearings")


def test_elements_are_matched_by_name_else_by_place(gamma: Document) -> None:
    wheels = list(reversed(gamma.data["gears"]["wheels"]))
    other = {**gamma.data, "gears": {**gamma.data["gears"], "wheels": wheels}}
    assert inputs(gamma.data, other) == []
    fewer = {**gamma.data, "gears": {**gamma.data["gears"], "wheels": gamma.data["gears"]["wheels"][:-1]}}
    (lost,) = inputs(gamma.data, fewer)
    assert (
        lost.key == "gears.wheels.shaft"
        and lost.b is None
        and lost.a["name"] == "shaft"
        and lost.label == "Wheels: shaft"
    )
    swapped = {**gamma.data, "gears": {**gamma.data["gears"], "meshes": list(reversed(gamma.data["gears"]["meshes"]))}}
    assert {d.key for d in inputs(gamma.data, swapped)} >= {"gears.meshes.0.driver", "gears.meshes.2.driver"}


def test_two_spellings_of_one_value_are_no_difference(gamma: Document) -> None:
    one = gamma.with_value("friction.flank_roughness_um", 0.8)
    assert inputs(one.data, gamma.with_value("friction.flank_roughness_um", [0.8]).data) == []
    assert inputs(one.data, gamma.with_value("friction.flank_roughness_um", [0.8, 0.9]).data)[0].b == [0.8, 0.9]
    bolts = gamma.with_value("shafts.shaft.bolts.property_class", "8.8")
    assert inputs(bolts.data, gamma.with_value("shafts.shaft.bolts.property_class", 8.8).data) == []


def editable() -> list[str]:
    """The keys of tables that are there, but for the names by which elements are matched."""
    data = read(GAMMA).data
    keys = [key for key, _ in quantities(data)]
    return [
        key
        for key in keys
        if not (key.endswith(".name") and key.count(".") > 1) and "cost.alternatives" not in key and there(data, key)
    ]


def there(data: Any, key: str) -> bool:
    here: Any = data
    for part in address(data, key)[:-1]:
        here = here.get(part) if isinstance(part, str) else here[part]
        if here is None:
            return False
    return True


@settings(max_examples=150, deadline=None)
@given(st.sampled_from(editable()), st.one_of(st.none(), st.floats(-1e6, 1e6), st.text("abc", max_size=3)))
def test_one_changed_key_is_reported_and_no_other(key: str, content: Any) -> None:
    """Whatever is put there; whether it is allowed is not asked."""
    data = read(GAMMA).data
    before = value_at(data, key)
    found = inputs(data, changed(data, address(data, key), content))
    assert [(d.key, d.a, d.b) for d in found] == ([(key, before, content)] if content != before else [])


# --- results
def test_the_checks_of_beta_and_gamma(found: Comparison, beta_results: Results, gamma_results: Results) -> None:
    theirs, ours = ({c.id: c for c in results.checks()} for results in (beta_results, gamma_results))
    moved = {d.id for d in found.checks_moved}
    assert moved == {id for id in theirs.keys() & ours.keys() if theirs[id].verdict != ours[id].verdict}
    assert {"bearings.rear.film_edge", "gears.central_idler.backlash_warm"} <= moved
    assert {d.id for d in found.checks if not d.both} == theirs.keys() ^ ours.keys()
    edge = next(d for d in found.checks if d.id == "bearings.rear.film_edge")
    assert edge.a and edge.b and (edge.a.verdict, edge.b.verdict, edge.worse) == ("fail", "pass", False)
    limit = next(d for d in found.checks if d.id == "bearings.rear.transition")
    assert limit.a and limit.b and limit.a.value == limit.b.value and limit.relative > 0.5  # its limit has moved
    outcomes = [results.outcomes for results in (beta_results, gamma_results)]
    moved_steps = [key for key in outcomes[0] if outcomes[0][key].verdict != outcomes[1][key].verdict]
    assert [v.step for v in found.steps_moved] == moved_steps


def test_values_in_order(found: Comparison, beta_results: Results, gamma_results: Results) -> None:
    # by their present names
    theirs, ours = ({id: v for id, v in r.values().items() if id == v.id} for r in (beta_results, gamma_results))
    assert {d.id for d in found.values if not d.both} == theirs.keys() ^ ours.keys()
    order = {step.key: n for n, step in enumerate(STEPS)}
    ranks = [(order[d.step], not d.both, -d.relative if d.both else 0.0) for d in found.values]
    assert ranks == sorted(ranks)
    for d in found.values:
        if d.both:
            assert (d.a, d.b) == (theirs[d.id].shown, ours[d.id].shown)
    same = (theirs.keys() & ours.keys()) - {d.id for d in found.values}
    assert same and all(
        theirs[id].shown == pytest.approx(ours[id].shown, rel=SAME) for id in same
    )  # nothing that differs is passed over


def mirrored(found: Comparison) -> Comparison:
    return Comparison(
        tuple(replace(d, a=d.b, b=d.a) for d in found.inputs),
        tuple(replace(v, a=v.b, b=v.a) for v in found.verdicts),
        tuple(replace(d, a=d.b, b=d.a) for d in found.checks),
        tuple(replace(d, a=d.b, b=d.a) for d in found.values),
        tuple(replace(r, a=r.b, b=r.a) for r in found.results),
    )


@pytest.mark.parametrize("name", ["r753ie4_beta", "timing_pair"])
def test_the_other_way_round_it_is_the_mirror_image(name: str, gamma: Document, gamma_results: Results) -> None:
    other = read(DESIGNS / f"{name}.toml")
    results = solve(design(other))
    there = compare(other.data, gamma.data, results, gamma_results)
    back = compare(gamma.data, other.data, gamma_results, results)
    assert {(d.key, str(d.a), str(d.b)) for d in back.inputs} == {(d.key, str(d.b), str(d.a)) for d in there.inputs}
    assert back.verdicts == mirrored(there).verdicts
    assert [(d.id, d.a, d.b, d.relative) for d in back.values] == [(d.id, d.b, d.a, d.relative) for d in there.values]
    assert {(d.id, d.a, d.b) for d in back.checks} == {(d.id, d.b, d.a) for d in there.checks}


def test_a_design_is_equal_to_itself(gamma: Document, gamma_results: Results) -> None:
    found = compare(gamma.data, gamma.data, gamma_results, solve(design(read(GAMMA))))
    assert found.equal and not found.values and not found.checks and not found.inputs
    named = compare(gamma.data, {**gamma.data, "name": "another"}, gamma_results, gamma_results)
    assert not named.equal and [d.key for d in named.inputs] == ["name"]


def test_a_step_of_one_design_only(gamma: Document, gamma_results: Results) -> None:
    fewer = {key: table for key, table in gamma.data.items() if key != "friction"}
    found = compare(fewer, gamma.data, solve(design(replace(gamma, data=fewer))), gamma_results)
    table = next(d for d in found.inputs if d.key == "friction")
    assert table.a is None and table.b == gamma.data["friction"]
    last = next(verdict for verdict in found.verdicts if verdict.step == "friction")
    assert (last.step, last.a.verdict, last.b.verdict, last.moved) == ("friction", "not_asked", "pass", True)
    assert "friction" not in found.steps_shared and "gears" in found.steps_shared
    assert input_table([table], ("A", "B")).rows == (("friction", "not used", f"{len(table.b)} keys"),)


# --- noise
def results_of(gamma_results: Results, *values: Published, checks: tuple[Check, ...] = ()) -> Results:
    class One(Outcome):
        def values(self) -> Iterator[Published]:
            yield from values

    outcomes = {step.key: Outcome(step.key, "not_asked") for step in STEPS}
    outcomes["engine"] = One("engine", checks=checks)
    return Results(gamma_results.design, outcomes)


def published(id: str, shown: float, unit: str = "N") -> Published:
    return Published(f"engine.{id}", shown, unit, id, "", shown, Described(id, unit))


@pytest.mark.parametrize(
    ("a", "b", "differs"),
    [
        (100.0, 100.0 * (1 + 1e-9), False),
        (100.0, 100.01, True),
        (1e-12, 0.0, False),
        (1e-12, -3e-12, False),
        (1e-3, 0.0, True),
        (math.nan, math.nan, False),
        (math.nan, 1.0, True),
        (math.inf, math.inf, False),
        (math.inf, 1.0, True),
        (5.0, -5.0, True),
    ],
)
def test_the_last_digits_are_no_difference(gamma_results: Results, a: float, b: float, differs: bool) -> None:
    """Beside a force of 1000 N, 10⁻¹² N are what is left of a sum that is zero."""
    sides = [results_of(gamma_results, published("large", 1000.0), published("force", x)) for x in (a, b)]
    assert bool(compare({}, {}, *sides).values) is differs


def test_numbers_without_a_unit_are_not_measured_by_each_other(gamma_results: Results) -> None:
    sides = [
        results_of(gamma_results, published("reynolds", 1e9, ""), published("loss_factor", x, "")) for x in (1e-6, 2e-6)
    ]
    assert [d.id for d in compare({}, {}, *sides).values] == ["engine.loss_factor"]


@pytest.mark.parametrize(
    ("a", "b", "length", "size"), [(359.0, 1.0, 10.0, 2 / 180), (10.0, 190.0, 10.0, 1.0), (0.0, 90.0, 1e-12, None)]
)
def test_phases_are_compared_the_shorter_way(
    gamma_results: Results, a: float, b: float, length: float, size: float | None
) -> None:
    """A vector of no length has no phase."""
    sides = [
        results_of(gamma_results, published("large", 1000.0), published("v", length), published("v_phase", x, "°"))
        for x in (a, b)
    ]
    found = compare({}, {}, *sides).values
    assert [d.relative for d in found] == ([pytest.approx(size)] if size is not None else [])


def test_a_limit_that_turns_into_advice_differs(gamma_results: Results) -> None:
    checks = [made_check(1.0, "<=", 2.0, kind, "N", id="engine.x") for kind in ("limit", "advice")]
    found = compare({}, {}, *(results_of(gamma_results, checks=(c,)) for c in checks)).checks
    assert len(found) == 1 and found[0].relative == 0 and not found[0].moved
    assert check_table(found, ("A", "B"), str).rows[0][3] == "≤ 2 N → ≤ 2 N (advice)"


finite = st.floats(allow_nan=False, allow_infinity=False, width=32)


@given(finite, finite)
def test_the_relative_difference_is_symmetric_and_bounded(a: float, b: float) -> None:
    assert relative(a, b) == relative(b, a)
    assert 0 <= relative(a, b) <= 2 and (relative(a, b) == 0) == (a == b)


@given(st.floats(-360, 360), st.floats(-360, 360))
def test_a_turn_is_half_a_turn_at_most(a: float, b: float) -> None:
    assert -180 <= turn(a, b) <= 180
    assert math.isclose(math.cos(math.radians(a + turn(a, b))), math.cos(math.radians(b)), abs_tol=1e-9)


# --- tables
@given(finite, finite)
def test_two_numbers_can_be_told_apart(a: float, b: float) -> None:
    texts = pair(a, b)
    assert (texts[0] != texts[1]) or relative(a, b) < 1e-11


def test_how_a_change_is_said() -> None:
    def said(a: float, b: float, unit: str = "N", id: str = "engine.force") -> str:
        return change_text(ValueDifference(id, "", unit, a, b, 1.0))

    assert said(100, 150) == "+50 %" and said(100, 50) == "−50 %" and said(-2, 2) == "+200 %" and said(0, 2) == "from 0"
    assert (
        said(350, 10, "°", "engine.force_phase") == "+20°"
        and said(90, 100, "°C") == "+10 K"
        and said(1e-9, 1) == "> +99999 %"
    )


def test_the_tables_have_a_row_for_each_difference(found: Comparison) -> None:
    names = ("β", "γ")
    assert len(input_table(found.inputs, names).rows) == len(found.inputs)
    assert [row[0] for row in verdict_table(found, names, str).rows] == [step.title for step in STEPS]
    shaft, row = found.verdicts[2], verdict_table(found, names, str).rows[2]
    assert (
        row[0] == "Counter-shaft"
        and str(row[2]).startswith(f"{shaft.b.verdict}: ")
        and f"{shaft.b.counts.cautions} cautions" in row[2]
    )
    table = check_table(found.checks, names, str)
    assert [row[0] for row in table.rows] == [d.id for d in found.checks]
    assert all(len(row) == len(table.columns) for row in table.rows)
    values = value_table("gears", "Gears", [d for d in found.values if d.step == "gears"], names, ids=False)
    assert all(len(row) == len(values.columns) for row in values.rows) and ("β", "") in values.columns
    bolts = next(d for d in found.inputs if d.key == "shafts.shaft.bolts")
    assert "thread = M10x1.5, torque_Nm = 45" in str(input_table([bolts], names, full=True).rows[0][2])


@pytest.mark.parametrize("name", sorted(path.name for path in (ROOT / "tests" / "data" / "designs_0_1").glob("*.toml")))
def test_a_file_and_the_same_upgraded_do_not_differ(name: str) -> None:
    former, today = (read(ROOT / "tests" / "data" / folder / name) for folder in ("designs_0_1", "upgraded"))
    assert inputs(former.data, today.data) == []
