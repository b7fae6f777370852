# SPDX-License-Identifier: Apache-2.0
"""What a design file says is never obeyed by the terminal."""

from assistant.session import Session

from .conftest import Screen
from .driving import screen_rows


async def test_control_characters_of_a_name_do_not_reach_the_terminal(screen: Screen, light: Session) -> None:
    light.apply([r'name="red\u001b[31m \u202ehidden"', r'accepted.imbalance.order_1_couple="\u009b2J [b]agreed[/b]"'])
    assert "\x1b" in light.design.name
    async with screen() as pilot:
        rows = "".join(screen_rows(pilot))
        assert "red[31m hidden" in rows and not any(letter in rows for letter in "\x1b\x9b\u202e")
