# SPDX-License-Identifier: Apache-2.0
"""What is published of a seat: how bush or shells sit, the classes they are picked by, the split line."""

from ....sheet.quantity import group, result, value
from ....sheet.record import record
from ....sheet.shown import Shown
from ....sheet.units import Celsius, Metre, NewtonMetre, Number, Pascal, PerKelvin
from .rings import Rings


@record
class Temperatures:
    """The states that a fit is judged at: coldest start, and bush and housing where the film is hottest; `cool`: the
    housing at its coolest while it is, where its temperature is not given."""

    cold: Celsius
    reference: Celsius
    hot: Celsius
    housing: Celsius
    cool: Celsius | None


@result
class SeatResult(Shown):
    """A bush or pair of shells in its housing, assembled at the reference temperature.  Pressures of the least
    interference, stresses of the most."""

    interference_min: Metre = value("Interference, least", "µm", "δ_min")
    interference_max: Metre = value("Interference, most", "µm", "δ_max")
    interference: Metre = value("Interference, middle", "µm", "δ")
    bore: Metre = value("Bore as assembled", "mm", "d_i")
    bore_free: Metre = value("the same of the bush alone", "mm", "d_i,free")
    bore_closing: Metre = value("by which it closes when pressed", "µm", "c_i")
    housing_growth: Metre = value("by which the housing widens", "µm", "g_H")
    press: Pascal = value("Pressure of the fit", "MPa", "p", short=True)
    press_cold: Pascal = value("the same at the lowest temperature", "MPa", "p_cold")
    press_hot: Pascal = value("the same where the film is hottest", "MPa", "p_hot", short=True)
    press_needed: Pascal = value("Pressure that keeps the fit shut under the load", "MPa", "p_need")
    bush_stress: Pascal = value("Hoop stress of the bush", "MPa", "σ_B")
    housing_stress: Pascal = value("Stress of the housing at its bore", "MPa", "σ_v")
    tension: Pascal = value("Hoop tension of the housing at its bore", "MPa", "σ_H")
    expansion: PerKelvin = value("Expansion of the bore while it is pressed", "10⁻⁶/K", "α_eff")
    loose_at: Celsius | None = value("Temperature at which it comes loose", "°C", "T_0", default=None, short=True)
    holding_torque: NewtonMetre = value("Torque that holds it where the film is hottest", "N·m", "M_h")
    drag_torque: NewtonMetre = value("Torque of the film", "N·m", "M_f")
    rings: Rings
    temperatures: Temperatures
    press_hot_cool: Pascal | None  # with the housing at its coolest; None: its temperature is given


@result
class PairResult(Shown):
    """One pair of classes."""

    min: Metre = value("Least clearance of the pair", "µm", "g_min")
    max: Metre = value("Most clearance of the pair", "µm", "g_max")


@result
class SelectResult(Shown):
    """Shells that are picked by classes."""

    inserts: Number = value("Number of different shells", "", "n")
    pair: dict[str, PairResult] = group(words="classes of bore and journal")


@result
class SplitResult(Shown):
    """The film as the parting lines of the shells pass under the turning load."""

    share: Number = value("Share of the film that is left", "", "s_t")
    film: Metre = value("Film at the edge as the split passes under the load", "µm", "h_split", short=True)
    beyond: bool  # the relief or the film lies outside what was marched: there is less film than this
