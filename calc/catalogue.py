# SPDX-License-Identifier: Apache-2.0
"""Oils and materials by name: the design's own first, then the tables that come with the program."""

import tomllib
from collections.abc import Iterable
from functools import cache
from pathlib import Path

from .sheet.quantity import choice, inputs, keys, quantity, text

TABLES = Path(__file__).parent / "tables"


@inputs
class Oil:
    """A lubricant by two viscosities and its density; the values by which it acts in a gear mesh follow from its base."""

    name: str = text("Name")
    nu40: float = quantity("Kinematic viscosity at 40 °C", "mm²/s", low=1, high=1e5, symbol="nu_40")
    nu100: float = quantity("Kinematic viscosity at 100 °C", "mm²/s", low=1, high=1e4, symbol="nu_100")
    rho15: float = quantity("Density at 15 °C", "kg/m³", low=600, high=1300, symbol="rho_15")
    base: str = choice("Base stock", "mineral", "PAO", "PAG", "ester", "MIL-L-7808", "MIL-L-23699")
    conductivity: float = quantity("Thermal conductivity", "W/(m·K)", default=0.14, low=0.05, high=1.0, symbol="k_f")
    source: str = text("Source", default="the user")

    def problems(self) -> Iterable[tuple[str, str]]:
        if self.nu100 >= self.nu40:
            yield "nu100_mm2_s", "must be below the viscosity at 40 °C"


@inputs
class Material:
    """A solid by what shaft, bearing and gear need of it."""

    name: str = text("Name")
    E: float = quantity("Young's modulus", "GPa", low=1, high=1000)
    poisson: float = quantity("Poisson's ratio", default=0.3, low=0.0, high=0.49, symbol="nu")
    density: float = quantity("Density", "kg/m³", low=500, high=25000, symbol="rho")
    expansion: float = quantity("Thermal expansion", "10⁻⁶/K", low=0, high=100, symbol="alpha")
    proof_stress: float | None = quantity("Proof stress", "MPa", optional=True, above=0, high=10000, symbol="R_p", help="Rp0.2, tension.")
    tensile_strength: float | None = quantity("Tensile strength", "MPa", optional=True, above=0, high=10000, symbol="R_m")
    source: str = text("Source", default="the user")


@cache
def rows_of(file: str, cls: type, only: str = "") -> dict[str, object]:
    """The rows of a table by their names; `only`: one of them, which spares the reading of the others."""
    text = (TABLES / file).read_text(encoding="utf-8")
    if only:
        text = "".join("[[row]]" + row for row in text.split("[[row]]")[1:] if row.lstrip().startswith(f'name = "{only}"\n'))
    rows = tomllib.loads(text)["row"]
    known = keys(cls)
    return {
        row["name"]: cls(**{known[k].attribute: known[k].about.units.inside(v) if isinstance(v, float) else v for k, v in row.items()})
        for row in rows
    }


def oils(own: Iterable[Oil] = ()) -> dict[str, Oil]:
    """Every oil that a design may name; its own override those of the table."""
    return {**rows_of("oils.toml", Oil), **{o.name: o for o in own}}  # type: ignore[dict-item]


def materials(own: Iterable[Material] = ()) -> dict[str, Material]:
    """Every material that a design may name; its own override those of the table."""
    return {**rows_of("materials.toml", Material), **{m.name: m for m in own}}  # type: ignore[dict-item]
