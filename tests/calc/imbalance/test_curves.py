"""Figures and tables: the vectors end on their locus, the shaft takes its share, what is nothing is not drawn."""

import numpy as np
import pytest

from calc.imbalance.curves import WITHOUT, pictures, remedy_table
from calc.imbalance.inputs import ImbalanceInputs
from tests.calc.imbalance.engines import solved


def curves(left=None, several=False, **changes):
    found = solved(ImbalanceInputs(), **changes)[2]
    return found, {curve.id: curve for curve in pictures(found, left, several=several)}


def left_by(found, *shafts):
    """What is left by order, of shafts of (ratio, force, couple)."""
    left = {}
    for ratio, force, couple in shafts:
        n, side = abs(ratio), int(ratio < 0)
        vectors = list(left.get(n, found.orders[f"order_{n}"].vectors))
        vectors[side] += force
        vectors[2 + side] += couple
        left[n] = tuple(vectors)
    return left


@pytest.mark.parametrize(
    "changes", [{}, dict(cylinders=4, firing_order=(1, 3, 4, 2)), dict(cylinders=1, firing_order=None)]
)
def test_the_chain_of_vectors_ends_on_the_locus(changes):
    _, drawn = curves(**changes)
    for curve in drawn.values():
        for chain in curve.turning:
            line = next(s for s in curve.series if s.variant == chain.variant and s.label.startswith("order"))
            assert curve.along[0] == "crank angle, °"
            for k, theta in enumerate(np.radians(curve.along[1])):
                end = chain.at(theta)[-1]
                assert (end.imag, end.real) == pytest.approx(
                    (line.x[k], line.y[k]), abs=1e-6 * np.abs(line.y).max() + 1e-6
                )


def test_an_ideal_shaft_closes_the_chain():
    _, drawn = curves()
    ideal = drawn["locus"].turning[1]
    assert ideal.names[-1] == "counter-shaft" and abs(ideal.at(0.7)[-1]) < 1e-9
    assert drawn["locus"].variants == (WITHOUT, "with an ideal counter-shaft")


def test_the_design_s_own_shaft_leaves_what_it_leaves():
    found = solved()[2]
    left = left_by(found, (-1, 0j, 0.9 * found.required))
    _, drawn = curves(left)
    assert abs(drawn["locus"].turning[1].at(1.0)[-1]) == pytest.approx(0.1 * found.required_couple)
    bars = {(s.label, s.variant): s.y for s in drawn["orders_couple"].series}
    assert bars["backward", "with the counter-shaft"][0] == pytest.approx(0.1 * bars["backward", WITHOUT][0])
    row = remedy_table(found, 0.5, 1.0, left).rows[2]
    assert row[3] == pytest.approx(0.1 * found.required_couple)


def test_an_inline_four_shows_its_second_order_and_no_couple():
    _, drawn = curves(cylinders=4, firing_order=(1, 3, 4, 2))
    assert {"locus_force", "orders_force", "forces"} == set(drawn)
    assert drawn["locus_force"].series[0].label == "order 2" and not drawn["locus_force"].variants
    assert drawn["locus_force"].turning[0].orders == (2, -2)


def test_two_shafts_at_twice_crank_speed_show_what_they_leave_of_second_order():
    four = dict(cylinders=4, firing_order=(1, 3, 4, 2))
    found = solved(**four)[2]
    F_f, F_b, _, _ = found.orders["order_2"].vectors
    left = left_by(found, (2, -0.75 * F_f, 0j), (-2, -0.75 * F_b, 0j))
    _, drawn = curves(left, several=True, **four)
    locus = drawn["locus_force"]
    assert locus.variants == ("without the shafts", "with the shafts") and locus.turning[1].orders == (2, -2, 2, -2)
    assert locus.turning[1].names[2:] == ("shaft with the crank", "shaft against it")
    assert abs(locus.turning[1].at(0.0)[-1]) == pytest.approx(0.25 * found.orders["order_2"].force_peak)
    bars = {(s.label, s.variant): s.y for s in drawn["orders_force"].series}
    assert bars["forward", "with the shafts"][1] == pytest.approx(0.25 * bars["forward", "without the shafts"][1])
    row = remedy_table(found, 0.5, 1.0, left, several=True).rows[2]
    assert row[0] == "the same, with the shafts as designed"
    assert row[4] == pytest.approx(0.25 * found.orders["order_2"].force_peak)


def test_an_inline_six_has_next_to_nothing_to_draw():
    assert curves(cylinders=6, firing_order=(1, 5, 3, 6, 2, 4))[1] == {}


def test_the_table_of_remedies_goes_from_worst_to_best():
    found = solved(ImbalanceInputs())[2]
    rows = {row[0]: row for row in remedy_table(found, 0.5).rows}
    assert rows["rotating masses balanced, nothing else"][3] == pytest.approx(1145.864, abs=1e-3)
    assert rows["crank as designed (share 0.5)"][3] == pytest.approx(572.932, abs=5e-4)
    assert rows["the same, and one shaft at −1"][3] == 0
    assert rows["two shafts at ±1, two shafts at ±2"][5] == 0
    assert "7729 kg·mm² at 30°" in rows["the same, and one shaft at −1"][1]
