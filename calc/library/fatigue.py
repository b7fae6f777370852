# SPDX-License-Identifier: Apache-2.0
"""Endless life at a fillet: the elastic stress there by amplitude and mean, against what the material bears.

After the FKM guideline (analytical strength assessment), reduced to what is known of a design: alternating strength from the tensile
strength, roughness, mean stress; without the support of the steep gradient at a fillet, without size and hardened layers.  On the safe
side for steel.  Its constants are given from memory.
"""

from .catalogue import Material
from ..sheet.formula import formula
from ..sheet.functions import log10, smallest
from ..sheet.record import record
from ..sheet.text import Text
from ..sheet.units import Number, Pascal, PerPascal

FKM = Text("FKM guideline (from memory)")
ROUGHNESS = 6.3  # µm: Rz of a turned fillet, rule of this program


@record
class Kind:
    """Constants of a kind of metal: alternating over tensile strength; mean-stress sensitivity a·R_m + b; roughness a_R and the tensile
    strength R_N at which it begins [Pa]; the safety to be kept, higher for castings."""

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


@formula("σ_W", Text("{fkm}: alternating strength of forged or case-hardened steel 0.40, ductile iron 0.34, grey iron and cast aluminium "
    "0.30 of the tensile one", fkm=FKM), unit="MPa")  # fmt: skip
def alternating_strength(f_W: Number, R_m: Pascal) -> Pascal:
    """>>> alternating_strength(f_W=0.40, R_m=1026e6)
    410400000.0
    """
    return f_W * R_m


@formula("K_R", Text("{fkm}: roughness", fkm=FKM), names={"R_z": "R_z/µm"})
def roughness_factor(a_R: Number, R_z: Number, R_m: Pascal, R_N: Pascal) -> Number:
    """>>> roughness_factor(a_R=0.22, R_z=6.3, R_m=1026e6, R_N=400e6)
    0.8751...
    """
    return 1 - a_R * log10(R_z) * log10(2 * R_m / R_N)


@formula("M_σ", Text("{fkm}: mean-stress sensitivity", fkm=FKM), names={"a": "a_M", "b": "b_M"})
def mean_sensitivity(a: PerPascal, R_m: Pascal, b: Number) -> Number:
    """>>> mean_sensitivity(a=0.35e-9, R_m=1026e6, b=-0.10)
    0.2591
    """
    return a * R_m + b


@formula("σ_A", Text("{fkm}: what the fillet bears, alternating", fkm=FKM), unit="MPa")
def bearable(K_R: Number, sigma_W: Pascal) -> Pascal:
    return K_R * sigma_W


@formula("σ_eq", Text("{fkm}: alternating stress as hard as amplitude and mean together", fkm=FKM), unit="MPa", names={"M": "M_σ"})
def equivalent_amplitude(sigma_a: Pascal, sigma_m: Pascal, M: Number) -> Pascal:
    """`sigma_m` is not below zero: a mean pressure is given no credit.  The second line holds from a mean as large as the amplitude."""
    return smallest(sigma_a + M * sigma_m, (sigma_a + M / 3 * sigma_m) * (1 + M) / (1 + M / 3))


@formula(
    "σ_a",
    "rule of this program: every run-up from standstill is a cycle: amplitude and mean are half of the stress",
    unit="MPa",
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
