# SPDX-License-Identifier: Apache-2.0
"""Endless life of the throws: the fillets of pin and journal over the whole cycle, all around their circumference.

In the frame that turns with the throw the radial and the tangential force keep their planes, so that each point of a fillet has a stress
of its own over the cycle.  The amplitudes of bending and torsion are added as if they came at once, which is on the safe side.
"""

import numpy as np

from ..library import fatigue
from ..library.catalogue import Material
from ..sheet.arrays import Array, each, many
from ..sheet.check import Check, check
from ..sheet.formula import formula
from ..sheet.functions import sqrt
from ..sheet.quantity import result, value
from ..sheet.text import Text
from ..sheet.trace import about, untraced
from ..sheet.units import Metre, Number, Pascal
from ..sheet.value import based_on
from . import throw_strength as t
from .throw_inputs import ThrowInputs

Forces = tuple[Array, Array, Array]  # tangential, radial, and the torque from in front: (angles over the cycle, cylinders)
Notch = dict[str, tuple[Number, Number, Number]]
AROUND = 24  # points of a fillet over half of its circumference; the other half has the same with the other sign


@formula("σ_a", "statics: bending and torsion by von Mises", shows="√(σ_a² + 3·τ_a²) of the amplitudes, worst point", unit="MPa")
def amplitude(sigma: Pascal, tau: Pascal) -> Pascal:
    return sqrt(sigma**2 + 3 * tau**2)


@formula("σ_m", "statics: bending and torsion by von Mises; pressure counts as none", shows="√(σ_m² + 3·τ_m²) there", unit="MPa")
def mean(sigma: Pascal, tau: Pascal) -> Pascal:
    return sqrt(sigma**2 + 3 * tau**2)


@result
class ThrowFatigue:
    """The fillet that is nearest to fatigue, of all throws."""

    fatigue_amplitude: Pascal = value("Amplitude at the fillet that governs fatigue", "MPa", "σ_a")
    fatigue_mean: Pascal = value("its mean over the cycle", "MPa", "σ_m")
    fatigue_equivalent: Pascal = value("Alternating stress that equals both", "MPa", "σ_eq")
    fatigue_strength: Pascal = value("Alternating stress that a fillet bears", "MPa", "σ_A")
    fatigue_safety: Number = value("Safety of the fillets against fatigue", "", "j")
    place: str
    cylinder: int
    wanted: Number


def judged(
    forces: Forces, notch: Notch, throw: ThrowInputs, r: Metre, material: Material | None, load: tuple[object, ...]
) -> ThrowFatigue | None:
    """The worst fillet; None where no fillet is given or the material's strength is not known.

    `notch`: of each place ρ/d and the factors of bending and torsion; `load`: what the forces come from.
    """
    if not notch or material is None:
        return None
    with about(Text("fatigue of the throws")):
        bears = fatigue.strength(material)
        if bears is None:
            return None
        with untraced():
            found = [_worst(place, factors, forces, throw, r, bears.sensitivity) for place, factors in notch.items()]
        _, place, k, parts = max(found, key=lambda one: one[0])
        sigma_a, tau_a, sigma_m, tau_m = (based_on(part, *load, throw) for part in parts)
        a, m = amplitude(sigma=sigma_a, tau=tau_a), mean(sigma=sigma_m, tau=tau_m)
        equal = fatigue.equivalent_amplitude(sigma_a=a, sigma_m=m, M=bears.sensitivity)
        return ThrowFatigue(
            fatigue_amplitude=a, fatigue_mean=m, fatigue_equivalent=equal, fatigue_strength=bears.bearable,
            fatigue_safety=fatigue.safety(sigma_A=bears.bearable, sigma_eq=equal), place=place, cylinder=k + 1, wanted=bears.safety,
        )  # fmt: skip


def _worst(
    place: str, factors: tuple[Number, Number, Number], forces: Forces, throw: ThrowInputs, r: Metre, M: Number
) -> tuple[float, str, int, tuple[float, float, float, float]]:
    """Of one place: the largest equivalent amplitude, its cylinder from 0, and amplitudes and means of bending and torsion there."""
    F_t, F_r, T_v = map(each, forces)
    pin = place == "pin"
    arm = throw.journal_length / 2 + (throw.web_thickness if pin else 0.0)
    d = throw.pin_diameter if pin else throw.journal_diameter
    _, K_b, K_t = factors
    radial = many(K_b * t.bending_stress(M=F_r / 2 * arm, d=d))
    tangential = many(K_b * t.bending_stress(M=F_t / 2 * arm, d=d))
    torsion = t.pin_torsion(F_t=F_t, r=r, T_v=T_v) if pin else t.journal_torsion(F_t=F_t, r=r, T_v=T_v)
    tau = many(K_t * t.torsion_stress(T=torsion, d=d))
    around = np.arange(AROUND) * np.pi / AROUND
    sigma = radial[..., None] * np.cos(around) + tangential[..., None] * np.sin(around)  # (angles, cylinders, around)
    sigma_a, tau_a = np.ptp(sigma, 0) / 2, (np.ptp(tau, 0) / 2)[:, None]
    sigma_m, tau_m = np.abs(sigma.max(0) + sigma.min(0)) / 2, np.abs(tau.max(0) + tau.min(0))[:, None] / 2  # the point opposite is pulled
    a, m = amplitude(sigma=each(sigma_a), tau=each(tau_a)), mean(sigma=each(sigma_m), tau=each(tau_m))
    equal = many(fatigue.equivalent_amplitude(sigma_a=a, sigma_m=m, M=M))
    k, point = np.unravel_index(int(equal.argmax()), equal.shape)
    at = sigma_a[k, point], tau_a[k, 0], sigma_m[k, point], tau_m[k, 0]
    return float(equal.max()), place, int(k), (float(at[0]), float(at[1]), float(at[2]), float(at[3]))


def check_of(found: ThrowFatigue, part: Text) -> Check:
    """The safety of the worst fillet, `part` its place in words."""
    return check(
        "engine.throw.fatigue", Text("Safety of the throws against fatigue, fillet of the {part}", part=part), found.fatigue_safety, ">=",
        found.wanted, "", Text("{fkm}: endless life at rated speed", fkm=fatigue.FKM),
        Text("A larger fillet, a larger diameter; rolling or hardening the fillets, which is not counted here."),
    )  # fmt: skip
