# SPDX-License-Identifier: Apache-2.0
"""Pictures and curves stay within their frames, with their titles whole, however large or small the frames are."""

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from rich.cells import cell_len
from textual.app import ComposeResult
from textual.pilot import Pilot

from assistant import app
from assistant.base_app import BaseApp
from assistant.session.recovery import Memory
from assistant.session.session import Session
from assistant.widgets.canvas import Spread, _below, arranged, draw
from assistant.widgets.curve_pane import CurvePane
from assistant.widgets.picture import sketch_of
from assistant.widgets.signs import Signs
from calc.design.model import STEPS, Design
from calc.design.toml_file import load
from calc.draw.drawing import Sketch
from calc.locale import language
from calc.locale.language import said
from calc.sheet.step import Curve, Table
from calc.solve import Results, solve
from tests.assistant.driving import at_rest, screen_rows
from tests.conftest import DESIGNS, FEW

SAY, SIGNS = language("en"), Signs()
LARGE, SMALL = ((250, 70), (118, 34), (78, 17)), ((57, 22), (47, 13), (30, 9), (18, 6))  # columns and rows
DRIVE = "r753ie4_drive_over_speed"
BRAILLE, DRAWN = "[\u2801-\u28ff]", "[\u2801-\u28ff▀-▟]"  # dots of lines, and what is filled

HINTS = r"(\d+ of \d+)?( · )?(← → reads it.*)?\s*$"  # beside the title


def solved_design(name: str | Path) -> tuple[Design, Results]:
    _, design = load(DESIGNS / f"{name}.toml" if isinstance(name, str) else name)
    return design, solve(design)


@pytest.fixture(scope="module")
def drive() -> tuple[Design, Results]:
    return solved_design(DRIVE)


# --- pictures


def sketches(design: Design, results: Results) -> Iterator[tuple[str, Sketch]]:
    """Each picture of each step, in front of the others."""
    for step in STEPS:
        first = sketch_of(step.key, design, results, 0.0)
        for view in range(first.views if isinstance(first, Sketch) else 0):
            sketch = sketch_of(step.key, design, results, 0.0, view)
            assert isinstance(sketch, Sketch)
            yield f"{step.key}, {view}", sketch


def within(at: str, sketch: Sketch, columns: int, rows: int) -> None:
    """Of the pictures that have room each is in its frame, below its title; between frames nothing is drawn."""
    lines = draw(sketch, columns, rows, SIGNS, SAY).plain.split("\n")
    assert len(lines) == rows and {cell_len(line) for line in lines} == {columns}, at
    pictures = [Spread(picture, SAY) for picture in (sketch, *sketch.beside)]
    shown = [picture for picture, _ in arranged(pictures, columns, rows - len(_below(pictures, columns, rows, SAY)))]
    below = _below(shown, columns, rows, SAY)
    for picture, frame in arranged(shown, columns, rows - len(below)):
        assert 0 <= frame.left < frame.right <= columns and 0 <= frame.top < frame.bottom <= rows - len(below)
        own = [line[frame.left : frame.right] for line in lines[frame.top : frame.bottom]]
        if title := SAY(picture.sketch.title):
            first = next(n for n, row in enumerate(own) if row.strip())
            heading = own[first : first + len(picture.title(frame.columns))]
            assert " ".join(" ".join(heading).split()) == title, (at, columns, rows)
        for n in range(frame.top, frame.bottom):
            lines[n] = lines[n][: frame.left] + " " * frame.columns + lines[n][frame.right :]
    assert not any(line.strip() for line in lines[: rows - len(below)]), (at, columns, rows)


@pytest.mark.parametrize("columns, rows", [LARGE[1], SMALL[1], SMALL[3]])
def test_pictures_of_the_drive_are_within_their_frames(drive: tuple[Design, Results], columns: int, rows: int) -> None:
    for at, sketch in sketches(*drive):
        within(at, sketch, columns, rows)


@pytest.mark.slow
@pytest.mark.parametrize("path", FEW, ids=lambda path: path.stem)
def test_pictures_of_shipped_designs_are_within_their_frames(path: Path) -> None:
    for at, sketch in sketches(*solved_design(path)):
        for columns, rows in (*LARGE, *SMALL):
            within(f"{path.stem}, {at}", sketch, columns, rows)


# --- curves


class Stage(BaseApp):
    """Only the pane of curves."""

    CSS_PATH = Path(app.__file__).with_name("contralbero.tcss")

    def compose(self) -> ComposeResult:
        yield CurvePane()


def axes(lines: list[str]) -> list[tuple[int, int, int]]:
    """The row of the upper and of the lower axis, and where each begins and ends; a mark may lie on it."""
    found = [(n, re.search("[┏┗┻].*━{3}.*[┓┛┻]", line)) for n, line in enumerate(lines)]
    return [(n, *axis.span()) for n, axis in found if axis is not None]


async def framed(
    pilot: Pilot[int], step: str, leaves: tuple[Curve | Table, ...], sizes: tuple[tuple[int, int], ...]
) -> int:
    """How many curves were looked at: of each the title is whole above, and all is drawn within the axes."""
    pane, seen = pilot.app.query_one(CurvePane), 0
    for size in sizes:
        await pilot.resize_terminal(*size)
        pane.show(step, leaves)
        for curve in leaves:
            pane.choose(curve.id)
            if not isinstance(curve, Curve):
                continue
            await pilot.pause()
            await at_rest(pilot)  # the canvas follows the frame
            lines = screen_rows(pilot)
            assert {cell_len(line) for line in lines} == {size[0]}
            heads = [re.sub(HINTS, "", row) for row in lines[: pane.title.size.height]]
            assert "".join("".join(heads).split()) == "".join(curve.title.split()), size
            (top, *ends), (bottom, *others) = axes(lines)
            assert bottom > top + 1 and ends == others, (curve.id, size)
            beside = [row[: ends[0]] + row[ends[1] :] for row in lines[top : bottom + 1]]
            assert not re.search(DRAWN, "".join((*beside, *lines[bottom + 1 :]))), (curve.id, size)
            assert not re.search(BRAILLE, "".join(lines[:top])), (curve.id, size)
            seen += 1
    return seen


async def test_curves_are_within_their_axes(drive: tuple[Design, Results], tmp_path: Path) -> None:
    async with Stage(Session.open(DESIGNS / f"{DRIVE}.toml", memory=Memory(tmp_path))).run_test(size=(80, 24)) as pilot:
        whole = said(drive[1].outcomes["gears"].whole, SAY)
        longest = sorted(whole.curves, key=lambda curve: -len(curve.title))[:3]
        assert await framed(pilot, "gears", tuple(longest), ((47, 17), (78, 18))) == 6


@pytest.mark.slow
@pytest.mark.parametrize("path", FEW, ids=lambda path: path.stem)
async def test_curves_of_shipped_designs_are_within_their_axes(path: Path, tmp_path: Path) -> None:
    _, results = solved_design(path)
    async with Stage(Session.open(path, memory=Memory(tmp_path))).run_test(size=(80, 24)) as pilot:
        for step in STEPS:
            whole = said(results.outcomes[step.key].whole, SAY)
            await framed(pilot, step.key, whole.curves, ((47, 17), (78, 13)))
