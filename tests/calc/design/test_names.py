# SPDX-License-Identifier: Apache-2.0
"""What the parts of an id are called: a word for each that the program has made, the user's own name for the others."""

import re
from pathlib import Path

import pytest

from calc.design.names import belongs
from calc.design.toml_file import load
from calc.sheet.text import Name
from calc.solve import solve
from tests.conftest import each_shipped

NUMBERS = re.compile(r"\d+")  # of an element without a name
PROPER = (
    "ISO 7902",
    "DIN 31652",
    "Falz",
    "Reynolds",
    "Raimondi & Boyd",
    "Schlenk",
    "Niemann",
    "Xu, Kahraman",
    "Benedict, Kelley",
)


@pytest.mark.parametrize("path", each_shipped())
def test_a_name_is_the_user_s_or_an_author_s(path: Path) -> None:
    """Else it is a word of the program, in every language: a report in Italian has no "roll_axis" in its heads."""
    document, made = load(path)
    results = solve(made).whole()
    given = set(re.findall(r"[\w-]+", document.raw.decode())) | {"front", "rear", "ADI-800", "ADI-1050", "ADI-1200"}
    given |= {shaft.name for shaft in made.shafts}  # which an upgrade may have named
    for id in [*results.values(), *(check.id for check in results.checks())]:
        for word in belongs(id):
            if isinstance(word, Name) and not NUMBERS.fullmatch(word) and word not in PROPER:
                assert all(part in given for part in word.split("–")), (id, word)


@pytest.mark.parametrize(
    ("id", "words"),
    [
        ("mounting.static.engine.deflection", ["at rest", "engine"]),
        ("mounting.idle.torque.order_1_5", ["idle", "torque"]),
        ("mounting.critical.bounce.order_1_5.seat.half", ["critical speed", "bounce", "order 1.5", "seat"]),
        ("mounting.with_chassis.mode_12.frequency", ["engine and frame", "mode 12"]),
        ("imbalance.order_2.force_peak", ["order 2"]),
        ("countershaft.residual.order_1.force_forward", ["residual", "order 1"]),
        ("countershaft.lower.mass_moment.front", ["lower", "mass moment"]),
        ("countershaft.lower.bolts.slip", ["lower", "bolts"]),
        ("bearings.lower.front.corners.film", ["lower", "front", "corners"]),
        ("gears.crank_central.backlash_min", ["crank–central"]),
    ],
)
def test_the_words_of_an_id(id: str, words: list[str]) -> None:
    assert belongs(id) == words
