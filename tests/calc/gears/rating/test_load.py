# SPDX-License-Identifier: Apache-2.0
"""The load of the rating: mean torque of a power, and the dynamic torque of an uneven crank from the energy of what it
drives."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from calc.design.toml_file import design, read
from calc.gears.drive.crank import firing_order
from calc.gears.inputs import Stage
from calc.gears.rating.checks import application_factor_check
from calc.gears.rating.irregular import Irregular, MeshTorques
from calc.gears.rating.load import Power, Surroundings, loads, mean_torques, rating_context
from calc.gears.rating.solve import rating
from calc.gears.stages import slack_notes
from calc.library.catalogue import materials
from calc.solve import solve
from tests.calc.gears.drive.at_work import driven, on_shaft, r753_engine
from tests.calc.gears.trains import SPEED, r753, solved

GAMMA = Path(__file__).parents[4] / "designs" / "r753ie4_gamma.toml"
GEARS = r753()
TRAIN = solved(GEARS)
STEEL = materials()["steel"]


def inertia(name):
    w = TRAIN.wheels[name]
    return math.pi / 32 * STEEL.density * w.face_width * w.pitch_diameter**4


def uneven_by(J_S, with_wheel=True, gears=GEARS, delta=0.02, order=1.5):
    """What an irregularity adds to the torques of a train with a shaft of this inertia."""
    return driven(on_shaft(J_S, with_wheel), gears, delta, order).solution.torques


def rated(uneven, gears=GEARS):
    return loads(gears, TRAIN, mean_torques(TRAIN, 1.0), uneven)


def test_dynamic_torque_is_what_the_energy_behind_the_mesh_asks_for():
    """d/dt of the kinetic energy of all wheels behind a mesh, over the speed of its driver."""
    J_S, delta, i = 5e-3, 0.02, 1.5
    found = rated(uneven_by(J_S, delta=delta, order=i))
    omega = 2 * math.pi * SPEED
    alpha = delta / 2 * i * omega**2
    ratio = {name: 25 / TRAIN.wheels[name].teeth for name in ("central", "idler", "shaft")}
    energy = J_S * ratio["shaft"] ** 2  # per ω²/2 of the crank
    for key, driver, mate in (
        ("idler_shaft", "idler", "shaft"),
        ("central_idler", "central", "idler"),
        ("crank_central", "crank", "central"),
    ):
        if mate != "shaft":
            energy += inertia(mate) * ratio[mate] ** 2
        at_crank = energy * alpha
        assert found[key].dynamic == pytest.approx(at_crank * TRAIN.wheels[driver].teeth / 25, rel=1e-9)


def test_the_wheel_on_the_shaft_is_added_where_the_shaft_has_none():
    bare, whole = (rated(uneven_by(5e-3, with_wheel)) for with_wheel in (False, True))
    heavier = rated(uneven_by(5e-3 + inertia("shaft")))
    assert bare["idler_shaft"].dynamic == pytest.approx(heavier["idler_shaft"].dynamic)
    assert bare["idler_shaft"].dynamic > whole["idler_shaft"].dynamic


def test_either_the_peak_or_the_application_factor():
    uneven = uneven_by(5e-3)
    peak, usual = rated(uneven)["idler_shaft"], rated(None)["idler_shaft"]
    assert peak.K_A == 1.0 and peak.rated == pytest.approx(peak.mean + peak.dynamic)
    assert (usual.K_A, usual.rated, usual.dynamic) == (1.25, usual.mean, None)
    assert usual.assumed and not peak.assumed
    given = rated(uneven, replace(GEARS, application_factor=1.5))["idler_shaft"]
    assert (given.K_A, given.rated) == (1.5, given.mean) and given.dynamic == peak.dynamic


def test_a_factor_that_overlooks_the_known_torque_is_said():
    """K_A on the mean against the peak of mean and dynamic torque."""
    uneven = uneven_by(5e-3)
    for K_A, verdict in ((1.25, "warn"), (20.0, "pass")):
        load = rated(uneven, replace(GEARS, application_factor=K_A))["idler_shaft"]
        check = application_factor_check("idler_shaft", "idler–shaft", load)
        assert check.verdict == verdict and check.limit == pytest.approx(1 + load.dynamic / load.mean)
    assert application_factor_check("idler_shaft", "idler–shaft", rated(uneven)["idler_shaft"]) is None


def test_the_least_torque_is_that_of_the_point_where_it_is_least():
    """Where the crank slows down most, or where the drag is least; the dynamic one is the largest of all."""
    swing = MeshTorques(dynamic=2.0, slowing=(1.0, 1.8, 1.5), share=(0.2, 1.0, 0.5))
    found = rated(Irregular({"idler_shaft": swing}, assumed=False))["idler_shaft"]
    assert found.mean == pytest.approx(39 / 25) and found.dynamic == 2.0
    assert found.least == pytest.approx(found.mean * 0.5 - 1.5)
    assert found.rated == pytest.approx(found.mean + 2.0) and found.reverses


def test_a_rim_is_lighter_than_a_disc():
    thin = replace(GEARS, wheels=tuple(replace(w, rim_thickness=5e-3) for w in GEARS.wheels))
    solid, ring = uneven_by(5e-3), uneven_by(5e-3, gears=thin)
    assert ring.of["crank_central"].dynamic < solid.of["crank_central"].dynamic


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
    engine = replace(r753_engine()[0], cylinders=cylinders, strokes=strokes)
    assert firing_order(engine) == order


def test_the_whole_design_hands_on_irregularity_and_inertia():
    """Given, or that of gas and flywheel, it loads the teeth; the teeth rattle where the least torque is below zero."""
    document = read(GAMMA)
    plain = solve(design(document)).outcomes["gears"].result
    assert plain.meshes["idler_shaft"].rating.dynamic_torque is None
    uneven = solve(design(document.with_value("gears.speed_irregularity", 0.02)))
    shaft, mesh = uneven.outcomes["countershaft"].result, uneven.outcomes["gears"].result.meshes["idler_shaft"].rating
    omega = 2 * math.pi * 2600 / 60
    assert mesh.dynamic_torque == pytest.approx(shaft.moment_of_inertia * 0.01 * 1.5 * omega**2 * 39 / 25)
    at_rated = mesh.mean_torque - mesh.dynamic_torque
    assert (
        at_rated - mesh.mean_torque < mesh.least_torque < at_rated < 0
    )  # where there is less drag than at rated speed
    verdicts = {c.id: c.verdict for c in uneven.checks()}
    assert verdicts["gears.idler_shaft.flank_reversal"] == "note"


def test_gas_and_flywheel_load_the_teeth():
    """The torque above its mean, over flywheel and train, at that speed and load where it is largest; a first driver
    that is not the crank turns with its share of it."""
    document = read(GAMMA)
    for key, value in (
        ("engine.gas.peak_pressure_bar", 140.0),
        ("engine.gas.compression_ratio", 17.0),
        ("engine.flywheel_inertia_kgm2", 0.6),
    ):
        document = document.with_value(key, value)
    results = solve(design(document))
    train, shaft = results.train, results.outcomes["countershaft"].result
    mesh, source = train.meshes["idler_shaft"].rating, train.drive.drive.source
    turns = {name: 25 / train.wheels[name].teeth for name in ("central", "idler")}
    J_E = 0.6 + shaft.moment_of_inertia + sum(inertia(name) * i**2 for name, i in turns.items())
    assert train.drive.inertia_total == pytest.approx(J_E, rel=1e-6)
    torque = source.torque(*source.points())
    epsilon = np.linspace(0, 4 * math.pi, 1441)
    swing = (torque.t @ np.exp(1j * np.multiply.outer(torque.orders, epsilon))).real / J_E
    assert mesh.dynamic_torque == pytest.approx(shaft.moment_of_inertia * swing.max() * 39 / 25, rel=2e-3)
    at_rated = mesh.mean_torque + shaft.moment_of_inertia * swing[-1].min() * 39 / 25
    assert mesh.least_torque < at_rated * 0.99 < 0  # not where the mean is that of the balance
    slower = solve(design(document.with_value("gears.speed_rpm", 1300.0))).train.meshes["idler_shaft"].rating
    assert slower.dynamic_torque == pytest.approx(mesh.dynamic_torque / 2, rel=0.01)  # and less of it in J_E


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
    found = loads(gears, train, mean_torques(train, 1.0), uneven_by(J_S, gears=gears, delta=delta, order=i))
    alpha = delta / 2 * i * (2 * math.pi * SPEED) ** 2
    turns = {name: 2 * 25 / TRAIN.wheels[name].teeth for name in ("crank", "central", "idler", "shaft")}
    energy = J_S * turns["shaft"] ** 2  # per ω²/2 of the nose
    for key, driver, mate in (("idler_shaft", "idler", "shaft"), ("crank_central", "crank", "central")):
        if mate == "central":
            energy += sum(inertia(name) * turns[name] ** 2 for name in ("idler", "central"))
        assert found[key].dynamic == pytest.approx(energy * alpha / turns[driver], rel=1e-9)
    energy += inertia("crank") * turns["crank"] ** 2
    assert found["chain"].dynamic == pytest.approx(energy * alpha, rel=1e-9)
    assert found["chain"].mean == 1.0 and found["crank_central"].mean == pytest.approx(0.5)


def slack(tensioner):
    gears = behind_a_chain(tensioner=tensioner)
    outcome = rating(gears, solved(gears), 1.0, materials(), Surroundings(uneven_by(5e-3, gears=gears)))
    (force,) = outcome.solution.least_strand_forces.values()
    return force, [check for check in outcome.checks if check.id == "gears.chain.slack"]


def test_the_slack_strand_is_judged_where_its_force_is_known():
    """The least torque at the driving sprocket over its radius; the tensioner must hold what the other strand takes."""
    force, checks = slack(None)
    gears = behind_a_chain()
    train = solved(gears)
    load = loads(gears, train, mean_torques(train, 1.0), uneven_by(5e-3, gears=gears))
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
