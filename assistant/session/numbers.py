# SPDX-License-Identifier: Apache-2.0
"""What a person types into a field, understood: `3,5` and `3.5`, `1.2e-3`, `3.7 in`, `92.4/2`, `-167.5; 167.5`.

The comma is a decimal sign, never a separator of thousands: `1,234.5` is refused with the reason, because a wrong guess
would be a factor of a thousand.  The answer stands in the unit of the field, as the design file has it."""

import math
import re
import tomllib
from datetime import date
from typing import Any

from calc.design.toml_file import is_day
from calc.sheet.quantity import FLAGS, Quantity
from calc.sheet.text import Text

# --- the units that may be typed behind a number
# By the unit of the field: words and their factors to the SI unit.

PI = 3.141592653589793
INCH, POUND, GRAVITY = 0.0254, 0.45359237, 9.80665

# fmt: off
LENGTH = {
    "m": 1.0, "dm": 0.1, "cm": 1e-2, "mm": 1e-3, "µm": 1e-6, "um": 1e-6, "micron": 1e-6, "nm": 1e-9,
    "in": INCH, '"': INCH, "inch": INCH, "ft": 12 * INCH, "feet": 12 * INCH, "thou": INCH / 1000, "mil": INCH / 1000,
}
PRESSURE = {
    "Pa": 1.0, "hPa": 1e2, "kPa": 1e3, "MPa": 1e6, "GPa": 1e9, "N/mm²": 1e6, "bar": 1e5, "mbar": 1e2, "atm": 101325.0,
    "psi": POUND * GRAVITY / INCH**2, "ksi": 1000 * POUND * GRAVITY / INCH**2,
    "kgf/cm²": GRAVITY * 1e4, "at": GRAVITY * 1e4,
}
FORCE = {"N": 1.0, "daN": 10.0, "kN": 1e3, "kgf": GRAVITY, "lbf": POUND * GRAVITY}
MASS = {"kg": 1.0, "g": 1e-3, "mg": 1e-6, "t": 1e3, "lb": POUND, "lbs": POUND, "oz": POUND / 16}
TORQUE = {
    "N·m": 1.0, "Nm": 1.0, "N·mm": 1e-3, "Nmm": 1e-3, "daNm": 10.0, "kN·m": 1e3, "kNm": 1e3, "kgf·m": GRAVITY,
    "lbf·ft": POUND * GRAVITY * 12 * INCH, "lb·ft": POUND * GRAVITY * 12 * INCH,
    "lbf·in": POUND * GRAVITY * INCH, "lb·in": POUND * GRAVITY * INCH,
}
UNBALANCE = {
    "g·mm": 1e-6, "gmm": 1e-6, "g·cm": 1e-5, "kg·mm": 1e-3, "kgmm": 1e-3, "kg·m": 1.0, "oz·in": POUND / 16 * INCH,
}
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
    "km/h": {"km/h": 1 / 3.6, "m/s": 1.0},
    "m/s": {"m/s": 1.0, "mm/s": 1e-3, "km/h": 1 / 3.6, "ft/s": 12 * INCH},
    "m/s²": {"m/s²": 1.0, "g": GRAVITY}, "rad/s²": {"rad/s²": 1.0, "1/s²": 1.0},
    "N": FORCE, "kN": FORCE, "N·m": TORQUE, "N·mm": TORQUE,
    "N·m/°": {"N·m/°": 180 / PI, "Nm/°": 180 / PI, "N·m/rad": 1.0, "Nm/rad": 1.0},
    "N/m": {"N/m": 1.0, "N/mm": 1e3, "kN/m": 1e3, "N/µm": 1e6},
    "N·s/m": {"N·s/m": 1.0, "Ns/m": 1.0, "N·s/mm": 1e3, "Ns/mm": 1e3},
    "N/mm": {"N/mm": 1e3, "N/m": 1.0, "kN/m": 1e3, "N/µm": 1e6}, "kN/mm": {"kN/mm": 1e6, "N/mm": 1e3, "N/µm": 1e6},
    "MPa": PRESSURE, "GPa": PRESSURE, "bar": PRESSURE,
    "1/GPa": {"1/GPa": 1e-9, "GPa⁻¹": 1e-9, "1/MPa": 1e-6, "1/Pa": 1.0, "mm²/N": 1e-6},
    "mm²/N": {"mm²/N": 1e-6, "1/MPa": 1e-6, "1/GPa": 1e-9, "1/Pa": 1.0},
    "MPa·m/s": {"MPa·m/s": 1e6, "N/mm²·m/s": 1e6},
    "mPa·s": {"mPa·s": 1e-3, "Pa·s": 1.0, "cP": 1e-3, "P": 0.1},
    "mm²/s": {"mm²/s": 1e-6, "cSt": 1e-6, "St": 1e-4, "m²/s": 1.0},
    "N·rpm/mm": {"N·rpm/mm": 1000 / 60, "N·rpm/cm": 100 / 60},
    "W": POWER, "kW": POWER, "W/K": {"W/K": 1.0, "kW/K": 1e3},
    "J": {"J": 1.0, "kJ": 1e3, "N·m": 1.0, "Nm": 1.0, "W·h": 3600.0, "Wh": 3600.0, "kWh": 3.6e6},
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


# --- reading what was typed

LONGEST = 200  # characters of one entry
MINUS = str.maketrans({"−": "-", "–": "-", "\u00a0": " ", "\u202f": " ", "\u2009": " "})
RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺", "0123456789-+")
NUMBER = re.compile(
    r"""(?P<number>[+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+))                 # 3  3.5  3,5  .5
        (?:[eE](?P<e>[+-]?\d{1,3})(?![0-9])                            # 1.2e-3
          |\s*[·*x×]\s*10(?:\^(?P<power>[+-]?\d{1,3})|(?P<raised>[⁻⁺]?[⁰¹²³⁴⁵⁶⁷⁸⁹]{1,3})))?   # 1.2·10⁻³
        \s*(?P<unit>[^\s\d.,+-].*)?\Z""",
    re.VERBOSE,
)
GROUPED = re.compile(r"[+-]?\d+(?:[.,'’_ ]\d+){2,}|[+-]?\d+['’_ ]\d|[+-]?\d[\d.,]*,\d*\.|[+-]?\d[\d.,]*\.\d*,")

SUM = re.compile(  # 92.4/2  3/8 in  2*(45+1)
    r"(?P<sum>(?=.*[\d)]\s*[-+*/×]\s*[-+(\d.,])[-+(\d.,][-+*/×().,\deE\s]*?)\s*(?P<unit>(?![eE]\d)[^-+*/×().,\d\s^][^()]*)?\Z"
)
TOKEN = re.compile(r"\s*(?:(?P<number>(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d{1,3})?)|(?P<sign>[-+*/×()]))")
POWER_OF_TEN = re.compile(r"[·*x×]\s*10\s*(?:\^|[⁻⁺⁰¹²³⁴⁵⁶⁷⁸⁹])")
UNFINISHED = re.compile(r"[+-]?(?:\d+[.,]?\d*[eE][+-]?)?\Z|[+-]?[.,]\Z|[\d(][-+*/×().,\de\s]*[-+*/×(]\Z")


class NotUnderstood(ValueError):
    """The text can not be taken as a value of this field; `reason` says why, and what is allowed."""

    def __init__(self, reason: Text) -> None:
        self.reason = reason
        super().__init__(reason)


YES_NO = dict(zip(("no", "yes"), FLAGS))


def value(text: str, about: Quantity) -> Any:
    """The value that the text stands for, as the design file has it; None where the field is left empty and may be."""
    text = text.strip()
    if len(text) > LONGEST:
        raise NotUnderstood(Text("is longer than {limit} characters", limit=LONGEST))
    if not text:
        if about.optional:
            return None
        raise NotUnderstood(Text("is empty; needs {allowed}", allowed=about.allowed()))
    match about.kind:
        case "text" | "choice":
            return text
        case "flag":
            word = YES_NO.get(text.lower(), text.lower())
            if word not in FLAGS:
                raise NotUnderstood(Text("must be {allowed}", allowed=about.allowed()))
            return word == FLAGS[1]
        case "date":
            return day(text, about)
        case "number":
            return number(text, about)
        case "integer":
            return integer(text, about)
        case "series" | "integers":
            return series(text, about)
        case "names":
            return names(text, about)
        case "open":
            return nested(text, about)
    raise NotUnderstood(Text("can not be typed into one field"))


def day(text: str, about: Quantity) -> date:
    """A date as TOML has it."""
    if not is_day(text.translate(MINUS)):
        raise NotUnderstood(Text("must be {allowed}", allowed=about.allowed()))
    return date.fromisoformat(text.translate(MINUS))


def number(text: str, about: Quantity) -> float:
    """A decimal number, with or without a unit; the answer stands in the unit of the field."""
    shown, unit = _parts(text, about)
    return _converted(shown, unit, about)


def integer(text: str, about: Quantity) -> int:
    shown = number(text, about)
    if shown != int(shown):
        raise NotUnderstood(Text("must be {allowed}", allowed=about.allowed()))
    return int(shown)


def series(text: str, about: Quantity) -> list[Any]:
    """`-167.5; 167.5`.  Whole numbers, and a list in brackets as the design file has it, may have commas between
    them."""
    bracketed = text.startswith("[") and text.endswith("]")
    body = text[1:-1].strip() if bracketed else text
    if ";" in body:
        items = body.split(";")
    elif bracketed or about.kind == "integers":
        items = body.split(",") if "," in body else body.split()
    elif ", " in body:
        items = body.split(", ")
    elif body.count(",") > 1 or ("," in body and "." in body):
        raise NotUnderstood(Text("is ambiguous; put a semicolon between the numbers: 1.5; 2.5"))
    else:
        items = body.split() if all(NUMBER.match(part) for part in body.translate(MINUS).split()) else [body]
    items = [item.strip() for item in items]
    if items and not items[-1]:
        items.pop()
    if not items or not all(items):
        raise NotUnderstood(Text("has an empty place; needs {allowed}", allowed=about.allowed()))
    read = [_parts(item, about) for item in items]
    if len({bool(unit) for _, unit in read}) > 1:
        raise NotUnderstood(Text("has units at some numbers only; give every number its unit, or none"))
    numbers = [_converted(shown, unit, about) for shown, unit in read]
    if about.kind == "integers":
        if any(n != int(n) for n in numbers):
            raise NotUnderstood(Text("must be {allowed}", allowed=about.allowed()))
        return [int(n) for n in numbers]
    return numbers


def names(text: str, about: Quantity) -> list[str]:
    """`left; right`, or a list as the design file has it."""
    found = [name.strip(" \"'") for name in text.strip("[]").replace(";", ",").removesuffix(",").split(",")]
    if not all(found):
        raise NotUnderstood(Text("has an empty place; needs {allowed}", allowed=about.allowed()))
    return found


def nested(text: str, about: Quantity) -> list[Any]:
    """`[[27.987, 27.993], [27.994, 28.0]]`: a list as the design file has it, where a comma parts numbers."""
    if text.count("[") > text.count("]"):
        raise NotUnderstood(Text("is not finished"))
    try:
        read = tomllib.loads(f"it = {text.translate(MINUS)}")
    except ValueError:
        read = {}
    if list(read) != ["it"] or not isinstance(read["it"], list):
        raise NotUnderstood(Text("is no list of lists; write [[1.48, 1.49], [1.5, 1.51]], with points in the numbers"))
    return read["it"]


def _parts(text: str, about: Quantity) -> tuple[float, str]:
    """The number as typed, and the unit behind it."""
    plain = text.translate(MINUS).strip()
    if plain[:1] in "+-" and plain[1:2] == " ":
        plain = plain[0] + plain[1:].lstrip()
    digits, behind = plain, ""
    for name in UNIT_WORDS.get(about.unit, {}):
        if name[:1].isdigit() and plain.endswith(" " + name):  # 2600 1/min
            digits, behind = plain.removesuffix(name).rstrip(), name
    if UNFINISHED.match(digits):
        raise NotUnderstood(Text("is not finished"))
    if (worked := SUM.match(digits)) is not None and not POWER_OF_TEN.search(digits):
        return _Sum(worked["sum"], about).value(), behind or (worked["unit"] or "").strip()
    if GROUPED.match(digits):
        raise NotUnderstood(
            Text("is ambiguous: the thousands are not separated here; write {number}", number=_ungrouped(digits))
        )
    parsed = NUMBER.match(digits)
    if parsed is None:
        if digits.lower().lstrip("+-").startswith(("nan", "inf")):
            raise NotUnderstood(Text("must be {allowed}, and finite", allowed=about.allowed()))
        raise NotUnderstood(Text("is no number; needs {allowed}", allowed=about.allowed()))
    mantissa = parsed["number"].replace(",", ".")
    power = parsed["e"] or parsed["power"] or (parsed["raised"] or "0").translate(RAISED)
    return float(f"{mantissa}e{int(power)}"), behind or (parsed["unit"] or "").strip()


class _Sum:
    """A little arithmetic: + - * / and brackets, by recursive descent."""

    def __init__(self, text: str, about: Quantity) -> None:
        self._refused = NotUnderstood(
            Text("is no sum that can be worked out; needs {allowed}", allowed=about.allowed())
        )
        self._tokens: list[str] = []
        end = 0
        while end < len(text.rstrip()):
            if (token := TOKEN.match(text, end)) is None:
                raise self._refused
            self._tokens.append((token["number"] or token["sign"]).replace(",", ".").replace("×", "*"))
            end = token.end()
        self._tokens.reverse()

    def value(self) -> float:
        total = self._terms()
        if self._tokens or not math.isfinite(total):
            raise self._refused
        return float(f"{total:.12g}")

    def _next(self, *signs: str) -> str:
        return self._tokens.pop() if self._tokens and self._tokens[-1] in signs else ""

    def _terms(self) -> float:
        total = self._factors()
        while sign := self._next("+", "-"):
            total += self._factors() if sign == "+" else -self._factors()
        return total

    def _factors(self) -> float:
        product = self._single()
        while sign := self._next("*", "/"):
            by = self._single()
            if sign == "/" and not by:
                raise self._refused
            product = product * by if sign == "*" else product / by
        return product

    def _single(self) -> float:
        if sign := self._next("+", "-"):
            return self._single() if sign == "+" else -self._single()
        if self._next("("):
            total = self._terms()
            if not self._next(")"):
                raise self._refused
            return total
        if not self._tokens or self._tokens[-1] in "+-*/()":
            raise NotUnderstood(Text("is not finished")) if not self._tokens else self._refused
        return float(self._tokens.pop())


def _ungrouped(text: str) -> str:
    """The same digits without the separators of thousands: what was probably meant."""
    digits = re.match(r"[+-]?[\d.,'’_ ]*\d", text)
    body = digits[0] if digits else text
    if body.count(".") == 1 and (body.count(",") != 1 or body.rindex(".") > body.rindex(",")):
        return re.sub(r"[,'’_ ]", "", body)
    if body.count(",") == 1:
        return re.sub(r"[.'’_ ]", "", body).replace(",", ".")
    return re.sub(r"[.,'’_ ]", "", body)


def _converted(shown: float, word: str, about: Quantity) -> float:
    """A number with the unit that stands behind it, in the unit of the field."""
    if abs(shown) > 1e300:
        raise NotUnderstood(Text("must be {allowed}, and finite", allowed=about.allowed()))
    if not word or word == about.unit:
        return shown
    known = UNIT_WORDS.get(about.unit, {})
    name = _unit(word, known)
    if name is None:
        others = [n for n in known if n and n != about.unit][:5]
        allowed = (
            Text("write {units} or no unit", units=", ".join([about.unit, *others]))
            if about.unit
            else Text("it has no unit")
        )
        raise NotUnderstood(Text('"{word}" is no unit of this field; {allowed}', word=word, allowed=allowed))
    if name == about.unit:
        return shown
    factor, zero = known[name] if isinstance(known[name], tuple) else (known[name], 0.0)
    return float(f"{about.units.shown(shown * factor + zero):.12g}")


def _unit(word: str, known: dict[str, Any]) -> str | None:
    """The known unit that a word means: µ in either coding, ^2 for ², a dot, a star or a space for ·; any case where
    that is unique."""
    plain = re.sub(
        r"\s*[·⋅*]\s*|(?<=[A-Za-z])\.(?=[A-Za-z])|(?<=[A-Za-z])[ -](?=[A-Za-z])", "·", word.replace("μ", "µ")
    )
    plain = plain.replace("^2", "²").replace("^3", "³").replace("^-1", "⁻¹").replace("min-1", "min⁻¹")
    plain = re.sub(r"(?<=m)2\b", "²", re.sub(r"(?<=m)3\b", "³", plain))
    if plain in known:
        return plain
    same = [name for name in known if name.casefold() == plain.casefold()]
    return same[0] if len(same) == 1 else None


def written(content: Any, about: Quantity, decimal: str = ".") -> str:
    """A value of the design file as it stands in its field, with the decimal sign of the user's language."""
    if content is None:
        return ""
    if about.kind == "flag" and isinstance(content, bool):
        return FLAGS[content]
    if about.kind == "open":
        return _as_in_file(content)
    if isinstance(content, list):
        return "; ".join(_decimal(item, decimal) for item in content)
    return content if isinstance(content, str) else _decimal(content, decimal)


def _decimal(content: Any, sign: str) -> str:
    return _digits(content).replace(".", sign) if isinstance(content, float) else _digits(content)


def _as_in_file(content: Any) -> str:
    """A list of lists in brackets; anything in them as a field of its own has it."""
    return f"[{', '.join(map(_as_in_file, content))}]" if isinstance(content, list) else _digits(content)


def _digits(content: Any) -> str:
    if isinstance(content, bool) or not isinstance(content, (int, float)):
        return str(content)
    return repr(content + 0).removesuffix(".0")  # + 0: minus nought is nought
