# SPDX-License-Identifier: Apache-2.0
"""The type checker sees a mistake in the order of solving: arguments that are swapped, fields of results that are
misspelt.

Each mistake is made in a copy of its own; one run of mypy has to refuse them all.
"""

import ast
import copy
import re
import subprocess
import sys
from collections.abc import Iterator
from itertools import combinations
from pathlib import Path
from types import NoneType
from typing import get_args, get_type_hints

import pytest

from calc.bearings.inputs import BearingsInputs
from calc.countershaft.inputs import ShaftInputs
from calc.countershaft.rows import BearingRow
from calc.design.model import Design
from calc.design.toml_file import design
from calc.design.toml_file import read as read_design
from calc.measurements.rows import RunRows
from calc.sheet.errors import BadInput
from calc.sheet.quantity import keys

ROOT = Path(__file__).parents[1]
SOLVE, STEP_INPUTS = ROOT / "calc" / "solve.py", ROOT / "calc" / "design" / "step_inputs.py"


def read(path: Path) -> ast.Module:
    """The syntax tree, its imports written out, so that a copy may stand anywhere."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.level == 1:
            node.level, node.module = 0, f"calc.{node.module}" if node.module else "calc"
    return tree


def swapped(tree: ast.Module) -> Iterator[tuple[str, str]]:
    """(what was done, the source) with each pair of arguments of each call swapped, by place or by keyword."""
    for n, node in enumerate(ast.walk(tree)):
        if not isinstance(node, ast.Call) or any(isinstance(a, ast.Starred) for a in node.args):
            continue
        for i, j in combinations(range(len(node.args) + len(node.keywords)), 2):
            changed = copy.deepcopy(tree)
            call = list(ast.walk(changed))[n]
            assert isinstance(call, ast.Call)
            values = [*call.args, *(k.value for k in call.keywords)]
            values[i], values[j] = values[j], values[i]
            call.args = values[: len(call.args)]
            for keyword, value in zip(call.keywords, values[len(call.args) :]):
                keyword.value = value
            yield f"line {node.lineno}: {ast.unparse(call)}", ast.unparse(changed)


def is_result(node: ast.expr) -> bool:
    """Whether an expression is a result, or a part of one."""
    return isinstance(node, ast.Attribute) and (node.attr in ("result", "solution") or is_result(node.value))


def misspelt(tree: ast.Module) -> Iterator[tuple[str, str]]:
    """(what was done, the source) with each field that is read from a result misspelt."""
    for n, node in enumerate(ast.walk(tree)):
        if isinstance(node, ast.Attribute) and is_result(node.value):
            changed = copy.deepcopy(tree)
            attribute = list(ast.walk(changed))[n]
            assert isinstance(attribute, ast.Attribute)
            attribute.attr += "s"
            yield f"line {node.lineno}: {ast.unparse(attribute)}", ast.unparse(changed)


def accepted(mistakes: dict[str, tuple[str, str]], folder: Path) -> list[str]:
    """What was done in those copies in which mypy sees nothing wrong."""
    for name, (_, source) in mistakes.items():
        (folder / f"{name}.py").write_text(source, encoding="utf-8")
    files = [str(folder / f"{name}.py") for name in mistakes]
    run = subprocess.run([sys.executable, "-m", "mypy", *files], cwd=ROOT, capture_output=True, text=True)
    assert run.returncode in (0, 1), run.stderr
    refused = set(re.findall(r"(\w+)\.py:\d+: error: ", run.stdout))
    return [what for name, (what, _) in mistakes.items() if name not in refused]


@pytest.mark.slow
def test_no_two_arguments_of_a_call_can_be_swapped_and_no_field_misspelt(tmp_path):
    swaps = {f"swap_{n}": one for n, one in enumerate(swapped(read(SOLVE)))}
    fields = {f"solve_field_{n}": one for n, one in enumerate(misspelt(read(SOLVE)))}
    more = {f"inputs_field_{n}": one for n, one in enumerate(misspelt(read(STEP_INPUTS)))}
    assert len(swaps) > 100 and len(fields) > 2 and len(more) > 10
    assert accepted({**swaps, **fields, **more}, tmp_path) == []
    # it is the mistakes that are refused
    assert accepted({"as_it_is": ("", ast.unparse(read(SOLVE)))}, tmp_path) == [""]


FORMULA_CALLS = {
    "numbers": ("length_ratio(l=l, d=d) + 1.0", True),
    "a_number_is_no_array": ("length_ratio(l=l, d=d).max()", False),
    "an_array_in_place_of_a_number": ("length_ratio(l=lengths, d=d).max()", True),
    "an_array_is_no_number": ("round(length_ratio(l=lengths, d=d), 3)", False),
    "a_misspelt_argument": ("length_ratio(l=l, D=d) + 1.0", False),
    "a_missing_argument": ("length_ratio(l=l) + 1.0", False),
}


@pytest.mark.slow
def test_a_formula_of_numbers_is_one_of_arrays_too_and_its_arguments_are_held_to_its_own(tmp_path):
    head = "import numpy as np\nfrom calc.bearings.plain.formulas import length_ratio\nl, d, lengths = 1.0, 2.0, np.ones(3)\n"
    calls = {name: (name, f"{head}result = {call}\n") for name, (call, _) in FORMULA_CALLS.items()}
    assert accepted(calls, tmp_path) == [name for name, (_, fits) in FORMULA_CALLS.items() if fits]


# Left out by the file's own rules alone: a sound design has them wherever they are read, as the whole design asks.
ASKED_ELSEWHERE = {
    ShaftInputs: ("material", "speed_ratio"),
    BearingsInputs: ("supply", "supply_pressure"),
    BearingRow: ("position", "diameter", "length", "journal_roughness", "housing_roughness"),
}


def test_an_input_that_may_be_left_out_is_typed_so():
    """Else the type checker takes what is done without it for unreachable, and checks none of it."""
    wrong, seen, classes = [], set(), [Design]
    while classes:
        cls = classes.pop()
        hints = get_type_hints(cls, localns={"RunRows": RunRows})  # which a design without runs does not load
        seen.add(cls)
        for key in keys(cls).values():
            if key.field.default is None and NoneType not in get_args(hints[key.attribute]):
                wrong.append((cls, key.attribute))
            if key.about.table is not None and key.about.table not in seen:
                classes.append(key.about.table)
    elsewhere = [(cls, field) for cls, fields in ASKED_ELSEWHERE.items() for field in fields]
    assert len(seen) > 20 and sorted(wrong, key=str) == sorted(elsewhere, key=str)


@pytest.mark.parametrize(
    ("cls", "field"), [(cls, field) for cls, fields in ASKED_ELSEWHERE.items() for field in fields]
)
def test_what_the_whole_design_asks_is_no_sound_design_without(cls, field):
    (key,) = [key.key for key in keys(cls).values() if key.attribute == field]
    there = {BearingRow: "shafts.shaft.bearings.rear", BearingsInputs: "bearings"}.get(cls, "shafts.shaft")
    with pytest.raises(BadInput) as bad:
        design(
            read_design(ROOT / "tests" / "data" / "upgraded" / "r753ie4_gamma.toml").with_value(f"{there}.{key}", None)
        )
    assert [error.key.rpartition(".")[2] for error in bad.value.errors] == [key]
