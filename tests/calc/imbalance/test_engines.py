"""Free forces and couples of many engines beside published values, and what must hold for any engine."""

import math
import tomllib
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.engine.inputs import EngineInputs
from calc.engine.solve import solve as solve_engine
from calc.imbalance.inputs import ImbalanceInputs
from calc.imbalance.solve import solve as solve_imbalance
from tests.calc.imbalance.engines import R753, solved
from tests.calc.imbalance.test_properties import motion

ROWS = tomllib.loads((Path(__file__).parents[2] / "reference" / "balance.toml").read_text(encoding="utf-8"))["row"]


@pytest.mark.parametrize("row", ROWS, ids=[r["engine"] for r in ROWS])
def test_published_engine(row):
    changes = dict(
        layout=row.get("layout", "inline"),
        cylinders=len(row["z"]),
        bank_of_cylinder=tuple(row["bank"]),
        rod_length=0.163,
        axial_positions=tuple(0.112 * z for z in row["z"]),
        firing_order=tuple(row["order"]) if "order" in row else None,
        crank_angles=tuple(math.radians(p) for p in row["phi"]) if "phi" in row else None,
        cylinder_offset=0.0,
        bank_angle=math.radians(row.get("bank_angle", 0)),
    )
    engine, e, i = solved(ImbalanceInputs(crank_balance_fraction=0.0, kinematics="two_term"), **changes)
    scale = e.reciprocating_mass * engine.crank_radius * e.angular_speed**2
    for name, unit in (("first", scale), ("second", scale * e.lambda_)):
        order = i.orders["order_1" if name == "first" else "order_2"]
        found = [abs(order.force_forward) / unit, abs(order.force_backward) / unit]
        found += [abs(order.couple_forward) / unit / 0.112, abs(order.couple_backward) / unit / 0.112]
        assert found == pytest.approx(row[name], abs=1e-4)


GIVEN = [row for row in ROWS if "phi" in row]


@pytest.mark.parametrize("row", GIVEN, ids=[r["engine"] for r in GIVEN])
def test_published_engine_in_phase(row):
    """Modulus and phase of the same engines against the Fourier coefficients of their exact motion."""
    n = len(row["z"])
    engine, e, i = solved(
        ImbalanceInputs(crank_balance_fraction=0.0),
        layout="vee",
        cylinders=n,
        firing_order=None,
        bank_of_cylinder=tuple(row["bank"]),
        axial_positions=tuple(0.112 * z for z in row["z"]),
        crank_angles=tuple(math.radians(p) for p in row["phi"]),
        bank_angle=math.radians(row.get("bank_angle", 180 if row.get("layout") == "boxer" else 0)),
    )
    force, couple = motion(engine, e, np.arange(256) * 2 * np.pi / 256)
    F, C = np.fft.fft(force) / 256, np.fft.fft(couple) / 256
    for order in (1, 2):
        expected = [F[order], F[-order], C[order], C[-order]]
        assert np.abs(np.array(i.orders[f"order_{order}"].vectors) - expected).max() < 1e-10 * i.one_force


@pytest.mark.parametrize(
    "fraction, forward, vertical, horizontal",
    [(0.0, 572.932, 1145.864, 0.0), (0.5, 0.0, 572.932, 572.932), (1.0, 572.932, 0.0, 1145.864)],
)
def test_r753_first_order(fraction, forward, vertical, horizontal):
    """Finotti 2013, 2.5.3: 572.93 N·m; the share on the crank moves the forward vector only."""
    order = solved(ImbalanceInputs(crank_balance_fraction=fraction))[2].orders["order_1"]
    assert order.couple_forward == pytest.approx(forward, abs=5e-4)
    assert order.couple_backward == pytest.approx(572.932, abs=5e-4)
    assert order.couple_peak_vertical == pytest.approx(vertical, abs=1e-3)
    assert order.couple_peak_horizontal == pytest.approx(horizontal, abs=1e-3)
    assert math.degrees(order.couple_backward_phase) == pytest.approx(-150)


def test_r753_needs_572_newton_metres_at_30_degrees():
    i = solved()[2]
    assert i.required_couple == pytest.approx(572.932, abs=5e-4)
    assert math.degrees(i.required_couple_phase) == pytest.approx(30)
    assert i.required_unbalance_product * 1e6 == pytest.approx(7728.57, abs=5e-3)


@pytest.mark.parametrize("rpm, couple", [(1000, 84.753), (1500, 190.695), (2000, 339.013)])
def test_the_couple_grows_with_the_square_of_the_speed(rpm, couple):
    assert solved(rated_speed=rpm / 60)[2].required_couple == pytest.approx(couple, abs=5e-4)


def test_second_order_is_376_with_two_terms_and_387_exact_not_188():
    """The thesis prints 188.05 N·m: it leaves out the half that the crank balances, which order 2 does not know."""
    order = solved()[2].orders["order_2"]
    assert order.two_term.couple_peak_vertical == pytest.approx(376.096, abs=5e-4)
    assert order.couple_peak_vertical == pytest.approx(386.77, abs=5e-3)
    assert order.couple_peak_horizontal == pytest.approx(0, abs=1e-9)


def test_source_value_of_the_second_order_is_shown_beside():
    engine = EngineInputs(**R753)
    outcome = solve_imbalance(ImbalanceInputs(), engine, solve_engine(engine).result)
    (erratum,) = outcome.errata
    assert erratum.source_value == pytest.approx(188.05, abs=5e-3)  # Finotti 2013, 2.5.3.4
    assert erratum.about == "imbalance.order_2.couple_peak_vertical"


def test_order_two_does_not_know_the_counterweights():
    assert (
        len(
            {
                solved(ImbalanceInputs(crank_balance_fraction=k))[2].orders["order_2"].couple_peak_vertical
                for k in (0.0, 0.5, 1.0)
            }
        )
        == 1
    )


angle = st.floats(0, 2 * math.pi)


@settings(max_examples=40, deadline=None)
@given(
    phi=st.lists(angle, min_size=1, max_size=8),
    data=st.data(),
    offset=st.floats(-0.006, 0.006),
    kappa=st.floats(0, 1),
    bank=st.floats(0.1, 3.0),
)
def test_phasors_equal_the_time_domain(phi, data, offset, kappa, bank):
    """Any fan of cylinders with offset: the sum of the orders is the sum of the cylinders' forces at every crank
    angle."""
    n = len(phi)
    banks = data.draw(st.lists(st.integers(0, 1), min_size=n, max_size=n))
    z = data.draw(st.lists(st.floats(-1, 1), min_size=n, max_size=n))
    engine, e, i = solved(
        ImbalanceInputs(crank_balance_fraction=kappa),
        layout="vee",
        cylinders=n,
        crank_angles=tuple(phi),
        bank_of_cylinder=tuple(banks),
        bank_angle=bank,
        axial_positions=tuple(z),
        cylinder_offset=offset,
        firing_order=None,
    )
    turn = np.linspace(0, 2 * np.pi, 37)
    force, couple = np.zeros(turn.size, complex), np.zeros(turn.size, complex)
    psi = np.where(np.array(banks) == 1, bank / 2, -bank / 2)
    m, r, w = e.reciprocating_mass, engine.crank_radius, e.angular_speed
    for k in range(n):
        theta = turn + e.crank.theta_0
        alpha = theta + phi[k] - phi[0] - psi[k]  # crank angles are counted from cylinder 1
        beta = np.arcsin(e.lambda_ * np.sin(alpha) - e.delta)
        a = np.cos(alpha) - np.sin(alpha) * np.tan(beta) + e.lambda_ * np.cos(alpha) ** 2 / np.cos(beta) ** 3
        # orders above 8 are not part of the result
        a -= np.real(sum(c * np.exp(1j * order * alpha) for order, c in higher(e).items()))
        f = m * r * w**2 * (a * np.exp(1j * psi[k]) - kappa * np.exp(1j * (theta + phi[k] - phi[0])))
        force += f
        couple += z[k] * f
    found_force, found_couple = np.zeros(turn.size, complex), np.zeros(turn.size, complex)
    for name, order in i.orders.items():
        o = int(name.split("_")[1])
        F_f, F_b, C_f, C_b = order.vectors
        found_force += F_f * np.exp(1j * o * turn) + F_b * np.exp(-1j * o * turn)
        found_couple += C_f * np.exp(1j * o * turn) + C_b * np.exp(-1j * o * turn)
    scale = m * r * w**2 * n
    assert np.abs(found_force - force).max() < 1e-8 * scale
    assert np.abs(found_couple - couple).max() < 1e-8 * scale


def higher(e):
    """The harmonics above order 8 of the exact acceleration."""
    alpha = np.arange(720) * 2 * np.pi / 720
    beta = np.arcsin(e.lambda_ * np.sin(alpha) - e.delta)
    a = np.cos(alpha) - np.sin(alpha) * np.tan(beta) + e.lambda_ * np.cos(alpha) ** 2 / np.cos(beta) ** 3
    spectrum = np.fft.rfft(a) * 2 / 720
    return {n: spectrum[n] for n in range(9, 60)}


@settings(max_examples=25, deadline=None)
@given(factor=st.floats(0.2, 5))
def test_doubling_the_speed_quadruples_everything(factor):
    one, other = solved()[2], solved(rated_speed=factor * 2600 / 60)[2]
    for name, order in one.orders.items():
        assert other.orders[name].couple_peak_vertical == pytest.approx(
            factor**2 * order.couple_peak_vertical, rel=1e-9, abs=1e-9
        )


def test_what_an_inline_four_leaves_is_seen():
    """Its second-order force is whole; the couples are zero."""
    engine = EngineInputs(**{**R753, "cylinders": 4, "firing_order": (1, 3, 4, 2)})
    outcome = solve_imbalance(ImbalanceInputs(), engine, solve_engine(engine).result)
    verdicts = {c.id: c.verdict for c in outcome.checks}
    assert verdicts["imbalance.order_2.force"] == "note" and verdicts["imbalance.order_2.couple"] == "pass"


def test_a_vee_engine_pairs_its_cylinders_by_bank():
    """V6 90°, three pins: √3 and no backward couple, however the cylinders are numbered."""
    degrees = (0, 240, 120, 0, 240, 120)
    _, _, i = solved(
        ImbalanceInputs(crank_balance_fraction=0.0),
        layout="vee",
        cylinders=6,
        bank_angle=math.pi / 2,
        firing_order=None,
        crank_angles=tuple(map(math.radians, degrees)),
        bank_of_cylinder=(0, 0, 0, 1, 1, 1),
    )
    first = i.orders["order_1"]
    assert first.couple_forward / i.one_couple == pytest.approx(math.sqrt(3))
    assert first.couple_backward == pytest.approx(0, abs=1e-6)
