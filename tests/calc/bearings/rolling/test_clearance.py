# SPDX-License-Identifier: Apache-2.0
"""Fits and clearances of rolling bearings against the given values, against rings solved apart, and against limits."""

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given as drawn
from hypothesis import strategies as st

from calc.bearings.rolling import clearance as c
from calc.library.catalogue import shipped_materials
from calc.library.tolerances import deviations, parse
from tests.calc.bearings.rolling.typical import BEARINGS, given

ALUMINIUM = shipped_materials()["EN AC-43100"]
STEEL = shipped_materials()["steel"]
HOT = 127.6576  # °C, NU205 at the rated point


def metal(material):
    return dict(housing_expansion=material.expansion, housing_modulus=material.E, housing_poisson=material.poisson)


def mounting(size, fits=None, housing=ALUMINIUM, **more):
    """`fits`: what is said of them."""
    one = BEARINGS[size]
    sits = c.fits_of(one.type, one.d, one.D, **(fits or {}))
    return c.Mounting(type=one.type, bore=one.d, outside=one.D, fits=sits, **{**one.raceways, **metal(housing), **more})


def um(x):
    return x * 1e6


@pytest.mark.parametrize("row", given("clearance"), ids=lambda row: f"{row['case']} {row['value']}")
def test_given_clearances(row):
    said = row["inputs"]
    fits = {key: said[key] for key in ("clearance_class", "shaft_fit", "seat_fit") if said.get(key)}
    found = c.clearances(mounting(said["size"], fits), said["temperature_C"], lowest=-20.0)
    name = row["value"].removeprefix("clearance_").replace("cold", "frozen")
    assert um(getattr(found, name)) == pytest.approx(row["is"], rel=1e-5)


def test_the_defaults_of_a_nu205_and_a_6305():
    """C3, js6 and N7 in aluminium; the 6305 at 113 °C has nothing left hot, and neither when the shaft warms first."""
    nu205 = c.clearances(mounting("NU205"), HOT, lowest=-20.0)
    assert um(nu205.running) == pytest.approx(40.86915, abs=1e-4)
    assert um(nu205.grip_hot) == pytest.approx(-60.0, abs=0.05)
    assert um(nu205.start) == pytest.approx(-5.1, abs=0.05)
    assert um(nu205.grip_mounted) == pytest.approx(17.5)
    ball = c.clearances(mounting("6305"), 113.0, lowest=-20.0)
    assert um(ball.running) == pytest.approx(13.53502, abs=1e-4)
    assert (um(ball.start), um(ball.least)) == pytest.approx((-25.8, -2.8), abs=0.05)


def test_no_fit_of_a_ring_holds_in_hot_aluminium():
    """R7, 17 µm at least at 20 °C, is lost by 53 °C."""
    tight = mounting("NU205", dict(seat_fit="R7"))
    assert um(tight.grip(20.0)) == pytest.approx(17.0)
    assert tight.grip(52.0) > 0 > tight.grip(53.0)


# --- rings, solved apart: u = A·r + B/r in each, radial stress E/(1 − ν²)·(A·(1 + ν) − B·(1 − ν)/r²)


def pressed(rings, U):
    """Radial displacements u(r) of two rings pressed together with the diametral interference U; each: inner and outer
    radius, E, ν; an inner radius of 0 is a solid shaft."""
    rows, right = [], []

    def stress(k, r, E, nu):
        row = np.zeros(4)
        row[2 * k : 2 * k + 2] = E / (1 - nu**2) * (1 + nu), -E / (1 - nu**2) * (1 - nu) / r**2
        return row

    def moved(k, r):
        row = np.zeros(4)
        row[2 * k : 2 * k + 2] = r, 1 / r
        return row

    (a, b, *inner), (_, d, *outer) = rings
    rows += [stress(0, a, *inner) if a else np.array([0.0, 1.0, 0.0, 0.0]), stress(1, d, *outer)]
    rows += [stress(0, b, *inner) - stress(1, b, *outer), moved(1, b) - moved(0, b)]
    scale = np.array([1 / inner[0], 1 / outer[0], 1 / inner[0], 1.0])
    if not a:
        scale[0] = 1.0
    right = np.array([0.0, 0.0, 0.0, U / 2])
    A = np.linalg.solve(np.array(rows) * scale[:, None], right)
    return lambda k, r: A[2 * k] * r + A[2 * k + 1] / r


RING = (c.RING_MODULUS, c.RING_POISSON)


@pytest.mark.parametrize("hollow", [0.0, 0.3, 0.8])
def test_the_inner_ring_grows_as_two_rings_do(hollow):
    d, d_F, U = 0.025, 0.0315, 12e-6
    u = pressed([(hollow * d / 2, d / 2, *RING), (d / 2, d_F / 2, *RING)], U)
    assert c.inner_ring_growth(U=U, d=d, d_F=d_F, d_b=hollow * d) == pytest.approx(2 * u(1, d_F / 2), rel=1e-9)


@pytest.mark.parametrize("wall", [1.2, 2.0, 10.0])
def test_the_outer_ring_closes_as_two_rings_do(wall):
    D, d_E, U = 0.052, 0.0464, 20e-6
    u = pressed([(d_E / 2, D / 2, *RING), (D / 2, wall * D / 2, ALUMINIUM.E, ALUMINIUM.poisson)], U)
    p = c.seat_pressure(U=U, D=D, d_E=d_E, D_h=wall * D, E_H=ALUMINIUM.E, nu_H=ALUMINIUM.poisson)
    assert c.outer_ring_closing(p=p, d_E=d_E, D=D) == pytest.approx(-2 * u(0, d_E / 2), rel=1e-9)


def test_limits_of_the_rings():
    """A solid shaft: d/d_F of the interference; steel in endless steel: d_E/D of it; play leaves both as they are."""
    assert c.inner_ring_growth(U=10e-6, d=0.025, d_F=0.0315, d_b=0.0) == pytest.approx(10e-6 * 25 / 31.5)
    p = c.seat_pressure(U=10e-6, D=0.052, d_E=0.0464, D_h=52.0, E_H=c.RING_MODULUS, nu_H=c.RING_POISSON)
    assert c.outer_ring_closing(p=p, d_E=0.0464, D=0.052) == pytest.approx(10e-6 * 46.4 / 52, rel=1e-5)
    assert c.inner_ring_growth(U=-5e-6, d=0.025, d_F=0.0315, d_b=0.01) == 0.0
    assert c.seat_pressure(U=-5e-6, D=0.052, d_E=0.0464, D_h=0.1, E_H=ALUMINIUM.E, nu_H=0.33) == 0.0


def test_the_rings_are_the_steel_of_the_materials():
    assert (c.RING_EXPANSION, c.RING_MODULUS, c.RING_POISSON) == (STEEL.expansion, STEEL.E, STEEL.poisson)


# --- what is around a bearing


def test_an_insert_holds_hot_as_it_does_cold():
    seat = c.metal_of_seat(ALUMINIUM, "insert")
    assert seat == STEEL and c.metal_of_seat(ALUMINIUM, "pin") == ALUMINIUM
    held = c.clearances(mounting("NU205", housing=seat), HOT, lowest=-20.0)
    assert um(held.grip_hot) == pytest.approx(-4.0)  # N7 may be a play of 4 µm, at any temperature
    held = c.clearances(mounting("NU205", dict(seat_fit="P7"), housing=seat), HOT, lowest=-20.0)
    assert um(held.grip_hot) == pytest.approx(8.0)
    rings_warm = um(c.RING_EXPANSION * 5 * BEARINGS["NU205"].raceways["outer_raceway"])
    assert um(held.frozen - held.start) == pytest.approx(rings_warm)


def test_a_housing_that_is_held_back_grips_like_an_insert():
    held = mounting("NU205", restraint=1.0)
    assert held.grip(HOT) == pytest.approx(held.grip(20.0))
    half = mounting("NU205", restraint=0.5)
    assert um(half.grip(HOT)) == pytest.approx(-4 - 0.5 * 10e-3 * 52 * (HOT - 20))


def test_a_thin_housing_presses_less():
    room = [mounting("NU205", housing_outer=D_h).clearance(20.0) for D_h in (0.056, 0.07, 0.104, 1.0)]
    assert room == sorted(room, reverse=True) and room[2] == mounting("NU205").clearance(20.0)


@pytest.mark.parametrize("size", ["NU205", "6205", "NA4905"])
def test_a_tighter_shaft_leaves_less(size):
    fields = ["g6", "h6", "js6", "j6", "k6", "m6", "n6", "p6", "r6"]
    for place in ("middle", "least"):
        left = [mounting(size, dict(shaft_fit=word)).clearance(100.0, place=place) for word in fields]
        assert all(more >= less for more, less in pairwise(left)) and left[2] > left[-1]
    d_F = BEARINGS[size].raceways["inner_raceway"]
    least = [mounting(size, dict(shaft_fit=word)).clearance(100.0, place="least") for word in ("k6", "r6")]
    assert um(least[0] - least[1]) == pytest.approx((41 - 15) * 25e-3 / d_F)  # +15 and +41 µm at 25 mm


def test_a_hollow_shaft_gives_way():
    left = [mounting("NU205", dict(shaft_fit="n6"), shaft_bore=d_b).clearance(80.0) for d_b in (0.0, 0.01, 0.02)]
    assert left == sorted(left) and left[0] < left[2]


def test_a_journal_of_another_material():
    """It grips the inner ring more as it warms; where elements roll on it, it takes the clearance itself."""
    alpha_J = 21.5e-6
    rings = mounting("NU205", journal_expansion=alpha_J)
    more = rings.interference_on_shaft(100.0) - mounting("NU205").interference_on_shaft(100.0)
    assert um(more) == pytest.approx(10e-6 * 25e3 * 80)
    for size in ("HK2520", "K25x30x20"):
        less = mounting(size).clearance(100.0) - mounting(size, journal_expansion=alpha_J).clearance(100.0)
        assert um(less) == pytest.approx(10e-6 * 25e3 * 80)


# --- what has no ring


def test_a_bearing_without_an_inner_ring_by_hand():
    """RNA4905: F6 of 20 to 33 µm, h5 of −9 to 0 on 30 mm; hot the seat is open, cold it presses."""
    one = BEARINGS["NA4905"]
    fits = c.fits_of("needle", 0.030, one.D, inner_ring=False)
    rna = c.Mounting(type="needle", bore=0.030, outside=one.D, fits=fits, **one.raceways, **metal(ALUMINIUM))
    assert rna.interference_on_shaft(20.0) is None
    found = c.clearances(rna, 100.0, lowest=-20.0)
    assert um(found.running) == pytest.approx(26.5 + 4.5 - 11.5e-3 * 5 * 36)
    assert um(found.most) == pytest.approx(33 + 9 - 11.5e-3 * 5 * 36)
    U = 33 + 10e-3 * 42 * 40  # N7 of 42 mm at its lower end against 0, and what −20 °C adds
    p = c.seat_pressure(U=U / 1e6, D=0.042, d_E=0.036, D_h=0.084, E_H=ALUMINIUM.E, nu_H=ALUMINIUM.poisson)
    assert um(found.frozen) == pytest.approx(20 - um(c.outer_ring_closing(p=p, d_E=0.036, D=0.042)))


def test_a_cup_follows_its_housing_and_is_judged_by_its_grip():
    cup = c.clearances(mounting("HK2520"), 110.0, lowest=-20.0)
    assert um(cup.grip_hot) == pytest.approx(-11 + 8 - 10e-3 * 32 * 90)  # N7 −33 … −8, outside −11 … 0
    assert um(cup.grip_mounted) == pytest.approx(20.5 - 5.5)
    held = mounting("HK2520", restraint=1.0)
    assert held.clearance(110.0) == pytest.approx(held.clearance(20.0))


def test_a_cage_has_no_seat():
    cage = c.clearances(mounting("K25x30x20"), 110.0, lowest=-20.0)
    assert cage.grip_hot is cage.grip_mounted is cage.grip_scale is None
    assert um(cage.least) == pytest.approx(7 - 11.5e-3 * 5 * 30)
    for word, bore in (("j5", 5), ("h5", 0), ("g6", -7)):  # upper end of the shaft; small, normal, large
        tight = mounting("K25x30x20", dict(shaft_fit=word))
        assert um(tight.clearance(20.0, 0.0, "least")) == pytest.approx(7 - bore)


# --- tables

# As makers print ISO 5753 (tables of radial internal clearance on their public pages), a second time: by the largest bore
# in mm least and most of CN, C3, C4 and C5 in µm.
FREE = {
    "ball": {
        18: (3, 18, 11, 25, 18, 33, 25, 45), 24: (5, 20, 13, 28, 20, 36, 28, 48), 30: (5, 20, 13, 28, 23, 41, 30, 53),
        40: (6, 20, 15, 33, 28, 46, 40, 64), 50: (6, 23, 18, 36, 30, 51, 45, 73), 65: (8, 28, 23, 43, 38, 61, 55, 90),
    },
    "roller": {
        24: (20, 45, 35, 60, 50, 75, 65, 90), 30: (20, 45, 35, 60, 50, 75, 70, 95),
        40: (25, 50, 45, 70, 60, 85, 80, 105), 50: (30, 60, 50, 80, 70, 100, 95, 125),
        65: (40, 70, 60, 90, 80, 110, 110, 140),
    },
}  # fmt: skip


@pytest.mark.parametrize("elements, d", [(elements, d) for elements, rows in FREE.items() for d in rows])
def test_clearances_before_mounting(elements, d):
    """At the upper end of a range, and where it begins."""
    ends = [10, *FREE[elements]]
    for bore in (d / 1e3, ends[ends.index(d) - 1] / 1e3 + 1e-6):
        spans = [c.free_clearance(elements, word, bore) for word in c.CLASSES]
        assert [um(x) for span in spans for x in span] == pytest.approx(FREE[elements][d])


@pytest.mark.parametrize("elements", ["ball", "roller"])
@pytest.mark.parametrize("d", [0.012, 0.02, 0.028, 0.04, 0.05, 0.065])
def test_classes_rise(elements, d):
    spans = [c.free_clearance(elements, word, d) for word in c.CLASSES]
    for (low, high), (lower, higher) in pairwise(spans):
        assert low < lower <= high < higher


def test_outside_the_table_a_clearance_is_not_known():
    for d in (0.009, 0.0651):
        fits = c.fits_of("ball", d, 2 * d)
        assert fits.free is None
        unknown = c.Mounting(
            type="ball", bore=d, outside=2 * d, inner_raceway=1.3 * d, outer_raceway=1.7 * d, fits=fits,
            **metal(ALUMINIUM),
        )  # fmt: skip
        found = c.clearances(unknown, 100.0, lowest=-20.0)
        assert found.running is found.scale is None and math.isfinite(found.grip_hot)
    assert c.fits_of("ball", 0.009, 0.02, clearance=(5e-6, 9e-6)).free == (5e-6, 9e-6)


def test_given_clearance_replaces_the_class():
    fits = dict(clearance=(10e-6, 20e-6))
    assert um(mounting("NU205", fits).clearance(HOT)) == pytest.approx(40.86915 - 47.5 + 15, abs=1e-4)


def test_rings_of_class_normal():
    assert [um(c.ring_limits("bore", d / 1e3)[0]) for d in (15, 18, 25, 50, 60, 100)] == pytest.approx(
        [-8, -8, -10, -12, -15, -20]
    )
    assert [um(c.ring_limits("outside", d / 1e3)[0]) for d in (18, 28, 42, 52, 110, 130, 160)] == pytest.approx(
        [-8, -9, -11, -13, -15, -18, -25]
    )


@pytest.mark.parametrize(
    "said", [dict(shaft_fit="K6"), dict(seat_fit="js6"), dict(seat_fit="IT7"), dict(seat_fit="P8")]
)
def test_words_that_are_no_class_are_refused(said):
    with pytest.raises(ValueError, match=r"allowed: a (shaft|hole)'s class"):
        c.fits_of("ball", 0.025, 0.052, **said)


def test_many_bearings_are_the_single_ones():
    d, D = np.array([15.0, 25.0, 30.0, 60.0, 70.0]) / 1e3, np.array([35.0, 52.0, 62.0, 110.0, 125.0]) / 1e3
    raceways = dict(inner_raceway=d + 0.3 * (D - d), outer_raceway=D - 0.2 * (D - d))
    T = np.array([100.0, 110.0, 120.0, 130.0, 140.0])
    for type in ("ball", "roller", "cup", "cage"):
        for said in (dict(), dict(shaft_fit="k6", seat_fit="R7"), dict(shaft_fit="r6", seat_fit="K7")):
            many = c.clearances(
                c.Mounting(
                    type=type, bore=d, outside=D, fits=c.fits_of(type, d, D, **said), **raceways, **metal(STEEL)
                ),
                T,
                lowest=-20.0,
            )
            for k in range(d.size):
                one = {name: x[k].item() for name, x in dict(bore=d, outside=D, **raceways).items()}
                fits = c.fits_of(type, one["bore"], one["outside"], **said)
                alone = c.clearances(c.Mounting(type=type, fits=fits, **one, **metal(STEEL)), T[k].item(), lowest=-20.0)
                for name, number in vars(alone).items():
                    several = vars(many)[name]
                    if number is None:
                        assert several is None or np.isnan(several[k])
                    else:
                        assert several[k] == pytest.approx(number, abs=1e-15)


@drawn(
    st.sampled_from([("k6", "shaft in a ring"), ("r6", "shaft in a ring"), ("N7", "hole for a ring"), ("C9", "hole")]),
    st.floats(0.0011, 0.5),
)
def test_limits_of_many_are_those_of_one(said, d):
    low, high = c.limits(parse(*said), np.array([d, 0.025]))
    assert (low[0], high[0]) == deviations(parse(*said), d) == c.limits(parse(*said), d)


@drawn(
    st.sampled_from(sorted(BEARINGS)), st.floats(-40, 180), st.floats(0, 20),
    st.sampled_from(["h6", "js6", "k6", "m6", "r6"]), st.sampled_from(["H7", "K7", "N7", "R7"]),
)  # fmt: skip
def test_the_middle_lies_between(size, T, rise, shaft_fit, seat_fit):
    sits = mounting(size, dict(shaft_fit=shaft_fit, seat_fit=seat_fit))
    least, middle, most = (sits.clearance(T, rise, place) for place in ("least", "middle", "most"))
    assert least < middle < most
    if BEARINGS[size].type != "cage":
        loosest, tightest = sits.grip(T), sits.grip(T, "least")
        assert loosest < sits.grip(T, "middle") < tightest


def test_scales_are_never_nought():
    found = c.clearances(mounting("6205", dict(seat_fit="H7", clearance=(0.0, 0.0), shaft_fit="h6")), 20.0, lowest=20.0)
    assert found.grip_mounted < 0 and found.grip_scale == 1e-6 and found.scale >= 1e-6
    usual = c.clearances(mounting("NU205"), HOT, lowest=-20.0)
    assert (um(usual.scale), um(usual.grip_scale)) == pytest.approx((um(usual.mounted), 17.5))
