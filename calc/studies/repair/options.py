# SPDX-License-Identifier: Apache-2.0
"""What would help against one finding: remedies of different kinds, each the smallest of its kind, with what it does to
all the rest.

A kind that mends the finding at every corner of its group is best, then one that mends it as given, then one that
breaks something else, then one that only comes nearer.  What is locked is shown too, and not searched."""

import math
from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from itertools import islice

from ...bearings.inputs import BearingsInputs
from ...bearings.plain.checks import (
    FILM_DOUBLE_LOAD,
    FILM_EDGE,
    FILM_EDGE_CORNER,
    FILM_EDGE_RANGE,
    FILM_EDGE_SHEARED,
    FILM_EDGE_SPEEDS,
    FILM_EDGE_STANDING,
    FILM_EDGE_USUAL,
    FILM_OVERSPEED,
    FILM_PRESSURE,
    FILM_TRUMPLER,
    TRANSITION,
)
from ...bearings.plain.selection.variants import closer_fits, variants
from ...countershaft.left_over import RESIDUAL, RESIDUAL_FORCE, RESIDUAL_FORCE_SHARE, RESIDUAL_SHARE
from ...countershaft.making.unbalance import HOLES_RANGE
from ...design.addresses import address, quantity_of, value_at
from ...design.locks import locked
from ...design.model import Design
from ...design.names import asked, named, published, written
from ...design.step_inputs import bearings_case
from ...design.toml_file import Document
from ...gears.rating.checks import (
    MICROPITTING_FILM,
    SAFETY_BENDING,
    SAFETY_BENDING_USUAL,
    SAFETY_CONTACT,
    SAFETY_CONTACT_USUAL,
)
from ...library.catalogue import Material
from ...sheet.check import KINDS, Check
from ...sheet.deferred import Later
from ...sheet.errors import BadInput, NoSolution
from ...sheet.progress import Progress, part, tell
from ...sheet.quantity import Quantity, dotted
from ...sheet.record import replace
from ...sheet.remedy import Changes
from ...sheet.search import Budget, closer, rounded
from ...sheet.text import EMPTY, Small, Text
from ...solve import Results, solve
from . import sizing
from .levers import Lever, called, free_keys, kind_of, levers, named_keys, place_of, settled, words_of
from .nearest import NearestRemedy, remedy
from .option import ALL_CORNERS, AS_GIVEN, BREAKS, NEAR, RepairOption, rank, repair_option
from .state import RepairState, held, state_of
from .trials import ROUND, Trials

# --- which kinds are looked at

PLANS = 7  # kinds that are looked at
SETS = 12  # changes of one kind that are tried as they are


@dataclass(frozen=True)
class LeverPlan:
    """One kind of remedy: its keys, what can be moved, what can be tried; `reason`: why its one key is held."""

    keys: tuple[str, ...]
    levers: tuple[Lever, ...] = ()
    sets: tuple[Changes, ...] = ()
    reason: Text = EMPTY


def plans(state: RepairState, step: str, group: tuple[Check, ...]) -> list[LeverPlan]:
    """In the order in which a designer would think of them: what the checks themselves name, what moves them, what else
    is free."""
    document = state.document
    tried = [dict(remedy.changes) for check in group for remedy in check.remedies if remedy.changes]
    tried += _made_for(state, group)
    first = [next(iter(changes)) for changes in tried]
    by_kind: dict[tuple[str, ...], list[str]] = {}
    for key in dict.fromkeys([*first, *named_keys(state, group), *free_keys(state, step, group)[0]]):
        by_kind.setdefault(kind_of(document, key), []).append(key)
    shut = [
        LeverPlan((key,), reason=reason) for keys in by_kind.values() for key in keys if (reason := held(state, key))
    ]
    by_first = [(kind_of(document, key), changes) for key, changes in zip(first, tried)]
    filled = (
        _filled(state, keys, [changes for other, changes in by_first if other == kind])
        for kind, keys in by_kind.items()
    )
    return [*shut, *islice(filter(None, filled), PLANS)]


def _filled(state: RepairState, keys: list[str], tried: list[Changes]) -> LeverPlan | None:
    """With its levers and its changes of what is free; None where it has none."""
    free = [key for key in keys if not held(state, key)]
    sets = [changes for changes in tried if not any(held(state, key) for key in changes)]
    sets += [changes for key in free for changes in _words(state, key)]
    by_place: dict[str, list[str]] = {}
    for key in free:
        by_place.setdefault(place_of(key), []).append(key)
    moved = [lever for some in by_place.values() for lever in levers(state, some)]
    return LeverPlan(tuple(keys), tuple(moved), tuple(sets[:SETS])) if moved or sets else None


WEAK = (SAFETY_CONTACT, SAFETY_CONTACT_USUAL, SAFETY_BENDING, SAFETY_BENDING_USUAL)
UNBALANCED = (RESIDUAL, RESIDUAL_FORCE, RESIDUAL_SHARE, RESIDUAL_FORCE_SHARE, HOLES_RANGE)


def _made_for(state: RepairState, group: tuple[Check, ...]) -> list[Changes]:
    """What is made for some checks: stronger teeth, masses that are set to what the engine asks for, rolling bearings
    that sit otherwise or are larger."""
    weak = tuple(c for c in group if c.rule in WEAK)
    sets = list(sizing.stronger(state, sizing.wheels(state, weak))) if weak else []
    sets += [changes for own in sizing.of_rolling(state, group) for changes in sizing.rolling_ways(state, own)]
    for view in state.design.views.values() if any(c.rule in UNBALANCED for c in group) else ():
        if view.countershaft is not None and view.countershaft.mode == "given":
            try:
                sets += sizing.balanced(state, view.countershaft)
            except NoSolution:
                pass
    return [changes for changes in sets if changes]


FITS = (
    dotted(Design.bearings, BearingsInputs.journal_fit),
    dotted(Design.bearings, BearingsInputs.seat_fit),
)


def _words(state: RepairState, key: str) -> Iterator[Changes]:
    """Other words that may stand at a key, the nearest first."""
    about, now, bearings = (
        quantity_of(state.document.data, key),
        value_at(state.document.data, key),
        state.design.bearings,
    )
    if about.kind == "choice":
        yield from ({key: word} for word in about.choices if word != now)
    elif about.catalogue == "materials" and (there := state.design.materials.get(str(now))) is not None:
        unlike = sorted((_unlike(there, other), name) for name, other in state.design.materials.items() if name != now)
        yield from ({key: name} for _, name in unlike)
    elif about.catalogue == "oils" and bearings is not None:
        yield from ({key: name} for name in _oils(state, bearings))
    elif key in FITS and bearings is not None:
        yield from (dict(zip(FITS, fits)) for fits in closer_fits(bearings))


def _oils(state: RepairState, bearings: BearingsInputs) -> list[str]:
    """Engine oils other than that of the bearings, the nearest in viscosity first."""
    current, *others = variants(bearings_case(state.design, solve, state.results))
    T = bearings.supply_temperature
    mu = current.lubricant.at(T).mu
    others = [v for v in others if v.supply == current.supply]
    return [v.oil for v in sorted(others, key=lambda v: abs(math.log(v.lubricant.at(T).mu / mu)))]


def _unlike(first: Material, other: Material) -> float:
    """How far two materials are from each other in stiffness, weight and expansion."""
    pairs = ((first.E, other.E), (first.density, other.density), (first.expansion, other.expansion))
    return sum(abs(math.log(a / b)) for a, b in pairs if a > 0 and b > 0) + (first.kind != other.kind)


# --- the best way of a kind

FARTHEST = (0.6, 0.9)  # relative change up and down that is still believed
TRIES = 100  # whole designs
DEAR = 3.0  # times the change that is enough as given, beyond which the corners are left open
EIGHTH = 0.125  # of a change that breaks something: so close to it one that does not is looked for
LARGE = 0.25  # relative change beyond which one that breaks something else is no remedy
MANY = 3  # limits that a remedy may break
ABSURD = 3.0  # relative change beyond which what a check computes is no remedy: a flywheel of seventy times its inertia
NEARER = 0.9  # share of what is missing that a change may leave to be worth a row


def _best(
    state: RepairState, step: str, group: tuple[Check, ...], plan: LeverPlan, progress: Progress | None
) -> tuple[RepairOption, ...]:
    """The best way of a kind, and of a smaller change what the finding itself names, where that mends it as given; none
    where it brings nothing."""
    label, options = words_of(state.document, plan.keys[0]), list[RepairOption]()
    name = label.other or label.less
    tell(progress, 0.0, name)
    trials = Trials(state, step, group, Budget(TRIES), progress, name, FARTHEST, ROUND)
    for changes in plan.sets:
        way = _way(trials, settled(state.document, changes))
        if way is None or not way.passes:
            way = _way(trials, changes)
        if way is not None:
            options.append(way)
            if way.quality == ALL_CORNERS:
                break
    limits = tuple(c for c in group if c.verdict == "fail") or group[:1]
    for lever in plan.levers:
        if any(way.quality == ALL_CORNERS and way.disturbance < LARGE for way in options):
            break
        for wanted in (group, limits) if limits != group else (group,):
            if (way := _moved(trials, lever, wanted)) is None:
                continue
            options.append(way)
            if way.quality in (ALL_CORNERS, BREAKS):
                break
    options = sorted((way for way in options if _worth(trials, way)), key=rank)
    given = next((way for way in options if way.quality == AS_GIVEN), None)
    if given is not None and options[0].disturbance > max(DEAR * given.disturbance, LARGE):
        options = [given, *options]
    named, best = [dict(remedy.changes) for check in group[:1] for remedy in check.remedies], options[:1]
    smaller = (
        way
        for way in options[1:]
        if way.quality == AS_GIVEN and way.disturbance < best[0].disturbance and dict(way.made) in named
    )
    return (*best, *islice(smaller, 1))


def _way(trials: Trials, changes: Changes) -> RepairOption | None:
    """What changes come to; None where they are not allowed, or without a solution."""
    state, after = trials.state, trials.tried(changes, whole=True)
    if after is None or after.outcome(trials.step).state != "solved" or not after.changes:
        return None
    key = next((key for key, new in after.changes.items() if new is not None), next(iter(after.changes)))
    now = value_at(state.document.data, key)
    if now is None and (there := published(state.results, key)) is not None:
        now = there.shown
    kind = called(state.document, after.changes, key, now)
    return repair_option(state, after, after.changes, trials.checks, kind)


def _worth(trials: Trials, way: RepairOption) -> bool:
    """Whether it is worth a row: it breaks little, and comes clearly nearer."""
    if way.quality != NEAR:
        return len(way.breaks) <= MANY
    after = trials.tried(dict(way.made), whole=True)
    return not way.breaks and after is not None and _missing(trials, after) < _missing(trials, trials.state) * NEARER


def _missing(trials: Trials, after: RepairState) -> float:
    """What the first check lacks, in its unit: a limit that moves away without the value is nothing gained."""
    first = trials.checks[:1]
    scale = next((c.scale for c in after.outcome(trials.step).checks if c.id == first[0].id), 0.0) if first else 0.0
    return -trials.score(after, first) * (scale or 1.0)


def _moved(trials: Trials, lever: Lever, wanted: tuple[Check, ...]) -> RepairOption | None:
    """The smallest change by which what is wanted holds, else the one that comes nearest."""
    numbers, nearest = trials.enough(lever, wanted)
    for number in numbers:
        if (way := _way(trials, lever.offered_at(number) or {})) is not None:
            large = way.breaks and way.disturbance >= LARGE
            return _nearer(trials, lever, (number - lever.now) / lever.scale) if large else way
    return _nearer(trials, lever, nearest) if nearest else None


def _nearer(trials: Trials, lever: Lever, end: float) -> RepairOption | None:
    """As far towards a relative change as nothing else breaks."""
    ways: dict[float, RepairOption] = {}

    def breaks(share: float) -> float:
        """0 where something does, else no number."""
        change = share * abs(end)
        number = lever.rounded(math.copysign(change - min(ROUND, change / 5), end), math.copysign(change, end))
        changes = lever.offered_at(lever.short_of(number))
        way = _way(trials, changes) if changes is not None else None
        if way is None or way.breaks:
            return 0.0
        ways[share] = way
        return math.nan

    if breaks(1.0) == 0:
        closer(breaks, 0.0, 1.0, math.nan, 0.0, EIGHTH)
    return ways[max(ways)] if ways else None


# --- all kinds

HOUSINGS = ("EN-GJL-250", "EN AC-43100")  # grey iron and aluminium: what housings are usually cast of


def group_of(results: Results, finding: Check) -> tuple[Check, ...]:
    """What is open and shares the cause of a finding, of its kind or a worse one; the finding first."""
    kinds = KINDS[: max(KINDS.index(finding.kind), KINDS.index("caution") if finding.kind == "limit" else 0) + 1]
    cause = finding.cause or finding.id
    same = [
        c for c in results.checks() if c.open and (c.cause or c.id) == cause and c.kind in kinds and c.id != finding.id
    ]
    return (finding, *same)


def search(
    document: Document,
    finding: Check | str,
    results: Results | None = None,
    progress: Progress | None = None,
    nearest: NearestRemedy | None = None,
) -> Iterator[RepairOption]:
    """Remedies of one finding, or of a step without a solution, each as soon as it is found.  `progress` may raise
    `Cancelled`; `nearest`: that of the step, where it is known."""
    state = state_of(document, results)
    step = finding if isinstance(finding, str) else finding.id.partition(".")[0]
    group = () if isinstance(finding, str) else group_of(state.results, finding)
    if group and group[0].verdict == "not_verified":
        yield from _given(state, group)
        if group[0].holds:  # by what is taken: no other number makes it known
            return
    if group and group[0].rule.of_input:
        yield from _meant(state, group)
        return
    every = plans(state, step, group) if group else []
    yield from (_locked(state, plan, group) for plan in every if plan.reason)
    free = [plan for plan in every if not plan.reason]
    known = set[tuple[str, ...]]()
    for computed in _computed(state, step, group, progress):
        known.add(computed.changes)
        yield computed
    for n, plan in enumerate([*free, *([None] if not group or group[0].kind == "limit" else [])]):
        here = part(progress, n / (len(free) + 1), (n + 1) / (len(free) + 1))
        if plan is not None:
            ways = _best(state, step, group, plan, here)
        else:
            ways = _whole_step(state, step, group, here, nearest)
        for way in ways:
            if way.changes not in known:
                known.add(way.changes)
                yield way


def _computed(
    state: RepairState, step: str, group: tuple[Check, ...], progress: Progress | None
) -> Iterator[RepairOption]:
    """Of a finding that computes its remedies when they are looked at each that helps; a kind has several of them."""
    named = group[0].remedies if group else ()
    if not isinstance(named, Later):
        return
    trials = Trials(state, step, group, Budget(TRIES), progress, group[0].name, FARTHEST, ROUND)
    for each in (each for each in named if each.changes):
        if any(locked(state.document.data, key) for key, _ in each.changes):
            continue
        way = _way(trials, dict(each.changes))
        if way is None or way.disturbance > ABSURD or not _worth(trials, way):
            continue
        if way.passes and each.effect:
            told = dict(passes=way.effect, effect=each.effect)
            closed = way.quality == ALL_CORNERS
            effect = Text("{passes}: {effect}", **told) if closed else Text("{effect}: {passes}", **told)
            way = replace(way, effect=effect)
        yield way


WHOLE_STEP = Text("all of the step at once")
QUICK = 20  # whole designs that the search for the nearest may solve over single numbers, while somebody waits


def _whole_step(
    state: RepairState,
    step: str,
    group: tuple[Check, ...],
    progress: Progress | None,
    nearest: NearestRemedy | None,
) -> tuple[RepairOption, ...]:
    """The nearest design in which all limits of the step hold, if there is one."""
    nearest = nearest or remedy(state.document, step, state.results, progress, tries=QUICK)
    if not nearest.changes or (not nearest.mends and group):
        return ()
    after = RepairState(nearest.document, nearest.results)
    changes = nearest.made
    way = repair_option(state, after, changes, group, WHOLE_STEP)
    return (way,) if way.quality < NEAR else ()


def _given(state: RepairState, group: tuple[Check, ...]) -> Iterator[RepairOption]:
    """Of what can not be judged: the missing inputs, with a usual value where there is one, and all of them at once."""
    every: Changes = {}
    for key in dict.fromkeys(key for check in group for key in check.missing):
        try:
            address(state.document.data, key, whole=True)
        except BadInput:  # of something that has no field, as a material
            continue
        kind = Text("give {input}", input=asked(state.document, key))
        values: tuple[float | int | str, ...] = ()
        with suppress(BadInput):  # of a table, which has no usual value
            values = _usual(state, key, quantity_of(state.document.data, key))
        if values:
            every[key] = values[0]
        else:
            yield RepairOption(kind, (key,), effect=Text("then it can be judged"), quality=NEAR)
        yield from _as_given(state, group, [{key: value} for value in values], kind)
    if len(every) > 1:
        yield from _as_given(state, group, [every], Text("give all that is missing"))


def _as_given(
    state: RepairState, group: tuple[Check, ...], ways: Iterable[Changes], kind: Text
) -> Iterator[RepairOption]:
    for changes in ways:
        try:
            after = state.with_changes(changes)
        except BadInput:
            continue
        yield repair_option(state, after, changes, group, kind)


def _meant(state: RepairState, group: tuple[Check, ...]) -> Iterator[RepairOption]:
    """Of an input that is doubted: what was probably meant, and nothing that only just gets by."""
    for way in group[0].remedies:
        changes = dict(way.changes)
        if any(locked(state.document.data, key) for key in changes):
            continue
        try:
            after = state.with_changes(changes)
        except BadInput:
            continue
        yield repair_option(state, after, changes, group, Text("what was probably meant"))


def _usual(state: RepairState, key: str, about: Quantity) -> tuple[float | int | str, ...]:
    """What is usually given there; of a housing the material of the bearings' first."""
    if about.usual is not None and about.kind in ("number", "integer"):
        low, high = about.usual
        middle = rounded(low + 0.4 * (high - low), low + 0.6 * (high - low))
        return (round(middle) if about.kind == "integer" else middle,)
    if key.endswith(dotted("", BearingsInputs.housing_material)):  # or that of the gears, called alike
        of_bearings = state.design.bearings.housing_material if state.design.bearings is not None else None
        return tuple(dict.fromkeys(name for name in (of_bearings, *HOUSINGS) if name))
    return about.choices[:1]


FILMS = (
    FILM_EDGE,
    FILM_EDGE_RANGE,
    FILM_EDGE_SPEEDS,
    FILM_EDGE_STANDING,
    FILM_EDGE_SHEARED,
    FILM_EDGE_CORNER,
    FILM_EDGE_USUAL,
    FILM_OVERSPEED,
    FILM_DOUBLE_LOAD,
    FILM_TRUMPLER,
    FILM_PRESSURE,
    TRANSITION,
    MICROPITTING_FILM,
)  # what a thicker oil helps


def _locked(state: RepairState, plan: LeverPlan, group: tuple[Check, ...]) -> RepairOption:
    document, key = state.document, plan.keys[0]
    change, now, label = words_of(document, key), value_at(document.data, key), named(document, key)
    film = any(check.rule in FILMS for check in group)
    text = Text("{label} {value}", label=label, value=written(now)) if now is not None else label
    thicker = film and quantity_of(document.data, key).catalogue == "oils"
    name = change.more if thicker else change.other or change.less
    shut = locked(document.data, key)
    effect = Text("not looked at") if shut else Text("held: {reason}", reason=plan.reason)
    if not shut:  # in which direction it would have to go is not known
        name = Small(quantity_of(document.data, key).label)
    return RepairOption(name, plan.keys, words=text, effect=effect, locked=shut)
