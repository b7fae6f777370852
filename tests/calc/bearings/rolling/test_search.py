# SPDX-License-Identifier: Apache-2.0
"""The search for rolling bearings: the given ranking, and fits that hold once they are solved."""

from dataclasses import replace

import numpy as np
import pytest

from calc.bearings.inputs import BearingsInputs
from calc.bearings.rolling import checks as c
from calc.bearings.rolling import search as s
from calc.bearings.rolling.bearing import judged
from calc.bearings.rolling.sizes import every_size, size_of
from calc.bearings.rolling.solve import case_of
from calc.bearings.support import Solids, StandingLoads, Task
from calc.countershaft.rows import BearingRow
from calc.library.catalogue import shipped_materials
from tests.calc.bearings.rolling.typical import OIL, given

METALS = shipped_materials()
SITS = (c.CLEARANCE_LEAST, c.CLEARANCE_START, c.GRIP_HOT)
CASE = given("choice front of gamma")


def place(housing="EN AC-43100", **more):
    said = CASE[0]["inputs"]
    inputs = BearingsInputs(
        oil="10W-40",
        supply_temperature=said["oil_temperature_C"],
        supply_pressure=4e5,
        supply="hole",
        housing_material=housing,
        life=said["life_h"] * 3600.0,
    )
    R = said["standing_N"]
    asked = dict(
        row=BearingRow(name="front", position=-0.1675, diameter=0.0595, length=0.02, seat_fit="H7"),
        inputs=inputs,
        solids=Solids(OIL, METALS["steel"], METALS[housing], METALS["steel"]),
        load=said["turning_N"],
        stands=StandingLoads(R, R, 0.0),
        slope=None,
        task=Task(said["speed_rpm"] / 60, None),
        bores=tuple(x / 1e3 for x in said["journal_mm"]),
        locates=False,
    )
    return s.Place(**asked | more)


def solved(at, row):
    case = case_of(row, at.inputs, at.solids)
    return judged(case, at.load, at.stands, at.slope, at.task)


def test_the_given_ranking():
    first = s.candidates(place())
    for row in CASE:
        kind, _, rest = row["value"].partition(" ")
        if kind != "row" or not rest:
            continue
        n, what = rest.split()
        one = first[int(n) - 1]
        if what == "size":
            assert one.size.designation == row["is"]
        else:
            assert one.loss == pytest.approx(row["is"], rel=row["rel"])


@pytest.mark.parametrize("locates", [False, True])
def test_each_is_as_it_is_solved_alone(locates):
    """All at once and one by one; the duty by its rows."""
    said = replace(place().inputs, duty=())
    at = place(inputs=said, locates=locates, stands=StandingLoads(300.0, 60.0, 150.0 if locates else 0.0))
    for one in s.candidates(at)[::9]:
        r = solved(at, s.as_rolling(at, one.size.designation))
        assert one.loss == pytest.approx(r.duty_loss, rel=1e-9)
        assert one.life == pytest.approx(r.life, rel=1e-9)
        assert one.static_safety == pytest.approx(r.static_safety, rel=1e-9)
        assert (one.temperature, one.mass, one.seat) == pytest.approx(
            (r.running_temperature, r.bearing_mass, r.seat_diameter)
        )
        failing = {check.rule.id for check in r.checks() if check.verdict == "fail"}
        broken = {rule.id for rule in one.fails}
        assert broken <= failing
        assert failing - broken <= {c.CLEARANCE_LEAST.id, c.CLEARANCE_START.id, c.GRIP_HOT.id}


def test_flanges_where_the_shaft_is_located_alone():
    for locates in (False, True):
        sizes = list(s.sizes_for(place(locates=locates)))
        assert {size.flanged for size in sizes if size.type == "roller"} == {locates}
        assert {size.type for size in sizes} == ({"ball", "roller"} if locates else {"ball", "roller", "needle", "cup"})
        assert all(0.025 <= size.bore <= 0.04 for size in sizes)


@pytest.mark.parametrize("size", ["6205", "6305", "NU205", "NU2306", "NA4906", "RNA4905", "HK3020", "K25x30x20"])
@pytest.mark.parametrize("housing", ["EN AC-43100", "EN-GJL-250"])
def test_what_is_fitted_holds_as_it_is_solved(size, housing):
    at = place(housing)
    row = s.as_rolling(at, size)
    T_b = solved(at, row).running_temperature
    there = s.fitted(at, row, T_b)
    assert there is not None
    r = solved(at, there)
    assert r.clearance_least >= 0 and r.clearance_start >= 0
    assert r.grip_hot is None or r.grip_hot >= 0
    assert not list(there.problems())
    if housing == "EN AC-43100":
        assert there.outer_ring_held == "insert"
    failing = {check.rule.id for check in r.checks() if check.verdict == "fail"}
    assert failing <= {c.LIFE.id, c.STATIC_SAFETY.id}
    narrow = {check.rule.id for check in r.checks() if check.rule in SITS and check.verdict != "pass"}
    assert not narrow or size.startswith("6")  # balls have just enough
    assert there.cage == "steel" and T_b > 120
    kept = s.fitted(at, there, T_b)
    assert kept == there  # nothing changes where all holds


def test_a_ring_that_a_pin_holds_is_not_asked_for_its_grip():
    at = place()
    row = replace(s.as_rolling(at, "NU205"), outer_ring_held="pin")
    found = s.fitted(at, row, 127.0)
    assert (found.outer_ring_held, found.seat_fit, found.clearance_class) == ("pin", None, "C4")


def test_where_no_fit_does_there_is_none():
    """Limits of the clearance that leave nothing, and a shaft that is warmer by half the way to the oil."""
    at = place()
    tight = replace(s.as_rolling(at, "6205"), clearance_limits=(0.0, 1e-6))
    assert s.fitted(at, tight, 125.0) is None
    hot = place(inputs=replace(place().inputs, ring_temperature=49.0))
    _, loose = s.seated(hot, [one for one in s.candidates(hot) if one.size.type == "ball"], 3)
    assert loose


def test_a_load_that_stands_needs_no_grip_but_a_tight_inner_ring():
    at = place(stands=StandingLoads(2000.0, 50.0, 0.0))
    found = s.fitted(at, s.as_rolling(at, "NU205"), 127.0)
    assert (found.outer_ring_held, found.shaft_fit) == ("fit", None)


def test_plain_keys_go_and_what_any_bearing_has_stays():
    at = place()
    said = replace(at.row, load=1000.0, slope=1e-4, housing_outer=0.2, housing_material="EN-GJL-250", bore=(0.0595,))
    row = s.as_rolling(replace(at, row=said), "NU205")
    assert (row.kind, row.size, row.load, row.slope, row.housing_outer) == ("rolling", "NU205", 1000.0, 1e-4, 0.2)
    assert row.housing_material == "EN-GJL-250" and row.seat_fit is None and row.bore is None
    assert not list(row.problems())
    narrow = s.as_rolling(replace(at, row=replace(said, housing_outer=0.05)), "NU205")
    assert narrow.housing_outer is None


def test_nothing_in_the_pareto_set_is_beaten():
    rows = s.pareto(s.candidates(place()))
    numbers = np.array([(one.loss, one.mass, one.seat, -one.life) for one in rows])
    for one in numbers:
        worse = (numbers >= one).all(axis=1) & (numbers > one).any(axis=1)
        assert not worse.any()
    assert rows[0].size.designation == "6305"


def test_a_heavy_load_leaves_few():
    heavy = place(load=15e3, bores=(0.015, 0.06))
    every = s.candidates(heavy)
    passing = [one.size.designation for one in every if not one.fails]
    assert 0 < len(passing) < len(every) / 10 and not any(name.startswith("6") for name in passing), passing
    assert all(c.LIFE in one.fails or c.STATIC_SAFETY in one.fails for one in every if one.fails)


def test_every_size_of_the_grid_is_known():
    assert {size_of(size.designation).designation for size in every_size()} == {
        size.designation for size in every_size()
    }
