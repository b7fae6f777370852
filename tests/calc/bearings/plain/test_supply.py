"""Where the oil comes in, and how it stands to the load."""

import math
from dataclasses import replace

import numpy as np
import pytest

from calc.bearings.plain.routes import flow, supply
from calc.design.toml_file import design
from calc.sheet.errors import BadInput
from calc.solve import solve
from tests.calc.bearings.documents import TABLE, alone, changed
from tests.calc.bearings.documents import outcome as solved

OF_SEAT = ("supply", "hole_diameter_mm", "housing_material")


def bearings(document, **changes):
    return design(changed(document, **changes)).bearings


@pytest.mark.parametrize(
    "where, load, keeps",
    [
        ("hole", 1.0, False),
        ("hole", 0.0, True),
        ("pocket", 1.0, False),
        ("pocket", 0.0, True),
        ("shaft", 1.0, True),
        ("shaft", 0.0, False),
    ],
)
def test_a_feed_keeps_its_angle_only_to_a_load_that_turns_with_it(gamma, where, load, keeps):
    inputs = replace(bearings(gamma), supply=where, load_speed_ratio=load)
    assert supply.keeps_its_angle(inputs) is keeps


def test_the_angle_factor_has_the_three_cases_of_the_table():
    """Opposite the load (1 + ε)³, at 90° 1, in the load zone (1 − ε)³."""
    eps = 0.7
    assert flow.at_angle(eps, math.pi) == pytest.approx((1 + eps) ** 3)
    assert flow.at_angle(eps, math.pi / 2) == pytest.approx(1)
    assert flow.at_angle(eps, 0.0) == pytest.approx((1 - eps) ** 3)


def test_the_swept_hole_is_the_mean_over_all_angles():
    eps = 0.7
    angles = np.linspace(0, 2 * math.pi, 720, endpoint=False)
    assert flow.at_angle(eps, angles).mean() == pytest.approx(flow.swept(eps), rel=1e-12)


def test_a_part_groove_all_round_is_the_full_groove():
    full = flow.groove_factor(eps=0.6, d=0.06, l=0.03, b_G=0.004)
    assert flow.part_groove_factor(eps=0.6, phi_A=-math.pi, phi_E=math.pi, d=0.06, l=0.03, b_G=0.004) == pytest.approx(
        full
    )
    assert flow.swept_part_groove_factor(
        eps=0.6, delta_A=0.0, delta_E=2 * math.pi, d=0.06, l=0.03, b_G=0.004
    ) == pytest.approx(full)


def test_a_part_groove_is_the_integral_of_the_gap_cubed():
    eps, start, end = 0.6, -0.8, 1.1
    phi = np.linspace(start, end, 20001)
    integral = np.trapezoid((1 + eps * np.cos(phi)) ** 3, phi)
    found = flow.part_groove_factor(eps=eps, phi_A=start, phi_E=end, d=0.06, l=0.03, b_G=0.004)
    assert found == pytest.approx(integral / 48 * 0.06 / 0.026, rel=1e-7)


def test_a_part_groove_opposite_a_standing_load_leaves_the_film_whole(gamma):
    groove = dict(supply="groove", groove_width_mm=3.0)
    whole = solved(gamma, **groove, groove_arc_deg=[120.0, 240.0], load_speed_ratio=0.0).result.bearings["front"]
    parted = solved(gamma, **groove, groove_arc_deg=[60.0, 240.0], load_speed_ratio=0.0).result.bearings["front"]
    turning = solved(gamma, **groove, groove_arc_deg=[120.0, 240.0]).result.bearings["front"]
    assert whole.length_ratio == pytest.approx(27.5 / 59.5)
    assert parted.length_ratio == turning.length_ratio == pytest.approx(12.25 / 59.5)
    assert whole.film > 1.5 * parted.film


def test_a_hole_through_the_shaft_gives_most_oil_opposite_the_load(gamma):
    flows = [
        solved(gamma, supply="shaft", supply_angle_deg=a).result.bearings["front"].supply_flow
        for a in (180.0, 90.0, 20.0)
    ]
    assert flows[0] > flows[1] > flows[2] > 0


def test_a_standing_load_and_a_turning_one_have_the_same_film_number(gamma):
    """|ω_J + ω_B − 2·ω_F| is the journal's speed in both cases; only the way of the oil differs."""
    turning = solved(gamma).result.bearings["front"]
    standing = solved(gamma, load_speed_ratio=0.0).result.bearings["front"]
    assert turning.duty.effective_speed == standing.duty.effective_speed == pytest.approx(2600 / 60)
    assert standing.supply_flow > 2 * turning.supply_flow
    assert standing.feed_blocked_arc is None and turning.feed_blocked_arc > 0


def test_a_load_at_twice_the_speed_triples_the_film_s_speed_and_not_its_sliding(gamma):
    """|1 − 2·2| = 3: the film is that of three times the speed, the shear by sliding at one third of it."""
    r = solved(gamma, load_speed_ratio=2.0).result.bearings["front"]
    one = solved(gamma).result.bearings["front"]
    assert r.duty.effective_speed == pytest.approx(3 * 2600 / 60)
    assert r.duty.sliding_ratio == pytest.approx(1 / 3)
    assert r.film > 1.3 * one.film


def test_a_bush_that_turns_against_the_journal_adds_its_speed(gamma):
    """Journal n, bush −n, load standing: nothing is dragged into the gap; journal n, bush −n/2: half."""
    r = solved(gamma, bush_speed_ratio=-0.5, load_speed_ratio=0.0).result.bearings["front"]
    assert r.duty.effective_speed == pytest.approx(0.5 * 2600 / 60)
    assert r.duty.sliding_ratio == pytest.approx(3)


@pytest.mark.parametrize(
    "changes, key",
    [
        (dict(load_speed_ratio=0.5), "bearings.load_speed_ratio"),
        (dict(load_speed_ratio=0.505), "bearings.load_speed_ratio"),
        (dict(bush_speed_ratio=-1.0, load_speed_ratio=0.0), "bearings.load_speed_ratio"),
        (dict(bush_speed_ratio=1.0), "bearings.bush_speed_ratio"),
        (dict(groove_arc_deg=[200.0, 100.0]), "bearings.groove_arc_deg"),
        (dict(speed_range_rpm=[2600.0, 1000.0]), "bearings.speed_range_rpm"),
        (dict(journal_fit="H7"), "bearings.journal_fit"),
        (dict(seat_fit="f7"), "bearings.seat_fit"),
        (dict(journal_fit="IT99"), "bearings.journal_fit"),
        (dict(bush_material="wood"), "bearings.bush_material"),
        (dict(application="kettle"), "bearings.application"),
        (dict(front__load_N=0.0), "bearings.front.load_N"),
    ],
)
def test_what_can_not_be_is_refused_with_its_key(gamma, changes, key):
    with pytest.raises(BadInput) as caught:
        bearings(gamma, **changes)
    assert any(error.key == key for error in caught.value.errors), [e.key for e in caught.value.errors]


# --- supply and seat of one bearing, in its row


def test_a_row_has_the_supply_and_the_seat_that_it_says():
    own = dict(supply="groove", groove_width_mm=3.0, housing_material="EN AC-43100", seat_fit="H7")
    shared = solved(alone()).result.bearings
    grooved = solved(alone(**own)).result.bearings
    mixed = solved(alone(**{f"front__{key}": value for key, value in own.items()}))
    for place, like in (("front", grooved), ("rear", shared)):
        found = mixed.result.bearings[place]
        assert (found.film, found.oil_flow, found.clearance_hot) == (
            like[place].film,
            like[place].oil_flow,
            like[place].clearance_hot,
        )
        assert found.corners.clearance_min == like[place].corners.clearance_min
    assert (
        grooved["front"].film < shared["front"].film and grooved["front"].clearance_hot > shared["rear"].clearance_hot
    )
    moved = {check.id: check.moved_by for check in mixed.checks}
    ids = ("bearings.front.film_edge_corner", "bearings.rear.film_edge_corner")
    fits = ("shafts.shaft.bearings.front.seat_fit", "bearings.seat_fit")
    assert all(fit in moved[id] for id, fit in zip(ids, fits))
    notes = [str(note) for note in mixed.notes]
    assert any(note.startswith("Front: The groove") for note in notes)
    assert any(note.startswith("Rear: The hole") for note in notes)


def test_rows_that_say_what_all_share_change_nothing():
    same = {f"{place}__{key}": TABLE[key] for place in ("front", "rear") for key in OF_SEAT}
    results = [solve(design(alone(**changes))) for changes in ({}, same)]
    shared, said = ({id: value.inside for id, value in found.values().items()} for found in results)
    assert shared == said


@pytest.mark.parametrize(
    ("changes", "key", "words"),
    [
        (dict(front__supply="groove"), "front.groove_width_mm", "needed with supply"),
        (dict(front__hole_diameter_mm=31.0), "front.hole_diameter_mm", "smaller than the length of the front bearing"),
        (dict(front__bush_material="wood"), "front.bush_material", "must be one of"),
        (dict(front__housing_material="wood"), "front.housing_material", "is not known"),
        (dict(front__journal_fit="H7"), "front.journal_fit", "must be a shaft's class"),
        (dict(front__groove_arc_deg=[200.0, 100.0]), "front.groove_arc_deg", "must rise"),
        (dict(hole_diameter_mm=31.0, front__hole_diameter_mm=5.0), "", "smaller than the length of the rear bearing"),
    ],
)
def test_what_is_wrong_in_a_row_is_said_there_and_what_all_share_once(changes, key, words):
    with pytest.raises(BadInput) as caught:
        design(alone(**changes))
    (error,) = caught.value.errors
    assert error.called == (f"shafts.shaft.bearings.{key}" if key else "") and words in error.reason
    assert key or error.key == "bearings.hole_diameter_mm"


def test_a_row_is_longer_than_its_own_supply_alone():
    """That of all may be wider, where none of them has it."""
    design(alone(hole_diameter_mm=31.0, front__hole_diameter_mm=5.0, rear__hole_diameter_mm=5.0))
