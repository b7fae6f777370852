# SPDX-License-Identifier: Apache-2.0
"""Plain and rolling bearings for one shaft side by side: what each set loses, costs in fuel, weighs, lasts and risks.

Made when somebody looks.  The loads are those of the design as it is; each set is solved as it would stand there, with
all its checks."""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any

import numpy as np

from ..countershaft.rows import BearingRow
from ..sheet.check import Check
from ..sheet.deferred import Later
from ..sheet.errors import NoSolution
from ..sheet.record import record
from ..sheet.step import Curve, Further, Series, Table, axis_label
from ..sheet.text import COMMA, EMPTY, SEMICOLON, SPACE, Amount, Name, Text
from ..sheet.units import Celsius, Metre, Number, RevPerSecond, Watt
from ..sheet.value import untraced
from .inputs import BearingsInputs
from .kinds import KINDS
from .lives import life_together
from .rolling.search import Candidate, Place, candidates, seated
from .rolling.solve import Rows, rows_of
from .support import Carrying

TITLE = Text("Plain and rolling for this shaft")
ROOM: Celsius = 20.0  # °C: no colder oil is compared
FASTEST: Number = 1.1  # of the rated speed
POINTS = 23  # of a curve
PUMP: Number = 0.5  # efficiency of an oil pump; rule of this program
RISKS = 3  # of a set that are named
TYPES = {
    "ball": Text("ball"),
    "roller": Text("roller"),
    "needle": Text("needle"),
    "cup": Text("drawn cup"),
    "cage": Text("needle cage"),
}
GRAM_PER_HOUR = 1e-3 / 3600


@record
class Costs:
    """What watts cost, as the friction step has it: `fuel` of them, kg/s, and `co2` of that; None where it is not
    given."""

    rated_power: Watt | None = None
    fuel: Callable[[Watt], float] | None = None
    co2: Callable[[float], float] = float


@record
class ComparisonCase:
    """One shaft as its bearings are compared.  `idle`: the speed of the shaft, 1/s, `assumed`: nobody gives it."""

    places: Mapping[str, Place]
    now: Mapping[str, Carrying]
    checks: tuple[Check, ...]  # of the design's bearings
    idle: RevPerSecond
    assumed: bool
    costs: Costs
    seat_asked: Metre = 0.0  # of the largest seat: the sectors have to pass it

    @property
    def mixed(self) -> bool:
        """Whether the design has bearings of another kind than plain ones: then a short report shows all of this."""
        return any(place.row.kind != "plain" for place in self.places.values())

    @property
    def first(self) -> Place:
        return next(iter(self.places.values()))

    @property
    def rated(self) -> RevPerSecond:
        return self.first.task.speed

    @property
    def rows(self) -> Rows | None:
        """The duty."""
        return rows_of(self.first.inputs, self.first.task)

    @property
    def hot(self) -> Celsius:
        return self.first.inputs.supply_temperature

    @property
    def cold(self) -> Celsius:
        return min(max(self.first.inputs.lowest_temperature, ROOM), self.hot)


@record
class BearingSet:
    """Bearings for all places of the shaft, as they are called together."""

    name: Text
    bearings: Mapping[str, Carrying]
    checks: tuple[Check, ...]

    @property
    def film(self) -> bool:
        """Whether none of them fatigues."""
        return all(r.survival() is None for r in self.bearings.values())

    def loss(self, case: ComparisonCase, n: Any, T: Any, factor: Any = 1.0, extra: Any = 0.0) -> Any:
        """Of all of them at n, 1/s, with oil of T, °C; nan where there is no film.  `factor`: on the load that turns;
        `extra`: of the load that stands, N."""
        ratio = np.asarray(n, dtype=float) / case.rated
        T = np.broadcast_to(np.asarray(T, dtype=float), ratio.shape)
        with untraced(), np.errstate(all="ignore"):
            answers = {place: r.answer_at(ratio, T, None, factor) for place, r in self.bearings.items()}
            return sum(answer.under(case.places[place].stands.all + extra) for place, answer in answers.items())

    def losses(self, case: ComparisonCase) -> "SetLosses":
        n, T = np.array([case.rated, case.rated, case.idle, case.idle]), np.array([case.hot, case.cold] * 2)
        rows = case.rows
        if rows is None:
            P = self.loss(case, n, T)
            return SetLosses(tuple(P.tolist()), float(P[0]))
        factor, extra = np.append(np.ones(len(n)), rows.factor), np.append(np.zeros(len(n)), rows.extra)
        P = self.loss(case, np.append(n, rows.n), np.append(T, rows.T_oil), factor, extra)
        return SetLosses(tuple(P[: len(n)].tolist()), float(np.sum(rows.share * P[len(n) :])))


@record
class SetLosses:
    """Of a set, W.  `at`: rated speed hot and cold, idle hot and cold; `mean`: over the duty, else at rated speed."""

    at: tuple[Watt, ...]
    mean: Watt


Compared = list[tuple[BearingSet, SetLosses]]


def further(case: ComparisonCase, plain: "Iterable[tuple[BearingsInputs, Mapping[str, BearingRow]]]") -> Further:
    """The table, its costs and its figure.  `plain`: the best journals of the search, where there are any."""
    sets = [BearingSet(Text("as designed"), case.now, case.checks), *_plain(case, plain)]
    rolling, none = _rolling(case)
    sets += rolling
    compared = [(one, one.losses(case)) for one in sets]
    return Further(
        curves=Later(lambda: [_curve(case, compared)]), tables=(_table(case, compared, none), _costs(case, compared))
    )


# --- the sets


def carried(place: Place, row: BearingRow, inputs: BearingsInputs) -> tuple[Carrying, list[Check]]:
    """A bearing of any kind in a place, solved and judged with what stands there."""
    with untraced():
        support = KINDS[row.kind].support(row, inputs, place.solids, place.load, place.task)
        solved = support.solved(place.load, place.slope, None, place.task)
        return solved.under(place.stands, [*solved.checks()], [])


def _set(
    name: Text, case: ComparisonCase, rows: Mapping[str, BearingRow], inputs: BearingsInputs | None = None
) -> BearingSet:
    bearings, checks = {}, list[Check]()
    for place, row in rows.items():
        of_row = case.places[place].inputs if inputs is None else inputs.of(row)
        bearings[place], mine = carried(case.places[place], row, of_row)
        checks += mine
    return BearingSet(name, bearings, tuple(checks))


def _plain(
    case: ComparisonCase, plain: Iterable[tuple[BearingsInputs, Mapping[str, BearingRow]]]
) -> Iterator[BearingSet]:
    for inputs, rows in plain:
        try:
            yield _set(Text("plain, the least loss"), case, rows, inputs)
        except NoSolution:
            continue


def _rolling(case: ComparisonCase) -> tuple[list[BearingSet], list[Text]]:
    """Of each type the set with the least loss that passes and sits, where the one that locates the shaft can not be of
    it that of another; and of which types there is none."""
    every = {place: candidates(it) for place, it in case.places.items()}
    sets, none = list[BearingSet](), list[Text]()
    for type, word in TYPES.items():
        rows, of_type = dict[str, BearingRow](), False
        for place, those in every.items():
            mine = [one for one in those if one.size.type == type]
            found = _first(case.places[place], mine) or (None if mine else _first(case.places[place], those))
            if found is None:
                break
            rows[place] = found
            of_type |= bool(mine)
        if len(rows) == len(every) and of_type:
            try:
                sets.append(_set(word, case, rows))
                continue
            except NoSolution:
                pass
        if any(one.size.type == type for those in every.values() for one in those):
            none.append(word)
    return sets, none


def _first(place: Place, those: list[Candidate]) -> BearingRow | None:
    found, _ = seated(place, those, 1)
    return found[0].row if found else None


# --- shown


def _table(case: ComparisonCase, sets: Compared, none: list[Text]) -> Table:
    columns = [
        (Text("bearings"), ""),
        (Text("sizes"), ""),
        (Text("rated, hot"), "W"),
        (Text("rated, cold"), "W"),
        (Text("idle, hot"), "W"),
        (Text("idle, cold"), "W"),
        *([(Text("duty"), "W")] if case.rows is not None else []),
        (Text("life"), "h"),
        (Text("seat"), "mm"),
        (Text("mass"), "kg"),
        (Text("pressure oil"), "L/min"),
    ]
    rows = []
    for one, losses in sets:
        life = life_together(one.bearings.values())
        rows.append(
            (
                one.name,
                _sizes(one),
                *map(_three, losses.at),
                *([_three(losses.mean)] if case.rows is not None else []),
                Text("by film") if life is None else float(f"{life / 3600:.3g}"),
                max(r.seat_size() for r in one.bearings.values()) * 1e3,
                float(f"{sum(r.mass() for r in one.bearings.values()):.3g}"),
                float(f"{sum(r.oil_flow for r in one.bearings.values()) * 60e3:.3g}"),
            )
        )
    speeds = Amount(case.rated * 60, form=".0f"), Amount(case.idle * 60, form=".0f")
    note = Text(
        "Shaft at {rated} rpm, idle {idle} rpm{assumed}; oil {hot}, cold {cold}. The loads are those of the design as "
        "it is. Seat: the largest. Life: of all together.",
        rated=speeds[0],
        idle=speeds[1],
        assumed=Text(", assumed") if case.assumed else EMPTY,
        hot=Amount(case.hot, "°C"),
        cold=Amount(case.cold, "°C"),
    )
    if none:
        note = SPACE.join([note, Text("None passes and sits of: {types}.", types=COMMA.join(none))])
    return Table("plain_and_rolling", TITLE, tuple(columns), tuple(rows), note, short=True)


def _costs(case: ComparisonCase, sets: Compared) -> Table:
    """Fuel and what it burns to, at the mean loss of the duty; and the checks that are open."""
    costs, rows = case.costs, []
    km = _metres_per_second(case.rows)
    for one, losses in sets:
        cells: list[Any] = [one.name, _three(sum(r.pumped() for r in one.bearings.values()) / PUMP)]
        if costs.fuel is not None:
            with untraced():
                m_B, rated = costs.fuel(losses.mean), costs.fuel(losses.at[0])
                m_CO2 = costs.co2(m_B)
            cells += [_three(m_B / GRAM_PER_HOUR), _three(m_CO2 / GRAM_PER_HOUR)]
            if costs.rated_power is not None:
                cells.append(_three(rated / costs.rated_power * 3.6e9))
            if km is not None:
                cells.append(_three(m_CO2 / km * 1e6))
        rows.append((*cells, _risks(case, one)))
    columns = [(Text("bearings"), ""), (Text("oil pump"), "W")]
    if costs.fuel is not None:
        columns += [(Text("fuel"), "g/h"), (Text("CO₂"), "g/h")]
        columns += [(Text("fuel over rated power"), "g/kWh")] if costs.rated_power is not None else []
        columns += [(Text("CO₂ of the road"), "g/km")] if km is not None else []
    title = Text("What plain and rolling cost, and risk")
    note = Text("Oil pump: flow × pressure over an efficiency of {eta}, not in the losses.", eta=Amount(PUMP))
    if costs.fuel is not None:
        of = Text("Fuel and CO₂ of the mean loss over the duty.")
        of = of if case.rows is not None else Text("Fuel and CO₂ of the loss at rated speed, hot.")
        note = SPACE.join((of, note))
    columns.append((Text("open checks"), ""))
    return Table("plain_and_rolling_costs", title, tuple(columns), tuple(rows), note, short=case.mixed)


def _metres_per_second(rows: Rows | None) -> float | None:
    """The mean road speed, where every part of the duty has one."""
    if rows is None or None in rows.road:
        return None
    mean = float(np.sum(rows.share * np.array(rows.road, dtype=float)))
    return mean or None


def _sizes(one: BearingSet) -> Text:
    return COMMA.join(dict.fromkeys(_size(r) for r in one.bearings.values()))


def _size(r: Carrying) -> Text:
    d, length = r.row.on_shaft or (0.0, 0.0)
    across, long = (Amount(x * 1e3, form="g") for x in (d, length))
    return Name(r.row.size) if r.row.size else Text("⌀{d}×{length}", d=across, length=long)


def _risks(case: ComparisonCase, one: BearingSet) -> Text:
    """What does not hold, each rule once, those that fail first; before them that the shaft does not come in."""
    open_ = [check for verdict in ("fail", "warn", "not_verified") for check in one.checks if check.verdict == verdict]
    names = [(check.rule.name or check.name, check.verdict) for check in open_]
    rules = list(dict.fromkeys(Text("fails: {name}", name=name) if how == "fail" else name for name, how in names))
    if max(r.row.opening() for r in one.bearings.values()) < case.seat_asked:
        asked = Amount(case.seat_asked * 1e3, "mm", digits=4)
        rules.insert(0, Text("threaded in, the sectors ask for a seat of {asked}", asked=asked))
    if not rules:
        return Text("none")
    words = SEMICOLON.join(rules[:RISKS])
    return words if len(rules) <= RISKS else Text("{words}; {n} more", words=words, n=len(rules) - RISKS)


def _three(x: float) -> float | None:
    """Three figures; none where a part of the duty has no film."""
    return float(f"{x:.3g}") if math.isfinite(x) else None


def _curve(case: ComparisonCase, sets: Compared) -> Curve:
    """The least loss of plain ones and of rolling ones over the speed, each at three temperatures of the oil."""
    shown = []
    for film in (True, False):
        alike = [(one, losses.mean) for one, losses in sets if one.film == film]
        designed = [one for one, _ in alike if one.bearings is case.now]
        shown += designed or [one for one, _ in sorted(alike, key=lambda pair: pair[1])[:1]]
    n = np.linspace(min(case.idle, case.rated), FASTEST * case.rated, POINTS)
    middle = 10.0 * round((case.hot + case.cold) / 20)
    temperatures = list(dict.fromkeys((case.cold, middle, case.hot)))
    series = []
    for one in shown:
        rolling = all(r.survival() is not None for r in one.bearings.values())
        word = Text("plain") if one.film else Text("rolling") if rolling else Text("mixed")
        losses = one.loss(case, np.tile(n, len(temperatures)), np.repeat(temperatures, POINTS))
        for T, P in zip(temperatures, np.split(losses, len(temperatures))):
            label = Text("{kind} {sizes}, {T}", kind=word, sizes=_sizes(one), T=Amount(T, "°C"))
            series.append(Series(label, n * 60, np.log10(np.where(P > 0, P, np.nan)), dashed=not one.film))
    return Curve(
        "plain_and_rolling_loss",
        Text("Loss of plain and of rolling bearings over speed and oil temperature"),
        axis_label("speed of the shaft", "rpm"),
        Text("lg P_f, W"),
        tuple(series),
        short=5 if case.mixed else 0,
    )
