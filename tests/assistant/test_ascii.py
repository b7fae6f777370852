# SPDX-License-Identifier: Apache-2.0
"""`--ascii`: no letter beyond 127 on any screen; units, symbols and signs have names of their own."""

import pytest

from assistant import line_filters
from assistant.session.session import Session
from calc.locale import language
from calc.sheet.in_ascii import in_ascii
from calc.sheet.text import Amount, Text
from tests.assistant.conftest import Screen
from tests.assistant.driving import at_rest, screen_rows, settled, until, work

BARE = set("─━│┃┌┐└┘├┤┬┴┼▁▂▃▄▅▆▇█░▒…·\u00a0")  # lines, bars, an end cut off, a point or a space between
WALK = ("f1", "escape", "ctrl+p", "m", "escape")
ELSEWHERE = (
    "f1",
    "f1",
    "escape",
    "C",
    "escape",
    "x",
    "escape",
    "E",
    "escape",
    "ctrl+n",
    "escape",
    "f12",
    "escape",
    "equals_sign",
    "escape",
    "ctrl+t",
    "escape",
)
CHOOSING = ("ctrl+t", "down", "escape")


@pytest.mark.parametrize(
    "text, plain",
    [
        ("3 µm at 40 °C, 2 N·m", "3 um at 40 degC, 2 N*m"),
        ("front · rear", "front - rear"),
        ("η₀ ≥ 9 mm²·s⁻¹", "eta_0 >= 9 mm^2*s^-1"),
        ("Ø 59.5 × 27.5", "dia  59.5 x 27.5"),
        ("altà, naïve, Straße", "alta, naive, Strasse"),
        ("573 → 0, ±2", "573 -> 0, +-2"),
        ("電", "?"),
    ],
)
def test_what_has_a_name_keeps_its_meaning(text: str, plain: str) -> None:
    assert in_ascii(text) == plain
    assert in_ascii(plain) == plain


@pytest.mark.parametrize("code", ["en", "it"])
def test_a_language_says_everything_in_ascii(code: str) -> None:
    say = language(code, ascii=True)
    words = say(
        Text("{value}, needs {limit}", value=Amount(-7.4, "µm"), limit=Text("≥ {least}", least=Amount(9, "µm")))
    )
    assert words.isascii() and "-7" in words and ">= 9 um" in words
    assert say.part(Amount(120000.5, "°C")).isascii() and say("größer") == "grosser"
    assert language(code)("größer") == "größer"


@pytest.mark.parametrize(
    "whole, size",
    [
        (False, (120, 40)),
        pytest.param(True, (120, 40), marks=pytest.mark.slow),
        pytest.param(True, (80, 24), marks=pytest.mark.slow),
    ],
)
async def test_no_letter_beyond_ascii_on_any_screen(
    screen: Screen,
    session: Session,
    light: Session,
    monkeypatch: pytest.MonkeyPatch,
    whole: bool,
    size: tuple[int, int],
) -> None:
    """Steps with calculation and curves, help, palette, dialogs, Ready; and hardly anything has to be made ASCII when
    it stands on the screen already, where a unit would lose its prefix and a limit its equals sign."""
    left: dict[str, str] = {}
    cells = line_filters._cells

    def noted(text: str) -> str:
        left.update({letter: text for letter in set(text) - BARE if not letter.isascii()})
        return cells(text)

    monkeypatch.setattr(line_filters, "_cells", noted)
    async with screen(size, session if whole else light, ascii=True) as pilot:

        async def look(at: str) -> None:
            await settled(pilot)
            await at_rest(pilot)
            assert not [row for row in screen_rows(pilot) if not row.isascii()], at

        for n in "1234567" if whole else "3":
            await pilot.press("escape", "escape", n)
            await look(n)
            for _ in range(2 if whole else 1):
                await pilot.press("f4")
                await look(f"{n}, {work(pilot).turned}")
        for key in (*WALK, *((*ELSEWHERE, "1", *CHOOSING) if whole else ())):
            await pilot.press(key)
            await look(key)
        await until(pilot, lambda: len(pilot.app.screen_stack) == 1)
        work(pilot).action_ready()
        await look("ready")
    assert not left
