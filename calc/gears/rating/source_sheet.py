# SPDX-License-Identifier: Apache-2.0
"""The calculation sheet of Finotti 2013 for one pair, exactly as it computes: a result to compare with, beside what is wrong in it.

Wheel 1 is the driver, u = z_2/z_1 also below 1.  It reproduces Fig. 4.20 and 4.22 and Tables 4.5 and 4.6.
"""

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.functions import cos, pi, sin, sqrt
from ...sheet.quantity import result, value
from ...sheet.step import Table
from ...sheet.trace import about
from ...sheet.units import UNITS, Metre, Newton, NewtonMetre, Number, Pascal, Radian
from .. import formulas as f
from . import stress as s
from .tooth_form import ToothForm, lever, section

if TYPE_CHECKING:
    from ..result import MeshResult, ToothSystem, WheelResult

SHEET = "Finotti 2013, sheet of Tables 4.5 and 4.6"
E_OF_SHEET: Pascal = 2.1e12  # 210000 daN/mm², ten times that of steel


@formula("H_0", "Finotti 2013, Fig. 4.20: addendum of the tool in transverse modules (printed as mm)")
def transverse_addendum(h_aP0: Number, beta: Radian) -> Number:
    return h_aP0 * cos(beta)


@formula("σ_H,F", f"{SHEET} (wrong: E, β for β_b, and √cos β of the withdrawn edition)", unit="MPa")
def contact_stress(beta: Radian, alpha_wt: Radian, alpha_t: Radian, Z_eps: Number, F_t: Newton, d_1: Metre, b: Metre, u: Number) -> Pascal:
    return (
        sqrt(0.175 * E_OF_SHEET) * sqrt(2 * cos(beta) * cos(alpha_wt) / (cos(alpha_t) ** 2 * sin(alpha_wt)))
        * Z_eps * sqrt(cos(beta)) * sqrt(F_t / (d_1 * b) * (u + 1) / u)
    )  # fmt: skip


@formula("d_en,F", f"{SHEET} (wrong: the transverse height of the outer single contact, not that of the virtual wheel)", unit="mm")
def load_diameter(m_n: Metre, z_n: Number, d_D: Metre, d: Metre) -> Metre:
    return m_n * z_n + d_D - d


@formula("Y_F,F", f"{SHEET} (wrong: α_t for α_n)", names={"h": "h*_Fe", "s": "s*_Fn"})
def form_factor(h: Number, alpha_en: Radian, gamma_e: Radian, s: Number, alpha_t: Radian) -> Number:
    return 6 * h * cos(alpha_en - gamma_e) / (s**2 * cos(alpha_t))


@formula("η", "Finotti 2013, Fig. 4.22: half angle of the tooth space at the working circle")
def space_angle(z: Number, s_w: Metre, d_w: Metre) -> Radian:
    return pi / z - s_w / d_w


@formula("α_tr", "Finotti 2013, Fig. 4.22 (wrong: the product of two angles in degrees stands for their sum)")
def ball_angle(alpha_wt: Radian, eta: Radian) -> Radian:
    return 180 / pi * alpha_wt * eta


@formula("D_F", "Finotti 2013, Fig. 4.22: ball from the angle above", unit="mm")
def ball(d_w: Metre, beta_b: Radian, eta: Radian, alpha_tr: Radian) -> Metre:
    return d_w * cos(beta_b) * sin(eta) / cos(alpha_tr)


def sheet_contact(system: "ToothSystem", mesh: "MeshResult", driver: "WheelResult", driven: "WheelResult", F_t: Newton) -> Pascal:
    """σ_H of the sheet."""
    Z_eps = s.contact_ratio_factor(mesh.transverse_contact_ratio, mesh.overlap_ratio)
    u = driven.teeth / driver.teeth
    alpha_wt, alpha_t = mesh.working_pressure_angle, system.transverse_pressure_angle
    return contact_stress(system.beta, alpha_wt, alpha_t, Z_eps, F_t, driver.pitch_diameter, mesh.face_width, u)


def sheet_tooth_form(system: "ToothSystem", wheel: "WheelResult", sap_curvature: Metre) -> ToothForm:
    """Y_F and Y_S of the sheet; ρ at the outer single contact is that at the start of contact plus one base pitch."""
    cut = section(system, wheel)
    d_D = f.diameter_at(wheel.base_diameter, sap_curvature + system.base_pitch)
    alpha_en, gamma_e, arm = lever(system, wheel, cut, load_diameter(system.m_n, cut.z_n, d_D, wheel.pitch_diameter))
    Y_F = form_factor(arm, alpha_en, gamma_e, cut.chord, system.transverse_pressure_angle)
    return ToothForm(Y_F, s.stress_correction(s.slenderness(cut.chord, arm), cut.q_s), cut.q_s)


# --- the sheet as a result -------------------------------------------------------------------------------------------------
@result
class SheetResult:
    """What the sheet gives for one mesh."""

    tool_addendum: Number = value("Source's sheet: addendum of the tool, in transverse modules", "", "H_0")
    tangential_force: Newton = value("Source's sheet: tangential force", "N", "F_t")
    contact_stress: Pascal = value("Source's sheet: contact stress", "MPa", "σ_H,F")
    helix_factor: Number = value("Source's sheet: helix angle factor of the root", "", "Y_β")
    form_factor_driver: Number | None = value("Source's sheet: form factor, driver", "", "Y_F,F", default=None)
    form_factor_driven: Number | None = value("Source's sheet: form factor, driven", "", "Y_F,F", default=None)
    notch_parameter_driver: Number | None = value("Source's sheet: notch parameter, driver", "", "q_s", default=None)
    notch_parameter_driven: Number | None = value("Source's sheet: notch parameter, driven", "", "q_s", default=None)
    stress_correction_driver: Number | None = value("Source's sheet: stress correction factor, driver", "", "Y_S", default=None)
    stress_correction_driven: Number | None = value("Source's sheet: stress correction factor, driven", "", "Y_S", default=None)
    root_stress_driver: Pascal | None = value("Source's sheet: root stress, driver", "MPa", "σ_F,F", default=None)
    root_stress_driven: Pascal | None = value("Source's sheet: root stress, driven", "MPa", "σ_F,F", default=None)
    ball_angle_driver: Radian = value("Source's sheet: pressure angle at the ball, driver", "°", "α_tr")
    ball_angle_driven: Radian = value("Source's sheet: pressure angle at the ball, driven", "°", "α_tr")
    ideal_ball_driver: Metre | None = value("Source's sheet: theoretical ball, driver", "mm", "D_F", default=None)
    ideal_ball_driven: Metre | None = value("Source's sheet: theoretical ball, driven", "mm", "D_F", default=None)


def sheet(system: "ToothSystem", mesh: "MeshResult", wheels: "tuple[WheelResult, WheelResult]", T: NewtonMetre) -> SheetResult:
    """The whole sheet of one mesh, T at its driver as the sheet takes it: that of the train's first driver, whatever its speed."""
    driver, driven = wheels
    found: dict[str, Any] = {}
    with about(f"source's sheet, mesh {mesh.driver}–{mesh.driven}"):
        F_t = s.tangential_force(T, driver.pitch_diameter)
        found["tool_addendum"] = transverse_addendum(h_aP0=system.h_aP0, beta=system.beta)
        found["contact_stress"] = sheet_contact(system, mesh, driver, driven, F_t)
        found["helix_factor"] = s.helix_factor_root(mesh.overlap_ratio, system.beta)
        for end, wheel, rho, s_w, d_w in (
            ("driver", driver, mesh.sap_curvature_driver, mesh.working_thickness_driver, mesh.working_diameter_driver),
            ("driven", driven, mesh.sap_curvature_driven, mesh.working_thickness_driven, mesh.working_diameter_driven),
        ):
            try:
                form = sheet_tooth_form(system, wheel, rho)
                found[f"root_stress_{end}"] = s.root_stress(F_t, mesh.face_width, system.m_n, form.Y_F, form.Y_S, found["helix_factor"])
                found |= {f"form_factor_{end}": form.Y_F, f"stress_correction_{end}": form.Y_S, f"notch_parameter_{end}": form.q_s}
            except NoSolution:  # its load circle can miss the tooth where the right one does not: then it has no value
                pass
            eta = space_angle(wheel.teeth, s_w, d_w)
            angle = found[f"ball_angle_{end}"] = ball_angle(mesh.working_pressure_angle, eta)
            if 0 < angle < math.pi / 2:
                found[f"ideal_ball_{end}"] = ball(d_w, system.base_helix_angle, eta, angle)
    return SheetResult(tangential_force=F_t, **found)


ALIKE = 1e-3  # a value of the sheet that comes this near is not called wrong
WRONG = {
    "tangential_force": "first wheel's speed for all",
    "contact_stress": "10 times E; β for β_b; √cos β",
    "form_factor": "no 1/cos² β_b; cos α_t",
    "stress_correction": "by its form factor",
    "root_stress": "by its form factor and force",
    "ideal_ball": "α_wt·η for α_wt + η",
}


def comparison(rows: "Iterator[tuple[str, SheetResult, dict[str, float | None]]]") -> Table:
    """The sheet's values beside the right ones: (driver–driven, what the sheet gives, what is right)."""
    made: list[tuple[str | float | None, ...]] = []
    for mesh, given, right in rows:
        ends = dict(zip(("driver", "driven"), mesh.split("–")))
        for key, ours in right.items():
            theirs = getattr(given, key)
            if theirs is None or ours is None:
                continue
            stem, _, end = key.rpartition("_")
            what = f"{stem.replace('_', ' ')} of {ends[end]}" if end in ends else key.replace("_", " ")
            unit = {"tangential_force": "N", "contact_stress": "MPa", "root_stress": "MPa", "ideal_ball": "mm"}.get(
                stem if end in ends else key, ""
            )
            shown = UNITS[unit].shown
            wrong = WRONG[stem if end in ends else key] if abs(theirs - ours) > ALIKE * abs(ours) else ""
            made.append((mesh, what, unit, shown(theirs), shown(ours), wrong))
    return Table(
        "source_sheet", "The sheet of Finotti 2013 for this load, beside ISO 6336 with K = 1",
        (("Mesh", ""), ("Quantity", ""), ("Unit", ""), ("Sheet", ""), ("Right", ""), ("Wrong in the sheet", "")), tuple(made),
        "To compare with, not to design by; with the source's power and speed it gives the printed values. E is 210000 daN/mm², "
        "ten times that of steel, so σ_H is √10 too high, and has β for β_b in Z_H and √cos β, withdrawn, for Z_β. The height of the "
        "outer single contact is carried to the virtual wheel without 1/cos² β_b, and Y_F has cos α_t for cos α_n. The ball has the "
        "product of two angles in degrees for their sum.",
    )  # fmt: skip
