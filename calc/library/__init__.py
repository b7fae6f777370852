# SPDX-License-Identifier: Apache-2.0
"""What a designer looks up: oils, materials, publications, fits, fatigue, contact, and the tables they stand in."""

from typing import TYPE_CHECKING

from ..sheet.offered import offer

if TYPE_CHECKING:
    from .catalogue import Material as Material
    from .catalogue import Oil as Oil
    from .catalogue import shipped_materials as shipped_materials
    from .catalogue import shipped_oils as shipped_oils

offer(globals())
