# SPDX-License-Identifier: Apache-2.0
"""The figures of solved friction: along the path, over λ, and of the oil."""

import numpy as np
import pytest

from calc.friction.mesh.loss import Local
from calc.friction.mesh.mixed import BOUNDARY, MIXED, regimes
from tests.calc.friction.pairs import closed, r753

TRAIN = closed()


def test_curves_run_along_the_path():
    curves = {c.id: c for c in TRAIN.curves}
    of_a_mesh = ("friction", "film", "heat", "temperature", "deborah", "stribeck")
    assert {"losses", "shear", *(f"{mesh}.{name}" for mesh in r753() for name in of_a_mesh)} <= curves.keys()
    for curve in curves.values():
        for series in curve.series:
            assert np.isfinite(series.x).all() and np.isfinite(series.y).all()
            assert (np.diff(series.x) >= 0).all()
    assert curves["idler_shaft.film"].limits[0][1] == pytest.approx(0.8 * 2**0.5)
    assert 10 ** curves["idler_shaft.deborah"].series[0].y.max() == pytest.approx(
        TRAIN.result.meshes["idler_shaft"].judged.deborah_max, rel=0.1
    )
    line, own = curves["idler_shaft.stribeck"].series
    assert np.interp(own.x, line.x, line.y) == pytest.approx(own.y, rel=0.01)
    assert line.y[0] == pytest.approx(BOUNDARY, rel=0.1) and 10 ** line.x[0] < MIXED[0] and line.y[-1] < 0.2 * BOUNDARY


def test_film_and_friction_are_drawn_where_a_twentieth_of_the_load_is_carried():
    """Pressure goes with the root of the load: √0.049 and √0.05 of the largest."""
    column = np.array([1.0, 2.0, 3.0])
    same = dict.fromkeys(("x", "lam", "xi", "mu", "q", "T_f", "w", "V_s", "b_H", "De"), column)
    local = Local(p_H=8e8 * np.sqrt([0.049, 0.05, 1.0]), h=column, **same)
    for name in ("h", "lam", "mu"):
        assert local.drawn(name) == pytest.approx([np.nan, 2.0, 3.0], nan_ok=True)
    assert local.drawn("q") == pytest.approx(column)


def test_the_shear_that_an_oil_bears():
    """Both models meet at no pressure, 2·Λ/α; under pressure the judged one has a smaller α.  Warmer oil bears more
    before it thins."""
    limit, *judged = next(c for c in TRAIN.curves if c.id == "shear").series
    source = next(c for c in closed(film="source").curves if c.id == "shear").series[1:]
    assert limit.y == pytest.approx(0.047 * limit.x * 1e3)
    for one, other in zip(judged, source):
        assert np.ptp(other.y) == 0 and np.all(np.diff(one.y) > 0) and 1 < one.y[0] / other.y[0] < 1.3
    assert judged[0].y[0] < judged[1].y[0] < judged[2].y[0]


@pytest.mark.parametrize(
    "lam, said",
    [
        ((0.1, 0.29), "boundary"),
        ((0.1, 1.0), "boundary to mixed"),
        ((0.31, 3.45), "mixed"),
        ((1.0, 9.0), "mixed to full-film"),
        ((3.55, 9.0), "full-film"),
    ],
)
def test_the_kind_of_lubrication(lam, said):
    assert str(regimes(*lam)) == said
