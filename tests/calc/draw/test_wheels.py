"""The sheets of a design of gears alone: one for each wheel, its sizes those of the train."""

import copy
from itertools import combinations

import pytest

from calc.design.toml_file import Document, design, read
from calc.draw.drawing import CENTRE, EDGE, VISIBLE, Arc, Hatch, Measure
from calc.draw.lettering import room
from calc.solve import solve
from calc.studies.drawings import sheets
from tests.calc.draw.test_sheet import MM, cut, letters, overlap
from tests.conftest import DESIGNS


def drawn(bore=None):
    data = copy.deepcopy(read(DESIGNS / "timing_pair.toml").data)
    if bore is not None:
        data["gears"]["wheels"][0] |= {"bore_diameter_mm": bore, "tip_diameter_tolerance_um": [0, -100]}
    results = solve(design(Document(data)))
    return results, sheets(results, data=data)


@pytest.fixture(scope="module")
def pair():
    return drawn()


def test_every_wheel_has_its_sheet(pair):
    _, made = pair
    assert [sheet.title for sheet in made] == ["Gear crank", "Gear camshaft"]
    assert [
        next(text for text in map(str, (w.text for w in letters(sheet))) if text in ("1/2", "2/2")) for sheet in made
    ] == ["1/2", "2/2"]


def test_circles_and_dimensions_are_those_of_the_train(pair):
    results, made = pair
    values = results.values()
    for sheet, name, b in zip(made, ("crank", "camshaft"), (30.0, 23.0)):
        radii = {
            mark.layer: mark.radius / sheet.scale / MM
            for mark in sheet.marks
            if isinstance(mark, Arc) and mark.radius > 10 * MM
        }
        for layer, size in ((VISIBLE, "tip"), (CENTRE, "reference"), (EDGE, "root")):
            assert 2 * radii[layer] == pytest.approx(values[f"gears.{name}.{size}_diameter"].shown)
        width, tip = (mark for mark in sheet.marks if isinstance(mark, Measure))
        start, end, _ = width.points
        assert width.inscription.words == f"{b:g} ±0.2" and (end[0] - start[0]) / sheet.scale / MM == pytest.approx(b)
        assert tip.turned and tip.inscription.words == f"⌀{round(values[f'gears.{name}.tip_diameter'].shown, 2):g} h10"


def test_the_bore_is_drawn_and_measured_where_it_is_given_and_missed_where_it_is_not(pair):
    _, (with_bore, _) = drawn(40.0)
    found = [mark.inscription for mark in with_bore.marks if isinstance(mark, Measure)]
    assert [(said.words, said.upper, said.lower) for said in found] == [
        ("30 ±0.2", "", ""),
        ("⌀40 H7", "+0.025", "0"),
        ("⌀93.37", "0", "−0.1"),
    ]
    assert sum(isinstance(mark, Hatch) for mark in with_bore.marks) == 2
    words = [mark.text for mark in letters(with_bore)]
    # run-out of tips and face about the bore: F_r, and 0.2·F_β·d_a/b with F_β 19 µm (grade 7)
    assert {"A", "0.031"} <= set(words) and f"{round(0.2 * 19 * 93.37 / 30) / 1e3:g}" in words
    assert "H7 of the bore" in " ".join(words)
    said = " ".join(words.text for words in letters(pair[1][0]))
    assert "Not given by the design: bore and hub" in said and "⌀40" not in said
    assert "accuracy grade of the teeth, the measuring ball" in said and "grade of balancing" not in said


def test_a_small_wheel_is_enlarged():
    """ISO 5455 has 5:1 and 10:1 as well."""
    data = copy.deepcopy(read(DESIGNS / "timing_pair.toml").data)
    data["gears"] |= {"normal_module_mm": 0.5, "face_width_mm": 5.0}
    data["gears"]["wheels"][0]["face_width_mm"] = 6.0
    first, _ = sheets(solve(design(Document(data))), data=data)
    assert first.scale == 5.0 and "5:1" in [words.text for words in letters(first)]


def test_a_wheel_larger_than_the_standards_go_has_its_sheet_without_deviations():
    """ISO 286 ends at 500 mm here."""
    data = copy.deepcopy(read(DESIGNS / "timing_pair.toml").data)
    data["gears"]["normal_module_mm"] = 8.0
    _, second = sheets(solve(design(Document(data))), data=data)
    found = [mark.inscription for mark in second.marks if isinstance(mark, Measure)]
    assert [(said.words[0], said.deviations is None) for said in found] == [("2", False), ("⌀", True)]


@pytest.mark.parametrize("bore", [None, 20.0])
def test_no_two_texts_overlap(bore):
    for sheet in drawn(bore)[1]:
        boxes = [(cut(room(words), 0.05 * MM), words.text) for words in letters(sheet)]
        for (a, text), (b, other) in combinations(boxes, 2):
            assert not overlap(a, b), (text, other)
