# SPDX-License-Identifier: Apache-2.0
"""Every check of a seat: just inside its limit, just outside, and with a housing whose temperature is not given."""

import math
from dataclasses import replace

import pytest

from calc.bearings.inputs import BearingsInputs
from calc.bearings.plain.seats.checks import seat_checks, unknown_check
from calc.bearings.plain.seats.result import PairResult, SelectResult, Temperatures
from calc.bearings.plain.seats.rings import Rings
from calc.bearings.plain.seats.seat import seated
from calc.bearings.plain.seats.stack import stack_of
from calc.countershaft.rows import BearingRow
from calc.design.toml_file import design
from calc.solve import solve
from tests.calc.bearings.plain.test_seat_classes import PICK, WALLS, classes
from tests.calc.bearings.plain.test_seat_inputs import document
from tests.calc.bearings.plain.test_seats import MPA, SOLIDS, UM

STRIP, ALUMINIUM = SOLIDS["strip"], SOLIDS["EN AC-43100"]
ROW = BearingRow(name="front", diameter=28e-3, length=18e-3, seat="shells", interference=(30e-6, 42e-6))
PIN = replace(ROW, retained="pin")
BAND = (24e-6, 46e-6)


def seat_in(housing=ALUMINIUM, backing=STRIP, *, cool=None, chosen=False, **numbers):
    """`cool`: with a housing whose temperature is not given."""
    rings = Rings(backing, housing, 1.49e-3, 0.0, 20.0, (30e-6, 42e-6), chosen=chosen)
    at = Temperatures(-20.0, 20.0, 110.0, 110.0, cool)
    return replace(seated(rings, ROW, 32e-6, 2473.0, 100.0, 890.0, at), **numbers)


def made(seat, row=ROW, select=None, band=None):
    return {c.id.removeprefix("bearings.front."): c for c in seat_checks("front", row, seat, select, band)}


INSIDE = {"limit": "warn", "caution": "pass"}  # a limit that just holds is narrow
OUTSIDE = {"limit": "fail", "caution": "warn"}
TABLE = [
    # check, kind, row, how its value comes, just inside, just outside, the limit as shown
    ("seat_press", "caution", ROW, lambda x: seat_in(press_hot=x, press_needed=5e6), 5.01e6, 4.99e6, 5.0),
    ("seat_fretting", "caution", PIN, lambda x: seat_in(press_hot=x, press_needed=5e6), 5.01e6, 4.99e6, 5.0),
    ("seat_turn", "limit", ROW, lambda x: seat_in(holding_torque=x, drag_torque=0.1), 0.201, 0.199, 0.2),
    ("seat_stress", "limit", ROW, lambda x: seat_in(housing_stress=x), 179e6, 181e6, 180.0),
    ("seat_stress", "limit", ROW, lambda x: seat_in(SOLIDS["EN-GJL-250"], tension=x), 249e6, 251e6, 250.0),
    ("bush_stress", "caution", ROW, lambda x: seat_in(bush_stress=-x), 299e6, 301e6, 300.0),
    ("bush_stress", "caution", PIN, lambda x: seat_in(backing=SOLIDS["CuSn10P"], bush_stress=-x), 169e6, 171e6, 170.0),
]


@pytest.mark.parametrize(("key", "kind", "row", "changed", "inside", "outside", "limit"), TABLE)
def test_a_check_holds_just_inside_its_limit_and_not_just_outside(key, kind, row, changed, inside, outside, limit):
    kept, missed = made(changed(inside), row)[key], made(changed(outside), row)[key]
    assert (kept.kind, kept.verdict, missed.verdict) == (kind, INSIDE[kind], OUTSIDE[kind])
    assert kept.limit == pytest.approx(limit) and missed.advice and kept.source and "front" in str(kept.name)
    assert not kept.missing and not missed.missing


def test_what_the_housing_bears_is_its_proof_stress_else_its_tensile_strength_else_that_of_weak_steel():
    proof, tension = made(seat_in())["seat_stress"], made(seat_in(SOLIDS["EN-GJL-250"]))["seat_stress"]
    assert "proof stress of EN AC-43100" in str(proof.source) and "tensile strength" in str(tension.source)
    over, under = (made(seat_in(SOLIDS["steel"], housing_stress=x * MPA))["seat_stress"] for x in (236, 234))
    assert (over.limit, over.verdict, over.at_best) == (235.0, "not_verified", "holds")
    assert under.verdict == "warn" and under.missing == over.missing == ("material.proof_stress_MPa",)


def test_an_interference_that_was_chosen_to_hold_is_not_judged_for_that():
    assert not {"seat_press", "seat_turn", "seat_fretting"} & set(made(seat_in(chosen=True)))
    assert {"seat_stress", "bush_stress"} <= set(made(seat_in(chosen=True)))


def test_a_pin_holds_what_no_press_does():
    loose = dict(press_hot=0.0, holding_torque=0.0)
    assert "seat_turn" not in made(seat_in(**loose), PIN) and "seat_press" not in made(seat_in(**loose), PIN)
    assert made(seat_in(**loose), PIN)["seat_fretting"].verdict == "warn"
    assert (
        made(seat_in(**loose))["seat_turn"].verdict == "fail" and made(seat_in(**loose))["seat_press"].verdict == "warn"
    )


@pytest.mark.parametrize(
    ("hot", "cool", "press", "turn"),
    [
        # what it holds at the worst and at the best end, over what is needed
        (1.1, 1.5, "pass", "pass"),
        (0.9, 1.1, "not_verified", "not_verified"),
        (0.5, 0.9, "warn", "fail"),
        (0.0, 1.1, "not_verified", "not_verified"),
        (0.0, 0.9, "warn", "fail"),
        (0.0, 0.0, "warn", "fail"),
    ],
)
def test_a_housing_whose_temperature_is_not_given_is_as_warm_as_the_film_or_as_cool_as_the_oil(hot, cool, press, turn):
    need = 5e6
    torque = 0.10 * need * math.pi * seat_in().rings.fit(ROW.diameter, 32e-6).d_o ** 2 * ROW.length / 2
    seat = seat_in(
        cool=100.0,
        press_needed=need,
        press_hot=hot * need,
        press_hot_cool=cool * need,
        holding_torque=hot * torque,
        drag_torque=torque / 2,
    )
    found = made(seat)
    assert (found["seat_press"].verdict, found["seat_turn"].verdict) == (press, turn)
    assert made(seat, PIN)["seat_fretting"].verdict == press
    for key, ends in (("seat_press", (need / MPA)), ("seat_turn", torque)):
        check = found[key]
        assert check.missing == ("bearings.housing_temperature_C",)
        assert (check.at_worst, check.at_best) == pytest.approx((hot * ends, cool * ends), rel=1e-6)
        assert "110 °C" in str(check.taken[0])


@pytest.mark.parametrize(
    ("band", "verdict", "pair"),
    [((23.0, 46.0), "pass", None), ((23.1, 46.0), "warn", (1, 1)), ((23.0, 45.9), "warn", (1, 2))],
)
def test_every_pair_of_classes_lies_within_the_clearance_that_was_asked_for(band, verdict, pair):
    """A bore that does not give way: 23 to 46 µm."""
    rigid = replace(seat_in().rings, interference=(0.0, 0.0))
    stack = stack_of(ROW, classes(walls_mm=WALLS, pick=PICK))
    ends = {pair: stack.of_pair(pair, rigid) for pair in stack.pairs}
    pairs = {f"{i}_{j}": PairResult(min=least, max=most) for (i, j), (least, most) in ends.items()}
    select = SelectResult(inserts=3.0, pair=pairs)
    within = tuple(g * UM * (1 + e) for g, e in zip(band, (-1e-9, 1e-9)))
    check = made(None, select=select, band=within)["select"]
    assert (check.kind, check.verdict) == ("caution", verdict)
    if pair is not None:
        assert "bore class {} with journal class {}".format(*pair) in str(check.name)
    assert "select" not in made(None, select=select) and "select" not in made(None, band=BAND)


def test_shells_hold_themselves_by_their_spread():
    for spread, verdict in ((1e-6, "pass"), (0.0, "note"), (-1e-6, "note")):
        check = made(None, replace(ROW, spread=spread))["spread"]
        assert (check.kind, check.verdict) == ("advice", verdict)
    assert made(None, replace(ROW, spread=50e-6))["spread"].margin == pytest.approx(0.5)
    assert "spread" not in made(None)


def test_a_carrier_goes_into_its_bore():
    """Exact: with nothing between them it just does."""
    for most, verdict in ((41.995, "pass"), (42.0, "pass"), (42.001, "fail")):
        check = made(None, replace(ROW, carrier_bore=(0.042, 0.042016), carrier=(0.041975, most * 1e-3)))[
            "bore_clearance"
        ]
        assert (check.kind, check.verdict) == ("limit", verdict)
        assert check.value == pytest.approx((42.0 - most) * 1e3, abs=1e-9)
    assert "bore_clearance" not in made(None, replace(ROW, carrier_bore=(0.042,)))


def test_a_bush_of_unknown_wall_is_told_where_its_wall_matters():
    inputs = BearingsInputs(
        oil="SAE 30",
        supply_temperature=100.0,
        supply_pressure=3e5,
        supply="hole",
        hole_diameter=3e-3,
        housing_material="EN AC-43100",
        bush_material="AlSn20Cu",
    )
    direct = replace(ROW, seat="direct", interference=None)
    bore = 28e-3 + 40e-6
    rings = Rings(STRIP, ALUMINIUM, 2e-3, 0.0, 20.0, (0.0, 0.0))
    fit = rings.fit(28e-3, 40e-6)
    s = rings.pressed(fit, 1e-6).c / 1e-6
    less = bore * ((21.5 - 11.5) - s * fit.d_o / fit.d_i * (21.5 - 11.5)) * 1e-6 * 90  # µm·1e-6
    for clearance, verdict in ((less / 0.05 * 1.01, "pass"), (less / 0.05 * 0.99, "note")):
        check = unknown_check("front", direct, ALUMINIUM, inputs, clearance, 110.0)
        assert (check.kind, check.verdict) == ("method", verdict)
    assert check.value == pytest.approx(less / UM, rel=2e-2)
    assert unknown_check("front", ROW, ALUMINIUM, inputs, 40e-6, 110.0) is None
    assert unknown_check("front", direct, ALUMINIUM, replace(inputs, bush_material=None), 40e-6, 110.0) is None
    iron = unknown_check("front", direct, SOLIDS["EN-GJL-250"], inputs, 40e-6, 110.0)
    assert iron.verdict == "pass", "it grows as steel does"


# --- in whole designs


def checks_of(made_):
    results = solve(design(made_))
    return {c.id.removeprefix("bearings."): c for c in results.checks()}


def test_which_checks_a_seat_has():
    found = checks_of(document())
    for place in ("front", "rear"):  # what holds it was chosen
        here = {key.partition(".")[2] for key in found if key.startswith(place)}
        assert {"seat_stress", "bush_stress"} <= here and not {"seat_press", "seat_turn", "seat_fretting"} & here
        assert not {"seat_unknown", "spread", "bore_clearance", "fit"} & here
    assert "front.select" in found and "rear.select" not in found
    held = checks_of(document(rear={"interference_um": [30, 45]}, front={"crush_um": [30, 45], "retained": "pin"}))
    assert {"rear.seat_press", "rear.seat_turn", "front.seat_fretting"} <= set(held)
    assert "front.seat_turn" not in held and "front.seat_press" not in held


@pytest.mark.parametrize(
    "place, key, least", [("rear", "interference_um", 25), ("front", "interference_um", 25), ("front", "crush_um", 42)]
)
def test_so_much_more_interference_holds_the_bush(place, key, least):
    """What the check on its press asks for, done; shells by their crush, where that is given."""
    fields = {place: {key: [least, least + 15]}, "housing_temperature_C": 110.0}
    check = checks_of(document(**fields))[f"{place}.seat_press"]
    assert check.verdict == "warn" and not check.missing
    (((changed, ends),),) = (way.changes for way in check.remedies)
    assert changed == f"shafts.shaft.bearings.{place}.{key}" and ends[1] - ends[0] == 15
    tighter = checks_of(document(**{**fields, place: {key: ends}}))[f"{place}.seat_press"]
    assert tighter.verdict == "pass"
    short = checks_of(document(**{**fields, place: {key: [end - 2 for end in ends]}}))[f"{place}.seat_press"]
    assert short.verdict == "warn", "and no more than that"


def test_so_much_more_interference_keeps_the_bush_from_turning():
    """Of one that has come loose: less than what keeps it shut."""
    fields = {"rear": {"interference_um": [20, 35]}, "housing_temperature_C": 105.0}
    found = checks_of(document(**fields))
    turn, press = found["rear.seat_turn"], found["rear.seat_press"]
    (((key, ends),),) = (way.changes for way in turn.remedies)
    (((_, shut),),) = (way.changes for way in press.remedies)
    assert key == "shafts.shaft.bearings.rear.interference_um" and 20 < ends[0] < shut[0] and turn.verdict == "fail"
    held = checks_of(document(**{**fields, "rear": {"interference_um": ends}}))["rear.seat_turn"]
    short = checks_of(document(**{**fields, "rear": {"interference_um": [end - 2 for end in ends]}}))["rear.seat_turn"]
    assert held.holds and not short.holds


def test_the_temperature_of_the_housing_decides_whether_the_bush_holds():
    found = {}
    for T in (None, 100.0, 140.0):
        found[T] = checks_of(document(rear={"interference_um": [30, 45]}, housing_temperature_C=T))["rear.seat_press"]
    assert found[None].missing == ("bearings.housing_temperature_C",)
    assert found[None].at_best == pytest.approx(found[100.0].value, rel=0.1), "the oil comes at 100 °C"
    assert found[100.0].value > found[None].value > found[140.0].value and not found[100.0].missing
