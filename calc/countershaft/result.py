# SPDX-License-Identifier: Apache-2.0
"""What the counter-shaft's step publishes."""

from typing import TYPE_CHECKING

from ..sheet.quantity import Stated, group, result, value, values
from ..sheet.shown import Shown
from ..sheet.text import Text
from ..sheet.units import (
    Kilogram,
    KilogramMetre,
    KilogramMetre2,
    Metre,
    Newton,
    NewtonMetre,
    NewtonPerMetreSecond,
    Number,
    Pascal,
    Radian,
    RadPerSecond,
    RevPerSecond,
)
from .bending.shaft import Bending
from .inputs import EccentricMass
from .making.unbalance import HolesResult, ToleranceResult
from .mass_properties import InertiaResult
from .outline import Outline
from .rows import called, sign
from .sums import SystemResult

if TYPE_CHECKING:  # loaded only where they are asked for
    from .balancing.result import BalancingResult
    from .making.bolts import BoltsResult
    from .making.drain import DrainResult
    from .making.scatter import ScatterResult
    from .sizing.choices import MaterialResult
    from .sizing.sectors import SizedSector


@result
class Standing(Shown):
    """The standing part of the bearings' load, and the largest load over a turn."""

    weight: Newton | None = value("Weight of the shaft", "N", "G_S", default=None)
    weights: dict[str, Newton] = values(
        "Weight on the {row} bearing", "N", "G_*", id="weight_*", called=called, sign=sign
    )
    gear_torque: NewtonMetre | None = value("Torque at the shaft's gear", "N·m", "T", default=None)
    gear_force_tangential: Newton | None = value("Tooth force, tangential", "N", "F_t", default=None)
    gear_force_radial: Newton | None = value("Tooth force, radial", "N", "F_r", default=None)
    gear_force_axial: Newton | None = value("Tooth force, axial", "N", "F_a", default=None)
    chain_pull: Newton | None = value("Pull of chains and belts on the shaft, at most", "N", "F_K", default=None)
    stationary: dict[str, Newton] = values(
        "Standing part at the {row} bearing, at most",
        "N",
        "R_0,*",
        id="stationary_*",
        called=called,
        sign=sign,
    )
    peaks: dict[str, Newton] = values(
        "Largest load of the {row} bearing over a turn",
        "N",
        id="reaction_*_peak",
        called=called,
        sign=sign,
        short=True,
    )


@result
class SupportResult(Shown):
    """One support: what it carries, and the load on its journal."""

    reaction: Newton = value("Reaction", "N", "F")
    reaction_clapeyron: Newton | None = value(
        "the same of a shaft of one stiffness at rest, by Clapeyron's three moments", "N", "F", default=None
    )
    specific_load: Pascal | None = value("Specific load", "MPa", "p", default=None)
    heat_index: NewtonPerMetreSecond | None = value("Heat index", "N·rpm/mm", "W", default=None)
    slope: Radian | None = value("Slope of the journal", "mrad", "θ", default=None)


@result
class CountershaftResult(Shown):
    """What the shaft supplies, leaves over and puts on its supports; how it bends; what its making needs."""

    couple: NewtonMetre = value("Couple of the shaft as designed", "N·m", "C_S", short=True, headline=1)
    couple_phase: Radian = value("its phase, cylinder 1 at TDC", "°", short=True)
    mass_moment: dict[str, Stated] = group(words="mass moment")
    sums: SystemResult | None = group(spread=True, default=None)  # with a twin both shafts'; of several no shaft's own
    static_unbalance: KilogramMetre = value("Static unbalance of the shaft", "g·mm", "ΣU")
    force: Newton = value("Rotating force of the shaft", "N", "F_S", short=True, headline=3)
    loads: dict[str, Newton] = values(
        "Reaction of the {row} bearing",
        "N",
        "R_*",
        id="reaction_*",
        called=called,
        sign=sign,
        short=True,
        taken_by=("bearings",),
    )
    # of what is no more than rounding there is none
    load_phases: dict[str, Radian] = values(
        "Phase of the {row} bearing's reaction on the shaft, cylinder 1 at TDC",
        "°",
        "∠R_*",
        id="reaction_*_phase",
        called=called,
        sign=sign,
    )
    loads_by_levers: dict[str, Newton] = values(
        "Reaction of the {row} bearing, by the levers of a rigid shaft",
        "N",
        "R_*",
        id="reaction_*_levers",
        called=called,
        sign=sign,
    )
    support: dict[str, SupportResult] = group(words="support")
    eccentric_mass: Kilogram = value("Eccentric masses together", "kg", "Σm")
    sector_half_angle: Radian | None = value(
        "Half-angle of a sector, the wider one", "°", "γ", default=None, short=True
    )
    sector_length: Metre | None = value("Length of a sector, the longer one", "mm", "b", default=None, short=True)
    sector_mass: Kilogram | None = value("Mass of a sector, the heavier one", "kg", "m", default=None, short=True)
    sector: "dict[str, SizedSector] | None" = group(default=None, words="sector")
    utilisation: Number | None = value("Utilisation of the envelope", "", "u", default=None)
    mass: Kilogram | None = value(
        "Mass of the whole shaft", "kg", "m_S", default=None, short=True, page_one=7, headline=2
    )
    centre_of_gravity: Metre | None = value("its centre of gravity from mid-shaft", "mm", "z_S", default=None)
    moment_of_inertia: KilogramMetre2 | None = value(
        "Moment of inertia about its axis",
        "kg·mm²",
        "J_S",
        default=None,
        short=True,
        taken_by=("gears",),
    )
    centre_of_gravity_up: Metre | None = value(
        "Centre of gravity of its outline, up from the axis, cylinder 1 at TDC", "mm", "x_G", default=None
    )
    centre_of_gravity_side: Metre | None = value(
        "the same, 90° further in the sense of crank rotation", "mm", "y_G", default=None
    )
    inertia: InertiaResult | None = group(default=None, words="inertia")
    outline_force_deviation: Newton | None = value(
        "Force of the given sections, off the masses'", "N", "ΔF_O", default=None
    )
    outline_couple_deviation: NewtonMetre | None = value(
        "Couple of the given sections, off the masses'", "N·m", "ΔC_O", default=None
    )
    standing: Standing | None = group(spread=True, default=None)
    slopes: dict[str, Radian] = values(
        "Slope of the {row} journal",
        "mrad",
        "θ_*",
        id="slope_*",
        called=called,
        sign=sign,
        short=True,
        page_one=8,
    )
    slopes_stiff: dict[str, Radian] = values(
        "Slope of the {row} journal, full stiffness",
        "mrad",
        "θ_*",
        id="slope_*_stiff",
        called=called,
        sign=sign,
        page_one=8,
    )
    first_critical_speed: RevPerSecond | None = value(
        "First bending critical speed on pins (natural frequency)", "rpm", "n_1", default=None, short=True
    )
    first_critical_speed_stiff: RevPerSecond | None = value("the same, full stiffness", "rpm", "n_1", default=None)
    first_critical_speed_without_rotary: RevPerSecond | None = value(
        "the first without rotary inertia, as other programs have it", "rpm", "n_1", default=None
    )
    first_critical_share: Number | None = value(
        "First bending critical speed over the highest speed", "", "n_1/n_max", default=None
    )
    fem_safety: Number | None = value(
        "Safety against fatigue of the largest principal stress by finite elements", "", "j", default=None
    )
    first_critical_speed_on_films: RevPerSecond | None = value(
        "the first on the films, in the housing with its stiffness", "rpm", "n_1", default=None, short=True
    )
    roll_torque: NewtonMetre | None = value("Roll torque of its force beside the crank", "N·m", "T_roll", default=None)
    bending: Bending | None = group(spread=True, default=None)
    tolerance: ToleranceResult | None = group(spread=True, default=None)
    holes: HolesResult | None = group(spread=True, default=None)
    balancing: "BalancingResult | None" = group(
        default=None,
        words="balancing sheet",
        key_words={
            "front": Text("front plane"),
            "rear": Text("rear plane"),
            "ring_front": Text("front ring"),
            "ring_rear": Text("rear ring"),
            "hole": Text("hole"),
            "reading": Text("reading"),
        },
    )
    scatter: "ScatterResult | None" = group(default=None, words="scatter")
    bolts: "BoltsResult | None" = group(spread=True, default=None)
    further_bolts: "dict[str, BoltsResult] | None" = group(default=None, words="further bolts")
    drain: "DrainResult | None" = group(spread=True, default=None)
    further_drains: "dict[str, DrainResult] | None" = group(default=None, words="further drains")
    alternative: "dict[str, MaterialResult] | None" = group(default=None, words="alternative")
    insertion_room_front: Metre | None = value("Room on the way in from the front", "mm", "c_R,f", default=None)
    insertion_room_rear: Metre | None = value("Room on the way in from the rear", "mm", "c_R,r", default=None)
    part_count: Number | None = value("Parts of the assembly", "", default=None)
    part_kinds: Number | None = value("Kinds of parts", "", default=None)
    couple_against: NewtonMetre  # what turns the other way, with a twin shaft what that leaves of it
    reactions: tuple[complex, ...]  # of the supports on the shaft, front to rear, cylinder 1 at TDC
    masses: tuple[EccentricMass, ...]  # given, or sized
    force_vector: complex  # F_S and C_S, cylinder 1 at TDC
    couple_vector: complex
    omega: RadPerSecond  # of the shaft
    outline: Outline | None = None
    wheel: Metre | None = None  # the middle of its wheel from mid-shaft

    @property
    def vectors(self) -> tuple[complex, complex]:
        """Force and couple, cylinder 1 at TDC."""
        return self.force_vector, self.couple_vector
