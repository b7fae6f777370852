"""Slips at the command line: what was meant is named, and no design is lost."""

import json

import pytest

from tests.command import run
from tests.conftest import ROOT


@pytest.mark.parametrize(
    "command", [["report", "{}"], ["compare", "{}", "designs/r753ie4_beta.toml"], ["export", "{}", "--json"]]
)
def test_no_command_writes_over_the_design_that_it_reads(command, tmp_path):
    path = tmp_path / "mine.json"
    raw = (ROOT / "designs" / "r753ie4_gamma.toml").read_bytes()
    path.write_bytes(raw)
    made = run(*(part.format(path) for part in command), "-o", path)
    assert made.returncode == 2 and "is an input of this very command; give another name with -o" in made.stderr
    assert path.read_bytes() == raw


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["chek", "designs/r753ie4_gamma.toml"], "chek: is neither a command nor a file; did you mean check?"),
        (
            ["check", "designs/r753ie4_gamma.toml", "--stp", "bearings"],
            "contralbero check: error: unrecognized arguments: --stp bearings",
        ),
        (
            ["check", "designs/r753ie4_gamma.toml", "--set", "engine.bore_mm=3,5"],
            "must be a number above 0 and up to 1000 mm; write 3.5",
        ),
    ],
)
def test_a_slip_is_named_with_what_was_meant(arguments, said):
    made = run(*arguments)
    assert made.returncode == 2 and said in made.stderr and not made.stdout


def test_a_comma_and_a_table_of_another_name_are_found_in_their_lines(tmp_path):
    path = tmp_path / "x.toml"
    text = (ROOT / "designs" / "r753ie4_gamma.toml").read_text(encoding="utf-8")
    path.write_text(text.replace("bore_mm = 94.0", "bore_mm = 94,5"), encoding="utf-8")
    at = text[: text.index("bore_mm")].count("\n") + 1
    assert f"x.toml:{at}: is not TOML" in (error := run("check", path).stderr) and "written with a point: 94.5" in error
    path.write_text(text.replace("[bearings.front]", "[bearing.front]"), encoding="utf-8")
    at = text[: text.index("[bearings.front]")].count("\n") + 1
    assert f'x.toml:{at}: bearing: is not known; did you mean "bearings"?' in run("check", path).stderr


@pytest.fixture(scope="module")
def shaft(tmp_path_factory):
    """The sized design without what follows the shaft: sooner solved."""
    text = (ROOT / "designs" / "r753ie4_sized.toml").read_text(encoding="utf-8")
    path = tmp_path_factory.mktemp("designs") / "shaft.toml"
    path.write_text(text.partition("\n[bearings]")[0], encoding="utf-8")
    return path


def test_a_bore_in_metres_is_a_caution_that_says_what_was_meant(shaft):
    slips = ["--set", "engine.bore_mm=0.094", "engine.cylinder_pitch_mm=0.105"]
    lines = run("check", shaft, *slips).stdout.split("\n")
    bore = "▲ warn  Far from usual: bore: 0.094 mm, needs 50 to 150 mm (−50 %)  [engine.inputs.bore_mm]"
    assert [line.strip() for line in lines[3:5]] == [bore, "Did you mean bore 94 mm?"]  # before what follows from it
    assert "Did you mean cylinder pitch 105 mm?" in lines[6]
    checks = json.loads(run("check", shaft, *slips, "--json").stdout)["checks"]
    bore = next(check for check in checks if check["id"] == "engine.inputs.bore_mm")
    assert bore["kind"] == "caution" and bore["remedies"][0]["changes"] == {"engine.bore_mm": 94}


def test_what_is_a_little_outside_is_told_with_what_is_usual(shaft):
    slips = ["--set", "engine.bore_mm=45", "engine.cylinder_pitch_mm=210"]
    said = run("check", shaft, *slips).stdout
    assert "2 inputs are not usual: cylinder pitch 210 mm (usual 35 to 200); bore 45 mm (usual 50 to 150)" in " ".join(
        said.split()
    )
    assert "not usual" not in run("check", shaft).stdout
    found = json.loads(run("check", "designs/r753ie4_gamma.toml", "--step", "gears", "--json").stdout)["unusual"]
    assert found == [
        {"key": "gears.wheels.central.span_allowance_um", "value": -2.0, "usual": [-80, -20], "unit": "µm"}
    ]
    assert json.loads(run("check", "designs/r753ie4_gamma.toml", "--step", "engine", "--json").stdout)["unusual"] == []
    assert "not usual" not in run("check", "designs/r753ie4_gamma.toml", "--step", "engine").stdout
    many = ["--set", "engine.bore_mm=45", "engine.crank_radius_mm=15", "engine.cylinder_pitch_mm=210",
            "engine.piston_mass_g=140", "engine.rod_mass_g=190", "engine.rated_speed_rpm=900"]  # fmt: skip
    short, whole = (" ".join(run("check", shaft, *many, *more).stdout.split()) for more in ([], ["--all"]))
    assert "6 inputs are not usual:" in short and "; 2 more" in short and "rod mass 190 g" not in short
    assert "6 inputs are not usual:" in whole and "rod mass 190 g" in whole


def test_what_is_accepted_of_no_check_is_told(tmp_path):
    path = tmp_path / "x.toml"
    path.write_bytes((ROOT / "designs" / "r753ie4_sized.toml").read_bytes())
    said = " ".join(run("set", path, "accepted.bearings.front.mcke=seen").stdout.split())
    assert (
        "bearings.front.mcke is accepted, but this design has no such check; did you mean bearings.front.mckee?" in said
    )


def test_an_element_is_called_in_the_error_as_it_was_in_the_command():
    said = run("check", "designs/r753ie4_gamma.toml", "--set", "gears.wheels.shaft.teeth=25.5").stderr
    assert ": gears.wheels.shaft.teeth: 25.5: must be a whole number" in said
