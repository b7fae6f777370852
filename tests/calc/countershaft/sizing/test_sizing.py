"""The lightest pair of sectors: the closed form, the search, and what is said where the envelope is too small."""

import cmath
import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from calc.countershaft.inputs import Extra
from calc.countershaft.sizing import lengths
from calc.countershaft.sizing.sectors import TooSmall, eccentric_masses, masses, pair, pair_masses, pieces, size
from calc.sheet.errors import NoSolution
from calc.sheet.functions import root
from calc.sheet.value import leaves, link_of, linked, trace

OMEGA = 2 * math.pi * 2600 / 60
C, RHO = 572.932, 7860.0  # N·m, kg/m³
P = C / OMEGA**2 * cmath.rect(1, math.radians(30))


# --- a pure couple
@pytest.mark.parametrize(
    "R, r_0, z_max, u, gamma, b, z_c, e, m",
    [
        (40.5, 15, 154, 0.986, 83.70, 140.48, 83.76, 20.211, 2.283),
        (43, 15, 152, 0.839, 68.25, 104.62, 99.69, 24.370, 1.591),
    ],
)
def test_envelopes_of_the_closed_form(R, r_0, z_max, u, gamma, b, z_c, e, m):
    """Figures of the closed form, worked out apart from this program; half a unit of the last digit."""
    found = pair(C, OMEGA, RHO, R * 1e-3, r_0 * 1e-3, z_max * 1e-3)
    assert found.utilisation == pytest.approx(u, abs=5e-4)
    assert math.degrees(found.half_angle) == pytest.approx(gamma, abs=5e-3)
    assert found.length * 1e3 == pytest.approx(b, abs=5e-3)
    assert found.arm * 1e3 == pytest.approx(z_c, abs=5e-3)
    assert found.radius * 1e3 == pytest.approx(e, abs=5e-4)
    assert found.mass == pytest.approx(m, abs=5e-4)
    assert found.couple == pytest.approx(C, rel=1e-12)


def test_an_envelope_that_is_too_small():
    """R 40.2, core 15, ±152 mm: utilisation 1.037, at most 552.8 N·m.  What is said to be needed is then just
    enough."""
    with pytest.raises(TooSmall, match=r"552\.8 N·m at most .utilisation 1\.037") as caught:
        pair(C, OMEGA, RHO, 0.0402, 0.015, 0.152)
    none = caught.value
    assert none.possible_couple == pytest.approx(552.8, abs=0.05)
    assert pair(C, OMEGA, RHO, none.outer_radius * (1 + 1e-9), 0.015, 0.152).utilisation == pytest.approx(1, abs=1e-7)
    assert pair(C, OMEGA, RHO, 0.0402, 0.015, none.half_length * (1 + 1e-9)).utilisation == pytest.approx(1, abs=1e-7)
    assert pair(
        C - none.product * OMEGA**2 * (1 + 1e-9), OMEGA, RHO, 0.0402, 0.015, 0.152
    ).utilisation == pytest.approx(1, abs=1e-7)
    for stands in ("outer radius of 40.66 mm", "half-length of 154.8 mm", "bring 272.3 kg·mm²"):
        assert stands in none.advice
    pair(C, OMEGA, RHO, 0.04066, 0.015, 0.152)
    pair(C, OMEGA, RHO, 0.0402, 0.015, 0.1548)


def random_envelopes(count, seed):
    random = np.random.default_rng(seed)
    R = random.uniform(20e-3, 60e-3, count)
    return np.column_stack(
        [
            random.uniform(50, 1500, count),
            random.uniform(100, 600, count),
            random.uniform(7000, 8000, count),
            R,
            R * random.uniform(0, 0.7, count),
            random.uniform(60e-3, 250e-3, count),
        ]
    )


def test_the_closed_form_is_the_least_of_a_search_over_half_angle_and_length():
    """200 envelopes: mass to 0.1 %, and those in which no half-angle and length give the couple are called too
    small."""
    fitting = 0
    for C_i, omega, rho, R, r_0, z_max in random_envelopes(200, 9):
        b = np.linspace(z_max / 20_000, z_max, 20_000)
        needed = C_i / (2 * rho * omega**2 * 2 / 3 * (R**3 - r_0**3) * b * (z_max - b / 2))  # sin γ
        if not np.any(needed <= 1):
            with pytest.raises(TooSmall):
                pair(C_i, omega, rho, R, r_0, z_max)
            continue
        fitting += 1
        least = np.nanmin(np.where(needed <= 1, rho * b * np.arcsin(np.minimum(needed, 1)) * (R**2 - r_0**2), np.inf))
        found = pair(C_i, omega, rho, R, r_0, z_max).mass
        assert found == pytest.approx(least, rel=1e-3) and found <= least * (1 + 1e-12)
    assert 50 < fitting < 180


def test_many_pairs_at_once():
    rows = random_envelopes(300, 4)
    many = pair_masses(*rows.T)
    for row, mass in zip(rows.tolist(), many.tolist()):
        if math.isnan(mass):
            with pytest.raises(TooSmall):
                pair(*row)
        else:
            assert 2 * pair(*row).mass == pytest.approx(mass, rel=1e-12)
    assert 50 < np.isnan(many).sum() < 250


def test_no_couple_needs_no_mass():
    assert pair_masses(0.0, OMEGA, RHO, 0.043, 0.015, 0.152) == 0
    assert pair(1e-9, OMEGA, RHO, 0.043, 0.015, 0.152).mass < 1e-9


@given(st.floats(1e-6, 1 - 1e-9))
def test_the_half_angle_solves_its_equation(u):
    """At u of the largest couple: 2·q·sin γ/(1 + q)² = u/2."""
    z_max = 0.1
    found = pair(u * 2 / 3 * RHO * OMEGA**2 * 0.04**3 * z_max**2, OMEGA, RHO, 0.04, 0.0, z_max)
    gamma = found.half_angle
    q = 1 - gamma / math.tan(gamma)
    assert 2 * q * math.sin(gamma) / (1 + q) ** 2 == pytest.approx(u / 2, rel=1e-9)
    assert 0 < gamma <= math.pi / 2 and 0 < found.length <= z_max


def test_a_gap_that_holds_no_two_fillets_is_closed():
    """Of an envelope that is nearly full: the same couple from sectors that meet, hardly heavier; a wider gap stays."""
    R, r_0, z_max, fillet = 0.043, 0.015, 0.15, 1.5e-3
    C = 0.9999 * pair(1.0, OMEGA, RHO, R, r_0, z_max).utilisation ** -1
    open_, closed = (pair(C, OMEGA, RHO, R, r_0, z_max, r) for r in (0.0, fillet))
    assert 0 < 2 * (z_max - open_.length) < 2 * fillet and closed.length == z_max
    assert closed.couple == pytest.approx(C, rel=1e-12) and open_.mass < closed.mass < open_.mass * 1.005
    assert vars(pair(0.99 * C, OMEGA, RHO, R, r_0, z_max, fillet)) == vars(pair(0.99 * C, OMEGA, RHO, R, r_0, z_max))


def test_the_gap_of_two_unlike_sectors_is_closed_too():
    """A little force beside nearly the whole couple: both sectors are of full length, and give what is asked."""
    k = RHO * 2 / 3 * (0.043**3 - 0.015**3)
    U, P_ = 1e-5 * k * 0.15, 0.9999 * k * 0.15**2
    open_, closed = (size(U, P_, OMEGA, RHO, 0.043, 0.015, 0.15, fillet=r) for r in (0.0, 1.5e-3))
    assert 0 < 0.3 - open_.front.length - open_.rear.length < 3e-3
    assert closed.front.length == closed.rear.length == 0.15 and closed.mass >= open_.mass
    parts = [(m.mass * m.radius * cmath.rect(1, m.angle), m.z) for m in eccentric_masses(closed)]
    assert sum(u for u, _ in parts) == pytest.approx(U, abs=1e-9 * k * 0.15)
    assert sum(u * z for u, z in parts) == pytest.approx(P_, rel=1e-9)


# --- a force as well
@settings(max_examples=40, deadline=None)
@given(st.floats(0, 0.4), st.floats(0.05, 0.8), st.floats(-math.pi, math.pi), st.floats(-math.pi, math.pi))
def test_the_sectors_give_what_is_asked_and_turn_and_mirror_with_it(force, couple, phase, turn):
    k = RHO * 2 / 3 * (0.043**3 - 0.015**3)
    U, P_ = force * k * 0.152, cmath.rect(couple * k * 0.152**2, phase)
    try:
        one = size(U, P_, OMEGA, RHO, 0.043, 0.015, 0.152)
    except TooSmall:
        assume(False)
    parts = [(m.mass * m.radius * cmath.rect(1, m.angle), m.z) for m in eccentric_masses(one)]
    assert sum(u for u, _ in parts) == pytest.approx(U, abs=1e-9 * k * 0.152)
    assert sum(u * z for u, z in parts) == pytest.approx(P_, abs=1e-9 * k * 0.152**2)
    turned = size(U * cmath.rect(1, turn), P_ * cmath.rect(1, turn), OMEGA, RHO, 0.043, 0.015, 0.152)
    assert turned.mass == pytest.approx(one.mass, rel=1e-8)
    mirrored = size(U, -P_, OMEGA, RHO, 0.043, 0.015, 0.152)
    assert mirrored.mass == pytest.approx(one.mass, rel=1e-8)
    assert mirrored.front.mass == pytest.approx(one.rear.mass, rel=1e-4, abs=1e-6)


def test_a_force_alone_is_shared_by_two_thin_sectors_of_full_length():
    """An unbalance in mid-shaft: the longer a sector, the narrower and the lighter for its unbalance."""
    U = 0.01
    found = size(U, 0j, OMEGA, RHO, 0.043, 0.015, 0.152)
    assert found.front.length == pytest.approx(0.152) and found.rear.length == pytest.approx(0.152)
    assert found.front.mass == pytest.approx(found.rear.mass, rel=1e-9)
    assert found.front.mass * found.front.radius == pytest.approx(U / 2, rel=1e-9)
    assert found.front.angle == pytest.approx(found.rear.angle)


def test_what_one_sector_can_do_leaves_the_other_without_mass():
    """A force in the middle of the rear half, on the way to the closed end: nothing remains for the front."""
    k = RHO * 2 / 3 * (0.043**3 - 0.015**3)
    U = 0.3 * k * 0.152
    found = size(U, U * 0.076, OMEGA, RHO, 0.043, 0.015, 0.152)
    assert found.front.mass < 1e-6 * found.rear.mass
    assert found.rear.length == pytest.approx(0.152, rel=1e-4)
    assert all(piece.outer_radius == 0.043 for piece in pieces(found))


def test_a_little_force_changes_little():
    alone = size(0j, P, OMEGA, RHO, 0.043, 0.015, 0.152)
    for tiny in (1e-6, 1e-9, 1e-14):
        assert size(tiny * abs(P), P, OMEGA, RHO, 0.043, 0.015, 0.152).mass == pytest.approx(
            alone.mass, rel=max(1e-8, 10 * tiny)
        )


def test_a_longer_or_wider_envelope_is_never_heavier():
    before = size(2e-3, P, OMEGA, RHO, 0.043, 0.015, 0.152).mass
    assert size(2e-3, P, OMEGA, RHO, 0.0435, 0.015, 0.152).mass < before
    assert size(2e-3, P, OMEGA, RHO, 0.043, 0.015, 0.153).mass < before
    assert size(2e-3, P, OMEGA, RHO * 1.01, 0.043, 0.015, 0.152).mass < before


@pytest.mark.parametrize("force", [0.0, 5e-3, 0.02 + 0.01j])
def test_what_is_needed_is_just_enough(force):
    envelope = dict(R=0.0402, r_0=0.015, z_max=0.152)
    with pytest.raises(TooSmall) as caught:
        size(force, P, OMEGA, RHO, **envelope)
    none, more = caught.value, 1 + 1e-9
    for change in ({"R": none.outer_radius}, {"z_max": none.half_length}):
        ((key, exact),) = change.items()
        assert size(force, P, OMEGA, RHO, **{**envelope, key: exact * more}).utilisation == pytest.approx(1, abs=1e-7)
        with pytest.raises(TooSmall):
            size(force, P, OMEGA, RHO, **{**envelope, key: exact * (1 - 1e-7)})
    assert size(
        force * none.possible * (1 - 1e-9), P * none.possible * (1 - 1e-9), OMEGA, RHO, **envelope
    ).utilisation == pytest.approx(1, abs=1e-7)
    if none.product is not None:
        rest = P * (1 - none.product * more / abs(P))
        assert size(force, rest, OMEGA, RHO, **envelope).utilisation == pytest.approx(1, abs=1e-7)


def test_a_force_that_further_elements_can_not_help():
    """Their pure couple does not take away a force that is too large by itself."""
    k = RHO * 2 / 3 * (0.0402**3 - 0.015**3)
    with pytest.raises(TooSmall) as caught:
        size(2.1 * k * 0.152, 0.1 * P, OMEGA, RHO, 0.0402, 0.015, 0.152)
    assert caught.value.product is None and "extras" not in caught.value.advice


def test_nothing_to_balance_is_said():
    with pytest.raises(NoSolution, match="nothing"):
        size(0j, 0j, OMEGA, RHO, 0.043, 0.015, 0.152)


# --- further elements
def test_a_hole_and_its_counterpart_close_the_couple_of_a_full_envelope():
    """A shaft R 40.3, core Ø30, ±152 mm: a Ø12.13 hole through the rear journal (26.5 mm) at 24 mm radius and as much
    unbalance at z −202.25 mm on the other side bring 15.84 N·m; only with them does the envelope hold 572.932 N·m."""
    hole = RHO * math.pi / 4 * 12.13e-3**2 * 26.5e-3
    assert hole * 24 == pytest.approx(0.578, abs=5e-4)
    rear = math.radians(30)
    extras = (
        Extra(name="hole", mass=-hole, radius=0.024, angle=rear + math.pi, z=0.1675),
        Extra(name="stub", mass=hole, radius=0.024, angle=rear + math.pi, z=-0.20225),
    )
    with pytest.raises(TooSmall):
        size(0j, P, OMEGA, RHO, 0.0403, 0.015, 0.152)
    found = size(0j, P, OMEGA, RHO, 0.0403, 0.015, 0.152, extras)
    assert found.couple == pytest.approx(C - 15.84, abs=0.02)  # half a unit of 15.84 and of the hole's 12.13
    everything = (*eccentric_masses(found), *extras)
    assert sum(x.mass * x.radius * cmath.rect(1, x.angle) for x in everything) == pytest.approx(0, abs=1e-12)
    assert sum(x.mass * x.radius * x.z * cmath.rect(1, x.angle) for x in everything) == pytest.approx(P, rel=1e-9)


def test_elements_that_do_all_leave_nothing_to_size():
    U = abs(P) / 0.3
    extras = (
        Extra(name="front", mass=U / 0.02, radius=0.02, angle=cmath.phase(P) + math.pi, z=-0.15),
        Extra(name="rear", mass=U / 0.02, radius=0.02, angle=cmath.phase(P), z=0.15),
    )
    with pytest.raises(NoSolution, match="nothing"):
        size(0j, P, OMEGA, RHO, 0.043, 0.015, 0.152, extras)


# --- what is handed on
@pytest.mark.parametrize("force", [0j, 3e-3 + 1e-3j])
def test_masses_and_pieces_are_one_shaft(force):
    found = size(force, P, OMEGA, RHO, 0.043, 0.015, 0.152)
    front, rear = eccentric_masses(found)
    assert (front.name, rear.name) == ("front", "rear") and front.z < 0 < rear.z
    for mass, piece in zip((front, rear), pieces(found)):
        area = piece.half_angle * (piece.outer_radius**2 - piece.core_radius**2)
        assert RHO * area * piece.length == pytest.approx(mass.mass, rel=1e-12)
        assert (piece.start + piece.end) / 2 == pytest.approx(mass.z)
        assert piece.what == "sector" and piece.angle == mass.angle
    assert pieces(found)[0].start == pytest.approx(-0.152) and pieces(found)[1].end == pytest.approx(0.152)
    assert masses(force, P, RHO, np.array([0.043, 0.03]), 0.015, 0.152) == pytest.approx(
        [found.mass, np.nan], rel=1e-8, nan_ok=True
    )


@pytest.mark.parametrize("force", [0j, 3e-3 + 1e-3j])
def test_every_number_is_led_back_to_what_was_asked(force):
    """The chain of a mass ends at the keys of what was handed in."""
    asked = linked(complex(force), "force"), linked(complex(P), "product")
    with trace() as lines:
        found = size(*asked, OMEGA, linked(RHO, "density"), 0.043, 0.015, 0.152)
    pending, ends = [*leaves(link_of(found.mass))], set()
    while pending:
        leaf = pending.pop()
        if isinstance(leaf, str):
            ends.add(leaf)
        else:
            assert leaf in lines
            pending += [further for argument in leaf.arguments.values() for further in leaves(link_of(argument))]
    assert {"product", "density"} <= ends and (force == 0 or "force" in ends)
    assert 8 < len(lines) < 40


def test_the_least_radius_is_that_at_which_the_envelope_is_used_up():
    """Against a root of the utilisation over the radius."""
    with pytest.raises(TooSmall) as caught:
        size(4e-3, P, OMEGA, RHO, 0.0402, 0.015, 0.152)
    k = lambda R: RHO * 2 / 3 * (R**3 - 0.015**3)  # noqa: E731
    load = lambda R: float(lengths.utilisation(4e-3 / (k(R) * 0.152), P / (k(R) * 0.152**2))[0]) - 1  # noqa: E731
    assert root(load, 0.0402, 0.06) == pytest.approx(caught.value.outer_radius, rel=1e-9)
