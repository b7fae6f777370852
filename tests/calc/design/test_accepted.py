"""Findings that the user accepts, and what the inputs do that move a check."""

from dataclasses import replace

import pytest

from assistant.results_text import lost_acceptances
from calc.design.toml_file import design, parse, read
from calc.sheet.errors import BadInput
from calc.solve import solve
from calc.studies.explain import effects
from calc.studies.shipped import EXAMPLE

OPEN, HOLDS, LIMIT = "bearings.front.slope_given", "bearings.rear.mckee", "bearings.front.film_edge"


def accepting(**reasons):
    """The shipped example with some findings accepted, by ids with __ for the dots."""
    document = read(EXAMPLE)
    for id, reason in reasons.items():
        document = document.with_value("accepted." + id.replace("__", "."), reason)
    return document


def test_a_finding_is_accepted_with_its_reason_and_colours_nothing():
    before, after = (
        solve(design(d)) for d in (read(EXAMPLE), accepting(bearings__front__slope_given=" seen on the bench "))
    )
    check = {c.id: c for c in after.checks()}[OPEN]
    assert {c.id: c.verdict for c in before.checks()}[OPEN] == "warn"
    assert (check.verdict, check.accepted, check.open) == ("accepted", "seen on the bench", False)
    changed = {c.id for c, d in zip(before.checks(), after.checks()) if c.verdict != d.verdict}
    assert changed == {OPEN}


@pytest.mark.parametrize(
    "id, said",
    [
        (HOLDS, "Accepted without need, since it holds: bearings.rear.mckee."),
        (
            "bearings.front.nothing",
            "Ignored: bearings.front.nothing is accepted, but this design has no such check.",
        ),
        ("gone.check", "Ignored: gone.check is accepted, but this design has no such check."),
        (LIMIT, f"Ignored: {LIMIT} is accepted, but is a limit, which nobody can accept."),
    ],
)
def test_an_entry_that_does_nothing_is_said(id, said):
    results = solve(design(accepting(**{id.replace(".", "__"): "why"})))
    assert said in [note for o in results.outcomes.values() for note in o.notes]
    assert results.verdict == solve(design(read(EXAMPLE))).verdict


def test_what_is_accepted_in_vain_is_read_and_said_in_a_line_of_check():
    """A design of another version may accept what has become a limit, or is gone: it stays a design."""
    document = accepting(**{id.replace(".", "__"): "why" for id in (LIMIT, "bearings.front.slope_givn", OPEN)})
    results = solve(design(document))
    assert {c.id: c.verdict for c in results.checks()}[LIMIT] == "fail"
    lines = [
        " ".join(line.split()) for line in " ".join(lost_acceptances(results)).replace("•", "\n•").split("\n") if line
    ]
    assert lines == [
        f"• note Ignored: {LIMIT} is accepted, but is a limit, which nobody can accept",
        "• note Ignored: bearings.front.slope_givn is accepted, but this design has no such check; did you mean "
        f"{OPEN}?",
    ]


def test_a_step_without_a_solution_may_have_the_check_that_is_accepted():
    document = accepting(bearings__front__nothing="why").with_value("countershaft.masses.front.mass_kg", 300.0)
    assert list(lost_acceptances(solve(design(document)))) == []


def test_a_reason_must_say_something():
    raw = EXAMPLE.read_bytes() + f'\n[accepted]\n"{LIMIT}" = "no"\n"{HOLDS}" = " "\n"{OPEN}" = 3\n'.encode()
    with pytest.raises(BadInput) as bad:
        design(parse(raw, "here"))
    errors = {e.key: (e.line, e.reason) for e in bad.value.errors}
    last = raw.decode().count("\n")
    assert {key: line for key, (line, _) in errors.items()} == {
        f"accepted.{HOLDS}": last - 1,
        f"accepted.{OPEN}": last,
    }
    assert "in words" in errors[f"accepted.{HOLDS}"][1]


def test_the_inputs_that_move_a_check_are_measured():
    """An allowance of the span acts micrometre for micrometre; roughness moves the limit of the film, 7.5 for each µm,
    not the film."""
    document = read(EXAMPLE)
    results = solve(design(document))
    checks = {c.id: c for c in results.checks()}
    found = effects(document, results, [checks["gears.central_idler.backlash"], checks[LIMIT]])
    backlash = {e.key: e for e in found["gears.central_idler.backlash"]}
    assert backlash["gears.wheels.central.span_allowance_um"].slope == pytest.approx(-1, rel=1e-3)
    assert backlash["gears.meshes.1.tolerance_um"].slope == pytest.approx(-2 * 0.332, rel=0.02)  # 2·sin α_wt·cos β_b
    film = {e.key: e for e in found[LIMIT]}
    assert film["shafts.shaft.bearings.front.journal_roughness_um"].slope == 0.0
    assert film["shafts.shaft.bearings.front.journal_roughness_um"].gain == pytest.approx(-7.5)
    assert film["shafts.shaft.bearings.front.length_mm"].slope == film["shafts.shaft.bearings.front.length_mm"].gain > 0
    assert film["shafts.shaft.bearings.front.length_mm"].unit == "µm/mm"
    # not given, no number
    assert film["shafts.shaft.bearings.front.clearance_um"].slope is None and film["bearings.oil"].slope is None
    shorter = solve(design(document.with_value("bearings.front.length_mm", 27.4)))
    there = {c.id: c.value for c in shorter.checks()}[LIMIT]
    assert there - checks[LIMIT].value == pytest.approx(
        -0.1 * film["shafts.shaft.bearings.front.length_mm"].slope, rel=0.02
    )


def test_a_table_stands_for_its_numbers_and_a_hopeless_change_for_nothing():
    document = read(EXAMPLE)
    results = solve(design(document))
    check = replace(
        {c.id: c for c in results.checks()}[LIMIT], moved_by=("shafts.shaft.masses", "gears.wheels.central.teeth")
    )
    found = {e.key: e for e in effects(document, results, [check])[LIMIT]}
    assert any(key.endswith("mass_kg") for key in found) and any(key.endswith("radius_mm") for key in found)
    assert not any(key == "shafts.shaft.masses" for key in found)
