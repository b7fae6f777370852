# SPDX-License-Identifier: Apache-2.0
"""Figures of the mounts: the level of a seat over speed, orders beside each other with and without the shaft, forces of the mounts."""

import numpy as np

from ..sheet.step import Curve, Series, axis_label
from ..sheet.text import Amount, Name, Text
from .result import MountingResult
from .tables import table
from .words import VARIANT_WORDS


def curves(result: MountingResult) -> tuple[Curve, ...]:
    """What there is to draw: of a design without a seat the forces alone."""
    return (*seat_over_speed(result), *orders_at(result), forces(result))


def seat_over_speed(result: MountingResult) -> tuple[Curve, ...]:
    """The weighted level of each seat from idle to rated, one line for each variant; limits: perception and comfort."""
    limits = (
        (Text("felt by half of all people"), table()["perception"]["peak_m_s2"] / np.sqrt(2)),
        (Text("comfort"), next(row["above_m_s2"] for row in table()["comfort"] if row["above_m_s2"])),
    )
    found = []
    for seat, c in result.courses.items():
        series = tuple(Series(VARIANT_WORDS[variant], c.speeds * 60, c.total[v]) for v, variant in enumerate(c.variants))
        found.append(
            Curve(
                f"seat_{seat}",
                Text("Weighted acceleration at {seat} over speed", seat=Name(seat)),
                axis_label("speed", "rpm"),
                axis_label("a_w", "m/s²"),
                series,
                limits,
            )
        )
    return tuple(found)


def orders_at(result: MountingResult) -> tuple[Curve, ...]:
    """Bars by order at each operation, half beside shaft: order 1 goes, the firing order stays."""
    found = []
    for seat, weight in result.levels.weight.items():
        a = np.abs(result.levels.acceleration[seat])
        sizes = np.sqrt(((weight * a) ** 2).sum(2) / 2)  # (operations, variants, orders)
        shown = np.flatnonzero((sizes > 1e-9 * sizes.max(initial=0.0)).any((0, 1)))
        names = tuple(Text("{n}", n=Amount(float(result.drive.orders[i]))) for i in shown)
        place = np.arange(1, shown.size + 1, dtype=float)
        for i, (operation, (speed, _)) in enumerate(result.speeds.items()):
            series = tuple(
                Series(VARIANT_WORDS[variant], place, sizes[i, result.drive.variants.index(variant), shown])
                for variant in ("half", "shaft")
                if variant in result.drive.variants
            )
            title = Text(
                "Orders at {seat}, {operation}, {speed}",
                seat=Name(seat),
                operation=Name(operation),
                speed=Amount(speed * 60, "rpm", digits=4),
            )
            found.append(
                Curve(f"orders_{seat}_{operation}", title, Text("order"), axis_label("a_w", "m/s²"), series, bars=True, names=names)
            )
    return tuple(found)


def forces(result: MountingResult) -> Curve:
    """The force of each mount at each operation, half beside shaft."""
    names = tuple(Name(mount.name) for mount in result.system.mounting.mounts)
    place = np.arange(1, len(names) + 1, dtype=float)
    F = np.sqrt((np.abs(result.levels.force) ** 2).sum((-1, -2)) / 2)  # (operations, variants, mounts)
    series = tuple(
        Series(
            Text("{operation}, {variant}", operation=Name(operation), variant=VARIANT_WORDS[variant]),
            place,
            F[i, result.drive.variants.index(variant)],
        )
        for i, operation in enumerate(result.speeds)
        for variant in ("half", "shaft")
        if variant in result.drive.variants
    )
    return Curve("mount_forces", Text("Forces of the mounts"), Text("mount"), axis_label("F", "N"), series, bars=True, names=names)
