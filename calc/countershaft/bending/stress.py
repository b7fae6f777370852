# SPDX-License-Identifier: Apache-2.0
"""The stresses of the bent shaft: nominal in each piece, and at the fillet of the shoulder that governs.

The bending moment turns with the shaft, so that these stresses stand still in it.
"""

from collections import Counter
from itertools import pairwise
from typing import Any

import numpy as np

from ... import notch
from ...sheet.number import short
from ...sheet.trace import about, untraced
from ...sheet.units import Metre, NewtonMetre
from .. import sector as s
from ..outline import Outline
from . import formulas as f
from .beam import Bent

STEP = 1e-6  # m: radii that differ by less make no shoulder


def stresses(found: Outline, bent: Bent, M_max: NewtonMetre, fillet: Metre | None) -> dict[str, Any]:
    """Nominal stresses of the pieces, and the shoulder whose fillet is stressed most."""
    c: Any = found.each("outer_radius").astype(float)
    sector = np.array([p.half_angle is not None for p in found.pieces])
    if sector.any():
        R, r_0, gamma = (found.each(name)[sector].astype(float) for name in ("outer_radius", "core_radius", "half_angle"))
        S: Any = np.abs(found.moment[sector])
        A: Any = found.area[sector]
        c[sector] = f.farthest_fibre(R=R, y=s.whole_centre(S=S, A_tot=A), r_0=r_0, gamma=gamma)
    start, end = found.each("start"), found.each("end")
    I: Any = found.inertia
    M: Any = f.piece_moments(z_1=start, z_2=end, u=bent)
    stress: Any = f.bending_stress(M=M, c=c, I=I)
    k, size = int(stress.argmax()), np.abs(bent.moment)
    z_M = f.moment_place(u=bent)
    here = [i for i in range(start.size) if start[i] - STEP <= z_M <= end[i] + STEP]
    i = max(here, key=lambda i: float(c[i] / I[i]))
    own = np.flatnonzero((bent.moment_z >= start[k] - STEP) & (bent.moment_z <= end[k] + STEP))
    known: dict[str, Any] = dict(
        largest_moment_z=z_M, stress_at_largest_moment=f.bending_stress(M=M_max, c=float(c[i]), I=float(I[i])),
        bending_stress=float(stress[k]), bending_stress_z=float(bent.moment_z[own[size[own].argmax()]]),
    )  # fmt: skip
    return known if fillet is None else {**known, **_notch(found, bent, c, fillet)}


def _notch(found: Outline, bent: Bent, c: Any, r: Metre) -> dict[str, Any]:
    """The shoulder with the largest stress at its fillet: the round one from the larger diameter down to that of the weaker section.

    A sector counts there with its core, at whose back its shoulder to a full section lies; of two sectors on one core, with its edge.
    Shoulders lower than a tenth of the fillet, where the fit ends, are left out and said.
    """
    shoulders = []
    low = 0
    for i, k in pairwise(range(len(found.pieces))):
        weak = min(i, k, key=lambda n: float(found.inertia[n]))
        piece, other = found.pieces[weak], found.pieces[i + k - weak]
        at_core = piece.half_angle is not None and 0 < piece.core_radius != (other.core_radius if other.half_angle is not None else 0.0)
        d = 2 * (piece.core_radius if at_core else piece.outer_radius)
        D = 2 * max(piece.outer_radius, other.outer_radius)
        if D - d < 2 * STEP or (piece.half_angle, piece.core_radius, piece.outer_radius) == (
            other.half_angle, other.core_radius, other.outer_radius
        ):  # fmt: skip
            continue
        if (D - d) / (2 * r) < notch.FIT[0]:
            low += 1
            continue
        shoulders.append((piece.start if weak == k else piece.end, weak, D, d))
    notes: tuple[str, ...] = ("Notch stress: the shoulder of a sector is taken as a round one.",) if shoulders else ()
    if low:
        notes += (f"Notch stress: {low} of the shoulders lower than a tenth of the fillet radius left out: the fit ends there.",)
    if not shoulders:
        return dict(notes=notes)

    carried = Counter(weak for _, weak, *_ in shoulders)
    room = min(found.pieces[weak].length / times for weak, times in carried.items())

    def stressed(shoulder: tuple[Metre, int, Metre, Metre]) -> dict[str, Any]:
        z, weak, D, d = shoulder
        sigma = f.bending_stress(M=f.shoulder_moment(z=z, u=bent), c=float(c[weak]), I=float(found.inertia[weak]))
        x, K_t = notch.shoulder_bending(D=D, d=d, r=r)
        return dict(notch_z=z, notch_factor=K_t, notch_stress=notch.notch_stress(K_t=K_t, sigma=sigma), step_over_fillet=x)

    with untraced():
        governs = max(shoulders, key=lambda shoulder: float(stressed(shoulder)["notch_stress"]))
    with about(f"shoulder at {short(governs[0] * 1e3)} mm"):
        return {**stressed(governs), "fillet": r, "fillet_room": room, "notes": notes}
