# SPDX-License-Identifier: Apache-2.0
"""What production makes of several balance shafts together: by chance, and to first order.

Each shaft is drawn by itself, as scatter.py has it, drilled where it has holes; draw k of the system is draw k of each
of its shafts.  What they leave adds up as vectors, so that errors of shafts that turn alike may cancel."""

from collections.abc import Iterator, Mapping, Sequence
from random import Random
from typing import Any

import numpy as np

from ...sheet.arrays import Array, ComplexArray
from ...sheet.formula import formula
from ...sheet.functions import rss
from ...sheet.linked_array import column, gathered
from ...sheet.record import record
from ...sheet.text import Name, Text
from ...sheet.units import Newton, NewtonMetre, NewtonMetres, Newtons, Number, RadPerSecond
from ...sheet.value import about, based_on, untraced
from ..inputs import EccentricMass, Extra, Scatter
from ..sums import OrderScatter, OrderVectors, SystemScatter, SystemShaft
from .scatter import BLOCK, PERCENTILES, PROPAGATION, Target, calibrated, errors, joint, percentile, ranked, sample
from .unbalance import HolesResult

TOGETHER = Text("{propagation}: root of squares over the shafts that turn alike", propagation=PROPAGATION)


@formula("σ_F,n", TOGETHER, names={"sigma": "σ_F"})
def force_errors_joined(sigma: Newtons) -> Newton:
    return rss(sigma)


@formula("σ_C,n", TOGETHER, names={"sigma": "σ_C"})
def couple_errors_joined(sigma: NewtonMetres) -> NewtonMetre:
    return rss(sigma)


@formula(
    "F_n,p",
    "mathematics: order statistics of the shafts tried",
    shows="the smallest force that the share p of the shafts does not exceed",
)
def force_percentile(F: Newtons, p: Number) -> Newton:
    """`F` in rising order."""
    return ranked(F, p)


@record
class MadeShaft:
    """One of the shafts with the masses that it is made of, and how they scatter (None: it is exact).

    `omega`: its own speed; `extras`: elements that are exact; `drilling`: what it is calibrated by, None where it has
    no holes.  A twin has its own masses, those of a mirror image at −γ."""

    shaft: SystemShaft
    omega: RadPerSecond
    scatter: Scatter | None
    masses: tuple[EccentricMass, ...]
    extras: tuple[Extra, ...] = ()
    drilling: tuple[Target, HolesResult] | None = None


def system_scattered(engine: Mapping[int, OrderVectors], shafts: Sequence[MadeShaft]) -> SystemScatter | None:
    """As many engines as the fewest shafts that are tried of one; None where every shaft is exact.

    The draws of the shaft at place k have the seed of its scatter + k: twins meet other luck, and so do shafts that
    were given the same seed."""
    tried = [made.scatter.shafts for made in shafts if made.scatter is not None]
    if not tried:
        return None
    drawn = [_drawn(made, place, min(tried)) for place, made in enumerate(shafts)]
    peaks: dict[int, list[tuple[Array, Array]]] = {n: [] for n in sorted({made.shaft.order for made in shafts})}
    for _ in range(0, min(tried), BLOCK):
        with untraced():
            block = [(made.shaft, *next(draws)) for made, draws in zip(shafts, drawn)]
        for n, blocks in peaks.items():
            blocks.append(_peaks(engine[n], [one for one in block if one[0].order == n]))
    values: dict[str, Any] = {}
    parts: dict[str, OrderScatter] = {}
    ordered: tuple[dict[int, Array], dict[int, Array]] = {}, {}
    p = PERCENTILES["95"]
    for n, blocks in peaks.items():
        for word, some in zip(ordered, zip(*blocks)):
            word[n] = based_on(np.sort(np.concatenate(some)), engine, shafts)
        with about(Text("scatter of all shafts, order {n}", n=n)):
            values[f"order_{n}_force_95"] = force_percentile(F=ordered[0][n], p=p)
            values[f"order_{n}_couple_95"] = percentile(C=ordered[1][n], p=p)
            parts[f"order_{n}"] = _errors([made for made in shafts if made.shaft.order == n])
    return SystemScatter(**values, errors=parts, forces=ordered[0], couples=ordered[1])


def _drawn(made: MadeShaft, place: int, count: int) -> Iterator[tuple[ComplexArray, ComplexArray]]:
    """Force and couple of so many shafts, block by block, as they are fitted: drilled, and with their timing (whose
    sign is drawn as well, so that one turn serves both senses)."""
    scatter, masses = made.scatter, made.masses
    sizes = [min(BLOCK, count - start) for start in range(0, count, BLOCK)]
    if scatter is None:
        yield from ((np.full(size, made.shaft.force), np.full(size, made.shaft.couple)) for size in sizes)
        return
    random = Random(scatter.seed + place)
    for size in sizes:
        force, couple, timing, _ = sample(scatter, masses, made.extras, made.omega, random, size)
        if made.drilling is not None:
            target, holes = made.drilling
            z, turned = column(masses, "z"), np.exp(1j * column(masses, "angle"))
            deviation = target.deviation(force, couple)
            taken, _ = calibrated(deviation, target.influence(masses), holes.hole_unbalance_of_mass)
            force = force - made.omega**2 * joint(turned, taken)
            couple = couple - made.omega**2 * joint(z * turned, taken)
        yield force * timing, couple * timing


def _peaks(of: OrderVectors, fitted: Sequence[tuple[SystemShaft, ComplexArray, ComplexArray]]) -> tuple[Array, Array]:
    """What is left of force and couple in every engine, at its peak over a turn."""
    forces = [np.asarray(of.force_forward), np.asarray(of.force_backward)]
    couples = [np.asarray(of.couple_forward), np.asarray(of.couple_backward)]
    for shaft, force, couple in fitted:
        side = 0 if shaft.forward else 1
        forces[side], couples[side] = forces[side] + force, couples[side] + couple
    return np.abs(forces[0]) + np.abs(forces[1]), np.abs(couples[0]) + np.abs(couples[1])


def _errors(shafts: Sequence[MadeShaft]) -> OrderScatter:
    """Of the shafts of one order."""
    senses: dict[bool, list[dict[str, float]]] = {True: [], False: []}
    for made in shafts:
        if made.scatter is not None:
            with about(Name(made.shaft.name)):
                senses[made.shaft.forward].append(errors(made.scatter, made.masses, made.extras, made.omega))
    F_f, F_b = (gathered(one["force_error"] for one in senses[forward]) for forward in (True, False))
    C_f, C_b = (gathered(one["couple_error"] for one in senses[forward]) for forward in (True, False))
    return OrderScatter(
        force_forward=force_errors_joined(sigma=F_f),
        force_backward=force_errors_joined(sigma=F_b),
        couple_forward=couple_errors_joined(sigma=C_f),
        couple_backward=couple_errors_joined(sigma=C_b),
    )
