# SPDX-License-Identifier: Apache-2.0
"""The train: one shaft at −1 by three meshes, with a wheel that goes through its seats; several shafts, or others, by a
tree: an odd number of wheels lies between crank and shaft, an even one where the shaft turns against the crank; and its
friction.

Trains and flanks are tried in the order in which they are usual; the first is taken that leaves nothing to be said of
teeth and losses.  Where strikes stop one, the wheels that follow are finer, with less backlash, and wider; the first is
taken that is not graded C at idle and keeps every limit, even if cautions of its strikes stay; else the quietest of
those that keep every limit."""

import math
from collections import Counter
from collections.abc import Iterator
from itertools import product

from ...countershaft.result import CountershaftResult
from ...design.model import Design
from ...design.toml_file import Document, design
from ...friction.checks import MESH_MODELS
from ...friction.inputs import FrictionInputs, RollingBearing
from ...friction.result import FrictionResult
from ...gears import formulas as g
from ...gears.drive import checks as strikes
from ...gears.inputs import GearsInputs, Mesh, wheel_key
from ...gears.layout.room import CLEARANCE
from ...gears.rating.checks import SAFETY_CONTACT, SCUFFING
from ...gears.result import TrainResult
from ...gears.wheel_inputs import Wheel
from ...sheet.check import THIN_MARGIN, URGENT
from ...sheet.errors import BadInput, NoSolution
from ...sheet.record import record, replace
from ...sheet.text import SEMICOLON, Text
from ...sheet.units import Metre, Radian
from ...sheet.value import untraced
from ...solve import Results, solve
from .writing import Rows, Section, head, mm, table, up

HELIX: Radian = math.radians(20)
MODULES = (2.5e-3, 2.0e-3, 1.75e-3, 1.5e-3, 1.25e-3)
USUAL = 2.0e-3  # the largest of them where nothing asks for more
SMALLEST = 1.25e-3
# crank and shaft, central, idler; those of the R753IE4 first
WHEELS = ((25, 36, 39), (25, 31, 33), (21, 31, 34), (21, 26, 29), (20, 23, 27))
OF_TREE = (25, 21, 19)  # of the fastest shaft of a tree
LARGEST = 34  # teeth of what lies between there: larger ones meet in their main resonance
FACES = (7.5, 6.0)  # modules
WIDER = (9.0, 10.5, 12.0)  # where no train is strong enough for what nobody knows of the engine's irregularity
FLANKS = (0.8, 0.4, 0.3, 0.2)  # Ra in µm: ground, finely ground, and then polished
BORE = 0.6  # of the reference diameter
ALLOWANCE = (-30, -40)  # µm: at least
THINNER = 5  # µm: the steps in which teeth get thinner
GRADE = 7
TOLERANCE = 40  # µm
FINER_GRADE, FINER_TOLERANCE = 6, 20  # of wheels whose flanks would strike too hard: less backlash is left open
HOUSING = "EN-GJL-250"  # of the block; it expands like the wheels and the shaft
MUCH, LEFT = 10.0, 100.0  # kW that a train without plain bearings is tried with, and W that may be left of it
OF_FLANKS = (SCUFFING, MESH_MODELS, SAFETY_CONTACT)  # checks that finer flanks help
OF_STRIKES = (  # those that less backlash helps, and wider wheels
    strikes.RATTLE,
    strikes.BACKLASH_WINDOW,  # shut wherever the train is graded C
    strikes.STRIKE_CONTACT,
    strikes.STRIKE_CONTACT_MOST,
    strikes.STRIKE_BENDING,
    strikes.STRIKE_BENDING_MOST,
)
TRAIN = Text("a train to begin with")


@record
class Train:
    """One that is tried: the teeth of crank (as many on the shaft), central wheel and idler; module; face width in
    modules; whether teeth and centre distances are finer than usual."""

    teeth: tuple[int, int, int]
    module: Metre
    face: float
    finer: bool = False


def tip(teeth: int, module: Metre, helix: Radian = HELIX) -> Metre:
    """The tip diameter of a wheel without profile shift."""
    with untraced():
        reference = g.reference_diameter(float(teeth), g.transverse_module(module, helix))
        return float(g.tip_diameter(reference, module, 0.0, 0.0))


def passing_seat(seat: Metre, teeth: int = WHEELS[0][0]) -> tuple[int, Metre]:
    """The teeth and the largest usual module of a wheel that goes through a seat."""
    fitting = (module for module in MODULES if module <= USUAL and tip(teeth, module) + 1e-3 <= seat)
    return teeth, next(fitting, MODULES[-1])


def gears(document: Document, results: Results) -> list[Section]:
    """The tables of the first train that passes with some flanks.  Raises NoSolution."""
    return _passing(document, results)[0]


def friction(document: Document, results: Results) -> list[Section]:
    """The table with the roughest flanks of which nothing is to be said.  Raises NoSolution where the design has no
    wheels."""
    if results.design.gears is None:
        raise NoSolution(Text("friction to begin with"), Text("the wheels are not known"), Text("give [gears] first"))
    best = None
    for flanks in FLANKS:
        sections = _friction(results.design, results, flanks)
        outcome = solve(design(Document({**document.data, **table(sections)})), results).outcomes["friction"]
        if outcome.verdict == "pass":
            return sections
        best = best or sections
    assert best is not None
    return best


def gears_and_friction(document: Document, results: Results) -> list[Section]:
    """Both, found together."""
    train, flanks = _passing(document, results)
    return [*train, *flanks]


def _passing(document: Document, results: Results) -> tuple[list[Section], list[Section]]:
    why: list[Text] = []
    power = None if "bearings" in document.data else MUCH
    known = {c.id for c in results.outcomes["countershaft"].checks if c.verdict in URGENT}
    struck: tuple[float, list[Section], list[Section]] | None = None  # with the speed of its strikes at idle
    hard = False  # whether strikes stopped one
    weak = set[tuple[int, int, int]]()  # teeth that strikes break or pit however wide: smaller modules are weaker still
    for train in (replace(train, finer=finer) for finer in (False, True) for train in _trains(results.design, finer)):
        if train.finer != hard or train.teeth in weak:
            continue
        for flanks in FLANKS:
            losses = _friction(results.design, results, flanks)
            try:
                wheels, power, results = _loaded(document, results, train, losses, power)
            except BadInput as bad:
                why.append(bad.errors[0].reason)
                break
            outcomes = [results.outcomes[key] for key in ("countershaft", "gears", "friction")]
            stopping = [c for outcome in outcomes for c in outcome.checks if c.verdict in URGENT and c.id not in known]
            if all(outcome.state == "solved" for outcome in outcomes if outcome.state != "not_asked"):
                if not stopping:
                    return wheels, losses
                if train.finer and all(c.rule in OF_STRIKES and c.verdict != "fail" for c in stopping):
                    speed = next((c.value for c in stopping if c.rule is strikes.RATTLE), 0.0)
                    if not speed:
                        return wheels, losses
                    struck = (speed, wheels, losses) if struck is None or speed < struck[0] else struck
            hard = hard or any(c.rule in OF_STRIKES for c in stopping)
            if train.face == WIDER[-1] and any(c.rule in OF_STRIKES and c.verdict == "fail" for c in stopping):
                weak.add(train.teeth)
            why += [Text("{check}", check=c.name) for c in stopping[:1]]
            if not all(c.rule in OF_FLANKS for c in stopping):
                break  # finer flanks do not help
    if struck is not None:
        return struck[1:]
    raise NoSolution(
        TRAIN,
        SEMICOLON.join(text for text, _ in Counter(why).most_common(3)),
        Text("other teeth, modules or centre distances: give [gears]"),
    )


def _loaded(
    document: Document,
    results: Results,
    train: Train,
    losses: list[Section],
    power: float | None,
) -> tuple[list[Section], float | None, Results]:
    """The tables of a train, its power in kW, and the whole with it.

    `power`: None where plain bearings close the balance; else what is tried first, and then changed to what is lost."""
    solved_design, allowance, places = results.design, ALLOWANCE, dict[str, object]()
    for _ in range(3):
        wheels = _gears(solved_design, train, power, allowance, places)
        results = solve(design(Document({**document.data, **table(wheels), **table(losses)})), results, compared=False)
        balance = results.result(FrictionResult)
        delivered = balance.delivered_power if balance is not None else None
        less = _too_tight(results)
        allowance = (allowance[0] - less, allowance[1] - less)
        open_ = _proposed(results)
        places |= open_
        if power is not None and delivered is not None and not 0 < delivered < 2 * LEFT:
            power = round(up(power - delivered / 1e3 + LEFT / 2e3, LEFT / 1e3), 6)
        elif less == 0 and not open_:
            break
    return wheels, power, results


def _proposed(results: Results) -> dict[str, object]:
    """Places, by their keys, for wheels in a row that nothing fixes."""
    unplaced = [c for c in results.outcomes["gears"].checks if c.rule is CLEARANCE and c.missing]
    return {key: place for check in unplaced for way in check.remedies for key, place in way.changes}


def _too_tight(results: Results) -> int:
    """What has to come off the span of every wheel, in µm, so that no mesh is narrow at any state that is judged."""
    train = results.result(TrainResult)
    if train is None or train.play is None:
        return 0
    missing = 0.0
    for play in train.play.values():
        still_and_cold = play.backlash_min_runout, play.backlash_cold, play.backlash_warming
        least = min(*still_and_cold, play.backlash_running, play.backlash_warmer)
        missing = max(missing, THIN_MARGIN * play.backlash_recommended - least)
    return round(up(missing * 1e6 / 2, THINNER))


def _trains(design: Design, wide: bool = False) -> Iterator[Train]:
    """Those of a tree by their teeth; else those whose wheel on the shaft goes through its front seat, and that reach
    from the crank to the axis of the shaft.  `wide`: none but wide ones."""
    if _is_tree(design):
        for module, fastest, face in product(MODULES[1:], OF_TREE, WIDER[::2]):
            yield Train((fastest, 0, 0), module, face)
        return
    shaft = design.countershaft
    seat = math.inf
    if shaft is not None and not shaft.passes_seats:
        pass  # it is laid in with its wheel
    elif shaft is not None and shaft.journals:
        seat = shaft.journals[0][0]
    elif shaft is not None and shaft.outer_radius is not None:
        seat = 2 * shaft.outer_radius
    away = math.hypot(*shaft.axis) if shaft is not None and shaft.axis is not None else 0.0
    sizes = range(len(MODULES) - 1), WHEELS
    faces = (WIDER[::2],) if wide else (FACES, WIDER)
    for smaller, teeth, face in (row for of in faces for row in product(*sizes, of)):
        modules = [
            module for module in MODULES if (module <= USUAL or teeth != WHEELS[0]) and tip(teeth[0], module) < seat
        ]
        if smaller < len(modules) and modules[smaller] >= SMALLEST:
            yield Train(_reaching(teeth, modules[smaller], away), modules[smaller], face)


def _is_tree(design: Design) -> bool:
    """Whether a design asks for more than one shaft at −1."""
    return len(design.shafts) > 1 or (design.own is not None and design.own.speed_ratio != -1)


def _reaching(teeth: tuple[int, int, int], module: Metre, away: Metre) -> tuple[int, int, int]:
    """With idlers large enough for the distance."""
    crank, central, idler = teeth
    while (crank + central + idler) * module / math.cos(HELIX) < 1.03 * away:
        central, idler = central + 1, idler + 2
    return crank, central, idler


@record
class Row:
    """A wheel of a train, with the shaft that it carries and the wheel that drives it ("" where there is none)."""

    name: str
    teeth: int
    why: str
    driver: str = ""
    shaft: str = ""


def _wheels(design: Design, train: Train) -> list[Row]:
    """All wheels, each after the one that drives it."""
    crank, central, idler = train.teeth
    usual = "assumed: fewer, below the main resonance of the teeth"
    if (crank, central, idler) == WHEELS[0]:
        usual = "assumed, as in the R753IE4"
    if not _is_tree(design):
        own = design.own.name if design.own is not None else ""
        return [
            Row("crank", crank, usual),
            Row("central", central, usual, "crank"),
            Row("idler", idler, usual, "central"),
            Row("shaft", crank, "as many as on the crank: ratio −1 by three meshes", "idler", own),
        ]
    shafts = design.resolved
    fastest = max(abs(shaft.inputs.speed_ratio) for shaft in shafts)
    rows = [Row("crank", round(fastest * crank), f"assumed: {fastest:g} times those of the fastest shaft")]
    for shaft in shafts:
        ratio, axis = shaft.inputs.speed_ratio, shaft.inputs.axis
        carried, driver = round(fastest * crank / abs(ratio)), "crank"
        # their pitch circles together bridge the distance, which those of crank and shaft leave
        apart = 2 * math.hypot(*axis) * math.cos(HELIX) / train.module if axis is not None else 0.0
        missing = 1.06 * apart - rows[0].teeth - carried
        count = next(n for n in range(1 if ratio > 0 else 2, 99, 2) if missing / 2 / n <= LARGEST)
        teeth = max(crank, math.ceil(missing / 2 / count))
        for n in range(1, count + 1):
            name = f"{shaft.name}-{n}"
            rows.append(Row(name, teeth + (teeth % 2 == 0), "assumed: bridges the distance to the crank", driver))
            driver = name
        rows.append(Row(shaft.name, carried, f"ratio {ratio:+g}", driver, shaft.name))
    return rows


def _gears(
    design: Design, train: Train, power: float | None, allowance: tuple[int, int], places: dict[str, object]
) -> list[Section]:
    """`places`: of wheels, by their keys, where nothing else fixes them."""
    usual = train.teeth == WHEELS[0]
    module = (
        "the largest up to 2 whose wheel goes through the seats" if usual else "below the main resonance of the teeth"
    )
    if _is_tree(design):
        module = "a usual one"
    housing = design.bearings.housing_material if design.bearings is not None else HOUSING
    rows: Rows = {
        GearsInputs.normal_module: (mm(train.module), f"assumed: {module}"),
        GearsInputs.pressure_angle: (20.0, ""),
        GearsInputs.helix_angle: (round(math.degrees(HELIX), 6), "assumed"),
        GearsInputs.face_width: (mm(up(train.face * train.module, 0.5e-3)), f"assumed: {train.face:g} modules"),
        GearsInputs.tool_addendum: (1.41, "assumed: the tool of the R753IE4"),
        GearsInputs.tool_tip_radius: (0.2, "assumed"),
        GearsInputs.accuracy_grade: (
            FINER_GRADE if train.finer else GRADE,
            f"assumed: {'ground' if train.finer else 'shaved or ground'}; the runout of the teeth goes with it",
        ),
        GearsInputs.housing_material: (housing, "assumed: the block, as of the bearings"),
    }
    if power is not None:
        assumed = "assumed: what rolling bearings, teeth and windage lose, up to the next 0.1 kW"
        rows[GearsInputs.power] = (power, assumed)
    sections: list[Section] = [(head(Design.gears), rows)]
    wheels = _wheels(design, train)
    for row in wheels:
        free = "assumed: free with the runout, cold, warm, and when the wheels are warmer"
        carries: Rows = {Wheel.shaft: (row.shaft, "")} if row.shaft else {}
        wheel: Rows = {
            Wheel.name: (row.name, ""),
            **carries,
            Wheel.teeth: (row.teeth, row.why),
            Wheel.span_allowance: (allowance, free),
        }
        if (place := places.get(wheel_key(row.name, Wheel.position))) is not None:
            wheel[Wheel.position] = (place, "assumed: on an arc from the crank to the shaft; the others follow")
        if row is not wheels[-1] and not row.shaft:
            diameter = float(round(BORE * row.teeth * train.module * 1e3 / math.cos(HELIX)))
            sits = "assumed: turns on a pin" if row.driver else "assumed: sits on the crank"
            wheel[Wheel.bore_diameter] = (diameter, sits)
        sections.append((head(Design.gears, GearsInputs.wheels), wheel))
    for row in wheels[1:]:
        tolerance = (
            FINER_TOLERANCE if train.finer else TOLERANCE,
            f"assumed: the allowances leave it a backlash{', which is small for its strikes' if train.finer else ''}",
        )
        mesh: Rows = {Mesh.driver: (row.driver, ""), Mesh.driven: (row.name, ""), Mesh.tolerance: tolerance}
        sections.append((head(Design.gears, GearsInputs.meshes), mesh))
    return sections


def _friction(design: Design, results: Results, flanks: float) -> list[Section]:
    oil: Rows = {
        FrictionInputs.oil: ("5W-40", "assumed"),
        FrictionInputs.oil_temperature: (90.0, "assumed: gallery of a warm engine"),
    }
    words = {0.8: "assumed: ground", 0.4: "assumed: finely ground"}.get(flanks, "assumed: ground and polished")
    surfaces: Rows = {FrictionInputs.flank_roughness: (flanks, words), FrictionInputs.load_sharing: ("linear", "")}
    if design.bearings is not None:
        masses: Rows = {FrictionInputs.mass_loss: ("bracket", "of the sectors in the mist; no measurement is known")}
        return [(head(Design.friction), surfaces | masses)]
    return [(head(Design.friction), oil | surfaces), *_rolling(design, results)]


def _rolling(design: Design, results: Results) -> list[Section]:
    """Two bearings on the shaft, as wide around it as their series is usual."""
    shaft, countershaft = results.result(CountershaftResult), design.countershaft
    if shaft is None or countershaft is None or countershaft.core_radius is None:
        return []
    bore, load = up(2 * countershaft.core_radius, 5e-3), float(math.ceil(sum(shaft.loads.values())))
    rows: Rows = {
        RollingBearing.name: ("shaft-bearings", ""),
        RollingBearing.wheel: ("shaft", ""),
        RollingBearing.kind: ("cylindrical-roller", "assumed: split cages, or one race off the shaft"),
        RollingBearing.bore: (mm(bore), "assumed: the core, up to the next 5 mm"),
        RollingBearing.outside_diameter: (mm(up(1.6 * bore, 5e-3)), "assumed: 1.6 bores"),
        RollingBearing.load: (load, "of both bearings: the shaft's reactions"),
        RollingBearing.count: (2, ""),
    }
    return [(head(Design.friction, FrictionInputs.rolling_bearings), rows)]
