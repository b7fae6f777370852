# SPDX-License-Identifier: Apache-2.0
"""Forces and couples that turn: what is drawn is what the crank asks for, what the shaft supplies, and what is left."""

import math

import pytest

from calc.design.toml_file import load
from calc.draw.drawing import Polyline
from calc.imbalance.sketch import sketch
from calc.solve import solve
from tests.calc import sketches
from tests.conftest import DESIGNS, SCREENED


def arrows(picture):
    return {mark.key: mark.points[1] for mark in picture.primitives if isinstance(mark, Polyline) and mark.arrow}


@pytest.mark.parametrize("angle", [0.0, 1.2, 4.0])
def test_the_shaft_turns_back_and_takes_what_the_crank_leaves(angle):
    """A couple of order 1 of 573 N·m: half of it stands still in size and turns against the crank, and so does that of
    the shaft."""
    document, asked = load(DESIGNS / "r753ie4_gamma.toml")
    results = solve(asked)
    picture = sketch(asked, results, angle=angle)
    sketches.check(picture, document)
    assert picture.turning and str(picture.title).startswith("couple")
    shaft = complex(*arrows(picture)["countershaft"])
    _, supplied = results.outcomes["countershaft"].result.vectors
    assert abs(shaft) == pytest.approx(abs(supplied))
    now, then = (complex(*arrows(sketch(asked, results, angle=at))["countershaft"]) for at in (angle, angle + 0.1))
    back = (then / now).imag
    crank, later = (
        complex(*arrows(sketch(asked, results, angle=at))["imbalance.crank_balance_fraction"])
        for at in (angle, angle + 0.1)
    )
    # what is left on the crank turns back too
    assert abs(back) == pytest.approx(math.sin(0.1)) and back * (later / crank).imag > 0
    required = results.values()["imbalance.required_couple"].shown
    assert any(f"{required:.3g}" in word for word in sketches.words(picture))


@pytest.mark.parametrize("angle", [0.0, 0.7])
def test_a_pair_at_twice_crank_speed_leaves_what_its_step_says(angle):
    document, asked = load(DESIGNS / f"{SCREENED}.toml")
    results = solve(asked)
    picture = sketch(asked, results, angle=angle)
    sketches.check(picture, document)
    shafts = complex(*arrows(picture)["countershaft"])
    # both together stand upright, each with half of the force that the source's masses make
    assert shafts == pytest.approx(1j * -2 * 4268.1 * math.cos(2 * angle), abs=1.0)
    assert "the shafts 8540" in sketches.words(picture) and "left 2080" in sketches.words(picture)
