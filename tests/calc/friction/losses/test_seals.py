# SPDX-License-Identifier: Apache-2.0
"""Shaft seals by two rules: their constants, and that the one lies within the other."""

import math

import pytest

from calc.friction.inputs import Seal
from calc.friction.losses.bearings import linke, simrit
from tests.calc.friction.pairs import closed, lubricant, shown

D, N = 60e-3, 40.0  # m, rev/s


def per_square(P, d=D, n=N):
    """The power over d²·n, in W/(mm²·rpm)."""
    return P / ((d * 1e3) ** 2 * n * 60)


def test_simrit_is_a_torque_by_the_square_of_the_diameter():
    """7.69·10⁻⁶ W per mm²·rpm is 7.343·10⁻⁵ N·m per mm²."""
    for d, n in ((0.02, 10.0), (D, N)):
        assert simrit(d_sh=d, n=n) / (2 * math.pi * n) == pytest.approx(7.343e-5 * (d * 1e3) ** 2, rel=1e-4)


@pytest.mark.parametrize(
    "T, nu_40, expected",
    [
        (80.0, 220e-6, 146e-7),
        (100.0, 100e-6, 91e-7),
        (100.0, 46e-6, 63e-7),
        (90.0, 100e-6, 107e-7),
        (60.0, 5e-6, 7.97e-7),
    ],
)
def test_linke_by_hand(T, nu_40, expected):
    """Calculated by hand from the published equation, three oils by their ISO VG, and one of 5 mm²/s: lg 5.8 = 0.76343,
    lg lg 5.8 = −0.11723, 145 − 96 − 41.03 = 7.97."""
    assert per_square(linke(T_oil=T, nu_40=nu_40, d_sh=D, n=N)) == pytest.approx(expected, abs=0.5e-7)


def test_simrit_lies_within_linke_between_80_and_100_degrees():
    thin, thick = (linke(T_oil=T, nu_40=nu, d_sh=D, n=N) for T, nu in ((100.0, 46e-6), (80.0, 220e-6)))
    assert thin < simrit(d_sh=D, n=N) < thick


def test_hot_and_thin_oil_drags_less():
    cold, hot, thin = (linke(T_oil=T, nu_40=nu, d_sh=D, n=N) for T, nu in ((60.0, 1e-4), (100.0, 1e-4), (60.0, 3e-5)))
    assert hot < cold and thin < cold
    assert linke(T_oil=100.0, nu_40=5e-6, d_sh=D, n=N) == 0.0
    assert linke(T_oil=60.0, nu_40=1e-4, d_sh=2 * D, n=2 * N) == pytest.approx(8 * cold)


def test_seals_in_the_balance():
    """Two of Simrit's on the crank, one by Linke on the shaft, with the oil of the train."""
    seals = (Seal(name="crank", diameter=0.03, count=2), Seal(name="shaft rear", diameter=0.02, method="linke"))
    values = shown(closed(seals=seals))
    assert values["crank.seal_loss"] == pytest.approx(2 * 7.69e-6 * 30**2 * 2600)
    n = values["shaft.speed"] / 60
    assert values["shaft.seal_loss"] == pytest.approx(linke(T_oil=120.0, nu_40=lubricant().oil.nu40, d_sh=0.02, n=n))
    assert values["seal_loss"] == pytest.approx(values["crank.seal_loss"] + values["shaft.seal_loss"])
    assert values["total_loss"] == pytest.approx(values["crank_power"], rel=1e-9)
    assert "idler.seal_loss" not in values
