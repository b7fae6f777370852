# SPDX-License-Identifier: Apache-2.0
"""Curves and tables of rolling bearings, made when somebody looks: what each part of the duty costs of loss and life,
what other formulas give, the load that keeps the elements rolling, the clearance over the temperature."""

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ...countershaft.rows import called
from ...sheet.arrays import Array
from ...sheet.step import Curve, Series, Table, axis_label
from ...sheet.text import Name, Text
from .clearance import FieldPoint
from .solve import FASTEST, least_loads

if TYPE_CHECKING:
    from .bearing import RollingBearing

Results = Mapping[str, "RollingBearing"]

POINTS = 23
SLOWEST = 0.2  # of the rated speed
WARMER = 20.0  # K above the bearing: where the curve of the clearance ends


def tables(results: Results) -> Iterator[Table]:
    if any(r.duty for r in results.values()):
        yield duty_table(results)
    yield formulas_table(results)


def duty_table(results: Results) -> Table:
    """Each part of the duty: what it loses, and what it takes of the life."""
    rows = []
    for place, r in results.items():
        assert r.rows is not None
        damage = _damage(r)
        for i, (name, part) in enumerate(r.duty.items()):
            rows.append(
                (
                    called(place),
                    Name(name),
                    _digits(r.rows.n[i] * 60),
                    _digits(100 * r.rows.share[i]),
                    _digits(part.loss),
                    _digits(part.equivalent_load),
                    _digits(part.viscosity_ratio),
                    None if part.life_factor is None else _digits(part.life_factor),
                    None if damage is None else _digits(100 * damage[i]),
                )
            )
    columns = (
        (Text("bearing"), ""),
        (Text("part"), ""),
        (Text("n"), "rpm"),
        (Text("hours"), "%"),
        (Text("P_f"), "W"),
        (Text("P"), "N"),
        (Text("κ"), ""),
        (Text("a_ISO"), ""),
        (Text("of the damage"), "%"),
    )
    note = Text("n: of the shaft. Damage: the share of the life that this part uses up (Palmgren and Miner).")
    return Table("rolling_duty", Text("Rolling bearings over their duty"), columns, tuple(rows), note, short=True)


def _damage(r: "RollingBearing") -> Array | None:
    """Of each part of the duty its share of what ends the life; None where nothing loads the bearing."""
    assert r.rows is not None
    each = [
        0.0 if part.life_basic is None or part.life_factor is None else 1 / (part.life_basic * part.life_factor)
        for part in r.duty.values()
    ]
    used = r.rows.share * np.array(each)
    return None if not used.any() else used / used.sum()


def formulas_table(results: Results) -> Table:
    """Ratings as given beside those of the standards, the torque that is judged beside other formulas."""
    rows: list[tuple[Any, ...]] = []
    for place, r in results.items():
        computed, own = r.case.computed, r.case.ratings
        by_rule = r.case.friction.by_rule(r.friction_load)
        rows.append(
            (
                called(place),
                Name(r.case.size.designation),
                _digits(own.dynamic / 1e3),
                None if computed is None else _digits(computed.dynamic / 1e3),
                _digits(own.static / 1e3),
                None if computed is None else _digits(computed.static / 1e3),
                *(_digits(1e3 * M) for M in (r.torque, r.torque_two_part, r.torque_palmgren or 0.0, by_rule)),
            )
        )
    columns = (
        (Text("bearing"), ""),
        (Text("size"), ""),
        (Text("C_r, judged"), "kN"),
        (Text("C_r, ISO 281"), "kN"),
        (Text("C_0, judged"), "kN"),
        (Text("C_0, ISO 76"), "kN"),
        (Text("M, judged"), "N·mm"),
        (Text("M, two parts"), "N·mm"),
        (Text("M, Palmgren"), "N·mm"),
        (Text("M, μ·P·d/2"), "N·mm"),
    )
    note = Text(
        "Ratings of the standards stand on a typical inside: an estimate; a catalogue's rule where they are given. "
        "Torques at rated speed: balls and cylindrical rollers are judged by SKF's model, needles by INA's two parts; "
        "Palmgren's factors are of 1957."
    )
    return Table("rolling_formulas", Text("Rolling bearings by other formulas"), columns, tuple(rows), note)


def _digits(x: float) -> float:
    return float(f"{float(x):.4g}")


def curves(results: Results) -> Iterator[Curve]:
    yield _over_speed(results)
    clearances = [curve for place, r in results.items() for curve in _over_temperature(place, r)]
    if clearances:
        yield _of_clearance(results, clearances)


def _over_speed(results: Results) -> Curve:
    """The load and what it has to be at least, whole and dashed."""
    loads, least = [], []
    for place, r in results.items():
        n = np.linspace(SLOWEST, FASTEST, POINTS) * r.speed
        there, asked = least_loads(r.case, r.load * (n / r.speed) ** 2, r.stands.weight, n, r.supply_temperature)
        loads.append(Series(Text("load, {place}", place=called(place)), n * 60, np.log10(there)))
        needed = Text("least load, {place}", place=called(place))
        least.append(Series(needed, n * 60, np.log10(asked + 0.0 * n), dashed=True))
    return Curve(
        "rolling_least_load",
        Text("Load of the rolling bearings over speed, and the least with which they roll"),
        axis_label("speed of the shaft", "rpm"),
        Text("lg F, N"),
        (*loads, *least),
        short=6,
    )


def _over_temperature(place: str, r: "RollingBearing") -> Iterator[Series]:
    if r.case.mounting is None or r.gap is None or r.gap.running is None:
        return
    inputs = r.case.inputs
    T = np.linspace(inputs.lowest_temperature, r.running_temperature + WARMER, POINTS)
    ends: tuple[tuple[FieldPoint, Text, bool], ...] = (
        ("middle", Text("{place}", place=called(place)), False),
        ("least", Text("least, {place}", place=called(place)), True),
    )
    for end, label, dashed in ends:
        gap = [r.case.mounting.clearance(float(t), inputs.ring_temperature, end) for t in T]
        yield Series(label, T, np.array(gap) * 1e6, dashed=dashed)


def _of_clearance(results: Results, series: list[Series]) -> Curve:
    first = next(r for r in results.values() if r.gap is not None and r.gap.running is not None)
    ordered = sorted(series, key=lambda one: one.dashed)
    return Curve(
        "rolling_clearance",
        Text("Clearance of the rolling bearings over their temperature, inner ring warmer"),
        axis_label("temperature of the bearing", "°C"),
        axis_label("s", "µm"),
        tuple(ordered),
        limits=((Text("no clearance"), 0.0),),
        point=(first.running_temperature, (first.clearance_running or 0.0) * 1e6),
        short=7,
    )
