# SPDX-License-Identifier: Apache-2.0
"""How a language says a text: by its template, with the parts put in."""

from collections.abc import Callable

import pytest

from assistant import usage
from calc.locale import LANGUAGES, Language, language
from calc.sheet.number import short
from calc.sheet.text import Amount, Name, Text, listed, plural
from tests.languages.texts import po

Catalogue = Callable[..., Language]


@pytest.fixture
def say(catalogue: Catalogue) -> Language:
    return catalogue(
        {
            "Film at the edge": "Meato al bordo",
            "front": "anteriore",
            "{what}, {place}": "{what}, {place}",
            "oil": "olio",
            "Wheel {wheel}: {what} is missing": "Ruota {wheel}: manca {what}",
            "{before} and {last}": "{before} e {last}",
            "Take {less} off {wheel}.": "Togliere {less} a {wheel}.",
            "no value": "nessun valore",
            ("{n} warning", "{n} warnings"): ("{n} avviso", "{n} avvisi"),
        }
    )


def test_a_text_is_said_by_its_template(say: Language) -> None:
    assert say(Text("Film at the edge")) == "Meato al bordo"
    assert (
        say(Text("{what}, {place}", what=Text("Film at the edge"), place=Text("front"))) == "Meato al bordo, anteriore"
    )
    assert say(Text("Wheel {wheel}: {what} is missing", wheel="idler", what=Text("oil"))) == "Ruota idler: manca olio"


def test_names_are_never_said(say: Language) -> None:
    """A wheel may be called like a word of the vocabulary."""
    assert say(Text("Wheel {wheel}: {what} is missing", wheel="front", what=Text("oil"))) == "Ruota front: manca olio"
    assert say("front") == "front" and say(Name("front")) == "front"
    assert say(listed(["front", Text("front"), "oil"])) == "front, anteriore e oil"


def test_texts_stay_data_when_they_are_joined(say: Language) -> None:
    joined = Text("Film at the edge") + ", " + Text("front")
    assert joined == "Film at the edge, front" and say(joined) == "Meato al bordo, anteriore"
    assert say("− " + Text("oil")) == "− olio"
    assert say(Text("; ").join([Text("oil"), "oil", Text("front")])) == "olio; oil; anteriore"


@pytest.mark.parametrize(
    "n, english, italian",
    [(1, "1 warning", "1 avviso"), (43, "43 warnings", "43 avvisi"), (0, "0 warnings", "0 avvisi")],
)
def test_plurals(say: Language, n: int, english: str, italian: str) -> None:
    text = plural("{n} warning", "{n} warnings", n=n)
    assert text == english and say(text) == italian


@pytest.mark.parametrize(
    "amount, english, italian",
    [
        (Amount(0.25, "mrad"), "0.25 mrad", "0,25 mrad"),
        (Amount(240.0, "°"), "240°", "240°"),
        (Amount(-7.5, "°"), "−7.5°", "−7,5°"),
        (Amount(57293.0, "N"), "57290 N", "57\u2009290 N"),
        (Amount(1234567.0, digits=7), "1.234567·10⁶", "1,234567·10⁶"),
        (Amount(6.2e-3, "mm"), "6.2·10⁻³ mm", "6,2·10⁻³ mm"),
        (Amount(12345.678, "W", form=".2f"), "12345.68 W", "12\u2009345,68 W"),
        (Amount(float("nan"), "W"), "no value W", "nessun valore W"),
    ],
)
def test_numbers_are_written_by_the_language(say: Language, amount: Amount, english: str, italian: str) -> None:
    assert Text("Take {less} off {wheel}.", less=amount, wheel="a") == f"Take {english} off a."
    assert say(Text("Take {less} off {wheel}.", less=amount, wheel="a")) == f"Togliere {italian} a a."


def test_plain_numbers_among_the_parts(say: Language) -> None:
    assert say(Text("Take {less} off {wheel}.", less=0.5, wheel=-3)) == "Togliere 0,5 a −3."
    assert say.number(short(98765.4)) == "98\u2009770" and language("en").number(short(98765.4)) == "98770"


def test_english_is_what_it_was() -> None:
    assert language("en")(Text("Film at the edge, {place}", place="front")) == "Film at the edge, front"
    with pytest.raises(KeyError):
        language("tlh")


def test_the_command_line_offers_the_languages_that_there_are():
    assert usage.LANGUAGES == tuple(LANGUAGES)
    assert all(code == "en" or po(code).exists() for code in LANGUAGES)
