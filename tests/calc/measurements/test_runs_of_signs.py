"""The mean and the spread of the runs of signs, counted out over all orders of them."""

from itertools import combinations, pairwise

import numpy as np
import pytest

from calc.measurements.residuals import runs_expected, runs_spread


@pytest.mark.parametrize(("plus", "minus"), [(3, 4), (5, 5), (2, 6)])
def test_runs_are_counted_out(plus, minus):
    n, counts = plus + minus, []
    for chosen in combinations(range(n), plus):
        signs = [i in chosen for i in range(n)]
        counts.append(1 + sum(a != b for a, b in pairwise(signs)))
    mu = runs_expected(p=plus, m=minus)
    assert mu == pytest.approx(np.mean(counts)) and runs_spread(mu=mu, n=n) == pytest.approx(np.std(counts))
