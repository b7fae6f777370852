# SPDX-License-Identifier: Apache-2.0
"""One way to mend a finding: what it changes, how far it comes, and what it does to all the rest."""

from collections.abc import Iterable
from dataclasses import dataclass, field

from ..design.locks import USUAL
from ..sheet.changes import Changes, assignments
from ..sheet.check import Check
from ..sheet.text import COMMA, EMPTY, SEMICOLON, Amount, Text, plural
from ..solve import Results
from ..studies.repair.levers import disturbance
from ..studies.repair.state import ORDER, State, broken
from ..design.names import words

MOST, SHUT = 5, 2  # that are offered, and of these locked ones
ALL_CORNERS, AS_GIVEN, BREAKS, NEAR, LOCKED = range(5)  # how good a way is


@dataclass(frozen=True)
class Way:
    """One remedy.  `kind`: in the words of the trade; `words`: the change in labels and units of the fields; `made`: each
    key with its new value, `changes` the same as KEY=VALUE.

    `passes`: the finding and the limits of its group hold; `effect` says how far it comes.  `left`: names of what is still open in the
    group; `breaks`: names of limits that fail then and did not, and of steps without a solution.  `verdicts`: step, before, after.
    `power` [W], `mass` [kg]: before and after, of the crank's loss and the shaft; `cold` [µm]: the cold clearance, of a bearing.
    `locked`: why it was not looked at.  `missing`: it gives an input that was not there.
    """

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
        parts = [Text("{change}", change=Amount(b - a, unit, form="+.3g")) for pair, unit in ((self.power, "W"), (self.mass, "kg"))
                 if pair is not None and abs((b := pair[1]) - (a := pair[0])) > 5e-4 * abs(a)]  # fmt: skip
        if self.cold is not None:
            parts.append(Text("cold gap {gap}", gap=Amount(self.cold, "µm", digits=3)))
        text = COMMA.join(parts) if parts else EMPTY
        if self.breaks:
            fails = Text("then fails: {checks}", checks=COMMA.join(self.breaks[:2]))
            text = SEMICOLON.join([text, fails]) if text else fails
        return text


def ranked(ways: Iterable[Way]) -> tuple[Way, ...]:
    """The best few, what passes everything first, then by the smallest disturbance; what is locked last."""
    every = sorted(ways, key=lambda way: (way.quality, way.disturbance))
    shut = sorted((way for way in every if way.locked), key=lambda way: way.keys[0] in USUAL)[:SHUT]
    return (*[way for way in every if not way.locked][: MOST - len(shut)], *shut)


def made_way(state: State, after: State, changes: Changes, group: tuple[Check, ...], kind: Text) -> Way:
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
    return Way(
        kind, tuple(changes), tuple(changes.items()), words(state.document, before, changes), _effect(group, left, quality), quality,
        disturbance(state, changes.items()), tuple(c.name for c in left), breaks,
        tuple((key, before.outcomes[key].verdict, then.outcomes[key].verdict) for key in ORDER),
        _pair(before, then, "friction.total_loss"), _pair(before, then, "countershaft.mass"), gap.shown if gap is not None else None,
        results=then,
    )  # fmt: skip


def _pair(before: Results, after: Results, id: str) -> tuple[float, float] | None:
    one, other = before.values().get(id), after.values().get(id)
    return (one.shown, other.shown) if one is not None and other is not None else None


def _open_still(after: State, group: tuple[Check, ...]) -> tuple[Check, ...]:
    """Of a group what is not mended: a limit that failed must hold, all else must be closed."""
    there = {c.id: c for outcome in after.results.outcomes.values() for c in outcome.checks}
    return tuple(there[c.id] for c in group if c.id in there and (there[c.id].open if c.verdict != "fail" else not there[c.id].holds))


def _effect(group: tuple[Check, ...], left: tuple[Check, ...], quality: int) -> Text:
    if quality == NEAR and left:
        worst = left[0]
        if worst.id != group[0].id:
            return Text("still open: {checks}", checks=worst.name)
        return Text("comes to {value}, needs {limit}", value=Amount(worst.value, worst.unit, digits=3), limit=worst.limit_text())
    if left:
        return plural("passes as given; {n} finding is still open", "passes as given; {n} findings are still open", n=len(left))
    return Text("passes, also at every corner") if any("corner" in c.id or "worst" in c.id for c in group) else Text("passes")
