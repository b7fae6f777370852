# SPDX-License-Identifier: Apache-2.0
"""The catalogues are whole and current, and no text stays English where another language is spoken."""

import io
import re
import tomllib
from collections.abc import Callable
from pathlib import Path

import pytest
from babel.messages.mofile import read_mo

from calc.design.toml_file import design, read
from calc.locale import FOLDER, LANGUAGES, Language, language
from calc.locale.language import PLACE, WORD, said
from calc.sheet.text import Text
from calc.solve import solve
from tests.conftest import each_shipped
from tests.languages.texts import (
    ROOT,
    before_release,
    compiled,
    entries,
    judge_english,
    named,
    of_catalogues,
    of_inputs,
    of_results,
    of_tables,
    po,
    templates,
    untranslated,
)

OTHERS = [code for code in LANGUAGES if code != "en"]
# words by which English is known; none of them is a word of Italian, a name or a symbol
ENGLISH = re.compile(
    r"\b(the|of|with|from|and|is|are|for|which|that|by|at|to|than|its|it|not|this|or|as|on|an|has|have|was)\b"
)
# keys and choices of the file; two authors
QUOTED = re.compile(r'"[^"]*"|\b\w+-\w+\b|“[^”]*”|`[^`]*`|\b[A-Z]\w+,? (and|&) [A-Z]\w+')


# --- the files
@pytest.mark.parametrize("code", OTHERS)
def test_what_has_no_translation_is_listed_and_stops_a_release(code: str) -> None:
    """English is enough for a trial; CONTRIBUTING, "Release"."""
    if missing := untranslated(code):
        texts = "; ".join(f"{file}: {template!r}" for template, file in missing.items())
        before_release(f"{len(missing)} without a translation; `python -m tests.languages.texts {code}` adds: {texts}")


@pytest.mark.parametrize("code", OTHERS)
def test_entries_of_templates_that_are_gone_are_listed_and_stop_a_release(code: str) -> None:
    if gone := entries(code).keys() - templates().keys() - {(text, "") for text in of_tables()}:
        texts = "; ".join(many for many, _ in sorted(gone))
        before_release(f"{len(gone)} of no text any more; `python -m tests.languages.texts {code}` drops: {texts}")


@pytest.mark.parametrize("code", OTHERS)
def test_entries_keep_the_parts(code: str) -> None:
    for (many, one), told in entries(code).items():
        if not all(told):  # not translated yet
            continue
        for text, translation in zip((one, many) if one else (many,), told):
            assert set(PLACE.findall(translation)) <= set(PLACE.findall(many)), text
            assert one or set(PLACE.findall(text)) == set(PLACE.findall(translation)), text
            assert (text[0] == " ", text[-1] == " ") == (translation[0] == " ", translation[-1] == " "), text


@pytest.mark.parametrize("code", OTHERS)
def test_the_compiled_catalogue_is_that_of_the_file(code: str) -> None:
    with po(code).with_suffix(".mo").open("rb") as file:
        known = read_mo(file)
    told, expected = ([(m.id, m.string) for m in file if m.id] for file in (known, read_mo(io.BytesIO(compiled(code)))))
    assert told == expected and known.num_plurals == 2, f"`python -m tests.languages.texts {code}` compiles it"


def test_the_catalogues_are_installed_with_the_program() -> None:
    """A file that is no Python is only in a package where its ending is listed."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    listed = project["tool"]["setuptools"]["package-data"]["*"]
    assert all(
        any(file.match(pattern) for pattern in listed)
        for code in OTHERS
        for file in (FOLDER / code / "LC_MESSAGES").iterdir()
    )


# --- what is shown
LONG = ("r753ie4_beta", "r753ie4_drive", "r753ie4_gamma", "r753ie4_sized")


@pytest.mark.parametrize("code", OTHERS)
@pytest.mark.parametrize("file", each_shipped(*LONG, "l61"))
def test_no_english_word_is_left_in_what_a_design_gives(file: Path, code: str) -> None:
    say, names = (
        language(code),
        re.compile("|".join(map(re.escape, sorted(named(tomllib.loads(file.read_text(encoding="utf-8"))))))),
    )
    told = {say(text) for text in of_results(solve(design(read(file))))}
    judge_english(code, (text for text in told if ENGLISH.search(QUOTED.sub("", names.sub("", text)))))


@pytest.mark.parametrize("code", OTHERS)
def test_no_english_word_is_left_in_the_forms(code: str) -> None:
    say = language(code)
    judge_english(code, {told for text in of_inputs() if ENGLISH.search(QUOTED.sub("", told := say(text)))})


def test_the_tables_have_texts_to_translate() -> None:
    assert len({text for text in of_catalogues() if WORD.search(PLACE.sub("", text.template))}) > 50


def test_only_words_change() -> None:
    """Numbers, ids, verdicts and curves of an outcome are those of the original."""
    results = solve(design(read(ROOT / "designs" / "r753ie4_gamma.toml")))
    for outcome in results.outcomes.values():
        whole = outcome.whole
        told = said(whole, language("it"))
        assert [(c.id, c.value, c.limit, c.verdict) for c in told.checks] == [
            (c.id, c.value, c.limit, c.verdict) for c in whole.checks
        ]
        assert all(a.value is b.value for a, b in zip(told.lines, whole.lines))
        assert [c.id for c in told.curves] == [c.id for c in whole.curves]
        assert all(s.y is t.y for a, b in zip(told.curves, whole.curves) for s, t in zip(a.series, b.series))
        assert said(whole, language("en")) is whole


def test_a_template_without_translation_shows_whole_in_english(catalogue: Callable[..., Language]) -> None:
    say = catalogue({"front": "anteriore", "Film, {place}": "Meato, {place}"})
    assert say(Text("Film, {place}", place=Text("front"))) == "Meato, anteriore"
    assert say(Text("Load, {place}", place=Text("front"))) == "Load, front"
    assert say.missing == {"Load, {place}"}


def test_what_is_no_word_needs_no_entry() -> None:
    assert not any(WORD.search(symbol) for symbol in ("F_tw", "T_oil", "[P_f(1.05·F)]", "K_Hβ", "Re p"))
    assert WORD.search("c_1 of it") and WORD.search("gas")
