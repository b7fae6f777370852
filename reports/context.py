# SPDX-License-Identifier: Apache-2.0
"""What every part of a report is made from."""

from dataclasses import dataclass, field

from calc.design import STEPS, Design
from calc.design_file import Document
from calc.sheet.check import Check
from calc.sheet.quantity import Published
from calc.sheet.step import Curve, Outcome, Step
from calc.solve import Results

DEPTHS = ("summary", "engineer", "audit")


@dataclass(slots=True)
class Context:
    """A solved design and how it is to be reported; counts the figures and collects the sources on the way."""

    document: Document
    results: Results
    sha256: str
    depth: str
    words: dict[str, str]
    figures: int = 0
    sources: dict[str, list[str]] = field(default_factory=dict)  # source → titles of the steps that use it
    _values: dict[str, Published] = field(default_factory=dict)

    @property
    def values(self) -> dict[str, Published]:
        """Every value of the results by its name."""
        if not self._values:
            self._values.update(self.results.values())
        return self._values

    @property
    def design(self) -> Design:
        return self.results.design

    @property
    def audit(self) -> bool:
        return self.depth == "audit"

    def steps(self) -> list[tuple[int, Step, Outcome]]:
        return [(n, step, self.results.outcomes[step.key]) for n, step in enumerate(STEPS, 1) if step.key in self.results.outcomes]

    def cite(self, source: str, step: Step) -> str:
        used = self.sources.setdefault(source, [])
        if step.title not in used:
            used.append(step.title)
        return source

    def number(self, curves: tuple[Curve, ...]) -> list[tuple[int, Curve]]:
        first = self.figures + 1
        self.figures += len(curves)
        return list(enumerate(curves, first))


def part(id: str) -> str:
    """What a value or check belongs to: `bearings.front.film_edge` → "front"."""
    return " ".join(id.split(".")[1:-1]).replace("_", " ")


def severity(check: Check) -> tuple[int, float]:
    """Sorts checks with the worst first."""
    margin = check.margin
    return {"fail": 0, "warn": 1}.get(check.verdict, 2), margin if margin == margin else float("-inf")
