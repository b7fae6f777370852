"""The shifts that are found: the source's pairs, freedom of a train, the best on the lattice and off it, limits, and
what stops them."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from calc.gears.selection import optimum
from calc.gears.selection.free_shifts import freedoms, tied
from calc.gears.selection.optimum import ShiftCase, best, evaluated, objective
from calc.gears.selection.search import cut_steps, search
from calc.gears.selection.states import USUAL, judge
from calc.gears.selection.tables import changes, choices_table, limits_table, summary
from calc.gears.train import settle, tooth_system
from calc.sheet.errors import NoSolution
from calc.sheet.search import least
from tests.calc.gears.trains import mesh, pair_1, r753, solved, train, wheel


@pytest.fixture(scope="module")
def pair():
    return search(pair_1())


def case_of(gears):
    return ShiftCase(tooth_system(gears), gears)


# --- the source's pairs
def test_first_pair_alone_is_balanced_where_it_was_computed_to_be(pair):
    """x_1·m_n = −0.1998 mm, both 0.972: the figures to reach for the source's pair with 0.2 mm off the 39."""
    x, largest = pair.exact
    assert 2 * x == pytest.approx(-0.1998, abs=5e-5)
    assert largest == pytest.approx(0.972, abs=5e-4)
    (row,) = pair.optima
    assert row.free == {"central": -0.0999}
    assert [abs(float(z[0])) for z in row.states.sliding.values()] == pytest.approx([0.972, 0.972], abs=5e-4)
    assert {at[1]: abs(float(z[0])) for at, z in pair.now.states.sliding.items()} == pytest.approx(
        {"central": 0.818, "idler": 1.127}, abs=5e-4
    )


def test_what_the_pairs_want_of_the_idler(source):
    """The first alone −0.084 mm on the 39; the printed −0.312 mm is nearly what the second wants."""
    idler = {row.wants: 2 * float(row.states.shifts["idler"][0]) for row in source.wants}
    assert idler["central_idler"] == pytest.approx(-0.084, abs=5e-4)
    assert idler["idler_shaft"] == pytest.approx(-0.312, abs=5e-4)


def test_optimum_of_a_train_is_no_better_than_that_of_its_worst_pair(source):
    own = [float(row.states.largest_of(row.wants)[0]) for row in source.wants]
    assert all(row.largest >= max(own) - 1e-3 for row in source.optima if len(row.free) == 1)
    assert all(row.largest < source.now.largest for row in source.optima)


# --- freedom
def test_the_ways_of_the_source():
    """80.555 and 68.698 mm tie three wheels; the crank's wheel follows the shaft's, or a held distance, or is free
    itself."""
    gears = r753()
    assert tied(gears) == [("crank",), ("central", "idler", "shaft")]
    designed, held, free = freedoms(gears, tooth_system(gears))
    assert (designed.name, held.name, free.name) == ("crank as shaft", "distance held", "distance free")
    assert designed.free == held.free == ("central",) and free.free == ("crank", "central")
    assert dict(held.held) == {0: pytest.approx(0.065808, abs=1e-9)}
    assert designed.sign == {"crank": 1, "central": 1, "idler": -1, "shaft": 1} and held.sign["crank"] == -1


@pytest.mark.parametrize("number", [0, 1, 2])
@pytest.mark.parametrize("x", [-0.21, 0.14])
def test_shifts_follow_as_the_train_itself_settles_them(number, x):
    gears = r753()
    way = freedoms(gears, tooth_system(gears))[number]
    free = dict(zip(way.free, (x, 0.5 * x)))
    wheels = tuple(replace(w, profile_shift=free.get(w.name, w.profile_shift)) for w in way.gears.wheels)
    settled = settle(replace(way.gears, wheels=wheels), tooth_system(gears)).shifts
    assert way.shifts(free) == pytest.approx(settled, abs=1e-14)


def test_given_shifts_that_contradict_are_taken_out():
    """A design that can not be solved can be chosen for: one of the shifts that a distance ties stays."""
    gears = train([wheel("a", 36, 0.3), wheel("b", 39, 0.3)], [mesh("a", "b", 80.555)])
    with pytest.raises(NoSolution):
        solved(gears)
    found = search(gears)
    assert found.now is None and found.cut_now == ()
    assert next(iter(changes(found.optima[0]).items())) == ("gears.wheels.b.profile_shift", None)


def test_a_wheel_that_nothing_gives_stands_at_none_and_too_many_free_shifts_are_said():
    gears = train([wheel("a", 25), wheel("b", 30), wheel("c", 25)], [mesh("a", "b"), mesh("a", "c", 55)])
    assert [way.name for way in freedoms(gears, tooth_system(gears))] == ["b at 0", "distance held", "distance free"]
    long = [f"w{i}" for i in range(7)]
    found = search(
        train([wheel(name, 20 + 3 * i, 0.0) for i, name in enumerate(long)], [mesh(a, b) for a, b in pairwise(long)])
    )
    assert (
        found.unsought == ("distances free",)
        and "not searched" in " ".join(summary(found))
        and found.optima[0].freedom.key == "held"
    )


# --- the best
def test_one_free_shift_against_a_scan_of_its_own():
    """No point of a grid ten times as fine, seen by single trains or all at once, is better by more than the lattice
    allows."""
    case = case_of(r753())
    for way in freedoms(case.gears, case.system)[:2]:
        found = best(case, way, {}, USUAL)
        t = np.arange(-0.4, 0.6, 1e-5)
        many = evaluated(case, way, {"central": t}, {})
        kept = least(judge(many, case.system, USUAL)) >= 0
        reached = float(evaluated(case, way, found.free, {}).largest[0])
        assert np.min(many.largest[kept]) == pytest.approx(reached, abs=5e-4) and reached >= np.min(many.largest[kept])


@pytest.mark.parametrize(
    "gears",
    [
        r753(),
        train([wheel("a", 20, 0.1), wheel("b", 47, 0.2)], [mesh("a", "b")], tool=(1.25, 0.38), beta=12.0),
        train(
            [wheel("a", 20, 0.1, cut=0.1), wheel("b", 33, 0.2, cut=0.1)], [mesh("a", "b")], tool=(1.4, 0.3), beta=0.0
        ),
    ],
)
def test_two_free_shifts_against_a_grid(gears):
    """A grid of 0.01 over everything finds nothing better than the search; where nothing passes, nothing that misses by
    less."""
    case = case_of(gears)
    way = freedoms(gears, case.system)[-1]
    found = best(case, way, {}, USUAL)
    one, two = (axis.ravel() for axis in np.meshgrid(np.arange(-0.6, 1.6, 0.01), np.arange(-1.5, 1.6, 0.01)))
    many = evaluated(case, way, dict(zip(way.free, (one, two))), {})
    margin = least(judge(many, case.system, USUAL))
    if np.max(margin) < 0:
        assert np.max(margin) - 1e-9 <= found.margin <= np.max(margin) + 0.05
        return
    assert found.margin >= 0
    wanted = np.where(margin >= 0, objective(many), np.inf)
    reached = float(objective(evaluated(case, way, found.free, {}))[0])
    assert reached <= np.min(wanted) + 1e-9 and reached >= np.min(wanted) - 0.05


def test_three_free_shifts_find_the_symmetric_train():
    """a and c are the same wheel on both sides of b: the best has the same shift for both."""
    gears = train([wheel("a", 20, 0.1), wheel("b", 30, 0.2), wheel("c", 20, 0.0)], [mesh("a", "b"), mesh("b", "c")])
    (held, free) = freedoms(gears, tooth_system(gears))
    found = best(case_of(gears), free, {}, USUAL)
    assert found.margin >= 0 and found.free["a"] == pytest.approx(found.free["c"], abs=3e-4)
    assert held.free == ("a",)


@pytest.mark.parametrize("found", ["source", "pair"])
def test_rows_are_what_the_train_solved_alone_gives(found, request):
    """Each numbered row, put into the design, has the sliding that it promises, and keeps the rules that are checks as
    well."""
    found = request.getfixturevalue(found)
    assert len(found.all) > 15
    for row in found.all:
        gears = row.freedom.gears if row.freedom else found.case.gears
        wheels = tuple(
            replace(
                w,
                profile_shift=row.free.get(w.name, w.profile_shift),
                tip_shortening=row.cuts.get(w.name, w.tip_shortening),
            )
            for w in gears.wheels
        )
        made = solved(replace(gears, wheels=wheels))
        zeta = [abs(z) for m in made.meshes.values() for z in (m.specific_sliding_driver, m.specific_sliding_driven)]
        assert max(zeta) == pytest.approx(row.largest, rel=1e-10)
        assert all(
            w.profile_shift >= w.undercut_limit and w.tip_thickness_normal >= 0.25 * 2e-3 for w in made.wheels.values()
        )
        assert all(
            m.transverse_contact_ratio >= 1.25 and min(m.tip_clearance_driver, m.tip_clearance_driven) >= 0.2 * 2e-3
            for m in made.meshes.values()
        )
        assert all(x == round(x, 4) for x in row.free.values())


def test_scaling_all_lengths_changes_no_shift():
    def scaled(factor):
        wheels = [wheel("a", 36, 0.014), wheel("b", 39, cut=0.2 * factor)]
        return search(train(wheels, [mesh("a", "b", 80.555 * factor)], m_n=2 * factor, b=15 * factor))

    one, ten = scaled(1.0), scaled(10.0)
    assert one.optima[0].free == ten.optima[0].free
    assert one.exact == pytest.approx(ten.exact, abs=1e-9)


def test_swapping_driver_and_driven_finds_the_same_teeth():
    one = search(train([wheel("a", 36, 0.014), wheel("b", 39)], [mesh("a", "b", 80.555)]))
    other = search(train([wheel("b", 39), wheel("a", 36, 0.014)], [mesh("b", "a", 80.555)]))
    assert one.exact == pytest.approx(other.exact, abs=1e-9)


# --- limits, tip cuts, and what stops
def test_limits_are_where_the_rule_turns(source):
    """At each end the rule is kept, one step of the lattice further it is not."""
    case, along = source.case, source.along
    stopped = 0
    for one in source.limits:
        for x, by, step in ((one.range[0], one.low, -1e-4), (one.range[1], one.high, 1e-4)):
            if by:
                inside, outside = (
                    min(
                        float(j.margin[0])
                        for j in judge(
                            evaluated(case, along.freedom, {"central": t}, {}), case.system, source.optima[0].bar
                        )
                        if j.rule is one.rule
                    )
                    for t in (x, x + step)
                )
                assert inside >= 0 > outside
                stopped += 1
    assert stopped >= 6
    assert len(limits_table(source).rows) == len(source.limits) == 5


def test_steps_of_the_tip_cut_are_round():
    case = case_of(pair_1())
    assert [round(k * 1e3, 9) for k in cut_steps(case, case.gears.wheels[0])] == [0, 0.1, 0.2, 0.3, 0.4]
    big = case_of(pair_1(m_n=5.0))
    assert round(cut_steps(big, big.gears.wheels[0])[1] * 1e3, 9) == 0.2


def test_a_tip_cut_helps_the_mate_and_its_best_shift_uses_it(pair):
    """A longer cut of one wheel lowers what its mate slides, so the best shift goes the other way; each row is better
    than no cut."""
    assert all(row.largest < pair.optima[0].largest for row in pair.cut_best)
    of_central = sorted(
        (row.cuts["central"], row.free["central"], row.largest) for row in pair.cut_best if "central" in row.cuts
    )
    assert [x for _, x, _ in of_central] == sorted(x for _, x, _ in of_central)
    assert [z for *_, z in of_central] == sorted((z for *_, z in of_central), reverse=True)


def test_where_the_tool_leaves_no_clearance_the_rule_is_named():
    gears = train([wheel("a", 30, 0.1), wheel("b", 40, 0.1)], [mesh("a", "b", 70.2)], beta=0.0, tool=(1.0, 0.2))
    with pytest.raises(NoSolution, match="no profile shift keeps every rule") as none:
        search(gears)
    assert (
        "clearance: nowhere" in none.value.tried
        and "c/m_n" in none.value.tried
        and "larger addendum" in none.value.advice
    )


def test_where_undercut_leaves_nothing_both_wheels_are_named():
    gears = train([wheel("a", 12, 0.1), wheel("b", 13)], [mesh("a", "b", 24.2)], beta=0.0, tool=(1.25, 0.38))
    with pytest.raises(NoSolution, match="undercut") as none:
        search(gears)
    assert "a needs at least" in none.value.tried and "b at most" in none.value.tried


def test_a_design_below_what_is_usual_is_met_where_it_stands():
    """Its fillet reaches further up than 0.1·m_n allows: rows are no worse than it, and a cut that keeps the usual
    limit is offered."""
    wheels = [wheel("crank", 38, 0.22404, cut=0.034808), wheel("pump", 76, 0.22404, cut=0.034808)]
    found = search(train(wheels, [mesh("crank", "pump")], m_n=2.31, alpha_n=18.02525, beta=0.0, tool=(1.25, 0.38)))
    assert not found.now.passes and found.now.least.rule.key == "above_fillet"
    held = next(row for row in found.optima if row.freedom.key == "held")
    floor = min(float(m[0]) for m in found.now.states.margin.values())
    assert not held.usual and min(float(m[0]) for m in held.states.margin.values()) >= floor - 1e-12
    assert any(row.usual and row.largest < found.now.largest for row in found.cut_best)


# --- more freedom
def timing(**changes):
    """The spur pair of a timing drive: its contact starts less far above the fillet than is usual."""
    wheels = [wheel("crank", 38, 0.22404, cut=0.034808), wheel("pump", 76, 0.22404, cut=0.034808)]
    return train(
        wheels,
        [mesh("crank", "pump")],
        **{"m_n": 2.31, "alpha_n": 18.02525, "beta": 0.0, "tool": (1.25, 0.38), **changes},
    )


def test_the_limits_of_the_design_itself_are_looked_at_even_where_the_usual_ones_can_be_kept():
    """With the distance free a far corner keeps the usual limits, with three times the sliding; by those of the design
    it is far less."""
    found = search(timing())
    free = [row for row in found.optima if row.freedom.key == "free"]
    assert [row.usual for row in free] == [False, True] and free[1].largest > 3 * found.now.largest
    assert found.optima[0] is free[0] and free[0].largest < 0.9 * found.now.largest
    one, two = (axis.ravel() for axis in np.meshgrid(np.arange(-0.8, 1.6, 0.01), np.arange(-1.9, 1.6, 0.01)))
    many = evaluated(found.case, free[0].freedom, {"crank": one, "pump": two}, {})
    kept = least(judge(many, found.case.system, found.case.bars[-1])) >= 0
    assert free[0].largest <= np.min(many.largest[kept]) <= free[0].largest + 0.01
    floor = min(float(m[0]) for m in found.now.states.margin.values())
    assert min(float(m[0]) for m in free[0].states.margin.values()) >= floor - 1e-12


def test_a_row_says_which_limits_it_keeps(source):
    table = choices_table(search(timing()), 20)
    assert table.columns[-1][0] == "keeps" and [row[-1] for row in table.rows] == ["", "as now", "as now", "usual"]
    assert "as now: limits no lower than the design" in table.note
    same = choices_table(source, 20)
    assert (
        same.columns[-1][0] == "by"
        and "All numbered rows keep the usual limits and that of case-hardened tips." in same.note
    )


@pytest.mark.parametrize(
    "gears",
    [
        r753(),
        timing(),
        timing(tool=(1.4, 0.2)),
        train([wheel("a", 20, 0.3), wheel("b", 33, 0.1)], [mesh("a", "b")], beta=15.0),
    ],
)
def test_more_freedom_never_ranks_worse(gears):
    """By the limits that a row keeps, the way that contains its way has one that slides no more; also once the best of
    all is taken."""
    for _ in range(2):
        found = search(gears)
        case = found.case
        for row in found.optima:
            for way in found.freedoms:
                if way.contains(row.freedom) and way.name not in found.no_better:
                    rows = [
                        one
                        for one in found.optima
                        if one.freedom is way and case.bars.index(one.bar) <= case.bars.index(row.bar)
                    ]
                    assert min(round(one.largest, 4) for one in rows) <= round(row.largest, 4)
        assert not found.refused
        best_row = found.optima[0]
        wheels = tuple(
            replace(w, profile_shift=best_row.free.get(w.name, w.profile_shift)) for w in best_row.freedom.gears.wheels
        )
        gears = replace(best_row.freedom.gears, wheels=wheels)


def test_a_way_with_more_freedom_starts_from_those_within_it(monkeypatch):
    """A search that stays in a far corner is brought to what less freedom has found."""
    narrowed = optimum.narrowed

    def astray(evaluate, low, high, centre, step, side):
        if len(low) > 1 and (step > 1).any():
            margin, wanted = evaluate(low[None])
            return low, float(margin[0]), float(wanted[0])
        return narrowed(evaluate, low, high, centre, step, side)

    monkeypatch.setattr(optimum, "narrowed", astray)
    found = search(r753())
    assert found.optima[0].freedom.key == "free" and found.optima[0].largest < found.optima[1].largest


def test_no_more_grids_are_kept_than_memory_has_room_for(monkeypatch):
    monkeypatch.setattr(optimum, "KEPT", 2)
    case = case_of(r753())
    way = max(freedoms(case.gears, case.system), key=lambda one: len(one.free))
    known = {}
    few = best(case, way, {}, case.bars[0], known=known)
    monkeypatch.undo()
    every = best(case, way, {}, case.bars[0])
    assert len(known) == 2 and (few.free, few.margin) == (every.free, every.margin)


def test_a_way_that_has_nothing_better_is_said_and_not_offered(monkeypatch):
    def poor(case, way, cuts, bar, near=(), known=None):
        if way.key != "free":
            return best(case, way, cuts, bar, near)
        now = {"crank": 0.0142, "central": 0.014}
        made = evaluated(case, way, now, {})
        return optimum.Best(now, float(least(judge(made, case.system, bar))[0]), float(objective(made)[0]))

    monkeypatch.setattr("calc.gears.selection.search.best", poor)
    found = search(r753())
    assert found.no_better == ("distance free",) and found.refused == () and len(found.optima) == 2
    assert "Nothing better so." in summary(found)[2]
