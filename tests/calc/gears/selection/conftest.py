"""The search for the shifts of the source's train, which takes the better part of a second, once for all of its
tests."""

import pytest

from calc.gears.selection.search import search
from tests.calc.gears.trains import r753


@pytest.fixture(scope="session")
def source():
    return search(r753())
