# SPDX-License-Identifier: Apache-2.0
"""The JSON Schema of a design: every shipped design keeps that of its schema, it refuses what the program refuses of one
key, and docs has it as it is."""

import json
import os
import subprocess
import sys
import tomllib

import pytest

from tests.command import run
from tests.conftest import DESIGNS, ROOT

jsonschema = pytest.importorskip("jsonschema")


OLD, NEW = ROOT / "tests" / "data" / "designs_0_1", ROOT / "tests" / "data" / "upgraded"


@pytest.fixture(scope="module")
def judges():
    return {
        number: jsonschema.Draft7Validator(json.loads(run("schema", "--schema", number).stdout)) for number in (1, 2)
    }


@pytest.fixture
def judge(judges):
    return judges[2]


def data(text):
    return json.loads(json.dumps(tomllib.loads(text), default=str))  # a date of TOML is a word to JSON


@pytest.mark.parametrize("folder", [DESIGNS, DESIGNS / "makers", OLD, NEW], ids=lambda folder: folder.name)
def test_every_shipped_design_keeps_that_of_its_schema(judges, folder):
    designs = {path.stem: data(path.read_text(encoding="utf-8")) for path in sorted(folder.glob("*.toml"))}
    wrong = {
        name: [e.message for e in judges[design["schema"]].iter_errors(design)] for name, design in designs.items()
    }
    assert len(designs) >= 8 and not any(wrong.values()), wrong


def test_one_schema_is_not_the_other(judges):
    old, new = (data((folder / "r753ie4_gamma.toml").read_text(encoding="utf-8")) for folder in (OLD, NEW))
    assert list(judges[2].iter_errors(old)) and list(judges[1].iter_errors(new))


@pytest.mark.parametrize(
    "old, new, key",
    [
        ("bore_mm = 94.0", "bore_mm = -94.0", "engine.bore_mm"),
        ("bore_mm = 94.0", 'bore_mm = "94"', "engine.bore_mm"),
        ("bore_mm = 94.0", "boer_mm = 94.0", "engine"),
        ("cylinders = 3", "cylinders = 3.5", "engine.cylinders"),
        ('supply = "hole"', 'supply = "holes"', "bearings.supply"),
        ("speed_ratio = -1", 'speed_ratio = "-1"', "shafts.0.speed_ratio"),
        ("position_mm = -167.5", 'position_mm = "front"', "shafts.0.bearings.0.position_mm"),
        ("schema = 2", "schema = 3", "schema"),
    ],
)
def test_it_refuses_what_the_program_refuses(judge, tmp_path, old, new, key):
    text = (NEW / "r753ie4_gamma.toml").read_text(encoding="utf-8")
    assert old in text
    wrong = text.replace(old, new, 1)
    (tmp_path / "x.toml").write_text(wrong, encoding="utf-8")
    assert run("check", tmp_path / "x.toml").returncode == 2
    assert any(".".join(map(str, error.path)) == key for error in judge.iter_errors(data(wrong)))


def test_docs_has_it_as_it_is():
    written = (ROOT / "docs" / "contralbero.schema.json").read_text(encoding="utf-8")
    assert written == run("schema").stdout == run("schema", "--schema", "2").stdout


def test_every_key_says_what_it_means(judge):
    bore = judge.schema["properties"]["engine"]["properties"]["bore_mm"]
    assert bore["type"] == "number" and bore["exclusiveMinimum"] == 0 and bore["description"].startswith("Bore, mm")


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_a_shell_gets_its_script(shell):
    pytest.importorskip("argcomplete")
    done = run("completion", shell)
    assert done.returncode == 0 and "contralbero" in done.stdout and "_ARGCOMPLETE" in done.stdout


@pytest.mark.parametrize(
    ("line", "wanted"),
    [
        ("contralbero ver", {"verify"}),
        ("contralbero report x.toml --dep", {"--depth"}),
        ("contralbero report x.toml --depth ", {"summary", "engineer", "audit"}),
    ],
)
def test_a_shell_is_told_what_may_come_next(line, wanted, tmp_path):
    """By the protocol of argcomplete, as its scripts speak it."""
    pytest.importorskip("argcomplete")
    told = tmp_path / "told"
    environment = {
        **os.environ,
        "_ARGCOMPLETE": "1",
        "COMP_LINE": line,
        "COMP_POINT": str(len(line)),
        "COMP_TYPE": "9",
        "_ARGCOMPLETE_STDOUT_FILENAME": str(told),
        "_ARGCOMPLETE_IFS": "\n",
    }
    subprocess.run([sys.executable, "-m", "assistant"], env=environment, cwd=ROOT, capture_output=True, timeout=60)
    assert {word.strip() for word in told.read_text(encoding="utf-8").split("\n")} >= wanted
