"""Lanes: every lane is what it would be alone, and what can not be told of many at once is an error and never a
mixture."""

import operator
import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from calc.sheet.arrays import anywhere, element, most, one
from calc.sheet.deferred import Later
from calc.sheet.errors import NoSolution
from calc.sheet.functions import argument, largest, resultant, smallest, sqrt
from calc.sheet.lanes import (
    Diverged,
    Lanes,
    Singly,
    abreast,
    design_by_design,
    designs_abreast,
    lane,
    parted,
    point_by_point,
    some_lanes,
    stacked,
    together_or_singly,
)
from calc.sheet.record import record
from calc.sheet.text import Amount, Text

NUMBER = st.floats(-1e3, 1e3).map(lambda x: round(x, 3) + 0.0)
ROWS = st.integers(2, 4).flatmap(lambda n: st.lists(st.lists(NUMBER, min_size=3, max_size=3), min_size=n, max_size=n))
THREE = np.array([2.0, -1.0, 0.5])  # points that all lanes share


@record
class Part:
    size: float
    name: str = "a"
    points: object = None


def same(found: Lanes, expected: list[object]) -> None:
    """Lane by lane, to the last digit."""
    assert type(found) is Lanes and found.lanes == len(expected)
    for k, wanted in enumerate(expected):
        assert np.array_equal(found.data[k], np.asarray(wanted), equal_nan=True), k


@pytest.mark.parametrize("name", ["add", "sub", "mul", "truediv", "mod", "lt", "ge", "eq", "ne"])
@given(rows=ROWS)
def test_an_operator_works_lane_by_lane_whichever_side_has_lanes(name, rows):
    act, numbers = getattr(operator, name), [row[0] for row in rows]
    scalars, points = Lanes(np.array(numbers)), Lanes(np.array(rows))
    with np.errstate(all="ignore"):
        same(act(scalars, 2.5), [act(np.float64(x), 2.5) for x in numbers])
        same(act(2.5, scalars), [act(np.float64(2.5), x) for x in numbers])
        same(act(scalars, THREE), [act(np.float64(x), THREE) for x in numbers])
        same(act(THREE, scalars), [act(THREE, np.float64(x)) for x in numbers])
        same(act(points, scalars), [act(np.array(row), row[0]) for row in rows])
        same(act(points, points), [act(np.array(row), np.array(row)) for row in rows])


@pytest.mark.parametrize(
    "function",
    [
        np.sqrt,
        np.exp,
        np.abs,
        np.max,
        np.sum,
        np.argmax,
        np.diff,
        np.isfinite,
        np.add.reduce,
        lambda x: np.where(x > 0, x, THREE),
        lambda x: np.clip(x, -1.0, 2.0),
        lambda x: np.concatenate([x, THREE]),
        lambda x: np.stack([x, THREE], 1),
        lambda x: np.append(x, x[0]),
        lambda x: np.any(x > 1),
        lambda x: np.interp([0.5, 1.5], [0.0, 1.0, 2.0], x),
        lambda x: np.fft.rfft(x),
        lambda x: x[1],
        lambda x: x[::-1],
        lambda x: x[..., None] * THREE,
        lambda x: largest(x, 0.5),
        lambda x: smallest(x, THREE),
        lambda x: argument(x + 1j * THREE),
        lambda x: resultant(x + 1j * THREE),
        lambda x: element(x, np.argmin(x)),
        lambda x: element(THREE, np.argmax(x)),
        lambda x: one(np.max(x)),
        lambda x: sqrt(np.sum(x * x)),
        lambda x: abs(x),
        lambda x: -x,
        lambda x: np.add.reduce(x[:, None] * THREE),
        lambda x: np.tile(x, 2),
    ],
)
@given(rows=ROWS)
def test_a_function_of_points_works_lane_by_lane(function, rows):
    with np.errstate(all="ignore"):
        same(function(Lanes(np.array(rows))), [function(np.array(row)) for row in rows])


def test_points_and_lanes_are_told_apart_also_where_there_are_as_many():
    three = Lanes(np.array([10.0, 20.0, 30.0]))
    alone = [10.0 + THREE, 20.0 + THREE, 30.0 + THREE]
    same(three + THREE, alone)
    same(three + tuple(THREE), alone)
    same(tuple(THREE) + three, alone)
    same(np.add(three, list(THREE)), alone)
    same(np.where(three > 0, three, list(THREE)), [np.where(True, x, THREE) for x in (10.0, 20.0, 30.0)])


def test_steps_between_two_numbers():
    found = np.linspace(Lanes(np.array([1.0, 2.0])), 5.0, 3)
    assert found.data == pytest.approx(np.array([[1.0, 3.0, 5.0], [2.0, 3.5, 5.0]]), rel=1e-15)


def test_a_condition_is_one_thing_in_all_lanes_or_the_designs_go_apart():
    speeds = Lanes(np.array([1.0, 2.0, 3.0]))
    assert bool(speeds > 0) and not bool(speeds > 5)
    with pytest.raises(Diverged) as apart:
        bool(speeds > 1.5)
    assert apart.value.some.tolist() == [True, False, False]
    assert ["a", "b"][Lanes(np.array([1, 1]))] == "b"
    with pytest.raises(Diverged):
        ["a", "b"][Lanes(np.array([0, 1]))]


@pytest.mark.parametrize(
    "spoil",
    [
        float,
        complex,
        np.asarray,
        hash,
        lambda x: np.array([x, 1.0]),
        lambda x: {x: 1},
        lambda x: np.linalg.norm(x),
        lambda x: len(x),
        list,
        lambda x: bool(x * THREE > 0),
        lambda x: np.exp(x, out=np.empty(2)),
        lambda x: np.sum(x, -1),
        lambda x: np.max(x, 0),
        range,
        lambda x: np.argmin(x[..., None] * THREE[None, :]),
        lambda x: np.diff(x[..., None] * THREE[None, :]),
        lambda x: (x * THREE[:2, None] * THREE[:2]) @ (x * THREE[:2, None] * THREE[:2]),
        lambda x: np.cumsum(x * THREE),
    ],
)
def test_what_lanes_can_not_be_is_an_error(spoil):
    with pytest.raises(TypeError):
        spoil(Lanes(np.array([1.0, 2.0])))


def test_a_sentence_has_no_number_of_many():
    assert Text("at {n} rpm", n=Amount(Lanes(np.array([1.0, 2.0])))) == "at … rpm"


def test_an_iteration_ends_where_all_designs_are_at_the_end():
    assert most(Lanes(np.array([[1.0], [4.0]]))) == 4.0 == most(np.array([1.0, 4.0])) == most(4.0)
    assert anywhere(Lanes(np.array([False, True]))) and not anywhere(np.array([False]))


def test_designs_without_a_number_go_apart_and_where_none_has_one_there_is_no_solution():
    assert parted(whole := Lanes(np.array([1.0, 2.0]))) is whole
    with pytest.raises(Diverged) as apart:
        parted(Lanes(np.array([1.0, np.nan])))
    assert apart.value.some.tolist() == [True, False]
    with pytest.raises(NoSolution):
        parted(Lanes(np.array([np.nan, np.nan])))


# --- records
def test_records_side_by_side_and_each_again():
    parts = [
        Part(size=1.0, points=np.array([1.0, 2.0])),
        Part(size=2.0, points=np.array([1.0, 3.0])),
        Part(size=4.0, points=np.array([1.0, 2.0])),
    ]
    whole = abreast(parts)
    assert whole.name == "a"
    same(whole.size, [1.0, 2.0, 4.0])
    for k, part in enumerate(parts):
        again = lane(whole, k)
        assert type(again.size) is float and again.size == part.size and again.points.tolist() == part.points.tolist()
    same(some_lanes(whole, np.array([True, False, True])).size, [1.0, 4.0])


def test_what_is_the_same_stays_what_it_is():
    shared = Part(size=3.0)
    assert abreast([shared, shared]) is shared
    assert abreast([Part(size=3.0), Part(size=3.0)]).size == 3.0


@pytest.mark.parametrize(
    "other",
    [
        Part(size=1.0, name="b"),
        Part(size=1.0, points=2.0),
        Part(size=1.0, points=(1.0,)),
        Part(size=None),
        Part(size=1.0, points=Text("x")),
    ],
)
def test_records_that_differ_in_more_than_numbers_go_apart(other):
    with pytest.raises(Diverged) as apart:
        abreast([Part(size=1.0), other, Part(size=2.0)])
    assert apart.value.some.tolist() == [True, False, True]


def test_words_may_differ_since_nobody_reads_them():
    assert abreast([Text("{n} mm", n=1), Text("{n} mm", n=2)]) == "1 mm"


def test_what_a_design_makes_of_its_own_numbers_can_not_be_asked_of_many():
    whole = abreast([Part(size=n, points=lambda n=n: n) for n in (1.0, 2.0)])
    with pytest.raises(TypeError):
        whole.points()
    with pytest.raises(TypeError):
        list(abreast([Later(lambda: (1,)), Later(lambda: (2,))]))
    assert abreast([max, max]) is max
    for pair in ([max, None], [None, max], [Text("x"), None], [None, Text("x")], [Text(""), Text("x")]):
        with pytest.raises(Diverged):
            abreast(pair)


def test_a_search_is_made_for_each_design_and_known_when_they_go_apart():
    calls = []

    @design_by_design
    def searched(part: Part, start: float) -> float | None:
        calls.append(part.size)
        return None if part.size > 2 else part.size + start

    parts, singly = abreast([Part(size=1.0), Part(size=2.0), Part(size=3.0)]), Singly([{}] * 3)
    with designs_abreast(singly), pytest.raises(Diverged) as apart:
        searched(parts, 0.5)
    assert calls == [1.0, 2.0, 3.0]
    with designs_abreast(singly.some(apart.value.some)):
        same(searched(some_lanes(parts, apart.value.some), 0.5), [1.5, 2.5])
        assert len(calls) == 3
        same(searched(some_lanes(parts, apart.value.some), 1.5), [2.5, 3.5])  # another question is another answer
    assert len(calls) == 5 and searched(Part(size=1.0), 0.5) == 1.5


def test_a_design_of_many_without_a_solution_goes_apart():
    @design_by_design
    def solved(x: float) -> float:
        if x > 1:
            raise NoSolution(Text("too large"), Text(""), Text(""))
        return 1 / x

    with designs_abreast(Singly([{}] * 2)):
        for numbers in ([1.0, 2.0], [1.0, 0.0], [0.0, 2.0]):
            with pytest.raises(Diverged):
                solved(Lanes(np.array(numbers)))
        with pytest.raises(NoSolution, match="too large"):
            solved(Lanes(np.array([3.0, 2.0])))


def test_what_fails_with_lanes_is_called_for_each_design():
    @together_or_singly
    def rounded(x: float) -> float:
        return float(x)

    with designs_abreast(Singly([{}] * 2)):
        same(rounded(Lanes(np.array([1.0, 2.0]))), [1.0, 2.0])
    with pytest.raises(TypeError):
        rounded(Lanes(np.array([1.0, 2.0])))


def test_points_of_many_designs_are_more_points():
    seen = []

    @point_by_point
    def doubled(x: object) -> object:
        seen.append(np.shape(x))
        return 2 * np.asarray(x)

    with designs_abreast(Singly([{}] * 2)):
        same(doubled(Lanes(np.array([[1.0, 2.0], [3.0, 4.0]]))), [[2.0, 4.0], [6.0, 8.0]])
    assert seen == [(2, 2)] and doubled(THREE).tolist() == (2 * THREE).tolist()


def test_stacked_is_what_an_array_of_floats_is():
    same(stacked([Lanes(np.array([1.0, 2.0])), 5.0]), [[1.0, 5.0], [2.0, 5.0]])
    assert isinstance(stacked([1.0, 2.0]), np.ndarray) and re.fullmatch("…", repr(Lanes(np.zeros(2))))
