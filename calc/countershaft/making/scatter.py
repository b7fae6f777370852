# SPDX-License-Identifier: Apache-2.0
"""What production makes of the drawing: many shafts by chance, before and after their calibration by drilling.

Each eccentric mass has its own normal deviation of mass, radius, angle and position; the whole shaft has one of its
timing.  Timing is an error of mounting: no balancing machine sees it and no drilling mends it.  A shaft is measured as
on a balancing machine, by the two unbalances in the planes of the outer bearings that separate it from the one that
balances the engine.  If one of them is above what is permitted, the shaft is drilled: radially, into the masses as the
drawing places them, each hole as deep as it helps, so that the worse plane (over what it is permitted) comes as low as
the holes allow.  That may cost a shaft that is too light some of its couple."""

import math
from collections.abc import Iterator
from random import Random

import numpy as np

from ...sheet.arrays import Array, ComplexArray, IndexArray
from ...sheet.check import Check, CheckRule
from ...sheet.formula import formula
from ...sheet.functions import modulus, rss, sqrt
from ...sheet.linked_array import column
from ...sheet.quantity import dotted, result, value
from ...sheet.record import record, replace
from ...sheet.shown import Shown
from ...sheet.step import Curve, Series, Table
from ...sheet.text import Amount, Text
from ...sheet.units import (
    Kilogram,
    KilogramMetre,
    Metre,
    Newton,
    NewtonMetre,
    NewtonMetres,
    Number,
    PhasorNewton,
    PhasorNewtonMetre,
    Radian,
    RadPerSecond,
)
from ...sheet.value import about, based_on, untraced
from .. import formulas as f
from ..inputs import EccentricMass, Extra, Holes, Scatter, ShaftInputs
from ..rows import SHAFT
from .unbalance import HolesResult

BLOCK = 10_000  # shafts at once: enough that numpy's calls cost little, few enough for the processor's cache
SWEEPS = 12  # of the search for the drilled depths with both planes weighed alike, and then with ten other weights
PROPAGATION = Text("mathematics, first-order propagation of independent errors")
NAMES = ("mass", "radius", "angle", "z")
PARTS = {
    "mass": Text("mass"),
    "radius": Text("radius"),
    "angle": Text("angle"),
    "position": Text("position"),
    "timing": Text("timing"),
}
PERCENTILES = {"median": 0.5, "95": 0.95, "99": 0.99, "largest": 1.0}
SHARES = ("share_within", "share_drilled_within", "share_too_light", "share_beyond_drilling")
SHOWN = 201  # points of the curve


@formula(
    "σ_C,m",
    Text("{propagation}: mass", propagation=PROPAGATION),
    names=f.MASSES | {"s": "s_m", "omega": "ω_S"},
    meanings={"z": "Places of the eccentric masses"},
)
def couple_error_by_mass(omega: RadPerSecond, e: Metre, z: Metre, s: Kilogram) -> NewtonMetre:
    return omega**2 * rss(e * z) * s


@formula(
    "σ_C,e",
    Text("{propagation}: radius", propagation=PROPAGATION),
    names=f.MASSES | {"s": "s_e", "omega": "ω_S"},
    meanings={"z": "Places of the eccentric masses"},
)
def couple_error_by_radius(omega: RadPerSecond, m: Kilogram, z: Metre, s: Metre) -> NewtonMetre:
    return omega**2 * rss(m * z) * s


@formula(
    "σ_C,γ",
    Text("{propagation}: angle", propagation=PROPAGATION),
    names=f.MASSES | {"s": "s_γ", "omega": "ω_S"},
    meanings={"z": "Places of the eccentric masses"},
)
def couple_error_by_angle(omega: RadPerSecond, m: Kilogram, e: Metre, z: Metre, s: Radian) -> NewtonMetre:
    return omega**2 * rss(m * e * z) * s


@formula(
    "σ_C,z", Text("{propagation}: position", propagation=PROPAGATION), names=f.MASSES | {"s": "s_z", "omega": "ω_S"}
)
def couple_error_by_position(omega: RadPerSecond, m: Kilogram, e: Metre, s: Metre) -> NewtonMetre:
    return omega**2 * rss(m * e) * s


@formula("σ_C,t", Text("{propagation}: timing", propagation=PROPAGATION), names={"s": "s_t"})
def couple_error_by_timing(C_S: PhasorNewtonMetre, s: Radian) -> NewtonMetre:
    return modulus(C_S) * s


@formula(
    "σ_C",
    Text("{propagation}: root mean square", propagation=PROPAGATION),
    names={"m": "σ_C,m", "e": "σ_C,e", "gamma": "σ_C,γ", "z": "σ_C,z", "t": "σ_C,t"},
)
def couple_error(m: NewtonMetre, e: NewtonMetre, gamma: NewtonMetre, z: NewtonMetre, t: NewtonMetre) -> NewtonMetre:
    """Length of the error vector, whatever its direction."""
    return sqrt(m**2 + e**2 + gamma**2 + z**2 + t**2)


@formula("σ_F,m", Text("{propagation}: mass", propagation=PROPAGATION), names=f.MASSES | {"s": "s_m", "omega": "ω_S"})
def force_error_by_mass(omega: RadPerSecond, e: Metre, s: Kilogram) -> Newton:
    return omega**2 * rss(e) * s


@formula("σ_F,e", Text("{propagation}: radius", propagation=PROPAGATION), names=f.MASSES | {"s": "s_e", "omega": "ω_S"})
def force_error_by_radius(omega: RadPerSecond, m: Kilogram, s: Metre) -> Newton:
    return omega**2 * rss(m) * s


@formula("σ_F,γ", Text("{propagation}: angle", propagation=PROPAGATION), names=f.MASSES | {"s": "s_γ", "omega": "ω_S"})
def force_error_by_angle(omega: RadPerSecond, m: Kilogram, e: Metre, s: Radian) -> Newton:
    return omega**2 * rss(m * e) * s


@formula("σ_F,t", Text("{propagation}: timing", propagation=PROPAGATION), names={"s": "s_t"})
def force_error_by_timing(F_S: PhasorNewton, s: Radian) -> Newton:
    return modulus(F_S) * s


@formula(
    "σ_F",
    Text("{propagation}: root mean square", propagation=PROPAGATION),
    names={"m": "σ_F,m", "e": "σ_F,e", "gamma": "σ_F,γ", "t": "σ_F,t"},
)
def force_error(m: Newton, e: Newton, gamma: Newton, t: Newton) -> Newton:
    """Length of the error vector, whatever its direction; positions along the shaft are none of a force."""
    return sqrt(m**2 + e**2 + gamma**2 + t**2)


@formula(
    "C_1,p",
    "mathematics: order statistics of the shafts tried",
    shows="the smallest couple that the share p of the shafts does not exceed",
)
def percentile(C: NewtonMetres, p: Number) -> NewtonMetre:
    """`C` in rising order."""
    return ranked(C, p)


def ranked(ordered: Array, p: float) -> float:
    """Of numbers in rising order the smallest that the share p of them does not exceed."""
    return float(ordered[max(math.ceil(p * ordered.size) - 1, 0)].item())


@result
class ScatterResult(Shown):
    """Shares are of all shafts tried; the shares within, drilled, too light and beyond drilling make one."""

    couple_error: NewtonMetre = value("Error of the couple, root mean square to first order", "N·m", "σ_C")
    couple_error_by_mass: NewtonMetre = value("by the masses", "N·m", "σ_C,m")
    couple_error_by_radius: NewtonMetre = value("by their radii", "N·m", "σ_C,e")
    couple_error_by_angle: NewtonMetre = value("by their angles", "N·m", "σ_C,γ")
    couple_error_by_position: NewtonMetre = value("by their positions", "N·m", "σ_C,z")
    couple_error_by_timing: NewtonMetre = value("by the timing", "N·m", "σ_C,t")
    force_error: Newton = value("Error of the force, root mean square to first order", "N", "σ_F")
    force_error_by_mass: Newton = value("by the masses", "N", "σ_F,m")
    force_error_by_radius: Newton = value("by their radii", "N", "σ_F,e")
    force_error_by_angle: Newton = value("by their angles", "N", "σ_F,γ")
    force_error_by_timing: Newton = value("by the timing", "N", "σ_F,t")
    residual_couple_median: NewtonMetre = value("Couple left over, median of the shafts", "N·m")
    residual_couple_95: NewtonMetre = value("Couple that 95 % of the shafts stay below", "N·m")
    residual_couple_99: NewtonMetre = value("Couple that 99 % of the shafts stay below", "N·m")
    residual_couple_largest: NewtonMetre = value("Largest couple left over", "N·m")
    share_within: Number = value("Shafts within the permitted residual unbalance as made", "%")
    share_to_drill: Number = value("Shafts beyond the permitted residual unbalance", "%")
    share_drilled_within: Number | None = value("Shafts that drilling brings within it", "%", default=None)
    share_too_light: Number | None = value(
        "Shafts too light: only added material would bring them within", "%", default=None
    )
    share_beyond_drilling: Number | None = value(
        "Shafts that neither brings within: too heavy, or at a wrong angle", "%", default=None
    )
    drilled_couple_median: NewtonMetre | None = value("Couple left over after drilling, median", "N·m", default=None)
    drilled_couple_95: NewtonMetre | None = value("Couple that 95 % stay below after drilling", "N·m", default=None)
    residual: Array  # of every shaft, in rising order
    drilled: Array | None  # the same after drilling
    impossible: int  # shafts with a mass below zero: its standard deviation is too large
    target: "Target"


@record
class Target:
    """What balances the engine, and what each bearing plane may deviate from it.

    `couple`, `force`: what a shaft at `omega` must supply, cylinder 1 at TDC; `couple_left`: modulus of the couple that
    no such shaft can take, since it turns against it."""

    omega: RadPerSecond
    couple: PhasorNewtonMetre
    force: PhasorNewton
    couple_left: NewtonMetre
    z_f: Metre
    z_r: Metre
    permitted_front: KilogramMetre
    permitted_rear: KilogramMetre

    def mirrored(self) -> "Target":
        """That of a mirror image."""
        couple, force = (based_on(vector.conjugate(), vector) for vector in (self.couple, self.force))
        return replace(self, couple=couple, force=force)

    def residual(self, couple: ComplexArray, timing: ComplexArray) -> Array:
        """The couple that is left over, largest over a turn: the vector that turns against the shaft stays and comes
        into line with it."""
        return self.couple_left + np.abs(couple * timing - self.couple)

    def deviation(self, force: ComplexArray, couple: ComplexArray) -> ComplexArray:
        """The unbalance in the front and the rear plane (first axis) that separates a shaft from what balances the
        engine, over what is permitted there: above 1 in either it is out of tolerance."""
        rear = (couple - self.couple - self.z_f * (force - self.force)) / (self.z_r - self.z_f)
        front = force - self.force - rear
        return np.stack([front / self.permitted_front, rear / self.permitted_rear]) / self.omega**2

    def influence(self, masses: tuple[EccentricMass, ...]) -> ComplexArray:
        """What a unit of unbalance at each mass (second axis) is in the two planes, over what is permitted there."""
        z, gamma = (column(masses, name) for name in ("z", "angle"))
        span = self.z_r - self.z_f
        share = np.stack([(self.z_r - z) / span / self.permitted_front, (z - self.z_f) / span / self.permitted_rear])
        influence: ComplexArray = share * np.exp(1j * gamma)
        return influence


def normal(random: Random, *shape: int) -> Array:
    """Normally distributed numbers after Box & Muller 1958.  The generators of numpy cost a start-up 20 ms, a twentieth
    of a check."""
    count = math.prod(shape)
    bits = np.frombuffer(random.randbytes(8 * math.ceil(count / 2)), "<u4")
    u, v = (bits.reshape(2, -1) + 0.5) * 2.0**-32
    pairs: ComplexArray = np.sqrt(-2 * np.log(u)) * np.exp(2j * np.pi * v)
    return pairs.view(float)[:count].reshape(shape)


def sample(
    scatter: Scatter,
    masses: tuple[EccentricMass, ...],
    extras: tuple[Extra, ...],
    omega: RadPerSecond,
    random: Random,
    count: int,
) -> tuple[ComplexArray, ComplexArray, ComplexArray, int]:
    """Shafts from a generator of random numbers: force and couple before timing, the turn e^{iδ} of their timing; and
    how many of them have a mass below zero.  Extras are exact.

    The numbers are drawn whatever the deviations are, so that with one seed two designs meet the same luck.
    """
    luck = normal(random, 4, count, len(masses))
    delta = scatter.timing * normal(random, count)
    m, e, gamma, z = (column(masses, name) + getattr(scatter, name) * chance for name, chance in zip(NAMES, luck))
    impossible = int((m < 0).any(1).sum())
    if extras:
        fixed = [np.broadcast_to(column(extras, name), (count, len(extras))) for name in NAMES]
        m, e, gamma, z = (np.hstack(pair) for pair in zip((m, e, gamma, z), fixed))
    force = f.shaft_force(omega=omega, m=m, e=e, gamma=gamma)
    couple = f.shaft_couple(omega=omega, m=m, e=e, z=z, gamma=gamma)
    return force, couple, np.exp(1j * delta), impossible


def worse(deviation: ComplexArray) -> Array:
    """The worse of the two planes, over what is permitted there."""
    larger: Array = np.abs(deviation).max(0)
    return larger


def drill(deviation: ComplexArray, influence: ComplexArray, least: float, most: float) -> Array:
    """The unbalance to take off each mass (first axis) of every shaft, between `least` and `most`, for the smallest
    worse plane.

    The squares of both planes are first weighed alike and minimised mass by mass; then the weight of the worse plane is
    raised, by halved steps, which leads to the smallest maximum (its dual is concave in the weight).  The best of these
    tries is kept, and taking off nothing is one of them: drilling never makes a shaft worse."""
    masses, shafts = influence.shape[1], deviation.shape[1]
    # |left|² of plane j = |deviation|² − 2·pull·x + x·own·x
    matrix = np.einsum("ji,jk->jik", influence.conj(), influence).real
    pull = np.einsum("ji,js->jis", influence.conj(), deviation).real
    square = np.abs(deviation) ** 2
    x, best, lowest = np.zeros((masses, shafts)), np.zeros((masses, shafts)), square.max(0)
    weight, step = np.full(shafts, 0.5), 0.25  # of the front plane
    for sweep in range(1, 2 * SWEEPS + 1):
        pulls = pull[1] + weight * (pull[0] - pull[1])
        for i in range(masses):
            back, more = matrix[1, i], matrix[0, i] - matrix[1, i]
            wanted = x[i] + (pulls[i] - back @ x - weight * (more @ x)) / (back[i] + weight * more[i])
            x[i] = np.minimum(np.maximum(wanted, least), most)
        if sweep >= SWEEPS:
            front, rear = (square[j] + ((matrix[j] @ x - 2 * pull[j]) * x).sum(0) for j in (0, 1))
            now = np.maximum(front, rear)
            best, lowest = np.where(now < lowest, x, best), np.minimum(now, lowest)
            weight, step = weight + step * np.sign(front - rear), step / 2
    return best


def calibrated(deviation: ComplexArray, influence: ComplexArray, most: KilogramMetre) -> tuple[Array, IndexArray]:
    """What is drilled off each mass (first axis) of every shaft, nothing of those that are within; and of those that
    are not how many drilling mends, how many are too light, how many beyond it."""
    out = worse(deviation) > 1
    taken = np.zeros((influence.shape[1], out.size))
    deviation = deviation[:, out]
    taken[:, out] = drilled_off = drill(deviation, influence, 0.0, most)
    mended = worse(deviation - joint(influence, drilled_off)) <= 1
    # beyond drilling, and a mass is not drilled at all
    bare = deviation[:, ~mended & (drilled_off == 0).any(0)]
    light = int((worse(bare - joint(influence, drill(bare, influence, -math.inf, most))) <= 1).sum())
    return taken, np.array([mended.sum(), light, (~mended).sum() - light])


def scattered(
    scatter: Scatter,
    masses: tuple[EccentricMass, ...],
    extras: tuple[Extra, ...],
    target: Target,
    holes: HolesResult | None,
) -> ScatterResult:
    """Many shafts by chance, what they leave over and how many drilling mends."""
    with about(Text("scatter of production")):
        parts = errors(scatter, masses, extras, target.omega)
    random, influence = Random(scatter.seed), target.influence(masses)
    arms = column(masses, "z") * np.exp(1j * column(masses, "angle"))
    before, after, counts, impossible = [], [], np.zeros(4, int), 0  # counts: in the order of SHARES
    for start in range(0, scatter.shafts, BLOCK):
        with untraced():
            force, couple, timing, odd = sample(
                scatter, masses, extras, target.omega, random, min(BLOCK, scatter.shafts - start)
            )
            impossible += odd
            before.append(target.residual(couple, timing))
            deviation = target.deviation(force, couple)
            counts[0] += int((~(worse(deviation) > 1)).sum())
            if holes is None:
                continue
            taken, after_drilling = calibrated(deviation, influence, holes.hole_unbalance_of_mass)
            counts[1:] += after_drilling
            after.append(target.residual(couple - target.omega**2 * joint(arms, taken), timing))
    of = (scatter, masses, extras, target)
    within, *others = (based_on(int(count) / scatter.shafts, *of, holes) for count in counts)
    residual = based_on(np.sort(np.concatenate(before)), *of)
    drilled = based_on(np.sort(np.concatenate(after)), *of, holes) if after else None
    parts |= _percentiles("residual_couple", Text("as made"), residual, tuple(PERCENTILES))
    parts |= dict(zip(SHARES, (within, *others) if holes is not None else (within,)))
    if drilled is not None:
        parts |= _percentiles("drilled_couple", Text("after drilling"), drilled, ("median", "95"))
    to_drill = based_on(1 - within, within)
    return ScatterResult(
        **parts, share_to_drill=to_drill, residual=residual, drilled=drilled, impossible=impossible, target=target
    )


def joint(influence: ComplexArray, taken: Array) -> ComplexArray:
    """What is taken off all masses together.  Not by `@`: for so few masses a BLAS call costs more than it saves."""
    together: ComplexArray = np.einsum("...i,is->...s", influence, taken)
    return together


def errors(
    scatter: Scatter, masses: tuple[EccentricMass, ...], extras: tuple[Extra, ...], omega: RadPerSecond
) -> dict[str, float]:
    """The errors of couple and force to first order, in all and by what they come of."""
    m, e, _, z = (column(masses, name) for name in NAMES)
    whole = {symbol: column((*masses, *extras), name) for symbol, name in zip(("m", "e", "gamma", "z"), NAMES)}
    turning = {symbol: whole[symbol] for symbol in ("m", "e", "gamma")}
    couple = dict(
        mass=couple_error_by_mass(omega=omega, e=e, z=z, s=scatter.mass),
        radius=couple_error_by_radius(omega=omega, m=m, z=z, s=scatter.radius),
        angle=couple_error_by_angle(omega=omega, m=m, e=e, z=z, s=scatter.angle),
        position=couple_error_by_position(omega=omega, m=m, e=e, s=scatter.z),
        timing=couple_error_by_timing(C_S=f.shaft_couple(omega=omega, **whole), s=scatter.timing),
    )
    force = dict(
        mass=force_error_by_mass(omega=omega, e=e, s=scatter.mass),
        radius=force_error_by_radius(omega=omega, m=m, s=scatter.radius),
        angle=force_error_by_angle(omega=omega, m=m, e=e, s=scatter.angle),
        timing=force_error_by_timing(F_S=f.shaft_force(omega=omega, **turning), s=scatter.timing),
    )
    of_couple = couple_error(
        m=couple["mass"], e=couple["radius"], gamma=couple["angle"], z=couple["position"], t=couple["timing"]
    )
    of_force = force_error(m=force["mass"], e=force["radius"], gamma=force["angle"], t=force["timing"])
    return (
        {"couple_error": of_couple, "force_error": of_force}
        | {f"couple_error_by_{word}": part for word, part in couple.items()}
        | {f"force_error_by_{word}": part for word, part in force.items()}
    )


def _percentiles(name: str, when: str, ordered: Array, words: tuple[str, ...]) -> dict[str, float]:
    couples = {}
    for word in words:
        p = PERCENTILES[word]
        with about(Text("shafts {when}, p = {percentiles}", when=when, percentiles=Amount(p, form="g"))):
            couples[f"{name}_{word}"] = percentile(C=ordered, p=p)
    return couples


SCATTER_RESIDUAL = CheckRule(
    "countershaft.scatter.residual",
    "caution",
    "The shaft of the drawing holds, some of those that are made do not.",
    Text("Couple that 95 % of the shafts stay below"),
    "<=",
    "N·m",
    Text("rule of this program: 95 % of the shafts within the limit of the drawing"),
    Text("The table of the couple's error says which deviation counts most."),
    moved_by=(
        dotted(SHAFT, ShaftInputs.scatter),
        dotted(SHAFT, ShaftInputs.holes, Holes.depth),
    ),
)


def residual_check(spread: ScatterResult, limit: NewtonMetre) -> Check:
    """`limit`: what a shaft of the drawing may leave over."""
    # what leaves the factory
    couple = spread.residual_couple_95 if spread.drilled_couple_95 is None else spread.drilled_couple_95
    return SCATTER_RESIDUAL(couple, limit)


def curves(spread: ScatterResult, limit: NewtonMetre) -> tuple[Curve, ...]:
    """The cumulative distribution of the couple that is left over, lying: couple over the share of shafts that stay
    below it."""
    share = np.linspace(0, 1, SHOWN)
    rows = ((Text("as made"), spread.residual), (Text("after drilling"), spread.drilled))
    series = tuple(
        Series(label, 100 * share, np.array([percentile.function(C=ordered, p=p) for p in share]))
        for label, ordered in rows
        if ordered is not None
    )
    words = (
        Text("Couple left over, as production scatters"),
        Text("share of shafts that stay below, %"),
        Text("couple, N·m"),
    )
    return (Curve("scatter", *words, series, limits=((Text("limit"), limit),)),)


def tables(spread: ScatterResult) -> tuple[Table, ...]:
    """What the error of the couple comes of."""
    whole = spread.couple_error
    parts = {word: getattr(spread, f"couple_error_by_{name}") for name, word in PARTS.items()}
    rows = tuple((word, error, 100 * (error / whole) ** 2 if whole else None) for word, error in parts.items())
    columns = (Text("of"), ""), (Text("error"), "N·m"), (Text("share"), Text("%"))
    note = Text("Root mean squares; their squares add up.")
    return (Table("couple_error", Text("What the error of the couple comes of"), columns, rows, note),)


def notes(scatter: Scatter, spread: ScatterResult) -> Iterator[Text]:
    yield Text(
        "Scatter: {shafts} shafts by chance (seed {seed}), normal and independent deviations; further elements are "
        "exact.",
        shafts=scatter.shafts,
        seed=scatter.seed,
    )
    yield Text("Scatter: timing is left out of the shaft's balance; it counts in the couple that is left over.")
    if spread.drilled is not None:
        yield Text("Scatter: the balancing machine is taken as exact, and each hole is drilled as deep as it helps.")
    if spread.impossible:
        count = spread.impossible
        yield Text(
            "Scatter: {impossible} shafts have a mass below zero: its standard deviation is too large.",
            impossible=count,
        )
