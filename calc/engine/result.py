# SPDX-License-Identifier: Apache-2.0
"""What the engine gives: masses, kinematics and harmonics, the torque about its crank, the stresses of a throw."""

from typing import Generic

from ..sheet.arrays import Value
from ..sheet.quantity import Stated, group, result, value, values
from ..sheet.shown import Shown
from ..sheet.text import Text
from ..sheet.units import (
    Metre,
    MetrePerSecond,
    MetrePerSecond2,
    Newton,
    NewtonMetre,
    Number,
    Pascal,
    Radian,
    Watt,
)
from .crank import Crank
from .cycle import Cycle
from .formulas import Unlike
from .throw_strength import ThrowFatigue

MAIN_JOURNALS = {"front": Text("front"), "rear": Text("rear")}  # of a throw, which carry alike


@result
class CrankSection(Shown):
    """Moments and stresses of one section of the throw."""

    bending_moment: NewtonMetre = value("Bending moment", "N·m", "M")
    torsion: NewtonMetre = value("Torsion", "N·m", "T")
    bending_stress: Pascal = value("Bending stress, nominal", "MPa", "σ")
    torsion_stress: Pascal = value("Torsion stress, nominal", "MPa", "τ")
    von_mises: Pascal = value("Von Mises stress, nominal", "MPa", "σ_v")
    notch_stress: Pascal | None = value("Von Mises stress at the fillet", "MPa", "σ_vk", default=None)


@result
class Rod(Shown):
    """The forces of one cylinder at one crank angle."""

    crank_angle: Radian = value("Crank angle after the firing of this cylinder", "°", "ε_k")
    gas_force: Newton | None = value("Gas force on the piston", "N", "F_G", default=None)
    inertia_force: Newton = value("Inertia force of the reciprocating mass", "N", "F_I")
    piston_force: Newton = value("Force on the piston", "N", "F")
    rod_force: Newton = value("Force in the rod", "N", "F_R")
    side_thrust: Newton = value("Side thrust on the liner", "N", "F_N")
    tangential_force: Newton = value("Tangential force at the pin", "N", "F_t")
    radial_force: Newton = value("Radial force at the pin, towards the crank axis", "N", "F_r")


@result
class Position(Rod):
    """The governing throw at one crank angle.  `radial_force` and `tangential_force` are those of all rods on the
    pin."""

    reactions: dict[str, Newton] = values(
        "Reaction of the {row} main journal",
        "N",
        "R_*",
        id="reaction_*",
        called=MAIN_JOURNALS.__getitem__,
        sign=lambda journal: journal[0],
    )
    torque_in_front: NewtonMetre = value("Torque from the throws in front", "N·m", "T_v")
    pin: CrankSection = group(words="pin")
    journal: CrankSection = group(words="journal")


@result
class ThrowResult(Shown):
    """The governing throw in its two positions."""

    cylinder: Number = value("Cylinder whose throw governs")
    span: Metre = value("Distance of the middles of the main journals", "mm", "L")
    notch_bending_pin: Number | None = value("Notch factor of the pin, bending", "", "K_b", default=None)
    notch_torsion_pin: Number | None = value("Notch factor of the pin, torsion", "", "K_t", default=None)
    notch_bending_journal: Number | None = value("Notch factor of the journal, bending", "", "K_b", default=None)
    notch_torsion_journal: Number | None = value("Notch factor of the journal, torsion", "", "K_t", default=None)
    largest_tangential: Position = group(words="largest tangential")
    top_dead_centre: Position = group(words="top dead centre")
    fatigue: ThrowFatigue | None = group(spread=True, default=None)


@result
class TorqueResult(Shown):
    """The torque of the whole engine at rated speed; with gas over its cycle, else of the inertia forces alone."""

    inertia_torque_peak: NewtonMetre = value("Largest inertia torque, by amount", "N·m", "T_I")
    inertia_torque: dict[str, Stated] = group(words="inertia torque")
    reaction_inertia_peak: NewtonMetre = value(
        "Largest torque reaction of the inertia forces on the block, by amount", "N·m", "T_RI"
    )
    reaction_inertia: dict[str, Stated] = group(words="reaction inertia")
    reaction_peak: NewtonMetre | None = value(
        "Largest torque reaction on the block, by amount", "N·m", "T_R", default=None
    )
    gas_torque_peak: NewtonMetre | None = value("Largest gas torque, by amount", "N·m", "T_G", default=None)
    torque_peak: NewtonMetre | None = value("Largest torque, by amount", "N·m", "T_max", default=None)
    torque_peak_angle: Radian | None = value("its crank angle after the firing of cylinder 1", "°", default=None)
    compression_end_pressure: Pascal | None = value("Pressure at the end of compression", "bar", "p_c", default=None)
    indicated_work: NewtonMetre | None = value("Indicated work of one cylinder and cycle", "J", "W_i", default=None)
    indicated_mean_pressure: Pascal | None = value("Indicated mean pressure", "bar", "p_mi", default=None)
    mean_torque: NewtonMetre | None = value("Mean indicated torque", "N·m", "T_m", default=None, short=True)
    indicated_power: Watt | None = value("Indicated power", "kW", "P_i", default=None)
    torque_highest: NewtonMetre | None = value("Highest torque over the cycle", "N·m", "T_hi", default=None)
    torque_lowest: NewtonMetre | None = value("Lowest torque over the cycle", "N·m", "T_lo", default=None)
    energy_fluctuation: NewtonMetre | None = value("Energy fluctuation over the cycle", "J", "ΔE", default=None)
    speed_irregularity: Number | None = value("Speed irregularity", "", "δ_s", default=None, short=True)
    harmonics: tuple[complex, ...]  # t_1 … t_8 of the inertia torque: T = Re Σ t_n e^{inε}
    reaction_harmonics: tuple[complex, ...]  # the same of its reaction on the block
    cycle: Cycle | None  # the gas of a cylinder, for the crank throw


@result
class Cylinder(Shown):
    """One cylinder of an engine whose crank radii or offsets differ."""

    lambda_: Number = value("Crank ratio", "", "λ")
    stroke: Metre = value("Stroke", "mm", "s")
    mean_piston_speed: MetrePerSecond = value("Mean piston speed", "m/s", "u_m")
    piston_speed_max: MetrePerSecond = value("Largest piston speed", "m/s", "v_max")
    acceleration_max: MetrePerSecond2 = value("Largest piston acceleration", "m/s²", "a_max")
    acceleration_min: MetrePerSecond2 = value("Smallest piston acceleration", "m/s²", "a_min")


@result
class EngineResult(Shown, Generic[Value]):
    """Masses, kinematics and harmonics of an engine."""

    reciprocating_mass: Value = value(
        "Reciprocating mass per cylinder", "g", "M_alt", short=True, taken_by=("imbalance",)
    )
    rotating_mass: Value = value("Rotating mass per cylinder", "g", "M_rot", short=True)
    lambda_: Value = value("Crank ratio", "", "λ", short=True, headline=2, taken_by=("imbalance",))
    delta: Value = value("Offset ratio", "", "δ")
    angular_speed: Value = value("Angular speed", "rad/s", "ω", short=True)
    tdc_angle: Value = value("Crank angle at TDC", "°", "φ_0")
    stroke: Value = value("Stroke", "mm", "s", short=True, headline=1)
    displacement: Value = value("Displacement", "cm³", "V_h", short=True)
    mean_piston_speed: Value = value("Mean piston speed", "m/s", "u_m", short=True)
    brake_mean_pressure: Value | None = value("Brake mean effective pressure", "bar", "p_me", default=None, short=True)
    piston_speed_max: Value = value("Largest piston speed", "m/s", "v_max")
    piston_speed_max_angle: Value = value("Crank angle of the largest piston speed", "°", "α_v")
    acceleration_max: Value = value("Largest piston acceleration", "m/s²", "a_max", short=True)
    acceleration_min: Value = value("Smallest piston acceleration", "m/s²", "a_min")
    acceleration_min_angle: Value = value("Crank angle of the smallest acceleration", "°")
    firing_interval: Value | None = value("Firing interval, on average", "°", "Δ", default=None)
    firing_interval_shortest: Value | None = value("Shortest firing interval", "°", default=None)
    firing_interval_longest: Value | None = value("Longest firing interval", "°", default=None)
    harmonic: dict[str, Stated] | None = group(default=None, words="harmonic")
    cylinder: dict[str, Cylinder] | None = group(default=None, words="cylinder")
    torque: TorqueResult | None = group(spread=True, default=None)
    throw: ThrowResult | None = group(default=None, words="throw")
    crank: Crank
    unlike: Unlike | None  # where masses, crank radii or offsets differ from cylinder to cylinder
    harmonics: tuple[complex, ...]  # c_1 … c_8 of a/(ω² r), exact
    two_term: tuple[complex, ...]
