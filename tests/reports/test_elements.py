# SPDX-License-Identifier: Apache-2.0
"""A proof follows the element that its number is made from, through arrays that are put together from several."""

import numpy as np

from calc.locale import language
from calc.sheet.expression import governing
from calc.sheet.value import Line
from calc.studies.explain import shortened
from reports.blocks.proof import _given
from reports.context import Context, Origins
from tests.reports.reading import Solved, text_of


def line_of(example: Solved, step: str, symbol: str) -> Line:
    return next(line for line in example.results.outcomes[step].lines if line.formula.symbol == symbol)


def test_of_an_array_put_together_only_what_gave_the_element_is_followed(example: Solved) -> None:
    stress, origins = line_of(example, "countershaft", "σ"), Origins()
    index = governing(stress)
    assert index is not None and np.shape(stress.value) == (8,)
    lines, inputs = origins.of((stress, index))
    found = {line.formula.symbol: (line, at) for line, at in lines}
    assert set(found) == {"M", "I"} and found["M"][1] == index, (
        "the core's own fibre is an input: no sector's, no journal's"
    )
    assert inputs == ["shafts.shaft.core_radius_mm"]
    moment, at = found["I"]
    assert at is not None and np.shape(moment.value) == (6,)
    assert moment.value[at] == stress.arguments["I"][index]  # type: ignore[index]


def test_what_follows_gives_the_numbers_above_it(example: Solved) -> None:
    origins, seen = Origins(), 0
    for step, outcome in example.results.outcomes.items():
        for line in outcome.lines:
            if (index := governing(line)) is None or np.size(line.value) < 2:
                continue
            entering = [x[index] for x in line.arguments.values() if getattr(x, "shape", ()) == np.shape(line.value)]  # type: ignore[index]
            for source, at in origins.of((line, index))[0]:
                if at is not None:
                    seen += 1
                    assert any(source.value[at] == number for number in entering) or np.ndim(source.value) == 0, (
                        step,
                        line.formula.symbol,
                    )  # type: ignore[index]
    assert seen > 20


def test_numbers_of_a_formula_that_is_derived_with_others_say_so(engineer: bytes) -> None:
    text = " ".join(text_of(engineer).split())
    assert "9.557 µm [4.1]" in text and "9.979 µm [as in 4.1]" in text and "[3.3]" in text


def test_keys_of_all_elements_of_an_array_in_an_array_are_one_with_what_stands_at_each(example: Solved) -> None:
    places = [f"shafts.shaft.bearings.{row}.position_mm" for row in ("front", "rear")]
    together = "shafts.shaft.bearings.*.position_mm"
    assert shortened([*places, "bearings.oil"], example.results.design) == [together, "bearings.oil"]
    assert shortened(places[:1], example.results.design) == places[:1]
    short = Context(example.document, example.results, "", "engineer", language("en"))
    assert _given(short, together) == "position = −167.5; 167.5 mm"
    assert _given(short, places[0]) == "position of front = −167.5 mm" and _given(short, "bearings.oil").startswith(
        "oil ="
    )
    context = Context(example.document, example.results, "", "audit", language("en"))
    assert _given(context, together) == f"{together} = −167.5; 167.5"
    assert _given(context, places[0]) == f"{places[0]} = −167.5"
    assert _given(context, "shafts.shaft.extras.*.mass_kg") == "shafts.shaft.extras.*.mass_kg", "there are none"
