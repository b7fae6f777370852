# SPDX-License-Identifier: Apache-2.0
"""Words that the search for bearings uses over and over."""

from ...sheet.check import Check
from ...sheet.text import Amount, Small, Text
from ...sheet.units import Metre
from ..inputs import IN_WORDS as PLACE
from ..inputs import PLACES

__all__ = ["LETTER", "PLACE", "PLACES", "against", "mm", "short_mm", "size", "value_of"]

LETTER = {"front": Text("F"), "rear": Text("R")}


def mm(length: Metre) -> Amount:
    """A length to a hundredth of a millimetre."""
    return Amount(round(length * 1e3, 2), "mm")


def short_mm(length: Metre) -> Amount:
    """The same without its unit."""
    return Amount(round(length * 1e3, 2))


def value_of(check: Check, digits: int = 4) -> Text:
    if check.value != check.value:
        return Text("no film")
    return Text("{value}", value=Amount(check.value, check.unit, digits=digits))


def against(check: Check) -> Text:
    """`film at the edge, front: 8.2 µm, needs ≥ 9 µm`."""
    return Text("{check}: {value}, needs {limit}", check=Small(check.name), value=value_of(check), limit=check.limit_text())


def size(length: Metre, clearance: Metre) -> Text:
    return Text("{length} and {clearance}", length=Amount(length * 1e3, "mm"), clearance=Amount(clearance * 1e6, "µm"))
