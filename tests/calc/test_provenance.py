"""Move inputs of the shipped designs: an input that moves a value stands in the value's chain.

A fixed share of the inputs of every design; all of them: `python bench/provenance.py`.
"""

import importlib.util
from pathlib import Path

import pytest
import tomli_w

from calc.studies.shipped import shipped_name
from tests.calc.bearings.plain.test_seat_inputs import document
from tests.conftest import SHIPPED

ROOT = Path(__file__).parents[2]
SPEC = importlib.util.spec_from_file_location("provenance", ROOT / "bench" / "provenance.py")
assert SPEC is not None and SPEC.loader is not None
provenance = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(provenance)
# a bearing in the housing itself, by its limits
OWN = {"seat": "direct", "journal_mm": [27.98, 28.0], "bore_mm": [28.03, 28.05]}
# one input in so many; the primes share no table's period
EVERY = {"r753ie4_gamma": 17, "r753ie4_beta": 29, "r753ie4_sized": 31}


@pytest.mark.slow
@pytest.mark.parametrize("name", [shipped_name(path) for path in SHIPPED])
def test_an_input_that_moves_a_value_stands_in_its_chain(name):
    results, moves, chain, _ = provenance.compared(name, every=EVERY.get(name, 11))
    missing = {
        (id, key)
        for id in results.values()
        if not id.startswith("friction.scenarios.")
        for key in moves[id] - chain[id]
    }  # scenarios are many designs at once: explained by solving the one
    assert any(moves.values()) and not missing


@pytest.mark.slow
@pytest.mark.parametrize(
    "seats",
    [
        {},  # shells by classes, a bush by its limits, both with the interference that holds them
        {
            "front": {"crush_um": [30, 45], "crush_load_N": 3000.0, "housing_outer_mm": 60.0},
            "housing_temperature_C": 99.0,
        },
        {
            "rear": {"interference_um": [30, 45], "housing_outer_mm": 66.0, "retained": "pin"},
            "expansion_restraint": 0.1,
        },
        {"rear": {"bore": "finished", "finished_mm": [30.0, 30.02]}, "select": False, "front": OWN},
    ],
)
def test_what_moves_a_seat_stands_in_its_chain(seats, tmp_path):
    (tmp_path / "seats.toml").write_text(tomli_w.dumps(document(**seats).data), encoding="utf-8")
    results, moves, chain, _ = provenance.compared(str(tmp_path / "seats"), every=2)
    assert {(id, key) for id in results.values() for key in moves[id] - chain[id]} == set()


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
