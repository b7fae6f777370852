# SPDX-License-Identifier: Apache-2.0
"""Plain and rolling bearings to choose from in one order: what passes, then the least loss over the duty.

Plain rows are those of their own search.  Beside them stand rolling bearings, alone and beside plain ones: of each
place the best of every type and those that no other beats in loss, mass, seat and life; of these all together the same
once more.  The first of them are solved as whole designs before they are shown, the others when they are taken."""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import product
from typing import Any

import numpy as np

from ..countershaft.checks import JOURNAL_SLOPE
from ..countershaft.rows import BearingRow, called
from ..sheet.check import Check
from ..sheet.errors import NoSolution
from ..sheet.progress import Progress, tell
from ..sheet.quantity import Quantity, dotted, given, keys
from ..sheet.record import record, replace
from ..sheet.remedy import Changes, digits
from ..sheet.text import EMPTY, Name, Text
from ..sheet.units import UNITS, Kilogram, Metre, Number, Second, Watt
from ..sheet.value import untraced
from .inputs import BearingsInputs
from .plain.bearing import PlainBearing
from .plain.selection.ranking import ONE_PER_CENT
from .plain.selection.search import BearingsFound, Settled, slopes_of
from .plain.selection.states import against, short_mm
from .plain.selection.together import SharedFound
from .plain.selection.variants import SelectionCase, Solution, crossings
from .plain.selection.writing import with_row
from .result import BearingsResult
from .rolling.bearing import RollingBearing
from .rolling.geometry import STEEL
from .rolling.search import Candidate, Place, Seated, candidates, nearest_rows, seated
from .rolling.solve import rows_of

VERIFIED = 4  # rows with rolling bearings that are solved as whole designs before they are shown
TRIED = 12  # of which at most so many are looked at
EACH = {2: 8, 3: 4}  # rolling bearings of a place that are combined with those of the others, by how many places
AT_LEAST = 2  # of more places
MOST = 16  # rows with rolling bearings
PlainFound = BearingsFound | SharedFound  # of two bearings, of more that share their load
TYPES = ("ball", "roller", "needle", "cup", "cage")


@record
class Side:
    """One bearing of a row.  `type`: plain, or of the elements of a rolling one; `life`: None of a film."""

    row: BearingRow  # as it then stands in the design
    type: str
    loss: Watt  # over the duty
    mass: Kilogram
    seat: Metre
    life: Second | None
    cautions: tuple[str, ...] = ()  # names of the checks that would warn

    @property
    def words(self) -> Text:
        if self.type != "plain":
            return Name(self.row.size or "")
        return Text("{d}×{l}", d=short_mm(self.row.diameter), l=short_mm(self.row.length))


@record
class ChoiceRow:
    """All bearings of a shaft, front to rear, and what all shafts share.  `plain`: which row of the plain search, from
    1; 0: none."""

    sides: tuple[Side, ...]
    inputs: BearingsInputs
    plain: int = 0

    @property
    def loss(self) -> Watt:
        return sum(side.loss for side in self.sides)

    @property
    def mass(self) -> Kilogram:
        return sum(side.mass for side in self.sides)

    @property
    def seat(self) -> Metre:
        return max(side.seat for side in self.sides)

    @property
    def life(self) -> Second | None:
        """Of the one that lives shortest; None: films alone."""
        return min((side.life for side in self.sides if side.life is not None), default=None)

    @property
    def types(self) -> tuple[str, ...]:
        return tuple(side.type for side in self.sides)


@record
class KindsFound:
    """What there is to choose.  `plain`: what the plain search found, None where it found nothing, and `why_plain`.

    `rows`: in order, numbered from 1; `now`: the design, None where it has no answer.  `verified`: numbers of the rows
    that are solved as whole designs; `elsewhere`: by number what is then open and was not before.  `missing`: types
    without a row, and why; `dropped`: rows that the whole design refuses."""

    case: SelectionCase
    aim: str
    plain: PlainFound | None
    why_plain: Text
    rows: tuple[ChoiceRow, ...]
    now: ChoiceRow | None
    verified: tuple[int, ...]
    elsewhere: Mapping[int, tuple[Check, ...]]
    missing: tuple[tuple[str, Text], ...]
    dropped: tuple[Text, ...]

    @property
    def count(self) -> int:
        """Of all that may be taken: behind the rows stand plain ones that are too long, and those with more film."""
        found = self.plain
        return len(self.rows) + (len(found.all) - len(found.rows) if isinstance(found, BearingsFound) else 0)

    def row(self, number: int) -> ChoiceRow:
        if number <= len(self.rows):
            return self.rows[number - 1]
        found = self.plain
        assert isinstance(found, BearingsFound)
        return _plain_row(found, number - len(self.rows) + len(found.rows), {})


# --- the order


def order(row: ChoiceRow, aim: str) -> tuple[float, ...]:
    """loss: the least over the duty, within 1 % of each other alike as in the search for plain ones; size: the smallest
    seats."""
    alike = round(math.log(row.loss) / ONE_PER_CENT)
    return (round(sum(side.seat for side in row.sides), 6), alike) if aim == "size" else (alike,)


def unbeaten(rows: Sequence[ChoiceRow]) -> list[ChoiceRow]:
    """Those that no other beats in loss, mass, seat and life at once; films live as long as wanted."""
    numbers = np.array([(row.loss, row.mass, row.seat, -(row.life or math.inf)) for row in rows])
    return [
        row for row, own in zip(rows, numbers) if not ((numbers <= own).all(axis=1) & (numbers < own).any(axis=1)).any()
    ]


# --- the search


def choice(
    case: SelectionCase,
    places: Mapping[str, Place],
    plain: PlainFound | None,
    why_plain: Text,
    aim: str = "loss",
    progress: Progress | None = None,
) -> KindsFound:
    """Rows of both kinds.  `places`: the bearings as rolling ones are sought for them; `plain`: what the search for
    plain ones found, with the design or with plain bearings in place of its rolling ones.

    Raises NoSolution where there is no row of any kind."""
    shares = {place: _duty_share(case.seen(case.results), at) for place, at in places.items()}
    plain_rows = _plain_rows(plain, shares) if plain is not None else []
    rolling = dict[str, list[Side]]()
    stopped = dict[str, list[tuple[str, Text]]]()  # types without a bearing, by place
    each = EACH.get(len(places), AT_LEAST)
    for place, at in places.items():
        tell(progress, 0.1, called(place))
        rolling[place], stopped[place] = _rolling_sides(at, each)
    base = plain_rows[0] if plain_rows else None
    beside = _plain_sides(case, base, places, shares)
    inputs = base.inputs if base is not None else case.bearings
    mixed = list(_together(case, rolling, beside, inputs, places, aim))
    kept, elsewhere, dropped = list[ChoiceRow](), dict[int, tuple[Check, ...]](), list[Text]()
    if not mixed and any(rolling.values()):
        dropped.append(Text("the sectors pass none of their seats"))
    tried, solved = 0, list[ChoiceRow]()
    for row in mixed:
        if len(solved) == VERIFIED or tried == TRIED:
            kept.append(row)
            continue
        tried += 1
        tell(progress, 0.2 + 0.8 * tried / TRIED, words_of(row))
        settled = confirmed(case, row)
        if settled.results is None or settled.why:
            dropped.append(settled.why)
            continue
        kept.append(row)
        solved.append(row)
        if settled.broken:
            elsewhere[id(row)] = settled.broken
    if tried == TRIED and not solved:
        kept = []  # what was tried is refused: the others are not known
    rows = sorted([*plain_rows, *kept], key=lambda row: order(row, aim))
    if not rows:
        why = dropped[0] if dropped else next((text for some in stopped.values() for _, text in some), EMPTY)
        raise NoSolution(Text("no bearings of any kind pass"), why_plain or why, why if why_plain else EMPTY)
    number = {id(row): n for n, row in enumerate(rows, 1)}
    return KindsFound(
        case,
        aim,
        _named(plain, tuple(number[id(row)] for row in plain_rows), len(rows)),
        why_plain,
        tuple(rows),
        _as_it_is(case, places),
        tuple(sorted(number[id(row)] for row in solved)),
        {number[key]: checks for key, checks in elsewhere.items()},
        tuple(_missing(rows, stopped, dropped)),
        tuple(dropped),
    )


def _named(plain: PlainFound | None, named: tuple[int, ...], behind: int) -> PlainFound | None:
    if isinstance(plain, BearingsFound):
        return replace(plain, named=named, behind=behind)
    return None if plain is None else replace(plain, named=named)


def words_of(row: ChoiceRow) -> Text:
    return Text(" + ").join(side.words for side in row.sides)


def _missing(
    rows: Iterable[ChoiceRow], stopped: Mapping[str, list[tuple[str, Text]]], refused: Sequence[Text]
) -> Iterator[tuple[str, Text]]:
    """Types of which no row has one, with what stops them where they come nearest; "": rolling bearings of any."""
    there = {type for row in rows for type in row.types}
    told = dict[str, Text]()
    if refused and there == {"plain"}:
        told[""] = Text("No row with rolling bearings: {why}", why=refused[0])
    for some in stopped.values():
        for type, why in some:
            if type not in there:
                told.setdefault(type, why)
    yield from told.items()


# --- plain bearings among them


def _duty_share(results: Solution, at: Place) -> Number:
    """The mean loss of a plain bearing over the duty over that at the rated point; without a film to tell it, 1."""
    rows = rows_of(at.inputs, at.task)
    there = results.result(BearingsResult)
    r = there.bearings.get(at.row.name) if there is not None else None
    if rows is None or not isinstance(r, PlainBearing):
        return 1.0
    with untraced():
        powers = r.answer_at(rows.n / at.task.speed, rows.T_oil, None, rows.factor).friction_power
    mean = float(np.sum(rows.share * powers)) / r.friction_power
    return mean if math.isfinite(mean) else 1.0


def _plain_rows(found: PlainFound, shares: Mapping[str, Number]) -> list[ChoiceRow]:
    return [_plain_row(found, n, shares) for n in range(1, len(found.rows) + 1)]


def _plain_row(found: PlainFound, n: int, shares: Mapping[str, Number]) -> ChoiceRow:
    if isinstance(found, BearingsFound):
        row = found.all[n - 1]
        every = row.picks
    else:
        row, every = found.rows[n - 1].row, found.rows[n - 1].every
    inputs, after = with_row(found.case, row)
    powers = {pick.task.place: pick.power for pick in every}
    there = found.case.seen(found.case.results).result(BearingsResult)
    for own in after:  # what carries next to nothing is not judged, and turns as it did
        if own.name not in powers:
            powers[own.name] = there.bearings[own.name].friction_power if there is not None else 0.0
    sides = tuple(_plain_side(own, powers[own.name] * shares.get(own.name, 1.0)) for own in after)
    return ChoiceRow(sides, inputs, n)


def _plain_side(row: BearingRow, loss: Watt) -> Side:
    return Side(row, "plain", loss, bush_mass(row), seat_of(row), None)


def bush_mass(row: BearingRow) -> Kilogram:
    """Of what is put in between journal and housing, by its volume as if of steel; of a bare bore none."""
    return math.pi / 4 * (seat_of(row) ** 2 - row.diameter**2) * row.length * STEEL


def seat_of(row: BearingRow) -> Metre:
    return row.diameter + 2 * (row.wall[-1] if row.ringed and row.wall is not None else 0.0)


def _plain_sides(
    case: SelectionCase, base: ChoiceRow | None, places: Mapping[str, Place], shares: Mapping[str, Number]
) -> dict[str, Side]:
    """The plain bearing of each place that may stand beside rolling ones: of the best plain row, else the design's own
    where it keeps its limits."""
    if base is not None:
        return {side.row.name: side for side in base.sides}
    now = _as_it_is(case, places)
    checks = case.seen(case.results).outcomes["bearings"].checks
    failing = [c.id for c in checks if c.verdict == "fail"]
    return {
        side.row.name: side
        for side in (now.sides if now is not None else ())
        if side.type == "plain" and not any(f".{side.row.name}." in id for id in failing)
    }


def _as_it_is(case: SelectionCase, places: Mapping[str, Place]) -> ChoiceRow | None:
    """The design; None where its bearings have no answer."""
    there = case.seen(case.results).result(BearingsResult)
    if there is None:
        return None
    sides = []
    for row in case.rows:
        r: Any = there.bearings[row.name]
        if isinstance(r, RollingBearing):
            life = r.life
            sides.append(Side(row, r.case.size.type, r.duty_loss, r.bearing_mass, r.seat_diameter, life))
        else:
            share = _duty_share(case.seen(case.results), places[row.name])
            sides.append(_plain_side(row, r.friction_power * share))
    return ChoiceRow(tuple(sides), case.bearings)


# --- rolling bearings among them


def _rolling_sides(at: Place, wanted: int) -> tuple[list[Side], list[tuple[str, Text]]]:
    """The best of each type in a place, then those of least loss, so many in all; and the types without one."""
    every = candidates(at)
    if not every:
        low, high = map(short_mm, at.bores)
        none = Text(
            "No rolling bearing at the {place} journal: none has a bore of {low} to {high} mm, which the shaft asks "
            "for there",
            place=called(at.row.name),
            low=low,
            high=high,
        )
        return [], [("", none)]
    found, stopped = list[Seated](), list[tuple[str, Text]]()
    for type in TYPES:
        of_type = [one for one in every if one.size.type == type]
        if not of_type:
            continue
        best, loose = seated(at, of_type, 1)
        found += best
        if not best:
            near = min(of_type, key=lambda one: (len(one.fails), -(one.life or 0.0)))
            stopped.append((type, _why_not(at, near, bool(loose))))
    more, _ = seated(at, every, wanted)
    others = [one for one in more if all(one.row.size != other.row.size for other in found)]
    found += others[: max(wanted - len(found), 0)]
    return [_side(one) for one in sorted(found, key=lambda one: one.candidate.loss)], stopped


def _side(one: Seated) -> Side:
    c = one.candidate
    return Side(
        one.row, c.size.type, c.loss, c.mass, c.seat, c.life, tuple(str(rule.short or rule.name) for rule in c.risks)
    )


def _why_not(at: Place, nearest: Candidate, loose: bool) -> Text:
    place = called(at.row.name)
    if loose:
        return Text("{place}: no class and fits leave clearance and grip", place=place)
    broken = nearest.fails[0]
    return Text(
        "{place}: {size} fails {limit}",
        place=place,
        size=Name(nearest.size.designation),
        limit=broken.short or broken.name,
    )


def _together(
    case: SelectionCase,
    rolling: Mapping[str, list[Side]],
    beside: Mapping[str, Side],
    inputs: BearingsInputs,
    places: Mapping[str, Place],
    aim: str,
) -> Iterator[ChoiceRow]:
    """Rows with a rolling bearing at least, in order: the best of each combination of types, and what none beats."""
    options = [[*rolling[place], *([beside[place]] if place in beside else [])] for place in places]
    if not all(options):
        return
    every = [
        ChoiceRow(sides, inputs if any(side.type == "plain" for side in sides) else case.bearings)
        for sides in product(*options)
        if any(side.type != "plain" for side in sides) and threads(case, sides)
    ]
    every.sort(key=lambda row: (*order(row, aim), row.mass, row.loss))
    first = {row.types: row for row in reversed(every)}
    chosen = [row for row in every if first[row.types] is row][:MOST]
    for row in unbeaten(every):
        if len(chosen) >= MOST:
            break
        if row not in chosen:
            chosen.append(row)
    yield from sorted(chosen, key=lambda row: (*order(row, aim), row.mass, row.loss))


def threads(case: SelectionCase, sides: Sequence[Side]) -> bool:
    """Whether the sectors pass a seat of these, where they have to."""
    return case.shaft is None or max(side.seat for side in sides) >= case.shaft.seat_asked


# --- a row in the whole design


def confirmed(case: SelectionCase, row: ChoiceRow) -> Settled:
    """A row with rolling bearings through the whole solution.  `why`: what refuses it; empty: nothing."""
    results = case.solve(row.inputs, tuple(side.row for side in row.sides))
    seen, before = case.seen(results), {c.id for c in case.results.checks() if c.verdict == "fail"}
    there, again = seen.outcomes["bearings"], slopes_of(case, results)
    failing = [c for c in there.checks if c.verdict == "fail"]
    failing += [c for c in crossings(seen) if c.id not in before]
    failing += [
        c
        for c in seen.outcomes["countershaft"].checks
        if c.verdict == "fail" and c.id not in before and c.rule is not JOURNAL_SLOPE
    ]
    if there.state != "solved" or failing:
        why = against(failing[0]) if failing else there.reason
        return Settled(None, again, (), Text("{row}: {why}", row=words_of(row), why=why), results)
    mine = {c.id for c in (*there.checks, *seen.outcomes["countershaft"].checks)}
    others = [c for c in results.checks() if c.verdict == "fail" and c.id not in before and c.id not in mine]
    return Settled(None, again, tuple(others), results=results)


# --- a row in the file


def changes(case: SelectionCase, row: ChoiceRow) -> Changes:
    """The keys that put a row into the design: what its bearings say, and of those of another kind nothing any more."""
    written = _differences("bearings", case.bearings, row.inputs)
    for before, side in zip(case.rows, row.sides):
        written |= row_changes(case, before, side.row)
    return written


def row_changes(case: SelectionCase, before: BearingRow, after: BearingRow) -> Changes:
    """The same of one bearing."""
    here = f"{case.place}.{before.name}"
    written = _differences(here, before, after)
    if before.clearance_limits is not None and after.clearance_limits is None:
        written.setdefault(f"{here}.{dotted(BearingRow.clearance)}", None)  # under which they may stand
    return written


def nearest_changes(case: SelectionCase, place: Place) -> Iterator[Changes]:
    """How the rolling bearing of a place could sit, and other sizes with how they sit, the nearest first."""
    there = case.seen(case.results).result(BearingsResult)
    now = there.bearings.get(place.row.name) if there is not None else None
    if isinstance(now, RollingBearing):
        for row in nearest_rows(place, now.running_temperature):
            yield row_changes(case, place.row, row)


def _differences(place: str, before: object, after: object) -> Changes:
    """The keys of one table that are not the same, as they then stand in the file; None: left out."""
    kind: type = type(after)
    were = {key: content for key, _, content in given(before, place)}
    now = {key: (about, content) for key, about, content in given(after, place)}
    usual = {f"{place}.{key}": entry.field.default for key, entry in keys(kind).items()}
    found: Changes = {key: None for key in were if key not in now}
    for key, (about, content) in now.items():
        if were.get(key) != content:
            found[key] = None if usual.get(key) == content else _written(about, content)
    return found


def _written(about: Quantity, content: Any) -> object:
    if about.kind == "number":
        return digits(about.units.shown(content))
    if about.kind == "series":
        return [digits(about.units.shown(number)) for number in content]
    return content


def plain_case(case: SelectionCase, places: Mapping[str, Place]) -> SelectionCase:
    """The same design with a plain bearing wherever a rolling one stands, from which the plain search begins; what it
    lacks of oil supply is proposed."""
    if all(row.kind == "plain" for row in case.rows):
        return case
    rows = tuple(as_plain(places[row.name]) if row.kind != "plain" else row for row in case.rows)
    widest = case.shaft.seat_asked if case.shaft is not None else 0.0
    if widest > max(row.opening() for row in rows):
        through = max(range(len(rows)), key=lambda i: case.rows[i].opening())  # the sectors go on through the same one
        rows = tuple(begun(row, widest) if i == through else row for i, row in enumerate(rows))
    proposed: dict[str, Any] = {
        name: value for name, value in SUPPLY_PROPOSED.items() if getattr(case.bearings, name) is None
    }
    if case.bearings.supply not in (None, "hole", "shaft"):
        proposed.pop("hole_diameter", None)
    inputs = replace(case.bearings, **proposed)
    shaft = None if case.shaft is None else replace(case.shaft, bearings=rows)
    return replace(case, bearings=inputs, rows=rows, shaft=shaft, results=case.solve(inputs, rows))


SUPPLY_PROPOSED: dict[str, object] = {"supply": "hole", "hole_diameter": 4e-3, "supply_pressure": 4e5}
LENGTH, PSI = 0.5, 1.5e-3  # of the diameter, where the search begins
# Ra: a journal ground and lapped, a bore finely bored
LAPPED, BORED = (UNITS["µm"].inside(Ra) for Ra in (0.2, 0.4))


def as_plain(place: Place) -> BearingRow:
    """The row of a place with a plain bearing to begin with: as thick as the shaft is there, or its core."""
    row = place.row
    there = row.on_shaft
    kept = ("name", "position", "load", "offset", "slope", "carrier_bore", "carrier", "housing_material")
    said: dict[str, Any] = {name: getattr(row, name) for name in kept}
    begins = BearingRow(diameter=1.0, length=1.0, journal_roughness=LAPPED, housing_roughness=BORED, **said)
    return begun(begins, max(there[0] if there is not None else 0.0, place.bores[0]))


def begun(row: BearingRow, d: Metre) -> BearingRow:
    """A plain bearing of some diameter, its length and clearance in proportion."""
    d = math.ceil(d * 1e3 - 1e-6) / 1e3
    return replace(row, diameter=d, length=round(LENGTH * d, 4), clearance=round(PSI * d, 6))
