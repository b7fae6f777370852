# SPDX-License-Identifier: Apache-2.0
"""Bars, variants and turning vectors of a figure, read back from the operators of the page."""

import io
import re
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from pypdf import PdfReader

from calc.locale import language
from calc.sheet.step import Curve, Series, Turning
from calc.sheet.text import Text
from reports.figures.arrows import ARROW, LEAST, arrows
from reports.figures.plots import BARS, bar_colour, line_style, series_label, series_style
from reports.figures.spoken import in_words, read_out
from tests.languages.texts import judge_english
from tests.reports.archive_rules import elements
from tests.reports.reading import V12, Shape, rgb, shapes, solved, spans, squeezed, text_of, with_outcome

ORDERS = np.arange(1, 9)
THETA = np.radians(np.arange(0, 361, 3.0))
VARIANTS = ("crank alone", "with the counter-shaft")


def report(*curves: Curve) -> bytes:
    return with_outcome(solved(V12), "engine", curves=curves).report("audit")  # all of them


def bars_of(pdf: bytes, i: int) -> list[tuple[float, float, float, float]]:
    """The bars of the i-th series: left, lower, right and upper edge."""
    (shape,) = [s for s in shapes(pdf) if s.fill == rgb(bar_colour(i)) and s.stroke and len(s.parts) > 1]
    corners = [np.array(part) for part in shape.parts]
    return [(*c.min(axis=0).tolist(), *c.max(axis=0).tolist()) for c in corners]


def test_bars_stand_side_by_side_on_zero() -> None:
    values = [
        np.array([900.0, 387, 1, 12, 5, 30, 40, 8]),
        np.array([600.0, 40, 2, 120, 50, 3, 4, 80]),
        np.array([100.0, 1, 2, 3, 4, 5, 6, 7]),
    ]
    names = ("bare crank", "with counterweights", "with the counter-shaft")
    pdf = report(
        Curve("b", "By order", "order", "C, N·m", tuple(Series(n, ORDERS, v) for n, v in zip(names, values)), bars=True)
    )
    drawn = [bars_of(pdf, i) for i in range(3)]
    ground = drawn[0][0][1]
    scale = (drawn[0][0][3] - ground) / 900
    for bars, heights in zip(drawn, values):
        assert len(bars) == 8
        assert [(top - low) / scale for _, low, _, top in bars] == pytest.approx(heights, abs=0.06 / scale / 4)
        assert all(low == ground for _, low, _, _ in bars)
    in_order = [bars[n] for n in range(8) for bars in drawn]
    assert all(b[0] >= a[2] - 0.02 for a, b in pairwise(in_order)), "no bar covers another"
    read = text_of(pdf)
    assert all(name in read for name in names)
    assert "\n".join("12345678") in read or "1 2 3 4 5 6 7 8" in read.replace("\n", " ")


def test_the_legend_of_bars_has_filled_boxes() -> None:
    series = (Series("one", ORDERS, ORDERS), Series("two", ORDERS, ORDERS))
    for bars in (False, True):
        pdf = report(Curve("b", "By order", "order", "C", series, bars=bars))
        drawn = b"".join(page.get_contents().get_data() for page in PdfReader(io.BytesIO(pdf)).pages)
        for i in range(2):
            assert len(re.findall(rgb(bar_colour(i)).encode() + rb" rg [\d. ]+ re f", drawn)) == bars


def test_bars_differ_in_grey() -> None:
    greys = sorted(0.299 * r + 0.587 * g + 0.114 * b for r, g, b in BARS)
    assert min(b - a for a, b in pairwise(greys)) > 0.12


@pytest.mark.slow
def test_bars_that_are_no_numbers_or_go_down() -> None:
    nan = float("nan")
    curves = (
        Curve("a", "None", "order", "C", (Series("one", [], []), Series("two", [nan], [1.0])), bars=True),
        Curve("b", "Zero", "order", "C", (Series("one", ORDERS, 0 * ORDERS),), bars=True),
        Curve(
            "c",
            "Some",
            "order",
            "C",
            (Series("up", [1, 2, 3], [nan, 4, float("inf")]), Series("down", [1, 2, 3], [-2, -4, -1])),
            bars=True,
        ),
    )
    pdf = report(*curves)
    (up,) = [s.parts[0] for s in shapes(pdf) if s.fill == rgb(bar_colour(0)) and s.stroke]
    down = bars_of(pdf, 1)
    ground = {top for _, _, _, top in down}
    assert len(ground) == 1 and min(y for _, y in up) in ground
    assert max(y for _, y in up) - min(y for _, y in up) == pytest.approx(down[1][3] - down[1][1], abs=0.03)


def test_all_variants_stand_in_one_figure_with_their_names() -> None:
    series = [Series("first order", THETA, THETA * n, v) for n, v in enumerate(VARIANTS, 1)]
    curve = Curve(
        "v",
        "Variants",
        "x",
        "y",
        (*series, Series("limit", THETA, THETA), Series("", THETA, THETA, "third")),
        variants=VARIANTS,
    )
    labels = [series_label(curve, s) for s in curve.series]
    assert labels == ["first order, crank alone", "first order, with the counter-shaft", "limit", "third"]
    pdf = report(curve)
    assert all(squeezed(label) in squeezed(text_of(pdf)) for label in labels)
    drawn = {s.stroke for s in shapes(pdf) if len(s.parts[0]) > 1}
    assert {rgb(line_style(i)[0]) for i in range(4)} <= drawn


def test_no_two_of_many_lines_look_the_same() -> None:
    assert len({line_style(i) for i in range(14)}) == 14


def locus(forward: complex, backward: complex) -> tuple[np.ndarray, np.ndarray]:
    z = forward * np.exp(1j * THETA) + backward * np.exp(-1j * THETA)
    return z.imag, z.real


def heads(pdf: bytes, colour: str) -> list[tuple[float, float]]:
    """The points of all arrows of a colour."""
    return [s.parts[0][0] for s in shapes(pdf) if s.fill == colour and not s.stroke and len(s.parts[0]) in (3, 4)]


def shafts(pdf: bytes, colour: str) -> list[Shape]:
    return [s for s in shapes(pdf) if s.stroke == colour and not s.fill and len(s.parts[0]) == 2]


def test_the_longest_caption_under_a_half_of_the_page_is_whole() -> None:
    title = (
        "Scenarios, mesh crank–camshaft, 10W-40: normal force per length of the contact line, as the pairs share it "
        "along the path, source: EHL everywhere"
    )
    curve = Curve("t", title, "x from T₁, mm", "w, N/mm", (Series("a", THETA, THETA),))
    read = squeezed(text_of(report(curve, replace(curve, id="u"))))
    assert read.count(squeezed("source: EHL everywhere")) == 2


def test_vectors_are_drawn_tip_to_tail_in_true_scale() -> None:
    names = ("forward", "backward", "next to nothing")
    chain = Turning(names, (300 + 0j, 400j, 0.9 * LEAST * 400), (1, -1, 2))
    pdf = report(
        Curve(
            "t",
            "Locus",
            "horizontal, N·m",
            "vertical, N·m",
            (Series("", *locus(300, 400j)),),
            equal=True,
            turning=(chain,),
        )
    )
    tips = heads(pdf, rgb(ARROW))
    assert len(tips) == 4, "two in the legend, two in the figure"
    (_, _, (x1, y1), (x2, y2)) = tips
    assert x2 - x1 > 10 and y2 == pytest.approx(y1, abs=0.02), "imaginary to the right"
    origin = shafts(pdf, rgb(ARROW))[2].parts[0][0]
    assert origin[0] == pytest.approx(x1, abs=0.02), "real is up"
    assert (y1 - origin[1]) / 300 == pytest.approx((x2 - x1) / 400, rel=2e-3), "one scale for both axes"
    read = text_of(pdf)
    assert "forward" in read and "backward" in read and "next to nothing" not in read
    (drawn,) = [np.array(s.parts[0]) for s in shapes(pdf) if s.stroke == rgb(line_style(0)[0]) and len(s.parts[0]) > 20]
    assert min(np.hypot(*(drawn - (x2, y2)).T)) < 0.1, "the end of the chain lies on its locus"


def test_each_variant_has_its_chain_in_the_colour_of_its_locus() -> None:
    first = Turning(("crank",), (300 + 0j,), (1,), VARIANTS[0])
    second = Turning(("crank", "counter-shaft"), (300 + 0j, -100j), (1, -1), VARIANTS[1])
    series = (Series("locus", *locus(300, 0), VARIANTS[0]), Series("locus", *locus(300, -100j), VARIANTS[1]))
    curve = Curve("t", "Locus", "x, N", "y, N", series, equal=True, variants=VARIANTS, turning=(first, second))
    assert [(a.number, a.name, a.variant) for a in arrows(curve)] == [
        (1, "crank", VARIANTS[0]),
        (2, "counter-shaft", VARIANTS[1]),
    ]
    pdf = report(curve)
    assert len(heads(pdf, rgb(line_style(0)[0]))) == len(heads(pdf, rgb(line_style(1)[0]))) == 1
    assert report(curve) == pdf


def test_vectors_that_are_no_numbers() -> None:
    nan = complex("nan")
    chain = Turning(("a", "b", "c"), (1 + 0j, nan, 2 + 0j), (1, 2, 3))
    nothing = Turning(("a", "b"), (0j, 0j), (1, 2))
    curves = [
        Curve("t", "Locus", "x", "y", (Series("", *locus(1, 2)),), equal=True, turning=(t,)) for t in (chain, nothing)
    ]
    assert [[a.name for a in arrows(c)] for c in curves] == [["a"], []]
    assert len(heads(report(*curves), rgb(ARROW))) == 2


def test_loci_that_run_over_each_other_are_both_seen() -> None:
    """The first is broader than what is drawn over it, in each variant; a locus alone, and other curves, are as thick
    as ever."""
    x, y = np.sin(THETA), np.cos(THETA)
    two = tuple(Series(name, x, y, variant) for variant in VARIANTS for name in ("order 1", "all orders"))
    curve = Curve("l", "Locus", "x, N", "y, N", two, equal=True, variants=VARIANTS)
    thick = [series_style(curve, i)[2] for i in range(4)]
    assert thick[0] > 2 * thick[1] and thick[2] > 2 * thick[3]
    for alone in (replace(curve, series=two[:1]), replace(curve, equal=False)):
        assert all(series_style(alone, i) == line_style(i) for i in range(len(alone.series)))
    drawn = b"".join(page.get_contents().get_data() for page in PdfReader(io.BytesIO(report(curve))).pages)
    for i, wanted in enumerate(thick):
        assert f"{rgb(line_style(i)[0])} RG {wanted:.2f} w".encode() in drawn


@pytest.mark.slow
def test_figures_write_numbers_as_their_language_does(relazione: bytes) -> None:
    """Ticks, the value where the design stands, limits; and no sentence of the report has a decimal point before a
    unit but one that has no translation yet."""
    read = text_of(relazione)
    assert "7,409 µm" in read and "86,64 N·m" in read and "17,5" in read
    judge_english("it", re.findall(r"\d\.\d+ (?:µm|mm|N·m|N|W|kg|MPa|K|°C|%)(?!\w)", read))


def test_lines_of_a_stack_are_named_by_a_sample_of_each(relazione: bytes) -> None:
    """Three lines in 44 points leave no place at which a name could belong to but one of them: the legend stands over
    the axes."""
    name, *labels = (
        [s for s in spans(relazione) if s.text == words]
        for words in ("freccia, µm", "con la quota di rigidezza dei settori", "a rigidezza piena", "cuscinetti")
    )
    assert len(name) == 1 and all(
        any(s.page == name[0].page and abs(s.y - name[0].y) < 0.1 for s in found) for found in labels
    )


def test_a_figure_is_told_as_a_person_would(engineer: bytes) -> None:
    """Where a line is largest and smallest, in units and not in symbols; of a sketch no lone numbers and signs."""
    told = [str(e["/Alt"]) for e in elements(PdfReader(io.BytesIO(engineer))) if e["/S"] == "/Figure"]
    (film,) = [words for words in told if words.startswith("Figure 10. ")]
    assert "Over speed: mid-bearing is largest, 16.88 µm, at 1251 rpm, and smallest, 9.979 µm, at 2497 rpm" in film
    assert "the limit Kreisle is 9 µm" in film and "h_0" not in film
    assert all("✗" not in words and "▲" not in words and "…;" not in words for words in told)
    assert any("7.4 of 9 µm (fails)" in words for words in told)
    assert read_out(["1", "1", "A", "bare 1150", "210°", "bare 1150", "6 µm"]) == ["bare 1150", "6 µm"]


def test_values_throughout_marks_and_loci_are_told_as_such() -> None:
    def told(x: list[float], y: list[float], **kind: Any) -> str:
        series = (Series(Text("it"), np.array(x), np.array(y)),)
        return in_words(Curve("", Text(), Text("speed, rpm"), Text("P, W"), series, **kind), language("en"))

    assert told([1, 2, 3], [5, 5, 5 + 1e-12]) == "Over speed: it is 5 W throughout"
    assert told([2, 2], [0, 7]) == "Over speed: it is marked at 2 rpm"
    assert told([0, 4], [1e-13, 2], equal=True) == "it reaches from 0 rpm to 4 rpm across and from 0 W to 2 W upwards"
    assert told([1, 2], [-9, 2], names=(Text("oil"), Text("load"))) == "it goes furthest at oil, by −9 W"
    assert told([1, 2], [0, 3], limits=((Text("of heat"), 4.0),)).endswith("at 1 rpm; the limit of heat is 4 W")
