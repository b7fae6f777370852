# SPDX-License-Identifier: Apache-2.0
"""Every command on designs with several shafts: what all give together first, each shaft by its name, a twin as its
original."""

import json

import pytest

from calc.design.toml_file import design, read
from calc.solve import solve
from tests.command import run
from tests.conftest import DESIGNS

HEAD = """schema = 2
name = "An inline four with two shafts"

[engine]
name = "Own 4"
layout = "inline"
cylinders = 4
strokes = 4
bore_mm = 84.0
crank_radius_mm = 45.0
rod_length_mm = 145.0
cylinder_pitch_mm = 92.0
firing_order = [1, 3, 4, 2]
piston_mass_g = 620.0
rod_mass_g = 680.0
rod_cg_to_big_end_mm = 45.0
rated_speed_rpm = 4500.0
rated_power_kW = 100.0

[imbalance]
crank_balance_fraction = 0.0
kinematics = "exact"
"""
SHAFT = """
[[shafts]]
name = "{name}"
speed_ratio = {ratio}
material = "42CrMo4"
axis_mm = [-60.0, {side}]
core_radius_mm = 21.0
outer_radius_mm = 30.0
gear_z_mm = -122.0
masses = [
    {{ name = "front", mass_kg = {mass}, radius_mm = 12.0, angle_deg = 180.0, z_mm = -58.0 }},
    {{ name = "rear", mass_kg = {mass}, radius_mm = 12.0, angle_deg = 180.0, z_mm = 58.0 }},
]
bearings = [
    {{ name = "front", position_mm = -96.0, diameter_mm = 44.0, length_mm = 22.0, clearance_um = 70.0, {rough} }},
    {{ name = "rear", position_mm = 96.0, diameter_mm = 44.0, length_mm = 22.0, clearance_um = 70.0, {rough} }},
]
"""
ROUGH = "journal_roughness_um = 0.2, housing_roughness_um = 0.4"
TAIL = """
[bearings]
oil = "SAE 30"
supply = "hole"
hole_diameter_mm = 5.0
supply_temperature_C = 90.0
supply_pressure_bar = 3.0
housing_material = "EN AC-43100"

[gears]
normal_module_mm = 2.0
pressure_angle_deg = 20.0
helix_angle_deg = 0.0
face_width_mm = 15.0
wheels = [
    { name = "crank", teeth = 66 },
    { name = "idler", teeth = 42 },
    { name = "wheel-left", teeth = 33, shaft = "left" },
    { name = "wheel-right", teeth = 33, shaft = "right" },
]
meshes = [
    { driver = "crank", driven = "wheel-right" },
    { driver = "crank", driven = "idler" },
    { driver = "idler", driven = "wheel-left" },
]

[friction]
flank_roughness_um = 0.8
"""


def own(name, ratio, side, mass):
    return SHAFT.format(name=name, ratio=ratio, side=side, mass=mass, rough=ROUGH)


PAIR = HEAD + own("left", 2, -78.7, 0.248) + '\n[[shafts]]\nname = "right"\nmirrors = "left"\n' + TAIL
TWO = HEAD + own("left", 2, -78.7, 0.248) + own("right", -2, 78.7, 0.24) + TAIL


@pytest.fixture
def pair(tmp_path):
    (tmp_path / "pair.toml").write_text(PAIR, encoding="utf-8")
    return tmp_path / "pair.toml"


@pytest.fixture
def two(tmp_path):
    (tmp_path / "two.toml").write_text(TWO, encoding="utf-8")
    return tmp_path / "two.toml"


def test_a_check_says_the_sums_then_each_shaft(two):
    done = run("check", two, "--step", "countershaft")
    sums, _, rest = done.stdout.partition("\n left, 2 × crank speed\n")
    left, _, right = rest.partition("\n right, −2 × crank speed\n")
    assert done.stdout.splitlines()[1].startswith("Balance shafts")
    assert "countershaft.residual_order_2_force" in sums and "countershaft.left." not in sums
    assert "countershaft.left.force" in left and "countershaft.right." not in left
    assert "countershaft.right.force" in right
    step, more = done.stdout.splitlines()[-2:]
    assert step.split()[:2] == ["Balance", "shafts"] and more.split()[0] == "countershaft.roll_left_order_2"


@pytest.mark.slow
def test_its_remedies_are_of_each_shaft(two):
    """Films that fail on one shaft are mended there; the other stays as it is."""
    done = run("check", two, "--step", "bearings", "--set", "shafts.right.bearings.*.journal_roughness_um=1")
    assert done.returncode == 1, done.stderr
    last = done.stdout.splitlines()[-1]
    assert "nearest" in last and "shafts.right." in last and "shafts.left." not in last
    assert "to pass: right: " in done.stdout or "for no limit to fail: right: " in done.stdout


@pytest.mark.slow
def test_bearings_are_chosen_for_one_shaft_and_its_twins(two, pair):
    done = run("choose", two, "bearings", "--shaft", "right", "--apply", "1")
    assert done.returncode == 0, done.stderr
    results = solve(design(read(two)))
    assert [c.id for c in results.views["right"].outcomes["bearings"].checks if c.verdict == "fail"] == []
    assert results.design.views["left"].rows[0].length == pytest.approx(0.022)
    wrong = run("choose", pair, "bearings", "--shaft", "right")
    assert wrong.returncode == 2 and "is as left" in wrong.stderr
    nobody = run("choose", two, "countershaft", "--shaft", "middle")
    assert nobody.returncode == 2 and "there are left, right" in nobody.stderr


@pytest.mark.slow
def test_the_worst_shaft_is_chosen_for_where_none_is_named(two):
    done = run("choose", two, "countershaft", "--json")
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["summary"][0].startswith("Of the shaft ")


def test_a_sum_lists_its_shafts_and_a_twin_is_its_original(pair):
    sums = run("explain", pair, "countershaft.residual_order_2_force").stdout
    assert "  left, 2 × crank speed: countershaft.left.force" in sums
    assert "  right, mirrors left: countershaft.right.force" in sums
    twin = run("explain", pair, "bearings.right.front.film_edge").stdout.splitlines()
    assert twin[0] == "bearings.right.front.film_edge: that of left, which it mirrors"
    assert twin[2].startswith("bearings.left.front.film_edge = ")
    masses = run("explain", pair, "shafts.right.masses").stdout
    assert "that of left" in masses and "shafts.left.masses.front.mass_kg = 0.248   an input" in masses


@pytest.mark.slow
def test_what_is_judged_of_a_twin_by_itself_is_its_own(pair):
    pumps = pair.with_name("pumps.toml")
    mirror = 'mirrors = "left"\n'
    load = 'loads = [{ name = "pump", power_kW = 2.0 }]\n'
    pumps.write_text(pair.read_text().replace(mirror, mirror + load))
    said = run("explain", pumps, "bearings.right.front.film_edge_standing").stdout
    assert said.startswith("bearings.right.front.film_edge_standing: right: film at the edge over a turn")


@pytest.mark.slow
def test_a_drawing_for_each_that_is_no_twin(two, pair, tmp_path):
    assert run("export", two, "-o", tmp_path / "x.dxf").returncode == 0
    assert run("export", pair, "-o", tmp_path / "y.dxf").returncode == 0
    assert sorted(path.name for path in tmp_path.glob("*.dxf")) == ["x-left.dxf", "x-right.dxf", "y.dxf"]


def test_one_of_several_shafts_is_searched(two):
    several = run("design", two, "--dry")
    assert several.returncode == 2 and "there are several shafts: name one of left, right" in several.stderr
    right = run("design", two, "--dry", "--shaft", "right")
    assert right.returncode == 0, right.stderr
    assert "The shaft right is searched; the others stay as they are: left." in right.stdout
    assert "shafts.right.core_radius_mm: " in right.stdout and "shafts.left.core_radius_mm" not in right.stdout


def test_keys_of_one_shaft_are_none_of_several(two):
    done = run("set", two, "bearings.front.length_mm=20")
    assert done.returncode == 2
    assert "there are several shafts: shafts.left.bearings.front.length_mm, shafts.right…" in done.stderr


def test_an_error_names_shaft_and_bearing(tmp_path):
    (tmp_path / "x.toml").write_text(TWO.replace("length_mm = 22.0", "length_mm = -22.0", 1), encoding="utf-8")
    done = run("check", tmp_path / "x.toml")
    assert "shafts.left.bearings.front.length_mm: -22.0: must be" in done.stderr


@pytest.mark.slow
def test_shafts_of_other_names_are_compared(two, tmp_path):
    """Of the same ratio on the same side; that of the other has the name that it has in the first."""
    other = TWO.replace('"left"', '"port"').replace("mass_kg = 0.248", "mass_kg = 0.24")
    (tmp_path / "other.toml").write_text(other, encoding="utf-8")
    found = json.loads(run("compare", two, tmp_path / "other.toml", "--json").stdout)
    values = {row["id"] for row in found["values"] if None not in (row["a"], row["b"])}
    assert "countershaft.left.force" in values
    assert not any(".port." in row["id"] for row in found["values"] if row["id"].startswith(("countershaft", "gears")))


@pytest.mark.slow
@pytest.mark.parametrize("name", ["pair", "two", "r754ie4_balance_shafts"])
def test_no_command_breaks(name, pair, two, tmp_path):
    path = {"pair": pair, "two": two}.get(name, DESIGNS / f"{name}.toml")
    commands = [
        ["check", path, "--all"],
        ["check", path, "--json"],
        ["compare", path, DESIGNS / "r753ie4_gamma.toml"],
        ["compare", DESIGNS / "r753ie4_gamma.toml", path],
        ["export", path, "--json", "-o", tmp_path / "x.json"],
        ["export", path, "--csv", "-o", tmp_path / "x.csv"],
        ["export", path, "--dxf", "-o", tmp_path / "x.dxf"],
        *(["choose", path, step] for step in ("engine", "countershaft", "bearings", "gears", "mounting")),
        ["design", path, "--dry"],
        ["sweep", path, "--vary", "shafts.*.core_radius_mm=20:21:2", "--processes", "1"],
        ["report", path, "-o", tmp_path / "x.pdf"],
    ]
    codes = {" ".join(map(str, words[:1] + words[2:3])): run(*words).returncode for words in commands}
    assert set(codes.values()) <= {0, 1, 2, 3}, codes
