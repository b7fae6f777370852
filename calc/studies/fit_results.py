# SPDX-License-Identifier: Apache-2.0
"""A fit of a design as it is told: its values, its check, what applying it changes."""

from collections.abc import Mapping
from math import isfinite

from ..measurements.fit_words import VERDICTS, FreeName, sentence, written
from ..measurements.fitting import WIDEST, FitResult
from ..sheet.check import Check, CheckRule
from ..sheet.quantity import Described, Published
from ..sheet.record import record
from ..sheet.text import COMMA, EMPTY, Amount, Text
from ..sheet.units import UNITS

Changes = Mapping[str, float | None]  # keys with numbers in their units; None takes one out


@record
class DesignFit:
    """A fit of a design and what it came to.

    `names`: of the free inputs, in the order of the fit; `now`: what the design has of each; `replaced`: keys that a
    free one takes the place of; `runs`: the names of the runs; `rows`: how many of each column are fitted, `unit`: that
    of the rows, where all have one; `left_out`: what of them is not, and why."""

    name: str
    runs: tuple[str, ...]
    names: tuple[FreeName, ...]
    now: tuple[float | None, ...]
    replaced: tuple[str, ...]
    rows: Mapping[str, int]
    unit: str
    left_out: tuple[Text, ...]
    result: FitResult

    @property
    def changes(self) -> Changes:
        """What applying it makes of the design: keys with numbers in their units, None takes one out."""
        found = {name.key: self.applied(i) for i, name in enumerate(self.names)}
        return {**dict.fromkeys(self.replaced), **found}

    def applied(self, i: int) -> float:
        """The value of an input as a file takes it."""
        return written(float(self.result.values[i]), float(self.result.sd[i]))

    @property
    def identified(self) -> bool:
        return self.result.verdict == "identified"

    @property
    def verdict(self) -> Text:
        return VERDICTS[self.result.verdict]

    @property
    def sentence(self) -> Text:
        """What the verdict means, and what to do."""
        return sentence(self.result, self.names)

    @property
    def numbers(self) -> Text:
        """`clearance of front 97.92 ± 9.33 µm, clearance of rear …`; empty where no values are given."""
        values, parts = self.values(), []
        for i, name in enumerate(self.names):
            if (value := values.get(f"{self.id}.{name.key}")) is not None:
                number = Amount(self.applied(i), digits=6) if i not in self.result.at_bound else Amount(value.shown)
                sd = values.get(f"{self.id}.{name.key}.sd")
                spread = Text(" ± {sd}", sd=Amount(sd.shown, digits=3)) if sd is not None else EMPTY
                told = dict(label=name.label, value=number, spread=spread, unit=name.unit)
                parts.append(Text("{label} {value}{spread} {unit}", **told))
        return COMMA.join(parts) if parts else EMPTY

    @property
    def words(self) -> Text:
        """`drag: identified, clearance of front 97.92 ± 9.33 µm`, in a line."""
        words = COMMA.join(part for part in (self.verdict, self.numbers) if part)
        return Text("{name}: {words}", name=self.name, words=words)

    @property
    def id(self) -> str:
        return f"fit.{self.name}"

    def values(self) -> dict[str, Published]:
        """What it came to, by ids: `fit.NAME.KEY`, its `.sd`, `fit.NAME.chi2_reduced`, of rows without uncertainty
        `.residual_sd` in their unit, `.width`, `.correlation`.  Where the runs do not hold the inputs, or the search
        did not settle, the first two are not there."""
        found = []
        result = self.result
        if result.verdict in ("identified", "at its bound"):
            for i, name in enumerate(self.names):
                found.append(_published(f"{self.id}.{name.key}", float(result.values[i]), name.unit, name.label))
                if i not in result.at_bound:
                    sd = Text("Standard deviation of {label}", label=name.label)
                    found.append(_published(f"{self.id}.{name.key}.sd", float(result.sd[i]), name.unit, sd))
        if result.weighted:
            found.append(_published(f"{self.id}.chi2_reduced", result.variance, "", Text("χ² over degrees of freedom")))
        else:
            scatter = Text("Standard deviation of the residuals")
            found.append(_published(f"{self.id}.residual_sd", result.variance**0.5, self.unit, scatter))
        width = Text("Standard deviation along the least certain direction, as a share of the ranges")
        found.append(_published(f"{self.id}.width", result.width, "", width))
        if (correlation := result.correlation) is not None:
            largest = Text("Correlation of two free inputs, the largest")
            found.append(_published(f"{self.id}.correlation", correlation, "", largest))
        return {value.id: value for value in found}

    def check(self) -> Check:
        judged = self.result.width if self.result.verdict in ("identified", "not identifiable") else None
        name = Text("Fit {name}: {verdict}", name=self.name, verdict=self.verdict)
        keys = tuple(name.key for name in self.names)
        infinite = judged is not None and not isfinite(judged)
        return IDENTIFIED(None if infinite else judged, WIDEST, at=self.name, name=name, moved_by=keys)


IDENTIFIED = CheckRule(
    "fit.N",
    "method",
    "Says what a run is worth for an input, and nothing of the part.",
    Text("Fit"),
    "<=",
    source=Text("rule of this program: a standard deviation of a quarter of the range is no answer"),
    advice=Text("Measure another column that depends on the inputs otherwise, give a prior, or free fewer of them."),
)


def _published(id: str, shown: float, unit: str, label: Text) -> Published:
    about = Described(label, unit, "")
    return Published(id, shown, unit, label, "", UNITS[unit].inside(shown), about)
