# SPDX-License-Identifier: Apache-2.0
"""Times of the gear step:  python -m bench.gears

Geometry and rating of the whole train, one tooth and all teeth of a wheel, its drawing file, and ten thousand
combinations of profile shifts and tip cuts at once against one after the other, against np.exp of 100 000 numbers in
the same run."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from assistant.exports.kinds import Request
from bench.film import best
from calc.design.toml_file import design, read
from calc.gears import solve as gears
from calc.gears.profile.outline import repeated, tooth
from calc.gears.selection.free_shifts import freedoms
from calc.gears.selection.search import search
from calc.gears.selection.states import USUAL, judge, states
from calc.gears.train import settle, tooth_system
from calc.library.catalogue import materials
from calc.sheet.search import least
from calc.solve import solve

DESIGN = Path(__file__).parents[1] / "designs" / "r753ie4_gamma.toml"
MANY, FEW = 10_000, 100
TORQUE = 5.0  # N·m at the first driver; its value does not matter to the time


def main() -> None:
    document = read(DESIGN)
    made = design(document)
    results = solve(made)
    assert made.gears is not None and made.engine is not None
    train, speed, known = made.gears, made.engine.rated_speed, materials()
    system, solved = tooth_system(train), gears.geometry(train, made.engine.rated_speed).result
    wheel = solved.wheels["idler"]
    way = freedoms(train, system)[0]
    random = np.random.default_rng(0)
    shifts = way.shifts({"central": random.uniform(-0.3, 0.4, MANY)})
    cuts = {"idler": random.uniform(0.0, 0.4e-3, MANY)}

    def combinations() -> None:
        least(judge(states(system, train, shifts, cuts), system, USUAL))

    def one_by_one() -> None:
        for i in range(FEW):
            wheels = (
                replace(w, profile_shift=float(shifts["central"][i]))
                if w.name == "central"
                else replace(w, tip_shortening=float(cuts["idler"][i]))
                if w.name == "idler"
                else w
                for w in train.wheels
            )
            gears.geometry(replace(train, wheels=tuple(wheels)), speed)

    exponents = random.uniform(-1.0, 1.0, 100_000)
    baseline = best(lambda: np.exp(exponents), 20)
    loop = best(one_by_one, 1, 3) / FEW
    vectorised = best(combinations, 1) / MANY
    rows = (
        ("shifts and distances of the train", best(lambda: settle(train, system), 100)),
        ("geometry of the train", best(lambda: gears.geometry(train, speed), 20)),
        ("rating of the train", best(lambda: gears.rating(train, solved, TORQUE, known), 20)),
        ("all teeth of a wheel", best(lambda: repeated(tooth(system, wheel), wheel.teeth), 20)),
        (
            "its drawing file",
            best(lambda: made(Request(Path("idler.dxf"), document, results, {"gear": "idler"})), 1, 3),
        ),
        (f"{MANY} combinations of shifts and cuts, judged, all", vectorised * MANY),
        ("the same, per combination", vectorised),
        ("one after the other, per combination", loop),
        ("the whole search for shifts", best(lambda: search(train), 1, 3)),
    )
    print(f"{'np.exp of 100 000 numbers (baseline)':66s}{baseline * 1e6:12.1f} µs")
    for title, seconds in rows:
        print(f"{title:66s}{seconds * 1e6:12.1f} µs{seconds / baseline:12.3f}")
    print(f"{'one after the other over all at once':66s}{loop / vectorised:12.1f} ×")


if __name__ == "__main__":
    main()
