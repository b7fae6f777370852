"""Text that leaves: user's text is never obeyed, no encoding is too small, a full device and a closed pipe end the
program quietly."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from calc.sheet.visible import UNSEEN, visible
from tests.command import run
from tests.conftest import DESIGNS, GAMMA, ROOT

BAD = "\x00\x07\x1b\x7f\x85\x9b\u200b\u200e\u200f\u2028\u2029\u202a\u202e\u2066\u2069\ufeff\udc80\U000e0041"
PAIR = DESIGNS / "timing_pair.toml"
PROGRAM = [sys.executable, "-m", "assistant"]
ENVIRONMENT = {**os.environ, "PYTHONPATH": str(ROOT)}


def shell(line: str, **environment: str) -> subprocess.CompletedProcess[bytes]:
    command = f"contralbero() {{ '{sys.executable}' -m assistant \"$@\"; }}; {line}"
    return subprocess.run(["bash", "-c", command], capture_output=True, cwd=ROOT, env=ENVIRONMENT | environment)


@pytest.mark.parametrize("letter", BAD)
def test_what_can_not_be_seen_is_written_as_json_writes_it(letter: str) -> None:
    assert visible(f"a{letter}b") == f"a{json.dumps(letter)[1:-1] if letter not in 'x' else letter}b".replace(
        "\\b", "\\u0008"
    )
    assert visible(f"a{letter}b", lines=True) == visible(f"a{letter}b")


def test_what_can_be_seen_stays() -> None:
    text = "Überlänge −5·10⁻³ µm [red] 设计 مرحبا 🙂 \\u202e"
    assert (
        visible(text) is text
        and visible("two\n\tlines", lines=True) == "two\n\tlines"
        and visible("two\nlines") == "two\\u000alines"
    )
    assert len(UNSEEN) > 20


@pytest.fixture
def bad_design(tmp_path: Path) -> Path:
    """The source's design with names and a note that a terminal would obey."""
    bad = json.dumps("".join(letter for letter in BAD if not "\ud800" <= letter <= "\udfff") + "[red]name[/red]")
    bad = bad.replace("\\udb40\\udc41", "\\U000e0041")
    text = (
        GAMMA.read_text(encoding="utf-8")
        .partition("\n[bearings]")[0]
        .replace('name = "R753IE4 counter-shaft, solution gamma"', f"name = {bad}\n", 1)
    )
    assert bad in text
    text = text.replace('name = "VM Motori R753IE4"', f"name = {bad}").replace(
        "\n[engine]", '\n[accepted]\n"a\\u001bb" = "\\u009b2J"\n\n[engine]', 1
    )
    path = tmp_path / "bad\x1b[31m\u202e.toml"
    path.write_text(text, encoding="utf-8")
    return path


def unseen(text: str) -> list[str]:
    return [letter for letter in text if letter not in "\n" and visible(letter) != letter]


@pytest.mark.parametrize(
    "words",
    [["check"], ["check", "--all"], ["check", "--json"], ["explain", "countershaft.couple"], ["compare"], ["set"]],
    ids=" ".join,
)
def test_nothing_of_a_design_is_obeyed(bad_design: Path, words: list[str]) -> None:
    command, *rest = words
    others = {"compare": [str(PAIR)], "set": ["engine.bore_mm=\x1b[31m"]}.get(command, [])
    done = run(command, bad_design, *rest, *others)
    assert done.returncode in (0, 1, 2) and not unseen(done.stdout + done.stderr)
    if "--json" in words:
        assert "\x1b" in json.loads(done.stdout)["design"]["name"]


def test_a_name_is_no_line_of_its_own(bad_design: Path) -> None:
    """A line end in a name is written out: it can not pass for a verdict of the program."""
    text = bad_design.read_text(encoding="utf-8").replace("[red]name[/red]", r"\n\u2713 pass  forged")
    bad_design.write_text(text, encoding="utf-8")
    for words in (["check"], ["check", "--all"], ["compare", str(PAIR)]):
        done = run(words[0], bad_design, *words[1:])
        assert not [line for line in done.stdout.splitlines() if line.startswith("✓ pass  forged")], words


def test_errors_show_keys_values_and_file_names_in_one_line(bad_design: Path, tmp_path: Path) -> None:
    bad_design.write_text(
        'schema = 1\nname = "x"\n"k\\u001b\\ney" = 1\n[engine]\nlayout = "a\\u202e\\nFAKE: line"\n', encoding="utf-8"
    )
    done = run("check", bad_design)
    assert done.returncode == 2 and not unseen(done.stderr)
    assert r"k\u001b\u000aey" in done.stderr and r"a\u202e\u000aFAKE: line" in done.stderr
    assert all(line.startswith(visible(str(bad_design))) for line in done.stderr.splitlines())
    assert not unseen(run("check", tmp_path / "no\x1b\udcff.toml").stderr)


@pytest.mark.skipif(os.name != "posix", reason="names of bytes, and devices")
def test_a_file_name_that_is_no_text(tmp_path: Path) -> None:
    done = subprocess.run(
        [*PROGRAM, "check", os.fsencode(tmp_path) + b"/no\xff\x1b.toml"], capture_output=True, cwd=ROOT, env=ENVIRONMENT
    )
    assert done.returncode == 2 and rb"no\udcff\u001b.toml" in done.stderr and b"Traceback" not in done.stderr


@pytest.mark.parametrize(
    "encoding", ["cp1252", "ascii:strict", *(pytest.param(name, marks=pytest.mark.slow) for name in ("ascii", "utf-8"))]
)
def test_any_encoding_will_do(encoding: str) -> None:
    done = subprocess.run(
        [*PROGRAM, "check", str(PAIR)], capture_output=True, cwd=ROOT, env=ENVIRONMENT | {"PYTHONIOENCODING": encoding}
    )
    assert done.returncode == 0 and not done.stderr
    text = done.stdout.decode(encoding.partition(":")[0])
    assert ("(−3700 %)" if encoding == "utf-8" else "(-3700 %)") in text, "a number keeps its sign"


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no full device")
def test_a_full_device_and_a_closed_pipe() -> None:
    done = shell("contralbero check designs/timing_pair.toml --all > /dev/full; echo $?")
    assert (
        done.stdout == b"2\n"
        and done.stderr.decode().startswith("contralbero: the output cannot be written: ")
        and done.stderr.count(b"\n") == 1
    )
    assert shell("contralbero check designs/nothing.toml 2> /dev/full; echo $?").stdout == b"2\n"
    assert shell("contralbero check designs/timing_pair.toml >&-; echo $?").stdout == b"0\n"
    done = shell("contralbero check designs/timing_pair.toml --json | head -1 > /dev/null; echo ${PIPESTATUS[0]}")
    assert done.stdout == b"141\n" and not done.stderr  # it is longer than what a pipe holds


@pytest.mark.parametrize("closed", ["<&-", *(pytest.param(x, marks=pytest.mark.slow) for x in (">&-", "<&- >&-"))])
def test_a_session_needs_a_terminal(closed: str) -> None:
    done = shell(f"(contralbero designs/timing_pair.toml {closed}); echo $?")
    assert done.stdout == b"2\n" and b"the guided session needs a terminal" in done.stderr


@pytest.mark.slow
def test_a_pipe_that_closes_ends_a_sweep() -> None:
    sweep = "contralbero sweep designs/r753ie4_gamma.toml --vary engine.rated_speed_rpm=1000:3000:2000 --step imbalance"
    done = shell(f"{sweep} | head -1 > /dev/null; echo ${{PIPESTATUS[0]}}")
    assert done.stdout == b"141\n" and all(line.endswith(b"left") for line in done.stderr.splitlines())
