# SPDX-License-Identifier: Apache-2.0
"""What every part of a report is made from."""

from dataclasses import dataclass, field

from calc.design import STEPS, Design
from calc.design_file import Document
from calc.explain import Chains
from calc.id_words import belongs
from calc.languages import Language, language
from calc.sheet.check import URGENT, Check, severity
from calc.sheet.quantity import Published
from calc.sheet.step import Curve, Outcome, Step
from calc.sheet.text import Amount, Part, Text, plural
from calc.sheet.trace import Equation, Line
from calc.solve import Results

from .words import WORDS

DEPTHS = ("summary", "engineer", "audit")
CURVES = 2  # of a step, in the design calculation


Deciding = dict[tuple[str, Equation], set[str]]  # step and formula → variants


@dataclass(slots=True)
class Context:
    """A solved design and how it is to be reported; counts the figures and collects the sources on the way."""

    document: Document
    results: Results
    sha256: str
    depth: str
    say: Language
    original: Results | None = None  # the same results with their texts as data, if `results` are said in a language already
    figures: int = 0
    sources: dict[str, list[str]] = field(default_factory=dict)  # source, as the formula or check has it → titles of the steps that use it
    cited: set[str] = field(default_factory=set)  # those of what stands in the report
    words: dict[str, str] = field(init=False)  # the report's own, in its language
    _deciding: Deciding = field(default_factory=dict)
    _values: dict[str, Published] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.words = {key: self.say(text) for key, text in WORDS.items()}

    def text(self, key: str, /, n: float | None = None, **parts: Part) -> str:
        """A sentence of the report with its parts, in its language; `n`: the count of one that depends on it."""
        template, one = WORDS[key].template, WORDS[key].one
        return self.say(Text(template, **parts) if n is None else plural(one, template, n=n, **parts))

    def written(self, value: float, unit: str = "") -> str:
        """A number as the report's language writes it, with its unit."""
        return self.say.part(Amount(value, unit))

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

    def steps(self) -> list[tuple[int, Step, Outcome[object]]]:
        return [(n, step, self.results.outcomes[step.key]) for n, step in enumerate(STEPS, 1) if step.key in self.results.outcomes]

    def cite(self, source: str, step: Step, *, stands: bool = True) -> str:
        """Note that a step uses a source, and whether what it says stands in this report; gives it in the report's language."""
        used = self.sources.setdefault(source, [])
        if (title := self.say(step.title)) not in used:
            used.append(title)
        if stands:
            self.cited.add(source)
        return self.say(source)

    def belongs(self, id: str) -> list[str]:
        """What a value or check belongs to: `bearings.front.film_edge` → ["front"], in the report's language."""
        return [self.say(word) for word in belongs(id)]

    def holds_all(self, outcome: Outcome[object]) -> bool:
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
    return language("en").halves(line.about)[1]


def _deciding(results: Results) -> Deciding:
    """The formulas, each with its step and variants, that lead to the values which stand for the steps, to the limit that each step
    comes closest to (where it has none, to the advice), and to whatever fails."""
    chains = Chains(results)
    values = {id for step in STEPS if (id := step.headline(chains.values)) is not None}
    for outcome in results.outcomes.values():
        limits = [check for check in outcome.checks if check.kind in ("limit", "caution")] or outcome.checks
        judged = [*sorted(limits, key=closeness)[:1], *(check for check in limits if check.verdict == "fail")]
        values |= {value for check in judged if (value := chains.behind(check)) is not None}
    keys = list(results.outcomes)
    found: Deciding = {}
    for n in chains.leading_to(values):
        found.setdefault((keys[chains.steps[n]], chains.lines[n].formula), set()).add(variant(chains.lines[n]))
    return found


def closeness(check: Check) -> tuple[bool, int, int, float]:
    """Sorts checks so that the one that decides a step is the first: what is urgent, else the limit that is kept most narrowly."""
    return check.verdict not in URGENT, *severity(check)[1:]
