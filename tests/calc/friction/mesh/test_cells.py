# SPDX-License-Identifier: Apache-2.0
"""Stretches of the path cut where the regime changes: shares right to the second order, sums that do not jump."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.friction.mesh.loss import case, solve_mesh
from calc.friction.mesh.path import path
from tests.calc.friction.pairs import friction, oil, r753, spur_pair

PAIRS = {"spur": spur_pair(), "helical": r753()["central_idler"]}


@pytest.mark.parametrize("name", PAIRS)
def test_the_stretches_fill_the_path(name):
    mesh = PAIRS[name]
    p = path(mesh)
    whole = np.asarray(p.cells.left + p.cells.right).reshape(-1, p.per_strip).sum(axis=1)
    assert whole == pytest.approx(p.C_E - p.C_A, rel=1e-12)
    assert np.min(p.cells.left) > -1e-18 and np.min(p.cells.right) > -1e-18


@settings(max_examples=40, deadline=None)
@given(st.floats(0.001, 0.999), st.sampled_from(sorted(PAIRS)))
def test_a_line_is_cut_where_it_crosses(where, name):
    p = path(PAIRS[name])
    x = np.asarray(p.x)
    cut = p.C_A + where * (p.C_E - p.C_A)
    share = p.cells.below_zero(x - cut)
    below = (share * (p.cells.left + p.cells.right)).reshape(-1, p.per_strip).sum(axis=1)
    assert below == pytest.approx(cut - p.C_A, abs=1e-12)
    assert ((share >= 0) & (share <= 1)).all()


def test_one_regime_everywhere_is_one_or_nothing():
    cells = path(spur_pair()).cells
    some = np.linspace(1.0, 2.0, cells.left.size)
    assert (cells.below_zero(-some) == 1.0).all() and (cells.below_zero(some) == 0.0).all()


@pytest.mark.parametrize(
    "name, T, n, powers", [("spur", 20.0, 90.0, (10e3, 18e3)), ("helical", 120.0, 30.0, (420.0, 620.0))]
)
def test_the_loss_does_not_jump_with_the_power(name, T, n, powers):
    """Between two powers one per cent apart no step of several per cent, and the default path is as good as a fine
    one."""
    o = oil("10W-40 Q8 T905", T)
    coarse = case(friction(), PAIRS[name], o, n)
    fine = (
        case(friction(), PAIRS[name], o, n, points=100)
        if name == "spur"
        else case(friction(), PAIRS[name], o, n, points=12, strips=31)
    )
    P = np.geomspace(*powers, 9)
    a, b, c = solve_mesh(coarse, P, True), solve_mesh(coarse, P * 1.0001, True), solve_mesh(fine, P, True)
    assert b.loss == pytest.approx(a.loss, rel=5e-3)
    assert a.loss == pytest.approx(c.loss, rel=2e-3)
    assert np.ptp(a.rigid_share) > 0  # the regime does change
