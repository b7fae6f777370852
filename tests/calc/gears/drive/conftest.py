# SPDX-License-Identifier: Apache-2.0
"""What the tests of the drive share: the rating of the R753's train, solution gamma."""

import pytest

from calc.design import step_inputs
from calc.gears.rating.load import RatingContext, rating_context
from calc.solve import Results


@pytest.fixture(scope="session")
def context(gamma_results: Results) -> RatingContext:
    design = gamma_results.design
    around = step_inputs.around_gears(design, None)
    return rating_context(design.gears, gamma_results.train, design.materials, around)
