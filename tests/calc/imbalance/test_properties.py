"""What holds for any engine, whatever its cylinders, throws and banks."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.engine import solve as engine
from calc.imbalance import solve as imbalance
from calc.imbalance.inputs import ImbalanceInputs
from tests.calc.imbalance.engines import fans, solved

TWO_PI = 2 * np.pi


def motion(inputs, e, theta):
    """Force on the block and couple of all reciprocating masses at crank angles after TDC of cylinder 1, straight from
    the kinematics."""
    r, L, d, w = inputs.crank_radius, inputs.rod_length, inputs.cylinder_offset, TWO_PI * inputs.rated_speed
    force = couple = 0
    psi = [(-1 if bank == 0 else 1) * inputs.bank_angle / 2 for bank in inputs.bank_of_cylinder]
    start = psi[0] + np.arcsin(d / (L + r))
    for phi, z, bank in zip(inputs.crank_angles, inputs.axial_positions, psi):
        a = theta + start + phi - bank
        sine = (r * np.sin(a) - d) / L
        cosine = np.sqrt(1 - sine**2)
        # second derivative of r·cos α + L·cos β towards the crank
        slope = r * np.cos(a) / (L * cosine)  # dβ/dα
        bend = (-r * np.sin(a) / L + sine * slope**2) / cosine
        acceleration = r * np.cos(a) + L * (cosine * slope**2 + sine * bend)
        one = e.reciprocating_mass * w**2 * acceleration * np.exp(1j * bank)
        force, couple = force + one, couple + z * one
    return force, couple


@settings(max_examples=60, deadline=None)
@given(fan=fans())
def test_each_order_is_the_fourier_coefficient_of_the_exact_motion(fan):
    inputs, e, i = solved(ImbalanceInputs(crank_balance_fraction=0.0), **fan)
    size = 1024
    force, couple = motion(inputs, e, np.arange(size) * TWO_PI / size)
    F, C = np.fft.fft(force) / size, np.fft.fft(couple) / size
    scale = e.reciprocating_mass * inputs.crank_radius * e.angular_speed**2 * inputs.cylinders
    for n in range(1, 9):
        order = i.orders.get(f"order_{n}")
        found = order.vectors if order else (0, 0, 0, 0)
        assert np.abs(np.array(found) - [F[n], F[-n], C[n], C[-n]]).max() < 1e-12 * scale


@settings(max_examples=30, deadline=None)
@given(fan=fans(), kappa=st.floats(-1, 2))
def test_counterweights_change_nothing_but_the_forward_first_order(fan, kappa):
    without, with_ = (solved(ImbalanceInputs(crank_balance_fraction=k), **fan)[2] for k in (0.0, kappa))
    for name, order in without.orders.items():
        assert order.vectors[1] == with_.orders[name].vectors[1] and order.vectors[3] == with_.orders[name].vectors[3]
        if name != "order_1":
            assert order.vectors == with_.orders[name].vectors


@settings(max_examples=30, deadline=None)
@given(fan=fans(offset=False), kappa=st.floats(-1, 2))
def test_the_crank_takes_its_share_of_what_turns_forward(fan, kappa):
    """(½ − κ)·ω²·Σ M_alt r e^{iφ} is left, whatever the layout: nothing at ½ (centred cylinders)."""
    inputs, e, i = solved(ImbalanceInputs(crank_balance_fraction=kappa), **fan)
    start = e.crank.theta_0
    whole = e.reciprocating_mass * inputs.crank_radius * e.angular_speed**2
    expected = (0.5 - kappa) * whole * np.sum(np.exp(1j * (start + np.array(inputs.crank_angles))))
    assert abs(i.orders["order_1"].vectors[0] - expected) < 2e-9 * whole * inputs.cylinders


@settings(max_examples=30, deadline=None)
@given(fan=fans(), shift=st.floats(-0.5, 0.5))
def test_a_couple_about_another_plane_differs_by_force_times_distance(fan, shift):
    there = {**fan, "axial_positions": tuple(z + shift for z in fan["axial_positions"])}
    one, other = solved(**fan)[2], solved(**there)[2]
    scale = one.one_force * len(fan["axial_positions"])
    for name, order in one.orders.items():
        F_f, F_b, C_f, C_b = order.vectors
        assert abs(other.orders[name].vectors[2] - (C_f + shift * F_f)) < 1e-8 * scale
        assert abs(other.orders[name].vectors[3] - (C_b + shift * F_b)) < 1e-8 * scale


@pytest.mark.parametrize("order, cylinders", [((1, 3, 2), 3), ((1, 2, 4, 5, 3), 5), ((1, 3, 4, 2), 4)])
def test_without_a_force_the_couple_does_not_know_its_origin(order, cylinders):
    z = tuple(0.112 * k for k in range(cylinders))
    here = solved(firing_order=order, cylinders=cylinders, axial_positions=z)[2]
    there = solved(firing_order=order, cylinders=cylinders, axial_positions=tuple(x + 0.4 for x in z))[2]
    for name, found in here.orders.items():
        if not found.force_peak:
            assert np.abs(np.array(found.vectors[2:]) - there.orders[name].vectors[2:]).max() < 1e-9 * here.one_couple


@settings(max_examples=30, deadline=None)
@given(fan=fans())
def test_seen_from_the_other_end_the_couples_change_sign(fan):
    one = solved(**fan)[2]
    other = solved(**{**fan, "axial_positions": tuple(-z for z in fan["axial_positions"])})[2]
    for name, order in one.orders.items():
        F_f, F_b, C_f, C_b = order.vectors
        assert other.orders[name].vectors == (F_f, F_b, -C_f, -C_b)


@settings(max_examples=30, deadline=None)
@given(fan=fans())
def test_a_mirrored_engine_turns_mirrored_vectors(fan):
    """Throws, banks and offset reflected at the vertical plane: every vector becomes its conjugate."""
    mirrored = {
        **fan,
        "crank_angles": tuple(-phi for phi in fan["crank_angles"]),
        "cylinder_offset": -fan["cylinder_offset"],
        "bank_of_cylinder": tuple(1 - bank for bank in fan["bank_of_cylinder"]),
    }
    one, other = solved(**fan)[2], solved(**mirrored)[2]
    scale = one.one_force * len(fan["axial_positions"])
    for name, order in one.orders.items():
        assert np.abs(np.conj(order.vectors) - other.orders[name].vectors).max() < 1e-9 * scale


@settings(max_examples=30, deadline=None)
@given(fan=fans())
def test_the_ellipse_holds_the_path(fan):
    """Largest and smallest distance of the path from its middle, and the direction of the largest."""
    i = solved(**fan)[2]
    turn = np.linspace(0, TWO_PI, 3601)
    for name, order in i.orders.items():
        n = int(name[6:])
        path = order.vectors[0] * np.exp(1j * n * turn) + order.vectors[1] * np.exp(-1j * n * turn)
        assert np.abs(path).max() == pytest.approx(order.force_peak, rel=1e-4, abs=1e-9)
        assert np.abs(path).min() >= order.force_least - 1e-6 * order.force_peak
        assert np.abs(path.real).max() == pytest.approx(order.force_peak_vertical, rel=1e-4, abs=1e-9 * i.one_force)
        if order.force_axis is not None:
            top = path[np.abs(path).argmax()] * np.exp(-1j * order.force_axis)
            assert abs(top.imag) < 0.1 * abs(top.real) or order.force_least > 0.9 * order.force_peak


@settings(max_examples=10, deadline=None)
@given(fan=fans(), seed=st.integers(0, 9))
def test_many_engines_at_once_are_the_same_as_one_by_one(fan, seed):
    random, count = np.random.default_rng(seed), 4
    inputs, _, _ = solved(**fan)
    varied = dict(
        piston_mass=random.uniform(0.3, 2, count),
        rated_speed=random.uniform(10, 100, count),
        crank_radius=random.uniform(0.03, 0.06, count),
        cylinder_offset=random.uniform(-0.01, 0.01, count),
        crank_angles=random.uniform(0, 6, (count, inputs.cylinders)),
        bank_angle=random.uniform(0.2, 3, count),
    )
    cranks = replace(ImbalanceInputs(), crank_balance_fraction=random.uniform(0, 1, count))
    many = replace(inputs, **varied)
    e = engine.values(many)
    together = imbalance.values(cranks, many, e)
    for k in range(count):
        single = replace(inputs, **{name: tuple(x[k]) if x.ndim > 1 else x[k].item() for name, x in varied.items()})
        e_k = engine.values(single)
        alone = imbalance.values(
            replace(cranks, crank_balance_fraction=cranks.crank_balance_fraction[k].item()), single, e_k
        )
        assert e.acceleration_max[k] == pytest.approx(e_k.acceleration_max, rel=1e-12)
        scale = alone.one_force * inputs.cylinders
        for name, order in alone.orders.items():
            found = [np.broadcast_to(v, count)[k] for v in together.orders[name].vectors]
            assert np.abs(np.array(order.vectors) - found).max() < 2e-9 * scale
        assert together.required_couple[k] == pytest.approx(alone.required_couple, rel=1e-10, abs=1e-9 * scale)
