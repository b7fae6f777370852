"""Backlash: the source's pairs, its own small-change form, and what it means for the last wheel."""

import math

import pytest

from calc.gears import solve
from tests.calc.gears.backlash.plays import changed, played, true
from tests.calc.gears.trains import SPEED, mesh, pair_1, r753, shown, solved, train, wheel

LIMITS = "backlash_min", "backlash_nominal", "backlash_max"


@pytest.mark.parametrize(
    "allowances, expected",
    [(((-2, -20), (-20, -30)), (-14.7, 36.0, 86.8)), (((-20, -30), (-20, -30)), (3.3, 50.0, 96.8))],
)
def test_first_pair(allowances, expected):
    """Recomputed from the allowances of Finotti 2013, 4.5, at 80.555 ± 0.055 mm: as printed the pair can jam."""
    v = shown(solve.geometry(pair_1(allowances=allowances), SPEED))
    assert [v[f"central_idler.{n}"] for n in LIMITS] == pytest.approx(expected, abs=0.05)


@pytest.mark.parametrize("pair, tolerance", [("crank_central", 0.0), ("central_idler", 55.0), ("idler_shaft", 55.0)])
def test_every_pair_agrees_with_the_small_change_form(pair, tolerance):
    """j_bn = −(E_W1 + E_W2) ± 2·T_a·sin α_wt·cos β_b, good to T_a²/a."""
    t = solved(r753())
    mesh_ = t.meshes[pair]
    slope = 2 * math.sin(mesh_.working_pressure_angle) * math.cos(t.system.base_helix_angle) * tolerance * 1e-6
    ends = [t.wheels[w].allowance for w in (mesh_.driver, mesh_.driven)]
    upper, lower = sum(e[0] for e in ends), sum(e[1] for e in ends)
    linear = -upper - slope, -(upper + lower) / 2, -lower + slope
    assert [getattr(mesh_, n) for n in LIMITS] == pytest.approx(linear, abs=0.2e-6)


def test_a_given_pair_without_tolerance_and_allowance_has_none():
    gears = train([wheel("a", 36, 0.014), wheel("b", 39)], [mesh("a", "b", 80.555)])
    outcome = solve.geometry(gears, SPEED)
    assert [getattr(outcome.result.meshes["a_b"], n) for n in LIMITS] == [0, 0, 0]
    assert outcome.result.shafts["shaft"].phase_error == 0
    assert any("neither tolerance nor allowance" in n for n in outcome.notes)


def test_contributors_make_half_the_root_of_their_squares():
    by_parts = train([wheel("a", 36, 0.014), wheel("b", 39)], [mesh("a", "b", 80.555, contributors=[0.03, 0.04])])
    by_number = train([wheel("a", 36, 0.014), wheel("b", 39)], [mesh("a", "b", 80.555, tolerance=25)])
    one, two = (solved(g).meshes["a_b"] for g in (by_parts, by_number))
    assert [getattr(one, n) for n in LIMITS] == pytest.approx([getattr(two, n) for n in LIMITS], rel=1e-12)


@pytest.mark.parametrize("E", [-200, -20, -1, 15])
def test_an_allowance_acts_micrometre_for_micrometre(E):
    """Exactly, also on the very centre distance at an end of its tolerance."""
    plain = solved(pair_1(allowances=((0, 0), (0, 0)))).meshes["central_idler"]
    thinned = solved(pair_1(allowances=((E, E), (0, 0)))).meshes["central_idler"]
    for n in LIMITS:
        assert getattr(thinned, n) - getattr(plain, n) == pytest.approx(-E * 1e-6, abs=1e-15)


def test_phase_error_is_the_sum_of_the_largest_plays():
    """Σ j_wt/(d_w/2), each reduced to the last wheel by the teeth between; at least what the normal backlash gives at
    the base circle."""
    t = solved(r753())
    total = 0.0
    for pair in t.meshes.values():
        driven = t.wheels[pair.driven]
        at_base = pair.backlash_max / math.cos(t.system.base_helix_angle) / (driven.base_diameter / 2)
        total += at_base * driven.teeth / 25
    assert t.shafts["shaft"].phase_error == pytest.approx(total, rel=1e-12)


def test_a_tight_mesh_takes_nothing_from_the_phase_error():
    loose = train([wheel("a", 30, 0.0, allowance=(-20, -30)), wheel("b", 30, 0.0)], [mesh("a", "b")])
    fat = wheel("c", 30, 0.0, allowance=(90, 80))
    tight = train(
        [wheel("a", 30, 0.0, allowance=(-20, -30)), wheel("b", 30, 0.0), fat], [mesh("a", "b"), mesh("b", "c")]
    )
    assert solved(tight).shafts["shaft"].phase_error == pytest.approx(solved(loose).shafts["shaft"].phase_error)


def test_residual_couple_is_the_difference_of_two_vectors():
    outcome = solve.geometry(r753(), SPEED)
    error = outcome.result.shafts["shaft"].phase_error
    merged = solve.with_residuals(outcome, {"shaft": solve.Balanced(572.93, 1000.0)})
    chord = abs(1 - complex(math.cos(error), math.sin(error)))
    assert shown(merged)["residual_couple"] == pytest.approx(572.93 * chord)
    assert shown(merged)["residual_force"] == pytest.approx(1000.0 * chord)
    assert [line.formula.symbol for line in merged.lines[-2:]] == ["C_Δφ", "F_Δφ"]


@pytest.mark.parametrize("first", [None, (-1, -5), (-9, -30), (5, -5)])
def test_advice_just_passes(first):
    """What the failing check advises passes by no narrow margin, with less than 1 µm to spare."""

    def jams(**allowances):
        wheels = [wheel("a", 36, 0.014, allowance=allowances.get("a")), wheel("b", 39, allowance=allowances.get("b"))]
        play = played(train(wheels, [mesh("a", "b", 80.555, tolerance=20)]))
        return next(c for c in play.checks if c.id == "gears.a_b.backlash")

    jam = jams(a=first)
    assert jam.value < 0
    ((key, ends),) = jam.remedies[0].changes
    assert key.split(".")[2] == ("b" if first and first[0] < 0 else "a"), "the one with the thicker teeth"
    better = jams(**{"a": first, key.split(".")[2]: tuple(ends)})
    assert 0 <= better.value - 0.05 * better.zero_scale < 1 and better.verdict == "pass"


def test_a_closer_tolerance_that_is_advised_just_passes():
    def jams(gears):
        return next(c for c in played(gears).checks if c.id == "gears.central_idler.backlash")

    gears = true(pair_1(allowances=((-5, -15), (-20, -30))))
    jam = jams(gears)
    assert jam.verdict == "fail"
    ((key, tolerance),) = jam.remedies[1].changes
    better = jams(changed(gears, tolerance=tolerance * 1e-6))
    assert key == "gears.meshes.0.tolerance_um" and better.verdict == "pass"
    assert 0 <= better.value - 0.05 * better.zero_scale < 1
