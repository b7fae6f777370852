# SPDX-License-Identifier: Apache-2.0
"""A train over speed and load: what is published, against the motion followed event by event and worked out beside."""

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from scipy.optimize import brentq

from calc.gears.drive.inputs import DriveInputs, IrregularityRow
from calc.gears.drive.line import ShaftBody
from calc.gears.drive.result import HARDEST, IDLE, IDLE_FULL, RATED
from calc.gears.drive.solve import drags_of
from calc.sheet.value import link_of
from tests.calc.gears.drive import event_solver as solver
from tests.calc.gears.drive.at_work import driven, on_shaft, with_drag, work
from tests.calc.gears.drive.test_bodies import behind_a_chain, two_shafts
from tests.calc.gears.trains import r753, shown, solved

J_S = 6.46e-3
MESHES = ("crank_central", "central_idler", "idler_shaft")
DRAG = (("shaft", 900, 0.225), ("shaft", 2600, 0.808), ("idler", 900, 0.02), ("central", 2600, 0.03))


@cache
def with_gas():
    """The R753 with gas and a flywheel of 0.9 kg·m²: outcome."""
    return driven(on_shaft(J_S), with_drag(r753(), *DRAG), None, None, flywheel=0.9)


def cut_series(drive, op):
    """Orders on the crank, x'' of the crank's wheel in m/s² and ω at a published point, from the torque itself."""
    p = drive.at[op]
    n, load = drive.survey.speeds[p], drive.survey.loads[p]
    torque = drive.drive.source.torque(np.array([n]), np.array([load]))
    r_b = drive.drive.line.first_radius
    return torque.orders, r_b * torque.t[0] / float(drive.inertia_total), 2 * math.pi * n


def behind(drive, key, op):
    """M and D of a mesh with all behind it, on a train of one way whose wheels have one pitch: plain sums."""
    line, p = drive.drive.line, drive.at[op]
    return (
        sum(line.J[k] / line.radius[k] ** 2 for k in range(line.index(key), len(line.links))),
        sum(float(drive.survey.bodies.drag[p, k]) for k in range(line.index(key), len(line.links))),
    )


@pytest.mark.parametrize("op", [IDLE, IDLE_FULL, RATED, HARDEST])
def test_closed_flanks_over_the_cycle(op):
    """D + M·x'' at four thousand angles."""
    drive = with_gas().solution
    n, a, _ = cut_series(drive, op)
    wave = (a @ np.exp(1j * np.multiply.outer(n, np.linspace(0, 4 * math.pi, 4321)))).real
    for key in MESHES:
        (M, D), at = behind(drive, key, op), drive.meshes[key].operations[op]
        assert at.least_force == pytest.approx(D + M * wave.min(), rel=1e-3)
        assert at.most_force == pytest.approx(D + M * wave.max(), rel=1e-3)
        assert at.separation == pytest.approx(-M * wave.min() / D, rel=1e-3)


def test_drags_are_measured_between_their_rows():
    drive = with_gas().solution
    radius = {link.driven: r for link, r in zip(drive.drive.line.links, drive.drive.line.radius)}
    for rpm, shaft in ((900, 0.225), (2600, 0.808), (1750, 0.5165)):
        of = drive.drive.drags.at(np.array([rpm / 60]))[0]
        expected = [0.03 / radius["central"], 0.02 / radius["idler"], shaft / radius["shaft"]]
        assert of == pytest.approx(expected, rel=1e-9)


def of_event_solver(drive, op):
    """Strikes of every body in the backlash of its way, event by event: of each its M, orbit and length."""
    n, a, omega = cut_series(drive, op)
    period = 4 * math.pi / 3 / omega
    found, J = {}, 0.0
    for i, key in enumerate(MESHES):
        J += drive.drive.line.play["nominal"][i]
        M, D = behind(drive, key, op)
        strikes, T_o, _ = solver.orbit(solver.Driver(n * omega, a, period), D / M, J)
        found[key] = M, strikes, T_o, J
    return found


@pytest.mark.parametrize("op", [IDLE, RATED])
def test_strikes_event_by_event(op):
    """Of a mesh the hardest strike of its own body and of those behind; power of its own; per working cycle."""
    drive = with_gas().solution
    bodies = of_event_solver(drive, op)
    for i, key in enumerate(MESHES):
        at = drive.meshes[key].operations[op]
        speeds = [max(abs(strike.speed) for strike in bodies[other][1]) for other in MESHES[i:]]
        assert at.impact_speed == pytest.approx(max(speeds), rel=1e-3)
        M, strikes, T_o, _ = bodies[key]
        assert at.impact_power == pytest.approx(M / (2 * T_o) * sum(s.speed**2 for s in strikes), rel=2e-3)
        assert (at.impacts, at.flanks) == (6, 2)
    totals = [sum(drive.meshes[key].operations[x].impact_power for key in MESHES) for x in (IDLE, HARDEST)]
    assert drive.impact_power == pytest.approx(max(totals), rel=1e-9)
    if op == IDLE:
        assert drive.impact_speed == max(drive.meshes[key].operations[IDLE].impact_speed for key in MESHES)


def force(M, strikes, stiffness):
    """The largest over all strikes of F = M|p| + √((M|p|)² + k(F)·M·u²)."""
    by_one = []
    for s in strikes:
        m, u = M * abs(s.press), abs(s.speed)
        by_one.append(brentq(lambda F, m=m, u=u: m + math.sqrt(m**2 + stiffness(F) * M * u**2) - F, 1e-3, 1e7))
    return max(by_one)


def test_forces_of_the_strikes():
    """High: through the teeth of the one mesh; low: through those of all meshes of the way."""
    drive = with_gas().solution
    line, bodies = drive.drive.line, of_event_solver(drive, IDLE)

    def k(i, F):
        return line.width[i] * line.stiffness[i] * min(1.0, F / line.width[i] / 100e3) ** 0.25

    for i, key in enumerate(MESHES):
        at = drive.meshes[key].operations[IDLE]
        high = max(force(M, strikes, lambda F, i=i: k(i, F)) for M, strikes, *_ in (bodies[x] for x in MESHES[i:]))
        assert at.impact_force == pytest.approx(high, rel=2e-3)
        low = []
        for d in range(i, 3):
            M, strikes, *_ = bodies[MESHES[d]]
            low.append(force(M, strikes, lambda F, d=d: 1 / sum(1 / k(x, F) for x in range(d + 1))))
        assert at.impact_force_low == pytest.approx(max(low), rel=2e-3)


def test_the_hardest_point_is_that_of_the_largest_force():
    drive = with_gas().solution
    source, of = drive.drive.source, drive.survey
    assert len(of.speeds) == 12 * 3 and set(of.loads) == {0.0, 0.5, 1.0}
    assert (of.speeds.min() * 60, of.speeds.max() * 60) == pytest.approx((900, 2600))
    one_by_one = [
        drive.drive.survey(np.array([n]), np.array([load])).impacts.high.max() for n, load in zip(of.speeds, of.loads)
    ]
    p = int(np.argmax(one_by_one))
    assert (drive.hardest_speed, drive.hardest_load) == (of.speeds[p], of.loads[p])
    assert max(mesh.operations[HARDEST].impact_force for mesh in drive.meshes.values()) == pytest.approx(
        max(one_by_one)
    )
    assert source.J_E is not None and not drive.assumed


def test_the_largest_backlash_has_less_drag():
    """_most: that of the largest backlash, with 0.7 of the drag."""
    drive = with_gas().solution
    at = drive.meshes["idler_shaft"].operations[IDLE]
    M, D = behind(drive, "idler_shaft", IDLE)
    assert at.least_force_most == pytest.approx(at.least_force - 0.3 * D, rel=1e-9)
    assert at.separation_most == pytest.approx(at.separation / 0.7, rel=1e-9)
    n, a, omega = cut_series(drive, IDLE)
    driver = solver.Driver(n * omega, a, 4 * math.pi / 3 / omega)
    strikes, _, _ = solver.orbit(driver, 0.7 * D / M, sum(drive.drive.line.play["most"]))
    assert at.impact_speed_most == pytest.approx(max(abs(s.speed) for s in strikes), rel=1e-3)


def test_every_value_says_where_it_comes_from():
    outcome = with_gas()
    assert [value.id for value in outcome.values() if link_of(value.inside) is None] == [
        "gears.idle_speed",
        "gears.assumed",
    ]


# --- laws of whole trains


def numbers(outcome):
    """What is published, by ids; None left out."""
    every = {id: value for id, value in shown(outcome).items() if value is not None}
    for key, mesh in outcome.solution.meshes.items():
        for op, at in mesh.operations.items():
            every |= {f"{key}.{op}.{name}": getattr(at, name) for name in type(at).__dataclass_fields__}
        every |= {f"{key}.{name}": getattr(mesh, name) for name in ("reversal_from", "reversal_to", "order")}
    return every


def test_the_order_in_the_file_does_not_matter():
    gears = with_drag(two_shafts(), ("left", 900, 0.1), ("right", 900, 0.2), ("last", 900, 0.1))
    turned = replace(gears, wheels=gears.wheels[::-1], meshes=gears.meshes[::-1])
    one, other = (numbers(driven({}, of, 0.03, 2.0)) for of in (gears, turned))
    assert set(one) == set(other) and one["right_last.idle.impact_speed"] > 0
    assert other == {id: value if value is None else pytest.approx(value, rel=1e-9) for id, value in one.items()}


def test_a_mirrored_shaft_has_the_same_values():
    gears = two_shafts()
    gears = replace(gears, wheels=gears.wheels[:4], meshes=gears.meshes[:3])
    gears = with_drag(gears, ("left", 900, 0.1), ("right", 900, 0.1))
    found = driven({}, gears, 0.03, 2.0).solution.meshes
    left, right = found["idler_left"].operations, found["idler_right"].operations
    assert left[IDLE].impact_speed > 0
    for op, at in left.items():
        for name in type(at).__dataclass_fields__:
            assert getattr(at, name) == pytest.approx(getattr(right[op], name), rel=1e-9), (op, name)


def test_behind_a_chain_the_motion_goes_on():
    """A chain has neither backlash nor values; the meshes behind it see the crank's motion by its ratio."""
    shafts = on_shaft(J_S)
    plain, chained = (driven(shafts, gears, 0.02, 1.5).solution for gears in (r753(), behind_a_chain()))
    assert chained.meshes.keys() == plain.meshes.keys() == set(MESHES)
    line, of = chained.drive.line, chained.survey
    first, i = line.index("chain"), line.index("idler_shaft")
    assert not of.closed.parts[:, first].any() and of.closed.parts[:, i].all()
    assert of.strikes.backlash[0, i] == pytest.approx(sum(plain.drive.line.play["nominal"]), rel=1e-12)
    at, alone = (drive.meshes["idler_shaft"].operations[IDLE] for drive in (chained, plain))
    assert at.least_force == pytest.approx(
        2 * alone.least_force, rel=1e-9
    )  # the nose turns the crank at twice its speed
    assert chained.meshes["crank_central"].order == pytest.approx(2 * plain.meshes["crank_central"].order)
    assert 1 < at.impact_speed / alone.impact_speed < 2


def test_meshes_that_jam_do_not_strike():
    """Where the smallest backlash is below 0 nothing flies in it, and it takes nothing from the others'."""
    tight = tuple(replace(m, centre_distance=m.centre_distance and m.centre_distance - 3e-4) for m in r753().meshes)
    drive = driven(on_shaft(J_S), replace(r753(), meshes=tight), 0.02, 1.5).solution
    line = drive.drive.line
    assert [j > 0 for j in line.play["least"]] == [True, False, True]
    of = drive.drive.survey(*drive.drive.source.points(), "least")
    assert all(np.isfinite(getattr(of.impacts, name)).all() for name in ("speed", "low", "high", "power"))
    assert not of.strikes.hardest[:, 1].any() and of.strikes.hardest[:, [0, 2]].all()
    assert of.strikes.backlash[:, 2] == pytest.approx(line.play["least"][0] + line.play["least"][2])


def test_gravity_of_a_shaft_loads_its_mesh():
    """T_g = U·g·sin θ by the place of its mass, at every angle of the crank."""
    U, angle = 0.0108, math.radians(30.0)
    gears = with_drag(r753(), ("shaft", 900, 0.225))
    drive = driven({"shaft": ShaftBody(J_S, True, U, angle, 1.0)}, gears, 0.01, 1.5).solution
    at, plain = drive.meshes["idler_shaft"].operations[IDLE], driven(on_shaft(J_S), gears, 0.01, 1.5).solution
    r_b, epsilon = drive.drive.line.radius[-1], np.linspace(0, 4 * math.pi, 14401)
    alpha = 0.01 / 2 * 1.5 * (2 * math.pi * 2600 / 60) ** 2 * np.cos(1.5 * epsilon)
    torque = 0.225 + J_S * alpha - U * 9.80665 * np.sin(epsilon + angle)
    assert at.least_force == pytest.approx(torque.min() / r_b, rel=1e-3)
    assert at.most_force == pytest.approx(torque.max() / r_b, rel=1e-3)
    without = plain.meshes["idler_shaft"].operations[IDLE]
    assert at.separation == without.separation and at.least_force < without.least_force - 1.0


def test_where_the_flanks_part():
    """A drag that rises in a straight line, a motion that is the same at every speed: one speed where both are equal."""
    delta = 0.004
    J_alpha = J_S * delta / 2 * 1.5 * (2 * math.pi * 2600 / 60) ** 2
    half = 1750.0
    gears = with_drag(r753(), ("shaft", 900, 0.0), ("shaft", 2600, 2 * J_alpha))
    mesh = driven(on_shaft(J_S), gears, delta, 1.5).solution.meshes["idler_shaft"]
    assert mesh.reversal_from * 60 == pytest.approx(900) and mesh.reversal_to * 60 == pytest.approx(half, rel=1e-9)
    strong = with_drag(r753(), ("shaft", 900, 1.5 * J_alpha))
    closed = driven(on_shaft(J_S), strong, delta, 1.5).solution.meshes["idler_shaft"]
    assert (closed.reversal_from, closed.reversal_to) == (None, None)
    assert closed.operations[HARDEST].impact_speed == closed.operations[HARDEST].impacts == 0


# --- where the motion comes from


def test_a_default_irregularity_is_assumed():
    """0.05 of three cylinders at idle, one load; the same acceleration at every speed."""
    drive = driven(on_shaft(J_S), delta=None, order=None).solution
    assert drive.assumed and drive.inertia_total is None
    alpha = 0.05 / 2 * 1.5 * (2 * math.pi * 15.0) ** 2
    for op in (IDLE, RATED):
        at = drive.operations[op]
        assert (at.acceleration_up, at.acceleration_down) == (
            pytest.approx(alpha, rel=1e-3),
            pytest.approx(-alpha, rel=1e-3),
        )
    assert drive.operations[IDLE].irregularity == pytest.approx(0.05, rel=1e-3)
    assert IDLE_FULL not in drive.at and set(drive.survey.loads) == {0.0}


def test_rows_of_an_irregularity_come_before_gas_and_flywheel():
    rows = tuple(IrregularityRow(speed=n / 60, delta=d) for n, d in ((900, 0.03), (2600, 0.01)))
    gears = replace(r753(), drive=DriveInputs(irregularity=rows))
    drive = driven(on_shaft(J_S), gears, None, None, flywheel=0.9).solution
    assert not drive.assumed and drive.inertia_total is None
    assert drive.operations[IDLE].irregularity == pytest.approx(0.03, rel=1e-3)
    assert drive.operations[RATED].irregularity == pytest.approx(0.01, rel=1e-3)


class Friction:
    """A balance whose journals have no film below half of its speed."""

    total_loss = 100.0

    def drags(self, ratio):
        return {"shaft": np.where(ratio < 0.5, np.nan, ratio), "idler": np.full(ratio.size, np.nan)}

    def loss_on(self, key, P, b):
        return 0.1 * P


def test_a_drag_that_has_no_film_is_that_of_the_nearest_speed():
    gears = with_drag(r753(), ("central", 900, 0.3))
    train = solved(gears)
    at_work = work(on_shaft(J_S), friction=Friction())
    line = driven(on_shaft(J_S)).solution.drive.line
    drags = drags_of(at_work, gears, line)
    ratio = drags.speeds / (2600 / 60)
    assert ratio[0] == pytest.approx(900 / 2600) and ratio[-1] == pytest.approx(1.0) and len(ratio) == 7
    r = {name: train.wheels[name].base_diameter / 2 for name in ("central", "idler", "shaft")}
    least = ratio[ratio >= 0.5].min()
    assert drags.of[:, 2] == pytest.approx(np.maximum(ratio, least) / r["shaft"], rel=1e-12)
    assert not drags.of[:, 1].any() and drags.of[:, 0] == pytest.approx(0.3 / r["central"])
    assert drags_of(replace(at_work, friction=None), r753(), line) is None
