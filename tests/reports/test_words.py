"""What a report says to its reader: inputs by their names, not by the keys of the file."""

import re

import pytest

from calc.design.toml_file import design, read
from calc.sheet.text import Text
from calc.solve import Results, solve
from calc.studies.shipped import EXAMPLE
from tests.conftest import DESIGNS

KEY = re.compile(r"\b[a-z]{2,}_[a-z_]{2,}\b|\[\[?[a-z.]+\]\]?|\b(?:engine|gears|shafts|friction|mounting)\.[a-z]+\b")
SAYS_WHAT_TO_TYPE = "choose FILE"


@pytest.fixture(scope="module", params=["r754ie4_balance_shafts", "twin_drive", "r753ie4_mounting", EXAMPLE.stem])
def results(request: pytest.FixtureRequest) -> Results:
    return solve(design(read(DESIGNS / f"{request.param}.toml")))


def test_notes_and_advice_name_no_keys(results: Results) -> None:
    told: list[Text] = [note for outcome in results.outcomes.values() for note in outcome.notes]
    told += [check.advice for check in results.checks()]
    assert len(told) > 100
    assert [str(text) for text in told if KEY.search(str(text)) and SAYS_WHAT_TO_TYPE not in text] == []
