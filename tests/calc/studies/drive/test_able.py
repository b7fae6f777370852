# SPDX-License-Identifier: Apache-2.0
"""Whether the whole drive of a design can be searched, and why not, in words for whoever wants to."""

import pytest

from calc.design.toml_file import Document, design, read
from calc.solve import Results, solve
from calc.studies.drive import able
from calc.studies.drive.able import unable
from tests.conftest import DESIGNS


def why(name: str, *changes: tuple[str, object]) -> str:
    document = read(DESIGNS / f"{name}.toml")
    for key, new in changes:
        document = document.with_value(key, new)
    return unable(document, solve(design(document)))


def test_a_drive_that_can_be_searched(gamma: Document, gamma_results: Results) -> None:
    assert unable(gamma, gamma_results) == ""
    assert "has to" in unable(gamma, gamma_results, {"shaft": "other"}) or "no shaft" in unable(
        gamma, gamma_results, {"shaft": "other"}
    )


def test_what_is_missing_is_named() -> None:
    assert why("r753ie4_alpha") == "The whole drive is searched once the design has these steps: bearings."
    assert why("thesis_oils").endswith("these steps: engine, imbalance, counter-shaft, bearings.")


def test_a_package_that_is_needed_is_named_with_what_installs_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(able, "installed", lambda: False)
    assert "needs the package pymoo: `pip install 'contralbero[search]'` installs it" in why("r753ie4_rolling")
    monkeypatch.setattr(able, "installed", lambda: True)
    assert why("r753ie4_rolling") == ""
