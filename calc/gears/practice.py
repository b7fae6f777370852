# SPDX-License-Identifier: Apache-2.0
"""What the teeth of cylindrical gears have to keep: the limits by which the checks judge and the search for shifts chooses.

Lengths are in normal modules.  Where there are two, the first is hard and the other usual.
"""

from typing import Any

import numpy as np

from .formulas import diameter_at

PRACTICE = "practice for cylindrical gears, as generally published"

TIP_THICKNESS = 0.25  # normal
TIP_THICKNESS_HARDENED = 0.4  # of case-hardened teeth
CONTACT_RATIO, USUAL_CONTACT_RATIO = 1.1, 1.25
ABOVE_FILLET, USUAL_ABOVE_FILLET = 0.0, 0.1
TIP_CLEARANCE = 0.15


def above_fillet(d_b: Any, T: Any, rho_a: Any, d_Ff: Any) -> Any:
    """(d_N − d_Ff)/2 of a wheel, numbers or arrays; d_N: where the mate's tip arrives, whose curvature there is ρ_a.

    What the tip reaches past the base circle, where there is no flank, is counted along the line of action.
    """
    rho = T - rho_a
    return np.where(rho > 0, diameter_at(d_b, rho) / 2, d_b / 2 + rho) - d_Ff / 2
