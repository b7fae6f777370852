# SPDX-License-Identifier: Apache-2.0
"""Rolling bearings to begin with: of each place the one of least loss over a usual duty that passes every limit, with
the clearance class, the fits and the seat in which it neither jams nor creeps.

At the gear stands a ball bearing, which takes the thrust, or where none lives long enough a roller bearing with
flanges; elsewhere roller bearings, which leave the shaft its length.  Their bores are no larger than the core, which
is their shoulder.  Needles have rings, or roll on the shaft itself in a cage: where the shaft is laid in, in one of two
halves, which passes nothing."""

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from itertools import repeat

from ...bearings.inputs import BearingsInputs
from ...bearings.result import BearingsResult
from ...bearings.rolling.bearing import judged
from ...bearings.rolling.checks import LIFE as LIFE_ASKED
from ...bearings.rolling.checks import SYSTEM_LIFE, life_asked
from ...bearings.rolling.raceway import LEAST_CASE, case_depth_needed
from ...bearings.rolling.search import HELD, SMALL, Candidate, Place, as_rolling, candidates, fitted
from ...bearings.rolling.sizes import BearingSize, every_size, listed_cages, size_of
from ...bearings.rolling.solve import case_of
from ...countershaft.inputs import LAID_IN
from ...countershaft.result import CountershaftResult
from ...countershaft.rows import BearingRow, called
from ...design.addresses import Table
from ...design.model import Design
from ...design.step_inputs import rolling_places, twins_of
from ...design.toml_file import Document, design
from ...engine.inputs import EngineInputs
from ...engine.operation import Operation
from ...sheet.check import Check
from ...sheet.errors import NoSolution
from ...sheet.quantity import dotted, keys
from ...sheet.record import record, replace
from ...sheet.text import COMMA, Amount, Text
from ...sheet.units import Metre, Number, Second
from ...sheet.value import recorded
from ...solve import Results, solve
from .journals import OILS, oil_of, with_bearings
from .journals import shared as shared_of_plain
from .shaft import NAME
from .writing import BEARING_ROW, Rows, Section, mm, parted, up

BEARINGS = Text("rolling bearings to begin with")
GIVE = Text("what would help: a thicker core, a slower shaft, or bearings of your own")
HELPS = Text(
    "what would help: a slower engine, lighter pistons and rods, fewer hours asked, or bearings of another kind"
)
LIFE: Second = 5000 * 3600.0
SPREAD = 0.9  # of the lives of rollers: so many together live as much shorter
# share of the rated speed, and of the hours
DUTY = {"rated": (1.0, 20.0), "middle": (0.7, 60.0), "low": (0.35, 20.0)}
BALL, ROLLER, NEEDLE, CAGE, PLAIN, ROLLING = "ball", "roller", "needle", "cage", "plain", "rolling"
AT_GEAR, ELSEWHERE = (BALL, ROLLER), (ROLLER,)  # the kinds that are looked at, one after the other
# what stands there while the loads are found
BEGUN = {BALL: "6002", ROLLER: "NU1002", NEEDLE: "NA4902", CAGE: "K20x26x17"}
BORES = tuple(sorted({size.bore for size in every_size() if size.type == "ball" and size.bore >= 0.02}))  # of cores
CASE: Metre = 0.1e-3  # the depth of a hard case is given in steps of this
PASSES = 4  # the loads follow the size of the bearings a little
OPEN = ("limit", "caution")
OPERATION = dotted(Design.engine, EngineInputs.operation)


def duty(made: Design) -> list[Table]:
    """How the engine runs, as [[engine.operation]] has it: a fifth of the hours at rated speed, a fifth at a third."""
    engine = made.engine
    assert engine is not None
    return [
        {
            dotted(Operation.name): name,
            dotted(Operation.speed): round(share * engine.rated_speed * 60, 1),
            dotted(Operation.hours): hours,
        }
        for name, (share, hours) in DUTY.items()
    ]


def with_duty(document: Document, made: Design) -> Document:
    """The document with a duty of its engine, where it has none."""
    if made.engine is None or made.engine.operation or (made.bearings is not None and made.bearings.duty):
        return document
    return document.with_value(OPERATION, duty(made))


def best(
    document: Document, results: Results, kinds: tuple[str, ...], plain: Sequence[Section] = ()
) -> tuple[int, list[Section]]:
    """The tables of rolling bearings for the shafts of a design, and what their rows have then, as `with_bearings`
    takes them, and how many cautions are open with them; the document has a duty.

    `kinds`: of each shaft's bearings, front to rear: ball, roller, needle, plain, or rolling, by the rule above.
    `plain`: the tables of plain bearings, of which those places keep theirs.  Raises NoSolution."""
    made = results.design
    if made.engine is None or any(view.result(CountershaftResult) is None for view in results.views.values()):
        raise NoSolution(BEARINGS, Text("the shaft that they carry is not known"), Text("give [[shafts]] first"))
    if any(len(view.rows) > 2 for view in made.views.values()):
        raise NoSolution(BEARINGS, Text("no ring passes the sectors to an inner bearing"), GIVE)
    seats = _seats(made, kinds)
    plain_rows, of_plain = parted(list(plain))
    shared = _shared(made, of_plain if any(seat.kinds == (PLAIN,) for seat in seats) else [])
    known = {check.id for check in results.outcomes["countershaft"].checks if check.open}
    rows = {seat: as_begun(seat) for seat in seats if seat.kinds != (PLAIN,)}
    together = sum(1 + len(twins_of(made, seat.shaft)) for seat in rows)
    failed: set[tuple[SeatPlace, str]] = set()
    found: tuple[int, list[Section]] | None = None
    open_, expected = list[Check](), 0
    for n in range(PASSES):
        sections = [*shared, *_rows(seats, rows, plain_rows)]
        solved = solve(design(with_bearings(document, sections)), results, compared=False)
        if n:
            open_ = [check for check in _open(solved) if check.id not in known]
            if not open_:
                return 0, sections
            if not any(check.kind == "limit" for check in open_) and (found is None or len(open_) < found[0]):
                found = len(open_), sections
                if len(open_) <= expected:  # what is to be said of each alone
                    return found
            failed |= {(seat, rows[seat].size or "") for seat in _to_change(open_, rows, solved)}
        try:
            chosen = {seat: _chosen(seat, solved, together, failed) for seat in rows}
        except NoSolution:
            if found is None:
                raise
            break
        rows = {seat: row for seat, (_, row) in chosen.items()}
        expected = sum(count for count, _ in chosen.values())
    if found is not None:
        return found
    raise NoSolution(BEARINGS, COMMA.join(check.name for check in open_[:2]), GIVE)


class NoneCarries(NoSolution):
    """No bearing passes in a place.  `nearest`: of the life that is asked, what the one comes to that lives longest."""

    def __init__(self, tried: Text, nearest: Number) -> None:
        self.nearest = nearest
        super().__init__(BEARINGS, tried, HELPS)


@record
class SeatPlace:
    """One place of a shaft, by both names, and the kinds of bearing that are looked at there, one after the other."""

    shaft: str
    place: str
    kinds: tuple[str, ...]
    first: bool  # of its shaft, beside the wheel
    locates: bool


def _seats(made: Design, kinds: tuple[str, ...]) -> list[SeatPlace]:
    """Those of all shafts that are no twins, front to rear."""
    seats = []
    for name, view in made.views.items():
        located = False
        for n, row in enumerate(view.rows):
            some = (kinds[n],) if kinds[n] != ROLLING else ELSEWHERE if located else AT_GEAR
            locates = not located and some[0] in AT_GEAR
            seats.append(SeatPlace(name, row.name, some, n == 0, locates))
            located = located or locates
    return seats


def as_begun(seat: SeatPlace) -> BearingRow:
    """A small one, while the loads are found."""
    held = HELD if seat.kinds == (CAGE,) else "fit"
    return BearingRow(name=seat.place, kind="rolling", size=BEGUN[seat.kinds[0]], outer_ring_held=held)


def _chosen(
    seat: SeatPlace, solved: Results, together: int, failed: set[tuple[SeatPlace, str]]
) -> tuple[int, BearingRow]:
    """The one of least loss of which nothing is to be said; else of those that pass the one of which least is, and how
    much.  Raises NoSolution where none passes.

    `together`: so many live as long as is asked; `failed`: what the whole design did not pass with."""
    there = rolling_places(solved.design, solved, seat.shaft)[seat.place]
    # of which nothing stays that belongs to another size
    bare = replace(there.row, kind=PLAIN, split_cage=_is_split(solved.design, seat))
    place = replace(there, row=bare, locates=seat.locates, bores=_bores(solved.design, seat))
    found: tuple[int, BearingRow] | None = None
    why, passing, longest = Counter[Text](), list[Candidate](), list[Candidate]()
    for kind in seat.kinds:
        for one in candidates(place, _sizes(place, kind, _room(solved.design, seat))):
            if one.fails:
                why[one.fails[0].short or one.fails[0].name] += 1
                if LIFE_ASKED in one.fails:
                    longest.append(one)
            elif (seat, one.size.designation) not in failed:
                passing.append(one)
    for one in sorted(passing, key=lambda one: bool(one.risks)):
        row = fitted(place, _row(place, one.size.designation), one.temperature)
        if row is None:
            why[SITS] += 1
            continue
        if found is not None and one.risks:
            break
        open_ = _findings(place, row, together)
        if not open_:
            return 0, row
        if not any(check.kind == "limit" for check in open_) and (found is None or len(open_) < found[0]):
            found = len(open_), row
    if found is None:
        raise _none(place, why, longest)
    return found


def _none(place: Place, why: Counter[Text], longest: list[Candidate]) -> NoneCarries:
    """In words; `why`: what stands against how many; `longest`: those that live too short, some of which break other
    limits as well."""
    most = COMMA.join(text for text, _ in why.most_common(2))
    if not longest:
        return NoneCarries(Text("{place}: {why}", place=called(place.row.name), why=most), 0.0)
    one = max(longest, key=lambda one: (-len(one.fails), one.life or 0.0))
    asked = life_asked(place.inputs, place.task.life)
    said = Text(
        "{place}: of those that fit {size} comes nearest, and lives {life} of the {asked} that are asked",
        place=called(place.row.name),
        size=one.size.designation,
        life=Amount((one.life or 0.0) / 3600, "h", digits=3),
        asked=Amount(asked / 3600, "h", digits=3),
    )
    if others := COMMA.join(rule.short or rule.name for rule in one.fails if rule is not LIFE_ASKED):
        said = Text("{said} (beyond its limit too: {others})", said=said, others=others)
    return NoneCarries(said, (one.life or 0.0) / asked / len(one.fails))


def _row(place: Place, size: str) -> BearingRow:
    """As a bearing of this size stands there; of a cage with the shaft and the housing hard enough to be raceways."""
    row = as_rolling(place, size)
    if size_of(size).type != CAGE:
        return row
    row = replace(row, outer_ring_held=HELD, split_cage=place.row.split_cage)
    assert row.inside is not None
    return replace(row, case_depth=max(LEAST_CASE, up(case_depth_needed(D_w=row.inside.diameter), CASE)))


def _is_split(made: Design, seat: SeatPlace) -> bool:
    own = made.views[seat.shaft].own
    return seat.kinds == (CAGE,) and own is not None and own.assembly in LAID_IN


def _bores(made: Design, seat: SeatPlace) -> tuple[Metre, Metre]:
    """Least and largest: the core is the shoulder of a ring; where a wheel sits before the bearing, as thick as the
    core, the ring has to pass there."""
    own = made.views[seat.shaft].own
    if own is None or own.core_radius is None:
        return 0.0, math.inf
    passed = own.gear_z is not None and seat.first and not _is_split(made, seat)
    return (2 * own.core_radius if passed else 0.0), 2 * own.core_radius


def _room(made: Design, seat: SeatPlace) -> Metre:
    """How wide a bearing may be that stands as far from the sectors as a fillet is high."""
    own = made.views[seat.shaft].own
    if own is None or own.half_length is None:
        return math.inf
    position = next(row.position for row in own.bearings if row.name == seat.place)
    return 2 * (abs(position) - own.half_length - (own.fillet_radius or 0.0))


def _sizes(place: Place, kind: str, room: Metre) -> Iterator[BearingSize[float]]:
    if kind == CAGE:
        yield from (size for size in listed_cages() if _bears(place, size) and size.width <= room + SMALL)
    for size in every_size():
        if _bears(place, size) and size.type == kind:
            if size.inner_ring and (kind != ROLLER or size.flanged == place.locates):
                yield size


def _bears(place: Place, size: BearingSize[float]) -> bool:
    return place.bores[0] <= size.bore + SMALL and size.bore <= place.bores[1] + SMALL


def _findings(place: Place, row: BearingRow, together: int) -> list[Check]:
    """What is to be said of one bearing, which lives so long that all together do."""
    with recorded(False):
        one = judged(case_of(row, place.inputs, place.solids), place.load, place.stands, place.slope, place.task)
        checks = [*one.checks()]
    if one.life is not None and one.life < LIFE * together**SPREAD:
        checks.append(SYSTEM_LIFE(one.life, LIFE * together**SPREAD))
    return [check for check in checks if check.open and check.kind in OPEN]


def _open(solved: Results) -> list[Check]:
    outcomes = [solved.outcomes[step] for step in ("countershaft", "bearings")]
    return [check for outcome in outcomes for check in outcome.checks if check.open and check.kind in OPEN]


def _to_change(open_: list[Check], rows: Mapping[SeatPlace, BearingRow], solved: Results) -> set[SeatPlace]:
    """Of which bearings something is to be said: of those that it names, else of the one that lives shortest."""
    named = {seat for seat in rows for check in open_ if {seat.place, seat.shaft} <= {*check.id.split("."), NAME}}
    return named or {min(rows, key=lambda seat: _life(seat, solved))}


def _life(seat: SeatPlace, solved: Results) -> Second:
    """Of one whose life is not known endless."""
    result = solved.views[seat.shaft].result(BearingsResult)
    survival = result.bearings[seat.place].survival() if result is not None else None
    return math.inf if survival is None else survival[0]


# --- as they are written

LEAST_LOSS = "assumed: of least loss over the duty of those that keep every limit"
SITS = Text("no class and fit in which it neither jams nor creeps")


def _shared(made: Design, of_plain: list[Section]) -> list[Section]:
    """What all bearings share: beside that of the plain ones the life that is asked."""
    life: Rows = {BearingsInputs.life: (LIFE / 3600, "assumed")}
    if of_plain:
        (header, both), *others = of_plain
        return [(header, both | life), *others]
    (oil, *_) = oil_of(made, OILS)
    (header, both), *_ = shared_of_plain(made, oil)
    kept = (BearingsInputs.oil, BearingsInputs.supply_temperature, BearingsInputs.housing_material)
    rows: Rows = {key: both[key] for key in kept}
    rows[BearingsInputs.supply_temperature] = (
        rows[BearingsInputs.supply_temperature][0],
        "assumed: of the oil that is splashed",
    )
    return [(header, rows | life)]


def _rows(seats: list[SeatPlace], rows: Mapping[SeatPlace, BearingRow], plain: list[Section]) -> list[Section]:
    """Of all places, front to rear."""
    beside = iter(plain) if plain else repeat((BEARING_ROW, {}))
    return [
        theirs if seat not in rows else (BEARING_ROW, {BearingRow.name: (seat.place, "")} | written_row(rows[seat]))
        for seat, theirs in zip(seats, beside)
    ]


def written_row(row: BearingRow) -> Rows:
    """What a row says of a rolling bearing, as far as it is not what is taken where it says nothing."""
    held = "assumed: with it neither jams nor creeps, warm, cold and at the start"
    said: Rows = {
        BearingRow.kind: ("rolling", ""),
        BearingRow.size: (row.size, LEAST_LOSS),
        BearingRow.locates: (row.locates, "takes the thrust of the gear"),
        BearingRow.split_cage: (row.split_cage, "in two halves: it has to pass nothing"),
        BearingRow.cage: (row.cage, "assumed: polyamide would get too hot"),
        BearingRow.clearance_class: (row.clearance_class, held),
        BearingRow.shaft_fit: (row.shaft_fit, held),
        BearingRow.seat_fit: (row.seat_fit, held),
        BearingRow.outer_ring_held: (
            row.outer_ring_held,
            "assumed: a sleeve of steel cast in, " + ("hardened" if row.case_depth else "which grips when hot"),
        ),
        BearingRow.case_depth: (None if row.case_depth is None else mm(row.case_depth), "assumed: of the shaft"),
    }
    usual = {dotted(key): entry.field.default for key, entry in keys(BearingRow).items()}
    return {key: entry for key, entry in said.items() if key is BearingRow.kind or entry[0] != usual[dotted(key)]}
