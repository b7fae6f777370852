"""`contralbero export --rexs`: the file, what is said beside it, and designs that have none."""

from xml.etree import ElementTree

import pytest

from assistant.cli import main
from tests.conftest import DESIGNS

PAIR, BEARINGS = DESIGNS / "timing_pair.toml", DESIGNS / "makers" / "er6n.toml"


def test_the_ending_is_enough(capsys, tmp_path):
    file, again = tmp_path / "train.rexs", tmp_path / "again.rexs"
    assert main(["export", str(PAIR), "-o", str(file)]) == 0
    out = capsys.readouterr().out
    assert "supports of the crank are not part of this model" in " ".join(out.split()) and out.endswith(f"{file}\n")
    assert ElementTree.parse(file).getroot().get("applicationId") == "contralbero"
    assert main(["export", str(PAIR), "--rexs", "-o", str(again), "--quiet"]) == 0
    assert again.read_bytes() == file.read_bytes() and str(tmp_path).encode() not in file.read_bytes()


def test_a_design_of_bearings_alone_has_none(capsys, tmp_path):
    assert main(["export", str(BEARINGS), "--rexs", "-o", str(tmp_path / "x.rexs")]) == 2
    assert "gears: needed for a file of REXS: add [gears], or [[shafts]]" in capsys.readouterr().err


@pytest.mark.parametrize("ending", ["xml", "json"])
def test_its_ending(ending, capsys, tmp_path):
    assert main(["export", str(PAIR), "--rexs", "-o", str(tmp_path / f"x.{ending}")]) == 2
    assert ".rexs" in capsys.readouterr().err
