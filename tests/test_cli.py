"""The command line: names, exit codes, errors, and what it leaves alone."""

import json
import shutil
from pathlib import Path
from typing import get_args

import pytest

from assistant.commands import published as validate
from assistant.commands.check import exit_code
from calc.sheet.verdict import TITLES, State
from calc.studies.shipped import designs, shipped_name
from tests.command import run, run_apart
from tests.conftest import DESIGNS, GAMMA, ROOT, SHIPPED


@pytest.fixture(scope="module")
def checked():
    done = run_apart("check", GAMMA, "--json")
    return done, json.loads(done.stdout)


def test_check_prints_one_json_object(checked):
    done, found = checked
    assert done.returncode == 1 and done.stderr == ""
    keys = ("schema", "program", "version", "design", "verdict", "counts", "values", "checks", "steps", "not_counted")
    assert set(keys) <= set(found)
    assert found["schema"] == 2 and found["program"] == "contralbero"
    assert found["verdict"] == "fail" and found["counts"]["failed"] > 0
    assert len(found["design"]["sha256"]) == 64


NAMES = """engine.reciprocating_mass engine.rotating_mass engine.lambda imbalance.required_couple imbalance.required_couple_phase
imbalance.mistiming_per_degree countershaft.couple countershaft.couple_phase countershaft.residual_order_1_couple
countershaft.reaction_front countershaft.reaction_rear friction.bearing_loss friction.mesh_loss friction.windage_loss
friction.total_loss friction.crank_torque gears.phase_error gears.residual_couple""".split()
NAMES += [
    f"imbalance.order_{n}.{kind}_{sense}{tail}"
    for n in (1, 2, 4, 6)
    for kind in ("force", "couple")
    for sense in ("forward", "backward")
    for tail in ("", "_phase")
]
NAMES += [
    f"imbalance.order_{n}.{kind}_peak_{way}"
    for n in (1, 2)
    for kind in ("force", "couple")
    for way in ("vertical", "horizontal")
]
NAMES += [
    f"bearings.{b}.{name}"
    for b in ("front", "rear")
    for name in """specific_load heat_index clearance_hot clearance_cold film film_edge
film_double_load speed_of_thinnest_film temperature_rise friction_power oil_flow""".split()
]
NAMES += [
    f"bearings.{b}.{route}.{name}"
    for b in ("front", "rear")
    for route in ("raimondi_boyd", "falz", "din31652", "reynolds")
    for name in ("film", "temperature_rise", "friction_power", "sommerfeld", "oil_flow")
]
NAMES += [
    f"bearings.{b}.reynolds.{name}"
    for b in ("front", "rear")
    for name in ("eccentricity", "attitude_angle", "friction_variable")
]
NAMES += [
    f"gears.{w}.{name}"
    for w in ("crank", "central", "idler", "shaft")
    for name in """tip_diameter pitch_diameter base_diameter root_diameter
form_diameter profile_shift tip_thickness tip_thickness_normal over_balls over_balls_min over_balls_max""".split()
]
NAMES += ["gears.central.span_5", "gears.central.span_5_min", "gears.central.span_5_max", "gears.idler.span_5"]
MESHES = ("crank_central", "central_idler", "idler_shaft")
NAMES += [
    f"gears.{m}.{name}"
    for m in MESHES
    for name in """transverse_contact_ratio overlap_ratio working_pressure_angle working_helix_angle
backlash_min backlash_max working_diameter_driver working_diameter_driven sap_diameter_driver sap_diameter_driven specific_sliding_driver
specific_sliding_driven contact_stress""".split()
]
NAMES += [
    f"friction.{m}.{name}"
    for m in MESHES
    for name in ("loss", "efficiency", "loss_factor", "film_min", "friction_mean", "source.loss", "source.film_min")
]


NAMES += [
    f"countershaft.{name}"
    for name in """mass slope_front slope_rear slope_front_stiff slope_rear_stiff first_critical_speed bolt_preload
residual_unbalance_permitted""".split()
]


@pytest.mark.parametrize("name", NAMES)
def test_the_names_that_are_promised(checked, name):
    value = checked[1]["values"][name]
    assert isinstance(value["value"], float) and value["label"] and "unit" in value


LIMITS = [f"bearings.{b}.{n}" for b in ("front", "rear") for n in ("film_edge", "temperature", "clearance_cold")]
LIMITS += [f"countershaft.{n}" for n in ("residual", "first_critical_speed", "bending_stress")]
LIMITS += [*(f"gears.{m}.{n}" for m in MESHES for n in ("backlash", "contact_ratio"))]
LIMITS += [f"gears.{w}.{n}" for w in ("crank", "central", "idler", "shaft") for n in ("undercut", "tip_thickness")]
ADVICE = [
    f"bearings.{b}.{n}"
    for b in ("front", "rear")
    for n in ("length_ratio_usual", "heat_index", "film_double_load", "transition", "mckee")
]
CAUTION = [
    *(f"bearings.{b}.film_edge_corner" for b in ("front", "rear")),
    "gears.central_idler.backlash_worst",
    *(f"countershaft.{n}" for n in ("slope_front", "slope_rear", "rigid", "bolts.slip_vdi", "drain.clamp")),
]
METHOD = ["bearings.front.routes_spread", "friction.crank_central.regime", "gears.crank_central.line_load"]
KINDS = {"limit": LIMITS, "caution": CAUTION, "advice": ADVICE, "method": METHOD}


@pytest.mark.parametrize("name, kind", [(n, kind) for kind, names in KINDS.items() for n in names])
def test_the_checks_that_are_promised(checked, name, kind):
    (found,) = [c for c in checked[1]["checks"] if c["id"] == name]
    assert found["kind"] == kind and found["source"]
    assert found["verdict"] == "pass" or found["advice"] or found["missing"]


def test_a_sized_shaft_says_its_sectors_and_its_envelope():
    done = run("check", DESIGNS / "r753ie4_sized.toml", "--json", "--step", "countershaft")
    found = json.loads(done.stdout)
    assert done.returncode == 0
    assert found["verdict"] == found["steps"]["countershaft"] != "fail"
    for name in (
        "mass",
        "sector_half_angle",
        "sector_length",
        "slope_front",
        "slope_rear_stiff",
        "first_critical_speed",
        "bolt_preload",
        "residual_unbalance_permitted",
        "scatter.couple_error",
        "hole_couple",
    ):
        assert isinstance(found["values"][f"countershaft.{name}"]["value"], float)
    kinds = {c["id"]: c["kind"] for c in found["checks"]}
    assert all(kinds[f"countershaft.{name}"] == "limit" for name in ("residual", "envelope"))
    assert all(kinds[f"countershaft.{name}"] == "caution" for name in ("balance_grade", "slope_front", "slope_rear"))


def test_an_envelope_that_is_too_small_has_no_solution_and_says_what_it_holds():
    done = run("check", DESIGNS / "r753ie4_sized.toml", "--set", "countershaft.outer_radius_mm=40")
    assert done.returncode == 3 and done.stderr == ""
    assert "N·m at most" in done.stdout and "an outer radius of" in done.stdout


def test_verdicts_follow_from_value_limit_kind_and_ends(checked):
    for c in checked[1]["checks"]:
        low, high = c["limit"] if isinstance(c["limit"], list) else (None, None)

        def kept(value, c=c, low=low, high=high):
            if low is not None:
                return low <= value <= high
            ways = {">=": value >= c["limit"], ">": value > c["limit"], "<=": value <= c["limit"]}
            return (ways | {"<": value < c["limit"]})[c["sense"]]

        judges = c["kind"] in ("limit", "caution")
        passed_over = {"limit": "fail", "caution": "warn"}.get(c["kind"], "note")
        if c["value"] is None:  # nobody knows it
            assert c["finding"] == ("not_verified" if c["kind"] in ("limit", "caution") else "note"), c
            assert c["missing"] and c["at_best"] == c["at_worst"] == "none", c
            continue
        inside = kept(c["value"])
        assert c["margin"] <= 0 if not inside else c["margin"] >= 0
        if c["scale"]:
            assert c["margin"] == pytest.approx(c["gap"] / c["scale"])
        if judges and c["at_best"] is not None:
            best, worst = (
                kept(end) if isinstance(end, float) else {"holds": True}.get(end)
                for end in (c["at_best"], c["at_worst"])
            )
            if best is False:
                assert c["finding"] == passed_over, c
                continue
            if not (best and worst and inside):
                assert c["finding"] == "not_verified", c
                continue
        if inside:  # one whose limit may be used up is never narrow
            assert c["finding"] == "pass" or ((c["finding"], c["kind"]) == ("warn", "limit") and c["margin"] < 0.05), c
        else:
            assert c["finding"] == passed_over, c
        assert c["verdict"] == c["finding"]  # nothing is accepted


def test_the_source_is_corrected_beside_its_own_values(checked):
    errata = {e["about"]: e["source_value"] for e in checked[1]["errata"]}
    assert errata["imbalance.order_2.couple_peak_vertical"] == pytest.approx(188.05, abs=0.01)
    assert checked[1]["values"]["imbalance.order_2.couple_peak_vertical"]["value"] == pytest.approx(386.8, abs=0.05)
    assert errata["bearings.front.falz.film"] == pytest.approx(12.9, abs=0.1)
    assert any(about.endswith("contact_stress") for about in errata)
    assert any(about.endswith(".speed") for about in errata)


def test_the_steps_of_the_source_design(checked):
    assert checked[1]["steps"] == {
        "engine": "computed",
        "imbalance": checked[1]["steps"]["imbalance"],
        "countershaft": checked[1]["steps"]["countershaft"],
        "bearings": "fail",
        "gears": "fail",
        "friction": checked[1]["steps"]["friction"],
        "mounting": "not_asked",
    }
    assert checked[1]["steps"]["imbalance"] in ("computed", "warn")


def test_a_check_is_a_screen():
    text = run("check", GAMMA).stdout
    first = next(n for n, line in enumerate(text.splitlines()) if line.startswith("Engine "))
    verdicts = text.splitlines()[first : first + 6]  # behind what is open: what stands last is what a terminal shows
    assert (
        text.startswith("FAIL: ")
        and "\n✗ FAIL  " in text
        and [line.split()[0] for line in verdicts]
        == [
            "Engine",
            "Imbalance",
            "Counter-shaft",
            "Bearings",
            "Gears",
            "Friction",
        ]
    )
    assert "imbalance.required_couple 572.9 N·m" in verdicts[1] and "bearings.front.film_edge 7.409 µm" in verdicts[3]
    assert len(text.splitlines()) < 65 and "--all, or --step engine|" in text


def test_check_with_all_has_every_value_and_every_check_of_the_json(checked):
    text = run("check", GAMMA, "--all").stdout
    # an old name beside the present one: in the JSON only
    former = [id for id in checked[1]["values"] if id.endswith(".pitch_diameter") or ".din31652." in id]
    assert len(former) == 4 + 2 * 10
    for name in [*(checked[1]["values"].keys() - set(former)), *(c["id"] for c in checked[1]["checks"])]:
        assert name in text


def test_set_changes_an_input_for_one_run():
    before = GAMMA.read_bytes()
    done = run("check", GAMMA, "--json", "--set", "bearings.front.length_mm=34", "--set", "engine.rated_speed_rpm=1000")
    assert json.loads(done.stdout)["values"]["imbalance.required_couple"]["value"] == pytest.approx(84.753, abs=5e-4)
    assert GAMMA.read_bytes() == before


def test_one_step_only():
    found = json.loads(run("check", GAMMA, "--json", "--step", "engine").stdout)
    assert set(found["steps"]) == {"engine"}
    assert all(name.startswith("engine.") for name in found["values"])


@pytest.mark.parametrize(
    "arguments, words",
    [
        (["check", "nowhere.toml"], ["nowhere.toml", "cannot be read"]),
        (["check"], ["usage"]),
        (["check", GAMMA, "--set", "a"], ["KEY=VALUE"]),
        (["check", GAMMA, "--set", "bearings.front.lenght_mm=3", "--set", "x=1"], ["length_mm", "x: is not known"]),
        (["check", GAMMA, "--set", "bearings.front.length_mm=-3"], ["bearings.front.length_mm", "above 0"]),
        (["check", GAMMA, "--step", "wheels"], ["--step", "engine, imbalance"]),
        (["explain", GAMMA, "bearings.front.flim"], ["bearings.front.film"]),
        (["report", GAMMA, "-o", "/nowhere/at/all.pdf"], ["cannot be written"]),
        (["replay", GAMMA], ["design", "is missing"]),
        (["new", "x.toml", "--engine", "v99"], ["v99", "r753ie4"]),
        (["set", GAMMA, "engine.bore_mm=wide"], ["engine.bore_mm", "a number"]),
        (["frobnicate.toml", "--help-me"], ["usage"]),
        (["new"], ["needs the name"]),
    ],
)
def test_bad_use_is_exit_code_2_without_a_traceback(arguments, words, tmp_path):
    before = GAMMA.read_bytes()
    done = run(*arguments, cwd=tmp_path)
    assert done.returncode == 2, done
    assert "Traceback" not in done.stderr
    assert all(w in done.stderr for w in words), done.stderr
    assert GAMMA.read_bytes() == before and list(tmp_path.iterdir()) == []


def test_all_that_is_wrong_with_a_counter_shaft_is_said_at_once(tmp_path):
    path = tmp_path / "d.toml"
    text = (DESIGNS / "r753ie4_sized.toml").read_text(encoding="utf-8")
    wrong = {
        "outer_radius_mm = 43.0": "outer_radius_mm = nan",
        'balance_grade = "G16"': 'balance_grade = "G17"',
        'thread = "M10x1.5"': 'thread = "10"',
        "hose_max_mm = 24.0": "hose_max_mm = 2.0",
        "count = 4\n\n[countershaft.scatter]": "count = 0\n\n[countershaft.scatter]",
        'material = "20CrNi4"\nspeed_ratio = -1': 'material = "cheese"\nspeed_ratio = 0.5',
    }
    for old, new in wrong.items():
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    path.write_text(text, encoding="utf-8")
    done = run("check", path)
    assert done.returncode == 2 and done.stdout == "" and "Traceback" not in done.stderr
    for key in (
        "outer_radius_mm",
        "balance_grade",
        "bolts.thread",
        "oil_drain.hose_max_mm",
        "holes.count",
        "material",
        "speed_ratio",
    ):
        (line,) = [line for line in done.stderr.splitlines() if f" countershaft.{key}: " in line]
        assert key.rsplit(".", 1)[-1] in text.splitlines()[int(line.removeprefix(str(path)).split(":")[1]) - 1]


def test_no_solution_is_exit_code_3():
    done = run("check", GAMMA, "--set", "countershaft.masses.front.mass_kg=300")
    assert done.returncode == 3
    assert "no film carries" in done.stdout


def test_a_passing_step_is_exit_code_0():
    assert run("check", GAMMA, "--step", "engine").returncode == 0


STATES = {  # exit code, and with --strict
    "no_solution": (3, 3),
    "blocked": (0, 4),
    "not_asked": (0, 0),
    "fail": (1, 1),
    "not_verified": (0, 4),
    "not_judged": (0, 4),
    "computed": (0, 0),
    "warn": (0, 4),
    "pass": (0, 0),
}


@pytest.mark.parametrize("state", get_args(State))
def test_the_exit_code_of_every_state(state):
    assert (exit_code(state), exit_code(state, strict=True)) == STATES[state]


@pytest.mark.parametrize(
    "arguments",
    [
        pytest.param([GAMMA], marks=pytest.mark.slow),
        [GAMMA, "--step", "engine"],
        [GAMMA, "--step", "mounting"],
        [GAMMA, "--step", "bearings", "--set", "countershaft.masses.front.mass_kg=300"],
        pytest.param([DESIGNS / "r754ie4_balance_shafts.toml"], marks=pytest.mark.slow),
        [DESIGNS / "r754ie4_balance_shafts.toml", "--step", "countershaft"],
        [DESIGNS / "thesis_oils.toml"],
        [DESIGNS / "twin_mounting.toml"],
        [DESIGNS / "r753ie4_sized.toml", "--set", "countershaft.outer_radius_mm=40", "--step", "bearings"],
    ],
    ids=lambda arguments: " ".join(str(word).rpartition("/")[2] for word in arguments),
)
def test_the_exit_code_is_that_of_the_state_in_the_first_line(arguments):
    loose, strict = (run("check", *arguments, "--json", *more) for more in ((), ("--strict",)))
    found = json.loads(loose.stdout)
    assert (loose.returncode, strict.returncode) == STATES[found["verdict"]] and strict.stdout == loose.stdout
    if "--step" in arguments:
        assert found["verdict"] == found["steps"][arguments[arguments.index("--step") + 1]]
    first = run("check", *arguments, "--strict").stdout.split("\n")[0]
    assert first.partition(": ")[0] == TITLES[found["verdict"]]


def test_help_names_every_command():
    text = run_apart("--help").stdout
    assert all(name in text for name in ("new", "check", "explain", "report", "replay", "set", "validate"))
    assert run_apart("--version").stdout.startswith("contralbero ")


def test_a_session_without_a_terminal_says_so():
    done = run_apart(GAMMA)
    assert done.returncode == 2 and "terminal" in done.stderr


def test_new_writes_a_complete_design_and_never_over_another(tmp_path):
    assert run("new", "mine.toml", cwd=tmp_path).returncode == 0
    assert run("check", "mine.toml", cwd=tmp_path).returncode == 1
    before = (tmp_path / "mine.toml").read_bytes()
    assert run("new", "mine.toml", cwd=tmp_path).returncode == 2
    assert (tmp_path / "mine.toml").read_bytes() == before


def test_a_shipped_engine_makes_a_design(tmp_path):
    listed = [line.split()[0] for line in run("new", "--list").stdout.splitlines()]
    for name in (listed[0], "twin-180", "v12-60"):
        assert name in listed
        assert run("new", f"{name}.toml", "--engine", name, cwd=tmp_path).returncode == 0
        assert run("check", f"{name}.toml", "--step", "imbalance", cwd=tmp_path).returncode == 0
    done = run("check", "twin-180.toml", cwd=tmp_path)  # its couple turns backward: complete, and no limit fails
    assert done.returncode == 0 and "not used" not in done.stdout


def test_every_shipped_design_is_an_example_that_can_be_written(tmp_path):
    """As installed there is no folder `designs/` beside the user."""
    names = [shipped_name(path) for path in designs()]
    assert len(names) > 20
    for n, name in enumerate(names):
        done = run("new", f"{n}.toml", "--example", name, cwd=tmp_path)
        assert done.returncode == 0 and (tmp_path / f"{n}.toml").read_bytes() == (DESIGNS / f"{name}.toml").read_bytes()
    as_in_docs = run("new", "again.toml", "--example", "designs/r753ie4_gamma.toml", cwd=tmp_path)
    assert as_in_docs.returncode == 0 and (tmp_path / "again.toml").read_bytes() == GAMMA.read_bytes()
    wrong = run("new", "0.toml", "--example", "gama", "--mounts", cwd=tmp_path)
    assert wrong.returncode == 2 and all(name in wrong.stderr for name in names)
    assert "0.toml: exists already" in wrong.stderr and "--mounts: is for an engine" in wrong.stderr


def test_set_edits_in_place_and_keeps_the_comments(tmp_path):
    path = tmp_path / "d.toml"
    shutil.copy(GAMMA, path)
    done = run("set", path, "bearings.front.length_mm=34", "gears.wheels.central.span_allowance_um=[-20, -30]")
    assert done.returncode == 0, done.stderr
    text = path.read_text()
    assert "length_mm = 34" in text and "[-20, -30]" in text
    assert "# the text prints 0.6; only 0.61 gives the source's numbers" in text
    assert (tmp_path / "d.toml.bak").read_bytes() == GAMMA.read_bytes()
    assert done.stdout.split("\n")[0] == run("check", path).stdout.split("\n")[0] != ""


def test_set_leaves_the_file_alone_when_the_design_would_be_wrong(tmp_path):
    path = tmp_path / "d.toml"
    shutil.copy(GAMMA, path)
    assert run("set", path, "bearings.front.length_mm=34", "gears.wheels.central.teeth=2").returncode == 2
    assert path.read_bytes() == GAMMA.read_bytes() and len(list(tmp_path.iterdir())) == 1


@pytest.mark.parametrize(
    "name",
    [
        "imbalance.required_couple",
        "countershaft.reaction_rear",
        "bearings.front.film",
        "gears.idler_shaft.contact_stress",
        "countershaft.slope_front",
        "countershaft.bolt_slip_safety",
        "countershaft.clamp_nominal",
    ],
)
def test_explain_goes_back_to_the_inputs(name):
    done = run("explain", GAMMA, name)
    assert done.returncode == 0, done.stderr
    assert name in done.stdout and "←" in done.stdout and " = " in done.stdout


def test_explain_says_what_puts_a_check_outside_the_validity_of_its_formula():
    beyond = "Its check holds by a formula outside its validity: Load per face width idler–shaft (−94 %)"
    sized = DESIGNS / "r753ie4_sized.toml"
    assert run("explain", sized, "gears.idler_shaft.safety_contact").stdout.splitlines()[1] == beyond
    assert "outside its validity" not in run("explain", sized, "bearings.front.film_edge").stdout


def test_explain_of_the_film_reaches_the_engine():
    text = run("explain", GAMMA, "bearings.front.film").stdout
    assert (
        "← engine.rated_speed_rpm" in text
        and "← shafts.shaft.masses.front.mass_kg" in text
        and "← bearings.supply_temperature_C" in text
    )
    assert "9.557 µm" in text


def test_validate_compares_with_published_values(validation, monkeypatch):
    monkeypatch.setattr(validate, "rows", lambda: validation[0])
    monkeypatch.setattr(validate, "unmet", lambda: validation[1])
    done = run("validate")
    assert done.returncode == 0, done.stdout
    found = json.loads(run("validate", "--json").stdout)
    assert len(found["rows"]) > 300
    assert {"countershaft.bolt_preload_source", "countershaft.left.reaction_middle", "countershaft.sector_mass"} <= {
        r["what"] for r in found["rows"]
    }
    assert all(row["source"] and row["verdict"] == "pass" for row in found["rows"])


REPLAYS = sorted((ROOT / "tests" / "replays").glob("*.toml"))
LONG = ("r753ie4_drive", "r753ie4_sized")


@pytest.mark.parametrize(
    "path",
    [pytest.param(path, marks=pytest.mark.slow) if path.stem in LONG else path for path in REPLAYS],
    ids=lambda path: path.stem,
)
def test_shipped_replays_agree(path):
    done = run("replay", path)
    assert done.returncode == 0, done.stdout


def test_a_replay_that_differs_is_exit_code_1(tmp_path):
    script = tmp_path / "r.toml"
    script.write_text(
        f'schema = 1\ndesign = "{GAMMA}"\n[[expect]]\nvalue = "engine.lambda"\nis = 0.5\nunit = ""\nrel = 1e-3\nkind = "recorded"\n'
    )
    done = run("replay", script)
    assert done.returncode == 1 and "engine.lambda" in done.stdout


def test_report_prints_the_verdicts_and_why(tmp_path):
    done = run("report", GAMMA, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "r753ie4_gamma.pdf").read_bytes().startswith(b"%PDF")
    assert "FAIL" in done.stdout and "Film at the edge, front" in done.stdout and "Lengthen" in done.stdout


@pytest.mark.slow
def test_designs_are_all_checked():
    for path in SHIPPED:
        assert run("check", path).returncode in (0, 1)


def test_nothing_of_this_machine_is_printed():
    assert str(Path.home()) not in run("check", "designs/r753ie4_gamma.toml").stdout


def test_choose_lists_the_firing_orders_and_writes_one(tmp_path):
    path = tmp_path / "five.toml"
    assert run("new", path, "--engine", "inline-5").returncode == 0
    listed = json.loads(run("choose", path, "engine", "--json", "--top", "30").stdout)
    assert listed["rows"][0][:2] == ["", "1-2-4-5-3"]  # the design as it is
    orders = [row[1] for row in listed["rows"][1:]]
    assert len(orders) == 24 and "1-2-4-5-3" in orders
    number = orders.index("1-5-2-4-3") + 1 if "1-5-2-4-3" in orders else 2
    done = run("choose", path, "engine", "--apply", number)
    assert done.returncode == 0 and f"now fires {orders[number - 1]}" in done.stdout
    assert str(list(map(int, orders[number - 1].split("-")))) in path.read_text(encoding="utf-8")
    assert path.with_suffix(".toml.bak").exists()


@pytest.mark.parametrize(
    "arguments, words",
    [
        (("choose", GAMMA, "friction"), "nothing to choose here yet"),
        (("choose", GAMMA, "engine", "--apply", "9"), "from 1 to 2"),
        (("choose", DESIGNS / "timing_pair.toml", "engine"), "needed"),
        (("sweep", GAMMA, "--vary", "engine.rated_speed_rpm=1:2:3", "--step", "gear"), "is no step"),
    ],
)
def test_what_can_not_be_chosen_or_swept_is_said(arguments, words):
    done = run(*arguments)
    assert done.returncode == 2 and words in done.stderr and "Traceback" not in done.stderr


def test_where_nothing_can_be_listed_the_exit_code_is_three(tmp_path):
    path = tmp_path / "v12.toml"
    assert run("new", path, "--engine", "v12-60").returncode == 0
    assert run("set", path, "engine.bank_angle_deg=65").returncode == 0
    done = run("choose", path, "engine")
    assert done.returncode == 3 and "not listed" in done.stderr


def test_explain_says_what_is_not_there_and_what_has_no_solution():
    done = run("explain", GAMMA, "countershaft.slope_limit")
    assert done.returncode == 2 and "did you mean countershaft.slope" in done.stderr
    small = DESIGNS / "r753ie4_sized.toml"
    done = run("check", small, "--set", "countershaft.outer_radius_mm=38", "--step", "countershaft")
    assert done.returncode == 3 and "the journals as they are leave an outer radius of 43 mm" in done.stdout


@pytest.mark.parametrize(
    "key, head, help",
    [
        ("engine.bore_mm", " = 94.0   an input\n", "    Bore, mm. Diameter of the cylinders"),
        ("engine.bank_angle_deg", "   an input, left out\n", "    Bank angle, °. Between the banks"),
        ("bearings.*.length_mm", "shafts.shaft.bearings.rear.length_mm = 26.5   an input\n", "    Length, mm. Along"),
    ],
)
def test_an_input_is_explained_by_its_help(key, head, help):
    done = run("explain", GAMMA, key)
    assert done.returncode == 0 and head in done.stdout and help in done.stdout


@pytest.mark.parametrize(
    "check, said",
    [
        ("bearings.rear.slope_given", "taken from the inputs: shafts.shaft.bearings.rear.slope_mrad"),
        ("countershaft.support.wall", "taken from the inputs: shafts.shaft.support.wall_mm"),
    ],
)
def test_a_check_on_no_published_value_is_explained_by_what_it_judges(check, said):
    done = run("explain", GAMMA, check)
    assert done.returncode == 0 and done.stdout.startswith(f"{check}: ") and said in done.stdout


def test_an_engine_with_numbers_of_its_own_is_no_shipped_one():
    from calc.sheet.errors import BadInput
    from calc.studies.shipped import engine_alone

    assert engine_alone("inline-4", {}).data["engine"]["name"] != "own-inline-4"
    assert engine_alone("inline-4", {"engine.bore_mm": 84}).data["engine"]["name"] == "own-inline-4"
    assert engine_alone("inline-4", {"engine.bore_mm": 84, "name": "mine"}).data["engine"]["name"] == "mine"
    with pytest.raises(BadInput) as caught:
        engine_alone("inline-4", {"engine.bore_mm": -84, "engine.bor": 3})
    assert len(caught.value.errors) == 2
