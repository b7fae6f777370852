"""The Python of the documents: the notebook and the script run, and the type checker has nothing to say of any of it."""

import json
import os
import re
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path
from shutil import copytree

import pytest

from calc.sheet.shown import NO_PANDAS
from tests.conftest import ROOT

PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]
BLOCK = re.compile(r"^```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)
CALL = re.compile(r"^\| `([^`]+\([^`]+)` \|", re.MULTILINE)  # of a table of calls
NOTEBOOK = ROOT / "docs" / "notebook.ipynb"


def blocks(path: Path) -> list[str]:
    """The blocks of a page that are Python; a script, which runs by itself, is one of its own."""
    return [
        block.strip() + "\n"
        for block in BLOCK.findall(path.read_text(encoding="utf-8"))
        if re.search(r"^(?:from|import) .*\bimport\b|^import ", block, re.MULTILINE)
    ]


def scripts(path: Path) -> list[str]:
    """What of a page follows from one another, as one, with the calls of its tables; then its scripts."""
    alone = [block for block in blocks(path) if "__main__" in block]
    together = [block for block in blocks(path) if block not in alone]
    calls = CALL.findall(path.read_text(encoding="utf-8")) if together else []
    return ["\n".join([*together, *calls]), *alone]


_, SCRIPT = scripts(ROOT / "docs" / "python.md")


def cells() -> list[str]:
    notebook = json.loads(NOTEBOOK.read_text(encoding="utf-8"))
    assert notebook["nbformat"] == 4
    return ["".join(cell["source"]) for cell in notebook["cells"] if cell["cell_type"] == "code"]


def environment() -> dict[str, str]:
    """Of a stranger, who has the program installed."""
    return os.environ | {
        "PYTHONPATH": os.pathsep.join([str(ROOT), *sys.path]),
        "MPLBACKEND": "Agg",
        "MYPYPATH": str(ROOT),
    }


def test_the_script_is_short():
    assert sum(bool(line.strip()) for line in SCRIPT.splitlines()) <= 25


@pytest.mark.slow
def test_the_script_runs(tmp_path):
    """Without pandas to its first frame, where it says what is to be installed."""
    (tmp_path / "script.py").write_text(SCRIPT, encoding="utf-8")
    copytree(ROOT / "designs", tmp_path / "designs")
    done = subprocess.run(
        [sys.executable, "script.py"], cwd=tmp_path, env=environment(), capture_output=True, text=True
    )
    assert {path.name for path in tmp_path.glob("*.png")} == {"film_1000.png", "film_1707.png", "film_2500.png"}
    assert re.search(r"1707 N: 1\d\.\d µm at \d+ µm", done.stdout)
    if find_spec("pandas") is None:
        assert done.stderr.strip().endswith(NO_PANDAS)
    else:
        assert done.returncode == 0, done.stderr
        assert done.stdout.count("bearings.front.film") >= 4


def test_the_notebook_runs(tmp_path, monkeypatch):
    """Its cells in their order; what the last line of one gives can be shown."""
    import matplotlib

    matplotlib.use("Agg")
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    for cell in cells():
        exec(compile(cell, "cell", "exec"), names)
    assert (tmp_path / "example.pdf").read_bytes().startswith(b"%PDF")
    assert 60e-6 < names["best"] < 200e-6
    assert names["left"].required_couple == pytest.approx(572.9, rel=1e-3)


@pytest.mark.slow
def test_the_type_checker_takes_every_example_and_sees_a_mistake(tmp_path):
    mistakes = {
        "name": ("return solve_film(", "return solve_flim(", "solve_flim"),
        "argument": ("length=0.0275, ", "", 'No overload variant of "solve_film"'),
        "result": ("film.film.max()", "film.flim.max()", "flim"),
        "step": (".bearings\n", ".gears\n", "TrainResult"),
        "array": ("load=load, ", 'load="1707", ', 'No overload variant of "solve_film"'),
    }
    files = {f"{path.stem}_{n}": text for path in PAGES for n, text in enumerate(scripts(path)) if text}
    files["notebook"] = "\n".join(cells())
    assert {"python_0", "python_1", "notebook"} <= set(files)
    for name, (right, wrong, _) in mistakes.items():
        assert right in SCRIPT
        files[f"mistake_{name}"] = SCRIPT.replace(right, wrong)
    for name, text in files.items():
        (tmp_path / f"{name}.py").write_text(text, encoding="utf-8")
    run = subprocess.run(
        [
            *(sys.executable, "-m", "mypy", "--strict", "--config-file=", "--follow-imports=silent"),
            *("--cache-dir", str(ROOT / ".mypy_cache" / "strangers")),
            *(str(tmp_path / f"{name}.py") for name in files),
        ],
        cwd=tmp_path,
        env=environment() | {"PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
    )
    said = dict.fromkeys(files, "")
    for name, words in re.findall(r"(\w+)\.py:\d+: error: (.*)", run.stdout):
        said[name] += words
    for name, words in said.items():
        kind = name.removeprefix("mistake_")
        assert (mistakes[kind][2] in words) if name != kind else words == "", f"{name}: {words or run.stdout}"
