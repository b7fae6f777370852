"""Fixtures that every test may use."""

import gc
import os
import sys
import time
from pathlib import Path

import pytest
from _pytest.mark.structures import ParameterSet
from hypothesis import settings

from calc.design.toml_file import Document, read
from calc.design.toml_file import design as checked
from calc.solve import Results, solve
from calc.studies.published import Unmet, ValidationRow, rows, unmet
from calc.studies.shipped import designs, shipped_name

settings.register_profile("untimed", deadline=None)  # how long an example takes depends on what else the machine does
settings.load_profile("untimed")


# programs that a test starts keep what they have compiled, as a user's do: it is a second for each
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
sys.dont_write_bytecode = False
# looking for garbage took a tenth of all tests, of those of the reports a quarter
gc.set_threshold(200_000, 20, 100)

BEGUN = time.monotonic()
ROOT = Path(__file__).parent.parent
DESIGNS = ROOT / "designs"
SCREENED = (
    "../tests/data/upgraded/r754ie4_balance_shafts"  # from DESIGNS: a pair at ±2 that is screened, without [bearings]
)
GAMMA = DESIGNS / "r753ie4_gamma.toml"
SHIPPED = designs()
# of makers' journals, which are alike, the two that are always walked: shells; a bush, a seat of its own, a carrier
RUN_FILES = {path.name: path.read_bytes() for path in DESIGNS.glob("*.csv")}  # that designs name beside them
FEW = [path for path in SHIPPED if path.parent == DESIGNS or path.stem in ("er6n", "l61")]


def each_shipped(*long: str) -> list[ParameterSet]:
    """Every shipped design as a parameter of a test; those that take `long` only where that is asked for."""
    late = [path for path in SHIPPED if path not in FEW or path.stem in long]
    return [
        pytest.param(path, id=shipped_name(path), marks=[pytest.mark.slow] if path in late else []) for path in SHIPPED
    ]


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--within", type=float, default=float("inf"), metavar="SECONDS", help="begin no test after so many seconds"
    )


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item: pytest.Item) -> None:
    if time.monotonic() - BEGUN > item.config.getoption("--within"):
        pytest.skip("no time is left")


def pytest_collection_finish() -> None:
    """The modules and the tests stay: they need not be looked through again and again."""
    gc.freeze()


def pytest_sessionfinish() -> None:
    """The process ends: pytest would look through all that it holds five times."""
    gc.freeze()


@pytest.fixture(scope="session")
def gamma() -> Document:
    """The source's final design, as its file has it."""
    return read(GAMMA)


@pytest.fixture(scope="session")
def gamma_results(gamma: Document) -> Results:
    return solve(checked(gamma))


@pytest.fixture(scope="session")
def validation() -> tuple[list[ValidationRow], list[Unmet]]:
    """Every value of others beside ours: ninety designs are solved for it."""
    return rows(), list(unmet())
