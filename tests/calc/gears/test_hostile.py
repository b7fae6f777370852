"""Impossible gears: a clear word instead of a wrong number."""

import math

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from calc.gears import solve
from calc.gears.curves import curves
from calc.library.catalogue import materials
from calc.sheet.errors import NoSolution
from tests.calc.gears.trains import SPEED, mesh, solved, train, wheel

AB = [mesh("a", "b")]


TWINS = [wheel("a", 30, 0.0), wheel("b", 30, 0.0)]
IMPOSSIBLE = {
    "too close": (
        [wheel("a", 36, 0.0), wheel("b", 39)],
        [mesh("a", "b", 70.0)],
        {},
        r"meshes\.0\.centre_distance_mm = 70: .* overlap",
    ),
    "no distance": ([wheel("a", 36, -2.0), wheel("b", 39, -2.0)], AB, {}, r"a −2 and b −2 no centre distance"),
    "tolerance": (
        [TWINS[0], wheel("b", 30)],
        [mesh("a", "b", 64.75, tolerance=5000)],
        {},
        r"less its tolerance of 5 mm",
    ),
    "no flank": (
        [wheel("a", 8, -1.2), wheel("b", 60, 1.5)],
        AB,
        {},
        r"wheels\.a\.profile_shift = −1\.2: the tip circle .* no involute",
    ),
    "cut away": (
        [wheel("a", 30, 0.0, cut=4.2), TWINS[1]],
        AB,
        {},
        r"wheels\.a\..* and the tip cut 4\.2 mm: the tip circle",
    ),
    "derived": (
        [wheel("a", 60, 1.5), wheel("b", 8)],
        [mesh("a", "b", 73.3)],
        {},
        r"b\.profile_shift = −1\.49.* \(it follows from",
    ),
    "no centre": (
        [wheel("a", 5, -2.0), wheel("b", 60, 2.5)],
        AB,
        dict(beta=0.0),
        r"cut through the centre of the wheel",
    ),
    "tool": (
        TWINS,
        AB,
        dict(alpha_n=30.0, tool=(1.4, 0.9)),
        r"gears\.tool_tip_radius = 0\.9 with .*corners of such a tool overlap",
    ),
    "allowance": (
        [wheel("a", 30, 0.0, allowance=(0, -5000)), TWINS[1]],
        AB,
        {},
        r"wheels\.a\.span_allowance_um = −5000: takes away",
    ),
    "short tips": (
        [wheel("a", 30, 0.0, cut=2.8), wheel("b", 30, 0.0, cut=2.8)],
        AB,
        {},
        r"flanks of a and b do not reach each other",
    ),
}


@pytest.mark.parametrize("case", IMPOSSIBLE)
def test_what_can_not_be_is_said(case):
    wheels, meshes, said, what = IMPOSSIBLE[case]
    with pytest.raises(NoSolution, match=what) as caught:
        solved(train(wheels, meshes, **said))
    assert len(caught.value.advice) > 10


def test_advice_names_the_least_centre_distance():
    with pytest.raises(NoSolution, match=r"it must exceed 75\.2578 mm; without profile shift it is 80\.8423 mm"):
        solved(train(*IMPOSSIBLE["too close"][:2]))


@pytest.mark.parametrize(
    "wheels, failing",
    [
        ([wheel("a", 10, 0.0), wheel("b", 40, 0.0)], {"gears.a.undercut", "gears.a_b.interference"}),
        ([wheel("a", 12, 1.2), wheel("b", 40, 0.0)], {"gears.a.tip_thickness"}),
        ([wheel("a", 20, 0.4, cut=0.9), wheel("b", 40, 0.4, cut=0.9)], {"gears.a_b.contact_ratio"}),
    ],
)
def test_what_is_poor_fails_its_check_with_advice(wheels, failing):
    outcome = solve.geometry(train(wheels, AB, beta=0.0, tool=(1.25, 0.3)), SPEED)
    fails = {c.id: c for c in outcome.checks if c.verdict == "fail"}
    assert failing <= fails.keys()
    assert all(math.isfinite(c.value) and c.advice for c in fails.values())


def test_a_ball_that_touches_no_flank_gives_no_size():
    outcome = solve.geometry(train([wheel("a", 30, 0.0), wheel("b", 30, 0.0)], AB, ball=0.5), SPEED)
    assert outcome.result.wheels["a"].over_balls is None
    assert {c.id: c.verdict for c in outcome.checks}["gears.a.ball"] == "warn"


def test_a_narrow_wheel_can_not_carry_its_span():
    outcome = solve.geometry(train([wheel("a", 60, 0.0, face_width=0.005), wheel("b", 30, 0.0)], AB), SPEED)
    verdicts = {c.id: c.verdict for c in outcome.checks}
    assert (verdicts["gears.a.span_width"], verdicts["gears.b.span_width"]) == ("note", "pass")
    assert outcome.result.meshes["a_b"].face_width == 0.005


def test_a_span_off_the_flank_is_seen():
    outcome = solve.geometry(train([wheel("a", 30, 0.0, span=9), wheel("b", 30, 0.0)], AB), SPEED)
    assert {c.id: c.verdict for c in outcome.checks}["gears.a.span_contact"] == "note"


wheels = st.builds(
    lambda name, z, x, cut, ends, span: wheel(
        name, z, x, cut=cut, span=span, allowance=ends and tuple(sorted(ends, reverse=True))
    ),
    st.just("a"),
    st.integers(5, 120),
    st.none() | st.floats(-3, 3),
    st.just(0.0) | st.floats(0, 3),
    st.none() | st.tuples(st.floats(-5000, 5000), st.floats(-5000, 5000)),
    st.none() | st.integers(1, 30),
)


@given(
    wheels,
    st.integers(5, 120),
    st.none() | st.floats(-3, 3),
    st.none() | st.floats(0.9, 1.2),
    st.none() | st.floats(0, 5000),
    st.floats(0, 35),
    st.floats(10, 35),
    st.floats(0.5, 2),
    st.floats(0, 0.5, allow_subnormal=False),
    st.none() | st.floats(0.1, 20),
)
@settings(max_examples=150, deadline=None, suppress_health_check=[HealthCheck.too_slow])
def test_anything_gives_numbers_or_a_word(a, z, x, share, tolerance, beta, alpha_n, addendum, radius, ball):
    distance = None if share is None else share * (a.teeth + z) / math.cos(math.radians(beta))
    meshes = [mesh("a", "b", distance, tolerance=tolerance)]
    gears = train([a, wheel("b", z, x)], meshes, beta=beta, alpha_n=alpha_n, tool=(addendum, radius), ball=ball)
    try:
        outcome = solve.geometry(gears, SPEED)
        outcome = solve.merge(outcome, solve.rating(gears, outcome.result, 5.0, materials()))
    except NoSolution as none:
        assert none.what and none.advice
        return
    assert all(math.isfinite(v.shown) for v in outcome.values())
    assert all(math.isfinite(c.value) or c.missing for c in outcome.checks)
    assert all(sum(len(s.x) for s in c.series) > 1 for c in curves(outcome.result))
