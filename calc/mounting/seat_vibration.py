# SPDX-License-Identifier: Apache-2.0
"""What a person has of it: the level of every seat over speed, where it is largest, at critical speeds, and over a
day."""

from collections.abc import Sequence

import numpy as np

from ..engine.gas_torque import order_word
from ..sheet.arrays import Array
from ..sheet.quantity import Stated
from ..sheet.text import Text
from ..sheet.value import based_on
from . import modal, standards
from .body import DOFS
from .inputs import MountingInputs
from .levels import Course, course
from .result import MountingResult, Tree, described, put
from .system import System
from .wrenches import EngineWrenches

STEP = 10.0 / 60  # 1/s, of the grid of speeds
CRITICAL = (0.5, 3.0)  # orders that are looked at


def grid(mounting: MountingInputs, driven: EngineWrenches) -> Array:
    """From idle to rated in steps of 10 rpm, and the rated speed itself."""
    idle, rated = float(mounting.idle_speed), float(driven.engine.rated_speed)
    speeds: Array = idle + STEP * np.arange(int(np.floor((rated - idle) / STEP + 1e-9)) + 1, dtype=float)
    all_speeds: Array = speeds if rated - speeds[-1] < 1e-9 * rated else np.append(speeds, rated)
    return all_speeds


Crossing = tuple[str, str, float]  # mode, order, speed


def courses(
    mounting: MountingInputs, s: System, driven: EngineWrenches, more: Sequence[float]
) -> tuple[dict[str, Course], Course | None]:
    """The level of each seat over speed, and that of the foremost one at further speeds: all in one, since their torque
    is one."""
    foremost = mounting.seat
    if foremost is None:
        return {}, None
    seats = [point for point in mounting.points if point.role == "seat"]
    speeds = grid(mounting, driven)
    at = np.append(speeds, more)
    torque = driven.torque(at)
    n = len(speeds)
    by_seat = {
        seat.name: course(s, driven, seat, at, torque)
        if seat == foremost
        else course(s, driven, seat, speeds, torque[:n])
        for seat in seats
    }
    whole = by_seat[foremost.name]
    return {**by_seat, foremost.name: whole.part(slice(0, n))}, whole.part(slice(n, None))


def course_values(over_speed: dict[str, Course]) -> Tree | None:
    """The largest level of each variant between idle and rated, and at which speed."""
    tree: Tree = {}
    about = described(Text("Largest weighted acceleration, idle to rated"), "m/s²", "a_w")
    speed = described(Text("Speed at which it is"), "rpm", "n")
    for seat, c in over_speed.items():
        for v, variant in enumerate(c.variants):
            n, a = top(c.speeds, c.total[v])
            put(tree, (variant, seat, "weighted"), about, based_on(a, c.source))
            put(tree, (variant, seat, "speed"), speed, based_on(n, c.source))
    return tree or None


def top(n: Array, a: Array) -> tuple[float, float]:
    """Place and height of the largest of the points, refined by the parabola through its neighbours."""
    if not np.isfinite(a).any():
        return float("nan"), float("nan")
    i = int(np.nanargmax(a))
    if 0 < i < len(n) - 1 and np.isfinite(a[i - 1 : i + 2]).all():
        (x_0, x_1, x_2), (y_0, y_1, y_2) = n[i - 1 : i + 2].tolist(), a[i - 1 : i + 2].tolist()
        left, right = (y_1 - y_0) / (x_1 - x_0), (y_2 - y_1) / (x_2 - x_1)
        bend = (right - left) / (x_2 - x_0)
        if bend < 0:
            at = (x_0 + x_1) / 2 - left / (2 * bend)
            return at, y_0 + (at - x_0) * (left + bend * (at - x_1))
    return float(n[i]), float(a[i])


def crossings(
    mounting: MountingInputs, driven: EngineWrenches, existing: Sequence[int], frequency: dict[str, Stated]
) -> list[Crossing]:
    """Speeds between idle and rated at which an order that exists meets a mode."""
    idle, rated = float(mounting.idle_speed), float(driven.engine.rated_speed)
    low, high = CRITICAL
    orders = [float(driven.orders[i]) for i in existing if low <= driven.orders[i] <= high]
    return [
        (dof, f"order_{order_word(i)}", modal.critical_speed(f=frequency[dof].number, i=i))
        for dof in DOFS
        for i in orders
        if idle <= frequency[dof].number / i <= rated
    ]


def critical(rows: Sequence[Crossing], at: Course | None) -> Tree:
    """Critical speeds by mode and order, and what the foremost seat then has."""
    tree: Tree = {}
    about = described(Text("Critical speed: this order meets the mode"), "rpm", "n")
    level = described(Text("Weighted acceleration at this speed"), "m/s²", "a_w")
    for k, (dof, order, n) in enumerate(rows):
        put(tree, (dof, order, "speed"), about, n)
        for v, variant in enumerate(at.variants if at is not None else ()):
            if at is not None and variant in ("half", "shaft"):
                put(tree, (dof, order, "seat", variant), level, based_on(float(at.total[v, k]), n, at.source))
    return tree


def exposure(mounting: MountingInputs, result: MountingResult) -> Tree | None:
    """The daily exposure of each variant by the engine alone: the worst seat, the worst hand; None where no hours are
    given."""
    rows = [(i, hours) for i, (_, hours) in enumerate(result.speeds.values()) if hours]
    if not rows:
        return None
    which, hours = [i for i, _ in rows], np.array([hours for _, hours in rows])
    given = based_on(hours, tuple(row.hours for row in mounting.operation))
    tree: Tree = {}
    for v, variant in enumerate(result.drive.variants):
        for role, id, words in (("seat", "whole_body", WHOLE_BODY), ("hand", "hand_arm", HAND_ARM)):
            days = [_day(result, point.name, role, v, which, given) for point in mounting.points if point.role == role]
            if days:
                line = 5 if variant == result.own else 0
                put(tree, (variant, id), described(words, "m/s²", "A(8)", page_one=line), max(days))
    return tree or None


WHOLE_BODY = Text("Daily exposure of the whole body by the engine alone, A(8)")
HAND_ARM = Text("Daily exposure of hand and arm by the engine alone, A(8)")


def _day(result: MountingResult, name: str, role: str, v: int, which: list[int], hours: Array) -> float:
    operations = list(result.operations.values())
    of = [operations[i][result.drive.variants[v]][name] for i in which]
    if role == "hand":
        whole = [_number(level.weighted) for level in of]
        a: Array = np.array(whole)
        return standards.hand_arm(a=based_on(a, whole), T=hours)
    axes = [[_number(x) for x in (level.weighted_x, level.weighted_y, level.weighted_z)] for level in of]
    a = np.array(axes)
    return standards.whole_body(a=based_on(a, axes, result.levels.source), T=hours)


def _number(x: float | None) -> float:
    return float("nan") if x is None else x
