"""Several shafts by chance together: given values, the single shaft, first order."""

from dataclasses import replace

import numpy as np
import pytest

from calc.countershaft.inputs import Extra, Scatter
from calc.countershaft.making.scatter import errors
from calc.countershaft.making.system_scatter import MadeShaft, system_scattered
from calc.countershaft.sums import OrderVectors, SystemShaft
from tests.calc.countershaft.making.test_scatter import (
    COUPLE,
    DEGREE,
    FORCE,
    HOLES,
    MASSES,
    OMEGA,
    SOME,
    found,
    heavier,
    target,
    vectors,
)
from tests.calc.countershaft.systems import CASES, called, engine, masses, rows, scatter, shafts, tolerance

NOTHING = OrderVectors(0j, 0j, 0j, 0j)
ONE = SystemShaft("one", -1, FORCE, COUPLE)


def mirrored(parts):
    return tuple(replace(mass, angle=-mass.angle) for mass in parts)


def made(shaft=ONE, scatter=SOME, parts=MASSES, **changes):
    return MadeShaft(shaft=shaft, omega=OMEGA, scatter=scatter, masses=parts, **changes)


@pytest.mark.parametrize("row", rows(scatter=True), ids=called)
def test_the_given_system(row):
    case = CASES[row["case"]]
    orders, omega = engine(row["case"])
    original = case["shafts"][0]
    parts = masses(original)
    own = [
        MadeShaft(shaft=shaft, omega=abs(shaft.ratio) * omega, scatter=scatter(original), masses=of)
        for shaft, of in zip(shafts(row["case"]), (parts, mirrored(parts)))
    ]
    of = system_scattered(orders, own)
    _, _, *order, quantity = row["value"].split(".")
    assert getattr(of.errors[order[0]] if order else of, quantity) == pytest.approx(row["is"], **tolerance(row))


@pytest.mark.parametrize("drilled", [False, True])
@pytest.mark.parametrize("extras", [(), (Extra(name="hole", mass=-0.05, radius=0.024, angle=1.7, z=0.16),)])
def test_a_system_of_one_shaft_is_that_shaft(drilled, extras):
    """The same draws, block by block: what turns the other way stays, what turns alike is left over."""
    many = replace(SOME, shafts=10_007)
    alone = found(many, heavier(0.01), extras, holes=HOLES if drilled else None, couple_left=7.0)
    of = OrderVectors(0j, -FORCE, 7j, -COUPLE)
    one = made(scatter=many, parts=heavier(0.01), extras=extras, drilling=(target(), HOLES) if drilled else None)
    together = system_scattered({1: of}, [one])
    assert together.couples[1] == pytest.approx(alone.drilled if drilled else alone.residual, rel=1e-12)
    drilled_95 = alone.drilled_couple_95 if drilled else alone.residual_couple_95
    assert together.order_1_couple_95 == pytest.approx(drilled_95, rel=1e-12)
    assert together.errors["order_1"].couple_backward == alone.couple_error
    assert together.errors["order_1"].force_backward == alone.force_error
    assert together.order_2_couple_95 is None


def test_drilling_takes_of_the_force_what_it_takes_of_the_masses():
    """One mass that is too heavy, in the plane of a bearing: the hole takes force and couple as that mass has them."""
    heavy = (replace(MASSES[0], mass=MASSES[0].mass + 0.02), MASSES[1])
    exact = Scatter(mass=0.0, radius=0.0, angle=0.0, z=0.0)
    of = {1: OrderVectors(0j, -FORCE, 0j, -COUPLE)}
    left = [
        system_scattered(of, [made(scatter=exact, parts=heavy, drilling=drilling)])
        for drilling in (None, (target(), HOLES))
    ]
    before, after = (one.order_1_force_95 for one in left)
    assert before == pytest.approx(OMEGA**2 * 0.02 * MASSES[0].radius)
    assert after < 0.1 * before and left[1].order_1_couple_95 < 0.1 * left[0].order_1_couple_95


@pytest.mark.parametrize("part", ["mass", "radius", "angle", "z", "timing"])
def test_chance_agrees_with_the_first_order(part):
    """The errors of two shafts that turn alike, each part by itself, against the root mean square of what is left of
    engines that they balance as drawn."""
    small = {"mass": 0.003, "radius": 3e-5, "angle": 0.02 * DEGREE, "z": 1e-4, "timing": 0.02 * DEGREE}
    only = {name: size if name == part else 0.0 for name, size in small.items()}
    unlike = (replace(MASSES[0], mass=4.0), MASSES[1])  # that carries a force as well
    F, C = vectors(unlike)
    two = [made(SystemShaft(name, -1, F, C), Scatter(**only), unlike) for name in ("one", "two")]
    of = system_scattered({1: OrderVectors(0j, -2 * F, 0j, -2 * C)}, two)
    for drawn, first_order in ((of.forces, "force_backward"), (of.couples, "couple_backward")):
        error = getattr(of.errors["order_1"], first_order)
        assert np.sqrt((drawn[1] ** 2).mean()) == pytest.approx(error, rel=0.03, abs=1e-6)
        assert (error == 0) == (part == "z" and first_order == "force_backward")
    assert of.errors["order_1"].force_forward == of.errors["order_1"].couple_forward == 0


def test_shafts_of_one_seed_have_their_own_luck():
    """Two that were the same in every draw would leave twice the error of one, not √2 of it."""
    one = made()
    single = system_scattered({1: OrderVectors(0j, -FORCE, 0j, -COUPLE)}, [one])
    twice = system_scattered({1: OrderVectors(0j, -2 * FORCE, 0j, -2 * COUPLE)}, [one, one])
    spread = [np.sqrt((of.couples[1] ** 2).mean()) for of in (single, twice)]
    assert spread[1] / spread[0] == pytest.approx(np.sqrt(2), rel=0.03)


def test_an_exact_shaft_is_what_it_is_and_the_fewest_tries_count():
    exact = MadeShaft(SystemShaft("exact", 2, 3 + 4j, 0j), 2 * OMEGA, None, ())
    assert system_scattered({2: NOTHING}, [exact]) is None
    tried = made(scatter=replace(SOME, shafts=150)), made(scatter=replace(SOME, shafts=12_000))
    of = system_scattered({1: NOTHING, 2: NOTHING}, [exact, *tried])
    assert of.couples[1].size == of.forces[2].size == 150
    assert (of.forces[2] == 5).all() and of.errors["order_2"].force_forward == 0


def test_the_errors_of_a_mirror_image_are_its_originals():
    of = errors(SOME, MASSES, (), OMEGA)
    assert errors(SOME, mirrored(MASSES), (), OMEGA) == pytest.approx(of, rel=1e-12)
