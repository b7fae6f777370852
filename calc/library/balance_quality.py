# SPDX-License-Identifier: Apache-2.0
"""Balance quality grades of ISO 21940-11, and the residual unbalance that one permits a rigid rotor."""

from ..sheet.formula import formula
from ..sheet.text import Text
from ..sheet.units import Kilogram, KilogramMetre, MetrePerSecond, RadPerSecond

ISO = Text("ISO 21940-11")
GRADES = ("G0.4", "G1", "G2.5", "G6.3", "G16", "G40", "G100", "G250", "G630", "G1600", "G4000")


@formula(
    "U_per", Text("{iso}: permissible residual unbalance, from G = e_per·ω", iso=ISO), unit="g·mm", names={"G": "G_Q"}
)
def permitted_unbalance(G: MetrePerSecond, m_S: Kilogram, omega: RadPerSecond) -> KilogramMetre:
    """>>> permitted_unbalance(G=0.0063, m_S=9.034, omega=272.3)
    0.0002090128...
    """
    return G * m_S / omega


@formula("G_Q", Text("{iso}: balance quality grade, e_per·ω", iso=ISO), shows="number of the grade, in mm/s")
def grade_number(grade: str) -> MetrePerSecond:
    """G of a grade: "G6.3" is 6.3 mm/s."""
    return float(grade[1:]) / 1000
