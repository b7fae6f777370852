# SPDX-License-Identifier: Apache-2.0
"""The search for bearings: its candidates against the step itself, its rows against each other, and what it refuses."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from calc.bearings.plain.checks import (
    CLEARANCE_COLD,
    CLEARANCE_COLD_CORNER,
    FILM_EDGE,
    FILM_EDGE_SHEARED,
    FILM_EDGE_SPLIT,
    FILM_OVERSPEED,
    FILM_PRESSURE,
    LENGTH_RATIO,
    SPECIFIC_LOAD,
    TEMPERATURE,
)
from calc.bearings.plain.corners import corner_points, corners
from calc.bearings.plain.routes.routes import own_warm
from calc.bearings.plain.routes.thermal_balance import balanced, settled
from calc.bearings.plain.selection import search as search_
from calc.bearings.plain.selection.grid import clearances, fields, lengths
from calc.bearings.plain.selection.ranking import ONE_PER_CENT, CandidateRow, best, by_power, picks
from calc.bearings.plain.selection.search import (
    fields_of,
    in_room,
    nearest_row,
    search,
    slopes_of,
    with_surfaces,
)
from calc.bearings.plain.selection.states import judge, passes_split, room, smoother, solved
from calc.bearings.plain.selection.tables import (
    beyond_table,
    changed,
    choices_table,
    neighbours,
    neighbours_table,
    notes,
    outside,
    pareto_table,
    summary,
)
from calc.bearings.plain.selection.variants import closer_fits, tasks, tied, variants
from calc.bearings.plain.selection.writing import bearing_changes, fits_to_write, with_row
from calc.bearings.result import BearingsResult
from calc.countershaft.inputs import Section, ShaftInputs
from calc.design.step_inputs import bearings_case
from calc.design.toml_file import design, parse, read
from calc.sheet.search import least
from calc.solve import solve
from tests.conftest import DESIGNS


def nearest_passing(case):
    """The smallest change that fits and keeps every rule with the design's oil, supply and fits."""
    return nearest_row(case, only=variants(case)[:1]).row


@pytest.fixture(scope="module")
def sized():
    return bearings_case(design(read(DESIGNS / "r753ie4_sized.toml")), solve)


def task_of(source, place="front"):
    variant = variants(source)[0]
    return tasks(source)[place][0].with_oil(variant.lubricant, variant.supply)


def test_the_rules_have_the_limits_of_the_checks(source):
    """Where the journal's diameter is tied the least l/d is not asked; the outlet keeps 5 K."""
    checks = {c.id: c for c in source.results.checks()}
    for place in ("front", "rear"):
        rules = task_of(source, place).rules
        for rule in (FILM_EDGE, FILM_PRESSURE, SPECIFIC_LOAD, CLEARANCE_COLD):
            known, asked = checks[rule.of(place)], rules[rule].check
            assert (asked.limit, asked.sense, asked.unit) == (known.limit, known.sense, known.unit)
        assert rules[TEMPERATURE].check.limit == checks[TEMPERATURE.of(place)].limit - 5
        assert {rules[rule].check.limit for rule in (FILM_EDGE, FILM_EDGE_SHEARED, FILM_OVERSPEED)} == {9.0}
        assert rules[LENGTH_RATIO].check.limit == (0.2, 0.8)


@pytest.mark.parametrize(
    "place, length, clearance", [("front", 0.0275, 80e-6), ("front", 0.041, 75e-6), ("rear", 0.033, 115e-6)]
)
def test_a_candidate_is_what_the_step_finds(source, place, length, clearance):
    task = task_of(source, place)
    states = solved(task, [length], [clearance])
    seat = replace(task.seat, bearing=replace(task.seat.bearing, length=length), clearance=clearance)
    film = balanced(own_warm, seat, task.duty)
    assert states.film[0, 0] == pytest.approx(film.film, rel=1e-6)
    assert states.power[0] == pytest.approx(film.friction_power, rel=1e-6)
    assert states.flow[0] == pytest.approx(film.oil_flow, rel=1e-6)
    slope = slopes_of(source, source.results)[place]
    eight = corners(seat, task.duty, slope, settled(*corner_points(seat, task.duty)))
    value = {one.rule.declared: one.value[0] for one in judge(task, states, slope)}
    assert value[FILM_EDGE] == pytest.approx(eight.film_edge * 1e6, rel=1e-5)
    assert value[TEMPERATURE] == pytest.approx(eight.outlet_temperature, rel=1e-5)
    assert value[CLEARANCE_COLD_CORNER] == pytest.approx(eight.clearance_cold * 1e6, rel=1e-5)
    rows = tuple(
        replace(row, length=length, clearance=clearance, clearance_factor=None) if row.name == place else row
        for row in source.rows
    )
    there = source.solve(source.bearings, rows, last=True).result(BearingsResult).bearings[place]
    assert value[FILM_EDGE_SHEARED] == pytest.approx(there.film_sheared * 1e6, rel=1e-5)
    assert value[FILM_OVERSPEED] == pytest.approx(there.film_overspeed * 1e6, rel=1e-5)


@pytest.mark.parametrize("temperature, pressure", [(120.0, 4e5), (60.0, 1e5), (5.0, 4e5)])
def test_the_short_balance_is_the_full_one(source, temperature, pressure):
    """Where the rise is one that is looked at; beyond there is no film, and never one where the full balance has
    none."""
    task = task_of(source)
    there = replace(task, duty=replace(task.duty, supply_temperature=temperature, supply_pressure=pressure))
    l, g = np.meshgrid(np.linspace(0.016, 0.044, 6), np.linspace(20e-6, 150e-6, 8))
    some, full = solved(there, l, g, all_rises=False), solved(there, l, g)
    known = np.isfinite(some.film)
    assert known.any() and np.isfinite(full.film[known]).all()
    assert known[np.isfinite(full.film) & (full.rise < 40)].all()
    assert some.film[known] == pytest.approx(full.film[known], rel=1e-5)
    assert some.rise[known] == pytest.approx(full.rise[known], rel=1e-4, abs=1e-3)


@pytest.mark.parametrize("place", ["front", "rear"])
def test_between_the_solved_lengths_the_cubic_is_close(source, place):
    task = task_of(source, place)
    made = fields([task], variants(source)[0])[0]
    exact = solved(task, made.states.length, made.states.clearance)
    for name in ("film", "rise", "viscosity", "power", "flow", "pressure"):
        close, true = getattr(made.states, name), getattr(exact, name)
        if close.ndim == 3:  # the oil begins to thin by shear at one film, where its share of viscosity has a kink
            assert np.nanmax(np.abs(close[-1] / true[-1] - 1)) < 4e-3
            close, true = close[:-1], true[:-1]
        there = np.isfinite(close) & np.isfinite(true)
        assert there.mean() > 0.9
        assert np.abs(close / true - 1)[there].max() < 1e-4


def test_no_length_is_looked_at_that_the_supply_takes_up(source):
    """A hole of 24 mm: lengths begin half a millimetre above it, where they else begin at a quarter of the diameter."""
    task = task_of(source)
    wide = replace(task, seat=replace(task.seat, inputs=replace(task.seat.inputs, supply="hole", hole_diameter=0.024)))
    assert min(lengths(wide)) == pytest.approx(0.0245) and min(lengths(task)) < 0.024


def test_every_row_passes_where_it_stands(source, found):
    for row in (found.rows[n - 1] for n in found.verified):
        there = source.solve(*with_row(source, row)).outcomes["bearings"]
        assert [c.id for c in there.checks if c.verdict == "fail"] == []
        beyond = [c.id for c in there.checks if c.id.endswith(("_corner", "_sheared", "overspeed")) and c.margin < 0]
        assert beyond == []
        power = sum(b.friction_power for b in there.result.bearings.values())
        assert row.power == pytest.approx(power, rel=1e-5)


def test_rows_rise_in_power_by_one_per_cent_and_then_in_size(found):
    keys = [tuple(map(float, by_power(row.wanted))) for row in found.rows]
    powers = [row.power for row in found.rows]
    assert len(keys) > 5 and keys == sorted(keys)
    assert all(b > a * (1 - 0.01) for a, b in pairwise(powers)), "never less by a per cent"
    assert all(row.margin >= 0 for row in found.all)
    assert keys[0][0] == round(np.log(powers[0]) / np.log(1.01)) and ONE_PER_CENT == pytest.approx(0.00995, rel=1e-3)


def test_nothing_nearer_passes(source):
    """Every candidate of both grids with a smaller change, its surfaces as they are or smoother, breaks a rule."""
    settled = nearest_row(source, only=variants(source)[:1])
    assert settled.row is not None
    for place, one in zip(("front", "rear"), settled.row.picks):
        made = fields([task_of(source, place)], variants(source)[0])[0]
        levels = [level for level in made.smoother() if level.task.level <= one.task.level]
        assert levels[-1].task.level == one.task.level
        nearer = made.change() < one.change - 1e-9
        assert nearer.any()
        states = solved(made.task, made.states.length[nearer], made.states.clearance[nearer])
        kept = least(judge(levels[-1].task, states, settled.slopes[place])) >= 1e-3
        assert not kept.any()


def test_the_least_power_is_that_of_all_candidates(source, found):
    slopes, variant = found.slopes[0], found.variants[0]
    of_variant = with_surfaces(in_room(fields_of(variant, tasks(source))))
    pair = best(of_variant, slopes, by_power)
    for place, one in zip(("front", "rear"), pair):
        f = of_variant[place][-1]
        exact = solved(f.task, f.states.length, f.states.clearance)
        kept = least(judge(f.task, exact, slopes[place])) >= 1e-4
        assert one.power == pytest.approx(exact.power[kept].min(), rel=0.0101)
        alike = kept & (exact.power < one.power * (1 - 0.0101))
        assert not alike.any()


def test_no_row_of_the_pareto_set_is_beaten(found):
    rows = found.pareto
    assert 3 <= len(rows) <= 13
    assert all(a.power < b.power and a.film < b.film for a, b in pairwise(rows))
    for row in found.rows[1:]:
        assert not any(row.power < other.power - 0.2 and row.film > other.film * 1.001 for other in rows)


def test_one_step_less_breaks_a_rule(found):
    for number, row in enumerate(found.rows[:3], 1):
        around = list(neighbours(row, found.variants, found.slopes_of_row(number)))
        shorter = [n for n in around if n.change.startswith("l ")]
        assert len(shorter) == 2 and all(n.instead.margin < 0 for n in shorter), "of equals the shortest"
        for n in around:
            assert n.instead.margin < 1e-3 or n.more > -0.0101 * row.power or n.oil or outside(n)


def test_the_tables_have_a_cell_for_every_column(found):
    for table in (choices_table(found, 5), neighbours_table(found), pareto_table(found)):
        assert table.rows and all(len(row) == len(table.columns) for row in table.rows)
    numbers = [row[0] for row in choices_table(found, 3).rows]
    assert numbers == ["now", "1", "2", "3"]
    assert pareto_table(found).rows[0][0] == str(len(found.rows) + 1)
    assert "thinner film of both" in choices_table(found, 1).note
    assert (
        choices_table(found, 1).title.startswith("Bearings that keep every rule of the search")
        and beyond_table(found, 50) is None
    )


def test_what_ties_the_diameters(tight, source, sized):
    beta = bearings_case(design(read(DESIGNS / "r753ie4_beta.toml")), solve)
    for case, front, rear in ((tight, "gear", "sectors"), (source, "", "not known"), (sized, "", "sectors")):
        assert front in tied(case, case.rows[0]) and rear in tied(case, case.rows[1])
    assert tied(beta, beta.rows[1]) == "" and "gear" in tied(beta, beta.rows[0])
    assert [len(tasks(source)[place]) for place in ("front", "rear")] == [1, 1]


def test_the_room_that_the_shaft_leaves(tight, sized):
    drawn = room(tight.shaft, tight.results.outcomes["countershaft"].result, "front", 0.0595)
    assert drawn.longest == pytest.approx(2 * (0.1675 - 0.153353), abs=1e-6)
    given = room(sized.shaft, sized.results.outcomes["countershaft"].result, "rear", 0.0864)
    assert given.longest == pytest.approx(0.040)
    assert room(None, None, "front", 0.0595).longest is None


def test_given_sections_leave_their_cylinder(source):
    parts = [(-0.190, -0.150, 0.030), (-0.150, 0.148, 0.015), (0.148, 0.185, 0.0405)]
    sections = tuple(Section(from_=a, to=b, outer_radius=R) for a, b, R in parts)
    shaft = replace(source.shaft, sections=sections)
    front, rear = (room(shaft, None, place, d) for place, d in (("front", 0.0595), ("rear", 0.081)))
    assert front.longest == pytest.approx(2 * 0.0175) and rear.longest == pytest.approx(2 * 0.0175)
    assert room(shaft, None, "front", 0.062).longest is None


@pytest.mark.slow
def test_a_room_that_is_given_is_kept(sized):
    some = search(sized)
    assert some.kind == "all" and some.own
    assert all(one.length <= 0.040 + 1e-9 for row in (*some.rows, *some.pareto) for one in row.picks)
    assert all(max(row.too_long) > 0 for row in some.beyond)


def test_rows_that_fit_come_first(loaded, fitting):
    """Under 5.5 kN no journal of 28.3 mm has its film at the corners, whatever the fits: rows keep the limits as
    given."""
    assert fitting.kind == "given" and fitting.rows
    for row in (fitting.rows[n - 1] for n in fitting.verified):
        assert row.too_long == (0, 0)
        outcomes = loaded.solve(*with_row(loaded, row)).outcomes
        assert [
            c.id for step in ("countershaft", "bearings") for c in outcomes[step].checks if c.verdict == "fail"
        ] == []
    assert summary(fitting)[0].startswith("Nothing that fits keeps every rule: the front journal has room for 28.29 mm")
    least = fitting.beyond[0]
    assert max(least.too_long) == min(max(row.too_long) for row in fitting.beyond)
    assert max(least.too_long) == pytest.approx(least.picks[0].length - 0.028294, abs=2e-6)
    assert "at every corner: these keep them as given" in choices_table(fitting, 20).title
    assert any(words.startswith("Rows 1 to") for words in notes(fitting))


def test_numbers_run_on_over_all_tables(fitting):
    shown = [choices_table(fitting, 99), beyond_table(fitting, 99), pareto_table(fitting)]
    numbers = [row[0] for table in shown for row in table.rows if row[0] != "now"]
    assert numbers == [str(n) for n in range(1, len(fitting.all) + 1)]
    shorter = [choices_table(fitting, 9), beyond_table(fitting, 9)]
    assert [row[0] for table in shorter for row in table.rows if row[0] != "now"] == [*map(str, range(1, 10))]


@pytest.mark.slow
def test_a_design_that_collides_hears_of_it_first(loaded, fitting):
    """The room is that of the shaft without the overlap, and the design no row."""
    again = search(other(loaded, *with_row(loaded, fitting.beyond[0])))
    assert (
        "countershaft.crossing" in choices_table(again, 5).title and "FAILS countershaft.crossing" in summary(again)[0]
    )
    assert not any("it keeps every rule" in words for words in summary(again))
    rooms = [[some[0].room.longest for some in found.tasks.values()] for found in (again, fitting)]
    assert rooms[0] == pytest.approx(rooms[1])
    assert again.rows and all(row.too_long == (0, 0) for row in again.rows)


@pytest.mark.slow
def test_smoother_surfaces_come_after_all_else(source):
    """With Ra 2 µm on both Kreisle asks for more film than any oil has; smoother surfaces bring the rows back."""
    front, rear = source.rows
    rough = replace(front, housing_roughness=2e-6, journal_roughness=2e-6)
    row = nearest_row(other(source, rows=(rough, rear))).row
    assert row is not None and row.picks[0].task.level > 0
    written = bearing_changes(row, source)
    b = row.picks[0].task.seat.bearing
    assert float(written["shafts.shaft.bearings.front.journal_roughness_um"]) == pytest.approx(
        b.journal_roughness * 1e6
    )
    limit = next(c.limit for c in row.picks[0].checks if c.id == "bearings.front.film_edge")
    assert limit == pytest.approx(7.5e6 * (b.journal_roughness + b.housing_roughness))  # Rt = 7.5·Ra, Kreisle
    assert "Ra" in changed(row)


def test_the_steps_to_smoother_surfaces():
    steps = [tuple(round(x * 1e6, 3) for x in pair) for pair in smoother(0.6e-6, 0.4e-6)]
    assert steps == [(0.4, 0.4), (0.3, 0.4), (0.3, 0.3), (0.2, 0.3), (0.2, 0.2)]
    assert list(smoother(0.1e-6, 0.2e-6)) == []


def test_closer_fits_go_by_grades(source):
    own = source.bearings
    assert closer_fits(own) == [("IT6", "IT6"), ("IT5", "IT5")]
    assert closer_fits(replace(own, journal_fit="f6", seat_fit="H7")) == [("IT5", "IT6"), ("IT5", "IT5")]
    assert closer_fits(replace(own, journal_fit="IT5", seat_fit="IT4")) == []


@pytest.mark.slow
def test_fits_with_a_place_become_widths(source):
    """A row with another clearance than that of the fits can not keep them."""
    placed = other(source, journal_fit="f7", seat_fit="H7")
    row = next(row for row in search(placed).rows if any(one.clearance != one.task.clearance for one in row.picks))
    there, _ = with_row(placed, row)
    assert (there.journal_fit, there.seat_fit) == ("IT7", "IT7")
    assert {"bearings.journal_fit": "IT7", "bearings.seat_fit": "IT7"}.items() <= bearing_changes(row, placed).items()


def test_wider_clearances_where_the_oil_is_too_little(source):
    """A tenth of the supply's pressure: close clearances pass too little oil."""
    speeds = 1000 / 60, 2600 / 60  # with this oil, not with that of the bench run
    cool = dict(supply_pressure=0.1e5, supply_temperature=60.0, oil="SAE 30", speed_range=speeds)
    row = nearest_passing(other(source, **cool))
    assert row is not None and all(one.clearance > min(clearances(one.task)) for one in row.picks)


def other(case, bearings=None, rows=None, **changes):
    """The same design with other bearings."""
    bearings, rows = replace(bearings or case.bearings, **changes), rows or case.rows
    return replace(case, bearings=bearings, rows=rows, results=case.solve(bearings, rows))


def test_closer_fits_and_a_surer_oil_ask_for_less(source, found):
    row = nearest_passing(other(source, journal_fit="IT5", seat_fit="IT6", viscosity_tolerance=0.0))
    assert row is not None and row.change < found.rows[0].change


def test_a_design_that_passes_is_its_own_nearest(source, found):
    done = other(source, *with_row(source, found.rows[0]))
    row = nearest_passing(done)
    assert row is not None and row.change == 0 and changed(row) == ""
    assert bearing_changes(row, done) == {}


def test_bearings_without_a_film_are_helped_too(source):
    """A clearance of a tenth of a micrometre, in steel, so that it never opens."""
    front, rear = source.rows
    tight = replace(rear, clearance_factor=None, clearance=1e-7)
    stuck = other(source, rows=(front, tight), housing_material="20CrNi4")
    assert stuck.results.outcomes["bearings"].state == "no_solution"
    row = nearest_passing(stuck)
    assert row is not None and row.picks[1].clearance > 50e-6 and row.picks[1].task.clearance == 1e-7


def test_a_clearance_meant_warm_is_widened_for_the_cold(source):
    """Given at 150 °C the clearance would seize when cold."""
    row = nearest_passing(other(source, clearance_reference_temperature=150.0))
    assert row is not None and all(one.clearance > one.task.clearance for one in row.picks)
    cold = [(c.value, one.clearance) for one in row.picks for c in one.checks if c.id.endswith("clearance_cold_corner")]
    assert len(cold) == 2 and all(left >= 0.05e6 * g * (1 - 1e-9) for left, g in cold)


def test_bearings_that_stand_alone_have_free_diameters(source, gamma, gamma_results):
    found = gamma_results.outcomes["bearings"].result.bearings
    rows = tuple(replace(row, load=found[row.name].load) for row in source.rows)
    alone = replace(
        design(gamma),
        engine=None,
        imbalance=None,
        shafts=(ShaftInputs(name="shaft", mode="bearings", bearings=rows),),
        gears=None,
        friction=None,
        bearings=replace(source.bearings, speed=2600 / 60, journal_material="20CrNi4"),
    )
    some = tasks(bearings_case(alone, solve))
    sizes = [59.5, 22, 24, 26, 28, 30, 32, 34, 36, 38, 40, 42, 45, 48, 50, 55]
    assert [round(t.size * 1e3, 6) for t in some["front"]] == sizes, "5 MPa at l/d 0.8 on 20.7 mm"
    assert some["front"][1].rules[LENGTH_RATIO].check.limit == (0.5, 0.8)


def test_the_supplies_are_those_with_a_width(source):
    assert {v.supply for v in variants(source)} == {"hole", "shaft"}
    own = replace(source.bearings, pocket_width=0.01, groove_width=0.003)
    assert {v.supply for v in variants(replace(source, bearings=own))} == {"hole", "shaft", "pocket", "groove"}
    names = {v.oil for v in variants(source)}
    assert names >= {"10W-40 Q8 T905", "SAE 30", "20W-50"} and not any("MIL" in n or "FVA" in n for n in names)


@pytest.mark.parametrize(
    "changes", [{"supply": "groove", "groove_width": 0.003}, {"supply": "pocket", "pocket_width": 0.012}]
)
def test_other_supplies_are_searched_too(source, changes):
    """A groove all round parts the bearing into two, whose l/d is that of each; a pocket takes its width."""
    case = other(source, **changes)
    row = nearest_passing(case)
    assert row is not None and row.margin >= 0 and row.variant.supply == changes["supply"]
    for one in row.picks:
        ratio = next(c.value for c in one.checks if c.id.endswith("length_ratio"))
        bare = (one.length - 0.003) / 2 if changes["supply"] == "groove" else one.length
        assert ratio == pytest.approx(bare / one.diameter) and one.length > changes.get("pocket_width", 0)


SORTED = """
schema = 2
name = "shells by classes"
[[shafts]]
name = "shaft"
mode = "bearings"
assembly = "split"
[[shafts.bearings]]
name = "front"
position_mm = -60
diameter_mm = 28.0
length_mm = 18
seat = "shells"
load_N = 2473
journal_roughness_um = 0.2
housing_roughness_um = 0.4
slope_mrad = 0.1
[[shafts.bearings]]
name = "rear"
position_mm = 60
diameter_mm = 28.0
length_mm = 20
seat = "bush"
wall_mm = [1.500, 1.508]
bore_mm = [31.06, 31.075]
journal_mm = [27.987, 28.0]
load_N = 2000
journal_roughness_um = 0.2
housing_roughness_um = 0.4
slope_mrad = 0.1
[bearings]
oil = "10W-40 Q8 T905"
supply_temperature_C = 100
supply_pressure_bar = 3
supply = "hole"
hole_diameter_mm = 3
housing_material = "EN AC-43100"
journal_material = "42CrMo4"
bush_material = "AlSn20Cu"
speed_rpm = 8500
[bearings.select]
journal_classes_mm = [[27.987, 27.993], [27.994, 28.0]]
bore_classes_mm = [[31.0, 31.008], [31.009, 31.016]]
clearance_band_um = [23, 50]
"""


@pytest.fixture(scope="module")
def shells():
    return SORTED, bearings_case(design(parse(SORTED.encode(), "shells")), solve)


def test_limits_and_classes_move_and_keep_their_widths(shells):
    """What is written makes the clearance that was chosen, of the size that was chosen; what the press then does to
    another size is off by less than half a micrometre."""
    _, case = shells
    variant = variants(case)[0]
    picks = best(with_surfaces(in_room(fields_of(variant, tasks(case)))), slopes_of(case), by_power)
    row = CandidateRow("offered", variant, picks)
    inputs, rows = with_row(case, row)
    there = case.solve(inputs, rows, last=True).result(BearingsResult).bearings
    for pick, of_design, written in zip(picks, case.rows, rows):
        made, was = there[pick.task.place], case.results.result(BearingsResult).bearings[pick.task.place]
        assert made.clearance == pytest.approx(pick.clearance, abs=0.5e-6) and pick.diameter < of_design.diameter
        fields_of_both = [c.clearance_max - c.clearance_min for c in (made.corners, was.corners)]
        assert fields_of_both[0] == pytest.approx(fields_of_both[1], rel=0.05)
        assert written.diameter == pytest.approx(pick.diameter) and pick.task.half * 2 == pytest.approx(
            fields_of_both[1]
        )
    assert inputs.select.journals[-1][1] == pytest.approx(picks[0].diameter)
    assert inputs.select.bores[0][0] - case.bearings.select.bores[0][0] == pytest.approx(picks[0].diameter - 0.028)
    assert rows[1].journal[1] - rows[1].journal[0] == pytest.approx(13e-6)


def test_shells_of_one_set_of_classes_are_of_one_size(shells):
    """However different their loads are."""
    text, _ = shells
    front, rear = text.split("[[shafts.bearings]]")[1:]
    other_row = front.replace("front", "rear").replace("-60", "60").replace("2473", "1200")
    both = text.replace(rear, other_row + rear[rear.index("[bearings]") :])
    case = bearings_case(design(parse(both.encode(), "shells")), solve)
    picks = best(with_surfaces(in_room(fields_of(variants(case)[0], tasks(case)))), slopes_of(case), by_power)
    assert picks[0].diameter == picks[1].diameter < 0.028
    assert picks[0].clearance == pytest.approx(picks[1].clearance, abs=0.1e-6)
    assert picks[0].length > picks[1].length


def test_a_candidate_of_shells_is_what_the_step_finds_as_the_split_passes(shells):
    """A bush has no split, nor has a load that stands with the seat one to pass.  A chosen interference, which a
    candidate has at every temperature, moves the film by some tenths of a per cent."""
    _, case = shells
    front, rear = (tasks(case)[place][0] for place in ("front", "rear"))
    assert FILM_EDGE_SPLIT in front.rules and FILM_EDGE_SPLIT not in rear.rules
    assert not passes_split(case.rows[0], replace(case.bearings, load_speed_ratio=0.0))
    longer = tuple(replace(row, length=0.0205) for row in case.rows)
    there = case.solve(case.bearings, longer, last=True).result(BearingsResult).bearings["front"]
    value = {one.rule.declared: one for one in judge(front, solved(front, [0.0205], [there.clearance]), 1e-4)}
    assert value[FILM_EDGE_SPLIT].value[0] == pytest.approx(there.split.film * 1e6, rel=4e-3)
    assert there.split.film < 0.9 * there.film_edge


def test_a_relief_that_is_not_known_passes_nowhere(shells):
    task = tasks(shells[1])["front"][0]
    wide = replace(task, seat=replace(task.seat, bearing=replace(task.seat.bearing, relief_length=0.02)))
    value = {one.rule.declared: one for one in judge(wide, solved(wide, [0.0205], [42e-6]), 1e-4)}
    assert np.isinf(value[FILM_EDGE_SPLIT].margin[0]) and np.isfinite(value[FILM_EDGE].margin[0])


def test_the_metal_around_a_bush_moves_with_its_diameter(shells):
    """In each candidate, many at once or alone, and in the row that is written."""
    text = shells[0].replace('seat = "bush"\n', 'seat = "bush"\nhousing_outer_mm = 40\n')
    case = bearings_case(design(parse(text.encode(), "shells")), solve)
    of_rear = tasks(case)["rear"]
    assert len(of_rear) > 3
    assert all(t.seat.rings.outside - t.size == pytest.approx(0.012) for t in of_rear)
    made = {field.task.size: field for field in fields(of_rear, variants(case)[0])}
    largest = made[max(made)]
    assert largest.task.size + 0.003 > 0.040, "thicker than what the design has around its bush"
    l, g = largest.states.length[:, -1:], largest.states.clearance[:, -1:]
    alone = solved(largest.task, l, g, all_rises=False)
    assert largest.states.film[:5, :, -1:] == pytest.approx(alone.film[:5], rel=1e-4, nan_ok=True)
    pick = picks(largest.task, [float(l[0, 0])], [float(g[0, 0])], 1e-4)[0]
    _, rows = with_row(case, CandidateRow("offered", variants(case)[0], (pick,)))
    assert rows[1].housing_outer - rows[1].diameter == pytest.approx(0.012)


def test_fits_are_of_bearings_that_they_make(shells, source):
    """Not of those by limits or classes."""
    case = shells[1]
    closer = replace(variants(case)[0], fits=("IT5", "IT5"))
    of_parts = tuple(picks(t := some[0], [t.length], [t.clearance], 1e-4)[0] for some in tasks(case).values())
    assert fits_to_write(CandidateRow("offered", closer, of_parts), case.bearings) is None
    own = task_of(source)
    by_fits = (*picks(own, [own.length], [own.clearance], 1e-4), *of_parts)
    assert fits_to_write(CandidateRow("offered", closer, by_fits), source.bearings) == ("IT5", "IT5")


def test_a_step_of_clearance_is_the_grid_s(shells):
    """Counted from the design's own clearance, where limits of the parts make it."""
    case = shells[1]
    of_parts = tuple(picks(t := some[0], [t.length], [t.clearance], 1e-4)[0] for some in tasks(case).values())
    around = neighbours(CandidateRow("offered", variants(case)[0], of_parts), (), dict.fromkeys(tasks(case), 1e-4))
    steps = [n.instead.clearance - n.of.clearance for n in around if n.change.startswith("g ")]
    assert steps == pytest.approx([-2e-6, 2e-6] * 2)


def test_two_candidates_that_are_alike_are_solved_whole_once(source, monkeypatch):
    """More spare film that asks for no other bearing is no new trial."""
    seen = []

    def refused(case, row, slopes, *, strict=False):
        seen.append(tuple((p.diameter, p.length, p.clearance, p.task.level) for p in row.picks))
        return search_.Settled(None, dict(slopes), why="refused")

    monkeypatch.setattr(search_, "confirmed", refused)
    monkeypatch.setattr(search_, "SPARE", (0.0, 1e-6, 0.1))
    variant = variants(source)[0]
    some = with_surfaces(in_room(fields_of(variant, tasks(source))))
    assert search_.settle(source, variant, some, slopes_of(source), by_power).row is None
    assert len(seen) == len(set(seen)) == 2


@pytest.mark.parametrize("length, opened", [(0.019, []), (0.016, ["bearings.rear.seat_press"])])
def test_cautions_of_the_bearings_that_a_row_opens_are_told(shells, length, opened):
    """A shorter bush takes more press to be held than is given."""
    text = shells[0].replace('seat = "bush"\n', 'seat = "bush"\ninterference_um = [32, 47]\n')
    case = bearings_case(design(parse(text.encode(), "shells")), solve)
    both = zip(tasks(case).values(), (0.0205, length))
    shorter = tuple(picks(some[0], [l], [some[0].clearance], 1e-4)[0] for some, l in both)
    settled = search_.confirmed(case, CandidateRow("offered", variants(case)[0], shorter), slopes_of(case))
    assert settled.row is not None and [c.id for c in settled.broken if "seat_press" in c.id] == opened
