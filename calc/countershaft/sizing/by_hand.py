# SPDX-License-Identifier: Apache-2.0
"""The sizing of sectors from Python, in SI, its arguments held to the ranges of a design file."""

from ...library.catalogue import Material
from ...sheet.arguments import check_arguments, demand_numbers
from ...sheet.units import (
    KilogramPerMetre3,
    Metre,
    NewtonMetre,
    PhasorKilogramMetre,
    PhasorKilogramMetre2,
    RadPerSecond,
)
from ..inputs import ShaftInputs
from . import sectors, stretches


def size_sectors(
    C: NewtonMetre, omega: RadPerSecond, rho: KilogramPerMetre3, R: Metre, r_0: Metre, z_max: Metre, fillet: Metre = 0.0
) -> sectors.SectorPair:
    """Two equal sectors opposite each other that give the couple C [N·m] with the least mass.

    `omega`: speed of the shaft [rad/s]; `rho`: density [kg/m³]; `R`, `r_0`: outer radius and that of the core [m];
    `z_max`: from the middle to the outer face of a sector [m]; `fillet`: radius to the core [m].  Numbers alone.  A gap
    between them that does not hold two fillets is closed.  Raises TooSmall where the envelope can not hold them,
    BadInput where a size lies outside of the range that it has in a design file."""
    demand_numbers("size_sectors", C=C, omega=omega)
    _check("size_sectors", rho, R, r_0, z_max, fillet)
    return sectors.pair(C, omega, rho, R, r_0, z_max, fillet)


def size_stretches(
    U: PhasorKilogramMetre,
    P: PhasorKilogramMetre2,
    omega: RadPerSecond,
    rho: KilogramPerMetre3,
    R: Metre,
    r_0: Metre,
    where: tuple[tuple[Metre, Metre], ...],
    fillet: Metre = 0.0,
) -> stretches.SizedStretches:
    """The sectors that together have the unbalance U and the product of unbalance and position P.

    U = F/ω² [kg·m] and P = C/ω² [kg·m²], less what further elements do; `omega` [rad/s], `rho` [kg/m³], `R` and `r_0`,
    outer radius and that of the core [m]; `where`: the stretches, (from, to) [m], front to rear (`stretches`); a single
    one takes a pair about its own middle, and only for that `fillet` [m] counts.  Numbers alone.

    Raises TooSmall where the envelope can not hold them, NoSolution where nothing is asked, no stretch is left, or
    force and couple point different ways and there are more than two; BadInput as `size_sectors`."""
    ends = {f"where[{n}][{i}]": z for n, stretch in enumerate(where) for i, z in enumerate(stretch)}
    demand_numbers("size_stretches", U=U, P=P, omega=omega, **ends)
    farthest = max((abs(z) for stretch in where for z in stretch), default=None)
    _check("size_stretches", rho, R, r_0, farthest, fillet)
    return stretches.size_stretches(U, P, omega, rho, R, r_0, where, fillet)


def _check(call: str, rho: float, R: float, r_0: float, z_max: float | None, fillet: float) -> None:
    demand_numbers(call, rho=rho, R=R, r_0=r_0, z_max=z_max, fillet=fillet)
    check_arguments(
        call,
        rho=(Material.density, rho),
        R=(ShaftInputs.outer_radius, R),
        r_0=(ShaftInputs.core_radius, r_0),
        z_max=(ShaftInputs.half_length, z_max),
        fillet=(ShaftInputs.fillet_radius, fillet or None),
    )
