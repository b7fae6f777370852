# SPDX-License-Identifier: Apache-2.0
"""A check: a value against its limit, with margin, verdict, source and advice."""

import math
from dataclasses import dataclass

from .number import short
from .units import UNITS

THIN_MARGIN = 0.05  # a limit that holds by less than this is a warning
SIGNS = {"pass": "✓", "warn": "▲", "fail": "✗", "blocked": "○", "not_asked": "·", "no_solution": "✗"}
ORDER = ("not_asked", "pass", "warn", "blocked", "fail", "no_solution")  # from good to bad


@dataclass(frozen=True, slots=True)
class Check:
    """`value` and `limit` stand in the shown unit.  `sense` is ">=", ">", "<=", "<" or "in" (limit is then (low, high)).

    `kind` "limit": passed over is a fail, less than 5 % margin a warning.  `kind` "advice": passed over is a warning.
    """

    id: str
    name: str
    value: float
    limit: float | tuple[float, float]
    sense: str
    unit: str
    source: str
    advice: str = ""
    kind: str = "limit"

    @property
    def nearest(self) -> tuple[float, float]:
        """Distance to the nearest limit, negative when passed over, and that limit."""
        if isinstance(self.limit, tuple):
            low, high = self.limit
            to_low, to_high = self.value - low, high - self.value
            return (to_low, low) if to_low <= to_high else (to_high, high)
        return (self.value - self.limit if self.sense in (">=", ">") else self.limit - self.value), self.limit

    @property
    def margin(self) -> float:
        """Distance to the nearest limit over |limit|, negative when passed over; for a limit of 0 the distance itself."""
        gap, limit = self.nearest
        return gap / abs(limit) if limit else gap

    @property
    def narrow(self) -> bool:
        """Kept, but by so little that it is a warning."""
        return self.verdict == "warn" and self.nearest[0] >= 0

    @property
    def verdict(self) -> str:
        margin = self.margin
        if math.isnan(margin):
            return "fail"
        passed_over = margin < 0 or (margin == 0 and self.sense in (">", "<"))
        if self.kind == "advice":
            return "warn" if passed_over else "pass"
        if passed_over:
            return "fail"
        return "warn" if margin < THIN_MARGIN else "pass"

    def limit_text(self) -> str:
        if isinstance(self.limit, tuple):
            return f"{short(self.limit[0])} to {short(self.limit[1])} {self.unit}".rstrip()
        sign = {">=": "≥", "<=": "≤"}.get(self.sense, self.sense)
        return f"{sign} {short(self.limit)} {self.unit}".rstrip()

    def margin_text(self) -> str:
        if math.isnan(self.margin):
            return "no number"
        if self.nearest[1] == 0:
            text = f"{self.margin:+.3g}".replace("-", "−")
            if "e" in text:
                text = ("+" if self.margin > 0 else "") + short(self.margin, 3)
            return f"{text} {self.unit}".rstrip()
        percent = self.margin * 100
        if abs(percent) > 99999:  # of a limit that is all but zero
            return "beyond −99999 %" if percent < 0 else "beyond +99999 %"
        digits = 1 if 0 < abs(percent) < 0.5 else 0
        return f"{percent:+.{digits}f} %".replace("-", "−")


def check(
    id: str,
    name: str,
    value: float,
    sense: str,
    limit: float | tuple[float, float],
    unit: str,
    source: str,
    advice: str = "",
    *,
    kind: str = "limit",
) -> Check:
    """A check from numbers in SI: value and limit are turned into the shown unit here and nowhere else."""
    shown = UNITS[unit].shown
    bound = (shown(limit[0]), shown(limit[1])) if isinstance(limit, tuple) else shown(limit)
    number = shown(value) if math.isfinite(value) else value
    return Check(id, name, number, bound, sense, unit, source, advice, kind)


def worst(verdicts: list[str]) -> str:
    return max(verdicts, key=ORDER.index, default="pass")
