# SPDX-License-Identifier: Apache-2.0
"""Names that the user gave are never translated, though they be words of the program's own vocabulary."""

import re
import tomllib
from pathlib import Path
from typing import Any

import pytest
import tomli_w

from calc.design.toml_file import design, parse
from calc.locale import language
from calc.solve import Results, solve
from tests.conftest import SHIPPED, each_shipped
from tests.languages.texts import named, of_results

VOCABULARY = (
    "rear",
    "left",
    "oil",
    "hole",
    "pump",
    "given",
    "steel",
    "front",
    "mesh",
    "tip",
    "root",
    "wheel",
    "smallest",
    "idler",
    "side",
    "up",
)
TOKENS = tuple(f"Qz{letter}x" for letter in "abcdefghijklmnop")


def _renamed(data: Any, names: dict[str, str]) -> Any:
    """The same with every text that is a name, of an element or where one is referred to, replaced."""
    if isinstance(data, dict):
        return {key: _renamed(value, names) for key, value in data.items()}
    if isinstance(data, list):
        return [_renamed(item, names) for item in data]
    if not isinstance(data, str):
        return data
    kind, _, name = data.partition(" ")  # "mass front", where the balancing sheet counts from
    return f"mass {names[name]}" if kind == "mass" and name in names else names.get(data, data)


def with_names(file: Path, words: tuple[str, ...]) -> Results:
    data = tomllib.loads(file.read_text(encoding="utf-8"))
    data = {key: x for key, x in data.items() if key not in ("measurements", "fits")}  # whose keys have names in them
    names = dict(zip(dict.fromkeys(named(data)), words))
    assert len(names) <= len(words)
    return solve(design(parse(tomli_w.dumps(_renamed(data, names)).encode(), file.name)))


LONG = ("twin_drive", *(path.stem for path in SHIPPED if path.stem.startswith("r753")))


@pytest.mark.parametrize("code", ["it", pytest.param("en", marks=pytest.mark.slow)])
@pytest.mark.parametrize("file", each_shipped(*LONG, "l61"))
def test_names_that_are_words_of_the_program_are_not_translated(file: Path, code: str) -> None:
    """What is said of a design named in vocabulary is what is said of the one named in gibberish, name for name."""
    say = language(code)
    plain = [say(text) for text in of_results(with_names(file, TOKENS))]
    named = [say(text) for text in of_results(with_names(file, VOCABULARY))]
    words = dict(zip(TOKENS, VOCABULARY))
    expected = [re.sub("Qz[a-p]x", lambda m: words[m[0]], text) for text in plain]
    assert len(named) == len(expected)
    assert [pair for pair in zip(named, expected) if pair[0] != pair[1]] == []
