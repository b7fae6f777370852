"""The packages have short names: what stands in their way is told in words, and nothing of it is run."""

import os
import subprocess
import sys

import pytest

from contralbero import PACKAGES, in_the_way
from tests.conftest import GAMMA, ROOT

BEGIN = "import contralbero, sys; sys.argv[1:] = ['--version']; sys.exit(contralbero.main())"


def begun(folder, *how):
    """The program, with a folder before everything that is installed."""
    path = os.pathsep.join(map(str, (folder, ROOT)))
    return subprocess.run(
        [sys.executable, *how], cwd=folder, env=os.environ | {"PYTHONPATH": path}, capture_output=True, text=True
    )


def test_its_own_packages_are_in_nobody_s_way():
    assert in_the_way() == []


@pytest.mark.parametrize("name", PACKAGES)
@pytest.mark.parametrize("as_package", [True, False])
def test_a_package_of_somebody_else_is_named_with_its_place(tmp_path, name, as_package):
    other = tmp_path / name / "__init__.py" if as_package else tmp_path / f"{name}.py"
    other.parent.mkdir(exist_ok=True)
    other.write_text("raise SystemExit('of somebody else')")
    done = begun(tmp_path, "-c", BEGIN)
    assert done.returncode == 2
    assert f"another package called {name} stands in the way: {other}" in done.stderr
    assert "environment of its own" in done.stderr
    assert "Traceback" not in done.stderr and done.stderr.count("\n") == 1


def test_all_that_stand_in_the_way_are_named(tmp_path):
    for name in ("calc", "reports"):
        (tmp_path / f"{name}.py").touch()
    assert begun(tmp_path, "-c", BEGIN).stderr.count("stands in the way") == 2


def test_a_module_beside_one_s_design_is_told_to_python_m_assistant(tmp_path):
    (tmp_path / "calc.py").write_text("print('of somebody else')")
    done = begun(tmp_path, "-m", "assistant", "check", str(GAMMA))
    assert done.returncode == 2 and done.stdout == ""
    assert f"another package called calc stands in the way: {tmp_path / 'calc.py'}" in done.stderr


@pytest.mark.parametrize("module", ["contralbero", "assistant"])
def test_else_it_begins(tmp_path, module):
    (tmp_path / "calc").mkdir()  # a folder without Python is no package of that name
    done = begun(tmp_path, "-m", module, "--version")
    assert done.returncode == 0 and "ontralbero" in done.stdout, done.stderr
