# SPDX-License-Identifier: Apache-2.0
"""What is declared can be named by its declaration: a rename is one edit, and a misspelling an error of the types."""

import ast
import re
from collections.abc import Iterator
from dataclasses import fields
from functools import cache
from pathlib import Path
from types import UnionType
from typing import get_args, get_origin

import pytest

from calc.bearings.plain.result import PlainResult
from calc.bearings.result import BearingsResult
from calc.countershaft.result import CountershaftResult
from calc.countershaft.rows import BearingRow
from calc.design.model import STEP_KEYS, STEPS, Design
from calc.design.toml_file import design, read
from calc.engine.inputs import EngineInputs
from calc.engine.result import EngineResult
from calc.friction.result import FrictionResult
from calc.gears.result import TrainResult
from calc.imbalance.result import ImbalanceResult
from calc.mounting.result import MountingResult
from calc.sheet.quantity import dotted, keys, results_of
from calc.solve import solve
from calc.studies.shipped import EXAMPLE

ROOT = Path(__file__).resolve().parents[3]
# files that may spell keys or ids, each with the reason
EXCUSED = {
    "assistant/results_schema.py": "fields of the JSON, whose names are promised",
    "assistant/results_text.py": "fields of the JSON, whose names are promised",
    "calc/exchange/loads_text.py": "columns of the loads, whose names are promised",
    "calc/bearings/rolling/sizes.py": "columns of the table of outlines",
    "calc/countershaft/making/drain.py": "columns of the house's own tables",
    "calc/library/catalogue.py": "columns of the table of materials",
    "calc/library/tolerances.py": "a column of the table of ISO 286",
    "calc/design/other_tables.py": "keys of [optimise.most], which is of free form",
    "calc/draw/sheet_data.py": "stands below the steps whose keys it reads",
    "calc/gears/rating/checks.py": "names inputs of bearings and friction, which stand above it",
    "calc/design/downgrade.py": "the keys of schema 1",
    "calc/design/upgrade.py": "keys of schema 1, which are declared nowhere any more",
    "calc/design/upgrade_text.py": "words of a text, of keys that are declared nowhere any more",
    "calc/gears/layout/room.py": "names inputs of the shaft and its bearings, which stand above it",
}


def test_keys_and_ids_are_those_of_file_and_report() -> None:
    assert dotted(Design.engine, EngineInputs.bore) == "engine.bore_mm"
    assert dotted(Design.bearings, "front", BearingRow.length) == "bearings.front.length_mm"
    assert dotted(Design.engine, EngineResult.stroke) == "engine.stroke"


def test_a_value_is_found_by_its_declaration() -> None:
    results = solve(design(read(EXAMPLE)))
    stroke = results.value(EngineResult.stroke)
    assert stroke is not None and stroke.id == "engine.stroke"
    films = results.values_of(PlainResult.film_edge)
    assert [v.id for v in films] == ["bearings.front.film_edge", "bearings.rear.film_edge"]


# --- no key and no id is spelt a second time
# A key or id that is written as a string is not found when its field is renamed.

Way = tuple[str, ...]  # the parts of a key or id; * for what a design names


def inputs_of(kind: type, way: Way) -> Iterator[Way]:
    for key in keys(kind).values():
        here = (*way, key.key)
        yield here
        if key.about.table is not None:
            yield from inputs_of(key.about.table, (*here, "*") if key.about.kind == "tables" else here)


def values_of(kind: type, way: Way) -> Iterator[Way]:
    for f in fields(kind):
        if "value" in f.metadata:
            yield (*way, f.name.rstrip("_"))
        elif "group" in f.metadata:
            here = way if f.metadata["group"].spread else (*way, f.name)
            content = without_none(f.type)
            if get_origin(content) is dict:
                content, here = without_none(get_args(content)[1]), (*here, "*")
            for one in results_of(content):
                yield from values_of(one, here)


def without_none(hint: object) -> object:
    return get_args(hint)[0] if isinstance(hint, UnionType) else hint


@cache
def declared() -> dict[str, list[Way]]:
    """The keys and ids of all steps and of the design itself, by their last part."""
    first = (EngineResult, ImbalanceResult, CountershaftResult, BearingsResult, TrainResult)
    ways = {way for way in inputs_of(Design, ()) if len(way) > 1}
    for step, kind in zip(STEP_KEYS, (*first, FrictionResult, MountingResult), strict=True):
        ways |= set(values_of(kind, (step,)))
    by_last: dict[str, list[Way]] = {}
    for way in ways:
        by_last.setdefault(way[-1], []).append(way)
    return by_last


@cache
def with_unit() -> set[str]:
    """The keys that end in a unit: words of a design file and of nothing else."""

    def walk(kind: type) -> Iterator[str]:
        for key in keys(kind).values():
            if key.about.units.suffix:
                yield key.key
            if key.about.table is not None:
                yield from walk(key.about.table)

    return {key for step in STEPS for key in walk(step.inputs)} | set(walk(Design))


def is_spelt(text: str) -> bool:
    """Whether a string is a key or id; `{}` stands for what an f-string puts in."""
    if " " in text.strip():  # several of them
        words = [word for word in text.split() if word != "{}"]
        return bool(words) and all(map(is_spelt, words))
    parts = text.split(".")
    if not all(re.fullmatch(r"[\w{}-]+", part) for part in parts):
        return False
    if parts[-1] in with_unit():
        return True
    return any("{" not in part for part in parts[:-1]) and any(
        len(way) == len(parts) and all(a == b or b == "*" or "{}" in a for a, b in zip(parts, way))
        for way in declared().get(parts[-1], ())
    )


def spelt(source: str) -> list[str]:
    """The keys and ids in a source, but for sentences, labels, and the ids of checks, curves and tables."""
    tree = ast.parse(source)
    passed: set[int] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.JoinedStr):
            passed |= {id(part) for part in node.values}
        elif isinstance(node, ast.Expr):
            passed.add(id(node.value))
        elif isinstance(node, ast.Call):
            called = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
            if called == "judged":
                passed |= {id(part) for part in ast.walk(node)}
            elif called in ("Text", "formula", "value", "check", "CheckRule", "Curve", "Table") and node.args:
                passed |= {id(part) for part in ast.walk(node.args[0])}
    return [text for node in ast.walk(tree) if id(node) not in passed and (text := text_of(node)) and is_spelt(text)]


def text_of(node: ast.AST) -> str:
    if isinstance(node, ast.Constant):
        return node.value if isinstance(node.value, str) else ""
    if isinstance(node, ast.JoinedStr):
        return "".join(part.value if isinstance(part, ast.Constant) else "{}" for part in node.values)
    return ""


@cache
def all_spelt() -> dict[str, list[str]]:
    paths = [path for top in ("calc", "reports", "assistant") for path in sorted((ROOT / top).rglob("*.py"))]
    known = {path.relative_to(ROOT).as_posix(): spelt(path.read_text(encoding="utf-8")) for path in paths}
    return {path: texts for path, texts in known.items() if texts}


@pytest.mark.parametrize(
    "source",
    [
        'x = "engine.bore_mm"',
        'x = f"bearings.{place}.film_edge"',
        'x = f"{here}.length_mm"',
        'row["rod_length_mm"]',
        'x = "engine.layout engine.strokes"',
    ],
)
def test_a_key_that_is_spelt_is_seen(source: str) -> None:
    assert spelt(source)


@pytest.mark.parametrize(
    "source", ['Text("give engine.bore_mm")', 'CheckRule("countershaft.bending_stress", x)', 'x = "engine.firing.even"']
)
def test_a_sentence_and_the_id_of_a_check_are_none(source: str) -> None:
    assert not spelt(source)


def test_no_key_and_no_id_is_spelt_beside_its_declaration() -> None:
    assert {path: texts for path, texts in all_spelt().items() if path not in EXCUSED} == {}
    assert EXCUSED.keys() - all_spelt().keys() == set(), "no excuse is needed any more"
