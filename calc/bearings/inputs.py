# SPDX-License-Identifier: Apache-2.0
"""The two plain bearings, their oil and its supply."""

from collections.abc import Iterable

from ..sheet.quantity import choice, inputs, quantity, series, table, text


@inputs
class BearingInputs:
    """One journal in its seat."""

    diameter: float = quantity("Journal diameter", "mm", above=0, high=1000, symbol="d", step=0.5)
    length: float = quantity(
        "Length",
        "mm",
        above=0,
        high=1000,
        symbol="l",
        step=0.5,
        help="Usual l/d 0.25 to 0.75. More length: lower specific load, thicker film.",
    )
    clearance: float = quantity(
        "Clearance (diametral)", "µm", optional=True, low=0.1, high=5000, symbol="g", step=1,
        help="Bore minus journal at the reference temperature; usual 1 to 1.5 ‰ of d. Left out: from the clearance factor.",
    )  # fmt: skip
    clearance_factor: float = quantity(
        "Clearance factor K",
        optional=True,
        low=0.01,
        high=10,
        usual=(0.4, 0.8),
        symbol="K",
        step=0.05,
        help="g = K·d·u^¼ in mm, m and m/s; 0.4 to 0.8.",
    )
    journal_roughness: float = quantity("Roughness Ra, journal", "µm", low=0, high=50, symbol="Ra_1", step=0.1)
    housing_roughness: float = quantity("Roughness Ra, seat", "µm", low=0, high=50, symbol="Ra_2", step=0.1)

    def problems(self) -> Iterable[tuple[str, str]]:
        if (self.clearance is None) == (self.clearance_factor is None):
            yield "clearance_um", "give either clearance_um or clearance_factor, one of the two"
        if self.clearance is not None and self.clearance >= 0.1 * self.diameter:
            yield "clearance_um", "must stay below a tenth of the diameter"


@inputs
class BearingsInputs:
    """Oil, supply and temperatures of both bearings, and the bearings."""

    oil: str = text("Oil", help="A name from the table of oils or from [[oil]].")
    supply_temperature: float = quantity(
        "Supply temperature", "°C", low=-40, high=200, symbol="T_in", step=1, help="In the gallery before the bearing."
    )
    supply_pressure: float = quantity("Supply pressure", "bar", low=0, high=100, symbol="p_s", step=0.1, help="Above ambient.")
    supply: str = choice(
        "Oil supply",
        "hole",
        "groove",
        "pocket",
        "shaft",
        help="hole, groove, pocket: in the seat. shaft: through holes in the journal, turning with the load.",
    )
    hole_diameter: float = quantity("Oil hole diameter", "mm", optional=True, low=0.1, high=200, symbol="d_H")
    groove_width: float = quantity("Groove width", "mm", optional=True, low=0, high=500, symbol="b_G")
    pocket_width: float = quantity("Pocket width", "mm", optional=True, low=0.1, high=500, symbol="b_P", help="Along the shaft.")
    pocket_length: float = quantity(
        "Pocket length", "mm", optional=True, low=0.1, high=500, symbol="l_P", help="Around the seat; the flow does not ask for it."
    )
    expansion_restraint: float = quantity(
        "Expansion held back",
        default=0.0,
        low=0,
        high=1,
        symbol="chi",
        step=0.05,
        help="Share of the housing's thermal expansion that the block holds back.",
    )
    housing_material: str = text("Housing material", help="A name from the table of materials or from [[material]].")
    clearance_reference_temperature: float = quantity("Clearance given at", "°C", default=20.0, low=-60, high=250, symbol="T_ref")
    lowest_temperature: float = quantity(
        "Lowest temperature", "°C", default=-20.0, low=-60, high=60, symbol="T_low", help="Cold start: the clearance must still be there."
    )
    outlet_temperature_limit: float = quantity(
        "Outlet temperature limit", "°C", default=135.0, low=50, high=250, symbol="T_lim", help="Trumpler allows 121 °C."
    )
    roughness_ratio: float = quantity(
        "Rt/Ra", default=7.5, low=1, high=30, symbol="k_R", help="Peak-to-valley over mean roughness; 6 to 7.5."
    )
    viscosity_law: str = choice(
        "Viscosity law", "walther", "d341", default="walther", help="walther: ν + 0.6, as in the source. d341: ν + 0.7, ASTM D341."
    )
    slope: tuple[float, ...] | None = series(
        "Slope of the journals", "mrad", optional=True, count=(1, 2), low=0, high=20, symbol="theta",
        help="One for both, or [front, rear]. Left out: that of the counter-shaft's bending; where it is not known zero.",
    )  # fmt: skip
    front: BearingInputs = table("Front bearing", BearingInputs)
    rear: BearingInputs = table("Rear bearing", BearingInputs)

    def problems(self) -> Iterable[tuple[str, str]]:
        needs = {
            "hole": ("hole_diameter",),
            "shaft": ("hole_diameter",),
            "groove": ("groove_width",),
            "pocket": ("pocket_width",),
        }
        for name in needs[self.supply]:
            if getattr(self, name) is None:
                yield f"{name}_mm", f'needed with supply = "{self.supply}"'
        for place, bearing in (("front", self.front), ("rear", self.rear)):
            for name in ("hole_diameter", "groove_width", "pocket_width"):
                width = getattr(self, name)
                if width is not None and width >= bearing.length:
                    yield f"{name}_mm", f"must be smaller than the length of the {place} bearing"
