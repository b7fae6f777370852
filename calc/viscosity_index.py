# SPDX-License-Identifier: Apache-2.0
"""The viscosity index: how little an oil thins with heat, beside two series of reference oils of the same viscosity at 100 °C."""

from .sheet.formula import formula
from .sheet.functions import log10
from .sheet.units import Number, SquareMetrePerSecond

SQUARE_MILLIMETRE_PER_SECOND: SquareMetrePerSecond = 1e-6
LOWEST = 2e-6  # m²/s at 100 °C: below it the index is not defined

# ASTM D2270, X2: L = a·Y² + b·Y + c, H = d·Y² + e·Y + f, up to Y mm²/s at 100 °C; from memory, held against its table by the tests.  From
# 55 to 70 mm²/s the last row, which the standard has for what is above 70, is within 0.3 % of the table.
REFERENCE_OILS = (
    (3.8, 1.14673, 1.7576, -0.109, 0.84155, 1.5521, -0.077),
    (4.4, 3.38095, -15.4952, 33.196, 0.78571, 1.7929, -0.183),
    (5.0, 2.5, -7.2143, 13.812, 0.82143, 1.5679, 0.119),
    (6.4, 0.101, 16.635, -45.469, 0.04985, 9.1613, -18.557),
    (7.0, 3.35714, -23.5643, 78.466, 0.22619, 7.7369, -16.656),
    (7.7, 0.01191, 21.475, -72.87, 0.79762, -0.7321, 14.61),
    (9.0, 0.41858, 16.1558, -56.04, 0.05794, 10.5156, -28.24),
    (12.0, 0.88779, 7.5527, -16.6, 0.26665, 6.7015, -10.81),
    (15.0, 0.7672, 10.7972, -38.18, 0.20073, 8.4658, -22.49),
    (18.0, 0.97305, 5.3135, -2.2, 0.28889, 5.9741, -4.93),
    (22.0, 0.97256, 5.25, -0.98, 0.24504, 7.416, -16.73),
    (28.0, 0.91413, 7.4759, -21.82, 0.20323, 9.1267, -34.23),
    (40.0, 0.87031, 9.7157, -50.77, 0.18411, 10.1015, -46.75),
    (55.0, 0.84703, 12.6752, -133.31, 0.17029, 11.4866, -80.62),
    (float("inf"), 0.83531, 14.6731, -216.246, 0.16841, 11.8493, -96.947),
)


@formula("L", "ASTM D2270, X2: oil of index 0 with the same viscosity at 100 °C", shows="by rows", unit="mm²/s", names={"nu_100": "ν_100"})
def of_index_0(nu_100: SquareMetrePerSecond) -> SquareMetrePerSecond:
    Y = nu_100 / SQUARE_MILLIMETRE_PER_SECOND
    a, b, c = next(row[1:4] for row in REFERENCE_OILS if row[0] >= Y)
    return (a * Y**2 + b * Y + c) * SQUARE_MILLIMETRE_PER_SECOND


@formula(
    "H", "ASTM D2270, X2: oil of index 100 with the same viscosity at 100 °C", shows="by rows", unit="mm²/s", names={"nu_100": "ν_100"}
)
def of_index_100(nu_100: SquareMetrePerSecond) -> SquareMetrePerSecond:
    Y = nu_100 / SQUARE_MILLIMETRE_PER_SECOND
    d, e, f = next(row[4:7] for row in REFERENCE_OILS if row[0] >= Y)
    return (d * Y**2 + e * Y + f) * SQUARE_MILLIMETRE_PER_SECOND


@formula("VI", "ASTM D2270, procedure A, up to 100", names={"nu_40": "ν_40"})
def index_up_to_100(L: SquareMetrePerSecond, nu_40: SquareMetrePerSecond, H: SquareMetrePerSecond) -> Number:
    return 100 * (L - nu_40) / (L - H)


@formula("N", "ASTM D2270, procedure B", names={"nu_40": "ν_40", "nu_100": "ν_100"})
def exponent(H: SquareMetrePerSecond, nu_40: SquareMetrePerSecond, nu_100: SquareMetrePerSecond) -> Number:
    return log10(H / nu_40) / log10(nu_100 / SQUARE_MILLIMETRE_PER_SECOND)


@formula("VI", "ASTM D2270, procedure B, above 100")
def index_above_100(N: Number) -> Number:
    return (10**N - 1) / 0.00715 + 100


def viscosity_index(nu_40: SquareMetrePerSecond, nu_100: SquareMetrePerSecond) -> Number | None:
    """The viscosity index; None below 2 mm²/s at 100 °C."""
    if nu_100 < LOWEST:
        return None
    H = of_index_100(nu_100=nu_100)
    if nu_40 < H:
        return index_above_100(N=exponent(H=H, nu_40=nu_40, nu_100=nu_100))
    return index_up_to_100(L=of_index_0(nu_100=nu_100), nu_40=nu_40, H=H)
