# SPDX-License-Identifier: Apache-2.0
"""Where the throws stand, and when they fire: crank angles, axial positions, banks, firing order and its evenness.

Of any engine, or of many engines that differ in their numbers."""

import math

import numpy as np

from ..sheet.arrays import Array, BoolArray, IndexArray
from ..sheet.formula import formula
from ..sheet.functions import single_or_many
from ..sheet.record import record, replace
from ..sheet.text import EMPTY, Text
from ..sheet.units import Metre, Metres, Number, Places, Radian, Radians
from ..sheet.value import based_on
from .inputs import EngineInputs, usual_order

# --- firing: the order from the crank, the crank's use by an order, and how even the intervals are
# A cylinder fires at one of its top dead centres.  Angles are crank angles after the firing of cylinder 1, over the
# working cycle: 720° of a four-stroke engine, 360° of a two-stroke.  An offset that all cylinders have shifts every
# dead centre alike and changes nothing here; one that differs turns `top`, the direction of a throw while its piston
# stands at TDC, away from the cylinder's axis.

TURN = 2 * math.pi
DUST = 1e-9  # of a turn: two dead centres nearer than this are one


@record
class Firing:
    """`order` of the cylinders, numbered from 1; `angles` one per cylinder [rad]; `intervals` in the order, the last
    one to cylinder 1.

    `chosen`: what the crank and the order leave open, and how it was taken.
    """

    order: tuple[int, ...]
    angles: Array
    intervals: Array
    chosen: Text = EMPTY


def dead_centres(phi: Array, top: Array) -> Array:
    """The crank angle after TDC of cylinder 1 at which each piston stands at TDC, from 0 up to a turn."""
    angle = (top - phi - (top[0] - phi[0])) % TURN
    return np.where(TURN - angle < DUST * TURN, 0.0, angle)


def in_order(phi: Array, top: Array, strokes: int, order: tuple[int, ...]) -> Firing | None:
    """The firing of a crank in a given order; None where this crank can not fire so within one cycle."""
    k = np.asarray(order) - 1
    at = dead_centres(phi, top)[k]
    gaps = (np.roll(at, -1) - at) % TURN
    gaps[(gaps < DUST * TURN) | (TURN - gaps < DUST * TURN)] = 0.0
    idle = round((strokes * math.pi - float(np.sum(gaps))) / TURN)  # whole turns that the dead centres leave over
    if idle < 0:
        return None
    chosen = EMPTY
    for _ in range(idle):  # pistons that stand at TDC together fire a turn apart; what is left lies before cylinder 1
        together = np.flatnonzero(gaps == 0.0)
        gaps[together[0] if together.size else -1] += TURN
        if not together.size and len(order) > 1:
            chosen = Text("The order leaves a whole turn without firing; it is taken before cylinder 1.")
    angles = np.empty(len(order))
    angles[k] = np.concatenate(([0.0], np.cumsum(gaps)[:-1]))
    return Firing(order, angles, gaps, chosen)


def evenest(phi: Array, top: Array, strokes: int, usual: tuple[int, ...] = ()) -> list[Firing]:
    """All the equally most even firings of a crank, the usual one first, the others by number.  A four-stroke cylinder
    may fire at either of its two dead centres in the cycle."""
    cycle = strokes * math.pi
    n = phi.size
    ways = (strokes // 2) ** (n - 1)
    turns = (np.arange(ways)[:, None] >> np.arange(n - 1)[::-1]) & 1
    at = dead_centres(phi, top) + TURN * np.column_stack([np.zeros(ways), turns])
    place = np.argsort(at, axis=1, kind="stable")
    sorted_ = np.take_along_axis(at, place, 1)
    gaps = np.diff(np.column_stack([sorted_, np.full(ways, cycle)]), axis=1)
    unevenness = np.abs(gaps - cycle / n).max(1)
    best = np.flatnonzero(unevenness <= unevenness.min() + 1e-9)
    orders = sorted((tuple((place[i] + 1).tolist()), i) for i in best)
    orders.sort(key=lambda pair: pair[0] != usual)
    return [Firing(order, at[i], gaps[i]) for order, i in orders]


# --- the crank

SAME_PIN = 1e-6  # rad


@formula(
    "φ",
    "Finotti 2013, 2.4: angles of the throws for even firing, throw k at ψ_k − i_k·180°·strokes/N",
    shows="φ from ψ − i·π·strokes/N, counted from throw 1",
)
def throw_angles(psi: Radians, i: Places, strokes: Number, N: Number) -> Radians:
    """The angle of every throw, leading throw 1; i is the place of each cylinder in the firing order."""
    phi: Array = psi - i * math.pi * strokes / N
    return (phi - phi[..., :1]) % (2 * math.pi)


@formula(
    "φ_0",
    "Finotti 2013, 2.1: crank angle of TDC with an offset cylinder, of each",
    shows="arcsin(d/(L + r)) of each cylinder",
    names={"d": "d_k", "r": "r_k"},
)
def tdc_angles(d: Metres, r: Metres, L: Metre) -> Radians:
    return np.arcsin(d / (L + r))


@formula(
    "i",
    "definition: how many cylinders fire before each",
    shows="i of each cylinder, from the firing order",
    meanings={"return": "Places in the firing order"},
)
def places_in_order(order: Places) -> Places:
    """The place of cylinders 1, 2 … in the firing order, from 0."""
    return np.argsort(order)


@formula(
    "z",
    "definition: equal pitch, counted from mid-engine towards the flywheel",
    shows="z from the cylinders' places times the pitch a",
    meanings={"return": "Places of the cylinders"},
)
def axial_positions(k: Places, a: Metre) -> Metres:
    z: Array = (k - (k.min() + k.max()) / 2) * a
    return z


@formula(
    "a",
    "geometry: mean distance of neighbours in the longest row of one bank; where each stands alone, the bore",
    shows="(z_max − z_min)/(n − 1) of that row",
    unit="mm",
)
def mean_pitch(z: Metres, D: Metre) -> Metre:
    """`z`: of the cylinders of that row."""
    span = z.max(-1) - z.min(-1)
    return single_or_many(np.where(span > 0, span / max(z.shape[-1] - 1, 1), D))


@record
class Crank:
    """One entry per cylinder, along the last axis: φ angle of its throw from throw 1 [rad], z axial position [m], ψ
    direction of its axis, `top` that of its throw while its piston stands at TDC, less what all have of an offset.

    `pitch` is the distance of neighbouring cylinders.  `theta_0` is the angle of throw 1 from up while cylinder 1
    stands at its TDC.  `chosen` says what the program decided."""

    phi: Array
    z: Array
    psi: Array
    top: Array
    pitch: Metre
    theta_0: Radian
    chosen: tuple[Text, ...]


def crank(engine: EngineInputs, tdc_angle: Radian) -> Crank:
    """The crank of an engine from its crank angles, or from the firing order of an evenly firing engine.

    Angles lead cylinder 1 in the sense of rotation; z = 0 is mid-engine, + towards the flywheel.  Numbers of the engine
    may be arrays, an engine each; crank angles and axial positions then have the cylinders along their last axis."""
    n = engine.cylinders
    chosen: list[Text] = []
    bank = banks(engine)
    if engine.layout in ("vee", "boxer") and engine.bank_of_cylinder is None:
        in_turn = ", ".join(map(str, bank.tolist()))
        chosen.append(
            Text(
                "Banks {banks} taken for cylinders 1 to {n}, in turn, since the bank of each cylinder is not given.",
                banks=in_turn,
                n=n,
            )
        )
    psi = _directions(engine, bank)
    top = psi
    if engine.unlike_motions and any(engine.offsets):
        d, r = (based_on(np.asarray(x), x) for x in (engine.offsets, engine.radii))
        phi_0 = tdc_angles(d=d, r=r, L=engine.rod_length)
        top = based_on(psi + phi_0, psi, phi_0)
    if engine.crank_angles is not None:
        given_phi: Array = np.asarray(engine.crank_angles)
        phi = based_on(given_phi - given_phi[..., :1], engine.crank_angles)
        if np.any(given_phi[..., 0]):
            chosen.append(
                Text("The crank angles are counted from cylinder 1: that of its throw is taken off all of them.")
            )
    else:
        order = engine.firing_order or usual_order(n, engine.strokes) or tuple(range(1, n + 1))
        if engine.firing_order is None and n > 2:
            why = (
                Text("the usual one of an inline engine with {n} cylinders", n=n)
                if n == 3 or (engine.strokes == 4 and n in (4, 5, 6, 8))
                else Text("of those that were tried it leaves the least, at λ = 0.3")
            )
            chosen.append(Text("Firing order {map} chosen: {why}.", map="-".join(map(str, order)), why=why))
        given_order: IndexArray = based_on(np.asarray(order), order)
        phi = throw_angles(psi=top, i=places_in_order(order=given_order), strokes=engine.strokes, N=n)
    if engine.axial_positions is not None:
        z: Array = based_on(np.asarray(engine.axial_positions), engine.axial_positions)
        pitch = engine.cylinder_pitch
        if pitch is None:
            longest = bank == np.bincount(bank).argmax()
            pitch = mean_pitch(z=based_on(z[..., longest], engine.axial_positions), D=engine.bore)
            chosen.append(
                Text("The cylinder pitch is taken from the axial positions; a cylinder alone in its bank has its bore.")
            )
    else:
        assert engine.cylinder_pitch is not None
        pitch = engine.cylinder_pitch
        row = places(engine)  # side by side in a vee, whose stagger is neglected; one behind the other in a boxer
        row = 2 * row + (bank != bank[0]) if engine.layout == "boxer" else row
        z = axial_positions(k=row, a=column(pitch))
    turned = psi[..., 0] + tdc_angle
    theta_0 = based_on(single_or_many(turned), psi, tdc_angle)
    return Crank(phi, z, psi, top, pitch, theta_0, tuple(chosen))


def firing(engine: EngineInputs, throws: Crank) -> Firing:
    """When the cylinders of one engine fire: in the order given, else in the most even one that its crank allows."""
    usual = usual_order(engine.cylinders, engine.strokes)
    given = engine.firing_order or (usual if engine.crank_angles is None else None)
    first = given.index(1) if given else 0
    chosen = in_order(throws.phi, throws.top, engine.strokes, given[first:] + given[:first]) if given else None
    if chosen is None:
        chosen, *others = evenest(throws.phi, throws.top, engine.strokes, usual or ())
        if others:
            note = Text(
                "The firing order is chosen: one of {count} equally even ways in which this crank can fire; give "
                "a firing order for another.",
                count=len(others) + 1,
            )
            chosen = replace(chosen, chosen=note)
    of = (throws.phi, throws.top, engine.strokes, engine.firing_order)
    return replace(chosen, angles=based_on(chosen.angles, *of), intervals=based_on(chosen.intervals, *of))


def sharing(engine: EngineInputs, throws: Crank) -> BoolArray:
    """Which cylinders (second axis) run on the crankpin of each (first axis), itself too.

    Two share a pin where they stand in different banks, at one angle of throw and less than half a pitch apart, at one
    radius."""
    n = engine.cylinders
    if engine.layout == "inline":
        return np.eye(n, dtype=bool)
    phi, z, psi = throws.phi, throws.z, throws.psi
    turned = np.abs((phi[None, :] - phi[:, None] + math.pi) % (2 * math.pi) - math.pi)
    near = np.abs(z[None, :] - z[:, None]) < throws.pitch / 2
    other_bank = np.abs(psi[None, :] - psi[:, None]) > SAME_PIN
    r: Array = np.asarray(engine.radii)
    same: BoolArray = (turned < SAME_PIN) & near & other_bank & (r == r[:, None])
    return same | np.eye(n, dtype=bool)


def pin_of_cylinder(engine: EngineInputs, throws: Crank) -> IndexArray:
    """The crankpin, from 0, that each cylinder runs on; pins are numbered in the order of their first cylinders."""
    return np.unique(sharing(engine, throws).argmax(1), return_inverse=True)[1]


def column(x: float) -> float:
    """The number of each engine as a column, so that it meets the cylinders or crank angles of a row; a single number
    as it is."""
    return x[..., None] if isinstance(x, np.ndarray) else x


def places(engine: EngineInputs) -> IndexArray:
    """The place of each cylinder along its bank, from 0: cylinders at the same place may share a crankpin."""
    bank = banks(engine)
    return np.array([int(np.sum(bank[:k] == b)) for k, b in enumerate(bank)])


def banks(engine: EngineInputs) -> IndexArray:
    """Cylinders alternate between the banks, 0 first; an inline engine has bank 0 only, a W or radial one a bank for
    each direction."""
    n = engine.cylinders
    if engine.layout in ("w", "radial"):
        return np.unique(np.round(_directions(engine) % TURN, 9), return_inverse=True)[1]
    if engine.bank_of_cylinder is not None:
        return np.asarray(engine.bank_of_cylinder)
    return np.zeros(n, int) if engine.layout == "inline" else np.arange(n) % 2


def _directions(engine: EngineInputs, bank: IndexArray | None = None) -> Array:
    """The direction of each cylinder's axis from up, in the sense of rotation; of two banks that of its bank."""
    n, given = engine.cylinders, engine.cylinder_directions
    if engine.layout in ("w", "radial"):
        return np.arange(n, dtype=float) * (TURN / n) if given is None else based_on(np.asarray(given), given)
    if engine.layout == "inline":
        return np.zeros(n)
    opening = math.pi if engine.layout == "boxer" else column(0.0 if engine.bank_angle is None else engine.bank_angle)
    return based_on(np.where(bank == 1, opening / 2, -opening / 2), engine.bank_angle, engine.bank_of_cylinder)


def not_fired(engine: EngineInputs) -> Text:
    """Why a crank of given angles can not fire in the given order; empty where it can, or where what says so is
    missing."""
    order, angles = engine.firing_order or (), engine.crank_angles or ()
    if not len(angles) == len(order) == engine.cylinders or sorted(order) != list(range(1, len(order) + 1)):
        return EMPTY
    if engine.cylinder_pitch is None and engine.axial_positions is None:
        return EMPTY
    first = order.index(1)
    if firing(engine, throws := crank(engine, 0.0)).order == order[first:] + order[:first]:
        return EMPTY
    best = "-".join(map(str, firing(replace(engine, firing_order=None), throws).order))
    return Text(
        "these crank angles can not fire in it within one cycle; they fire {best}: correct one of the two, or leave "
        "one out",
        best=best,
    )
