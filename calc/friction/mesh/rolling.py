# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="no-any-return"
"""What rolling costs: oil is pumped against its own pressure although nothing slides.  The friction source leaves it out.

Between rigid bodies in a full gap the loss follows from the same Reynolds solution as the film; it is an upper bound, because a
real inlet is seldom full.  For EHL an estimate by Goksem and Hargreaves is shown and not added.
"""

from ...sheet.formula import formula
from ...sheet.functions import sqrt
from ...sheet.units import Metre, MetrePerSecond, Number, PascalSecond, PerPascal, WattPerMetre


@formula("q_R", "hydrodynamics, derived here: rolling of a rigid isoviscous film, fully flooded; its load gives Martin's 4.896")
def rigid_rolling_power(eta_0: PascalSecond, u_e: MetrePerSecond, R: Metre, h_0: Metre) -> WattPerMetre:
    return 9.202 * eta_0 * u_e**2 * sqrt(R / h_0)


@formula("q_E", "Goksem and Hargreaves 1978, rolling of a fully flooded EHL film")
def ehl_rolling_power(alpha: PerPascal, G: Number, U: Number, W: Number, R: Metre, Phi: Number, u_e: MetrePerSecond) -> WattPerMetre:
    return 4.318 / alpha * (G * U) ** 0.658 * W**0.0126 * R * Phi * u_e
