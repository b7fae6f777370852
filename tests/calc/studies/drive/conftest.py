# SPDX-License-Identifier: Apache-2.0
"""A search that is small enough for a test: few values of each size, everything else as in the shipped design."""

import pytest

from calc.design.toml_file import read
from calc.studies.drive.search import asked
from tests.conftest import DESIGNS

FEW = {
    "shafts.shaft.core_radius_mm": {"from": 13.0, "to": 17.0, "step": 1.0},
    "shafts.shaft.bearings.rear.diameter_mm": [84.0, 85.0, 86.0],
    "shafts.shaft.bearings.front.diameter_mm": [58.5, 62.0, 66.0],
    "shafts.shaft.material": ["20CrNi4"],
    "bearings.supply": ["hole"],
}


@pytest.fixture(scope="package")
def sized():
    # fillets that take room
    return read(DESIGNS / "r753ie4_sized.toml").with_value("shafts.shaft.fillet_radius_mm", 1.5)


@pytest.fixture(scope="package")
def few(sized):
    problem, _ = asked(sized, {"vary": FEW, "rows": 8})
    return problem
