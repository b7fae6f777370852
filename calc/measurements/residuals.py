# SPDX-License-Identifier: Apache-2.0
"""What is predicted against what was measured, column by column: residuals, χ², whether they run, and in words."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from ..sheet.arrays import Array
from ..sheet.check import CheckRule
from ..sheet.formula import formula
from ..sheet.functions import sqrt
from ..sheet.record import record
from ..sheet.text import COMMA, EMPTY, Text
from ..sheet.units import Number, Numbers
from .nodes import ColumnNodes
from .words import RUN_WORDS, WORDS, Judged, Runs

TAIL = 0.025  # of two: what is judged is the middle 95 %
RUNS = 1.96  # the same of a normal deviate
FEWEST = 10  # nodes from which on runs are judged
RESIDUALS = "statistics: residuals, predicted less measured"
WALD = "Wald, Wolfowitz 1940: runs of the signs"


METHOD = CheckRule(
    "measured.R.C",
    "method",
    "A measurement judges the calculation and the uncertainty of the bench, never the part.",
    Text("Run of the bench"),
    "in",
    source=Text("χ² of the residuals over their uncertainty, two-sided 95 %"),
)


@formula("r̄", RESIDUALS, shows="Σ r / n")
def bias(r: Numbers) -> Number:
    return float(np.mean(r))


@formula("r_rms", RESIDUALS, shows="√(Σ r² / n)")
def rms(r: Numbers) -> Number:
    return float(np.sqrt(np.mean(np.square(r))))


@formula(
    "χ²",
    "statistics: residuals over their uncertainty, with an error b that all share as one nuisance parameter",
    shows="rᵀ (diag σ² + b bᵀ)⁻¹ r",
    names={"sigma": "σ"},
)
def chi_square(r: Numbers, sigma: Numbers, b: Numbers) -> Number:
    """By Sherman and Morrison; the same as the least over t of Σ ((r − t b)/σ)² + t²."""
    w = np.square(1 / sigma)
    return float(np.sum(w * r * r) - np.sum(w * r * b) ** 2 / (1 + np.sum(w * b * b)))


@formula("χ²_ν", "statistics: of nothing fitted, over the number of nodes", names={"chi": "χ²"})
def reduced(chi: Number, n: Number) -> Number:
    return chi / n


@formula("μ", WALD, names={"p": "n₊", "m": "n₋"})
def runs_expected(p: Number, m: Number) -> Number:
    return 2 * p * m / (p + m) + 1


@formula("σ_R", WALD, names={"mu": "μ"})
def runs_spread(mu: Number, n: Number) -> Number:
    return sqrt((mu - 1) * (mu - 2) / (n - 1))


@formula("z_R", WALD, names={"mu": "μ", "sigma": "σ_R"})
def runs_deviate(R: Number, mu: Number, sigma: Number) -> Number:
    return (R - mu) / sigma


def range_of_chi(n: int) -> tuple[float, float]:
    """The two-sided 95 % range of χ² with so many degrees of freedom."""
    from scipy.special import gammaincinv  # type: ignore[import-untyped]  # which is loaded where something was measured

    return 2 * float(gammaincinv(n / 2, TAIL)), 2 * float(gammaincinv(n / 2, 1 - TAIL))


@record
class Residuals:
    """Of one column: `r` node by node, NaN where something is missing, and what they come to.  None: there is none, or
    no uncertainty.  `judged_by`: the range of χ² over n, in which it agrees; `runs_z`: how far the number of runs lies
    from what chance gives."""

    r: Array
    used: int
    bias: float | None
    rms: float | None
    chi2_reduced: float | None
    judged_by: tuple[float, float] | None
    runs_z: float | None
    verdict: Judged
    runs: Runs

    @property
    def words(self) -> Text:
        """`agrees`, and whether the residuals run."""
        return COMMA.join(filter(None, (WORDS[self.verdict], RUN_WORDS.get(self.runs, EMPTY))))


def residuals(predicted: Array, nodes: ColumnNodes, y: Array, sigma: Array | None, common: Array | None) -> Residuals:
    """`predicted`, `y`, `sigma`, `common`: node by node in one unit; in order of speed."""
    r = predicted - y
    there = np.isfinite(r)
    some, used = r[there], int(there.sum())
    if not used:
        return Residuals(r, 0, None, None, None, None, None, "not verified", "not judged")
    verdict: Judged = "not verified"
    chi2_reduced, judged_by = None, None
    if sigma is not None and (sure := there & (sigma > 0)).any():
        n = int(sure.sum())
        b = np.zeros(n) if common is None else common[sure]
        low, high = range_of_chi(n)
        chi = chi_square(r=r[sure], sigma=sigma[sure], b=b)
        chi2_reduced, judged_by = reduced(chi=chi, n=n), (low / n, high / n)
        verdict = "agrees" if low <= chi <= high else "does not agree" if chi > high else "uncertainty too large"
    z, runs = runs_of([x >= 0 for x in some.tolist()])
    return Residuals(r, used, bias(r=some), rms(r=some), chi2_reduced, judged_by, z, verdict, runs)


def runs_of(signs: Sequence[bool]) -> tuple[float | None, Runs]:
    """How far the number of runs lies from that of chance, in standard deviations, None where there is no such number;
    and what that says."""
    n, plus = len(signs), sum(signs)
    judged = n >= FEWEST
    if plus in (0, n):
        return None, "one side" if judged else "not judged"
    mu = runs_expected(p=plus, m=n - plus)
    if mu <= 2:  # two nodes
        return None, "not judged"
    found = 1 + sum(a != b for a, b in pairwise(signs))
    z = runs_deviate(R=found, mu=mu, sigma=runs_spread(mu=mu, n=n))
    return z, "not judged" if not judged else "run" if abs(z) > RUNS else "random"
