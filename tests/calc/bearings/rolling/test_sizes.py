# SPDX-License-Identifier: Apache-2.0
"""Designations, outlines and what is usual inside: against the tables of the standards and given bearings."""

import math

import numpy as np
import pytest

from calc.bearings.rolling.geometry import alike, inside_of, mass_of, mean_diameter, overlap, stacked
from calc.bearings.rolling.ratings import computed
from calc.bearings.rolling.sizes import UnknownSize, every_size, listed_cages, own_size, size_of
from calc.library.table_file import house_table

MM = 1e-3
BORES = [15, 17, 20, 25, 30, 35, 40, 45, 50, 55, 60]


def outline(designation):
    size = size_of(designation)
    return tuple(round(length / MM, 9) for length in (size.bore, size.outside, size.width))


@pytest.mark.parametrize(
    "designation, bore, outside, width",
    [  # ISO 15, 1206 and 3245 as in public catalogues
        ("6002", 15, 32, 9),
        ("6205", 25, 52, 15),
        ("6305", 25, 62, 17),
        ("6312", 60, 130, 31),
        ("NU1007", 35, 62, 14),
        ("NU205", 25, 52, 15),
        ("NU2205", 25, 52, 18),
        ("NJ305", 25, 62, 17),
        ("NJ2304", 20, 52, 21),
        ("NU210", 50, 90, 20),
        ("NA4905", 25, 42, 17),
        ("RNA4905", 30, 42, 17),
        ("HK2520", 25, 32, 20),
        ("HK5025", 50, 58, 25),
        ("K25x30x20", 25, 30, 20),
        ("K28x33x13.5", 28, 33, 13.5),
    ],
)
def test_outlines_are_those_of_the_standards(designation, bore, outside, width):
    assert outline(designation) == (bore, outside, width)


def test_blanks_and_case_do_not_count():
    assert size_of(" nu 2 05 ").designation == "NU205"
    assert size_of("k25X30x20").designation == "K25x30x20"
    assert size_of("hk 25 20").series == "HK" and size_of("rna4905").series == "RNA49"


def test_what_runs_on_the_shaft_and_what_carries_thrust():
    assert [size_of(name).inner_ring for name in ("6205", "NU205", "NA4905", "RNA4905", "HK2520", "K25x30x20")] == [
        True,
        True,
        True,
        False,
        False,
        False,
    ]
    assert size_of("NJ205").flanged and not size_of("NU205").flanged
    needle = size_of("NA4905")
    assert needle.bore == pytest.approx(25 * MM) and needle.raceway == pytest.approx(30 * MM)


@pytest.mark.parametrize(
    "word, said",
    [
        ("NU25", ["NU25", "nearest is NU205"]),
        ("6213", ["13", "02 15", "12 60", "nearest is 6212"]),
        ("6200", ["00", "nearest is 6202"]),
        ("HK0810", ["15, 16, 18, 20, 22, 25, 28, 30, 35, 40, 45, 50"]),
        ("HK2501", ["06 to 60"]),
        ("K30x25x20", ["E_w is larger than F_w"]),
        ("K25x30x0", ["none is 0"]),
        ("6405", ["60, 62, 63"]),
        ("", ["allowed"]),
        ("NU405", ["nearest is NU"]),
        ("own", ["own"]),
    ],
)
def test_what_is_no_size_is_told_with_what_is_allowed(word, said):
    with pytest.raises(UnknownSize) as error:
        size_of(word)
    assert all(part in error.value.text for part in said), error.value.text
    assert isinstance(error.value, ValueError) and error.value.text.template


def test_the_grid_of_a_search_has_every_series_once():
    sizes = every_size()
    assert len({size.designation for size in sizes}) == len(sizes) == 11 * (3 + 10 + 2) + 12 * 3
    assert {size.series for size in sizes} == {"60", "62", "63", "10", "2", "3", "22", "23", "NA49", "RNA49", "HK"}
    assert {round(size.width / MM) for size in sizes if size.type == "cup"} == {16, 20, 26}
    for series in ("60", "62", "63"):
        assert [round(size.bore / MM) for size in sizes if size.series == series] == BORES
    for size in sizes:
        assert 0 < size.bore < size.outside and size.width > 0
        assert size_of(size.designation).outside == size.outside


def test_cages_that_are_listed_come_near_the_ratings_that_their_maker_prints():
    """C of IKO's tables of KT, kN."""
    printed = {"K20x28x20": 21.5, "K25x30x20": 18.6, "K25x35x30": 39.1, "K28x33x27": 26.3, "K30x35x27": 27.9}
    printed |= {"K30x38x24": 33.2, "K35x42x30": 40.6, "K40x48x34": 51.1}
    known = {size.designation: size for size in listed_cages()}
    assert len(known) == len(listed_cages()) and not {*known} & {size.designation for size in every_size()}
    for name, C in printed.items():
        size = known[name]
        assert computed(inside_of(size), size.usual.rating, 700.0).dynamic == pytest.approx(C * 1e3, rel=0.11), name


def test_every_row_of_the_table_says_where_it_is_from_and_how_sure():
    table = house_table("rolling_bearings.toml")
    rows = [
        *table["outline"].values(),
        table["cups"],
        table["cages"],
        *table["inside"].values(),
        *table["thrust"].values(),
    ]
    rows += [table["contamination"], table["filtered"], table["reliability"]]
    assert all(row["source"] and row["confidence"] in ("high", "medium", "low") for row in rows)
    codes = len(table["bore_codes"])
    assert all(len(row[key]) == codes for row in table["outline"].values() for key in ("outside_mm", "width_mm"))


# --- what is inside


@pytest.mark.parametrize(
    "designation, count, diameter, pitch, length",
    [  # by hand from the rules of the table
        ("6205", 9, 7.965, 38.5, None),
        ("NU205", 13, 7.425, 38.962, 8.1),
        ("NU1007", 18, 6.75, 49.082, 5.04),
        ("NA4905", 25, 3.0, 33.0, 11.56),
        ("HK2520", 25, 2.5, 27.5, 13.0),
        ("K25x30x20", 24, 2.5, 27.5, 15.6),
    ],
)
def test_what_is_usual_inside(designation, count, diameter, pitch, length):
    inside = inside_of(size_of(designation))
    assert inside.count == count
    assert inside.diameter / MM == pytest.approx(diameter) and inside.pitch / MM == pytest.approx(pitch)
    assert (inside.length is None) if length is None else inside.length / MM == pytest.approx(length)
    assert not overlap(inside)


def test_a_cage_in_halves_has_two_less():
    assert inside_of(size_of("K25x30x20"), split_cage=True).count == 22


def test_what_is_given_rules_and_the_rest_follows_it():
    inside = inside_of(size_of("6205"), diameter=6e-3)
    assert inside.diameter == 6e-3 and inside.count == math.floor(1 + 198 / math.degrees(2 * math.asin(6 / 38.5)))
    assert inside_of(size_of("HK2520"), diameter=2e-3).pitch == pytest.approx(27e-3)
    given = inside_of(size_of("NU205"), count=12.0, diameter=7.5e-3, length=9e-3, pitch=39e-3)
    assert (given.count, given.diameter, given.length, given.pitch) == (12.0, 7.5e-3, 9e-3, 39e-3)


def test_ones_own_has_no_usual_inside():
    ball, roller = own_size("ball", 0.03, 0.062, 0.016), own_size("roller", 0.03, 0.062, 0.016)
    assert inside_of(ball) is None and inside_of(ball, count=9.0) is None
    assert inside_of(roller, count=14.0, diameter=9e-3) is None
    assert inside_of(ball, count=9.0, diameter=9.525e-3).pitch == pytest.approx(0.046)
    assert inside_of(roller, count=14.0, diameter=9e-3, length=9e-3, pitch=0.046).length == 9e-3


def test_elements_that_overlap_are_seen():
    inside = inside_of(size_of("6205"), count=16.0)
    assert overlap(inside) and not overlap(inside_of(size_of("6205"), count=15.0))
    assert 16 * math.asin(7.965 / 38.5) > math.pi > 15 * math.asin(7.965 / 38.5)


@pytest.mark.parametrize("designation, mass", [("6205", 0.128), ("6305", 0.23), ("NU205", 0.13), ("HK2520", 0.033)])
def test_mass_is_about_that_of_catalogues(designation, mass):
    assert mass_of(size_of(designation)) == pytest.approx(mass, rel=0.07)  # as SKF and INA print it, from memory


def test_mass_and_mean_diameter_by_hand():
    size = size_of("K25x30x20")
    assert mass_of(size) == pytest.approx(0.5 * math.pi / 4 * (0.03**2 - 0.025**2) * 0.02 * 7850)
    assert mean_diameter(d=size.bore, D=size.outside) == pytest.approx(27.5e-3)


# --- many at once


def test_many_of_a_type_are_the_same_as_each_alone():
    groups = alike(every_size())
    assert {(group[0].type, group[0].inner_ring, group[0].flanged) for group in groups} == {
        ("ball", True, False),
        ("roller", True, False),
        ("roller", True, True),
        ("needle", True, False),
        ("needle", False, False),
        ("cup", False, False),
    }
    for group in groups:
        many, masses = inside_of(stacked(group)), mass_of(stacked(group))
        for row, size in enumerate(group):
            alone = inside_of(size)
            for name in ("count", "diameter", "pitch", "length"):
                value = getattr(alone, name)
                assert value is None or getattr(many, name)[row, 0] == pytest.approx(value, rel=1e-12)
            assert masses[row, 0] == pytest.approx(mass_of(size))
        assert np.shape(many.count) == (len(group), 1)


def test_several_types_do_not_stack():
    with pytest.raises(ValueError, match="several types"):
        stacked([size_of("6205"), size_of("NU205")])
