# SPDX-License-Identifier: Apache-2.0
"""`contralbero export --step` with wheels, teeth and modules."""

import re
from types import SimpleNamespace

import pytest

from assistant.cli import main
from calc.design.toml_file import load_design
from calc.solve import solve
from tests.conftest import ROOT

DRIVE, PAIR, GAMMA = (
    ROOT / "designs" / f"{name}.toml" for name in ("r753ie4_drive", "r754ie4_balance_shafts", "r753ie4_gamma")
)


@pytest.fixture
def run(tmp_path, capsys):
    """Exports a design, and gives the exit code, the file and what was said."""

    def export(design, *options):
        target = tmp_path / "out.step"
        code = main(["export", str(design), "--step", *options, "-o", str(target)])
        said = capsys.readouterr()
        text = target.read_bytes().decode("ascii") if target.exists() else ""
        return code, text, said.out + said.err

    return export


def products(text):
    return set(re.findall(r"=\s*PRODUCT\('([^']*)'", text))


@pytest.fixture(autouse=True)
def kernel():
    pytest.importorskip("OCP")


def test_what_can_not_be_had_is_said_at_once(run):
    code, text, said = run(GAMMA, "--wheel", "idle", "--teeth", "--allowance", "max")
    assert code == 2 and not text
    assert "--wheel: idle: is no wheel; the wheels are crank, central, idler, shaft" in said.replace(" = ", ": ")
    assert "--teeth" in said


def test_a_module_asks_for_the_axes(run):
    code, text, said = run(GAMMA, "--module")
    assert code == 2 and not text and "shafts.shaft: where shaft stands is not known: give axis_mm = [up, side]" in said


def test_blanks_have_no_allowance_and_shafts_no_blank(run):
    assert "is for teeth" in run(GAMMA, "--wheel", "idler", "--blank", "--allowance", "max")[2]
    assert "is for wheels" in run(GAMMA, "--blank")[2]
    assert "--drilled: is for shafts" in run(GAMMA, "--wheel", "idler", "--drilled")[2].replace(" = ", ": ")


def test_one_part_is_asked_for(run):
    code, text, said = run(GAMMA, "--module", "--wheel", "idler")
    assert code == 2 and not text and "not allowed with" in said


def test_a_module_has_a_named_part_for_each_shaft_and_each_wheel_of_another_axis(run):
    """The shaft's wheel is the blank of its outline."""
    code, text, said = run(DRIVE, "--module", "--blank")
    assert code == 0 and "wheel of shaft" not in said, said
    assert {"shaft", "crank", "central", "idler"} <= products(text)
    assert text.count("NEXT_ASSEMBLY_USAGE_OCCURRENCE") == 4


def test_a_module_prints_one_table_and_says_that_the_shafts_own_wheel_is_a_blank(run):
    code, text, said = run(DRIVE, "--module")
    assert code == 0, said
    assert said.count("cm³") == 1 and said.count("Deviation") == 1
    for name in ("shaft", "crank", "central", "idler"):
        part, program = (re.search(f"^{words} +(.*)", said, re.M) for words in (name, f"{name}, by the program"))
        assert part and program and part[1].split() == program[1].split()
    assert "wheel of shaft: blank, which cuts into the teeth of its mate; --teeth cuts its teeth." in said
    assert "wheel of shaft: blank" in text


def test_a_wheel_that_its_shaft_does_not_reach_is_a_part_of_its_own(run):
    code, text, said = run(PAIR, "--module", "--blank")
    assert code == 0, said
    assert {"left", "right", "left-wheel", "right-wheel", "crank", "left-idler"} <= products(text)


@pytest.mark.slow
def test_teeth_on_the_shaft_and_what_they_change(run):
    code, text, said = run(DRIVE, "--teeth")
    assert code == 0, said
    assert products(text) == {"shaft"} and "Teeth in place of the blank change the mass by −4.05" in said


@pytest.mark.slow
@pytest.mark.parametrize("path", sorted((ROOT / "designs").glob("*.toml")), ids=lambda path: path.stem)
def test_every_wheel_of_every_shipped_design_is_a_solid(path):
    from assistant.exports.solids import Solids

    results = solve(load_design(path))
    made = Solids(SimpleNamespace(options={}, results=results))
    for name in results.train.wheels if results.train is not None else ():
        assert made.wheel(name).deviation < 2e-7
