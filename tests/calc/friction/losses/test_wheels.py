# SPDX-License-Identifier: Apache-2.0
"""What the wheels lose besides their meshes: who carries it, that nothing is lost in the balance, what loads an idler's
bush."""

import math
from dataclasses import replace

import numpy as np
import pytest

from calc.friction.inputs import Dip, Jet, OtherLoss, PlainBearing, RollingBearing, Seal
from calc.friction.losses import bearings as plain_bearings
from calc.friction.losses import bearings as rolling_bearings
from calc.friction.losses.wheels import carrying, speeds_of, unloaded
from calc.friction.power_balance import most_force
from calc.solve import solve
from tests.calc.friction.documents import changed, design, gamma
from tests.calc.friction.pairs import CRANK_SPEED, closed, friction, lubricant, r753, shown

PARTS = ("bearing", "mesh", "windage", "churning", "thrown_oil", "seal", "wheel_bearing", "other")
EVERYTHING = dict(
    seals=(Seal(name="crank front", diameter=0.03), Seal(name="crank rear", diameter=0.04, count=2)),
    rolling_bearings=(RollingBearing(name="central", bore=0.02, outside_diameter=0.042),),
    plain_bearings=(PlainBearing(name="idler", diameter=0.025, length=0.02, clearance=40e-6),),
    dips=(Dip(name="idler", depth=10e-3, oil_volume=3e-3),),
    jets=(Jet(name="shaft", flow=1e-3 / 60, jet_speed=2.0),),
    other_losses=(OtherLoss(name="central pump", power=3.0), OtherLoss(name="somewhere", power=1.0)),
)


# --- the balance
def test_all_parts_together_are_the_power_at_the_crank():
    values = shown(closed(**EVERYTHING))
    parts = {part: values[f"{part}_loss"] for part in PARTS}
    assert all(P > 0 for P in parts.values())
    assert sum(parts.values()) == pytest.approx(values["total_loss"], rel=1e-12)
    assert values["total_loss"] == pytest.approx(values["crank_power"], rel=1e-9)


def test_every_kind_of_loss_sums_over_the_wheels():
    values = shown(closed(**EVERYTHING))
    for kind, of_wheel in (
        ("windage", "windage"),
        ("churning", "churning"),
        ("thrown_oil", "thrown_oil"),
        ("seal", "seal_loss"),
        ("wheel_bearing", "bearing_loss"),
        ("other", "other_loss"),
    ):
        each = [values.get(f"{name}.{of_wheel}", 0.0) for name in ("crank", "central", "idler", "shaft")]
        assert values[f"{kind}_loss"] == pytest.approx(sum(each), rel=1e-12), kind


def test_a_wheel_without_other_losses_has_none():
    said = friction(other_losses=(OtherLoss(name="central", power=3.0),))
    wheels = unloaded(said, r753(), lubricant(), 80.0, 30.0)
    assert {name: wheel.other_loss for name, wheel in wheels.items()} == dict(
        crank=0.0, central=3.0, idler=0.0, shaft=0.0
    )


def test_each_mesh_carries_the_wheels_behind_it():
    values = shown(closed(**EVERYTHING))

    def own(name):
        return sum(
            values.get(f"{name}.{part}", 0.0)
            for part in ("windage", "churning", "thrown_oil", "seal_loss", "bearing_loss", "other_loss")
        )

    assert values["idler_shaft.power_out"] == pytest.approx(own("shaft") + values["bearing_loss"], rel=1e-12)
    assert values["central_idler.power_out"] == pytest.approx(own("idler") + values["idler_shaft.power_in"], rel=1e-12)
    assert values["crank_central.power_out"] == pytest.approx(
        own("central") + values["central_idler.power_in"], rel=1e-12
    )
    assert values["crank_power"] == pytest.approx(own("crank") + values["crank_central.power_in"], rel=1e-12)


def test_an_entry_counts_as_much_as_its_two_halves():
    """Several entries on one wheel add up, each by its own name."""
    one = shown(closed(seals=(Seal(name="idler", diameter=0.03, count=2),)))
    two = shown(closed(seals=(Seal(name="idler-front", diameter=0.03), Seal(name="idler rear", diameter=0.03))))
    assert one["idler.seal_loss"] == pytest.approx(two["idler.seal_loss"], rel=1e-12)
    assert one["crank_power"] == pytest.approx(two["crank_power"], rel=1e-12)


def test_what_names_no_wheel_is_carried_by_the_last_and_is_told():
    outcome = closed(
        seals=(Seal(name="flywheel", diameter=0.03),),
        jets=(Jet(name="nozzle", flow=1e-5, jet_speed=0.0),),
        dips=(Dip(name="idler", depth=5e-3, oil_volume=1e-3),),
    )
    values = shown(outcome)
    assert {"shaft.seal_loss", "shaft.thrown_oil", "idler.churning"} <= values.keys()
    assert any(
        note.startswith("Carried by wheel shaft, the last, ") and "flywheel, nozzle" in note for note in outcome.notes
    )


def test_no_entry_leaves_no_value():
    values = shown(closed())
    assert not [
        id
        for id in values
        if "seal" in id or "churning" in id or "thrown" in id or "wheel_bearing" in id or id.endswith("bearing_force")
    ]


def test_speeds_follow_the_teeth_and_many_points_are_the_single_ones():
    speeds = speeds_of(r753(), CRANK_SPEED)
    assert speeds["shaft"] == pytest.approx(CRANK_SPEED)
    assert speeds["idler"] * 39 == pytest.approx(CRANK_SPEED * 25)
    said = friction(seals=EVERYTHING["seals"], dips=EVERYTHING["dips"], jets=EVERYTHING["jets"])
    n, T = np.array([10.0, 30.0, 80.0]), np.array([0.0, 60.0, 120.0])
    many = unloaded(said, r753(), lubricant(), T, n)
    for i in range(3):
        alone = unloaded(said, r753(), lubricant(), float(T[i]), float(n[i]))
        for name, wheel in alone.items():
            for part in ("windage", "churning", "thrown_oil", "seal_loss"):
                one = getattr(wheel, part)
                assert (one is None) == (getattr(many[name], part) is None)
                if one is not None:
                    assert np.broadcast_to(getattr(many[name], part), 3)[i] == pytest.approx(one, rel=1e-12)


# --- bearings of the wheels
def test_without_places_a_bush_carries_the_largest_that_its_teeth_can_push():
    outcome = closed(plain_bearings=EVERYTHING["plain_bearings"])
    values, meshes = shown(outcome), r753()
    forces = [
        values[f"{key}.power_in"] / (2 * math.pi * values[f"{m.driver.name}.speed"] / 60 * m.driver.base_radius)
        for key, m in meshes.items()
    ]
    assert values["idler.bearing_force"] == pytest.approx(forces[1] + forces[2], rel=1e-9)
    oil = lubricant().at(120.0)
    expected = plain_bearings.plain_bearing_power(
        EVERYTHING["plain_bearings"][0], forces[1] + forces[2], values["idler.speed"] / 60, oil.mu
    )
    assert values["idler.bearing_loss"] == pytest.approx(expected, rel=1e-9)
    speeds = speeds_of(meshes, CRANK_SPEED)
    most = most_force(meshes, {key: values[f"{key}.power_in"] for key in meshes}, speeds)
    assert most["idler"] == pytest.approx(values["idler.bearing_force"], rel=1e-9)
    assert most["crank"] == pytest.approx(forces[0], rel=1e-12)


def test_where_no_teeth_push_the_bush_carries_nothing():
    bush = EVERYTHING["plain_bearings"][0]
    said = friction(plain_bearings=(bush,))
    wheels = unloaded(said, r753(), lubricant(), 80.0, 30.0)
    F, P = carrying(said, wheels, "shaft", lubricant(), 80.0, {})["idler"]
    assert F == 0.0
    assert P == plain_bearings.plain_bearing_power(bush, 0.0, wheels["idler"].speed, lubricant().at(80.0).mu)


def test_a_given_load_counts_instead_of_the_teeth():
    bearings = (RollingBearing(name="idler", bore=0.02, outside_diameter=0.042, load=500.0),)
    light, heavy = (shown(closed(shaft_power=P, rolling_bearings=bearings)) for P in (50.0, 500.0))
    assert light["idler.bearing_force"] == heavy["idler.bearing_force"] == 500.0
    assert light["idler.bearing_loss"] == heavy["idler.bearing_loss"]
    by_hand = rolling_bearings.power(bearings[0], 500.0, light["idler.speed"] / 60, lubricant().at(120.0).nu)
    assert light["idler.bearing_loss"] == pytest.approx(by_hand, rel=1e-12)


def bushes(document):
    rows = [dict(name=name, diameter_mm=25.0, length_mm=20.0, clearance_um=40.0) for name in ("central", "idler")]
    return changed(document, friction=dict(plain_bearings=rows))


def bearing_forces(results):
    """Of the friction step, and of the gear step for the power of the same balance."""
    friction = results.outcomes["friction"].result
    forces = results.outcomes["gears"].result.forces.wheels
    return {name: (friction.wheels[name].bearing_force, forces[name]) for name in ("central", "idler")}


def test_in_their_places_the_bushes_carry_what_the_gear_step_says():
    placed = (
        bushes(gamma())
        .with_value("shafts.shaft.axis_mm", [-60.0, 120.0])
        .with_value("gears.wheels.central.position_mm", [30.0, 59.0])
    )
    results = solve(design(placed))
    for ours, theirs in bearing_forces(results).values():
        assert theirs.bearing_force is not None
        assert ours == pytest.approx(theirs.bearing_force, rel=1e-9)
    for ours, theirs in bearing_forces(solve(design(bushes(gamma())))).values():
        assert theirs.bearing_force is None
        assert ours == pytest.approx(theirs.bearing_force_max, rel=1e-9)


def test_a_bush_that_can_not_carry_its_wheel_is_named():
    thin = replace(EVERYTHING["plain_bearings"][0], diameter=4e-3, length=1e-3, clearance=200e-6)
    with pytest.raises(Exception, match="plain bearing idler: no film carries its load"):
        closed(plain_bearings=(thin,))
