# SPDX-License-Identifier: Apache-2.0
"""What is drawn of a wheel and of a whole train, in the transverse section: outlines, circles, and the table of data
for the workshop.

The sheet's first axis runs to the right, its second up.  Where the wheels stand in their places, up is the direction
"up" of the engine and the crank turns clockwise."""

import cmath
import math
from collections.abc import Mapping

import numpy as np

from ...draw.drawing import Arc, Point, Polyline, Stroke, Words
from ...sheet.quantity import Published, published
from ...sheet.text import Amount, Text
from ...sheet.units import Metre, Number, Radian
from ..inputs import GearsInputs
from ..layout.phase import phase
from ..result import MeshResult, TrainResult, WheelResult
from .outline import CHORD_ERROR, repeated, shifts, tooth

LAYERS = (
    "PROFILE",
    "PROFILE_MAX",
    "PROFILE_MIN",
    "TIP",
    "REFERENCE",
    "BASE",
    "ROOT",
    "FORM",
    "WORKING",
    "AXIS",
    "TEXT",
)
CIRCLES = {
    "TIP": "tip_diameter",
    "REFERENCE": "reference_diameter",
    "BASE": "base_diameter",
    "ROOT": "root_diameter",
    "FORM": "form_diameter",
}
HANDS = {"left": Text("left"), "right": Text("right")}
# rule of this program: letters are a fiftieth of the tip diameter high, and all distances multiples of that
LETTER = 0.02
CHAIN = 0.75  # rule of this program, of both diameters: how far apart the axes of a chain are drawn in a row
CHAIN = 0.75  # rule of this program, of both diameters: how far apart the axes of a chain are drawn in a row
UP: Radian = math.pi / 2
Places = Mapping[str, tuple[Metre, Metre]]


def wheel_drawing(
    train: TrainResult, name: str, title: str = "", gears: GearsInputs | None = None, chord_error: Metre = CHORD_ERROR
) -> tuple[Stroke, ...]:
    """One wheel about the origin, the middle of its first tooth up, with its table of data.

    PROFILE is the outline without allowance, PROFILE_MAX and PROFILE_MIN those at its ends, if there is one.
    """
    wheel = train.wheels[name]
    shapes = _outlines(train, wheel, chord_error, 0j, UP, limits=True)
    shapes += _circles(wheel, train.mates(name), 0j)
    h = LETTER * wheel.tip_diameter
    left, top = wheel.tip_diameter / 2 + 6 * h, wheel.tip_diameter / 2
    rows = (
        *data_table(train, name, gears),
        (Text("Profile"), Text("transverse section, without allowance; MAX, MIN: at its ends")),
    )
    shapes.append(Words("TEXT", (left, top), f"{title}: {name}" if title else name, 1.6 * h))
    for i, (label, words) in enumerate(rows):
        y = top - (3 + 1.8 * i) * h
        shapes += [Words("TEXT", (left, y), label, h), Words("TEXT", (left + 26 * h, y), words, h)]
    return tuple(shapes)


def train_drawing(
    train: TrainResult,
    title: str = "",
    positions: Places | None = None,
    tooth_angle: Radian = 0.0,
    chord_error: Metre = CHORD_ERROR,
) -> tuple[Stroke, ...]:
    """All wheels, meshing, without allowances.

    `positions` [up, side] of every wheel from the crank's axis; left out, or not of every wheel: in a row, each beside
    its driver at their centre distance.  `tooth_angle`: of a tooth of the first driver, from up in the sense of crank
    rotation.  Where the train stands as its layout has it, the first tooth of every wheel is the layout's tooth 1."""
    centres, standing = in_row(train), Text("In a row: where the axes stand is not known.")
    if positions is not None and set(train.wheels) <= set(positions):
        centres = {name: complex(side, up) for name, (up, side) in positions.items()}
        standing = Text("Drawn up: up from the crank's axis; the crank turns clockwise.")
    if not train.wheels:  # chains alone
        return ()
    teeth = _teeth(train, centres, tooth_angle)
    shapes: list[Stroke] = []
    for name, wheel in train.wheels.items():
        shapes += _outlines(train, wheel, chord_error, centres[name], UP - teeth[name], limits=False)
        shapes += _circles(wheel, train.mates(name), centres[name])
    h = LETTER * max(wheel.tip_diameter for wheel in train.wheels.values())
    for name, wheel in train.wheels.items():
        shapes.append(Words("TEXT", _point(centres[name] + complex(h, h)), f"{name}, z {wheel.teeth}", h))
    low = min(centres[name].imag - wheel.tip_diameter / 2 for name, wheel in train.wheels.items())
    left = min(centres[name].real - wheel.tip_diameter / 2 for name, wheel in train.wheels.items())
    below = [Text("Millimetres, 1:1. Transverse section, outlines without allowance."), standing]
    for i, line in enumerate([title, *below] if title else below):
        shapes.append(Words("TEXT", (left, low - (4 + 1.8 * i) * h), line, h))
    return tuple(shapes)


def _teeth(train: TrainResult, centres: Mapping[str, complex], tooth_angle: Radian) -> dict[str, Radian]:
    """Middle of a tooth of every wheel, from up in the sense of crank rotation: the layout's where the wheels stand as
    it has them."""
    places = {name: complex(at.imag, at.real) for name, at in centres.items()}
    laid = train.layout.wheels if train.layout is not None else {}
    angles = {
        name: w.tooth_angle for name, w in laid.items() if w.tooth_angle is not None and w.position == places[name]
    }
    if angles.keys() == train.wheels.keys():
        return angles
    directions = {key: cmath.phase(places[mesh.driven] - places[mesh.driver]) for key, mesh in train.meshes.items()}
    behind = {stage.driven: 0.0 for stage in train.stages.values()}  # which tooth stands where is not known there
    return phase(train, directions, {**behind, train.tree.first: tooth_angle}, {}).teeth


def in_row(train: TrainResult) -> dict[str, complex]:
    """Each wheel to the right of its driver; a driver's further wheels above it, below it, and so on round.  A chain
    spans what leaves its wheels apart."""
    centres, used = {train.tree.first: 0j}, {train.tree.first: 0}
    for link in train.tree.links:
        way = (1, 1j, -1j, -1)[used[link.driver] % 4]
        used[link.driver] += 1
        used[link.driven] = 0
        if link.toothed:
            apart = train.meshes[link.key].centre_distance
        else:
            apart = 2 * CHAIN * (reach(train, link.driver) + reach(train, link.driven))
        centres[link.driven] = centres[link.driver] + apart * way
    return centres


def reach(train: TrainResult, name: str) -> Metre:
    """The radius of a wheel, or of a sprocket that turns beside none."""
    if name in train.wheels:
        return train.wheels[name].tip_diameter / 2
    driving = {stage.driver: stage.pitch_diameter_driver for stage in train.stages.values()}
    driven = {stage.driven: stage.pitch_diameter_driven for stage in train.stages.values()}
    return max(driving.get(name, 0.0), driven.get(name, 0.0)) / 2


# --- shapes


def _outlines(
    train: TrainResult, wheel: WheelResult, chord_error: Metre, at: complex, turn: Radian, *, limits: bool
) -> list[Stroke]:
    """The closed outline, its first point not repeated, and with `limits` those at the ends of the allowance."""
    outlines: list[Stroke] = []
    for end, x in shifts(train.system, wheel).items():
        if limits or not end:
            path = repeated(tooth(train.system, wheel, chord_error, x), wheel.teeth)[:-1] * cmath.exp(1j * turn) + at
            points = tuple(zip(np.real(path).tolist(), np.imag(path).tolist()))
            outlines.append(Polyline(f"PROFILE_{end.upper()}" if end else "PROFILE", points, True))
    return outlines


def _circles(wheel: WheelResult, working: list[tuple[str, Metre, MeshResult]], at: complex) -> list[Stroke]:
    circles = [(layer, getattr(wheel, field)) for layer, field in CIRCLES.items()]
    circles += [("WORKING", d_w) for _, d_w, _ in working]
    shapes: list[Stroke] = [Arc(layer, _point(at), d / 2, 0.0, 2 * math.pi) for layer, d in circles]
    reach = wheel.tip_diameter * (0.5 + LETTER)
    for way in (complex(reach, 0.0), complex(0.0, reach)):
        shapes.append(Polyline("AXIS", (_point(at - way), _point(at + way))))
    return shapes


def _point(at: complex) -> Point:
    return at.real, at.imag


# --- the table of data


def data_table(train: TrainResult, name: str, gears: GearsInputs | None = None) -> tuple[tuple[Text, Text], ...]:
    """What stands beside a wheel on its drawing: a label and what is said, with limits where the design gives them."""
    s, wheel = train.system, train.wheels[name]
    known = {v.id.removeprefix("."): v for v in published(wheel, "")}
    helix = _alone(_degrees(s.beta))
    if gears is not None and s.beta:
        helix = Text("{angle}, {hand}", angle=_degrees(s.beta), hand=HANDS[gears.hands()[name]])
    rows = [
        (Text("Normal module m_n"), _alone(_mm(s.m_n))),
        (Text("Teeth z"), Text("{z}", z=wheel.teeth)),
        (Text("Normal pressure angle"), _alone(_degrees(s.alpha_n))),
        (Text("Helix angle"), helix),
        (Text("Profile shift coefficient x"), _alone(_number(wheel.profile_shift, 5))),
        (Text("Tool: addendum, tip radius"), Text("{h} / {rho} m_n", h=_number(s.h_aP0), rho=_number(s.rho_aP0))),
        (Text("Stock; residual undercut"), Text("{q}; {s_pr}", q=_mm(s.stock), s_pr=_mm(s.s_pr))),
        (Text("Face width b"), _alone(_mm(wheel.face_width))),
        (Text("Reference diameter d"), _alone(_mm(wheel.reference_diameter))),
        (Text("Base diameter d_b"), _alone(_mm(wheel.base_diameter))),
        (Text("Tip diameter d_a"), _between(wheel.tip_diameter, wheel.tip_diameter_min, wheel.tip_diameter_max)),
        (Text("Root diameter d_f"), _between(wheel.root_diameter, wheel.root_diameter_min, wheel.root_diameter_max)),
        (Text("Form diameter d_Ff"), _between(wheel.form_diameter, wheel.form_diameter_min, wheel.form_diameter_max)),
    ]
    if gears is not None:
        rows.append((Text("Accuracy grade (ISO 1328-1)"), Text("{grade}", grade=gears.accuracy_grade)))
    for mate, d_w, mesh in train.mates(name):
        distance, tolerance = _mm(mesh.centre_distance), _mm(mesh.centre_tolerance)
        centres = Text("{a} ±{t}", a=distance, t=tolerance) if mesh.centre_tolerance else _alone(distance)
        words = Text("{mm}; centres {distance}", mm=_mm(d_w), distance=centres)
        rows.append((Text("Working diameter to {mate}", mate=mate), words))
    for id in known:
        if id.startswith("span_") and id[5:].isdigit():
            rows.append((Text("Span over {id} teeth W", id=id[5:]), _limits(known, id)))
    if "over_balls" in known and "ball_diameter" in known:
        label = Text("Size over balls M, D_M {shown}", shown=_number(known["ball_diameter"].shown))
        rows.append((label, _limits(known, "over_balls")))
    return tuple(rows)


def _limits(known: Mapping[str, Published], id: str) -> Text:
    """A size, or its limits where the wheel has an allowance."""
    low, high = known.get(f"{id}_min"), known.get(f"{id}_max")
    if low is None or high is None:
        return _alone(_number(known[id].shown))
    return Text("{shown} to {shown2}", shown=_number(low.shown), shown2=_number(high.shown))


def _between(size: Metre, low: Metre | None, high: Metre | None) -> Text:
    if low is None or high is None:
        return _alone(_mm(size))
    return Text("{mm} to {mm2}", mm=_mm(low), mm2=_mm(high))


def _alone(number: Amount) -> Text:
    return Text("{number}", number=number)


def _mm(length: Metre) -> Amount:
    return _number(length * 1e3)


def _degrees(angle: Radian) -> Amount:
    return _number(math.degrees(angle), unit="°")


def _number(x: Number, digits: int = 4, unit: str = "") -> Amount:
    """Rounded to so many decimals, without zeros behind them."""
    return Amount(round(x, digits) + 0.0, unit, form=".12g")
