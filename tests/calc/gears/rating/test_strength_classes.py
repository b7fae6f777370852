"""Strength classes of ISO 6336-5: published numbers, ranges, and what is said where a class is not there."""

from itertools import pairwise

import pytest

from calc.gears.rating import classes as c
from calc.gears.rating.checks import hardness_checks
from calc.gears.rating.classes import class_names, classes_of, of_wheel, strength_class
from calc.gears.rating.curves import classes_table
from calc.sheet.errors import NoSolution
from calc.sheet.value import trace
from tests.calc.gears.trains import wheel

# ISO 6336-5:2016, Table 1, as reprinted in the public code of Mekanika (class, quality, HV, σ_Hlim, σ_Flim in MPa)
PUBLISHED = [
    ("case-hardened", "ML", 700, 1300, 312),
    ("case-hardened", "MQ", 700, 1500, 425),
    ("case-hardened", "ME", 700, 1650, 525),
    ("case-hardened, 28 HRC at 12 mm", "MQ", 700, 1500, 461),
    ("case-hardened, core 30 HRC", "MQ", 700, 1500, 500),
    ("quenched and tempered alloy steel", "MQ", 300, 1.313 * 300 + 373, 0.425 * 300 + 187),
    ("quenched and tempered alloy steel", "ME", 300, 2.213 * 300 + 260, 0.358 * 300 + 231),
    ("quenched and tempered carbon steel", "MQ", 200, 0.925 * 200 + 360, 0.240 * 200 + 163),
    ("induction-hardened", "MQ", 550, 0.541 * 550 + 882, 0.138 * 550 + 290),
    ("induction-hardened", "ME", 600, 0.505 * 600 + 1013, 0.271 * 600 + 237),
    ("nitrided, nitriding steel", "MQ", 800, 1250, 420),
    ("nitrided, quenched and tempered steel", "MQ", 500, 998, 363),
    ("nitrocarburised", "MQ", 400, 1.167 * 400 + 425, 0.653 * 400 + 94),
    ("nitrocarburised", "MQ", 500, 950, 388),
    ("normalised steel", "MQ", 200, 1.0 * 190 + 190, 0.455 * 190 + 69),  # 190 HBW
    ("grey iron", "ME", 200 / 0.95, 1.465 * 200 + 122, 0.200 * 200 + 53),
    ("nodular iron, pearlitic", "MQ", 250 / 0.95, 1.434 * 250 + 211, 0.350 * 250 + 119),
    ("malleable iron", "MQ", 200 / 0.95, 1.371 * 200 + 143, 0.345 * 200 + 77),
]


@pytest.mark.parametrize("name, quality, HV, sigma_H, sigma_F", PUBLISHED)
def test_numbers_of_table_1(name, quality, HV, sigma_H, sigma_F):
    found = strength_class(name, quality, float(HV))
    assert found.sigma_Hlim / 1e6 == pytest.approx(sigma_H, rel=1e-9)
    assert found.sigma_Flim / 1e6 == pytest.approx(sigma_F, rel=1e-9)


# ISO 6336-3, Table 3, in mm
@pytest.mark.parametrize(
    "name, printed",
    [
        ("case-hardened", 0.0030),
        ("induction-hardened", 0.0030),
        ("nitrided, nitriding steel", 0.1005),
        ("nitrocarburised", 0.1005),
        ("nodular iron, ferritic", 0.3095),
        ("grey iron", 0.3124),
    ],
)
def test_slip_layers_that_no_proof_stress_makes(name, printed):
    assert strength_class(name).slip_layer == pytest.approx(printed * 1e-3, rel=1e-12)


def test_usual_rounded_values():
    """300 HV quenched and tempered, MQ: 767 and 315 MPa, as usually quoted."""
    found = strength_class("quenched and tempered alloy steel", "MQ", 300.0)
    assert (found.sigma_Hlim / 1e6, found.sigma_Flim / 1e6) == pytest.approx((767, 315), abs=0.5)


@pytest.mark.parametrize("HV, HBW", [(120, 114), (190, 181), (250, 238), (320, 304), (385, 366), (435, 414)])
def test_brinell_by_the_pairs_of_iso_898_1(HV, HBW):
    assert c.brinell_hardness(HV=float(HV)) == pytest.approx(HBW, abs=1)


@pytest.mark.parametrize("name", class_names())
def test_every_class_is_whole(name):
    """Three qualities, better ones not weaker, lines that meet where one ends and the next begins, and one way to its
    slip layer."""
    row = c._row(name)
    for part in ("contact", "bending"):
        for quality in ("ML", "MQ", "ME"):
            lines = row[f"{part}_{quality}"]
            for (A, B, _, end), (A_2, B_2, start, _) in pairwise(lines):
                assert start == end and A * end + B == pytest.approx(A_2 * end + B_2, abs=0.5)
    at = [strength_class(name, quality) for quality in ("ML", "MQ", "ME")]
    assert [x.sigma_Hlim for x in at] == sorted(x.sigma_Hlim for x in at)
    assert [x.sigma_Flim for x in at] == sorted(x.sigma_Flim for x in at)
    assert (at[0].slip_layer is None) != (at[0].proof_stress is None)
    assert at[0].low < at[0].high and row["source"] and row["title"]


def test_nothing_given_is_case_hardened_and_said():
    found = strength_class()
    assert (found.name, found.quality, found.kind) == ("case-hardened", "MQ", "Eh")
    assert "not given" in found.notes[0]


def test_a_hardness_that_is_needed_and_not_given_is_the_lowest_and_said():
    found = strength_class("quenched and tempered alloy steel")
    assert found.sigma_Hlim == strength_class("quenched and tempered alloy steel", "MQ", 200.0).sigma_Hlim
    assert "200 HV" in found.notes[0]
    assert not strength_class("nitrided, nitriding steel").notes  # one number for the whole range


def test_more_hardness_than_the_range_adds_nothing_and_is_said():
    hard, end = (strength_class("quenched and tempered alloy steel", "MQ", HV) for HV in (900.0, 360.0))
    assert (hard.sigma_Hlim, hard.sigma_Flim) == (end.sigma_Hlim, end.sigma_Flim)
    assert "above the range" in hard.notes[0] and not end.notes


@pytest.mark.parametrize("HV, verdicts", [(650, ["fail", "pass"]), (700, ["pass", "pass"]), (820, ["pass", "note"])])
def test_hardness_is_judged_by_the_range(HV, verdicts):
    checks = tuple(hardness_checks("idler", strength_class("case-hardened", "MQ", float(HV))))
    assert [k.id for k in checks] == ["gears.idler.hardness", "gears.idler.hardness_most"]
    assert ["pass" if k.verdict == "warn" and k.margin > 0 else k.verdict for k in checks] == verdicts
    assert not tuple(hardness_checks("idler", strength_class("case-hardened")))


def test_range_in_brinell_is_judged_in_vickers():
    low, _ = hardness_checks("a", strength_class("grey iron", "MQ", 160.0))
    assert low.limit == pytest.approx(150 / 0.95) and low.unit == "HV"


@pytest.mark.parametrize(
    "name, says",
    [
        ("ADI 1000", "not among the materials of ISO 6336-5"),
        ("austempered iron", "not among the materials of ISO 6336-5"),
        ("42CrMo4", '"quenched and tempered alloy steel"'),
        ("casehardened", '"case-hardened"'),
    ],
)
def test_a_class_that_is_not_there_says_what_is(name, says):
    with pytest.raises(NoSolution, match=says):
        strength_class(name)


def test_a_steel_by_its_classes():
    assert set(classes_of("42crmo4")) == {
        "induction-hardened",
        "nitrided, quenched and tempered steel",
        "nitrocarburised",
        "quenched and tempered alloy steel",
    }
    assert classes_of("20CrNi4") and not classes_of("unknown")


def test_of_a_wheel_of_the_design():
    given = wheel("idler", 39, gear_material="quenched and tempered alloy steel", quality="ME", hardness=300.0)
    with trace() as lines:
        found = of_wheel(given, 206e9, 900e6)
    assert found.quality == "ME" and found.proof_stress == 900e6
    assert {line.about for line in lines} == {"wheel idler, strength class"}
    assert any(line.arguments.get("x") is given.hardness for line in lines)  # linked to the input


@pytest.mark.parametrize("E, steel", [(189e9, False), (191e9, True), (224e9, True), (226e9, False)])
def test_an_unknown_material_as_stiff_as_steel_is_case_hardened(E, steel):
    chosen = of_wheel(wheel("idler", 39, material="unknown"), E)
    assert chosen.name == "case-hardened" if steel else chosen is None


def test_table_of_the_wheels():
    table = classes_table({"a": strength_class(), "b": strength_class("grey iron", "MQ", 200.0)})
    assert [row[0] for row in table.rows] == ["a", "b"]
    assert table.rows[0][5:] == pytest.approx((1500, 425)) and table.rows[0][4] is None
