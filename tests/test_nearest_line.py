# SPDX-License-Identifier: Apache-2.0
"""The last line of a failing `check`: pasted into a shell it passes; where there is none, it says what still fails."""

import re
import shlex
from pathlib import Path

import pytest

from assistant.cli import main
from assistant.commands.check import changed
from calc.design.toml_file import design, read
from calc.solve import solve
from tests.conftest import DESIGNS, GAMMA

PASTE = re.compile(r"nearest (?:passing design|design in which no limit fails): (.*)")
MENDS = re.compile(r"(?:to pass|for no limit to fail): .* → ")
WARNS = "with new warnings: "


def check(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, list[str]]:
    code = main(["check", *arguments])
    return code, capsys.readouterr().out.rstrip("\n").split("\n")


def pasted(lines: list[str]) -> list[str]:
    """The command of the last line, as a shell takes it."""
    found = PASTE.fullmatch(lines[-1])
    assert found is not None, lines[-1]
    return shlex.split(found[1])


@pytest.mark.parametrize(
    "arguments",
    [
        [str(GAMMA)],
        [str(DESIGNS / "r753ie4_beta.toml"), "--short"],
        pytest.param([str(DESIGNS / "finotti_gear_sheet.toml")], marks=pytest.mark.slow),
        pytest.param([str(GAMMA), "--step", "bearings"], marks=pytest.mark.slow),
        [str(GAMMA), "--step", "gears", "--set", "bearings.oil=SAE 10W"],
        pytest.param(
            [str(GAMMA), "--set", "bearings.front.length_mm=20", "gears.wheels.idler.span_allowance_um=[-5,-15]"],
            marks=pytest.mark.slow,
        ),
        [str(DESIGNS / "r753ie4_sized.toml"), "--set", "countershaft.outer_radius_mm=38"],  # no solution: exit 3
    ],
    ids=lambda words: " ".join(words[1:]) or "plain",
)
def test_the_last_line_pasted_passes(capsys: pytest.CaptureFixture[str], arguments: list[str]) -> None:
    code, lines = check(capsys, *arguments)
    assert code in (1, 3)
    words = pasted(lines)
    (mends,) = filter(MENDS.match, lines)
    assert words[:3] == ["contralbero", "check", arguments[0]]
    assert main(words[1:]) == 0
    again = capsys.readouterr().out
    assert not PASTE.search(again) and "✗" not in again
    state = again.split("\n")[0]
    assert state.startswith(("PASS", "WARN", "NOT VERIFIED"))
    assert (f"then {state}" in lines) is not state.startswith("PASS")
    passes = not state.startswith("NOT VERIFIED")
    assert mends.startswith("to pass: ") is passes and lines[-1].startswith("nearest passing design: ") is passes
    assert ("--step" in arguments) == ("--step" in words) and ("--short" in arguments) == ("--short" in words)


@pytest.mark.slow
def test_what_the_nearest_design_then_warns_of_is_said(capsys: pytest.CaptureFixture[str]) -> None:
    """Of warnings those that are new, or that were failing."""
    file = DESIGNS / "r753ie4_beta.toml"
    _, lines = check(capsys, str(file))
    before, after = solve(design(read(file))), solve(changed(read(file), pasted(lines)[4:])[1])
    known = {c.id for c in before.checks() if c.open and c.verdict != "fail"}
    new = [c for c in after.checks() if c.verdict == "warn" and c.id not in known]
    (words,) = [line for line in lines if line.startswith(WARNS)] or [""]
    assert bool(new) is bool(words) and (not new or any(f"{c.name} ({c.margin_text()})" in words for c in new))


def test_a_name_that_a_shell_would_split_is_quoted(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    file = tmp_path / "my 'last' design; $HOME.toml"
    file.write_bytes((DESIGNS / "finotti_gear_sheet.toml").read_bytes())
    _, lines = check(capsys, str(file))
    assert main(pasted(lines)[1:]) == 0


@pytest.mark.slow
def test_a_key_that_is_set_stands_once(capsys: pytest.CaptureFixture[str]) -> None:
    _, lines = check(capsys, str(GAMMA), "--step", "bearings", "--set", "bearings.front.length_mm=20")
    assert lines[-1].count("bearings.front.length_mm=") == 1
    _, lines = check(capsys, str(GAMMA), "--step", "bearings", "--set", "shafts.shaft.bearings.*.length_mm=20")
    assert lines[-1].count("length_mm=") == 2 and "*" not in lines[-1], "all that it sets is set anew"


def test_what_is_locked_stays_and_is_said(capsys: pytest.CaptureFixture[str]) -> None:
    _, lines = check(capsys, str(GAMMA), "--step", "bearings")
    assert "kept as locked: bearings.oil (the oil is the engine's)" in lines and "bearings.oil=" not in lines[-1]
    _, lines = check(capsys, str(GAMMA), "--step", "bearings", "--set", "locked.engine=it is bought")
    assert "kept as locked: engine (it is bought)" in lines and "bearings.oil=" in lines[-1]


def test_a_design_that_passes_says_nothing_of_it(capsys: pytest.CaptureFixture[str]) -> None:
    code, lines = check(capsys, str(DESIGNS / "r753ie4_sized.toml"))
    assert code == 0 and not any(PASTE.search(line) or "no passing design" in line for line in lines)


@pytest.mark.slow
def test_the_json_stays_one_object(capsys: pytest.CaptureFixture[str]) -> None:
    import json

    code, lines = check(capsys, str(GAMMA), "--json")
    assert code == 1 and json.loads("\n".join(lines))["steps"]["bearings"] == "fail"


def test_where_there_is_none_the_last_line_says_what_still_fails(capsys: pytest.CaptureFixture[str]) -> None:
    code, lines = check(
        capsys,
        str(DESIGNS / "r753ie4_sized.toml"),
        "--step",
        "gears",
        "--set",
        "gears.wheels.central.teeth=25",
        "gears.wheels.shaft.teeth=40",
    )
    assert code == 1 or code == 3
    assert lines[-1].startswith("no passing design found: gears") and " still fails: " in lines[-1]


def test_a_search_that_takes_too_long_is_ended_and_said(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("assistant.commands.check.SEARCH_SECONDS", 0)
    code, lines = check(capsys, str(GAMMA))
    assert code == 1 and lines[-1] == "no passing design found in 0 s; --step STEP looks for one step alone"
