"""The train as a whole: open shifts and centre distances, speeds, the source's second pair, one outcome."""

import math
import pickle
import subprocess
import sys
from pathlib import Path

import pytest

from calc.design.toml_file import design, read
from calc.gears import solve
from calc.gears.backlash.formulas import circumferential_backlash
from calc.gears.profile.meshing import flank, penetration
from calc.library.catalogue import materials
from calc.sheet.errors import NoSolution
from calc.sheet.quantity import published
from calc.sheet.step import Outcome
from calc.sheet.text import Text
from calc.sheet.value import leaves, link_of
from calc.solve import solve as whole_solve
from tests.calc.gears.trains import SPEED, mesh, r753, shown, solved, train, wheel

OF_A_WHEEL = (
    "tip_diameter", "reference_diameter", "base_diameter", "root_diameter", "form_diameter", "profile_shift",
    "undercut_limit",
    "tip_thickness", "tip_thickness_normal", "ball_diameter", "over_balls", "over_balls_min", "over_balls_max",
    "chordal_thickness",
    "chordal_height", "speed",
)  # fmt: skip
OF_A_MESH = (
    "centre_distance", "transverse_contact_ratio", "overlap_ratio", "total_contact_ratio", "working_pressure_angle",
    "working_helix_angle",
    "working_diameter_driver", "working_diameter_driven", "sap_diameter_driver", "sap_diameter_driven",
    "tip_clearance_driver",
    "tip_clearance_driven", "specific_sliding_driver", "specific_sliding_driven", "specific_sliding_lpstc_driver",
    "specific_sliding_lpstc_driven", "backlash_min", "backlash_nominal", "backlash_max", "tangential_force",
    "contact_stress",
)  # fmt: skip
DESIGNS = Path(__file__).parents[3] / "designs"
TORQUE = 1350 / (2 * math.pi * SPEED)


@pytest.fixture(scope="module")
def whole():
    """Geometry, play, rating and residual couple of the source's train, as one outcome."""
    gears = r753()
    geometry = solve.with_play(solve.geometry(gears, SPEED), gears, materials(), None)
    rated = solve.rating(gears, geometry.result, TORQUE, materials())
    return solve.with_residuals(solve.merge(geometry, rated), {"shaft": solve.Balanced(572.93)})


# --- the source's train
def test_shifts_follow_through_the_train(whole):
    """36: 0.014 is given; the 39 follows from 80.555 mm (printed −0.312 mm), the shaft's 25 from 68.698 mm, the crank's
    is the shaft's."""
    v = shown(whole)
    assert 2 * v["idler.profile_shift"] == pytest.approx(-0.312, abs=5e-4)
    assert v["crank.profile_shift"] == v["shaft.profile_shift"]
    assert v["crank_central.centre_distance"] == pytest.approx(65.808, abs=5e-4)
    assert any("crank" in note and "chosen" in note and "shaft" in note for note in whole.notes)
    assert any("65.808" in note for note in whole.notes)


def test_speeds(whole):
    v = shown(whole)
    assert [v[f"{w}.speed"] for w in ("crank", "central", "idler", "shaft")] == pytest.approx(
        [2600, -1805.56, 1666.67, -2600], abs=5e-3
    )


def test_second_pair_agrees_with_what_is_known_of_it(whole):
    """Its sheet is not printed in full: ε_α 1.453, ε_β 0.891, k*·m_n 0.004 mm, and sliding of both wheels equal at the
    start of contact."""
    v = {k.removeprefix("idler_shaft."): n for k, n in shown(whole).items() if k.startswith("idler_shaft.")}
    assert v["transverse_contact_ratio"] == pytest.approx(1.453, abs=5e-4)
    assert v["overlap_ratio"] == pytest.approx(0.891, abs=5e-4)
    assert v["standard_tip_shortening"] == pytest.approx(0.004, abs=5e-4)
    assert v["specific_sliding_driver"] == pytest.approx(v["specific_sliding_driven"], abs=5e-4)
    assert v["working_diameter_driver"] / v["working_diameter_driven"] == pytest.approx(39 / 25)
    assert v["working_diameter_driver"] + v["working_diameter_driven"] == pytest.approx(2 * 68.698)


def test_the_first_pair_can_jam_and_the_check_says_what_to_do(whole):
    jams = next(c for c in whole.checks if c.verdict == "fail")
    assert jams.id == "gears.central_idler.backlash" and jams.at_best == pytest.approx(-14.65, abs=0.005)
    assert [way.changes for way in jams.remedies] == [(("gears.wheels.central.span_allowance_um", [-43, -61]),)]
    assert jams.advice.startswith(
        "To pass: Allowance of the span of central [−43; −61] µm (41 µm more off the span of its teeth)"
    )


def test_a_tolerance_that_its_parts_do_not_keep_is_no_remedy(gamma_results):
    """Of the source's last design only the pair of central and idler has its parts between the centres listed: ±54
    µm."""
    ways = {
        c.id: {key for one in c.remedies for key, _ in one.changes}
        for c in gamma_results.outcomes["gears"].checks
        if c.remedies
    }
    assert ways["gears.central_idler.backlash_warm"] == {"gears.wheels.central.span_allowance_um"}
    assert ways["gears.idler_shaft.backlash_cold"] == {
        "gears.wheels.idler.span_allowance_um",
        "gears.meshes.2.tolerance_um",
    }


def test_one_outcome_with_every_promised_name(whole):
    v = shown(whole)
    for w in ("crank", "central", "idler", "shaft"):
        for name in OF_A_WHEEL:
            assert f"{w}.{name}" in v
        assert {f"gears.{w}.undercut", f"gears.{w}.tip_thickness"} <= {c.id for c in whole.checks}
    for pair in ("crank_central", "central_idler", "idler_shaft"):
        for name in OF_A_MESH:
            assert f"{pair}.{name}" in v
        ids = {
            f"gears.{pair}.{c}"
            for c in ("backlash", "contact_ratio", "contact_ratio_usual", "tip_clearance", "interference")
        }
        assert ids <= {c.id for c in whole.checks}
    assert {"idler.span_5", "idler.span_5_min", "crank.span_4_max", "idler_shaft.root_stress_shaft"} <= v.keys()
    assert {"phase_error", "residual_couple"} <= v.keys()


def test_addresses_and_checks_are_unique_and_errata_point_at_values(whole):
    addresses = [v.id for v in whole.values()]
    assert len(addresses) == len(set(addresses))
    assert len({c.id for c in whole.checks}) == len(whole.checks)
    assert {e.about for e in whole.errata} <= set(addresses)
    assert all(c.advice for c in whole.checks if c.verdict != "pass")


def test_every_value_is_what_a_line_returned(whole):
    """So that it can be explained.  First speed, given shift, ball and teeth spanned are inputs."""
    made = set(whole.lines)
    given = ("ball_diameter", "span_teeth", "mean_torque")
    loose = {v.id for v in whole.values() if made.isdisjoint(leaves(link_of(v.inside))) and not v.id.endswith(given)}
    distances = {"gears.central_idler.centre_distance", "gears.idler_shaft.centre_distance"}
    assert loose == {"gears.crank.speed", "gears.central.profile_shift", *distances}


@pytest.mark.parametrize("name", ["r753ie4_gamma.toml", "timing_pair.toml"])
def test_every_value_of_a_shipped_design_is_what_a_line_returned_or_an_input(name):
    drawn = design(read(DESIGNS / name))
    results = whole_solve(drawn)
    assert [v.id for v in results.outcomes["gears"].values() if link_of(v.inside) is None] == []


@pytest.mark.parametrize(
    "teeth, wanted, verdict", [(25, -1.0, "pass"), (26, -1.0, "fail"), (25, 1.0, "fail"), (50, -0.5, "pass")]
)
def test_the_shaft_turns_as_it_must(teeth, wanted, verdict):
    wheels = [wheel("crank", 25, 0.0), wheel("central", 36, 0.0), wheel("idler", 39, 0.0), wheel("shaft", teeth, 0.0)]
    outcome = solve.geometry(
        train(wheels, [mesh("crank", "central"), mesh("central", "idler"), mesh("idler", "shaft")]), SPEED
    )
    (found,) = [
        c for c in solve.with_speed_ratios(outcome, {"shaft": wanted}).checks if c.id == "gears.train.speed_ratio"
    ]
    assert (found.verdict, found.kind) == (verdict, "limit")
    assert f"crank 25 → central 36 → idler 39 → shaft {teeth}" in found.advice


def test_an_even_number_of_meshes_turns_the_shaft_the_wrong_way():
    wheels = [wheel("crank", 25, 0.0), wheel("idler", 36, 0.0), wheel("shaft", 25, 0.0)]
    outcome = solve.geometry(train(wheels, [mesh("crank", "idler"), mesh("idler", "shaft")]), SPEED)
    found = solve.with_speed_ratios(outcome, {"shaft": -1.0}).checks[-1]
    assert found.verdict == "fail" and found.value == pytest.approx(2.0)
    assert "an odd number of meshes from crank to shaft" in found.advice
    blocked = Outcome("gears", "no_solution", reason="none")
    assert solve.with_speed_ratios(blocked, {"shaft": -1.0}) is blocked


def test_errata_name_the_method_of_the_source(whole):
    assert whole.errata and all(e.source == "method of Finotti 2013, Tables 4.5 and 4.6" for e in whole.errata)


def test_numbers_far_outside_any_gear_are_refused_with_words():
    gears = r753(b=1e-303)
    with pytest.raises(NoSolution, match=r"gears\..* is ∞.*give usual ones"):
        solve.rating(gears, solve.geometry(gears, SPEED).result, 1e9, materials())


def test_wrong_speeds_of_the_source(whole):
    speeds = {e.about: e.source_value for e in whole.errata if e.unit == "rpm"}
    assert speeds == {"gears.central.speed": pytest.approx(-2600), "gears.idler.speed": pytest.approx(2600)}


def test_results_can_be_compared_and_sent_to_another_process(whole):
    assert list(published(pickle.loads(pickle.dumps(whole.result)), "gears")) == list(whole.values())


def test_wheel_names_with_a_hyphen():
    gears = train([wheel("crank-1", 25, 0.0), wheel("idler-2", 36, 0.0)], [mesh("crank-1", "idler-2")])
    outcome = solve.geometry(gears, SPEED)
    rated = solve.rating(gears, outcome.result, 1.0, materials())
    assert "crank-1_idler-2.root_stress_crank-1" in shown(solve.merge(outcome, rated))


# --- open shifts and distances
def shifts(wheels, meshes, **said):
    return {name: w.profile_shift for name, w in solved(train(wheels, meshes, **said)).wheels.items()}


def test_the_mate_is_derived_in_either_direction():
    forward = shifts([wheel("a", 36, 0.014), wheel("b", 39)], [mesh("a", "b", 80.555)])
    backward = shifts([wheel("a", 36), wheel("b", 39, forward["b"])], [mesh("a", "b", 80.555)])
    assert backward["a"] == pytest.approx(0.014, abs=1e-15)


def test_a_chain_is_derived_from_its_far_end():
    known = shifts([wheel("a", 25, 0.1), wheel("b", 36), wheel("c", 39)], [mesh("a", "b", 65.9), mesh("b", "c", 80.6)])
    again = shifts(
        [wheel("a", 25), wheel("b", 36), wheel("c", 39, known["c"])], [mesh("a", "b", 65.9), mesh("b", "c", 80.6)]
    )
    assert again == pytest.approx(known, abs=1e-14)


def test_open_shifts_are_chosen_and_said():
    """As many teeth: the same shift; else 0 for the first, and what follows from it."""
    outcome = solve.geometry(
        train([wheel("a", 30), wheel("b", 40), wheel("c", 30, 0.2)], [mesh("a", "b", 75.6), mesh("b", "c")]), SPEED
    )
    assert outcome.result.wheels["a"].profile_shift == 0.2
    assert any("of a: not given; chosen: 0.2" in n for n in outcome.notes)
    outcome = solve.geometry(train([wheel("a", 30), wheel("b", 40)], [mesh("a", "b", 75.6)]), SPEED)
    assert outcome.result.wheels["a"].profile_shift == 0.0
    assert outcome.result.wheels["b"].profile_shift > 0
    assert any("of a: not given; chosen: 0." in n for n in outcome.notes)


def test_two_given_shifts_that_nearly_agree():
    exact = shifts([wheel("a", 36, 0.014), wheel("b", 39)], [mesh("a", "b", 80.555)])["b"]
    outcome = solve.geometry(train([wheel("a", 36, 0.014), wheel("b", 39, -0.156)], [mesh("a", "b", 80.555)]), SPEED)
    assert outcome.result.wheels["b"].profile_shift == exact
    assert any("−0.156 is given" in n for n in outcome.notes)
    assert outcome.result.meshes["a_b"].backlash_nominal == 0


def test_two_given_shifts_that_jam():
    said = r"meshes\.0\.centre_distance_mm = 80\.555.*a 0\.014 and b −0\.15.*jam by 8\.1.*needs b −0\.15597.*b\.profile_shift"
    with pytest.raises(NoSolution, match=said):
        solved(train([wheel("a", 36, 0.014), wheel("b", 39, -0.15)], [mesh("a", "b", 80.555)]))


@pytest.mark.parametrize("less", [0.005, 0.05, 0.2])
def test_two_given_shifts_make_the_backlash(less):
    """j_bn = 2·m_n·sin α_n·Δx: the tooth is thinner by 2·m_n·Δx·tan α_n at the reference circle, and tan α_n·cos
    α_t·cos β_b/cos β = sin α_n."""
    exact = shifts([wheel("a", 36, 0.014), wheel("b", 39)], [mesh("a", "b", 80.555)])["b"]
    outcome = solve.geometry(
        train([wheel("a", 36, 0.014), wheel("b", 39, exact - less)], [mesh("a", "b", 80.555)]), SPEED
    )
    t = outcome.result
    assert t.wheels["b"].profile_shift == exact - less and t.meshes["a_b"].centre_distance == 80.555e-3
    assert t.meshes["a_b"].backlash_nominal == pytest.approx(
        2 * t.system.m_n * math.sin(t.system.alpha_n) * less, rel=1e-9
    )
    assert (
        t.shafts["shaft"].phase_error == pytest.approx(t.meshes["a_b"].play_angle) and t.meshes["a_b"].penetration == 0
    )
    assert any("both profile shifts are given" in n for n in outcome.notes)


def test_a_loose_pair_touches_with_one_flank():
    """Half of the backlash to one side the outlines touch and no more; a micrometre further they enter each other."""
    t = solved(train([wheel("a", 36, 0.014), wheel("b", 39, -0.4)], [mesh("a", "b", 80.555)]))
    m = t.meshes["a_b"]
    both = flank(t.system, t.wheels["a"]), flank(t.system, t.wheels["b"])
    j_wt = circumferential_backlash(
        m.working_diameter_driver, 36, m.working_thickness_driver, m.working_thickness_driven
    )
    assert j_wt > 100e-6 and penetration(m.centre_distance, *both, j_wt) == 0.0
    assert penetration(m.centre_distance, *both, j_wt + 2e-6) == pytest.approx(
        1e-6 * math.cos(m.working_pressure_angle), rel=0.02
    )


def test_a_branching_train():
    wheels = [wheel("a", 25, 0.0), wheel("b", 30, 0.0), wheel("c", 40, 0.0)]
    gears = train(wheels, [mesh("a", "b"), mesh("a", "c")])
    t = solved(gears)
    assert (t.wheels["b"].speed, t.wheels["c"].speed) == pytest.approx((-SPEED * 25 / 30, -SPEED * 25 / 40))
    rated = solve.rating(gears, t, {"a_b": 2.0, "a_c": 1.0}, materials()).result.meshes
    assert rated["a_b"].tangential_force == pytest.approx(2 * rated["a_c"].tangential_force)


def test_nothing_heavier_than_numpy_is_loaded():
    heavy = "scipy", "matplotlib", "reportlab", "textual", "rich", "pint"
    code = f"import sys, calc.gears.solve; print([m for m in {heavy} if m in sys.modules])"
    assert (
        subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.strip() == "[]"
    )


def test_the_reference_diameter_is_found_by_its_old_name_too():
    """So that old replays, scripts and `explain` go on; it is listed once."""
    results = whole_solve(design(read(DESIGNS / "timing_pair.toml")))
    value = results.values()["gears.crank.reference_diameter"]
    assert results.values()["gears.crank.pitch_diameter"] == value and value.label == "Reference diameter"
    assert [v.id for v in results.outcomes["gears"].values() if "pitch_diameter" in v.id] == []
    assert (value.id, value.former) == ("gears.crank.reference_diameter", "gears.crank.pitch_diameter")


@pytest.mark.parametrize("part", ["backlash", "layout", "rating"])
def test_a_part_that_has_no_solution_fails(part):
    outcome = solve.without(solve.geometry(r753(), SPEED), getattr(solve, part.upper()), Text("too close"))
    check = outcome.checks[-1]
    assert (check.id, check.verdict) == (f"gears.train.{part}", "fail")
    assert (check.kind, check.role, check.limit, check.zero_scale) == ("limit", "self", 0.0, 1.0)
    assert str(check.source) == "the part has no values" and str(check.advice) == "too close."


def test_two_wheels_with_nothing_but_their_size_are_of_the_usual_tool():
    """20°, no helix, a tool of 1.25 with a tip of 0.38, one turn a second."""
    pair = solve.solve_pair((25, 39), normal_module=2e-3, face_width=15e-3)
    wheels = [wheel("driver", 25, 0.0), wheel("driven", 39, 0.0)]
    given = train(wheels, [mesh("driver", "driven")], beta=0.0, tool=(1.25, 0.38), ball=None)
    ours, theirs = ({v.id: v.shown for v in published(t, "gears")} for t in (pair, solve.geometry(given, 1.0).result))
    assert ours == theirs and len(ours) > 50


def test_teeth_whose_power_nobody_knows_are_not_verified():
    outcome = solve.not_rated(solve.geometry(r753(), SPEED), Text("no power"))
    check = outcome.checks[-1]
    assert (check.id, check.verdict, outcome.verdict) == ("gears.train.rating", "not_verified", "not_verified")
    assert (check.missing, check.at_best, check.at_worst) == (("gears.power_kW",), "none", "none")
    assert (check.limit, check.zero_scale) == (0.0, 1.0)
    assert "without a torque no tooth is rated" in check.source and "no power" in outcome.notes
