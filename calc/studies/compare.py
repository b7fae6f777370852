# SPDX-License-Identifier: Apache-2.0
"""Two designs side by side: the inputs that differ, the verdicts of the steps, and the checks and values that differ.

Nothing is solved here.  A and B change places without changing what is found: every measure of a difference is
symmetric."""

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, TypeVar

from ..countershaft.inputs import ShaftInputs
from ..design.addresses import Table, as_list, as_table
from ..design.key_results import is_least, judged, key_results
from ..design.model import STEPS, Design, step_of
from ..design.unusual import told, unusual
from ..gears.drive.result import IDLE
from ..sheet.check import ORDER, Check
from ..sheet.quantity import Published, Quantity, described, dotted, keys
from ..sheet.record import replace
from ..sheet.step import OF_SHAFTS
from ..sheet.text import EMPTY, Name, Text
from ..sheet.verdict import Counts, design_state, step_state

if TYPE_CHECKING:
    from ..solve import Results


# --- the inputs that differ between two design files, key by key

BEHIND: tuple[object, ...] = (  # stand behind what is calculated with
    Design.accepted,
    Design.without,
    Design.locked,
    Design.oil,
    Design.material,
    Design.schema,
    Design.name,
    Design.note,
    Design.author,
    Design.checker,
    Design.revision,
    Design.date,
    Design.document,
)
LAST = tuple(map(dotted, BEHIND))
T = TypeVar("T")


@dataclass(frozen=True)
class InputDifference:
    """One key, as the two files have it; None: left out.  A table that only one of them has is one difference, and so
    is an element."""

    key: str  # elements of arrays by name, else by index, as everywhere
    label: Text
    unit: str
    a: object
    b: object
    within: str = ""  # what the element is called that the key has by its index: a mesh by its wheels

    @property
    def step(self) -> str:
        return step_of(self.key, judged=True)


def inputs(a: Table, b: Table) -> list[InputDifference]:
    """The keys that differ between the tables of two design files: the steps in their order, then what only names or
    explains."""
    differences = list(_keys(Design, a, b, ""))
    return sorted(differences, key=lambda d: LAST.index(d.step) + 1 if d.step in LAST else 0)


def _keys(cls: type, a: Table, b: Table, prefix: str, within: str = "") -> Iterator[InputDifference]:
    for key, known in keys(cls).items():
        about, mine, theirs = known.about, a.get(key), b.get(key)
        if mine is theirs or mine == theirs:
            continue
        here = f"{prefix}{key}"
        if about.kind == "tables":
            theirs = _renamed(as_list(mine), as_list(theirs)) if about is SHAFTS else as_list(theirs)
            yield from _elements(about, as_list(mine), theirs, here, within)
        elif about.kind == "reasons":
            first, other = as_table(mine), as_table(theirs)
            for id in first | other:
                if first.get(id) != other.get(id):
                    yield InputDifference(f"{here}.{id}", about.label, "", first.get(id), other.get(id))
        elif about.kind == "table" and mine is not None and theirs is not None:
            assert about.table is not None
            yield from _keys(about.table, as_table(mine), as_table(theirs), f"{here}.", within)
        elif _plain(about, mine) != _plain(about, theirs):
            yield InputDifference(here, about.label, about.unit, mine, theirs, within)


def _plain(about: Quantity, content: object) -> object:
    """One number stands for a list of one, and a choice may look like a number."""
    if content is None:
        return None
    if about.kind in ("series", "integers"):
        return as_list(content)
    return str(content) if about.kind in ("choice", "date") else content


def _elements(about: Quantity, a: list[object], b: list[object], here: str, within: str) -> Iterator[InputDifference]:
    """The elements of two arrays of tables, matched by name, else by index."""
    assert about.table is not None
    if not a or not b:
        if a or b:
            yield InputDifference(here, about.label, "", a or None, b or None, within)
        return
    mine, theirs = _named(a), _named(b)
    for name in united(mine, theirs):
        first, other = mine.get(name), theirs.get(name)
        if first is not None and other is not None:
            called = _called(first) if _called(first) == _called(other) else ""
            yield from _keys(about.table, first, other, f"{here}.{name}.", called)
        else:
            label = Text("{label}: {name}", label=about.label, name=name)
            yield InputDifference(f"{here}.{name}", label, "", first, other, within)


def _named(items: list[object]) -> dict[str, Table]:
    return {str(item.get("name", n)): item for n, item in enumerate(map(as_table, items))}


# --- shafts that have other names in the other design

SHAFTS = described(Design.shafts)


def matched(a: list[object], b: list[object]) -> dict[str, str]:
    """The shafts of B by what those of A are called: of the same name, else of the same ratio on the same side."""
    mine, theirs = _placed(a), _placed(b)
    names = {name: name for name in theirs if name in mine}
    for name, place in theirs.items():
        free = [other for other, there in mine.items() if there == place and other not in names.values()]
        if name not in names and free:
            names[name] = free[0]
    return names


def _placed(shafts: list[object]) -> dict[str, tuple[float, float]]:
    """How fast each shaft turns, and on which side of the crank, 0: it is not known."""
    places: dict[str, tuple[float, float]] = {}
    for name, shaft in _named(shafts).items():
        original = places.get(str(shaft.get(dotted(ShaftInputs.mirrors), shaft.get(dotted(ShaftInputs.repeats), ""))))
        ratio, side = shaft.get(dotted(ShaftInputs.speed_ratio), -1.0), 0.0
        if original is not None:
            turned = -1.0 if dotted(ShaftInputs.mirrors) in shaft else 1.0
            ratio, side = turned * original[0], turned * original[1]
        axis = as_list(shaft.get(dotted(ShaftInputs.axis)))
        if len(axis) == 2 and isinstance(axis[1], (int, float)):
            side = float(axis[1] > 0) - float(axis[1] < 0)
        places[name] = float(ratio) if isinstance(ratio, (int, float)) else 0.0, side
    return places


def _renamed(a: list[object], b: list[object]) -> list[object]:
    """The shafts of B under the names of those of A."""
    names = matched(a, b)
    return [{**as_table(shaft), dotted(ShaftInputs.name): names.get(name, name)} for name, shaft in _named(b).items()]


def _ids(a: "Results", b: "Results", names: dict[str, str]) -> tuple[Callable[[str], str], Callable[[str], str]]:
    """What the ids of A and of B are called where they are compared: by the names that the shafts have in A, of which
    none stands in an id where one of the designs has one shaft."""
    alone = min(len(a.design.shafts), len(b.design.shafts)) == 1

    def named(design: Design, known: dict[str, str], id: str) -> str:
        step, _, rest = id.partition(".")
        name, _, rest = rest.partition(".")
        if len(design.shafts) < 2 or name not in known:
            return id
        if step in OF_SHAFTS and alone:
            return f"{step}.{rest}"
        return f"{step}.{known[name]}.{rest}" if step in (*OF_SHAFTS, dotted(Design.gears)) and not alone else id

    own = {name: name for name in names.values()}
    return partial(named, a.design, own), partial(named, b.design, names)


def _called(item: Table) -> str:
    """What an element without a name is known by: a mesh by its wheels, in the direction of power."""
    return f"{item['driver']}–{item['driven']}" if {"driver", "driven"} <= item.keys() else ""


def united(a: Iterable[T], b: Iterable[T]) -> list[T]:
    """What is in either, in an order that does not depend on which comes first."""
    first, second = list(a), list(b)
    shared = set(first) & set(second)
    rest = [x for x in (*first, *second) if x not in shared]
    return [*(x for x in first if x in shared), *sorted(rest, key=str)]


# --- the whole comparison

EQUAL = Text("The two designs are equal: no input, verdict, check or value differs.")
# results that differ by less, of the larger one, are the same: iterations end somewhere, and nobody reads further
SAME = 1e-6
# what is less than this share of the largest number of its unit in its step is what is left of a sum that is zero
NOTHING = 1e-13
RANKS = (*ORDER[: ORDER.index("note")], "outside", *ORDER[ORDER.index("note") :])  # of the verdicts, from good to bad
NOTABLE = 1e-3  # a key result that differs by less is neither better nor worse


@dataclass(frozen=True)
class Judged:
    """The verdict of a step, and how many of its checks stand behind it; `unaccepted`: its verdict if nothing were
    accepted."""

    verdict: str
    counts: Counts
    reason: Text = EMPTY
    unaccepted: str = ""


@dataclass(frozen=True)
class StepVerdicts:
    """One step in both designs."""

    step: str
    title: Text
    a: Judged
    b: Judged

    @property
    def moved(self) -> bool:
        return self.a.verdict != self.b.verdict


@dataclass(frozen=True)
class CheckDifference:
    """A check whose verdict, value or limit differs, or that only one design has (None: the other).

    `before`, `after`: its verdicts in A and in B; "outside": it holds, by a formula outside its validity.
    """

    id: str
    a: Check | None
    b: Check | None
    relative: float  # of value or limit, whichever differs more
    before: str
    after: str

    @property
    def step(self) -> str:
        return self.id.partition(".")[0]

    @property
    def name(self) -> Text:
        either = self.b or self.a
        return either.name if either else Name(self.id)

    @property
    def both(self) -> bool:
        return self.a is not None and self.b is not None

    @property
    def moved(self) -> bool:
        """Both designs have it, and judge it differently."""
        return self.both and self.before != self.after

    @property
    def worse(self) -> bool:
        """B is judged worse than A; a check that only one design has, where it does not pass."""
        if self.both:
            return RANKS.index(self.after) > RANKS.index(self.before)
        return RANKS.index(self.before or self.after) > RANKS.index("accepted")

    @property
    def accepted(self) -> bool:
        """Found of one kind in both, whatever its size; somebody accepts it, or does not any more."""
        findings = {check.finding for check in (self.a, self.b) if check is not None}
        return self.moved and len(findings) == 1 and not self.beyond

    @property
    def beyond(self) -> bool:
        """It holds by a formula outside its validity in one of the designs."""
        return "outside" in (self.before, self.after)


@dataclass(frozen=True)
class ValueDifference:
    """A result that differs, or that only one design has (None: the other)."""

    id: str
    label: Text
    unit: str
    a: float | None
    b: float | None
    relative: float  # to the larger of the two; of a phase, to half a turn

    @property
    def step(self) -> str:
        return self.id.partition(".")[0]

    @property
    def both(self) -> bool:
        return self.a is not None and self.b is not None

    @property
    def phase(self) -> bool:
        return _is_phase(self.id, self.unit)


@dataclass(frozen=True)
class KeyResult:
    """One of the results that a design is known by, of each design at the part where it is worst."""

    a: Published | None  # None: the design has none
    b: Published | None
    least: bool  # the more of it the better
    relative: float

    @property
    def either(self) -> Published:
        published = self.b or self.a
        assert published is not None
        return published

    @property
    def better(self) -> bool | None:
        """Whether B is better than A; None: neither, or only one has it."""
        if self.a is None or self.b is None or not self.relative > NOTABLE:
            return None
        return (self.b.shown > self.a.shown) == self.least


@dataclass(frozen=True)
class Comparison:
    """What differs.  Checks and values: step by step, first those of both designs by the size of the difference, then
    those of one."""

    inputs: tuple[InputDifference, ...]
    verdicts: tuple[StepVerdicts, ...]  # of every step
    # of a step those first whose verdict has moved; of those of one design those that do not pass
    checks: tuple[CheckDifference, ...]
    values: tuple[ValueDifference, ...]
    results: tuple[KeyResult, ...] = ()  # of either design, whether they differ or not
    unusual: tuple[Text, Text] = (EMPTY, EMPTY)  # the inputs of A and of B that are not usual
    whole: tuple[str, str] = ("pass", "pass")  # the state of each design
    unaccepted: tuple[str, str] = ("pass", "pass")  # its state if nothing were accepted
    words: tuple[Text, Text] = (EMPTY, EMPTY)  # its state and what is open
    strikes: tuple[float, float] | None = None  # at idle, the largest force of the teeth in N, of one engine twice

    @property
    def equal(self) -> bool:
        return not (self.inputs or self.steps_moved or self.checks or self.values)

    @property
    def steps_moved(self) -> tuple[StepVerdicts, ...]:
        return tuple(v for v in self.verdicts if v.moved)

    @property
    def steps_shared(self) -> frozenset[str]:
        """The steps that both designs ask for."""
        return frozenset(v.step for v in self.verdicts if "not_asked" not in (v.a.verdict, v.b.verdict))

    @property
    def checks_moved(self) -> tuple[CheckDifference, ...]:
        return tuple(c for c in self.checks if c.moved)

    @property
    def checks_lone(self) -> tuple[CheckDifference, ...]:
        """Of one design only, in a step that both have, and not passed."""
        return tuple(c for c in self.checks if not c.both and c.worse and c.step in self.steps_shared)

    @property
    def checks_kept(self) -> tuple[CheckDifference, ...]:
        """Of both designs with the same verdict, at another value or limit."""
        return tuple(c for c in self.checks if c.both and not c.moved)

    @property
    def only_accepted(self) -> bool:
        """The verdict as a whole differs by what is accepted alone."""
        return self.whole[0] != self.whole[1] and self.unaccepted[0] == self.unaccepted[1]


def compare(a: Table, b: Table, results_a: "Results", results_b: "Results", same: float = SAME) -> Comparison:
    """Compare two designs: the tables of their files, and what they gave."""
    key = dotted(Design.shafts)
    ids = _ids(results_a, results_b, matched(as_list(a.get(key)), as_list(b.get(key))))
    return Comparison(
        tuple(inputs(a, b)),
        tuple(StepVerdicts(s.key, s.title, _judged(results_a, s.key), _judged(results_b, s.key)) for s in STEPS),
        tuple(_checks(results_a, results_b, same, ids)),
        tuple(_values(results_a, results_b, same, ids)),
        tuple(_key_results(results_a, results_b)),
        (_unusual(results_a), _unusual(results_b)),
        (results_a.verdict, results_b.verdict),
        (_unaccepted(results_a), _unaccepted(results_b)),
        (results_a.words(), results_b.words()),
        _strikes(results_a, results_b),
    )


def _strikes(a: "Results", b: "Results") -> tuple[float, float] | None:
    """What the teeth of both carry when they strike hardest at idle without load, by the high estimate, in N: a
    tendency of what is heard, of one engine only; None where it is another one, or where that is not known."""
    forces = []
    for results in (a, b):
        drive = results.train.drive if results.train is not None else None
        meshes = drive.meshes.values() if drive is not None and not drive.assumed else ()
        at = [mesh.operations[IDLE] for mesh in meshes if IDLE in mesh.operations]
        if not at:
            return None
        forces.append(max(float(mesh.impact_force) for mesh in at))
    return (forces[0], forces[1]) if _size(a.design) == _size(b.design) else None


def _size(design: Design) -> tuple[object, ...]:
    """By which two engines are told apart."""
    e = design.engine
    return () if e is None else (e.layout, e.strokes, e.cylinders, e.bore, e.crank_radius, e.rod_length, e.rated_speed)


# --- results


def _unusual(results: "Results") -> Text:
    return told(unusual(results.design, checks=results.checks()))


def _unaccepted(results: "Results") -> str:
    steps = [outcome.verdict for outcome in results.outcomes.values()]
    return design_state([replace(check, accepted="") for check in results.checks()], steps)


def _judged(results: "Results", step: str) -> Judged:
    outcome = results.outcomes[step]
    unaccepted = (
        step_state([replace(check, accepted="") for check in outcome.checks], computes=outcome.computes)
        if outcome.state == "solved"
        else outcome.verdict
    )
    return Judged(outcome.verdict, outcome.counts, outcome.reason, unaccepted)


Named = tuple[Callable[[str], str], Callable[[str], str]]  # what the ids of both designs are called


def _checks(a: "Results", b: "Results", same: float, ids: Named) -> list[CheckDifference]:
    differences: list[CheckDifference] = []
    for step in STEPS:
        mine, theirs = ({name(c.id): c for c in r.outcomes[step.key].checks} for r, name in zip((a, b), ids))
        either = (*mine.values(), *theirs.values())
        floors = size_of_nothing((c.unit, x) for c in either for x in (c.value, *_limits(c)))
        differ = []
        for id in united(mine, theirs):
            first, other = mine.get(id), theirs.get(id)
            verdicts = ["" if c is None else judged(c) for c in (first, other)]
            size = math.inf
            if first is not None and other is not None:
                numbers = zip((first.value, *_limits(first)), (other.value, *_limits(other)))
                size = max(relative(x, y, floors[first.unit]) for x, y in numbers)
            if size > same or verdicts[0] != verdicts[1] or (first and other and _kind(first) != _kind(other)):
                differ.append(CheckDifference(id, first, other, size, *verdicts))
        differences += sorted(differ, key=lambda d: (not d.moved, not d.both, -d.relative if d.both else not d.worse))
    return differences


def _kind(check: Check) -> tuple[str, str, str]:
    return check.kind, check.sense, check.unit


def _limits(check: Check) -> tuple[float, ...]:
    return check.limit if isinstance(check.limit, tuple) else (check.limit,)


def _values(a: "Results", b: "Results", same: float, ids: Named) -> list[ValueDifference]:
    differences: list[ValueDifference] = []
    for step in STEPS:
        mine, theirs = ({name(v.id): v for v in r.outcomes[step.key].values()} for r, name in zip((a, b), ids))
        floors = size_of_nothing((v.unit, v.shown) for v in (*mine.values(), *theirs.values()))
        differ = []
        for id in united(mine, theirs):
            first, other = mine.get(id), theirs.get(id)
            if first is None or other is None:
                size = math.inf
            elif _is_phase(id, first.unit):
                size = _turned(first, other, mine, theirs, floors)
            else:
                size = relative(first.shown, other.shown, floors[first.unit])
            either = other or first
            assert either is not None
            if size > same or (first is not None and first.unit != either.unit):
                a_shown, b_shown = (v.shown if v is not None else None for v in (first, other))
                differ.append(ValueDifference(id, either.label, either.unit, a_shown, b_shown, size))
        sums = {d.id for d in differ if not any(map(partial(_of_shaft, d.id), (a.design, b.design)))}
        differences += sorted(differ, key=lambda d: (d.id not in sums, not d.both, -d.relative if d.both else 0.0))
    return differences


def _of_shaft(id: str, design: Design) -> bool:
    """Whether a value is of one of several shafts, and not of what all of them give together."""
    step, _, rest = id.partition(".")
    several = len(design.shafts) > 1 and step in OF_SHAFTS
    return several and rest.partition(".")[0] in [shaft.name for shaft in design.shafts]


def _key_results(a: "Results", b: "Results") -> Iterator[KeyResult]:
    mine, theirs = a.values(), b.values()
    floors = {
        s.key: size_of_nothing((v.unit, v.shown) for r in (a, b) for v in r.outcomes[s.key].values()) for s in STEPS
    }
    ours, others = key_results(mine), key_results(theirs)
    for line in ours | others:
        first, other = ours.get(line), others.get(line)
        size = math.inf
        if first is not None and other is not None:
            if line[0] == dotted(Design.bearings) and first.about is not other.about:
                yield KeyResult(first, None, is_least(first), size)  # a film and a life stand in one line
                yield KeyResult(None, other, is_least(other), size)
                continue
            size = relative(first.shown, other.shown, floors[line[0]].get(first.unit, 0.0))
        yield KeyResult(first, other, any(v is not None and is_least(v) for v in (first, other)), size)


def _is_phase(id: str, unit: str) -> bool:
    return unit == "°" and id.endswith("_phase")


def _turned(
    a: Published, b: Published, mine: dict[str, Published], theirs: dict[str, Published], floors: dict[str, float]
) -> float:
    """Between two phases: the shorter way round, of half a turn.  Vectors of no length have none."""
    lengths = [vectors[vector] for vectors in (mine, theirs) if (vector := a.id.removesuffix("_phase")) in vectors]
    if lengths and all(abs(v.shown) <= floors[v.unit] for v in lengths):
        return 0.0
    return abs(turn(a.shown, b.shown)) / 180


def turn(a: float, b: float) -> float:
    """From one phase to another, in degrees, the shorter way."""
    return (b - a + 180) % 360 - 180


def size_of_nothing(numbers: Iterable[tuple[str, float]]) -> dict[str, float]:
    """By unit, the size up to which a number is nothing.  Numbers without a unit have nothing in common."""
    floors: dict[str, float] = {}
    for unit, number in numbers:
        size = abs(number) * NOTHING if unit and math.isfinite(number) else 0.0
        floors[unit] = max(floors.get(unit, 0.0), size)
    return floors


def relative(a: float, b: float, floor: float = 0.0) -> float:
    """How much two numbers differ, of the larger one: 0 where they are equal, or both nothing; 2 where only the sign
    differs."""
    if a == b or (math.isnan(a) and math.isnan(b)):
        return 0.0
    if not (math.isfinite(a) and math.isfinite(b)):
        return math.inf
    largest = max(abs(a), abs(b))
    return 0.0 if largest <= floor else abs(a - b) / largest
