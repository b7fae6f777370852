# SPDX-License-Identifier: Apache-2.0
"""The shaft and its bearings: the smallest envelope that carries what is asked, and bearings that hold in it.

The envelope has room to spare, and a core that keeps its journals straight."""

import math
from dataclasses import replace
from itertools import product

import numpy as np

from ...bearings.inputs import BearingsInputs
from ...bearings.selection.search import bearing_changes, nearest_row
from ...bearings.selection.variants import Variant
from ...countershaft import formulas as f
from ...countershaft.inputs import Holes, ShaftInputs
from ...countershaft.making.unbalance import calibration
from ...countershaft.result import CountershaftResult
from ...countershaft.rows import BearingRow
from ...countershaft.sizing import formulas as sizes
from ...countershaft.sizing.lengths import utilisation
from ...countershaft.sizing.sectors import Sized, size
from ...design.addresses import Table, own_shafts
from ...design.model import Design
from ...design.step_inputs import bearings_case
from ...design.toml_file import Document, design
from ...engine.result import EngineResult
from ...imbalance.result import ImbalanceResult
from ...library.journal_rules import COOLED, LUBRICATIONS, N_RPM_MM
from ...library.lubricant import Lubricant
from ...sheet.check import THIN_MARGIN
from ...sheet.errors import NoSolution
from ...sheet.linked_array import gathered
from ...sheet.quantity import dotted
from ...sheet.record import record
from ...sheet.text import SEMICOLON, Amount, Text
from ...sheet.units import Metre, Newton, NewtonPerMetreSecond, Radian, RadPerSecond, RevPerSecond
from ...sheet.value import untraced
from ...solve import Results, solve
from .train import HOUSING, passing_seat, tip
from .writing import BEARING_ROW, Rows, Section, changed, down, head, mm, parted, table, up

STEEL = "42CrMo4"
UTILISATION = 0.75
CORES = (0.65, 0.70, 0.75, 0.80, 0.85, 0.90)  # of the outer radius
FILLET = 1.5e-3  # m
SLOPE = 0.2e-3  # rad: of the 0.25 mrad that are accepted
OVERDESIGN, DRILLED = 0.015, 0.03  # what the shaft is made stronger, and what the holes take: twice as much
HEAT_INDEX: NewtonPerMetreSecond = 400e3 * N_RPM_MM  # of the 500 000 N·rpm/mm that are accepted
BEARING = 0.35, 0.75  # length over diameter: of the rear bearing at least, of both at most
THREADED = 0.2e-3
AT_ONCE = 32  # radii that are looked at together
UPSTREAM: tuple[str, ...] = ("schema", "name", "oil", "material", "engine", "imbalance")
SHAFT, GIVE = Text("a counter-shaft to begin with"), Text("give [[shafts]]")
NAME = "shaft"  # what the shaft is called


@record
class StarterTask:
    """What one shaft supplies: force and couple that turn like it, cylinder 1 at TDC; `ratio`: its speed over the
    crank's."""

    ratio: int
    F: complex
    C: complex
    omega: RadPerSecond  # of the shaft
    speed: RevPerSecond


@record
class Envelope:
    """The envelope and the journals that go with it: radii, diameters, and the length of both."""

    span: Metre
    outer: Metre
    core: Metre
    half_length: Metre
    rear: Metre
    length: Metre
    load: Newton
    sized: Sized


def task(results: Results, ratio: int) -> StarterTask:
    """Of the engine whose crank carries the design's share: a shaft at +1 takes all that turns forward, so its crank
    carries none."""
    train, imbalance = results.result(EngineResult), results.result(ImbalanceResult)
    if train is None or imbalance is None:
        raise NoSolution(SHAFT, Text("the engine's imbalance is not known"), Text("give [engine] and [imbalance]"))
    order = imbalance.orders[f"order_{abs(ratio)}"]
    F_f, F_b, C_f, C_b = order.unbalanced if ratio == 1 else order.vectors
    F, C = (F_f, C_f) if ratio > 0 else (F_b, C_b)
    return StarterTask(ratio, F, C, train.angular_speed * abs(ratio), results.design.engine.rated_speed * abs(ratio))  # type: ignore[union-attr]


def envelope(design: Design, results: Results, todo: StarterTask, core: float = CORES[0]) -> Envelope:
    """The smallest outer radius at which the utilisation is comfortable, with the journals that go with it.  Raises
    NoSolution."""
    engine, train = design.engine, results.result(EngineResult)
    assert engine is not None and train is not None
    row = float(max(train.crank.z) - min(train.crank.z)) + train.crank.pitch
    apart = row if abs(todo.ratio) == 1 or abs(todo.C) > 0.01 * row * abs(todo.F) else 0.0
    span = up(max(apart, 1.5 * engine.bore), 2e-3)
    rho = design.materials[STEEL].density
    with untraced():
        U = f.asked_unbalance(x_o=OVERDESIGN, F_like=todo.F, omega=todo.omega)
        P = f.asked_product(x_o=OVERDESIGN, C_like=todo.C, omega=todo.omega)
        F_S, C_S = U * todo.omega**2, P * todo.omega**2
        ends = ((-span / 2, span / 2), (span / 2, -span / 2))
        load = max(abs(f.lever_reaction(C_S=C_S, z_o=z_o, F_S=F_S, z_B=z_B)) for z_B, z_o in ends)
        thicker: list[tuple[Metre, Metre, Metre, Metre, Metre]] = []
        for step in range(20, 400):
            R = step * 0.5e-3
            rear = up(2 * (R + THREADED), 0.5e-3)
            length = _length(load, todo.speed, rear)
            half_length, r_0 = down(span / 2 - length / 2 - 2 * FILLET, 0.5e-3), down(core * R, 0.5e-3)
            if half_length <= 0:
                break
            thicker.append((R, rear, length, half_length, r_0))
        for n in range(0, len(thicker), AT_ONCE):
            some = thicker[n : n + AT_ONCE]
            k = [sizes.unbalance_per_length(rho=rho, R=R, r_0=r_0) for R, _, _, _, r_0 in some]
            alpha = [sizes.force_number(U=U, k=per_length, z_max=z) for per_length, (_, _, _, z, _) in zip(k, some)]
            product = [sizes.product_number(P=P, k=per_length, z_max=z) for per_length, (_, _, _, z, _) in zip(k, some)]
            used = utilisation(np.array(alpha), np.array(product))
            if (fitting := np.flatnonzero(used <= UTILISATION)).size:
                R, rear, length, half_length, r_0 = some[fitting[0]]
                sized = size(U, P, todo.omega, rho, R, r_0, half_length)
                return Envelope(span, R, r_0, half_length, rear, length, load, sized)
    raise NoSolution(SHAFT, Text("outer radii up to 200 mm on a span of {span}", span=Amount(span * 1e3, "mm")), GIVE)


def _length(load: Newton, speed: RevPerSecond, d: Metre, room: Metre = math.inf) -> Metre:
    """Of a journal: as long as its heat index asks, within the usual ratio to its diameter and the room."""
    asked, most = max(load * speed / HEAT_INDEX, BEARING[0] * d), min(BEARING[1] * d, room)
    return min(up(asked, 0.5e-3), down(most, 0.5e-3))


def countershaft(document: Document, results: Results, ratio: int, pair: bool = False) -> list[Section]:
    """The table with the thinnest core on which the slopes of the journals stay below 0.2 mrad.  Raises NoSolution."""
    todo = task(results, ratio)
    for share in CORES:
        size_of = envelope(results.design, results, todo, share)
        sections = _sections(size_of, share, todo, pair, _drill(results.design, todo, size_of))
        if _slope(document, size_of, sections) <= SLOPE:
            return sections
    raise NoSolution(SHAFT, Text("cores up to {share} of the outer radius", share=CORES[-1]), GIVE)


def before_shaft(document: Document) -> Table:
    """The tables of a design up to its imbalance."""
    return {key: document.data[key] for key in UPSTREAM if key in document.data}


def _slope(document: Document, of: Envelope, sections: list[Section]) -> Radian:
    """The larger slope of both journals, by the shaft alone."""
    begun = design(Document({**before_shaft(document), **table(sections)}))
    assert begun.countershaft is not None
    rows = tuple(replace(row, diameter=of.rear, length=of.length) for row in begun.rows)
    loaded = begun.with_shaft(replace(begun.countershaft, bearings=rows))
    shaft = solve(loaded).result(CountershaftResult)
    return max(shaft.slopes.values(), default=math.inf) if shaft is not None else math.inf


def _drill(design: Design, todo: StarterTask, of: Envelope) -> Holes:
    """The narrowest of four holes that together take 3 % of what the shaft supplies."""
    depth = min(down(0.8 * (of.outer - of.core), 0.5e-3), 20e-3)
    places = gathered([of.sized.front.z, of.sized.rear.z])
    with untraced():
        for diameter in range(4, 41):
            holes = Holes(diameter=diameter * 1e-3, depth=depth, count=4)
            takes = calibration(holes, design.materials[STEEL].density, of.outer, places, todo.omega, abs(todo.C))
            enough = holes.count * takes.hole_unbalance * todo.omega**2 >= DRILLED * abs(todo.F)
            if takes.hole_range >= DRILLED * abs(todo.C) and enough:
                return holes
    raise NoSolution(SHAFT, Text("four holes of {depth}, up to 40 mm wide", depth=Amount(depth * 1e3, "mm")), GIVE)


def _sections(of: Envelope, share: float, todo: StarterTask, pair: bool, holes: Holes) -> list[Section]:
    narrowest = f"assumed: the smallest with a utilisation up to {UTILISATION:g}; here {of.sized.utilisation:.2f}"
    more = "" if share == CORES[0] else f", not {CORES[0]:g}, to keep the journals' slopes below 0.2 mrad"
    apart = "assumed: as far apart as the row of cylinders is long, or 1.5 bores"
    shaft: Rows = {
        ShaftInputs.name: (NAME, ""),
        ShaftInputs.mode: ("size", ""),
        ShaftInputs.material: (STEEL, "assumed: a usual shaft steel"),
        ShaftInputs.speed_ratio: (todo.ratio, ""),
        ShaftInputs.outer_radius: (mm(of.outer), narrowest),
        ShaftInputs.core_radius: (mm(of.core), f"assumed: {share:g} of the outer radius{more}"),
        ShaftInputs.half_length: (mm(of.half_length), "assumed: two fillets short of the journals"),
        ShaftInputs.radial_clearance: (mm(THREADED), "assumed: for threading in"),
        ShaftInputs.fillet_radius: (mm(FILLET), "assumed"),
        ShaftInputs.overdesign: (OVERDESIGN * 100, "assumed: half of what the holes are to take"),
    }
    drilled: Rows = {
        Holes.diameter: (mm(holes.diameter), f"assumed: the narrowest that take {DRILLED * 100:g} %"),
        Holes.depth: (mm(holes.depth), "assumed: 0.8 of the sectors' height, at most 20 mm"),
        Holes.count: (holes.count, "assumed: two in each sector"),
    }
    rows: list[Section] = [
        (BEARING_ROW, {BearingRow.name: (name, ""), BearingRow.position: (mm(z), why)})
        for name, z, why in (("front", -of.span / 2, apart), ("rear", of.span / 2, "assumed: as far from mid-shaft"))
    ]
    mirrored: Rows = {
        ShaftInputs.name: ("twin", ""),
        ShaftInputs.mirrors: (NAME, "a mirrored second shaft turns the other way"),
    }
    twin: list[Section] = [(head(Design.shafts), mirrored)] if pair else []
    return [(head(Design.shafts), shaft), (head(Design.shafts, ShaftInputs.holes), drilled), *rows, *twin]


# --- the bearings
# Journals that the shaft goes through, then lengths and clearances that hold at every corner, by the search for
# bearings.

OILS = ("5W-40", "5W-30", "0W-20")  # what engines run on, the thickest first
FITS: tuple[tuple[str, str] | None, ...] = (None, ("IT6", "IT6"))
FOUND = "assumed: by the search for bearings, so that its rules hold at the worst corner of the tolerances"
BEARINGS = Text("bearings to begin with")


class TooFast(NoSolution):
    """A plain journal of usual length carries off less heat than this load and speed make: a case for rolling
    bearings."""


def bearings(document: Document, results: Results) -> list[Section]:
    """The table of the bearings for the shaft of a design that has none, and what its rows have then.

    Raises NoSolution, TooFast where no plain bearing carries it."""
    made, shaft = results.design, results.result(CountershaftResult)
    if made.countershaft is None or shaft is None or made.engine is None:
        raise NoSolution(BEARINGS, Text("the shaft that they carry is not known"), Text("give [[shafts]] first"))
    load = max(shaft.loads.values())
    front, rear, room = _sizes(made)
    length = _cooled_length(load, made.engine.rated_speed, rear, room)
    narrowest = max(front, min(up(length / BEARING[1], 0.5e-3), rear))
    oils = oil_of(made, OILS)
    tried: list[Text] = []
    # closer fits with the oil that came nearest first
    for fits, oil in [*product(FITS[:1], oils), *product(FITS[1:], reversed(oils))]:
        for front in dict.fromkeys((narrowest, rear)):
            sections = _journal_sections(made, oil, front, rear, length)
            begun = design(with_bearings(document, sections))
            own = begun.bearings
            assert own is not None
            only = [Variant(oil, own.supply, Lubricant(own.in_bearings(begun.oils[oil]), own.viscosity_law), fits)]
            case = bearings_case(begun, solve, solve(begun, results))
            try:
                settled = nearest_row(case, only=only)
            except NoSolution as none:
                tried.append(none.text)
                break  # a wider journal is no cooler
            verdict = settled.results.outcomes["bearings"].verdict if settled.results is not None else ""
            if settled.row is not None and verdict == "pass":
                return changed(sections, bearing_changes(settled.row, case), FOUND)
    raise NoSolution(BEARINGS, SEMICOLON.join(tried[:1]), Text("a stiffer shaft, a slower one, or rolling bearings"))


def with_bearings(document: Document, sections: list[Section]) -> Document:
    """The document with the table of the bearings, and with what its shaft's rows have then."""
    rows, others = parted(sections)
    (bearings_of,) = [dotted(Design.shafts, n) for n in own_shafts(document.data)]
    document = replace(document, data={**document.data, **table(others)})
    for n, (_, row) in enumerate(rows):
        for field, (value, _) in row.items():
            if dotted(field) != dotted(BearingRow.name):
                document = document.with_value(dotted(bearings_of, ShaftInputs.bearings, n, field), value)
    return document


def _sizes(design: Design) -> tuple[Metre, Metre, Metre]:
    """Diameters of the front and the rear journal, and the longest journal beside the sectors."""
    shaft = design.countershaft
    assert shaft is not None
    z = min(abs(shaft.bearing_positions[0]), abs(shaft.bearing_positions[-1]))
    if shaft.journals:
        (d_first, l_first), (d_last, l_last) = shaft.journals[0], shaft.journals[-1]
        return d_first, d_last, max(l_first, l_last)
    radii = [section.outer_radius for section in shaft.sections] or [2 * mass.radius for mass in shaft.masses]
    outer = shaft.outer_radius if shaft.outer_radius is not None else max(radii, default=0.0)
    ends = shaft.half_length
    if ends is None:
        ends = max((abs(mass.z) for mass in shaft.masses), default=0.0)
    rear = up(2 * (outer + (shaft.radial_clearance or THREADED)), 0.5e-3)
    if design.gears is not None:
        wheel = next(wheel for wheel in design.gears.wheels if wheel.name == design.gears.carrier())
        through = up(tip(wheel.teeth, design.gears.module, design.gears.helix_angle) + 1e-3, 0.5e-3)
    else:
        through = up(tip(*passing_seat(rear)) + 1e-3, 0.5e-3)
    return min(through, rear), rear, max(2 * (z - ends - 2 * FILLET), 0.0)


def _cooled_length(load: Newton, speed: RevPerSecond, rear: Metre, room: Metre) -> Metre:
    """The same; raises TooFast where it carries off too little heat."""
    length, heat = _length(load, speed, rear, room), load * speed
    limit = LUBRICATIONS[COOLED].limit * (1 - THIN_MARGIN)
    if length <= 0 or heat / length > limit:
        tried = Text(
            "{load} at {speed} on {length} of journal: a heat index of {index}",
            load=Amount(load, "N"),
            speed=Amount(speed * 60, "rpm"),
            length=Amount(length * 1e3, "mm"),
            index=Amount(heat / length / N_RPM_MM if length > 0 else float("inf"), "N·rpm/mm"),
        )
        raise TooFast(BEARINGS, tried, Text("rolling bearings"))
    return length


def _journal_sections(made: Design, oil: str, front: Metre, rear: Metre, length: Metre) -> list[Section]:
    why = f"assumed: l/d of at least {BEARING[0]:g} at the rear, and a heat index up to 400 000 N·rpm/mm"
    alike: Rows = {
        BearingRow.clearance_factor: (0.75, "assumed: usual 0.4 to 0.8; a fast journal wants the oil"),
        BearingRow.journal_roughness: (0.2, "assumed: ground and lapped"),
        BearingRow.housing_roughness: (0.4, "assumed: finely bored"),
    }
    through = f"assumed: 1 mm above the gear's tip, or l/d of {BEARING[1]:g}"
    in_front: Rows = {
        BearingRow.diameter: (mm(front), "assumed: that of the rear" if front == rear else through),
        BearingRow.length: (mm(length), "assumed: that of the rear bearing"),
    }
    behind: Rows = {
        BearingRow.diameter: (mm(rear), "assumed: the sectors and their clearance go through"),
        BearingRow.length: (mm(length), why),
    }
    return [
        *judged(made, oil),
        (BEARING_ROW, {BearingRow.name: ("front", "")} | in_front | alike),
        (BEARING_ROW, {BearingRow.name: ("rear", "")} | behind | alike),
    ]


def judged(made: Design, oil: str) -> list[Section]:
    """The table of what all bearings share."""
    housing = (HOUSING, "assumed: expands like the shaft, so that the clearance stays when cold")
    if made.gears is not None and made.gears.housing_material:
        housing = (made.gears.housing_material, "as between the wheels")
    both: Rows = {
        BearingsInputs.oil: (oil, "assumed"),
        BearingsInputs.supply_temperature: (90.0, "assumed: gallery of a warm engine"),
        BearingsInputs.supply_pressure: (4.0, "assumed"),
        BearingsInputs.supply: ("hole", ""),
        BearingsInputs.hole_diameter: (5.0, "assumed"),
        BearingsInputs.housing_material: housing,
    }
    return [(head(Design.bearings), both)]


def oil_of(made: Design, oils: tuple[str, ...]) -> tuple[str, ...]:
    """The oil that a design has for its teeth, else what engines run on."""
    return oils if made.friction is None or made.friction.oil is None else (made.friction.oil,)
