# SPDX-License-Identifier: Apache-2.0
"""Turning masses and pumps of whole designs: what the balance counts of them, and what it only carries."""

import copy
import math
from dataclasses import replace

import numpy as np
import pytest

from calc.design.step_inputs import on_shafts
from calc.design.toml_file import Document
from calc.friction.journals import journals_at
from calc.friction.losses.turning_masses import Sectors
from calc.friction.power_balance import End, Hung, drive, end_of, losses_of
from calc.sheet.errors import BadInput
from calc.solve import solve
from tests.calc.friction.balance.test_tree import Rubbing, pair, solved
from tests.calc.friction.documents import DESIGNS, changed, design, gamma, read
from tests.calc.friction.losses.test_turning_masses import LOSSES, values
from tests.calc.friction.pairs import friction, lubricant, shown
from tests.conftest import SCREENED


def document(shaft=(), **tables):
    """The counter-shaft of the R753IE4 with keys of its shaft and of other tables set."""
    made = changed(gamma(), **tables)
    data = copy.deepcopy(made.data)
    data["shafts"][0].update(dict(shaft))
    return replace(made, data=data)


def found(shaft=(), **friction):
    return solve(design(document(shaft, friction=friction)))


def friction_of(results):
    return results.outcomes["friction"].result


def sectors(name):
    """Two sectors of the case, opposed, with its core between them and journals at their ends."""
    case = LOSSES[name]
    R, r_0, half = case["outer_radius_mm"], case["core_radius_mm"], case["length_mm"] / 2
    ends = (-130.0, -90.0, -90.0 + half, 90.0 - half, 90.0, 130.0)
    kinds = ({}, {"angle_deg": 211.5}, None, {"angle_deg": 31.5}, {})
    sections = []
    for from_mm, to_mm, kind in zip(ends, ends[1:], kinds):
        cut = {"from_mm": from_mm, "to_mm": to_mm, "outer_radius_mm": R if kind is not None else r_0}
        if kind:
            cut |= kind | {"core_radius_mm": r_0, "half_angle_deg": 80.0}
        sections.append(cut)
    return sections


def test_the_given_loss_through_a_whole_design():
    """At 12 000 rpm in the mist of the wheels.  The program's air is thicker than that of the given values, which moves
    the low end by 1.3 % and the plate not at all."""
    case = LOSSES["mist-2x"]
    given = {said["value"]: said["is"] for said in values("mist-2x")}
    low, high = given["mass_loss_low"], given["mass_loss_high"]
    made = document(
        {"sections": sectors("mist-2x"), "axis_mm": [100.0, 0.0]},
        friction={"mass_loss": "bracket", "oil_level_mm": 100.0 - case["outer_radius_mm"] + 5.0},
        engine={"rated_speed_rpm": case["speed_rpm"], "bench": []},
    )
    for row in made.data["shafts"][0]["bearings"]:
        row |= {"position_mm": math.copysign(110.0, row["position_mm"]), "load_N": 500.0, "diameter_mm": 44.0}
        row |= {"length_mm": 24.0}
    results = solve(design(made))
    result = friction_of(results)
    assert result is not None, results.outcomes["friction"].reason
    masses = result.masses
    assert masses.mass_loss_high - masses.mass_loss_low == pytest.approx(high - low, rel=1e-6)
    assert masses.mass_loss_low == pytest.approx(1.013 * low, rel=5e-4)
    assert masses.mass_loss == pytest.approx(math.sqrt(masses.mass_loss_low * masses.mass_loss_high), rel=1e-12)
    assert results.check("countershaft.oil_level").verdict == "warn"


# --- one shaft


def test_what_is_not_asked_costs_nothing_and_is_said(gamma_results):
    plain, counted = friction_of(gamma_results), friction_of(found(mass_loss="bracket"))
    assert plain.masses is None and plain.mass_loss is None and plain.dip_loss_most is None
    assert any("turning masses lose in the mist is not counted" in note for note in notes(gamma_results))
    assert counted.total_loss > plain.total_loss + counted.mass_loss  # the meshes carry it
    assert counted.crank_power == pytest.approx(counted.total_loss, rel=1e-9)


def notes(results):
    return [str(note) for note in results.outcomes["friction"].notes]


def test_masses_that_nobody_knows_are_not_counted_and_that_is_said():
    made = document(friction={"mass_loss": "bracket"})
    for key in ("outer_radius_mm", "core_radius_mm"):
        del made.data["shafts"][0][key]
    bare = solve(design(made))
    assert friction_of(bare).masses is None
    assert any("turning masses of shaft lose is not counted: no outline" in note for note in notes(bare))


def test_a_shell_counts_the_low_end_and_keeps_the_oil_out():
    shell = dict(covered="shell", shell_gap_mm=3.0, axis_mm=[10.0, 0.0])
    closed, open_ = (found(shaft, mass_loss="bracket", oil_level_mm=0.0) for shaft in (shell, {"axis_mm": [10.0, 0.0]}))
    assert friction_of(closed).mass_loss == friction_of(closed).masses.mass_loss_low < friction_of(open_).mass_loss
    assert friction_of(closed).dip_loss_most is None and friction_of(open_).dip_loss_most > 0
    assert closed.check("countershaft.oil_level") is None
    assert open_.check("countershaft.oil_level").verdict == "warn"


def test_oil_below_the_sectors_costs_nothing_and_a_place_that_is_not_given_is_not_verified():
    low, unknown = found({"axis_mm": [0.0, 0.0]}, oil_level_mm=-60.0), found(oil_level_mm=-60.0)
    assert low.check("countershaft.oil_level").verdict == "pass" and friction_of(low).dip_loss_most == 0.0
    assert unknown.check("countershaft.oil_level").verdict == "not_verified"
    assert friction_of(unknown).dip_loss_most is None


def test_over_speed_the_loss_grows_a_little_slower_than_the_cube():
    """The friction of the cylinder falls slowly with Re, the drag of the plate not at all."""
    slow, fast = (friction_of(solve(design(at(rpm)))).masses for rpm in (1300.0, 2600.0))
    assert 4.0 < fast.mass_loss_low / slow.mass_loss_low < 8.0
    assert fast.mass_loss_high - fast.mass_loss_low == pytest.approx(8 * (slow.mass_loss_high - slow.mass_loss_low))
    outcome = found(mass_loss="bracket").outcomes["friction"]
    curve = next(c for c in outcome.further().curves if c.id == "over_speed_parts")
    line = next(s for s in curve.series if s.label == "turning masses")
    at_half = next(y for x, y in zip(line.x, line.y) if x == pytest.approx(1300.0))
    assert at_half == pytest.approx(slow.mass_loss, rel=1e-9) and line.y[-1] == pytest.approx(fast.mass_loss, rel=1e-9)


def at(rpm):
    return document(friction={"mass_loss": "bracket"}, engine={"rated_speed_rpm": rpm, "bench": []})


def test_the_open_bracket_is_among_what_the_literature_leaves_open():
    outcome = found(mass_loss="bracket").outcomes["friction"]
    table = next(t for t in outcome.further().tables if t.id == "tornado")
    row = next(row for row in table.rows if row[0] == "loss of the turning masses")
    masses = outcome.result.masses
    assert row[3] < outcome.result.total_loss < row[4]
    assert row[5] == pytest.approx(masses.mass_loss_high - masses.mass_loss_low, rel=0.1)


def test_a_scenario_loses_it_too():
    cold = {"name": "cold", "oil_temperature_C": 40.0}
    results = found(mass_loss="bracket", scenarios=[cold]).whole()
    one = friction_of(results).scenarios["cold"]
    assert one.mass_loss == pytest.approx(friction_of(results).mass_loss, rel=1e-12)
    table = next(t for t in results.outcomes["friction"].tables if t.id == "scenarios")
    assert ("masses", "W") in [(str(label), unit) for label, unit in table.columns]


# --- pumps


def pump(**said):
    return {"loads": [{"name": "pump", "power_kW": 2.0, **said}]}


def test_a_pump_is_carried_and_not_lost(gamma_results):
    plain, results = gamma_results, found(pump())
    with_pump = friction_of(results)
    assert with_pump.carried_power == 2000.0
    assert with_pump.crank_power == pytest.approx(with_pump.total_loss + 2000.0, rel=1e-9)
    standing, light = (r.outcomes["countershaft"].result.standing for r in (results, plain))
    assert standing.gear_torque > light.gear_torque + 0.99 * 2000.0 / (2 * math.pi * 2600 / 60)
    table = next(t for t in results.outcomes["friction"].tables if t.id == "balance")
    assert ("carried and not lost: pump", 2000.0, None) in [(str(row[0]), *row[1:]) for row in table.rows]
    assert results.check("friction.train.balance").holds


def test_a_pump_on_another_wheel_does_not_push_the_shaft(gamma_results):
    plain, idler = gamma_results, found(pump(wheel="idler"))
    assert friction_of(idler).carried_power == 2000.0
    of_plain, of_idler = (friction_of(r).at_teeth("shaft") for r in (plain, idler))
    assert of_idler == pytest.approx(of_plain, rel=1e-9)


@pytest.mark.parametrize("exponent", [0.0, 1.0, 3.0])
def test_a_pump_follows_the_speed(exponent, gamma_results):
    made = design(document(pump(speed_exponent=exponent)))
    on = on_shaft(made, solve(made))
    half = end_of(made.friction, "shaft", on, journals_at(on, 0.5, 120.0))
    assert half.hung == (Hung("pump", "shaft", pytest.approx(2000.0 / 2**exponent)),)


def on_shaft(made, results):
    c, b, g = (results.outcomes[step] for step in ("countershaft", "bearings", "gears"))
    return on_shafts(made, {"shaft": c}, {"shaft": b}, g.result)["shaft"]


# --- several shafts


def turning(up, gap=None):
    sizes = (np.array([60e-3, 60e-3]), np.array([30e-3, 30e-3]), np.array([12e-3, 12e-3]))
    return Sectors(*sizes, omega=400.0, shell_gap=gap, up=up)


def test_each_shaft_has_its_own_and_the_train_their_sum():
    ends = {
        "left": End("left", Rubbing(100.0), sectors=turning(0.02), rho_oil=850.0),
        "right": End("right", Rubbing(150.0, 0.03), sectors=turning(-0.01, gap=2e-3), rho_oil=850.0),
        "pump": End("pump", Rubbing(10.0)),
    }
    outcome = solved(pair(), ends, mass_loss="bracket", oil_level=0.0)
    r, shown_ = outcome.result, shown(outcome)
    left, right = r.shafts["left"], r.shafts["right"]
    for name in ("mass_loss_low", "mass_loss_high", "mass_loss"):
        assert getattr(r.masses, name) == pytest.approx(getattr(left.masses, name) + getattr(right.masses, name))
        assert shown_[f"left.{name}"] == pytest.approx(getattr(left.masses, name), rel=1e-12)
    assert right.masses.mass_loss == right.masses.mass_loss_low and r.shafts["pump"].masses is None
    assert r.dip_loss_most == left.dip_loss_most > 0 and right.dip_loss_most is None
    assert r.meshes["left_right"].power_out == pytest.approx(
        sum(r.wheels["right"].parts()) + r.journals["right"]["front"].friction_power + right.masses.mass_loss, rel=1e-8
    )
    quick = losses_of(drive(friction(mass_loss="bracket"), pair(), lubricant(), 90.0, 50.0, ends))
    assert quick.total == pytest.approx(r.total_loss, rel=1e-8) and quick.masses == pytest.approx(r.mass_loss)


def test_a_shaft_and_the_same_once_more_lower_down():
    """A design with two shafts at crank speed: each has its bracket, its pump, and its own height over the oil."""
    data = document(
        {"axis_mm": [-100.0, 90.0], **pump()}, friction={"mass_loss": "bracket", "oil_level_mm": -145.0}
    ).data
    lower = {"name": "lower", "repeats": "shaft", "axis_mm": [-150.0, -90.0]}
    data["shafts"].append(lower | {"loads": [{"name": "other", "power_kW": 0.5}]})
    wheels, meshes = data["gears"]["wheels"], data["gears"]["meshes"]
    wheels[-1]["shaft"] = "shaft"
    wheels.append({**wheels[-1], "name": "second", "shaft": "lower"})
    meshes.append({**meshes[-1], "driven": "second"})
    results = solve(design(Document(data)))
    shown_ = {id: value.shown for id, value in results.values().items()}
    for end in ("mass_loss_low", "mass_loss_high", "mass_loss"):
        assert shown_[f"friction.shaft.{end}"] == shown_[f"friction.lower.{end}"] > 0
        assert shown_[f"friction.{end}"] == pytest.approx(2 * shown_[f"friction.shaft.{end}"], rel=1e-12)
    assert shown_["friction.carried_power"] == 2500.0
    assert shown_["friction.crank_power"] == pytest.approx(shown_["friction.total_loss"] + 2500.0, rel=1e-9)
    upper, lower = (results.check(f"countershaft.{name}.oil_level") for name in ("shaft", "lower"))
    assert (upper.verdict, lower.verdict) == ("pass", "warn")
    assert "shafts.lower.axis_mm" in lower.moved_by and "shafts.shaft.axis_mm" in upper.moved_by
    assert shown_["friction.lower.dip_loss_most"] > shown_["friction.shaft.dip_loss_most"] == 0


# --- what may be said


def test_without_bearings_nothing_hangs_on_a_shaft():
    made = document(pump())
    train = {key: table for key, table in made.data.items() if key != "bearings"}
    train["friction"] = train["friction"] | {"oil": "SAE 30", "oil_temperature_C": 90.0}
    with pytest.raises(BadInput, match=r"loads: .*add that table, or leave it out"):
        design(replace(made, data=train))


@pytest.mark.parametrize(
    "shaft, words",
    [
        ({"covered": "shell"}, 'shell_gap_mm: needed with covered = "shell"'),
        ({"shell_gap_mm": 2.0}, 'shell_gap_mm: .*leave it out, or say covered = "shell"'),
        (pump(wheel="pimp"), "loads.0.wheel: .*is not known"),
        (pump(power_kW=-1.0), "loads.0.power_kW"),
    ],
)
def test_what_can_not_be_is_said_at_its_key(shaft, words):
    with pytest.raises(BadInput, match=words):
        design(document(shaft))


def test_a_twin_has_its_own_loads_and_the_cover_of_its_original():
    data = copy.deepcopy(read(DESIGNS / f"{SCREENED}.toml").data)
    own, twin = data["shafts"]
    own |= {"covered": "shell", "shell_gap_mm": 2.0, **pump()}
    twin["loads"] = [{"name": "other", "power_kW": 1.0}]
    own, twin = design(Document(data)).resolved
    assert [load.name for load in own.inputs.loads] == ["pump"]
    assert [load.name for load in twin.inputs.loads] == ["other"]
    assert twin.inputs.covered == "shell" and twin.inputs.shell_gap == pytest.approx(2e-3)
    data["shafts"][1]["covered"] = "open"
    design(Document(data))  # as left out
    data["shafts"][1]["covered"] = "shell"
    with pytest.raises(BadInput, match=r"covered: .*is that of its original"):
        design(Document(data))
