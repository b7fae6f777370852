# SPDX-License-Identifier: Apache-2.0
"""Backlash of a pair at a centre distance and at a temperature, what parts add up to, and the free turn that it leaves
a train.

Backlash is exact at the very centre distance.  For small changes it is −(E_W1 + E_W2) + 2·Δa·sin α_wt·cos β_b: an
allowance of the span acts on it micrometre for micrometre."""

from ...library.table_file import house_table
from ...sheet.formula import formula
from ...sheet.functions import cos, inv, joined, pi, rss, sin, smallest, tan, total
from ...sheet.quantity import result, value
from ...sheet.shown import Shown
from ...sheet.text import Text
from ...sheet.units import (
    Celsius,
    Kelvin,
    Metre,
    Metres,
    Newton,
    NewtonMetre,
    Number,
    Numbers,
    PerKelvin,
    Radian,
    Radians,
)
from ..formulas import ISO

DUST: Metre = 1e-12  # a backlash below this is none
GUIDE = Text("ISO/TR 10064-2")
LEAST_BACKLASH: Metre = 0.06e-3  # the constant term of the guide value
REFERENCE: Celsius = 20.0  # of all measures, ISO 1


# --- tolerances, thicknesses and the backlash of a pair


@formula(
    "T_a",
    "mathematics: root of the sum of squares of the parts' fields, half of it to each side (Finotti 2013, Table 4.7)",
    unit="mm",
    names={"T": "T_i"},
    meanings={"T": "Tolerance fields of the parts"},
)
def tolerance_of_contributors(T: Metres) -> Metre:
    return rss(T) / 2


@formula(
    "a_max",
    "geometry: centre distance at the upper end of its tolerance",
    unit="mm",
    meanings={"T_a": "Tolerance of the centre distance (±)"},
)
def widest(a_w: Metre, T_a: Metre) -> Metre:
    return a_w + T_a


@formula(
    "a_min",
    "geometry: centre distance at the lower end of its tolerance",
    unit="mm",
    meanings={"T_a": "Tolerance of the centre distance (±)"},
)
def narrowest(a_w: Metre, T_a: Metre) -> Metre:
    return a_w - T_a


@formula("E_W", "mathematics: middle of the allowance", unit="µm")
def middle_allowance(E_Ws: Metre, E_Wi: Metre) -> Metre:
    return (E_Ws + E_Wi) / 2


@formula("j_wt", Text("{iso}: circumferential backlash at the working circle", iso=ISO), unit="µm")
def circumferential_backlash(d_w1: Metre, z_1: Number, s_w1: Metre, s_w2: Metre) -> Metre:
    return joined(pi * d_w1 / z_1 - s_w1, -s_w2)


@formula("j_bn", Text("{iso}: normal backlash", iso=ISO), unit="µm")
def normal_backlash(j_wt: Metre, alpha_wt: Radian, beta_b: Radian) -> Metre:
    """>>> normal_backlash(j_wt=4.133e-05, alpha_wt=0.376, beta_b=0.3584)
    3.600004...e-05
    """
    return j_wt * cos(alpha_wt) * cos(beta_b)


@formula(
    "s_bt",
    Text("{iso}: transverse tooth thickness at the base circle, thinned by the change E_W of its span", iso=ISO),
    unit="mm",
)
def base_thickness(d_b: Metre, s_t: Metre, d: Metre, alpha_t: Radian, E_W: Metre, beta_b: Radian) -> Metre:
    return d_b * (s_t / d + inv(alpha_t)) + E_W / cos(beta_b)


@formula("j_bn", Text("{iso}: normal backlash by the thicknesses at the base circles; exact", iso=ISO), unit="µm")
def backlash_of_bases(
    p_bt: Metre, s_b1: Metre, s_b2: Metre, d_b1: Metre, d_b2: Metre, alpha_wt: Radian, beta_b: Radian
) -> Metre:
    return joined(p_bt - s_b1 - s_b2, (d_b1 + d_b2) * inv(alpha_wt)) * cos(beta_b)


@formula("j_wt", Text("{iso}: circumferential backlash at the working circle", iso=ISO), unit="µm")
def circumferential_of_normal(j_bn: Metre, alpha_wt: Radian, beta_b: Radian) -> Metre:
    return j_bn / (cos(alpha_wt) * cos(beta_b))


@formula("j_t", Text("{iso}: circumferential backlash at the reference circle", iso=ISO), unit="µm")
def reference_backlash(j_wt: Metre, d: Metre, d_w: Metre) -> Metre:
    return j_wt * d / d_w


@formula("j_r", Text("{iso}: radial backlash, by which the centres can approach; to first order", iso=ISO), unit="µm")
def radial_backlash(j_wt: Metre, alpha_wt: Radian) -> Metre:
    return j_wt / (2 * tan(alpha_wt))


@formula(
    "a_min,F",
    "geometry: eccentricity of both wheels, half of each runout, towards each other",
    unit="mm",
    meanings={"return": "Smallest centre distance, with the runout of both wheels"},
)
def narrowest_with_runout(a_min: Metre, F_r1: Metre, F_r2: Metre) -> Metre:
    return a_min - (F_r1 + F_r2) / 2


@formula(
    "F_r",
    Text("ISO 1328-2:1997, from memory: runout of the teeth by their accuracy grade"),
    unit="µm",
    shows="(0.24·m_n + √d + 5.6)·2^((A − 5)/2), m_n and d in mm",
)
def runout_of_grade(m_n: Metre, d: Metre, A: Number) -> Metre:
    """>>> runout_of_grade(m_n=2.25e-3, d=0.072, A=7)
    2.9250562...e-05
    """
    row = house_table("iso_1328.toml")["runout"]
    of_grade = row["per_module"] * m_n * 1e3 + row["per_root"] * (d * 1e3) ** 0.5 + row["constant"]
    F_r: float = of_grade * 2 ** ((A - row["grade"]) / 2) * 1e-6
    return F_r


@formula(
    "j_bn,rec",
    Text("{guide}: recommended smallest backlash, steel or iron wheels in an iron housing", guide=GUIDE),
    unit="µm",
)
def recommended_backlash(a_w: Metre, m_n: Metre) -> Metre:
    """From memory; public summaries have the same three terms.  Meant for wheels of general engineering; it is no
    requirement."""
    return 2 * (LEAST_BACKLASH + 0.0005 * a_w + 0.03 * m_n) / 3


@formula("φ_j", "geometry: free turn of the driven wheel")
def play_angle(j_wt: Metre, d_w2: Metre) -> Radian:
    """>>> play_angle(j_wt=5.74e-05, d_w2=0.07768)
    0.001477857...
    """
    return j_wt / (d_w2 / 2)


@formula("Δφ", "kinematics: free turns along the train, each reduced to the last wheel by the ratio of the teeth")
def reduced_play(phi_before: Radian, phi_j: Radian, z: Number, z_last: Number) -> Radian:
    return phi_before + phi_j * z / z_last


@formula("φ_j", "geometry: free turn of the driven wheel by the backlash along its base circle")
def play_angle_at_base(j_bn: Metre, beta_b: Radian, d_b: Metre) -> Radian:
    """The same as j_wt/(d_w/2); growth of the base circle by temperature, 1 ‰, is left out."""
    return j_bn / cos(beta_b) / (d_b / 2)


@formula(
    "Δφ",
    "definition, where the sum over the train begins: the first driver stands",
    shows="0",
    meanings={"return": "Free turn of the first driver"},
)
def no_play() -> Radian:
    return 0.0


@formula("C_Δφ", "mathematics: exact difference of two couples of equal length, Δφ apart", names={"Delta_phi": "Δφ"})
def residual_couple(C: NewtonMetre, Delta_phi: Radian) -> NewtonMetre:
    return 2 * C * sin(Delta_phi / 2)


@formula("F_Δφ", "mathematics: exact difference of two forces of equal length, Δφ apart", names={"Delta_phi": "Δφ"})
def residual_force(F: Newton, Delta_phi: Radian) -> Newton:
    return 2 * F * sin(Delta_phi / 2)


# --- how it is set: by shims between the centres, or by a coat that wears off


@formula(
    "j'",
    Text("{iso}: change of the normal backlash over that of the centre distance; to first order", iso=ISO),
    meanings={"return": "Backlash for a change of the centre distance"},
)
def backlash_per_centre(alpha_wt: Radian, beta_b: Radian) -> Number:
    """>>> import math
    >>> backlash_per_centre(alpha_wt=math.radians(21.17), beta_b=math.radians(18.74724))
    0.683952...
    """
    return 2 * sin(alpha_wt) * cos(beta_b)


@formula(
    "j_bn,c",
    "geometry, set without backlash on a coat on both flanks of one wheel: what is there once it has worn off",
    unit="µm",
    meanings={"s_c": "Thickness of the coat", "return": "Backlash that the coat leaves"},
)
def coat_backlash(s_c: Metre) -> Metre:
    return 2 * s_c


@formula(
    "j_bn,need",
    "rule of this program: what tolerance, runout and temperature take of the nominal backlash at their worst",
    unit="µm",
    names={"j_bn": "j_bn", "j_least": "j_bn,least"},
    meanings={"j_least": "Smallest backlash that is judged", "return": "Backlash that is needed"},
)
def needed_backlash(j_bn: Metre, j_least: Metre) -> Metre:
    return j_bn - j_least


# --- the parts between two centres


@formula(
    "T_wc",
    "mathematics, worst case: every part at the end of its field, on the line of centres",
    unit="µm",
    names={"T": "T_i"},
    meanings={"T": "Tolerance fields of the parts"},
)
def worst_case(T: Metres) -> Metre:
    return total(T) / 2


@formula(
    "3σ_a",
    "mathematics, root of squares of the standard deviations; k: that of each part over half its field, by its kind",
    unit="µm",
    names={"T": "T_i", "k": "k_i"},
    meanings={"k": "Standard deviation over half the field, by its kind", "T": "Tolerance fields of the parts"},
)
def three_deviations(k: Numbers, T: Metres) -> Metre:
    """k is 1/2 for a position, 1/√2 for a fit and a runout, 1/√3 for a radial shift: elementary, after their
    distributions."""
    return 3 * rss(k * T) / 2


# --- temperature


@formula(
    "T_W",
    "given in the design: temperature of the wheels, warmer than the housing",
    meanings={"Delta_T": "Excess of the wheels over the housing"},
)
def wheel_temperature(T_H: Celsius, Delta_T: Kelvin) -> Celsius:
    return T_H + Delta_T


@formula(
    "α_a",
    "physics, expansion of the centre distance; λ_S: share of it that the support spans",
    unit="10⁻⁶/K",
    meanings={
        "alpha_H": "Thermal expansion of the housing",
        "alpha_S": "Thermal expansion of the support",
        "return": "Thermal expansion of the centre distance",
    },
)
def expansion_between_centres(alpha_H: PerKelvin, alpha_S: PerKelvin, lambda_S: Number) -> PerKelvin:
    return alpha_H * (1 - lambda_S) + alpha_S * lambda_S


@formula(
    "ε_T",
    "physics: linear expansion from 20 °C (ISO 1)",
    names={"alpha": "α_T", "T": "T_p"},
    meanings={"alpha": "Thermal expansion of the part", "T": "Temperature of the part"},
)
def expansion(alpha: PerKelvin, T: Celsius) -> Number:
    return alpha * (T - REFERENCE)


@formula("ε_g", "physics: expansion of both base circles together, which fixes the working pressure angle")
def expansion_of_wheels(eps_1: Number, eps_2: Number, d_b1: Metre, d_b2: Metre) -> Number:
    return (eps_1 * d_b1 + eps_2 * d_b2) / (d_b1 + d_b2)


@formula("Δa_eff", "geometry: change of the centre distance against the wheels", unit="µm")
def change_against_wheels(a_w: Metre, eps_a: Number, eps_g: Number) -> Metre:
    return a_w * joined(eps_a, -eps_g) / (1 + eps_g)


@formula("a_eff", "geometry: centre distance referred to the wheels as they are at 20 °C", unit="mm")
def effective_centre(a: Metre, eps_a: Number, eps_g: Number) -> Metre:
    return a * (1 + eps_a) / (1 + eps_g)


@formula(
    "j_bn,T",
    "geometry: normal backlash of wheels that have grown by ε; of a tooth in a space with the smaller base pitch",
    unit="µm",
)
def warm_backlash(
    p_bt: Metre,
    eps_1: Number,
    eps_2: Number,
    s_b1: Metre,
    s_b2: Metre,
    d_b1: Metre,
    d_b2: Metre,
    alpha_wt: Radian,
    beta_b: Radian,
) -> Metre:
    return joined(
        (1 + smallest(eps_1, eps_2)) * p_bt - (1 + eps_1) * s_b1 - (1 + eps_2) * s_b2,
        ((1 + eps_1) * d_b1 + (1 + eps_2) * d_b2) * inv(alpha_wt),
    ) * cos(beta_b)


# --- root of squares over the train


@formula(
    "δφ",
    "mathematics: what the tolerances of one mesh add to its play at mid-tolerance, reduced to the last wheel",
    names={"phi_max": "φ_j,max"},
)
def deviation_at_shaft(phi_max: Radian, phi_j: Radian, z: Number, z_last: Number) -> Radian:
    return (phi_max - phi_j) * z / z_last


@formula(
    "Δφ_rss",
    "mathematics: play at mid-tolerance and the root of squares of the meshes' deviations",
    names={"Delta_phi": "Δφ", "delta": "δφ"},
)
def phase_error_rss(Delta_phi: Radian, delta: Radians) -> Radian:
    return Delta_phi + rss(delta)


# What the play of a train gives beside the backlash over the tolerances, which stands with each mesh.


@result
class PlayResult(Shown):
    """One mesh.  Backlashes are normal to the flanks.  The smallest ones are with the runout, but for `backlash_min` of
    the mesh itself."""

    backlash_circumferential: Metre = value(
        "Circumferential backlash at the working circle, mid-tolerance", "µm", "j_wt"
    )
    backlash_transverse: Metre = value("Circumferential backlash at the reference circle, mid-tolerance", "µm", "j_t")
    backlash_radial: Metre = value("Radial backlash, mid-tolerance", "µm", "j_r")
    backlash_per_centre: Number = value("Backlash for a change of the centre distance, normal", "", "j'")
    coat_backlash: Metre | None = value(
        "Backlash once the coat has worn off, normal", "µm", "j_bn,c", default=None, short=True
    )
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
    backlash_min_runout: Metre = value("Smallest backlash with runout, normal", "µm", "j_bn,r")
    centre_change_cold: Metre = value("Change of the centre distance against the wheels, cold", "µm", "Δa_eff")
    centre_change_running: Metre = value("Change of the centre distance against the wheels, running", "µm", "Δa_eff")
    centre_change_warmer: Metre = value(
        "Change of the centre distance against the wheels, wheels warmer", "µm", "Δa_eff"
    )
    centre_change_warming: Metre = value("Change of the centre distance against the wheels, warming up", "µm", "Δa_eff")
    backlash_cold: Metre = value(
        "Smallest backlash at the lowest temperature, normal", "µm", "j_bn,cold", short=True, page_one=3, worst="least"
    )
    backlash_running: Metre = value("Smallest backlash at running temperature, normal", "µm", "j_bn,run", short=True)
    backlash_warmer: Metre = value(
        "Smallest backlash, wheels warmer than the housing, normal",
        "µm",
        "j_bn,warmer",
        short=True,
        page_one=4,
        worst="least",
    )
    backlash_warming: Metre = value(
        "Smallest backlash, wheels warmer and the housing still cold, normal", "µm", "j_bn,warming", short=True
    )
    backlash_median: Metre | None = value(
        "Smallest backlash over a turn by chance, median of the trains", "µm", "j_bn,50", default=None
    )
    backlash_99: Metre | None = value("Backlash that 99 % of the trains keep", "µm", "j_bn,99", default=None)
    share_jammed: Number | None = value("Trains in which the mesh can jam", "%", "p_jam", default=None)
    play_angle_nominal: Radian  # free turn of the driven wheel at mid-tolerance, below 0 where it is tight
    play_angle_running: Radian  # at the largest backlash, all parts at running temperature


@result
class TrainPlay(Shown):
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
