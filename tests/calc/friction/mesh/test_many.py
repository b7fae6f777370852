# SPDX-License-Identifier: Apache-2.0
"""Ten thousand operating points in one call: the single ones, however they are cut."""

import numpy as np
import pytest

from calc.friction.mesh import loss as many
from calc.friction.mesh.film import oil_at
from calc.friction.mesh.loss import case, solve_mesh
from calc.friction.mesh.path import path
from calc.sheet.errors import NoSolution
from tests.calc.friction.pairs import friction, lubricant, r753, spur_pair

MESHES = {"spur": spur_pair(), "helical": r753()["central_idler"]}
P, N, T = np.geomspace(5.0, 2e4, 23), np.linspace(5.0, 90.0, 23), np.linspace(120.0, 20.0, 23)
NUMBERS = (
    "loss",
    "sliding_loss",
    "friction_mean",
    "film_min",
    "temperature_max",
    "pressure_max",
    "lambda_min",
    "rigid_share",
    "deborah_max",
)


@pytest.mark.parametrize("at_once", [500, 7, 23])
@pytest.mark.parametrize("kind", MESHES)
@pytest.mark.parametrize("by_regime", [True, False])
def test_they_are_the_single_ones(kind, at_once, by_regime, monkeypatch):
    monkeypatch.setattr(many, "AT_ONCE", at_once)
    mesh, said = MESHES[kind], friction(load_sharing="smooth")
    found = many.losses(said, mesh, lubricant(), T, N, P, by_regime=by_regime)
    points = many.SPUR_POINTS if mesh.spur else many.HELICAL_POINTS
    for i in range(0, 23, 4):
        c = case(said, mesh, oil_at(lubricant(), float(T[i])), float(N[i]), points=points, strips=many.STRIPS)
        alone = solve_mesh(c, float(P[i]), by_regime)
        for name in (*NUMBERS, "rolling_loss"):
            assert np.broadcast_to(getattr(found, name), 23)[i] == pytest.approx(getattr(alone, name), rel=1e-9), name
        assert found.local.T_f[i] == pytest.approx(alone.local.T_f, rel=1e-9)
    assert np.shape(found.loss) == (23,)


@pytest.mark.parametrize("kind, tolerance", [("spur", 2e-6), ("helical", 1e-2)])
def test_the_coarse_path_is_as_good_as_it_says(kind, tolerance):
    """With one film everywhere; where the regime changes on the path its place is only known to a position."""
    mesh, fine = MESHES[kind], {"points": 60 if kind == "spur" else 4, "strips": 41}
    coarse, fine = (
        many.losses(friction(), mesh, lubricant(), T, N, P, by_regime=False, **more).loss for more in ({}, fine)
    )
    assert coarse == pytest.approx(fine, rel=tolerance)


def test_how_coarse_the_path_of_many_points_is():
    """12 Gauss points on each piece of a spur path; 2 on those of 5 strips of a helical one."""
    spur, helical = (many.losses(friction(), mesh, lubricant(), 60.0, 25.0, 100.0).local.x for mesh in MESHES.values())
    assert spur.size == 4 * 12 + 5
    strip = path(MESHES["helical"], points=2, strips=5)
    assert helical == pytest.approx(strip.in_the_middle(strip.x))


@pytest.mark.parametrize("T, liquid", [(-61.0, False), (-59.0, True), (399.0, True), (401.0, False), (np.nan, False)])
def test_the_oil_of_many_points_is_liquid(T, liquid):
    try:
        many.losses(friction(), MESHES["spur"], lubricant(), T, 25.0, 100.0)
        refused = ""
    except NoSolution as none:
        refused = str(none)
    assert ("a temperature of a liquid oil is needed" in refused) == (not liquid)


def test_a_point_that_fails_is_counted_from_where_its_part_begins():
    """500 are solved at once."""
    P = np.full(502, 100.0)
    P[501] = 1e12
    with pytest.raises(NoSolution, match=r"operating point 1.*\(counted from operating point 500\)"):
        many.losses(friction(), MESHES["spur"], lubricant(), 60.0, 25.0, P, points=1)


def test_numbers_and_arrays_mix():
    found = many.losses(friction(), MESHES["spur"], lubricant(), 60.0, 25.0, P)
    assert np.shape(found.loss) == (23,)
    one = many.losses(friction(), MESHES["spur"], lubricant(), 60.0, 25.0, float(P[3]))
    assert np.ravel(one.loss)[0] == pytest.approx(found.loss[3], rel=1e-9)


@pytest.mark.parametrize(
    "said", [{"P": np.array([10.0, np.nan])}, {"N": np.array([0.0, 10.0])}, {"P": np.array([10.0, -1.0])}]
)
def test_a_number_without_meaning_is_refused(said):
    with pytest.raises(NoSolution, match=r"mesh pinion–gear: (power|speed|force)"):
        many.losses(friction(), MESHES["spur"], lubricant(), 60.0, said.get("N", 25.0), said.get("P", 100.0))
