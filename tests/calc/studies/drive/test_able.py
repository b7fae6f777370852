# SPDX-License-Identifier: Apache-2.0
"""Whether the whole drive of a design can be searched, and why not, in words for whoever wants to."""

from dataclasses import replace

import pytest

from calc.design.toml_file import Document, design, parse, read
from calc.sheet.errors import NoSolution
from calc.sheet.text import Text
from calc.solve import Results, solve
from calc.studies.drive import able
from calc.studies.drive.able import unable
from calc.studies.shipped import engine_design
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
    assert "needs the extra `search`: pip install 'contralbero[search]'" in why("r753ie4_rolling")
    monkeypatch.setattr(able, "installed", lambda: True)
    assert why("r753ie4_rolling") == ""


@pytest.mark.slow
def test_a_shaft_with_a_twin_and_classes_of_parts_is_begun_from_its_own_bearings() -> None:
    """Its clearances are those of its own solved films; the palette asks this of every design that is open."""
    document = parse(engine_design("inline-4", "second").encode(), "four")
    shaft = document.data["shafts"][0]
    two = [row for row in shaft["bearings"] if row["name"] != "middle"]
    document = replace(
        document, data={**document.data, "shafts": [{**shaft, "bearings": two}, *document.data["shafts"][1:]]}
    )
    results = solve(design(document))
    assert any(row.seat == "shells" for row in results.design.rows)
    assert unable(document, results, {"shaft": "left"}) in ("", unable(document, results))
    assert "solved" not in unable(document, results)


def test_what_can_not_be_begun_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    def none(*_: object) -> object:
        raise NoSolution(Text("the bearings"), Text(""), Text("a design whose bearings are solved"))

    monkeypatch.setattr(able, "asked_of", none)
    assert why("r753ie4_gamma").startswith("The whole drive can not be searched: the bearings")
