# SPDX-License-Identifier: Apache-2.0
"""What the teeth of cylindrical gears have to keep: the limits by which the checks judge and the search chooses.

Lengths are in normal modules.  Where there are two, the first is hard and the other usual."""

import numpy as np

from ..sheet.formula import formula
from ..sheet.functions import single_or_many
from ..sheet.number import DIGITS
from ..sheet.text import Amount, Text
from ..sheet.units import Metre

PRACTICE = Text("rule of this program after the practice of gear handbooks, from memory")

TIP_THICKNESS = 0.25  # normal
TIP_THICKNESS_HARDENED = 0.4  # of case-hardened teeth
CONTACT_RATIO, USUAL_CONTACT_RATIO = 1.1, 1.25
ABOVE_FILLET, USUAL_ABOVE_FILLET = 0.0, 0.1
TIP_CLEARANCE, USUAL_TIP_CLEARANCE = 0.15, 0.2  # the second: what the search for shifts keeps
QUARTER, QUARTER_MODULE = 0.25, "0.25 m_n"  # what a margin is a share of where the limit is 0


@formula(
    "c_F",
    "ISO 21771:2007: how far above the fillet contact begins",
    unit="mm",
    shows="(d_N − d_Ff)/2, d_N where the tip of the mate arrives",
    names={"T": "T_1T_2"},
)
def above_fillet(d_b: Metre, T: Metre, rho_a: Metre, d_Ff: Metre) -> Metre:
    """Numbers or arrays; ρ_a: curvature at the mate's tip.

    What the tip reaches past the base circle, where there is no flank, is counted along the line of action.
    """
    rho = T - rho_a
    reach = np.where(rho > 0, np.hypot(d_b / 2, rho), d_b / 2 + rho) - d_Ff / 2
    return single_or_many(np.asarray(reach))


# --- words that several sentences of the gear train share

EXTREME = Text("module, face width, power or speed are far outside what the formulas are for: give usual ones")


def mm(length: Metre, form: str = "", *, digits: int = DIGITS) -> Amount:
    """In millimetres, which the sentence names behind it."""
    return Amount(length * 1000.0, form=form, digits=digits)
