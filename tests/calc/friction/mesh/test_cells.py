# SPDX-License-Identifier: Apache-2.0
"""Stretches of the path cut where the regime changes: shares right to the second order, sums that do not jump."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.friction.mesh.loss import case, solve_mesh
from calc.friction.mesh.path import cells, path
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


def measured(x, width, value, points):
    """The share of every stretch below 0, of a line through the positions of its own piece, carried on to its ends;
    measured at many places."""
    shares = []
    for first in range(0, len(x), points):
        here, there = x[first : first + points], value[first : first + points]
        ends = here.mean() - width[first : first + points].sum() / 2 + np.cumsum([0, *width[first : first + points]])
        for a, b in pairwise(ends):
            places = np.linspace(a, b, 20_001)
            cell = np.clip(np.searchsorted(here, places) - 1, 0, points - 2)
            slope = np.diff(there) / np.diff(here)
            shares.append(np.mean(there[cell] + slope[cell] * (places - here[cell]) < 0))
    return shares


@pytest.mark.parametrize("seed", range(12))
def test_any_numbers_are_cut_as_lines_between_the_positions_of_a_piece(seed):
    """Two pieces of four positions each, between which the number jumps; the mark at the end stands for nothing."""
    random = np.random.default_rng(seed)
    nodes, weights = np.polynomial.legendre.leggauss(4)
    x, width = np.concatenate((nodes, 3 + 2 * nodes)), np.concatenate((weights, 2 * weights))
    value = random.uniform(-1, 1, 8)
    cut = cells(np.append(x, 5.0)[None, :], width[None, :], 4, 1)
    found = cut.below_zero(np.append(value, 7.0))
    assert found[:-1] == pytest.approx(measured(x, width, value, 4), abs=2e-4) and found[-1] == 0.0
    assert cut.below_zero(np.append(value, -7.0))[-1] == 1.0


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
