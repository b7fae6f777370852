# SPDX-License-Identifier: Apache-2.0
"""The report of several shafts: what they leave together comes first, then each that is no twin, a twin in few lines."""

import json
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest
import tomli_w

from assistant.exports.drawing import made
from assistant.exports.kinds import Request
from calc.draw.drawing import Words
from calc.studies.drawings import sheets
from reports.blocks.chapter import of_all
from reports.report import context_of
from reports.verify.verify import Verdict, verify
from tests.conftest import ROOT
from tests.reports.reading import Solved, pages_of, solved, squeezed, text_of

GIVEN = json.loads((ROOT / "tests" / "data" / "shafts.json").read_text(encoding="utf-8"))["cases"]["single-four"]
BEARING = dict(diameter_mm=36.0, length_mm=30.0, clearance_um=45.0, journal_roughness_um=0.2, housing_roughness_um=0.4)
ROWS = [dict(name=name, position_mm=z, **BEARING) for name, z in (("front", -60.0), ("rear", 60.0))]


def four() -> dict[str, Any]:
    """A single with two shafts at ±1, a and its mirror image b, and two at ±2, c and d."""
    made = {key: content for key, content in GIVEN.items() if key != "teeth"}
    shaped = dict(material="42CrMo4", core_radius_mm=18.0, outer_radius_mm=40.0, bearings=ROWS)
    made["shafts"] = [shaft if "mirrors" in shaft else shaft | shaped for shaft in made["shafts"]]
    made["bearings"] = dict(oil="SAE 10W", supply="hole", supply_temperature_C=90.0, supply_pressure_bar=3.0)
    made["bearings"] |= dict(hole_diameter_mm=5.0, housing_material="EN AC-43100")
    return made


@pytest.fixture(scope="module")
def single() -> Solved:
    return solved(tomli_w.dumps(four()))


@pytest.fixture(scope="module")
def engineer(single: Solved) -> list[str]:
    return pages_of(single.report())


def test_chapters_have_a_section_for_all_and_one_for_each_shaft(engineer: list[str]) -> None:
    text = "\n".join(engineer)
    titles = ["3 Balance shafts", "3.1 All shafts together", "3.2 a", "3.3 b", "3.4 c", "3.5 d", "4 Bearings"]
    titles += ["4.1 All shafts together", "4.2 a", "4.3 c"]
    contents = text.index("Contents")
    first = text.index("Engine", text.index("Nomenclature", contents))
    for told in (text[contents:first], text[first:]):
        place = 0
        for title in map(squeezed, titles):
            assert title in squeezed(told)[place:], title
            place = squeezed(told).index(title, place)


def test_what_all_leave_stands_in_one_table(single: Solved, engineer: list[str]) -> None:
    """Half of the reciprocating force of order 1 turns against the crank, which b takes, and half with it, which a
    does."""
    (table,) = [table for table in single.results.outcomes["countershaft"].tables if table.id == "sums"]
    assert [label for label, _ in table.columns] == ["", "engine", "a", "b", "c", "d", "left over"]
    rows = {str(row[0]): row[1:] for row in table.rows}
    assert rows["force of order 1, N"][1:3] == pytest.approx((4901.245546, 4901.245546), rel=1e-6)
    assert rows["force of order 1, N"][3:5] == (None, None), "they turn twice as fast"
    assert rows["force of order 1, N"][5] == pytest.approx(1.315947253, rel=1e-6)
    assert rows["roll of order 2, N·m"][3:5] == pytest.approx((129.5991831, 129.5991831), rel=1e-6)
    assert "What the shafts leave over" in "\n".join(engineer)


def test_a_twin_is_told_in_few_words(engineer: list[str]) -> None:
    text = "\n".join(engineer)
    told = squeezed(text[text.index("The mirror image of a") :])[:500]
    assert told.startswith(squeezed("The mirror image of a, at −1 × crank speed."))
    assert squeezed("Rotating force of the shaft 4901 N") in told


@pytest.mark.slow
def test_the_audit_names_checks_and_values_as_the_design_has_them(single: Solved) -> None:
    read = squeezed(text_of(single.report("audit")))
    assert squeezed("countershaft.a.mass") in read and squeezed("countershaft.mass") not in read
    for check in single.results.checks():
        assert squeezed(check.id) in read, check.id


def test_it_verifies(single: Solved) -> None:
    assert verify(single.report("summary"), "four.pdf").verdict is Verdict.IDENTICAL


def test_each_original_has_its_drawing(single: Solved) -> None:
    drawn = sheets(single.results, data=single.document.data)
    assert [sheet.title for sheet in drawn] == [
        "Balance shaft a; b is its mirror image",
        "Balance shaft c; d is its mirror image",
    ]
    words = [{mark.text for mark in sheet.marks if isinstance(mark, Words)} for sheet in drawn]
    assert "1/2" in words[0] and "2/2" in words[1]
    files = made(Request(Path("drive.dxf"), single.document, single.results)).files
    assert [path.name for path in files] == ["drive-a.dxf", "drive-c.dxf"]
    for sheet, text in zip(drawn, files.values()):
        assert sheet.title in text


@pytest.mark.parametrize("step", ["countershaft", "bearings"])
def test_the_picture_has_the_shafts_below_each_other(single: Solved, step: str) -> None:
    make = import_module(f"calc.{step}.sketch").sketch
    whole = make(single.results.design, single.results)
    *_, drawn = (whole, *whole.beside)
    for view in single.results.views.values():  # also where one is in view
        seen = [picture for picture in make(view.design, view).beside if picture.of_all]
        assert [len(picture.primitives) for picture in seen] == [
            len((drawn if step == "bearings" else whole).primitives)
        ]
    names = [mark for mark in drawn.primitives if isinstance(mark, Words) and "," in str(mark.text)]
    (first, second) = sorted(names, key=lambda mark: -mark.at[1])
    assert (str(first.text), str(second.text)) == ("a, b", "c, d")
    assert drawn.of_all == 2


def test_each_line_of_the_shafts_stands_with_all_with_its_shaft_or_with_its_twin(single: Solved) -> None:
    context = context_of(single.document, single.results, single.raw, depth="audit", lang="en")
    _, step, outcome = context.steps()[2]
    own = {line for view in single.results.views.values() for line in view.outcomes[step.key].lines}
    together = of_all(context, step, outcome).lines
    assert {str(line.about).partition(":")[0] for line in together} == {"", "order 1", "order 2"}
    of_twins = [line for line in outcome.lines if line not in own and line not in together]
    assert {str(line.about) for line in of_twins} == {"b", "d", "standing part of the load"}
