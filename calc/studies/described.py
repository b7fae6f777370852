# SPDX-License-Identifier: Apache-2.0
"""What a design is about, in a line for each of its steps: the object, its drive, and the load case it is judged at;
and what acts on it that nobody counts."""

from collections.abc import Callable, Iterator
from math import degrees

from ..countershaft.rows import called
from ..design.model import TITLES, Design
from ..engine.formulas import stroke
from ..mounting.standards import Scope, scope
from ..sheet.quantity import dotted
from ..sheet.record import record
from ..sheet.text import COMMA, SEMICOLON, Amount, Name, Text, plural

LAYOUTS = {"inline": Text("inline"), "vee": Text("vee"), "boxer": Text("boxer")}
DASH = Text(" – ")


def described(design: Design) -> Iterator[tuple[Text, Text]]:
    """A title and a line of words for each step that the design has, and for the load case."""
    if (engine := design.engine) is not None:
        yield (
            TITLES["engine"],
            Text(
                "{name}: {layout}, {cylinders}, four-stroke, bore {bore}, stroke {stroke}"
                if engine.strokes == 4
                else "{name}: {layout}, {cylinders}, two-stroke, bore {bore}, stroke {stroke}",
                name=Name(engine.name),
                layout=LAYOUTS.get(engine.layout, Name(engine.layout)),
                cylinders=plural("{n} cylinder", "{n} cylinders", n=engine.cylinders),
                bore=_mm(engine.bore),
                stroke=_mm(stroke(L=engine.rod_length, r=engine.crank_radius, d=engine.cylinder_offset)),
            ),
        )
    views = [view for view in design.views.values() if view.countershaft is not None]
    if shafts := SEMICOLON.join(of_shaft(design, view.own_name, _shaft(view)) for view in views):
        yield design.title("countershaft"), shafts
    if (bearings := design.bearings) is not None:
        rows = SEMICOLON.join(of_shaft(design, name, _rows(view)) for name, view in design.views.items())
        words = Text("{sizes}; oil {oil}", sizes=rows, oil=Name(bearings.oil))
        if any(
            row.size is not None and row.dynamic_rating is None for view in design.views.values() for row in view.rows
        ):
            words = Text("{words}; ratings estimated by a typical inside", words=words)
        yield TITLES["bearings"], words
    if (gears := design.gears) is not None:
        teeth = DASH.join(Text("{name} {teeth}", name=Name(wheel.name), teeth=wheel.teeth) for wheel in gears.wheels)
        yield (
            TITLES["gears"],
            Text(
                "{teeth}; module {module}, pressure angle {alpha}, helix {beta}, face width {width}",
                teeth=teeth,
                module=_mm(gears.module),
                alpha=_degrees(gears.pressure_angle),
                beta=_degrees(gears.helix_angle),
                width=_mm(gears.face_width),
            ),
        )
    if load := COMMA.join(_load_case(design)):
        yield Text("Load case"), load


def of_shaft(design: Design, name: str, words: Text) -> Text:
    """With the name of the shaft before it, where there are several, and those of its twins."""
    if len(design.shafts) < 2:
        return words
    twins = [Name(shaft.name) for shaft in design.shafts if name in (shaft.mirrors, shaft.repeats)]
    names = Text(" and ").join([Name(name), *twins])
    return Text("{name}: {reason}", name=names, reason=words)


def _shaft(view: Design) -> Text:
    shaft = view.countershaft
    assert shaft is not None
    return Text(
        "{material}, {ratio} × crank speed, bearings {span} apart, outer radius {radius}"
        if shaft.outer_radius is not None
        else "{material}, {ratio} × crank speed, bearings {span} apart",
        material=Name(shaft.material),
        ratio=Amount(shaft.speed_ratio),
        span=_mm(shaft.bearing_positions[-1] - shaft.bearing_positions[0]),
        radius=_mm(shaft.outer_radius or 0.0),
    )


def _rows(view: Design) -> Text:
    return COMMA.join(Text("{row} {size}", row=called(row.name), size=row.size_words()) for row in view.rows)


def _load_case(design: Design) -> Iterator[Text]:
    if design.engine is not None:
        yield Text("rated speed {speed}", speed=Amount(design.engine.rated_speed * 60, "rpm"))
    elif design.gears is not None and design.gears.speed is not None:
        yield Text("first driver at {speed}", speed=Amount(design.gears.speed * 60, "rpm"))
    if design.gears is not None and design.gears.power is not None:
        yield Text("power {power}", power=Amount(design.gears.power / 1e3, "kW"))
    if (bearings := design.bearings) is not None:
        T, p = Amount(bearings.supply_temperature, "°C"), bearings.supply_pressure
        if p is None:
            yield Text("oil at {temperature}", temperature=T)
        else:
            pressure = Amount(p / 1e5, "bar")
            yield Text("oil supplied at {temperature} and {pressure}", temperature=T, pressure=pressure)
        yield Text("cold at {lowest}", lowest=Amount(bearings.lowest_temperature, "°C"))


def _mm(length: float) -> Amount:
    return Amount(length * 1e3, "mm")


def _degrees(angle: float) -> Amount:
    return Amount(degrees(angle), "°", digits=6)


# --- what is not counted


def _slopes_given(design: Design) -> bool:
    return design.gears is not None and all(mesh.shaft_deflection is not None for mesh in design.gears.meshes)


@record
class Influence:
    """What acts on the parts of a step and no formula counts.  `given`: whether a design has the inputs by which it is
    counted; None: there are none yet."""

    step: str
    words: Text
    given: Callable[[Design], bool] | None = None


def _scope(design: Design) -> Scope | None:
    engine, given = design.engine, design.mounting
    if engine is None or given is None:
        return None
    return scope(given.application, given.power or engine.rated_power, engine.rated_speed, given.machine_class)


def _classed(design: Design) -> bool:
    """Whether the class of the machine is given, or no standard asks for it."""
    judged, given = _scope(design), design.mounting
    return judged is None or given is None or not judged.iso_10816 or given.machine_class is not None


def _severity_judged(design: Design) -> bool:
    judged = _scope(design)
    return judged is None or judged.iso_10816 or judged.iso_8528


BEARINGS, SHAFT, GEARS = dotted(Design.bearings), "countershaft", dotted(Design.gears)
MOUNTING = dotted(Design.mounting)
INFLUENCES = (
    Influence(BEARINGS, Text("alignment of the bores")),
    Influence(BEARINGS, Text("distortion of the housing")),
    Influence(BEARINGS, Text("stiffness of the housing under the journals")),
    Influence(BEARINGS, Text("air and fuel in the oil")),
    Influence(BEARINGS, Text("pulsation of the oil pressure")),
    Influence(BEARINGS, Text("bolts of the bearing joint")),
    Influence(BEARINGS, Text("wear of journals and bores")),
    Influence(SHAFT, Text("torsion of the shaft")),
    Influence(GEARS, Text("slope of the shaft at its wheel"), _slopes_given),
    Influence(GEARS, Text("wear of the teeth")),
    Influence(MOUNTING, Text("severity by ISO 10816-6, for which the class of the machine is to be given"), _classed),
    Influence(MOUNTING, Text("severity of the vibration, for which no standard has limits here"), _severity_judged),
    Influence(MOUNTING, Text("bending of engine and frame")),
    Influence(MOUNTING, Text("rubber that softens with amplitude (Payne effect)")),
    Influence(MOUNTING, Text("start and stop, which sweep through the modes")),
    Influence(MOUNTING, Text("valve gear, fan and fuel pump")),
    Influence(MOUNTING, Text("couple of the rods, whip of the crank, gyroscopic couple")),
)


def not_counted(design: Design) -> tuple[Text, ...]:
    """What acts on the steps that are asked and no input of this design describes.  It is no finding: it touches no
    state."""
    asked = {step.key for step in design.asked()}
    return tuple([each.words for each in INFLUENCES if each.step in asked and not (each.given and each.given(design))])
