# SPDX-License-Identifier: Apache-2.0
"""The calculation sheet of Finotti 2013 for one pair, exactly as it computes: a result to compare with, beside what is
wrong in it.

Wheel 1 is the driver, u = z_2/z_1 also below 1.  It reproduces Fig. 4.20 and 4.22 and Tables 4.5 and 4.6.
"""

import math
from collections.abc import Iterator, Mapping

from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.functions import cos, pi, sin, sqrt
from ...sheet.quantity import dotted
from ...sheet.step import Erratum, Table
from ...sheet.text import EMPTY, Amount, Text
from ...sheet.units import UNITS, Metre, Newton, NewtonMetre, Number, Pascal, Radian
from ...sheet.value import about, based_on, untraced
from .. import formulas as f
from ..measures.solve import ball_at
from ..result import MeshResult, ToothSystem, TrainResult, WheelResult
from . import stress as s
from .mesh_strength import lever, section
from .result import MeshRating, SheetResult, ToothForm

SHEET = Text("Finotti 2013, sheet of Tables 4.5 and 4.6")
E_OF_SHEET: Pascal = 2.1e12  # 210000 daN/mm², ten times that of steel


@formula("H_0", "Finotti 2013, Fig. 4.20: addendum of the tool in transverse modules (printed as mm)")
def transverse_addendum(h_aP0: Number, beta: Radian) -> Number:
    return h_aP0 * cos(beta)


@formula(
    "σ_H,F",
    Text("{sheet} (wrong: E, β for β_b, and √cos β of the withdrawn edition)", sheet=SHEET),
    unit="MPa",
    meanings={"u": "Teeth of the wheel over those of the pinion"},
)
def contact_stress(
    beta: Radian, alpha_wt: Radian, alpha_t: Radian, Z_eps: Number, F_t: Newton, d_1: Metre, b: Metre, u: Number
) -> Pascal:
    return (
        sqrt(0.175 * E_OF_SHEET)
        * sqrt(2 * cos(beta) * cos(alpha_wt) / (cos(alpha_t) ** 2 * sin(alpha_wt)))
        * Z_eps
        * sqrt(cos(beta))
        * sqrt(F_t / (d_1 * b) * (u + 1) / u)
    )


@formula(
    "d_en,F",
    Text(
        "{sheet} (wrong: the transverse height of the outer single contact, not that of the virtual wheel)", sheet=SHEET
    ),
    unit="mm",
)
def load_diameter(m_n: Metre, z_n: Number, d_D: Metre, d: Metre) -> Metre:
    return m_n * z_n + d_D - d


@formula("Y_F,F", Text("{sheet} (wrong: α_t for α_n)", sheet=SHEET), names={"h": "h*_Fe", "s": "s*_Fn"})
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


def sheet_tooth_form(system: ToothSystem, wheel: WheelResult, sap_curvature: Metre) -> ToothForm:
    """Y_F and Y_S of the sheet; ρ at the outer single contact is that at the start of contact plus one base pitch."""
    cut = section(system, wheel)
    d_D = f.diameter_at(
        wheel.base_diameter, based_on(sap_curvature + system.base_pitch, sap_curvature, system.base_pitch)
    )
    alpha_en, gamma_e, arm = lever(system, wheel, cut, load_diameter(system.m_n, cut.z_n, d_D, wheel.pitch_diameter))
    Y_F = form_factor(arm, alpha_en, gamma_e, cut.chord, system.transverse_pressure_angle)
    return ToothForm(Y_F, s.stress_correction(s.slenderness(cut.chord, arm), cut.q_s), cut.q_s)


def sheet(
    system: ToothSystem, mesh: MeshResult, wheels: tuple[WheelResult, WheelResult], T: NewtonMetre
) -> SheetResult:
    """The whole sheet of one mesh, T at its driver as the sheet takes it: that of the train's first driver, whatever
    its speed."""
    driver, driven = wheels
    ends: dict[str, float] = {}  # fields of SheetResult that driver and driven have each
    with about(Text("source's sheet, mesh {pair}", pair=mesh.title)):
        F_t = s.tangential_force(T, driver.pitch_diameter)
        addendum = transverse_addendum(h_aP0=system.h_aP0, beta=system.beta)
        Z_eps = s.contact_ratio_factor(mesh.transverse_contact_ratio, mesh.overlap_ratio)
        u = based_on(driven.teeth / driver.teeth, driven.teeth, driver.teeth)
        alpha_wt, alpha_t, b = mesh.working_pressure_angle, system.transverse_pressure_angle, mesh.face_width
        sigma_H = contact_stress(system.beta, alpha_wt, alpha_t, Z_eps, F_t, driver.pitch_diameter, b, u)
        Y_beta = s.helix_factor_root(mesh.overlap_ratio, system.beta)
        for end, wheel, rho, s_w, d_w in (
            ("driver", driver, mesh.sap_curvature_driver, mesh.working_thickness_driver, mesh.working_diameter_driver),
            ("driven", driven, mesh.sap_curvature_driven, mesh.working_thickness_driven, mesh.working_diameter_driven),
        ):
            try:
                form = sheet_tooth_form(system, wheel, rho)
                ends[f"root_stress_{end}"] = s.root_stress(F_t, b, system.m_n, form.Y_F, form.Y_S, Y_beta)
                ends |= {
                    f"form_factor_{end}": form.Y_F,
                    f"stress_correction_{end}": form.Y_S,
                    f"notch_parameter_{end}": form.q_s,
                }
            except NoSolution:  # its load circle can miss the tooth where the right one does not: then it has no value
                pass
            eta = space_angle(wheel.teeth, s_w, d_w)
            angle = ends[f"ball_angle_{end}"] = ball_angle(alpha_wt, eta)
            if 0 < angle < math.pi / 2:
                ends[f"ideal_ball_{end}"] = ball(d_w, system.base_helix_angle, eta, angle)
    return SheetResult(
        tool_addendum=addendum, tangential_force=F_t, contact_stress=sigma_H, helix_factor=Y_beta, **ends
    )


# --- beside what is right

ALIKE = 1e-3  # a value of the sheet that comes this near is not called wrong
WRONG = {  # quantity: (its name, its unit, what is wrong in the sheet)
    "tangential_force": (Text("tangential force"), "N", Text("first wheel's speed for all")),
    "contact_stress": (Text("contact stress"), "MPa", Text("10 times E; β for β_b; √cos β")),
    "form_factor": (Text("form factor"), "", Text("no 1/cos² β_b; cos α_t")),
    "stress_correction": (Text("stress correction"), "", Text("by its form factor")),
    "root_stress": (Text("root stress"), "MPa", Text("by its form factor and force")),
    "ideal_ball": (Text("ideal ball"), "mm", Text("α_wt·η for α_wt + η")),
}
CONTACT_OF_SHEET = Text(
    "Its modulus of 210000 daN/mm² is ten times that of steel, so the stress is √10 too high; it also takes β for β_b "
    "in the zone factor, and √cos β of the withdrawn edition. Its root stresses stand in the table of the sheet."
)


def comparison(train: TrainResult, rated: Mapping[str, MeshRating]) -> Table:
    """The sheet's values beside the right ones."""
    rows: list[tuple[str | float | None, ...]] = []
    for key, rating in rated.items():
        for quantity, wheel, ours in _right(train, train.meshes[key], rating):
            end = {train.meshes[key].driver: "_driver", train.meshes[key].driven: "_driven"}.get(wheel, "")
            theirs = getattr(rating.sheet, f"{quantity}{end}")
            if theirs is None or ours is None:
                continue
            name, unit, wrong = WRONG[quantity]
            what = Text("{quantity} of {wheel}", quantity=name, wheel=wheel) if wheel else name
            shown = UNITS[unit].shown
            differs = abs(theirs - ours) > ALIKE * abs(ours)
            rows.append((key.replace("_", "–"), what, unit, shown(theirs), shown(ours), wrong if differs else ""))
    return Table(
        "source_sheet",
        Text("The sheet of Finotti 2013 for this load, beside ISO 6336 with K = 1"),
        (
            (Text("Mesh"), ""),
            (Text("Quantity"), ""),
            (Text("Unit"), ""),
            (Text("Sheet"), ""),
            (Text("Right"), ""),
            (Text("Wrong in the sheet"), ""),
        ),
        tuple(rows),
        Text(
            "To compare with, not to design by; with the source's power and speed it gives the printed values. E is "
            "210000 daN/mm², ten times that of steel, so σ_H is √10 too high, and has β for β_b in Z_H and √cos β, "
            "withdrawn, for Z_β. The height of the outer single contact is carried to the virtual wheel without 1/cos² "
            "β_b, and Y_F has cos α_t for cos α_n. The ball has the product of two angles in degrees for their sum."
        ),
    )


def _share(rating: MeshRating) -> Number:
    """Of the rated torque, the mean one, which the sheet knows."""
    return abs(rating.mean_torque / rating.torque) if rating.torque else 1.0


def _right(train: TrainResult, mesh: MeshResult, rating: MeshRating) -> Iterator[tuple[str, str, float | None]]:
    """(quantity of the sheet, its wheel, what is right in its place at the mean torque)."""
    share = _share(rating)
    yield "tangential_force", "", rating.tangential_force * share
    yield "contact_stress", "", rating.contact_stress * math.sqrt(share)
    for name in (mesh.driver, mesh.driven):
        wheel, system = train.wheels[name], train.system
        with untraced():
            ball_at_working_circle = ball_at(system, wheel, mesh.working_pressure_angle)
        yield "form_factor", name, rating.forms[name].Y_F
        yield "stress_correction", name, rating.forms[name].Y_S
        yield "root_stress", name, rating.root_stress[f"root_stress_{name}"].number * share
        yield "ideal_ball", name, ball_at_working_circle


def errata(train: TrainResult, rated: Mapping[str, MeshRating]) -> tuple[Erratum, ...]:
    """What the sheet of the source gives for every pair: the torque of the first wheel at each driver, and its own
    formulas."""
    errata = []
    for key, mesh in train.meshes.items():
        first = next(iter(train.meshes.values())).driver
        driver, rating = train.wheels[mesh.driver], rated[key]
        if rating.sheet is None:
            continue
        speed = EMPTY
        if driver.teeth != train.wheels[first].teeth:
            force = rating.tangential_force * _share(rating)
            speed = Text(
                " With the first wheel's speed entered for {name}, its tangential force is {tangential_force} N "
                "instead of {force} N.",
                name=driver.name,
                tangential_force=Amount(rating.sheet.tangential_force, form=".4g"),
                force=Amount(force, form=".4g"),
            )
        id, shown = dotted("gears", key, MeshRating.contact_stress), UNITS["MPa"].shown(rating.sheet.contact_stress)
        label = Text("{label} by the sheet of Finotti 2013", label=Text("Contact stress"))
        source = Text("method of Finotti 2013, Tables 4.5 and 4.6")
        at = "Finotti 2013", "2108, 2132"
        errata.append(Erratum(id, label, shown, "MPa", source, CONTACT_OF_SHEET + speed, at))
    return tuple(errata)
