# SPDX-License-Identifier: Apache-2.0
"""The standard's own route: ISO 7902-1 with the functions of ISO 7902-2 for a full bearing (DIN 31652 is its German forerunner).

Film by So(ε, B/D), friction of the full film, the angle β from load to narrowest film, side flow by geometry and flow by the supply
pressure (`flow`, `supply`).  Closed forms after Butenschön 1976, which the standard takes over; the coefficients were read in two public
programs that use them, not in the standard.  Against Reynolds' equation (`film.reynolds`) for ε 0.1 to 0.95: So −3 … +7 % for B/D ¼ to
½ and −3 … +5 % at 1, but −11 % between; beyond 1 it loses all use (+71 % at 1.25), so that there this route gives nothing.
"""

from ...root import root
from ...sheet.formula import formula
from ...sheet.functions import atan, pi, sqrt
from ...sheet.text import Amount, Text
from ...sheet.units import Number, Radian
from .states import OutsideCharts

SHORTEST, LONGEST = 0.1, 1.0  # B/D
FITTED_UP_TO = 0.6  # B/D from which its So falls behind
LEAST, MOST = 1e-3, 0.999  # ε that is looked for
FITTED = Text("ISO 7902-2, after Butenschön 1976 (coefficients as read in public programs)")


@formula("So", FITTED, names={"b": "(B/D)"})
def sommerfeld(eps: Number, b: Number) -> Number:
    """The short bearing's, times what its length takes away.

    >>> sommerfeld(eps=0.7, b=0.5)
    0.8638448...
    """
    return (
        b**2 * eps / (2 * (1 - eps**2) ** 2) * sqrt(pi**2 * (1 - eps**2) + 16 * eps**2)
        * (1.1642 - 1.9456 * b + 7.1161 * b**2 - 10.1073 * b**3 + 5.0141 * b**4) * (eps - 1)
        / (-1.000026 - 0.023634 * b - 0.4215 * b**2 - 0.038817 * b**3 - 0.090551 * b**4 + eps)
    )  # fmt: skip


@formula("ε", FITTED, shows="ε at which the standard's So(ε, B/D) is So, bracketed", names={"b": "(B/D)"})
def eccentricity(So: Number, b: Number) -> Number:
    """>>> eccentricity(So=1.0, b=0.5)
    0.7227199...
    """
    if not SHORTEST <= b <= LONGEST:
        at, low, high = (Amount(x, form=".3g") for x in (b, SHORTEST, LONGEST))
        raise OutsideCharts(Text("B/D = {b} is outside what its functions are good for ({low} to {high})", b=at, low=low, high=high))
    of = sommerfeld.function
    if not of(LEAST, b) <= So <= of(MOST, b):
        raise OutsideCharts(Text("no ε from {least} to {most} has So = {so}", least=LEAST, most=MOST, so=Amount(So, form=".3g")))
    return root(lambda eps: of(eps, b) - So, LEAST, MOST, tolerance=1e-12)


@formula("β", FITTED, unit="°", names={"b": "(B/D)"})
def attitude_angle(eps: Number, b: Number) -> Radian:
    """From the load to the narrowest film."""
    return (
        1.152624 - 0.104565 * b + (-2.5905 + 0.798745 * b) * eps + (8.73393 - 2.3291 * b) * eps**2
        + (-13.3414 + 3.424337 * b) * eps**3 + (6.6294 - 1.591732 * b) * eps**4
    ) * atan(pi * sqrt(1 - eps**2) / (2 * eps))  # fmt: skip
