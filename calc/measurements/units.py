# SPDX-License-Identifier: Apache-2.0
"""The units in which benches measure: those of this program, what else there is, and how programs spell them."""

from difflib import get_close_matches

from ..sheet.record import record
from ..sheet.units import PI, UNITS


@record
class BenchUnit:
    """`inside = factor · (number + zero)`; `symbol`: the unit inside, by which dimensions are told apart."""

    symbol: str
    factor: float
    zero: float = 0.0


POUND, GRAVITY, INCH = 0.45359237, 9.80665, 0.0254  # exact by definition: kg, m/s², m
# beside those of the program; of several meanings the dimension decides
FURTHER: dict[str, tuple[BenchUnit, ...]] = {
    "°F": (BenchUnit("°C", 5 / 9, -32.0),),
    "psi": (BenchUnit("Pa", POUND * GRAVITY / INCH**2),),
    "Pa": (BenchUnit("Pa", 1.0),),
    "hPa": (BenchUnit("Pa", 1e2),),
    "mbar": (BenchUnit("Pa", 1e2),),
    "kPa": (BenchUnit("Pa", 1e3),),
    "in": (BenchUnit("m", INCH),),
    "inch": (BenchUnit("m", INCH),),
    "cm": (BenchUnit("m", 1e-2),),
    "in/s": (BenchUnit("m/s", INCH),),
    "g": (BenchUnit("kg", 1e-3), BenchUnit("m/s²", GRAVITY)),  # of an acceleration that of gravity
    "g_n": (BenchUnit("m/s²", GRAVITY),),
    "mm/s²": (BenchUnit("m/s²", 1e-3),),
    "lb": (BenchUnit("kg", POUND),),
    "lbf": (BenchUnit("N", POUND * GRAVITY),),
    "lbf·ft": (BenchUnit("N·m", POUND * GRAVITY * 12 * INCH),),
    "lbf·in": (BenchUnit("N·m", POUND * GRAVITY * INCH),),
    "hp": (BenchUnit("W", 550 * 12 * INCH * POUND * GRAVITY),),
    "PS": (BenchUnit("W", 75 * GRAVITY),),
    "mW": (BenchUnit("W", 1e-3),),
    "cm³/s": (BenchUnit("m³/s", 1e-6),),
    "cm³/min": (BenchUnit("m³/s", 1e-6 / 60),),
    "mL/min": (BenchUnit("m³/s", 1e-6 / 60),),
    "L/h": (BenchUnit("m³/s", 1e-3 / 3600),),
    "L/s": (BenchUnit("m³/s", 1e-3),),
    "m³/h": (BenchUnit("m³/s", 1 / 3600),),
    "min": (BenchUnit("s", 60.0),),
    "s": (BenchUnit("s", 1.0),),
    "ms": (BenchUnit("s", 1e-3),),
    "rad": (BenchUnit("rad", 1.0),),
    "Hz": (BenchUnit("Hz", 1.0), BenchUnit("1/s", 1.0)),  # of a speed, turns a second
    "rad/s": (BenchUnit("rad/s", 1.0), BenchUnit("1/s", 1 / (2 * PI))),
    "cSt": (BenchUnit("m²/s", 1e-6),),
    "cP": (BenchUnit("Pa·s", 1e-3),),
}
# how programs write them, without capitals and blanks
SPELLINGS = {
    "-": "", "1": "", "none": "", "[-]": "",
    "1/min": "rpm", "min-1": "rpm", "min^-1": "rpm", "u/min": "rpm", "r/min": "rpm", "rev/min": "rpm", "min⁻¹": "rpm",
    "c": "°C", "degc": "°C", "deg_c": "°C", "celsius": "°C", "f": "°F", "degf": "°F", "deg_f": "°F",
    "deg": "°", "nm": "N·m", "n*m": "N·m", "n.m": "N·m", "n-m": "N·m", "nmm": "N·mm", "n*mm": "N·mm",
    "um": "µm", "μm": "µm", "micron": "µm", "l/min": "L/min", "lpm": "L/min", "l/h": "L/h", "l/s": "L/s",
    "ml/min": "mL/min", "cc/min": "cm³/min", "m/s2": "m/s²", "m/s^2": "m/s²", "m/s**2": "m/s²", "mm/s2": "mm/s²",
    "mm/s^2": "mm/s²", "m3/h": "m³/h", "mm2/s": "mm²/s", "mpas": "mPa·s", "mpa*s": "mPa·s", "ft-lb": "lbf·ft",
    "lb-ft": "lbf·ft", "lbft": "lbf·ft", "kgm2": "kg·m²", "pct": "%", "percent": "%", "watt": "W", "sec": "s",
}  # fmt: skip


def canonical(unit: str) -> str:
    """A unit as this program writes it; one that is not known as it stands."""
    unit = unit.strip()
    if unit in UNITS or unit in FURTHER:
        return unit
    bare = unit[1:-1].strip() if unit[:1] + unit[-1:] in ("[]", "()") else unit
    return bare if bare in UNITS or bare in FURTHER else SPELLINGS.get(bare.lower().replace(" ", ""), unit)


def known(unit: str) -> bool:
    return bool(_meanings(unit))


def alike(unit: str) -> str:
    """The unit that was probably meant; empty where none is near."""
    return next(iter(get_close_matches(canonical(unit), [*UNITS, *FURTHER], 1)), "")


def of_dimension(unit: str) -> list[str]:
    """The units that this one can be converted to, itself too; none of one that is not known."""
    symbols = {meaning.symbol for meaning in _meanings(unit)}
    return [each for each in (*UNITS, *FURTHER) if any(meaning.symbol in symbols for meaning in _meanings(each))]


def listed(unit: str) -> str:
    """The units of the same dimension in words."""
    return ", ".join(each or "1" for each in of_dimension(unit))


def _meanings(unit: str) -> tuple[BenchUnit, ...]:
    unit = canonical(unit)
    if unit in FURTHER:
        return FURTHER[unit]
    return (BenchUnit(UNITS[unit].inside_symbol, UNITS[unit].factor),) if unit in UNITS else ()


def conversion(unit: str, into: str) -> tuple[float, float] | None:
    """(factor, zero) with number in `into` = factor · (number in `unit` + zero); None where they are of other
    dimensions.  `into`: a unit that values are shown in."""
    if canonical(unit) == into:
        return 1.0, 0.0
    to = BenchUnit(UNITS[into].inside_symbol, UNITS[into].factor)
    here = next((meaning for meaning in _meanings(unit) if meaning.symbol == to.symbol), None)
    return None if here is None else (here.factor / to.factor, here.zero)
