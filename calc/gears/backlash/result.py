# SPDX-License-Identifier: Apache-2.0
"""What the play of a train gives beside the backlash over the tolerances, which stands with each mesh."""

from ...sheet.quantity import result, value
from ...sheet.units import Metre, NewtonMetre, Number, Radian


@result
class PlayResult:
    """One mesh.  Backlashes are normal to the flanks; those of the temperatures are the smallest, with the runout where
    it is given."""

    backlash_circumferential: Metre = value(
        "Circumferential backlash at the working circle, mid-tolerance", "µm", "j_wt"
    )
    backlash_transverse: Metre = value("Circumferential backlash at the reference circle, mid-tolerance", "µm", "j_t")
    backlash_radial: Metre = value("Radial backlash, mid-tolerance", "µm", "j_r")
    backlash_recommended: Metre = value("Recommended smallest backlash, normal", "µm", "j_bn,rec")
    centre_tolerance_rss: Metre | None = value(
        "Tolerance of the centre distance (±), root of squares", "µm", "T_a", default=None
    )
    centre_tolerance_worst: Metre | None = value(
        "Tolerance of the centre distance (±), worst case", "µm", "T_wc", default=None
    )
    centre_tolerance_chance: Metre | None = value(
        "Three standard deviations of the centre distance", "µm", "3σ_a", default=None
    )
    backlash_min_worst: Metre | None = value(
        "Smallest backlash, all parts at their worst, normal", "µm", "j_bn,wc", default=None
    )
    backlash_min_runout: Metre | None = value("Smallest backlash with runout, normal", "µm", "j_bn,r", default=None)
    centre_change_cold: Metre = value("Change of the centre distance against the wheels, cold", "µm", "Δa_eff")
    centre_change_running: Metre = value("Change of the centre distance against the wheels, running", "µm", "Δa_eff")
    centre_change_warmer: Metre = value(
        "Change of the centre distance against the wheels, wheels warmer", "µm", "Δa_eff"
    )
    centre_change_warming: Metre = value("Change of the centre distance against the wheels, warming up", "µm", "Δa_eff")
    backlash_cold: Metre = value("Smallest backlash at the lowest temperature, normal", "µm", "j_bn,cold")
    backlash_running: Metre = value("Smallest backlash at running temperature, normal", "µm", "j_bn,run")
    backlash_warmer: Metre = value("Smallest backlash, wheels warmer than the housing, normal", "µm", "j_bn,warmer")
    backlash_warming: Metre = value(
        "Smallest backlash, wheels warmer and the housing still cold, normal", "µm", "j_bn,warming"
    )
    backlash_median: Metre | None = value(
        "Smallest backlash over a turn by chance, median of the trains", "µm", "j_bn,50", default=None
    )
    backlash_99: Metre | None = value("Backlash that 99 % of the trains keep", "µm", "j_bn,99", default=None)
    share_jammed: Number | None = value("Trains in which the mesh can jam", "%", "p_jam", default=None)
    play_angle_nominal: Radian  # free turn of the driven wheel at mid-tolerance, below 0 where it is tight
    play_angle_running: Radian  # at the largest backlash, all parts at running temperature


@result
class TrainPlay:
    """The last wheel, the first driver standing.  The worst case of the tolerances is the train's phase error
    itself."""

    phase_error_nominal: Radian = value("Free turn of the last wheel, mid-tolerance", "°", "Δφ")
    phase_error_rss: Radian = value("Free turn of the last wheel, deviations as root of squares", "°", "Δφ_rss")
    phase_error_median: Radian | None = value(
        "Free turn of the last wheel by chance, median of the trains", "°", "Δφ_50", default=None
    )
    phase_error_95: Radian | None = value("Free turn that 95 % of the trains stay below", "°", "Δφ_95", default=None)
    phase_error_99: Radian | None = value("Free turn that 99 % of the trains stay below", "°", "Δφ_99", default=None)
    phase_error_running: Radian = value("Largest free turn of the last wheel at running temperature", "°", "Δφ_run")
    share_jammed: Number | None = value("Trains in which a mesh can jam", "%", "p_jam", default=None)
    residual_couple_nominal: NewtonMetre | None = value(
        "Couple left by the play at mid-tolerance", "N·m", "C_Δφ", default=None
    )
    residual_couple_rss: NewtonMetre | None = value(
        "Couple left by the play, deviations as root of squares", "N·m", "C_Δφ", default=None
    )
    residual_couple_95: NewtonMetre | None = value(
        "Couple left by the play that 95 % of the trains stay below", "N·m", "C_Δφ", default=None
    )
    residual_couple_running: NewtonMetre | None = value(
        "Couple left by the play at running temperature", "N·m", "C_Δφ", default=None
    )
