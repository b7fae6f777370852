# SPDX-License-Identifier: Apache-2.0
"""A drawing as a DXF file: lines, arcs, words and dimensions in millimetres, each on its layer.

Nothing of the machine or the hour stands in it: the same drawing gives the same bytes.
"""

import math
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from io import StringIO
from typing import TYPE_CHECKING, Any

from calc.draw.annotations import corners
from calc.draw.drawing import (
    LAYERS,
    Arc,
    Area,
    Hatch,
    Ink,
    Inscription,
    Measure,
    Point,
    Polyline,
    Words,
    moved,
    reach,
    spanned,
)
from calc.draw.lettering import ARROW, BEYOND, OFF
from calc.sheet.units import UNITS, Metre
from calc.studies.drawings import WorkshopSheet

if TYPE_CHECKING:
    from ezdxf.document import Drawing
    from ezdxf.layouts import BaseLayout

VERSION = "R2010"  # the oldest with UTF-8 text that programs of today write; all CAD programs read it
MILLIMETRES = 4  # code of DXF's $INSUNITS
COLOURS = {
    "PROFILE": 7, "PROFILE_MAX": 8, "PROFILE_MIN": 9, "TIP": 4, "REFERENCE": 2, "BASE": 6, "ROOT": 4, "FORM": 3,
    "WORKING": 30, "AXIS": 1
}  # fmt: skip  # of the DXF palette, for what is drawn of gears; a sheet's layers have their own
DASH_DOTTED = ("AXIS", "REFERENCE", "WORKING")  # centre lines, and circles that nothing touches, as ISO 128 has them
WIDE = 1.6  # width of a usual window over its height
STYLE = "CONTRALBERO"  # of the dimensions
DIMENSION_STYLE = {
    "dimdec": 2, "dimzin": 8, "dimazin": 2, "dimdsep": ord("."), "dimtad": 1, "dimtih": 0, "dimtoh": 0, "dimlunit": 2,
    "dimtolj": 0, "dimtfac": 1.0, "dimtzin": 0
}  # fmt: skip
DIAMETER = "%%c"  # the sign of a diameter, which every font of a CAD program has
MEASURED = "<>"  # what a CAD program puts the measured size in for
OWN_BLOCK = 32  # of a dimension's type: its block is its own
POINTS: dict[
    str, tuple[int, tuple[str, ...]]
] = {  # the type of a dimension, and what the points of a measure are to it
    "length": (0, ("defpoint2", "defpoint3", "defpoint")),
    "radius": (4, ("defpoint", "defpoint4")),
    "angle": (5, ("defpoint2", "defpoint3", "defpoint4", "defpoint")),
}
WINDOW = "WINDOW"
ROUND = 2.0  # around what a window shows
LETTERS = "ISO 3098"  # style of a sheet's letters
# what CAD programs have for ISO 3098; its letters are narrower than those that a sheet makes room for
FONT = "isocpeur.ttf"
DIAGONAL = math.sqrt(0.5)
STRAIGHT = (0.0, 0.0, 0.0)  # widths at both ends and bulge of a side of a polyline
mm = UNITS["mm"].shown


def sheet_dxf(sheet: WorkshopSheet) -> str:
    """A drawing sheet as the text of a DXF file: in the model the part in full size with its dimensions, letters and
    line types larger than on paper in the measure of the scale; on a layout the paper, with a window on the part."""
    return dxf(sheet.part, tuple(LAYERS), 1 / sheet.scale, sheet)


def wheel_dxf(teeth: Sequence[Ink], layers: tuple[str, ...], sheet: WorkshopSheet) -> str:
    """The teeth of a wheel about the origin, with their data; to their left the wheel as its sheet shows it, and on a
    layout the sheet."""
    left, right = (spanned(point for mark in marks for point in _points(mark)) for marks in (teeth, sheet.part))
    away = left[0] - right[2] - (left[2] - left[0]) / 2
    part = [moved(mark, away, 0.0) for mark in sheet.part]
    return dxf([*teeth, *part], (*layers, *LAYERS), 1 / sheet.scale, sheet, away)


def dxf(
    drawing: Sequence[Ink],
    layers: tuple[str, ...] = (),
    by: float = 1.0,
    sheet: WorkshopSheet | None = None,
    away: Metre = 0.0,
) -> str:
    """The text of a DXF file.  `layers` are there even where nothing stands on them; further ones are made where they
    are named.

    `by`: how many times longer than on paper the dashes of its lines are; `sheet`: the paper around the drawing;
    `away`: where in the drawing the part of that sheet stands, to the right of its origin.
    """
    import ezdxf

    with _fixed():
        document = ezdxf.new(VERSION, units=MILLIMETRES)
        document.linetypes.add("CENTER", [20.0, 12.5, -2.5, 2.5, -2.5], description="Center ____ _ ____")
        style: Any = document.dimstyles.duplicate_entry("Standard", STYLE)
        style.dxf.update(DIMENSION_STYLE)
        style.dxf.update(
            {"dimtxt": 2.5 * by, "dimasz": ARROW * 2.5 * by, "dimexe": BEYOND * 2.5 * by, "dimexo": OFF * 2.5 * by}
        )
        document.styles.add(LETTERS, font=FONT)
        for layer in dict.fromkeys(layers):
            _layer(document, layer, by)
        document.header["$LWDISPLAY"] = 1  # the widths of the lines are shown
        space = document.modelspace()
        for mark in drawing:
            if mark.layer not in document.layers:
                _layer(document, mark.layer, by)
            _draw(document, space, mark)
        _view(document, drawing)
        if sheet is not None:
            _paper(document, sheet, mm(away))
        for kind in sorted(document.entitydb.dxf_types_in_use()):
            document.classes.add_class(kind)  # else they are written in the order of a set, another one in each run
        text = StringIO()
        document.write(text)
    return text.getvalue()


def _paper(document: "Drawing", sheet: WorkshopSheet, away: float) -> None:
    """The layout: frame, title block, tables and notes, and a window on the model in the scale of the sheet."""
    layout = document.paperspace()
    document.layouts.rename(layout.name, sheet.paper.name)
    layout.page_setup(size=(sheet.paper.wide, sheet.paper.high), margins=(0, 0, 0, 0), units="mm")
    document.header["$PSLTSCALE"] = 0  # dashes are as long as the model has them
    for mark in sheet.around:
        _draw(document, layout, mark)
    left, low, right, top = (mm(side) for side in spanned(point for mark in sheet.views for point in corners(mark)))
    size, middle = (right - left + 2 * ROUND, top - low + 2 * ROUND), ((left + right) / 2, (low + top) / 2)
    x, y = ((middle[n] - mm(sheet.origin[n])) / sheet.scale for n in (0, 1))
    window = layout.add_viewport(middle, size, (x + away, y), size[1] / sheet.scale, status=2)
    document.layers.add(WINDOW, color=8, plot=False)  # the edges of the window are not printed
    window.dxf.layer = WINDOW


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


def _layer(document: "Drawing", name: str, by: float) -> None:
    if (known := LAYERS.get(name)) is None:
        document.layers.add(
            name, color=COLOURS.get(name, 7), linetype="CENTER" if name in DASH_DOTTED else "CONTINUOUS"
        )
        return
    dashes = [dash * by for dash in known.dashes]
    if dashes and f"{name}_LINE" not in document.linetypes:
        document.linetypes.add(f"{name}_LINE", [sum(map(abs, dashes)), *dashes])
    layer = document.layers.add(name, color=known.colour, linetype=f"{name}_LINE" if dashes else "CONTINUOUS")
    layer.dxf.lineweight = round(100 * known.width)


def _view(document: "Drawing", drawing: Sequence[Ink]) -> None:
    """What a program shows when it opens the file: all of it."""
    if not drawing:
        return
    left, low, right, high = map(mm, spanned(point for mark in drawing for point in _points(mark)))
    document.modelspace().reset_extents((left, low, 0.0), (right, high, 0.0))
    height = max(high - low, (right - left) / WIDE)
    document.set_modelspace_vport(1.1 * height, ((left + right) / 2, (low + high) / 2))


def _points(mark: Ink) -> Iterable[Point]:
    return (*mark.points, *reach(mark)) if isinstance(mark, Measure) else reach(mark)


def _draw(document: "Drawing", space: "BaseLayout", mark: Ink) -> None:
    on = {"layer": mark.layer}
    match mark:
        case Polyline():
            line = space.add_lwpolyline((), close=mark.closed, dxfattribs=on)
            # one by one, each would copy all before it
            line.lwpoints.extend([(*_at(point), *STRAIGHT) for point in mark.points])
        case Arc() if mark.end - mark.start >= 2 * math.pi:
            space.add_circle(_at(mark.centre), mm(mark.radius), dxfattribs=on)
        case Arc():
            start, end = math.degrees(mark.start) % 360, math.degrees(mark.end) % 360
            space.add_arc(_at(mark.centre), mm(mark.radius), start, end, dxfattribs=on)
        case Words():
            _words(space, mark)
        case Area(outlines=outlines):
            for outline in outlines:
                space.add_solid([_at(point) for point in (*outline, outline[-1])[:4]], dxfattribs=on)
        case Hatch():
            _hatch(space, mark)
        case Measure():
            _dimension(document, space, mark)


def _words(space: "BaseLayout", words: Words) -> None:
    on = (
        {"layer": words.layer}
        | ({"style": LETTERS} if words.layer in LAYERS else {})
        | ({"rotation": 90.0} if words.turned else {})
    )
    text = space.add_text(_clean(words.text), height=mm(words.height), dxfattribs=on)
    if words.side == "left":
        text.dxf.insert = _at(words.at)
    else:
        from ezdxf.enums import TextEntityAlignment as Side

        text.set_placement(_at(words.at), align=Side.CENTER if words.side == "centre" else Side.RIGHT)


def _hatch(space: "BaseLayout", hatch: Hatch) -> None:
    """As a hatch of the program that opens the file, its lines where the report has them."""
    entity = space.add_hatch(dxfattribs={"layer": hatch.layer})
    apart = mm(hatch.spacing) * DIAGONAL
    entity.set_pattern_fill("ANSI31", color=256, definition=[[45.0, (0.0, 0.0), (-apart, apart), []]])
    for outline in hatch.outlines:
        entity.paths.add_polyline_path([_at(point) for point in outline], is_closed=True)


def _dimension(document: "Drawing", space: "BaseLayout", measure: Measure) -> None:
    """A dimension that knows what it measures and may deviate, with the strokes of the sheet as its picture."""
    block = document.blocks.new_anonymous_block(type_char="D")
    for stroke in measure.picture:
        _draw(document, block, stroke)
    words = next(stroke for stroke in measure.picture if isinstance(stroke, Words))
    points = [(*_at(point), 0.0) for point in measure.points]
    kind, names = POINTS[measure.kind]
    entity: Any = space.new_entity(
        "DIMENSION",
        {
            "layer": measure.layer,
            "dimstyle": STYLE,
            "geometry": block.name,
            "dimtype": OWN_BLOCK | kind,
            "text": MEASURED,
            "text_midpoint": (*_at(words.at), 0.0),
            **dict(zip(names, points)),
        }
        | ({"angle": math.degrees(measure.turned)} if measure.kind == "length" else {}),
    )
    entity.set_acad_dstyle(_style_of(measure.inscription, measure.kind))


def _style_of(inscription: Inscription, kind: str) -> dict[str, object]:
    """How a dimension differs from its style: what stands around its number, its decimals, its deviations."""
    own: dict[str, object] = {"dimadec" if kind == "angle" else "dimdec": inscription.digits}
    if inscription.post != MEASURED and kind != "angle":
        own["dimpost"] = inscription.post.replace("⌀", DIAMETER)
    if inscription.deviations is not None:
        lower, upper = inscription.deviations
        places = max(len(f"{x:.4f}".rstrip("0").partition(".")[2]) for x in (lower, upper))
        own |= {"dimtol": 1, "dimtp": upper, "dimtm": -lower, "dimtdec": places}
    return own


def _at(point: Point) -> tuple[float, float]:
    return mm(point[0]), mm(point[1])


def _clean(text: str) -> str:
    """A text of one line: a line break would end its tag, and a caret begins a control character."""
    printed = "".join(letter if letter.isprintable() else " " for letter in text)
    return " ".join(printed.split()).replace("^", "^ ").replace("⌀", DIAMETER)
