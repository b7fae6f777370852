# SPDX-License-Identifier: Apache-2.0
"""The stresses of the bent shaft: nominal in each piece, and at the fillet of the shoulder that governs.

The bending moment turns with the shaft, so that these stresses stand still in it.
"""

from collections import Counter
from itertools import pairwise

import numpy as np

from ... import notch
from ...sheet.arrays import Array, each, many
from ...sheet.linked_array import column, gathered, item, where
from ...sheet.text import Amount, Text
from ...sheet.trace import about, untraced
from ...sheet.units import Metre, NewtonMetre
from ...sheet.value import based_on
from .. import sector as s
from ..outline import Outline
from . import formulas as f
from .beam import Bent

STEP = 1e-6  # m: radii that differ by less make no shoulder


def stresses(outline: Outline, bent: Bent, M_max: NewtonMetre, fillet: Metre | None) -> tuple[dict[str, float], tuple[Text, ...]]:
    """Nominal stresses of the pieces, and the shoulder whose fillet is stressed most; notes on it."""
    c: Array = column(outline.pieces, "outer_radius")
    sector = np.array([p.half_angle is not None for p in outline.pieces])
    if sector.any():
        R, r_0 = (column(outline.pieces, name)[sector] for name in ("outer_radius", "core_radius"))
        gamma = each(gathered(p.half_angle for p in outline.pieces if p.half_angle is not None))
        S = based_on(np.abs(outline.moment[sector]), outline.moment[sector])
        A = outline.area[sector]
        c = where(sector, f.farthest_fibre(R=R, y=s.whole_centre(S=S, A_tot=A), r_0=r_0, gamma=gamma), c[~sector])
    start, end = column(outline.pieces, "start"), column(outline.pieces, "end")
    I = outline.inertia
    M = f.piece_moments(z_1=start, z_2=end, u=bent)
    stress = many(f.bending_stress(M=M, c=each(c), I=each(I)))
    k, size = int(stress.argmax()), np.abs(bent.moment)
    z_M = f.moment_place(u=bent)
    here = [i for i in range(start.size) if start[i] - STEP <= z_M <= end[i] + STEP]
    i = max(here, key=lambda i: float(c[i] / I[i]))
    own = np.flatnonzero((bent.moment_z >= start[k] - STEP) & (bent.moment_z <= end[k] + STEP))
    known = dict(largest_moment_z=z_M, stress_at_largest_moment=f.bending_stress(M=M_max, c=item(c[i]), I=item(I[i])),
        bending_stress=item(stress[k]), bending_stress_z=based_on(float(bent.moment_z[own[size[own].argmax()]]), bent))  # fmt: skip
    notch_of, notes = ({}, ()) if fillet is None else _notch(outline, bent, c, fillet)
    return known | notch_of, notes


def _notch(outline: Outline, bent: Bent, c: Array, r: Metre) -> tuple[dict[str, float], tuple[Text, ...]]:
    """The shoulder with the largest stress at its fillet: the round one from the larger diameter down to that of the weaker section.

    A sector counts there with its core, at whose back its shoulder to a full section lies; of two sectors on one core, with its edge.
    Shoulders lower than a tenth of the fillet, where the fit ends, are left out and said.
    """
    shoulders = []
    low = 0
    for i, k in pairwise(range(len(outline.pieces))):
        weak = min(i, k, key=lambda n: float(outline.inertia[n]))
        piece, other = outline.pieces[weak], outline.pieces[i + k - weak]
        at_core = piece.half_angle is not None and 0 < piece.core_radius != (other.core_radius if other.half_angle is not None else 0.0)
        d = 2 * (piece.core_radius if at_core else piece.outer_radius)
        D = 2 * max(piece.outer_radius, other.outer_radius)
        d, D = based_on(d, piece.core_radius if at_core else piece.outer_radius), based_on(D, piece.outer_radius, other.outer_radius)
        if D - d < 2 * STEP or (piece.half_angle, piece.core_radius, piece.outer_radius) == (
            other.half_angle, other.core_radius, other.outer_radius
        ):  # fmt: skip
            continue
        if (D - d) / (2 * r) < notch.FIT[0]:
            low += 1
            continue
        shoulders.append((piece.start if weak == k else piece.end, weak, D, d))
    notes: tuple[Text, ...] = (Text("Notch stress: the shoulder of a sector is taken as a round one."),) if shoulders else ()
    if low:
        notes += (
            Text("Notch stress: {low} of the shoulders lower than a tenth of the fillet radius left out: the fit ends there.", low=low),
        )
    if not shoulders:
        return {}, notes

    carried = Counter(weak for _, weak, *_ in shoulders)
    room = min(outline.pieces[weak].length / times for weak, times in carried.items())

    def stressed(shoulder: tuple[Metre, int, Metre, Metre]) -> dict[str, float]:
        z, weak, D, d = shoulder
        sigma = f.bending_stress(M=f.shoulder_moment(z=z, u=bent), c=item(c[weak]), I=item(outline.inertia[weak]))
        x, K_t = notch.shoulder_bending(D=D, d=d, r=r)
        return dict(notch_z=z, notch_factor=K_t, notch_stress=notch.notch_stress(K_t=K_t, sigma=sigma), step_over_fillet=x)

    with untraced():
        governs = max(shoulders, key=lambda shoulder: stressed(shoulder)["notch_stress"])
    with about(Text("shoulder at {governs} mm", governs=Amount(governs[0] * 1000.0))):
        z, weak, D, d = governs
        governs = based_on(z, z, bent), weak, based_on(D, D, bent), based_on(d, d, bent)
        return {**stressed(governs), "fillet": r, "fillet_room": room}, notes
