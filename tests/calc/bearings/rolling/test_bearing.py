# SPDX-License-Identifier: Apache-2.0
"""Whole rolling bearings by their design file: the given designs, limits, what is the same in another way, what is not
known, and what is refused."""

import json
import math

import numpy as np
import pytest

from calc.bearings.result import BearingsResult
from calc.bearings.rolling.balance import balanced_temperature
from calc.countershaft.result import CountershaftResult
from calc.design.toml_file import Document, design, parse, read
from calc.friction.result import FrictionResult
from calc.sheet.errors import BadInput
from calc.solve import solve
from tests.calc.bearings.documents import on_bearings
from tests.calc.bearings.rolling.typical import BEARINGS, OIL
from tests.conftest import DESIGNS, ROOT

REFERENCE = json.loads((ROOT / "tests/reference/rolling.json").read_text(encoding="utf-8"))
GIVEN = [row for row in REFERENCE["given"] if row["case"] in REFERENCE["designs"]]
TWO, PROFILE = REFERENCE["designs"]
OWN = {"elements": "ball", "bore_mm": [25.0], "outside_diameter_mm": 52.0, "width_mm": 15.0}
RATED = {"dynamic_rating_kN": 14.0, "static_rating_kN": 7.8}


def document(name=TWO):
    return parse(REFERENCE["designs"][name].encode(), f"{name}.toml")


def with_rows(name=TWO, front=None, rear=None, **bearings):
    """A given design with other keys; None takes one out."""
    data = document(name).data
    (shaft,) = data["shafts"]
    rows = [{**row, **(more or {})} for row, more in zip(shaft["bearings"], (front, rear))]
    told = [{key: x for key, x in row.items() if x is not None} for row in rows]
    table = {key: x for key, x in {**data["bearings"], **bearings}.items() if x is not None}
    return Document({**data, "shafts": [{**shaft, "bearings": told}], "bearings": table}, f"{name}.toml")


def solved(*args, **changes):
    return solve(design(with_rows(*args, **changes)))


def front(*args, **changes):
    return solved(*args, **changes).result(BearingsResult).bearings["front"]


def checks(results, place="front"):
    return {
        c.id.removeprefix(f"bearings.{place}."): c for c in results.checks() if c.id.startswith(f"bearings.{place}")
    }


def refused(*args, **changes):
    with pytest.raises(BadInput) as bad:
        solved(*args, **changes)
    return {error.key.rpartition(".")[2]: str(error.reason) for error in bad.value.errors}


@pytest.fixture(scope="module")
def two():
    return solve(design(document()))


# --- against given values
@pytest.fixture(scope="module")
def by_design():
    return {name: solve(design(document(name))).values() for name in REFERENCE["designs"]}


@pytest.mark.parametrize("row", GIVEN, ids=[f"{row['case']}: {row['value']}" for row in GIVEN])
def test_a_given_design(by_design, row):
    assert by_design[row["case"]][row["value"]].shown == pytest.approx(row["is"], rel=row["rel"])


def test_all_given_values_are_asked():
    assert len(GIVEN) == 36


# --- limits
def test_of_a_turning_load_alone_all_means_are_the_load():
    alone = front(front={"standing_load_N": None})
    assert alone.mean_load == alone.friction_load == alone.load
    assert alone.equivalent_load == pytest.approx(alone.ring_factor * alone.load) and 1.0 < alone.ring_factor < 1.05


def test_where_more_stands_than_turns_the_ring_factor_is_1():
    stands = front(front={"load_N": 0.001, "standing_load_N": 1700.0})
    assert stands.ring_factor == 1.0 and stands.equivalent_load == pytest.approx(1700.0)


@pytest.mark.parametrize("size, divisor", [("6305", 8.0), ("NU205", 2 ** (10 / 3))])
def test_a_load_twice_as_large_divides_the_basic_life(size, divisor):
    once, twice = (
        front(front={"size": size, "load_N": k * 800.0, "standing_load_N": k * 90.0}).life_basic for k in (1, 2)
    )
    assert once / twice == pytest.approx(divisor, rel=1e-12)


def test_two_equal_bearings_live_together():
    rear = {"size": "NU205", "load_N": 1706.81, "standing_load_N": 78.2488}
    found = solved(rear=rear).result(BearingsResult)
    assert found.system_life / found.bearings["front"].life == pytest.approx(2 ** (-8 / 9), rel=1e-12)


def test_the_dirtiest_oil_leaves_a_tenth_of_the_life():
    dirty = front(cleanliness="very-severe")
    assert dirty.life_factor == pytest.approx(0.1) and dirty.life == pytest.approx(0.1 * dirty.life_basic)


def test_cleaner_oil_lets_it_live_longer():
    lives = [front(cleanliness=word).life for word in ("very-severe", "severe", "typical", "slight", "normal", "high")]
    assert lives == sorted(lives) and lives[0] < lives[1] < lives[2]
    filtered = [front(cleanliness=word).life for word in ("-/19/16", "-/17/14", "-/15/12", "-/13/10")]
    assert filtered == sorted(filtered)


@pytest.mark.parametrize("percent, a_1", [(90, 1.0), (95, 0.64), (99, 0.25), (99.9, 0.093), (95.5, 0.595)])
def test_reliability(two, percent, a_1):
    before = two.result(BearingsResult).bearings["front"]
    after = front(reliability_percent=percent)
    assert after.life == pytest.approx(a_1 * before.life) and after.life_basic == before.life_basic


def test_nothing_on_it():
    """No life and no division; the least load is not there."""
    results = solved(front={"load_N": 1e-30, "standing_load_N": None})
    bare = results.result(BearingsResult).bearings["front"]
    made = checks(results)
    assert bare.life is None or bare.life > 1e12
    assert made["minimum_load"].verdict == "warn" and bare.minimum_load_speed is None
    assert bare.friction_power > 0


def test_heat_given_off_is_the_friction(two):
    for r in two.result(BearingsResult).bearings.values():
        assert r.friction_power == pytest.approx(2 * math.pi * r.speed * r.torque, rel=1e-9)
        assert r.friction_power == pytest.approx(r.case.heat * (r.running_temperature - 120.0), rel=1e-12)


@pytest.mark.parametrize("size", sorted(BEARINGS))
def test_the_balance_of_heat_is_that_of_halvings(size):
    """Where it is the only one: from oil of 20 °C on, below n·d_m of 500 000."""
    one, random = BEARINGS[size], np.random.default_rng(1)
    F, n, T_oil = 10 ** random.uniform(1, 4, 300), random.uniform(1, 200, 300), random.uniform(20, 150, 300)
    hA, friction = 10 ** random.uniform(-0.5, 1.0, 300), one.friction()
    low, high = T_oil, T_oil + 400
    for _ in range(55):
        middle = (low + high) / 2
        warmer = 2 * np.pi * n * friction.torque(F, n, OIL.nu(middle)) > hA * (middle - T_oil)
        low, high = np.where(warmer, middle, low), np.where(warmer, high, middle)
    found = balanced_temperature(friction, F, n, T_oil, hA, OIL.nu)
    there = high < T_oil + 399.9
    assert there.sum() > 200 and np.array_equal(np.isfinite(found), there)
    assert found[there] == pytest.approx(low[there], abs=1e-8)


# --- the duty
ROWS = [{"name": "idle", "speed_rpm": 900.0, "hours": 1.0}, {"name": "fast", "speed_rpm": 2600.0, "hours": 3.0}]


def test_a_duty_of_the_rated_point_is_that_of_none(two):
    rated, none = front(duty=[{**ROWS[1], "hours": 7.0}]), two.result(BearingsResult).bearings["front"]
    for name in ("life", "life_basic", "life_reference", "duty_loss", "equivalent_load", "friction_power"):
        assert getattr(rated, name) == pytest.approx(getattr(none, name), rel=1e-9), name
    assert rated.duty["fast"].loss == pytest.approx(none.friction_power, rel=1e-9)


def test_rows_add_their_damage_and_their_heat():
    whole = front(duty=ROWS)
    alone = [front(duty=[row]) for row in ROWS]
    assert 1 / whole.life == pytest.approx(0.25 / alone[0].life + 0.75 / alone[1].life, rel=1e-9)
    assert whole.duty_loss == pytest.approx(0.25 * alone[0].duty_loss + 0.75 * alone[1].duty_loss, rel=1e-9)
    assert whole.duty["idle"].loss == pytest.approx(alone[0].duty_loss, rel=1e-9)


def test_the_load_of_a_row_grows_with_the_square_of_its_speed():
    row = front(front={"standing_load_N": None}, duty=ROWS).duty
    assert row["fast"].equivalent_load / row["idle"].equivalent_load == pytest.approx((2600 / 900) ** 2, rel=1e-9)


def test_what_a_row_adds():
    plain = front(duty=ROWS).duty["fast"]
    more = front(duty=[ROWS[0], {**ROWS[1], "load_factor": 2.0}]).duty["fast"]
    extra = front(duty=[ROWS[0], {**ROWS[1], "extra_load_N": 500.0}]).duty["fast"]
    warmer = front(duty=[ROWS[0], {**ROWS[1], "oil_temperature_C": 130.0}]).duty["fast"]
    assert 1.9 < more.equivalent_load / plain.equivalent_load < 2.0
    assert plain.equivalent_load < extra.equivalent_load < plain.equivalent_load + 500.0 * 1.03
    assert warmer.viscosity_ratio < plain.viscosity_ratio and warmer.equivalent_load == plain.equivalent_load


def on_rolling(sizes=("6305", "NU205"), plain=(), **shaft):
    """The source's engine and shaft, its journals on rolling bearings, but for those that stay `plain`."""
    data = read(DESIGNS / "r753ie4_gamma.toml").data
    (old,) = data["shafts"]
    rows = [
        row
        if row["name"] in plain
        else {"name": row["name"], "position_mm": row["position_mm"], "kind": "rolling", "size": size}
        for row, size in zip(old["bearings"], sizes)
    ]
    return Document({**data, "shafts": [{**old, "bearings": rows, **shaft}]}, "gamma.toml")


def test_the_duty_may_be_that_of_the_engine():
    data = on_rolling().data
    operation = [
        {"name": "idle", "speed_rpm": 900.0, "hours": 1.0},
        {"name": "full", "speed_rpm": 2600.0, "hours": 1.0},
    ]
    by_engine = Document({**data, "engine": {**data["engine"], "operation": operation}}, "x.toml")
    by_duty = Document({**data, "bearings": {**data["bearings"], "duty": operation}}, "y.toml")
    first, second = (solve(design(one)).result(BearingsResult).bearings["front"] for one in (by_engine, by_duty))
    assert set(first.duty) == {"idle", "full"} and first.life == pytest.approx(second.life, rel=1e-12)


# --- with a shaft, beside plain ones
@pytest.mark.parametrize("plain", [(), ("front",), ("rear",)])
def test_the_power_closes_with_any_kinds(plain):
    results = solve(design(on_rolling(plain=plain)))
    balance, bearings = results.result(FrictionResult), results.result(BearingsResult).bearings
    assert [r.row.kind for r in bearings.values()] == ["plain" if p in plain else "rolling" for p in ("front", "rear")]
    losses = [journal.friction_power for journal in balance.journals["shaft"].values()]
    assert balance.crank_power == pytest.approx(balance.total_loss, rel=1e-9)  # nothing else is driven
    assert sum(losses) == pytest.approx(balance.bearing_loss, rel=1e-9)


def test_its_loss_in_the_balance_is_its_own():
    """The mean over a turn with what stands: the same numbers in both steps."""
    results = solve(design(on_rolling()))
    balance, bearings = results.result(FrictionResult), results.result(BearingsResult).bearings
    for place, journal in balance.journals["shaft"].items():
        assert journal.standing_load == pytest.approx(bearings[place].standing_load, rel=1e-6)
        assert journal.friction_power == pytest.approx(bearings[place].friction_power, rel=1e-6)


def test_what_stands_is_that_of_the_shaft():
    results = solve(design(on_rolling()))
    shaft, bearings = results.result(CountershaftResult), results.result(BearingsResult).bearings
    for place, r in bearings.items():
        assert r.standing_load == shaft.standing.stationary[place] and r.load == shaft.loads[place]
        assert r.stands.weight == shaft.standing.weights[place] < r.standing_load


def carried_by(results):
    """Force and couple of what the bearings carry, in the frame of the shaft, and their size."""
    found = results.result(BearingsResult)
    P = [r.load * np.exp(1j * (r.on_shaft.load_phase or 0.0)) for r in found.bearings.values()]
    z = [r.row.position for r in found.bearings.values()]
    return sum(P), sum(p * at for p, at in zip(P, z)), max(map(abs, P))


@pytest.mark.parametrize("rolling", [{"middle": "6305"}, {"front": "NU205", "rear": "HK3020"}, {"front": "NA4905"}])
def test_three_bearings_of_any_kinds_share_the_load_in_equilibrium(rolling):
    """Against the same shaft on films alone: force and couple of its masses, but for what it bends otherwise."""
    films = on_bearings("r754-films")
    (shaft,) = films.data["shafts"]
    mixed = [
        {"name": row["name"], "position_mm": row["position_mm"], "kind": "rolling", "size": rolling[row["name"]]}
        if row["name"] in rolling
        else row
        for row in shaft["bearings"]
    ]
    results = solve(design(films.with_value("shafts", [{**shaft, "bearings": mixed}])))
    found, bent = results.result(BearingsResult), results.result(CountershaftResult)
    assert {name for name, r in found.bearings.items() if r.row.kind == "rolling"} == set(rolling)
    force, couple, size = carried_by(results)
    assert force == pytest.approx(bent.force_vector, abs=0.02 * size)
    assert couple == pytest.approx(bent.couple_vector, abs=0.02 * size * 0.2)
    for name in rolling:
        r = found.bearings[name]
        law = r.case.springs(r.clearance_running)
        assert r.on_shaft.displacement == pytest.approx(float(law.displacement(r.load)), rel=0.02)
        assert r.on_shaft.load_phase == pytest.approx(r.on_shaft.displacement_phase)


def test_a_twin_has_the_bearings_of_its_original():
    """A mirror image says nothing of its own where as much stands on it; a row of it may have its own fits."""
    data = on_rolling().data
    (shaft,) = data["shafts"]
    alone = {key: x for key, x in data.items() if key not in ("gears", "friction")}

    def pair(*rows):
        twin = {"name": "image", "mirrors": "shaft", "axis_mm": [0.0, 80.0]} | ({"bearings": [*rows]} if rows else {})
        shafts = [{**shaft, "axis_mm": [0.0, -80.0]}, twin]
        return solve(design(Document({**alone, "shafts": shafts}, "pair.toml"))).values()

    same, other = pair(), pair({"name": "front", "seat_fit": "P7"})
    assert not any(id.startswith("bearings.image.") for id in same)
    assert other["bearings.image.front.life"].shown == pytest.approx(same["bearings.shaft.front.life"].shown, rel=1e-9)
    assert other["bearings.image.front.grip_hot"].shown > same["bearings.shaft.front.grip_hot"].shown
    lives = [same[f"bearings.shaft.{place}.life"].shown for place in ("front", "rear")]
    every = same["bearings.system_life"].shown
    ball_and_roller = zip(lives, (10 / 9, 9 / 8))
    assert 2 * sum((every / life) ** e for life, e in ball_and_roller) == pytest.approx(1.0)  # of both shafts


def test_an_insert_is_a_seat_of_steel():
    bare, insert = front(), front(front={"outer_ring_held": "insert"})
    assert bare.grip_hot < insert.grip_hot == pytest.approx(-4e-6)  # of N7 as it is at 20 °C
    assert insert.clearance_running < bare.clearance_running  # the ring stays pressed
    steel = front(housing_material="steel")
    assert insert.grip_hot == pytest.approx(steel.grip_hot) and insert.clearance_cold == steel.clearance_cold


# --- what is not known
UNKNOWN = ("life_reference", "clearance_running", "clearance_least", "clearance_start", "stiffness", "pass_frequency")
JUDGED = ("life_reference", "clearance_least", "clearance_start", "clearance_frozen")


def own(**more):
    return {"size": "own", **OWN, **RATED, **more}


def test_of_ones_own_by_its_ratings_alone():
    results = solved(front=own())
    r, made = results.result(BearingsResult).bearings["front"], checks(results)
    assert r.ring_factor == 1.0 and r.dynamic_rating == 14e3 and r.life > 0
    assert [name for name in UNKNOWN if getattr(r, name) is not None] == []
    assert {name: made[name].verdict for name in JUDGED} == dict.fromkeys(JUDGED, "not_verified")
    assert all(key.endswith(("element_count", "element_diameter_mm")) for key in made["clearance_least"].missing)
    # its ring sits as that of the same outline, some K apart
    assert r.grip_hot == pytest.approx(front(front={"size": "6205"}).grip_hot, rel=0.01)


def test_of_ones_own_with_all_that_is_inside():
    inside = {"element_count": 9, "element_diameter_mm": 7.965, "pitch_diameter_mm": 38.5}
    one, known = front(front=own(**inside)), front(front={"size": "6205", **RATED})
    for name in ("ring_factor", "clearance_running", "stiffness", "life_reference", "pass_frequency"):
        assert getattr(one, name) is not None, name
    assert one.stiffness == pytest.approx(known.stiffness, rel=0.02)


def test_a_bore_beyond_the_table_of_clearances_asks_for_one():
    large = {**own(), "bore_mm": [80.0], "outside_diameter_mm": 140.0, "width_mm": 26.0, "element_count": 10}
    large |= {"element_diameter_mm": 17.0, "pitch_diameter_mm": 110.0}
    made = checks(solved(front=large))
    assert made["clearance_least"].verdict == "not_verified"
    assert made["clearance_least"].missing == ("shafts.shaft.bearings.front.clearance_limits_um",)
    told = checks(solved(front={**large, "clearance_um": [30.0, 50.0]}))
    assert told["clearance_least"].verdict != "not_verified"


def test_a_catalogue_s_ratings_rule():
    estimated, told = front(), front(front={"dynamic_rating_kN": 32.0, "static_rating_kN": 27.0})
    assert (told.dynamic_rating, told.static_rating) == (32e3, 27e3)
    assert told.dynamic_rating_computed == estimated.dynamic_rating
    assert told.fatigue_limit == pytest.approx(27e3 / 8.2)
    made = checks(solved(front={"dynamic_rating_kN": 32.0, "static_rating_kN": 27.0}))
    assert made["rating_estimate"].verdict == "pass"


def test_a_soft_raceway_lowers_every_rating():
    hard, soft = (front(PROFILE, front={"size": "HK3020", "locates": None, "axial_load_N": None,
        "raceway_hardness_HV": HV}) for HV in (700.0, 335.0))  # fmt: skip
    assert soft.dynamic_rating == pytest.approx(0.25 * hard.dynamic_rating)
    assert soft.static_rating == pytest.approx(0.25 * hard.static_rating)


# --- what is refused, all of it at once
def test_bad_input_is_told_all_at_once():
    wrong = refused(
        front={"size": "NU25", "locates": True},
        rear={"size": "NU205", "locates": True, "split_cage": True, "raceway_hardness_HV": 600.0, "seat_fit": "Q7"},
        cleanliness="filthy",
        duty=[{"name": "a", "speed_rpm": 900.0, "hours": 1.0}, {"name": "a", "speed_rpm": 900.0, "hours": 1.0}],
    )
    assert "NU205" in wrong["size"] and "carries no thrust" in wrong["locates"]
    assert "needle cage" in wrong["split_cage"] and "inner ring" in wrong["raceway_hardness_HV"]
    assert "filthy" in wrong["cleanliness"] and "twice" in wrong["name"] and "seat_fit" in wrong


@pytest.mark.parametrize(
    ("row", "key", "word"),
    [
        ({"size": "NU213"}, "size", "NU212"),
        ({"size": "HK0810"}, "size", "15, 16"),
        ({"size": None}, "size", "6205"),
        ({"size": "own"}, "elements", "needed"),
        ({"size": "own", **OWN}, "size", "element_count"),
        ({"diameter_mm": 40.0}, "diameter_mm", 'kind = "plain"'),
        ({"element_count": 40}, "element_count", "overlap"),
        ({"element_diameter_mm": 14.0}, "element_diameter_mm", "room"),
        ({"contact_angle_deg": 15.0}, "contact_angle_deg", "pairs"),
        ({"clearance_um": [30.0, 20.0]}, "clearance_limits_um", "before"),
        ({"shaft_fit": "H7"}, "shaft_fit", ""),
        ({**own(), "outside_diameter_mm": 20.0}, "outside_diameter_mm", "larger than the bore"),
        ({"width_mm": 14.0}, "width_mm", "own"),
        ({"size": "HK25٢٠"}, "size", "no bearing"),  # figures of another script
        ({"size": "K480x520x20"}, "size", "500 mm"),
        ({"housing_outer_mm": 52.0}, "housing_outer_mm", "54 mm"),
        ({"pitch_diameter_mm": 0.001}, "pitch_diameter_mm", "between 25 and 52 mm"),
        ({"pitch_diameter_mm": 50.0}, "pitch_diameter_mm", "between 25 and 52 mm"),
        ({"element_length_mm": 15.0}, "element_length_mm", "15 mm"),
    ],
)
def test_a_row_that_is_refused(row, key, word):
    assert word in refused(front=row)[key]


def test_the_fastest_part_of_the_duty_is_held_against_the_limiting_speed():
    """NU205 may turn at 600 000/38.5 rpm, whether that is its rated speed or not."""
    for speed in (15500.0, 15700.0):
        check = checks(solved(duty=[{"name": "over", "speed_rpm": speed, "hours": 1.0, "load_factor": 0.05}]))[
            "speed_factor"
        ]
        assert check.value == pytest.approx(speed) and (check.verdict == "fail") is (speed > 600e3 / 38.5)


def test_a_duty_that_is_refused():
    for row in ({"hours": 0.0}, {"speed_rpm": 0.0}, {"speed_rpm": -5.0}, {"hours": -1.0}):
        (key,) = row
        assert key in refused(duty=[{**ROWS[0], **row}])


def test_only_one_bearing_locates():
    assert "locates" in refused(front={"size": "6205", "locates": True}, rear={"locates": True})


def test_a_size_belongs_to_rolling_bearings():
    assert "rolling" in refused(front={"kind": "plain", "diameter_mm": 40.0, "length_mm": 20.0})["size"]
