# SPDX-License-Identifier: Apache-2.0
"""`contralbero export --step`: shafts as solids, and what is refused."""

import pytest

from assistant import extras
from assistant.cli import main
from tests.test_export import PLAIN, SECTIONS

WITHOUT = 'a STEP file needs the extra "cad": pip install "contralbero[cad]" (380 MB)'


def pair(angle=180.0, twin='mirrors = "left"'):
    """Two shafts, the second the mirror image of the first, whose sector stands at an angle; holes in both masses."""
    head, shaft = PLAIN.replace("schema = 1", "schema = 2").split("[countershaft]")
    shaft = shaft.replace("bearing_positions_mm = [-60.0, 60.0]", 'name = "left"\nspeed_ratio = 1')
    bearings = "".join(
        f'\n[[shafts.bearings]]\nname = "{name}"\nposition_mm = {z}\n' for name, z in (("front", -60.0), ("rear", 60.0))
    )
    sections = SECTIONS.replace("countershaft", "shafts").replace("angle_deg = 180.0", f"angle_deg = {angle}")
    holes = "\n[shafts.holes]\ndiameter_mm = 6.0\ndepth_mm = 5.0\ncount = 2\n"
    return f'{head}[[shafts]]{shaft}{bearings}{sections}{holes}\n[[shafts]]\nname = "right"\n{twin}\n'


@pytest.fixture
def run(tmp_path, capsys):
    """Exports a design of some text, and gives the exit code, the files that came out and what was said."""

    def export(text, *options, name="out.step"):
        (tmp_path / "design.toml").write_text(text, encoding="utf-8")
        code = main(["export", str(tmp_path / "design.toml"), *options, "-o", str(tmp_path / name)])
        said = capsys.readouterr()
        files = {path.name: path.read_bytes() for path in sorted(tmp_path.glob("*.st*p"))}
        return code, files, said.out + said.err

    return export


def test_without_the_extra_it_is_said(run, monkeypatch):
    monkeypatch.setattr(extras, "find_spec", lambda module: None)
    code, files, said = run(PLAIN + SECTIONS, "--step")
    assert code == 2 and not files and WITHOUT in said


def test_a_shaft_is_written_the_same_each_time(run):
    pytest.importorskip("OCP")
    code, files, said = run(PLAIN + SECTIONS)  # by its ending
    assert code == 0 and list(files) == ["out.step"] and "density is not in the file" in said
    assert run(PLAIN + SECTIONS, "--step")[1] == files
    text = files["out.step"].decode("ascii")
    assert (
        "'undrilled'" in text and "clockwise seen from the front" in text and "the sense of rotation is assumed" in text
    )
    assert {*run(PLAIN + SECTIONS, name="other.stp")[1]} == {"out.step", "other.stp"}


def test_each_shaft_has_a_file_and_a_twin_where_it_is_another_part(run):
    pytest.importorskip("OCP")
    code, files, said = run(pair(180.0), "--step")
    assert (
        code == 0
        and list(files) == ["out-left.step"]
        and "right is the mirror image of left, which is the same part." in said
    )
    assert "right is the mirror image of left, which is the same part, turned by 180°." in run(pair(90.0), "--step")[2]
    assert "right is the same part as left." in run(pair(60.0, 'repeats = "left"\naxis_mm = [0.0, 90.0]'), "--step")[2]


def test_a_mirror_image_of_another_pattern_is_a_part_of_its_own(run):
    pytest.importorskip("OCP")
    twisted = pair().replace(
        "[[shafts.sections]]\nfrom_mm = 50.0\nto_mm = 70.0\nouter_radius_mm = 12.0\n",
        "[[shafts.sections]]\nfrom_mm = 50.0\nto_mm = 70.0\nouter_radius_mm = 12.0\ncore_radius_mm = 8.0\n"
        "half_angle_deg = 60.0\nangle_deg = 80.0\n",
    )
    code, files, _ = run(twisted, "--step")
    assert code == 0 and list(files) == ["out-left.step", "out-right.step"]
    assert b"PRODUCT('right'" in files["out-right.step"]


def test_one_shaft_by_its_name_and_with_its_holes(run):
    pytest.importorskip("OCP")
    code, files, said = run(pair(), "--step", "--shaft", "right", "--drilled")
    assert code == 0 and list(files) == ["out.step"] and "undrilled" in said
    assert b"PRODUCT('right'" in files["out.step"] and b"'drilled to the greatest depth'" in files["out.step"]
    assert b"CONICAL_SURFACE" in files["out.step"]
    assert "Hole rear-1 is outside of its sector, which goes from 90° to 270°: it is not drilled." in said
    assert files["out.step"].count(b"CONICAL_SURFACE") == 1 and "Hole front-1" not in said


def test_one_shaft_by_its_name_asks_nothing_of_the_others(run):
    pytest.importorskip("OCP")
    bare = 'mode = "given"\nmaterial = "42CrMo4"\nspeed_ratio = -1\n' + "".join(
        f'[[shafts.bearings]]\nname = "{name}"\nposition_mm = {z}\n' for name, z in (("a", -60.0), ("b", 60.0))
    )
    text = pair(
        twin=bare + '[[shafts.masses]]\nname = "m"\nmass_kg = 0.5\nradius_mm = 15.0\nangle_deg = 0.0\nz_mm = 0.0'
    )
    assert "shafts.right: the shaft's outline is not known" in run(text, "--step")[2]
    code, files, said = run(text, "--step", "--shaft", "left")
    assert code == 0 and list(files) == ["out.step"], said
    assert "shafts.right: the shaft's outline is not known" in run(text, "--step", "--shaft", "right")[2]


@pytest.mark.parametrize(
    "text, options, told",
    [
        (pair(), ("--step", "--shaft", "rihgt"), "--shaft: rihgt: is no shaft; the shafts are left, right"),
        (PLAIN + SECTIONS, ("--step", "--drilled"), "--drilled: needs holes to drill: add [shafts.holes]"),
        (PLAIN, ("--step",), "outline is not known: give [[shafts.sections]]"),
        (PLAIN + SECTIONS, ("--csv", "--drilled"), "--drilled: is for --step, not for --csv"),
    ],
)
def test_what_is_refused(run, text, options, told):
    if "--step" in options:
        pytest.importorskip("OCP")
    code, files, said = run(text, *options, name="out.csv" if "--csv" in options else "out.step")
    assert code == 2 and not files and told in said


def test_points_on_a_plain_outline_are_named(run):
    pytest.importorskip("OCP")
    plain = PLAIN + "\n[[countershaft.sections]]\nfrom_mm = -70.0\nto_mm = 70.0\nouter_radius_mm = 12.0\n"
    code, _, said = run(plain, "--step")
    assert code == 0 and "no part of the solid: front (0.5 kg), rear (0.5 kg)." in said
