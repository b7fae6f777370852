# SPDX-License-Identifier: Apache-2.0
"""A language: it gives a text, or all that a step gave, in its own words, and writes numbers in its own way."""

import re
from dataclasses import fields
from functools import cache
from gettext import translation
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar, cast

from ..sheet.check import Check
from ..sheet.curve import MeasuredPoints
from ..sheet.deferred import Later
from ..sheet.in_ascii import in_ascii
from ..sheet.quantity import Quantity
from ..sheet.record import replace
from ..sheet.step import Curve, DrawnLoad, Erratum, Outcome, Series, Table, Turning
from ..sheet.text import Amount, Name, Part, Small, Text, english, with_unit

if TYPE_CHECKING:
    from gettext import NullTranslations


LANGUAGES = {"en": "English", "it": "italiano"}
FOLDER = Path(__file__).resolve().parent
DOMAIN = "contralbero"
PLACE = re.compile(r"\{\w+\}")  # where a template has a part
WORD = re.compile(r"(?<!\w)(?:[A-Za-z]?[a-z]{2,}|[A-Z]{4,})")  # of a language; a symbol has none
NUMERAL = re.compile(r"(?<![\w.])(\d+)(?:\.(\d+))?(?![\w.])")
THIN = "\u2009"  # between thousands, ISO 80000-1
NO_NUMBER = Text("no value")


class Language:
    """English is the language without a catalogue.  `missing`: templates that were asked for and are not in the
    catalogue."""

    def __init__(self, code: str, catalogue: "NullTranslations | None" = None) -> None:
        self.code = code
        self.missing: set[str] = set()
        self._catalogue = catalogue

    @property
    def original(self) -> bool:
        """Whether a text is said as it stands in the code."""
        return self._catalogue is None

    @property
    def decimal(self) -> str:
        """The decimal sign."""
        return "." if self._catalogue is None else ","

    def __call__(self, text: str) -> str:
        """A Text in this language; any other string is a name and stays as it stands."""
        if self._catalogue is None or not isinstance(text, Text):
            return text
        template = self._template(text)
        if template is None:
            return str(text)
        parts = {name: self.part(part) for name, part in text.parts.items()}
        words = template.format_map(parts) if parts else template
        return words[:1].lower() + words[1:] if isinstance(text, Small) else words

    def halves(self, text: Text) -> tuple[str, str]:
        """A Text in front of and behind the first comma of its template ("front bearing", "twice the load"); names keep
        their commas."""
        template = self._template(text) if self._catalogue is not None else text.template
        front, _, behind = (text.template if template is None else template).partition(", ")
        parts = {name: self.part(part) for name, part in text.parts.items()}
        return front.format_map(parts), behind.format_map(parts)

    def part(self, part: Part) -> str:
        """What stands in a place of a template."""
        if isinstance(part, str):
            return self(part)
        if isinstance(part, Amount):
            return with_unit(self.number(part.written()), part.unit)
        return self.number(english(part))

    def number(self, written: str) -> str:
        """A number that is written in English (`short`), as this language writes it: decimal comma, thin spaces between
        thousands."""
        if self._catalogue is None:
            return written
        return self(NO_NUMBER) if written == NO_NUMBER else NUMERAL.sub(_numeral, written)

    def _template(self, text: Text) -> str | None:
        """The template in this language; None where the catalogue lacks it.  One without words of its own is the same
        everywhere."""
        assert self._catalogue is not None
        template = text.template
        if text.one:
            count = round(text.number) if text.number == round(text.number) else 2
            translated = self._catalogue.ngettext(text.one, template, count)
            # one's plural may be spelt as English spells the other
            known = translated is not text.one and translated is not template
        else:
            translated = self._catalogue.gettext(template) if template else template
            known = translated is not template  # gettext hands back what it does not know
        if known or not WORD.search(PLACE.sub("", template)):
            return translated
        self.missing.add(template)
        return None


class AsciiLanguage(Language):
    """A language in the letters of ASCII: its texts, and names too."""

    original = False

    def __call__(self, text: str) -> str:
        return in_ascii(super().__call__(text))

    def halves(self, text: Text) -> tuple[str, str]:
        front, behind = super().halves(text)
        return in_ascii(front), in_ascii(behind)

    def part(self, part: Part) -> str:
        return in_ascii(super().part(part))

    def number(self, written: str) -> str:
        return in_ascii(super().number(written))


def _numeral(match: re.Match[str]) -> str:
    whole, decimals = match[1], match[2]
    if len(whole) > 4:
        whole = THIN.join([whole[: len(whole) % 3], *re.findall("...", whole[len(whole) % 3 :])]).lstrip(THIN)
    return f"{whole},{decimals}" if decimals else whole


@cache
def language(code: str, ascii: bool = False) -> Language:
    """A language by its code; `ascii`: for a terminal without other letters.  Raises KeyError where there is none."""
    if code not in LANGUAGES:
        raise KeyError(code)
    kind = AsciiLanguage if ascii else Language
    return kind(code) if code == "en" else kind(code, translation(DOMAIN, FOLDER, [code]))


# --- what a step gave, with its texts in another language
# Numbers, ids, symbols and names are those of the original.
#
# The lines of the calculation stay the same objects, since the links of its numbers lead to them: whoever shows a line
# says its texts.

T = TypeVar("T")
SPOKEN = frozenset(
    {Quantity, Curve, Erratum, DrawnLoad, MeasuredPoints, Series, Table, Turning}
)  # records that hold texts


def said(outcome: Outcome[object], say: Language) -> Outcome[object]:
    """The outcome in a language.  What is made only when it is asked for (`further`) is left out: pass
    `outcome.whole`."""
    if say.original:
        return outcome
    left = ("result", "lines", "key_curves")
    spoken = {f.name: in_language(getattr(outcome, f.name), say) for f in fields(Outcome) if f.name not in left}
    key_curves = Later(lambda: in_language(tuple(outcome.key_curves), say))
    return replace(outcome, **spoken | {"further": None}, key_curves=key_curves)


def in_language(thing: T, say: Language) -> T:
    """A text, a tuple, or a record of the sheet, with every Text in it said; anything else as it is."""
    if say.original:
        return thing
    return cast(T, _said(thing, say))


def _said(thing: object, say: Language) -> object:
    kind: type = type(thing)
    if isinstance(thing, Text):
        return Name(say(thing))
    if type(thing) is tuple or type(thing) is Later:
        return tuple([_said(part, say) for part in thing])
    if type(thing) is Check:
        name, source, advice = (in_language(text, say) for text in (thing.name, thing.source, thing.advice))
        return replace(thing, name=name, source=source, advice=advice)
    if kind in SPOKEN:
        return kind(**{name: _said(getattr(thing, name), say) for name in _names(kind)})
    return thing


@cache
def _names(kind: type) -> tuple[str, ...]:
    return tuple(f.name for f in fields(kind))
