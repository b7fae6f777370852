# SPDX-License-Identifier: Apache-2.0
"""What every part of a report is made from."""

from dataclasses import dataclass, field

from calc.design.model import STEPS, Design
from calc.design.toml_file import Document
from calc.studies.explain import Chains
from calc.id_words import belongs
from calc.design.key_values import CURVES, judged, like, outside
from calc.locale import Language
from calc.studies.drive.front import Picked
from calc.sheet.check import URGENT, Check, severity
from calc.sheet.quantity import Published
from calc.sheet.step import Curve, Outcome, Step
from calc.sheet.text import Amount, Part, Text, plural
from calc.solve import Results

from .elements import Origins
from .logo import Logo
from .setting.symbols import Symbol
from .blocks.words import WORDS

DEPTHS = ("summary", "engineer", "audit")
NEAR = 0.1  # margin up to which a check that holds is proven


@dataclass(slots=True)
class Context:
    """A solved design and how it is to be reported; counts the figures and collects the sources on the way."""

    document: Document
    results: Results
    sha256: str
    depth: str
    say: Language
    original: Results | None = None  # the same results with their texts as data, if `results` are said in a language already
    logo: Logo | None = None
    drive: Picked | None = None  # of the front that the design is one drive of
    figures: int = 0
    chapter: str = ""  # key of the step whose chapter is being made
    ranges: set[str] = field(default_factory=set)  # chapters that say how a long list of numbers is written
    symbols: dict[tuple[str, str], Symbol] = field(default_factory=dict)  # of each chapter, as they are set
    labels: dict[tuple[str, str], str] = field(default_factory=dict)  # chapter and symbol → what the value or input is called
    sources: dict[str, list[str]] = field(default_factory=dict)  # source, as the formula or check has it → titles of the steps that use it
    cited: set[str] = field(default_factory=set)  # those of what stands in the report
    origins: Origins = field(default_factory=Origins)
    words: dict[str, str] = field(init=False)  # the report's own, in its language
    _chains: Chains | None = None
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

    @property
    def chains(self) -> Chains:
        """The chains of lines that lead to values and checks."""
        if self._chains is None:
            self._chains = Chains(self.original or self.results)
        return self._chains

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

    def number(self, outcome: Outcome[object]) -> list[tuple[int, Curve]]:
        """The curves of a step with the numbers of their figures, one for a whole stack: all of them for an audit, else the main ones."""
        curves = outcome.curves if self.audit else _main_curves(outcome)
        numbered: list[tuple[int, Curve]] = []
        for curve in curves:
            if not (curve.stack and numbered and numbered[-1][1].stack == curve.stack):
                self.figures += 1
            numbered.append((self.figures, curve))
        return numbered

    def outside(self, check: Check) -> list[Check]:
        """The checks of the method that put a check outside the validity of its formula."""
        return outside(check, self.results.outcomes[check.id.partition(".")[0]].checks)

    def state(self, check: Check) -> str:
        """The verdict of a check, or that it holds outside the validity of its formula."""
        return judged(check, self.results.outcomes[check.id.partition(".")[0]].checks)


def _main_curves(outcome: Outcome[object]) -> list[Curve]:
    """The curves of a step that a short report has.  All of them are made only where one of these is not a key curve: some take long."""
    found: list[Curve] = []
    for pattern in CURVES.get(outcome.key, ()):
        first = next((curve for curves in (outcome.key_curves, outcome.curves) for curve in curves if like(curve.id, (pattern,))), None)
        found += [first] if first is not None else []
    return found


def near(check: Check) -> bool:
    """Whether a check is to be proven: a limit or caution that is passed over or can not be judged, or that is kept by at most a tenth."""
    if check.kind not in ("limit", "caution"):
        return False
    return check.verdict != "pass" or not check.holds or (check.nearest[1] != 0 and check.margin <= NEAR)


def stands(check: Check) -> bool:
    """Whether a check has a line of its own in the engineer's report: advice and what concerns the method do where they are passed over."""
    return check.open or check.kind in ("limit", "caution")


def closeness(check: Check) -> tuple[bool, int, int, float]:
    """Sorts checks so that the one that decides a step is the first: what is urgent, else the limit that is kept most narrowly."""
    return check.verdict not in URGENT, *severity(check)[1:]
