# SPDX-License-Identifier: Apache-2.0
"""The figures of this step, without and with the counter-shaft: loci with their turning vectors, bars over the orders, a whole turn."""

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np

from ..sheet.number import SUBSCRIPTS, short
from ..sheet.step import Curve, Series, Table, Turning
from .orders import DUST

if TYPE_CHECKING:
    from .solve import ImbalanceResult

DRAWN = 5e-3  # of one cylinder's m·r·ω²: less is not worth a figure
WITHOUT = "without the counter-shaft"
Shaft = tuple[complex, complex]  # its force and couple, cylinder 1 at TDC; they turn backward
KINDS = (("couple", "couple", "C", "N·m", 2), ("force", "force", "F", "N", 0))


def pictures(result: "ImbalanceResult", shaft: Shaft | None = None) -> tuple[Curve, ...]:
    """All figures.  Without a shaft of the design an ideal one stands for it: it takes all of first order that turns backward."""
    vectors = {int(name.rpartition("_")[2]): order.vectors for name, order in result.orders.items()}
    with_ = "with the counter-shaft" if shaft is not None else "with an ideal counter-shaft"
    supplied = shaft if shaft is not None else (-vectors[1][1], -vectors[1][3])
    after = {**vectors, 1: (vectors[1][0], vectors[1][1] + supplied[0], vectors[1][2], vectors[1][3] + supplied[1])}
    made: list[Curve] = []
    for kind, word, symbol, unit, at in KINDS:
        one = result.one_couple if kind == "couple" else result.one_force
        if max(abs(v) for pair in (vectors, after) for order in pair.values() for v in order[at : at + 2]) <= DRAWN * one:
            continue
        both = ((WITHOUT, vectors), (with_, after)) if any(abs(v) > DUST * one for v in vectors[1][at : at + 2]) else (("", vectors),)
        variants = tuple(name for name, _ in both) if len(both) > 1 else ()
        made += [
            _locus(word, symbol, unit, at, both, variants, supplied[at // 2], one),
            _bars(word, symbol, unit, at, both, variants),
            _turn(word, symbol, unit, at, both, variants),
        ]
    if result.required_couple > DRAWN * result.one_couple:
        made.append(_mistiming("couple", "C, N·m", result.required_couple))
    if result.required_force is not None and result.required_force > DRAWN * result.one_force:
        made.append(_mistiming("force", "F, N", result.required_force))
    return tuple(made)


def _locus(word: str, symbol: str, unit: str, at: int, both: Any, variants: tuple[str, ...], supplied: complex, one: float) -> Curve:
    """The path of the lowest order that there is and of all orders together, and the vectors that draw the first of these."""
    before = both[0][1]
    shown = next((n for n in sorted(before) if max(abs(v) for v in before[n][at : at + 2]) > DUST * one), 1)
    index = str(shown).translate(SUBSCRIPTS)
    degrees = np.arange(0, 361, 3.0)
    theta = np.radians(degrees)
    series, chains = [], []
    for variant, vectors in both:
        path, everything = _path(vectors, (shown,), at, theta), _path(vectors, vectors, at, theta)
        series.append(Series(f"order {shown}", path.imag, path.real, variant))
        series.append(Series("all orders", everything.imag, everything.real, variant))
        forward, backward = before[shown][at], before[shown][at + 1]
        parts = [(f"{symbol}{index}⁺ forward", forward, shown), (f"{symbol}{index}⁻ backward", backward, -shown)]
        if variant and variant != WITHOUT:
            parts.append(("counter-shaft", supplied, -1))
        if parts := [part for part in parts if abs(part[1]) > DUST * one]:
            chains.append(Turning(tuple(p[0] for p in parts), tuple(p[1] for p in parts), tuple(p[2] for p in parts), variant))
    return Curve(
        "locus" if word == "couple" else "locus_force", f"Locus of the {word}", f"horizontal, {unit}", f"vertical, {unit}",
        tuple(series), equal=True, variants=variants, turning=tuple(chains), along=("crank angle, °", degrees),
    )  # fmt: skip


def _path(vectors: Any, orders: Iterable[int], at: int, theta: Any) -> Any:
    """The sum of the turning vectors of some orders at crank angles."""
    path: Any = np.zeros(theta.size, complex)
    for n in orders:
        path += vectors[n][at] * np.exp(1j * n * theta) + vectors[n][at + 1] * np.exp(-1j * n * theta)
    return path


def _bars(word: str, symbol: str, unit: str, at: int, both: Any, variants: tuple[str, ...]) -> Curve:
    series = []
    for variant, vectors in both:
        orders = np.array(sorted(vectors), float)
        for side, label in enumerate(("forward", "backward")):
            series.append(Series(label, orders, np.array([abs(vectors[int(n)][at + side]) for n in orders]), variant))
    return Curve(
        f"orders_{word}", f"{word.capitalize()} of each order", "order", f"{symbol}, {unit}", tuple(series), bars=True, variants=variants
    )


def _turn(word: str, symbol: str, unit: str, at: int, both: Any, variants: tuple[str, ...]) -> Curve:
    degrees = np.arange(0, 361, 3.0)
    theta = np.radians(degrees)
    series = []
    for variant, vectors in both:
        everything = _path(vectors, vectors, at, theta)
        series += [Series("vertical", degrees, everything.real, variant), Series("horizontal", degrees, everything.imag, variant)]
    turn = "crank angle from TDC of cylinder 1, °"
    return Curve(
        f"{word}s", f"{word.capitalize()}s of all orders over one turn", turn, f"{symbol}, {unit}", tuple(series), variants=variants
    )


def _mistiming(word: str, axis: str, whole: float) -> Curve:
    degrees = np.arange(-20, 20.5, 0.5)
    left = whole * 2 * np.abs(np.sin(np.radians(degrees) / 2))
    title = f"First-order {word} turning backward that a mistimed counter-shaft leaves"
    return Curve(
        "mistiming" if word == "couple" else "mistiming_force", title, "mistiming of the shaft, °", axis, (Series("", degrees, left),)
    )


def remedy_table(result: "ImbalanceResult", kappa: float, shaft: Shaft | None = None) -> Table:
    """What is left of orders 1 and 2 before and after each remedy."""
    first, second = result.orders["order_1"], result.orders["order_2"]
    F_2, C_2 = second.force_peak, second.couple_peak

    def row(words: str, vectors: Any, shaft: Shaft = (0j, 0j)) -> tuple[Any, ...]:
        F = abs(vectors[0]) + abs(vectors[1] + shaft[0])
        C = abs(vectors[2]) + abs(vectors[3] + shaft[1])
        return words, "", F, C, F_2, C_2, None

    half = abs(kappa - 0.5) < 1e-12
    rows = [row("rotating masses balanced, nothing else", first.unbalanced), row(f"crank as designed (share {kappa:g})", first.vectors)]
    if shaft is not None:
        rows.append(row("the same, with the counter-shaft as designed", first.vectors, shaft))
    for name, remedy in result.remedy.items():
        if name == "crank" and half:
            continue  # the crank as designed
        needs = "; ".join(filter(None, (_needs(part) for part in remedy.shafts.values())))
        left = remedy.order_1_force, remedy.order_1_couple, remedy.order_2_force, remedy.order_2_couple
        rows.append((remedy.title, needs, *left, remedy.roll_torque if remedy.roll_torque is not None else remedy.roll_torque_at_100_mm))
    return Table(
        "remedies", "Before and after each remedy",
        (
            ("remedy", ""), ("shafts", ""), ("F order 1", "N"), ("C order 1", "N·m"), ("F order 2", "N"), ("C order 2", "N·m"),
            ("roll torque", "N·m"),
        ),
        tuple(rows),
        "Peaks over the turn. Shafts by unbalance U (force) and unbalance times arm U·Δz (couple), directions with cylinder 1 at TDC. "
        "Roll torque of a single shaft that carries a force: where its place is not given, 100 mm beside the crank.",
        covers=("imbalance.remedy.",),
    )  # fmt: skip


def _needs(part: Any) -> str:
    """One shaft in words: what it carries, and where it points."""
    words = []
    for symbol, amount, scale, unit, phase in (
        ("U", part.unbalance, 1e3, "kg·mm", part.unbalance_phase),
        ("U·Δz", part.unbalance_product, 1e6, "kg·mm²", part.unbalance_product_phase),
    ):
        if amount is not None:
            words.append(f"{symbol} {short(amount * scale)} {unit} at {short(round(np.degrees(phase), 6))}°")
    return f"{part.speed_ratio:+g}: ".replace("-", "−") + ", ".join(words) if words else ""
