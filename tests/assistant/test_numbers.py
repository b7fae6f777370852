# SPDX-License-Identifier: Apache-2.0
"""What a person types into a field."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from assistant.session import numbers
from assistant.session.numbers import UNIT_WORDS, NotUnderstood
from calc.sheet.quantity import Quantity
from calc.sheet.units import UNITS


def about(kind: str = "number", unit: str = "mm", optional: bool = False) -> Quantity:
    return Quantity(kind, "x", unit, optional=optional)


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("3.5", "mm", 3.5),
        ("3,5", "mm", 3.5),
        (" 3,5 ", "mm", 3.5),
        ("68,698", "mm", 68.698),
        ("3.", "mm", 3.0),
        (".5", "mm", 0.5),
        (",5", "mm", 0.5),
        ("-3", "mm", -3.0),
        ("−3", "mm", -3.0),
        ("+3", "mm", 3.0),
        ("1.2e-3", "mm", 0.0012),
        ("1,2E-3", "mm", 0.0012),
        ("1.2·10⁻³", "mm", 0.0012),
        ("1.2*10^-3", "mm", 0.0012),
        ("1.2 × 10^3", "mm", 1200.0),
        ("3.7 in", "mm", 93.98),
        ("3,7in", "mm", 93.98),
        ("50 µm", "mm", 0.05),
        ("50 μm", "mm", 0.05),
        ("50 um", "mm", 0.05),
        ("3 mm", "mm", 3.0),
        ("0.1 mm", "µm", 100.0),
        ("0.4 MPa", "bar", 4.0),
        ("0.4 N/mm²", "bar", 4.0),
        ("0.4 N/mm2", "bar", 4.0),
        ("4000 hPa", "bar", 4.0),
        ("14.5037738 psi", "bar", pytest.approx(1.0, rel=1e-8)),
        ("43 Hz", "rpm", 2580.0),
        ("2600 1/min", "rpm", 2600.0),
        ("2600 min-1", "rpm", 2600.0),
        ("2600 RPM", "rpm", 2600.0),
        ("272.27136331112 rad/s", "rpm", pytest.approx(2600.0)),
        ("248 °F", "°C", 120.0),
        ("393.15 K", "°C", 120.0),
        ("12 Nm", "N·m", 12.0),
        ("12 N m", "N·m", 12.0),
        ("12 lbf ft", "N·m", pytest.approx(16.2698, rel=1e-5)),
        ("1 kg m2", "kg·m²", 1.0),
        ("5'", "°", pytest.approx(1 / 12)),
        ("50 %", "", 0.5),
        ("1.5 g/cm3", "kg/m³", 1500.0),
        ("11 cSt", "mm²/s", 11.0),
        ("2 hp", "kW", pytest.approx(1.4914, rel=1e-4)),
        ("92,4/2", "mm", 46.2),
        ("3/8 in", "mm", 9.525),
        ("2*(45 + 1)-1", "mm", 91.0),
        ("-3-4", "mm", -7.0),
        ("2600 1/min", "rpm", 2600.0),
    ],
)
def test_a_number_is_understood(text: str, unit: str, value: float) -> None:
    assert numbers.value(text, about(unit=unit)) == value


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("1,234.5", "write 1234.5"),
        ("1.234,5", "write 1234.5"),
        ("1,234,567", "write 1234567"),
        ("1 234", "write 1234"),
        ("1'234.5", "write 1234.5"),
        ("1_000", "write 1000"),
        ("", "is empty"),
        ("abc", "is no number"),
        ("--1", "is no number"),
        ("3..5", "is no number"),
        ("1/0", "is no sum"),
        ("-", "is not finished"),
        ("92.4/", "is not finished"),
        ("1,234.5/2", "is no sum"),
        ("1e300*1e300-1e300*1e300", "is no sum"),
        ("1e", "is not finished"),
        ("1e-", "is not finished"),
        ("3 kg", "is no unit of this field"),
        ("0x10", "is no unit"),
        ("nan", "finite"),
        ("inf", "finite"),
        ("-Infinity", "finite"),
        ("1e400", "finite"),
        ("1" * 300, "longer than"),
        ("3 mm mm", "no unit"),
    ],
)
def test_what_can_be_misread_is_refused_with_the_reason(text: str, reason: str) -> None:
    with pytest.raises(NotUnderstood) as refused:
        numbers.value(text, about())
    assert reason in str(refused.value)


@pytest.mark.parametrize(
    ("text", "kind", "value"),
    [
        ("-167.5; 167.5", "series", [-167.5, 167.5]),
        ("-167,5; 167,5", "series", [-167.5, 167.5]),
        ("[-167.5, 167.5]", "series", [-167.5, 167.5]),
        ("-167.5 167.5", "series", [-167.5, 167.5]),
        ("-6.6 in; 6.6 in", "series", [-167.64, 167.64]),
        ("1, 2, 3", "series", [1.0, 2.0, 3.0]),
        ("1,5", "series", [1.5]),
        ("3 mm", "series", [3.0]),
        ("1; 3; 2", "integers", [1, 3, 2]),
        ("1,3,2", "integers", [1, 3, 2]),
        ("1 3 2", "integers", [1, 3, 2]),
        ("[1, 3, 2]", "integers", [1, 3, 2]),
        ("4;", "series", [4.0]),
        ("left; right", "names", ["left", "right"]),
        ('["left", "right"]', "names", ["left", "right"]),
        ("left,", "names", ["left"]),
    ],
)
def test_a_list_is_understood(text: str, kind: str, value: list[float]) -> None:
    assert numbers.value(text, about(kind, "mm" if kind == "series" else "")) == value


@pytest.mark.parametrize("text", ["1.5,2.5", "1,2,3", "-6.6; 6.6 in", "1;;2", "1; x", "1; 1,234.5"])
def test_an_ambiguous_list_is_refused(text: str) -> None:
    with pytest.raises(NotUnderstood):
        numbers.value(text, about("series"))


@pytest.mark.parametrize("text", ["[[1.5, 1.6], [1.7, 2]]", " [[1.5,1.6],[1.7,2.0]] "])
def test_a_list_of_lists_is_typed_and_shown_as_the_file_has_it(text: str) -> None:
    assert numbers.value(text, about("open")) == [[1.5, 1.6], [1.7, 2]]
    assert numbers.written([[1.5, 1.6], [1.7, 2.0]], about("open")) == "[[1.5, 1.6], [1.7, 2]]"


@pytest.mark.parametrize("text", ["1.5; 1.6", "[[1,5; 1,6]]", "3", "[1]]", "[1]\ny = [2]", "[[1.5, 1.6"])
def test_no_list_of_lists_is_refused(text: str) -> None:
    with pytest.raises(NotUnderstood):
        numbers.value(text, about("open"))


def test_whole_numbers() -> None:
    assert numbers.value("25", about("integer", "")) == 25
    assert isinstance(numbers.value("25.0", about("integer", "")), int)
    with pytest.raises(NotUnderstood, match="whole number"):
        numbers.value("25,5", about("integer", ""))
    with pytest.raises(NotUnderstood, match="whole numbers"):
        numbers.value("1.5; 2", about("integers", ""))


def test_an_empty_field_leaves_the_choice_to_the_program() -> None:
    assert numbers.value("  ", about(optional=True)) is None


def test_every_unit_of_a_key_can_be_typed() -> None:
    for symbol, unit in UNITS.items():
        known = UNIT_WORDS[symbol]
        factor = known[symbol][0] if isinstance(known[symbol], tuple) else known[symbol]
        assert factor == pytest.approx(unit.factor, rel=1e-12), symbol
        assert numbers.value(f"2.5 {symbol}", about(unit=symbol)) == 2.5


@given(st.floats(allow_nan=False, allow_infinity=False, min_value=-1e290, max_value=1e290))
def test_what_is_written_is_read_back(value: float) -> None:
    assert numbers.value(numbers.written(value, about()), about()) == value


@given(st.text(max_size=30))
def test_any_text_is_understood_or_refused(text: str) -> None:
    for kind, unit in (("number", "mm"), ("integer", ""), ("series", "°C"), ("integers", "")):
        try:
            numbers.value(text, about(kind, unit))
        except NotUnderstood as refused:
            assert str(refused)


def test_nought_has_no_sign() -> None:
    assert numbers.written(-0.0, about()) == numbers.written(0.0, about()) == "0"
    assert numbers.written([-0.0, -1.5], about("series")) == "0; -1.5"
