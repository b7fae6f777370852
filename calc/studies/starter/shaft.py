# SPDX-License-Identifier: Apache-2.0
"""The shaft: the smallest envelope that carries what is asked, with room to spare, and a core that keeps its journals
straight.  It is laid into a divided housing, so that its journals are as thin as their load allows."""

import math

import numpy as np

from ...countershaft import formulas as f
from ...countershaft.inputs import Holes, ShaftInputs
from ...countershaft.making.unbalance import calibration
from ...countershaft.result import CountershaftResult
from ...countershaft.rows import BearingRow
from ...countershaft.sizing import formulas as sizes
from ...countershaft.sizing.lengths import utilisation
from ...countershaft.sizing.sectors import Sized, size
from ...design.addresses import Table
from ...design.model import Design
from ...design.toml_file import Document, design
from ...engine.result import EngineResult
from ...imbalance.result import ImbalanceResult
from ...sheet.errors import NoSolution
from ...sheet.linked_array import gathered
from ...sheet.record import record, replace
from ...sheet.text import Amount, Text
from ...sheet.units import Metre, Newton, Radian, RadPerSecond, RevPerSecond
from ...sheet.value import untraced
from ...solve import Results, solve
from .journals import estimated, estimated_length
from .writing import BEARING_ROW, Rows, Section, down, head, mm, table, up

STEEL = "42CrMo4"
UTILISATION = 0.75
CORES = (0.65, 0.70, 0.75, 0.80, 0.85, 0.90)  # of the outer radius
FILLET = 1.5e-3  # m
SLOPE = 0.2e-3  # rad: of the 0.25 mrad that are accepted
OVERDESIGN, DRILLED = 0.015, 0.03  # what the shaft is made stronger, and what the holes take: twice as much
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
    """The envelope, and the journals that are looked at first."""

    span: Metre
    outer: Metre
    core: Metre
    half_length: Metre
    journal: Metre
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
    """The smallest outer radius at which the utilisation is comfortable.  Raises NoSolution."""
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
        journal = estimated(load)
        length = estimated_length(journal)
        half_length = down(span / 2 - length / 2 - 2 * FILLET, 0.5e-3)
        radii = [step * 0.5e-3 for step in range(20, 400)] if half_length > 0 else []
        thicker = [(R, down(core * R, 0.5e-3)) for R in radii]
        for n in range(0, len(thicker), AT_ONCE):
            some = thicker[n : n + AT_ONCE]
            k = [sizes.unbalance_per_length(rho=rho, R=R, r_0=r_0) for R, r_0 in some]
            alpha = [sizes.force_number(U=U, k=per_length, z_max=half_length) for per_length in k]
            product = [sizes.product_number(P=P, k=per_length, z_max=half_length) for per_length in k]
            used = utilisation(np.array(alpha), np.array(product))
            if (fitting := np.flatnonzero(used <= UTILISATION)).size:
                R, r_0 = some[fitting[0]]
                sized = size(U, P, todo.omega, rho, R, r_0, half_length)
                return Envelope(span, R, r_0, half_length, journal, length, load, sized)
    raise NoSolution(SHAFT, Text("outer radii up to 200 mm on a span of {span}", span=Amount(span * 1e3, "mm")), GIVE)


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
    rows = tuple(replace(row, diameter=of.journal, length=of.length) for row in begun.rows)
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
        ShaftInputs.assembly: ("split", "assumed: laid into a divided crankcase"),
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
