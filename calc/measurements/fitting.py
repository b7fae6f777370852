# SPDX-License-Identifier: Apache-2.0
"""At most four numbers from measurements: the least sum of squares, and whether it says anything about them.

A fit by itself always ends in numbers; what they are worth lies in how the sum of squares grows away from them.  Each
free number is counted as a share q of its range, 0 at `low` and 1 at `high`.  The singular values s of the Jacobian of
the rows by q say how far the numbers may move along each of its directions v before the sum has grown by one: the width
1/s, a standard deviation as a share of the ranges.  A width above a quarter of them is no answer, however well the
curve goes through the points."""

from collections.abc import Callable, Sequence
from math import inf, sqrt
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from ..sheet.formula import formula
from ..sheet.record import record, replace
from ..sheet.units import Number

Floats = NDArray[np.float64]
Model = Callable[[Sequence[Floats]], Sequence[Floats]]
Verdict = Literal["not converged", "not identifiable", "at its bound", "identified"]

WIDEST = 0.25  # share of the ranges; a direction along which the numbers may move further is not identified
NO_INFORMATION = 1e-12  # a singular value below this share of the largest is none
PART = 0.3  # of a direction of length one: a number with less of it has little to do with it
AT_BOUND = 1e-6  # share of the range
TOLERANCE = 1e-10  # of the sum of squares, the step and the gradient
EVALUATIONS = 30  # a free number
OF_FORMULA, OF_DESIGN = 1e-5, 1e-3  # steps of the differences, as shares of the range


@record
class FreeNumber:
    """A number that is fitted, in the unit that the model takes: `low` < `high`, `start` between them, and what is
    known of it beforehand, a standard deviation beside it."""

    name: str
    low: float
    high: float
    start: float
    prior: float | None = None
    prior_sd: float | None = None

    @property
    def range(self) -> float:
        return self.high - self.low


@record
class FitRows:
    """What was measured, a row each, in the unit of the model: `measured` (n,); `sigma` (n,), the standard uncertainty
    of each row, all above zero, None where it is not known; `common`: for each instrument that has an error common to
    its rows the amounts (n,) by which one standard uncertainty of it shifts them, 0 in the rows of others."""

    measured: Floats
    sigma: Floats | None = None
    common: tuple[Floats, ...] = ()

    def whitening(self) -> Callable[[Floats], Floats]:
        """What makes rows of unit variance of differences (n,): r'(diag(σ²) + Σ b b')⁻¹ r is the sum of their
        squares.  Without uncertainties they stay as they are."""
        sigma = self.sigma
        if sigma is None:
            return lambda differences: differences
        if not self.common:
            return lambda differences: differences / sigma
        shifts = np.array(self.common)
        rows = np.linalg.inv(np.linalg.cholesky(np.diag(sigma**2) + shifts.T @ shifts))
        return lambda differences: np.asarray(rows @ differences)


@record
class FitResult:
    """What a fit came to, of k free numbers.

    `values` (k,), `sd` (k,) one standard deviation, `limits` (k, 2) two-sided 95 %, all in the unit of the model;
    `correlations` (k, k); `widths` (k,), the widest first, and `directions` (k, k), a row for each, the first of its
    parts that count positive.  What a direction of infinite width spoils is not a number.  `sum_of_squares` of all
    rows, those of priors among them, of which there are `degrees_of_freedom` more than free numbers.  `scaled`: the
    rows scatter more than their uncertainties say, and sd is wider for it.  `at_bound`: the places of the numbers that
    ended at low or high."""

    verdict: Verdict
    free: tuple[FreeNumber, ...]
    values: Floats
    sd: Floats
    limits: Floats
    correlations: Floats
    widths: Floats
    directions: Floats
    sum_of_squares: float
    degrees_of_freedom: int
    weighted: bool
    scaled: bool
    at_bound: tuple[int, ...]
    evaluations: int

    @property
    def width(self) -> float:
        """Of the worst direction."""
        return float(self.widths[0])

    @property
    def variance(self) -> float:
        """χ² over its degrees of freedom, of rows without uncertainty the square of their standard deviation."""
        return variance(self.sum_of_squares, self.degrees_of_freedom)

    @property
    def correlation(self) -> float | None:
        """The one of largest modulus between two of them; None of a single number, or where one is not known."""
        upper = self.correlations[np.triu_indices(len(self.free), 1)]
        if not upper.size or not np.isfinite(upper).all():
            return None
        return float(upper[np.argmax(np.abs(upper))])


@formula("s²", "definition: sum of squares over the degrees of freedom; χ² over them where the rows have uncertainties")
def variance(S: Number, nu: Number) -> Number:
    return S / nu


@formula("w", "mathematics: standard deviation along a singular direction of the Jacobian, as a share of the ranges")
def width(s: Number, s_k: Number) -> Number:
    return s / s_k


def fitted(model: Model, data: FitRows, free: Sequence[FreeNumber], step: float = OF_FORMULA) -> FitResult:
    """The numbers between their bounds for which the rows have the least sum of squares.

    `model` takes several sets of the free numbers (k,), to be solved abreast, and gives of each what it predicts (n,)
    in the order of the measurements; what it raises ends the fit.  `step` of the differences is a share of the range.
    Raises ValueError where there are no more rows than free numbers, or where a prior stands beside rows without
    uncertainty: its weight among them is not known."""
    from scipy.optimize import least_squares  # type: ignore[import-untyped]

    priors = [(i, f.prior, f.prior_sd) for i, f in enumerate(free) if f.prior is not None and f.prior_sd is not None]
    count, rows = len(free), len(data.measured) + len(priors)
    if rows <= count:
        raise ValueError(f"{rows} rows for {count} free numbers")
    if priors and data.sigma is None:
        raise ValueError("a prior beside rows without uncertainty")
    low, span = np.array([f.low for f in free]), np.array([f.range for f in free])
    whitened, evaluations = data.whitening(), 0

    def residuals(points: Sequence[Floats]) -> list[Floats]:
        nonlocal evaluations
        evaluations += len(points)
        numbers = [low + q * span for q in points]
        predicted = model(numbers)
        known = [np.array([(p[i] - prior) / sd for i, prior, sd in priors]) for p in numbers]
        return [np.concatenate([whitened(f - data.measured), k]) for f, k in zip(predicted, known)]

    here: dict[bytes, Floats] = {}  # what was asked of last: the differences at a bound need it again

    def at(q: Floats) -> Floats:
        if q.tobytes() not in here:
            here.clear()
            here[q.tobytes()] = residuals([q])[0]
        return here[q.tobytes()]

    def jacobian(q: Floats) -> Floats:
        return differences(residuals, at, q, step)

    start = np.array([(f.start - f.low) / f.range for f in free])
    found: Any = least_squares(
        at,
        np.clip(start, 0.0, 1.0),  # a start at a bound may lie beside it by rounding
        jac=jacobian,
        bounds=(0.0, 1.0),
        method="trf",
        ftol=TOLERANCE,
        xtol=TOLERANCE,
        gtol=TOLERANCE,
        max_nfev=EVALUATIONS * count,
    )
    q = np.asarray(found.x)
    total, weighted = float(at(q) @ at(q)), data.sigma is not None
    fit = _judged(free, q, np.asarray(found.jac), total, rows - count, weighted=weighted, converged=found.status > 0)
    return replace(fit, evaluations=evaluations)


def differences(
    residuals: Callable[[Sequence[Floats]], list[Floats]], at: Callable[[Floats], Floats], q: Floats, h: float
) -> Floats:
    """The Jacobian (rows, k) at the shares q, all its columns asked for at once: central differences, and where those
    would leave the range one-sided ones inwards, of the same order."""
    points, sides = list[Floats](), list[int]()
    for i, share in enumerate(q):
        side = 1 if share - h < 0 else -1 if share + h > 1 else 0
        for far in (side, 2 * side) if side else (-1, 1):
            points.append(np.array([x + far * h if j == i else x for j, x in enumerate(q)]))
        sides.append(side)
    solved = residuals(points)
    columns = []
    for i, side in enumerate(sides):
        first, second = solved[2 * i : 2 * i + 2]
        columns.append(side * (4 * first - second - 3 * at(q)) / (2 * h) if side else (second - first) / (2 * h))
    return np.array(columns).T


def _judged(
    free: Sequence[FreeNumber], q: Floats, jacobian: Floats, total: float, dof: int, *, weighted: bool, converged: bool
) -> FitResult:
    from scipy.special import chdtri, ndtri, stdtrit  # type: ignore[import-untyped]

    _, singular, directions = np.linalg.svd(jacobian, full_matrices=False)  # the smallest, so the widest, is the last
    singular, directions = singular[::-1], directions[::-1]
    first = directions[np.arange(len(free)), np.argmax(np.abs(directions) > PART, axis=1)]
    directions = directions * np.where(first < 0, -1.0, 1.0)[:, None]
    s = 1.0 if weighted else sqrt(variance(total, dof))
    none = NO_INFORMATION * singular[-1]
    widths = np.array([width(s, s_k) if s_k > none else inf for s_k in singular.tolist()])
    spread = np.where(np.isfinite(widths), widths, np.nan)[:, None] * directions
    covariance = spread.T @ spread
    share = np.sqrt(np.diag(covariance))
    with np.errstate(invalid="ignore"):  # rows that are met exactly leave no scatter
        correlations = covariance / np.outer(share, share)
    scaled = weighted and bool(total > chdtri(dof, 0.025))
    span, low = np.array([f.range for f in free]), np.array([f.low for f in free])
    values = low + q * span
    sd = share * span * (sqrt(variance(total, dof)) if scaled else 1.0)
    times = ndtri(0.975) if weighted and not scaled else stdtrit(dof, 0.975)
    at_bound = tuple(i for i, x in enumerate(q) if min(x, 1 - x) <= AT_BOUND)
    verdict: Verdict = "identified"
    if not converged:
        verdict = "not converged"
    elif widths[0] > WIDEST:
        verdict = "not identifiable"
    elif at_bound:
        verdict = "at its bound"
    return FitResult(
        verdict,
        tuple(free),
        values,
        sd,
        np.column_stack([values - times * sd, values + times * sd]),
        correlations,
        widths,
        directions,
        total,
        dof,
        weighted,
        scaled,
        at_bound,
        0,
    )
