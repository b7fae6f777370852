# SPDX-License-Identifier: Apache-2.0
"""Figures and tables of the drive over speed: what they draw is what is published, and what they must be by balance."""

import numpy as np
import pytest

from calc.design.toml_file import design, read
from calc.gears.drive import curves as drawn
from calc.gears.drive.tables import CHAIN, chain_table, map_rows, over_speed_table, sentence
from calc.sheet.step import Curve
from calc.solve import Results, solve
from calc.studies.headlines import GIVES, drive_row, governing_safeties, lead, main_numbers
from tests.calc.gears.drive.over_speed import known_drive
from tests.conftest import DESIGNS


@pytest.fixture(scope="module")
def results() -> Results:
    return known_drive()


@pytest.fixture(scope="module")
def figures(results: Results) -> dict[str, Curve]:
    return {curve.id: curve for curve in drawn.curves(results.train.drive)}


def by_label(curve: Curve) -> dict[str, tuple[np.ndarray, np.ndarray]]:
    return {str(series.label): (series.x, series.y) for series in curve.series}


# --- strikes over speed


def test_the_step_has_the_figures_of_its_drive(results: Results, figures: dict[str, Curve]) -> None:
    of_step = [curve.id for curve in results.outcomes["gears"].curves]
    assert set(figures) <= set(of_step)
    assert [curve.id for curve in figures.values() if curve.short] == ["strikes_over_speed", "backlash_window"]


def test_strikes_over_speed_begin_with_what_is_published(results: Results, figures: dict[str, Curve]) -> None:
    curve, drive = figures["strikes_over_speed"], results.train.drive
    lines = by_label(curve)
    for words, op in (("no load", "idle"), ("full load", "idle_full")):
        x, y = lines[words]
        u = max(mesh.operations[op].impact_speed for mesh in drive.meshes.values())
        assert len(x) == 60 and x[0] == 900.0 and x[-1] == 2600.0
        assert y[0] == pytest.approx(u * 1e3, rel=1e-9)
    assert lines["full load"][1].max() == pytest.approx(93.5, abs=0.5)  # near 1560 rpm
    assert curve.point == pytest.approx((900.0, 58.1), abs=0.05) and not curve.fails
    assert [limit for _, limit in curve.limits] == pytest.approx([35.0, 70.0])


def test_strikes_that_are_harder_between_the_judged_speeds_are_said(results: Results) -> None:
    """Of the twin the map peaks near 1040 rpm, between the judged 715 and 1150 rpm; of the R753 at full load the judged
    1518 rpm has all but 1 %."""
    twin = solve(design(read(DESIGNS / "twin_drive.toml")), compared=False)
    (told,) = (str(note) for note in twin.outcomes["gears"].notes if "between these some are harder" in note)
    curve = next(curve for curve in drawn.curves(twin.train.drive) if curve.id == "strikes_over_speed")
    x, y = by_label(curve)["any load"]
    judged = twin.train.drive.survey.impacts.speed.max(axis=1) * 1e3
    assert y.max() > 1.2 * judged.max()
    assert f"{y.max():.0f} mm/s and " in told and f"{x[y.argmax()]:.0f} rpm, any load" in told
    forces = twin.train.drive.drive.drawn().impacts.high.max() / twin.train.drive.survey.impacts.high.max()
    assert f"{100 * (forces - 1):.0f} % more force" in told and f"{100 * (1 - 1 / forces):.0f} % against" in told
    assert not any("between these some are harder" in note for note in results.outcomes["gears"].notes)


def test_the_bar_of_the_reversal_lies_under_the_axis(results: Results, figures: dict[str, Curve]) -> None:
    x, y = by_label(figures["strikes_over_speed"])["flanks part"]
    ends = [(mesh.reversal_from * 60, mesh.reversal_to * 60) for mesh in results.train.drive.meshes.values()]
    assert x.tolist() == [min(low for low, _ in ends), max(high for _, high in ends)] and (y < 0).all()


# --- a working cycle


def spikes(curve: Curve, label: str) -> np.ndarray:
    """How far each spike of a flank stands out, in shares of the longest."""
    _, y = by_label(curve)[label]
    out = np.abs(y - y[0])
    return out[out > 0] / out.max()


def test_a_body_moves_between_its_flanks(results: Results, figures: dict[str, Curve]) -> None:
    drive, curve = results.train.drive, figures["cycle_way_idle"]
    x, y = by_label(curve)["way"]
    J = drive.survey.strikes.backlash[drive.at["idle"], 2] * 1e6
    assert (x[0], y.max(), y.min()) == pytest.approx((0.0, 0.0, -J)) and 719 <= x[-1] < 720
    strikes = [len(spikes(curve, f"{flank} flank, its strikes")) for flank in ("driving", "coast")]
    assert strikes == [3, 3] and sum(strikes) == drive.meshes["idler_shaft"].operations["idle"].impacts
    # a strike stands where the way reaches its flank
    tips, out = by_label(curve)["driving flank, its strikes"]
    for angle in tips[out > 0]:
        before, at = y[int(angle) - 2], y[int(angle) + 2]
        assert before < -10.0 and at == pytest.approx(0.0, abs=1.0)


@pytest.mark.parametrize("op", ["idle", "hardest"])
def test_force_and_strikes_together_are_the_drag(results: Results, op: str) -> None:
    """Over a cycle nothing is gained: pressure and blows, those of the coast flank against it, carry the drag."""
    drive = results.train.drive
    p, body = drive.at[op], 2
    curve = next(c for c in drawn.cycles(drive) if c.id == f"cycle_force_{op}")
    of, hits = drive.survey.closed, drive.survey.strikes
    blows = of.mass[body] * (hits.speed[p, body] * hits.flank[p, body]).sum() / hits.orbit[p, body]
    assert curve.series[0].y.mean() + blows == pytest.approx(
        of.drag[p, body], abs=0.02 * np.abs(curve.series[0].y).max()
    )
    assert (curve.series[0].y == 0).any()  # in flight


def test_the_cycle_is_walked_over_speed_and_load(figures: dict[str, Curve]) -> None:
    walk = figures["cycle_way_idle"].walk
    assert (walk.steps, walk.rows, walk.here) == (12, 3, (0, 0))
    assert walk.at(0, 0).title == figures["cycle_way_idle"].title == "900 rpm, no load: idler–shaft between its flanks"
    assert (
        walk.at(4, 2).title
        == figures["cycle_way_hardest"].title
        == "1518 rpm, full load: idler–shaft between its flanks"
    )
    np.testing.assert_array_equal(walk.at(4, 2).series[0].y, figures["cycle_way_hardest"].series[0].y)
    assert figures["cycle_force_idle"].stack == figures["cycle_way_idle"].stack != figures["cycle_way_hardest"].stack


# --- the window


def test_the_window_is_shut_between_jam_and_rattle(results: Results, figures: dict[str, Curve]) -> None:
    drive, lines = results.train.drive, by_label(figures["backlash_window"])
    marks = {label.rpartition(" ")[0].rpartition(" ")[0]: x[0] for label, (x, _) in lines.items() if len(x) == 2}
    assert set(marks) == {"may jam below", "may rattle above", "nominal", "largest, warm"}
    assert marks["may jam below"] == pytest.approx(drive.window_low * 1e6)
    assert marks["may rattle above"] == pytest.approx(drive.window_high * 1e6)
    assert marks["may rattle above"] < marks["may jam below"]  # shut
    quiet_b = marks["may rattle above"] + marks["largest, warm"] - marks["nominal"]
    assert drive.backlash_quiet_b * 1e6 == pytest.approx(quiet_b)
    J, u = lines["hardest strike"]
    for grade, speed in ((drive.backlash_quiet_a, 35.0), (drive.backlash_quiet_b, 70.0)):
        assert np.interp(grade * 1e6, J, u) == pytest.approx(speed, rel=5e-3)
    assert np.interp(marks["nominal"], J, u) == pytest.approx(drive.impact_speed * 1e3, rel=5e-3)


# --- tables


def test_every_mesh_stands_at_idle_and_where_it_is_hardest(results: Results) -> None:
    table = over_speed_table(results.train, results.train.drive)
    assert [str(row[0]) for row in table.rows] == [
        f"{pair}, {where}"
        for pair in ("crank–central", "central–idler", "idler–shaft")
        for where in ("idle: B", "largest force")
    ]
    idle, hardest = table.rows[4:]
    at = results.train.drive.meshes["idler_shaft"].operations
    assert idle[1] == at["idle"].impact_speed * 1e3 and hardest[3] == at["hardest"].impact_power
    low, high = (float(x) for x in str(hardest[2]).split(" to "))
    assert low == pytest.approx(at["hardest"].impact_force_low, rel=5e-3)
    assert high == pytest.approx(at["hardest"].impact_force, rel=5e-3)
    mesh = results.train.meshes["idler_shaft"].over_speed
    assert str(hardest[5]) == f"{mesh.strike_safety_contact:.2f} to {mesh.strike_safety_contact_low:.2f}"
    assert idle[5] is idle[6] is None and "never one number" in table.note and table.short


def test_the_chain_lies_about_the_estimates(results: Results) -> None:
    """Each low estimate below its high one, and the chain's forces within what the note says."""
    assert len(chain_table().rows) == len(CHAIN) == 7 and not chain_table().short
    for _, low, high, chain, _ in CHAIN:
        spans = [tuple(map(float, span.split("–"))) for span in chain.split(", ")]
        for of_low, of_high, (least, most) in zip(
            map(float, low.split()), map(float, high.split()), spans, strict=True
        ):
            assert of_low <= of_high and least <= most and 0.60 <= most / of_low <= 11 and most / of_high <= 1.87


def test_the_map_begins_and_ends_with_what_is_published(results: Results) -> None:
    header, rows = map_rows(results.train.drive)
    assert len(rows) == 180 and len(header) == len(rows[0]) == 2 + 3 * 6
    first, last = dict(zip(header, rows[0])), dict(zip(header, rows[-1]))
    assert (first["speed [rpm]"], first["load [%]"]) == (900.0, 0.0)
    assert (last["speed [rpm]"], last["load [%]"]) == (2600.0, 100.0)
    for row, op in ((first, "idle"), (last, "rated")):
        at = results.train.drive.meshes["central_idler"].operations[op]
        assert row["central_idler.separation"] == pytest.approx(at.separation, rel=1e-9)
        assert row["central_idler.least_force [N]"] == pytest.approx(at.least_force, rel=1e-9)
        assert row["central_idler.impact_speed [mm/s]"] == pytest.approx(at.impact_speed * 1e3, rel=1e-9)
        assert row["central_idler.impact_force_low [N]"] == pytest.approx(at.impact_force_low, rel=1e-6)
        assert row["central_idler.impact_force [N]"] == pytest.approx(at.impact_force, rel=1e-6)
        assert row["central_idler.impact_power [W]"] == pytest.approx(at.impact_power, rel=1e-9)


# --- in words


def test_the_sentence(results: Results) -> None:
    assert lead(results, "gears") == (
        "Rattle at idle, no load: B, strikes at 58 mm/s on both flanks (A up to 35, B up to 70); teeth then carry some "
        "1.8 to 3.0 kN."
    )
    assert lead(results, "gears", brief=True) == (
        "Rattle at idle, no load: B, strikes at 58 mm/s on both flanks; teeth then carry some 1.8 to 3.0 kN."
    )
    assert lead(results, "engine") is None


def test_a_default_is_said_with_what_to_give(gamma_results: Results) -> None:
    words = sentence(gamma_results.train)
    assert words.startswith("Rattle at idle, no load: ") and words.endswith(
        "This rests on an irregularity of 5 % at idle, 600 rpm, a default that knows no load: give the gas and "
        "the inertia of the flywheel."
    )
    assert GIVES["gears"](gamma_results).startswith("backlash")  # which no default decides


def test_an_irregularity_that_is_taken_is_that_of_any_load(gamma_results: Results) -> None:
    tables = {table.id: table for table in gamma_results.outcomes["gears"].tables}
    assert str(tables["drive_over_speed"].title).count("any load") == 2


def test_the_headline(results: Results) -> None:
    assert GIVES["gears"](results) == "rattle B 58 mm/s"


def test_the_safeties_that_govern_are_those_of_the_strikes(results: Results, gamma_results: Results) -> None:
    governing = governing_safeties(results)
    S_H = [mesh.over_speed.strike_safety_contact for mesh in results.train.meshes.values()]
    S_F = [wheel.strikes.strike_safety_bending_low for wheel in results.train.wheels.values()]
    assert governing["S_H"].high.shown == pytest.approx(min(S_H), rel=1e-9)
    assert governing["S_F"].low.shown == pytest.approx(min(S_F), rel=1e-9)
    assert governing["S_H"].words == "0.94 to 1.08" and governing["S_F"].words == "1.10 to 1.49"
    numbers = dict(main_numbers(results))
    assert numbers["rattle at idle"] == "B 58 mm/s (A ≤ 35, B ≤ 70)"
    assert numbers["S_H"] == "0.94 to 1.08 under strikes" and numbers["S_F"] == "1.10 to 1.49 under strikes"
    assert not governing_safeties(gamma_results)  # a motion that is assumed governs nothing
    assert "strikes" not in dict(main_numbers(gamma_results))["S_H"]


def test_the_row_of_the_first_page(results: Results, gamma_results: Results) -> None:
    title, words = drive_row(results)
    assert title == "Drive at idle / largest force"
    assert words == (
        "grade B; strikes of 58 / 92 mm/s at 900 rpm, no load / 1518 rpm, full load; force some 1.8 to 3.0 kN / 3.0 to "
        "4.9 kN; power about 0.92 / 4 W at most; under strikes S_H 0.94 to 1.08, S_F 1.10 to 1.49"
    )
    assert drive_row(gamma_results)[1].endswith("a default that knows no load: give the gas and the flywheel")
