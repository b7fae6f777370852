# SPDX-License-Identifier: Apache-2.0
"""Shells that are picked by the classes of bore and journal."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from calc.bearings.plain.seats.classes import Select, found_walls
from calc.bearings.plain.seats.rings import Rings
from calc.bearings.plain.seats.stack import stack_of
from calc.countershaft.rows import BearingRow
from tests.calc.bearings.plain.test_seats import MM, SOLIDS, UM, mm, of

BORES, JOURNALS = [[31.0, 31.008], [31.009, 31.016]], [[27.987, 27.993], [27.994, 28.0]]
WALLS, PICK = [[1.484, 1.488], [1.488, 1.492], [1.492, 1.496]], [[1, 0], [2, 1]]
SHELLS = BearingRow(name="front", diameter=28e-3, length=18e-3, seat="shells")
STEEL, METAL = SOLIDS["strip"], SOLIDS["EN AC-43100"]


def classes(**more):
    given_ = dict(journal_classes_mm=JOURNALS, bore_classes_mm=BORES, clearance_band=(20e-6, 44e-6))
    return Select(**{**given_, **more})


def rings(delta=0.0):
    return Rings(STEEL, METAL, 1.49e-3, 0.0, 20.0, (delta, delta))


@pytest.mark.parametrize("row", of("4.5 selection"))
def test_the_clearance_of_each_pair_of_classes(row):
    case = row["case"]
    select = classes(walls_mm=case["walls_mm"], pick=case["pick"])
    stack = stack_of(SHELLS, select)
    if "all pairs" in row["quantity"]:
        got = stack.clearances(rings())
        assert stack.clearances(rings()) == pytest.approx(
            (
                min(stack.of_pair(p, rings())[0] for p in stack.pairs),
                max(stack.of_pair(p, rings())[1] for p in stack.pairs),
            )
        )
    else:
        got = stack.of_pair((case["bore_class"], case["journal_class"]), rings())
    assert np.array(got) / UM == pytest.approx(row["is"], rel=row["rel"])


@pytest.mark.parametrize("row", of("4.5 found walls"))
def test_three_inserts_for_two_classes_and_two(row):
    case = row["case"]
    bores, journals = (tuple(mm(x) for x in case[f"{part}_classes_mm"]) for part in ("bore", "journal"))
    walls = found_walls(bores, journals, case["band_middle_um"] * UM)
    assert np.array(walls) / MM == pytest.approx(row["is"], rel=row["rel"])
    # the program itself: its walls 4 µm wide, in whole micrometres, and each pair with the nearest
    select = classes()
    assert [sum(wall) / 2 for wall in select.walls()] == pytest.approx(walls, abs=0.51 * UM)
    assert all(end / UM == pytest.approx(round(end / UM)) for wall in select.walls() for end in wall)
    assert [most - least for least, most in select.walls()] == pytest.approx([case["wall_field_um"] * UM] * 3)
    assert select.picked() == tuple(map(tuple, PICK))


def test_picking_takes_a_third_off_the_field():
    """23 to 46 µm, 23 wide; unselected 16 to 53, 37 wide."""
    all_parts = BearingRow(
        name="front",
        diameter=28e-3,
        seat="shells",
        journal=mm((27.987, 28.0)),
        bore=mm((31.0, 31.016)),
        wall=mm((1.488, 1.492)),
    )
    picked = stack_of(SHELLS, classes(walls_mm=WALLS, pick=PICK)).clearances(rings())
    unpicked = stack_of(all_parts, None).clearances(rings())
    assert (picked[1] - picked[0]) / UM == pytest.approx(23.0) and (unpicked[1] - unpicked[0]) / UM == pytest.approx(
        37.0
    )


def test_a_seated_bore_stands_wider_and_found_walls_allow_for_it():
    """Walls that are given do not: both ends of every pair move by the same."""
    pressed = rings(40e-6)
    rise = pressed.rise(28e-3, 32e-6)
    assert 5e-6 < rise < 35e-6
    given_ = stack_of(SHELLS, classes(walls_mm=WALLS, pick=PICK), rise)
    for pair in given_.pairs:
        wider = np.array(given_.of_pair(pair, pressed)) - given_.of_pair(pair, rings())
        assert wider == pytest.approx([rise, rise], rel=5e-3)
    found, rigid = stack_of(SHELLS, classes(), rise), stack_of(SHELLS, classes(), 0.0)
    assert found.clearances(pressed) == pytest.approx(rigid.clearances(rings()), abs=1.1 * UM)  # by whole ones
    assert found.walls[0] - rigid.walls[0] == pytest.approx(rise / 2, abs=0.51 * UM)


def test_thick_walls_go_with_large_bores_and_small_journals():
    select = classes()
    pairs, walls = select.pairs(), select.walls()
    assert pairs[1, 2][1] == walls[0] and pairs[2, 1][1] == walls[-1]
    assert pairs[2, 1][0] == pytest.approx(mm(BORES[1])) and pairs[2, 1][2] == pytest.approx(mm(JOURNALS[0]))


@given(bores=st.integers(1, 4), journals=st.integers(1, 4), step=st.floats(6, 20), band=st.floats(20, 60))
def test_equal_steps_need_one_insert_less_than_both_have_classes(bores, journals, step, band):
    """Each pair within half a field of the wall of the middle that was asked for."""
    D = tuple((31e-3 + i * step * UM, 31e-3 + (i + 0.9) * step * UM) for i in range(bores))
    d = tuple((28e-3 + i * step * UM, 28e-3 + (i + 0.9) * step * UM) for i in range(journals))
    walls = found_walls(D, d, band * UM)
    assert len(walls) == bores + journals - 1
    assert walls == sorted(walls)
    for bore in D:
        for journal in d:
            wanted = (sum(bore) / 2 - sum(journal) / 2 - band * UM) / 2
            assert min(abs(w - wanted) for w in walls) < 2e-6


@pytest.mark.parametrize(
    ("changes", "key", "words"),
    [
        ({"bore_classes_mm": [[31.0, 31.009], [31.008, 31.016]]}, "bore_classes_mm", "rising and apart"),
        ({"journal_classes_mm": [[27.994, 28.0], [27.987, 27.993]]}, "journal_classes_mm", "rising and apart"),
        ({"journal_classes_mm": [[28.0, 27.99]]}, "journal_classes_mm", "pairs of numbers in mm"),
        ({"journal_classes_mm": []}, "journal_classes_mm", "pairs of numbers in mm"),
        ({"journal_classes_mm": [[27.9, True]]}, "journal_classes_mm", "pairs of numbers in mm"),
        ({"journal_classes_mm": [[27.9, float("nan")]]}, "journal_classes_mm", "pairs of numbers in mm"),
        ({"bore_classes_mm": [[31.0, 31.008, 31.01]]}, "bore_classes_mm", "pairs of numbers in mm"),
        ({"bore_classes_mm": ["31.0"]}, "bore_classes_mm", "pairs of numbers in mm"),
        ({"walls_mm": [[1.484, 1.489], [1.488, 1.492]]}, "walls_mm", "rising and apart"),
        ({"walls_mm": [[14.84, 14.88]]}, "walls_mm", "walls of 0.5 to 10 mm"),
        ({"walls_mm": [[0.484, 0.488]]}, "walls_mm", "walls of 0.5 to 10 mm"),
        ({"clearance_band": (2e-3, 2.2e-3)}, "clearance_band_um", "walls of 0.5 to 10 mm"),
        ({"bore_classes_mm": [[61.0, 61.01]]}, "clearance_band_um", "walls of 0.5 to 10 mm"),
        ({"clearance_band": (50e-6, 23e-6)}, "clearance_band_um", "least before most"),
        ({"clearance_band": (50e-6, 50e-6)}, "clearance_band_um", "least before most"),
        ({"pick": PICK}, "pick", "needs walls_mm"),
        ({"walls_mm": WALLS, "pick": [[1, 0]]}, "pick", "2 rows (bore classes) of 2 numbers (journal classes)"),
        ({"walls_mm": WALLS, "pick": [[1, 0], [2]]}, "pick", "2 rows"),
        ({"walls_mm": WALLS, "pick": [[1, 0], [3, 1]]}, "pick", "from 0 to 2"),
        ({"walls_mm": WALLS, "pick": [[1, 0], [-1, 1]]}, "pick", "from 0 to 2"),
        ({"walls_mm": WALLS, "pick": [[1, 0], [1.5, 1]]}, "pick", "from 0 to 2"),
    ],
)
def test_classes_that_make_no_sense_are_told_by_their_key(changes, key, words):
    ((where, why),) = classes(**changes).problems()
    assert where == key and words in str(why)


def test_classes_that_make_sense_are_told_nothing():
    for changes in ({}, {"walls_mm": WALLS}, {"walls_mm": WALLS, "pick": PICK}, {"bore_classes_mm": BORES[:1]}):
        assert not list(classes(**changes).problems())


def test_all_that_is_wrong_of_the_classes_is_told_at_once():
    wrong = classes(journal_classes_mm=[[1]], bore_classes_mm=[[2]], clearance_band=(2e-6, 1e-6))
    assert [key for key, _ in wrong.problems()] == ["journal_classes_mm", "bore_classes_mm", "clearance_band_um"]
