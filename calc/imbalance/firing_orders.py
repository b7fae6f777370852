# SPDX-License-Identifier: Apache-2.0
"""All evenly firing orders of a layout, with what each leaves, the best first."""

import math
from collections.abc import Iterable, Iterator
from itertools import permutations, product

import numpy as np

from ..engine.crank import banks, crank, firing, pin_of_cylinder, places, throw_angles
from ..engine.inputs import EngineInputs
from ..engine.result import EngineResult
from ..sheet.arrays import Array, IndexArray
from ..sheet.errors import NoSolution
from ..sheet.record import record, replace
from ..sheet.step import Table
from ..sheet.text import SPACE, Name, Text, plural
from ..sheet.units import Newton, NewtonMetre
from ..sheet.value import untraced
from .inputs import ImbalanceInputs
from .orders import Order, harmonics, order

ALL, SOME = 9, 12  # cylinders up to which every order is tried, and up to which those of the cranks that are built are


@record
class FiringOrder:
    """An order, its crank angles [rad], and the peaks it leaves with the share on the crank that the design has.

    `left` is what the orders are ranked by: the peaks of the forces, and of the couples over one pitch, of all harmonic
    orders together with half of the reciprocating mass on the crank, which takes of order 1 what it can.  `neighbours`:
    how often two cylinders beside each other, which load the same main bearing, fire in turn; `same_half`: how often
    two of one half of the engine (of one bank) do, which draw from the same end of a manifold."""

    order: tuple[int, ...]
    crank_angles: Array
    force_1: Newton
    couple_1_forward: NewtonMetre
    couple_1_backward: NewtonMetre
    force_2: Newton
    couple_2: NewtonMetre
    left: Newton
    neighbours: int
    same_half: int


def firing_orders(imbalance: ImbalanceInputs, engine: EngineInputs, e: EngineResult) -> list[FiringOrder]:
    """Every order that begins with cylinder 1, as an evenly firing crank of this layout.

    Ranked by what is left, then by bearings and intake; orders of one crank stand together.

    From ten to twelve cylinders only the cranks that are built are tried: symmetrical inline ones, and common or
    opposed pins of two banks. Raises NoSolution for more."""
    n = engine.cylinders
    orders = np.array(list(_orders(engine)), dtype=np.intp)
    place = np.argsort(orders, axis=1)  # of each cylinder in the order
    # places so far apart share a crank angle: they are a turn apart
    throws = n // 2 if engine.strokes == 4 and n % 2 == 0 else n
    keys = np.zeros(len(orders), dtype=np.int64)
    for k in range(n):
        keys = keys * n + place[:, k] % throws
    _, first, which = np.unique(keys, return_index=True, return_inverse=True)
    residuals, angles = _left(imbalance, engine, e, place[first])
    best = (
        residuals
        if imbalance.crank_balance_fraction == 0.5
        else _left(replace(imbalance, crank_balance_fraction=0.5), engine, e, place[first])[0]
    )
    left: Array = sum(
        (np.asarray(o.force_peak + o.couple_peak / e.crank.pitch) for o in best.values()), np.zeros(len(first))
    )
    one, two = residuals[1], residuals[2]
    beside, half = _in_turn(engine, orders)
    mild = [(int(b), int(h)) for b, h in zip(beside, half)]
    mildest = dict(sorted(zip(which.tolist(), mild), reverse=True))  # of the orders of each crank
    ranked = sorted(
        range(len(orders)),
        key=lambda i: (float(f"{left[which[i]]:.6e}"), mildest[which[i]], which[i], mild[i], tuple(orders[i])),
    )
    return [
        FiringOrder(
            order=tuple(orders[i].tolist()),
            crank_angles=angles[j],
            force_1=float(np.asarray(one.force_peak)[j]),
            couple_1_forward=float(np.asarray(one.couple_forward)[j]),
            couple_1_backward=float(np.asarray(one.couple_backward)[j]),
            force_2=float(np.asarray(two.force_peak)[j]),
            couple_2=float(np.asarray(two.couple_peak)[j]),
            left=float(left[j]),
            neighbours=int(beside[i]),
            same_half=int(half[i]),
        )
        for i, j in ((i, which[i]) for i in ranked)
    ]


def _in_turn(engine: EngineInputs, orders: IndexArray) -> tuple[IndexArray, IndexArray]:
    """Of each order, how often neighbours, and cylinders of one half or bank, fire one after the other (Finotti 2013,
    2.3.4)."""
    fired = orders - 1
    if engine.cylinders < 2:
        return np.zeros(len(fired), int), np.zeros(len(fired), int)
    place = places(engine)[fired]
    after = np.roll(place, -1, axis=1)
    if engine.layout == "inline":
        # the middle one of an odd number is of neither
        side, side_after = (np.sign(2 * x - np.max(place)) for x in (place, after))
    else:
        side = banks(engine)[fired] + 1
        side_after = np.roll(side, -1, axis=1)
    return np.sum(np.abs(place - after) <= 1, 1), np.sum((side == side_after) & (side != 0), 1)


def _orders(engine: EngineInputs) -> Iterable[tuple[int, ...]]:
    n = engine.cylinders
    if n <= ALL:
        return ((1, *rest) for rest in permutations(range(2, n + 1)))
    orders: list[tuple[int, ...]] = []
    if n <= SOME and engine.layout == "inline":
        orders = list(_symmetric(n, engine.strokes))
    elif n <= SOME and engine.layout in ("vee", "boxer"):
        orders = list(_paired(engine))
    if not orders:
        raise NoSolution(
            Text("firing orders of {n} cylinders in this layout are not listed", n=n),
            Text(
                "every order is tried for up to {all} cylinders; up to {some} those of symmetrical inline cranks, and "
                "of two banks on common (boxer: opposed) pins, where these fire evenly",
                all=ALL,
                some=SOME,
            ),
            Text("give the crank angles or one firing order; `check` shows what it leaves"),
        )
    return orders


def _paired(engine: EngineInputs) -> Iterator[tuple[int, ...]]:
    """Orders of a vee whose cylinders side by side share a pin, and of a boxer whose neighbours run on opposed ones."""
    n, row = engine.cylinders, places(engine)
    shift = 0.0 if engine.layout == "boxer" else (engine.bank_angle or 0.0) / (engine.strokes * math.pi / n)
    rows = [np.flatnonzero(row == k).tolist() for k in range(n // 2)]
    if abs(shift - round(shift)) > 1e-9 or any(len(pair) != 2 for pair in rows):
        return
    apart = n // 2 if engine.strokes == 4 else n  # places so far apart share a crank angle
    place = [-1] * n

    def fill(k: int, free: frozenset[int]) -> Iterator[tuple[int, ...]]:
        if k == len(rows):
            yield tuple(int(c) + 1 for c in np.argsort(place))
            return
        first, second = sorted(rows[k], key=lambda c: bank[c])
        for p in (0,) if first == 0 else sorted(free):
            for q in sorted({(p + round(shift)) % n, (p + round(shift) + apart) % n}):
                if p != q and {p, q} <= free and (second != 0 or q == 0):
                    place[first], place[second] = p, q
                    yield from fill(k + 1, free - {p, q})

    bank = engine.bank_of_cylinder or tuple(c % 2 for c in range(n))
    yield from fill(0, frozenset(range(n)))


def _symmetric(n: int, strokes: int) -> Iterator[tuple[int, ...]]:
    """Orders of inline cranks whose ends mirror each other.

    Four strokes and n even: the throws k and n + 1 − k at one angle.  Else they stand mirrored at an axis: their places
    add up to the same number."""
    pairs = n // 2
    in_line = strokes == 4 and n % 2 == 0
    for whole in (pairs,) if in_line else range(1, n, 1 if n % 2 else 2):
        partner = [(i + pairs) % n if in_line else (whole - i) % n for i in range(n)]
        middle = [i for i in range(n) if partner[i] == i]
        if partner[0] in (0, *middle):
            continue
        free = [i for i in range(1, n) if i < partner[i] and 0 not in (i, partner[i])]
        for chosen in permutations(free):
            for sides in product((0, 1), repeat=len(chosen)):
                place = [0] * n
                place[n - 1] = partner[0]
                if middle:
                    place[pairs] = middle[0]
                for k, (i, side) in enumerate(zip(chosen, sides), 1):
                    place[k], place[n - 1 - k] = (partner[i], i) if side else (i, partner[i])
                yield tuple(int(k) + 1 for k in np.argsort(place))


def _left(
    imbalance: ImbalanceInputs, engine: EngineInputs, e: EngineResult, place: IndexArray
) -> tuple[dict[int, Order], Array]:
    """All harmonic orders of many cranks at once, and their crank angles."""
    layout = crank(replace(engine, crank_angles=None, firing_order=tuple(range(1, engine.cylinders + 1))), e.tdc_angle)
    with untraced():
        angles = throw_angles(psi=layout.top, i=place, strokes=engine.strokes, N=engine.cylinders)
        every = replace(e, crank=replace(layout, phi=angles))
        judged = harmonics(e, imbalance.kinematics)
        return {
            n: order(n, c_n, imbalance, engine, every) for n, c_n in enumerate(judged, 1) if np.any(c_n) or n <= 2
        }, angles


COLUMNS = (
    (Text("order"), ""),
    (Text("crank angles"), "°"),
    (Text("pins"), ""),
    (Text("F order 1"), "N"),
    (Name("C₁⁺"), "N·m"),
    (Name("C₁⁻"), "N·m"),
    (Text("F order 2"), "N"),
    (Text("C order 2"), "N·m"),
    (Text("neighbours"), ""),
    (Text("same half"), ""),
)
TITLE = Text("Evenly firing orders, the one that leaves least first")
RANKED = Text(
    "Ranked by the forces, and the couples over one pitch, of all orders with half of the reciprocating mass on the "
    "crank; of equal ones first where neighbours (their main bearing), then where cylinders of one half or bank (their "
    "intake), fire in turn least often."
)


def orders_table(orders: list[FiringOrder], most: int, design: FiringOrder, engine: EngineInputs) -> Table:
    """The best orders, each with its number in the ranking, under the design as it is."""
    rows = (
        ("", *_row(design, engine)),
        *((float(n), *_row(candidate, engine)) for n, candidate in enumerate(orders[:most], 1)),
    )
    shown = plural(
        "{shown} of {n} order, under the design as it is.",
        "{shown} of {n} orders, under the design as it is.",
        n=len(orders),
        shown=len(rows) - 1,
    )
    return Table("firing_orders", TITLE, ((Text("no."), ""), *COLUMNS), rows, SPACE.join((shown, RANKED)))


def cranks_table(orders: list[FiringOrder], engine: EngineInputs, most: int = 12) -> Table:
    """The best cranks, each with the best of the orders that it can fire in."""
    cranks = [
        candidate
        for n, candidate in enumerate(orders)
        if n == 0 or not np.allclose(orders[n - 1].crank_angles, candidate.crank_angles)
    ]
    note = Text(
        "{n} orders on {cranks} different cranks; of each crank the best order.", n=len(orders), cranks=len(cranks)
    )
    return Table(
        "firing_orders",
        TITLE,
        COLUMNS,
        tuple(_row(candidate, engine) for candidate in cranks[:most]),
        SPACE.join((note, RANKED)),
    )


def as_designed(imbalance: ImbalanceInputs, engine: EngineInputs, e: EngineResult) -> FiringOrder:
    """The design's own crank and order in the terms of the list."""
    judged = harmonics(e, imbalance.kinematics)
    with untraced():
        one, two = (order(n, judged[n - 1], imbalance, engine, e) for n in (1, 2))
    fires = firing(engine, e.crank).order
    beside, half = _in_turn(engine, np.array([fires], dtype=np.intp))
    return FiringOrder(
        order=fires,
        crank_angles=e.crank.phi,
        force_1=one.force_peak,
        couple_1_forward=one.couple_forward,
        couple_1_backward=one.couple_backward,
        force_2=two.force_peak,
        couple_2=two.couple_peak,
        left=float("nan"),
        neighbours=int(beside[0]),
        same_half=int(half[0]),
    )


def _row(candidate: FiringOrder, engine: EngineInputs) -> tuple[str | float, ...]:
    throws = crank(replace(engine, crank_angles=tuple(candidate.crank_angles.tolist()), firing_order=None), 0.0)
    pins = float(pin_of_cylinder(engine, throws).max() + 1)
    peaks = (
        candidate.force_1,
        candidate.couple_1_forward,
        candidate.couple_1_backward,
        candidate.force_2,
        candidate.couple_2,
        float(candidate.neighbours),
        float(candidate.same_half),
    )
    return ("-".join(map(str, candidate.order)), crank_words(candidate.crank_angles), pins, *peaks)


def crank_words(angles: Array) -> str:
    """Crank angles in degrees, as a row of words."""
    degrees = np.round(np.degrees(angles), 3) % 360
    return " ".join(f"{a:g}" for a in degrees)
