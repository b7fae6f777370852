# SPDX-License-Identifier: Apache-2.0
"""What the mounts, and the points on engine and frame, feel at the speed of a measurement: an operation of its own, its
gas between those of the design's operations."""

import math
from functools import cached_property
from typing import Any

import numpy as np

from ..engine.gas_torque import order_word
from ..sheet.quantity import Described, Stated
from ..sheet.record import replace
from ..sheet.shown import Shown
from ..sheet.text import Text
from ..sheet.units import UNITS
from ..sheet.value import untraced
from .levels import displacement, levels
from .operations import existing, operations
from .result import MountingResult, Tree, described, with_worst

NAME = "measured"  # of the operation
MEASURED = f"mounting.{NAME}."  # how the ids of its values begin
KINDS = {"displacement": ("mm", 0), "velocity": ("mm/s", 1), "acceleration": ("m/s²", 2)}
ORDER = "order_"


class AtMeasuredSpeed:
    """A mounting step at one more speed."""

    def __init__(self, result: MountingResult, speed: float) -> None:
        self.result, self.speed = result, speed

    @cached_property
    def _lines(self) -> Any:
        speeds = np.array([self.speed])
        return levels(self.result.system, self.result.drive, speeds, self._torque)

    @cached_property
    def _torque(self) -> Any:
        return self.result.drive.torque(np.array([self.speed]))

    @cached_property
    def tree(self) -> Tree:
        """All that stands below the name of the operation."""
        drive, lines = self.result.drive, self._lines
        with untraced():
            found = operations(
                drive, lines, self.result.system, [(NAME, self.speed, 0.0)], self._torque, existing(drive, lines)
            )
        mine: Tree = with_worst(replace(self.result, operations=found, exposure=None)).operations[NAME]
        return mine

    def value(self, id: str) -> float | None:
        """A number by its id, in the unit that it is shown in; None where there is none at this speed."""
        found = self.leaf(id)
        return None if found is None else UNITS[found[0].unit].shown(found[1])

    def leaf(self, id: str) -> tuple[Described, float] | None:
        """What is said of a number, and the number in SI."""
        parts = id.removeprefix(MEASURED).split(".")
        if (of_order := self._one_order(parts)) is not None:
            return of_order
        here: Any = self.tree
        about: Described | None = None
        for part in parts:
            if isinstance(here, dict):
                here = here.get(part)
            elif isinstance(here, Shown):
                key = getattr(type(here), part, None)
                about = getattr(key, "about", None)
                orders = getattr(here, "orders", None) or {}
                here = getattr(here, part, None) if about is not None else orders.get(part)
            else:
                return None
        if isinstance(here, Stated):
            about, here = here.about, here.number
        return (about, float(here)) if about is not None and isinstance(here, float) else None

    def _one_order(self, parts: list[str]) -> tuple[Described, float] | None:
        """`VARIANT.POINT.velocity_x.order_1`: what one order moves a point along an axis by, rms."""
        if len(parts) != 4 or not parts[3].startswith(ORDER):
            return None
        variant, point, what, order = parts
        kind, _, axis = what.rpartition("_")
        drive = self.result.drive
        names = [one.name for one in self.result.system.mounting.points]
        words = [f"{ORDER}{order_word(n)}" for n in drive.orders]
        if kind not in KINDS or axis not in "xyz" or variant not in drive.variants:
            return None
        if point not in names or order not in words:
            return None
        unit, k = KINDS[kind]
        v, p, a, n = drive.variants.index(variant), names.index(point), "xyz".index(axis), words.index(order)
        with untraced():
            rms = float(displacement(self._lines.motion[0, v, p, k, a, n : n + 1]))
        label = Text("{kind} along {axis}, {order}, rms", kind=kind, axis=axis, order=order.replace("_", " "))
        return (described(label, unit), rms) if math.isfinite(rms) else None


def unit_of(result: MountingResult | None, id: str) -> tuple[str, Text] | Text:
    """The unit and the label of a value of the operation `measured`, or why there is none of this id."""
    if result is None:
        return Text("{id} needs [mounting], and a solution of it", id=id)
    speed = max(speed for speed, _ in result.speeds.values())
    found = AtMeasuredSpeed(result, speed).leaf(id)
    if found is None:
        known = ", ".join(dict.fromkeys(result.drive.variants))
        return Text(
            "{id} is none of mounting.measured.VARIANT.POINT.velocity_x, ….velocity_x.order_1, .MOUNT.force or "
            ".MOUNT.order_1.force of this design; its variants are {known}",
            id=id,
            known=known,
        )
    return found[0].unit, found[0].label
