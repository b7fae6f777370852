# SPDX-License-Identifier: Apache-2.0
"""Bush and shells in their housing: two rings over temperature, what holds them, and the parts that make a clearance."""

import json
import math
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from calc.bearings.plain.seats import formulas as f
from calc.bearings.plain.seats.result import Temperatures
from calc.bearings.plain.seats.rings import Rings
from calc.bearings.plain.seats.seat import chosen, seated
from calc.bearings.plain.seats.stack import SeatStack, stack_of
from calc.countershaft.rows import BearingRow
from calc.library.catalogue import materials

REFERENCE = json.loads((Path(__file__).parents[3] / "reference" / "seats.json").read_text(encoding="utf-8"))
MM, UM, MPA = 1e-3, 1e-6, 1e6
SOLIDS = materials()
STEEL = SOLIDS["42CrMo4"]


def of(chapter):
    """The given values whose case begins so."""
    rows = [row for row in REFERENCE["given"] if row["case"]["what"].startswith(chapter)]
    assert rows
    return [pytest.param(row, id=f"{row['case']['what']} {row['quantity']} {n}") for n, row in enumerate(rows)]


def holds(row, got):
    assert got == pytest.approx(row["is"], rel=row["rel"], abs=row["rel"] * 1e-3)


def rings_of_case(case, **more):
    delta = case.get("interference_um", case.get("interference_20_um", 0.0)) * UM
    given = dict(
        backing=SOLIDS[case["backing"]],
        housing=SOLIDS[case["housing"]],
        wall=0.0,
        restraint=0.0,
        reference=20.0,
        interference=(delta, delta),
        bore=case["d_o_mm"] * MM,
        outside=case["housing_outer_mm"] * MM,
    )
    return Rings(**{**given, **more})


def mm(limits):
    return tuple(x * MM for x in limits)


def test_the_materials_are_those_of_the_given_values():
    for name, row in REFERENCE["materials"].items():
        there = SOLIDS[name]
        assert (there.E, there.poisson, there.expansion) == pytest.approx(
            (row["E_GPa"] * 1e9, row["nu"], row["expansion_1e6_K"] * 1e-6)
        )


@pytest.mark.parametrize("row", of("4.1 rings"))
def test_two_rings(row):
    case = row["case"]
    rings = rings_of_case(case)
    fit = rings.fit_of(case["d_o_mm"] * MM, case["d_i_mm"] * MM)
    state = rings.pressed(fit, rings.middle)
    q = f.housing_tension(p=state.p, D=fit.D, d_o=fit.d_o)
    alpha = dict(alpha_B=rings.backing.expansion, alpha_H=rings.housing.expansion)
    got = {
        "press MPa": state.p / MPA,
        "bore after pressing mm, free bore d_i": (fit.d_i - state.c) / MM,
        "growth of the housing's bore µm": f.housing_growth(p=state.p, d_o=fit.d_o, k_H=fit.k_H) / UM,
        "hoop stress of the bush MPa": f.bush_stress(p=state.p, d_o=fit.d_o, d_i=fit.d_i) / MPA,
        "von Mises of the housing MPa": f.housing_stress(sigma_H=q, p=state.p) / MPA,
        "expansion of the assembled bore 1e-6/K": f.bore_expansion(
            s=state.c / state.delta, d_o=fit.d_o, d_i=fit.d_i, chi=0.0, **alpha
        )
        / UM,
    }
    holds(row, got[row["quantity"]])


@pytest.mark.parametrize("row", of("4.3 seat"))
def test_a_seat_over_temperature(row):
    case, T = row["case"], row["case"]["all_at_C"]
    journal = case["journal_mm"] * MM
    rings, clearance = rings_of_case(case, journal=journal), case["assembled_bore_mm"] * MM - journal
    fit = rings.fit(journal, clearance)
    got = {
        "clearance µm": rings.clearance_at(journal, clearance, STEEL.expansion, T, T) / UM,
        "press MPa (0: loose)": rings.at(fit, rings.middle, T, T).p / MPA,
    }
    holds(row, got[row["quantity"]])


@pytest.mark.parametrize("row", of("4.3 direct"))
def test_a_bore_of_the_housing_itself(row):
    case = row["case"]
    T, alpha_H = case["all_at_C"], SOLIDS[case["housing"]].expansion
    bore = f.own_bore_at(d_i=case["assembled_bore_mm"] * MM, alpha_H=alpha_H, chi=0.0, T=T, T_ref=20.0)
    holds(row, f.clearance_in(d_iT=bore, d_J=case["journal_mm"] * MM, alpha_J=STEEL.expansion, T=T, T_ref=20.0) / UM)


@pytest.mark.parametrize("row", of("4.2 crush"))
def test_the_crush_of_one_half(row):
    case = {"d_o_mm": 30.0, "wall_mm": 1.5, "width_mm": 20.0, "backing": "strip", **row["case"]}
    got = f.interference_of_crush(
        c=case["crush_um"] * UM,
        F_c=case["crush_load_N"],
        d_o=case["d_o_mm"] * MM,
        E_B=SOLIDS[case["backing"]].E,
        w=case["wall_mm"] * MM,
        b=case["width_mm"] * MM,
    )
    holds(row, got / UM)


def row_of(**keys):
    return BearingRow(name="front", **keys)


def test_the_press_that_keeps_a_fit_shut_and_the_interference_that_is_chosen_for_it():
    (press,) = (row for row in REFERENCE["given"] if row["case"]["what"] == "4.4")
    case = press["case"]
    holds(press, f.press_needed(F=case["load_N"], d_o=case["d_o_mm"] * MM, l=case["length_mm"] * MM) / MPA)
    (choice,) = (row for row in REFERENCE["given"] if row["case"]["what"] == "4.4 chosen interference")
    case = choice["case"]
    rings = rings_of_case(case, chosen=True, journal=case["d_i_mm"] * MM)
    at = Temperatures(case["coldest_C"], 20.0, case["hottest_C"], case["hottest_C"], None)
    shells = row_of(diameter=case["d_i_mm"] * MM, length=case["length_mm"] * MM, seat="shells")
    made = chosen(rings, shells, 0.0, case["load_N"], at)
    assert np.array(made.interference) / UM == pytest.approx(choice["is"], rel=choice["rel"])
    bush = chosen(rings, row_of(diameter=shells.diameter, length=shells.length, seat="bush"), 0.0, case["load_N"], at)
    least, most = bush.interference
    assert least / UM == pytest.approx(choice["is"][0], rel=choice["rel"])
    assert (most - least) / UM == pytest.approx(25.0)  # IT7 of 31 mm, ISO 286
    given_ = rings_of_case(case | {"interference_um": 40.0})
    assert chosen(given_, shells, 0.0, case["load_N"], at) is given_, "what is given stays"


@pytest.mark.parametrize("hot, housing", [(110.0, 110.0), (110.0, 90.0), (60.0, 130.0)])
@pytest.mark.parametrize("metal", ["EN AC-43100", "EN-GJL-250", "steel"])
def test_the_chosen_interference_keeps_the_press_in_every_state_and_no_more(metal, hot, housing):
    row = row_of(diameter=28e-3, length=18e-3, seat="shells")
    rings = Rings(SOLIDS["strip"], SOLIDS[metal], 1.5e-3, 0.0, 20.0, (0.0, 0.0), chosen=True)
    made = chosen(rings, row, 35e-6, 2473.0, Temperatures(-20.0, 20.0, hot, housing, None))
    fit = made.fit(row.diameter, 35e-6)
    presses = [made.at(fit, made.interference[0], *state).p for state in ((hot, housing), (-20.0, -20.0), (20.0, 20.0))]
    assert min(presses) == pytest.approx(2 * 2473.0 / (math.pi * fit.d_o * row.length))


# --- the stack of parts


@pytest.mark.parametrize("row", of("4.5 stack"))
def test_the_clearance_of_a_stack(row):
    case = row["case"]
    walls = mm(case["wall_mm"]) if "wall_mm" in case else None
    stack = stack_of(
        row_of(
            diameter=case["journal_mm"][0] * MM,
            journal=mm(case["journal_mm"]),
            bore=mm(case["bore_mm"]),
            wall=walls,
            seat="direct" if walls is None else "bush",
        ),
        None,
    )
    rings = None
    if walls is not None:
        rings = Rings(SOLIDS["strip"], SOLIDS["EN AC-43100"], sum(walls) / 2, 0.0, 20.0, (0.0, 0.0))
        if "rise_um" in case:
            rings = _risen(rings, sum(stack.bore) / 2, sum(walls) / 2, case["rise_um"] * UM)
    assert np.array(stack.clearances(rings)) / UM == pytest.approx(row["is"], rel=row["rel"])


def _risen(rings, bore, wall, rise):
    """The same with the interference whose seated bore stands so much wider: it is a share of the interference."""
    fit = rings.fit_of(bore, bore - 2 * wall)
    delta = rise / (1 - rings.pressed(fit, 1e-6).c / 1e-6)
    return Rings(rings.backing, rings.housing, wall, 0.0, 20.0, (delta, delta))


def test_ld9_as_its_maker_prints_it():
    """34 to 100 µm by the diameters alone; the printed 44 to 111 by 10.5 µm of which the housing gives way: in
    aluminium of twice the bore that is 31 µm of interference, 12.4 MPa and 49 µm of crush."""
    ld9 = row_of(diameter=29.96e-3, journal=mm((29.95, 29.975)), bore=mm((33.025, 33.05)), wall=mm((1.5, 1.508)))
    stack = stack_of(BearingRow(**{**vars(ld9), "seat": "shells"}), None)
    rigid = Rings(SOLIDS["strip"], SOLIDS["EN AC-43100"], 1.504e-3, 0.0, 20.0, (0.0, 0.0))
    assert np.array(stack.clearances(rigid)) / UM == pytest.approx((34.0, 100.0))
    rings = _risen(rigid, 33.0375e-3, 1.504e-3, 10.5e-6)
    assert np.round(np.array(stack.clearances(rings)) / UM) == pytest.approx((44.0, 110.0), abs=0.6)  # prints 44, 111
    fit = rings.fit_of(33.0375e-3, 30.0295e-3)
    assert rings.middle / UM == pytest.approx(31.0, abs=0.5)
    assert rings.pressed(fit, rings.middle).p / MPA == pytest.approx(12.4, abs=0.2)
    assert math.pi / 2 * rings.middle / UM == pytest.approx(49.0, abs=0.7)


def test_a_finished_bore_is_what_it_was_cut_to():
    row = row_of(diameter=30e-3, journal=mm((29.95, 29.97)), finished=mm((30.02, 30.06)), seat="bush", bore_="finished")
    rings = Rings(SOLIDS["strip"], SOLIDS["EN AC-43100"], 2e-3, 0.0, 20.0, (50e-6, 60e-6))
    assert np.array(stack_of(row, None).clearances(rings)) / UM == pytest.approx((50.0, 110.0))


parts = st.tuples(st.floats(0, 1), st.floats(0, 1), st.floats(0, 1), st.floats(0, 1))


@given(at=parts, widths=st.tuples(*[st.floats(0, 0.03)] * 3), delta=st.tuples(st.floats(0, 60), st.floats(0, 60)))
def test_every_part_within_its_limits_makes_a_clearance_within_theirs(at, widths, delta):
    """The least with the least interference, the most with the most."""
    least, most = sorted(delta)
    bore, walls, journal = mm((33.0, 33.0 + widths[0])), mm((1.48, 1.48 + widths[1])), mm((29.9, 29.9 + widths[2]))
    rings = Rings(SOLIDS["strip"], SOLIDS["EN AC-43100"], sum(walls) / 2, 0.0, 20.0, (least * UM, most * UM))
    low, high = SeatStack(bore, walls, journal).clearances(rings)
    D, w, d, one = (a + share * (b - a) for share, (a, b) in zip(at, (bore, walls, journal, rings.interference)))
    fit = rings.fit_of(sum(bore) / 2, sum(bore) / 2 - sum(walls))
    g = D - 2 * w - d + one - rings.pressed(fit, one).c
    assert low - 1e-15 <= g <= high + 1e-15


# --- rings against rings


def shrunk(rings, T):
    """Thick rings in plane stress from the inside out, each (inner radius, outer radius, E, ν, α), free at 20 °C: radii
    at the bore, the pressures and radii at the joints, by continuity of displacement and of pressure.

    u = A r + B/r + α ΔT r; σ_r = E/(1 − ν²)·((1 + ν) A − (1 − ν) B/r²)."""
    n = len(rings)
    M, y = np.zeros((2 * n, 2 * n)), np.zeros(2 * n)

    def radial(i, r):
        _, _, E, nu, _ = rings[i]
        row = np.zeros(2 * n)
        row[2 * i : 2 * i + 2] = E / (1 + nu) * np.array([(1 + nu) / (1 - nu), -1 / r**2])
        return row

    def moved(i, r):
        row = np.zeros(2 * n)
        row[2 * i : 2 * i + 2] = r, 1 / r
        return row, r * (1 + rings[i][4] * (T - 20.0))

    M[0], M[1] = radial(0, rings[0][0]), radial(n - 1, rings[-1][1])
    for i, (inner, outer) in enumerate(pairwise(rings)):
        M[2 + 2 * i] = radial(i, inner[1]) - radial(i + 1, outer[0])
        (here, free), (there, wide) = moved(i, inner[1]), moved(i + 1, outer[0])
        M[3 + 2 * i], y[3 + 2 * i] = here - there, wide - free
    scale = np.abs(M).max(axis=1)
    x = np.linalg.solve(M / scale[:, None], y / scale)
    row, free = moved(0, rings[0][0])
    presses = [-(radial(i, ring[1]) @ x) for i, ring in enumerate(rings[:-1])]
    joints = [free_ + at @ x for at, free_ in (moved(i + 1, ring[0]) for i, ring in enumerate(rings[1:]))]
    return free + row @ x, presses, joints


CASES = [
    # backing, housing, d_i, d_o, D in mm, δ in µm
    ("strip", "EN AC-43100", 30.0, 33.0, 60.0, 28.0),
    ("strip", "EN AC-43100", 28.0, 31.0, 62.0, 35.0),
    ("strip", "EN-GJL-250", 49.0, 53.0, 106.0, 60.0),
    ("CuSn10P", "EN-GJL-250", 36.0, 42.0, 80.0, 40.0),
    ("CuSn10P", "EN AC-43100", 20.0, 30.0, 40.0, 30.0),
    ("strip", "EN AC-43100", 30.0, 31.0, 120.0, 50.0),
]


@pytest.mark.parametrize("backing, housing, d_i, d_o, D, delta", CASES)
def test_rings_as_general_rings_have_them(backing, housing, d_i, d_o, D, delta):
    """Free sizes made from the assembled bore, the housing in two parts that fit each other: every radius moves, where
    the program's rings keep theirs; press, bore and its change over temperature agree to 3·10⁻³, the press over
    temperature to 5·10⁻³ (an interference grows with the heat too, by a share of 2·10⁻³)."""
    rings = Rings(SOLIDS[backing], SOLIDS[housing], 0.0, 0.0, 20.0, (delta * UM,) * 2, bore=d_o * MM, outside=D * MM)
    fit = rings.fit_of(d_o * MM, d_i * MM)
    free = fit.d_i + rings.pressed(fit, rings.middle).c
    inside, around = ((s.E, s.poisson, s.expansion) for s in (rings.backing, rings.housing))
    half = (fit.d_o + fit.D) / 4
    parts = [
        (free / 2, (fit.d_o + rings.middle) / 2, *inside),
        (fit.d_o / 2, half, *around),
        (half, fit.D / 2, *around),
    ]
    bore_20, (press, _), joints = shrunk(parts, 20.0)
    assert 2 * bore_20 == pytest.approx(fit.d_i, rel=1e-6)
    assert rings.pressed(fit, rings.middle).c == pytest.approx(free - 2 * bore_20, rel=3e-3)
    assert press == pytest.approx(rings.pressed(fit, rings.middle).p, rel=3e-3)
    grown = f.housing_growth(p=rings.pressed(fit, rings.middle).p, d_o=fit.d_o, k_H=fit.k_H)
    assert 2 * joints[0] - fit.d_o == pytest.approx(grown, rel=3e-3)
    seen, at_20 = 0, press
    for T in (-40.0, 60.0, 100.0, 140.0):
        bore, (press, _), _ = shrunk(parts, T)
        if press <= 0:
            continue
        seen += 1
        ours = rings.clearance_at(fit.d_i, 0.0, 0.0, T, T)  # on a journal that does not grow
        assert ours == pytest.approx(2 * (bore - bore_20), rel=3e-3)
        assert rings.at(fit, rings.middle, T, T).p == pytest.approx(press, rel=5e-3, abs=5e-3 * at_20)
    assert seen >= 2


@given(
    d=st.tuples(st.floats(10, 60), st.floats(1.02, 1.6), st.floats(1.2, 6)),
    delta=st.floats(1, 100),
    metal=st.sampled_from(["steel", "EN AC-43100", "EN-GJL-250", "CuSn10P"]),
)
def test_one_material_as_shigley_has_it(d, delta, metal):
    """p = E δ (d_o² − d_i²)(D² − d_o²)/(2 d_o³ (D² − d_i²))."""
    d_i, d_o = d[0] * MM, d[0] * d[1] * MM
    D, one = d_o * d[2], SOLIDS[metal]
    rings = Rings(one, one, 0.0, 0.0, 20.0, (delta * UM,) * 2, outside=D)
    expected = one.E * delta * UM * (d_o**2 - d_i**2) * (D**2 - d_o**2) / (2 * d_o**3 * (D**2 - d_i**2))
    assert rings.pressed(rings.fit_of(d_o, d_i), delta * UM).p == pytest.approx(expected, rel=1e-12)


# --- over temperature


@pytest.mark.parametrize("chi", [0.0, 0.2])
def test_where_it_comes_loose_the_clearance_goes_on_and_its_slope_jumps(chi):
    """From that of the pressed bore, between bush and housing, to that of the bush alone."""
    rings = Rings(SOLIDS["strip"], SOLIDS["EN AC-43100"], 1.5e-3, chi, 20.0, (28e-6,) * 2)
    row, g = row_of(diameter=30e-3, length=20e-3, seat="bush"), 70e-6
    at = Temperatures(-20.0, 20.0, 100.0, 100.0, 100.0)
    seat = seated(rings, row, g, 3000.0, 50.0, 900.0, at)
    T_0, alpha_B = seat.loose_at, rings.backing.expansion
    assert 60 < T_0 < 200

    def bore(T):
        return rings.clearance_at(row.diameter, g, 0.0, T, T) + row.diameter

    assert bore(T_0 - 1e-9) == pytest.approx(bore(T_0 + 1e-9), abs=1e-15)
    fit = rings.fit(row.diameter, g)
    assert rings.at(fit, rings.middle, T_0 - 1, T_0 - 1).p > 0 == rings.at(fit, rings.middle, T_0 + 1, T_0 + 1).p
    tight, loose = bore(T_0 - 1) - bore(T_0 - 2), bore(T_0 + 2) - bore(T_0 + 1)
    # what closes it at the reference temperature grows with the bush too
    assert tight == pytest.approx(seat.bore * seat.expansion + seat.bore_closing * alpha_B, rel=1e-7)
    assert loose == pytest.approx(seat.bore_free * alpha_B, rel=1e-7)
    assert alpha_B < seat.expansion < rings.housing.expansion * (1 - chi) * seat.rings.fit(0.03, g).d_o / seat.bore
    assert tight > 1.2 * loose


def test_the_example_of_a_thin_shell_in_aluminium():
    """1.5 mm of steel, 33 mm in aluminium of 66: 0.67 of the interference closes the bore, 18.8·10⁻⁶/K between 11.5 and
    21.5; 31 µm are used up at 115 °C, 35 µm around 31 mm at 133 °C."""
    rings = Rings(SOLIDS["strip"], SOLIDS["EN AC-43100"], 1.5e-3, 0.0, 20.0, (31e-6,) * 2)
    fit = rings.fit(30e-3, 0.0)
    s = rings.pressed(fit, 1e-6).c / 1e-6
    assert s == pytest.approx(0.67, abs=0.005)
    alpha = f.bore_expansion(alpha_B=11.5e-6, s=s, d_o=fit.d_o, d_i=fit.d_i, alpha_H=21.5e-6, chi=0.0)
    assert alpha == pytest.approx(18.8e-6, abs=0.1e-6)
    for delta, d_o, T_0 in ((31e-6, 33e-3, 115.0), (35e-6, 31e-3, 133.0)):
        loose = f.loose_at(T_ref=20.0, delta=delta, d_o=d_o, alpha_H=21.5e-6, chi=0.0, alpha_B=11.5e-6)
        assert loose == pytest.approx(T_0, abs=1.5)


def test_a_bush_in_metal_that_grows_less_never_comes_loose():
    rings = Rings(SOLIDS["strip"], SOLIDS["EN-GJL-250"], 2e-3, 0.0, 20.0, (10e-6, 30e-6))
    row = row_of(diameter=49e-3, length=24e-3, seat="bush")
    at = Temperatures(-20.0, 20.0, 110.0, 110.0, 100.0)
    seat = seated(rings, row, 100e-6, 2100.0, 50.0, 540.0, at)
    assert seat.loose_at is None and seat.press_hot > seat.press > seat.press_cold
    assert seat.press_hot_cool > seat.press_hot, "round a cooler housing it sits tighter"
    within = Temperatures(-20.0, 20.0, 110.0, 100.0, None)
    assert seated(rings, row, 100e-6, 2100.0, 50.0, 540.0, within).press_hot_cool is None


def test_stresses_are_of_the_most_interference_in_the_tightest_state():
    """In aluminium the cold is the tightest, in iron the heat."""
    row = row_of(diameter=30e-3, length=20e-3, seat="bush")
    for metal, T in (("EN AC-43100", -20.0), ("EN-GJL-250", 140.0)):
        rings = Rings(SOLIDS["strip"], SOLIDS[metal], 2e-3, 0.0, 20.0, (10e-6, 30e-6))
        seat = seated(rings, row, 50e-6, 1000.0, 50.0, 540.0, Temperatures(-20.0, 20.0, 140.0, 140.0, None))
        fit = rings.fit(row.diameter, 50e-6)
        p = rings.at(fit, 30e-6, T, T).p
        assert seat.bush_stress == pytest.approx(f.bush_stress(p=p, d_o=fit.d_o, d_i=fit.d_i))
        q = p * (fit.D**2 + fit.d_o**2) / (fit.D**2 - fit.d_o**2)
        assert seat.housing_stress == pytest.approx(math.sqrt(q**2 + q * p + p**2)) and seat.tension == q


sizes = st.tuples(st.floats(15, 60), st.floats(1, 4), st.floats(1.5, 5), st.floats(0, 80), st.floats(10, 200))


@given(sizes=sizes, T=st.lists(st.floats(-40, 160), min_size=1, max_size=5), T_H=st.floats(-40, 160))
def test_arrays_are_many_single_seats(sizes, T, T_H):
    d, w, ratio, delta, g = sizes
    d_o = (d + 2 * w) * MM
    rings = Rings(SOLIDS["strip"], SOLIDS["EN AC-43100"], w * MM, 0.0, 20.0, (0.0, 2 * delta * UM), outside=ratio * d_o)
    diameters = d * MM * np.linspace(0.95, 1.0, len(T))
    clearances = g * UM * np.linspace(1.0, 0.8, len(T))
    many = rings.clearance_at(diameters, clearances, STEEL.expansion, np.array(T), T_H)
    one = [rings.clearance_at(a, b, STEEL.expansion, t, T_H) for a, b, t in zip(diameters, clearances, T)]
    assert many == pytest.approx(one, abs=1e-15)


@given(sizes=sizes, more=st.floats(0.1, 50), metal=st.sampled_from(["EN AC-43100", "EN-GJL-250", "steel"]))
def test_more_interference_is_more_press_and_what_is_given_stays(sizes, more, metal):
    d, w, ratio, delta, g = sizes
    rings = Rings(
        SOLIDS["strip"], SOLIDS[metal], w * MM, 0.0, 20.0, (delta * UM,) * 2, outside=ratio * (d + 2 * w) * MM
    )
    fit = rings.fit(d * MM, g * UM)
    for T in (-20.0, 20.0, 120.0):
        less = rings.at(fit, delta * UM, T, T)
        tighter = rings.at(fit, (delta + more) * UM, T, T)
        assert tighter.p > less.p or tighter.p == less.p == 0.0
        assert 0.0 <= less.c <= max(less.delta, 0.0), "the housing gives way too"
        assert tighter.delta == pytest.approx(less.delta + more * UM)
    assert rings.clearance_at(d * MM, g * UM, STEEL.expansion, 20.0, 20.0) == pytest.approx(g * UM, abs=1e-14)
    needed = rings.needed(fit, 5e6, 120.0, 90.0)
    assert rings.at(fit, needed, 120.0, 90.0).p == pytest.approx(5e6)


def test_the_holding_torque_is_friction_all_around():
    held = f.holding_torque(mu_s=0.1, p=5e6, d_o=0.031, l=0.018)
    assert held == pytest.approx(0.1 * 5e6 * (math.pi * 0.031 * 0.018) * 0.031 / 2)
    assert f.drag_torque(P_f=100.0, omega=890.0) == pytest.approx(100 / 890)
