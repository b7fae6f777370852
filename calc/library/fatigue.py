# SPDX-License-Identifier: Apache-2.0
"""Endless life at a fillet: the elastic stress by amplitude and mean, what the material bears, and notch factors.

After the FKM guideline (analytical strength assessment), reduced to what is known of a design: alternating strength
from the tensile strength, roughness, mean stress; without the support of the steep gradient at a fillet, without size
and hardened layers.  On the safe side for steel.  Its constants are given from memory."""

from ..sheet.formula import formula
from ..sheet.functions import log10, smallest, sqrt
from ..sheet.record import record
from ..sheet.text import Text
from ..sheet.units import Metre, Number, Pascal, PerPascal
from .catalogue import Material

FKM = Text("FKM guideline (from memory)")
ROUGHNESS = 6.3  # µm: Rz of a turned fillet, rule of this program


@record
class Kind:
    """Constants of a kind of metal: alternating over tensile strength; mean-stress sensitivity a·R_m + b; roughness a_R
    and the tensile strength R_N at which it begins [Pa]; the safety to be kept, higher for castings."""

    ratio: Number
    a: PerPascal
    b: Number
    a_R: Number
    R_N: Pascal
    safety: Number


KINDS = {
    "steel": Kind(0.40, 0.35e-9, -0.10, 0.22, 400e6, 1.5),  # forged and case-hardened; others 0.45
    "ductile iron": Kind(0.34, 0.35e-9, 0.08, 0.16, 400e6, 2.1),
    "grey iron": Kind(0.30, 0.0, 0.50, 0.06, 100e6, 2.1),
    "aluminium": Kind(0.30, 1.0e-9, 0.20, 0.20, 133e6, 2.1),  # cast
}


@formula(
    "σ_W",
    Text(
        "{fkm}: alternating strength of forged or case-hardened steel 0.40, ductile iron 0.34, grey iron and cast "
        "aluminium "
        "0.30 of the tensile one",
        fkm=FKM,
    ),
    unit="MPa",
    meanings={
        "R_m": "Tensile strength",
        "return": "Alternating strength",
        "f_W": "Alternating strength over the tensile strength",
    },
)
def alternating_strength(f_W: Number, R_m: Pascal) -> Pascal:
    """>>> alternating_strength(f_W=0.40, R_m=1026e6)
    410400000.0
    """
    return f_W * R_m


@formula(
    "K_R",
    Text("{fkm}: roughness", fkm=FKM),
    names={"R_z": "R_z/µm"},
    meanings={
        "a_R": "Constant of the roughness factor",
        "R_z": "Roughness Rz in µm",
        "R_m": "Tensile strength",
        "R_N": "Least tensile strength of the group of materials",
        "return": "Roughness factor",
    },
)
def roughness_factor(a_R: Number, R_z: Number, R_m: Pascal, R_N: Pascal) -> Number:
    """>>> roughness_factor(a_R=0.22, R_z=6.3, R_m=1026e6, R_N=400e6)
    0.8751...
    """
    return 1 - a_R * log10(R_z) * log10(2 * R_m / R_N)


@formula(
    "M_σ",
    Text("{fkm}: mean-stress sensitivity", fkm=FKM),
    names={"a": "a_M", "b": "b_M"},
    meanings={
        "a": "Slope of the mean-stress sensitivity",
        "R_m": "Tensile strength",
        "b": "Constant of the mean-stress sensitivity",
    },
)
def mean_sensitivity(a: PerPascal, R_m: Pascal, b: Number) -> Number:
    """>>> mean_sensitivity(a=0.35e-9, R_m=1026e6, b=-0.10)
    0.2591
    """
    return a * R_m + b


@formula("σ_A", Text("{fkm}: what the fillet bears, alternating", fkm=FKM), unit="MPa")
def bearable(K_R: Number, sigma_W: Pascal) -> Pascal:
    return K_R * sigma_W


@formula(
    "σ_eq",
    Text("{fkm}: alternating stress as hard as amplitude and mean together", fkm=FKM),
    unit="MPa",
    names={"M": "M_σ"},
    meanings={"sigma_m": "Mean stress"},
)
def equivalent_amplitude(sigma_a: Pascal, sigma_m: Pascal, M: Number) -> Pascal:
    """`sigma_m` is not below zero: a mean pressure is given no credit.  The second line holds from a mean as large as
    the amplitude."""
    return smallest(sigma_a + M * sigma_m, (sigma_a + M / 3 * sigma_m) * (1 + M) / (1 + M / 3))


@formula(
    "σ_a",
    "rule of this program: every run-up from standstill is a cycle: amplitude and mean are half of the stress",
    unit="MPa",
    meanings={"return": "Stress amplitude of a run-up"},
)
def run_up_amplitude(sigma_k: Pascal) -> Pascal:
    return sigma_k / 2


@formula("j", Text("{fkm}: safety against fatigue, endless life", fkm=FKM))
def safety(sigma_A: Pascal, sigma_eq: Pascal) -> Number:
    return sigma_A / sigma_eq


@record
class Strength:
    """What a fillet of a material bears, how a mean stress counts, and the safety to be kept."""

    bearable: Pascal
    sensitivity: Number
    safety: Number


def strength(material: Material) -> Strength | None:
    """Of a material whose kind and tensile strength are known."""
    kind = KINDS.get(str(material.kind))
    if kind is None or material.tensile_strength is None:
        return None
    R_m = material.tensile_strength
    sigma_W = material.alternating_strength
    if sigma_W is None:
        sigma_W = alternating_strength(f_W=kind.ratio, R_m=R_m)
    K_R = roughness_factor(a_R=kind.a_R, R_z=ROUGHNESS, R_m=R_m, R_N=kind.R_N)
    return Strength(bearable(K_R=K_R, sigma_W=sigma_W), mean_sensitivity(a=kind.a, R_m=R_m, b=kind.b), kind.safety)


# --- notch factors: how far the elastic stress at a fillet exceeds the nominal one
# Shouldered round shaft in bending, after the curves that Pilkey fitted to Peterson's charts.  The nominal stress is
# that of the smaller diameter, σ = 32·M/(π·d³).  Valid for 0.1 ≤ t/r ≤ 20, t the height of the shoulder; at t/r = 2 the
# two fits lie 0.1 to 1.4 % apart up to 2t/D = 0.7, 3 % at 0.9.

PETERSON = Text("Pilkey, chart 3.10: shouldered round shaft, bending")
FIT = (0.1, 20.0)  # of t/r
BRANCH = 2.0  # of t/r, where the second fit begins


@formula(
    "ξ",
    "definition, t/r: height of the shoulder over the radius of its fillet",
    meanings={"D": "Larger diameter at the shoulder", "d": "Smaller diameter at the shoulder"},
)
def step_over_fillet(D: Metre, d: Metre, r: Metre) -> Number:
    return (D - d) / (2 * r)


@formula(
    "ζ",
    "definition, 2·t/D: height of the shoulder over the larger radius",
    meanings={"D": "Larger diameter at the shoulder", "d": "Smaller diameter at the shoulder"},
)
def relative_step(D: Metre, d: Metre) -> Number:
    return (D - d) / D


@formula("K_t", Text("{peterson}, t/r up to 2", peterson=PETERSON), names={"x": "ξ", "y": "ζ"})
def low_shoulder(x: Number, y: Number) -> Number:
    """x = t/r from 0.1 to 2, y = 2t/D."""
    return (
        0.947
        + 1.206 * sqrt(x)
        - 0.131 * x
        + (0.022 - 3.405 * sqrt(x) + 0.915 * x) * y
        + (0.869 + 1.777 * sqrt(x) - 0.555 * x) * y**2
        + (-0.810 + 0.422 * sqrt(x) - 0.260 * x) * y**3
    )


@formula("K_t", Text("{peterson}, t/r from 2 to 20", peterson=PETERSON), names={"x": "ξ", "y": "ζ"})
def high_shoulder(x: Number, y: Number) -> Number:
    """x = t/r from 2 to 20, y = 2t/D."""
    return (
        1.232
        + 0.832 * sqrt(x)
        - 0.008 * x
        + (-3.813 + 0.968 * sqrt(x) - 0.260 * x) * y
        + (7.423 - 4.868 * sqrt(x) + 0.869 * x) * y**2
        + (-3.839 + 3.070 * sqrt(x) - 0.600 * x) * y**3
    )


@formula("σ_k", "elasticity: elastic stress at the fillet, notch factor times nominal stress", unit="MPa")
def notch_stress(K_t: Number, sigma: Pascal) -> Pascal:
    """>>> notch_stress(K_t=2.353, sigma=9918000)
    2333705...
    """
    return K_t * sigma


def shoulder_bending(D: Metre, d: Metre, r: Metre) -> tuple[Number, Number]:
    """t/r and K_t of a shoulder from the diameter D down to d.  Outside `FIT` the factor is an extrapolation: the
    caller says so."""
    x = step_over_fillet(D=D, d=d, r=r)
    y = relative_step(D=D, d=d)
    return x, low_shoulder(x=x, y=y) if x <= BRANCH else high_shoulder(x=x, y=y)
