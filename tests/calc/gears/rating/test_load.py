# SPDX-License-Identifier: Apache-2.0
"""The load of the rating: mean torque of a power, and the dynamic torque of an uneven crank from the energy of what it
drives."""

import math
from dataclasses import replace
from pathlib import Path

import pytest

from calc.design.toml_file import design, read
from calc.gears.inputs import Stage
from calc.gears.rating.checks import application_factor_check
from calc.gears.rating.load import (
    Irregularity,
    Power,
    ShaftInertia,
    Surroundings,
    Swing,
    firing_order,
    loads,
    mean_torques,
    rating_context,
    wheel_inertia,
)
from calc.gears.rating.solve import rating
from calc.gears.stages import slack_notes
from calc.library.catalogue import materials
from calc.solve import solve
from tests.calc.gears.trains import SPEED, r753, solved

GAMMA = Path(__file__).parents[4] / "designs" / "r753ie4_gamma.toml"
GEARS = r753()
TRAIN = solved(GEARS)
STEEL = materials()["steel"]


def inertia(name):
    w = TRAIN.wheels[name]
    return math.pi / 32 * STEEL.density * w.face_width * w.pitch_diameter**4


def on_shaft(J_S, with_wheel=True):
    return {"shaft": ShaftInertia(J_S, with_wheel)}


def rated(uneven, gears=GEARS):
    return loads(gears, TRAIN, mean_torques(TRAIN, 1.0), uneven, materials())


def test_dynamic_torque_is_what_the_energy_behind_the_mesh_asks_for():
    """d/dt of the kinetic energy of all wheels behind a mesh, over the speed of its driver."""
    J_S, delta, i = 5e-3, 0.02, 1.5
    found = rated(Irregularity(delta, i, None, on_shaft(J_S)))
    omega = 2 * math.pi * SPEED
    alpha = delta / 2 * i * omega**2
    ratio = {name: 25 / TRAIN.wheels[name].teeth for name in ("central", "idler", "shaft")}
    energy = J_S * ratio["shaft"] ** 2  # per ω²/2 of the crank
    for key, driver, driven in (
        ("idler_shaft", "idler", "shaft"),
        ("central_idler", "central", "idler"),
        ("crank_central", "crank", "central"),
    ):
        if driven != "shaft":
            energy += inertia(driven) * ratio[driven] ** 2
        at_crank = energy * alpha
        assert found[key].dynamic == pytest.approx(at_crank * TRAIN.wheels[driver].teeth / 25, rel=1e-12)


def test_the_wheel_on_the_shaft_is_added_where_the_shaft_has_none():
    bare, whole = (rated(Irregularity(0.02, 1.5, None, on_shaft(5e-3, with_wheel))) for with_wheel in (False, True))
    heavier = rated(Irregularity(0.02, 1.5, None, on_shaft(5e-3 + inertia("shaft"))))
    assert bare["idler_shaft"].dynamic == pytest.approx(heavier["idler_shaft"].dynamic)
    assert bare["idler_shaft"].dynamic > whole["idler_shaft"].dynamic


def test_either_the_peak_or_the_application_factor():
    uneven = Irregularity(0.02, 1.5, None, on_shaft(5e-3))
    peak, usual = rated(uneven)["idler_shaft"], rated(None)["idler_shaft"]
    assert peak.K_A == 1.0 and peak.rated == pytest.approx(peak.mean + peak.dynamic)
    assert (usual.K_A, usual.rated, usual.dynamic) == (1.25, usual.mean, None)
    assert usual.assumed and not peak.assumed
    given = rated(uneven, replace(GEARS, application_factor=1.5))["idler_shaft"]
    assert (given.K_A, given.rated) == (1.5, given.mean) and given.dynamic == peak.dynamic


def test_a_factor_that_overlooks_the_known_torque_is_said():
    """K_A on the mean against the peak of mean and dynamic torque."""
    uneven = Irregularity(0.02, 1.5, None, on_shaft(5e-3))
    for K_A, verdict in ((1.25, "warn"), (20.0, "pass")):
        load = rated(uneven, replace(GEARS, application_factor=K_A))["idler_shaft"]
        check = application_factor_check("idler_shaft", "idler–shaft", load)
        assert check.verdict == verdict and check.limit == pytest.approx(1 + load.dynamic / load.mean)
    assert application_factor_check("idler_shaft", "idler–shaft", rated(uneven)["idler_shaft"]) is None


def test_the_engine_torque_accelerates_its_flywheel_and_all_behind():
    """Up by what the torque has above its mean, down by what it lacks; a first driver that turns slower than the crank
    gets its share."""
    swing = Swing(1000.0, 200.0, -300.0, 0.6, 1.0)
    found = rated(Irregularity(None, None, swing, on_shaft(5e-3)))["idler_shaft"]
    assert found.dynamic == pytest.approx(5e-3 * 800 / 0.6 * 39 / 25)
    assert found.least == pytest.approx(found.mean - 5e-3 * 500 / 0.6 * 39 / 25)
    half = rated(Irregularity(None, None, replace(swing, ratio=0.5), on_shaft(5e-3)))["idler_shaft"]
    assert half.dynamic == pytest.approx(found.dynamic / 2)


def test_a_rim_is_lighter_than_a_disc():
    thin = replace(GEARS, wheels=tuple(replace(w, rim_thickness=5e-3) for w in GEARS.wheels))
    uneven = Irregularity(0.02, 1.5, None, on_shaft(5e-3))
    assert rated(uneven, thin)["crank_central"].dynamic < rated(uneven)["crank_central"].dynamic


def test_the_inertia_of_a_ring():
    """m·(r² + r_i²)/2."""
    mass = 7830.0 * 0.02 * math.pi * (0.05**2 - 0.03**2)
    assert wheel_inertia(rho=7830.0, b=0.02, d=0.1, d_i=0.06) == pytest.approx(mass * (0.05**2 + 0.03**2) / 2)


def test_a_power_gives_the_torque_of_every_driver():
    first = mean_torques(TRAIN, Power(1350.0))
    assert first["crank_central"] == pytest.approx(1350 / (2 * math.pi * SPEED))
    assert first["idler_shaft"] == pytest.approx(first["crank_central"] * 39 / 25)
    each = mean_torques(TRAIN, Power({"crank_central": 1350.0, "central_idler": 1300.0, "idler_shaft": 1200.0}))
    assert each["central_idler"] == pytest.approx(1300 / (2 * math.pi * SPEED * 25 / 36))


def test_the_roughness_of_the_flanks():
    """Rz 4 µm where nothing is given; Ra = Rz/6 both ways, the rougher flank counts."""

    def context(gears=GEARS, **around):
        return rating_context(gears, TRAIN, materials(), Surroundings(**around))

    usual, measured = context(), context(flank_ra=(0.5e-6, 0.8e-6))
    given = context(replace(GEARS, flank_rz=3e-6), flank_ra=(0.5e-6, 0.8e-6))
    assert usual.flank_rz == 4e-6 and usual.flank_ra == pytest.approx((2e-6 / 3,) * 2)
    assert measured.flank_rz == pytest.approx(4.8e-6) and measured.flank_ra == (0.5e-6, 0.8e-6)
    assert given.flank_rz == 3e-6 and given.flank_ra == pytest.approx((0.5e-6,) * 2)


@pytest.mark.parametrize("cylinders, strokes, order", [(3, 4, 1.5), (4, 4, 2.0), (2, 2, 2.0)])
def test_firing_order(cylinders, strokes, order):
    assert firing_order(cylinders, strokes) == order


def test_the_whole_design_hands_on_irregularity_and_inertia():
    """Given, or that of gas and flywheel, it loads the teeth; the teeth rattle where the least torque is below zero."""
    document = read(GAMMA)
    plain = solve(design(document)).outcomes["gears"].result
    assert plain.meshes["idler_shaft"].rating.dynamic_torque is None
    uneven = solve(design(document.with_value("gears.speed_irregularity", 0.02)))
    shaft, mesh = uneven.outcomes["countershaft"].result, uneven.outcomes["gears"].result.meshes["idler_shaft"].rating
    omega = 2 * math.pi * 2600 / 60
    assert mesh.dynamic_torque == pytest.approx(shaft.moment_of_inertia * 0.01 * 1.5 * omega**2 * 39 / 25)
    assert mesh.least_torque == pytest.approx(mesh.mean_torque - mesh.dynamic_torque) and mesh.least_torque < 0
    verdicts = {c.id: c.verdict for c in uneven.checks()}
    assert verdicts["gears.idler_shaft.flank_reversal"] == "note"


def test_gas_and_flywheel_load_the_teeth():
    """(T_hi − T_m)/J of the engine's own torque; a first driver that is not the crank turns with its share of it."""
    document = read(GAMMA)
    for key, value in (
        ("engine.gas.peak_pressure_bar", 140.0),
        ("engine.gas.compression_ratio", 17.0),
        ("engine.flywheel_inertia_kgm2", 0.6),
    ):
        document = document.with_value(key, value)
    results = solve(design(document))
    torque, shaft = results.outcomes["engine"].result.torque, results.outcomes["countershaft"].result
    mesh = results.outcomes["gears"].result.meshes["idler_shaft"].rating
    up = (torque.torque_highest - torque.mean_torque) / 0.6
    assert mesh.dynamic_torque == pytest.approx(shaft.moment_of_inertia * up * 39 / 25)
    down = (torque.mean_torque - torque.torque_lowest) / 0.6
    assert mesh.least_torque == pytest.approx(mesh.mean_torque - shaft.moment_of_inertia * down * 39 / 25)
    assert torque.torque_lowest < torque.mean_torque < torque.torque_highest
    slower = (
        solve(design(document.with_value("gears.speed_rpm", 1300.0)))
        .outcomes["gears"]
        .result.meshes["idler_shaft"]
        .rating
    )
    assert slower.dynamic_torque == pytest.approx(mesh.dynamic_torque / 2)


# --- behind a chain


def behind_a_chain(**said):
    stage = Stage(
        name="chain",
        kind="chain",
        driver="nose",
        driven="crank",
        driver_teeth=38,
        driven_teeth=19,
        pitch=9.525e-3,
        **said,
    )
    return replace(GEARS, stages=(stage,))


def test_what_a_chain_drives_is_accelerated_by_its_ratio():
    """Crank and all behind it turn twice as fast as the nose: the energy behind a link, over the speed of its driver."""
    gears = behind_a_chain()
    train = solved(gears)
    delta, i, J_S = 0.02, 1.5, 5e-3
    found = loads(gears, train, mean_torques(train, 1.0), Irregularity(delta, i, None, on_shaft(J_S)), materials())
    alpha = delta / 2 * i * (2 * math.pi * SPEED) ** 2
    turns = {name: 2 * 25 / TRAIN.wheels[name].teeth for name in ("crank", "central", "idler", "shaft")}
    energy = J_S * turns["shaft"] ** 2  # per ω²/2 of the nose
    for key, driver, driven in (("idler_shaft", "idler", "shaft"), ("crank_central", "crank", "central")):
        if driven == "central":
            energy += sum(inertia(name) * turns[name] ** 2 for name in ("idler", "central"))
        assert found[key].dynamic == pytest.approx(energy * alpha / turns[driver], rel=1e-12)
    energy += inertia("crank") * turns["crank"] ** 2
    assert found["chain"].dynamic == pytest.approx(energy * alpha, rel=1e-12)
    assert found["chain"].mean == 1.0 and found["crank_central"].mean == pytest.approx(0.5)


def slack(tensioner):
    gears = behind_a_chain(tensioner=tensioner)
    outcome = rating(
        gears, solved(gears), 1.0, materials(), Surroundings(Irregularity(0.02, 1.5, None, on_shaft(5e-3)))
    )
    (force,) = outcome.solution.least_strand_forces.values()
    return force, [check for check in outcome.checks if check.id == "gears.chain.slack"]


def test_the_slack_strand_is_judged_where_its_force_is_known():
    """The least torque at the driving sprocket over its radius; the tensioner must hold what the other strand takes."""
    force, checks = slack(None)
    gears = behind_a_chain()
    train = solved(gears)
    load = loads(gears, train, mean_torques(train, 1.0), Irregularity(0.02, 1.5, None, on_shaft(5e-3)), materials())
    assert force == pytest.approx(load["chain"].least / (9.525e-3 / math.sin(math.pi / 38) / 2)) and force < 0
    assert not checks
    for tensioner, verdict in ((-1.01 * force, "pass"), (-0.99 * force, "note")):
        _, (check,) = slack(tensioner)
        assert check.verdict == verdict and check.value == pytest.approx(-force)
    said = "its slack strand takes up to"
    assert [said in str(note) for note in slack_notes(gears, {"chain": force})] == [True]
    assert not [*slack_notes(gears, {"chain": 1.0}), *slack_notes(behind_a_chain(tensioner=5.0), {"chain": force})]
    outcome = rating(gears, train, 1.0, materials())
    assert not outcome.solution.least_strand_forces and not any(said in str(note) for note in outcome.notes)
