# SPDX-License-Identifier: Apache-2.0
"""Times of the oil film:  python -m bench.film

Each line: the best of several rounds, and its ratio to np.exp of 100 000 numbers in the same run, which travels between
machines better than the time itself."""

import itertools
import math
import time
from collections.abc import Callable

import numpy as np

from calc.bearings.plain.film import short_bearing
from calc.bearings.plain.film import table as film_nodes
from calc.bearings.plain.film.dynamics import coefficients
from calc.bearings.plain.film.reynolds import radial_damping, solve_film
from calc.bearings.plain.film.table import eccentricity_from, film_at

POINTS = 20_000


def best(task: Callable[[], object], repeats: int, rounds: int = 7) -> float:
    """Seconds of one call, the best round."""
    times = []
    for _ in range(rounds):
        start = time.perf_counter()
        for _ in range(repeats):
            task()
        times.append((time.perf_counter() - start) / repeats)
    return min(times)


def load() -> None:
    film_nodes.film_nodes.cache_clear()
    film_nodes.film_nodes()


def main() -> None:
    random = np.random.default_rng(0)
    eccentricities = np.tanh(random.uniform(math.atanh(0.021), math.atanh(0.979), POINTS))
    lengths = np.exp(random.uniform(math.log(0.11), math.log(1.9), POINTS))
    numbers = film_at(eccentricities, lengths).sommerfeld
    fresh = (0.4 + 1e-7 * count for count in itertools.count())  # a length never seen before
    exponents = random.uniform(-1.0, 1.0, 100_000)
    solve_film(0.5, 0.5)  # loads scipy

    baseline = best(lambda: np.exp(exponents), 20)
    print(f"{'np.exp of 100 000 numbers (baseline)':52s}{baseline * 1e6:12.2f} µs")
    for title, seconds in (
        ("direct solution, ε 0.1, l/d 0.5", best(lambda: solve_film(0.1, 0.5), 10)),
        ("direct solution, ε 0.75, l/d 0.4622", best(lambda: solve_film(0.75, 0.4622), 10)),
        ("direct solution, ε 0.98, l/d 2", best(lambda: solve_film(0.98, 2.0), 10)),
        ("direct solution, ε 0.75, infinite length", best(lambda: solve_film(0.75, math.inf), 10)),
        ("radial damping, direct, ε 0.75, l/d 0.4622", best(lambda: radial_damping(0.75, 0.4622), 10)),
        ("table loaded", best(load, 10)),
        ("film_at, one point, l/d as before", best(lambda: film_at(0.75, 0.4622), 1000)),
        ("film_at, one point, new l/d", best(lambda: film_at(0.75, next(fresh)), 1000)),
        ("eccentricity_from, one point, l/d as before", best(lambda: eccentricity_from(0.1588, 0.4622), 1000)),
        ("eccentricity_from, one point, new l/d", best(lambda: eccentricity_from(0.1588, next(fresh)), 1000)),
        ("eight coefficients, one point", best(lambda: coefficients(0.75, 0.4622), 200)),
        ("short bearing: eccentricity, one point", best(lambda: short_bearing.eccentricity(S=0.1588, b=0.4622), 1000)),
        (
            "short bearing: blocked arc, one point",
            best(lambda: short_bearing.blocked_arc(eps=0.74, p_s=4e5, p_max=6e6), 200),
        ),
        (f"eight coefficients, per point of {POINTS}", best(lambda: coefficients(eccentricities, lengths), 2) / POINTS),
        (f"film_at, per point of {POINTS}", best(lambda: film_at(eccentricities, lengths), 2) / POINTS),
        (f"eccentricity_from, per point of {POINTS}", best(lambda: eccentricity_from(numbers, lengths), 2) / POINTS),
    ):
        print(f"{title:52s}{seconds * 1e6:12.2f} µs{seconds / baseline:12.4f}")


if __name__ == "__main__":
    main()
