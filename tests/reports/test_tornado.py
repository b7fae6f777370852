# SPDX-License-Identifier: Apache-2.0
"""Bars with names, which lie on their side; and figures that are drawn apart."""

import io
from itertools import pairwise

import numpy as np
import pytest
from pypdf import PdfReader

from calc.locale import language
from calc.sheet.step import Curve, Series
from reports.figures.plots import Plots, bar_colour, tick_words
from reports.figures.tornado import Lying, lies
from reports.typesetting.fonts import LEFT, PAGE, RIGHT
from tests.reports.reading import V12, rgb, shapes, solved, spans, squeezed, text_of, with_outcome
from tests.reports.test_hostile import inside

NAMES = (
    "film",
    "friction of the solids μ_s",
    "load sharing of two pairs",
    "viscosity under pressure",
    "limiting shear Λ",
)
LOW, HIGH = np.array([0.0, -1.9, -2.0, 0.5, 0.0]), np.array([-4.4, 1.9, 1.2, 1.0, 0.0])
NAN = float("nan")


def curve(names: tuple[str, ...] = NAMES, low: object = LOW, high: object = HIGH, **changed: object) -> Curve:
    places = np.arange(1.0, len(names) + 1)
    series = (Series("low end", places, low), Series("high end", places, high))
    return Curve("t", "What the constants change", "1 film, 2 …", "ΔP, W", series, bars=True, names=names, **changed)  # type: ignore[arg-type]


def report(*curves: Curve) -> bytes:
    return with_outcome(solved(V12), "engine", curves=curves).report("audit")  # all of them


def bars(pdf: bytes, i: int) -> list[tuple[float, float, float, float]]:
    """The lying bars of the i-th series: left, lower, right and upper edge."""
    corners = [
        np.array(s.parts[0])
        for s in shapes(pdf)
        if s.fill == rgb(bar_colour(i)) and not s.stroke and len(s.parts[0]) == 4
    ]
    return [(*c.min(axis=0).tolist(), *c.max(axis=0).tolist()) for c in corners]


def test_bars_lie_on_both_sides_of_nought_with_the_first_name_on_top() -> None:
    pdf = report(curve())
    inside(pdf)
    low, high = bars(pdf, 0), bars(pdf, 1)
    assert len(low) == 3 and len(high) == 4, "what changes nothing has no bar"
    nought = high[0][2]
    scale = (nought - high[0][0]) / 4.4
    for drawn, values in ((low, LOW[1:4]), (high, HIGH[:4])):
        for (a, _, b, _), value in zip(drawn, values):
            assert (a if value < 0 else b) == pytest.approx(nought + scale * value, abs=0.03)
            assert (b if value < 0 else a) == pytest.approx(nought, abs=0.03)
    assert [b[1] for b in high] == sorted((b[1] for b in high), reverse=True), "the first row on top"
    stacked = sorted([*low, *high], key=lambda b: -b[1])
    assert all(lower[3] <= upper[1] + 0.02 for upper, lower in pairwise(stacked)), "no bar covers another"


def test_names_and_numbers_stand_whole_beside_their_rows() -> None:
    pdf = report(curve())
    read = text_of(pdf)
    for words in (*NAMES, "low end", "high end", "ΔP, W", "Figure 2. What the constants change"):
        assert squeezed(words) in squeezed(read), words
    assert "1 film, 2" not in read and "…" not in read.partition("low end")[2].partition("Figure 2")[0]
    axis = read.partition("limiting shear")[2].split()
    assert axis[axis.index("−4") : axis.index("ΔP,")] == ["−4", "−3", "−2", "−1", "0", "1", "2"]
    nought = bars(pdf, 1)[0][2]
    page = next(n for n, p in enumerate(PdfReader(io.BytesIO(pdf)).pages) if "limiting shear" in p.extract_text())
    _, low, _, top = bars(pdf, 1)[0]
    beside = [s for s in spans(pdf) if s.page == page and low - 1 < s.y < top]
    assert beside and all(s.end < nought and s.upright for s in beside), (
        "the name of the first row stands beside its bar"
    )


@pytest.mark.slow
def test_rows_without_effect_and_without_numbers_are_still_named() -> None:
    none = np.zeros(5)
    strange = np.array([NAN, float("inf"), 1.0, 0.0, -1e-14])
    for low, high in ((none, none), (strange, none)):
        pdf = report(curve(low=low, high=high))
        inside(pdf)
        assert all(squeezed(name) in squeezed(text_of(pdf)) for name in NAMES)
        assert len(bars(pdf, 0)) == np.count_nonzero(np.isfinite(low) & (np.abs(low) > 1e-9)) and not bars(pdf, 1)
    stray = Curve("t", "Stray", "x", "y", (Series("one", [0, 2, 9], [1.0, 2.0, 3.0]),), bars=True, names=NAMES[:2])
    assert len(bars(report(stray), 0)) == 1, "places that have no name"


def test_long_names_wrap_and_many_rows_become_smaller() -> None:
    long = "a constant whose name is a whole sentence, since nothing shorter says what it is about, " * 2
    pdf = report(curve((long, *NAMES[1:])))
    inside(pdf)
    assert squeezed(long) in squeezed(text_of(pdf)), "wrapped and not cut"
    names = tuple(f"constant {i}" for i in range(1, 91))
    values = np.linspace(9.0, 0.1, 90)
    many = curve(names, -values, values)
    pdf = report(many)
    inside(pdf)
    assert all(squeezed(name) in squeezed(text_of(pdf)) for name in names) and len(bars(pdf, 0)) == 90
    assert Lying(many, PAGE[0] - LEFT - RIGHT, Plots(language("en"))).height == pytest.approx(520.0)


def test_limits_are_named_and_bars_without_names_do_not_lie() -> None:
    pdf = report(curve(limits=(("allowed", 3.0), ("none", NAN))))
    inside(pdf)
    assert "allowed 3 W" in text_of(pdf) and "none" not in text_of(pdf).partition("allowed")[2].splitlines()[0]
    assert lies(curve()) and not lies(curve(())), "without names: bars that stand"
    assert report(curve()) == report(curve())


def test_two_variants_of_many_lines_are_drawn_apart() -> None:
    x = np.linspace(0.0, 1.0, 9)
    kinds = ("by regime", "as the source")
    series = tuple(Series(f"oil {i}", x, i * x, kind) for kind in kinds for i in range(1, 4))
    first = Curve("a", "Before", "x", "y", series[:1])
    crowd = Curve("b", "Film", "x", "y", series, variants=kinds)
    read = text_of(report(first, crowd, first))
    for words in (
        "Figure 2. Before",
        "Figure 3a. Film, by regime",
        "Figure 3b. Film, as the source",
        "Figure 4. Before",
    ):
        assert squeezed(words) in squeezed(read), words
    few = Curve("b", "Film", "x", "y", (series[0], series[3]), variants=kinds)
    assert "Figure 2. Film" in text_of(report(few)) and "Figure 2a" not in text_of(report(few))


def test_numbers_of_an_axis_are_written_one_way() -> None:
    assert tick_words([0.0, 0.005, 0.01]) == ["0", "0.005", "0.01"]
    assert tick_words([40.0, 40.025, 40.05]) == ["40", "40.025", "40.05"], "not rounded"
    assert tick_words([-2e-3, 1e-19, 2e-3]) == ["−2·10⁻³", "0", "2·10⁻³"]
    assert tick_words([-1e5, 2e5]) == ["−1·10⁵", "2·10⁵"] and tick_words([]) == []


def test_the_name_of_an_axis_becomes_smaller_before_it_is_cut() -> None:
    label = "x from T₁, mm (A 8.71, B 14.01, C 14.62, D 15.61, E 20.91)"
    x = np.linspace(0.0, 1.0, 9)
    pair = [Curve("a", "Half", words, "y", (Series("", x, x),)) for words in (label, f"{label} and {'so on ' * 40}")]
    pdf = report(*pair)
    inside(pdf)
    read = text_of(pdf)
    assert label in read.splitlines() and "…" in read
