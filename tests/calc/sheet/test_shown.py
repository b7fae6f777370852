"""Results in a notebook or a script: as HTML, as a frame, as a plot."""

import sys
from html.parser import HTMLParser

import matplotlib
import numpy as np
import pytest

from calc import BadInput, bearings, gears, imbalance
from calc.sheet.curve import Curve, DrawnLoad, Series
from calc.sheet.text import Text
from calc.solve import Results

matplotlib.use("Agg")
FILM = dict(diameter=0.0595, length=0.0275, load=1707, speed=43.33, oil="SAE 50", supply_temperature=100)
CLEARANCES = np.linspace(40e-6, 400e-6, 5)


@pytest.fixture(autouse=True)
def closed():
    yield
    from matplotlib import pyplot

    pyplot.close("all")


@pytest.fixture(scope="module")
def films():
    return bearings.solve_film(**FILM, clearance=CLEARANCES)


class Cells(HTMLParser):
    """The cells of a table, row by row, and the sentences below it."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.rows, self.below, self.open = [], [], []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.open.append(tag)
        if tag == "tr":
            self.rows.append([])

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        if self.open[-1] == "td":
            self.rows[-1].append(data)
        elif self.open[-1] == "p":
            self.below.append(data)


# --- HTML
def test_a_result_is_a_table_of_what_it_prints():
    pair = gears.solve_pair((32, 41), normal_module=2.25e-3, face_width=18e-3)
    rows = Cells(pair._repr_html_()).rows
    printed = str(pair).splitlines()[1:]
    assert len(rows) == len(printed) > 50
    assert [" ".join(row).split() for row in rows] == [line.split() for line in printed]


def test_an_outcome_and_results_tell_what_fails(gamma_results: Results):
    shown = Cells(gamma_results.bearings._repr_html_())
    assert len(shown.rows) == len(gamma_results.bearings.values())
    assert len(shown.below) == sum(check.open for check in gamma_results.bearings.checks) > 1
    whole = Cells(gamma_results._repr_html_())
    assert [row[0] for row in whole.rows][:3] == ["Engine", "Imbalance", "Counter-shaft"]
    assert len(whole.below) == sum(check.verdict == "fail" for check in gamma_results.checks())


def test_what_a_design_says_is_no_markup(gamma_results: Results):
    from dataclasses import replace

    named = replace(gamma_results, design=replace(gamma_results.design, name="<script>alert(1)</script>"))
    assert "<script>" not in named._repr_html_() and "&lt;script&gt;" in named._repr_html_()


# --- frames
def test_without_pandas_a_sentence_says_what_to_install(films, monkeypatch):
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(ImportError, match=r"needs pandas, .* pip install 'contralbero\[pandas\]'"):
        films.to_frame()


def test_numbers_are_rows_by_their_names(gamma_results: Results):
    pytest.importorskip("pandas")
    whole, step = gamma_results.to_frame(), gamma_results.bearings.to_frame()
    assert list(whole.columns) == ["value", "unit", "label"]
    for value in gamma_results.bearings.values():
        assert whole.loc[value.id, "value"] == step.loc[value.id, "value"] == value.shown
        assert step.loc[value.id, "unit"] == value.unit
    alone = gamma_results.bearings.solution.to_frame()
    assert alone.loc["front.film", "value"] == step.loc["bearings.front.film", "value"]
    assert whole.index.is_unique


def test_arrays_are_columns_in_the_units_of_a_file(films):
    pytest.importorskip("pandas")
    frame = films.to_frame()
    assert len(frame) == CLEARANCES.size
    assert frame["film_um"].to_numpy() == pytest.approx(films.film * 1e6)
    assert frame["friction_power_W"].to_numpy() == pytest.approx(films.friction_power)


def test_engines_of_arrays_are_a_row_each(gamma_results: Results):
    pytest.importorskip("pandas")
    many = imbalance.solve_imbalance(gamma_results.design.engine, piston_mass=np.linspace(0.3, 0.6, 4))
    frame = many.to_frame()
    assert len(frame) == 4
    assert frame["order_2.couple_peak_Nm"].to_numpy() == pytest.approx(many.orders["order_2"].couple_peak)


# --- plots
def test_a_value_is_drawn_over_another_or_over_an_array(films):
    (line,) = films.plot(x="clearance").get_lines()  # the film stands for the film
    assert line.get_xdata() == pytest.approx(films.clearance * 1e6)
    assert line.get_ydata() == pytest.approx(films.film * 1e6)
    axes = films.plot("side_flow", "supply_flow", x=CLEARANCES)
    assert [line.get_xdata().tolist() for line in axes.get_lines()] == [CLEARANCES.tolist()] * 2
    assert axes.get_ylabel() == "L/min"
    assert films.plot("film", ax=axes) is axes and len(axes.get_lines()) == 3


@pytest.mark.parametrize(
    "names, x, words",
    [
        (["films"], "", 'films: is not known; did you mean "film"?'),
        (["film"], "clearence", 'did you mean "clearance"?'),
        (["film", "friction_power"], "", "friction_power: is in W, film in µm"),
    ],
)
def test_what_cannot_be_drawn_is_said(films, names, x, words):
    with pytest.raises(BadInput) as bad:
        films.plot(*names, x=x)
    assert words in str(bad.value)


def test_one_point_makes_no_curve(gamma_results: Results):
    with pytest.raises(BadInput, match="one point, which makes no curve"):
        gamma_results.bearings.solution.plot()
    with pytest.raises(BadInput, match="there is no figure"):
        gamma_results.mounting.plot()


def test_an_outcome_draws_its_curves(gamma_results: Results):
    first, *_ = gamma_results.bearings.curves
    axes = gamma_results.bearings.plot()
    assert axes.get_title() == str(first.title)
    assert [line.get_ydata().tolist() for line in axes.get_lines()[: len(first.series)]] == [
        series.y.tolist() for series in first.series
    ]
    later = next(
        c.id for c in gamma_results.bearings.whole.curves if c.id not in {c.id for c in gamma_results.bearings.curves}
    )
    assert gamma_results.bearings.plot(later).has_data()
    assert gamma_results.plot("locus").get_title() == gamma_results.imbalance.plot().get_title()
    with pytest.raises(BadInput, match="known here are film_front"):
        gamma_results.bearings.plot("x")


@pytest.mark.parametrize("step", ["engine", "imbalance", "countershaft", "bearings", "gears", "friction"])
def test_every_curve_can_be_drawn(gamma_results: Results, step):
    from matplotlib import pyplot

    curves = getattr(gamma_results, step).curves
    axes = pyplot.figure().subplots(1, len(curves))
    for curve, ax in zip(curves, axes):
        assert curve.plot(ax).has_data()
        drawn = len(ax.get_lines()) if not curve.bars else len(ax.containers)
        assert drawn >= len(curve.series)
        assert len(ax.texts) == 2 * len(curve.loads)


def test_a_bar_with_a_name_lies_and_a_load_is_an_arrow():
    words, one = Text("a"), np.array([1.0, 2.0])
    bars = Curve(
        "b", words, words, Text("P, W"), (Series(words, one, np.array([3.0, 5.0])),), bars=True, names=(words, words)
    )
    axes = bars.plot()
    assert [bar.get_width() for bar in axes.patches] == [3.0, 5.0] and axes.get_xlabel() == "P, W"
    loads = Curve(
        "l",
        words,
        words,
        words,
        (Series(words, one, one),),
        loads=(DrawnLoad(words, 1.0, 2.0), DrawnLoad(words, 2.0, 1.0, held=True)),
        load_unit="N",
    )
    assert [text.get_text() for text in loads.plot().texts] == ["", "a 2 N", "", "a 1 N"]
