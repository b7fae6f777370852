# SPDX-License-Identifier: Apache-2.0
"""The design's material beside others: what they make of the sectors, of the wall beside the seat, and of the cost."""

import re
from collections.abc import Mapping

from ...bearings.formulas import specific_load
from ...library.catalogue import Material
from ...sheet.quantity import result, value
from ...sheet.record import record
from ...sheet.step import Table
from ...sheet.text import Amount, Text
from ...sheet.trace import about
from ...sheet.units import Euro, Kilogram, KilogramPerMetre3, Metre, Newton, Number, Pascal
from ..inputs import CountershaftInputs
from ..making.inputs import Alternative
from . import cost_formulas as f


@record
class Seat:
    """The shaft's largest journal, which the sectors pass."""

    diameter: Metre
    length: Metre
    load: Newton


@result
class MaterialResult:
    """One material; what depends on a size or a cost that is not known is left out."""

    density: KilogramPerMetre3 | None = value("Density", "kg/m³", "ρ'", default=None)
    outer_radius: Metre | None = value("Outer radius of the sectors, same length and half-angle", "mm", "R'", default=None)
    bore_growth: Metre | None = value("Growth of the seat's bore", "mm", "ΔD", default=None)
    eccentric_mass: Kilogram | None = value("Eccentric masses together", "kg", "Σm'", default=None)
    wall_left: Metre | None = value("Wall left beside the seat", "mm", "w'", default=None)
    journal: Metre | None = value("Largest journal", "mm", "d'", default=None)
    specific_load: Pascal | None = value("its specific load", "MPa", "p'", default=None)
    shaft_mass: Kilogram | None = value("Mass of the whole shaft", "kg", "m_S'", default=None)
    mass_difference: Kilogram | None = value("Whole shaft against the design's own", "g", "Δm", default=None)
    first_year_cost: Euro | None = value("Cost of the first year", "€", "K_1", default=None)
    break_even: Number | None = value("Pieces at which it costs as much as the design's material", "", "N_e", default=None)
    bearable_development: Euro | None = value("Development at which it costs as much in the first year", "€", "K_D,e", default=None)
    name: str


def compared(shaft: CountershaftInputs, materials: Mapping[str, Material], R: Metre | None, r_0: Metre | None,
    eccentric_mass: Kilogram, shaft_mass: Kilogram | None = None, seat: Seat | None = None) -> dict[str, MaterialResult]:  # fmt: skip
    """The design's own material first, then the others to compare; keys are fit for the names of values.

    `R` and `r_0`: of the design's sectors, None where they are not known; `eccentric_mass`: both together; `shaft_mass`: the whole
    shaft, `seat`: its largest journal, where they are known.
    """
    costs = {a.material: a for a in shaft.cost.alternatives} if shaft.cost is not None else {}
    own = costs.get(shaft.material)
    results = {}
    for name in named(shaft, materials):
        with about(Text("material {material}", material=name)):
            sized = _size(shaft, materials[shaft.material], materials.get(name), R, r_0, eccentric_mass)
            sized |= _whole(sized, materials[shaft.material], eccentric_mass, shaft_mass, seat)
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
    float]:  # fmt: skip
    if other is None:
        return {}
    sizes = {"density": other.density}
    if R is None or r_0 is None:
        return sizes
    wall = shaft.support.wall if shaft.support is not None else None
    if other.name == own.name:
        sizes |= {"outer_radius": R, "bore_growth": 0.0, "eccentric_mass": mass}
        return sizes if wall is None else sizes | {"wall_left": wall}
    R_m = f.radius_for(R=R, r_0=r_0, rho=own.density, rho_m=other.density)
    sizes |= {"outer_radius": R_m, "bore_growth": f.bore_growth(R_m=R_m, R=R)}
    sizes["eccentric_mass"] = f.mass_for(m=mass, rho=own.density, rho_m=other.density, R=R, R_m=R_m, r_0=r_0)
    return sizes if wall is None else sizes | {"wall_left": f.wall_left(w=wall, R_m=R_m, R=R)}


def _whole(sized: dict[str, float], own: Material, mass: Kilogram, shaft_mass: Kilogram | None, seat: Seat | None) -> dict[str, float]:
    """The journal that grows with its seat, and the mass of the whole shaft; the rest of it keeps its shape."""
    if seat is None or "bore_growth" not in sized:
        return {}
    d = f.grown(d=seat.diameter, dD=sized["bore_growth"])
    whole = {"journal": d, "specific_load": specific_load(F=seat.load, d=d, l=seat.length)}
    if shaft_mass is not None:
        m = f.whole_mass(
            m_new=sized["eccentric_mass"],
            m_S=shaft_mass,
            m=mass,
            rho_m=sized["density"],
            rho=own.density,
            d_m=d,
            d=seat.diameter,
            l=seat.length,
        )
        whole |= {"shaft_mass": m, "mass_difference": f.mass_difference(m_new=m, m_S=shaft_mass)}
    return whole


def _cost(shaft: CountershaftInputs, one: Alternative | None, own: Alternative | None) -> dict[str, float]:
    if shaft.cost is None or one is None:
        return {}
    N = shaft.cost.pieces_per_year
    year = f.first_year(K_T=one.tooling, K_D=one.development, N=N, c=one.piece)
    costs = {"first_year_cost": year}
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
    (Text("largest journal"), "journal", "mm"), (Text("its specific load"), "specific_load", "MPa"),
    (Text("whole shaft"), "shaft_mass", "kg"), (Text("against the design"), "mass_difference", "g"),
    (Text("first year"), "first_year_cost", "k€"), (Text("same cost at pieces"), "break_even", ""),
    (Text("development it bears"), "bearable_development", "k€"),
)  # fmt: skip


def compared_table(shaft: CountershaftInputs, results: Mapping[str, MaterialResult]) -> Table:
    """The materials beside each other; columns that nothing is known of are left out."""
    rows = list(results.values())
    whole = any(row.shaft_mass is not None for row in rows)  # which says more than the sectors alone
    shown = [
        c
        for c in COLUMNS
        if not (whole and c[1] in ("bore_growth", "eccentric_mass")) and any(getattr(row, c[1]) is not None for row in rows)
    ]
    units = [{"mm": 1e-3, "k€": 1e3, "MPa": 1e6, "g": 1e-3}.get(unit, 1.0) for _, _, unit in shown]
    cells = tuple(
        (row.name, *(None if getattr(row, c[1]) is None else float(getattr(row, c[1])) / unit for c, unit in zip(shown, units)))
        for row in rows
    )
    note = Text("The same couple from sectors of the same length and half-angle, so that a lighter material needs a larger radius.")
    if whole:
        note += Text(" The largest journal grows with them, the rest of the shaft keeps its shape.")
    if shaft.support is not None and shaft.support.wall is not None:
        note += Text(" The wall should keep {wall}.", wall=Amount(shaft.support.least_wall * 1e3, "mm", form="g"))
    if shaft.cost is not None:
        note += Text(" First year: tooling, development and {n} pieces; the comparison is with {material}.", n=shaft.cost.pieces_per_year,
            material=shaft.material)  # fmt: skip
    columns = ((Text("material"), ""), *((label, unit) for label, _, unit in shown))
    return Table("materials", Text("The shaft in other materials"), columns, cells, note, covers=("countershaft.alternative.",))
