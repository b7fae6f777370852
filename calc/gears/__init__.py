# SPDX-License-Identifier: Apache-2.0
"""The gear train: geometry, measures, backlash, its place in the engine, profile, and the rating of its teeth."""

from typing import TYPE_CHECKING

from ..sheet.lazy import lazy

__all__ = ["centre_distance", "contact_stress", "solve_pair", "span", "tip_diameter", "transverse_contact_ratio"]

if TYPE_CHECKING:
    from .public import centre_distance, contact_stress, solve_pair, span, tip_diameter, transverse_contact_ratio
else:
    __getattr__ = lazy(__name__, __all__)
