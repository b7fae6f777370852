# SPDX-License-Identifier: Apache-2.0
"""What the drive over speed publishes: the motion of the crank, and of every mesh its forces, strikes and grade."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from ...sheet.quantity import Stated, group, result, value
from ...sheet.record import record
from ...sheet.shown import Shown
from ...sheet.text import Text
from ...sheet.units import (
    KilogramMetre2,
    Metre,
    MetrePerSecond,
    Newton,
    NewtonMetre,
    Number,
    RadPerSecond2,
    RevPerSecond,
    Watt,
)

if TYPE_CHECKING:
    from ..rating.irregular import Irregular
    from .source import Drive
    from .survey import Survey

IDLE, IDLE_FULL, RATED, HARDEST = "idle", "idle_full", "rated", "hardest"
OPERATIONS = {
    IDLE: Text("idle, no load"),
    IDLE_FULL: Text("idle, full load"),
    RATED: Text("rated speed, full load"),
    HARDEST: Text("where it strikes hardest"),
}
MOST = "largest backlash, least drag"


@result
class MotionAt(Shown):
    """The crank at one operating point."""

    irregularity: Number = value("Irregularity of the crank", "%", "δ_s", short=True)
    acceleration_up: RadPerSecond2 = value("Largest acceleration of the crank", "rad/s²", "ω'_max")
    acceleration_down: RadPerSecond2 = value("Largest deceleration of the crank, negative", "rad/s²", "ω'_min")
    mean_torque: NewtonMetre | None = value("Mean torque on the crank, indicated", "N·m", "T_m", default=None)
    acceleration: dict[str, Stated] = group(words="acceleration")


@result
class MeshAt(Shown):
    """One mesh at one operating point.  Forces act along the transverse line of action, + on the driving flank; those
    ending in _most are with the largest backlash when all is warm and 0.7 of the drag."""

    separation: Number | None = value("Inertia over drag: above 1 the flanks part", "", "Γ", default=None)
    least_force: Newton = value("Least force of closed flanks over the cycle", "N", "F_lo")
    most_force: Newton = value("Largest force of closed flanks over the cycle", "N", "F_hi")
    impact_speed: MetrePerSecond = value("Speed of the hardest strike", "mm/s", "u_s")
    impact_force_low: Newton = value("Force of the hardest strike, low", "N", "F_u,lo")
    impact_force: Newton = value("Force of the hardest strike, high", "N", "F_u,hi")
    impact_power: Watt = value("Power lost by strikes of its body, about", "W", "W_u")
    impacts: Number = value("Strikes in a working cycle", "", "N_u")
    flanks: Number = value("Flanks that strike: none, one or both", "", "N_F")
    backlash_share: Number = value("Backlash of its way over half the swing of the driver", "", "J/x̂")
    separation_most: Number | None = value(f"Inertia over drag, {MOST}", "", "Γ", default=None)
    least_force_most: Newton = value(f"Least force of closed flanks, {MOST}", "N", "F_lo")
    most_force_most: Newton = value(f"Largest force of closed flanks, {MOST}", "N", "F_hi")
    impact_speed_most: MetrePerSecond = value(f"Speed of the hardest strike, {MOST}", "mm/s", "u_s")
    impact_force_low_most: Newton = value(f"Force of the hardest strike, low, {MOST}", "N", "F_u,lo")
    impact_force_most: Newton = value(f"Force of the hardest strike, high, {MOST}", "N", "F_u,hi")
    impact_power_most: Watt = value(f"Power lost by strikes of its body, {MOST}", "W", "W_u")
    impacts_most: Number = value(f"Strikes in a working cycle, {MOST}", "", "N_u")
    flanks_most: Number = value(f"Flanks that strike, {MOST}", "", "N_F")
    backlash_share_most: Number = value(f"Backlash over half the swing, {MOST}", "", "J/x̂")


@result
class ScissorResult(Shown):
    """A split wheel in its mesh; what is None is not known."""

    torque_least: NewtonMetre = value("Torque of the spring at the largest backlash", "N·m", "T_S")
    needed: NewtonMetre = value("Torque that holds the flanks closed, idle, no load", "N·m", "T_S,min")
    needed_range: NewtonMetre = value("Torque that holds them closed up to its speed, any load", "N·m", "T_S,min")
    opens_at: RevPerSecond | None = value("Lowest speed at which they part, any load", "rpm", "n_o", default=None)
    loss: Watt | None = value("Power that the spring costs in the mesh, at most", "W", "P_S", default=None)
    main_safety_contact: Number | None = value("Main half: safety against pitting", "", "S_H", default=None)
    main_safety_bending: Number | None = value("Main half: safety against tooth breakage", "", "S_F", default=None)
    sprung_safety_contact: Number | None = value("Sprung half: safety against pitting", "", "S_H", default=None)
    sprung_safety_bending: Number | None = value("Sprung half: safety against tooth breakage", "", "S_F", default=None)
    wheel: str
    width: Metre  # of the sprung half
    to: RevPerSecond  # of the crank, up to which it shall hold
    torque: NewtonMetre  # at no backlash


@result
class MeshOverSpeed(Shown):
    """One mesh over the range of speeds and loads."""

    operations: dict[str, MeshAt] = group(spread=True, key_words=OPERATIONS)
    reversal_from: RevPerSecond | None = value(
        "Lowest speed at which its flanks part, at any load", "rpm", "n_F,1", default=None
    )
    reversal_to: RevPerSecond | None = value(
        "Highest speed at which its flanks part, at any load", "rpm", "n_F,2", default=None
    )
    order: Number = value("Order of the mesh on the crank", "", "i_z")
    error_by_load: Metre | None = value("Transmission error by the load, peak to peak", "µm", "Δx_F", default=None)
    strike_safety_contact_low: Number | None = value(
        "Safety against pitting under the hardest strike, low", "", "S_H,u", default=None
    )
    strike_safety_contact: Number | None = value(
        "Safety against pitting under the hardest strike, high", "", "S_H,u", default=None
    )
    strike_safety_contact_most: Number | None = value(
        f"Safety against pitting under the hardest strike, high, {MOST}", "", "S_H,u", default=None
    )
    scissor: ScissorResult | None = group(default=None, words="scissor gear")


@result
class WheelStruck(Shown):
    """One wheel under the hardest strike in any of its meshes."""

    strike_safety_bending_low: Number | None = value(
        "Safety against tooth breakage under the hardest strike, low", "", "S_F,u", default=None
    )
    strike_safety_bending: Number | None = value(
        "Safety against tooth breakage under the hardest strike, high", "", "S_F,u", default=None
    )
    strike_safety_bending_most: Number | None = value(
        f"Safety against tooth breakage under the hardest strike, high, {MOST}", "", "S_F,u", default=None
    )


@record
class Window:
    """Of one way, by the body that strikes last on it.  `by_phase`: whether the phase error rules its upper end."""

    body: int
    nominal: Metre
    low: Metre
    high: Metre | None  # None: its strikes never reach grade B's limit, and nothing else bounds it
    quiet_a: Metre | None
    quiet_b: Metre | None
    by_phase: bool
    taken: Mapping[str, Metre]  # by mesh: what tolerance, runout and temperature take of it
    widened: Metre  # by how much the largest running backlash is above the nominal one


@result
class DriveResult(Shown):
    """The crank and the train behind it over speed and load."""

    idle_speed: RevPerSecond = value("Idle speed of the crank", "rpm", "n_i", short=True)
    inertia_total: KilogramMetre2 | None = value(
        "Inertia on the crank: flywheel and train", "kg·m²", "J_E", default=None
    )
    operations: dict[str, MotionAt] = group(spread=True, key_words=OPERATIONS)
    hardest_speed: RevPerSecond = value("Speed of the largest strike force, of those judged", "rpm", "n_u", short=True)
    hardest_load: Number = value("Load of the largest strike force, of those judged", "%", "p_u")
    impact_power: Watt = value("Power lost by strikes, about, at most", "W", "ΣW_u", short=True)
    impact_speed: MetrePerSecond | None = value(
        "Hardest strike of the drive at idle, no load",
        "mm/s",
        "u_s,i",
        default=None,
        short=True,
        page_one=9,
        headline=3,
    )
    grade: Number | None = value("Grade of the rattle at idle: 1 A, 2 B, 3 C", "", default=None)
    backlash_quiet_a: Metre | None = value(
        "Backlash on the way of grade A at idle, along the line of action", "µm", "J_A", default=None
    )
    backlash_quiet_b: Metre | None = value(
        "Backlash on the way of grade B at idle, along the line of action", "µm", "J_B", default=None
    )
    window_low: Metre | None = value("Least nominal backlash on the way", "µm", "J_lo", default=None)
    window_high: Metre | None = value("Largest nominal backlash on the way", "µm", "J_hi", default=None)
    assumed: Number = value("A default stands for the motion of the crank: 1 yes, 0 no", "")
    drive: "Drive"  # by which it can be surveyed at other points
    survey: "Survey"  # what is judged, as arrays
    most: "Survey"  # the published points at the largest backlash and the least drag
    at: Mapping[str, int]  # the published points in the survey
    meshes: Mapping[str, MeshOverSpeed]
    torques: "Irregular"  # what the rating takes
    jams: tuple[str, ...] = ()  # meshes that would strike at idle and have no backlash at mid-tolerance
    window: Window | None = None  # the way with the least room for its nominal backlash
