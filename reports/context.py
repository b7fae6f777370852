# SPDX-License-Identifier: Apache-2.0
"""What every part of a report is made from."""

from dataclasses import dataclass, field
from typing import Any

from calc.design import STEPS, Design
from calc.design_file import Document
from calc.explain import Chains, behind
from calc.languages import Language
from calc.sheet.check import Check
from calc.sheet.formula import Formula
from calc.sheet.quantity import Published
from calc.sheet.step import Curve, Outcome, Step
from calc.sheet.trace import Line
from calc.solve import Results

from .words import WORDS

DEPTHS = ("summary", "engineer", "audit")
CURVES = 2  # of a step, in the design calculation


Deciding = dict[tuple[str, Formula[..., Any]], set[str]]  # step and formula → variants


@dataclass(slots=True)
class Context:
    """A solved design and how it is to be reported; counts the figures and collects the sources on the way."""

    document: Document
    results: Results
    sha256: str
    depth: str
    say: Language
    figures: int = 0
    sources: dict[str, list[str]] = field(default_factory=dict)  # source → titles of the steps that use it
    cited: set[str] = field(default_factory=set)  # those of what stands in the report
    words: dict[str, str] = field(init=False)  # the report's own, in its language
    _deciding: Deciding = field(default_factory=dict)
    _values: dict[str, Published] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.words = {key: self.say(text) for key, text in WORDS.items()}

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

    def lines(self, key: str) -> list[Line]:
        """The lines of a step's calculation: all of them for an audit, else those of the formulas that decide."""
        lines = list(self.results.outcomes[key].lines)
        if self.audit:
            return lines
        if not self._deciding:
            self._deciding.update(_deciding(self.results))
        return [line for line in lines if variant(line) in self._deciding.get((key, line.formula), ())]

    def steps(self) -> list[tuple[int, Step, Outcome]]:
        return [(n, step, self.results.outcomes[step.key]) for n, step in enumerate(STEPS, 1) if step.key in self.results.outcomes]

    def cite(self, source: str, step: Step, *, stands: bool = True) -> str:
        """Note that a step uses a source, and whether what it says stands in this report; gives it in the report's language."""
        source, title = self.say(source), self.say(step.title)
        used = self.sources.setdefault(source, [])
        if title not in used:
            used.append(title)
        if stands:
            self.cited.add(source)
        return source

    def belongs(self, id: str) -> list[str]:
        """What a value or check belongs to: `bearings.front.film_edge` → ["front"].  Wheels and meshes have the user's names."""
        step, *parts = id.split(".")[:-1]
        return [self._named(step, part) for part in parts]

    def _named(self, step: str, part: str) -> str:
        gears = self.design.gears
        if step in ("gears", "friction") and gears is not None:
            if any(part == wheel.name for wheel in gears.wheels):
                return part
            if mesh := next((mesh for mesh in gears.meshes if part == mesh.key), None):
                return f"{mesh.driver}–{mesh.driven}"
        address, words = f"{step}.{part}", part.replace("_", " ")  # a word like "crank" is a wheel's name elsewhere
        said = self.say(address)
        return said if said != address else self.say(words)

    def holds_all(self, outcome: Outcome) -> bool:
        """Whether all curves and tables of a step stand in the report."""
        return self.audit or (len(outcome.curves) <= CURVES and outcome.further is None)

    def number(self, curves: tuple[Curve, ...]) -> list[tuple[int, Curve]]:
        """The curves of a step with their numbers: all of them for an audit, else the first two."""
        curves = curves if self.audit else curves[:CURVES]
        first = self.figures + 1
        self.figures += len(curves)
        return list(enumerate(curves, first))


def variant(line: Line) -> str:
    """What of a part a line is about: "front bearing, twice the load" → "twice the load"; all parts are treated alike."""
    return line.about.partition(", ")[2]


def _deciding(results: Results) -> Deciding:
    """The formulas, each with its step and variants, that lead to the values which stand for the steps, to the limit that each step
    comes closest to (where it has none, to the advice), and to whatever fails."""
    chains = Chains(results)
    values = {id for step in STEPS if (id := step.headline(chains.values)) is not None}
    for outcome in results.outcomes.values():
        limits = [check for check in outcome.checks if check.kind != "advice"] or outcome.checks
        judged = [*sorted(limits, key=severity)[:1], *(check for check in limits if check.verdict == "fail")]
        values |= {value for check in judged if (value := behind(check, chains.values)) is not None}
    keys = list(results.outcomes)
    found: Deciding = {}
    for n in chains.leading_to(values):
        found.setdefault((keys[chains.steps[n]], chains.lines[n].formula), set()).add(variant(chains.lines[n]))
    return found


def severity(check: Check) -> tuple[int, float]:
    """Sorts checks with the worst first."""
    margin = check.margin
    return {"fail": 0, "warn": 1}.get(check.verdict, 2), margin if margin == margin else float("-inf")
