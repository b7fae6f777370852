# SPDX-License-Identifier: Apache-2.0
"""The split line under a turning load: the march against values computed independently, the stored table against the
march."""

import math
import subprocess
import sys
import tomllib
from pathlib import Path

import numpy as np
import pytest

from calc.bearings.plain.film import build_split_line as march
from calc.bearings.plain.film import split_line
from calc.bearings.plain.film.build_split_line import (
    at_rest,
    film_motion,
    least_film_over_turn,
    seat_with_relief,
    smooth_place,
)
from calc.bearings.plain.film.split_line import share, share_at
from calc.bearings.plain.film.table import FilmRangeError, eccentricity_from

REFERENCE = Path(__file__).parents[3] / "reference" / "split_line.toml"
ROWS = tomllib.loads(REFERENCE.read_text(encoding="utf-8"))["row"]
EACH_ROW = pytest.mark.parametrize("row", ROWS, ids=lambda row: f"{row['So']}-{row['depth']}")
ONE_QUICKLY = pytest.mark.parametrize(
    "row",
    [ROWS[0], *(pytest.param(row, marks=pytest.mark.slow) for row in ROWS[1:])],
    ids=lambda row: f"{row['depth']}",
)
SMOOTH, STANDING, TURNING = 0.01, 0.08, 0.05  # relative, as given with the values
RANDOM = np.random.default_rng(1867)
OFF_NODE = [
    (
        math.tanh(RANDOM.uniform(math.atanh(0.1), math.atanh(0.97))),
        math.exp(RANDOM.uniform(math.log(0.12), math.log(1.9))),
        math.exp(RANDOM.uniform(math.log(0.05), math.log(4.0))),
        RANDOM.uniform(0.05, 0.6),
    )
    for _ in range(20)
]


def eccentricity(row: dict[str, float]) -> float:
    return eccentricity_from(1.0 / (2.0 * math.pi * row["So"]), row["length_ratio"])


def relief(row: dict[str, float]) -> tuple[float, float, float]:
    return row["length_ratio"], row["depth"], row["half_arc"]


# --- the march


@ONE_QUICKLY
def test_least_film_over_the_turn(row):
    least = least_film_over_turn(eccentricity(row), *relief(row))
    assert least == pytest.approx(row["turning"], rel=TURNING)


@ONE_QUICKLY
def test_without_relief_the_journal_stays_where_the_film_table_has_it(row):
    length_ratio, _, half_arc = relief(row)
    smooth = least_film_over_turn(eccentricity(row), length_ratio, 0.0, half_arc)
    assert smooth == pytest.approx(row["smooth"], rel=SMOOTH)
    assert smooth == pytest.approx(1.0 - eccentricity(row), rel=SMOOTH)


@pytest.mark.slow
@EACH_ROW
def test_standing_load_over_the_split_at_its_worst_place(row):
    """Load and seat stand: the place at which the journal rests, for a split line at each angle."""
    x, y, load = smooth_place(eccentricity(row), row["length_ratio"])
    seat = seat_with_relief(*relief(row))
    motion, films = at_rest(seat, x, y, 0.0), []
    for turned in np.linspace(0.0, math.pi, 60, endpoint=False):
        for _ in range(300):
            motion = film_motion(seat, x, y, turned, load, motion, runs=False)
            if np.abs(motion.velocity).max() < 1e-3:
                break
            x, y = x + 0.25 * motion.velocity[0], y + 0.25 * motion.velocity[1]
        else:
            raise AssertionError("does not come to rest")
        films.append(1.0 - math.hypot(x, y))
    assert min(films) == pytest.approx(row["standing"], rel=STANDING)


@pytest.mark.parametrize("eccentricity, length_ratio", [(0.3, 1.5), (0.9, 0.3)])
def test_the_film_of_a_smooth_seat_needs_no_velocity(eccentricity, length_ratio):
    """At the place of the film table the load is held by a journal at rest; beside it the film pushes back there."""
    x, y, load = smooth_place(eccentricity, length_ratio)
    seat = seat_with_relief(length_ratio, 0.0, 0.3)
    at_place = film_motion(seat, x, y, 0.4, load, at_rest(seat, x, y, 0.4)).velocity
    assert np.abs(at_place).max() < 0.01 * eccentricity
    nearer = film_motion(seat, 0.95 * x, 0.95 * y, 0.4, load, at_rest(seat, x, y, 0.4)).velocity
    assert nearer @ [x, y] > 0.0


def test_the_load_turns_past_two_equal_halves():
    x, y, load = smooth_place(0.7, 0.5)
    seat = seat_with_relief(0.5, 0.4, 0.25)
    one, other = (film_motion(seat, x, y, at, load, at_rest(seat, x, y, at)).velocity for at in (1.3, 1.3 + math.pi))
    assert other == pytest.approx(one, rel=1e-6)
    assert np.abs(one).max() > 1e-3


def test_the_journal_sinks_where_the_relief_meets_the_pressure():
    """The film is dragged towards −α and narrowest at α = −φ: its pressure stands a little before, at larger α."""
    x, y, load = smooth_place(0.8, 0.5)
    seat, narrowest = seat_with_relief(0.5, 0.5, 0.25), math.atan2(y, x)
    before, beyond, beside = (
        film_motion(seat, x, y, at, load, at_rest(seat, x, y, at)).velocity @ [x, y] / 0.8
        for at in math.pi / 2 - narrowest - np.radians([15.0, -15.0, 90.0])
    )
    assert narrowest < 0.0
    assert before > 0.1 and beyond < 0.0 and abs(beside) < 0.2 * before


# --- the table


@EACH_ROW
def test_share_as_given(row):
    assert share_at(eccentricity(row), *relief(row)) == pytest.approx(row["share"], rel=0.05)


def test_no_relief_loses_nothing():
    assert share_at(0.8, 0.5, 0.0, 0.3) == share_at(0.8, 0.5, 0.3, 0.0) == share_at(0.98, 2.0, 0.0, 0.0) == 1.0
    assert (share_at(np.linspace(0.02, 0.98, 9), 0.5, 0.0, 0.3) == 1.0).all()


def test_a_deeper_and_a_longer_relief_never_leave_more():
    eps = np.tanh(np.linspace(0.0201, 2.29, 13))[:, None, None, None]
    ratio = np.geomspace(0.1, 2.0, 7)[:, None, None]
    depth, arc = np.geomspace(1e-3, 30.0, 41)[:, None], np.linspace(0.01, 1.0, 25)
    left = share_at(eps, ratio, depth, arc)
    assert left.min() == 0.0 and left.max() > 0.99
    assert np.diff(left, axis=2).max() < 1e-12 and np.diff(left, axis=3).max() < 1e-12


def test_a_shallow_relief_loses_in_proportion():
    least = 1.0 - share_at(0.6, 0.5, np.array([1e-4, 2e-4]), 0.3)
    assert least[1] == pytest.approx(2.0 * least[0], rel=1e-3)
    least = 1.0 - share_at(0.6, 0.5, 0.3, np.array([1e-3, 2e-3]))
    assert least[1] == pytest.approx(2.0 * least[0], rel=1e-3)


def test_a_relief_far_deeper_than_the_film_is_a_groove():
    assert share_at(0.98, 0.5, 4.0, 0.1) == share_at(0.98, 0.5, 50.0, 0.1) == share_at(0.98, 0.5, math.inf, 0.1)


def test_four_numbers_give_a_float_and_arrays_are_broadcast():
    assert type(share_at(0.8, 0.5, 0.5, 0.3)) is float
    assert type(share(eps=0.8, b=0.5, depth=0.5, arc=0.3)) is float
    many = share_at(np.array([[0.5], [0.8]]), 0.5, np.array([0.2, 0.5, 1.0]), 0.3)
    assert many.shape == (2, 3) and many[1, 1] == share_at(0.8, 0.5, 0.5, 0.3)
    assert share_at(np.array([]), 0.5, 0.5, 0.3).shape == (0,)
    assert (share(eps=np.array([0.5, 0.8]), b=0.5, depth=0.5, arc=0.3) == many[:, 1]).all()


@pytest.mark.parametrize(
    "place, words",
    [
        ((0.99, 0.5, 0.5, 0.3), ("eccentricity", "0.99", "0.02 to 0.98")),
        ((math.nan, 0.5, 0.5, 0.3), ("eccentricity", "nan")),
        ((0.8, 2.5, 0.5, 0.3), ("l/d", "2.5", "0.1 to 2")),
        ((0.8, 0.5, -0.1, 0.3), ("depth", "−0.1")),
        ((0.8, 0.5, 0.5, 1.2), ("half arc", "1.2", "0 to 1")),
    ],
)
def test_outside_the_table(place, words):
    with pytest.raises(FilmRangeError) as caught:
        share_at(*place)
    assert all(word in str(caught.value) for word in words)
    left = share_at(*(np.array([inside, at]) for inside, at in zip((0.8, 0.5, 0.5, 0.3), place)), outside="nan")
    assert math.isnan(left[1]) and left[0] == share_at(0.8, 0.5, 0.5, 0.3)


@pytest.mark.slow
def test_between_the_nodes():
    off = []
    for eps, ratio, depth, arc in OFF_NODE:
        least, smooth = (least_film_over_turn(eps, ratio, at, arc) for at in (depth, 0.0))
        off.append(abs(share_at(eps, ratio, depth, arc) - max(0.0, least / smooth)))
    assert np.median(off) < 0.01 and max(off) < 0.05


@pytest.mark.slow
@pytest.mark.parametrize("i, j, k", [(2, 1, 3), (5, 3, 1), (-1, -1, 0)])
def test_nodes_come_from_the_march(i, j, k):
    """A row of the table is written again, but for what a deeper relief is not let to gain."""
    eccentricities, length_ratios, depth, half_arcs = march.axes()
    eps, ratio, half_arc = float(eccentricities[i]), float(length_ratios[j]), float(half_arcs[k])
    lost = np.array(march.losses(eps, ratio, half_arc))
    stored = 1.0 - share_at(eps, ratio, depth * (1.0 - eps), half_arc)
    assert stored == pytest.approx(np.clip(lost, 0.0, 1.0), abs=5e-3)


def test_the_table_needs_no_scipy():
    code = (
        "import sys; from calc.bearings.plain.film.split_line import share_at; share_at(0.8, 0.5, 0.5, 0.3);"
        "print([name for name in sys.modules if name.split('.')[0] == 'scipy'])"
    )
    run = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        check=True,
        cwd=Path(split_line.__file__).parents[4],
    )
    assert run.stdout.strip() == "[]"
