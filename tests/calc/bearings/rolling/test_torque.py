# SPDX-License-Identifier: Apache-2.0
"""The torque of rolling bearings against the given values and against the catalogues' formulas in their own units."""

import math

import numpy as np
import pytest
from hypothesis import given as drawn
from hypothesis import strategies as st

from calc.bearings.rolling.torque import constants, friction_of
from tests.calc.bearings.rolling.typical import BEARINGS, given

POINT = 1700.0, 2600 / 60, 12e-6  # N, 1/s, m²/s


@pytest.mark.parametrize("row", given("torque"), ids=lambda row: row["case"])
def test_given_torques(row):
    said = row["inputs"]
    friction = BEARINGS[said["size"]].friction(lubrication=said["rolling_lubrication"])
    torque = friction.torque(said["load_N"], said["speed_rpm"] / 60, said["viscosity_mm2_s"] * 1e-6)
    assert torque * 1e3 == pytest.approx(row["is"], rel=row["rel"])


@pytest.mark.parametrize("size, rule", [("6205", 31.9), ("NU205", 23.4), ("HK2520", 53.1)])
def test_the_constant_coefficient_is_within_a_factor_of_two(size, rule):
    """The public rule M = μ·P·d/2, N·mm at 1700 N."""
    friction = BEARINGS[size].friction()
    assert friction.by_rule(1700.0) * 1e3 == pytest.approx(rule, abs=0.05)
    assert 0.5 < friction.torque(*POINT) / friction.by_rule(1700.0) < 2


def two_parts(f_0, f_1, d, D, F=1700.0, rpm=2600.0, nu=12.0):
    d_m = (d + D) / 2
    return f_0 * 1e-7 * (nu * rpm) ** (2 / 3) * d_m**3 + f_1 * F * d_m


# f_0 in mist and in oil, f_1 (of balls with F/C_0 = 0.2125), as INA prints them, written down a second time
INA = [
    ("ball", "60", 1.1, 1.7, 0.0007 * 0.2125**0.5), ("ball", "62", 1.3, 2.0, 0.0007 * 0.2125**0.5),
    ("ball", "63", 1.5, 2.3, 0.0007 * 0.2125**0.5), ("ball", "own", 1.3, 2.0, 0.0007 * 0.2125**0.5),
    ("roller", "10", 1.3, 2.0, 0.0002), ("roller", "2", 1.3, 2.0, 0.0003), ("roller", "3", 1.3, 2.0, 0.00035),
    ("roller", "22", 2.0, 3.0, 0.0004), ("roller", "23", 2.7, 4.0, 0.0004), ("roller", "own", 1.3, 2.0, 0.0003),
    ("needle", "NA49", 4.0, 5.5, 0.0005), ("needle", "RNA49", 4.0, 5.5, 0.0005),
    ("cup", "HK", 24 * 15 / 58, 36 * 15 / 58, 0.0005), ("cage", "K", 12 * 15 / 58, 18 * 15 / 58, 0.0005),
]  # fmt: skip


@pytest.mark.parametrize("type, series, mist, oil, f_1", INA)
def test_two_parts_of_every_series(type, series, mist, oil, f_1):
    for lubrication, f_0 in (("mist", mist), ("splash", oil), ("jet", oil), ("bath", oil)):
        friction = friction_of(type, series, 0.025, 0.052, 0.015, static_rating=8000.0, lubrication=lubrication)
        assert friction.by_two_parts(*POINT) * 1e3 == pytest.approx(two_parts(f_0, f_1, 25, 52), rel=1e-9)


def test_slow_or_thin_oil_counts_as_2000():
    friction = BEARINGS["NA4905"].friction()
    still, slow = (friction.torque(0.0, n, 12e-6) * 1e3 for n in (0.0, 100 / 60))
    assert still == slow == pytest.approx(5.5e-7 * 2000 ** (2 / 3) * 33.5**3)


def test_which_model_counts():
    judged = {size: BEARINGS[size].friction().judged for size in BEARINGS}
    assert {judged[size] for size in ("6205", "6305", "NU205")} == {"skf"}
    assert {judged[size] for size in ("NA4905", "HK2520", "K25x30x20")} == {"two_part"}
    assert friction_of("ball", "own", 0.025, 0.052, 0.015, static_rating=8e3).judged == "two_part"
    assert friction_of("roller", "own", 0.025, 0.052, 0.015).judged == "two_part"


@pytest.mark.parametrize("size", ["6205", "NU205"])
def test_in_a_bath_the_larger_counts(size):
    """SKF's drag is not in its torque: in thin oil the two parts are larger, under a large load SKF's."""
    friction = BEARINGS[size].friction(lubrication="bath")
    larger = set()
    for F, nu in ((1700.0, 12e-6), (10.0, 12e-6), (8000.0, 3e-6), (100.0, 300e-6)):
        both = friction.by_skf(F, 50.0, nu), friction.by_two_parts(F, 50.0, nu)
        assert friction.torque(F, 50.0, nu) == max(both)
        larger.add(both.index(max(both)))
    assert larger == {0, 1}
    splash = BEARINGS[size].friction()
    assert splash.torque(*POINT) == splash.by_skf(*POINT) == friction.by_skf(*POINT)


def test_given_factors_make_the_two_parts_count():
    usual = BEARINGS["NU205"].friction()
    both = BEARINGS["NU205"].friction(f_0=1.0, f_1=0.001)
    assert both.torque(*POINT) * 1e3 == pytest.approx(two_parts(1.0, 0.001, 25, 52))
    one = BEARINGS["NU205"].friction(f_0=1.0)
    assert one.torque(*POINT) * 1e3 == pytest.approx(two_parts(1.0, 0.0003, 25, 52)) != usual.torque(*POINT) * 1e3
    cup = BEARINGS["HK2520"].friction(f_0=3.0)  # as it is, not over its width
    assert cup.torque(*POINT) * 1e3 == pytest.approx(two_parts(3.0, 0.0005, 25, 32))
    no_rating = friction_of("ball", "62", 0.025, 0.052, 0.015, f_1=0.0003)
    assert no_rating.torque(*POINT) * 1e3 == pytest.approx(two_parts(2.0, 0.0003, 25, 52))


def test_balls_slide_more_easily_in_another_base_than_mineral():
    """μ_EHL 0.04 for 0.05 on the full film; rollers are the same."""
    mineral, other = (BEARINGS["6205"].friction(base=base).torque(*POINT) for base in ("mineral", "PAO"))
    phi_bl = math.exp(-2.6e-8 * (2600 * 12) ** 1.4 * 38.5)
    less = 3.23e-3 * 38.5**-0.26 * 1700 ** (5 / 3) * (1 - phi_bl) * 0.01
    assert (mineral - other) * 1e3 == pytest.approx(less, rel=1e-9)
    roller = BEARINGS["NU205"]
    assert roller.friction(base="PAO").torque(*POINT) == roller.friction().torque(*POINT)


def test_needles_by_palmgren_are_an_upper_bound():
    """f_0 12 and f_1 0.002 of the bearings of wheels."""
    friction = BEARINGS["NA4905"].friction()
    assert friction.by_palmgren(*POINT) * 1e3 == pytest.approx(two_parts(12.0, 0.002, 25, 42))
    assert friction.by_palmgren(*POINT) > 2 * friction.torque(*POINT)


def test_many_bearings_are_the_single_ones():
    series = ["10", "2", "3", "22", "23"]
    d, D = np.array([15, 20, 25, 40, 60]) / 1e3, np.array([32, 47, 62, 80, 130]) / 1e3
    F, n = np.array([[100.0], [2000.0]]), np.array([[15.0], [50.0]])
    for lubrication in ("splash", "bath"):
        many = friction_of("roller", series, d, D, 0.3 * d, lubrication=lubrication).torque(F, n, 12e-6)
        assert many.shape == (2, 5)
        for k, name in enumerate(series):
            one = friction_of("roller", name, *(x[k].item() for x in (d, D, 0.3 * d)), lubrication=lubrication)
            alone = [one.torque(F[row, 0].item(), n[row, 0].item(), 12e-6) for row in (0, 1)]
            assert many[:, k] == pytest.approx(alone, rel=1e-12)


@drawn(
    st.sampled_from(sorted(BEARINGS)), st.sampled_from(["splash", "mist", "bath"]), st.floats(0, 1e4),
    st.floats(0.1, 200), st.floats(1e-6, 1e-3),
)  # fmt: skip
def test_torques_are_finite_and_grow_with_the_load(size, lubrication, F, n, nu):
    friction = BEARINGS[size].friction(lubrication=lubrication)
    M = friction.torque(F, n, nu)
    assert (math.isfinite(M) and M > 0) or F == 0
    assert friction.torque(1.1 * F + 1, n, nu) > M


def test_every_constant_says_where_it_is_from():
    from calc.library.publications import resolved
    from calc.library.table_file import house_table

    for name in ("rolling_friction.toml", "rolling_fits.toml"):
        for title, section in house_table(name).items():
            rows = [section] if "source" in section else list(section.values())
            for row in rows:
                assert resolved(row["source"]).found and row["confidence"] in ("high", "medium", "low"), title
    assert constants("skf")["roller"]["series"]["22"] == [1.40e-6, 0.0015]
