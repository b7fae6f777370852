# SPDX-License-Identifier: Apache-2.0
"""What geometry and mechanics say of any involute gears beside tests/calc/gears/test_properties.py; the list of all
such laws is docs/laws.md."""

import cmath
import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from calc.gears import formulas as f
from calc.gears import solve
from calc.gears.backlash import formulas as play
from calc.gears.layout import formulas as room
from calc.gears.layout.forces import forces
from calc.library.catalogue import materials
from tests.calc.gears.layout.trains import AXIS, laid, triangle
from tests.calc.gears.layout.trains import solved as placed
from tests.calc.gears.test_properties import gears, one, pairs
from tests.calc.gears.trains import SPEED, mesh, train, wheel

angles, helices = st.floats(math.radians(14), math.radians(28)), st.floats(0, math.radians(35))
teeth, shifts = st.integers(8, 200), st.floats(-0.5, 1.0)


def system(alpha_n, beta, m_n=1e-3):
    m_t, alpha_t = f.transverse_module(m_n=m_n, beta=beta), f.transverse_pressure_angle(alpha_n=alpha_n, beta=beta)
    return m_t, alpha_t


# --- geometry
@settings(max_examples=80, deadline=None)
@given(z_1=teeth, z_2=teeth, x_1=shifts, x_2=shifts, more=st.floats(1e-4, 0.5), alpha_n=angles, beta=helices)
def test_shifts_and_centre_distance_say_the_same(z_1, z_2, x_1, x_2, more, alpha_n, beta):
    """a_w·cos α_wt = a·cos α_t; the sum of shifts comes back from a_w; a_w rises with it, by no more than m_n, and is a
    where it is 0."""
    m_t, alpha_t = system(alpha_n, beta)

    def distance(x_1, x_2):
        involute = f.working_involute(alpha_t=alpha_t, alpha_n=alpha_n, x_1=x_1, x_2=x_2, z_1=z_1, z_2=z_2)
        assume(involute > 1e-6)
        alpha_wt = f.angle_of_involute(involute)
        return f.centre_distance(z_1=z_1, z_2=z_2, m_t=m_t, alpha_t=alpha_t, alpha_wt=alpha_wt), alpha_wt

    a_w, alpha_wt = distance(x_1, x_2)
    a = (z_1 + z_2) * m_t / 2
    d_b = [f.base_diameter(d=z * m_t, alpha_t=alpha_t) for z in (z_1, z_2)]
    assert a_w * math.cos(alpha_wt) == pytest.approx(a * math.cos(alpha_t), rel=1e-12)
    assert f.working_pressure_angle(*d_b, a_w) == pytest.approx(alpha_wt, abs=1e-7)
    back = f.shift_sum(z_1=z_1, z_2=z_2, alpha_wt=alpha_wt, alpha_t=alpha_t, alpha_n=alpha_n)
    assert back == pytest.approx(x_1 + x_2, abs=1e-9)
    wider, _ = distance(x_1 + more, x_2)
    assert a_w < wider
    if x_1 + x_2 >= 0:
        assert wider - a_w <= more * 1e-3 * (1 + 1e-9)
    assert distance(x_1, -x_1)[0] == pytest.approx(a, rel=1e-9)


@settings(max_examples=80, deadline=None)
@given(z=teeth, x=shifts, alpha_n=angles, beta=helices, share=st.floats(0, 1))
def test_teeth_and_spaces_fill_every_circle(z, x, alpha_n, beta, share):
    """s_y(x) + s_y(−x) is the pitch less d_y·(inv α_y − inv α_t): a tooth and the space of its counterpart; pointed
    where both flanks meet."""
    m_t, alpha_t = system(alpha_n, beta)
    d = f.reference_diameter(z=z, m_t=m_t)
    d_b = f.base_diameter(d=d, alpha_t=alpha_t)
    s_t, mirrored = (f.reference_thickness(m_n=1e-3, x=shift, alpha_n=alpha_n, beta=beta) for shift in (x, -x))
    assert s_t + mirrored == pytest.approx(math.pi * m_t, rel=1e-12)
    alpha_p = f.angle_of_involute(f.pointed_involute(s_t=s_t, d=d, alpha_t=alpha_t))
    d_p = f.pointed_diameter(d_b=d_b, alpha_p=alpha_p)
    assert f.thickness_at(d_y=d_p, s_t=s_t, d=d, alpha_t=alpha_t, alpha_yt=alpha_p) == pytest.approx(0, abs=1e-9 * d)
    below = d_b + share * (d_p - d_b)
    thick = f.thickness_at(d_y=below, s_t=s_t, d=d, alpha_t=alpha_t, alpha_yt=f.pressure_angle_at(d_b=d_b, d_y=below))
    assert thick >= -1e-9 * d
    # the line tangent to the base circle unwinds from it: arc from the tooth's foot to where it touches = radius of
    # curvature
    rho = f.curvature_at(d_y=below, d_b=d_b)
    alpha_y = f.pressure_angle_at(d_b=d_b, d_y=below)
    assert rho == pytest.approx(d_b / 2 * math.tan(alpha_y), abs=1e-7 * d)
    assert f.diameter_at(d_b=d_b, rho=rho) == pytest.approx(below, rel=1e-12)


@settings(max_examples=80, deadline=None)
@given(z=teeth, alpha_n=angles, beta=helices, h=st.floats(1.0, 1.5), rho=st.floats(0, 0.3), more=st.floats(1e-3, 1))
def test_undercut_begins_on_the_base_circle(z, alpha_n, beta, h, rho, more):
    """At x_min the tool's straight flank ends where the line of action touches the base circle; with more shift the
    fillet begins above."""
    m_t, alpha_t = system(alpha_n, beta)
    d = z * m_t
    d_b = f.base_diameter(d=d, alpha_t=alpha_t)
    x_min = f.undercut_limit(h_fP=h, rho_aP0=rho, alpha_n=alpha_n, z=z, alpha_t=alpha_t, beta=beta)

    def form(x):
        h_F = f.straight_flank_depth(m_n=1e-3, h_fP=h, rho_aP0=rho, alpha_n=alpha_n, x=x)
        return f.form_diameter(d=d, alpha_t=alpha_t, h_F=h_F, d_b=d_b)

    assert form(x_min) == pytest.approx(d_b, rel=1e-12)
    assert form(x_min + more) > d_b
    z_min = 2 * (h - rho * (1 - math.sin(alpha_n))) * math.cos(beta) / math.sin(alpha_t) ** 2
    assert (x_min <= 0) == (z >= z_min) or abs(z - z_min) < 1e-6


@settings(max_examples=60, deadline=None)
@given(z_1=st.integers(10, 400), z_2=st.integers(10, 400), alpha_n=angles, beta=helices)
def test_two_racks_have_the_largest_contact_ratio(z_1, z_2, alpha_n, beta):
    """Unshifted teeth of addendum 1: ε_α < 4·cos β/(π·sin 2α_t), and comes to it as the teeth become many."""
    m_t, alpha_t = system(alpha_n, beta)

    def ratio(z_1, z_2):
        d, T, p = (
            [z * m_t for z in (z_1, z_2)],
            (z_1 + z_2) * m_t / 2 * math.sin(alpha_t),
            f.base_pitch(m_t=m_t, alpha_t=alpha_t),
        )
        tips = [
            f.curvature_at(d_y=f.tip_diameter(d=x, m_n=1e-3, x=0.0, k=0.0), d_b=f.base_diameter(d=x, alpha_t=alpha_t))
            for x in d
        ]
        starts = [T - tip for tip in tips]
        return f.transverse_contact_ratio(g_alpha=f.path_of_contact(T=T, rho_A1=starts[1], rho_A2=starts[0]), p_bt=p)

    most = 4 * math.cos(beta) / (math.pi * math.sin(2 * alpha_t))
    assert ratio(z_1, z_2) < ratio(z_1 + 1, z_2) < most
    assert ratio(10**6, 10**6) == pytest.approx(most, rel=1e-4)


@settings(max_examples=25, deadline=None)
@given(pair=pairs())
def test_both_flanks_move_alike_along_the_line_of_action(pair):
    """The law of gearing: ω_1·r_b1 = ω_2·r_b2, so a constant ratio; both wheels have one base pitch; the pitch circles
    roll."""
    t, m = one(gears(pair))
    a, b = t.wheels["a"], t.wheels["b"]
    assert a.speed * a.base_diameter == pytest.approx(-b.speed * b.base_diameter, rel=1e-12)
    assert a.speed * m.working_diameter_driver == pytest.approx(-b.speed * m.working_diameter_driven, rel=1e-12)
    assert (m.working_diameter_driver + m.working_diameter_driven) / 2 == pytest.approx(m.centre_distance, rel=1e-12)
    for w in (a, b):
        assert math.pi * w.base_diameter / w.teeth == pytest.approx(t.system.base_pitch, rel=1e-12)
    assert m.line_of_action**2 + ((a.base_diameter + b.base_diameter) / 2) ** 2 == pytest.approx(
        m.centre_distance**2, rel=1e-12
    )
    for w, d_w, c in (
        (a, m.working_diameter_driver, m.tip_clearance_driver),
        (b, m.working_diameter_driven, m.tip_clearance_driven),
    ):
        mate = b if w is a else a
        assert w.root_diameter / 2 + c + mate.tip_diameter / 2 == pytest.approx(m.centre_distance, rel=1e-12)
        assert w.root_diameter < w.base_diameter / math.cos(m.working_pressure_angle) == pytest.approx(d_w, rel=1e-12)


@settings(max_examples=25, deadline=None)
@given(pair=pairs(), middle=st.integers(18, 70))
def test_an_idler_changes_the_sense_and_not_the_ratio(pair, middle):
    """a–idler–b: the speed of b is that of a direct mesh with its sign turned, whatever the idler's teeth."""
    (z_1, z_2), m_n = pair["z"], pair["m_n"]
    direct, _ = one(gears(pair))
    wheels = [wheel("a", z_1, 0.1), wheel("i", middle, 0.1), wheel("b", z_2, 0.1)]
    chain = solve.geometry(
        train(wheels, [mesh("a", "i"), mesh("i", "b")], m_n=m_n, beta=pair["beta"], tool=(1.25, 0.3), ball=None), SPEED
    ).result
    assert chain.shafts["shaft"].speed_ratio == pytest.approx(-direct.shafts["shaft"].speed_ratio, rel=1e-12)
    assert chain.wheels["i"].speed * middle == pytest.approx(-SPEED * z_1, rel=1e-12)


@settings(max_examples=80, deadline=None)
@given(z_1=st.integers(5, 150), z_2=st.integers(5, 150), z_3=st.integers(5, 150))
def test_the_same_teeth_meet_when_both_have_made_whole_turns(z_1, z_2, z_3):
    """N_m is the first whole number of turns of the driver after which the mate has made whole turns too; so for the
    marks of all wheels."""
    turns = int(room.turns_to_repeat(z_2=z_2, g_z=room.common_factor(z_1=z_1, z_2=z_2)))
    assert turns == next(n for n in range(1, z_2 + 1) if n * z_1 % z_2 == 0)
    marks = int(room.marks_period(z_1=z_1, z=(z_1, z_2, z_3)))
    assert marks * z_1 % z_2 == 0 == marks * z_1 % z_3
    assert marks == math.lcm(turns, int(room.turns_to_repeat(z_2=z_3, g_z=room.common_factor(z_1=z_1, z_2=z_3))))


# --- backlash
@settings(max_examples=60, deadline=None)
@given(
    z_1=teeth,
    z_2=teeth,
    alpha_n=angles,
    beta=helices,
    a=st.floats(1.0, 1.06),
    wider=st.floats(1.0001, 1.01),
    x=st.floats(-0.2, 0.2),
    eps=st.floats(-2e-3, 2e-3),
)
def test_backlash_grows_with_the_centres_and_with_the_whole(z_1, z_2, alpha_n, beta, a, wider, x, eps):
    """∂j_bn/∂a = 2·sin α_wt·cos β_b at every distance; wheels and housing that grow alike keep their angle, and j grows
    as all lengths."""
    m_t, alpha_t = system(alpha_n, beta)
    beta_b, p_bt = f.base_helix_angle(beta=beta, alpha_n=alpha_n), f.base_pitch(m_t=m_t, alpha_t=alpha_t)
    d, d_b = [z * m_t for z in (z_1, z_2)], [z * m_t * math.cos(alpha_t) for z in (z_1, z_2)]
    s = [f.reference_thickness(m_n=1e-3, x=shift, alpha_n=alpha_n, beta=beta) for shift in (x, -x)]
    s_b = [
        play.base_thickness(d_b=b, s_t=t, d=D, alpha_t=alpha_t, E_W=-2e-5, beta_b=beta_b) for b, t, D in zip(d_b, s, d)
    ]

    def backlash(a_w):
        alpha_wt = f.working_pressure_angle(*d_b, a_w)
        j = play.backlash_of_bases(
            p_bt=p_bt, s_b1=s_b[0], s_b2=s_b[1], d_b1=d_b[0], d_b2=d_b[1], alpha_wt=alpha_wt, beta_b=beta_b
        )
        return j, alpha_wt

    a_w = a * sum(d) / 2
    (j, alpha_wt), (larger, alpha_2) = backlash(a_w), backlash(a_w * wider)
    way = a_w * (wider - 1) * 2 * math.cos(beta_b)
    assert way * math.sin(alpha_wt) <= (larger - j) * (1 + 1e-9) and larger - j <= way * math.sin(alpha_2) * (1 + 1e-9)
    grown = play.expansion_of_wheels(eps_1=eps, eps_2=eps, d_b1=d_b[0], d_b2=d_b[1])
    assert play.effective_centre(a=a_w, eps_a=eps, eps_g=grown) == pytest.approx(a_w, rel=1e-12)
    warm = play.warm_backlash(
        p_bt=p_bt,
        eps_1=eps,
        eps_2=eps,
        s_b1=s_b[0],
        s_b2=s_b[1],
        d_b1=d_b[0],
        d_b2=d_b[1],
        alpha_wt=alpha_wt,
        beta_b=beta_b,
    )
    assert warm == pytest.approx((1 + eps) * j, abs=1e-12 * sum(d))


# --- stress and force
@settings(max_examples=10, deadline=None)
@given(pair=pairs(), T=st.floats(0.5, 500), load=st.floats(0.1, 10), scale=st.floats(0.3, 4))
def test_nominal_stress_goes_with_the_load_and_not_with_the_size(pair, T, load, scale):
    """Hertz: σ_H ~ √T; bending: σ_F ~ T; similar gears with T ~ l³ have the same stresses."""
    small, large = gears(pair), gears(pair, scale)
    one_, more, similar = (
        next(iter(solve.rating(g, solve.geometry(g, SPEED).result, torque, materials()).result.meshes.values()))
        for g, torque in ((small, T), (small, T * load), (large, T * scale**3))
    )
    assert more.contact_stress == pytest.approx(math.sqrt(load) * one_.contact_stress, rel=1e-9)
    assert similar.contact_stress == pytest.approx(one_.contact_stress, rel=1e-9)
    for name, stress in one_.root_stress.items():
        assert more.root_stress[name].number == pytest.approx(load * stress.number, rel=1e-9)
        assert similar.root_stress[name].number == pytest.approx(stress.number, rel=1e-9)


TRIANGLE = triangle()
SOLVED = placed(TRIANGLE)
HERE = laid(TRIANGLE, AXIS).result


@settings(max_examples=30, deadline=None)
@given(turn=st.floats(0, 2 * math.pi), T=st.floats(0.1, 100), lost=st.floats(0.9, 1))
def test_forces_of_the_teeth_cancel_and_turn_with_the_train(turn, T, lost):
    """Over all axes the forces add up to nothing; a train that is turned as a whole has its forces turned, and as
    large; F ~ T."""
    ratio = SOLVED.wheels["idler"].teeth / SOLVED.wheels["crank"].teeth

    def loads(layout, T):
        found = forces(TRIANGLE, SOLVED, layout, {"crank_idler": T, "idler_shaft": T * ratio * lost}).result.wheels
        return {name: w.bearing_force * cmath.exp(1j * w.bearing_force_direction) for name, w in found.items()}

    here, there = loads(HERE, 1.0), loads(laid(TRIANGLE, AXIS * cmath.exp(1j * turn)).result, T)
    size = sum(map(abs, here.values()))
    assert abs(sum(here.values())) < 1e-9 * size
    for name, F in here.items():
        assert there[name] == pytest.approx(T * F * cmath.exp(1j * turn), abs=1e-6 * T * size)


@settings(max_examples=60, deadline=None)
@given(
    T=st.floats(-500, 500),
    d_w=st.floats(0.01, 0.5),
    alpha=angles,
    beta=helices,
    gamma=st.floats(-4, 4),
    s=st.sampled_from([-1.0, 1.0]),
)
def test_the_tooth_force_stands_square_to_the_flank(T, d_w, alpha, beta, gamma, s):
    """F_t, F_r and F_a are the parts of one normal force; its arm about the axis is the base radius: T = F_bt·r_b."""
    F_t = room.tangential_force(T_1=T, d_w1=d_w)
    F_r, F_bt = room.radial_force(F_tw=F_t, alpha_wt=alpha), room.transverse_force(F_tw=F_t, alpha_wt=alpha)
    assert math.hypot(F_t, F_r) == pytest.approx(F_bt, rel=1e-9, abs=1e-12)
    assert F_bt * d_w / 2 * math.cos(alpha) == pytest.approx(abs(T), rel=1e-9, abs=1e-12)
    on_driven = room.force_on_driven(F_rw=F_r, F_tw=F_t, gamma=gamma, s=s)
    assert abs(on_driven) == pytest.approx(F_bt, rel=1e-9, abs=1e-12)
    assert room.force_on_driver(F_2=on_driven) == -on_driven
    # from the driver's axis; its torque drives against the force of the driven wheel
    pitch_point = d_w / 2 * cmath.exp(1j * gamma)
    assert (pitch_point.conjugate() * -on_driven).imag == pytest.approx(-s * T, abs=1e-9 * (abs(T) + 1))


@settings(max_examples=60, deadline=None)
@given(
    p=st.complex_numbers(max_magnitude=1),
    a=st.floats(0.02, 0.3),
    b=st.floats(0.02, 0.3),
    share=st.floats(0.01, 0.99),
    turn=st.floats(-3, 3),
)
def test_the_two_places_of_an_idler_mirror_each_other(p, a, b, share, turn):
    """Both stand at their centre distances; the line of centres is their axis of symmetry; turned axes turn them."""
    c = abs(a - b) + share * (a + b - abs(a - b))
    q = p + c * cmath.exp(1j * turn)
    u = room.chord_foot(c=c, a_12=a, a_23=b)
    v = room.half_chord(a_12=a, u=u)
    one_, other = (
        room.on_two_circles(p_1=p, gamma=room.line_of_centres(p_1=p, p_3=q), u=u, v=v, s=s) for s in (1.0, -1.0)
    )
    for place in (one_, other):
        assert abs(place - p) == pytest.approx(a, rel=1e-9) and abs(place - q) == pytest.approx(b, rel=1e-9)
    along = cmath.exp(1j * turn)
    assert (one_ - p) / along == pytest.approx(((other - p) / along).conjugate(), abs=1e-9)
    assert np.sign(((one_ - p) / along).imag) == 1  # s = +1 lies further in the sense of rotation
