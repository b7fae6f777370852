# SPDX-License-Identifier: Apache-2.0
"""The screening of one mesh: its film and its flash temperature, what is judged on them, what is drawn, what is said."""

import math
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ....catalogue import Material
from ....sheet.arrays import Array
from ....sheet.check import Check, check
from ....sheet.errors import NoSolution
from ....sheet.number import short
from ....sheet.step import Curve, Series
from ....sheet.trace import about, untraced
from ....sheet.units import Kelvin, Metre, Newton, NewtonPerMetre, Number, Pascal
from .load import OilBath, load_of
from .micropitting import film
from .path import Path
from .result import Screening
from .scuffing import LOAD_STAGE, STIFFNESS, flash

if TYPE_CHECKING:
    from ...result import MeshResult, ToothSystem, WheelResult

PERMISSIBLE_FILM = 0.3  # rule of this program: Annex A of ISO/TR 15144-1, read from its figure by public code, has 0.06 to 0.6 by oil
MARGIN: Kelvin = 50.0  # ISO/TR 13989-1:2000, 10.5
TESTED = "modules of 3 to 11 mm and 8 to 60 m/s"
LOWEST_TEST_PRESSURE: Pascal = 800e6  # load stage 5 of the FZG test C-GF, from memory
LIGHT: NewtonPerMetre = 100e3  # of line load, ISO 6336-1: below, its load factors are no longer proportional


def screening(
    system: "ToothSystem", mesh: "MeshResult", driver: "WheelResult", driven: "WheelResult", *,
    F_t: Newton, oil: OilBath, materials: Mapping[str, Material], roughness: tuple[Metre, Metre],
    load_factor: Number = 1.0, application_factor: Number = 1.0, accuracy_grade: Number = 7, mates: Number = 1,
    load_stage: Number | None = None, structural_factor: Number = 1.0, mesh_stiffness: Pascal = STIFFNESS,
    permissible_film: Number | None = None,
) -> Screening:  # fmt: skip
    """Film and flash temperature of a mesh.

    F_t is the nominal tangential force at the reference circle; `load_factor` is K_A·K_V·K_Hβ·K_Hα, `application_factor` K_A alone;
    `oil` from `oil_bath`, once for all meshes; `roughness` Ra of driver and driven; `mates` the most that one of both wheels has (2 for
    an idler); `load_stage` that of the FZG test A/8.3/90 at which the oil scuffs; `structural_factor` X_W of the steel (1 case-hardened,
    1.5 nitrided); `permissible_film` λ_GFP from a test of the oil.
    """
    title = f"{mesh.driver}–{mesh.driven}"
    _possible(title, F_t, abs(driver.speed), roughness)
    stage = LOAD_STAGE if load_stage is None else load_stage
    a, b, z = mesh.centre_distance, mesh.face_width, (driver.teeth, driven.teeth)
    with about(f"screening of mesh {title}"):
        path = Path(system, mesh, driver, driven, accuracy_grade)
        load = load_of(
            F_t, load_factor, application_factor, b, system.transverse_pressure_angle, mesh.total_contact_ratio,
            (driver.material, driven.material), materials, roughness,
        )  # fmt: skip
        with untraced():
            samples = path.samples()
            places = path.at(_joined(path.marks().values(), samples))
    with about(f"film of mesh {title}"):
        thin = film(path, load, oil, a, b, driver.pitch_diameter, z, places)
    with about(f"flash temperature of mesh {title}"):
        hot = flash(
            path, load, oil, b, mesh.working_pressure_angle, system.transverse_pressure_angle, places, mates, stage, structural_factor,
            mesh_stiffness,
        )  # fmt: skip
    return Screening(
        specific_film_min=thin.lam, film_min=thin.h, film_pressure=thin.p_dyn, friction_film=thin.mu_m, bulk_temperature_film=thin.T_M,
        flash_temperature_max=hot.T_fl, friction_flash=hot.mu_m, bulk_temperature_flash=hot.T_M, contact_temperature_max=hot.T_B,
        scuffing_temperature=hot.T_S, scuffing_safety=hot.S_B, scuffing_margin=hot.margin, title=title, film_place=thin.place,
        permissible_film=PERMISSIBLE_FILM if permissible_film is None else permissible_film,
        permissible_given=permissible_film is not None, load_stage=stage, load_stage_given=load_stage is not None,
        line_load=load.w_Bt, pitch_line_speed=math.pi * abs(driver.speed) * mesh.working_diameter_driver, oil_temperature=oil.T_oil,
        method_applies=path.shared_by_two, way=samples - path.C, flash=hot.along, specific_film=thin.along,
    )  # fmt: skip


def _joined(marks: Iterable[float], samples: Array) -> Any:
    return np.concatenate([list(marks), samples])


def _possible(title: str, F_t: Newton, n: float, roughness: tuple[Metre, Metre]) -> None:
    for what, number in (("the tangential force", F_t), ("the speed", n), ("the flank roughness", min(roughness))):
        if not number > 0:
            raise NoSolution(
                f"screening of mesh {title}: {what} is {short(number)}", advice="film and flash temperature need load, speed and roughness"
            )


def checks(key: str, found: Screening) -> tuple[Check, ...]:
    """What is judged, as advice; `key` is that of the mesh, "driver_driven"."""
    judged = []
    if found.specific_film_min is not None:
        limit = "λ_GFP of the oil's test" if found.permissible_given else "λ_GFP by a rule of this program; a test of the oil gives its own"
        judged.append(
            check(
                f"gears.{key}.micropitting_film", f"Specific film thickness {found.title} at {found.film_place} (screening)",
                found.specific_film_min, ">=", found.permissible_film, "",
                f"ISO/TR 15144-1:2014, ISO/TS 6336-22:2018, method B, as generally published; {limit}",
                f"Smoother flanks (gears.flank_rz_um), cooler or thicker oil, more speed; stronger steel does not help. {_pressure(found)}",
                kind="advice",
            )
        )  # fmt: skip
    stage = f"FZG load stage {found.load_stage:g}" + ("" if found.load_stage_given else ", assumed by a rule of this program")
    judged.append(
        check(
            f"gears.{key}.scuffing", f"Scuffing temperature above the contact temperature {found.title} (screening)",
            found.scuffing_margin, ">=", MARGIN, "K",
            f"ISO/TR 13989-1:2000 (ISO/TS 6336-20), as generally published, 10.5: for instance 50 K; {stage}",
            "Cooler oil, an oil of a higher load stage, smoother flanks, less sliding (shorter addenda), or more face width.",
            kind="advice",
        )
    )  # fmt: skip
    return tuple(judged)


def _pressure(found: Screening) -> str:
    """How the Hertzian pressure stands to that of the test of oils."""
    lowest = f"{LOWEST_TEST_PRESSURE / 1e6:.0f} MPa"
    if (found.film_pressure or 0.0) < LOWEST_TEST_PRESSURE:
        return (
            f"The pressure is below that of the first stage of the test of oils against micropitting (FZG C-GF, about {lowest}, from "
            "memory): a thin film alone then need not harm."
        )
    return "Have the oil tested (FZG C-GF/8.3/90): its result gives the permissible film."


def curves(key: str, found: Screening) -> tuple[Curve, ...]:
    """Contact temperature and specific film thickness along the path of contact."""
    x, axis = found.way * 1e3, "way on the line of action from the pitch point, mm"
    drawn = [
        Curve(
            f"contact_temperature_{key}", f"Contact temperature, {found.title} (screening)", axis, "Θ_B, °C",
            (Series("bulk and flash temperature", x, found.bulk_temperature_flash + found.flash),),
            limits=(("scuffing temperature", found.scuffing_temperature), ("oil", found.oil_temperature)),
        )
    ]  # fmt: skip
    if found.specific_film is not None:
        drawn.append(
            Curve(
                f"specific_film_{key}", f"Specific film thickness, {found.title} (screening)", axis, "λ_GF",
                (Series("λ_GF", x, found.specific_film),), limits=(("permissible", found.permissible_film),),
            )
        )  # fmt: skip
    return tuple(drawn)


def notes(system: "ToothSystem", all_found: Iterable[Screening], base: str) -> tuple[str, ...]:
    """What the screening of all meshes rests on; `base` is the base stock of the oil."""
    found = list(all_found)
    if not found:
        return ()
    loads, speeds = [f.line_load / 1e3 for f in found], [f.pitch_line_speed for f in found]
    said = [
        "Film against micropitting and flash temperature against scuffing are a screening, not a rating: that of the film is made from "
        f"tests with {TESTED} (ISO/TS 6336-22:2018); here m_n is {short(system.m_n * 1e3)} mm, {_span(speeds)} m/s"
        + (f", and the line loads of {_span(loads)} N/mm are far below those of the tests." if max(loads) < LIGHT / 1e3 else ".")
    ]
    if not all(f.load_stage_given for f in found):
        said.append(
            f"No FZG load stage of the oil is given: stage {LOAD_STAGE:g} of the test A/8.3/90 is assumed for its scuffing temperature."
        )
    if not all(f.permissible_given for f in found):
        said.append(f"No micropitting test of the oil is given: a specific film thickness of {PERMISSIBLE_FILM:g} is taken as permissible.")
    if base not in ("mineral", "PAO", "PAG"):
        said.append(f"The lubricant factor of {base} oil is not in the methods: it counts as mineral oil.")
    for f in found:
        if not f.method_applies:
            said.append(
                f"Mesh {f.title}: with ε_α of 2 or more the methods give no load sharing; one pair is taken to carry all, on the safe side."
            )
        if f.specific_film_min is None:
            said.append(f"Mesh {f.title}: a contact hotter than 500 °C is beyond the law of the oil: no film is given.")
    return tuple(said)


def _span(numbers: list[float]) -> str:
    low, high = f"{min(numbers):.3g}", f"{max(numbers):.3g}"
    return low if low == high else f"{low} to {high}"
