# SPDX-License-Identifier: Apache-2.0
"""A language: called with an English text of the program, it gives that text in its own words."""

import json
import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator
from functools import cache
from itertools import count
from pathlib import Path
from threading import RLock
from typing import NamedTuple

from ..sheet.units import UNITS

LANGUAGES = {"en": "English", "it": "italiano"}
FOLDER = Path(__file__).resolve().parent
PLACE = re.compile(r"\{(\w*)\}")  # where an f-string, or format(), puts something in
WORD = re.compile(r"[^\W\d_]{2,}")
NUMBER = re.compile(r"[-−+±]?\d\S* ")
SMALL = re.compile(r"[^\W\d_A-Z]{2,}")  # what has no small letters is a name, a symbol or a sign: EN AC-43100
EDGES = " .,;:"  # what may stand before or behind a text that was put together with others
# where texts may have been put together, the coarse joints first
JOINTS = tuple(map(re.compile, (r"((?<=[.!?]) )", r"((?<=[;:]) )", r"((?<=,) )", r"( ?[()])", r"( and | or | by | at )")))
WEAK = 6  # letters of a template that say little: "{0} of {1}"
HEAD = re.compile(r"[^\W\d_]{3,}: ")  # a template that begins so says enough: "Saved: {0}"
KNOWN = 20_000  # texts that are remembered


class Said(NamedTuple):
    """A text in the language.  `whole`: no word of it has stayed English, as far as that can be told."""

    text: str
    whole: bool


class Language:
    """`texts`: English text or template → translation; nothing for English itself.  What is not known stays English."""

    def __init__(self, code: str, texts: dict[str, str]) -> None:
        self.code = code
        self._texts = texts
        self._known = {text: made for text, made in texts.items() if not PLACE.search(text)}
        self._known |= {text.strip(EDGES): made.strip(EDGES) for text, made in self._known.items() if text.strip(EDGES) not in self._known}
        templates = {_numbered(text): _numbered(made) for text, made in texts.items() if PLACE.search(text)}
        self._templates = {text.strip(EDGES): made.strip(EDGES) for text, made in templates.items()} | templates
        self._by_word = _by_rarest_word(self._templates)
        self._compiled: dict[str, re.Pattern[str]] = {}
        self._said: dict[str, Said] = {}
        self._saying = RLock()  # the mark of a text that is just being said is for its own thread only

    def __call__(self, text: str) -> str:
        if not self._texts:
            return text
        with self._saying:
            return self._say(text).text

    def wholly(self, text: str) -> str:
        """The translation where no word stays English, else the text as it is: for what a user or a book has said."""
        if not self._texts:
            return text
        with self._saying:
            said = self._say(text)
        return said.text if said.whole else text

    def knows(self, text: str) -> bool:
        """Whether a text, or a template as it stands in the source, has a translation."""
        return not self._texts or text in self._texts

    def _say(self, text: str) -> Said:
        said = self._said.get(text)
        if said is None:
            if len(self._said) >= KNOWN:
                self._said.clear()
            self._said[text] = Said(text, False)  # a template may lead back to its own text
            said = self._said[text] = self._found(text)
        return said

    def _found(self, text: str) -> Said:
        """The first way to say it by which nothing stays English, else the first by which something changes."""
        if (known := self._known.get(text)) is not None:
            return Said(known, True)
        if not WORD.search(text) or not SMALL.search(text) or NUMBER.sub("", text, count=1) in UNITS:
            return Said(text, True)
        first: Said | None = None
        for said in self._ways(text):
            if said.whole:
                return said
            if first is None and said.text != text:
                first = said
        return first or Said(text, " " not in text.strip())  # a single word may be a name

    def _ways(self, text: str) -> Iterator[Said]:
        matches = self._matches(text)
        yield from (self._filled(*match) for match in matches if self._strong(*match))
        if (core := text.strip(EDGES)) != text and core:
            said = self._say(core)
            start = text.index(core)
            yield Said(text[:start] + said.text + text[start + len(core) :], said.whole)
        for joint in JOINTS:
            parts = joint.split(text)  # every second one is what joins them
            if len(parts) > 1:
                made = list(self._pieces(parts))
                yield Said("".join(said.text for said in made), all(said.whole for said in made))
        yield from (self._filled(*match) for match in matches if not self._strong(*match))

    def _pieces(self, parts: list[str]) -> Iterator[Said]:
        """Parts that were joined: as many at a time as are one text of the program, else one by one."""
        start = 0
        while start < len(parts):
            for end in range(len(parts), start, -2):
                if end - start < len(parts) and (said := self._exactly("".join(parts[start:end]))) is not None:
                    break
            else:
                end, said = start + 1, self._say(parts[start])
            yield said
            yield from (Said(self._joint(part), True) for part in parts[end : end + 1])
            start = end + 1

    def _joint(self, text: str) -> str:
        """What stands between two parts: a mark, or a word like “and”."""
        word = text.strip()
        return text.replace(word, self._known.get(word, word), 1) if word else text

    def _strong(self, template: str, fillers: tuple[str, ...]) -> bool:
        """Whether a template says enough not to be met by chance; a short one does where only numbers or known words were put in."""
        return (
            _letters(template) > WEAK
            or HEAD.match(template) is not None
            or all(not WORD.search(filler) or filler.strip() in self._known for filler in fillers)
        )

    def _exactly(self, text: str) -> Said | None:
        """What is one text of the program, known or made from a template."""
        core = text.strip(EDGES)
        found = self._known.get(text) or self._known.get(core)
        if found is not None:
            return Said(text.replace(core, found.strip(EDGES), 1), True)
        made = (self._filled(*match) for match in self._matches(core) if self._strong(*match))
        whole = next((said for said in made if said.whole), None) if core else None
        return Said(text.replace(core, whole.text.strip(EDGES), 1), True) if whole is not None else None

    def _matches(self, text: str) -> list[tuple[str, tuple[str, ...]]]:
        """The templates that this text can have been made from, those that say most first, and what was put in."""
        found = []
        for template in {template for word in set(WORD.findall(text)) for template in self._by_word.get(word, ())}:
            if (match := self._pattern(template).fullmatch(text)) is not None:
                found.append((template, match.groups()))
        return sorted(found, key=lambda match: (-_letters(match[0]), match[0]))  # a set has another order in each run

    def _filled(self, template: str, fillers: tuple[str, ...]) -> Said:
        """The translation of a template, with what was put in said as well."""
        given = {name: self._say(filler) for name, filler in zip(PLACE.findall(template), fillers)}
        return Said(PLACE.sub(lambda place: given[place[1]].text, self._templates[template]), all(said.whole for said in given.values()))

    def _pattern(self, template: str) -> re.Pattern[str]:
        if (made := self._compiled.get(template)) is None:
            literal = [re.escape(part) for part in PLACE.split(template)[::2]]
            made = self._compiled[template] = re.compile("(.*?)".join(literal), re.DOTALL)
        return made


def _numbered(template: str) -> str:
    """The same template with a number in each empty place, as format() counts them."""
    numbers = count()
    return PLACE.sub(lambda place: place[0] if place[1] else f"{{{next(numbers)}}}", template)


def _letters(template: str) -> int:
    """How much a template says of its own."""
    return sum(map(len, WORD.findall(PLACE.sub(" ", template))))


def _by_rarest_word(templates: Iterable[str]) -> dict[str, list[str]]:
    """Each template under the word of its own that the fewest others have: a text is only held against those whose word it has."""
    words = {template: WORD.findall(PLACE.sub(" ", template)) for template in templates}
    often = Counter(word for own in words.values() for word in set(own))
    found: dict[str, list[str]] = defaultdict(list)
    for template, own in words.items():
        if own:
            found[min(own, key=lambda word: (often[word], word))].append(template)
    return found


@cache
def language(code: str) -> Language:
    """A language by its code.  Raises KeyError where there is none."""
    return afresh(code)


def afresh(code: str) -> Language:
    """A language that has said nothing yet: what it says does not depend on what was said before."""
    if code not in LANGUAGES:
        raise KeyError(code)
    texts: dict[str, str] = {}
    for file in sorted((FOLDER / code).glob("*.json")):
        texts |= json.loads(file.read_text(encoding="utf-8"))
    return Language(code, texts)
