# SPDX-License-Identifier: Apache-2.0
"""A language: called with an English text of the program, it gives that text in its own words."""

import json
import re
from collections import Counter, defaultdict
from functools import cache
from pathlib import Path

LANGUAGES = {"en": "English", "it": "italiano"}
FOLDER = Path(__file__).resolve().parent
PLACE = re.compile(r"\{(\d+)\}")  # where an f-string puts something in
WORD = re.compile(r"[^\W\d_]{2,}")
JOINTS = tuple(map(re.compile, (r"((?<=[.;:]) )", r"((?<=,) )", r"( ?[()])", r"( and | or )")))  # where texts may have been put together
KNOWN = 20_000  # texts that are remembered


class Language:
    """`texts`: English text or template → translation; nothing for English itself.  What is not known stays English."""

    def __init__(self, code: str, texts: dict[str, str]) -> None:
        self.code = code
        self._known = {text: made for text, made in texts.items() if not PLACE.search(text)}
        self._said: dict[str, str] = {}
        self._compiled: dict[str, re.Pattern[str]] = {}
        self._by_word = _by_rarest_word(template for template in texts if PLACE.search(template))
        self._templates = {template: made for template, made in texts.items() if PLACE.search(template)}

    def __call__(self, text: str) -> str:
        if not self._known or not text:
            return text
        said = self._said.get(text)
        if said is None:
            if len(self._said) >= KNOWN:
                self._said.clear()
            said = self._said[text] = self._whole(text) or self._parts(text)
        return said

    def knows(self, text: str) -> bool:
        """Whether a text, or a template as it stands in the source, has a translation."""
        return not self._known or text in self._known or text in self._templates

    def _whole(self, text: str) -> str | None:
        """A text of the catalogue, or one made from a template of it."""
        bare = text.strip()
        if (known := self._known.get(text) or self._known.get(bare)) is not None:
            return known if text in self._known else text.replace(bare, known.strip(), 1)
        if (found := self._template(text)) is None:
            return None
        template, fillers = found
        given: dict[str, str] = {}
        for number, filler in zip(PLACE.findall(template), fillers):
            given.setdefault(number, self(filler))
        return PLACE.sub(lambda place: given[place[1]], self._templates[template])

    def _template(self, text: str) -> tuple[str, tuple[str, ...]] | None:
        """The template with the most words of its own that this text can have been made from, and what was put in."""
        words = set(WORD.findall(text))
        candidates = {template for word in words for template in self._by_word.get(word, ())}
        for template in sorted(candidates, key=lambda t: (-len(PLACE.sub("", t)), t)):
            if (match := self._pattern(template).fullmatch(text)) is not None:
                return template, match.groups()
        return None

    def _pattern(self, template: str) -> re.Pattern[str]:
        if (made := self._compiled.get(template)) is None:
            literal = [re.escape(part) for part in PLACE.split(template)[::2]]
            made = self._compiled[template] = re.compile("(.*?)".join(literal), re.DOTALL)
        return made

    def _parts(self, text: str) -> str:
        """A text that was put together of others: each of them as far as it is known."""
        for joint in JOINTS:
            parts = joint.split(text)
            if len(parts) > 1:  # every second one is what joins them
                made = [self._known.get(part, part) if n % 2 else self(part) for n, part in enumerate(parts)]
                if made[::2] != parts[::2]:
                    return "".join(made)
        if text[-1] in ".,;:" and (made_ := self(text[:-1])) != text[:-1]:
            return made_ + text[-1]
        return text


def _by_rarest_word(templates: object) -> dict[str, list[str]]:
    """Each template under the word of its own that the fewest others have: a text is only held against those whose word it has."""
    words = {template: WORD.findall(PLACE.sub(" ", template)) for template in templates}  # type: ignore[attr-defined]
    often = Counter(word for own in words.values() for word in set(own))
    found: dict[str, list[str]] = defaultdict(list)
    for template, own in words.items():
        if own:
            found[min(own, key=lambda word: (often[word], word))].append(template)
    return found


@cache
def language(code: str) -> Language:
    """A language by its code.  Raises KeyError where there is none."""
    if code not in LANGUAGES:
        raise KeyError(code)
    texts: dict[str, str] = {}
    for file in sorted((FOLDER / code).glob("*.json")):
        texts |= json.loads(file.read_text(encoding="utf-8"))
    return Language(code, texts)
