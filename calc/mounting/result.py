# SPDX-License-Identifier: Apache-2.0
"""What the step of the mounts publishes, the arrays behind it for figures, and the way from one to the other."""

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import fields
from functools import cache
from typing import Any, Unpack

import numpy as np

from ..sheet.arrays import Array
from ..sheet.quantity import Described, Stands, Stated, group, result, value
from ..sheet.record import record, replace
from ..sheet.shown import Shown
from ..sheet.text import Text
from ..sheet.units import Hertz, Metre, MetrePerSecond, MetrePerSecond2, Newton, Number, Radian
from ..sheet.value import based_on, recorder
from .inputs import DOF_WORDS, VARIANT_WORDS
from .levels import Course, Levels
from .modes import Modes
from .system import System
from .wrenches import TOOTH, EngineWrenches


@record
class Rest:
    """`deflection`: along own axes (mounts, 3), of the weight; `by_torque`: of 1 N·m about the crank; `load`: upward
    (mounts,)."""

    deflection: Array
    by_torque: Array
    load: Array
    q: Array
    q_by_torque: Array


Tree = dict[str, Any]  # Any: dicts of dicts down to a Stated, by the parts of the id


@result
class Mode(Shown):
    """One of the six modes of the engine on rigid ground, slowest first."""

    frequency: Hertz = value("Frequency", "Hz", "f")
    loss_factor: Number = value("Loss factor", "", "η")
    share: dict[str, Stated] = group(words="energy")


@result
class RollAxis(Shown):
    """The axis about which a free engine turns under a torque about the crank."""

    angle: Radian = value("Torque roll axis from the crank", "°", "∠e_T", short=True)
    decoupling: Number = value(
        "Largest share of a mode in the motion about the torque roll axis", "%", "max s_i", short=True
    )
    direction: dict[str, Stated] = group(words="direction")


@result
class StaticMount(Shown):
    """A mount under the weight of the engine."""

    deflection: Metre = value("Static deflection along the first own axis", "mm", "δ_1", short=True)
    load: Newton = value("Upward force on the engine", "N", "F_s")


@result
class Ceiling(Shown):
    """How stiff all mounts may become."""

    highest_factor: Number = value("Highest factor of all stiffnesses for isolation at idle", "", "s_high")
    lowest_order: Number = value("Lowest order that drives the engine", "", "n_exc")


@result
class Window(Shown):
    """By which factor all stiffnesses may be changed: not below the road's frequency, not above what isolates at
    idle."""

    lowest_factor: Number = value("Lowest factor of all stiffnesses, by the road", "", "s_low", short=True)
    spread: Number = value("Spread of the modes, highest over lowest", "", "f_max/f_min", short=True)
    half: Ceiling | None = group(default=None)
    shaft: Ceiling | None = group(default=None)


@result
class Focal(Shown):
    """Two mounts that mirror each other: how they would have to lean for the engine to turn about its centre of
    gravity."""

    angle: Radian | None = value("Inclination that decouples roll from lateral", "°", "φ", default=None)
    reach: Metre = value("Highest elastic centre that an inclination gives", "mm", "a_max")


@result
class OrderLevel(Shown):
    """What of one order is felt."""

    weighted: MetrePerSecond2 | None = value("Weighted acceleration of this order, rms", "m/s²", "a_w", default=None)


@result
class OrderForce(Shown):
    """What a mount has of one order."""

    force: Newton | None = value("Force of the mount, this order, rms", "N", "F", default=None)


@result
class PointLevel(Shown):
    """All orders together at a point, rms; the weighted ones at seats and hands.  None: an undamped resonance is
    hit."""

    displacement: Metre | None = value("Displacement, rms", "mm", "s", default=None)
    displacement_x: Metre | None = value("Displacement along x, rms", "mm", "s_x", default=None)
    displacement_y: Metre | None = value("Displacement along y, rms", "mm", "s_y", default=None)
    displacement_z: Metre | None = value("Displacement along z, rms", "mm", "s_z", default=None)
    velocity: MetrePerSecond | None = value("Velocity, rms", "mm/s", "v", default=None)
    velocity_x: MetrePerSecond | None = value("Velocity along x, rms", "mm/s", "v_x", default=None)
    velocity_y: MetrePerSecond | None = value("Velocity along y, rms", "mm/s", "v_y", default=None)
    velocity_z: MetrePerSecond | None = value("Velocity along z, rms", "mm/s", "v_z", default=None)
    acceleration: MetrePerSecond2 | None = value("Acceleration, rms", "m/s²", "a", default=None)
    acceleration_x: MetrePerSecond2 | None = value("Acceleration along x, rms", "m/s²", "a_x", default=None)
    acceleration_y: MetrePerSecond2 | None = value("Acceleration along y, rms", "m/s²", "a_y", default=None)
    acceleration_z: MetrePerSecond2 | None = value("Acceleration along z, rms", "m/s²", "a_z", default=None)
    grade: Number | None = value("Severity grade, a lower bound", "", default=None)
    weighted: MetrePerSecond2 | None = value("Weighted acceleration, rms", "m/s²", "a_w", default=None)
    weighted_x: MetrePerSecond2 | None = value("Weighted acceleration along x, rms", "m/s²", "a_w,x", default=None)
    weighted_y: MetrePerSecond2 | None = value("Weighted acceleration along y, rms", "m/s²", "a_w,y", default=None)
    weighted_z: MetrePerSecond2 | None = value("Weighted acceleration along z, rms", "m/s²", "a_w,z", default=None)
    orders: dict[str, OrderLevel] | None = group(spread=True, default=None)


@result
class MachineLevel(PointLevel):
    """At a point of the machine, with what the design has: what its severity is judged by."""

    velocity: MetrePerSecond | None = value("Velocity, rms", "mm/s", "v", default=None, short=True, page_one=3)


@result
class FeltLevel(PointLevel):
    """At a seat or a hand, with what the design has."""

    weighted: MetrePerSecond2 | None = value(
        "Weighted acceleration, rms", "m/s²", "a_w", default=None, short=True, page_one=4
    )


@result
class MountLevel(Shown):
    """A mount, all orders together."""

    force: Newton | None = value("Force of the mount, rms", "N", "F", default=None)
    deflection_peak: Metre | None = value("Largest deflection along an own axis", "mm", "δ_peak", default=None)
    orders: dict[str, OrderForce] | None = group(spread=True, default=None)


@result
class MountingResult(Shown):
    """Six modes, statics and aids, then operation by operation what the engine, the frame and the driver feel."""

    frequency: dict[str, Stated] = group(words="frequency")
    energy: dict[str, Stated] = group(words="energy")
    frequency_range: Tree | None = group(default=None)
    modes: dict[str, Mode] = group(spread=True)
    with_chassis: Tree | None = group(default=None, words="engine and frame")
    roll_axis: RollAxis = group(words="torque roll axis")
    static: Tree = group(words="at rest")
    window: Window = group(words="stiffness")
    focal: Tree | None = group(default=None, words="leaning pair")
    critical: Tree = group(words="critical speed")
    operations: Tree = group(spread=True, key_words={"torque": Text("torque")} | VARIANT_WORDS | DOF_WORDS)
    felt_order_1: Tree | None = group(default=None, words="first order felt")
    exposure: Tree | None = group(default=None, words="exposure")
    range: Tree | None = group(default=None, words="idle to rated")
    own: str  # the design's own variant
    speeds: dict[str, tuple[float, float]]  # of each operation, and its hours
    mode_data: Modes
    stiffness: Any  # K and M of the engine on rigid ground
    system: System
    drive: EngineWrenches
    levels: Levels
    rest: Rest
    output: tuple[float, ...]  # mean torque on the mounts, of each operation
    courses: dict[str, Course]  # of each seat, over speed
    teeth: Tree  # of several shafts what stands below the operations for each row of one tooth off

    @property
    def has_shaft(self) -> bool:
        return self.own == "shaft"

    def leaf(self, id: str) -> float | None:
        """A number below the operations, by the parts of its id; None where there is none."""
        here: Any = self.operations
        for part in id.split("."):
            here = here.get(part) if isinstance(here, dict) else getattr(here, part, None)
        number: float | None = here.number if isinstance(here, Stated) else here
        return number


# --- one tooth off


def with_worst(result: MountingResult) -> MountingResult:
    """The same, every number with one tooth off that of the row where it is largest."""
    off = result.drive.off
    if not off:
        return result
    return replace(
        result,
        operations={name: _joined(tree, off) for name, tree in result.operations.items()},
        exposure=None if result.exposure is None else _joined(result.exposure, off),
        teeth={name: {row: tree[row] for row in off} for name, tree in result.operations.items()},
    )


def _joined(tree: Tree, off: Iterable[str]) -> Tree:
    """A tree by variants with the worst of the rows in the place of all."""
    kept = {name: part for name, part in tree.items() if name not in off}
    return kept | {TOOTH: _worst([tree[row] for row in off if row in tree])}


def _worst(parts: Sequence[Any]) -> Any:
    """Of results that are built alike one with the largest of each number; none where one of them has none, as at an
    undamped resonance."""
    first = parts[0]
    if any(part is None for part in parts):
        return None
    if isinstance(first, dict):
        return {key: _worst([part[key] for part in parts]) for key in first if all(key in part for part in parts)}
    if isinstance(first, float):
        return max(parts)
    return replace(
        first,
        **{
            field.name: _worst(contents)
            for field in fields(first)
            if isinstance((contents := [getattr(part, field.name) for part in parts])[0], float | dict)
        },
    )


# --- from arrays to published numbers
# One line of the calculation for each where lines are wanted, one call for all where not.

Nested = Any  # lists of lists of floats, as deep as the arrays have axes before those that the formula takes


def mapped(formula: Callable[..., Any], *given: Any, source: object, axes: int = 1) -> Nested:
    """A formula of the last axes of arrays of one shape, for all that stands before them."""
    if recorder.get() is None:
        return np.asarray(formula(*given)).tolist()
    if given[0].ndim == axes:
        return formula(
            *(based_on(np.ascontiguousarray(x), source) if i == len(given) - 1 else x for i, x in enumerate(given))
        )
    return [mapped(formula, *parts, source=source, axes=axes) for parts in zip(*given)]


def joined(formula: Callable[..., Any], parts: Nested) -> Nested:
    """A formula of the numbers along the last axis of nested lists, for all that stands before."""
    if recorder.get() is None:
        return np.asarray(formula(*np.moveaxis(np.asarray(parts), -1, 0))).tolist()
    return [joined(formula, part) for part in parts] if isinstance(parts[0], list) else formula(*parts)


def along_last(nested: Nested) -> list[Nested]:
    """The numbers along the last axis one after the other, each with the axes before it."""
    if not isinstance(nested[0], list):
        return list(nested)
    return [list(part) for part in zip(*(along_last(part) for part in nested))]


def there(number: float) -> float | None:
    """A number, or None where it is none: an undamped resonance."""
    return number if -math.inf < number < math.inf else None


@cache
def described(label: Text, unit: str, symbol: str = "", **stands: Unpack[Stands]) -> Described:
    return Described(label, unit, symbol, **stands)


def put(tree: dict[str, Any], way: tuple[str, ...], about: Described, number: float | None) -> None:
    """Publish a number; one that is none (an undamped resonance, a ratio of nothing) is left out."""
    if number is None or not math.isfinite(number):
        return
    for part in way[:-1]:
        tree = tree.setdefault(part, {})
    tree[way[-1]] = Stated(about, number)
