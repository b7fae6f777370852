# SPDX-License-Identifier: Apache-2.0
"""Rows, nodes and what residuals come to."""

import math

import numpy as np
import pytest

from calc.measurements.inputs import Condition, MeasuredColumn, Measurement
from calc.measurements.nodes import nodes_of
from calc.measurements.reading import read_run
from calc.measurements.residuals import chi_square, range_of_chi, residuals, runs_of
from calc.measurements.rows import rows_of

KEY = "bearings.supply_temperature_C"


def run(text, columns=None, **keys):
    about = [MeasuredColumn(column="P", value=("friction.bearing_loss",), unit="W", **(columns or {}))]
    table = Measurement(name="run", file="run.csv", **({"speed_": "n"} | keys), columns=tuple(about))
    raw = text.encode()
    rows, problems = rows_of(table, read_run(raw, ".csv"), lambda key: "°C", raw)
    assert not problems, problems
    return rows


def column(text, columns=None, **keys):
    nodes = nodes_of(run(text, columns, **keys), frozenset({KEY}))
    return nodes, next(iter(nodes.columns.values()))


def test_a_node_takes_rows_within_half_a_per_cent_of_its_first():
    nodes, P = column("n;P\n1004;12\n1000;10\n1005.1;20\n2000;30\n")
    assert nodes.speed * 60 == pytest.approx([1002, 1005.1, 2000]) and P.y.tolist() == [11, 20, 30]


def test_its_uncertainty_is_that_of_a_row_and_at_least_that_of_the_mean():
    """T-16: not over the root of their number."""
    _, alike = column("n;P\n1000;10\n1000;10\n1000;10\n1000;10\n", {"uncertainty_": 0.4})
    assert alike.sigma.tolist() == [pytest.approx(0.4)]
    _, apart = column("n;P\n1000;10\n1000;14\n", {"uncertainty_": 0.4})
    assert apart.sigma.tolist() == [pytest.approx(2.0)]  # 2√2/√2
    _, unlike = column("n;P;s\n1000;10;3\n1000;10;4\n", {"uncertainty_column": "s"})
    assert unlike.sigma.tolist() == [pytest.approx(math.sqrt(12.5))]


def test_uncertainties_are_added_as_squares_and_common_ones_stand_apart():
    _, P = column(
        "n;P;s\n1000;-10;4\n",
        {"uncertainty_": 3.0, "uncertainty": 0.2, "uncertainty_column": "s", "uncertainty_common": 0.1},
    )
    assert P.sigma.tolist() == [pytest.approx(math.sqrt(9 + 4 + 16))] and P.common.tolist() == [pytest.approx(-1.0)]


def test_peaks_are_divided_by_root_two():
    """T-12."""
    _, P = column("n;P\n1000;10\n", {"peak": True, "uncertainty": 0.1})
    assert P.y.tolist() == [pytest.approx(10 / math.sqrt(2))] and P.sigma.tolist() == [pytest.approx(1 / math.sqrt(2))]


def test_unlike_conditions_are_unlike_nodes():
    keys = {"conditions": (Condition(column="t", key=KEY),)}
    nodes, P = column("n;P;t\n1000;10;80\n1000;12;80.4\n1000;20;80.6\n", **keys)
    assert P.y.tolist() == [11, 20] and nodes.conditions[KEY].tolist() == [pytest.approx(80.2), 80.6]


def test_a_condition_in_another_unit():
    keys = {"conditions": (Condition(column="t", key=KEY),)}
    nodes, _ = column("n;P;t\nrpm;W;°F\n1000;10;248\n", **keys)
    assert nodes.conditions[KEY].tolist() == [pytest.approx(120.0)]


def test_many_speeds_are_sixty_bins():
    rows = "".join(f"{n};{n / 100}\n" for n in range(1000, 3000, 7))
    nodes, P = column(f"n;P\n{rows}")
    assert nodes.speed.size == 60 and int(nodes.rows.sum()) == len(range(1000, 3000, 7))
    assert P.y == pytest.approx(nodes.speed * 60 / 100)


def test_empty_cells_and_rows_without_speed_are_counted():
    nodes, P = column("n;P\n1000;10\n1500;\n;30\n0;40\n2000;NaN\n")
    rows = run("n;P\n1000;10\n1500;\n;30\n0;40\n2000;NaN\n")
    assert (P.rows, P.empty, rows.lost) == (1, 2, 2) and nodes.speed.size == 3


def test_what_is_kept_gives_the_same_rows_again():
    raw = "n;P;t;other\nrpm;W;°F;\n1000;10,125;248;x\n1500;;250;y\n;3;250;\n"
    keys = {"conditions": (Condition(column="t", key=KEY),)}
    first = run(raw, {"uncertainty": 0.02}, **keys)
    again = run(first.kept.decode(), {"uncertainty": 0.02}, **keys)
    assert again.kept == first.kept and again.sha256 == first.sha256 and b"other" not in first.kept
    assert again.speed == first.speed and again.conditions == first.conditions
    assert repr(again.columns) == repr(first.columns)


# --- residuals


def of(r, sigma, b=None):
    n = len(r)
    text = "n;P\n" + "".join(f"{1000 + 100 * i};0\n" for i in range(n))
    P = column(text, {"uncertainty_": 1.0})[1]
    common = None if b is None else np.asarray(b, dtype=float)
    return residuals(np.asarray(r, dtype=float), P, P.y, np.full(n, float(sigma)), common)


def test_a_common_error_is_one_nuisance_row():
    """Its χ² is that of the inverse of the whole covariance."""
    rng = np.random.default_rng(1)
    r, s, b = rng.normal(size=7), rng.uniform(0.5, 2, 7), rng.normal(size=7)
    whole = r @ np.linalg.inv(np.diag(s**2) + np.outer(b, b)) @ r
    assert chi_square(r=r, sigma=s, b=b) == pytest.approx(whole, rel=1e-12)


def test_with_its_common_error_a_right_model_agrees():
    """Without it in about half of the cases at seven nodes, as the uncertainties alone are said to be right."""
    rng = np.random.default_rng(753)
    low, high = range_of_chi(7)
    with_it = without = 0
    for _ in range(400):
        r = rng.normal(size=7) + rng.normal()
        with_it += low <= chi_square(r=r, sigma=np.ones(7), b=np.ones(7)) <= high
        without += low <= chi_square(r=r, sigma=np.ones(7), b=np.zeros(7)) <= high
    assert 0.92 < with_it / 400 < 0.98 and without / 400 < 0.8


def test_the_range_is_that_of_the_tables():
    """Abramowitz, Stegun 1964, table 26.8: 7 degrees of freedom, 2.5 and 97.5 %."""
    assert range_of_chi(7) == pytest.approx((1.68987, 16.0128), rel=1e-5)


@pytest.mark.parametrize(
    "r, verdict",
    [([1, -1, 1, -1, 1, -1, 1], "agrees"), ([3, -3] * 3 + [3], "does not agree"), ([0.1] * 7, "uncertainty too large")],
)
def test_verdicts(r, verdict):
    found = of(r, 1.0)
    assert found.verdict == verdict and found.used == 7
    assert found.bias == pytest.approx(np.mean(r)) and found.rms == pytest.approx(np.sqrt(np.mean(np.square(r))))
    assert found.chi2_reduced == pytest.approx(np.sum(np.square(r)) / 7)


def test_without_uncertainty_nothing_is_judged():
    _, P = column("n;P\n1000;10\n2000;20\n")
    found = residuals(np.array([11.0, np.nan]), P, P.y, None, None)
    assert (found.verdict, found.chi2_reduced, found.used, found.bias) == ("not verified", None, 1, 1.0)


@pytest.mark.parametrize(
    "signs, z, word",
    [
        ("+++++-----", (2 - 6) / math.sqrt(20 / 9), "run"),
        ("+-+-+-+-+-", (10 - 6) / math.sqrt(20 / 9), "run"),
        ("++--+-++--", (6 - 6) / math.sqrt(20 / 9), "random"),
        ("+" * 10, None, "one side"),
        ("-" * 9, None, "not judged"),
        ("+++---+", (3 - (2 * 4 * 3 / 7 + 1)) / math.sqrt((24 / 7) * (24 / 7 - 1) / 6), "not judged"),
        ("+-", None, "not judged"),
    ],
)
def test_runs(signs, z, word):
    found, words = runs_of([sign == "+" for sign in signs])
    assert words == word and (found is None if z is None else found == pytest.approx(z))
