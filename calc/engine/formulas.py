# SPDX-License-Identifier: Apache-2.0
"""The slider-crank and its masses, in the order of Finotti 2013, chapter 2.

λ = r/L and δ = d/L must satisfy λ + |δ| < 1.  α is the crank angle from the cylinder's axis, in the sense of rotation;
the piston stands at TDC at α = φ₀.  Acceleration is positive towards the crank at TDC, as the derivative of the way
from TDC."""

from collections.abc import Iterator

from ..sheet.arrays import ComplexArray, Num
from ..sheet.formula import formula
from ..sheet.functions import asin, cos, pi, sin, sqrt, tan, total
from ..sheet.linked_array import gathered
from ..sheet.record import record, replace
from ..sheet.units import (
    CubicMetre,
    Kilogram,
    Kilograms,
    Metre,
    MetrePerSecond,
    MetrePerSecond2,
    Metres,
    Number,
    Numbers,
    Pascal,
    Radian,
    RadPerSecond,
    RevPerSecond,
    Watt,
)
from .inputs import EngineInputs


@formula("M_ra", "Finotti 2013, 2.5.3.1: reciprocating mass of the rod as two masses", unit="g")
def rod_reciprocating_mass(M_B: Kilogram, X_2: Metre, L: Metre) -> Kilogram:
    """The share of the rod that moves with the piston; X₂ is its CG to the big end."""
    return M_B * X_2 / L


@formula(
    "M_ra",
    "Finotti 2013, 2.2.2, its list (the text above it says two thirds): one third of the rod where its CG is not known",
    unit="g",
)
def rod_reciprocating_mass_by_thirds(M_B: Kilogram) -> Kilogram:
    return M_B / 3


@formula("M_alt", "Finotti 2013, 2.5.3.1: reciprocating mass per cylinder", unit="g")
def reciprocating_mass(M_P: Kilogram, M_ra: Kilogram) -> Kilogram:
    """>>> reciprocating_mass(M_P=1.178, M_ra=0.3113)
    1.4893
    """
    return M_P + M_ra


@formula("M_rot", "Finotti 2013, 2.5.3.1: rotating mass per cylinder, crank throw apart", unit="g")
def rotating_mass(M_shell: Kilogram, M_B: Kilogram, M_ra: Kilogram) -> Kilogram:
    """>>> rotating_mass(M_shell=0.055, M_B=1.015, M_ra=0.31128)
    0.7587199...
    """
    return M_shell + M_B - M_ra


@formula("M_alt", "definition: reciprocating mass per cylinder, as given", unit="g")
def given_reciprocating_mass(M_given: Kilogram) -> Kilogram:
    return M_given


@formula("M_rot", "definition: rotating mass per cylinder, as given", unit="g")
def given_rotating_mass(M_given: Kilogram) -> Kilogram:
    return M_given


@formula("M_alt", "mathematics: mean over cylinders whose reciprocating masses differ", unit="g")
def mean_reciprocating_mass(M_k: Kilograms, N: Number) -> Kilogram:
    return total(M_k) / N


@formula("M_rot", "mathematics: mean over cylinders whose rotating masses differ", unit="g")
def mean_rotating_mass(M_k: Kilograms, N: Number) -> Kilogram:
    return total(M_k) / N


@formula("λ", "Finotti 2013, 2.1: crank ratio")
def crank_ratio(r: Metre, L: Metre) -> Number:
    """>>> crank_ratio(r=0.0535, L=0.163)
    0.3282208...
    """
    return r / L


@formula("δ", "Finotti 2013, 2.1: offset ratio")
def offset_ratio(d: Metre, L: Metre) -> Number:
    return d / L


@formula("ω", "definition of angular speed")
def angular_speed(n: RevPerSecond) -> RadPerSecond:
    """>>> angular_speed(n=43.33)
    272.2504...
    """
    return 2 * pi * n


@formula("φ_0", "Finotti 2013, 2.1: crank angle of TDC with an offset cylinder", names={"lam": "λ"})
def tdc_angle(delta: Number, lam: Number) -> Radian:
    return asin(delta / (1 + lam))


@formula("s", "kinematics, stroke of the offset slider-crank: distance of its dead centres", unit="mm")
def stroke(L: Metre, r: Metre, d: Metre) -> Metre:
    """>>> stroke(L=0.163, r=0.0535, d=0.005)
    0.1070564...
    """
    return sqrt((L + r) ** 2 - d**2) - sqrt((L - r) ** 2 - d**2)


@formula("V_h", "definition of displacement", unit="cm³")
def displacement(N: Number, D: Metre, s: Metre) -> CubicMetre:
    """>>> displacement(N=3, D=0.094, s=0.107)
    0.002227668...
    """
    return N * pi / 4 * D**2 * s


@formula("V_h", "definition of displacement, of cylinders whose strokes differ", unit="cm³")
def displacement_of_unlike(D: Metre, s: Metres) -> CubicMetre:
    return pi / 4 * D**2 * total(s)


@formula("u_m", "Finotti 2013, 2.1: mean piston speed")
def mean_piston_speed(s: Metre, n: RevPerSecond) -> MetrePerSecond:
    """>>> mean_piston_speed(s=0.107, n=43.33)
    9.27262
    """
    return 2 * s * n


@formula("p_me", "definition of the brake mean effective pressure", unit="bar")
def brake_mean_pressure(P_e: Watt, strokes: Number, V_h: CubicMetre, n: RevPerSecond) -> Pascal:
    """>>> brake_mean_pressure(P_e=50000.0, strokes=4, V_h=0.0022277, n=43.333)
    1035915.99...
    """
    return P_e * strokes / (2 * V_h * n)


@formula("β", "Finotti 2013, 2.1: angle of the rod", meanings={"alpha": "Crank angle from TDC"})
def rod_angle(lam: Number, alpha: Radian, delta: Number) -> Radian:
    return asin(lam * sin(alpha) - delta)


@formula("x/r", "the piston's way from TDC, exact (Finotti 2013, eq. 2.7, which misplaces δ; here with the offset)")
def relative_path(alpha: Radian, beta: Radian, lam: Number, delta: Number) -> Number:
    return (sqrt((1 + lam) ** 2 - delta**2) - cos(beta)) / lam - cos(alpha)


@formula("x_2/r", "the way whose derivative is the two-term speed (Finotti 2013, eq. 2.9)")
def relative_path_two_term(alpha: Radian, lam: Number, delta: Number) -> Number:
    return 1 - cos(alpha) - delta * sin(alpha) + lam / 4 * (1 - cos(2 * alpha))


@formula(
    "v/(ω·r)",
    "kinematics: first derivative of the piston's way, exact (Finotti 2013, 2.1, with offset)",
    meanings={"alpha": "Crank angle from TDC"},
)
def relative_speed(alpha: Radian, beta: Radian) -> Number:
    return sin(alpha) + cos(alpha) * tan(beta)


@formula("v_2/(ω·r)", "Finotti 2013, eq. 2.9: the two-term form, with the offset's share")
def relative_speed_two_term(alpha: Radian, lam: Number, delta: Number) -> Number:
    return sin(alpha) - delta * cos(alpha) + lam / 2 * sin(2 * alpha)


@formula(
    "a/(ω²·r)",
    "kinematics: second derivative of the piston's way, exact (Finotti 2013, 2.1, with offset)",
    meanings={"alpha": "Crank angle from TDC"},
)
def relative_acceleration(alpha: Radian, beta: Radian, lam: Number) -> Number:
    return cos(alpha) - sin(alpha) * tan(beta) + lam * cos(alpha) ** 2 / cos(beta) ** 3


@formula("a_2/(ω²·r)", "Finotti 2013, 2.1: the two-term form, with the offset's share of the first order")
def relative_acceleration_two_term(alpha: Radian, lam: Number, delta: Number) -> Number:
    return cos(alpha) + delta * sin(alpha) + lam * cos(2 * alpha)


@formula(
    "α_min",
    "mathematics: crank angle of the smallest acceleration",
    shows="where a/(ω²·r) is smallest; at λ > ¼ before BDC",
)
def angle_of_smallest(a_rel: Numbers, alpha: Radian) -> Radian:
    return alpha


@formula(
    "α_v",
    "crank angle of the largest speed (Finotti 2013, 2.1: there of two terms)",
    shows="where |v|/(ω·r) is largest",
)
def angle_of_fastest(v_rel: Numbers, alpha: Radian) -> Radian:
    return alpha


@formula("a", "mathematics: acceleration of the piston, extreme value over the turn")
def acceleration(a_rel: Number, omega: RadPerSecond, r: Metre) -> MetrePerSecond2:
    return a_rel * omega**2 * r


@formula("v_max", "mathematics: largest speed of the piston")
def piston_speed(v_rel: Number, omega: RadPerSecond, r: Metre) -> MetrePerSecond:
    return v_rel * omega * r


# --- the masses that move with a cylinder
# By its piston and rod, or as they are given, one for all or one for each; and what else differs.


@record
class Unlike:
    """What cylinders have that are not alike: arrays, (cylinders,), of what differs, and one number of what does
    not."""

    reciprocating: Num
    rotating: Num
    radius: Num
    lambda_: Num
    harmonics: tuple[complex | ComplexArray, ...]  # as those of the engine
    two_term: tuple[complex | ComplexArray, ...]
    delta: Num
    tdc_angle: Num
    offset: Num


def alone(engine: EngineInputs) -> Iterator[EngineInputs]:
    """Each cylinder as an engine of its own."""
    for k, (r, d) in enumerate(zip(engine.radii, engine.offsets)):
        alternating, rotating = engine.reciprocating_masses, engine.rotating_masses
        yield replace(
            engine,
            layout="inline",
            cylinders=1,
            firing_order=None,
            crank_angles=None,
            axial_positions=(0.0,),
            bank_angle=None,
            bank_of_cylinder=None,
            cylinder_directions=None,
            crank_radius=r,
            crank_radii=None,
            cylinder_offset=d,
            cylinder_offsets=None,
            rated_power=None,
            reciprocating_masses=None if alternating is None else alternating[k % len(alternating) :][:1],
            rotating_masses=None if rotating is None else rotating[k % len(rotating) :][:1],
        )


def masses(engine: EngineInputs) -> tuple[Kilogram, Kilogram, tuple[Num, Num]]:
    """Reciprocating and rotating mass of a cylinder, and those of each: where they differ, the first two are their
    means.

    A reciprocating mass that is given has its share of the rod in it; what rotates of a rod that is given beside it
    counts all the same."""
    rod = None
    if engine.rod_mass is not None and engine.rod_cg_to_big_end is None:
        rod = rod_reciprocating_mass_by_thirds(M_B=engine.rod_mass)
    elif engine.rod_mass is not None and engine.rod_cg_to_big_end is not None:
        rod = rod_reciprocating_mass(M_B=engine.rod_mass, X_2=engine.rod_cg_to_big_end, L=engine.rod_length)
    reciprocating: tuple[Kilogram, ...] | Kilogram | None = engine.reciprocating_masses
    if engine.piston_mass is not None and rod is not None:
        reciprocating = reciprocating_mass(M_P=engine.piston_mass, M_ra=rod)
    assert reciprocating is not None
    rotating: tuple[Kilogram, ...] | Kilogram | None = engine.rotating_masses
    if rotating is None:
        rotating = engine.crankpin_bearing_mass
        if engine.rod_mass is not None and rod is not None:
            rotating = rotating_mass(M_shell=engine.crankpin_bearing_mass, M_B=engine.rod_mass, M_ra=rod)
    if not engine.unlike_masses:
        M_alt = (
            given_reciprocating_mass(M_given=reciprocating[0]) if isinstance(reciprocating, tuple) else reciprocating
        )
        by_rod = engine.rotating_masses is None and rod is not None
        M_rot = _one(rotating)
        M_rot = M_rot if by_rod else given_rotating_mass(M_given=M_rot)
        return M_alt, M_rot, (M_alt, M_rot)
    n = engine.cylinders
    of_each = _each(reciprocating, n), _each(rotating, n)
    return mean_reciprocating_mass(M_k=of_each[0], N=n), mean_rotating_mass(M_k=of_each[1], N=n), of_each


def _one(given: tuple[Kilogram, ...] | Kilogram) -> Kilogram:
    """The mass of a cylinder of an engine whose cylinders are alike."""
    return given[0] if isinstance(given, tuple) else given


def _each(given: tuple[Kilogram, ...] | Kilogram, cylinders: int) -> Kilograms:
    return gathered(given if isinstance(given, tuple) and len(given) == cylinders else (_one(given),) * cylinders)
