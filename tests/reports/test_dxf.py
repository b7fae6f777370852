"""The drawing of a shaft as a DXF file, read back; its shapes: tests/calc/countershaft/test_drawing.py."""

import os
import subprocess
import sys
from io import StringIO

import ezdxf
import pytest
from ezdxf import bbox

from calc.countershaft.drawing import LAYERS, shaft_drawing, silhouette
from calc.sheet.drawing import Polyline
from reports.dxf import STYLE, dxf

from ..calc.countershaft.shafts import POSITIONS
from ..calc.countershaft.shafts import drawn_shaft as shaft
from ..conftest import ROOT


def read(text):
    return ezdxf.read(StringIO(text))


@pytest.fixture(scope="module")
def written():
    return dxf(shaft_drawing(shaft(), POSITIONS, "Shaft Ø of the test"), LAYERS)


def shapes(document, kind, layer):
    return document.modelspace().query(f'{kind}[layer=="{layer}"]')


# --- the file -----------------------------------------------------------------------------------------------------------
def test_the_file_is_valid_and_in_millimetres(written):
    document = read(written)
    audit = document.audit()
    assert not audit.errors and not audit.fixes
    assert document.header["$INSUNITS"] == 4
    assert set(LAYERS) <= {layer.dxf.name for layer in document.layers}
    assert {entity.dxf.layer for entity in document.modelspace()} == set(LAYERS)


def test_the_outline_comes_back(written):
    (found,) = shapes(read(written), "LWPOLYLINE", "OUTLINE")
    points = [(x, y) for x, y, *_ in found.get_points()]
    assert found.closed
    assert points == [(pytest.approx(1e3 * x, abs=1e-9), pytest.approx(1e3 * y, abs=1e-9)) for x, y in silhouette(shaft())]
    box = bbox.extents([found])
    assert tuple(box.extmin)[:2] == pytest.approx((-196.25, -40.5)) and tuple(box.extmax)[:2] == pytest.approx((180.75, 40.5))


def test_every_piece_stands_on_its_layer(written):
    document = read(written)
    closed = {layer: [p for p in shapes(document, "LWPOLYLINE", layer) if p.closed] for layer in LAYERS}
    assert {layer: len(found) for layer, found in closed.items()} == {
        "OUTLINE": 1, "SECTORS": 2, "JOURNALS": 2, "GEAR": 1, "AXIS": 0, "SUPPORTS": 2, "DIMENSIONS": 0, "TEXT": 0,
    }  # fmt: skip
    assert [p.get_points()[0][0] for p in closed["SUPPORTS"]] == pytest.approx([-167.5, 167.5])


def test_the_sections_come_back_with_their_radii_and_directions(written):
    """Half-angles 70° and 110° of the two sectors: the outer arcs span twice as much, the first about "up", the other about "down"."""
    outer = [arc.dxf for arc in shapes(read(written), "ARC", "SECTORS") if arc.dxf.radius == pytest.approx(40.3)]
    spans = [(arc.end_angle - arc.start_angle) % 360 for arc in outer]
    assert spans == pytest.approx([140.0, 220.0])
    assert [(arc.start_angle + span / 2) % 360 for arc, span in zip(outer, spans)] == pytest.approx([90.0, 270.0])


def test_dimensions_measure_what_is_drawn(written):
    document = read(written)
    found = shapes(document, "DIMENSION", "DIMENSIONS")
    assert {d.dxf.dimstyle for d in found} == {STYLE}
    across = {round(d.get_measurement(), 6) for d in found if d.dxf.angle == 90}
    along = [round(d.get_measurement(), 6) for d in found if d.dxf.angle == 0]
    assert across == {30.0, 58.7, 59.5, 81.0}
    assert along == [15.0, 27.5, 1.75, 151.0, 2.0, 151.0, 2.25, 26.5, 335.0, 377.0]
    told = {text.text for d in found for text in document.blocks.get(d.dxf.geometry).query("MTEXT")}
    assert {"⌀59.5", "⌀81", "335", "1.75"} <= told


def test_the_title_is_there(written):
    texts = [text.dxf.text for text in shapes(read(written), "TEXT", "TEXT")]
    assert "Shaft Ø of the test" in texts
    assert any("210°" in text for text in texts)


@pytest.mark.parametrize("name", ["two\nlines\r\n 0\nEOF", "caret ^J and 100 %%u", "\t\x00 tab", "", "日本語 ⌀"])
def test_a_name_can_not_break_the_file(name):
    document = read(dxf(shaft_drawing(shaft(), POSITIONS, name), LAYERS))
    assert not document.audit().errors
    plain = " ".join("".join(c if c.isprintable() else " " for c in name).split())
    texts = [text.plain_text().replace("^ ", "^") for text in shapes(document, "TEXT", "TEXT")]
    assert plain.replace("%%u", "") in texts or plain == ""


@pytest.mark.parametrize("seed", ["1", "2", "3", "4"])
def test_the_same_shaft_gives_the_same_bytes(written, tmp_path, seed):
    """In this process, and in others with other seeds of hashes, another time zone and another home."""
    assert dxf(shaft_drawing(shaft(), POSITIONS, "Shaft Ø of the test"), LAYERS) == written
    code = (
        "import sys; from tests.reports.test_dxf import *\n"
        "sys.stdout.buffer.write(dxf(shaft_drawing(shaft(), POSITIONS, 'Shaft Ø of the test'), LAYERS).encode())"
    )
    other = {**os.environ, "PYTHONHASHSEED": seed, "TZ": "Asia/Tokyo", "HOME": str(tmp_path), "PYTHONPATH": str(ROOT)}
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, cwd=ROOT, env=other, check=True).stdout.decode() == written


def test_programs_open_it_on_the_whole_drawing(written):
    """The view holds all lines that are drawn."""
    document = read(written)
    view = document.viewports.get("*Active")[0].dxf
    low, high = document.header["$EXTMIN"], document.header["$EXTMAX"]
    box = bbox.extents(document.modelspace().query("LWPOLYLINE"))
    assert low[0] <= box.extmin.x and low[1] <= box.extmin.y and high[0] >= box.extmax.x and high[1] >= box.extmax.y
    assert view.height >= high[1] - low[1]
    assert tuple(view.center)[:2] == pytest.approx(((low[0] + high[0]) / 2, (low[1] + high[1]) / 2))


def test_the_library_keeps_its_own_options(written):
    from ezdxf import options

    assert options.write_fixed_meta_data_for_testing is False


def test_a_further_layer_is_made_where_it_is_named():
    document = read(dxf([Polyline("TOOTH", ((0.0, 0.0), (0.001, 0.0)))]))
    assert "TOOTH" in document.layers and len(shapes(document, "LWPOLYLINE", "TOOTH")) == 1
