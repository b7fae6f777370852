# SPDX-License-Identifier: Apache-2.0
"""The fit against certified values, against linear algebra, and against what its limits promise."""

import json
import tomllib
from math import inf

import numpy as np
import pytest

from calc.measurements.fitting import FitResult, FitRows, FreeNumber, differences, fitted
from calc.sheet.errors import NoSolution
from calc.sheet.text import Text
from tests.conftest import ROOT

NIST = tomllib.loads((ROOT / "tests" / "reference" / "nist_nonlinear.toml").read_text())
GIVEN = json.loads((ROOT / "tests" / "reference" / "fits.json").read_text())["given"]
SPEEDS = np.array([800.0, 1200.0, 1600.0, 2000.0, 2400.0, 2800.0, 3200.0])
exp = np.exp
FORMULAS = {
    "Misra1a": lambda b, x: b[0] * (1 - exp(-b[1] * x)),
    "Misra1b": lambda b, x: b[0] * (1 - (1 + b[1] * x / 2) ** -2),
    "Misra1c": lambda b, x: b[0] * (1 - (1 + 2 * b[1] * x) ** -0.5),
    "Misra1d": lambda b, x: b[0] * b[1] * x / (1 + b[1] * x),
    "DanWood": lambda b, x: b[0] * x ** b[1],
    "BoxBOD": lambda b, x: b[0] * (1 - exp(-b[1] * x)),
    "Rat42": lambda b, x: b[0] / (1 + exp(b[1] - b[2] * x)),
    "MGH09": lambda b, x: b[0] * (x**2 + x * b[1]) / (x**2 + x * b[2] + b[3]),
    "petroff": lambda p, n: p[0] * (n / 1000) ** 2 + p[1] * n / 1000,
    "collinear": lambda p, n: (p[0] + p[1]) * (n / 1000) ** 2 + 0.002 * p[0] * n / 1000,
}
FORMULAS["misra1a"] = FORMULAS["Misra1a"]


def of_formula(name, x):
    return lambda points: [FORMULAS[name](p, np.asarray(x)) for p in points]


def free(low, high, start, **prior):
    return [FreeNumber(f"p{i}", *ends, **prior) for i, ends in enumerate(zip(low, high, start), 1)]


def a_fit(
    name, measured, sigma, low, high, start, *, x=SPEEDS, common=(), prior=None, prior_sd=None, **how
) -> FitResult:
    numbers = [
        FreeNumber(f.name, f.low, f.high, f.start, None if prior is None else prior[i], prior_sd and prior_sd[i])
        for i, f in enumerate(free(low, high, start))
    ]
    known = None if sigma is None else np.broadcast_to(np.asarray(sigma, float), np.shape(measured))
    return fitted(of_formula(name, x), FitRows(np.asarray(measured, float), known, common), numbers, **how)


@pytest.mark.parametrize("name", NIST)
def test_the_certified_values(name):
    of = NIST[name]
    fit = a_fit(name, of["y"], None, of["low"], of["high"], of["start"], x=of["x"])
    assert fit.verdict == "identified"
    assert np.abs((fit.values - of["values"]) / of["sd"]).max() < 2e-5  # tolerance 1e-10 of the sum of squares
    assert fit.sd == pytest.approx(of["sd"], rel=2e-5)
    assert fit.sum_of_squares == pytest.approx(of["sum_of_squares"], rel=1e-9)
    assert fit.variance**0.5 == pytest.approx(of["residual_sd"], rel=1e-9)


def test_misra1a_to_eight_digits():
    of = NIST["Misra1a"]
    fit = a_fit("Misra1a", of["y"], None, of["low"], of["high"], of["start"], x=of["x"])
    assert fit.values == pytest.approx(of["values"], rel=1e-8)
    assert fit.sd == pytest.approx(of["sd"], rel=1e-8)


def test_the_given_values():
    read = {
        "p1": lambda fit: fit.values[0],
        "p2": lambda fit: fit.values[1],
        "sd p1": lambda fit: fit.sd[0],
        "sd p2": lambda fit: fit.sd[1],
        "chi2": lambda fit: fit.sum_of_squares,
        "sum of squares": lambda fit: fit.sum_of_squares,
        "width of the worst direction (share of the range)": lambda fit: fit.width,
    }
    fits = {}
    for row in GIVEN:
        case = row["case"]
        if isinstance(case, dict):
            name, prior = case["fit"], case["prior"]
            ends = case["low"], case["high"], case["start"]
            fits[name] = a_fit(name, case["y"], case["sigma"], *ends, x=case["x"], prior=prior)
        else:
            name = case
        if row["quantity"] == "verdict":
            assert fits[name].verdict == row["is"]
        else:
            assert read[row["quantity"]](fits[name]) == pytest.approx(row["is"], rel=row["rel"]), row
    assert len(GIVEN) == 17


COLLINEAR = [12.96, 28.95, 52.81, 83.04, 121.59, 164.54, 217.34]


def test_collinear_numbers_are_identified_by_a_prior():
    given = "collinear", COLLINEAR, 1.5, [0.0, 0.0], [40.0, 40.0], [10.0, 10.0]
    alone = a_fit(*given)
    assert alone.verdict == "not identifiable" and alone.correlation < -0.999
    assert alone.directions[0] == pytest.approx([0.71, -0.71], abs=0.02)
    known = a_fit(*given, prior=[8.0, None], prior_sd=[2.0, None])
    assert known.verdict == "identified" and known.degrees_of_freedom == alone.degrees_of_freedom + 1
    assert known.sd[0] == pytest.approx(2.0, rel=0.01)  # the prior's own: the rows say nothing of it


def test_a_number_of_no_effect_has_infinite_width():
    fit = fitted(
        lambda points: [p[0] * SPEEDS for p in points],
        FitRows(2.0 * SPEEDS, np.ones(7)),
        free([0.0, 0.0], [5.0, 5.0], [1.0, 1.0]),
    )
    assert fit.verdict == "not identifiable" and fit.width == inf and fit.correlation is None
    assert fit.directions[0] == pytest.approx([0, 1], abs=1e-9)


def linear(sigma, common, prior, prior_sd):
    """What linear algebra says of p1 n² + p2 n, by the inverse of the whole matrix of normal equations."""
    n = SPEEDS / 1000
    rows, values = np.column_stack([n**2, n]), np.array([17.26, 37.18, 65.86, 96.99, 132.9, 181.43, 233.3])
    weights = np.linalg.inv(np.diag(sigma**2) + sum(np.outer(b, b) for b in common))
    normal, right = rows.T @ weights @ rows, rows.T @ weights @ values
    if prior is not None:
        normal[0, 0] += 1 / prior_sd**2
        right[0] += prior / prior_sd**2
    covariance = np.linalg.inv(normal)
    return values, covariance @ right, np.sqrt(np.diag(covariance))


@pytest.mark.parametrize("prior, prior_sd", [(None, None), (22.0, 0.3)])
@pytest.mark.parametrize("common", [(), (np.full(7, 2.0),), (0.03 * SPEEDS / 100, np.array([0, 0, 0, 4.0, 4, 4, 4]))])
def test_of_a_linear_model_it_is_that_of_linear_algebra(common, prior, prior_sd):
    sigma = np.linspace(2.0, 6.0, 7)
    measured, values, sd = linear(sigma, common, prior, prior_sd)
    priors = dict(prior=[prior, None], prior_sd=[prior_sd, None]) if prior is not None else {}
    fit = a_fit("petroff", measured, sigma, [0.0, 0.0], [60.0, 40.0], [50.0, 1.0], common=common, **priors)
    assert not fit.scaled
    assert fit.values == pytest.approx(values, rel=1e-7) and fit.sd == pytest.approx(sd, rel=1e-7)
    assert fit.limits[:, 1] - fit.values == pytest.approx(1.959964 * sd, rel=1e-6)


def test_a_common_error_is_one_more_number_with_a_prior_of_one():
    """χ² = r'(σ² + bb')⁻¹r is the least over β of ((r − βb)/σ)² + β²."""
    sigma, shift = np.full(7, 1.5), np.linspace(1.0, 8.0, 7)
    measured, *_ = linear(sigma, (), None, None)
    at_once = a_fit("petroff", measured, sigma, [0.0, 0.0], [60.0, 40.0], [10.0, 10.0], common=(shift,))
    beside = fitted(
        lambda points: [FORMULAS["petroff"](p, SPEEDS) - p[2] * shift for p in points],
        FitRows(measured, sigma),
        [*free([0.0, 0.0], [60.0, 40.0], [10.0, 10.0]), FreeNumber("β", -10.0, 10.0, 0.0, 0.0, 1.0)],
    )
    assert at_once.sum_of_squares == pytest.approx(beside.sum_of_squares, rel=1e-8)
    assert at_once.values == pytest.approx(beside.values[:2], rel=1e-7)
    assert at_once.sd == pytest.approx(beside.sd[:2], rel=1e-7)
    assert at_once.degrees_of_freedom == beside.degrees_of_freedom == 5


def test_a_number_that_ends_at_its_bound():
    measured, *_ = linear(np.full(7, 1.5), (), None, None)
    fit = a_fit("petroff", measured, 1.5, [0.0, 7.5], [60.0, 40.0], [10.0, 10.0])
    assert fit.verdict == "at its bound" and fit.at_bound == (1,)
    assert fit.values[1] == pytest.approx(7.5, rel=1e-6)


def test_the_bound_is_asked_after_the_width():
    """A number of no effect stays wherever it is, at a bound too."""
    fit = a_fit("collinear", COLLINEAR, 1.5, [0.0, 0.0], [40.0, 40.0], [0.0, 40.0])
    assert fit.verdict == "not identifiable"


def test_at_a_bound_nothing_beyond_it_is_asked_for():
    asked = []

    def model(points):
        asked.extend(points)
        return [FORMULAS["petroff"](p, SPEEDS) for p in points]

    measured, *_ = linear(np.full(7, 1.5), (), None, None)
    numbers = free([0.0, 7.5], [60.0, 40.0], [60.0, 7.5])
    fitted(model, FitRows(measured, np.full(7, 1.5)), numbers, step=0.01)
    low, high = np.min(asked, axis=0), np.max(asked, axis=0)
    assert (low >= [0.0, 7.5]).all() and (high <= [60.0, 40.0]).all()


@pytest.mark.parametrize("q, h", [((0.5, 0.5), 1e-3), ((0.0, 1.0), 1e-3), ((0.0004, 0.9999), 1e-3)])
def test_differences_are_of_second_order_at_bounds_too(q, h):
    def residuals(points):
        return [np.array([exp(a) * b**2, a**2 + b]) for a, b in points]

    a, b = q
    exact = np.array([[exp(a) * b**2, 2 * exp(a) * b], [2 * a, 1.0]])
    errors = [
        np.abs(differences(residuals, lambda x: residuals([x])[0], np.array(q), step) - exact).max()
        for step in (h, h / 2)
    ]
    assert errors[0] < 3e-6
    if min(a, 1 - b) == 0:
        assert errors[0] / errors[1] == pytest.approx(4, rel=0.05)


def test_the_columns_are_solved_abreast():
    sizes = []

    def model(points):
        sizes.append(len(points))
        return [FORMULAS["petroff"](p, SPEEDS) for p in points]

    measured, *_ = linear(np.full(7, 1.5), (), None, None)
    fit = fitted(model, FitRows(measured, np.full(7, 1.5)), free([0.0, 0.0], [60.0, 40.0], [10.0, 10.0]))
    assert set(sizes) == {1, 4} and fit.evaluations == sum(sizes)


def test_rows_that_scatter_more_than_they_say_make_it_wider():
    measured, _, sd = linear(np.full(7, 0.2), (), None, None)
    fit = a_fit("petroff", measured, 0.2, [0.0, 0.0], [60.0, 40.0], [10.0, 10.0])
    assert fit.scaled and fit.variance > 2.57  # χ²(5), 97.5 %
    assert fit.sd == pytest.approx(sd * fit.variance**0.5, rel=1e-6)
    assert fit.width == pytest.approx(a_fit("petroff", measured, 0.4, [0, 0], [60, 40], [10, 10]).width / 2, rel=1e-6)


def test_one_row_too_few_is_refused():
    with pytest.raises(ValueError, match="2 rows for 2 free numbers"):
        a_fit("petroff", [17.0, 37.0], 1.5, [0, 0], [60, 40], [10, 10], x=SPEEDS[:2])


def test_a_prior_beside_rows_without_uncertainty_is_refused():
    with pytest.raises(ValueError, match="prior"):
        a_fit("petroff", COLLINEAR, None, [0, 0], [60, 40], [10, 10], prior=[8.0, None], prior_sd=[1.0, None])


def test_what_the_model_says_ends_the_fit():
    def model(points):
        if points[0][0] > 12:
            raise NoSolution(Text("no film"))
        return [FORMULAS["petroff"](p, SPEEDS) for p in points]

    with pytest.raises(NoSolution, match="no film"):
        fitted(model, FitRows(np.array(COLLINEAR), np.ones(7)), free([0, 0], [60, 40], [10, 10]))


def test_a_search_that_does_not_settle_says_so():
    """The bottom of a curved valley, for which its evaluations do not suffice."""
    fit = fitted(
        lambda points: [np.array([1e4 * (b - a**2), a - 1, a / 10]) for a, b in points],
        FitRows(np.zeros(3), np.ones(3)),
        free([-30.0, -30.0], [30.0, 30.0], [-5.0, 25.0]),
    )
    assert fit.verdict == "not converged" and fit.evaluations < 5 * 2 * 30


@pytest.mark.slow
@pytest.mark.parametrize("known", ["sigma", "no sigma", "common", "prior"])
def test_the_limits_hold_what_they_say(known):
    """Of 1200 fits of as many truths 95 % of the limits hold them, within three standard deviations of that count."""
    chance, held, asked = np.random.default_rng(753), 0, 0
    sigma = 0.02 * SPEEDS / 10
    for _ in range(1200):
        truth = np.array([chance.uniform(15, 40), chance.uniform(5, 20)])
        error, how = sigma * chance.standard_normal(7), {}
        if known == "common":
            how = {"common": (0.05 * SPEEDS / 10,)}
            error = error + how["common"][0] * chance.standard_normal()
        if known == "prior":
            how = {"prior": [None, truth[1] + 0.5 * chance.standard_normal()], "prior_sd": [None, 0.5]}
        measured = FORMULAS["petroff"](truth, SPEEDS) + error
        given = None if known == "no sigma" else sigma
        if known == "no sigma":
            measured = FORMULAS["petroff"](truth, SPEEDS) + 2.0 * chance.standard_normal(7)
        fit = a_fit("petroff", measured, given, [-40.0, -40.0], [120.0, 120.0], [10.0, 10.0], **how)
        assert fit.verdict == "identified"
        held += np.count_nonzero((fit.limits[:, 0] <= truth) & (truth <= fit.limits[:, 1]))
        asked += 2
    assert abs(held / asked - 0.95) < 3 * (0.95 * 0.05 / (asked / 2)) ** 0.5  # the two of a fit are not independent
