# SPDX-License-Identifier: Apache-2.0
"""What a film is asked and what it answers: the seat, the duty, the film.

Every number may be an array (many bearings, corners, speeds at once), which `[Any]` says; then the film's are, with nan
where there is none."""

from typing import Any, Generic

from ....countershaft.rows import BearingRow
from ....library.lubricant import Lubricant, OilState
from ....sheet.arrays import Value
from ....sheet.quantity import result, value
from ....sheet.record import record, replace
from ....sheet.shown import Shown
from ....sheet.value import based_on
from ...inputs import BearingsInputs
from ...support import OperatingPoint as OperatingPoint
from .. import formulas as f
from ..film.grooved import Feed, Feeds
from ..seats import formulas as seats
from ..seats.rings import Rings
from ..seats.stack import SeatStack


@record
class BearingCase(Generic[Value]):
    """One bearing with all that decides its film but speed, load and supply."""

    bearing: BearingRow
    inputs: BearingsInputs
    lubricant: Lubricant
    clearance: Value  # at the reference temperature
    journal_expansion: float
    housing_expansion: float
    viscosity_factor: Value | None = None  # on the oil's viscosity, at a corner of its tolerance
    stack: SeatStack | None = None  # the parts that make its clearance; None: it is given otherwise
    rings: Rings | None = None  # what is pressed into its housing
    centred: bool = False  # it carries next to nothing: its film is the thickest of the table, whatever the load

    @property
    def grooves(self) -> Feeds | None:
        """The axial grooves that bound the film, by the sizes of this bearing; None where it has none."""
        i, b = self.inputs, self.bearing
        if (
            i.supply != "axial_groove"
            or i.axial_groove_angles is None
            or i.axial_groove_width is None
            or i.axial_groove_length is None
        ):
            return None
        arc, share = 2 * i.axial_groove_width / b.diameter, i.axial_groove_length / b.length
        return Feeds(tuple(Feed(float(angle), float(arc), float(share)) for angle in i.axial_groove_angles))

    def clearance_at(self, T: Any) -> Any:
        """All at one temperature."""
        return self._clearance(T, T)

    def running_clearance(self, T: Any) -> Any:
        """With film, journal and bush at a temperature, and the housing at its own where that is given."""
        T_H = self.inputs.housing_temperature
        return self._clearance(T, T if T_H is None else T_H)

    def _clearance(self, T: Any, T_H: Any) -> Any:
        inputs, d = self.inputs, self.bearing.diameter
        T_ref = inputs.clearance_reference_temperature
        if self.rings is not None:
            return self.rings.clearance_at(d, self.clearance, self.journal_expansion, T, T_H)
        if self.stack is not None:
            d_J = based_on((self.stack.journal[0] + self.stack.journal[1]) / 2, self.stack.journal)
            d_iT = seats.own_bore_at(
                d_i=based_on(d_J + self.clearance, d_J, self.clearance),
                alpha_H=self.housing_expansion,
                chi=inputs.expansion_restraint,
                T=T,
                T_ref=T_ref,
            )
            return seats.clearance_in(d_iT=d_iT, d_J=d_J, alpha_J=self.journal_expansion, T=T, T_ref=T_ref)
        return f.clearance_at(
            g=self.clearance,
            d=d,
            alpha_H=self.housing_expansion,
            chi=inputs.expansion_restraint,
            alpha_J=self.journal_expansion,
            T=T,
            T_ref=T_ref,
        )

    def oil_at(self, T: Any) -> OilState[Any]:
        oil = self.lubricant.at(T)
        if self.viscosity_factor is None:
            return oil
        return OilState(
            oil.nu * self.viscosity_factor, f.viscosity_at_corner(mu=oil.mu, k=self.viscosity_factor), oil.rho, oil.cp
        )


def resized(seat: BearingCase[Any], **sizes: Any) -> BearingCase[Any]:
    """The case of a bearing of another `diameter` or `length`, a number or an array of them."""
    return replace(seat, bearing=replace(seat.bearing, **sizes))


@result
class Film(Shown, Generic[Value]):
    """The state of a film, and the temperature rise that its friction and its flow make.  `clearance`: at which it
    runs."""

    clearance: Value = value("Clearance (diametral)", "µm", "g")
    relative_clearance: Value = value("Relative clearance", "‰", "ψ")
    specific_load: Value = value("Specific load", "MPa", "p")
    sommerfeld: Value = value("Sommerfeld number (S; ISO, Falz: So)", "", "S")
    eccentricity: Value = value("Eccentricity ratio", "", "ε")
    film: Value = value("Smallest film", "µm", "h_0", headline=1)
    friction_coefficient: Value = value("Coefficient of friction", "", "f")
    friction_variable: Value = value("Friction variable", "", "f*")
    friction_power: Value = value("Friction power", "W", "P_f")
    oil_flow: Value = value("Oil flow", "L/min", "Q")
    temperature_rise: Value = value("Temperature rise", "K", "ΔT")
    mean_temperature: Value = value("Mean temperature of the film", "°C", "T_m")
    oil: OilState[Value]
    attitude: Value | None = value("Attitude angle", "°", "φ", default=None)
    largest_pressure: Value | None = value("Largest film pressure", "MPa", "p_max", default=None)
    side_flow: Value | None = value("of it carried out by the turning film", "L/min", "Q_1", default=None)
    supply_flow: Value | None = value("of it driven by the supply pressure", "L/min", "Q_2", default=None)


class Seized(ValueError):
    """The journal has no clearance left at this temperature."""


class OutsideCharts(ValueError):
    """The point lies outside what a published method shows."""


class OutsideBalance(ValueError):
    """The heat of the film is not carried away at any temperature that is looked at.  `end`: what ends the film above,
    if it ends."""

    def __init__(self, words: str, end: ValueError | None = None) -> None:
        super().__init__(words)
        self.end = end
