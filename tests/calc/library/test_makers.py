"""The table of makers' journals: each of its numbers stands on its sheet, and each number of the sheets in it; the
clearances that makers print are those of the diameters that they print.

`tests/reference/makers.csv` is the collection that the table was written from, a row for each engine and several facts in a
cell."""

import csv
import re
import tomllib
from pathlib import Path
from typing import Any

import pytest

from calc.library import table_file
from calc.library.makers import ASSEMBLIES, journals, maker_sheets, span
from calc.sheet.errors import BadTable

COLLECTED = list(csv.DictReader((Path(__file__).parents[2] / "reference" / "makers.csv").open(encoding="utf-8")))
WRITTEN = tomllib.loads(table_file.text_of_table("makers.toml"))["row"]
PAIRS = [pytest.param(row, sheet, id=sheet["name"]) for row, sheet in zip(COLLECTED, WRITTEN, strict=True)]
NUMBER = re.compile(r"\d+(?:\.\d+)?")
COLUMNS = ("journal_mm", "seat_mm", "wall_mm", "clearance_mm")
BESIDE = {("GM 2.4 LD9", ""), ("Caterpillar 3304", "3304B")}  # with numbers that stand in the column `other`

Numbers = dict[tuple[str, str], list[float]]  # by place and column


def in_cells(row: dict[str, str], places: list[str]) -> Numbers:
    """The numbers of the cells.  A part of a cell that names a place is of it; one that names none is of the journal
    that has no name, or of all."""
    found: Numbers = {}
    for column in COLUMNS:
        for part in filter(None, row[column].split("; ")):
            named = {place: place.removesuffix(" parts") for place in places if place}
            of = [place for place, word in named.items() if re.search(rf"\b{word}\b", part)]
            numbers = re.sub("|".join(named.values()), "", part) if named else part
            for place in of or ([""] if "" in places else places or [""]):
                found.setdefault((place, column), []).extend(map(float, NUMBER.findall(numbers)))
    return found


def in_table(sheet: dict[str, Any]) -> Numbers:
    """The numbers of its journals, but for those that come from the column `other`."""
    found: Numbers = {}
    for journal in sheet.get("journals", ()):
        place = journal.get("place", "")
        if place == "3304B":
            continue
        single = {key: [journal[key]] if key in journal else [] for key in SINGLE}
        numbers = (
            [*journal.get("journal_mm", ()), *single["nominal_mm"], *single["journal_limit_mm"]],
            journal.get("housing_mm", journal.get("bore_mm", ())),
            journal.get("wall_mm", ()),
            [*journal.get("clearance_mm", ()), *single["clearance_up_to_mm"]],
        )
        found |= {(place, column): list(of) for column, of in zip(COLUMNS, numbers) if of}
    return found


SINGLE = ("nominal_mm", "journal_limit_mm", "clearance_up_to_mm")


@pytest.mark.parametrize(("row", "sheet"), PAIRS)
def test_each_number_of_a_sheet_stands_in_the_table_and_each_of_the_table_on_its_sheet(
    row: dict[str, str], sheet: dict[str, Any]
) -> None:
    places = [journal.get("place", "") for journal in sheet.get("journals", ())]
    assert len(set(places)) == len(places)
    assert in_table(sheet) == in_cells(row, [place for place in places if place != "3304B"])
    speeds = [sheet[key] for key in ("speed_max_rpm", "engine_speed_rpm") if key in sheet]
    assert speeds == list(map(float, NUMBER.findall(row["speed_max_rpm"])))
    limits = [sheet["service_limit_mm"]] if "service_limit_mm" in sheet else []
    assert limits == list(map(float, NUMBER.findall(row["service_limit_mm"])))
    assert sheet["ratio"] == float(row["ratio"])


@pytest.mark.parametrize(("row", "sheet"), PAIRS)
def test_the_words_of_a_sheet_stand_in_the_table_as_they_are(row: dict[str, str], sheet: dict[str, Any]) -> None:
    layout = f" ({sheet['layout']})" if "layout" in sheet else ""
    assert sheet["name"] + layout == row["engine"]
    for key in ("arrangement", "assembly", "bearing", "other", "title", "address"):
        assert sheet.get(key, "") == row[key]
    assert (sheet.get("backlash", ""), sheet.get("end_play", "")) == (row["backlash_mm"], row["end_play_mm"])
    assert sheet["title"] and sheet["address"] and sheet["assembly"] in ASSEMBLIES


def test_numbers_beside_the_columns_stand_in_the_words_of_their_sheets() -> None:
    for sheet in WRITTEN:
        for journal in sheet.get("journals", ()):
            if (sheet["name"], journal.get("place", "")) in BESIDE:
                keys = ("bore_mm",) if "housing_mm" in journal else ("journal_mm", "bore_mm")
                for key in keys:
                    low, high = journal[key]
                    assert f"{low:.3f}-{high:.3f}" in sheet["other"]
            else:
                assert not {"housing_mm", "bore_mm"} <= set(journal)  # one column holds both


def test_limits_rise_and_classes_stand_apart() -> None:
    assert len(maker_sheets()) == 23
    for sheet in maker_sheets().values():
        for journal in sheet.journals:
            for limits in (journal.journal, journal.bore, journal.housing, journal.wall, journal.clearance):
                assert len(limits) % 2 == 0 and list(limits) == sorted(set(limits)), sheet.name


def test_a_sheet_as_a_record_in_SI() -> None:
    kubota = maker_sheets()["Kubota V3007 V3307"]
    assert (kubota.ratio, kubota.assembly, kubota.layout) == (2, "threaded", "inline 4 diesel")
    assert (kubota.speed_max, kubota.engine_speed) == pytest.approx((5200 / 60, 2600 / 60))
    assert kubota.service_limit == pytest.approx(0.2e-3)
    first, second = kubota.journals
    assert (first.place, first.diameter) == ("shaft 1", pytest.approx(48.942e-3))
    assert first.relative_clearance == pytest.approx(0.103 / 48.942)
    assert second.stated_clearance == (pytest.approx((50e-6, 136e-6)), "printed")
    assert maker_sheets()["Honda K24"].journals == ()


@pytest.mark.parametrize(
    ("engine", "place", "d", "psi", "wall", "how"),
    [  # mm, ‰; of printed limits by hand
        ("GM 2.4 LD9", "", 29.9625, 0.0775 / 29.9625, 1.504, "printed"),
        ("Caterpillar 3304", "3304B", 52.908, 0.142 / 52.908, None, "bore less journal"),
        ("Kawasaki ER-6n", "", 27.9935, None, None, None),  # two classes; no wall is printed, hence no clearance
        ("Kawasaki EN500", "", 27.9935, None, None, None),  # a clearance without a least has no middle
        ("Suzuki GSX-R1000 2003", "", 23.0, None, None, None),
        ("Yamaha R1 2009", "", None, None, None, "printed"),
    ],
)
def test_a_journal(engine: str, place: str, d: float | None, psi: float | None, wall: float | None, how: str) -> None:
    (journal,) = (each for each in maker_sheets()[engine].journals if each.place == place)
    in_mm = [None if x is None else x * 1000 for x in (journal.diameter, journal.wall_middle)]
    assert in_mm == [None if x is None else pytest.approx(x) for x in (d, wall)]
    assert journal.relative_clearance == (None if psi is None else pytest.approx(psi))
    assert (journal.stated_clearance[1] if journal.stated_clearance else None) == how


# --- printed clearances against printed diameters

SHEETS = {
    "GM 2.4 LD9",
    "GM 2.2 L61",
    "GM 2.4 LAF LEA LUK",
    "Ford 6.8 V10",
    "Kubota V3007 V3307",
    "Westerbeke 65A",
    "Caterpillar 3304",
    "AGCO Power 44 49",
    "John Deere STX38",
}
# what a sheet prints beside what its diameters give, µm; both are remarked on the rows themselves
OTHERWISE = {("Westerbeke 65A", ""): (159, 160), ("GM 2.4 LAF LEA LUK", "front"): (60, 63)}


def test_the_clearances_of_nine_sheets_are_those_of_their_diameters() -> None:
    """To 1 µm at both ends, but for two that print less at the upper one."""
    seen = set()
    for sheet in maker_sheets().values():
        for journal in sheet.journals:
            by_diameters = journal.clearance_of_bore
            if (sheet.name, journal.place) == ("Caterpillar 3304", ""):  # its bore is printed on the sheet of the 3304B
                bore = sheet.journals[2].bore
                by_diameters = bore[0] - journal.journal[1], bore[1] - journal.journal[0]
            if by_diameters is None or not journal.clearance:
                continue
            seen.add(sheet.name)
            least, most = (round(x * 1e6, 3) for x in by_diameters)
            printed_least, printed_most = (round(x * 1e6, 3) for x in journal.clearance)
            assert least == pytest.approx(printed_least, abs=1)
            if (sheet.name, journal.place) in OTHERWISE:
                assert (printed_most, most) == OTHERWISE[sheet.name, journal.place]
            else:
                assert most == pytest.approx(printed_most, abs=1)
    assert seen == SHEETS


def test_the_shells_of_the_LD9_stand_wider_than_bore_and_walls_say() -> None:
    """By 10 and 11 µm: the housing gives way to the shells that are pressed in."""
    (journal,) = maker_sheets()["GM 2.4 LD9"].journals
    rigid = journal.clearance_of_shells
    assert rigid is not None
    assert [round(x * 1e6) for x in rigid] == [34, 100]
    assert [round((x - y) * 1e6) for x, y in zip(journal.clearance, rigid)] == [10, 11]


# --- the rows that a design stands beside


def test_journals_of_a_ratio_and_an_assembly() -> None:
    assert {each.sheet.ratio for each in journals(-2)} == {2.0}  # whichever way the shaft turns
    assert {each.sheet.name for each in journals(1, "split")} == {
        "Kawasaki ER-6n",
        "Kawasaki EN500",
        "Yamaha MT-09 Tracer",
        "Yamaha XSR900 2022",
        "Yamaha R1 2009",
        "John Deere STX38",
    }
    assert {each.sheet.assembly for each in journals(2)} == set(ASSEMBLIES)
    assert journals(1.5) == () == journals(1, "cartridge")


def test_least_and_most_are_those_of_three_engines_or_are_not_said() -> None:
    def diameter(journal):
        return journal.diameter

    def psi(journal):
        return journal.relative_clearance

    assert span(journals(2, "module"), diameter) == pytest.approx((24.9475e-3, 36.008e-3))  # J24B, AGCO
    assert span(journals(2, "module"), psi) == pytest.approx((0.0545 / 36.008, 0.0775 / 29.9625))  # AGCO, LD9
    assert span(journals(1, "split"), diameter) == pytest.approx((19.9685e-3, 27.9935e-3))  # STX38, Kawasaki
    assert span(journals(1, "split"), psi) is None  # of the STX38 alone
    assert span(journals(2, "cartridge"), diameter) is None  # four journals of two engines


@pytest.mark.parametrize("limits", ['[0.1, "0.2"]', "[0.1, true]", '"0.1"'])
def test_limits_that_are_no_numbers_are_told_with_their_line(
    limits: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from calc.library.catalogue import CatalogueRows
    from calc.library.makers import MakerSheet

    text = table_file.text_of_table("makers.toml").replace("clearance_mm = [0.044, 0.111]", f"clearance_mm = {limits}")
    (tmp_path / "makers.toml").write_text(text, encoding="utf-8")
    monkeypatch.setattr(table_file, "TABLES", tmp_path)
    with pytest.raises(BadTable) as told:
        CatalogueRows("makers.toml", "row", MakerSheet)["GM 2.4 LD9"]
    (mistake,) = told.value.errors
    assert mistake.key == "row.0.journals.0.clearance_mm" and mistake.line and "a list of numbers" in str(mistake)
