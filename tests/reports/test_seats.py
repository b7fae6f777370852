# SPDX-License-Identifier: Apache-2.0
"""Seats in the report, read back: their pictures and tables, over temperature, and no line more where nothing is known
of a seat."""

import pytest
import tomli_w

from calc.draw.drawing import CONTEXT, Area, Sketch
from calc.locale import language
from calc.sheet.step import Curve, Series
from calc.sheet.text import Text
from reports.figures.plots import EDGE_STYLE, series_style
from reports.figures.sketches import ABREAST, PAIRED, _Picture, _rows
from tests.calc.bearings.plain.test_seat_inputs import document
from tests.reports.reading import solved, squeezed, text_of


@pytest.fixture(scope="module")
def read() -> str:
    return text_of(solved(tomli_w.dumps(document().data).encode()).report())


def test_the_seats_have_a_figure_of_their_own(read: str) -> None:
    assert "Figure 1. Bearings (" in read
    figure = read[
        read.index("Figure 1.") : read.index("Figure 2. Seats in section, and what their clearance is made of")
    ]
    for words in ("front: shells, wall 1.496 mm", "rear: bush, wall 1.504 mm", "of 300 MPa", "journal 29.950–29.975"):
        assert words in figure
    assert "gap and relief × 200" in read and "rear: the press adds 12.4 to 20.8 µm" in read.replace("\n", " ")


def test_clearance_and_press_stand_over_each_other_over_temperature(read: str) -> None:
    (number,) = [line for line in read.splitlines() if "Clearance and press of the front bearing over" in line]
    assert "all parts alike" in number
    for words in ("least loose from 135 °C", "shut under the load 2.821 MPa", "least interference"):
        assert words in read
    assert "Pressure of the fit of the front bearing over temperature" not in read  # its caption is that of the stack


def test_stack_and_classes_stand_among_the_tables(read: str) -> None:
    for words in ("What the clearance is made of, rear bearing", "Shells by classes, front bearing"):
        assert words in read
    assert "− 2 × wall 1.5000 1.5080 16" in read and "brown, 26.5 to 48.5 µm" in read
    # inputs: lists of lists, and the material of bush and shells although the file leaves it out
    assert squeezed("[27.987; 27.993]; [27.994; 28.0]") in squeezed(read)
    assert "strip" in read[read.index("Oils and materials", 800) :]


def test_of_a_seat_that_says_nothing_nothing_is_said(engineer: bytes) -> None:
    example = text_of(engineer)
    for words in (
        "Seats in section",
        "What the clearance is made of",
        "over temperature, all parts",
        "Over temperature, ",
    ):
        assert words not in example


def test_pictures_of_one_caption_stand_two_in_a_row() -> None:
    square = ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))
    pictures = [_Picture(Sketch((Area(CONTEXT, (square,)),)), language("en")) for _ in range(4)]
    one, two = (_rows(pictures, "Figure 1. Seats", abreast).height for abreast in (ABREAST, PAIRED))
    assert two > 1.8 * one


def test_the_edges_of_a_band_have_its_style_in_the_legend_too() -> None:
    lines = tuple(Series(Text(name), [0.0, 1.0], [0.0, 1.0]) for name in ("middle", "least", "most"))
    curve = Curve("clearance", Text("Clearance"), Text("T"), Text("g"), lines, band=True)
    assert [series_style(curve, n) == EDGE_STYLE for n in range(3)] == [False, True, True]
