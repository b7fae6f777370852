# SPDX-License-Identifier: Apache-2.0
"""The list of publications."""

import tomllib
from pathlib import Path

import pytest

from calc import publications
from calc.publications import full

CALC = Path(publications.__file__).parent
KNOWN = tomllib.loads(publications.TABLE.read_text(encoding="utf-8"))["full"]


def test_a_standard_is_found_whatever_its_year():
    assert full("ISO 6336-2:2006") == full("ISO 6336-2") != "" and full("DIN 9999") == ""


@pytest.mark.parametrize("name", KNOWN)
def test_every_one_is_named_somewhere(name):
    files = (path for path in CALC.rglob("*") if path.suffix in (".py", ".toml") and path != publications.TABLE)
    assert any(name in path.read_text(encoding="utf-8") for path in files)
