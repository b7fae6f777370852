"""Supports that share what turns: against closed forms, limits, and reference values of another program."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc import countershaft
from calc.countershaft import Rigid, Spring
from calc.countershaft.bending import formulas as f
from calc.countershaft.bending.carried import Hold, _tangent
from calc.sheet.errors import NoSolution
from tests.calc.countershaft.bending import cases


def laws(case):
    return [Spring(law["k_N_um"] * 1e6) for law in case["laws"]] if "laws" in case else [Rigid()] * len(case["names"])


@pytest.mark.parametrize("name", ["r754-pins", "r754-sectors", "r754-sectors-honest", "r754-springs", "four-supports"])
def test_pins_and_springs_agree_with_another_program(name):
    case = cases.SHARE[name]
    shaft = cases.turning(case)
    carried = countershaft.carried(shaft, laws(case))
    found = {}
    for i, row in enumerate(case["names"]):
        found |= {
            f"load.{row}": abs(carried.load[i]),
            f"load_phase.{row}": np.angle(carried.load[i]) % (2 * math.pi),
            f"slope.{row}": abs(shaft.theta_0[i]),
            f"tilt.{row}": abs(carried.theta[i]),
            f"displacement.{row}": abs(carried.x[i]),
        }
    cases.compared(name, found)


SHAFT = cases.turning(cases.SHARE["four-supports"])  # nothing of it is symmetric
stiffnesses = st.lists(st.floats(1e6, 1e10), min_size=4, max_size=4)


@given(k=stiffnesses)
def test_springs_are_a_linear_system(k):
    carried = countershaft.carried(SHAFT, [Spring(x) for x in k])
    x = np.linalg.solve(SHAFT.K_c + np.diag(k), SHAFT.f_c)
    assert carried.x == pytest.approx(x, rel=1e-9)
    assert carried.load == pytest.approx(k * x, rel=1e-9)
    assert carried.stiffness == pytest.approx(k)
    assert carried.steps <= 1


def test_stiff_springs_are_pins():
    pins, springs = (countershaft.carried(SHAFT, [law] * 4) for law in (Rigid(), Spring(1e14)))
    assert springs.load == pytest.approx(pins.load, rel=1e-5)
    assert springs.theta == pytest.approx(SHAFT.theta_0, rel=1e-5)


def test_some_are_rigid():
    mixed = countershaft.carried(SHAFT, [Rigid(), Spring(8e7), Rigid(), Spring(6e7)])
    almost = countershaft.carried(SHAFT, [Spring(x) for x in (1e14, 8e7, 1e14, 6e7)])
    assert mixed.load == pytest.approx(almost.load, rel=1e-4)
    assert mixed.x[[0, 2]] == pytest.approx([0, 0])
    assert mixed.stiffness == pytest.approx([math.inf, 8e7, math.inf, 6e7])


def test_a_stiff_shaft_shares_by_the_lever_rule():
    """On supports that are soft beside it a shaft stays straight: its force and its couple decide, not its bending."""
    case = cases.SHARE["four-supports"] | {"E_GPa": 206e6}
    k = np.array([6e6, 9e6, 7e6, 6e6])
    shaft = cases.turning(case)
    carried = countershaft.carried(shaft, [Spring(x) for x in k])
    straight = np.stack([np.ones(4), shaft.z], 1)
    inertia = straight.T @ shaft.K_c @ straight  # −ω² times mass, static moment and moment of inertia
    lift, tilt = np.linalg.solve(straight.T @ (k[:, None] * straight) + inertia, straight.T @ shaft.f_c)
    assert carried.load == pytest.approx(k * (lift + tilt * shaft.z), rel=1e-3)
    assert carried.theta == pytest.approx(np.full(4, tilt), rel=1e-2)
    assert f.cone(x_f=carried.x[0], x_r=carried.x[3], z_f=shaft.z[0], z_r=shaft.z[3]) == pytest.approx(
        abs(tilt), rel=1e-2
    )


class Stiffening:
    """A made law: it stiffens, and turns its load the more the farther the journal is."""

    def __init__(self, k, b, turns):
        self.k, self.b, self.turns = k, b, turns

    def hold(self, e):
        k, b = self.k, self.b
        return Hold(k * e + b * e**3, k + 3 * b * e**2, k + b * e**2, self.turns * e, self.turns)

    def begin(self, F):
        return F / self.k

    def farthest(self, e):
        return math.inf

    def softer(self, share):
        return self

    def said(self, name, e):
        return f"bearing {name}"


WAYS = st.floats(-5e-5, 5e-5, allow_subnormal=False)  # of which a direction can still be taken


@settings(max_examples=50)
@given(re=WAYS, im=WAYS, turns=st.floats(-2e4, 2e4))
def test_the_tangent_is_the_slope_of_the_load(re, im, turns):
    law, h = Stiffening(5e7, 4e16, turns), 1e-9
    x = complex(re, im)

    def load(x):
        held = law.hold(abs(x))
        return held.force * np.exp(1j * held.attitude) * (x / abs(x) if x else 1)

    along, across = ((load(x + h * way) - load(x - h * way)) / (2 * h) for way in (1, 1j))
    size = 1e-4 * (5e7 + 3 * 4e16 * abs(x) ** 2) * (1 + abs(turns * x))
    held, u = law.hold(abs(x)), x / abs(x) if x else 1.0
    assert _tangent(held, u, u * np.exp(1j * held.attitude)) == pytest.approx(
        [along.real, across.real, along.imag, across.imag], abs=size
    )


@settings(max_examples=50)
@given(k=st.lists(st.floats(3e7, 1e10), min_size=4, max_size=4), b=st.floats(0, 1e17), turns=st.floats(-1e4, 1e4))
def test_what_is_carried_is_in_equilibrium_and_obeys_the_laws(k, b, turns):
    supports = [Stiffening(x, b, turns) for x in k]
    carried = countershaft.carried(SHAFT, supports)
    missing = SHAFT.f_c - SHAFT.K_c @ carried.x - carried.load
    assert abs(missing).max() <= 1e-10 * abs(SHAFT.f_c).max()
    for law, x, P in zip(supports, carried.x, carried.load):
        held = law.hold(abs(x))
        assert P == pytest.approx(held.force * np.exp(1j * held.attitude) * x / abs(x), rel=1e-9, abs=1e-9)


def test_a_mirrored_shaft_has_conjugate_loads():
    """T-1: mirrored in the vertical plane through the crank the angles and the sense turn round, lengths do not."""
    case = cases.SHARE["four-supports"]
    mirrored = case | {"points": [[z, m, e, -angle] for z, m, e, angle in case["points"]]}
    one, other = (
        countershaft.carried(cases.turning(c), [Stiffening(8e7, 1e16, sense * 2e4)] * 4)
        for c, sense in ((case, 1), (mirrored, -1))
    )
    for name in ("x", "load", "theta"):
        assert getattr(other, name) == pytest.approx(getattr(one, name).conj(), rel=1e-9)
    assert other.stiffness == pytest.approx(one.stiffness, rel=1e-9)


def test_a_turned_shaft_has_turned_loads():
    case = cases.SHARE["four-supports"]
    turned = case | {"points": [[z, m, e, angle + 77] for z, m, e, angle in case["points"]]}
    one, other = (countershaft.carried(cases.turning(c), [Stiffening(8e7, 1e16, 2e4)] * 4) for c in (case, turned))
    assert other.load == pytest.approx(one.load * np.exp(1j * math.radians(77)), rel=1e-8)


def test_a_shaft_without_load_lies_in_the_middle():
    case = cases.SHARE["four-supports"] | {"points": []}
    carried = countershaft.carried(cases.turning(case), [Spring(8e7)] * 4)
    assert abs(carried.load).max() == 0.0 == carried.steps


def test_a_step_is_halved_until_less_is_missing():
    """Supports that level off, looked for too far out: whole steps of Newton's method lead ever farther."""

    class Levelling(Stiffening):
        def hold(self, e):
            t = e / 1e-5
            F = 2000 * math.atan(t)
            return Hold(F, 2000 / 1e-5 / (1 + t**2), F / e if e else 2000 / 1e-5)

        def begin(self, F):
            return 5e-5

    shaft = replace(SHAFT, K_c=np.zeros((4, 4)))
    carried = countershaft.carried(shaft, [Levelling(0, 0, 0)] * 4)
    assert abs(carried.x) == pytest.approx(1e-5 * np.tan(abs(shaft.f_c) / 2000), rel=1e-6)


def test_what_finds_no_place_is_said():
    """Supports that would have to let the journals farther out than they can."""

    class Narrow(Stiffening):
        def begin(self, F):
            return 0.0

        def farthest(self, e):
            return 1e-6

    with pytest.raises(NoSolution, match=r"bearings of left find no common place; bearing first, bearing second"):
        countershaft.carried(SHAFT, [Narrow(1e7, 0, 0)] * 4, ["first", "second", "third", "last"], "left")


# --- where the journal is tilted to
def test_the_tilt_towards_the_narrowest_film():
    theta, x = np.array([3e-4 + 4e-4j, 3e-4 + 4e-4j, -2e-4j]), np.array([1e-5j, -2e-5 + 0j, 0j])
    assert f.tilt_along(theta=theta, x=x) == pytest.approx([4e-4, 3e-4, 2e-4])
