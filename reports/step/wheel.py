# SPDX-License-Identifier: Apache-2.0
"""A wheel as a solid: with its teeth as the tool cuts them, or the blank that the program weighs.  Its origin is on its
own axis in the middle of its face, its first tooth where the layout has tooth 1, else up.

A spur wheel is its transverse section drawn along the axis; a helical one is smooth through several of its sections,
each turned by what the helix asks for there.  What the solid weighs is held against the section's own area."""

import math

import numpy as np

from calc.exchange.frame import Frame
from calc.exchange.places import HANDS, helix
from calc.gears.inputs import GearsInputs
from calc.gears.profile.outline import Outline, shifts
from calc.gears.profile.section import ToothCurves, section
from calc.gears.rating.influence import inner_diameter
from calc.gears.result import TrainResult, WheelResult
from calc.sheet.units import KilogramPerMetre3, Metre, Radian
from calc.sheet.value import recorded
from reports.step.kernel import (
    Edge,
    KernelFault,
    Shape,
    SolidProperties,
    StepPart,
    arc,
    cut,
    demand_valid,
    face_of,
    in_splines,
    lofted,
    moved,
    prism,
    properties,
    spline,
    wire,
)
from reports.step.shaft import MM, ROUND, Weighed, WeighedPart, at, cylinder

SECTIONS = 7  # of a helical wheel, over its face
TURN: Radian = math.radians(10)  # rule of this program: nor is one turned further than this from the one before it
CLOSE = 2e-6  # of the solid to the section's area times the face


def wheel_solid(
    train: TrainResult,
    gears: GearsInputs,
    name: str,
    rho: KilogramPerMetre3,
    frame: Frame,
    *,
    tooth: Radian = 0.0,
    end: str = "",
    blank: bool = False,
    inside: Metre | None = None,
) -> WeighedPart:
    """`rho`: its density; `tooth`: where the middle of its first stands, from up in the sense of crank rotation; `end`:
    of its allowance, "max", "min", or "" for teeth without one; `blank`: a cylinder of the reference diameter in place
    of its teeth; `inside`: the radius inside which it is open, else that of its bore, or of its rim where that is
    given, since what carries a rim is not known.  Raises KeyError for an end that the wheel does not have, KernelFault
    where the solid is not valid or off its section."""
    wheel = train.wheels[name]
    with recorded(False):
        open_to = opening(wheel, gears) if inside is None else inside
        curves = None if blank else section(train.system, wheel, shifts(train.system, wheel)[end])
    b, hand = wheel.face_width * MM, HANDS[gears.hands().get(name, "")]
    if curves is None:
        body = cylinder(wheel.reference_diameter / 2 * MM, -b / 2, b / 2)
    else:
        body = toothed(curves, b, hand * helix(train, name) / MM)
    if open_to:
        body = cut(body, cylinder(open_to * MM, -b / 2 - ROUND, b / 2 + ROUND))
    body = moved(body, turned=frame.angle(tooth)) if tooth else body
    demand_valid(body, name, 1)
    found, kg = properties(body) if blank else with_teeth(body, not hand), rho * 1e-9
    whole = Weighed(name, found.volume, found.volume * kg, found.centre, found.tensor * kg)
    by_program = weighed_by_section(name, wheel, curves, open_to, rho)
    off = abs(whole.mass / by_program.mass - 1)
    deviation = max(off, float(np.abs(whole.tensor - by_program.tensor).max() / by_program.tensor.max()))
    if not off <= CLOSE:
        raise KernelFault(f"the solid of wheel {name} is off its section by {off:.1e}")
    return WeighedPart(StepPart(name, ((name, body),)), (whole,), whole, whole, by_program, deviation)


def with_teeth(body: Shape, straight: bool) -> SolidProperties:
    """Of a solid with teeth: the flanks of straight ones are splines that are drawn along Z."""
    return properties(in_splines(body) if straight else body, splines=True)


def opening(wheel: WheelResult, gears: GearsInputs) -> Metre:
    """The radius inside which a wheel is open: of its bore, or its rim."""
    given = next(one for one in gears.wheels if one.name == wheel.name)
    return inner_diameter(wheel.root_diameter, given.bore_diameter, given.rim_thickness) / 2


def weighed_by_section(
    name: str, wheel: WheelResult, curves: ToothCurves | None, inside: Metre, rho: KilogramPerMetre3
) -> Weighed:
    """Mass and inertia of a section drawn along the axis, turned or not; `curves` None: a full circle of the reference
    diameter.  `inside`: radius of its bore.  Alike in all directions across the axis, as any of three teeth or more."""
    R, b = wheel.reference_diameter / 2, wheel.face_width
    area = (math.pi * R**2 if curves is None else curves.area) - math.pi * inside**2
    polar = (math.pi / 2 * R**4 if curves is None else curves.polar_moment) - math.pi / 2 * inside**4
    mass, J = rho * area * b, rho * polar * b * MM**2
    across = J / 2 + mass * (b * MM) ** 2 / 12
    return Weighed(name, area * b * MM**3, mass, np.zeros(3), np.diag([across, across, J]))


# --- its teeth


def toothed(curves: ToothCurves, b: float, twist: float) -> Shape:
    """The teeth with all inside them, the middle of the first along X in the middle of the face; `b` in mm, `twist` in
    radians a millimetre, positive for a right hand."""
    pitch = 2 * math.pi / curves.teeth
    tooth = wire(_tooth(curves))
    outline = wire([moved(tooth, turned=n * pitch) if n else tooth for n in range(curves.teeth)])
    if not twist:
        return prism(face_of(moved(outline, (0.0, 0.0, -b / 2))), b)
    count = max(SECTIONS, math.ceil(abs(twist) * b / TURN) + 1)
    return lofted([moved(outline, (0.0, 0.0, z), twist * z) for z in np.linspace(-b / 2, b / 2, count)])


def _tooth(curves: ToothCurves) -> list[Edge]:
    """From the root arc before a tooth to the end of its upper fillet, angles rising."""
    root, tip, fillet, involute = curves.root_angle, curves.tip_angle, curves.fillet, curves.involute
    beside = [float(np.angle(involute[0])), float(np.angle(fillet[-1]))]
    edges = [_arc(curves.root_radius, root - 2 * math.pi / curves.teeth, -root)] if curves.has_root else []
    edges.append(_through(fillet.conj()))
    edges += [_arc(abs(involute[0]), -beside[1], -beside[0])] if curves.step else []
    edges.append(_through(involute.conj()))
    edges += [_arc(curves.tip_radius, -tip, tip)] if curves.has_tip else []
    edges.append(_through(involute[::-1]))
    edges += [_arc(abs(involute[0]), *beside)] if curves.step else []
    edges.append(_through(fillet[::-1]))
    return edges


def _arc(radius: Metre, start: Radian, end: Radian) -> Edge:
    return arc(*(at(radius * MM, angle, 0.0) for angle in (start, (start + end) / 2, end)))


def _through(points: Outline) -> Edge:
    return spline([(float(p.real) * MM, float(p.imag) * MM, 0.0) for p in points])
