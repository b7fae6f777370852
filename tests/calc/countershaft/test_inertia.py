# SPDX-License-Identifier: Apache-2.0
"""The shaft's moment of inertia about its axis: a cylinder's own, a sector by quadrature, points."""

import math

import numpy as np
import pytest

from calc.countershaft.inputs import Extra
from calc.countershaft.outline import Piece, outline, turning_inertia

RHO = 7860.0


def piece(length, R, core=0.0, half=None):
    return Piece(0.0, length, R, core, half, 0.3, "full" if half is None else "sector")


def test_a_cylinder_has_half_its_mass_times_the_square_of_its_radius():
    mass = RHO * math.pi * 0.02**2 * 0.3
    assert turning_inertia(outline((piece(0.3, 0.02),), False), RHO, ()) == pytest.approx(mass * 0.02**2 / 2, rel=1e-12)


@pytest.mark.parametrize("half", [0.3, 1.2, 2.5])
def test_a_sector_on_its_core_by_quadrature(half):
    r = (np.arange(4000) + 0.5) / 4000 * 0.04
    wide = np.where(r < 0.015, 2 * math.pi, 2 * half)  # of the arc at each radius
    expected = RHO * 0.1 * np.sum(wide * r**3) * 0.04 / 4000
    assert turning_inertia(outline((piece(0.1, 0.04, 0.015, half),), False), RHO, ()) == pytest.approx(
        expected, rel=2e-3
    )


def test_an_element_counts_by_the_square_of_its_radius_and_a_hole_takes_away():
    bare = outline((piece(0.3, 0.02),), False)
    hole = Extra(name="hole", mass=-0.1, radius=0.03, angle=0.0, z=0.0)
    assert turning_inertia(bare, RHO, (hole,)) - turning_inertia(bare, RHO, ()) == pytest.approx(
        -0.1 * 0.03**2, rel=1e-9
    )
