# SPDX-License-Identifier: Apache-2.0
"""The shaft's bending against ROSS (petrobras/ross), an independent rotor-dynamics program, on the worked example.

ROSS is no dependency of this program.  Into an environment of its own, then run from the root of the repository:

    python3 -m venv ROSS && ROSS/bin/pip install ross-rotordynamics 'plotly<6'
    ROSS/bin/python -m bench.beam_against_ross

ROSS knows round sections only.  From it come the matrices of each shaft element (shear after Cowper, no rotary
inertia), with the sector's second moment, area and shear factor put in place of the round ones; stiff springs stand for
the bearings, and the loads are put on the nodes of elements of 1 mm as forces.  Compared are slopes, reactions and
frequency."""

import math
import sys
from itertools import pairwise
from typing import Any

import numpy as np

from calc.countershaft.bending import shaft as b
from calc.countershaft.inputs import Extra
from calc.countershaft.outline import Outline, Piece, outline
from calc.library.catalogue import Material

MM = 1e-3
OMEGA = 2 * math.pi * 2600 / 60
STEEL = Material(name="steel", E=206e9, poisson=0.29, density=7860.0, expansion=12e-6)
POSITIONS = (-167.5 * MM, 167.5 * MM)
SPRING = 1e13  # N/m
ELEMENT = 1 * MM
SHARES = (1.0, 0.5, 0.25, 0.2, 1e-9)
#         from, to, outer radius, core radius of a sector of half a turn, its angle
EXAMPLE = (
    (-208.25, -196.25, 15.0, None, 0.0),
    (-196.25, -181.25, 26.95, None, 0.0),
    (-181.25, -153.75, 29.75, None, 0.0),
    (-153.75, -152.0, 15.0, None, 0.0),
    (-152.0, -1.0, 40.3, 15.0, math.pi),
    (-1.0, 1.0, 15.0, None, 0.0),
    (1.0, 152.0, 40.3, 15.0, 0.0),
    (152.0, 154.25, 15.0, None, 0.0),
    (154.25, 180.75, 40.5, None, 0.0),
)


def example() -> tuple[Outline, tuple[Extra, ...]]:
    pieces = tuple(
        Piece(
            a * MM,
            z * MM,
            R * MM,
            (core or 0.0) * MM,
            math.pi / 2 if core else None,
            angle,
            "sector" if core else "full",
        )
        for a, z, R, core, angle in EXAMPLE
    )
    hole = STEEL.density * math.pi / 4 * (12.13 * MM) ** 2 * 26.5 * MM
    extras = (
        Extra(name="hole", mass=-hole, radius=24 * MM, angle=math.pi, z=POSITIONS[1]),
        Extra(name="front", mass=1e-9, radius=hole * 24 * MM / 1e-9, angle=math.pi, z=-202.25 * MM),
    )
    return outline(pieces, False), extras


def by_ross(ross: Any, found: Outline, extras: tuple[Extra, ...], share: float) -> tuple[Any, Any, float]:
    """Slopes and reactions (real: the couple's plane) and lowest frequency [1/s] with the matrices of ROSS."""
    steel = ross.Material(name="example", rho=STEEL.density, E=STEEL.E, Poisson=STEEL.poisson)
    marks = np.unique(np.round([*found.each("start"), found.end, *POSITIONS, *(x.z for x in extras)], 9))
    nodes = np.unique(
        np.round(np.concatenate([np.linspace(a, z, math.ceil((z - a) / ELEMENT) + 1) for a, z in pairwise(marks)]), 9)
    )
    n = 2 * nodes.size
    K, M, f = np.zeros((n, n)), np.zeros((n, n)), np.zeros(n)
    for i, (a, z) in enumerate(pairwise(nodes)):
        k = int(np.searchsorted(found.each("start"), (a + z) / 2) - 1)
        piece, A, full = found.pieces[k], float(found.area[k]), float(found.inertia[k])
        core = math.pi * piece.core_radius**4 / 4 if piece.half_angle else full
        element = ross.ShaftElement(
            L=z - a,
            idl=0,
            odl=2 * piece.outer_radius,
            material=steel,
            shear_effects=True,
            rotary_inertia=False,
            gyroscopic=False,
        )
        I = core + share * (full - core)
        element.phi = 12 * STEEL.E * I / (steel.G_s * element.kappa * A * (z - a) ** 2)
        inertia, area = I / element.Ie, A / element.A  # the round section's of ROSS scaled to the true one's
        own = np.r_[0, 4, 6, 10]  # x and the turning about y of both ends, of six freedoms each
        at = slice(2 * i, 2 * i + 4)
        K[at, at] += _plane(element.K(), own) * inertia
        M[at, at] += _plane(element.M(), own) * area
        q = OMEGA**2 * STEEL.density * float(found.moment[k].real) * (z - a)
        f[2 * i] += q / 2
        f[2 * i + 2] += q / 2
    for x in extras:
        node = int(abs(nodes - x.z).argmin())
        f[2 * node] += OMEGA**2 * x.mass * x.radius * math.cos(x.angle)
        M[2 * node, 2 * node] += x.mass
    pins = [2 * int(abs(nodes - z).argmin()) for z in POSITIONS]
    K[pins, pins] += SPRING
    u = np.linalg.solve(K - OMEGA**2 * M, f)
    C = np.linalg.inv(np.linalg.cholesky(K))
    first = 1 / math.sqrt(np.linalg.eigvalsh(C @ M @ C.T)[-1]) / (2 * math.pi)
    return np.abs(u[[p + 1 for p in pins]]), np.abs(SPRING * u[pins]), first


def _plane(matrix: Any, own: Any) -> Any:
    return matrix[np.ix_(own, own)]


def main() -> None:
    try:
        import ross  # type: ignore[import-not-found]
    except ImportError as wrong:
        sys.exit(f"ROSS is not installed here ({wrong}). How to get it stands at the top of {__file__}.")
    found, extras = example()
    print(f"ROSS {ross.__version__}, elements of {ELEMENT * 1e3:g} mm, springs of {SPRING:g} N/m")
    names = ("slope front, mrad", "slope rear, mrad", "reaction front, N", "first frequency, Hz")
    print("share  " + "".join(f"{name:<30}" for name in names) + "(ours, ROSS, difference)")
    for share in SHARES:
        ours = b.bending(found, STEEL, OMEGA, POSITIONS, extras, share)
        slopes, reactions, first = by_ross(ross, found, extras, share)
        rows = (
            (ours.slopes[0] * 1e3, slopes[0] * 1e3),
            (ours.slopes[1] * 1e3, slopes[1] * 1e3),
            (abs(ours.reactions[0]), reactions[0]),
            (ours.natural_frequency, first),
        )
        print(f"{share:5.2f}  " + "  ".join(f"{a:<8.5g} {z:<8.5g} {100 * (a / z - 1):+.4f} %  " for a, z in rows))


if __name__ == "__main__":
    main()
