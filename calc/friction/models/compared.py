# SPDX-License-Identifier: Apache-2.0
"""The loss of a mesh by all models side by side, each with its range; how far they spread."""

from functools import reduce

from ...sheet.formula import formula
from ...sheet.functions import largest, smallest
from ...sheet.record import record
from ...sheet.step import Table
from ...sheet.text import Amount, Text
from ...sheet.units import Number, Watt
from ..mesh.loss import MeshLoss
from .regressions import FASTEST, LOWEST_LINE_LOAD, RUNS, SMOOTH, Regression

TESTS = Text(
    "line load from {lowest_line_load} N/mm (held there below), sum of speeds from 1 m/s, pitch line to {fastest} m/s",
    lowest_line_load=Amount(LOWEST_LINE_LOAD / 1000.0, form="g"),
    fastest=Amount(FASTEST, form="g"),
)
INTEGRATED, OHLENDORF = Text("integrated"), Text("× Ohlendorf")


@record
class Model:
    """A published model: who made it, how its loss is found here, and where it holds."""

    authors: Text
    how: Text
    range: Text


MODELS = {
    "schlenk": Model(Text("Schlenk"), OHLENDORF, TESTS),
    "niemann": Model(Text("Niemann and Winter, Michaelis"), OHLENDORF, TESTS),
    "xu_kahraman": Model(
        Text("Xu and Kahraman"), INTEGRATED,
        Text("{runs} to {runs2} MPa, roughness to {smooth} µm (from memory); one gear oil, 75W-90",
            runs=Amount(RUNS[0] / 1000000.0, form="g"), runs2=Amount(RUNS[1] / 1000000.0, form="g"),
            smooth=Amount(SMOOTH * 1000000.0, form="g")),
    ),
    "benedict_kelley": Model(Text("Benedict and Kelley"), INTEGRATED, Text("μ from 0.01 to 0.2 (held there)")),
}  # fmt: skip


@formula("P_max/P_min", "definition: the largest loss of all models over the smallest")
def spread(P_max: Watt, P_min: Watt) -> Number:
    return P_max / P_min


@formula("P_>/P_<", "definition: the larger of two losses over the smaller")
def factor_apart(P_1: Watt, P_2: Watt) -> Number:
    return largest(P_1 / P_2, P_2 / P_1)


def spread_of(losses: list[Watt]) -> Number | None:
    """None where a model gives no loss at all."""
    most, least = reduce(largest, losses), reduce(smallest, losses)
    return spread(P_max=most, P_min=least) if least > 0 else None


def table(
    key: str, title: str, by_regime: MeshLoss, source: MeshLoss, H_V: Number, published: dict[str, Regression | None]
) -> Table:  # fmt: skip
    """`key` of the mesh; the own models integrate with the local film."""
    rigid = by_regime.lead_at_pitch < 1
    rows: list[tuple[str | float | None, ...]] = [
        (Text("by regime, integrated"), by_regime.loss, by_regime.friction_mean, by_regime.loss_factor,
            Text("any load; rolling an upper bound"), ""),
        (Text("EHL film, integrated (source)"), source.loss, source.friction_mean, source.loss_factor,
            Text("EHL film thicker than a rigid one"),
         Text("outside: a rigid isoviscous film governs") if rigid else ""),
    ]  # fmt: skip
    for name, model in MODELS.items():
        one, named = published[name], Text("{authors} {how}", authors=model.authors, how=model.how)
        if one is None:
            rows.append((named, None, None, None, model.range, Text("runs away: not shown")))
            continue
        H = H_V if model.how is OHLENDORF else by_regime.loss_factor
        rows.append(
            (named, one.loss, one.friction_mean, H, model.range, Text("outside: {outside}", outside=one.outside) if one.outside else "")
        )
    columns = ((Text("Model"), ""), (Text("P_VZ"), "W"), (Text("μ_m"), ""), (Text("H"), ""), (Text("Range"), ""), (Text("Here"), ""))
    note = Text("μ_m is that of sliding; the first line also counts rolling in its loss. Only the first two know the local film.")
    return Table(
        f"models_{key}",
        Text("Mesh {title}: models of friction side by side", title=title),
        columns,
        tuple(rows),
        note,
        covers=tuple(f"friction.{key}.{name}" for name in published),
    )
