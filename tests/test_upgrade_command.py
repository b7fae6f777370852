# SPDX-License-Identifier: Apache-2.0
"""`contralbero upgrade`: designs of schema 1 in schema 2, as files."""

import shutil
from pathlib import Path

import pytest

from tests.command import run
from tests.conftest import ROOT

OLD, NEW = (ROOT / "tests" / "data" / name for name in ("designs_0_1", "upgraded"))
GAMMA, R754, TWIN = "r753ie4_gamma.toml", "r754ie4_balance_shafts.toml", "twin_force_shaft.toml"


@pytest.fixture
def files(tmp_path: Path) -> list[Path]:
    return [Path(shutil.copy(OLD / name, tmp_path)) for name in (R754, TWIN)]


def test_files_are_written_and_the_old_ones_kept(files: list[Path]) -> None:
    done = run("upgrade", *files)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.splitlines() == [f"{p} is written in schema 2; as it was before: {p}.bak" for p in files]
    for path in files:
        assert path.read_bytes() == (NEW / path.name).read_bytes()
        assert path.with_name(f"{path.name}.bak").read_bytes() == (OLD / path.name).read_bytes()


def test_one_of_schema_2_is_left_alone_and_its_backup_too(files: list[Path]) -> None:
    run("upgrade", *files)
    done = run("upgrade", files[0])
    assert (done.returncode, done.stdout) == (0, f"{files[0]} is of schema 2 already\n")
    assert files[0].with_name(f"{files[0].name}.bak").read_bytes() == (OLD / files[0].name).read_bytes()


def test_dry_prints_the_difference_and_writes_nothing(files: list[Path]) -> None:
    done = run("upgrade", "--dry", files[1])
    assert (done.returncode, done.stderr) == (0, "")
    changed = [line for line in done.stdout.splitlines() if line[:1] in "+-"]
    assert changed[:4] == [f"--- {files[1]}", f"+++ {files[1]}", "-schema = 1", "+schema = 2"]
    assert "+[[shafts.bearings]]" in changed and "-bearing_positions_mm = [-60.0, 60.0]" in changed
    assert sorted(path.name for path in files[1].parent.iterdir()) == sorted((R754, TWIN))
    assert files[1].read_bytes() == (OLD / TWIN).read_bytes()


def test_a_notation_that_can_not_be_edited_is_written_afresh_and_says_so(files: list[Path]) -> None:
    text = files[1].read_text(encoding="utf-8")
    inline = "locked = { 'countershaft.speed_ratio' = 'first order' } # bound\n"
    files[1].write_text(text.replace("schema = 1\n", f"schema = 1\n{inline}"), encoding="utf-8")
    done = run("upgrade", files[1])
    assert (done.returncode, done.stderr) == (0, "")
    written, afresh, *lost = done.stdout.splitlines()
    assert written.endswith(".bak") and afresh.endswith(f"it is written afresh; {len(lost)} comments are not in it")
    assert (
        "  # An inline two with its pins together and one balance shaft, which carries a force and so stands close beside the crank."
        in lost
    )
    made = files[1].read_text(encoding="utf-8")
    assert '[locked]   # bound\n"shafts.shaft.speed_ratio" = "first order"   # bound\n' in made
    assert "axis_mm = [   # beside the crank and a little below it\n" in made


def test_where_one_is_wrong_none_is_written(files: list[Path]) -> None:
    text = files[1].read_text(encoding="utf-8")
    files[1].write_text(text.replace("bearing_positions_mm = [-60.0, 60.0]", "bearing_positions_mm = [60.0, -60.0]"))
    done = run("upgrade", *files)
    assert done.returncode == 2 and done.stdout == ""
    assert f"{files[1]}:49: countershaft.bearing_positions_mm: must rise from front to rear" in done.stderr
    assert files[0].read_bytes() == (OLD / R754).read_bytes()
    assert len(list(files[0].parent.iterdir())) == 2


@pytest.mark.parametrize(
    "text, words",
    [
        ("schema = 3\n", "x.toml:1: schema: 3: needs a newer program"),
        ("schema = 1\n[engine\n", "x.toml:2: is not TOML"),
        ("schema = 1\n[[step]]\n", "step: is not known"),
        (None, "cannot be read"),
    ],
)
def test_what_is_no_design_is_bad_input(text: str | None, words: str, tmp_path: Path) -> None:
    if text is not None:
        (tmp_path / "x.toml").write_text(text, encoding="utf-8")
    done = run("upgrade", tmp_path / "x.toml")
    assert done.returncode == 2 and words in done.stderr


@pytest.mark.parametrize("folder", [OLD, pytest.param(NEW, marks=pytest.mark.slow)], ids=lambda folder: folder.name)
def test_a_key_of_schema_1_is_answered_by_that_of_today(folder: Path) -> None:
    said = run("explain", folder / "r753ie4_gamma.toml", "bearings.front.length_mm").stdout
    assert said.startswith("shafts.shaft.bearings.front.length_mm = 27.5 ")
    both = run("explain", folder / "r753ie4_gamma.toml", "bearings.*.length_mm").stdout.splitlines()
    assert [line.split("   ")[0] for line in both[:2]] == [
        "shafts.shaft.bearings.front.length_mm = 27.5",
        "shafts.shaft.bearings.rear.length_mm = 26.5",
    ]
    table = run(
        *("sweep", folder / "r753ie4_gamma.toml", "--step", "countershaft", "--values", "countershaft.reaction_front"),
        *("--vary", "countershaft.bearing_positions_mm.0=-167.5,-160", "--vary", "bearings.slope_mrad=0.1,0.2"),
    ).stdout
    assert table.splitlines()[0].startswith("shafts.shaft.bearings.front.position_mm,bearings.slope_mrad,")
    assert len(table.splitlines()) >= 5
