# SPDX-License-Identifier: Apache-2.0
"""A seat over temperature: bore, journal, clearance and the pressure of its fit, as a table and as curves."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ....countershaft.rows import called
from ....sheet.arrays import Array
from ....sheet.record import replace
from ....sheet.step import Curve, Series, Table, axis_label
from ....sheet.text import EMPTY, Amount, Text
from ....sheet.units import Celsius, Metre
from ....sheet.value import unlinked, untraced
from . import formulas as f
from .rings import Rings
from .tables import LEAST, MIDDLE, MOST, ends_of, size

if TYPE_CHECKING:
    from ..result import PlainResult
    from ..routes.states import BearingCase

OVER = np.linspace(-40.0, 160.0, 101)  # °C, of the curves


class Warm(NamedTuple):
    """A seat at temperatures, all arrays of one shape.  `press`: of the least interference; None: nothing is pressed
    in."""

    bore: Any
    journal: Any
    clearance: Any
    press: Any


def warm(seat: "BearingCase[Any]", T: Any, T_H: Any) -> Warm:
    """`T`: of journal and bush, `T_H`: of the housing."""
    seat = replace(unlinked(seat), inputs=replace(unlinked(seat.inputs), housing_temperature=T_H))
    d_J, rings = seat.bearing.diameter, seat.rings
    if seat.stack is not None:
        d_J = sum(seat.stack.journal) / 2
    with untraced():
        g = seat.running_clearance(T)
        d_JT = d_J * (1 + seat.journal_expansion * (T - seat.inputs.clearance_reference_temperature))
        p = None
        if rings is not None:
            p = rings.at(rings.fit(seat.bearing.diameter, seat.clearance), rings.interference[0], T, T_H).p
    return Warm(d_JT + g, d_JT, g, p)


def tells(seat: "BearingCase[Any]") -> bool:
    """Whether anything is known of the seat beside its clearance."""
    return seat.stack is not None or seat.rings is not None


def warm_table(place: str, r: "PlainResult", told: tuple[Celsius, ...]) -> Iterator[Table]:
    """At temperatures that all parts have (`told`), as supplied, at the film's mean and at the limit of the outlet."""
    if not tells(r.seat):
        return
    inputs, housing = r.seat.inputs, r.seat.inputs.housing_temperature
    states = [(Text("all parts"), T, T) for T in told]
    for name, T in (
        (Text("oil as supplied"), inputs.supply_temperature),
        (Text("film, mean"), r.hot.mean_temperature),
        (Text("limit of the outlet"), inputs.outlet_temperature_limit),
    ):
        states.append((name, float(T), float(T if housing is None else housing)))
    pressed = r.seat.rings is not None
    rows = []
    for name, T, T_H in states:
        there = warm(r.seat, T, T_H)
        cells = (size(there.bore), size(there.journal), there.clearance * 1e6)
        rows.append((name, T, *cells, there.press / 1e6) if pressed else (name, T, *cells))
    columns = (
        (Text("state"), ""),
        (Text("T"), "°C"),
        (Text("bore"), "mm"),
        (Text("journal"), "mm"),
        (Text("clearance"), "µm"),
    )
    note = EMPTY if not pressed else Text("Pressure with the least interference.")
    if housing is not None and pressed:
        at = Amount(housing, "°C", form="g")
        note = Text("{note} Once oil is supplied the housing is at {T}.", note=note, T=at)
    yield Table(
        f"over_temperature_{place}",
        Text("Over temperature, {place} bearing", place=called(place)),
        (*columns, (Text("pressure"), "MPa")) if pressed else columns,
        tuple(rows),
        note,
    )


# --- curves


def seat_curves(place: str, r: "PlainResult") -> Iterator[Curve]:
    """The clearance over temperature, all parts alike, and below it the pressure of the fit; where that comes loose is
    marked."""
    if not tells(r.seat):
        return
    seat, rings, where = r.seat, r.seat.rings, {"place": called(place)}
    T, stack = axis_label("temperature", "°C"), f"seat_{place}"
    series = [Series(MIDDLE, OVER, _clearance(seat))]
    ends = []
    if seat.stack is not None:
        for label, end in zip((LEAST, MOST), ends_of(seat)):
            ends.append(Series(label, OVER, _clearance(replace(seat, clearance=end))))
    title = Text("Clearance of the {place} bearing over temperature, all parts alike", **where)
    if rings is not None:
        title = Text("Clearance and press of the {place} bearing over temperature, all parts alike", **where)
        series += _loose(seat, rings, rings.middle, Text("middle loose from {T}"), [*series, *ends])
    yield Curve(
        f"clearance_over_temperature_{place}",
        title,
        T,
        axis_label("g", "µm"),
        (*series, *ends),
        band=seat.stack is not None,
        stack=stack if rings is not None else "",
        short=2 if rings is not None else 4,
    )
    if rings is None or r.seat_ is None:
        return
    fit, (least, most) = rings.fit(seat.bearing.diameter, seat.clearance), rings.interference
    with untraced():
        lines = [
            Series(label, OVER, rings.at(fit, delta, OVER, OVER).p / 1e6)
            for label, delta in ((Text("least interference"), least), (Text("most interference"), most))
        ]
    yield Curve(
        f"press_over_temperature_{place}",
        Text("Pressure of the fit of the {place} bearing over temperature, all parts alike", **where),
        T,
        axis_label("p", "MPa"),
        (*lines, *_loose(seat, rings, least, Text("least loose from {T}"), lines)),
        limits=((Text("shut under the load"), r.seat_.press_needed / 1e6),),
        stack=stack,
        short=3,
    )


def _clearance(seat: "BearingCase[Any]") -> Array:
    return np.asarray(warm(seat, OVER, OVER).clearance) * 1e6


def _loose(seat: "BearingCase[Any]", rings: Rings, delta: Metre, label: Text, lines: list[Series]) -> Iterator[Series]:
    """An upright where this interference is used up, as high as the lines reach; nothing where it is outside them."""
    if rings.housing.expansion * (1 - rings.restraint) <= rings.backing.expansion:
        return
    with untraced():
        T = f.loose_at(
            T_ref=rings.reference,
            delta=delta,
            d_o=rings.fit(seat.bearing.diameter, seat.clearance).d_o,
            alpha_H=rings.housing.expansion,
            chi=rings.restraint,
            alpha_B=rings.backing.expansion,
        )
    if OVER[0] <= T <= OVER[-1]:
        heights = np.concatenate([line.y for line in lines])
        words = Text(label.template, T=Amount(float(T), "°C", form=".0f"))
        yield Series(words, np.array([T, T]), np.array([heights.min(), heights.max()]))
