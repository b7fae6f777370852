# SPDX-License-Identifier: Apache-2.0
"""What shakes the engine: the wrenches on its centre of gravity, every order, every variant of the balancing.

All hold at any speeds."""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from statistics import NormalDist

import numpy as np

from ..countershaft.sums import SystemShaft, pairs_of
from ..engine.crank import firing
from ..engine.gas_torque import Nodes, all_cylinders, harmonics, index, integer, nodes, orders_of
from ..engine.inputs import EngineInputs
from ..engine.operation import changes, over_speed
from ..engine.result import EngineResult
from ..imbalance.result import ImbalanceResult
from ..imbalance.shaft_pair import roll_backward, roll_forward
from ..sheet.arrays import Array, ComplexArray
from ..sheet.record import record
from ..sheet.text import Name, Text
from ..sheet.units import Number, Radian, RevPerSecond
from ..sheet.value import about, based_on
from . import excitation as x
from .excitation import Moving, moving, turning_wrench
from .inputs import SEVERAL_WORDS, VARIANT_WORDS, MountingInputs, Operation

TOOTH = "tooth"
PURE = 1e-6  # of a couple: smaller forces beside it are dust
EXACT = 0.0, 0.0


@record
class ShaftOnEngine(SystemShaft):
    """A balance shaft as the mounts see it.

    `errors`: of a shaft as it scatters, of its couple s and its angle δ, None where nothing is known."""

    errors: tuple[Number, Radian] | None = None


@record
class Variant:
    """The engine with its shafts, each with its own error s of its couple and its own angle δ by which it is late (of
    those that are not named: none)."""

    words: Text
    off: Mapping[str, tuple[Number, Radian]]

    def shafts(self, shafts: Iterable[ShaftOnEngine]) -> Iterator[ShaftOnEngine]:
        for shaft in shafts:
            s, delta = self.off.get(shaft.name, EXACT)
            yield shaft.late_by(delta, s)


def with_shafts(shafts: Sequence[ShaftOnEngine]) -> dict[str, Variant]:
    """The variants with the shafts of a design: as designed, as they scatter, one tooth off."""
    if not shafts:
        return {}
    variants = {"shaft": Variant(VARIANT_WORDS["shaft"], {})}
    errors = {shaft.name: shaft.errors for shaft in shafts if shaft.errors is not None}
    if errors:
        variants["scatter"] = Variant(VARIANT_WORDS["scatter"], errors)
    if len(shafts) > 1:
        return variants | one_tooth_off(shafts)
    if shafts[0].tooth is not None:
        variants[TOOTH] = Variant(VARIANT_WORDS[TOOTH], {shafts[0].name: (0.0, shafts[0].tooth)})
    return variants


def one_tooth_off(shafts: Sequence[ShaftOnEngine]) -> dict[str, Variant]:
    """Of several shafts every row of the table of one tooth off: each by itself, each with its mirror images, all, and
    each of these late and early."""
    rows: dict[tuple[str, ...], Text] = {(shaft.name,): Name(shaft.name) for shaft in shafts}
    for name, pair in pairs_of(shafts).items():
        rows[tuple(shaft.name for shaft in pair)] = Text("{name} and its mirror image", name=Name(name))
    rows.setdefault(tuple(shaft.name for shaft in shafts), Text("all shafts"))
    teeth = {shaft.name: shaft.tooth for shaft in shafts}
    variants: dict[str, Variant] = {}
    for names, words in rows.items():
        for sense, sign in ((Text("late"), 1.0), (Text("early"), -1.0)):
            by = {name: (0.0, based_on(sign * tooth, tooth)) for name in names if (tooth := teeth[name]) is not None}
            if len(by) == len(names):
                which = Text("{which}, one tooth {sense}", which=words, sense=sense)
                variants[f"{TOOTH}_{len(variants) + 1}"] = Variant(which, by)
    return variants


@record
class EngineWrenches:
    """`inertia`: forces and moments of the masses at rated speed about the centre of gravity (variants, orders, 6),
    torque included.

    `gas`: of one cylinder at which speeds; None where it is not given.  `apart`: the orders in which the variants
    differ, by index.  `off`: of several shafts the variants with some of them one tooth off, which stand last."""

    engine: EngineInputs
    e: EngineResult
    orders: Array
    variants: tuple[str, ...]
    inertia: ComplexArray
    torque_of_masses: ComplexArray
    nodes: Nodes | None
    spread: Array
    fires: Array
    r_G: Array
    apart: tuple[int, ...]
    shafts: tuple[ShaftOnEngine, ...]
    off: Mapping[str, Variant]
    # half over each variant with the shaft, where the order of the shaft is a pure couple
    first_order: dict[str, float]

    @property
    def shown(self) -> tuple[str, ...]:
        """The variants with those of one tooth off as a single one, of which every number is that of the worst."""
        return (*self.variants[: -len(self.off)], TOOTH) if self.off else self.variants

    @property
    def words(self) -> Mapping[str, Text]:
        """What the variants are called."""
        return SEVERAL_WORDS if len(self.shafts) > 1 else VARIANT_WORDS

    @property
    def taken(self) -> tuple[float, ...]:
        """The orders at which a shaft turns."""
        return tuple(sorted({float(shaft.order) for shaft in self.shafts}))

    def torque(self, speeds: Array) -> ComplexArray:
        """Order by order on the crank (speeds, orders): gas and inertia."""
        of_masses = self.torque_of_masses * self._squares(speeds)[:, None]
        gas = np.zeros_like(of_masses) if self.nodes is None else harmonics(self.engine, self.e, self.nodes, speeds)
        of_masses = based_on(of_masses, self.torque_of_masses, self.e.angular_speed, speeds)
        return all_cylinders(t_one=gas, t_inertia=of_masses, spread=self.spread, fires=self.fires, n=self.orders)

    @property
    def own(self) -> str:
        """The design's own variant."""
        return "shaft" if "shaft" in self.variants else "half"

    def strengths(self, wrench: ComplexArray | None, rho: float) -> Array:
        """How strong each order is with half on the crank, of a wrench (orders, variants, 6); None: of the masses
        alone, without torque.

        `rho`: radius of gyration, by which a force is compared with a moment.
        """
        v = self.variants.index("half")
        if wrench is None:
            return x.strength(self.inertia[v][:, :3], self.inertia[v][:, 3:5], rho)
        return x.strength(np.asarray(wrench)[:, v, :3], np.asarray(wrench)[:, v, 3:], rho)

    def mean_torque(self, speeds: Array) -> Array:
        """Of the gas of all cylinders; inertia adds nothing."""
        if self.nodes is None:
            return np.zeros(len(speeds))
        gas = harmonics(self.engine, self.e, self.nodes, speeds, mean=True)[:, 0].real / 2
        mean: Array = gas * (1 + np.asarray(self.spread)).sum()
        return mean

    def wrench(self, speeds: Array, torque: ComplexArray) -> ComplexArray:
        """About the centre of gravity (speeds, orders, variants, 6)."""
        squares = self._squares(speeds)
        wrench = np.swapaxes(self.inertia, 0, 1)[None] * squares[:, None, None, None]
        wrench[..., 5] -= (np.asarray(torque) - self.torque_of_masses * squares[:, None])[:, :, None]
        return based_on(wrench, self.inertia, torque, self.r_G, speeds)

    def frequencies(self, speeds: Array) -> Array:
        """Ω of every speed and order, in one row."""
        frequencies: Array = (2 * math.pi * np.asarray(speeds)[:, None] * self.orders).ravel()
        return based_on(frequencies, speeds)

    def _squares(self, speeds: Array) -> Array:
        return (np.asarray(speeds, dtype=float) / float(self.engine.rated_speed)) ** 2


def drive(
    mounting: MountingInputs,
    engine: EngineInputs,
    e: EngineResult,
    imbalance: ImbalanceResult,
    shafts: tuple[ShaftOnEngine, ...],
) -> EngineWrenches:
    n = orders_of(engine.strokes)
    fires = firing(engine, e.crank)
    turning = e.torque
    assert turning is not None
    torque, reaction = integer(turning.harmonics, n), integer(turning.reaction_harmonics, n)
    inertia, variants = [], ["bare", "half"]
    with about(Text("half on the crank")):
        half = moving(n, imbalance.orders, bare=False)
    with about(Text("nothing balanced")):
        inertia.append(turning_wrench(moving(n, imbalance.orders, bare=True), reaction))
    inertia.append(turning_wrench(half, reaction))
    cases = with_shafts(shafts)
    for name, variant in cases.items():
        with about(variant.words):
            inertia.append(turning_wrench(*_with_shafts(n, half, reaction, variant.shafts(shafts))))
        variants.append(name)
    whole = based_on(np.stack(inertia), *inertia)
    whole[np.abs(whole) < 1e-12 * np.abs(whole).max(initial=0.0)] = 0.0
    moment = x.about_gravity(F=whole[..., :3], M=whole[..., 3:], r_G=mounting.centre_of_gravity)
    at_gravity = based_on(np.concatenate([whole[..., :3], moment], -1), moment)
    return EngineWrenches(
        engine=engine,
        e=e,
        orders=n,
        variants=tuple(variants),
        inertia=at_gravity,
        torque_of_masses=based_on(torque, turning.harmonics),
        nodes=nodes(engine, e, engine.gas, running(mounting, engine), n) if engine.gas is not None else None,
        spread=_spread(mounting, engine, fires.order),
        fires=fires.angles,
        r_G=np.asarray(mounting.centre_of_gravity),
        apart=tuple(sorted({index(n, 1.0), *(index(n, shaft.order) for shaft in shafts)})),
        shafts=shafts,
        off={name: variant for name, variant in cases.items() if name not in VARIANT_WORDS},
        first_order=_first_order(n, half, shafts[0]) if len(shafts) == 1 else {},
    )


def _first_order(n: Array, half: Moving, shaft: ShaftOnEngine) -> dict[str, float]:
    """How much less there is of the shaft's order at every place, where it is a couple that turns backward and nothing
    else."""
    if shaft.forward:
        return {}
    i = index(n, shaft.order)
    F_f, F_b, C_f, C_b = (complex(part[i]) for part in half)
    if not C_b or max(abs(F_f), abs(F_b), abs(C_f)) > PURE * abs(C_b):
        return {}
    ratios, left = {}, C_b + shaft.couple
    if left:
        C_left = based_on(left, half[3], shaft.couple)
        ratios["shaft"] = x.couple_ratio(C=based_on(C_b, half[3]), C_left=C_left)
    others = {name: variant.off.get(shaft.name, EXACT) for name, variant in with_shafts([shaft]).items()}
    return ratios | {name: x.first_order_ratio(s=s, delta=delta) for name, (s, delta) in others.items() if s or delta}


def _with_shafts(
    n: Array, half: Moving, roll: ComplexArray, shafts: Iterable[ShaftOnEngine]
) -> tuple[Moving, ComplexArray]:
    """The same vectors with those of the shafts at their orders, and with the roll of their forces."""
    F_f, F_b, C_f, C_b = (np.array(part) for part in half)
    rolled, of = np.array(roll), []
    for shaft in shafts:
        i, forward = index(n, shaft.order), shaft.forward
        (F_f if forward else F_b)[i] += shaft.force
        (C_f if forward else C_b)[i] += shaft.couple
        of += [shaft.force, shaft.couple]
        if shaft.axis is not None:
            M_z = (roll_forward if forward else roll_backward)(p=shaft.axis, F=shaft.force)
            rolled[i] += M_z
            of.append(M_z)
    parts = tuple(based_on(part, before, *of) for part, before in zip((F_f, F_b, C_f, C_b), half))
    return parts, based_on(rolled, roll, *of)  # type: ignore[return-value]


def _spread(mounting: MountingInputs, engine: EngineInputs, order: tuple[int, ...]) -> Array:
    """ε of each cylinder: given, or from one standard deviation, evenly spaced quantiles in firing order."""
    given = mounting.cylinder_spread
    if given is None:
        return np.zeros(engine.cylinders)
    if len(given) == engine.cylinders and engine.cylinders > 1:
        return based_on(np.asarray(given, dtype=float), given)
    quantiles = [NormalDist().inv_cdf((k + 0.5) / engine.cylinders) for k in range(engine.cylinders)]
    spread = np.zeros(engine.cylinders)
    spread[np.asarray(order) - 1] = given[0] * np.array(quantiles)
    return based_on(spread, given)


def running(mounting: MountingInputs, engine: EngineInputs) -> tuple[Operation, ...]:
    """The operations, else how the engine runs over its speed: without hours, which are shares there and no hours a
    day."""
    return mounting.operation or tuple(
        Operation(name=row.name, speed=row.speed, **changes(row))
        for row in over_speed(engine.operation, mounting.idle_speed)
    )


def operating(mounting: MountingInputs, engine: EngineInputs) -> tuple[tuple[str, RevPerSecond, float], ...]:
    """Name, speed and hours of every operation; where none is given, idle and rated."""
    if rows := running(mounting, engine):
        return tuple((row.name, row.speed, row.hours or 0.0) for row in rows)
    return ("idle", mounting.idle_speed, 0.0), ("rated", engine.rated_speed, 0.0)
