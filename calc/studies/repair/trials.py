# SPDX-License-Identifier: Apache-2.0
"""The smallest change of one kind by which a finding and its group hold; whole designs are tried, each once."""

from collections.abc import Iterable
from dataclasses import dataclass, field
from math import copysign, isnan, nan

from ...design.addresses import value_at
from ...design.locks import USUAL
from ...design.names import PLACES, named, published, words
from ...sheet.check import THIN_MARGIN, Check
from ...sheet.errors import BadInput, NoSolution
from ...sheet.progress import Progress, part, tell
from ...sheet.remedy import Changes, assignments
from ...sheet.search import rounded
from ...sheet.step import Outcome
from ...sheet.text import COMMA, EMPTY, SEMICOLON, Amount, Text, plural
from ...solve import Results
from . import sizing
from .levers import Lever, LeverPlan, called, disturbance, levers
from .state import ORDER, RepairState, broken

# --- one way to mend a finding: what it changes, how far it comes, and what it does to all the rest

MOST, SHUT = 5, 2  # that are offered, and of these locked ones
ALL_CORNERS, AS_GIVEN, BREAKS, NEAR, LOCKED = range(5)  # how good a way is


@dataclass(frozen=True)
class RepairOption:
    """One remedy.  `kind`: in the words of the trade; `words`: the change in labels and units of the fields; `made`:
    each key with its new value, `changes` the same as KEY=VALUE.

    `passes`: the finding and the limits of its group hold; `effect` says how far it comes.  `left`: names of what is
    still open in the group; `breaks`: names of limits that fail then and did not, and of steps without a solution.
    `verdicts`: step, before, after. `power` [W], `mass` [kg]: before and after, of the crank's loss and the shaft;
    `cold` [µm]: the cold clearance, of a bearing. `locked`: why it was not looked at.  `missing`: it gives an input
    that was not there."""

    kind: Text
    keys: tuple[str, ...]
    made: tuple[tuple[str, object], ...] = ()
    words: Text = EMPTY
    effect: Text = EMPTY
    quality: int = LOCKED
    disturbance: float = 0.0
    left: tuple[Text, ...] = ()
    breaks: tuple[Text, ...] = ()
    verdicts: tuple[tuple[str, str, str], ...] = ()
    power: tuple[float, float] | None = None
    mass: tuple[float, float] | None = None
    cold: float | None = None
    locked: str = ""
    results: Results | None = field(default=None, repr=False)

    @property
    def changes(self) -> tuple[str, ...]:
        return tuple(assignments(dict(self.made)))

    @property
    def passes(self) -> bool:
        return self.quality < NEAR

    @property
    def rest(self) -> Text:
        """What it does beside: `+9 W, +0.4 kg, cold gap 32 µm; then fails: …`."""
        parts = [
            Text("{change}", change=Amount(b - a, unit, form="+.3g"))
            for pair, unit in ((self.power, "W"), (self.mass, "kg"))
            if pair is not None and abs((b := pair[1]) - (a := pair[0])) > 5e-4 * abs(a)
        ]
        if self.cold is not None:
            parts.append(Text("cold gap {gap}", gap=Amount(self.cold, "µm", digits=3)))
        text = COMMA.join(parts) if parts else EMPTY
        if self.breaks:
            fails = Text("then fails: {checks}", checks=COMMA.join(self.breaks[:2]))
            text = SEMICOLON.join([text, fails]) if text else fails
        return text


def ranked(ways: Iterable[RepairOption]) -> tuple[RepairOption, ...]:
    """The best few, what passes everything first, then by the smallest disturbance; what is locked last."""
    every = sorted(ways, key=lambda way: (way.quality, way.disturbance))
    shut = sorted((way for way in every if way.locked), key=lambda way: way.keys[0] in USUAL)[:SHUT]
    return (*[way for way in every if not way.locked][: MOST - len(shut)], *shut)


def repair_option(
    state: RepairState, after: RepairState, changes: Changes, group: tuple[Check, ...], kind: Text
) -> RepairOption:
    """A way that was found, with all that it does."""
    left = _open_still(after, group)
    steps = [id for id in broken(state, after)]
    names = {c.id: c.name for outcome in after.results.outcomes.values() for c in outcome.checks}
    breaks = tuple(names.get(id, Text("{step} has no solution", step=id)) for id in steps)
    limits = any(c.verdict == "fail" for c in left) or (bool(left) and left[0].id == group[0].id)
    quality = NEAR if limits else BREAKS if breaks else AS_GIVEN if left else ALL_CORNERS
    before, then = state.results, after.results
    place = group[0].id.split(".")[1] if group and group[0].id.startswith("bearings.") else ""
    gap = then.values().get(f"bearings.{place}.clearance_cold") if place else None
    return RepairOption(
        kind,
        tuple(changes),
        tuple(changes.items()),
        words(state.document, before, changes),
        _effect(group, left, quality),
        quality,
        disturbance(state, changes.items()),
        tuple(c.name for c in left),
        breaks,
        tuple((key, before.outcomes[key].verdict, then.outcomes[key].verdict) for key in ORDER),
        _pair(before, then, "friction.total_loss"),
        _pair(before, then, "countershaft.mass"),
        gap.shown if gap is not None else None,
        results=then,
    )


def _pair(before: Results, after: Results, id: str) -> tuple[float, float] | None:
    first, other = before.values().get(id), after.values().get(id)
    return (first.shown, other.shown) if first is not None and other is not None else None


def _open_still(after: RepairState, group: tuple[Check, ...]) -> tuple[Check, ...]:
    """Of a group what is not mended: a limit that failed must hold, all else must be closed."""
    there = {c.id: c for outcome in after.results.outcomes.values() for c in outcome.checks}
    return tuple(
        there[c.id]
        for c in group
        if c.id in there and (there[c.id].open if c.verdict != "fail" else not there[c.id].holds)
    )


def _effect(group: tuple[Check, ...], left: tuple[Check, ...], quality: int) -> Text:
    if quality == NEAR and left:
        worst = left[0]
        if worst.id != group[0].id:
            return Text("still open: {checks}", checks=worst.name)
        return Text(
            "comes to {value}, needs {limit}", value=Amount(worst.value, worst.unit, digits=3), limit=worst.limit_text()
        )
    if left:
        return plural(
            "passes as given; {n} finding is still open", "passes as given; {n} findings are still open", n=len(left)
        )
    return (
        Text("passes, also at every corner")
        if any("corner" in c.id or "worst" in c.id for c in group)
        else Text("passes")
    )


# --- the trials

PROBE = 0.02  # of the number, by which it is moved to see what it does
FARTHEST = {1.0: 0.6, -1.0: 0.9}  # relative change up and down that is still believed
DEAR = 3.0  # times the change that is enough as given, beyond which the corners are left open
HALVINGS = 4  # towards the farthest change that breaks nothing
ROUND = 0.03  # relative change that a round number is worth
STRIDES = 5  # towards the smallest change
LARGE = 0.25  # relative change beyond which one that breaks something else is no remedy
MANY = 3  # limits that a remedy may break
NEARER = 0.1  # share of what is missing that a change must bring to be worth a row


class Trials:
    """The smallest change of one kind: whole designs are tried, each once."""

    def __init__(
        self, state: RepairState, step: str, group: tuple[Check, ...], progress: Progress | None, name: Text
    ) -> None:
        self.state, self.step, self.group, self.progress, self.name = state, step, group, progress, name
        self.ids = {c.id for c in group}
        self.known: dict[tuple[str, bool], RepairState | None] = {}
        self.ended = False  # whether the last one was solved as far as the group only

    def best(self, plan: LeverPlan) -> RepairOption | None:
        """The best way of a kind; None where it brings nothing."""
        options: list[RepairOption] = []
        for changes in plan.sets:
            if (way := self.way(changes)) is not None:
                options.append(way)
                if way.quality == ALL_CORNERS:
                    break
        limits = tuple(c for c in self.group if c.verdict == "fail") or self.group[:1]
        for lever in plan.levers:
            if any(way.quality == ALL_CORNERS and way.disturbance < LARGE for way in options):
                break
            for wanted in (self.group, limits) if limits != self.group else (self.group,):
                way = self.moved(lever, wanted)
                if way is not None:
                    options.append(way)
                if way is not None and way.quality in (ALL_CORNERS, BREAKS) and wanted is self.group:
                    break
        options = sorted(filter(self._worth, options), key=lambda way: (way.quality, way.disturbance))
        given = next((way for way in options if way.quality == AS_GIVEN), None)
        if options and given is not None and options[0].disturbance > max(DEAR * given.disturbance, LARGE):
            return given
        return next(iter(options), None)

    # --- trying
    def tried(self, changes: Changes | None, whole: bool = False) -> RepairState | None:
        """The design with a change, solved no further than to the checks of the group; `whole`: to the end."""
        if changes is None:
            return None
        name = str(changes)
        if (name, whole) not in self.known:
            tell(self.progress, 1 - 0.9 ** len(self.known), self.name)
            self.ended = False
            begun = self.known.get((name, False))
            try:
                after = self.state.with_changes(
                    changes, begun.results if begun else None, None if whole else self._known
                )
            except (BadInput, NoSolution):
                after = None
            self.known[name, False] = after
            if not self.ended:
                self.known[name, True] = after
        return self.known[name, whole]

    def _known(self, outcome: Outcome[object]) -> bool:
        """Whether all of the group is known; the checks of the imbalance change once the shaft is known."""
        if outcome.key == self.step and self.step != "imbalance" and self.ids <= {c.id for c in outcome.checks}:
            self.ended = True
        return self.ended

    def score(self, after: RepairState | None, wanted: tuple[Check, ...]) -> float:
        """The least margin of what is to hold, from what it needs; no number where there is none."""
        if after is None or after.outcome(self.step).state != "solved":
            return nan
        there = {c.id: c for c in after.outcome(self.step).checks}
        margins = [there[c.id].margin - (THIN_MARGIN if c.narrow else 0.0) for c in wanted if c.id in there]
        return min(margins, default=nan)

    def way(self, changes: Changes) -> RepairOption | None:
        """What changes come to; None where they are not allowed, or without a solution."""
        after = self.tried(changes, whole=True)
        if after is None or after.outcome(self.step).state != "solved":
            return None
        applied = {key: after.changes[key] for key in after.changes}
        if not applied:
            return None
        key = next((key for key in applied if applied[key] is not None), next(iter(applied)))
        way = repair_option(
            self.state, after, applied, self.group, called(self.state.document, key, self._now(key), applied[key])
        )
        return way

    def _worth(self, way: RepairOption) -> bool:
        """Whether it is worth a row: it breaks little, and comes clearly nearer."""
        if way.quality == NEAR:
            gap, still = (-self.score(state, self.group[:1]) for state in (self.state, self._after(way)))
            return not way.breaks and still < gap * (1 - NEARER)
        return len(way.breaks) <= MANY

    def _after(self, way: RepairOption) -> RepairState | None:
        return RepairState(self.state.document, way.results) if way.results is not None else None

    def _now(self, key: str) -> object:
        now = value_at(self.state.document.data, key)
        if now is None and (there := published(self.state.results, key)) is not None:
            return there.shown
        return now

    # --- one number
    def moved(self, lever: Lever, wanted: tuple[Check, ...]) -> RepairOption | None:
        """The smallest change by which what is wanted holds, else the one that comes nearest."""
        start = self.score(self.state, wanted)
        for sign in (1.0, -1.0):
            first = self._step(lever, sign * PROBE)
            gain = self.score(self.tried(lever.at(first)), wanted) - start
            if isnan(gain) or gain <= 0:
                continue
            ends = self._ends(lever, wanted, start, first, start + gain)
            numbers: list[float] = []
            if isinstance(ends, tuple):
                low, high = ends
                beyond = high + copysign(max(abs(high - low), ROUND * lever.scale), high - lever.now)
                numbers = [self._rounded(lever, low, high), self._rounded(lever, high, beyond), high]
            for number in numbers:
                if (
                    self.score(self.tried(lever.at(number)), wanted) >= 0
                    and (way := self.way(lever.at(number) or {})) is not None
                ):
                    return way if not way.breaks or way.disturbance < LARGE else self._nearer(lever, number)
            return self._nearer(lever, ends) if not isinstance(ends, tuple) else None
        return None

    def _nearer(self, lever: Lever, end: float) -> RepairOption | None:
        """As far towards a number as nothing else breaks."""
        low, high, number = lever.now, end, end
        best: RepairOption | None = None
        for _ in range(HALVINGS):
            changes = lever.at(number)
            way = self.way(changes) if changes is not None else None
            if way is not None and not way.breaks:
                low, best = number, way
                if number == end:
                    break
            else:
                high = number
            number = self._whole(lever, self._rounded(lever, low + 0.4 * (high - low), low + 0.6 * (high - low)))
        return best

    def _step(self, lever: Lever, change: float) -> float:
        """A number of the lever after a relative change; whole where it is whole, and another one than now."""
        off = change * lever.scale
        if lever.about.kind == "integer" or (lever.about.unit == "µm" and abs(off) < 1.0 and lever.scale >= 50.0):
            off = copysign(max(1.0, round(abs(off))), off)
        return lever.now + off

    def _rounded(self, lever: Lever, low: float, high: float) -> float:
        return high if lever.about.kind == "integer" or low == high else rounded(low, high)

    def _ends(
        self, lever: Lever, wanted: tuple[Check, ...], start: float, first: float, score: float
    ) -> tuple[float, float] | float:
        """The largest number (seen from now) that is known not to help and the smallest that does; or the one that
        comes nearest."""
        sign = copysign(1.0, first - lever.now)
        end = lever.now + sign * FARTHEST[sign] * lever.scale
        end = self._rounded(lever, end - sign * ROUND * lever.scale, end)
        low, at_low = lever.now, start
        number, here = first, score
        nearest, most = first, score
        for _ in range(STRIDES):
            if here >= 0:
                break
            rise = (here - at_low) / (number - low) if number != low else 0.0
            low, at_low = number, here
            if rise * sign <= 0:
                return nearest
            step = -here / rise * 1.05
            number = self._whole(lever, low + copysign(max(abs(step), 0.01 * lever.scale), step))
            number = min(number, end) if sign > 0 else max(number, end)
            while (changes := lever.at(number)) is None or isnan(here := self.score(self.tried(changes), wanted)):
                # not allowed, or without solution: half as far
                number, before = (self._whole(lever, (low + number) / 2), number)
                if abs(number - low) < 0.01 * lever.scale or number == before:
                    return nearest
            if here > most:
                nearest, most = number, here
        if here < 0:
            return nearest
        high = number
        for _ in range(2):  # the stretch between the two, by its slope
            if abs(high - low) < 0.03 * lever.scale or here == at_low:
                break
            middle = self._whole(lever, low + (high - low) * max(0.2, min(0.9, -1.05 * at_low / (here - at_low))))
            if middle in (low, high):
                break
            there = self.score(self.tried(lever.at(middle)), wanted)
            if there >= 0:
                high, here = middle, there
            else:
                low, at_low = middle, there
        return low, high

    def _whole(self, lever: Lever, number: float) -> float:
        if lever.about.kind != "integer":
            return number
        return lever.now + copysign(max(1.0, abs(round(number - lever.now))), number - lever.now)


# --- bearings that fail
# The nearest ones that fit, else journals as long as their films ask for, with the bearings further out.


def bearings_or_longer_journals(
    state: RepairState, failing: tuple[Check, ...], progress: Progress | None = None
) -> RepairState:
    """Raises NoSolution where neither helps."""
    try:
        return sizing.nearest_bearings(state, failing, part(progress, 0.0, 0.5))
    except NoSolution as none:
        try:
            return longer_journals(state, failing, part(progress, 0.5, 1.0))
        except NoSolution:
            raise none from None


def longer_journals(state: RepairState, failing: tuple[Check, ...], progress: Progress | None = None) -> RepairState:
    """Journals as much longer as their films ask for, outwards where the masses leave no room.  Raises NoSolution."""
    for n, place in enumerate(PLACES):
        group = tuple(c for c in failing if c.id.startswith(f"bearings.{place}."))
        key = f"bearings.{place}.length_mm"
        if not group:
            continue
        here = part(progress, n / len(PLACES), (n + 1) / len(PLACES))
        way = Trials(state, "bearings", group, here, named(state.document, key)).best(
            LeverPlan((key,), tuple(levers(state, [key])))
        )
        if way is None or way.quality > AS_GIVEN:
            raise NoSolution(Text("no longer journal is enough, {place}", place=PLACES[place]))
        state = state.with_changes(dict(way.made), way.results)
    return state
