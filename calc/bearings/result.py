# SPDX-License-Identifier: Apache-2.0
"""What the bearing step publishes: each bearing as its kind has it."""

from ..countershaft.bending.condensed import OnSupports
from ..countershaft.rows import IN_WORDS
from ..sheet.arrays import Array, ComplexArray
from ..sheet.quantity import group, result, value
from ..sheet.shown import Shown
from ..sheet.units import Radian, Second
from .plain.bearing import PlainBearing
from .support import Carrying, Support, Told


@result
class BearingsResult(Shown):
    """The bearings of a shaft, front to rear."""

    bearings: dict[str, Carrying] = group(spread=True, key_words=IN_WORDS)
    system_life: Second | None = value(
        "Life of all rolling bearings of the shaft together", "h", "L_s", short=True, default=None
    )
    cone: Radian | None = value("Half-angle of the cone on which the shaft goes round", "mrad", "γ_c", default=None)
    stands: OnSupports | None = None  # what stands on more than two bearings
    line: tuple[Array, ComplexArray] | None = None  # places along the shaft, and the way of its axis in the films
    supports: tuple[Support, ...] = ()  # the bearings before their loads were known
    told: Told | None = None  # what is shown beside them

    @property
    def plain(self) -> dict[str, PlainBearing]:
        """Those of them that run on a film."""
        return {place: r for place, r in self.bearings.items() if isinstance(r, PlainBearing)}


@result
class TwinBearings(Shown):
    """The bearings of a twin on which more stands than on those of its original: of each what is not its original's."""

    bearings: dict[str, object] = group(spread=True, key_words=IN_WORDS)


@result
class BearingsOfShafts(Shown):
    """Those of several shafts."""

    shafts: dict[str, BearingsResult | TwinBearings] = group(spread=True)
    system_life: Second | None = value("Life of all rolling bearings together", "h", "L_s", short=True, default=None)
