# SPDX-License-Identifier: Apache-2.0
"""The oil drain of the support: a spring band clamp that grips both ends of the hose, a union that fits the block and a
sleeve on it.

A clamp must be closed when it sits on the smaller end, so its nominal diameter must not exceed that end, and it must
open far enough to go over the larger one.  A clamp of the next size up would open far enough where this one does not,
but it would not grip."""

import math
from collections.abc import Iterator
from functools import cache

from ...library.table_file import house_table
from ...sheet.check import Check, CheckRule
from ...sheet.formula import formula
from ...sheet.quantity import dotted, result, value
from ...sheet.record import replace
from ...sheet.shown import Shown
from ...sheet.text import EMPTY, Amount, Name, Text
from ...sheet.units import CubicMetrePerSecond, Metre, MetreTuple, Radian
from ...sheet.value import about, based_on
from ..inputs import ShaftInputs
from ..rows import SHAFT
from .inputs import Clamp, FurtherDrain, OilDrain, Sleeve, Union, thread

# m: by which the ring of a sleeve may be wider than the thread that goes through it; so the source's table has them
RING = 0.1e-3
RULE = Text("Finotti 2013, 4.4: choice of a spring band clamp (DIN 3021)")


@cache
def clamps(series: str = "company") -> tuple[Clamp, ...]:
    """The clamps that come with the program: those of the source ("company") or of the standard ("din3021")."""
    rows = house_table("clamps.toml")[series]["clamps"]
    return tuple(Clamp(nominal=row["nominal_mm"] / 1000, opening=row["opening_mm"] / 1000) for row in rows)


@cache
def unions() -> tuple[Union, ...]:
    """The unions that come with the program."""
    return tuple(Union(thread=row["thread"], bore=row["bore_mm"] / 1000) for row in house_table("unions.toml")["row"])


@cache
def sleeves() -> tuple[Sleeve, ...]:
    """The sleeves that come with the program, those that take a hose."""
    rows = [row for row in house_table("sleeves.toml")["row"] if "d1_mm" in row]
    return tuple(Sleeve(ring=row["d_mm"] / 1000, bore=row["d1_mm"] / 1000, end=row["d2_mm"] / 1000) for row in rows)


# --- formulas


@formula(
    "D_n",
    Text("{rule}: the largest that still grips the smaller end of the hose", rule=RULE),
    shows="largest nominal diameter at hand ≤ D_min",
    unit="mm",
)
def nominal(D_n: MetreTuple, D_min: Metre) -> Metre:
    """`D_n`: the nominal diameters at hand.  Meaningful where at least one of them fits."""
    return max(size for size in D_n if size <= D_min)


@formula(
    "D_o",
    Text("{rule}: opening of this clamp", rule=RULE),
    shows="opening beside D_n in the table of clamps",
    unit="mm",
)
def opening(D_n: Metre, nominals: MetreTuple, openings: MetreTuple) -> Metre:
    return max(o for size, o in zip(nominals, openings) if size == D_n)


@formula("Δ", Text("{rule}: what the opening exceeds the larger end of the hose by", rule=RULE), unit="mm")
def margin(D_o: Metre, D_max: Metre) -> Metre:
    return D_o - D_max


@formula(
    "d_u",
    "rule of this program: the union with the widest bore among those whose thread fits the block (Finotti 2013, 4.4)",
    shows="largest bore",
    unit="mm",
)
def widest_bore(bores: MetreTuple, designation: str) -> Metre:
    """`bores`: of the unions at hand with the thread `designation`."""
    return max(bores)


@formula(
    "d_1",
    "rule of this program: the sleeve with the widest bore among those whose ring fits the union's thread (Finotti "
    "2013, 4.4)",
    shows="largest bore",
    unit="mm",
)
def widest_sleeve(bores: MetreTuple, designation: str) -> Metre:
    """`bores`: of the sleeves at hand whose ring fits the thread `designation`."""
    return max(bores)


@formula(
    "θ_d",
    "geometry: slope of the passage to the drain while the machine tilts against it",
    unit="°",
    names={"tau": "τ"},
)
def tilted_slope(theta: Radian, tau: Radian) -> Radian:
    return theta - tau


# --- results


@result
class DrainResult(Shown):
    """Clamp and union; None where none fits.  `tried` and `tried_din3021` are the margins of the one clamp that could
    grip, taken or not (None: each is too large); `reason` says why it was not taken."""

    clamp_nominal: Metre | None = value("Nominal diameter of the hose clamp", "mm", "D_n", default=None)
    clamp_opening: Metre | None = value("its largest opening", "mm", "D_o", default=None)
    clamp_margin: Metre | None = value("its opening beyond the hose", "mm", "Δ", default=None)
    clamp_opening_din3021: Metre | None = value("its largest opening by DIN 3021", "mm", "D_o", default=None)
    union_bore: Metre | None = value("Bore of the widest pipe union that fits", "mm", "d_u", default=None)
    sleeve_bore: Metre | None = value("Bore of the widest sleeve that fits", "mm", "d_1", default=None)
    sleeve_end: Metre | None = value("outer diameter of its end, for the hose", "mm", "d_2", default=None)
    drain_slope: Radian | None = value("Slope of the passage to the drain, machine tilted", "°", "θ_d", default=None)
    drain_run_off: CubicMetrePerSecond | None = value("Oil that runs off by this slope", "L/min", "Q_d", default=None)
    drain_flow: CubicMetrePerSecond | None = value(
        "Oil of the bearings that the drain takes", "L/min", "Q_o", default=None
    )
    drain: OilDrain
    smallest: Metre  # nominal diameter of the smallest clamp at hand
    tried: Metre | None
    tried_din3021: Metre | None
    unions: tuple[Union, ...]  # those that fit
    reason: Text


def _pick(drain: OilDrain, at_hand: tuple[Clamp, ...]) -> tuple[Metre, Metre] | None:
    """Nominal diameter and opening of the one clamp that grips and comes closest to the hose; None where each is too
    large."""
    if min(clamp.nominal for clamp in at_hand) > drain.hose_min:
        return None
    sizes, opens = tuple(clamp.nominal for clamp in at_hand), tuple(clamp.opening for clamp in at_hand)
    D_n = nominal(D_n=sizes, D_min=drain.hose_min)
    return D_n, opening(D_n=D_n, nominals=sizes, openings=opens)


def _widest_union(drain: OilDrain) -> tuple[tuple[Union, ...], Metre | None]:
    """The unions whose thread fits the block, and the widest of their bores; None where none fits."""
    hole = thread(drain.thread)
    fitting = tuple(union for union in drain.unions or unions() if thread(union.thread) == hole)
    if not fitting:
        return (), None
    return fitting, widest_bore(bores=tuple(union.bore for union in fitting), designation=drain.thread)


def _widest_sleeve(drain: OilDrain) -> tuple[Metre | None, Metre | None]:
    """Bore and end of the sleeve that goes on the union; None where no ring fits its thread."""
    diameter = thread(drain.thread)[0]
    fitting = tuple(s for s in drain.sleeves or sleeves() if 0 <= round(s.ring - diameter, 9) <= RING)
    if not fitting:
        return None, None
    bore = widest_sleeve(bores=tuple(sleeve.bore for sleeve in fitting), designation=drain.thread)
    return bore, based_on(next(sleeve.end for sleeve in fitting if sleeve.bore == bore), bore)


def _mm(x: Metre) -> Text:
    return Text("{x} mm", x=Amount(x * 1000.0, form="g"))


def solve(drain: OilDrain) -> DrainResult:
    """Choose clamp and union from the design's own lists, or else from those that come with the program."""
    at_hand = drain.clamps or clamps()
    with about(Text("oil drain")):
        picked = _pick(drain, at_hand)
        fitting, union_bore = _widest_union(drain)
        sleeve_bore, sleeve_end = _widest_sleeve(drain)
        slope = tilted_slope(theta=drain.slope, tau=drain.tilt or 0.0) if drain.slope is not None else None
        gap = margin(D_o=picked[1], D_max=drain.hose_max) if picked else None
        with about(Text("oil drain, DIN 3021")):
            standard = None if drain.clamps else _pick(drain, clamps("din3021"))
            gap_din = margin(D_o=standard[1], D_max=drain.hose_max) if standard else None
    taken = picked if picked is not None and picked[1] >= drain.hose_max else None
    same_size = standard if standard is not None and taken is not None and standard[0] == taken[0] else None
    return DrainResult(
        clamp_nominal=taken[0] if taken else None,
        clamp_opening=taken[1] if taken else None,
        clamp_margin=gap if taken else None,
        clamp_opening_din3021=same_size[1] if same_size else None,
        union_bore=union_bore,
        sleeve_bore=sleeve_bore,
        sleeve_end=sleeve_end,
        drain_slope=slope,
        drain=drain,
        smallest=min(clamp.nominal for clamp in at_hand),
        tried=gap,
        tried_din3021=gap_din if same_size else None,
        unions=fitting,
        reason=EMPTY if taken else _reason(drain, picked, standard),
    )


def _reason(drain: OilDrain, picked: tuple[Metre, Metre] | None, standard: tuple[Metre, Metre] | None) -> Text:
    """Why no clamp is taken, and whether the standard has one."""
    if picked is None:
        why = Text("no clamp at hand is as small as the hose end of {mm}, so none grips it", mm=_mm(drain.hose_min))
    else:
        why = Text(
            "the largest clamp that grips the hose end of {mm} is {mm2} and opens to {mm3}, not over the end of "
            "{mm4}; a larger one would not grip",
            mm=_mm(drain.hose_min),
            mm2=_mm(picked[0]),
            mm3=_mm(picked[1]),
            mm4=_mm(drain.hose_max),
        )
    if standard is not None and standard[1] >= drain.hose_max:
        size, opens = _mm(standard[0]), _mm(standard[1])
        why += Text(
            ". DIN 3021 has one of {mm} that opens to {mm2}: give it as a clamp of the design", mm=size, mm2=opens
        )
    return why


DRAIN = SHAFT, ShaftInputs.oil_drain
HOSE = (dotted(*DRAIN, OilDrain.hose_min), dotted(*DRAIN, OilDrain.hose_max))
THREAD, PASSAGE = dotted(*DRAIN, OilDrain.thread), dotted(*DRAIN, OilDrain.slope)
CLAMP = CheckRule(
    "countershaft.D.clamp",
    "caution",
    "No clamp at hand holds the hose: it leaks; another one can be bought.",
    unit="mm",
    source=RULE,
    zero="hose_max_mm",
    moved_by=HOSE,
)
CLAMP_DIN3021 = CheckRule(
    "countershaft.D.clamp_din3021",
    "advice",
    "The standard asks for less opening than the clamps of the source have.",
    Text("Opening of the clamp by DIN 3021 beyond the larger hose end"),
    unit="mm",
    advice=Text(
        "The clamp of the source opens further than the standard asks for: make sure that the one bought does too."
    ),
    zero="hose_max_mm",
    moved_by=HOSE,
)
UNION = CheckRule(
    "countershaft.D.union",
    "caution",
    "No union at hand fits the thread; another one can be bought.",
    sense=">",
    source=Text("Finotti 2013, 4.4: the union's thread must be that of the hole in the block"),
    advice=Text("Another thread in the block, or a union of the design."),
    zero="1 (count)",
    moved_by=(THREAD,),
)
SLEEVE = CheckRule(
    "countershaft.D.sleeve",
    "advice",
    "A sleeve that is not at hand can be made.",
    sense=">",
    source=Text("Finotti 2013, 4.4: the union goes through the ring of the sleeve"),
    advice=Text("A sleeve of the design."),
    zero="1 (count)",
    moved_by=(THREAD,),
)
PASSAGE_SLOPE = CheckRule(
    "countershaft.D.slope",
    "limit",
    "The oil does not leave the support.",
    Text("Slope of the passage to the drain, machine tilted"),
    ">",
    "°",
    Text("Finotti 2013, 3.2.2: the oil must leave while the machine works on a slope"),
    Text("A steeper passage: it must slope by more than the machine tilts."),
    role="physics",
    zero="5°",
    value_id=dotted("countershaft", DrainResult.drain_slope),
    moved_by=(PASSAGE,),
)
RUN_OFF = CheckRule(
    "countershaft.D.run_off",
    "caution",
    "Oil stands in the support and the shaft churns in it; the true passage is no pipe of one bore.",
    Text("Oil of the bearings that the drain takes"),
    "<=",
    "L/min",
    Text("rule of this program: it must run off by itself, by the slope that the machine's tilt leaves"),
    Text("A wider bore, a steeper passage, or a drain more. Cold oil runs off far slower."),
    demand=True,
    value_id=dotted("countershaft", DrainResult.drain_flow),
    limit_id=dotted("countershaft", DrainResult.drain_run_off),
    moved_by=(dotted(*DRAIN, OilDrain.bore), PASSAGE),
)
TILTED = math.radians(5.0)  # of which the margin of a slope is a share


def checks(choice: DrainResult) -> Iterator[Check]:
    """Whether a clamp goes over both ends, whether union and sleeve fit, and whether the oil finds a slope while the
    machine is tilted."""
    drain, advice = choice.drain, EMPTY
    at = drain.element
    if choice.reason:
        advice = Text(
            "Hose ends closer to each other in diameter, or a clamp for each end: {reason}.", reason=choice.reason
        )
    if choice.tried is None:
        label = Text("Smallest clamp at hand on the smaller hose end")
        clamp = CLAMP(choice.smallest, drain.hose_min, at=at, name=label, sense="<=", advice=advice)
    else:
        label = Text("Opening of the clamp beyond the larger hose end")
        clamp = CLAMP(choice.tried, 0.0, at=at, name=label, advice=advice, scale=drain.hose_max)
    yield of_drain(clamp, drain)
    if choice.tried_din3021 is not None:
        source = Text(house_table("clamps.toml")["din3021"]["source"])
        standard = CLAMP_DIN3021(choice.tried_din3021, 0.0, at=at, source=source, scale=drain.hose_max)
        yield of_drain(standard, drain)
    name = Text("Pipe unions at hand with thread {thread}", thread=drain.thread)
    yield of_drain(UNION(float(len(choice.unions)), 0.0, at=at, name=name, scale=1.0), drain)
    if choice.sleeve_bore is None:
        name = Text("Sleeves at hand for a union with thread {thread}", thread=drain.thread)
        yield of_drain(SLEEVE(0.0, 0.0, at=at, name=name, scale=1.0), drain)
    if choice.drain_slope is not None and drain.tilt is not None:
        yield of_drain(PASSAGE_SLOPE(choice.drain_slope, 0.0, at=at, scale=TILTED), drain)


def run_off_check(result: DrainResult) -> Check | None:
    """Of a drain that takes the bearings' oil."""
    if (runs_off := result.drain_run_off) is None:
        return None
    return of_drain(RUN_OFF(result.drain_flow, runs_off, at=result.drain.element), result.drain)


def of_drain(drain_check: Check, drain: OilDrain) -> Check:
    """The check with the name of its drain, its values and its keys; as it is declared it is that of the first, which
    has no name."""
    if not isinstance(drain, FurtherDrain):
        return drain_check
    key = dotted(SHAFT, ShaftInputs.further_drains, drain.name)
    id = dotted("countershaft", ShaftInputs.further_drains, drain.name)
    return replace(
        drain_check,
        name=Text("{what}, {drain}", what=drain_check.name, drain=Name(drain.name)),
        value_id=drain_check.value_id.replace("countershaft", id),
        limit_id=drain_check.limit_id.replace("countershaft", id),
        moved_by=tuple([moving.replace(dotted(*DRAIN), key) for moving in drain_check.moved_by]),
    )


def notes(choice: DrainResult) -> Iterator[Text]:
    """Where the choice comes from, what seals the union, and why there is no clamp."""
    if not choice.drain.clamps:
        yield Text("Oil drain: clamps by {source}.", source=Text(house_table("clamps.toml")["company"]["source"]))
    if choice.reason:
        yield Text("Oil drain: no clamp is taken: {reason}.", reason=choice.reason)
    if choice.drain.slope is not None and choice.drain.bore is None:
        yield Text("Oil drain: what runs off is not computed: give the narrowest bore of the passage.")
    for row in house_table("unions.toml")["seal"]:
        if choice.unions and thread(row["thread"]) == thread(choice.drain.thread):
            parts, source = Text(row["parts"]), Text(row["source"])
            yield Text(
                "Oil drain: the union {thread} is sealed by {parts} ({source}).",
                thread=row["thread"],
                parts=parts,
                source=source,
            )
