# SPDX-License-Identifier: Apache-2.0
"""The register of sources, and that every source of the program stands in it."""

import ast
import importlib
import pkgutil
import re
import tomllib
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import pytest

import calc
from calc.design.model import STEPS
from calc.design.toml_file import load
from calc.library.publications import KINDS, KNOWN, PLACES, TABLE, cited, publication, register, resolved
from calc.sheet.check import RULES
from calc.sheet.formula import FORMULAS
from calc.sheet.quantity import keys
from calc.solve import solve
from tests.conftest import FEW, each_shipped

CALC = Path(calc.__file__).parent
ROOT = CALC.parent
TABLES = sorted(path for path in TABLE.parent.glob("*.toml") if path not in (TABLE, PLACES))
READ = {"Finotti 2013", "mechanics textbook", "gear friction thesis"}  # whose text lay before us


@cache
def formulas() -> dict[str, str]:
    for module in pkgutil.walk_packages(calc.__path__, "calc."):
        importlib.import_module(module.name)
    return {name: str(formula.source) for name, formula in FORMULAS.items() if name.startswith("calc.")}


def fields() -> dict[str, str]:
    def of(cls: type, path: str) -> Iterator[tuple[str, str]]:
        for key, known in keys(cls).items():
            if known.about.source:
                yield path + key, str(known.about.source)
            if known.about.table is not None:
                yield from of(known.about.table, f"{path}{key}.")

    return dict(pair for step in STEPS for pair in of(step.inputs, f"{step.key}."))


def of_table(data: Any, path: str = "") -> Iterator[tuple[str, str]]:
    """Every `source` of a table, whatever it stands in."""
    if isinstance(data, dict):
        for key, value in data.items():
            if key == "source" and isinstance(value, str) and data.get("place") != "throughout":
                yield path, f"{value}, {data['place']}" if "place" in data else value
            yield from of_table(value, f"{path}.{key}")
    elif isinstance(data, list):
        for n, value in enumerate(data):
            yield from of_table(value, f"{path}[{n}]")


def lost(sources: dict[str, str]) -> dict[str, str]:
    """Those that the register does not have."""
    return {what: source for what, source in sources.items() if not resolved(source).found}


# --- the register


@pytest.mark.parametrize("name", register())
def test_every_publication_says_what_it_is_and_how_we_know(name):
    row = register()[name]
    assert row.title and row.edition and row.known in KNOWN and set(row.where.values()) <= set(KNOWN)
    assert row.status in ("current", "not checked") or row.status.startswith("superseded by ")
    assert (name in READ) == bool(row.places), "what was read as a whole has its places, and only that"


@pytest.mark.parametrize("name", register())
def test_every_publication_is_cited_somewhere(name):
    files = (path for path in CALC.rglob("*") if path.suffix in (".py", ".toml") and path != TABLE)
    texts = (path.read_text(encoding="utf-8") for path in files)
    assert any(name in text or name.replace(":2", " of 2") in text for text in texts)


def test_a_standard_is_found_whatever_its_year_and_by_its_edition_where_there_is_one():
    assert publication("ISO 898-1:2013") is register()["ISO 898-1"] and publication("DIN 9999") is None
    assert (
        publication("ISO 6336-1:2006").status == "superseded by ISO 6336-1:2019"
        and publication("ISO 6336-1").status == "current"
    )


def test_a_publication_is_told_from_its_clause_and_from_what_has_its_name_within():
    assert cited("AGMA 925-A03: working pressure angle") == "AGMA 925-A03"
    assert cited("ISO/TR 15144-1:2014 (84)") == "ISO/TR 15144-1:2014" and cited("ISO 6336-2, 5") == "ISO 6336-2"
    assert cited("by the beam (Cowper 1966, Dowson and Toyoda 1978)") == "Cowper 1966"  # the first
    assert cited("ISO 12345") == cited("equilibrium of the shaft") == ""


def test_places_are_read_as_they_are_written():
    def places(source: str) -> tuple[str, ...]:
        return resolved(source).citations[0].places

    assert places("Finotti 2013, Tables 4.5 and 4.6, Fig. 4.20, 4.5.1") == (
        "Table 4.5",
        "Table 4.6",
        "Fig. 4.20",
        "4.5.1",
    )
    assert places("Finotti 2013, 4.7 (in chapter 6): 20 MPa") == ("4.7", "ch. 6") and places(
        "Finotti 2013, eq. 2.7, corrected"
    ) == ("eq. 2.7",)
    assert places("gear friction thesis, eqs. 32 (with its limit) and 48: Eyring") == ("eq. 32", "eq. 48")


@pytest.mark.parametrize(
    "source",
    [
        "Finotti 2013, 5.6: Trumpler",  # there is no 5.6
        "Finotti 2013, Tables 5.2 to 5.5",  # nor these tables
        "Finotti 2013: somewhere",  # a place is asked of what lay before us
        "Smith 1999, 3: load",
        "ISO 99999: a standard that is not here",
        "geometry, by Smith 1999",  # a kind does not cover an unknown name
        "as generally published",
        "the sum of both",  # neither kind nor publication
        "",
    ],
)
def test_a_source_that_the_register_does_not_have_is_found_out(source):
    assert not resolved(source).found


def test_how_we_know_follows_the_place():
    def known(source: str) -> str:
        return str(resolved(source).citations[0].known)

    assert (
        known("ASTM D2270, procedure B") == "read in a public reprint"
        and known("ASTM D2270, X2: index 0") == "from memory"
    )
    assert known("Finotti 2013, 4.1: cost") == "read in the source"
    assert known("ISO 6336-1:2006, clause 6: below") == "compared with public code, not with the original"
    assert known("AGMA 925-A03, from memory") == "from memory"


# --- everything that has a source


def test_every_formula():
    assert len(formulas()) > 1000 and lost(formulas()) == {}


def test_every_field():
    assert len(fields()) > 100 and lost(fields()) == {}


@pytest.mark.parametrize("path", TABLES, ids=lambda path: path.name)
def test_every_row_of_a_table(path):
    assert lost(dict(of_table(tomllib.loads(path.read_text(encoding="utf-8"))))) == {}


@pytest.mark.parametrize("path", each_shipped())
def test_every_check_erratum_and_row_of_a_shipped_design(path):
    outcomes = [outcome.whole for outcome in solve(load(path)[1]).outcomes.values()]
    sources = {f"check {c.id}": str(c.source) for o in outcomes for c in o.checks}
    sources |= {f"erratum {e.about}": str(e.source) for o in outcomes for e in o.errata}
    sources |= dict(of_table(tomllib.loads(path.read_text(encoding="utf-8"))))
    assert sources and lost(sources) == {}


def written(path: Path) -> Iterator[str]:
    """The strings of a file of the program, those of its comments and docstrings too, in pieces that are one
    statement."""
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".py":
        yield from (
            n.value for n in ast.walk(ast.parse(text)) if isinstance(n, ast.Constant) and isinstance(n.value, str)
        )
        yield from (line.partition("#")[2] for line in text.splitlines() if "# " in line)
    else:
        yield from text.splitlines()


PLACED = re.compile("(?:" + "|".join(map(re.escape, READ)) + r")[^:;(\"]*")


@pytest.mark.parametrize("folder", ["calc", "reports", "assistant", "designs", "README.md", "CONTRIBUTING.md"])
def test_no_text_names_a_place_that_is_not_there(folder):
    """Notes, hints, comments and designs too: a section, table or figure of what was read must be one of its own."""
    top = ROOT / folder
    files = (
        [top]
        if top.is_file()
        else [p for p in top.rglob("*") if p.suffix in (".py", ".toml", ".md") and p not in (TABLE, PLACES)]
    )
    wrong = {
        (path.name, found): citation.lost
        for path in files
        for text in written(path)
        for found in PLACED.findall(text)
        for citation in resolved(found).citations
        if citation.lost
    }
    assert wrong == {}


def test_nothing_is_generally_published():
    files = [
        p
        for top in ("calc", "reports", "assistant", "designs")
        for p in (ROOT / top).rglob("*")
        if p.suffix in (".py", ".toml", ".md")
    ]
    assert [p.name for p in files if "generally published" in p.read_text(encoding="utf-8")] == []


def test_every_kind_is_used():
    every = [*formulas().values(), *fields().values()]
    every += [source for path in TABLES for _, source in of_table(tomllib.loads(path.read_text(encoding="utf-8")))]
    for path in FEW:
        for outcome in solve(load(path)[1]).outcomes.values():
            every += [str(one.source) for one in (*outcome.checks, *outcome.errata)]
    assert {resolved(source).kind for source in every} - {""} == set(KINDS)


def test_what_is_from_memory_and_decides_a_limit_has_a_second_witness_or_says_that_it_has_none() -> None:
    """By the sources of the limits, as declared and as the shipped designs meet them."""
    limits = [str(rule.source) for rule in RULES.values() if rule.kind == "limit"]
    for file in FEW:
        limits += [str(check.source) for check in solve(load(file)[1]).checks() if check.kind == "limit"]
    named = {c.publication.name: c.publication for source in limits for c in resolved(source).citations}
    deciding = [row for row in named.values() if row.known == "memory"]
    assert {"FKM guideline", "ISO 6336-1", "ISO 898-1", "VDI 2230-1"} <= {row.name for row in deciding}
    assert [row.name for row in deciding if not row.witness] == []
    assert all(str(row.witness_text) in str(row.described()) for row in deciding)
    assert "second witness" in str(publication("VDI 2230-1").described())
