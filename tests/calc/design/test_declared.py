# SPDX-License-Identifier: Apache-2.0
"""What is declared can be named by its declaration: a rename is one edit, and a misspelling an error of the types."""

from calc.bearings.inputs import BearingInputs
from calc.bearings.result import BearingResult
from calc.design.model import Design
from calc.design.toml_file import design, read
from calc.engine.inputs import EngineInputs
from calc.engine.result import EngineResult
from calc.sheet.quantity import dotted
from calc.solve import solve
from calc.studies.shipped import EXAMPLE


def test_keys_and_ids_are_those_of_file_and_report() -> None:
    assert dotted(Design.engine, EngineInputs.bore) == "engine.bore_mm"
    assert dotted(Design.bearings, "front", BearingInputs.length) == "bearings.front.length_mm"
    assert dotted(Design.engine, EngineResult.stroke) == "engine.stroke"


def test_a_value_is_found_by_its_declaration() -> None:
    results = solve(design(read(EXAMPLE)))
    stroke = results.value(EngineResult.stroke)
    assert stroke is not None and stroke.id == "engine.stroke"
    films = results.values_of(BearingResult.film_edge)
    assert [v.id for v in films] == ["bearings.front.film_edge", "bearings.rear.film_edge"]
