# SPDX-License-Identifier: Apache-2.0
"""Figures of the drive over speed: how fast the flanks strike over speed and load, one working cycle of a mesh between
its flanks, and where the nominal backlash stands between jam and rattle.

Made when somebody looks: the map of 60 speeds costs a keystroke or two."""

from collections.abc import Iterator
from functools import partial

import numpy as np

from ...sheet.arrays import Array
from ...sheet.record import replace
from ...sheet.step import Curve, Series, Walk, axis_label
from ...sheet.text import EMPTY, Amount, Text
from ...sheet.value import untraced
from .checks import grade_limits
from .result import HARDEST, IDLE, DriveResult
from .source import Drive, Source
from .strikes import course, speed_over_backlash
from .survey import Survey

MM_S, UM, RPM = 1e3, 1e6, 60.0
LOAD_WORDS = {0.0: Text("no load"), 0.5: Text("half load"), 1.0: Text("full load")}
BELOW = -0.05  # of the highest strike: where the bar of the reversal lies under the axis
SPIKE = 0.35  # of the backlash: the mark of the hardest strike of a cycle
WIDTHS = 60  # backlashes of which the strikes are drawn


def load_words(source: Source, load: float) -> Text:
    """An irregularity that is given or taken is the same at any load."""
    if source.J_E is None:
        return Text("any load")
    return LOAD_WORDS.get(load, Text("load {percent}", percent=Amount(100 * load, "%", form=".0f")))


def curves(drive: DriveResult | None) -> Iterator[Curve]:
    """First those that a short report has."""
    if drive is None or not drive.meshes:  # not known, or chains alone
        return
    yield strikes_over_speed(drive)
    yield from window(drive)
    yield from cycles(drive)


# --- strikes over speed


def strikes_over_speed(drive: DriveResult) -> Curve:
    """The hardest strike in the train, a line for each load; the limits of the grades, which are judged at idle without
    load alone, and the speeds at which flanks part, as a bar under the axis."""
    map_ = drive.drive.drawn()
    u = map_.impacts.speed.max(axis=1) * MM_S
    series = [
        Series(load_words(drive.drive.source, load), map_.speeds[map_.loads == load] * RPM, u[map_.loads == load])
        for load in drive.drive.source.loads
    ]
    ends = [(mesh.reversal_from, mesh.reversal_to) for mesh in drive.meshes.values()]
    lows, highs = ([end for of in ends if (end := of[n]) is not None] for n in (0, 1))
    if lows:
        bar = BELOW * max(float(u.max()), grade_limits()[1] * MM_S)
        series.append(
            Series(Text("flanks part"), np.array([min(lows), max(highs)]) * RPM, np.full(2, bar), dashed=True)
        )
    graded = drive.impact_speed is not None
    return Curve(
        "strikes_over_speed",
        Text("Hardest strike in the train over speed"),
        axis_label("speed of the crank", "rpm"),
        axis_label("u", "mm/s"),
        tuple(series),
        limits=tuple((Text("grade {grade}", grade=grade), u * MM_S) for grade, u in zip("AB", grade_limits())),
        point=(drive.idle_speed * RPM, (drive.impact_speed or 0.0) * MM_S) if graded else None,
        fails=drive.grade is not None and drive.grade > 2,
        short=2,
    )


# --- one working cycle


def cycles(drive: DriveResult) -> Iterator[Curve]:
    """Force and way in the mesh that strikes hardest at idle, at idle and where the train strikes hardest; the session
    walks over all speeds and loads that are judged."""
    speeds = drive.survey.each_speed
    body, seen = hardest_body(drive), set[int]()
    for op in (IDLE, HARDEST):
        if op not in drive.at or drive.at[op] in seen:
            continue
        p = drive.at[op]
        seen.add(p)
        here = int(np.argmin(np.abs(speeds - drive.survey.speeds[p]))), _row(drive.drive, drive.survey.loads[p])
        for part in ("force", "way"):
            at = partial(_cycle, drive.drive, speeds, body, op, part)
            yield replace(at(*here), walk=Walk(at, speeds.size, len(drive.drive.source.loads), here))


def _row(drive: Drive, load: float) -> int:
    return int(np.argmin(np.abs(np.array(drive.source.loads) - load)))


def hardest_body(drive: DriveResult) -> int:
    """The body whose own strikes are the fastest at idle without load, else where the train strikes hardest: the last
    of a path, whose backlash is the sum over it."""
    p = drive.at.get(IDLE, drive.at[HARDEST])
    if not drive.survey.strikes.hardest[p].any():
        p = drive.at[HARDEST]
    u = drive.survey.strikes.hardest[p]
    toothed = np.flatnonzero(drive.survey.bodies.toothed)
    return int(np.argmax(u)) if u.any() else int(toothed[-1])


def _cycle(drive: Drive, speeds: Array, body: int, op: str, part: str, step: int, row: int) -> Curve:
    """One of both figures of a cycle, at one of the speeds and loads."""
    n, load = float(speeds[step]), drive.source.loads[row]
    with untraced():
        of = drive.survey(np.array([n]), np.array([load]))
        epsilon, y, F = course(of.motion, of.bodies, 0, body)
    degrees = np.degrees(epsilon)
    words = dict(
        pair=drive.line.links[body].title, n=Amount(n * RPM, "rpm", form=".0f"), load=load_words(drive.source, load)
    )
    x_label, stack = axis_label("crank", "°"), f"cycle_{op}"
    if part == "force":
        return Curve(
            f"cycle_force_{op}",
            Text("{n}, {load}: force in {pair} over a cycle", **words),
            x_label,
            axis_label("force, without the peaks of the strikes", "N"),
            (Series(EMPTY, degrees, F),),
            limits=((Text("no force"), 0.0),),
            stack=stack,
        )
    return Curve(
        f"cycle_way_{op}",
        Text("{n}, {load}: {pair} between its flanks", **words),
        x_label,
        axis_label("way between the flanks", "µm"),
        (Series(Text("way"), degrees, y * UM), *_flanks(of, body)),
        stack=stack,
    )


def _flanks(of: Survey, body: int) -> Iterator[Series]:
    """Both flanks as lines, with a spike outward for every strike: the hardest is a third of the backlash high."""
    hits, cycle = of.strikes, of.motion.cycle
    J = hits.backlash[0, body] * UM
    if not hits.orbit[0, body]:
        return
    first, length = int(hits.first[0, body]), hits.orbit[0, body] * of.motion.omega[0]
    start = hits.let_go[0, body, first]
    for flank, words in ((1, Text("driving flank, its strikes")), (-1, Text("coast flank, its strikes"))):
        events = np.flatnonzero((hits.speed[0, body] > 0) & (hits.flank[0, body] == flank))
        at = [
            ((hits.struck[0, body, e] + n * length) % cycle, hits.speed[0, body, e])
            for e in events
            for n in range(int(np.ceil(cycle / length)))
            if hits.struck[0, body, e] - start + n * length < cycle
        ]
        base = 0.0 if flank > 0 else -J
        x, y = [0.0], [base]
        for angle, u in sorted(at):
            x += [angle] * 3
            y += [base, base + flank * SPIKE * J * u / hits.hardest[0, body], base]
        yield Series(words, np.degrees(np.array([*x, cycle])), np.array([*y, base]))


# --- the backlash window


def window(drive: DriveResult) -> Iterator[Curve]:
    """The hardest strike at idle without load over the nominal backlash of the way that has the least room, with the
    grades; upright what jamming asks for, what rattle or phase allow, and the backlash as it is.  What has no value is
    not drawn."""
    way, line = drive.window, drive.drive.line
    if way is None:
        return
    lever = drive.survey.bodies.lever[:, way.body]
    least = sum(float(line.play["least"][i] * lever[i]) for i in map(line.index, way.taken))
    allows = Text("late above") if way.by_phase else Text("may rattle above")
    marks = [
        (Text("may jam below"), way.low),
        (allows, way.high),
        (Text("smallest, warm"), least),
        (Text("nominal"), float(way.nominal)),
        (Text("largest, warm"), float(way.nominal + way.widened)),
    ]
    known = [float(J) for _, J in marks if J is not None]
    J = np.linspace(0.0, 1.05 * max(known), WIDTHS)
    with untraced():
        u = speed_over_backlash(drive.survey.motion, drive.survey.bodies, way.body, J, drive.at[IDLE])
    quiet, loud = grade_limits()
    upright = np.array([0.0, 1.05 * max(float(u.max()), loud) * MM_S])
    lines = [
        Series(
            Text("{mark} {J}", mark=words, J=Amount(J * UM, "µm", form=".0f")), np.full(2, J * UM), upright, dashed=True
        )
        for words, J in marks
        if J is not None and J > 0  # a mesh that jams has none
    ]
    yield Curve(
        "backlash_window",
        Text("Strikes at idle over the nominal backlash on the way to {wheel}", wheel=line.links[way.body].driven),
        axis_label("nominal backlash along the line of action", "µm"),
        axis_label("u", "mm/s"),
        (Series(Text("hardest strike"), J * UM, u * MM_S), *lines),
        limits=((Text("grade A"), quiet * MM_S), (Text("grade B"), loud * MM_S)),
        point=(float(way.nominal) * UM, float(np.interp(float(way.nominal), J, u)) * MM_S),
        short=3,
    )
