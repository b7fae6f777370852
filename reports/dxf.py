# SPDX-License-Identifier: Apache-2.0
"""A drawing as a DXF file: lines, arcs, words and dimensions in millimetres, each on its layer.

Nothing of the machine or the hour stands in it: the same drawing gives the same bytes.
"""

import math
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from io import StringIO
from typing import TYPE_CHECKING, Any

from calc.sheet.drawing import Arc, Dimension, Point, Polyline, Primitive, Words
from calc.sheet.units import UNITS

if TYPE_CHECKING:
    from ezdxf.document import Drawing
    from ezdxf.layouts import Modelspace

VERSION = "R2010"  # the oldest with UTF-8 text that programs of today write; all CAD programs read it
MILLIMETRES = 4  # code of DXF's $INSUNITS
COLOURS = {
    "OUTLINE": 7,
    "SECTORS": 5,
    "JOURNALS": 3,
    "GEAR": 6,
    "AXIS": 1,
    "SUPPORTS": 30,
    "DIMENSIONS": 8,
    "TEXT": 7,
    "PROFILE": 7,
    "PROFILE_MAX": 8,
    "PROFILE_MIN": 9,
    "TIP": 4,
    "REFERENCE": 2,
    "BASE": 6,
    "ROOT": 4,
    "FORM": 3,
    "WORKING": 30,
}  # of the DXF palette
DASH_DOTTED = ("AXIS", "REFERENCE", "WORKING")  # centre lines, and circles that nothing touches, as ISO 128 has them
WIDE = 1.6  # width of a usual window over its height
STYLE = "CONTRALBERO"  # of the dimensions
mm = UNITS["mm"].shown


def dxf(drawing: Sequence[Primitive], layers: tuple[str, ...] = ()) -> str:
    """The text of a DXF file.  `layers` are there even where nothing stands on them; further ones are made where they are named."""
    import ezdxf

    with _fixed():
        document = ezdxf.new(VERSION, units=MILLIMETRES)
        document.linetypes.add("CENTER", [20.0, 12.5, -2.5, 2.5, -2.5], description="Center ____ _ ____")
        style: Any = document.dimstyles.duplicate_entry("Standard", STYLE)
        style.dxf.update({"dimdec": 2, "dimzin": 8, "dimdsep": ord("."), "dimtad": 1, "dimtih": 0, "dimtoh": 0, "dimlunit": 2})
        style.dxf.update({part: COLOURS["DIMENSIONS"] for part in ("dimclrd", "dimclre", "dimclrt")})
        for layer in layers:
            _layer(document, layer)
        space = document.modelspace()
        for primitive in drawing:
            if primitive.layer not in document.layers:
                _layer(document, primitive.layer)
            _draw(space, primitive)
        _view(document, drawing)
        for kind in sorted(document.entitydb.dxf_types_in_use()):
            document.classes.add_class(kind)  # else they are written in the order of a set, another one in each run
        text = StringIO()
        document.write(text)
    return text.getvalue()


@contextmanager
def _fixed() -> Iterator[None]:
    """Dates and identifiers that ezdxf keeps fixed for its own tests."""
    from ezdxf import options

    before = options.write_fixed_meta_data_for_testing
    options.write_fixed_meta_data_for_testing = True
    try:
        yield
    finally:
        options.write_fixed_meta_data_for_testing = before


def _layer(document: "Drawing", name: str) -> None:
    document.layers.add(name, color=COLOURS.get(name, 7), linetype="CENTER" if name in DASH_DOTTED else "CONTINUOUS")


def _view(document: "Drawing", drawing: Sequence[Primitive]) -> None:
    """What a program shows when it opens the file: all of it."""
    points = [_at(point) for primitive in drawing for point in _points(primitive)]
    if not points:
        return
    (left, right), (low, high) = ((min(places), max(places)) for places in zip(*points))
    document.modelspace().reset_extents((left, low, 0.0), (right, high, 0.0))
    height = max(high - low, (right - left) / WIDE)
    document.set_modelspace_vport(1.1 * height, ((left + right) / 2, (low + high) / 2))


def _points(primitive: Primitive) -> tuple[Point, ...]:
    match primitive:
        case Polyline():
            return primitive.points
        case Arc():
            (x, y), r = primitive.centre, primitive.radius
            return (x - r, y - r), (x + r, y + r)
        case Words():
            return (primitive.at,)
        case Dimension():
            return primitive.start, primitive.end, primitive.line


def _draw(space: "Modelspace", primitive: Primitive) -> None:
    on = {"layer": primitive.layer}
    match primitive:
        case Polyline():
            space.add_lwpolyline([_at(point) for point in primitive.points], close=primitive.closed, dxfattribs=on)
        case Arc() if primitive.end - primitive.start >= 2 * math.pi:
            space.add_circle(_at(primitive.centre), mm(primitive.radius), dxfattribs=on)
        case Arc():
            start, end = math.degrees(primitive.start) % 360, math.degrees(primitive.end) % 360
            space.add_arc(_at(primitive.centre), mm(primitive.radius), start, end, dxfattribs=on)
        case Words():
            space.add_text(_clean(primitive.text), height=mm(primitive.height), dxfattribs=on).dxf.insert = _at(primitive.at)
        case Dimension():
            h = mm(primitive.height)
            sizes: dict[str, Any] = {"dimtxt": h, "dimasz": 0.8 * h, "dimexe": 0.5 * h, "dimexo": 0.3 * h, "dimgap": 0.25 * h}
            if primitive.diameter:
                sizes["dimpost"] = "⌀<>"
            style = space.add_linear_dim(
                base=_at(primitive.line), p1=_at(primitive.start), p2=_at(primitive.end), angle=90 if primitive.upright else 0,
                dimstyle=STYLE, override=sizes, dxfattribs=on,
            )  # fmt: skip
            if primitive.shift:
                style.shift_text(mm(primitive.shift), 0)
            style.render()


def _at(point: Point) -> tuple[float, float]:
    return mm(point[0]), mm(point[1])


def _clean(text: str) -> str:
    """A text of one line: a line break would end its tag, and a caret begins a control character."""
    printed = "".join(letter if letter.isprintable() else " " for letter in text)
    return " ".join(printed.split()).replace("^", "^ ")
