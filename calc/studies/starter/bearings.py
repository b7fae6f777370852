# SPDX-License-Identifier: Apache-2.0
"""Which bearings a shaft begins with: plain ones; rolling ones where no plain ones are found that keep every limit, or
where these together lose more than a hundredth of the rated power, and rolling ones less with nothing to be said of
them; or those of the kinds with which the engine is built."""

from collections.abc import Callable, Sequence

from ...bearings.result import BearingsResult
from ...bearings.support import Carrying
from ...design.model import Design
from ...design.step_inputs import on_rolling_instead, twins_of
from ...design.toml_file import Document, design
from ...engine.inputs import EngineInputs
from ...engine.result import EngineResult
from ...sheet.errors import NoSolution
from ...sheet.record import record
from ...sheet.text import EMPTY, SEMICOLON, Amount, Text
from ...sheet.units import Number, Watt
from ...solve import Results, solve
from . import journals, rolling, several
from .rolling import PLAIN, ROLLING
from .writing import Section, completed, parted

SHARE: Number = 0.01  # of the rated power
MEAN_PRESSURE = {4: 10e5, 2: 6e5}  # Pa, of an engine whose power is not given; by its strokes, rule of this program
BEARINGS = Text("bearings to begin with, plain and rolling")
BY_RULE = (ROLLING, ROLLING)
GIVE = Text("other bearings, a thicker core, a slower shaft")


@record
class OnBearings:
    """A design with its bearings: its document, and the tables of its shafts and of what all bearings share.

    `plain`: of plain bearings of one shaft what `journals.bearings` gives; `open`: how many cautions are."""

    document: Document
    sections: list[Section]
    plain: list[Section]
    open: int = 0


@record
class Unborne:
    """A design whose shafts have no bearings yet, and their tables."""

    document: Document
    results: Results
    shafts: list[Section]


class NoBearings(NoSolution):
    """No bearings are found, for shafts that are."""


Shafts = Callable[[tuple[str, ...]], Unborne]  # those for bearings of these kinds


def carried(shafts: Shafts, kinds: tuple[str, ...] = ()) -> OnBearings:
    """A design with bearings.

    `shafts`: gives it with the shafts that are as thick as such bearings ask; `kinds`: those with which the engine is
    built, front to rear: plain, ball, roller, needle; where none such are found, or left out, by the rule.  Raises
    NoBearings where neither plain nor rolling ones carry it."""
    if kinds and PLAIN not in kinds:
        try:
            return on_rolling(shafts(kinds), kinds)
        except NoSolution:
            kinds = ()
    on_films, plain, why = shafts(()), None, EMPTY
    try:
        plain = on_plain(on_films)
    except NoSolution as none:
        why = none.tried or none.what
    if plain is not None and {*kinds} == {PLAIN}:
        return plain
    if plain is not None and kinds:
        try:
            return on_rolling(on_films, kinds, plain.plain)
        except NoSolution:
            pass
    if plain is not None and not _lose_much(plain, on_films.results):
        return plain
    try:
        rolled = on_rolling(shafts(BY_RULE), BY_RULE)
    except NoSolution as none:
        if plain is None:
            raise NoBearings(BEARINGS, SEMICOLON.join((why, none.tried or none.what)), GIVE) from None
        return plain
    # what is too hot at 150 °C, or lives too short with its clearance, takes no place of what is well on films
    return rolled if plain is None or (rolled.open == 0 and _loses_less(rolled, plain, on_films.results)) else plain


def on_plain(made: Unborne) -> OnBearings:
    """Raises NoSolution."""
    if _is_one_at_minus_one(made.results.design):
        found = journals.bearings(made.document, made.results)
        rows, shared = parted(found)
        return OnBearings(journals.with_bearings(made.document, found), completed(made.shafts, rows) + shared, found)
    document = several.bearings(made.document, made.results)
    return OnBearings(document, several.completed(made.shafts, document), [])


def on_rolling(made: Unborne, kinds: tuple[str, ...], plain: Sequence[Section] = ()) -> OnBearings:
    """Raises NoSolution."""
    document, results = rolling.with_duty(made.document, made.results.design), made.results
    if document is not made.document:
        results = solve(design(document), results, compared=False)
    open_, found = rolling.best(document, results, kinds, plain)
    rows, shared = parted(found)
    return OnBearings(
        journals.with_bearings(document, found), completed(made.shafts, rows) + shared, list(plain), open_
    )


def _is_one_at_minus_one(made: Design) -> bool:
    return len(made.shafts) == 1 and made.own is not None and made.own.speed_ratio == -1


# --- one per cent


@record
class Lost:
    """What the bearings of all shafts lose at rated speed, and the rated power; whether that is estimated."""

    power: Watt
    rated: Watt
    estimated: bool


def lost(results: Results) -> Lost | None:
    """None where it is not known."""
    made, engine = results.design, results.result(EngineResult)
    every = _every(results)
    if made.engine is None or engine is None or not every:
        return None
    rated = made.engine.rated_power
    estimated = _estimated_power(made.engine, engine.displacement)
    return Lost(sum(b.friction_power for b in every), estimated if rated is None else rated, rated is None)


def share_said(results: Results) -> Text:
    """What the bearings of all shafts lose, of the rated power; above 1 % why, and what would lose less."""
    known, made = lost(results), results.design
    if known is None or made.engine is None:
        return EMPTY
    of = Text("of the rated power")
    if known.estimated:
        p = Amount(MEAN_PRESSURE[made.engine.strokes] / 1e5, "bar")
        power = Amount(known.rated / 1e3, "kW", digits=3)
        of = Text("of {power} (mean pressure {p}, assumed)", power=power, p=p)
    amounts = {"P": Amount(known.power, "W", digits=3), "share": Amount(100 * known.power / known.rated, digits=2)}
    said = Text("All bearings of the shafts lose {P}, {share} % {of}.", of=of, **amounts)
    if known.power <= SHARE * known.rated:
        return said
    most = max(_every(results), key=lambda b: b.load)
    amounts = {"load": Amount(most.load, "N", digits=3), "speed": Amount(most.speed * 60, "rpm", digits=4)}
    why = Text("That is more than 1 %, for {load} at {speed}.", **amounts)
    would = on_rolling_instead(made, {name: view.shaft for name, view in results.views.items()})
    if would is None or would >= known.power:
        return Text("{said} {why}", said=said, why=why)
    less = Text("Balls and rollers would lose about {P}.", P=Amount(would, "W", digits=2))
    return Text("{said} {why} {less}", said=said, why=why, less=less)


def _lose_much(plain: OnBearings, before: Results) -> bool:
    """Whether plain bearings lose more than a hundredth of the rated power."""
    of_all = lost(_solved(plain, before))
    return of_all is not None and of_all.power > SHARE * of_all.rated


def _loses_less(one: OnBearings, other: OnBearings, before: Results) -> bool:
    powers = [lost(_solved(each, before)) for each in (one, other)]
    return all(powers) and powers[0].power < powers[1].power  # type: ignore[union-attr]


def _solved(bearings: OnBearings, before: Results) -> Results:
    return solve(design(bearings.document), before, compared=False)


def _every(results: Results) -> list[Carrying]:
    """The bearings of all shafts, those of twins too."""
    found = []
    for name, view in results.views.items():
        of_shaft = view.result(BearingsResult)
        count = 1 + len(twins_of(results.design, name))
        found += [*of_shaft.bearings.values()] * count if of_shaft is not None else []
    return found


def _estimated_power(engine: EngineInputs, displacement: float) -> Watt:
    return MEAN_PRESSURE[engine.strokes] * displacement * engine.rated_speed / (engine.strokes / 2)
