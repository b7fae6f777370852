# SPDX-License-Identifier: Apache-2.0
"""The tables of a step, and the tables and long lists among its inputs."""

import io
from functools import partial
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from pypdf import PdfReader

from calc.design.model import STEPS
from calc.locale import language
from calc.sheet.quantity import inputs, integer, quantity, table, tables, text
from calc.sheet.step import Step, Table
from reports.blocks.inputs import ENDS, LONG, exact, input_blocks, material_blocks, used_materials
from reports.blocks.values import _fitting, paired_table, value_blocks
from reports.blocks.words import WORDS
from reports.context import Context
from reports.typesetting.fonts import LEFT, width
from reports.typesetting.pagination import Block
from reports.typesetting.pen import Pen
from reports.typesetting.prose import CELL, NOTE
from reports.typesetting.tables import GUTTER, Cell, Column
from reports.typesetting.tables import table as made_table
from tests.reports.reading import ROOT, V12, pages_of, solved, spans, squeezed, text_of, with_outcome
from tests.reports.test_hostile import inside

REMEDIES = Table(
    "remedies",
    "What takes the couple",
    (("Remedy", ""), ("Couple left", "N·m"), ("Phase", "°"), ("Said", "")),
    (
        ("none at all", 572.9213, 30, None),
        (
            "counterweights on the crank that carry half of the reciprocating masses, and nothing else besides",
            286.46,
            None,
            "turns back",
        ),
        ("counter-shaft", float("nan"), -1.25e-7, "a word"),
    ),
    "At rated speed; the phase from cylinder 1 at TDC.",
)


def test_every_cell_of_a_table_stands_in_the_report() -> None:
    pdf = with_outcome(solved(V12), "engine", tables=(REMEDIES,)).report("audit")
    inside(pdf)
    read = squeezed(text_of(pdf))
    for words in (
        "Tables",
        REMEDIES.title,
        "Couple left, N·m",
        "Phase, °",
        "572.9",
        "286.5",
        "30",
        "no value",
        "1.25·10⁷",
        REMEDIES.note,
        *(cell for row in REMEDIES.rows for cell in row if isinstance(cell, str)),
    ):
        assert squeezed(words) in read, words
    assert squeezed("None") not in read
    text = text_of(pdf)
    assert text.index("Results", text.index("1  Engine")) < text.index(REMEDIES.title)


def test_tables_stand_in_outline_and_contents_but_not_in_the_summary() -> None:
    made = with_outcome(solved(V12), "engine", tables=(REMEDIES,))
    pdf = made.report("audit")
    reader = PdfReader(io.BytesIO(pdf))
    (entry,) = [e for part in reader.outline if isinstance(part, list) for e in part if e.title == "Tables"]
    assert REMEDIES.title in pages_of(pdf)[reader.get_destination_page_number(entry)]
    page = next(page for page, words in zip(reader.pages, pages_of(pdf)) if "Contents" in words)
    links = [a.get_object() for a in page["/Annots"] if "/Dest" in a.get_object()]
    place = [float(entry.top or 0), reader.get_destination_page_number(entry)]
    assert place in [[float(a["/Dest"][3]), reader.get_page_number(a["/Dest"][0].get_object())] for a in links]
    assert REMEDIES.title not in text_of(made.report("summary"))
    assert made.report("audit") == pdf


def test_a_short_report_has_the_key_values_and_names_what_is_zero() -> None:
    made = solved(V12)
    outcome = made.results.outcomes["imbalance"]

    def words(depth: str) -> str:
        context = Context(made.document, made.results, "0" * 64, depth, language("en"))
        values = [value for value in outcome.values() if depth == "audit" or value.short]
        return "\n".join(drawn(value_blocks(context, outcome, values)))

    short, whole = words("engineer"), words("audit")
    assert "counter-shaft must supply" in " ".join(short.split()) and "Zero throughout" in short and "order 2" in short
    assert "rder 6" not in short and "imbalance.order_6" not in short
    assert "rder 6" in whole and "Zero throughout" not in whole, "the audit has everything"


def test_nought_has_no_sign() -> None:
    assert exact(-0.0) == exact(0.0) == "0.0" and exact([-0.0, 1.5]) == "0.0; 1.5" and exact(-0.0, rounded=True) == "0"
    assert exact(0) == "0" and exact(-1e-9) == "−1·10⁻⁹" and exact(-0.25) == "−0.25"
    words = laid({"bore_mm": -0.0})
    assert "0" in words and not any("−0" in w or "-0" in w for w in words)


def test_what_is_not_known_of_a_material_is_a_dash() -> None:
    made = solved((ROOT / "designs" / "twin_force_shaft.toml").read_bytes())
    words = drawn(material_blocks(Context(made.document, made.results, "0" * 64, "engineer", language("en"))))
    used = used_materials(Context(made.document, made.results, "", "engineer", language("en")))[1]
    unknown = sum(m.proof_stress is None for m in used) + sum(m.tensile_strength is None for m in used)
    assert unknown and words.count("–") == unknown and "None" not in words


def test_long_and_wide_tables_are_divided_and_lose_nothing() -> None:
    columns = (("Order", ""), *((f"Amount{i}", "N·m") for i in range(20)))
    rows = tuple((f"row{n}", *(float(1000 * n + i) + 0.5 for i in range(20))) for n in range(60))
    wide = Table("w", "A wide table", columns, rows)
    pdf = with_outcome(
        solved(V12), "engine", tables=(wide, Table("e", "Without rows", columns[:3], (), "Nothing of it."))
    ).report("audit")
    inside(pdf)
    words = text_of(pdf).split()
    for row in rows:
        assert words.count(str(row[0])) >= 2, "its first column names the rows of each part"
        for number in row[1:]:
            assert f"{number:.1f}" in words, "no number is broken"
    assert "A wide table (continued)" in text_of(pdf) and "Nothing of it." in text_of(pdf)
    holding = [page for page in pages_of(pdf) if "row30" in page.split() or "row59" in page.split()]
    assert holding and all("Order" in page for page in holding), "the header is repeated"


def test_numbers_end_at_one_edge_and_words_begin_at_one() -> None:
    rows = tuple(("W" * 20, v, "–" if n == 1 else v) for n, v in enumerate((7123.0, 8.0, 91.25)))
    pdf = with_outcome(
        solved(V12), "engine", tables=(Table("t", "Edges", (("A", ""), ("B", "mm"), ("C", "mm")), rows),)
    ).report("audit")
    page = next(n for n, words in enumerate(pages_of(pdf)) if "Edges" in words)
    words = round(LEFT + width("W" * 20, CELL.size), 1)
    lines: dict[float, list[tuple[float, float]]] = {}
    for span in spans(pdf):
        if span.page == page and span.upright:
            lines.setdefault(round(span.y, 1), []).append((round(span.x, 1), round(span.end, 1)))
    one, two, three = (c for _, c in sorted(lines.items(), reverse=True) if c[0] == (LEFT, words) and len(c) == 3)
    assert one[0][0] == two[0][0] == three[0][0] and one[1][1] == two[1][1] == three[1][1]
    assert one[1][0] != two[1][0], "numbers of different length"
    assert one[2][1] == three[2][1] > two[2][1], "a word among numbers stands to the left"


# --- inputs
@inputs
class Pressure:
    angle: float = quantity("Crank angle", "°")
    pressure: float = quantity("Cylinder pressure", "bar")


@inputs
class Gas:
    peak_pressure: float = quantity("Peak pressure", "bar", default=None)
    pressure: tuple[Pressure, ...] = tables("Pressure in the cylinder", Pressure, default=())


@inputs
class Throw:
    pin_mass: float = quantity("Pin mass", "g")


@inputs
class Body:
    name: str = text("Name")
    mass: float = quantity("Mass", "kg")
    x: float = quantity("Centre, up", "mm")
    y: float = quantity("Centre, side", "mm")
    z: float = quantity("Position", "mm")
    a: float = quantity("Length", "mm")
    pin: int | None = integer("Crankpin", default=None)


@inputs
class Engine:
    bore: float = quantity("Bore", "mm")
    gas: Gas | None = table("Gas force", Gas, default=None)
    throw: Throw | None = table("Throw", Throw, default=None)
    bodies: tuple[Body, ...] = tables("Bodies of the crank", Body, default=())


def laid(data: dict[str, Any], depth: str = "engineer") -> list[str]:
    """The pieces of text that the inputs of a step consist of."""
    document = SimpleNamespace(data={"engine": data}, remarks={})
    context: Any = SimpleNamespace(words=WORDS, say=language("en"), audit=depth == "audit", document=document)
    context.asks = lambda key: True
    context.text = partial(Context.text, context)
    return drawn(input_blocks(context, Step("engine", "Engine", Engine)))


def drawn(blocks: list[Block]) -> list[str]:
    """The pieces of text that blocks consist of."""
    pen = Pen(SimpleNamespace(), {}, {})  # type: ignore[arg-type]
    y = 0.0
    for block in blocks:
        y -= block.gap
        block.draw(pen, y)
        y -= block.height
    return [mark[3] for _, _, mark, *_ in pen.text if mark[0] == "text"]


CYCLE = [{"angle_deg": float(n), "pressure_bar": 1000.0 + n} for n in range(720)]


def test_a_long_array_is_shown_by_its_ends_and_counted() -> None:
    data = {"bore_mm": 94.0, "gas": {"peak_pressure_bar": 140.0, "pressure": CYCLE}}
    words = laid(data)
    assert [w for w in words if w.isdigit() and int(w) >= 1000] == [
        f"{1000 + n}" for n in (*range(ENDS), *range(720 - ENDS, 720))
    ]
    assert "720" in words, "the last row has its own number"
    assert any(str(720 - 2 * ENDS) in w for w in words) and any("720 in all" in w for w in words)
    assert "Gas force" in words and "140" in words
    assert "engine.gas.peak_pressure_bar" in " ".join(laid(data, "audit")), "keys stand in the audit"


def test_the_audit_shows_all_of_it() -> None:
    words = laid({"bore_mm": 94.0, "gas": {"pressure": CYCLE}}, "audit")
    assert {f"{1000 + n}" for n in range(720)} <= set(words) and not any("in all" in w for w in words)


@pytest.mark.parametrize("count", [LONG, LONG + 1])
def test_an_array_of_usual_length_is_shown_whole(count: int) -> None:
    words = laid({"bore_mm": 94.0, "gas": {"pressure": CYCLE[:count]}})
    assert any("in all" in w for w in words) == (count > LONG)
    assert (f"{1000 + count // 2}" in words) == (count <= LONG)


def test_nested_tables_may_be_absent_or_have_one_key() -> None:
    assert "94" in laid({"bore_mm": 94.0}) and "Gas force" not in laid({"bore_mm": 94.0})
    words = laid({"bore_mm": 94.0, "throw": {"pin_mass_g": 310.5}})
    assert "310.5" in words and "Throw" in words


OLD, NEW = (ROOT / "tests" / "data" / folder for folder in ("designs_0_1", "upgraded"))


def inputs_of(name: str, number: int, folder: Path = NEW) -> str:
    """The words of the inputs of a chapter of the audit report."""
    made = solved((folder / f"{name}.toml").read_bytes())
    context = Context(made.document, made.results, made.raw, "audit", language("en"))
    views = [context.in_view(name) for name in made.results.views] if context.shafts else []
    return " ".join(word for one in (context, *views) for word in drawn(input_blocks(one, STEPS[number - 1])))


def test_a_shaft_stands_in_chapter_3_with_the_places_of_its_bearings_and_each_bearing_in_chapter_4() -> None:
    shaft, bearings = inputs_of("r753ie4_gamma", 3), inputs_of("r753ie4_gamma", 4)
    assert "shafts.shaft.core_radius_mm" in shaft and "Front −167.5" in shaft and "Rear 167.5" in shaft
    assert "Journal diameter" not in shaft and "mirrors" not in shaft
    assert "bearings.oil" in bearings and "Front Rear" in bearings and "59.5 81.0" in bearings
    assert "Slope of the journal" in bearings and "0.15625 0.11501" in bearings and "167.5" not in bearings


def test_of_a_pair_the_twin_says_what_it_mirrors_and_screened_bearings_what_they_may_have() -> None:
    shafts = inputs_of("r754ie4_balance_shafts", 3)
    assert "Front Middle Rear" in shafts and "24 24 24" in shafts and "21 21 21" in shafts
    assert shafts.count("shafts.twin.") == 1 and "shafts.twin.mirrors" in shafts
    assert "roughness" not in shafts.casefold() and "slope of the journal" not in shafts


@pytest.mark.parametrize("name", ["r753ie4_gamma", "r754ie4_balance_shafts"])
def test_what_an_old_file_remarks_is_said_once_of_what_says_it_now(name: str) -> None:
    said = inputs_of(name, 3, OLD)
    assert said.count("the middle of the shaft midway") <= 1 and "Bearings;" not in said and "Name" not in said
    assert ("Position, Front; Position, Rear “assumed" if name == "r753ie4_gamma" else "Mirrors, twin “") in said


def test_an_array_of_bodies_is_one_table_with_a_row_for_each() -> None:
    bodies = [
        {"name": f"web{n}", "mass_kg": 1.5 + n, "x_mm": 2.25, "y_mm": 0.0, "z_mm": -3.0 * n, "a_mm": 9.0}
        for n in range(LONG)
    ]
    bodies[4]["pin"] = 1
    words = laid({"bore_mm": 94.0, "bodies": bodies})
    assert words.count("Bodies of the crank") == 1 and not any("continued" in w for w in words)
    n = words.index("web0")
    assert words[n : n + 7] == ["web0", "1.5", "2.25", "0", "0", "9", "–"]
    assert words[words.index("web4") + 6] == "1"


# --- how wide
def test_headers_stand_on_one_line_where_there_is_room() -> None:
    rows = ((600.0, 1.0, 2.0), (1500.0, 3.0, 4.0))
    numbers = Table("m", "Losses over speed", (("n", "rpm"), ("100 °C", "W"), ("120 °C", "W")), rows)
    read = text_of(with_outcome(solved(V12), "engine", tables=(numbers,)).report("audit"))
    assert "n, rpm 100 °C, W 120 °C, W" in " ".join(read.split())


def test_the_parts_of_a_wide_table_are_about_as_wide_as_each_other() -> None:
    columns = [Column("", "l", 60.0), *(Column("", "r", 34.0) for _ in range(12))]
    assert _fitting(columns) == [[0, *range(1, 7)], [0, *range(7, 13)]]
    assert _fitting(columns[:6]) == [[0, 1, 2, 3, 4, 5]] and _fitting([]) == []


def test_what_stands_below_words_runs_on_under_short_neighbours() -> None:
    under = "so long that it does not stand on a single line in a column of this width"
    columns = (Column("A", width=80.0), Column("B", "r", 300.0))
    beside, taller = (
        _words_of(columns, Cell("name", under=(under, NOTE)), words) for words in ("12.5", "many words " * 20)
    )
    assert under in beside and under not in taller
    assert squeezed(under) in squeezed("".join(taller))


def _words_of(columns: tuple[Column, ...], *cells: str | Cell) -> list[str]:
    return drawn(made_table(columns, [cells], width=400.0, header=False))


def test_tables_side_by_side_stand_six_millimetres_apart() -> None:
    """Their words, and their rules."""
    context: Any = SimpleNamespace(words={key: str(words) for key, words in WORDS.items()})
    pen = Pen(SimpleNamespace(), {}, {})  # type: ignore[arg-type]
    rows = [(f"a quantity with a name of some length, {n}", "x", "1234.5", "kg·mm²") for n in range(5)]
    for block in paired_table(context, "", rows):
        block.draw(pen, 0.0)
    right = [x for x, _, mark, _ in pen.text if mark[3] == str(WORDS["quantity"])][1]
    ends = [x + width(mark[3], mark[5], mark[4]) for x, _, mark, _ in pen.text if x < right]
    places = [[float(word) for word in code.split()[4:8]] for code, _ in pen.code]
    assert right - max(ends) > 6 / 25.4 * 72 and GUTTER > 6 / 25.4 * 72
    assert places and all(x + long <= right - GUTTER + 0.1 or x >= right - 0.1 for x, _, long, _ in places)
