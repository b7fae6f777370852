# SPDX-License-Identifier: Apache-2.0
"""One wheel as its tool cuts it: the flank, the fillet that the round corner of the tool leaves, and where one passes
into the other.

The corner of the rack is a circle in the normal section, so an ellipse in the transverse one.  Each of its points cuts
when its normal passes through the pitch point: the fillet is that envelope.  φ is the direction of the corner's normal:
−π/2 at the root, −α_n where the corner touches the tool's flank.  A tool with protuberance goes on beyond −α_n, towards
0, until its corner has come back to the finished flank; it cuts as computed here where the flank of its protuberance
has no larger angle than −φ at the end of the fillet.  A point of a flank is given by its radius and its angle from the
middle of the tooth."""

import math
from collections.abc import Callable
from functools import cached_property

import numpy as np

from ...sheet.arrays import Array
from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.record import record
from ...sheet.text import Amount, Text
from ...sheet.units import Metre, Number, Radian
from .. import formulas as f
from ..limits import mm
from ..result import ToothSystem

ROOT: Radian = -math.pi / 2  # direction of the corner's normal at the root
FLATTEST: Radian = -1e-3  # as far as a corner with protuberance is followed: at 0 it would cut at an endless distance


@record
class Cut:
    """One wheel as the tool sees it.  `shift` x, or the generating x_E of a tooth with an allowance."""

    system: ToothSystem
    teeth: int
    shift: Number

    @cached_property
    def pitch_radius(self) -> Metre:
        return self.teeth * self.system.transverse_module / 2

    @cached_property
    def base_radius(self) -> Metre:
        return self.pitch_radius * math.cos(self.system.transverse_pressure_angle)

    @cached_property
    def root_radius(self) -> Metre:
        return self.pitch_radius + (self.shift - self.system.h_fP) * self.system.m_n

    @cached_property
    def half_angle_at_base(self) -> Radian:
        """Angle of the involute from the middle of the tooth, where it begins at the base circle."""
        alpha_t = self.system.transverse_pressure_angle
        reference = (math.pi / 2 + 2 * self.shift * math.tan(self.system.alpha_n)) / self.teeth
        return reference + math.tan(alpha_t) - alpha_t

    @cached_property
    def pointed_angle(self) -> Radian:
        """Pressure angle where the flanks of a tooth meet; 0 where they do so inside the base circle."""
        return f.angle_of_involute.function(self.half_angle_at_base)

    @cached_property
    def offset_of_tool(self) -> Radian:
        """How far the involute that the tool leaves stands off the finished one: s_pr over the base circle, positive
        inside the tooth."""
        return self.system.s_pr / (math.cos(self.system.base_helix_angle) * self.base_radius)

    @cached_property
    def _corner(self) -> tuple[float, float, float, float]:
        """Centre of the corner (from the middle of the tool's tooth, from the reference circle), its semi-axes."""
        s = self.system
        rho = s.rho_aP0 * s.m_n
        u_c = f.tool_corner_position.function(
            s.transverse_module, s.h_fP, s.rho_aP0, s.m_n, s.transverse_pressure_angle, s.alpha_n, s.beta, s.s_pr
        )
        return u_c, (s.rho_aP0 + self.shift - s.h_fP) * s.m_n, rho / math.cos(s.beta), rho

    # --- points

    def involute(self, radius: Array | Metre) -> Array:
        """Angle of the involute from the middle of the tooth; inside the base circle, that of its beginning."""
        alpha = np.arccos(np.minimum(self.base_radius / np.asarray(radius), 1.0))
        return self.half_angle_at_base - (np.tan(alpha) - alpha)

    def fillet(self, phi: Array) -> tuple[Array, Array]:
        """Radius and angle from the middle of the tooth, where the corner's normal has the direction φ."""
        u_c, v_c, wide, rho = self._corner
        r, slant = self.pitch_radius, math.cos(self.system.beta)
        sin, cos = np.sin(phi), np.cos(phi)
        v = v_c + rho * sin
        X, Y = v * cos * slant / sin, v + r  # where the normal passes through the pitch point
        return np.hypot(X, Y), math.pi / self.teeth - (np.arctan2(X, Y) - (X - u_c - wide * cos) / r)

    def fillet_point(self, phi: Radian) -> tuple[Metre, Radian]:
        """`fillet` of one direction."""
        u_c, v_c, wide, rho = self._corner
        r, slant = self.pitch_radius, math.cos(self.system.beta)
        sin, cos = math.sin(phi), math.cos(phi)
        v = v_c + rho * sin
        X, Y = v * cos * slant / sin, v + r
        return math.hypot(X, Y), math.pi / self.teeth - (math.atan2(X, Y) - (X - u_c - wide * cos) / r)

    def turn_of_fillet(self, phi: Array) -> Array:
        """dθ/dφ of the fillet: how its angle from the middle of the tooth changes with the direction of the normal."""
        _, v_c, wide, rho = self._corner
        r, slant = self.pitch_radius, math.cos(self.system.beta)
        sin, cos = np.sin(phi), np.cos(phi)
        v = v_c + rho * sin
        X, Y = v * cos * slant / sin, v + r
        dX, dY = slant * (rho * cos**2 / sin - v / sin**2), rho * cos
        turn: Array = (dX + wide * sin) / r - (Y * dX - X * dY) / (X**2 + Y**2)
        return turn

    # --- the end of the fillet

    @cached_property
    def end_of_fillet(self) -> Radian:
        """φ where the fillet leaves the outline.

        At the flank; with protuberance, or where the tooth is undercut, at the crossing with the finished involute.  A
        tool that leaves more stock than it has protuberance ends it at the end of its own involute: the finishing tool
        leaves a step there. Raises NoSolution where the corner of a tool with protuberance never comes back to the
        flank."""
        s, flank = self.system, -self.system.alpha_n
        if s.s_pr > 0:
            if self._off(flank, 0.0) < 0:
                return self._return_of_the_corner(flank)
            crossing = self._undercut(0.0)
            return flank if crossing is None else crossing
        x_min = f.undercut_limit.function(s.h_fP, s.rho_aP0, s.alpha_n, self.teeth, s.transverse_pressure_angle, s.beta)
        if self.shift >= x_min:
            return flank
        crossing = self._undercut(0.0)
        if crossing is None:
            crossing = self._undercut(self.offset_of_tool)
        return flank if crossing is None else crossing

    def _off(self, phi: Radian, offset: Radian) -> Radian:
        """Angle by which the fillet stands off an involute: negative where it cuts into it.  `offset`: of that
        involute, inwards."""
        radius, angle = self.fillet_point(phi)
        cosine = self.base_radius / radius
        alpha = math.acos(cosine) if cosine < 1 else 0.0
        return angle - (self.half_angle_at_base - offset - math.tan(alpha) + alpha)

    def _undercut(self, offset: Radian) -> Radian | None:
        """Where the trochoid of an undercut tooth crosses the involute, between base circle and flank; None: it does
        not cut into it."""
        flank, r_b = -self.system.alpha_n, self.base_radius
        low = ROOT
        if self.root_radius < r_b:
            if self.fillet_point(flank)[0] <= r_b:
                return flank
            low = _root(lambda phi: self.fillet_point(phi)[0] - r_b, ROOT, flank)
        if self._off(low, offset) >= 0:
            return None
        return _root(lambda phi: self._off(phi, offset), low, flank) if self._off(flank, offset) > 0 else flank

    def _return_of_the_corner(self, flank: Radian) -> Radian:
        """Where the fillet of a tool with protuberance crosses the finished involute: before the corner comes back to
        the flank line."""
        s, low, step = self.system, flank, 0.02
        while self._off(high := min(low + step, FLATTEST), 0.0) <= 0:
            if high == FLATTEST:
                raise NoSolution(
                    Text(
                        "protuberance: it stands {s_pr} mm out beyond the finished flank, and what it cuts never "
                        "comes back to it",
                        s_pr=mm(s.s_pr, ".4g"),
                    ),
                    advice=Text(
                        "a round corner of this tip radius comes back from {largest_residual_undercut} mm: give a "
                        "smaller gears.protuberance_mm, a larger gears.stock_mm or tip radius, or less profile shift",
                        largest_residual_undercut=mm(largest_residual_undercut(s), ".4g"),
                    ),
                )
            low, step = high, 2 * step
        return _root(lambda phi: self._off(phi, 0.0), low, high)


def _root(function: Callable[[float], float], low: float, high: float) -> float:
    """Where a function that is negative at `low` and positive at `high` passes through 0, to the last digits: regula
    falsi (Illinois)."""
    f_low, f_high = function(low), function(high)
    if f_low == 0 or f_high == 0:
        return low if f_low == 0 else high
    side = 0
    for n in range(200):
        at, middle = (low * f_high - high * f_low) / (f_high - f_low), (low + high) / 2
        if n % 8 == 7 or not low < at < high:  # a chord that rounding puts at an end says nothing: halve
            at = middle
        if high - low < 1e-15 or not low < at < high:
            break
        f = function(at)
        if f == 0:
            return at
        if f < 0:
            low, f_low = at, f
            f_high, side = (f_high / 2, -1) if side == -1 else (f_high, -1)
        else:
            high, f_high = at, f
            f_low, side = (f_low / 2, 1) if side == 1 else (f_low, 1)
    return (low + high) / 2


@formula(
    "d_Ff",
    "geometry: envelope of the tool's corner",
    unit="mm",
    shows="crossing of the fillet that the tool's corner cuts and the involute",
)
def form_diameter_of_undercut(cut: Cut) -> Metre:
    """Where the finished involute begins, for a tooth that is undercut by generation or by a protuberance."""
    return 2 * cut.fillet_point(cut.end_of_fillet)[0]


# --- the tool


def largest_residual_undercut(s: ToothSystem) -> Metre:
    """How far a corner circle can stand out beyond the flank and come back to it before its side is upright: ρ(1 − cos
    α_n)."""
    return s.rho_aP0 * s.m_n * (1 - math.cos(s.alpha_n))


def finishing_step(s: ToothSystem) -> Metre:
    """Step that finishing leaves above the fillet, normal to the flank: stock that the protuberance does not cover; 0
    without one."""
    return max(0.0, -s.s_pr)


def tool_problem(s: ToothSystem) -> NoSolution | None:
    """Why there is no such tool, and what is allowed; None: there is."""
    corner = f.tool_corner_position(
        m_t=s.transverse_module,
        h_fP=s.h_fP,
        rho_aP0=s.rho_aP0,
        m_n=s.m_n,
        alpha_t=s.transverse_pressure_angle,
        alpha_n=s.alpha_n,
        beta=s.beta,
        s_pr=s.s_pr,
    )
    if corner >= -1e-9 * s.m_n:
        return None
    cosines, tangent = math.cos(s.alpha_n) * math.cos(s.beta), math.tan(s.transverse_pressure_angle)
    straight = math.pi * s.transverse_module / 4
    widest = (straight - s.h_fP * s.m_n * tangent + s.s_pr / cosines) / ((1 / cosines - tangent) * s.m_n)
    # of the tool itself, where its sharp corners meet
    deepest = (straight + (s.s_pr + s.stock) / cosines) / (tangent * s.m_n)
    advice = Text("give a gears.tool_addendum of less than {down}: that much with sharp corners", down=_down(deepest))
    if widest >= 0:
        advice = Text(
            "give a gears.tool_tip_radius of at most {down}, or a smaller gears.tool_addendum", down=_down(widest)
        )
    overlap = Text(
        "gears.tool_tip_radius = {rho_ap0} with gears.tool_addendum = {h_ap0}: the round corners of such a tool "
        "overlap by {corner} mm",
        rho_ap0=Amount(s.rho_aP0, form="g"),
        h_ap0=Amount(s.h_aP0, form="g"),
        corner=Amount(-2000.0 * corner, form=".4g"),
    )
    return NoSolution(overlap, advice=advice)


def _down(limit: Number) -> str:
    """Four digits, of which none is rounded up: what is said to be allowed is allowed."""
    return f"{math.floor(limit * 1e4) / 1e4:.4f}"


def protuberance_note(cut: Cut) -> str:
    """What the hob's protuberance must be like for the fillet to be as it is computed; empty where nothing depends on
    it.

    A round corner alone comes back to the flank from at most ρ(1 − cos α_n); a straight flank of the protuberance
    carries it on."""
    if cut.system.s_pr <= 0 or cut.end_of_fillet <= -cut.system.alpha_n:
        return ""
    angle = math.degrees(-cut.end_of_fillet)
    return Text(
        "the fillet is as computed if the flank of the hob's protuberance stands at most {angle}° from the upright",
        angle=Amount(angle, form=".1f"),
    )
