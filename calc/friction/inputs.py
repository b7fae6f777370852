# SPDX-License-Identifier: Apache-2.0
"""What the friction of the meshes needs beyond the gears themselves."""

from collections.abc import Iterable

from ..sheet.quantity import choice, inputs, quantity, series, tables, text


@inputs
class OtherLoss:
    """A loss that the train carries besides those computed: idler bearings, seals."""

    name: str = text("Name")
    power: float = quantity("Power", "W", low=0, high=1e6, symbol="P")


@inputs
class FrictionInputs:
    """Oil, flanks and load sharing of the meshes."""

    oil: str | None = text("Oil", optional=True, help="Left out: that of the bearings.")
    oil_temperature: float = quantity(
        "Oil temperature", "°C", optional=True, low=-40, high=200, symbol="T_oil", step=5,
        help="Left out: the bearings' supply temperature.",
    )  # fmt: skip
    bulk_temperature: float = quantity(
        "Bulk temperature", "°C", optional=True, low=-40, high=300, symbol="T_b", help="Of the teeth. Left out: that of the oil."
    )
    flank_roughness: tuple[float, ...] = series(
        "Flank roughness Ra", "µm", count=(1, 2), above=0, high=20, symbol="Ra", help="One for both, or [driver, driven]."
    )
    load_sharing: str = choice(
        "Load sharing", "linear", "smooth", default="linear", help="linear: flanks as generated. smooth: both tips relieved."
    )
    solid_friction: float = quantity("Friction of the solids", default=0.135, low=0, high=1, symbol="mu_s", step=0.005)
    film: str = choice(
        "Film that is judged", "judged", "source", default="judged",
        help="judged: by lubrication regime, with rolling loss. source: EHL film everywhere.",
    )  # fmt: skip
    mist_density: float = quantity(
        "Density of the oil mist", "kg/m³", default=24.0, low=0.1, high=1000, symbol="rho_m",
        help="Governs the windage: 24 in the tests behind its formula, 1.2 in air alone.",
    )  # fmt: skip
    specific_fuel_consumption: float = quantity("Specific fuel consumption", "g/kWh", optional=True, above=0, high=2000, symbol="b_e")
    other_losses: tuple[OtherLoss, ...] = tables(
        "Other losses",
        OtherLoss,
        optional=True,
        help='Idler bearings, seals …; the wheel that the name begins with carries it ("idler bearing"), else the last.',
    )


def carrier(loss: str, wheels: Iterable[str], last: str) -> str:
    """The wheel that carries a loss: whose name it has, or begins with before a separator ("idler-seal"); else the last wheel."""
    named = [name for name in wheels if loss == name or (loss.startswith(name) and not loss[len(name)].isalnum())]
    return max(named, key=len, default=last)
