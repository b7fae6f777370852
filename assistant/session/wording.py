# SPDX-License-Identifier: Apache-2.0
"""Sentences that name keys of the design file, as the form calls them: who fills in fields need not know the file."""

import re
from functools import cache

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


SENTENCE = re.compile(r"(?<=[^\s.]{3}[.;])\s+")  # behind a full stop that ends no abbreviation


def sentences(text: str) -> list[str]:
    """A text by its sentences, so that what has no room goes as a whole."""
    return SENTENCE.split(text) if text else []
