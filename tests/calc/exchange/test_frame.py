"""The axes of all files: right-handed both ways, and how numbers and dates stand in them."""

import numpy as np
import pytest

from calc.design.toml_file import design, parse
from calc.exchange.frame import UNDATED, Frame, date_of, frame_of, number
from tests.conftest import DESIGNS, GAMMA

MOUNTED, PAIR = DESIGNS / "r753ie4_mounting.toml", DESIGNS / "timing_pair.toml"


@pytest.mark.parametrize("turn", [1, -1])
def test_a_moment_is_that_of_the_force_at_its_place(turn):
    """A design's moments are y·F_z − z·F_y and so on, whichever hand its axes have."""
    frame = Frame(turn)
    place, force = np.array([3.0, -5.0, 7.0]), np.array([11.0, 13.0, -17.0])
    there = np.cross(frame.place(*place), frame.vector(*force))
    assert np.allclose(frame.moment(*np.cross(place, force)), there)


@pytest.mark.parametrize("turn", [1, -1])
def test_an_angle_turns_up_into_its_direction(turn):
    frame, angle = Frame(turn), 0.7
    turned = frame.vector(np.cos(angle), np.sin(angle), 0.0)
    assert np.allclose(turned[:2], (np.cos(frame.angle(angle)), np.sin(frame.angle(angle))))


def test_products_of_inertia_go_with_the_places():
    frame, place = Frame(-1), (2.0, 3.0, 5.0)
    X, Y, Z = frame.place(*place)
    assert frame.product(2.0 * 3.0, 3.0 * 5.0, 5.0 * 2.0) == (X * Y, Y * Z, Z * X)


def test_the_design_says_how_it_turns():
    text = MOUNTED.read_text(encoding="utf-8")
    assert frame_of(design(parse(text.encode(), "x.toml"))).turn == 1
    turned = text.replace("\n[mounting]", '\n[mounting]\nrotation_seen_from_front = "anticlockwise"', 1)
    frame = frame_of(design(parse(turned.encode(), "x.toml")))
    assert frame.turn == -1 and "about -Z" in frame.words
    assert "is not given" in frame_of(design(parse(GAMMA.read_bytes(), "x.toml"))).words


def test_a_number_reads_back():
    assert [number(value) for value in (np.float64(0.1), -0.0, 3, 1e-30)] == ["0.1", "0.0", "3.0", "1e-30"]


def test_the_date_is_that_of_the_revision():
    rows = "".join(
        f'[[document.changes]]\nrevision = "{revision}"\ndate = "{day}"\nwhat = "x"\n'
        for revision, day in (("A", "2026-03-01"), ("B", "2026-04-02"))
    )
    dated = f'{PAIR.read_text(encoding="utf-8")}\n[document]\nrevision = "B"\n{rows}'
    assert date_of(design(parse(dated.encode(), "x.toml"))) == "2026-04-02"
    assert date_of(design(parse(PAIR.read_bytes(), "x.toml"))) == UNDATED
