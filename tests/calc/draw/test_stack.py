"""Dimensions in rows and words on shelves: nothing covers or crosses another, for any lengths."""

from itertools import combinations, pairwise

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from calc.draw.placing import Shelf, Span, rows, shelves

H = 2.5
CHAINS = st.lists(st.floats(0.5, 60.0), min_size=1, max_size=9)


def chain(lengths):
    ends = [sum(lengths[:n]) for n in range(len(lengths) + 1)]
    spans = [Span(a, b, 3.0 + 2.0 * len(f"{b - a:.1f}")) for a, b in pairwise(ends)]
    return (
        [*spans, Span(ends[0] + lengths[0] / 2, ends[-1] - lengths[-1] / 2, 9.0), Span(0.0, ends[-1], 12.0)]
        if len(lengths) > 1
        else spans
    )


@settings(deadline=None, max_examples=80)
@given(CHAINS)
@example([12.0, 7.0, 11.0, 1.0])
def test_no_two_of_a_row_cover_each_other_and_no_number_is_crossed(lengths):
    spans = chain(lengths)
    found = rows(spans, H)
    assert [row.span for row in found] == spans
    for a, b in combinations(found, 2):
        (first, last), (start, end) = a.taken(H), b.taken(H)
        if a.level == b.level:
            assert last <= start + 1e-6 or end <= first + 1e-6
        for near, far in ((a, b), (b, a)):
            if near.level < far.level:
                assert not any(near.number[0] < x < near.number[1] for x in (far.span.start, far.span.end))
                if near.span.start >= far.span.start - 1e-9 and near.span.end <= far.span.end + 1e-9:
                    assert near.span.length <= far.span.length + 1e-9


def test_a_chain_with_room_stands_in_one_row_with_its_numbers_in_the_middle():
    found = rows([Span(0.0, 30.0, 8.0), Span(30.0, 70.0, 8.0), Span(0.0, 70.0, 8.0)], H)
    # the whole lets the middle pass
    assert [(row.level, row.shift) for row in found] == [(0, 0.0), (0, 0.0), (1, 0.0)] or found[2].shift
    assert [row.level for row in found] == [0, 0, 1]


def test_a_number_without_room_stands_beside_its_arrows():
    (row,) = rows([Span(10.0, 11.0, 6.0)], H)
    assert row.level == 0 and (row.number[0] > 11.0 or row.number[1] < 10.0)


@settings(deadline=None, max_examples=80)
@given(st.lists(st.tuples(st.floats(0.0, 150.0), st.floats(5.0, 45.0), st.booleans()), min_size=1, max_size=6))
def test_shelves_do_not_meet(asked):
    shelf = [Shelf(x + 3 * n, 10.0, wide, 8.0 if high else 4.5) for n, (x, wide, high) in enumerate(sorted(asked))]
    found = shelves(shelf, 14.0, 4.0, (-60.0, 280.0), [])
    boxes = []
    for one, (y, right) in zip(shelf, found):
        left = one.x if right else one.x - one.wide
        assert y >= 14.0 and -60.0 <= left and left + one.wide <= 280.0
        boxes.append((left, y, left + one.wide, y + one.high))
    for a, b in combinations(boxes, 2):
        assert a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1]
    for n, (one, (y, _)) in enumerate(zip(shelf, found)):
        for i, box in enumerate(boxes):
            assert i == n or not (box[0] < one.x < box[2] and one.foot < box[1] < y), "a line through words"


def test_a_shelf_goes_round_what_stands_there():
    """Above it, or outwards where it is high."""
    for top, place in ((20.0, (22.0, True)), (30.0, (14.0, False))):
        mark = (15.0, 13.0, 25.0, top)
        assert shelves([Shelf(10.0, 10.0, 30.0, 4.0)], 14.0, 4.0, (-60.0, 200.0), [mark]) == [place]


@pytest.mark.parametrize("x, right", [(10.0, True), (190.0, False)])
def test_a_shelf_looks_inwards(x, right):
    assert shelves([Shelf(x, 10.0, 30.0, 4.0)], 14.0, 4.0, (0.0, 200.0), []) == [(14.0, right)]


def test_stairs_stand_above_all_that_is_there():
    """Where there is no room at either side."""
    mark, asked = (15.0, 13.0, 25.0, 30.0), [Shelf(10.0, 10.0, 30.0, 4.0), Shelf(30.0, 10.0, 30.0, 4.0)]
    found = shelves(asked, 14.0, 4.0, (5.0, 35.0), [mark])
    assert all(right and y > 30.0 for y, right in found) and found[0][0] > found[1][0]
