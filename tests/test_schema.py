# SPDX-License-Identifier: Apache-2.0
"""The JSON Schemas.  Of a design: every shipped design keeps that of its schema, it refuses what the program refuses of
one key.  Of the results: what is promised of them stays.  Docs has both as they are."""

import json
import os
import subprocess
import sys
import tomllib

import pytest

from assistant.results_schema import results_schema
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


def test_docs_has_them_as_they_are():
    docs = ROOT / "docs"
    written = (docs / "contralbero.schema.json").read_text(encoding="utf-8")
    assert written == run("schema").stdout == run("schema", "--schema", "2").stdout
    results = (docs / "contralbero.results.schema.json").read_text(encoding="utf-8")
    assert results == run("schema", "--results").stdout


@pytest.mark.parametrize("words", [["--schema", 1], ["--schema", 2], ["--results"]], ids=str)
def test_each_names_its_dialect_and_itself_as_validators_want_it(words):
    """With https, or without the sign at its end, ajv knows no such dialect."""
    schema = json.loads(run("schema", *words).stdout)
    assert schema["$schema"] == "http://json-schema.org/draft-07/schema#"
    of = "results:2" if words == ["--results"] else f"design:{words[1]}"
    assert schema["$id"] == f"urn:contralbero:{of}"
    jsonschema.Draft7Validator.check_schema(schema)


def nodes(schema, path=()):
    """Every schema in a schema, with its way."""
    if isinstance(schema, dict):
        yield path, schema
        for name, part in schema.items():
            yield from nodes(part, (*path, name))
    elif isinstance(schema, list):
        for n, part in enumerate(schema):
            yield from nodes(part, (*path, n))


def test_a_default_is_what_the_program_takes_and_allows(judge):
    known = {
        path: node
        for path, node in nodes(judge.schema)
        if "default" in node and isinstance(node.get("description"), str)
    }
    wrong = {
        path: node["default"]
        for path, node in known.items()
        if not jsonschema.Draft7Validator(node).is_valid(node["default"])
    }
    assert len(known) > 80 and not wrong
    bearings = judge.schema["properties"]["bearings"]["properties"]
    assert bearings["outlet_temperature_limit_C"]["default"] == 135.0  # in the unit of the key
    assert bearings["viscosity_law"]["default"] == "walther"
    assert (
        "default" not in bearings["oil"]
        and "default" not in judge.schema["properties"]["engine"]["properties"]["bore_mm"]
    )


def test_shipped_oils_and_materials_are_offered_and_own_ones_allowed(judge):
    bearings = judge.schema["properties"]["bearings"]["properties"]
    offered, own = bearings["oil"]["anyOf"]
    assert "5W-30" in offered["enum"] and own == {"type": "string"}
    steels = judge.schema["properties"]["shafts"]["items"]["properties"]["material"]["anyOf"][0]["enum"]
    assert "20CrNi4" in steels
    design = data((NEW / "r753ie4_gamma.toml").read_text(encoding="utf-8"))
    design["bearings"]["oil"] = "our own"
    assert judge.is_valid(design)
    design["bearings"]["bush_material"] = "our own"  # of which there is no table in a design
    assert not judge.is_valid(design)


# --- the results


def promised(schema, path=""):
    """What is said of each field: its way, and what it may be."""
    schema = {
        name: part
        for name, part in schema.items()
        if name not in ("description", "required", "$schema", "$id", "title")
    }
    fields, inner = schema.pop("properties", {}), schema.pop("items", None)
    by = schema.pop("additionalProperties", None)
    schema.pop("propertyNames", None)
    told = {path: json.dumps(schema, sort_keys=True).replace('"description": "", ', "")}
    for name, part in fields.items():
        told |= promised(part, f"{path}.{name}".removeprefix("."))
    for sign, part in (("[]", inner), ("{}", by)):
        if part is not None:
            told |= promised(part, path + sign)
    return told


def test_what_is_promised_of_the_results_stays():
    """The file is of the day on which this schema was published: a field of it that is gone, or may be something else,
    needs a schema of another number, and a file of its own."""
    kept = json.loads((ROOT / "tests" / "data" / "results_2.json").read_text(encoding="utf-8"))
    now = promised(results_schema())
    assert len(kept) > 70 and {path: now.get(path) for path in kept} == kept


def closed(schema):
    """The same without leave to have further fields."""
    if isinstance(schema, list):
        return [closed(part) for part in schema]
    if not isinstance(schema, dict):
        return schema
    more = {"additionalProperties": False} if "properties" in schema and "required" in schema else {}
    return {name: closed(part) for name, part in schema.items()} | more


def results_are_told(path, *words):
    """Every field of the results is in the schema, and is what it says."""
    found = json.loads(run("check", path, "--json", *words).stdout)
    wrong = [
        (list(e.path), e.message[:200]) for e in jsonschema.Draft7Validator(closed(results_schema())).iter_errors(found)
    ]
    assert not wrong, wrong[:5]
    return found


def test_the_results_of_a_design_are_as_the_schema_says(tmp_path):
    gamma = DESIGNS / "r753ie4_gamma.toml"
    found = results_are_told(gamma, "--step", "bearings", "--set", "bearings.front.length_mm=30")
    assert found["design"]["set"] == ["bearings.front.length_mm=30"] and found["checks"] and found["tables"]
    broken = json.loads(json.dumps(found))
    broken["checks"][0]["verdict"] = "good"
    del broken["counts"]
    assert len(list(jsonschema.Draft7Validator(results_schema()).iter_errors(broken))) == 2
    assert jsonschema.Draft7Validator(results_schema()).is_valid(found | {"later": 1})  # of a later version
    out = tmp_path / "x.json"
    run("export", DESIGNS / "timing_pair.toml", "--json", "-o", out)
    assert json.loads(out.read_text(encoding="utf-8")) == results_are_told(DESIGNS / "timing_pair.toml")


@pytest.mark.slow
@pytest.mark.parametrize(
    "path", [*sorted(DESIGNS.glob("*.toml")), *sorted((DESIGNS / "makers").glob("*.toml"))], ids=lambda path: path.stem
)
def test_the_results_of_every_shipped_design_are_as_the_schema_says(path):
    results_are_told(path)


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
