# SPDX-License-Identifier: Apache-2.0
"""What a comparison comes to: the way of each key result and verdict, and labels that say what they are of."""

from dataclasses import replace
from pathlib import Path

import pytest

from calc.design.key_results import is_least, key_results
from calc.design.names import in_context
from calc.design.toml_file import Document, design, read
from calc.sheet.quantity import Described, Published
from calc.sheet.text import Text
from calc.solve import Results, solve
from calc.studies.compare import NOTABLE, Comparison, KeyResult, compare, inputs
from calc.studies.compare_tables import input_table, moved_table, result_table, sentences
from tests.conftest import DESIGNS

NAMES = ("beta", "gamma")


@pytest.fixture(scope="module")
def found(gamma: Document, gamma_results: Results) -> Comparison:
    beta = read(DESIGNS / "r753ie4_beta.toml")
    return compare(beta.data, gamma.data, solve(design(beta)), gamma_results)


def result(a: float, b: float, *, least: bool) -> KeyResult:
    one, other = (
        Published("gears.x.y", number, "µm", Text("Backlash"), "", number, Described("Backlash", "µm"))
        for number in (a, b)
    )
    return KeyResult(one, other, least, abs(a - b) / max(abs(a), abs(b)))


@pytest.mark.parametrize(
    ("a", "b", "least", "better"), [(1, 2, True, True), (1, 2, False, False), (-3, -2, True, True), (2, 1, False, True)]
)
def test_better_is_the_way_of_the_quantity(a: float, b: float, least: bool, better: bool) -> None:
    assert result(a, b, least=least).better is better and result(b, a, least=least).better is not better


def test_a_difference_that_nobody_notices_is_none() -> None:
    assert result(1.0, 1.0 + 0.9 * NOTABLE, least=True).better is None
    assert replace(result(1.0, 2.0, least=True), a=None).better is None


def test_each_key_result_is_of_its_worst_part(gamma_results: Results) -> None:
    shown = {id: v.shown for id, v in gamma_results.values().items()}
    worst = {v.id.rpartition(".")[2]: v for v in key_results(gamma_results.values()).values()}
    assert worst["safety_contact"].shown == min(
        v for id, v in shown.items() if id.count(".") == 2 and id.endswith(".safety_contact")
    )
    assert worst["outlet_temperature"].shown == max(
        shown[f"bearings.{b}.outlet_temperature"] for b in ("front", "rear")
    )
    assert is_least(worst["safety_contact"]) and not is_least(worst["total_loss"])


def test_sentences_count_what_the_tables_show(found: Comparison) -> None:
    said = sentences(found, NAMES, str.upper)
    before, after = found.words
    assert said[0] == f"beta → gamma: the whole goes from {before} to {after}." and before.startswith("FAIL: ")
    moved = (f"{v.title} {v.a.verdict.upper()} → {v.b.verdict.upper()}" for v in found.steps_moved)
    assert ("Steps: " + ", ".join(moved) + "." in said) is bool(found.steps_moved)
    same = replace(found, words=(before, before))
    assert sentences(same, NAMES, str.upper)[0] == f"beta → gamma: the whole stays {before}."
    hard = [
        d
        for d in found.checks_moved
        if d.a is not None and d.b is not None and {d.a.kind, d.b.kind} & {"limit", "caution"}
    ]
    counts = [
        int(word.strip(".,"))
        for text in said
        if text.startswith("Limits and cautions to")
        for word in text.split()
        if word[0].isdigit()
    ]
    assert sum(counts) == len(hard) > 5
    table = moved_table(found, NAMES, str)
    ways = [str(row[-1]) for row in table.rows]
    assert ways == sorted(ways, key=["worse", "new", "better", "gone"].index) and ways.count("better") == sum(
        not d.worse for d in hard
    )
    short = moved_table(found, NAMES, str, 4)
    assert short.rows == table.rows[:4] and str(len(table.rows) - 4) in short.note
    ways = [str(row[-1]) for row in result_table(found, NAMES).rows]
    same = sum(r.better is None for r in found.results)
    assert (
        said[-1]
        == f"Key results: {ways.count('better')} better, {ways.count('worse')} worse, {same} the same within 0.1 %."
    )


def test_a_whole_that_changes_says_which_way(found: Comparison) -> None:
    states, texts = ("warn", "pass"), (Text("WARN: 2 cautions"), Text("PASS"))
    better = replace(found, whole=states, unaccepted=states, words=texts)
    said = sentences(better, NAMES, str)[0]
    assert said == "beta → gamma: the whole goes from WARN: 2 cautions to PASS, to the better."
    worse = replace(better, whole=states[::-1], unaccepted=states[::-1], words=texts[::-1])
    assert sentences(worse, NAMES, str)[0].endswith("goes from PASS to WARN: 2 cautions, to the worse.")
    unjudged = replace(better, whole=("pass", "not_judged"), unaccepted=("pass", "not_judged"))
    assert sentences(unjudged, NAMES, str)[0].endswith("to the worse.")


def test_labels_say_what_they_are_of(found: Comparison, gamma: Document) -> None:
    labels = [str(row[0]) for row in (*moved_table(found, NAMES, str).rows, *result_table(found, NAMES).rows)]
    assert len(set(labels)) == len(labels)
    assert "Film at the edge, rear" in labels and "Film at the bearing's edge (rear)" in labels
    assert in_context(Text("Specific load"), "bearings.front.specific_load") == "Specific load (front)"
    assert in_context(Text("Film, front"), "bearings.front.film_edge") == "Film, front"
    pitting = next(row for row in result_table(found, NAMES).rows if "pitting" in str(row[0]))
    assert "(idler–shaft)" in str(pitting[1]) and "(crank–central)" in str(pitting[2])  # the worst part is another one
    other = gamma.with_value("gears.meshes.2.support_share", 0.25)
    (row,) = input_table(inputs(gamma.data, other.data), NAMES, ids=False).rows
    assert str(row[0]).endswith("(gears, meshes, idler–shaft)")


def test_an_acceptance_is_neither_better_nor_worse(gamma: Document, gamma_results: Results) -> None:
    accepting = gamma.with_value("accepted.bearings.front.slope_given", "seen on the bench")
    there = compare(gamma.data, accepting.data, gamma_results, solve(design(accepting)))
    assert [row[-1] for row in moved_table(there, NAMES, str).rows] == ["accepted"]
    said = " ".join(sentences(there, NAMES, str))
    assert "Accepted in one of them only: warn → accepted 1." in said and "to the better" not in said
    back = compare(accepting.data, gamma.data, solve(design(accepting)), gamma_results)
    assert [row[-1] for row in moved_table(back, NAMES, str).rows] == ["no longer accepted"]


def test_a_whole_that_passes_by_what_is_accepted_alone_is_not_better() -> None:
    alpha = read(DESIGNS / "r753ie4_alpha.toml")
    results = solve(design(alpha))
    accepting = alpha
    for check in results.checks():
        if check.kind == "caution" and check.open:
            accepting = accepting.with_value(f"accepted.{check.id}", "seen")
    before, after = (_without_narrow(some) for some in (results, solve(design(accepting))))
    assert (before.verdict, after.verdict) == ("warn", "pass")
    said = sentences(compare(alpha.data, accepting.data, before, after), NAMES, str)
    n = after.counts.accepted
    cautions = "1 caution" if n == 1 else f"{n} cautions"
    assert said[0] == (
        f"beta → gamma: the whole goes from WARN: {cautions} to PASS: {n} accepted, by what is accepted."
    )
    assert not compare(alpha.data, alpha.data, before, before).only_accepted


def _without_narrow(results: Results) -> Results:
    """As if no limit held by a narrow margin."""
    outcomes = {
        key: replace(outcome, checks=tuple(check for check in outcome.checks if not check.narrow))
        for key, outcome in results.outcomes.items()
    }
    return Results(results.design, outcomes)


def test_what_is_not_usual_is_said_of_each_design_or_of_both(gamma: Document, gamma_results: Results) -> None:
    sized = read(DESIGNS / "r753ie4_sized.toml")
    there = compare(gamma.data, sized.data, gamma_results, solve(design(sized)))
    odd = "1 input is not usual: span allowance of central −2 µm (usual −80 to −20)"
    assert f"In beta {odd}." in sentences(there, NAMES, str)
    assert f"In both {odd}." in sentences(replace(there, unusual=(there.unusual[0], there.unusual[0])), NAMES, str)


def test_what_holds_outside_validity_is_not_called_a_pass(found: Comparison) -> None:
    kept = next(d for d in found.checks_kept if d.a is not None and d.a.kind == "limit" and d.before == "pass")
    safety = replace(kept, before="outside", after="outside")
    only = replace(found, checks=(replace(safety, before="pass"),))
    assert [
        (str(row[1]).split()[0], str(row[2]).split()[0], row[-1]) for row in moved_table(only, NAMES, str).rows
    ] == [("pass", "outside", "worse")]
    assert "to the worse: pass → outside 1." in " ".join(sentences(only, NAMES, str))
    assert [
        replace(safety, before=a, after=b).worse
        for a, b in (("outside", "accepted"), ("outside", "note"), ("outside", "warn"))
    ] == [False, True, True]
    lone = replace(safety, a=None, before="")
    assert [replace(lone, after=verdict).worse for verdict in ("pass", "accepted", "outside", "note")] == [
        False,
        False,
        True,
        True,
    ]


def test_of_what_got_worse_the_worst_comes_first(found: Comparison) -> None:
    one = next(d for d in found.checks_moved if d.a is not None and d.a.kind == "limit")
    moves = [replace(one, before="pass", after=after) for after in ("warn", "fail", "outside")]
    table = moved_table(replace(found, checks=tuple(moves)), NAMES, str)
    assert [str(row[2]).split()[0] for row in table.rows] == ["fail", "warn", "outside"]


KINDS = """
schema = 2
name = "two bearings"

[[shafts]]
name = "shaft"
mode = "bearings"

[[shafts.bearings]]
name = "front"
load_N = 1710.0
{front}

[[shafts.bearings]]
name = "rear"
load_N = 1710.0
diameter_mm = 81.0
length_mm = 26.5
clearance_um = 90.0
journal_roughness_um = 0.6
housing_roughness_um = 0.6

[bearings]
oil = "10W-40 Q8 T905"
supply_temperature_C = 120.0
supply_pressure_bar = 4.0
supply = "hole"
hole_diameter_mm = 4.0
housing_material = "EN AC-43100"
journal_material = "20CrNi4"
speed_rpm = 2600.0
"""
PLAIN = """diameter_mm = 59.5
length_mm = 27.5
clearance_um = 80.0
journal_roughness_um = 0.6
housing_roughness_um = 0.6"""


def test_a_film_and_a_life_are_no_more_or_less_of_each_other(tmp_path: Path) -> None:
    """They stand in one line of the first page, and the line of a bearing of another kind says another thing."""
    found = []
    for name, front in (("plain", PLAIN), ("rolling", 'kind = "rolling"\nsize = "6206"\nlocates = true')):
        (tmp_path / f"{name}.toml").write_text(KINDS.format(front=front), encoding="utf-8")
        document = read(tmp_path / f"{name}.toml")
        found.append((document, solve(design(document))))
    (a, before), (b, after) = found
    results = compare(a.data, b.data, before, after).results
    both = [(r.a, r.b) for r in results if r.a is not None and r.b is not None]
    assert both and all(one.about is other.about for one, other in both)
    assert {"bearings.front.film_edge", "bearings.front.life", "bearings.rear.film_edge"} <= {
        r.either.id for r in results
    }
