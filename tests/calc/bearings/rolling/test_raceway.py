# SPDX-License-Identifier: Apache-2.0
"""What a raceway on the shaft has to be, and slopes."""

import math

import numpy as np
import pytest

from calc.bearings.rolling import raceway as r


def test_the_case_is_as_deep_as_the_needles_ask_and_never_thinner_than_0_3_mm():
    assert r.case_depth_needed(D_w=2.5e-3) == 0.3e-3 and r.case_depth_needed(D_w=10e-3) == pytest.approx(0.78e-3)
    assert r.case_depth_needed(D_w=np.array([2.5e-3, 10e-3])) == pytest.approx([0.3e-3, 0.78e-3])


def test_what_makers_ask_of_a_raceway():
    """58 HRC, which is 670 HV; ground to Ra 0.2 µm."""
    assert (r.HARDNESS, r.ROUGHNESS) == (670.0, 0.2e-6)


def test_roundness_is_that_of_it3():
    """ISO 286-1, Table 1: 3 µm up to 18, 4 µm up to 50 mm."""
    assert [r.roundness_needed(x) for x in (0.015, 0.025, 0.06)] == pytest.approx([3e-6, 4e-6, 5e-6])


@pytest.mark.parametrize(
    "type, series, minutes",
    [
        ("ball", "62", 10), ("ball", "own", 10), ("roller", "2", 4), ("roller", "10", 4), ("roller", "own", 4),
        ("roller", "22", 3), ("roller", "23", 3), ("needle", "NA49", 1), ("cup", "HK", 1), ("cage", "K", 1),
    ],
)  # fmt: skip
def test_slopes_in_minutes_of_arc(type, series, minutes):
    assert r.largest_slope(type, series) == pytest.approx(math.radians(minutes / 60), rel=0.01)
