# SPDX-License-Identifier: Apache-2.0
"""What a step gave, with its texts in another language.  Numbers, ids, symbols and names are those of the original.

The lines of the calculation stay the same objects, since the links of its numbers lead to them: whoever shows a line says its texts.
"""

from dataclasses import fields, replace
from functools import cache
from typing import TypeVar, cast

from ..sheet.check import Check
from ..sheet.later import Later
from ..sheet.quantity import Quantity
from ..sheet.step import Curve, Erratum, Load, Outcome, Series, Table, Turning
from ..sheet.text import Name, Text
from ..locale.language import Language

T = TypeVar("T")
SPOKEN = frozenset({Quantity, Curve, Erratum, Load, Series, Table, Turning})  # records that hold texts


def said(outcome: Outcome[object], say: Language) -> Outcome[object]:
    """The outcome in a language.  What is made only when it is asked for (`further`) is left out: pass `outcome.whole`."""
    if say.code == "en":
        return outcome
    left = ("result", "lines", "key_curves")
    spoken = {f.name: in_language(getattr(outcome, f.name), say) for f in fields(Outcome) if f.name not in left}
    return replace(outcome, **spoken | {"further": None}, key_curves=Later(lambda: in_language(tuple(outcome.key_curves), say)))


def in_language(thing: T, say: Language) -> T:
    """A text, a tuple, or a record of the sheet, with every Text in it said; anything else as it is."""
    if say.code == "en":
        return thing
    return cast(T, _said(thing, say))


def _said(thing: object, say: Language) -> object:
    kind: type = type(thing)
    if isinstance(thing, Text):
        return Name(say(thing))
    if type(thing) is tuple or type(thing) is Later:
        return tuple([_said(part, say) for part in thing])
    if type(thing) is Check:
        return replace(
            thing, name=in_language(thing.name, say), source=in_language(thing.source, say), advice=in_language(thing.advice, say)
        )
    if kind in SPOKEN:
        return kind(**{name: _said(getattr(thing, name), say) for name in _names(kind)})
    return thing


@cache
def _names(kind: type) -> tuple[str, ...]:
    return tuple(f.name for f in fields(kind))
