# SPDX-License-Identifier: Apache-2.0
"""Many shafts by chance at once against one by one:  python -m bench.scatter

The scatter of 10 000 counter-shafts with four calibration holes: one call on arrays, and a plain loop over a part of
the same shafts, in Python's own numbers, with the same search for the depths of the holes.  The ratio travels between
machines better than the times."""

import cmath
import math
import time
from random import Random

import numpy as np

from calc.countershaft.inputs import EccentricMass, Holes, Scatter
from calc.countershaft.making import scatter as sc
from calc.countershaft.making.unbalance import calibration, permitted

COUNT, LOOPED = 10_000, 1_000
OMEGA = 2 * math.pi * 2600 / 60
COUPLE = 572.932 * cmath.exp(1j * math.pi / 6)
PLANES = (-0.1675, 0.1675)
MASSES = (
    EccentricMass(name="front", mass=2.730, radius=0.018676, angle=7 * math.pi / 6, z=-0.077671),
    EccentricMass(name="rear", mass=2.727, radius=0.018731, angle=math.pi / 6, z=0.075968),
)  # Finotti 2013, Table 4.1, heavier by half of what the holes take
SCATTER = Scatter(mass=0.010, radius=1e-4, angle=math.radians(0.2), z=2e-4, timing=math.radians(0.3), shafts=COUNT)


def looped(luck: np.ndarray, timing: np.ndarray, per: tuple[float, float], most: float) -> tuple[float, float]:
    """What one shaft leaves over as made and after drilling; `luck`: its random numbers."""
    (z_f, z_r), squared = PLANES, OMEGA**2
    force = couple = 0j
    for i, mass in enumerate(MASSES):
        m, e = mass.mass + SCATTER.mass * float(luck[0, i]), mass.radius + SCATTER.radius * float(luck[1, i])
        U = m * e * cmath.exp(1j * (mass.angle + SCATTER.angle * float(luck[2, i])))
        force += squared * U
        couple += squared * U * (mass.z + SCATTER.z * float(luck[3, i]))
    rear = (couple - COUPLE - z_f * force) / (z_r - z_f)
    left = [(force - rear) / per[0] / squared, rear / per[1] / squared]
    turn = cmath.exp(1j * SCATTER.timing * float(timing))
    made = abs(couple * turn - COUPLE)
    if max(abs(a) for a in left) <= 1:
        return made, made
    lowest, x, best = max(abs(a) for a in left), [0.0] * len(MASSES), [0.0] * len(MASSES)
    span = z_r - z_f
    unit = [[(z_r - mass.z) / span / per[0], (mass.z - z_f) / span / per[1]] for mass in MASSES]
    toward = [[u * cmath.exp(1j * mass.angle) for u in pair] for mass, pair in zip(MASSES, unit)]
    weight, step = 0.5, 0.25
    for sweep in range(2 * sc.SWEEPS):
        shares = weight, 1 - weight
        for i in range(len(MASSES)):
            wanted = sum(w * (a * b.conjugate()).real for w, a, b in zip(shares, left, toward[i]))
            new = min(max(x[i] + wanted / sum(w * abs(b) ** 2 for w, b in zip(shares, toward[i])), 0.0), most)
            left = [a - (new - x[i]) * b for a, b in zip(left, toward[i])]
            x[i] = new
        if sweep >= sc.SWEEPS - 1:
            front, back = abs(left[0]), abs(left[1])
            if max(front, back) < lowest:
                lowest, best = max(front, back), list(x)
            weight, step = weight + math.copysign(step, front - back), step / 2
    taken = squared * sum(t * mass.z * cmath.exp(1j * mass.angle) for t, mass in zip(best, MASSES))
    return made, abs((couple - taken) * turn - COUPLE)


def main() -> None:
    steel = permitted("G6.3", 8.914, OMEGA, 0.0, *PLANES, abs(COUPLE))
    per = steel.residual_unbalance_permitted_front, steel.residual_unbalance_permitted_rear
    z = np.array([mass.z for mass in MASSES])
    holes = calibration(Holes(diameter=0.014, depth=0.020, count=4), 7860.0, 0.040, z, OMEGA, abs(COUPLE))
    target = sc.Target(
        omega=OMEGA,
        couple=COUPLE,
        force=0j,
        couple_left=0.0,
        z_f=PLANES[0],
        z_r=PLANES[1],
        permitted_front=per[0],
        permitted_rear=per[1],
    )
    times = []
    for _ in range(15):
        start = time.perf_counter()
        together = sc.scattered(SCATTER, MASSES, (), target, holes)
        times.append(time.perf_counter() - start)
    random = Random(SCATTER.seed)
    luck, delta = sc.normal(random, 4, sc.BLOCK, len(MASSES)), sc.normal(random, sc.BLOCK)  # of the first block
    start = time.perf_counter()
    alone = [looped(luck[:, i], delta[i], per, holes.hole_unbalance_of_mass) for i in range(LOOPED)]
    loop = (time.perf_counter() - start) / LOOPED * COUNT
    assert together.drilled is not None
    worst = max(  # each shaft of the loop is one of the call
        float(np.abs(ordered - one).min())
        for made, after in alone
        for ordered, one in ((together.residual, made), (together.drilled, after))
    )
    print(f"{COUNT} shafts in one call: {min(times) * 1e3:.1f} ms (median {sorted(times)[7] * 1e3:.1f} ms)")
    print(f"{COUNT} shafts in a plain loop: {loop:.2f} s (from {LOOPED})")
    print(f"ratio loop / call: {loop / min(times):.0f}; largest difference of what is left over: {worst:.1e} N·m")


if __name__ == "__main__":
    main()
