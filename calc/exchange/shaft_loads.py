# SPDX-License-Identifier: Apache-2.0
"""What one balance shaft does to its bearings at one speed of the crank: the forces that turn with it, and what stands.

Vectors of a shaft are complex: real up, imaginary 90° further in the sense of crank rotation, cylinder 1 at TDC, as in
the steps.  A couple is Σ z·F."""

from collections.abc import Mapping

import numpy as np

from ..bearings.result import BearingsResult
from ..countershaft.bending.condensed import OnSupports, of_beam
from ..countershaft.bending.shaft import Bending
from ..countershaft.formulas import late_force, lever_reaction, weight
from ..countershaft.result import CountershaftResult
from ..countershaft.supports import on_supports
from ..countershaft.twins import Resolved
from ..sheet.arrays import Array, ComplexArray
from ..sheet.record import record
from ..sheet.units import Metre, Newton, NewtonMetre, Number, PhasorNewton, PhasorNewtonMetre, Radian, RadPerSecond

Wrench = tuple[PhasorNewton, PhasorNewtonMetre]  # force and couple
DUST = 1e-12  # of the largest force


@record
class ShaftAtSpeed:
    """A shaft at one speed.  `result` and `bearings` (None: not solved) are as they turn with an original, also of its
    mirror image; `axis`: beside the crank, None: not known."""

    shaft: Resolved
    result: CountershaftResult
    bearings: BearingsResult | None
    axis: complex | None

    @property
    def name(self) -> str:
        return self.shaft.name

    @property
    def mirrored(self) -> bool:
        return self.shaft.how == "mirrors"

    @property
    def sense(self) -> float:
        """1 with the crank, -1 against it."""
        return 1.0 if self.shaft.inputs.speed_ratio > 0 else -1.0

    @property
    def order(self) -> float:
        return abs(float(self.shaft.inputs.speed_ratio))

    @property
    def places(self) -> dict[str, Metre]:
        """The bearings by their names, from mid-shaft."""
        return {row.name: float(row.position) for row in self.shaft.inputs.bearings}

    @property
    def locating(self) -> tuple[str, bool]:
        """The bearing that takes the thrust, and whether the design says so; else it is the rear one."""
        rows = self.shaft.inputs.bearings
        located = next((row.name for row in rows if row.locates), None)
        return located or rows[-1].name, located is not None


# --- what turns with the shaft


@record
class TurningForces:
    """`forces` on the block by the bearing; `inertia`: what the bent shaft itself adds to them, with the opposite sign;
    `outline`: what its outline has more than its masses, likewise; so that all together are `total`, ω² times the
    unbalance of masses and further elements.  None: nothing.  `like`: which value of the results the forces are."""

    forces: dict[str, PhasorNewton]
    like: str  # levers, load (of the bearing) or reaction
    inertia: Wrench | None
    outline: Wrench | None
    total: Wrench


def turning(of: ShaftAtSpeed, s: Number = 0.0, delta: Radian = 0.0) -> TurningForces:
    """The forces of a shaft that is late by `delta` (of its own angle), its couple too large by the share `s`.

    Two plain bearings carry by levers, which is statics alone and grows with the square of speed; others what judges
    them: their load in its direction, which for more than two moves with films and bending."""
    result, places = of.result, of.places
    F_S, C_S = complex(result.force_vector), complex(result.couple_vector)
    inertia = outline = None
    shared, like = _shared(of), "reaction"
    if shared is not None and result.bending is not None:
        carried, x, like = shared
        (F_O, C_O), (F_b, C_b) = load_and_inertia(result.bending, result.omega, x)
        inertia, outline = (-F_b, -C_b), (F_S - F_O, C_S - C_O)
        if abs(outline[0]) < DUST * max(map(abs, carried)):
            outline = None
    elif len(places) == 2:
        (_, z_1), (_, z_2) = places.items()
        ends = ((z_1, z_2), (z_2, z_1))
        carried = [-complex(lever_reaction(C_S=C_S, z_o=z_o, F_S=F_S, z_B=z_B)) for z_B, z_o in ends]
        like = "levers" if result.loads_by_levers else like  # of a shaft that is not bent both are the same
    else:
        carried = [-complex(R) for R in result.reactions]

    def turned(vector: complex) -> complex:
        seen = vector.conjugate() if of.mirrored else vector
        return complex(late_force(F_S=seen, sigma=of.sense, delta=delta))

    def both(wrench: Wrench | None) -> Wrench | None:
        return None if wrench is None else (turned(wrench[0]), turned(wrench[1]))

    forces, more = {name: turned(F) for name, F in zip(places, carried)}, s * turned(C_S)
    if more:  # the outer two carry what the couple has more
        first, last = next(iter(places)), next(reversed(places))
        forces[first] -= more / (places[last] - places[first])
        forces[last] += more / (places[last] - places[first])
    return TurningForces(forces, like, both(inertia), both(outline), (turned(F_S), turned(C_S) + more))


def _shared(of: ShaftAtSpeed) -> tuple[list[complex], ComplexArray, str] | None:
    """The loads of the bearings, how far their journals are displaced, and which value the loads are, where these and
    not levers judge."""
    rows, bent = of.shaft.inputs.bearings, of.result.bending
    if bent is None or (len(rows) == 2 and all(row.kind == "plain" for row in rows)):
        return None
    at_rest = np.zeros(len(rows), dtype=complex)
    found = of.bearings
    if found is None or any(r.on_shaft is None for r in found.bearings.values()):
        return [-complex(R) for R in of.result.reactions], at_rest, "reaction"
    lies = [(r, r.on_shaft) for r in found.bearings.values()]
    loads = [_polar(r.load, on.load_phase) for r, on in lies if on is not None]
    if len(rows) == 2:  # whose loads are those on pins
        return loads, at_rest, "load"
    x = np.array([_polar(on.displacement, on.displacement_phase) for _, on in lies if on is not None])
    return loads, x, "load"


def _polar(size: float, phase: float | None) -> complex:
    return 0j if phase is None else complex(float(size) * np.exp(1j * float(phase)))


def load_and_inertia(bent: Bending, omega: RadPerSecond, x: ComplexArray) -> tuple[Wrench, Wrench]:
    """The load of the bent shaft, and the centrifugal force of its own bending where its journals are displaced by x:
    force and couple about mid-shaft of each."""
    model = bent.model
    line = of_beam(model, float(omega))
    return _wrench(model.z, model.f), _wrench(model.z, float(omega) ** 2 * (model.M @ (line.u + line.moved @ x)))


def _wrench(z: Array, forces: ComplexArray) -> Wrench:
    """Of forces and couples at the nodes in turn."""
    return complex(forces[::2].sum()), complex((z * forces[::2] + forces[1::2]).sum())


# --- what stands still


@record
class OnWheel:
    """The forces of the teeth on the wheel of the shaft: across it, and its couple with that of the thrust about the
    wheel's middle at `z`; the thrust itself towards the flywheel."""

    force: PhasorNewton
    couple: PhasorNewtonMetre
    thrust: Newton
    z: Metre


@record
class StandingForces:
    """`weight` of the shaft, N, and where along it; of each bearing the share of the weight, the force of the teeth,
    and the friction torque in the sense in which the shaft turns; None: not known."""

    weight: tuple[Newton, Metre] | None
    weights: Mapping[str, Number] | None
    teeth: Mapping[str, PhasorNewton] | None
    friction: Mapping[str, NewtonMetre]


def standing(of: ShaftAtSpeed, wheel: OnWheel | None, losses: Mapping[str, float]) -> StandingForces:
    """`losses`: of the journals, W."""
    result, places = of.result, of.places
    known, stands = None, None
    if result.mass is not None and result.centre_of_gravity is not None:
        known = float(weight(m_S=result.mass)), float(result.centre_of_gravity)
    if len(places) > 2:
        stands = of.bearings.stands if of.bearings is not None else None
        stands = stands or on_supports(result, of.shaft.inputs.bearing_positions, np.inf)
    weights = None if known is None else _weights(places, known, stands)
    teeth = None if wheel is None else _teeth(places, wheel, stands)
    friction = {name: P / float(result.omega) for name, P in losses.items()}
    return StandingForces(known, weights, teeth, friction)


def _weights(
    places: Mapping[str, Metre], known: tuple[Newton, Metre], stands: OnSupports | None
) -> dict[str, Number] | None:
    G, z_S = known
    if len(places) == 2:
        return dict(zip(places, _levers(places, z_S)))
    return None if stands is None else {name: -float(up) / G for name, up in zip(places, stands.weight)}


def _teeth(places: Mapping[str, Metre], wheel: OnWheel, stands: OnSupports | None) -> dict[str, PhasorNewton] | None:
    if len(places) == 2:
        z_1, z_2 = places.values()
        of_force, of_couple = _levers(places, wheel.z), (-1 / (z_2 - z_1), 1 / (z_2 - z_1))
    elif stands is not None and stands.force is not None and stands.couple is not None:
        of_force, of_couple = tuple(stands.force.tolist()), tuple(stands.couple.tolist())
    else:
        return None
    parts = zip(places, of_force, of_couple)
    return {name: complex(wheel.force * a + wheel.couple * b) for name, a, b in parts}


def _levers(places: Mapping[str, Metre], z: Metre) -> tuple[float, ...]:
    """The shares of two bearings in a force at z."""
    z_1, z_2 = places.values()
    return (z_2 - z) / (z_2 - z_1), (z - z_1) / (z_2 - z_1)
