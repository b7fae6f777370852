"""The torque of the gas by order against the torque of the cycle, point by point."""

import numpy as np
import pytest

from calc.engine.gas_torque import basis, harmonics, nodes, orders_of
from calc.engine.torque import at, prepare
from tests.calc.engine.given_drive import cases, engine_of, row_of

GIVEN = cases("R753 rated, full load")[0]["given"]


@pytest.fixture(scope="module")
def engine():
    return engine_of(GIVEN, GIVEN["gas"])


def test_the_series_is_the_torque_of_the_cycle(engine):
    """All orders up to 60, with twice the mean as order 0, against the engine's own torque at every half degree: what
    is cut off shows where its bends are."""
    engine, e = engine
    n = np.append(0.0, orders_of(4, 60))
    there = nodes(engine, e, engine.gas, (), n)
    t = harmonics(engine, e, there, np.array([20.0]))[0]
    t[0] /= 2
    epsilon = np.radians(np.arange(0, 720, 0.5))
    exact = at(engine, e, prepare(engine, e, engine.gas), 0.0, epsilon)[0]
    series = (t * np.exp(1j * np.outer(epsilon, n))).sum(1).real
    assert np.abs(series - exact).max() < 0.02 * np.abs(exact).max()
    for order, phasor in zip(n, t):
        wave = np.mean(exact * np.exp(-1j * order * epsilon)) * (2 if order else 1)
        assert phasor == pytest.approx(wave, abs=2e-3 * np.abs(t).max())


def test_mean_is_the_indicated_work(engine):
    engine, e = engine
    there = nodes(engine, e, engine.gas, (), orders_of(4))
    mean = harmonics(engine, e, there, np.array([1.0]), mean=True)[0, 0].real / 2
    assert 3 * mean == pytest.approx(float(e.torque.mean_torque), rel=1e-6)


def test_many_speeds_are_those_of_each(engine):
    """Held angles that end between the samples as well: one sum over all of them is the sums of each."""
    engine, e = engine
    rows = [row_of(GIVEN["gas"] | {"held": held}, speed, 1) for held, speed in ((0.07, 15.0), (0.25, 43.0))]
    b = basis(engine, e, prepare(engine, e, engine.gas), orders_of(4))
    held = np.array([row.changes["constant_pressure_angle"] for row in rows] + [0.07, 0.1234567])
    together = b.parts(held)
    for i, angle in enumerate(held):
        assert together[i] == pytest.approx(b.parts(np.array([angle]))[0], rel=1e-12, abs=1e-15)
    assert together[0] == pytest.approx(together[2], rel=0, abs=0)
    whole = together[:, 0] + together[:, 1]
    assert np.abs(whole[0] - whole[1]).max() > 0  # a longer held peak is another torque


@pytest.mark.parametrize(("strokes", "first", "last"), [(4, 0.5, 24.0), (2, 1.0, 24.0)])
def test_orders(strokes, first, last):
    n = orders_of(strokes, 24)
    assert (n[0], n[-1], n.size) == (first, last, round(last / first))
