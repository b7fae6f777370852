# SPDX-License-Identifier: Apache-2.0
"""The smallest change of one kind by which a finding and its group hold; whole designs are tried, each once."""

from math import copysign, isnan, nan

from ...design.addresses import value_at
from ...sheet.changes import Changes
from ...sheet.check import THIN_MARGIN, Check
from ...sheet.errors import BadInput, NoSolution
from ...sheet.progress import Progress, tell
from ...sheet.search import rounded
from ...sheet.step import Outcome
from ...sheet.text import Text
from ...repair.kinds import called
from .levers import Lever, Plan
from .state import State
from ...repair.way import ALL_CORNERS, AS_GIVEN, BREAKS, NEAR, Way, made_way
from ...design.names import published

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

    def __init__(self, state: State, step: str, group: tuple[Check, ...], progress: Progress | None, name: Text) -> None:
        self.state, self.step, self.group, self.progress, self.name = state, step, group, progress, name
        self.ids = {c.id for c in group}
        self.known: dict[tuple[str, bool], State | None] = {}
        self.ended = False  # whether the last one was solved as far as the group only

    def best(self, plan: Plan) -> Way | None:
        """The best way of a kind; None where it brings nothing."""
        found: list[Way] = []
        for changes in plan.sets:
            if (way := self.way(changes)) is not None:
                found.append(way)
                if way.quality == ALL_CORNERS:
                    break
        limits = tuple(c for c in self.group if c.verdict == "fail") or self.group[:1]
        for lever in plan.levers:
            if any(way.quality == ALL_CORNERS and way.disturbance < LARGE for way in found):
                break
            for wanted in (self.group, limits) if limits != self.group else (self.group,):
                way = self.moved(lever, wanted)
                if way is not None:
                    found.append(way)
                if way is not None and way.quality in (ALL_CORNERS, BREAKS) and wanted is self.group:
                    break
        found = sorted(filter(self._worth, found), key=lambda way: (way.quality, way.disturbance))
        given = next((way for way in found if way.quality == AS_GIVEN), None)
        if found and given is not None and found[0].disturbance > max(DEAR * given.disturbance, LARGE):
            return given
        return next(iter(found), None)

    # --- trying
    def tried(self, changes: Changes | None, whole: bool = False) -> State | None:
        """The design with a change, solved no further than to the checks of the group; `whole`: to the end."""
        if changes is None:
            return None
        name = str(changes)
        if (name, whole) not in self.known:
            tell(self.progress, 1 - 0.9 ** len(self.known), self.name)
            self.ended = False
            begun = self.known.get((name, False))
            try:
                after = self.state.with_changes(changes, begun.results if begun else None, None if whole else self._known)
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

    def score(self, after: State | None, wanted: tuple[Check, ...]) -> float:
        """The least margin of what is to hold, from what it needs; no number where there is none."""
        if after is None or after.outcome(self.step).state != "solved":
            return nan
        there = {c.id: c for c in after.outcome(self.step).checks}
        margins = [there[c.id].margin - (THIN_MARGIN if c.narrow else 0.0) for c in wanted if c.id in there]
        return min(margins, default=nan)

    def way(self, changes: Changes) -> Way | None:
        """What changes come to; None where they are not allowed, or without a solution."""
        after = self.tried(changes, whole=True)
        if after is None or after.outcome(self.step).state != "solved":
            return None
        made = {key: after.changes[key] for key in after.changes}
        if not made:
            return None
        key = next((key for key in made if made[key] is not None), next(iter(made)))
        way = made_way(self.state, after, made, self.group, called(self.state.document, key, self._now(key), made[key]))
        return way

    def _worth(self, way: Way) -> bool:
        """Whether it is worth a row: it breaks little, and comes clearly nearer."""
        if way.quality == NEAR:
            gap, still = (-self.score(state, self.group[:1]) for state in (self.state, self._after(way)))
            return not way.breaks and still < gap * (1 - NEARER)
        return len(way.breaks) <= MANY

    def _after(self, way: Way) -> State | None:
        return State(self.state.document, way.results) if way.results is not None else None

    def _now(self, key: str) -> object:
        now = value_at(self.state.document.data, key)
        if now is None and (there := published(self.state.results, key)) is not None:
            return there.shown
        return now

    # --- one number
    def moved(self, lever: Lever, wanted: tuple[Check, ...]) -> Way | None:
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
                if self.score(self.tried(lever.at(number)), wanted) >= 0 and (way := self.way(lever.at(number) or {})) is not None:
                    return way if not way.breaks or way.disturbance < LARGE else self._nearer(lever, number)
            return self._nearer(lever, ends) if not isinstance(ends, tuple) else None
        return None

    def _nearer(self, lever: Lever, end: float) -> Way | None:
        """As far towards a number as nothing else breaks."""
        low, high, number = lever.now, end, end
        best: Way | None = None
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

    def _ends(self, lever: Lever, wanted: tuple[Check, ...], start: float, first: float, score: float) -> tuple[float, float] | float:
        """The largest number (seen from now) that is known not to help and the smallest that does; or the one that comes nearest."""
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
                number, before = self._whole(lever, (low + number) / 2), number  # not allowed, or without solution: half as far
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
