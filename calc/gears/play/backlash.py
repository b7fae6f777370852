# SPDX-License-Identifier: Apache-2.0
"""Backlash of a pair over the tolerance of its centre distance, and what the backlash of a train means for its last wheel.

Backlash is exact at the very centre distance.  For small changes it is −(E_W1 + E_W2) + 2·Δa·sin α_wt·cos β_b: an allowance of
the span acts on it micrometre for micrometre.  Runout and temperature are not part of it: they stand in the other files of this room,
which take the same backlash from the thicknesses at the base circle.
"""

from collections.abc import Mapping

from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.functions import cos, inv, pi, rss, sin, tan
from ...sheet.record import record
from ...sheet.trace import about
from ...sheet.units import Metre, NewtonMetre, Number, Radian
from .. import formulas as f
from ..formulas import ISO
from ..measures.formulas import generating_shift
from ..result import MeshResult, ToothSystem, WheelResult

DUST: Metre = 1e-12  # a backlash below this is none
GUIDE = "ISO/TR 10064-2, from memory"
LEAST_BACKLASH: Metre = 0.06e-3  # the constant term of the guide value


@formula("T_a", "root of the sum of squares of the parts' fields, half of it to each side (Finotti 2013, Table 4.7)", unit="mm")
def tolerance_of_contributors(T: Metre) -> Metre:
    return rss(T) / 2


@formula("a_max", "centre distance at the upper end of its tolerance", unit="mm")
def widest(a_w: Metre, T_a: Metre) -> Metre:
    return a_w + T_a


@formula("a_min", "centre distance at the lower end of its tolerance", unit="mm")
def narrowest(a_w: Metre, T_a: Metre) -> Metre:
    return a_w - T_a


@formula("E_W", "middle of the allowance", unit="µm")
def middle_allowance(E_Ws: Metre, E_Wi: Metre) -> Metre:
    return (E_Ws + E_Wi) / 2


@formula("j_wt", f"{ISO}: circumferential backlash at the working circle", unit="µm")
def circumferential_backlash(d_w1: Metre, z_1: Number, s_w1: Metre, s_w2: Metre) -> Metre:
    return pi * d_w1 / z_1 - s_w1 - s_w2


@formula("j_bn", f"{ISO}: normal backlash", unit="µm")
def normal_backlash(j_wt: Metre, alpha_wt: Radian, beta_b: Radian) -> Metre:
    return j_wt * cos(alpha_wt) * cos(beta_b)


@formula("j_bn", "rule of this program: a backlash below 10⁻⁶ µm is that of the last digits, and none", unit="µm", shows="0")
def no_backlash(j_bn: Metre) -> Metre:
    return 0.0 * abs(j_bn)


@formula("s_bt", f"{ISO}: transverse tooth thickness at the base circle, thinned by the change E_W of its span", unit="mm")
def base_thickness(d_b: Metre, s_t: Metre, d: Metre, alpha_t: Radian, E_W: Metre, beta_b: Radian) -> Metre:
    return d_b * (s_t / d + inv(alpha_t)) + E_W / cos(beta_b)


@formula("j_bn", f"{ISO}: normal backlash by the thicknesses at the base circles; exact", unit="µm")
def backlash_of_bases(p_bt: Metre, s_b1: Metre, s_b2: Metre, d_b1: Metre, d_b2: Metre, alpha_wt: Radian, beta_b: Radian) -> Metre:
    return (p_bt - s_b1 - s_b2 + (d_b1 + d_b2) * inv(alpha_wt)) * cos(beta_b)


@formula("j_wt", f"{ISO}: circumferential backlash at the working circle", unit="µm")
def circumferential_of_normal(j_bn: Metre, alpha_wt: Radian, beta_b: Radian) -> Metre:
    return j_bn / (cos(alpha_wt) * cos(beta_b))


@formula("j_t", f"{ISO}: circumferential backlash at the reference circle", unit="µm")
def reference_backlash(j_wt: Metre, d: Metre, d_w: Metre) -> Metre:
    return j_wt * d / d_w


@formula("j_r", f"{ISO}: radial backlash, by which the centres can approach; to first order", unit="µm")
def radial_backlash(j_wt: Metre, alpha_wt: Radian) -> Metre:
    return j_wt / (2 * tan(alpha_wt))


@formula("a_min", "eccentricity of both wheels, half of each runout, towards each other", unit="mm")
def narrowest_with_runout(a_min: Metre, F_r1: Metre, F_r2: Metre) -> Metre:
    return a_min - (F_r1 + F_r2) / 2


@formula("j_bn,rec", f"{GUIDE}: recommended smallest backlash, steel or iron wheels in an iron housing", unit="µm")
def recommended_backlash(a_w: Metre, m_n: Metre) -> Metre:
    """From memory; public summaries have the same three terms.  Meant for wheels of general engineering; it is no requirement."""
    return 2 * (LEAST_BACKLASH + 0.0005 * a_w + 0.03 * m_n) / 3


@formula("φ_j", "free turn of the driven wheel")
def play_angle(j_wt: Metre, d_w2: Metre) -> Radian:
    return j_wt / (d_w2 / 2)


@formula("Δφ", "free turns along the train, each reduced to the last wheel by the ratio of the teeth")
def reduced_play(phi_before: Radian, phi_j: Radian, z: Number, z_last: Number) -> Radian:
    return phi_before + phi_j * z / z_last


@formula("φ_j", "free turn of the driven wheel by the backlash along its base circle")
def play_angle_at_base(j_bn: Metre, beta_b: Radian, d_b: Metre) -> Radian:
    """The same as j_wt/(d_w/2); growth of the base circle by temperature, 1 ‰, is left out."""
    return j_bn / cos(beta_b) / (d_b / 2)


@formula("Δφ", "where the sum over the train begins: the first driver stands", shows="0")
def no_play() -> Radian:
    return float("0")


@formula("C_Δφ", "exact difference of two couples of equal length, Δφ apart", names={"Delta_phi": "Δφ"})
def residual_couple(C: NewtonMetre, Delta_phi: Radian) -> NewtonMetre:
    return 2 * C * sin(Delta_phi / 2)


@record
class Pair:
    """What backlash needs to know of a mesh."""

    place: str  # where its centre distance stands in the design
    driver: WheelResult
    driven: WheelResult
    a_w: Metre
    tolerance: Metre  # ±, 0 where none is given


@record
class Backlash:
    smallest: Metre
    nominal: Metre
    largest: Metre
    play_angle: Radian


def backlash(system: ToothSystem, pair: Pair) -> Backlash:
    """Normal backlash over the tolerance of the centre distance and the allowances of both wheels."""
    subject = f"mesh {pair.driver.name}–{pair.driven.name}"
    upper, lower = ([_end(w, i) for w in (pair.driver, pair.driven)] for i in (0, 1))
    with about(f"{subject}, backlash at mid-tolerance"):
        middle = [middle_allowance(*w.allowance) if w.allowance else 0.0 for w in (pair.driver, pair.driven)]
        nominal, j_wt, d_w2 = _backlash_at(system, pair, pair.a_w, middle)
    smallest = largest = nominal
    if pair.tolerance or any(upper) or any(lower):
        with about(f"{subject}, largest backlash"):
            largest, j_wt, d_w2 = _backlash_at(system, pair, widest(pair.a_w, pair.tolerance), lower)
        with about(f"{subject}, smallest backlash"):
            closest = narrowest(pair.a_w, pair.tolerance)
            if closest <= (pair.driver.base_diameter + pair.driven.base_diameter) / 2:
                raise NoSolution(
                    f"{pair.place} = {pair.a_w * 1e3:.6g}: less its tolerance of {pair.tolerance * 1e3:.6g} mm the wheels can not mesh",
                    advice="give a tolerance_um that leaves the base circles apart",
                )
            smallest, _, _ = _backlash_at(system, pair, closest, upper)
    with about(f"{subject}, largest backlash"):
        return Backlash(smallest, nominal, largest, play_angle(j_wt, d_w2))


def _end(wheel: WheelResult, i: int) -> Metre:
    return wheel.allowance[i] if wheel.allowance else 0.0


def _backlash_at(system: ToothSystem, pair: Pair, a: Metre, allowances: list[Metre]) -> tuple[Metre, Metre, Metre]:
    """(j_bn, j_wt, working diameter of the driven wheel) at one centre distance, with one change of the span for each wheel."""
    alpha_wt = f.working_pressure_angle(pair.driver.base_diameter, pair.driven.base_diameter, a)
    d_w, s_w = [], []
    for wheel, mate, E_W in ((pair.driver, pair.driven, allowances[0]), (pair.driven, pair.driver, allowances[1])):
        x_E = generating_shift(wheel.profile_shift, E_W, system.m_n, system.alpha_n) if E_W else wheel.profile_shift
        d_w.append(f.working_diameter(a, wheel.teeth, mate.teeth))
        s_t = f.reference_thickness(system.m_n, x_E, system.alpha_n, system.beta)
        s_w.append(f.thickness_at(d_w[-1], s_t, wheel.pitch_diameter, system.transverse_pressure_angle, alpha_wt))
    j_wt = circumferential_backlash(d_w[0], pair.driver.teeth, *s_w)
    j_bn = normal_backlash(j_wt, alpha_wt, system.base_helix_angle)
    return (j_bn, j_wt, d_w[1]) if abs(j_bn) > DUST else (no_backlash(j_bn), 0.0, d_w[1])


def settled(j_bn: Metre) -> Metre:
    """The backlash, or none where it is only that of the last digits."""
    return j_bn if abs(j_bn) > DUST else no_backlash(j_bn)


def way_to(last_wheel: str, meshes: Mapping[str, MeshResult]) -> list[str]:
    """Keys of the meshes between the first driver and a wheel, along the flow of power."""
    above = {mesh.driven: key for key, mesh in meshes.items()}
    way: list[str] = []
    wheel = last_wheel
    while wheel in above:
        way.insert(0, above[wheel])
        wheel = meshes[above[wheel]].driver
    return way


def backlash_at_shaft(wheels: Mapping[str, WheelResult], meshes: Mapping[str, MeshResult], last_wheel: str) -> Radian:
    """How far the last wheel can turn while the first driver stands: the largest play of every mesh on the way to it."""
    return free_turn(wheels, meshes, last_wheel, {key: mesh.play_angle for key, mesh in meshes.items()})


def free_turn(wheels: Mapping[str, WheelResult], meshes: Mapping[str, MeshResult], last_wheel: str, plays: Mapping[str, Radian]) -> Radian:
    """The free turns of the driven wheels, by mesh, reduced to the last wheel and added up.

    A mesh that is tight adds nothing and takes nothing away.
    """
    angle = no_play()
    for key in way_to(last_wheel, meshes):
        if plays[key] > 0:
            angle = reduced_play(angle, plays[key], wheels[meshes[key].driven].teeth, wheels[last_wheel].teeth)
    return angle
