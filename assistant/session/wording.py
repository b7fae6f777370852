# SPDX-License-Identifier: Apache-2.0
"""Sentences that name keys of the design file, as the form calls them: who fills in fields need not know the file."""

import re
from collections.abc import Sequence
from functools import cache
from itertools import pairwise

from calc.design.model import Design
from calc.locale import Language
from calc.sheet.quantity import Quantity, keys
from calc.sheet.text import Small

# [[shafts.sections]], [engine.gas], transverse_module_mm, shafts.bearings
KEY = re.compile(r"\[{1,2}([a-z_]+(?:\.[a-z_]+)*)\]{1,2}|\b([a-z]+(?:_[A-Za-z0-9]+)+)\b")


@cache
def described_keys() -> dict[str, Quantity]:
    """Every key of a design by its last part; of several of one name the first."""
    known: dict[str, Quantity] = {}
    seen: set[type] = set()

    def walk(inputs: type) -> None:
        if inputs in seen:
            return
        seen.add(inputs)
        below = []
        for key in keys(inputs).values():
            known.setdefault(key.key, key.about)
            below += [key.about.table] if key.about.table is not None else []
        for table in below:
            walk(table)

    walk(Design)
    return known


def worded(sentence: str, say: Language) -> str:
    """A sentence with labels where it has keys; what is no key of a design stays."""

    def label(found: re.Match[str]) -> str:
        name = (found[1] or found[2]).rpartition(".")[2]
        about = described_keys().get(name)
        return found[0] if about is None else say(Small(about.label))

    return KEY.sub(label, sentence)


def words_shared(text: str, before: str) -> int:
    """With how many words a text begins as the one before it does."""
    pairs = enumerate(zip(text.split(" "), before.split(" ")))
    return next((n for n, (word, old) in pairs if word != old), 0)


def not_repeated(changes: Sequence[str]) -> list[str]:
    """`span allowance of central 2 → 3 µm`, `idler 4 → 5 µm`: of each the words with which the one before it began are
    left out, up to what tells them apart."""
    shorter = list(changes[:1])
    for before, change in pairwise(changes):
        told = " ".join(change.split(" ")[words_shared(change, before) :])
        shorter.append(told if told[:1].isalpha() else change)
    return shorter


SENTENCE = re.compile(r"(?<=[^\s.]{3}\.)\s+")  # behind a full stop that ends no abbreviation


def sentences(text: str) -> list[str]:
    """A text by its sentences, so that what has no room goes as a whole."""
    return SENTENCE.split(text) if text else []
