# SPDX-License-Identifier: Apache-2.0
"""What every kind of bearing has: a word, a row, a room; and no key that rows of other kinds seem to have too."""

from collections.abc import Iterable
from typing import get_type_hints

import pytest

from calc.bearings.kinds import KINDS
from calc.bearings.row import SupportRow
from calc.bearings.support import Kind
from calc.countershaft.rows import KIND, ROWS, BearingRow
from calc.sheet.quantity import Where, keys


def words_of(where: Where | None) -> Iterable[str]:
    """The kinds that an input is of, at the end of its way; none: of all."""
    if where is None:
        return ()
    if where.choice.name == KIND.attribute:
        return where.words
    return words_of(where.choice.metadata["quantity"].where)


def test_every_word_has_a_row_and_a_room() -> None:
    assert set(KIND.about.choices) == set(ROWS) == set(KINDS)
    assert all(isinstance(kind, Kind) for kind in KINDS.values())
    assert all(issubclass(BearingRow, row) for row in ROWS.values())


@pytest.mark.parametrize("word", ROWS)
def test_what_a_row_of_one_kind_has_says_of_which_kind_it_is(word: str) -> None:
    shared, own = set(keys(SupportRow)), keys(ROWS[word])
    assert get_type_hints(ROWS[word])
    for key in own.keys() - shared:
        assert word in words_of(own[key].about.where), key


@pytest.mark.parametrize("word", ROWS)
def test_a_row_without_a_size_has_no_place_and_names_its_keys(word: str) -> None:
    row = BearingRow(name="front", position=0.0, kind=word)
    assert row.on_shaft is None and not row.sized
    assert row.size_keys() and set(row.size_keys()) <= set(keys(BearingRow))


def test_a_word_that_is_none_knows_no_size() -> None:
    assert not BearingRow(name="front", position=0.0, kind="magnetic").sized
