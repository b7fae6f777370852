# SPDX-License-Identifier: Apache-2.0
"""What the tests of the drive share: the rating of the R753's train, solution gamma."""

import pytest

from calc.design import step_inputs
from calc.design.toml_file import Document, design, read
from calc.gears.rating.load import RatingContext, rating_context
from calc.solve import Results, solve
from tests.conftest import DESIGNS


@pytest.fixture(scope="session")
def context(gamma_results: Results) -> RatingContext:
    design = gamma_results.design
    around = step_inputs.around_gears(design, None)
    return rating_context(design.gears, gamma_results.train, design.materials, around)


@pytest.fixture(scope="session")
def over_speed() -> Results:
    """The same train with gas and flywheel."""
    return solve(design(read(DESIGNS / "r753ie4_drive_over_speed.toml")))


def changed(changes: dict[str, object]) -> Document:
    """The design of that train with other values of keys."""
    document = read(DESIGNS / "r753ie4_drive_over_speed.toml")
    for key, value in changes.items():
        document = document.with_value(key, value)
    return document


@pytest.fixture(scope="session")
def light() -> tuple[Document, Results]:
    """With a third of its flywheel the train is C."""
    document = changed({"engine.flywheel_inertia_kgm2": 0.3})
    results = solve(design(document))
    check = results.check("gears.crank_central.rattle")
    assert check is not None and "made" not in vars(check.remedies)  # before anybody looks
    return document, results
