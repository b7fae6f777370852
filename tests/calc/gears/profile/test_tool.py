"""The tool with stock and protuberance: rolled through the space it cuts nothing more than the outline, and it touches
it."""

import dataclasses
import math

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from calc.gears.profile.cut import Cut, finishing_step, form_diameter_of_undercut, protuberance_note, tool_problem
from calc.gears.profile.outline import regions, tooth
from calc.gears.train import tooth_system
from calc.sheet.errors import NoSolution
from tests.calc.gears.trains import mesh, solved, train, wheel

PLAIN = [
    (36, 0.014, 21.916, (1.41, 0.2), 0.0, 0.0),
    (25, 0.0142, 21.916, (1.41, 0.2), 0.0, 0.0),
    (20, 0.0, 0.0, (1.25, 0.38), 0.0, 0.0),
    (80, -0.4, 10.0, (1.25, 0.0), 0.0, 0.0),
    (10, 0.0, 0.0, (1.25, 0.38), 0.0, 0.0),
    (8, -0.3, 15.0, (1.25, 0.2), 0.0, 0.0),
]
PROTUBERANT = [
    (25, 0.0, 21.916, (1.41, 0.2), 0.08, 0.1),
    (36, 0.1, 21.916, (1.4, 0.38), 0.1, 0.13),
    (100, -0.3, 0.0, (1.4, 0.39), 0.0, 0.02),
    (40, 0.0, 15.0, (1.4, 0.2), 0.05, 0.15),
    (40, 0.0, 15.0, (1.25, 0.0), 0.02, 0.04),
    (10, 0.0, 0.0, (1.25, 0.38), 0.08, 0.1),
    (17, 0.15, 15.8, (1.4, 0.39), 0.1, 0.102),
]
STEPPED = [(25, 0.0, 21.916, (1.41, 0.2), 0.08, 0.05), (40, 0.3, 0.0, (1.4, 0.38), 0.1, 0.0)]


def made(z, x, beta, tool, q=0.0, pr=0.0, m_n=2.0):
    """Stock and protuberance in mm."""
    gears = train([wheel("a", z, x), wheel("b", 60, 0.5)], [mesh("a", "b")], m_n=m_n, beta=beta, tool=tool)
    t = solved(dataclasses.replace(gears, stock=q * 1e-3, protuberance=pr * 1e-3))
    return t.system, t.wheels["a"]


def rack(system, w):
    """The tool's tooth: its round corner as far as it stands out, and the finished flank above; each (from its middle,
    from the pitch line)."""
    s, m_n = system, system.m_n
    rho, slant, alpha_t = s.rho_aP0 * m_n, math.cos(s.beta), s.transverse_pressure_angle
    bottom = (w.profile_shift - s.h_fP) * m_n

    def flank(v):
        return np.pi * s.transverse_module / 4 + (v - w.profile_shift * m_n) * math.tan(alpha_t)

    # where corner and flank of the tool touch; it stands s_pr beyond the finished one
    v_touch = bottom + rho * (1 - math.sin(s.alpha_n))
    u_touch = flank(v_touch) + s.s_pr / (math.cos(s.alpha_n) * slant)
    phi = np.linspace(-np.pi / 2, -s.alpha_n + (0.3 if s.s_pr > 0 else 0.0), 400)
    u = u_touch + rho / slant * (np.cos(phi) - math.cos(s.alpha_n))
    v = v_touch + rho * (np.sin(phi) + math.sin(s.alpha_n))
    v_up = np.linspace(v_touch, (w.profile_shift + 1.5) * m_n, 300)
    return (u, v), (flank(v_up), v_up)


@pytest.mark.parametrize("case", PLAIN + PROTUBERANT + STEPPED)
def test_the_tool_rolls_through_the_space_cuts_nothing_more_and_touches(case):
    system, w = made(*case)
    m_n, r, cut = system.m_n, w.reference_diameter / 2, Cut(system, w.teeth, w.profile_shift)
    fillet = cut.fillet(np.linspace(-np.pi / 2, cut.end_of_fillet, 20001))
    corner, flank = rack(system, w)
    if not finishing_step(system):  # else the finishing tool ends somewhere above the fillet
        corner = flank = tuple(np.concatenate(both) for both in zip(corner, flank))
    gaps = [], []
    for s in np.linspace(-2.5 * m_n, 2.5 * m_n, 1201) * np.pi:
        for (u, v), upper, found in ((corner, False, gaps[0]), (flank, True, gaps[1])):
            X, Y = u + s, v + r
            R, angle = np.hypot(X, Y), np.pi / w.teeth - (np.arctan2(X, Y) - s / r)
            drawn = cut.involute(R) if upper else np.interp(R, *fillet)
            # at the very root the outline is a circle
            there = (
                (R < w.tip_diameter / 2) & (R > fillet[0][-1])
                if upper
                else (R < fillet[0][-1]) & (R > fillet[0][0] + 1e-3 * m_n)
            )
            found.append(((angle - drawn)[there] * R[there]).min(initial=np.inf))
    for found in gaps:
        assert -2e-6 * m_n < min(found) < 3e-3 * m_n


@pytest.mark.parametrize("case", PLAIN + PROTUBERANT + STEPPED)
def test_the_flank_is_whole_from_root_to_tip(case):
    system, w = made(*case)
    flank = regions(system, w)
    radius = np.concatenate([flank.root[0], flank.fillet[0][1:], flank.involute[0][1:], flank.tip[0][1:]])
    assert np.all(np.diff(radius) >= -1e-15)
    assert 2 * flank.root[0][0] == pytest.approx(w.root_diameter, rel=1e-13)
    assert 2 * flank.involute[0][0] == pytest.approx(w.form_diameter, rel=1e-12)
    assert 2 * flank.tip[0][-1] == pytest.approx(w.tip_diameter, rel=1e-13)
    for (r_1, a_1), (r_2, a_2) in (
        (flank.root, flank.fillet),
        (flank.fillet, flank.involute),
        (flank.involute, flank.tip),
    ):
        assert (r_1[-1], a_1[-1]) == pytest.approx((r_2[0], a_2[0]), abs=1e-12)


@pytest.mark.parametrize("case", PROTUBERANT)
def test_a_protuberance_undercuts_the_finished_flank(case):
    """Below the form circle the fillet lies inside the involute; on it both meet."""
    system, w = made(*case)
    cut = Cut(system, w.teeth, w.profile_shift)
    radius, angle = cut.fillet_point(cut.end_of_fillet)
    assert angle == pytest.approx(float(cut.involute(radius)), abs=1e-12)
    r, a = cut.fillet(np.linspace(cut.end_of_fillet - 0.01, cut.end_of_fillet, 50)[:-1])
    assert np.all(a[r > cut.base_radius] < cut.involute(r[r > cut.base_radius]))
    without, _ = made(*case[:4], case[4], case[4])
    assert w.form_diameter > form_diameter_of_undercut(Cut(without, w.teeth, w.profile_shift))


@pytest.mark.parametrize("case", PROTUBERANT[:4])
def test_the_corner_touches_the_flank_of_the_tool_s_pr_under_the_finished_one(case):
    """At φ = −α_n the fillet lies on the involute that the tool would go on with: s_pr inside, normal to the flank."""
    system, w = made(*case)
    cut = Cut(system, w.teeth, w.profile_shift)
    radius, angle = cut.fillet_point(-system.alpha_n)
    inside = (float(cut.involute(radius)) - angle) * cut.base_radius * math.cos(system.base_helix_angle)
    assert inside == pytest.approx(system.s_pr, rel=1e-9)


@pytest.mark.parametrize("case", STEPPED)
def test_stock_without_protuberance_leaves_a_step_of_its_size(case):
    """Beside each other on the form circle: the end of the tool's fillet outside, the finished involute inside; s_pr
    along the base tangent."""
    system, w = made(*case)
    flank = regions(system, w)
    (r_1, r_2), (a_1, a_2) = flank.fillet[0][-2:], flank.fillet[1][-2:]
    assert r_1 == pytest.approx(r_2, rel=1e-14) and a_1 > a_2
    step = (a_1 - a_2) * w.base_diameter / 2 * math.cos(system.base_helix_angle)
    assert step == pytest.approx(finishing_step(system), rel=1e-9) and step == pytest.approx(
        (case[4] - case[5]) * 1e-3, rel=1e-9
    )
    whole = tooth(system, w)
    assert np.all(np.diff(np.angle(whole[: whole.size // 2])) >= -1e-15)


def test_no_step_where_the_protuberance_covers_the_stock():
    for case in PLAIN + PROTUBERANT:
        assert finishing_step(made(*case)[0]) == 0.0


def test_form_diameter_is_continuous_where_the_protuberance_vanishes():
    """The crossing lies √s_pr above the tangent point, so the difference falls with the root of it."""
    at = [made(30, 0.2, 15.0, (1.25, 0.38), 0.1, 0.1 + e)[1].form_diameter for e in (0.0, 1e-9, 1e-7)]
    assert 0 <= at[1] - at[0] < 1e-6 and at[1] < at[2] < at[0] + 1e-5


def test_the_hob_is_held_back_from_the_root_by_the_stock():
    """h_fP = h_aP0 − q/(m_n·sin α_n), as generally published (ISO 21771)."""
    whole, held = made(30, 0.2, 15.0, (1.25, 0.38))[1], made(30, 0.2, 15.0, (1.25, 0.38), 0.1, 0.1)[1]
    assert held.root_diameter - whole.root_diameter == pytest.approx(2e-4 / math.sin(math.radians(20)), rel=1e-9)


def test_what_the_protuberance_must_be_like_is_said():
    system, w = made(*PROTUBERANT[3])
    cut = Cut(system, w.teeth, w.profile_shift)
    assert f"at most {math.degrees(-cut.end_of_fillet):.1f}°" in protuberance_note(cut)
    system, w = made(*PLAIN[0])
    assert protuberance_note(Cut(system, w.teeth, w.profile_shift)) == ""


@pytest.mark.parametrize("q, pr", [(0.0, 0.0), (0.05, 0.02), (0.02, 0.06)])
@pytest.mark.parametrize("addendum, rho, said", [(1.25, 0.6, "at most "), (2.9, 0.3, "less than ")])
def test_a_tool_whose_corners_overlap_says_what_it_can_have(q, pr, addendum, rho, said):
    """With the radius, or the addendum, that is said there is such a tool; with a little more there is none."""
    with pytest.raises(
        NoSolution, match=f"tool_tip_radius = {rho} with gears.tool_addendum = {addendum}: the round corners"
    ) as caught:
        made(20, 0.0, 10.0, (addendum, rho), q, pr)
    limit = float(caught.value.advice.split(said)[1].split()[0].rstrip(",:"))

    def tool(size):
        gears = train([wheel("a", 20)], [], beta=10.0, tool=(addendum, size) if rho == 0.6 else (size, 0.0))
        return tooth_system(dataclasses.replace(gears, stock=q * 1e-3, protuberance=pr * 1e-3))

    assert tool_problem(tool(limit)) is None
    with pytest.raises(NoSolution):
        tool(limit + 1.1e-4)


@settings(deadline=None, max_examples=150)
@given(
    z=st.integers(8, 120),
    x=st.floats(-0.6, 0.9),
    beta=st.floats(0, 30),
    addendum=st.floats(1.0, 1.5),
    rho=st.floats(0.0, 0.4),
    q=st.floats(0, 0.1),
    pr=st.floats(0, 0.15),
)
@example(
    z=9, x=0.0, beta=28.98289905353122, addendum=1.4291630101867394, rho=0.0, q=0.0, pr=0.0
)  # rounding puts a chord at an end
def test_any_tool_makes_a_whole_flank_or_says_why_not(z, x, beta, addendum, rho, q, pr):
    try:
        system, w = made(z, x, beta, (addendum, rho), q, pr)
        flank = regions(system, w)
    except NoSolution:
        return
    radius = np.concatenate([flank.fillet[0], flank.involute[0]])
    assert np.all(np.diff(radius) >= -1e-12)
    assert np.all(np.concatenate([flank.fillet[1], flank.involute[1]]) < np.pi / z + 1e-9)
    cut = Cut(system, z, w.profile_shift)
    gap = cut.fillet_point(cut.end_of_fillet)[1] - float(cut.involute(cut.fillet_point(cut.end_of_fillet)[0]))
    step = finishing_step(system) / math.cos(system.base_helix_angle) / cut.base_radius
    assert -1e-9 < gap < step + 1e-9
    assert 2 * flank.involute[0][0] == pytest.approx(w.form_diameter, rel=1e-6)
