"""What all shafts together leave: just inside each limit and just outside, what would leave less, figures."""

import copy
import re
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from calc.countershaft import left_over
from calc.countershaft.sums import SystemShaft
from calc.design.toml_file import Document, design
from calc.sheet.check import CheckRule
from calc.solve import solve
from tests.calc.countershaft.systems import document, shafts
from tests.calc.countershaft.systems import engine as vectors

OMEGA = 300.0


def engine(like=(0j, 0j), against=(0j, 0j), second=((0j, 0j), (0j, 0j)), ratio=-1):
    """An engine of 1000 N·m and 1000 N by one cylinder: couple and force of the order of a shaft of this ratio, of what
    turns like it and against it; `second`: those of the second order beside a shaft of the first."""
    orders = {f"order_{n}": (0j, 0j, 0j, 0j) for n in (1, 2)}
    for n, ((C, F), (C_against, F_against)), sense in ((2, second, 1), (abs(ratio), (like, against), ratio)):
        forces, couples = (F, F_against), (C, C_against)
        order = 1 if sense > 0 else -1  # forward first
        orders[f"order_{n}"] = (*forces[::order], *couples[::order])
    vectors = {name: SimpleNamespace(vectors=of) for name, of in orders.items()}
    return SimpleNamespace(orders=vectors, one_force=1000.0, one_couple=1000.0)


def shaft(couple=0j, force=0j, ratio=-1, name="shaft", **places):
    return SystemShaft(name, ratio, complex(force), complex(couple), **places)


def judged(of, *shafts, rolls=None):
    """The checks of an engine with its shafts, by their ids; `rolls`: of its inertia, by order."""
    made = left_over.solve(of, shafts, rolls or {}, OMEGA).checks
    return {check.id.removeprefix("countershaft."): check for check in made}


def left(id, couple=0.0, force=0.0, before=(0j, 0j), ratio=-1):
    """Where the shaft takes all of the engine's couple and force `before`, but for so much."""
    C, F = before
    return judged(engine((C, F), ratio=ratio), shaft(-C + couple, -F + force, ratio))[id]


def second(id, couple=0.0, force=0.0, before=(0j, 0j)):
    """The same of the second order, beside a shaft that takes the first."""
    C, F = before
    of = engine(second=((C, F), (0j, 0j)))
    return judged(of, shaft(name="first"), shaft(-C + couple, -F + force, 2, "second"))[id]


def rolling(id, up):
    """1000 N at a height beside a roll of 100 N·m: of the first order, or of the second beside a shaft of the first."""
    turning = shaft(force=1000.0, ratio=-1 if id == "roll" else 2, name="high", axis=up + 0j)
    first = () if id == "roll" else (shaft(name="first", axis=0j),)
    return judged(engine(), *first, turning, rolls={1: 100j, 2: 100j})[id]


# "5 % of the couple to be balanced", "5 % of m·r·ω² of one cylinder"
FORCE_BEFORE, COUPLE_BEFORE = (0j, 200j), (200j, 0j)
CASES = [
    ("residual", "fail", 50.0, "5 %", left, dict(couple=49.9), dict(couple=50.1)),
    ("residual", "fail", 40.0, "5 %", left, dict(couple=39.9, before=(800j, 0j)), dict(couple=40.1, before=(800j, 0j))),
    ("residual_force", "fail", 50.0, "one cylinder", left, dict(force=49.9), dict(force=50.1)),
    (
        "residual_share",
        "note",
        10.0,
        "5 %",
        left,
        dict(couple=9.9, ratio=2, before=COUPLE_BEFORE),
        dict(couple=10.1, ratio=2, before=COUPLE_BEFORE),
    ),
    (
        "residual_force_share",
        "note",
        50.0,
        "one cylinder",
        left,
        dict(force=49.9, ratio=2, before=FORCE_BEFORE),
        dict(force=50.1, ratio=2, before=FORCE_BEFORE),
    ),
    (
        "residual_2",
        "note",
        10.0,
        "5 %",
        second,
        dict(couple=9.9, before=COUPLE_BEFORE),
        dict(couple=10.1, before=COUPLE_BEFORE),
    ),
    (
        "residual_force_2",
        "note",
        50.0,
        "one cylinder",
        second,
        dict(force=49.9, before=FORCE_BEFORE),
        dict(force=50.1, before=FORCE_BEFORE),
    ),
    (
        "residual_2_worse",
        "fail",
        200.0,
        "5 %",
        second,
        dict(couple=199.9, before=COUPLE_BEFORE),
        dict(couple=200.1, before=COUPLE_BEFORE),
    ),
    (
        "residual_force_2_worse",
        "fail",
        200.0,
        "one cylinder",
        second,
        dict(force=199.9, before=FORCE_BEFORE),
        dict(force=200.1, before=FORCE_BEFORE),
    ),
    ("roll", "note", 100.0, "inertia", rolling, dict(up=-0.1999), dict(up=-0.2001)),
    ("roll_2", "note", 100.0, "inertia", rolling, dict(up=0.1999), dict(up=0.2001)),
]


@pytest.mark.parametrize("id, beyond, limit, quote, made, inside, outside", CASES)
def test_it_holds_just_inside_and_not_outside(id, beyond, limit, quote, made, inside, outside):
    check = made(id, **outside)
    assert check.id == f"countershaft.{id}" and check.verdict == beyond and not check.holds
    assert check.limit == pytest.approx(limit) and quote in str(check.source)
    assert check.advice and check.name and check.rule.why.endswith(".")
    assert made(id, **inside).holds and made(id, **inside).limit == pytest.approx(limit)


def test_every_check_has_its_case():
    declared = {rule.id for rule in vars(left_over).values() if isinstance(rule, CheckRule)}
    assert {f"countershaft.{id}" for id, *_ in CASES} == declared


def test_a_shaft_of_the_second_order_that_takes_a_part_is_advised_and_one_that_makes_it_worse_fails():
    """200 N before: 150 and 200 are a part, or nothing at all; beyond it is worse."""
    for force in (150.0, 200.0):
        assert left("residual_force_share", force=force, ratio=2, before=FORCE_BEFORE).verdict == "note"
    worse = left("residual_force", force=200.1, ratio=2, before=FORCE_BEFORE)
    assert (worse.verdict, worse.kind, worse.value_id) == ("fail", "limit", "countershaft.residual_order_2_force")
    # where nothing is to be balanced it may still leave 5 %
    assert left("residual_share", couple=49.0, ratio=2).verdict == "pass"
    assert left("residual", couple=51.0, ratio=2).verdict == "fail"
    assert second("residual_2_worse", couple=49.0).holds


def test_what_turns_against_the_shaft_counts_before_it_too():
    """30 + 170 before; 199 left is no worse."""
    force = engine((0j, 30j), (0j, 170j), ratio=2)
    assert judged(force, shaft(force=-1j, ratio=2))["residual_force_share"].verdict == "note"
    assert judged(force, shaft(force=1j, ratio=2))["residual_force"].verdict == "fail"
    couple = engine((30j, 0j), (170j, 0j), ratio=2)
    assert judged(couple, shaft(couple=-1j, ratio=2))["residual_share"].verdict == "note"
    assert judged(couple, shaft(couple=1j, ratio=2))["residual"].verdict == "fail"


def test_of_two_orders_the_lower_one_is_what_the_shafts_are_for():
    made = judged(engine(), shaft(name="first"), shaft(ratio=2, name="second"))
    assert list(made) == [
        "residual",
        "residual_force",
        "residual_2",
        "residual_2_worse",
        "residual_force_2",
        "residual_force_2_worse",
    ]
    names = [str(check.name) for check in made.values()]
    assert names[0] == "First-order couple left over" and names[2] == "Second-order couple left over"
    assert made["residual_force_2"].value_id == "countershaft.residual_order_2_force"
    assert list(judged(engine(ratio=2), shaft(ratio=2))) == ["residual_share", "residual_force_share"]


# --- what would leave less

AIM = "Aim at {} at {}°: the {} of {} grows with mass{}"
REACH = "{} turn against the shaft, and no mass on it takes them: "
CRANK = REACH + "that is for the counterweights of the crank (see the imbalance)."
SECOND_SHAFT = REACH + "a mirrored second shaft does (mirrors)."
ALIKE = "Balance the masses against each other (mass times radius), so that only a couple remains."
COUPLE = AIM.format("800.0 N·m", "−90.0", "couple", "{}", ", radius and arm.")
FORCE = AIM.format("900 N", "0.0", "force", "the shaft", " and radius.")


@pytest.mark.parametrize(
    "against, kept, ratio, advice",
    [
        (0j, 50.0, -1, COUPLE.format("the shaft")),
        # 5 % of 800 N·m may be left, on either side
        (39j, 11.0, -1, COUPLE.format("the shaft")),
        (100j, 39.0, -1, CRANK.format("100 N·m")),
        (100j, 41.0, -1, COUPLE.format("the shaft") + " " + CRANK.format("100 N·m")),
        (100j, 39.0, -2, SECOND_SHAFT.format("100 N·m")),
        (100j, 39.0, 1, SECOND_SHAFT.format("100 N·m")),
    ],
)
def test_what_would_leave_less_of_the_couple(against, kept, ratio, advice):
    made = judged(engine((800j, 0j), (against, 0j), ratio=ratio), shaft(-800j + kept, ratio=ratio))
    check = made["residual" if abs(ratio) == 1 else "residual_share"]
    assert check.limit == pytest.approx(40.0) and check.advice == advice
    assert check.value == pytest.approx(abs(against) + kept)


@pytest.mark.parametrize("ratio", [-1, 1, 2])
def test_a_mirrored_pair_takes_both_senses(ratio):
    """Each the vector of its own sense, which are mirror images; nothing is out of its reach."""
    one = shaft(-800j + 25, ratio=ratio)
    made = judged(engine((800j, 0j), (-800j, 0j), ratio=ratio), one, one.mirror_image("twin"))
    check = made["residual" if abs(ratio) == 1 else "residual_share"]
    assert check.value == pytest.approx(50.0) and check.advice == COUPLE.format("each of both shafts")


def test_shafts_that_turn_alike_take_one_vector_together():
    made = judged(engine((800j, 0j), (100j, 0j)), shaft(-400j + 41, name="left"), shaft(-400j, name="right"))
    together = COUPLE.format("the 2 shafts that turn alike, together,")
    assert made["residual"].value == pytest.approx(141.0)
    assert made["residual"].advice == together + " " + CRANK.format("100 N·m")


@pytest.mark.parametrize(
    "force, against, kept, advice",
    [
        (-900 + 0j, 0j, 60.0, FORCE),
        (51j, 0j, 60.0, AIM.format("51 N", "−90.0", "force", "the shaft", " and radius.")),
        (49j, 0j, 60.0, ALIKE),
        (-900 + 0j, 100j, 49.0, CRANK.format("100 N")),
        (-900 + 0j, 100j, 51.0, FORCE + " " + CRANK.format("100 N")),
        (49j, 100j, 51.0, ALIKE + " " + CRANK.format("100 N")),
    ],
)
def test_what_would_leave_less_of_the_force(force, against, kept, advice):
    check = judged(engine((0j, force), (0j, against)), shaft(force=-force + kept))["residual_force"]
    assert check.limit == pytest.approx(50.0) and check.advice == advice
    assert check.value == pytest.approx(abs(against) + kept)


def test_the_second_order_beside_the_first_says_its_own_aim():
    check = second("residual_force_2", force=60.0, before=(0j, -900 + 0j))
    assert check.advice == AIM.format("900 N", "0.0", "force", "the shaft", " and radius.")


# --- the roll about the crank


def of_system(case, moved=0.0):
    """The roll check of a given pair; `moved`: the shaft that turns with the crank higher, the other one lower."""
    orders, _ = vectors(case)
    of = SimpleNamespace(
        orders={f"order_{n}": SimpleNamespace(vectors=(*v.forces, *v.couples)) for n, v in orders.items()},
        one_force=1000.0,
        one_couple=1000.0,
    )
    placed = [replace(one, axis=one.axis + (moved if one.forward else -moved)) for one in shafts(case)]
    return judged(of, *placed, rolls={n: v.roll for n, v in orders.items()})["roll"]


def test_the_given_pairs_leave_no_more_roll_than_the_engine_has():
    level, silent = of_system("r754"), of_system("i4-silent")
    assert (level.value, level.limit) == pytest.approx((842.1439177, 842.1439177)) and level.verdict == "pass"
    assert (silent.value, silent.limit) == pytest.approx((269.2350604, 932.68), rel=1e-5) and silent.holds
    assert silent.value_id == "countershaft.roll_left_order_2" and silent.name == "Second-order roll left over"


@pytest.mark.parametrize("case, one, other", [("r754", "left", "right"), ("i4-silent", "high", "low")])
def test_the_heights_of_the_least_roll_are_told(case, one, other):
    """i·A·(h₊ − h₋): what the advice says is left there, and each millimetre off leaves more."""
    words = str(of_system(case).advice)
    told = re.fullmatch(
        rf"The least roll, (\S+) N·m, is left with {one} (\S+) mm higher and {other} \2 mm lower\.", words
    )
    least, by = float(told[1]), float(told[2]) * 1e-3
    assert of_system(case, by).value == pytest.approx(least, abs=5.0)  # the height is told to 1 mm
    assert least < of_system(case, by - 5e-3).value and least < of_system(case, by + 5e-3).value
    worse = of_system(case, -0.05)
    assert worse.verdict == ("note" if case == "r754" else "pass") and "mm higher" in worse.advice


def test_the_other_side_is_told_where_it_leaves_less():
    """1000 N at 50 mm beside the crank raise 50 N·m, on the other side as much against what the engine has."""
    beside = judged(engine(), shaft(force=1000.0, axis=-0.05j), rolls={1: 100 + 0j})["roll"]
    assert beside.value == pytest.approx(150.0) and beside.verdict == "note"
    assert beside.advice == "On the other side of the crank 50.0 N·m are left."
    no_better = judged(engine(), shaft(force=1000.0, axis=-0.05j), rolls={1: 10 + 0j})["roll"]
    assert str(no_better.advice).startswith("On the other side of the crank 40.0 N·m are left. The nearer the axes are")
    best = judged(engine(), shaft(force=1000.0, axis=0.05j), rolls={1: 100 + 0j})["roll"]
    assert best.holds and not best.advice  # nearer axes would take less of the engine's


def test_a_roll_that_nobody_knows_or_that_no_force_raises_is_not_judged():
    placed = shaft(force=1000.0, axis=0.1 + 0j)
    assert "roll" in judged(engine(), placed, rolls={1: 100j})
    assert "roll" not in judged(engine(), placed)
    assert "roll" not in judged(engine(), replace(placed, axis=None), rolls={1: 100j})
    assert "roll" not in judged(engine(), shaft(500.0, axis=0.1 + 0j), rolls={1: 100j})


# --- figures


def curves(of, *shafts):
    return {curve.id: curve for curve in left_over.solve(of, shafts, {}, OMEGA).curves}


def test_what_is_next_to_nothing_is_not_drawn():
    assert curves(engine(), shaft()) == {}
    assert list(curves(engine((800j, 0j)), shaft(-700j))) == ["residual_couple_over_speed", "residual"]
    assert list(curves(engine((0j, 800j)), shaft(force=-700j))) == ["residual_force_over_speed", "residual_force"]
    # a couple that the shafts bring in themselves
    assert list(curves(engine(), shaft(100j))) == ["residual_couple_over_speed", "residual"]


def test_each_order_has_its_own_figures():
    of = engine((800j, 0j), second=((0j, 900j), (0j, 300j)))
    made = curves(of, shaft(-790j), shaft(force=-600j, ratio=2, name="second"))
    residual = ["residual_couple_over_speed", "residual_force_over_speed_2", "residual", "residual_force_2"]
    assert [id for id in made if id.startswith("residual")] == residual
    over = made["residual_force_over_speed_2"]
    assert str(over.title).startswith("Second-order force") and over.limits[0][1] == pytest.approx(50.0)
    rated = OMEGA * 60 / (2 * np.pi)
    assert [str(series.label) for series in over.series] == ["without shafts", "as designed"]
    for series, peak in zip(over.series, (1200.0, 600.0)):
        assert series.x.size == 21 and series.x[[0, -1]] == pytest.approx([rated / 5, rated])
        assert series.y == pytest.approx(peak * (series.x / rated) ** 2)
    locus = made["residual_force_2"]
    assert locus.equal and locus.along[1][-1] == pytest.approx(180.0)  # twice a turn
    for series, ends in zip(locus.series, ((1200.0, 600.0), (600.0, 0.0))):
        lengths = np.hypot(series.x, series.y)
        assert (lengths.max(), lengths.min()) == pytest.approx(ends, rel=1e-3, abs=1e-9)


def test_over_speed_each_shaft_one_tooth_off_stands_beside_the_others():
    """A pair of mirror images leaves the same, and is one line; the first order has its own shaft."""
    of = engine((800j, 0j), second=((0j, 900 + 0j), (0j, 900 + 0j)))
    one = shaft(force=-700 + 0j, ratio=2, name="left", tooth=0.2)
    first = shaft(-790j, name="first", tooth=0.1)
    made = curves(of, one, one.mirror_image("right"), first)
    over = {str(series.label): series.y[-1] for series in made["residual_force_over_speed_2"].series}
    assert list(over) == ["without shafts", "as designed", "left, right one tooth off"]
    off = left_over.teeth_off(left_over.vectors_of(of, (one, first), {}), (one, one.mirror_image("right"), first))
    assert list(over.values()) == pytest.approx([1800.0, 400.0, off.shafts["right"].order_2_force])
    couple = made["residual_couple_over_speed"].series
    assert str(couple[-1].label) == "first one tooth off" and couple[-1].y[-1] > couple[1].y[-1]


# --- one tooth off, and what is made by chance


def test_a_train_without_a_solution_or_shafts_stays_as_it_is():
    nothing = SimpleNamespace(result=None)
    assert left_over.one_tooth_off(nothing, engine(), (shaft(),), {}) is nothing
    train = SimpleNamespace(result=SimpleNamespace())
    assert left_over.one_tooth_off(train, engine(), (), {}) is train


def test_one_tooth_off_stands_beside_the_train_late_and_early():
    results = solve(design(document("v2-45")))
    tables = {table.id: table for table in results.outcomes["gears"].tables}
    rows = [[str(cell) for cell in row[:2]] for row in tables["teeth_off"].rows]
    assert rows == [["front", "1"], ["rear", "1"], ["all shafts", "1"]]
    values = results.values()
    for name, row in zip(("front.tooth", "rear.tooth", "all"), tables["teeth_off"].rows):
        for what, late, early in zip(("force", "couple", "roll"), row[2::2], row[3::2]):
            assert values[f"gears.{name}_late.order_1_{what}"].shown == pytest.approx(max(late, early))


def test_without_a_wheel_nobody_knows_what_a_tooth_leaves():
    data = copy.deepcopy(document("v2-45").data)
    data["gears"]["wheels"].pop()
    data["gears"]["meshes"].pop()
    results = solve(design(Document(data)))
    assert {id for id in results.values() if "_late" in id and id.endswith("force")} == {
        "gears.tooth_late.order_1_force"  # of the only one in the train
    }


def test_shafts_scatter_together_where_one_of_them_does():
    data = copy.deepcopy(document("r754-scatter").data)
    results = solve(design(Document(data)))
    worst = results.values()["countershaft.scatter.order_2_force_95"].shown
    over = next(c for c in results.outcomes["countershaft"].curves if c.id == "residual_force_over_speed")
    assert {str(s.label): s.y[-1] for s in over.series}["95 % of those made"] == pytest.approx(worst)
    del data["shafts"][0]["scatter"]
    assert not any(".scatter." in id for id in solve(design(Document(data))).values())
