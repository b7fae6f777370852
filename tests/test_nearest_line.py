# SPDX-License-Identifier: Apache-2.0
"""The last line of a failing `check`: pasted into a shell it passes; where there is none, it says what still fails."""

import shlex
from pathlib import Path

import pytest

from assistant.cli import main
from tests.conftest import DESIGNS, GAMMA

PASTE = "nearest passing design: "
WARNS = "with new warnings: "


def check(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, list[str]]:
    code = main(["check", *arguments])
    return code, capsys.readouterr().out.rstrip("\n").split("\n")


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
    found = lines[-3] if lines[-2].startswith(WARNS) else lines[-2]
    assert found.startswith("to pass: ") and "→" in found
    assert lines[-1].startswith(PASTE)
    words = shlex.split(lines[-1].removeprefix(PASTE))
    assert words[:3] == ["contralbero", "check", arguments[0]]
    assert main(words[1:]) == 0
    again = capsys.readouterr().out
    assert PASTE not in again and "✗" not in again
    assert ("--step" in arguments) == ("--step" in words) and ("--short" in arguments) == ("--short" in words)


def test_what_the_nearest_design_then_warns_of_is_said(capsys: pytest.CaptureFixture[str]) -> None:
    _, lines = check(capsys, str(DESIGNS / "r753ie4_beta.toml"))
    assert lines[-2] == f"{WARNS}Length ratio l/d, rear (+3 %)"
    assert not any(line.startswith("▲") and "Length ratio l/d, rear" in line for line in lines)
    main(shlex.split(lines[-1].removeprefix(PASTE))[1:])
    assert "▲ warn  Length ratio l/d, rear" in capsys.readouterr().out


def test_a_name_that_a_shell_would_split_is_quoted(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    file = tmp_path / "my 'last' design; $HOME.toml"
    file.write_bytes((DESIGNS / "finotti_gear_sheet.toml").read_bytes())
    _, lines = check(capsys, str(file))
    assert main(shlex.split(lines[-1].removeprefix(PASTE))[1:]) == 0


def test_a_key_that_is_set_stands_once(capsys: pytest.CaptureFixture[str]) -> None:
    _, lines = check(capsys, str(GAMMA), "--step", "bearings", "--set", "bearings.front.length_mm=20")
    assert lines[-1].count("bearings.front.length_mm=") == 1


def test_what_is_locked_stays_and_is_said(capsys: pytest.CaptureFixture[str]) -> None:
    _, lines = check(capsys, str(GAMMA), "--step", "bearings")
    assert "kept as locked: bearings.oil (the oil is the engine's)" in lines and "bearings.oil=" not in lines[-1]
    _, lines = check(capsys, str(GAMMA), "--step", "bearings", "--set", "locked.engine=it is bought")
    assert "kept as locked: engine (it is bought)" in lines and "bearings.oil=" in lines[-1]


def test_a_design_that_passes_says_nothing_of_it(capsys: pytest.CaptureFixture[str]) -> None:
    code, lines = check(capsys, str(DESIGNS / "r753ie4_sized.toml"))
    assert code == 0 and not any(PASTE in line or "no passing design" in line for line in lines)


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
