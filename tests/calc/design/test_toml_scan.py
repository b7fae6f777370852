# SPDX-License-Identifier: Apache-2.0
"""Where keys stand, and that hostile text is refused or read in time that grows with its length and no faster."""

import sys
from collections.abc import Callable
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from calc.design.limits import DESIGN_BYTES, DESIGN_DEPTH, DESIGN_ENTRIES, SHOWN_ERRORS
from calc.design.toml_file import design, parse
from calc.sheet.errors import BadInput
from calc.sheet.toml_scan import TOKEN, Beyond, key_lines, remarks
from tests.conftest import GAMMA


def test_lines_of_keys():
    lines = key_lines(
        'a = 1\n# b\n[t]\nx = [\n 1,\n 2]\ny = """\nz = 1\n"""\n[[t.w]]\nn = 1\n[[t.w]]\nn = 2\n[t.w.s]\nq.r = 1\n'
    )
    assert lines["a"] == 1 and lines["t"] == 3 and lines["t.x"] == 4 and lines["t.y"] == 7
    assert "t.z" not in lines
    assert lines["t.w.0.n"] == 11 and lines["t.w.1.n"] == 13 and lines["t.w.1.s.q.r"] == 15


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        ("a = '''\n[x]\n''' # '\nb = 1", {"a": 1, "b": 4}),
        ('a = """\n\\"""\nc = 1\n""""\nb = 1', {"a": 1, "b": 5}),
        ('a = "#[" # "\nb = 1', {"a": 1, "b": 2}),
        ("'a b' . \"c\" = 1\n[ x . y ]\r\nz=1", {"a b.c": 1, "x": 2, "x.y": 2, "x.y.z": 3}),
        ("a = { b = 1, c = [ { d = 1 } ] }\ne = 1", {"a": 1, "e": 2}),
        ("a = [ # [\n]\nb = 1", {"a": 1, "b": 3}),
        ("[a] # ]\nb = '['\nc = 1", {"a": 1, "a.b": 2, "a.c": 3}),
    ],
)
def test_texts_comments_and_tables_in_line_hold_no_keys_of_their_own(text, lines):
    assert key_lines(text) == lines


def test_a_comment_is_that_of_the_key_on_its_line():
    text = (
        '# head\na = "#no" # yes\n# apart\nb = [ # of b\n 1, # inner\n]\nc = 1 #\n[[t]] # first\nn = 1\n[[t]]\nn = '
        "2 ## both = 1 \r\n"
    )
    assert remarks(text) == {"a": "yes", "b": "of b", "t.0": "first", "t.1.n": "both = 1"}
    assert remarks("a = [ 1, # of one\n 2 ] # of both\n") == {"a": "of both"}
    assert remarks('a = [\n 1\n] # closed\nb = """\nx\n""" # ended\nc = { d = 1 } # table') == {
        "a": "closed",
        "b": "ended",
        "c": "table",
    }


def test_a_comment_goes_with_the_value_that_it_is_about():
    made = parse(b"[engine]\nbore_mm = 94 # measured\n[bearings.front]\nlength_mm = 27.5 # assumed\n", "d.toml")
    assert made.remarks == {"engine.bore_mm": "measured", "shafts.0.bearings.0.length_mm": "assumed"}
    assert made.with_value("bearings.front.length_mm", 33.0).remarks == {"engine.bore_mm": "measured"}
    assert made.with_value("engine.crank_radius_mm", 53.5).remarks == made.remarks


def test_a_comment_stays_with_its_element():
    made = parse(
        b'[[gears.wheels]]\nname = "a"\nteeth = 20 # of a\n[[gears.wheels]]\nname = "b"\nteeth = 20 # of b\n', "d.toml"
    )
    a, b = made.data["gears"]["wheels"]
    assert made.remarks == {"gears.wheels.0.teeth": "of a", "gears.wheels.1.teeth": "of b"}
    assert made.with_value("gears.wheels", [b, a]).remarks == {}


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("\n" + "a." * DESIGN_DEPTH + "a = 1", None),
        ("\n" + "a." * (DESIGN_DEPTH + 1) + "a = 1", "nested deeper"),
        ("\n[" + "a." * 500_000 + "a]", "nested deeper"),
        ("\na = " + "[" * DESIGN_DEPTH + "]" * DESIGN_DEPTH, None),
        ("\na = " + "[" * 500_000, "nested deeper"),
        ("\na = " + "{a = " * 200_000, "nested deeper"),
        ("\na = [" + "1," * (DESIGN_ENTRIES - 3) + "]", None),
        ("\na = [" + "1," * DESIGN_ENTRIES + "]", "more than 20,000 entries"),
        ("\n" + "[[a]]" * 200_000, "entries"),
    ],
)
def test_depth_and_number_have_their_limits(text, said):
    if said is None:
        key_lines(text)
        return
    with pytest.raises(Beyond) as beyond:
        key_lines(text)
    assert beyond.value.line == 2 and said in str(beyond.value)
    with pytest.raises(BadInput, match=r"d\.toml:2: is not a design: "):
        parse(text.encode(), "d.toml")


def test_the_size_is_a_limit_of_bytes_from_anywhere():
    parse(b"# " + b"x" * (DESIGN_BYTES - 2), "d.toml")
    with pytest.raises(BadInput, match="at most 1,048,576"):
        parse(b"# " + b"x" * (DESIGN_BYTES - 1), "d.toml")


HOSTILE = {
    "words": lambda n: "a " * (n // 2), "texts not closed": lambda n: '"""\\' * (n // 4), "quotes": lambda n: "'" * n,
    "double quotes": lambda n: '"' * n,
    "escapes": lambda n: 'a = "' + "\\n" * (n // 2) + '"',
    "escaped quotes": lambda n: 'a = """' + '\\"' * (n // 2) + '"""', "lines": lambda n: "\n" * n,
    "returns": lambda n: "\r" * n, "spaces": lambda n: " " * n + "a", "number": lambda n: "a = " + "9" * n,
    "key": lambda n: "a" * n + " = 1", "backslashes": lambda n: "a = '" + "\\" * n + "'",
    "one long name": lambda n: f'[engine]\nname = "{"x" * n}"\nlayout = "{"y" * n}"',
    "comments": lambda n: "#\n" * (n // 2), "brackets": lambda n: "]" * n,
}  # fmt: skip
COUNTED = {
    "unknown keys": lambda n: "".join(f"key{i} = 1\n" for i in range(n)),
    "unknown tables": lambda n: "".join(f"[table{i}]\n" for i in range(n)),
    "one name": lambda n: '[[oil]]\nname = "a"\n' * n,
    "names": lambda n: "".join(f'[[material]]\nname = "m{i}"\n' for i in range(n)),
    "wheels": lambda n: "".join(f'[[gears.wheels]]\nname = "w{i}"\nteeth = "x"\n' for i in range(n)),
    "unbalances": lambda n: "[[imbalance.unbalances]]\n" * n,
    "findings": lambda n: "[accepted]\n" + "".join(f'"check{i}" = 1\n' for i in range(n)),
    "numbers": lambda n: "[engine]\nfiring_order = [" + "1, " * n + "]",
}


def refused(text: str) -> None:
    try:
        design(parse(text.encode(), "d.toml"))
    except BadInput as bad:
        str(bad)


def calls(do: Callable[[], None]) -> int:
    """How many functions are called, those of Python and those written in C."""
    counted = 0

    def count(frame: object, event: str, argument: object) -> None:
        nonlocal counted
        counted += event in ("call", "c_call")

    before = sys.getprofile()
    sys.setprofile(count)
    try:
        do()
    finally:
        sys.setprofile(before)
    return counted


@pytest.mark.parametrize("kind", HOSTILE)
def test_every_letter_is_looked_at_once(kind):
    """No part of the text is taken into two tokens, and none is left out."""
    text = HOSTILE[kind](10_000)
    ends = [token.span() for token in TOKEN.finditer(text)]
    assert all(a[1] == b[0] for a, b in pairwise(ends)) and (ends[0][0], ends[-1][1]) == (0, len(text))


@pytest.mark.parametrize("kind", [*HOSTILE, *COUNTED])
def test_twice_the_text_is_at_most_twice_the_work(kind):
    make, n = (HOSTILE[kind], 50_000) if kind in HOSTILE else (COUNTED[kind], 400)
    refused(make(n))  # what is made once
    assert calls(lambda: refused(make(2 * n))) <= 2.2 * calls(lambda: refused(make(n))) + 1000


@pytest.mark.parametrize("kind", HOSTILE)
def test_the_largest_hostile_text_is_read_or_refused(kind):
    refused(HOSTILE[kind](1_000_000))


@pytest.mark.parametrize("kind", COUNTED)
def test_the_most_entries_are_read_or_refused(kind):
    refused(COUNTED[kind](6_000))


def test_the_first_mistakes_are_printed_and_the_rest_counted():
    with pytest.raises(BadInput) as bad:
        design(parse("".join(f"key{i} = 1\n" for i in range(SHOWN_ERRORS + 7)).encode(), "d.toml"))
    *first, last = str(bad.value).splitlines()
    assert len(first) == SHOWN_ERRORS and all("is not known" in line for line in first[10:])
    assert last == f"d.toml: {len(bad.value.errors) - SHOWN_ERRORS} more mistakes"


@given(st.text("a1.=[]{}\"'\\# \n,-", max_size=80))
def test_any_text_is_scanned_to_its_end(text):
    spans = [token.span() for token in TOKEN.finditer(text)]
    assert all(a[1] == b[0] for a, b in pairwise(spans)) and spans[-1][1] == len(text)
    refused(text)


@given(st.integers(0, len(GAMMA.read_bytes()) - 1), st.sampled_from("[]{}\"'\\#=.,\n"))
def test_a_design_with_one_sign_too_many_is_read_or_refused(place, sign):
    text = GAMMA.read_text("utf-8")
    refused(text[:place] + sign + text[place:])
