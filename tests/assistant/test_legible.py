# SPDX-License-Identifier: Apache-2.0
"""What a design file says is never obeyed by the terminal."""

from rich.segment import Segment
from textual.color import Color

from assistant.line_filters import Legible
from assistant.session.session import Session
from tests.assistant.conftest import Screen
from tests.assistant.driving import screen_rows


async def test_control_characters_of_a_name_do_not_reach_the_terminal(screen: Screen, light: Session) -> None:
    light.apply([r'name="red\u001b[31m \u202ehidden"', r'accepted.imbalance.order_1_couple="\u009b2J [b]agreed[/b]"'])
    assert "\x1b" in light.design.name
    async with screen() as pilot:
        rows = "".join(screen_rows(pilot))
        assert r"red\u001b[31m" in rows and not any(letter in rows for letter in "\x1b\x9b\u202e")


async def test_markup_of_a_name_is_printed_as_it_stands(screen: Screen, light: Session) -> None:
    light.apply(['name="a [red]b[/red] [@click=app.quit]c[/]"'])
    async with screen() as pilot:
        rows = "\n".join(screen_rows(pilot))
        assert "a [red]b[/red]" in rows


def test_a_line_stays_as_wide_as_it_was() -> None:
    line = [Segment("name \x1b[31m\u202e"), Segment("    after   "), Segment("│")]
    filtered = Legible().apply(line, Color(0, 0, 0))
    assert "".join(one.text for one in filtered) == "name \\u001b[31m\\u202e "
    assert Segment.get_line_length(filtered) == Segment.get_line_length(line)
    plain = [Segment("plain")]
    assert Legible().apply(plain, Color(0, 0, 0)) is plain
