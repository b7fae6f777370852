"""Move inputs of the shipped designs: an input that moves a value stands in the value's chain.

A fixed share of the inputs of every design; all of them: `python bench/provenance.py`.
"""

import importlib.util
from pathlib import Path

import pytest

from calc.studies.shipped import shipped_name
from tests.conftest import SHIPPED

ROOT = Path(__file__).parents[2]
SPEC = importlib.util.spec_from_file_location("provenance", ROOT / "bench" / "provenance.py")
assert SPEC is not None and SPEC.loader is not None
provenance = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(provenance)
# one input in so many; the primes share no table's period
EVERY = {"r753ie4_gamma": 17, "r753ie4_beta": 29, "r753ie4_sized": 31}


@pytest.mark.slow
@pytest.mark.parametrize("name", map(shipped_name, SHIPPED))
def test_an_input_that_moves_a_value_stands_in_its_chain(name):
    results, moves, chain, _ = provenance.compared(name, every=EVERY.get(name, 11))
    missing = {
        (id, key)
        for id in results.values()
        if not id.startswith("friction.scenarios.")
        for key in moves[id] - chain[id]
    }  # scenarios are many designs at once: explained by solving the one
    assert any(moves.values()) and not missing


@pytest.mark.parametrize(
    "key, value",
    [
        ("bearings.supply_pressure_bar", "bearings.front.film"),
        ("bearings.hole_diameter_mm", "bearings.rear.film_edge"),
        ("engine.bench.2.oil_pressure_bar", "bearings.front.thinnest_film"),
        ("gears.accuracy_grade", "gears.crank_central.bulk_temperature_flash"),
        ("shafts.shaft.core_radius_mm", "countershaft.slope_front"),
        ("bearings.supply_temperature_C", "friction.total_loss"),
    ],
)
def test_what_was_missing_behind_the_film(key, value):
    results = provenance.solve(provenance.design(provenance.read(provenance.DESIGNS / "r753ie4_gamma.toml")))
    assert key in {key for link in provenance.Chains(results).of(value) for key in link.inputs}
