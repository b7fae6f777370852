# SPDX-License-Identifier: Apache-2.0
"""The list of publications."""

import ast
import re
import tomllib
from pathlib import Path

import pytest

from calc import publications
from calc.publications import cited, full

CALC = Path(publications.__file__).parent
KNOWN = tomllib.loads(publications.TABLE.read_text(encoding="utf-8"))["full"]


def test_a_standard_is_found_whatever_its_year():
    assert full("ISO 6336-2:2006") == full("ISO 6336-2") != "" and full("DIN 9999") == ""


@pytest.mark.parametrize("name", KNOWN)
def test_every_one_is_named_somewhere(name):
    files = (path for path in CALC.rglob("*") if path.suffix in (".py", ".toml") and path != publications.TABLE)
    assert any(name in path.read_text(encoding="utf-8") for path in files)


def test_a_publication_is_told_from_its_clause_and_from_what_has_its_name_within():
    assert cited("AGMA 925-A03, as generally published: working pressure angle") == "AGMA 925-A03"
    assert cited("ISO/TR 15144-1:2014 (84)") == "ISO/TR 15144-1:2014" and cited("ISO 6336-2, 5") == "ISO 6336-2"
    assert cited("by the beam (Cowper 1966, Dowson and Toyoda 1978)") == "Cowper 1966"  # the first
    assert cited("ISO 12345") == cited("equilibrium of the shaft") == ""


# what looks like a publication: names and a year, or a standard with its number
LIKELY = re.compile(
    r"[A-Z][\w.’'-]+(?:(?: |, | & |/| and )(?:[A-Z][\w.’'-]*|et al\.))*,? (?:18|19|20)\d\d\b"
    r"|\b(?:ISO|DIN|AGMA|VDI|FVA|ASTM|API|BS|EN|JIS|SAE|UNI)(?:/(?:TR|TS))?[ -](?:ISO |EN )?[A-Z]?\d+(?:-[A-Z]?\d+)*(?::\d{4})?"
)


def test_every_publication_that_a_formula_names_first_is_listed():
    """A new source that is not in the register would be shown as a rule without a publication."""
    sources = []
    for path in CALC.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "formula" and len(node.args) > 1:
                sources += [one.value for one in ast.walk(node.args[1]) if isinstance(one, ast.Constant) and isinstance(one.value, str)]
    assert len(sources) > 500
    assert {source for source in sources if (likely := LIKELY.search(source)) and cited(source) != likely[0]} == set()
