# SPDX-License-Identifier: Apache-2.0
"""Many operating points in one call are the single ones."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from calc.friction import models as regressions
from calc.friction.mesh.film import oil_at
from calc.friction.mesh.geometry import column, flat
from calc.friction.mesh.loss import Warming, case, solve_mesh
from tests.calc.friction.pairs import friction, lubricant, r753, spur_pair

# Four points from a rigid isoviscous film to heavy mixed friction; power W, speed rev/s, temperature °C, Λ, factor on
# α, Ra, μ_s
POINTS = {
    "P": np.array([5.0, 300.0, 6000.0, 20000.0]),
    "n": np.array([10.0, 43.3, 25.0, 60.0]),
    "T": np.array([40.0, 120.0, 60.0, 90.0]),
    "Lambda": np.array([0.03, 0.047, 0.06, 0.04]),
    "thickening": np.array([0.8, 1.0, 1.2, 1.1]),
    "Ra": np.array([0.4e-6, 0.8e-6, 1.6e-6, 0.2e-6]),
    "mu_s": np.array([0.135, 0.1, 0.16, 0.12]),
}
NUMBERS = (
    "loss", "sliding_loss", "rolling_loss", "rolling_estimate", "efficiency", "loss_factor", "friction_mean",
    "film_min", "lambda_min",
    "pressure_max", "temperature_max", "bulk_temperature", "deborah_max", "rigid_share", "load", "lead_at_pitch",
    "thermal_reduction_min",
)  # fmt: skip
MESHES = {"spur": spur_pair(), "helical": r753()["central_idler"]}
WAYS = {
    "plain": {},
    "relieved": {"load_sharing": "smooth"},
    "roelands": {"pressure_law": "roelands"},
    "estimated": {"bulk": "estimated"},
    "bodies": {"body_resistance": (0.02, 0.01)},
    "all": {"bulk": "estimated", "body_resistance": (0.02,), "pressure_law": "roelands"},
}


def made(mesh, P, n, T, Lambda, thickening, Ra, mu_s, **said):
    """The case and its power; the numbers may be arrays."""
    oil = oil_at(lubricant(), column(T), column(Lambda), column(thickening))
    own = replace(friction(**said), flank_roughness=(column(Ra),), solid_friction=column(mu_s))
    return case(own, mesh, oil, n, Warming(column(T), 1.2, 1.0)), P


def one(values, i):
    return None if values is None else np.broadcast_to(values, 4)[i]


@pytest.mark.parametrize("by_regime", [True, False])
@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("kind", MESHES)
def test_four_points_at_once_are_four_times_one(kind, way, by_regime):
    many = solve_mesh(*made(MESHES[kind], **POINTS, **WAYS[way]), by_regime)
    for i in range(4):
        point = {name: float(values[i]) for name, values in POINTS.items()}
        alone = solve_mesh(*made(MESHES[kind], **point, **WAYS[way]), by_regime)
        for name in NUMBERS:
            expected = getattr(alone, name)
            if expected is None:  # no such value: of many points, 0
                assert getattr(many, name) is None or not one(getattr(many, name), i), name
            else:
                assert isinstance(expected, float), name
                assert one(getattr(many, name), i) == pytest.approx(expected, rel=1e-9, abs=1e-300), (name, i)


@pytest.mark.parametrize("kind", MESHES)
def test_along_the_path_too(kind):
    many = solve_mesh(*made(MESHES[kind], **POINTS), True).local
    for i in range(4):
        alone = solve_mesh(
            *made(MESHES[kind], **{name: float(values[i]) for name, values in POINTS.items()}), True
        ).local
        for name in ("p_H", "h", "lam", "xi", "mu", "q", "T_f"):
            assert getattr(many, name)[i] == pytest.approx(getattr(alone, name), rel=1e-8, abs=1e-9), name
        assert many.x == pytest.approx(alone.x)


def test_the_points_cover_both_films():
    shares = solve_mesh(*made(MESHES["spur"], **POINTS), True).rigid_share
    assert shares[0] == 1.0 and shares[-1] == 0.0


@pytest.mark.parametrize("name", POINTS)
def test_each_number_may_be_many_alone(name):
    """The others stay floats."""
    base = {key: float(values[1]) for key, values in POINTS.items()}
    many = solve_mesh(*made(MESHES["spur"], **(base | {name: POINTS[name]})), True)
    for i in range(4):
        alone = solve_mesh(*made(MESHES["spur"], **(base | {name: float(POINTS[name][i])})), True)
        for key in ("loss", "film_min", "temperature_max", "pressure_max"):
            assert one(getattr(many, key), i) == pytest.approx(getattr(alone, key), rel=1e-9), key


def test_one_point_as_an_array_is_one_point():
    base = {key: values[:1] for key, values in POINTS.items()}
    found = solve_mesh(*made(MESHES["spur"], **base), True).loss
    assert np.shape(found) == (1,)
    assert found[0] == pytest.approx(
        solve_mesh(*made(MESHES["spur"], **{key: float(x[0]) for key, x in base.items()}), True).loss, rel=1e-9
    )


def test_a_column_and_back():
    x = np.array([1.0, 2.0])
    assert column(x).shape == (2, 1)
    assert np.array_equal(flat(column(x)), x)
    assert column(3.0) == flat(3.0) == 3.0


@pytest.mark.parametrize("of", ["of_schlenk", "of_niemann", "of_xu_kahraman", "of_benedict_kelley"])
def test_the_regressions_too(of):
    said = {name: POINTS[name] for name in ("P", "n", "T")}
    if of in ("of_xu_kahraman", "of_benedict_kelley"):
        said = said | {"Ra": np.array([0.3e-6, 0.5e-6, 0.8e-6, 1.2e-6])}
    base = {key: float(values[1]) for key, values in POINTS.items()}

    def found(point):
        return getattr(regressions, of)(*made(MESHES["spur"], **point), 0.13)

    many = found(base | said)
    for i in range(4):
        alone = found(base | {key: float(values[i]) for key, values in said.items()})
        assert many.loss[i] == pytest.approx(alone.loss, rel=1e-12)
        assert many.friction_mean[i] == pytest.approx(alone.friction_mean, rel=1e-12)


def test_the_load_rises_the_loss_of_each_point():
    P = np.geomspace(1.0, 1e5, 30)
    base = {key: float(values[2]) for key, values in POINTS.items()}
    losses = solve_mesh(*made(MESHES["spur"], **(base | {"P": P})), False).loss
    assert all(a < b for a, b in pairwise(losses))
