# SPDX-License-Identifier: Apache-2.0
"""Where the watts go: bands as wide as the losses, which together are all that the train takes in."""

import pytest

from calc.design.toml_file import design, load
from calc.draw.drawing import Area, Polyline, Words
from calc.friction.sketch import sketch
from calc.solve import solve
from tests.calc import sketches
from tests.conftest import DESIGNS


def widths(flow):
    """The bands where they begin and where they end."""
    bands = [mark.outlines[0] for mark in flow.primitives if isinstance(mark, Area)]
    half = [len(band) // 2 for band in bands]
    return [band[0][1] - band[-1][1] for band in bands], [band[n - 1][1] - band[n][1] for band, n in zip(bands, half)]


@pytest.mark.parametrize("name", ["r753ie4_gamma", "r754ie4_balance_shafts", "timing_pair"])
def test_the_bands_are_as_wide_as_the_losses(name):
    document, asked = load(DESIGNS / f"{name}.toml")
    results = solve(asked)
    flow, found = sketch(asked, results), results.outcomes["friction"].result
    sketches.check(flow, document)
    if name.startswith("r754"):  # with the sectors' own loss, none of these files counts it
        lossy = document.with_value("friction.mass_loss", "bracket")
        asked = design(lossy)
        results = solve(asked)
        flow, found = sketch(asked, results), results.outcomes["friction"].result
        assert found.mass_loss > 0
    before, behind = widths(flow)
    (_, top), (_, bottom) = next(mark for mark in flow.primitives if isinstance(mark, Polyline)).points
    assert sum(before) == pytest.approx(top - bottom)  # they fill the line that the flow begins at
    assert before == pytest.approx(behind)
    scale = (top - bottom) / found.total_loss
    assert any(str(mark.text).endswith("turning masses") for mark in flow.primitives if isinstance(mark, Words)) is (
        scale * (found.mass_loss or 0.0) > 0.01 * (top - bottom)
    )
    largest = max(
        [mesh.judged.loss for mesh in found.meshes.values()]
        + [journal.friction_power for journals in found.journals.values() for journal in journals.values()]
    )
    assert max(before) / sum(before) == pytest.approx(largest / found.total_loss)


def test_what_a_train_passes_on_is_told():
    _, asked = load(DESIGNS / "timing_pair.toml")
    assert any("passed on" in str(note) for note in sketch(asked, solve(asked)).notes)
