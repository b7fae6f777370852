# SPDX-License-Identifier: Apache-2.0
"""The outline of a tooth as the tool makes it: tip arc, involute, fillet, root arc.

The corner of the rack is a circle in the normal section, so an ellipse in the transverse one.  Each of its points cuts when its
normal passes through the pitch point: the fillet is that envelope, and meets the involute with a common tangent at the form
circle, or crosses it where the tooth is undercut.  A point of a flank is given by its radius and its angle from the middle of the
tooth; an outline is an array of complex numbers, the middle of the first tooth on the real axis.
"""

from typing import Any

import numpy as np

from ...sheet.arrays import Array, ComplexArray
from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.functions import inv
from ...sheet.record import record
from ...sheet.units import Metre
from ..result import ToothSystem, WheelResult

Outline = ComplexArray


@record
class Cut:
    """One wheel as the tool sees it."""

    system: ToothSystem
    teeth: int
    shift: float

    @property
    def pitch_radius(self) -> float:
        return self.teeth * self.system.transverse_module / 2

    @property
    def base_radius(self) -> float:
        return self.pitch_radius * float(np.cos(self.system.transverse_pressure_angle))

    def involute(self, radius: Any) -> Any:
        """Angle of the involute from the middle of the tooth."""
        s = self.system
        reference = (np.pi / 2 + 2 * self.shift * np.tan(s.alpha_n)) / self.teeth
        alpha = np.arccos(np.minimum(self.base_radius / np.asarray(radius), 1.0))
        return reference + inv(s.transverse_pressure_angle) - (np.tan(alpha) - alpha)

    def fillet(self, phi: Array) -> tuple[Array, Array]:
        """Radius and angle from the middle of the tooth, where the corner's normal points along φ: −π/2 at the root, −α_n at the flank."""
        s = self.system
        r = self.pitch_radius
        rho = s.rho_aP0 * s.m_n
        v_c = (s.rho_aP0 + self.shift - s.h_fP) * s.m_n
        u = self._corner + rho / np.cos(s.beta) * np.cos(phi)
        v = v_c + rho * np.sin(phi)
        X = v * np.cos(phi) * np.cos(s.beta) / np.sin(phi)  # where the normal passes through the pitch point
        return np.hypot(X, v + r), np.pi / self.teeth - (np.arctan2(X, v + r) - (X - u) / r)

    @property
    def _corner(self) -> float:
        """Distance of the corner's centre from the middle of the tool's tooth."""
        s = self.system
        alpha_t = s.transverse_pressure_angle
        straight = np.pi * s.transverse_module / 4 - (s.h_fP - s.rho_aP0) * s.m_n * np.tan(alpha_t)
        return float(straight - (s.rho_aP0 * s.m_n - s.s_pr) / (np.cos(s.alpha_n) * np.cos(s.beta)))

    def end_of_fillet(self) -> float:
        """φ where the fillet leaves the outline: at the flank, or where it crosses the involute of an undercut tooth."""
        s = self.system
        low, high = -np.pi / 2, -s.alpha_n
        if self.shift >= _undercut_limit(s, self.teeth):
            return float(high)
        for _ in range(12):  # the gap falls through 0 once between base circle and flank; each pass narrows it 32 times
            phi = np.linspace(low, high, 33)
            radius, angle = self.fillet(phi)
            uncut = (radius > self.base_radius) & (angle > self.involute(radius))
            first = int(np.argmax(uncut)) if uncut.any() else 32
            low, high = phi[max(first - 1, 0)], phi[first]
        return float(high)


def _undercut_limit(s: ToothSystem, teeth: int) -> float:
    straight = s.h_fP - s.rho_aP0 * (1 - np.sin(s.alpha_n))
    return float(straight - teeth * np.sin(s.transverse_pressure_angle) ** 2 / (2 * np.cos(s.beta)))


@formula("d_Ff", "envelope of the tool's corner", unit="mm", shows="crossing of the tool's trochoid and the involute of the undercut tooth")
def form_diameter_of_undercut(cut: Cut) -> Metre:
    radius, _ = cut.fillet(np.array([cut.end_of_fillet()]))
    return 2 * float(radius[0])


@record
class Regions:
    """One flank from root to tip, each region with the ends that it shares with its neighbours: (radius, angle) arrays."""

    root: tuple[Array, Array]
    fillet: tuple[Array, Array]
    involute: tuple[Array, Array]
    tip: tuple[Array, Array]


def regions(system: ToothSystem, wheel: WheelResult, points: int = 16) -> Regions:
    """The four regions of one flank; a pointed tooth ends where its flanks meet."""
    cut = Cut(system, wheel.teeth, wheel.profile_shift)
    base, tip, form = wheel.base_diameter / 2, wheel.tip_diameter / 2, wheel.form_diameter / 2
    if form >= tip:
        raise NoSolution(f"wheel {wheel.name}: no involute is left below its tip circle", advice="give it more profile shift")
    fillet = cut.fillet(np.linspace(-np.pi / 2, cut.end_of_fillet(), points))
    rho = np.linspace(np.sqrt(max(form**2 - base**2, 0.0)), np.sqrt(tip**2 - base**2), points)
    radius = np.hypot(base, rho)
    angle = cut.involute(radius)
    if angle[-1] < 0:
        pointed = np.interp(0.0, angle[::-1], radius[::-1])
        keep = angle > 0
        radius, angle = np.append(radius[keep], pointed), np.append(angle[keep], 0.0)
    few = max(points // 4, 2)
    root = np.full(few, fillet[0][0]), np.linspace(np.pi / wheel.teeth, fillet[1][0], few)
    top = np.full(few, radius[-1]), np.linspace(angle[-1], 0.0, few)
    return Regions(root, fillet, (radius, angle), top)


def tooth(system: ToothSystem, wheel: WheelResult, points: int = 16) -> Outline:
    """One whole tooth, from the middle of a root to the middle of the next, angles rising."""
    flank = regions(system, wheel, points)
    parts = (flank.root, flank.fillet, flank.involute, flank.tip)
    radius = np.concatenate([p[0][:-1] for p in parts] + [flank.tip[0][-1:]])
    angle = np.concatenate([p[1][:-1] for p in parts] + [flank.tip[1][-1:]])
    half: Outline = radius * np.exp(1j * angle)
    return np.concatenate([half.conj(), half[-2::-1]])


def outline(system: ToothSystem, wheel: WheelResult, points: int = 16, teeth: range | None = None) -> Outline:
    """The teeth with the given numbers (all of them: a closed line), number 0 on the real axis."""
    numbers = range(wheel.teeth) if teeth is None else teeth
    one = tooth(system, wheel, points)
    turned = [one[:-1] * np.exp(2j * np.pi * k / wheel.teeth) for k in numbers]
    last = one[-1:] * np.exp(2j * np.pi * numbers[-1] / wheel.teeth)
    return np.concatenate([*turned, last])
