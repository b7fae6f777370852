# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="no-any-return"
"""From what a bearing carries to the load that its rating is compared with.

F_1 turns with the shaft and stands on the inner ring, F_2 stands in space.  ISO 281 rates a load that turns over the
inner ring: the ring factor V says what it costs that the larger one stands on it.  Bearings as floats or as columns,
duty rows along the last axis."""

from collections.abc import Sequence
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from ...library.table_file import TableRow, house_table
from ...sheet.arrays import Array
from ...sheet.formula import formula
from ...sheet.functions import largest, power, single_or_many, smallest
from ...sheet.text import Text
from ...sheet.units import Newton, Number
from .geometry import Inside, gamma_of
from .ratings import ISO_RACES, Ratings, counted_grooves, race_ratio_of_balls, race_ratio_of_rollers
from .sizes import FILE, BearingSize
from .zone import EXPONENTS, narrowest, radial_integral, standing_integral, turning_integral

NOTHING: Newton = 1e-9  # a load that no bearing feels, in place of none
TERMS = 2000
SMALLEST = 1e-12  # term of the series
HALF = 0.5  # ε without clearance
PALMGREN = Text("Palmgren 1957: mean of a load that turns, with one that stands, by the power p")

# --- both loads together


@formula(
    "ξ",
    "definition: the smaller of both loads over the larger",
    meanings={"F_1": "Load that stands still", "F_2": "Load that turns with the shaft"},
)
def load_ratio(F_1: Newton, F_2: Newton) -> Number:
    return smallest(F_1, F_2) / largest(largest(F_1, F_2), NOTHING)


@formula(
    "Σ_p",
    "mathematics: mean of |1 + ξ·e^{iθ}|^p over a turn",
    shows="Σ_k binom(p/2, k)²·ξ^{2k}, to a term of 10⁻¹², no more than 2000 terms",
)
def mean_power(xi: Number, p: Number) -> Number:
    """>>> mean_power(xi=1.0, p=2.0)
    2.0
    """
    square = np.asarray(np.square(xi))
    c, needed_from = _squares(float(p))
    terms = 2 + int(np.searchsorted(needed_from[:-1], np.nanmax(square, initial=0.0)))
    powers = np.empty((*square.shape, terms))
    powers[...], powers[..., 0] = square[..., None], 1.0
    return single_or_many(np.asarray(np.multiply.accumulate(powers, axis=-1) @ c[:terms]))


@cache
def _squares(p: float) -> tuple[Array, Array]:
    """binom(p/2, k)² for every k of the series; and the ξ² from which the term behind each is still needed."""
    k = np.arange(1, TERMS)
    c = np.cumprod((p / 2 - k + 1) / k) ** 2
    with np.errstate(divide="ignore"):
        needed_from = (SMALLEST / c) ** (1 / k)
    return np.concatenate([[1.0], c]), np.minimum.accumulate(needed_from[::-1])[::-1]


@formula(
    "F_m",
    PALMGREN,
    names={"Sigma": "Σ_p", "p": "p_L"},
    meanings={
        "p": "Exponent of the life over the load",
        "F_1": "Load that stands still",
        "F_2": "Load that turns with the shaft",
    },
)
def mean_load(F_1: Newton, F_2: Newton, Sigma: Number, p: Number) -> Newton:
    return largest(F_1, F_2) * power(Sigma, 1 / p)


@formula(
    "F̄",
    "definition: mean of a load that turns, with one that stands; friction follows it",
    names={"Sigma": "Σ_1"},
    meanings={"F_1": "Load that stands still", "F_2": "Load that turns with the shaft"},
)
def friction_load(F_1: Newton, F_2: Newton, Sigma: Number) -> Newton:
    return largest(F_1, F_2) * Sigma


def means_of(F_1: Any, F_2: Any, p: float) -> tuple[Any, Any]:
    """F_m of both loads, exponent p, and F̄."""
    xi = load_ratio(F_1=F_1, F_2=F_2)
    F_m = mean_load(F_1=F_1, F_2=F_2, Sigma=mean_power(xi=xi, p=p), p=p)
    return F_m, friction_load(F_1=F_1, F_2=F_2, Sigma=mean_power(xi=xi, p=1.0))


def mean_of(F_1: Any, F_2: Any, p: float) -> Any:
    """F_m of both loads, exponent p."""
    return mean_load(F_1=F_1, F_2=F_2, Sigma=mean_power(xi=load_ratio(F_1=F_1, F_2=F_2), p=p), p=p)


def friction_mean_of(F_1: Any, F_2: Any) -> Any:
    """F̄ of both loads."""
    return friction_load(F_1=F_1, F_2=F_2, Sigma=mean_power(xi=load_ratio(F_1=F_1, F_2=F_2), p=1.0))


# --- how it spreads over the races


@formula(
    "q_i",
    Text("{iso}: balls, load of the inner race Q_ci over C", iso=ISO_RACES),
    names={"X": "X_Q"},
    meanings={"Z": "Number of rolling elements"},
)
def inner_race_of_balls(X: Number, Z: Number) -> Number:
    return (1 + X ** (10 / 3)) ** 0.3 / (0.407 * Z)


@formula(
    "q_e",
    Text("{iso}: balls, load of the outer race Q_ce over C", iso=ISO_RACES),
    names={"X": "X_Q"},
    meanings={"Z": "Number of rolling elements"},
)
def outer_race_of_balls(X: Number, Z: Number) -> Number:
    return (1 + X ** (-10 / 3)) ** 0.3 / (0.389 * Z)


@formula("q_i", Text("{iso}: rollers, load of the inner race Q_ci over C", iso=ISO_RACES), names={"X": "X_Q"})
def inner_race_of_rollers(X: Number, Z: Number) -> Number:
    return (1 + X**4.5) ** (2 / 9) / (0.378 * Z)


@formula("q_e", Text("{iso}: rollers, load of the outer race Q_ce over C", iso=ISO_RACES), names={"X": "X_Q"})
def outer_race_of_rollers(X: Number, Z: Number) -> Number:
    return (1 + X**-4.5) ** (2 / 9) / (0.364 * Z)


@formula("Z_J", "statics: elements in the load's direction, Z·J_r; no less than one, but for preload", shows="Z·J_r(ε)")
def carrying(Z: Number, J_r: Number, preloaded: bool) -> Number:
    held = np.where(preloaded, Z * J_r, np.maximum(Z * J_r, 1.0))
    return single_or_many(np.asarray(held))


@formula(
    "P_ref/F",
    Text("{iso}: equivalent load of both races", iso=ISO_RACES),
    names={"u": "u_Q"},
    meanings={"u": "Exponent of the loads of both races"},
)
def reference_share(Z_J: Number, J_i: Number, q_i: Number, J_e: Number, q_e: Number, u: Number) -> Number:
    return power(power(J_i / (Z_J * q_i), u) + power(J_e / (Z_J * q_e), u), 1 / u)


@formula(
    "V",
    Text("{iso}: the load stands on the inner ring, over it turns there; no clearance", iso=ISO_RACES),
    names={"P_s": "P_ref,s/F", "P_t": "P_ref,t/F"},
)
def ring_factor(P_s: Number, P_t: Number) -> Number:
    return P_s / P_t


@formula(
    "P_ref/P_ref,0",
    Text("{iso}: of the zone over that without clearance", iso=ISO_RACES),
    names={"P_1": "P_ref(ε)/F", "P_2": "P_ref(½)/F"},
)
def zone_ratio(P_1: Number, P_2: Number) -> Number:
    return P_1 / P_2


class Races(NamedTuple):
    """What one element's races bear in a bearing: Q_c over C of both.

    `V`, `still`, `turns`: its ring factor, and P_ref over F without clearance where the load stands on the inner ring
    and where it turns over it; None until `races_of` has them."""

    inside: Inside[Any]
    inner: Any
    outer: Any
    still: Any = None
    turns: Any = None
    V: Any = None

    def share(self, eps: Any, stands: bool, preloaded: Any = False) -> Any:
        """P_ref over F where the zone reaches to ε; `stands`: the load on the inner ring."""
        return self.shares(eps, (stands,), preloaded)[0]

    def shares(self, eps: Any, ways: Sequence[bool], preloaded: Any = False) -> list[Any]:
        """The same of several ways to stand."""
        kind = self.inside.elements
        eps = largest(eps, narrowest(Z=self.inside.count, elements=kind))
        Z_J = carrying(Z=self.inside.count, J_r=radial_integral(eps=eps, elements=kind), preloaded=preloaded)
        still, turns = standing_integral(eps=eps, elements=kind), turning_integral(eps=eps, elements=kind)
        both = [(still, turns) if stands else (turns, still) for stands in ways]
        known = dict(Z_J=Z_J, q_i=self.inner, q_e=self.outer, u=EXPONENTS[kind].races)
        return [reference_share(J_i=J_i, J_e=J_e, **known) for J_i, J_e in both]

    def over_reference(self, eps: Any, stands: Any, preloaded: Any = False) -> Any:
        """P_ref over that without clearance; `stands`: of each row, whether the larger load is on the inner ring."""
        ways = [way for way in (True, False) if np.any(np.asarray(stands) == way)]
        ratios = [
            zone_ratio(P_1=P, P_2=self.still if way else self.turns)
            for way, P in zip(ways, self.shares(eps, ways, preloaded))
        ]
        return np.where(stands, *ratios) if len(ways) > 1 else ratios[0]


def races_of(inside: Inside[Any]) -> Races:
    gamma, Z = gamma_of(inside), inside.count
    if inside.elements == "ball":
        f_i, f_e = counted_grooves(inside)
        X = race_ratio_of_balls(k_X=1.044, gamma=gamma, f_i=f_i, f_e=f_e)
        races = Races(inside, inner_race_of_balls(X=X, Z=Z), outer_race_of_balls(X=X, Z=Z))
    else:
        X = race_ratio_of_rollers(k_X=1.038, gamma=gamma)
        races = Races(inside, inner_race_of_rollers(X=X, Z=Z), outer_race_of_rollers(X=X, Z=Z))
    still, turns = races.shares(HALF, (True, False))
    return races._replace(still=still, turns=turns, V=ring_factor(P_s=still, P_t=turns))


def radial_of(races: Races | None, F_1: Any, F_2: Any, p: float) -> Any:
    """V·F_m of each row; V is 1 where the larger load stands in space."""
    return on_ring(races, mean_of(F_1, F_2, p), F_1 >= F_2)


def on_ring(races: Races | None, F_m: Any, stands: Any) -> Any:
    """The same of mean loads; `stands`: where the larger load stands on the inner ring."""
    V = ring_factor_of(races)
    if np.ndim(stands):
        V = np.where(stands, V, 1.0)
    return radial_equivalent(V=V if np.ndim(V) or stands else 1.0, F_m=F_m)


def ring_factor_of(races: Races | None) -> Any:
    """V where the load stands on the inner ring; 1 of a bearing whose inside is not known."""
    return 1.0 if races is None else races.V


# --- equivalent loads


@formula(
    "P_r",
    "ISO 281: radial load, by the ring on which it stands; V is 1 where the larger load stands in space",
    meanings={"V": "Factor of the ring that turns"},
)
def radial_equivalent(V: Number, F_m: Newton) -> Newton:
    return V * F_m


@formula("u_a", "ISO 281, table 3: relative axial load of balls")
def relative_thrust(f_0: Number, F_a: Newton, C_0: Newton) -> Number:
    return f_0 * F_a / C_0


@formula("Y", "ISO 281, table 3: balls in deep grooves", shows="Y by table, linear in ln u_a, held at its ends")
def thrust_factor(u: Number) -> Number:
    row = _thrust()
    return single_or_many(np.asarray(np.interp(np.log(largest(u, 1e-9)), np.log(row["u"]), row["Y"])))


@formula(
    "e_a", "ISO 281, table 3: thrust over load up to which it does not count", shows="e by table, linear in ln u_a"
)
def thrust_threshold(u: Number) -> Number:
    row = _thrust()
    return single_or_many(np.asarray(np.interp(np.log(largest(u, 1e-9)), np.log(row["u"]), row["e"])))


@formula("P", "ISO 281, table 3: balls in deep grooves")
def equivalent_of_balls(P_r: Newton, Y: Number, F_a: Newton) -> Newton:
    return largest(P_r, 0.56 * P_r + Y * F_a)


@formula("P", "SKF 2013: flanged cylindrical roller bearings with thrust")
def equivalent_of_rollers(P_r: Newton, Y: Number, F_a: Newton) -> Newton:
    return 0.92 * P_r + Y * F_a


def equivalent(size: BearingSize[Any], ratings: Ratings, P_r: Any, F_a: Any) -> Any:
    """P of the radial load and the thrust F_a; what bears no thrust leaves it out."""
    if size.elements == "ball":
        f_0 = 14.0 if ratings.f_0 is None else ratings.f_0  # of one's own whose inside is not known: the middle of all
        Y = thrust_factor(u=relative_thrust(f_0=f_0, F_a=F_a, C_0=ratings.static))
        return equivalent_of_balls(P_r=P_r, Y=Y, F_a=F_a)
    e, Y = size.usual.thrust_from, size.usual.thrust_factor
    if Y is None:
        return P_r
    both, counts = equivalent_of_rollers(P_r=P_r, Y=Y, F_a=F_a), F_a > e * P_r
    if np.ndim(counts):
        return np.where(counts, both, P_r)
    return both if counts else P_r


def _thrust() -> TableRow:
    row: TableRow = house_table(FILE)["thrust"]["ball"]
    return row


# --- standing


@formula("P_0", "ISO 76: radial load at the overspeed, with shocks", names={"k_s": "k_shock"})
def static_load(k_s: Number, F_1: Newton, o: Number, F_2: Newton) -> Newton:
    """o: overspeed, a share of the rated speed."""
    return k_s * (F_1 * (1 + o) ** 2 + F_2)


@formula("S_0", "ISO 76: static safety")
def static_safety(C_0: Newton, P_0: Newton) -> Number:
    return C_0 / largest(P_0, NOTHING)
