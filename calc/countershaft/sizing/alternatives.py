# SPDX-License-Identifier: Apache-2.0
"""The design's material beside others: what they make of the sectors, of the wall beside the seat, and of the cost."""

import re
from collections.abc import Mapping
from typing import Any

from ...catalogue import Material
from ...sheet.quantity import result, value
from ...sheet.step import Table
from ...sheet.text import Amount, Text
from ...sheet.trace import about
from ...sheet.units import Euro, Kilogram, KilogramPerMetre3, Metre, Number
from ..inputs import CountershaftInputs
from ..making.inputs import Alternative
from . import cost_formulas as f


@result
class MaterialResult:
    """One material; what depends on a size or a cost that is not known is left out."""

    density: KilogramPerMetre3 | None = value("Density", "kg/m³", "ρ'", default=None)
    outer_radius: Metre | None = value("Outer radius of the sectors, same length and half-angle", "mm", "R'", default=None)
    bore_growth: Metre | None = value("Growth of the seat's bore", "mm", "ΔD", default=None)
    eccentric_mass: Kilogram | None = value("Eccentric masses together", "kg", "Σm'", default=None)
    wall_left: Metre | None = value("Wall left beside the seat", "mm", "w'", default=None)
    first_year_cost: Euro | None = value("Cost of the first year", "€", "K_1", default=None)
    break_even: Number | None = value("Pieces at which it costs as much as the design's material", "", "N_e", default=None)
    bearable_development: Euro | None = value("Development at which it costs as much in the first year", "€", "K_D,e", default=None)
    name: str


def compared(shaft: CountershaftInputs, materials: Mapping[str, Material], R: Metre | None, r_0: Metre | None,
    eccentric_mass: Kilogram) -> dict[str, MaterialResult]:  # fmt: skip
    """The design's own material first, then the others to compare; keys are fit for the names of values.

    `R` and `r_0`: of the design's sectors, None where they are not known; `eccentric_mass`: both together.
    """
    costs = {a.material: a for a in shaft.cost.alternatives} if shaft.cost is not None else {}
    own = costs.get(shaft.material)
    results = {}
    for name in named(shaft, materials):
        with about(Text("material {material}", material=name)):
            sized = _size(shaft, materials[shaft.material], materials.get(name), R, r_0, eccentric_mass)
            results[key(name)] = MaterialResult(name=name, **sized, **_cost(shaft, costs.get(name), own))
    return results


def named(shaft: CountershaftInputs, materials: Mapping[str, Material]) -> tuple[str, ...]:
    """The materials to compare: the design's own, and those of [countershaft.cost]; where it is sized without one, the ADI grades."""
    if shaft.cost is not None:
        others = [a.material for a in shaft.cost.alternatives]
    else:
        others = [name for name in materials if name.startswith("ADI")] if shaft.mode == "size" else []
    return (shaft.material, *(name for name in others if name != shaft.material))


def key(name: str) -> str:
    """A material's name as part of the name of a value: "ADI 800" → "ADI-800"."""
    return re.sub(r"[^A-Za-z0-9]+", "-", name).strip("-")


def _size(shaft: CountershaftInputs, own: Material, other: Material | None, R: Metre | None, r_0: Metre | None, mass: Kilogram) -> dict[str,
    Any]:  # fmt: skip
    if other is None:
        return {}
    sizes: dict[str, Any] = {"density": other.density}
    if R is None or r_0 is None:
        return sizes
    wall = shaft.support.wall if shaft.support is not None else None
    if other.name == own.name:
        return {**sizes, "outer_radius": R, "bore_growth": 0.0, "eccentric_mass": mass, "wall_left": wall}
    R_m = f.radius_for(R=R, r_0=r_0, rho=own.density, rho_m=other.density)
    sizes |= {"outer_radius": R_m, "bore_growth": f.bore_growth(R_m=R_m, R=R)}
    sizes["eccentric_mass"] = f.mass_for(m=mass, rho=own.density, rho_m=other.density, R=R, R_m=R_m, r_0=r_0)
    sizes["wall_left"] = f.wall_left(w=wall, R_m=R_m, R=R) if wall is not None else None
    return sizes


def _cost(shaft: CountershaftInputs, one: Alternative | None, own: Alternative | None) -> dict[str, Any]:
    if shaft.cost is None or one is None:
        return {}
    N = shaft.cost.pieces_per_year
    year = f.first_year(K_T=one.tooling, K_D=one.development, N=N, c=one.piece)
    costs: dict[str, Any] = {"first_year_cost": year}
    if own is None or one.material == own.material:
        return costs
    theirs = f.first_year(K_T=own.tooling, K_D=own.development, N=N, c=own.piece)
    costs["bearable_development"] = f.bearable_development(K_1=theirs, K_1a=year, K_Da=one.development)
    first, other = own.tooling + own.development, one.tooling + one.development
    if (own.piece - one.piece) * (other - first) > 0:  # else the same one is the cheaper at any volume
        K, K_a = (f.before_first_piece(K_T=x.tooling, K_D=x.development) for x in (own, one))
        costs["break_even"] = f.break_even(K=K, K_a=K_a, c=own.piece, c_a=one.piece)
    return costs


COLUMNS = (
    (Text("density"), "density", "kg/m³"), (Text("outer radius"), "outer_radius", "mm"), (Text("bore larger by"), "bore_growth", "mm"),
    (Text("eccentric masses"), "eccentric_mass", "kg"), (Text("wall left"), "wall_left", "mm"),
    (Text("first year"), "first_year_cost", "k€"), (Text("same cost at pieces"), "break_even", ""),
    (Text("development it bears"), "bearable_development", "k€"),
)  # fmt: skip


def compared_table(shaft: CountershaftInputs, results: Mapping[str, MaterialResult]) -> Table:
    """The materials beside each other; columns that nothing is known of are left out."""
    rows = list(results.values())
    shown = [c for c in COLUMNS if any(getattr(row, c[1]) is not None for row in rows)]
    units = [{"mm": 1e-3, "k€": 1e3}.get(unit, 1.0) for _, _, unit in shown]
    cells = tuple(
        (row.name, *(None if getattr(row, c[1]) is None else float(getattr(row, c[1])) / unit for c, unit in zip(shown, units)))
        for row in rows
    )
    note = Text("The same couple from sectors of the same length and half-angle, so that a lighter material needs a larger radius.")
    if shaft.support is not None and shaft.support.wall is not None:
        note += Text(" The wall should keep {wall}.", wall=Amount(shaft.support.least_wall * 1e3, "mm", form="g"))
    if shaft.cost is not None:
        note += Text(" First year: tooling, development and {n} pieces; the comparison is with {material}.", n=shaft.cost.pieces_per_year,
            material=shaft.material)  # fmt: skip
    columns = ((Text("material"), ""), *((label, unit) for label, _, unit in shown))
    return Table("materials", Text("The shaft in other materials"), columns, cells, note, covers=("countershaft.alternative.",))
