# SPDX-License-Identifier: Apache-2.0
"""What a crank throw is described by."""

from ..sheet.quantity import inputs, quantity, text


@inputs
class ThrowInputs:
    """One throw of the crank between its two main journals; all throws have the same.  Pin and journals are solid and round."""

    pin_diameter: float = quantity(
        "Crankpin diameter", "mm", above=0, high=1000, symbol="d_p", help="Diameter of the crankpin, solid and round."
    )
    pin_length: float = quantity("Crankpin length", "mm", above=0, high=1000, symbol="l_p", help="Length of the crankpin between the webs.")
    journal_diameter: float = quantity(
        "Main journal diameter", "mm", above=0, high=1000, symbol="d_j", help="Diameter of the main journals, solid and round."
    )
    journal_length: float = quantity(
        "Main journal length", "mm", above=0, high=1000, symbol="l_j", help="Length of a main journal between the webs of two throws."
    )
    web_thickness: float = quantity(
        "Web thickness", "mm", above=0, high=1000, symbol="t_w", help="Thickness of a web along the crank axis."
    )
    fillet_radius: float | None = quantity(
        "Fillet radius", "mm", default=None, above=0, high=500, symbol="rho",
        help="Radius from pin and journal to the web. Left out: no notch stress.",
    )  # fmt: skip
    material: str = text("Material", help="A name from the table of materials or from [[material]]; its proof stress is the limit.")
