# SPDX-License-Identifier: Apache-2.0
"""The logo of a title block: a PNG file beside the design, in which a stranger may have put anything."""

from __future__ import annotations

import io
import stat
import struct
import zlib
from dataclasses import dataclass
from pathlib import Path

from reportlab.lib.utils import ImageReader

from calc.design.toml_file import Document
from calc.design.limits import LOGO_BYTES, LOGO_SIDE
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import Text

KEY = "document.logo"
HEAD = b"\x89PNG\r\n\x1a\n\x00\x00\x00\rIHDR"
BROKEN = (
    OSError,
    SyntaxError,
    ValueError,
    EOFError,
    TypeError,
    IndexError,
    KeyError,
    struct.error,
    zlib.error,
)  # what a damaged PNG raises


@dataclass(frozen=True, slots=True)
class Logo:
    """`raw`: the bytes of the file, which go into the report; width and height in pixels."""

    name: str
    raw: bytes
    image: ImageReader
    width: int
    height: int


def logo(document: Document, name: str, given: bytes | None = None) -> Logo | None:
    """The logo of a design, from the bytes `given` or from its file; None where it has none.  Raises BadInput where it can not be drawn."""
    if not name:
        return None

    def refused(reason: Text) -> BadInput:
        return BadInput(document.place, [InputError(document.lines.get(KEY, 0), KEY, f'"{name}"', reason)])

    try:
        raw = _read(Path(document.place).parent / name) if given is None else given
    except OSError as error:
        why = error.strerror or str(error)
        raise refused(Text("cannot be read beside the design: {reason}; put the file there, or leave the logo out", reason=why)) from None
    except ValueError:
        raise refused(Text("is no plain file; put the picture itself beside the design")) from None
    if len(raw) > LOGO_BYTES:
        raise refused(Text("is larger than {most} kB; make it smaller", most=LOGO_BYTES // 1000))
    if not raw.startswith(HEAD) or len(raw) < len(HEAD) + 8:
        raise refused(Text("is no PNG picture"))
    width, height = struct.unpack(">II", raw[len(HEAD) : len(HEAD) + 8])
    if not 0 < width <= LOGO_SIDE or not 0 < height <= LOGO_SIDE:
        raise refused(
            Text("has {width} × {height} pixels; at most {side} either way are drawn", width=width, height=height, side=LOGO_SIDE)
        )
    try:
        image = ImageReader(io.BytesIO(raw))
        image.getRGBData()
    except BROKEN:
        raise refused(Text("is a damaged PNG picture")) from None
    return Logo(name, raw, image, width, height)


def _read(path: Path) -> bytes:
    """The first bytes of a plain file: no link out of the folder, no device that never ends."""
    if not stat.S_ISREG(path.lstat().st_mode):
        raise ValueError(path)
    with path.open("rb") as file:
        return file.read(LOGO_BYTES + 1)
