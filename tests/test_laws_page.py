# SPDX-License-Identifier: Apache-2.0
"""docs/laws.md names property tests that are there, and all of the files that are made of laws."""

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
PAGE = (ROOT / "docs" / "laws.md").read_text(encoding="utf-8")
ROWS = [line for line in PAGE.splitlines() if line.startswith("| ") and not line.startswith("| law |")]
NAMED = re.findall(r"`(tests/[\w/]+\.py)::(test_\w+)`", PAGE)
FILES = sorted({file for file, _ in NAMED})


def property_tests(file):
    """The tests of a file to which Hypothesis gives its inputs."""

    def given(decorator):
        return isinstance(decorator, ast.Call) and isinstance(decorator.func, ast.Name) and decorator.func.id == "given"

    tree = ast.parse((ROOT / file).read_text(encoding="utf-8"))
    return {
        node.name for node in tree.body if isinstance(node, ast.FunctionDef) and any(map(given, node.decorator_list))
    }


def test_there_are_fifty_and_as_many_as_the_page_says():
    assert len(NAMED) == len(set(NAMED)) == len(ROWS) >= 50
    assert f"\n{len(ROWS)} laws " in PAGE


def test_every_row_says_law_range_and_test():
    for row in ROWS:
        cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", row)[1:-1]]
        assert len(cells) == 3 and all(cells), row


@pytest.mark.parametrize("file", FILES)
def test_the_tests_are_there(file):
    named = {name for other, name in NAMED if other == file}
    assert named <= property_tests(file)


def test_no_law_is_left_out():
    for path in (ROOT / "tests" / "calc").rglob("test_laws.py"):
        file = path.relative_to(ROOT).as_posix()
        assert property_tests(file) == {name for other, name in NAMED if other == file}, file


def test_all_steps_have_laws():
    for step in ("engine", "imbalance", "countershaft", "bearings", "gears", "friction"):
        assert len([1 for file, _ in NAMED if f"/{step}/" in file]) >= 8, step
