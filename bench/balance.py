# SPDX-License-Identifier: Apache-2.0
"""Many engines at once against one by one:  python -m bench.balance

The imbalance of 10 000 engines of different mass, speed, crank radius and crank angles: one call on arrays, and the
plain loop over a part of them.  The ratio travels between machines better than the times."""

import time
from dataclasses import replace
from typing import Any

import numpy as np

from calc.design.toml_file import design, read
from calc.engine import solve as engine
from calc.engine.inputs import EngineInputs
from calc.imbalance import solve as imbalance
from calc.imbalance.inputs import ImbalanceInputs
from calc.studies.shipped import EXAMPLE

COUNT, LOOPED = 10_000, 300


def solved(inputs: EngineInputs, crank: ImbalanceInputs) -> imbalance.ImbalanceResult:
    return imbalance.values(crank, inputs, engine.values(inputs))


def main() -> None:
    one = design(read(EXAMPLE))
    assert one.engine is not None and one.imbalance is not None
    crank = replace(one.imbalance, crank_bodies=())
    random = np.random.default_rng(0)
    angles = np.column_stack([np.zeros(COUNT), random.uniform(0, 2 * np.pi, (COUNT, one.engine.cylinders - 1))])
    varied: dict[str, Any] = {
        "piston_mass": random.uniform(0.3, 2.0, COUNT),
        "rated_speed": random.uniform(15, 100, COUNT),
        "crank_radius": random.uniform(0.03, 0.055, COUNT),
        "crank_angles": angles,
    }
    many = replace(one.engine, **varied)
    singles = []
    for i in range(LOOPED):
        own: dict[str, Any] = {k: tuple(x[i]) if x.ndim > 1 else x[i].item() for k, x in varied.items()}
        singles.append(replace(one.engine, **own))

    times = []
    for _ in range(5):
        start = time.perf_counter()
        together: Any = solved(many, crank)
        times.append(time.perf_counter() - start)
    start = time.perf_counter()
    alone = [solved(inputs, crank) for inputs in singles]
    loop = (time.perf_counter() - start) / LOOPED * COUNT
    worst = max(abs(together.required_couple[i] - a.required_couple) / a.one_couple for i, a in enumerate(alone))
    print(f"{COUNT} engines in one call: {min(times):.3f} s (median {sorted(times)[2]:.3f} s)")
    print(f"{COUNT} engines in a plain loop: {loop:.1f} s (from {LOOPED})")
    print(f"ratio loop / call: {loop / min(times):.0f}; largest difference of the couples, over m·r·ω²·a: {worst:.1e}")


if __name__ == "__main__":
    main()
