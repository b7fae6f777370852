# SPDX-License-Identifier: Apache-2.0
"""The crank throw at the two positions that size it: the largest tangential force, and top dead centre at firing.

Every cylinder is looked at in both; the one with the largest nominal stress governs and is shown.  The torque of the
throws in front of it (towards the free end) passes through.  Signs: forces are positive towards the crank, tangential
in the sense of rotation, radial towards the crank axis."""

import math
from collections.abc import Iterator, Mapping
from typing import Any, Protocol, overload

import numpy as np

from ..library.catalogue import Material, proof_of
from ..sheet.arrays import Array, BoolArray, Num
from ..sheet.check import Check, CheckRule
from ..sheet.linked_array import item
from ..sheet.quantity import dotted
from ..sheet.record import replace
from ..sheet.step import Table
from ..sheet.text import Name, Text
from ..sheet.units import UNITS, Metre, Newton, NewtonMetre
from ..sheet.value import about, based_on, untraced
from . import cycle as c
from . import formulas as f
from . import throw_strength as t
from .crank import sharing
from .cycle import TURN, Cycle
from .gas import GasInputs
from .inputs import EngineInputs, ThrowInputs
from .result import MAIN_JOURNALS, CrankSection, EngineResult, Position, Rod, ThrowResult
from .throw_strength import FATIGUE, PLACES, Forces, Notch, ThrowFatigue, fatigue_check, judged
from .torque import prepare

# --- the throws

POSITIONS = {"largest_tangential": Text("largest tangential force"), "top_dead_centre": Text("top dead centre")}
SPAN = (0.8, 1.1)
FIT = (0.01, 0.3)  # of the notch factors, ρ/d
SAME_STRESS = 1e-9


class Rods(Protocol):
    """`Rod` of many cylinders (last axis) or crank angles."""

    @property
    def tangential_force(self) -> Array: ...
    @property
    def radial_force(self) -> Array: ...


class _Throw:
    """One engine's throws: what the scan and the traced call have in common.  Works on floats as on arrays."""

    def __init__(
        self, engine: EngineInputs, e: EngineResult, fires: Array, cycle: Cycle | None, throw: ThrowInputs
    ) -> None:
        self.engine, self.e, self.fires, self.cycle, self.throw = engine, e, fires, cycle, throw
        self.shared, self.in_front = pins(engine, e)
        self.length = cycle.length if cycle else TURN
        self.epsilon = c.points(cycle, fires) if cycle else np.linspace(0.0, TURN, 721)  # over the whole cycle
        self.load = (
            fires,
            e.lambda_,
            e.delta,
            e.reciprocating_mass,
            e.rotating_mass,
            e.angular_speed,
            engine.crank_radius,
            engine.bore,
            cycle,
        )
        self.span = t.span(l_j=throw.journal_length, t_w=throw.web_thickness, l_p=throw.pin_length)
        self.notch: Notch = {}
        if throw.fillet_radius is not None:
            for place, d in (("pin", throw.pin_diameter), ("journal", throw.journal_diameter)):
                with about(Text("fillet of the {place}", place=PLACES[place])):
                    ratio = t.relative_fillet(rho=throw.fillet_radius, d=d)
                    self.notch[place] = ratio, t.notch_bending(rho_d=ratio), t.notch_torsion(rho_d=ratio)

    def partners(self, k: int) -> list[int]:
        """The other cylinders on the pin of cylinder k, all from 0."""
        return [int(j) for j in np.flatnonzero(self.shared[k]) if j != k]

    @overload
    def rod(self, fires: float, epsilon: float) -> Rod: ...
    @overload
    def rod(self, fires: Array, epsilon: Num) -> Rods: ...
    def rod(self, fires: Any, epsilon: Any) -> Any:
        """The forces of the cylinders that fire at `fires`, at crank angles ε of the engine."""
        engine, e = self.engine, self.e
        angle = c.own_angle(epsilon=epsilon, fires=fires, cycle=self.length)
        alpha = c.crank_angle(phi_0=e.tdc_angle, epsilon=angle)
        beta = f.rod_angle(lam=e.lambda_, alpha=alpha, delta=e.delta)
        v_rel = f.relative_speed(alpha=alpha, beta=beta)
        a_rel = f.relative_acceleration(alpha=alpha, beta=beta, lam=e.lambda_)
        F = F_I = c.inertia_force(M_alt=e.reciprocating_mass, omega=e.angular_speed, r=engine.crank_radius, a_rel=a_rel)
        F_G = None
        if self.cycle:
            x = c.piston_way(r=engine.crank_radius, lam=e.lambda_, phi_0=e.tdc_angle, alpha=alpha, beta=beta)
            F_G = c.gas_force(p=self.cycle.pressure(angle, x), p_case=self.cycle.crankcase, D=engine.bore)
            F = t.piston_force(F_G=F_G, F_I=F_I)
        S = t.rod_force(F=F, beta=beta)
        return Rod(
            crank_angle=angle,
            gas_force=F_G,
            inertia_force=F_I,
            piston_force=F,
            rod_force=S,
            side_thrust=t.side_thrust(F=F, beta=beta),
            tangential_force=t.tangential_force(F=F, v_rel=v_rel),
            radial_force=t.radial_force(
                S=S, alpha=alpha, beta=beta, M_rot=e.rotating_mass, r=engine.crank_radius, omega=e.angular_speed
            ),
        )

    def sections(self, F_t: Newton, F_r: Newton, T_v: NewtonMetre) -> tuple[Newton, CrankSection, CrankSection]:
        """Reaction, and the stresses of pin and journal, from the forces on the pin and the torque from in front."""
        throw, r = self.throw, self.engine.crank_radius
        R = t.reaction(F_t=F_t, F_r=F_r)
        pin = self.stresses(
            "pin",
            throw.pin_diameter,
            t.pin_bending(R=R, L=self.span),
            t.pin_torsion(F_t=F_t, r=r, T_v=T_v),
            t.pin_fillet_bending(R=R, l_j=throw.journal_length, t_w=throw.web_thickness) if self.notch else None,
        )
        at_edge = t.journal_bending(R=R, l_j=throw.journal_length)
        journal = self.stresses(
            "journal", throw.journal_diameter, at_edge, t.journal_torsion(F_t=F_t, r=r, T_v=T_v), at_edge
        )
        return R, pin, journal

    def stresses(
        self, place: str, d: Metre, M: NewtonMetre, T: NewtonMetre, M_fillet: NewtonMetre | None
    ) -> CrankSection:
        sigma, tau = t.bending_stress(M=M, d=d), t.torsion_stress(T=T, d=d)
        notch = None
        if place in self.notch and M_fillet is not None:
            _, K_b, K_t = self.notch[place]
            notch = t.notch_stress(
                K_b=K_b, sigma=sigma if M_fillet is M else t.bending_stress(M=M_fillet, d=d), K_t=K_t, tau=tau
            )
        nominal = t.von_mises(sigma=sigma, tau=tau)
        return CrankSection(
            bending_moment=M, torsion=T, bending_stress=sigma, torsion_stress=tau, von_mises=nominal, notch_stress=notch
        )


def pins(engine: EngineInputs, e: EngineResult) -> tuple[BoolArray, BoolArray]:
    """Which cylinders (second axis) run on the pin of each (first axis), itself too; and which stand on throws in front
    of it.

    Of two throws at one place along the crank, those of a split pin, the one with the lower cylinder number is taken to
    lie in front."""
    z = e.crank.z
    number = np.arange(z.size)
    apart = z[None, :] - z[:, None]
    shared = sharing(engine, e.crank)
    in_front: BoolArray = (apart < 0) | ((apart == 0) & (number[None, :] < number[:, None]))
    return shared, in_front & ~shared


def solve(
    engine: EngineInputs,
    e: EngineResult,
    firing: Array,
    gas: GasInputs | None,
    throw: ThrowInputs,
    materials: Mapping[str, Material],
    cycle: Cycle | None = None,
) -> tuple[ThrowResult, tuple[Check, ...], tuple[Text, ...], tuple[Table, ...]]:
    """The governing throw of one engine at rated speed.

    `firing` as for the torque.  `cycle`: the gas as the torque prepared it, so that one chain of lines leads to both.
    """
    if cycle is None and gas is not None:
        with about(Text("gas cycle")):
            cycle = prepare(engine, e, gas)
    crank = _Throw(engine, e, firing, cycle, throw)
    with untraced():
        angles = _positions(crank)
        worst = _stress_of_all(crank, angles)
    stress = worst[..., :2].max((0, 2))
    k = int(np.argmax(stress >= stress.max() * (1 - SAME_STRESS)))  # of equal ones the first
    at = zip(POSITIONS.values(), (based_on(float(angles[0, k]), *crank.load), item(firing[k])))
    largest, top = [_position(crank, k, epsilon, words) for words, epsilon in at]
    material = materials.get(throw.material)
    fatigue = judged(_forces_over_the_cycle(crank), crank.notch, throw, engine.crank_radius, material, crank.load)
    pin, journal = (crank.notch.get(place, (None, None, None)) for place in PLACES)
    result = ThrowResult(
        cylinder=based_on(k + 1, *crank.load, e.crank.pitch, throw),
        span=crank.span,
        notch_bending_pin=pin[1],
        notch_torsion_pin=pin[2],
        notch_bending_journal=journal[1],
        notch_torsion_journal=journal[2],
        largest_tangential=largest,
        top_dead_centre=top,
        fatigue=fatigue,
    )
    checks = tuple(_checks(crank, worst, material, fatigue))
    return result, checks, tuple(_notes(crank, result, material)), tuple(_tables(result, worst))


def _forces_over_the_cycle(crank: _Throw) -> Forces:
    """Tangential and radial force on every pin, and the torque from in front of it: (angles, cylinders)."""
    with untraced():
        rods = crank.rod(crank.fires, crank.epsilon[:, None])
    F_t, F_r = rods.tangential_force, rods.radial_force
    return F_t @ crank.shared.T, F_r @ crank.shared.T, F_t @ crank.in_front.T * crank.engine.crank_radius


def _positions(crank: _Throw) -> Array:
    """The crank angles of the two positions (first axis) for each cylinder."""
    epsilon, fires, shared = crank.epsilon, crank.fires, crank.shared
    size = c.amounts(crank.rod(fires, epsilon[:, None]).tangential_force @ shared.T)
    between = np.array([c.highest(epsilon, column)[0] for column in size.T])
    there = c.amounts(np.einsum("kj,kj->k", crank.rod(fires, between[:, None]).tangential_force, shared))
    largest = np.where(there >= size.max(0), between, epsilon[size.argmax(0)])
    return np.stack([largest, fires])


def _stress_of_all(crank: _Throw, angles: Array) -> Array:
    """Von Mises stress by position, cylinder and place: pin and journal nominal, then at their fillets (NaN where these
    are not given)."""
    rods = crank.rod(crank.fires, angles[:, :, None])
    F_t, F_r = (np.einsum("pkj,kj->pk", part, crank.shared) for part in (rods.tangential_force, rods.radial_force))
    T_v = np.einsum("pkj,kj->pk", rods.tangential_force, crank.in_front) * crank.engine.crank_radius
    _, *sections = crank.sections(F_t, F_r, T_v)
    notch = [np.full(F_t.shape, np.nan) if part.notch_stress is None else part.notch_stress for part in sections]
    return np.stack([*(part.von_mises for part in sections), *notch], -1)


def _position(crank: _Throw, k: int, epsilon: float, words: str) -> Position:
    """Cylinder k at one crank angle, recorded."""
    with untraced():
        in_front = crank.rod(crank.fires, epsilon).tangential_force[crank.in_front[k]]
    with about(Text("throw of cylinder {k}, {words}", k=k + 1, words=words)):
        T_v = t.torque_in_front(F_t=based_on(in_front, epsilon, *crank.load), r=crank.engine.crank_radius)
        rod = crank.rod(item(crank.fires[k]), epsilon)
    F_t, F_r = rod.tangential_force, rod.radial_force
    for j in crank.partners(k):
        with about(Text("cylinder {j} on the same pin, {words}", j=j + 1, words=words)):
            other = crank.rod(item(crank.fires[j]), epsilon)
            F_t = t.both_rods(F=F_t, F_other=other.tangential_force)
            F_r = t.both_rods(F=F_r, F_other=other.radial_force)
    with about(Text("throw of cylinder {k}, {words}", k=k + 1, words=words)):
        R, pin, journal = crank.sections(F_t, F_r, T_v)
    on_pin = replace(rod, tangential_force=F_t, radial_force=F_r)
    return Position(
        **vars(on_pin), reactions=dict.fromkeys(MAIN_JOURNALS, R), torque_in_front=T_v, pin=pin, journal=journal
    )


# --- what is judged

DIAMETERS = {
    "pin": dotted("engine", EngineInputs.throw, ThrowInputs.pin_diameter),
    "journal": dotted("engine", EngineInputs.throw, ThrowInputs.journal_diameter),
}
FILLET_RADIUS = dotted("engine", EngineInputs.throw, ThrowInputs.fillet_radius)
SPAN_OF_THROW = CheckRule(
    dotted("engine", EngineInputs.throw, ThrowResult.span),
    "method",
    "A throw that is not as long as the cylinder pitch is not the one between two main journals that is computed.",
    Text("Distance of the main journals over the cylinder pitch"),
    "in",
    source=Text("rule of this program: a main journal between any two throws"),
    advice=Text("Journal length, both webs and pin length make the span; the stresses are proportional to it."),
    moved_by=(
        dotted("engine", EngineInputs.throw, ThrowInputs.journal_length),
        dotted("engine", EngineInputs.throw, ThrowInputs.web_thickness),
        dotted("engine", EngineInputs.throw, ThrowInputs.pin_length),
    ),
)
STRESS = {
    "pin": CheckRule(
        "engine.throw.stress_pin",
        "limit",
        "The pin of the crank yields.",
        Text("Von Mises stress of the pin, nominal"),
        "<=",
        "MPa",
        advice=Text("A larger diameter: the stress falls with its cube."),
        role="physics",
        demand=True,
        moved_by=(DIAMETERS["pin"], DIAMETERS["journal"]),
        short=Text("pin"),
        proven=(),
    ),
    "journal": CheckRule(
        "engine.throw.stress_journal",
        "limit",
        "The journal of the crank yields.",
        Text("Von Mises stress of the journal, nominal"),
        "<=",
        "MPa",
        advice=Text("A larger diameter: the stress falls with its cube."),
        role="physics",
        demand=True,
        moved_by=(DIAMETERS["journal"], DIAMETERS["pin"]),
        short=Text("journal"),
    ),
}
NOTCH_STRESS = {
    place: CheckRule(
        f"engine.throw.notch_stress_{place}",
        "caution",
        "The fillet yields locally where the section as a whole holds.",
        Text("Von Mises stress at the fillet of the {part}", part=part),
        "<=",
        "MPa",
        advice=Text("A larger fillet, or a larger diameter."),
        demand=True,
        cause=STRESS[place].id,
        moved_by=(FILLET_RADIUS, DIAMETERS[place]),
    )
    for place, part in PLACES.items()
}
FILLET = {
    place: CheckRule(
        f"engine.throw.fillet_{place}",
        "method",
        "Outside its range the notch factor is an extrapolation.",
        Text("Fillet radius over diameter of the {part}", part=part),
        "in",
        source=Text("range of the notch factors ({notch})", notch=t.NOTCH),
        advice=Text("Outside it the notch stress is an extrapolation."),
        cause="engine.throw.fillet",
        moved_by=(FILLET_RADIUS, DIAMETERS[place]),
        weakens=((FATIGUE, 1.5),),
    )
    for place, part in PLACES.items()
}


def _checks(crank: _Throw, worst: Array, material: Material | None, fatigue: ThrowFatigue | None) -> Iterator[Check]:
    """Each place by the largest stress that it has on any throw, in either position; the worst fillet by its
    fatigue."""
    largest = worst.max((0, 1))
    throw, pitch = crank.throw, crank.e.crank.pitch
    if crank.engine.cylinders > 1:
        yield SPAN_OF_THROW(crank.span / pitch, SPAN)
    proof = material.proof_stress if material else None
    source = Text("elasticity, proof stress of {material}", material=throw.material)
    assumed = Text(
        "rule of this program: as the weakest structural steels; the strength of {name} is not known",
        name=throw.material,
    )
    for place, stresses in zip(PLACES, largest.reshape(2, 2).T):
        nominal, notch = (based_on(float(stress), *crank.load, throw) for stress in stresses)
        strength, unknown = proof_of(proof, nominal)
        yield STRESS[place](nominal, strength, source=assumed if unknown else source, missing=unknown)
        if proof is not None and place in crank.notch:
            local = Text("{proof}: above it the fillet yields locally", proof=source)
            yield NOTCH_STRESS[place](notch, proof, source=local)
        if place in crank.notch:
            yield FILLET[place](crank.notch[place][0], FIT)
    if crank.notch:
        yield fatigue_check(fatigue, material)


# --- what is said about it


def _notes(crank: _Throw, result: ThrowResult, material: Material | None) -> Iterator[Text]:
    k = int(result.cylinder)
    if crank.engine.cylinders > 1:
        yield Text("Throw: that of cylinder {k} governs; each was looked at in both positions.", k=k)
    if partners := crank.partners(k - 1):
        yield Text(
            "Throw: cylinder {map} runs on the same pin; both rods are taken to act at its middle.",
            map=", ".join(str(j + 1) for j in partners),
        )
    if crank.cycle is None:
        yield Text("Throw: no gas is given; it is loaded by inertia alone.")
    else:
        yield Text(
            "Throw: judged at rated speed; at low speed no inertia force relieves the gas force at top dead centre."
        )
    if crank.notch and (material is None or material.proof_stress is None):
        yield Text(
            "Throw: the proof stress of {material} is not known, so the stress at its fillets is not judged.",
            material=crank.throw.material,
        )
    yield Text(
        "Throw: pin and web masses are taken as counterweighted; what the counterweights take off the journals "
        "beyond that is left out."
    )
    yield Text(
        "Throw: solid round sections between two simple supports; shear, the webs and the neighbouring throws' "
        "stiffness are left out."
    )
    if not crank.notch:
        yield Text("Throw: fatigue is not judged: it takes the radius of the fillets.")
    if crank.notch:
        yield Text(
            "Throw: the notch factors are those of a round shaft with a shoulder of twice its diameter, which a "
            "web is not; below ρ/d 0.03 published fits of them lie 10 % and more apart."
        )


def _tables(result: ThrowResult, worst: Array) -> Iterator[Table]:
    positions = tuple((words, getattr(result, key)) for key, words in POSITIONS.items())
    mega, cylinder = UNITS["MPa"].factor, int(result.cylinder)
    forces = ("F_G", "F_I", "F", "S", "N", "F_t", "F_r", "R_f", "R_r")
    yield Table(
        "throw_forces",
        Text("Forces on the throw of cylinder {cylinder}", cylinder=cylinder),
        ((Text("position"), ""), (Text("ε_k"), "°"), *((Name(name), "N") for name in forces), (Name("T_v"), "N·m")),
        tuple(
            (
                words,
                math.degrees(p.crank_angle),
                p.gas_force,
                p.inertia_force,
                p.piston_force,
                p.rod_force,
                p.side_thrust,
                p.tangential_force,
                p.radial_force,
                *p.reactions.values(),
                p.torque_in_front,
            )
            for words, p in positions
        ),
        Text(
            "Gas, inertia, piston, rod, side thrust, tangential and radial force (towards the crank axis), "
            "reactions of the journals, torque from the throws in front."
        ),
        covers=("engine.throw.largest_tangential.",),
    )
    moments, stresses = ("M", "T"), ("σ", "τ", "σ_v", "σ_vk")
    yield Table(
        "throw_stresses",
        Text("Stresses of the throw of cylinder {cylinder}", cylinder=cylinder),
        (
            (Text("section"), ""),
            *((Name(name), "N·m") for name in moments),
            *((Name(name), "MPa") for name in stresses),
        ),
        tuple(
            (
                Text("{place}, {position}", place=PLACES[place], position=words),
                s.bending_moment,
                s.torsion,
                s.bending_stress / mega,
                s.torsion_stress / mega,
                s.von_mises / mega,
                None if s.notch_stress is None else s.notch_stress / mega,
            )
            for words, p in positions
            for place, s in (("pin", p.pin), ("journal", p.journal))
        ),
        Text("σ_v nominal; σ_vk at the fillet, where its radius is given."),
        covers=("engine.throw.top_dead_centre.",),
    )
    if worst.shape[1] > 1:
        columns = Text("pin, F_t"), Text("journal, F_t"), Text("pin, TDC"), Text("journal, TDC")
        yield Table(
            "throws",
            Text("Nominal von Mises stress of every throw"),
            ((Text("throw"), ""), *((words, "MPa") for words in columns)),
            tuple(
                (Text("cylinder {k}", k=k + 1), *(float(s) / mega for s in worst[:, k, :2].ravel()))
                for k in range(worst.shape[1])
            ),
            Text("At its largest tangential force (F_t) and at its firing (TDC)."),
        )
