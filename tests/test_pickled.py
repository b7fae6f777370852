"""What a design gives goes to other processes and back: joblib, multiprocessing, a cache on disk."""

import pickle
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

import pytest

from calc import bearings, engine, friction, gears, imbalance, load_design, solve_design
from calc.solve import Results, solve
from tests.conftest import DESIGNS


@pytest.fixture(scope="module")
def pair_of_shafts() -> Results:
    return solve(load_design(DESIGNS / "r754ie4_balance_shafts.toml"))


def sent(x):
    return pickle.loads(pickle.dumps(x))


@pytest.mark.parametrize("step", ["engine", "imbalance", "countershaft", "bearings", "gears", "friction"])
def test_an_outcome_is_what_it_was(gamma_results, step):
    here = gamma_results.outcomes[step]
    there = sent(here)
    assert str(there) == str(here) and there.values() == here.values()
    assert [str(check) for check in there.checks] == [str(check) for check in here.checks]
    assert [(curve.id, len(curve.series)) for curve in there.curves] == [(c.id, len(c.series)) for c in here.curves]
    assert [line.formula for line in there.lines] == [line.formula for line in here.lines]
    assert [str(note) for note in there.notes] == [str(note) for note in here.notes]
    assert (there.further is None) == (here.further is None)


def test_what_takes_longer_can_still_be_made(gamma_results):
    here = gamma_results.outcomes["bearings"]
    there = sent(here)
    assert [curve.id for curve in there.whole.curves] == [curve.id for curve in here.whole.curves]
    assert len(there.whole.curves) > len(there.curves)


def test_results_are_what_they_were(pair_of_shafts):
    there = sent(pair_of_shafts)
    assert str(there) == str(pair_of_shafts)
    assert there.values() == pair_of_shafts.values()
    assert there.views.keys() == pair_of_shafts.views.keys()
    assert str(solve(there.design, before=there)) == str(there)


def test_results_of_the_steps_alone_are_sent():
    one = load_design(DESIGNS / "r753ie4_gamma.toml")
    pair = gears.solve_pair((32, 41), normal_module=2.25e-3, face_width=18e-3)
    film = bearings.solve_film(
        diameter=0.0595, length=0.0275, clearance=80e-6, load=1707, speed=43.33, oil="SAE 50", supply_temperature=100
    )
    loss = friction.solve_loss(pair, power=2000, speed=50, oil="SAE 50", temperature=90)
    for result in (engine.solve_engine(one.engine), imbalance.solve_imbalance(one.engine), pair, film, loss):
        assert str(sent(result)) == str(result)


@pytest.mark.slow
def test_processes_solve_designs():
    designs = [load_design(DESIGNS / f"r753ie4_{name}.toml") for name in ("alpha", "gamma")]
    with ProcessPoolExecutor(2, get_context("spawn")) as processes:
        there = list(processes.map(solve_design, designs))
    assert list(map(str, there)) == [str(solve_design(design)) for design in designs]
