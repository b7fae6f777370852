# SPDX-License-Identifier: Apache-2.0
"""What a step has to draw: curves with labels and limits, as data.  Terminal and paper draw the same object; in a
notebook or a script it draws itself with matplotlib, which is loaded only then."""

import cmath
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from .arrays import Array
from .record import record, replace
from .text import EMPTY, Amount, Name, Text

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def said_of(name: str, words: Text) -> Text:
    """What is said of one of several shafts."""
    return Text("{name}: {words}", name=Name(name), words=words)


def axis_label(label: str, unit: str) -> Text:
    """The label of an axis: what runs along it, and its unit behind a comma."""
    return Text("{quantity}, {unit}", quantity=Text(label), unit=unit)


@record
class Series:
    """One line of a curve, in shown units.  `variant`: the one of the curve's variants that it belongs to; empty: all
    of them.  `dashed`: it is told from whole lines by that, and those that are have in turn the same colours."""

    label: Text
    x: Array  # (points,)
    y: Array  # (points,)
    variant: Text = EMPTY
    dashed: bool = False


def line_of(series: Sequence[Series], n: int) -> int:
    """Which of the colours the n-th of them has: the whole ones have theirs in turn, and so have the dashed ones."""
    if n >= len(series):
        return n
    return sum(other.dashed == series[n].dashed for other in series[:n])


@record
class Turning:
    """Vectors set tip to tail, each turning at `orders` times the crank's speed (negative: backward).  Their end runs
    along a locus.

    Real is up, imaginary is to the right: 90° further in the sense of crank rotation.
    """

    names: tuple[Text, ...]
    phasors: tuple[complex, ...]
    orders: tuple[int, ...]
    variant: Text = EMPTY

    def at(self, theta: float) -> list[complex]:
        """Origin, tips and end of the chain at a crank angle [rad]."""
        points = [0j]
        for phasor, order in zip(self.phasors, self.orders):
            points.append(points[-1] + phasor * cmath.exp(1j * order * theta))
        return points


@record
class DrawnLoad:
    """A force across what a curve draws, up where it is above nought; `held`: by a support, which pushes, where others
    pull."""

    label: Text
    x: float
    size: float
    held: bool = False


@record
class MeasuredPoints:
    """What was measured on a curve: points with one standard uncertainty either way (NaN: none is given), and what lies
    below them in a strip: the curve less the point (NaN: the curve is not known there)."""

    label: Text
    x: Array  # (points,)
    y: Array
    bar: Array
    residual: Array


@record
class Walk:
    """A curve that the session shows at other points too, made when it goes there.

    `at`: the curve at one of `steps` along the way and in one of `rows`; `here`: the step and the row of the curve that
    has the walk.  Curves of one `stack` are walked together."""

    at: Callable[[int, int], "Curve"]
    steps: int
    rows: int
    here: tuple[int, int]


@record
class Curve:
    """Data with labels and limit lines; terminal and paper draw the same object.

    `equal`: both axes in true scale.  `bars`: the series are groups of bars at their x; with `names` the groups at 1,
    2, … have these, and paper lays them on their side.  `variants`: the terminal shows one of them at a time, paper
    all.  `turning`: the vectors whose ends draw the loci. `point`: where the design stands on it, and `fails`: whether
    it is on the wrong side of a limit there. `band`: its last two series are the edges of a band, which paper fills.
    `stack`: curves of one stack stand on paper over each other as one figure, along one x. `loads`: forces across it,
    which paper draws as arrows; `load_unit`: what they are in. `short`: its place among the figures of a short report,
    from 1; of those with one place the first of the step stands. `along`: what all series run along, where it is not x,
    as of loci: its label and its value at each of their points. `walk`: the same at other points. `measured`: points of
    a bench on it."""

    id: str
    title: Text
    x_label: Text
    y_label: Text
    series: tuple[Series, ...]
    limits: tuple[tuple[Text, float], ...] = ()
    equal: bool = False
    bars: bool = False
    names: tuple[Text, ...] = ()
    variants: tuple[Text, ...] = ()
    turning: tuple[Turning, ...] = ()
    along: tuple[Text, Array] | None = None
    point: tuple[float, float] | None = None
    fails: bool = False
    band: bool = False
    stack: str = ""
    loads: tuple[DrawnLoad, ...] = ()
    load_unit: str = ""
    short: int = 0
    walk: Walk | None = None
    measured: MeasuredPoints | None = None

    def of_one(self, name: str) -> "Curve":
        """The same as that of one of several shafts."""
        stack = f"{name}.{self.stack}" if self.stack else ""
        return replace(self, id=f"{name}.{self.id}", title=said_of(name, self.title), stack=stack)

    def plot(self, ax: "Axes | None" = None) -> "Axes":
        """Draws it with matplotlib, in the units that its axes say: on `ax`, or on a figure of its own.  Returns the
        axes."""
        if ax is None:
            from matplotlib import pyplot

            ax = pyplot.subplots(layout="constrained")[1]
        draw(self, ax)
        return ax


# --- with matplotlib

WIDTH = 0.8  # of a group of bars
GREY, RED = "0.45", "tab:red"
ARROW = {"arrowstyle": "-|>", "color": GREY}
LONGEST = 0.25  # of the height: the arrow of the largest force


def draw(curve: Curve, ax: "Axes") -> None:
    """A curve on axes of matplotlib: its series, limits, point, vectors and forces."""
    if curve.bars:
        _bars(curve, ax)
    else:
        _lines(curve, ax)
    lies = bool(curve.bars and curve.names)
    for words, limit in curve.limits:
        (ax.axvline if lies else ax.axhline)(limit, color=GREY, linestyle=":", label=str(words))
    for turning in curve.turning:
        ends = turning.at(0.0)
        ax.plot([end.imag for end in ends], [end.real for end in ends], "o-", color=GREY, markersize=3)
    if curve.point is not None:
        ax.plot(*curve.point, "o", color=RED if curve.fails else "black")
    _forces(curve, ax)
    if (points := curve.measured) is not None:
        ax.errorbar(points.x, points.y, points.bar, fmt="o", color="black", markersize=3, label=str(points.label))
    if curve.equal:
        ax.set_aspect("equal", adjustable="datalim")
    ax.set_title(str(curve.title), wrap=True)
    ax.set(xlabel=str(curve.y_label)) if lies else ax.set(xlabel=str(curve.x_label), ylabel=str(curve.y_label))
    if any(not label.startswith("_") for label in ax.get_legend_handles_labels()[1]):
        ax.legend()


def _label(curve: Curve, series: Series) -> str:
    """What the legend says of it; of a curve with variants its variant first, an underscore for nothing."""
    return ": ".join(str(words) for words in (series.variant, series.label) if words) or "_"


def _lines(curve: Curve, ax: "Axes") -> None:
    edges = curve.series[-2:] if curve.band else ()
    for series in curve.series:
        style = "--" if series.dashed else "-"
        ax.plot(series.x, series.y, style, marker="." if len(series.x) == 1 else "", label=_label(curve, series))
    if edges:
        low, high = edges
        ax.fill_between(low.x, low.y, high.y, color=GREY, alpha=0.2)


def _bars(curve: Curve, ax: "Axes") -> None:
    """Groups of bars; with names they lie on their side, the first on top."""
    thick = WIDTH / len(curve.series)
    for n, series in enumerate(curve.series):
        place = series.x + (n + 0.5) * thick - WIDTH / 2
        (ax.barh if curve.names else ax.bar)(place, series.y, thick, label=_label(curve, series))
    if curve.names:
        ax.set_yticks(range(1, len(curve.names) + 1), [str(name) for name in curve.names])
        ax.invert_yaxis()


def _forces(curve: Curve, ax: "Axes") -> None:
    """Each an arrow across what the curve draws, with its size."""
    largest = max((abs(load.size) for load in curve.loads), default=0.0)
    if not largest:
        return
    low, high = ax.get_ylim()
    for load in curve.loads:
        length = LONGEST * (high - low) * load.size / largest
        tail, tip = (-length, 0.0) if load.held else (0.0, length)
        ax.annotate("", (load.x, tip), (load.x, tail), arrowprops=ARROW)
        words = f"{load.label} {Amount(load.size, curve.load_unit)}"
        ax.annotate(words, (load.x, tail if load.held else tip), color=GREY, fontsize="small")
