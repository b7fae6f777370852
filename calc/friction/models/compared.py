# SPDX-License-Identifier: Apache-2.0
"""The loss of a mesh by all models side by side, each with its range; how far they spread."""

from ...sheet.formula import formula
from ...sheet.record import record
from ...sheet.step import Table
from ...sheet.units import Number, Watt
from ..mesh.loss import MeshLoss
from .regressions import FASTEST, LOWEST_LINE_LOAD, RUNS, SMOOTH, Regression

TESTS = f"line load from {LOWEST_LINE_LOAD / 1e3:g} N/mm (held there below), sum of speeds from 1 m/s, pitch line to {FASTEST:g} m/s"


@record
class Model:
    """A published model: who made it, how its loss is found here, and where it holds."""

    authors: str
    how: str
    range: str


MODELS = {
    "schlenk": Model("Schlenk", "× Ohlendorf", TESTS),
    "niemann": Model("Niemann and Winter, Michaelis", "× Ohlendorf", TESTS),
    "xu_kahraman": Model(
        "Xu and Kahraman", "integrated",
        f"{RUNS[0] / 1e6:g} to {RUNS[1] / 1e6:g} MPa, roughness to {SMOOTH * 1e6:g} µm (from memory); one gear oil, 75W-90",
    ),
    "benedict_kelley": Model("Benedict and Kelley", "integrated", "μ from 0.01 to 0.2 (held there)"),
}  # fmt: skip


@formula("P_max/P_min", "definition: the largest loss of all models over the smallest")
def spread(P_max: Watt, P_min: Watt) -> Number:
    return P_max / P_min


def spread_of(losses: list[Watt]) -> Number | None:
    """None where a model gives no loss at all."""
    return spread(P_max=max(losses), P_min=min(losses)) if min(losses) > 0 else None


def table(
    key: str, title: str, by_regime: MeshLoss, source: MeshLoss, H_V: Number, published: dict[str, Regression | None]
) -> Table:  # fmt: skip
    """`key` of the mesh; the own models integrate with the local film."""
    rigid = by_regime.lead_at_pitch < 1
    rows: list[tuple[str | float | None, ...]] = [
        ("by regime, integrated", by_regime.loss, by_regime.friction_mean, by_regime.loss_factor, "any load; rolling an upper bound", ""),
        ("EHL film, integrated (source)", source.loss, source.friction_mean, source.loss_factor, "EHL film thicker than a rigid one",
         "outside: a rigid isoviscous film governs" if rigid else ""),
    ]  # fmt: skip
    for name, model in MODELS.items():
        one, named = published[name], f"{model.authors} {model.how}"
        if one is None:
            rows.append((named, None, None, None, model.range, "runs away: not shown"))
            continue
        H = H_V if model.how == "× Ohlendorf" else by_regime.loss_factor
        rows.append((named, one.loss, one.friction_mean, H, model.range, f"outside: {one.outside}" if one.outside else ""))
    columns = (("Model", ""), ("P_VZ", "W"), ("μ_m", ""), ("H", ""), ("Range", ""), ("Here", ""))
    note = "μ_m is that of sliding; the first line also counts rolling in its loss. Only the first two know the local film."
    return Table(
        f"models_{key}",
        f"Mesh {title}: models of friction side by side",
        columns,
        tuple(rows),
        note,
        covers=tuple(f"friction.{key}.{name}" for name in published),
    )
