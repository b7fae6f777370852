# SPDX-License-Identifier: Apache-2.0
"""The units that a person may type behind a number, by the unit of the field: words and their factors to the SI unit."""

from typing import Any

PI = 3.141592653589793
INCH, POUND, GRAVITY = 0.0254, 0.45359237, 9.80665

# fmt: off
LENGTH = {
    "m": 1.0, "dm": 0.1, "cm": 1e-2, "mm": 1e-3, "µm": 1e-6, "um": 1e-6, "micron": 1e-6, "nm": 1e-9,
    "in": INCH, '"': INCH, "inch": INCH, "ft": 12 * INCH, "feet": 12 * INCH, "thou": INCH / 1000, "mil": INCH / 1000,
}
PRESSURE = {
    "Pa": 1.0, "hPa": 1e2, "kPa": 1e3, "MPa": 1e6, "GPa": 1e9, "N/mm²": 1e6, "bar": 1e5, "mbar": 1e2, "atm": 101325.0,
    "psi": POUND * GRAVITY / INCH**2, "ksi": 1000 * POUND * GRAVITY / INCH**2, "kgf/cm²": GRAVITY * 1e4, "at": GRAVITY * 1e4,
}
FORCE = {"N": 1.0, "daN": 10.0, "kN": 1e3, "kgf": GRAVITY, "lbf": POUND * GRAVITY}
MASS = {"kg": 1.0, "g": 1e-3, "mg": 1e-6, "t": 1e3, "lb": POUND, "lbs": POUND, "oz": POUND / 16}
TORQUE = {
    "N·m": 1.0, "Nm": 1.0, "N·mm": 1e-3, "Nmm": 1e-3, "daNm": 10.0, "kN·m": 1e3, "kNm": 1e3, "kgf·m": GRAVITY,
    "lbf·ft": POUND * GRAVITY * 12 * INCH, "lb·ft": POUND * GRAVITY * 12 * INCH,
    "lbf·in": POUND * GRAVITY * INCH, "lb·in": POUND * GRAVITY * INCH,
}
UNBALANCE = {"g·mm": 1e-6, "gmm": 1e-6, "g·cm": 1e-5, "kg·mm": 1e-3, "kgmm": 1e-3, "kg·m": 1.0, "oz·in": POUND / 16 * INCH}
INERTIA = {"kg·mm²": 1e-6, "kgmm²": 1e-6, "kg·cm²": 1e-4, "kg·m²": 1.0, "kgm²": 1.0, "g·mm²": 1e-9}
TURNS = {
    "rpm": 1 / 60, "1/min": 1 / 60, "min⁻¹": 1 / 60, "r/min": 1 / 60, "U/min": 1 / 60, "giri/min": 1 / 60,
    "1/s": 1.0, "Hz": 1.0, "rad/s": 0.5 / PI,
}
ANGLE = {
    "°": PI / 180, "deg": PI / 180, "rad": 1.0, "mrad": 1e-3, "µrad": 1e-6, "mm/m": 1e-3,
    "'": PI / 10800, "arcmin": PI / 10800, "gon": PI / 200,
}
POWER = {"W": 1.0, "kW": 1e3, "mW": 1e-3, "MW": 1e6, "hp": 745.69987, "PS": 735.49875, "CV": 735.49875}
CELSIUS = {  # factor and zero point
    "°C": (1.0, 0.0), "C": (1.0, 0.0), "degC": (1.0, 0.0), "K": (1.0, -273.15),
    "°F": (5 / 9, -160 / 9), "F": (5 / 9, -160 / 9), "degF": (5 / 9, -160 / 9),
}
SHARE = {"": 1.0, "%": 1e-2, "‰": 1e-3}
FLOW = {"m³/s": 1.0, "L/min": 1e-3 / 60, "L/s": 1e-3, "L/h": 1e-3 / 3600, "cm³/s": 1e-6, "m³/h": 1 / 3600}

UNIT_WORDS: dict[str, dict[str, Any]] = {
    "mm": LENGTH, "µm": LENGTH, "m": LENGTH,
    "cm³": {"cm³": 1e-6, "ccm": 1e-6, "cc": 1e-6, "L": 1e-3, "dm³": 1e-3, "mm³": 1e-9, "m³": 1.0, "in³": INCH**3},
    "mm³": {"mm³": 1e-9, "cm³": 1e-6, "m³": 1.0},
    "mm⁴": {"mm⁴": 1e-12, "cm⁴": 1e-8, "m⁴": 1.0},
    "mm²": {"mm²": 1e-6, "cm²": 1e-4, "m²": 1.0, "in²": INCH**2},
    "g": MASS, "kg": MASS,
    "g·mm": UNBALANCE, "kg·mm": UNBALANCE,
    "kg·mm²": INERTIA, "kg·m²": INERTIA,
    "°": ANGLE, "mrad": ANGLE,
    "rpm": TURNS, "1/s": TURNS,
    "rad/s": {name: 2 * PI * factor for name, factor in TURNS.items()} | {"rad/s": 1.0},
    "Hz": {"Hz": 1.0, "1/s": 1.0, "kHz": 1e3, "rpm": 1 / 60, "1/min": 1 / 60},
    "mm/s": {"mm/s": 1e-3, "m/s": 1.0, "in/s": INCH}, "mm/s/N": {"mm/s/N": 1e-3, "m/s/N": 1.0},
    "N·s/mm": {"N·s/mm": 1e3, "Ns/mm": 1e3, "N·s/m": 1.0, "Ns/m": 1.0},
    "m/s": {"m/s": 1.0, "mm/s": 1e-3, "km/h": 1 / 3.6, "ft/s": 12 * INCH},
    "m/s²": {"m/s²": 1.0, "g": GRAVITY},
    "N": FORCE, "N·m": TORQUE,
    "N/m": {"N/m": 1.0, "N/mm": 1e3, "kN/m": 1e3, "N/µm": 1e6},
    "N·s/m": {"N·s/m": 1.0, "Ns/m": 1.0, "N·s/mm": 1e3, "Ns/mm": 1e3},
    "N/mm": {"N/mm": 1e3, "N/m": 1.0, "kN/m": 1e3, "N/µm": 1e6},
    "MPa": PRESSURE, "GPa": PRESSURE, "bar": PRESSURE,
    "1/GPa": {"1/GPa": 1e-9, "GPa⁻¹": 1e-9, "1/MPa": 1e-6, "1/Pa": 1.0, "mm²/N": 1e-6},
    "mm²/N": {"mm²/N": 1e-6, "1/MPa": 1e-6, "1/GPa": 1e-9, "1/Pa": 1.0},
    "MPa·m/s": {"MPa·m/s": 1e6, "N/mm²·m/s": 1e6},
    "mPa·s": {"mPa·s": 1e-3, "Pa·s": 1.0, "cP": 1e-3, "P": 0.1},
    "mm²/s": {"mm²/s": 1e-6, "cSt": 1e-6, "St": 1e-4, "m²/s": 1.0},
    "N·rpm/mm": {"N·rpm/mm": 1000 / 60, "N·rpm/cm": 100 / 60},
    "W": POWER, "kW": POWER, "J": {"J": 1.0, "kJ": 1e3, "N·m": 1.0, "Nm": 1.0, "W·h": 3600.0, "Wh": 3600.0, "kWh": 3.6e6},
    "K": {"K": 1.0},
    "°C": CELSIUS,
    "10⁻⁶/K": {"10⁻⁶/K": 1e-6, "1e-6/K": 1e-6, "ppm/K": 1e-6, "µm/(m·K)": 1e-6, "1/K": 1.0},
    "kg/m³": {"kg/m³": 1.0, "g/cm³": 1e3, "kg/dm³": 1e3, "kg/L": 1e3, "g/L": 1.0},
    "L/min": FLOW,
    "J/(kg·K)": {"J/(kg·K)": 1.0, "J/kgK": 1.0, "kJ/(kg·K)": 1e3, "kJ/kgK": 1e3},
    "K/W": {"K/W": 1.0, "K/kW": 1e-3},
    "L": {"L": 1e-3, "l": 1e-3, "mL": 1e-6, "m³": 1.0},
    "W/(m·K)": {"W/(m·K)": 1.0, "W/mK": 1.0},
    "g/kWh": {"g/kWh": 1e-3 / 3.6e6, "kg/kWh": 1 / 3.6e6},
    "g/h": {"g/h": 1e-3 / 3600, "kg/h": 1 / 3600},
    "h": {"h": 3600.0, "min": 60.0, "s": 1.0, "d": 86400.0},
    "HV": {"HV": 1.0},
    "€": {"€": 1.0, "EUR": 1.0, "k€": 1e3, "kEUR": 1e3},
    "‰": SHARE, "%": SHARE, "": SHARE,
}
# fmt: on
