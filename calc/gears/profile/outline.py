# SPDX-License-Identifier: Apache-2.0
"""The outline of a tooth as the tool makes it: tip arc, involute, fillet, root arc, as a polyline within a chord error
of the true curve.

A point of a flank is given by its radius and its angle from the middle of the tooth; an outline is an array of complex
numbers, the middle of the first tooth on the real axis."""

import math

import numpy as np

from ...sheet.arrays import Array, ComplexArray
from ...sheet.errors import NoSolution
from ...sheet.record import record
from ...sheet.text import Text
from ...sheet.units import Metre, Number
from ..measures.formulas import generating_shift
from ..result import ToothSystem, WheelResult
from .cut import ROOT, Cut

# rule of this program: a polyline stays within a micrometre of the curve, if nothing else is asked
CHORD_ERROR: Metre = 1e-6
FINE = 65  # places at which the curvature of a fillet is looked at
SAFETY = 1.15  # more chords than a constant curvature between two points would ask for

Outline = ComplexArray


@record
class Regions:
    """One flank from root to tip, each region with the ends that it shares with its neighbours: (radius, angle)
    arrays."""

    root: tuple[Array, Array]
    fillet: tuple[Array, Array]
    involute: tuple[Array, Array]
    tip: tuple[Array, Array]


def shifts(system: ToothSystem, wheel: WheelResult) -> dict[str, Number]:
    """Generating shift of each outline of a wheel: "" without allowance; "max", "min" with the upper and the lower end
    of it."""
    shifts = {"": wheel.profile_shift}
    for end, E_W in zip(("max", "min"), wheel.allowance or ()):
        shifts[end] = generating_shift.function(wheel.profile_shift, E_W, system.m_n, system.alpha_n)
    return shifts


def regions(
    system: ToothSystem, wheel: WheelResult, chord_error: Metre = CHORD_ERROR, shift: Number | None = None
) -> Regions:
    """The four regions of one flank; a pointed tooth ends where its flanks meet.  `shift`: another one than that
    without allowance."""
    cut = Cut(system, wheel.teeth, wheel.profile_shift if shift is None else shift)
    end = cut.end_of_fillet
    form, corner = cut.fillet_point(end)
    base, tip = cut.base_radius, wheel.tip_diameter / 2
    if form >= tip:
        raise NoSolution(
            Text("wheel {name}: no involute is left below its tip circle", name=wheel.name),
            advice=Text("give it more profile shift"),
        )
    fillet = _fillet(cut, end, chord_error)
    radius, angle = _involute(
        cut, math.sqrt(max((form / base) ** 2 - 1, 0.0)), math.sqrt((tip / base) ** 2 - 1), chord_error
    )
    if abs(corner - angle[0]) * form > 1e-9 * system.m_n:  # finishing has left a step
        fillet = np.append(fillet[0], form), np.append(fillet[1], angle[0])
    root = _arc(cut.root_radius, math.pi / wheel.teeth, float(fillet[1][0]), chord_error)
    return Regions(root, fillet, (radius, angle), _arc(float(radius[-1]), float(angle[-1]), 0.0, chord_error))


def _fillet(cut: Cut, end: float, chord_error: Metre) -> tuple[Array, Array]:
    phi, chords = chords_of_fillet(cut, end, chord_error)
    wanted = (
        np.linspace(0.0, chords[-1], math.ceil(SAFETY * float(chords[-1])) + 1) if chords[-1] > 1 else chords[[0, -1]]
    )
    return cut.fillet(np.interp(wanted, chords, phi))


def chords_of_fillet(cut: Cut, end: float, chord_error: Metre = CHORD_ERROR) -> tuple[Array, Array]:
    """Directions of the normal from root to form circle, and how many chords its curvature asks for up to each of them:
    one of length s stands s²/8R off a curve of radius R."""
    phi = np.linspace(ROOT, end, FINE)
    radius, angle = cut.fillet(phi)
    step = np.diff(radius * np.exp(1j * angle))
    length = np.abs(step) + 1e-30
    turned = np.abs(np.angle(step[1:] * step[:-1].conj()))
    curvature = 2 * turned / (length[1:] + length[:-1])
    density = np.sqrt(np.concatenate([curvature[:1], curvature, curvature[-1:]]) / (8 * chord_error))
    return phi, np.concatenate([[0.0], np.cumsum((density[1:] + density[:-1]) / 2 * length)])


def _involute(cut: Cut, start: Number, end: Number, chord_error: Metre) -> tuple[Array, Array]:
    """Between two places t = tan α; the curvature is 1/(r_b·t), so equal steps of t^(3/2) stand equally far off.  Ends
    where θ is 0."""
    theta = cut.half_angle_at_base
    pointed = end - math.atan(end) > theta
    if pointed:
        end = math.tan(cut.pointed_angle)
    chords = 2 / 3 * (end**1.5 - start**1.5) * math.sqrt(cut.base_radius / (8 * chord_error))
    t = np.linspace(start**1.5, end**1.5, max(2, math.ceil(SAFETY * chords) + 1)) ** (2 / 3)
    t[0], t[-1] = start, end
    angle = theta - (t - np.arctan(t))
    if pointed:
        angle[-1] = 0.0
    return cut.base_radius * np.hypot(1.0, t), angle


def _arc(radius: Metre, start: float, end: float, chord_error: Metre) -> tuple[Array, Array]:
    """An arc about the wheel's axis."""
    widest = 2 * math.acos(max(1 - chord_error / radius, 0.0))
    count = max(1, math.ceil(abs(end - start) / widest))
    return np.full(count + 1, radius), np.linspace(start, end, count + 1)


def tooth(
    system: ToothSystem, wheel: WheelResult, chord_error: Metre = CHORD_ERROR, shift: Number | None = None
) -> Outline:
    """One whole tooth, from the middle of a root to the middle of the next, angles rising."""
    return whole_tooth(regions(system, wheel, chord_error, shift))


def whole_tooth(flank: Regions) -> Outline:
    """Both flanks from one, which is the upper."""
    parts = (flank.root, flank.fillet, flank.involute, flank.tip)
    radius = np.concatenate([p[0][:-1] for p in parts] + [flank.tip[0][-1:]])
    angle = np.concatenate([p[1][:-1] for p in parts] + [flank.tip[1][-1:]])
    half: Outline = radius * np.exp(1j * angle)
    return np.concatenate([half.conj(), half[-2::-1]])


def repeated(tooth: Outline, z: int, teeth: range | None = None) -> Outline:
    """The teeth with the given numbers (all of them: a closed line, its first point again at its end), number 0 on the
    real axis."""
    numbers = np.arange(z) if teeth is None else np.asarray(teeth)
    turns = np.exp(2j * np.pi * numbers / z)
    # a closed line ends in the very point in which it begins
    last = tooth[:1] if teeth is None else tooth[-1:] * turns[-1]
    return np.concatenate([np.outer(turns, tooth[:-1]).ravel(), last])
