# SPDX-License-Identifier: Apache-2.0
"""Times of sizing the counter-shaft:  python -m bench.sizing

Each line: the best of several rounds, and its ratio to np.exp of 100 000 numbers in the same run, which travels between
machines better than the time itself.  Budget: below 5 ms for a sizing by search."""

import math

import numpy as np

from bench.film import best
from calc.countershaft.sizing import lengths
from calc.countershaft.sizing.choices import front_curve
from calc.countershaft.sizing.sectors import TooSmall, pair, pair_masses, size

OMEGA, STEEL = 2 * math.pi * 2600 / 60, 7860.0
P = 572.932 / OMEGA**2 + 0j
COUNT = 10_000


def searched(force: complex, R: float) -> None:
    lengths.one.cache_clear()
    try:
        size(force, P, OMEGA, STEEL, R, 0.015, 0.152)
    except TooSmall:
        assert R < 0.0405


def main() -> None:
    exponents = np.random.default_rng(0).uniform(-1.0, 1.0, 100_000)
    radii = np.linspace(0.035, 0.05, COUNT)
    solids = {"steel": STEEL, "ADI": 7200.0}
    baseline = best(lambda: np.exp(exponents), 20)
    print(f"{'np.exp of 100 000 numbers (baseline)':52s}{baseline * 1e6:12.2f} µs")
    for title, seconds in (
        ("a pure couple, closed form", best(lambda: pair(572.932, OMEGA, STEEL, 0.043, 0.015, 0.152), 100)),
        ("a force as well, by search", best(lambda: searched(2e-3 + 1e-3j, 0.043), 20)),
        ("a force as well, envelope too small", best(lambda: searched(2e-3 + 1e-3j, 0.040), 5)),
        (
            f"pair_masses, per radius of {COUNT}",
            best(lambda: pair_masses(572.932, OMEGA, STEEL, radii, 0.015, 0.152), 2) / COUNT,
        ),
        (
            "front of two materials, pure couple",
            best(lambda: front_curve(0j, P, OMEGA, 0.043, 0.015, 0.152, solids), 10),
        ),
        (
            "front of two materials, a force as well",
            best(lambda: front_curve(2e-3 + 0j, P, OMEGA, 0.043, 0.015, 0.152, solids), 3),
        ),
    ):
        print(f"{title:52s}{seconds * 1e6:12.2f} µs   ratio {seconds / baseline:10.3f}")


if __name__ == "__main__":
    main()
