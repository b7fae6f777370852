# SPDX-License-Identifier: Apache-2.0
"""The loads as a file: a table with a head of lines with #, and the same as JSON."""

import csv
import json
import math
from collections.abc import Callable, Sequence
from io import StringIO

from ..sheet.text import Name, Text
from ..sheet.version import VERSION
from ..sheet.visible import visible
from .frame import number
from .load_rows import LoadRow
from .loads import CLOSES, Loads

AXES = "XYZ"
COLUMNS = (
    *("speed_rpm", "kind", "place", "on", "order"),
    *(f"{axis}_mm" for axis in AXES),
    *(name for axis in AXES for name in (f"F{axis}_N", f"F{axis}_deg")),
    *(name for axis in AXES for name in (f"M{axis}_Nm", f"M{axis}_deg")),
)
FULL_TURN = 1e-9  # degrees: a phase so near to 360 is 0

HARMONICS = Text(
    "amplitudes are peaks, N and N·m, phase in degrees, a(t) = A cos(order·ω·t + phase), t = 0 at firing TDC of "
    "cylinder 1; ω: of the crank; order 0 and a component that is exactly 0 have no phase"
)
SIDES = Text(
    "each row is the force on the body named in `on`, one side of a contact only: the other body has the opposite"
)
BLOCK = Text("on a model of the block: the rows engine and bearing, all orders, and nothing else")
BODIES = Text(
    "on a model with the shafts as bodies: the rows weight, and mesh on their wheels; of the bearings then only MZ "
    "(friction) and FZ (thrust) of order 0, since the bodies' own unbalance makes the rest"
)
NEVER = Text(
    "never: mount together with engine and bearing, whose reaction it is; nor inertia, which closes the sums: what the "
    "bent shaft itself adds is in its bearings' rows already"
)
LEFT_OUT = Text(
    "main bearings of the crank: the row engine is the whole wrench about the origin, without the mean torque; pins of "
    "idlers, of which each carries the sum of the rows mesh on its wheel; strikes of the teeth"
)


Say = Callable[[Text], str]  # in a language


def head(loads: Loads, design: str, sha256: str, say: Say = str) -> dict[str, str | list[str]]:
    """What stands above the rows, by its key."""
    return {
        "program": f"Contralbero {VERSION}",
        "design": visible(design),
        "sha256": sha256,
        "frame": say(loads.frame.words),
        "harmonics": say(HARMONICS),
        "sides": say(SIDES),
        "variant": say(loads.variant),
        "bearings": [*map(say, loads.bearings)],
        "apply": [say(BLOCK), say(BODIES), say(NEVER)],
        "not_in_it": [say(LEFT_OUT), *map(say, loads.left_out)],
        "notes": [*map(say, loads.notes)],
        "sum_check": [say(_sum_line(what, off)) for what, off in loads.sums.items()],
    }


def _sum_line(what: str, off: float) -> Text:
    words = Text("closes to") if off <= CLOSES else Text("DOES NOT CLOSE:")
    return Text(
        "{what}: {words} {off} of the largest (limit {limit})",
        what=Name(what),
        words=words,
        off=Name(f"{off:.1e}"),
        limit=Name(f"{CLOSES:.0e}"),
    )


def csv_text(loads: Loads, design: str, sha256: str, say: Say = str) -> str:
    file = StringIO()
    for key, words in head(loads, design, sha256, say).items():
        for line in [words] if isinstance(words, str) else words:
            file.write(f"# {key}: {line}\n")
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(COLUMNS)
    writer.writerows(cells(row) for row in loads.rows)
    return file.getvalue()


def cells(row: LoadRow) -> list[str]:
    """What stands in the columns, numbers as texts that read back."""
    found = [_rpm(row), row.kind, row.place, row.on, number(row.order)]
    found += ["" if part is None else number(part * 1e3) for part in row.at]
    for part in (*row.force, *row.moment):
        found += amplitude_and_phase(part, row.order)
    return found


def amplitude_and_phase(phasor: complex, order: float) -> tuple[str, str]:
    """Of order 0 the signed value; the phase from 0 to 360°, empty where there is none."""
    if not order:
        return number(phasor.real), ""
    if not phasor:
        return number(0.0), ""
    phase = math.degrees(math.atan2(phasor.imag, phasor.real)) % 360.0
    return number(abs(phasor)), number(0.0 if phase >= 360.0 - FULL_TURN else phase)


def json_text(loads: Loads, design: str, sha256: str, say: Say = str) -> str:
    """A row stands in a line."""
    above = json.dumps(head(loads, design, sha256, say), ensure_ascii=False, indent=1)
    rows = ",\n".join(json.dumps(_object(row), ensure_ascii=False) for row in loads.rows)
    return f'{{\n"frame": {above},\n"rows": [\n{rows}\n]\n}}\n'


def _object(row: LoadRow) -> dict[str, object]:
    return {
        "speed_rpm": float(_rpm(row)),
        "kind": row.kind,
        "place": row.place,
        "on": row.on,
        "order": float(row.order),
        "at_mm": [None if part is None else _plain(part * 1e3) for part in row.at],
        "force_N": _pairs(row.force),
        "moment_Nm": _pairs(row.moment),
    }


def _rpm(row: LoadRow) -> str:
    """As it was asked for: what the way from rpm and back has added in the last digit is taken off."""
    return number(round(row.speed * 60, 9))


def _pairs(vector: Sequence[complex]) -> list[list[float]]:
    return [[_plain(complex(part).real), _plain(complex(part).imag)] for part in vector]


def _plain(value: float) -> float:
    return float(value) + 0.0
