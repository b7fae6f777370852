"""What a drill takes: against given values, by a quadrature of its own, and its inverse."""

import json
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from calc.countershaft.balancing.hole import (
    bottom_radius,
    cone_length,
    depth_for,
    hole_mass,
    hole_unbalance,
    least_depth,
    mean_surface,
)
from tests.conftest import ROOT

GIVEN = json.loads((ROOT / "tests" / "reference" / "balancing.json").read_text(encoding="utf-8"))["given"]
HOLES = [row for row in GIVEN if row["quantity"].startswith("hole:")]


def drilled(a, R, h, theta, rho=7860.0):
    """Mass and unbalance."""
    l, q = cone_length(a=a, theta=theta), bottom_radius(R=R, h=h)
    mass = hole_mass(rho=rho, a=a, R_m=mean_surface(R=R, a=a), q=q, l=l)
    return mass, hole_unbalance(rho=rho, a=a, R=R, q=q, l=l)


@pytest.mark.parametrize("row", HOLES, ids=lambda row: f"{row['quantity']} {row['case']['depth_mm']}")
def test_given_holes(row):
    case, what = row["case"], row["quantity"]
    a, R, theta = case["diameter_mm"] / 2e3, case["outer_radius_mm"] / 1e3, math.radians(case["point_deg"])
    mass, unbalance = drilled(a, R, case["depth_mm"] / 1e3, theta, case["density_kgm3"])
    if "depth for" in what:
        U = float(what.split()[3]) * 1e-6
        found = depth_for(U=U, rho=case["density_kgm3"], a=a, R=R, l=cone_length(a=a, theta=theta)) * 1e3
    else:
        found = mass * 1e3 if "mass" in what else unbalance * 1e6
    assert found == pytest.approx(row["is"], rel=row["rel"])


SIZES = st.tuples(st.floats(0.002, 0.02), st.floats(1.2, 8.0), st.floats(0.05, 0.9), st.floats(60.0, 180.0))


def of(size):
    """Radius of the drill, outer radius, depth and point angle of a hole whose cone ends before the axis."""
    a, times, share, point = size
    R, theta = a * times, math.radians(point)
    least, most = least_depth(R=R, a=a), R - cone_length(a=a, theta=theta)
    return (a, R, least + share * (most - least), theta) if most > least else None


@given(SIZES)
def test_the_inverse_gives_the_depth_back(size):
    hole = of(size)
    if hole is not None:
        a, R, h, theta = hole
        U = drilled(a, R, h, theta)[1]
        assert depth_for(U=U, rho=7860.0, a=a, R=R, l=cone_length(a=a, theta=theta)) == pytest.approx(h, rel=1e-10)


@pytest.mark.parametrize("point", [90.0, 118.0, 180.0])
def test_a_quadrature_over_the_drill_gives_the_same(point):
    """On each ring of the drill the metal reaches from its cone to the surface, both without the formula."""
    a, R, h, theta = 0.006, 0.020, 0.008, math.radians(point)
    nodes, weights = np.polynomial.legendre.leggauss(40)
    r, w = a * (nodes + 1) / 2, a * weights / 2
    turns = np.linspace(0, 2 * np.pi, 200, endpoint=False)
    y = r[:, None] * np.sin(turns)
    top = np.sqrt(R**2 - y**2)
    low = (R - h - (a - r) / math.tan(theta / 2))[:, None]
    mass, unbalance = (
        7860.0 * float(np.sum(w[:, None] * r[:, None] * part) * 2 * np.pi / turns.size)
        for part in (top - low, (top**2 - low**2) / 2)
    )
    assert drilled(a, R, h, theta) == (pytest.approx(mass, rel=1e-12), pytest.approx(unbalance, rel=1e-12))
