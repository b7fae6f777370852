# SPDX-License-Identifier: Apache-2.0
"""What the journal runs on, what is usual, and what runs already."""

import subprocess
import sys
import tomllib

import pytest
from hypothesis import given
from hypothesis import strategies as st

from calc.bearings.plain.materials import (
    DEFAULT_APPLICATION,
    SCALE,
    Application,
    BearingMaterial,
    application,
    application_problem,
    applications,
    bearing_materials,
    bush_problem,
    running_bearings,
    running_surface,
)
from calc.bearings.plain.suitability import (
    Journal,
    Running,
    application_checks,
    fatigue_note,
    film_duty,
    load_cycles,
    load_times_speed,
    material_checks,
    reference_table,
    table,
)
from calc.design import toml_file as design_file
from calc.library.catalogue import materials
from calc.library.journal_rules import RELATIVE_CLEARANCE
from calc.library.table_file import TABLES
from calc.sheet.value import trace
from calc.solve import solve
from tests.conftest import DESIGNS, ROOT, SCREENED

GAMMA = (Journal("front", 0.0595, 0.0275, 2600 / 60, 1710.15), Journal("rear", 0.081, 0.0265, 2600 / 60, 1710.15))
MPA = 1e6


def column(found, label):
    at = [name for name, _ in found.columns].index(label)
    return {row[0]: row[at] for row in found.rows}


# --- materials
@pytest.mark.parametrize(
    "name, load, temperature, hardness",
    [
        # J. Carvill, Mechanical Engineer's Data Handbook, 2.9.3: lower end of load capacity, MPa; °C; lower end of the
        # shaft's hardness, HB. The white metals' hardness: Performance characteristics of bearing materials, Orion
        # Corporation (130 to 170 HB).
        ("SnSb8Cu4", 5.5, 150, 130),
        ("PbSb15SnAs", 5.5, 150, 130),
        ("CuPb24Sn", 10.3, 175, 200),
        ("CuSn10P", 30, 260, 300),
        ("CuPb10Sn10", 20, 225, 300),
        ("AlSn6Cu", 30, 125, 200),
        ("AlSn20Cu", 25, 125, 200),
        ("EN AC-43100", 5.0, None, None),
    ],
)
def test_published_values(name, load, temperature, hardness):
    m = bearing_materials()[name]
    assert m.specific_load == (None if load is None else pytest.approx(load * MPA))
    assert (m.temperature, m.journal_hardness) == (temperature, hardness)


def test_emergency_running_goes_with_the_published_scale_of_compatibility():
    """Orion Corporation, scale of compatibility: tin and lead babbitt 1, copper-lead 2, lead bronze 3, aluminium alloy
    4, tin bronze 5."""
    published = {"SnSb8Cu4": 1, "PbSb15SnAs": 1, "CuPb24Sn": 2, "CuPb10Sn10": 3, "AlSn6Cu": 4, "CuSn10P": 5}
    words = {1: "excellent", 2: "good", 3: "fair", 4: "fair", 5: "poor"}
    for name, number in published.items():
        m = bearing_materials()[name]
        assert m.emergency_running == words[number] and (number == 2 or f"{number} of 5" in m.emergency_basis)


def test_every_row_says_where_its_numbers_come_from():
    for file in ("bearing_materials.toml", "running_bearings.toml"):
        rows = tomllib.loads((TABLES / file).read_text(encoding="utf-8"))["row"]
        assert rows and all(
            any(word in row["source"] for word in ("Carvill", "Finotti", "end journals")) for row in rows
        )


def test_what_the_journal_runs_on():
    assert running_surface(None, "EN AC-43100").form == "bare"
    assert running_surface("AlSn20Cu", "EN AC-43100").form == "shell"
    assert running_surface(None, "EN-GJL-250") is None
    assert {m.name for m in bearing_materials().values() if m.form == "bare"} <= set(materials())


def test_words_that_are_no_bush_are_refused_with_the_nearest():
    assert bush_problem("AlSn20Cu") is application_problem("diesel-main") is None
    assert bush_problem("AlSn20").endswith("did you mean AlSn20Cu?")
    assert "EN AC-43100" not in bush_problem("EN AC-43100")
    assert application_problem("diesel").startswith(
        "must be one of balance-shaft, locomotive-axle"
    ) and application_problem("")
    assert application_problem(DEFAULT_APPLICATION) is None


def found(name, **of):
    given = dict(place="front", p=1.0 * MPA, pv=8.5 * MPA, T_hot=126.0, T_in=110.0) | of
    return {
        c.id.removeprefix("bearings.front."): c for c in material_checks(material=bearing_materials()[name], **given)
    }


def test_a_bare_seat_is_told_of_emergency_running():
    bare = found("EN AC-43100")
    # no p·v, temperature or hardness was found, and its load is that of the check on the specific load
    assert set(bare) == {"material_emergency_running"}
    one = bare["material_emergency_running"]
    assert one.verdict == "note" and "lined shell" in one.advice
    assert found("AlSn20Cu")["material_emergency_running"].verdict == "pass"


@pytest.mark.parametrize("name", bearing_materials())
def test_emergency_running_is_asked_to_be_fair(name):
    """1 poor, 2 fair, 3 good, 4 excellent."""
    number = {"poor": 1, "fair": 2, "good": 3, "excellent": 4}[bearing_materials()[name].emergency_running]
    check = found(name)["material_emergency_running"]
    assert (check.value, check.limit, check.verdict) == (number, 2, "pass" if number > 1 else "note")


@pytest.mark.parametrize("name", bearing_materials())
def test_a_check_stands_only_where_the_row_has_the_number_and_never_fails(name):
    m = bearing_materials()[name]
    hard = found(name, p=1e9, pv=1e12, T_hot=999.0, hardness=1.0)
    assert ("material_load" in hard) is (m.specific_load is not None and m.form != "bare") and (
        "material_pv" in hard
    ) is (m.pv is not None)
    assert ("material_temperature" in hard) is (m.temperature is not None) and ("material_hardness" in hard) is (
        m.journal_hardness is not None
    )
    cautions = {"material_load", "material_temperature", "material_hardness"}
    assert all(
        c.verdict == ("warn" if key in cautions else "note")
        for key, c in hard.items()
        if key != "material_emergency_running"
    )
    assert all(
        c.kind == ("caution" if key in cautions else "advice") and c.source and c.advice for key, c in hard.items()
    )
    assert "material_hardness" not in found(name)


def test_a_limit_itself_passes():
    m = bearing_materials()["SnSb8Cu4"]
    at = found("SnSb8Cu4", p=m.specific_load, pv=m.pv, T_hot=m.temperature, hardness=m.journal_hardness)
    assert {c.verdict for c in at.values()} == {"pass"} and len(at) == 5
    assert (at["material_pv"].limit, at["material_pv"].unit) == (16.0, "MPa·m/s")
    # what a stretched formula adds to the temperature counts from that of the oil
    assert {key: c.base for key, c in at.items() if c.base} == {"material_temperature": 110.0}


def test_turns_of_the_load():
    """2600 rpm over 7700 h: 1.2·10⁹ turns of the load (bearing of the source's engine over its life)."""
    assert load_cycles(n=2600 / 60, L=7700 * 3600.0) == pytest.approx(1.2012e9)
    note = fatigue_note("front", bearing_materials()["EN AC-43100"], 4.6e6, 2600 / 60, 7700 * 3600.0)
    assert "4.6 MPa" in note and "1.2·10⁹ times in 7700 h" in note and "80 to 110 MPa" in note
    assert "times an hour" in fatigue_note("rear", bearing_materials()["CuSn10P"], 4.6e6, 2600 / 60, None)


def test_the_table_shows_what_the_harder_bearing_uses():
    shown = table(
        {"front": Running(1.1 * MPA, 8.0 * MPA, 126.0), "rear": Running(0.8 * MPA, 8.8 * MPA, 128.0)}, "EN AC-43100"
    )
    assert shown.rows[0][0] == "EN AC-43100, chosen" and len(shown.rows) == len(bearing_materials())
    assert all(len(row) == len(shown.columns) for row in shown.rows)
    assert len({name for name, _ in shown.columns}) == len(shown.columns)
    assert column(shown, "p used")["SnSb8Cu4"] == pytest.approx(20.0)  # 1.1 of 5.5 MPa, the front
    assert column(shown, "p·v used")["SnSb8Cu4"] == pytest.approx(55.0)  # 8.8 of 16 MPa·m/s, the rear
    assert (
        column(shown, "in reserve")["AlSn20Cu"] == pytest.approx(-3.0)
        and column(shown, "p·v allowed")["AlSn20Cu"] is None
    )


# --- references
def test_loads_of_the_r754_are_those_of_its_design():
    results = solve(design_file.design(design_file.read(DESIGNS / f"{SCREENED}.toml")))
    supports = results.outcomes["countershaft"].values()
    reaction = {v.id: v.inside for v in supports}
    ends = [reaction[f"countershaft.shaft.reaction_{row}"] for row in ("front", "middle", "rear")]
    rows = running_bearings()
    assert rows["R754IE4, end"].load == pytest.approx(ends[0], abs=0.005) == pytest.approx(ends[2], abs=0.005)
    assert rows["R754IE4, centre"].load == pytest.approx(ends[1], abs=0.005)


def test_loads_of_the_r754_by_the_closed_form_for_two_equal_spans():
    """Two spans of 112 mm, P = 0.453 kg · 11.933 mm · (2π·100/s)² at 58 mm from the middle of each: M₂ =
    −P·l₃·(l₁²−l₃²)/(2·l₁²)."""
    P, l1, l2 = 0.453 * 11.933e-3 * (2 * 3.141592653589793 * 100) ** 2, 0.112, 0.058
    l3 = l1 - l2
    M2 = -P * l3 * (l1**2 - l3**2) / (2 * l1**2)
    end = (P * l2 + M2) / l1
    assert running_bearings()["R754IE4, end"].load == pytest.approx(end, abs=0.005)
    assert running_bearings()["R754IE4, centre"].load == pytest.approx(2 * P - 2 * end, abs=0.005)


def test_reference_table():
    """p and W of Finotti 2013, 3.2.3.1: front of gamma 1.045 MPa and 161 687, rear 0.797 and 167 788, front of beta
    1.105 and 171 015."""
    shown = reference_table(GAMMA)
    p, W, u = column(shown, "p"), column(shown, "W"), column(shown, "u")
    assert [row[0] for row in shown.rows][:2] == ["front", "rear"] and len(shown.rows) == 2 + len(running_bearings())
    assert (p["front"], p["rear"], p["R753IE4 beta, front"]) == (
        pytest.approx(1.045, abs=5e-4),
        pytest.approx(0.797, abs=5e-4),
        pytest.approx(1.105, abs=6e-4),
    )
    assert (W["front"], W["rear"], W["R753IE4 beta, front"]) == (
        pytest.approx(161687, abs=0.5),
        pytest.approx(167788, abs=0.5),
        pytest.approx(171015, abs=0.5),
    )
    assert (u["front"], u["rear"]) == (pytest.approx(8.100, abs=5e-4), pytest.approx(11.027, abs=5e-4))
    assert p["front"] == p["R753IE4 gamma, front"] and W["rear"] == W["R753IE4 gamma, rear"]
    assert p["R754IE4, centre"] > 5 and W["R754IE4, centre"] > 500_000 and "goes beyond" in shown.note
    assert p["R754IE4, end"] < 2 and W["R754IE4, end"] < 240_000
    # W·π/60000 is p·v in MPa·m/s
    assert column(shown, "p·u")["rear"] == pytest.approx(W["rear"] * 3.141592653589793 / 60000)


def test_tables_leave_no_lines_behind():
    with trace() as lines:
        reference_table(GAMMA)
        table({"front": Running(1.0 * MPA, 8.0 * MPA, 126.0)}, "AlSn6Cu")
    assert lines == []


# --- applications
def test_the_figure_has_27_rows_and_dashes_are_none():
    rows = dict(applications())
    own_row = rows.pop(DEFAULT_APPLICATION)
    assert len(rows) == 27
    assert rows["hoist"].length_ratio_low is None and rows["hoist"].pv is None
    # makers of balance shafts print neither load nor length
    assert own_row.specific_load_high is own_row.pv is own_row.duty_low is own_row.length_ratio_low is None
    assert rows["steam-slow-main"].duty_low is None and rows["car-main"].pv is None


@pytest.mark.parametrize(
    "name, p, pv, duty, ratio",
    [  # Chirone & Vullo 1979, after Finotti 2013, Figure 5.16
        ("diesel-main", (2, 8), 35, (4, 5), (0.8, 1.5)),
        ("car-main", (2, 12), None, (5, 7), (0.8, 1.5)),
        ("aircraft-crankpin", (5, 35), 90, (2.5, 2.5), (0.5, 1.5)),
        ("gas-gudgeon", (8, 14), None, (1.5, 2.5), (0.8, 1.2)),
        ("steam-turbine", (0.5, 2), 35, (25, 50), (1, 2)),
        ("gearbox", (0.6, 1.7), 3.5, (10, 75), (2, 4)),
        ("locomotive-axle", (4, 4), 4, (7, 12), (1.6, 1.8)),
        ("electric-machine", (0.7, 1.4), 2, (50, 50), (1, 2)),
        ("press-crankpin", (35, 55), None, None, (1, 2)),
        ("machine-tool", (0.3, 2), 0.35, (0.5, 2.5), (1, 3)),
    ],
)
def test_rows_of_the_figure(name, p, pv, duty, ratio):
    row = applications()[name]
    assert (row.specific_load_low, row.specific_load_high) == pytest.approx((p[0] * MPA, p[1] * MPA))
    assert row.pv == (None if pv is None else pytest.approx(pv * MPA))
    assert (row.duty_low, row.duty_high) == (
        (None, None) if duty is None else pytest.approx((duty[0] * 1e-8, duty[1] * 1e-8))
    )
    assert (row.length_ratio_low, row.length_ratio_high) == pytest.approx(ratio)


def judged(name, **of):
    given = (
        dict(place="rear", p=1.045 * MPA, pv=8.46 * MPA, mu=6.6e-3, mu_n_over_p=2.7e-7, psi=1.35e-3, l_over_d=0.462)
        | of
    )
    return {c.id.removeprefix("bearings.rear."): c for c in application_checks(row=applications()[name], **given)}


def test_the_source_design_violates_its_own_table_in_length():
    found = judged("diesel-main")
    assert {key: c.verdict for key, c in found.items()} == {
        "application_load": "pass",
        "application_pv": "pass",
        "application_duty": "pass",
        "clearance_usual": "pass",
        "length_ratio_application": "note",
    }
    usual = found.pop("clearance_usual")
    assert usual.limit == pytest.approx((0.9, 2.9)) and "makers" in usual.source
    assert all(c.kind == "advice" and "Finotti 2013, Fig. 5.16" in c.source for c in found.values())
    assert found["length_ratio_application"].limit == (0.8, 1.5)


@pytest.mark.parametrize("name", applications())
def test_each_application_yields_what_its_row_has(name):
    row, found = applications()[name], judged(name)
    there = {
        "application_load": row.specific_load_high,
        "application_pv": row.pv,
        "application_duty": row.duty_low,
        "length_ratio_application": row.length_ratio_low,
    }
    assert set(found) == {"clearance_usual", *(key for key, number in there.items() if number is not None)}
    assert (row.specific_load_low or 0) <= (row.specific_load_high or 0)


def test_the_usual_clearance_is_that_of_the_makers():
    """Least printed clearance and largest printed middle over d: GM L61, rear, and Caterpillar 3304."""
    assert RELATIVE_CLEARANCE[0] == pytest.approx(0.033 / 36.733, abs=5e-6)
    assert RELATIVE_CLEARANCE[1] == pytest.approx((0.081 + 0.229) / 2 / 52.895, abs=5e-5)


def test_duty_is_a_pure_number_in_revolutions_per_second():
    """McKee's 30 cP·rpm/psi is 7.25·10⁻⁸ (1 cP, 1 rpm = 1/60 per second, 1 psi = 6894.757 Pa): the figure's values are
    of that size."""
    assert film_duty(mu=30e-3, n_h=1 / 60, p=6894.757) == pytest.approx(7.25e-8, abs=5e-11)
    assert film_duty(mu=6.49260e-3, n_h=2600 / 60, p=1.0451e6) > applications()["diesel-main"].duty_low


@given(st.floats(1e4, 1e8), st.floats(0.01, 100))
def test_p_times_u(p, u):
    assert load_times_speed(p=p, u=u) / u == pytest.approx(p)


def test_rows_are_of_their_kind_and_words_of_the_scale():
    assert all(isinstance(m, BearingMaterial) and m.emergency_running in SCALE for m in bearing_materials().values())
    assert all(isinstance(row, Application) and row.title for row in applications().values())


def test_the_tables_are_read_without_numpy():
    code = (
        "import sys; from calc.bearings.plain.materials import *; "
        "bearing_materials(); applications(); bush_problem('x'); print('numpy' in sys.modules)"
    )
    assert (
        subprocess.run(
            [sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT, check=True
        ).stdout.strip()
        == "False"
    )


@pytest.mark.parametrize("name", applications())
def test_one_application_is_read_as_all_of_them_are(name):
    assert application(name) == applications()[name]
