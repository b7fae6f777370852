# SPDX-License-Identifier: Apache-2.0
"""What every part of a report is made from: the solved design, its logo, and what its numbers come from."""

from __future__ import annotations

import io
import stat
import struct
import zlib
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from reportlab.lib.utils import ImageReader

from calc.design.addresses import as_list, as_table
from calc.design.key_results import judged, outside
from calc.design.limits import LOGO_BYTES, LOGO_SIDE
from calc.design.model import STEPS, Design
from calc.design.names import belongs
from calc.design.other_tables import DocumentControl
from calc.design.toml_file import Document
from calc.locale import Language
from calc.locale.language import said
from calc.sheet.check import Check
from calc.sheet.errors import BadInput, InputError
from calc.sheet.quantity import Published, described, dotted
from calc.sheet.step import OF_SHAFTS, Curve, Outcome, Step
from calc.sheet.text import Amount, Part, Text, plural
from calc.sheet.value import Line, Link, leaves, link_of
from calc.solve import Results
from calc.studies.drive.front import Picked
from calc.studies.explain import Chains

from .blocks.words import WORDS
from .made import versions
from .typesetting.boxes import Symbol

if TYPE_CHECKING:
    from calc.design.run_results import RunResults  # which a design without runs does not load
    from calc.studies.fit_results import DesignFit

# --- the logo of a title block: a PNG file beside the design, in which a stranger may have put anything

KEY = dotted(Design.document, DocumentControl.logo)
HEAD = b"\x89PNG\r\n\x1a\n\x00\x00\x00\rIHDR"
# what a damaged PNG raises
BROKEN = (OSError, SyntaxError, ValueError, EOFError, TypeError, IndexError, KeyError, struct.error, zlib.error)


@dataclass(frozen=True, slots=True)
class Logo:
    """`raw`: the bytes of the file, which go into the report; width and height in pixels."""

    name: str
    raw: bytes
    image: ImageReader
    width: int
    height: int


def logo(document: Document, name: str, given: bytes | None = None) -> Logo | None:
    """The logo of a design, from the bytes `given` or from its file; None where it has none.  Raises BadInput where it
    can not be drawn."""
    if not name:
        return None

    def refused(reason: Text) -> BadInput:
        return BadInput(document.place, [InputError(document.lines.get(KEY, 0), KEY, f'"{name}"', reason)])

    try:
        raw = _read(Path(document.place).parent / name) if given is None else given
    except OSError as error:
        why = error.strerror or str(error)
        raise refused(
            Text("cannot be read beside the design: {reason}; put the file there, or leave the logo out", reason=why)
        ) from None
    except ValueError:
        raise refused(Text("is no plain file; put the picture itself beside the design")) from None
    if len(raw) > LOGO_BYTES:
        raise refused(Text("is larger than {most} kB; make it smaller", most=LOGO_BYTES // 1000))
    if not raw.startswith(HEAD) or len(raw) < len(HEAD) + 8:
        raise refused(Text("is no PNG picture"))
    width, height = struct.unpack(">II", raw[len(HEAD) : len(HEAD) + 8])
    if not 0 < width <= LOGO_SIDE or not 0 < height <= LOGO_SIDE:
        raise refused(
            Text(
                "has {width} × {height} pixels; at most {side} either way are drawn",
                width=width,
                height=height,
                side=LOGO_SIDE,
            )
        )
    try:
        image = ImageReader(io.BytesIO(raw))
        image.getRGBData()
    except BROKEN:
        raise refused(Text("is a damaged PNG picture")) from None
    return Logo(name, raw, image, width, height)


def _read(path: Path) -> bytes:
    """The first bytes of a plain file: no link out of the folder, no device that never ends."""
    if not stat.S_ISREG(path.lstat().st_mode):
        raise ValueError(path)
    with path.open("rb") as file:
        return file.read(LOGO_BYTES + 1)


# --- what a number comes from, followed through arrays
# Of each line the one element that enters, and what that is made of.

Index = tuple[int, ...]
Element = tuple[Line, Index | None]  # a line, and which element of its value; None: all of it, or it is no array


class Origins:
    """The elements that others come from, each found once."""

    def __init__(self) -> None:
        self._known: dict[Element, tuple[list[Element], list[str]]] = {}

    def of(self, element: Element) -> tuple[list[Element], list[str]]:
        """The elements of lines, and the inputs, that enter a line, or one element of it."""
        if element not in self._known:
            self._known[element] = _came_from(*element)
        return self._known[element]

    def followed(self, start: Iterable[Element]) -> Iterator[Element]:
        """These elements and all that they come from, the nearest first; each line once."""
        waiting = list(start)
        known = {line for line, _ in waiting}
        for element in waiting:  # grows on the way
            yield element
            for needed in self.of(element)[0]:
                if needed[0] not in known:
                    known.add(needed[0])
                    waiting.append(needed)


def _came_from(line: Line, index: Index | None) -> tuple[list[Element], list[str]]:
    shape = getattr(line.value, "shape", ()) if index else ()
    elements: dict[Line, Index | None] = {}
    inputs: dict[str, None] = {}
    for argument in line.arguments.values():
        number: Any = argument
        link = link_of(argument)
        if index and getattr(argument, "shape", ()) == shape:
            number, link = number[index], _part(number, index) or link
        sources = leaves(link)
        entering = [leaf for leaf in sources if isinstance(leaf, Line)]
        if len(entering) > 1:
            entering = [leaf for leaf in entering if _holds(leaf, number)] or entering
        for leaf in entering:
            if leaf not in elements:
                elements[leaf] = _index(leaf, number, index)
        inputs |= dict.fromkeys(leaf for leaf in sources if isinstance(leaf, str))
    return list(elements.items()), list(inputs)


def _part(array: Any, index: Index) -> Link | None:
    """The link of one element, where an array knows those of its elements."""
    parts = getattr(array, "parts", ())
    return parts[index[0]] if parts else None


def _holds(line: Line, number: Any) -> bool:
    """Whether a line gives this number, alone or among others."""
    value = line.value
    if getattr(number, "ndim", 0) or not isinstance(number, (int, float, complex)):
        return False
    return value == number if not isinstance(value, np.ndarray) else number in value


def _index(line: Line, number: Any, index: Index | None) -> Index | None:
    """The element of a line that is this number: the one at the same place, else the first that is equal."""
    value = line.value
    if (
        not isinstance(value, np.ndarray)
        or value.size < 2
        or np.ndim(number)
        or not isinstance(number, (int, float, complex))
    ):
        return None
    if index and len(index) == value.ndim and all(i < n for i, n in zip(index, value.shape)) and value[index] == number:
        return index
    equal = np.argwhere(value == number)
    return tuple(equal[0].tolist()) if len(equal) else None


# --- the context

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
    # the same results with their texts as data, if `results` are said in a language already
    original: Results | None = None
    logo: Logo | None = None
    made: dict[str, str] = field(default_factory=versions)  # with which versions
    drive: Picked | None = None  # of the front that the design is one drive of
    runs: RunResults | None = None  # of the bench, at whose nodes the design was solved
    fits: dict[str, DesignFit | Text] = field(default_factory=dict)  # those that are made, by their names
    shaft: str = ""  # the one of several that is in view, with ids that do not say its name
    figures: int = 0
    chapter: str = ""  # key of the step whose chapter is being made
    ranges: set[str] = field(default_factory=set)  # chapters that say how a long list of numbers is written
    symbols: dict[tuple[str, str, str], Symbol] = field(default_factory=dict)  # of each chapter, as they are set
    # chapter and symbol → what the value or input is called
    labels: dict[tuple[str, str], list[tuple[str, str]]] = field(default_factory=dict)
    # source, as the formula or check has it → titles of the steps that use it
    sources: dict[str, list[str]] = field(default_factory=dict)
    cited: set[str] = field(default_factory=set)  # those of what stands in the report
    origins: Origins = field(default_factory=Origins)
    words: dict[str, str] = field(init=False)  # the report's own, in its language
    _chains: Chains | None = None
    _values: dict[str, Published] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.words = {key: self.say(text) for key, text in WORDS.items()}

    def text(self, key: str, /, n: float | None = None, **parts: Part) -> str:
        """A sentence of the report with its parts, in its language; `n`: the count of one that depends on it."""
        template, singular = WORDS[key].template, WORDS[key].one
        return self.say(Text(template, **parts) if n is None else plural(singular, template, n=n, **parts))

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

    # --- several shafts: what is of all of them together, and each that is no twin in view

    @property
    def shafts(self) -> tuple[str, ...]:
        """The names of several that all stand in ids; none where there is one, or one in view."""
        names = tuple(shaft.name for shaft in self.design.shafts)
        return names if len(names) > 1 and not self.shaft else ()

    def title(self, step: Step) -> str:
        """What a step is called: that of several shafts by these."""
        if step.key != OF_SHAFTS[0]:
            return self.say(step.title)
        if self.shaft:
            return self.say(Text("Balance shaft"))
        return self.say(described(Design.shafts).label if self.shafts else step.title)

    def values_of(self, step: Step) -> list[Published]:
        """The values of a step that stand where this is told."""
        return [v for id, v in self.values.items() if id == v.id and id.startswith(f"{step.key}.") and self.tells(id)]

    def in_view(self, name: str) -> Context:
        """The same with one of the shafts in view: what it gives and what is asked of it, without its name."""
        original = (self.original or self.results).view(name)
        original = original.whole() if self.audit else original
        spoken = {step: said(original.outcomes[step], self.say) for step in OF_SHAFTS if step in original.outcomes}
        view = replace(original, outcomes=self.results.outcomes | spoken)
        return replace(self, results=view, original=original, shaft=name, _chains=None, _values={})

    def tells(self, id: str) -> bool:
        """Whether a value or check stands where this is told: of a step that each shaft has for itself, what is of
        one of them stands with that one."""
        step, name, *_ = f"{id}.".split(".")
        return step not in OF_SHAFTS or name not in self.shafts

    def asks(self, key: str) -> bool:
        """The same of an input, by its shaft's name or place; those of a twin stand with its original's."""
        table, name, *_ = f"{key}.".split(".")
        of_one = ""
        if table == dotted(Design.shafts):
            shafts = list(map(as_table, as_list(self.document.data.get(table))))
            of_one = str(shafts[int(name)].get("name", "")) if name.isdecimal() else name
        if self.shaft:
            return of_one in [shaft.name for shaft in self.results.design.shafts]
        return not self.shafts or not of_one

    def whole_id(self, id: str) -> str:
        """The id of a value or check as the whole design has it."""
        step, _, rest = id.partition(".")
        return dotted(step, self.shaft, rest) if self.shaft and step in OF_SHAFTS else id

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
        return [
            (n, step, self.results.outcomes[step.key])
            for n, step in enumerate(STEPS, 1)
            if step.key in self.results.outcomes
        ]

    def cite(self, source: str, step: Step, *, stands: bool = True) -> str:
        """Note that a step uses a source, and whether what it says stands in this report; gives it in the report's
        language."""
        used = self.sources.setdefault(source, [])
        if (title := self.title(step)) not in used:
            used.append(title)
        if stands:
            self.cited.add(source)
        return self.say(source)

    def belongs(self, id: str) -> list[str]:
        """What a value or check belongs to: `bearings.front.film_edge` → ["front"], in the report's language."""
        return [self.say(word) for word in belongs(id)]

    def number(self, outcome: Outcome[object]) -> list[tuple[int, Curve]]:
        """The curves of a step with the numbers of their figures, one for a whole stack: all of them for an audit, else
        the main ones."""
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
        return judged(check)


def _main_curves(outcome: Outcome[object]) -> list[Curve]:
    """The curves of a step that a short report has, in its order.  Where the step makes them apart, the others are not
    made: some take long."""
    first: dict[int, Curve] = {}
    for curve in tuple(outcome.key_curves) or outcome.curves:
        if curve.short:
            first.setdefault(curve.short, curve)
    return [first[place] for place in sorted(first)]


def near(check: Check) -> bool:
    """Whether a check is to be proven: a limit or caution that is passed over or can not be judged, or that is kept by
    at most a tenth."""
    if check.kind not in ("limit", "caution"):
        return False
    return check.verdict != "pass" or not check.holds or (check.nearest[1] != 0 and check.margin <= NEAR)


def stands(check: Check) -> bool:
    """Whether a check has a line of its own in the engineer's report: advice and what concerns the method do where they
    are passed over."""
    return check.open or check.kind in ("limit", "caution")
