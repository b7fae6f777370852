# SPDX-License-Identifier: Apache-2.0
"""What the rating of a train gives, mesh by mesh: nominal stresses, load factors, strength, the sheet of the source."""

from typing import Any

from ...sheet.quantity import Stated, group, result, value
from ...sheet.record import record
from ...sheet.shown import Shown
from ...sheet.text import Text
from ...sheet.units import (
    KilogramPerMetre,
    Metre,
    MetrePerSecond,
    Newton,
    NewtonMetre,
    NewtonPerMetre,
    Number,
    Pascal,
    Radian,
    RevPerSecond,
)
from .classes import StrengthClass
from .screening.load import Screening
from .strength import ContactStrength, RootStrength


@record
class ToothForm:
    """Form and stress correction factor and notch parameter of one wheel in one mesh."""

    Y_F: Number
    Y_S: Number
    q_s: Number


@record
class Deviations:
    """Of both wheels of a mesh the larger; y_p, y_f: what running in takes of f_pb and f_fα."""

    f_pb: Metre
    f_falpha: Metre
    f_ma: Metre
    f_Hbeta: Metre
    y_p: Metre
    y_f: Metre


@result
class Influence(Shown):
    """How much more than the nominal load the teeth of a mesh carry, and what that follows from."""

    line_load: NewtonPerMetre = value("Load per face width, F_t·K_A/b", "N/mm", "w")
    dynamic_factor: Number = value("Dynamic factor", "", "K_V", short=True)
    face_load_factor_flank: Number = value("Face load factor, flank", "", "K_Hβ", short=True)
    face_load_factor_root: Number = value("Face load factor, root", "", "K_Fβ")
    face_load_factor_at_100: Number | None = value(
        "Face load factor, flank, if the load were 100 N/mm", "", "K_Hβ,100", default=None
    )
    transverse_load_factor_flank: Number = value("Transverse load factor, flank", "", "K_Hα", short=True)
    transverse_load_factor_root: Number = value("Transverse load factor, root", "", "K_Fα")
    transverse_load_factor_flank_max: Number = value(
        "Transverse load factor, flank: its limit, one pair carries all", "", "K_Hα,max"
    )
    transverse_load_factor_root_max: Number = value(
        "Transverse load factor, root: its limit, one pair carries all", "", "K_Fα,max"
    )
    contact_width_share: Number = value("Share of the face width that touches", "%", "b_cal/b")
    resonance_ratio: Number = value("Speed over that of the main resonance", "", "N")
    resonance_speed: RevPerSecond = value("Main resonance, speed of the smaller wheel", "rpm", "n_E1")
    single_stiffness: Pascal = value("Single stiffness, GPa = N/(mm·µm)", "GPa", "c'")
    mesh_stiffness: Pascal = value("Mesh stiffness, GPa = N/(mm·µm)", "GPa", "c_γα")
    mesh_stiffness_face: Pascal = value("Mesh stiffness along the face width, GPa = N/(mm·µm)", "GPa", "c_γβ")
    pitch_line_velocity: MetrePerSecond = value("Speed at the reference circle", "m/s", "v")
    base_pitch_deviation: Metre = value("Deviation of the base pitch, larger of both", "µm", "f_pb")
    profile_form_deviation: Metre = value("Deviation of the profile form, larger of both", "µm", "f_fα")
    manufacturing_misalignment: Metre = value("Mesh misalignment by manufacture", "µm", "f_ma")
    effective_misalignment: Metre = value("Misalignment after running in", "µm", "F_βy")
    reduced_mass: KilogramPerMetre  # m_red
    deviations: Deviations
    full_stiffness: Pascal  # c' from 100 N/mm on
    speed_range: Text
    lower_resonance: Number  # N_S, where the main resonance begins
    out_of_range: tuple[Text, ...]  # sizes without a tolerance in ISO 1328-1
    misalignment_given: bool


@record
class FlankFilm:
    """The three factors of the film, of a mesh."""

    Z_L: Number
    Z_v: Number
    Z_R: Number
    rho_red: Metre


@record
class WheelStrength:
    """One wheel as its strength in one mesh needs it.

    `sigma_F0`: nominal root stress, K = 1.  `cycles` None: no life is given.  `loading`: pulsating or reversed.
    `tooth_depth` and `rim` (None: solid body) give the rim factor.
    """

    name: str
    strength: StrengthClass
    teeth: int
    tip_diameter: Metre
    base_diameter: Metre
    tooth_depth: Metre
    rim: Metre | None
    q_s: Number
    sigma_F0: Pascal
    loading: str
    cycles: Number | None


@result
class MeshStrength(Shown):
    """The strength of one mesh; a safety of None: no load."""

    safety_contact: Number | None = value(
        "Safety against pitting, on stress", "", "S_H", default=None, short=True, page_one=1, worst="least"
    )
    safety_contact_load: Number | None = value("Safety against pitting, on load", "", "S_H²", default=None)
    lubricant_factor: Number = value("Lubricant factor", "", "Z_L")
    velocity_factor: Number = value("Velocity factor", "", "Z_v")
    roughness_factor: Number = value("Roughness factor", "", "Z_R")
    wheels: dict[str, Stated] = group(spread=True)  # NAME_WHEEL
    sides: tuple[WheelStrength, WheelStrength]
    contact: dict[str, ContactStrength]  # by wheel
    bending: dict[str, RootStrength]
    film: FlankFilm

    @property
    def pair(self) -> str:
        return f"{self.sides[0].name}–{self.sides[1].name}"


@result
class SheetResult(Shown):
    """What the calculation sheet of Finotti 2013 gives for one mesh."""

    tool_addendum: Number = value("Source's sheet: addendum of the tool, in transverse modules", "", "H_0")
    tangential_force: Newton = value("Source's sheet: tangential force", "N", "F_t")
    contact_stress: Pascal = value("Source's sheet: contact stress", "MPa", "σ_H,F")
    helix_factor: Number = value("Source's sheet: helix angle factor of the root", "", "Y_β")
    form_factor_driver: Number | None = value("Source's sheet: form factor, driver", "", "Y_F,F", default=None)
    form_factor_driven: Number | None = value("Source's sheet: form factor, driven", "", "Y_F,F", default=None)
    notch_parameter_driver: Number | None = value("Source's sheet: notch parameter, driver", "", "q_s", default=None)
    notch_parameter_driven: Number | None = value("Source's sheet: notch parameter, driven", "", "q_s", default=None)
    stress_correction_driver: Number | None = value(
        "Source's sheet: stress correction factor, driver", "", "Y_S", default=None
    )
    stress_correction_driven: Number | None = value(
        "Source's sheet: stress correction factor, driven", "", "Y_S", default=None
    )
    root_stress_driver: Pascal | None = value("Source's sheet: root stress, driver", "MPa", "σ_F,F", default=None)
    root_stress_driven: Pascal | None = value("Source's sheet: root stress, driven", "MPa", "σ_F,F", default=None)
    ball_angle_driver: Radian = value("Source's sheet: pressure angle at the ball, driver", "°", "α_tr")
    ball_angle_driven: Radian = value("Source's sheet: pressure angle at the ball, driven", "°", "α_tr")
    ideal_ball_driver: Metre | None = value("Source's sheet: theoretical ball, driver", "mm", "D_F", default=None)
    ideal_ball_driven: Metre | None = value("Source's sheet: theoretical ball, driven", "mm", "D_F", default=None)


@result
class MeshRating(Shown):
    """One mesh.  Torques are those of its driver; `contact_stress` and `root_stress` are nominal, without load factors
    (K = 1)."""

    mean_torque: NewtonMetre = value("Mean torque at the driver", "N·m", "T_m")
    dynamic_torque: NewtonMetre | None = value(
        "Dynamic torque at the driver by the crank's irregularity", "N·m", "T_dyn", default=None
    )
    least_torque: NewtonMetre | None = value("Least torque at the driver over the cycle", "N·m", "T_min", default=None)
    application_factor: Number = value("Application factor", "", "K_A")
    tangential_force: Newton = value("Tangential force at the reference circle", "N", "F_t", short=True)
    zone_factor: Number = value("Zone factor", "", "Z_H")
    contact_ratio_factor: Number = value("Contact ratio factor", "", "Z_ε")
    helix_factor: Number = value("Helix angle factor, contact", "", "Z_β")
    contact_stress: Pascal = value("Nominal contact stress, K = 1", "MPa", "σ_H0", short=True)
    root_helix_factor: Number = value("Helix angle factor, root", "", "Y_β")
    form: dict[str, Stated] = group(spread=True)  # form_factor_WHEEL, stress_correction_WHEEL, notch_parameter_WHEEL
    root_stress: dict[str, Stated] = group(spread=True)  # root_stress_WHEEL
    influence: Influence | None = group(spread=True, default=None)
    contact_load_factor: Number | None = value("Load factors together, contact", "", "K_H", default=None)
    root_load_factor: Number | None = value("Load factors together, root", "", "K_F", default=None)
    strength: MeshStrength | None = group(spread=True, default=None)
    screening: Screening | None = group(spread=True, default=None)
    sheet: SheetResult | None = group(default=None, words="sheet")
    torque: NewtonMetre  # at the driver, that of F_t
    forms: dict[str, ToothForm]


@result
class RatingResult(Shown):
    """The rating of every mesh."""

    meshes: dict[str, MeshRating] = group(spread=True)
    least_strand_forces: dict[str, Newton]  # by chain or belt; those of which it is known
    context: Any  # the RatingContext of load.py, which knows the train that this is a part of
