# SPDX-License-Identifier: Apache-2.0
"""Two routes to the film: the source's second method, which it calls DIN 31652, and the standard's own, ISO 7902.

The source's method takes the film by Falz's rule and the friction by the standard's polynomial.  The rule is not the
standard's: at the same So its film is 0.50 to 1.75 times that of Reynolds' equation for l/d 0.4 to 1 and ε 0.1 to 0.95,
up to 2.2 times at l/d ¼, where it may also give none.  Its two formulas do not meet at So = 1 unless l = d; the
source's own choice (So above or below 1) is kept.  Friction by the polynomial only where it holds (l/d ≤ 0.55, or 1);
elsewhere by the identity of Reynolds' solution."""

from ....sheet.formula import formula
from ....sheet.functions import atan, log10, pi, root, sqrt
from ....sheet.text import Amount, Text
from ....sheet.units import Metre, Number, Radian
from ....sheet.value import based_on
from .states import OutsideCharts

POLYNOMIAL_UP_TO = 0.55
FALZ = Text("Finotti 2013, 5.5.3, Falz's rule (there called DIN 31652)")
POLYNOMIAL = Text("DIN 31652-1 as printed in Finotti 2013, 5.5.3")


@formula("h_0", FALZ + ", So > 1", unit="µm", names={"b": "(l/d)"})
def film_heavily_loaded(g: Metre, So: Number, b: Number) -> Metre:
    return g / 2 / (2 * So) * (2 * b / (1 + b))


@formula("h_0", FALZ + ", So ≤ 1", unit="µm", names={"b": "(l/d)"})
def film_lightly_loaded(g: Metre, So: Number, b: Number) -> Metre:
    return g / 2 * (1 - So / 2 * ((1 + b) / (2 * b)))


def film(g: Metre, So: Number, b: Number) -> Metre:
    """Falz's film by the source's own rule."""
    return film_heavily_loaded(g=g, So=So, b=b) if So > 1 else film_lightly_loaded(g=g, So=So, b=b)


@formula("C", POLYNOMIAL, names={"b": "(l/d)"})
def coefficient_C(b: Number) -> Number:
    return 1.153423 - 2.69332 * b + 6.552763 * b**2 - 7.81938 * b**3 + 3.405146 * b**4


@formula("E", POLYNOMIAL, names={"b": "(l/d)"})
def coefficient_E(b: Number) -> Number:
    return -0.7441784 + 0.104245 * b - 0.343503 * b**2 + 0.4677244 * b**3 - 0.215028 * b**4


@formula("F", POLYNOMIAL, names={"b": "(l/d)"})
def coefficient_F(b: Number) -> Number:
    return -0.0105921 + 0.342048 * b - 0.459955 * b**2 + 0.381193 * b**3 - 0.1056112 * b**4


@formula("G", POLYNOMIAL, names={"b": "(l/d)"})
def coefficient_G(b: Number) -> Number:
    return -0.000397154 - 0.01669 * b + 0.00966612 * b**2 - 0.0191126 * b**3 - 0.01094135 * b**4


@formula("H", POLYNOMIAL, names={"b": "(l/d)"})
def coefficient_H(b: Number) -> Number:
    return -0.00258444 - 0.00870384 * b - 0.00157289 * b**2 + 0.01759905 * b**3 - 0.00668883 * b**4


@formula("s", POLYNOMIAL)
def log_sommerfeld(So: Number) -> Number:
    return log10(So)


@formula(
    "Y",
    POLYNOMIAL,
    names={"F": "F_Y"},
    meanings={
        "C": "Coefficient of the approximation",
        "E": "Coefficient of the approximation",
        "F": "Coefficient of the approximation",
        "G": "Coefficient of the approximation",
        "H": "Coefficient of the approximation",
    },
)
def friction_exponent(C: Number, E: Number, F: Number, G: Number, H: Number, s: Number) -> Number:
    return C + E * s + F * s**2 + G * s**3 + H * s**4


@formula("f", POLYNOMIAL)
def friction_coefficient(psi: Number, Y: Number) -> Number:
    return psi * 10**Y


def friction(psi: Number, So: Number, b: Number) -> tuple[Number, Number]:
    """Y and f by the polynomial; its coefficients depend on l/d alone and are not traced one by one."""
    C, E, F, G, H = (
        based_on(c.function(b), b) for c in (coefficient_C, coefficient_E, coefficient_F, coefficient_G, coefficient_H)
    )
    Y = friction_exponent(C, E, F, G, H, s=log_sommerfeld(So))
    return Y, friction_coefficient(psi=psi, Y=Y)


def polynomial_holds(b: float) -> bool:
    return b <= POLYNOMIAL_UP_TO or abs(b - 1) < 1e-9


# --- the standard's own route
# ISO 7902-1 with the functions of ISO 7902-2 for a full bearing (DIN 31652 is its German forerunner).
#
# Film by So(ε, B/D), friction of the full film, the angle β from load to narrowest film, side flow by geometry and flow
# by the supply pressure (`flow`, `supply`).  Closed forms after Butenschön 1976, which the standard takes over; the
# coefficients were read in two public programs that use them, not in the standard.  Against Reynolds' equation
# (`film.reynolds`) for ε 0.1 to 0.95: So −3 … +7 % for B/D ¼ to ½ and −3 … +5 % at 1, but −11 % between; beyond 1 it
# loses all use (+71 % at 1.25), so that there this route gives nothing.

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
        b**2
        * eps
        / (2 * (1 - eps**2) ** 2)
        * sqrt(pi**2 * (1 - eps**2) + 16 * eps**2)
        * (1.1642 - 1.9456 * b + 7.1161 * b**2 - 10.1073 * b**3 + 5.0141 * b**4)
        * (eps - 1)
        / (-1.000026 - 0.023634 * b - 0.4215 * b**2 - 0.038817 * b**3 - 0.090551 * b**4 + eps)
    )


@formula("ε", FITTED, shows="ε at which the standard's So(ε, B/D) is So, bracketed", names={"b": "(B/D)"})
def eccentricity(So: Number, b: Number) -> Number:
    """>>> eccentricity(So=1.0, b=0.5)
    0.7227199...
    """
    if not SHORTEST <= b <= LONGEST:
        at, low, high = (Amount(x, form=".3g") for x in (b, SHORTEST, LONGEST))
        raise OutsideCharts(
            Text("B/D = {b} is outside what its functions are good for ({low} to {high})", b=at, low=low, high=high)
        )
    of = sommerfeld.function
    if not of(LEAST, b) <= So <= of(MOST, b):
        raise OutsideCharts(
            Text("no ε from {least} to {most} has So = {so}", least=LEAST, most=MOST, so=Amount(So, form=".3g"))
        )
    return root(lambda eps: of(eps, b) - So, LEAST, MOST, tolerance=1e-12)


@formula("β", FITTED, unit="°", names={"b": "(B/D)"})
def attitude_angle(eps: Number, b: Number) -> Radian:
    """From the load to the narrowest film."""
    return (
        1.152624
        - 0.104565 * b
        + (-2.5905 + 0.798745 * b) * eps
        + (8.73393 - 2.3291 * b) * eps**2
        + (-13.3414 + 3.424337 * b) * eps**3
        + (6.6294 - 1.591732 * b) * eps**4
    ) * atan(pi * sqrt(1 - eps**2) / (2 * eps))
