"""The page for the balancing machine: what stands on it, in which sense, and that it has room for it; its rows as CSV,
and both as exports and in a report."""

import csv
import math
from io import BytesIO, StringIO
from pathlib import Path

import pytest
from pypdf import PdfReader

from assistant.exports import balancing
from assistant.exports.kinds import KINDS, Request, in_the_way
from calc.countershaft.balancing.formulas import sense
from calc.countershaft.balancing.inputs import LineCheck
from calc.countershaft.twins import turned_alike
from calc.design.toml_file import design, parse
from calc.draw.annotations import corners
from calc.draw.balancing_sheet import balancing_sheet
from calc.draw.balancing_views import A4, conditions
from calc.draw.drawing import Words, strokes_of
from calc.draw.workshop_sheet import BLOCK_TOP, LEFT, STAMP, DrawnPart
from calc.locale import language
from calc.sheet.record import replace
from calc.sheet.text import Text
from calc.sheet.value import recorded
from calc.solve import solve
from calc.studies.balancing import drag, page_of, sheets
from calc.studies.drawings import release_of
from reports.balancing_sheet import render
from reports.blocks.drawing import balancing_blocks
from reports.report import context_of
from tests.conftest import DESIGNS

R754 = DESIGNS / "r754ie4_balance_shafts.toml"
TEXT = R754.read_text(encoding="utf-8")
BEFORE, _, REST = TEXT.partition("[shafts.balancing]")
AFTER = REST.partition("# assumed: the outline;")[2]
MM = 1e-3


def of(table=None):
    """The shipped design, or with another table in place of its balancing."""
    text = TEXT if table is None else f"{BEFORE}{table}\n#{AFTER}"
    document = parse(text.encode(), "sheet.toml")
    with recorded(False):
        return document, solve(design(document), compared=False)


@pytest.fixture(scope="module")
def shipped():
    return of()


@pytest.fixture(scope="module")
def plain():
    """By the empty table, which takes no further solving."""
    return of("[shafts.balancing]")


@pytest.fixture(scope="module")
def page(shipped):
    return page_of(shipped[1].view("left"), "left")


def sheet_in(page, results, lang="en"):
    part = DrawnPart("Balance shaft left", "42CrMo4")
    return balancing_sheet(page, part, results.design.control, release_of(results), language(lang))


def words_on(sheet):
    return [stroke for mark in sheet.marks for stroke in strokes_of(mark) if isinstance(stroke, Words)]


def test_what_the_operator_looks_for_stands_there(shipped, page):
    there = [words.text for words in words_on(sheet_in(page, shipped[1]))]
    for asked in ("0 = middle of mass front", "angles count clockwise, seen from the front", "5406", "8.65", "L-0117"):
        assert asked in there
    assert "(on right, the mirror image, anticlockwise)" in there and "1: 3.4 · 2: 1.3" in there
    assert "(without its teeth right is the same part)" in there
    assert {"Serial number", "Date", "Name", "Drag torque, 1000 rpm, oil at 40 °C"} <= {*there}


def test_a_hole_in_the_air_has_no_depths_on_the_page(shipped, page):
    front = page.found.hole["front"].drill
    aside = replace(front, name="aside", outside=Text("outside of its sector"))
    drawn = [
        words.text
        for words in words_on(sheet_in(replace(page, found=replace(page.found, outside=(aside,))), shipped[1]))
    ]
    assert drawn.count("Not drilled, in the air") == drawn.count("aside") == drawn.count("outside of its sector") == 1


@pytest.mark.parametrize("angle, same", [(180.0, True), (90.0, True), (120.0, False)])
def test_a_mirror_image_is_the_same_part_where_all_lies_in_one_plane(page, angle, same):
    """A sector at 120° with one at 180° has its mirror image at −120°; one alone, or two across, are turned."""
    outline = page.outline
    pieces = [replace(p, angle=math.radians(angle)) if p.start > 0 and p.half_angle else p for p in outline.pieces]
    if angle == 90.0:
        pieces = [replace(p, angle=math.radians(angle)) for p in pieces]
    assert (turned_alike(replace(outline, pieces=tuple(pieces))) is not None) is same


MANY = "[shafts.balancing]\nzero = 215\nring_positions_mm = [-130, 150]\n" + "".join(
    f'[[shafts.balancing.holes]]\nname = "hole-no-{k}"\nz_mm = {-92 + 13 * k if k < 6 else 14 * k - 60}\n'
    f"angle_deg = {140 + k % 3 * 40}\ndiameter_mm = 6\ndepth_max_mm = {6 + k / 10}\n"
    for k in range(12)
)
MANY += "".join(
    f'[[shafts.balancing.readings]]\nserial = "L-{k}"\nfront_gmm = {20 + 9 * k}\nfront_deg = {72 * k}\nrear_gmm = 14\n'
    "rear_deg = 175\n"
    for k in range(5)
)


@pytest.mark.parametrize("name", ["shipped", "empty", pytest.param("many", marks=pytest.mark.slow)])
def test_all_has_room_within_the_frame_and_above_the_title_block(name, shipped, plain, page):
    results = {"shipped": shipped, "empty": plain}[name][1] if name != "many" else of(MANY)[1]
    drawn = page if name == "shipped" else page_of(results.view("left"), "left")
    for lang in ("en", "it"):
        sheet = sheet_in(drawn, results, lang)
        points = [point for mark in sheet.marks for point in corners(mark)]
        assert min(x for x, _ in points) >= (LEFT - 1e-6) * MM and max(x for x, _ in points) <= (A4.right + 1e-6) * MM
        rows = sorted(words.at[1] for words in words_on(sheet) if words.at[1] > (BLOCK_TOP + STAMP) * MM)
        assert rows[0] > (BLOCK_TOP + STAMP + 0.5) * MM and rows[-1] < A4.top * MM


@pytest.mark.parametrize(
    "ratio, count, turn, clockwise",
    [(2, "with", 1, True), (-2, "with", 1, False), (2, "against", 1, False), (2, "with", -1, False)],
)
def test_the_sense_of_counting_as_it_is_seen(page, ratio, count, turn, clockwise):
    """From the front, of an engine that turns clockwise there (1) or not."""
    seen = replace(page, turn=float(turn), found=replace(page.found, sense=sense(ratio, count)))
    said = "\n".join(map(str, conditions(seen)))
    assert ("angles count clockwise" in said) is clockwise


@pytest.mark.slow
def test_drag_rises_with_speed_and_falls_with_temperature(shipped):
    view = shipped[1].view("left")
    cold, warm, fast = (
        drag(view, LineCheck(speed=n / 60, oil_temperature=T)) for n, T in ((1000, 40.0), (1000, 80.0), (3000, 40.0))
    )
    assert all(least < middle < most for least, middle, most in (cold, warm, fast))
    assert warm[1] < cold[1] < fast[1]


def test_the_pdf_is_a_page_of_a4_and_the_same_bytes(plain):
    once, again = render(*plain), render(*plain)
    (only,) = PdfReader(BytesIO(once)).pages
    assert once == again
    assert [round(float(x) / 72 * 25.4) for x in (only.mediabox.width, only.mediabox.height)] == [210, 297]


def table_of(document, results):
    """Lines with #, the names of the columns, and blocks of rows by their id."""
    (text,) = balancing.made(Request(Path("sheet.csv"), document, results)).files.values()
    lines = text.split("\n")
    head = [line for line in lines if line.startswith("#")]
    names, *rest = lines[len(head) :]
    blocks = [list(csv.DictReader(StringIO(f"{names}\n{block}"))) for block in "\n".join(rest).split("\n\n")]
    return head, names, [{row["id"].partition(".balancing.")[2] or row["id"]: row for row in block} for block in blocks]


@pytest.fixture(scope="module")
def table(shipped):
    return table_of(*shipped)


def test_the_table_says_what_is_counted_from_where(shipped, table):
    head, names, blocks = table
    assert names == "id,value,unit,label" and len(blocks) == 2
    said = dict(line[2:].split(": ", 1) for line in head)
    assert said["sha256"] == shipped[0].sha256 and said["program"].startswith("Contralbero ")
    assert said["design"] == shipped[1].design.name and said["zero, left"] == "0 = middle of mass front"
    assert "# sense, left: angles count clockwise, seen from the front" in head
    assert {"angles", "places", "units", "verdict"} <= {*said}


def test_the_rows_that_are_values_are_those_of_the_design(shipped, table):
    known = shipped[1].values()
    rows = {row["id"]: row for block in table[2] for row in block.values()}
    same = [id for id in rows if id in known]
    assert all((float(rows[id]["value"]), rows[id]["unit"]) == (known[id].shown, known[id].unit) for id in same)
    assert {id for id in known if ".left.balancing." in id} <= {*same} and all(row["label"] for row in rows.values())


def test_the_table_has_all_that_is_on_the_page(table):
    sheet, read = table[2]

    def number(id, rows=sheet):
        return float(rows[id]["value"])

    assert (number("ring_front.angle"), number("ring_front.shop_angle")) == (0.0, 180.0)
    assert (number("front.z"), number("ring_rear.z"), number("hole.front.z")) == (-112.0, 112.0, -58.0)
    assert (number("hole.front.angle"), number("hole.front.shop_angle"), number("hole.rear.diameter")) == (180, 0, 8)
    assert number("hole.front.depth_100") == pytest.approx(8.0) and sheet["hole.front.depth_10"]["value"] == ""
    assert number("line.drag_1.least") < number("line.drag_1.middle") < number("line.drag_1.most")
    assert number("line.backlash_crank_left-idler.wanted") == pytest.approx(90.0, abs=0.5)
    assert "as on the drawing" in sheet["line.end_float"]["label"]
    of = {id.removeprefix("reading.L-0117."): row for id, row in read.items()}
    assert (of["verdict_as_read"]["value"], of["verdict"]["value"], of["kind"]["value"]) == ("fail", "pass", "residual")
    assert number("read_front", of) == 31.0 and number("read_rear.shop_angle", of) == 352.0
    assert number("unreached_front", of) == pytest.approx(31.0 * math.sin(math.radians(8.0)), rel=1e-9)
    assert number("unreached_front.shop_angle", of) == pytest.approx(90.0)


def test_a_design_that_does_not_ask_has_no_sheet():
    document, results = of("")
    assert not sheets(results)
    wrong = in_the_way(KINDS["balancing"], Request(Path("sheet.pdf"), document, results))
    assert "the empty table [shafts.balancing]" in str(wrong.reason)
    context = context_of(document, results, document.raw, depth="engineer", lang="en")
    assert not balancing_blocks(context)


def test_the_report_has_it_as_an_appendix(plain):
    document, results = plain
    context = context_of(document, results, document.raw, depth="engineer", lang="en")
    (block,) = balancing_blocks(context)
    assert "angles count clockwise, seen from the front" in block.tag.alt
