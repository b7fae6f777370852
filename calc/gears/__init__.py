# SPDX-License-Identifier: Apache-2.0
"""The gear train: geometry, measures, backlash, its place in the engine, profile, rating, and a search for shifts."""

from typing import TYPE_CHECKING

from ..sheet.offered import offer

if TYPE_CHECKING:
    from .formulas import centre_distance as centre_distance
    from .formulas import tip_diameter as tip_diameter
    from .formulas import transverse_contact_ratio as transverse_contact_ratio
    from .inputs import GearsInputs as GearsInputs
    from .measures.formulas import span as span
    from .rating.stress import contact_stress as contact_stress
    from .result import TrainResult as TrainResult
    from .solve import solve_pair as solve_pair

offer(globals())
