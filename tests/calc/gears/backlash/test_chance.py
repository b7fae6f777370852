"""Trains by chance, against many more trains of a common random generator; and the phase error that their play
leaves."""

import itertools
import math
from dataclasses import replace

import numpy as np
import pytest

from calc.gears.backlash.case import SPREAD, cases
from calc.gears.backlash.chance import TRAINS, by_chance, deviate
from calc.gears.backlash.solve import with_couple
from tests.calc.gears.backlash.plays import CENTRAL, IDLER, SHAVED, alone, changed, parts, played, true
from tests.calc.gears.trains import mesh, pair_1, r753, solved, train, wheel

MANY = 400_000


def brute_force(gears, seed=1):
    """Smallest backlash by mesh and free turn of the last wheel of very many trains, by the formulas for thickness at
    the working circle."""
    random, t = np.random.default_rng(seed), solved(gears)
    runouts = {w.name: w.runout or 0.0 for w in gears.wheels}
    E = {name: random.uniform(*sorted(w.allowance or (0, 0)), MANY) for name, w in t.wheels.items()}
    smallest, turn = {}, 0.0
    for inputs, (key, m) in zip(gears.meshes, t.meshes.items()):
        a = np.full(MANY, m.centre_distance)
        if inputs.stack:
            for part in inputs.stack:
                angle, reach = random.uniform(0, 2 * np.pi, MANY), part.field / 2
                if part.kind == "position":  # a point anywhere in the square that falls into the circle
                    x, y = random.uniform(-1, 1, (2, 2 * MANY))
                    a += reach * x[x**2 + y**2 < 1][:MANY]
                else:
                    a += reach * (random.uniform(-1, 1, MANY) if part.kind == "radial" else np.sin(angle))
        elif m.centre_tolerance:
            a += random.uniform(-m.centre_tolerance, m.centre_tolerance, MANY)
        wheels = t.wheels[m.driver], t.wheels[m.driven]

        def normal(a, wheels=wheels):
            alpha = np.arccos((wheels[0].base_diameter + wheels[1].base_diameter) / (2 * a))
            j = 2 * np.pi * a / (wheels[0].teeth + wheels[1].teeth)
            for w in wheels:
                d_w = w.base_diameter / np.cos(alpha)
                s_t = w.reference_thickness + E[w.name] / (math.cos(t.system.alpha_n) * math.cos(t.system.beta))
                alpha_t = t.system.transverse_pressure_angle
                j = j - d_w * (s_t / w.reference_diameter + math.tan(alpha_t) - alpha_t - np.tan(alpha) + alpha)
            return j, alpha

        j, alpha = normal(a)
        turn = (
            turn
            + np.maximum(j, 0)
            / (wheels[1].base_diameter / np.cos(alpha) / 2)
            * wheels[1].teeth
            / t.wheels[gears.meshes[-1].driven].teeth
        )
        j, alpha = normal(a - (runouts[m.driver] + runouts[m.driven]) / 2)
        smallest[key] = j * np.cos(alpha) * math.cos(t.system.base_helix_angle)
    return smallest, turn


def stacked():
    gears = changed(
        true(r753()), 1, stack=parts("position", CENTRAL) + parts("fit", IDLER), wheels={"idler": {"runout": 25e-6}}
    )
    return changed(gears, 2, stack=parts("runout", {"a": 0.03, "b": 0.02}) + parts("radial", {"c": 0.06}))


@pytest.mark.parametrize("gears", [true(r753()), true(pair_1()), stacked()], ids=["tolerances", "pair", "kinds"])
def test_against_brute_force(gears):
    """Within three standard errors of 4096 trains drawn freely: of the spread 0.06 at the median, 0.10 at 5 %, 0.17 at
    1 % (normal)."""
    found, (smallest, turn) = played(gears), brute_force(gears)
    for key, j in smallest.items():
        mine, spread = found.meshes[key], j.std()
        assert mine.backlash_median == pytest.approx(np.median(j), abs=0.06 * spread)
        assert mine.backlash_99 == pytest.approx(np.quantile(j, 0.01), abs=0.17 * spread)
        assert mine.share_jammed == pytest.approx((j < 0).mean(), abs=0.009)
    assert found.shafts["shaft"].share_jammed == pytest.approx(
        (np.min(list(smallest.values()), 0) < 0).mean(), abs=0.009
    )
    for name, p, error in (("median", 0.5, 0.06), ("95", 0.95, 0.10), ("99", 0.99, 0.17)):
        assert getattr(found.shafts["shaft"], f"phase_error_{name}") == pytest.approx(
            np.quantile(turn, p), abs=error * turn.std()
        )


def test_the_first_pair_can_jam_as_printed():
    """Three even deviations, each ±w: the share beyond c is Σ ±(±w_1 ± w_2 ± w_3 − c)³ over the signs, where positive,
    over 6·8·w_1·w_2·w_3."""
    gears = true(pair_1(allowances=((-2, -20), (-20, -30))))
    t = solved(gears)
    m = t.meshes["central_idler"]
    slope = 2 * math.sin(m.working_pressure_angle) * math.cos(t.system.base_helix_angle)
    w, total = (slope * 55, 9.0, 5.0), 0.0
    for signs in itertools.product((1, -1), repeat=3):
        beyond = sum(s * x for s, x in zip(signs, w)) - m.backlash_nominal * 1e6
        total += math.prod(signs) * max(beyond, 0.0) ** 3
    share = total / (48 * math.prod(w))
    assert 0.03 < share < 0.05
    assert played(gears).meshes["central_idler"].share_jammed == pytest.approx(share, abs=0.003)
    assert alone(SHAVED)[1].share_jammed == 0.0


def test_the_share_of_jams_of_one_even_deviation():
    """Only the centre deviates, evenly: the share below zero is a ratio of lengths."""
    gears = true(pair_1(allowances=((-10, -10), (-5, -5))))
    t = solved(gears)
    m = t.meshes["central_idler"]
    slope = 2 * math.sin(m.working_pressure_angle) * math.cos(t.system.base_helix_angle)
    share = (55e-6 - 15e-6 / slope) / 110e-6
    assert played(gears).meshes["central_idler"].share_jammed == pytest.approx(share, abs=2e-3)


@pytest.mark.parametrize("kind, share", SPREAD.items())
@pytest.mark.parametrize("k", [0, 2, 14, 60, 118])
def test_deviates_have_the_spread_of_their_kind(kind, share, k):
    numbers = deviate(kind, k)
    assert numbers.shape == (TRAINS,) and abs(numbers).max() <= 1
    assert numbers.mean() == pytest.approx(0, abs=0.01)
    assert numbers.std() == pytest.approx(share, rel=0.02)


def test_parts_do_not_deviate_in_step():
    numbers = np.array([deviate("radial", k) for k in range(120)])
    assert abs(np.corrcoef(numbers) - np.eye(len(numbers))).max() < 0.1
    assert numbers.sum(0).var() == pytest.approx(len(numbers) / 3, rel=0.05)


def test_the_same_numbers_in_every_run():
    first, second = (played(r753()).shafts["shaft"] for _ in range(2))
    assert first.phase_error_95 == second.phase_error_95 and first.share_jammed == second.share_jammed


def test_all_lies_within_the_worst_case():
    gears = true(r753())
    t, met = solved(gears), cases(gears, solved(gears))
    found = by_chance(met, t.tree, ["shaft"], {})
    for key, m in t.meshes.items():
        assert m.backlash_min - 1e-12 <= found.smallest[key][0] and found.smallest[key][-1] <= m.backlash_max + 1e-12
    assert 0 <= found.phase["shaft"][0] and found.phase["shaft"][-1] <= t.shafts["shaft"].phase_error


def test_phase_errors_stand_in_order():
    """At mid-tolerance, root of squares, worst case; by chance between; the couples as their sines."""
    gears = r753()
    worst, play = solved(gears).shafts["shaft"].phase_error, played(gears, "aluminium").shafts["shaft"]
    assert play.phase_error_nominal < play.phase_error_rss < worst < play.phase_error_running
    assert play.phase_error_median == pytest.approx(play.phase_error_nominal, rel=0.01)
    assert play.phase_error_median < play.phase_error_95 < play.phase_error_99 < worst
    left = with_couple(play, 572.93)
    assert left.residual_couple_95 == pytest.approx(2 * 572.93 * math.sin(play.phase_error_95 / 2))
    assert left.residual_couple_nominal < left.residual_couple_rss < left.residual_couple_running
    assert play.residual_couple_rss is None


def test_phase_error_at_mid_tolerance_is_the_sum_of_the_reduced_plays():
    gears = r753()
    t, total = solved(gears), 0.0
    for m in t.meshes.values():
        driven = t.wheels[m.driven]
        j_wt = m.backlash_nominal / (math.cos(m.working_pressure_angle) * math.cos(t.system.base_helix_angle))
        total += j_wt / (m.working_diameter_driven / 2) * driven.teeth / 25
    assert played(gears).shafts["shaft"].phase_error_nominal == pytest.approx(total, rel=1e-12)


def test_root_of_squares_of_one_mesh_is_its_worst_case():
    gears = pair_1(allowances=SHAVED)
    assert played(gears).shafts["shaft"].phase_error_rss == pytest.approx(
        solved(gears).shafts["shaft"].phase_error, rel=1e-9
    )


def test_a_mesh_beside_the_way_adds_no_phase_error():
    """Two wheels on one driver: the last wheel is reached by its own mesh alone."""
    wheels = [wheel(name, 30, 0.0, allowance=(-20, -30)) for name in "abc"]
    branched = train(wheels, [mesh("a", "b", tolerance=20), mesh("a", "c", tolerance=20)])
    single = train([wheels[0], wheels[2]], [mesh("a", "c", tolerance=20)])
    assert played(branched).shafts["shaft"].phase_error_nominal == pytest.approx(
        played(single).shafts["shaft"].phase_error_nominal
    )
    assert played(branched).shafts["shaft"].phase_error_95 == pytest.approx(
        played(single).shafts["shaft"].phase_error_95, rel=0.02
    )


def test_what_does_not_vary_has_no_distribution():
    gears = changed(
        r753(),
        0,
        wheels={name: {"span_allowance": (-25e-6, -25e-6)} for name in ("crank", "central", "idler", "shaft")},
    )
    found = played(gears)
    assert found.meshes["crank_central"].share_jammed is None
    assert found.meshes["central_idler"].share_jammed is not None
    still = replace(gears, meshes=tuple(replace(m, tolerance=None) for m in gears.meshes))
    assert played(still).shafts["shaft"].phase_error_95 is None
