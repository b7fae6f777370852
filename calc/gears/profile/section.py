# SPDX-License-Identifier: Apache-2.0
"""The transverse section of a wheel as the curves that bound it, and what they enclose.

Arcs are told by radius and angle; fillet and involute by points of their own, through which a spline is laid.  Area and
polar moment are Gauss integrals along the true curves: those of a polyline that stays within a micrometre of them are
some 3·10⁻⁵ too small."""

import math

import numpy as np

from ...sheet.arrays import Array
from ...sheet.errors import NoSolution
from ...sheet.record import record
from ...sheet.text import Text
from ...sheet.units import Metre, Metre4, Number, Radian, SquareMetre
from ..result import ToothSystem, WheelResult
from .cut import ROOT, Cut
from .outline import Outline, chords_of_fillet

# Of a spline.  On the fillet as close as its curvature asks for, on the involute in equal steps of the angle of roll:
# the area is then exact to 5·10⁻⁸.  At equal lengths it is to 10⁻⁵ where an involute begins on its base circle.
POINTS = 25
NODES = 48  # of a Gauss integral along one fillet or one involute: exact to the last digits
LEAST = 1e-9  # of the module: an arc that is no longer is none


@record
class ToothCurves:
    """One tooth, its middle on the real axis, by its upper flank; the lower one is its mirror image.

    The root arc runs from the fillet's first point to that of the next tooth.  `step`: the fillet ends beside the
    involute, on one circle with its beginning, where finishing has left a step.  Where `tip_angle` is 0 the flanks meet
    in a point.  `area` and `polar_moment` are those of the whole section, without a bore.
    """

    teeth: int
    root_radius: Metre
    root_angle: Radian  # of the fillet's first point, from the middle of the tooth
    fillet: Outline
    involute: Outline
    step: bool
    tip_radius: Metre
    tip_angle: Radian
    area: SquareMetre
    polar_moment: Metre4

    @property
    def has_root(self) -> bool:
        """Whether a root arc is left between two teeth."""
        return math.pi / self.teeth - self.root_angle > LEAST

    @property
    def has_tip(self) -> bool:
        """Whether a tip arc is left between the flanks of a tooth."""
        return self.tip_angle > LEAST


def section(system: ToothSystem, wheel: WheelResult, shift: Number | None = None, points: int = POINTS) -> ToothCurves:
    """The section of a wheel; `shift`: another generating shift than that without allowance.

    Raises NoSolution where no involute is left below the tip circle."""
    cut = Cut(system, wheel.teeth, wheel.profile_shift if shift is None else shift)
    end = cut.end_of_fillet
    form, corner = cut.fillet_point(end)
    tip = wheel.tip_diameter / 2
    if form >= tip:
        raise NoSolution(
            Text("wheel {name}: no involute is left below its tip circle", name=wheel.name),
            advice=Text("give it more profile shift"),
        )
    start = math.sqrt(max((form / cut.base_radius) ** 2 - 1, 0.0))
    stop = math.sqrt((tip / cut.base_radius) ** 2 - 1)
    if stop - math.atan(stop) > cut.half_angle_at_base:  # pointed
        stop = math.tan(cut.pointed_angle)
    phi, chords = chords_of_fillet(cut, end)
    radius, angle = cut.fillet(np.interp(np.linspace(0.0, chords[-1], points), chords, phi))
    t = np.linspace(start, stop, points)
    involute = cut.base_radius * np.hypot(1.0, t) * np.exp(1j * _angle(cut, t))
    tip_radius, tip_angle = abs(involute[-1]), max(float(_angle(cut, t)[-1]), 0.0)
    first, beside = float(angle[0]), float(_angle(cut, t)[0])
    moments = [
        math.pi / wheel.teeth * cut.root_radius**n
        - first * cut.root_radius**n
        - _along_fillet(cut, end, n)
        + (corner - beside) * form**n
        + _along_involute(cut, start, stop, n)
        + tip_angle * tip_radius**n
        for n in (2, 4)
    ]
    return ToothCurves(
        teeth=wheel.teeth,
        root_radius=cut.root_radius,
        root_angle=first,
        fillet=radius * np.exp(1j * angle),
        involute=involute,
        step=abs(corner - beside) * form > LEAST * system.m_n,
        tip_radius=tip_radius,
        tip_angle=tip_angle,
        area=wheel.teeth * moments[0],
        polar_moment=wheel.teeth * moments[1] / 2,
    )


def _angle(cut: Cut, t: Array) -> Array:
    """Of points of the involute from the middle of the tooth, t = tan α."""
    angle: Array = cut.half_angle_at_base - (t - np.arctan(t))
    return angle


def _gauss(low: float, high: float) -> tuple[Array, Array]:
    """Places and weights of an integral."""
    x, w = np.polynomial.legendre.leggauss(NODES)
    return (low + high) / 2 + (high - low) / 2 * x, (high - low) / 2 * w


def _along_fillet(cut: Cut, end: Radian, n: int) -> float:
    """∫ rⁿ dθ from root to form circle."""
    phi, w = _gauss(ROOT, end)
    radius, _ = cut.fillet(phi)
    return float(np.sum(w * radius**n * cut.turn_of_fillet(phi)))


def _along_involute(cut: Cut, start: Number, stop: Number, n: int) -> float:
    """−∫ rⁿ dθ from form to tip circle: dθ = −t²/(1 + t²) dt."""
    t, w = _gauss(start, stop)
    return float(np.sum(w * (cut.base_radius * np.hypot(1.0, t)) ** n * t**2 / (1 + t**2)))
