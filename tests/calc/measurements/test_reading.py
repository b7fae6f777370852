# SPDX-License-Identifier: Apache-2.0
"""Files as benches write them, and what is wrong with others."""

import importlib.util
import io
import math

import pytest

from calc.measurements.reading import Unread, read_csv, read_run
from calc.measurements.units import canonical, conversion

PLAIN = b"n,P\n900,19.5\n1200,\n1500,nan\n"


@pytest.mark.parametrize(
    "raw",
    [
        PLAIN,
        b"\xef\xbb\xbfn,P\r\n900,19.5\r\n1200,\r\n1500,NaN\r\n",
        b"# bench 7\n\nn;P\nrpm;W\n900;19,5\n1200;\n#pause\n1500;nan\n",
        b"n\tP\n900\t1.95e1\n1200\t\n1500\tnan\n",
        b'"n";"P"\n900;"19,5"\n1200\n1500;NaN;\n',
    ],
)
def test_one_run_as_it_is_written_here_and_there(raw):
    file = read_csv(raw)
    assert file.numbers("n") == [900.0, 1200.0, 1500.0]
    found = file.numbers("P")
    assert found[0] == 19.5 and math.isnan(found[1]) and math.isnan(found[2])


def test_latin_1_and_a_line_of_units():
    file = read_csv("n;t_öl\nU/min;°C\n900;80,5\n".encode("latin-1"))
    assert file.units == {"n": "rpm", "t_öl": "°C"} and file.numbers("t_öl") == [80.5]
    assert file.lines == [3]


@pytest.mark.parametrize("cells", [b"nan;nan", b";", b"NaN;"])
def test_a_first_row_in_which_nothing_was_measured_is_no_line_of_units(cells):
    file = read_csv(b"n;P\n" + cells + b"\n900;19,5\n")
    assert not file.units and file.lines == [2, 3]
    assert math.isnan(file.numbers("n")[0]) and file.numbers("P")[1] == 19.5


def test_what_stands_in_quotes_separates_no_columns():
    assert list(read_csv(b'"P; of both, W",n\n1,2\n').columns) == ["P; of both, W", "n"]
    assert list(read_csv(b'"n, 1/min";"P, W"\n1;2\n').columns) == ["n, 1/min", "P, W"]


def test_a_comma_between_cells_is_no_decimal_comma():
    assert read_csv(b"a,b\n1,5\n2,6\n").numbers("a") == [1.0, 2.0]


@pytest.mark.parametrize(
    "raw, words",
    [
        (b"  \n", "is empty"),
        (b"# nothing\n", "no line but comments"),
        (b"n;P\n", "no row"),
        (b"n;P\n900;19,5\n1200;19.5\n", "comma (line 2) and with a point (line 3)"),
        (b"n;P;P\n1;2;3\n", "the column P twice"),
        (b"n;P\n1;2;3\n", "line 2 has 3 cells, the header 2"),
        (b"n\n" + b"1\n" * 20_001, "at most 20,000"),
        (b"a;" * 501, "at most 500"),
    ],
)
def test_what_is_no_run_says_why(raw, words):
    with pytest.raises(Unread) as why:
        read_run(raw, ".csv")
    assert words in why.value.text


@pytest.mark.parametrize(
    "cell, words",
    [
        ("off", 'line 3: "off" in column P'),
        ("1e999", "line 3: column P is infinite"),
        ("1e300", "line 3: column P: a number must be 0 or of a size from 1e-30 to 1e30"),
        ("-1e-200", "a size from 1e-30"),
    ],
)
def test_what_is_no_number_is_said_with_its_line(cell, words):
    file = read_csv(f"n;P\n900;1\n1200;{cell}\n".encode())
    with pytest.raises(Unread, match=words):
        file.numbers("P")


@pytest.mark.parametrize(
    "unit, into, number, expected",
    [
        ("°F", "°C", 248.0, 120.0),
        ("psi", "bar", 58.0151, 4.0),
        ("N·mm", "N·m", 1500.0, 1.5),
        ("g", "kg", 5.0, 0.005),
        ("g", "m/s²", 2.0, 19.6133),
        ("mm/s", "m/s", 3.0, 0.003),
        ("1/min", "rpm", 900.0, 900.0),
        ("Hz", "rpm", 15.0, 900.0),
        ("um", "mm", 80.0, 0.08),
        ("kW", "W", 1.2, 1200.0),
        ("[l/min]", "L/min", 2.0, 2.0),
    ],
)
def test_units_of_one_dimension_are_converted(unit, into, number, expected):
    factor, zero = conversion(canonical(unit), into)
    assert factor * (number + zero) == pytest.approx(expected, rel=1e-6)


@pytest.mark.parametrize("unit, into", [("W", "N·m"), ("°C", "K"), ("g", "m/s"), ("furlong", "m")])
def test_units_of_another_dimension_are_not(unit, into):
    assert conversion(unit, into) is None


def test_other_formats_ask_for_their_extra_or_say_that_the_file_is_none():
    for ending, module in ((".tdms", "nptdms"), (".parquet", "pyarrow")):
        with pytest.raises(Unread) as why:
            read_run(b"no such thing", ending)
        there = importlib.util.find_spec(module) is not None
        assert ("can not be read as" if there else "needs the extra") in why.value.text


def test_tdms_has_channels_and_their_units():
    nptdms = pytest.importorskip("nptdms")
    written = io.BytesIO()
    channel = nptdms.ChannelObject("g", "P", [1.5, 2.5], properties={"unit_string": "kW"})
    with nptdms.TdmsWriter(written) as file:
        file.write_segment([channel, nptdms.ChannelObject("g", "n", [900.0, 1200.0])])
    run = read_run(written.getvalue(), ".tdms")
    assert run.numbers("P") == [1.5, 2.5] and run.units == {"P": "kW"}


def test_parquet_has_columns():
    arrow = pytest.importorskip("pyarrow")
    from pyarrow.parquet import write_table

    written = io.BytesIO()
    write_table(arrow.table({"n": [900, 1200], "P": [1.5, None]}), written)
    run = read_run(written.getvalue(), ".parquet")
    assert run.numbers("n") == [900.0, 1200.0] and run.numbers("P")[0] == 1.5 and math.isnan(run.numbers("P")[1])
