"""Records: what they refuse, and how they print themselves."""

from dataclasses import FrozenInstanceError, field
from inspect import signature

import pytest

from calc.countershaft.rows import BearingRow
from calc.sheet.quantity import Described, Stated, group, result, value
from calc.sheet.record import record, replace
from calc.sheet.text import Text


@record
class Point:
    x: float
    y: float
    names: tuple[str, ...] = ()


@result
class Film:
    film: float = value("Smallest film", "µm")
    case: Point = Point(1.0, 2.0)  # not published
    rise: float | None = value("Temperature rise", "K", default=None)
    more: dict = group(default=None)


GIVEN = {"name": "front", "diameter": 0.06, "length": 0.03, "journal_roughness": 6e-7, "housing_roughness": 6e-7}


@pytest.mark.parametrize("make", [lambda: BearingRow(**GIVEN, lenght=0.03), lambda: Point(1.0, 2.0, lenght=3)])
def test_a_wrong_keyword_is_named(make):
    with pytest.raises(TypeError, match="lenght"):
        make()


@record
class Made:
    self: float
    held: list = field(default_factory=list)
    count: int = field(default=0, kw_only=True)
    kept: dict = field(default_factory=dict, init=False)

    def __post_init__(self) -> None:
        self.kept["count"] = self.count


def test_a_record_is_made_as_the_library_makes_it():
    one, two = Made(1.0), Made(2.0, [3], count=4)
    assert (one.self, one.held, one.count, one.kept) == (1.0, [], 0, {"count": 0})
    assert (two.self, two.held, two.count, two.kept) == (2.0, [3], 4, {"count": 4})
    assert one.held is not Made(1.0).held and replace(two, count=5).kept == {"count": 5}
    assert str(signature(Point)) == "(x: float, y: float, names: tuple[str, ...] = ()) -> None"
    with pytest.raises(TypeError, match=r"Made.__init__\(\) takes from 2 to 3 positional arguments but 4 were given"):
        Made(1.0, [], 3)


def test_a_record_is_changed_as_the_library_changes_it():
    point = Point(1.0, 2.0, ("a",))
    point.__dict__["kept"] = "what was worked out of it stays behind"
    other = replace(point, y=3.0)
    assert (other.x, other.y, other.names, point.y) == (1.0, 3.0, ("a",), 2.0) and not hasattr(other, "kept")
    with pytest.raises(TypeError, match="Point has no z"):
        replace(point, z=1.0)


def test_a_record_is_written_once():
    point = Point(1.0, 2.0)
    with pytest.raises(FrozenInstanceError, match="cannot change x of Point"):
        point.x = 3.0
    with pytest.raises(FrozenInstanceError, match="cannot change z of Point"):
        point.z = 3.0
    assert point.x == 1.0


def test_repr_is_one_line_of_what_differs_from_the_defaults():
    assert repr(Point(1.0, 2.5)) == "Point(x=1.0, y=2.5)"
    assert repr(Point(1.0, 2.0, ("a",))) == "Point(x=1.0, y=2.0, names=('a',))"
    assert repr(Film(film=7e-6, case=Point(0.0, 0.0))) == "Film(film=7e-06, case=Point(…))"


def test_repr_shortens_what_is_long():
    assert len(repr(Point(1.0, 2.0, tuple("abcdefghijkl")))) < 80


def test_inputs_print_labels_values_and_units():
    assert str(BearingRow(**GIVEN)).splitlines() == [
        "BearingRow",
        "  Name                    front",
        "  Kind                    plain",
        "  Journal diameter           60 mm",
        "  Length                     30 mm",
        "  Roughness Ra, journal     0.6 µm",
        "  Roughness Ra, seat        0.6 µm",
        "  Seat                   direct",
        "  Plane of the joint          0 °",
    ]


def test_results_print_what_they_publish():
    span = Stated(Described(Text("Span over 5 teeth"), "mm"), 0.0312)
    assert str(Film(film=7.4e-6, more={"span_5": span, "of": {"inner": Film(film=1e-6)}})).splitlines() == [
        "Film",
        "  Smallest film         7.4 µm",
        "  more",
        "    Span over 5 teeth  31.2 mm",
        "    of",
        "      inner",
        "        Smallest film     1 µm",
    ]


def test_records_without_descriptions_print_their_fields():
    assert str(Point(1.0, 2e-5, ("a", "b", "c", "d", "e"))).splitlines() == [
        "Point",
        "  x                           1",
        "  y                      2·10⁻⁵",
        "  names  a, b, c, d, … 5 in all",
    ]


def test_a_class_may_print_itself():
    @record
    class Named:
        name: str

        def __str__(self) -> str:
            return self.name

    assert str(Named("front")) == "front"
    assert repr(Named("front")) == "Named(name='front')"
