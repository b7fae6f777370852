# SPDX-License-Identifier: Apache-2.0
"""What a fit came to, in sentences."""

from collections.abc import Sequence
from math import floor, isfinite, log10

from ..sheet.record import record
from ..sheet.text import SEMICOLON, SPACE, Amount, Name, Text, listed
from .fitting import EVALUATIONS, PART, WIDEST, FitResult

BEYOND = 1000  # times the ranges

VERDICTS = {
    "identified": Text("identified"),
    "at its bound": Text("at its bound"),
    "not identifiable": Text("not identifiable"),
    "not converged": Text("not converged"),
}
UP, DOWN = Text("up"), Text("down")


@record
class FreeName:
    """What a free input is called, its key, and the unit of that, in which it is fitted."""

    key: str
    label: Text
    unit: str


def written(value: float, sd: float) -> float:
    """A value as a file takes it: two digits below the first one of its standard deviation."""
    if not (isfinite(sd) and sd > 0):
        return value
    return round(value, 2 - floor(log10(sd)))


def sentence(fit: FitResult, names: Sequence[FreeName]) -> Text:
    """What the verdict means, and what to do."""
    if fit.verdict == "not converged":
        return Text(
            "The search did not settle within {n} evaluations of a free input. Give a start nearer to the answer, "
            "narrow the ranges, or free fewer inputs.",
            n=EVALUATIONS,
        )
    if fit.verdict == "not identifiable":
        return _not_identifiable(fit, names)
    if fit.verdict == "at its bound":
        ends = []
        for i in fit.at_bound:
            value = Amount(float(fit.values[i]), names[i].unit)
            ends.append(Text("{label} ended at {value}", label=names[i].label, value=value))
        return Text(
            "{ends}, a bound of its range, and nothing is applied. Widen the range if the input may lie beyond it; "
            "else the model, or another input, is off.",
            ends=listed(ends),
        )
    parts = [
        Text(
            "The runs determine what is free: the least certain direction to {width} of the ranges (at most {most}).",
            width=Amount(fit.width, digits=2),
            most=WIDEST,
        )
    ]
    if fit.scaled:
        parts.append(
            Text(
                "The rows scatter more than their uncertainties say (χ² is {chi2} a degree of freedom), and each ± is "
                "wider by the root of that.",
                chi2=Amount(fit.variance, digits=3),
            )
        )
    return SPACE.join(parts)


def width_words(fit: FitResult, digits: int = 2) -> Text | Amount:
    """How wide the worst direction is; far beyond the ranges its digits are those of the differences."""
    return Text("more than {n}", n=BEYOND) if fit.width > BEYOND else Amount(fit.width, digits=digits)


def _not_identifiable(fit: FitResult, names: Sequence[FreeName]) -> Text:
    """Each direction along which the rows do not hold the free inputs, and what would help."""
    loose = [direction for w, direction in zip(fit.widths, fit.directions) if w > WIDEST]
    ways = SEMICOLON.join(_combination(direction, names) for direction in loose)
    helps = Text("another measured column that depends on them otherwise, a prior, or fewer free inputs would help")
    if len(names) == 1:
        helps = Text("another measured column that depends on it, more exact rows, or a prior would help")
    return Text(
        "What was measured hardly changes with {ways}: along that the width is {wide} of the ranges (at most {most}). "
        "No values are given; {helps}.",
        ways=ways,
        wide=width_words(fit),
        most=WIDEST,
        helps=helps,
    )


def _combination(direction: Sequence[float], names: Sequence[FreeName]) -> Text:
    """`clearance of front up, clearance of rear down in the proportion 0.76 : −0.65`, as shares of the ranges."""
    parts = [(float(part), name) for part, name in zip(direction, names) if abs(part) > PART]
    if len(parts) == 1:
        return Text("{label} alone", label=parts[0][1].label)
    ways = [Text("{label} {way}", label=name.label, way=UP if part > 0 else DOWN) for part, name in parts]
    proportion = " : ".join(Amount(part, form=".2f").written() for part, _ in parts)
    return Text("{ways} in the proportion {proportion}", ways=listed(ways), proportion=Name(proportion))
