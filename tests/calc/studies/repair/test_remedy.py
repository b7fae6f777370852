# SPDX-License-Identifier: Apache-2.0
"""The nearest passing design: it passes when solved afresh, or it is said why there is none; nothing is changed in
place."""

from copy import deepcopy

import pytest

from calc.bearings.plain.selection.search import nearest_row, search
from calc.design.addresses import parse_assignment
from calc.design.step_inputs import bearings_case
from calc.design.toml_file import Document, design, read
from calc.sheet.errors import Cancelled
from calc.solve import Results, solve
from calc.studies.repair.nearest import nearest, remedy
from calc.studies.repair.state import broken, state_of, warned
from tests.conftest import DESIGNS, SCREENED


def damaged(name: str, *changes: str) -> Document:
    return with_changes(read(DESIGNS / f"{name}.toml"), changes)


def with_changes(document: Document, changes: tuple[str, ...]) -> Document:
    for change in changes:
        document = document.with_value(*parse_assignment(change))
    return document


def fails(results: Results) -> list[str]:
    unsolved = [key for key, outcome in results.outcomes.items() if outcome.state in ("no_solution", "blocked")]
    return unsolved + [c.id for c in results.checks() if c.verdict == "fail"]


DAMAGED = [
    ("r753ie4_gamma",),
    ("r753ie4_beta",),
    ("finotti_gear_sheet",),
    ("r753ie4_sized", "shafts.shaft.bearings.front.length_mm=20"),  # too short
    ("r753ie4_sized", "shafts.shaft.bearings.rear.length_mm=60"),  # runs into the sector
    ("r753ie4_sized", "bearings.oil=SAE 10W", "locked.engine=bought"),  # which leaves the oil free
    ("r753ie4_sized", "gears.wheels.central.span_allowance_um=[100, 80]"),  # jams
    (
        "r753ie4_sized",
        "gears.wheels.central.profile_shift=-1.2",
        "gears.wheels.central.position_mm=",
    ),  # contradicts the distances
    ("r753ie4_sized", "gears.wheels.idler.tip_shortening_mm=2.5"),  # hands over too late
    ("timing_pair", "gears.wheels.0.profile_shift=-1"),  # undercut
    ("timing_pair", "gears.power_kW=60"),  # too weak
    ("r753ie4_sized", "shafts.shaft.outer_radius_mm=38"),  # too small to size a shaft in
    ("r753ie4_gamma", "shafts.shaft.masses.front.mass_kg=2.0"),
    ("r753ie4_gamma", "shafts.shaft.masses.front.angle_deg=180"),
    ("r753ie4_gamma", "shafts.shaft.masses.rear.z_mm=60"),
    (SCREENED, "shafts.shaft.masses.0.mass_kg=5"),
    ("r753ie4_gamma", "shafts.shaft.bolts.torque_Nm=5"),  # nothing is made for it: one number at a time
]


QUICK = (*DAMAGED[::4], *DAMAGED[10:12])  # one of each kind


@pytest.mark.parametrize(
    "case", [case if case in QUICK else pytest.param(case, marks=pytest.mark.slow) for case in DAMAGED], ids=" ".join
)
def test_the_nearest_design_passes_when_it_is_solved_afresh(case: tuple[str, ...]) -> None:
    document = damaged(*case)
    before = deepcopy(document.data)
    results = solve(design(document))
    assert fails(results)
    found = nearest(document, results)
    assert document.data == before
    assert found.nothing_fails and not found.left
    again = with_changes(document, found.changes)
    assert again.data == found.document.data
    assert fails(solve(design(again))) == []
    assert found.words and all(one.words and one.mends for one in found.remedies)


def test_the_remedies_follow_each_other_and_each_says_what_it_mends(gamma: Document, gamma_results: Results) -> None:
    found = nearest(gamma, gamma_results)
    assert [one.step for one in found.remedies] == ["bearings", "gears"]
    mends = [id for one in found.remedies for id in one.mends]
    assert sorted(mends) == sorted(fails(gamma_results))
    first, second = found.remedies
    assert first.said == first.results.outcomes["bearings"].words() and not first.breaks
    assert {id.split(".")[0] for id in fails(first.results)} == {"gears"}
    assert "front roughness Ra, journal 0.6 → 0.4 µm" in first.words and "oil" not in first.words  # the engine's
    assert "span allowance of central −2/−20 →" in second.words
    assert second.results is found.results


# the search moves both lengths
NEEDLESS = ("twin_drive", "shafts.shaft.bearings.front.length_mm=12.5", "bearings.supply_pressure_bar=2.4")


@pytest.mark.parametrize("case", [("r753ie4_gamma",), NEEDLESS], ids=" ".join)
def test_no_change_is_named_without_which_it_would_pass(case: tuple[str, ...]) -> None:
    document = damaged(*case)
    found = nearest(document)
    whole = state_of(found.document, found.results)
    for change in found.changes:
        less = state_of(with_changes(document, tuple(one for one in found.changes if one != change)))
        worse = fails(less.results) or broken(whole, less) or warned(whole.results, less.results)
        assert worse, change


def test_one_step_alone(gamma: Document, gamma_results: Results) -> None:
    gears = remedy(gamma, "gears", gamma_results)
    assert gears.changes and not gears.left and not gears.results.outcomes["gears"].verdict == "fail"
    assert gears.results.outcomes["bearings"].verdict == "fail"
    sound = remedy(gamma, "countershaft", gamma_results)
    assert not sound.changes and not sound.left


def test_no_row_of_the_search_is_nearer_than_the_nearest_bearings(gamma: Document, gamma_results: Results) -> None:
    """Which asks for the fewest steps of smoother surfaces, then for the smallest change; `choose` wants friction."""
    case = bearings_case(design(gamma), solve, gamma_results)
    row = nearest_row(case).row
    assert row is not None
    rows = search(case).rows
    assert all((row.level, row.change) <= (other.level, other.change) for other in rows) and row.power > rows[0].power


def test_no_micrometre_more_than_needed_comes_off_the_spans(gamma: Document, gamma_results: Results) -> None:
    found = remedy(gamma, "gears", gamma_results)
    assert len(found.changes) >= 2
    for change in found.changes:
        key, (upper, lower) = parse_assignment(change)
        thicker = found.document.with_value(key, [upper + 1, lower + 1])
        limits = [c for c in solve(design(thicker)).checks() if c.kind == "limit" and ".backlash" in c.id]
        assert any(c.narrow or c.finding != "pass" for c in limits)


def test_results_of_another_design_are_not_believed(gamma: Document, gamma_results: Results) -> None:
    other = damaged("r753ie4_sized")
    assert nearest(other, gamma_results).changes == ()


@pytest.mark.slow
def test_what_can_not_be_mended_is_said() -> None:
    found = nearest(damaged("r753ie4_sized", "gears.wheels.shaft.teeth=24"), tries=0)
    assert not found.nothing_fails
    left = {one.id: one for one in found.left}
    assert "the search was ended there" in left["gears.train.speed_ratio"].why
    assert "gears.train.speed_ratio" in fails(found.results)


def test_an_idler_that_touches_the_cover_gets_the_nearest_teeth_that_do_not() -> None:
    found = remedy(damaged("r753ie4_sized", "gears.walls.cover-below.to_mm=[80,165]"), "gears", tries=0)
    assert (
        found.mends == ("gears.idler.clearance",)
        and not found.left
        and found.changes[0] == "gears.wheels.idler.teeth=37"
    )


@pytest.mark.slow
def test_an_idler_that_touches_is_repaired_beside_axes_that_are_off_their_distance() -> None:
    """Other teeth of the idler put no two other axes right: first these, then the idler."""
    apart = "gears.meshes.1.centre_distance_mm=82.6", "gears.meshes.2.centre_distance_mm=70.7"
    found = remedy(damaged("r753ie4_sized", "gears.wheels.idler.teeth=41", *apart), "gears", tries=0)
    assert not found.left and {"gears.idler.clearance", "gears.crank_central.position"} <= set(found.mends)


def test_where_no_teeth_of_the_idler_help_it_is_said() -> None:
    found = remedy(damaged("r753ie4_sized", "gears.walls.cover-below.to_mm=[140,140]"), "gears", tries=0)
    assert not found.changes and "gears.idler.clearance" in {one.id for one in found.left}


def test_a_part_that_is_mended_is_kept_where_another_is_not() -> None:
    document = damaged("r753ie4_gamma", "gears.wheels.shaft.teeth=24")
    found = remedy(document, "gears", tries=0)
    assert found.changes and any(".backlash" in id for id in found.mends)
    assert [one.id for one in found.left] == ["gears.train.speed_ratio"] and found.said.startswith(
        "still fails: Speed ratio"
    )


@pytest.mark.parametrize(
    "case", [("r753ie4_gamma",), ("r753ie4_sized", "gears.wheels.central.profile_shift=-1.2")], ids=" ".join
)
@pytest.mark.parametrize("call", [1, 2])
def test_it_can_be_stopped_at_any_call(case: tuple[str, ...], call: int) -> None:
    document = damaged(*case)
    calls: list[float] = []

    def stop(share: float, what: str) -> None:
        calls.append(share)
        if len(calls) == call:
            raise Cancelled

    with pytest.raises(Cancelled):
        nearest(document, progress=stop)
    assert len(calls) == call


def test_the_progress_goes_from_nothing_up_to_at_most_all() -> None:
    said: list[tuple[float, str]] = []
    nearest(damaged("r753ie4_gamma"), progress=lambda share, what: said.append((share, what)))
    shares = [share for share, _ in said]
    assert all(0 <= share <= 1 for share in shares) and shares == sorted(shares) and len(said) > 3
    assert all(what for _, what in said)
