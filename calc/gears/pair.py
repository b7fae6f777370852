# SPDX-License-Identifier: Apache-2.0
"""One mesh, once its wheels and its centre distance are known: contact, sliding, clearances, backlash."""

from typing import Any

from ..sheet.errors import NoSolution
from ..sheet.trace import about
from ..sheet.units import Metre
from . import formulas as f
from .inputs import Mesh
from .play.backlash import Pair, backlash, tolerance_of_contributors
from .result import MeshResult, ToothSystem, WheelResult


def solve_mesh(system: ToothSystem, mesh: Mesh, place: str, a_w: Metre, driver: WheelResult, driven: WheelResult) -> MeshResult:
    z_1, z_2 = driver.teeth, driven.teeth
    with about(f"mesh {mesh.driver}–{mesh.driven}"):
        alpha_wt = f.working_pressure_angle(driver.base_diameter, driven.base_diameter, a_w)
        T = f.line_of_action(a_w, alpha_wt)
        rho_A1 = _start(driver, driven, T)
        rho_A2 = _start(driven, driver, T)
        path = f.path_of_contact(T, rho_A1, rho_A2)
        if path <= 0:
            raise NoSolution(
                f"{place}.centre_distance_mm = {a_w * 1e3:.6g}: the flanks of {mesh.driver} and {mesh.driven} do not reach each other",
                advice="bring the wheels closer, cut less off the tips, or give larger profile shifts",
            )
        eps_alpha = f.transverse_contact_ratio(path, system.base_pitch)
        b = min(driver.face_width, driven.face_width)
        eps_beta = f.overlap_ratio(b, system.beta, system.m_n)
        lpstc_1 = lpstc_2 = None
        if 1 <= eps_alpha < 2:
            lpstc_1 = f.specific_sliding(T, f.lowest_single_contact(T, rho_A2, system.base_pitch), z_1, z_2)
            lpstc_2 = f.specific_sliding(T, f.lowest_single_contact(T, rho_A1, system.base_pitch), z_2, z_1)
        fields: Any = mesh.contributors
        tolerance = tolerance_of_contributors(fields) if fields else mesh.tolerance or 0.0
        values: dict[str, Any] = dict(
            centre_distance=a_w, working_pressure_angle=alpha_wt,
            working_helix_angle=f.working_helix_angle(system.base_helix_angle, alpha_wt),
            working_diameter_driver=f.working_diameter(a_w, z_1, z_2), working_diameter_driven=f.working_diameter(a_w, z_2, z_1),
            standard_tip_shortening=f.standard_tip_shortening(
                driver.profile_shift, driven.profile_shift, system.m_n, a_w, driver.pitch_diameter, driven.pitch_diameter
            ),
            transverse_contact_ratio=eps_alpha, overlap_ratio=eps_beta, total_contact_ratio=f.total_contact_ratio(eps_alpha, eps_beta),
            sap_diameter_driver=f.diameter_at(driver.base_diameter, rho_A1),
            sap_diameter_driven=f.diameter_at(driven.base_diameter, rho_A2),
            tip_clearance_driver=f.tip_clearance(a_w, driver.root_diameter, driven.tip_diameter),
            tip_clearance_driven=f.tip_clearance(a_w, driven.root_diameter, driver.tip_diameter),
            specific_sliding_driver=f.specific_sliding(T, rho_A1, z_1, z_2),
            specific_sliding_driven=f.specific_sliding(T, rho_A2, z_2, z_1),
            specific_sliding_lpstc_driver=lpstc_1, specific_sliding_lpstc_driven=lpstc_2,
            face_width=b, line_of_action=T, sap_curvature_driver=rho_A1, sap_curvature_driven=rho_A2, centre_tolerance=tolerance,
        )  # fmt: skip
    play = backlash(system, Pair(place, driver, driven, a_w, tolerance))
    return MeshResult(
        **values, driver=mesh.driver, driven=mesh.driven, backlash_min=play.smallest, backlash_nominal=play.nominal,
        backlash_max=play.largest, play_angle=play.play_angle,
    )  # fmt: skip


def _start(wheel: WheelResult, mate: WheelResult, T: Metre) -> Metre:
    """Where contact begins on a wheel, as the radius of curvature; it must lie outside the base circle."""
    rho_A = f.start_of_active_profile(T, mate.tip_curvature, wheel.form_curvature)
    if rho_A > 0:
        return rho_A
    largest = f.diameter_at(mate.base_diameter, T)
    raise NoSolution(
        f"wheels {wheel.name} and {mate.name}: the tip of {mate.name} reaches {(mate.tip_curvature - T) * 1e3:.4g} mm past the point "
        f"where the line of action touches the base circle of {wheel.name}",
        advice=f"cut the tip of {mate.name} ({mate.tip_diameter * 1e3:.4f} mm) below {largest * 1e3:.4f} mm by "
        f"gears.wheels.{mate.name}.tip_shortening_mm, give {wheel.name} more profile shift, or set the wheels further apart",
    )
