"""Shafts on two to nine plain bearings, solved as whole designs: how the films share the load, how the journals tilt in
them, and a bearing that carries nothing."""

import math
from dataclasses import replace

import numpy as np
import pytest

from calc.bearings.plain.as_support import at_corners
from calc.bearings.plain.corners import corner_points
from calc.bearings.plain.loads import standing as standing_part
from calc.bearings.plain.loads import standing_checks
from calc.bearings.plain.routes.states import resized
from calc.bearings.plain.routes.thermal_balance import settled
from calc.bearings.plain.selection import together
from calc.bearings.plain.selection.search import nearest_row
from calc.bearings.plain.solve import PlainSupport
from calc.bearings.result import BearingsResult
from calc.bearings.sharing import on_films, shared, support_checks, turned_over
from calc.bearings.sketch import sketch
from calc.countershaft.bending.carried import carried
from calc.countershaft.bending.condensed import of_beam
from calc.countershaft.result import CountershaftResult
from calc.countershaft.rows import BearingRow, row_key
from calc.countershaft.supports import Gear, ShaftDrive, Sprocket, standing_of
from calc.countershaft.twins import resolved
from calc.design.addresses import quantities, quantity_of, value_at
from calc.design.step_inputs import bearings_case
from calc.design.toml_file import design
from calc.design.unusual import doubts
from calc.draw.drawing import Area, Polyline
from calc.friction.result import FrictionResult
from calc.library.catalogue import shipped_materials
from calc.sheet.errors import BadInput, NoSolution
from calc.solve import solve
from calc.studies.drive.problem import problem
from tests.calc.bearings.documents import alone, on_bearings, outcome
from tests.calc.countershaft.bending import cases

CASES = ("r754-films", "r754-middle-wide", "couple-middle-films")
FILM = ("film_edge", "film_double_load", "film_trumpler", "film_band", "mckee", "film_edge_corner", "film_overspeed")
NAMES = ("front", "middle", "rear")
ALUMINIUM = shipped_materials()["EN AC-43100"]


def solved(name, **changes):
    return solve(design(on_bearings(name, **changes)))


def rows_of(results):
    return results.result(BearingsResult).bearings


@pytest.fixture(scope="module")
def three():
    return solved("r754-films")


@pytest.fixture(scope="module")
def couple():
    return solved("couple-middle-films")


def wrong_of(document):
    with pytest.raises(BadInput) as caught:
        design(document)
    return {error.key: str(error.reason) for error in caught.value.errors}


# --- what they carry


@pytest.mark.parametrize("name", CASES)
def test_the_whole_design_gives_what_another_program_does(name):
    """Its films are the program's own in their balance; a viscosity that no heat changes makes them those of the case.

    Films: the clearance at the edge of the table's accuracy, 3e-4 in S, is some nm of a thin film."""
    values, found = solved(name).values(), 0
    for row in (row for row in cases.DATA["given"] if row["case"] == name):
        what, _, place = row["value"].partition(".")
        id = f"bearings.{place}.{what}" if place else f"bearings.{what}"
        if what == "slope":
            id = f"countershaft.slope_{place}"
        if id == "bearings.middle.load" and not row["is"]:
            assert values[id].inside == 0.0
            continue
        unit, near = cases.UNITS[row["unit"]], {"rel": 2e-3, "abs": 4e-9 if row["unit"] == "µm" else 0.0}
        if what == "load_phase":
            turned = (values[id].inside - row["is"] * unit + math.pi) % (2 * math.pi) - math.pi
            assert turned == pytest.approx(0.0, abs=math.radians(0.02))
        elif (name, id) == ("r754-middle-wide", "bearings.middle.standing_stiffness"):
            # the reference is 1.4 % above the direct solution of Reynolds' equation: test_as_supports
            assert values[id].inside == pytest.approx(row["is"] * unit, rel=2e-2)
        else:
            assert values[id].inside == pytest.approx(row["is"] * unit, **near), id
        found += 1
    assert found >= 12


@pytest.mark.parametrize("name", CASES)
def test_loads_and_inertia_are_in_equilibrium(name):
    """What the bearings carry is the force and the couple of the masses, and what the shaft adds by its way off its
    axis: ω²·∫ρ·A·w dz."""
    results, case = solved(name), cases.SHARE[name]
    found, shaft = results.result(BearingsResult), results.result(CountershaftResult)
    z, w = found.line
    mass, arm, ways = [], [], []
    for start, end, R, r_0, half, _ in case["pieces"]:
        area = math.pi * R**2 if half is None else math.pi * r_0**2 + math.radians(half) * (R**2 - r_0**2)
        places = np.linspace(start, end, 2001) / 1e3
        line = np.interp(places, z, w.real) + 1j * np.interp(places, z, w.imag)
        share = case["rho"] * area * 1e-6 * line
        mass.append(np.trapezoid(share, places))
        arm.append(np.trapezoid(share * places, places))
        ways += list(np.abs(line))
    P = [r.load * np.exp(1j * (r.on_shaft.load_phase or 0.0)) for r in found.bearings.values()]
    positions = [r.seat.bearing.position for r in found.bearings.values()]
    F = shaft.force_vector + shaft.omega**2 * sum(mass)
    C = shaft.couple_vector + shaft.omega**2 * sum(arm)
    size = max(abs(np.array(P)))
    assert sum(P) == pytest.approx(F, abs=1e-4 * size)
    assert sum(P_i * z_i for P_i, z_i in zip(P, positions)) == pytest.approx(C, abs=1e-4 * size * positions[-1])


def test_in_the_picture_each_load_fills_the_outline_of_that_on_rigid_supports(three):
    """The bar of the middle bearing ends short of its outline, those of the outer ones beyond theirs."""
    side = sketch(three.design, three).beside[-1]
    bars = [mark for mark in side.primitives if mark.key.endswith(".load_N")]
    shared = [np.ptp([y for _, y in bar.outlines[0]]) for bar in bars if isinstance(bar, Area)]
    rigid = [np.ptp([y for _, y in bar.points]) for bar in bars if isinstance(bar, Polyline)]
    found, pins = rows_of(three), three.result(CountershaftResult).loads
    scale = shared[0] / found["front"].load
    assert shared == pytest.approx([scale * found[name].load for name in NAMES])
    assert rigid == pytest.approx([scale * pins[name] for name in NAMES]) and shared[1] < rigid[1]


def test_tighter_bearings_share_as_rigid_supports_would():
    shares = []
    for c in (60.0, 40.0, 25.0):
        rows = rows_of(solved("r754-films", rows={name: {"clearance_um": c} for name in NAMES}))
        shares.append([abs(row.on_shaft.share - 1) for row in rows.values()])
    assert all(wide > narrow for wide, narrow in zip(shares[0], shares[1]))
    assert all(wide > narrow for wide, narrow in zip(shares[1], shares[2]))


def test_a_wider_middle_bearing_gives_load_to_the_outer_ones(three):
    wider = rows_of(solved("r754-films", rows={"middle": {"clearance_um": 90.0}}))
    rows = rows_of(three)
    assert wider["middle"].load < rows["middle"].load
    assert wider["front"].load > rows["front"].load and wider["rear"].load > rows["rear"].load


def test_heat_is_settled_with_the_loads():
    """An oil that thins, seats that grow: under its load each film is the one that shares it."""
    made = design(on_bearings("r754-films", viscosity_mPas=None, housing_material="EN AC-43100"))
    results = solve(made)
    (check,) = (c for c in results.checks() if c.id == "bearings.share_settled")
    assert check.verdict == "pass"
    rows = list(rows_of(results).values())
    temperatures = [row.hot.mean_temperature for row in rows]
    assert abs(temperatures[1] - temperatures[0]) > 0.2
    for row in rows:  # the way of the journal is that of its own film
        assert row.on_shaft.displacement == pytest.approx(row.eccentricity * row.clearance_hot / 2, rel=1e-3)


@pytest.mark.parametrize("ratio", [1.0, -1.0, -2.0])
def test_the_journals_turn_as_fast_as_the_shaft(ratio, three):
    """At another ratio under an engine that makes the same speed of the shaft: all of the bearings is the same.  A shaft
    that turns the other way is the same with its masses mirrored; those at 180° are their own image."""
    other = solved("r754-films", speed_ratio=ratio)
    values = other.values()
    for id, value in three.values().items():
        if not id.startswith("bearings."):
            continue
        if "phase" in id:
            turned = values[id].inside - math.copysign(1.0, ratio) * value.inside
            assert abs(math.remainder(turned, 2 * math.pi)) < 1e-7
        elif isinstance(value.inside, float):
            assert values[id].inside == pytest.approx(value.inside, rel=1e-9), id
    same = {c.id: c.verdict for c in three.checks() if c.id.startswith("bearings.")}
    assert {c.id: c.verdict for c in other.checks() if c.id.startswith("bearings.")} == same


def test_the_bench_run_is_the_crank_s():
    document = on_bearings("r754-films")
    bench = [{"speed_rpm": n, "oil_temperature_C": 100.0, "oil_pressure_bar": 4.0} for n in (1500.0, 3000.0)]
    document = replace(document, data=document.data | {"engine": document.data["engine"] | {"bench": bench}})
    sweep = rows_of(solve(design(document)))["front"].sweep
    assert (min(sweep.speeds) * 60, max(sweep.speeds) * 60) == pytest.approx((3000.0, 6000.0))


def test_a_given_speed_is_the_journals():
    assert "bearings.speed_rpm" in wrong_of(on_bearings("r754-films", speed_rpm=3000.0))
    assert rows_of(solved("r754-films", speed_rpm=6000.0))["front"].duty.speed == pytest.approx(100.0)


def test_a_corner_takes_the_share_anew(three):
    """The middle bearing at its largest clearance carries less: as a design of that clearance has it."""
    within = {"viscosity_tolerance_percent": 0.0}
    rows = rows_of(solved("r754-films", **within))
    widest = rows["middle"].corners.clearance_max
    wide = rows_of(solved("r754-films", rows={"middle": {"clearance_um": widest * 1e6}}, **within))["middle"]
    corners = rows["middle"].corners.columns
    at = int(np.argmax(corners["clearance"]))
    assert corners["film"][at] == pytest.approx(wide.film, rel=2e-3)
    assert wide.load < 0.999 * rows["middle"].load


@pytest.mark.parametrize("wider", [1.0, 1.05])
@pytest.mark.parametrize("softer", [1.0, 2.0])
def test_the_corners_of_all_bearings_are_those_of_each_alone(three, wider, softer):
    """Of bearings of one size and of several, near the middle and too far from it for undamped steps."""
    films, turning = _films(three), of_beam(*_beam(three))
    seats = [replace(row.seat, clearance=softer * row.seat.clearance) for row in rows_of(three).values()]
    seats[0] = resized(seats[0], diameter=seats[0].bearing.diameter * wider)
    duty = rows_of(three)["front"].duty
    _corners_are_those_of_each_alone(turning, films, seats, duty)


def _corners_are_those_of_each_alone(turning, films, seats, duty):
    shares = at_corners(turning, films, seats, duty)
    for i, name in enumerate(NAMES):
        load = abs(films.carried.load[i])
        film = settled(corner_points(seats[i], duty)[0], replace(duty, load=load))
        for k in (0, 7):
            c, mu = film.clearance[k].item(), film.oil.mu[k].item()
            laws = [replace(law, c=c, mu=mu) if j == i else law for j, law in enumerate(films.laws)]
            assert shares[name][k] == pytest.approx(abs(carried(turning, laws).load[i]) / load, rel=1e-9)


# --- a bearing that carries next to nothing


def test_a_middle_bearing_that_carries_nothing_is_a_row_that_says_so(couple):
    found = couple.outcomes["bearings"]
    assert found.state == "solved"
    middle, checks = rows_of(couple)["middle"], {c.id: c for c in found.checks}
    assert middle.load == 0.0 and middle.eccentricity == pytest.approx(0.02)
    assert checks["bearings.middle.unloaded"].verdict == "note"
    assert not any(f"bearings.middle.{name}" in checks for name in FILM)
    assert all(f"bearings.front.{name}" in checks for name in FILM)
    assert any("middle" in str(note).lower() and "centred" in str(note) for note in found.whole.notes)
    mu, n, d, l, c = 8e-3, 5600 / 60, 28e-3, 20e-3, 60e-6
    petroff = 2 * math.pi**3 * mu * n**2 * d**3 * l / c
    assert middle.friction_power == pytest.approx(petroff, rel=1e-3)


def test_what_is_drawn_and_listed_of_it_is_made(couple):
    whole = couple.outcomes["bearings"].whole
    assert {"in_films", "film_middle"} <= {curve.id for curve in whole.curves}
    assert {"corners_front", "corners_middle", "corners_rear"} <= {table.id for table in whole.tables}


def test_of_two_bearings_one_may_carry_nothing(gamma):
    rows = outcome(gamma, front__load_N=0.5).result.bearings
    assert rows["front"].seat.centred and not rows["rear"].seat.centred
    assert rows["front"].load == 0.5 < rows["front"].duty.load


def test_all_of_them_that_carry_nothing_have_no_film():
    found = solve(design(alone(front__load_N=0.01, rear__load_N=0.01))).outcomes["bearings"]
    assert found.state == "no_solution" and "nearly centred" in found.reason


def test_what_is_rounding_alone_is_nothing(couple):
    lies = rows_of(couple)["middle"].on_shaft
    assert (lies.displacement, lies.load_phase, lies.displacement_phase) == (0.0, None, None)


# --- what stands


def test_the_weight_is_shared_and_bores_add_to_it(three):
    standing = three.result(CountershaftResult).standing
    assert sum(standing.weights.values()) == pytest.approx(standing.weight, rel=1e-6)
    for name, row in rows_of(three).items():
        total = standing.weights[name] + row.on_shaft.alignment_load
        assert standing.stationary[name] == pytest.approx(total, rel=1e-9)
        assert standing.peaks[name] == pytest.approx(row.load + total, rel=1e-9)
        assert row.standing.standing_load == standing.stationary[name]


def test_a_bore_that_is_too_high_lifts_the_shaft():
    """20 µm up in the middle: what stands there is the weight and the load of the bore; sideways both add as a right
    angle."""
    exact = {"coaxiality_um": 0.0}
    up, side, straight = (
        solved("r754-films", rows={"middle": {"offset_um": offset}}, **exact).result(CountershaftResult).standing
        for offset in ([20.0, 0.0], [0.0, 20.0], None)
    )
    weight = straight.stationary["middle"]
    bore = side.stationary["middle"] ** 2 - weight**2
    assert up.stationary["middle"] == pytest.approx(weight + math.sqrt(bore), rel=1e-6)
    aligned = rows_of(solved("r754-films", coaxiality_um=20.0))["middle"].on_shaft.alignment_load
    assert math.sqrt(bore) == pytest.approx(aligned, rel=1e-6)  # the middle alone by t, or each by t/2


def test_without_bearings_that_are_judged_they_are_rigid():
    document = on_bearings("r754-films")
    kept = ("name", "position_mm", "diameter_mm", "length_mm")
    shaft = document.data["shafts"][0]
    rows = [{key: row[key] for key in kept} for row in shaft["bearings"]]
    data = {key: table for key, table in document.data.items() if key != "bearings"}
    data["shafts"] = [shaft | {"bearings": rows}]
    standing = solve(design(replace(document, data=data))).result(CountershaftResult).standing
    assert sum(standing.weights.values()) == pytest.approx(standing.weight, rel=1e-6)
    assert standing.weights["front"] == pytest.approx(standing.weights["rear"], rel=1e-6)


# --- what is refused, and what is not known


def test_what_more_than_two_bearings_do_not_go_with():
    wrong = wrong_of(on_bearings("r754-films", load_speed_ratio=0.0))
    assert "more than two bearings" in wrong["bearings.load_speed_ratio"]
    wrong = wrong_of(on_bearings("r754-films", rows={"front": {"offset_um": [1.0, 0.0]}}))
    assert "define the line" in wrong["shafts.0.bearings.0.offset_um"]


def test_a_load_that_is_given_rules():
    results = solved("r754-films", rows={"middle": {"load_N": 900.0}})
    rows, shaft = rows_of(results), results.result(CountershaftResult)
    assert rows["middle"].load == 900.0 and rows["front"].load == shaft.loads["front"]
    assert all(row.on_shaft is None for row in rows.values())


def test_without_an_outline_the_share_is_not_verified():
    document = on_bearings("r754-films")
    shaft = {key: x for key, x in document.data["shafts"][0].items() if key != "sections"}
    results = solve(design(replace(document, data=document.data | {"shafts": [shaft]})))
    rows, shaft = rows_of(results), results.result(CountershaftResult)
    assert {name: row.load for name, row in rows.items()} == shaft.loads
    share = next(c for c in results.checks() if c.id == "bearings.middle.share")
    assert not share.holds and share.missing == ("shafts.shaft.sections",)


def test_without_an_outline_bores_out_of_line_are_not_verified():
    for rows, zone in (({"middle": {"offset_um": [20.0, 0.0]}}, 0.0), ({}, 20.0)):
        document = on_bearings("r754-films", rows=rows, coaxiality_um=zone)
        shaft = {key: x for key, x in document.data["shafts"][0].items() if key != "sections"}
        results = solve(design(replace(document, data=document.data | {"shafts": [shaft]})))
        for name in NAMES:
            assert results.check(f"bearings.{name}.alignment").verdict == "not_verified"


def test_a_film_that_can_not_carry_its_share_ends_the_step():
    found = solved("couple-middle-films", rows={name: {"clearance_um": 500.0} for name in NAMES}).outcomes["bearings"]
    assert found.state == "no_solution" and found.reason


def test_a_row_of_several_bearings_that_is_written_passes(monkeypatch):
    """One alone, on few nodes: what is offered holds as it then stands in the file."""

    def middle(case, own, there, variant, free, asked, progress):
        return together._group(case, "middle alone", own, there, variant, ("middle",), asked)

    monkeypatch.setattr(together, "_groups", middle)
    monkeypatch.setattr(together, "NODES", 2)
    monkeypatch.setattr(together, "KINDS", (("limit",),))
    smooth = {name: {"journal_roughness_um": 0.2, "housing_roughness_um": 0.2} for name in NAMES}
    three = solved("r754-films", rows=smooth)
    case = bearings_case(three.design, solve, three)
    found = together.search(case)
    assert found.now is not None and found.rows[0].power <= found.now.power
    assert sum(one.which == together.AS_IT_IS for one in found.rows) == 1
    settled = together.confirmed(case, found.rows[-1].row, found.slopes, found.asked)
    assert settled.row is not None and not settled.results.outcomes["bearings"].verdict == "fail"


def test_only_two_bearings_are_searched(three):
    with pytest.raises(NoSolution, match="has two"):
        nearest_row(bearings_case(three.design, solve, three))
    with pytest.raises(BadInput) as caught:
        problem(on_bearings("r754-films"), None)
    assert any("not searched whole yet" in str(error.reason) for error in caught.value.errors)


# --- each check, just inside and just outside


def verdicts(found, films=None):
    return {c.id: c.verdict for c in support_checks(found, films, None, 0.0)}


def with_row(found, name, load=None, **on_shaft):
    row = found.bearings[name]
    row = replace(row, on_shaft=replace(row.on_shaft, **on_shaft), load=row.load if load is None else load)
    return replace(found, bearings=found.bearings | {name: row})


@pytest.mark.parametrize("share, verdict", [(0.801, "pass"), (0.799, "note"), (1.249, "pass"), (1.251, "note")])
def test_share(three, share, verdict):
    found = with_row(three.result(BearingsResult), "front", share=share)
    assert verdicts(found)["bearings.front.share"] == verdict


@pytest.mark.parametrize("part, verdict", [(0.999, "pass"), (1.001, "fail")])
def test_share_settled(three, part, verdict):
    films = replace(_films(three), moved=1e-4 * part)
    assert verdicts(three.result(BearingsResult), films)["bearings.share_settled"] == verdict


@pytest.mark.parametrize("part, verdict", [(0.0501, "pass"), (0.0499, "note")])
def test_unloaded(three, part, verdict):
    found = three.result(BearingsResult)
    found = with_row(found, "front", load=part * found.bearings["middle"].load)
    assert verdicts(found)["bearings.front.unloaded"] == verdict


@pytest.mark.parametrize("part, verdict", [(1.001, "pass"), (0.999, "warn")])
def test_film_edge_tilted_and_alignment(three, part, verdict):
    found = three.result(BearingsResult)
    asked = found.bearings["front"].kreisle_film
    lost = found.bearings["front"].film - found.bearings["front"].film_edge
    found = with_row(found, "front", film_edge_tilted=part * asked, film_alignment=part * asked + lost)
    assert verdicts(found)["bearings.front.film_edge_tilted"] == verdict
    assert verdicts(found)["bearings.front.alignment"] == verdict
    assert verdicts(with_row(found, "front", film_alignment=None))["bearings.front.alignment"] == "warn"


def test_a_slope_that_is_given_is_not_judged_by_the_tilt(gamma_results, three):
    assert all(row.seat.bearing.slope is not None for row in rows_of(gamma_results).values())
    assert not any("film_edge_tilted" in c.id for c in gamma_results.checks())
    assert "bearings.front.film_edge_tilted" in {c.id for c in three.checks()}


def test_what_the_tilt_would_leave_beside_a_slope_that_is_given_is_said(gamma_results, three):
    """Both edges of gamma are below the 9 µm that they need once the journals tilt in their films."""
    told = [
        str(note) for note in gamma_results.outcomes["bearings"].notes if "the slope that is given is judged" in note
    ]
    edges = [row.on_shaft.film_edge_tilted * 1e6 for row in rows_of(gamma_results).values()]
    assert len(told) == 2 and all(f"{edge:.3f} µm, less than the 9 µm" in note for edge, note in zip(edges, told))
    assert not any("the slope that is given" in note for note in three.outcomes["bearings"].notes)


@pytest.mark.parametrize("part, verdict", [(0.499, "pass"), (0.501, "note")])
def test_standing_share(three, part, verdict):
    row = rows_of(three)["front"]
    standing = replace(row.standing, standing_load=part * row.load)
    found = {c.id: c.verdict for c in standing_checks("front", row, standing)}
    assert found["bearings.front.standing_share"] == verdict


def test_more_standing_load_never_leaves_more_film(three):
    """Past what an orbit of first order is for, too: then the share is noted, and the film is not better for it."""
    front, edges = rows_of(three)["front"], []
    for part in (0.3, 0.45, 0.499, 0.501, 0.55, 0.7):
        standing = standing_part(front, part * front.load, "front", [])
        edges.append(next(c.value for c in standing_checks("front", front, standing) if "film_edge" in c.id))
    assert edges == sorted(edges, reverse=True)


def _beam(results):
    shaft = results.result(CountershaftResult)
    return shaft.bending.model, shaft.omega


def _films(results):
    found = results.result(BearingsResult)
    seats = [row.seat for row in found.bearings.values()]
    turning, duty = of_beam(*_beam(results)), found.bearings["front"].duty
    return _on(turning, seats, duty)


def _on(turning, seats, duty):
    supports = [PlainSupport(seat, ALUMINIUM) for seat in seats]
    return on_films(turning, shared(turning, supports, duty, 1), supports, duty)


def test_the_loop_ends_within_its_passes(three):
    films = _films(three)
    assert films.moved <= 1e-4
    assert abs(films.carried.load) == pytest.approx([row.load for row in rows_of(three).values()], rel=1e-9)


def test_two_bearings_stay_as_they_were(gamma_results):
    """No share, no stiffness to what stands; against the crank the journal lags its load the other way round."""
    rows = rows_of(gamma_results)
    for row in rows.values():
        lag = row.on_shaft.load_phase - row.on_shaft.displacement_phase
        assert math.remainder(lag + row.attitude_angle, 2 * math.pi) == pytest.approx(0.0, abs=1e-9)
    assert all(row.on_shaft.share is None and row.on_shaft.standing_stiffness is None for row in rows.values())


def test_the_power_balance_closes_with_what_stands_on_three_bearings(gamma):
    """The source's train on a shaft of three bearings: the gear's force that friction closes on is that of the statics,
    and what stands of it grows with the power alone."""

    def full(start, end):
        return {"from_mm": start, "to_mm": end, "outer_radius_mm": 29.75}

    def sector(start, end, angle):
        ends = {"from_mm": start, "to_mm": end, "outer_radius_mm": 38.0, "core_radius_mm": 18.0}
        return ends | {"half_angle_deg": 62.0, "angle_deg": angle}

    front, rear = ({**row, "diameter_mm": 59.5, "slope_mrad": None} for row in gamma.data["shafts"][0]["bearings"])
    rows = [front, {**front, "name": "middle", "position_mm": 0.0}, rear]
    rows = [{key: x for key, x in row.items() if x is not None} for row in rows]
    sections = [
        full(-182, -153.7),
        sector(-153.7, -16, 210.0),
        full(-16, 16),
        sector(16, 153.7, 30.0),
        full(153.7, 182),
    ]
    shaft = gamma.data["shafts"][0] | {"sections": sections, "gear_z_mm": -170.0, "bearings": rows}
    results = solve(design(replace(gamma, data=gamma.data | {"shafts": [shaft]})))
    assert {results.outcomes[key].state for key in ("countershaft", "bearings", "gears", "friction")} == {"solved"}
    standing, journals = results.result(CountershaftResult).standing, results.result(FrictionResult).journals["shaft"]
    assert sum(standing.weights.values()) == pytest.approx(standing.weight, rel=1e-6)
    for name, journal in journals.items():
        assert journal.standing_load == pytest.approx(standing.stationary[name], rel=1e-6)
        assert standing.stationary[name] > abs(standing.weights[name])
    # beside the front bearing the wheel loads that one alone, but for the couple of its thrust
    of_wheel = {name: standing.stationary[name] - abs(standing.weights[name]) for name in NAMES}
    assert of_wheel["front"] == pytest.approx(
        math.hypot(standing.gear_force_tangential, standing.gear_force_radial), rel=0.2
    )


# --- bearings that are not alike, and twins


def test_a_bearing_that_is_fed_otherwise_than_the_others_is_warmed_by_itself(three):
    rows, turning = rows_of(three), of_beam(*_beam(three))
    seats, duty = [row.seat for row in rows.values()], rows["front"].duty
    grooved = replace(seats[1].inputs, supply="groove", groove_width=2e-3)
    mixed = [seats[0], replace(seats[1], inputs=grooved), seats[2]]
    films = _on(turning, mixed, duty)
    assert [law.lands for law in films.laws] == [1, 2, 1]
    _corners_are_those_of_each_alone(turning, films, mixed, duty)
    again = [replace(seat, inputs=replace(seat.inputs)) for seat in seats]  # as of rows that say what all share
    assert np.array_equal(_on(turning, again, duty).carried.load, _on(turning, seats, duty).carried.load)


def with_image(document, *rows):
    """With a mirror image of its shaft that says so much of its bearings itself."""
    image = {"name": "image", "mirrors": "shaft", "axis_mm": [0.0, 80.0]} | ({"bearings": list(rows)} if rows else {})
    return document.with_value("shafts", [*document.data["shafts"], image])


@pytest.fixture(scope="module")
def image():
    """Whose middle bearing is wider, as in the case r754-middle-wide."""
    return solve(design(with_image(on_bearings("r754-films"), {"name": "middle", "clearance_um": 90.0})))


def test_a_twin_that_says_something_of_its_bearings_has_them_solved(image, three):
    wide = {row["value"]: row["is"] for row in cases.DATA["given"] if row["case"] == "r754-middle-wide"}
    values = image.values()
    for row in NAMES:
        assert values[f"bearings.image.{row}.load"].inside == pytest.approx(wide[f"load.{row}"], rel=2e-3)
        assert values[f"bearings.shaft.{row}.load"].inside == rows_of(three)[row].load
    assert values["bearings.image.middle.clearance"].inside == 90e-6
    moved = next(check.moved_by for check in image.checks() if check.id == "bearings.image.middle.film_edge")
    assert "shafts.image.bearings.middle.clearance_um" in moved and "shafts.shaft.bearings.middle.length_mm" in moved
    speeds = [values[f"countershaft.{name}.first_critical_speed_on_films"].inside for name in ("shaft", "image")]
    assert speeds[1] < speeds[0]  # a wider bearing holds it less
    view = image.view("image")
    assert view.design.own_name == "image" and rows_of(view)["middle"].seat.bearing.clearance == 90e-6
    assert list(image.views) == ["shaft"]


def test_a_twin_that_says_nothing_is_the_very_object():
    found = resolved(design(with_image(on_bearings("r754-films"), {"name": "middle"})).shafts)
    assert found[1].rows == () and found[1].inputs.bearings is found[0].inputs.bearings


def test_a_repetition_says_of_its_bearings_what_a_mirror_image_may():
    original, image = design(with_image(on_bearings("r754-films"), {"name": "middle", "clearance_um": 90.0})).shafts
    _, again = resolved((original, replace(image, mirrors=None, repeats=original.name, axis=(0.1, 0.0))))
    assert again.how == "repeats" and again.rows == image.bearings
    clearances = {row.name: row.clearance for row in again.inputs.bearings}
    assert clearances == {row.name: row.clearance for row in original.bearings} | {"middle": 90e-6}


def test_the_pull_of_a_chain_is_shared_as_a_force_at_the_wheel_is(three):
    """By shaft and films, and added to the tooth force of a wheel beside the sprocket."""
    shaft, bearings = three.result(CountershaftResult), three.result(BearingsResult)
    inputs, gear = three.design.own, Gear(0.05, 0.054, 0.015, math.radians(20), 0.0)
    strands = ((Sprocket("chain", 0.06, 50.0), 1400.0),)

    def stands(*drive):
        found = standing_of(shaft, inputs, gear, ShaftDrive(*drive), bearings.stands, bearings)
        return np.array(list(found.stationary.values()))

    idle, chained = stands(None, 50.0), stands(None, 50.0, strands)
    pull = 2 * 1400.0 / (2 * math.pi * 50.0) / 0.06 + 100.0
    assert chained - idle == pytest.approx(pull * abs(bearings.stands.force))
    assert stands(900.0, 50.0, strands) - stands(900.0, 50.0) == pytest.approx(chained - idle)


def test_the_films_of_a_mirror_image_lie_the_other_way(three):
    found = three.result(BearingsResult)
    image = turned_over(found)
    for row, mine in image.bearings.items():
        lies, theirs = mine.on_shaft, found.bearings[row].on_shaft
        assert lies.load_phase == -theirs.load_phase and lies.displacement_phase == -theirs.displacement_phase
        assert (lies.tilt_along, mine.film_edge) == (theirs.tilt_along, found.bearings[row].film_edge)
    assert np.array_equal(image.line[1], found.line[1].conjugate())


def test_what_a_twin_may_say_of_its_bearings():
    document = on_bearings("r754-films")
    (error,) = wrong_of(with_image(document, {"name": "midle", "clearance_um": 90.0})).items()
    assert error == ("shafts.1.bearings.0.name", '"midle" is not known; did you mean "middle"?')
    theirs = {"diameter_mm": 24.0, "length_mm": 20.0, "position_mm": 1.0, "offset_um": [1.0, 1.0]}
    wrong = wrong_of(with_image(document, {"name": "middle", **theirs}))
    assert wrong == {
        f"shafts.1.bearings.0.{key}": "is that of its original, shaft: leave it out here" for key in theirs
    }
    of_supply = wrong_of(with_image(document, {"name": "middle", "supply": "groove"}))
    assert of_supply == {"shafts.1.bearings.0.groove_width_mm": 'needed with supply = "groove"'}
    wide = wrong_of(with_image(document, {"name": "middle", "clearance_um": 4000.0}))
    assert wide == {"shafts.1.bearings.0.clearance_um": "must stay below a tenth of the diameter"}
    by_factor = design(with_image(document, {"name": "middle", "clearance_factor": 0.5})).resolved[1].inputs
    assert [row.clearance for row in by_factor.bearings][1] is None  # which its original gives


def test_what_a_twin_says_is_doubted_and_told_by_its_own_keys():
    made = design(with_image(on_bearings("r754-films"), {"name": "middle", "journal_roughness_um": 5.0}))
    assert not any(".image." in key for key, _, _ in made.given("bearings"))
    (far,) = doubts(made.with_bearings_of("image"), "bearings")
    assert far.moved_by == ("shafts.image.bearings.middle.journal_roughness_um",)
    keys_of = made.in_twin(made.resolved[1])
    rough, size = (row_key("middle", field) for field in (BearingRow.journal_roughness, BearingRow.diameter))
    assert (*keys_of(rough), *keys_of(size), *keys_of("bearings.oil")) == (
        "shafts.image.bearings.middle.journal_roughness_um",
        "shafts.shaft.bearings.middle.diameter_mm",
        "bearings.oil",
    )


def test_a_key_of_a_twins_bearing_makes_its_row():
    document = with_image(on_bearings("r754-films"))
    key = "shafts.image.bearings.middle.clearance_um"
    assert value_at(document.data, key) is None and quantity_of(document.data, key).unit == "µm"
    changed = document.with_value(key, 90.0)
    assert changed.data["shafts"][1]["bearings"] == [{"name": "middle", "clearance_um": 90.0}]
    assert document.with_value(key, None).data == document.data  # there is nothing to take out
    assert "bearings" not in changed.with_value("bearings", None).data["shafts"][1]
    every = changed.with_value("shafts.image.bearings.*.clearance_um", 70.0).data["shafts"]
    assert {row["name"]: row["clearance_um"] for row in every[1]["bearings"]} == dict.fromkeys(NAMES, 70.0)
    own = changed.with_value("shafts.*.bearings.*.clearance_um", 50.0).data["shafts"]
    assert own[1] == changed.data["shafts"][1] and [row["clearance_um"] for row in own[0]["bearings"]] == [50.0] * 3
    keys = {key.rpartition(".")[2] for key, _ in quantities(changed.data) if ".image.bearings." in key}
    assert "clearance_um" in keys and not {"diameter_mm", "length_mm", "position_mm"} & keys
