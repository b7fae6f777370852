# SPDX-License-Identifier: Apache-2.0
"""The power balance of a tree with several shafts, chains and belts: each link carries the sum of all that lies behind
it."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.friction.mesh.geometry import MeshGeometry, Sprocket, StageGeometry
from calc.friction.power_balance import End, Hung, drive, losses_of
from calc.friction.result import JournalResult
from calc.friction.solve import closed
from calc.sheet.errors import NoSolution
from tests.calc.friction.pairs import friction, lubricant, r753, shown, wheel

MODULE, ANGLE = 2e-3, math.radians(20)


class Rubbing:
    """A shaft that loses some power and a share of what the teeth of its wheel carry."""

    def __init__(self, P_0, share=0.0):
        self.P_0, self.share = P_0, share

    def journals(self, P, loads):
        lost = self.P_0 if P is None else self.P_0 + self.share * P
        return {"front": JournalResult(standing_load=None, friction_power=lost)}

    def sum(self, journals):
        return journals["front"].friction_power


def hung(wheel, power):
    return (Hung("pump", wheel, power),)


def gear(name, z):
    return wheel(name, z, MODULE, ANGLE, MODULE * (z / 2 + 1), 15e-3)


def meshing(one, two):
    return MeshGeometry(one, two, one.reference_radius + two.reference_radius, 0.0)


def chain(name, driver, driven, z_1=20, z_2=30, efficiency=0.98):
    return StageGeometry(name, Sprocket(driver, z_1), Sprocket(driven, z_2), efficiency)


def pair(efficiency=0.97):
    """The crank drives the left shaft by a mesh and an idler, and that the right one by a mesh; a chain drives a pump
    shaft."""
    wheels = {name: gear(name, z) for name, z in (("crank", 40), ("idler", 31), ("left", 29), ("right", 30))}
    made = [meshing(wheels[a], wheels[b]) for a, b in (("crank", "idler"), ("idler", "left"), ("left", "right"))]
    return {mesh.name: mesh for mesh in made} | {"chain": chain("chain", "crank", "pump", efficiency=efficiency)}


def solved(links, ends, **said):
    return closed(drive(friction(**said), links, lubricant(), 90.0, 50.0, ends))


def behind(links, result, ends, name):
    """What a wheel needs with all that hangs on it, by the published losses."""
    of_ends = sum(result.journals[s]["front"].friction_power for s, end in ends.items() if end.wheel == name) + sum(
        load.power for end in ends.values() for load in end.hung if load.wheel == name
    )
    taken = sum(
        behind(links, result, ends, link.driven.name)
        + (result.stages | result.meshes)[key].power_in
        - (result.stages | result.meshes)[key].power_out
        for key, link in links.items()
        if link.driver.name == name
    )
    return sum(result.wheels[name].parts()) + of_ends + taken


@st.composite
def trees(draw):
    """A random tree of wheels and chains with a shaft at each end, and what hangs on the shafts."""
    count = draw(st.integers(1, 6))
    teeth = draw(st.lists(st.integers(24, 60), min_size=count + 1, max_size=count + 1))
    wheels = [gear(f"w{n}", z) for n, z in enumerate(teeth)]
    links = {"w0_w1": meshing(wheels[0], wheels[1])}
    for n in range(2, count + 1):
        above = draw(st.integers(0, n - 1))
        if draw(st.booleans()):
            links[f"w{above}_w{n}"] = meshing(wheels[above], wheels[n])
        else:
            eta = draw(st.floats(0.9, 1.0))
            links[f"c{n}"] = chain(
                f"c{n}", f"w{above}", f"w{n}", draw(st.integers(17, 40)), draw(st.integers(17, 40)), eta
            )
    drivers = {link.driver.name for link in links.values()}
    leaves = [link.driven.name for link in links.values() if link.driven.name not in drivers]
    ends = {
        f"s{n}": End(
            leaf,
            Rubbing(draw(st.floats(50.0, 500.0)), draw(st.floats(0, 0.1))),
            tuple(
                Hung("pump", draw(st.sampled_from([leaf, "w1"])), draw(st.floats(0, 2000.0)))
                for _ in range(draw(st.integers(0, 2)))
            ),
        )
        for n, leaf in enumerate(leaves)
    }
    return links, ends


@settings(max_examples=25, deadline=None)
@given(trees())
def test_every_link_carries_the_sum_of_what_lies_behind_it(tree):
    links, ends = tree
    outcome = solved(links, ends)
    r = outcome.result
    for key, link in links.items():
        assert (r.stages | r.meshes)[key].power_out == pytest.approx(behind(links, r, ends, link.driven.name), rel=1e-8)
    assert r.crank_power == pytest.approx(behind(links, r, ends, "w0"), rel=1e-8)
    carried = sum(load.power for end in ends.values() for load in end.hung)
    assert r.crank_power == pytest.approx(r.total_loss + carried, rel=1e-9)
    assert all(check.holds for check in outcome.checks if check.id == "friction.train.balance")
    quick = losses_of(drive(friction(), links, lubricant(), 90.0, 50.0, ends))
    assert quick.total == pytest.approx(r.total_loss, rel=1e-8)


def test_a_shaft_feels_what_its_wheel_passes_on():
    """Its teeth push as what it takes in and what it passes on: the journals close with both."""
    ends = {"left": End("left", Rubbing(100.0, 0.02)), "right": End("right", Rubbing(150.0, 0.03))}
    r = solved(pair(), ends | {"pump": End("pump", Rubbing(0.0), hung("pump", 800.0))}).result
    left, right = (r.journals[name]["front"].friction_power for name in ("left", "right"))
    through = r.meshes["idler_left"].power_out + r.meshes["left_right"].power_in
    assert left == pytest.approx(100.0 + 0.02 * through, rel=1e-8) and through == pytest.approx(r.at_teeth("left"))
    assert right == pytest.approx(150.0 + 0.03 * r.meshes["left_right"].power_out, rel=1e-8)
    assert r.journals["pump"]["front"].friction_power == 0.0 and r.at_teeth("pump") is None
    assert r.bearing_loss == pytest.approx(left + right) and r.shafts["left"].bearing_loss == left


def test_what_hangs_on_a_shaft_is_carried_and_not_lost():
    rubs = {name: Rubbing(100.0) for name in ("left", "right", "pump")}
    free = solved(pair(), {name: End(name, rub) for name, rub in rubs.items()}).result
    loaded = solved(
        pair(), {name: End(name, rub, hung("pump", 500.0) if name == "pump" else ()) for name, rub in rubs.items()}
    ).result
    assert loaded.carried_power == 500.0 and free.carried_power is None
    assert loaded.crank_power == pytest.approx(loaded.total_loss + 500.0, rel=1e-12)
    assert loaded.total_loss == pytest.approx(free.total_loss + 500.0 * (1 / 0.97 - 1), rel=1e-9)


def test_a_chain_loses_its_share():
    ends = {name: End(name, Rubbing(100.0)) for name in ("left", "right", "pump")}
    outcome = solved(pair(0.9), ends)
    r, values = outcome.result, shown(outcome)
    assert r.stages["chain"].loss == pytest.approx(0.1 * r.stages["chain"].power_in, rel=1e-12)
    assert values["chain.loss"] == pytest.approx(values["stage_loss"]) == pytest.approx(100.0 / 0.9 - 100.0, rel=1e-9)
    assert "pump.windage" not in values and "crank.windage" in values
    assert sum(values[f"{part}_loss"] for part in ("bearing", "mesh", "stage", "windage", "other")) == pytest.approx(
        values["total_loss"], rel=1e-12
    )


def test_a_chain_without_loss_at_the_end_changes_nothing_before_it():
    """The same train, its shaft turned by a chain of ratio 1 that loses nothing."""
    meshes = r753()
    plain = solved(meshes, {"shaft": End("shaft", Rubbing(200.0))}).result
    longer = meshes | {"chain": chain("chain", "shaft", "further", 20, 20, 1.0)}
    chained = solved(longer, {"shaft": End("further", Rubbing(200.0))}).result
    assert chained.crank_power == pytest.approx(plain.crank_power, rel=1e-12)
    assert {key: mesh.judged.loss for key, mesh in chained.meshes.items()} == pytest.approx(
        {key: mesh.judged.loss for key, mesh in plain.meshes.items()}, rel=1e-9
    )


def test_a_chain_in_a_train_whose_power_is_given():
    links = r753() | {"chain": chain("chain", "shaft", "further", 20, 40, 0.95)}
    r = closed(drive(friction(), links, lubricant(), 90.0, 50.0), 2000.0).result
    assert r.stages["chain"].power_out == pytest.approx(0.95 * r.stages["chain"].power_in, rel=1e-12)
    assert r.crank_power == pytest.approx(r.total_loss + r.delivered_power, rel=1e-12)
    assert r.wheels["further"].speed == pytest.approx(r.wheels["shaft"].speed / 2, rel=1e-12)
    with pytest.raises(NoSolution, match="branches"):
        closed(drive(friction(), pair(), lubricant(), 90.0, 50.0), 2000.0)
