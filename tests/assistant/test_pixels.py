"""Figures as pixels: which terminals are believed, and that what is written decodes to the picture again."""

import base64
import re

import numpy as np
import pytest

from assistant.screens.curves import CHUNK, iterm2, kitty, protocol, sixel


@pytest.mark.parametrize(
    "environment, how",
    [
        ({"TERM": "xterm-kitty"}, "kitty"),
        ({"TERM_PROGRAM": "iTerm.app"}, "iterm2"),
        ({"TERM_PROGRAM": "WezTerm"}, "iterm2"),
        ({"TERM": "foot-extra"}, "sixel"),
        ({"TERM": "xterm-256color"}, ""),
        ({"TERM": "xterm-kitty", "TMUX": "/tmp/t,1,0"}, ""),
        ({"TERM": "xterm", "CONTRALBERO_PIXELS": "sixel"}, "sixel"),
        ({"TERM": "xterm-kitty", "CONTRALBERO_PIXELS": "none"}, ""),
    ],
)
def test_a_terminal_is_believed_by_what_it_says_of_itself(environment, how):
    assert protocol(environment) == how


def test_pieces_for_kitty_and_iterm2_join_to_the_file():
    file = bytes(range(256)) * 40
    pieces = list(kitty(file))
    heads, bodies = zip(*(re.fullmatch("\x1b_G([^;]*);(.*)\x1b\\\\", piece).groups() for piece in pieces))
    assert base64.b64decode("".join(bodies)) == file and all(len(body) <= CHUNK for body in bodies)
    assert heads[0] == "f=100,a=T,m=1" and {*heads[1:-1]} == {"m=1"} and heads[-1] == "m=0"
    assert base64.b64decode("".join(iterm2(file)).rpartition(":")[2].rstrip("\x07")) == file


def test_a_sixel_picture_has_every_dot_in_its_colour():
    rng = np.random.default_rng(1)
    steps = rng.integers(0, 6, (13, 9, 3))
    steps[4:9, 2:7] = (5, 0, 2)  # dots that follow each other
    text = "".join(sixel((steps * 51).astype(np.uint8)))
    assert text.startswith('\x1bPq"1;1;9;13') and text.endswith("\x1b\\")
    colours = {int(n): tuple(map(int, rgb)) for n, *rgb in re.findall(r"#(\d+);2;(\d+);(\d+);(\d+)", text)}
    body = text[: -len("\x1b\\")].rpartition(";")[2]
    body = body[re.match(r"\d{1,3}(?=#)", body).end() :]
    seen = np.full((18, 9, 3), -1)
    for top, band in enumerate(body.split("-")[:-1]):
        for colour, runs in re.findall(r"#(\d+)((?:!\d+[?-~])*)\$", band):
            at = 0
            for count, bits in re.findall(r"!(\d+)([?-~])", runs):
                for row in range(6):
                    if (ord(bits) - 63) >> row & 1:
                        seen[top * 6 + row, at : at + int(count)] = colours[int(colour)]
                at += int(count)
            assert at == 9
    assert np.array_equal(seen[:13], steps * 20) and (seen[13:] == -1).all()
