# SPDX-License-Identifier: Apache-2.0
"""What is seen of a curve: one of its variants, its vectors at one crank angle.  Knows neither screen nor plotting library."""

from dataclasses import dataclass

from calc.sheet.step import Curve, Series, Turning

TURN = 10  # degrees by which the crank is turned at a time


@dataclass(frozen=True)
class Cursor:
    """Where a curve is read.  `place`: an x, or the parameter of a locus, or the number of a point; `line`: the series that was chosen."""

    place: float
    line: int = 0


@dataclass(frozen=True)
class Sight:
    """`wanted`: the variant that was chosen, by its name; a curve that does not have it shows its first."""

    curve: Curve
    wanted: str = ""
    degrees: int = 0  # crank angle; 0: cylinder 1 at TDC

    @property
    def variant(self) -> str:
        variants = self.curve.variants
        return self.wanted if self.wanted in variants else variants[0] if variants else ""

    @property
    def next_variant(self) -> str:
        variants = self.curve.variants
        return variants[(variants.index(self.variant) + 1) % len(variants)] if variants else ""

    @property
    def series(self) -> tuple[Series, ...]:
        return tuple(s for s in self.curve.series if s.variant in ("", self.variant))

    @property
    def chains(self) -> tuple[Turning, ...]:
        """The vectors that are drawn: only true scale shows them as they are."""
        return tuple(t for t in self.curve.turning if t.variant in ("", self.variant)) if self.curve.equal else ()

    @property
    def turns(self) -> bool:
        return bool(self.chains)
