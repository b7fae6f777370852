# SPDX-License-Identifier: Apache-2.0
"""Units: as types inside the formulas, as suffixes of the keys at the border.

Inside the program every number is in SI (temperatures in °C, speeds in revolutions per second).  A `Unit` says how such
a number is shown and which ending its key has in a design file: `mm` → `bore_mm`."""

from typing import Annotated

from .arrays import Array, ComplexArray, IndexArray, Value

# --- units as types: a float to the type checker, a unit to the formula

Number = Annotated[float, ""]
Metre = Annotated[float, "m"]
SquareMetre = Annotated[float, "m²"]
CubicMetre = Annotated[float, "m³"]
Metre4 = Annotated[float, "m⁴"]
Kilogram = Annotated[float, "kg"]
Second = Annotated[float, "s"]
Radian = Annotated[float, "rad"]
RevPerSecond = Annotated[float, "1/s"]
RadPerSecond = Annotated[float, "rad/s"]
RadPerSecond2 = Annotated[float, "rad/s²"]
MetrePerSecond = Annotated[float, "m/s"]
MetrePerSecond2 = Annotated[float, "m/s²"]
MetrePerSecond3 = Annotated[float, "m/s³"]
Newton = Annotated[float, "N"]
PerMetre = Annotated[float, "1/m"]
NewtonPerMetre = Annotated[float, "N/m"]
NewtonSecondPerMetre = Annotated[float, "N·s/m"]
NewtonMetre = Annotated[float, "N·m"]
NewtonMetrePerRadian = Annotated[float, "N·m/rad"]
NewtonMetre2 = Annotated[float, "N·m²"]
Pascal = Annotated[float, "Pa"]
PascalSecond = Annotated[float, "Pa·s"]
PerPascal = Annotated[float, "1/Pa"]
PascalMetrePerSecond = Annotated[float, "Pa·m/s"]  # p·v of a bearing
Watt = Annotated[float, "W"]
WattPerMetre = Annotated[float, "W/m"]
Celsius = Annotated[float, "°C"]
Euro = Annotated[float, "€"]
Kelvin = Annotated[float, "K"]
PerKelvin = Annotated[float, "1/K"]
KelvinPerWatt = Annotated[float, "K/W"]
KilogramMetre = Annotated[float, "kg·m"]
KilogramPerMetre = Annotated[float, "kg/m"]
Hertz = Annotated[float, "1/s"]
PhasorHertz = Annotated[complex, "1/s"]
PerSecond2 = Annotated[float, "1/s²"]  # of a squared angular frequency
PhasorNumber = Annotated[complex, ""]
PhasorMetre = Annotated[complex, "m"]
PhasorSquareMetre = Annotated[complex, "m²"]
PhasorCubicMetre = Annotated[complex, "m³"]
PhasorMetre4 = Annotated[complex, "m⁴"]
PhasorKilogramMetre = Annotated[complex, "kg·m"]
PhasorKilogramMetre2 = Annotated[complex, "kg·m²"]
PhasorNewton = Annotated[complex, "N"]
PhasorNewtonMetre = Annotated[complex, "N·m"]
PhasorNewtonPerMetre = Annotated[complex, "N/m"]
KilogramMetre2 = Annotated[float, "kg·m²"]
KilogramPerMetre3 = Annotated[float, "kg/m³"]
SquareMetrePerSecond = Annotated[float, "m²/s"]
CubicMetrePerSecond = Annotated[float, "m³/s"]
JoulePerKilogramKelvin = Annotated[float, "J/(kg·K)"]
WattPerMetreKelvin = Annotated[float, "W/(m·K)"]
NewtonPerMetreSecond = Annotated[float, "N/(m·s)"]  # heat index: load per length times speed

# arrays and tuples, where a formula takes or gives nothing else

MetreTuple = Annotated[tuple[float, ...], "m"]
Numbers = Annotated[Array, ""]
Places = Annotated[IndexArray, ""]
Metres = Annotated[Array, "m"]
SquareMetres = Annotated[Array, "m²"]
Metres4 = Annotated[Array, "m⁴"]
Kelvins = Annotated[Array, "K"]
Kilograms = Annotated[Array, "kg"]
KilogramsPerMetre = Annotated[Array, "kg/m"]
KilogramMetres2 = Annotated[Array, "kg·m²"]
Radians = Annotated[Array, "rad"]
RadiansPerMetre = Annotated[Array, "rad/m"]
RadiansPerSecond = Annotated[Array, "rad/s"]
Newtons = Annotated[Array, "N"]
NewtonsPerMetre = Annotated[Array, "N/m"]
NewtonMetres2 = Annotated[Array, "N·m²"]
NewtonMetres = Annotated[Array, "N·m"]
Hertzes = Annotated[Array, "1/s"]
PerSeconds2 = Annotated[Array, "1/s²"]
MetresPerSecond2 = Annotated[Array, "m/s²"]
MetresPerSecond = Annotated[Array, "m/s"]
Watts = Annotated[Array, "W"]
WattsPerMetre = Annotated[Array, "W/m"]
CelsiusArray = Annotated[Array, "°C"]
Pascals = Annotated[Array, "Pa"]
PhasorMetres = Annotated[ComplexArray, "m"]
PhasorCubicMetres = Annotated[ComplexArray, "m³"]
PhasorMetres4 = Annotated[ComplexArray, "m⁴"]
PhasorNewtons = Annotated[ComplexArray, "N"]
KilogramMetres = Annotated[Array, "kg·m"]
PhasorKilogramMetres = Annotated[ComplexArray, "kg·m"]
PhasorSquareMetres = Annotated[ComplexArray, "m²"]
PhasorNumbers = Annotated[ComplexArray, ""]
PhasorRadians = Annotated[ComplexArray, "rad"]
PhasorNewtonMetres = Annotated[ComplexArray, "N·m"]
PhasorNewtonsPerMetre = Annotated[ComplexArray, "N/m"]


# what is inside in another unit than it is shown
INSIDE = {
    "": ("%", "‰"),
    "m": ("mm", "µm"),
    "m²": ("mm²",),
    "m³": ("mm³", "cm³", "L"),
    "m⁴": ("mm⁴",),
    "m/s": ("mm/s", "km/h"),
    "m/s/N": ("mm/s/N",),
    "m²/s": ("mm²/s",),
    "m²/N": ("mm²/N",),
    "m³/s": ("L/min",),
    "kg": ("g",),
    "kg/s": ("g/h",),
    "kg/J": ("g/kWh",),
    "kg·m": ("g·mm", "kg·mm"),
    "kg·m²": ("kg·mm²",),
    "s": ("h",),
    "rad": ("°", "mrad"),
    "1/s": ("rpm",),
    "N": ("kN",),
    "N/m": ("N/mm", "kN/mm"),
    "N·m": ("N·mm",),
    "N·m/rad": ("N·m/°",),
    "N·s/m": ("N·s/mm",),
    "N/(m·s)": ("N·rpm/mm",),
    "Pa": ("bar", "MPa", "GPa"),
    "Pa·s": ("mPa·s",),
    "Pa·m/s": ("MPa·m/s",),
    "1/Pa": ("1/GPa",),
    "W": ("kW",),
    "1/K": ("10⁻⁶/K",),
}


class Unit:
    """How a quantity is shown: `shown = inside / factor`; `suffix` ends its key in a design file, `inside_symbol` is
    the unit in which Python has it."""

    __slots__ = ("factor", "inside_symbol", "suffix", "symbol")

    def __init__(self, symbol: str, suffix: str, factor: float) -> None:
        self.symbol, self.suffix, self.factor = symbol, suffix, factor
        self.inside_symbol = next((inside for inside, shown in INSIDE.items() if symbol in shown), symbol)

    def shown(self, inside: float) -> float:
        """The number as the user sees it, without the last digits that the conversion itself makes."""
        return float(f"{inside / self.factor:.14g}")

    def all_shown(self, inside: Value) -> Value:
        """The same for an array, with all its digits."""
        return inside / self.factor

    def inside(self, shown: float) -> float:
        """The SI number; by a division where the factor is a whole part (mm, µm, rpm), which keeps the last digit
        right."""
        parts = 1 / self.factor
        return shown / round(parts) if parts > 1 and abs(parts - round(parts)) < 1e-6 * parts else shown * self.factor


PI = 3.141592653589793
_ROWS = (  # symbol, suffix of keys, factor
    ("", "", 1.0),
    ("mm", "_mm", 1e-3),
    ("µm", "_um", 1e-6),
    ("m", "_m", 1.0),
    ("cm³", "_cm3", 1e-6),
    ("mm²", "_mm2", 1e-6),
    ("mm³", "_mm3", 1e-9),
    ("mm⁴", "_mm4", 1e-12),
    ("g", "_g", 1e-3),
    ("kg", "_kg", 1.0),
    ("g·mm", "_gmm", 1e-6),
    ("kg·mm", "_kgmm", 1e-3),
    ("kg·mm²", "_kgmm2", 1e-6),
    ("kg·m²", "_kgm2", 1.0),
    ("°", "_deg", PI / 180),
    ("mrad", "_mrad", 1e-3),
    ("rpm", "_rpm", 1 / 60),
    ("1/s", "_1_s", 1.0),
    ("Hz", "_Hz", 1.0),
    ("rad/s", "_rad_s", 1.0),
    ("rad/s²", "_rad_s2", 1.0),
    ("mm/s", "_mm_s", 1e-3),
    ("mm/s/N", "_mm_s_N", 1e-3),
    ("m/s", "_m_s", 1.0),
    ("km/h", "_km_h", 1 / 3.6),
    ("m/s²", "_m_s2", 1.0),
    ("N", "_N", 1.0),
    ("kN", "_kN", 1e3),
    ("N·m", "_Nm", 1.0),
    ("N·mm", "_Nmm", 1e-3),
    ("N·m/°", "_Nm_deg", 180 / PI),
    ("N/mm", "_N_mm", 1e3),
    ("kN/mm", "_kN_mm", 1e6),
    ("N/m", "_N_m", 1.0),
    ("N·s/m", "_Ns_m", 1.0),
    ("N·s/mm", "_Ns_mm", 1e3),
    ("MPa", "_MPa", 1e6),
    ("GPa", "_GPa", 1e9),
    ("1/GPa", "_1_GPa", 1e-9),
    ("mm²/N", "_mm2_N", 1e-6),
    ("bar", "_bar", 1e5),
    ("MPa·m/s", "_MPa_m_s", 1e6),
    ("mPa·s", "_mPas", 1e-3),
    ("mm²/s", "_mm2_s", 1e-6),
    ("N·rpm/mm", "_Nrpm_mm", 1000 / 60),
    ("J", "_J", 1.0),
    ("W", "_W", 1.0),
    ("kW", "_kW", 1e3),
    ("K", "_K", 1.0),
    ("K/W", "_K_W", 1.0),
    ("W/K", "_W_K", 1.0),
    ("°C", "_C", 1.0),
    ("10⁻⁶/K", "_1e6_K", 1e-6),
    ("kg/m³", "_kgm3", 1.0),
    ("L", "_L", 1e-3),
    ("L/min", "_L_min", 1e-3 / 60),
    ("J/(kg·K)", "_J_kgK", 1.0),
    ("W/(m·K)", "_W_mK", 1.0),
    ("g/kWh", "_g_kWh", 1e-3 / 3.6e6),
    ("g/h", "_g_h", 1e-3 / 3600),
    ("h", "_h", 3600.0),
    ("‰", "_permille", 1e-3),
    ("%", "_percent", 1e-2),
    ("HV", "_HV", 1.0),
    ("€", "_EUR", 1.0),
)
UNITS = {symbol: Unit(symbol, suffix, factor) for symbol, suffix, factor in _ROWS}
