# SPDX-License-Identifier: Apache-2.0
"""The search for whole drives beside bearings that roll: they stay as they are, films and shaft are varied."""

from dataclasses import replace

import numpy as np
import pytest

from calc.bearings.rolling.search import as_rolling
from calc.countershaft.rows import BearingRow
from calc.design.step_inputs import rolling_places
from calc.design.toml_file import design, parse
from calc.solve import solve
from calc.studies.drive.classes import class_of
from calc.studies.drive.films import StandingTask, without_film
from calc.studies.drive.problem import problem
from calc.studies.drive.solved_drive import Sized, changes
from tests.calc.bearings import test_choice as choices
from tests.conftest import DESIGNS


def gamma_on(**sizes):
    """The shipped design with these rolling bearings in their places."""
    document = parse((DESIGNS / "r753ie4_gamma.toml").read_bytes(), "gamma.toml")
    made = design(document)
    places = rolling_places(made, solve(made), made.own_name)
    case, _ = choices.case_of(document)
    sides = []
    for row in case.rows:
        rolls = as_rolling(places[row.name], sizes[row.name]) if row.name in sizes else row
        sides.append(choices.c.Side(rolls, "plain", 1.0, 0.1, 0.05, None))
    document, _ = choices.changed(document, choices.c.changes(case, choices.c.ChoiceRow(tuple(sides), case.bearings)))
    return problem(document, 54.0)


def test_what_rolls_stays_and_the_film_is_varied():
    p = gamma_on(front="6306")
    front, rear = (p.keys.of_bearing(place, BearingRow.diameter) for place in ("front", "rear"))
    assert p.keys.on_films == ("rear",) and p.seat == "rear" and p.rolling == {"front": pytest.approx((30, 19, 72))}
    assert p.sizes[front] == pytest.approx((30.0,)) and len(p.sizes[rear] or ()) > 10
    assert "The front bearing rolls, and stays as it is." in p.said
    sized = Sized(
        p.classes[0], 15.0, {"front": 30.0, "rear": 80.0}, {"front": 19.0, "rear": 25.0}, {"rear": 90.0}, None
    )
    written = changes(p, sized)
    assert not any(".front." in key for key in written) and written[rear] == 80.0
    assert written[p.keys.outer] == pytest.approx(40.0 - p.threaded)


@pytest.mark.slow
def test_the_front_of_a_class_has_its_loss():
    p = gamma_on(front="6306")
    few = replace(p, sizes={**p.sizes, p.keys.of_bearing("rear", BearingRow.diameter): (82.0,)})
    found = class_of(few, few.classes[0])  # on arrays, with the loss of the one that rolls
    assert len(found.rows) and np.allclose(found.rows.diameter[:, 0], 0.03) and (found.rows.power > 9.0).all()


def test_where_all_roll_there_is_no_film_to_vary():
    p = gamma_on(front="6306", rear="NU1011")
    assert p.keys.on_films == () and any("There is no film to vary" in words for words in p.said)
    assert len(p.sizes[p.keys.core] or ()) > 5 and p.keys.material in p.choices
    assert p.seats({"front": 30.0, "rear": 55.0}) == pytest.approx(90.0)


def test_what_has_no_film_bears_every_slope():
    films = without_film(StandingTask("front", 0.03, 0.072), 0.019, 9.2)
    assert films.opening == 0.072 and films.bears(3e-6, 0.1, 2.5e-4) == pytest.approx(np.array([[2.25e-4]]))
