# SPDX-License-Identifier: Apache-2.0
"""A language: called with a text of the program, it gives that text in its own words and writes its numbers in its own way."""

import re
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from ..sheet.text import Amount, Part, Small, Text, english, with_unit

if TYPE_CHECKING:
    from gettext import NullTranslations

LANGUAGES = {"en": "English", "it": "italiano"}
FOLDER = Path(__file__).resolve().parent
DOMAIN = "contralbero"
PLACE = re.compile(r"\{\w+\}")  # where a template has a part
WORD = re.compile(r"(?<!\w)[A-Za-z]?[a-z]{2,}")  # of a language; a symbol has none
NUMERAL = re.compile(r"(?<![\w.])(\d+)(?:\.(\d+))?(?![\w.])")
THIN = "\u2009"  # between thousands, ISO 80000-1
NO_NUMBER = Text("no value")


class Language:
    """English is the language without a catalogue.  `missing`: templates that were asked for and are not in the catalogue."""

    def __init__(self, code: str, catalogue: "NullTranslations | None" = None) -> None:
        self.code = code
        self.missing: set[str] = set()
        self._catalogue = catalogue

    def __call__(self, text: str) -> str:
        """A Text in this language; any other string is a name and stays as it stands."""
        if self._catalogue is None or not isinstance(text, Text):
            return text
        template = self._template(text)
        if template is None:
            return str(text)
        told = template.format_map({name: self.part(part) for name, part in text.parts.items()}) if text.parts else template
        return told[:1].lower() + told[1:] if isinstance(text, Small) else told

    def halves(self, text: Text) -> tuple[str, str]:
        """A Text in front of and behind the first comma of its template ("front bearing", "twice the load"); names keep their commas."""
        template = self._template(text) if self._catalogue is not None else text.template
        front, _, behind = (text.template if template is None else template).partition(", ")
        told = {name: self.part(part) for name, part in text.parts.items()}
        return front.format_map(told), behind.format_map(told)

    def part(self, part: Part) -> str:
        """What stands in a place of a template."""
        if isinstance(part, str):
            return self(part)
        if isinstance(part, Amount):
            return with_unit(self.number(part.written()), part.unit)
        return self.number(english(part))

    def number(self, written: str) -> str:
        """A number that is written in English (`short`), as this language writes it: decimal comma, thin spaces between thousands."""
        if self._catalogue is None:
            return written
        return self(NO_NUMBER) if written == NO_NUMBER else NUMERAL.sub(_numeral, written)

    def _template(self, text: Text) -> str | None:
        """The template in this language; None where the catalogue lacks it.  One without words of its own is the same everywhere."""
        assert self._catalogue is not None
        template = text.template
        if text.one:
            told = self._catalogue.ngettext(text.one, template, round(text.number) if text.number == round(text.number) else 2)
            known = told is not text.one and told is not template  # one's plural may be spelt as English spells the other
        else:
            told = self._catalogue.gettext(template) if template else template
            known = told is not template  # gettext hands back what it does not know
        if known or not WORD.search(PLACE.sub("", template)):
            return told
        self.missing.add(template)
        return None


def _numeral(found: re.Match[str]) -> str:
    whole, decimals = found[1], found[2]
    if len(whole) > 4:
        whole = THIN.join([whole[: len(whole) % 3], *re.findall("...", whole[len(whole) % 3 :])]).lstrip(THIN)
    return f"{whole},{decimals}" if decimals else whole


@cache
def language(code: str) -> Language:
    """A language by its code.  Raises KeyError where there is none."""
    if code not in LANGUAGES:
        raise KeyError(code)
    if code == "en":
        return Language(code)
    from gettext import translation

    return Language(code, translation(DOMAIN, FOLDER, [code]))
