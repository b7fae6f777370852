# SPDX-License-Identifier: Apache-2.0
"""What may be changed for a finding, kind by kind, and what each change is called in the words of the trade.

Numbers are moved, alone or together; words are changes that are tried as they are."""

import math
import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from fnmatch import fnmatchcase
from itertools import islice

from ...design.addresses import as_list, quantities, quantity_of, value_at
from ...design.locks import locked
from ...design.names import published
from ...design.toml_file import Document
from ...library.catalogue import Material
from ...sheet.check import Check
from ...sheet.errors import BadInput, NoSolution
from ...sheet.quantity import Quantity
from ...sheet.remedy import Changes, digits, whole
from ...sheet.search import allowed
from ...sheet.text import EMPTY, Small, Text
from . import sizing
from .single_input import ASKED, FREE
from .state import RepairState

# --- what kind of remedy a changed input is
# In the words of the trade: a smaller clearance, a longer journal, a thicker core.


@dataclass(frozen=True)
class Kind:
    """`less`, `more`: the words for a smaller and a larger number; `other`: for another word, or a number that is taken
    out."""

    less: Text
    more: Text
    other: Text = EMPTY


# Patterns of keys, the first that fits counts.  Keys of one row that stand in the same bearing, mass or mesh move
# together.
KINDS: tuple[tuple[str, Kind], ...] = (
    (r".*\.(front|rear)\.clearance_(um|factor)", Kind(Text("smaller clearance"), Text("larger clearance"))),
    (r"bearings\.(front|rear)\.length_mm", Kind(Text("shorter journal"), Text("longer journal"))),
    (r"bearings\.(front|rear)\.(journal|housing)_roughness_um", Kind(Text("smoother surfaces"),
    Text("rougher surfaces"))),
    (r"bearings\.(front|rear)\.diameter_mm", Kind(Text("smaller journal"), Text("larger journal"))),
    (r"bearings\.(journal|seat)_fit", Kind(Text("closer fits"), Text("wider fits"), Text("closer fits"))),
    (r"bearings\.slope_mrad", Kind(Text("smaller slope"), Text("larger slope"), Text("slope of the shaft's bending"))),
    (r"(bearings|friction)\.oil", Kind(Text("thinner oil"), Text("thicker oil"), Text("another oil"))),
    (r"bearings\.(hole_diameter|groove_width|pocket_width)_mm", Kind(Text("narrower oil supply"),
    Text("wider oil supply"))),
    (r"bearings\.supply_pressure_bar", Kind(Text("less oil pressure"), Text("more oil pressure"))),
    (r"bearings\.housing_material", Kind(EMPTY, EMPTY, Text("another housing"))),
    (r"gears\.(housing|support)_material", Kind(EMPTY, EMPTY, Text("another housing"))),
    (r"countershaft\.material", Kind(EMPTY, EMPTY, Text("another steel"))),
    (r"countershaft\.core_radius_mm", Kind(Text("thinner core"), Text("stiffer shaft"))),
    (r"countershaft\.fillet_radius_mm", Kind(Text("smaller fillet"), Text("larger fillet"))),
    (r"countershaft\.outer_radius_mm", Kind(Text("smaller envelope"), Text("larger envelope"))),
    (r"countershaft\.half_length_mm", Kind(Text("shorter shaft"), Text("longer shaft"))),
    (r"countershaft\.bearing_positions_mm", Kind(Text("shorter span"), Text("longer span"))),
    (r"countershaft\.masses\.[^.]+\.mass_kg", Kind(Text("lighter mass"), Text("heavier mass"))),
    (r"countershaft\.masses\.[^.]+\.radius_mm", Kind(Text("mass further in"), Text("mass further out"))),
    (r"countershaft\.masses\.[^.]+\.z_mm", Kind(Text("mass elsewhere"), Text("mass elsewhere"))),
    (r"countershaft\.masses\.[^.]+\.angle_deg", Kind(Text("mass turned"), Text("mass turned"))),
    (r"countershaft\.overdesign_percent", Kind(Text("less beyond what is asked"), Text("more beyond what is asked"))),
    (r"countershaft\.holes\.depth_mm", Kind(Text("shallower holes"), Text("deeper holes"))),
    (r"countershaft\.holes\.count", Kind(Text("fewer holes"), Text("more holes"))),
    (r"countershaft\.bolts\.torque_Nm", Kind(Text("less bolt torque"), Text("more bolt torque"))),
    (r"countershaft\.bolts\.head_diameter_mm", Kind(Text("smaller bolt heads"), Text("larger bolt heads"))),
    (r"countershaft\.bolts\.hole_diameter_mm", Kind(Text("closer bolt holes"), Text("wider bolt holes"))),
    (r"countershaft\.bolts\.count", Kind(Text("fewer bolts"), Text("more bolts"))),
    (r"countershaft\.support\.wall_mm", Kind(Text("thinner wall"), Text("thicker wall"))),
    (r"gears\.wheels\..*\.span_allowance_um", Kind(Text("thinner teeth"), Text("thicker teeth"))),
    (r"gears\.wheels\..*\.teeth", Kind(Text("fewer teeth"), Text("more teeth"))),
    (r"gears\.wheels\..*\.profile_shift", Kind(Text("less profile shift"), Text("more profile shift"))),
    (r"gears\.wheels\..*\.tip_shortening_mm", Kind(Text("smaller tip cut"), Text("larger tip cut"))),
    (r"gears\.wheels\..*\.tip_diameter_tolerance_um", Kind(Text("smaller tips"), Text("larger tips"))),
    (r"gears\.wheels\..*\.position_mm", Kind(Text("wheel elsewhere"), Text("wheel elsewhere"))),
    (r"gears\.wheels\..*\.runout_um", Kind(Text("less runout"), Text("more runout"))),
    (r"gears\.wheels\..*\.(gear_material|quality|hardness_HV)", Kind(Text("softer teeth"), Text("harder teeth"),
    Text("stronger teeth"))),
    (r"gears\.meshes\..*\.centre_distance_mm", Kind(Text("closer centres"), Text("wider centres"))),
    (r"gears\.meshes\..*\.tolerance_um", Kind(Text("closer tolerance"), Text("wider tolerance"))),
    (r"gears\.(wheels\..*\.)?face_width_mm", Kind(Text("narrower gears"), Text("wider gears"))),
    (r"gears\.normal_module_mm", Kind(Text("smaller module"), Text("larger module"))),
    (r"gears\.accuracy_grade", Kind(Text("better gear quality"), Text("lower gear quality"))),
    (r"gears\.tool_addendum", Kind(Text("shallower roots"), Text("deeper roots"))),
    (r"gears\.(flank|root)_rz_um|friction\.flank_roughness_um", Kind(Text("smoother flanks"), Text("rougher flanks"))),
    (r"engine\.flywheel_inertia_kgm2", Kind(Text("lighter flywheel"), Text("heavier flywheel"))),
    (r"engine\.rod_length_mm", Kind(Text("shorter rods"), Text("longer rods"))),
    (r"imbalance\.crank_balance_fraction", Kind(Text("lighter counterweights"), Text("heavier counterweights"))),
    (r"imbalance\.bob_mass_kg", Kind(Text("lighter bob"), Text("heavier bob"))),
)  # fmt: skip
CALLED = tuple((re.compile(pattern), kind) for pattern, kind in KINDS)


def row_of(key: str) -> int | None:
    """The row of the table that a key belongs to; None: it has none of its own."""
    return next((n for n, (pattern, _) in enumerate(CALLED) if pattern.fullmatch(key)), None)


def kind_of(document: Document, key: str) -> Kind:
    """Where the table has no words of its own, those of the field."""
    if (row := row_of(key)) is not None:
        return CALLED[row][1]
    label = Small(quantity_of(document.data, key).label)
    return Kind(
        Text("smaller {label}", label=label), Text("larger {label}", label=label), Text("another {label}", label=label)
    )


def called(document: Document, key: str, now: object, new: object) -> Text:
    """The words for one change; of several numbers those of the first that changes."""
    kind = kind_of(document, key)
    pairs = zip(now, new) if isinstance(now, list) and isinstance(new, list) else [(now, new)]
    for old, value in pairs:
        if isinstance(old, (int, float)) and isinstance(value, (int, float)) and old != value:
            return kind.less if value < old else kind.more
    return kind.other or kind.less


# --- what may be changed

# not moved as numbers
FIXED = re.compile(rf"{ASKED.pattern}|.*\.(slope_mrad|position_mm|firing_order|crank_angles_deg|speed_range_rpm)")
PLANS = 7  # kinds that are looked at
SETS = 12  # changes of one kind that are tried as they are
ALLOWANCE = 100.0  # µm off a span: what a change of it is measured against


@dataclass(frozen=True)
class Lever:
    """Inputs that move together, by the number of the first: where it stands, its description, and all changes for
    another number."""

    now: float
    about: Quantity
    write: Callable[[float], Changes]
    scale: float  # what a change counts against

    def at(self, number: float) -> Changes | None:
        """None where the input does not allow the number."""
        return self.write(number) if allowed(self.about, [number]) else None


@dataclass(frozen=True)
class LeverPlan:
    """One kind of remedy: its keys, what can be moved, what can be tried; `reason`: why its one key is locked."""

    keys: tuple[str, ...]
    levers: tuple[Lever, ...] = ()
    sets: tuple[Changes, ...] = ()
    reason: str = ""


def plans(state: RepairState, step: str, group: tuple[Check, ...]) -> list[LeverPlan]:
    """In the order in which a designer would think of them: what the checks themselves name, what moves them, what else
    is free."""
    by_kind: dict[int | str, LeverPlan] = {}
    tried = [*_named(group), *_made_for(state, group)]
    keys = [*(next(iter(changes)) for changes in tried), *_keys(state, step, group)]
    for key in dict.fromkeys(keys):
        kind = _kind(key)
        plan = by_kind.get(kind, LeverPlan(()))
        by_kind[kind] = replace(plan, keys=(*plan.keys, key))
    data = state.document.data
    shut = [
        LeverPlan((key,), reason=reason)
        for plan in by_kind.values()
        for key in plan.keys
        if (reason := locked(data, key))
    ]
    return [*shut, *islice(filter(None, (_filled(state, kind, plan, tried) for kind, plan in by_kind.items())), PLANS)]


def _kind(key: str) -> int | str:
    row = row_of(key)
    return key if row is None else row


def _filled(state: RepairState, kind: int | str, plan: LeverPlan, tried: list[Changes]) -> LeverPlan | None:
    """With its levers and its changes of what is free; None where it has none."""
    data = state.document.data
    free = [key for key in plan.keys if not locked(data, key)]
    sets = [
        changes
        for changes in tried
        if _kind(next(iter(changes))) == kind and not any(locked(data, key) for key in changes)
    ]
    sets += [changes for key in free for changes in _words(state, key)]
    by_place: dict[str, list[str]] = {}
    for key in free:
        by_place.setdefault(key.rpartition(".")[0], []).append(key)
    moved = [lever for some in by_place.values() for lever in levers(state, some)]
    return replace(plan, levers=tuple(moved), sets=tuple(sets[:SETS])) if moved or sets else None


# --- what moves a finding


def _keys(state: RepairState, step: str, group: tuple[Check, ...]) -> Iterator[str]:
    """Of a table the numbers in it; then the free numbers of the step in the same bearing, mesh or wheel."""
    every = [key for key, about in quantities(state.document.data) if about.kind in ("number", "integer", "series")]
    for key in dict.fromkeys(key for check in group for key in check.moved_by):
        yield from [inner for inner in every if inner.startswith(f"{key}.")] or [key]
    free, near = re.compile(FREE[step]), {part for c in group for part in c.id.split(".")[1].split("_")}
    for key in every:
        if key.startswith(f"{step}.") and free.fullmatch(key.partition(".")[2]) and near & set(key.split(".")):
            yield key


def _named(group: tuple[Check, ...]) -> list[Changes]:
    return [dict(remedy.changes) for check in group for remedy in check.remedies if remedy.changes]


def _made_for(state: RepairState, group: tuple[Check, ...]) -> list[Changes]:
    """What is made for some checks: masses that are set to what the engine asks for, stronger teeth."""
    sets: list[Changes] = []
    for patterns, changes in MADE_FOR:
        some = tuple(c for c in group if any(fnmatchcase(c.id, pattern) for pattern in patterns))
        try:
            sets += [change_set for change_set in changes(state, some) if change_set] if some else []
        except NoSolution:
            pass
    return sets


def _balanced(state: RepairState, group: tuple[Check, ...]) -> list[Changes]:
    countershaft = state.design.countershaft
    return (
        list(sizing.balanced(state, countershaft)) if countershaft is not None and countershaft.mode == "given" else []
    )


def _stronger(state: RepairState, group: tuple[Check, ...]) -> list[Changes]:
    return list(sizing.stronger(state, sizing.wheels(state, group)))


MADE_FOR: tuple[tuple[tuple[str, ...], Callable[[RepairState, tuple[Check, ...]], list[Changes]]], ...] = (
    (("countershaft.residual", "countershaft.residual_force", "countershaft.holes.range"), _balanced),
    (("*.safety_contact*", "*.safety_bending*"), _stronger),
)


# --- words


def _words(state: RepairState, key: str) -> Iterator[Changes]:
    """Other words that may stand at a key, the nearest first."""
    about, now, last = quantity_of(state.document.data, key), value_at(state.document.data, key), key.rpartition(".")[2]
    if about.kind == "choice":
        yield from ({key: word} for word in about.choices if word != now)
    elif last.endswith("material") and isinstance(now, str) and (there := state.design.materials.get(now)) is not None:
        others = sorted(
            (_unlike(there, material), name) for name, material in state.design.materials.items() if name != now
        )
        yield from ({key: name} for _, name in others)
    elif last == "oil" and state.design.bearings is not None:
        yield from ({key: name} for name in _oils(state))
    elif last.endswith("_fit") and state.design.bearings is not None:
        from ...bearings.selection.variants import closer_fits

        for journal, seat in closer_fits(state.design.bearings):
            yield {"bearings.journal_fit": journal, "bearings.seat_fit": seat}


def _oils(state: RepairState) -> list[str]:
    """Engine oils other than that of the bearings, the nearest in viscosity first."""
    from ...bearings.selection.variants import variants
    from ...design.step_inputs import bearings_case
    from ...solve import solve

    current, *others = variants(bearings_case(state.design, solve, state.results))
    T = state.design.bearings.supply_temperature if state.design.bearings is not None else 0.0
    mu = current.lubricant.at(T).mu
    return [
        v.oil
        for v in sorted(others, key=lambda v: abs(math.log(v.lubricant.at(T).mu / mu)))
        if v.supply == current.supply
    ]


def _unlike(first: Material, other: Material) -> float:
    """How far two materials are from each other in stiffness, weight and expansion."""
    pairs = ((first.E, other.E), (first.density, other.density), (first.expansion, other.expansion))
    return sum(abs(math.log(a / b)) for a, b in pairs if a > 0 and b > 0) + (first.kind != other.kind)


# --- numbers


def levers(state: RepairState, keys: list[str]) -> Iterator[Lever]:
    """Of the keys of one kind in one place: what moves all of them, and other ways to do so."""
    key, data = keys[0], state.document.data
    about, given, place = quantity_of(data, key), value_at(data, key), key.rpartition(".")[0]
    if about.kind not in ("number", "integer", "series") or FIXED.fullmatch(key):
        return
    if key.endswith(("clearance_um", "clearance_factor")):
        yield from _clearance(state, place)
        return
    numbers = {name: [float(x) for x in as_list(value_at(data, name)) if isinstance(x, (int, float))] for name in keys}
    if given is None and (chosen := published(state.results, key)) is not None and chosen.unit == about.unit:
        numbers[key] = [digits(chosen.shown, 6)]
    numbers = {name: some for name, some in numbers.items() if some}
    if key not in numbers:
        return
    now, alone = numbers[key][0], not isinstance(given, list)
    if key.endswith("_allowance_um"):
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

    if key == "countershaft.core_radius_mm" and value_at(data, "bearings.slope_mrad") is not None:
        yield Lever(now, about, lambda x: write(x) | {"bearings.slope_mrad": None}, abs(now))
        return
    yield Lever(now, about, write, abs(now))
    if re.fullmatch(r"bearings\.(front|rear)\.length_mm", key) and (places := outwards(state, key, now)) is not None:
        yield Lever(now, about, lambda x: write(x) | {POSITIONS: places(x)}, abs(now))


POSITIONS = "countershaft.bearing_positions_mm"


def outwards(state: RepairState, key: str, now: float) -> Callable[[float], list[float]] | None:
    """Where the bearings stand when the inner end of one stays and its length becomes another."""
    places = value_at(state.document.data, POSITIONS) if state.design.countershaft is not None else None
    if not isinstance(places, list) or len(places) != 2 or not all(isinstance(z, (int, float)) for z in places):
        return None
    n, side = (0, -1.0) if key.split(".")[1] == "front" else (1, 1.0)
    return lambda x: [digits(z + side * (x - now) / 2, 6) if i == n else z for i, z in enumerate(places)]


def _clearance(state: RepairState, place: str) -> Iterator[Lever]:
    """In micrometres, in place of the factor where that is given."""
    key, data = f"{place}.clearance_um", state.document.data
    if (there := published(state.results, key)) is None:
        return
    factor = f"{place}.clearance_factor"
    gone: Changes = {} if value_at(data, factor) is None else {factor: None}
    now = float(f"{there.shown:.4g}")
    yield Lever(now, quantity_of(data, key), lambda x: gone | {key: digits(x)}, now)


def disturbance(state: RepairState, changes: Iterable[tuple[str, object]]) -> float:
    """How much changes change: the sum of the relative changes of their numbers, and a half for a word."""
    total = 0.0
    for key, new in changes:
        try:
            olds, news = as_list(value_at(state.document.data, key)), as_list(new)
        except BadInput:
            olds, news = [], as_list(new)
        pairs = [(a, b) for a, b in zip(olds, news) if isinstance(a, (int, float)) and isinstance(b, (int, float))]
        off = [abs(b - a) / (ALLOWANCE if key.endswith("_allowance_um") else abs(a) or 1.0) for a, b in pairs]
        total += max(off) if off else 0.5 if isinstance(new, str) else 0.05
    return total
