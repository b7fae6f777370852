# SPDX-License-Identifier: Apache-2.0
"""The train as a tree: ways, speeds and phase errors of random trees against a walk from the end to the first driver,
and which wheel carries which shaft."""

import math
import re
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.design.toml_file import design
from calc.gears import solve
from calc.gears.backlash.case import free_turn, lags
from calc.gears.inputs import GearsInputs, Stage
from calc.gears.layout.curves import layout_curve, loop
from calc.gears.layout.forces import axis_forces
from calc.gears.layout.solve import ShaftInTrain
from calc.gears.profile.drawing import in_row
from calc.gears.sketch import sketch
from calc.gears.train import speeds
from calc.gears.tree import TrainLink, Tree, first_of, in_flow
from calc.sheet.errors import BadInput
from calc.solve import solve as solve_design
from tests.calc.friction.documents import changed, gamma
from tests.calc.gears.trains import SPEED, mesh, solved, train, wheel

SHAFTS = ("left", "right")


def stage(driver, driven, z_1=20, z_2=40, *, name="chain", **said):
    said = {"kind": "chain", "pitch": 9.525e-3, "span": 0.3, **said}
    return Stage(name=name, driver=driver, driven=driven, driver_teeth=z_1, driven_teeth=z_2, **said)


def pair_of_shafts(**said):
    """The crank wheel drives the left shaft by an idler and the right one by two, at twice its speed."""
    wheels = (
        wheel("crank", 48, 0.0, allowance=(-20, -40)),
        wheel("a", 31, 0.0, allowance=(-20, -40)),
        wheel("left", 24, 0.0, shaft="left", allowance=(-20, -40)),
        wheel("b", 29, 0.0, allowance=(-20, -40)),
        wheel("c", 33, 0.0, allowance=(-20, -40)),
        wheel("right", 24, 0.0, shaft="right", allowance=(-20, -40)),
    )
    meshes = (mesh("crank", "a"), mesh("a", "left"), mesh("crank", "b"), mesh("b", "c"), mesh("c", "right"))
    return train(wheels, meshes, **said)


def by_chain(gears=None, **said):
    """A chain from the crank to the left shaft, whose wheel turns the right one."""
    gears = train(
        (wheel("left", 30, 0.0, shaft="left"), wheel("right", 30, 0.0, shaft="right")), (mesh("left", "right"),)
    )
    return replace(gears, stages=(stage("crank", "left", 38, 19, **said),))


def turned(gears, shafts=SHAFTS):
    return solve.turning(solve.at_rest(gears, shafts), gears, SPEED)


# --- random trees


@st.composite
def links(draw):
    """Of a random tree, in random order: a wheel keeps its teeth in all its meshes, a sprocket has its own."""
    count = draw(st.integers(1, 8))
    teeth = draw(st.lists(st.integers(5, 90), min_size=count + 1, max_size=count + 1))
    made = []
    for n in range(1, count + 1):
        above, toothed = draw(st.integers(0, n - 1)), draw(st.booleans())
        z_1, z_2 = (teeth[above], teeth[n]) if toothed else (draw(st.integers(5, 90)), draw(st.integers(5, 90)))
        sense = -1 if toothed else draw(st.sampled_from((1, -1)))
        made.append(TrainLink(f"k{n}", "", f"w{above}", f"w{n}", z_1, z_2, sense, toothed))
    return draw(st.permutations(made))


def walked(made, end):
    """The links to a wheel and the exact ratio of its speed, from the end to the first driver."""
    above, ratio, way = {link.driven: link for link in made}, Fraction(1), []
    while end in above:
        link = above[end]
        way.append(link)
        ratio *= Fraction(link.z_1, link.z_2) * link.sense
        end = link.driver
    return way[::-1], ratio


@settings(max_examples=300, deadline=None)
@given(made=links(), data=st.data())
def test_a_random_tree_is_what_a_walk_finds(made, data):
    """Ways, senses, turns; and the free turn of every wheel, each play carried to the end by the ratios behind it."""
    assert first_of(made) == "w0"
    tree = Tree(in_flow(made, "w0"))
    assert sorted(link.key for link in tree.links) == sorted(link.key for link in made)
    reached = {"w0"}
    for link in tree.links:
        assert link.driver in reached
        reached.add(link.driven)
    plays = {link.key: data.draw(st.floats(-1e-3, 5e-3)) for link in made}
    for end in reached - {"w0"}:
        way, ratio = walked(made, end)
        assert list(tree.way(end)) == way
        assert tree.senses[end] == (1 if ratio > 0 else -1)
        assert tree.turns(end) == pytest.approx(abs(float(ratio)), rel=1e-12)
        expected = 0.0
        for link in way:
            _, at_link = walked(made, link.driven)
            expected += max(plays[link.key], 0.0) * abs(float(ratio / at_link))
            z, z_end = tree.reduction(link, end)
            assert Fraction(z, z_end) == abs(ratio / at_link)
        assert free_turn(tree, end, plays, plays) == pytest.approx(expected, rel=1e-12, abs=1e-15)


def test_one_branch_reduces_by_the_teeth_of_both_wheels_themselves():
    tree = Tree(
        tuple(TrainLink(f"{a}{b}", "", a, b, z, y, -1, True) for a, b, z, y in (("a", "b", 25, 36), ("b", "c", 36, 39)))
    )
    assert [tree.reduction(link, "c") for link in tree.links] == [(36, 39), (39, 39)]


# --- a train with two shafts


def test_each_shaft_has_the_values_of_its_own_way():
    gears = pair_of_shafts()
    outcome = turned(gears)
    t, values = outcome.result, {v.id: v.inside for v in outcome.values()}
    assert values["gears.left.speed_ratio"] == 2.0 and values["gears.right.speed_ratio"] == -2.0
    for name, way in (("left", ("crank_a", "a_left")), ("right", ("crank_b", "b_c", "c_right"))):
        alone = sum(t.meshes[key].play_angle * t.wheels[t.meshes[key].driven].teeth / 24 for key in way)
        assert values[f"gears.{name}.phase_error"] == pytest.approx(alone, rel=1e-12)
    assert "gears.phase_error" not in values
    left = solve.with_residuals(outcome, {"left": solve.Balanced(100.0), "right": solve.Balanced(0.0, 4000.0)}).result
    assert left.shafts["left"].residual_couple == pytest.approx(200 * math.sin(left.shafts["left"].phase_error / 2))
    assert left.shafts["right"].residual_force == pytest.approx(8000 * math.sin(left.shafts["right"].phase_error / 2))
    assert left.shafts["left"].residual_force is None


def test_each_shaft_must_turn_at_its_own_ratio():
    checks = solve.with_speed_ratios(turned(pair_of_shafts()), {"left": 2.0, "right": 2.0}).checks
    found = {c.id: c for c in checks if c.id.endswith("speed_ratio")}
    assert found["gears.left.speed_ratio"].holds and found["gears.right.speed_ratio"].verdict == "fail"
    assert "an even number of meshes from crank to right" in found["gears.right.speed_ratio"].advice


@pytest.mark.parametrize("wanted", [-2.0, -1.0, 1.0])
def test_of_a_shaft_without_a_wheel_it_is_said_which_would_turn_it(wanted):
    gears = pair_of_shafts()
    check = solve.with_speed_ratios(turned(gears), {"third": wanted}).checks[-1]
    assert check.id == "gears.third.speed_ratio" and check.verdict == "not_verified"
    teeth, driver = re.search(r'teeth = (\d+).* driver = "([a-z]+)"', str(check.advice)).groups()
    third = replace(gears.wheels[-1], name="third", teeth=int(teeth), shaft="third")
    more = replace(gears, wheels=(*gears.wheels, third), meshes=(*gears.meshes, mesh(driver, "third")))
    outcome = solve.with_speed_ratios(turned(more, ("third",)), {"third": wanted})
    assert outcome.checks[-1].holds and outcome.checks[-1].verdict == "pass"


def test_the_way_to_one_shaft_is_that_of_a_train_with_it_alone():
    """Leaving the other branch out moves nothing, to the last bit."""
    gears = pair_of_shafts()
    alone = replace(gears, wheels=gears.wheels[:3], meshes=gears.meshes[:2])
    both, one = turned(gears).result, turned(alone, ("left",)).result
    assert both.shafts["left"].phase_error == one.shafts["left"].phase_error
    assert both.shafts["left"].speed_ratio == one.shafts["left"].speed_ratio


# --- which wheel carries a shaft


def test_the_last_that_is_driven_carries_the_shaft_where_no_wheel_says_so():
    gears = replace(pair_of_shafts(), wheels=tuple(replace(w, shaft=None) for w in pair_of_shafts().wheels))
    assert gears.carrier() == "right" and gears.carriers == {"right"}


def test_a_wheel_says_on_which_shaft_it_sits():
    gears = pair_of_shafts()
    assert [gears.carrier(shaft) for shaft in SHAFTS] == ["left", "right"]
    inner = replace(gears, wheels=tuple(replace(w, shaft="shaft" if w.name == "a" else None) for w in gears.wheels))
    assert inner.carrier() == "a"
    assert solved(inner).shafts["shaft"].speed_ratio == pytest.approx(-48 / 31)


def test_a_sprocket_carries_the_shaft_that_is_called_like_it():
    gears = replace(by_chain(), wheels=(wheel("a", 30, 0.0), wheel("b", 30, 0.0)), meshes=(mesh("a", "b"),))
    gears = replace(gears, stages=(stage("b", "left"),))
    assert gears.carrier("left") == "left"
    t = turned(gears, ("left",)).result
    assert t.shafts["left"].speed_ratio == pytest.approx(-0.5) and "left" not in t.wheels


def problems(gears):
    return dict(gears.problems())


def test_a_shaft_has_one_wheel():
    gears = pair_of_shafts()
    assert not problems(gears)
    twice = replace(gears, wheels=(replace(gears.wheels[0], shaft="left"), *gears.wheels[1:]))
    assert "each shaft has one wheel" in problems(twice)["wheels.2.shaft"]
    crank = replace(gears, wheels=(replace(gears.wheels[0], shaft="third"), *gears.wheels[1:]))
    assert "turns with the crank" in problems(crank)["wheels.0.shaft"]
    like = replace(gears, wheels=tuple(replace(w, shaft="a" if w.name == "left" else None) for w in gears.wheels))
    assert "is what the shaft is called on which left sits" in problems(like)["wheels.1.name"]


# --- chains and belts


def test_a_chain_keeps_the_sense_and_its_outer_side_turns_it():
    inner, outer = by_chain(), by_chain(side="outer")
    assert speeds(inner, SPEED) == {"crank": SPEED, "left": 2 * SPEED, "right": -2 * SPEED}
    assert speeds(outer, SPEED) == {"crank": SPEED, "left": -2 * SPEED, "right": 2 * SPEED}


def test_a_chain_adds_its_lag_to_the_phase_of_what_lies_behind():
    """ε·span over the pitch radius of the driven sprocket, 9.525 mm/(2 sin(180°/19)) by the polygon."""
    t = turned(by_chain(elongation=0.004)).result
    lag = 0.004 * 0.3 / (9.525e-3 / (2 * math.sin(math.pi / 19)))
    assert t.stages["chain"].phase_error == pytest.approx(lag, rel=1e-12)
    assert t.shafts["left"].phase_error == pytest.approx(lag, rel=1e-12)
    play = t.meshes["left_right"].play_angle
    assert t.shafts["right"].phase_error == pytest.approx(lag + max(play, 0.0), rel=1e-12)


def test_what_lies_before_a_chain_is_reduced_by_its_ratio():
    gears = train((wheel("crank", 25, 0.0, allowance=(-20, -30)), wheel("a", 36, 0.0)), (mesh("crank", "a"),))
    gears = replace(gears, stages=(stage("a", "left", 40, 20),))
    t = turned(gears, ("left",)).result
    play = t.meshes["crank_a"].play_angle
    assert play > 0
    assert t.shafts["left"].phase_error == pytest.approx(2 * play + t.stages["chain"].phase_error, rel=1e-12)


def test_a_chain_without_its_span_has_no_phase_error_and_says_so():
    outcome = turned(by_chain(span=None))
    assert outcome.result.stages["chain"].phase_error is None and not lags(outcome.result.stages)
    assert any("gears.stages.chain.span_mm" in str(note) for note in outcome.notes)


def test_the_polygon_of_a_chain():
    """A link lies at d/2 or at d/2·cos(π/z) from the axis: the exact swing of the speed agrees to the fourth order."""
    t = turned(by_chain()).result.stages["chain"]
    assert t.polygon_ripple == pytest.approx(1 - math.cos(math.pi / 19), rel=math.pi**2 / 12 / 19**2 * 1.01)
    assert t.polygon_order == 38
    belt = turned(by_chain(kind="belt")).result.stages["chain"]
    assert belt.polygon_ripple is None and belt.pitch_diameter_driven == pytest.approx(19 * 9.525e-3 / math.pi)


@pytest.mark.parametrize("teeth, verdict", [(19, "pass"), (18, "note")])
def test_few_teeth_are_told(teeth, verdict):
    gears = replace(by_chain(), stages=(stage("crank", "left", 38, teeth),))
    (found,) = [c for c in turned(gears).checks if c.id == "gears.chain.sprocket_teeth"]
    assert found.verdict == verdict


def test_a_stage_must_hang_on_the_train_and_have_a_name_of_its_own():
    gears = by_chain()
    assert not problems(gears)
    assert (
        "is driven already"
        in problems(replace(gears, stages=(*gears.stages, stage("left", "right", name="more"))))["stages.1.driven"]
    )
    loose = problems(replace(gears, stages=(*gears.stages, stage("x", "y", name="more"), stage("y", "x", name="most"))))
    assert "no mesh and no stage leads there from crank" in loose["stages.1.driver"]
    assert (
        "something else in the train"
        in problems(replace(gears, stages=(stage("crank", "left", name="left"),)))["stages.0.name"]
    )
    assert dict(stage("a", "a").problems())["driven"] == "a sprocket can not drive itself"


def test_the_hands_begin_anew_behind_a_chain():
    gears: GearsInputs = by_chain()
    assert gears.hands() == {"left": "right", "right": "left"}
    said = replace(gears, wheels=(gears.wheels[0], replace(gears.wheels[1], hand="right")))
    assert said.hands() == {"left": "left", "right": "right"} and not problems(said)


# --- the place, the forces and the drawings of a branched train


def placed(gears, axes):
    outcome = turned(gears)
    return solve.with_layout(
        outcome, gears, {name: ShaftInTrain(axis, 0.3, couple=50.0) for name, axis in axes.items()}
    )


AXES = {"left": 0.090 + 0.075j, "right": -0.105 - 0.130j}


def test_the_wheel_of_each_shaft_stands_on_its_axis():
    """The others stand at their centre distances from both neighbours; each shaft has a tooth, a step and a couple."""
    outcome = placed(pair_of_shafts(), AXES)
    t, there = outcome.result, outcome.result.layout
    assert there.wheels["left"].position == AXES["left"] and there.wheels["right"].position == AXES["right"]
    for key, m in t.meshes.items():
        one, two = (there.wheels[name].position for name in (m.driver, m.driven))
        assert abs(one - two) == pytest.approx(m.centre_distance, rel=1e-9), key
    values = {v.id: v.inside for v in outcome.values()}
    for name in SHAFTS:
        assert values[f"gears.{name}.remesh_angle"] == pytest.approx(2 * math.pi / 24)
        assert values[f"gears.{name}.remesh_couple"] == pytest.approx(100 * math.sin(math.pi / 24))
        assert abs(values[f"gears.{name}.eccentric_offset"]) <= math.pi / 24
        assert there.wheels[name].tooth_angle == pytest.approx(0.3 + values[f"gears.{name}.eccentric_offset"])


def test_every_mark_puts_a_tooth_into_a_space():
    """Of every mesh the tooth of one wheel stands where the other has a space, on both branches."""
    t = placed(pair_of_shafts(), AXES).result
    for key, m in t.meshes.items():
        gamma = t.layout.meshes[key].line_of_centres
        z_1, z_2 = t.wheels[m.driver].teeth, t.wheels[m.driven].teeth
        theta_1, theta_2 = (t.layout.wheels[name].tooth_angle for name in (m.driver, m.driven))
        half_turns = (z_1 * (theta_1 - gamma) + z_2 * (theta_2 - gamma - math.pi)) / math.pi
        assert math.cos(half_turns * math.pi) == pytest.approx(-1.0, abs=1e-9)


def test_the_force_on_a_wheel_that_drives_two_is_their_vector():
    """Statics apart: each mesh pushes along its line of action, seen from the driver."""
    gears = pair_of_shafts()
    t = placed(gears, AXES).result
    torques = {key: 10.0 + n for n, key in enumerate(t.meshes)}
    found = axis_forces(gears, t, torques)
    total = 0j
    for key in ("crank_a", "crank_b"):
        m, gamma = t.meshes[key], t.layout.meshes[key].line_of_centres
        F_t = torques[key] / (m.working_diameter_driver / 2)
        toward = complex(math.cos(gamma), math.sin(gamma))
        total += F_t * (-1j * toward - math.tan(m.working_pressure_angle) * toward)
    assert found["crank"] == pytest.approx(abs(total), rel=1e-12)


def test_a_branched_train_is_drawn_whole():
    t = placed(pair_of_shafts(), AXES).result
    assert set(in_row(t)) == set(t.wheels)
    curve = layout_curve(pair_of_shafts(), t, t.layout)
    assert {str(series.label) for series in curve.series} == set(t.wheels)


def test_the_line_of_a_chain_touches_both_circles():
    p_1, p_2, r_1, r_2 = 0j, 0.2 + 0.1j, 0.03, 0.05
    line = loop(p_1, p_2, r_1, r_2)
    assert line[0] == line[-1]
    near = np.minimum(np.abs(np.abs(line - p_1) - r_1), np.abs(np.abs(line - p_2) - r_2))
    assert near.max() < 1e-12
    strands = [(a, b) for a, b in pairwise(line) if abs(b - a) > 0.1]
    assert len(strands) == 2
    for a, b in strands:
        assert abs(b - a) == pytest.approx(math.sqrt(abs(p_2 - p_1) ** 2 - (r_1 - r_2) ** 2), rel=1e-12)


def test_a_chain_is_drawn_between_axes_that_are_known():
    gears = by_chain()
    outcome = solve.with_layout(
        turned(gears), gears, {"left": ShaftInTrain(0.2 + 0j), "right": ShaftInTrain(0.2 + 0.06j)}
    )
    curve = layout_curve(gears, outcome.result, outcome.result.layout)
    assert "chain" in [str(series.label) for series in curve.series]
    assert outcome.result.layout.sprockets == {"crank": 0j}


# --- whole designs


def test_a_wheel_that_says_what_it_carries_anyway_moves_nothing(gamma_results):
    """And where a further wheel hangs on the train behind it, the shaft keeps its own way."""
    gears = gamma().data["gears"]
    wheels = [{**w, "shaft": "shaft"} if w["name"] == "shaft" else w for w in gears["wheels"]]
    said = solve_design(design(changed(gamma(), gears={"wheels": wheels}))).values()
    plain = gamma_results.values()
    assert {id: v.inside for id, v in said.items()} == {id: v.inside for id, v in plain.items()}
    more = [*wheels, {"name": "pump", "teeth": 30, "profile_shift": 0.0}]
    meshes = [*gears["meshes"], {"driver": "central", "driven": "pump"}]
    branched = solve_design(design(changed(gamma(), gears={"wheels": more, "meshes": meshes}))).values()
    for id in ("phase_error", "phase_error_rss", "residual_couple", "speed_ratio", "remesh_couple", "insertion_gap"):
        assert branched[f"gears.{id}"].inside == plain[f"gears.{id}"].inside
    assert branched["friction.idler_shaft.power_in"].inside == pytest.approx(
        plain["friction.idler_shaft.power_in"].inside, rel=1e-9
    )
    assert branched["friction.crank_power"].inside > plain["friction.crank_power"].inside


def test_a_wheel_sits_on_a_shaft_of_the_design():
    gears = gamma().data["gears"]
    wheels = [{**w, "shaft": "left"} if w["name"] == "shaft" else w for w in gears["wheels"]]
    with pytest.raises(BadInput, match='"left" is not known; known are shaft'):
        design(changed(gamma(), gears={"wheels": wheels}))


def test_a_chain_before_the_train_of_a_design(gamma_results):
    """Its lag joins the phase error, its loss the balance; the shaft feels neither."""
    stage = dict(name="chain", kind="chain", driver="nose", driven="crank", driver_teeth=23, driven_teeth=23)
    stages = {"stages": [{**stage, "pitch_mm": 9.525, "span_mm": 200.0}]}
    found, plain = solve_design(design(changed(gamma(), gears=stages))).values(), gamma_results.values()
    lag = found["gears.chain.phase_error"].inside
    assert found["gears.phase_error"].inside == pytest.approx(plain["gears.phase_error"].inside + lag, rel=1e-12)
    assert found["gears.phase_error_95"].inside == pytest.approx(plain["gears.phase_error_95"].inside + lag, rel=1e-9)
    assert found["gears.speed_ratio"].inside == pytest.approx(-1.0, rel=1e-12)
    passed = plain["friction.crank_power"].inside
    assert found["friction.crank_power"].inside == pytest.approx(passed / 0.98, rel=1e-9)
    assert found["friction.bearing_loss"].inside == pytest.approx(plain["friction.bearing_loss"].inside, rel=1e-9)


def test_a_chain_alone_turns_the_shaft_against_the_crank_by_its_outer_side(gamma_results):
    """No wheel, no mesh: all steps, their figures and sketches stand."""
    gears = {
        key: value for key, value in gamma().data["gears"].items() if key not in ("wheels", "meshes", "source_sheet")
    }
    said = dict(
        name="chain", kind="chain", driver="crank", driven="shaft", driver_teeth=38, driven_teeth=38, side="outer"
    )
    gears["stages"] = [{**said, "pitch_mm": 9.525, "span_mm": 150.0}]
    document = gamma()
    results = solve_design(design(replace(document, data={**document.data, "gears": gears}))).whole()
    assert all(outcome.state in ("solved", "not_asked") for outcome in results.outcomes.values())
    values = results.values()
    assert values["gears.speed_ratio"].inside == -1.0
    assert values["gears.phase_error"].inside == values["gears.chain.phase_error"].inside
    assert values["gears.remesh_angle"].inside == pytest.approx(2 * math.pi / 38)
    assert values["friction.crank_power"].inside == pytest.approx(
        values["friction.bearing_loss"].inside / 0.98, rel=1e-12
    )
    made = [*results.outcomes["friction"].curves, *results.outcomes["gears"].curves]
    assert "losses" in [curve.id for curve in made]
    assert sketch(results.design, results).primitives
