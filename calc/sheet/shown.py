# SPDX-License-Identifier: Apache-2.0
"""How results show themselves from Python: as a table in a notebook, as a frame of pandas, as a plot of matplotlib.
Both are loaded when they are asked for."""

from collections.abc import Iterable, Sequence
from html import escape
from typing import TYPE_CHECKING, Any

from . import number
from .arrays import Array
from .curve import Curve, Series, axis_label
from .errors import BadInput, InputError
from .quantity import Published, published, unknown
from .text import EMPTY, Text
from .units import UNITS

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from pandas import DataFrame

Rows = Iterable[tuple[str, str, str]]  # (label, value, unit)
LEFT = "text-align: left; white-space: pre"
NO_PANDAS = "to_frame() needs pandas, which is not installed: pip install 'contralbero[pandas]', or pip install pandas"


class Shown:
    """What a class of results can do in a notebook or a script."""

    def _repr_html_(self) -> str:
        return html(type(self).__name__, number.rows(self))

    def to_frame(self) -> "DataFrame":
        """Its values in the units in which they are shown, as a frame of pandas.

        Of numbers: a row for each value by its name, with `value`, `unit` and `label`.  Of arrays: a column for each
        value, its unit behind its name as in a design file (`film_um`), and a row for each point."""
        return frame(published(self, ""))

    def plot(self, *names: str, x: "str | Array" = "", ax: "Axes | None" = None) -> "Axes":
        """Values of a result of arrays over another one of them, or over an array `x`, with matplotlib; the axes are
        returned.

        `names`: of values in one unit; left out: what stands for all of them.  `x`: left out, the number of the point.
        BadInput where there are no arrays, no such names, or names in different units."""
        return _curve(type(self).__name__, published(self, ""), names, x).plot(ax)


def html(title: str, rows: Rows, below: Sequence[object] = ()) -> str:
    """A table for a notebook, under its title; `below`: sentences under it."""
    left = f'<td style="{LEFT}">'
    lines = [
        f"<tr>{left}{escape(label)}</td><td>{escape(value)}</td>{left}{escape(unit)}</td></tr>"
        for label, value, unit in rows
    ]
    caption = f'<caption style="{LEFT}">{escape(title)}</caption>'
    return f"<table>{caption}{''.join(lines)}</table>" + "".join(f"<p>{escape(str(words))}</p>" for words in below)


def frame(values: Sequence[Published]) -> "DataFrame":
    """Values as a frame: of numbers a row each, of arrays a column each."""
    try:
        import pandas
    except ImportError:
        raise ImportError(NO_PANDAS) from None
    shapes = {v.shown.shape for v in values if getattr(v.shown, "ndim", 0)}  # type: ignore[attr-defined]
    if len(shapes) == 1:
        import numpy as np

        (shape,) = shapes
        columns = {f"{_name(v)}{UNITS[v.unit].suffix}": np.broadcast_to(v.shown, shape).ravel() for v in values}
        return pandas.DataFrame(columns)
    return pandas.DataFrame(
        {"value": [v.shown for v in values], "unit": [v.unit for v in values], "label": [str(v.label) for v in values]},
        index=pandas.Index([_name(v) for v in values], name="id"),
    )


def _name(value: Published) -> str:
    return value.id.removeprefix(".")


def _curve(kind: str, values: Sequence[Published], names: Sequence[str], x: Any) -> Curve:
    """The curve of some values of arrays."""
    many = {_name(v): v for v in values if getattr(v.shown, "ndim", 0)}
    if not many:
        reason = Text("has one point, which makes no curve: give the call arrays, or plot the outcome of a step")
        raise BadInput(f"{kind}.plot", [InputError(0, "", "", reason)])
    over = many.get(x) if isinstance(x, str) else None
    free = [name for name in many if not isinstance(x, str) or name != x]
    asked = names or (min(free, key=lambda name: many[name].headline or len(many)),)
    wrong = [name for name in (*asked, *([x] if isinstance(x, str) and x else [])) if name not in many]
    if wrong:
        raise BadInput(f"{kind}.plot", [InputError(0, name, "", unknown(name, list(many))) for name in wrong])
    drawn = [many[name] for name in asked]
    for v in drawn[1:]:
        if v.unit != drawn[0].unit:
            units = {"unit": v.unit or "1", "name": asked[0], "first": drawn[0].unit or "1"}
            reason = Text("is in {unit}, {name} in {first}: one axis has one unit", **units)
            raise BadInput(f"{kind}.plot", [InputError(0, _name(v), "", reason)])
    along: Any = over.shown if over is not None else x
    if isinstance(x, str) and not x:
        along = list(range(drawn[0].shown.size))  # type: ignore[attr-defined]
    alone = len(drawn) == 1
    return Curve(
        kind,
        EMPTY,
        _axis(over) if over is not None else EMPTY if not isinstance(x, str) else Text("point"),
        _axis(drawn[0]) if alone else Text("{unit}", unit=drawn[0].unit),
        tuple(Series(EMPTY if alone else v.label, along, v.shown) for v in drawn),  # type: ignore[arg-type]
    )


def _axis(value: Published) -> Text:
    return axis_label(value.label, value.unit) if value.unit else value.label


def figure(called: str, curves: Iterable[Curve], id: str) -> Curve:
    """The curve of this id among those of a step, or of all steps; of none: the first."""
    known: dict[str, Curve] = {}
    for curve in curves:
        if id in ("", curve.id):
            return curve
        known.setdefault(curve.id, curve)
    reason = unknown(id, list(known)) if known else Text("there is no figure")
    raise BadInput(called, [InputError(0, id, "", reason)])
