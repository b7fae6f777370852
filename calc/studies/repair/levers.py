# SPDX-License-Identifier: Apache-2.0
"""What may be moved for a finding, how numbers move together, and what a change is called in the words of the trade.

Which inputs are free, which are asked for and what their changes are called stands where they are declared."""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from math import copysign, isclose

from ...countershaft.inputs import ShaftInputs
from ...countershaft.rows import BearingRow
from ...design.addresses import Table, address, as_list, quantities, quantity_of, value_at, within
from ...design.model import Design, step_of
from ...design.names import published
from ...design.toml_file import Document
from ...gears.wheel_inputs import Wheel
from ...sheet.check import Check
from ...sheet.errors import BadInput
from ...sheet.quantity import ChangeWords, Quantity, described, dotted
from ...sheet.remedy import Changes, digits, whole
from ...sheet.search import rounded
from ...sheet.text import Small, Text
from .state import RepairState

# --- what kind of remedy a changed input is


def kind_of(document: Document, key: str) -> tuple[str, ...]:
    """Keys of one kind are of one step and have their words in common; a key without words is a kind of its own."""
    words = quantity_of(document.data, key).change
    kind = (words.less, words.more, words.other)
    return (step_of(key, judged=dotted(Design.bearings) in document.data), *kind) if any(kind) else (key,)


ALONG = tuple(dotted(field) for field in (BearingRow.position, BearingRow.slope))  # inputs of all bearings of a shaft


def place_of(key: str) -> str:
    """The table whose keys move together; where its bearings stand, and their slopes, are of the shaft."""
    place, _, last = key.rpartition(".")
    return place.rpartition(".")[0] if last in ALONG else place


def is_position(key: str) -> bool:
    return key.rpartition(".")[2] == ALONG[0]


def together(keys: Iterable[str]) -> Iterable[list[str]]:
    """Keys that are moved as one: the places of the bearings of a shaft; any other alone."""
    groups: dict[str, list[str]] = {}
    for key in keys:
        groups.setdefault(place_of(key) if is_position(key) else key, []).append(key)
    return groups.values()


def axes_of_pair(design: Design, key: str) -> list[str]:
    """The keys of the given axes that move with that of a shaft, so that mirror images stay such; none of another
    key."""
    table, _, last = key.rpartition(".")
    if last != dotted(ShaftInputs.axis):
        return []
    shaft = next((shaft for shaft in design.shafts if dotted(Design.shafts, shaft.name) == table), None)
    original = shaft.mirrors or shaft.name if shaft is not None else ""
    pair = [one for one in design.shafts if original in (one.name, one.mirrors) and one.axis is not None]
    return [dotted(Design.shafts, one.name, ShaftInputs.axis) for one in pair]


def words_of(document: Document, key: str) -> ChangeWords:
    """What a change of a key is called: where its field says nothing, by its label."""
    about = quantity_of(document.data, key)
    if len(kind_of(document, key)) > 1:
        return about.change
    label = Small(about.label)
    return ChangeWords(
        Text("smaller {label}", label=label), Text("larger {label}", label=label), Text("another {label}", label=label)
    )


def called(document: Document, changes: Changes, key: str, now: object) -> Text:
    """The words for changes, by one of them and what stands there now; of several numbers, and of the places of
    bearings, by how far they reach, else by the first that changes."""
    words, new = words_of(document, key), changes[key]
    if is_position(key):
        there = [other for other, _ in quantities(document.data) if is_position(other)]
        together = {other: value_at(document.data, other) for other in there if place_of(other) == place_of(key)}
        now, new = list(together.values()), [changes.get(other, z) for other, z in together.items()]
    olds, news = ([x for x in as_list(value) if isinstance(x, (int, float))] for value in (now, new))
    if not olds or len(olds) != len(news):
        return words.other or words.less
    pairs = [(max(olds) - min(olds), max(news) - min(news)), *zip(olds, news)]
    old, value = next((pair for pair in pairs if not isclose(*pair)), pairs[-1])
    return words.less if value < old else words.more


# --- which keys


def named_keys(state: RepairState, checks: Iterable[Check]) -> list[str]:
    """Keys that the remedies of checks change, then those that move them; of a table the numbers in it."""
    checks, data = tuple(checks), state.document.data
    keys = [key for check in checks for remedy in check.remedies for key, _ in remedy.changes]
    keys += [key for check in checks for key in check.moved_by]
    keys = [next(iter(axes_of_pair(state.design, key)), key) for key in keys]
    numbers = [key for key, about in quantities(data) if about.kind in NUMBERS]
    inner = {key: [number for number in numbers if number.startswith(f"{key}.")] for key in keys}
    return list(dict.fromkeys(each for key in keys for each in inner[key] or [key] * _is_there(data, key)))


def _is_there(data: Table, key: str) -> bool:
    """Whether a value can stand there; a table without numbers has none."""
    try:
        return bool(address(data, key))
    except BadInput:
        return False


def free_keys(state: RepairState, step: str, checks: Iterable[Check]) -> tuple[list[str], list[str]]:
    """Keys of numbers of a step that its maker is free to move: those in the same bearing, mesh or wheel as the checks,
    and all others, with the places of bearings, which move together."""
    ids = [state.design.of_original(check.id) for check in checks]  # what a twin has is moved with its original
    shafts = {state.design.shaft_of(id) for id in ids}
    near = {word for id in ids for word in id.split(".")[1 + bool(state.design.shaft_of(id))].split("_")}
    free = [
        key
        for key, about in quantities(state.document.data)
        if about.repair == "free"
        and about.kind in NUMBERS
        and state.design.step_of(key) == step
        and ("" in shafts or state.design.shaft_of(key) in shafts | {""})
    ]
    beside = [key for key in free if not is_position(key) and near & set(within(key))]
    return beside, [key for key in free if key not in beside]


# --- numbers as a workshop writes them

GRIDS = {
    "mm": 0.1, "µm": 1.0, "°": 0.1, "kg": 0.001, "g": 1.0, "N·m": 0.1, "bar": 0.1, "K": 1.0, "°C": 1.0, "%": 1.0,
    "HV": 10.0, "MPa": 1.0, "N": 1.0, "rpm": 10.0,
}  # fmt: skip
COARSE = 0.05  # of a number: a grid that its field does not say itself is no coarser
FINER = 0.1  # of the grid, where no number on it will do


def grid(about: Quantity, now: float) -> float | None:
    """What numbers of a field are multiples of, in its unit: the step of the field, else what is usual for the unit."""
    if about.step is not None:
        return about.step
    step = GRIDS.get(about.unit)
    while step is not None and now and step > COARSE * abs(now) * (1 + 1e-9):
        step /= 10
    return step


def on_grid(about: Quantity, now: float, number: float, finer: float = 1.0) -> float:
    """The number on the grid of its field that is next to it, seen from what stands there now."""
    step = grid(about, now)
    if about.kind in ("integer", "integers") or step is None or number == now:
        return number
    step *= finer
    n = math.ceil(number / step - 1e-6) if number > now else math.floor(number / step + 1e-6)
    return round(n * step) if isinstance(number, int) else digits(n * step)


def settled(document: Document, changes: Changes) -> Changes:
    """Changes with their numbers on the grids of their fields."""
    written: Changes = {}
    for key, new in changes.items():
        about, now = quantity_of(document.data, key), value_at(document.data, key)
        olds, news = ([x for x in as_list(value) if isinstance(x, (int, float))] for value in (now, new))
        if about.kind in NUMBERS and len(olds) == len(news) == len(as_list(new)) > 0:
            numbers = [on_grid(about, a, b) for a, b in zip(olds, news)]
            written[key] = numbers if isinstance(new, (list, tuple)) else numbers[0]
        else:
            written[key] = new
    return written


# --- numbers that move together

NUMBERS = ("number", "integer", "series")
ALLOWANCE = 100.0  # µm off a span: what a change of it is measured against
CLEARANCES = (described(BearingRow.clearance), described(BearingRow.clearance_factor))
SPAN = described(Wheel.span_allowance)


@dataclass(frozen=True)
class Lever:
    """Inputs that move together, by the number of the first: where it stands, its description, and all changes for
    another number."""

    now: float
    about: Quantity
    write: Callable[[float], Changes]
    scale: float  # what a change counts against
    settle: Callable[[Changes], Changes] = lambda changes: changes  # the numbers beside it as a workshop writes them

    def at(self, number: float) -> Changes | None:
        """None where the input does not allow the number."""
        return self.write(number) if self.about.allows(number) else None

    def offered_at(self, number: float) -> Changes | None:
        """The same as it is offered."""
        changes = self.at(number)
        return None if changes is None else self.settle(changes)

    @property
    def step(self) -> float:
        """The least relative change."""
        return 1 / self.scale if self.about.kind == "integer" else 0.0

    def number(self, change: float) -> float:
        """The number after a relative change; whole where it is whole, and another one than now."""
        off = change * self.scale
        if self.about.kind == "integer" or (self.about.unit == "µm" and abs(off) < 1.0 and self.scale >= 50.0):
            off = copysign(max(1.0, round(abs(off))), off)
        return self.now + off

    def offered(self, *numbers: float) -> list[float]:
        """Numbers as a workshop writes them, none of them nearer to that of now than before; the last one on a finer
        grid as well."""
        written = [on_grid(self.about, self.now, x) for x in numbers]
        return list(dict.fromkeys([*written, on_grid(self.about, self.now, numbers[-1], FINER)]))

    def short_of(self, number: float) -> float:
        """The number on the grid that lies nearer to that of now; the number itself where there is none."""
        step = grid(self.about, self.now)
        if step is None or self.about.kind == "integer":
            return number
        n = math.floor(number / step + 1e-6) if number > self.now else math.ceil(number / step - 1e-6)
        nearer = digits(n * step)
        return nearer if (nearer - self.now) * (number - self.now) > 0 else number

    def rounded(self, low: float, high: float) -> float:
        """The number of the fewest digits between two relative changes, but for the first of them."""
        start, end = self.number(low), self.number(high)
        return end if self.about.kind == "integer" or start == end else rounded(start, end)


def levers(state: RepairState, keys: list[str]) -> Iterator[Lever]:
    """Of the keys of one kind in one place: what moves all of them, and other ways to do so."""
    keys = axes_of_pair(state.design, keys[0]) or keys
    key, data = keys[0], state.document.data
    about, given, place = quantity_of(data, key), value_at(data, key), place_of(key)
    if about.kind not in NUMBERS or about.repair == "asked":
        return
    if about in CLEARANCES:
        yield from _clearance(state, place)
        return
    numbers = {name: [float(x) for x in as_list(value_at(data, name)) if isinstance(x, (int, float))] for name in keys}
    if given is None and (chosen := published(state.results, key)) is not None and chosen.unit == about.unit:
        numbers[key] = [digits(chosen.shown, 6)]
    numbers = {name: some for name, some in numbers.items() if some}
    if key not in numbers:
        return
    now, alone = numbers[key][0], not isinstance(given, list) and not is_position(key)
    if about is SPAN:
        yield Lever(now, about, lambda x: {key: [whole(round(n + x - now)) for n in numbers[key]]}, ALLOWANCE)
    elif about.kind == "integer" and alone:
        yield Lever(now, about, lambda x: {key: round(x)}, max(abs(now), 1.0))
    elif now:
        yield from _scaled(state, numbers, key, about)
    elif alone:
        yield Lever(now, about, lambda x: {key: digits(x)}, 10 * (about.step or 0.1))


def _scaled(state: RepairState, numbers: Mapping[str, list[float]], key: str, about: Quantity) -> Iterator[Lever]:
    """All in one proportion; a journal that grows outwards, away from the masses; a core for which the slope is that of
    the bending."""
    data, now = state.document.data, numbers[key][0]
    lists = {name for name in numbers if isinstance(value_at(data, name), list)}

    def write(x: float) -> Changes:
        scaled = {name: [digits(n * x / now, 6) for n in some] for name, some in numbers.items()}
        return {name: some if name in lists else some[0] for name, some in scaled.items()}

    def settle(changes: Changes) -> Changes:
        others = [name for name in numbers if name != key or name in lists]
        return changes | settled(state.document, {name: changes[name] for name in others})

    if about is described(ShaftInputs.core_radius) and (slopes := given_slopes(state.view(key))):
        yield Lever(now, about, lambda x: write(x) | dict.fromkeys(slopes), abs(now), settle)
        return
    yield Lever(now, about, write, abs(now), settle)
    if about is described(BearingRow.length) and (outer := outwards(state, key, now)) is not None:
        yield Lever(now, about, lambda x: write(x) | outer(x), abs(now), settle)


def given_slopes(design: Design) -> list[str]:
    """The keys of the slopes that stand for those of the shaft's bending."""
    rows = [row for row in design.rows if row.slope is not None and design.countershaft is not None]
    return [design.own_key(ShaftInputs.bearings, row.name, BearingRow.slope) for row in rows]


def outwards(state: RepairState, key: str, now: float) -> Callable[[float], Changes] | None:
    """Where a bearing at the end of the shaft stands when its inner end stays and its length becomes another."""
    data, place = state.document.data, key.rpartition(".")[0]
    view = state.view(key)
    if view.countershaft is None or len(view.rows) != 2:
        return None
    there = dotted(place, BearingRow.position)
    z = value_at(data, there)
    if not isinstance(z, (int, float)):
        return None
    side = -1.0 if place.endswith(f".{view.rows[0].name}") else 1.0
    return lambda x: {there: digits(z + side * (x - now) / 2, 6)}


def _clearance(state: RepairState, place: str) -> Iterator[Lever]:
    """In micrometres, in place of the factor where that is given."""
    data, key = state.document.data, dotted(place, BearingRow.clearance)
    if (there := published(state.results, key)) is None:
        return
    factor = dotted(place, BearingRow.clearance_factor)
    gone: Changes = {} if value_at(data, factor) is None else {factor: None}
    now = float(f"{there.shown:.4g}")
    yield Lever(now, quantity_of(data, key), lambda x: gone | {key: digits(x)}, now)


def disturbance(document: Document, changes: Changes) -> float:
    """How much changes change: the sum of the relative changes of their numbers, and a half for a word; what moves
    along a shaft is one change, the largest."""
    along: dict[str, float] = {}
    for key, new in changes.items():
        olds, news = as_list(value_at(document.data, key)), as_list(new)
        span = quantity_of(document.data, key) is SPAN
        pairs = [(a, b) for a, b in zip(olds, news) if isinstance(a, (int, float)) and isinstance(b, (int, float))]
        off = [abs(b - a) / (ALLOWANCE if span else abs(a) or 1.0) for a, b in pairs]
        much = max(off) if off else 0.5 if isinstance(new, str) else 0.05
        last = key.rpartition(".")[2]
        one = dotted(place_of(key), last) if last in ALONG else key
        along[one] = max(along.get(one, 0.0), much)
    return sum(along.values())
