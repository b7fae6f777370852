# SPDX-License-Identifier: Apache-2.0
"""One way to mend a finding: what it changes, how far it comes, and what it does to all the rest."""

from collections.abc import Iterable
from dataclasses import dataclass

from ...bearings.plain.checks import CLEARANCE_COLD_CORNER, FILM_EDGE_CORNER, TEMPERATURE_CORNER
from ...bearings.plain.result import PlainResult
from ...countershaft.result import CountershaftResult
from ...countershaft.shafts import ShaftsResult
from ...design.locks import USUAL
from ...design.names import asked, words
from ...friction.result import FrictionResult
from ...gears.backlash.checks import BACKLASH_WORST
from ...sheet.check import Check
from ...sheet.remedy import Changes, assignments
from ...sheet.text import COMMA, EMPTY, SEMICOLON, Amount, Text, plural
from ...sheet.verdict import named as named_checks
from ...solve import Results
from .effects import NO_EFFECTS, SideEffects, first_of, side_effects
from .levers import disturbance
from .state import ORDER, RepairState, broken, closer_limits, is_mended

MOST, SHUT = 6, 2  # that are offered, and of these locked ones
ALL_CORNERS, AS_GIVEN, BREAKS, NEAR, LOCKED = range(5)  # how good a way is


@dataclass(frozen=True)
class RepairOption:
    """One remedy.  `kind`: in the words of the trade; `words`: the change in labels and units of the fields; `made`:
    each key with its new value, `changes` the same as KEY=VALUE.

    `passes`: the finding and the limits of its group hold; `effect` says how far it comes.  `left`: names of what is
    still open in the group; `breaks`: names of limits that are judged worse then, and of steps without a solution;
    `closer`: of limits that come closer to failing, or further out, in words. `verdicts`: step, before, after. `power`
    [W], `mass` [kg], `cold` [µm]: before and after, of the crank's loss, the shaft and the cold clearance of a bearing.
    `locked`: by what lock it was not looked at; what is held otherwise says so in `effect`."""

    kind: Text
    keys: tuple[str, ...]
    made: tuple[tuple[str, object], ...] = ()
    words: Text = EMPTY
    effect: Text = EMPTY
    quality: int = LOCKED
    disturbance: float = 0.0
    left: tuple[Text, ...] = ()
    side: SideEffects = NO_EFFECTS
    closer: tuple[Text, ...] = ()
    verdicts: tuple[tuple[str, str, str], ...] = ()
    power: tuple[float, float] | None = None
    mass: tuple[float, float] | None = None
    cold: tuple[float, float] | None = None
    locked: str = ""

    @property
    def changes(self) -> tuple[str, ...]:
        return tuple(assignments(dict(self.made)))

    @property
    def passes(self) -> bool:
        return self.quality < NEAR

    @property
    def breaks(self) -> tuple[Text, ...]:
        return self.side.breaks

    @property
    def result(self) -> Text:
        """How far it comes and how much it opens: `passes; opens 2 cautions`; of what is locked why it was not looked
        at."""
        return SEMICOLON.join([text for text in (self.effect, self.side.counted) if text]) or EMPTY

    @property
    def rest(self) -> Text:
        """What it does beside: `+9 W, +0.4 kg, cold gap 32 µm; then not kept: …`."""
        parts = [
            Text("{change}", change=Amount(b - a, unit, form="+.3g"))
            for pair, unit in ((self.power, "W"), (self.mass, "kg"))
            if pair is not None and _differ(a := pair[0], b := pair[1])
        ]
        if self.cold is not None and _differ(*self.cold):
            parts.append(Text("cold gap {gap}", gap=Amount(self.cold[1], "µm", digits=3)))
        texts = [COMMA.join(parts)] if parts else []
        if self.breaks and self.quality != BREAKS:  # of which the effect says so
            texts.append(Text("then not kept: {checks}", checks=first_of(self.breaks)))
        if self.closer:
            texts.append(Text("then closer: {checks}", checks=COMMA.join(self.closer[:2])))
        return SEMICOLON.join(texts) if texts else EMPTY


def _differ(before: float, after: float) -> bool:
    """Whether it is worth a word."""
    return abs(after - before) > 5e-4 * abs(before)


def ranked(ways: Iterable[RepairOption]) -> tuple[RepairOption, ...]:
    """The best few, what is held last."""
    every = sorted(ways, key=rank)
    shut = sorted((way for way in every if way.quality == LOCKED), key=lambda way: way.keys[0] in USUAL)[:SHUT]
    return (*[way for way in every if way.quality != LOCKED][: MOST - len(shut)], *shut)


def repair_option(
    state: RepairState, after: RepairState, changes: Changes, group: tuple[Check, ...], kind: Text
) -> RepairOption:
    """A way that was found, with all that it does."""
    left = _open_still(after, group)
    side = side_effects(state.results, after.results, [c.id for c in group])
    mine = {c.id for c in (*group, *side.opens)} | set(broken(state, after))
    part = group[0].id.rpartition(".")[0] if group else ""
    closer = tuple(named_checks([c]) for c in closer_limits(state.results, after.results, part) if c.id not in mine)
    limits = any(c.verdict == "fail" for c in left) or (bool(left) and left[0].id == group[0].id)
    quality = NEAR if limits else BREAKS if side.breaks else AS_GIVEN if left else ALL_CORNERS
    before, then = state.results, after.results
    gaps, gaps_then = (
        {v.id.rpartition(".")[0]: v.shown for v in results.values_of(PlainResult.clearance_cold)}
        for results in (before, then)
    )
    return RepairOption(
        kind,
        tuple(changes),
        tuple(changes.items()),
        words(state.document, before, changes),
        _effect(after, group, left, side, quality),
        quality,
        disturbance(state.document, changes),
        tuple(c.name for c in left),
        side,
        closer,
        tuple((key, before.outcomes[key].verdict, then.outcomes[key].verdict) for key in ORDER),
        _pair(before, then, FrictionResult.total_loss),
        _pair(before, then, ShaftsResult.shaft_mass) or _pair(before, then, CountershaftResult.mass),
        (gaps[part], gaps_then[part]) if part in gaps and part in gaps_then else None,
    )


def _pair(before: Results, after: Results, field: object) -> tuple[float, float] | None:
    first, other = before.value(field), after.value(field)
    return (first.shown, other.shown) if first is not None and other is not None else None


def _open_still(after: RepairState, group: tuple[Check, ...]) -> tuple[Check, ...]:
    """Of a group what is not mended: a limit that failed must hold, all else must be closed."""
    there = {c.id: c for c in after.results.checks()}
    return tuple(
        there[c.id]
        for c in group
        if c.id in there and (there[c.id].open if c.verdict != "fail" else not is_mended(there[c.id]))
    )


AT_CORNERS = (FILM_EDGE_CORNER, TEMPERATURE_CORNER, CLEARANCE_COLD_CORNER, BACKLASH_WORST)


def _effect(
    after: RepairState, group: tuple[Check, ...], left: tuple[Check, ...], side: SideEffects, quality: int
) -> Text:
    if quality == BREAKS:
        return Text("mends this; then not kept: {checks}", checks=first_of(side.breaks))
    if quality == NEAR and left:
        worst = left[0]
        if worst.verdict == "not_verified" and worst.missing and worst.holds:
            value = Amount(worst.value, worst.unit, digits=3)
            return plural(
                "{value} as taken; {n} more input is needed",
                "{value} as taken; {n} more inputs are needed",
                n=len(worst.missing),
                value=value,
            )
        if worst.id != group[0].id:
            return Text("still open: {checks}", checks=worst.name)
        return Text(
            "comes to {value}, needs {limit}", value=Amount(worst.value, worst.unit, digits=3), limit=worst.limit_text()
        )
    if left:
        return plural(
            "passes as given; {n} finding is still open", "passes as given; {n} findings are still open", n=len(left)
        )
    ids = {c.id for c in group}
    if unknown := [c for c in after.results.checks() if c.id in ids and c.verdict == "not_verified"]:
        keys = dict.fromkeys(key for c in unknown for key in c.missing)
        if not keys:
            return Text("holds as computed; closer to its limit than can be told")
        inputs = COMMA.join(asked(after.document, key) for key in keys)
        return Text("holds as taken; not verified without {keys}", keys=inputs)
    return Text("passes, also at every corner") if any(c.rule in AT_CORNERS for c in group) else Text("passes")


def rank(way: RepairOption) -> tuple[int, float]:
    """What passes everything first, then by the smallest disturbance."""
    return way.quality, way.disturbance
