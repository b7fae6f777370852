"""What the search for bearings says beside its tables: what is nearest where nothing passes, which diameters were
looked at, which rows."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from calc.bearings.plain.checks import FILM_EDGE_SHEARED, FILM_EDGE_SPLIT, MCKEE, on_bearing
from calc.bearings.plain.selection.ranking import closest, picks
from calc.bearings.plain.selection.search import fields_of, nothing
from calc.bearings.plain.selection.tables import RULES, _diameters, choices_table, hidden, notes, rows_of, summary
from calc.sheet.search import least


@pytest.fixture(scope="module")
def thin_and_thick(found):
    """The fields of the design's oil and of the thinnest."""
    variants = [found.variants[0], next(v for v in found.variants if v.oil == "SAE 10W")]
    return [(v, fields_of(v, found.tasks)) for v in variants]


def test_the_closest_has_the_largest_least_margin_of_all_fields(found, thin_and_thick):
    """In whichever order the fields stand."""
    (_, one), (_, other) = thin_and_thick
    for fields in ({p: [*one[p], *other[p]] for p in one}, {p: [*other[p], *one[p]] for p in one}):
        for place, pick in zip(("front", "rear"), closest(fields, found.slopes[0])):
            margins = [float(least(field.judged(found.slopes[0][place]).values()).max()) for field in fields[place]]
            assert margins[0] != margins[1] and pick.margin == pytest.approx(max(margins), abs=1e-3)
            assert pick.margin == min(check.margin for check in pick.checks) == pick.governing.margin
    assert closest({"front": [], "rear": one["rear"]}, found.slopes[0]) is None


def test_where_nothing_passes_the_nearest_is_named_with_what_stops_it(found, thin_and_thick):
    """Of the variants the one whose worse bearing misses least; here by its governing limit, and with the advice of
    that."""
    said = nothing(thin_and_thick, found.slopes[0])
    margins = {v.name: min(one.margin for one in closest(fields, found.slopes[0])) for v, fields in thin_and_thick}
    best = max(margins, key=margins.get)
    worse = min(
        closest(dict(thin_and_thick)[next(v for v, _ in thin_and_thick if v.name == best)], found.slopes[0]),
        key=lambda one: one.margin,
    )
    assert (
        str(said.tried).startswith(f"nearest: {best}, front ") and f"needs {worse.governing.limit_text()}" in said.tried
    )
    assert said.advice == worse.governing.advice and (f"corner: {worse.corner}" in said.tried) == bool(worse.corner)
    assert "no bearing is left to look at" in str(nothing([], found.slopes[0]))


def test_whatever_is_worst_in_a_row_has_a_word(found):
    """Every rule, at the corners and as given, has one that fits its column; a check without one has its name."""
    first = found.rows[0]
    tasks = (first.picks[0].task, replace(first.picks[0].task, corners=False))
    checks = [c for task in tasks for c in picks(task, [0.03], [80e-6], 0.0)[0].checks]
    asked = set(first.picks[0].task.rules) - {FILM_EDGE_SPLIT}  # of shells alone
    asked -= {FILM_EDGE_SHEARED} if first.picks[0].task.shear is None else set()
    assert {c.rule for c in checks} == asked and asked <= set(RULES)

    def by(check):
        front, rear = first.picks
        worst = replace(first, picks=(replace(front, governing=check, margin=-1.0), rear))
        table = choices_table(replace(found, now=None, rows=(worst,)), 1)
        return table.rows[0][[label for label, _ in table.columns].index("by")]

    assert all(by(check) == f"{RULES[check.rule]} F" and len(by(check)) <= 11 for check in checks)
    assert by(on_bearing(MCKEE, "front", 100.0, 150.0)) == "McKee number, cP·rpm/psi, front F"


# --- notes
def free(found, best):
    """As if three front diameters were looked at and the rows had these."""
    task = found.tasks["front"][0]
    looked = [
        replace(task, seat=replace(task.seat, bearing=replace(task.seat.bearing, diameter=d)))
        for d in (0.0595, 0.0505, 0.0685)
    ]
    rows = [SimpleNamespace(picks=(SimpleNamespace(diameter=d), SimpleNamespace(diameter=0.081))) for d in best]
    return SimpleNamespace(tasks={"front": looked, "rear": found.tasks["rear"]}, rows=rows, case=found.case)


@pytest.mark.parametrize("best, end", [([0.0595, 0.0685], ""), ([0.0685, 0.0595], "68.5 mm"), ([0.0505], ""), ([], "")])
def test_a_best_diameter_at_the_upper_end_of_those_looked_at_is_said(found, best, end):
    front, rear, shares = _diameters(free(found, best))
    assert front.startswith("The front diameter is free: 50.5, 59.5, 68.5 mm are looked at")
    assert (f"{end}, in the first row, is the end of it" in front) if end else "is the end of it" not in front
    assert rear.startswith("The rear diameter stays as it is") and "every diameter" in shares


@pytest.mark.parametrize(
    "numbers, said",
    [
        ([1], "row 1"),
        ([1, 2], "rows 1 to 2"),
        ([3, 5], "rows 3 and 5"),
        ([1, 2, 3, 7, 9, 10], "rows 1 to 3, 7 and 9 to 10"),
    ],
)
def test_numbers_of_rows_are_put_together(numbers, said):
    assert rows_of(numbers) == said


@pytest.mark.parametrize(
    "rows, beyond, top, said",
    [
        (8, 0, 8, ""),
        (8, 4, 12, ""),
        (8, 0, 5, "Rows 6 to 8: --top 8."),
        (0, 4, 2, "Rows 3 to 4: --top 4."),
        (8, 4, 5, "Rows 6 to 12: --top 12 (from 9 on too long for their room)."),
        (8, 4, 10, "Rows 11 to 12: --top 12 (from 11 on too long for their room)."),
    ],
)
def test_what_is_hidden_is_said_with_how_to_see_it(rows, beyond, top, said):
    assert hidden(SimpleNamespace(rows=range(rows), beyond=range(beyond)), top) == said


def test_what_fails_elsewhere_what_was_dropped_and_what_the_fits_take_is_said(found):
    check = found.rows[0].picks[0].governing
    more = replace(found, elsewhere={2: (check,), 5: (check,)}, dropped=("one", "other"), placed=True)
    said = "\n".join(notes(more))
    assert (
        f"Then open, with row 2, 5: {check.id} (" in said
        and "Dropped once the whole design was solved: one; other." in said
    )
    assert "takes their widths alone" in said
    assert f"Solved as whole designs: {rows_of(list(found.verified))}; the others" in said
    plain = "\n".join(notes(replace(found, elsewhere={}, dropped=())))
    assert not any(words in plain for words in ("Then open", "Dropped", "takes their widths"))


def test_what_changes_in_the_first_row_is_said(found):
    """Oil and supply besides the sizes, and what it saves; the design itself where nothing changes; which row has its
    own oil, supply and surfaces, or why none."""
    first = found.rows[0]
    other = next(v for v in found.variants if v.oil != found.variants[0].oil and v.supply != found.variants[0].supply)
    words = summary(replace(found, rows=(replace(first, variant=other), *found.rows[1:]), own=3))
    assert words[-2].startswith(f"Row 1: oil {other.oil}, supply by ") and "front length 27.5 → " in words[-2]
    assert f" W in place of {found.now.power:.3g} W." in words[-2]
    assert words[-1] == "With the design's own oil, supply and surfaces: row 3."
    lost = replace(found, own=0, refused=((found.variants[0], "too thin"),))
    assert summary(lost)[-1] == "No row has the design's own oil, supply and surfaces: too thin."
    assert summary(replace(found, rows=())) == ()
    as_it_is = replace(
        first,
        variant=found.variants[0],
        picks=tuple(
            replace(pick, task=replace(pick.task, length=pick.length, clearance=pick.clearance, level=0))
            for pick in first.picks
        ),
    )
    assert np.isclose(as_it_is.change, 0)
    assert summary(replace(found, rows=(as_it_is,), own=1)) == (
        "Row 1 is the design as it is: it keeps every rule of the search.",
    )
