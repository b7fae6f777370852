# SPDX-License-Identifier: Apache-2.0
"""What would help against one finding: remedies of different kinds, each the smallest of its kind, with what it does to
all the rest.

A kind that mends the finding at every corner of its group is best, then one that mends it as given, then one that
breaks something else, then one that only comes nearer.  What is locked is shown too, and not searched."""

import time
from collections.abc import Iterator

from ...design.addresses import quantity_of, value_at
from ...design.names import named, written
from ...design.toml_file import Document
from ...sheet.check import KINDS, Check
from ...sheet.errors import BadInput
from ...sheet.progress import Progress, part, tell
from ...sheet.quantity import Quantity
from ...sheet.search import rounded
from ...sheet.text import Text
from ...solve import Results
from .levers import LeverPlan, kind_of, plans
from .state import RepairState, state_of
from .trials import NEAR, RepairOption, Trials, ranked, repair_option

HOUSINGS = ("EN-GJL-250", "EN AC-43100")  # grey iron and aluminium: what housings are usually cast of


def group_of(results: Results, finding: Check) -> tuple[Check, ...]:
    """What is open and shares the cause of a finding, of its kind or a worse one; the finding first."""
    kinds = KINDS[: max(KINDS.index(finding.kind), KINDS.index("caution") if finding.kind == "limit" else 0) + 1]
    cause = finding.cause or finding.id
    same = [
        c for c in results.checks() if c.open and (c.cause or c.id) == cause and c.kind in kinds and c.id != finding.id
    ]
    return (finding, *same)


def ways(
    document: Document,
    finding: Check | str,
    results: Results | None = None,
    progress: Progress | None = None,
    seconds: float | None = None,
) -> tuple[RepairOption, ...]:
    """The best few remedies of one finding, or of a step without a solution.  `progress` may raise `Cancelled`."""
    return ranked(search(document, finding, results, progress, seconds))


def search(
    document: Document,
    finding: Check | str,
    results: Results | None = None,
    progress: Progress | None = None,
    seconds: float | None = None,
) -> Iterator[RepairOption]:
    """All of them, each as soon as it is found; `seconds`: after so many no further kind is begun."""
    state, ends = state_of(document, results), None if seconds is None else time.monotonic() + seconds
    step = finding if isinstance(finding, str) else finding.id.partition(".")[0]
    group = () if isinstance(finding, str) else group_of(state.results, finding)
    yield from _given(state, group)
    looked_at = plans(state, step, group) if group else []
    if any(c.missing for c in group):
        looked_at = []
    yield from (_locked(state, plan, group) for plan in looked_at if plan.reason)
    looked_at = [plan for plan in looked_at if not plan.reason]
    written = set[tuple[str, ...]]()
    for n, plan in enumerate(looked_at):
        if ends is not None and time.monotonic() > ends:
            return
        label = kind_of(document, plan.keys[0])
        name = label.other or label.less
        here = part(progress, n / (len(looked_at) + 1), (n + 1) / (len(looked_at) + 1))
        tell(here, 0.0, name)
        way = Trials(state, step, group, here, name).best(plan)
        if way is not None and way.changes not in written:
            written.add(way.changes)
            yield way
    if (
        (group and group[0].kind != "limit")
        or any(c.missing for c in group)
        or (ends is not None and time.monotonic() > ends)
    ):
        return
    way = _whole_step(state, step, group, part(progress, len(looked_at) / (len(looked_at) + 1), 1.0))
    if way is not None and way.changes not in written:
        yield way


def _whole_step(
    state: RepairState, step: str, group: tuple[Check, ...], progress: Progress | None
) -> RepairOption | None:
    """The nearest design in which all limits of the step hold."""
    from .nearest import remedy

    nearest = remedy(state.document, step, state.results, progress, tries=20)
    if not nearest.changes or (not nearest.mends and group):
        return None
    after = RepairState(nearest.document, nearest.results)
    changes = {
        key: value_at(nearest.document.data, key) for key in (change.partition("=")[0] for change in nearest.changes)
    }
    way = repair_option(state, after, changes, group, Text("all of the step at once"))
    return way if way.quality < NEAR else None


def _given(state: RepairState, group: tuple[Check, ...]) -> Iterator[RepairOption]:
    """Of what can not be judged: the missing inputs, with a usual value where there is one."""
    for key in dict.fromkeys(key for check in group for key in check.missing):
        try:
            about = quantity_of(state.document.data, key)
        except BadInput:
            continue
        kind = Text("give {input}", input=named(state.document, key))
        values = _usual(state, key, about)
        if not values:
            yield RepairOption(kind, (key,), effect=Text("then it can be judged"), quality=NEAR)
        for value in values:
            try:
                after = state.with_changes({key: value})
            except BadInput:
                continue
            yield repair_option(state, after, {key: value}, group, kind)


def _usual(state: RepairState, key: str, about: Quantity) -> tuple[float | int | str, ...]:
    """What is usually given there; of a housing the material of the bearings' first."""
    if about.usual is not None and about.kind in ("number", "integer"):
        low, high = about.usual
        middle = rounded(low + 0.4 * (high - low), low + 0.6 * (high - low))
        return (round(middle) if about.kind == "integer" else middle,)
    if key.endswith("housing_material"):
        of_bearings = state.design.bearings.housing_material if state.design.bearings is not None else None
        return tuple(dict.fromkeys(name for name in (of_bearings, *HOUSINGS) if name))
    return about.choices[:1]


def _locked(state: RepairState, plan: LeverPlan, group: tuple[Check, ...]) -> RepairOption:
    kind = kind_of(state.document, plan.keys[0])
    film = any("film" in check.id or check.id.endswith("transition") for check in group)
    now, label = value_at(state.document.data, plan.keys[0]), named(state.document, plan.keys[0])
    text = Text("{label} {value}", label=label, value=written(now)) if now is not None else label
    name = kind.more if film and plan.keys[0].endswith(".oil") else kind.other or kind.less
    return RepairOption(name, plan.keys, words=text, effect=Text("not looked at"), locked=plan.reason)
