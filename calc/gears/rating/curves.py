# SPDX-License-Identifier: Apache-2.0
"""The curves and tables of the rating: film and temperature along the path of contact, influence factors, strength of
flanks and roots."""

from collections.abc import Mapping

from ...sheet.step import Curve, Series, Table, axis_label
from ...sheet.text import Amount, Name, Text
from ...sheet.units import UNITS
from .classes import MEGAPASCAL, TABLE_1, StrengthClass
from .mesh_strength import BENDING, CONTACT, Row
from .result import Influence, MeshRating, MeshStrength
from .screening.load import Screening

FACTORS = (
    ("line_load", "w", "N/mm"),
    ("dynamic_factor", "K_V", ""),
    ("face_load_factor_flank", "K_Hβ", ""),
    ("face_load_factor_root", "K_Fβ", ""),
    ("transverse_load_factor_flank", "K_Hα", ""),
    ("transverse_load_factor_root", "K_Fα", ""),
    ("resonance_ratio", "N", ""),
    ("mesh_stiffness", "c_γα", "GPa"),
)


def curves(rated: Mapping[str, MeshRating]) -> tuple[Curve, ...]:
    """Film and contact temperature of the mesh whose film is thinnest."""
    screened = {key: rating.screening for key, rating in rated.items() if rating.screening is not None}
    films = {key: s.specific_film_min for key, s in screened.items() if s.specific_film_min is not None}
    key = min(films, key=films.__getitem__) if films else next(iter(screened), None)
    return screening_curves(key, screened[key]) if key is not None else ()


def screening_curves(key: str, screened: Screening) -> tuple[Curve, ...]:
    """Contact temperature and specific film thickness along the path of contact."""
    title, x, axis = screened.title, screened.way * 1e3, Text("way on the line of action from the pitch point, mm")
    bulk_and_flash = Series(Text("bulk and flash temperature"), x, screened.bulk_temperature_flash + screened.flash)
    temperature = Curve(
        f"contact_temperature_{key}",
        Text("Contact temperature, {title} (screening)", title=title),
        axis,
        axis_label("Θ_B", "°C"),
        (bulk_and_flash,),
        limits=((Text("scuffing temperature"), screened.scuffing_temperature), (Text("oil"), screened.oil_temperature)),
    )
    if screened.specific_film is None:
        return (temperature,)
    film = Curve(
        f"specific_film_{key}",
        Text("Specific film thickness, {title} (screening)", title=title),
        axis,
        Text("λ_GF"),
        (Series(Text("λ_GF"), x, screened.specific_film),),
        limits=((Text("permissible"), screened.permissible_film),),
    )
    return temperature, film


def influence_table(meshes: Mapping[str, Influence]) -> Table:
    """The factors of all meshes side by side; `meshes` by DRIVER_DRIVEN."""
    return Table(
        "influence_factors",
        Text("Influence factors of ISO 6336-1"),
        ((Text("mesh"), ""), *((Name(symbol), unit) for _, symbol, unit in FACTORS)),
        tuple(
            (key.replace("_", "–"), *(UNITS[unit].shown(getattr(factors, name)) for name, _, unit in FACTORS))
            for key, factors in meshes.items()
        ),
        Text(
            "c_γα: GPa = N/(mm·µm). The load on the teeth is F_t·K_A times K_V, K_Hβ, K_Hα on the flank and K_V, "
            "K_Fβ, K_Fα at the root."
        ),
        tuple(f"gears.{key}.{name}" for key in meshes for name, *_ in FACTORS),
    )


def strength_tables(meshes: Mapping[str, MeshStrength]) -> tuple[Table, Table]:
    """Flanks and roots of all meshes, every factor in its column."""
    film = Text("; ").join(
        Text(
            "{pair}: Z_L {z_l}, Z_v {z_v}, Z_R {z_r}",
            pair=mesh.pair,
            z_l=Amount(mesh.lubricant_factor, form=".4g"),
            z_v=Amount(mesh.velocity_factor, form=".4g"),
            z_r=Amount(mesh.roughness_factor, form=".4g"),
        )
        for mesh in meshes.values()
    )
    flank_note = Text(
        "σ_HG = σ_Hlim·Z_NT·Z_L·Z_v·Z_R·Z_W, Z_X = 1. {film}. S_H is on stress; on load it counts squared.", film=film
    )
    root_note = Text(
        "σ_FG = σ_Flim·Y_ST·Y_NT·Y_δrelT·Y_RrelT·Y_X·Y_M, Y_ST = 2; Y_M 0.7 where a wheel is driven by one and drives "
        "another, or the torque changes its sign."
    )
    flanks, roots = Text("Flanks: stress and strength"), Text("Tooth roots: stress and strength")
    return (
        _strength_table("gear_flank_strength", flanks, CONTACT, "contact", meshes, flank_note),
        _strength_table("gear_root_strength", roots, BENDING, "bending", meshes, root_note),
    )


def _strength_table(
    id: str, title: Text, rows: tuple[Row, ...], part: str, meshes: Mapping[str, MeshStrength], note: Text
) -> Table:
    """`part` of MeshStrength, by wheel; the safety, first of the rows, stays a value of its own."""
    cells: list[tuple[str | float | None, ...]] = []
    for mesh in meshes.values():
        for wheel, strength in getattr(mesh, part).items():
            numbers = ((getattr(strength, attribute), UNITS[about.unit].factor) for _, about, attribute in rows)
            cells.append((mesh.pair, wheel, *(None if n is None else n / factor for n, factor in numbers)))
    columns = ((Text("mesh"), ""), (Text("wheel"), ""), *((Name(about.symbol), about.unit) for _, about, _ in rows))
    covers = tuple(
        f"gears.{key}.{id}_{wheel}" for key, mesh in meshes.items() for wheel in mesh.contact for id, *_ in rows[1:]
    )
    return Table(id, title, columns, tuple(cells), note, covers)


def classes_table(classes: Mapping[str, StrengthClass]) -> Table:
    """The wheels with their classes and the two stress numbers."""
    return Table(
        "gear_strength_classes",
        Text("Strength classes of the wheels"),
        (
            (Text("wheel"), ""),
            (Text("class"), ""),
            (Text("kind"), ""),
            (Text("quality"), ""),
            (Text("hardness"), "HV"),
            (Text("σ_Hlim"), "MPa"),
            (Text("σ_Flim"), "MPa"),
        ),
        tuple(
            (wheel, c.name, c.kind, c.quality, c.hardness, c.sigma_Hlim / MEGAPASCAL, c.sigma_Flim / MEGAPASCAL)
            for wheel, c in classes.items()
        ),
        Text("{table_1}; for 1 % probability of failure. A hardness that is not given stays empty.", table_1=TABLE_1),
    )
