# SPDX-License-Identifier: Apache-2.0
"""The picture of a step on the screen: it follows the step, waits in words, turns by keys, and never stops the
session."""

import pytest
from textual.app import ComposeResult

from assistant.base_app import BaseApp
from assistant.session.recovery import Memory
from assistant.session.session import Session
from assistant.widgets import picture
from assistant.widgets.canvas import draw
from assistant.widgets.picture import Picture
from assistant.widgets.signs import Signs
from calc.design.toml_file import Document, design, load, read
from calc.engine.sketch import icon
from calc.locale import language
from calc.solve import solve
from calc.studies.shipped import engine_inputs, engines
from tests.calc.bearings.plain.test_seat_inputs import document
from tests.conftest import DESIGNS, GAMMA, SCREENED


class Stage(BaseApp):
    """Only the picture."""

    def compose(self) -> ComposeResult:
        yield Picture()


@pytest.fixture
async def shown(tmp_path):
    """The picture, and a way to see what stands in it."""
    app = Stage(Session.open(GAMMA, memory=Memory(tmp_path)))
    app.animation_level = "none"
    async with app.run_test(size=(60, 18)) as pilot:
        yield app.query_one(Picture), pilot


@pytest.fixture(scope="module")
def gamma():
    _, design = load(GAMMA)
    return design, solve(design)


async def test_it_shows_each_step_and_says_what_it_waits_for(shown, gamma):
    drawing, _ = shown
    design, results = gamma
    drawing.show("engine", design, results)
    engine = drawing.render()
    assert "fires 1-3-2" in engine.plain
    drawing.show("engine", design, results, "engine.bore_mm")
    assert drawing.render().spans != engine.spans
    drawing.show("imbalance", design, None)
    assert drawing.render().plain == "The picture waits for the results of the step Imbalance."


async def test_the_seat_comes_first_while_an_input_of_it_alone_is_edited(shown):
    """One that the film shows too leaves the picture as it is."""
    drawing, _ = shown
    seated = design(document())
    results = solve(seated)
    for key, title in (
        ("shafts.shaft.bearings.front.diameter_mm", "front Ø28"),
        ("shafts.shaft.bearings.rear.wall_mm", "rear: bush"),
        ("bearings.select.journal_classes_mm", "front: shells"),
        ("bearings.lowest_temperature_C", "front Ø28"),  # in no picture
    ):
        drawing.show("bearings", seated, results, key)
        assert drawing.render().plain.splitlines()[0].strip().startswith(title), key
    drawing.view = 2
    drawing.show("bearings", seated, results, "bearings.select.journal_classes_mm")
    assert "rear: bush" in drawing.render().plain  # who has leafed stays


async def test_keys_turn_what_turns(shown, gamma):
    drawing, pilot = shown
    drawing.show("imbalance", *gamma)
    before = drawing.render().plain
    drawing.focus()
    await pilot.press("right", "right")
    assert "crank at 20°" in drawing.render().plain and drawing.render().plain != before
    await pilot.press("left", "left", "left")
    assert "crank at 350°" in drawing.render().plain
    drawing.show("engine", *gamma)
    drawing.render()
    await pilot.press("right")
    assert drawing.degrees == 350


async def test_a_fault_in_a_sketch_is_one_quiet_line(shown, gamma, monkeypatch):
    def broken(*_):
        raise ZeroDivisionError

    monkeypatch.setattr(picture, "sketch_of", broken)
    drawing, _ = shown
    drawing.show("engine", *gamma)
    assert drawing.render().plain == "The picture of this step cannot be drawn."


async def test_it_turns_by_itself_only_with_the_focus_and_animations(shown, gamma):
    drawing, pilot = shown
    drawing.show("imbalance", *gamma)
    drawing.render()
    drawing.blur()
    await pilot.pause()
    pilot.app.animation_level = "full"
    drawing.focus()
    await pilot.pause(0.5)
    turned = drawing.degrees
    assert turned > 0 and turned % 20 == 0
    drawing.blur()
    await pilot.pause()
    turned = drawing.degrees
    await pilot.pause(0.3)
    assert drawing.degrees == turned


@pytest.mark.parametrize("name", engines())
def test_every_shipped_engine_has_its_icon(name):
    lines = draw(icon(engine_inputs(name)), 16, 5, Signs(), language("en")).plain.split("\n")
    assert [len(line) for line in lines] == [16] * 5
    assert sum(letter != " " for line in lines for letter in line) > 15


LEFT = {
    "name": "left",
    "material": "steel",
    "speed_ratio": 2,
    "axis_mm": [-60.0, -95.0],
    "bearings": [{"name": "front", "position_mm": -112.0}, {"name": "rear", "position_mm": 112.0}],
    "masses": [{"name": "a", "mass_kg": 0.9, "radius_mm": 12.0, "angle_deg": 180.0, "z_mm": 0.0}],
}
SHAFTS = [
    LEFT,
    {"name": "right", "mirrors": "left"},
    LEFT | {"name": "first", "speed_ratio": -1, "axis_mm": [90.0, 60.0]},
    {"name": "back", "repeats": "first"} | {"axis_mm": [90.0, -60.0]},
]


@pytest.mark.parametrize("columns", [120, 80])
@pytest.mark.parametrize("count", [1, 2, 3, 4])
async def test_every_shaft_is_named_beside_the_crank(shown, columns, count):
    """At both widths of a terminal; where one of them is no twin each is a picture to leaf to."""
    drawing, pilot = shown
    await pilot.resize_terminal(columns, 24)
    await pilot.pause()
    four = {key: part for key, part in read(DESIGNS / f"{SCREENED}.toml").data.items() if key != "shafts"}
    asked = design(Document(four | {"shafts": SHAFTS[:count]}))
    results = solve(asked)
    drawing.show("countershaft", asked, results)
    text = drawing.render().plain
    for shaft, n in zip(SHAFTS[:count], (2, 2, 1, 1)):
        assert (f"{shaft['name']} ×{n}" in text) == (count > 1 or columns > 80)  # of one it is the picture missed least
    assert max(map(len, text.splitlines())) <= columns and not drawing.turns
    if count > 2:
        drawing.action_leaf(2)
        assert drawing.render().plain != text and drawing.views == 4
