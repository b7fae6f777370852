"""Fixtures that every test may use."""

import os
import sys
from pathlib import Path

import pytest

from calc.design_file import Document, read
from calc.design_file import design as checked
from calc.solve import Results, solve

# programs that a test starts keep what they have compiled, as a user's do: it is a second for each
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
sys.dont_write_bytecode = False

ROOT = Path(__file__).parent.parent
DESIGNS = ROOT / "designs"
GAMMA = DESIGNS / "r753ie4_gamma.toml"


@pytest.fixture(scope="session")
def gamma() -> Document:
    """The source's final design, as its file has it."""
    return read(GAMMA)


@pytest.fixture(scope="session")
def gamma_results(gamma: Document) -> Results:
    return solve(checked(gamma))
