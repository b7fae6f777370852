# SPDX-License-Identifier: Apache-2.0
"""Blocks on pages: a figure that does not fit leaves no gap, and stays in its chapter."""

from reports.flow import AFTER, Block, Page, paginate


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


def test_a_table_goes_on_under_a_figure_with_its_header() -> None:
    header = block("header", 10.0)
    rows = [block(f"row {n}", 20.0, repeat=header) for n in range(5)]
    made = paginate([*TEXT[:3], FIGURE, header, *rows], 100.0)
    assert names(made)[1:] == [["figure", "header", "row 1"], ["header", "row 2", "row 3", "row 4"]]
    assert all(page.filled <= 100.0 for page in made)
