# SPDX-License-Identifier: Apache-2.0
"""What holds for any engine beside tests/calc/imbalance/test_properties.py; the list of all such laws is
docs/laws.md."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.gears.backlash.formulas import residual_couple
from calc.imbalance import formulas as f
from calc.imbalance.inputs import ImbalanceInputs
from calc.imbalance.remedies import counterweights, crank_product, crank_unbalance, equivalent_mass
from tests.calc.imbalance.engines import R753, fans, solved


def vectors(found):
    """F⁺ F⁻ C⁺ C⁻ of orders 1 to 8, zero where there is none."""
    return np.array(
        [found.orders[f"order_{n}"].vectors if f"order_{n}" in found.orders else (0, 0, 0, 0) for n in range(1, 9)]
    )


@settings(max_examples=30, deadline=None)
@given(fan=fans(), masses=st.floats(0.1, 10), lengths=st.floats(0.2, 5), speeds=st.floats(0.1, 10))
def test_forces_go_with_mass_length_and_speed_squared(fan, masses, lengths, speeds):
    """Similar engines: F ~ m·l·ω², C ~ m·l²·ω²."""
    said = {name: R753[name] * masses for name in ("piston_mass", "rod_mass", "crankpin_bearing_mass")}
    said |= {
        name: {**R753, **fan}[name] * lengths
        for name in ("crank_radius", "rod_length", "cylinder_offset", "rod_cg_to_big_end", "cylinder_pitch")
    }
    said |= {
        "axial_positions": tuple(z * lengths for z in fan["axial_positions"]),
        "rated_speed": R753["rated_speed"] * speeds,
    }
    one, other = solved(**fan)[2], solved(**{**fan, **said})[2]
    scale = masses * lengths * speeds**2 * np.array([1, 1, lengths, lengths])
    assert (
        np.abs(vectors(other) - scale * vectors(one)) < 2e-9 * scale * one.one_force * len(fan["axial_positions"])
    ).all()


@settings(max_examples=30, deadline=None)
@given(fan=fans(), kappa=st.floats(-1, 2), data=st.data())
def test_two_engines_on_one_crank_add_up(fan, kappa, data):
    """Superposition: cylinders 1 to k and cylinder 1 with the others make the vectors of the whole and of cylinder 1
    once more."""
    n = fan["cylinders"]
    k = data.draw(st.integers(1, n))

    def part(which):
        some = {
            name: tuple(fan[name][i] for i in which) for name in ("crank_angles", "bank_of_cylinder", "axial_positions")
        }
        return vectors(
            solved(ImbalanceInputs(crank_balance_fraction=kappa), **{**fan, **some, "cylinders": len(which)})[2]
        )

    front, rest, first, whole = part(range(k)), part([0, *range(k, n)]), part([0]), part(range(n))
    scale = solved()[2].one_force * n * (1 + abs(kappa))
    assert np.abs(front + rest - first - whole).max() < 3e-9 * scale


@settings(max_examples=30, deadline=None)
@given(fan=fans(), data=st.data())
def test_the_numbers_of_the_cylinders_do_not_matter(fan, data):
    """Cylinders 2 … N may be numbered anew in any order."""
    n = fan["cylinders"]
    order = [0, *data.draw(st.permutations(range(1, n)))]
    anew = {
        name: tuple(fan[name][i] for i in order) for name in ("crank_angles", "bank_of_cylinder", "axial_positions")
    }
    one, other = solved(**fan)[2], solved(**{**fan, **anew})[2]
    assert np.abs(vectors(one) - vectors(other)).max() < 2e-9 * one.one_force * n


@settings(max_examples=40, deadline=None)
@given(fan=fans(), turn=st.floats(0, 2 * math.pi))
def test_a_turned_throw_turns_its_vectors_by_the_order_times_its_angle(fan, turn):
    """One cylinder at another throw, seen from the same crank angle: its vectors turn by ±n times the angle, without
    counterweights.

    A bank that is turned with its throw turns them by the angle alone, whatever the order.
    """
    bank, opening = fan["bank_of_cylinder"][0], fan["bank_angle"]
    one = {**fan, "cylinders": 2, "axial_positions": (0.0, 1.0)}  # of the couples, cylinder 2 alone has an arm
    plain = ImbalanceInputs(crank_balance_fraction=0.0)

    def second(angle, bank_2):
        return vectors(solved(plain, **{**one, "crank_angles": (0.0, angle), "bank_of_cylinder": (bank, bank_2)})[2])

    here, there = second(0.0, bank), second(turn, bank)
    n, scale = np.arange(1, 9), 1e-8 * np.abs(here).max()
    for column, sense in ((2, 1), (3, -1)):
        own = here[:, column - 2] / 2  # both cylinders are alike there
        assert np.abs(here[:, column] - own).max() < scale
        assert np.abs(there[:, column] - own * np.exp(1j * sense * n * turn)).max() < scale
        assert np.abs(there[:, column - 2] - own * (1 + np.exp(1j * sense * n * turn))).max() < scale
    way = opening if bank == 0 else -opening
    beside = second(way, 1 - bank)
    assert np.abs(beside[:, 2:] - here[:, 2:] * np.exp(1j * way)).max() < scale


@settings(max_examples=40, deadline=None)
@given(fan=fans(), kappa=st.floats(0, 1), span=st.floats(0.05, 2), radius=st.floats(0.01, 0.2))
def test_two_counterweights_cancel_force_and_couple_of_the_crankpins(fan, kappa, span, radius):
    """ΣU = 0 and ΣU·z = 0 of all crankpins and both weights."""
    inputs, e, _ = solved(**fan)
    M_eq, r = equivalent_mass(M_rot=e.rotating_mass, kappa=kappa, M_alt=e.reciprocating_mass), inputs.crank_radius
    phi, z, theta_0 = e.crank.phi, e.crank.z, e.crank.theta_0
    found = counterweights(M_eq, r, theta_0, phi, z, span, radius)
    front, rear = (found[name].mass * radius * np.exp(1j * found[name].angle) for name in ("front", "rear"))
    pins = M_eq * r * np.exp(1j * (theta_0 + np.asarray(phi)))
    size = M_eq * r * inputs.cylinders
    assert abs(front + rear + pins.sum()) < 1e-9 * size / span
    assert abs((rear - front) * span / 2 + (pins * z).sum()) < 1e-9 * size
    assert crank_unbalance(M_eq=M_eq, r=r, theta_0=theta_0, phi=phi) == pytest.approx(pins.sum(), abs=1e-12 * size)
    assert crank_product(M_eq=M_eq, r=r, theta_0=theta_0, z=z, phi=phi) == pytest.approx(
        (pins * z).sum(), abs=1e-12 * size
    )


@settings(max_examples=20, deadline=None)
@given(
    cylinders=st.integers(2, 12), strokes=st.sampled_from([2, 4]), lam=st.floats(0.05, 0.4), pitch=st.floats(0.05, 0.5)
)
def test_even_firing_leaves_forces_of_the_firing_frequency_only(cylinders, strokes, lam, pitch):
    """Inline engines: forces of order n are N times one cylinder's where n is a multiple of 2·N/strokes, and zero
    elsewhere."""
    _, e, found = solved(
        ImbalanceInputs(crank_balance_fraction=0.0),
        cylinders=cylinders,
        strokes=strokes,
        firing_order=None,
        rod_length=0.0535 / lam,
        cylinder_pitch=pitch,
    )
    for n, (forward, backward, _, _) in enumerate(vectors(found), 1):
        expected = (
            cylinders * found.one_force * abs(e.harmonics[n - 1]) / 2 if n * strokes % (2 * cylinders) == 0 else 0.0
        )
        for F in (forward, backward):
            assert abs(F) == pytest.approx(expected, abs=1e-8 * found.one_force * cylinders), n


@settings(max_examples=60, deadline=None)
@given(C=st.floats(0.1, 1e4), late=st.floats(-math.pi, math.pi), z=st.integers(8, 200))
def test_two_equal_couples_out_of_phase_leave_twice_the_sine_of_half_their_angle(C, late, z):
    """|C − C·e^(iΔφ)| = 2·C·|sin(Δφ/2)|: of backlash, per degree and per tooth of mistiming; of forces alike."""
    left = abs(C - C * np.exp(1j * late))
    assert abs(residual_couple(C=C, Delta_phi=late)) == pytest.approx(left, rel=1e-9, abs=1e-12 * C)
    degree, tooth = (
        pytest.approx(abs(C - C * np.exp(1j * angle)), rel=1e-9) for angle in (math.radians(1), 2 * math.pi / z)
    )
    assert f.couple_per_degree(C_S=C) == degree and f.couple_per_tooth(C_S=C, z=float(z)) == tooth
    assert f.force_per_degree(F_S=C) == degree and f.force_per_tooth(F_S=C, z=float(z)) == tooth
