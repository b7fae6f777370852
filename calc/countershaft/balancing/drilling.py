# SPDX-License-Identifier: Apache-2.0
"""Which holes how deep: bounded least squares, since drilling only takes away.

The planes count by what is permitted in each.  Where several sets of depths leave the same, that with the least sum of
(u/u_most)² is taken: the load is shared."""

import numpy as np

from ...sheet.arrays import Array, ComplexArray

SHARP = 1e-7  # weight of the shares against what is left, where that alone does not decide


def amounts(excess: ComplexArray, takes: ComplexArray, permitted: Array, most: Array) -> Array:
    """What each hole has to take, from 0 to `most`, so that Σ |left/permitted|² over the planes is least.

    `excess`: (planes,), what is too much; `takes`: (planes, holes), what each plane loses of a unit taken at a hole;
    `permitted`: (planes,); `most`: (holes,); all in one unit.  An infinite `most`: as much as helps."""
    from scipy.optimize import lsq_linear  # type: ignore[import-untyped]  # costs half a second, for readings alone

    bounded = np.where(np.isfinite(most), most, float(np.sum(np.abs(excess))) or 1.0)
    by_share = takes * bounded / permitted[:, None]
    wanted = excess / permitted
    A, b = (np.concatenate([x.real, x.imag]) for x in (by_share, wanted))
    upper = np.where(np.isfinite(most), 1.0, np.inf)
    shares = np.asarray(lsq_linear(A, b, (0.0, upper), method="bvls", tol=1e-14).x)
    if np.linalg.matrix_rank(A) < shares.size:
        kept, none = np.concatenate([A / SHARP, np.eye(shares.size)]), np.zeros(shares.size)
        shares = np.asarray(
            lsq_linear(kept, np.concatenate([A @ shares / SHARP, none]), (0.0, upper), method="bvls", tol=1e-14).x
        )
    return shares * bounded
