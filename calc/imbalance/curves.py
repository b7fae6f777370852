# SPDX-License-Identifier: Apache-2.0
"""The figures of this step, without and with the counter-shaft: loci with their turning vectors, bars over the orders,
a whole turn."""

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from ..sheet.arrays import Array, ComplexArray
from ..sheet.number import SUBSCRIPTS
from ..sheet.step import Curve, Series, Table, Turning, axis_label
from ..sheet.text import COMMA, EMPTY, SEMICOLON, Amount, Text
from .orders import DUST
from .remedies import BalanceShaft, Vectors
from .result import ImbalanceResult

DRAWN = 5e-3  # of one cylinder's m·r·ω²: less is not worth a figure
WITHOUT = Text("without the counter-shaft")
WITHOUT_SHAFTS = Text("without the shafts")
Both = Sequence[tuple[Text, Mapping[int, Vectors]]]  # without and with the shaft, by order
Left = Mapping[int, Vectors]  # what the design's shafts leave of each order at which one turns
ONE = Text("counter-shaft"), Text("counter-shaft")
KINDS = (("couple", "C", "N·m", 2), ("force", "F", "N", 0))
LOCUS = {"couple": Text("Locus of the couple"), "force": Text("Locus of the force")}
BARS = {"couple": Text("Couple of each order"), "force": Text("Force of each order")}
TURN = {"couple": Text("Couples of all orders over one turn"), "force": Text("Forces of all orders over one turn")}
MISTIMING = {
    "couple": Text("First-order couple turning backward that a mistimed counter-shaft leaves"),
    "force": Text("First-order force turning backward that a mistimed counter-shaft leaves"),
}


def pictures(result: ImbalanceResult, left: Left | None = None, *, several: bool = False) -> tuple[Curve, ...]:
    """All figures.  Without a shaft of the design an ideal one stands for it: it takes all of first order that turns
    backward.  `several`: the design has more than one."""
    vectors = {int(name.rpartition("_")[2]): order.vectors for name, order in result.orders.items()}
    with_, without = Text("with the counter-shaft"), WITHOUT
    if left is None:
        with_, left = Text("with an ideal counter-shaft"), {1: (vectors[1][0], 0j, vectors[1][2], 0j)}
    if several:
        with_, without = Text("with the shafts"), WITHOUT_SHAFTS
    after = {**vectors, **left}
    curves: list[Curve] = []
    for kind, symbol, unit, at in KINDS:
        scale = result.one_couple if kind == "couple" else result.one_force
        if (
            max(abs(v) for pair in (vectors, after) for order in pair.values() for v in order[at : at + 2])
            <= DRAWN * scale
        ):
            continue
        both = (
            ((without, vectors), (with_, after))
            if any(abs(v) > DUST * scale for n in left for v in vectors[n][at : at + 2])
            else ((EMPTY, vectors),)
        )
        variants = tuple(name for name, _ in both) if len(both) > 1 else ()
        curves += [
            _locus(kind, symbol, unit, at, both, variants, sorted(left), scale),
            _bars(kind, symbol, unit, at, both, variants),
            _turn(kind, symbol, unit, at, both, variants),
        ]
    if result.required_couple > DRAWN * result.one_couple:
        curves.append(_mistiming("couple", Text("C, N·m"), result.required_couple))
    if result.required_force is not None and result.required_force > DRAWN * result.one_force:
        curves.append(_mistiming("force", Text("F, N"), result.required_force))
    return tuple(curves)


def _locus(
    kind: str,
    symbol: str,
    unit: str,
    at: int,
    both: Both,
    variants: tuple[Text, ...],
    taken: Sequence[int],
    scale: float,
) -> Curve:
    """The path of the lowest order that there is, of those that shafts take before others, and of all orders together;
    and the vectors that draw the first of these."""
    before = both[0][1]
    shown = next(
        (n for n in (*taken, *sorted(before)) if max(abs(v) for v in before[n][at : at + 2]) > DUST * scale), 1
    )
    index = str(shown).translate(SUBSCRIPTS)
    degrees = np.arange(0, 361, 3.0)
    theta = np.radians(degrees)
    series, chains = [], []
    for variant, vectors in both:
        path, everything = _path(vectors, (shown,), at, theta), _path(vectors, vectors, at, theta)
        series.append(Series(Text("order {shown}", shown=shown), path.imag, path.real, variant))
        series.append(Series(Text("all orders"), everything.imag, everything.real, variant))
        forward, backward = before[shown][at], before[shown][at + 1]
        parts = [
            (Text("{symbol}{index}⁺ forward", symbol=symbol, index=index), forward, shown),
            (Text("{symbol}{index}⁻ backward", symbol=symbol, index=index), backward, -shown),
        ]
        if vectors is not before:
            with_crank, against = vectors[shown][at] - forward, vectors[shown][at + 1] - backward
            names = (Text("shaft with the crank"), Text("shaft against it")) if abs(with_crank) > DUST * scale else ONE
            parts += [(names[0], with_crank, shown), (names[1], against, -shown)]
        if parts := [part for part in parts if abs(part[1]) > DUST * scale]:
            names, phasors, turns = zip(*parts)
            chains.append(Turning(names, phasors, turns, variant))
    return Curve(
        "locus" if kind == "couple" else "locus_force",
        LOCUS[kind],
        Text("horizontal, {unit}", unit=unit),
        Text("vertical, {unit}", unit=unit),
        tuple(series),
        equal=True,
        variants=variants,
        turning=tuple(chains),
        along=(Text("crank angle, °"), degrees),
    )


def _path(vectors: Mapping[int, Vectors], orders: Iterable[int], at: int, theta: Array) -> ComplexArray:
    """The sum of the turning vectors of some orders at crank angles."""
    path: ComplexArray = np.zeros(theta.size, complex)
    for n in orders:
        path += vectors[n][at] * np.exp(1j * n * theta) + vectors[n][at + 1] * np.exp(-1j * n * theta)
    return path


def _bars(kind: str, symbol: str, unit: str, at: int, both: Both, variants: tuple[Text, ...]) -> Curve:
    series = []
    for variant, vectors in both:
        orders = np.array(sorted(vectors), float)
        for side, label in enumerate((Text("forward"), Text("backward"))):
            series.append(Series(label, orders, np.array([abs(vectors[int(n)][at + side]) for n in orders]), variant))
    return Curve(
        f"orders_{kind}",
        BARS[kind],
        Text("order"),
        Text("{symbol}, {unit}", symbol=symbol, unit=unit),
        tuple(series),
        bars=True,
        variants=variants,
        short=3,
    )


def _turn(kind: str, symbol: str, unit: str, at: int, both: Both, variants: tuple[Text, ...]) -> Curve:
    degrees = np.arange(0, 361, 3.0)
    theta = np.radians(degrees)
    series = []
    for variant, vectors in both:
        everything = _path(vectors, vectors, at, theta)
        series += [
            Series(Text("vertical"), degrees, everything.real, variant),
            Series(Text("horizontal"), degrees, everything.imag, variant),
        ]
    return Curve(
        f"{kind}s",
        TURN[kind],
        Text("crank angle from TDC of cylinder 1, °"),
        Text("{symbol}, {unit}", symbol=symbol, unit=unit),
        tuple(series),
        variants=variants,
        short=1 if kind == "couple" else 2,
    )


def _mistiming(kind: str, axis: Text, whole: float) -> Curve:
    degrees = np.arange(-20, 20.5, 0.5)
    left = whole * 2 * np.abs(np.sin(np.radians(degrees) / 2))
    return Curve(
        "mistiming" if kind == "couple" else "mistiming_force",
        MISTIMING[kind],
        axis_label("mistiming of the shaft", "°"),
        axis,
        (Series(EMPTY, degrees, left),),
    )


def remedy_table(
    result: ImbalanceResult, kappa: float, rho: float = 1.0, left: Left | None = None, *, several: bool = False
) -> Table:
    """What is left of orders 1 and 2 before and after each remedy; `rho`: the share of the rotating masses that is
    balanced; `left`: what the shafts of the design leave, `several` of them or one."""
    first, second = result.orders["order_1"], result.orders["order_2"]

    def row(words: Text, *orders: Vectors) -> tuple[str | float | None, ...]:
        peaks = [abs(v[at]) + abs(v[at + 1]) for v in orders for at in (0, 2)]
        return words, "", *peaks, None

    half = abs(kappa - 0.5) < 1e-12
    rows = [
        row(
            Text("rotating masses balanced, nothing else")
            if abs(rho - 1) < 1e-9
            else Text("rotating masses as designed (share {rho}), nothing else", rho=Amount(rho, form="g")),
            first.unbalanced,
            second.vectors,
        ),
        row(Text("crank as designed (share {kappa})", kappa=Amount(kappa, form="g")), first.vectors, second.vectors),
    ]
    if left is not None:
        same = Text("the same, with the counter-shaft as designed")
        same = Text("the same, with the shafts as designed") if several else same
        rows.append(row(same, left.get(1, first.vectors), left.get(2, second.vectors)))
    for name, remedy in result.remedy.items():
        if name == "crank" and half:
            continue  # the crank as designed
        needs = SEMICOLON.join(filter(None, (_needs(part) for part in remedy.shafts.values())))
        peaks = remedy.order_1_force, remedy.order_1_couple, remedy.order_2_force, remedy.order_2_couple
        roll = remedy.roll_torque if remedy.roll_torque is not None else remedy.roll_torque_at_100_mm
        rows.append((remedy.title, needs, *peaks, roll))
    return Table(
        "remedies",
        Text("Before and after each remedy"),
        (
            (Text("remedy"), ""),
            (Text("shafts"), ""),
            (Text("F order 1"), "N"),
            (Text("C order 1"), "N·m"),
            (Text("F order 2"), "N"),
            (Text("C order 2"), "N·m"),
            (Text("roll torque"), "N·m"),
        ),
        tuple(rows),
        Text(
            "Peaks over the turn. Shafts by unbalance U (force) and unbalance times arm U·Δz (couple), directions "
            "with cylinder 1 at TDC. "
            "Roll torque of a single shaft that carries a force: where its place is not given, 100 mm beside the crank."
        ),
        covers=("imbalance.remedy.",),
    )


def _needs(part: BalanceShaft) -> Text:
    """One shaft in words: what it carries, and where it points."""
    words = []
    for symbol, amount, scale, unit, phase in (
        ("U", part.unbalance, 1e3, "kg·mm", part.unbalance_phase),
        ("U·Δz", part.unbalance_product, 1e6, "kg·mm²", part.unbalance_product_phase),
    ):
        if amount is not None and phase is not None:
            words.append(
                Text(
                    "{symbol} {amount} at {phase}",
                    symbol=symbol,
                    amount=Amount(amount * scale, unit),
                    phase=Amount(round(np.degrees(phase), 6), "°"),
                )
            )
    return (
        Text("{speed}: {what}", speed=Amount(part.speed_ratio, form="+g"), what=COMMA.join(words)) if words else EMPTY
    )
