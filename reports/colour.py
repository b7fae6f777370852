# SPDX-License-Identifier: Apache-2.0
"""The colour space sRGB as an ICC profile, which says what the document's colours are wherever it is printed.

Written here from the numbers of the standard, so that nothing is shipped under another licence and the bytes are always the same:
primaries, white and curve of IEC 61966-2-1, adapted to D50 by Bradford as ICC.1:2010 (profile version 4.3), annex E, has it; the
numbers were remembered, and are compared with LittleCMS's own profile by a test.
"""

from __future__ import annotations

import struct

NAME = "sRGB IEC61966-2.1"
D50 = (0.9642, 1.0, 0.8249)  # the profile connection space's white
PRIMARIES = {"r": (0.4360747, 0.2225045, 0.0139322), "g": (0.3850649, 0.7168786, 0.0971045), "b": (0.1430804, 0.0606169, 0.7141733)}
ADAPTED = (1.0478112, 0.0228866, -0.0501270, 0.0295424, 0.9904844, -0.0170491, -0.0092345, 0.0150436, 0.7521316)  # D65 to D50
CURVE = (2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045)  # ((a·x + b) to the power of g) from d on, below it c·x


def profile() -> bytes:
    """The profile as bytes: a header, a table of its tags, what they hold."""
    tags = {
        "desc": _words(NAME),
        "cprt": _words("No copyright, use freely"),
        "wtpt": _xyz(D50),
        "chad": b"sf32" + bytes(4) + _fixed(*ADAPTED),
    }
    curve = b"para" + bytes(4) + struct.pack(">HH", 3, 0) + _fixed(*CURVE)
    for letter, primary in PRIMARIES.items():
        tags |= {f"{letter}XYZ": _xyz(primary), f"{letter}TRC": curve}
    at = 128 + 4 + 12 * len(tags)
    table, contents, places = b"", b"", {}
    for name, held in tags.items():
        if held not in places:
            places[held] = at + len(contents)
            contents += held + bytes(-len(held) % 4)
        table += name.encode() + struct.pack(">II", places[held], len(held))
    made = struct.pack(">I", len(tags)) + table + contents
    return _header(128 + len(made)) + made


def _header(size: int) -> bytes:
    date = struct.pack(">6H", 2010, 12, 1, 0, 0, 0)  # of the specification that it follows; any other would change the bytes
    kinds = struct.pack(">I", size) + bytes(4) + b"\x04\x30\0\0" + b"mntrRGB XYZ " + date + b"acsp"
    return (kinds + bytes(28) + _fixed(*D50)).ljust(128, b"\0")


def _fixed(*numbers: float) -> bytes:
    return struct.pack(f">{len(numbers)}i", *(round(number * 65536) for number in numbers))


def _xyz(numbers: tuple[float, float, float]) -> bytes:
    return b"XYZ " + bytes(4) + _fixed(*numbers)


def _words(words: str) -> bytes:
    raw = words.encode("utf-16-be")
    return b"mluc" + bytes(4) + struct.pack(">II2s2sII", 1, 12, b"en", b"US", len(raw), 28) + raw
