# SPDX-License-Identifier: Apache-2.0
"""Other shafts than one at −1: pairs at ±1 and ±2, one at ±2, two at −1.

They lie in a module that is parted at their axes, so that nothing has to pass a seat: a journal is as thick as the
core, and core and outer radius grow together until the bearings hold.  Shells of journals of one size are picked by
classes; where shafts have different ones they lie as close by their fits.  A force at twice crank speed gets three
plain bearings, one cylinder pitch apart, or two rolling ones, whose rings pass no sectors, half a pitch on either side
of it; all else two."""

import math
from collections.abc import Iterator

from ...bearings.inputs import BearingsInputs
from ...bearings.plain.selection.variants import STANDARD
from ...bearings.result import BearingsResult
from ...countershaft.inputs import ShaftInputs
from ...countershaft.rows import BearingRow
from ...countershaft.sizing.sectors import Sized, TooSmall
from ...countershaft.sizing.stretches import SizedStretches, gap_of, size_between
from ...design.addresses import Table, as_list, as_table, own_shafts
from ...design.model import Design
from ...design.toml_file import Document, design
from ...engine.result import EngineResult
from ...imbalance.checks import FIRST
from ...imbalance.result import ImbalanceResult
from ...sheet.errors import NoSolution
from ...sheet.quantity import dotted
from ...sheet.record import record, replace
from ...sheet.text import Text
from ...sheet.units import Kilogram, Metre, Newton, Watt
from ...sheet.value import untraced
from ...solve import Results, solve
from . import rolling
from .journals import BEARINGS, OILS, PRESSURE, PSI, RATIO, estimated_length, oil_of, select, shared, shell, wall_of
from .rolling import PLAIN
from .shaft import FILLET, NAME, OVERDESIGN, SHAFT, STEEL, UTILISATION, StarterTask, task
from .writing import BEARING_ROW, Rows, Section, down, head, mm, table, up

ROWS, SHAFTS = dotted(ShaftInputs.bearings), dotted(Design.shafts)
JOURNALS = tuple(d / 1000 for d in STANDARD if 22 <= d <= 60)  # m: diameters that are tried; a wheel sits on the core
WIDEST: Metre = 0.1  # outer radius
LARGEST = 7e6  # Pa: no journal is looked at that would carry more
FIT = "IT5"  # of journal and seat, where no classes pick the shells
FAILS = 1000  # more than there are cautions
APART: Metre = 5e-3  # between what turns
GEAR: Metre = 15e-3  # from the front journal to the middle of the widest wheel, and a fillet
MIRRORS, REPEATS = dotted(ShaftInputs.mirrors), dotted(ShaftInputs.repeats)


@record
class Arranged:
    """One shaft that is built, its ratio to the crank, and the name and the kind of its twin ("" where it has none)."""

    name: str
    ratio: int
    twin: str = ""
    how: str = MIRRORS


def second_shafts(imbalance: ImbalanceResult) -> tuple[int, bool] | None:
    """Speed ratio of the shaft against the second order, and whether it has a mirrored twin; None where two unlike ones
    would be needed."""
    shafts = imbalance.remedy["second_order_shafts"].shafts
    if len(shafts) == 1:
        return round(next(iter(shafts.values())).speed_ratio), False
    return (2, True) if _mirrored(*imbalance.orders["order_2"].vectors) else None


def first_pair(imbalance: ImbalanceResult) -> bool:
    """Whether one shaft at crank speed and its mirrored twin take the first order."""
    return "first_order_pair" in imbalance.remedy and _mirrored(*imbalance.orders["order_1"].unbalanced)


def _mirrored(F_f: complex, F_b: complex, C_f: complex, C_b: complex) -> bool:
    """Whether what turns backward is the mirror image of what turns forward, within what a good shaft may leave."""
    return all(abs(b.conjugate() - f) <= FIRST * abs(f) for f, b in ((F_f, F_b), (C_f, C_b)))


def arrangement(balancing: str, imbalance: ImbalanceResult) -> tuple[Arranged, ...]:
    """The shafts of a balancing that asks for others than one at −1.  Raises NoSolution where they would be no mirror
    images."""
    second = second_shafts(imbalance) if "second" in balancing else None
    if balancing == "repeat":
        return (Arranged("left", -1, "right", REPEATS),)
    first = (Arranged("left", 1, "right"),) if "pair" in balancing and first_pair(imbalance) else ()
    if ("pair" in balancing and not first) or ("second" in balancing and second is None):
        raise NoSolution(Text("the shafts of this balancing are no mirror images: write each as a shaft of its own"))
    if second is None:
        return first
    ratio, mirrored = second
    if not mirrored:
        return (*first, Arranged("second" if first else NAME, ratio))
    names = ("second-left", "second-right") if first else ("left", "right")
    return (*first, Arranged(names[0], ratio, names[1]))


def shafts(
    document: Document, results: Results, arranged: tuple[Arranged, ...], kinds: tuple[str, ...] = ()
) -> list[Section]:
    """The tables of all shafts, each with the thinnest core whose journals hold in plain bearings, or in the rolling
    ones of these `kinds`; where none does with the thickest.  Raises NoSolution where no envelope has room."""
    rolls = _roll(kinds)
    each = [_shaft(results, one, _thinnest(document, results, one, kinds), rolls) for one in arranged]
    return [section for sections in each for section in sections]


def _thinnest(document: Document, results: Results, one: Arranged, kinds: tuple[str, ...]) -> Metre:
    on_rolling = _roll(kinds)
    least = 0.0 if on_rolling else math.sqrt(_load(results, one) / (RATIO * LARGEST))
    found: tuple[float, Metre] | None = None
    thicker = 0  # that were no better than one that carries
    for diameter in (d for d in (rolling.BORES if on_rolling else JOURNALS) if d >= least):
        try:
            tried = _shaft(results, one, diameter, on_rolling)
        except NoSolution:
            continue
        with_it = Document({**document.data, **table(tried)})
        worse = _on_rolling(with_it, results, kinds) if on_rolling else _on_plain(with_it, results)
        thicker = thicker + 1 if found is not None and FAILS - 1 > found[0] <= worse else 0
        if found is None or worse < found[0]:
            found = worse, diameter
        # a cage that turns slowly enough is small: what a much thicker shaft leaves to be said of needles is no less
        if worse == 0 or (thicker == 2 and {*kinds} <= {rolling.NEEDLE, rolling.CAGE}):
            break
    if found is None:
        raise NoSolution(SHAFT, Text("journals up to 60 mm, outer radii up to 100 mm"), Text("give [[shafts]]"))
    return found[1]


def _roll(kinds: tuple[str, ...]) -> bool:
    """Whether all bearings of these kinds are rolling ones."""
    return bool(kinds) and PLAIN not in kinds


def _on_plain(document: Document, results: Results) -> int:
    """How much is to be said of the first plain bearings of which least is."""
    return _best(document, solve(design(document), results), OILS[:1], first=True)[0]


def _on_rolling(document: Document, results: Results, kinds: tuple[str, ...]) -> float:
    """The same of rolling ones, and of the shaft on them; where none carry, the less the longer they live."""
    with_duty = rolling.with_duty(document, design(document))
    try:
        return rolling.best(with_duty, solve(design(with_duty), results), kinds)[0]
    except rolling.NoneCarries as none:
        return FAILS - none.nearest
    except NoSolution:
        return FAILS


def bearings(document: Document, results: Results) -> Document:
    """The document with plain bearings of all its shafts, whose journals are as thick as they have them, or their core.
    Raises NoSolution where none keep every limit."""
    worse, _, found = _best(document, results, OILS)
    if worse >= FAILS:
        raise NoSolution(BEARINGS, Text("clearances of usual size with usual oils"), Text("thicker cores"))
    return found


def _best(
    document: Document, results: Results, oils: tuple[str, ...], *, first: bool = False
) -> tuple[int, Watt, Document]:
    """With the oil and the clearance of which least is to be said, of these with the least friction; and how much that
    is: the cautions that are open, FAILS where a limit fails.  `first`: with the first of which nothing is."""
    found: tuple[int, Watt, Document] | None = None
    for oil in oil_of(results.design, oils):
        for psi in reversed(PSI):
            tried = judged_document(document, results.design, oil, psi)
            solved = solve(design(tried), results, compared=False)
            outcomes = [solved.outcomes[step] for step in ("countershaft", "bearings")]
            worse = sum(c.kind == "caution" and c.open for outcome in outcomes for c in outcome.checks)
            if any(outcome.verdict not in ("pass", "warn") for outcome in outcomes):
                worse += FAILS
            films = [view.result(BearingsResult) for view in solved.views.values()]
            power = sum(b.friction_power for of_shaft in films if of_shaft for b in of_shaft.bearings.values())
            if found is None or (worse, power) < found[:2]:
                found = worse, power, tried
            if worse == 0:  # of one oil the widest that holds has the least friction
                if first:
                    return found
                break
    assert found is not None
    return found


def judged_document(document: Document, made: Design, oil: str, psi: float) -> Document:
    """With [bearings], and with what the rows of all shafts that are no twins need there."""
    own = own_shafts(document.data)
    sizes = {n: 2e-3 * _core(shaft) for n, shaft in own.items()}
    document = replace(document, data={**document.data, **table(_shared(made, oil, set(sizes.values()), psi))})
    for n, shaft in own.items():
        needed = _in_tables(_row(sizes[n], psi, alike=len(set(sizes.values())) == 1))
        rows = [{**as_table(row), **needed} for row in as_list(shaft.get(ROWS))]
        document = document.with_value(dotted(SHAFTS, n, ROWS), rows)
    return document


def _shared(made: Design, oil: str, sizes: set[Metre], psi: float) -> list[Section]:
    """Of journals of one size with their classes, else with fits that are as close."""
    of_all = shared(made, oil)
    if len(sizes) == 1:
        return [*of_all, select(min(sizes), psi)]
    (header, rows), *others = of_all
    close = "assumed: as close as shells that are picked by classes"
    fits: Rows = {BearingsInputs.journal_fit: (FIT, close), BearingsInputs.seat_fit: (FIT, close)}
    return [(header, rows | fits), *others]


def _row(diameter: Metre, psi: float, *, alike: bool) -> Rows:
    rows = shell(diameter, estimated_length(diameter))
    if alike:
        return rows
    return rows | {
        BearingRow.wall: (mm(wall_of(diameter)), "assumed"),
        BearingRow.clearance: (float(round(psi * diameter * 1e6)), f"assumed: {psi * 1e3:g} ‰"),
    }


def _core(shaft: Table) -> float:
    """In mm; where it is not given that of a journal of 30 mm."""
    return float(shaft.get(dotted(ShaftInputs.core_radius), 15.0))  # type: ignore[arg-type]


def _in_tables(rows: Rows) -> Table:
    return {dotted(field): value for field, (value, _) in rows.items()}


def _task(results: Results, one: Arranged) -> StarterTask:
    """What one shaft supplies: of two that repeat each other half."""
    whole = task(results, one.ratio)
    return replace(whole, F=whole.F / 2, C=whole.C / 2) if one.how == REPEATS and one.twin else whole


def _places(results: Results, one: Arranged, todo: StarterTask, rolls: bool = False) -> tuple[Metre, ...]:
    """Where the bearings stand; `rolls`: they are rolling ones."""
    engine, train = results.design.engine, results.result(EngineResult)
    assert engine is not None and train is not None
    pitch = train.crank.pitch
    row = float(max(train.crank.z) - min(train.crank.z)) + pitch
    if abs(one.ratio) == 2 and abs(todo.C) <= 0.01 * row * abs(todo.F):
        apart = up(max(pitch, 0.75 * engine.bore), 1e-3)
        return (-apart / 2, apart / 2) if rolls else (-apart, 0.0, apart)
    half = up(max(row, 1.5 * engine.bore), 2e-3) / 2
    return -half, half


def _load(results: Results, one: Arranged) -> Newton:
    """On one bearing, as if all carried alike."""
    todo = _task(results, one)
    places = _places(results, one, todo)
    return abs(todo.F) / len(places) + abs(todo.C) / (2 * places[-1])


def estimated_mass(results: Results, one: Arranged) -> Kilogram:
    """Of the eccentric masses of a shaft and its twin, with journals by their load alone."""
    diameter = up(math.sqrt(_load(results, one) / (RATIO * PRESSURE)), JOURNALS[1] - JOURNALS[0])
    return float(_sized(results, one, max(diameter, JOURNALS[0]))[-1].mass) * (2 if one.twin else 1)


def _sized(
    results: Results, one: Arranged, diameter: Metre, rolls: bool = False
) -> tuple[tuple[Metre, ...], Metre, Metre, Sized | SizedStretches]:
    """The places of the bearings, half the length of the sectors, the smallest outer radius whose utilisation is
    comfortable, and the sectors.  Raises NoSolution."""
    todo = _task(results, one)
    places, length, core = _places(results, one, todo, rolls), estimated_length(diameter), diameter / 2
    half_length = down(places[-1] - length / 2 - 2 * FILLET, 0.5e-3)
    rho = results.design.materials[STEEL].density
    with untraced():
        U, P = (-(1 + OVERDESIGN) * vector / todo.omega**2 for vector in (todo.F, todo.C))
        gaps = tuple((z, gap_of(l=length, r=FILLET)) for z in places[1:-1])
        for outer in _radii(core):
            try:
                sized = size_between(U, P, todo.omega, rho, outer, core, half_length, gaps, (), FILLET)
            except TooSmall:
                continue
            if sized.utilisation <= UTILISATION:
                return places, half_length, outer, sized
    raise NoSolution(SHAFT, Text("outer radii up to 100 mm"))


def _shaft(results: Results, one: Arranged, diameter: Metre, rolls: bool = False) -> list[Section]:
    """The tables of a shaft and its twin; `rolls`: on rolling bearings.  Raises NoSolution."""
    engine, length, core = results.design.engine, estimated_length(diameter), diameter / 2
    assert engine is not None
    places, half_length, outer, sized = _sized(results, one, diameter, rolls)
    side = up(max(outer + APART, core + 4 * APART, 0.75 * engine.bore), 5e-3)
    beneath = up(2 * engine.crank_radius + outer, 5e-3)
    axis = (-beneath, -side) if abs(one.ratio) == 2 else (0.0, -beneath)
    why = "assumed: the smallest with a utilisation up to {limit:g}; here {used:.2f}"
    rows: Rows = {
        ShaftInputs.name: (one.name, ""),
        ShaftInputs.mode: ("size", ""),
        ShaftInputs.speed_ratio: (one.ratio, ""),
        ShaftInputs.axis: ([mm(z) for z in axis], "assumed: clear of the crank, whose counterweights are not known"),
        ShaftInputs.assembly: ("split", "assumed: a module that is parted at the axes"),
        ShaftInputs.material: (STEEL, "assumed: a usual shaft steel"),
        ShaftInputs.outer_radius: (mm(outer), why.format(limit=UTILISATION, used=sized.utilisation)),
        ShaftInputs.core_radius: (mm(core), "assumed: the thinnest whose journals hold"),
        ShaftInputs.half_length: (mm(half_length), "assumed: two fillets short of the journals"),
        ShaftInputs.fillet_radius: (mm(FILLET), "assumed"),
        ShaftInputs.overdesign: (OVERDESIGN * 100, "assumed: for what making leaves"),
        ShaftInputs.gear_z: (
            mm(places[0] - up(length / 2 + GEAR, 1e-3)),
            "assumed: overhung, before the front bearing",
        ),
    }
    if len(places) > 2:
        rows[ShaftInputs.gap] = (mm(gap_of(l=length, r=FILLET)), "assumed: the journal and two fillets on either side")
    sections: list[Section] = [(head(Design.shafts), rows)]
    names = ("front", "middle", "rear") if len(places) == 3 else ("front", "rear")
    for name, z in zip(names, places):
        apart = "as long as the row of cylinders, or 1.5 bores"
        if len(_places(results, one, _task(results, one))) == 3:
            apart = "a cylinder pitch apart"
        bearing: Rows = {
            BearingRow.name: (name, ""),
            BearingRow.position: (mm(z), f"assumed: {apart}"),
        }
        sections.append((BEARING_ROW, bearing))
    if one.twin:
        opposite: Rows = {ShaftInputs.name: (one.twin, "")}
        if one.how == REPEATS:
            opposite[ShaftInputs.repeats] = (one.name, "a second one, alike, on the other side")
            opposite[ShaftInputs.axis] = ([mm(axis[0]), mm(-axis[1])], "assumed")
        else:
            opposite[ShaftInputs.mirrors] = (one.name, "its mirror image, turning the other way")
        sections.append((head(Design.shafts), opposite))
    return sections


def _radii(core: Metre) -> Iterator[Metre]:
    for step in range(math.ceil((core + 1e-3) / 0.5e-3), round(WIDEST / 0.5e-3) + 1):
        yield step * 0.5e-3


def completed(sections: list[Section], document: Document) -> list[Section]:
    """The sections of the shafts with what their bearings have in the document beside it."""
    made = design(document)
    bearings = made.bearings
    assert bearings is not None
    sizes = {row.diameter for view in made.views.values() for row in view.rows}
    first = made.rows[0]
    if bearings.select is not None:
        middle = (bearings.select.clearance_band[0] + bearings.select.clearance_band[-1]) / 2
    else:
        middle = first.clearance or 0.0
    psi = min(PSI, key=lambda psi: abs(psi - middle / first.diameter))
    whole: list[Section] = []
    needed: Rows = {}
    for header, rows in sections:
        if ShaftInputs.core_radius in rows:
            core = float(rows[ShaftInputs.core_radius][0])  # type: ignore[arg-type]
            needed = _row(2e-3 * core, psi, alike=len(sizes) == 1)
        whole.append((header, rows | needed if header == BEARING_ROW else rows))
    return [*whole, *_shared(made, bearings.oil, sizes, psi)]
