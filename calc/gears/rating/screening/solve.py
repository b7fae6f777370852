# SPDX-License-Identifier: Apache-2.0
"""The screening of one mesh: its film and its flash temperature at the load that its load factors make."""

import math
from collections.abc import Mapping

import numpy as np

from ....library.catalogue import Material
from ....sheet.arrays import each
from ....sheet.errors import NoSolution
from ....sheet.text import Amount, Text
from ....sheet.units import Metre, Newton, Number, Pascal
from ....sheet.value import about, untraced
from ...result import MeshResult, ToothSystem, WheelResult
from .load import OilBath, Screening, load_of
from .micropitting import film
from .path import Path
from .scuffing import LOAD_STAGE, STIFFNESS, flash

PERMISSIBLE_FILM = (
    0.3  # rule of this program: Annex A of ISO/TR 15144-1, read from its figure by public code, has 0.06 to 0.6 by oil
)


def screening(
    system: ToothSystem,
    mesh: MeshResult,
    driver: WheelResult,
    driven: WheelResult,
    *,
    F_t: Newton,
    oil: OilBath,
    materials: Mapping[str, Material],
    roughness: tuple[Metre, Metre],
    load_factor: Number = 1.0,
    application_factor: Number = 1.0,
    accuracy_grade: Number = 7,
    mates: Number = 1,
    load_stage: Number | None = None,
    structural_factor: Number = 1.0,
    mesh_stiffness: Pascal = STIFFNESS,
    permissible_film: Number | None = None,
) -> Screening:
    """Film and flash temperature of a mesh.

    F_t is the nominal tangential force at the reference circle; `load_factor` is K_A·K_V·K_Hβ·K_Hα,
    `application_factor` K_A alone; `oil` from `oil_bath`, once for all meshes; `roughness` Ra of driver and driven;
    `mates` the most that one of both wheels has (2 for an idler); `load_stage` that of the FZG test A/8.3/90 at which
    the oil scuffs; `structural_factor` X_W of the steel (1 case-hardened,
    1.5 nitrided); `permissible_film` λ_GFP from a test of the oil.
    """
    title = mesh.title
    _possible(title, F_t, abs(driver.speed), roughness)
    stage = LOAD_STAGE if load_stage is None else load_stage
    a, b, z = mesh.centre_distance, mesh.face_width, (driver.teeth, driven.teeth)
    with about(Text("screening of mesh {title}", title=title)):
        path = Path(system, mesh, driver, driven, accuracy_grade)
        load = load_of(
            F_t,
            load_factor,
            application_factor,
            b,
            system.transverse_pressure_angle,
            mesh.total_contact_ratio,
            (driver.material, driven.material),
            materials,
            roughness,
        )
        with untraced():
            samples = path.samples()
            places = path.at(each(np.concatenate([list(path.marks().values()), samples])))
    with about(Text("film of mesh {title}", title=title)):
        thin = film(path, load, oil, a, b, driver.pitch_diameter, z, places)
    with about(Text("flash temperature of mesh {title}", title=title)):
        hot = flash(
            path,
            load,
            oil,
            b,
            mesh.working_pressure_angle,
            system.transverse_pressure_angle,
            places,
            mates,
            stage,
            structural_factor,
            mesh_stiffness,
        )
    return Screening(
        specific_film_min=thin.lam,
        film_min=thin.h,
        film_pressure=thin.p_dyn,
        friction_film=thin.mu_m,
        bulk_temperature_film=thin.T_M,
        flash_temperature_max=hot.T_fl,
        friction_flash=hot.mu_m,
        bulk_temperature_flash=hot.T_M,
        contact_temperature_max=hot.T_B,
        scuffing_temperature=hot.T_S,
        scuffing_safety=hot.S_B,
        scuffing_margin=hot.margin,
        title=title,
        film_place=thin.place,
        permissible_film=PERMISSIBLE_FILM if permissible_film is None else permissible_film,
        permissible_given=permissible_film is not None,
        load_stage=stage,
        load_stage_given=load_stage is not None,
        line_load=load.w_Bt,
        pitch_line_speed=math.pi * abs(driver.speed) * mesh.working_diameter_driver,
        oil_temperature=oil.T_oil,
        method_applies=path.shared_by_two,
        way=samples - path.C,
        flash=hot.along,
        specific_film=thin.along,
    )


def _possible(title: str, F_t: Newton, n: float, roughness: tuple[Metre, Metre]) -> None:
    for what, number in (
        (Text("the tangential force"), F_t),
        (Text("the speed"), n),
        (Text("the flank roughness"), min(roughness)),
    ):
        if not number > 0:
            raise NoSolution(
                Text("screening of mesh {title}: {what} is {number}", title=title, what=what, number=Amount(number)),
                advice=Text("film and flash temperature need load, speed and roughness"),
            )
