# SPDX-License-Identifier: Apache-2.0
"""Where nothing passes: the nearest miss, and which one requirement would have to give way, and by how much.

Only what the file calls a requirement is moved: the largest seat, the places of the bearings, the couple beyond the
required one, the fillet, the margin, and what could be chosen otherwise (fits, surfaces, supply, oil).  Limits of
checks are never relaxed; they are named. Each line is one change alone, sought on the tables and confirmed by a whole
solution before it is said."""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from ...bearings.plain.selection.states import ROUGHNESSES
from ...bearings.plain.selection.variants import ENGINE_OIL, FINEST, SUPPLY
from ...countershaft.inputs import ShaftInputs
from ...countershaft.making.parts import SUPPORT_WALL
from ...countershaft.rows import BearingRow
from ...design.model import IN_SENTENCES, Design
from ...design.names import asked as input_asked
from ...design.toml_file import Document, design
from ...library.lubricant import Lubricant
from ...library.tolerances import parse
from ...sheet.check import Check
from ...sheet.errors import BadInput, NoSolution
from ...sheet.progress import Progress, tell
from ...sheet.record import record, replace
from ...sheet.text import COMMA, EMPTY, Name, Text
from ...sheet.value import untraced
from .classes import NotClosed, class_with, sized
from .combinations import DriveRows
from .output import LABELS
from .problem import FITS, OIL, SEAT_REACH, SUPPLY_KEY, SURFACES, Problem
from .search import FrontFound
from .solved_drive import Whole, whole

FEW = 12  # diameters of the smaller journal that are looked at for a question alone
HALVINGS = 6
NAMED = 3  # of what is broken, before the rest is counted
WORST = -0.9  # margin to which a nearest miss is looked for


@record
class RefusalLine:
    """One change alone that lets something pass: its key, from and to in words, what it costs beside; `broken`: what it
    then breaks."""

    key: str
    change: Text
    beside: Text
    broken: tuple[str, ...] = ()


@record
class Refusal:
    """`always`: checks that fail in every drive that was tried whole; `miss`: by how much the nearest misses, of 1;
    None: not known."""

    always: tuple[str, ...]
    miss: float | None
    lines: tuple[RefusalLine, ...]
    useless: tuple[Text, ...]
    also: tuple[str, ...] = ()  # what every one of the lines breaks beside: it is to be repaired elsewhere


def refusal(front: FrontFound, progress: Progress | None = None) -> Refusal:
    """Why a search found nothing, and what alone would help."""
    problem = front.problem
    if front.dropped:
        every = [set(drive.broken) for drive in front.dropped]
        return Refusal(tuple(sorted(set.intersection(*every))) or tuple(sorted(set.union(*every))), None, (), ())
    with untraced():
        return _relaxed(problem, progress)


def _relaxed(problem: Problem, progress: Progress | None) -> Refusal:
    lines: list[RefusalLine] = []
    useless: list[Text] = []
    tell(progress, 0.0, Text("nearest miss"))
    miss = _nearest_miss(problem)
    ways = list(_ways(problem))
    for n, (what, way) in enumerate(ways):
        tell(progress, 0.1 + 0.9 * n / len(ways), what)
        line = way()
        if line is None:
            useless.append(what)
        else:
            lines.append(line)
    also = set.intersection(*(set(line.broken) for line in lines)) if lines else set()
    lines = [replace(line, broken=tuple(id for id in line.broken if id not in also)) for line in lines]
    return Refusal((), miss, tuple(lines), tuple(useless), tuple(sorted(also)))


def said(ids: Sequence[str], document: Document, checks: Iterable[Check]) -> Text:
    """What is broken, in words: the names of the first checks, of steps without a solution and of bounds, and how many
    more there are."""
    names = {check.id: check.name for check in checks}
    names |= {step: Text("{step} has no solution", step=title) for step, title in IN_SENTENCES.items()}
    names |= {
        f"optimise.most.{name}": Text("the bound on the {objective}", objective=word) for name, word in LABELS.items()
    }
    words = [names.get(id) or input_asked(document, id) for id in ids[:NAMED]]
    first, more = COMMA.join(words), len(ids) - NAMED
    return Text("{names} and {n} more", names=first, n=more) if more > 0 else first


# --- one question


def quick(problem: Problem) -> Problem:
    """The same with few diameters of the smaller journal, and no margin but the least."""
    seat, small = (problem.keys.of_bearing(place, BearingRow.diameter) for place in (problem.seat, problem.small))
    values, seats = problem.sizes[small] or (), problem.sizes[seat] or ()
    few = values[:: max(1, math.ceil(len(values) / FEW))]
    sizes = {**problem.sizes, small: few, seat: seats[-1:]}
    return replace(problem, sizes=sizes, margins=problem.margins[:1])


def of_closest_fits(classes: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Those of the closest fits: where their worst corners do not hold, those of wider fits, which enclose them, do not
    either."""

    def within(inner: dict[str, Any], other: dict[str, Any]) -> bool:
        pairs = [(parse(a), parse(b)) for a, b in zip(inner[FITS], other[FITS])]
        alike = inner | {FITS: None} == other | {FITS: None} and all(a.letter == b.letter for a, b in pairs)
        return alike and all(a.grade <= b.grade for a, b in pairs) and any(a.grade < b.grade for a, b in pairs)

    return [candidate for candidate in classes if not any(within(other, candidate) for other in classes)]


def passing(problem: Problem) -> tuple[dict[str, Any], DriveRows] | None:
    """The rows of the first class that has any; None: nothing passes."""
    return next(_passing(problem, of_closest_fits(problem.classes)), None)


def _passing(problem: Problem, classes: list[dict[str, Any]]) -> Iterator[tuple[dict[str, Any], DriveRows]]:
    for choices in classes:
        try:
            rows = class_with(problem, choices)
        except NotClosed:
            raise
        except NoSolution:
            continue
        if len(rows):
            yield choices, rows


def _confirmed(problem: Problem) -> Whole | None:
    """A drive of a changed problem, solved whole: of little power, the first that breaks nothing, else that which
    breaks least; None: there is none."""
    first, tried = of_closest_fits(problem.classes), list[Whole]()
    for classes in (first, [candidate for candidate in problem.classes if candidate not in first]):
        for choices, rows in _passing(problem, classes):
            for n in np.argsort(rows.power, kind="stable")[:3]:
                tried.append(whole(problem, sized(problem, choices, rows, int(n)))[0])
                if not tried[-1].broken:
                    return tried[-1]
            if classes is not first:
                break  # one more class is enough
        if not tried:
            return None
    return min(tried, key=lambda drive: len(drive.broken))


def _nearest_miss(problem: Problem) -> float | None:
    """The margin that the best drive of the ranges lacks, found by halving."""
    reduced = quick(problem)
    least = reduced.margins[0]

    def holds(margin: float) -> bool:
        return passing(replace(reduced, margins=(margin,))) is not None

    if not holds(WORST):
        return None
    low, high = WORST, least
    for _ in range(HALVINGS + 1):
        middle = (low + high) / 2
        low, high = (middle, high) if holds(middle) else (low, middle)
    return least - low


# --- the ways

Requirement = tuple[Text, Callable[[], RefusalLine | None]]


def _ways(problem: Problem) -> Iterator[Requirement]:
    shaft, base = problem.shaft, problem.base
    seats = problem.sizes[problem.keys.of_bearing(problem.seat, BearingRow.diameter)] or ()
    if seats:
        yield Text("a larger seat"), lambda: _seat(problem, max(seats))
    z = {problem.keys.of_bearing(row.name, BearingRow.position): row.position * 1e3 for row in base.rows}
    yield (
        Text("bearings further apart"),
        lambda: _stretched(
            problem,
            problem.keys.of_bearing("*", BearingRow.position),
            0.1,
            lambda share: {key: round(x * (1 + share), 2) for key, x in z.items()},
            lambda moved: Text("{a} → {b} mm", a=Name(_list(z.values())), b=Name(_list(moved.values()))),
        ),
    )
    x_o, beyond = shaft.overdesign * 100, base.own_key(ShaftInputs.overdesign)
    yield (
        Text("less couple beyond the required one"),
        lambda: _stretched(
            problem,
            beyond,
            0.05,
            lambda share: {beyond: round(x_o - share * 100, 2)},
            lambda moved: Text("{a} → {b} %", a=Name(f"{x_o:g}"), b=Name(f"{moved[beyond]:g}")),
        ),
    )
    r, fillet = problem.fillet, base.own_key(ShaftInputs.fillet_radius)
    if r:
        yield (
            Text("a smaller fillet"),
            lambda: _stretched(
                problem,
                fillet,
                0.8,
                lambda share: {fillet: round(r * (1 - share), 3)},
                lambda moved: Text("{a} → {b} mm", a=Name(f"{r:g}"), b=Name(f"{moved[fillet]:g}")),
            ),
        )
    yield from _chosen(problem)


def _list(values: Iterable[float]) -> str:
    return "[" + ", ".join(f"{x:g}" for x in values) + "]"


def _seat(problem: Problem, now: float) -> RefusalLine | None:
    """The least larger seat; the wall beside it gives what it takes, and may be what is then broken."""
    key = problem.keys.of_bearing(problem.seat, BearingRow.diameter)

    def at(seat: float) -> Problem:
        reduced = quick(problem)
        return replace(
            reduced,
            sizes={**reduced.sizes, key: (round(seat, 2),)},
            most={k: v for k, v in reduced.most.items() if k != "seat"},
        )

    seat = _least(lambda d: passing(at(now + d)) is not None, SEAT_REACH)
    seat = None if seat is None else math.ceil(seat * 100 - 1e-6) / 100
    if seat is None or (drive := _confirmed(at(now + seat))) is None:
        return None
    broken = tuple(id for id in drive.broken if id not in (SUPPORT_WALL.id, "optimise.most.seat"))
    return RefusalLine(
        key,
        Text("{a} → {b} mm", a=Name(f"{now:g}"), b=Name(f"{now + seat:g}")),
        _wall(problem, now, now + seat),
        broken,
    )


def _wall(problem: Problem, now: float, seat: float) -> Text:
    support = problem.shaft.support
    if support is None or support.wall is None or support.wall_at_seat is None:
        return EMPTY
    left = [(support.wall - (d * 1e-3 - support.wall_at_seat) / 2) * 1e3 for d in (now, seat)]
    return Text(
        "wall {a} → {b} mm, least_wall_mm {least}",
        a=Name(f"{left[0]:.2f}"),
        b=Name(f"{left[1]:.2f}"),
        least=Name(f"{support.least_wall * 1e3:g}"),
    )


Moved = Mapping[str, float]  # keys and their new values


def _stretched(
    problem: Problem, key: str, reach: float, moved: Callable[[float], Moved], words: Callable[[Moved], Text]
) -> RefusalLine | None:
    """One requirement moved by the least share that lets something pass; `key`: what it is called."""

    def at(share: float) -> Problem | None:
        return _with(quick(problem), moved(share))

    def holds(share: float) -> bool:
        candidate = at(share)
        return candidate is not None and passing(candidate) is not None

    share = _least(holds, reach)
    changed = at(share) if share is not None else None
    if share is None or changed is None or (drive := _confirmed(changed)) is None:
        return None
    return RefusalLine(key, words(moved(share)), EMPTY, drive.broken)


def _with(problem: Problem, moved: Moved) -> Problem | None:
    """The problem of a changed design; None where that is none."""
    start = problem.start
    for key, value in moved.items():
        start = start.with_value(key, value)
    try:
        base: Design = design(start)
    except BadInput:
        return None
    return replace(problem, start=start, base=base)


def _least(holds: Callable[[float], bool], reach: float) -> float | None:
    """The least change up to `reach` that helps; None: not even that does."""
    if not holds(reach):
        return None
    low, high = 0.0, reach
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        low, high = (low, middle) if holds(middle) else (middle, high)
    return math.ceil(high * 1e3 - 1e-6) / 1e3


def _chosen(problem: Problem) -> Iterator[Requirement]:
    """What could be chosen otherwise, each alone: the closest fits, the smoothest surfaces, another supply, a thicker
    oil."""
    reduced, bearings = quick(problem), problem.base.bearings
    assert bearings is not None
    fits = [str(bearings.journal_fit), str(bearings.seat_fit)]
    closest = [f"{parse(fit).letter or 'IT'}{min(FINEST, parse(fit).grade)}" for fit in fits]
    if closest not in [list(x) for x in problem.choices.get(FITS, ())]:
        yield Text("closer fits, {fits}", fits=Name("/".join(closest))), lambda: _choice(reduced, FITS, closest)
    smooth = min(ROUGHNESSES) * 1e6
    if all(pair is None or max(pair) > smooth + 1e-9 for pair in problem.surfaces):
        yield (
            Text("smoother surfaces, {Ra} µm", Ra=Name(f"{smooth:g}/{smooth:g}")),
            lambda: _smooth(reduced, (smooth, smooth)),
        )
    for name in _thicker(problem):
        yield Text("the oil {name}", name=Name(name)), lambda name=name: _choice(reduced, OIL, name)  # type: ignore[misc]
    for supply, width in (("groove", bearings.groove_width), ("pocket", bearings.pocket_width)):
        if width is not None and supply not in problem.choices.get(SUPPLY_KEY, ()):
            yield SUPPLY[supply], lambda supply=supply: _choice(reduced, SUPPLY_KEY, supply)  # type: ignore[misc]


def _thicker(problem: Problem) -> list[str]:
    """Engine oils that are thicker than the design's as they enter, the thinnest of them first."""
    design, bearings = problem.base, problem.base.bearings
    assert bearings is not None
    at = bearings.supply_temperature
    mu = {
        name: Lubricant(bearings.in_bearings(oil), bearings.viscosity_law).at(at).mu
        for name, oil in design.oils.items()
        if ENGINE_OIL.match(name) or name == bearings.oil
    }
    own_mu = mu[bearings.oil]
    return sorted((name for name in mu if mu[name] > own_mu * 1.02), key=lambda name: mu[name])


def _choice(problem: Problem, key: str, value: Any) -> RefusalLine | None:
    drive = _confirmed(replace(problem, choices={**problem.choices, key: (value,)}))
    words = "/".join(value) if isinstance(value, list) else str(value)
    return None if drive is None else RefusalLine(key, Text("{value}", value=Name(words)), EMPTY, drive.broken)


def _smooth(problem: Problem, pair: tuple[float, float]) -> RefusalLine | None:
    drive = _confirmed(replace(problem, surfaces=(pair,)))
    words = Name("/".join(f"{x:g}" for x in pair))
    return None if drive is None else RefusalLine(SURFACES, Text("Ra {pair} µm", pair=words), EMPTY, drive.broken)
