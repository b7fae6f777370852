# SPDX-License-Identifier: Apache-2.0
"""What the rating of one mesh gives."""

from ...sheet.quantity import Stated, group, result, value
from ...sheet.units import Newton, NewtonMetre, Number, Pascal
from .influence import Influence
from .screening.result import Screening
from .source_sheet import SheetResult
from .strength import MeshStrength
from .tooth_form import ToothForm


@result
class MeshRating:
    """One mesh.  Torques are those of its driver; `contact_stress` and `root_stress` are nominal, without load factors (K = 1)."""

    mean_torque: NewtonMetre = value("Mean torque at the driver", "N·m", "T_m")
    dynamic_torque: NewtonMetre | None = value("Dynamic torque at the driver by the crank's irregularity", "N·m", "T_dyn", default=None)
    least_torque: NewtonMetre | None = value("Least torque at the driver over the cycle", "N·m", "T_min", default=None)
    application_factor: Number = value("Application factor", "", "K_A")
    tangential_force: Newton = value("Tangential force at the reference circle", "N", "F_t")
    zone_factor: Number = value("Zone factor", "", "Z_H")
    contact_ratio_factor: Number = value("Contact ratio factor", "", "Z_ε")
    helix_factor: Number = value("Helix angle factor, contact", "", "Z_β")
    contact_stress: Pascal = value("Nominal contact stress, K = 1", "MPa", "σ_H0")
    root_helix_factor: Number = value("Helix angle factor, root", "", "Y_β")
    form: dict[str, Stated] = group(spread=True)  # form_factor_WHEEL, stress_correction_WHEEL, notch_parameter_WHEEL
    root_stress: dict[str, Stated] = group(spread=True)  # root_stress_WHEEL
    influence: Influence | None = group(spread=True, default=None)
    contact_load_factor: Number | None = value("Load factors together, contact", "", "K_H", default=None)
    root_load_factor: Number | None = value("Load factors together, root", "", "K_F", default=None)
    strength: MeshStrength | None = group(spread=True, default=None)
    screening: Screening | None = group(spread=True, default=None)
    sheet: SheetResult | None = group(default=None)
    torque: NewtonMetre  # at the driver, that of F_t
    forms: dict[str, ToothForm]
