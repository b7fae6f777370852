# SPDX-License-Identifier: Apache-2.0
"""The sectors of a shaft with inner bearings: the given values, a search over all ends and half-angles, and what must
hold whatever is asked."""

import cmath
import json
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.countershaft.sizing import multipliers as m
from calc.countershaft.sizing.sectors import TooSmall, masses, pair, size
from calc.countershaft.sizing.stretches import gap_of, size_stretches, stretch_masses, stretches
from calc.sheet.errors import NoSolution
from calc.sheet.value import leaves, link_of, linked, trace
from tests.conftest import ROOT

GIVEN = json.loads((ROOT / "tests" / "data" / "shafts.json").read_text(encoding="utf-8"))
CASES = GIVEN["parameters"]["sizing"]
OMEGA, RHO, R, R_0 = 600.0, 7860.0, 0.022, 0.008
K = 2 / 3 * RHO * (R**3 - R_0**3)


def sized(U, P, where, rho=RHO, outer=R, core=R_0, fillet=0.0):
    return size_stretches(U, P, OMEGA, rho, outer, core, where, fillet)


def sums(found):
    """Unbalance and product of what was found, from masses, radii and places."""
    each = [(one.mass * one.radius * cmath.rect(1, one.angle), one.z) for one in found.sectors]
    return sum(u for u, _ in each), sum(u * z for u, z in each)


# --- the given values
@pytest.mark.parametrize("name", CASES)
def test_the_given_values(name):
    """Two of them have a gap of no width: there the sectors are today's pair."""
    case = CASES[name]
    where = [(a * 1e-3, b * 1e-3) for a, b in case.get("stretches_mm", ())]
    where = where or stretches(case["half_length_mm"] * 1e-3, [(0.0, case["gap_mm"] * 1e-3)])
    U = cmath.rect(case.get("unbalance_kgm", 0.0), math.radians(case.get("unbalance_deg", 0.0)))
    P = cmath.rect(case.get("product_kgm2", 0.0), math.radians(case.get("product_deg", 0.0)))
    sizes = case["density_kgm3"], case["outer_radius_mm"] * 1e-3, case["core_radius_mm"] * 1e-3
    found = sized(U, P, where, *sizes)
    last = found.sectors[-1]
    said = dict(utilisation=found.utilisation, mass=found.mass, length=last.length, z=last.z)
    said["half_angle"] = math.degrees(last.half_angle)
    for number, one in enumerate(found.sectors, 1):
        turned = math.degrees(one.angle)
        # below 0: on the other side; where force and couple point different ways the angle stands beside
        opposite = found.lightest and abs(turned - 180) < 1e-6
        said[f"sector.{number}.half_angle"] = math.degrees(one.half_angle) * (-1 if opposite else 1)
        said[f"sector.{number}.angle"] = turned % 360
        said[f"sector.{number}.from"], said[f"sector.{number}.to"] = (
            (one.z + side * one.length / 2) * 1e3 for side in (-1, 1)
        )
    values = [given for given in GIVEN["given"] if given["case"] == name]
    assert len(values) >= 3
    for given_ in values:
        near = pytest.approx(given_["is"], rel=given_.get("rel"), abs=given_.get("abs"))
        assert said[given_["value"]] == near, given_["value"]
    assert sums(found) == pytest.approx((U, P), abs=1e-12 * K)
    assert found.lightest == (case["kind"] != "moments")


# --- oracles
def searched(alpha, product, where):
    """Least Σ γ·β of one sector in each of two stretches, over all of its ends: a grid of four ends, the half-angles
    from force and couple, and smaller and smaller windows around its best."""
    low, high = np.repeat([a for a, _ in where], 2), np.repeat([b for _, b in where], 2)
    starts, width = [(low + high) / 2], (high - low) / 2
    for closer in range(70):
        steps = 15 if closer == 0 else 5
        grid = np.stack(np.meshgrid(*[np.linspace(-1, 1, steps)] * 4, indexing="ij"), -1).reshape(-1, 4)
        ends = np.unique(np.concatenate([np.clip(start + width * grid, low, high) for start in starts]), axis=0)
        b = ends[:, 1::2] - ends[:, ::2]
        ends, b = ends[(b > 1e-6).all(1)], b[(b > 1e-6).all(1)]
        z = (ends[:, 1::2] + ends[:, ::2]) / 2
        rear = (product - z[:, 0] * alpha) / (z[:, 1] - z[:, 0])
        sines = np.abs(np.stack([alpha - rear, rear], 1)) / b
        with np.errstate(invalid="ignore"):
            amount = np.where((sines <= 1).all(1), (b * np.arcsin(sines)).sum(1), np.inf)
        starts = ends[np.argsort(amount)[: 40 if closer == 0 else 4]]
        width = width * (0.3 if closer == 0 else 0.75)
    return amount.min()


@pytest.mark.parametrize("seed", range(6))
def test_no_ends_and_half_angles_are_lighter(seed):
    """Two stretches, a task at random: equal to a search over all four ends to 1e-6."""
    random = np.random.default_rng(seed)
    where = ((-1.0, random.uniform(-0.5, -0.1)), (random.uniform(0.0, 0.3), random.uniform(0.6, 1.0)))
    alpha, product = random.uniform(0.05, 1.0), random.uniform(-0.6, 0.6)
    share = random.uniform(0.2, 0.95) / m.utilisation(alpha, product, where)
    task = alpha * share, product * share
    lam = m.multipliers(*task, where)
    assert len(m.present(*lam, where)) == 2  # the search knows no stretch with two opposed sectors
    assert m.supply(*lam, where)[2] == pytest.approx(searched(*task, where), rel=1e-6)


FACES = st.lists(st.floats(0.03, 1.0), min_size=3, max_size=9).filter(lambda steps: len(steps) % 2)


@st.composite
def tasks(draw, most=0.999):
    """Stretches at random (with gaps between them), and a task of a share u of what they can give."""
    faces = np.concatenate([[0.0], np.cumsum(draw(FACES))])
    faces = 2 * faces / faces[-1] - draw(st.floats(0.6, 1.4))
    where = tuple(zip(faces[::2].tolist(), faces[1::2].tolist()))
    theta, u = draw(st.floats(0, 2 * math.pi)), draw(st.floats(0.02, most))
    alpha, product = math.cos(theta), math.sin(theta)
    share = u / m.utilisation(alpha, product, where)
    return alpha * share, product * share, where, u


@settings(max_examples=150, deadline=None)
@given(tasks())
def test_they_give_the_task_and_none_elsewhere_is_worth_more(case):
    """What proves the least mass for any task: of all ends and half-angles, on both sides of a stretch, no sector is
    worth more than the one that stands there.  For any other sectors that give α and Π have the mass
    λ_F·α + λ_C·Π less their worth."""
    alpha, product, where, _ = case
    lam_F, lam_C = m.multipliers(alpha, product, where)
    given_alpha, given_product, mass = m.supply(lam_F, lam_C, where)
    assert (given_alpha, given_product) == pytest.approx((alpha, product), abs=2e-9)
    standing = 0.0
    for a, b in where:
        ours = {1.0: 0.0, -1.0: 0.0}
        for part in m.parts(lam_F, lam_C, ((a, b),)):
            gamma, beta = m.grown(m.worth(lam_F=lam_F, lam_C=lam_C, zeta=part.outer), lam_C, part.length)
            middle = part.outer + part.inward * beta / 2
            ours[part.side] = abs(lam_F + lam_C * middle) * beta * math.sin(gamma) - gamma * beta
            standing += ours[part.side]
        ends = np.linspace(a, b, 121)
        start, end = (x.ravel() for x in np.meshgrid(ends, ends))
        length = np.maximum(end - start, 0.0)
        for side, best in ours.items():
            force = np.maximum(side * (lam_F + lam_C * (start + end) / 2) * length, length)  # at 0°: worth nothing
            worth = np.sqrt(force**2 - length**2) - length * np.arccos(length / np.maximum(force, 1e-300))
            assert worth.max() <= best + 1e-12 * abs(lam_F) + 1e-12
            assert best == pytest.approx(worth.max(), rel=2e-2, abs=2e-3)
    assert mass == pytest.approx(lam_F * alpha + lam_C * product - standing, rel=1e-8, abs=1e-9)


@settings(max_examples=30, deadline=None)
@given(tasks())
def test_the_utilisation_is_the_largest_over_all_directions(case):
    """Of 20 000 directions of the multipliers, with |h| summed over its two sides."""
    alpha, product, where, u = case
    theta = np.linspace(0, 2 * math.pi, 20_001)
    x, y = np.cos(theta), np.sin(theta)
    area = lambda z: (x + y * z) * np.abs(x + y * z) / (2 * y)  # noqa: E731  # its slope over z is |x + y·z|
    with np.errstate(divide="ignore", invalid="ignore"):
        envelope = sum(area(b) - area(a) for a, b in where)
        ratio = np.where(np.abs(y) > 1e-4, (alpha * x + product * y) / envelope, 0.0)
    assert u >= ratio.max() - 1e-9 and m.utilisation(alpha, product, where) == pytest.approx(u, rel=1e-12)
    assert u == pytest.approx(ratio.max(), abs=1e-4)


@settings(max_examples=60, deadline=None)
@given(tasks(most=0.9), st.sampled_from([1 - 1e-9, 1 + 1e-9]))
def test_refused_exactly_where_more_is_asked_than_can_be(case, share):
    alpha, product, where, u = case
    task = (share / u * alpha * K, share / u * product * K)
    if share > 1:
        with pytest.raises(TooSmall) as caught:
            sized(*task, where)
        assert caught.value.possible == pytest.approx(1 / share, rel=1e-11)
    else:
        assert sums(sized(*task, where)) == pytest.approx(task, abs=1e-8 * K)


# --- what must hold whatever is asked
@settings(max_examples=40, deadline=None)
@given(tasks(), st.floats(0.2, 5.0), st.floats(0.3, 3.0), st.floats(-math.pi, math.pi))
def test_they_scale_turn_and_mirror_with_the_task(case, x, y, turn):
    """Lengths times x, densities times y: the same half-angles; the task turned: the same sectors, turned; the shaft
    seen from the other end: the same sectors, in the other order."""
    alpha, product, where, _ = case
    U, P = alpha * K, product * K
    found = sized(U, P, where)
    larger = sized(U * x**4 * y, P * x**5 * y, [(a * x, b * x) for a, b in where], RHO * y, R * x, R_0 * x)
    turned = sized(U * cmath.rect(1, turn), P * cmath.rect(1, turn), where)
    mirrored = sized(U, -P, [(-b, -a) for a, b in reversed(where)])
    assert len(found.sectors) == len(larger.sectors) == len(turned.sectors) == len(mirrored.sectors)
    assert larger.mass == pytest.approx(found.mass * x**3 * y, rel=1e-7)
    assert turned.mass == pytest.approx(found.mass, rel=1e-7) and mirrored.mass == pytest.approx(found.mass, rel=1e-7)
    near = dict(rel=1e-5, abs=1e-6)
    for one, large, other, seen in zip(
        found.sectors, larger.sectors, turned.sectors, reversed(mirrored.sectors), strict=True
    ):
        assert (large.half_angle, large.z) == pytest.approx((one.half_angle, one.z * x), **near)
        assert cmath.rect(1, other.angle) == pytest.approx(cmath.rect(1, one.angle + turn), abs=1e-9)
        assert (seen.half_angle, seen.z, seen.length) == pytest.approx((one.half_angle, -one.z, one.length), **near)


@settings(max_examples=40, deadline=None)
@given(st.floats(0.01, 0.999), st.floats(0.0, 0.95))
def test_a_pure_couple_beside_one_bearing_at_the_middle(u, gap):
    """Two equal sectors: b the smaller of 2q/(1+q)·z_max and what the gap leaves, and b·(z_max − b/2)·sin γ = P/(2k)."""
    z_max, half = 0.1, gap * 0.1
    most = (z_max - half) * (z_max + half) / 2  # b·(z_max − b/2) at the full length
    P = u * 2 * K * most
    found = sized(0j, P, stretches(z_max, [(0.0, 2 * half)]))
    front, rear = found.sectors
    gamma = rear.half_angle
    q = 1 - gamma / math.tan(gamma)
    assert found.utilisation == pytest.approx(u, rel=1e-9)
    assert rear.length == pytest.approx(min(2 * q / (1 + q) * z_max, z_max - half), rel=1e-6)
    assert rear.length * (z_max - rear.length / 2) * math.sin(gamma) == pytest.approx(P / (2 * K), rel=1e-9)
    assert (front.mass, front.z) == pytest.approx((rear.mass, -rear.z), rel=1e-9)
    if half < z_max - rear.length - 1e-9:  # the gap does not reach the sectors: today's pair
        assert found.mass == pytest.approx(2 * pair(P * OMEGA**2, OMEGA, RHO, R, R_0, z_max).mass, rel=1e-9)


@settings(max_examples=40, deadline=None)
@given(st.floats(0.02, 0.95), st.floats(0.0, 0.3))
def test_a_couple_that_leads_in_one_stretch_takes_todays_pair(u, force):
    """Where h changes its sign between two sectors that reach the ends, both searches have the same sectors."""
    where = ((-1.0, 1.0),)
    share = u / m.utilisation(force, 1.0, where)
    lam = m.multipliers(force * share, share, where)
    found = m.supply(*lam, where)[2]
    alone = masses(force * share * K, share * K, RHO, R, R_0, 1.0).item() / (RHO * (R**2 - R_0**2))
    if len(m.present(*lam, where)) == 2:
        assert found == pytest.approx(alone, rel=1e-6)
    else:  # one sector does it, with both ends free
        assert found <= alone * (1 + 1e-6)


@given(st.floats(0.01, 1.0))
def test_a_force_alone_fills_all_stretches_alike(u):
    where = stretches(0.1, [(-0.04, 0.02), (0.04, 0.02)])
    found = sized(u * 0.16j * K, 0j, where)
    assert found.utilisation == pytest.approx(u, rel=1e-9) and len(found.sectors) == 3
    for one, (a, b) in zip(found.sectors, where):
        assert math.sin(one.half_angle) == pytest.approx(u, rel=1e-9)
        assert (one.length, one.z, one.angle) == pytest.approx((b - a, (a + b) / 2, math.pi / 2), abs=1e-12)


def test_a_wider_gap_is_never_lighter_and_nothing_jumps():
    """From a gap of nothing to the widest that serves, a task between force and couple."""
    U, P = 0.25 * K * 0.1, 0.3 * K * 0.01
    widths = np.linspace(0.0, 0.08, 81)
    found = [sized(U, P, stretches(0.1, [(0.01, width)])).mass for width in widths]
    steps = np.diff(found)
    assert (steps >= -1e-12).all() and steps.max() < 0.02 * found[0]


@settings(max_examples=25, deadline=None)
@given(st.floats(0.02, 0.9), st.floats(-math.pi, math.pi), st.floats(-0.05, 0.05))
def test_one_stretch_carries_todays_pair_about_its_own_middle(u, phase, middle):
    where = ((middle - 0.08, middle + 0.08),)
    U, P = u * 0.08 * K, cmath.rect(0.1 * 0.08**2 * K, phase)
    found = sized(U, P + middle * U, where)
    today = size(U, P, OMEGA, RHO, R, R_0, 0.08)
    assert sums(found) == pytest.approx((U, P + middle * U), abs=1e-9 * K)
    assert found.mass == pytest.approx(today.mass, rel=1e-6)
    assert stretch_masses(U, P + middle * U, RHO, R, R_0, where) == pytest.approx(found.mass, rel=1e-6)


# --- force and couple in different directions
def test_two_stretches_are_filled_where_force_and_couple_point_different_ways():
    where = ((-0.1, -0.02), (0.03, 0.09))
    U, P = 0.02 * K, 0.003j * K
    found = sized(U, P, where)
    assert [one.length for one in found.sectors] == pytest.approx([0.08, 0.06])
    assert sums(found) == pytest.approx((U, P), rel=1e-12)
    assert found.utilisation == pytest.approx(max(math.sin(one.half_angle) for one in found.sectors))
    assert not found.lightest and sized(U, 0.0001 * K, where).lightest


def test_filled_stretches_are_not_the_most_that_unequal_ones_hold():
    """What the module says of them: with a front sector of 0.37 in place of 0.68 the larger sine falls by 12 %."""
    where = ((-1.0, -0.32), (0.42, 0.71))
    U, P = (-0.106 - 0.127j) * K, (0.369 - 0.086j) * K
    filled = sized(U, P, where)
    shorter = sized(U, P, ((-1.0, -0.63), where[1]))
    assert 0.8 < shorter.utilisation / filled.utilisation < 0.9 and shorter.mass < 0.95 * filled.mass


@settings(max_examples=20, deadline=None)
@given(tasks())
def test_what_a_twisted_sector_would_save(case):
    """The least mass where every slice may have its own half-angle, bounded from below at any multipliers: 2.5 % less
    at most."""
    alpha, product, where, _ = case
    lam = np.array(m.multipliers(alpha, product, where))
    mass = m.supply(*lam, where)[2]

    def bound(lam):
        least = lam @ (alpha, product)
        for a, b in where:
            ends = np.linspace(a, b, 2001)
            h = np.maximum(np.abs(lam[0] + lam[1] * (ends[1:] + ends[:-1]) / 2), 1.0)
            least -= np.mean(np.sqrt(h**2 - 1) - np.arccos(1 / h)) * (b - a)
        return least

    step, least = 0.1 * np.hypot(*lam), bound(lam)
    compass = np.exp(2j * np.pi * np.arange(12) / 12)
    while step > 1e-4 * np.hypot(*lam):
        around = [lam + step * np.array([way.real, way.imag]) for way in compass]
        best = max(around, key=bound)
        if bound(best) > least:
            lam, least = best, bound(best)
        else:
            step /= 2
    assert 0.975 * mass < least <= mass * (1 + 1e-6)


def test_next_to_nothing_across_is_one_direction():
    """Between sectors that must not turn a couple across of 1e-9 is no reason to refuse; one of 1e-5 is."""
    where = stretches(0.1, [(-0.04, 0.02), (0.04, 0.02)])
    straight = sized(0.05 * K, 0j, where).mass
    assert sized(0.05 * K, 1e-9j * 0.005 * K, where).mass == pytest.approx(straight, rel=1e-9)
    with pytest.raises(NoSolution, match=r"point 90° apart; one direction .* of 3 stretches .* give the masses"):
        sized(0.05 * K, 1e-5j * 0.005 * K, where)
    with pytest.raises(NoSolution, match="point 150° apart"):
        sized(0.05 * K, cmath.rect(0.001 * K, math.radians(150)), where)


# --- where it does not fit
LONG = stretches(0.1, [(-0.04, 0.02), (0.03, 0.01)])


@pytest.mark.parametrize(
    "U, P, where",
    [
        (0.2 * K, 0j, LONG),
        (0.06 * K, 0.0088 * K, LONG),
        (0.04j * K, 0.009j * K, ((-0.1, -0.02), (0.03, 0.09))),
        (0.06 * K, 0.008j * K, ((-0.1, -0.02), (0.03, 0.09))),
    ],
)
def test_what_is_needed_is_just_enough(U, P, where):
    with pytest.raises(TooSmall, match="does not fit into the envelope") as caught:
        sized(U, P, where)
    none, more = caught.value, 1 + 1e-9

    def used_up(U=U, P=P, where=where, **changed):
        return sized(U, P, where, **changed).utilisation == pytest.approx(1, abs=1e-7)

    assert used_up(outer=none.outer_radius * more) and used_up(rho=none.density * more)
    longer = none.half_length * more - 0.1
    assert used_up(where=((where[0][0] - longer, where[0][1]), *where[1:-1], (where[-1][0], where[-1][1] + longer)))
    assert used_up(U * none.possible * (1 - 1e-9), P * none.possible * (1 - 1e-9))
    if none.product is not None:
        assert used_up(P=P * (1 - none.product * more / abs(P)))
    if none.gap is not None:
        faces = np.ravel(where)
        gaps = faces[2::2] - faces[1:-1:2]
        less = np.minimum(none.gap * more, gaps) / 2
        faces[1:-1:2] += less
        faces[2::2] -= less
        assert used_up(where=tuple(zip(faces[::2].tolist(), faces[1::2].tolist())))
    assert ("which they fill" in none.tried) == (U.real != 0 and P.imag != 0)
    words = "an outer radius of", "a half-length of", "gaps at the inner bearings", "extras", "kg/m³"
    there = True, True, none.gap is not None, none.product is not None, True
    assert [word in none.advice for word in words] == list(there)


def test_what_no_gap_and_no_further_element_helps():
    """A force beyond what the stretches hold when they touch; and a density that tungsten does not have: it takes a
    larger radius too."""
    with pytest.raises(TooSmall) as caught:
        sized(0.5 * K, 0.001 * K, LONG)
    none = caught.value
    assert none.gap is None and none.product is None and none.density > 17600
    (radius,) = [
        part
        for part in str(none.advice).split(", or ")
        if part.startswith("tungsten (17600 kg/m³) and an outer radius")
    ]
    outer = float(radius.split()[-2]) * 1e-3
    assert sized(0.5 * K, 0.001 * K, LONG, 17600.0, outer).utilisation == pytest.approx(1, abs=2e-3)
    with pytest.raises(TooSmall):
        sized(0.5 * K, 0.001 * K, LONG, 17600.0, outer - 1.01e-5)


def test_a_heavier_material_of_the_sectors_saves_length_not_unbalance():
    light, heavy = (sized(0.06 * K, 0.001 * K, LONG, rho) for rho in (RHO, 17600.0))
    assert sums(light) == pytest.approx(sums(heavy), rel=1e-9)
    assert heavy.utilisation == pytest.approx(light.utilisation * RHO / 17600.0, rel=1e-9)


def test_nothing_to_do_and_no_room_are_said():
    with pytest.raises(NoSolution, match="nothing"):
        sized(0j, 0j, LONG)
    with pytest.raises(NoSolution, match="no room for sectors"):
        sized(0.01 * K, 0j, stretches(0.1, [(0.0, 0.3)]))


# --- the stretches
def test_the_stretches_that_the_gaps_leave():
    """Around each bearing, in any order, off the middle too; overlapping gaps, one at the end, one beyond it."""
    assert stretches(0.1, []) == ((-0.1, 0.1),)
    assert stretches(0.1, [(0.0, 0.0)]) == ((-0.1, 0.0), (0.0, 0.1))
    assert stretches(0.1, [(0.05, 0.02), (-0.03, 0.04)]) == pytest.approx(
        np.array([(-0.1, -0.05), (-0.01, 0.04), (0.06, 0.1)])
    )
    assert stretches(0.1, [(0.0, 0.06), (0.05, 0.06)]) == pytest.approx(np.array([(-0.1, -0.03), (0.08, 0.1)]))
    assert stretches(0.1, [(0.1, 0.04), (-0.2, 0.04)]) == pytest.approx(np.array([(-0.1, 0.08)]))
    assert gap_of(l=0.018, r=1.5e-3) == pytest.approx(0.024)


# --- many at once, and what is handed on
@pytest.mark.parametrize("P", [0.001 * K, 0.001j * K])
@pytest.mark.parametrize("where", [LONG, ((-0.1, -0.02), (0.03, 0.09)), ((-0.1, 0.08),)])
def test_the_masses_of_many_envelopes(P, where):
    radii = np.array([0.03, 0.022, 0.009])
    found = stretch_masses(0.05 * K, P, RHO, radii, R_0, where)
    for mass, radius in zip(found, radii):
        try:
            assert mass == pytest.approx(sized(0.05 * K, P, where, outer=radius).mass, rel=1e-7)
        except NoSolution:
            assert math.isnan(mass)
    assert math.isnan(found[-1])
    assert math.isnan(found[0]) == (len(where) == 3 and P.imag > 0)


def test_every_number_is_led_back_to_what_was_asked():
    """The chain of a mass ends at the keys of what was handed in."""
    where = stretches(linked(0.1, "half_length"), [(linked(0.01, "place"), linked(0.03, "gap"))])
    with trace() as lines:
        found = sized(linked(0.03 * K + 0j, "force"), linked(0.001 * K + 0j, "product"), where, linked(RHO, "density"))
    pending, ends = [*leaves(link_of(found.mass))], set()
    while pending:
        leaf = pending.pop()
        if isinstance(leaf, str):
            ends.add(leaf)
        else:
            assert leaf in lines
            pending += [further for argument in leaf.arguments.values() for further in leaves(link_of(argument))]
    assert ends == {"force", "product", "density", "half_length", "place", "gap"}
    assert 15 < len(lines) < 40
