# SPDX-License-Identifier: Apache-2.0
"""One mesh, once its wheels and its centre distance are known: contact, sliding, clearances, backlash."""

from typing import Any

from ..sheet.errors import NoSolution
from ..sheet.trace import about
from ..sheet.units import Metre, Number, Radian
from . import formulas as f
from .inputs import Mesh
from .play.backlash import Pair, backlash, narrowest, widest
from .play.stack import centre_tolerance
from .practice import above_fillet
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
                advice=f"the tips reach {(driver.tip_diameter + driven.tip_diameter) / 2 * 1e3:.4f} mm together; bring the wheels closer, "
                "cut less off the tips, or give larger profile shifts",
            )
        eps_alpha = f.transverse_contact_ratio(path, system.base_pitch)
        b = min(driver.face_width, driven.face_width)
        eps_beta = f.overlap_ratio(b, system.beta, system.m_n)
        d_w1, d_w2 = f.working_diameter(a_w, z_1, z_2), f.working_diameter(a_w, z_2, z_1)
        d_Nf1, d_Nf2 = f.diameter_at(driver.base_diameter, rho_A1), f.diameter_at(driven.base_diameter, rho_A2)
        tolerance = centre_tolerance(mesh)
        values: dict[str, Any] = dict(
            centre_distance=a_w, working_pressure_angle=alpha_wt,
            working_helix_angle=f.working_helix_angle(system.base_helix_angle, alpha_wt),
            centre_modification=f.centre_modification(a_w, driver.pitch_diameter, driven.pitch_diameter, system.m_n),
            shift_sum=f.sum_of_shifts(driver.profile_shift, driven.profile_shift), working_module=f.working_module(a_w, z_1, z_2),
            working_diameter_driver=d_w1, working_diameter_driven=d_w2,
            working_thickness_driver=_thickness(system, driver, d_w1, alpha_wt),
            working_thickness_driven=_thickness(system, driven, d_w2, alpha_wt),
            standard_tip_shortening=f.standard_tip_shortening(
                driver.profile_shift, driven.profile_shift, system.m_n, a_w, driver.pitch_diameter, driven.pitch_diameter
            ),
            transverse_contact_ratio=eps_alpha, overlap_ratio=eps_beta, total_contact_ratio=f.total_contact_ratio(eps_alpha, eps_beta),
            sap_diameter_driver=d_Nf1, sap_diameter_driven=d_Nf2,
            form_margin_driver=above_fillet(driver.base_diameter, T, driven.tip_curvature, driver.form_diameter),
            form_margin_driven=above_fillet(driven.base_diameter, T, driver.tip_curvature, driven.form_diameter),
            tip_clearance_driver=f.tip_clearance(a_w, driver.root_diameter, driven.tip_diameter),
            tip_clearance_driven=f.tip_clearance(a_w, driven.root_diameter, driver.tip_diameter),
            specific_sliding_driver=f.specific_sliding(T, rho_A1, z_1, z_2),
            specific_sliding_driven=f.specific_sliding(T, rho_A2, z_2, z_1),
            specific_sliding_tip_driver=f.specific_sliding(T, driver.tip_curvature, z_1, z_2),
            specific_sliding_tip_driven=f.specific_sliding(T, driven.tip_curvature, z_2, z_1),
            **_single_contact(system, T, (driver, driven), (rho_A1, rho_A2), eps_alpha),
            face_width=b, line_of_action=T, sap_curvature_driver=rho_A1, sap_curvature_driven=rho_A2, centre_tolerance=tolerance,
        )  # fmt: skip
    if tolerance or driver.tip_diameter_min is not None or driven.tip_diameter_min is not None:
        with about(f"mesh {mesh.driver}–{mesh.driven}, shortest tips and widest centres"):
            values["transverse_contact_ratio_min"] = _least_contact(system, a_w, tolerance, (driver, driven))
    if tolerance or any(w.tip_diameter_max is not None or w.root_diameter_max is not None for w in (driver, driven)):
        with about(f"mesh {mesh.driver}–{mesh.driven}, longest tips and closest centres"):
            values |= _closest(a_w, tolerance, (driver, driven))
    play = backlash(system, Pair(place, driver, driven, a_w, tolerance))
    return MeshResult(
        **values, driver=mesh.driver, driven=mesh.driven, backlash_min=play.smallest, backlash_nominal=play.nominal,
        backlash_max=play.largest, play_angle=play.play_angle,
    )  # fmt: skip


def _thickness(system: ToothSystem, wheel: WheelResult, d_w: Metre, alpha_wt: Radian) -> Metre:
    return f.thickness_at(d_w, wheel.reference_thickness, wheel.pitch_diameter, system.transverse_pressure_angle, alpha_wt)


def _single_contact(
    system: ToothSystem, T: Metre, wheels: tuple[WheelResult, WheelResult], starts: tuple[Metre, Metre], eps_alpha: Number
) -> dict[str, Metre]:
    """Ends of single contact on both wheels, and the sliding at the lower one; nothing where there is no single contact."""
    found: dict[str, Metre] = {}
    if not 1 <= eps_alpha < 2:
        return found
    for i, end in enumerate(("driver", "driven")):
        wheel, mate = wheels[i], wheels[1 - i]
        rho_B = f.lowest_single_contact(T, starts[1 - i], system.base_pitch)
        found[f"specific_sliding_lpstc_{end}"] = f.specific_sliding(T, rho_B, wheel.teeth, mate.teeth)
        found[f"lpstc_diameter_{end}"] = f.diameter_at(wheel.base_diameter, rho_B)
        found[f"hpstc_diameter_{end}"] = f.diameter_at(wheel.base_diameter, f.highest_single_contact(starts[i], system.base_pitch))
    return found


def _least_contact(system: ToothSystem, a_w: Metre, tolerance: Metre, wheels: tuple[WheelResult, WheelResult]) -> Number:
    """ε_α with the shortest tips at the widest centre distance."""
    a = widest(a_w, tolerance) if tolerance else a_w
    T = f.line_of_action(a, f.working_pressure_angle(wheels[0].base_diameter, wheels[1].base_diameter, a))
    rho_a = [w.tip_curvature if w.tip_diameter_min is None else f.curvature_at(w.tip_diameter_min, w.base_diameter) for w in wheels]
    starts = [f.start_of_active_profile(T, rho_a[1 - i], w.form_curvature) for i, w in enumerate(wheels)]
    return f.transverse_contact_ratio(f.path_of_contact(T, *starts), system.base_pitch)


def _closest(a_w: Metre, tolerance: Metre, wheels: tuple[WheelResult, WheelResult]) -> dict[str, Metre]:
    """Clearance and start of contact where the tips are longest, the roots and fillets highest, and the centres closest."""
    a = narrowest(a_w, tolerance) if tolerance else a_w
    found: dict[str, Metre] = {}
    if a <= (wheels[0].base_diameter + wheels[1].base_diameter) / 2:
        return found  # which the backlash says
    T = f.line_of_action(a, f.working_pressure_angle(wheels[0].base_diameter, wheels[1].base_diameter, a))
    clearances, margins = [], []
    for own, mate in (wheels, wheels[::-1]):
        d_f = own.root_diameter if own.root_diameter_max is None else own.root_diameter_max
        d_Ff = own.form_diameter if own.form_diameter_max is None else own.form_diameter_max
        d_a = mate.tip_diameter if mate.tip_diameter_max is None else mate.tip_diameter_max
        clearances.append(f.tip_clearance(a, d_f, d_a))
        margins.append(above_fillet(own.base_diameter, T, f.curvature_at(d_a, mate.base_diameter), d_Ff))
    return {"tip_clearance_min": min(clearances), "form_margin_min": min(margins)}


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
