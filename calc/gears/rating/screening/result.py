# SPDX-License-Identifier: Apache-2.0
"""What the screening of a mesh gives."""

from ....sheet.arrays import Array
from ....sheet.quantity import result, value
from ....sheet.units import Celsius, Kelvin, Metre, MetrePerSecond, NewtonPerMetre, Number, Pascal


@result
class Screening:
    """Film and temperatures of one mesh at its load.  A screening, not a rating."""

    specific_film_min: Number | None = value("Smallest specific film thickness (screening)", "", "λ_GF,min", default=None)
    film_min: Metre | None = value("Film thickness where the specific film is smallest", "µm", "h_min", default=None)
    film_pressure: Pascal | None = value("Hertzian pressure where the specific film is smallest", "MPa", "p_dyn", default=None)
    friction_film: Number = value("Mean coefficient of friction, micropitting method", "", "μ_m")
    bulk_temperature_film: Celsius = value("Bulk temperature, micropitting method", "°C", "Θ_M")
    flash_temperature_max: Kelvin = value("Highest flash temperature (screening)", "K", "Θ_fl,max")
    friction_flash: Number = value("Mean coefficient of friction, flash temperature method", "", "μ_m")
    bulk_temperature_flash: Celsius = value("Bulk temperature, flash temperature method", "°C", "Θ_M")
    contact_temperature_max: Celsius = value("Highest contact temperature", "°C", "Θ_B,max")
    scuffing_temperature: Celsius = value("Scuffing temperature of the oil", "°C", "Θ_S")
    scuffing_safety: Number = value("Safety against scuffing, by temperatures (screening)", "", "S_B")
    scuffing_margin: Kelvin
    title: str  # "driver–driven"
    film_place: str  # A, AB, B, C, D, DE or E; empty: no film
    permissible_film: Number
    permissible_given: bool
    load_stage: Number
    load_stage_given: bool
    line_load: NewtonPerMetre  # w_Bt
    pitch_line_speed: MetrePerSecond
    oil_temperature: Celsius
    method_applies: bool  # spur or narrow helical wheels with ε_α below 2, or wide helical ones
    way: Array  # samples: way on the line of action from the pitch point
    flash: Array
    specific_film: Array | None
