# SPDX-License-Identifier: Apache-2.0
"""Transfer functions: how every point moves under unit forces and moments at the engine's centre of gravity, over frequency."""

import math

import numpy as np

from ..sheet.arrays import Array, ComplexArray
from .result import MountingResult
from .system import moves, respond_at

LOWEST, HIGHEST, STEP = 0.5, 200.0, 0.5  # Hz
DRIVES = ("F_x [N]", "F_y [N]", "F_z [N]", "M_x [N·m]", "M_y [N·m]", "M_z [N·m]")


def transfer_functions(result: MountingResult, f: Array) -> ComplexArray:
    """Displacement over wrench (frequencies, points, 3 axes, 6 components of the wrench), in m."""
    unit = np.broadcast_to(np.eye(6, dtype=complex), (len(f), 6, 6))
    q = respond_at(result.system, 2 * math.pi * np.asarray(f), unit)  # (frequencies, components, coordinates)
    P = np.stack([moves(result.system, point) for point in result.system.mounting.points])
    found: ComplexArray = np.einsum("pac,fwc->fpaw", P, q)
    return found


def rows(result: MountingResult) -> tuple[tuple[str, ...], list[list[float]]]:
    """Header and rows of a file: frequency, then real and imaginary part of each function, in mm."""
    f = np.arange(LOWEST, HIGHEST + STEP / 2, STEP)
    names = [f"{point.name}.{axis} [mm] / {drive}" for point in result.system.mounting.points for axis in "xyz" for drive in DRIVES]
    header = ("frequency [Hz]", *(f"{name} {part}" for name in names for part in ("re", "im")))
    H = transfer_functions(result, f).reshape(f.size, -1) * 1e3
    both = np.stack([H.real, H.imag], -1).reshape(f.size, -1)
    return header, np.column_stack([f, both]).tolist()
