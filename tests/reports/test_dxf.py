"""The drawing of a shaft: its shapes, and the DXF file read back."""

import math
import os
import subprocess
import sys
from io import StringIO

import ezdxf
import pytest
from ezdxf import bbox
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.countershaft.drawing import LAYERS, outline_curve, reach, shaft_drawing, silhouette, upwards
from calc.countershaft.outline import Outline, Piece, outline
from calc.sheet.drawing import Arc, Dimension, Polyline, Words
from reports.dxf import STYLE, dxf

from ..conftest import ROOT

UP = math.radians(210)
POSITIONS = (-0.1675, 0.1675)


def piece(start, end, radius, what, half_angle=None, angle=0.0, core=0.0):
    return Piece(start * 1e-3, end * 1e-3, radius * 1e-3, core * 1e-3, half_angle and math.radians(half_angle), angle, what)


def shaft(front=70.0, rear=110.0) -> Outline:
    """Two opposed sectors between journals, a gear ahead."""
    return outline((
        piece(-196.25, -181.25, 29.35, "gear"), piece(-181.25, -153.75, 29.75, "journal"), piece(-153.75, -152, 15, "core"),
        piece(-152, -1, 40.3, "sector", front, UP, 15), piece(-1, 1, 15, "core"), piece(1, 152, 40.3, "sector", rear, UP - math.pi, 15),
        piece(152, 154.25, 15, "core"), piece(154.25, 180.75, 40.5, "journal"),
    ), derived=True)  # fmt: skip


def read(text):
    return ezdxf.read(StringIO(text))


@pytest.fixture(scope="module")
def written():
    return dxf(shaft_drawing(shaft(), POSITIONS, "Shaft Ø of the test"), LAYERS)


def shapes(document, kind, layer):
    return document.modelspace().query(f'{kind}[layer=="{layer}"]')


# --- shapes -------------------------------------------------------------------------------------------------------------
@settings(deadline=None)
@given(
    half=st.floats(0.05, math.pi), angle=st.floats(-7, 7), up=st.floats(-7, 7),
    core=st.one_of(st.just(0.0), st.floats(0.001, 0.039)),
)  # fmt: skip
def test_the_silhouette_is_that_of_the_points_of_the_section(half, angle, up, core):
    """Against the highest and the lowest of many points of sector and core."""
    part = Piece(0.0, 0.1, 0.04, core, half, angle, "sector")
    points = [radius * math.cos(angle - up + half * n / 2000) for n in range(-2000, 2001) for radius in (0.04, core)]
    high, low = reach(part, up)
    assert high == pytest.approx(max(*points, core), abs=0.04 * (math.pi / 2000) ** 2)
    assert low == pytest.approx(-min(*points, -core), abs=0.04 * (math.pi / 2000) ** 2)


@pytest.mark.parametrize("half, low", [(60.0, 15.0), (90.0, 15.0), (110.0, 15.0), (120.0, 20.15), (180.0, 40.3)])
def test_the_side_away_from_the_sector(half, low):
    """Core up to where −R·cos γ is larger: geometry of the circular sector."""
    high, found = reach(piece(0, 1, 40.3, "sector", half, UP, 15), UP)
    assert high == pytest.approx(0.0403) and found == pytest.approx(low * 1e-3)


def test_the_first_sector_is_drawn_up_and_the_opposed_one_down():
    whole = shaft()
    assert upwards(whole) == UP
    path = silhouette(whole)
    front = [y for x, y in path if -0.152 < x + 1e-9 < 0]
    rear = [y for x, y in path if 0 < x - 1e-9 < 0.152]
    assert max(front) == pytest.approx(0.0403) and min(front) == pytest.approx(-0.015)
    assert max(rear) == pytest.approx(0.015) and min(rear) == pytest.approx(-0.0403)
    assert len(set(path)) == len(path)


def test_the_enclosed_area_is_the_sum_over_the_pieces():
    """Shoelace formula against length times height of every piece."""
    whole = shaft()
    path = silhouette(whole)
    twice = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(path, [*path[1:], path[0]]))
    assert abs(twice) / 2 == pytest.approx(sum(p.length * sum(reach(p, UP)) for p in whole.pieces), rel=1e-12)


@pytest.mark.parametrize("half", [20.0, 90.0, 140.0])
def test_a_section_closes_and_has_the_area_of_sector_and_core(half):
    """Green's theorem over its arcs and lines, against the area that the outline computes."""
    whole = outline((piece(0, 10, 40.3, "sector", half, UP, 15),), derived=False)
    drawn = [p for p in shaft_drawing(whole, (), "") if p.layer == "SECTORS"]
    arcs = [p for p in drawn if isinstance(p, Arc)]
    below = -0.0403  # of the side view
    lines = [p.points for p in drawn if isinstance(p, Polyline) and not p.closed and max(y for _, y in p.points) < below]
    assert len(arcs) == 2 and len(lines) == 2
    (x, y) = arcs[0].centre
    ends = [
        (x + a.radius * math.cos(w), y + a.radius * math.sin(w)) for a in arcs for w in (a.start, a.end)
    ]  # fmt: skip
    for end in ends:
        assert min(math.dist(end, point) for line in lines for point in line) < 1e-12
    area = sum(a.radius**2 / 2 * (a.end - a.start) for a in arcs)  # radial lines add nothing about the centre
    assert area == pytest.approx(whole.area[0], rel=1e-12)


def test_a_whole_ring_is_a_circle():
    whole = outline((piece(0, 10, 40.3, "sector", 180.0, UP, 15),), derived=False)
    (ring,) = (p for p in shaft_drawing(whole, (), "") if isinstance(p, Arc))
    assert ring.end - ring.start == 2 * math.pi and ring.radius == pytest.approx(0.0403)


def test_sectors_of_the_same_shape_share_a_section():
    def letters(whole):
        return [p.text for p in shaft_drawing(whole, (), "") if isinstance(p, Words) and len(p.text) == 1]

    assert letters(shaft()) == ["A", "B"]
    alike = outline((piece(0, 10, 40, "sector", 90, UP, 15), piece(10, 20, 40, "sector", 90, UP, 15)), derived=False)
    assert letters(alike) == ["A", "A"]


def test_a_shaft_without_sectors_is_drawn_as_well():
    plain = outline((piece(0, 10, 5, "full"), piece(10, 30, 8, "full")), derived=False)
    drawn = shaft_drawing(plain, (0.005, 0.02), "")
    assert upwards(plain) == 0.0 and not [p for p in drawn if p.layer == "SECTORS"]
    assert [p for p in drawn if isinstance(p, Dimension) and p.diameter]


def test_what_rounding_leaves_between_two_pieces_is_not_drawn():
    """A hundredth of a millimetre of core between two pieces: no step, no dimension."""
    parts = (piece(0, 10, 40, "full"), piece(10, 10.01, 15, "full"), piece(10.01, 50, 40, "full"))
    drawn = shaft_drawing(outline(parts, derived=False), (), "")
    (path,) = (p.points for p in drawn if p.layer == "OUTLINE")
    assert {round(abs(y), 9) for _, y in path} == {0.04}
    lengths = sorted({round(abs(p.end[0] - p.start[0]), 9) for p in drawn if isinstance(p, Dimension) and not p.upright})
    assert lengths == [0.01001, 0.03999, 0.05]


def test_the_curve_has_the_points_of_the_drawing():
    whole = shaft()
    curve = outline_curve(whole, POSITIONS)
    assert (curve.id, curve.title, curve.equal) == ("outline", "Outline of the shaft", True)
    labels = [series.label for series in curve.series]
    assert labels == ["outline", "axis", "front support", "rear support"]
    drawn = next(p for p in shaft_drawing(whole, POSITIONS, "") if p.layer == "OUTLINE")
    body = list(zip(curve.series[0].x, curve.series[0].y))
    assert body[0] == body[-1]
    assert body[:-1] == [(pytest.approx(1e3 * x, rel=1e-12), pytest.approx(1e3 * y, rel=1e-12)) for x, y in drawn.points]
    assert curve.series[2].x[0] == -167.5 and curve.series[2].y[0] == -29.75  # under the front journal


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
