# SPDX-License-Identifier: Apache-2.0
"""What solving the gear train gives: the tooth system, its wheels, its meshes."""

from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING

from ..sheet.quantity import Stated, group, result, value
from ..sheet.record import record
from ..sheet.shown import Shown
from ..sheet.units import Kilogram, Metre, Newton, NewtonMetre, Number, Radian, RevPerSecond
from .accuracy import ToothTolerances
from .backlash.formulas import PlayResult, TrainPlay
from .drive.result import DriveResult, MeshOverSpeed, WheelStruck
from .layout.result import ForcesResult, LayoutResult
from .measures.result import MeasuresResult, Seat
from .rating.result import MeshRating
from .stages import StageResult
from .tree import Tree

if TYPE_CHECKING:
    from ..countershaft.sums import ToothOff


@result
class ToothSystem(Shown):
    """What all wheels of a train have in common; tool addendum and tip radius in modules."""

    transverse_module: Metre = value("Transverse module", "mm", "m_t", short=True)
    transverse_pressure_angle: Radian = value("Transverse pressure angle", "°", "α_t", short=True)
    base_helix_angle: Radian = value("Helix angle at the base circle", "°", "β_b", short=True)
    base_pitch: Metre = value("Transverse base pitch", "mm", "p_bt")
    h_fP: Number = value("Dedendum of the finished teeth, in modules", "", "h_fP")
    s_pr: Metre = value("Undercut left by the protuberance", "mm", "s_pr")
    m_n: Metre
    alpha_n: Radian
    beta: Radian
    h_aP0: Number  # of the tool
    rho_aP0: Number
    stock: Metre


@record
class End:
    """The tooth at one end of its allowance: generating shift, thickness at the reference circle, seat of the measuring
    ball."""

    x_E: Number
    s_t: Metre
    seat: Seat | None


@result
class WheelResult(Shown):
    """One wheel.  Values ending in _min and _max belong to the two ends of the allowance of the span."""

    profile_shift: Number = value("Profile shift coefficient", "", "x")
    undercut_limit: Number = value("Smallest shift without undercut", "", "x_min")
    reference_diameter: Metre = value("Reference diameter", "mm", "d", former="pitch_diameter")
    base_diameter: Metre = value("Base diameter", "mm", "d_b")
    tip_diameter: Metre = value("Tip diameter", "mm", "d_a")
    tip_diameter_min: Metre | None = value("Tip diameter, smallest by its tolerance", "mm", "d_a", default=None)
    tip_diameter_max: Metre | None = value("Tip diameter, largest by its tolerance", "mm", "d_a", default=None)
    pointed_diameter: Metre = value("Circle on which the tooth would be pointed", "mm", "d_p")
    root_diameter: Metre = value("Root diameter", "mm", "d_f")
    root_diameter_min: Metre | None = value("Root diameter, thinnest tooth", "mm", "d_f", default=None)
    root_diameter_max: Metre | None = value("Root diameter, thickest tooth", "mm", "d_f", default=None)
    form_diameter: Metre = value("Form diameter: the fillet begins", "mm", "d_Ff")
    form_diameter_min: Metre | None = value("Form diameter, thinnest tooth", "mm", "d_Ff", default=None)
    form_diameter_max: Metre | None = value("Form diameter, thickest tooth", "mm", "d_Ff", default=None)
    tooth_depth: Metre = value("Tooth depth", "mm", "h")
    reference_thickness: Metre = value("Tooth thickness at the reference circle, transverse", "mm", "s_t")
    tip_thickness: Metre = value("Tooth thickness at the tip, transverse", "mm", "s_at")
    form_thickness: Metre = value("Tooth thickness at the form circle, transverse", "mm", "s_Ff")
    tip_thickness_normal: Metre = value("Tooth thickness at the tip, normal", "mm", "s_an", short=True)
    tip_thickness_normal_min: Metre | None = value(
        "Tooth thickness at the tip, normal, thinnest tooth", "mm", "s_an", default=None
    )
    speed: RevPerSecond = value("Speed (+: in the sense of the first driver)", "rpm", "n", short=True)
    span_teeth: Number = value("Teeth spanned", "", "K")
    span: dict[str, Stated] = group(spread=True)
    ideal_ball: Metre = value("Ball that touches in the middle of the flank", "mm", "D_y")
    preferred_ball: Metre | None = value(
        "Preferred ball or pin nearest to the middle of the flank", "mm", "D_M", default=None
    )
    ball_diameter: Metre = value("Measuring ball", "mm", "D_M")
    over_balls: Metre | None = value("Size over balls", "mm", "M", default=None)
    over_balls_min: Metre | None = value("Size over balls, thinnest tooth", "mm", "M", default=None)
    over_balls_max: Metre | None = value("Size over balls, thickest tooth", "mm", "M", default=None)
    chordal_thickness: Metre = value("Chordal thickness, normal", "mm", "s_c")
    chordal_height: Metre = value("Height above the chord", "mm", "h_c")
    measures: MeasuresResult | None = group(spread=True, default=None)
    mass: Kilogram | None = value("Mass", "kg", "m_W", default=None)
    strikes: WheelStruck | None = group(spread=True, default=None)
    name: str
    teeth: int
    face_width: Metre
    material: str
    allowance: tuple[Metre, Metre] | None  # (upper, lower) change of the span
    span_length: Metre  # W_K
    virtual_teeth: Number  # z_v
    seat: Seat | None  # of the measuring ball; None: it does not fit
    ball_given: bool  # whether the design gives the ball; else it is chosen
    ends: dict[str, End] | None = None  # "max", "min": at the ends of the allowance
    tip_curvature: Metre  # ρ_a
    form_curvature: Metre  # ρ_F
    tolerances: ToothTolerances  # of the accuracy grade

    @property
    def pitch_diameter(self) -> Metre:
        """The old name of the reference diameter."""
        return self.reference_diameter


@result
class MeshResult(Shown):
    """One mesh."""

    centre_distance: Metre = value("Centre distance", "mm", "a_w", short=True)
    centre_modification: Number = value("Centre distance modification, in modules", "", "y")
    shift_sum: Number = value("Sum of the profile shifts", "", "Σx")
    working_module: Metre = value("Transverse module at the working circles", "mm", "m_wt")
    working_pressure_angle: Radian = value("Working transverse pressure angle", "°", "α_wt", short=True)
    working_helix_angle: Radian = value("Helix angle at the working circle", "°", "β_w")
    working_diameter_driver: Metre = value("Working diameter, driver", "mm", "d_w1")
    working_diameter_driven: Metre = value("Working diameter, driven", "mm", "d_w2")
    working_thickness_driver: Metre = value("Tooth thickness at the working circle, driver", "mm", "s_wt1")
    working_thickness_driven: Metre = value("Tooth thickness at the working circle, driven", "mm", "s_wt2")
    standard_tip_shortening: Metre = value("Standard tip shortening (not applied)", "mm", "k*·m_n")
    transverse_contact_ratio: Number = value(
        "Transverse contact ratio", "", "ε_α", short=True, page_one=5, worst="least"
    )
    overlap_ratio: Number = value("Overlap ratio", "", "ε_β", short=True)
    total_contact_ratio: Number = value("Total contact ratio", "", "ε_γ")
    transverse_contact_ratio_min: Number | None = value(
        "Transverse contact ratio, shortest tips and widest centres", "", "ε_α,min", default=None
    )
    sap_diameter_driver: Metre = value("Start of active profile, driver", "mm", "d_Nf1")
    sap_diameter_driven: Metre = value("Start of active profile, driven", "mm", "d_Nf2")
    form_margin_driver: Metre = value("Contact begins above the fillet, driver", "mm", "c_F1")
    form_margin_driven: Metre = value("Contact begins above the fillet, driven", "mm", "c_F2")
    form_margin_min: Metre | None = value(
        "Contact begins above the fillet, longest tips and closest centres", "mm", "c_F,min", default=None
    )
    lpstc_diameter_driver: Metre | None = value("Lowest single contact, driver", "mm", "d_B1", default=None)
    lpstc_diameter_driven: Metre | None = value("Lowest single contact, driven", "mm", "d_B2", default=None)
    hpstc_diameter_driver: Metre | None = value("Highest single contact, driver", "mm", "d_D1", default=None)
    hpstc_diameter_driven: Metre | None = value("Highest single contact, driven", "mm", "d_D2", default=None)
    tip_clearance_driver: Metre = value("Tip clearance at the driver's root", "mm", "c_1")
    tip_clearance_driven: Metre = value("Tip clearance at the driven wheel's root", "mm", "c_2")
    tip_clearance_min: Metre | None = value(
        "Tip clearance, longest tips and closest centres", "mm", "c_min", default=None
    )
    specific_sliding_driver: Number = value("Specific sliding at the start of contact, driver", "", "ζ_A1")
    specific_sliding_driven: Number = value("Specific sliding at the start of contact, driven", "", "ζ_A2")
    specific_sliding_tip_driver: Number = value("Specific sliding at the end of contact, driver", "", "ζ_E1")
    specific_sliding_tip_driven: Number = value("Specific sliding at the end of contact, driven", "", "ζ_E2")
    specific_sliding_lpstc_driver: Number | None = value(
        "Specific sliding at the lowest single contact, driver", "", "ζ_B1", default=None
    )
    specific_sliding_lpstc_driven: Number | None = value(
        "Specific sliding at the lowest single contact, driven", "", "ζ_B2", default=None
    )
    backlash_min: Metre = value("Smallest backlash, normal", "µm", "j_bn,min", short=True)
    backlash_nominal: Metre = value("Backlash at mid-tolerance, normal", "µm", "j_bn")
    backlash_max: Metre = value("Largest backlash, normal", "µm", "j_bn,max", short=True)
    penetration: Metre | None = value(
        "Depth of the outlines inside each other, without backlash", "µm", "δ_p", default=None
    )
    rating: MeshRating | None = group(spread=True, default=None)
    over_speed: MeshOverSpeed | None = group(spread=True, default=None)
    driver: str
    driven: str
    face_width: Metre  # common to both
    line_of_action: Metre  # T_1T_2
    sap_curvature_driver: Metre  # ρ_A of each
    sap_curvature_driven: Metre
    centre_tolerance: Metre  # ±
    play_angle: Radian  # free turn of the driven wheel at the largest backlash

    @cached_property
    def title(self) -> str:
        """What it is called in sentences."""
        return f"{self.driver}–{self.driven}"


def working_circles(meshes: Mapping[str, MeshResult], wheel: str) -> list[tuple[str, Metre, MeshResult]]:
    """The mates of a wheel, each with the wheel's working diameter towards it and their mesh."""
    drives = [(mesh.driven, mesh.working_diameter_driver, mesh) for mesh in meshes.values() if mesh.driver == wheel]
    return drives + [
        (mesh.driver, mesh.working_diameter_driven, mesh) for mesh in meshes.values() if mesh.driven == wheel
    ]


@result
class ShaftTurn(Shown):
    """How the wheel of one shaft turns with the first driver, and what its free turn leaves of what the shaft
    balances."""

    speed_ratio: Number = value("Speed of the last wheel over that of the first (−: against it)", "", "i", short=True)
    phase_error: Radian = value(
        "Free turn of the last wheel by backlash", "°", "Δφ", short=True, page_one=6, headline=1
    )
    residual_couple: NewtonMetre | None = value(
        "Couple left by the phase error", "N·m", "C_Δφ", default=None, short=True, page_one=7, headline=2
    )
    residual_force: Newton | None = value("Force left by the phase error", "N", "F_Δφ", default=None, page_one=8)
    tooth_late: "ToothOff | None" = group(default=None, words="one tooth off")
    pair_late: "ToothOff | None" = group(default=None, words="with its mirror image one tooth off")
    wheel: str  # or sprocket


@result
class TrainResult(Shown):
    """The whole train.  What is None was not asked, or waits for another step."""

    system: ToothSystem = group(spread=True)
    wheels: dict[str, WheelResult] = group(spread=True)
    meshes: dict[str, MeshResult] = group(spread=True)
    stages: dict[str, StageResult] = group(spread=True)
    shafts: dict[str, ShaftTurn] = group(spread=True, named="several")
    all_late: "ToothOff | None" = group(default=None, words="all shafts one tooth off")
    play: dict[str, PlayResult] | None = group(spread=True, default=None)  # by mesh
    train_play: dict[str, TrainPlay] | None = group(spread=True, default=None, named="several")  # by shaft
    layout: LayoutResult | None = group(spread=True, default=None)
    forces: ForcesResult | None = group(spread=True, default=None)
    drive: DriveResult | None = group(default=None, words="drive")
    tree: Tree
    speeds: Mapping[str, RevPerSecond]  # of wheels and sprockets, + in the sense of the first driver; empty at rest

    def mates(self, wheel: str) -> list[tuple[str, Metre, MeshResult]]:
        """The mates of a wheel, each with the wheel's working diameter towards it and their mesh."""
        return working_circles(self.meshes, wheel)
