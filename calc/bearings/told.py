# SPDX-License-Identifier: Apache-2.0
"""What is shown of the bearings of a shaft beside their values, each kind by its own."""

from collections.abc import Iterator, Mapping
from functools import partial
from typing import Any

from ..sheet.deferred import Later
from ..sheet.step import Curve, Further
from .kinds import KINDS
from .plain.curves import in_films
from .result import BearingsResult
from .support import Carrying, Told

Bearings = Mapping[str, Carrying]  # by their places


def shown(told: Told, result: BearingsResult, bearings: Bearings) -> dict[str, Any]:
    """Curves, tables, notes and what else an outcome has, made when somebody looks."""
    kinds = of_kinds(bearings)
    return dict(
        curves=Later(lambda: _curves(result, kinds)),
        tables=Later(lambda: (t for kind, those in kinds.items() for t in KINDS[kind].tables(those, told.shaft))),
        errata=Later(lambda: (e for kind, those in kinds.items() for e in KINDS[kind].errata(those))),
        notes=Later(
            lambda: dict.fromkeys(
                n for kind, those in kinds.items() for n in KINDS[kind].notes(told.inputs, told.solved, those)
            )
        ),
        further=partial(_charts, kinds),
    )


def _charts(kinds: Mapping[str, dict[str, Carrying]]) -> Further:
    return Further(curves=Later(lambda: (c for kind, those in kinds.items() for c in KINDS[kind].charts(those))))


def of_kinds(bearings: Bearings) -> dict[str, dict[str, Carrying]]:
    """Those of each kind that there is, in the order of the kinds."""
    words = [kind for kind in KINDS if any(r.row.kind == kind for r in bearings.values())]
    return {kind: {place: r for place, r in bearings.items() if r.row.kind == kind} for kind in words}


def _curves(result: BearingsResult, kinds: Mapping[str, dict[str, Carrying]]) -> Iterator[Curve]:
    for kind, those in kinds.items():
        yield from KINDS[kind].curves(those)
    yield from in_films(result)
    for kind, those in kinds.items():
        yield from KINDS[kind].seat_curves(those)
