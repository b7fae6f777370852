# SPDX-License-Identifier: Apache-2.0
"""The masses that move with a cylinder: by its piston and rod, or as they are given, one for all or one for each; and what else differs."""

from collections.abc import Iterator
from dataclasses import replace

from ..sheet.arrays import each
from ..sheet.linked_array import gathered
from ..sheet.record import record
from ..sheet.units import Kilogram, Metre, Number
from . import formulas as f
from .inputs import EngineInputs


@record
class Unlike:
    """What cylinders have that are not alike: arrays, (cylinders,), of what differs, and one number of what does not."""

    reciprocating: Kilogram
    rotating: Kilogram
    radius: Metre
    lambda_: Number
    harmonics: tuple[complex, ...]  # as those of the engine
    two_term: tuple[complex, ...]


def alone(engine: EngineInputs) -> Iterator[EngineInputs]:
    """Each cylinder as an engine of its own."""
    for k, r in enumerate(engine.crank_radii or ()):
        alternating, rotating = engine.reciprocating_masses, engine.rotating_masses
        yield replace(
            engine, layout="inline", cylinders=1, firing_order=None, crank_angles=None, axial_positions=None, bank_angle=None,
            bank_of_cylinder=None, crank_radius=r, crank_radii=None, rated_power=None,
            reciprocating_masses=None if alternating is None else alternating[k % len(alternating) :][:1],
            rotating_masses=None if rotating is None else rotating[k % len(rotating) :][:1],
        )  # fmt: skip


def masses(engine: EngineInputs) -> tuple[Kilogram, Kilogram, tuple[Kilogram, Kilogram]]:
    """Reciprocating and rotating mass of a cylinder, and those of each: where they differ, the first two are their means.

    A reciprocating mass that is given has its share of the rod in it; what rotates of a rod that is given beside it counts all the same.
    """
    rod = None
    if engine.rod_mass is not None and engine.rod_cg_to_big_end is None:
        rod = f.rod_reciprocating_mass_by_thirds(M_B=engine.rod_mass)
    elif engine.rod_mass is not None and engine.rod_cg_to_big_end is not None:
        rod = f.rod_reciprocating_mass(M_B=engine.rod_mass, X_2=engine.rod_cg_to_big_end, L=engine.rod_length)
    reciprocating: tuple[Kilogram, ...] | Kilogram | None = engine.reciprocating_masses
    if engine.piston_mass is not None and rod is not None:
        reciprocating = f.reciprocating_mass(M_P=engine.piston_mass, M_ra=rod)
    assert reciprocating is not None
    rotating: tuple[Kilogram, ...] | Kilogram | None = engine.rotating_masses
    if rotating is None:
        rotating = engine.crankpin_bearing_mass
        if engine.rod_mass is not None and rod is not None:
            rotating = f.rotating_mass(M_shell=engine.crankpin_bearing_mass, M_B=engine.rod_mass, M_ra=rod)
    if not engine.unlike_masses:
        M_alt = f.given_reciprocating_mass(M_given=reciprocating[0]) if isinstance(reciprocating, tuple) else reciprocating
        by_rod = engine.rotating_masses is None and rod is not None
        M_rot = _one(rotating)
        M_rot = M_rot if by_rod else f.given_rotating_mass(M_given=M_rot)
        return M_alt, M_rot, (M_alt, M_rot)
    n = engine.cylinders
    M_alt, M_rot = _each(reciprocating, n), _each(rotating, n)
    return f.mean_reciprocating_mass(M_k=M_alt, N=n), f.mean_rotating_mass(M_k=M_rot, N=n), (M_alt, M_rot)


def _one(given: tuple[Kilogram, ...] | Kilogram) -> Kilogram:
    """The mass of a cylinder of an engine whose cylinders are alike."""
    return given[0] if isinstance(given, tuple) else given


def _each(given: tuple[Kilogram, ...] | Kilogram, cylinders: int) -> Kilogram:
    return each(gathered(given if isinstance(given, tuple) and len(given) == cylinders else (_one(given),) * cylinders))
