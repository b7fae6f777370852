# SPDX-License-Identifier: Apache-2.0
"""What a film is asked and what it answers: the seat, the duty, the film.

Every number may be an array (many bearings, corners, speeds at once); then the film's are, with nan where there is none.
"""

from ...lubricant import Lubricant, State
from ...sheet.record import record
from .. import formulas as f
from ..inputs import BearingInputs, BearingsInputs


@record
class Seat:
    """One bearing with all that decides its film but speed, load and supply."""

    bearing: BearingInputs
    inputs: BearingsInputs
    lubricant: Lubricant
    clearance: float  # at the reference temperature
    journal_expansion: float
    housing_expansion: float
    viscosity_factor: float | None = None  # on the oil's viscosity, at a corner of its tolerance

    def clearance_at(self, T: float) -> float:
        return f.clearance_at(
            g=self.clearance, d=self.bearing.diameter, alpha_H=self.housing_expansion, chi=self.inputs.expansion_restraint,
            alpha_J=self.journal_expansion, T=T, T_ref=self.inputs.clearance_reference_temperature,
        )  # fmt: skip

    def oil_at(self, T: float) -> State:
        oil = self.lubricant.at(T)
        if self.viscosity_factor is None:
            return oil
        return State(oil.nu * self.viscosity_factor, f.viscosity_at_corner(mu=oil.mu, k=self.viscosity_factor), oil.rho, oil.cp)


@record
class Duty:
    """What a bearing has to do at one moment: load, journal speed, hydrodynamic speed and sliding speed over it, oil supply."""

    load: float
    speed: float
    effective_speed: float
    sliding_ratio: float
    supply_temperature: float
    supply_pressure: float


@record
class Film:
    """The state of a film, and the temperature rise that its friction and its flow make."""

    clearance: float
    relative_clearance: float
    specific_load: float
    sommerfeld: float
    eccentricity: float
    film: float
    friction_coefficient: float
    friction_variable: float
    friction_power: float
    oil_flow: float
    temperature_rise: float
    mean_temperature: float
    oil: State
    attitude: float | None = None
    largest_pressure: float | None = None
    side_flow: float | None = None
    supply_flow: float | None = None


class Seized(ValueError):
    """The journal has no clearance left at this temperature."""


class OutsideBalance(ValueError):
    """The heat of the film is not carried away at any temperature that is looked at.  `end`: what ends the film above, if it ends."""

    def __init__(self, words: str, end: ValueError | None = None) -> None:
        super().__init__(words)
        self.end = end
