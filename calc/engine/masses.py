# SPDX-License-Identifier: Apache-2.0
"""The masses that move with a cylinder: by its piston and rod, or as they are given, one for all or one for each."""

from ..sheet.arrays import Array, each
from ..sheet.linked_array import gathered
from ..sheet.record import record
from ..sheet.units import Kilogram
from . import formulas as f
from .inputs import EngineInputs


@record
class UnlikeMasses:
    """The masses of each cylinder, (cylinders,), where they differ."""

    reciprocating: Array
    rotating: Array


def masses(engine: EngineInputs) -> tuple[Kilogram, Kilogram, UnlikeMasses | None]:
    """Reciprocating and rotating mass of a cylinder, and of each of them where they differ: the first two are then their means.

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
    if not engine.unlike:
        M_alt = f.given_reciprocating_mass(M_given=reciprocating[0]) if isinstance(reciprocating, tuple) else reciprocating
        by_rod = engine.rotating_masses is None and rod is not None
        M_rot = _one(rotating)
        return M_alt, M_rot if by_rod else f.given_rotating_mass(M_given=M_rot), None
    n = engine.cylinders
    every = UnlikeMasses(_each(reciprocating, n), _each(rotating, n))
    M_alt, M_rot = each(every.reciprocating), each(every.rotating)
    return f.mean_reciprocating_mass(M_k=M_alt, N=n), f.mean_rotating_mass(M_k=M_rot, N=n), every


def _one(given: tuple[Kilogram, ...] | Kilogram) -> Kilogram:
    """The mass of a cylinder of an engine whose cylinders are alike."""
    return given[0] if isinstance(given, tuple) else given


def _each(given: tuple[Kilogram, ...] | Kilogram, cylinders: int) -> Array:
    return gathered(given if isinstance(given, tuple) and len(given) == cylinders else (_one(given),) * cylinders)
