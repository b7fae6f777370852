# SPDX-License-Identifier: Apache-2.0
"""A rolling bearing before and under its load: what its shaft, the power balance and a report ask of any bearing."""

from collections.abc import Iterator
from typing import Any, Self

import numpy as np

from ...countershaft.bending.carried import AnyLaw, Rigid
from ...countershaft.rows import BearingRow, called
from ...library.lubricant import Lubricant, OilState
from ...sheet.arrays import Array, BoolArray
from ...sheet.check import Check
from ...sheet.quantity import result
from ...sheet.record import record, replace
from ...sheet.text import Amount, Text
from ...sheet.units import Celsius, Kilogram, Metre, Newton, NewtonPerMetre, Number, Radian, RevPerSecond, Second
from ...sheet.value import about, based_on, untraced
from ..support import Carrying, OnShaftResult, OperatingPoint, StandingLoads, Task, by_row
from .checks import of_one, rolling_checks
from .contact import Springs
from .load import friction_mean_of
from .raceway import largest_slope
from .result import RollingResult
from .solve import LoadedBearing, RollingCase, solve
from .zone import EXPONENTS


@record
class RollingSupport:
    """A rolling bearing before its load is known."""

    case: RollingCase

    @property
    def row(self) -> BearingRow:
        return self.case.row

    def _law(self, T_b: Celsius) -> AnyLaw:
        gap = self.case.clearances(T_b)
        springs = self.case.springs(0.0 if gap is None else gap.running)
        return Rigid() if springs is None else springs

    def law(self, duty: OperatingPoint[Any], sense: int) -> AnyLaw:
        return self._law(duty.supply_temperature)

    def warm_law(self, duty: OperatingPoint[Any], supplied: AnyLaw, before: AnyLaw, sense: int) -> AnyLaw:
        return self._law(self.case.warm(duty.load, duty.speed, duty.supply_temperature).temperature)

    def told_law(self, law: AnyLaw, duty: OperatingPoint[Any]) -> AnyLaw:
        if not isinstance(law, Springs):
            return law
        return replace(law, gap=based_on(law.gap, self.row.size, duty.supply_temperature))

    def centred_under(self, duty: OperatingPoint[Any]) -> bool:
        return False

    def as_centred(self) -> "RollingSupport":
        return self

    def solved(self, load: Newton, slope: Radian | None, share: Array | None, task: Task) -> "RollingBearing":
        stands = self.row.standing_load or 0.0
        return judged(self.case, load, StandingLoads(stands, stands, 0.0), slope, task)


@record
class RollingAnswer:
    """How the friction answers to a standing load: solved anew with it."""

    case: RollingCase
    load: Any
    speed: Any
    oil_temperature: Any

    @property
    def unsteady(self) -> bool:
        return False

    @property
    def friction_power(self) -> Any:
        with untraced():
            return self.under(0.0)

    def under(self, R_0: Any) -> Any:
        F = friction_mean_of(self.load, R_0 + 0.0 * self.load)
        return self.case.warm(F, self.speed, self.oil_temperature).loss

    def only(self, some: BoolArray) -> "RollingAnswer":
        parts = (x[some] if np.ndim(x) else x for x in (self.load, self.speed, self.oil_temperature))
        return RollingAnswer(self.case, *parts)

    def note(self, place: str, R_0: Any) -> Text | None:
        return None


@result
class RollingBearing(LoadedBearing, Carrying):
    """One rolling bearing under its load, as its shaft and a report ask it."""

    anew = True

    @property
    def speed(self) -> RevPerSecond:
        return self.task.speed

    @property
    def supply_temperature(self) -> Celsius:
        return self.case.inputs.supply_temperature

    @property
    def supplied(self) -> OilState:
        return self.case.lubricant.at(self.supply_temperature)

    @property
    def running_clearance(self) -> Metre:
        return self.clearance_running or 0.0

    @property
    def least_load(self) -> Newton:
        return 0.0

    def lying(self, lies: OnShaftResult) -> Self:
        return replace(self, on_shaft=lies)

    def checks(self) -> Iterator[Check]:
        return rolling_checks(self.row.name, self)

    def slope_effect(self, bent: Radian) -> Text:
        most = largest_slope(self.case.size.type, self.case.size.series)
        return Text(
            "then that of the bending: slope {slope}, allowed {most}",
            slope=Amount(bent * 1e3, "mrad"),
            most=Amount(most * 1e3, "mrad"),
        )

    def way(self) -> tuple[Metre, Radian]:
        springs = self.case.springs(self.running_clearance)
        if springs is None or self.load <= 0:
            return based_on(0.0, self.load), based_on(0.0, self.load)
        e = float(springs.displacement(self.load))
        return based_on(e, self.load, self.clearance_running, springs.contact), based_on(0.0, self.load)

    def edge_tilted(self, theta: Radian) -> None:
        return None

    def out_of_line(self, R_c: Newton) -> None:
        return None

    def survival(self) -> tuple[Second, Number] | None:
        return None if self.life is None else (self.life, EXPONENTS[self.case.size.elements].weibull)

    def seat_size(self) -> Metre:
        return self.seat_diameter

    def mass(self) -> Kilogram:
        return self.bearing_mass

    def spring(self) -> NewtonPerMetre | None:
        return self.stiffness

    def drained(self) -> None:
        return None

    def answer(self, *, turns: bool) -> RollingAnswer:
        return RollingAnswer(self.case, self.load, self.speed, self.supply_temperature)

    def answer_at(self, ratio: Any, T: Any, lubricant: Lubricant | None, factor: Any = 1.0) -> RollingAnswer:
        case = self.case if lubricant is None else replace(self.case, lubricant=lubricant)
        return RollingAnswer(case, self.load * ratio**2 * factor, self.speed * ratio, T)

    def under(self, stands: StandingLoads, checks: list[Check], notes: list[Text]) -> tuple[Self, list[Check]]:
        place, row = self.row.name, self.row
        if row.standing_load is not None:
            stands = replace(stands, all=row.standing_load, weight=row.standing_load)
        with about(Text("{place} bearing", place=called(place))):
            again: Any = judged(self.case, self.load, stands, self.slope, self.task)
        again = again.lying(self.on_shaft)
        mine = [of_one(check, place) for check in checks]
        at = mine.index(True) if True in mine else len(checks)
        others = [check for check, own in zip(checks[at:], mine[at:]) if not own]
        return again, [*checks[:at], *by_row(row, [*again.checks()]), *others]

    def beside_original(self) -> RollingResult:
        return self


def judged(case: RollingCase, load: Newton, stands: StandingLoads, slope: Radian | None, task: Task) -> RollingBearing:
    """The bearing under its loads."""
    return RollingBearing(**solve(case, load, stands, slope, task))
