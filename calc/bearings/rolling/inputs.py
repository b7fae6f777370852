# SPDX-License-Identifier: Apache-2.0
"""What the rolling bearings of all shafts share: how the oil comes to them, how clean it is, what they are asked."""

from collections.abc import Iterable

from ...sheet.quantity import choice, dotted, inputs, quantity, tables, text
from ...sheet.text import Text
from .contamination import cleanliness_problem

ROLLING = Text("Rolling bearings")
DUTY = Text("Duty")


@inputs
class Duty:
    """A part of the machine's life: how fast it turns, for how long, with which oil."""

    name: str = text("Name", help="idle, cruise, rated or any other word.")
    speed: float = quantity(
        "Speed",
        "rpm",
        up_to=1e5,
        symbol="n",
        help="Of the crank; of the shaft where there is no engine.",
        repair="asked",
    )
    hours: float = quantity("Hours", up_to=1e9, symbol="w", help="In any unit: their shares count.", repair="asked")
    oil_temperature: float | None = quantity(
        "Oil temperature",
        "°C",
        default=None,
        within=(-40, 200),
        symbol="T_oil",
        help="Where it reaches the bearings. Left out: supply_temperature_C.",
        repair="asked",
    )
    extra_load: float = quantity(
        "Extra load",
        "N",
        default=0.0,
        within=(0, 1e7),
        symbol="F_x",
        help="That stands, of unknown direction: added.",
        repair="asked",
    )
    load_factor: float = quantity(
        "Load factor",
        default=1.0,
        within=(0, 10),
        symbol="k_F",
        help="On the load that turns with the shaft.",
        repair="asked",
    )
    road_speed: float | None = quantity(
        "Road speed",
        "km/h",
        default=None,
        within=(0, 500),
        help="For CO₂ per kilometre, where every row has one.",
        repair="asked",
    )


@inputs
class RollingInputs:
    """Oil and duty of the rolling bearings."""

    rolling_lubrication: str = choice(
        "Oil at the rolling bearings",
        "splash",
        "mist",
        "jet",
        "bath",
        default="splash",
        help="How it comes to them.",
        fold=ROLLING,
    )
    cleanliness: str = text(
        "Cleanliness of the oil",
        default="typical",
        help="high, normal, slight, typical, severe, very-severe; or a class of ISO 4406 behind an on-line filter.",
        source="ISO 281:2007",
        fold=ROLLING,
    )
    reliability: float = quantity(
        "Reliability",
        "%",
        default=0.9,
        within=(90, 99.9),
        symbol="S",
        source="ISO 281:2007",
        help="Of the life that is asked.",
        fold=ROLLING,
        repair="asked",
    )
    life: float | None = quantity(
        "Life",
        "h",
        default=None,
        up_to=1e7,
        symbol="L_h",
        help="Asked of the rolling bearings. Left out: that of the gears, else 5000, assumed.",
        fold=ROLLING,
        repair="asked",
    )
    shock_factor: float = quantity(
        "Shock factor",
        default=1.5,
        within=(1, 5),
        symbol="k_s",
        source="rule of this program",
        help="On the largest load, against marks in the raceways.",
        fold=ROLLING,
        repair="asked",
    )
    ring_temperature: float = quantity(
        "Inner ring above outer ring",
        "K",
        default=5.0,
        within=(0, 50),
        symbol="ΔT_r",
        source="IKO: 5 to 10 normal, 15 to 20 fast",
        help="By how much the inner ring is warmer than the outer.",
        fold=ROLLING,
        repair="asked",
    )
    duty: tuple[Duty, ...] = tables(
        "Duty",
        Duty,
        default=(),
        help="Parts of the machine's life. Left out: those of [[engine.operation]], else rated speed alone.",
        fold=DUTY,
    )

    def rolling_problems(self) -> Iterable[tuple[str, Text]]:
        if (wrong := cleanliness_problem(self.cleanliness)) is not None:
            yield dotted(RollingInputs.cleanliness), wrong
        seen: set[str] = set()
        for i, row in enumerate(self.duty):
            if row.name in seen:
                yield dotted(RollingInputs.duty, i, Duty.name), Text('"{name}" stands twice', name=row.name)
            seen.add(row.name)
