# SPDX-License-Identifier: Apache-2.0
"""Who no longer waits ends what is being computed, in the middle of it."""

import numpy as np
import pytest

from calc.bearings.plain.routes.thermal_balance import settled
from calc.bearings.result import BearingsResult
from calc.sheet.errors import Cancelled
from calc.sheet.progress import go_on, waited_for
from calc.solve import Results, solve


def enough(times: int) -> tuple[list[int], object]:
    """Asked so many times, the next ends it."""
    asked: list[int] = []

    def by(*_: object) -> None:
        asked.append(1)
        if len(asked) > times:
            raise Cancelled

    return asked, by


def test_nobody_waits_until_somebody_does() -> None:
    go_on()
    asked, by = enough(1)
    with waited_for(by):
        go_on()
        with pytest.raises(Cancelled):
            go_on()
    go_on()
    assert len(asked) == 2


def test_films_of_many_points_are_left_where_nobody_waits(gamma_results: Results) -> None:
    found = gamma_results.result(BearingsResult)
    assert found is not None
    bearing = found.plain["front"]
    loads = bearing.duty.load * np.linspace(0.9, 1.1, 5)
    many = bearing.duty.__class__(**{**vars(bearing.duty), "load": loads})
    assert np.all(np.isfinite(settled(bearing.seat, many).film))
    asked, by = enough(1)
    with waited_for(by), pytest.raises(Cancelled):
        settled(bearing.seat, many)
    assert len(asked) == 2


def test_a_solve_is_left_between_its_parts(gamma_results: Results) -> None:
    asked, by = enough(1)
    with waited_for(by), pytest.raises(Cancelled):
        solve(gamma_results.design)
    assert len(asked) == 2
