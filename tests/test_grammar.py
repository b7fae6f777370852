# SPDX-License-Identifier: Apache-2.0
"""One grammar of all commands: options are never abbreviated, N is a number of values, the ending of an output decides
its format, `-` is standard input or output, many files have the worst exit code, a terminal has colours."""

import json
import os
import shutil
import subprocess
import sys
from contextlib import redirect_stderr, redirect_stdout
from io import BytesIO, StringIO, TextIOWrapper
from pathlib import Path

import pytest

from assistant.cli import main
from assistant.colour import paint_for
from assistant.commands.design import own_keys
from assistant.usage import COMMANDS, parser
from calc.sheet.errors import BadInput
from tests.command import run
from tests.conftest import DESIGNS, ROOT

PAIR = DESIGNS / "timing_pair.toml"  # soon solved, and nothing of it fails
LIMIT = "gears.power_kW=60"  # by which it fails


def piped(monkeypatch: pytest.MonkeyPatch, *arguments: object, given: bytes = b"") -> tuple[int, bytes, str]:
    """With bytes at both ends of the program: exit code, stdout, stderr."""
    monkeypatch.setattr(sys, "stdin", TextIOWrapper(BytesIO(given), "utf-8"))
    with redirect_stdout(TextIOWrapper(BytesIO(), "utf-8")) as out, redirect_stderr(StringIO()) as err:
        code = main(list(map(str, arguments)))
    return code, out.buffer.getvalue(), err.getvalue()


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Three designs: one that holds, one that fails, one that is none."""
    (tmp_path / "designs").mkdir()
    for name in "abc":
        shutil.copy(PAIR, tmp_path / "designs" / f"{name}.toml")
    assert run("set", tmp_path / "designs" / "b.toml", LIMIT, "-q").returncode == 0
    (tmp_path / "designs" / "b.toml.bak").unlink()
    (tmp_path / "designs" / "c.toml").write_text("schema = 2\n[gearz]\n", encoding="utf-8")
    return tmp_path


# --- words


@pytest.mark.parametrize("name", COMMANDS)
def test_no_command_takes_an_abbreviated_option(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    it = parser(name)._subparsers._group_actions[0].choices[name]  # type: ignore[union-attr, index]
    for option in [option for option in it._option_string_actions if option.startswith("--") and len(option) > 4]:
        short = option[:-1]
        if short not in it._option_string_actions:
            with pytest.raises(SystemExit):
                it.parse_args([short])
            assert f"unrecognized arguments: {short}; did you mean {option}" in capsys.readouterr().err


def test_help_is_that_of_the_command() -> None:
    assert run("help", "check").stdout == run("check", "--help").stdout != ""
    assert run("help").stdout == run("--help").stdout and "help" in run("help").stdout
    assert "chek: is no command; did you mean check?" in run("help", "chek").stderr


def test_n_is_a_number_of_values_and_a_step_is_another_word() -> None:
    asked = parser("design").parse_args(
        ["design", "d.toml", "--vary", "a=80:90:5", "b=1,2", "--spaced", "c=80:90:2.5", "--vary", "d=fixed"]
    )
    spaced = {"from": 80.0, "to": 90.0, "step": 2.5}
    assert own_keys(asked)["vary"] == {"a": [80, 82.5, 85, 87.5, 90], "b": [1, 2], "c": spaced, "d": "fixed"}
    for wrong, said in (
        (["--vary", "a=80:90:0.5"], "--spaced KEY=LO:HI:STEP"),
        (["--vary", "a=90:80:3"], "from a lower number"),
        (["--vary", "a=1:2:100000"], "at most"),
        (["--vary", "a=1", "--spaced", "a=1:2:1"], "stands twice"),
        (["--spaced", "a=1:2"], "KEY=LO:HI:STEP"),
    ):
        with pytest.raises(BadInput, match=said):
            own_keys(parser("design").parse_args(["design", "d.toml", *wrong]))


# --- files


@pytest.mark.parametrize(
    "arguments, known",
    [
        (["report", PAIR, "-o", "x.txt"], ".pdf, .docx"),
        (["report", PAIR, "-o", "x"], ".pdf, .docx"),
        (["sweep", PAIR, "--vary", "gears.face_width_mm=10,12", "-o", "a.xlsx"], ".csv, .parquet"),
        (["compare", PAIR, PAIR, "-o", "x.html"], ".pdf"),
        (["schema", "-o", "x.yaml"], ".json"),
        (["replay", ROOT / "tests" / "replays" / "timing_pair.toml", "--junit", "x.json"], ".xml"),
        (["record", PAIR, "-o", "x.json"], ".toml"),
    ],
    ids=lambda words: words[0] if isinstance(words, list) else "",
)
def test_the_ending_decides_or_is_refused(tmp_path: Path, arguments: list[object], known: str) -> None:
    done = run(*arguments, cwd=tmp_path)
    assert done.returncode == 2 and f"known are {known}" in done.stderr and not list(tmp_path.iterdir())


def test_a_dash_is_standard_input_and_output(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    raw, report = PAIR.read_bytes(), tmp_path / "r.pdf"
    assert piped(monkeypatch, "check", "-", "-q", given=raw) == (0, b"PASS\n", "")
    code, edited, said = piped(monkeypatch, "set", "-", "name=other", given=raw)
    assert code == 0 and said.startswith("PASS\n")
    assert edited == raw.replace(b'"Timing pair of the gear friction thesis"', b'"other"') != raw
    assert run("report", PAIR, "--depth", "summary", "-o", report).returncode == 0
    code, paper, said = piped(monkeypatch, "report", "-", "--depth", "summary", "-o", "-", given=raw)
    assert code == 0 and paper == report.read_bytes() and said.startswith("PASS\n")
    assert piped(monkeypatch, "verify", "-", "-q", given=paper)[1].startswith(b"identical")
    values = piped(monkeypatch, "export", "-", "--json", "-o", "-", given=raw)[1]
    assert json.loads(values)["verdict"] == "pass"
    for words, said in (
        (["report", "-"], "has no name; give -o"),
        (["export", "-", "-o", "-"], "give one of --dxf, "),
        (["check", "-", "-"], "name it once"),
        (["check", "-"], "nothing came in"),
    ):
        code, out, error = piped(monkeypatch, *words, given=b"" if said == "nothing came in" else raw)
        assert code == 2 and said in error and not out


def test_many_files_are_checked_each_by_itself(folder: Path) -> None:
    one = run("check", "designs/a.toml", cwd=folder).stdout
    done = run("check", "designs", cwd=folder)
    first, rest = done.stdout.split("\n\ndesigns/b.toml\n")
    assert done.returncode == 2 and f"{first}\n" == f"designs/a.toml\n{one}" and rest.startswith("FAIL: ")
    assert "designs/c.toml:2: gearz: is not known" in done.stderr
    good = ["designs/a.toml", "designs/b.toml"]
    assert run("check", *good, "-q", cwd=folder).stdout.splitlines()[0] == "designs/a.toml: PASS"
    assert run("check", *good, "-q", cwd=folder).returncode == 1
    assert run("check", "--set", "name=x", *good, "-q", cwd=folder).returncode == 1  # files behind the changes
    found = json.loads(run("check", "designs", "--json", cwd=folder).stdout)
    assert [x["file"] for x in found] == [*good, "designs/c.toml"] and found[1]["verdict"] == "fail"
    assert ("gearz", 2) in [(error["key"], error["line"]) for error in found[2]["errors"]]
    assert json.loads(run("check", good[0], "--json", cwd=folder).stdout) == {
        k: v for k, v in found[0].items() if k != "file"
    }


def test_many_reports_go_into_a_folder(folder: Path) -> None:
    good = ["designs/a.toml", "designs/b.toml"]
    brief = ["--depth", "summary", "-q", "-o", "out"]
    done = run("report", *good, *brief, cwd=folder)
    assert done.returncode == 0 and done.stdout == "out/a.pdf\nout/b.pdf\n"
    assert run("report", *good, *brief, "--fail", cwd=folder).returncode == 1
    assert run("report", good[0], *brief, "--fail", cwd=folder).returncode == 0
    assert sorted(path.name for path in (folder / "out").iterdir()) == ["a.pdf", "b.pdf"], "and no .bak"
    (folder / "a.toml").write_bytes(PAIR.read_bytes())
    assert "would be written for two designs" in run("report", good[0], "a.toml", *brief, cwd=folder).stderr
    (folder / "-o.toml").write_bytes((folder / good[0]).read_bytes())
    assert "-o.pdf: would be taken for an option" in run("report", "./-o.toml", cwd=folder).stderr
    assert "is one file, for 2 designs" in run("report", *good, "-o", "x.pdf", cwd=folder).stderr


def test_only_a_design_keeps_the_file_that_it_was(tmp_path: Path) -> None:
    design = shutil.copy(PAIR, tmp_path / "d.toml")
    for _ in range(2):
        for words in (["export", "d.toml", "-o", "v.csv"], ["schema", "-o", "s.json"], ["set", "d.toml", "name=x"]):
            assert run(*words, cwd=tmp_path).returncode == 0
    assert {path.name for path in tmp_path.glob("*.bak")} == {f"{design.name}.bak"}


@pytest.mark.parametrize(
    "words", [["check", PAIR], ["compare", PAIR, DESIGNS / "thesis_oils.toml"]], ids=lambda w: w[0]
)
def test_quiet_says_a_part_of_it_and_all_says_more(words: list[object]) -> None:
    quiet, normal, whole = (run(*words, *more).stdout.splitlines() for more in (["-q"], [], ["-v"]))
    assert 0 < len(quiet) < len(normal) < len(whole) and set(quiet) <= set(normal)
    assert whole == run(*words, "--all").stdout.splitlines() == run(*words, "--verbose").stdout.splitlines()


# --- colour


@pytest.mark.skipif(os.name != "posix", reason="terminals of POSIX")
def test_a_terminal_has_colours() -> None:
    spawn = "import pty, sys; pty.spawn([sys.executable, '-m', 'assistant', *sys.argv[1:]])"
    command = [sys.executable, "-c", spawn, "check", str(PAIR), "-q"]
    env = {key: value for key, value in os.environ.items() if key != "NO_COLOR"}
    env |= {"PYTHONPATH": str(ROOT), "TERM": "xterm-256color"}
    done = subprocess.run(command, capture_output=True, stdin=subprocess.DEVNULL, cwd=ROOT, env=env)
    assert done.stdout == b"\x1b[1;32mPASS\x1b[0m\r\n"


class Terminal(StringIO):
    def isatty(self) -> bool:
        return True


def test_verdicts_have_the_colour_of_their_state_and_names_none(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("NO_COLOR", raising=False)
    monkeypatch.setenv("TERM", "xterm")
    paint = paint_for(Terminal())
    assert paint is not None and paint_for(StringIO()) is None
    assert paint("a.toml: FAIL: 2 failed") == "a.toml: \x1b[1;31mFAIL\x1b[0m: 2 failed"
    assert paint("Gears  ▲ warn  x") == "Gears  \x1b[1;33m▲ warn\x1b[0m  x"
    for text in ("the FAIL of a name", '"verdict": "pass"', "PASSING", "• note"):
        assert paint(text) == text


@pytest.mark.parametrize("name, value", [("NO_COLOR", "1"), ("TERM", "dumb")])
def test_colours_can_be_refused(monkeypatch: pytest.MonkeyPatch, name: str, value: str) -> None:
    monkeypatch.setenv(name, value)
    with redirect_stdout(Terminal()) as out, redirect_stderr(StringIO()):
        assert main(["check", str(PAIR), "-q"]) == 0
    assert out.getvalue() == "PASS\n"
