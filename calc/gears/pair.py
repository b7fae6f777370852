# SPDX-License-Identifier: Apache-2.0
"""One mesh, once its wheels and its centre distance are known: contact, sliding, clearances, backlash."""

from ..sheet.errors import NoSolution
from ..sheet.text import Text
from ..sheet.units import Metre, Number, Radian
from ..sheet.value import about
from . import formulas as f
from .backlash.case import backlash, centre_tolerance
from .backlash.formulas import narrowest, widest
from .inputs import Mesh
from .limits import above_fillet, mm
from .result import MeshResult, ToothSystem, WheelResult


def solve_mesh(
    system: ToothSystem, mesh: Mesh, place: str, a_w: Metre, driver: WheelResult, driven: WheelResult
) -> MeshResult:
    z_1, z_2 = driver.teeth, driven.teeth
    with about(Text("mesh {pair}", pair=mesh.title)):
        alpha_wt = f.working_pressure_angle(driver.base_diameter, driven.base_diameter, a_w)
        T = f.line_of_action(a_w, alpha_wt)
        rho_A1 = _start(driver, driven, T)
        rho_A2 = _start(driven, driver, T)
        path = f.path_of_contact(T, rho_A1, rho_A2)
        if path <= 0:
            raise NoSolution(
                Text(
                    "{place}.centre_distance_mm = {a_w}: the flanks of {driver} and {driven} do not reach each other",
                    place=place,
                    a_w=mm(a_w, ".6g"),
                    driver=mesh.driver,
                    driven=mesh.driven,
                ),
                advice=Text(
                    "the tips reach {tip_diameter} mm together; bring the wheels closer, cut less off the tips, or "
                    "give larger profile shifts",
                    tip_diameter=mm((driver.tip_diameter + driven.tip_diameter) / 2, ".4f"),
                ),
            )
        eps_alpha = f.transverse_contact_ratio(path, system.base_pitch)
        b = min(driver.face_width, driven.face_width)
        eps_beta = f.overlap_ratio(b, system.beta, system.m_n)
        d_1, d_2 = driver.reference_diameter, driven.reference_diameter
        x_1, x_2 = driver.profile_shift, driven.profile_shift
        tolerance = centre_tolerance(mesh)
        values: dict[str, float] = dict(
            centre_distance=a_w,
            working_pressure_angle=alpha_wt,
            working_helix_angle=f.working_helix_angle(system.base_helix_angle, alpha_wt),
            working_module=f.working_module(a_w, z_1, z_2),
            centre_modification=f.centre_modification(a_w, d_1, d_2, system.m_n),
            shift_sum=f.sum_of_shifts(x_1, x_2),
            standard_tip_shortening=f.standard_tip_shortening(x_1, x_2, system.m_n, a_w, d_1, d_2),
            transverse_contact_ratio=eps_alpha,
            overlap_ratio=eps_beta,
            total_contact_ratio=f.total_contact_ratio(eps_alpha, eps_beta),
            face_width=b,
            line_of_action=T,
            centre_tolerance=tolerance,
        )
        for end, wheel, mate, starts in (
            ("driver", driver, driven, (rho_A1, rho_A2)),
            ("driven", driven, driver, (rho_A2, rho_A1)),
        ):
            sizes = _side(system, a_w, alpha_wt, T, wheel, mate, *starts, 1 <= eps_alpha < 2)
            values |= {f"{name}_{end}": size for name, size in sizes.items()}
    if tolerance or driver.tip_diameter_min is not None or driven.tip_diameter_min is not None:
        with about(Text("mesh {pair}, shortest tips and widest centres", pair=mesh.title)):
            values["transverse_contact_ratio_min"] = _least_contact(system, a_w, tolerance, (driver, driven))
    if tolerance or any(w.tip_diameter_max is not None or w.root_diameter_max is not None for w in (driver, driven)):
        with about(Text("mesh {pair}, longest tips and closest centres", pair=mesh.title)):
            values |= _closest(a_w, tolerance, (driver, driven))
    values |= backlash(system, place, driver, driven, a_w, tolerance)
    return MeshResult(**values, driver=mesh.driver, driven=mesh.driven, rating=None, over_speed=None)


def _side(
    system: ToothSystem,
    a_w: Metre,
    alpha_wt: Radian,
    T: Metre,
    wheel: WheelResult,
    mate: WheelResult,
    start: Metre,
    end: Metre,
    single: bool,
) -> dict[str, float]:
    """What a mesh makes of one of its wheels.  `start`, `end`: ρ_A of the wheel and of its mate; `single`: there is
    single contact."""
    z, z_m, d_w = wheel.teeth, mate.teeth, f.working_diameter(a_w, wheel.teeth, mate.teeth)
    sizes = {
        "working_diameter": d_w,
        "sap_diameter": f.diameter_at(wheel.base_diameter, start),
        "sap_curvature": start,
        "working_thickness": f.thickness_at(
            d_w, wheel.reference_thickness, wheel.reference_diameter, system.transverse_pressure_angle, alpha_wt
        ),
        "form_margin": above_fillet(wheel.base_diameter, T, mate.tip_curvature, wheel.form_diameter),
        "tip_clearance": f.tip_clearance(a_w, wheel.root_diameter, mate.tip_diameter),
        "specific_sliding": f.specific_sliding(T, start, z, z_m),
        "specific_sliding_tip": f.specific_sliding(T, wheel.tip_curvature, z, z_m),
    }
    if single:
        rho_B = f.lowest_single_contact(T, end, system.base_pitch)
        sizes["specific_sliding_lpstc"] = f.specific_sliding(T, rho_B, z, z_m)
        sizes["lpstc_diameter"] = f.diameter_at(wheel.base_diameter, rho_B)
        sizes["hpstc_diameter"] = f.diameter_at(wheel.base_diameter, f.highest_single_contact(start, system.base_pitch))
    return sizes


def _least_contact(
    system: ToothSystem, a_w: Metre, tolerance: Metre, wheels: tuple[WheelResult, WheelResult]
) -> Number:
    """ε_α with the shortest tips at the widest centre distance."""
    a = widest(a_w, tolerance) if tolerance else a_w
    T = f.line_of_action(a, f.working_pressure_angle(wheels[0].base_diameter, wheels[1].base_diameter, a))
    rho_a = [
        w.tip_curvature if w.tip_diameter_min is None else f.curvature_at(w.tip_diameter_min, w.base_diameter)
        for w in wheels
    ]
    starts = [f.start_of_active_profile(T, rho_a[1 - i], w.form_curvature) for i, w in enumerate(wheels)]
    return f.transverse_contact_ratio(f.path_of_contact(T, starts[0], starts[1]), system.base_pitch)


def _closest(a_w: Metre, tolerance: Metre, wheels: tuple[WheelResult, WheelResult]) -> dict[str, Metre]:
    """Clearance and start of contact where the tips are longest, the roots and fillets highest, and the centres
    closest."""
    a = narrowest(a_w, tolerance) if tolerance else a_w
    if a <= (wheels[0].base_diameter + wheels[1].base_diameter) / 2:
        return {}  # which the backlash says
    T = f.line_of_action(a, f.working_pressure_angle(wheels[0].base_diameter, wheels[1].base_diameter, a))
    clearances, margins = [], []
    for wheel, mate in (wheels, wheels[::-1]):
        d_f = wheel.root_diameter if wheel.root_diameter_max is None else wheel.root_diameter_max
        d_Ff = wheel.form_diameter if wheel.form_diameter_max is None else wheel.form_diameter_max
        d_a = mate.tip_diameter if mate.tip_diameter_max is None else mate.tip_diameter_max
        clearances.append(f.tip_clearance(a, d_f, d_a))
        margins.append(above_fillet(wheel.base_diameter, T, f.curvature_at(d_a, mate.base_diameter), d_Ff))
    return {"tip_clearance_min": min(clearances), "form_margin_min": min(margins)}


def _start(wheel: WheelResult, mate: WheelResult, T: Metre) -> Metre:
    """Where contact begins on a wheel, as the radius of curvature; it must lie outside the base circle."""
    rho_A = f.start_of_active_profile(T, mate.tip_curvature, wheel.form_curvature)
    if rho_A > 0:
        return rho_A
    largest = f.diameter_at(mate.base_diameter, T)
    raise NoSolution(
        Text(
            "wheels {name} and {name2}: the tip of {name2} reaches {tip_curvature} mm past the point where the line of "
            "action touches the base circle of {name}",
            name=wheel.name,
            name2=mate.name,
            tip_curvature=mm(mate.tip_curvature - T, ".4g"),
        ),
        advice=Text(
            "cut the tip of {name} ({tip_diameter} mm) below {largest} mm by gears.wheels.{name}.tip_shortening_mm, "
            "give {name2} more profile shift, or set the wheels further apart",
            name=mate.name,
            tip_diameter=mm(mate.tip_diameter, ".4f"),
            largest=mm(largest, ".4f"),
            name2=wheel.name,
        ),
    )
