# SPDX-License-Identifier: Apache-2.0
"""What hydrodynamics says of any plain bearing; the list of all such laws is docs/laws.md."""

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from calc.bearings.inputs import BearingsInputs
from calc.bearings.plain import formulas as f
from calc.bearings.plain.film import short_bearing as short
from calc.bearings.plain.film.dynamics import coefficients
from calc.bearings.plain.film.reynolds import radial_damping
from calc.bearings.plain.film.reynolds import solve_film as reynolds
from calc.bearings.plain.film.table import film_at
from calc.bearings.plain.routes import flow
from calc.bearings.plain.routes.routes import own_cold, own_warm
from calc.bearings.plain.routes.states import BearingCase, OperatingPoint
from calc.bearings.plain.solve import solve_film
from calc.countershaft.rows import BearingRow
from calc.library.catalogue import oils
from calc.library.lubricant import Lubricant
from calc.sheet.errors import BadInput, NoSolution

OILS = sorted(oils())
eccentricities, ratios = st.floats(0.03, 0.97), st.floats(0.1, 2.0)
diameters, clearances = st.floats(0.01, 0.4), st.floats(5e-4, 4e-3)  # m, over the diameter
speeds, temperatures = st.floats(2, 200), st.floats(30, 130)


@st.composite
def cases(draw):
    """Any bearing whose film is in the table, under the load that makes a drawn eccentricity: (case, operating point,
    ε, l/d)."""
    d, psi, b, eps, n = draw(diameters), draw(clearances), draw(ratios), draw(eccentricities), draw(speeds)
    l, g = b * d, psi * d
    sizes = dict(diameter=d, length=l, clearance=g, load=1.0, journal_roughness=0.0, housing_roughness=0.0)
    bearing = BearingRow(name="front", position=0.0, **sizes)
    inputs = BearingsInputs(
        oil=draw(st.sampled_from(OILS)),
        supply_temperature=draw(temperatures),
        supply_pressure=3e5,
        supply="hole",
        hole_diameter=l / 10,
        housing_material="steel",
        load_speed_ratio=1.0,
    )
    case = BearingCase(bearing, inputs, Lubricant(oils()[inputs.oil]), g, 1.15e-5, 1.15e-5)
    mu = case.oil_at(inputs.supply_temperature).mu
    F = mu * n / (film_at(eps, b).sommerfeld * psi**2) * d * l
    return case, OperatingPoint(F, n, n, 1.0, inputs.supply_temperature, inputs.supply_pressure), eps, b


def sized(case, k):
    b = case.bearing
    return replace(case, bearing=replace(b, diameter=k * b.diameter, length=k * b.length), clearance=k * case.clearance)


# --- similarity
@settings(max_examples=40, deadline=None)
@given(asked=cases(), size=st.floats(0.2, 5), load=st.floats(0.2, 5))
def test_the_film_knows_one_number_only(asked, size, load):
    """ε depends on S = μ·n/(p·ψ²) at a given l/d alone: size with p the same, load with speed, load with viscosity."""
    case, duty, eps, _ = asked
    plain = own_cold(case, duty, 0.0)
    larger = own_cold(sized(case, size), replace(duty, load=duty.load * size**2), 0.0)
    faster = own_cold(
        case,
        replace(duty, load=duty.load * load, speed=duty.speed * load, effective_speed=duty.effective_speed * load),
        0.0,
    )
    thicker = own_cold(replace(case, viscosity_factor=load), replace(duty, load=duty.load * load), 0.0)
    for film in (plain, larger, faster, thicker):
        assert film.eccentricity == pytest.approx(eps, rel=1e-7)
        assert film.friction_variable == pytest.approx(plain.friction_variable, rel=1e-7)
    assert larger.film == pytest.approx(size * plain.film, rel=1e-7)
    assert larger.friction_power == pytest.approx(size**3 * plain.friction_power, rel=1e-7)
    assert faster.friction_power == pytest.approx(load**2 * plain.friction_power, rel=1e-7)
    assert faster.side_flow == pytest.approx(load * plain.side_flow, rel=1e-7)
    assert thicker.friction_power == pytest.approx(load * plain.friction_power, rel=1e-7)
    assert larger.side_flow == pytest.approx(size**3 * plain.side_flow, rel=1e-7)


@settings(max_examples=60, deadline=None)
@given(asked=cases())
def test_film_and_clearance_and_power(asked):
    """h_0 = c·(1 − ε); P_f = f·F·u, f = ψ·f*; So·S = 1/(2π)."""
    case, duty, _, _ = asked
    film = own_cold(case, duty, 0.0)
    assert film.film == pytest.approx(film.clearance / 2 * (1 - film.eccentricity), rel=1e-9)
    torque = film.friction_variable * film.relative_clearance * duty.load * case.bearing.diameter / 2
    assert film.friction_power == pytest.approx(torque * 2 * math.pi * duty.effective_speed, rel=1e-9)
    So = f.sommerfeld_din(
        p=film.specific_load, psi=film.relative_clearance, mu=film.oil.mu, omega=f.angular_speed(n=duty.effective_speed)
    )
    assert So * film.sommerfeld == pytest.approx(1 / (2 * math.pi), rel=1e-12)


@settings(max_examples=60, deadline=None)
@given(n_J=st.floats(-200, 200), n_B=st.floats(-200, 200), n_F=st.floats(-200, 200), turn=st.floats(-200, 200))
def test_the_film_does_not_know_who_looks(n_J, n_B, n_F, turn):
    """Journal, bush, load and observer: the same film from a frame that turns, with journal and bush exchanged, and in
    a mirror."""
    seen = f.effective_speed(n_J=n_J, n_B=n_B, n_F=n_F)
    for other in ((n_J + turn, n_B + turn, n_F + turn), (n_B, n_J, n_F), (-n_J, -n_B, -n_F)):
        assert f.effective_speed(n_J=other[0], n_B=other[1], n_F=other[2]) == pytest.approx(seen, abs=1e-9)
        assert f.sliding_speed(n_J=other[0], n_B=other[1]) == pytest.approx(f.sliding_speed(n_J=n_J, n_B=n_B), abs=1e-9)
    # a load at half speed finds no film
    assert f.effective_speed(n_J=n_J, n_B=n_B, n_F=(n_J + n_B) / 2) == pytest.approx(0, abs=1e-9)
    assert f.effective_speed(n_J=n_J, n_B=0.0, n_F=n_J) == pytest.approx(
        f.effective_speed(n_J=n_J, n_B=0.0, n_F=0.0), abs=1e-9
    )


# --- limits
@settings(max_examples=60, deadline=None)
@given(eps=eccentricities, b=ratios)
def test_no_film_rubs_less_than_petroff(eps, b):
    """f* ≥ 2π²·S, and both meet as ε → 0: they differ by no more than 2·ε²/(1 − ε²)."""
    film = film_at(eps, b)
    petroff = 2 * math.pi**2 * film.sommerfeld
    assert petroff < film.friction
    near = film_at(0.02, b)
    assert near.friction == pytest.approx(2 * math.pi**2 * near.sommerfeld, rel=3e-3)
    assert film.friction >= petroff / math.sqrt(1 - eps**2)


@settings(max_examples=12, deadline=None)
@given(eps=st.floats(0.03, 0.6), b=st.floats(0.1, 0.25))
def test_a_short_bearing_is_ocvirks(eps, b):
    """l/d → 0: load, attitude and flows of the direct solution come to the closed forms of the short bearing as (l/d)²
    does, the load from below."""
    film, square = reynolds(eps, b), b**2
    load = 1 / (2 * math.pi * film.sommerfeld) / short.sommerfeld_din(eps=eps, b=b)
    assert 1 - 1.5 * square < load < 1
    assert film.attitude == pytest.approx(short.attitude_angle(eps=eps), abs=0.2 * square)
    assert film.flow == pytest.approx(short.relative_flow(eps=eps), rel=0.2 * square)
    assert film.side_flow_ratio == pytest.approx(short.side_flow_share(eps=eps), rel=0.3 * square)
    # the usual grid is within 1e-2 at l/d 0.1
    damping = 2 * math.pi * film.sommerfeld * radial_damping(eps, b, cells=(384, 32))
    assert 1 - 4 * square < damping / short.radial_damping(eps=eps) < 1 - 0.1 * square


@settings(max_examples=8, deadline=None)
@given(eps=st.floats(0.05, 0.95))
def test_a_long_bearing_comes_to_sommerfelds(eps):
    """l/d → ∞: the load per area rises with l/d and stays below that of the infinite bearing, whose ends leak
    nothing."""
    loads = [1 / film_at(eps, b).sommerfeld for b in (0.25, 0.5, 1.0, 2.0)]
    endless = reynolds(eps, math.inf)
    loads.append(1 / endless.sommerfeld)
    assert all(after > before for before, after in pairwise(loads))
    assert endless.side_flow_ratio == 0.0
    leaks = [film_at(eps, b).side_flow_ratio for b in (0.1, 0.5, 1.0, 2.0)]
    assert all(after < before for before, after in pairwise(leaks))


@settings(max_examples=8, deadline=None)
@given(eps=st.floats(0.05, 0.95))
def test_the_pressure_carries_the_load(eps):
    """Infinitely long: ∫Π·cos θ dθ and ∫Π·sin θ dθ of the pressure that is shown give S and φ, and its largest value
    P/p_max."""
    film = reynolds(eps, math.inf)
    along, across = (np.trapezoid(film.pressure * g(film.theta), film.theta) for g in (np.cos, np.sin))
    assert math.pi * film.sommerfeld * math.hypot(along, across) == pytest.approx(1.0, rel=2e-3)
    assert math.atan2(across, -along) == pytest.approx(film.attitude, abs=2e-3)
    assert math.hypot(along, across) / 2 / film.pressure.max() == pytest.approx(film.pressure_ratio, rel=2e-3)


@settings(max_examples=12, deadline=None)
@given(eps=st.floats(0.05, 0.95), b=ratios)
def test_what_flows_in_leaves_by_the_sides_or_with_the_broken_film(eps, b):
    """Q − Q_s is dragged out where the film breaks, beyond the narrowest place: between π·(1 − ε) and π·h there, in the
    middle plane."""
    film = reynolds(eps, b)
    carried = film.flow * (1 - film.side_flow_ratio)
    broken = film.theta[np.flatnonzero(film.pressure > 0)[-1] + 1]
    assert math.pi < broken < 1.5 * math.pi
    assert math.pi * (1 - eps) * (1 - 1e-4) <= carried <= math.pi * (1 + eps * math.cos(broken)) * (1 + 1e-4)
    assert film.flow <= math.pi * (1 + eps) * (1 + 1e-4)  # pressure only hinders at the widest place


@settings(max_examples=60, deadline=None)
@given(eps=st.floats(0.03, 0.95), b=ratios, more=st.floats(1.001, 1.02))
def test_more_eccentric_means_more_load_nearer_to_the_load_line(eps, b, more):
    """So, the side flow and p_max/p rise with ε, the attitude angle falls."""
    eps_2 = min(eps * more, 0.97)
    one, two = film_at(eps, b), film_at(eps_2, b)
    assert two.sommerfeld < one.sommerfeld and two.attitude < one.attitude
    assert two.flow * two.side_flow_ratio > one.flow * one.side_flow_ratio
    assert 0 < two.pressure_ratio < 1 and 0 < two.attitude < math.pi / 2


# --- spring and damper
def force(x, y, b):
    """The film's force on the journal over μ·ω·d·l/ψ², real away from the line of the undisplaced load: of a journal at
    x + i·y."""
    place = x + 1j * y
    film = film_at(abs(place), b)
    return place / abs(place) * np.exp(-1j * film.attitude) / (2 * math.pi * film.sommerfeld)


@settings(max_examples=60, deadline=None)
@given(eps=st.floats(0.05, 0.95), b=ratios)
def test_stiffness_is_the_slope_of_the_force(eps, b):
    """K_ij = ∂F_i/∂x_j of the load that the displaced journal carries, in any direction."""
    phi = film_at(eps, b).attitude
    k = coefficients(eps, b)
    x, y, step = eps * math.cos(phi), eps * math.sin(phi), 1e-5
    load = abs(force(x, y, b))
    along, across = (
        (force(x + dx, y + dy, b) - force(x - dx, y - dy, b)) / (2 * step) / load
        for dx, dy in ((step, 0.0), (0.0, step))
    )
    size = max(abs(k.k_xx), abs(k.k_xy), abs(k.k_yx), abs(k.k_yy))
    assert [along.real, across.real, along.imag, across.imag] == pytest.approx(
        [k.k_xx, k.k_xy, k.k_yx, k.k_yy], abs=2e-3 * size
    )


@settings(max_examples=60, deadline=None)
@given(eps=st.floats(0.05, 0.95), b=ratios)
def test_a_journal_that_circles_at_half_the_speed_carries_nothing(eps, b):
    """Half-frequency whirl: the force of damping at the speed ε·ω/2 along the circle takes the whole load away."""
    phi, c = film_at(eps, b).attitude, coefficients(eps, b)
    along, across = -math.sin(phi) * eps / 2, math.cos(phi) * eps / 2
    assert 1 + c.c_xx * along + c.c_xy * across == pytest.approx(0, abs=1e-9)
    assert c.c_xy * along + c.c_yy * across == pytest.approx(0, abs=1e-9)


@settings(max_examples=60, deadline=None)
@given(eps=eccentricities, b=ratios)
def test_damping_takes_energy_from_every_motion(eps, b):
    """C is symmetric and positive definite; its trace and determinant do not know the axes that it is looked at
    from."""
    c = coefficients(eps, b)
    film = film_at(eps, b)
    assert c.c_xx + c.c_yy > 0 and c.c_xx * c.c_yy - c.c_xy**2 > 0
    across = 2 * math.sin(film.attitude) / eps  # moving along the circle, the force along it
    assert c.c_xx + c.c_yy == pytest.approx(film.radial_damping + across, rel=1e-9)


# --- oil, heat, clearance
@settings(max_examples=25, deadline=None)
@given(asked=cases(), more=st.floats(1.02, 1.5))
def test_in_thermal_balance_more_load_means_less_film(asked, more):
    """h_0 falls with the load and with the supply temperature; the film closes its balance at each."""
    case, duty, _, _ = asked
    b = case.bearing
    said = dict(
        diameter=b.diameter,
        length=b.length,
        clearance=b.clearance,
        speed=duty.speed,
        oil=case.inputs.oil,
        hole_diameter=case.inputs.hole_diameter,
    )
    try:
        light, heavy, hot = (
            solve_film(load=F, supply_temperature=T, **said)
            for F, T in ((duty.load, 60.0), (duty.load * more, 60.0), (duty.load, 60.0 + 20 * (more - 1)))
        )
    except (NoSolution, BadInput):  # a load larger than any in a file
        assume(False)
    assert heavy.film < light.film and heavy.friction_power > light.friction_power
    assert hot.film < light.film and hot.oil.mu < light.oil.mu
    for film in (light, heavy, hot):
        assert film.friction_power == pytest.approx(
            film.oil.rho * film.oil.cp * film.oil_flow * film.temperature_rise, rel=1e-6
        )


@settings(max_examples=40, deadline=None)
@given(asked=cases(), pressure=st.floats(0.2, 5))
def test_oil_is_pressed_through_as_through_a_slit(asked, pressure):
    """Poiseuille: Q_2 ~ p_s·g³/μ at the same ε and form, while the side flow does not know the supply pressure."""
    case, duty, _, _ = asked
    plain = own_cold(case, duty, 0.0)
    pressed = own_cold(case, replace(duty, supply_pressure=duty.supply_pressure * pressure), 0.0)
    assert pressed.supply_flow == pytest.approx(pressure * plain.supply_flow, rel=1e-9)
    assert pressed.side_flow == plain.side_flow and pressed.oil_flow == pytest.approx(
        pressed.side_flow + pressed.supply_flow, rel=1e-12
    )
    thicker = own_cold(replace(case, viscosity_factor=pressure), replace(duty, load=duty.load * pressure), 0.0)
    assert thicker.supply_flow == pytest.approx(plain.supply_flow / pressure, rel=1e-6)
    wide = own_cold(replace(case, clearance=2 * case.clearance), replace(duty, load=duty.load / 4), 0.0)
    assert wide.supply_flow == pytest.approx(8 * plain.supply_flow, rel=1e-6)


@settings(max_examples=60, deadline=None)
@given(
    eps=st.floats(0, 0.95),
    d=diameters,
    b=st.floats(0.2, 1.5),
    width=st.floats(0.05, 0.5),
    parts=st.lists(st.floats(0.01, 1), min_size=2, max_size=6),
)
def test_parts_of_a_groove_feed_as_the_whole(eps, d, b, width, parts):
    """Grooves side by side round the whole seat pass what the full groove does, each by the mean of (h/c)³ over it,
    with a load that stands or turns."""
    l = b * d
    b_G = width * l
    whole = flow.groove_factor(eps=eps, d=d, l=l, b_G=b_G)
    ends = np.append(0.0, np.cumsum(parts)) * 2 * math.pi / sum(parts)
    ends[-1] = 2 * math.pi
    fixed = sum(flow.part_groove_factor(eps=eps, phi_A=a, phi_E=e, d=d, l=l, b_G=b_G) for a, e in pairwise(ends))
    swept = sum(
        flow.swept_part_groove_factor(eps=eps, delta_A=a, delta_E=e, d=d, l=l, b_G=b_G) for a, e in pairwise(ends)
    )
    assert [fixed, swept] == pytest.approx([whole, whole], rel=1e-9)
    for a, e in pairwise(ends):
        phi = a + (e - a) * (np.arange(2000) + 0.5) / 2000
        opened = np.sum((1 + eps * np.cos(phi)) ** 3) * (e - a) / 2000 / 48 * d / (l - b_G)
        assert flow.part_groove_factor(eps=eps, phi_A=a, phi_E=e, d=d, l=l, b_G=b_G) == pytest.approx(
            opened, rel=1e-5, abs=1e-6 * whole
        )
    holes = np.mean([flow.at_angle(eps=eps, delta=delta) for delta in np.linspace(0, 2 * math.pi, 65)[:-1]])
    assert flow.swept(eps=eps) == pytest.approx(holes, rel=1e-12)
    assert flow.opposite(eps=eps) == pytest.approx(flow.at_angle(eps=eps, delta=math.pi), rel=1e-12)


@settings(max_examples=60, deadline=None)
@given(
    asked=cases(),
    journal=st.floats(5e-6, 3e-5),
    housing=st.floats(5e-6, 3e-5),
    chi=st.floats(0, 1),
    T=st.floats(-40, 200),
    way=st.floats(-40, 200),
)
def test_clearance_is_linear_in_temperature(asked, journal, housing, chi, T, way):
    """Warmed in two steps as in one; of one material not at all; a seat that is held does not grow; the warm route runs
    at that clearance."""
    case, duty, _, _ = asked
    d, g = case.bearing.diameter, case.clearance
    said = dict(d=d, alpha_H=housing, alpha_J=journal, chi=chi)
    at_once = f.clearance_at(g=g, T=T, T_ref=20.0, **said)
    between = f.clearance_at(g=g, T=way, T_ref=20.0, **said)
    assert f.clearance_at(g=between, T=T, T_ref=way, **said) == pytest.approx(at_once, abs=1e-12 * d)
    assert f.clearance_at(g=g, T=T, T_ref=20.0, **{**said, "alpha_J": housing, "chi": 0.0}) == pytest.approx(
        g, rel=1e-12
    )
    held, free = (f.clearance_at(g=g, T=T, T_ref=20.0, **{**said, "chi": x}) for x in (1.0, 0.0))
    # the block holds the seat: the journal alone grows
    assert held == pytest.approx(g - d * journal * (T - 20), rel=1e-9)
    assert free - held == pytest.approx(d * housing * (T - 20), rel=1e-9, abs=1e-12 * d)
    assert at_once == pytest.approx(chi * held + (1 - chi) * free, rel=1e-9, abs=1e-12 * d)
    warm = own_warm(replace(case, journal_expansion=housing, housing_expansion=housing), duty, 0.0)
    assert warm.clearance == pytest.approx(g, rel=1e-12) and warm.film == pytest.approx(
        own_cold(case, duty, 0.0).film, rel=1e-9
    )


@settings(max_examples=60, deadline=None)
@given(
    eps=st.floats(0.05, 0.95),
    b=st.floats(0.11, 1.9),
    R_0=st.floats(0, 1e4),
    F=st.floats(1, 1e4),
    n=speeds,
    ratio=st.floats(0.1, 10),
)
def test_loads_of_eccentric_masses_grow_with_the_square_of_the_speed(eps, b, R_0, F, n, ratio):
    """F ~ n²: then S goes with 1/n, the turning load is as large as the standing one at n_0, and the peak is their
    sum."""
    assert f.load_at_speed(F=F, n=n * ratio, n_0=n) == pytest.approx(ratio**2 * F)
    n_0 = f.speed_of_equal_loads(n=n, R_0=R_0, R=F)
    assert f.load_at_speed(F=F, n=n_0, n_0=n) == pytest.approx(R_0, abs=1e-9)
    S, faster = (f.sommerfeld(mu=0.01, n_h=x, p=f.load_at_speed(F=F, n=x, n_0=n), psi=1e-3) for x in (n, n * ratio))
    assert faster == pytest.approx(S / ratio)
    assert f.load_peak(F=F, R_0=R_0) >= max(F, R_0)
