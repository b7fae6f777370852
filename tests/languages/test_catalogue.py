# SPDX-License-Identifier: Apache-2.0
"""No text stays English where another language is spoken."""

import json
import re
import tomllib
from pathlib import Path

import pytest

from calc.design_file import design, read
from calc.languages import LANGUAGES, Language, language
from calc.languages.language import FOLDER, PLACE
from calc.languages.outcome import said
from calc.solve import solve

from .texts import ROOT, of_inputs, of_results, templates

OTHERS = [code for code in LANGUAGES if code != "en"]
# words by which English is known; none of them is a word of Italian, a name or a symbol
ENGLISH = re.compile(r"\b(the|of|with|from|and|is|are|for|which|that|by|at|to|than|its|it|not|this|or|as|on|an|has|have|was)\b")
QUOTED = re.compile(r'"[^"]*"|“[^”]*”|`[^`]*`|\b[A-Z]\w+,? (and|&) [A-Z]\w+')  # keys and choices of the file; two authors
DESIGNS = sorted((ROOT / "designs").glob("*.toml"))


@pytest.mark.parametrize("code", OTHERS)
def test_every_text_of_the_source_has_an_entry(code: str) -> None:
    say = language(code)
    missing = {text: file for text, file in templates().items() if not say.knows(text)}
    assert not missing, f"{len(missing)} texts without an entry; `python -m tests.languages.texts {code}` lists them"


@pytest.mark.parametrize("code", OTHERS)
def test_entries_keep_what_is_put_in(code: str) -> None:
    for file in sorted((FOLDER / code).glob("*.json")):
        for text, made in json.loads(file.read_text(encoding="utf-8")).items():
            assert made, text
            assert sorted(PLACE.findall(text)) == sorted(PLACE.findall(made)), text
            assert (text[0] == " ", text[-1] == " ") == (made[0] == " ", made[-1] == " "), text


@pytest.mark.parametrize("code", OTHERS)
def test_no_entry_is_of_a_text_that_is_gone(code: str) -> None:
    """But for words.json: what is only put together when the program runs."""
    known = set(templates())
    for file in sorted((FOLDER / code).glob("*.json")):
        if file.name != "words.json":
            gone = [text for text in json.loads(file.read_text(encoding="utf-8")) if text not in known]
            assert not gone, f"{file.name}: {gone[:3]}"


@pytest.mark.parametrize("code", OTHERS)
@pytest.mark.parametrize("file", DESIGNS, ids=lambda path: path.stem)
def test_no_english_word_is_left_in_what_a_design_gives(file: Path, code: str) -> None:
    say = language(code)
    left = sorted({made for text in of_results(solve(design(read(file)))) if ENGLISH.search(QUOTED.sub("", made := say(text)))})
    assert not left, f"{len(left)}: {left[:5]}"


@pytest.mark.parametrize("code", OTHERS)
def test_no_english_word_is_left_in_the_forms(code: str) -> None:
    say = language(code)
    left = sorted({made for text in of_inputs() if ENGLISH.search(QUOTED.sub("", made := say(text)))})
    assert not left, f"{len(left)}: {left[:5]}"


def test_the_catalogues_are_installed_with_the_program() -> None:
    """A file that is no Python is only in a package where its ending is listed."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    listed = project["tool"]["setuptools"]["package-data"]["*"]
    assert all(any(file.match(pattern) for pattern in listed) for code in OTHERS for file in (FOLDER / code).iterdir())


# --- the mechanism
def test_a_text_is_found_by_its_template() -> None:
    say = Language(
        "xx",
        {"Film at the edge": "Meato al bordo", "front": "anteriore", "Wheel {0}: {1} is missing": "Ruota {0}: manca {1}", "oil": "olio",
         "{0} of {1}": "{0} di {1}", "Take {0} µm off {1}.": "Togliere {0} µm a {1}.", "Then check again": "Poi ricontrollare",
         "a {} b {} long enough": "x {1} y {0} abbastanza", "Saved: {0}": "Salvato: {0}",
         "above {0} and up to {1}": "sopra {0} e fino a {1}", "{0} to {1} {2}": "da {0} a {1} {2}"},
    )  # fmt: skip
    assert say("Film at the edge") == "Meato al bordo"
    assert say("Film at the edge, front") == "Meato al bordo, anteriore"
    assert say("Wheel idler: oil is missing") == "Ruota idler: manca olio"
    assert say("oil of idler") == "olio di idler"
    assert say("Take 3 µm off idler. Then check again.") == "Togliere 3 µm a idler. Poi ricontrollare."
    assert say("a 1 b 2 long enough") == "x 2 y 1 abbastanza"
    assert say("Saved: /home/so und so/a.toml") == "Salvato: /home/so und so/a.toml"
    assert say("above 0 and up to 100 bar") == "sopra 0 e fino a 100 bar"
    assert say("nothing known here") == "nothing known here"
    assert say("") == "" and say("12.5 µm") == "12.5 µm"


def test_english_is_what_it_was() -> None:
    assert language("en")("Film at the edge, front") == "Film at the edge, front"
    with pytest.raises(KeyError):
        language("tlh")


def test_only_words_change() -> None:
    """Numbers, ids, verdicts and curves of an outcome are those of the original."""
    results = solve(design(read(ROOT / "designs" / "r753ie4_gamma.toml")))
    for outcome in results.outcomes.values():
        whole = outcome.whole
        made = said(whole, language("it"))
        assert [(c.id, c.value, c.limit, c.verdict) for c in made.checks] == [(c.id, c.value, c.limit, c.verdict) for c in whole.checks]
        assert all(a.value is b.value for a, b in zip(made.lines, whole.lines))
        assert [c.id for c in made.curves] == [c.id for c in whole.curves]
        assert all(s.y is t.y for a, b in zip(made.curves, whole.curves) for s, t in zip(a.series, b.series))
        assert said(whole, language("en")) is whole
