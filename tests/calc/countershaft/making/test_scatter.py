"""Shafts by chance: closed forms where there are any, limits and symmetries elsewhere.

The shaft is that of Finotti 2013, Table 4.1, but with equal masses, so that by itself it balances its engine exactly.
"""

import math
import struct
from dataclasses import replace
from itertools import pairwise, product
from random import Random

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.countershaft import formulas as f
from calc.countershaft.inputs import EccentricMass, Extra, Holes, Scatter
from calc.countershaft.making import scatter as sc
from calc.countershaft.making.unbalance import calibration, permitted

OMEGA = 2 * math.pi * 2600 / 60
DEGREE = math.pi / 180
MASSES = (
    EccentricMass(name="front", mass=2.69, radius=0.0187, angle=210 * DEGREE, z=-0.0768),
    EccentricMass(name="rear", mass=2.69, radius=0.0187, angle=30 * DEGREE, z=0.0768),
)
EXTRA = Extra(name="hole", mass=-0.05, radius=0.024, angle=100 * DEGREE, z=0.16)
NONE = Scatter(mass=0.0, radius=0.0, angle=0.0, z=0.0)
SOME = Scatter(mass=0.010, radius=1e-4, angle=0.05 * DEGREE, z=2e-4, timing=0.2 * DEGREE)
HOLES = calibration(
    Holes(diameter=0.014, depth=0.020, count=4), 7860.0, 0.040, np.array([-0.0768, 0.0768]), OMEGA, 572.932
)


def vectors(masses=MASSES, extras=()):
    m, e, gamma, z = (np.array([getattr(x, name) for x in (*masses, *extras)]) for name in sc.NAMES)
    return f.shaft_force(omega=OMEGA, m=m, e=e, gamma=gamma), f.shaft_couple(omega=OMEGA, m=m, e=e, z=z, gamma=gamma)


FORCE, COUPLE = vectors()


def target(grade="G6.3", couple_left=0.0, z_S=0.0, **changes):
    t = permitted(grade, 8.914, OMEGA, z_S, -0.1675, 0.1675, abs(COUPLE))
    made = sc.Target(
        omega=OMEGA,
        couple=COUPLE,
        force=0j,
        couple_left=couple_left,
        z_f=-0.1675,
        z_r=0.1675,
        permitted_front=t.residual_unbalance_permitted_front,
        permitted_rear=t.residual_unbalance_permitted_rear,
    )
    return replace(made, **changes)


def heavier(share):
    return tuple(replace(mass, mass=mass.mass * (1 + share)) for mass in MASSES)


def found(scatter=SOME, masses=MASSES, extras=(), holes=HOLES, **changes):
    return sc.scattered(scatter, masses, extras, target(**changes), holes)


def total(r):
    return r.share_within + r.share_drilled_within + r.share_too_light + r.share_beyond_drilling


# --- without chance
@pytest.mark.parametrize("extras", [(), (EXTRA,)])
def test_without_scatter_every_shaft_is_the_drawing_exactly(extras):
    masses = heavier(0.02)
    r = found(NONE, masses, extras, holes=None, couple_left=7.0)
    nominal = 7.0 + abs(vectors(masses, extras)[1] - COUPLE)
    assert (r.residual == nominal).all()
    assert (
        r.residual_couple_median == r.residual_couple_95 == r.residual_couple_99 == r.residual_couple_largest == nominal
    )
    assert r.couple_error == 0


def test_a_shaft_made_heavier_by_less_than_the_range_is_drilled_to_nothing():
    r = found(NONE, heavier(0.014))
    assert (r.share_to_drill, r.share_drilled_within) == (1, 1)
    assert r.residual_couple_95 == pytest.approx(0.014 * abs(COUPLE))
    assert r.drilled_couple_95 == pytest.approx(0, abs=1e-3 * abs(COUPLE) * 0.014)


def test_a_light_shaft_is_not_drilled():
    r = found(NONE, heavier(-0.02))
    assert r.share_too_light == 1
    assert r.drilled_couple_95 == r.residual_couple_95


def test_a_shaft_heavier_than_the_range_is_beyond_drilling():
    """The holes reach 2.9 %: of 5 % they leave the difference."""
    r = found(NONE, heavier(0.05))
    assert r.share_beyond_drilling == 1
    assert r.drilled_couple_95 == pytest.approx(0.05 * abs(COUPLE) - HOLES.hole_range, rel=1e-6)


def test_a_shaft_at_a_wrong_angle_is_beyond_drilling():
    turned = tuple(replace(mass, angle=mass.angle + 2 * DEGREE) for mass in MASSES)
    assert found(NONE, turned).share_beyond_drilling == 1


def test_an_unbalance_in_the_plane_of_a_bearing_is_seen_there_alone():
    t = target(force=3 - 2j)
    U = 1e-4 * np.exp(0.7j)
    seen = t.deviation(np.array([3 - 2j + OMEGA**2 * U]), np.array([COUPLE + OMEGA**2 * U * t.z_r]))
    assert abs(seen[0, 0]) == pytest.approx(0, abs=1e-9)
    assert abs(seen[1, 0]) == pytest.approx(1e-4 / t.permitted_rear)


@pytest.mark.parametrize("z, gamma", [(-0.05, 0.4), (0.02, 2.0), (0.31, -1.0)])
def test_an_unbalance_is_shared_by_the_planes_as_by_a_lever(z, gamma):
    """What a mass is in the planes of its bearings, each over what is permitted there."""
    t = target(force=3 - 2j, z_f=-0.1, z_r=0.23, permitted_front=2e-4, permitted_rear=5e-4)
    U = 1e-4 * np.exp(1j * gamma)
    seen = t.deviation(np.array([3 - 2j + OMEGA**2 * U]), np.array([COUPLE + OMEGA**2 * U * z]))[:, 0]
    assert seen == pytest.approx([U * (0.23 - z) / 0.33 / 2e-4, U * (z + 0.1) / 0.33 / 5e-4])
    assert t.influence((replace(MASSES[0], z=z, angle=gamma),))[:, 0] * 1e-4 == pytest.approx(seen)


@pytest.mark.parametrize("share, outcome", [(0.999, "out"), (1.001, "within")])
def test_the_shares_change_where_the_worse_plane_is_at_what_is_permitted(share, outcome):
    """Of a shaft without scatter: too heavy, drilled as far as it goes; and turned by 1°, to which what is taken off or
    added stands square."""

    def judged(masses, couple):
        permitted = share * couple / 0.335 / OMEGA**2
        r = found(NONE, masses, permitted_front=permitted, permitted_rear=permitted)
        return r.share_within, r.share_drilled_within, r.share_too_light, r.share_beyond_drilling

    reached, C = outcome == "within", abs(COUPLE)
    assert judged(heavier(0.02), 0.02 * C)[0] == reached
    assert judged(heavier(0.05), 0.05 * C - HOLES.hole_range)[1::2] == (reached, not reached)
    turned = tuple(replace(mass, angle=mass.angle + DEGREE) for mass in heavier(-0.02))
    assert judged(turned, C * math.sin(DEGREE))[2:] == (reached, not reached)


def test_a_shaft_that_must_carry_a_force_is_measured_against_that_force():
    masses = (MASSES[0], replace(MASSES[1], mass=4.0))
    force, couple = vectors(masses)
    assert found(NONE, masses, couple=couple, force=force).share_within == 1
    assert found(NONE, masses, couple=couple, force=0j).share_within == 0


# --- chance
def test_the_numbers_drawn_are_normally_distributed_and_do_not_hang_together():
    """Of 200 001 a share is known to 0.1 %, and the correlation of two series to 0.3 % (one deviation)."""
    z = sc.normal(Random(1), 200_001)
    for bound in (-2.5, -1.0, 0.0, 0.5, 2.0, 3.0):
        assert np.mean(z < bound) == pytest.approx((1 + math.erf(bound / math.sqrt(2))) / 2, abs=0.003)
    for one, other in ((z[::2][:-1], z[1::2]), (z[1:], z[:-1])):
        assert np.corrcoef(one, other)[0, 1] == pytest.approx(0, abs=0.01)
        assert np.corrcoef(one**2, other**2)[0, 1] == pytest.approx(0, abs=0.01)
    assert sc.normal(Random(1), 3, 5, 7).shape == (3, 5, 7)


def test_the_numbers_drawn_are_those_of_box_and_muller():
    """From 32 bits each; with one seed every machine meets the same luck."""
    bits = struct.unpack("<6I", Random(7).randbytes(24))
    u, v = ([(bit + 0.5) / 2**32 for bit in half] for half in (bits[:3], bits[3:]))
    lengths, angles = [math.sqrt(-2 * math.log(x)) for x in u], [2 * math.pi * x for x in v]
    wanted = [length * turn(angle) for length, angle in zip(lengths, angles) for turn in (math.cos, math.sin)]
    assert sc.normal(Random(7), 6) == pytest.approx(wanted, rel=1e-13)
    assert sc.normal(Random(7), 5) == pytest.approx(wanted[:5], rel=1e-13)
    assert sc.normal(Random(3), 1)[0] == pytest.approx(sc.normal(Random(3), 2)[0])


@pytest.mark.parametrize(
    "p, rank", [(0.0, 1), (0.004, 1), (0.0051, 2), (0.5, 100), (0.95, 190), (0.99, 198), (1.0, 200)]
)
def test_a_percentile_is_the_smallest_that_the_share_does_not_exceed(p, rank):
    assert sc.percentile(C=np.arange(1.0, 201.0), p=p) == rank


# --- closed forms
PARTS = {
    "mass": dict(mass=0.010),
    "radius": dict(radius=5e-5),
    "angle": dict(angle=0.1 * DEGREE),
    "position": dict(z=2e-4),
    "timing": dict(timing=0.1 * DEGREE),
}


@pytest.mark.parametrize("part", [*PARTS, "all"])
def test_chance_agrees_with_the_propagation_of_errors(part):
    """The root mean square of 50 000 lengths is known to 0.5 % or better."""
    given_ = {k: v for p in PARTS.values() for k, v in p.items()} if part == "all" else PARTS[part]
    scatter = replace(NONE, **given_)
    masses = (replace(MASSES[0], z=-0.05), replace(MASSES[1], mass=3.1))
    _, couple, timing, _ = sc.sample(scatter, masses, (EXTRA,), OMEGA, Random(5), 50_000)
    seen = math.sqrt(np.mean(np.abs(couple * timing - vectors(masses, (EXTRA,))[1]) ** 2))
    r = found(replace(scatter, shafts=100), masses, (EXTRA,), holes=None)
    assert seen == pytest.approx(r.couple_error if part == "all" else getattr(r, f"couple_error_by_{part}"), rel=0.015)
    assert r.couple_error == pytest.approx(math.sqrt(sum(getattr(r, f"couple_error_by_{p}") ** 2 for p in PARTS)))


def test_the_timing_of_a_shaft_has_nothing_to_do_with_its_masses():
    """The correlation of 20 000 pairs is known to 0.7 % (one deviation)."""
    force, couple, timing, _ = sc.sample(replace(SOME, timing=0.2 * DEGREE), MASSES, (), OMEGA, Random(2), 20_000)
    for part in (couple.real, couple.imag, force.real, force.imag, np.abs(couple)):
        assert np.corrcoef(part, np.angle(timing))[0, 1] == pytest.approx(0, abs=0.03)


def test_timing_alone_leaves_the_chord_of_its_angle():
    """|1 − e^{iδ}|·C = 2·sin(|δ|/2)·C; half of all |δ| stay below 0.67449 σ (normal distribution)."""
    scatter = replace(NONE, timing=0.5 * DEGREE)
    _, couple, timing, _ = sc.sample(scatter, MASSES, (), OMEGA, Random(1), 1000)
    delta = np.angle(timing)
    assert target().residual(couple, timing) == pytest.approx(2 * np.sin(np.abs(delta) / 2) * abs(COUPLE))
    r = found(replace(scatter, shafts=100_000))
    assert r.residual_couple_median == pytest.approx(
        2 * math.sin(0.67449 * scatter.timing / 2) * abs(COUPLE), rel=0.015
    )


def test_timing_is_neither_seen_nor_mended_by_balancing():
    r = found(replace(NONE, timing=2 * DEGREE))
    assert r.share_within == 1
    assert (r.residual == r.drilled).all()


def test_what_turns_the_other_way_stays_on_every_shaft():
    assert found(couple_left=20.0).residual == pytest.approx(found().residual + 20.0)


# --- drilling
lengths = st.floats(0.0, 30.0)
angles = st.floats(0.0, 2 * math.pi)


def test_recorded_drillings():
    """Recorded: the depths of three holes and the worse planes that they leave."""
    deviation = np.array(
        [[3.0 + 1.0j, -2.0 + 0.5j, 0.5 + 4.0j, 6.0j], [1.0 - 2.0j, 3.0 + 1.0j, 2.0 + 2.5j, 5.0 + 1.0j]]
    )
    masses = (replace(MASSES[0], z=-0.12), replace(MASSES[1], z=0.10, angle=0.4), replace(MASSES[0], z=0.03, angle=1.0))
    influence = target().influence(masses)
    taken = sc.drill(deviation, influence, 0.0, 4e-4)
    recorded = [
        [0.0, 334.245113485, 0.0, 0.0],
        [114.887559562, 350.025251651, 360.012936724, 400.0],
        [75.91931893, 230.907238495, 400.0, 400.0],
    ]
    assert taken * 1e6 == pytest.approx(np.array(recorded), rel=1e-6)
    recorded = [2.712143014, 1.113256558, 2.590637387, 4.633743946]
    assert sc.worse(deviation - influence @ taken) == pytest.approx(recorded, rel=1e-6)


@settings(max_examples=60, deadline=None)
@given(
    st.lists(st.tuples(lengths, angles, lengths, angles), min_size=1, max_size=5),
    st.floats(-0.15, 0.0),
    st.floats(0.02, 0.15),
    angles,
)
def test_drilling_never_makes_a_shaft_worse(rows, z_1, z_2, gamma):
    deviation = np.array([[a * np.exp(1j * b), c * np.exp(1j * d)] for a, b, c, d in rows]).T
    masses = (replace(MASSES[0], z=z_1), replace(MASSES[1], z=z_2, angle=gamma), replace(MASSES[0], z=0.05, angle=1.0))
    influence = target().influence(masses)
    taken = sc.drill(deviation, influence, 0.0, 2e-3)
    assert ((taken >= 0) & (taken <= 2e-3)).all()
    assert (sc.worse(deviation - influence @ taken) <= sc.worse(deviation) * (1 + 1e-9)).all()


@pytest.mark.parametrize(("share", "z_S"), [(0.0, 0.0), (0.0145, 0.0), (0.03, 0.05)])
def test_the_holes_are_the_best_of_a_fine_grid_of_depths(share, z_S):
    t = target(z_S=z_S)
    force, couple, _, _ = sc.sample(replace(SOME, angle=0.3 * DEGREE), heavier(share), (), OMEGA, Random(3), 40)
    deviation, influence, most = t.deviation(force, couple), t.influence(MASSES), HOLES.hole_unbalance_of_mass
    ours = sc.worse(deviation - influence @ sc.drill(deviation, influence, 0.0, most))
    depths = np.array(list(product(np.linspace(0, most, 201), repeat=2))).T
    grid = np.array([sc.worse(one[:, None] - influence @ depths).min() for one in deviation.T])
    assert (ours <= grid + 1e-3).all()
    assert ours == pytest.approx(grid, abs=0.1)  # the grid is that coarse


def test_shafts_within_tolerance_are_left_alone():
    small = replace(SOME, mass=1e-4, radius=1e-6, angle=1e-5, z=1e-6, timing=0.0)
    r = found(small)
    assert r.share_within == 1
    assert (r.residual == r.drilled).all()


# --- shares
@pytest.mark.parametrize("share", [-0.005, 0.0, 0.0145])
def test_a_wider_grade_lets_more_shafts_through(share):
    """The luck is the same whatever the grade."""
    results = [found(masses=heavier(share), grade=grade) for grade in ("G2.5", "G6.3", "G16", "G40", "G100")]
    assert all(total(r) == pytest.approx(1) for r in results)
    for narrow, wide in pairwise(results):
        assert wide.share_within >= narrow.share_within
        assert wide.share_to_drill == pytest.approx(1 - wide.share_within)
        assert wide.share_within + wide.share_drilled_within >= narrow.share_within + narrow.share_drilled_within
    assert results[0].share_to_drill > 0.5 > results[-1].share_to_drill


def test_overdesign_turns_light_shafts_into_ones_that_can_be_drilled():
    bare, over = found(), found(masses=heavier(0.0145))
    assert bare.share_too_light > 0.1 > over.share_too_light
    assert over.share_within + over.share_drilled_within > bare.share_within + bare.share_drilled_within
    assert over.drilled_couple_95 < bare.drilled_couple_95


def test_without_holes_nothing_is_said_of_drilling():
    r = found(holes=None)
    assert r.drilled is None and r.share_too_light is None and r.drilled_couple_95 is None
    assert r.share_within == found().share_within


def test_one_seed_one_result():
    assert (found().residual == found().residual).all()
    assert found(replace(SOME, seed=2)).residual_couple_95 != found().residual_couple_95
    assert found(replace(SOME, seed=2)).residual_couple_95 == pytest.approx(found().residual_couple_95, rel=0.05)


@pytest.mark.parametrize("shafts", [100, 5_000, 12_345])
def test_as_many_shafts_as_were_asked_for(shafts):
    r = found(replace(SOME, shafts=shafts))
    assert r.residual.size == r.drilled.size == shafts
    for name, p in (("median", 0.5), ("95", 0.95), ("99", 0.99)):
        assert np.mean(r.residual <= getattr(r, f"residual_couple_{name}")) == pytest.approx(p, abs=1 / shafts)
    assert np.mean(r.drilled <= r.drilled_couple_median) == pytest.approx(0.5, abs=1 / shafts)
    assert r.residual_couple_largest == r.residual.max()
    recorded = {
        100: 8.417530699656997,
        5_000: 10.89029947880727,
        12_345: 11.0308922311302,
    }  # the second block goes on with the luck of the first
    assert r.residual_couple_largest == pytest.approx(recorded[shafts], rel=1e-9)


# --- what is said
def test_the_curve_is_the_distribution_and_has_the_limit():
    r = found()
    (curve,) = sc.curves(r, 28.6)
    assert curve.limits == (("limit", 28.6),)
    assert [s.label for s in curve.series] == ["as made", "after drilling"]
    for series, ordered in zip(curve.series, (r.residual, r.drilled)):
        assert series.x == pytest.approx(np.arange(0, 100.1, 0.5))
        rank = np.arange(201) * r.residual.size // 200
        assert (ordered[np.maximum(rank - 1, 0)] <= series.y).all() and (series.y[:-1] <= ordered[rank[:-1]]).all()
    assert curve.series[0].y[-1] == r.residual_couple_largest
    assert np.interp(95, curve.series[1].x, curve.series[1].y) == pytest.approx(r.drilled_couple_95)


def test_the_table_of_shares_adds_up():
    (table,) = sc.tables(found())
    assert sum(row[2] for row in table.rows) == pytest.approx(100)
    (empty,) = sc.tables(found(NONE))
    assert all(row[2] is None for row in empty.rows)


def test_the_check_judges_what_leaves_the_factory():
    drilled, made = found(masses=heavier(0.0145)), found(masses=heavier(0.0145), holes=None)
    limit = (drilled.drilled_couple_95 + made.residual_couple_95) / 2
    assert sc.residual_check(drilled, limit).verdict == "pass"
    assert sc.residual_check(made, limit).verdict == "warn"


def test_deviations_beyond_reason_are_said():
    wild = replace(SOME, mass=2.0)
    below = found(wild)
    mass = 2.69 + 2.0 * sc.normal(Random(wild.seed), 4, wild.shafts, 2)[0]
    assert below.impossible == (mass.min(1) < 0).sum() > 100
    assert any(f"{below.impossible} shafts have a mass below zero" in note for note in sc.notes(wild, below))
    assert not any("below zero" in note for note in sc.notes(SOME, found()))
