# SPDX-License-Identifier: Apache-2.0
"""What a crank throw is described by."""

from ..sheet.quantity import THUMB, inputs, quantity, text


@inputs
class ThrowInputs:
    """One throw of the crank between its two main journals; all throws have the same.  Pin and journals are solid and round."""

    pin_diameter: float = quantity(
        "Crankpin diameter",
        "mm",
        above=0,
        high=1000,
        symbol="d_p",
        usual=(20, 120),
        source=THUMB,
        help="Diameter of the crankpin, solid and round.",
    )
    pin_length: float = quantity(
        "Crankpin length",
        "mm",
        above=0,
        high=1000,
        symbol="l_p",
        usual=(12, 90),
        source=THUMB,
        help="Length of the crankpin between the webs.",
    )
    journal_diameter: float = quantity(
        "Main journal diameter",
        "mm",
        above=0,
        high=1000,
        symbol="d_j",
        usual=(20, 140),
        source=THUMB,
        help="Diameter of the main journals, solid and round.",
    )
    journal_length: float = quantity(
        "Main journal length",
        "mm",
        above=0,
        high=1000,
        symbol="l_j",
        usual=(12, 90),
        source=THUMB,
        help="Length of a main journal between the webs of two throws.",
    )
    web_thickness: float = quantity(
        "Web thickness",
        "mm",
        above=0,
        high=1000,
        symbol="t_w",
        usual=(6, 60),
        source=THUMB,
        help="Thickness of a web along the crank axis.",
    )
    fillet_radius: float | None = quantity(
        "Fillet radius", "mm", default=None, above=0, high=500, symbol="rho", usual=(1, 8), source=THUMB,
        help="Radius from pin and journal to the web. Left out: no notch stress.",
    )  # fmt: skip
    material: str = text("Material", help="A name from the table of materials or from [[material]]; its proof stress is the limit.")
