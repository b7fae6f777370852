"""Shafts on several supports: Clapeyron's equation against the source's example, textbook cases and the finite-element
beam."""

import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from calc.countershaft.bending.beam import beam, bend
from calc.countershaft.supports import phases_of, reactions, support_moments
from calc.library.journal_rules import heat_index, specific_load
from calc.sheet.errors import NoSolution

mm = 1e-3
R754 = (0.0, 112 * mm, 224 * mm)


def test_the_second_order_shaft_of_the_source():
    """Finotti 2013, 3.2.3.1 (R754IE4): 2134 N at 58 mm from the middle support, both sides, spans 112 mm: M2 =
    −44224.02 N·mm."""
    P, l1, l2 = 2134.0, 112 * mm, 58 * mm
    F, z = [P, P], [l1 - l2, l1 + l2]
    M = support_moments(F=F, z=z, z_s=R754)
    assert M[1].real * 1e3 == pytest.approx(-44224.02, abs=0.005)
    F1 = (P * l2 + M[1].real) / l1
    assert reactions(F, z, R754) == pytest.approx([-F1, -(2 * P - 2 * F1), -F1], rel=1e-12)


def test_loads_of_its_journals():
    """24 × 21 mm at 6000 rpm, by hand from F1 = 710.2498 N: p = F/(d·l), W = F·n/l in N·rpm/mm."""
    F = -reactions([2134.0] * 2, [54 * mm, 170 * mm], R754).real[0]
    assert specific_load(F=F, d=24 * mm, l=21 * mm) / 1e6 == pytest.approx(710.2498 / (24 * 21), rel=1e-6)
    assert heat_index(F=F, n=100.0, l=21 * mm) / (1000 / 60) == pytest.approx(710.2498 * 6000 / 21, rel=1e-6)


def test_a_reaction_that_is_no_more_than_rounding_has_no_phase():
    assert phases_of(["front", "middle", "rear"], [2j, 1e-9 + 0j, -2 + 0j]) == pytest.approx(
        {"front": math.pi / 2, "rear": math.pi}
    )
    assert phases_of(["front", "rear"], [0j, 0j]) == {}


def test_two_supports_by_the_lever():
    F, z = np.array([100 + 50j, -30j]), np.array([-0.1, 0.7])
    R = reactions(F, z, (0.0, 0.5))
    assert R[1] == pytest.approx(-(F @ z) / 0.5)
    assert R.sum() == pytest.approx(-F.sum())


def test_three_equal_spans_under_a_force_in_the_middle():
    """P at the middle of the second of three equal spans: M = −3·P·L/40 over both inner supports (symmetric: 5·M·L =
    −3/8·P·L²)."""
    M = support_moments(F=[1000.0], z=[1.5], z_s=(0.0, 1.0, 2.0, 3.0))
    assert M[1:3] == pytest.approx([-1000 * 3 / 40] * 2, rel=1e-12)


def test_a_load_over_a_support_goes_straight_into_it():
    for i in range(3):
        R = reactions([500.0], [R754[i]], R754)
        assert -R == pytest.approx(500 * np.eye(3)[i], abs=1e-9)


def test_an_overhang():
    """The moment at the end support is −P·a; a third of the way on it lifts: carried over as −½ to a support far beyond
    (two spans)."""
    M = support_moments(F=[100.0], z=[-0.2], z_s=(0.0, 1.0, 2.0))
    assert M == pytest.approx([-20, 5, 0], abs=1e-12)  # 2·M1·(1 + 1) = −M0·1


def test_wrong_supports_are_said():
    for wrong in ((0.0,), (0.0, 0.0), (1.0, 0.5)):
        with pytest.raises(NoSolution, match="supports"):
            reactions([1.0], [0.2], wrong)


spans = st.lists(st.floats(0.05, 1.0), min_size=1, max_size=6)
loads = st.lists(
    st.tuples(st.floats(-1000, 1000), st.floats(-1000, 1000), st.floats(-0.3, 1.3)), min_size=1, max_size=6
)


def arranged(spans, loads):
    positions = np.cumsum([0.2, *spans])
    F = np.array([complex(a, b) for a, b, _ in loads])
    z = positions[0] + np.array([c for *_, c in loads]) * (positions[-1] - positions[0])
    return F, z, positions


@given(spans, loads)
def test_equilibrium(spans, loads):
    F, z, positions = arranged(spans, loads)
    R = reactions(F, z, positions)
    size = np.abs(F).sum() + np.abs(R).sum() + 1
    assert abs(R.sum() + F.sum()) < 1e-12 * size
    assert abs(R @ positions + F @ z) < 1e-12 * size * max(1, positions[-1] * 2)


@given(spans, loads)
def test_superposition_and_mirror(spans, loads):
    F, z, positions = arranged(spans, loads)
    R = reactions(F, z, positions)
    size = np.abs(F).sum() + np.abs(R).sum() + 1
    assert R == pytest.approx(sum(reactions([f], [at], positions) for f, at in zip(F, z)), abs=1e-10 * size)
    assert R[::-1] == pytest.approx(reactions(F, -z, -positions[::-1]), abs=1e-10 * size)


@settings(max_examples=30, deadline=None)
@given(spans, loads)
def test_the_same_as_the_finite_element_beam(spans, loads):
    F, z, positions = arranged(spans, loads)
    marks = np.sort(np.concatenate([z, positions]))
    apart = np.diff(marks)
    assume(np.all((apart == 0) | (apart > 2e-3)))  # the beam makes one node of places that lie within a micrometre
    model = beam([marks[0], marks[-1]], [1e4], [math.inf], [1.0], [0.0], positions, forces=(z, F), longest=0.2)
    R = reactions(F, z, positions)
    assert bend(model).reactions == pytest.approx(R, abs=1e-5 * (np.abs(F).sum() + np.abs(R).sum() + 1))
