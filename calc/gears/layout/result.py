# SPDX-License-Identifier: Apache-2.0
"""What the layout of a train gives: where its wheels stand, which teeth meet, and the forces on the axes."""

from ...sheet.quantity import group, result, value
from ...sheet.shown import Shown
from ...sheet.units import Metre, Newton, NewtonMetre, Number, Radian


@result
class WheelLayout(Shown):
    """One wheel in its place.  Positions from the crank's axis; None: it has no place, or nothing is near it."""

    position_up: Metre | None = value("Axis, up from the crank's", "mm", "p_up", default=None)
    position_side: Metre | None = value(
        "Axis, 90° further in the sense of crank rotation", "mm", "p_side", default=None
    )
    included_angle: Radian | None = value("Angle between the lines of centres", "°", "φ", default=None)
    clearance_wall: Metre | None = value("Clearance to the nearest wall", "mm", "g", default=None)
    clearance_neighbour: Metre | None = value("Clearance to the nearest neighbour", "mm", "g", default=None)
    clearance_wheel: Metre | None = value(
        "Clearance to the nearest wheel that it does not mesh with", "mm", "g", default=None
    )
    tooth_angle: Radian | None = value("Middle of its tooth 1, cylinder 1 at TDC", "°", "θ", default=None)
    position: complex | None = None
    placed_by: str = ""
    nearest: str = ""  # what the smallest clearance is to
    clearance: Metre | None = None  # the smallest of the three


@result
class MeshLayout(Shown):
    """One mesh in its place."""

    line_of_centres: Radian | None = value("Line of centres, driver to driven wheel", "°", "γ", default=None)
    common_factor: Number = value("Common factor of the tooth numbers", "", "g_z")
    turns_to_repeat: Number = value("Turns of the driver until the same teeth meet", "", "N_m")


@result
class ShaftLayout(Shown):
    """How the wheel of one shaft can be assembled, and what a wrong tooth costs."""

    remesh_angle: Radian = value("Last wheel meshed one tooth further: its phase", "°", "τ")
    remesh_couple: NewtonMetre | None = value(
        "Couple left, last wheel meshed one tooth further", "N·m", "C_ε", default=None
    )
    eccentric_offset: Radian | None = value(
        "From the eccentric to the nearest tooth of the last wheel", "°", "δ_E", default=None
    )
    eccentric_tooth_error: Radian | None = value(
        "Phase error with a tooth on the eccentric's axis", "°", "ε_z", default=None
    )
    eccentric_tooth_couple: NewtonMetre | None = value(
        "Couple left, a tooth on the eccentric's axis", "N·m", "C_ε", default=None
    )
    eccentric_space_error: Radian | None = value(
        "Phase error with a space on the eccentric's axis", "°", "ε_s", default=None
    )
    eccentric_space_couple: NewtonMetre | None = value(
        "Couple left, a space on the eccentric's axis", "N·m", "C_ε", default=None
    )
    insertion_gap: Metre | None = value("Seat of the journal over the tip circle, diametral", "mm", "g_J", default=None)


@result
class LayoutResult(Shown):
    """The whole train.  `wheels`, `meshes` and `shafts` have the names of those of the train."""

    wheels: dict[str, WheelLayout] = group(spread=True)
    meshes: dict[str, MeshLayout] = group(spread=True)
    marks_period: Number = value("Turns of the first driver until all marks meet again", "", "N_M")
    shafts: dict[str, ShaftLayout] = group(spread=True, named="several")
    sprockets: dict[str, complex]  # places of those that turn beside no wheel


@result
class MeshForces(Shown):
    """Forces between the teeth of one mesh, at the working circles."""

    working_tangential_force: Newton = value("Tangential force at the working circle", "N", "F_tw")
    working_radial_force: Newton = value("Radial force at the working circle", "N", "F_rw")
    axial_force: Newton | None = value("Axial force", "N", "F_a", default=None)


@result
class WheelForces(Shown):
    """What a wheel's bearing carries.  _min and _max: over every included angle, where the wheels have no positions."""

    bearing_force: Newton | None = value("Load of its bearing, transverse", "N", "F_B", default=None)
    bearing_force_min: Newton | None = value(
        "Load of its bearing, least over the included angle", "N", "F_B,min", default=None
    )
    bearing_force_max: Newton | None = value(
        "Load of its bearing, most over the included angle", "N", "F_B,max", default=None
    )
    bearing_force_direction: Radian | None = value("Direction of that load, from up", "°", "ψ_B", default=None)
    thrust: Newton | None = value("Thrust (+: towards the flywheel)", "N", "F_x", default=None)
    tilting_couple: NewtonMetre | None = value("Tilting couple of the axial forces", "N·m", "M_K", default=None)
    tilting_couple_min: NewtonMetre | None = value(
        "Tilting couple, least over the included angle", "N·m", "M_K,min", default=None
    )
    tilting_couple_max: NewtonMetre | None = value(
        "Tilting couple, most over the included angle", "N·m", "M_K,max", default=None
    )
    hand: str = ""


@result
class ForcesResult(Shown):
    """The whole train."""

    wheels: dict[str, WheelForces] = group(spread=True)
    meshes: dict[str, MeshForces] = group(spread=True)
