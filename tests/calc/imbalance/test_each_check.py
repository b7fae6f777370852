"""Each check of the imbalance just inside and just outside its limit, and the unbalances that nobody gave."""

import math
from dataclasses import replace

import pytest

from calc.imbalance.checks import checks
from calc.imbalance.shaft_pair import ShaftPair
from calc.imbalance.webs import CrankState, WebsResult
from calc.sheet.verdict import step_state
from tests.calc.imbalance.engines import solved

FORCE, COUPLE = 1000.0, 100.0  # of one cylinder: its force and its couple over one pitch
LAMBDA = 0.3
RESULT = replace(solved()[2], one_force=FORCE, one_couple=COUPLE)


def found(shaft=False, webs=None, pair=None, order_1=(), order_2=()):
    """The checks by their ids, of an engine with some of its results replaced."""
    orders = {
        "order_1": replace(RESULT.orders["order_1"], **dict(order_1)),
        "order_2": replace(RESULT.orders["order_2"], **dict(order_2)),
    }
    result = replace(RESULT, orders=orders, webs=webs, shaft_pair=pair)
    return {check.id: check for check in checks(result, LAMBDA, 0.5, 1.0, shaft)}


def first(**changes):
    return found(order_1=changes)


def second(**changes):
    return found(order_2=changes)


def roll(left, reaction=60.0):
    zeros = ("force_forward", "force_backward", "height_difference", "roll_torque_phase", "reaction_phase")
    return found(pair=ShaftPair(**dict.fromkeys(zeros, 0.0), roll_torque=50.0, reaction=reaction, roll_left=left))


def crank(state="balanced", permitted=None, drilled=None, pins=None, **changes):
    """Two states of the crank, of which the bare one is far outside."""
    numbers = {key: 0.0 for key in CrankState.__dataclass_fields__}
    states = {
        "bare": CrankState(**dict.fromkeys(numbers, 1e6)),
        state: CrankState(**{**numbers, **changes}),
    }
    webs = WebsResult(crank=states, permitted_unbalance=permitted, drilled_mass=drilled, pin_deviation=pins)
    return found(webs=webs)


def pulley(left=None, missing=None):
    return found(webs=WebsResult(missing_forward_couple=missing, unbalances_couple_left=left))


CASES = [  # 5 % of 1000 N and 100 N·m; half of λ = 0.3 of them
    ("imbalance.order_1.backward", first(couple_backward=4.99), first(couple_backward=5.01), "note"),
    ("imbalance.order_1.backward_force", first(force_backward=49.9), first(force_backward=50.1), "note"),
    ("imbalance.order_1.forward", first(couple_forward=4.99), first(couple_forward=5.01), "warn"),
    ("imbalance.order_1.forward_force", first(force_forward=49.9), first(force_forward=50.1), "warn"),
    ("imbalance.order_2.couple", second(couple_peak=14.9), second(couple_peak=15.1), "note"),
    ("imbalance.order_2.force", second(force_peak=149.0), second(force_peak=151.0), "note"),
    ("imbalance.shaft_pair.roll", roll(59.9), roll(60.1), "note"),
    ("imbalance.crank.force", crank(force=49.9), crank(force=50.1), "warn"),
    ("imbalance.crank.couple", crank("stated", couple=4.99), crank("stated", couple=5.01), "warn"),
    (
        "imbalance.crank.residual",
        crank(permitted=1e-3, unbalance=0.99e-3),
        crank(permitted=1e-3, unbalance=1.01e-3),
        "note",
    ),
    ("imbalance.unbalances.couple_left", pulley(left=4.99), pulley(left=5.01), "warn"),
    ("imbalance.crank.throws", crank(pins=math.radians(1.99)), crank(pins=math.radians(2.01)), "warn"),
]


@pytest.mark.parametrize("id, inside, outside, verdict", CASES)
def test_inside_and_outside(id, inside, outside, verdict):
    assert (inside[id].verdict, outside[id].verdict) == ("pass", verdict)


@pytest.mark.parametrize(
    "id, quoted",
    [
        ("imbalance.order_1.backward", "5 % (order 1) or 50 % of λ (order 2) of m·r·ω² of one cylinder"),
        ("imbalance.order_1.backward_force", "5 % (order 1)"),
        ("imbalance.order_1.forward", "5 % (order 1)"),
        ("imbalance.order_1.forward_force", "5 % (order 1)"),
        ("imbalance.order_2.couple", "couples over one pitch"),
        ("imbalance.order_2.force", "50 % of λ (order 2)"),
        ("imbalance.shaft_pair.roll", "should not add to the torque reaction of the inertia forces"),
        ("imbalance.crank.force", "5 % (order 1)"),
        ("imbalance.crank.couple", "couples over one pitch"),
        ("imbalance.crank.residual", "ISO 21940-11, permissible residual unbalance"),
        ("imbalance.unbalances.couple_left", "couples over one pitch"),
        ("imbalance.crank.throws", "rule of this program: within 2°"),
    ],
)
def test_sources(id, quoted):
    inside = next(inside for case, inside, *_ in CASES if case == id)
    assert quoted in str(inside[id].source)


def test_with_a_shaft_its_own_step_judges_what_turns_backward():
    assert not [id for id in found(shaft=True) if "backward" in id]


def test_the_crank_as_stated_is_judged_before_that_with_the_bobs_found():
    assert crank("stated")["imbalance.crank.force"].name == "Force of the crank with the bobs as stated"
    assert crank("balanced")["imbalance.crank.force"].name == "Force of the crank with the bobs found"


def test_a_crank_that_is_drilled_has_nothing_left():
    assert "imbalance.crank.residual" not in crank(permitted=1e-3, drilled=0.1, unbalance=1.0)


def test_a_roll_without_any_reaction_is_measured_against_that_of_the_shafts():
    check = roll(25.0, reaction=0.0)["imbalance.shaft_pair.roll"]
    assert check.verdict == "note" and check.margin == pytest.approx(-0.5)


# --- unbalances that are not given
@pytest.mark.parametrize("missing, verdict", [(4.99, "pass"), (5.01, "not_verified"), (827.8, "not_verified")])
def test_the_couple_that_pulley_and_flywheel_must_supply_is_judged_without_unbalances(missing, verdict):
    """They may leave nothing of it, or all of it."""
    check = pulley(missing=missing)["imbalance.unbalances.couple_left"]
    assert (check.verdict, check.at_best, check.at_worst) == (verdict, 0.0, missing)
    assert check.missing == ("imbalance.unbalances",) and check.taken == ("unbalances that leave nothing",)


def test_given_unbalances_are_judged_by_what_they_leave():
    check = pulley(left=5.01, missing=827.8)["imbalance.unbalances.couple_left"]
    assert (check.verdict, check.value, check.missing) == ("warn", 5.01, ())


def test_where_nothing_is_known_of_the_crank_nothing_is_asked_of_pulley_and_flywheel():
    assert "imbalance.unbalances.couple_left" not in pulley() | found()


def test_a_couple_that_is_not_verified_is_a_caution_of_the_step():
    quiet = dict(couple_forward=0.0, force_forward=0.0)
    rest = [*first(**quiet).values()]
    assert step_state(rest, computes=True) == "computed"
    asked = pulley(missing=827.8)["imbalance.unbalances.couple_left"]
    assert step_state([*rest, asked], computes=True) == "warn"
