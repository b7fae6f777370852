# SPDX-License-Identifier: Apache-2.0
"""Colours: words stand out from what is behind them in every theme that can be chosen, in those of the terminal's own
colours too; a failure and a caution are told apart in sixteen colours and without any."""

from itertools import combinations

import pytest
from rich.color import Color as RichColor
from rich.color import ColorSystem
from rich.color_triplet import ColorTriplet
from rich.style import Style
from textual.color import Color
from textual.theme import BUILTIN_THEMES

from assistant.app import ContralberoApp
from assistant.line_filters import WRITTEN, readable
from assistant.session.session import Session
from assistant.widgets.signs import Signs
from tests.assistant.conftest import solved
from tests.assistant.driving import go_to, work

STATES = ("pass", "warn", "fail", "lit", "accepted", "no_solution")
AA = 4.5  # WCAG 2.2, 1.4.3: of words against what is behind them
# what terminals have for their sixteen colours: the IBM VGA, xterm (its XTerm-col.ad), the Windows console since 2017
PALETTES = {
    "vga": "000000 AA0000 00AA00 AA5500 0000AA AA00AA 00AAAA AAAAAA "
    "555555 FF5555 55FF55 FFFF55 5555FF FF55FF 55FFFF FFFFFF",
    "xterm": "000000 CD0000 00CD00 CDCD00 0000EE CD00CD 00CDCD E5E5E5 "
    "7F7F7F FF0000 00FF00 FFFF00 5C5CFF FF00FF 00FFFF FFFFFF",
    "campbell": "0C0C0C C50F1F 13A10E C19C00 0037DA 881798 3A96DD CCCCCC "
    "767676 E74856 16C60C F9F1A5 3B78FF B4009E 61D6D6 F2F2F2",
}


def ratio(some: tuple[int, int, int], other: tuple[int, int, int]) -> float:
    """As WCAG 2.2 defines the ratio of contrast."""

    def luminance(rgb: tuple[int, int, int]) -> float:
        r, g, b = (v / 255 / 12.92 if v <= 10 else ((v / 255 + 0.055) / 1.055) ** 2.4 for v in rgb)
        return 0.2126 * r + 0.7152 * g + 0.0722 * b

    light, dark = sorted((luminance(some), luminance(other)), reverse=True)
    return (light + 0.05) / (dark + 0.05)


def test_the_ratio_of_contrast_is_that_of_wcag() -> None:
    """The examples of WebAIM's checker: black on white, #777 on white, red on white."""
    assert ratio((0, 0, 0), (255, 255, 255)) == pytest.approx(21)
    assert ratio((0x77, 0x77, 0x77), (255, 255, 255)) == pytest.approx(4.48, abs=0.01)
    assert ratio((255, 0, 0), (255, 255, 255)) == pytest.approx(4.0, abs=0.01)


@pytest.mark.parametrize("name", [name for name, theme in BUILTIN_THEMES.items() if not theme.ansi])
def test_states_are_readable_on_everything_they_stand_on(name: str) -> None:
    """On the page, a dialog, a bar, a field, and the row under the cursor, dimmed or not; and stay different."""
    theme = BUILTIN_THEMES[name]
    known = theme.to_color_system().generate()
    page, surface, primary, text = (
        Color.parse(known[key]) for key in ("background", "surface", "primary", "foreground")
    )
    boost = Color.parse(known["boost"])
    papers = (
        page,
        surface,
        page.blend(boost.with_alpha(1), boost.a),
        page.blend(primary, 0.3),
        surface.blend(primary, 0.3),
    )
    signs = Signs(dark=theme.dark)
    for paper in papers:
        shown = {}
        for state in STATES:
            style = Style.parse(f"{signs.style(state)} on {paper.hex6}")
            seen = readable(style, theme.dark).color
            assert seen is not None and ratio(seen.get_truecolor(), paper.rgb) >= AA - 0.02, (state, paper)
            shown[state] = seen.get_truecolor()
        assert len({shown[state] for state in ("pass", "warn", "fail")}) == 3
        for ink in (text, text.blend(paper, 0.5), primary):
            seen = readable(Style.parse(f"{ink.hex6} on {paper.hex6}"), theme.dark).color
            assert seen is not None and ratio(seen.get_truecolor(), paper.rgb) >= AA - 0.02


def _seen(colour: RichColor | None, default: int, palette: str) -> tuple[int, int, int]:
    """What a terminal shows."""
    if colour is not None and colour.triplet is not None:
        return tuple(colour.triplet)
    number = default if colour is None or colour.number is None else colour.number
    red, green, blue = bytes.fromhex(palette.split()[number])
    return red, green, blue


async def test_a_screen_of_the_terminals_colours_is_readable(light: Session) -> None:
    """The row under the cursor of the findings, the field that has the focus, the palette's chosen row: every word."""
    light.solve()
    app = ContralberoApp(light)
    async with app.run_test(size=(120, 40)) as pilot:
        await solved(pilot)

        def look(at: str, paper: int, ink: int) -> set[str]:
            papers = set()
            for strip in app.screen._compositor.render_strips():
                for text, style, control in strip:
                    if control or style is None or not WRITTEN.search(text):
                        continue
                    front, behind = (style.bgcolor, style.color) if style.reverse else (style.color, style.bgcolor)
                    papers.add(str(behind and behind.name))
                    for terminal, palette in PALETTES.items():
                        pair = _seen(front, ink, palette), _seen(behind, paper, palette)
                        least = AA if style.reverse or (behind and not behind.is_default) else 3.0
                        assert ratio(*pair) >= least, (at, terminal, text, style)
            return papers

        for name, paper, ink in (("ansi-dark", 0, 7), ("ansi-light", 15, 0)):
            app.theme = name
            await go_to(pilot, "engine.bore_mm")
            await pilot.pause()
            assert "color(6)" in look("field", paper, ink)
            work(pilot).checks.focus()
            await pilot.pause()
            assert "color(4)" in look("findings", paper, ink)
            await pilot.press("ctrl+p", "m")
            await pilot.pause()
            look("palette", paper, ink)
            await pilot.press("escape", "escape")


@pytest.mark.parametrize("dark", [True, False])
def test_a_failure_and_a_caution_differ_in_sixteen_colours_and_without(dark: bool) -> None:
    few = Signs(dark=dark, sixteen=True)
    numbers = {}
    for state in ("pass", "warn", "fail"):
        colour = Style.parse(few.style(state)).color
        assert colour is not None
        numbers[state] = colour.downgrade(ColorSystem.STANDARD).number
        assert ratio(colour.get_truecolor(), (0, 0, 0) if dark else (255, 255, 255)) >= AA
    assert len(set(numbers.values())) == 3
    assert few.limit().colour == few.colours["fail"]
    none = Signs(dark=dark, colour=False)
    for one, other in combinations(("fail", "warn", "pass", "note"), 2):
        assert none.mark(one) != none.mark(other)
    assert none.style("fail") != none.style("warn")
    assert set(few.colours) == set(Signs(dark=dark).colours)


async def test_the_terminal_is_asked_how_many_colours_it_has(light: Session, monkeypatch: pytest.MonkeyPatch) -> None:
    app = ContralberoApp(light)
    monkeypatch.setattr(type(app.console), "color_system", property(lambda self: "standard"))
    app.fit_signs()
    assert app.signs.style("fail") == "bold #FF5555"
    monkeypatch.setattr(type(app.console), "color_system", property(lambda self: "truecolor"))
    app.fit_signs()
    assert app.signs.style("fail") == "bold #D55E00"


def test_black_on_a_colour_and_white_on_a_colour() -> None:
    """The better of the two ends is gone to: dark letters on yellow, light ones on blue."""
    on_yellow = readable(Style.parse("#FFE060 on #FFFF55"), True).color
    on_blue = readable(Style.parse("#3040A0 on #0000AA"), True).color
    assert on_yellow is not None and on_yellow.get_truecolor() < ColorTriplet(0x80, 0x80, 0x80)
    assert on_blue is not None and on_blue.get_truecolor() > ColorTriplet(0x80, 0x80, 0x80)
    plain = Style.parse("#FFFFFF on #000000 bold")
    assert readable(plain, True) is plain
