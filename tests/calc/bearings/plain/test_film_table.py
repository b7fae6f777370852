# SPDX-License-Identifier: Apache-2.0
"""The stored film against the direct solution, and its inversion."""

import json
import math
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from calc.bearings.plain.film import build_table as build_film_table
from calc.bearings.plain.film import table as film_nodes
from calc.bearings.plain.film import table as film_table
from calc.bearings.plain.film.reynolds import solve_film
from calc.bearings.plain.film.table import FilmRangeError, eccentricity_from, film_at

REFERENCE = Path(__file__).parents[3] / "reference"
FINITE = [row for row in json.loads((REFERENCE / "bearings_reynolds.json").read_text())["rows"] if row["ld"] != "inf"]
RANDOM = np.random.default_rng(1958)
OFF_NODE = [
    (
        math.tanh(RANDOM.uniform(math.atanh(0.02), math.atanh(0.98))),
        math.exp(RANDOM.uniform(math.log(0.1), math.log(2.0))),
    )
    for _ in range(40)
]
CORNERS = [(e, b) for e in (0.02, 0.98) for b in (0.1, 2.0)]
GRID = np.meshgrid(np.tanh(np.linspace(0.0201, 2.297, 101)), np.geomspace(0.1001, 1.999, 67))
DIRECT = ("sommerfeld", "attitude", "friction", "flow", "side_flow_ratio", "pressure_ratio")
FIELDS = (*DIRECT, "radial_damping")


@pytest.mark.parametrize("row", FINITE, ids=lambda row: f"{row['ld']}-{row['eps']}")
def test_converged_solutions(row):
    film = film_at(row["eps"], row["ld"])
    assert film.sommerfeld == pytest.approx(row["S"], rel=2e-4)
    assert math.degrees(film.attitude) == pytest.approx(row["phi"], rel=2e-4)
    assert film.friction == pytest.approx(row["frc"], rel=2e-4)
    assert film.flow == pytest.approx(row["Q"], rel=2e-4)
    assert film.side_flow_ratio == pytest.approx(row["QsQ"], rel=2e-4)
    assert film.pressure_ratio == pytest.approx(row["Pr"], rel=5e-4)
    assert eccentricity_from(row["S"], row["ld"]) == pytest.approx(row["eps"], rel=2e-4)


@pytest.mark.parametrize("eccentricity, length_ratio", OFF_NODE + CORNERS)
def test_between_the_nodes(eccentricity, length_ratio):
    stored, direct = film_at(eccentricity, length_ratio), solve_film(eccentricity, length_ratio)
    for name in DIRECT:
        assert getattr(stored, name) == pytest.approx(getattr(direct, name), rel=2e-4), name


@pytest.mark.parametrize("i, j", [(0, 0), (-1, -1), (0, -1), (-1, 0), (13, 11), (22, 5)])
def test_nodes_come_from_the_direct_solution(i, j):
    table = film_nodes.film_nodes()
    eccentricity, length_ratio = float(table.eccentricities[i]), float(table.length_ratios[j])
    assert eccentricity == build_film_table.eccentricity_nodes()[i]
    assert length_ratio == build_film_table.length_ratio_nodes()[j]
    assert table.rows[2 * j, 2 * i] == pytest.approx(build_film_table.node_values(eccentricity, length_ratio), abs=1e-9)


@pytest.mark.slow
def test_the_whole_table_can_be_written_again(tmp_path):
    build_film_table.main(tmp_path / "again.npy")
    stored, again = np.load(film_nodes.TABLE)[()], np.load(tmp_path / "again.npy")[()]
    for name in stored.dtype.names:
        assert np.allclose(stored[name], again[name], rtol=0.0, atol=1e-7), name


def test_a_scalar_gives_floats_and_the_same_as_an_array():
    eccentricity, length_ratio = GRID
    many = film_at(eccentricity, length_ratio)
    assert many.flow.shape == eccentricity.shape
    for at in [(0, 0), (66, 100), (31, 57), (50, 3)]:
        one = film_at(float(eccentricity[at]), float(length_ratio[at]))
        for name in ("eccentricity", *FIELDS):
            assert type(getattr(one, name)) is float
            assert getattr(one, name) == pytest.approx(getattr(many, name)[at], rel=1e-12)
        back = eccentricity_from(one.sommerfeld, float(length_ratio[at]))
        assert type(back) is float and back == pytest.approx(one.eccentricity, rel=1e-12)


def test_broadcasting():
    assert film_at(np.array([[0.2], [0.4]]), np.array([0.3, 0.5, 0.7])).sommerfeld.shape == (2, 3)
    assert film_at(0.5, np.array([0.3, 0.5])).attitude.shape == (2,)
    assert eccentricity_from(np.array([0.1, 0.2, 0.3]), 0.5).shape == (3,)
    assert film_at(np.array([]), 0.5).flow.shape == eccentricity_from(np.array([]), 0.5).shape == (0,)
    assert type(film_at(np.float64(0.5), np.array(0.5)).flow) is float


def test_round_trip():
    eccentricity, length_ratio = GRID
    assert (
        np.abs(eccentricity_from(film_at(eccentricity, length_ratio).sommerfeld, length_ratio) - eccentricity).max()
        < 1e-12
    )


def test_the_load_rises_with_the_eccentricity_at_every_length():
    eccentricity = np.tanh(np.linspace(math.atanh(0.0200001), math.atanh(0.9799999), 1500))
    assert np.all(np.diff(film_at(eccentricity[:, None], np.geomspace(0.1, 1.9999, 90)).sommerfeld, axis=0) < 0.0)


@pytest.mark.parametrize("length_ratio", [0.1, 0.3271604938, 0.5, 2.0])
def test_the_limits_belong_to_the_range(length_ratio):
    low, high = (film_at(eccentricity, length_ratio).sommerfeld for eccentricity in (0.98, 0.02))
    assert eccentricity_from(low, length_ratio) == pytest.approx(0.98, abs=1e-12)
    assert eccentricity_from(high, length_ratio) == pytest.approx(0.02, abs=1e-12)
    assert np.allclose(eccentricity_from(np.array([low, high]), length_ratio), [0.98, 0.02], rtol=0.0, atol=1e-12)


@pytest.mark.parametrize("limit", [0.02, 0.98])
def test_the_range_of_many_lengths(limit):
    assert film_at(limit, np.array([0.25, 0.5])).sommerfeld[1] == pytest.approx(
        film_at(limit, 0.5).sommerfeld, rel=1e-12
    )


@pytest.mark.parametrize(
    "function, first, length_ratio, words",
    [
        (film_at, 0.99, 0.5, ("eccentricity", "0.99", "0.02 to 0.98")),
        (film_at, 0.5, 2.5, ("l/d", "2.5", "0.1 to 2")),
        (film_at, math.nan, 0.5, ("eccentricity", "nan")),
        (film_at, 0.5, math.inf, ("l/d", "inf", "0.1 to 2")),
        (eccentricity_from, 1e-6, 0.5, ("Sommerfeld", "1·10⁻⁶", "l/d 0.5")),
        (eccentricity_from, 1e6, 0.5, ("Sommerfeld", "1·10⁶", "l/d 0.5")),
        (eccentricity_from, -0.1, 0.5, ("Sommerfeld", "−0.1")),
        (eccentricity_from, 0.1, 0.05, ("l/d", "0.05", "0.1 to 2")),
    ],
)
def test_outside_the_table(function, first, length_ratio, words):
    for value in (first, np.array([0.3, first])):
        with pytest.raises(FilmRangeError) as caught:
            function(value, length_ratio)
        assert all(word in str(caught.value) for word in words)
        result = function(value, length_ratio, outside="nan")
        result = result if function is eccentricity_from else result.friction
        assert math.isnan(np.ravel(result)[-1])
        if length_ratio == 0.5 and np.ndim(value):
            assert not math.isnan(result[0])


def test_the_error_carries_its_numbers():
    with pytest.raises(
        FilmRangeError, match=r"l/d 0\.05 is outside the film table, 0\.1 to 2 \(1 of 3 values are outside\)"
    ) as caught:
        film_at(0.5, np.array([0.3, 0.05, 0.4]))
    assert (caught.value.quantity, caught.value.value, caught.value.low, caught.value.high) == (
        "length ratio l/d",
        0.05,
        0.1,
        2.0,
    )


def test_the_table_needs_no_scipy():
    code = (
        "import sys; from calc.bearings.plain.film.table import film_at, eccentricity_from;"
        "eccentricity_from(film_at(0.5, 0.5).sommerfeld, 0.5);"
        "print([name for name in sys.modules if name.split('.')[0] == 'scipy'])"
    )
    run = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        check=True,
        cwd=Path(film_table.__file__).parents[3],
    )
    assert run.stdout.strip() == "[]"
