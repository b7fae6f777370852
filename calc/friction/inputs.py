# SPDX-License-Identifier: Apache-2.0
"""What the friction of the meshes needs beyond the gears themselves."""

from collections.abc import Iterable

from ..sheet.quantity import choice, dotted, inputs, integer, quantity, series, tables, text
from ..sheet.text import Text

# Types of rolling bearings whose factors are known (`losses/bearings.py`).
BEARING_TYPES = (
    "deep-groove-ball",
    "angular-contact-ball",
    "self-aligning-ball",
    "cylindrical-roller",
    "needle-roller",
    "spherical-roller",
    "tapered-roller",
)


CARRIED = Text("Left out: the wheel that the name begins with (crank-seal), else the last of the train.")
# Series of rolling bearings for which SKF's constants could be read.
SKF_SERIES = {
    "deep-groove-ball": ("2", "3", "42", "43", "60", "630", "62", "622", "63", "623", "64", "160", "161", "618", "619"),
    "cylindrical-roller": ("4", "22", "10", "2", "3", "23"),
}

# the folds of the form
LOSSES = Text("Seals, rolling bearings, splash")


@inputs
class Carried:
    """A loss, or what makes one, that a wheel carries."""

    name: str = text("Name")
    wheel: str | None = text("Wheel that carries it", default=None, help=CARRIED)


@inputs
class OtherLoss(Carried):
    """A loss that the train carries besides those computed."""

    power: float = quantity(
        "Power", "W", within=(0, 1e6), symbol="P", help="Power that is lost there, known from elsewhere."
    )


@inputs
class Seal(Carried):
    """A radial shaft seal on the shaft of a wheel."""

    diameter: float = quantity(
        "Shaft diameter",
        "mm",
        up_to=1000,
        symbol="d_sh",
        help="Diameter of the shaft under the lip.",
        brief="diameter",
    )
    count: int = integer(
        "Seals of this size", default=1, within=(1, 20), help="How many such seals the wheel's shaft has."
    )
    method: str = choice(
        "Method",
        "simrit",
        "linke",
        default="simrit",
        help="simrit: by diameter and speed. linke: also by the oil and its temperature.",
    )


@inputs
class RollingBearing(Carried):
    """Rolling bearings that carry a wheel."""

    kind: str = choice("Type", *BEARING_TYPES, default="deep-groove-ball")
    bore: float = quantity("Bore", "mm", up_to=1000, symbol="d", help="Inner diameter of the bearing.")
    outside_diameter: float = quantity(
        "Outside diameter",
        "mm",
        up_to=2000,
        symbol="D",
        help="Outer diameter of the bearing; with the bore it gives the mean one.",
    )
    load: float | None = quantity(
        "Radial load of all of them together",
        "N",
        default=None,
        within=(0, 1e6),
        symbol="F",
        help="What they carry together. Left out: by the teeth of its wheel.",
        repair="asked",
    )
    count: int = integer(
        "Bearings that share the load",
        default=1,
        within=(1, 8),
        help="How many they are, sharing the radial load evenly.",
    )
    method: str = choice("Method", "palmgren", "skf", default="palmgren", help="skf: needs the series.")
    series: str | None = text("Series", default=None, help='For SKF\'s model: "60", "62", "63" …')
    lubrication: str = choice(
        "Lubrication",
        "bath",
        "mist",
        "jet",
        default="mist",
        help="By Palmgren: mist half of a bath, a jet twice. By SKF: mist starves more.",
    )
    f_0: float | None = quantity(
        "Factor f_0",
        default=None,
        within=(0, 50),
        symbol="f_0",
        usual=(0.5, 24),
        source="Palmgren 1957, by type and lubrication",
        help="For the loss without load. Left out: by type and lubrication.",
    )
    f_1: float | None = quantity(
        "Factor f_1",
        default=None,
        within=(0, 0.05),
        symbol="f_1",
        usual=(0.0001, 0.002),
        source="Palmgren 1957, by type",
        help="For the loss by the load. Left out: by the type.",
    )

    def problems(self) -> Iterable[tuple[str, Text]]:
        if self.outside_diameter <= self.bore:
            yield dotted(RollingBearing.outside_diameter), Text("must be larger than the bore")
        if self.method == "skf" and self.series not in (known := SKF_SERIES.get(self.kind, ())):
            rows = ", ".join(f'"{series}"' for series in known)
            hint = (
                Text("give one of {rows}", rows=rows)
                if known
                else Text(
                    "SKF's constants could be read for {skf_series} only", skf_series=Text(" and ").join(SKF_SERIES)
                )
            )
            yield (
                dotted(RollingBearing.series),
                Text('method = "skf" needs the series of the bearing: {told}; or take method = "palmgren"', told=hint),
            )


@inputs
class PlainBearing(Carried):
    """The bush of an idler on its fixed pin."""

    diameter: float = quantity(
        "Diameter", "mm", up_to=1000, symbol="d", help="Diameter of the pin in the bush.", brief="diameter"
    )
    length: float = quantity("Length", "mm", up_to=1000, symbol="l", help="Length of the bush along its pin.")
    clearance: float = quantity(
        "Diametral clearance when running",
        "µm",
        up_to=5000,
        symbol="g",
        help="Bore of the bush minus pin, both warm.",
        brief="clearance",
    )
    load: float | None = quantity(
        "Load",
        "N",
        default=None,
        within=(0, 1e6),
        symbol="F",
        help="Force of the wheel on its pin. Left out: by the teeth of its wheel.",
        repair="asked",
    )


@inputs
class Dip(Carried):
    """A wheel that dips into oil."""

    depth: float = quantity(
        "Depth of its lowest tooth below the oil at rest",
        "mm",
        up_to=2000,
        symbol="h",
        source="Changenet et al. 2011",
        help="How deep the wheel dips while the oil is at rest.",
    )
    oil_volume: float = quantity(
        "Oil in the sump",
        "L",
        up_to=1000,
        symbol="V_0",
        source="Changenet et al. 2011",
        help="Volume of the oil into which the wheel dips.",
    )


@inputs
class Jet(Carried):
    """Oil thrown onto a wheel, which carries it along."""

    flow: float = quantity(
        "Flow",
        "L/min",
        up_to=1000,
        symbol="Q",
        source="Butsch 1989, ISO/TR 14179-2",
        help="Oil that strikes the wheel and is carried along.",
    )
    jet_speed: float = quantity(
        "Speed of the jet along the teeth",
        "m/s",
        default=0.0,
        within=(-200, 200),
        symbol="v_j",
        help="Positive: the way the teeth go.",
    )


@inputs
class Scenario:
    """The same design with another oil, temperature, load sharing, roughness or power."""

    name: str = text("Name")
    oil: str | None = text("Oil", default=None, catalogue="oils")
    oil_temperature: float | None = quantity(
        "Oil temperature",
        "°C",
        default=None,
        within=(-40, 200),
        symbol="T_oil",
        step=5,
        rule_of_thumb=(40, 130),
        help="Of the teeth; replaces a measured bulk temperature.",
        repair="asked",
    )
    load_sharing: str | None = choice("Load sharing", "linear", "smooth", default=None)
    flank_roughness: tuple[float, ...] | None = series(
        "Flank roughness Ra",
        "µm",
        count=(1, 2),
        default=None,
        up_to=20,
        symbol="Ra",
        rule_of_thumb=(0.1, 2),
        help="Mean roughness, one for both or [driver, driven].",
    )
    power: float | None = quantity(
        "Power of the first driver",
        "kW",
        default=None,
        up_to=1e5,
        symbol="P",
        help="What goes into the first driver of a design without counter-shaft.",
        repair="asked",
    )
    figure: str | None = text(
        "Figure",
        default=None,
        help="Scenarios of one figure are drawn together. Left out: with the others that say none.",
    )


@inputs
class FrictionInputs:
    """Oil, flanks and load sharing of the meshes."""

    oil: str | None = text(
        "Oil",
        default=None,
        help="Of teeth and wheels. Left out: that of the bearings, which alone sets the journals' friction.",
        change=("thinner oil", "thicker oil", "another oil"),
        catalogue="oils",
        decides=1,
    )
    oil_temperature: float | None = quantity(
        "Oil temperature",
        "°C",
        default=None,
        within=(-40, 200),
        symbol="T_oil",
        step=5,
        rule_of_thumb=(40, 130),
        help="Of teeth and wheels. Left out: the bearings' supply temperature.",
        repair="asked",
        decides=2,
    )
    bulk_temperature: float | None = quantity(
        "Bulk temperature",
        "°C",
        default=None,
        within=(-40, 300),
        symbol="T_b",
        rule_of_thumb=(40, 150),
        help="Of the teeth, measured. Left out: by the next key.",
        repair="asked",
    )
    bulk: str = choice(
        "Bulk temperature without measurement",
        "oil",
        "estimated",
        default="oil",
        help="oil: that of the oil. estimated: above it by the loss of the mesh itself (ISO/TR 15144-1).",
    )
    tip_relief_factor: float = quantity(
        "Tip relief factor of that estimate",
        default=1.0,
        within=(1, 10),
        symbol="X_Ca",
        source="ISO/TR 15144-1",
        help="How much tip relief shares the load more evenly; 1: no tip relief.",
    )
    body_resistance: tuple[float, ...] | None = series(
        "Thermal resistance of the wheels' bodies",
        "K/W",
        count=(1, 2),
        default=None,
        within=(0, 1000),
        symbol="M",
        source="Olver 1991, Olver and Spikes 1998",
        help="From flank to where the bulk temperature is known. One for both, or [driver, driven]. Left out: not "
        "counted.",
    )
    flank_roughness: tuple[float, ...] = series(
        "Flank roughness Ra",
        "µm",
        count=(1, 2),
        up_to=20,
        symbol="Ra",
        rule_of_thumb=(0.1, 2),
        help="Mean roughness, one for both or [driver, driven].",
        change=("smoother flanks", "rougher flanks"),
        repair="free",
        decides=3,
    )
    load_sharing: str = choice(
        "Load sharing",
        "linear",
        "smooth",
        default="linear",
        help="linear: flanks as generated. smooth: both tips relieved.",
        decides=4,
    )
    load_share: str = choice(
        "Load share of the roughness",
        "zhu-hu",
        "castro-seabra",
        "olver-spikes",
        "doleschel",
        "thesis",
        default="zhu-hu",
        help="How much of the load rides on the peaks where the film is thin. The friction source's model always "
        "takes the thesis'.",
    )
    solid_friction: float | None = quantity(
        "Friction of peaks",
        default=None,
        within=(0, 1),
        symbol="mu_s",
        step=0.005,
        usual=(0.05, 0.15),
        source="gear friction thesis, 4.2: 0.08 to 0.135; Arana, Larrañaga and Ulacia 2018: 0.065 to 0.07, lubricated",
        help="Where flanks touch. Left out: 0.08; the source's 0.135.",
    )
    pressure_law: str | None = choice(
        "Viscosity under pressure",
        "barus",
        "roelands",
        default=None,
        help="Roelands' is milder above some 0.5 GPa. Left out: Roelands, and Barus in the friction source's model.",
    )
    film: str = choice(
        "Film that is judged",
        "judged",
        "source",
        default="judged",
        help="judged: by lubrication regime and lubricated peaks, with rolling loss. source: the friction source's "
        "model, EHL everywhere.",
    )
    mist_density: float = quantity(
        "Density of the oil mist",
        "kg/m³",
        default=24.0,
        within=(0.1, 1000),
        symbol="rho_m",
        usual=(1.2, 50),
        source="rule of this program; tests of Anderson and Loewenthal: 24",
        help="Governs the windage; air alone has 1.2.",
        repair="asked",
    )
    mass_loss: str = choice(
        "Loss of the turning masses",
        "none",
        "bracket",
        default="none",
        help="Of sectors in the mist, which nobody has measured. bracket: between the least and the most the mean in "
        "proportion counts, in a shell the least. none: not counted.",
    )
    oil_level: float | None = quantity(
        "Oil at rest",
        "mm",
        default=None,
        within=(-5000, 5000),
        symbol="h_oil",
        help="Up from the crank's axis, as the shafts' axes are; sectors must turn above it.",
        repair="asked",
        change=("less oil", "more oil"),
    )
    specific_fuel_consumption: float | None = quantity(
        "Specific fuel consumption",
        "g/kWh",
        default=None,
        up_to=2000,
        symbol="b_e",
        rule_of_thumb=(190, 350),
        help="What the engine burns for its power.",
        decides=5,
    )
    co2_per_fuel: float = quantity(
        "CO₂ per fuel, by mass",
        default=3.17,
        up_to=5,
        symbol="e_CO2",
        usual=(2.7, 3.2),
        source="physics: carbon share, natural gas to diesel",
        help="Of complete combustion; diesel, petrol 3.17.",
    )
    map_temperatures: tuple[float, ...] | None = series(
        "Oil temperatures of the map",
        "°C",
        count=(1, 8),
        default=None,
        within=(-40, 200),
        help="Of losses over speed. Left out: four from 40 K below the oil's to 10 K above.",
    )
    map_speeds: tuple[float, ...] | None = series(
        "Speeds of the map",
        "rpm",
        count=(2, 2),
        default=None,
        up_to=1e5,
        help="Lowest and highest, of the first driver.",
        repair="asked",
    )
    seals: tuple[Seal, ...] = tables(
        "Shaft seals",
        Seal,
        default=(),
        help="The wheel that the name begins with carries it, else the last.",
        fold=LOSSES,
    )
    rolling_bearings: tuple[RollingBearing, ...] = tables(
        "Rolling bearings of wheels", RollingBearing, default=(), fold=LOSSES
    )
    plain_bearings: tuple[PlainBearing, ...] = tables("Plain bearings of idlers", PlainBearing, default=(), fold=LOSSES)
    dips: tuple[Dip, ...] = tables("Wheels that dip into oil", Dip, default=(), fold=LOSSES)
    jets: tuple[Jet, ...] = tables("Oil thrown onto wheels", Jet, default=(), fold=LOSSES)
    other_losses: tuple[OtherLoss, ...] = tables(
        "Other losses",
        OtherLoss,
        default=(),
        help='What is known otherwise; the wheel that the name begins with carries it ("idler-pump"), else the last.',
        fold=LOSSES,
    )
    scenarios: tuple[Scenario, ...] = tables(
        "Scenarios", Scenario, default=(), help="The same train under other conditions, side by side.", fold=LOSSES
    )

    def problems(self) -> Iterable[tuple[str, Text]]:
        if self.bulk == "estimated" and self.bulk_temperature is not None:
            yield (
                dotted(FrictionInputs.bulk_temperature),
                Text('leave it out where bulk = "estimated": it is measured or estimated, not both'),
            )


def carrier(entry: Carried, wheels: Iterable[str], last: str) -> str:
    """The wheel that carries a loss: told, or whose name it has, or begins with before a separator ("idler-seal"); else
    the last wheel."""
    if entry.wheel is not None:
        return entry.wheel
    loss = entry.name
    named = [name for name in wheels if loss == name or (loss.startswith(name) and not loss[len(name)].isalnum())]
    return max(named, key=len, default=last)
