# SPDX-License-Identifier: Apache-2.0
"""What each of several shafts that are to be sized takes of what the engine and the given shafts leave.

The vectors are those of one order that turn like the shaft, at its own speed: the engine's and those of all given
shafts of its ratio together."""

from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.text import Amount, Text
from ...sheet.units import (
    Metre,
    Number,
    PhasorKilogramMetre,
    PhasorKilogramMetre2,
    PhasorNewton,
    PhasorNewtonMetre,
    RadPerSecond,
)
from ..formulas import asked_product, asked_unbalance
from ..inputs import ShaftInputs
from .sectors import Asked

Vectors = tuple[PhasorNewton, PhasorNewtonMetre]  # force F and couple C
UNLIKE: Number = 0.05  # of the larger of both senses: what a mirrored pair may leave of one of them; as LEFT_OVER
OPPOSITE = Text("dynamics: opposite to its share of what turns like the shaft and is left for it, and over-design")
LEFT = {"F_like": "F_left", "C_like": "C_left", "w": "w_s", "omega": "ω_S"}


@formula("w_s", "rule of this program: shafts of one ratio that are sized take equal shares, twins counted")
def equal_share(k: Number) -> Number:
    return 1 / k


@formula("U_req", OPPOSITE, unit="kg·mm", names=LEFT)
def shared_unbalance(x_o: Number, w: Number, F_like: PhasorNewton, omega: RadPerSecond) -> PhasorKilogramMetre:
    return -(1 + x_o) * w * F_like / omega**2


@formula("P_req", OPPOSITE, unit="kg·mm²", names=LEFT)
def shared_product(x_o: Number, w: Number, C_like: PhasorNewtonMetre, omega: RadPerSecond) -> PhasorKilogramMetre2:
    return -(1 + x_o) * w * C_like / omega**2


def share_of(shaft: ShaftInputs, alike: int) -> Number:
    """What a sized shaft takes of what is left for those of its ratio, of which there are so many."""
    if shaft.share is not None:
        return shaft.share
    return equal_share(k=float(alike)) if alike > 1 else 1.0


def asked_share(left: Vectors, omega: RadPerSecond, x_o: Number = 0.0, share: Number = 1.0) -> Asked:
    """Unbalance and unbalance times position that a shaft needs, `omega` its own speed.

    `left`: of the engine and of all given shafts of its ratio; `share`: of it, 1 where no other shaft is sized for this
    ratio; of several the shares of all, twins counted, add to 1."""
    F, C = left
    if share == 1:
        return asked_unbalance(x_o=x_o, F_like=F, omega=omega), asked_product(x_o=x_o, C_like=C, omega=omega)
    return (
        shared_unbalance(x_o=x_o, w=share, F_like=F, omega=omega),
        shared_product(x_o=x_o, w=share, C_like=C, omega=omega),
    )


def need_mirror_images(left: Vectors, against: Vectors, z_max: Metre) -> None:
    """Whether a shaft and its mirror image can take what is left in both senses: of what turns like the shaft and what
    turns against it each must be the mirror image of the other.  Forces are judged beside couples at the half-length
    z_max, so that next to nothing is not judged by itself.  Raises NoSolution."""
    (F, C), (F_against, C_against) = left, against
    force, couple = abs(F_against - F.conjugate()), abs(C_against - C.conjugate())
    most = max(abs(F), abs(F_against), abs(C) / z_max, abs(C_against) / z_max)
    unlike = max(force, couple / z_max) / most if most else 0.0
    if unlike > UNLIKE:
        raise NoSolution(
            Text(
                "forward and backward vectors are no mirror images: they differ by {unlike} %", unlike=_percent(unlike)
            ),
            Text("one shaft and its mirror image, which may leave {limit} % of them", limit=_percent(UNLIKE)),
            Text("write two shafts"),
        )


def _percent(share: Number) -> Amount:
    return Amount(share * 100, form=".3g")
