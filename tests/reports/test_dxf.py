"""The drawing sheet as a DXF file, read back; its shapes: tests/calc/draw."""

import os
import subprocess
import sys
from dataclasses import replace
from io import StringIO
from itertools import pairwise

import ezdxf
import pytest
from ezdxf import bbox
from ezdxf.entities.lwpolyline import LWPolylinePoints

from calc.design import toml_file
from calc.draw.annotations import corners
from calc.draw.drawing import LAYERS, Measure, Polyline
from calc.draw.shaft_outline import drawn
from calc.draw.turned import turned
from calc.solve import solve
from calc.studies.drawings import drawable, sheets
from reports.dxf import MEASURED, STYLE, dxf, sheet_dxf
from tests.conftest import DESIGNS, GAMMA, ROOT


def read(text):
    return ezdxf.read(StringIO(text))


@pytest.fixture(scope="module")
def sheet(gamma, gamma_results):
    (made,) = sheets(gamma_results, data=gamma.data)
    return made


@pytest.fixture(scope="module")
def written(sheet):
    return sheet_dxf(sheet)


def shapes(document, kind, layer):
    return document.modelspace().query(f'{kind}[layer=="{layer}"]')


# --- the file
def test_the_file_is_valid_and_in_millimetres(written):
    document = read(written)
    audit = document.audit()
    assert not audit.errors and not audit.fixes
    assert document.header["$INSUNITS"] == 4


def test_the_layers_are_those_of_the_sheet_with_their_widths_and_line_types(sheet, written):
    document = read(written)
    assert {entity.dxf.layer for entity in document.modelspace()} == {mark.layer for mark in sheet.views} <= set(LAYERS)
    around = {entity.dxf.layer for entity in document.layout(sheet.paper.name) if entity.dxftype() != "VIEWPORT"}
    assert around == {mark.layer for mark in sheet.around} <= set(LAYERS)
    for name, layer in LAYERS.items():
        found = document.layers.get(name).dxf
        assert found.lineweight == round(100 * layer.width) and found.color == layer.colour
        assert (found.linetype.upper() == "CONTINUOUS") is (not layer.dashes)
    assert len({name: None for name in LAYERS if LAYERS[name].dashes}) == 2


def test_the_shaft_comes_back_in_full_size(written):
    """z from −196.25 to 180.75 mm and 40.5 mm to either side, whatever the scale of the sheet."""
    contour = max((p for p in shapes(read(written), "LWPOLYLINE", "VISIBLE") if p.closed), key=len)
    box = bbox.extents([contour])
    assert tuple(box.size)[:2] == pytest.approx((377.0, 81.0))


def test_the_sections_are_hatched_within_sector_and_core(written):
    """Two hatches, each of a half disc and more on the core: areas after the masses and lengths of the design."""
    found = list(shapes(read(written), "HATCH", "HATCH"))
    areas = []
    for hatch in found:
        (path,) = hatch.paths
        points = [(x, y) for x, y, _ in path.vertices]
        areas.append(abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(points, [*points[1:], points[0]]))) / 2)
    core = 3.14159265 * 15**2
    halves = [
        (91.11 / 180 * 3.14159265 * (40.5**2 - 15**2)) + core,
        (90.85 / 180 * 3.14159265 * (40.5**2 - 15**2)) + core,
    ]
    assert areas == pytest.approx(halves, rel=2e-3)  # chords of 2°
    assert all(hatch.pattern.lines[0].angle == pytest.approx(45.0) for hatch in found)


def test_the_paper_has_a_window_on_the_part_in_the_scale_of_the_sheet(sheet, written):
    """Through it every point of the part is seen where the sheet has it."""
    document = read(written)
    layout = document.layout(sheet.paper.name)
    (window,) = (port for port in layout.query("VIEWPORT") if port.dxf.id != 1)
    assert window.get_scale() == pytest.approx(sheet.scale) and window.dxf.status > 1
    assert not document.layers.get(window.dxf.layer).dxf.plot
    middle, aim, half = window.dxf.center, window.dxf.view_center_point, (window.dxf.width / 2, window.dxf.height / 2)
    for mark in sheet.views:
        for point in corners(mark):  # letters too
            assert all(abs(1e3 * point[n] - middle[n]) < half[n] for n in (0, 1))
    for mark, full in zip(sheet.views, sheet.part):
        if isinstance(mark, Polyline):
            for on_paper, point in zip(mark.points, full.points):
                seen = [middle[n] + sheet.scale * (1e3 * point[n] - aim[n]) for n in (0, 1)]
                assert seen == pytest.approx([1e3 * x for x in on_paper], abs=1e-6)


def test_the_contour_comes_back_as_the_model_has_it(written, gamma_results):
    """The part stands about its own origin: z 0 is mid-shaft, y 0 the axis."""
    contour = max((p for p in shapes(read(written), "LWPOLYLINE", "VISIBLE") if p.closed), key=len)
    outline = gamma_results.shaft.outline
    ends = {round(1e3 * z, 6) for piece in drawn(outline) for z in (piece.start, piece.end)}
    back = sorted({round(x, 6) for x, _ in contour.vertices()})
    assert back == pytest.approx(sorted({min(ends, key=lambda end: abs(end - x)) for x in back}), abs=0.05)
    assert (back[0], back[-1]) == pytest.approx((1e3 * outline.start, 1e3 * outline.end))
    tops = {round(y, 6) for _, y in contour.vertices() if y > 0}
    radii = {round(1e3 * piece.outer_radius, 6) for piece in outline.pieces if piece.what == "journal"}
    assert radii <= tops


def test_dimensions_measure_what_is_drawn_and_have_the_picture_of_the_sheet(sheet, written):
    document = read(written)
    found = list(shapes(document, "DIMENSION", "DIMENSION"))
    asked = [mark for mark in sheet.part if isinstance(mark, Measure)]
    assert {d.dxf.dimstyle for d in found} == {STYLE} and {d.dxf.text for d in found} == {MEASURED}
    across, of_sections = [57.952, 59.5, 81.0], [182.215, 40.5, 15.0, 14.0, 181.694, 40.5, 15.0, 14.0]
    along = [15.0, 27.5, 0.397, 151.364, 2.143, 151.629, 2.468, 26.5, 335.0, 377.0]
    assert [d.get_measurement() for d in found] == pytest.approx([*across, *along, *of_sections], abs=0.006)
    for dimension, mark in zip(found, asked):
        texts = [text.dxf.text for text in document.blocks.get(dimension.dxf.geometry).query("TEXT")]
        words = (mark.inscription.words, mark.inscription.upper, mark.inscription.lower)
        assert texts == [word.replace("⌀", "%%c") for word in words if word]


def functional(results):
    """What the function of each drawn part hangs on, as the model has it: kind and size in mm, across and along."""
    if results.design.countershaft is None:
        for wheel in results.train.wheels.values():
            bore = next(w.bore_diameter for w in results.design.gears.wheels if w.name == wheel.name)
            yield [(90.0, wheel.tip_diameter), (0.0, wheel.face_width), *([(90.0, bore)] if bore else [])]
        return
    for view in drawable(results).values():
        pieces = [piece for piece in turned(view, view.shaft) if piece.functional]
        rows = view.design.countershaft.bearing_positions
        yield [
            *((90.0, 2 * piece.radius) for piece in pieces),
            *((0.0, piece.end - piece.start) for piece in pieces),
            *((0.0, b - a) for a, b in pairwise(rows)),
        ]


@pytest.mark.parametrize("name", sorted(path.stem for path in DESIGNS.glob("*.toml")))
def test_every_functional_size_of_a_shipped_design_is_a_dimension_with_deviations(name):
    """Read from the file; and what a CAD program writes of each dimension is what the sheet says: the measured size,
    rounded as its style says, between its signs, with its deviations."""
    document = toml_file.read(DESIGNS / f"{name}.toml")
    results = solve(toml_file.design(document))
    made = sheets(results, data=document.data)
    for sheet, sizes in zip(made, functional(results) if made else (), strict=True):
        found = list(shapes(read(sheet_dxf(sheet)), "DIMENSION", "DIMENSION"))
        with_deviations = [
            (d.dxf.angle, d.get_measurement()) for d in found if d.dimtype == 0 and d.override().get("dimtol")
        ]
        for direction, size in sizes:
            assert any(
                (angle, length) == (direction, pytest.approx(1e3 * size, abs=1e-6)) for angle, length in with_deviations
            ), (direction, size)
        asked = [mark for mark in sheet.part if isinstance(mark, Measure)]
        assert len(found) == len(asked) > 1
        for dimension, mark in zip(found, asked):
            assert written_by_a_program(dimension, mark.kind) == mark.inscription.words.replace("⌀", "%%c")
            upper, lower = mark.inscription.upper, mark.inscription.lower
            if upper:
                style = dimension.override()
                signs = [float(text.replace("−", "-")) for text in (lower, upper)]
                assert signs == pytest.approx([-style.get("dimtm"), style.get("dimtp")], abs=1e-9)


def written_by_a_program(dimension, kind):
    style = dimension.override()
    size = f"{round(dimension.get_measurement(), style.get('dimadec' if kind == 'angle' else 'dimdec')):.12g}"
    words = f"{size}°" if kind == "angle" else (style.get("dimpost") or "<>").replace("<>", size)
    upper, lower = style.get("dimtp"), style.get("dimtm")
    return f"{words} ±{round(upper, style.get('dimtdec')):.12g}" if style.get("dimtol") and upper == lower else words


@pytest.mark.parametrize("name", ["two\nlines\r\n 0\nEOF", "caret ^J and 100 %%u", "\t\x00 tab", "", "日本語 ⌀"])
def test_a_name_can_not_break_the_file(name, gamma_results):
    results = replace(gamma_results, design=replace(gamma_results.design, name=name))
    document = read(sheet_dxf(sheets(results)[0]))
    assert not document.audit().errors
    plain = " ".join("".join(c if c.isprintable() else " " for c in name).split())
    texts = [t.plain_text().replace("^ ", "^") for t in document.layout("A2").query('TEXT[layer=="TABLE"]')]
    assert f"Title, part of {plain}".replace("%%u", "").replace("⌀", "Ø") in texts or plain == ""


def test_the_same_shaft_gives_the_same_bytes(written, tmp_path):
    """In another process with another seed of hashes, another time zone and another home."""
    code = (
        "import sys; from calc.design.toml_file import design, read; from calc.solve import solve; from "
        "calc.studies.drawings import sheets\n"
        f"from reports.dxf import sheet_dxf; document = read({str(GAMMA)!r})\n"
        "sys.stdout.buffer.write(sheet_dxf(sheets(solve(design(document)), data=document.data)[0]).encode())"
    )
    other = {**os.environ, "PYTHONHASHSEED": "3", "TZ": "Asia/Tokyo", "HOME": str(tmp_path), "PYTHONPATH": str(ROOT)}
    assert (
        subprocess.run(
            [sys.executable, "-c", code], capture_output=True, cwd=ROOT, env=other, check=True
        ).stdout.decode()
        == written
    )


def test_programs_open_it_on_the_whole_drawing(written):
    """The view holds all lines that are drawn."""
    document = read(written)
    view = document.viewports.get("*Active")[0].dxf
    low, high = document.header["$EXTMIN"], document.header["$EXTMAX"]
    box = bbox.extents(document.modelspace().query("LWPOLYLINE"))
    assert low[0] <= box.extmin.x and low[1] <= box.extmin.y and high[0] >= box.extmax.x and high[1] >= box.extmax.y
    assert view.height >= high[1] - low[1]
    assert tuple(view.center)[:2] == pytest.approx(((low[0] + high[0]) / 2, (low[1] + high[1]) / 2))


def test_an_outline_of_many_points_is_put_in_at_once(monkeypatch):
    """Point by point the library would copy all that are there for each: minutes for the teeth of a fine chord
    error."""
    calls, extend = [], LWPolylinePoints.extend
    monkeypatch.setattr(LWPolylinePoints, "extend", lambda self, points: calls.append(1) or extend(self, points))
    points = tuple((n * 1e-3, n % 7 * 1e-3) for n in range(1000))
    (line,) = read(dxf([Polyline("PROFILE", points, True)])).modelspace()
    assert (
        calls == [1]
        and line.closed
        and list(line.vertices()) == [(pytest.approx(x * 1e3), pytest.approx(y * 1e3)) for x, y in points]
    )


def test_the_library_keeps_its_own_options(written):
    from ezdxf import options

    assert options.write_fixed_meta_data_for_testing is False
