# SPDX-License-Identifier: Apache-2.0
"""The counter-shaft, given or sized: its couple, what it leaves of the imbalance, what its supports carry, how it bends and is made."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from ..catalogue import Material
from ..imbalance.remedies import roll_torque
from ..imbalance.solve import ImbalanceResult
from ..sheet.step import Outcome
from ..sheet.trace import about, trace
from ..sheet.units import KilogramPerMetre3, Metre, NewtonMetre, RadPerSecond
from . import formulas as f
from .inputs import CountershaftInputs, EccentricMass, Extra
from .judgement import checks, notes
from .outline import NoOutline, Outline, assembled, given, sectors_of, weighed
from .pictures import pictures
from .result import CountershaftResult, SupportResult
from .standing import Gear, standing
from .task import Task, task

Journals = tuple[tuple[Metre, Metre], ...]  # (diameter, length), front to rear


def solve(
    shaft: CountershaftInputs, imbalance: ImbalanceResult, omega: RadPerSecond, materials: Mapping[str, Material],
    journals: Journals, gear: Gear | None, slopes: tuple[float, ...] | None = None,
) -> Outcome:  # fmt: skip
    """Check a shaft against what the engine asks for, or size it first.

    `omega` is the crank's rated angular speed; `journals` are those of [bearings] or of the shaft itself, empty where they are not known;
    `slopes` are those of the journals where they are given, for a shaft whose outline is not known.
    """
    todo = task(shaft, imbalance)
    rho = materials[shaft.material].density
    said: list[str] = []
    with trace() as lines:
        omega_S = f.shaft_speed(i=shaft.speed_ratio, omega=omega)
        masses = shaft.masses
        F_S, C_S = _supplied(masses, shaft.extras, omega_S)
        found = _balance(shaft, todo, masses, F_S, C_S, omega_S)
        drawn = _outline(shaft, masses, rho, journals, gear, said)
        if drawn is not None:
            m_S, z_S = weighed(drawn, rho, shaft.extras)
            found = replace(found, outline=drawn, mass=m_S, centre_of_gravity=z_S)
        elif slopes:
            found = replace(found, slope_front=slopes[0], slope_rear=slopes[-1])
    return Outcome(
        "countershaft",
        result=found,
        checks=checks(shaft, todo, imbalance, found, journals),
        lines=tuple(lines),
        curves=pictures(todo, found),
        notes=(*notes(shaft, found), *said),
    )


def _supplied(masses: tuple[EccentricMass, ...], extras: tuple[Extra, ...], omega: RadPerSecond) -> tuple[complex, complex]:
    """The force and the couple of the shaft, cylinder 1 at TDC."""

    def of(parts: tuple[Any, ...]) -> tuple[complex, complex]:
        m, e, gamma, z = (_column(parts, name) for name in ("mass", "radius", "angle", "z"))
        C = f.shaft_couple(omega=omega, m=m, e=e, z=z, gamma=gamma)
        return f.shaft_force(omega=omega, m=m, e=e, gamma=gamma), C

    if not extras:
        return of(masses)
    with about("main masses"):
        F_m, C_m = of(masses)
    with about("further elements"):
        F_x, C_x = of(extras)
    return f.whole_force(F_m=F_m, F_x=F_x), f.whole_couple(C_m=C_m, C_x=C_x)


def _column(parts: tuple[Any, ...], name: str) -> Any:
    """One number of every element, as an array."""
    return np.array([getattr(part, name) for part in parts])


def _balance(
    shaft: CountershaftInputs, todo: Task, masses: tuple[EccentricMass, ...], F_S: complex, C_S: complex, omega: RadPerSecond
) -> CountershaftResult:
    """What the shaft supplies, what is left, and what two supports carry."""
    z_f, z_r = shaft.bearing_positions[0], shaft.bearing_positions[-1]
    couple, phase, force = f.couple(C_S=C_S), f.couple_phase(C_S=C_S), f.force(F_S=F_S)
    C_against, F_against = todo.C_against, todo.F_against
    if shaft.pair == "yes":
        with about("twin shaft"):
            C_against = f.residual_vector(C_like=C_against, C_S=f.mirrored_couple(C_S=C_S))
            F_against = f.residual_force_vector(F_like=F_against, F_S=f.mirrored_force(F_S=F_S))
    C_left = f.residual_couple(C_against=C_against, C_res=f.residual_vector(C_like=todo.C, C_S=C_S))
    F_left = f.residual_force(F_against=F_against, F_res=f.residual_force_vector(F_like=todo.F, F_S=F_S))
    R_r = f.reaction_rear(C_S=C_S, z_f=z_f, F_S=F_S, z_r=z_r)
    R_f = f.reaction_front(F_S=F_S, R_r=R_r)
    first = todo.order == 1
    return CountershaftResult(
        couple=couple,
        couple_phase=phase,
        residual_order_1_couple=C_left if first else None,
        residual_order_1_force=F_left if first else None,
        residual_order_2_couple=None if first else C_left,
        residual_order_2_force=None if first else F_left,
        static_unbalance=f.static_unbalance(F_S=force, omega=omega),
        force=force,
        reaction_front=f.reaction(R=R_f),
        reaction_rear=f.reaction(R=R_r),
        support={},
        eccentric_mass=f.eccentric_mass(m=_column(masses, "mass")),
        roll_torque=roll_torque(p=complex(*shaft.axis), F=F_S) if shaft.axis is not None and shaft.pair == "no" else None,
        force_vector=F_S,
        couple_vector=C_S,
        omega=omega,
    )


def _outline(
    shaft: CountershaftInputs,
    masses: tuple[EccentricMass, ...],
    rho: KilogramPerMetre3,
    journals: Journals,
    gear: Gear | None,
    said: list[str],
) -> Outline | None:
    """The shaft's pieces: given, or put together from what is known; else None, and a note says what is missing."""
    if shaft.sections:
        return given(shaft)
    R = shaft.outer_radius
    if R is None and journals:
        R = max(d for d, _ in journals) / 2 - (shaft.radial_clearance or 0.0)
    if R is None or shaft.core_radius is None or not journals:
        missing = [
            name
            for name, there in (
                ("core_radius_mm", shaft.core_radius is not None),
                ("outer_radius_mm", R is not None),
                ("[bearings] or [[countershaft.journals]]", bool(journals)),
            )
            if not there
        ]
        said.append(f"Mass, bending and critical speed are not computed: give [[countershaft.sections]], or {' and '.join(missing)}.")
        return None
    try:
        sectors = sectors_of(masses, rho, R, shaft.core_radius)
        found = assembled(
            sectors, journals, shaft.bearing_positions, shaft.core_radius,
            (gear.diameter / 2, gear.face_width) if gear is not None else None, shaft.gear_z, shaft.extras,
        )  # fmt: skip
    except NoOutline as none:
        said.append(f"Mass, bending and critical speed are not computed, since the shaft can not be drawn: {none}.")
        return None
    said.append(
        "The outline is put together from eccentric masses (as sectors of the same mass, centre of gravity and place), core, journals"
        + (" and gear" if gear is not None else "")
        + "; the true shape may be given as [[countershaft.sections]]."
    )
    return found


def with_standing(outcome: Outcome, shaft: CountershaftInputs, gear: Gear | None, torque: NewtonMetre | None) -> Outcome:
    """The same outcome with its weight and its gear's force on the bearings; on two bearings only."""
    if len(shaft.bearing_positions) != 2:
        return outcome
    found: CountershaftResult = outcome.result
    with trace() as lines, about("standing part of the load"):
        z_f, z_r = shaft.bearing_positions
        weight = None
        if found.mass is not None and found.centre_of_gravity is not None:
            G_S = f.weight(m_S=found.mass)
            G_r = f.weight_rear(G_S=G_S, z_S=found.centre_of_gravity, z_f=z_f, z_r=z_r)
            weight = G_S, f.weight_front(G_S=G_S, G_r=G_r), G_r
        reactions = found.reaction_front, found.reaction_rear
        stands = standing(reactions, shaft.bearing_positions, weight, gear, gear_place(shaft, found, gear), torque)
    return replace(outcome, result=replace(found, standing=stands), lines=(*outcome.lines, *lines))


def gear_place(shaft: CountershaftInputs, found: CountershaftResult, gear: Gear | None) -> Metre | None:
    """The middle of the gear: given, or as the outline has it; else the front bearing's."""
    if gear is None:
        return None
    if shaft.gear_z is not None or found.outline is None:
        return shaft.gear_z if shaft.gear_z is not None else shaft.bearing_positions[0]
    return next(((p.start + p.end) / 2 for p in found.outline.pieces if p.what == "gear"), shaft.bearing_positions[0])


__all__ = ["CountershaftResult", "Gear", "SupportResult", "solve", "with_standing"]
