"""The routes to the tooth thickness: forward from one tooth and back again, and from published sizes back to their
tooth."""

import math
from dataclasses import replace
from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.gears import formulas as f
from calc.gears.measures import formulas as m
from calc.gears.measures.solve import Span, best, measured, measures, spans
from calc.gears.solve import geometry
from calc.sheet.errors import NoSolution
from tests.calc.gears.trains import SPEED, mesh, reference, train, wheel

ROUTES = ("measured_span", "measured_over_balls", "measured_over_pins", "measured_chordal_thickness")
EXAMPLES = {e["name"].split()[0]: e for e in reference("gears_examples.toml")["example"]}


def solve(z, x, *, sizes=None, allowance=None, span=None, b=60.0, **said):
    """A wheel with a mate, as (system, its inputs, its result)."""
    made = wheel("a", z, x, span=span, allowance=allowance, **(sizes or {}))
    gears = train([made, wheel("mate", 40, 0.1)], [mesh("a", "mate")], tool=(1.25, 0.3), b=b, **said)
    found = geometry(gears, SPEED).result
    return found.system, gears.wheels[0], found.wheels["a"]


@st.composite
def wheels(draw):
    z = draw(st.integers(14, 120))
    m_n = draw(st.floats(0.5, 10))
    return dict(z=z, x=draw(st.floats(0.1, 0.5)), m_n=m_n, beta=draw(st.just(0.0) | st.floats(1, 32)), ball=1.75 * m_n)


@given(wheels(), st.floats(-0.08, 0.02))
@settings(max_examples=60, deadline=None)
def test_four_routes_agree(said, thinner):
    """Sizes of the wheel with another shift, measured on this one."""
    x_E = said["x"] + thinner
    system, _, nominal = solve(**said)
    _, given_, actual = solve(**(said | {"x": x_E}), span=round(nominal.span_teeth))
    over = measures(system, given_, actual)[0]
    sizes = dict(zip(ROUTES, (actual.span_length, actual.over_balls, over.over_pins, actual.chordal_thickness)))
    _, given_, nominal = solve(**said, sizes=sizes, span=round(nominal.span_teeth))
    routes = measured(system, given_, nominal)
    assert set(routes) == set(ROUTES)
    s_n = system.m_n * (math.pi / 2 + 2 * x_E * math.tan(system.alpha_n))
    for route in routes.values():
        assert route.normal_thickness == pytest.approx(s_n, abs=1e-9)
        assert route.transverse_thickness == pytest.approx(s_n / math.cos(system.beta), abs=2e-9)
        assert route.span_change == pytest.approx(2 * thinner * system.m_n * math.sin(system.alpha_n), abs=1e-9)
        assert route.thickness_change == pytest.approx(
            s_n - nominal.reference_thickness * math.cos(system.beta), abs=1e-9
        )


@given(wheels())
@settings(max_examples=40, deadline=None)
def test_every_span_is_one_base_pitch_longer_and_touches_where_it_says(said):
    system, _, a = solve(**said)
    found = spans(system, a)
    p_bn = math.pi * system.m_n * math.cos(system.alpha_n)
    for one, more in pairwise(found):
        assert more.length - one.length == pytest.approx((more.K - one.K) * p_bn, rel=1e-9)
    for s in found:
        touches = a.form_diameter < s.contact_diameter < a.tip_diameter
        assert (s.fault in ("", "needs a wider face")) == touches
        if touches:
            assert (s.fault == "") == (a.face_width > s.length * math.sin(system.base_helix_angle))
    assert len([s for s in found if s.contact_diameter <= a.form_diameter]) <= 1 + (found[0].K == a.span_teeth)


@pytest.mark.parametrize(
    "z, x, beta, chosen",
    [(39, 0.2, 21.9, 5), (60, 0.0, 0.0, 7), (25, 0.4, 10.0, 9), (8, 0.5, 0.0, 2), (5, 0.7, 0.0, 1)],
)
def test_the_spans_that_touch_one_more_to_each_side_and_the_one_that_is_chosen(z, x, beta, chosen):
    """Between 1 and the number of teeth; where each touches by Pythagoras."""
    system, _, a = solve(z, x, beta=beta, span=chosen, ball=None)
    p_bn = math.pi * system.m_n * math.cos(system.alpha_n)
    lengths = [a.span_length + (K - chosen) * p_bn for K in range(1, z + 1)]
    circles = [math.hypot(a.base_diameter, W * math.cos(system.base_helix_angle)) for W in lengths]
    touching = [K for K, d_W in enumerate(circles, 1) if a.form_diameter < d_W < a.tip_diameter]
    wanted = {*touching, max(touching[0] - 1, 1), min(touching[-1] + 1, z), chosen}
    found = spans(system, a)
    assert [s.K for s in found] == sorted(wanted)
    assert [s.contact_diameter for s in found] == pytest.approx([circles[K - 1] for K in sorted(wanted)])
    assert [s.K for s in found if not s.fault] == touching


@pytest.mark.parametrize("d_V, K", [(50.4, 4), (55.1, 5), (54.9, 4), (70.0, 5), (20.0, 4), (55.0, 4)])
def test_the_best_span_touches_nearest_to_its_circle(d_V, K):
    row = [
        Span(K, 0.0, d_W, 0.0, fault) for K, d_W, fault in ((3, 40, "low"), (4, 50, ""), (5, 60, ""), (6, 70, "high"))
    ]
    assert best(tuple(row), d_V).K == best(tuple(row[::-1]), d_V).K == K
    assert best((row[0], row[3]), d_V) is None


@pytest.mark.parametrize(("z", "x", "K"), [(39, 0.426, 5), (39, 0.427, 6), (60, 0.853, 8), (60, 0.854, 9)])
def test_the_best_span_changes_where_two_touch_as_near_to_the_circle_of_the_shift(z, x, K):
    system, given_, a = solve(z, x, beta=0.0)
    off = [abs(s.contact_diameter - (z + 2 * x) * 2e-3) for s in spans(system, a)]
    assert sorted(off)[1] - sorted(off)[0] < 5e-6
    assert measures(system, given_, a)[0].best_span_teeth == K


@pytest.mark.parametrize(("beta_K", "loose"), [(44.9, True), (45.1, False)])
def test_pins_that_lie_steeper_than_45_degrees_are_not_measured_loose(beta_K, loose):
    system, given_, a = solve(25, 0.2, beta=25.0)
    alpha_K = math.acos(math.tan(system.base_helix_angle) / math.tan(math.radians(beta_K)))
    found = measures(system, given_, replace(a, seat=replace(a.seat, alpha_K=alpha_K)))[0]
    assert (found.over_two_pins is not None) is loose


@given(wheels(), st.floats(0.2, 5))
@settings(max_examples=25, deadline=None)
def test_sizes_scale_with_the_module(said, scale):
    allowance = (-20 * said["m_n"], -30 * said["m_n"])
    system, given_, a = solve(**said, allowance=allowance)
    small = measures(system, given_, a)[0]
    large_said = said | {"m_n": said["m_n"] * scale, "ball": said["ball"] * scale}
    system, given_, a = solve(**large_said, allowance=[scale * e for e in allowance], b=60.0 * scale)
    large = measures(system, given_, a)[0]
    for key, number in vars(small).items():
        if isinstance(number, float) and key not in ("preferred_ball", "best_span_teeth"):
            assert getattr(large, key) == pytest.approx(scale * number, rel=1e-8), key


@given(wheels(), st.integers(15, 100))
@settings(max_examples=40, deadline=None)
def test_the_constant_chord_is_constant_and_ends_on_the_involute(said, other):
    system, given_, a = solve(**said)
    found = measures(system, given_, a)[0]
    system, given_, b = solve(**(said | {"z": other}))
    assert measures(system, given_, b)[0].constant_chord == found.constant_chord
    # its end in the normal section, turned back along the helix into the transverse section through the middle of the
    # tooth
    along, high = found.constant_chord / 2, found.constant_chord * math.tan(system.alpha_n) / 2
    side, out = along * math.cos(system.beta), a.reference_diameter / 2 + high
    axial = -along * math.sin(system.beta)
    d_y = 2 * math.hypot(side, out)
    assert found.constant_chord_diameter == pytest.approx(d_y, rel=1e-12)
    turned = math.atan2(side, out) - axial * math.tan(system.beta) / (a.reference_diameter / 2)
    alpha_yt = f.pressure_angle_at(a.base_diameter, d_y)
    s_yt = f.thickness_at(d_y, a.reference_thickness, a.reference_diameter, system.transverse_pressure_angle, alpha_yt)
    assert turned == pytest.approx(s_yt / d_y, abs=1e-12)
    assert a.tip_diameter / 2 - found.constant_chord_height == pytest.approx(out, rel=1e-12)


# --- published sizes, measured
PUBLISHED = [
    ("V4", "measured_span", dict(z=24, x=0.0, m_n=3.0, beta=0.0, span=4), "32.8266", 0.4),
    ("V5", "measured_span", dict(z=24, x=0.0, m_n=3.0, beta=25.0, span=5), "42.0085", 0.4),
    ("V7", "measured_over_balls", dict(z=20, x=0.1, m_n=1.0, beta=0.0, ball=1.7), "22.2941", 0.0),
    ("V7", "measured_over_pins", dict(z=20, x=0.1, m_n=1.0, beta=0.0, ball=1.7), "22.2941", 0.0),
    ("V8", "measured_over_pins", dict(z=20, x=0.1, m_n=1.0, beta=15.0, ball=2.0), "24.5696", 0.4),
    ("V10", "measured_chordal_thickness", dict(z=12, x=0.1, m_n=10.0, beta=0.0), "17.8256", 0.3),
    ("V11", "measured_chordal_thickness", dict(z=16, x=0.1, m_n=5.0, beta=25.0), "8.5728", 0.2),
]


@pytest.mark.parametrize(("name", "route", "said", "size", "x"), PUBLISHED)
def test_a_published_size_gives_back_the_shift_of_its_example(name, route, said, size, x):
    assert size in EXAMPLES[name]["published"].values()
    system, given_, a = solve(**said, sizes={route: float(size) * 1e-3})
    found = measured(system, given_, a)[route]
    half_digit = 0.5e-7
    # a chord's is 1, a span's 1.06
    assert abs(found.normal_thickness - m.normal_thickness(system.m_n, x, system.alpha_n)) < 2 * half_digit


# --- sizes of no tooth
@pytest.mark.parametrize(
    ("route", "z", "beta", "share"),
    [
        ("measured_over_balls", 24, 0.0, 1.0),
        ("measured_over_balls", 25, 0.0, math.cos(math.pi / 50)),
        ("measured_over_balls", 25, 15.0, math.cos(math.pi / 50)),
        ("measured_over_pins", 25, 0.0, math.cos(math.pi / 50)),
        ("measured_over_pins", 25, 15.0, 1.0),
        ("measured_over_pins", 24, 15.0, 1.0),
    ],
)
def test_the_least_size_over_balls_and_pins(route, z, beta, share):
    """Where their centres stand on the base circle; of an odd number of teeth they are not opposite, but pins of a
    helical wheel are."""
    _, _, a = solve(z, 0.2, beta=beta)
    least = a.base_diameter * share + a.ball_diameter
    with pytest.raises(NoSolution, match=f"with 3.5 mm in diameter it is at least {least * 1e3:.4f} mm"):
        solve(z, 0.2, beta=beta, sizes={route: least - 1e-7})
    _, _, thin = solve(z, 0.2, beta=beta, sizes={route: least + 1e-7})
    assert getattr(thin.measures, route).normal_thickness > 0


@pytest.mark.parametrize(
    ("route", "size", "words"),
    [
        ("measured_span", 0.017, "at a pitch of 6.283 mm"),
        ("measured_over_balls", 0.040, "it is at least"),
        ("measured_over_pins", 0.040, "it is at least"),
        ("measured_chordal_thickness", 0.4, "no chord of its virtual wheel is longer"),
        ("measured_chordal_thickness", 0.007, "at a pitch of 6.283 mm"),
    ],
)
def test_a_size_of_no_tooth_has_no_solution(route, size, words):
    with pytest.raises(NoSolution, match=words) as raised:
        solve(25, 0.2, sizes={route: size}, span=4)
    assert f"gears.wheels.a.{route}_mm" in raised.value.what


@pytest.mark.parametrize(("less", "hint"), [(2, "over 2 teeth, not 4"), (3, "over 1 teeth, not 4"), (4, "compare it")])
def test_a_span_over_fewer_teeth_is_recognised(less, hint):
    """One base pitch shorter for each tooth; over none there is no span."""
    _, _, a = solve(25, 0.2, span=4)
    pitch = math.pi * 2e-3 * math.cos(math.radians(20))
    with pytest.raises(NoSolution) as raised:
        solve(25, 0.2, sizes={"measured_span": a.span_length - less * pitch}, span=4)
    assert hint in raised.value.advice
    with pytest.raises(NoSolution) as raised:
        solve(25, 0.2, sizes={"measured_chordal_thickness": 0.007}, span=4)
    assert raised.value.advice.startswith("compare it with the computed chordal thickness")


def test_a_span_over_another_number_of_teeth_is_recognised():
    _, _, a = solve(25, 0.2, span=4)
    with pytest.raises(NoSolution, match="near a span over 3 teeth, not 4"):
        solve(25, 0.2, sizes={"measured_span": a.span_length - 0.005905}, span=4)
