"""`contralbero export`: what stands in the files, and what is refused."""

import csv
import json
from io import StringIO
from itertools import pairwise

import ezdxf
import pytest

from assistant.cli import main
from tests.conftest import DESIGNS, GAMMA

ALPHA = DESIGNS / "r753ie4_alpha.toml"  # of few values
PAIR = DESIGNS / "timing_pair.toml"  # of gears alone

STEPS = ["Engine", "Imbalance", "Counter-shaft", "Bearings", "Gears", "Friction"]

PLAIN = """schema = 1
name = "a shaft alone"
[engine]
name = "twin"
layout = "inline"
cylinders = 2
strokes = 4
bore_mm = 80.0
crank_radius_mm = 40.0
rod_length_mm = 130.0
cylinder_pitch_mm = 90.0
crank_angles_deg = [0.0, 180.0]
piston_mass_g = 400.0
rod_mass_g = 500.0
rated_speed_rpm = 5000.0
[imbalance]
crank_balance_fraction = 0.5
kinematics = "exact"
[countershaft]
mode = "given"
material = "42CrMo4"
bearing_positions_mm = [-60.0, 60.0]
masses = [
    { name = "front", mass_kg = 0.5, radius_mm = 15.0, angle_deg = 180.0, z_mm = -30.0 },
    { name = "rear", mass_kg = 0.5, radius_mm = 15.0, angle_deg = 0.0, z_mm = 30.0 },
]
"""
SECTIONS = """
[[countershaft.sections]]
from_mm = -70.0
to_mm = -50.0
outer_radius_mm = 12.0
[[countershaft.sections]]
from_mm = -50.0
to_mm = 50.0
outer_radius_mm = 20.0
core_radius_mm = 8.0
half_angle_deg = 90.0
angle_deg = 180.0
[[countershaft.sections]]
from_mm = 50.0
to_mm = 70.0
outer_radius_mm = 12.0
"""


@pytest.fixture
def design(tmp_path):
    def written(text):
        path = tmp_path / "shaft.toml"
        path.write_text(text, encoding="utf-8")
        return path

    return written


def run(capsys, *arguments):
    code = main([*map(str, arguments)])
    return code, *capsys.readouterr()


def test_json_is_the_object_of_check(capsys, tmp_path):
    out = tmp_path / "gamma.json"
    code, said, errors = run(capsys, "export", ALPHA, "--json", "-o", out)
    assert code == 0 and errors == "" and said.rstrip().endswith(str(out))
    assert "Friction" in said and "WARN" in said  # the verdict of each step
    _, shown, _ = run(capsys, "check", ALPHA, "--json")
    assert json.loads(out.read_text(encoding="utf-8")) == json.loads(shown)


def test_the_findings_are_not_printed_but_the_verdict_of_each_step(capsys, tmp_path):
    code, said, _ = run(capsys, "export", GAMMA, "--loads", "--speeds", "2600:2600:1", "-o", tmp_path / "loads.csv")
    state, *steps, empty, rows, written = said.splitlines()
    assert code == 0 and state.startswith("FAIL") and not empty and "sums close" in rows and "loads.csv" in written
    assert [line.split()[0] for line in steps] == STEPS and "needs" not in said


def test_csv_has_a_row_for_each_value(capsys, tmp_path):
    out = tmp_path / "gamma.csv"
    assert run(capsys, "export", ALPHA, "--csv", "-o", out)[0] == 0
    rows = list(csv.DictReader(StringIO(out.read_text(encoding="utf-8"))))
    _, shown, _ = run(capsys, "check", ALPHA, "--json")
    values = json.loads(shown)["values"]
    assert list(rows[0]) == ["id", "value", "unit", "label", "symbol"]
    assert {row["id"]: (float(row["value"]) if row["value"] else None, row["unit"], row["label"]) for row in rows} == {
        name: (value["value"], value["unit"], value["label"]) for name, value in values.items()
    }
    assert next(row for row in rows if row["id"] == "countershaft.couple")["symbol"] == "C_S"


def test_dxf_is_the_shaft(capsys, tmp_path, design):
    out = tmp_path / "shaft.dxf"
    code, said, errors = run(capsys, "export", design(PLAIN + SECTIONS), "--dxf", "-o", out)
    assert code == 0 and errors == "" and "Counter-shaft" in said
    document = ezdxf.readfile(out)
    assert not document.audit().errors
    contour = max((p for p in document.modelspace().query('LWPOLYLINE[layer=="VISIBLE"]') if p.closed), key=len)
    xs, ys = zip(*((x, y) for x, y, *_ in contour.get_points()))
    assert (max(xs) - min(xs), max(ys) - min(ys)) == pytest.approx((140.0, 32.0))
    assert "Title, part of a shaft alone" in [text.dxf.text for text in document.layout("A3").query("TEXT")]
    before = out.read_bytes()
    assert run(capsys, "export", design(PLAIN + SECTIONS), "-o", out)[0] == 0  # the ending decides
    assert out.read_bytes() == before


def test_a_shaft_without_outline_says_what_to_add(capsys, tmp_path, design):
    out = tmp_path / "shaft.dxf"
    code, _, errors = run(capsys, "export", design(PLAIN), "--dxf", "-o", out)
    assert code == 2 and not out.exists()
    assert "[[shafts.sections]]" in errors and "core_radius_mm" in errors


# --- gears
def layers(path):
    document = ezdxf.readfile(path)
    assert not document.audit().errors
    return document.modelspace()


def test_a_wheel_is_drawn_with_its_table(capsys, tmp_path):
    out = tmp_path / "idler.dxf"
    code, said, errors = run(capsys, "export", GAMMA, "--gear", "idler", "-o", out)
    assert code == 0 and errors == "" and said.rstrip().endswith(str(out))
    space = layers(out)
    (outline,) = space.query('LWPOLYLINE[layer=="PROFILE"]')
    assert outline.closed and len(outline) % 39 == 0
    about_origin = {c.dxf.layer for c in space.query("CIRCLE") if c.dxf.center.magnitude < 1e-9}
    assert about_origin == {"TIP", "REFERENCE", "BASE", "ROOT", "FORM", "WORKING"}
    words = [text.dxf.text for text in space.query("TEXT")]
    assert "Span over 5 teeth W" in words and "39" in words


def test_beside_its_teeth_a_wheel_has_its_sheet(capsys, tmp_path):
    """The window of the layout shows the wheel in section, and nothing of the teeth."""
    out = tmp_path / "idler.dxf"
    assert run(capsys, "export", GAMMA, "--gear", "idler", "-o", out)[0] == 0
    document = ezdxf.readfile(out)
    layout = document.layout("A3")
    assert "Gear idler" in [text.dxf.text for text in layout.query("TEXT")]
    (window,) = (port for port in layout.query("VIEWPORT") if port.dxf.id != 1)
    scale, x = window.get_scale(), window.dxf.view_center_point[0]
    (teeth,) = document.modelspace().query('LWPOLYLINE[layer=="PROFILE"]')
    left, right = x - window.dxf.width / scale / 2, x + window.dxf.width / scale / 2
    assert right < min(point[0] for point in teeth)
    sizes = {round(d.get_measurement(), 3): d for d in document.modelspace().query("DIMENSION")}
    assert sorted(sizes) == [15.0, 87.052] and all(d.override().get("dimtol") for d in sizes.values())
    assert all(left < d.dxf.defpoint2.x < right for d in sizes.values())


def test_a_coarser_chord_error_gives_fewer_points(capsys, tmp_path):
    sizes = []
    for error in ("0.1", "1", "10"):
        assert run(capsys, "export", PAIR, "--gear", "crank", "--chord-error", error, "-o", tmp_path / "o.dxf")[0] == 0
        sizes.append(len(layers(tmp_path / "o.dxf").query('LWPOLYLINE[layer=="PROFILE"]')[0]))
    assert sizes[0] > sizes[1] > sizes[2]
    assert run(capsys, "export", PAIR, "--gear", "crank", "-o", tmp_path / "o.dxf")[0] == 0
    # 1 µm if nothing is said
    assert len(layers(tmp_path / "o.dxf").query('LWPOLYLINE[layer=="PROFILE"]')[0]) == sizes[1]


def test_the_whole_train_is_drawn(capsys, tmp_path):
    out = tmp_path / "train.dxf"
    assert run(capsys, "export", GAMMA, "--gears", "-o", out)[0] == 0
    assert len(layers(out).query('LWPOLYLINE[layer=="PROFILE"]')) == 4


def test_a_design_of_gears_alone_draws_its_gears(capsys, tmp_path):
    out = tmp_path / "pair.dxf"
    code, _, errors = run(capsys, "export", PAIR, "--dxf", "-o", out)
    assert code == 0 and errors == ""
    assert len(layers(out).query('LWPOLYLINE[layer=="PROFILE"]')) == 2


def test_positions_that_are_given_are_drawn(capsys, tmp_path):
    text = PAIR.read_text(encoding="utf-8")
    for name, place in (("crank", "0.0, 0.0"), ("camshaft", "0.0, 132.67")):
        text = text.replace(f'name = "{name}"', f'name = "{name}"\nposition_mm = [{place}]')
    design, out = tmp_path / "pair.toml", tmp_path / "pair.dxf"
    design.write_text(text, encoding="utf-8")
    assert run(capsys, "export", design, "-o", out)[0] == 0
    centres = {tuple(round(x, 6) for x in c.dxf.center)[:2] for c in layers(out).query('CIRCLE[layer=="TIP"]')}
    assert centres == {(0.0, 0.0), (132.67, 0.0)}


def test_positions_that_the_layout_finds_are_drawn(capsys, tmp_path):
    """Crank and shaft in their places: both idlers stand at their centre distances, wherever the layout puts them."""
    text = GAMMA.read_text(encoding="utf-8").replace("[countershaft]", "[countershaft]\naxis_mm = [-130.0, 103.0]", 1)
    design, out = tmp_path / "gamma.toml", tmp_path / "train.dxf"
    design.write_text(text, encoding="utf-8")
    assert run(capsys, "export", design, "--gears", "-o", out)[0] == 0
    places = [complex(*tuple(c.dxf.center)[:2]) for c in layers(out).query('CIRCLE[layer=="TIP"]')]
    assert places[0] == 0 and places[3] == pytest.approx(103 - 130j)
    assert [abs(b - a) for a, b in pairwise(places)] == pytest.approx([65.80804653, 80.555, 68.698], abs=1e-6)


@pytest.mark.parametrize(
    "arguments, said",
    [
        (("--gear", "nobody", "-o", "o.dxf"), "the wheels are crank, central, idler, shaft"),
        (("--gear", "idler", "-o", "o.csv"), "is for --dxf"),
        (("--gears", "--json", "-o", "o.json"), "is for --dxf"),
        (("--gear", "idler", "--chord-error", "0", "-o", "o.dxf"), "must lie between"),
        (("--gear", "idler", "--chord-error", "nan", "-o", "o.dxf"), "must lie between"),
        (("--gear", "idler", "--chord-error", "few", "-o", "o.dxf"), "invalid float"),
        (("--gear", "idler", "--gears", "-o", "o.dxf"), "not allowed with"),
        (("--chord-error", "2", "-o", "o.dxf"), "is for gears"),
    ],
)
def test_gears_that_can_not_be_drawn_are_refused(capsys, arguments, said, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    code, _, errors = run(capsys, "export", GAMMA, *arguments)
    assert code == 2 and said in errors and not list(tmp_path.iterdir())


def test_a_design_with_neither_shaft_nor_gears_says_so(capsys, tmp_path, design):
    path = design(PLAIN.split("[countershaft]")[0])
    out = tmp_path / "o.dxf"
    code, _, errors = run(capsys, "export", path, "--dxf", "-o", out)
    assert code == 2 and "add [[shafts]]" in errors and "[gears]" in errors and not out.exists()
    code, _, errors = run(capsys, "export", path, "--gears", "-o", out)
    assert code == 2 and "add [gears]" in errors and not out.exists()


# --- what is refused
@pytest.mark.parametrize(
    "arguments, said",
    [
        (("-o", "out.xyz"), ".xyz is not known"),
        (("-o", "out"), "has no ending"),
        (("--dxf", "-o", "out.csv"), "--dxf writes .dxf"),
        (("--json", "-o", "out"), "--json writes .json"),
        (("--csv", "-o", "design.toml"), "--csv writes .csv"),
    ],
)
def test_other_endings_are_refused(capsys, arguments, said, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    code, _, errors = run(capsys, "export", GAMMA, *arguments)
    assert code == 2 and said in errors and not list(tmp_path.iterdir())


def test_all_mistakes_are_named_at_once(capsys, tmp_path, design):
    path = design(PLAIN.replace("bore_mm = 80.0", "bore_mm = -1.0").replace('"42CrMo4"', '"42CrMo5"'))
    code, _, errors = run(capsys, "export", path, "--dxf", "-o", tmp_path / "out.xyz")
    assert code == 2
    assert "bore_mm" in errors and "-o" in errors and ".xyz" in errors


def test_a_file_that_can_not_be_written_is_named(capsys, tmp_path):
    code, _, errors = run(capsys, "export", ALPHA, "--json", "-o", tmp_path / "nowhere" / "out.json")
    assert code == 2 and "nowhere" in errors


def test_formats_exclude_each_other_and_a_path_is_needed(capsys, tmp_path):
    assert run(capsys, "export", GAMMA, "--json", "--csv", "-o", tmp_path / "out.json")[0] == 2
    assert run(capsys, "export", GAMMA, "--json")[0] == 2


# --- the map of the drive over speed
def test_the_map_has_a_row_for_each_speed_and_load(tmp_path, gamma_results):
    path = tmp_path / "map.csv"
    assert main(["export", str(GAMMA), "--csv", "--map", "-o", str(path)]) == 0
    rows = list(csv.DictReader(path.open(encoding="utf-8")))
    speeds = [float(row["speed [rpm]"]) for row in rows]
    assert len(rows) == 60 and speeds == sorted(speeds) and speeds[-1] == 2600.0  # by a default: one load
    for name, id in (
        ("impact_speed [mm/s]", "impact_speed"),
        ("impact_force_low [N]", "impact_force_low"),
        ("impact_force [N]", "impact_force"),
        ("least_force [N]", "least_force"),
        ("separation", "separation"),
        ("impact_power [W]", "impact_power"),
    ):
        published = gamma_results.values()[f"gears.idler_shaft.idle.{id}"].shown
        assert float(rows[0][f"idler_shaft.{name}"]) == pytest.approx(published, rel=1e-6)


@pytest.mark.parametrize(
    ("path", "kind", "words"),
    [
        (ALPHA, "csv", "gears: needed"),
        (PAIR, "csv", "timing_pair.toml: engine: needed"),
        (GAMMA, "json", "is for --csv"),
    ],
)
def test_where_there_is_no_map(tmp_path, capsys, path, kind, words):
    assert main(["export", str(path), "--map", "-o", str(tmp_path / f"map.{kind}")]) == 2
    assert words in capsys.readouterr().err


@pytest.mark.parametrize("arguments", [("export", str(GAMMA), "--dxf", "-o", "x.dxf"), ("serve", str(GAMMA))])
def test_an_extra_that_is_not_installed_is_named(capsys, arguments, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("assistant.extras.find_spec", lambda name: None)
    assert main([*arguments]) == 2
    extra = "dxf" if arguments[0] == "export" else "serve"
    assert f"pip install 'contralbero[{extra}]'" in capsys.readouterr().err and not list(tmp_path.iterdir())
