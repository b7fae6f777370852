# SPDX-License-Identifier: Apache-2.0
"""Orders of the meshes on the crank, and what the load makes of the transmission of spur teeth."""

import json
from pathlib import Path

import pytest

from calc.gears.drive.orders import error_by_load, mesh_frequency, mesh_order, notes, orders_table
from calc.gears.drive.result import MeshOverSpeed
from calc.gears.layout.phase import hunting
from calc.gears.rating.dynamic import mesh_stiffness
from calc.gears.rating.solve import rating
from calc.library.catalogue import materials
from tests.calc.gears.trains import mesh as mesh_of
from tests.calc.gears.trains import r753, solved, train, wheel

REFERENCE = json.loads((Path(__file__).parents[3] / "reference" / "drive.json").read_text(encoding="utf-8"))["given"]
ROWS = {row["id"]: row for row in REFERENCE if row["id"].startswith("whine.")}


def test_the_frequency_of_a_mesh():
    row = ROWS["whine.frequency"]
    z_1, _ = row["given"]["teeth"]
    o = mesh_order(z=z_1, i=1.0)
    f = mesh_frequency(k=row["given"]["harmonic"], o=o, n=row["given"]["speed_rpm"] / 60)
    assert f == pytest.approx(row["is"], rel=row["rel"])


def test_the_turns_until_the_same_teeth_meet():
    row, train = ROWS["whine.turns_to_repeat"], solved(r753())
    mesh = train.meshes["crank_central"]
    assert [train.wheels[name].teeth for name in (mesh.driver, mesh.driven)] == row["given"]["teeth"]
    assert hunting(train, mesh)[1] == row["is"]


def test_the_error_by_load():
    row = ROWS["whine.error_by_load"]
    w, c = row["given"]["line_load_N_mm"] * 1e3, row["given"]["single_stiffness_GPa"] * 1e9
    assert error_by_load(w=w, c=c) * 1e6 == pytest.approx(row["is"], rel=row["rel"])


@pytest.mark.parametrize("eps_alpha", [1.2, 1.5, 1.9])
def test_the_error_is_that_of_one_pair_and_two_by_the_mean_stiffness(eps_alpha):
    """For the share 2 − ε_α of the path one pair carries, else two; whatever ε_α, their mean is the standard's where two
    pairs are 1.75 times as stiff."""
    c, w = 7.57e9, 20e3
    two = (mesh_stiffness(c=c, eps_alpha=eps_alpha) - (2 - eps_alpha) * c) / (eps_alpha - 1)
    assert error_by_load(w=w, c=c) == pytest.approx(w / c - w / two, rel=1e-12)


def order_of(**said):
    return MeshOverSpeed(operations={}, **said)


def test_all_meshes_of_a_gear_chain_share_one_order(over_speed):
    assert [mesh.order for mesh in over_speed.train.drive.meshes.values()] == pytest.approx([25.0] * 3)


def test_the_table_has_each_order_once_and_the_firings():
    train = solved(r753())
    table = orders_table(train, {key: order_of(order=25.0) for key in train.meshes}, 15.0, 2600 / 60, cylinders=3)
    assert [row[1:3] for row in table.rows] == [(1, 25.0), (2, 50.0), (3, 75.0), (1, 1.5), (2, 3.0), (3, 4.5)]
    assert table.rows[0][3] == pytest.approx(375.0) and table.rows[2][4] == pytest.approx(3250.0)
    assert str(table.rows[0][0]) == "crank–central, central–idler, idler–shaft"


SPUR = train(
    [wheel("crank", 25, gear_material="case-hardened"), wheel("pump", 36, gear_material="case-hardened")],
    [mesh_of("crank", "pump")],
    beta=0.0,
)


def test_the_grade_rules_over_the_load_of_a_spur_mesh():
    of_spur = solved(SPUR)
    K = {key: mesh.influence for key, mesh in rating(SPUR, of_spur, 1.0, materials()).solution.meshes.items()}
    influence = K["crank_pump"]
    error = error_by_load(w=influence.line_load, c=influence.single_stiffness)
    (note,) = notes(SPUR, of_spur, {"crank_pump": order_of(order=25.0, error_by_load=error)}, K)
    assert "the grade rules" in str(note) and "11 µm" in str(note)
    (note,) = notes(SPUR, of_spur, {"crank_pump": order_of(order=25.0, error_by_load=20e-6)}, K)
    assert "the load rules" in str(note)


def test_helical_teeth_are_not_reckoned(over_speed):
    train = over_speed.train
    meshes = {key: mesh.over_speed for key, mesh in train.meshes.items()}
    assert all(mesh.error_by_load is None for mesh in meshes.values())
    K = {key: mesh.rating.influence for key, mesh in train.meshes.items()}
    (note,) = notes(over_speed.design.gears, train, meshes, K)
    assert "not computed" in str(note) and "idler–shaft" in str(note)
