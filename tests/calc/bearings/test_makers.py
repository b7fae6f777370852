"""A design's journals beside those that makers print: the check, the table, and where both come into a solve."""

import pytest

from calc.bearings.plain.makers import OwnJournal, maker_check, makers_table
from calc.design.toml_file import design, parse
from calc.solve import solve
from calc.studies.shipped import DESIGNS


def own(d: float, psi: float, place: str = "front") -> OwnJournal:
    """In mm and ‰; specific load, surface speed and heat index of no matter but to the table's note."""
    return OwnJournal(place, d * 1e-3, psi * 1e-3, 2e6, 10.0, 5e5 * 1000 / 60)


# what three engines in a module at twice the speed have: 24.940 (J24B) to 36.016 mm (AGCO), 1.51355 (AGCO) to 2.58657 ‰ (LD9)
@pytest.mark.parametrize(
    ("d", "psi", "label", "value", "verdict"),
    [
        (30.0, 1.9, "Relative clearance", 1.9, "pass"),  # of what holds what is nearer to an end, as a share of all
        (26.0, 2.0, "Diameter", 26.0, "pass"),
        (24.95, 2.0, "Diameter", 24.95, "pass"),
        (24.93, 2.0, "Diameter", 24.93, "note"),
        (36.01, 2.0, "Diameter", 36.01, "pass"),
        (36.02, 2.0, "Diameter", 36.02, "note"),
        (30.0, 1.51, "Relative clearance", 1.51, "note"),
        (30.0, 1.52, "Relative clearance", 1.52, "pass"),
        (30.0, 2.58, "Relative clearance", 2.58, "pass"),
        (30.0, 2.59, "Relative clearance", 2.59, "note"),
        (20.0, 2.59, "Diameter", 20.0, "note"),  # both are outside: the one that is further out
        (24.93, 5.0, "Relative clearance", 5.0, "note"),
    ],
)
@pytest.mark.parametrize("ratio", [2.0, -2.0])
def test_what_lies_further_out_is_judged(
    d: float, psi: float, label: str, value: float, verdict: str, ratio: float
) -> None:
    check = maker_check(own(d, psi), "module", ratio)
    assert check is not None
    assert (check.id, check.kind, check.verdict) == ("bearings.front.maker_range", "advice", verdict)
    assert check.value == pytest.approx(value) and check.name == f"{label} among those of makers, front"
    in_mm = label == "Diameter"
    assert check.unit == ("mm" if in_mm else "‰")
    assert check.limit == pytest.approx((24.940, 36.016) if in_mm else (54.5 / 36.008, 77.5 / 29.9625))


def test_a_number_that_fewer_than_three_engines_have_is_not_judged() -> None:
    """Of shafts at the engine's speed in a split crankcase three have a diameter, and one a clearance beside it."""
    check = maker_check(own(24.0, 50.0), "split", -1.0)
    assert check is not None and check.verdict == "pass" and check.limit == pytest.approx((19.962, 28.0))


@pytest.mark.parametrize(
    ("assembly", "ratio"),
    [
        (None, 2.0),  # how it comes into its seats is not said
        ("module", None),  # a bearing alone, without a shaft
        ("cartridge", 2.0),  # two engines
        ("module", 1.0),
        ("module", 1.5),
    ],
)
def test_it_is_not_made_without_three_engines(assembly: str | None, ratio: float | None) -> None:
    assert maker_check(own(30.0, 2.0), assembly, ratio) is None


def test_the_table_has_this_design_and_then_the_makers() -> None:
    table = makers_table([own(24.0, 1.9), own(60.0, 2.0, "rear")], "split", -2.0)
    assert table is not None
    first, second, ld9, *others = table.rows
    assert first[:3] == ("front", "split", 24.0) and first[-2:] == (1.9, "this design")
    assert second[:3] == ("rear", "split", 60.0)
    assert ld9[:8] == ("GM 2.4 LD9", "module", 29.9625, 1.504, 44.0, 111.0, "printed", 2.59)
    assert ld9[8] == "“Balance Shaft, specifications, Sunfire L4-144 2.4L”"
    by_name = {row[0]: row for row in others}
    assert by_name["Caterpillar 3304, 3304B"][4:7] == (61.0, 223.0, "bore less journal")
    assert by_name["Porsche 944 M44.40"][3:8] == (None, None, None, None, None)  # not printed
    assert "Kawasaki ER-6n" not in by_name and "Toyota 5S-FE" not in by_name  # another ratio; no journal
    note = str(table.note)
    assert note.startswith("3 of 4 numbers of this design (d and ψ) lie")  # 60 mm is larger than any
    assert "Rear: p 2 MPa, u 10 m/s, W 5·10⁵ N·rpm/mm." in note and "no length and no load" in note
    assert all(len(row) == len(table.columns) for row in table.rows)


def test_the_table_at_the_speed_of_the_engine_shows_what_has_no_least() -> None:
    table = makers_table([own(24.0, 1.9)], None, 1.0)
    assert table is not None
    assert table.rows[0][1] is None  # the assembly is not said
    (en500,) = (row for row in table.rows if row[0] == "Kawasaki EN500")
    assert en500[2:8] == (27.9935, None, None, 50.0, "printed", None)
    assert str(table.note).startswith("1 of 1 number of this design")  # two engines alone have a clearance with d
    assert makers_table([own(24.0, 1.9)], "split", None) is None
    assert makers_table([own(24.0, 1.9)], "split", 1.5) is None


def test_a_solve_has_both() -> None:
    """24 mm at twice the engine's speed: thinner than those of three engines in modules, and of one alone in a split
    housing, as the design itself has it."""
    text = (DESIGNS / "r754ie4_balance_shafts.toml").read_text(encoding="utf-8")
    found = {}
    for assembly in ("split", "module"):
        given = text.replace('assembly = "split"', f'assembly = "{assembly}"')
        assert f'assembly = "{assembly}"' in given
        results = solve(design(parse(given.encode(), "shafts.toml")), compared=False)
        found[assembly] = {c.id: c for c in results.checks() if c.id.endswith("maker_range")}
        tables = {table.id for table in results.outcomes["bearings"].tables}
        assert "left.makers" in tables
    assert found["split"] == {}
    check = found["module"]["bearings.left.front.maker_range"]
    assert (check.value, check.unit, check.verdict) == (pytest.approx(24.0), "mm", "note")
    assert check.moved_by == ("shafts.left.bearings.front.diameter_mm", "shafts.left.bearings.front.clearance_um")
