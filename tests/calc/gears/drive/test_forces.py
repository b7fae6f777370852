# SPDX-License-Identifier: Apache-2.0
"""Forces of strikes, what each mesh has of them, and the given values (tests/reference/drive.json: an oracle of the
method that went event by event; closed forms)."""

import math
from dataclasses import replace

import numpy as np
import pytest

from calc.gears.drive.forces import (
    Impacts,
    at_point,
    forces_in,
    impacts,
    reduced_mass,
    stiffness_at,
    strike_force,
    whip_force,
)
from calc.gears.drive.strikes import (
    closed,
    fly,
    impact_power,
    least_force,
    quiet_backlash,
    quiet_backlashes,
    separation,
    speed_by_jerk,
)
from calc.sheet.value import link_of, trace
from tests.calc.gears.drive.lanes import given_of, golden, lane, motion, train
from tests.calc.gears.drive.test_strikes import random_lanes

OF_IMPACTS = dict(
    impact_force_low="low", impact_force="high", impact_power="power", impact_speed="speed", impacts="impacts",
    flanks="flanks", backlash_share="share",
)  # fmt: skip
OF_CLOSED = dict(separation="separation", least_force="least", most_force="most")


def solved(motion, bodies):
    of = closed(motion, bodies)
    strikes = fly(motion, bodies, of)
    return of, strikes, impacts(motion, bodies, of, strikes)


def force(M, u, p, b, c):
    """Of one strike, by iteration from 1 kN."""
    F = 1000.0
    for _ in range(60):
        F = strike_force(M, p, stiffness_at(F, b, c), u)
    return F


# --- given values


def meshes():
    """(row, quantity, mesh) of every row about a mesh whose parameters are those of a train here."""
    for row in golden():
        kind, _, name = row["id"].rpartition(".")
        if kind.startswith("gears.mesh_"):
            yield row, name, int(kind[-1]) - 1


def test_given_values_of_meshes():
    cases, asked = {}, 0
    for row, name, mesh in meshes():
        if row["case"] not in cases:
            m, bodies = lane(given_of(row["case"]))
            cases[row["case"]] = solved(m, bodies)
        of, _, found = cases[row["case"]]
        is_ = getattr(of, OF_CLOSED[name]) if name in OF_CLOSED else getattr(found, OF_IMPACTS[name])
        factor = 1e3 if name == "impact_speed" else 1.0
        assert is_[0, mesh] * factor == pytest.approx(row["is"], rel=row["rel"], abs=1e-12), (row["case"], row["id"])
        asked += 1
    assert asked == 48


def other(case):
    row = next(row for row in golden() if row["case"] == case)
    return row, row["given"]


def test_given_value_of_the_jerk_law():
    row, given = other("jerk law")
    u = speed_by_jerk(given["jerk_m_s3"], given["backlash_um"] * 1e-6)
    assert u * 1e3 == pytest.approx(row["is"], rel=row["rel"])


def test_given_values_of_one_strike():
    rows = [row for row in golden() if row["case"] == "force of a strike"]
    assert len(rows) == 2
    for row in rows:
        g = row["given"]
        F = force(g["mass_kg"], g["speed_m_s"], g["press_m_s2"], g["face_width_mm"] * 1e-3, g["c_gamma_100_GPa"] * 1e9)
        assert F == pytest.approx(row["is"], rel=row["rel"])


def test_given_value_of_a_resin_rim():
    row, g = other("resin rim on the shaft wheel, R753 idle")
    one = g["mass_kg"], g["speed_m_s"], g["press_m_s2"], g["face_width_mm"] * 1e-3
    c = g["c_gamma_100_GPa"] * 1e9
    assert force(*one, c * g["stiffness_factor"]) / force(*one, c) == pytest.approx(row["is"], rel=row["rel"])
    m, bodies = lane(given_of("R753 idle"))
    of, strikes, steel = solved(m, bodies)
    resin = impacts(m, bodies, of, strikes, factor=np.array([1.0, 1.0, g["stiffness_factor"]]))
    assert resin.high[0, 2] / steel.high[0, 2] == pytest.approx(row["is"], rel=2e-3)
    assert (resin.low < steel.low).all() and resin.high[0, 0] == steel.high[0, 0]
    assert (resin.speed == steel.speed).all()


def test_given_value_of_the_quiet_backlash():
    row, g = other("R753 idle: path backlash of the shaft at 35 mm/s")
    m, bodies = lane(given_of(g["see"]))
    J = quiet_backlash(m, bodies, 2, g["limit_mm_s"] * 1e-3)
    assert J * 1e6 == pytest.approx(row["is"], rel=row["rel"])


@pytest.mark.parametrize(
    "mass, drag, j, Gamma, low, high",
    [
        ([4 / 3, 4 / 3], [0.5, 16], [70, 70], [2.0, 1.05], [907, 413], [907, 864]),
        ([3, 1.3, 0.4], [3, 3, 1], [50, 70, 90], None, [961, 666, 332], [976, 1996, 1153]),
    ],
)
def test_given_trains_on_the_motion_of_the_inline_4(mass, drag, j, Gamma, low, high):
    """Printed to 1 N beside a chain of elastic teeth, which is not at hand."""
    m, _ = lane(given_of("inline 4, two shafts at 2x in a chain, idle"))
    n = len(mass)
    of, _, found = solved(m, train((-1, 0, 1)[:n], mass, [drag], np.array(j) * 1e-6, stiffness=np.full(n, 16.7e9)))
    assert found.low[0] == pytest.approx(low, rel=3e-3) and found.high[0] == pytest.approx(high, rel=3e-3)
    if Gamma:
        assert of.separation[0] == pytest.approx(Gamma, abs=0.05)


def test_both_grades_of_the_quiet_backlash():
    m, bodies = lane(given_of("R753 idle"))
    found = quiet_backlashes(m, bodies, 2, (35e-3, 70e-3))
    assert np.array(found) * 1e6 == pytest.approx([47.5, 198.0], abs=0.5)
    assert found[0] == pytest.approx(quiet_backlash(m, bodies, 2, 35e-3), rel=1e-12)


# --- laws of the force


def test_force_of_a_strike_agrees_with_its_own_stiffness():
    """All at once as one after the other; above 100 N/mm a spring that is linear, by energy."""
    m, bodies = random_lanes(40)
    _, strikes, found = solved(m, bodies)
    b, c = float(bodies.width[0]), float(bodies.stiffness[0])
    for i in range(40):
        pairs = zip(strikes.speed[i, 0].tolist(), strikes.press[i, 0].tolist())
        assert found.high[i, 0] == pytest.approx(max(force(2.0, u, p, b, c) for u, p in pairs if u), rel=1e-8)
    assert found.low == pytest.approx(found.high, rel=1e-12)  # one mesh, and none behind
    F = force(50.0, 0.08, 3.0, b, c)
    assert F / b > 1e5 and F**2 / (2 * b * c) == pytest.approx(50.0 * 0.08**2 / 2 + 50.0 * 3.0 * F / (b * c), rel=1e-9)
    assert force(0.4, 0.02, 0.0, b, c) == pytest.approx(
        (0.4 * 0.02**2 * b * c / (b * 1e5) ** 0.25) ** (4 / 7), rel=1e-9
    )


def test_mass_of_a_train_enters_force_by_its_root():
    """(M, D) together times 4: twice the force where teeth are stiff and nothing presses; never more than 4 times."""
    m, bodies = random_lanes(30)
    stiff = replace(bodies, width=np.array([1e-9]), stiffness=np.array([2e17]))  # far above 100 N/mm
    (_, strikes, found) = solved(m, stiff)
    (_, _, more) = solved(m, replace(stiff, mass=4 * stiff.mass, drag=4 * stiff.drag))
    bare = np.sqrt(2e8 * 2.0) * strikes.hardest
    assert (found.high >= bare * (1 - 1e-9)).all() and (found.high < 1.4 * bare).any()
    assert ((more.high >= 2 * found.high * (1 - 1e-9)) & (more.high < 4 * found.high)).all()


def test_teeth_in_series_give_way_more():
    """Low of a chain of like wheels: the mass of the last through n meshes, high through one; at a light load the force
    in series is (1/n)^(4/7) of that of one."""
    m = motion([[12.0]])
    bodies = train((-1, 0, 1), [1e-6, 1e-6, 2.0], [[0.0, 0.0, 1.0]], [0.0, 0.0, 90e-6])
    _, strikes, found = solved(m, bodies)
    u, p = strikes.speed[0, 2], strikes.press[0, 2]
    b, c = float(bodies.width[0]), float(bodies.stiffness[0])
    wanted = [max(force(2.0, float(u_), float(p_), b, c / n) for u_, p_ in zip(u, p) if u_) for n in (1, 3)]
    assert found.high[0] == pytest.approx([wanted[0]] * 3, rel=1e-6)
    assert found.low[0] == pytest.approx([wanted[1]] * 3, rel=1e-5)


def test_whip_is_its_own_fixed_point():
    for mu, u in ((0.3, 0.01), (0.3, 0.05), (5.0, 0.4)):
        F = whip_force(mu, u, 12e-3, 16e9)
        assert F == pytest.approx(2 * u * math.sqrt(stiffness_at(F, 12e-3, 16e9) * mu), rel=1e-12)
    assert reduced_mass(1.0, 3.0, 1.0) == pytest.approx(0.75)
    assert reduced_mass(1.0, 3.0, 2.0) == pytest.approx(1 / (1 + 4 / 3))
    # it governs a light wheel between heavy ones, not one that the crank's own wheel drives and that parts
    m = motion([[10.0]])
    bodies = train((-1, 0, 1), [3.0, 3.0, 0.5], [[1.0, 1.0, 1.0]], [60e-6, 60e-6, 60e-6])
    of, strikes, found = solved(m, bodies)
    hardest = float(strikes.hardest.max())
    assert found.high[0, 2] == pytest.approx(whip_force(reduced_mass(0.5, 3.0, 1.0), hardest, 12e-3, 16e9), rel=1e-12)
    assert found.high[0, 0] != pytest.approx(whip_force(3.0, hardest, 12e-3, 16e9), rel=1e-2)
    # a mesh of the first driver that stays closed itself has it too, by the mass of its own wheel
    closed_first = replace(bodies, drag=np.array([[80.0, 0.2, 0.1]]))
    of, strikes, found = solved(m, closed_first)
    assert of.parts.tolist() == [[False, True, True]]
    assert found.high[0, 0] >= whip_force(3.0, float(strikes.hardest.max()), 12e-3, 16e9) * (1 - 1e-12) > 0


def test_branches_do_not_strike_each_other():
    m = motion([[10.0]])
    both = train((-1, -1), [2.0, 1.0], [[1.0, 40.0]], [60e-6, 60e-6])
    _, _, found = solved(m, both)
    assert found.high[0, 0] > 0 and not found.high[0, 1] and not found.speed[0, 1]


def test_low_high_and_speed_as_they_are_defined():
    """Of a tree with other radii, body by body and strike by strike."""
    rng = np.random.default_rng(8)
    parent, rho = (-1, 0, 0, 2, -1), np.array([1.0, 1.3, 0.7, 1.2, 0.9])
    points = 6
    m = motion(rng.normal(size=(points, 3)) * [9, 5, 2], [2.0, 4.0, 6.0], rng.uniform(80, 200, points))
    drag, mass = rng.uniform(0.1, 8, (points, 5)), rng.uniform(0.3, 4, 5)
    b, c = rng.uniform(8e-3, 20e-3, 5), rng.uniform(12e9, 18e9, 5)
    bodies = train(parent, mass, drag, rng.uniform(30e-6, 120e-6, 5), rho=rho, width=b, stiffness=c)
    of, strikes, found = solved(m, bodies)
    path = [[i] if up < 0 else [] for i, up in enumerate(parent)]
    for i, up in enumerate(parent):
        path[i] = [*path[up], i] if up >= 0 else path[i]
    R = [math.prod(rho[n] for n in path[d]) for d in range(5)]
    for point in range(points):
        hits = [  # on each body, at its own mesh
            [
                (u * R[d] / R[a], p * R[d] / R[a])
                for a in path[d]
                for u, p in zip(strikes.speed[point, a].tolist(), strikes.press[point, a].tolist())
                if u
            ]
            for d in range(5)
        ]
        for i in range(5):
            low = high = speed = 0.0
            for d in range(5):
                lever = R[d] / R[i]
                for u, p in hits[d] if i in path[d] else ():
                    F = alone = 1000.0
                    for _ in range(40):
                        k = 1 / sum((R[d] / R[n]) ** 2 / stiffness_at(F, b[n], c[n]) for n in path[d])
                        F = strike_force(of.mass[d], p, k, u)
                        k = stiffness_at(alone * lever, b[i], c[i]) / lever**2
                        alone = strike_force(of.mass[d], p, k, u)
                    low, high, speed = max(low, F * lever), max(high, alone * lever), max(speed, u)
            branch = [d for d in range(5) if path[d][0] == path[i][0]]
            u_b = max(strikes.hardest[point, d] / R[d] for d in branch) * R[i]
            if parent[i] >= 0 or not of.parts[point, i]:
                mu = 1 / (1 / mass[i] + (rho[i] ** 2 / mass[parent[i]] if parent[i] >= 0 else 0.0))
                high = max(high, whip_force(mu, float(u_b), b[i], c[i]))
            assert found.low[point, i] == pytest.approx(low, rel=1e-7)
            assert found.high[point, i] == pytest.approx(high, rel=1e-7)
            assert found.speed[point, i] == pytest.approx(speed, rel=1e-12)
            assert forces_in(at_point(bodies, of, strikes, found, point), i) == pytest.approx((low, high), rel=1e-7)


def test_strikes_of_a_working_cycle_are_counted():
    """Two a period of order 2: 8 in a four-stroke cycle; one-sided where the backlash is out of reach: 4."""
    m = motion([[10.0], [10.0]])
    _, _, found = solved(m, train(drag=[[2.0], [6.0]], backlash=np.array([[60e-6], [5e-3]])))
    assert found.impacts[:, 0] == pytest.approx([8.0, 4.0]) and found.flanks[:, 0].tolist() == [2, 1]
    two_stroke = replace(m, cycle=2 * math.pi)
    _, _, half = solved(two_stroke, train(drag=[[2.0], [6.0]], backlash=np.array([[60e-6], [5e-3]])))
    assert half.impacts[:, 0] == pytest.approx([4.0, 2.0])


def test_weak_strikes_are_not_counted():
    """Below 5 % of the hardest of the orbit; those between 5 and 50 % count."""
    m, bodies = random_lanes(60)
    _, strikes, found = solved(m, bodies)
    share = strikes.speed[:, 0] / strikes.hardest
    cycles = m.cycle / m.omega / strikes.orbit[:, 0]
    assert found.impacts[:, 0] == pytest.approx((share > 0.05).sum(1) * cycles, rel=1e-12)
    assert ((share > 0) & (share < 0.05)).any() and ((share > 0.05) & (share < 0.5)).any()


def test_forces_of_one_mesh_by_the_formulas():
    """The lines give what all at once gave, and stand on formulas with a source."""
    trains = [lane(given_of(case)) for case in ("R753 idle", "two wheels of other radius on the first shaft")]
    trains += [
        lane(given_of("light wheel of much drag behind a striking one")),
        lane(given_of("heavy drag, never lets go")),
    ]
    for m, bodies in trains:
        of, strikes, found = solved(m, bodies)
        for mesh in range(len(bodies.parent)):
            with trace() as lines:
                low, high = forces_in(at_point(bodies, of, strikes, found), mesh)
            assert (low, high) == pytest.approx((found.low[0, mesh], found.high[0, mesh]), rel=1e-8)
            assert bool(lines) == (high > 0)
            if high:
                assert link_of(low) and link_of(high)


def test_formulas_by_hand():
    assert separation(M=10.254, a=12.0, D=9.0) == pytest.approx(13.672)
    assert least_force(M=10.0, a=12.0, D=9.0) == pytest.approx(-111.0)
    assert impact_power(M=10.0, u=np.array([0.05, 0.03]), T=0.04) == pytest.approx(0.425)


def test_every_quantity_has_its_shape():
    m, bodies = random_lanes(12)
    _, _, found = solved(m, bodies)
    each = Impacts.__dataclass_fields__.keys() - {"teeth", "forces"}
    assert all(getattr(found, name).shape == (12, 1) for name in each)
