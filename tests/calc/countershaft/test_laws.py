# SPDX-License-Identifier: Apache-2.0
"""What mechanics says of any shaft on its supports; the list of all such laws is docs/laws.md."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.countershaft.bending.beam import beam, bend, displaced, natural_frequency
from calc.countershaft.outline import sector_area, sector_moment
from calc.countershaft.sizing import formulas as sizing
from calc.countershaft.supports import reactions

pieces = st.lists(
    st.tuples(st.floats(0.02, 0.4), st.floats(1e2, 1e6), st.floats(1e6, 1e9), st.floats(0.5, 50)),
    min_size=1,
    max_size=5,
)
hundredths = st.integers(0, 100).map(lambda n: n / 100)  # places closer than a micrometre are one node
pins = st.tuples(hundredths.map(lambda x: 0.4 * x), hundredths.map(lambda x: 0.6 + 0.4 * x))
place = hundredths


def shaft(pieces, pins, *, q=0.0, forces=((), ()), masses=((), ()), length=1.0, stiffness=1.0, mass=1.0, more=()):
    """A stepped beam; places of pins, forces and masses in parts of its length."""
    l, EI, S, mu = (np.array(column) for column in zip(*pieces))
    ends = np.append(0, np.cumsum(l)) * length
    inner = [*pins, *more]
    return beam(
        ends,
        EI * stiffness,
        S * stiffness / length**2,
        mu * mass,
        np.full(l.size, q),
        np.array(inner) * ends[-1],
        (np.array(forces[0]) * ends[-1], forces[1]),
        (np.array(masses[0]) * ends[-1], masses[1]),
        longest=0.05 * length,
    )


def deflection(model, z):
    """At the node at z, in parts of the length."""
    return bend(model).w[np.abs(model.z - z * model.z[-1]).argmin()]


@settings(max_examples=50, deadline=None)
@given(pieces=pieces, pins=pins, a=place, b=place)
def test_maxwell_and_betti(pieces, pins, a, b):
    """The deflection at a under a force at b is that at b under the same force at a."""
    # both places are nodes of both
    at_a, at_b = (shaft(pieces, pins, forces=([x, y], [1000.0, 0.0])) for x, y in ((a, b), (b, a)))
    one, other = deflection(at_a, b), deflection(at_b, a)
    size = max(abs(bend(model).w).max() for model in (at_a, at_b))
    assert abs(one - other) <= 1e-6 * size


@settings(max_examples=40, deadline=None)
@given(
    pieces=pieces, pins=pins, a=place, b=place, F=st.floats(-1e4, 1e4), G=st.floats(-1e4, 1e4), q=st.floats(-1e4, 1e4)
)
def test_loads_superpose_in_both_planes(pieces, pins, a, b, F, G, q):
    """Deflections, moments and reactions of loads together are the sum of those of each, also of loads at right
    angles."""
    parts = [((F, 0.0), 0.0), ((0.0, 1j * G), 0.0), ((0.0, 0.0), q)]
    one, two, three = (bend(shaft(pieces, pins, q=load, forces=([a, b], forces))) for forces, load in parts)
    whole = bend(shaft(pieces, pins, q=q, forces=([a, b], (F, 1j * G))))
    for name in ("w", "theta", "moment", "reactions"):
        columns = [getattr(x, name) for x in (one, two, three)]
        size = sum(np.abs(column).max() for column in columns) + 1e-30
        assert np.abs(getattr(whole, name) - sum(columns)).max() < 1e-6 * size, name


@settings(max_examples=40, deadline=None)
@given(pieces=pieces, pins=pins, a=place, length=st.floats(0.2, 5), stiffness=st.floats(0.1, 10), F=st.floats(1, 1e4))
def test_similar_shafts_bend_alike(pieces, pins, a, length, stiffness, F):
    """w ~ F·L³/(E·I), with κ·G·A·L²/(E·I) the same; moments ~ F·L."""
    small, large = (
        bend(shaft(pieces, pins, forces=([a], [force]), length=s, stiffness=k))
        for force, s, k in ((1.0, 1.0, 1.0), (F, length, stiffness))
    )
    size = np.abs(small.w).max() + 1e-12 * (np.abs(small.reactions).max())
    assert np.abs(large.w / (F * length**3 / stiffness) - small.w).max() < 1e-5 * size
    assert np.abs(large.moment / (F * length) - small.moment).max() < 1e-6 * (1 + np.abs(small.moment).max())


@settings(max_examples=40, deadline=None)
@given(pieces=pieces, pins=pins, stiffness=st.floats(0.1, 10), mass=st.floats(0.1, 10), length=st.floats(0.2, 5))
def test_frequency_goes_with_the_root_of_stiffness_over_mass(pieces, pins, stiffness, mass, length):
    """ω ~ √(E·I/μ)/L² of similar shafts."""
    one = natural_frequency(shaft(pieces, pins))
    other = natural_frequency(shaft(pieces, pins, stiffness=stiffness, mass=mass, length=length))
    assert other == pytest.approx(one * math.sqrt(stiffness / mass) / length**2, rel=1e-6)


@settings(max_examples=40, deadline=None)
@given(
    pieces=pieces, pins=pins, where=place, m=st.floats(0.1, 20), third=st.floats(0.42, 0.58), softer=st.floats(0.1, 0.9)
)
def test_rayleigh(pieces, pins, where, m, third, softer):
    """A mass lowers the lowest frequency, a support raises it, a softer piece lowers it; never the other way."""
    plain = natural_frequency(shaft(pieces, pins, masses=([where], [0.0])))
    heavier = natural_frequency(shaft(pieces, pins, masses=([where], [m])))
    held = natural_frequency(shaft(pieces, pins, more=(third,), masses=([where], [0.0])))
    l, EI, S, mu = pieces[0]
    soft = natural_frequency(shaft([(l, EI * softer, S, mu), *pieces[1:]], pins, masses=([where], [0.0])))
    assert heavier <= plain * (1 + 1e-7) and held >= plain * (1 - 1e-7) and soft <= plain * (1 + 1e-7)


@settings(max_examples=30, deadline=None)
@given(pieces=pieces, pins=pins, share=st.floats(0.05, 0.9), q=st.floats(1, 1e4))
def test_turning_below_the_critical_speed_bends_more(pieces, pins, share, q):
    """The work of the load grows with the speed, at least by 1 and at most by 1/(1 − (ω/ω_1)²)."""
    model = shaft(pieces, pins, q=q)
    omega = share * natural_frequency(model)
    still, turning = (float((displaced(model, x).conj() @ model.f).real) for x in (0.0, omega))
    assert still * (1 - 1e-9) <= turning <= still / (1 - share**2) * (1 + 1e-6)


@settings(max_examples=60, deadline=None)
@given(
    spans=st.lists(st.floats(0.05, 1.0), min_size=1, max_size=5),
    arm=st.floats(0.01, 0.5),
    at=st.floats(-0.3, 1.3),
    F=st.floats(1, 1e4),
    angle=st.floats(0, 6.2),
)
def test_a_couple_asks_for_no_force(spans, arm, at, F, angle):
    """Two opposite forces: reactions add up to nothing and have the opposite couple, and on two supports C/L, wherever
    the couple sits."""
    z = np.cumsum([0.0, *spans])
    push = F * np.exp(1j * angle)
    places = np.array([at, at + arm])
    R = reactions([push, -push], places, z)
    size = np.abs(R).sum() + F
    assert abs(R.sum()) < 1e-11 * size and abs(R @ z - push * arm) < 1e-11 * size * (1 + z[-1])
    if len(spans) == 1:
        assert abs(R[0] + push * arm / z[1]) < 1e-11 * size and abs(R[1] - push * arm / z[1]) < 1e-11 * size


@settings(max_examples=60, deadline=None)
@given(
    R=st.floats(0.02, 0.2),
    core=st.floats(0.05, 0.95),
    gamma=st.floats(0.05, math.pi),
    scale=st.floats(0.2, 5),
    rho=st.floats(1000, 12000),
)
def test_a_sector_is_the_sum_of_its_parts(R, core, gamma, scale, rho):
    """Area and static moment are the integrals of dA and y·dA over the section; they go with l² and l³."""
    r_0, phi = core * R, np.linspace(-gamma, gamma, 4001)
    ring, moment = (R**2 - r_0**2) / 2, (R**3 - r_0**3) / 3 * np.trapezoid(np.cos(phi), phi)
    area, static = sector_area(gamma=gamma, R=R, r_0=r_0), sector_moment(gamma=gamma, R=R, r_0=r_0)
    assert area == pytest.approx(ring * 2 * gamma, rel=1e-9) and static == pytest.approx(
        moment, rel=1e-5, abs=1e-6 * R**3
    )
    assert sector_area(gamma=gamma, R=scale * R, r_0=scale * r_0) == pytest.approx(scale**2 * area, rel=1e-9)
    assert sector_moment(gamma=gamma, R=scale * R, r_0=scale * r_0) == pytest.approx(scale**3 * static, rel=1e-9)
    most = sizing.unbalance_per_length(rho=rho, R=R, r_0=r_0)
    assert rho * static <= most * (1 + 1e-12)
    assert most == pytest.approx(rho * sector_moment(gamma=math.pi / 2, R=R, r_0=r_0), rel=1e-12)
