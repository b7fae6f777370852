# SPDX-License-Identifier: Apache-2.0
"""What is no TOML, in every way that the grammar knows, is bad input on its own and in front of a design; never a
trace."""

import importlib.util
from pathlib import Path

import pytest

from calc.design.toml_file import parse
from calc.sheet.errors import BadInput
from tests.conftest import DESIGNS

OWN = {
    "bare key with a space": "two words = 1", "no key": "= 1", "no value": "key =", "no equals": "key",
    "two equals": "a = = 1",
    "two values": "a = 1 2", "two keys on a line": "a = 1 b = 2", "a key twice": "a = 1\na = 2",
    "a quoted key twice": 'a = 1\n"a" = 2',
    "dotted over a value": "a = 1\na.b = 2", "table over a value": "a = 1\n[a]\nb = 1", "a table twice": "[a]\n[a]",
    "array over a table": "[a]\n[[a]]", "table over an array": "[[a]]\n[a]",
    "array over a static array": "a = []\n[[a]]",
    "table by dots, then by header": "[a]\nb.c = 1\n[a.b]", "empty header": "[]", "open header": "[a",
    "open array header": "[[a]",
    "header with a line break": "[a\n]", "header with something behind": "[a] b", "empty part of a key": "a..b = 1",
    "key with a dot behind": "a. = 1",
    "key of many lines": '"""a""" = 1', "open string": 'a = "b', "open literal string": "a = 'b",
    "open long string": 'a = """b',
    "open long literal string": "a = '''b", "line break in a string": 'a = "b\nc"', "bad escape": r'a = "\q"',
    "short unicode escape": r'a = "\u12"',
    "surrogate": r'a = "\ud800"', "beyond unicode": r'a = "\U00110000"', "control sign": 'a = "\x01"', "control sign "
                                                                                                       "in a comment": "a = 1 # \x00",
    "DEL": 'a = "\x7f"', "lone carriage return": "a = 1\rb = 2", "bare word": "a = word", "True": "a = True",
    "nil": "a = nil",
    "leading zero": "a = 01", "leading zero, negative": "a = -01", "two signs": "a = ++1",
    "underscore at the end": "a = 1_", "two underscores": "a = 1__0",
    "underscore in front": "a = _1", "upper-case hex": "a = 0XFF", "signed hex": "a = +0xff", "empty hex": "a = 0x",
    "bad octal": "a = 0o8",
    "bad binary": "a = 0b2", "point at the end": "a = 1.", "point in front": "a = .5", "empty exponent": "a = 1e",
    "point in an exponent": "a = 1e1.5",
    "point and exponent": "a = 1.e5", "Inf": "a = Inf", "infinity": "a = infinity", "month 13": "a = 2026-13-01",
    "30 February": "a = 2026-02-30",
    "hour 25": "a = 25:00:00", "short date": "a = 2026-1-1", "date with a half time": "a = 2026-01-01T",
    "open array": "a = [1, 2",
    "array with two commas": "a = [1,,2]", "array with a comma in front": "a = [,1]",
    "array without commas": "a = [1 2]", "open inline table": "a = {b = 1",
    "inline table with a comma behind": "a = {b = 1,}", "inline table of two lines": "a = {b = 1,\n c = 2}",
    "inline table, a key twice": "a = {b = 1, b = 2}",
    "inline table extended": "a = {b = 1}\na.c = 2", "inline table by header": "a = {b = 1}\n[a.c]",
    "comma alone": "a = ,", "brace alone": "}",
    "text behind a value": 'a = "b" c', "comment without a break": "a = 1 \x00",
    "word behind a date": "a = 2026-01-01 word",
}  # fmt: skip
NO_UTF_8 = {
    "latin": "a = 'é'".encode("latin-1"),
    "cut": "a = 'é'".encode()[:-2],
    "overlong": b"a = '\xc0\xaf'",
    "UTF-16": "a = 1".encode("utf-16"),
}
GOOD = (DESIGNS / "r753ie4_gamma.toml").read_bytes()


def refused(raw: bytes) -> None:
    with pytest.raises(BadInput) as caught:
        parse(raw, "stranger.toml")
    assert all(
        str(line).startswith("stranger.toml") and "Traceback" not in line for line in str(caught.value).splitlines()[:1]
    )


@pytest.mark.parametrize("text", OWN.values(), ids=OWN)
def test_what_is_no_toml_is_bad_input(text: str) -> None:
    refused(text.encode())
    refused(text.encode() + b"\n" + GOOD)


@pytest.mark.parametrize("raw", NO_UTF_8.values(), ids=NO_UTF_8)
def test_what_is_no_utf_8_is_bad_input(raw: bytes) -> None:
    refused(raw)


def of_python() -> list[Path]:
    """The files that Python itself is tested with, where its tests are installed."""
    found = importlib.util.find_spec("test")
    places = found.submodule_search_locations if found is not None else None
    return sorted(
        path for place in places or () for path in (Path(place) / "test_tomllib" / "data" / "invalid").rglob("*.toml")
    )


@pytest.mark.parametrize("path", of_python(), ids=lambda path: path.stem)
def test_what_python_refuses_is_bad_input(path: Path) -> None:
    refused(path.read_bytes())
