# SPDX-License-Identifier: Apache-2.0
"""Blocks on pages: a figure that does not fit leaves no gap, and stays in its chapter."""

from dataclasses import replace

from reports.typesetting.fonts import HEIGHT
from reports.typesetting.pagination import AFTER, Block, Page, composed, paginate
from reports.typesetting.tags import Tag


def block(name: str, height: float, **kind: object) -> Block:
    return Block(height, lambda pen, y: None, anchor=name, **kind)  # type: ignore[arg-type]


def names(pages: list[Page]) -> list[list[str]]:
    return [[b.anchor for _, b in page.blocks] for page in pages]


TEXT = [block(f"text {n}", 20.0) for n in range(6)]
FIGURE = block("figure", 50.0, floats=True)


def test_text_fills_the_page_before_a_figure_that_does_not_fit() -> None:
    made = paginate([*TEXT[:3], FIGURE, *TEXT[3:]], 100.0)
    assert names(made) == [["text 0", "text 1", "text 2", "text 3", "text 4"], ["figure", "text 5"]]
    assert made[1].blocks[1][0] == 50.0 + AFTER


def test_a_figure_that_fits_stands_where_it_is_given() -> None:
    assert names(paginate([TEXT[0], FIGURE, TEXT[1]], 100.0)) == [["text 0", "figure", "text 1"]]


def test_figures_keep_their_order_and_their_chapter() -> None:
    second = block("second", 10.0, floats=True)
    chapter = block("chapter", 10.0, need=30.0)
    made = paginate([*TEXT[:3], FIGURE, second, TEXT[3], chapter], 100.0)
    assert names(made) == [["text 0", "text 1", "text 2", "text 3"], ["figure", "second"], ["chapter"]]
    assert names(paginate([*TEXT[:3], FIGURE], 100.0)) == [["text 0", "text 1", "text 2"], ["figure"]], "at the end"


def test_no_figure_stands_between_the_rows_of_a_table() -> None:
    """A table that goes on over the page comes first, under its header; the figure that waits stands below it."""
    header, whole = block("header", 10.0), Tag("Table")
    rows = [block(f"row {n}", 20.0, repeat=header, tag=Tag("TR", whole)) for n in range(4)]
    begun = [*TEXT[:3], FIGURE, replace(header, tag=Tag("TR", whole))]
    first = ["text 0", "text 1", "text 2", "header", "row 0"]
    made = paginate([*begun, *rows[:3], TEXT[3]], 100.0)
    assert names(made) == [first, ["header", "row 1", "row 2", "figure"], ["text 3"]]
    made = paginate([*begun, *rows, TEXT[3]], 100.0)
    assert names(made) == [first, ["header", "row 1", "row 2", "row 3", "text 3"], ["figure"]]
    assert all(page.filled <= 100.0 + AFTER for page in made)


def of_gaps(count: int, share: float) -> list[Block]:
    """Blocks of a hundredth of a page, every fourth part of them gap, as many as fill `count` pages and a share of one
    more."""
    height, gap = 0.0075 * HEIGHT, 0.0025 * HEIGHT
    return [Block(height, lambda pen, y: None, gap) for _ in range(round(100 * (count + share)))]


def test_gaps_are_closed_where_that_saves_a_page_with_little_on_it() -> None:
    kept, saved, sparse = of_gaps(5, 0.9), of_gaps(5, 0.3), of_gaps(5, 0.15)
    assert len(composed(kept)) == len(paginate(kept)) == 6
    assert [len(paginate(blocks)) for blocks in (saved, sparse)] == [6, 6] and len(composed(saved)) == len(
        composed(sparse)
    ) == 5


def test_what_takes_no_room_opens_no_page_between_two_sheets() -> None:
    sheet = [block(name, 0.0, page=(500.0, 700.0)) for name in ("one", "two")]
    pages = paginate([block("text", 10.0), block("head", 0.0), sheet[0], block("head", 0.0), sheet[1]], 100.0)
    assert names(pages) == [["text", "head"], ["one", "head"], ["two"]]
