# SPDX-License-Identifier: Apache-2.0
"""The one search: its candidates, its limits on arrays, and its trials one after the other, against plain loops."""

import math

import numpy as np
import pytest

from calc.sheet.quantity import Quantity, inputs, quantity, table, text
from calc.sheet.remedy import applied, assignments, digits, whole
from calc.sheet.search import (
    Budget,
    Trial,
    beside,
    crossing,
    first,
    first_good,
    governing,
    judged,
    least,
    least_wanted,
    least_whole,
    multiples,
    narrowed,
    rounded,
    stretch,
)
from calc.sheet.text import Small, Text
from tests.made_checks import made_check


# --- candidates
def test_multiples_stand_on_the_step_with_the_own_number_between_them():
    assert multiples(0.5, 1.2, 3.0).tolist() == [1.5, 2.0, 2.5, 3.0]
    assert multiples(0.5, 1.2, 2.0, [1.7]).tolist() == [1.5, 1.7, 2.0]
    assert multiples(0.5, 1.2, 2.0, [1.5 + 1e-9]).tolist() == [1.5 + 1e-9, 2.0]
    assert multiples(0.5, 2.1, 2.4).size == 0


def test_what_an_input_allows():
    about = Quantity("number", Text("Width"), above=0, high=5)
    assert [x for x in (0.0, 0.1, 1.0, 5.0, 5.1) if about.allows(x)] == [0.1, 1.0, 5.0]
    assert not Quantity("number", Text("Width"), low=1).allows(0.9)


@pytest.mark.parametrize(
    "low, high, number",
    [(1.23, 1.34, 1.3), (99.0, 1234.0, 1000.0), (1.34, 1.23, 1.3), (-1.0, -1.26, -1.2), (0.0, 0.007, 0.007)],
)
def test_a_round_number_beyond_the_first_and_not_beyond_the_second(low, high, number):
    assert rounded(low, high) == pytest.approx(number)


def test_the_steps_beside_a_number():
    assert beside(27.5e-3, 0.5e-3) == (27e-3, 28e-3)
    assert beside(90.04e-6, 5e-6) == (85e-6, 95e-6)
    assert beside(94e-6, 5e-6) == (90e-6, 100e-6)  # 95 is less than half a step away
    assert beside(92.5e-6, 5e-6) == pytest.approx((85e-6, 100e-6))  # 90 and 95 are no more than that


# --- many at once
@pytest.mark.parametrize("sense, limit", [(">=", 2.0), ("<=", 2.0), (">", 0.0), ("in", (1.0, 3.0))])
def test_a_limit_on_an_array_is_a_check_on_each(sense, limit):
    values = np.array([-1.0, 0.0, 1.0, 1.9, 2.0, 2.5, 4.0])
    margins = judged("rule", values, limit, sense).margin
    for value, margin in zip(values, margins):
        one = made_check(float(value), sense, limit, zero_scale=1.0)
        assert margin == pytest.approx(one.margin)
    assert judged("rule", np.array([math.nan]), limit, sense).margin[0] == -math.inf
    assert judged("rule", np.array([2.0 - 1e-12]), 2.0).margin[0] == 0.0


def test_the_least_margin_and_what_governs():
    one, two = judged("one", np.array([1.0, 3.0]), 2.0), judged("two", np.array([2.2, 2.2]), 2.0)
    assert least([one, two]) == pytest.approx([-0.5, 0.1])
    assert governing([one, two], 0).rule == "one" and governing([one, two], 1).rule == "two"


def test_the_first_by_several_orders():
    kept = np.array([[False, True, True], [True, True, False]])
    wanted, then = np.array([[0, 2, 1], [1, 3, 0]]), np.array([[0, 0, 5], [4, 0, 0]])
    assert first(kept, wanted, then) == (1, 0)
    assert first(np.zeros(3, bool), np.arange(3)) is None


def test_the_stretch_around_or_nearest_to_a_candidate():
    kept = np.array([True, False, True, True, True, False, False])
    assert stretch(kept, 3) == (2, 4) and stretch(kept, 6) == (2, 4) and stretch(kept, 0) == (0, 0)
    assert stretch(np.zeros(3, bool), 1) is None


def test_a_narrowing_grid_finds_the_best_point_of_the_lattice():
    low, high = np.array([-40, -40]), np.array([60, 60])

    def evaluate(points):
        x, y = points.T
        return 35.0 - x - y, (x - 31) ** 2 + 2.0 * (y - 13) ** 2

    point, margin, wanted = narrowed(evaluate, low, high, np.array([0, 0]), np.array([10, 10]), 5)
    every = np.stack(np.meshgrid(np.arange(-40, 61), np.arange(-40, 61)), -1).reshape(-1, 2)
    margins, values = evaluate(every)
    i = least_wanted(values, margins)
    assert margin >= 0 and wanted == values[i] and (point == every[i]).all()


def test_a_narrowing_grid_reaches_a_far_end_in_few_steps():
    """A start with step 1, as beside a point that is known, may have most of the lattice before it."""
    grids = 0

    def evaluate(points):
        nonlocal grids
        grids += 1
        return np.zeros(len(points)), np.abs(points - [28_765, -4_321]).sum(axis=1)

    low, high = np.array([-10_000, -10_000]), np.array([30_000, 30_000])
    point, _, wanted = narrowed(evaluate, low, high, np.array([0, 0]), np.array([1, 1]), 9)
    assert point.tolist() == [28_765, -4_321] and wanted == 0
    assert grids < 200  # at step 1 alone it takes 7000


# --- one after the other
def test_a_budget_is_spent_once():
    budget = Budget(2)
    assert [budget.spend() for _ in range(4)] == [True, True, False, False] and budget.left == 0


def test_the_first_of_rank_0_ends_the_trials():
    seen = []

    def evaluate(n):
        seen.append(n)
        return Trial(n, rank=0 if n == 4 else n) if n > 1 else Trial(None, why=Text("too small"))

    assert first_good([0, 3, 2, 4, 9], evaluate).result == 4 and seen == [0, 3, 2, 4]
    assert first_good([0, 3, 2, 9], evaluate).result == 2
    assert first_good([0, 1], evaluate).why == "too small" and first_good([], evaluate).result is None
    assert first_good([0, 1, 4], evaluate, most=2).result is None


SCORES = {  # of a change x, zero at 0.37
    "line": lambda x: x - 0.37,
    "ever steeper": lambda x: x**3 - 0.37**3,
    "ever flatter": lambda x: math.log((x + 0.01) / 0.38),
    "not allowed far on": lambda x: x**3 - 0.37**3 if x < 0.4 else math.nan,
    "known only where it holds": lambda x: 0.0 if x >= 0.37 else math.nan,
}


@pytest.mark.parametrize("kind", SCORES)
def test_the_smallest_change_lies_between_its_two_ends(kind):
    asked = []

    def score(x):
        asked.append(x)
        return SCORES[kind](x)

    low, high = crossing(score, SCORES[kind](0.0), 0.02, 10.0, 0.01)
    assert low < 0.37 <= high <= 1.2 * 0.37 and len(asked) <= 13
    assert SCORES[kind](high) >= 0 and not SCORES[kind](low) >= 0
    wide = crossing(score, SCORES[kind](0.0), 0.02, 10.0, 0.01, near=0.5)
    assert wide[0] <= low and wide[1] >= high


def test_where_no_change_is_enough_the_nearest_one_is_told():
    assert crossing(lambda x: x - 0.37, -0.37, 0.02, 0.3, 0.01) == 0.3, "no farther than that"
    assert crossing(lambda x: -abs(x - 0.1) - 1, -1.1, 0.02, 2.0, 0.01) == pytest.approx(0.1, abs=0.09)
    assert crossing(lambda x: x - 0.37 if x < 0.2 else math.nan, -0.37, 0.02, 2.0, 0.01) == pytest.approx(
        0.19, abs=0.01
    )
    assert crossing(lambda x: math.nan, math.nan, 0.02, 2.0, 0.01) == 0.0


@pytest.mark.parametrize("limit", [3, 4, 9, 12])
def test_the_least_whole_number_that_gives_anything(limit):
    asked = []

    def evaluate(n):
        asked.append(n)
        return f"width {n}" if n >= limit else None

    assert least_whole(evaluate, 3, 12) == f"width {limit}" and len(asked) <= 5
    assert least_whole(evaluate, 1, 2) is None and least_whole(evaluate, 5, 4) is None


# --- changes
@inputs
class Inner:
    length: float = quantity("Length", "mm", low=0, high=100)
    clearance: float = quantity("Clearance", "µm", default=None)


@inputs
class Outer:
    oil: str = text("Oil")
    front: Inner = table("Front", Inner)


def test_changes_are_applied_as_if_the_file_had_them():
    before = Outer(oil="SAE 30", front=Inner(length=0.02, clearance=5e-5))
    after = applied(
        before, {"outer.oil": "SAE 50", "outer.front.length_mm": 27.5, "outer.front.clearance_um": None}, "outer."
    )
    assert after.oil == "SAE 50" and after.front.length == 27.5 / 1000 and after.front.clearance is None
    assert before.front.length == 0.02


def test_changes_are_written_as_on_the_command_line():
    changes = {"a.b": None, "a.c": 65.0, "a.d": 'SAE "50"', "a.e": [1, 2.5], "a.f": 3}
    assert assignments(changes) == ["a.b=", "a.c=65.0", 'a.d="SAE \\"50\\""', "a.e=[1, 2.5]", "a.f=3"]
    assert digits(0.1 + 0.2) == 0.3 and whole(15.0) == 15 and isinstance(whole(15.0), int) and whole(14.5) == 14.5


def test_a_label_is_small_within_a_sentence_in_every_language():
    import pickle

    label = Small(Text("Length of {wheel}", wheel="Idler"))
    assert label == "length of Idler" and label.template == "Length of {wheel}"
    again = pickle.loads(pickle.dumps(label))
    assert again == label and type(again) is Small and again.parts == label.parts
    assert Text("{label} 3 mm", label=label) == "length of Idler 3 mm"
