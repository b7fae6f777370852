# SPDX-License-Identifier: Apache-2.0
"""Reports of the shipped example, made once."""

import pytest

from .reading import EXAMPLE, Solved, solved


@pytest.fixture(scope="session")
def example() -> Solved:
    return solved(EXAMPLE.read_bytes())


@pytest.fixture(scope="session")
def engineer(example: Solved) -> bytes:
    return example.report()


@pytest.fixture(scope="session")
def audit(example: Solved) -> bytes:
    return example.report("audit")


@pytest.fixture(scope="session")
def relazione(example: Solved) -> bytes:
    """The engineer report in Italian."""
    return example.report(lang="it")


@pytest.fixture(scope="session")
def summary(example: Solved) -> bytes:
    return example.report("summary")
