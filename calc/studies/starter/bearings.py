# SPDX-License-Identifier: Apache-2.0
"""Which bearings a shaft begins with: plain ones, and rolling ones where none are found that keep every limit, or all
together lose more than a hundredth of the rated power, and rolling ones less; or of the kinds with which the engine is
built."""

from collections.abc import Sequence

from ...bearings.result import BearingsResult
from ...bearings.support import Carrying
from ...design.model import Design
from ...design.step_inputs import twins_of
from ...design.toml_file import Document, design
from ...engine.inputs import EngineInputs
from ...engine.result import EngineResult
from ...sheet.errors import NoSolution
from ...sheet.record import record
from ...sheet.text import EMPTY, SEMICOLON, Amount, Text
from ...sheet.units import Number, Watt
from ...solve import Results, solve
from . import journals, rolling, several
from .rolling import PLAIN
from .writing import Section, completed, parted

SHARE: Number = 0.01  # of the rated power
MEAN_PRESSURE = {4: 10e5, 2: 6e5}  # Pa, of an engine whose power is not given; by its strokes, rule of this program
BEARINGS = Text("bearings to begin with, plain and rolling")
GIVE = Text("other bearings, a thicker core, a slower shaft")


@record
class Carried:
    """A design with its bearings: its document, and the tables of its shafts and of what all bearings share."""

    document: Document
    sections: list[Section]
    plain: list[Section]  # of plain bearings of one shaft, as `journals.bearings` gives them


def carried(document: Document, results: Results, own: list[Section], kinds: Sequence[str] = ()) -> Carried:
    """A design whose shafts have no bearings yet, with such.

    `own`: the tables of its shafts; `kinds`: those with which the engine is built, front to rear: plain, ball, roller,
    needle; where none such are found, or left out, by the rule.  Raises NoSolution where neither kind carries them."""
    if kinds and PLAIN not in kinds:
        try:
            return on_rolling(document, results, own, kinds)
        except NoSolution:
            kinds = ()
    plain, why = None, Text("")
    try:
        plain = on_plain(document, results, own)
    except NoSolution as none:
        why = none.tried or none.what
    lost_so = _lost(plain, results) if plain is not None else None
    little = lost_so is None or lost_so.power <= SHARE * lost_so.rated
    if plain is not None and ({*kinds} == {PLAIN} or (little and not kinds)):
        return plain
    try:
        rolled = on_rolling(document, results, own, kinds, plain.plain if plain is not None else ())
    except NoSolution as none:
        if plain is None:
            raise NoSolution(BEARINGS, SEMICOLON.join((why, none.tried or none.what)), GIVE) from None
        return plain
    less = _lost(rolled, results)
    if plain is not None and not kinds and lost_so is not None and less is not None and less.power >= lost_so.power:
        return plain
    return rolled


def on_plain(document: Document, results: Results, own: list[Section]) -> Carried:
    """Raises NoSolution."""
    if _is_one_at_minus_one(results.design):
        found = journals.bearings(document, results)
        rows, shared = parted(found)
        return Carried(journals.with_bearings(document, found), completed(own, rows) + shared, found)
    document = several.bearings(document, results)
    return Carried(document, several.completed(own, document), [])


def on_rolling(
    document: Document, results: Results, own: list[Section], kinds: Sequence[str] = (), plain: Sequence[Section] = ()
) -> Carried:
    """Raises NoSolution."""
    with_duty = rolling.with_duty(document, results.design)
    if with_duty is not document:
        results = solve(design(with_duty), results, compared=False)
    found = rolling.bearings(with_duty, results, kinds, plain)
    rows, shared = parted(found)
    return Carried(journals.with_bearings(with_duty, found), completed(own, rows) + shared, list(plain))


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
    why = Text(
        "That is more than 1 %, for {load} at {speed}.",
        load=Amount(most.load, "N", digits=3),
        speed=Amount(most.speed * 60, "rpm", digits=4),
    )
    return Text("{said} {why}", said=said, why=why)


def _lost(bearings: Carried, before: Results) -> Lost | None:
    return lost(solve(design(bearings.document), before, compared=False))


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
