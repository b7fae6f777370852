# SPDX-License-Identifier: Apache-2.0
"""What is shown of a seat: its stack, the shells by classes, over temperature, its curves and its sketches."""

import math

import numpy as np
import pytest

from calc.bearings.plain.seats.warm import OVER, warm
from calc.bearings.sketch import sketch
from calc.design.toml_file import design
from calc.draw.drawing import Arc, Area, Dimension, Polyline, reach
from calc.solve import solve
from tests.calc import sketches
from tests.calc.bearings.documents import alone
from tests.calc.bearings.plain.test_seat_inputs import document

UM = 1e-6


@pytest.fixture(scope="module")
def seats():
    """Shells by classes in front, a bush by its limits behind."""
    return solve(design(document()))


@pytest.fixture(scope="module")
def tables(seats):
    return {table.id: table for table in seats.outcomes["bearings"].tables}


def of(seats, place):
    return seats.outcomes["bearings"].result.bearings[place]


def column(table, n):
    return [float(str(row[n]).replace("−", "-")) for row in table.rows]


# --- values


def test_the_clearance_is_told_with_all_parts_at_three_temperatures(seats):
    values = seats.values()
    for place in ("front", "rear"):
        case = of(seats, place).seat
        for T in (-20, 20, 100):
            told = values[f"bearings.{place}.clearance_at.{T}"]
            assert told.inside == pytest.approx(float(case.clearance_at(float(T))), rel=1e-12)
            assert str(told.label) == f"Clearance with all parts at {str(T).replace('-', '−')} °C" and not told.short
        assert values[f"bearings.{place}.clearance_at.20"].inside == pytest.approx(case.clearance)


def test_classes_are_told_by_their_pairs_and_the_number_of_shells(seats):
    """Three shells for two classes and two, as Kawasaki has."""
    values = seats.values()
    assert values["bearings.front.select.inserts"].shown == 3
    pairs = [(i, j) for i in (1, 2) for j in (1, 2)]
    ends = [[values[f"bearings.front.select.pair.{i}_{j}.{end}"].inside for i, j in pairs] for end in ("min", "max")]
    # the corners have the scatter of the interference as well, of which a part is closed again
    field = (
        12e-6
        / 2
        * (1 - values["bearings.front.seat.bore_closing"].inside / values["bearings.front.seat.interference"].inside)
    )
    assert min(ends[0]) - values["bearings.front.corners.clearance_min"].inside == pytest.approx(field, rel=0.02)
    assert values["bearings.front.corners.clearance_max"].inside - max(ends[1]) == pytest.approx(field, rel=0.02)
    assert not any(id.startswith("bearings.rear.select") for id in values)


# --- tables


def test_the_stack_adds_up(tables, seats):
    """Least: bore and rise least, walls and journal most; the field is what the parts' fields come to."""
    table, r = tables["stack_rear"], of(seats, "rear")
    bore, wall, journal, rise, worst, root = zip(column(table, 1), column(table, 2), column(table, 3))
    assert bore[:2] == (33.025, 33.05) and wall[:2] == (1.5, 1.508) and journal[:2] == (29.95, 29.975)
    assert worst[0] == pytest.approx(bore[0] - 2 * wall[1] - journal[1] + rise[0], abs=1.1e-4)
    assert worst[1] == pytest.approx(bore[1] - 2 * wall[0] - journal[0] + rise[1], abs=1.1e-4)
    assert worst[0] == pytest.approx(r.corners.clearance_min * 1e3, abs=5.1e-5)
    assert worst[2] == pytest.approx(sum(part[2] for part in (bore, wall, journal, rise)), abs=0.2)
    assert root[2] == pytest.approx(math.hypot(bore[2], wall[2], journal[2], rise[2]), abs=0.1)
    assert root[0] + root[1] == pytest.approx(worst[0] + worst[1], abs=2e-4)  # about the same middle


def test_the_stack_of_classes_is_that_of_one_pair(tables, seats):
    """Of the pair with the least clearance; it adds up, and the note has what all pairs leave."""
    table, c = tables["stack_front"], of(seats, "front").corners
    bore, wall, journal, rise, worst, _ = zip(column(table, 1), column(table, 2), column(table, 3))
    assert column(table, 3)[:3] == [8.0, 8.0, 6.0]  # of a bore class, twice a wall, of a journal class
    assert worst[0] == pytest.approx(bore[0] - 2 * wall[1] - journal[1] + rise[0], abs=1.1e-4)
    assert worst[2] == pytest.approx(8 + 8 + 6 + rise[2], abs=0.2)  # 22, and the scatter of the interference
    assert worst[0] == pytest.approx(c.clearance_min * 1e3, abs=5.1e-5)
    assert f"all pairs: {c.clearance_min * 1e6:.1f} to {c.clearance_max * 1e6:.1f} µm" in str(table.note)


def test_shells_by_classes_have_the_words_of_their_colours(tables):
    table = tables["classes_front"]
    cells = [[str(cell).partition(",")[0] for cell in row[1:]] for row in table.rows]
    assert cells == [["black", "brown"], ["blue", "black"]]  # a large bore and a small journal: the thickest
    assert "27.987 to 27.993" in str(table.columns[1][0]) and "31.009 to 31.016" in str(table.rows[1][0])
    assert "brown 1.490 to 1.494" in str(table.note) and table.covers == ("bearings.front.select.",)


def test_over_temperature_bore_and_journal_leave_the_clearance(tables, seats):
    for place in ("front", "rear"):
        table, r = tables[f"over_temperature_{place}"], of(seats, place)
        T, bore, journal, clearance, press = (column(table, n) for n in range(1, 6))
        assert T == pytest.approx([-20, 20, 100, r.hot.mean_temperature, 135])
        assert np.subtract(bore, journal) * 1e3 == pytest.approx(clearance, abs=0.11)
        assert clearance[3] == pytest.approx(r.clearance_hot / UM)
        assert press[0] > press[1] > press[2] > press[3] > press[4] == 0.0
        assert press[1] == pytest.approx(r.seat_.press / 1e6)


def test_a_housing_of_its_own_temperature_is_counted_once_oil_is_supplied():
    cooler = solve(design(document(housing_temperature_C=60)))
    table = next(t for t in cooler.outcomes["bearings"].tables if t.id == "over_temperature_rear")
    r = of(cooler, "rear")
    assert column(table, 4)[3] == pytest.approx(r.clearance_hot / UM) and "60 °C" in str(table.note)
    assert column(table, 4)[1] == pytest.approx(r.clearance / UM)


def test_a_seat_of_which_nothing_more_is_known_has_none_of_them():
    outcome = solve(design(alone())).outcomes["bearings"]
    assert not [t.id for t in outcome.tables if t.id.startswith(("stack", "classes", "over_temperature"))]
    assert not [c.id for c in outcome.curves if "over_temperature" in c.id]


# --- curves


def test_a_curve_bends_where_the_seat_comes_loose():
    pressed = solve(design(document(rear={"interference_um": [20, 30]})))
    curves = {curve.id: curve for curve in pressed.outcomes["bearings"].curves}
    curve, r = curves["press_over_temperature_rear"], of(pressed, "rear")
    least, _, loose = curve.series
    assert loose.x == pytest.approx([r.seat_.loose_at] * 2)
    assert (least.y[least.x > r.seat_.loose_at] == 0).all() and (least.y[least.x < r.seat_.loose_at] > 0).all()
    assert curve.limits[0][1] == pytest.approx(r.seat_.press_needed / 1e6)
    clearance = curves["clearance_over_temperature_rear"]
    middle, upright, low, high = clearance.series
    slopes = np.diff(middle.y) / np.diff(OVER)
    before, behind = slopes[OVER[1:] < upright.x[0]], slopes[OVER[:-1] > upright.x[0]]
    d_i, d_J = r.seat_.bore, r.seat_.bore - r.clearance
    steel = r.seat.journal_expansion
    assert before == pytest.approx((d_i * r.seat_.expansion - d_J * steel) / UM, rel=1e-3)
    assert behind == pytest.approx((d_i * r.seat.rings.backing.expansion - d_J * steel) / UM, abs=2e-3)
    assert clearance.band and (low.y < middle.y).all() and (middle.y < high.y).all()
    assert (clearance.stack, clearance.short, curve.short) == (curve.stack, 2, 3)


def test_what_is_drawn_is_asked_of_all_temperatures_at_once(seats):
    case = of(seats, "front").seat
    there = warm(case, OVER, OVER)
    assert np.shape(there.press) == np.shape(there.bore) == OVER.shape
    assert there.clearance[50] == pytest.approx(float(case.clearance_at(OVER[50])))


def test_limits_of_a_seat_in_the_housing_itself_have_a_curve_without_press():
    direct = {"seat": "direct", "wall_mm": None, "bore_mm": [30.01, 30.03], "journal_mm": [29.95, 29.97]}
    outcome = solve(design(document(rear=direct))).outcomes["bearings"]
    ids = {curve.id: curve for curve in outcome.curves}
    assert "press_over_temperature_rear" not in ids and not ids["clearance_over_temperature_rear"].stack
    assert [str(row[0]) for t in outcome.tables if t.id == "stack_rear" for row in t.rows][:2] == [
        "+ bore of the seat",
        "− journal",
    ]


# --- sketches


def test_each_seat_comes_first_in_a_view_of_its_own(seats):
    first = sketch(seats.design, seats)
    sketches.check(first, document())
    assert first.views == 3 and "Ø28" in str(first.title)
    titles = [str(sketch(seats.design, seats, view=view).title) for view in range(3)]
    assert titles[1].startswith("front: shells") and titles[2].startswith("rear: bush")


def test_the_section_shows_relief_split_and_what_limits_the_seat(seats):
    front, rear = (sketch(seats.design, seats, view=view) for view in (1, 2))
    key = "shafts.S.bearings.front"
    (bore,) = [m for m in sketches.lit(front, f"{key}.relief_um") if isinstance(m, Polyline)]
    radii = np.hypot(*np.array(bore.points).T)
    assert (radii.max() - radii.min()) / 200 == pytest.approx(8 * UM, rel=1e-6)  # as drawn, 200 times as large
    angle = math.degrees(math.atan2(*bore.points[int(radii.argmax())][::-1]))
    assert angle % 180 == pytest.approx(0.0, abs=1e-6)  # of a joint that lies level
    assert any(isinstance(m, Polyline) for m in sketches.lit(front, f"{key}.split_angle_deg"))
    assert not sketches.lit(rear, "shafts.S.bearings.rear.split_angle_deg")
    words = [str(mark.text) for mark in front.primitives if hasattr(mark, "text")]
    assert any(word.startswith("shells 28") and "of 300 MPa" in word for word in words)
    assert any(word.startswith("loose from 13") for word in words)
    warned = [m for m in rear.primitives if getattr(m, "state", "") == "warn"]
    assert [str(m.text) for m in warned] == ["bush 344 of 300 MPa"]


def test_a_joint_that_stands_is_drawn_standing():
    turned = solve(design(document(front={"split_angle_deg": 90})))
    marks = sketches.lit(sketch(turned.design, turned, view=1), "shafts.S.bearings.front.split_angle_deg")
    assert marks and all(abs(x) < 1e-9 for mark in marks for x, _ in reach(mark))


def test_the_chain_of_dimensions_spans_its_bore(seats):
    chain = sketch(seats.design, seats, view=2).beside[0]
    ends = {str(m.label): (m.start[0], m.end[0]) for m in chain.primitives if isinstance(m, Dimension)}
    bore, wall, clearance, journal = (
        next(span for label, span in ends.items() if label.startswith(part))
        for part in ("bore 33.025–33.050", "wall 1.500–1.508", "clearance 0.0", "journal 29.950–29.975")
    )
    assert bore[0] == wall[0] and wall[1] == clearance[0] and clearance[1] == journal[0] < journal[1] < bore[1]
    assert any("the press adds" in str(note) for note in chain.notes)


def test_pictures_of_seats_stand_apart_on_paper_and_of_plain_seats_there_are_none(seats):
    first = sketch(seats.design, seats)
    assert [bool(part.caption) for part in (first, *first.beside)] == [False, False, True, True, True, True]
    plain = solve(design(alone()))
    one = sketch(plain.design, plain)
    assert one.views == 1 and not any(part.caption for part in (one, *one.beside))
    assert any(isinstance(m, Arc) for m in one.primitives) and any(isinstance(m, Area) for m in one.primitives)
