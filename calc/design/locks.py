# SPDX-License-Identifier: Apache-2.0
"""Inputs that no remedy and no search may change: those of the table [locked], where there is none the oil, which is
the engine's.

What was measured, and what the user accepted, nothing changes but the user.
"""

from collections.abc import Mapping
from contextlib import suppress

from ..bearings.inputs import BearingsInputs
from ..friction.inputs import FrictionInputs
from ..sheet.errors import BadInput
from ..sheet.quantity import dotted
from ..sheet.text import Text
from .addresses import Table, address, step_at, value_at
from .model import STEP_KEYS, Design
from .upgrade import current

USUAL: Mapping[str, Text] = {
    dotted(Design.bearings, BearingsInputs.oil): Text("the oil is the engine's"),
    dotted(Design.friction, FrictionInputs.oil): Text("the oil is the engine's"),
}
GIVEN = {"measured": Text("it was measured"), "accepted": Text("it is the user's word")}


def locks(data: Table) -> Mapping[str, str]:
    """The locked keys of a design, each with its reason.  A key locks all that stands below it, that of a step all its
    inputs."""
    given = data.get("locked")
    return dict(given) if isinstance(given, dict) else USUAL


def standing(data: Table) -> Mapping[str, str]:
    """Those of the locks whose keys the design has."""
    there = {}
    for key, reason in locks(data).items():
        with suppress(BadInput):
            if value_at(data, key, whole=True) is not None:
                there[key] = reason
    return there


def locked(data: Table, key: str) -> str:
    """Why a key may not be changed by the program; empty where it may."""
    if (reason := GIVEN.get(key.partition(".")[0])) is not None:
        return reason
    return next((reason for lock, reason in locks(data).items() if _holds(data, lock, key)), "")


def _holds(data: Table, lock: str, key: str) -> bool:
    if lock in STEP_KEYS:
        return step_at(data, current(data, key)) == lock
    outer = _place(data, lock)
    return _place(data, key)[: len(outer)] == outer


def _place(data: Table, key: str) -> tuple[str | int, ...]:
    """An element of an array by its index, by which of its names it ever goes."""
    try:
        return address(data, key, whole=True)
    except BadInput:  # of an element that is not there any more
        return tuple(key.split("."))


def toggled(data: Table, key: str, reason: str) -> Table:
    """The tables with a key locked, or unlocked where it was: then the locks that hold it go, that of its table too."""
    now = dict(locks(data))
    holding = [lock for lock in now if _holds(data, lock, key)]
    for lock in holding:
        del now[lock]
    if not holding:
        now[key] = reason
    return {**data, "locked": now}
