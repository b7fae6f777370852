"""A number carries where it came from, and is else a number like any other."""

import copy
import json
import pickle

import numpy as np
import pytest

from calc.sheet.formula import formula
from calc.sheet.linked_array import elements, gathered, item, where
from calc.sheet.units import Metre, Number
from calc.sheet.value import based_on, converged, leaves, link_of, linked, trace, unlinked, untraced


@formula("a", "a formula for this test")
def double(x: Metre) -> Metre:
    return 2 * x


@formula("x", "a formula for this test", shows="x with x = 1 + x/2")
def closing(x: Number) -> Number:
    return x


@pytest.mark.parametrize("x", [1.25, 3, 2 - 1j, "20CrNi4", np.float64(0.1), np.complex128(1j)])
def test_it_is_the_same_number(x):
    one = linked(x, "engine.bore_mm")
    assert (
        one == x and hash(one) == hash(x) and repr(one) == repr(x) and str(one) == str(x) and isinstance(one, type(x))
    )
    assert link_of(one) == "engine.bore_mm" and link_of(x) is None
    for again in (pickle.loads(pickle.dumps(one)), copy.deepcopy(one), unlinked(one)):
        assert again == x and (type(again) is type(x) or isinstance(x, (int, str)))
    assert isinstance(x, (complex, np.generic)) or json.dumps(one) == json.dumps(x)


def test_arithmetic_gives_a_plain_number():
    assert type(linked(2.0, "a") * 3) is float and link_of(linked(np.ones(3), "a") * 2) is None


def test_a_formula_links_what_it_returns_to_its_line():
    with trace() as lines:
        a, b = double(x=linked(1.5, "engine.bore_mm")), double(x=np.ones(3))
        with untraced():
            assert link_of(double(x=1.0)) is None
    assert (link_of(a), link_of(b)) == tuple(lines) and link_of(lines[0].arguments["x"]) == "engine.bore_mm"
    assert link_of(b[1]) is lines[1] and link_of(b[:2]) is lines[1] and link_of(item(b[0])) is lines[1]
    assert type(lines[0].value) is float  # no circle of lines and numbers


def test_an_array_that_is_gathered_knows_its_elements():
    array = gathered([linked(1.0, "a"), 2.0, linked(3.0, "c")])
    assert array.tolist() == [1.0, 2.0, 3.0] and leaves(link_of(array)) == ("a", "c")
    assert [link_of(x) for x in array] == ["a", None, "c"] and [link_of(x) for x in elements(array)] == ["a", None, "c"]
    assert leaves(link_of(array[[2, 1]])) == ("c",) and leaves(link_of(array[array > 2])) == ("c",)
    twice = based_on(2 * array, array)
    assert [link_of(x) for x in twice] == ["a", None, "c"]
    both = where(np.array([True, False, True]), array[[0, 2]], linked(np.array([9.0]), "other"))
    assert both.tolist() == [1.0, 9.0, 3.0] and [link_of(x) for x in both] == ["a", "other", "c"]


def test_what_a_solver_found_is_linked_to_all_that_it_was_given():
    assert leaves(link_of(based_on(1.0, linked(2.0, "a"), (linked(3.0, "b"), linked(2.0, "a")), 4.0))) == ("a", "b")
    assert link_of(based_on(1.0, 2.0)) is None


def test_the_last_pass_of_an_iteration_leads_out_and_not_in_a_circle():
    given = linked(1.0, "given")

    def last(x):
        double(x=linked(7.0, "beside"))  # of no account for x
        return based_on(double(x=x), double(x=x), double(x=given))

    with trace() as lines:
        found = converged(closing, 2.0, last, lambda made: made)
    own = lines[0]
    assert own.formula is closing and own.value == 2.0 and link_of(own.arguments["from"]) == ("given",)
    assert own in {leaf for line in leaves(link_of(found)) for leaf in leaves(link_of(line.arguments["x"]))}
