# SPDX-License-Identifier: Apache-2.0
"""The reference of keys: every key of the schema stands there, with its unit and its address."""

import json
import re

import pytest

from tests.conftest import ROOT

REFERENCE = ROOT / "docs" / "reference"
SCHEMA = json.loads((ROOT / "docs" / "contralbero.schema.json").read_text(encoding="utf-8"))
ENTRY = re.compile(
    r'^### <a id="(?P<path>[^"]+)"></a>`(?P<key>\w+)`\n(?P<text>.*?)(?=^##|\Z)', re.MULTILINE | re.DOTALL
)


def properties(table, prefix=""):
    """Every key of the schema by its path, as the schema has it."""
    for key, known in table.get("properties", {}).items():
        yield f"{prefix}{key}", known
        yield from properties(known.get("items", known), f"{prefix}{key}.")


@pytest.fixture(scope="module")
def entries():
    return {
        entry["path"]: (page.name, entry["text"])
        for page in REFERENCE.glob("keys_*.md")
        for entry in ENTRY.finditer(page.read_text(encoding="utf-8"))
    }


def test_every_key_of_the_schema_stands_there_and_no_other(entries):
    known = dict(properties(SCHEMA))
    assert len(known) > 700
    assert entries.keys() == known.keys()


def test_an_entry_says_what_the_schema_says(entries):
    """Label, words and bounds of the schema, which is written from the same declarations by other code."""
    for path, known in properties(SCHEMA):
        text = entries[path][1]
        label = known["description"].partition(". ")[0]
        assert text.replace("\\", "").lstrip().startswith(f"`{path}`: **{label.rpartition(', ')[0] or label}"[:40]), (
            path
        )
        words = [word for word in known.get("enum", ()) if isinstance(word, str)]
        assert all(f'"{word}"' in text for word in words), path
        assert known.get("minimum", known.get("maximum")) is None or re.search(r"Allowed: .*\d", text), path


def test_the_index_leads_to_every_key(entries):
    links = dict(
        re.findall(r"\[`([^`]+)`\]\((keys_\w+\.md)#\1\) \|$", (REFERENCE / "keys.md").read_text(encoding="utf-8"), re.M)
    )
    assert links == {path: page for path, (page, _) in entries.items()}


@pytest.mark.parametrize(
    "path, words",
    [
        ("shafts.overdesign_percent", ("in %", "(overdesign)", "Left out: 0 %", 'Only with `mode` = `"size"`')),
        ("bearings.hole_diameter_mm", ("in mm", "Oil hole diameter", '`"shaft"`', "`bearings.B.supply_range`")),
        (
            "engine.bore_mm",
            ("**Bore**, in mm.", "Must be given.", "[engine](../theory/engine.md), [gears](../theory/gears.md)"),
        ),
        ("bearings.supply", ("through holes in the journal", "one of ")),
        ("gears.wheels.teeth", ("a whole number",)),
    ],
)
def test_an_entry_has_all_that_is_known(entries, path, words):
    assert [word for word in words if word not in entries[path][1]] == []
