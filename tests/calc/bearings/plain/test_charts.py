# SPDX-License-Identifier: Apache-2.0
"""The charts of the literature: what they draw is what the bearing has, and the band is the published one."""

from dataclasses import replace

import numpy as np
import pytest

from calc.bearings.plain.film.table import film_at, share_of_largest_load, share_of_least_friction
from calc.bearings.plain.routes.routes import own_warm
from calc.bearings.plain.routes.thermal_balance import balanced
from calc.design.toml_file import design, read
from calc.sheet.number import short
from calc.solve import solve
from calc.studies.shipped import DESIGNS


@pytest.fixture(scope="module")
def gamma():
    return solve(design(read(DESIGNS / "r753ie4_gamma.toml")))


@pytest.fixture(scope="module")
def drawn(gamma):
    return {
        curve.id: {str(s.label): (s.x, s.y) for s in curve.series} for curve in gamma.outcomes["bearings"].whole.curves
    }


@pytest.mark.parametrize("length_ratio, load, friction", [(1.0, 0.53, 0.30), (0.5, 0.43, 0.12), (0.25, 0.27, 0.03)])
def test_the_band_is_that_of_the_chart_of_1958(length_ratio, load, friction):
    """Read from the chart in Shigley, from memory: to ±0.04."""
    assert share_of_largest_load(b=length_ratio) == pytest.approx(load, abs=0.04)
    assert share_of_least_friction(b=length_ratio) == pytest.approx(friction, abs=0.04)


@pytest.mark.parametrize("length_ratio", [0.3, 0.46, 1.0])
def test_the_largest_load_is_larger_than_at_any_other_clearance(length_ratio):
    """With the smallest film held, c = h_0/(1 − ε): no other eccentricity carries more."""
    best = 1 - share_of_largest_load(b=length_ratio)

    def load(eps):
        return (1 - eps) ** 2 / film_at(eps, length_ratio).sommerfeld

    assert all(load(best) > load(best + off) for off in (-0.1, -0.02, 0.02, 0.1))


@pytest.mark.parametrize("place", ["front", "rear"])
def test_every_chart_passes_through_the_design(gamma, drawn, place):
    values = gamma.values()

    def v(name):
        return values[f"bearings.{place}.{name}"].shown

    angle, pressure = drawn[f"pressure_around_{place}"]["as designed"]
    assert pressure.max() == pytest.approx(v("film_pressure_max"), rel=3e-3) and 0 < angle[pressure.argmax()] < v(
        "attitude_angle"
    )
    for x, name in (("clearance_effects", v("clearance")), ("length_effects", v("length_ratio"))):
        for label, (at, share) in drawn[f"{x}_{place}"].items():
            assert np.interp(name, at, share) == pytest.approx(1.0, abs=0.02), (x, label)
    S, share = drawn[f"raimondi_boyd_chart_{place}"]["as designed"]
    assert 10 ** S[0] == pytest.approx(v("sommerfeld")) and share[0] == pytest.approx(1 - v("eccentricity"))
    for name in ("friction", "flow", "side_flow_ratio", "pressure_ratio"):
        (at,), (y,) = drawn[f"raimondi_boyd_{name}_{place}"]["as designed"]
        x, line = drawn[f"raimondi_boyd_{name}_{place}"][f"l/d = {short(v('length_ratio'))}"]
        assert 10**at == pytest.approx(v("sommerfeld")) and np.interp(at, x[::-1], line[::-1]) == pytest.approx(
            y, rel=1e-2
        ), name
    duty, friction = drawn[f"stribeck_{place}"]["full film"]
    assert np.interp(v("mckee_number"), duty[::-1], friction[::-1]) == pytest.approx(
        v("friction_coefficient"), rel=5e-3
    )


@pytest.mark.parametrize("place", ["front", "rear"])
def test_pressure_along_falls_to_nothing_at_the_edges(gamma, drawn, place):
    whole, parted = (drawn[f"pressure_along_{place}"][name] for name in ("as designed", "parted by a groove around"))
    length = gamma.outcomes["bearings"].result.bearings[place].seat.bearing.length * 1e3
    for z, p in (whole, parted):
        assert z[0] == pytest.approx(-length / 2) and z[-1] == pytest.approx(length / 2) and p[0] == p[-1] == 0
    assert whole[1].max() == pytest.approx(gamma.values()[f"bearings.{place}.film_pressure_max"].shown, rel=3e-3)
    assert (
        np.interp(0.0, *whole) == whole[1].max()
        and np.interp(0.0, *parted) == pytest.approx(0, abs=1e-9)
        and parted[1].max() > whole[1].max()
    )


@pytest.mark.parametrize("place", ["front", "rear"])
def test_a_sloping_journal_has_its_peak_off_the_middle(gamma, drawn, place):
    """With the slope of the design, under the same load."""
    (label, (z, p)), whole = (
        list(drawn[f"pressure_along_{place}"].items())[1],
        drawn[f"pressure_along_{place}"]["as designed"],
    )
    r = gamma.outcomes["bearings"].result.bearings[place]
    assert f"{(r.film - r.film_edge) * 2 / r.seat.bearing.length * 1e3:.2f}" in label
    assert whole[1].max() < p.max() < 1.1 * whole[1].max() and z[p.argmax()] > 1 and p[0] == p[-1] == 0
    assert np.trapezoid(p, z) == pytest.approx(np.trapezoid(*whole[::-1]), rel=0.03)


def test_a_bearing_with_a_groove_is_drawn_as_its_two_lands():
    grooved = solve(
        design(
            read(DESIGNS / "r753ie4_gamma.toml")
            .with_value("bearings.supply", "groove")
            .with_value("bearings.groove_width_mm", 4.0)
        )
    )
    curve = next(c for c in grooved.outcomes["bearings"].whole.curves if c.id == "pressure_along_rear")
    z, p = curve.series[0].x, curve.series[0].y
    length = grooved.outcomes["bearings"].result.bearings["rear"].seat.bearing.length * 1e3
    assert (
        len(curve.series) == 1
        and (z[0], z[-1]) == pytest.approx((-length / 2, length / 2))
        and p[abs(z) < 2.001].max() == 0
    )


@pytest.mark.parametrize("place", ["front", "rear"])
def test_the_load_that_a_length_bears_leaves_the_film_of_the_limit(gamma, drawn, place):
    """Solved anew under that load, the film at the edge is Kreisle's; with the slope it is less than parallel, the more
    the longer: up to l/d = 2, where the seat that slopes bears less than a shorter one (Finotti 2013, Fig. 5.15)."""
    parallel, sloping = list(drawn[f"allowable_load_{place}"].values())[:2]
    assert (np.diff(parallel[1]) > 0).all() and (np.diff(sloping[1] / parallel[1]) < 0).all()
    assert parallel[0][-1] == pytest.approx(2.0) and sloping[1].argmax() < len(sloping[1]) - 1
    r = gamma.outcomes["bearings"].result.bearings[place]
    p = np.interp(r.length_ratio, *sloping) * 1e6
    load = float(p * r.seat.bearing.diameter * r.seat.bearing.length)
    there = balanced(own_warm, r.seat, replace(r.duty, load=load))
    assert there.film - (r.film - r.film_edge) == pytest.approx(r.kreisle_film, rel=0.01)


def test_pressure_carries_the_load_in_the_middle_plane_of_a_long_bearing(gamma, drawn):
    """Around the middle plane the pressure pushes along the load: its sideways part is the smaller one."""
    angle, pressure = drawn["pressure_around_front"]["as designed"]
    step = np.gradient(np.radians(angle))
    along, aside = (np.sum(pressure * f(np.radians(angle)) * step) for f in (np.cos, np.sin))
    assert along > 3 * abs(aside) > 0


def test_the_oil_of_the_design_is_among_the_oils(gamma, drawn):
    T, lg = next(iter(drawn["viscosity_of_oils"].values()))
    assert 10 ** np.interp(40.0, T, lg) == pytest.approx(95.7, rel=1e-6) and "5W-30" in drawn["viscosity_of_oils"]


def test_a_check_says_where_the_film_lies_in_the_band(gamma):
    values, found = gamma.values(), next(c for c in gamma.checks() if c.id == "bearings.front.film_band")
    low, high = (values[f"bearings.front.film_share_{end}"].shown for end in ("least_friction", "largest_load"))
    share = 1 - values["bearings.front.eccentricity"].shown
    assert found.kind == "advice" and found.verdict == "pass" and found.limit == (0.0, 100.0)
    assert found.value == pytest.approx(100 * (share - low) / (high - low)) == pytest.approx(6.6, abs=0.1)
