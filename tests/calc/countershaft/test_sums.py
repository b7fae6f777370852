"""All balance shafts of an engine together: given values, a turn in time, symmetries."""

import cmath
import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from calc.countershaft import formulas as f
from calc.countershaft.curves import phasor_plane, teeth_bars
from calc.countershaft.sums import (
    OrderVectors,
    SystemShaft,
    left,
    rolled,
    teeth_off,
    teeth_table,
    together,
)
from calc.design.toml_file import design, read
from calc.engine.result import EngineResult
from calc.imbalance.remedies import roll_torque
from calc.imbalance.result import ImbalanceResult
from calc.solve import solve
from tests.calc.countershaft.systems import CASES, called, engine, rows, shafts, tolerance
from tests.conftest import DESIGNS

SIZED = ("v2-45-sized", "twin-270-beside")  # what is left of the first order is shared


def system(case):
    """Its engine and its shafts; one to be sized supplies what is asked of it."""
    orders, omega = engine(case)
    known = shafts(case)
    if case not in SIZED:
        return orders, known
    tables = CASES[case]["shafts"]
    sized = next(row for row in tables if row.get("mode") == "size")
    twins = [row for row in tables if row.get("repeats") == sized["name"]]
    share, beyond = 1 / (1 + len(twins)), sized.get("overdesign_percent", 0.0) / 100
    rest = left(orders[1], known)
    F = f.asked_unbalance(x_o=beyond, F_like=share * rest.force_backward, omega=omega) * omega**2
    C = f.asked_product(x_o=beyond, C_like=share * rest.couple_backward, omega=omega) * omega**2
    one = SystemShaft(sized["name"], -1, F, C, complex(*sized["axis_mm"]) * 1e-3)
    repeated = [one.repeated(row["name"], complex(*row["axis_mm"]) * 1e-3) for row in twins]
    return orders, [*known, one, *repeated]


# --- given values

OF_A_SHAFT = {
    "force": lambda shaft: abs(shaft.force),
    "couple": lambda shaft: abs(shaft.couple),
    "couple_phase": lambda shaft: math.degrees(cmath.phase(shaft.couple)) % 360,
    "roll_torque": lambda shaft: roll_torque(p=shaft.axis, F=shaft.force),
}
GIVEN = rows(scatter=False)
OFF = [row for row in GIVEN if row["value"].startswith("gears.")]
SUPPLIED = [row for row in GIVEN if row["value"].split(".")[-1] in OF_A_SHAFT]
LEFT = [row for row in GIVEN if row not in OFF and row not in SUPPLIED]


@pytest.mark.parametrize("row", LEFT, ids=called)
def test_what_is_left_of_the_given_systems(row):
    assert getattr(together(*system(row["case"])), row["value"].split(".")[-1]) == pytest.approx(
        row["is"], **tolerance(row)
    )


@pytest.mark.parametrize("row", SUPPLIED, ids=called)
def test_what_the_given_shafts_supply(row):
    _, *name, quantity = row["value"].split(".")
    known = system(row["case"])[1]
    shaft = next(shaft for shaft in known if [shaft.name] == name or not name)
    assert OF_A_SHAFT[quantity](shaft) == pytest.approx(row["is"], **tolerance(row))
    if quantity == "roll_torque":  # the amount of its part of the sum
        assert abs(rolled([shaft])) == pytest.approx(row["is"], **tolerance(row))


@pytest.mark.parametrize("row", OFF, ids=called)
def test_one_tooth_off_in_the_given_systems(row):
    """The larger of late and early, each value by itself."""
    _, *name, which, quantity = row["value"].split(".")
    found = teeth_off(*system(row["case"]))
    off = {
        "tooth_late": found.shafts.get(*name) if name else next(iter(found.shafts.values())),
        "pair_late": found.pairs.get(*name) if name else None,
        "all_late": found.all,
    }[which]
    assert getattr(off, quantity) == pytest.approx(row["is"], **tolerance(row))


def test_late_and_early_differ_and_the_table_has_both():
    """The pair under the inline four: a roll of 730 N·m late, 942 N·m early; the vee's two shafts 91 and 301 N·m."""
    for case, name, late, early in (("r754", "left", 730.0, 942.0), ("v2-45", "front", 91.0, 301.0)):
        found = teeth_off(*system(case))
        (columns,) = found.shafts[name].columns.values()
        assert columns[2] == pytest.approx((late, early), abs=0.5)
        table = teeth_table(found)
        assert len(table.rows) == len(list(found.rows()))
        assert table.rows[0][-2:] == columns[2] and table.rows[0][2:4] == columns[0]


# --- against a turn in time

numbers = st.floats(-1.0, 1.0)
vectors = st.complex_numbers(max_magnitude=1.0, allow_nan=False, allow_infinity=False)
orders_of_an_engine = st.builds(OrderVectors, vectors, vectors, vectors, vectors, vectors)
teeth = st.integers(12, 60).map(lambda z: 2 * math.pi / z)
some_shafts = st.lists(
    st.builds(SystemShaft, st.just(""), st.sampled_from((-2, -1, 1, 2)), vectors, vectors, vectors, teeth),
    min_size=1,
    max_size=4,
).map(lambda found: [replace(shaft, name=f"shaft-{k}") for k, shaft in enumerate(found)])
TURN = np.arange(720) * 2 * np.pi / 720


def in_time(n, orders, known):
    """Order n of force, couple and roll over a turn of the crank, each force at its place: Fourier coefficients."""
    of = orders[n]
    with_crank, against = np.exp(1j * n * TURN), np.exp(-1j * n * TURN)
    F = of.force_forward * with_crank + of.force_backward * against
    C = of.couple_forward * with_crank + of.couple_backward * against
    T = (of.roll * with_crank).real
    for shaft in known:
        turned = np.exp(1j * shaft.ratio * TURN)
        F, C = F + shaft.force * turned, C + shaft.couple * turned
        force = shaft.force * turned
        T = T + shaft.axis.real * force.imag - shaft.axis.imag * force.real
    # of another order a shaft adds nothing to this one
    return [np.fft.fft(course) / TURN.size for course in (F, C, T)]


@given(st.fixed_dictionaries({1: orders_of_an_engine, 2: orders_of_an_engine}), some_shafts)
def test_sums_against_a_turn_in_time(orders, known):
    found = together(orders, known)
    assert set(found.vectors) == {shaft.order for shaft in known}
    for n, of in found.vectors.items():
        F, C, T = in_time(n, orders, known)
        close = pytest.approx
        assert (of.force_forward, of.force_backward) == (close(F[n], abs=1e-9), close(F[-n], abs=1e-9))
        assert (of.couple_forward, of.couple_backward) == (close(C[n], abs=1e-9), close(C[-n], abs=1e-9))
        assert of.roll == close(2 * T[n], abs=1e-9)
        # peak and least over the turn are the half axes of an ellipse: singular values of its conjugate half diameters
        for word, forward, backward in (("force", F[n], F[-n]), ("couple", C[n], C[-n])):
            at_tdc, quarter_on = forward + backward, 1j * (forward - backward)
            axes = np.linalg.svd([[at_tdc.real, quarter_on.real], [at_tdc.imag, quarter_on.imag]], compute_uv=False)
            part = found.residual[f"order_{n}"]
            assert getattr(found, f"residual_order_{n}_{word}") == close(axes[0], abs=1e-9)
            assert getattr(part, f"{word}_least") == close(axes[1], abs=1e-9)
            for sense, vector in (("forward", forward), ("backward", backward)):
                length, phase = (getattr(part, f"{word}_{sense}{end}") for end in ("", "_phase"))
                assert cmath.rect(length, phase) == close(vector, abs=1e-9)
        of_shafts = in_time(n, {n: OrderVectors(0j, 0j, 0j, 0j, 0j)}, known)[2]
        for name, roll in (("roll_left", T), ("roll_torque", of_shafts)):
            amount, phase = (getattr(found, f"{name}_order_{n}{end}") for end in ("", "_phase"))
            assert cmath.rect(amount, phase) == close(2 * roll[n], abs=1e-9)


@given(st.fixed_dictionaries({1: orders_of_an_engine, 2: orders_of_an_engine}), some_shafts)
def test_one_tooth_off_against_shafts_that_are_turned_in_time(orders, known):
    """A late shaft does what it did an angle δ of its own before, whichever way it turns."""
    found = teeth_off(orders, known)
    for shaft in known:
        for n, (force, couple, roll) in found.shafts[shaft.name].columns.items():
            for k, sign in enumerate((1, -1)):
                delta = sign * shaft.tooth
                before = cmath.exp(-1j * math.copysign(1, shaft.ratio) * delta)
                moved = replace(shaft, force=shaft.force * before, couple=shaft.couple * before)
                F, C, T = in_time(n, orders, [moved if one is shaft else one for one in known])
                assert force[k] == pytest.approx(abs(F[n]) + abs(F[-n]), abs=1e-9)
                assert couple[k] == pytest.approx(abs(C[n]) + abs(C[-n]), abs=1e-9)
                assert roll[k] == pytest.approx(abs(2 * T[n]), abs=1e-9)
            off = found.shafts[shaft.name]
            assert getattr(off, f"order_{n}_force") == max(force)
            assert getattr(off, f"order_{n}_couple") == max(couple)
            assert getattr(off, f"order_{n}_roll") == max(roll)


# --- symmetries


def mirrored_engine(of):
    """What turned with the crank turns against it, all vectors and the roll mirrored, in axes that stay."""
    return OrderVectors(
        of.force_backward.conjugate(),
        of.force_forward.conjugate(),
        of.couple_backward.conjugate(),
        of.couple_forward.conjugate(),
        -of.roll,
    )


@given(st.fixed_dictionaries({1: orders_of_an_engine, 2: orders_of_an_engine}), some_shafts)
def test_a_system_that_is_mirrored_whole_leaves_the_same(orders, known):
    mirrored = {n: mirrored_engine(of) for n, of in orders.items()}
    images = [shaft.mirror_image(shaft.name) for shaft in known]
    one, other = together(orders, known), together(mirrored, images)
    for name in (name for name in vars(one) if name.startswith(("residual_", "roll_")) and not name.endswith("phase")):
        value = getattr(one, name)
        assert (value is None) == (getattr(other, name) is None)
        if value is not None:
            assert getattr(other, name) == pytest.approx(value, abs=1e-12)


def test_a_pair_of_mirror_images_off_together_stays_one():
    """What is left of a force that it took whole is vertical, 2·sin(τ/2) of each sense; it rolls nothing."""
    F, tau = -1000 + 0j, 2 * math.pi / 30
    one = SystemShaft("one", 2, F, 0j, 0.02 + 0.1j, tau)
    pair = [one, one.mirror_image("other")]
    taken = {2: OrderVectors(-F, -F, 0j, 0j, 0j)}
    assert together(taken, pair).residual_order_2_force == together(taken, pair).roll_torque_order_2 == 0
    both = teeth_off(taken, pair).pairs["one"]
    assert both.order_2_force == pytest.approx(2 * 2 * math.sin(tau / 2) * 1000)
    assert both.order_2_roll == pytest.approx(0, abs=1e-10)
    late = [shaft.late_by(tau) for shaft in pair]
    whole = left(taken[2], late)
    assert whole.force_forward == pytest.approx(whole.force_backward.conjugate())


@given(vectors, vectors, st.sampled_from((-2, -1, 1, 2)), vectors)
def test_a_shaft_repeated_at_no_distance_is_one_of_double_masses(F, C, ratio, axis):
    nothing = {abs(ratio): OrderVectors(0j, 0j, 0j, 0j, 0j)}
    one = SystemShaft("one", ratio, F, C, axis)
    twice = together(nothing, [one, one.repeated("again", axis)]).vectors[abs(ratio)]
    double = together(nothing, [replace(one, force=2 * F, couple=2 * C)]).vectors[abs(ratio)]
    for name in vars(double):
        assert getattr(twice, name) == pytest.approx(getattr(double, name), abs=1e-14)


@given(st.floats(-0.2, 0.2), st.floats(-0.2, 0.2), st.floats(0.01, 0.2), vectors)
def test_a_mirrored_pair_at_unequal_heights_rolls_by_its_force_times_the_difference(up, down, side, F):
    """i·A·(h⁺ − h⁻) of a vertical force A; at equal heights nothing, whatever the force."""
    one = SystemShaft("one", 1, F, 0j, complex(up, side))
    assert abs(rolled([one, one.mirror_image("two")])) <= 1e-15
    vertical = replace(one, force=F.real + 0j)
    pair = [vertical, vertical.mirror_image("two", complex(down, -side))]
    assert abs(rolled(pair)) == pytest.approx(abs(F.real * (up - down)), abs=1e-12)


# --- bits of one shaft, what is not known


@pytest.mark.parametrize("path", sorted(DESIGNS.glob("*.toml")), ids=lambda path: path.stem)
def test_what_the_step_leaves_has_the_same_bits(path):
    """Of every shipped design with one shaft, or with a mirrored pair."""
    solved = solve(design(read(path)))
    inputs, left = solved.design.countershaft, solved.left
    if left is None:
        return
    step = next(each["countershaft"].result for each in solved.of_shafts.values())
    e, i = solved.result(EngineResult), solved.result(ImbalanceResult)
    axis = None if inputs.axis is None else complex(*inputs.axis)
    one = SystemShaft("shaft", inputs.speed_ratio, *step.vectors, axis)
    known = [one, one.mirror_image("twin")] if len(solved.design.shafts) > 1 else [one]
    n = one.order
    bare = {n: OrderVectors(*i.orders[f"order_{n}"].vectors, e.torque.reaction_harmonics[n - 1])}
    found = together(bare, known)
    for name in ("couple", "force"):
        assert getattr(found, f"residual_order_{n}_{name}") == getattr(left, f"residual_order_{n}_{name}")


def test_an_axis_that_is_not_known_leaves_the_roll_unknown():
    one = SystemShaft("one", -1, 1 + 0j, 0j, 0.1 + 0j, 0.1)
    known = {1: OrderVectors(0j, -1 + 0j, 0j, 0j, 2 + 0j)}
    for shaft, bare in ((replace(one, axis=None), known), (one, {1: replace(known[1], roll=None)})):
        found = together(bare, [shaft])
        assert found.roll_left_order_1 is None and found.residual_order_1_force == 0
        assert (found.roll_torque_order_1 is None) == (shaft.axis is None)
        assert teeth_off(bare, [shaft]).shafts["one"].order_1_roll is None
    assert together(known, [one]).roll_left_order_1 == pytest.approx(abs(2 - 0.1j * -1))


def test_a_wheel_that_is_not_known_leaves_its_rows_out():
    one = SystemShaft("one", 1, 1 + 0j, 0j, None, 0.1)
    nothing = {1: OrderVectors(0j, 0j, 0j, 0j)}
    assert teeth_off(nothing, [one]).all is None  # of one shaft the row is its own
    pair = [one, replace(one.mirror_image("two"), tooth=None)]
    found = teeth_off(nothing, pair)
    assert list(found.shafts) == ["one"] and not found.pairs and found.all is None


def test_the_phasor_plane_chains_the_shafts_to_what_is_left():
    """Of each sense the vectors end on the circle of what is left, at the place of the sum with cylinder 1 at TDC."""
    bare = OrderVectors(3000 + 40j, 2900 - 70j, 10j, 5 + 0j)
    left_one = SystemShaft("left", 2, -2500 + 100j, 0j)
    known = [left_one, left_one.mirror_image("right"), SystemShaft("first", -1, 7 + 0j, 0j)]
    curve = phasor_plane(2, "N", bare, known)
    assert curve.variants == ("with the crank", "against it") and curve.equal
    found = together({2: bare, 1: bare}, known).vectors[2]
    for chain, circle, shaft, end, order in zip(curve.turning, curve.series, ("left", "right"), found.forces, (2, -2)):
        assert chain.names == ("engine", shaft) and chain.orders == (order, order)
        assert chain.at(0.0)[-1] == pytest.approx(end)
        assert np.hypot(circle.x, circle.y) == pytest.approx(np.full(circle.x.shape, abs(end)))
        assert chain.at(0.3)[-1] == pytest.approx(end * cmath.exp(1j * order * 0.3))
    assert phasor_plane(1, "N·m", OrderVectors(0j, 0j, 0j, 5 + 0j), known).variants == ("against it",)


def test_bars_of_one_tooth_off_stand_in_the_order_of_the_table():
    bare = {2: OrderVectors(3000 + 40j, 2900 - 70j, 0j, 0j)}
    one = SystemShaft("left", 2, -2500 + 100j, 0j, None, 0.2)
    teeth = teeth_off(bare, pair := [one, one.mirror_image("right")])
    designed = together(bare, pair).residual_order_2_force
    curve = teeth_bars(2, "N", teeth, designed)
    table = teeth_table(teeth).rows
    assert [str(name) for name in curve.names] == [str(row[0]) for row in table] and len(curve.names) == 4
    for series, column in zip(curve.series, (2, 3)):
        assert list(series.y) == [row[column] for row in table]
    assert curve.limits[0][1] == designed < min(curve.series[0].y)
