# SPDX-License-Identifier: Apache-2.0
"""What a file is to the design inside it.  Only bytes speak for a report."""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from enum import Enum
from typing import Any

from calc.sheet.errors import BadInput
from calc.sheet.text import Text
from calc.solve import Results
from calc.studies.compare import size_of_nothing

from .. import comparison, report
from ..apart import Refused, apart
from ..pdf.attach import Inside, beginning, inside, nine, packed, refused, sha256
from .signature import signers

SAME = 1e-9  # relative: numbers that differ by less are the same, whatever computed them
NOTHING = "–"  # where a value or a verdict is not there


class Verdict(Enum):
    """What a file is; the first two speak for what is printed in it."""

    IDENTICAL = "identical"  # byte for byte what this program writes
    SIGNED = "signed"  # that, and behind it signatures in the fields that it foresees, and nothing else
    APPENDED = "appended to"  # that, and behind it something else
    NOT_AS_WRITTEN = "not as written"  # other bytes; what is attached is compared, its pages are not looked at


@dataclass(frozen=True)
class Difference:
    what: str
    was: str
    now: str


@dataclass(frozen=True)
class Verification:
    """`made`: the versions that the report says it was made with, by name; `front`: it repeats what the front says
    that is attached to it, and nobody has searched again for that.

    Of a file that begins with what this program writes: `original`, that beginning; `signers`, a line for each; or
    `why` it is not signed.  Of another one: how many values and verdicts were `compared`, the `differences`, and which
    attachments were `changed`."""

    design: str
    made: dict[str, str]
    front: bool
    verdict: Verdict = Verdict.IDENTICAL
    original: bytes = b""
    signers: tuple[str, ...] = ()
    why: str = ""
    compared: int = 0
    differences: tuple[Difference, ...] = ()
    changed: tuple[str, ...] = ()


def verify(raw: bytes, place: str) -> Verification:
    """Solve the design that is attached to a report, or the two of a comparison, again, write it once more, and say
    what the file is.

    `place`: its name, for messages.  Raises BadInput for a file that is no report of this program, or whose design
    this version does not accept."""
    ours = beginning(raw)
    try:
        it, document, values, solved = _again(ours, place)
    except BadInput:
        if ours == raw:
            raise
        document = b""
    if document != ours and raw != ours:
        it, document, values, solved = _again(raw, place)
    known = Verification(" – ".join(results.design.name for results in solved), it.made, "front" in it.said)
    if document != ours:
        return _compared(known, it, values, solved)
    known = replace(known, original=ours)
    if raw == ours:
        return known
    try:
        return replace(known, verdict=Verdict.SIGNED, signers=tuple(apart(signers, raw, len(ours))))
    except Refused as no:
        return replace(known, verdict=Verdict.APPENDED, why=str(no))


def _again(raw: bytes, place: str) -> tuple[Inside, bytes, dict[str, Any], list[Results]]:
    """What is inside a file, and what that gives now."""
    try:
        it = inside(place, raw, packed(raw))
        return it, *(comparison.again(it) if "other" in it.said else report.again(it))
    except (Refused, RecursionError, MemoryError) as error:
        raise refused(place, Text("{why}", why=str(error) or type(error).__name__)) from None


# --- what differs


def _compared(known: Verification, it: Inside, values: dict[str, Any], solved: list[Results]) -> Verification:
    """Of a file that this program does not write so: all that is inside and differs from what it gives now by more
    than rounding."""
    logos = {results.design.control.logo: it.said.get("logo", "") for results in solved} if "logo" in it.said else {}
    changed = tuple(name for name, sum in (it.sums | logos).items() if sha256(it.file(name)) != sum)
    was, now = dict(_flat(it.solved())), dict(_flat(values))
    sizes = {id: size for results in solved for id, size in _nothing(results)}
    keys = dict.fromkeys([*now, *was])
    differences = tuple(
        Difference(key, *(str(side.get(key, NOTHING)) for side in (was, now)))
        for key in keys
        if key not in was or key not in now or not _same(was[key], now[key], sizes.get(key.rpartition(" ")[2], 0.0))
    )
    return replace(known, verdict=Verdict.NOT_AS_WRITTEN, changed=changed, compared=len(keys), differences=differences)


def _flat(value: Any, *path: str) -> Iterator[tuple[str, Any]]:
    """Each single value of JSON, by the way to it."""
    if not isinstance(value, dict):
        yield " ".join(path), value
        return
    for key, inner in value.items():
        yield from _flat(inner, *path, key)


def _nothing(results: Results) -> Iterator[tuple[str, float]]:
    """Of each value the size of what is left of a sum that is zero."""
    for outcome in results.outcomes.values():
        sizes = size_of_nothing((value.unit, value.shown) for value in outcome.values())
        yield from ((value.id, sizes[value.unit]) for value in outcome.values())


def _same(was: Any, now: Any, nothing: float) -> bool:
    """Whether the digits of a report may be those of the number that it is now."""
    if not (isinstance(was, float) and isinstance(now, float) and math.isfinite(was)):
        return bool(was == now)
    low, high = sorted(nine(now * (1.0 + by)) for by in (-SAME, SAME))
    return low <= nine(was) <= high or max(abs(was), abs(now)) <= nothing
