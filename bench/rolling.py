# SPDX-License-Identifier: Apache-2.0
"""Times of rolling bearings:  python -m bench.rolling

Two shafts with four rolling bearings over a duty of six rows: the bearing step with its lines, then the heat balance
and the clearances of 400 sizes at once; in processor time of the best of many runs, against np.exp of 100 000 numbers
in the same run."""

from typing import Any

import numpy as np

from bench.film import best
from calc.bearings.rolling.balance import heat_balance, heat_conductance, heat_surface
from calc.bearings.rolling.geometry import alike, inside_of, stacked
from calc.bearings.rolling.ratings import computed
from calc.bearings.rolling.sizes import every_size
from calc.bearings.rolling.torque import friction_of
from calc.design.toml_file import Document, design
from calc.library.catalogue import oils
from calc.library.lubricant import Lubricant
from calc.solve import solve

SIZES = {"left": ("6305", "NU205"), "right": ("NJ2304", "HK3020")}
DUTY = [(900, 20, 80), (1400, 15, 90), (1800, 20, 95), (2200, 30, 105), (2500, 10, 112), (2600, 5, 115)]


def of_two_shafts() -> Document:
    shafts = [
        {
            "name": name,
            "mode": "bearings",
            "speed_ratio": 1.0,
            "bearings": [
                {"name": row, "position_mm": z, "kind": "rolling", "size": size, "load_N": 1700.0}
                | {"standing_load_N": 80.0, "slope_mrad": 0.1}
                for row, z, size in zip(("front", "rear"), (-150.0, 150.0), sizes)
            ],
        }
        for name, sizes in SIZES.items()
    ]
    duty = [
        {"name": f"row-{n}", "speed_rpm": float(speed), "hours": float(hours), "oil_temperature_C": float(oil)}
        for n, (speed, hours, oil) in enumerate(DUTY)
    ]
    bearings = {"oil": "10W-40", "supply_temperature_C": 110.0, "housing_material": "steel", "duty": duty}
    bearings |= {"journal_material": "steel", "speed_rpm": 2600.0}
    return Document({"schema": 2, "name": "four rolling", "shafts": shafts, "bearings": bearings}, "four.toml")


def main() -> None:
    four = design(of_two_shafts())
    lubricant = Lubricant(oils()["10W-40"])
    groups = [stacked(group) for group in alike(every_size())]
    speeds: Any = np.array([2600.0 / 60])

    def grid() -> None:
        for size in groups:
            ratings = computed(inside_of(size), size.usual.rating)
            friction = friction_of(
                size.type, size.series, size.bore, size.outside, size.width, static_rating=ratings.static
            )
            conductance = heat_conductance(A=heat_surface(B=size.width, d=size.bore, D=size.outside))
            heat_balance(friction, 1700.0, speeds, 110.0, conductance, lubricant.nu, outside="nan")

    exponents = np.random.default_rng(0).uniform(-1.0, 1.0, 100_000)
    baseline = best(lambda: np.exp(exponents), 20)
    rows = (
        ("whole design: four rolling bearings, six rows of duty", best(lambda: solve(four), 3)),
        (f"ratings and heat balance of {len(every_size())} sizes at once", best(grid, 3)),
    )
    print(f"{'np.exp of 100 000 numbers (baseline)':66s}{baseline * 1e6:12.1f} µs")
    for title, seconds in rows:
        print(f"{title:66s}{seconds * 1e6:12.1f} µs{seconds / baseline:12.3f}")


if __name__ == "__main__":
    main()
