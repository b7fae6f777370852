# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="no-any-return"
"""How a rolling bearing gives way to a load, and how hard its most loaded element presses.

F = Z·K_1·(δ − s/2)^n·J_r(ε), ε = (1 − s/(2δ))/2: δ is how far the inner ring lies off the middle, s the clearance
(diametral, below 0 where the elements are preloaded), K_1 the load that brings both races of an element nearer by 1
mm.

Few elements: where clearance leaves a zone so narrow that the sum would be less than one element carries alone, one
carries all, F = K_1·(δ − s/2)^n.  Elements that are preloaded always share."""

import math
from typing import Any

import numpy as np

from ...countershaft.bending.carried import Hold
from ...sheet.arrays import Array
from ...sheet.formula import formula
from ...sheet.functions import acos, largest, modulus, power, single_or_many
from ...sheet.record import record
from ...sheet.text import Amount, Text
from ...sheet.units import Hertz, Metre, Newton, NewtonPerMetre, Number, Radian, RevPerSecond
from .geometry import Inside, gamma_of, inner_raceway
from .hertz import HERTZ, PLANE, BallContact, line_pressure, line_width, shear_depth
from .sizes import Elements
from .zone import EXPONENTS, zone_of

MILLIMETRE: Metre = 1e-3
ONE_NEWTON: Newton = 1.0
NOTHING: Newton = 1e-9  # a load that no bearing feels, in place of none
NOWHERE: Metre = 1e-25
STEPS, NEAR = 8, 1e-9  # of Newton's method: at most, and of the way: the next step would reach the last digits

LAW = Text("ISO/TS 16281, from memory, with {hertz}", hertz=HERTZ)


# --- one element


@formula("K_1", Text("{hertz}: balls, by what 1 N brings both races nearer", hertz=HERTZ), unit="kN")
def contact_of_balls(delta_i: Metre, delta_e: Metre) -> Newton:
    return power((delta_i + delta_e) / MILLIMETRE, -1.5) * ONE_NEWTON


@formula("K_1", "ISO/TS 16281, from memory: rollers, both races", unit="kN")
def contact_of_rollers(L_we: Metre) -> Newton:
    return 35948 * power(L_we / MILLIMETRE, 8 / 9) * ONE_NEWTON


def ball_contacts(inside: Inside[Any]) -> tuple[BallContact, BallContact]:
    """A ball on the inner and on the outer raceway."""
    D_w, gamma = inside.diameter, gamma_of(inside)
    return (
        BallContact(D_w, gamma, inside.groove_inner, inner=True),
        BallContact(D_w, gamma, inside.groove_outer, inner=False),
    )


def contact_constant(inside: Inside[Any]) -> Any:
    """K_1 of a bearing."""
    if inside.elements == "roller":
        return contact_of_rollers(L_we=inside.roller_length)
    inner, outer = ball_contacts(inside)
    return contact_of_balls(delta_i=inner.approach(ONE_NEWTON), delta_e=outer.approach(ONE_NEWTON))


def pressure_of(inside: Inside[Any], Q: Any) -> tuple[Any, Any]:
    """The largest pressure under the load Q of an element, and the depth of its largest shear stress (None of balls).

    Balls: of both races; rollers: on the inner one, which is curved more."""
    if inside.elements == "ball":
        inner, outer = (contact.pressure(Q) for contact in ball_contacts(inside))
        return largest(inner, outer), None
    F_w = inner_raceway(D_pw=inside.pitch, D_w=inside.diameter)
    b = line_width(Q=Q, L_we=inside.roller_length, E_r=PLANE, D_w=inside.diameter, F_w=F_w)
    return line_pressure(Q=Q, L_we=inside.roller_length, b=b), shear_depth(b=b)


# --- all elements


@formula(
    "δ_r",
    Text("{law}; the loads of the elements hold F", law=LAW),
    shows="δ_r with F = Z·K_1·(δ_r − G_r/2)^n_Q·J_r(ε), no less than one element carries alone; by Newton's method",
    unit="µm",
)
def displacement(F: Newton, Z: Number, K_1: Newton, s: Metre, elements: Elements) -> Metre:
    return Springs(elements, Z, K_1, s).displacement(F)


@formula("ε", "geometry: reach of the loaded zone over the diameter", names={"s": "G_r", "delta": "δ_r"})
def reach(s: Metre, delta: Metre) -> Number:
    return (1 - s / (2 * delta)) / 2


@formula("φ_z", "geometry: loaded zone; all round from ε = 1 on", names={"eps": "ε"})
def load_zone(eps: Number) -> Radian:
    return 2 * acos(largest(1 - 2 * eps, -1.0))


@formula(
    "Q_max",
    Text("{law}: load of the element in the middle of the zone", law=LAW),
    names={"s": "G_r", "n_c": "n_Q", "delta": "δ_r"},
    meanings={"n_c": "Exponent of the load over the approach"},
)
def largest_load(K_1: Newton, delta: Metre, s: Metre, n_c: Number) -> Newton:
    return K_1 * power((delta - s / 2) / MILLIMETRE, n_c)


@formula(
    "k_r",
    Text("{law}: slope of the load over the displacement", law=LAW),
    shows="dF/dδ_r = F/(δ_r − G_r/2)·(n_Q + G_r/(2·δ_r)·d ln J_r/d ln ε)",
    unit="kN/mm",
)
def stiffness(delta: Metre, Z: Number, K_1: Newton, s: Metre, elements: Elements) -> NewtonPerMetre:
    return single_or_many(np.asarray(Springs(elements, Z, K_1, s).force(delta)[1]))


@formula(
    "f_pass",
    "kinematics: elements pass a load that turns with the inner ring",
    unit="Hz",
    meanings={"Z": "Number of rolling elements"},
)
def pass_frequency(Z: Number, n: RevPerSecond, gamma: Number) -> Hertz:
    return Z * modulus(n) * (1 + gamma) / 2


@record
class Springs:
    """The elements of a bearing as what holds its inner ring, of one bearing or of many alike: Z and K_1 (`contact`, N)
    as above, s the clearance (`gap`), m.  Of one bearing it is a support of a shaft
    (`countershaft.bending.carried.Law`), whose load has the direction of the displacement.

    `stiff`: the share of K_1 that counts, below 1 only where a solution is looked for."""

    elements: Elements
    count: Any  # a number, or an array of many
    contact: Any
    gap: Any
    stiff: Number = 1.0

    def force(self, e: Any) -> tuple[Any, Any, Any]:
        """F, dF/de and F/e where the inner ring lies off the middle by e; at the middle the limits of them."""
        n, s, Z = EXPONENTS[self.elements].n, self.gap, self.count
        K, e = self.stiff * self.contact, np.maximum(e, NOWHERE)
        pressed = np.maximum(e - s / 2, 0.0)
        J_r, bend = zone_of(self.elements).radial(pressed / (2 * e))
        alone = (Z * J_r < 1) & (s >= 0)
        carry, bend = np.where(alone, 1.0, Z * J_r), np.where(alone, 0.0, bend)
        by_slope = carry * K / MILLIMETRE * (pressed / MILLIMETRE) ** (n - 1)
        secant = by_slope * pressed / e
        return secant * e, by_slope * (n + bend * s / (2 * e)), secant

    def displacement(self, F: Any) -> Any:
        """Where the bearing carries F, all at once.  A load of nothing is taken as the least there is.

        By Newton's method on the logarithms of F and of the way beyond half the clearance: the slope between these is
        nowhere twice as steep as elsewhere, so that each step comes nearer."""
        F, taken_up = np.maximum(F, NOTHING), np.maximum(self.gap, 0.0) / 2
        way = MILLIMETRE * (F / (self.stiff * self.contact * self.count / 4)) ** (1 / EXPONENTS[self.elements].n)
        for _ in range(STEPS):
            held, slope, _ = self.force(taken_up + way)
            more = (F / held) ** (held / (slope * way))
            way = way * more
            if not np.any(np.abs(more - 1) > NEAR):
                break
        return single_or_many(np.asarray(taken_up + way))

    def alone(self, e: Any) -> Any:
        """Whether one element carries all."""
        J_r, _ = zone_of(self.elements).radial(np.maximum(e - self.gap / 2, 0.0) / (2 * np.maximum(e, NOWHERE)))
        return (self.count * J_r < 1) & (self.gap >= 0)

    # --- as a support

    def hold_many(self, e: Array) -> Hold[Array]:
        _, slope, secant = self.force(e)
        return Hold(secant * e, slope, secant, np.zeros(e.shape), np.zeros(e.shape))

    def hold(self, e: Metre) -> Hold:
        _, slope, secant = self.force(e)
        return Hold(secant * e, slope, secant) if np.ndim(e) else Hold(float(secant) * e, float(slope), float(secant))

    def begin(self, F: Newton) -> Metre:
        return float(self.displacement(F))

    def farthest(self, e: Metre) -> Metre:
        return math.inf

    def softer(self, share: Number) -> "Springs":
        return Springs(self.elements, self.count, self.contact, self.gap, share)

    def said(self, name: str, e: Metre) -> Text:
        return Text("bearing {name}: play {s}", name=name, s=Amount(self.gap * 1e6, "µm"))
