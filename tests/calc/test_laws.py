# SPDX-License-Identifier: Apache-2.0
"""What physics says of oils, elastic contact and fits, whichever they are; the list of all such laws is
docs/laws.md."""

import math
from dataclasses import replace

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from calc.library import contact as hertz
from calc.library import contact as line
from calc.library.catalogue import materials, oils
from calc.library.lubricant import Lubricant
from calc.library.oil_formulas import of_index_0, of_index_100, viscosity_index
from calc.library.tolerances import GRADES, SHAFTS, ToleranceField, clearance_limits, tolerance

OILS = st.sampled_from(sorted(oils()))
laws = st.sampled_from(["walther", "d341"])


# --- oils
@settings(max_examples=100, deadline=None)
@given(name=OILS, law=laws, T=st.floats(-10, 145), hotter=st.floats(0.1, 20))
def test_oil_thins_with_heat(name, law, T, hotter):
    """ν, μ, ρ and α fall with temperature, c_p rises; μ = ν·ρ."""
    oil = Lubricant(oils()[name], law)
    cold, warm = oil.at(T), oil.at(T + hotter)
    assert warm.nu < cold.nu and warm.mu < cold.mu and warm.rho < cold.rho and warm.cp > cold.cp
    assert cold.mu == pytest.approx(cold.nu * cold.rho, rel=1e-12)
    assert 0 < oil.alpha(warm.mu) <= oil.alpha(cold.mu)


@settings(max_examples=100, deadline=None)
@given(name=OILS, law=laws, T=st.floats(0, 140))
def test_the_temperature_coefficient_is_the_slope_of_the_law(name, law, T):
    """β = −d ln μ/dT, by differences of the law itself."""
    oil = Lubricant(oils()[name], law)
    step = 1e-3
    slope = (math.log(oil.at(T - step).mu) - math.log(oil.at(T + step).mu)) / (2 * step)
    assert oil.beta(T) == pytest.approx(slope, rel=1e-6)


@settings(max_examples=100, deadline=None)
@given(name=OILS, law=laws, T=st.tuples(st.floats(0, 140), st.floats(0, 140), st.floats(0, 140)))
def test_the_viscosity_line_is_straight(name, law, T):
    """lg lg(ν + c) over lg T (absolute): three points of an oil lie on one line."""
    oil = Lubricant(oils()[name], law)
    assume(min(abs(a - b) for a, b in ((T[0], T[1]), (T[1], T[2]), (T[0], T[2]))) > 1)
    x = [math.log10(t + 273.15) for t in T]
    y = [math.log10(math.log10(oil.at(t).nu * 1e6 + oil.c)) for t in T]
    assert (y[1] - y[0]) * (x[2] - x[0]) == pytest.approx((y[2] - y[0]) * (x[1] - x[0]), rel=1e-7)


@settings(max_examples=100, deadline=None)
@given(nu_100=st.floats(2.0e-6, 60e-6), share=st.floats(0.3, 1.2), more=st.floats(1.01, 1.3))
def test_the_viscosity_index_tells_how_little_an_oil_thins(nu_100, share, more):
    """100 and 0 are the reference oils; it falls with the viscosity at 40 °C, also across 100, where both procedures
    meet."""
    L, H = of_index_0(nu_100=nu_100), of_index_100(nu_100=nu_100)
    assume(L > H * 1.001 and share * H > nu_100)  # up to some 2.1 mm²/s the reference oils are nearly one
    assert viscosity_index(H, nu_100) == pytest.approx(100) and viscosity_index(L, nu_100) == pytest.approx(0, abs=1e-9)
    assert viscosity_index(H * (1 - 1e-9), nu_100) == pytest.approx(100, abs=1e-3)
    assert viscosity_index(share * H, nu_100) > viscosity_index(share * H * more, nu_100)


@settings(max_examples=60, deadline=None)
@given(name=OILS, factor=st.floats(0.3, 3), T=st.floats(20, 140), alpha_40=st.floats(5e-9, 4e-8))
def test_thicker_oil_stiffens_more_under_pressure(name, factor, T, alpha_40):
    """α ~ μˢ, through the value given at 40 °C."""
    own = Lubricant(replace(oils()[name], pressure_viscosity_40=alpha_40))
    assert own.alpha(own.at(40.0).mu) == pytest.approx(alpha_40, rel=1e-12)
    mu = own.at(T).mu
    assert own.alpha(mu * factor**2) * own.alpha(mu) == pytest.approx(own.alpha(mu * factor) ** 2, rel=1e-9)
    assert (own.alpha(mu * 1.1) > own.alpha(mu)) is True


# --- two bodies in contact
@settings(max_examples=100, deadline=None)
@given(
    w=st.floats(10, 1e7),
    rho=st.floats(1e-4, 1),
    E=st.floats(1e9, 1e12),
    load=st.floats(0.1, 10),
    size=st.floats(0.1, 10),
    hard=st.floats(0.1, 10),
)
def test_hertz_goes_with_roots(w, rho, E, load, size, hard):
    """p ~ √(w·E/ρ), b ~ √(w·ρ/E); similar bodies under similar loads (w ~ l) have one pressure."""
    p, b = hertz.hertz_pressure(w=w, E_r=E, rho_n=rho), hertz.half_width(w=w, rho_n=rho, E_r=E)
    assert hertz.hertz_pressure(w=w * load, E_r=E * hard, rho_n=rho * size) == pytest.approx(
        p * math.sqrt(load * hard / size), rel=1e-9
    )
    assert hertz.half_width(w=w * load, E_r=E * hard, rho_n=rho * size) == pytest.approx(
        b * math.sqrt(load * size / hard), rel=1e-9
    )
    assert hertz.hertz_pressure(w=w * size, E_r=E, rho_n=rho * size) == pytest.approx(p, rel=1e-9)
    assert b * E / (4 * rho) == pytest.approx(p, rel=1e-9)  # the slope of the dented surface: p = E_r·b/(4·ρ)


@settings(max_examples=60, deadline=None)
@given(one=st.sampled_from(sorted(materials())), two=st.sampled_from(sorted(materials())), stiffer=st.floats(1.01, 10))
def test_the_softer_body_yields_more(one, two, stiffer):
    """Reduced modulus: 1/E_r is the mean of both bodies' (1 − ν²)/E, so between theirs, the same either way round,
    rising with each."""
    a, b = materials()[one], materials()[two]
    both = hertz.reduced_modulus(nu_1=a.poisson, E_1=a.E, nu_2=b.poisson, E_2=b.E)
    alone = [hertz.reduced_modulus(nu_1=x.poisson, E_1=x.E, nu_2=x.poisson, E_2=x.E) for x in (a, b)]
    assert min(alone) * (1 - 1e-12) <= both <= max(alone) * (1 + 1e-12)
    assert 2 / both == pytest.approx(1 / alone[0] + 1 / alone[1], rel=1e-9)
    assert hertz.reduced_modulus(nu_1=b.poisson, E_1=b.E, nu_2=a.poisson, E_2=a.E) == pytest.approx(both, rel=1e-12)
    assert hertz.reduced_modulus(nu_1=a.poisson, E_1=a.E * stiffer, nu_2=b.poisson, E_2=b.E) > both


@settings(max_examples=60, deadline=None)
@given(
    T=st.floats(1e-3, 1),
    z_1=st.integers(5, 200),
    z_2=st.integers(5, 200),
    x=st.floats(0.01, 0.99),
    n=st.floats(0.1, 500),
)
def test_two_flanks_roll_as_their_curvatures(T, z_1, z_2, x, n):
    """ρ_1 + ρ_2 = T_1T_2; the relative curvature is the sum of both and largest where a flank starts; at the pitch
    point both roll alike."""
    rho_1 = x * T
    rho_2 = line.driven_curvature(T=T, rho_1=rho_1)
    rho = line.relative_radius(rho_1=rho_1, rho_2=rho_2)
    assert rho_1 + rho_2 == pytest.approx(T, rel=1e-12) and 1 / rho == pytest.approx(1 / rho_1 + 1 / rho_2, rel=1e-9)
    assert rho <= T / 4 * (1 + 1e-12) and rho == pytest.approx(x * (1 - x) * T, rel=1e-9)
    C = line.pitch_point(T=T, z_1=z_1, z_2=z_2)
    assert line.rolling_speed(n=n, rho=C) == pytest.approx(
        line.rolling_speed(n=n * z_1 / z_2, rho=line.driven_curvature(T=T, rho_1=C)), rel=1e-9
    )


# --- fits
@settings(max_examples=100, deadline=None)
@given(
    letter=st.sampled_from(SHAFTS),
    journal=st.sampled_from([g for g in GRADES if 4 <= g <= 13]),
    seat=st.sampled_from([g for g in GRADES if 4 <= g <= 13]),
    d=st.floats(0.0011, 0.5),
)
def test_a_fit_is_the_same_by_its_hole_or_by_its_shaft(letter, journal, seat, d):
    """f7 in H8 has the clearance of h7 in F8; its spread is the sum of both widths; a coarser grade never narrows
    it."""
    by_hole = clearance_limits(ToleranceField(letter, journal), ToleranceField("H", seat), d)
    by_shaft = clearance_limits(ToleranceField("h", journal), ToleranceField(letter.upper(), seat), d)
    if letter != "js":
        assert by_hole == pytest.approx(by_shaft, abs=1e-9)
        assert by_hole[0] >= 0
    least, most = by_hole
    assert most - least == pytest.approx(tolerance(journal, d) + tolerance(seat, d), abs=1e-9)
    assert sum(by_hole) == pytest.approx(sum(by_shaft) if letter != "js" else tolerance(seat, d) + 0.0, abs=1e-9)
    coarser = clearance_limits(ToleranceField(letter, journal), ToleranceField("H", seat + 1), d)
    assert coarser[0] == pytest.approx(least, abs=1e-9) and coarser[1] > most
