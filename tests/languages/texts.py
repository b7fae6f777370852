# SPDX-License-Identifier: Apache-2.0
"""Every text that a user may see: those that stand in the source, as templates, and those that a design gives.

`python -m tests.languages.texts` lists those of the source that a catalogue does not have yet, as JSON to be filled in.
"""

import ast
import json
import re
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

from calc.design import STEPS
from calc.languages import LANGUAGES, language
from calc.sheet.quantity import keys
from calc.sheet.step import Outcome
from calc.solve import Results

ROOT = Path(__file__).resolve().parents[2]
# what speaks English only: the commands, and what they alone use
ENGLISH = ("calc/validate.py", "calc/sweep.py", "calc/replay.py", "calc/oils.py", "calc/version.py", "calc/languages/", "reports/verify.py", "reports/likeness.py", "assistant/commands/",
           "assistant/cli.py", "assistant/plain.py")  # fmt: skip
# calls whose words nobody sees: names of things, patterns, formats
SILENT = set(
    "getattr hasattr import_module open field Literal cast TypeVar compile match search sub replace split strip startswith endswith encode "
    "decode get pop query_one query add_class set_class has_class remove_class partition rpartition removeprefix removesuffix strftime "
    "Binding work run_worker NewType log".split()
)
PLACE = re.compile(r"\{\d+\}")
WORD = re.compile(r"[^\W\d_]{2,}")
CODE = re.compile(r"[a-z0-9_.\-\[\]*{}=:;,/()<>#]+|[a-z_]+\((-?\d+|True|False|, )*\)|\w+ (-\w+ ?)+")  # keys, actions, classes
STYLE = re.compile(r"(?=.*\b(bold|dim|italic|underline)\b)(((not|bold|dim|italic|underline|on|\$[\w-]+|\{\d+\})\b|\$[\w-]+|\{\d+\}) ?)+")


@cache
def templates() -> dict[str, str]:
    """The texts of the source, what an f-string puts in as {0}, {1} …; each with the first file that has it."""
    found: dict[str, str] = {}
    for top in ("calc", "reports", "assistant"):
        for path in sorted((ROOT / top).rglob("*.py")):
            name = path.relative_to(ROOT).as_posix()
            if not name.startswith(ENGLISH):
                for text in _of(ast.parse(path.read_text(encoding="utf-8"))):
                    found.setdefault(text, name)
    return found


def _of(tree: ast.AST) -> Iterator[str]:
    parents = {child: node for node in ast.walk(tree) for child in ast.iter_child_nodes(node)}
    names = set(_names(tree))
    for node in ast.walk(tree):
        text = _template(node)
        if text is not None and _seen(text) and node not in names and not _silent(node, parents.get(node)):
            yield text


def _names(tree: ast.AST) -> Iterator[ast.AST]:
    """All that stands in annotations and in `__all__`: a name in quotes is no text."""
    for node in ast.walk(tree):
        for inner in (getattr(node, "annotation", None), getattr(node, "returns", None)):
            if inner is not None:
                yield from ast.walk(inner)
        if isinstance(node, ast.Assign) and any(isinstance(target, ast.Name) and target.id == "__all__" for target in node.targets):
            yield from ast.walk(node)


def _template(node: ast.AST) -> str | None:
    if isinstance(node, ast.JoinedStr):
        parts, number = [], 0
        for part in node.values:
            if isinstance(part, ast.Constant):
                parts.append(str(part.value))
            else:
                parts.append(f"{{{number}}}")
                number += 1
        return "".join(parts)
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else None


def _seen(text: str) -> bool:
    """Whether this is a text for a reader, and not a key, an id or a pattern."""
    bare = PLACE.sub(" ", text)
    words = WORD.findall(bare)
    if not words or CODE.fullmatch(text) or STYLE.fullmatch(text) or "(?" in text or "|" in text:
        return False
    if " " in text.strip():
        return any(len(word) > 2 for word in words)
    return re.fullmatch(r"[A-Z][a-z\-’']{2,}[.:]?", bare.strip()) is not None


def _silent(node: ast.AST, parent: ast.AST | None) -> bool:
    """Parts of an f-string, docstrings, keys, comparisons, and what is given to a silent call."""
    if isinstance(parent, (ast.JoinedStr, ast.FormattedValue, ast.Expr, ast.Subscript, ast.Compare)):
        return True
    if isinstance(parent, ast.Dict):
        return node in parent.keys
    if isinstance(parent, ast.Call):
        name = parent.func.attr if isinstance(parent.func, ast.Attribute) else getattr(parent.func, "id", "")
        first = node is parent.args[0] if parent.args else False
        return name in SILENT or (name == "choice" and node in parent.args[1:]) or (name == "formula" and first)
    return False


def of_results(results: Results) -> Iterator[str]:
    """The texts of all steps, with curves and tables."""
    for outcome in results.whole().outcomes.values():
        yield from of_outcome(outcome)
        yield from (value.label for value in outcome.values())


def of_outcome(outcome: Outcome) -> Iterator[str]:
    """The texts of one step, but for the labels of its values."""
    yield from (*outcome.notes, *outcome.proposals, outcome.reason)
    for check in outcome.checks:
        yield from (check.name, check.advice, check.source)
    for erratum in outcome.errata:
        yield from (erratum.label, erratum.why, erratum.source)
    for curve in outcome.curves:
        yield from (curve.title, *curve.names, *curve.variants, *(s.label for s in curve.series), *(name for name, _ in curve.limits))
        yield from (name for turning in curve.turning for name in turning.names)
    for table in outcome.tables:
        yield from (table.title, table.note, *(label for label, _ in table.columns))
        yield from (cell for row in table.rows for cell in row if isinstance(cell, str))
    for line in outcome.lines:
        yield from (line.about, line.formula.source)


def of_inputs() -> Iterator[str]:
    """Titles of the steps, labels and helps of their inputs, and what may stand there."""
    for step in STEPS:
        yield step.title
        yield from _of_inputs(step.inputs)


def _of_inputs(cls: Any) -> Iterator[str]:
    for key in keys(cls).values():
        about = key.about
        yield from (about.label, about.help, about.source)
        if about.kind not in ("choice", "text", "table", "tables"):
            yield about.allowed()
        if about.table is not None:
            yield from _of_inputs(about.table)


if __name__ == "__main__":
    code = sys.argv[1] if len(sys.argv) > 1 else next(code for code in LANGUAGES if code != "en")
    print(json.dumps({text: "" for text in templates() if not language(code).knows(text)}, ensure_ascii=False, indent=0))
