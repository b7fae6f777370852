"""Each check of the imbalance just inside and just outside its limit, and the unbalances that nobody gave."""

import cmath
import math
from dataclasses import replace

import pytest

from calc.imbalance.checks import checks, proposals
from calc.imbalance.remedies import BalanceShaft
from calc.imbalance.shaft_pair import ShaftPair
from calc.imbalance.webs import CrankState, WebsResult
from calc.sheet.verdict import step_state
from tests.calc.imbalance.engines import solved

FORCE, COUPLE = 1000.0, 100.0  # of one cylinder: its force and its couple over one pitch
LAMBDA = 0.3
RESULT = replace(solved()[2], one_force=FORCE, one_couple=COUPLE)


def found(taken=(), webs=None, pair=None, order_1=(), order_2=(), shares=(0.5, 1.0), **changes):
    """The checks by their ids, of an engine with some of its results replaced; `shares` on the crank, of what moves to
    and fro and of what turns."""
    orders = {
        "order_1": replace(RESULT.orders["order_1"], **dict(order_1)),
        "order_2": replace(RESULT.orders["order_2"], **dict(order_2)),
    }
    result = replace(RESULT, orders=orders, webs=webs, shaft_pair=pair, **changes)
    return {check.id: check for check in checks(result, LAMBDA, *shares, frozenset(taken))}


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
    ("imbalance.order_1.backward", lambda: first(couple_backward=4.99), lambda: first(couple_backward=5.01), "note"),
    (
        "imbalance.order_1.backward_force",
        lambda: first(force_backward=49.9),
        lambda: first(force_backward=50.1),
        "note",
    ),
    ("imbalance.order_1.forward", lambda: first(couple_forward=4.99), lambda: first(couple_forward=5.01), "warn"),
    ("imbalance.order_1.forward_force", lambda: first(force_forward=49.9), lambda: first(force_forward=50.1), "warn"),
    ("imbalance.order_2.couple", lambda: second(couple_peak=14.9), lambda: second(couple_peak=15.1), "note"),
    ("imbalance.order_2.force", lambda: second(force_peak=149.0), lambda: second(force_peak=151.0), "note"),
    ("imbalance.shaft_pair.roll", lambda: roll(59.9), lambda: roll(60.1), "note"),
    ("imbalance.crank.force", lambda: crank(force=49.9), lambda: crank(force=50.1), "warn"),
    ("imbalance.crank.couple", lambda: crank("stated", couple=4.99), lambda: crank("stated", couple=5.01), "warn"),
    (
        "imbalance.crank.residual",
        lambda: crank(permitted=1e-3, unbalance=0.99e-3),
        lambda: crank(permitted=1e-3, unbalance=1.01e-3),
        "note",
    ),
    ("imbalance.unbalances.couple_left", lambda: pulley(left=4.99), lambda: pulley(left=5.01), "warn"),
    ("imbalance.crank.throws", lambda: crank(pins=math.radians(1.99)), lambda: crank(pins=math.radians(2.01)), "warn"),
]


@pytest.mark.parametrize("id, inside, outside, verdict", CASES)
def test_inside_and_outside(id, inside, outside, verdict):
    assert (inside()[id].verdict, outside()[id].verdict) == ("pass", verdict)


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
    assert quoted in str(inside()[id].source)


def test_with_a_shaft_its_own_step_judges_what_turns_backward():
    assert not [id for id in found(taken={-1}) if "backward" in id]
    assert not [id for id in found(taken={1}) if ".forward" in id] and "imbalance.order_1.backward" in found(taken={1})


def test_of_second_order_both_senses_must_be_taken():
    ids = {"imbalance.order_2.couple", "imbalance.order_2.force"}
    assert ids <= set(found(taken={2})) and ids <= set(found(taken={-1, 1})) and not ids & set(found(taken={-2, 2}))


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
    assert (check.verdict, check.value, check.at_best, check.at_worst) == (verdict, 0.0, 0.0, missing)
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


# --- what would help
HALF = "A backward shaft can not take it: balance half of the reciprocating mass on the crank (fraction 0.5)."
BOTH = (
    "A backward shaft can not take it: balance the rotating masses whole and half of the reciprocating mass on the "
    "crank (rotating_balance_fraction 1, crank_balance_fraction 0.5)."
)
TURN = "The offset turns it away from the pins: counterweights turned by {} from opposite them take it."


def turned(degrees, force=100.0, couple=0.0, sign=1.0):
    """Vectors that turn forward, so far from where counterweights opposite the pins act against them."""
    away = cmath.rect(1.0, sign * math.radians(degrees))
    return dict(
        order_1={"unbalanced": (force * away, 0j, couple * away, 0j)},
        whole=(complex(-2 * force), complex(-2 * couple)),
    )


@pytest.mark.parametrize(
    "changes, advice",
    [
        (turned(0.0099), HALF),
        (turned(0.0101), TURN.format("0.0101°")),
        (turned(12.0, sign=-1.0), TURN.format("12°")),
        (turned(12.0, couple=0.1), TURN.format("12°")),  # beside the force the couple is rounding
        (turned(12.0, force=1e-3, couple=50.0), TURN.format("12°")),
        (turned(12.0) | dict(shares=(0.0, 1.0)), HALF),
        (turned(12.0) | dict(shares=(1.0, 1.0)), HALF),
        (turned(12.0) | dict(shares=(0.5, 0.9)), BOTH),
        (turned(0.0) | dict(shares=(0.0, 1.1)), BOTH),
    ],
)
def test_how_the_crank_could_take_what_turns_forward(changes, advice):
    judged = found(**changes)
    assert judged["imbalance.order_1.forward"].advice == judged["imbalance.order_1.forward_force"].advice == advice


def test_the_greater_of_force_and_couple_says_how_far_the_offset_turns():
    """Of an engine whose forces cancel but for rounding their direction means nothing."""
    changes = turned(12.0, force=1e-3, couple=50.0)
    changes["order_1"]["unbalanced"] = (1e-3j, 0j, *changes["order_1"]["unbalanced"][2:])
    assert found(**changes)["imbalance.order_1.forward"].advice == TURN.format("12°")
    changes = turned(12.0, force=50.0, couple=1e-3)
    changes["order_1"]["unbalanced"] = (*changes["order_1"]["unbalanced"][:2], 1e-3j, 0j)
    assert found(**changes)["imbalance.order_1.forward"].advice == TURN.format("12°")


def single(speed_ratio):
    """One shaft against the second order."""
    shafts = {"a": BalanceShaft(speed_ratio=speed_ratio)}
    return RESULT.remedy | {"second_order_shafts": replace(RESULT.remedy["second_order_shafts"], shafts=shafts)}


NO_SECOND = {name: remedy for name, remedy in RESULT.remedy.items() if name != "second_order_shafts"}


@pytest.mark.parametrize("remedy, shafts", [(RESULT.remedy, "two shafts at ±2"), (single(-2.0), "one shaft at −2")])
def test_which_shafts_would_take_the_second_order(remedy, shafts):
    judged = found(remedy=remedy)
    words = f"A shaft at crank speed leaves it whole; {shafts}ω would take it, a longer rod lowers it."
    assert judged["imbalance.order_2.couple"].advice == judged["imbalance.order_2.force"].advice == words
    assert found(remedy=NO_SECOND)["imbalance.order_2.couple"].advice == ""


def test_one_shaft_takes_what_turns_backward():
    check = found(required_couple=123.4, required_couple_phase=math.radians(-150.0))["imbalance.order_1.backward"]
    assert check.advice == "One shaft at −ω takes it: 123.4 N·m at −150°; add a shaft."


CRANK = (
    "Counterweights on the crank for half of the reciprocating mass (crank_balance_fraction 0.5; {}), because they {} "
    "of first order that turns forward: {}."
)
ALONE = " Nothing of first order turns backward: no shaft is needed for it."
BACKWARD = (
    "One shaft at −1 times crank speed{}, because {} of first order {} backward, and nothing on the crank can take it."
)
BESIDE = (
    " It carries a force: each 100 mm beside the crank's axis cost a roll torque of {} N·m; two shafts at ±1 cost none."
)
SECOND = (
    "{} times crank speed, where the comfort is worth it, because {} of second order {} left at the peak; neither the "
    "crank nor a shaft at crank speed changes it."
)
SECOND_TAKEN = (
    "{} times crank speed (as designed): without, {} of second order {} left at the peak; neither the crank nor a shaft "
    "at crank speed changes it."
)
FORWARD = "One shaft at +1 times crank speed (as designed): it takes what of first order turns forward, {}."
SUPPLY = (
    "Unbalances on pulley and flywheel that supply {} (the couple at −30°), because the crank's own webs lack it for "
    "the share 0.4; give them as [[imbalance.unbalances]] to see what is left."
)
NONE = "No remedy is called for: neither order 1 nor order 2 leaves a force or couple that counts."
TURNED_AWAY = "take all but {} (the offset turns it by {}° from the pins; counterweights turned as far take that too)"
IN_PART = "take all but {} (the rotating masses are balanced to a share of 0.9 only)"


def proposed(
    forward=(0.0, 0.0),
    backward=(0.0, 0.0),
    plus=(0.0, 0.0),
    minus=(0.0, 0.0),
    whole=None,
    kappa=0.5,
    rho=1.0,
    taken=(),
    offsets_differ=False,
    **changes,
):
    """Of an engine that leaves these forces and couples; unless `whole` is given, half on the crank takes all that
    turns forward."""
    (F_f, C_f), (F_b, C_b), (F_p, C_p), (F_m, C_m) = forward, backward, plus, minus
    orders = {
        "order_1": replace(RESULT.orders["order_1"], unbalanced=(F_f, -1j * F_b, C_f, -1j * C_b)),
        "order_2": replace(RESULT.orders["order_2"], vectors=(F_p, -1j * F_m, C_p, -1j * C_m)),
    }
    whole = (-2 * F_f, -2 * C_f) if whole is None else whole
    result = replace(RESULT, orders=orders, whole=tuple(map(complex, whole)), **{"webs": None} | changes)
    return proposals(result, LAMBDA, kappa, rho, frozenset(taken), offsets_differ)


def lacking(force, couple, given=None):
    phase = math.radians(-30.0)
    return WebsResult(
        missing_forward_force=force,
        missing_forward_couple=couple,
        missing_forward_couple_phase=phase,
        unbalances_couple=given,
    )


def rolling(torque):
    return RESULT.remedy | {"backward_shaft": replace(RESULT.remedy["backward_shaft"], roll_torque_at_100_mm=torque)}


@pytest.mark.parametrize(
    "engine, sentences",
    [
        # 5 % of 1000 N and 100 N·m; of each shaft of the second order half of that of 0.3 · 1000 N and 100 N·m
        (dict(forward=(49.9, 4.99), backward=(49.9, 4.99), plus=(74.9, 7.49), minus=(74.9, 7.49)), [NONE]),
        (dict(forward=(50.1, 0.0)), [CRANK.format("as designed", "take all", "a force of 50.1 N") + ALONE]),
        (
            dict(forward=(0.0, 5.01), kappa=0.4),
            [CRANK.format("the design has 0.4", "take all", "a couple of 5.01 N·m") + ALONE],
        ),
        (
            dict(forward=(60.0, 6.0), kappa=0.6, backward=(0.0, 5.01)),
            [
                CRANK.format("the design has 0.6", "take all", "a force of 60 N and a couple of 6 N·m"),
                BACKWARD.format("", "a couple of 5.01 N·m", "turns"),
            ],
        ),
        (dict(backward=(60.0, 6.0)), [BACKWARD.format("", "a force of 60 N and a couple of 6 N·m", "turn")]),
        (
            dict(backward=(50.1, 0.0), taken={-1}, remedy=rolling(12.0)),
            [BACKWARD.format(" (as designed)", "a force of 50.1 N", "turns") + BESIDE.format(12)],
        ),
        (dict(backward=(49.9, 6.0), remedy=rolling(12.0)), [BACKWARD.format("", "a couple of 6 N·m", "turns")]),
        (dict(plus=(75.1, 0.0)), [SECOND.format("Two shafts at ±2", "a force of 75.1 N", "is")]),
        (dict(plus=(75.1, 0.0), taken={2, -2}), [SECOND_TAKEN.format("Two shafts at ±2", "a force of 75.1 N", "is")]),
        (dict(plus=(75.1, 0.0), taken={2}), [SECOND.format("Two shafts at ±2", "a force of 75.1 N", "is")]),
        (
            dict(minus=(75.1, 0.0), taken={-2}, remedy=single(-2.0)),
            [SECOND_TAKEN.format("One shaft at −2", "a force of 75.1 N", "is")],
        ),
        (dict(forward=(50.1, 0.0), taken={1, -1}), [FORWARD.format("a force of 50.1 N")]),
        (dict(minus=(0.0, 7.51)), [SECOND.format("Two shafts at ±2", "a couple of 7.51 N·m", "is")]),
        (dict(minus=(75.1, 0.0), remedy=single(-2.0)), [SECOND.format("One shaft at −2", "a force of 75.1 N", "is")]),
        (
            dict(plus=(60.0, 5.0), minus=(80.0, 4.0)),
            [SECOND.format("Two shafts at ±2", "a force of 140 N and a couple of 9 N·m", "are")],
        ),
        (dict(plus=(75.1, 0.0), remedy=NO_SECOND), [NONE]),
        # what half on the crank leaves: 2 % of the 50 N and 5 N·m that count
        (
            dict(forward=(50.99, 0.0), whole=(-100.0, 0.0)),
            [CRANK.format("as designed", "take all", "a force of 50.99 N") + ALONE],
        ),
        (
            dict(forward=(51.01, 0.0), whole=(-100.0, 0.0)),
            [CRANK.format("as designed", TURNED_AWAY.format("a force of 1.01 N", 0), "a force of 51.01 N") + ALONE],
        ),
        (
            dict(forward=(0.0, 6.101), whole=(0.0, -12.0), rho=0.9),
            [CRANK.format("as designed", IN_PART.format("a couple of 0.101 N·m"), "a couple of 6.101 N·m") + ALONE],
        ),
        (
            dict(forward=(0.0, 6.099), whole=(0.0, -12.0), rho=0.9),
            [CRANK.format("as designed", "take all", "a couple of 6.099 N·m") + ALONE],
        ),
        # half of 200 N against 100 N that stand 60° from the pins leaves 100 N
        (
            dict(forward=(cmath.rect(100.0, math.pi / 3), 0.0), whole=(-200.0, 0.0)),
            [CRANK.format("as designed", TURNED_AWAY.format("a force of 100 N", 60), "a force of 100 N") + ALONE],
        ),
        # what pulley and flywheel shall supply
        (dict(webs=lacking(50.1, 0.0), kappa=0.4), [SUPPLY.format("a force of 50.1 N")]),
        (dict(webs=lacking(0.0, 5.01), kappa=0.4), [SUPPLY.format("a couple of 5.01 N·m")]),
        (dict(webs=lacking(49.9, 4.99)), [NONE]),
        (dict(webs=lacking(0.0, 5.01, given=1.0)), [NONE]),
        (dict(webs=WebsResult()), [NONE]),
    ],
)
def test_the_remedies_that_are_proposed(engine, sentences):
    assert proposed(**engine) == tuple(sentences)


@pytest.mark.parametrize("away, opposite", [(60, True), (120, False)])
def test_no_counterweights_opposite_the_pins_are_proposed_that_make_it_worse(away, opposite):
    """Half of 20 N·m against 10 N·m that offsets have turned from the pins: at 60° 10 N·m are left, at 120° 17.3."""
    turned = cmath.rect(10.0, math.radians(away))
    told = str(proposed(forward=(0.0, turned), whole=(0.0, -20.0), offsets_differ=True)[0])
    assert ("for half of the reciprocating mass" in told, "a couple of 17.32 N·m" in told) == (opposite, not opposite)
    assert "10 N·m" in told
