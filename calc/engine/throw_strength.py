# SPDX-License-Identifier: Apache-2.0
"""The strength of a crank throw: forces on its pin and journals, moments, stresses, and endless life of its fillets.

Tangential: in the sense of rotation.  Radial: positive towards the crank axis.  The pin is loaded at its middle and the
throw rests on the middles of its two journals, which the textbooks take as simple supports."""

import numpy as np

from ..library import fatigue
from ..library.catalogue import Material
from ..sheet.arrays import Array
from ..sheet.check import Check, CheckRule, Missing
from ..sheet.formula import formula
from ..sheet.functions import cos, pi, power, sqrt, tan, total
from ..sheet.quantity import dotted, result, value
from ..sheet.shown import Shown
from ..sheet.text import Text
from ..sheet.units import Kilogram, Metre, Newton, NewtonMetre, Newtons, Number, Pascal, Radian, RadPerSecond
from ..sheet.value import about, based_on, untraced
from .inputs import EngineInputs, ThrowInputs

ROD = Text("statics of the slider-crank (Finotti 2013, 2.2.1)")
BEAM = Text("statics, simply supported throw, pin loaded at its middle (mechanics textbook, 48.7)")
PLACES = {"pin": Text("pin"), "journal": Text("journal")}
NOTCH = Text("Norton, app. of stress-concentration factors, after Peterson: shouldered round shaft, D/d = 2")


# --- forces


@formula("F", Text("{rod}: force on the piston", rod=ROD))
def piston_force(F_G: Newton, F_I: Newton) -> Newton:
    return F_G + F_I


@formula("F_R", Text("{rod}: force in the rod, positive in compression", rod=ROD))
def rod_force(F: Newton, beta: Radian) -> Newton:
    return F / cos(beta)


@formula("F_N", Text("{rod}: side thrust on the liner", rod=ROD))
def side_thrust(F: Newton, beta: Radian) -> Newton:
    return F * tan(beta)


@formula("F_t", Text("{rod}: tangential force at the pin, torque over crank radius", rod=ROD))
def tangential_force(F: Newton, v_rel: Number) -> Newton:
    return F * v_rel


@formula("F_r", Text("{rod}: radial part of the rod's force, less the centrifugal force of its rotating mass", rod=ROD))
def radial_force(S: Newton, alpha: Radian, beta: Radian, M_rot: Kilogram, r: Metre, omega: RadPerSecond) -> Newton:
    return S * cos(alpha + beta) - M_rot * r * omega**2


@formula("ΣF", "mathematics: sum of the two rods on one pin")
def both_rods(F: Newton, F_other: Newton) -> Newton:
    return F + F_other


@formula("R", Text("{beam}: reaction of a main journal, half the pin's force", beam=BEAM))
def reaction(F_t: Newton, F_r: Newton) -> Newton:
    return sqrt(F_t**2 + F_r**2) / 2


@formula("T_v", "statics, torque through the front journal: sum over the cylinders on the throws in front")
def torque_in_front(F_t: Newtons, r: Metre) -> NewtonMetre:
    return total(F_t) * r


# --- moments


@formula("L", Text("{beam}: distance of the journals' middles", beam=BEAM), unit="mm")
def span(l_j: Metre, t_w: Metre, l_p: Metre) -> Metre:
    return l_j + 2 * t_w + l_p


@formula("M_p", Text("{beam}: bending moment at the pin's middle, both planes", beam=BEAM))
def pin_bending(R: Newton, L: Metre) -> NewtonMetre:
    return R * L / 2


@formula("M_pf", Text("{beam}: bending moment at the pin's fillet", beam=BEAM))
def pin_fillet_bending(R: Newton, l_j: Metre, t_w: Metre) -> NewtonMetre:
    return R * (l_j / 2 + t_w)


@formula("M_j", Text("{beam}: bending moment at the journal's edge to the web", beam=BEAM))
def journal_bending(R: Newton, l_j: Metre) -> NewtonMetre:
    return R * l_j / 2


@formula(
    "T_p",
    Text(
        "{beam}: torsion of the pin, by the front journal's reaction and the torque from the throws in front", beam=BEAM
    ),
)
def pin_torsion(F_t: Newton, r: Metre, T_v: NewtonMetre) -> NewtonMetre:
    return F_t * r / 2 + T_v


@formula("T_j", "statics, torque behind the throw: its own and that of the throws in front")
def journal_torsion(F_t: Newton, r: Metre, T_v: NewtonMetre) -> NewtonMetre:
    return F_t * r + T_v


# --- stresses


@formula("σ", "elasticity: elementary bending of a solid round section, nominal", unit="MPa")
def bending_stress(M: NewtonMetre, d: Metre) -> Pascal:
    return 32 * M / (pi * d**3)


@formula("τ", "elasticity: elementary torsion of a solid round section, nominal", unit="MPa")
def torsion_stress(T: NewtonMetre, d: Metre) -> Pascal:
    return 16 * T / (pi * d**3)


@formula("σ_v", "elasticity: equivalent stress after von Mises, bending and torsion", unit="MPa")
def von_mises(sigma: Pascal, tau: Pascal) -> Pascal:
    return sqrt(sigma**2 + 3 * tau**2)


@formula("ρ/d", "definition: relative fillet radius")
def relative_fillet(rho: Metre, d: Metre) -> Number:
    return rho / d


@formula("K_b", Text("{notch}, bending", notch=NOTCH))
def notch_bending(rho_d: Number) -> Number:
    return 0.90879 * power(rho_d, -0.28598)


@formula("K_t", Text("{notch}, torsion", notch=NOTCH))
def notch_torsion(rho_d: Number) -> Number:
    return 0.86331 * power(rho_d, -0.23865)


@formula("σ_vk", "elasticity: equivalent stress after von Mises at the fillet, elastic", unit="MPa")
def notch_stress(K_b: Number, sigma: Pascal, K_t: Number, tau: Pascal) -> Pascal:
    return sqrt((K_b * sigma) ** 2 + 3 * (K_t * tau) ** 2)


# --- endless life of the throws: the fillets of pin and journal over the whole cycle, all around
# In the frame that turns with the throw the radial and the tangential force keep their planes, so that each point of a
# fillet has a stress of its own over the cycle.  The amplitudes of bending and torsion are added as if they came at
# once, which is on the safe side.

# tangential, radial, and the torque from in front: (angles over the cycle, cylinders)
Forces = tuple[Array, Array, Array]
Notch = dict[str, tuple[Number, Number, Number]]
AROUND = 24  # points of a fillet over half of its circumference; the other half has the same with the other sign


@formula(
    "σ_a",
    "statics: bending and torsion by von Mises",
    shows="√(σ_a² + 3·τ_a²) of the amplitudes, worst point",
    unit="MPa",
)
def amplitude(sigma: Pascal, tau: Pascal) -> Pascal:
    return sqrt(sigma**2 + 3 * tau**2)


@formula(
    "σ_m",
    "statics: bending and torsion by von Mises; pressure counts as none",
    shows="√(σ_m² + 3·τ_m²) there",
    unit="MPa",
    meanings={"return": "Mean stress, by von Mises"},
)
def mean(sigma: Pascal, tau: Pascal) -> Pascal:
    return sqrt(sigma**2 + 3 * tau**2)


@result
class ThrowFatigue(Shown):
    """The fillet that is nearest to fatigue, of all throws."""

    fatigue_amplitude: Pascal = value("Amplitude at the fillet that governs fatigue", "MPa", "σ_a")
    fatigue_mean: Pascal = value("its mean over the cycle", "MPa", "σ_m")
    fatigue_equivalent: Pascal = value("Alternating stress that equals both", "MPa", "σ_eq")
    fatigue_strength: Pascal = value("Alternating stress that a fillet bears", "MPa", "σ_A")
    fatigue_safety: Number = value("Safety of the fillets against fatigue", "", "j", short=True)
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
            fillets = [_worst(place, factors, forces, throw, r, bears.sensitivity) for place, factors in notch.items()]
        _, place, k, parts = max(fillets, key=lambda fillet: fillet[0])
        sigma_a, tau_a, sigma_m, tau_m = (based_on(part, *load, throw) for part in parts)
        a, m = amplitude(sigma=sigma_a, tau=tau_a), mean(sigma=sigma_m, tau=tau_m)
        equal = fatigue.equivalent_amplitude(sigma_a=a, sigma_m=m, M=bears.sensitivity)
        return ThrowFatigue(
            fatigue_amplitude=a,
            fatigue_mean=m,
            fatigue_equivalent=equal,
            fatigue_strength=bears.bearable,
            fatigue_safety=fatigue.safety(sigma_A=bears.bearable, sigma_eq=equal),
            place=place,
            cylinder=k + 1,
            wanted=bears.safety,
        )


def _worst(
    place: str, factors: tuple[Number, Number, Number], forces: Forces, throw: ThrowInputs, r: Metre, M: Number
) -> tuple[float, str, int, tuple[float, float, float, float]]:
    """Of one place: the largest equivalent amplitude, its cylinder from 0, and amplitudes and means of bending and
    torsion there."""
    F_t, F_r, T_v = forces
    pin = place == "pin"
    arm = throw.journal_length / 2 + (throw.web_thickness if pin else 0.0)
    d = throw.pin_diameter if pin else throw.journal_diameter
    _, K_b, K_t = factors
    radial = K_b * bending_stress(M=F_r / 2 * arm, d=d)
    tangential = K_b * bending_stress(M=F_t / 2 * arm, d=d)
    torsion = pin_torsion(F_t=F_t, r=r, T_v=T_v) if pin else journal_torsion(F_t=F_t, r=r, T_v=T_v)
    tau = K_t * torsion_stress(T=torsion, d=d)
    around = np.arange(AROUND) * np.pi / AROUND
    sigma = radial[..., None] * np.cos(around) + tangential[..., None] * np.sin(around)  # (angles, cylinders, around)
    sigma_a, tau_a = np.ptp(sigma, 0) / 2, (np.ptp(tau, 0) / 2)[:, None]
    # the point opposite is pulled
    sigma_m, tau_m = (np.abs(sigma.max(0) + sigma.min(0)) / 2, np.abs(tau.max(0) + tau.min(0))[:, None] / 2)
    a, m = amplitude(sigma=sigma_a, tau=tau_a), mean(sigma=sigma_m, tau=tau_m)
    equal = fatigue.equivalent_amplitude(sigma_a=a, sigma_m=m, M=M)
    k, point = np.unravel_index(int(equal.argmax()), equal.shape)
    at = sigma_a[k, point], tau_a[k, 0], sigma_m[k, point], tau_m[k, 0]
    return float(equal.max()), place, int(k), (float(at[0]), float(at[1]), float(at[2]), float(at[3]))


FATIGUE = CheckRule(
    "engine.throw.fatigue",
    "caution",
    "A crack at a fillet breaks the crank; the notch is that of a round shaft, and rolled or hardened fillets bear "
    "more.",
    Text("Safety of the throws against fatigue"),
    source=Text("{fkm}: endless life at rated speed", fkm=fatigue.FKM),
    advice=Text("A larger fillet, a larger diameter; rolling or hardening the fillets, which is not counted here."),
    demand=True,
    cause="engine.throw.stress_pin",
    value_id=dotted("engine", EngineInputs.throw, ThrowFatigue.fatigue_safety),
    moved_by=(
        dotted("engine", EngineInputs.throw, ThrowInputs.fillet_radius),
        dotted("engine", EngineInputs.throw, ThrowInputs.pin_diameter),
        dotted("engine", EngineInputs.throw, ThrowInputs.journal_diameter),
    ),
    proven=(),
)


def fatigue_check(worst: ThrowFatigue | None, material: Material | None) -> Check:
    """The safety of the worst fillet; not verified where the strength of the material is not known."""
    if worst is not None:
        place = PLACES[worst.place]
        name = Text("Safety of the throws against fatigue, fillet of the {part}", part=place)
        return FATIGUE(worst.fatigue_safety, worst.wanted, name=name)
    kind = fatigue.KINDS.get(str(material.kind)) if material else None
    wanted = kind.safety if kind else max(other.safety for other in fatigue.KINDS.values())
    keys = (Material.tensile_strength,) if kind else (Material.kind, Material.tensile_strength)
    unknown = tuple(dotted("material", key) for key in keys)
    return FATIGUE(None, wanted, missing=Missing(unknown, (), "none", "none"))
