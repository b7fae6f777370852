"""Two shafts at ±2 beneath an inline four on its mounts: by hand, with one tooth off, and which of them is the worst."""

import cmath
import math
from dataclasses import replace

import numpy as np
import pytest

from calc.design.toml_file import Document, design, load, read
from calc.mounting.solve import solve as on_mounts
from calc.mounting.wrenches import ShaftOnEngine, drive
from calc.solve import solve
from tests.conftest import DESIGNS, SCREENED

TAU = 2 * math.pi / 24
F = -4268.1 + 0j  # of the left shaft; both carry no couple
LEFT = ShaftOnEngine("left", 2.0, F, 0j, -0.06 - 0.095j, TAU)
RIGHT = ShaftOnEngine("right", -2.0, F, 0j, -0.06 + 0.095j, TAU, mirrors="left")
LEVELS = ("work.{}.seat.weighted", "rated.{}.top-front.velocity")


@pytest.fixture(scope="module")
def four():
    """The mounts, the engine, and what the steps before give, with moments about the crank's axis."""
    _, made = load(DESIGNS / f"{SCREENED}.toml")
    mounting = load(DESIGNS / "r753ie4_mounting.toml")[1].mounting
    outcomes = solve(made).outcomes
    before = outcomes["engine"].result, outcomes["imbalance"].result
    return replace(mounting, centre_of_gravity=(0.0, 0.0, 0.0)), made.engine, *before


def order_2(driven, variant):
    return driven.inertia[driven.variants.index(variant), list(driven.orders).index(2.0)]


def test_two_shafts_take_the_vertical_force_and_roll_nothing(four):
    driven = drive(*four, (LEFT, RIGHT))
    taken = order_2(driven, "shaft") - order_2(driven, "half")
    assert taken == pytest.approx([2 * F, 0, 0, 0, 0, 0], abs=1e-9 * abs(F))


def test_at_unequal_heights_their_sideways_forces_roll(four):
    high = replace(RIGHT, axis=RIGHT.axis + 0.15)
    taken = order_2(driven := drive(*four, (LEFT, high)), "shaft") - order_2(driven, "half")
    assert taken == pytest.approx([2 * F, 0, 0, 0, 0, 1j * abs(F) * -0.15], abs=1e-9 * abs(F))


def test_shafts_of_two_orders_act_at_their_own(four):
    first = ShaftOnEngine("first", -1.0, 300j, 50 + 20j, None)
    driven = drive(*four, (LEFT, first))
    assert driven.taken == (1.0, 2.0) and len(driven.apart) == 2
    n = list(driven.orders).index(1.0)
    taken = driven.inertia[driven.variants.index("shaft"), n] - driven.inertia[driven.variants.index("half"), n]
    F_b, C_b = (300j).conjugate(), (50 + 20j).conjugate()  # it turns backward
    assert taken == pytest.approx([F_b, 1j * F_b, 0, -1j * C_b, C_b, 0])


def test_as_they_scatter_each_has_its_own_errors(four):
    s, delta = 0.02, 0.03
    driven = drive(*four, (replace(LEFT, errors=(s, delta)), RIGHT))
    taken = order_2(driven, "scatter") - order_2(driven, "shaft")
    late = F * (cmath.exp(-1j * delta) - 1)
    assert taken[:2] == pytest.approx([late, -1j * late])


def test_every_row_of_one_tooth_off_is_there(four):
    driven = drive(*four, (LEFT, RIGHT))
    assert [str(row.words) for row in driven.off.values()] == [
        f"{which}, one tooth {sense}"
        for which in ("left", "right", "left and its mirror image")
        for sense in ("late", "early")
    ]
    single = ShaftOnEngine("single", -1.0, 10 + 0j, 0j, None, 0.1)
    assert len(drive(*four, (LEFT, RIGHT, single)).off) == 10
    assert len(drive(*four, (LEFT, replace(RIGHT, tooth=None))).off) == 2


@pytest.mark.parametrize("level", LEVELS)
def test_the_worst_tooth_is_that_of_the_row_solved_by_itself(four, level):
    """The shafts turned by hand, each case solved as a design of its own."""
    mounting, engine, e, imbalance = four
    both = on_mounts(mounting, engine, e, imbalance, (LEFT, RIGHT)).result
    cases = []
    for left, right in ((1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (-1, -1)):
        # late is e^(−iδ) with the crank, e^(+iδ) against it
        turned = (
            replace(LEFT, force=F * cmath.exp(-1j * left * TAU)),
            replace(RIGHT, force=F * cmath.exp(1j * right * TAU)),
        )
        by_hand = on_mounts(mounting, engine, e, imbalance, turned).result
        cases.append(by_hand.leaf(level.format("shaft")))
    found = both.leaf(level.format("tooth"))
    rows = list(both.teeth[level.split(".")[0]].values())
    assert len(rows) == len(cases) and max(cases) > 1.05 * min(cases)
    assert found == pytest.approx(max(cases), rel=1e-12)
    _, _, point, name = level.split(".")
    assert [getattr(row[point], name) for row in rows] == pytest.approx(cases, rel=1e-12)


def test_the_design_of_two_shafts_says_which_tooth_is_the_worst(four):
    mounting, engine, e, imbalance = four
    outcome = on_mounts(mounting, engine, e, imbalance, (LEFT, RIGHT))
    result = outcome.result
    worst = max(result.teeth["rated"], key=lambda row: result.teeth["rated"][row]["seat"].weighted)
    words = f"One tooth off, at rated the worst at the seat is: {result.drive.off[worst].words}."
    assert words in [str(note) for note in outcome.notes]
    table = next(table for table in outcome.tables if table.id == "felt_teeth")
    assert len(table.rows) == 6 * len(result.speeds)
    assert "The shafts take what the masses have of order 2" in str(outcome.reason)
    day = {row: result.exposure[row]["whole_body"].number for row in ("half", "shaft", "tooth")}
    assert day["shaft"] < day["tooth"]
    course = result.courses["seat"]
    assert course.variants == ("bare", "half", "shaft", "tooth") and course.total.shape[0] == 4
    assert np.all(course.total[3] >= course.total[2] * (1 - 1e-12))


def test_a_pair_is_two_shafts_on_the_mounts():
    data = dict(read(DESIGNS / f"{SCREENED}.toml").data)
    data["shafts"] = [dict(data["shafts"][0], axis_mm=[-60.0, -95.0]), *data["shafts"][1:]]
    other = read(DESIGNS / "r753ie4_mounting.toml").data
    data["engine"], data["mounting"] = data["engine"] | {"gas": other["engine"]["gas"]}, other["mounting"]
    made = solve(design(Document(data))).outcomes["mounting"].result
    first, twin = made.drive.shafts
    assert (twin.ratio, twin.axis, twin.mirrors) == (-first.ratio, first.axis.conjugate(), first.name)
    assert (twin.force, twin.couple) == (first.force.conjugate(), first.couple.conjugate())
    assert twin.errors == (pytest.approx(0.006), pytest.approx(math.radians(1.0)))
    assert not made.drive.off  # no wheels
