# SPDX-License-Identifier: Apache-2.0
"""Teeth that are too weak: the smallest face width that is enough, and beyond half as much again a stronger class or quality."""

import math
from collections.abc import Iterator

from ..gears.inputs import Wheel
from ..gears.rating.classes import DEFAULT, class_names, strength_class
from ..sheet.changes import Changes, whole
from ..sheet.check import Check
from ..sheet.errors import BadInput, NoSolution
from ..sheet.progress import Progress, part, tell
from ..sheet.search import least_whole
from ..sheet.text import Text
from ..studies.repair.state import State, broken, first_repaired, repaired

STEP = 0.5  # mm
WIDER = 1.5  # times the face width that is tried before a stronger class; rule of this program
WIDEST = 3.0  # times it where no class is enough
QUALITIES = ("MQ", "ME")
TRIED = 8  # classes, the weakest first


def repair(state: State, failing: tuple[Check, ...], progress: Progress | None = None) -> State:
    """Raises NoSolution where neither helps."""
    ids, names = [c.id for c in failing], wheels(state, failing)
    tell(progress, 0.0, Text("face width"))
    made = _wider(state, names, ids, 1.0, WIDER)
    if made is None:
        try:
            made = first_repaired(state, "gears", ids, stronger(state, names), part(progress, 0.3, 0.7))
        except NoSolution:
            made = _wider(state, names, ids, WIDER, WIDEST)
    if made is None:
        raise NoSolution(Text("neither {times} times the face width nor a stronger class is enough", times=WIDEST))
    return made


def wheels(state: State, failing: tuple[Check, ...]) -> list[str]:
    """Wheels of the pairs that fail: a root is as wide as its pair."""
    gears = state.design.gears
    assert gears is not None
    what = {c.id.split(".")[1] for c in failing}
    pairs = [mesh for mesh in gears.meshes if {mesh.key, mesh.driver, mesh.driven} & what]
    wanted = {name for mesh in pairs for name in (mesh.driver, mesh.driven)}
    return [wheel.name for wheel in gears.wheels if wheel.name in wanted]


def _wider(state: State, names: list[str], ids: list[str], low: float, high: float) -> State | None:
    """The smallest face width between two multiples of the present one, on half millimetres; None where none is enough."""
    gears = state.design.gears
    assert gears is not None
    own = {w.name: w.face_width for w in gears.wheels if w.name in names and w.face_width is not None}
    widths = {f"gears.wheels.{name}.face_width_mm": b * 1e3 for name, b in own.items()}
    if len(own) < len(names):
        widths["gears.face_width_mm"] = gears.face_width * 1e3

    def with_width(n: int) -> State | None:
        """The common width of n steps, wheels that are wider staying as they are; None where it is not enough."""
        try:
            made = state.with_changes({key: whole(n * STEP) for key, b in widths.items() if b < n * STEP})
        except BadInput:
            return None
        return made if repaired(state, made, "gears", ids) and not broken(state, made) else None

    narrow, wide = min(widths.values()), max(widths.values())
    return least_whole(with_width, math.floor(narrow * low / STEP) + 1, math.floor(wide * high / STEP))


def stronger(state: State, names: list[str]) -> Iterator[Changes]:
    """Classes and qualities that are stronger than those of the wheels, the weakest first: for each wheel alone, then for all."""
    gears = state.design.gears
    assert gears is not None
    some_wheels = [wheel for wheel in gears.wheels if wheel.name in names]
    every = [strength_class(name, quality) for name in class_names() for quality in QUALITIES]
    every.sort(key=lambda one: one.sigma_Hlim + one.sigma_Flim)
    for some in [*([wheel] for wheel in some_wheels), some_wheels]:
        now = [strength_class(w.gear_material or DEFAULT, w.quality, w.hardness) for w in some]
        enough = [
            one for one in every if all(one.sigma_Hlim >= was.sigma_Hlim and one.sigma_Flim >= was.sigma_Flim for was in now)
            and any(one.sigma_Hlim > was.sigma_Hlim or one.sigma_Flim > was.sigma_Flim for was in now)
        ]  # fmt: skip
        for one in enough[:TRIED]:
            yield dict(change for wheel in some for change in _class(wheel, one.name, one.quality))


def _class(wheel: Wheel, name: str, quality: str) -> Iterator[tuple[str, str | None]]:
    """The hardness goes, which belonged to another class: the lowest of the new one is then taken."""
    at = f"gears.wheels.{wheel.name}"
    if (wheel.gear_material or DEFAULT) != name:
        yield f"{at}.gear_material", name
        if wheel.hardness is not None:
            yield f"{at}.hardness_HV", None
    if wheel.quality != quality:
        yield f"{at}.quality", quality
