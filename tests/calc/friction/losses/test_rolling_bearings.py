# SPDX-License-Identifier: Apache-2.0
"""Rolling bearings by Palmgren and by SKF, against the same equations written in N, mm, mm²/s and rpm."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from calc.bearings.rolling.torque import constants
from calc.friction.inputs import SKF_SERIES, RollingBearing
from calc.friction.losses import bearings as b
from calc.sheet.errors import NoSolution


def bearing(**said):
    """A 6205, of which two share the load."""
    return RollingBearing(**{"name": "idler", "bore": 25e-3, "outside_diameter": 52e-3, **said})


def power(one, F=1000.0, rpm=3000.0, nu=15.0):
    return b.power(one, F, rpm / 60, nu * 1e-6)


def by_palmgren(F, rpm, nu, f_0, f_1, d=25.0, D=52.0):
    """In the units of the catalogues, one bearing, in W; the constant below ν·n = 2000."""
    d_m = (d + D) / 2
    M_0 = 160e-7 * f_0 * d_m**3 if nu * rpm < 2000 else 1e-7 * f_0 * (nu * rpm) ** (2 / 3) * d_m**3
    return (M_0 + f_1 * F * d_m) * rpm * math.pi / 30 * 1e-3


# --- Palmgren
@pytest.mark.parametrize("rpm, nu", [(3000.0, 15.0), (10000.0, 8.0), (100.0, 5.0), (1000.0, 1.5)])
def test_palmgren_in_the_units_of_the_catalogues(rpm, nu):
    one = bearing(lubrication="bath", count=1)
    assert power(one, rpm=rpm, nu=nu) == pytest.approx(by_palmgren(1000.0, rpm, nu, 2.0, 0.0003), rel=1e-9)


def test_palmgren_by_hand():
    """ν·n = 45 000: M_0 = 1e-7·2·1265.2·57066.6 = 14.44 N·mm, M_1 = 0.0003·1000·38.5 = 11.55 N·mm."""
    assert power(bearing(lubrication="bath", count=1)) == pytest.approx((14.44 + 11.55) * 1e-3 * 314.159, rel=2e-4)


def test_the_two_branches_meet_beside_2000():
    """2000^(2/3) is 158.7 and not 160: the larger counts, so that the torque never falls with the speed."""
    torque = [b.torque_of_oil(f_0=2.0, nu=1e-6 * nu, n=1000 / 60, d_m=38.5e-3) for nu in (1.0, 1.999, 2.0, 2.03, 3.0)]
    assert torque[0] == torque[1] == pytest.approx(160e-7 * 2 * 38.5**3 * 1e-3)
    assert torque == sorted(torque)
    assert torque[4] == pytest.approx(1e-7 * 3000 ** (2 / 3) * 2 * 38.5**3 * 1e-3)


@pytest.mark.parametrize("lubrication, factor", [("bath", 1.0), ("mist", 0.5), ("jet", 2.0)])
def test_how_the_oil_comes_changes_its_part(lubrication, factor):
    assert power(bearing(lubrication=lubrication, f_1=0.0)) == pytest.approx(
        factor * power(bearing(lubrication="bath", f_1=0.0))
    )
    assert power(bearing(lubrication=lubrication, f_0=0.0)) == pytest.approx(
        power(bearing(lubrication="bath", f_0=0.0))
    )


def test_given_factors_are_taken_as_they_are():
    one = bearing(lubrication="jet", f_0=1.7, f_1=0.0007, count=1)
    assert power(one) == pytest.approx(by_palmgren(1000.0, 3000.0, 15.0, 1.7, 0.0007))


def test_the_load_is_shared():
    """The part of the load stays, that of the oil counts once for each."""
    one, four = bearing(count=1), bearing(count=4)
    oil, load = power(bearing(count=1, f_1=0.0)), power(bearing(count=1, f_0=0.0))
    assert power(one) == pytest.approx(oil + load)
    assert power(four) == pytest.approx(4 * oil + load)


@pytest.mark.parametrize(
    "kind, f_0, f_1",
    [
        ("deep-groove-ball", 2.0, 3e-4),
        ("angular-contact-ball", 3.3, 5e-4),
        ("self-aligning-ball", 1.75, 1e-4),
        ("cylindrical-roller", 3.0, 3e-4),
        ("needle-roller", 12.0, 2e-3),
        ("spherical-roller", 5.0, 4e-4),
        ("tapered-roller", 4.5, 4e-4),
    ],
)
def test_every_type_has_factors(kind, f_0, f_1):
    assert power(bearing(kind=kind, lubrication="bath", count=1)) == pytest.approx(
        by_palmgren(1000.0, 3000.0, 15.0, f_0, f_1)
    )


# --- SKF
def by_skf(F, rpm, nu, G_rr, G_sl, K_Z, mu_EHL, d=25.0, D=52.0):
    """The published equations in mm, N, N·mm, rpm and mm²/s; K_rs 3e-8, μ_bl 0.12.  The power of one bearing in W."""
    d_m = (d + D) / 2
    phi_ish = 1 / (1 + 1.84e-9 * (rpm * d_m) ** 1.28 * nu**0.64)
    phi_rs = 1 / math.e ** (3e-8 * nu * rpm * (d + D) * math.sqrt(K_Z / (2 * (D - d))))
    phi_bl = 1 / math.e ** (2.6e-8 * (rpm * nu) ** 1.4 * d_m)
    M = phi_ish * phi_rs * G_rr(d_m, F) * (nu * rpm) ** 0.6 + G_sl(d_m, F) * (phi_bl * 0.12 + (1 - phi_bl) * mu_EHL)
    return M * 1e-3 * rpm * math.pi / 30


def balls(R_1, S_1):
    return lambda d_m, F: R_1 * d_m**1.96 * F**0.54, lambda d_m, F: S_1 * d_m**-0.26 * F ** (5 / 3)


def rollers(R_1, S_2):
    return lambda d_m, F: R_1 * d_m**2.41 * F**0.31, lambda d_m, F: S_2 * d_m * F


@pytest.mark.parametrize("F, rpm, nu", [(1000.0, 3000.0, 15.0), (50.0, 10000.0, 8.0), (3000.0, 200.0, 100.0)])
def test_a_6205_by_skf(F, rpm, nu):
    one = bearing(method="skf", series="62", count=1, lubrication="bath")
    assert power(one, F, rpm, nu) == pytest.approx(by_skf(F, rpm, nu, *balls(3.9e-7, 3.23e-3), 3.1, 0.05), rel=1e-9)
    assert power(bearing(method="skf", series="62", count=2, lubrication="bath"), 2 * F, rpm, nu) == pytest.approx(
        2 * power(one, F, rpm, nu)
    )


CATALOGUE = {
    (4.4, 2.00): ("2", "3"),
    (5.4, 3.00): ("42", "43"),
    (4.1, 3.73): ("60", "630"),
    (3.9, 3.23): ("62", "622"),
    (3.7, 2.84): ("63", "623"),
    (3.6, 2.43): ("64",),
    (4.3, 4.63): ("160", "161"),
    (4.7, 6.50): ("618",),
    (4.3, 4.75): ("619",),
}


def test_every_series_of_balls_has_its_constants():
    """10⁷·R_1 and 10³·S_1 of SKF's catalogue, copied a second time from another public program that quotes it; at two
    loads, so that neither part hides the other."""
    for (R_1, S_1), series in CATALOGUE.items():
        parts = balls(R_1 * 1e-7, S_1 * 1e-3)
        for F in (50.0, 5000.0):
            found = [power(bearing(method="skf", series=x, count=1, lubrication="bath"), F) for x in series]
            expected = by_skf(F, 3000.0, 15.0, *parts, 3.1, 0.05)
            assert found == pytest.approx([expected] * len(series), rel=1e-9)
    assert {x for series in CATALOGUE.values() for x in series} == set(SKF_SERIES["deep-groove-ball"])


def test_a_design_may_give_the_series_whose_constants_are_known():
    for kind, series in SKF_SERIES.items():
        assert series == tuple(constants("skf")[b.ELEMENTS[kind]]["series"])


def test_mist_starves_twice_as_much_and_a_jet_as_a_bath():
    """φ_rs is a power of K_rs: 6·10⁻⁸ in mist, 3·10⁻⁸ else; at 1 N only rolling is left."""
    one = {way: bearing(method="skf", series="62", count=1, lubrication=way) for way in ("bath", "mist", "jet")}
    bath, mist, jet = (power(one[way], 1.0, nu=100.0) for way in one)
    starved = math.exp(-3e-8 * 100 * 3000 * (25 + 52) * math.sqrt(3.1 / (2 * (52 - 25))))
    assert jet == bath and mist / bath == pytest.approx(starved, rel=1e-3)


def test_balls_slide_more_easily_in_synthetic_oil():
    """0.04 for 0.05 on the full film; rollers are the same."""
    one = bearing(method="skf", series="62", count=1)
    roller = bearing(kind="cylindrical-roller", method="skf", series="4")
    mineral, synthetic = (b.power(one, 1e5, 50.0, 15e-6, base) for base in ("mineral", "PAO"))
    phi_bl = math.exp(-2.6e-8 * (3000 * 15) ** 1.4 * 38.5)
    less = 3.23e-3 * 38.5**-0.26 * 1e5 ** (5 / 3) * (1 - phi_bl) * 0.01
    assert mineral - synthetic == pytest.approx(less * 1e-3 * 100 * math.pi, rel=1e-6)
    assert b.power(roller, 1e5, 50.0, 15e-6, "PAO") == b.power(roller, 1e5, 50.0, 15e-6)


def test_a_6205_lies_between_the_rules_of_thumb():
    """0.5·μ·P·d with μ 0.0015 of SKF's catalogue is for a load of about C/10, 1.4 kN; the models are within a factor of
    two of it."""
    simple = 0.5 * 0.0015 * 1400 * 25e-3 * 3000 * math.pi / 30
    for one in (bearing(method="skf", series="62", count=1), bearing(count=1)):
        assert 0.5 < power(one, 1400.0) / simple < 2


@pytest.mark.parametrize(
    "series, R_1",
    [("22", 1.40e-6), ("4", 1.00e-6), ("10", 1.12e-6), ("2", 1.09e-6), ("3", 1.09e-6), ("23", 1.48e-6)],
)
def test_cylindrical_rollers_by_skf(series, R_1):
    """NU 2205, NU 405; the last four from memory."""
    one = bearing(kind="cylindrical-roller", method="skf", series=series, count=1, lubrication="bath")
    assert power(one, 2000.0) == pytest.approx(by_skf(2000.0, 3000.0, 15.0, *rollers(R_1, 0.0015), 5.1, 0.02), rel=1e-9)


@pytest.mark.parametrize(
    "kind, series",
    [
        ("deep-groove-ball", "99"),
        ("deep-groove-ball", None),
        ("cylindrical-roller", "62"),
        ("needle-roller", "62"),
        ("tapered-roller", "302"),
    ],
)
def test_a_series_without_constants_is_refused_with_those_that_are_known(kind, series):
    with pytest.raises(
        NoSolution,
        match=r"rolling bearing idler: SKF's model.*palmgren.*deep-groove-ball 2, 3,.*cylindrical-roller 4, 22",
    ) as caught:
        power(bearing(kind=kind, method="skf", series=series))
    assert (series or "not given") in str(caught.value)


@pytest.mark.parametrize(
    "said", [dict(), dict(method="skf", series="60"), dict(kind="cylindrical-roller", method="skf", series="4")]
)
def test_many_operating_points_are_the_single_ones(said):
    one, F, rpm, nu = (
        bearing(**said),
        np.array([0.0, 10.0, 1000.0]),
        np.array([100.0, 3000.0, 9000.0]),
        np.array([200.0, 15.0, 0.1]),
    )
    alone = [power(one, *point) for point in zip(F.tolist(), rpm.tolist(), nu.tolist())]
    assert power(one, F, rpm, nu) == pytest.approx(alone, rel=1e-12)


@given(F=st.floats(0, 1e5), rpm=st.floats(0.1, 2e4), nu=st.floats(1, 1e4), skf=st.booleans())
def test_losses_are_finite_positive_and_grow_with_the_load(F, rpm, nu, skf):
    one = bearing(method="skf", series="62") if skf else bearing()
    P = power(one, F, rpm, nu)
    assert math.isfinite(P) and P >= 0
    assert power(one, F * 1.5 + 1, rpm, nu) >= P
