# SPDX-License-Identifier: Apache-2.0
"""What the gas in the cylinders is described by: a simple mixed cycle, or a table of indicated pressure."""

from collections.abc import Iterable, Iterator
from math import pi

from ..sheet.quantity import choice, dotted, inputs, quantity, tables
from ..sheet.text import Amount, Text

FEWEST_POINTS = 8  # of a pressure table
SAME_ANGLE = 1e-9  # rad: two points nearer than this are one
# What is taken where it is left out.
INTAKE, EXHAUST, CRANKCASE = 1.0e5, 1.1e5, 1.0e5  # Pa
COMPRESSION, EXPANSION = 1.35, 1.28
HELD = 10 * pi / 180  # rad


@inputs
class PressurePoint:
    """One row of a table of indicated pressure."""

    angle: float = quantity(
        "Crank angle",
        "°",
        within=(-360, 720),
        symbol="epsilon",
        help="Crank angle after the TDC at which this cylinder fires.",
    )
    pressure: float = quantity(
        "Pressure", "bar", within=(0, 1000), symbol="p", help="Pressure in the cylinder at this angle, absolute."
    )


@inputs
class GasInputs:
    """The gas of one cylinder over its cycle; all cylinders have the same.  Pressures are absolute."""

    peak_pressure: float | None = quantity(
        "Peak pressure",
        "bar",
        default=None,
        up_to=1000,
        symbol="p_max",
        rule_of_thumb=(40, 220),
        help="Highest in the mixed (Sabathé) cycle, absolute.",
    )
    compression_ratio: float | None = quantity(
        "Compression ratio",
        default=None,
        above=1,
        high=50,
        symbol="epsilon_c",
        rule_of_thumb=(7, 23),
        help="Largest over smallest volume of a cylinder.",
    )
    intake_pressure: float | None = quantity(
        "Intake pressure",
        "bar",
        default=None,
        up_to=100,
        symbol="p_in",
        rule_of_thumb=(0.3, 3.5),
        help="Absolute, as compression begins. Left out: 1.0 bar.",
    )
    exhaust_pressure: float | None = quantity(
        "Exhaust pressure",
        "bar",
        default=None,
        up_to=100,
        symbol="p_ex",
        rule_of_thumb=(1, 4),
        help="In a four-stroke's exhaust, absolute. Left out: 1.1 bar.",
    )
    crankcase_pressure: float | None = quantity(
        "Crankcase pressure",
        "bar",
        default=None,
        within=(0, 100),
        symbol="p_case",
        rule_of_thumb=(0.8, 1.5),
        help="Absolute, under the piston. Left out: 1.0 bar.",
    )
    compression_exponent: float | None = quantity(
        "Compression exponent",
        default=None,
        within=(1, 2),
        symbol="n_c",
        rule_of_thumb=(1.25, 1.4),
        help="Of the polytropic compression. Left out: 1.35.",
    )
    expansion_exponent: float | None = quantity(
        "Expansion exponent",
        default=None,
        within=(1, 2),
        symbol="n_e",
        rule_of_thumb=(1.2, 1.35),
        help="Of the polytropic expansion. Left out: 1.28.",
    )
    constant_pressure_angle: float | None = quantity(
        "Peak pressure held for",
        "°",
        default=None,
        within=(0, 90),
        symbol="epsilon_p",
        rule_of_thumb=(0, 30),
        help="Crank angle after TDC. Left out: 10°.",
    )
    charge: str | None = choice(
        "How load is made",
        "throttled",
        "unthrottled",
        default=None,
        help="For idle and part load. Left out: unthrottled from a compression ratio of 14 on.",
    )
    pressure: tuple[PressurePoint, ...] = tables(
        "Indicated pressure",
        PressurePoint,
        default=(),
        help="Over one cycle, linear between the points; instead of peak pressure and ratio.",
    )

    def problems(self) -> Iterable[tuple[str, Text]]:
        """What no single field can show: (key, reason)."""
        of_the_cycle = (
            (dotted(GasInputs.peak_pressure), self.peak_pressure),
            (dotted(GasInputs.compression_ratio), self.compression_ratio),
            (dotted(GasInputs.intake_pressure), self.intake_pressure),
            (dotted(GasInputs.exhaust_pressure), self.exhaust_pressure),
            (dotted(GasInputs.compression_exponent), self.compression_exponent),
            (dotted(GasInputs.expansion_exponent), self.expansion_exponent),
            (dotted(GasInputs.constant_pressure_angle), self.constant_pressure_angle),
        )
        if self.pressure:
            yield from (
                (key, Text("belongs to the simple cycle; the pressure table says it all: leave one of the two out"))
                for key, given in of_the_cycle
                if given is not None
            )
            if len(self.pressure) < FEWEST_POINTS:
                yield (
                    dotted(GasInputs.pressure),
                    Text(
                        "has {count} points; needs at least {fewest_points} over the cycle",
                        count=len(self.pressure),
                        fewest_points=FEWEST_POINTS,
                    ),
                )
            yield from _doubled(self, 4 * pi)
            return
        for key, given in of_the_cycle[:2]:
            if given is None:
                yield (
                    key,
                    Text("is missing; give peak pressure and compression ratio, or a table [[engine.gas.pressure]]"),
                )
        if self.peak_pressure is None or self.compression_ratio is None:
            return
        n_c = COMPRESSION if self.compression_exponent is None else self.compression_exponent
        end = (INTAKE if self.intake_pressure is None else self.intake_pressure) * self.compression_ratio**n_c
        if self.peak_pressure <= end:
            yield (
                dotted(GasInputs.peak_pressure),
                Text(
                    "must exceed the pressure at the end of compression, {end} bar",
                    end=Amount(end / 100000.0, form=".4g"),
                ),
            )


def cycle_problems(gas: GasInputs, strokes: int) -> Iterator[tuple[str, Text]]:
    """What is wrong with the gas for an engine of so many strokes, with keys of [engine.gas]."""
    if strokes == 2:
        yield from _doubled(gas, 2 * pi)
        if gas.exhaust_pressure is not None and not gas.pressure:
            yield (
                dotted(GasInputs.exhaust_pressure),
                Text("belongs to a four-stroke engine; the cycle of a two-stroke has no exhaust stroke: leave it out"),
            )


def _doubled(gas: GasInputs, length: float) -> Iterator[tuple[str, Text]]:
    """Points of the table that fall on one crank angle of the cycle; those of a two-stroke that do so in 720° as well
    are named once."""
    if length < 4 * pi and any(True for _ in _doubled(gas, 4 * pi)):
        return
    order = sorted((point.angle % length, i) for i, point in enumerate(gas.pressure))
    pressure = [point.pressure for point in gas.pressure]
    for (here, this_point), (there, other) in zip(order, [*order[1:], *((a + length, i) for a, i in order[:1])]):
        # a closed cycle ends as it began
        if there - here < SAME_ANGLE and this_point != other and pressure[this_point] != pressure[other]:
            first, second = sorted((this_point, other))
            yield (
                dotted(GasInputs.pressure, second, PressurePoint.angle),
                Text(
                    "is the angle of point {first} too, {length}° being one cycle; give one pressure for it",
                    first=first,
                    length=Amount(length / pi * 180, form="g"),
                ),
            )
