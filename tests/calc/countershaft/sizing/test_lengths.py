"""The lengths of least mass: against plain grids, the closed form, and their own neighbourhood."""

import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from calc.countershaft.sizing import lengths
from calc.countershaft.sizing.sectors import pair_masses


def random_tasks(count, seed):
    """Unbalance and product over what the envelope can do, complex; some with hardly a force, some with hardly a
    couple."""
    random = np.random.default_rng(seed)
    a = random.uniform(0, 2.2, count) * np.exp(2j * np.pi * random.uniform(0, 1, count))
    p = random.uniform(0, 1.3, count) * np.exp(2j * np.pi * random.uniform(0, 1, count))
    a[: count // 5] *= 1e-2
    p[count // 5 : 2 * count // 5] *= 1e-2
    a[count // 2 :: 4] = abs(a[count // 2 :: 4])  # force and couple in one plane
    p[count // 2 :: 4] = p[count // 2 :: 4].real
    return a, p


def searched(alpha, product, steps=300):
    """Least mass (Σ β·γ) and least largest sin γ over a plain grid of both lengths, straight from the two
    equilibria."""
    grid = np.linspace(1 / steps, 1, steps)
    f, r = grid[:, None], grid[None, :]
    z_f, z_r = f / 2 - 1, 1 - r / 2
    U_r = (product - z_f * alpha) / (z_r - z_f)
    U_f = alpha - U_r
    s_f, s_r = abs(U_f) / f, abs(U_r) / r
    worst = np.maximum(s_f, s_r)
    with np.errstate(invalid="ignore"):
        return np.where(worst <= 1, f * np.arcsin(s_f) + r * np.arcsin(s_r), np.inf).min(), worst.min()


def test_the_search_is_the_least_of_a_grid_over_both_lengths():
    """90 tasks: never heavier than the grid's best and within what the grid resolves; those that no grid point serves
    are refused."""
    alpha, product = random_tasks(90, 1)
    front, rear, u = lengths.lengths(alpha, product)
    mass = lengths.amount(lengths.task(alpha, product), front, rear)
    refused = 0
    for i in range(90):
        least, worst = searched(alpha[i], product[i])
        assert u[i] <= worst * (1 + 1e-12)  # nothing serves that is refused
        if u[i] > 1:
            assert math.isinf(least) and math.isnan(front[i])
            refused += 1
        elif worst <= 0.98:  # nearer to the limit the grid itself is too coarse
            assert mass[i] <= least * (1 + 1e-12) and mass[i] == pytest.approx(least, rel=1e-3)
        else:
            assert mass[i] <= least * (1 + 1e-12) and math.isfinite(mass[i])
    assert 18 < refused < 72


def test_the_search_finds_the_closed_form():
    """Without a force, to 1e-8 in mass, up to 1e-6 below the limit."""
    for u in (1e-4, 0.01, 0.2, 0.5, 0.8, 0.95, 0.999, 1 - 1e-6):
        front, rear, found = lengths.lengths(0.0, u)
        mass = lengths.amount(lengths.task(0.0, u), front, rear)
        exact = pair_masses(u, 1.0, 1.0, 1.5 ** (1 / 3), 0.0, 1.0) / 1.5 ** (2 / 3)  # k = 1
        assert found[0] == pytest.approx(u, rel=1e-12)
        assert mass[0] == pytest.approx(exact, rel=1e-8)


@settings(derandomize=True, max_examples=60, deadline=None)
@given(st.complex_numbers(max_magnitude=1.8), st.complex_numbers(max_magnitude=1.0))
def test_no_neighbour_is_lighter(alpha, product):
    """Least to a millionth, where sectors in two planes make a kink: also against the best of fine steps around the
    lengths found."""
    assume(abs(alpha) + abs(product) > 1e-3)
    front, rear, u = lengths.lengths(alpha, product)
    assume(u[0] <= 1)
    asked = lengths.task(alpha, product)
    mass = lengths.amount(asked, front, rear)[0]
    assert math.isfinite(mass)
    for width in (1e-1, 1e-2, 1e-3, 1e-4):
        steps = np.linspace(-width, width, 41)
        f, r = np.clip(front[0] + steps[:, None], 0, 1)[None], np.clip(rear[0] + steps[None, :], 0, 1)[None]
        f, r = np.broadcast_arrays(f, r)
        assert lengths.amount(asked, f, r).min() >= mass * (1 - 1e-6) - 1e-15


@pytest.mark.parametrize(
    "alpha, product",
    [
        (0.30679948576902455, 0.19702688854535458),
        (0.05572625775767707, 0.05015363198190936),
        (0.04229308463868905, 0.03811367206288815),
        (-0.46152792829343003 - 0.005569833892390687j, -0.23078076807026965),
        (0.0078125, 0.0078125),
    ],
)
def test_of_two_minima_the_lower_is_taken(alpha, product):
    """One sector does almost everything; short or of full length, the other one makes a minimum of its own."""
    front, rear, _ = lengths.lengths(alpha, product)
    asked = lengths.task(alpha, product)
    grid = np.unique([*np.geomspace(1e-4, 1, 400), *np.linspace(0.01, 1, 400)])
    f, r = np.broadcast_arrays(grid[None, :, None], grid[None, None, :])
    assert lengths.amount(asked, front, rear)[0] <= lengths.amount(asked, f, r).min() * (1 + 1e-8)
