"""The workbook, read back as the XML that it is: numbers are numbers, texts are texts, and the same design is the same
file."""

import re
from io import BytesIO
from math import isfinite
from pathlib import Path
from xml.etree import ElementTree
from zipfile import ZipFile

import pytest

from assistant.exports.kinds import Request
from assistant.exports.spreadsheet import made
from calc.design.toml_file import design, parse
from calc.exchange.loads import loads
from calc.exchange.workbook import Sheet, workbook
from calc.locale import language
from calc.sheet.step import Table
from calc.sheet.text import Name, Text
from calc.solve import solve
from tests.conftest import DESIGNS

pytest.importorskip("xlsxwriter")

MAIN = "{http://schemas.openxmlformats.org/spreadsheetml/2006/main}"
PAIR = DESIGNS / "timing_pair.toml"


def read(content):
    """Sheet → its rows, each a dict of column letters."""
    book = ZipFile(BytesIO(content))
    strings = [
        "".join(part.text or "" for part in item.iter(f"{MAIN}t"))
        for item in ElementTree.fromstring(book.read("xl/sharedStrings.xml"))
    ]
    names = [sheet.get("name") for sheet in ElementTree.fromstring(book.read("xl/workbook.xml")).iter(f"{MAIN}sheet")]
    sheets = {}
    for n, name in enumerate(names, 1):
        tree = ElementTree.fromstring(book.read(f"xl/worksheets/sheet{n}.xml"))
        assert not [*tree.iter(f"{MAIN}f")]  # no formula
        rows = []
        for row in tree.iter(f"{MAIN}row"):
            cells = {}
            for cell in row:
                value = cell.find(f"{MAIN}v")
                if value is not None:
                    letter = re.match("[A-Z]+", cell.get("r"))[0]
                    cells[letter] = strings[int(value.text)] if cell.get("t") == "s" else float(value.text)
            rows.append(cells)
        sheets[name] = rows
    return sheets


@pytest.fixture(scope="module")
def pair():
    document = parse(PAIR.read_bytes(), str(PAIR))
    return document, solve(design(document))


def of(document, results, lang="en"):
    (content,) = made(Request(Path("x.xlsx"), document, results, lang=lang)).files.values()
    return content


def test_every_value_stands_in_full(pair):
    document, results = pair
    sheets = read(of(*pair))
    assert [*sheets] == ["Summary", "Inputs", "Results", "Checks", "Tables"]
    found = {row["A"]: row.get("B") for row in sheets["Results"][1:]}
    assert found == {id: value.shown for id, value in results.values().items()}
    assert all(map(isfinite, found.values()))
    checks = {row["A"]: row.get("D") for row in sheets["Checks"][1:]}
    assert checks == {c.id: c.value if isfinite(c.value) else None for c in results.checks()}
    assert {"SHA-256", document.sha256} <= {text for row in sheets["Summary"] for text in row.values()}


def test_inputs_say_which_are_defaults(pair):
    rows = {row["A"]: row for row in read(of(*pair))["Inputs"][1:]}
    assert rows["gears.normal_module_mm"]["B"] == 2.31 and "D" not in rows["gears.normal_module_mm"]
    assert any(row.get("D") == "default" for row in rows.values())


def test_the_same_design_is_the_same_file_and_speaks_italian(pair):
    assert of(*pair) == of(*pair)
    assert [*read(of(*pair, "it"))] != [*read(of(*pair))]


def test_what_begins_like_a_formula_is_a_text_and_no_number_is_empty():
    from reports.spreadsheet import workbook_bytes

    rows = tuple((Name(text), float("nan")) for text in ("=1+1", "+1", "-1", "@x", "http://x.org"))
    table = Table("t", Text("Results"), ((Text("Id"), ""), (Text("Value"), "mm")), rows)
    content = workbook_bytes([Sheet(Text("Results"), (table,))], "2026-01-01", language("en"))
    head, *cells = read(content)["Results"]
    assert head == {"A": "Id", "B": "Value [mm]"}
    assert cells == [{"A": text} for text in ("=1+1", "+1", "-1", "@x", "http://x.org")]


def test_only_sheets_that_have_something(pair):
    assert all(any(table.rows for table in page.tables) for page in workbook(*pair))


def test_loads_and_balancing_stand_on_sheets_of_their_own():
    path = DESIGNS / "r754ie4_balance_shafts.toml"
    document = parse(path.read_bytes(), str(path))
    results = solve(design(document))
    found = loads(results, [results.design.engine.rated_speed])
    book = {page.title: page for page in workbook(document, results, found)}
    assert {"Loads", "Balancing"} <= book.keys() and "Measurements" not in book
    (table,) = book["Loads"].tables
    assert len(table.rows) == len(found.rows) and all(isinstance(row[0], float) for row in table.rows)
    assert all(".balancing." in row[0] for row in book["Balancing"].tables[0].rows)
