# SPDX-License-Identifier: Apache-2.0
"""`contralbero oils`: the oils that a design may name, and what is known of each of their values."""

from argparse import Namespace
from typing import Any

from assistant.plain import table_json, table_lines
from calc.library.catalogue import Oil, oils
from calc.library.lubricant import Lubricant
from calc.library.oils import least_sure, printed_table, values_table
from calc.sheet.errors import BadInput, InputError
from calc.sheet.step import Table
from calc.sheet.text import Amount, Name, Text
from calc.sheet.units import UNITS
from calc.version import VERSION
from calc.viscosity_index import viscosity_index

TEMPERATURES = (40.0, 60.0, 80.0, 100.0, 120.0)  # °C


def run(asked: Namespace) -> int:
    known = oils()
    if asked.name is not None and asked.name not in known:
        from difflib import get_close_matches

        near = get_close_matches(asked.name, list(known), 1, 0.4)
        hint = Text('did you mean "{oil}"?', oil=near[0]) if near else Text("known are {oils}", oils=", ".join(known))
        raise BadInput("contralbero oils", [InputError(0, "", f'"{asked.name}"', Text("is not known; {hint}", hint=hint))])
    tables = _list(known.values()) if asked.name is None else _one(known[asked.name])
    if asked.json:
        import json

        about: dict[str, Any] = {"schema": 1, "program": "contralbero", "version": VERSION}
        if asked.name is not None:
            about |= {"oil": asked.name, "source": known[asked.name].source}
        print(json.dumps({**about, "tables": {table.id: table_json(table) for table in tables}}, ensure_ascii=False, indent=1))
        return 0
    for n, table in enumerate(tables):
        print(("\n" if n else "") + "\n".join(table_lines(table)))
    return 0


def _list(known: Any) -> list[Table]:
    """All oils, a row each."""
    columns = (
        (Text("Oil"), ""), (Text("Base"), ""), (Name("ν40"), "mm²/s"), (Name("ν100"), "mm²/s"), (Name("VI"), ""), (Name("ρ15"), "kg/m³"),
        (Name("η40"), "mPa·s"), (Name("η100"), "mPa·s"), (Name("α40"), "1/GPa"), (Name("Λ"), ""), (Text("Confidence"), "at least"),
    )  # fmt: skip
    note = Text(
        "At 40, 100 and 15 °C. VI: viscosity index; α: rise of the viscosity with pressure; Λ: limiting shear stress over pressure. "
        "`contralbero oils NAME` tells where each value comes from."
    )
    return [Table("oils", Text("Oils that a design may name"), columns, tuple(_row(oil) for oil in known), note)]


def _row(oil: Oil) -> tuple[str | float | None, ...]:
    lubricant = Lubricant(oil)
    cold, hot = lubricant.at(40.0), lubricant.at(100.0)
    index = viscosity_index(lubricant.nu40, lubricant.nu100)
    return (
        oil.name, oil.base, _shown(lubricant.nu40, "mm²/s"), _shown(lubricant.nu100, "mm²/s"),
        index if index is None else float(round(index)), oil.rho15,
        _shown(cold.mu, "mPa·s"), _shown(hot.mu, "mPa·s"), _shown(lubricant.alpha(cold.mu), "1/GPa"), lubricant.limiting_shear,
        least_sure(oil)[0],
    )  # fmt: skip


def _one(oil: Oil) -> list[Table]:
    """One oil: its values, its viscosity over temperature, what is printed for it elsewhere."""
    lubricant = Lubricant(oil)
    states = [(T, lubricant.at(T)) for T in TEMPERATURES]
    rows = tuple(
        (T, _shown(s.nu, "mm²/s"), _shown(s.mu, "mPa·s"), _shown(s.rho, "kg/m³"), _shown(lubricant.alpha(s.mu), "1/GPa"),
         round(lubricant.beta(T), 5)) for T, s in states
    )  # fmt: skip
    units = {"T": "°C", "ν": "mm²/s", "η": "mPa·s", "ρ": "kg/m³", "α": "1/GPa", "β": "1/K"}
    columns = tuple((Name(symbol), unit) for symbol, unit in units.items())
    index = viscosity_index(lubricant.nu40, lubricant.nu100)
    note = Text("Walther's law through the two viscosities.")
    if index is not None:
        note = Text("{law} Viscosity index {index}.", law=note, index=Amount(index, form=".0f"))
    law = Table("oil_law", Text("Oil {oil}: viscosity over temperature", oil=oil.name), columns, rows, note)
    printed = printed_table(lubricant)
    return [values_table(oil), law, *([printed] if printed is not None else [])]


def _shown(inside: float, unit: str) -> float:
    """Four digits, which is more than any of these is known to."""
    return float(f"{UNITS[unit].shown(inside):.4g}")
