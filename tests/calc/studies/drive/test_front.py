# SPDX-License-Identifier: Apache-2.0
"""Fronts against what the definition says, row by row."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from calc.studies.drive.front import front, knee, lower_left, representatives

ROWS = st.integers(0, 60).flatmap(
    lambda n: st.integers(1, 4).flatmap(lambda k: arrays(np.int64, (n, k), elements=st.integers(0, 6)))
)


@given(ROWS)
def test_the_front_is_what_no_other_row_beats(rows):
    rows = rows.astype(float)
    places = front(rows)
    beaten = {
        i
        for i in range(len(rows))
        for j in range(len(rows))
        if (rows[j] <= rows[i]).all() and ((rows[j] < rows[i]).any() or (j < i and (rows[j] == rows[i]).all()))
    }
    assert set(places.tolist()) == set(range(len(rows))) - beaten and list(places) == sorted(places)


def test_a_front_longer_than_a_block():
    x = np.arange(2000.0)
    rows = np.stack([x, -x, np.zeros(2000)], 1)
    assert len(front(np.concatenate([rows, rows + 0.5]))) == 2000


@given(ROWS)
def test_two_objectives_are_the_same_front(rows):
    if rows.shape[1] < 2 or not len(rows):
        return
    x, y = rows[:, 0].astype(float), rows[:, 1].astype(float)
    kept = rows[lower_left(x, y)][:, :2]
    assert {tuple(r) for r in kept.tolist()} == {
        tuple(r) for r in rows[front(rows[:, :2].astype(float))][:, :2].tolist()
    }


def test_representatives_have_the_best_of_everything_and_leave_no_row_alone():
    rng = np.random.default_rng(1)
    rows = rng.random((500, 3))
    rows = rows[front(rows)]
    chosen = representatives(rows, np.full(3, 0.1), 20)
    assert len(set(chosen)) == 20 and set(rows.argmin(0).tolist()) <= set(chosen) and knee(rows) in chosen
    lacks = np.array([(rows[chosen] - row).max(1).min() for row in rows])  # additive ε to the nearest of them
    random = rng.permutation(len(rows))[:20]
    assert lacks.max() < np.array([(rows[random] - row).max(1).min() for row in rows]).max()
    assert representatives(rows[:0], np.full(3, 0.1), 5) == []
