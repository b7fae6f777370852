# SPDX-License-Identifier: Apache-2.0
"""How far the inputs that move a check move it: the sign and the size of each effect, by solving the design again with
a small change."""

import math
from collections.abc import Callable, Iterable

from ..design.addresses import as_list, quantities, value_at
from ..design.toml_file import Document, design
from ..sheet.check import Check, grouped
from ..sheet.errors import BadInput
from ..sheet.quantity import Quantity
from ..sheet.record import record
from ..solve import Results, solve

SMALL = 1e-3  # relative change of an input
MOST = 3  # inputs that are moved for one cause
KINDS = ("number", "integer", "series")


@record
class Effect:
    """What one unit more of a key does to a check, in the check's unit: to its value (`slope`), and to the distance
    from its limit (`gain`, positive: it is kept more widely).  Of a list all numbers are moved.  None: it was not
    moved, or it is no number, is not given, or the design has no solution then."""

    key: str
    slope: float | None
    gain: float | None
    unit: str


def effects(
    document: Document, results: Results, checks: Iterable[Check], most: int = MOST, stop: Callable[[], bool] = bool
) -> dict[str, tuple[Effect, ...]]:
    """For each check what the inputs do that move it most, in the order of use.  `document` is that of the results.

    Of checks with one cause the worst says which inputs are moved, `most` of them.  Each is moved once, and only what
    depends on it is solved again.  `stop` as of a solve."""
    known = dict(quantities(document.data))
    wanted = list(checks)
    moved: dict[str, Moved] = {}
    for group in grouped(wanted):
        numbers = [
            key
            for key in _keys(group[0], known)
            if known[key].kind in KINDS and value_at(document.data, key) is not None
        ]
        for key in numbers[:most]:
            if key not in moved:
                moved[key] = _moved(document, results, key, known[key], stop)
    return {c.id: tuple(_effect(c, key, known[key], moved.get(key)) for key in _keys(c, known)) for c in wanted}


Moved = tuple[float, dict[str, Check]] | None


def _keys(check: Check, known: dict[str, Quantity]) -> list[str]:
    """The keys of single inputs: in place of the key of a table those of the numbers in it."""
    found: dict[str, None] = {}
    for key in check.moved_by:
        inside = [one for one in known if one.startswith(f"{key}.") and known[one].kind in KINDS]
        found |= dict.fromkeys([key] if key in known else inside)
    return list(found)


def _moved(document: Document, results: Results, key: str, about: Quantity, stop: Callable[[], bool]) -> Moved:
    """The change of an input in its unit, and all checks after it."""
    old = value_at(document.data, key)
    numbers = [x for x in as_list(old) if isinstance(x, (int, float))]
    size = max(map(abs, numbers)) * SMALL or (about.step or 1.0) * 0.01
    for change in (1, -1) if about.kind == "integer" else (size, -size):
        new = [x + change for x in numbers]
        try:
            after = solve(design(document.with_value(key, new if isinstance(old, list) else new[0])), results, stop)
        except BadInput:
            continue  # beyond what is allowed: the other way
        return change, {check.id: check for check in after.checks()}
    return None


def _effect(check: Check, key: str, about: Quantity, moved: Moved) -> Effect:
    unit = f"{check.unit or '1'}/{about.unit or '1'}" if check.unit or about.unit else ""
    if moved is None or check.id not in moved[1]:
        return Effect(key, None, None, unit)
    change, after = moved[0], moved[1][check.id]
    return Effect(
        key,
        _finite((after.value - check.value) / change),
        _finite((after.nearest[0] - check.nearest[0]) / change),
        unit,
    )


def _finite(number: float) -> float | None:
    return number if math.isfinite(number) else None


def moved_by(
    document: Document, results: Results, key: str, stop: Callable[[], bool] = bool
) -> tuple[tuple[Check, Effect], ...]:
    """What one input moves: every check, with the effect of one unit more; first those whose margin it moves most, of
    what there is."""
    about = dict(quantities(document.data)).get(key)
    if about is None or about.kind not in KINDS or value_at(document.data, key) is None:
        return ()
    moved = _moved(document, results, key, about, stop)
    found = [(check, _effect(check, key, about, moved)) for check in results.checks()]
    there = [(check, effect) for check, effect in found if effect.gain]
    return tuple(sorted(there, key=lambda one: -abs((one[1].gain or 0.0) / (abs(one[0].nearest[0]) or 1.0))))
