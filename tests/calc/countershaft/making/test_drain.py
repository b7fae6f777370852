"""The hose clamp and the pipe union of the oil drain."""

import math
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.bearings.result import BearingsResult
from calc.countershaft.making import drain
from calc.countershaft.making.inputs import Clamp, OilDrain, Sleeve, Union, thread, thread_problem
from calc.countershaft.solve import laminar_speed, run_off, turbulent_speed, with_oil
from calc.sheet.quantity import published
from calc.sheet.value import link_of, trace
from tests.calc.countershaft.shafts import outcome
from tests.calc.countershaft.shafts import verdicts as shaft_verdicts


def asked(low, high, name="M18x1.5", **own):
    return OilDrain(hose_min=low / 1e3, hose_max=high / 1e3, thread=name, **own)


def clamp(nominal, opening):
    return Clamp(nominal=nominal / 1e3, opening=opening / 1e3)


def verdicts(found):
    return {c.id.removeprefix("countershaft.drain."): c.verdict for c in drain.checks(found)}


def test_the_source_design():
    """Finotti 2013, 4.4: hose ends 22.5 and 24 mm → clamp 22, opening 24.5 mm; block M18×1.5 → washers 18×22×1.5; the
    bore stands blank in its table, where a blank repeats the row above: 11 mm."""
    r = drain.solve(asked(22.5, 24.0))
    shown = {p.id: p.shown for p in published(r, "countershaft")}
    assert shown == pytest.approx(
        {
            "countershaft.clamp_nominal": 22.0,
            "countershaft.clamp_opening": 24.5,
            "countershaft.clamp_margin": 0.5,
            "countershaft.clamp_opening_din3021": 24.2,
            "countershaft.union_bore": 11.0,
            "countershaft.sleeve_bore": 7.5,
            "countershaft.sleeve_end": 16.0,
        }
    )
    assert verdicts(r) == {"clamp": "pass", "clamp_din3021": "pass", "union": "pass"}
    margins = {c.id: c.value for c in drain.checks(r)}
    assert margins["countershaft.drain.clamp"] == pytest.approx(0.5) and margins[
        "countershaft.drain.clamp_din3021"
    ] == pytest.approx(0.2)
    assert any("18 × 22 × 1.5" in note for note in drain.notes(r))


@pytest.mark.parametrize(
    "nominal, source, standard",
    [
        (13, 14.5, 14.2),
        (14, 15.8, 15.8),
        (15, 16.8, 16.5),
        (16, 17.5, 17.5),
        (17, 18.5, 18.5),
        (19, 21, 20.2),
        (20, 21.6, 21.6),
        (21, 22.5, 22.5),
        (22, 24.5, 24.2),
        (23, 24.7, 24.7),
        (25, 27, 26.8),
    ],
)
def test_the_tables(nominal, source, standard):
    """Finotti 2013, Table 4.3, beside DIN 3021 as published by Westfield Fasteners."""
    for series, opening in (("company", source), ("din3021", standard)):
        found = {round(c.nominal * 1e3, 6): c.opening * 1e3 for c in drain.clamps(series)}
        assert found[nominal] == pytest.approx(opening)


def test_the_tables_rise_and_each_clamp_opens_beyond_its_size():
    for series, count in (("company", 11), ("din3021", 39)):
        rows = drain.clamps(series)
        assert len(rows) == count
        assert [c.nominal for c in rows] == sorted({c.nominal for c in rows})
        assert [c.opening for c in rows] == sorted(c.opening for c in rows)
        assert all(not list(c.problems()) for c in rows)


def test_the_next_size_up_is_not_taken():
    """A clamp of 23 mm would open over 24.6 mm, but it is not closed on 22.5 mm."""
    r = drain.solve(asked(22.5, 24.6))
    assert r.clamp_nominal is r.clamp_opening is r.clamp_margin is r.clamp_opening_din3021 is None
    assert verdicts(r) == {"clamp": "warn", "union": "pass"}
    assert "would not grip" in r.reason and any("would not grip" in note for note in drain.notes(r))
    assert next(drain.checks(r)).value == pytest.approx(-0.1)


def test_bounds_belong_to_the_clamp():
    r = drain.solve(asked(22.0, 24.5))
    assert (r.clamp_nominal, r.clamp_margin) == (0.022, 0.0)
    assert verdicts(r)["clamp"] == "pass", "it fits, without any spare"
    assert drain.solve(asked(21.99, 22.6)).clamp_nominal is None


def test_the_opening_of_the_standard_may_be_too_small():
    r = drain.solve(asked(22.5, 24.4))
    assert r.clamp_opening == pytest.approx(0.0245)
    assert verdicts(r) == {"clamp": "pass", "clamp_din3021": "note", "union": "pass"}


def test_a_hose_smaller_than_every_clamp():
    r = drain.solve(asked(12.0, 12.5))
    assert r.clamp_nominal is None and "none grips" in r.reason
    assert verdicts(r)["clamp"] == "warn"
    (first, *_) = drain.checks(r)
    assert (first.value, first.limit) == pytest.approx((13.0, 12.0)) and r.smallest == 13e-3


def test_a_clamp_of_the_standard_of_another_size_says_nothing_of_the_one_that_is_taken():
    r = drain.solve(asked(18.5, 18.5))  # of DIN 3021 there is one of 18 mm as well, which opens to 19
    assert (r.clamp_nominal, r.clamp_opening) == pytest.approx((17e-3, 18.5e-3))
    assert r.clamp_opening_din3021 is r.tried_din3021 is None and "clamp_din3021" not in verdicts(r)


def test_the_standard_is_named_where_the_source_has_no_clamp():
    r = drain.solve(asked(30.0, 32.0))
    assert r.clamp_nominal is None
    assert "DIN 3021 has one of 30 mm that opens to 32.5 mm" in r.reason


def test_the_designs_own_clamps_replace_those_of_the_program():
    r = drain.solve(asked(22.5, 24.0, clamps=(clamp(10, 12), clamp(18, 25), clamp(22.4, 23), clamp(22.4, 24.1))))
    assert (r.clamp_nominal, r.clamp_opening) == pytest.approx((0.0224, 0.0241))
    assert r.clamp_opening_din3021 is None and verdicts(r) == {"clamp": "pass", "union": "pass"}
    assert not any("Table 4.3" in note for note in drain.notes(r))


@given(
    st.floats(8, 60), st.floats(0, 6), st.lists(st.tuples(st.floats(5, 60), st.floats(0.1, 5)), min_size=1, max_size=8)
)
def test_a_clamp_that_is_taken_fits_both_ends_and_none_at_hand_grips_closer(low, more, sizes):
    at_hand = tuple(clamp(n, n + o) for n, o in sizes)
    hose = asked(low, low + more, clamps=at_hand)
    r = drain.solve(hose)
    closest = max((c.nominal for c in at_hand if c.nominal <= hose.hose_min), default=None)
    if r.clamp_nominal is None:
        assert r.reason and verdicts(r)["clamp"] == "warn"
        assert closest is None or all(c.opening < hose.hose_max for c in at_hand if c.nominal == closest)
    else:
        assert r.clamp_nominal == closest and r.clamp_opening >= hose.hose_max and not r.reason
        assert verdicts(r)["clamp"] == "pass"


# --- unions
@pytest.mark.parametrize(
    "name, bore",
    [
        ("M8x1", 4),
        ("M10x1", 5.5),
        ("M10", 5),
        ("M10×1.5", 5),
        ("M12x1", 5.5),
        ("M12x1.5", 7),
        ("M14x1.5", 9),
        ("M16x1", 11),
        ("M16x1.5", 11),
        ("M18x1.5", 11),
        ("M22x1.5", 12),
    ],
)
def test_unions_of_the_source(name, bore):
    """Finotti 2013, 4.4: thread → bore; of two the wider."""
    assert drain.solve(asked(22.5, 24.0, name)).union_bore * 1e3 == pytest.approx(bore)


@pytest.mark.parametrize("name", ["M18", "M20x1.5", "M12"])
def test_no_union_fits(name):
    r = drain.solve(asked(22.5, 24.0, name))
    assert r.union_bore is None and verdicts(r)["union"] == "warn"
    assert not any("sealed" in note for note in drain.notes(r))


@pytest.mark.parametrize("block, own, sealed", [("M18x1.5", "", True), ("M8x1", "", False), ("M18x1.5", "M8x1", False)])
def test_the_seal_of_the_union_that_fits(block, own, sealed):
    unions = (Union(thread=own, bore=4e-3),) if own else ()
    notes = drain.notes(drain.solve(asked(22.5, 24.0, block, unions=unions)))
    assert any("is sealed by" in note for note in notes) is sealed


def test_the_designs_own_unions_replace_those_of_the_program():
    own = (
        Union(thread="M20x1.5", bore=13e-3),
        Union(thread="M20×1.50", bore=14e-3),
        Union(thread="M18x1.5", bore=20e-3),
    )
    assert drain.solve(asked(22.5, 24.0, "M20x1.5", unions=own)).union_bore == 14e-3
    assert drain.solve(asked(22.5, 24.0, "M8x1", unions=own)).union_bore is None


def test_threads_of_the_table_can_be_read():
    assert len(drain.unions()) == 11
    assert all(thread_problem(union.thread) is None for union in drain.unions())
    assert len({thread(union.thread) for union in drain.unions()}) == 10
    assert len(drain.sleeves()) == 8 and all(not list(sleeve.problems()) for sleeve in drain.sleeves())


# --- sleeves
@pytest.mark.parametrize(
    "name, bore", [("M8x1", 4), ("M12x1.5", 6), ("M14x1.5", 5), ("M18x1.5", 7.5), ("M22x1.5", 12), ("M10x1", None)]
)
def test_sleeves_of_the_source(name, bore):
    """Finotti 2013, 4.4: the ring goes over the thread; the only one for M10 takes no hose."""
    r = drain.solve(asked(22.5, 24.0, name))
    assert r.sleeve_bore == (None if bore is None else pytest.approx(bore / 1e3))
    assert verdicts(r).get("sleeve") == ("note" if bore is None else None)


def test_a_sleeve_of_the_design():
    own = (
        Sleeve(ring=18e-3, bore=9e-3, end=16e-3),
        Sleeve(ring=18.05e-3, bore=10e-3, end=17e-3),
        Sleeve(ring=18.2e-3, bore=12e-3, end=20e-3),
    )
    r = drain.solve(asked(22.5, 24.0, sleeves=own))
    assert (r.sleeve_bore, r.sleeve_end) == (10e-3, 17e-3)
    assert [key for key, _ in Sleeve(ring=1.0, bore=1.0, end=1.0).problems()] == ["end_mm"]


@pytest.mark.parametrize(
    "ring, fits", [(17.9999, False), (18.0, True), (18.05, True), (18.097, True), (18.1, True), (18.103, False)]
)
def test_the_ring_of_a_sleeve_is_up_to_a_tenth_wider_than_the_thread(ring, fits):
    r = drain.solve(asked(22.5, 24.0, sleeves=(Sleeve(ring=ring / 1e3, bore=9e-3, end=16e-3),)))
    assert (r.sleeve_bore is not None) is fits


# --- tilted machine
@pytest.mark.parametrize("tilt, verdict", [(None, None), (30.0, "pass"), (45.0, "fail"), (60.0, "fail")])
def test_the_slope_that_a_tilted_machine_leaves(tilt, verdict):
    """Finotti 2013, 3.2.2: 45° of the support, so that the oil leaves also on a slope."""
    r = drain.solve(asked(22.5, 24.0, slope=math.radians(45), tilt=None if tilt is None else math.radians(tilt)))
    assert math.degrees(r.drain_slope) == pytest.approx(45.0 - (tilt or 0.0)) and verdicts(r).get("slope") == verdict
    assert any("narrowest bore" in note for note in drain.notes(r))


@pytest.mark.parametrize("own, missing", [({}, False), ({"slope": 0.1}, True), ({"slope": 0.1, "bore": 0.01}, False)])
def test_what_runs_off_needs_a_bore_where_there_is_a_slope(own, missing):
    notes = drain.notes(drain.solve(asked(22.5, 24.0, **own)))
    assert any("narrowest bore" in note for note in notes) is missing


def test_a_tilt_needs_a_slope():
    assert ["slope_deg"] == [key for key, _ in asked(22.5, 24.0, tilt=0.5).problems()]


@settings(max_examples=30)
@given(st.floats(0.01, 1.57), st.floats(2e-3, 30e-3), st.floats(2e-6, 1e-3))
def test_what_runs_off_is_half_of_a_full_pipe(theta, d, nu):
    """Hagen and Poiseuille below Re = (64/0.316)^(4/3), where Blasius gives the same; both laws balance weight and wall
    friction."""
    v_l, v_t = (speed(theta=theta, d=d, nu=nu) for speed in (laminar_speed, turbulent_speed))
    Q, v = run_off(d=d, v_l=v_l, v_t=v_t), min(v_l, v_t)
    assert Q == pytest.approx(v * math.pi * d**2 / 8)
    Re = v * d / nu
    assert max(64 / Re, 0.316 / Re**0.25) * v**2 / (2 * d) == pytest.approx(9.80665 * math.sin(theta))
    if Re < (64 / 0.316) ** (4 / 3):
        assert Q == pytest.approx(math.pi * 9.80665 * math.sin(theta) * d**4 / (256 * nu))


def test_the_oil_of_the_bearings_against_what_runs_off(gamma_results):
    """The source's drain takes all of the rear bearing's oil and half of the front one's; its bore is not given."""
    shaft, bearings = gamma_results.outcomes["countershaft"], gamma_results.result(BearingsResult)
    found = {}
    for bore in (8e-3, 16e-3):
        wanted = replace(shaft.result.drain.drain, bore=bore)
        solved = with_oil(replace(shaft, result=replace(shaft.result, drain=drain.solve(wanted))), bearings)
        found[bore] = next(c for c in solved.checks if c.id == "countershaft.drain.run_off")
        assert (
            solved.result.drain.drain_flow
            == bearings.bearings["rear"].oil_flow + bearings.bearings["front"].oil_flow / 2
        )
    assert [c.verdict for c in found.values()] == ["warn", "pass"]
    assert with_oil(shaft, bearings) is shaft


# --- several
def test_two_circuits():
    """Finotti 2013, 3.1.2: solution alpha has two; each is chosen and judged by itself, and what is noted of both is
    noted once."""
    own = {"hose_min_mm": 15.4, "hose_max_mm": 16.4, "thread": "M14x1.5"}
    found = outcome(oil_drain=own, further_drains=[{**own, "name": "middle", "hose_max_mm": 17.0, "thread": "M22x1.5"}])
    assert found.result.drain.union_bore == 9e-3 and found.result.further_drains["middle"].union_bore == 12e-3
    assert {id: v for id, v in shaft_verdicts(found).items() if "drain" in id} == {
        "drain.clamp": "pass",
        "drain.clamp_din3021": "pass",
        "drain.union": "pass",
        "further_drains.middle.clamp": "warn",
        "further_drains.middle.union": "pass",
    }
    assert sum("clamps by" in note for note in found.notes) == 1


def test_every_value_leads_back_to_a_line():
    with trace() as lines:
        r = drain.solve(asked(22.5, 24.0))
    assert all(link_of(p.inside) in lines for p in published(r, "countershaft"))
