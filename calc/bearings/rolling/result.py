# SPDX-License-Identifier: Apache-2.0
"""What is published of a rolling bearing."""

from ...sheet.quantity import group, result, value
from ...sheet.shown import Shown
from ...sheet.units import (
    Celsius,
    CubicMetrePerSecond,
    Hertz,
    Kilogram,
    Metre,
    Newton,
    NewtonMetre,
    NewtonPerMetre,
    Number,
    Pascal,
    Radian,
    RevPerSecond,
    Second,
    Watt,
)
from ..support import OnShaftResult


@result
class DutyRowResult(Shown):
    """One row of the duty."""

    loss: Watt = value("Friction power", "W", "P_f")
    life_basic: Second | None = value("Life by the load alone", "h", "L_10", default=None)
    viscosity_ratio: Number = value("Viscosity ratio", "", "κ")
    life_factor: Number | None = value("Life factor", "", "a_ISO", default=None)
    equivalent_load: Newton = value("Equivalent load", "N", "P")


@result
class RollingResult(Shown):
    """One rolling bearing at rated speed, its life over the whole duty."""

    life: Second | None = value(
        "Life, ISO 281 with a_ISO",
        "h",
        "L_nmh",
        short=True,
        page_one=1,
        worst="least",
        each=True,
        headline=1,
        default=None,
    )
    life_basic: Second | None = value("Life by the load alone", "h", "L_10h", short=True, default=None)
    life_reference: Second | None = value(
        "Life with the zone that the clearance leaves, a lower bound", "h", "L_nmrh", default=None
    )
    friction_power: Watt = value("Friction power", "W", "P_f", short=True, taken_by=("friction",))
    duty_loss: Watt = value(
        "Mean friction power of the duty", "W", "P_fm", short=True, page_one=3, worst="largest", each=True
    )
    running_temperature: Celsius = value(
        "Temperature of the bearing", "°C", "T_b", short=True, page_one=2, worst="largest"
    )
    load: Newton = value("Load that turns with the shaft", "N", "F_1", short=True)
    standing_load: Newton = value("Load that stands", "N", "F_2", short=True)
    load_peak: Newton = value("Largest load over a turn", "N", "R_max")
    mean_load: Newton = value("Mean load for the life", "N", "F_m")
    friction_load: Newton = value("Mean load for the friction", "N", "F_f")
    ring_factor: Number = value("Factor of the ring on which the load stands", "", "V")
    equivalent_load: Newton = value("Equivalent load", "N", "P", short=True)
    dynamic_rating: Newton = value("Dynamic load rating", "kN", "C_r", short=True)
    static_rating: Newton = value("Static load rating", "kN", "C_0", short=True)
    fatigue_limit: Newton = value("Fatigue load limit", "kN", "C_u")
    dynamic_rating_computed: Newton | None = value(
        "Dynamic load rating by ISO 281 and the typical inside, an estimate", "kN", "C_r,ISO", default=None
    )
    static_rating_computed: Newton | None = value(
        "Static load rating by ISO 76 and the typical inside, an estimate", "kN", "C_0,ISO", default=None
    )
    viscosity_ratio: Number = value("Viscosity ratio", "", "κ", short=True)
    contamination_factor: Number = value("Contamination factor", "", "e_C")
    life_factor: Number | None = value("Life factor", "", "a_ISO", short=True, default=None)
    static_safety: Number | None = value("Static safety", "", "S_0", short=True, default=None)
    torque: NewtonMetre = value("Torque of friction", "N·mm", "M")
    torque_two_part: NewtonMetre = value("the same by the two-part formula", "N·mm", "M_2")
    torque_palmgren: NewtonMetre | None = value(
        "the same by Palmgren's factors of 1957, as for the wheels' bearings", "N·mm", "M_P", default=None
    )
    speed_factor: Number = value("Speed factor n·d_m, rpm·mm", "", "n·d_m")
    reference_speed: RevPerSecond | None = value("Thermal reference speed", "rpm", "n_θr", default=None)
    minimum_load: Newton | None = value("Minimum load", "N", "F_min", short=True, default=None)
    minimum_load_speed: RevPerSecond | None = value(
        "Lowest speed from which the load is large enough", "rpm", default=None
    )
    clearance_running: Metre | None = value("Clearance as it runs", "µm", "s", short=True, default=None)
    clearance_least: Metre | None = value("Least clearance as it runs", "µm", "s_least", default=None)
    clearance_most: Metre | None = value("Most clearance as it runs", "µm", "s_most", default=None)
    clearance_cold: Metre | None = value("Least clearance at the lowest temperature", "µm", "s_cold", default=None)
    clearance_start: Metre | None = value(
        "Least clearance at 20 °C while the shaft warms first", "µm", "s_start", default=None
    )
    clearance_mounted: Metre | None = value("Clearance as mounted, at 20 °C", "µm", "s_20", default=None)
    grip_hot: Metre | None = value(
        "Loosest fit of the outer ring as it runs: below 0 it is loose", "µm", "U_o", short=True, default=None
    )
    stiffness: NewtonPerMetre | None = value("Radial stiffness", "kN/mm", "k_r", default=None)
    load_zone: Radian | None = value("Loaded zone", "°", "φ_z", default=None)
    contact_pressure: Pascal | None = value("Largest contact pressure", "MPa", "p_H", default=None)
    shear_depth: Metre | None = value("Depth of the largest shear stress", "mm", "z_τ", default=None)
    pass_frequency: Hertz | None = value("Frequency at which elements pass the load", "Hz", "f_pass", default=None)
    seat_diameter: Metre = value("Diameter of its seat", "mm", "D")
    bearing_mass: Kilogram = value("Mass of the bearing", "kg", "m_B")
    oil_flow: CubicMetrePerSecond = value("Pressure oil", "L/min", "Q")
    jet_flow: CubicMetrePerSecond = value("Oil that a jet would have to bring", "L/min", "Q_jet")
    duty: dict[str, DutyRowResult] = group(words="duty", short=False)
    on_shaft: OnShaftResult | None = group(spread=True, default=None)
