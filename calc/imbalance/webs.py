# SPDX-License-Identifier: Apache-2.0
"""The crank on the balancing machine: its webs and pins, what to drill off them, and the bobs that it needs.

With them the couple that pulley and flywheel must supply.

x is up and y 90° further in the sense of rotation while the throw named in the design stands up; z from mid-engine.  As
complex numbers p = x + i·y: static unbalance S = Σ m·p, couple product C = Σ m·p·z."""

import math
from collections.abc import Iterable
from itertools import combinations
from typing import Annotated

import numpy as np

from ..engine.crank import pin_of_cylinder
from ..engine.inputs import EngineInputs
from ..engine.result import EngineResult
from ..library.tolerances import grade_number, permitted_unbalance
from ..sheet.arrays import Array, ComplexArray, Num
from ..sheet.formula import formula
from ..sheet.functions import argument, cis, imag, modulus, resultant, total
from ..sheet.linked_array import column, elements, gathered
from ..sheet.quantity import Described, Stated, group, result, value
from ..sheet.record import replace
from ..sheet.shown import Shown
from ..sheet.step import Table
from ..sheet.text import Text
from ..sheet.units import (
    Kilogram,
    KilogramMetre,
    KilogramMetre2,
    KilogramMetres,
    Kilograms,
    Metre,
    Metres,
    Newton,
    NewtonMetre,
    PhasorKilogramMetre,
    PhasorKilogramMetre2,
    PhasorKilogramMetres,
    PhasorMetres,
    PhasorNewton,
    PhasorNewtonMetre,
    PhasorSquareMetre,
    PhasorSquareMetres,
    Radian,
    Radians,
    RadPerSecond,
)
from ..sheet.value import about, based_on, untraced
from . import formulas as f
from . import orders as u
from .inputs import ImbalanceInputs
from .orders import DUST
from .remedies import crank_masses

# --- which webs to drill, by how many grams and where: what a balancing machine says (Finotti 2013, 2.6)
# A web is drilled away from its pin only, within `WITHIN` of the direction opposite to it: that is a rule of this
# program.  A mass along any direction there is the sum of shares along the two ends of that range, so that the least
# mass that leaves neither force nor couple is the best corner of a small linear programme.

WITHIN = math.radians(75.0)  # to either side of the direction opposite to the pin
MOST = 16  # webs of which the best choice is looked for
UNDRILLED = Text(
    "Which webs to drill is not found: it takes the bodies of the crank with at least two webs, and an unbalance that "
    "holes within {degrees}° of the side away from the pins can take; else bobs or webs must change.",
    degrees=round(math.degrees(WITHIN)),
)
SOURCE = Text(
    "Finotti 2013, 2.6: the machine says which webs to drill and how much; here the least mass in all that leaves S = "
    "0 and C = 0"
)


@formula(
    "U_k",
    SOURCE,
    shows="least Σ|U_k|/r_d with ΣU_k = S, ΣU_k·z_k = C, U_k on the web's side away from its pin",
    unit="kg·mm",
)
def removed(S: PhasorKilogramMetre, C: PhasorKilogramMetre2, z: Metres, psi: Radians) -> PhasorKilogramMetres:
    """The unbalance to take away at every web; ψ are the directions opposite to the pins.  No numbers where it can not
    be done."""
    ends = np.concatenate([np.exp(1j * (psi - WITHIN)), np.exp(1j * (psi + WITHIN))])
    places = np.tile(np.asarray(z), 2)
    arm = float(np.max(np.abs(places))) or 1.0
    rows = np.array([ends.real, ends.imag, ends.real * places / arm, ends.imag * places / arm])
    wanted = np.array([S.real, S.imag, C.real / arm, C.imag / arm])
    chosen = np.array(list(combinations(range(ends.size), 4)))
    systems = np.moveaxis(rows[:, chosen], 0, 1)  # (choices, 4, 4)
    sound = np.abs(np.linalg.det(systems)) > 1e-9
    shares = np.linalg.solve(systems[sound], np.broadcast_to(wanted, (int(sound.sum()), 4))[..., None])[..., 0]
    possible = np.flatnonzero(np.all(shares >= -1e-12, axis=1))
    unbalances: ComplexArray = np.full(places.size // 2, np.nan, complex)
    if possible.size:
        best = possible[np.argmin(np.sum(shares[possible], axis=1))]
        share = np.zeros(ends.size)
        share[chosen[sound][best]] = np.maximum(shares[best], 0.0)
        unbalances = np.sum((share * ends).reshape(2, -1), axis=0)
    return unbalances


@formula("m_k", "Finotti 2013, 2.6: mass to drill out of a web", unit="g")
def drilled(U: PhasorKilogramMetre, r_d: Metre) -> Kilogram:
    return modulus(U) / r_d


@formula("Σm_k", "mathematics: sum over the webs", unit="g")
def in_all(m_k: Kilograms) -> Kilogram:
    return total(m_k)


@formula("∠U_k", "mathematics: direction of the hole, while the throw that the list of bodies names stands up")
def direction(U: PhasorKilogramMetre) -> Radian:
    return argument(U)


@result
class WebDrilling(Shown):
    """One web."""

    mass: Kilogram = value("Mass to drill out", "g", "m_k")
    angle: Radian = value("Direction of the hole, the named throw up", "°")


def drilling(
    imbalance: ImbalanceInputs, S: complex, C: complex, p: ComplexArray, z: Array
) -> tuple[dict[str, WebDrilling] | None, Kilogram | None]:
    """The webs to drill, by name and together, for a crank with the unbalance S and the couple product C; none where it
    can not be done.

    `p`, `z`: centres of gravity of the bodies.
    """
    radius, bodies = imbalance.drill_radius, imbalance.crank_bodies
    webs = [k for k, body in enumerate(bodies) if body.pin is None]
    pins = [k for k, body in enumerate(bodies) if body.pin is not None]
    if radius is None or not 2 <= len(webs) <= MOST:
        return None, None
    nearest = [min(pins, key=lambda pin: abs(bodies[pin].z - bodies[k].z)) for k in webs]
    away = based_on(np.angle(-np.asarray(p)[nearest]), p)
    with about(Text("webs to drill")):
        U = removed(S=S, C=C, z=based_on(np.asarray(z)[webs], z), psi=away)
        if not np.all(np.isfinite(U)):
            return None, None
        drillings = {
            bodies[k].name: WebDrilling(mass=drilled(U=u, r_d=radius), angle=direction(U=u))
            for k, u in zip(webs, (based_on(complex(u), U) for u in U))
            if abs(u) > DUST * float(np.sum(np.abs(U)))
        }
        return drillings, in_all(m_k=gathered(web.mass for web in drillings.values()))


# --- the crank on the machine

TABLE = Text("Finotti 2013, 2.6: table of webs and pins, here for any throws")
BobMass = Annotated[Num, "kg"]  # the same on every pin, or of each its own
MACHINE = 2 * math.pi * 400 / 60  # rad/s of the balancing machine (Finotti 2013, 2.6)


@formula("S", TABLE, unit="kg·mm", meanings={"p": "Radii of the bodies, as vectors", "m": "Masses of the bodies"})
def unbalance(m: Kilograms, p: PhasorMetres) -> PhasorKilogramMetre:
    return resultant(m * p)


@formula("P_U", TABLE, unit="kg·mm²", meanings={"p": "Radii of the bodies, as vectors", "m": "Masses of the bodies"})
def product(m: Kilograms, p: PhasorMetres, z: Metres) -> PhasorKilogramMetre2:
    return resultant(m * p * z)


@formula("m_S", "definition: mass of the crank's bodies as they are listed, with their bobs")
def crank_mass(m: Kilograms, m_b: Kilograms) -> Kilogram:
    return total(m) + total(m_b)


@formula(
    "m_b",
    "Finotti 2013, 2.6: one bob on every pin, without couple across the throw that stands up",
    unit="g",
    names={"C": "P_U", "G": "G_U"},
    meanings={"G": "Sum of places and radii of the same mass on every pin"},
)
def equal_bob(C: PhasorKilogramMetre2, G: PhasorSquareMetre) -> Kilogram:
    """`C` of the bare crank; `G` of the same mass on every pin, per kilogram: sum of p·z.  Imaginary: across the throw
    that stands up."""
    return -imag(C) / imag(G)


@formula(
    "m_j",
    "mathematics: smallest change of the common bob that takes the whole couple",
    shows="least norm of m − m_b with P_U = 0",
    unit="g",
)
def bobs_per_pin(m_b: Kilogram, C: PhasorKilogramMetre2, G: PhasorSquareMetres) -> Kilograms:
    """One bob per pin.  For three throws the middle pin, which has no arm, keeps the common one.  `G`: p·z of each
    pin."""
    rows = np.array([np.real(G), np.imag(G)])
    left = C + m_b * np.sum(G)
    change: Array = np.linalg.lstsq(rows, -np.array([left.real, left.imag]), rcond=1e-9)[0]
    return m_b + change


@formula(
    "m_j",
    "mathematics: least squares of static unbalance and of couple over pitch",
    shows="least |S|² + |P_U|²/a² over m",
    unit="g",
)
def bobs_by_least_squares(
    S: PhasorKilogramMetre, C: PhasorKilogramMetre2, p: PhasorMetres, G: PhasorSquareMetres, a: Metre
) -> Kilograms:
    """One bob per pin; `p` and `G` = p·z of each pin."""
    rows = np.array([np.real(p), np.imag(p), np.real(G) / a, np.imag(G) / a])
    target = np.array([S.real, S.imag, C.real / a, C.imag / a])
    bobs: Array = np.linalg.lstsq(rows, -target, rcond=1e-9)[0]
    return bobs


@formula(
    "Δφ", "mathematics: largest angle between a pin as listed and its throw", shows="the largest of |arg(p·e^(−i·φ))|"
)
def pin_deviation(p: PhasorMetres, phi: Radians) -> Radian:
    """`phi` of every pin from the throw that stands up; a pin without radius has no direction and is left out."""
    return float(np.max(np.abs(np.angle(p * np.exp(-1j * phi)))[np.abs(p) > 0], initial=0.0))


@formula("|S|", "mathematics, length of the vector", unit="kg·mm")
def unbalance_length(S: PhasorKilogramMetre) -> KilogramMetre:
    return modulus(S)


@formula(
    "∠P_U",
    "mathematics: direction with cylinder 1 at TDC; χ the crank's angle from the list of bodies to there",
    names={"P": "P_U", "turned": "χ"},
    meanings={"turned": "Crank angle from the list of bodies to TDC"},
)
def state_direction(P: PhasorKilogramMetre2, turned: Radian) -> Radian:
    return argument(P * cis(turned))


@formula("F_ω", "dynamics: force of the crank's own unbalance at rated speed")
def force_at(S: PhasorKilogramMetre, omega: RadPerSecond) -> Newton:
    return modulus(S) * omega**2


@formula(
    "C_ω",
    "dynamics: couple of the crank's own unbalance at rated speed",
    names={"P": "P_U"},
    meanings={"omega": "Angular speed"},
)
def couple_at(P: PhasorKilogramMetre2, omega: RadPerSecond) -> NewtonMetre:
    return modulus(P) * omega**2


@formula(
    "U·z",
    "mathematics, what the bobs lack of the equivalent masses (Finotti 2013, 2.6)",
    unit="kg·mm²",
    names={"z_p": "z_P", "phi_p": "φ_P"},
)
def lacking_product(
    r: Metre, theta_0: Radian, M_eq: Kilogram, z: Metres, phi: Radians, m_b: BobMass, z_p: Metres, phi_p: Radians
) -> PhasorKilogramMetre2:
    """`M_eq` of every cylinder at z, φ less the bobs `m_b`, for which the crank's own webs are balanced, of every pin
    at z_P, φ_P."""
    return r * cis(theta_0) * (M_eq * resultant(z * cis(phi)) - resultant(m_b * z_p * cis(phi_p)))


@formula(
    "U",
    "mathematics, what the bobs lack of the equivalent masses (Finotti 2013, 2.6)",
    unit="kg·mm",
    names={"phi_p": "φ_P"},
)
def lacking_unbalance(
    r: Metre, theta_0: Radian, M_eq: Kilogram, phi: Radians, m_b: BobMass, phi_p: Radians
) -> PhasorKilogramMetre:
    return r * cis(theta_0) * (M_eq * resultant(cis(phi)) - resultant(m_b * cis(phi_p)))


@formula(
    "C_pf", "dynamics: couple that pulley and flywheel must supply, opposite to what is lacking", names={"P": "U·z"}
)
def wanted_couple(P: PhasorKilogramMetre2, omega: RadPerSecond) -> PhasorNewtonMetre:
    return -(omega**2) * P


@formula("F_pf", "dynamics: force that pulley and flywheel must supply, opposite to what is lacking")
def wanted_force(U: PhasorKilogramMetre, omega: RadPerSecond) -> PhasorNewton:
    return -(omega**2) * U


@formula("C_U", "dynamics: couple of unbalances that turn with the crank")
def couple_of_unbalances(omega: RadPerSecond, U: KilogramMetres, z: Metres, gamma: Radians) -> PhasorNewtonMetre:
    return omega**2 * resultant(U * z * cis(gamma))


@formula("F_U", "dynamics: force of unbalances that turn with the crank")
def force_of_unbalances(omega: RadPerSecond, U: KilogramMetres, gamma: Radians) -> PhasorNewton:
    return omega**2 * resultant(U * cis(gamma))


@formula("C_left", "mathematics: what the unbalances leave of the couple that is wanted")
def couple_not_supplied(C_pf: PhasorNewtonMetre, C_U: PhasorNewtonMetre) -> NewtonMetre:
    return modulus(C_pf - C_U)


@result
class CrankState(Shown):
    """The crank in one state: bare, with the bobs as stated, or with those found."""

    unbalance_up: KilogramMetre = value("Static unbalance, up", "kg·mm", "S_x")
    unbalance_side: KilogramMetre = value("Static unbalance, side", "kg·mm", "S_y")
    product_up: KilogramMetre2 = value("Couple product, up", "kg·mm²", "C_x")
    product_side: KilogramMetre2 = value("Couple product, side", "kg·mm²", "C_y")
    unbalance: KilogramMetre = value("Static unbalance", "kg·mm", "|S|")
    force: Newton = value("Force at rated speed", "N", "F_ω")
    couple: NewtonMetre = value("Couple at rated speed", "N·m", "C_ω")
    couple_phase: Radian = value("its direction, cylinder 1 at TDC", "°")
    couple_on_machine: NewtonMetre = value("Couple on the balancing machine, 400 rpm", "N·m")


@result
class WebsResult(Shown):
    """The crank's own balance, and what it leaves to pulley and flywheel."""

    bob_mass: dict[str, Stated] | None = group(default=None, words="bob mass")
    crank: dict[str, CrankState] | None = group(
        default=None,
        words="crank",
        key_words={"bare": Text("bare"), "stated": Text("stated"), "balanced": Text("balanced")},
    )
    drill: dict[str, WebDrilling] | None = group(default=None)
    drilled_mass: Kilogram | None = value("Mass to drill out of the crank in all", "g", default=None)
    permitted_unbalance: KilogramMetre | None = value(
        "Permitted residual unbalance of the crank", "kg·mm", "U_per", default=None
    )
    pin_deviation: Radian | None = value("Largest angle between a pin of the bodies and its throw", "°", default=None)
    equivalent_mass: Kilogram | None = value("Equivalent mass of a cylinder", "g", "M_eq", default=None)
    missing_forward_couple: NewtonMetre | None = value(
        "Couple that pulley and flywheel must supply", "N·m", "C_pf", default=None, short=True, page_one=5
    )
    missing_forward_couple_phase: Radian | None = value(
        "its direction, cylinder 1 at TDC", "°", default=None, short=True
    )
    missing_forward_force: Newton | None = value(
        "Force that pulley and flywheel must supply", "N", "F_pf", default=None, short=True, page_one=6
    )
    unbalances_couple: NewtonMetre | None = value("Couple of the given unbalances", "N·m", "C_U", default=None)
    unbalances_couple_phase: Radian | None = value("its direction, cylinder 1 at TDC", "°", default=None)
    unbalances_force: Newton | None = value("Force of the given unbalances", "N", "F_U", default=None)
    unbalances_couple_left: NewtonMetre | None = value(
        "Wanted couple that the unbalances leave", "N·m", "C_left", default=None
    )


def webs(imbalance: ImbalanceInputs, engine: EngineInputs, e: EngineResult) -> WebsResult | None:
    """The balance of the crank's own bodies; None where the design says nothing of them.  Speed and masses may be
    arrays."""
    if not imbalance.crank_bodies and imbalance.bob_mass is None and not imbalance.unbalances:
        return None
    omega = e.angular_speed
    result = WebsResult()
    bob: Num | None = imbalance.bob_mass
    if imbalance.crank_bodies:
        with about(Text("crank on the balancing machine")):
            result, masses = _bodies(_Machine(imbalance, e), imbalance, engine, e)
        bob = masses if bob is None else bob
    wanted: complex | None = None
    if bob is not None:
        crank = e.crank
        pin = pin_of_cylinder(engine, crank)
        first = np.unique(pin, return_index=True)[1]
        with about(Text("pulley and flywheel")):
            M_eq = crank_masses(imbalance, e)
            of, r = (crank.theta_0, M_eq), u.radius(engine, e)
            z, phi, z_p, phi_p = crank.z, crank.phi, crank.z[first], crank.phi[..., first]
            if e.unlike is None:
                P, U = lacking_product(r, *of, z, phi, bob, z_p, phi_p), lacking_unbalance(r, *of, phi, bob, phi_p)
            else:
                r_p = r[first] if np.ndim(r) else r
                P = u.lacking_product(r, *of, z, phi, bob, r_p, z_p, phi_p)
                U = u.lacking_unbalance(r, *of, phi, bob, r_p, phi_p)
            wanted = wanted_couple(P=P, omega=omega)
            result = replace(
                result,
                equivalent_mass=M_eq if e.unlike is None or not np.ndim(M_eq) else None,
                missing_forward_couple=f.couple_length(C=wanted),
                missing_forward_couple_phase=f.couple_direction(C=wanted),
                missing_forward_force=f.force_length(F=wanted_force(U=U, omega=omega)),
            )
    if imbalance.unbalances:
        U_u, gamma, z = (column(imbalance.unbalances, name) for name in ("unbalance", "angle", "z"))
        with about(Text("unbalances on the crank")):
            C_U = couple_of_unbalances(omega=omega, U=U_u, z=z, gamma=gamma)
            F_U = force_of_unbalances(omega=omega, U=U_u, gamma=gamma)
            result = replace(
                result,
                unbalances_couple=f.couple_length(C=C_U),
                unbalances_couple_phase=f.couple_direction(C=C_U),
                unbalances_force=f.force_length(F=F_U),
                unbalances_couple_left=None if wanted is None else couple_not_supplied(C_pf=wanted, C_U=C_U),
            )
    return result


class _Machine:
    """The crank on the balancing machine: its bodies as arrays, what they sum up to, and the bobs by every mode that
    has an answer."""

    def __init__(self, imbalance: ImbalanceInputs, e: EngineResult) -> None:
        self.m, x, y, self.z = (column(imbalance.crank_bodies, name) for name in ("mass", "x", "y", "z"))
        self.p: ComplexArray = based_on(x + 1j * y, x, y)
        number = np.array([body.pin or 0 for body in imbalance.crank_bodies])
        self.pins = np.argsort(np.where(number > 0, number, 99), kind="stable")[: int(number.max())]
        p_pin = self.p[self.pins]
        G = based_on(p_pin * self.z[self.pins], p_pin, self.z[self.pins])
        with about(Text("bare crank")):
            S_0, C_0 = unbalance(m=self.m, p=self.p), product(m=self.m, p=self.p, z=self.z)
        self.bare = S_0, C_0
        together = based_on(complex(np.sum(G)), G)
        self.modes: dict[str, Array] = {}
        if abs(together.imag) > 1e-6 * float(np.sum(np.abs(G))) > 0:
            common = equal_bob(C=C_0, G=together)
            self.modes["equal"] = based_on(np.full(self.pins.size, common), common)
            self.modes["per_pin"] = bobs_per_pin(m_b=common, C=C_0, G=G)
        self.modes["least_squares"] = bobs_by_least_squares(S=S_0, C=C_0, p=p_pin, G=G, a=e.crank.pitch)
        self.mode = imbalance.bob_mode if imbalance.bob_mode in self.modes else "least_squares"

    def with_bobs(self, bobs: Array) -> tuple[complex, complex]:
        """Static unbalance and couple product of the crank with a bob on every pin."""
        m = based_on(np.concatenate([self.m, bobs]), self.m, bobs)
        p = based_on(np.concatenate([self.p, self.p[self.pins]]), self.p)
        z = based_on(np.concatenate([self.z, self.z[self.pins]]), self.z)
        return unbalance(m, p), product(m, p, z)


def _bodies(
    machine: _Machine, imbalance: ImbalanceInputs, engine: EngineInputs, e: EngineResult
) -> tuple[WebsResult, Array]:
    """The crank bare, with the bobs as stated, and with those found; and the masses of these."""
    masses = machine.modes[machine.mode]
    states = {"bare": _state(*machine.bare, imbalance, e)}
    if imbalance.bob_mass is not None:
        with about(Text("crank with the bobs as stated")):
            m_b = based_on(np.full(machine.pins.size, imbalance.bob_mass), imbalance.bob_mass)
            turned_with = machine.with_bobs(m_b)
            states["stated"] = _state(*turned_with, imbalance, e)
    with about(Text("crank with the bobs found")):
        balanced = machine.with_bobs(masses)
        states["balanced"] = _state(*balanced, imbalance, e)
    if imbalance.bob_mass is None:
        m_b, turned_with = masses, balanced
    crank = e.crank
    throw = based_on(
        crank.phi - crank.phi[imbalance.crank_bodies_throw_at_tdc - 1], crank.phi, imbalance.crank_bodies_throw_at_tdc
    )
    first = np.unique(pin_of_cylinder(engine, crank), return_index=True)[1]
    deviation = pin_deviation(p=machine.p[machine.pins], phi=throw[first])
    bobs = {
        str(j + 1): Stated(Described(Text("Bob mass on pin {j}", j=j + 1), "g", f"m_{j + 1}", short=True), bob)
        for j, bob in enumerate(elements(masses))
    }
    drill, drilled = drilling(imbalance, *turned_with, machine.p, machine.z)
    grade = imbalance.crank_balance_grade
    with about(Text("balance quality {grade}", grade=grade)):
        m_S = crank_mass(m=machine.m, m_b=m_b)
        U_per = permitted_unbalance(G=grade_number(grade=grade), m_S=m_S, omega=e.angular_speed)
    return WebsResult(
        crank=states,
        bob_mass=bobs,
        pin_deviation=deviation,
        drill=drill,
        drilled_mass=drilled,
        permitted_unbalance=U_per,
    ), masses


def _state(S: complex, C: complex, imbalance: ImbalanceInputs, e: EngineResult) -> CrankState:
    crank = e.crank
    at_tdc = imbalance.crank_bodies_throw_at_tdc
    turned = based_on(crank.phi[at_tdc - 1] + crank.theta_0, crank.phi, at_tdc, crank.theta_0)
    return CrankState(
        unbalance_up=based_on(S.real, S),
        unbalance_side=based_on(S.imag, S),
        product_up=based_on(C.real, C),
        product_side=based_on(C.imag, C),
        unbalance=unbalance_length(S=S),
        force=force_at(S=S, omega=e.angular_speed),
        couple=couple_at(P=C, omega=e.angular_speed),
        couple_phase=state_direction(P=C, turned=turned),
        couple_on_machine=couple_at(P=C, omega=MACHINE),
    )


def bob_table(
    imbalance: ImbalanceInputs, engine: EngineInputs, e: EngineResult
) -> tuple[tuple[Table, ...], tuple[Text, ...]]:
    """The crank without bobs, with the stated ones, and with those of every mode, side by side; and what is to be said
    of them."""
    if not imbalance.crank_bodies:
        return (), ()
    words = {"equal": Text("equal"), "per_pin": Text("per pin"), "least_squares": Text("least squares")}
    with untraced():
        machine = _Machine(imbalance, e)
        count = machine.pins.size
        rows: list[tuple[Text, Iterable[float | None], tuple[complex, complex]]] = [
            (Text("bare"), [None] * count, machine.bare)
        ]
        if imbalance.bob_mass is not None:
            rows.append(
                (Text("as stated"), [imbalance.bob_mass] * count, machine.with_bobs(np.full(count, imbalance.bob_mass)))
            )
        for mode, bobs in machine.modes.items():
            title = Text("{mode} (chosen)", mode=words[mode]) if mode == machine.mode else words[mode]
            rows.append((title, bobs, machine.with_bobs(bobs)))
    table = Table(
        "bobs",
        Text("The crank on the balancing machine"),
        (
            (Text("bobs"), ""),
            *((Text("pin {j}", j=j + 1), "g") for j in range(count)),
            (Text("S up"), "kg·mm"),
            (Text("S side"), "kg·mm"),
            (Text("C up"), "kg·mm²"),
            (Text("C side"), "kg·mm²"),
            (Text("C at rated speed"), "N·m"),
        ),
        tuple(
            (
                name,
                *(None if bob is None else float(bob) * 1e3 for bob in bobs),
                S.real * 1e3,
                S.imag * 1e3,
                C.real * 1e6,
                C.imag * 1e6,
                abs(C) * e.angular_speed**2,
            )
            for name, bobs, (S, C) in rows
        ),
        Text(
            "Throw {crank_bodies_throw_at_tdc} up; side: 90° further in the sense of rotation; z towards the flywheel.",
            crank_bodies_throw_at_tdc=imbalance.crank_bodies_throw_at_tdc,
        ),
    )
    notes = []
    if machine.mode != imbalance.bob_mode:
        notes.append(
            Text(
                "Equal bobs have no couple across the throw that stands up: the bobs are found by least squares "
                "instead."
            )
        )
    if min(machine.modes[machine.mode]) < 0:
        notes.append(
            Text(
                "A bob comes out negative: the webs are too light for it there; the crank can not be balanced by bobs "
                "of this kind."
            )
        )
    return (table,), tuple(notes)
