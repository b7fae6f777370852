# SPDX-License-Identifier: Apache-2.0
"""What is said about the influence factors of a mesh: its checks, its notes, the table of all meshes."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from ...sheet.check import Check, check
from ...sheet.step import Table
from ...sheet.units import UNITS, NewtonPerMetre, Number
from .distribution import CLAUSE_7
from .dynamic import MAIN_TO
from .influence import Influence
from .stiffness import CLAUSE_6, CLAUSE_9

if TYPE_CHECKING:
    from ..result import MeshResult

ISO = "ISO 6336-1, as generally published, from memory"
LEAST_LOAD: NewtonPerMetre = 50e3  # below, flanks may part and hammer


def influence_checks(key: str, mesh: "MeshResult", found: Influence) -> list[Check]:
    """`key`: DRIVER_DRIVEN."""
    id, pair = f"gears.{key}", f"{mesh.driver}–{mesh.driven}"
    below = found.resonance_ratio <= 1
    slower, faster = found.lower_resonance, MAIN_TO
    judged = [
        check(
            f"{id}.line_load", f"Load per face width {pair}", found.line_load, ">=", LEAST_LOAD, "N/mm",
            f"{ISO}: below 50 N/mm flanks can part and hammer; the factors are made for 100 N/mm and more",
            "K_V, K_Hβ and K_Hα are outside their validity here: small deviations over a small load. "
            "What governs is the torque of the speed's irregularity "
            "(gears.speed_irregularity) or the application factor; a narrower face width raises the load per width.",
            kind="advice",
        ),
        check(
            f"{id}.resonance", f"Speed of {pair} over its main resonance, {found.speed_range}", found.resonance_ratio,
            "<=" if below else ">=", slower if below else faster, "", f"{CLAUSE_6}: the main resonance lies from N_S to 1.15",
            "Change the number of teeth, or the mass of the wheels, so that the teeth do not meet at the natural frequency of the pair.",
            kind="advice",
        ),
        check(
            f"{id}.shift_sum", f"Sum of the profile shifts {pair}", mesh.shift_sum, "in", (-0.5, 2.0), "",
            f"{CLAUSE_9}: range of the stiffness of the teeth",
            "The stiffness of the teeth is extrapolated; the factors K are uncertain.", kind="advice",
        ),
    ]  # fmt: skip
    if found.line_load >= LEAST_LOAD:  # below it no teeth are pressed together over their whole width
        judged.append(
            check(
                f"{id}.contact_width", f"Face width that touches, {pair}", found.contact_width_share, ">=", 1.0, "%",
                f"{CLAUSE_7}: K_Hβ up to 2",
                "The load is too small to press the misaligned teeth together over the whole face width: crown or end-relieve the teeth, "
                "or hold the axes more parallel (mesh_misalignment_um of the mesh, gears.accuracy_grade).",
                kind="advice",
            )
        )  # fmt: skip
    return judged


def influence_notes(mesh: "MeshResult", found: Influence, grade: Number) -> tuple[str, ...]:
    """What was assumed, and what is outside its range."""
    pair = f"{mesh.driver}–{mesh.driven}"
    said = []
    if not found.misalignment_given:
        said.append(
            f"Mesh {pair}: misalignment by manufacture not given; chosen: {found.manufacturing_misalignment * 1e6:.3g} µm from the helix "
            f"slopes that grade {grade:g} of ISO 1328-1 permits both wheels; no crowning."
        )
    if found.face_load_factor_at_100 is not None:
        said.append(
            f"Mesh {pair}: K_Hβ is that of the load as it is, {found.face_load_factor_flank:.3g}; held at 100 N/mm, as DIN 3990-11 does, "
            f"it would be {found.face_load_factor_at_100:.3g}."
        )
    if found.out_of_range:
        said.append(f"Mesh {pair}: ISO 1328-1 has no tolerances for {', '.join(found.out_of_range)}: they are extrapolated.")
    return tuple(said)


COLUMNS = (
    ("line_load", "N/mm"), ("dynamic_factor", ""), ("face_load_factor_flank", ""), ("face_load_factor_root", ""),
    ("transverse_load_factor_flank", ""), ("transverse_load_factor_root", ""), ("resonance_ratio", ""), ("mesh_stiffness", "GPa"),
)  # fmt: skip
HEADS = ("w", "K_V", "K_Hβ", "K_Fβ", "K_Hα", "K_Fα", "N", "c_γα")


def influence_table(found: Mapping[str, Influence]) -> Table:
    """The factors of all meshes side by side; `found` by DRIVER_DRIVEN."""
    rows: list[tuple[str | float | None, ...]] = []
    for key, one in found.items():
        rows.append((key.replace("_", "–"), *(UNITS[unit].shown(getattr(one, name)) for name, unit in COLUMNS)))
    return Table(
        "influence_factors", "Influence factors of ISO 6336-1", (("mesh", ""), *((head, unit) for head, (_, unit) in zip(HEADS, COLUMNS))),
        tuple(rows),
        "c_γα: GPa = N/(mm·µm). The load on the teeth is F_t·K_A times K_V, K_Hβ, K_Hα on the flank and K_V, K_Fβ, K_Fα at the root.",
        tuple(f"gears.{key}.{name}" for key in found for name, _ in COLUMNS),
    )  # fmt: skip
