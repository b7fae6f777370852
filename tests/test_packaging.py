"""What is handed on: the source distribution with tests and fixtures, the types, one version."""

import shutil
import subprocess
import sys
import tarfile
import tomllib

import pytest

from calc.sheet.version import VERSION
from tests.conftest import ROOT

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
FOLDERS = ("assistant", "bench", "calc", "designs", "reports", "tests")


def test_the_version_is_the_same_everywhere():
    citation = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    assert PROJECT["version"] == VERSION
    assert f"\nversion: {VERSION}\n" in citation
    assert f"\n## [{VERSION}]" in (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")


def test_the_authors_are_those_of_the_citation():
    citation = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    assert PROJECT["authors"]
    assert all(f'name: "{author["name"]}"' in citation for author in PROJECT["authors"])


@pytest.mark.parametrize("package", ["calc", "reports", "assistant"])
def test_the_packages_say_that_they_are_typed(package):
    assert (ROOT / package / "py.typed").is_file()


@pytest.mark.slow
def test_the_source_distribution_holds_tests_and_fixtures(tmp_path):
    pytest.importorskip("setuptools", minversion="77")
    copy = tmp_path / "copy"
    for name in (*FOLDERS, ".ci"):
        shutil.copytree(ROOT / name, copy / name, ignore=shutil.ignore_patterns("__pycache__", "*.pyc"))
    for path in ROOT.glob("[A-Zcp]*"):
        if path.is_file():
            shutil.copy(path, copy)
    wanted = {str(path.relative_to(copy)) for path in copy.rglob("*") if path.is_file()}
    assert len(wanted) > 500
    code = f"from setuptools import build_meta; build_meta.build_sdist({str(tmp_path)!r})"
    subprocess.run([sys.executable, "-c", code], cwd=copy, check=True, capture_output=True)
    with tarfile.open(next(tmp_path.glob("*.tar.gz"))) as archive:
        packed = {name.partition("/")[2] for name in archive.getnames()}
    assert {name for name in wanted - packed if not name.endswith(".pdf")} == set()
    assert {"README.md", "CONTRIBUTING.md", "CHANGELOG.md", "LICENSE", "pyproject.toml"} <= packed
