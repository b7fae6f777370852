# SPDX-License-Identifier: Apache-2.0
"""What the friction of one mesh needs to know of its two wheels; filled from the geometry of the train.

The driver is body 1 and the driven wheel body 2 throughout this folder; a ratio below 1 is allowed.

Whatever a mesh is asked may be one operating point, all numbers floats, or N at once, some numbers arrays of length N:
`column` sets them against the positions of the path, which stand along the last axis."""

import math
from dataclasses import fields
from functools import cached_property
from typing import Any

import numpy as np

from ...sheet.errors import NoSolution
from ...sheet.number import short
from ...sheet.record import record
from ...sheet.text import Text
from ...sheet.units import Metre, Number, Pascal, Radian
from ...sheet.value import LinkedFloat

MAY_BE_ZERO = ("base_helix_angle", "poisson")


@record
class WheelGeometry:
    """One wheel.  An idler is the same wheel in both of its meshes."""

    name: str
    teeth: int
    reference_radius: Metre
    base_radius: Metre
    tip_radius: Metre
    face_width: Metre
    E: Pascal
    poisson: Number


@record
class MeshGeometry:
    """Two wheels at their working centre distance; a base helix angle of 0 is a spur pair."""

    driver: WheelGeometry
    driven: WheelGeometry
    centre_distance: Metre
    base_helix_angle: Radian

    @property
    def name(self) -> str:
        return f"{self.driver.name}_{self.driven.name}"

    @cached_property
    def title(self) -> str:
        return f"{self.driver.name}–{self.driven.name}"

    @property
    def face_width(self) -> Metre:
        """The width that both wheels have."""
        return min(self.driver.face_width, self.driven.face_width)

    @cached_property
    def power(self) -> Text:
        return Text("mesh {title}: power", title=self.title)

    @property
    def spur(self) -> bool:
        return self.base_helix_angle == 0.0


@record
class Sprocket:
    """One end of a chain or a belt, on the axis of a wheel."""

    name: str
    teeth: int


@record
class StageGeometry:
    """A chain or a belt: it passes on a share of what it takes in."""

    name: str
    driver: Sprocket
    driven: Sprocket
    efficiency: Number

    @property
    def title(self) -> str:
        return f"{self.driver.name}–{self.driven.name}"

    @cached_property
    def power(self) -> Text:
        return Text("stage {name}: power", name=self.name)


Link = MeshGeometry | StageGeometry


def sound(mesh: MeshGeometry) -> None:
    """Raise where a number of a mesh has no meaning; whether the teeth reach each other is asked in `path.py`."""
    for part in (mesh, mesh.driver, mesh.driven):
        for field in fields(part):
            number = getattr(part, field.name)
            if isinstance(number, (int, float)) and not 0 < number < math.inf:
                what = Text("mesh {title}: {name}", title=mesh.title, name=field.name)
                require(what, number, zero=field.name in MAY_BE_ZERO)


def require(what: Text, number: Any, *, zero: bool = False) -> Any:
    """The number, or the array of numbers, if all are finite and positive (or zero, where zero has a meaning)."""
    if type(number) in (float, LinkedFloat) and 0 < number < math.inf:
        return number
    good = np.isfinite(number) & ((number >= 0) if zero else (number > 0))
    if not np.all(good):
        wrong = float(np.ravel(number)[int(np.argmin(np.ravel(good)))])
        tried = Text("is {wrong}", wrong=wrong if math.isfinite(wrong) else short(wrong))
        sign = Text("of zero or more") if zero else Text("above zero")
        raise NoSolution(what, tried, Text("a finite number ") + sign + Text(" is needed"))
    return number


def column(x: Any) -> Any:
    """One number as it is; an array of N operating points as a column, against which the positions of a path stand in a
    row."""
    return x if np.ndim(x) == 0 else x[:, None]


def flat(x: Any) -> Any:
    """The inverse of `column`."""
    return x if np.ndim(x) == 0 else x[:, 0]
