# SPDX-License-Identifier: Apache-2.0
"""Inputs that no remedy and no search may change: those of the table [locked], where there is none the oil, which is the engine's.

What was measured, and what the user accepted, nothing changes but the user.
"""

from collections.abc import Mapping

from .addresses import Table
from .sheet.text import Text

USUAL: Mapping[str, Text] = {"bearings.oil": Text("the oil is the engine's"), "friction.oil": Text("the oil is the engine's")}
GIVEN = {"measured": Text("it was measured"), "accepted": Text("it is the user's word")}


def locks(data: Table) -> Mapping[str, str]:
    """The locked keys of a design, each with its reason.  A key locks all that stands below it."""
    given = data.get("locked")
    return dict(given) if isinstance(given, dict) else USUAL


def locked(data: Table, key: str) -> str:
    """Why a key may not be changed by the program; empty where it may."""
    if (reason := GIVEN.get(key.partition(".")[0])) is not None:
        return reason
    return next((reason for one, reason in locks(data).items() if key == one or key.startswith(f"{one}.")), "")


def toggled(data: Table, key: str, reason: str) -> Table:
    """The tables with a key locked, or unlocked where it was."""
    now = dict(locks(data))
    inside = [one for one in now if key == one or key.startswith(f"{one}.")]
    for one in inside:
        del now[one]
    if not inside:
        now[key] = reason
    return {**data, "locked": now}
