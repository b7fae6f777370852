"""The source's bearings as the search sees them, with the room that the shaft leaves and without any, and what it
finds: once for all tests."""

from dataclasses import replace

import pytest

from calc.bearings.plain.selection.search import search
from calc.design.step_inputs import bearings_case
from calc.design.toml_file import design
from calc.solve import solve


@pytest.fixture(scope="session")
def tight(gamma, gamma_results):
    """The source's design, whose front journal has room for 28.3 mm."""
    return bearings_case(design(gamma), solve, gamma_results)


@pytest.fixture(scope="session")
def loaded(tight):
    """The same under 5.5 kN each, which no journal of its length carries at every corner, however smooth."""
    rows = tuple(replace(row, load=5500.0) for row in tight.rows)
    return replace(tight, rows=rows, results=tight.solve(tight.bearings, rows))


@pytest.fixture(scope="session")
def fitting(loaded):
    return search(loaded)


@pytest.fixture(scope="session")
def source(gamma):
    """The same without an outline, so that no room is known."""
    made = design(gamma)
    return bearings_case(made.with_shaft(replace(made.own, outer_radius=None, core_radius=None)), solve)


@pytest.fixture(scope="session")
def found(source):
    return search(source)
