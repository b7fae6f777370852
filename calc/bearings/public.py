# SPDX-License-Identifier: Apache-2.0
"""Plain bearings from Python, in SI: `from calc import bearings`."""

from ..library.catalogue import Oil, materials, oils
from ..library.lubricant import Lubricant
from ..sheet.units import Celsius, Metre, Newton, Number, Pascal, RevPerSecond
from .film.grooved import Feed, solve_grooved
from .film.table import film_at
from .formulas import relative_clearance, sommerfeld, specific_load
from .inputs import BearingInputs, BearingsInputs
from .routes.balance import balanced
from .routes.routes import own_cold, own_warm
from .routes.states import BearingCase, Film
from .solve import operating_point

__all__ = ["Feed", "film_at", "relative_clearance", "solve_film", "solve_grooved", "sommerfeld", "specific_load"]


def solve_film(
    *,
    diameter: Metre,
    length: Metre,
    clearance: Metre,
    load: Newton,
    speed: RevPerSecond,
    oil: str | Oil,
    supply_temperature: Celsius,
    supply_pressure: Pascal = 3e5,
    hole_diameter: Metre = 4e-3,
    load_speed_ratio: Number = 1.0,
    journal: str = "steel",
    housing: str = "steel",
    warm: bool = True,
) -> Film:
    """The film of one bearing in thermal balance, by this program's own solution of Reynolds' equation.

    `clearance`: diametral, at 20 °C.  `speed`: of the journal, revolutions per second.  `oil`: a name of the table, or
    an Oil. `load_speed_ratio`: 1, the load turns with the shaft; 0, it stands.  `journal`, `housing`: materials, by
    whose expansion the clearance changes (`warm` False: it keeps its size).  Raises NoSolution where there is no film.
    """
    bearing = BearingInputs(
        diameter=diameter, length=length, clearance=clearance, load=load, journal_roughness=0.0, housing_roughness=0.0
    )
    row = oils()[oil] if isinstance(oil, str) else oil
    inputs = BearingsInputs(
        oil=row.name,
        supply_temperature=supply_temperature,
        supply_pressure=supply_pressure,
        supply="hole",
        hole_diameter=hole_diameter,
        housing_material=housing,
        front=bearing,
        rear=bearing,
        load_speed_ratio=load_speed_ratio,
    )
    known = materials()
    case = BearingCase(bearing, inputs, Lubricant(row), clearance, known[journal].expansion, known[housing].expansion)
    return balanced(own_warm if warm else own_cold, case, operating_point(inputs, load, speed))
