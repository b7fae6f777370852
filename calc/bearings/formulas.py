# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="no-any-return"
"""Formulas of a bearing of any kind: its loads over speed, its place on the shaft."""

from ..sheet.formula import formula
from ..sheet.functions import pi, sqrt
from ..sheet.units import Newton, Number, Radian, RadPerSecond, RevPerSecond


@formula("ω", "definition of angular speed", meanings={"n": "Speed"})
def angular_speed(n: RevPerSecond) -> RadPerSecond:
    return 2 * pi * n


@formula("P/f_c", "definition: load over that of rigid supports")
def share_of(P: Newton, R: Newton) -> Number:
    return P / R


@formula(
    "n_0",
    "dynamics: the turning load grows with the square of the speed; the standing one is as large at this",
    unit="rpm",
)
def speed_of_equal_loads(n: RevPerSecond, R_0: Newton, R: Newton) -> RevPerSecond:
    """Below it the load swings about the standing part instead of turning round."""
    return n * sqrt(R_0 / R)


@formula("n_over", "definition: overspeed above the highest speed", unit="rpm", names={"n": "n_max"})
def overspeed(n: RevPerSecond, s: Number) -> RevPerSecond:
    return n * (1 + s)


@formula(
    "F",
    "dynamics: load of eccentric masses, which grows with the square of the speed",
    names={"F": "F_rated", "n_0": "n_rated"},
    meanings={"n": "Speed"},
)
def load_at_speed(F: Newton, n: RevPerSecond, n_0: RevPerSecond) -> Newton:
    return F * (n / n_0) ** 2


@formula("R_max", "statics: the standing part at the moment when it points with the turning one")
def load_peak(F: Newton, R_0: Newton) -> Newton:
    return F + R_0


@formula("φ'", "geometry: a shaft mirrored in the vertical plane, turning the other way")
def mirrored_phase(phi: Radian) -> Radian:
    return -phi
