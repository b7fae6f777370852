# SPDX-License-Identifier: Apache-2.0
"""Every text that a user may see: those that stand in the source, as templates, and those that a design gives.

`python -m tests.languages.texts it` brings the catalogue of a language up to date: it adds the templates that are new
in the source (with an empty translation, to be filled in), leaves out those that are gone, and compiles it."""

import ast
import io
import os
import sys
import tomllib
import warnings
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import fields, is_dataclass
from datetime import UTC, datetime
from functools import cache
from pathlib import Path
from typing import Any

from babel.messages.catalog import Catalog
from babel.messages.mofile import write_mo
from babel.messages.pofile import read_po, write_po

from calc.bearings.plain.materials import bearing_materials, running_bearings
from calc.design.model import STEPS
from calc.library.catalogue import base_stocks, materials, shipped_oils
from calc.library.makers import maker_sheets
from calc.locale.language import FOLDER, PLACE, WORD
from calc.sheet.quantity import keys
from calc.sheet.step import Outcome
from calc.sheet.text import Text
from calc.solve import Results
from calc.studies.shipped import engines

ROOT = Path(__file__).resolve().parents[2]
# calls whose first argument is a label
FIELDS = {
    "value",
    "values",
    "quantity",
    "integer",
    "text",
    "choice",
    "series",
    "integers",
    "names",
    "table",
    "tables",
    "open_",
    "flag",
}
SENTENCES = {"help", "source", "brief", "change"}  # their keywords that are texts
RELEASE = bool(os.environ.get("RELEASE"))  # RELEASE=1 pytest tests/languages: every text must have its translation
# for one and for many: babel's own rules differ from version to version
PLURALS = ("Plural-Forms", "nplurals=2; plural=(n != 1);")
Template = tuple[str, str]  # the template, and that for a count of 1 ("": none)


@cache
def templates() -> dict[Template, str]:
    """The templates of the source, each with the first file that has it."""
    found: dict[Template, str] = {}
    for top in ("calc", "reports", "assistant"):
        for path in sorted((ROOT / top).rglob("*.py")):
            for template in _of(ast.parse(path.read_text(encoding="utf-8"))):
                if WORD.search(PLACE.sub("", template[0])):
                    found.setdefault(template, path.relative_to(ROOT).as_posix())
    return found


def _of(tree: ast.AST) -> Iterator[Template]:
    constants = {
        target.id: node.value.value
        for node in ast.walk(tree)
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)
        for target in node.targets
        if isinstance(target, ast.Name)
    }

    def literals(node: ast.expr) -> Iterator[str]:
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and node.value:
            yield node.value
        elif isinstance(node, ast.Name) and constants.get(node.id):
            yield constants[node.id]
        elif isinstance(node, ast.IfExp):
            yield from (*literals(node.body), *literals(node.orelse))
        elif isinstance(node, ast.JoinedStr):  # of words that have a name
            parts = [list(literals(p.value if isinstance(p, ast.FormattedValue) else p)) for p in node.values]
            if all(parts):
                yield "".join(part for (part,) in parts)
        elif isinstance(node, ast.Tuple):  # the words of a change
            yield from (text for element in node.elts for text in literals(element))

    for node in ast.walk(tree):
        if not isinstance(node, ast.Call):
            continue
        name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
        words = {k.arg: k.value for k in node.keywords}
        if name == "group" and "words" in words:
            yield from ((text, "") for text in literals(words["words"]))
        if not node.args:
            continue
        field = name in FIELDS and isinstance(node.func, ast.Name)
        if field or name in {"Text", "axis_label"}:
            yield from ((text, "") for text in literals(node.args[0]))
        if field or name == "as_in":
            yield from ((text, "") for key in SENTENCES & words.keys() for text in literals(words[key]))
        if name == "_ended":  # the last two of a list (`calc.sheet.text`)
            yield from ((text, "") for text in literals(node.args[1]))
        if name == "plural":
            yield from ((many, one) for one in literals(node.args[0]) for many in literals(node.args[1]))
        if name == "formula":
            yield from (
                (text, "") for said in (*node.args[1:2], *filter(None, [words.get("shows")])) for text in literals(said)
            )
            if isinstance(meanings := words.get("meanings"), ast.Dict):
                yield from ((text, "") for said in meanings.values for text in literals(said))


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
        yield from (
            curve.title,
            *curve.names,
            *curve.variants,
            *(s.label for s in curve.series),
            *(name for name, _ in curve.limits),
        )
        yield from (name for turning in curve.turning for name in turning.names)
    for table in outcome.tables:
        yield from (table.title, table.note, *(label for label, _ in table.columns))
        yield from (cell for row in table.rows for cell in row if isinstance(cell, str))
    for line in outcome.lines:
        yield from (line.about, line.formula.source)


def named(data: Any) -> Iterator[str]:
    """The names of all elements, in the order of the file."""
    if isinstance(data, dict):
        for value in data.values():
            if isinstance(value, list) and all(isinstance(item, dict) for item in value):
                yield from (item["name"] for item in value if "name" in item)
            yield from named(value)
    elif isinstance(data, list):
        for item in data:
            yield from named(item)


@cache
def of_tables() -> frozenset[str]:
    """The words of the program's own tables, but for the names of their rows."""
    files = list((ROOT / "calc" / "library" / "tables").glob("*.toml"))
    assert files, "the tables have been moved"
    return frozenset(text for file in files for text in _words(tomllib.loads(file.read_text(encoding="utf-8"))))


def _words(data: Any) -> Iterator[str]:
    if isinstance(data, str):
        yield data
    elif isinstance(data, list):
        yield from (word for item in data for word in _words(item))
    elif isinstance(data, dict):
        yield from (word for key, item in data.items() if key != "name" for word in _words(item))


def of_catalogues() -> Iterator[Text]:
    """What the tables of oils, materials, bearings and engines tell beside names and numbers; of makers' sheets, which
    are read in the terminal alone, the places of their journals."""
    yield from _texts(tuple(journal.place for sheet in maker_sheets().values() for journal in sheet.journals))
    yield from _texts((shipped_oils(), base_stocks(), materials(), bearing_materials(), running_bearings(), engines()))


def _texts(thing: Any) -> Iterator[Text]:
    if isinstance(thing, Text):
        yield thing
    elif isinstance(thing, Mapping):
        yield from _texts(tuple(thing.values()))
    elif isinstance(thing, tuple):
        yield from (text for part in thing for text in _texts(part))
    elif is_dataclass(thing):
        yield from _texts(tuple(getattr(thing, field.name) for field in fields(thing)))


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


# --- the catalogues
def po(code: str) -> Path:
    return FOLDER / code / "LC_MESSAGES" / "contralbero.po"


def entries(code: str) -> dict[Template, tuple[str, ...]]:
    """Template → translation (of a plural: for one, for many)."""
    with po(code).open("rb") as file:
        return {
            (m.id, "") if isinstance(m.id, str) else (m.id[1], m.id[0]): (m.string,)
            if isinstance(m.string, str)
            else tuple(m.string)
            for m in read_po(file, locale=code)
            if m.id
        }


@cache
def untranslated(code: str) -> dict[str, str]:
    """The templates that have no translation yet, each with the first file that has it."""
    known = entries(code)
    without = {many: file for (many, one), file in templates().items() if not all(known.get((many, one), ("",)))}
    asked = {text.template for text in of_catalogues() if WORD.search(PLACE.sub("", text.template))}
    return without | {text: "calc/library/tables" for text in asked if not all(known.get((text, ""), ("",)))}


def before_release(words: str) -> None:
    """What stops a release, and is listed among the warnings before it."""
    assert not RELEASE, words
    warnings.warn(words, stacklevel=2)


def judge_english(code: str, left: Iterable[str]) -> None:
    """English that is left is a mistake where every text has its translation.  Before a release some may have none:
    then they may be the reason, and what is left is listed."""
    found = sorted(left)
    if found and untranslated(code):
        before_release(f"English is left in {code}: {len(found)}: {'; '.join(text[:60] for text in found[:5])} …")
    else:
        assert not found, f"{len(found)}: {found[:5]}"


def compiled(code: str) -> bytes:
    """The catalogue as the program reads it, without a date: the same file gives the same bytes."""
    data = io.BytesIO()
    with po(code).open("rb") as file:
        catalog = read_po(file, locale=code)
    catalog.creation_date = datetime(2000, 1, 1, tzinfo=UTC)
    write_mo(data, catalog)
    return data.getvalue()


def update(code: str) -> None:
    po(code).parent.mkdir(parents=True, exist_ok=True)
    known = entries(code) if po(code).exists() else {}
    catalog = Catalog(locale=code, fuzzy=False, header_comment=f"# The texts of contralbero in {code}.")
    catalog.mime_headers = [PLURALS]
    for many, one in templates():
        told = known.get((many, one), ("", "") if one else ("",))
        catalog.add((one, many) if one else many, told if one else told[0])
    for word in of_tables():
        if (word, "") in known and (word, "") not in templates():
            catalog.add(word, known[word, ""][0])
    text = io.BytesIO()
    write_po(text, catalog, sort_output=True, no_location=True, width=76)
    dated = (
        b'"POT-Creation-Date',
        b'"PO-Revision-Date',
        b'"Generated-By',
        b'"Last-Translator',
        b'"Language-Team',
        b'"Report-Msgid',
    )
    po(code).write_bytes(b"\n".join(row for row in text.getvalue().split(b"\n") if not row.startswith(dated)))
    po(code).with_suffix(".mo").write_bytes(compiled(code))


if __name__ == "__main__":
    update(sys.argv[1])
