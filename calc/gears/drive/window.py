# SPDX-License-Identifier: Apache-2.0
"""The window of the nominal backlash of each way to a body that strikes: from below what tolerance, runout and
temperature take of it, from above rattle, and what the shaft may leave of its couple and force.

All along the transverse line of action, summed over the meshes of the way that part of themselves and referred to that
of the body that strikes last on it.  The sum does not keep one mesh from jamming: each has its own checks."""

from collections.abc import Callable, Iterable, Mapping

from ...sheet.check import Check
from ...sheet.deferred import Later
from ...sheet.formula import formula
from ...sheet.functions import asin, cos, smallest
from ...sheet.record import record, replace
from ...sheet.remedy import Remedy
from ...sheet.step import Outcome
from ...sheet.text import COMMA, EMPTY, Amount, Text
from ...sheet.units import Metre, MetrePerSecond, Newton, NewtonMetre, Number, Radian
from ...sheet.value import about, based_on, trace, untraced
from ..result import TrainResult
from .checks import grade_limits, window_check
from .line import TrainOnLine
from .result import IDLE, DriveResult, Window
from .strikes import quiet_backlashes

STATES = ("backlash_min_runout", "backlash_cold", "backlash_running", "backlash_warmer", "backlash_warming")
NONE_YET: Metre = 0.0


@record
class MayLeave:
    """What a shaft turns with, and how much of it all shafts together may leave; None where it has none."""

    couple: NewtonMetre | None
    most_couple: NewtonMetre | None
    force: Newton | None
    most_force: Newton | None


# --- formulas


@formula(
    "J_Σ",
    "mathematics: sum over the meshes of a way, J_v: of those before",
    unit="µm",
    names={"J": "J_v", "rho": "ρ_b"},
    meanings={
        "rho": "Speed on the line of action at the end of the way, over that of the mesh",
        "return": "Backlash of the meshes of a way, at its end",
        "J": "Backlash of the meshes before",
    },
)
def with_mesh(J: Metre, j: Metre, rho: Number) -> Metre:
    """`rho`: from the mesh to the end of the way."""
    return J + j * rho


@formula(
    "Δj",
    "rule of this program: what tolerance, runout and temperature take of the nominal backlash at their worst",
    unit="µm",
    names={"j_bn": "j_bn,least"},
    meanings={"return": "Backlash that tolerance, runout and temperature take"},
)
def taken(j: Metre, j_bn: Metre, beta_b: Radian) -> Metre:
    """`j` along the transverse line of action, `j_bn` normal to the flanks.

    >>> taken(j=36e-6, j_bn=-9e-6, beta_b=0.0)
    4.5e-05
    """
    return j - j_bn / cos(beta_b)


@formula(
    "J_q",
    "rule of this program, flanks that strike without rebound: the first backlash of a way, from 0 on, at which they "
    "reach a speed at idle without load",
    shows="J where u(J) = u_q",
    unit="µm",
    names={"u": "u_q"},
    meanings={"return": "Backlash at which strikes at idle are just quiet enough"},
)
def quiet(J: Metre, u: MetrePerSecond) -> Metre:
    """As the search over flights has it."""
    return J


@formula(
    "J_r",
    "rule of this program: nominal backlash whose largest, with tolerances and all warm, is just quiet enough",
    unit="µm",
    names={"J_most": "J_run", "J": "J_Σ"},
    meanings={"return": "Largest nominal backlash that is quiet enough"},
)
def below_rattle(J_q: Metre, J_most: Metre, J: Metre) -> Metre:
    """>>> below_rattle(J_q=198e-6, J_most=264e-6, J=130e-6)
    6.39...e-05
    """
    return J_q - (J_most - J)


@formula(
    "J_φ",
    "mathematics: exact difference of two couples of equal length",
    unit="µm",
    names={"C_may": "C_max"},
    meanings={
        "return": "Backlash that leaves the couple that may be left",
        "r_b": "Base radius",
        "C_may": "Couple that may be left",
    },
)
def phase_by_couple(r_b: Metre, C: NewtonMetre, C_may: NewtonMetre) -> Metre:
    """Where the shaft stays so far behind that `C_may` of its couple `C` is left."""
    return 2 * r_b * asin(C_may / (2 * C))


@formula(
    "J_φ",
    "mathematics: exact difference of two forces of equal length",
    unit="µm",
    names={"F_may": "F_max"},
    meanings={"return": "Backlash that leaves the force that may be left"},
)
def phase_by_force(r_b: Metre, F: Newton, F_may: Newton) -> Metre:
    return 2 * r_b * asin(F_may / (2 * F))


@formula(
    "J_hi", "mathematics: the smaller one, by rattle and by phase", unit="µm", names={"J_hi": "J_r", "J_phi": "J_φ"}
)
def with_phase(J_hi: Metre, J_phi: Metre) -> Metre:
    return smallest(J_hi, J_phi)


# --- each way


def windows(train: TrainResult, drive: DriveResult, shafts: Mapping[str, MayLeave]) -> list[Window]:
    """Of every way to a body that strikes last on it at idle without load; the one with the least room first."""
    if IDLE not in drive.at:
        return []
    strikes = drive.survey.strikes.orbit[drive.at[IDLE]] > 0
    before = drive.survey.bodies.before
    last = [i for i in range(strikes.size) if strikes[i] and not (strikes & before[i])[i + 1 :].any()]
    found = [_window(train, drive, i, shafts) for i in last]
    return sorted(found, key=lambda way: float("inf") if way.high is None else way.high - way.low)


def _window(train: TrainResult, drive: DriveResult, body: int, shafts: Mapping[str, MayLeave]) -> Window:
    line, p = drive.drive.line, drive.at[IDLE]
    bodies = drive.survey.bodies
    meshes = [i for i in line.path(body) if drive.survey.closed.parts[p, i]]
    J = J_most = J_lo = NONE_YET
    takes: dict[str, Metre] = {}
    name = line.links[body].driven
    for i in meshes:
        link, rho = line.links[i], based_on(float(bodies.lever[i, body]), *line.rho)
        pair, least = link.title, smallest_normal(train, link.key)
        nominal, most = line.play["nominal"][i], line.play["most"][i]
        with about(Text("mesh {pair}, way to {name}", pair=pair, name=name)):
            takes[link.key] = taken(j=nominal, j_bn=least, beta_b=train.system.base_helix_angle)
        with about(Text("way to {name} with {pair}, nominal", name=name, pair=pair)):
            J = with_mesh(J=J, j=nominal, rho=rho)
        with about(Text("way to {name} with {pair}, largest", name=name, pair=pair)):
            J_most = with_mesh(J=J_most, j=most, rho=rho)
        with about(Text("way to {name} with {pair}, what tolerances and temperature take", name=name, pair=pair)):
            J_lo = with_mesh(J=J_lo, j=takes[link.key], rho=rho)
    with about(Text("way to {name}, backlash", name=name)):
        with untraced():
            of = quiet_backlashes(drive.survey.motion, bodies, body, grade_limits(), p)
        at = drive.meshes[line.links[body].key].operations[IDLE]
        quiet_a, quiet_b = (
            None if found is None else quiet(J=based_on(found, at.least_force, line.mass[body]), u=u)
            for found, u in zip(of, grade_limits())
        )
        J_hi = None if quiet_b is None else below_rattle(J_q=quiet_b, J_most=J_most, J=J)
        J_phi = _phase(train, line, body, shafts)
        by_phase = J_phi is not None and (J_hi is None or J_phi < J_hi)
        if J_phi is not None:
            J_hi = J_phi if J_hi is None else with_phase(J_hi=J_hi, J_phi=J_phi)
    return Window(body, J, J_lo, J_hi, quiet_a, quiet_b, by_phase, takes, J_most - J)


def smallest_normal(train: TrainResult, key: str) -> Metre:
    """The smallest backlash of a mesh that the step judges, normal: by tolerance, runout and temperature; all parts at
    their worst are not among it."""
    least: Metre = train.meshes[key].backlash_min
    for state in STATES if train.play is not None else ():
        assert train.play is not None
        least = min(least, getattr(train.play[key], state))
    return least


def _phase(train: TrainResult, line: TrainOnLine, body: int, shafts: Mapping[str, MayLeave]) -> Metre | None:
    """The backlash at which a shaft that stays behind leaves as much as it may; None where the body is no shaft, or
    where all that it has may be left."""
    wheel, r_b = line.links[body].driven, line.radius[body]
    name = next((name for name, turn in train.shafts.items() if turn.wheel == wheel), None)
    of = shafts.get(name) if name is not None else None
    if of is None:
        return None
    ends = []
    if of.couple and of.most_couple is not None and of.most_couple < 2 * of.couple:
        ends.append(phase_by_couple(r_b=r_b, C=of.couple, C_may=of.most_couple))
    if of.force and of.most_force is not None and of.most_force < 2 * of.force:
        ends.append(phase_by_force(r_b=r_b, F=of.force, F_may=of.most_force))
    return min(ends, default=None)


# --- the one with the least room


def window(
    train: TrainResult,
    drive: DriveResult,
    shafts: Mapping[str, MayLeave],
    remedies: Callable[[DriveResult], Iterable[Remedy]],
) -> tuple[Outcome[object], DriveResult]:
    """Lines and check, and the drive with the window of the way that has the least room; `remedies`: what opens it."""
    with trace() as lines:
        ways = windows(train, drive, shafts)
    if not ways:
        return Outcome("gears"), drive
    way, checks = ways[0], tuple[Check, ...]()
    with_it = replace(
        drive,
        backlash_quiet_a=way.quiet_a,
        backlash_quiet_b=way.quiet_b,
        window_low=way.low,
        window_high=way.high,
        window=way,
    )
    if way.high is not None:
        opens = what_opens_it(drive, way) if way.low > way.high else EMPTY
        later = Later(lambda: remedies(with_it))
        checks = (window_check(drive, way.low, way.high, governs(drive, way), opens, later),)
    return Outcome("gears", checks=checks, lines=tuple(lines)), with_it


def governs(drive: DriveResult, way: Window) -> Text:
    """Which way, and what bounds it from above."""
    path = drive.drive.line.path(way.body)
    names = "–".join([drive.drive.line.links[path[0]].driver, *(drive.drive.line.links[i].driven for i in path)])
    side = Text("phase error of the shaft") if way.by_phase else Text("rattle")
    return Text("{way}, from above {side}", way=names, side=side)


def what_opens_it(drive: DriveResult, way: Window) -> Text:
    """By how much it is shut, and what takes how much of it."""
    assert way.high is not None
    line = drive.drive.line
    parts = [
        Text("{mesh} {j}", mesh=line.links[line.index(key)].title, j=Amount(j * 1e6, "µm", form=".0f"))
        for key, j in sorted(way.taken.items(), key=lambda item: -item[1])
    ]
    return Text(
        "It is shut by {gap}: from below tolerance, runout and temperature take {parts}; from above the largest "
        "running backlash is {widened} over the nominal one. Narrower tolerances open it from both ends; a heavier "
        "flywheel or a scissor gear from above.",
        gap=Amount((way.low - way.high) * 1e6, "µm", form=".0f"),
        parts=COMMA.join(parts),
        widened=Amount(way.widened * 1e6, "µm", form=".0f"),
    )
