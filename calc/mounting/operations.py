# SPDX-License-Identifier: Apache-2.0
"""Operation by operation: torque, levels at the points, forces of the mounts, transmissibility; transfer functions.

Each with what the shaft takes off it."""

import math
from collections.abc import Sequence

import numpy as np

from ..engine.gas_torque import order_word
from ..sheet.arrays import Array, ComplexArray
from ..sheet.linked_array import gathered
from ..sheet.quantity import Described
from ..sheet.record import record
from ..sheet.text import Text
from ..sheet.value import based_on
from . import excitation as x
from . import levels as l
from . import standards
from .inputs import VARIANT_WORDS, MountingInputs
from .levels import Levels
from .result import (
    FeltLevel,
    MachineLevel,
    MountingResult,
    MountLevel,
    Nested,
    OrderForce,
    OrderLevel,
    PointLevel,
    Tree,
    along_last,
    described,
    joined,
    mapped,
    put,
    there,
)
from .system import System, moves, respond_at
from .wrenches import EngineWrenches

SHOWN = tuple(name for name in PointLevel.__dataclass_fields__ if name != "orders")
FELT = 1e-6  # of all orders together: one that is weaker is not worth a line
BY_ORDER = ("half", "shaft")  # variants whose orders are shown one by one


def operations(
    driven: EngineWrenches,
    lines: Levels,
    s: System,
    rows: Sequence[tuple[str, float, float]],
    torque: ComplexArray,
    there: list[int],
) -> Tree:
    """Everything that stands below the name of an operation."""
    tree: Tree = {name: {} for name, _, _ in rows}
    points, mounts = s.mounting.points, s.mounting.mounts
    _torque(tree, driven, rows, torque, there)
    for p, point in enumerate(points):
        felt = _felt(driven, lines, point.name, there) if point.role != "machine" else None
        own = FeltLevel if felt is not None else MachineLevel if point.on == "engine" else PointLevel
        levels = _points(driven, lines, p, point.name, felt, own)
        for (name, _, _), of_operation in zip(rows, levels):
            for variant, level in zip(driven.variants, of_operation):
                tree[name].setdefault(variant, {})[point.name] = level
    _mounts(tree, driven, lines, rows, [mount.name for mount in mounts], there)
    _transmissibility(tree, driven, lines, rows, there)
    _ratios(tree, driven, rows, s.mounting)
    return tree


def existing(driven: EngineWrenches, lines: Levels) -> list[int]:
    """The orders by their index that drive the engine at all, with half on the crank."""
    half = np.asarray(lines.wrench)[:, :, driven.variants.index("half")]
    sizes = (np.linalg.norm(half[..., :3], axis=-1) + np.linalg.norm(half[..., 3:], axis=-1)).max(0)
    return [int(i) for i in np.flatnonzero(sizes > l.NONE_BELOW * sizes.max(initial=0.0))]


def _torque(
    tree: Tree, driven: EngineWrenches, rows: Sequence[tuple[str, float, float]], torque: ComplexArray, there: list[int]
) -> None:
    about = described(Text("Torque on the crank, this order"), "N·m", "T_n")
    for (name, _, _), t in zip(rows, np.asarray(torque).tolist()):
        for i, order in zip(there, _words(driven, there)):
            if t[i]:
                put(tree[name], ("torque", order), about, x.amplitude(t_n=based_on(t[i], torque)))


def _points(
    driven: EngineWrenches, lines: Levels, point: int, name: str, felt: "Felt | None", own: type[PointLevel]
) -> list[list[PointLevel]]:
    """The levels at a point (operations, variants).  `own`: what they are of the design's own variant."""
    numbers, source = [], (lines.source, lines.places[name])
    banded = np.sqrt((np.abs(np.where(lines.band, lines.motion, 0.0)[:, :, point]) ** 2).sum(-1) / 2)
    for k, (of_axis, of_all) in enumerate(l.KINDS):
        axes = mapped(of_axis, lines.motion[:, :, point, k], source=source)
        numbers += [joined(of_all, axes), *along_last(axes)]
    numbers.append(mapped(standards.grade, *np.moveaxis(banded, 2, 0), source=source))
    if felt is not None:
        numbers += [felt.whole, *along_last(felt.axes)]

    def level(i: int, v: int) -> PointLevel:
        by_name = dict(zip(SHOWN, map(there, (x[i][v] for x in numbers))))
        kind = own if driven.variants[v] == driven.own else PointLevel
        return kind(**by_name, orders=felt.orders(i, v) if felt is not None else None)

    return [[level(i, v) for v in range(len(driven.variants))] for i in range(len(lines.speeds))]


@record
class Felt:
    """What is felt at a seat or at a hand: (operations, variants), its axes along the last, and each order of some
    variants."""

    whole: Nested
    axes: Nested
    by_order: Nested  # (operations, those variants, orders)
    shown: list[int]
    words: list[str]

    def orders(self, i: int, v: int) -> dict[str, OrderLevel] | None:
        if v not in self.shown:
            return None
        return {
            word: OrderLevel(weighted=there(x)) for word, x in zip(self.words, self.by_order[i][self.shown.index(v)])
        }


def _felt(driven: EngineWrenches, lines: Levels, name: str, existing: list[int]) -> Felt:
    a, source = np.abs(lines.acceleration[name]), (lines.source, lines.places[name])
    W = np.broadcast_to(lines.weight[name], a.shape)
    along = mapped(standards.weighted, W, a, source=source)
    shown = _shown(driven)
    sizes = np.linalg.norm(W * a, axis=-2).max((0, 1))
    existing = [n for n in existing if not sizes[n] < FELT * sizes.max()]
    # (operations, variants, orders, axes, 1)
    apart = [np.moveaxis(x[:, shown][..., existing], -1, 2)[..., None] for x in (W, a)]
    by_order = joined(standards.total_value, mapped(standards.weighted, *apart, source=source))
    return Felt(joined(standards.total_value, along), along, by_order, shown, _words(driven, existing))


def _shown(driven: EngineWrenches) -> list[int]:
    return [v for v, variant in enumerate(driven.variants) if variant in BY_ORDER]


def _words(driven: EngineWrenches, existing: list[int]) -> list[str]:
    return [f"order_{order_word(driven.orders[n])}" for n in existing]


def _mounts(
    tree: Tree,
    driven: EngineWrenches,
    lines: Levels,
    rows: Sequence[tuple[str, float, float]],
    names: list[str],
    existing: list[int],
) -> None:
    F, shown, words = lines.force, _shown(driven), _words(driven, existing)
    whole = mapped(l.force, F.reshape(*F.shape[:3], -1), source=lines.source)
    peaks = mapped(l.deflection_peak, lines.deflection, source=lines.source, axes=2)
    by_order = mapped(l.force, np.moveaxis(F[:, shown][..., existing], -1, -2), source=lines.source)
    sums = [[l.force_sum(F=gathered(of_variant)) for of_variant in of_operation] for of_operation in whole]
    together = described(Text("Forces of all mounts"), "N", "ΣF")
    for i, (name, _, _) in enumerate(rows):
        for v, variant in enumerate(driven.variants):
            here = tree[name].setdefault(variant, {})
            for j, mount in enumerate(names):
                parts = None
                if v in shown:
                    parts = {word: OrderForce(force=there(x)) for word, x in zip(words, by_order[i][shown.index(v)][j])}
                force, peak = there(whole[i][v][j]), there(peaks[i][v][j])
                here[mount] = MountLevel(force=force, deflection_peak=peak, orders=parts)
            put(here, ("force_sum",), together, sums[i][v])


def _transmissibility(
    tree: Tree, driven: EngineWrenches, lines: Levels, rows: Sequence[tuple[str, float, float]], there: list[int]
) -> None:
    """With half on the crank: with the shaft the first order is a residue, and its ratio no property of the mounts."""
    v = driven.variants.index("half")
    wrench = np.asarray(lines.wrench)[:, :, v]
    of_moment = described(Text("Moment passed on over the moment that drives, this order"), "", "T_M")
    of_force = described(Text("Force passed on over the force that drives, this order"), "", "T_F")
    isolation = described(Text("Isolation of the moment, this order"), "%", "1 − T_M")
    for i, (name, _, _) in enumerate(rows):
        F, M = (np.linalg.norm(part, axis=-1) for part in (wrench[i, :, :3], wrench[i, :, 3:]))
        F_t, M_t = (np.linalg.norm(part[i, v], axis=-1) for part in lines.passed_on)
        for n, order in zip(there, _words(driven, there)):
            if M[n] > l.NONE_BELOW * M.max():
                passed_on, driving = based_on(float(M_t[n]), lines.source), based_on(float(M[n]), lines.wrench)
                T = l.moment_transmissibility(M_t=passed_on, M=driving)
                put(tree[name], ("half", order, "transmissibility_moment"), of_moment, T)
                put(tree[name], ("half", order, "isolation"), isolation, based_on(1 - T, T))
            if F[n] > l.NONE_BELOW * F.max():
                passed_on, driving = based_on(float(F_t[n]), lines.source), based_on(float(F[n]), lines.wrench)
                T = l.force_transmissibility(F_t=passed_on, F=driving)
                put(tree[name], ("half", order, "transmissibility_force"), of_force, T)


def _ratios(
    tree: Tree, driven: EngineWrenches, rows: Sequence[tuple[str, float, float]], mounting: MountingInputs
) -> None:
    """Half over shaft at the foremost seat, at the foremost point of the engine, in the mounts: three numbers, never
    one."""
    if "shaft" not in driven.variants:
        return
    seat, engine = mounting.seat, mounting.engine_point
    asked: list[tuple[str, str, str, Described]] = []
    if seat is not None:
        at_seat = described(Text("Felt at the seat, half over shaft"), "", "q_S", short=True, page_one=1, worst="least")
        asked.append(("felt_seat", seat.name, "weighted", at_seat))
    if engine is not None:
        at_engine = described(Text("Felt at the engine, half over shaft"), "", "q_S", short=True)
        asked.append(("felt_engine", engine.name, "velocity", at_engine))
    for name, _, _ in rows:
        half, shaft = tree[name]["half"], tree[name]["shaft"]
        for id, place, kind, about in asked:
            put(tree[name], (id,), about, _ratio(getattr(half[place], kind), getattr(shaft[place], kind)))
        about = described(Text("Felt in the mounts, half over shaft"), "", "q_S", short=True, page_one=2, worst="least")
        if "force_sum" in half and "force_sum" in shaft:
            put(tree[name], ("felt_force",), about, _ratio(half["force_sum"].number, shaft["force_sum"].number))


def _ratio(half: float | None, shaft: float | None) -> float | None:
    return l.felt_ratio(half=half, shaft=shaft) if half is not None and shaft else None


def felt_order_1(driven: EngineWrenches) -> Tree | None:
    """The same at every place, of a pure couple: what the shaft's own error leaves of first order; none of one without
    error."""
    tree: Tree = {}
    for name in ("shaft", "scatter", "tooth"):
        if name in driven.variants:
            label = Text("First order felt, half over {variant}", variant=VARIANT_WORDS[name])
            put(tree, (name,), described(label, "", "q_S,1", short=True), driven.first_order.get(name))
    return tree or None


# --- transfer functions
# How every point moves under unit forces and moments at the engine's centre of gravity, over frequency.

LOWEST, HIGHEST, STEP = 0.5, 200.0, 0.5  # Hz
DRIVES = ("F_x [N]", "F_y [N]", "F_z [N]", "M_x [N·m]", "M_y [N·m]", "M_z [N·m]")


def transfer_functions(result: MountingResult, f: Array) -> ComplexArray:
    """Displacement over wrench (frequencies, points, 3 axes, 6 components of the wrench), in m."""
    unit = np.broadcast_to(np.eye(6, dtype=complex), (len(f), 6, 6))
    q = respond_at(result.system, 2 * math.pi * np.asarray(f), unit)  # (frequencies, components, coordinates)
    P = np.stack([moves(result.system, point) for point in result.system.mounting.points])
    transfer: ComplexArray = np.einsum("pac,fwc->fpaw", P, q)
    return transfer


def rows(result: MountingResult) -> tuple[tuple[str, ...], list[list[float]]]:
    """Header and rows of a file: frequency, then real and imaginary part of each function, in mm."""
    f = np.arange(LOWEST, HIGHEST + STEP / 2, STEP)
    names = [
        f"{point.name}.{axis} [mm] / {drive}"
        for point in result.system.mounting.points
        for axis in "xyz"
        for drive in DRIVES
    ]
    header = ("frequency [Hz]", *(f"{name} {part}" for name in names for part in ("re", "im")))
    H = transfer_functions(result, f).reshape(f.size, -1) * 1e3
    both = np.stack([H.real, H.imag], -1).reshape(f.size, -1)
    return header, np.column_stack([f, both]).tolist()
